//! The charts of the Run tab: one or three on a common time axis, with readouts below a single one.

use ratatui::text::{Line, Span};

use crate::report::figures::run::{event_letter, event_marks};
use crate::report::law::Law;
use crate::report::run::page::of_first;
use crate::report::series::Channel;
use crate::tui::app::layout::NARROW;
use crate::tui::app::status::{short_name, value_at};
use crate::tui::chart::{
    self, Axis, Chart, Curve, Emphasis, Frame, Labels, Legend, MARKERS, Mark, Side, Unit,
    align_gutters,
};
use crate::tui::pages::prelude::*;
use crate::tui::pages::run::CHARTS;
use crate::tui::pages::run::charts::{Curve as Data, Window};
use crate::tui::pages::run::runs::{RunView, engineering};

/// Rows of readout below a single chart, without the line that closes the box.
const READOUT_ROWS: u16 = 2;
/// How the curve of a second axis is marked.
const SECOND: char = '~';
const SECOND_COLOUR: usize = 9;
/// Where the readouts of further runs have no room.
const MORE: &str = "  ..";
const EVENT_LINES: usize = 24;

pub(crate) fn render(app: &App, areas: &[Rect], focused: bool, canvas: &mut Canvas<'_>) {
    match areas {
        [] => {}
        [area] => single(app, *area, focused, canvas),
        _ => stacked(app, areas, focused, canvas),
    }
}

/// Say what the areas of a chart are to the mouse.
fn hits(app: &App, chart: usize, area: Rect, layout: &chart::Layout, canvas: &mut Canvas<'_>) {
    canvas.pane(area, CHARTS);
    canvas.plot_columns.get_or_insert(layout.plot.width);
    if app.charts.quantities[chart].is_over_time() {
        canvas.plot(layout, |value, _| Some(Target::Value { pane: CHARTS, chart, value }));
    }
}

fn single(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let inner = PaneFrame::new("").focused(focused).draw(area, canvas);
    let data = app.curves(app.charts.quantities[app.charts.selected]);
    let below = if area.height >= 12 { READOUT_ROWS } else { 0 };
    let second = app.second_curve(app.charts.selected);
    let mut chart = chart(app, app.charts.selected, &data, second.as_ref());
    chart.frame = Frame::OpenBelow;
    chart.focused = focused;
    let upper = Rect { height: area.height.saturating_sub(below + 1), ..area };
    let layout = canvas.draw(&chart, upper);
    hits(app, app.charts.selected, area, &layout, canvas);
    nothing_yet(app, app.charts.selected, upper, canvas);
    if below > 0 {
        let rows = Rect { y: inner.bottom() - below, height: below, ..inner };
        readout(app, rows, canvas);
    }
}

fn stacked(app: &App, areas: &[Rect], focused: bool, canvas: &mut Canvas<'_>) {
    let data: Vec<Vec<Data<'_>>> =
        (0..areas.len()).map(|index| app.curves(app.charts.quantities[index])).collect();
    let second: Vec<Option<(Channel, Data<'_>)>> =
        (0..areas.len()).map(|index| app.second_curve(index)).collect();
    let both = data.iter().zip(&second).enumerate();
    let mut charts: Vec<Chart<'_>> =
        both.map(|(index, (data, second))| chart(app, index, data, second.as_ref())).collect();
    let last = charts.len() - 1;
    for (index, chart) in charts.iter_mut().enumerate() {
        chart.focused = focused && app.charts.selected == index;
        if index > 0 && second[index].is_none() {
            chart.legend = Legend::Hidden;
        }
        let is_over_time = app.charts.quantities[index].is_over_time();
        if is_over_time && index < last && areas[index].height < 11 {
            chart.x.labels = Labels::Hidden;
        }
    }
    align_gutters(&mut charts, areas);
    for (index, (chart, area)) in charts.iter().zip(areas).enumerate() {
        let layout = canvas.draw(chart, *area);
        hits(app, index, *area, &layout, canvas);
        nothing_yet(app, index, *area, canvas);
    }
}

/// Where there is no curve: say why.
fn nothing_yet(app: &App, chart: usize, area: Rect, canvas: &mut Canvas<'_>) {
    let runs = app.visible_runs();
    let quantity = app.charts.quantities[chart];
    let absent = runs.iter().map(|view| quantity.absence(&view.run.scene));
    let absent = absent.reduce(Option::and).flatten();
    if area.height < 3 || absent.is_none() && !runs.is_empty() {
        return;
    }
    let text = match (&app.shown, &app.jobs.current) {
        _ if absent.is_some() => absent.unwrap_or_default(),
        (Some(_), _) => "all runs are hidden: <show-hide> in the pane Runs shows them",
        (None, Some(_)) => "running the first time",
        (None, None) => NO_RESULTS,
    };
    canvas.put_centred(area, &app.keymap.shown(text));
}

/// A chart of these curves, with a second axis for the quantity and curve that have one.
fn chart<'a>(
    app: &'a App,
    index: usize,
    data: &'a [Data<'a>],
    second: Option<&'a (Channel, Data<'a>)>,
) -> Chart<'a> {
    let quantity = app.charts.quantities[index];
    let curves = data.iter().map(|Data { view, points }| {
        Curve::new(MARKERS[view.index % MARKERS.len()], label(view), points)
            .colour(view.index)
            .emphasis(match (view.old, view.letter) {
                (true, _) => Emphasis::Stale,
                (false, None) => Emphasis::Selected,
                (false, Some(_)) => Emphasis::Normal,
            })
    });
    if !quantity.is_over_time() {
        return over_displacement(app, index, data, curves.collect());
    }
    let range @ (from, to) = app.time_range_s();
    let time = ViewRange::new(from, to);
    let x =
        Axis::new("t", time).unit(Unit::with_prefix(time.size(), "s")).scale(app.charts.time_scale);
    let scale = app.charts.value_scales[index];
    let y = value_axis(app, data, quantity, scale).scale(scale);
    let right = second.map(|(quantity, curve)| {
        let axis = value_axis(app, std::slice::from_ref(curve), *quantity, Scale::Linear);
        Axis { label: quantity.symbol().into(), ..axis }
    });
    let overlay = second.map(|(quantity, curve)| {
        let run = short_name(&curve.view);
        Curve::new(SECOND, format!("{} {run}", quantity.symbol()), &curve.points)
            .colour(SECOND_COLOUR)
            .emphasis(if curve.view.old { Emphasis::Stale } else { Emphasis::Normal })
            .side(Side::Right)
    });
    // Of very many events (a plate rattling on its stop) only the first ones.
    let shown = app.shown.iter().filter(|_| app.current_visible);
    let marks = shown.flat_map(|shown| event_marks(&shown.run, range).take(EVENT_LINES));
    Chart {
        marks: marks.collect(),
        crosshair: app.charts.cursor_s,
        right,
        ..Chart::new(title(app, quantity), x, y, overlay.into_iter().chain(curves).collect())
    }
}

