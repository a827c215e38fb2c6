//! The motion in the implicit method's unknowns.
//!
//! Where a law's exponent is below one its force is the unknown (`Carrier`). Where the plate touches an elastic stop that is far
//! from the spring's zero, its displacement is measured from the stop: the stop's force is the stiffness times a small difference
//! that is lost in the rounding of the displacement itself.

use crate::model::mechanism::{Elastic, PowerLaw, sign};
use crate::model::motion::{ElasticForce, Motion, State};
use crate::numerics::implicit::{ImplicitSystem, NODES, Unfolded};
use crate::numerics::{larger, smaller};

/// Part of the displacement up to which the stop's deflection is measured by itself.
const ON_STOP: f64 = 0.5;

/// The present motion in the implicit method's unknowns.
pub(super) struct Unknowns<'a> {
    pub(super) motion: &'a Motion<'a>,
    from_s: f64,
    spring: Carrier<'a>,
    damper: Carrier<'a>,
    /// From where the plate's displacement is measured, m.
    datum_m: f64,
    scale: [f64; 4],
}

/// Whether a law's unknown is its argument or its force.
#[derive(Clone, Copy)]
enum Carrier<'a> {
    /// x itself, from a datum on; the force follows.
    Argument(Elastic<'a>, f64),
    /// The force; x = sgn (|force|/k)^(1/n) follows.
    Force(PowerLaw),
}

impl<'a> Carrier<'a> {
    fn of(law: Elastic<'a>) -> Self {
        match law {
            Elastic::Power(law) if law.is_steep_at_zero() => Self::Force(law),
            Elastic::Power(_) | Elastic::Piece(_) => Self::Argument(law, 0.0),
        }
    }

    /// The unknown of an argument, and what rounding has omitted from that.
    fn unknown(self, z: f64, compensation: f64) -> f64 {
        match self {
            Self::Argument(_, datum) => (z - datum) + compensation,
            Self::Force(law) => law.force(z),
        }
    }

    /// The argument, from the datum on, by the unknown.
    fn unfold(self, y: f64) -> Unfolded {
        match self {
            Self::Argument(law, datum) => {
                let z = datum + y;
                Unfolded { value: y, slope: 1.0, force: law.force(z), force_slope: law.tangent(z) }
            }
            Self::Force(law) => {
                let value = law.at_force(y) * sign(y);
                let slope = if y == 0.0 { 0.0 } else { value / (law.exponent * y) };
                Unfolded { value, slope, force: y, force_slope: 1.0 }
            }
        }
    }
}

impl<'a> Unknowns<'a> {
    pub(super) fn of(motion: &'a Motion<'a>, from: &State, scale: [f64; 4]) -> Self {
        let (stop, plate_m) = (motion.stop, from.plate_m);
        let on_stop =
            stop.stiffness_n_m > 0.0 && (plate_m - stop.slack_m).abs() < ON_STOP * plate_m.abs();
        let datum_m = if on_stop { stop.slack_m } else { 0.0 };
        let spring = if on_stop {
            Carrier::Argument(motion.spring, datum_m)
        } else {
            Carrier::of(motion.spring)
        };
        let damper = Carrier::of(Elastic::Power(motion.damper));
        Self { motion, from_s: from.t_s, spring, damper, datum_m, scale }
    }

    /// The state of these unknowns, so long after the start of the step, s.
    pub(super) fn state(&self, y: &[f64; 4], after_s: f64) -> State {
        State {
            t_s: self.from_s + after_s,
            travel_m: y[0],
            slip_m_s: y[1],
            plate_m: self.datum_m + self.spring.unfold(y[2]).value,
            plate_m_s: self.damper.unfold(y[3]).value,
        }
    }

    /// The unknowns of a state whose displacement rounding has left so much out of, m.
    pub(super) fn fold(&self, state: &State, compensation_m: f64) -> [f64; 4] {
        [
            state.travel_m,
            state.slip_m_s,
            self.spring.unknown(state.plate_m, compensation_m),
            self.damper.unknown(state.plate_m_s, 0.0),
        ]
    }

    /// The part of the displacement that rounding omits from the state with these unknowns, m.
    pub(super) fn compensation_m(&self, y: &[f64; 4]) -> f64 {
        let z = self.spring.unfold(y[2]).value;
        z - ((self.datum_m + z) - self.datum_m)
    }

    fn stop_n(&self, x_from_datum: f64, w: f64) -> f64 {
        let stop = self.motion.stop;
        ElasticForce { slack_m: stop.slack_m - self.datum_m, ..stop }.force(x_from_datum, w)
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
            let others = motion.spring.force(state.plate_m) + motion.stop_force(&state);
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
                let bounded = smaller(by_inertia.abs(), held_n) * sign(by_inertia);
                stage[3] = if by_inertia * drive > 0.0 { bounded } else { y[3] };
            }
            stage
        })
    }
}

impl ImplicitSystem<4> for Unknowns<'_> {
    fn carried(&self, y: &[f64; 4]) -> [f64; 4] {
        [y[0], y[1], self.spring.unfold(y[2]).value, self.damper.unfold(y[3]).value]
    }

    fn carried_slope(&self, y: &[f64; 4]) -> [f64; 4] {
        [1.0, 1.0, self.spring.unfold(y[2]).slope, self.damper.unfold(y[3]).slope]
    }

    fn rate(&self, after: f64, y: &[f64; 4]) -> [f64; 4] {
        let (motion, state) = (self.motion, self.state(y, after));
        let spring = self.spring.unfold(y[2]);
        let damper_n = self.damper.unfold(y[3]).force;
        let g = spring.force + damper_n + self.stop_n(spring.value, state.plate_m_s);
        let rates = motion.response(motion.contact_force(&state), g);
        [state.slip_m_s, rates.slip_m_s2, state.plate_m_s, rates.plate_m_s2]
    }

    fn jacobian(&self, y: &[f64; 4]) -> [[f64; 4]; 4] {
        let motion = self.motion;
        // No slope depends on the time.
        let [f_q, f_u] = motion.contact.slopes(&self.state(y, 0.0));
        let (x, w) = (self.spring.unfold(y[2]), self.damper.unfold(y[3]));
        let g_x = x.force_slope + motion.stop.stiffness_n_m * x.slope;
        let g_w = w.force_slope + motion.stop.damping_n_s_m * w.slope;
        let columns = [(f_q, 0.0), (f_u, 0.0), (0.0, g_x), (0.0, g_w)];
        let columns = columns.map(|(f, g)| motion.response(f, g));
        [
            [0.0, 1.0, 0.0, 0.0],
            columns.map(|column| column.slip_m_s2),
            [0.0, 0.0, 0.0, w.slope],
            columns.map(|column| column.plate_m_s2),
        ]
    }

    fn scale(&self) -> [f64; 4] {
        self.scale
    }
}
