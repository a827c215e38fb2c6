//! The content of the charts: quantities, the times shown, the crosshair, and the points of every curve. No drawing.

pub(crate) mod draw;

use std::ops::Range;

use crate::model::run::Run;
use crate::numerics::{larger, smaller};
use crate::report::figures::run::contact_window_s;
use crate::report::series::{Channel, thinned};
use crate::tui::app::pins::RunView;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::runs;
use crate::tui::pages::run::state::Window;
use crate::tui::widgets::along;

/// The points of one run, SI.
#[derive(Clone, Debug)]
pub struct Curve<'a> {
    pub view: RunView<'a>,
    /// Time, s, and value; a gap where the value is not a number.
    pub points: Vec<(f64, f64)>,
}

/// How far a press moves the crosshair, as a share of the range in view.
const STEP: f64 = 0.01;

/// A plate is as good as held that moves less than this part of the depth.
const HELD: f64 = 1e-3;

/// Whether the plate of a run does not move, or so little that nobody sees it beside the depth.
pub(crate) fn is_held(run: &Run) -> bool {
    let farthest = run.max_plate_displacement_m.map(f64::abs);
    let starts_at_zero = run.scene.start_m() == 0.0;
    let share = farthest.zip(run.final_penetration_m).map(|(farthest, depth)| farthest / depth);
    starts_at_zero && share.is_some_and(|share| share < HELD)
}

/// The end of what the whole response shows, s: a plate that nothing stops is followed for two contact times.
fn whole_s(run: &Run) -> f64 {
    let end_s = run.series.last().map_or(0.0, |sample| sample.t_s);
    if is_free(run) { larger(end_s, 2.0 * run.contact_end_s()) } else { end_s }
}

/// Whether nothing ever stops the plate.
pub(crate) fn is_free(run: &Run) -> bool {
    let is_known = run.end.is_complete() && run.at_least.plate_displacement_m.is_none();
    is_known && run.max_plate_displacement_m.is_none()
}

impl App {
    /// The time range that a chart shows, s.
    pub fn time_range_s(&self, chart: usize) -> (f64, f64) {
        let of = |run: &Run| match self.pages.run.charts.windows[chart] {
            Window::Contact => contact_window_s(run),
            Window::Whole => whole_s(run),
        };
        let runs = self.visible_runs().into_iter().map(|view| of(view.run));
        let end = runs.filter(|end| end.is_finite() && *end > 0.0).fold(0.0, larger);
        (0.0, if end > 0.0 { end } else { 1e-3 })
    }

    /// The curves of a chart.
    pub fn curves(&self, chart: usize) -> Vec<Curve<'_>> {
        let runs = self.visible_runs().into_iter();
        runs.map(|view| self.curve(view, chart)).collect()
    }

    /// The points of a run that are in view, and one on either side of it.
    fn curve<'a>(&self, view: RunView<'a>, chart: usize) -> Curve<'a> {
        let (run, quantity) = (view.run, self.pages.run.charts.quantities[chart]);
        let over_time = quantity.is_over_time();
        // Over the displacement the whole way is drawn.
        let range = self.time_range_s(chart);
        let seen = if over_time { Self::samples_seen(run, range) } else { 0..run.series.len() };
        let samples = &run.series[seen];
        let mut points = quantity.points(run, samples);
        if quantity == Channel::ContactForce && is_held(run) {
            // After the arrest it is that of a vibration which nobody sees.
            points.retain(|point| point.0 <= run.contact_end_s());
        }
        if quantity == Channel::PlateDisplacement && is_free(run) {
            points.extend(run.series.last().map(|last| {
                let t_s = whole_s(run);
                (t_s, last.plate_displacement_m + last.plate_velocity_m_s * (t_s - last.t_s))
            }));
        }
        if over_time {
            points = thinned(points);
        }
        Curve { view, points }
    }

    fn samples_seen(run: &Run, (from, to): (f64, f64)) -> Range<usize> {
        let before = run.series.partition_point(|sample| sample.t_s < from);
        let within = run.series.partition_point(|sample| sample.t_s <= to);
        before.saturating_sub(1)..run.series.len().min(within + 1)
    }

    /// The range of values to show, over the curves; a little room is left to the chart itself.
    pub fn value_range(&self, curves: &[Curve<'_>], chart: usize) -> (f64, f64) {
        let (from, to) = self.time_range_s(chart);
        let seen = |t: f64| (from..=to).contains(&t);
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
            .filter(|(t, value)| seen(*t) && value.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (_, value)| {
                (smaller(low, value), larger(high, value))
            });
        match (low < high, low.is_finite()) {
            (true, _) => (low, high),
            (false, true) if low != 0.0 => (low - 0.1 * low.abs(), high + 0.1 * high.abs()),
            (false, _) => (0.0, 1.0),
        }
    }

    /// Move the crosshair by hundredths of the range in view; it starts in the middle.
    pub fn move_cursor(&mut self, by: i16) {
        let (from, to) = self.time_range_s(self.pages.run.charts.selected);
        let middle = f64::midpoint(from, to);
        let moved = |here: f64| (here + f64::from(by) * STEP * (to - from)).clamp(from, to);
        self.pages.run.charts.cursor_s = Some(self.pages.run.charts.cursor_s.map_or(middle, moved));
    }
}

/// Do what a key means.
pub(crate) fn act(app: &mut App, action: Action) -> bool {
    use Action as A;
    let selected = app.pages.run.charts.selected;
    match action {
        A::Mark => runs::pin_scene(app),
        A::Window => window(app),
        A::View => {
            let mut next = app.pages.run.charts.quantities[selected].next();
            while app.pages.run.charts.quantities.contains(&next) {
                next = next.next();
            }
            app.pages.run.charts.quantities[selected] = next;
        }
        _ => match along(action, 10) {
            Some(by) => app.move_cursor(by),
            None => return false,
        },
    }
    true
}

/// The selected chart shows the other part of the time.
fn window(app: &mut App) {
    let charts = &mut app.pages.run.charts;
    let (window, name) =
        (&mut charts.windows[charts.selected], charts.quantities[charts.selected].title());
    let (next, words) = match window {
        Window::Contact => (Window::Whole, "the whole response"),
        Window::Whole => (Window::Contact, "the contact, up to the last change of the depth"),
    };
    *window = next;
    app.tell(format!("{name}: {words}"));
}
