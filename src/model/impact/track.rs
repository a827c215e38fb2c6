//! The run itself: stretches of smooth motion between located events.
//!
//! A [`Track`] owns the state and knows in which mode the bodies are. Each stretch is advanced by Taylor steps
//! (`taylor.rs`) or, where those become too many, by the implicit method (`stiff.rs`); when an event function (`active_events.rs`) changes its sign, the
//! state is put exactly on the event and `events.rs` decides what follows. What rounding has put behind the state already is found
//! by `missed_event.rs`.

use std::cell::Cell;
use std::ops::ControlFlow;

use crate::model::contact_models::Hole;
use crate::model::event_function::EventId;
use crate::model::impact::demand::Swing;
use crate::model::impact::problem::Problem;
use crate::model::impact::record::{Record, Setting};
use crate::model::impact::report;
use crate::model::impact::singular_crossing::Taken;
use crate::model::impact::termination::{Asked, MaximumDisplacement};
use crate::model::mechanism::{Elastic, PowerKind, PowerLaw, sign};
use crate::model::motion::{Motion, State, StopForce};
use crate::model::run::Observer;
use crate::model::run::{EndReason, Mode, Outcome};
use crate::numerics::larger;

/// Taylor steps after which a stretch is handed to the implicit method.
const TAYLOR_STEPS_PER_STRETCH: usize = 20_000;
/// A passage through zero within this many ticks of the clock takes no time.
const PASSED_TICKS: f64 = 16.0;

/// Part of the spring's force up to which its damper, times its exponent, lets a plate that came through zero swing: Taylor steps
/// then follow the swings, with fewer steps than the implicit method.
const SWINGS_TO: f64 = 3.0;

/// A run in progress.
#[derive(Clone)]
#[expect(clippy::struct_excessive_bools, reason = "facts that hold or do not, each by itself")]
pub(super) struct Track<'a> {
    pub(super) problem: &'a Problem,
    pub(super) record: Record<'a>,
    pub(super) state: State,
    /// Greatest travel so far: the bottom of the hole, m.
    pub(super) deepest_m: f64,
    pub(super) mode: Mode,
    /// The plate rests on its rigid stop.
    pub(super) held: bool,
    /// The rigid stop has released the plate at this moment: no rounding of the forces brings it back.
    pub(super) released: bool,
    /// The mechanism cannot move the plate noticeably: it stays where it is.
    pub(super) immobile: bool,
    /// The plate, on which nothing but its mechanism acts, has died down.
    pub(super) resting: bool,
    /// The elastic stop is in contact.
    pub(super) stop_touches: bool,
    /// The singular spring, or damper, is left out close to its zero.
    pub(super) spring_omitted: bool,
    pub(super) damper_omitted: bool,
    /// How far from zero they come back, fixed when they are left out, m and m/s.
    pub(super) clear_m: f64,
    pub(super) clear_m_s: f64,
    pub(super) side_x: f64,
    pub(super) side_w: f64,
    /// Where a stride through the zero of the spring, and of the damper, was refused last on this way in, m and m/s.
    pub(super) stride_refused: [f64; 2],
    /// Where the last stride out of each zero ended, m and m/s; 0 once the way is another one.
    pub(super) strode_to: [f64; 2],
    /// What strides that the depth depends on may be off by, relative.
    pub(super) stride_error: f64,
    /// What rounding has left out of the displacement, m, as far as the last step knew.
    pub(super) compensation_m: f64,
    /// The stretch of the spring's curve in which the plate is; without meaning for a power law.
    pub(super) region: usize,
    /// Greatest |x| and |w| seen, m and m/s.
    pub(super) plate_scale_m: f64,
    pub(super) speed_scale_m_s: f64,
    /// Time unit of the next expansion, s.
    pub(super) unit_s: f64,
    pub(super) tolerance: f64,
    /// The implicit method has this stretch.
    pub(super) stiff: bool,
    pub(super) stretch_steps: usize,
    /// Taylor steps in a row in which the plate crept against its damper.
    pub(super) creeping_steps: usize,
    /// The implicit method has this stretch because the plate creeps.
    pub(super) creeps: bool,
    /// Times the force on the plate changed its sign: twice a swing, about whatever it swings.
    pub(super) turns: usize,
    /// The sign of the force on the plate at the last step.
    pub(super) pushed: f64,
    pub(super) steps: usize,
    pub(super) stiff_steps: usize,
    pub(super) rejected: usize,
    pub(super) evaluations: usize,
    /// Work done, in Taylor expansions.
    pub(super) work: Cell<usize>,
    pub(super) event_count: usize,
    /// The outcome, once it is decided, and the steps taken until then.
    pub(super) decided: Option<(Outcome, usize)>,
    /// Times the interface has given way since the hole last became noticeably deeper.
    pub(super) slips_since_deeper: usize,
    /// Depth of the hole when it last did, as travel, m.
    pub(super) noticed_m: f64,
    /// The greatest displacement, as far as it is known.
    pub(super) farthest: MaximumDisplacement,
    /// When the outcome was last asked for, on a curve.
    pub(super) asked: Option<Asked>,
    /// How far the first swing of the joined body has come.
    pub(super) swing: Swing,
    /// The second computation, which the first is compared with.
    pub(super) is_second: bool,
}

