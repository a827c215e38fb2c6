//! The Explore tab, drawn: an output, or two, over one variable, with a curve for each value of a second one; what has no value is a
//! letter on the axis, never a number.

use crate::report::figures::{axis_of, column_of, map_over, sweeps};
use crate::report::map::Map;
use crate::study::quantities::Quantity;
use crate::study::sweep::Axis;
use crate::study::sweep::grid::{self, Grid};
use crate::tui::chart::heatmap::{role, swatch};
use crate::tui::chart::{self, Chart, Curve, Emphasis, Layout, Levels, MARKERS, Unit};
use crate::tui::pages::explore::plan::no_value;
use crate::tui::pages::explore::state::{Picture, RESULTS, SETUP, nearest};
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::layout::{ROOMY, setup_width};
use crate::tui::widgets::text::shortened;
use crate::tui::widgets::text::{put, wrapped};
use crate::worker::studies::PictureSweep;

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct SweepPanes {
    /// Axes, output, held variables.
    pub setup: Option<Rect>,
    /// One chart or two, or the map.
    pub plots: Vec<Rect>,
    pub scale: Option<Rect>,
    /// The slices through the cursor, along and up.
    pub slices: Vec<Rect>,
}

/// The setup beside one chart, or two where there is room; or beside the map, with scale and slices at its right. On a narrow
/// screen the pane beside the map is the one that is of use: the setup while it has the keys, else scale and slices.
pub(crate) fn panes(app: &App, body: Rect) -> SweepPanes {
    let on_setup = app.pane() == SETUP;
    let (left, rest) = match (app.is_full(), on_setup) {
        (true, true) => return SweepPanes { setup: Some(body), ..SweepPanes::default() },
        (true, false) => (None, body),
        (false, _) => {
            let (left, rest) = split_left(body, setup_width(body.width));
            (Some(left), rest)
        }
    };
    let is_line = app.picture() == Picture::Line;
    let plots = if is_line && rest.height >= 26 {
        let (top, bottom) = split_bottom(rest, rest.height / 2);
        vec![top, bottom]
    } else {
        vec![rest]
    };
    match left {
        Some(left) if !is_line && (body.width >= ROOMY || !on_setup) => surface(body, left, rest),
        setup => SweepPanes { setup, plots, ..SweepPanes::default() },
    }
}

fn surface(body: Rect, left: Rect, rest: Rect) -> SweepPanes {
    let (setup, map, side) = if body.width < ROOMY {
        (None, rest, left)
    } else {
        let (map, side) = split_left(rest, rest.width - 32.min(rest.width));
        (Some(left), map, side)
    };
    // Ten bands and the marks, within a frame; what is left goes to the slices, one where two would be too low.
    let (scale, below) = split_bottom(side, side.height - side.height.min(13));
    let slices = match below.height {
        0..=5 => Vec::new(),
        6..=15 => vec![below],
        _ => {
            let (top, bottom) = split_bottom(below, below.height / 2);
            vec![top, bottom]
        }
    };
    SweepPanes { setup, plots: vec![map], scale: Some(scale), slices }
}

pub(crate) fn render_curves(app: &App, panes: &SweepPanes, canvas: &mut Canvas<'_>) {
    panes.plots.iter().for_each(|area| canvas.pane(*area, RESULTS));
    let Some(grid) = app.pages.explore.found() else {
        if let Some(area) = panes.plots.first() {
            waiting(app, "Curves", *area, canvas);
        }
        return;
    };
    let outputs = grid.plan().outputs().len();
    let (shown, _) = app.shown_output(grid);
    for (place, area) in panes.plots.iter().enumerate() {
        // The shown output first, then the ones after it.
        let output = (shown + place) % outputs;
        if place > 0 && place >= outputs {
            waiting(app, "", *area, canvas);
            continue;
        }
        curves(app, grid, output, *area, canvas);
    }
}

/// A pane that has nothing to show yet.
fn waiting(app: &App, title: &'static str, area: Rect, canvas: &mut Canvas<'_>) {
    let inner = PaneFrame::new(title).draw(area, canvas);
    let why = app.pages.explore.problem.as_ref().map(|_| "see the message below");
    let text = nothing::<PictureSweep>(app, "sweeping the first points", why);
    canvas.put_centred(inner, &text);
}

