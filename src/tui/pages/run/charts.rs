//! The content of the charts: quantities, the time range, the crosshair, and the points of every curve. No drawing.

pub(crate) mod draw;

use std::ops::Range;

use crate::model::run::Run;
use crate::numerics::{larger, smaller};
use crate::report::series::{Channel, thinned};
use crate::tui::chart::Mapping;
use crate::tui::pages::prelude::*;
use crate::tui::pages::run::panes;
use crate::tui::pages::run::runs::{self, RunView};
use crate::tui::update::act::along;
use crate::tui::view::plot_columns;

/// Which part of the time is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Window {
    /// From first contact to a little after the first arrest (or perforation).
    Contact,
    Whole,
}

#[derive(Clone, Debug)]
pub struct Charts {
    /// Their quantities, from top to bottom.
    pub quantities: [Channel; 3],
    /// Their quantities on a second axis at the right, if any.
    pub second: [Option<Channel>; 3],
    /// The chart the keys act on.
    pub selected: usize,
    /// The crosshair, s since first contact.
    pub cursor_s: Option<f64>,
    /// Contact window or whole response.
    pub window: Window,
    /// A time range chosen by zooming or panning, s; `None`: all of the window.
    pub zoom_s: Option<ViewRange>,
    /// The vertical axes are fitted to the whole curves, not to the part in view.
    pub fits_whole: bool,
    pub time_scale: Scale,
    pub value_scales: [Scale; 3],
    /// Curves are differences to the first pinned run.
    pub difference: bool,
}

impl Default for Charts {
    fn default() -> Self {
        Self {
            quantities: [Channel::Penetration, Channel::PlateDisplacement, Channel::ContactForce],
            second: [None; 3],
            selected: 0,
            cursor_s: None,
            window: Window::Contact,
            zoom_s: None,
            fits_whole: false,
            time_scale: Scale::Linear,
            value_scales: [Scale::Linear; 3],
            difference: false,
        }
    }
}

/// The points of one run, SI.
#[derive(Clone, Debug)]
pub struct Curve<'a> {
    pub view: RunView<'a>,
    /// Time, s, and value; a gap where the value is not a number.
    pub points: Vec<(f64, f64)>,
}

/// How far beyond the range in view curves are given, as a share of it.
const BEYOND: f64 = 0.02;

impl App {
    /// The time range of the window without zoom, s.
    pub fn window_s(&self) -> (f64, f64) {
        let of = |run: &Run| match self.charts.window {
            Window::Contact => 1.1 * run.contact_end_s(),
            Window::Whole => run.series.last().map_or(0.0, |sample| sample.t_s),
        };
        let end = self
            .visible_runs()
            .iter()
            .map(|view| of(view.run))
            .filter(|end| end.is_finite() && *end > 0.0)
            .fold(0.0, larger);
        (0.0, if end > 0.0 { end } else { 1e-3 })
    }

    /// The time range on the screen, s; begins above zero on a logarithmic axis.
    pub fn time_range_s(&self) -> (f64, f64) {
        self.on_time_axis(
            self.charts.zoom_s.map_or_else(|| self.window_s(), |it| (it.lo(), it.hi())),
        )
    }

    fn on_time_axis(&self, (from, to): (f64, f64)) -> (f64, f64) {
        match self.charts.time_scale {
            Scale::Log10 if from <= 0.0 => (to * 1e-4, to),
            Scale::Log10 | Scale::Linear => (from, to),
        }
    }

