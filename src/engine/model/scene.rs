//! Scene: all inputs of a run, and the rules for physically meaningful scenes.
//!
//! Symbols and default values are those of Table 9.1 and of the baseline of chapter 9 of the thesis (with `S_y` = 1.52e8 Pa: the table's
//! 1.52e7 is a misprint). Units are SI, except for the obliquity. It is stored in degrees, so that a value typed in degrees is stored
//! exactly. The module does not depend on files or the terminal. The table row of each variable is next to its field;
//! [`crate::model::variables`] collects the rows.

use crate::model::strength::{hardening_exponent, hole_growth_pa};
use crate::model::variables::part::{part, parts};

mod bodies;
mod contact;
mod mechanism;

pub use crate::model::mechanism::kinds::beam::Beam;
pub use crate::model::mechanism::kinds::table::Table;
pub use crate::model::mechanism::kinds::{OwnMass, Spring, SpringKind, Wire};
use bodies::is_sprung;
pub use bodies::{
    Closure, Core, Criterion, DragSource, Mount, Nose, Plate, PlateSize, Projectile, Target,
};
pub use contact::{Contact, ContactModel, Interface, InterfaceLaw, Listing};
pub(in crate::model) use contact::{is_listing, resists};
pub use mechanism::{Combination, Mechanism, Stop, StopKind};
pub(in crate::model) use mechanism::{damper_rows, may_stop, second_rows};

/// Projectile, struck plate, and the mechanism that carries the plate.
#[expect(missing_docs, reason = "each part says what it is")]
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Scene {
    /// Short title.
    pub title: String,
    /// Source of the numbers, and the expected result.
    pub notes: String,
    pub projectile: Projectile,
    pub target: Target,
    pub plate: Plate,
    pub mechanism: Mechanism,
    pub interface: Interface,
    pub contact: Contact,
    pub run: RunSettings,
    pub stack: Stack,
    /// Sweep with this scene as its base, if any.
    pub sweep: Option<Sweep>,
}

/// Gives the rows of variables access to the parts of a scene.
macro_rules! access {
    ($($($place:ident).+: $part:ty;)+) => {$(
        impl AsRef<$part> for Scene {
            fn as_ref(&self) -> &$part {
                &self.$($place).+
            }
        }

        impl AsMut<$part> for Scene {
            fn as_mut(&mut self) -> &mut $part {
                &mut self.$($place).+
            }
        }
    )+};
}

access! {
    projectile: Projectile;
    target: Target;
    plate: Plate;
    mechanism: Mechanism;
    mechanism.spring: Spring;
    interface: Interface;
    contact: Contact;
    run: RunSettings;
    stack: Stack;
}

parts! {
    /// Settings of the computation of a run.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct RunSettings at (run: RunSettings) {
        pub tolerance: f64 = 1e-9 => "tol", "tolerance", "relative error tolerance of depth and time",
            number(Number, Between(1e-14, 1e-2)).aliases(&["tolerance"]).is_log(true).source("default of this program");
        pub horizon_s: Option<f64> = None => "horizon", "end of the run", "the time the run goes on to",
            optional(Time, Positive, "auto").source("absent: until the results are known");
    }

    /// Elements behind the scene's own plate.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Stack at (stack: Stack) {
        pub base_thickness_m: Option<f64> = None => "h_base", "base thickness",
            "thickness of a base plate behind the elements, on a rigid mount",
            optional(Length, Positive, "none").aliases(&["base"]).is_seldom(true)
            .source("thesis section 6.2.8; no value there. none: the plate stands alone");
        pub base_strength_pa: Option<f64> = None => "S_base", "base strength", "flow strength of the base plate",
            optional(Pressure, NonNegative, "plate").is_seldom(true).listed(|scene| part::<Stack>(scene).is_set()).source("plate: that of the scene's plate");
        pub elements: f64 = 1.0 => "elements", "elements",
            "how many equal elements, each a plate on its mechanism, stand one behind the other",
            number(Number, Between(1.0, 50.0)).is_seldom(true).listed(|scene| part::<Stack>(scene).is_set()).source("thesis section 6.2.8; 1 throughout chapter 9");
        pub gap_m: Option<f64> = None => "gap", "gap",
            "clear distance behind each plate: a warning where a plate travels farther",
            optional(Length, Positive, "none").is_seldom(true).listed(|scene| part::<Stack>(scene).is_set()).source("none: enough");
        /// Further elements that differ from the first, in order.
        pub layers: Vec<Layer> = Vec::new();
    }
}

/// Sweep stored with its base scene, so that a figure opens from its preset.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Sweep {
    /// Axes of the sweep; at least one.
    pub axes: Vec<SweepAxis>,
    /// Names of the results to show.
    pub outputs: Vec<String>,
}

/// Axis of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepAxis {
    /// Symbol or key of a variable.
    pub name: String,
    /// First value, in the stored unit.
    pub from: f64,
    /// Last value, in the stored unit.
    pub to: f64,
    /// Number of points, >= 2.
    pub count: usize,
    /// Whether the points are geometrically spaced; else linearly.
    pub log: bool,
    /// Listed values, in this order, instead of a range; empty for a range.
    pub values: Vec<f64>,
}

impl SweepAxis {
    /// Creates a linearly spaced axis.
    pub fn linear(name: &str, from: f64, to: f64, count: usize) -> Self {
        Self { name: name.to_owned(), from, to, count, log: false, values: Vec::new() }
    }
}

