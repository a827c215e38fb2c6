//! The part of a scene that says how the force between projectile and plate is modelled: which of the models of thesis
//! section 8.2, and what each of them needs. Which variables matter to which model is told by `variables.rs`.

use crate::model::worded::worded;

/// The interaction model and its parameters.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Contact {
    /// Which model.
    pub model: ContactModel,
    /// `t_d` > 0, duration of the half-sine force history, s; `None`: that of the hydrodynamic contact on a rigid mount.
    pub duration_s: Option<f64>,
    /// `k_load` > 0 of the lumped interface, N/m; `None`: such that on a rigid mount it is pressed in as far as the
    /// hydrodynamic model penetrates there.
    pub load_stiffness_n_m: Option<f64>,
    /// `k_unload` >= `k_load`, N/m; `None`: a hundred times `k_load`.
    pub unload_stiffness_n_m: Option<f64>,
    /// `b_2` >= 0, damper of the lumped interface, N s/m.
    pub damping_n_s_m: f64,
    /// How the listing of Appendix A is read.
    pub appendix: Listing,
}

worded! {
    /// How the force between projectile and plate is modelled.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum ContactModel: word {
        /// `F = A (S_y + C_d rho u²/2)`, thesis equation 8.4.
        #[default]
        Hydrodynamic = "hydrodynamic",
        /// A prescribed half-sine force history, equation 8.9.
        HalfSine = "half-sine",
        /// A perfectly inelastic collision at once, equation 8.11.
        InitialVelocity = "initial-velocity",
        /// A spring with hysteresis and a damper between projectile and plate, Figures 8.4 to 8.8.
        Lumped = "lumped",
        /// The listing of Appendix A.
        Appendix = "appendix",
    }
}

worded! {
    /// How one doubtful place of the listing is read.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum Reading: word {
        /// As it is printed.
        #[default]
        Printed = "printed",
        /// Put right.
        Corrected = "corrected",
    }
}

worded! {
    /// What becomes of the area once the nose is buried.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum Jumps: word {
        /// The scripts' jumps do what they are meant to: the area stays that of the full section.
        #[default]
        Meant = "meant",
        /// They are calls that come back: the next lines overwrite the area, and divide by tan(theta) = 0.
        Ignored = "ignored",
    }
}

/// The listing of Appendix A, quirk by quirk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Listing {
    /// `dt` > 0, s.
    pub step_s: f64,
    /// Printed: depth subtracts the plate's last increment only; corrected: the whole relative travel.
    pub coupling: Reading,
    /// Printed: `b |w|^m` without a sign; corrected: it resists.
    pub damper: Reading,
    /// Printed: ends below 0.01 m/s, after the step; corrected: common velocity is located within the step.
    pub stopping: Reading,
    /// Printed: projectile and plate move as one afterwards, whatever happened; corrected: not after a perforation.
    pub afterwards: Reading,
    /// Printed: force held over the step, Euler and trapezoid for the projectile; corrected: Runge-Kutta for both bodies.
    pub scheme: Reading,
    /// Printed: the same force on both bodies; corrected: resolved along the plate's normal.
    pub obliquity: Reading,
    /// Whether the scripts' jumps are heeded.
    pub jumps: Jumps,
}

impl Default for Listing {
    fn default() -> Self {
        Self::read(1e-6, Reading::Printed)
    }
}

impl Listing {
    /// As printed, but for depth, damper and obliquity, which are read so: corrected, depth follows from the whole relative travel, the
    /// damper resists, and both couplings have obliquity's cosine.
    pub fn coupled(step_s: f64, reading: Reading) -> Self {
        let printed = Self::read(step_s, Reading::Printed);
        Self { coupling: reading, damper: reading, obliquity: reading, ..printed }
    }

    /// Everything put right that can be, with the same step.
    pub fn corrected(step_s: f64) -> Self {
        Self::read(step_s, Reading::Corrected)
    }

    /// Every place read alike.
    fn read(step_s: f64, reading: Reading) -> Self {
        Self {
            step_s,
            coupling: reading,
            damper: reading,
            stopping: reading,
            afterwards: reading,
            scheme: reading,
            obliquity: reading,
            jumps: Jumps::Meant,
        }
    }
}