    pub fn curves(&self, quantity: Channel) -> Vec<Curve<'_>> {
        let reference = self
            .reference_pin()
            .filter(|_| self.charts.difference)
            .and_then(|pin| pin.run.as_deref());
        self.visible_runs().into_iter().map(|view| self.curve(view, quantity, reference)).collect()
    }

    /// The points of a run that are in view, and one on either side of it.
    fn curve<'a>(
        &self,
        view: RunView<'a>,
        quantity: Channel,
        reference: Option<&Run>,
    ) -> Curve<'a> {
        let over_time = quantity.is_over_time();
        // Over the displacement the whole way is drawn.
        let seen = if over_time { self.samples_seen(view.run) } else { 0..view.run.series.len() };
        let samples = &view.run.series[seen];
        let mut points = quantity.points(view.run, samples);
        if let Some(run) = reference.filter(|_| over_time) {
            // At a jump, the value before it of both.
            points.dedup_by_key(|point| point.0.to_bits());
            for (t_s, value) in &mut points {
                *value -= quantity.at(run, *t_s).unwrap_or(f64::NAN);
            }
        }
        if over_time && self.charts.time_scale == Scale::Linear {
            points = thinned(points);
        }
        Curve { view, points }
    }

    fn samples_seen(&self, run: &Run) -> Range<usize> {
        let all = 0..run.series.len();
        if self.charts.fits_whole {
            return all;
        }
        let (from, to) = self.time_range_s();
        // The outermost dots of a chart stand for times a little beyond its range.
        let beyond = BEYOND * (to - from);
        let (from, to) = (from - beyond, to + beyond);
        let before = run.series.partition_point(|sample| sample.t_s < from);
        let within = run.series.partition_point(|sample| sample.t_s <= to);
        before.saturating_sub(1)..all.end.min(within + 1)
    }

    /// The curve of the second axis of a chart: the current run's where it is drawn, else the last visible one's.
    pub fn second_curve(&self, chart: usize) -> Option<(Channel, Curve<'_>)> {
        let quantity = self.charts.second[chart]?;
        Some((quantity, self.curves(quantity).pop()?))
    }

    /// Put the next quantity on the second axis of the selected chart, at last none; gives what is there now.
    pub fn next_second(&mut self) -> Option<Channel> {
        let chart = self.charts.selected;
        let first = self.charts.quantities[chart];
        let next = self.charts.second[chart].unwrap_or(first).next();
        // What is drawn over the displacement has no time axis to share, and stands last.
        let next = if next.is_over_time() { next } else { Channel::ALL[0] };
        self.charts.second[chart] = (next != first).then_some(next);
        self.charts.second[chart]
    }

    /// The range of values to show, over the curves; a little room is left to the chart itself.
    pub fn value_range(&self, curves: &[Curve<'_>], scale: Scale) -> (f64, f64) {
        let (from, to) = self.time_range_s();
        let seen = |t: f64| self.charts.fits_whole || (from..=to).contains(&t);
        let points = curves.iter().flat_map(|curve| curve.points.iter().copied());
        // What a curve passes at the ends of the range counts, too: there may be no point between them.
        let at_end = |curve: &Curve<'_>, t: f64| {
            let after = curve.points.partition_point(|point| point.0 < t);
            let (t0, a) = *curve.points.get(after.checked_sub(1)?)?;
            let (t1, b) = *curve.points.get(after)?;
            (t < t1).then(|| (t, a + (b - a) * (t - t0) / (t1 - t0)))
        };
        let at_ends = curves.iter().flat_map(|curve| [from, to].map(|t| at_end(curve, t)));
        let (low, high) = points
            .chain(at_ends.flatten())
            .filter(|(t, value)| seen(*t) && scale.shows(*value))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (_, value)| {
                (smaller(low, value), larger(high, value))
            });
        match (low < high, low.is_finite(), scale) {
            (true, _, _) => (low, high),
            (false, true, Scale::Linear) if low == 0.0 => (0.0, 1.0),
            (false, true, Scale::Linear) => (low - 0.1 * low.abs(), high + 0.1 * high.abs()),
            (false, true, Scale::Log10) => (low / 10.0, high * 10.0),
            (false, false, _) => (0.1, 1.0),
        }
    }

    /// Move the crosshair by columns of a plot so wide; it starts in the middle and stays in the range.
    pub fn move_cursor(&mut self, columns: i32, width: u16) {
        let (from, to) = self.time_range_s();
        let view = Mapping::new(self.charts.time_scale, ViewRange::new(from, to), width);
        let middle = || view.value(width / 2);
        let moved = self.charts.cursor_s.map_or_else(middle, |here| view.stepped(here, columns));
        self.charts.cursor_s = Some(moved);
    }

    /// Move the crosshair to the next or previous event of the current run and bring it into view; gives its name.
    pub fn move_to_event(&mut self, forward: bool) -> Option<&'static str> {
        let events = &self.shown.as_ref()?.run.events;
        let here = self.charts.cursor_s;
        let event = if forward {
            let start = here.unwrap_or(f64::NEG_INFINITY);
            events.iter().find(|event| event.t_s > start)
        } else {
            let start = here.unwrap_or(f64::INFINITY);
            events.iter().rev().find(|event| event.t_s < start)
        }?;
        let (t_s, words) = (event.t_s, event.kind.words());
        self.bring_into_view(t_s);
        Some(words)
    }

    /// Put the crosshair on a time, and that into view.
    pub fn bring_into_view(&mut self, t_s: f64) {
        self.charts.cursor_s = Some(t_s);
        let (from, to) = self.time_range_s();
        if t_s < from || t_s > to {
            let width = to - from;
            self.charts.zoom_s =
                Some(ViewRange::new((t_s - 0.5 * width).max(0.0), t_s + 0.5 * width));
        }
    }

    /// Columns of a chart that stand for time, about.
    fn chart_columns(&self) -> u16 {
        let body = self.layout().body;
        let chart = body.and_then(|body| panes(self, body).charts.first().copied());
        chart.map_or(40, |area| area.width.saturating_sub(12)).max(10)
    }

    /// The event of the current run under the crosshair.
    pub fn event_at_cursor(&self) -> Option<&'static str> {
        let cursor = self.charts.cursor_s?;
        let run = &self.shown.as_ref()?.run;
        let (from, to) = self.time_range_s();
        let near = 0.5 * (to - from) / f64::from(self.chart_columns());
        run.events
            .iter()
            .filter(|event| (event.t_s - cursor).abs() <= near)
            .min_by(|a, b| {
                let distance = |t: f64| (t - cursor).abs();
                distance(a.t_s).total_cmp(&distance(b.t_s))
            })
            .map(|event| event.kind.words())
    }

    /// The time axis, of which a part can be chosen.
    pub(crate) fn time_across(&mut self) -> Across<'_> {
        let range = |(from, to)| ViewRange::new(from, to);
        let view = range(self.time_range_s());
        let home = range(self.on_time_axis(self.window_s()));
        let bounds = range(self.whole_s());
        let (scale, about) = (self.charts.time_scale, self.charts.cursor_s);
        let mut across = Across::of(&mut self.charts.zoom_s, home, scale, about);
        (across.span.view, across.span.bounds) = (view, bounds);
        across
    }

    /// From first contact to the end of the longest visible run (or of the window, where that is later), s.
    fn whole_s(&self) -> (f64, f64) {
        let (begin, end) = self.window_s();
        let runs = self.visible_runs().into_iter();
        let ends = runs.filter_map(|view| Some(view.run.series.last()?.t_s));
        (begin, ends.fold(end, larger))
    }
}

