//! The charts of the Run tab: as many as have room above each other in one box, each with its number in its title.

use crate::model::run::{Outcome, Run, Warning, envelope};
use crate::report::chart::Below;
use crate::report::figures::run::{contact_window_s, event_letter, event_marks};
use crate::report::law::Law;
use crate::report::run::page::{self, of_first};
use crate::report::series::Channel;
use crate::tui::app::pins::RunView;
use crate::tui::chart::{
    Axis, Chart, Curve, Frame, Legend, MARKERS, Mark, Unit, align_gutters, emphasis,
};
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::charts::{Curve as Data, is_free, is_held};
use crate::tui::pages::run::state::{CHARTS, Charts, Window};
use crate::tui::widgets::steps::engineering;
use crate::tui::widgets::text::fitting;

/// Rows of a chart that can be read.
const LEAST: u16 = 3;
/// Events that are marked: of very many (a plate rattling on its stop) only the first ones.
const EVENT_LINES: usize = 24;

/// A chart in the box: its place among the charts, its rows of the screen, and its lower line.
struct Place {
    chart: usize,
    area: Rect,
    begins: bool,
    below: Below,
    /// Why it has nothing to draw: then its title says so, and it has no rows.
    absent: Option<String>,
}

pub(crate) fn render(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let places = places(app, area);
    let data: Vec<Vec<Data<'_>>> = places.iter().map(|place| app.curves(place.chart)).collect();
    let mut charts: Vec<Chart<'_>> =
        places.iter().zip(&data).map(|(place, data)| chart(app, place, data)).collect();
    for (chart, place) in charts.iter_mut().zip(&places) {
        chart.focused = focused && app.pages.run.charts.selected == place.chart;
        // The table of runs has the markers, where it is seen.
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

/// The title of a chart without rows: a line across the box, or the last one.
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

/// The charts that have room in an area, from top to bottom: the selected one is among them.
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

/// These charts above each other; `None` where one would have too few rows.
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
    // A title each, and a line for each axis.
    let has_line = |at: &usize| absent[*at].is_none() && below(*at) != Below::Nothing;
    let lines = charts.len() + (0..charts.len()).filter(has_line).count();
    let rows = area.height.checked_sub(u16::try_from(lines).ok()?)?;
    if rows < LEAST * drawn && charts.len() > 1 {
        return None;
    }
    let (each, mut over) = (rows.checked_div(drawn).unwrap_or(0), rows.checked_rem(drawn)?);
    let mut y = area.y;
    let place = |(at, why): (usize, Option<String>)| {
        let own = if why.is_some() { 0 } else { each + u16::from(over > 0) };
        over = over.saturating_sub(u16::from(own > 0));
        let height = 1 + own + u16::from(has_line(&at));
        let area = Rect { y, height, ..area };
        y += height;
        Place { chart: charts[at], area, begins: at == 0, below: below(at), absent: why }
    };
    Some(absent.clone().into_iter().enumerate().map(place).collect())
}

/// Why a chart has nothing to draw, in all runs.
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

/// Where there is no curve: say why.
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
    let curves = data.iter().map(|Data { view, points }| {
        Curve::new(MARKERS[view.index % MARKERS.len()], label(view), points)
            .colour(view.index)
            .emphasis(emphasis(view.old, view.letter.is_none()))
    });
    let frame = Frame::Stacked { begins: place.begins, below: place.below };
    // A corner, a line and blanks around the title.
    let room = usize::from(place.area.width.saturating_sub(5));
    let alike = alike(app, index, data);
    let taken = if alike.is_empty() { 0 } else { alike.len() + 4 };
    let title = title(app, index, room.saturating_sub(taken));
    if !quantity.is_over_time() {
        return Chart { frame, ..over_displacement(app, index, title, data, curves.collect()) };
    }
    let end_s = app.end_s(index);
    let time = ViewRange::new(0.0, end_s);
    let x = Axis::new("t", time).unit(Unit::with_prefix(time.size(), "s"));
    let marks = app.shown.iter().flat_map(|shown| event_marks(&shown.run, (0.0, end_s)));
    let left = room.saturating_sub(title.chars().count() + 4);
    Chart {
        marks: marks.take(EVENT_LINES).collect(),
        levels: levels(app, quantity),
        crosshair: app.pages.run.charts.cursor_s,
        frame,
        note: note(app, index, alike, left).into(),
        ..Chart::new(title, x, value_axis(app, data, index), curves.collect())
    }
}

/// The plate's thickness, and where the stop stands.
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