/// An axis of the sweep of which a part is in view.
fn zoomed_axis(axis: &Axis, view: ViewRange) -> chart::Axis<'static> {
    let unit = axis.variable().unit();
    chart::Axis { view, ..axis_of(axis) }.unit(Unit::with_prefix(view.size(), unit))
}

fn curves(app: &App, grid: &Grid, output: usize, area: Rect, canvas: &mut Canvas<'_>) {
    let column = grid.plan().outputs()[output];
    let old = app.sweep_is_old() && app.jobs.running::<PictureSweep>().is_none();
    let axes = grid.plan().axes();
    let (along, repeats) = grid.counts();
    let scale = app.pages.explore.value_scale;
    let line = |y: usize| -> Vec<(f64, f64)> {
        let point = |x: usize| (grid.coordinate((x, y), 0), number(grid.cell(x, y, output)));
        (0..along).map(point).collect()
    };
    let lines: Vec<Vec<(f64, f64)>> = (0..repeats).map(line).collect();
    let printed = printed(app, grid, output);
    // The values in view, as in Run; all of them where no point is.
    let view = app.pages.explore.zoomed;
    let values = |all: bool| {
        let is_seen = move |x: f64| all || view.is_none_or(|view| view.contains(x));
        let points = lines.iter().chain(&printed).flatten();
        points.filter(move |point| is_seen(point.0)).map(|point| point.1)
    };
    let fitted = |all| chart::Axis::fitted("", column.unit(), scale, values(all));
    let why = || app.keymap.shown(&no_value(grid, output).join("\n"));
    let title = column.title() + if old { ", of another scene" } else { "" };
    let Some(y) = fitted(false).or_else(|| fitted(true)) else {
        return nothing_exists(&title, &why(), area, canvas);
    };
    let (x, selected) = app.cursor_point(grid);
    let named = axes.get(1);
    let curves = lines.iter().enumerate().map(|(index, points)| {
        let name = named.map_or_else(String::new, |axis| {
            // The first of the family also says what is repeated.
            let value = significant(axis.value(index as u64), 3);
            if index == 0 { format!("{}={value}", axis.symbol()) } else { value }
        });
        let emphasis = match (old, index == selected) {
            (true, _) => Emphasis::Stale,
            (false, true) => Emphasis::Selected,
            (false, false) => Emphasis::Normal,
        };
        let marker = MARKERS[index % MARKERS.len()];
        Curve::new(marker, name, points).colour(index).emphasis(emphasis)
    });
    let along_axis = match view {
        Some(view) => zoomed_axis(&axes[0], view),
        None => axis_of(&axes[0]),
    };
    let printed = printed.iter().enumerate().map(|(index, points)| {
        // The first says what all of them are, in pictures too.
        let name = if index == 0 { "as printed" } else { "" };
        Curve::new('.', name, points).emphasis(Emphasis::Faint)
    });
    let chart = Chart {
        crosshair: Some(grid.coordinate((x, selected), 0)),
        focused: output == app.shown_output(grid).0 && app.has_focus(RESULTS),
        ..Chart::new(title, along_axis, y, printed.chain(curves).collect())
    };
    let layout = canvas.draw(&chart, area);
    marks(app, grid, output, &layout, canvas);
    canvas.plot(&layout, |x, _| Some(Target::Cell(RESULTS, (nearest(&axes[0], x)?, selected))));
}

/// Parts of the values of a chart that are about as wide as its line.
const LINE: f64 = 0.02;

/// The curves of a figure by the scheme that the thesis prints, as far as they differ from the corrected ones by more than a line.
pub(crate) fn printed(app: &App, grid: &Grid, output: usize) -> Vec<Vec<(f64, f64)>> {
    let found = app.pages.explore.printed.as_ref();
    let is_same = |it: &&Arc<Grid>| it.plan().axes() == grid.plan().axes();
    let Some(found) = found.filter(is_same) else { return Vec::new() };
    let (along, repeats) = grid.counts();
    let value = |grid: &Grid, at: (usize, usize)| number(grid.cell(at.0, at.1, output));
    let all = sweeps::points(grid, output).map(|it| number(it).abs());
    let size = all.filter(|it| it.is_finite()).fold(0.0, f64::max);
    let curve = |y: usize| {
        let differs = |x: usize| (value(grid, (x, y)) - value(found, (x, y))).abs() > LINE * size;
        let point = |x: usize| (found.coordinate((x, y), 0), value(found, (x, y)));
        (0..along).any(differs).then(|| (0..along).map(point).collect())
    };
    (0..repeats).filter_map(curve).collect()
}

