//! Measurements from outside the thesis, and what the model makes of them with nothing fitted.
//!
//! What was measured is written in `cases` with where it comes from; what the model gives is always computed, by the case's
//! own closure for the flow strength and by the other one. The scenes are bundled presets. What is known of but cannot be
//! checked is listed with the reason.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::run::envelope::{self, Check};
use crate::model::scene::{Closure, Scene};
use crate::model::simulate::{Settings, simulate};
use crate::model::units::Bare;
use crate::model::variables;
use crate::study::limit;

mod bias;
mod cases;
mod ladders;
mod not_checked;

pub use bias::{Bias, biases};
pub use not_checked::NOT_CHECKED;

/// All measurements, class by class.
pub fn cases() -> impl Iterator<Item = &'static Case> {
    cases::CASES.iter().chain(ladders::LADDERS)
}

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The ballistic limit, m/s.
    Limit,
    /// The depth, m.
    Depth,
    /// The velocity at which the last of so many equal hits at one place perforates, m/s.
    RepeatLimit(u8),
    /// The ballistic limit over that of the same plate at 0 deg.
    Ratio,
    /// The strength the target opposes to a slow nose, Pa.
    Strength,
    /// How far the plate bulges under the nose, m.
    Bulge,
}

impl Quantity {
    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Limit => "ballistic limit",
            Self::RepeatLimit(2) => "ballistic limit of two equal hits at one place",
            Self::RepeatLimit(_) => "ballistic limit of three equal hits at one place",
            Self::Depth => "depth",
            Self::Ratio => "limit over that at 0 deg",
            Self::Strength => "flow strength",
            Self::Bulge => "bulge",
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Limit | Self::RepeatLimit(_) => "m/s",
            Self::Depth | Self::Bulge => "m",
            Self::Ratio => "",
            Self::Strength => "Pa",
        }
    }
}

/// What a measurement is of: the model is good for some classes and bad for others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// A hemispherical nose on a steel plate of half a diameter and more.
    Hemisphere,
    /// A sphere on a plate of a twentieth of its diameter.
    ThinPlate,
    /// Further hits at the same place.
    RepeatHits,
    /// A blunt or conical nose.
    OtherNoses,
    /// An armour-piercing core on aluminium, straight on.
    CoreOnAluminium,
    /// The same at an angle.
    CoreOblique,
    /// The limit at an angle over that straight on.
    ObliqueRatio,
    /// An armour-piercing core on mild steel.
    CoreOnMildSteel,
    /// An armour-piercing core on armour steel.
    CoreOnArmourSteel,
    /// Concrete.
    Concrete,
    /// A measurement that is in the table already, computed with another input, or one of a quantity that the model does not
    /// aim at: in no statistics.
    Aside,
}

impl Class {
    /// All that are counted, in the order of the table.
    pub const COUNTED: [Self; 10] = [
        Self::Hemisphere,
        Self::ThinPlate,
        Self::RepeatHits,
        Self::OtherNoses,
        Self::CoreOnAluminium,
        Self::CoreOblique,
        Self::ObliqueRatio,
        Self::CoreOnMildSteel,
        Self::CoreOnArmourSteel,
        Self::Concrete,
    ];

    /// Its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Hemisphere => "hemisphere on steel",
            Self::ThinPlate => "sphere on a thin plate",
            Self::RepeatHits => "repeat hits at one place",
            Self::OtherNoses => "blunt and conical noses",
            Self::CoreOnAluminium => "AP core on aluminium",
            Self::CoreOblique => "AP core on aluminium, oblique",
            Self::ObliqueRatio => "limit at an angle over that at 0 deg",
            Self::CoreOnMildSteel => "AP core on mild steel",
            Self::CoreOnArmourSteel => "AP core on armour steel (RHA)",
            Self::Concrete => "ogive in concrete",
            Self::Aside => "not counted",
        }
    }
}

/// One measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// A short name.
    pub id: &'static str,
    /// The bundled preset of the shot.
    pub preset: &'static str,
    /// What differs from the preset, as `--set` takes it.
    pub set: &'static [(&'static str, &'static str)],
    /// What it is of.
    pub class: Class,
    /// What was measured.
    pub quantity: Quantity,
    /// The measurement, in its unit.
    pub measured: f64,
    /// Its resolution, where it is known, in its unit.
    pub resolution: Option<f64>,
    /// The nose, and what stands for it here.
    pub nose: &'static str,
    /// What the projectile is made of, so far as it is known: it must stay rigid.
    pub projectile: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Where the model must not be used, seen in this case.
    pub caution: &'static str,
}

