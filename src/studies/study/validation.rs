//! Measurements from outside the thesis, and what the model computes for them, with nothing fitted.
//!
//! Measurements and their sources are in `data/measurements.toml`; the model's values are always
//! computed, by the case's own closure for the flow strength and by the other one. The scenes are bundled presets. Measurements that
//! cannot be checked are listed with the reason.

use std::sync::LazyLock;

use serde::Deserialize;

use crate::study::quantities::{Quantity, find};
use crate::study::{changed, limit, plain_run, run_with};
use cmra_engine::model::run::Warning;
use cmra_engine::model::run::envelope::{self, Check};
use cmra_engine::model::scene::{Closure, Scene};
use cmra_engine::model::simulate::Settings;
use cmra_engine::model::variables;

mod bias;

pub use bias::{Bias, biases};

/// The measurements as they are written.
const FILE: &str = include_str!("../data/measurements.toml");

/// The class of a measurement that is in no statistics.
pub const NOT_COUNTED: &str = "not counted";

/// The measurements from outside the thesis.
#[derive(Default)]
pub struct Measurements {
    /// The classes that are counted, in the order of tables: the model is good for some and bad for others.
    pub classes: Vec<&'static str>,
    /// The measurements, in the order of pages.
    pub cases: Vec<Case>,
    /// Further measurements that cannot be used as a check.
    pub not_checked: Vec<NotChecked>,
}

/// All measurements; none where the file is wrong, which a test refuses.
pub fn measurements() -> &'static Measurements {
    static ALL: LazyLock<Measurements> = LazyLock::new(|| read(FILE).unwrap_or_default());
    &ALL
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(borrow)]
    classes: Vec<&'static str>,
    group: Vec<Group>,
    not_checked: Vec<NotChecked>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Group {
    preset: &'static str,
    class: &'static str,
    quantity: MeasuredQuantity,
    nose: &'static str,
    projectile: &'static str,
    source: &'static str,
    caution: &'static str,
    case: Vec<Entry>,
}

/// A measurement of a group, with what it has of its own.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    id: &'static str,
    #[serde(default)]
    set: &'static str,
    class: Option<&'static str>,
    quantity: Option<MeasuredQuantity>,
    measured: f64,
    over: Option<f64>,
    resolution: Option<f64>,
    nose: Option<&'static str>,
    caution: Option<&'static str>,
}

fn read(text: &'static str) -> Result<Measurements, toml::de::Error> {
    let File { classes, group, not_checked } = toml::from_str(text)?;
    let cases = group.into_iter().flat_map(|group| {
        let case = move |own: Entry| Case {
            id: own.id,
            preset: group.preset,
            set: own.set,
            class: own.class.unwrap_or(group.class),
            quantity: own.quantity.unwrap_or(group.quantity),
            measured: own.measured / own.over.unwrap_or(1.0),
            resolution: own.resolution,
            nose: own.nose.unwrap_or(group.nose),
            projectile: group.projectile,
            source: group.source,
            caution: own.caution.unwrap_or(group.caution),
        };
        group.case.into_iter().map(case)
    });
    Ok(Measurements { classes, cases: cases.collect(), not_checked })
}

/// The measured quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeasuredQuantity {
    /// The ballistic limit, m/s.
    Limit,
    /// The depth, m.
    Depth,
    /// The velocity at which the last of a given number of equal hits at one place perforates, m/s.
    RepeatLimit(u8),
    /// The ballistic limit over that of the same plate at 0 deg.
    Ratio,
    /// The strength the target opposes to a slow nose, Pa.
    Strength,
    /// How far the plate bulges under the nose, m.
    Bulge,
    /// Change of the projectile's velocity over the closing velocity.
    ProjectileShare,
    /// Change of the plate's velocity over the closing velocity.
    PlateShare,
    /// Momentum that the struck plate and the projectile have together over that of the shot.
    MomentumShare,
    /// Whether an absorber is crushed flat: 1 if it is, else 0.
    Bottoms,
    /// A quantity of the run, by its name.
    Output(&'static str),
}

impl MeasuredQuantity {
    /// The word.
    pub fn label(self) -> &'static str {
        match self {
            Self::Limit => "ballistic limit",
            Self::RepeatLimit(2) => "ballistic limit of two equal hits at one place",
            Self::RepeatLimit(_) => "ballistic limit of three equal hits at one place",
            Self::Depth => "depth",
            Self::Ratio => "limit over that at 0 deg",
            Self::Strength => "flow strength",
            Self::Bulge => "bulge",
            Self::ProjectileShare => "projectile's velocity change over closing velocity",
            Self::PlateShare => "plate's velocity change over closing velocity",
            Self::MomentumShare => "momentum of plate and projectile over the shot's",
            Self::Bottoms => "absorber crushed flat",
            Self::Output(name) => find(name).map_or(name, |quantity| quantity.meaning),
        }
    }

    /// Returns the unit.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Limit | Self::RepeatLimit(_) => "m/s",
            Self::Depth | Self::Bulge => "m",
            Self::Ratio
            | Self::ProjectileShare
            | Self::PlateShare
            | Self::MomentumShare
            | Self::Bottoms => "",
            Self::Output(name) => find(name).map_or("", Quantity::unit),
            Self::Strength => "Pa",
        }
    }
}

/// Measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// A short name.
    pub id: &'static str,
    /// The bundled preset of the shot.
    pub preset: &'static str,
    /// The changes to the preset, as `--set` takes them.
    pub set: &'static str,
    /// Class of the measurement, or [`NOT_COUNTED`].
    pub class: &'static str,
    /// The measured quantity.
    pub quantity: MeasuredQuantity,
    /// The measurement, in its unit.
    pub measured: f64,
    /// Resolution in the unit of the value; `None` if unknown.
    pub resolution: Option<f64>,
    /// The nose, and what stands for it here.
    pub nose: &'static str,
    /// Material of the projectile, if known; it must stay rigid.
    pub projectile: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Where the model must not be used, seen in this case.
    pub caution: &'static str,
}

/// Measurements that cannot be used as a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NotChecked {
    /// A short name.
    pub id: &'static str,
    /// The available data.
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
    /// Closure of the scene.
    pub closure: Closure,
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
    // A text that cannot be set would be seen at once: the row's numbers would be the preset's.
    let scene = changed(preset.clone(), case.set).unwrap_or_else(|_| preset.clone());
    let v = scene.projectile.velocity_m_s;
    Row {
        case,
        computed: value(case.quantity, &scene),
        closure: scene.closure(),
        other: other(&scene).and_then(|scene| value(case.quantity, &scene)),
        thickness_ratio: 0.5 * scene.target.thickness_m / scene.projectile.tip_radius_m,
        pressure_pa: scene.flow_strength_pa() + scene.drag_kg_m3() * v * v,
        beyond: envelope::of_scene(&scene)
            .into_iter()
            .find(|breach| breach.check == Check::Thickness)
            .map(|breach| Warning::from(&breach).to_string()),
    }
}

/// The scene under the other closure, with the drag each is made with: Virostek's `C_d` = 0.5 for 2 Y, a hemisphere's 1 for
/// cavity expansion.
fn other(scene: &Scene) -> Option<Scene> {
    let mut own = scene.clone();
    (own.target.closure, own.target.dishing, own.target.drag_coefficient) = match scene.closure() {
        Closure::Given | Closure::Cylindrical => return None,
        Closure::DoubleYield => (Closure::Cavity, false, 1.0),
        Closure::Cavity | Closure::ByThickness => (Closure::DoubleYield, true, 0.5),
    };
    Some(own)
}

fn value(quantity: MeasuredQuantity, scene: &Scene) -> Option<f64> {
    variables::validate(scene).ok()?;
    match quantity {
        MeasuredQuantity::Limit => limit::closed_form(scene),
        // A hit leaves a hole of the volume its energy opens, and the next one starts at that depth. So N hits of mass m do what one of
        // mass N m does at their velocity.
        MeasuredQuantity::RepeatLimit(hits) => {
            let mut joined = scene.clone();
            joined.projectile.mass_kg *= f64::from(hits);
            limit::closed_form(&joined)
        }
        MeasuredQuantity::Ratio => {
            let mut straight = scene.clone();
            straight.projectile.obliquity_deg = 0.0;
            Some(limit::closed_form(scene)? / limit::closed_form(&straight)?)
        }
        MeasuredQuantity::Strength => Some(scene.flow_strength_pa()),
        MeasuredQuantity::Bulge => {
            scene.target_in_effect().dishing.then_some(2.0 * scene.projectile.tip_radius_m)
        }
        MeasuredQuantity::Depth => plain_run(scene)?.final_penetration_m,
        MeasuredQuantity::ProjectileShare => shares(scene).map(|shares| shares.0),
        MeasuredQuantity::PlateShare => shares(scene).map(|shares| shares.1),
        MeasuredQuantity::MomentumShare => {
            let common_m_s = plain_run(scene)?.first_arrest?.plate_velocity_m_s;
            Some((1.0 + scene.mass_ratio()) * common_m_s / scene.projectile.velocity_m_s)
        }
        MeasuredQuantity::Bottoms => {
            let far_m = plain_run(scene)?.max_plate_displacement_m?;
            Some(if far_m > scene.mechanism.spring.crush.stroke_m { 1.0 } else { 0.0 })
        }
        MeasuredQuantity::Output(name) => find(name)?.value(&run_with(scene, Settings::SERIES)?),
    }
}

/// Changes of the velocities of projectile and plate up to their first common velocity or their separation, over the closing velocity.
/// Momentum gives the plate's.
fn shares(scene: &Scene) -> Option<(f64, f64)> {
    let run = plain_run(scene)?;
    let common = || run.first_arrest.map(|arrest| arrest.plate_velocity_m_s);
    let after_m_s = run.separation.map(|it| it.velocity_m_s).or_else(common)?;
    let change = (scene.projectile.velocity_m_s - after_m_s) / scene.closing_velocity_m_s();
    Some((change, change / scene.mass_ratio()))
}
