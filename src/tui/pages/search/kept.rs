//! The setup of the tab as a session keeps it: by what it means, whatever its rows are called.

use serde::{Deserialize, Serialize};

use crate::model::scene::SweepAxis;
use crate::study::quantities;
use crate::study::search::front::{SAMPLES, USUAL};
use crate::study::search::seek::{Goal, SCAN, SCAN_USUAL};
use crate::study::sweep::{Axis, COUNTS};
use crate::tui::pages::search::setup::{Bound, Setup};

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct KeptSetup {
    /// Goal seek: its variable, and its goal.
    seek: String,
    goal: String,
    /// The variables of fronts and sensitivity, and whether each is varied; none where nobody changed them.
    bounds: Vec<(String, bool)>,
    minimise: Vec<String>,
    stroke_m: Option<f64>,
    subject_to: Vec<String>,
    feasible: bool,
    designs: usize,
    /// The objectives drawn across and up.
    axes: (usize, usize),
    output: String,
    percent: f64,
    samples: usize,
}

impl Default for KeptSetup {
    fn default() -> Self {
        Self::of(&Setup::default())
    }
}

impl KeptSetup {
    pub(crate) fn of(setup: &Setup) -> Self {
        let (name, target) = setup.goal;
        let goal = quantities::find(name).map(|measure| Goal { measure, target });
        let chosen = USUAL.iter().zip(setup.objectives).filter(|(_, is_chosen)| *is_chosen);
        Self {
            seek: Axis::of(&setup.seek, &SCAN).map_or_else(|_| String::new(), |it| it.to_string()),
            goal: goal.map_or_else(String::new, |goal| goal.to_string()),
            bounds: setup.bounds.iter().map(|it| (it.axis.to_string(), it.on)).collect(),
            minimise: chosen.map(|(name, _)| (*name).to_owned()).collect(),
            stroke_m: setup.stroke_m,
            subject_to: setup.subject_to.iter().map(ToString::to_string).collect(),
            feasible: setup.feasible,
            designs: setup.designs,
            axes: setup.axes,
            output: setup.output.to_owned(),
            percent: setup.percent,
            samples: setup.samples,
        }
    }

    /// The setup, as far as what was kept of it still means something.
    pub(crate) fn setup(&self) -> Setup {
        let usual = Setup::default();
        let bound = |(text, on): &(String, bool)| {
            let axis = Axis::read_range(text, Some(*COUNTS.start()), &COUNTS).ok()?;
            Some(Bound { axis, on: *on })
        };
        let seek = Axis::read_range(&self.seek, Some(SCAN_USUAL), &SCAN);
        let goal = self.goal.parse::<Goal>().map(|goal| (goal.measure.name, goal.target));
        Setup {
            seek: seek.map_or(usual.seek, |axis: Axis| -> SweepAxis { axis.to_sweep_axis() }),
            goal: goal.unwrap_or(usual.goal),
            bounds: self.bounds.iter().filter_map(bound).collect(),
            objectives: USUAL.map(|name| self.minimise.iter().any(|it| it == name)),
            stroke_m: self.stroke_m.filter(|stroke_m| *stroke_m > 0.0),
            subject_to: self.subject_to.iter().filter_map(|text| text.parse().ok()).collect(),
            feasible: self.feasible,
            designs: self.designs.clamp(*SAMPLES.start(), *SAMPLES.end()),
            axes: self.axes,
            output: quantities::find(&self.output).map_or(usual.output, |it| it.name),
            percent: self.percent.clamp(1e-3, 100.0),
            samples: self.samples.clamp(2, 1_000_000),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::sweep::Spacing;

    #[test]
    fn a_setup_is_kept_and_what_means_nothing_any_more_is_as_usual() {
        let axis = |name, ends| Axis::new(name, ends, 2, Spacing::Linear).unwrap();
        let setup = Setup {
            seek: SweepAxis::linear("k", 1e3, 1e6, 33),
            goal: ("stroke_m", 0.045),
            bounds: vec![
                Bound { axis: axis("gamma", (1.0, 5.0)), on: true },
                Bound { axis: axis("theta", (0.0, 30.0)), on: false },
            ],
            objectives: [true, false, false, true],
            stroke_m: None,
            subject_to: vec!["peak_mount_force_n<=20kN".parse().unwrap()],
            feasible: false,
            axes: (1, 0),
            ..Setup::default()
        };
        let text = serde_json::to_string(&KeptSetup::of(&setup)).unwrap();
        let kept: KeptSetup = serde_json::from_str(&text).unwrap();
        assert_eq!(kept.setup(), setup);
        let odd = r#"{ "seek": "kk=1..2", "goal": "depth", "output": "?", "bounds": [["gamma=1..5", true], ["x", true]], "percent": 0 }"#;
        let kept = serde_json::from_str::<KeptSetup>(odd).unwrap().setup();
        let usual = Setup::default();
        assert_eq!((kept.seek, kept.goal, kept.output), (usual.seek, usual.goal, usual.output));
        assert!(kept.bounds.len() == 1 && kept.percent > 0.0);
    }
}
