//! Projectile, and plate as a target and as a body.

use crate::model::labelled_enum::labelled_enum;
use crate::model::scene::contact::{Contact, is_listing, penetrates, resists};
use crate::model::scene::mechanism::Mechanism;
use crate::model::units::Dimension;
use crate::model::variables::part::{TABLE_9_1, TABLE_9_2, part, part_mut, parts, rows};
use crate::model::variables::row::{Allowed, RowKind, RowNumber};

parts! {
    /// Rigid projectile.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Projectile at (projectile: Projectile) reads(Plate, Contact) {
        pub mass_kg: f64 = 0.0295 => "m_p", "projectile mass", "projectile mass",
            number(Mass, Positive).own_name("projectile_mass").source(TABLE_9_1);
        pub tip_radius_m: f64 = 0.00635 => "R", "tip radius", "radius of the hemispherical tip and of the body behind it",
            number(Length, Positive).own_name("radius").source(TABLE_9_1);
        pub velocity_m_s: f64 = 100.0 => "v_i", "impact velocity", "impact velocity",
            number(Velocity, Positive).aliases(&["vi"]).source(TABLE_9_1);
        pub obliquity_deg: f64 = 0.0 => "theta", "obliquity", "obliquity, between the projectile's axis and the plate's normal",
            number(Angle, Below(0.0, 90.0)).source("thesis Appendix A.1; 0 throughout chapter 9");
        pub density_kg_m3: f64 = 7850.0 => "rho_p", "density", "projectile density, for the warnings of ricochet (by Tate, of a rod m_p/(rho_p pi R^2) long) and of a nose sphere heavier than m_p",
            number(Density, Positive).own_name("projectile_density")
            .when(|scene| is_oblique(scene) || part::<Projectile>(scene).is_lighter_than_nose())
            .source("assumption: steel");
        pub strength_pa: f64 = 1e9 => "Y_p", "yield strength", "projectile strength, used for the ricochet warning only",
            number(Pressure, Positive).own_name("projectile_strength").when(is_oblique).source("assumption: 1 GPa");
        pub nose: Nose = Nose::Hemispherical => "nose", "nose shape",
            "shape of the nose, which chooses the law: hemispherical or pointed (hole growth), blunt (a rigid cylinder) or fragment (a chisel of soft steel): a plug",
            choice().is_seldom(true).listed(|scene| part::<Projectile>(scene).nose != Nose::Hemispherical)
            .source("hemispherical: the thesis; plug: the form of Recht and Ipson (1963), fitted on the REL database");
        pub core: Core = Core::Steel => "core", "core", "material of the core: it chooses the class of measurements and changes no force",
            choice().is_seldom(true).listed(|scene| part::<Projectile>(scene).core != Core::Steel).source("assumption: steel");
        pub weight: bool = false => "weight", "weight",
            "on: the projectile falls on a level plate, and its weight m_p g presses on for as long as both touch; the plate's own is in equilibrium at x = 0",
            switch().is_seldom(true).listed(|scene| part::<Projectile>(scene).weight).used(falls)
            .source("off: the thesis; g = 9.80665 m/s^2");
    }

    /// Plate as a target.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Target at (target: Target) reads(Projectile, Plate, Contact) {
        pub thickness_m: f64 = 0.0254 => "h", "plate thickness", "plate thickness", number(Length, Positive)
            .used(|scene| penetrates(scene) || gives_mass(scene)).source(TABLE_9_1);
        pub density_kg_m3: f64 = 2710.0 => "rho", "plate density", "plate density",
            number(Density, Positive).used(|scene| resists(scene) || gives_mass(scene)).source("thesis Table 9.1 (the Appendix has 2780)");
        /// Given flow strength; [`Scene::flow_strength_pa`](super::Scene::flow_strength_pa) is the value in effect.
        pub flow_strength_pa: f64 = 1.52e8 => "S_y", "flow strength", "dynamic flow strength of the plate",
            number(Pressure, NonNegative).aliases(&["Sy"]).used(|scene| resists(scene) && part::<Target>(scene).closure == Closure::Given)
            .source("thesis Table 9.1 prints 1.52e7, a misprint: the Appendix has 2 x 75.8e6");
        pub closure: Closure = Closure::Given => "closure", "source of S_y",
            "where S_y comes from: given, 2 Y (with dishing), a spherical cavity, a cylindrical one in a hardening metal (both without dishing), or by-thickness",
            choice().is_seldom(true).used(resists)
            .source("given: Table 9.1; double-yield: thesis 8.3.1; cavity: 2/3 Y (1 + ln(2 E/3 Y)); cylindrical: Luk and Forrestal (1987), with UTS");
        pub yield_pa: f64 = 75.8e6 => "Y", "yield strength", "static yield strength, for a closure",
            number(Pressure, Positive).own_name("yield_strength").is_seldom(true)
            .when(|scene| part::<Target>(scene).closure != Closure::Given).used(resists).source("thesis Appendix A.1: 75.8 MPa");
        pub tensile_pa: Option<f64> = None => "UTS", "tensile strength",
            "engineering ultimate tensile strength, for the hardening; none, or below Y: no hardening",
            optional(Pressure, Positive, "none").own_name("tensile_strength").is_seldom(true).used(resists).when(hardens)
            .source("none: the thesis needs none");
        pub modulus_pa: f64 = 73.1e9 => "E", "elastic modulus", "modulus of elasticity, for cavity expansion and for the plug",
            number(Pressure, Positive).is_seldom(true).used(resists)
            .when(|scene| hardens(scene) || part::<Target>(scene).closure == Closure::Cavity)
            .source("aluminium 2024; the thesis needs none");
        pub drag_coefficient: f64 = 0.5 => "C_d", "drag coefficient",
            "drag coefficient: the inertial part of the contact force is C_d rho u^2 / 2",
            is(drag()).aliases(&["Cd"])
            .used(|scene| resists(scene) && (!part::<Target>(scene).closure.chooses_drag() || part::<Target>(scene).drag == DragSource::Given))
            .source(TABLE_9_1);
        pub drag: DragSource = DragSource::Closure => "drag", "source of C_d",
            "where C_d comes from with closure = cylindrical or by-thickness: closure (and nose), or given; setting C_d makes it given",
            choice().is_seldom(true).when(|scene| resists(scene) && part::<Target>(scene).closure.chooses_drag())
            .source("0.5 with 2 Y (Virostek); with a cavity 0.212 for an ogive of CRH 3, else 1");
        pub dishing: bool = true => "dishing", "dishing",
            "the plate's local bulge takes up about one projectile diameter of travel",
            is(dishing()).used(|scene| penetrates(scene) && dishes(scene)).source("thesis section 8.3.1 and Appendix A.2");
        pub criterion: Criterion = Criterion::Passage => "criterion", "criterion",
            "when the plate counts as perforated: passage (navy: the nose is clear of the rear face) or protrusion (army: it stands out)",
            choice().is_seldom(true).used(penetrates).source("passage: the thesis");
    }

    /// Plate as a body.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Plate at (plate: Plate) reads(Projectile, Target, Mechanism, Contact) {
        pub mount: Mount = Mount::Sprung => "mount", "mount", "sprung: carried by spring and damper; rigid: it cannot move",
            choice().source("thesis section 9.3 (rigid: the baseline)");
        /// Input that defines the plate's size.
        pub size: PlateSize = PlateSize::Ratio(1.0) => each(sizes);
        pub cocking_m: f64 = 0.0 => "d", "cocking distance", "cocking distance: the plate starts at x = -d",
            number(Length, NonNegative).thesis_range(Some((0.0, 0.5)))
            .used(is_sprung).source(TABLE_9_2);
        pub velocity_m_s: f64 = 0.0 => "w_0", "plate speed", "plate velocity at first contact, away from the shot",
            number(Velocity, Closing).own_name("plate_velocity").is_seldom(true).used(is_sprung)
            .source("thesis Appendix A.1, y(2), and section 4.3.2; 0 throughout chapter 9; in a stack it is that of the first plate");
    }
}