/// What is known of, and nothing can be checked by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotChecked {
    /// A short name.
    pub id: &'static str,
    /// What there is.
    pub says: &'static str,
    /// Why it cannot be checked from the data at hand.
    pub why: &'static str,
    /// Where it comes from.
    pub source: &'static str,
}

/// A case with what the model makes of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The case.
    pub case: &'static Case,
    /// By the case's own closure; `None` where the model gives nothing.
    pub computed: Option<f64>,
    /// Its closure's word.
    pub closure: &'static str,
    /// By the other closure; `None` where the flow strength is given outright.
    pub other: Option<f64>,
    /// Plate thickness over projectile diameter.
    pub thickness_ratio: f64,
    /// Pressure on the nose at the start, which the projectile must bear to stay rigid, Pa.
    pub pressure_pa: f64,
    /// Where the closure is used beyond the plates it suits: in words.
    pub beyond: Option<String>,
}

impl Row {
    /// How far off a value is, relative to the measurement.
    pub fn error(&self, value: f64) -> f64 {
        value / self.case.measured - 1.0
    }
}

/// Compute a case from its preset's scene.
pub fn compute(case: &'static Case, preset: &Scene) -> Row {
    let mut scene = preset.clone();
    for (name, value) in case.set {
        // A text that cannot be set would be seen at once: the row's numbers would be the preset's.
        let _ = variables::set_by_name(&mut scene, name, value, Bare::Si);
    }
    let v = scene.projectile.velocity_m_s;
    Row {
        case,
        computed: value(case.quantity, &scene),
        closure: match scene.target.closure {
            Closure::Given => "given",
            Closure::DoubleYield => "double-yield",
            Closure::Cavity => "cavity",
        },
        other: other(&scene).and_then(|scene| value(case.quantity, &scene)),
        thickness_ratio: 0.5 * scene.target.thickness_m / scene.projectile.tip_radius_m,
        pressure_pa: scene.flow_strength_pa() + scene.drag_kg_m3() * v * v,
        beyond: envelope::of_scene(&scene)
            .into_iter()
            .find(|breach| breach.check == Check::Thickness)
            .map(|breach| breach.to_string()),
    }
}

/// The scene under the other closure, with the drag each is made with: Virostek's `C_d` = 0.5 for 2 Y, a hemisphere's 1 for
/// cavity expansion.
fn other(scene: &Scene) -> Option<Scene> {
    let mut own = scene.clone();
    (own.target.closure, own.target.dishing, own.target.drag_coefficient) =
        match scene.target.closure {
            Closure::Given => return None,
            Closure::DoubleYield => (Closure::Cavity, false, 1.0),
            Closure::Cavity => (Closure::DoubleYield, true, 0.5),
        };
    Some(own)
}

fn value(quantity: Quantity, scene: &Scene) -> Option<f64> {
    variables::validate(scene).ok()?;
    match quantity {
        Quantity::Limit => limit::closed_form(scene),
        // A hit leaves a hole of the volume its energy opens, and the next one starts at that depth. So N hits of mass m do what one of
        // mass N m does at their velocity.
        Quantity::RepeatLimit(hits) => {
            let mut joined = scene.clone();
            joined.projectile.mass_kg *= f64::from(hits);
            limit::closed_form(&joined)
        }
        Quantity::Ratio => {
            let mut straight = scene.clone();
            straight.projectile.obliquity_deg = 0.0;
            Some(limit::closed_form(scene)? / limit::closed_form(&straight)?)
        }
        Quantity::Strength => Some(scene.flow_strength_pa()),
        Quantity::Bulge => scene.target.dishing.then_some(2.0 * scene.projectile.tip_radius_m),
        Quantity::Depth => {
            let settings = Settings { series: false, estimate: false };
            let scene = Arc::new(scene.clone());
            let run = simulate(&scene, &settings, &mut |_| ControlFlow::Continue(())).ok()?;
            run.final_penetration_m
        }
    }
}
