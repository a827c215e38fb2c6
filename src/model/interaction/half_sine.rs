//! The linearised force history of Abatan and Hu, thesis equations 8.5 to 8.9: `F = m_p v pi/(2 t_d) sin(pi t/t_d)`.
//!
//! The history is prescribed: it is that of a fixed plate, on which it just stops the projectile, and its impulse is the
//! projectile's whole momentum. Here it acts on both bodies for all of `t_d`, whatever the plate does meanwhile; then they
//! are one, with the momentum they have. So the initial-velocity model is its limit for `t_d` to 0. Depth is the greatest
//! relative travel that follows: at the first common velocity, or at a later one where a spring throws the plate back.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::model::estimate::{self, ROUNDING};
use crate::model::interaction::course::{Course, Fired, Tag, say};
use crate::model::interaction::pair::{N, Push, V, W};
use crate::model::interaction::{ModelNote, Values, notes_of};
use crate::model::run::{EndReason, EstimateBasis, EventKind, Mode, Outcome, Run};
use crate::model::run::{Observer, Settings};
use crate::model::scene::Scene;
use crate::numerics::explicit::Boundary;

/// Tolerance of the second computation per tolerance of the first.
const TIGHTER: f64 = 1e-2;
/// A projectile that arrives at common velocity within this part of the end of the history has not been overrun.
const AT_THE_END: f64 = 1e-3;

/// Run it.
pub(super) fn run(scene: &Arc<Scene>, settings: Settings, observer: Observer<'_>) -> Run {
    let mut run = once(scene, settings.series, 1.0, observer);
    if settings.estimate && run.end.is_complete() {
        let second = once(scene, false, TIGHTER, observer);
        estimate::set(&mut run, &second, EstimateBasis::SecondComputation, ROUNDING);
    }
    run
}

fn once(scene: &Arc<Scene>, series: bool, tighter: f64, observer: Observer<'_>) -> Run {
    let mut course = Course::new(scene, series, tighter);
    let duration_s = Values::of(scene).duration_s;
    let duration = duration_s / course.units.time_s;
    course.pair.push = Push::Pulse { amplitude: 0.5 * PI / duration, duration };
    course.point();
    let horizon = course.horizon(duration);
    let pulse_end = if horizon < duration { horizon } else { duration };
    let mut end = pulse(&mut course, pulse_end, observer);
    // The peak is known exactly; the points to draw may miss it.
    course.peak_n = peak_n(&course, pulse_end);
    let (mut outcome, mut farthest) = (Outcome::Moving, None);
    if end.is_none() && pulse_end < duration {
        end = Some(EndReason::Horizon);
    }
    if end.is_none() {
        if course.first_arrest.is_none() {
            course.note_arrest();
        } else {
            course.event(EventKind::Arrest);
        }
        course.join();
        course.point();
        outcome = Outcome::Arrested;
        let (reached, reason) = course.coast(horizon, observer);
        (farthest, end) = (reached, Some(reason));
    }
    let depth_m = course.geometry.depth_m(course.deepest_m);
    let arrest_s = course.first_arrest.map(|arrest| arrest.t_s);
    let mut run = course.into_run(outcome, end.unwrap_or(EndReason::Decided));
    run.final_penetration_m = (outcome == Outcome::Arrested).then_some(depth_m);
    run.max_plate_displacement_m = farthest;
    let mut notes = notes_of(scene, run.final_penetration_m);
    if let Some(t_s) = arrest_s.filter(|t_s| *t_s < duration_s * (1.0 - AT_THE_END)) {
        notes.push(ModelNote::Overruns { t_s, duration_s });
    }
    say(&mut run, notes);
    run
}

/// Through the history; `Some` when that ended early.
fn pulse(course: &mut Course<'_>, until: f64, observer: Observer<'_>) -> Option<EndReason> {
    let mut common = Boundary { offset: 0.0, slope: [0.0; N] };
    common.slope[V] = 1.0;
    common.slope[W] = -course.pair.cos;
    loop {
        let own = [(Tag::Arrest, common)];
        // Of a plate that stays still it is at the end of the history, and quadratic there: known better than it can be located.
        let watched = if course.pair.is_still() { &[] } else { &own[..] };
        match course.advance(until, watched, observer) {
            Fired::Early(reason) => return Some(reason),
            Fired::Until => return None,
            Fired::Tag(Tag::Arrest) => {
                course.note_arrest();
                course.mode = Mode::Withdrawing;
            }
            Fired::Tag(_) => {}
        }
    }
}

fn peak_n(course: &Course<'_>, until: f64) -> f64 {
    let Push::Pulse { amplitude, duration } = course.pair.push else { return course.peak_n };
    let top = if until < 0.5 * duration { (PI * until / duration).sin() } else { 1.0 };
    amplitude * top * course.units.force_n
}
