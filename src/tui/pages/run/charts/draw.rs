//! Drawing of the Run tab's charts: as many as fit in one box, each with its number in the title.

use crate::tui::app::pins::RunView;
use crate::tui::chart::{
    Axis, Chart, Curve, Emphasis, Frame, Legend, MARKERS, Mark, Unit, align_gutters, emphasis,
};
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::charts::titles::title;
use crate::tui::pages::run::charts::{Curve as Data, is_held};
use crate::tui::pages::run::charts::{curves, end_s};
use crate::tui::pages::run::impact;
use crate::tui::pages::run::impact::time_shown_s;
use crate::tui::pages::run::state::{CHARTS, Charts};
use crate::tui::widgets::text::clip_words;
use crate::tui::widgets::value_steps::engineering;
use cmra_engine::model::run::Run;
use cmra_studies::report::chart::Below;
use cmra_studies::report::figures::run::{
    event_letter, event_marks, event_words as event_words_of,
};
use cmra_studies::report::law::Law;
use cmra_studies::report::series::Channel;

/// Minimum rows of a readable chart.
const LEAST: u16 = 3;
/// Maximum number of marked events; a plate that chatters on its stop has many more.
const EVENT_LINES: usize = 24;

/// Chart in the box: its index, its rows on the screen, and its lower border.
struct Place {
    chart: usize,
    area: Rect,
    begins: bool,
    below: Below,
    /// Reason for a chart without data. The title shows it, and the chart has no rows.
    absent: Option<String>,
}

pub(crate) fn render(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let drawing = if app.is_full() { impact::rows(area.height) } else { 0 };
    let (area, below) = split_bottom(area, drawing);
    if drawing > 0 {
        canvas.pane(below, CHARTS);
        impact::render(app, below, focused, canvas);
    }
    let places = places(app, area);
    let data: Vec<Vec<Data<'_>>> = places.iter().map(|place| curves(app, place.chart)).collect();
    let mut charts: Vec<Chart<'_>> =
        places.iter().zip(&data).map(|(place, data)| chart(app, place, data)).collect();
    for (chart, place) in charts.iter_mut().zip(&places) {
        chart.focused = focused && app.pages.run.charts.selected == place.chart;
        // The table of runs shows the markers if it is visible.
        if places.len() > 1 || !app.is_full() {
            chart.legend = Legend::Hidden;
        }
    }
    let areas: Vec<Rect> = places.iter().map(|place| place.area).collect();
    align_gutters(&mut charts, &areas);
    canvas.pane(area, CHARTS);
    for (chart, place) in charts.iter().zip(&places) {
        if let Some(why) = &place.absent {
            absent(app, place, why, chart.focused, canvas);
            continue;
        }
        let layout = canvas.draw(chart, place.area);
        let at = place.chart;
        if app.pages.run.charts.quantities[at].is_over_time() {
            canvas.plot(&layout, |value, _| Some(Target::Value { pane: CHARTS, chart: at, value }));
        }
        nothing_yet(app, place.area, canvas);
    }
}

/// Draws the title of a chart without rows: a line across the box, or the last line.
fn absent(app: &App, place: &Place, why: &str, focused: bool, canvas: &mut Canvas<'_>) {
    let title = format!("{}: {why}", app.pages.run.charts.quantities[place.chart].title());
    let frame = Frame::Stacked { begins: place.begins, below: Below::Nothing };
    PaneFrame::new(title).focused(focused).frame(frame).draw(place.area, canvas);
    if place.below == Below::End {
        let role = if focused { Role::Focus } else { Role::Border };
        canvas.put(place.area, (0, 0), "└", role);
        canvas.put(place.area, (place.area.width - 1, 0), "┘", role);
    }
}

/// Returns the charts that fit an area, from top to bottom, including the selected one.
fn places(app: &App, area: Rect) -> Vec<Place> {
    let all: Vec<usize> = (0..app.pages.run.charts.quantities.len()).collect();
    let selected = app.pages.run.charts.selected;
    if app.is_full() {
        return stack(app, area, &[selected]).unwrap_or_default();
    }
    let two = if selected == 0 { [0, 1] } else { [selected - 1, selected] };
    let fitting = [&all[..], &two[..]].into_iter().find_map(|charts| stack(app, area, charts));
    fitting.or_else(|| stack(app, area, &[selected])).unwrap_or_default()
}

