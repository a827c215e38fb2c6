//! Wu's lumped parameters, thesis Figures 8.4 to 8.8: a spring with hysteresis and a damper between projectile and plate.
//!
//! The interface is pressed in along `k_load`, gives back along the steeper `k_unload`, and keeps a dent of
//! `delta_max (1 - k_load/k_unload)`, from which it is pressed again along `k_unload` up to where it was. It only pushes.
//! The dent is the depth; the model knows no rear face.

use std::sync::Arc;

use crate::model::estimate;
use crate::model::interaction::course::{Course, Fired, Tag, say};
use crate::model::interaction::pair::{N, Push, Q, V, W, X};
use crate::model::interaction::{Values, notes_of};
use crate::model::run::{EndReason, EstimateBasis, EventKind, Mode, Outcome, Run};
use crate::model::run::{Observer, Settings};
use crate::model::scene::Scene;
use crate::numerics::explicit::{Boundary, System as _};

/// Tolerance of the second computation per tolerance of the first.
const TIGHTER: f64 = 1e-2;
/// Part of the time up to the next touch that the first step in free flight takes.
const WITHIN: f64 = 0.25;
/// Part of forces, or depths, by which they differ although they are meant to be equal.
const ROUNDING: f64 = 1e-12;
/// With less than this part of the energy left, everything is at rest.
const AT_REST: f64 = 1e-9;

/// The interface, in the course's units.
struct Interface {
    load: f64,
    unload: f64,
    damping: f64,
    /// Greatest compression so far.
    deepest: f64,
}

/// Run it.
pub(super) fn run(scene: &Arc<Scene>, settings: Settings, observer: Observer<'_>) -> Run {
    let mut run = once(scene, settings.series, 1.0, observer);
    if settings.estimate && run.end.is_complete() {
        let second = once(scene, false, TIGHTER, observer);
        estimate::set(&mut run, &second, EstimateBasis::SecondComputation, estimate::ROUNDING);
    }
    run
}

fn once(scene: &Arc<Scene>, series: bool, tighter: f64, observer: Observer<'_>) -> Run {
    let mut course = Course::new(scene, series, tighter);
    let values = Values::of(scene);
    let units = course.units;
    let mut interface = Interface {
        load: units.stiffness(values.load_stiffness_n_m),
        unload: units.stiffness(values.unload_stiffness_n_m),
        damping: units.damping(scene.contact.damping_n_s_m),
        deepest: 0.0,
    };
    course.pair.push =
        Push::Spring { stiffness: interface.load, slack: 0.0, damping: interface.damping };
    course.point();
    let horizon = course.horizon(1.0 / interface.load.sqrt());
    let (outcome, end) = contact(&mut course, &mut interface, horizon, observer);
    if outcome == Outcome::Separated {
        let left = (course.t * units.time_s, course.y[V] * units.speed_m_s);
        let (farthest, end) = course.coast(horizon, observer);
        let mut run = finish(course, &interface, (outcome, end));
        run.separation = Some(left);
        run.max_plate_displacement_m = farthest;
        return run;
    }
    let farthest = (outcome == Outcome::Arrested).then(|| course.farthest_m());
    let mut run = finish(course, &interface, (outcome, end));
    run.max_plate_displacement_m = farthest;
    run
}

fn finish(course: Course<'_>, interface: &Interface, (outcome, end): (Outcome, EndReason)) -> Run {
    let dent_m = interface.slack() * course.units.length_m;
    let depth_m = course.geometry.depth_m(dent_m);
    let known = outcome != Outcome::Moving;
    let scene = course.scene;
    let mut run = course.into_run(outcome, end);
    run.final_penetration_m = known.then_some(depth_m);
    let notes = notes_of(scene, run.final_penetration_m);
    say(&mut run, notes);
    run
}

impl Interface {
    /// The dent: where the interface is slack.
    fn slack(&self) -> f64 {
        self.deepest * (1.0 - self.load / self.unload)
    }

    /// The law on the steeper branch.
    fn elastic(&self) -> Push {
        Push::Spring { stiffness: self.unload, slack: self.slack(), damping: self.damping }
    }
}

impl Interface {
    /// What ends the present mode.
    fn watched(&self, course: &Course<'_>, in_dent: bool) -> Vec<(Tag, Boundary<N>)> {
        let slack = self.slack();
        if course.mode == Mode::Penetrating {
            vec![(Tag::Arrest, plane(course, 0.0, 0.0, 1.0))]
        } else if course.mode == Mode::FreeFlight {
            if in_dent {
                // Spring and damper together would push again.
                let again = plane(course, self.unload * slack, -self.unload, -self.damping);
                vec![(Tag::Touch, again), (Tag::Clear, plane(course, -slack, 1.0, 0.0))]
            } else {
                vec![(Tag::Touch, plane(course, slack, -1.0, 0.0))]
            }
        } else {
            let force = (self.unload, self.damping);
            vec![
                (Tag::Slack, plane(course, -self.unload * slack, force.0, force.1)),
                (Tag::Deepest, plane(course, self.deepest, -1.0, 0.0)),
            ]
        }
    }

