//! The force between projectile and plate, what holds them together, and how the run is computed.

use crate::model::scene::{ContactModel, InterfaceLaw, Jumps, Reading};
use crate::model::units::Quantity;
use crate::model::variables::visible::{Visible, is_hydrodynamic, is_listing};
use crate::model::variables::{Allowed, Choice, Group, Kind, Number, Variable};

/// A quirk of the listing: printed or corrected.
macro_rules! quirk {
    ($field:ident, $symbol:literal, $label:literal, $meaning:literal, $where:literal) => {
        choice!(Reading, contact.appendix.$field)
            .named($symbol, $label)
            .when(is_listing)
            .means($meaning)
            .from(concat!("thesis Appendix ", $where))
    };
}

pub(super) const ROWS: &[Variable] = &[
    choice!(ContactModel, contact.model)
        .named("model", "contact model")
        .means("how the force between projectile and plate is modelled")
        .from("thesis section 8.2 and Table 8.1"),
    optional!(Time, Allowed::Positive, "auto", contact.duration_s)
        .named("t_d", "pulse duration")
        .when(|scene| scene.contact.model == ContactModel::HalfSine)
        .means("duration of the half-sine force history")
        .from("thesis equation 8.9; auto: the hydrodynamic contact on a rigid mount"),
    optional!(Stiffness, Allowed::Positive, "auto", contact.load_stiffness_n_m)
        .named("k_load", "loading")
        .when(|scene| scene.contact.model == ContactModel::Lumped)
        .means("stiffness of the lumped interface while it is pressed in")
        .from("thesis Figure 8.6; auto: as deep as the hydrodynamic model on a rigid mount"),
    optional!(Stiffness, Allowed::Positive, "auto", contact.unload_stiffness_n_m)
        .named("k_unload", "unloading")
        .when(|scene| scene.contact.model == ContactModel::Lumped)
        .means("stiffness of the lumped interface while it springs back, k_load or more")
        .from("thesis Figure 8.6; auto: 100 k_load, an assumption"),
    number!(Damping, Allowed::NonNegative, contact.damping_n_s_m)
        .named("b_2", "interface damper")
        .log()
        .when(|scene| scene.contact.model == ContactModel::Lumped)
        .means("damper of the lumped interface")
        .from("thesis Figure 8.4; Wu has none"),
    number!(Time, Allowed::Positive, contact.appendix.step_s)
        .named("dt", "time step")
        .log()
        .when(is_listing)
        .means("time step of the listing")
        .from("thesis Appendix A.1"),
    quirk!(
        coupling,
        "coupling",
        "nose depth",
        "depth subtracts the plate's last increment only, or (corrected) its whole motion",
        "A.2"
    ),
    quirk!(
        damper,
        "dampsign",
        "damper sign",
        "the damper's force has no sign, or (corrected) it resists",
        "A.7 and A.9"
    ),
    quirk!(
        stopping,
        "stopping",
        "end of contact",
        "contact ends below 0.01 m/s after a step, or (corrected) where both velocities are equal",
        "A.2"
    ),
    quirk!(
        afterwards,
        "after",
        "after contact",
        "the bodies stay joined afterwards, or (corrected) not after a perforation",
        "A.5 and A.7"
    ),
    quirk!(
        scheme,
        "scheme",
        "time stepping",
        "the force is held over the step, or (corrected) Runge-Kutta for both bodies",
        "A.4 and A.8"
    ),
    quirk!(
        obliquity,
        "oblique",
        "oblique force",
        "the whole force acts on both bodies, or (corrected) it is resolved on the normal",
        "A.2 to A.4"
    ),
    choice!(Jumps, contact.appendix.jumps)
        .named("jumps", "code jumps")
        .when(is_listing)
        .means("whether the listing's jumps work as meant, or (ignored) the area is overwritten once the nose is buried")
        .from("thesis Appendix A.2"),
    choice!(InterfaceLaw, interface.law)
        .named("interface", "interface law")
        .also(&["law"])
        .used_when(is_hydrodynamic)
        .means("fused: joined for good after the first arrest; plastic: carries forces up to its strength")
        .from("fused: the thesis; plastic: a rigid-plastic interface"),
    number!(Number, Allowed::NonNegative, interface.grip)
        .named("g", "grip")
        .also(&["grip"])
        .used_when(|scene| {
            is_hydrodynamic(scene) && scene.interface.law == InterfaceLaw::Plastic
        })
        .means("grip: the greatest tension of the interface is g A S_y")
        .from("assumption: 0.1"),
    number!(Number, Allowed::Between(1e-14, 1e-2), run.tolerance)
        .named("tol", "tolerance")
        .also(&["tolerance"])
        .log()
        .means("relative error tolerance of depth and time")
        .from("default of this program"),
    optional!(Time, Allowed::Positive, "auto", run.horizon_s)
        .named("horizon", "end of the run")
        .means("the time the run goes on to")
        .from("absent: chosen from the scene"),
];
