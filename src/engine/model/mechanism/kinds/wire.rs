//! Wire of coil springs, and the treatment of the springs' own mass.

use super::{Spring, parts};
use crate::model::labelled_enum::labelled_enum;

parts! {
    /// Wire of a coil spring: spring steel.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Wire at (mechanism.spring: Spring.wire) {
        pub density_kg_m3: f64 = 7850.0 => "rho_wire", "wire density", "density of the wire",
            number(Density, Positive).is_seldom(true).source("spring steel");
        pub shear_modulus_pa: f64 = 79.3e9 => "G_wire", "shear modulus", "shear modulus of the wire",
            number(Pressure, Positive).is_seldom(true).source("spring steel");
        pub shear_strength_pa: f64 = 700e6 => "tau_wire", "wire strength", "shear stress the wire may have",
            number(Pressure, Positive).is_seldom(true).source("spring steel");
    }
}

labelled_enum! {
    /// Treatment of the springs' own mass.
    pub enum OwnMass: word {
        Ignored = "ignored",
        /// The moving fraction adds to the plate's mass.
        Counted = "counted",
    }
}

impl Wire {
    /// Returns the maximum stored energy of a helical spring over the mass of its active coils, tau²/(4 rho G), J/kg, for any stiffness.
    pub fn specific_energy_j_kg(&self) -> f64 {
        let Self { density_kg_m3, shear_modulus_pa, shear_strength_pa: tau } = self;
        tau * tau / (4.0 * density_kg_m3 * shear_modulus_pa)
    }
}
