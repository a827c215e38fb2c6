//! Stretches too stiff for Taylor steps, by the implicit method.
//!
//! Where the spring's exponent is below one the unknown is the spring's force instead of the displacement, and the same for
//! the damper: x = (force/k)^(1/n) is smooth and flat at zero where force = k x^n is infinitely steep. So Newton's method
//! cannot mistake the plate for stuck, as implicit codes do that solve for x.

use std::ops::ControlFlow;

use crate::model::contact::AreaLaw;
use crate::model::impact::guard::{Form, Trigger};
use crate::model::impact::track::{Track, is_finite};
use crate::model::mechanism::{Elastic, PowerLaw, sign};
use crate::model::motion::{Motion, State};
use crate::model::run::{EndReason, Mode};
use crate::numerics::implicit::{
    ImplicitSystem, NODES, Step, WEIGHTS, interpolate, step, step_factor,
};
use crate::numerics::root::in_bracket;
use crate::numerics::{larger, smaller};

/// Points drawn within a step.
const POINTS_PER_STEP: usize = 3;
/// How far from zero a guard may be where it has fallen, relative to its variation over the step.
const LANDED: f64 = 1e-9;
/// The shortest step, relative to the time reached: the clock has no finer ticks.
const TICK: f64 = 2.0 * f64::EPSILON;
/// The step, relative to the time reached, at whose end an event is taken wherever in it it falls.
const CLOSEST: f64 = 4.0 * TICK;
/// Implicit steps after which a run ends early.
const STIFF_STEPS_MAX: usize = 30_000;
/// The estimate is of order 4 in the step, the method's local error of order 6: asking the estimate for this times the
/// tolerance to the power 2/3 (Hairer's RADAU5 does the same) brings the method's own error below the tolerance.
const LOCAL: f64 = 1e-3;

/// Energy a step may be off by, relative to all there is, per tolerance, and how often it is halved for that.
const UNBALANCED: f64 = 1e-2;
const HALVINGS_MAX: usize = 8;

/// Radians within a step, and part of the forces on the plate that is left for inertia, from which on a plate that crept swings
/// again, and for how many steps it must.
const SWINGING_STEP: f64 = 0.5;
const SWINGING: f64 = 0.2;
const SWINGING_STEPS: usize = 20;
/// The least scale of the slip relative to its own value.
const SLIP_ROUNDED: f64 = 1e-2;

/// The present motion in the implicit method's unknowns.
struct Unknowns<'a> {
    motion: &'a Motion<'a>,
    spring: Carrier<'a>,
    damper: Carrier<'a>,
    scale: [f64; 4],
}

/// Whether a law's unknown is its argument or its force.
#[derive(Clone, Copy)]
enum Carrier<'a> {
    /// x itself; the force follows.
    Argument(Elastic<'a>),
    /// The force; x = sgn (|force|/k)^(1/n) follows.
    Force(PowerLaw),
}

impl<'a> Carrier<'a> {
    fn of(law: Elastic<'a>) -> Self {
        match law {
            Elastic::Power(law) if law.coefficient > 0.0 && law.exponent < 1.0 => Self::Force(law),
            Elastic::Power(_) | Elastic::Piece(_) => Self::Argument(law),
        }
    }

    fn unknown(self, z: f64) -> f64 {
        match self {
            Self::Argument(_) => z,
            Self::Force(law) => law.force(z),
        }
    }

    /// (argument, its derivative, force, its derivative) by the unknown.
    fn unfold(self, y: f64) -> (f64, f64, f64, f64) {
        match self {
            Self::Argument(law) => {
                let tangent = law.tangent(y);
                (y, 1.0, law.force(y), tangent)
            }
            Self::Force(law) => {
                let z = law.at_force(y) * sign(y);
                let slope = if y == 0.0 { 0.0 } else { z / (law.exponent * y) };
                (z, slope, y, 1.0)
            }
        }
    }
}

