//! What the claims are checked with: both models on a scene, curves along a variable, and the words for numbers.

use std::cell::Cell;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::model::closed_form::Passage;
use crate::model::contact::Geometry;
use crate::model::run::{Outcome, Run};
use crate::model::scene::{Contact, ContactModel, Mount, Projectile, Scene, Target};
use crate::model::simulate::{self, Settings};
use crate::model::units::{self, Engineering};
use crate::model::variables::{self, VARIABLES, Value};
use crate::study::thesis::{Basis, Found, Verdict};

/// The thesis's baseline, m (section 9.3).
pub(super) const BASELINE_M: f64 = 7.129e-3;

/// Longer than any contact here, s.
const CONTACT_S: f64 = 1e-3;

/// Which algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Law {
    /// The engine.
    Sound,
    /// The Appendix as printed, at its own step.
    Printed,
}

/// Both.
pub(super) const LAWS: [Law; 2] = [Law::Sound, Law::Printed];

/// What is measured along a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// Depth as percent of the rigid mount's by the same law.
    Percent,
    /// Greatest displacement, mm.
    Travel,
}

/// An axis: symbol, first value, last value, points.
pub(super) type Axis = (&'static str, f64, f64, usize);

/// A point of a curve.
pub(super) type P = (f64, f64);

/// What a rigid mount's depth depends on.
type Shot = (Law, Projectile, Target, Contact);

/// The bench a claim is checked on.
#[derive(Default)]
pub(super) struct Lab {
    /// Runs made so far.
    runs: Cell<usize>,
    /// The last rigid mount's depth, and what it belongs to.
    baseline: Cell<Option<(Shot, f64)>>,
    /// Once it is set every run ends at its next step: what is found from then on is not kept.
    stop: Arc<AtomicBool>,
}

/// The scene of chapter 9's figures: gamma = 1, k = 1e5, n = 1, nothing else.
pub(super) fn base() -> Scene {
    Scene::default()
}

/// The same with some variables changed.
pub(super) fn with(changes: &[(&str, f64)]) -> Scene {
    changed(base(), changes)
}

/// A scene with some variables changed; names and values are this study's own, so none is refused.
pub(super) fn changed(mut scene: Scene, changes: &[(&str, f64)]) -> Scene {
    for (name, value) in changes {
        let set = variables::find(name).and_then(|it| it.set(&mut scene, Value::Number(*value)));
        debug_assert!(set.is_ok(), "{name} = {value}");
    }
    scene
}

/// The thesis's scene with variables set as `--set` does: for mechanisms, which are chosen by a word.
pub(super) fn spelled(changes: &[(&str, &str)]) -> Scene {
    let mut scene = base();
    for (name, value) in changes {
        let set = variables::set_by_name(&mut scene, name, value, units::Bare::Si);
        debug_assert!(set.is_ok(), "{name} = {value}");
    }
    scene
}

/// A finding of the sound model alone.
pub(super) fn found(sound: String, verdict: Verdict, cause: &'static str) -> Found {
    both(sound, String::new(), verdict, cause)
}

/// A finding of the sound model and of the Appendix as printed.
pub(super) fn both(sound: String, printed: String, verdict: Verdict, cause: &'static str) -> Found {
    let basis = if verdict == Verdict::Unchecked && sound.is_empty() {
        Basis::None
    } else {
        Basis::Computed
    };
    Found { sound, printed, verdict, cause, basis }
}

/// A finding about the thesis's words, tables or numbering: nothing is computed for it.
pub(super) fn read(sound: String, verdict: Verdict, cause: &'static str) -> Found {
    Found { sound, printed: String::new(), verdict, cause, basis: Basis::Read }
}

/// On a rigid mount.
pub(super) fn rigid(mut scene: Scene) -> Scene {
    scene.plate.mount = Mount::Rigid;
    scene
}

/// The numbers of the listing: rho = 2780, `S_y` = 2 x 75.8 `MPa`.
pub(super) fn listing_material(scene: Scene) -> Scene {
    changed(scene, &[("rho", 2780.0), ("S_y", 2.0 * 75.8e6)])
}

impl Lab {
    /// A bench that can be stopped from outside.
    pub(super) fn stopped_by(stop: &Arc<AtomicBool>) -> Self {
        Self { stop: Arc::clone(stop), ..Self::default() }
    }

    /// Whether it was stopped: then nothing found on it counts.
    pub(super) fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Run a scene by a law; series only where asked for.
    pub(super) fn run_with(&self, law: Law, scene: &Scene, series: bool) -> Run {
        let mut own = scene.clone();
        if law == Law::Printed {
            own.contact.model = ContactModel::Appendix;
        }
        self.runs.set(self.runs.get() + 1);
        let settings = Settings { series, estimate: false };
        let own = Arc::new(own);
        let watch = &mut |_t_s: f64| {
            if self.is_stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        simulate::simulate(&own, &settings, watch)
            .expect("the scenes of this study make physical sense")
    }

    /// Run a scene by a law, without series.
    pub(super) fn run(&self, law: Law, scene: &Scene) -> Run {
        self.run_with(law, scene, false)
    }

    /// Depth at the first arrest, m; infinite for a perforation, NaN where there is none.
    pub(super) fn depth_m(&self, law: Law, scene: &Scene) -> f64 {
        let mut own = scene.clone();
        if law == Law::Printed {
            // The listing follows the plate for as long as it swings; its depth is known when the contact ends.
            own.run.horizon_s = own.run.horizon_s.or(Some(CONTACT_S));
        }
        let run = self.run(law, &own);
        match run.outcome {
            Outcome::Perforated => f64::INFINITY,
            Outcome::Arrested | Outcome::Separated | Outcome::Moving => {
                run.first_arrest.map_or(f64::NAN, |arrest| arrest.penetration_m)
            }
        }
    }

    /// Depth over that of the same shot on a rigid mount by the same law, percent.
    pub(super) fn percent(&self, law: Law, scene: &Scene) -> f64 {
        100.0 * self.depth_m(law, scene) / self.baseline_m(law, scene)
    }

    /// The rigid mount's depth, m; curves of the mechanism's variables share one.
    fn baseline_m(&self, law: Law, scene: &Scene) -> f64 {
        let shot = (law, scene.projectile, scene.target, scene.contact);
        if let Some((_, depth_m)) = self.baseline.get().filter(|(own, _)| *own == shot) {
            return depth_m;
        }
        let depth_m = self.depth_m(law, &rigid(scene.clone()));
        self.baseline.set(Some((shot, depth_m)));
        depth_m
    }

    /// How many runs it took.
    pub(super) fn runs(&self) -> usize {
        self.runs.get()
    }

    /// Greatest displacement, mm; infinite where nothing stops the plate.
    pub(super) fn travel_mm(&self, law: Law, scene: &Scene) -> f64 {
        self.run(law, scene).max_plate_displacement_m.map_or(f64::INFINITY, |x| 1e3 * x)
    }

    pub(super) fn measure(&self, law: Law, measure: Measure, scene: &Scene) -> f64 {
        match measure {
            Measure::Percent => self.percent(law, scene),
            Measure::Travel => self.travel_mm(law, scene),
        }
    }

    /// A measure along an axis; points without a finite value are left out.
    pub(super) fn curve(&self, law: Law, measure: Measure, scene: &Scene, axis: Axis) -> Vec<P> {
        let (name, from, to, count) = axis;
        (0..count)
            .map(|i| {
                let value = from + (to - from) * i as f64 / (count - 1) as f64;
                let own = changed(scene.clone(), &[(name, value)]);
                (value, self.measure(law, measure, &own))
            })
            // Of a stopped bench nothing is kept, so nobody need expect a curve without points.
            .filter(|(_, measured)| measured.is_finite() || self.is_stopped())
            .collect()
    }

    /// A trend along an axis: the curve's ends by both laws, and whether the sound one has the property.
    pub(super) fn trend(
        &self,
        (measure, axis): (Measure, Axis),
        scene: &Scene,
        property: impl Fn(&[P]) -> bool,
        cause: &'static str,
    ) -> Found {
        let [sound, printed] = LAWS.map(|law| self.curve(law, measure, scene, axis));
        let holds = property(&sound);
        let told = |curve: &[P]| {
            format!("{}{}", ends(measure, axis.0, curve), also(property(curve), holds))
        };
        both(
            format!("{}{}", own_settings(scene, axis.0), ends(measure, axis.0, &sound)),
            told(&printed),
            trend_verdict(holds),
            cause,
        )
    }
}

/// How a scene differs from the one of chapter 9's figures, but for the variable of the axis: `d = 0.25 m: `.
fn own_settings(scene: &Scene, axis: &str) -> String {
    let base = base();
    let own: Vec<String> = VARIABLES
        .iter()
        .filter(|it| it.symbol != axis && it.value(scene) != it.value(&base))
        .map(|it| {
            let unit = if it.unit() == "-" { String::new() } else { format!(" {}", it.unit()) };
            format!("{} = {}{unit}", it.symbol, it.show(scene))
        })
        .collect();
    if own.is_empty() { String::new() } else { format!("{}: ", own.join(", ")) }
}

/// What the printed scheme does differently, in a word.
fn also(printed: bool, sound: bool) -> &'static str {
    match (printed, sound) {
        (true, false) => "; there it holds",
        (false, true) => "; there it fails",
        (true, true) | (false, false) => "",
    }
}

/// First and last value of a curve in words: `60.0 % at gamma = 0.8, 91.5 % at 7`.
pub(super) fn ends(measure: Measure, name: &str, curve: &[P]) -> String {
    let unit = match measure {
        Measure::Percent => "%",
        Measure::Travel => "mm",
    };
    let (Some(first), Some(last)) = (curve.first(), curve.last()) else {
        return "nothing finite".to_owned();
    };
    format!(
        "{} {unit} at {name} = {}, {} {unit} at {}",
        number(first.1),
        number(first.0),
        number(last.1),
        number(last.0)
    )
}

pub(super) fn trend_verdict(holds: bool) -> Verdict {
    if holds { Verdict::TrendHolds } else { Verdict::TrendFails }
}

/// A verdict for a number: as stated, or as stated after a correction; else the claim fails.
pub(super) fn number_verdict(as_stated: bool, corrected: bool) -> Verdict {
    if as_stated {
        Verdict::Reproduced
    } else if corrected {
        Verdict::Corrected
    } else {
        Verdict::TrendFails
    }
}

/// A misprint when the printed value does not do and the right one does.
pub(super) fn misprint_verdict(printed_does: bool, meant_does: bool) -> Verdict {
    match (printed_does, meant_does) {
        (true, _) => Verdict::Reproduced,
        (false, true) => Verdict::Misprint,
        (false, false) => Verdict::TrendFails,
    }
}

/// Within a relative distance.
pub(super) fn near(value: f64, stated: f64, relative: f64) -> bool {
    (value / stated - 1.0).abs() <= relative
}

/// The ballistic limit of a plate that is fixed, m/s.
pub(super) fn limit_m_s(scene: &Scene) -> f64 {
    let geometry = Geometry::of(scene);
    Passage::rigid(scene, &geometry).limit_velocity_m_s()
}

/// Four figures.
pub(super) fn number(value: f64) -> String {
    units::significant(value, 4)
}

/// Four figures with prefix and unit.
pub(super) fn unit(value: f64, unit: &'static str) -> String {
    Engineering { value, unit, digits: 4 }.to_string()
}

/// Millimetres with four decimals.
pub(super) fn mm(value_m: f64) -> String {
    if value_m.is_finite() { format!("{:.4} mm", 1e3 * value_m) } else { "perforated".to_owned() }
}

/// Percent with one decimal.
pub(super) fn pc(percent: f64) -> String {
    if percent.is_finite() { format!("{percent:.1} %") } else { "perforated".to_owned() }
}
