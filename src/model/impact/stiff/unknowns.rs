//! The motion in the implicit method's unknowns: where a law's exponent is below one its force is the unknown (`Carrier`).

use crate::model::mechanism::{Elastic, PowerLaw, sign};
use crate::model::motion::{Motion, State};
use crate::numerics::implicit::{ImplicitSystem, NODES};
use crate::numerics::{larger, smaller};

/// The present motion in the implicit method's unknowns.
pub(super) struct Unknowns<'a> {
    pub(super) motion: &'a Motion<'a>,
    from_s: f64,
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
            Elastic::Power(law) if law.is_steep_at_zero() => Self::Force(law),
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
            Self::Argument(law) => (y, 1.0, law.force(y), law.tangent(y)),
            Self::Force(law) => {
                let z = law.at_force(y) * sign(y);
                let slope = if y == 0.0 { 0.0 } else { z / (law.exponent * y) };
                (z, slope, y, 1.0)
            }
        }
    }
}

impl<'a> Unknowns<'a> {
    pub(super) fn of(motion: &'a Motion<'a>, from: &State, scale: [f64; 4]) -> Self {
        let spring = Carrier::of(motion.spring);
        let damper = Carrier::of(Elastic::Power(motion.damper));
        Self { motion, from_s: from.t_s, spring, damper, scale }
    }

    /// The state of these unknowns, so long after the start of the step, s.
    pub(super) fn state(&self, y: &[f64; 4], after_s: f64) -> State {
        State {
            t_s: self.from_s + after_s,
            travel_m: y[0],
            slip_m_s: y[1],
            plate_m: self.spring.unfold(y[2]).0,
            plate_m_s: self.damper.unfold(y[3]).0,
        }
    }

    /// The unknowns of a state.
    pub(super) fn fold(&self, state: &State) -> [f64; 4] {
        [
            state.travel_m,
            state.slip_m_s,
            self.spring.unknown(state.plate_m),
            self.damper.unknown(state.plate_m_s),
        ]
    }

    /// Stages to start Newton's method from: the present values; but a force that is zero is where its law is flat, so
    /// there the plate is taken to follow its spring under the contact force of the stage.
    pub(super) fn guess(&self, y: &[f64; 4], h: f64) -> [[f64; 4]; 3] {
        NODES.map(|node| {
            let mut stage = *y;
            let t = node * h;
            stage[0] += y[1] * t;
            let state = State { travel_m: stage[0], ..self.state(y, t) };
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
                let rests_on_stop = smaller(by_inertia.abs(), held_n) * sign(by_inertia);
                stage[3] = if by_inertia * drive > 0.0 { rests_on_stop } else { y[3] };
            }
            stage
        })
    }
}

impl ImplicitSystem<4> for Unknowns<'_> {
    fn carried(&self, y: &[f64; 4]) -> [f64; 4] {
        [y[0], y[1], self.spring.unfold(y[2]).0, self.damper.unfold(y[3]).0]
    }

    fn carried_slope(&self, y: &[f64; 4]) -> [f64; 4] {
        [1.0, 1.0, self.spring.unfold(y[2]).1, self.damper.unfold(y[3]).1]
    }

    fn rate(&self, after: f64, y: &[f64; 4]) -> [f64; 4] {
        let (motion, state) = (self.motion, self.state(y, after));
        let (_, _, spring_n, _) = self.spring.unfold(y[2]);
        let g = spring_n + self.damper.unfold(y[3]).2 + motion.stop.force(&state);
        let (slip, plate) = motion.response(motion.contact_force(&state), g);
        [state.slip_m_s, slip, state.plate_m_s, plate]
    }

    fn jacobian(&self, y: &[f64; 4]) -> [[f64; 4]; 4] {
        let motion = self.motion;
        // No slope depends on the time.
        let [f_q, f_u] = motion.contact.slopes(&self.state(y, 0.0));
        let (_, x_y, _, k_y) = self.spring.unfold(y[2]);
        let (_, w_y, _, d_y) = self.damper.unfold(y[3]);
        let g_x = k_y + motion.stop.stiffness_n_m * x_y;
        let g_w = d_y + motion.stop.damping_n_s_m * w_y;
        let columns = [(f_q, 0.0), (f_u, 0.0), (0.0, g_x), (0.0, g_w)];
        let columns = columns.map(|(f, g)| motion.response(f, g));
        [
            [0.0, 1.0, 0.0, 0.0],
            columns.map(|(slip, _)| slip),
            [0.0, 0.0, 0.0, w_y],
            columns.map(|(_, plate)| plate),
        ]
    }

    fn scale(&self) -> [f64; 4] {
        self.scale
    }
}