/// Stacks these charts; `None` if one would have too few rows.
fn stack(app: &App, area: Rect, charts: &[usize]) -> Option<Vec<Place>> {
    let absent: Vec<Option<String>> = charts.iter().map(|chart| absence(app, *chart)).collect();
    let drawn = u16::try_from(absent.iter().filter(|it| it.is_none()).count()).ok()?;
    let Charts { quantities, windows, .. } = &app.pages.run.charts;
    let has_same_axis = |one: usize, other: usize| {
        let are_over_time = [one, other].iter().all(|at| quantities[*at].is_over_time());
        are_over_time && windows[one] == windows[other]
    };
    let below = |at: usize| match charts.get(at + 1) {
        None => Below::End,
        Some(next) if absent[at + 1].is_none() && has_same_axis(charts[at], *next) => {
            Below::Nothing
        }
        Some(_) => Below::Across,
    };
    // A title for each, and a line for each axis.
    let has_line = |at: &usize| absent[*at].is_none() && below(*at) != Below::Nothing;
    let lines = charts.len() + (0..charts.len()).filter(has_line).count();
    let rows = area.height.checked_sub(u16::try_from(lines).ok()?)?;
    if rows < LEAST * drawn && charts.len() > 1 {
        return None;
    }
    let (each, mut over) = (rows.checked_div(drawn).unwrap_or(0), rows.checked_rem(drawn)?);
    let kept = kept_heights(charts, &absent, area.height)
        .filter(|heights| (0..3).all(|at| heights[at] > LEAST + u16::from(has_line(&at))));
    let mut y = area.y;
    let place = |(at, why): (usize, Option<String>)| {
        let own = if why.is_some() { 0 } else { each + u16::from(over > 0) };
        over = over.saturating_sub(u16::from(own > 0));
        let height = 1 + own + u16::from(has_line(&at));
        let height = kept.map_or(height, |heights| heights[at]);
        let area = Rect { y, height, ..area };
        y += height;
        Place { chart: charts[at], area, begins: at == 0, below: below(at), absent: why }
    };
    Some(absent.clone().into_iter().enumerate().map(place).collect())
}

/// Returns the heights of three charts with data as for their initial time ranges, where the first two share an axis. Another range of one
/// chart then leaves the others in their places, which saves most of the bytes of a frame.
fn kept_heights(charts: &[usize], absent: &[Option<String>], height: u16) -> Option<[u16; 3]> {
    let has_data = charts.len() == 3 && absent.iter().all(Option::is_none);
    let rows = height.checked_sub(5).filter(|_| has_data)?;
    let plot = |at: u16| rows / 3 + u16::from(rows % 3 > at);
    Some([1 + plot(0), 2 + plot(1), 2 + plot(2)])
}

/// Explains why a chart has no data in any run.
fn absence(app: &App, chart: usize) -> Option<String> {
    let quantity = app.pages.run.charts.quantities[chart];
    let of = |run: &Run| {
        if quantity == Channel::PlateDisplacement && is_held(run) {
            let farthest = run.max_plate_displacement_m.filter(|_| run.scene.is_sprung());
            return Some(farthest.map_or_else(
                || "plate held".to_owned(),
                |farthest| format!("{}, held", engineering(farthest, "m")),
            ));
        }
        quantity.absence(&run.scene).map(str::to_owned)
    };
    let runs = app.visible_runs();
    let reasons: Option<Vec<String>> = runs.iter().map(|view| of(view.run)).collect();
    reasons.and_then(|reasons| reasons.last().cloned())
}

/// Draws the reason why there are no curves.
fn nothing_yet(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    if area.height < 3 || !app.visible_runs().is_empty() {
        return;
    }
    let text = match &app.jobs.current {
        Some(_) => "running the first time",
        None => NO_RESULTS,
    };
    canvas.put_centred(area, &app.keymap.shown(text));
}

