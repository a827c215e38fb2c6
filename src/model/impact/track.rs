//! The run itself: stretches of smooth motion between located events.
//!
//! A [`Track`] owns the state and knows in which mode the bodies are. Each stretch is advanced by Taylor steps
//! ([`Track::taylor_step`]) or, where those become too many, by the implicit method (`stiff.rs`); when a guard falls, the
//! state is put exactly on the event and `events.rs` decides what follows.

use std::ops::ControlFlow;

use crate::model::contact::AreaLaw;
use crate::model::impact::Observer;
use crate::model::impact::guard::{Form, Guards, Trigger};
use crate::model::impact::problem::Problem;
use crate::model::impact::record::{Record, Setting};
use crate::model::impact::verdict::Farthest;
use crate::model::mechanism::{PowerKind, PowerLaw, sign};
use crate::model::motion::{Expansion, Motion, State, StopForce};
use crate::model::run::{EndReason, Mode};
use crate::numerics::root::first_fall;
use crate::numerics::series::evaluate_slope;
use crate::numerics::taylor::trusted_step;
use crate::numerics::{larger, smaller};

/// Local tolerance per global tolerance: a run has some tens of steps, whose errors may grow a little.
const LOCAL: f64 = 1e-4;
/// Defect at the end of a step, per local tolerance, above which the step is shortened, and what rounding alone may cause.
const DEFECT: f64 = 100.0;
const DEFECT_ROUNDING: f64 = 1e-12;
/// An expansion of which less than this part of its time unit can be used is made anew with a shorter unit.
const UNIT_FITS: f64 = 0.02;
/// Taylor steps after which a stretch is handed to the implicit method.
const TAYLOR_STEPS_PER_STRETCH: usize = 20_000;
/// Steps of any kind after which a run ends early.
pub(super) const STEPS_MAX: usize = 100_000;
/// Events after which a run ends early.
const EVENTS_MAX: usize = 4_000;
/// Half-width of the neighbourhood of zero in which a singular power law is left out, relative to the greatest value seen.
/// A spring gives on one side of it what it takes on the other; a damper does not, and a plate may creep near zero.
const CLEAR_OF_SPRING: f64 = 1e-6;
const CLEAR_OF_DAMPER: f64 = 1e-9;
/// Part of the plate's energy, or of the other forces, that a law may have where it is left out.
const PASSING: f64 = 1e-3;
/// The neighbourhood takes at least this part of the time reached to cross: the clock has no finer ticks.
const CLOCK: f64 = 1e-13;

/// A run in progress.
pub(super) struct Track<'a> {
    pub(super) problem: &'a Problem,
    pub(super) record: Record,
    pub(super) t_s: f64,
    pub(super) state: State,
    /// Greatest travel so far: the bottom of the hole, m.
    pub(super) deepest_m: f64,
    pub(super) mode: Mode,
    /// The plate rests on its rigid stop.
    pub(super) held: bool,
    /// The mechanism cannot move the plate noticeably: it stays where it is.
    pub(super) immobile: bool,
    /// The elastic stop is in contact.
    pub(super) stop_touches: bool,
    /// The singular spring, or damper, is left out close to its zero.
    pub(super) spring_omitted: bool,
    pub(super) damper_omitted: bool,
    pub(super) side_x: f64,
    pub(super) side_w: f64,
    /// Greatest |x| and |w| seen, m and m/s.
    pub(super) plate_scale_m: f64,
    pub(super) speed_scale_m_s: f64,
    /// Time unit of the next expansion, s.
    pub(super) unit_s: f64,
    pub(super) tolerance: f64,
    /// The implicit method has this stretch.
    pub(super) stiff: bool,
    pub(super) stretch_steps: usize,
    pub(super) steps: usize,
    pub(super) stiff_steps: usize,
    pub(super) rejected: usize,
    pub(super) evaluations: usize,
    pub(super) event_count: usize,
    /// When the outcome was decided, s.
    pub(super) decided_s: Option<f64>,
    pub(super) decided_steps: usize,
    /// Times the interface has given way since the hole last became noticeably deeper.
    pub(super) slips_since_deeper: usize,
    /// Depth of the hole when it last did, as travel, m.
    pub(super) noticed_m: f64,
    /// The greatest displacement, as far as it is known.
    pub(super) farthest: Farthest,
}

