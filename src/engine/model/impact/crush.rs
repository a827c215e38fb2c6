//! Absorbers that are crushed: they unload elastically from where they were crushed to.
//!
//! While the plate goes forward an absorber's law is a curve like any other. When the plate no longer does, the law begins again
//! from the greatest displacement: the elastic rise is shifted there, and what was spent on the way is dissipated.

use std::sync::OnceLock;

use crate::model::impact::problem::Problem;
use crate::model::impact::simulation::Simulation;
use crate::model::impact::straight_core::with_straight_core;
use crate::model::mechanism::Spring;

impl Problem {
    pub(super) fn has_absorber(&self) -> bool {
        let sprung = self.mechanism.spring.curve().is_some();
        sprung && self.scene.mechanism.spring.law().absorber().is_some()
    }

    /// The impact with its absorber as it was at first contact, for another run.
    pub(super) fn anew(&self) -> Self {
        Self { next: OnceLock::new(), ..self.clone() }
    }

    /// How far the absorber is crushed when the plate turns at x; `None` where that is no farther than before.
    fn crushed_by(&self, x: f64) -> Option<f64> {
        let absorber = self.scene.mechanism.spring.law().absorber()?;
        absorber.crushed_by(x, self.crushed_m)
    }

    /// The spring after its absorber was crushed up to x; `None` where that is no farther than before.
    pub(super) fn unloaded_spring(&self, x: f64) -> Option<Spring> {
        let crushed_m = if self.has_absorber() { self.crushed_by(x) } else { None };
        crushed_m
            .map(|crushed_m| with_straight_core(Spring::after(&self.scene.mechanism, crushed_m)))
    }

    /// The same impact with its absorber crushed so far.
    fn crushed(&self, crushed_m: f64) -> &Self {
        self.next.get_or_init(|| {
            let mut own = self.anew();
            own.mechanism.spring =
                with_straight_core(Spring::after(&own.scene.mechanism, crushed_m));
            own.crushed_m = crushed_m;
            Box::new(own)
        })
    }
}

impl Simulation<'_> {
    /// A plate that no longer goes forward unloads the absorber it has crushed from where it is; the energy spent on crushing it is
    /// dissipated.
    pub(super) fn unload_absorbers(&mut self) {
        if self.body.state.plate_m_s > 0.0 || !self.body.problem.has_absorber() {
            return;
        }
        let x = self.body.state.plate_m;
        let Some(crushed_m) = self.body.problem.crushed_by(x) else { return };
        (_, self.record.work.crush_j) = self.spring_energies();
        self.body.problem = self.body.problem.crushed(crushed_m);
        let spring = &self.body.problem.mechanism.spring;
        self.body.region = spring.curve().map_or(0, |curve| curve.region_below(x));
    }

    /// Energy that the springs give back from here, and that crushing has taken so far, J.
    pub(super) fn spring_energies(&self) -> (f64, f64) {
        let (problem, x) = (self.body.problem, self.body.state.plate_m);
        let crushed_j = self.record.work.crush_j;
        let stored_j = problem.mechanism.spring.energy(x);
        problem.unloaded_spring(x).map_or((stored_j, crushed_j), |unloaded| {
            let elastic_j = unloaded.energy(x);
            (elastic_j, crushed_j + stored_j - elastic_j)
        })
    }
}
