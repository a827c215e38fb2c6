//! Force between projectile and plate: the models of thesis section 8.2, their parameters, and the interface after the first arrest.

use crate::model::labelled_enum::labelled_enum;
use crate::model::scene::bodies::{Plate, is_sprung};
use crate::model::variables::part::{part, parts};

parts! {
    /// Contact model and its parameters.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Contact at (contact: Contact) {
        pub model: ContactModel = ContactModel::Hydrodynamic => "model", "contact model",
            "how the force between projectile and plate is modelled", choice().source("thesis section 8.2 and Table 8.1");
        pub duration_s: Option<f64> = None => "t_d", "pulse duration", "duration of the half-sine force history",
            optional(Time, Positive, "auto").when(|scene| part::<Contact>(scene).model == ContactModel::HalfSine)
            .source("thesis equation 8.9; auto: the hydrodynamic contact on a rigid mount");
        pub load_stiffness_n_m: Option<f64> = None => "k_load", "loading",
            "stiffness of the lumped interface while it is pressed in",
            optional(Stiffness, Positive, "auto").when(|scene| part::<Contact>(scene).model == ContactModel::Lumped)
            .source("thesis Figure 8.6; auto: as deep as the hydrodynamic model on a rigid mount");
        pub unload_stiffness_n_m: Option<f64> = None => "k_unload", "unloading",
            "stiffness of the lumped interface while it springs back, k_load or more",
            optional(Stiffness, Positive, "auto").when(|scene| part::<Contact>(scene).model == ContactModel::Lumped)
            .source("thesis Figure 8.6; auto: 100 k_load, an assumption");
        pub damping_n_s_m: f64 = 0.0 => "b_2", "interface damper", "damper of the lumped interface",
            number(Damping, NonNegative).own_name("interface_damping").is_log(true).when(|scene| part::<Contact>(scene).model == ContactModel::Lumped)
            .source("thesis Figure 8.4; Wu has none");
        /// Listing of Appendix A.
        pub appendix: Listing = Listing::default();
    }

    /// Listing of Appendix A. Scenes run it as printed. Each of its errors can be corrected separately, to find its effect.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Listing at (contact: Contact.appendix) {
        pub step_s: f64 = 1e-6 => "dt", "time step", "time step of the listing",
            number(Time, Positive).is_log(true).source("thesis Appendix A.1");
        /// A.2: depth subtracts the whole motion of the plate; printed, the last increment only.
        pub corrects_coupling: bool = false;
        /// A.7 and A.9: the damper resists the motion; printed, its force has no sign.
        pub corrects_damper: bool = false;
        /// A.2: contact ends at equal velocities; printed, after a step with a relative velocity below 0.01 m/s.
        pub corrects_stopping: bool = false;
        /// A.5 and A.7: the bodies separate after a perforation; printed, they stay joined.
        pub corrects_afterwards: bool = false;
        /// A.4 and A.8: Runge-Kutta for both bodies; printed, the force is constant over the step.
        pub corrects_scheme: bool = false;
        /// A.2 to A.4: only the normal component of the force acts on the plate; printed, the whole force acts on both bodies.
        pub corrects_obliquity: bool = false;
        /// A.2: the scripts' jumps work as intended. Printed, they are calls that return: once the nose is buried, the next lines overwrite
        /// the area and divide by tan(theta) = 0.
        pub corrects_jumps: bool = true;
    }

    /// Interface between projectile and plate after the first arrest.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Interface at (interface: Interface) reads(Plate) {
        pub law: InterfaceLaw = InterfaceLaw::Fused => "interface", "interface law",
            "fused: joined for good once the projectile stops; plastic: carries forces up to its strength",
            choice().own_name("interface_law").aliases(&["law"]).source("fused: the thesis; plastic: a rigid-plastic interface");
        pub grip: f64 = 0.1 => "g", "grip", "it lets go above a pull of g x hole area x strength; 0.1 is a guess",
            number(Number, NonNegative).aliases(&["grip"])
            .used(|scene| part::<Interface>(scene).law == InterfaceLaw::Plastic || is_sprung(scene)).source("assumption: 0.1");
    }
}

labelled_enum! {
    /// Law of the interface between projectile and plate.
    pub enum InterfaceLaw: word {
        /// Fused, as in the thesis: the bodies stay joined after the first arrest.
        Fused = "fused",
        /// Rigid-plastic: limit load `A S_y` in compression, `g A S_y` in tension.
        Plastic = "plastic",
    }

    /// Model of the force between projectile and plate.
    pub enum ContactModel: word {
        /// `F = A (S_y + C_d rho u²/2)`, thesis equation 8.4.
        Hydrodynamic = "hydrodynamic",
        /// Prescribed half-sine force history, equation 8.9.
        HalfSine = "half-sine",
        /// Instantaneous perfectly inelastic collision, equation 8.11.
        InitialVelocity = "initial-velocity",
        /// Spring with hysteresis and damper between projectile and plate, Figures 8.4 to 8.8.
        Lumped = "lumped",
        /// Listing of Appendix A.
        Appendix = "appendix",
    }
}

impl ContactModel {
    /// Returns `true` for a model that knows the plate's rear face, and so whether a shot perforates.
    pub fn knows_perforation(self) -> bool {
        matches!(self, Self::Hydrodynamic | Self::Appendix)
    }
}

impl Listing {
    /// Creates the printed listing with corrected depth, damper and obliquity: depth follows from the whole relative travel, the damper
    /// resists, and both couplings include the cosine of the obliquity.
    pub fn coupled(step_s: f64) -> Self {
        Self {
            step_s,
            corrects_coupling: true,
            corrects_damper: true,
            corrects_obliquity: true,
            ..Self::default()
        }
    }
}

/// Returns `true` for the listing of Appendix A.
pub(in crate::model) fn is_listing(scene: &impl AsRef<Contact>) -> bool {
    scene.as_ref().model == ContactModel::Appendix
}

/// Returns `true` if the projectile penetrates. The depth then depends on the plate's thickness.
pub(super) fn penetrates(scene: &impl AsRef<Contact>) -> bool {
    scene.as_ref().model != ContactModel::InitialVelocity
}

/// Returns `true` if the plate's resistance has an effect. Other contact models use it only for missing values.
pub(in crate::model) fn resists(scene: &impl AsRef<Contact>) -> bool {
    let contact = scene.as_ref();
    match contact.model {
        ContactModel::HalfSine => contact.duration_s.is_none(),
        ContactModel::Lumped => contact.load_stiffness_n_m.is_none(),
        ContactModel::InitialVelocity => false,
        ContactModel::Hydrodynamic | ContactModel::Appendix => true,
    }
}