impl<'a> Track<'a> {
    /// A run at the moment of first contact.
    pub(super) fn new(problem: &'a Problem, tolerance: f64, keep_series: bool) -> Self {
        let state = State {
            travel_m: 0.0,
            slip_m_s: problem.velocity_m_s,
            plate_m: problem.start_m,
            plate_m_s: 0.0,
        };
        let pull = -problem.mechanism.spring.force(problem.start_m);
        Self {
            problem,
            record: Record { keep_series, farthest_m: problem.start_m, ..Record::default() },
            t_s: 0.0,
            state,
            deepest_m: 0.0,
            mode: Mode::Penetrating,
            held: problem.mechanism.rigid_stop().is_some()
                && problem.start_m >= problem.mechanism.stop_at_m,
            immobile: false,
            stop_touches: problem.mechanism.elastic_stop().is_some()
                && problem.start_m >= problem.mechanism.stop_at_m,
            spring_omitted: false,
            damper_omitted: false,
            side_x: if problem.start_m < 0.0 { -1.0 } else { 1.0 },
            side_w: if pull < 0.0 { -1.0 } else { 1.0 },
            plate_scale_m: problem.start_m.abs(),
            speed_scale_m_s: 0.0,
            unit_s: 0.1 * problem.contact_scale_s(),
            tolerance,
            stiff: false,
            stretch_steps: 0,
            steps: 0,
            stiff_steps: 0,
            rejected: 0,
            evaluations: 0,
            event_count: 0,
            decided_s: None,
            decided_steps: 0,
            slips_since_deeper: 0,
            noticed_m: 0.0,
            farthest: Farthest::Pending,
        }
    }

    /// Run to the end.
    pub(super) fn run<const N: usize>(&mut self, observer: Observer<'_>) -> EndReason {
        loop {
            if let Some(reason) = self.finished() {
                return reason;
            }
            if observer(self.t_s).is_break() {
                return EndReason::Cancelled;
            }
            self.keep_off_singularities();
            if self.stretch_steps > TAYLOR_STEPS_PER_STRETCH {
                self.stiff = true;
            }
            let advanced = if self.stiff { self.stiff_step() } else { self.taylor_step::<N>() };
            match advanced {
                ControlFlow::Break(reason) => return self.end_early(reason),
                ControlFlow::Continue(None) => {}
                ControlFlow::Continue(Some(trigger)) => {
                    self.event_count += usize::from(trigger.changes_course());
                    let before = self.mode;
                    self.handle(trigger);
                    if self.mode != before {
                        self.stiff = false;
                    }
                    // A plate that swings through zero again and again takes many steps without being stiff.
                    if self.mode != before || trigger == Trigger::PlateZero {
                        self.stretch_steps = 0;
                    }
                }
            }
            if self.steps + self.rejected > STEPS_MAX {
                return self.end_early(EndReason::StepBudget);
            }
            if self.event_count > EVENTS_MAX {
                return self.end_early(EndReason::EventBudget);
            }
        }
    }

    /// A run whose outcome is known is complete even when its tail is cut short.
    fn end_early(&self, reason: EndReason) -> EndReason {
        if self.decided_s.is_some() { EndReason::Decided } else { reason }
    }

    /// Whether the plate cannot move: rigid, held by its stop, or as good as immobile.
    pub(super) fn is_still(&self) -> bool {
        self.problem.rigid || self.held || self.immobile
    }

    /// The equations of the present mode.
    pub(super) fn motion(&self) -> Motion {
        let problem = self.problem;
        let mechanism = &problem.mechanism;
        let still = self.is_still();
        let joined = self.mode == Mode::Fused;
        let grip = problem.grip * problem.strength_pa;
        let (strength_pa, drag_kg_m3) = match self.mode {
            Mode::Penetrating => (problem.strength_pa, problem.drag_kg_m3),
            Mode::Closing => (grip, 0.0),
            Mode::Withdrawing => (-grip, 0.0),
            Mode::Fused | Mode::FreeFlight | Mode::Perforated => (0.0, 0.0),
        };
        let keep = |law: PowerLaw, omitted: bool| PowerLaw {
            coefficient: if omitted || still { 0.0 } else { law.coefficient },
            ..law
        };
        let stop = mechanism.elastic_stop().filter(|_| self.stop_touches);
        let plate_kg = if joined { problem.joined_kg } else { problem.plate_kg };
        Motion {
            nose: problem.geometry.nose,
            area: if strength_pa == 0.0 && drag_kg_m3 == 0.0 {
                AreaLaw::None
            } else {
                self.area_law()
            },
            strength_pa,
            drag_kg_m3,
            slip_mobility: problem.slip_mobility(!still),
            plate_mobility: if still { 0.0 } else { 1.0 / plate_kg },
            coupling: if joined { 0.0 } else { problem.cos },
            spring: keep(mechanism.spring, self.spring_omitted),
            damper: keep(mechanism.damper, self.damper_omitted),
            stop: stop.map_or_else(StopForce::default, |stop| StopForce {
                stiffness_n_m: stop.stiffness_n_m,
                damping_n_s_m: stop.damping_n_s_m,
                position_m: mechanism.stop_at_m,
            }),
            side_x: self.side_x,
            side_w: self.side_w,
        }
    }

