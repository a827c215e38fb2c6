//! The scene: everything a run depends on, and the rules a scene must keep to make physical sense.
//!
//! Symbols and default values are those of Table 9.1 and of the baseline of chapter 9 of the thesis (with
//! `S_y` = 1.52e8 Pa: the table's 1.52e7 is a misprint). Units are SI; the obliquity alone is kept in degrees, so
//! that a value typed in degrees is stored exactly. This file knows no files and no screen; the table that
//! names each variable for people is in [`crate::model::variables`].

use crate::model::defaulted::defaulted;
use crate::model::worded::worded;

mod contact;
mod spring;

pub use contact::{Contact, ContactModel, Jumps, Listing, Reading};
pub use spring::{
    Beam, Bistable, Column, Combination, ConstantForce, Crush, Helix, Normalised, OwnMass, Spring,
    SpringKind, Table, Wire,
};

/// A projectile, the plate it strikes, and the mechanism that carries the plate.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Scene {
    /// A short name for people.
    pub title: String,
    /// Where the numbers come from and what to expect.
    pub notes: String,
    /// The projectile.
    pub projectile: Projectile,
    /// The plate's material and thickness.
    pub target: Target,
    /// The plate's mass and how it is carried.
    pub plate: Plate,
    /// Spring, damper and stop behind the plate.
    pub mechanism: Mechanism,
    /// The strength of the interface between projectile and plate once they move together.
    pub interface: Interface,
    /// How the contact force is modelled.
    pub contact: Contact,
    /// How the run is computed.
    pub run: RunSettings,
    /// The stack behind the plate.
    pub stack: Stack,
    /// The sweep this scene is the base of, if any.
    pub sweep: Option<Sweep>,
}

defaulted! {
    /// A rigid projectile with a hemispherical nose.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Projectile {
        pub mass_kg: f64 = 0.0295,
        pub tip_radius_m: f64 = 0.00635,
        pub velocity_m_s: f64 = 100.0,
        pub obliquity_deg: f64 = 0.0,
        pub density_kg_m3: f64 = 7850.0,
        pub strength_pa: f64 = 1e9,
        pub nose: Nose = Nose::Hemispherical,
    }
}

worded! {
    /// The shape of a projectile's nose.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum Nose: word {
        #[default]
        Hemispherical = "hemispherical",
        /// An ogive or a cone.
        Pointed = "pointed",
        /// Flat, or nearly so: it shears out a plug.
        Blunt = "blunt",
    }
}

defaulted! {
    /// The plate as a target.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Target {
        pub thickness_m: f64 = 0.0254,
        pub density_kg_m3: f64 = 2710.0,
        /// `S_y`, dynamic flow strength, >= 0 Pa; what counts is [`Scene::flow_strength_pa`].
        pub flow_strength_pa: f64 = 1.52e8,
        pub closure: Closure = Closure::Given,
        pub yield_pa: f64 = 75.8e6,
        pub modulus_pa: f64 = 73.1e9,
        pub drag_coefficient: f64 = 0.5,
        pub dishing: bool = true,
    }
}

worded! {
    /// Where the flow strength comes from.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum Closure: word {
        /// It is given: `S_y`.
        #[default]
        Given = "given",
        /// 2 Y, as the thesis has it: a yield strength and a constraint factor. Made for dishing.
        DoubleYield = "double-yield",
        /// The pressure that opens a spherical cavity in an elastic, perfectly plastic body, 2/3 Y (1 + ln(2 E/3 Y)). Made
        /// without dishing.
        Cavity = "cavity",
    }
}

defaulted! {
    /// The plate as a body.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Plate {
        pub mass_ratio: f64 = 1.0,
        /// The input that defines the plate's size; the mass ratio follows from it, unless it is the input itself.
        pub size: PlateSize = PlateSize::Ratio,
        pub mount: Mount = Mount::Sprung,
        pub cocking_m: f64 = 0.0,
    }
}

/// The input that defines the plate's size.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub enum PlateSize {
    /// gamma.
    #[default]
    Ratio,
    /// `m_2` > 0 kg.
    Mass(f64),
    /// The side of its square face, > 0 m: the plate is a block of its material.
    Face(f64),
}

worded! {
    /// How the plate is carried.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum Mount: word {
        #[default]
        Sprung = "sprung",
        Rigid = "rigid",
    }
}

defaulted! {
    /// Spring, damper and stop.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Mechanism {
        pub damper: Damper = Damper::default(),
        pub spring: Spring = Spring::default(),
        pub combination: Combination = Combination::Alone,
        /// Without effect where the first spring is alone.
        pub second: Spring = Spring::default(),
        pub energy_j_kg: Option<f64> = None,
        pub stop: Stop = Stop::default(),
    }

    /// A power-law damper.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Damper {
        pub coefficient: f64 = 0.0,
        pub exponent: f64 = 1.0,
    }

    /// A mechanical stop at x = `position_m`, which acts on the plate.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Stop {
        pub position_m: Option<f64> = None,
        pub kind: StopKind = StopKind::Rigid,
        pub restitution: f64 = 0.0,
        pub stiffness_n_m: f64 = 1e8,
        pub damping_n_s_m: f64 = 0.0,
    }
}

worded! {
    /// The kind of stop.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum StopKind: word {
        #[default]
        Rigid = "rigid",
        Elastic = "elastic",
    }
}

defaulted! {
    /// The interface between projectile and plate after the first arrest.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Interface {
        pub law: InterfaceLaw = InterfaceLaw::Fused,
        pub grip: f64 = 0.1,
    }
}

