//! Integration loop of a hybrid system.
//!
//! Each pass computes a step, locates the first event on its dense output, repeats the step so that it ends at the event, applies the
//! transition to the next mode, and records the results.

use std::sync::Arc;

use crate::model::impact::dense_output::DenseOutput;
use crate::model::impact::equations::Equations;
use crate::model::impact::events::{self, event_function};
use crate::model::impact::fused_swing::FusedSwing;
use crate::model::impact::loads::Loads;
use crate::model::impact::modes::{Event, PlateConstraint};
use crate::model::impact::parameters::ImpactParameters;
use crate::model::impact::recorder::Recorder;
use crate::model::impact::reduced_system::ReducedSystem;
use crate::model::impact::resolution::{CHANGES_MANY, RESOLUTION, TOLERANCE_RATIO};
use crate::model::impact::results::{self, ImpactRun};
use crate::model::impact::rule::Rule;
use crate::model::impact::state::State;
use crate::model::impact::transitions;
use crate::model::impact::zero_passage::ZeroPassage;
use crate::model::run::{Cost, EndReason, Observer, Run, RunSnapshot, Settings};
use crate::model::scene::Scene;
use crate::numerics::event_location::{CELLS, EventSearch, first_crossing};
use crate::numerics::step::{StagePredictor, Step, Stepper};
use crate::numerics::{larger, smaller};

/// Size of the first step, relative to `R / v_i`.
const FIRST_STEP: f64 = 0.5;
/// Distance from the end of a step, relative to its size, within which an event is taken from the dense output. The error of the dense
/// output there is that of the end.
const NEAR_END: f64 = 1e-5;
/// Maximum number of iterations to an event: of steps that are tried to end at it, and of the secant method for the size of such a step,
/// whose order of convergence is 1.6.
const LANDINGS_MAX: usize = 8;
/// Maximum number of steps after the results are known, for the peak loads and for the time series. A strongly damped plate may not reverse,
/// and a stiff mount can oscillate a million times meanwhile.
const STEPS_FOLLOWED: usize = 200;

/// State of a run in progress.
struct IntegrationLoop<'a, M, const S: usize> {
    course: ImpactRun<'a>,
    stepper: &'a M,
    /// Event at the present state, until a step has left it.
    last: Option<Event>,
    /// Size and acceleration of the previous step, if no force has jumped since.
    previous: Option<(f64, [[f64; S]; 2])>,
    /// Size of the next step, s.
    h_s: f64,
    /// Work after which the run ends undecided.
    work_max: usize,
}

/// Integrates one impact by a method. A run that exhausts its evaluation budget ends early with partial results.
pub(super) fn run<const S: usize>(
    scene: &Arc<Scene>,
    setup: &ImpactParameters,
    stepper: &impl Stepper<S>,
    settings: Settings,
    observer: Observer<'_>,
) -> Run {
    // Without a hole ahead of it, a plug comprises the whole thickness.
    let setup = setup.at(0.0);
    let (mode, state) = transitions::first(setup);
    let horizon_s = scene.run.horizon_s.unwrap_or(f64::INFINITY);
    let Settings { series: keep_series, every_s, .. } = settings;
    let record = Recorder { keep_series, every_s, ..Recorder::default() };
    let mut progress = IntegrationLoop {
        course: ImpactRun {
            scene,
            setup,
            mode,
            state,
            record,
            outcome: None,
            decided: None,
            deepens_m: 0.0,
            horizon_s,
        },
        stepper,
        last: None,
        previous: None,
        h_s: FIRST_STEP * setup.passage_s(),
        work_max: settings.most_work(scene.run.tolerance),
    };
    progress.begin();
    let mut end = progress.run_until_decided(observer);
    let mut course = progress.course.clone();
    if end == EndReason::Decided {
        end = progress.extend_for_output(observer);
    }
    // The results are those at the decision; rows, events and loads include the continued run.
    let Recorder { series, events, loads, turn, .. } = progress.course.record;
    (course.record.series, course.record.events, course.record.loads) = (series, events, loads);
    course.record.turn = turn;
    results::gather(course, end)
}