/// The pins that coincide with the current run in a chart: `A = now`.
fn alike(app: &App, chart: usize, data: &[Data<'_>]) -> String {
    let quantity = app.pages.run.charts.quantities[chart];
    let end_s = app.end_s(chart);
    let now = data.iter().find(|curve| curve.view.letter.is_none()).map(|curve| curve.view.run);
    let alike = data.iter().filter_map(|curve| {
        let letter = curve.view.letter?;
        coincide(quantity, now?, curve.view.run, end_s).then(|| format!("{letter} = now"))
    });
    alike.collect::<Vec<_>>().join(", ")
}

/// At the right of a title, beside those: what the letters of the events mean.
fn note(app: &App, chart: usize, alike: String, room: usize) -> String {
    let gap = if alike.is_empty() { "" } else { "  " };
    [format!("{alike}{gap}{}", event_words(app, chart)), alike]
        .into_iter()
        .find(|text| text.chars().count() <= room)
        .unwrap_or_default()
}

/// Parts of a range that nobody sees apart.
const APART: f64 = 0.01;

/// Whether a quantity of two runs is one curve on the screen up to a time.
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

/// What depends on the plate's displacement, with what the current run used of its mechanism, and its limits.
fn over_displacement<'a>(
    app: &App,
    index: usize,
    title: String,
    data: &[Data<'_>],
    curves: Vec<Curve<'a>>,
) -> Chart<'a> {
    let quantity = app.pages.run.charts.quantities[index];
    let run = app.shown.as_ref().map(|shown| &shown.run);
    let law = run.and_then(|run| Law::of(run));
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
            .zip(app.pages.run.charts.cursor_s)
            .and_then(|(run, t_s)| Channel::PlateDisplacement.at(run, t_s)),
        ..Chart::new(title, x.padded(0.04), y.padded(0.04), curves)
    }
}

