//! Stretches too stiff for Taylor steps, by the implicit method.
//!
//! Where the spring's exponent is below one the unknown is the spring's force instead of the displacement, and the same for
//! the damper: x = (force/k)^(1/n) is smooth and flat at zero where force = k x^n is infinitely steep. So Newton's method
//! cannot mistake the plate for stuck, as implicit codes do that solve for x.

use std::ops::ControlFlow;

use crate::model::event_function::EventId;
use crate::model::impact::record::Setting;
use crate::model::impact::simulation::{Simulation, is_finite};
use crate::model::impact::step_control::StepControl;
use crate::model::motion::{Motion, State};
use crate::model::run::{EndReason, Mode};
use crate::numerics::event::{first_sign_change, land};
use crate::numerics::implicit::{
    ImplicitSystem, NEWTON_MAX, NODES, Step, WEIGHTS, interpolate, step, step_factor,
};
use crate::numerics::{larger, maximum, smaller};

mod unknowns;

use unknowns::Unknowns;

/// Points drawn within a step, its end included.
const DRAWN_PER_STEP: usize = 4;
/// How far from zero an event function may be where it has fallen, relative to its variation over the step.
const EVENT_TOLERANCE: f64 = 1e-9;
/// The shortest step, relative to the time reached: time has no finer resolution.
const TICK: f64 = 2.0 * f64::EPSILON;
/// The step, relative to the time reached, at whose end an event is taken wherever on it the sign changes.
const EVENT_STEP_MIN: f64 = 4.0 * TICK;
/// The estimate is of order 4 in the step, the method's local error of order 6: asking the estimate for this times the
/// tolerance to the power 2/3 (Hairer's RADAU5 does the same) brings the method's own error below the tolerance.
const ESTIMATE_PART: f64 = 1e-3;
/// Displacement of the plate, relative to the travel, up to which the contact is independent of its oscillations; the estimate,
/// relative to the impact velocity, below which it follows them all the same; and the power with which the rest of a tighter
/// tolerance still counts, so that two tolerances do not share their steps.
const DECOUPLED: f64 = 1e-7;
const ESTIMATE_FLOOR: f64 = 1e-9;
const ESTIMATE_POWER: f64 = 0.05;

/// Energy a step may be off by, relative to all there is, per tolerance, and how often it is halved for that.
const ENERGY_TOLERANCE: f64 = 1e-2;
const HALVINGS_MAX: usize = 8;

/// Radians within a step, and part of the forces on the plate that is left for inertia, from which on a plate that crept
/// oscillates again, and for how many steps it must.
const OSCILLATION_STEP_RAD: f64 = 0.5;
const OSCILLATION_INERTIA: f64 = 0.2;
const OSCILLATION_STEPS: usize = 20;
/// How far the rounding of the plate's velocity is to lie below what the estimate of a step may be: Newton's method, and the
/// estimate itself, see nothing below it.
const ROUNDING_MARGIN: f64 = 100.0;
/// The least scale of the slip relative to its own value.
const SLIP_SCALE_MIN: f64 = 1e-2;