labelled_enum! {
    /// Shape of a projectile's nose.
    pub enum Nose: word {
        Hemispherical = "hemispherical",
        /// Ogive or cone.
        Pointed = "pointed",
        /// Rigid cylinder, which shears out a plug.
        Blunt = "blunt",
        /// Fragment simulating projectile, a chisel of soft steel. It mushrooms and shears out a plug.
        Fragment = "fragment",
    }

    /// Core of a projectile.
    pub enum Core: word {
        Steel = "steel",
        TungstenCarbide = "tungsten-carbide",
        /// Lead, or a rod that shortens.
        Deformable = "deformable",
    }

    /// Closure of the flow strength.
    pub enum Closure: word {
        /// Given strength `S_y`.
        Given = "given",
        /// Flow strength 2 Y, as in the thesis: yield strength times a constraint factor. Made for dishing.
        DoubleYield = "double-yield",
        /// Pressure that opens a spherical cavity in an elastic, perfectly plastic body, 2/3 Y (1 + ln(2 E/3 Y)). Made without dishing.
        Cavity = "cavity",
        /// Pressure that opens a cylindrical cavity in an incompressible hardening metal. Made without dishing.
        Cylindrical = "cylindrical",
        /// Choice by thickness. Under a hemisphere: 2 Y for plates thinner than the projectile's diameter, then a spherical cavity, and a
        /// cylindrical cavity from 1.6 diameters. Under another nose: a cylindrical cavity.
        ByThickness = "by-thickness",
    }

    /// Criterion of perforation.
    pub enum Criterion: word {
        /// Nose clear of the rear face: complete passage.
        Passage = "passage",
        /// Nose protruding from the rear face.
        Protrusion = "protrusion",
    }

    /// Source of the drag coefficient under a closure that chooses it.
    pub enum DragSource: word {
        /// Drag coefficient of the closure in effect and the nose.
        Closure = "closure",
        /// Given drag coefficient; the only choice under other closures.
        Given = "given",
    }

    /// Mount of the plate.
    pub enum Mount: word {
        Sprung = "sprung",
        Rigid = "rigid",
    }
}