/// A vertical axis that shows all of some curves.
fn value_axis(app: &App, data: &[Data<'_>], chart: usize) -> Axis<'static> {
    let (quantity, end_s) = (app.pages.run.charts.quantities[chart], app.end_s(chart));
    let points = data.iter().flat_map(|curve| &curve.points).filter(|point| point.0 <= end_s);
    // What a curve passes at the end of the time counts, too: there may be no point just before it.
    let at_end = data.iter().filter_map(|curve| quantity.at(curve.view.run, end_s));
    let values = points.map(|point| point.1).chain(at_end);
    let none = || Axis::new("", ViewRange::default()).unit(Unit::new(quantity.unit()));
    let axis = Axis::over("", quantity.unit(), Scale::Linear, values).unwrap_or_else(none);
    // Rates at or above zero begin at zero: the eye takes the axis for it.
    let is_rate = axis.view.lo() >= 0.0 && axis.view.lo() < 0.5 * axis.view.hi();
    if is_rate { axis.with_zero() } else { axis }
}

/// `now`, or letter and name of a pin, kept short.
fn label(view: &RunView<'_>) -> String {
    view.letter
        .map_or_else(|| "now".to_owned(), |letter| format!("{letter} {}", clip(view.name, 16)))
}

/// The name of a chart with the number of the current run, in a given number of columns.
fn title(app: &App, chart: usize, room: usize) -> String {
    let quantity = app.pages.run.charts.quantities[chart];
    let name = quantity.title().trim_end_matches(" over displacement");
    let window = match app.pages.run.charts.windows[chart] {
        Window::Whole if quantity.is_over_time() => ", whole",
        Window::Whole | Window::Contact => "",
    };
    let Some(shown) = &app.shown else { return name.to_owned() };
    if app.shows_old() {
        return format!("{name} (old)");
    }
    let run = &*shown.run;
    let name = format!("{name}{}{window}", of_first(run));
    match quantity {
        Channel::Penetration => fitting(depth_titles(&name, run), room),
        Channel::ContactForce => {
            let peak = peak(run);
            fitting([format!("{name}, {peak}"), format!("Force, {peak}")], room)
        }
        Channel::PlateDisplacement => {
            let travel = travel(run);
            fitting([format!("{name}: {travel}"), format!("Plate: {travel}")], room)
        }
        _ => {
            let values = run.series.iter().map(|sample| quantity.of(sample).abs());
            let most = values.filter(|value| value.is_finite()).fold(0.0, f64::max);
            let most = engineering(most, quantity.unit());
            let title = format!("{name}, greatest {most}");
            fitting([if quantity.is_over_time() { title } else { name }], room)
        }
    }
}

/// The depth in its title, from the longest to the shortest: a fused one that the interface could not hold never stands alone.
fn depth_titles(name: &str, run: &Run) -> Vec<String> {
    let Some(depth) = depth(run) else {
        return vec![format!("{name}: {}", page::outcome(run)), name.to_owned()];
    };
    let percent = run.percent_of_baseline().filter(|_| run.scene.is_sprung());
    let share = |of: &str| percent.map_or_else(String::new, |it| format!(" ({it:.0} %{of})"));
    let plastic = plastic(run).map_or_else(String::new, |it| format!("; plastic: {it}"));
    let colon = if run.outcome == Outcome::Perforated { ":" } else { "" };
    vec![
        format!("{name}{colon} {depth}{}{plastic}", share(" of rigid mount")),
        format!("{name}{colon} {depth}{}{plastic}", share("")),
        format!("Depth {depth}{plastic}"),
        format!("{depth}{plastic}"),
    ]
}

/// The depth of a shot, and what becomes of it after the first contact; `None` where it is not known.
fn depth(run: &Run) -> Option<String> {
    let depth_m = run.final_penetration_m?;
    if run.outcome == Outcome::Perforated {
        return Some(through(run));
    }
    let depth = engineering(depth_m, "m");
    let first_m = run.first_arrest.map(|arrest| arrest.penetration_m);
    let is_later = first_m.is_some_and(|first_m| depth_m > first_m * 1.001);
    let leaves = run
        .separation
        .map_or_else(String::new, |it| format!(", leaves at {}", speed(it.velocity_m_s.abs())));
    let shows_first = contact_window_s(run) < 1.2 * run.contact_end_s();
    Some(match first_m.filter(|_| is_later && shows_first) {
        Some(first_m) => format!("{}, later {depth}{leaves}", engineering(first_m, "m")),
        None => format!("{depth}{leaves}"),
    })
}

/// That a shot is through, and how fast it goes on.
fn through(run: &Run) -> String {
    match run.residual_velocity_m_s {
        Some(left) if left < 0.0 => format!("through, back at {}", speed(-left)),
        Some(left) => format!("through, leaves at {}", speed(left)),
        None => "through".to_owned(),
    }
}

/// A velocity with one decimal, of a slow one with the figures that say something.
fn speed(velocity_m_s: f64) -> String {
    if velocity_m_s < 1.0 {
        engineering(velocity_m_s, "m/s")
    } else {
        format!("{velocity_m_s:.1} m/s")
    }
}

/// What a plastic interface comes to, where the fused one would have to carry more than its strength.
fn plastic(run: &Run) -> Option<String> {
    let is_exceeded =
        |it: &Warning| matches!(it, Warning::InterfacePush { .. } | Warning::InterfacePull { .. });
    let fails = run.warnings.iter().any(is_exceeded);
    let is_hit = envelope::fused_stop_hits(run).is_some_and(|hits| hits > 0);
    let plastic = run.plastic.as_ref().filter(|_| fails || is_hit)?;
    if plastic.outcome == Outcome::Perforated {
        return Some(through(plastic));
    }
    plastic.final_penetration_m.map(|depth_m| engineering(depth_m, "m"))
}

fn peak(run: &Run) -> String {
    if envelope::fused_stop_hits(run).is_some_and(|hits| hits > 0) {
        return "fused: unbounded at the stop".to_owned();
    }
    run.peak_contact_force_n.map_or_else(
        || "no peak: the collision takes no time".to_owned(),
        |peak| format!("peak {}", engineering(peak, "N")),
    )
}

fn travel(run: &Run) -> String {
    let stroke = run.stroke_m().filter(|_| run.scene.start_m() != 0.0);
    let stroke =
        stroke.map_or_else(String::new, |stroke| format!(", stroke {}", engineering(stroke, "m")));
    match (run.max_plate_displacement_m, run.at_least.plate_displacement_m) {
        (Some(most), _) => format!("greatest {}{stroke}", engineering(most, "m")),
        (None, Some(least)) => format!("at least {}", engineering(least, "m")),
        (None, None) if is_free(run) => {
            let last = run.series.last().map_or(0.0, |last| last.plate_velocity_m_s);
            format!("leaves at {}, no greatest", speed(last))
        }
        (None, None) => "greatest not known".to_owned(),
    }
}

/// What the letters of a chart's event lines mean.
pub(crate) fn event_words(app: &App, chart: usize) -> String {
    let end_s = app.end_s(chart);
    let run = app.shown.as_ref().map(|shown| &shown.run);
    let events = run.into_iter().flat_map(|run| run.events.iter().enumerate());
    let words: Vec<String> = events
        .filter(|(_, event)| event.t_s <= end_s)
        .take(EVENT_LINES)
        .map(|(index, event)| format!("{} {}", event_letter(index), event.kind.words()))
        .collect();
    words.join("  ")
}
