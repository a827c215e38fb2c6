//! `cmra validate`: measurements from outside the thesis beside what the model computes for them.

use std::fmt::Write as _;
use std::process::ExitCode;

use clap::Args;

use crate::cli::reproduce::wrapped;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, output};
use crate::files::validation;
use crate::model::units::{Engineering, fixed_significant};
use crate::study::validation::{NOT_CHECKED, Quantity, Row};

#[derive(Debug, Args)]
pub(super) struct ValidateArguments {
    #[command(flatten)]
    table: TableArguments,
}

/// Compute every case; exit status 1 when the model gives nothing for one.
pub(super) fn run(arguments: &ValidateArguments) -> Result<ExitCode, CliError> {
    arguments.table.check()?;
    let report = validation::report()?;
    arguments.table.deliver(&page(&report), &validation::rows(&report))?;
    let missing: Vec<&str> =
        report.iter().filter(|row| row.computed.is_none()).map(|row| row.case.id).collect();
    for id in &missing {
        output::note(&format!("nothing could be computed for {id}"));
    }
    Ok(if missing.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn page(report: &[Row]) -> String {
    let mut page = String::new();
    for row in report {
        let case = row.case;
        let unit = case.quantity.unit();
        let show = |value: f64| match case.quantity {
            Quantity::Ratio => fixed_significant(value, 4),
            Quantity::Limit | Quantity::Depth | Quantity::Strength | Quantity::Bulge => {
                Engineering { value, unit, digits: 4 }.to_string()
            }
        };
        let off = |value: f64| format!("{} ({:+.1} %)", show(value), 100.0 * row.error(value));
        let absent = || "nothing".to_owned();
        let mut set = String::new();
        for (name, value) in case.set {
            let _ = write!(set, " {name}={value}");
        }
        let _ = writeln!(page, "{}  [{}{set}]", case.id, case.preset);
        let known = case.resolution.map_or_else(String::new, |it| format!(" +- {}", show(it)));
        let lines = [
            ("measured", format!("{} {}{known}", case.quantity.word(), show(case.measured))),
            (
                "computed",
                format!("{} by {}", row.computed.map_or_else(absent, off), closure_words(row)),
            ),
            (
                "otherwise",
                row.other.map_or_else(String::new, |value| {
                    let word = if row.closure == "cavity" {
                        "double-yield, with dishing"
                    } else {
                        "cavity, without dishing"
                    };
                    format!("{} by {word}", off(value))
                }),
            ),
            (
                "plate",
                row.beyond.clone().unwrap_or_else(|| {
                    format!("h/D = {}", fixed_significant(row.thickness_ratio, 3))
                }),
            ),
            ("nose", case.nose.to_owned()),
            (
                "projectile",
                format!(
                    "{}; must not be used where it yields below {}",
                    case.projectile,
                    Engineering { value: row.pressure_pa, unit: "Pa", digits: 4 }
                ),
            ),
            ("caution", case.caution.to_owned()),
            ("source", case.source.to_owned()),
        ];
        for (label, text) in lines.iter().filter(|(_, text)| !text.is_empty()) {
            wrapped(&mut page, label, text);
        }
        page.push('\n');
    }
    for it in &NOT_CHECKED {
        let _ = writeln!(page, "{}  [cannot be checked]", it.id);
        for (label, text) in [("says", it.says), ("why not", it.why), ("source", it.source)] {
            wrapped(&mut page, label, text);
        }
        page.push('\n');
    }
    page.push_str(
        "Nothing is fitted. The two closures are never combined: cavity with dishing is refused.\n",
    );
    page
}

fn closure_words(row: &Row) -> &'static str {
    match row.closure {
        "given" => "a flow strength that is given",
        "cavity" => "cavity, without dishing",
        _ => "double-yield, with dishing",
    }
}