fn chart<'a>(app: &'a App, place: &Place, data: &'a [Data<'a>]) -> Chart<'a> {
    let index = place.chart;
    let quantity = app.pages.run.charts.quantities[index];
    let before = before_points(app, place);
    let before =
        before.map(|points| Curve::points('·', "", points).colour(0).emphasis(Emphasis::Faint));
    let curves = data.iter().map(|Data { view, points }| {
        Curve::new(MARKERS[view.index % MARKERS.len()], label(view), points)
            .colour(view.index)
            .emphasis(emphasis(view.old, view.letter.is_none()))
    });
    let curves = before.into_iter().chain(curves);
    let measured = app.pages.run.drawn.get(index, quantity).iter().map(Curve::borrowed);
    let curves = curves.chain(measured);
    let frame = Frame::Stacked { begins: place.begins, below: place.below };
    // A corner, a line and blanks around the title.
    let room = usize::from(place.area.width.saturating_sub(5));
    let alike = alike(app, index, data);
    let taken = if alike.is_empty() { 0 } else { alike.len() + 4 };
    let title = title(app, index, room.saturating_sub(taken));
    if !quantity.is_over_time() {
        return Chart { frame, ..over_displacement(app, index, title, data, curves.collect()) };
    }
    let end_s = end_s(app, index);
    let time = ViewRange::new(0.0, end_s);
    let x = Axis::new("t", time).unit(Unit::with_prefix(time.size(), "s"));
    let marks = app.shown.iter().flat_map(|shown| event_marks(&shown.run, (0.0, end_s)));
    let left = room.saturating_sub(title.chars().count() + 4);
    Chart {
        marks: marks.take(EVENT_LINES).collect(),
        levels: levels(app, quantity),
        crosshair: crosshair_s(app),
        frame,
        note: note(app, index, alike, left).into(),
        ..Chart::new(title, x, value_axis(app, data, index), curves.collect())
    }
}

/// Number of points of the run before an edit that an axis must include.
const AXIS_POINTS: u16 = 64;

/// Returns points at equal time intervals of the run before the latest edit, one every second column; `None` without such a run.
fn before_points(app: &App, place: &Place) -> Option<Vec<(f64, f64)>> {
    let quantity = app.pages.run.charts.quantities[place.chart];
    let run = app.run_before().filter(|_| quantity.is_over_time())?;
    Some(before_values(quantity, run, end_s(app, place.chart), place.area.width / 2))
}

fn before_values(quantity: Channel, run: &Run, end_s: f64, count: u16) -> Vec<(f64, f64)> {
    let times = (0..=count).map(|at| end_s * f64::from(at) / f64::from(count.max(1)));
    let point = |t_s| Some((t_s, quantity.at(run, t_s)?));
    times.filter_map(point).filter(|point| point.1.is_finite()).collect()
}

/// Returns the time of the crosshair, s; always present for an enlarged chart, because the drawing uses it.
fn crosshair_s(app: &App) -> Option<f64> {
    if app.is_full() { Some(time_shown_s(app)) } else { app.pages.run.charts.cursor_s }
}

/// Returns the levels of the plate's thickness and the stop position.
fn levels(app: &App, quantity: Channel) -> Vec<Mark<'static>> {
    let Some(shown) = &app.shown else { return Vec::new() };
    let scene = &shown.run.scene;
    match quantity {
        Channel::Penetration => vec![Mark::new(scene.target.thickness_m, "h")],
        Channel::PlateDisplacement => {
            let stop = scene.mechanism.stop.position_m;
            stop.map(|stop_m| Mark::new(stop_m, "stop")).into_iter().collect()
        }
        _ => Vec::new(),
    }
}