pub(crate) fn act(app: &mut App, action: Action) -> bool {
    use Action as A;
    let selected = app.charts.selected;
    match action {
        A::LogX | A::SecondAxis if !app.charts.quantities[selected].is_over_time() => {
            app.refuse("this chart has no time axis: <view> shows another one");
        }
        A::Mark => runs::pin_scene(app),
        A::EventNext => event(app, true),
        A::EventPrevious => event(app, false),
        A::ZoomFit => {
            app.charts.fits_whole = false;
            return false;
        }
        A::FitVertical => fit(app),
        A::Window => window(app),
        A::View => {
            let mut next = app.charts.quantities[selected].next();
            while app.charts.quantities.contains(&next) {
                next = next.next();
            }
            show(app, next);
        }
        A::SecondAxis => second_axis(app),
        A::LogX => {
            app.charts.time_scale = app.charts.time_scale.toggled();
            app.tell(format!("time axis: {}", word(app.charts.time_scale)));
        }
        A::LogY => {
            let scale = &mut app.charts.value_scales[selected];
            *scale = scale.toggled();
            let text = format!("value axis: {}", word(*scale));
            app.tell(text);
        }
        A::Difference => difference(app),
        _ => match along(action, 10) {
            Some(by) => app.move_cursor(by.into(), plot_columns(app)),
            None => return false,
        },
    }
    true
}

/// Draw a quantity: the chart that has it is selected, else the selected one shows it.
pub(crate) fn show(app: &mut App, quantity: Channel) {
    let charts = &mut app.charts;
    if let Some(there) = charts.quantities.iter().position(|one| *one == quantity) {
        charts.selected = there;
        return;
    }
    let selected = charts.selected;
    charts.quantities[selected] = quantity;
    if charts.second[selected] == Some(quantity) || !quantity.is_over_time() {
        charts.second[selected] = None;
    }
}

fn second_axis(app: &mut App) {
    let text = match app.next_second() {
        Some(quantity) => format!(
            "right-hand axis: {} (<second-axis>: the next quantity; after the last none)",
            quantity.title().to_lowercase()
        ),
        None => "no second axis: <second-axis> puts a quantity there".to_owned(),
    };
    app.tell(text);
}

fn word(scale: Scale) -> &'static str {
    match scale {
        Scale::Linear => "linear",
        Scale::Log10 => "logarithmic (values of zero or less are not drawn)",
    }
}

fn event(app: &mut App, forward: bool) {
    if app.move_to_event(forward).is_none() {
        let text = match (&app.shown, forward) {
            (None, _) => "no run yet",
            (Some(shown), _) if shown.run.events.is_empty() => "this run has no events",
            (Some(_), true) => "no later event",
            (Some(_), false) => "no earlier event",
        };
        app.tell(text);
    }
}

fn fit(app: &mut App) {
    app.charts.fits_whole = !app.charts.fits_whole;
    let to = if app.charts.fits_whole { "the whole run" } else { "what is in view" };
    app.tell(format!("vertical axes: fitted to {to}"));
}

fn window(app: &mut App) {
    app.charts.window = match app.charts.window {
        Window::Contact => Window::Whole,
        Window::Whole => Window::Contact,
    };
    app.charts.zoom_s = None;
    app.tell(match app.charts.window {
        Window::Contact => "time axis: the contact, up to first arrest or perforation",
        Window::Whole => "time axis: the whole response",
    });
}

fn difference(app: &mut App) {
    let Some(letter) = app.reference_pin().map(|pin| pin.letter) else {
        return app.refuse("no pinned run to compare with: <mark> pins the current one");
    };
    app.charts.difference = !app.charts.difference;
    let text = if app.charts.difference {
        format!("curves are differences to {letter}: <difference> shows the values again")
    } else {
        "curves are values again".to_owned()
    };
    app.tell(text);
}
