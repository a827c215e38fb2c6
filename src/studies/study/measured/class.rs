//! Classes of measured limits: bias and scatter of the law, computed from a table, and the expected limit.

use crate::study::envelope::thickness_ratio;
use crate::study::statistics::student_quantile;
use cmra_engine::model::scene::{Closure, ContactModel, Core, Criterion, Nose, Scene};
use cmra_engine::numerics::larger;

/// Ranges of density, kg/m³, and of elastic modulus, Pa, that the measurements of an alloy cover.
const LIGHT: ([f64; 2], [f64; 2]) = ([2600.0, 2900.0], [65e9, 75e9]);
const STEEL: ([f64; 2], [f64; 2]) = ([7700.0, 7900.0], [190e9, 210e9]);
/// Angle limits, deg: classes of normal impact are below the first; classes of oblique impact end at the second.
const OBLIQUE_DEG: [f64; 2] = [10.0, 30.0];
/// Yield strength, Pa, and h/D of a plate that breaks a pointed core: above the strength and below the ratio the law is 40 to 50 % high.
const BREAKING: (f64, f64) = (1.25e9, 0.7);
/// Fraction of the limits of a class on one side of a band end.
const ONE_SIDED: f64 = 0.95;
/// Minimum number of papers of a class; also the minimum number of rows and papers for a scatter of its own.
const PAPERS_LEAST: usize = 2;
const OWN_SCATTER_FROM: (usize, usize) = (5, 3);
/// Relative rounding tolerance of h/D at the ends of a class.
const ROUNDING: f64 = 1e-9;

/// Alloy of a plate, by density and elastic modulus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alloy {
    /// 2600 to 2900 kg/m³, with an elastic modulus of 65e9 to 75e9 Pa.
    Light,
    /// 7700 to 7900 kg/m³, with an elastic modulus of 190e9 to 210e9 Pa.
    Steel,
}

/// Key of a class: the common properties of its shots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    /// Nose of the projectile.
    pub nose: Nose,
    /// Core of the projectile.
    pub core: Core,
    /// Alloy of the plate.
    pub alloy: Alloy,
    /// Whether the angle is 10 to 30 deg; else it is below 10 deg.
    pub is_oblique: bool,
}

impl Key {
    /// Returns the class of a scene's shot; `None` if the scene uses the law differently from the measurements.
    pub fn from_scene(scene: &Scene) -> Option<Self> {
        let (projectile, target) = (&scene.projectile, scene.target_in_effect());
        let is_rigid_plate = !scene.is_sprung() && !scene.is_stack();
        let law = target.by_law(Closure::Cylindrical, projectile.nose);
        let is_law = scene.contact.model == ContactModel::Hydrodynamic
            && (target.closure, target.dishing) == (law.closure, law.dishing)
            && target.criterion == Criterion::Passage
            && (target.drag_coefficient - law.drag_coefficient).abs() < ROUNDING;
        let is_in = |value: f64, [low, high]: [f64; 2]| (low..=high).contains(&value);
        let is_of = |(density, modulus)| {
            is_in(target.density_kg_m3, density) && is_in(target.modulus_pa, modulus)
        };
        let alloy = [(Alloy::Light, LIGHT), (Alloy::Steel, STEEL)];
        let alloy = alloy.into_iter().find(|it| is_of(it.1))?.0;
        let is_pointed = projectile.nose == Nose::Pointed;
        let breaks =
            is_pointed && target.yield_pa >= BREAKING.0 && thickness_ratio(scene) < BREAKING.1;
        let theta = projectile.obliquity_deg;
        // The plug law is for normal impact only.
        let most_deg = if is_pointed { OBLIQUE_DEG[1] } else { 0.0 };
        let is_known = projectile.core != Core::Deformable && theta <= most_deg;
        (is_rigid_plate && is_law && is_known && !breaks).then_some(Self {
            nose: projectile.nose,
            core: projectile.core,
            alloy,
            is_oblique: theta >= OBLIQUE_DEG[0],
        })
    }

