//! The Surface tab: a map of an output over two variables, its scale, and the slices through the cursor.

use ratatui::layout::Rect;

use crate::model::units::significant;
use crate::report::figures::sweeps::tone;
use crate::report::figures::{axis_of, column_of, map_over};
use crate::report::map::{Cell, Map, Tone};
use crate::study::quantities::Quantity;
use crate::study::sweep::Axis;
use crate::study::sweep::PointOutcome;
use crate::study::sweep::grid::{self, Grid};
use crate::study::sweep::quadratic::Quadratic;
use crate::tui::app::App;
use crate::tui::app::status::{clip, shortened};
use crate::tui::chart::heatmap::{dot, role, swatch};
use crate::tui::chart::{self, Chart, Curve, Levels, Scale, Unit, ViewRange};
use crate::tui::message::Target;
use crate::tui::pages::explore::RESULTS;
use crate::tui::pages::explore::curves::{drawn, nothing, nothing_exists, value_scale};
use crate::tui::pages::explore::layout::SweepPanes;
use crate::tui::pages::explore::plan::PictureSweep;
use crate::tui::pages::explore::state::{Contour, Picture, place, quadratic};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::put;

/// Draw map, scale and slices.
pub(in crate::tui) fn render(app: &App, panes: &SweepPanes, canvas: &mut Canvas<'_>) {
    let Some(area) = panes.plots.first().copied() else { return };
    let all = panes.plots.iter().chain(&panes.scale).chain(&panes.slices);
    all.for_each(|area| canvas.pane(*area, RESULTS));
    let Some(found) = app.pages.explore.found(Picture::Surface) else {
        nothing(app, "Map", area, canvas);
        for area in panes.scale.iter().chain(&panes.slices) {
            PaneFrame::new("").render(*area, canvas, app.theme);
        }
        return;
    };
    let view = ChartView::of(app, &found.grid);
    view.map(app, area, canvas);
    if let Some(area) = panes.scale {
        view.scale(app, area, canvas);
    }
    for (area, along) in panes.slices.iter().zip([true, false]) {
        view.slice(app, along, *area, canvas);
    }
}

/// What is looked at: an output of a grid, with its bands.
struct ChartView<'a> {
    grid: &'a Grid,
    output: usize,
    column: &'static Quantity,
    /// What is taken off the values.
    fit: Option<Quadratic>,
    /// What is shown at every point, NaN where there is nothing; the second axis runs fastest.
    values: Vec<f64>,
    levels: Option<Levels>,
    unit: Unit<'static>,
    range: ViewRange,
}

impl<'a> ChartView<'a> {
    fn of(app: &App, grid: &'a Grid) -> Self {
        let (output, column) = app.shown_output(grid);
        let (along, up) = grid.counts();
        let points = (0..along).flat_map(|x| (0..up).map(move |y| (x, y)));
        let fit = app.pages.explore.residuals.then(|| quadratic(grid, output)).flatten();
        // A value, or what is left of it beside the fit.
        let seen = |point| {
            let (u, v) = place(grid, point);
            drawn(grid, point, output) - fit.map_or(0.0, |fit| fit.value(u, v))
        };
        let values: Vec<f64> = points.map(seen).collect();
        let scale = scale_of(app);
        let range = ViewRange::of(scale, values.iter().copied()).unwrap_or_default();
        let levels = Levels::of(scale, values.iter().copied());
        Self {
            grid,
            output,
            column,
            fit,
            values,
            levels,
            unit: Unit::with_prefix(range.size(), column.unit()),
            range,
        }
    }

    /// What is shown at a point; NaN where there is nothing.
    fn value(&self, (x, y): (usize, usize)) -> f64 {
        self.values[x * self.grid.counts().1 + y]
    }

    fn map(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let axes = self.grid.plan().axes();
        let old =
            app.sweep_is_old(Picture::Surface) && app.jobs.running::<PictureSweep>().is_none();
        let (across, upward) = (axis_of(&axes[0]), axis_of(&axes[1]));
        let title = self.title(old, &across, &upward, area.width);
        let Some(levels) = &self.levels else {
            return nothing_exists(app, &title, self.grid, self.output, area, canvas);
        };
        if !self.grid.is_full() {
            return self.dots(app, title, levels, area, canvas);
        }
        let cell = |x: usize, y: usize| {
            let value = self.value((x, y));
            match self.grid.cell(x, y, self.output) {
                grid::Cell::Value(_) if scale_of(app).shows(value) => Cell::Value(value),
                grid::Cell::Value(_) => Cell::Mark('0', Tone::Faint),
                grid::Cell::Outcome(outcome) => Cell::Mark(outcome.letter(), tone(outcome)),
                grid::Cell::Waiting => Cell::Empty,
            }
        };
        let (x, y) = app.cursor_point(self.grid);
        let here = self.value((x, y));
        let through = app.pages.explore.contour == Contour::Cursor && here.is_finite();
        let map = Map {
            contour: through.then_some((here, "".into())),
            cursor: column_of(&axes[0], x).zip(column_of(&axes[1], y)),
            focused: app.has_focus(RESULTS),
            ..map_over(title, &axes[0], &axes[1], Some(levels.clone()), cell)
        };
        let layout = map.render(area, canvas, app.theme);
        canvas.plot(&layout, |x, y| {
            let nearest = |axis: &Axis, value: f64| usize::try_from(axis.nearest(value)).ok();
            Some(Target::Cell(RESULTS, (nearest(&axes[0], x)?, nearest(&axes[1], y)?)))
        });
    }

