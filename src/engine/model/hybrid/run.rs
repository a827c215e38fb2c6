//! The loop: step, locate, land, react, record.

use std::sync::Arc;

use crate::model::hybrid::equations::{Equations, Setup, State};
use crate::model::hybrid::events::{Events, gap};
use crate::model::hybrid::modes::{self, Contact, Event, Hold, Mode};
use crate::model::hybrid::moving::{Both, Moving, Plate, Projectile};
use crate::model::hybrid::outcome::Farthest;
use crate::model::hybrid::record::Record;
use crate::model::run::{Cost, EndReason, Observer, Outcome, Run};
use crate::model::scene::{Scene, Stop, StopKind};
use crate::numerics::locate::{Found, first_fall};
use crate::numerics::step::{Near, Step, Stepper};
use crate::numerics::{larger, smaller};

/// Evaluations of the equations after which a run ends undecided: about 0.1 s.
const EVALUATIONS_MAX: usize = 400_000;
/// Length of the first step in passages of a tip radius.
const FIRST_STEP: f64 = 0.2;
/// Part of a step that is tried where an event may lie before the first look at it: the looks are a sixteenth of a step apart.
const CLOSER: f64 = 1.0 / 16.0;
/// Part of a step from the end of which its polynomial is followed to an event: over so little it is as good as at the end.
const NEAR_END: f64 = 1e-5;
/// Landing steps that are tried on the way to one event.
const LANDINGS_MAX: usize = 6;
/// Secants to a root, of which each adds more than half as many digits again.
const SECANTS: usize = 8;
/// Part of a passage of the tip radius that is no time.
const NO_TIME: f64 = 1e-15;
/// Part of a gap by which rounding may put a state beyond a second event where it lands on a first.
const AT_ONCE: f64 = 1e-9;
/// Part of the interface's load by which it may grow without being followed.
const DEMAND_GROWTH: f64 = 1e-9;

/// How far a run goes, and how exactly.
#[derive(Clone, Copy, Debug)]
pub(in crate::model) struct Bounds {
    pub(in crate::model) horizon_s: f64,
    /// Go on to the horizon although all is decided.
    pub(in crate::model) to_horizon: bool,
}

/// A run in progress.
struct Progress<'a, M, const S: usize> {
    setup: &'a Setup,
    stepper: &'a M,
    mode: Mode,
    state: State,
    record: Record,
    /// Outcome and greatest displacement, once nothing can change them any more.
    decided: Option<(Outcome, Farthest)>,
    /// The event on which the state is, until a step has left it.
    last: Option<Event>,
    /// Length and acceleration of the step that ends at the state, in the same mode.
    previous: Option<(f64, [[f64; S]; 2])>,
    /// Length of the next step, s.
    h_s: f64,
    horizon_s: f64,
}

/// One impact, stepped through by a method. A run whose work is used up ends early, with what is known.
pub(super) fn run<const S: usize>(
    scene: &Arc<Scene>,
    setup: &Setup,
    stepper: &impl Stepper<S>,
    bounds: Bounds,
    observer: Observer<'_>,
) -> Run {
    let passage_s = setup.geometry.nose.radius_m / setup.velocity_m_s;
    let (mode, state) = modes::first(setup);
    // Without a spring to bring it back a plate is followed to its stop, and until it has left that.
    let waits = !bounds.to_horizon && setup.spring.is_absent() && setup.stop.is_some();
    let mut progress = Progress {
        setup,
        stepper,
        mode,
        state,
        record: Record { farthest_m: setup.start_m, ..Record::default() },
        decided: None,
        last: None,
        previous: None,
        h_s: FIRST_STEP * passage_s,
        horizon_s: if waits { f64::INFINITY } else { bounds.horizon_s },
    };
    progress.first_moment();
    let end = progress.follow(bounds.to_horizon, observer);
    progress.gather(scene, end)
}

