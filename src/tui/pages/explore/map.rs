//! The Surface tab: a map of an output over two variables, its scale, and the slices through the cursor.

use ratatui::layout::Rect;

use crate::model::units::significant;
use crate::report::figures::{axis_of, column_of, map_over, sweeps};
use crate::report::map::{Cell, Map};
use crate::study::quantities::Quantity;
use crate::study::sweep::Axis;
use crate::study::sweep::grid::{self, Grid};
use crate::tui::app::App;
use crate::tui::app::status::{clip, shortened};
use crate::tui::chart::heatmap::{dot, role, swatch};
use crate::tui::chart::{self, Chart, Curve, Draw, Levels, Scale, Unit, ViewRange};
use crate::tui::message::Target;
use crate::tui::pages::explore::RESULTS;
use crate::tui::pages::explore::curves::{nothing, nothing_exists, value_scale};
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
    /// Whether a fit is taken off the values.
    is_fit: bool,
    /// What is shown at every point; the second axis runs fastest.
    points: Vec<grid::Cell>,
    scale: Scale,
    levels: Option<Levels>,
    /// The axis of the values.
    values: chart::Axis<'static>,
}

impl<'a> ChartView<'a> {
    fn of(app: &App, grid: &'a Grid) -> Self {
        let (output, column) = app.shown_output(grid);
        let (along, up) = grid.counts();
        let points = (0..along).flat_map(|x| (0..up).map(move |y| (x, y)));
        let residuals = app.pages.explore.residuals;
        let fit = residuals.then(|| quadratic(grid, output)).flatten();
        // A value, or what is left of it beside the fit.
        let seen = |point: (usize, usize)| match (grid.cell(point.0, point.1, output), fit) {
            (grid::Cell::Value(value), Some(fit)) => {
                let (u, v) = place(grid, point);
                grid::Cell::Value(value - fit.value(u, v))
            }
            (cell, _) => cell,
        };
        let points: Vec<grid::Cell> = points.map(seen).collect();
        // Residuals of a fit are positive and negative.
        let scale = if residuals { Scale::Linear } else { value_scale(app) };
        let empty = || {
            let unit = Unit::with_prefix(1.0, column.unit());
            chart::Axis::new("", ViewRange::default()).scale(scale).unit(unit)
        };
        let values = || points.iter().map(|point| number(*point));
        Self {
            levels: Levels::of(scale, values()),
            values: chart::Axis::fitted("", column.unit(), scale, values()).unwrap_or_else(empty),
            is_fit: fit.is_some(),
            grid,
            output,
            column,
            points,
            scale,
        }
    }

    fn point(&self, (x, y): (usize, usize)) -> grid::Cell {
        self.points[x * self.grid.counts().1 + y]
    }

    /// What is shown at a point; NaN where there is nothing.
    fn value(&self, point: (usize, usize)) -> f64 {
        number(self.point(point))
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
        let cell = |x: usize, y: usize| sweeps::cell(self.point((x, y)), self.scale);
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
        let fit = if self.is_fit { "off the fit: " } else { "" };
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
            let (symbol, style) = match sweeps::cell(self.point((x, 0)), self.scale) {
                _ if x == cursor => ('X', app.theme.style(Role::Selection)),
                Cell::Value(value) => dot(levels.index(value), levels.bands(), app.theme),
                Cell::Mark(letter, tone) => (letter, app.theme.style(role(tone))),
                Cell::Empty => continue,
            };
            put(canvas, layout.plot, place, &symbol.to_string(), style);
        }
        let at = |x: usize, axis: usize| self.grid.coordinate((x, 0), axis);
        let places = (0..self.grid.counts().0).map(|x| Some((at(x, 0), at(x, 1))));
        canvas.points(&layout, places, |x| Target::Cell(RESULTS, (x, 0)));
    }

    /// The bands from the greatest down, then what the letters mean.
    fn scale(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let Unit { factor, name: unit } = &self.values.unit;
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
                let show = |value: f64| significant(value * factor, 4);
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
        let marks = sweeps::marks(self.column, self.points.iter().copied(), self.scale);
        for (letter, tone, words) in marks {
            put(canvas, inner, (2, row), &letter.to_string(), app.theme.style(role(tone)));
            let words = clip(words, usize::from(inner.width.saturating_sub(5)));
            put(canvas, inner, (5, row), &words, app.theme.style(Role::Text));
            row += 1;
        }
    }

    /// The output along one axis, through the cursor; of a design, which has no rows, all points seen along the other axis.
    fn slice(&self, app: &App, along: bool, area: Rect, canvas: &mut Canvas<'_>) {
        let axes = self.grid.plan().axes();
        let place = usize::from(!along);
        let (x, y) = app.cursor_point(self.grid);
        let (across, upward) = self.grid.counts();
        let point = |at: (usize, usize)| (self.grid.coordinate(at, place), self.value(at));
        let (title, points): (String, Vec<(f64, f64)>) = if self.grid.is_full() {
            let held = &axes[1 - place];
            let held_at = self.grid.coordinate((x, y), 1 - place);
            let title = format!("at {} {}", held.symbol(), significant(held_at, 3));
            let count = if along { across } else { upward };
            let at = |index: usize| if along { (index, y) } else { (x, index) };
            (title, (0..count).map(|index| point(at(index))).collect())
        } else {
            // Each by itself: they are no neighbours.
            let apart = |x: usize| [point((x, 0)), (f64::NAN, f64::NAN)];
            (format!("over {}", axes[place].symbol()), (0..across).flat_map(apart).collect())
        };
        let curves = vec![Curve::new('*', "", points)];
        let chart = Chart {
            crosshair: Some(self.grid.coordinate((x, y), place)),
            ..Chart::new(title, axis_of(&axes[place]), self.values.clone(), curves)
        };
        chart.render(area, canvas, app.theme);
    }
}

/// The number of a point to draw; NaN where there is none.
fn number(point: grid::Cell) -> f64 {
    match point {
        grid::Cell::Value(value) => value,
        grid::Cell::Outcome(_) | grid::Cell::Waiting => f64::NAN,
    }
}