worded! {
    /// The interface between projectile and plate.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum InterfaceLaw: word {
        /// The thesis: once together, together for good.
        #[default]
        Fused = "fused",
        /// Rigid-plastic: pushes up to `A S_y`, pulls up to `g A S_y`.
        Plastic = "plastic",
    }
}

defaulted! {
    /// How a run is computed.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct RunSettings {
        pub tolerance: f64 = 1e-9,
        pub horizon_s: Option<f64> = None,
    }
}

/// The sweep a scene is the base of: kept with the scene so that a figure opens from its preset.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Sweep {
    /// One or more axes.
    pub axes: Vec<SweepAxis>,
    /// Names of the results to show.
    pub outputs: Vec<String>,
}

/// One axis of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepAxis {
    /// A variable's symbol or key.
    pub name: String,
    /// First value, stored unit.
    pub from: f64,
    /// Last value, stored unit.
    pub to: f64,
    /// Number of points, >= 2.
    pub count: usize,
    /// Points at equal ratios instead of equal differences.
    pub log: bool,
    /// The values themselves, in this order, instead of a range; empty for a range.
    pub values: Vec<f64>,
}

/// Most further elements that a scene may list: the time of a run and of a key grows with the square of their number.
pub const LAYERS_MAX: usize = 50;

defaulted! {
    /// The elements behind the scene's own plate.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Stack {
        pub base_thickness_m: Option<f64> = None,
        pub base_strength_pa: Option<f64> = None,
        pub elements: f64 = 1.0,
        pub gap_m: Option<f64> = None,
        /// Further elements that are not like the first, in order.
        pub layers: Vec<Layer> = Vec::new(),
    }
}

/// One element of a stack: a plate on its mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// The plate's material.
    pub target: Target,
    /// The plate as a body.
    pub plate: Plate,
    /// The mechanism or mount that carries it.
    pub mechanism: Mechanism,
}

impl Damper {
    /// Whether there is none.
    pub fn is_absent(&self) -> bool {
        self.coefficient == 0.0
    }
}

impl Mechanism {
    /// Leave the springs out, and with them what they weigh and turn.
    pub fn remove_springs(&mut self) {
        self.combination = Combination::Alone;
        self.spring.kind = SpringKind::PowerLaw;
        self.spring.coefficient = 0.0;
        self.spring.own_mass = OwnMass::Ignored;
    }

    /// Energy that the spring or absorber takes up per mass of its own, J/kg: given, or tau²/(4 rho G) of a wire in torsion.
    pub fn specific_energy_j_kg(&self) -> f64 {
        let wire = self.spring.wire;
        let coil = wire.shear_strength_pa * wire.shear_strength_pa
            / (4.0 * wire.density_kg_m3 * wire.shear_modulus_pa);
        self.energy_j_kg.unwrap_or(coil)
    }

    /// Whether it is the thesis's: one power law `k |x|^n` that weighs nothing.
    pub fn is_plain(&self) -> bool {
        let spring = &self.spring;
        self.combination == Combination::Alone
            && spring.kind == SpringKind::PowerLaw
            && spring.own_mass == OwnMass::Ignored
            && spring.is_single()
    }

    /// Whether it is plain and neither spring, damper nor stop is there.
    pub fn is_nothing(&self) -> bool {
        self.is_plain()
            && self.spring.coefficient == 0.0
            && self.damper.is_absent()
            && self.stop.position_m.is_none()
    }
}

impl Scene {
    /// Plate mass `m_2 = gamma m_p`, kg.
    pub fn plate_mass_kg(&self) -> f64 {
        self.plate.mass_ratio * self.projectile.mass_kg
    }

    /// Gives the plate's size by `size`, and lets gamma follow.
    pub fn resize(&mut self, size: PlateSize) {
        self.plate.size = size;
        self.follow_size();
    }

    /// Lets gamma follow from the plate's size, after a change of what it depends on.
    pub fn follow_size(&mut self) {
        let Target { thickness_m, density_kg_m3, .. } = self.target;
        match self.plate.size {
            PlateSize::Ratio => {}
            PlateSize::Mass(kg) => self.plate.mass_ratio = kg / self.projectile.mass_kg,
            PlateSize::Face(side_m) => {
                let kg = density_kg_m3 * thickness_m * side_m * side_m;
                self.plate.mass_ratio = kg / self.projectile.mass_kg;
            }
        }
    }

    /// Side of the plate's square face, `(m_2/(rho h))^(1/2)`, m: the plate is a block of its material.
    pub fn plate_face_m(&self) -> f64 {
        (self.plate_mass_kg() / (self.target.density_kg_m3 * self.target.thickness_m)).sqrt()
    }

    /// The flow strength in the contact force, Pa: given, or from Y and E by the closure.
    pub fn flow_strength_pa(&self) -> f64 {
        let Target { flow_strength_pa, yield_pa: y, modulus_pa: e, .. } = self.target;
        match self.target.closure {
            Closure::Given => flow_strength_pa,
            Closure::DoubleYield => 2.0 * y,
            Closure::Cavity => 2.0 / 3.0 * y * (1.0 + (2.0 * e / (3.0 * y)).ln()),
        }
    }

    /// cos(theta).
    pub fn cos_obliquity(&self) -> f64 {
        self.projectile.obliquity_deg.to_radians().cos()
    }

    /// `h_e = h / cos(theta)`, m.
    pub fn effective_thickness_m(&self) -> f64 {
        self.target.thickness_m / self.cos_obliquity()
    }

    /// `c = C_d rho / 2`, kg/m³.
    pub fn drag_kg_m3(&self) -> f64 {
        0.5 * self.target.drag_coefficient * self.target.density_kg_m3
    }
}