    /// Returns the class in words: `steel core on light alloy, oblique`. A core is pointed; oblique is 10 to 30 deg, else the angle is
    /// below 10 deg.
    pub fn words(self) -> String {
        let angle = if self.is_oblique { ", oblique" } else { "" };
        let nose = match self.nose {
            Nose::Pointed => format!("{} core", self.core.word()),
            nose => nose.word().to_owned(),
        };
        let alloy = match self.alloy {
            Alloy::Light => "light alloy",
            Alloy::Steel => "steel",
        };
        format!("{nose} on {alloy}{angle}")
    }
}

/// Measured limit, with the error of the law.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Class of the row.
    pub key: Key,
    /// Publication of the measurement.
    pub paper: String,
    /// Error ln(law/measured).
    pub error: f64,
    /// Plate thickness over projectile diameter, h/D.
    pub thickness: f64,
    /// Impact angle, deg.
    pub angle_deg: f64,
}

/// Class of measurements with its statistics.
#[derive(Clone, Debug, PartialEq)]
pub struct Class {
    /// Common properties of the shots.
    pub key: Key,
    /// Number of rows.
    pub measurements: usize,
    /// Number of papers.
    pub papers: usize,
    /// Mean over the papers of each paper's mean of ln(law/measured).
    pub bias: f64,
    /// Standard deviation of ln(law/measured) for a limit of an unseen paper.
    pub deviation: f64,
    /// Student factor of the band that contains 90 % of the limits.
    pub student: f64,
    /// Minimum and maximum h/D.
    pub thickness: [f64; 2],
    /// Minimum and maximum angle, deg.
    pub angle_deg: [f64; 2],
}

/// Number, mean and sum of squared deviations of a paper's errors.
struct Paper<'p> {
    name: &'p str,
    errors: Vec<f64>,
}