/// Lists the pins that coincide with the current run in a chart: `A = now`.
fn alike(app: &App, chart: usize, data: &[Data<'_>]) -> String {
    let quantity = app.pages.run.charts.quantities[chart];
    let end_s = end_s(app, chart);
    let now = data.iter().find(|curve| curve.view.letter.is_none()).map(|curve| curve.view.run);
    let alike = data.iter().filter_map(|curve| {
        let letter = curve.view.letter?;
        coincide(quantity, now?, curve.view.run, end_s).then(|| format!("{letter} = now"))
    });
    alike.collect::<Vec<_>>().join(", ")
}

/// Returns the note of a title: coinciding pins, and the meanings of the event letters.
fn note(app: &App, chart: usize, alike: String, room: usize) -> String {
    let gap = if alike.is_empty() { "" } else { "  " };
    [format!("{alike}{gap}{}", event_words(app, chart)), alike]
        .into_iter()
        .find(|text| text.chars().count() <= room)
        .unwrap_or_default()
}

/// Fraction of a range below which differences are invisible.
const APART: f64 = 0.01;

/// Returns `true` if the curves of two runs coincide on the screen up to a time.
fn coincide(quantity: Channel, one: &Run, other: &Run, end_s: f64) -> bool {
    let times = (0..=100).map(|step| end_s * f64::from(step) / 100.0);
    let at = |t_s| (quantity.at(one, t_s), quantity.at(other, t_s));
    let pairs: Vec<(Option<f64>, Option<f64>)> = times.map(at).collect();
    let values = pairs.iter().flat_map(|pair| [pair.0, pair.1]).flatten();
    let size = values.fold(0.0_f64, |most, value| most.max(value.abs()));
    pairs.into_iter().all(|pair| match pair {
        (Some(a), Some(b)) => (a - b).abs() <= APART * size,
        (a, b) => a.is_none() && b.is_none(),
    })
}

/// Builds a chart over the plate displacement, with the range used by the current run and the limits of its mechanism.
fn over_displacement<'a>(
    app: &App,
    index: usize,
    title: String,
    data: &[Data<'_>],
    curves: Vec<Curve<'a>>,
) -> Chart<'a> {
    let quantity = app.pages.run.charts.quantities[index];
    let run = app.shown.as_ref().map(|shown| &shown.run);
    let law = run.and_then(|run| Law::from_run(run));
    let points = || data.iter().flat_map(|curve| curve.points.iter());
    let limits = law.iter().flat_map(|law| <[f64; 2]>::from(law.range_m()));
    let x = Axis::over("x", "m", Scale::Linear, points().map(|point| point.0).chain(limits));
    let y = Axis::over("", quantity.unit(), Scale::Linear, points().map(|point| point.1));
    let none = || Axis::new("", ViewRange::default());
    let (x, y) = (x.unwrap_or_else(none), y.unwrap_or_else(none).with_zero());
    let levels = if quantity == Channel::Stress { vec![Mark::new(1.0, "yield")] } else { vec![] };
    Chart {
        marks: law.map_or_else(Vec::new, |law| law.marks()),
        levels,
        crosshair: run
            .zip(crosshair_s(app))
            .and_then(|(run, t_s)| Channel::PlateDisplacement.at(run, t_s)),
        ..Chart::new(title, x.padded(0.04), y.padded(0.04), curves)
    }
}

/// Returns a vertical axis that contains all curves.
fn value_axis(app: &App, data: &[Data<'_>], chart: usize) -> Axis<'static> {
    let (quantity, end_s) = (app.pages.run.charts.quantities[chart], end_s(app, chart));
    let points = data.iter().flat_map(|curve| &curve.points).filter(|point| point.0 <= end_s);
    // Include the values at the end time, because there may be no point just before it.
    let at_end = data.iter().filter_map(|curve| quantity.at(curve.view.run, end_s));
    let before = app.run_before().map(|run| before_values(quantity, run, end_s, AXIS_POINTS));
    let before = before.into_iter().flatten().map(|point| point.1);
    let measured = app.pages.run.drawn.get(chart, quantity).iter();
    let measured = measured.flat_map(|curve| curve.points.iter()).map(|point| point.1);
    let values = points.map(|point| point.1).chain(at_end).chain(before).chain(measured);
    let none = || Axis::new("", ViewRange::default()).unit(Unit::new(quantity.unit()));
    let axis = Axis::over("", quantity.unit(), Scale::Linear, values).unwrap_or_else(none);
    // An axis of positive rates starts at zero, as a reader expects.
    let is_rate = axis.view.lo() >= 0.0 && axis.view.lo() < 0.5 * axis.view.hi();
    if is_rate { axis.with_zero() } else { axis }
}

/// Returns `now`, or letter and shortened name of a pin.
fn label(view: &RunView<'_>) -> String {
    view.letter.map_or_else(
        || "now".to_owned(),
        |letter| format!("{letter} {}", clip_words(view.name, 16)),
    )
}

/// Explains the letters of a chart's event lines.
pub(crate) fn event_words(app: &App, chart: usize) -> String {
    let end_s = end_s(app, chart);
    let run = app.shown.as_ref().map(|shown| &shown.run);
    let events =
        run.into_iter().flat_map(|run| run.events.iter().enumerate().map(move |it| (run, it)));
    let words: Vec<String> = events
        .filter(|(_, (_, event))| event.t_s <= end_s)
        .take(EVENT_LINES)
        .map(|(run, (index, event))| {
            format!("{} {}", event_letter(index), event_words_of(run, event))
        })
        .collect();
    words.join("  ")
}