impl<'a> Track<'a> {
    /// A run at the moment of first contact.
    pub(super) fn new(problem: &'a Problem, tolerance: f64, keep_series: bool) -> Self {
        let state = State {
            t_s: 0.0,
            travel_m: 0.0,
            slip_m_s: problem.velocity_m_s,
            plate_m: problem.start_m,
            plate_m_s: 0.0,
        };
        let pull = -problem.mechanism.spring.force(problem.start_m);
        Self {
            problem,
            record: Record { keep_series, farthest_m: problem.start_m, ..Record::default() },
            state,
            deepest_m: 0.0,
            mode: Mode::Penetrating,
            // Unless its spring takes it off at once.
            held: problem.mechanism.rigid_stop().is_some()
                && problem.start_m >= problem.mechanism.stop_at_m
                && pull >= 0.0,
            released: false,
            immobile: false,
            resting: false,
            stop_touches: problem.mechanism.elastic_stop().is_some()
                && problem.start_m >= problem.mechanism.stop_at_m,
            spring_omitted: false,
            damper_omitted: false,
            clear_m: 0.0,
            clear_m_s: 0.0,
            compensation_m: 0.0,
            stride_refused: [f64::INFINITY; 2],
            strode_to: [0.0; 2],
            stride_error: 0.0,
            side_x: if problem.start_m < 0.0 { -1.0 } else { 1.0 },
            side_w: if pull < 0.0 { -1.0 } else { 1.0 },
            region: first_region(problem, pull),
            plate_scale_m: problem.start_m.abs(),
            speed_scale_m_s: 0.0,
            unit_s: 0.1 * problem.contact_scale_s(),
            tolerance,
            stiff: false,
            stretch_steps: 0,
            creeping_steps: 0,
            creeps: false,
            turns: 0,
            pushed: 0.0,
            steps: 0,
            stiff_steps: 0,
            rejected: 0,
            evaluations: 0,
            work: Cell::new(0),
            event_count: 0,
            decided: None,
            slips_since_deeper: 0,
            noticed_m: 0.0,
            farthest: MaximumDisplacement::Pending,
            asked: None,
            swing: Swing::Back,
            is_second: false,
        }
    }

    /// Run to the end.
    pub(super) fn run<const N: usize>(&mut self, observer: Observer<'_>) -> EndReason {
        loop {
            if let Some(reason) = self.finished() {
                return reason;
            }
            if observer(self.state.t_s).is_break() {
                return EndReason::Cancelled;
            }
            if let Some(window) = self.record.window {
                window.show(|| report::gather(self.problem, self.look(), EndReason::Cancelled));
            }
            if let Some(reason) = self.budget_used_up() {
                return self.end_early(reason);
            }
            if let Some(event) = self.missed_event() {
                let before = self.state;
                self.project_onto_event(event, &before);
                self.apply_transition(event);
                continue;
            }
            self.compensate_displacement();
            self.come_to_rest();
            self.unload_absorbers();
            if let Some(Taken(fired)) = self.stride() {
                if let Some(event) = fired {
                    self.apply_transition(event);
                }
                continue;
            }
            self.keep_off_singularities();
            self.pass_zero_under_implicit_steps();
            if self.stretch_steps > TAYLOR_STEPS_PER_STRETCH {
                self.stiff = true;
            }
            let advanced = if self.stiff { self.stiff_step() } else { self.taylor_step::<N>() };
            match advanced {
                ControlFlow::Break(reason) => return self.end_early(reason),
                ControlFlow::Continue(None) => {}
                ControlFlow::Continue(Some(event)) => self.apply_transition(event),
            }
        }
    }