    /// What is shown and the axis upward, in as many words as there is room for: the other axis's name gives way first.
    fn title(
        &self,
        old: bool,
        across: &chart::Axis<'_>,
        up: &chart::Axis<'_>,
        width: u16,
    ) -> String {
        let fit = if self.fit.is_some() { "off the fit: " } else { "" };
        let old = if old { ", old" } else { "" };
        let (output, name) = (self.column.title(), &up.label);
        let long = format!("{fit}{output}{old}, up: {name}");
        let short = format!("{fit}{}{old}, up: {name}", shortened(&output));
        // In the line are also its unit and the other axis with brackets, blanks, and the frame's ends.
        let alone = usize::from(width).saturating_sub(up.unit.name.len() + 8);
        let both = alone.saturating_sub(across.label.len() + across.unit.name.len() + 5);
        let choices = [(&long, both), (&short, both), (&long, alone), (&short, alone)];
        let fits = choices.into_iter().find(|(title, room)| title.chars().count() <= *room);
        // The row below the map tells the output, too.
        fits.map_or_else(|| format!("{fit}up: {name}{old}"), |(title, _)| title.clone())
    }

    /// The points of a design where they lie, each in the colour of its band or as its letter.
    fn dots(&self, app: &App, title: String, levels: &Levels, area: Rect, canvas: &mut Canvas<'_>) {
        let axes = self.grid.plan().axes();
        let chart = Chart {
            focused: app.has_focus(RESULTS),
            ..Chart::new(title, axis_of(&axes[0]), axis_of(&axes[1]), Vec::new())
        };
        let layout = chart.render(area, canvas, app.theme);
        let cursor = app.cursor_point(self.grid).0;
        // The cursor's point last: it lies over others in its cell.
        let points = (0..self.grid.counts().0).filter(|x| *x != cursor).chain([cursor]);
        for x in points {
            let at = |axis: usize| self.grid.coordinate((x, 0), axis);
            let Some(place) = layout.place(at(0), at(1)) else { continue };
            let value = self.value((x, 0));
            let (symbol, style) = match self.grid.cell(x, 0, self.output) {
                _ if x == cursor => ('X', app.theme.style(Role::Selection)),
                grid::Cell::Value(_) if scale_of(app).shows(value) => {
                    dot(levels.index(value), levels.bands(), app.theme)
                }
                grid::Cell::Value(_) => ('0', app.theme.style(Role::Dim)),
                grid::Cell::Outcome(outcome) => {
                    (outcome.letter(), app.theme.style(role(tone(outcome))))
                }
                grid::Cell::Waiting => continue,
            };
            put(canvas, layout.plot, place, &symbol.to_string(), style);
        }
        let at = |x: usize, axis: usize| self.grid.coordinate((x, 0), axis);
        let places = (0..self.grid.counts().0).map(|x| Some((at(x, 0), at(x, 1))));
        canvas.points(&layout, places, |x| Target::Cell(RESULTS, (x, 0)));
    }

