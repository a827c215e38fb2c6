//! Swing of fused bodies on an undamped power law from one event to the next, by the balance of energy.
//!
//! Between the slips of a plastic interface, and always on a rigid one, nothing but the spring acts. With the energy E the next event is
//! known: the limit load of the interface, the turning point, or the singular zero of the spring. With k |x|^(n+1)/(n+1) = E sin² of the
//! phase, the velocity is in proportion to its cosine, and the time is an incomplete beta function.

use std::f64::consts::FRAC_PI_2;

use crate::model::impact::equations::Equations;
use crate::model::impact::loads::COMPRESSION_TENSION_SIGNS;
use crate::model::impact::method::IntegrationMethod;
use crate::model::impact::modes::{Contact, Event, PlateConstraint};
use crate::model::impact::state::State;
use crate::model::power_law::sign;
use crate::numerics::incomplete_beta::incomplete_beta;
use crate::numerics::root::bracketed_root;
use crate::numerics::{larger, smaller};

/// Swing in one direction, from a phase to another; the phase is -pi/2 at a turning point and pi/2 at the next.
#[derive(Debug)]
pub(super) struct FusedSwing {
    start: State,
    from: f64,
    to: f64,
    /// Phase at which the interface reaches its limit load in this direction, or a turning point.
    limit: f64,
    /// Time from the zero of the spring to the start, s.
    from_s: f64,
    /// Event at its end; `None` if it ends at the horizon.
    pub(super) event: Option<Event>,
    /// Displacement at the turning point, m, and velocity at the zero of the spring, m/s, both with the sign of the direction.
    far_m: f64,
    fastest_m_s: f64,
    /// Exponent of the spring plus one.
    power: f64,
}

impl Equations<'_> {
    /// Returns the swing from a state on, up to the horizon; `None` unless a power law alone acts on fused bodies.
    pub(super) fn fused_swing(&self, state: &State, horizon_s: f64) -> Option<FusedSwing> {
        let Equations { setup, mode } = self;
        let is_stepped = !matches!(
            setup.numerics.method,
            IntegrationMethod::Collocation(_) | IntegrationMethod::Second(_)
        );
        let is_fused = mode.contact == Contact::Fused && mode.hold == PlateConstraint::Free;
        if !is_fused || is_stepped {
            return None;
        }
        let law = setup.spring.power().filter(|law| !law.is_absent())?;
        let is_alone = self.is_undamped() && !setup.has_stop() && setup.weight_n == 0.0;
        let energy_j = self.energy_j(state);
        if !is_alone || setup.absorber.is_some() || energy_j <= 0.0 {
            return None;
        }
        let fastest_m_s = (2.0 * energy_j / self.moving_kg()).sqrt();
        // At a turning point the velocity can have the other sign by rounding.
        let direction = mode.w_side;
        let stored = (law.integral(state.x_m) / energy_j).sqrt() * sign(state.x_m);
        let from = (direction * stored).atan2(state.w_m_s.abs() / fastest_m_s);
        let (push_n, pull_n) = self.limit_loads_n(state);
        let (slips, limit_n, knot) = if direction > 0.0 {
            (Event::PushLimit, push_n, Event::KnotAhead)
        } else {
            (Event::PullLimit, pull_n, Event::KnotBehind)
        };
        let limit_m = law.at_force(limit_n / setup.interface_fraction());
        let limit_j = smaller(law.integral(limit_m), energy_j);
        let limit = larger((limit_j / energy_j).sqrt().asin(), from);
        let (event, to) = if from < 0.0 && !law.is_smooth_at_zero() {
            (knot, 0.0)
        } else if setup.interface.is_plastic && limit_j < energy_j {
            (slips, limit)
        } else {
            (Event::SpeedZero, FRAC_PI_2)
        };
        let mut swing = FusedSwing {
            start: *state,
            from,
            to,
            limit,
            from_s: 0.0,
            event: Some(event),
            far_m: direction * law.at_integral(energy_j),
            fastest_m_s: direction * fastest_m_s,
            power: law.exponent + 1.0,
        };
        swing.from_s = swing.since_zero_s(from);
        if swing.end().t_s <= horizon_s {
            return Some(swing);
        }
        let to = swing.phase(horizon_s);
        Some(FusedSwing { to, event: None, ..swing })
    }
}

impl FusedSwing {
    /// Returns the time from the zero of the spring to a phase, s: the integral of dx/w.
    fn since_zero_s(&self, phase: f64) -> f64 {
        let (sin, cos) = phase.sin_cos();
        let unit_s = self.far_m / (self.power * self.fastest_m_s);
        let squares = [sin * sin, cos * cos];
        sign(phase) * unit_s * incomplete_beta(squares, [1.0 / self.power, 0.5])
    }

    fn state(&self, phase: f64) -> State {
        let (sin, cos) = phase.sin_cos();
        State {
            t_s: self.start.t_s + (self.since_zero_s(phase) - self.from_s),
            x_m: sign(phase) * self.far_m * sin.abs().powf(2.0 / self.power),
            w_m_s: self.fastest_m_s * cos,
            ..self.start
        }
    }