impl Criterion {
    /// Returns the label: the rule and its authors.
    pub fn label(self) -> &'static str {
        match self {
            Self::Passage => {
                "complete passage: the nose is clear of the rear face (navy criterion)"
            }
            Self::Protrusion => "protrusion: the nose stands out of the rear face (army criterion)",
        }
    }
}

/// Input that defines the plate's size: the last one set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlateSize {
    /// Mass ratio gamma.
    Ratio(f64),
    /// Mass `m_2` > 0, kg.
    Mass(f64),
    /// Side of the square face, > 0, m. The plate is a block of its material.
    Face(f64),
}

impl Plate {
    /// Returns the mass ratio gamma: given, or from the plate's size.
    pub(super) fn mass_ratio(&self, target: &Target, projectile: &Projectile) -> f64 {
        let Target { thickness_m, density_kg_m3, .. } = target;
        match self.size {
            PlateSize::Ratio(ratio) => ratio,
            PlateSize::Mass(kg) => kg / projectile.mass_kg,
            PlateSize::Face(side_m) => {
                density_kg_m3 * thickness_m * side_m * side_m / projectile.mass_kg
            }
        }
    }
}

impl Projectile {
    /// Returns `true` if the nose sphere is heavier than the projectile.
    fn is_lighter_than_nose(&self) -> bool {
        self.nose_sphere_kg() > self.mass_kg
    }

    /// Returns the mass of the sphere of which the nose is half, kg.
    pub fn nose_sphere_kg(&self) -> f64 {
        let volume_m3 = 4.0 / 3.0 * std::f64::consts::PI * self.tip_radius_m.powi(3);
        volume_m3 * self.density_kg_m3
    }
}

impl Target {
    /// Returns the closures of a choice by thickness under a hemisphere, each with its minimum thickness, m: for a plate that dishes, for
    /// one as thick as the projectile, and for one thick enough for a cylindrical hole.
    pub fn by_thickness(tip_radius_m: f64) -> [(Closure, f64); 3] {
        let body_m = 2.0 * tip_radius_m;
        [
            (Closure::DoubleYield, 0.0),
            (Closure::Cavity, body_m),
            (Closure::Cylindrical, CYLINDRICAL_FROM * body_m),
        ]
    }

    /// Returns the thickness nearest to the plate's at which a closure by thickness changes under a hemisphere, m.
    pub fn nearest_change_m(&self, tip_radius_m: f64) -> f64 {
        let [_, (_, spherical_m), (_, cylindrical_m)] = Self::by_thickness(tip_radius_m);
        let between = (spherical_m * cylindrical_m).sqrt();
        if self.thickness_m < between { spherical_m } else { cylindrical_m }
    }