    /// The area law on the side of the present travel to which the projectile is going.
    fn area_law(&self) -> AreaLaw {
        let (geometry, q) = (&self.problem.geometry, self.state.travel_m);
        if self.mode == Mode::Withdrawing {
            let behind = geometry.pieces().iter().rev().find(|piece| piece.from_m < q);
            return behind.map_or(AreaLaw::None, |piece| piece.law);
        }
        geometry.piece(q).law
    }

    /// What the interface can push at the present travel, N.
    pub(super) fn interface_n(&self) -> f64 {
        self.problem.geometry.area_m2(self.state.travel_m) * self.problem.strength_pa
    }

    /// What samples and records need.
    pub(super) fn setting<'m>(&'m self, motion: &'m Motion) -> Setting<'m> {
        Setting {
            problem: self.problem,
            motion,
            mode: self.mode,
            still: self.is_still(),
            held: self.held,
            interface_n: if self.mode == Mode::Fused { self.interface_n() } else { 0.0 },
        }
    }

    /// Everything that may end the present stretch.
    pub(super) fn guards(&self) -> Guards {
        let mut guards = Guards::none();
        self.watch_slip(&mut guards);
        if !self.problem.rigid && !self.immobile {
            self.watch_plate(&mut guards);
        }
        guards
    }

    fn watch_slip(&self, guards: &mut Guards) {
        let (geometry, q) = (&self.problem.geometry, self.state.travel_m);
        match self.mode {
            Mode::Penetrating | Mode::Closing => {
                let end = geometry.piece(q).to_m;
                guards.watch(
                    Trigger::PieceEnd,
                    Form { offset: end, travel: -1.0, ..Form::default() },
                );
                guards.watch(Trigger::SlipZero, Form { slip: 1.0, ..Form::default() });
                if self.mode == Mode::Closing {
                    let bottom = Form { offset: self.deepest_m, travel: -1.0, ..Form::default() };
                    guards.watch(Trigger::HoleBottom, bottom);
                }
            }
            Mode::Withdrawing => {
                let behind = geometry.pieces().iter().rev().find(|piece| piece.from_m < q);
                let start = behind.map_or(0.0, |piece| piece.from_m);
                guards.watch(
                    Trigger::PieceStart,
                    Form { offset: -start, travel: 1.0, ..Form::default() },
                );
                guards.watch(Trigger::SlipZero, Form { slip: -1.0, ..Form::default() });
            }
            Mode::FreeFlight => {
                guards.watch(Trigger::Recontact, Form { travel: -1.0, ..Form::default() });
            }
            Mode::Fused if !self.is_still() => self.watch_interface(guards),
            Mode::Fused | Mode::Perforated => {}
        }
    }

    fn watch_interface(&self, guards: &mut Guards) {
        let (strength, share) = (self.interface_n(), self.problem.share);
        let pull = self.problem.grip * strength;
        let at_bottom = self.state.travel_m >= self.deepest_m;
        let push = if at_bottom { strength } else { pull };
        let record = &self.record;
        if self.problem.plastic || (strength > 0.0 && record.push_exceeded_s.is_none()) {
            let form = Form { offset: push, mechanism: -share, ..Form::default() };
            guards.watch(Trigger::PushLimit, form);
        }
        if self.problem.plastic || (strength > 0.0 && record.pull_exceeded_s.is_none()) {
            let form = Form { offset: pull, mechanism: share, ..Form::default() };
            guards.watch(Trigger::PullLimit, form);
        }
    }