/// Standard gravity, m/s².
pub const GRAVITY_M_S2: f64 = 9.806_65;

/// Maximum number of listed elements. The time of a run, and of each keystroke, grows with the square of their number.
pub const LAYERS_MAX: usize = 50;

/// Element of a stack: a plate on its mechanism or mount.
#[expect(missing_docs, reason = "each part says what it is")]
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    pub target: Target,
    pub plate: Plate,
    pub mechanism: Mechanism,
}

impl Stack {
    /// Returns `true` for a stack, or for elements that lack only the base plate.
    fn is_set(&self) -> bool {
        self.base_thickness_m.is_some() || self.elements > 1.0
    }
}

impl Scene {
    /// Returns the mass ratio gamma: given, or from the plate's size.
    pub fn mass_ratio(&self) -> f64 {
        self.plate.mass_ratio(&self.target, &self.projectile)
    }

    /// Returns the plate mass `m_2 = gamma m_p`, kg.
    pub fn plate_mass_kg(&self) -> f64 {
        self.mass_ratio() * self.projectile.mass_kg
    }

    /// Returns `true` if further plates stand behind this one, the last of them the base plate.
    pub fn is_stack(&self) -> bool {
        self.stack.base_thickness_m.is_some()
    }

    /// Returns the weight of the projectile along the plate's normal, N; 0 if it is not counted, or on a rigid mount.
    pub fn weight_n(&self) -> f64 {
        let acts = self.projectile.weight
            && self.is_sprung()
            && self.contact.model != ContactModel::Appendix;
        if acts { self.projectile.mass_kg * GRAVITY_M_S2 } else { 0.0 }
    }

    /// Returns `true` if a mechanism carries the plate; `false` for a rigid mount.
    pub fn is_sprung(&self) -> bool {
        is_sprung(self)
    }

    /// Returns the plate's displacement at first contact, -d, m; 0 on a rigid mount. Never returns -0.
    pub fn start_m(&self) -> f64 {
        if self.is_sprung() { 0.0 - self.plate.cocking_m } else { 0.0 }
    }

    /// Returns the plate's velocity at first contact along its normal, m/s; 0 on a rigid mount.
    pub fn plate_velocity_m_s(&self) -> f64 {
        if self.is_sprung() { self.plate.velocity_m_s } else { 0.0 }
    }

    /// Returns the closing velocity of projectile and plate along the projectile's axis, m/s.
    pub fn closing_velocity_m_s(&self) -> f64 {
        self.projectile.velocity_m_s - self.plate_velocity_m_s() * self.cos_obliquity()
    }

    /// Returns the side of the plate's square face, `(m_2/(rho h))^(1/2)`, m. The plate is a block of its material.
    pub fn plate_face_m(&self) -> f64 {
        (self.plate_mass_kg() / (self.target.density_kg_m3 * self.target.thickness_m)).sqrt()
    }

    /// Returns the closure chosen by the plate's thickness; `None` if the scene states a closure.
    pub fn closure_by_thickness(&self) -> Option<Closure> {
        (self.target.closure == Closure::ByThickness).then(|| self.closure())
    }

    /// Returns the target with the closure, the dishing and the drag in effect.
    pub fn target_in_effect(&self) -> Target {
        self.target.in_effect(&self.projectile)
    }

    /// Returns the closure in effect: stated, or chosen by the plate's thickness.
    pub fn closure(&self) -> Closure {
        self.target_in_effect().closure
    }

    /// Returns the flow strength in the contact force, Pa: given, or from Y and E by the closure.
    pub fn flow_strength_pa(&self) -> f64 {
        let Target { flow_strength_pa, yield_pa: y, modulus_pa: e, .. } = self.target;
        match self.closure() {
            Closure::Given => flow_strength_pa,
            Closure::DoubleYield => 2.0 * y,
            Closure::Cavity | Closure::ByThickness => {
                2.0 / 3.0 * y * (1.0 + (2.0 * e / (3.0 * y)).ln())
            }
            Closure::Cylindrical => hole_growth_pa(y, e, self.hardening_exponent()),
        }
    }

    /// Returns the hardening exponent of the plate's metal; 0 without a tensile strength above Y.
    pub fn hardening_exponent(&self) -> f64 {
        let Target { yield_pa, tensile_pa, modulus_pa, .. } = self.target;
        hardening_exponent(yield_pa, tensile_pa, modulus_pa)
    }

    /// Returns `true` if the law in effect includes hardening but the scene gives none.
    pub fn lacks_hardening(&self) -> bool {
        let closure = self.closure();
        let counts = closure == Closure::Cylindrical
            || self.projectile.nose.shears() && closure != Closure::Given;
        let Target { tensile_pa, yield_pa, .. } = self.target;
        counts && tensile_pa.is_none_or(|tensile_pa| tensile_pa <= yield_pa)
    }

    /// Returns cos(theta).
    pub fn cos_obliquity(&self) -> f64 {
        self.projectile.obliquity_deg.to_radians().cos()
    }

    /// Returns `h_e = h / cos(theta)`, m.
    pub fn effective_thickness_m(&self) -> f64 {
        self.target.thickness_m / self.cos_obliquity()
    }

    /// Returns `c = C_d rho / 2`, kg/m³.
    pub fn drag_kg_m3(&self) -> f64 {
        0.5 * self.target_in_effect().drag_coefficient * self.target.density_kg_m3
    }
}