    /// Fixes the drag coefficient as given, even if the closure would choose it.
    pub fn give_drag(&mut self) {
        if self.closure.chooses_drag() {
            self.drag = DragSource::Given;
        }
    }

    /// Returns the target with the closure, the dishing and the drag in effect under a projectile. By thickness under a hemisphere: 2 Y
    /// with dishing and Virostek's drag on a thin plate; on a thick plate a spherical, then a cylindrical cavity with a hemisphere's drag.
    /// Under another nose: a cylindrical cavity. Only a hemisphere dishes a plate. A given drag is unchanged.
    #[must_use]
    pub fn in_effect(self, projectile: &Projectile) -> Self {
        let nose = projectile.nose;
        match self.closure {
            Closure::Given | Closure::DoubleYield | Closure::Cavity => {
                Self { dishing: self.dishing && nose == Nose::Hemispherical, ..self }
            }
            Closure::ByThickness if nose == Nose::Hemispherical => {
                let chosen = Self::by_thickness(projectile.tip_radius_m).into_iter().rev();
                let mut chosen = chosen.filter(|(_, from_m)| self.thickness_m >= *from_m);
                self.under(chosen.next().map_or(Closure::DoubleYield, |(closure, _)| closure), nose)
            }
            Closure::ByThickness | Closure::Cylindrical => self.under(Closure::Cylindrical, nose),
        }
    }

    /// Returns the target under a closure and a nose, with their dishing and, unless given, their drag.
    #[must_use]
    pub fn under(self, closure: Closure, nose: Nose) -> Self {
        let law = self.by_law(closure, nose);
        match self.drag {
            DragSource::Given => Self { drag_coefficient: self.drag_coefficient, ..law },
            DragSource::Closure => law,
        }
    }

    /// Returns the target under a closure and a nose, with their dishing and drag, even if a drag is given.
    #[must_use]
    pub fn by_law(self, closure: Closure, nose: Nose) -> Self {
        let dishing = closure == Closure::DoubleYield;
        let drag_coefficient = if dishing { VIROSTEK_DRAG } else { nose.drag_coefficient() };
        Self { closure, dishing, drag_coefficient, drag: DragSource::Closure, ..self }
    }
}

/// Minimum thickness, in projectile diameters, at which a hemisphere opens a cylindrical cavity; the lower end of the measurements on soft
/// hardening alloys.
const CYLINDRICAL_FROM: f64 = 1.6;
/// Drag coefficient of Virostek's law.
const VIROSTEK_DRAG: f64 = 0.5;

impl Nose {
    /// Returns the drag coefficient of hole growth without dishing: that of an ogive of CRH 3 (N = 0.106 of Forrestal, `C_d` = 2 N), else a
    /// hemisphere's.
    fn drag_coefficient(self) -> f64 {
        if self == Self::Pointed { 0.212 } else { 1.0 }
    }

    /// Returns `true` if the nose shears out a plug.
    pub fn shears(self) -> bool {
        matches!(self, Self::Blunt | Self::Fragment)
    }
}

impl Closure {
    /// Returns `true` if the closure chooses the drag coefficient.
    pub fn chooses_drag(self) -> bool {
        matches!(self, Self::Cylindrical | Self::ByThickness)
    }
}

/// Returns `true` for an oblique impact.
fn is_oblique(scene: &impl AsRef<Projectile>) -> bool {
    scene.as_ref().obliquity_deg > 0.0
}

/// Returns `true` if a mechanism carries the plate; `false` for a rigid mount.
pub(super) fn is_sprung(scene: &impl AsRef<Plate>) -> bool {
    scene.as_ref().mount == Mount::Sprung
}

/// Returns `true` if hardening of the plate has an effect: in a cylindrical cavity, and in the shear strength of a plug.
fn hardens<S: AsRef<Projectile> + AsRef<Target>>(scene: &S) -> bool {
    let closure = part::<Target>(scene).closure;
    closure.chooses_drag() || part::<Projectile>(scene).nose.shears() && closure != Closure::Given
}

/// Returns `true` if dishing can be chosen: the closure may determine it, and only a hemisphere dishes a plate.
fn dishes<S: AsRef<Projectile> + AsRef<Target>>(scene: &S) -> bool {
    !part::<Target>(scene).closure.chooses_drag()
        && part::<Projectile>(scene).nose == Nose::Hemispherical
}