impl Simulation<'_> {
    /// One implicit step, shortened to the first event.
    pub(super) fn stiff_step(&mut self) -> ControlFlow<EndReason, Option<EventId>> {
        let motion = self.body.motion();
        let tolerance = self.estimate_allowed();
        let scale = self.stiff_scale(&motion, tolerance);
        let system = Unknowns::of(&motion, &self.body.state, scale);
        let y = system.fold(&self.body.state, self.body.compensation_m);
        let mut h = self.control.unit_s;
        let left = self.until_s() - self.body.state.t_s;
        let mut halvings = 0;
        for _ in 0..200 {
            h = if left < h { left } else { h };
            let tick = TICK * self.body.state.t_s;
            let at_tick = h <= tick;
            h = larger(h, tick);
            let solved = self.solve(&system, &y, h);
            self.control.evaluations +=
                solved.as_ref().map_or(NEWTON_MAX, |step| step.iterations) * 3;
            let Some(solved) = solved else {
                if at_tick {
                    return ControlFlow::Break(EndReason::StepUnderflow);
                }
                h *= 0.25;
                self.control.rejected += 1;
                continue;
            };
            let factor = step_factor(solved.error, tolerance);
            // Within one ulp of the time a stiff force settles, whatever its way: the method is L-stable.
            if solved.error > tolerance && !at_tick {
                h *= smaller(factor, 0.9);
                self.control.rejected += 1;
                continue;
            }
            if !at_tick
                && halvings < HALVINGS_MAX
                && self.imbalance_j(&system, &solved, h).abs()
                    > ENERGY_TOLERANCE * self.body.tolerance * self.body.problem.energy_j
            {
                halvings += 1;
                h *= 0.5;
                self.control.rejected += 1;
                continue;
            }
            self.control.unit_s = h * factor;
            return self.accept(&system, &y, h, solved);
        }
        ControlFlow::Break(EndReason::StepUnderflow)
    }

    /// The tolerance for the estimate of a step, relative to the scales.
    fn estimate_allowed(&self) -> f64 {
        let allowed = ESTIMATE_PART * self.body.tolerance.powf(2.0 / 3.0);
        let unresolved = self.body.problem.yields_part < DECOUPLED
            && self.body.plate_scale_m < DECOUPLED * self.body.state.travel_m;
        if self.body.is_sliding() && unresolved && allowed < ESTIMATE_FLOOR {
            ESTIMATE_FLOOR * (allowed / ESTIMATE_FLOOR).powf(ESTIMATE_POWER)
        } else {
            allowed
        }
    }

    /// A step from whichever guess leads anywhere.
    fn solve(&self, system: &Unknowns<'_>, y: &[f64; 4], h: f64) -> Option<Step<4>> {
        let from = |guess| newton(&self.control, system, y, h, guess);
        from(system.guess(y, h)).or_else(|| from([*y; 3]))
    }

    /// A plate that no longer creeps oscillates, and Taylor steps follow that with far fewer.
    fn notice_oscillations(&mut self, system: &Unknowns<'_>, y: &[f64; 4], h: f64) {
        let (motion, state) = (system.motion, &self.body.state);
        let stiffness = motion.stop.stiffness_n_m + motion.spring.tangent(state.plate_m).abs();
        let radians = (stiffness * motion.plate_mobility).sqrt() * h;
        let held_n =
            motion.damper.force(state.plate_m_s).abs() + motion.spring.force(state.plate_m).abs();
        let net_n = (system.rate(0.0, y)[3] / motion.plate_mobility).abs();
        let damping = motion.damper.tangent(state.plate_m_s).abs() + motion.stop.damping_n_s_m;
        let faded = damping * motion.plate_mobility * h;
        // About a place where large forces hold each other the one that is left says little.
        let is_free = faded < OSCILLATION_STEP_RAD || net_n > OSCILLATION_INERTIA * held_n;
        let oscillations = radians < OSCILLATION_STEP_RAD && is_free;
        self.control.stiffness_signs =
            if oscillations { self.control.stiffness_signs + 1 } else { 0 };
        if self.control.stiffness_signs > OSCILLATION_STEPS {
            self.control.stiffness_signs = 0;
            self.control.stretch_steps = 0;
            self.control.stiff = false;
        }
    }

    /// The error of the plate's energy over a step, J: where its spring holds nearly all energy, errors of the displacement that do
    /// not matter to the contact show in it.
    fn imbalance_j(&self, system: &Unknowns<'_>, solved: &Step<4>, h: f64) -> f64 {
        let motion = system.motion;
        let spring = &self.body.problem.mechanism.spring;
        let energy = |state: &State| {
            0.5 * state.plate_m_s * state.plate_m_s / motion.plate_mobility
                + spring.energy(state.plate_m)
        };
        let mut gained = energy(&system.state(&solved.stages[2], h)) - energy(&self.body.state);
        for ((stage, weight), node) in solved.stages.iter().zip(WEIGHTS).zip(NODES) {
            let state = system.state(stage, node * h);
            let push_n = motion.coupling * motion.contact_force(&state)
                - motion.damper.force(state.plate_m_s)
                - motion.stop_force(&state);
            gained -= h * weight * push_n * state.plate_m_s;
        }
        gained
    }

    /// The sizes against which errors are measured where a step's estimate may be so much of them.
    fn stiff_scale(&self, motion: &Motion<'_>, tolerance: f64) -> [f64; 4] {
        let speed = self.body.problem.velocity_m_s;
        let travel = self.body.state.travel_m.abs()
            + self.body.state.slip_m_s.abs() * self.control.unit_s
            + f64::MIN_POSITIVE;
        // An oscillation that an error starts does not die down: it is to be small beside the way the plate will have come.
        let yields = self.body.problem.yields_part;
        let part = if yields < DECOUPLED { 1.0 } else { yields };
        let (x, w) = if self.body.mode == Mode::Fused {
            let (x, w) = (self.body.plate_scale_m, self.body.speed_scale_m_s);
            (larger(x, f64::MIN_POSITIVE), larger(w, f64::MIN_POSITIVE))
        } else {
            let state = &self.body.state;
            (part * travel + state.plate_m.abs(), part * speed + state.plate_m_s.abs())
        };
        let known_w = self.rounding_of_speed_m_s(motion) * ROUNDING_MARGIN / tolerance;
        [
            travel,
            // A slip far above the impact's, of a plate thrown by its spring, is known to its own rounding only.
            larger(speed, SLIP_SCALE_MIN * self.body.state.slip_m_s.abs()),
            x,
            larger(known_w, w),
        ]
    }

    /// The uncertainty of the plate's velocity over the next step from the rounding of its forces, m/s.
    fn rounding_of_speed_m_s(&self, motion: &Motion<'_>) -> f64 {
        let state = &self.body.state;
        let force_n =
            larger(motion.spring.force(state.plate_m).abs(), motion.stop_force(state).abs());
        let damping = motion.damper.tangent(state.plate_m_s).abs() + motion.stop.damping_n_s_m;
        let mobility = motion.plate_mobility * self.control.unit_s;
        f64::EPSILON * force_n * mobility / (1.0 + damping * mobility)
    }

    fn accept(
        &mut self,
        system: &Unknowns<'_>,
        y: &[f64; 4],
        mut h: f64,
        mut solved: Step<4>,
    ) -> ControlFlow<EndReason, Option<EventId>> {
        let motion = system.motion;
        let events = self.active_events();
        let start = self.body.state;
        let mut detected = None;
        // What ends a step may lie behind what a shorter one shows to have happened before: a plate, or the projectile, that has
        // come back within it.
        for _ in events.iter() {
            let taken = StiffStep { control: &self.control, system, y, h, solved: &solved };
            let end = taken.dense(1.0);
            let armed = events.iter().filter(|(event, form)| {
                detected != Some(*event) && form.value_beyond_rounding(motion, &start) > 0.0
            });
            let sign_changes = armed.filter_map(|(event, form)| {
                let at = |part: f64| form.value_beyond_rounding(motion, &taken.dense(part));
                Some((
                    *event,
                    form,
                    first_sign_change([(1.0, form.value_beyond_rounding(motion, &end))], at)?,
                ))
            });
            let Some((event, form, sign_change)) =
                sign_changes.min_by(|a, b| a.2.part.total_cmp(&b.2.part))
            else {
                break;
            };
            let variation = form.at(motion, &start) - form.at(motion, &end);
            let near = |state: &State| EVENT_TOLERANCE * variation + form.rounding(motion, state);
            let value = |state: &State| form.value_beyond_rounding(motion, state);
            let (dense, anew) = (|part| taken.dense(part), |part| taken.anew(part));
            let landed = land(&sign_change, dense, anew, value, near);
            if let Some((part, step)) = landed {
                (h, solved, detected) = (part * h, step, Some(event));
            } else if h <= EVENT_STEP_MIN * start.t_s {
                // No coming closer: time has no finer resolution.
                detected = Some(event);
                break;
            } else {
                // Newton's method went astray on the way to the event: come closer first.
                self.control.unit_s = 0.25 * h;
                self.control.rejected += 1;
                return ControlFlow::Continue(None);
            }
        }
        let state = system.state(&solved.stages[2], h);
        if !is_finite(&state) {
            return ControlFlow::Break(EndReason::NonFinite);
        }
        self.write_down(system, y, &solved, h);
        self.control.steps += 1;
        self.control.stiff_steps += 1;
        self.control.stretch_steps += 1;
        self.control.count_turns(system.rate(0.0, y)[3]);
        self.notice_oscillations(system, y, h);
        self.arrive(state, motion, detected);
        let is_moved = self.body.state.plate_m.to_bits() != state.plate_m.to_bits();
        if !is_moved {
            self.body.compensation_m = system.compensation_m(&solved.stages[2]);
        }
        ControlFlow::Continue(detected)
    }

    /// Work by the method's own quadrature, extremes of its dense output, points to draw.
    fn write_down(&mut self, system: &Unknowns<'_>, y: &[f64; 4], solved: &Step<4>, h: f64) {
        let motion = system.motion;
        let record = &mut self.record;
        let setting = Setting { body: &self.body, motion };
        for ((stage, weight), node) in solved.stages.iter().zip(WEIGHTS).zip(NODES) {
            let state = system.state(stage, node * h);
            record.worked(&setting, &state, h * weight);
        }
        // Within a step that passes a boundary layer the polynomial through its stages says little: another step is taken to
        // there.
        let taken = StiffStep { control: &self.control, system, y, h, solved };
        record.note_extremes(&setting, |force, known| {
            let value = |state: &State| motion.force(force, state);
            let rough = |part: f64| value(&taken.dense(part));
            maximum::greatest_of(0.0, 1.0, known, rough, |part| value(&taken.exact(part)))
        });
        let penetrates = self.body.mode == Mode::Penetrating;
        let at = |part: f64| if penetrates { taken.exact(part) } else { taken.dense(part) };
        record.draw(&setting, self.body.state.t_s + h, DRAWN_PER_STEP, at);
    }
}