    /// What two events at one moment, or a stop, have left to be done: no boundary falls there.
    fn overdue(&self, course: &mut Course<'_>, in_dent: bool) -> Option<Tag> {
        let slip = course.pair.slip(&course.y);
        let rate = course.pair.rate(course.t, &course.y);
        let bend = rate[V] - course.pair.cos * rate[W];
        let depth = course.y[Q] - self.slack();
        let push = self.unload * depth + self.damping * slip;
        let growth = self.unload * slip + self.damping * bend;
        let rounding = ROUNDING * (self.unload * self.deepest + self.damping * slip.abs());
        match course.mode {
            Mode::FreeFlight if in_dent => {
                (push > rounding || push > -rounding && growth > 0.0).then_some(Tag::Touch)
            }
            Mode::FreeFlight => {
                (depth > ROUNDING * self.deepest && slip > 0.0).then_some(Tag::Touch)
            }
            Mode::Withdrawing | Mode::Closing => {
                (push < -rounding || push < rounding && growth < 0.0).then_some(Tag::Slack)
            }
            Mode::Penetrating | Mode::Fused | Mode::Perforated => None,
        }
    }

    /// When the interface is touched again that has just been let go of, if both bodies keep their accelerations. A step as long as
    /// that would see neither the one nor the other.
    fn touches_after(&self, course: &mut Course<'_>, in_dent: bool) -> Option<f64> {
        let slip = course.pair.slip(&course.y);
        let rate = course.pair.rate(course.t, &course.y);
        let bend = rate[V] - course.pair.cos * rate[W];
        let (stiffness, damping) = if in_dent { (self.unload, self.damping) } else { (1.0, 0.0) };
        let after = -2.0 * (stiffness * slip + damping * bend) / (stiffness * bend);
        (bend > 0.0 && after > 0.0).then_some(after)
    }
}

/// A plane in compression and relative velocity.
fn plane(course: &Course<'_>, offset: f64, q: f64, slip: f64) -> Boundary<N> {
    let mut boundary = Boundary { offset, slope: [0.0; N] };
    boundary.slope[Q] = q;
    boundary.slope[V] = slip;
    boundary.slope[W] = -slip * course.pair.cos;
    boundary
}

/// From first contact until the projectile has left for good, everything is at rest, or time is up.
fn contact(
    course: &mut Course<'_>,
    interface: &mut Interface,
    horizon: f64,
    observer: Observer<'_>,
) -> (Outcome, EndReason) {
    // The interface's damper has let go of a projectile that is still in its dent.
    let mut in_dent = false;
    loop {
        let slack = interface.slack();
        let own = interface.watched(course, in_dent);
        let fired = match interface.overdue(course, in_dent) {
            Some(tag) => Fired::Tag(tag),
            None => course.advance(horizon, &own, observer),
        };
        match fired {
            Fired::Early(reason) => return (Outcome::Moving, reason),
            Fired::Until => return (Outcome::Moving, EndReason::Horizon),
            Fired::Tag(Tag::Arrest) => {
                course.note_arrest();
                interface.deepest = course.y[Q];
                course.pair.push = interface.elastic();
                course.mode = Mode::Withdrawing;
            }
            Fired::Tag(Tag::Slack) => {
                course.unload();
                course.mode = Mode::FreeFlight;
                in_dent = interface.damping > 0.0 && course.y[Q] > slack;
                if let Some(back) = interface.touches_after(course, in_dent) {
                    course.step_at_most(WITHIN * back);
                }
                if in_dent {
                    course.step_at_most(WITHIN * interface.damping / interface.unload);
                }
                if gone_for_good(course, slack) {
                    course.event(EventKind::Separation);
                    return (Outcome::Separated, EndReason::Decided);
                }
            }
            Fired::Tag(Tag::Touch) => {
                course.event(EventKind::Recontact);
                course.pair.push = interface.elastic();
                course.mode = Mode::Closing;
            }
            Fired::Tag(Tag::Deepest) => {
                course.event(EventKind::Resumption);
                course.pair.push = Push::Spring {
                    stiffness: interface.load,
                    slack: 0.0,
                    damping: interface.damping,
                };
                course.mode = Mode::Penetrating;
            }
            Fired::Tag(tag) => {
                in_dent = in_dent && tag != Tag::Clear;
                if course.mode == Mode::FreeFlight && gone_for_good(course, slack) {
                    course.event(EventKind::Separation);
                    return (Outcome::Separated, EndReason::Decided);
                }
            }
        }
        let stored = match course.pair.push {
            Push::Spring { stiffness, slack, .. } => {
                let force = stiffness * (course.y[Q] - slack);
                0.5 * force * force / interface.unload
            }
            Push::None | Push::Pulse { .. } => 0.0,
        };
        if course.energy_left() + stored < AT_REST {
            return (Outcome::Arrested, EndReason::Decided);
        }
    }
}

/// Apart, moving apart, and unable to meet again.
fn gone_for_good(course: &Course<'_>, slack: f64) -> bool {
    let (pair, y) = (&course.pair, &course.y);
    let v = y[V];
    if pair.slip(y) >= 0.0 {
        return false;
    }
    let energy = pair.plate_energy(y);
    if pair.is_still() || v < -(2.0 * energy / pair.gamma).sqrt() * pair.cos {
        return true;
    }
    if pair.spring.coefficient == 0.0 && pair.stop.is_none() {
        return pair.damper.coefficient == 0.0 || v <= 0.0;
    }
    // It flies away, and is already beyond the plate's farthest swing back.
    let back = pair.spring.at_integral(energy);
    v < 0.0 && y[Q] + (y[X] + back) * pair.cos < slack
}