impl<M: Stepper<S>, const S: usize> IntegrationLoop<'_, M, S> {
    fn begin(&mut self) {
        let ImpactRun { setup, mode, state, record, .. } = &mut self.course;
        record.begin(&Equations { setup, mode }, state);
        // The start from a singular zero is analytic.
        if setup.starts_steep() && mode.hold == PlateConstraint::Free {
            let (after, works_j) = Equations { setup, mode }.after_first_moment();
            *state = after;
            self.h_s = state.t_s;
            record.first_moment(setup, works_j);
        } else if setup.is_second() && (Equations { setup, mode }).starts_at_singularity() {
            // The error of this step depends on its size more than on the number of stages.
            self.h_s *= TOLERANCE_RATIO;
        }
        if setup.starts_on_stop() && state.w_m_s > 0.0 {
            self.apply_transition(Event::StopReached, self.course.state);
        }
    }

    fn is_at(&self, t_s: f64) -> bool {
        self.course.state.t_s >= t_s * (1.0 - 4.0 * f64::EPSILON)
    }

    /// Integrates until outcome and displacement are final, or up to the horizon.
    fn run_until_decided(&mut self, observer: Observer<'_>) -> EndReason {
        loop {
            self.course.decide();
            let is_decided = self.course.decided.is_some();
            let horizon_s = self.course.horizon_s;
            if self.is_at(horizon_s) || is_decided && horizon_s.is_infinite() {
                return if is_decided { EndReason::Decided } else { EndReason::Horizon };
            }
            if let Some(end) = self.advance_once(observer) {
                return end;
            }
        }
    }

    /// Advances by one step or one event.
    fn advance_once(&mut self, observer: Observer<'_>) -> Option<EndReason> {
        let missed = self.pending_event();
        let so_far = || Some(results::gather(self.course.clone(), EndReason::Cancelled));
        let look = RunSnapshot { t_s: self.course.state.t_s, so_far: &so_far };
        // The row of an event replaces that of the state before.
        if missed.is_none() && observer(&look).is_break() {
            return Some(EndReason::Cancelled);
        }
        let record = &self.course.record;
        let Cost { events, turns, .. } = record.cost;
        // The first contact always ends, regardless of the number of reversals.
        let is_over = record.first_arrest.is_some() || record.exit.is_some();
        if record.cost.work() > self.work_max {
            let oscillates =
                is_over && self.course.has_no_horizon() && turns + events > CHANGES_MANY;
            return Some(if oscillates { EndReason::Oscillates } else { EndReason::StepBudget });
        }
        if let Some(event) = missed {
            self.apply_transition(event, self.course.state);
            return None;
        }
        let ImpactRun { ref state, horizon_s, .. } = self.course;
        let equations = self.course.equations();
        if let Some(swing) = equations.fused_swing(state, horizon_s) {
            self.advance_by_swing(&swing);
        } else if let Some(passage) = equations.zero_passage(state, horizon_s) {
            self.advance_by_passage(&passage);
        } else {
            return self.advance();
        }
        None
    }

    /// Advances beyond the zero of the spring.
    fn advance_by_passage(&mut self, passage: &ZeroPassage) {
        let ImpactRun { setup, ref mut mode, ref mut state, ref mut record, .. } = self.course;
        record.passage(&Equations { setup, mode }, passage);
        (*state, self.last, self.previous) = (passage.to, None, None);
        mode.stretch = mode.spring.stretch(mode.origin_m + state.x_m);
        if let Some(event) = passage.event {
            self.apply_transition(event, passage.to);
        } else {
            // Until as far again from the zero.
            self.h_s = (mode.origin_m + state.x_m) / state.w_m_s;
        }
    }

    /// Advances to the end of a swing of fused bodies.
    fn advance_by_swing(&mut self, swing: &FusedSwing) {
        let ImpactRun { setup, ref mode, ref mut state, ref mut record, horizon_s, .. } =
            self.course;
        let mut to = swing.end();
        if swing.event.is_none() {
            to.t_s = horizon_s;
        }
        record.swing(&Equations { setup, mode }, [state, &to], swing);
        (*state, self.last, self.previous) = (to, None, None);
        if let Some(event) = swing.event {
            self.apply_transition(event, to);
        }
    }

    /// Continues after the results are final: while the peak loads of mount and interface can grow, and for the time series to the end of the
    /// contact and to the maximum displacement.
    fn extend_for_output(&mut self, observer: Observer<'_>) -> EndReason {
        let is_drawn = self.course.record.keep_series && self.course.has_no_horizon();
        let steps = self.course.record.cost.steps;
        self.work_max = self.work_max.saturating_add(self.course.record.cost.work());
        self.course.horizon_s = f64::INFINITY;
        let mut loads: Option<Loads> = None;
        let ended = loop {
            let is_followed = self.course.record.cost.steps - steps < STEPS_FOLLOWED;
            if loads.is_none() && !(is_followed && self.course.loads_may_grow()) {
                loads = Some(self.course.record.loads);
            }
            let draws = is_drawn && is_followed && self.course.is_drawn();
            if (loads.is_some() && !draws) || self.is_at(self.course.horizon_s) {
                break None;
            }
            if !draws {
                let record = &mut self.course.record;
                (record.keep_series, record.is_over) = (false, true);
            }
            if loads.is_some() && !self.course.is_before_max_displacement() {
                self.course.horizon_s = self.course.tail_s();
            }
            let ended = self.advance_once(observer);
            if ended.is_some() {
                break ended;
            }
        };
        if let Some(known) = loads {
            self.course.record.loads = known;
        }
        ended.filter(|end| *end == EndReason::Cancelled).unwrap_or(EndReason::Decided)
    }

    /// Returns an event whose function is already beyond zero, by rounding or because of another event.
    fn pending_event(&mut self) -> Option<Event> {
        let ImpactRun { ref state, ref record, .. } = self.course;
        let locks = self.course.equations().locks_again(state, record.farthest_m);
        if locks && !self.course.follows_short_swing() {
            return Some(Event::SpringHolds);
        }
        let equations = self.course.equations();
        let is_behind =
            |event: &Event| event_function(&equations, *event, &self.course.state) < 0.0;
        let mut events = events::possible_events(self.course.setup, &self.course.mode);
        events.find(|event| is_behind(event) && !self.is_undone_by(*event))
    }

    /// Returns `true` if an event is the reverse of the event at the present state: its function is zero, apart from rounding.
    fn is_undone_by(&self, event: Event) -> bool {
        Rule::Undone.applies() && self.last.is_some_and(|last| last.is_undone_by(event))
    }

    /// Applies the transition of an event at a state.
    fn apply_transition(&mut self, event: Event, on_it: State) {
        let setup = self.course.setup;
        let mut state = on_it;
        let before = self.course.mode.clone();
        let mut next = transitions::after(setup, &before, event, &mut state);
        let setup_after = if event == Event::PieceEnd { setup.at(state.q_m) } else { setup };
        if event != Event::StopRelease {
            transitions::update_direction(setup_after, &mut next, &state);
        }
        (self.last, self.previous) = (Some(event), None);
        let old = Equations { setup, mode: &before };
        let new = Equations { setup: setup_after, mode: &next };
        self.course.record.event(event, (&old, &on_it), (&new, &state));
        let before_j = new.kinetic_j(&state);
        (self.course.mode, self.course.state) = (next, state);
        self.course.setup = setup_after;
        // With a horizon, the slips are simulated in time.
        if !self.course.has_no_horizon() {
            return;
        }
        let ImpactRun { mode, state, record, .. } = &mut self.course;
        let slips_m = Equations { setup, mode }.remaining_slip_m(state, record.farthest_m);
        if let Some(travel_m) = slips_m {
            transitions::apply_remaining_slip(setup, mode, state, travel_m);
            record.work.penetration_j += before_j - Equations { setup, mode }.kinetic_j(state);
        }
    }

    /// Advances the active degrees of freedom by one step.
    fn advance(&mut self) -> Option<EndReason> {
        let mode = self.course.mode.clone();
        let equations = Equations { setup: self.course.setup, mode: &mode };
        let start = self.course.state;
        if equations.is_touching() && !equations.plate_rests() {
            self.advance_by(&ReducedSystem::<2> { equations, start })
        } else {
            self.advance_by(&ReducedSystem::<1> { equations, start })
        }
    }

    fn advance_by<const D: usize>(&mut self, law: &ReducedSystem<'_, D>) -> Option<EndReason> {
        let ReducedSystem { equations, start } = law;
        let events: Vec<_> = events::possible_events(self.course.setup, equations.mode).collect();
        let left_s = self.course.horizon_s - start.t_s;
        let h_s = smaller(self.h_s, smaller(left_s, equations.approach_s(start)));
        // Smaller steps do not change the time.
        let no_time_s = f64::EPSILON * self.course.setup.passage_s();
        if h_s < f64::EPSILON * no_time_s {
            return Some(EndReason::StepUnderflow);
        }
        let near = self.previous.map(|(before_s, acceleration)| StagePredictor {
            acceleration: std::array::from_fn(|d| acceleration[d]),
            from: 1.0,
            over: h_s / before_s,
        });
        let evaluations = &mut self.course.record.cost.rhs_evaluations;
        let taken = self.stepper.step(law, law.point(start), h_s, near, evaluations);
        let (step, next_s) = match taken {
            Ok(taken) => taken,
            Err(shorter_s) => {
                self.course.record.cost.rejected += 1;
                self.h_s = shorter_s;
                return None;
            }
        };
        let at = |fraction: f64| law.state(fraction * h_s, &step.at(fraction));
        let path = DenseOutput::new(&at);
        let of_event = |event: &Event| {
            let mut gaps =
                path.looks.each_ref().map(|state| event_function(equations, *event, state));
            if self.is_undone_by(*event) {
                gaps[0] = 0.0;
            }
            gaps
        };
        let gaps: Vec<_> = events.iter().map(of_event).collect();
        let gap = |at: f64, which: usize| event_function(equations, events[which], &path.at(at));
        match first_crossing(&gaps, Rule::Dips.applies(), gap) {
            EventSearch::Nothing => {
                self.course.record.step(equations, &path);
                self.course.state = law.state(h_s, &step.end);
                self.course.record.reach(equations, &self.course.state);
                self.last = None;
                self.remember(&step);
                self.h_s = next_s;
            }
            EventSearch::Unresolved(which) if h_s < no_time_s => {
                self.apply_transition(events[which], *start);
            }
            // An event can precede the first sampling point.
            EventSearch::Unresolved(_) => self.h_s = h_s / CELLS as f64,
            EventSearch::Fall(which, _) if !self.stepper.locates() => {
                self.apply_transition(events[which], law.state(h_s, &step.end));
            }
            EventSearch::Fall(which, theta) => {
                match self.step_to_event(law, &events, (which, theta * h_s), &step) {
                    Ok((state, landing)) => {
                        self.apply_transition(events[which], state);
                        // A plate that reverses has the same forces before and after, unless its damper jumps there.
                        if events[which] == Event::SpeedZero
                            && self.course.setup.damper.is_smooth_at_zero()
                        {
                            self.remember(&landing);
                        }
                        // Fused or separate bodies have longer time scales than bodies in contact.
                        let is_touching = self.course.equations().is_touching();
                        let most_s =
                            if is_touching { self.course.setup.passage_s() } else { f64::INFINITY };
                        // A minimum step size advances the time past events that rounding repeats.
                        self.h_s = larger(smaller(self.h_s, most_s), no_time_s);
                    }
                    Err(shorter_s) => self.h_s = shorter_s,
                }
            }
        }
        None
    }

    /// Keeps the acceleration of a step, from which that of the next is extrapolated.
    fn remember<const D: usize>(&mut self, step: &Step<D, S>) {
        let mut acceleration = [[0.0; S]; 2];
        acceleration[..D].copy_from_slice(&step.acceleration);
        self.previous = Some((step.h, acceleration));
    }

    /// Repeats a step so that it ends at an event; `near` is the step that contains the event. Returns the state, or the step size to try
    /// if that fails or another event precedes it.
    fn step_to_event<const D: usize>(
        &mut self,
        law: &ReducedSystem<'_, D>,
        events: &[Event],
        (which, about_s): (usize, f64),
        near: &Step<D, S>,
    ) -> Result<(State, Step<D, S>), f64> {
        let ReducedSystem { equations, start } = law;
        let event = events[which];
        let mut h_s = about_s;
        for _ in 0..LANDINGS_MAX {
            let near =
                StagePredictor { acceleration: near.acceleration, from: 0.0, over: h_s / near.h };
            let evaluations = &mut self.course.record.cost.rhs_evaluations;
            let (step, _) =
                self.stepper.step(law, law.point(start), h_s, Some(near), evaluations)?;
            let at = |theta: f64| law.state(theta * h_s, &step.at(theta));
            let theta = near_root(|theta| event_function(equations, event, &at(theta)));
            if (theta - 1.0).abs() > NEAR_END {
                h_s *= if theta > 0.1 && theta < 2.0 { theta } else { 0.5 };
                continue;
            }
            let state = at(theta);
            let comes_first = events.iter().filter(|other| **other != event).any(|other| {
                let (before, now) = (
                    event_function(equations, *other, start),
                    event_function(equations, *other, &state),
                );
                // Rounding can swap two simultaneous events.
                before > 0.0 && now < -RESOLUTION * before
            });
            if comes_first {
                return Err(0.5 * h_s);
            }
            self.course.record.step(equations, &DenseOutput::new(&|fraction| at(fraction * theta)));
            return Ok((state, step));
        }
        Err(0.5 * h_s)
    }
}

/// Returns the root of a function near 1 by the secant method; a value far from 1 if there is none.
///
/// Not [`bracketed_root`](crate::numerics::root::bracketed_root): the event can lie behind the end of the step, so there is no bracket. Not
/// Newton's method: event functions have no derivatives.
fn near_root(f: impl Fn(f64) -> f64) -> f64 {
    let (mut a, mut b) = (1.0 - 1e-3, 1.0);
    let (mut at_a, mut at_b) = (f(a), f(b));
    for _ in 0..LANDINGS_MAX {
        let change = at_b - at_a;
        // Equal values differ only by rounding errors.
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
