//! A comparison of the interaction models.

use crate::model::run::{Outcome, Run};
use crate::model::units::engineering;
use crate::report::table::Table;
use crate::study::models::{Comparison, Row, depth_m};
use crate::study::quantities;

/// A model that was run, or one that does not apply.
#[derive(Clone, Copy)]
pub struct ModelLine<'r> {
    model: &'static str,
    row: Option<&'r Row>,
    /// Why it does not apply.
    refused: &'r str,
}

impl<'r> ModelLine<'r> {
    fn run(&self) -> Option<&'r Run> {
        self.row.map(|row| &*row.run)
    }
}

/// All of them.
pub fn table<'c>(name: &'c str, found: &'c Comparison) -> Table<'c, ModelLine<'c>> {
    let runs = found.rows.iter();
    let runs = runs.map(|row| ModelLine { model: row.name, row: Some(row), refused: "" });
    let refused = found.refused.iter();
    let refused = refused.map(|(model, why)| ModelLine { model, row: None, refused: why });
    Table::of(runs.chain(refused))
        .with("scene", "scene", "", move |_| name)
        .with("model", "model", "", |it| it.model)
        .with("outcome", "outcome", "", |it| {
            it.run().map_or("refused", |run| run.shot_outcome().word())
        })
        .with("final_penetration_m", "depth", "m", |it| it.run()?.final_penetration_m)
        .shown(|it, _| {
            let is_through = it.run()?.outcome == Outcome::Perforated;
            is_through.then(|| Outcome::Perforated.word().to_owned())
        })
        .with("first_arrest_penetration_m", "depth at first stop", "m", |it| {
            Some(it.run()?.first_arrest?.penetration_m)
        })
        .with("percent_of_baseline", "of baseline", "%", |it| it.run()?.percent_of_baseline())
        .with("max_plate_displacement_m", "travel", "m", |it| it.run()?.max_plate_displacement_m)
        .with("peak_contact_force_n", "peak", "N", |it| it.run()?.peak_contact_force_n)
        .with("penetration_deviation", "against", "", |it| found.deviation(it.row?, depth_m))
        .shown(|_, value| Some(percent(value.as_f64()?)))
        .with("displacement_deviation", "against", "", |it| {
            found.deviation(it.row?, |run| run.max_plate_displacement_m)
        })
        .shown(|_, value| Some(percent(value.as_f64()?)))
        .with("force_deviation", "against", "", |it| {
            found.deviation(it.row?, |run| run.peak_contact_force_n)
        })
        .shown(|_, value| Some(percent(value.as_f64()?)))
        .with("error_estimate", "error estimate", "", |it| {
            quantities::find("error_estimate")?.value(it.run()?)
        })
        .with("energy_residual", "energy residual", "", |it| Some(it.run()?.ledger.residual()))
        .with("run_time_s", "time", "", |it| it.row.map(|row| row.took_s))
        .shown(|_, value| Some(engineering(value.as_f64()?, "s", 3)))
        .with("steps", "steps", "", |it| it.run().map(|run| run.cost.steps))
        .with("with", "with", "", |it| it.row.map(|row| row.with.clone()))
        .with("strength", "strength", "", |it| it.row.map(|row| row.judged.0))
        .with("weakness", "weakness", "", |it| it.row.map_or(it.refused, |row| row.judged.1))
}

fn percent(value: f64) -> String {
    let places = usize::from(value.abs() < 1.0);
    format!("{:+.places$} %", 100.0 * value)
}