/// A letter at the foot of the plot wherever the selected curve has a gap.
fn marks(app: &App, grid: &Grid, output: usize, layout: &Layout, canvas: &mut Canvas<'_>) {
    let (along, _) = grid.counts();
    let (_, selected) = app.cursor_point(grid);
    for x in 0..along {
        if let grid::Cell::Outcome(outcome) = grid.cell(x, selected, output) {
            canvas.put_gap(layout, grid.coordinate((x, selected), 0), outcome.letter());
        }
    }
}

/// No point of the sweep has this output: say why, and what to do.
fn nothing_exists(title: &str, why: &str, area: Rect, canvas: &mut Canvas<'_>) {
    let inner = PaneFrame::new(title.to_owned()).draw(area, canvas);
    let room = inner.width.saturating_sub(2).max(8);
    let roles = std::iter::once(Role::Text).chain(std::iter::repeat(Role::Dim));
    let lines = why.lines().zip(roles).flat_map(|(text, role)| wrapped(text, room, role));
    let lines: Vec<TextLine> = lines.collect();
    let rows = u16::try_from(lines.len()).unwrap_or(u16::MAX);
    let top = inner.height.saturating_sub(rows) / 2;
    for (row, (text, role)) in (top..inner.height).zip(&lines) {
        let column = inner.width.saturating_sub(columns(text)) / 2;
        canvas.put(inner, (column, row), text, *role);
    }
}

pub(crate) fn render_map(app: &App, panes: &SweepPanes, canvas: &mut Canvas<'_>) {
    let Some(area) = panes.plots.first().copied() else { return };
    let all = panes.plots.iter().chain(&panes.scale).chain(&panes.slices);
    all.for_each(|area| canvas.pane(*area, RESULTS));
    let Some(grid) = app.pages.explore.found() else {
        waiting(app, "Map", area, canvas);
        for area in panes.scale.iter().chain(&panes.slices) {
            PaneFrame::new("").draw(*area, canvas);
        }
        return;
    };
    let view = ChartView::of(app, grid);
    view.map(app, area, canvas);
    if let Some(area) = panes.scale {
        view.scale(app, area, canvas);
    }
    for (area, along) in panes.slices.iter().zip([true, false]) {
        view.slice(app, along, *area, canvas);
    }
}

/// The displayed data: an output of a grid, with its bands.
struct ChartView<'a> {
    grid: &'a Grid,
    output: usize,
    column: &'static Quantity,
    scale: Scale,
    levels: Option<Levels>,
    values: chart::Axis<'static>,
}

impl<'a> ChartView<'a> {
    fn of(app: &App, grid: &'a Grid) -> Self {
        let (output, column) = app.shown_output(grid);
        let scale = app.pages.explore.value_scale;
        let empty = || {
            let unit = Unit::with_prefix(1.0, column.unit());
            chart::Axis::new("", ViewRange::default()).scale(scale).unit(unit)
        };
        let values = || sweeps::points(grid, output).map(number);
        Self {
            levels: Levels::of(scale, values()),
            values: chart::Axis::fitted("", column.unit(), scale, values()).unwrap_or_else(empty),
            grid,
            output,
            column,
            scale,
        }
    }

    /// The value shown at a point; NaN if there is none.
    fn value(&self, (x, y): (usize, usize)) -> f64 {
        number(self.grid.cell(x, y, self.output))
    }

