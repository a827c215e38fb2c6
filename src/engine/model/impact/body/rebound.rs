//! What the way back asks of a fused interface, after the end of a run: the plate comes back, and beyond neutral its mechanism
//! holds it by the projectile's inertia.

use super::Body;
use crate::numerics::larger;

/// Steps of the way back; the greatest tension comes out right to some hundredths.
const STEPS: u32 = 32;

impl Body<'_> {
    /// The greatest tension of the fused interface on the way back from the greatest displacement, N; `None` where no such way is
    /// known: a plate that rests or meets a rigid stop, whose hit no fused interface carries, and absorbers, which are not
    /// unloaded yet.
    pub(in crate::model::impact) fn rebound_pull_n(&self, farthest_m: f64) -> Option<f64> {
        let mechanism = &self.problem.mechanism;
        if self.fixed && mechanism.damper.is_absent() {
            // The spring swings by what the contact has pressed it, however little that is.
            return Some(self.problem.interface_fraction * self.interface_n() * self.problem.cos);
        }
        let meets_stop = mechanism.rigid_stop().is_some() && farthest_m >= mechanism.stop_at_m;
        if self.is_still() || meets_stop || self.problem.has_absorber() {
            return None;
        }
        let at_most_n = self.pull_at(self.energy_j());
        let is_damped = !mechanism.damper.is_absent() || mechanism.elastic_stop().is_some();
        let is_little = at_most_n <= self.interface_limits_n().1;
        let damped_n = if is_little || !is_damped { None } else { self.damped_pull_n(farthest_m) };
        Some(damped_n.map_or(at_most_n, |pull_n| self.problem.interface_fraction * pull_n))
    }

    /// The greatest pull on a plate that its damper slows down, N, by its energy from place to place; `None` where no spring ends
    /// its way.
    fn damped_pull_n(&self, farthest_m: f64) -> Option<f64> {
        let mechanism = &self.problem.mechanism;
        let from_m = if self.state.plate_m_s < 0.0 { self.state.plate_m } else { farthest_m };
        let mut energy_j = larger(self.energy_j(), self.potential_j(from_m));
        let back_m = mechanism.spring.backward(from_m, energy_j);
        let back_m = Some(back_m).filter(|back_m| back_m.is_finite())?;
        let step_m = (from_m + back_m) / f64::from(STEPS);
        let (mut pull_n, mut lost_j, mut creeps) = (0.0, 0.0, false);
        for step in 0..STEPS {
            // In the middle of the step, where the last one has lost half as much again.
            let x_m = from_m - (f64::from(step) + 0.5) * step_m;
            let spring_n = mechanism.spring.force(x_m);
            let moving_j = larger(energy_j - 0.5 * lost_j - self.potential_j(x_m), 0.0);
            let damper_n = mechanism.damper.force((2.0 * moving_j / self.moving_kg()).sqrt());
            lost_j = damper_n * step_m;
            if lost_j < moving_j {
                pull_n = larger(pull_n, damper_n - spring_n);
                (energy_j, creeps) = (energy_j - lost_j, false);
            } else if spring_n > 0.0 {
                // Spring and damper hold each other.
                (energy_j, lost_j, creeps) = (self.potential_j(x_m), 0.0, true);
            } else {
                // What creeps comes to rest at neutral; what does not has gone as far back as it can.
                return Some(if creeps { pull_n } else { larger(pull_n, -spring_n) });
            }
        }
        Some(pull_n)
    }
}

#[cfg(test)]
mod tests {
    use crate::model::impact::problem::Problem;
    use crate::model::impact::simulation::Simulation;
    use crate::model::run::Mode;

    /// At its greatest displacement, 30 mm, with the joined mass of 59 g.
    fn pull_n(pairs: &str) -> Option<f64> {
        let problem = Problem::with(pairs);
        Simulation::at(&problem, Mode::Fused, [4e-3, 0.0, 0.03, 0.0]).body.rebound_pull_n(0.03)
    }

    /// From rest at x0 a damped oscillator accelerates by -w0² x0 exp(-d t) (cos(wt) - d/w sin(wt)); its greatest pull forward.
    fn pull_of_oscillator_n(k: f64, b: f64) -> f64 {
        let (mass, x0) = (0.059, 0.03);
        let (decay, natural) = (b / (2.0 * mass), k / mass);
        let w = (natural - decay * decay).sqrt();
        let at = |t: f64| {
            let swing = (w * t).cos() - decay / w * (w * t).sin();
            -natural * x0 * (-decay * t).exp() * swing
        };
        let times = (0..20_000).map(|i| f64::from(i) * 1e-4 * std::f64::consts::PI / w);
        0.0295 * times.map(at).fold(0.0, f64::max)
    }

    #[test]
    fn the_way_back_pulls_as_a_damped_oscillator_does() {
        assert_eq!(pull_n("k=1e5"), Some(0.5 * 1e5 * 0.03));
        for b in [10.0, 40.0, 80.0] {
            let expected = pull_of_oscillator_n(1e5, b);
            // Whatever is asked: little strength, so that no bound comes before.
            let found = pull_n(&format!("k=1e5 b={b} S_y=1e6")).unwrap();
            assert!((found / expected - 1.0).abs() < 0.04, "b={b}: {found} {expected}");
        }
    }

    #[test]
    fn there_is_no_way_back_where_nothing_swings() {
        assert_eq!(pull_n("k=1e5 b=2e4 S_y=1e6"), Some(0.0));
        assert_eq!(pull_n("mount=rigid"), None);
        assert_eq!(pull_n("k=1e5 x_stop=0.03"), None);
        assert!(pull_n("k=1e5 x_stop=0.031").is_some());
    }
}
