//! The known error of the model in limit velocities, by class of shot: what `cmra validate` finds, as numbers that a study can use
//! without computing every measurement again. A test compares both.

use crate::model::run::envelope::equivalent_yield_pa;
use crate::model::scene::{ContactModel, Nose, Scene};
use crate::numerics::random::Random;

/// How far the model itself is off.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ModelError {
    /// Model over measurement, less 1: negative where limits come out low; > -1.
    pub bias: f64,
    /// Standard deviation of the logarithm of model over measurement, >= 0.
    pub spread: f64,
}

impl ModelError {
    /// The correction factor of a computed limit, drawn.
    pub(in crate::study) fn factor(self, random: &mut Random) -> f64 {
        let spread = if self.spread > 0.0 { (self.spread * random.normal()).exp() } else { 1.0 };
        spread / (1.0 + self.bias)
    }

    /// The band of measured limits to expect at a computed one, m/s: within two standard deviations.
    pub fn band_m_s(self, limit_m_s: f64) -> (f64, f64) {
        let middle = limit_m_s / (1.0 + self.bias);
        let factor = (2.0 * self.spread).exp();
        (middle / factor, middle * factor)
    }
}

/// The known error of a class of shots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KnownError {
    /// The class, as in the measurements.
    pub class: &'static str,
    /// How many measurements it is from.
    pub points: usize,
    /// The error; of a single measurement the spread is not known, and 0 here.
    pub error: ModelError,
}

const fn known(class: &'static str, points: usize, bias: f64, spread: f64) -> KnownError {
    KnownError { class, points, error: ModelError { bias, spread } }
}

/// The classes of limit velocities.
pub const KNOWN: [KnownError; 6] = [
    known("hemisphere on steel", 1, 0.026, 0.0),
    known("blunt nose", 1, -0.196, 0.0),
    known("AP core on aluminium", 2, -0.001, 0.018),
    known("AP core on aluminium, oblique", 3, -0.094, 0.070),
    known("AP core on mild steel", 7, -0.092, 0.081),
    known("AP core on armour steel (RHA)", 6, 0.258, 0.160),
];

/// Yield strength of armour steel, at least, Pa.
const HARD_PA: f64 = 7.5e8;
/// Densities of aluminium alloys and of steels, kg/m³.
const ALUMINIUM: std::ops::RangeInclusive<f64> = 2600.0..=2900.0;
const STEEL: std::ops::RangeInclusive<f64> = 7600.0..=8000.0;

impl KnownError {
    /// That of the class a scene belongs to; `None` where its shot was measured by nobody in the table.
    pub fn of(scene: &Scene) -> Option<&'static Self> {
        if scene.contact.model != ContactModel::Hydrodynamic || scene.is_stack() {
            return None;
        }
        let density = scene.target.density_kg_m3;
        let (is_aluminium, is_steel) = (ALUMINIUM.contains(&density), STEEL.contains(&density));
        let is_oblique = scene.projectile.obliquity_deg > 0.0;
        let class = match scene.projectile.nose {
            Nose::Blunt if !is_oblique => "blunt nose",
            Nose::Hemispherical if is_steel && !is_oblique => "hemisphere on steel",
            Nose::Pointed if is_aluminium && is_oblique => "AP core on aluminium, oblique",
            Nose::Pointed if is_aluminium => "AP core on aluminium",
            Nose::Pointed if is_steel && !is_oblique => {
                let is_hard = equivalent_yield_pa(scene) >= HARD_PA;
                if is_hard { "AP core on armour steel (RHA)" } else { "AP core on mild steel" }
            }
            Nose::Blunt | Nose::Fragment | Nose::Hemispherical | Nose::Pointed => return None,
        };
        KNOWN.iter().find(|known| known.class == class)
    }
}