    fn watch_plate(&self, guards: &mut Guards) {
        let mechanism = &self.problem.mechanism;
        if self.held {
            let offset = -mechanism.spring.force(self.state.plate_m);
            let form = Form { offset, contact: self.problem.cos, ..Form::default() };
            guards.watch(Trigger::StopRelease, form);
            return;
        }
        let singular = |law: PowerLaw| law.kind() == PowerKind::General && !self.stiff;
        self.watch_zero_of_x(guards, singular(mechanism.spring));
        self.watch_zero_of_w(guards, singular(mechanism.damper));
        let at = mechanism.stop_at_m;
        if self.stop_touches {
            let stop = mechanism.elastic_stop().unwrap_or_default();
            let form = Form {
                offset: -stop.stiffness_n_m * at,
                plate: stop.stiffness_n_m,
                plate_speed: stop.damping_n_s_m,
                ..Form::default()
            };
            guards.watch(Trigger::StopCleared, form);
        } else if at.is_finite() {
            guards.watch(Trigger::StopReached, Form { offset: at, plate: -1.0, ..Form::default() });
        }
    }

    fn watch_zero_of_x(&self, guards: &mut Guards, singular: bool) {
        let near = self.near_zero_m();
        if self.spring_omitted {
            for side in [1.0, -1.0] {
                let form = Form { offset: near, plate: -side, ..Form::default() };
                guards.watch(Trigger::PlateClear, form);
            }
        } else if !self.problem.mechanism.spring.is_smooth_at_zero() && !self.stiff {
            let offset = if singular { -near } else { 0.0 };
            guards
                .watch(Trigger::PlateZero, Form { offset, plate: self.side_x, ..Form::default() });
        }
    }

    fn watch_zero_of_w(&self, guards: &mut Guards, singular: bool) {
        let near = self.near_zero_m_s();
        if self.damper_omitted {
            for side in [1.0, -1.0] {
                let form = Form { offset: near, plate_speed: -side, ..Form::default() };
                guards.watch(Trigger::PlateSpeedClear, form);
            }
            return;
        }
        let offset = if singular { -near } else { 0.0 };
        let form = Form { offset, plate_speed: self.side_w, ..Form::default() };
        guards.watch(Trigger::PlateSpeedZero, form);
    }

    /// How close to zero displacement the singular spring is left out: so close that it holds little of the plate's energy.
    fn near_zero_m(&self) -> f64 {
        let (spring, w) = (self.problem.mechanism.spring, self.state.plate_m_s);
        let energy = 0.5 * self.problem.plate_kg * w * w;
        let passing =
            smaller(CLEAR_OF_SPRING * self.plate_scale_m, spring.at_integral(PASSING * energy));
        larger(passing, CLOCK * self.t_s * w.abs())
    }

    /// How close to zero velocity the singular damper is left out: so close that other forces turn the plate round.
    fn near_zero_m_s(&self) -> f64 {
        let damper = self.problem.mechanism.damper;
        let motion = self.motion();
        let (_, rate) = motion.accelerations(&self.state);
        let damping = motion.damper.force(self.state.plate_m_s) * motion.plate_mobility;
        let others = (rate + damping).abs();
        let turning = damper.at_force(PASSING * others * self.problem.plate_kg);
        larger(smaller(CLEAR_OF_DAMPER * self.speed_scale_m_s, turning), CLOCK * self.t_s * others)
    }

    /// A singular law exactly at its zero cannot be expanded: leave it out until it has left zero.
    fn keep_off_singularities(&mut self) {
        if self.is_still() || self.stiff {
            return;
        }
        let mechanism = &self.problem.mechanism;
        if mechanism.spring.kind() == PowerKind::General && self.state.plate_m == 0.0 {
            self.spring_omitted = true;
        }
        if mechanism.damper.kind() == PowerKind::General && self.state.plate_m_s == 0.0 {
            self.damper_omitted = true;
        }
    }

