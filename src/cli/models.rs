//! `cmra run SCENE --compare models|quirks`: the interaction models, or the quirks of Appendix A, side by side.

use std::fmt::Write as _;
use std::time::Instant;

use clap::ValueEnum;

use crate::cli::CliError;
use crate::cli::text::{labelled, width};
use crate::files::preset::Preset;
use crate::report::models::table;
use crate::study::models::{Comparison, Row, What, compare};

/// What to compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Compare {
    /// The contact models of thesis section 8.2: Table 8.1 with numbers
    Models,
    /// Appendix A as printed, and with each of its errors corrected
    Quirks,
}

pub(super) fn compute(preset: &Preset, what: Compare) -> Result<Comparison, CliError> {
    let what = match what {
        Compare::Models => What::Models,
        Compare::Quirks => What::Quirks,
    };
    let start = Instant::now();
    Ok(compare(&preset.scene, what, &|| start.elapsed().as_secs_f64())?)
}

pub(super) fn page(name: &str, found: &Comparison) -> String {
    let (title, first) = match found.what {
        What::Models => ("the interaction models of Table 8.1", "hydrodynamic"),
        What::Quirks => ("Appendix A, quirk by quirk", "as printed"),
    };
    let mut page = format!("{name}: {title}\n\n");
    let mut table = table(name, found);
    table.rows.truncate(found.rows.len());
    page += &table.page(
        &[
            "model",
            "final_penetration_m",
            "penetration_deviation",
            "max_plate_displacement_m",
            "displacement_deviation",
            "peak_contact_force_n",
            "force_deviation",
            "run_time_s",
        ],
        width(),
    );
    let _ = writeln!(
        page,
        "\nagainst: deviation from {first}; -: does not exist; travel: greatest displacement of the plate\n\
         time: shortest of several, without series and error estimate"
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