/// What depends on the plate's displacement, with what the current run used of its mechanism, and its limits.
fn over_displacement<'a>(
    app: &App,
    index: usize,
    data: &[Data<'_>],
    curves: Vec<Curve<'a>>,
) -> Chart<'a> {
    let quantity = app.charts.quantities[index];
    let run = app.shown.as_ref().filter(|_| app.current_visible).map(|shown| &shown.run);
    let law = run.and_then(|run| Law::of(run));
    let points = || data.iter().flat_map(|curve| curve.points.iter());
    let limits = law.iter().flat_map(|law| <[f64; 2]>::from(law.range_m()));
    let x = Axis::over("x", "m", Scale::Linear, points().map(|point| point.0).chain(limits));
    let scale = app.charts.value_scales[index];
    let y = Axis::over("", quantity.unit(), scale, points().map(|point| point.1));
    let none = || Axis::new("", ViewRange::default());
    let (x, mut y) = (x.unwrap_or_else(none), y.unwrap_or_else(none));
    if scale == Scale::Linear {
        y = y.with_zero();
    }
    let levels = if quantity == Channel::Stress { vec![Mark::new(1.0, "yield")] } else { vec![] };
    Chart {
        marks: law.map_or_else(Vec::new, |law| law.marks()),
        levels,
        crosshair: run
            .zip(app.charts.cursor_s)
            .and_then(|(run, t_s)| Channel::PlateDisplacement.at(run, t_s)),
        ..Chart::new(title(app, quantity), x.padded(0.04), y.padded(0.04), curves)
    }
}

