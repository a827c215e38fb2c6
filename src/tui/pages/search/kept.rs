//! The setup of the tab as a session keeps it: by what it means, whatever its rows are called.

use crate::files::session::Search;
use crate::model::scene::SweepAxis;
use crate::study::quantities;
use crate::study::search::front::{SAMPLES, USUAL};
use crate::study::search::seek::{Goal, SCAN, SCAN_USUAL};
use crate::study::sweep::{Axis, COUNTS};
use crate::tui::pages::search::state::{Bound, Setup};

impl Setup {
    pub(crate) fn kept(&self) -> Search {
        let (name, target) = self.goal;
        let goal = quantities::find(name).map(|measure| Goal { measure, target });
        let chosen = USUAL.iter().zip(self.objectives).filter(|(_, is_chosen)| *is_chosen);
        Search {
            seek: Axis::of(&self.seek, &SCAN).map_or_else(|_| String::new(), |it| it.to_string()),
            goal: goal.map_or_else(String::new, |goal| goal.to_string()),
            bounds: self.bounds.iter().map(|it| (it.axis.to_string(), it.on)).collect(),
            minimise: Some(chosen.map(|(name, _)| (*name).to_owned()).collect()),
            subject_to: Some(self.subject_to.iter().map(ToString::to_string).collect()),
            feasible: Some(self.feasible),
            designs: Some(self.designs),
            output: self.output.to_owned(),
            percent: Some(self.percent),
            samples: Some(self.samples),
        }
    }

    /// The setup that was kept, as far as that still means something.
    pub(crate) fn of(kept: &Search) -> Self {
        let usual = Self::default();
        let bound = |(text, on): &(String, bool)| {
            let axis = Axis::read_range(text, Some(*COUNTS.start()), &COUNTS).ok()?;
            Some(Bound { axis, on: *on })
        };
        let seek = Axis::read_range(&kept.seek, Some(SCAN_USUAL), &SCAN);
        let goal = kept.goal.parse::<Goal>().map(|goal| (goal.measure.name, goal.target));
        let minimise =
            kept.minimise.as_ref().map(|it| USUAL.map(|name| it.iter().any(|one| one == name)));
        let bounds = kept.subject_to.as_ref();
        let bounds = bounds.map(|it| it.iter().filter_map(|text| text.parse().ok()).collect());
        Self {
            seek: seek.map_or(usual.seek, |axis: Axis| -> SweepAxis { axis.to_sweep_axis() }),
            goal: goal.unwrap_or(usual.goal),
            bounds: kept.bounds.iter().filter_map(bound).collect(),
            objectives: minimise.unwrap_or(usual.objectives),
            subject_to: bounds.unwrap_or(usual.subject_to),
            feasible: kept.feasible.unwrap_or(usual.feasible),
            designs: kept.designs.unwrap_or(usual.designs).clamp(*SAMPLES.start(), *SAMPLES.end()),
            output: quantities::find(&kept.output).map_or(usual.output, |it| it.name),
            percent: kept.percent.unwrap_or(usual.percent).clamp(1e-3, 100.0),
            samples: kept.samples.unwrap_or(usual.samples).clamp(2, 1_000_000),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_means_nothing_any_more_is_as_usual() {
        let odd = Search {
            seek: "kk=1..2".to_owned(),
            goal: "depth".to_owned(),
            output: "?".to_owned(),
            bounds: vec![("gamma=1..5".to_owned(), true), ("x".to_owned(), true)],
            percent: Some(0.0),
            ..Search::default()
        };
        let kept = Setup::of(&odd);
        let usual = Setup::default();
        assert_eq!((kept.seek, kept.goal, kept.output), (usual.seek, usual.goal, usual.output));
        assert!(kept.bounds.len() == 1 && kept.percent > 0.0);
    }
}