impl<M: Stepper<S>, const S: usize> Progress<'_, M, S> {
    fn equations(&self) -> Equations<'_> {
        Equations { setup: self.setup, mode: &self.mode }
    }

    /// A law that is infinitely steep where the plate begins is left by the balance of forces.
    fn first_moment(&mut self) {
        if self.setup.starts_steep() && self.mode.hold == Hold::Free {
            self.state = self.equations().after_first_moment();
            self.h_s = self.state.t_s;
        }
    }

    fn follow(&mut self, to_horizon: bool, observer: Observer<'_>) -> EndReason {
        let mut to_horizon = to_horizon;
        loop {
            let at_horizon = self.state.t_s >= self.horizon_s * (1.0 - 4.0 * f64::EPSILON);
            self.decided = self.decided.or_else(|| self.decide());
            let is_decided = self.decided.is_some();
            let is_enough = is_decided && (at_horizon || !to_horizon);
            if is_enough && !self.demand_may_grow(to_horizon) {
                return EndReason::Decided;
            }
            if at_horizon {
                // Only what an elastic stop throws back may load the interface more after the horizon.
                if !(is_decided && to_horizon && self.is_thrown_back()) {
                    return if is_decided { EndReason::Decided } else { EndReason::Horizon };
                }
                self.horizon_s *= 2.0;
                to_horizon = false;
            }
            if observer(self.state.t_s).is_break() {
                return EndReason::Cancelled;
            }
            if self.record.evaluations + S * self.record.events > EVALUATIONS_MAX {
                return EndReason::StepBudget;
            }
            if let Some(event) = self.missed() {
                self.react(event, self.state);
            } else if let Some(end) = self.advance() {
                return end;
            }
        }
    }

    /// An event that rounding, or another event, has put behind the state.
    fn missed(&self) -> Option<Event> {
        let equations = self.equations();
        let events = Events::of(self.setup, &self.mode);
        let is_behind = |event: &Event| gap(&equations, *event, &self.state) < 0.0;
        events.list().iter().copied().find(|event| is_behind(event) && !self.is_undone_by(*event))
    }

    /// Whether an event undoes the one on which the state is: its gap is zero but for rounding.
    fn is_undone_by(&self, event: Event) -> bool {
        self.last.is_some_and(|last| last.is_undone_by(event))
    }

    /// Takes an event at a state on it.
    fn react(&mut self, event: Event, on_it: State) {
        let mut state = on_it;
        let mut next = modes::after(self.setup, &self.mode, event, &mut state);
        if event != Event::StopRelease {
            modes::face(self.setup, &mut next, &state);
        }
        (self.last, self.previous) = (Some(event), None);
        self.record.event(event, &Equations { setup: self.setup, mode: &self.mode }, &next, &state);
        (self.mode, self.state) = (next, state);
        if let Some(travel_m) = self.last_slips_m() {
            modes::take_slips(self.setup, &mut self.mode, &mut self.state, travel_m);
        }
    }

    /// One step by the law of whatever moves.
    fn advance(&mut self) -> Option<EndReason> {
        let mode = self.mode.clone();
        let equations = Equations { setup: self.setup, mode: &mode };
        match (mode.hold, mode.contact) {
            (Hold::Free, Contact::Joined | Contact::Gone) => self.advance_by(&Plate(equations)),
            (Hold::Free, _) => self.advance_by(&Both(equations)),
            (_, Contact::Joined | Contact::Gone) => self.rest(),
            (_, _) => self.advance_by(&Projectile(equations)),
        }
    }

    /// Nothing moves any more: the time goes on to the horizon.
    fn rest(&mut self) -> Option<EndReason> {
        self.state.t_s = self.horizon_s;
        None
    }

    fn advance_by<const D: usize>(&mut self, law: &impl Moving<D>) -> Option<EndReason> {
        let equations = law.equations();
        let events = Events::of(self.setup, equations.mode);
        let h_s = smaller(self.h_s, self.horizon_s - self.state.t_s);
        let no_time_s = NO_TIME * self.setup.geometry.nose.radius_m / self.setup.velocity_m_s;
        if h_s < NO_TIME * no_time_s {
            return Some(EndReason::StepUnderflow);
        }
        let near = self.previous.map(|(before_s, acceleration)| Near {
            acceleration: std::array::from_fn(|d| acceleration[d]),
            from: 1.0,
            over: h_s / before_s,
        });
        let start = self.state;
        let evaluations = &mut self.record.evaluations;
        let (step, next_s) = match self.stepper.step(law, law.point(&start), h_s, near, evaluations)
        {
            Ok(taken) => taken,
            Err(shorter_s) => {
                self.h_s = shorter_s;
                return None;
            }
        };
        let found = first_fall(events.list().len(), |theta, gaps| {
            let state = law.state(&start, start.t_s + theta * h_s, &step.at(theta));
            for (value, event) in gaps.iter_mut().zip(events.list()) {
                let is_zero = theta == 0.0 && self.is_undone_by(*event);
                *value = if is_zero { 0.0 } else { gap(equations, *event, &state) };
            }
        });
        match found {
            Found::Nothing => {
                self.record.step(equations, |theta| {
                    law.state(&start, start.t_s + theta * h_s, &step.at(theta))
                });
                self.state = law.state(&start, start.t_s + h_s, &step.end);
                self.last = None;
                let mut acceleration = [[0.0; S]; 2];
                acceleration[..D].copy_from_slice(&step.acceleration);
                self.previous = Some((h_s, acceleration));
                self.h_s = next_s;
            }
            Found::Unresolved(which) if h_s < no_time_s => self.react(events.list()[which], start),
            Found::Unresolved(_) => self.h_s = CLOSER * h_s,
            Found::Fall(which, _) if !self.stepper.locates() => {
                self.react(events.list()[which], law.state(&start, start.t_s + h_s, &step.end));
            }
            Found::Fall(which, theta) => {
                let whole_s = self.h_s;
                match self.land(law, &events, (which, theta * h_s), &step) {
                    Ok(state) => {
                        self.react(events.list()[which], state);
                        self.h_s = whole_s;
                    }
                    Err(shorter_s) => self.h_s = shorter_s,
                }
            }
        }
        None
    }

    /// The state on an event near the end of a step of about this length, by a step that ends there, guessed from the `near` one that
    /// goes on beyond; or how long a step to try, where that does not succeed or another event comes first.
    fn land<const D: usize>(
        &mut self,
        law: &impl Moving<D>,
        events: &Events,
        (which, about_s): (usize, f64),
        near: &Step<D, S>,
    ) -> Result<State, f64> {
        let (equations, start) = (law.equations(), self.state);
        let event = events.list()[which];
        let mut h_s = about_s;
        for _ in 0..LANDINGS_MAX {
            let near = Near { acceleration: near.acceleration, from: 0.0, over: h_s / near.h };
            let evaluations = &mut self.record.evaluations;
            let (step, _) =
                self.stepper.step(law, law.point(&start), h_s, Some(near), evaluations)?;
            let at = |theta: f64| law.state(&start, start.t_s + theta * h_s, &step.at(theta));
            let theta = near_root(|theta| gap(equations, event, &at(theta)));
            if (theta - 1.0).abs() > NEAR_END {
                let next = if theta > 0.1 && theta < 2.0 { theta } else { 0.5 };
                h_s *= next;
                continue;
            }
            let state = at(theta);
            let comes_first = events.list().iter().filter(|other| **other != event).any(|other| {
                let (before, now) =
                    (gap(equations, *other, &start), gap(equations, *other, &state));
                before > 0.0 && now < -AT_ONCE * before
            });
            if comes_first {
                return Err(0.5 * h_s);
            }
            self.record.step(equations, |part| at(part * theta));
            return Ok(state);
        }
        Err(0.5 * h_s)
    }

    /// The outcome and the greatest displacement, once nothing can change them any more.
    fn decide(&self) -> Option<(Outcome, Farthest)> {
        let equations = self.equations();
        let outcome = equations.outcome(&self.state)?;
        let farthest = equations.farthest(&self.state, self.record.farthest_m);
        (farthest != Farthest::Pending).then_some((outcome, farthest))
    }

    /// The travel of all slips to come, where they are so small that energy alone gives it.
    fn last_slips_m(&self) -> Option<f64> {
        let equations = self.equations();
        let far_m = equations.reach_m(&self.state, equations.energy_j(&self.state));
        let is_past = self.state.w_m_s < 0.0 && far_m <= self.record.farthest_m;
        is_past.then(|| equations.last_slips_m(&self.state)).flatten()
    }

    /// Whether the joined interface may still have to carry more than it has, on the plate's first way forward; behind an elastic
    /// stop, which throws it back, on the second as well.
    fn demand_may_grow(&mut self, only_to_horizon: bool) -> bool {
        let equations = Equations { setup: self.setup, mode: &self.mode };
        let ways = if self.is_thrown_back() { 2 } else { 1 };
        if self.mode.contact != Contact::Joined
            || equations.plate_rests()
            || self.record.swings >= ways
        {
            return false;
        }
        let strength_n = equations.strength_n(&self.state);
        let known_n = self.record.demand_ratio.unwrap_or(0.0) * strength_n;
        let most_n = equations.push_at_most_n(&self.state, equations.energy_j(&self.state));
        if most_n <= known_n * (1.0 + DEMAND_GROWTH) {
            return false;
        }
        // Nothing takes any of the energy on the way to where the spring pushes most.
        if self.setup.damper.is_absent() && self.setup.stop.is_none() && !only_to_horizon {
            self.record.carried(&equations, &self.state, most_n);
            return false;
        }
        true
    }

    /// Whether an elastic stop may throw the plate back and load an interface that cannot yield more than before.
    fn is_thrown_back(&self) -> bool {
        let is_elastic = |stop: Stop| stop.kind == StopKind::Elastic;
        !self.setup.plastic && self.setup.stop.is_some_and(is_elastic)
    }

    fn gather(self, scene: &Arc<Scene>, end: EndReason) -> Run {
        let equations = self.equations();
        let outcome = self.decided.map_or_else(
            || equations.outcome(&self.state).unwrap_or(Outcome::Moving),
            |(outcome, _)| outcome,
        );
        let (geometry, record) = (&self.setup.geometry, &self.record);
        let deepest_m = match self.mode.contact {
            Contact::Deepening => larger(self.state.q_m, self.mode.deepest_m),
            _ => self.mode.deepest_m,
        };
        let max_plate_displacement_m = match self.decided.map(|(_, farthest)| farthest) {
            Some(Farthest::Known(x_m)) => Some(larger(x_m, record.farthest_m)),
            Some(Farthest::Unbounded) => None,
            // Of an undecided run as far as there is no energy to go farther.
            Some(Farthest::Pending) | None => {
                let left_j = equations.energy_left_j(&self.state);
                let reach_m = equations.reach_m(&self.state, left_j);
                let is_farthest = reach_m <= record.farthest_m * (1.0 + AT_ONCE);
                is_farthest.then_some(record.farthest_m)
            }
        };
        Run {
            scene: Arc::clone(scene),
            outcome,
            end,
            first_arrest: record.first_arrest,
            final_penetration_m: Some(match outcome {
                Outcome::Perforated => geometry.depth_m(geometry.exit_m),
                _ => geometry.depth_m(deepest_m),
            }),
            peak_contact_force_n: Some(record.peak_contact_n),
            max_plate_displacement_m,
            residual_velocity_m_s: record.exit.map(|exit| exit.velocity_m_s),
            exit_time_s: record.exit.map(|exit| exit.t_s),
            separation: record.separation.filter(|_| outcome == Outcome::Separated),
            interface_demand_ratio: record.demand_ratio,
            cost: Cost {
                steps: record.steps,
                events: record.events,
                rhs_evaluations: record.evaluations,
                method: "Radau IIA collocation",
                ..Cost::default()
            },
            ..Run::default()
        }
    }
}

/// The root of a function near 1, by secants; far from it where there is none close by.
fn near_root(f: impl Fn(f64) -> f64) -> f64 {
    let (mut a, mut b) = (1.0 - 1e-3, 1.0);
    let (mut at_a, mut at_b) = (f(a), f(b));
    for _ in 0..SECANTS {
        let change = at_b - at_a;
        // Where both are the same there is nothing but rounding left.
        if at_b == 0.0 || change == 0.0 {
            break;
        }
        let next = b - at_b * (b - a) / change;
        if !(0.0..2.0).contains(&next) {
            return 0.0;
        }
        (a, at_a) = (b, at_b);
        (b, at_b) = (next, f(next));
        if (b - a).abs() < f64::EPSILON {
            break;
        }
    }
    b
}