    fn map(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let axes = self.grid.plan().axes();
        let old = app.sweep_is_old() && app.jobs.running::<PictureSweep>().is_none();
        let (across, upward) = (axis_of(&axes[0]), axis_of(&axes[1]));
        let title = self.title(old, &across, &upward, area.width);
        let Some(levels) = &self.levels else {
            let why = app.keymap.shown(&no_value(self.grid, self.output).join("\n"));
            return nothing_exists(&title, &why, area, canvas);
        };
        let cell = |x: usize, y: usize| sweeps::cell(self.grid.cell(x, y, self.output), self.scale);
        let (x, y) = app.cursor_point(self.grid);
        let map = Map {
            contour: self.contour(app).map(|level| (level, self.column.show(level, 4).into())),
            cursor: column_of(&axes[0], x).zip(column_of(&axes[1], y)),
            focused: app.has_focus(RESULTS),
            ..map_over(title, &axes[0], &axes[1], Some(levels.clone()), cell)
        };
        let layout = canvas.draw(&map, area);
        canvas.plot(&layout, |x, y| {
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
        let old = if old { ", old" } else { "" };
        let (output, name) = (self.column.title(), &up.label);
        let long = format!("{output}{old}, up: {name}");
        let short = format!("{}{old}, up: {name}", shortened(&output));
        // In the line are also its unit and the other axis with brackets, blanks, and the frame's ends.
        let alone = usize::from(width).saturating_sub(up.unit.name.len() + 8);
        let both = alone.saturating_sub(across.label.len() + across.unit.name.len() + 5);
        let choices = [(&long, both), (&short, both), (&long, alone), (&short, alone)];
        let fits = choices.into_iter().find(|(title, room)| title.chars().count() <= *room);
        // The row below the map tells the output, too.
        fits.map_or_else(|| format!("up: {name}{old}"), |(title, _)| title.clone())
    }

    /// The value of the contour, which runs through the point under the cursor.
    fn contour(&self, app: &App) -> Option<f64> {
        Some(self.value(app.cursor_point(self.grid))).filter(|here| here.is_finite())
    }

    /// The bands from the greatest down, then what the letters and the contour mean.
    fn scale(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let Unit { factor, name: unit } = &self.values.unit;
        let title = if unit.is_empty() { "Scale".to_owned() } else { format!("Scale [{unit}]") };
        let is_log = app.pages.explore.value_scale == Scale::Log10;
        let hint = app.keymap.shown(if is_log { "<log-y>: linear" } else { "<log-y>: log" });
        let inner = PaneFrame::new(title).right(hint).draw(area, canvas);
        let mut row = 0;
        let show = |value: f64| significant(value * factor, 4);
        if let Some(levels) = &self.levels {
            let here = self.value(app.cursor_point(self.grid));
            for band in (0..levels.bands()).rev() {
                let (symbol, style) = swatch(band, levels.bands(), app.settings.theme);
                let patch: String = [symbol; 3].iter().collect();
                put(canvas, inner, (1, row), &patch, style);
                let (from, to) = levels.band(band);
                let text = format!("{:>7} .. {:<7}", show(from), show(to));
                let mark = here.is_finite() && levels.index(here) == band;
                let role = if mark { Role::Title } else { Role::Text };
                let end = canvas.put(inner, (5, row), &text, role);
                if mark {
                    canvas.put(inner, (end, row), "X", Role::Title);
                }
                row += 1;
            }
        }
        let marks = sweeps::marks(self.column, sweeps::points(self.grid, self.output), self.scale);
        for (letter, tone, words) in marks {
            canvas.put(inner, (2, row), &letter.to_string(), role(tone));
            let words = clip(words, usize::from(inner.width.saturating_sub(5)));
            canvas.put(inner, (5, row), &words, Role::Text);
            row += 1;
        }
        if let Some(level) = self.contour(app) {
            canvas.put(inner, (2, row), "O", Role::Title);
            canvas.put(inner, (5, row), &format!("{:>7} as at X", show(level)), Role::Text);
        }
    }

    /// The output along one axis, through the cursor.
    fn slice(&self, app: &App, along: bool, area: Rect, canvas: &mut Canvas<'_>) {
        let axes = self.grid.plan().axes();
        let place = usize::from(!along);
        let (x, y) = app.cursor_point(self.grid);
        let (across, upward) = self.grid.counts();
        let point = |at: (usize, usize)| (self.grid.coordinate(at, place), self.value(at));
        let held = &axes[1 - place];
        let held_at = self.grid.coordinate((x, y), 1 - place);
        let title = format!("at {} {}", held.symbol(), significant(held_at, 3));
        let count = if along { across } else { upward };
        let at = |index: usize| if along { (index, y) } else { (x, index) };
        let points: Vec<(f64, f64)> = (0..count).map(|index| point(at(index))).collect();
        let curves = vec![Curve::new('*', "", points)];
        let chart = Chart {
            crosshair: Some(self.grid.coordinate((x, y), place)),
            ..Chart::new(title, axis_of(&axes[place]), self.values.clone(), curves)
        };
        canvas.draw(&chart, area);
    }
}

/// The number of a point to draw; NaN where there is none.
fn number(point: grid::Cell) -> f64 {
    point.value().unwrap_or(f64::NAN)
}