    /// The run so far, with no more of its series than a chart can show.
    fn look(&mut self) -> Self {
        let series = std::mem::take(&mut self.record.series);
        let mut copy = self.clone();
        copy.record.series = Record::look(&series);
        self.record.series = series;
        copy
    }

    /// What follows an event, and which method goes on.
    pub(super) fn apply_transition(&mut self, event: EventId) {
        self.event_count += usize::from(event.changes_course());
        self.worked(1);
        let before = self.mode;
        self.handle(event);
        if self.mode != before {
            self.stiff = false;
            self.creeps = false;
            self.resting = false;
            self.stretch_steps = 0;
        }
    }

    /// Count how often the force on the plate changes its sign, by its acceleration at every step.
    pub(super) fn count_turns(&mut self, acceleration: f64) {
        let pushed = sign(acceleration);
        if pushed * self.pushed < 0.0 {
            self.turns += 1;
            // What swings again and again takes many steps without being stiff.
            self.stretch_steps = 0;
        }
        self.pushed = if pushed == 0.0 { self.pushed } else { pushed };
    }

    /// A run whose outcome is known is complete even when its tail is cut short, unless it was to go as far as a horizon.
    fn end_early(&self, reason: EndReason) -> EndReason {
        let is_complete = self.decided.is_some() && !self.problem.horizon_is_asked;
        if is_complete { EndReason::Decided } else { reason }
    }

    /// Whether the plate cannot move: rigid, held by its stop, or as good as immobile.
    pub(super) fn is_still(&self) -> bool {
        self.problem.rigid || self.held || self.immobile || self.resting
    }

    /// Whether projectile and plate slide against each other.
    pub(super) fn is_sliding(&self) -> bool {
        matches!(self.mode, Mode::Penetrating | Mode::Closing | Mode::Withdrawing)
    }

    /// The equations of the present mode.
    pub(super) fn motion(&self) -> Motion<'a> {
        let problem = self.problem;
        let mechanism = &problem.mechanism;
        let still = self.is_still();
        let joined = self.mode == Mode::Fused;
        let keep = |law: PowerLaw, omitted: bool| PowerLaw {
            coefficient: if omitted || still { 0.0 } else { law.coefficient },
            ..law
        };
        let stop = mechanism.elastic_stop().filter(|_| self.stop_touches);
        let plate_kg = if joined { problem.joined_kg } else { problem.plate_kg };
        Motion {
            contact: problem.contact.force(self.mode, &self.hole()),
            slip_mobility: problem.slip_mobility(!still),
            plate_mobility: if still { 0.0 } else { 1.0 / plate_kg },
            coupling: if joined { 0.0 } else { problem.cos },
            spring: match mechanism.spring.curve() {
                Some(curve) if !still => Elastic::Piece(curve.piece(self.region)),
                _ => Elastic::Power(keep(self.spring(), self.spring_omitted)),
            },
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

    /// The projectile in its hole.
    pub(super) fn hole(&self) -> Hole<'_> {
        Hole {
            geometry: &self.problem.geometry,
            state: self.state,
            deepest_m: self.deepest_m,
            still: self.is_still(),
        }
    }

    /// The spring as a power law; none where it is a curve.
    pub(super) fn spring(&self) -> PowerLaw {
        let none = PowerLaw { coefficient: 0.0, exponent: 1.0 };
        self.problem.mechanism.spring.power().unwrap_or(none)
    }

    /// The ends of the present stretch of the spring's curve, m; infinite for a power law.
    pub(super) fn spring_ends(&self) -> (f64, f64) {
        let curve = self.problem.mechanism.spring.curve();
        curve.map_or((f64::NEG_INFINITY, f64::INFINITY), |curve| curve.ends(self.region))
    }

