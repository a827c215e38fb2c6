//! Helical spring that rotates the plate.

use super::{Law, NO_VALUES, PowerLaw, Spring, parts};

parts! {
    /// Linear spring with geared rotation of the plate.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Helix at (mechanism.spring: Spring.helix) {
        pub stiffness_n_m: f64 = 1e5 => "k_helix", "helix stiffness", "axial stiffness of the helical rotating spring",
            number(Stiffness, NonNegative).is_log(true).source(NO_VALUES);
        pub twist_rad_m: f64 = 50.0 => "twist", "twist", "turn of the plate per displacement", number(Twist, Any);
        pub inertia_kg_m2: f64 = 5e-6 => "I_z", "inertia",
            "moment of inertia of what turns: the plate gains I_z twist^2",
            number(Inertia, NonNegative).is_log(true).source("thesis section 6.2.7; values are assumptions");
    }
}

impl Law for Helix {
    fn power_law(&self, spring: &Spring) -> Option<PowerLaw> {
        Some(PowerLaw { coefficient: self.stiffness_n_m * spring.count, exponent: 1.0 })
    }

    fn rotation_kg(&self) -> f64 {
        self.inertia_kg_m2 * self.twist_rad_m * self.twist_rad_m
    }
}