/// A step from this guess; its work is counted.
fn newton(
    control: &StepControl,
    system: &Unknowns<'_>,
    y: &[f64; 4],
    h: f64,
    guess: [[f64; 4]; 3],
) -> Option<Step<4>> {
    let solved = step::<4, 12>(system, y, h, guess);
    // An iteration is as much work as a Taylor expansion.
    control.worked(solved.as_ref().map_or(NEWTON_MAX, |step| step.iterations));
    solved
}

struct StiffStep<'a> {
    control: &'a StepControl,
    system: &'a Unknowns<'a>,
    y: &'a [f64; 4],
    h: f64,
    solved: &'a Step<4>,
}

impl StiffStep<'_> {
    fn dense(&self, part: f64) -> State {
        self.system.state(&interpolate(self.y, self.solved, part), part * self.h)
    }

    /// A step from the same start that ends at this part, with the state there.
    fn anew(&self, part: f64) -> Option<(State, Step<4>)> {
        let h = part * self.h;
        let step = newton(self.control, self.system, self.y, h, self.system.guess(self.y, h))?;
        Some((self.system.state(&step.stages[2], h), step))
    }

    /// The state at a part of the step, as exact as the method is.
    fn exact(&self, part: f64) -> State {
        self.anew(part).map_or_else(|| self.dense(part), |(state, _)| state)
    }
}