    /// What the interface can push at the present travel, N.
    pub(super) fn interface_n(&self) -> f64 {
        self.problem.geometry.area_m2(self.state.travel_m) * self.problem.strength_pa
    }

    /// What samples and records need.
    pub(super) fn setting<'m>(&'m self, motion: &'m Motion<'m>) -> Setting<'m> {
        Setting {
            problem: self.problem,
            motion,
            mode: self.mode,
            still: self.is_still(),
            held: self.held,
            interface_n: if self.mode == Mode::Fused { self.interface_n() } else { 0.0 },
        }
    }

    /// A singular law exactly at its zero cannot be expanded: leave it out until it has left zero.
    fn keep_off_singularities(&mut self) {
        if self.is_still() || self.stiff {
            return;
        }
        let mechanism = &self.problem.mechanism;
        if mechanism.spring.is_singular() && self.state.plate_m == 0.0 {
            self.omit_spring();
        }
        if mechanism.damper.kind() == PowerKind::General && self.state.plate_m_s == 0.0 {
            self.omit_damper();
        }
    }

    /// The implicit method rides along a spring that is infinitely steep at zero, but cannot follow a plate that comes
    /// through zero with speed to spare: its unknown, the spring's force, changes sign there at once.
    fn pass_zero_under_implicit_steps(&mut self) {
        let (x, w) = (self.state.plate_m, self.state.plate_m_s);
        let steep = self
            .problem
            .mechanism
            .spring
            .power()
            .is_some_and(|law| law.coefficient > 0.0 && law.exponent < 1.0);
        if !(self.stiff && steep) || self.is_still() || self.spring_omitted {
            return;
        }
        let (spring, damper) = (self.spring(), self.problem.mechanism.damper);
        // The velocity of a plate that only follows the contact's force may be what a step has left of it.
        let unfelt = self.is_unfelt();
        let rides = unfelt && 0.5 * self.problem.plate_kg * w * w < spring.integral(x);
        if x * w < 0.0 && x.abs() <= self.near_zero_m() && !rides {
            if !unfelt
                && damper.exponent * damper.force(w).abs() <= SWINGS_TO * spring.force(x).abs()
            {
                self.stiff = false;
                self.stretch_steps = 0;
                self.side_x = sign(x);
                self.side_w = sign(w);
            }
            if x.abs() <= PASSED_TICKS * f64::EPSILON * self.state.t_s * w.abs() {
                // The clock does not see it.
                self.state.plate_m = -x;
                self.side_x = sign(-x);
                return;
            }
            // As far on the other side as on this one: what the spring takes it also gives.
            self.clear_m = x.abs();
            self.spring_omitted = true;
            self.shorten_unit(self.clear_m / w.abs());
        }
    }

    /// Records the present state.
    pub(super) fn point(&mut self) {
        let motion = self.motion();
        let mut record = std::mem::take(&mut self.record);
        record.point(&self.setting(&motion), &self.state, true);
        self.record = record;
    }

    /// The state at the end of a step, put exactly on the event that ended it.
    pub(super) fn arrive(&mut self, state: State, motion: &Motion<'_>, fired: Option<EventId>) {
        let before = self.state;
        self.state = state;
        self.compensation_m = 0.0;
        self.released = false;
        if let Some(event) = fired {
            self.project_onto_event(event, &before);
        }
        if self.mode == Mode::Penetrating {
            self.deepest_m = larger(self.state.travel_m, self.deepest_m);
        }
        let (x, w) = (self.state.plate_m.abs(), self.state.plate_m_s.abs());
        self.plate_scale_m = larger(x, self.plate_scale_m);
        self.speed_scale_m_s = larger(w, self.speed_scale_m_s);
        let mut record = std::mem::take(&mut self.record);
        record.reach(&self.state);
        record.point(&self.setting(motion), &self.state, true);
        self.record = record;
    }
}

/// The stretch of the spring's curve into which the plate starts to move.
fn first_region(problem: &Problem, pull_n: f64) -> usize {
    let Some(curve) = problem.mechanism.spring.curve() else {
        return 0;
    };
    let above = curve.region(problem.start_m);
    let at_knot = curve.ends(above).0 >= problem.start_m;
    if at_knot && pull_n < 0.0 { above - 1 } else { above }
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
