//! `cmra run SCENE --compare models|quirks`: the interaction models, or the quirks of Appendix A, side by side.

use std::fmt::Write as _;
use std::time::Instant;

use clap::ValueEnum;
use serde_json::Value;

use crate::cli::CliError;
use crate::cli::text::labelled;
use crate::files::preset::Preset;
use crate::files::rows::{Rows, number};
use crate::model::results;
use crate::model::run::Outcome;
use crate::model::units::{Engineering, fixed_significant};
use crate::study::models::{Comparison, Row, What, compare};

/// What to compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Compare {
    /// The contact models of thesis section 8.2: Table 8.1 with numbers
    Models,
    /// Appendix A as printed, and with each of its errors corrected
    Quirks,
}

const COLUMNS: [&str; 18] = [
    "scene",
    "model",
    "outcome",
    "final_penetration_m",
    "first_arrest_penetration_m",
    "percent_of_baseline",
    "max_plate_displacement_m",
    "peak_contact_force_n",
    "penetration_deviation",
    "displacement_deviation",
    "force_deviation",
    "error_estimate",
    "energy_residual",
    "run_time_s",
    "steps",
    "with",
    "strength",
    "weakness",
];

/// The comparison as a page and as rows.
pub(super) fn compute(preset: &Preset, what: Compare) -> Result<(String, Rows), CliError> {
    let what = match what {
        Compare::Models => What::Models,
        Compare::Quirks => What::Quirks,
    };
    let start = Instant::now();
    let found = compare(&preset.scene, what, &|| start.elapsed().as_secs_f64())?;
    Ok((page(&preset.name, &found), rows(&preset.name, &found)))
}

fn rows(name: &str, found: &Comparison) -> Rows {
    let row = |row: &Row| {
        let run = &row.run;
        vec![
            Value::from(name),
            Value::from(row.name),
            Value::from(run.outcome.word()),
            number(run.final_penetration_m),
            number(run.first_arrest.map(|arrest| arrest.penetration_m)),
            number(run.percent_of_baseline()),
            number(run.max_plate_displacement_m),
            number(run.peak_contact_force_n),
            number(found.depth_error(row)),
            number(found.travel_error(row)),
            number(found.force_error(row)),
            number(results::find("error_estimate").and_then(|column| column.value(run))),
            number(Some(run.ledger.residual())),
            number(Some(row.took_s)),
            Value::from(run.cost.steps),
            Value::from(row.with.as_str()),
            Value::from(row.judged.0),
            Value::from(row.judged.1),
        ]
    };
    let refused = |(model, reason): &(&str, String)| {
        let mut row = vec![Value::Null; COLUMNS.len()];
        (row[0], row[1]) = (Value::from(name), Value::from(*model));
        (row[2], row[17]) = (Value::from("refused"), Value::from(reason.as_str()));
        row
    };
    let rows = found.rows.iter().map(row).chain(found.refused.iter().map(refused)).collect();
    Rows { columns: COLUMNS.to_vec(), rows }
}

fn page(name: &str, found: &Comparison) -> String {
    let (title, first) = match found.what {
        What::Models => ("the interaction models of Table 8.1", "hydrodynamic"),
        What::Quirks => ("Appendix A, quirk by quirk", "as printed"),
    };
    let mut page = format!("{name}: {title}\n\n");
    let _ = writeln!(
        page,
        "{:<18}{:>10}{:>9}  {:>10}{:>9}  {:>9}{:>9}  {:>8}",
        "model", "depth mm", "against", "travel mm", "against", "peak kN", "against", "run time"
    );
    for row in &found.rows {
        line(&mut page, found, row);
    }
    let _ = writeln!(
        page,
        "\nagainst: deviation from {first}; -: does not exist; travel: greatest displacement of the plate\n\
         run time: shortest of several, without series and error estimate"
    );
    for (name, reason) in &found.refused {
        labelled(&mut page, "refused", &format!("{name}: {reason}"));
    }
    let told: Vec<&Row> = found.rows.iter().filter(|row| !row.with.is_empty()).collect();
    if found.what == What::Models {
        for row in told {
            let _ = writeln!(page, "{}: {}", row.name, row.with);
        }
        page.push('\n');
        for row in &found.rows {
            let _ = writeln!(page, "{:<18}{}; {}", row.name, row.judged.0, row.judged.1);
        }
        page.push_str("finite elements    not included: the fifth model of Table 8.1 needs a finite element solver\n");
    }
    page
}

fn line(page: &mut String, found: &Comparison, row: &Row) {
    let run = &row.run;
    let scaled = |value: Option<f64>, scale: f64| {
        value.map_or_else(|| "-".to_owned(), |value| fixed_significant(value * scale, 4))
    };
    let percent = |value: Option<f64>| {
        value.map_or_else(
            || "-".to_owned(),
            |value| {
                let places = usize::from(value.abs() < 1.0);
                format!("{:+.places$} %", 100.0 * value)
            },
        )
    };
    let depth = match run.outcome {
        Outcome::Perforated => "perforated".to_owned(),
        Outcome::Arrested | Outcome::Separated | Outcome::Moving => {
            scaled(run.final_penetration_m, 1e3)
        }
    };
    let took = Engineering { value: row.took_s, unit: "s", digits: 3 }.to_string();
    let _ = writeln!(
        page,
        "{:<18}{depth:>10}{:>9}  {:>10}{:>9}  {:>9}{:>9}  {took:>8}",
        row.name,
        percent(found.depth_error(row)),
        scaled(run.max_plate_displacement_m, 1e3),
        percent(found.travel_error(row)),
        scaled(run.peak_contact_force_n, 1e-3),
        percent(found.force_error(row)),
    );
}
