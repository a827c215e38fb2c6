//! The verdict on a shot: whether a plate stops it, by what measurements of such shots let expect.
//!
//! Every command, page and file takes its answer from here. A shot below the band of the expected limit is stopped, a shot above it
//! perforates. Without a class of measurements the law decides, and the verdict says so.

use crate::study::limit;
use crate::study::measured::{Class, Expectation, Key, known};
use cmra_engine::model::scene::{Mount, Scene};
use cmra_engine::model::units::{fixed_significant, velocity};
use cmra_engine::numerics::larger;

enumeration! {
    /// The answer to "does this armour stop this shot?".
    pub enum Decision in DecisionRow {
        /// The word in files.
        word: &'static str,
        /// The answer in a few words.
        words: &'static str,
    }
    /// Slower than the band of the expected limit.
    Stops { word: "stops", words: "stops it" }
    /// Within the band.
    Open { word: "open", words: "open: within the band of the limit" }
    /// Faster than the band.
    Perforates { word: "perforates", words: "is perforated" }
    /// No class of measurements applies: the law decides.
    NotMeasured { word: "not-measured", words: "not measured: the law decides" }
}

/// The limit that measurements let expect, with the band that holds 90 % of such limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    /// Lower end of the band, m/s.
    pub low_m_s: f64,
    /// Expected limit, m/s.
    pub limit_m_s: f64,
    /// Upper end of the band, m/s.
    pub high_m_s: f64,
    /// The class of measurements in words.
    pub class: String,
    /// Rows of the class.
    pub measurements: usize,
    /// Papers of the class.
    pub papers: usize,
    /// Mean of law over measurement, less one.
    pub bias: f64,
    /// Standard deviation of ln(law/measured) for a limit of an unseen paper.
    pub deviation: f64,
}

/// The verdict on a shot, with the limits that it rests on.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Limit by the law, m/s; `None` where it is not known.
    pub limit_m_s: Option<f64>,
    /// The expected limit; `None` without a class of measurements.
    pub expected: Option<Expected>,
    /// The answer.
    pub decision: Decision,
}

impl Verdict {
    /// The verdict on a scene's shot, with the limit in closed form where there is one.
    pub fn from_scene(scene: &Scene) -> Self {
        Self::with_limit(scene, limit::closed_form(scene))
    }

    /// The verdict on a scene's shot with a limit by the law that is known already, m/s.
    pub fn with_limit(scene: &Scene, limit_m_s: Option<f64>) -> Self {
        Self::by_classes(scene, limit_m_s, known)
    }

    /// The verdict by some classes, which are computed only for a shot that may have one.
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
            if v_m_s < band.low_m_s {
                Decision::Stops
            } else if v_m_s > band.high_m_s {
                Decision::Perforates
            } else {
                Decision::Open
            }
        });
        Self { limit_m_s, expected, decision }
    }

    /// Factor by which a design's shot is to be slower than the limit by the law: down to the lower end of the band of measured limits where
    /// such shots were measured, else 1. On a moving plate it is that of the same plate on a rigid mount, an assumption.
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

    /// Whether the shot is slow enough for a design, m/s: below the band where there is one, else below the law's limit. `None` without
    /// any limit.
    pub fn safe_below_m_s(&self) -> Option<f64> {
        self.expected.as_ref().map(|band| band.low_m_s).or(self.limit_m_s)
    }

    /// The limit to show first, m/s: the expected one, else that of the law.
    pub fn headline_m_s(&self) -> Option<f64> {
        self.expected.as_ref().map(|band| band.limit_m_s).or(self.limit_m_s)
    }
}

impl Expected {
    /// The expected limit with its band and its class in words.
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
