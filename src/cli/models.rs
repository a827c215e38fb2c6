//! `cmra run SCENE --compare models|quirks`: the interaction models, or the quirks of Appendix A, next to each other.

use std::fmt::Write as _;
use std::time::Instant;

use crate::cli::CliError;
use crate::cli::text::{labelled, width};
use crate::files::preset::Preset;
use crate::report::models::table;
use crate::study::models::{Comparison, Row, What, compare};

pub(super) fn compute(preset: &Preset, what: What) -> Result<Comparison, CliError> {
    let start = Instant::now();
    Ok(compare(&preset.scene, what, &mut || start.elapsed().as_secs_f64())?)
}

pub(super) fn page(name: &str, found: &Comparison) -> String {
    let (title, first) = (found.what.title(), found.what.first());
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
    let with_values: Vec<&Row> = found.rows.iter().filter(|row| !row.with.is_empty()).collect();
    if found.what == What::Models {
        for row in with_values {
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
