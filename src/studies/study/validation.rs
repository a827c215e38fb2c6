//! Measurements from sources other than the thesis, compared with the model without fitting.
//!
//! Measurements and their sources are in `data/measurements.toml`. The model's values are computed, by the case's own closure of the flow
//! strength and by the alternative closure. The scenes are bundled presets. Measurements that cannot be checked are listed with the reason.

use std::sync::LazyLock;

use serde::Deserialize;

use crate::study::envelope::{self, Check};
use crate::study::quantities::{Quantity, find};
use crate::study::{changed, limit, plain_run, run_with};
use cmra_engine::model::run::Warning;
use cmra_engine::model::scene::{Closure, Scene};
use cmra_engine::model::simulate::Settings;
use cmra_engine::model::variables;

mod bias;

pub use bias::{Bias, biases};

/// Measurements as TOML.
const FILE: &str = include_str!("../data/measurements.toml");

/// Class of measurements that are excluded from the statistics.
pub const NOT_COUNTED: &str = "not counted";

/// Measurements from sources other than the thesis.
#[derive(Default)]
pub struct Measurements {
    /// Classes in the statistics, in the order of tables. The accuracy of the model differs between them.
    pub classes: Vec<&'static str>,
    /// Measurements, in the order of pages.
    pub cases: Vec<Case>,
    /// Measurements that cannot be used as a check.
    pub not_checked: Vec<NotChecked>,
}

/// Returns all measurements; none if the file is invalid, which a test excludes.
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

/// Measurement of a group, with the fields that differ within the group.
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

/// Measured quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeasuredQuantity {
    /// Ballistic limit, m/s.
    Limit,
    /// Depth, m.
    Depth,
    /// Velocity at which the last of a number of equal hits at the same place perforates, m/s.
    RepeatLimit(u8),
    /// Ballistic limit over that of the same plate at 0 deg.
    Ratio,
    /// Resistance of the target to a slow nose, Pa.
    Strength,
    /// Bulge of the plate under the nose, m.
    Bulge,
    /// Change of the projectile's velocity over the closing velocity.
    ProjectileShare,
    /// Change of the plate's velocity over the closing velocity.
    PlateShare,
    /// Momentum of the struck plate and the projectile together, over that of the shot.
    MomentumShare,
    /// Whether an absorber bottoms out: 1 if it does, else 0.
    Bottoms,
    /// Quantity of the run, by name.
    Output(&'static str),
}

impl MeasuredQuantity {
    /// Returns the label.
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
    /// Short name.
    pub id: &'static str,
    /// Bundled preset of the shot.
    pub preset: &'static str,
    /// Changes to the preset, in the format of `--set`.
    pub set: &'static str,
    /// Class of the measurement, or [`NOT_COUNTED`].
    pub class: &'static str,
    /// Measured quantity.
    pub quantity: MeasuredQuantity,
    /// Measured value, in the unit of the quantity.
    pub measured: f64,
    /// Resolution in the unit of the value; `None` if unknown.
    pub resolution: Option<f64>,
    /// Nose of the projectile, and its representation in the model.
    pub nose: &'static str,
    /// Material of the projectile, if known; the model assumes a rigid projectile.
    pub projectile: &'static str,
    /// Source of the measurement.
    pub source: &'static str,
    /// Limitation of the model that this case shows.
    pub caution: &'static str,
}

/// Measurement that cannot be used as a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NotChecked {
    /// Short name.
    pub id: &'static str,
    /// Available data.
    pub says: &'static str,
    /// Reason why the data do not suffice for a check.
    pub why: &'static str,
    /// Source of the measurement.
    pub source: &'static str,
}

/// Case with its computed values.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Case of the measurement.
    pub case: &'static Case,
    /// Value by the case's own closure; `None` if the model gives none.
    pub computed: Option<f64>,
    /// Closure of the scene.
    pub closure: Closure,
    /// Value by the alternative closure; `None` if the flow strength is given directly.
    pub other: Option<f64>,
    /// Plate thickness over projectile diameter.
    pub thickness_ratio: f64,
    /// Initial pressure on the nose, Pa. The strength of a rigid projectile must exceed it.
    pub pressure_pa: f64,
    /// Describes how the plate is outside the range of the closure; `None` inside.
    pub beyond: Option<String>,
}

impl Row {
    /// Returns the error of a value, relative to the measurement.
    pub fn error(&self, value: f64) -> f64 {
        value / self.case.measured - 1.0
    }
}

/// Computes a case from the scene of its preset.
pub fn compute(case: &'static Case, preset: &Scene) -> Row {
    // If a change is invalid, the row visibly has the values of the preset.
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

/// Returns the scene with the alternative closure, its dishing and its drag.
fn other(scene: &Scene) -> Option<Scene> {
    let mut own = scene.clone();
    let closure = match scene.closure() {
        Closure::Given | Closure::Cylindrical => return None,
        Closure::DoubleYield => Closure::Cavity,
        Closure::Cavity | Closure::ByThickness => Closure::DoubleYield,
    };
    own.target = own.target.by_law(closure, own.projectile.nose);
    Some(own)
}

fn value(quantity: MeasuredQuantity, scene: &Scene) -> Option<f64> {
    variables::validate(scene).ok()?;
    match quantity {
        MeasuredQuantity::Limit => limit::closed_form(scene),
        // Each hit opens a hole of a volume proportional to its energy, and the next hit starts at that depth. N hits of mass m therefore
        // equal one hit of mass N m at the same velocity.
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
        MeasuredQuantity::Depth => plain_run(scene)?.penetration.final_m,
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

/// Computes the velocity changes of projectile and plate until arrest or separation, over the closing velocity. The change of the plate
/// follows from momentum.
fn shares(scene: &Scene) -> Option<(f64, f64)> {
    let run = plain_run(scene)?;
    let common = || run.first_arrest.map(|arrest| arrest.plate_velocity_m_s);
    let after_m_s = run.departure.separation.map(|it| it.velocity_m_s).or_else(common)?;
    let change = (scene.projectile.velocity_m_s - after_m_s) / scene.closing_velocity_m_s();
    Some((change, change / scene.mass_ratio()))
}