/// A vertical axis that shows all of some curves.
fn value_axis(app: &App, data: &[Data<'_>], quantity: Channel, scale: Scale) -> Axis<'static> {
    let (low, high) = app.value_range(data, scale);
    let values = match scale {
        Scale::Linear => ViewRange::new(low, high).padded(scale, 0.04),
        Scale::Log10 => ViewRange::new(low, high).on(scale),
    };
    // Rates at or above zero begin at zero: the eye takes the axis for it.
    let values = if scale == Scale::Linear && low >= 0.0 && low < 0.5 * high {
        ViewRange::new(0.0, values.hi())
    } else {
        values
    };
    Axis::new("", values).unit(Unit::with_prefix(values.size(), quantity.unit()))
}

/// `now`, or letter and name of a pin, kept short.
fn label(view: &RunView<'_>) -> String {
    view.letter
        .map_or_else(|| "now".to_owned(), |letter| format!("{letter} {}", clip(view.name, 16)))
}

fn title(app: &App, quantity: Channel) -> String {
    let is_difference = app.charts.difference && quantity.is_over_time();
    if let Some(pin) = app.reference_pin().filter(|_| is_difference) {
        return format!("{} {} minus {}'s", quantity.title(), quantity.symbol(), pin.letter);
    }
    let first = app.visible_runs().iter().map(|view| of_first(view.run)).max().unwrap_or_default();
    // The unit stands behind it, and is to have room.
    let is_short = !first.is_empty() && app.size.0 < NARROW;
    let name = if is_short { "" } else { quantity.title() };
    // The axis below says the rest.
    let name = name.trim_end_matches(" over displacement");
    format!("{name} {}{first}", quantity.symbol()).trim_start().to_owned()
}

/// Two rows: the values at the crosshair, and those at the first arrest (or what the window shows).
fn readout(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let quantity = app.charts.quantities[app.charts.selected];
    let views = app.visible_runs();
    // Values first, then what they are of; without a time before them it always has room.
    let line = |lead: String, name: &str, value: &dyn Fn(&RunView<'_>) -> String| {
        let mut spans = vec![Span::styled(format!(" {lead}"), app.theme.style(Role::Text))];
        let kept = if lead.is_empty() { name.chars().count() + 2 } else { lead.chars().count() };
        let mut left = usize::from(area.width).saturating_sub(kept + 1);
        let values = views.iter().rev().map(|view| (short_name(view), value(view))).collect();
        let values = in_one_unit(values, left);
        for (place, (view, (name, value))) in views.iter().rev().zip(values).enumerate() {
            let blank = if place == 0 && lead.is_empty() { "" } else { "  " };
            let name = format!("{blank}{name} ");
            let width = name.chars().count() + value.chars().count();
            let room = if place + 1 < views.len() { MORE.len() } else { 0 };
            if width + room > left {
                spans.push(Span::styled(MORE, app.theme.style(Role::Dim)));
                break;
            }
            left -= width;
            spans.push(Span::styled(name, app.theme.style(Role::Curve(view.index))));
            spans.push(Span::raw(value));
        }
        if !name.is_empty() && (lead.is_empty() || name.chars().count() + 2 <= left) {
            spans.push(Span::styled(format!("  {name}"), app.theme.style(Role::Text)));
        }
        Line::from(spans)
    };
    let first = if let Some(t_s) = app.charts.cursor_s {
        line(format!("t {}", engineering(t_s, "s")), app.event_at_cursor().unwrap_or(""), &|view| {
            let second = app.charts.second[app.charts.selected];
            let second = second.filter(|_| view.letter.is_none()).map_or_else(String::new, |one| {
                format!("  {} {}", one.symbol(), value_at(view.run, one, t_s))
            });
            value_at(view.run, quantity, t_s) + &second
        })
    } else {
        let text = events_in_view(app, usize::from(area.width.saturating_sub(1)));
        Line::from(Span::styled(format!(" {text}"), app.theme.style(Role::Dim)))
    };
    canvas.put_line(area, 0, &first);
    if views.is_empty() {
        return;
    }
    // Of perforations there is none.
    if views.iter().any(|view| view.run.first_arrest.is_some()) {
        let arrest = line(String::new(), "first arrest", &|view| {
            view.run
                .first_arrest
                .map_or_else(|| "-".to_owned(), |arrest| value_at(view.run, quantity, arrest.t_s))
        });
        canvas.put_line(area, 1, &arrest);
    }
}

/// Names and values; where that makes room for all of them, a unit that they share stands at the last one only.
fn in_one_unit(mut values: Vec<(String, String)>, room: usize) -> Vec<(String, String)> {
    let needed: usize = values.iter().map(|(name, value)| name.len() + value.len() + 3).sum();
    let Some(((_, last), others)) = values.split_last_mut() else { return values };
    let unit = last.rfind(' ').map_or("", |at| &last[at..]);
    let is_shared = others.iter().all(|(_, value)| value.ends_with(unit));
    if is_shared && needed > room && needed - others.len() * unit.len() <= room {
        for (_, value) in others {
            value.truncate(value.len() - unit.len());
        }
    }
    values
}

/// What the letters of the event lines mean, and, where there is room, how to see the other part of the time.
fn events_in_view(app: &App, width: usize) -> String {
    let (from, to) = app.time_range_s();
    let run = app.shown.as_ref().map(|shown| &shown.run);
    let events = run.into_iter().flat_map(|run| run.events.iter().enumerate());
    let words: Vec<String> = events
        .filter(|(_, event)| (from..=to).contains(&event.t_s))
        .take(EVENT_LINES)
        .map(|(index, event)| format!("{} {}", event_letter(index), event.kind.words()))
        .collect();
    let text = words.join("  ");
    let hint = app.keymap.shown(match app.charts.window {
        Window::Contact => "(<window>: whole response)",
        Window::Whole => "(<window>: contact only)",
    });
    if run.is_some() && text.chars().count() + hint.chars().count() + 2 <= width {
        return format!("{text}  {hint}").trim_start().to_owned();
    }
    clip(&text, width)
}