impl Paper<'_> {
    fn mean(&self) -> f64 {
        mean(&self.errors)
    }

    fn squares(&self) -> f64 {
        squares(&self.errors)
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn squares(values: &[f64]) -> f64 {
    let mean = mean(values);
    values.iter().map(|value| (value - mean).powi(2)).sum()
}

/// Computes the classes of the samples, in the order of their first sample.
///
/// The variance of a class is the sum of the variances within its papers and between papers. The variance between papers is estimated from
/// all classes with several papers, as the variance of their means. In the built-in table its standard deviation is 3.2 %; an analysis of
/// variance gives 2.6 % with equal weights of the papers and 3.4 % with weights by rows. A class of fewer than five rows or three papers
/// uses the variance within the papers of all classes.
pub fn classes(samples: &[Sample]) -> Vec<Class> {
    let mut groups: Vec<(Key, Vec<Paper<'_>>)> = Vec::new();
    for sample in samples {
        let at = groups.iter().position(|group| group.0 == sample.key).unwrap_or(groups.len());
        if at == groups.len() {
            groups.push((sample.key, Vec::new()));
        }
        let papers = &mut groups[at].1;
        match papers.iter_mut().find(|paper| paper.name == sample.paper) {
            Some(paper) => paper.errors.push(sample.error),
            None => papers.push(Paper { name: &sample.paper, errors: vec![sample.error] }),
        }
    }
    // Sum of squares and degrees of freedom: within papers, and between the means of the papers of a class.
    let within = |papers: &[Paper<'_>]| {
        let rows: usize = papers.iter().map(|paper| paper.errors.len()).sum();
        (papers.iter().map(Paper::squares).sum::<f64>(), rows - papers.len())
    };
    let means = |papers: &[Paper<'_>]| papers.iter().map(Paper::mean).collect::<Vec<f64>>();
    let pooled = groups.iter().map(|group| within(&group.1)).fold((0.0, 0), add);
    let between = groups
        .iter()
        .map(|group| (squares(&means(&group.1)), group.1.len() - 1))
        .fold((0.0, 0), add);
    let variance = |(squares, freedom): (f64, usize)| squares / larger(freedom as f64, 1.0);
    let class = |(key, papers): &(Key, Vec<Paper<'_>>)| {
        let own = || samples.iter().filter(|sample| sample.key == *key);
        let rows = own().count();
        let (rows_least, papers_least) = OWN_SCATTER_FROM;
        let has_own = rows >= rows_least && papers.len() >= papers_least;
        let scatter = if has_own { within(papers) } else { pooled };
        Class {
            key: *key,
            measurements: rows,
            papers: papers.len(),
            bias: mean(&means(papers)),
            deviation: (variance(scatter) + variance(between)).sqrt(),
            student: student_quantile(ONE_SIDED, scatter.1.max(1)),
            thickness: range(own().map(|sample| sample.thickness)),
            angle_deg: range(own().map(|sample| sample.angle_deg)),
        }
    };
    groups.iter().map(class).collect()
}

fn add(a: (f64, usize), b: (f64, usize)) -> (f64, usize) {
    (a.0 + b.0, a.1 + b.1)
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let ends = |[low, high]: [f64; 2], value: f64| [low.min(value), high.max(value)];
    values.fold([f64::INFINITY, f64::NEG_INFINITY], ends)
}

/// Correction of the law's limit, from measurements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expectation<'c> {
    /// Class of measurements.
    pub class: &'c Class,
    /// Mean of ln(law/measured).
    pub bias: f64,
    /// Standard deviation of ln(law/measured).
    pub deviation: f64,
    /// Half the width of the band in ln(law/measured).
    pub half_width: f64,
}

impl<'c> Expectation<'c> {
    /// Returns the expectation for a scene's shot; `None` without a similar class of two or more papers. Calls `classes` only for a shot
    /// that may have one.
    pub fn from_scene(scene: &Scene, classes: impl FnOnce() -> &'c [Class]) -> Option<Self> {
        let key = Key::from_scene(scene)?;
        Self::at(key, thickness_ratio(scene), scene.projectile.obliquity_deg, classes())
    }

    /// Returns the expectation for a shot of a class at h/D and an angle, deg.
    pub fn at(key: Key, thickness: f64, angle_deg: f64, classes: &'c [Class]) -> Option<Self> {
        let class = |key: Key| {
            classes.iter().find(|class| class.key == key && class.papers >= PAPERS_LEAST)
        };
        let own = class(key)?;
        let [low, high] = own.thickness;
        if !(low * (1.0 - ROUNDING)..=high * (1.0 + ROUNDING)).contains(&thickness) {
            return None;
        }
        let of = |class: &'c Class| Self {
            class: own,
            bias: class.bias,
            deviation: class.deviation,
            half_width: class.student * class.deviation,
        };
        let (from, to) = (OBLIQUE_DEG[0], OBLIQUE_DEG[1]);
        if !key.is_oblique || angle_deg >= to {
            return (angle_deg <= larger(own.angle_deg[1], from)).then(|| of(own));
        }
        let normal = of(class(Key { is_oblique: false, ..key })?);
        let (oblique, fraction) = (of(own), (angle_deg - from) / (to - from));
        let between = |a: f64, b: f64| a + fraction * (b - a);
        Some(Self {
            class: own,
            bias: between(normal.bias, oblique.bias),
            deviation: between(normal.deviation, oblique.deviation),
            half_width: between(normal.half_width, oblique.half_width),
        })
    }

    /// Returns the lower end of the band, the expected limit and the upper end, m/s, for a limit by the law.
    pub fn band_m_s(&self, law_m_s: f64) -> [f64; 3] {
        let expected = law_m_s * (-self.bias).exp();
        [expected * (-self.half_width).exp(), expected, expected * self.half_width.exp()]
    }
}