    /// The bands from the greatest down, then what the letters mean.
    fn scale(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let unit = &self.unit.name;
        let title = if unit.is_empty() { "Scale".to_owned() } else { format!("Scale [{unit}]") };
        let hint = if app.pages.explore.log_values { "Y linear" } else { "Y log" };
        let inner = PaneFrame::new(title).right(hint).render(area, canvas, app.theme);
        let mut row = 0;
        if let Some(levels) = &self.levels {
            let (x, y) = app.cursor_point(self.grid);
            let here = self.value((x, y));
            for band in (0..levels.bands()).rev() {
                let patch = if self.grid.is_full() { swatch } else { dot };
                let (symbol, style) = patch(band, levels.bands(), app.theme);
                let patch: String = [symbol; 3].iter().collect();
                put(canvas, inner, (1, row), &patch, style);
                let (from, to) = levels.band(band);
                let show = |value: f64| significant(value * self.unit.factor, 4);
                let text = format!("{:>7} .. {:<7}", show(from), show(to));
                let mark = here.is_finite() && levels.index(here) == band;
                let role = if mark { Role::Title } else { Role::Text };
                let end = put(canvas, inner, (5, row), &text, app.theme.style(role));
                if mark {
                    put(canvas, inner, (end, row), "X", app.theme.style(Role::Title));
                }
                row += 1;
            }
        }
        for (outcome, words) in self.outcomes() {
            let style = app.theme.style(role(tone(outcome)));
            put(canvas, inner, (2, row), &outcome.letter().to_string(), style);
            let words = clip(words, usize::from(inner.width.saturating_sub(5)));
            put(canvas, inner, (5, row), &words, app.theme.style(Role::Text));
            row += 1;
        }
        if scale_of(app) == Scale::Log10 && self.has_zero() {
            put(canvas, inner, (2, row), "0", app.theme.style(Role::Dim));
            let text = "zero or less: not on a log";
            let text = clip(text, usize::from(inner.width.saturating_sub(5)));
            put(canvas, inner, (5, row), &text, app.theme.style(Role::Text));
        }
    }

    /// Whether a logarithmic scale leaves values out.
    fn has_zero(&self) -> bool {
        let (along, up) = self.grid.counts();
        let mut points = (0..along).flat_map(|x| (0..up).map(move |y| (x, y)));
        points.any(|point| drawn(self.grid, point, self.output) <= 0.0)
    }

    /// The outcomes that stand in the map, each letter once.
    fn outcomes(&self) -> Vec<(PointOutcome, &'static str)> {
        let (along, up) = self.grid.counts();
        let mut list: Vec<(PointOutcome, &'static str)> = Vec::new();
        for (x, y) in (0..along).flat_map(|x| (0..up).map(move |y| (x, y))) {
            if let grid::Cell::Outcome(outcome) = self.grid.cell(x, y, self.output)
                && !list.iter().any(|(other, _)| other.letter() == outcome.letter())
            {
                list.push((outcome, outcome.without_value(self.column)));
            }
        }
        list
    }

    /// The output along one axis, through the cursor; of a design, which has no rows, all points seen along the other axis.
    fn slice(&self, app: &App, along: bool, area: Rect, canvas: &mut Canvas<'_>) {
        if !self.grid.is_full() {
            return self.shadow(app, usize::from(!along), area, canvas);
        }
        let axes = self.grid.plan().axes();
        let (x, y) = app.cursor_point(self.grid);
        let (axis, held, count, place) = if along {
            (&axes[0], &axes[1], self.grid.counts().0, x)
        } else {
            (&axes[1], &axes[0], self.grid.counts().1, y)
        };
        let at = |index: usize| axis.value(u64::try_from(index).unwrap_or(u64::MAX));
        let point = |index: usize| if along { (index, y) } else { (x, index) };
        let points: Vec<(f64, f64)> =
            (0..count).map(|index| (at(index), self.value(point(index)))).collect();
        let vertical = self.value_axis(app);
        let other = if along { y } else { x };
        let other = held.value(u64::try_from(other).unwrap_or(u64::MAX));
        let chart = Chart {
            crosshair: Some(at(place)),
            ..Chart::new(
                format!("at {} {}", held.symbol(), significant(other, 3)),
                axis_of(axis),
                vertical,
                vec![Curve::new('*', "", &points)],
            )
        };
        chart.render(area, canvas, app.theme);
    }

    /// All points of a design over one of its axes.
    fn shadow(&self, app: &App, axis: usize, area: Rect, canvas: &mut Canvas<'_>) {
        let place = |x: usize| self.grid.coordinate((x, 0), axis);
        // Each by itself: they are no neighbours.
        let points: Vec<(f64, f64)> = (0..self.grid.counts().0)
            .flat_map(|x| [(place(x), self.value((x, 0))), (f64::NAN, f64::NAN)])
            .collect();
        let over = &self.grid.plan().axes()[axis];
        let chart = Chart {
            crosshair: Some(place(app.cursor_point(self.grid).0)),
            ..Chart::new(
                format!("over {}", over.symbol()),
                axis_of(over),
                self.value_axis(app),
                vec![Curve::new('*', "", &points)],
            )
        };
        chart.render(area, canvas, app.theme);
    }

    fn value_axis(&self, app: &App) -> chart::Axis<'static> {
        let scale = scale_of(app);
        let view = match scale {
            Scale::Linear => self.range.padded(scale, 0.05),
            Scale::Log10 => self.range.rounded(scale),
        };
        chart::Axis::new("", view).scale(scale).unit(self.unit.clone())
    }
}

/// The scale of what is shown: what a fit leaves over has both signs.
fn scale_of(app: &App) -> Scale {
    if app.pages.explore.residuals { Scale::Linear } else { value_scale(app) }
}
