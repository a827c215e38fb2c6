//! Conditioning of the end of a lumped contact.
//!
//! The contact ends where its force is zero. A contact that is stiffer than the spring carries a part of the spring's force, which can
//! have a multiple zero: the time of the end is then an ill-conditioned root, and two computations can agree by chance. It is unknown
//! within the time in which the force is within its error.

use crate::model::contact_models::ContactLaw;
use crate::model::impact::dense_output::DenseOutput;
use crate::model::impact::equations::Equations;
use crate::model::impact::method::IntegrationMethod;
use crate::model::impact::state::State;
use crate::numerics::event_location::{EventSearch, first_crossing};

/// Time from which on the force of a lumped contact that unloads is within its error, s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ContactEnd {
    pub(super) unresolved_from_s: Option<f64>,
}

impl ContactEnd {
    /// Follows a step.
    pub(super) fn step(&mut self, equations: &Equations<'_>, path: &DenseOutput<'_>) {
        let is_lumped = matches!(equations.setup.law, ContactLaw::Lumped(_));
        if !is_lumped || !equations.is_touching() {
            return;
        }
        let excess_n =
            |state: &State| equations.contact_n(state) - equations.contact_error_n(state);
        if equations.is_loading() || excess_n(path.end()) > 0.0 {
            self.unresolved_from_s = None;
            return;
        }
        let excesses_n = path.looks.each_ref().map(excess_n);
        let found = first_crossing(&[excesses_n], false, |part, _| excess_n(&path.at(part)));
        if let EventSearch::Fall(_, part) = found {
            self.unresolved_from_s = Some(path.at(part).t_s);
        }
        self.unresolved_from_s.get_or_insert(path.looks[0].t_s);
    }
}

impl Equations<'_> {
    /// Returns the error of the force of a lumped contact in the first computation of an error estimate, N.
    fn contact_error_n(&self, state: &State) -> f64 {
        let numerics = &self.setup.numerics;
        let tolerance = match numerics.method {
            IntegrationMethod::Second(first) => first,
            _ => numerics.tolerance,
        };
        let (by_travel, by_slip) = self.contact_slopes(state.q_m, state.u_m_s);
        let ([q_m, _], [u_m_s, _]) = self.error_scales(state);
        tolerance * (by_travel * q_m + by_slip * u_m_s)
    }
}