    /// One Taylor step, shortened to the first event.
    fn taylor_step<const N: usize>(&mut self) -> ControlFlow<EndReason, Option<Trigger>> {
        let motion = self.motion();
        let h = self.unit_s;
        let e: Expansion<N> = motion.expand(&self.state, h);
        self.evaluations += 1;
        let trusted = trusted_step(&self.scales(&e), self.tolerance * LOCAL);
        if trusted < UNIT_FITS {
            // The unit is far too long for what happens now: sizes measured with it mean nothing.
            self.unit_s = h * larger(2.0 * trusted, 1e-3);
            self.rejected += 1;
            let hopeless = self.t_s + self.unit_s == self.t_s;
            return if hopeless {
                ControlFlow::Break(EndReason::StepUnderflow)
            } else {
                ControlFlow::Continue(None)
            };
        }
        let left = (self.until_s() - self.t_s) / h;
        let mut span = self.checked(&motion, &e, smaller(left, trusted));
        let mut fired = None;
        for (trigger, form) in self.guards().iter() {
            if let Some(s) = first_fall(&form.along(&e), span) {
                (span, fired) = (s, Some(*trigger));
            }
        }
        let state = e.state(span);
        if !is_finite(&state) {
            return ControlFlow::Break(EndReason::NonFinite);
        }
        let t_s = self.t_s + span * h;
        if t_s == self.t_s && fired.is_none() {
            return ControlFlow::Break(EndReason::StepUnderflow);
        }
        let mut record = std::mem::take(&mut self.record);
        record.step(&self.setting(&motion), &e, (self.t_s, h, span));
        self.record = record;
        self.unit_s = h * if fired.is_some() { trusted } else { span };
        self.steps += 1;
        self.stretch_steps += 1;
        self.arrive(t_s, state, &motion, fired);
        ControlFlow::Continue(fired)
    }

    /// The span, shortened until the expansion still solves the equations at its end.
    ///
    /// The last coefficients alone can be deceived: the solution may be close to a polynomial and yet end in a singularity.
    fn checked<const N: usize>(&mut self, motion: &Motion, e: &Expansion<N>, span: f64) -> f64 {
        let allowed = larger(DEFECT * self.tolerance * LOCAL, DEFECT_ROUNDING);
        let [_, (_, speed), _, (_, plate_speed)] = self.scales(e);
        let mut span = span;
        for _ in 0..60 {
            let (slip, plate) = motion.accelerations(&e.state(span));
            let time = span * self.unit_s;
            let slip_defect = (slip * time - evaluate_slope(&e.slip, span) * span) / speed;
            let plate_defect =
                (plate * time - evaluate_slope(&e.plate_speed, span) * span) / plate_speed;
            if slip_defect.abs() <= allowed && plate_defect.abs() <= allowed {
                break;
            }
            span *= 0.5;
            self.rejected += 1;
        }
        span
    }

    /// The state at the end of a step, put exactly on the event that ended it.
    pub(super) fn arrive(
        &mut self,
        t_s: f64,
        state: State,
        motion: &Motion,
        fired: Option<Trigger>,
    ) {
        let before = self.state;
        self.t_s = t_s;
        self.state = state;
        if let Some(trigger) = fired {
            self.snap(trigger, &before);
        }
        if self.mode == Mode::Penetrating {
            self.deepest_m = larger(self.state.travel_m, self.deepest_m);
        }
        let (x, w) = (self.state.plate_m.abs(), self.state.plate_m_s.abs());
        self.plate_scale_m = larger(x, self.plate_scale_m);
        self.speed_scale_m_s = larger(w, self.speed_scale_m_s);
        let mut record = std::mem::take(&mut self.record);
        record.reach(t_s, self.state.plate_m);
        record.point(&self.setting(motion), t_s, &self.state, true);
        self.record = record;
    }

    /// Scales against which truncation errors are measured: each quantity's own size over the step, but not less than
    /// what matters to the depth while there is contact.
    fn scales<'e, const N: usize>(&self, e: &'e Expansion<N>) -> [(&'e [f64; N], f64); 4] {
        let own = |c: &[f64; N]| c[0].abs() + c[1].abs() + c[2].abs() + c[3].abs();
        let contact = matches!(self.mode, Mode::Penetrating | Mode::Closing | Mode::Withdrawing);
        let part = if contact { 1e-3 } else { 0.0 };
        let travel = e.travel[0].abs() + e.travel[1].abs() + f64::MIN_POSITIVE;
        let speed = self.problem.velocity_m_s;
        [
            (&e.travel, travel),
            (&e.slip, speed),
            (&e.plate, own(&e.plate) + part * travel + f64::MIN_POSITIVE),
            (&e.plate_speed, own(&e.plate_speed) + part * speed + f64::MIN_POSITIVE),
        ]
    }
}

/// Whether every component is finite.
pub(super) fn is_finite(state: &State) -> bool {
    state.travel_m.is_finite()
        && state.slip_m_s.is_finite()
        && state.plate_m.is_finite()
        && state.plate_m_s.is_finite()
}

/// The side of zero of a number, or `other` for zero itself.
pub(super) fn side(z: f64, other: f64) -> f64 {
    if z == 0.0 { other } else { sign(z) }
}