impl Unknowns<'_> {
    fn state(&self, y: &[f64; 4]) -> State {
        State {
            travel_m: y[0],
            slip_m_s: y[1],
            plate_m: self.spring.unfold(y[2]).0,
            plate_m_s: self.damper.unfold(y[3]).0,
        }
    }

    fn fold(&self, state: &State) -> [f64; 4] {
        [
            state.travel_m,
            state.slip_m_s,
            self.spring.unknown(state.plate_m),
            self.damper.unknown(state.plate_m_s),
        ]
    }

    /// Stages to start Newton's method from: the present values; but a force that is zero is where its law is flat, so
    /// there the plate is taken to ride on its spring under the contact force of the stage.
    fn guess(&self, y: &[f64; 4], h: f64) -> [[f64; 4]; 3] {
        NODES.map(|node| {
            let mut stage = *y;
            let t = node * h;
            stage[0] += y[1] * t;
            let state = State { travel_m: stage[0], ..self.state(y) };
            let motion = self.motion;
            let others = motion.spring.force(state.plate_m) + motion.stop.force(&state);
            let drive = motion.contact_force(&state) * motion.coupling - others;
            let mut speed = drive * motion.plate_mobility * t;
            if let (Carrier::Force(law), true) = (self.spring, y[2] == 0.0) {
                stage[2] = drive;
                speed = law.at_force(drive) / (law.exponent * t);
            }
            if let Carrier::Force(law) = self.damper {
                // By inertia, but not beyond where the damper alone holds against the drive, if it does not exceed it now.
                let by_inertia = law.force(state.plate_m_s + speed);
                let held_n = larger(drive.abs(), y[3].abs());
                let held = smaller(by_inertia.abs(), held_n) * sign(by_inertia);
                stage[3] = if by_inertia * drive > 0.0 { held } else { y[3] };
            }
            stage
        })
    }

    /// Stages of a plate that rides on its spring through the whole step, at the stage's contact force: where Newton's method has
    /// to change the side of zero, its own slopes, flat at zero, do not lead it there.
    fn riding(&self, y: &[f64; 4], h: f64) -> [[f64; 4]; 3] {
        NODES.map(|node| {
            let mut stage = *y;
            stage[0] += y[1] * node * h;
            let state = State { travel_m: stage[0], plate_m: 0.0, plate_m_s: 0.0, ..self.state(y) };
            let motion = self.motion;
            stage[2] = motion.contact_force(&state) * motion.coupling - motion.stop.force(&state);
            stage[3] = 0.0;
            stage
        })
    }

    /// dA/dq, by a central difference within the piece.
    fn area_slope(&self, q: f64) -> f64 {
        match self.motion.area {
            AreaLaw::None => 0.0,
            AreaLaw::Quadratic { origin_m, a } => a[1] + 2.0 * a[2] * (q - origin_m),
            AreaLaw::Partial { .. } => {
                let h = 1e-6 * self.motion.nose.radius_m;
                let area = |q: f64| self.motion.area.area_m2(&self.motion.nose, q);
                (area(q + h) - area(q - h)) / (2.0 * h)
            }
        }
    }
}

impl ImplicitSystem<4> for Unknowns<'_> {
    fn carried(&self, y: &[f64; 4]) -> [f64; 4] {
        [y[0], y[1], self.spring.unfold(y[2]).0, self.damper.unfold(y[3]).0]
    }

    fn carried_slope(&self, y: &[f64; 4]) -> [f64; 4] {
        [1.0, 1.0, self.spring.unfold(y[2]).1, self.damper.unfold(y[3]).1]
    }

    fn rate(&self, y: &[f64; 4]) -> [f64; 4] {
        let (motion, state) = (self.motion, self.state(y));
        let f = motion.contact_force(&state);
        let g = self.spring.unfold(y[2]).2 + self.damper.unfold(y[3]).2 + motion.stop.force(&state);
        let plate = g * motion.plate_mobility;
        [
            state.slip_m_s,
            motion.coupling * plate - f * motion.slip_mobility,
            state.plate_m_s,
            motion.coupling * f * motion.plate_mobility - plate,
        ]
    }

    fn jacobian(&self, y: &[f64; 4]) -> [[f64; 4]; 4] {
        let (motion, u) = (self.motion, y[1]);
        let pressure = motion.strength_pa + motion.drag_kg_m3 * u * u;
        let f_q = self.area_slope(y[0]) * pressure;
        let area = motion.area.area_m2(&motion.nose, y[0]);
        let f_u = 2.0 * area * motion.drag_kg_m3 * u;
        let (_, x_y, _, k_y) = self.spring.unfold(y[2]);
        let (_, w_y, _, d_y) = self.damper.unfold(y[3]);
        let g_x = k_y + motion.stop.stiffness_n_m * x_y;
        let g_w = d_y + motion.stop.damping_n_s_m * w_y;
        let (slip, plate) = (motion.slip_mobility, motion.plate_mobility);
        let pass = motion.coupling * plate;
        [
            [0.0, 1.0, 0.0, 0.0],
            [-f_q * slip, -f_u * slip, pass * g_x, pass * g_w],
            [0.0, 0.0, 0.0, w_y],
            [pass * f_q, pass * f_u, -plate * g_x, -plate * g_w],
        ]
    }

    fn scale(&self) -> [f64; 4] {
        self.scale
    }
}

