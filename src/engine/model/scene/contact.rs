//! The force between projectile and plate: which of the models of thesis section 8.2, what each of them needs, and the interface
//! that holds both together afterwards.

use crate::model::labelled_enum::labelled_enum;
use crate::model::scene::ContactModel::{HalfSine, Lumped};
use crate::model::variables::part::parts;

parts! {
    /// The interaction model and its parameters.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Contact at (contact) {
        pub model: ContactModel = ContactModel::Hydrodynamic => "model", "contact model",
            "how the force between projectile and plate is modelled", choice().source("thesis section 8.2 and Table 8.1");
        pub duration_s: Option<f64> = None => "t_d", "pulse duration", "duration of the half-sine force history",
            optional(Time, Positive, "auto").when(|scene| scene.contact.model == HalfSine)
            .source("thesis equation 8.9; auto: the hydrodynamic contact on a rigid mount");
        pub load_stiffness_n_m: Option<f64> = None => "k_load", "loading",
            "stiffness of the lumped interface while it is pressed in",
            optional(Stiffness, Positive, "auto").when(|scene| scene.contact.model == Lumped)
            .source("thesis Figure 8.6; auto: as deep as the hydrodynamic model on a rigid mount");
        pub unload_stiffness_n_m: Option<f64> = None => "k_unload", "unloading",
            "stiffness of the lumped interface while it springs back, k_load or more",
            optional(Stiffness, Positive, "auto").when(|scene| scene.contact.model == Lumped)
            .source("thesis Figure 8.6; auto: 100 k_load, an assumption");
        pub damping_n_s_m: f64 = 0.0 => "b_2", "interface damper", "damper of the lumped interface",
            number(Damping, NonNegative).own_name("interface_damping").is_log(true).when(|scene| scene.contact.model == Lumped)
            .source("thesis Figure 8.4; Wu has none");
        /// The listing of Appendix A.
        pub appendix: Listing = Listing::default();
    }

    /// The listing of Appendix A. Scenes run it as printed; its errors can be put right one by one, to see what each is worth.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Listing at (contact.appendix) {
        pub step_s: f64 = 1e-6 => "dt", "time step", "time step of the listing",
            number(Time, Positive).is_log(true).source("thesis Appendix A.1");
        /// A.2: depth subtracts the plate's whole motion, not its last increment only.
        pub corrects_coupling: bool = false;
        /// A.7 and A.9: the damper resists; printed, its force has no sign.
        pub corrects_damper: bool = false;
        /// A.2: contact ends where both velocities are equal, not below 0.01 m/s after a step.
        pub corrects_stopping: bool = false;
        /// A.5 and A.7: after a perforation the bodies part; printed, they stay joined.
        pub corrects_afterwards: bool = false;
        /// A.4 and A.8: Runge-Kutta for both bodies; printed, the force is held over the step.
        pub corrects_scheme: bool = false;
        /// A.2 to A.4: the force is resolved on the normal; printed, all of it acts on both bodies.
        pub corrects_obliquity: bool = false;
        /// A.2: the scripts' jumps are those that they are meant to be; printed, they are calls that come back, so that once the nose is
        /// buried the next lines overwrite the area and divide by tan(theta) = 0.
        pub corrects_jumps: bool = true;
    }

    /// The interface between projectile and plate after the first arrest.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Interface at (interface) {
        pub law: InterfaceLaw = InterfaceLaw::Fused => "interface", "interface law",
            "fused: joined for good once the projectile stops; plastic: carries forces up to its strength",
            choice().own_name("interface_law").aliases(&["law"]).source("fused: the thesis; plastic: a rigid-plastic interface");
        pub grip: f64 = 0.1 => "g", "grip", "it lets go above a pull of g x hole area x strength; 0.1 is a guess",
            number(Number, NonNegative).aliases(&["grip"])
            .used(|scene| scene.interface.law == InterfaceLaw::Plastic || scene.is_sprung()).source("assumption: 0.1");
    }
}

labelled_enum! {
    /// The interface between projectile and plate.
    pub enum InterfaceLaw: word {
        /// The thesis: once together, together for good.
        Fused = "fused",
        /// Rigid-plastic: pushes up to `A S_y`, pulls up to `g A S_y`.
        Plastic = "plastic",
    }

    /// How the force between projectile and plate is modelled.
    pub enum ContactModel: word {
        /// `F = A (S_y + C_d rho u²/2)`, thesis equation 8.4.
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

impl Listing {
    /// As printed, but for depth, damper and obliquity: depth follows from the whole relative travel, the damper resists, and both
    /// couplings have obliquity's cosine.
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