/// Returns `true` if the weight can do work.
fn falls<S: AsRef<Plate> + AsRef<Contact>>(scene: &S) -> bool {
    is_sprung(scene) && !is_listing(scene)
}

/// Returns `true` if the plate's mass follows from its material and thickness.
fn gives_mass(scene: &impl AsRef<Plate>) -> bool {
    is_sprung(scene) && matches!(scene.as_ref().size, PlateSize::Face(_))
}

impl PlateSize {
    /// Keys of the inputs that define the plate's size; a scene uses one of them.
    pub const KEYS: [&str; 3] = ["plate.mass_ratio", "plate.mass_kg", "plate.face_m"];

    /// Returns the key of the input.
    pub fn key(self) -> &'static str {
        Self::KEYS[match self {
            Self::Ratio(_) => 0,
            Self::Mass(_) => 1,
            Self::Face(_) => 2,
        }]
    }
}

/// Returns the target of a scene in effect.
fn in_effect<S: AsRef<Projectile> + AsRef<Target>>(scene: &S) -> Target {
    part::<Target>(scene).in_effect(part(scene))
}

/// Returns the kind of the dishing switch. Shows the value in effect, because a closure by thickness determines it.
fn dishing<S>() -> RowKind<S>
where
    S: AsRef<Projectile> + AsRef<Target> + AsMut<Target>,
{
    RowKind::Switch {
        get: |scene| in_effect(scene).dishing,
        set: |scene, on| part_mut::<Target>(scene).dishing = on,
    }
}

/// Returns the kind of the drag coefficient. Shows the value in effect; a value that is set is a given one.
fn drag<S>() -> RowKind<S>
where
    S: AsRef<Projectile> + AsRef<Target> + AsMut<Target>,
{
    RowKind::Number(RowNumber {
        get: |scene| Some(in_effect(scene).drag_coefficient),
        set: |scene, value| {
            let target = part_mut::<Target>(scene);
            target.drag_coefficient = value.unwrap_or_default();
            target.give_drag();
        },
        ..RowNumber::new(Dimension::Number, Allowed::NonNegative)
    })
}

/// Returns the mass ratio of a scene.
fn mass_ratio<S: AsRef<Projectile> + AsRef<Target> + AsRef<Plate>>(scene: &S) -> f64 {
    part::<Plate>(scene).mass_ratio(part(scene), part(scene))
}

/// Kind of an input that defines the plate's size.
macro_rules! size {
    ($quantity:ident, $size:ident) => {
        RowNumber {
            absent: Some("none"),
            get: |scene| match part::<Plate>(scene).size {
                PlateSize::$size(value) => Some(value),
                _ => None,
            },
            set: |scene, value| match (value, part::<Plate>(scene).size) {
                (Some(value), _) => part_mut::<Plate>(scene).size = PlateSize::$size(value),
                (None, PlateSize::$size(_)) => {
                    part_mut::<Plate>(scene).size = PlateSize::Ratio(mass_ratio(scene));
                }
                (None, _) => {}
            },
            ..RowNumber::new(Dimension::$quantity, Allowed::Positive)
        }
    };
}

rows! {
    /// Returns the rows of the inputs that define the plate's size.
    fn sizes at (plate: Plate) reads(Projectile, Target);
    mass_ratio: f64 => "gamma", "mass ratio", "mass ratio, plate mass over projectile mass",
        is(RowKind::Number(RowNumber { absent: None, get: |scene| Some(mass_ratio(scene)), ..size!(Number, Ratio) }))
        .thesis_range(Some((0.8, 7.0))).used(is_sprung).source(TABLE_9_2);
    mass_kg: f64 => "m_2", "plate mass", "plate mass; gamma = m_2/m_p follows from it",
        is(RowKind::Number(size!(Mass, Mass))).own_name("plate_mass").aliases(&["m2"]).is_seldom(true).used(is_sprung)
        .listed(|scene| matches!(part::<Plate>(scene).size, PlateSize::Mass(_))).source("none: gamma gives the mass");
    face_m: f64 => "face", "plate side", "side of the plate's square face; gamma = rho h face^2/m_p follows from it",
        is(RowKind::Number(size!(Length, Face))).is_seldom(true).used(is_sprung)
        .listed(|scene| matches!(part::<Plate>(scene).size, PlateSize::Face(_))).source("none: gamma gives the mass");
}
