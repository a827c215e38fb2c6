//! Verdict on a shot: whether the plate stops it, as expected from measurements of such shots.
//!
//! All commands, pages and files use this verdict. A shot below the band of the expected limit is stopped; a shot above it perforates.
//! Without a class of measurements the law decides, and the verdict states this.

use crate::study::limit::{self, LimitReport};
use crate::study::measured::class::{Class, Expectation, Key};
use crate::study::measured::known::known;
use cmra_engine::model::scene::{Mount, Scene};
use cmra_engine::model::units::{fixed_significant, velocity};
use cmra_engine::numerics::larger;

enumeration! {
    /// Answer to "does this armour stop this shot?".
    pub enum Decision in DecisionRow {
        /// Keyword in files.
        word: &'static str,
        /// Short text for the user.
        words: &'static str,
    }
    /// Impact velocity below the band of the expected limit.
    Stops { word: "stops", words: "stops it" }
    /// Impact velocity within the band.
    Open { word: "open", words: "open: within the band of the limit" }
    /// Impact velocity above the band.
    Perforates { word: "perforates", words: "is perforated" }
    /// No class of measurements applies: the law decides.
    NotMeasured { word: "not-measured", words: "not measured: the law decides" }
}

/// Limit expected from measurements, with the band that contains 90 % of such limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    /// Lower end of the band, m/s.
    pub low_m_s: f64,
    /// Expected limit, m/s.
    pub limit_m_s: f64,
    /// Upper end of the band, m/s.
    pub high_m_s: f64,
    /// Class of measurements, in words.
    pub class: String,
    /// Number of rows of the class.
    pub measurements: usize,
    /// Number of papers of the class.
    pub papers: usize,
    /// Mean of law over measurement, less 1.
    pub bias: f64,
    /// Standard deviation of ln(law/measured) for a limit of an unseen paper.
    pub deviation: f64,
}

/// Verdict on a shot, with the limits it is based on.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Limit by the law, m/s; `None` if unknown.
    pub limit_m_s: Option<f64>,
    /// The expected limit; `None` without a class of measurements.
    pub expected: Option<Expected>,
    /// Decision on the shot.
    pub decision: Decision,
}

/// Relative tolerance of a limit. A design that a search sizes for the lower end of the band lies on it to this accuracy, and stops.
const LIMIT_TOLERANCE: f64 = 1e-9;

impl Verdict {
    /// Returns the verdict on a scene's shot; uses the limit in closed form if there is one.
    pub fn from_scene(scene: &Scene) -> Self {
        Self::with_limit(scene, limit::closed_form(scene))
    }

    /// Returns the verdict on a scene's shot, given its limit by the law, m/s.
    pub fn with_limit(scene: &Scene, limit_m_s: Option<f64>) -> Self {
        Self::by_classes(scene, limit_m_s, known)
    }

    /// Returns the verdict by these classes; calls `classes` only for a shot that may have one.
    pub(in crate::study) fn by_classes<'c>(
        scene: &Scene,
        limit_m_s: Option<f64>,
        classes: impl FnOnce() -> &'c [Class],
    ) -> Self {
        let expected = limit_m_s.and_then(|law_m_s| {
            let found = Expectation::from_scene(scene, classes)?;
            let [low_m_s, limit_m_s, high_m_s] = found.band_m_s(law_m_s);
            Some(Expected {
                low_m_s,
                limit_m_s,
                high_m_s,
                class: found.class.key.words(),
                measurements: found.class.measurements,
                papers: found.class.papers,
                bias: found.bias.exp_m1(),
                deviation: found.deviation,
            })
        });
        let v_m_s = scene.projectile.velocity_m_s;
        let decision = expected.as_ref().map_or(Decision::NotMeasured, |band| {
            if v_m_s <= band.low_m_s * (1.0 + LIMIT_TOLERANCE) {
                Decision::Stops
            } else if v_m_s > band.high_m_s {
                Decision::Perforates
            } else {
                Decision::Open
            }
        });
        Self { limit_m_s, expected, decision }
    }

    /// Returns the safety factor of a design: the law's limit over the largest impact velocity. The velocity is the lower end of the band
    /// if such shots were measured; else the factor is 1. A moving plate uses the factor of the same plate on a rigid mount, an assumption.
    pub fn margin(scene: &Scene) -> f64 {
        let mut rigid = Scene { sweep: None, ..scene.clone() };
        rigid.plate.mount = Mount::Rigid;
        if Key::from_scene(&rigid).is_none() {
            return 1.0;
        }
        let verdict = Self::from_scene(&rigid);
        let low_m_s = verdict.expected.as_ref().map(|band| band.low_m_s);
        let margin = verdict.limit_m_s.zip(low_m_s).map(|(law_m_s, low_m_s)| law_m_s / low_m_s);
        margin.map_or(1.0, |margin| larger(margin, 1.0))
    }

    /// Returns the velocity below which the shot is safe for a design, m/s: the lower end of the band, else the law's limit; `None` without
    /// a limit.
    pub fn safe_below_m_s(&self) -> Option<f64> {
        self.expected.as_ref().map(|band| band.low_m_s).or(self.limit_m_s)
    }

    /// Returns the limit to display first, m/s: the expected limit, else the law's limit.
    pub fn headline_m_s(&self) -> Option<f64> {
        self.expected.as_ref().map(|band| band.limit_m_s).or(self.limit_m_s)
    }
}

impl LimitReport {
    /// Returns the margin of the expected limit, else of the law's limit, over the scene's impact velocity, relative to that velocity.
    pub fn margin(&self) -> Option<f64> {
        let velocity = self.verdict().headline_m_s()?;
        Some(velocity / self.scene.projectile.velocity_m_s - 1.0)
    }

    /// Returns the verdict on the scene's own shot.
    pub fn verdict(&self) -> Verdict {
        Verdict::with_limit(&self.scene, self.limit.velocity_m_s())
    }
}

impl Expected {
    /// Formats the expected limit with its band and its class.
    pub fn words(&self) -> String {
        format!(
            "{} ({} to {}): {}, {} measured limits of {} papers",
            velocity(self.limit_m_s, 4),
            fixed_significant(self.low_m_s, 4),
            velocity(self.high_m_s, 4),
            self.class,
            self.measurements,
            self.papers
        )
    }
}