    /// Returns the state at the end.
    pub(super) fn end(&self) -> State {
        self.state(self.to)
    }

    /// Returns the time at which the interface is first loaded beyond a limit load forwards (0) or backwards (1), s. Against the direction
    /// of motion it is loaded most at the start.
    pub(super) fn first_exceeded_s(&self, way: usize) -> f64 {
        let is_ahead = COMPRESSION_TENSION_SIGNS[way] * self.fastest_m_s > 0.0;
        if is_ahead { self.state(self.limit).t_s } else { self.start.t_s }
    }

    /// Returns the phase at a time, s.
    fn phase(&self, t_s: f64) -> f64 {
        bracketed_root(self.from, self.to, |phase| self.state(phase).t_s - t_s)
    }

    /// Returns the state at a fraction of the phase; at 1 to the last bit that at the end.
    pub(super) fn at(&self, fraction: f64) -> State {
        self.state((1.0 - fraction) * self.from + fraction * self.to)
    }

    /// Returns the state at a fraction of the time.
    pub(super) fn at_time(&self, fraction: f64) -> State {
        let lasts_s = self.end().t_s - self.start.t_s;
        self.state(self.phase(self.start.t_s + fraction * lasts_s))
    }

    /// Returns the maximum speed, m/s.
    pub(super) fn greatest_m_s(&self) -> f64 {
        if self.from <= 0.0 { self.fastest_m_s.abs() } else { self.start.w_m_s.abs() }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::model::impact::step_by;
    use crate::model::impact::tests::{is_near, look};
    use crate::model::run::RunSnapshot;
    use crate::model::variables::scene_with;

    /// On a linear spring x = a sin(r t), r² = k/M, up to the turning point or the limit load pi p (2 R - p) `S_y`, in tension a tenth.
    #[test]
    fn valid_a_swing_on_a_linear_spring_is_a_sine_up_to_the_limit_load() {
        let strength_n = std::f64::consts::PI / 300.0 * (0.0127 - 0.01 / 3.0) * 1.52e8;
        for (k, speed_m_s) in [(1e5, 20.0), (1e7, 20.0), (1e7, -20.0)] {
            let pairs = format!("gamma=1 k={k} interface=plastic");
            let direction = f64::signum(speed_m_s);
            let state = [5e-3, 0.0, 1e-4, speed_m_s];
            let (swing, fraction) = look(&pairs, Contact::Fused, state, |it, at| {
                let mut mode = it.mode.clone();
                mode.w_side = direction;
                let it = Equations { setup: it.setup, mode: &mode };
                (it.fused_swing(at, f64::INFINITY).unwrap(), it.setup.interface_fraction())
            });
            let rate = (k / 0.059f64).sqrt();
            let far_m = 1e-4f64.hypot(speed_m_s / rate);
            let limit_m = strength_n * if direction > 0.0 { 1.0 } else { 0.1 } / (fraction * k);
            let to_m = if limit_m < far_m { limit_m } else { far_m };
            let t_s = ((to_m / far_m).asin() - (direction * 1e-4 / far_m).asin()) / rate;
            let end = swing.end();
            assert_eq!(swing.event == Some(Event::SpeedZero), limit_m > far_m, "{k} {speed_m_s}");
            assert!(is_near(end.t_s - swing.start.t_s, t_s, 1e-12), "{k} {speed_m_s}");
            assert!(is_near(end.x_m, direction * to_m, 1e-13));
            let half_m = far_m * (0.5 * rate * t_s + (direction * 1e-4 / far_m).asin()).sin();
            assert!(is_near(swing.at_time(0.5).x_m, direction * half_m, 1e-12), "{k} {speed_m_s}");
            assert_eq!(swing.at(1.0).t_s.to_bits(), end.t_s.to_bits(), "{k} {speed_m_s}");
        }
    }

    /// Steps through the same motions end as these swings.
    #[test]
    fn valid_swings_end_where_steps_do() {
        for pairs in ["n=0.5 k=3e5 gamma=0.8", "n=0.3 k=1e5", "n=2 k=1e9", "n=5 k=1e17 theta=20deg"]
        {
            let scene = Arc::new(scene_with(&format!("{pairs} interface=plastic")));
            let by = |method| {
                let go_on = &mut |_: &RunSnapshot<'_>| std::ops::ControlFlow::Continue(());
                step_by(method, &scene, go_on).unwrap().unwrap()
            };
            let swung = by(IntegrationMethod::Collocation(1e-12));
            let stepped = by(IntegrationMethod::Dop853(1e-13));
            assert_eq!((swung.outcome, swung.cost.events), (stepped.outcome, stepped.cost.events));
            let depths = [&swung, &stepped].map(|run| run.penetration.final_m.unwrap());
            assert!(is_near(depths[0], depths[1], 1e-10), "{pairs} {depths:?}");
            assert!(swung.ledger.residual().abs() < 1e-11, "{pairs}");
            assert!(swung.cost.rhs_evaluations < stepped.cost.rhs_evaluations, "{pairs}");
        }
    }
}
