//! The interaction models on one and the same scene: Table 8.1 of the thesis with numbers in it.
//!
//! Each model's depth, travel and peak force beside the hydrodynamic model's, and its run time. The clock is passed in.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::run::{Outcome, Run};
use crate::model::scene::{ContactModel, Scene};
use crate::model::simulate::{self, Settings};
use crate::model::variables::{self, VariableError};
use crate::study::accuracy::timing::{Clock, Patience, time};

/// How long the computations of one scene may take of which the shortest time counts.
const PATIENCE: Patience = Patience { point_s: 0.2, slow_s: 0.1 };

/// One line of the comparison.
#[derive(Clone, Debug)]
pub struct Row {
    /// `half-sine`.
    pub name: &'static str,
    /// Its parameters, in words; empty if none had to be chosen.
    pub with: String,
    /// Its run.
    pub run: Arc<Run>,
    /// Shortest of several computations, without series and error estimate, s.
    pub took_s: f64,
    /// What Table 8.1 calls its strength, and its weakness, in other words.
    pub judged: (&'static str, &'static str),
}

/// The comparison; the first row is what the others are compared with.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The rows.
    pub rows: Vec<Row>,
    /// Models that cannot run this scene, and why.
    pub refused: Vec<(&'static str, String)>,
}

impl Comparison {
    /// How far a result is from that of the first row, relative; `None` where either does not exist.
    pub fn deviation(&self, row: &Row, of: impl Fn(&Run) -> Option<f64>) -> Option<f64> {
        let relative = of(&row.run)? / of(&self.rows.first()?.run)? - 1.0;
        relative.is_finite().then_some(relative)
    }
}

/// The depth of a shot that does not perforate, m.
pub fn depth_m(run: &Run) -> Option<f64> {
    run.final_penetration_m.filter(|_| run.outcome != Outcome::Perforated)
}

/// Compute a comparison; `clock` gives the time.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense, or none of the rows can run it.
pub fn compare(scene: &Scene, clock: Clock<'_>) -> Result<Comparison, VariableError> {
    variables::require_single(scene)?;
    let (mut rows, mut refused) = (Vec::new(), Vec::new());
    for model in in_order() {
        let (own, about) = (Arc::new(by_model(scene, model)), model.about());
        if let Err(reason) = variables::validate(&own) {
            // Without the first row there is nothing to compare with.
            if rows.is_empty() {
                return Err(reason);
            }
            refused.push((model.word(), reason.to_string()));
            continue;
        }
        let run = simulate(&own, Settings::default())?;
        let took_s = time(clock, PATIENCE, || simulate(&own, Settings::BARE)).min_s;
        rows.push(Row {
            name: model.word(),
            with: (about.parameters)(&own),
            run: Arc::new(run),
            took_s,
            judged: (about.strength, about.limit),
        });
    }
    Ok(Comparison { rows, refused })
}

fn simulate(scene: &Arc<Scene>, settings: Settings) -> Result<Run, VariableError> {
    simulate::simulate(scene, &settings, &mut |_| ControlFlow::Continue(()))
}

fn by_model(scene: &Scene, model: ContactModel) -> Scene {
    let mut own = scene.clone();
    own.contact.model = model;
    own
}

/// The models in the order of the table.
fn in_order() -> [ContactModel; ContactModel::ALL.len()] {
    let mut models = ContactModel::ALL;
    models.sort_by_key(|model| model.about().place);
    models
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A clock by which every computation takes too long to be repeated.
    fn slow() -> impl FnMut() -> f64 {
        let mut now_s = 0.0;
        move || {
            now_s += 1.0;
            now_s
        }
    }

    #[test]
    fn every_model_stands_beside_the_hydrodynamic_one() {
        let found = compare(&Scene::default(), &mut slow()).unwrap();
        let names: Vec<&str> = found.rows.iter().map(|row| row.name).collect();
        assert_eq!(names, ["hydrodynamic", "lumped", "half-sine", "initial-velocity", "appendix"]);
        let row = |name: &str| found.rows.iter().find(|row| row.name == name).unwrap();
        let depth_error = |name| found.deviation(row(name), depth_m);
        assert_eq!(depth_error("hydrodynamic"), Some(0.0));
        // The printed coupling: 82.4 instead of 64.4 % of the baseline.
        assert!((depth_error("appendix").unwrap() - 0.28).abs() < 0.01);
        assert_eq!(depth_error("initial-velocity"), None);
        let force_error = |name| found.deviation(row(name), |run| run.peak_contact_force_n);
        assert_eq!(force_error("initial-velocity"), None);
        // Joined at once, the plate does not move before it has its speed.
        let travel = |run: &Run| run.max_plate_displacement_m;
        assert!(found.deviation(row("initial-velocity"), travel).unwrap().abs() < 0.1);
        assert!(row("half-sine").with.starts_with("t_d = 1"));
    }
}