impl Track<'_> {
    /// One implicit step, shortened to the first event.
    pub(super) fn stiff_step(&mut self) -> ControlFlow<EndReason, Option<Trigger>> {
        let motion = self.motion();
        let system = Unknowns {
            motion: &motion,
            spring: Carrier::of(motion.spring),
            damper: Carrier::of(Elastic::Power(motion.damper)),
            scale: self.stiff_scale(),
        };
        let y = system.fold(&self.state);
        let mut h = self.unit_s;
        let left = self.until_s() - self.t_s;
        let mut halvings = 0;
        for _ in 0..200 {
            h = if left < h { left } else { h };
            let tick = TICK * self.t_s;
            let at_tick = h <= tick;
            h = larger(h, tick);
            let solved = step::<4, 12>(&system, &y, h, system.guess(&y, h))
                .or_else(|| step::<4, 12>(&system, &y, h, [y; 3]))
                .or_else(|| {
                    let rides = matches!(system.spring, Carrier::Force(_));
                    rides.then(|| step::<4, 12>(&system, &y, h, system.riding(&y, h))).flatten()
                });
            self.evaluations += solved.as_ref().map_or(25, |step| step.iterations) * 3;
            let Some(solved) = solved else {
                if at_tick {
                    return ControlFlow::Break(EndReason::StepUnderflow);
                }
                h *= 0.25;
                self.rejected += 1;
                continue;
            };
            let tolerance = LOCAL * self.tolerance.powf(2.0 / 3.0);
            let factor = step_factor(solved.error, tolerance);
            // Within one tick of the clock a stiff force settles, whatever its way: the method is L-stable.
            if solved.error > tolerance && !at_tick {
                h *= smaller(factor, 0.9);
                self.rejected += 1;
                continue;
            }
            if self.creeps
                && !at_tick
                && halvings < HALVINGS_MAX
                && self.imbalance_j(&system, &solved, h).abs()
                    > UNBALANCED * self.tolerance * self.problem.energy_j
            {
                halvings += 1;
                h *= 0.5;
                self.rejected += 1;
                continue;
            }
            return self.accept(&system, &y, (h, factor), solved);
        }
        ControlFlow::Break(EndReason::StepUnderflow)
    }

    /// A plate that no longer creeps swings, and Taylor steps follow a swing with far fewer.
    fn notice_swings(&mut self, system: &Unknowns<'_>, y: &[f64; 4], h: f64) {
        let (motion, state) = (system.motion, &self.state);
        let stiffness = motion.stop.stiffness_n_m + motion.spring.tangent(state.plate_m).abs();
        let radians = (stiffness * motion.plate_mobility).sqrt() * h;
        let held_n =
            motion.damper.force(state.plate_m_s).abs() + motion.spring.force(state.plate_m).abs();
        let net_n = (system.rate(y)[3] / motion.plate_mobility).abs();
        let swings = radians < SWINGING_STEP && net_n > SWINGING * held_n;
        self.creeping_steps = if swings { self.creeping_steps + 1 } else { 0 };
        if self.creeping_steps > SWINGING_STEPS {
            self.creeping_steps = 0;
            self.stretch_steps = 0;
            (self.stiff, self.creeps) = (false, false);
        }
    }

    /// What the plate's energy is off by over a step, J: a plate that creeps has all of it in its spring, where errors of the
    /// displacement that do not matter to anything else show.
    fn imbalance_j(&self, system: &Unknowns<'_>, solved: &Step<4>, h: f64) -> f64 {
        let motion = system.motion;
        let spring = &self.problem.mechanism.spring;
        let energy = |state: &State| {
            0.5 * state.plate_m_s * state.plate_m_s / motion.plate_mobility
                + spring.energy(state.plate_m)
        };
        let mut gained = energy(&system.state(&solved.stages[2])) - energy(&self.state);
        for (stage, weight) in solved.stages.iter().zip(WEIGHTS) {
            let state = system.state(stage);
            let push_n = motion.coupling * motion.contact_force(&state)
                - motion.damper.force(state.plate_m_s)
                - motion.stop.force(&state);
            gained -= h * weight * push_n * state.plate_m_s;
        }
        gained
    }

    fn stiff_scale(&self) -> [f64; 4] {
        let speed = self.problem.velocity_m_s;
        let travel =
            self.state.travel_m.abs() + self.state.slip_m_s.abs() * self.unit_s + f64::MIN_POSITIVE;
        let joined = self.mode == Mode::Fused;
        let own_x = larger(self.plate_scale_m, f64::MIN_POSITIVE);
        let own_w = larger(self.speed_scale_m_s, f64::MIN_POSITIVE);
        [
            travel,
            // A slip far above the impact's, of a plate thrown by its spring, is known to its own rounding only.
            larger(speed, SLIP_ROUNDED * self.state.slip_m_s.abs()),
            if joined { own_x } else { travel + self.state.plate_m.abs() },
            if joined { own_w } else { speed + self.state.plate_m_s.abs() },
        ]
    }

    fn accept(
        &mut self,
        system: &Unknowns<'_>,
        y: &[f64; 4],
        (mut h, factor): (f64, f64),
        mut solved: Step<4>,
    ) -> ControlFlow<EndReason, Option<Trigger>> {
        let motion = system.motion;
        self.unit_s = h * factor;
        let mut fired = None;
        for (trigger, form) in self.guards().iter() {
            let end = system.state(&solved.stages[2]);
            if !falls(form, motion, &self.state, &end) {
                continue;
            }
            // Solve the step anew for each trial length: the end of a step is far more accurate than its inside.
            let value = |part: f64| {
                let trial = step::<4, 12>(system, y, part * h, system.guess(y, part * h));
                let at =
                    trial.map_or_else(|| interpolate(y, &solved, part), |trial| trial.stages[2]);
                form.at(motion, &system.state(&at))
            };
            let part = in_bracket(1e-12, 1.0, value);
            let landed = step::<4, 12>(system, y, part * h, system.guess(y, part * h));
            let variation = form.at(motion, &self.state) - form.at(motion, &end);
            let landed = landed.filter(|landed| {
                let at = system.state(&landed.stages[2]);
                form.at(motion, &at).abs() <= LANDED * variation + form.rounding(motion, &at)
            });
            if let Some(landed) = landed {
                (h, solved, fired) = (part * h, landed, Some(*trigger));
            } else if h <= CLOSEST * self.t_s {
                // No coming closer: the clock has no finer ticks.
                fired = Some(*trigger);
            } else {
                // Newton's method went astray on the way to the event: come closer first.
                self.unit_s = 0.25 * h;
                self.rejected += 1;
                return ControlFlow::Continue(None);
            }
        }
        let state = system.state(&solved.stages[2]);
        if !is_finite(&state) {
            return ControlFlow::Break(EndReason::NonFinite);
        }
        self.write_down(system, y, &solved, h);
        self.steps += 1;
        self.stiff_steps += 1;
        self.stretch_steps += 1;
        self.count_turns(system.rate(y)[3]);
        self.notice_swings(system, y, h);
        if self.stiff_steps > STIFF_STEPS_MAX {
            return ControlFlow::Break(EndReason::StepBudget);
        }
        self.arrive(self.t_s + h, state, motion, fired);
        ControlFlow::Continue(fired)
    }

    /// Work by the method's own quadrature, extremes at the stages, points to draw.
    fn write_down(&mut self, system: &Unknowns<'_>, y: &[f64; 4], solved: &Step<4>, h: f64) {
        let motion = system.motion;
        let mut record = std::mem::take(&mut self.record);
        let setting = self.setting(motion);
        for (stage, weight) in solved.stages.iter().zip(WEIGHTS) {
            let state = system.state(stage);
            record.worked(&setting, &state, h * weight);
            match self.mode {
                Mode::Penetrating => record.pressed(motion.contact_force(&state)),
                Mode::Fused => {
                    let force = motion.mechanism_force(&state);
                    record.carried(&setting, force, -force);
                }
                Mode::Closing | Mode::Withdrawing | Mode::FreeFlight | Mode::Perforated => {}
            }
        }
        if record.keep_series {
            for point in 1..=POINTS_PER_STEP {
                let s = point as f64 / (POINTS_PER_STEP + 1) as f64;
                let state = system.state(&interpolate(y, solved, s));
                record.point(&setting, self.t_s + s * h, &state, false);
            }
        }
        self.record = record;
    }
}

/// Whether a guard falls through zero over a step.
fn falls(form: &Form, motion: &Motion<'_>, from: &State, to: &State) -> bool {
    form.at(motion, from) > 0.0 && form.at(motion, to) <= 0.0
}
