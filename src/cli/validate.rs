//! `cmra validate`: measurements from outside the thesis beside what the model computes for them.

use std::fmt::Write as _;
use std::process::ExitCode;

use clap::Args;

use crate::cli::progress::Extent;
use crate::cli::study::Threads;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, progress, text};
use crate::files::validation;
use crate::model::scene::Closure;
use crate::model::units::{engineering, fixed_significant};
use crate::report::validation as tables;
use crate::study::validation::{MeasuredQuantity, NOT_COUNTED, Row, biases, measurements};

#[derive(Debug, Args)]
pub(super) struct ValidateArguments {
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    table: TableArguments,
}

/// Compute every case; exit status 1 when the model gives nothing for one.
pub(super) fn run(arguments: &ValidateArguments) -> Result<ExitCode, CliError> {
    arguments.table.check(false)?;
    let (report, extent) =
        progress::study(arguments.threads.count(), "measurements", validation::report);
    let report = report?;
    arguments.table.deliver(extent, None, &page(&report, extent), None, tables::table(&report))?;
    let missing = report.iter().filter(|row| row.computed.is_none());
    let missing = missing.map(|row| format!("nothing could be computed for {}", row.case.id));
    Ok(extent.exit_code_after(missing))
}

fn page(report: &[Row], extent: Extent) -> String {
    use Closure::{Cavity, DoubleYield};
    let mut page = String::new();
    for row in report {
        let case = row.case;
        let unit = case.quantity.unit();
        let show = |value: f64| match case.quantity {
            MeasuredQuantity::Ratio => fixed_significant(value, 4),
            _ => engineering(value, unit, 4),
        };
        let off = |value: f64| format!("{} ({:+.1} %)", show(value), 100.0 * row.error(value));
        let absent = || "nothing".to_owned();
        let scene = format!("{} {}", case.preset, case.set);
        let _ = writeln!(page, "{}  [{}]", case.id, scene.trim_end());
        let known = case.resolution.map_or_else(String::new, |it| format!(" +- {}", show(it)));
        let computed = row.computed.map_or_else(absent, off);
        let ratio = format!("h/D = {}", fixed_significant(row.thickness_ratio, 3));
        let (made_of, pressure) = (case.projectile, engineering(row.pressure_pa, "Pa", 4));
        let lines = [
            ("measured", format!("{} {}{known}", case.quantity.word(), show(case.measured))),
            ("computed", format!("{computed} by {}", closure_words(row.closure))),
            (
                "alternative",
                row.other.map_or_else(String::new, |value| {
                    let is_cavity = row.closure == Cavity;
                    let other = if is_cavity { DoubleYield } else { Cavity };
                    format!("{} by {}", off(value), closure_words(other))
                }),
            ),
            ("plate", row.beyond.clone().unwrap_or(ratio)),
            ("nose", case.nose.to_owned()),
            ("projectile", format!("{made_of}; invalid if the projectile yields below {pressure}")),
            ("caution", case.caution.to_owned()),
            ("source", case.source.to_owned()),
        ];
        text::labelled_each(&mut page, &lines);
        page.push('\n');
    }
    for it in &measurements().not_checked {
        let _ = writeln!(page, "{}  [cannot be checked]", it.id);
        let lines = [("says", it.says), ("why not", it.why), ("source", it.source)];
        text::labelled_each(&mut page, &lines);
        page.push('\n');
    }
    page + &extent.missing().map_or_else(|| summary(report), |missing| missing + "\n")
}

/// Points from which a class has a scatter.
const SCATTER_FROM: usize = 3;

/// Bias and scatter by class, and what was done.
fn summary(report: &[Row]) -> String {
    let mut table = format!(
        "{:<36}{:>7}{:>8}{:>8}  {}\n",
        "computed over measured, minus 1", "points", "bias", "scatter", "least to greatest"
    );
    let percent = |value: f64| format!("{:+.1} %", 100.0 * value);
    for it in biases(report) {
        let scatter = it
            .deviation
            .filter(|_| it.points >= SCATTER_FROM)
            .map_or_else(String::new, |value| format!("{:.1} %", 100.0 * value));
        let range = format!("{} to {}", percent(it.range.0), percent(it.range.1));
        let _ = writeln!(
            table,
            "{:<36}{:>7}{:>8}{scatter:>8}  {}",
            it.class.unwrap_or("all points"),
            it.points,
            percent(it.mean),
            if it.points > 1 { range.as_str() } else { "" }
        );
    }
    let computed = report.iter().filter(|row| row.computed.is_some()).count();
    let aside = report.iter().filter(|row| row.case.class == NOT_COUNTED).count();
    let said = format!(
        "{} measurements: {computed} computed, {} not; {aside} of them not counted above (another input for a counted \
         measurement, or a quantity outside the model). {} further ones cannot be checked. Positive is unconservative: \
         the real plate holds less than computed. Nothing is fitted. The two closures are never combined: cavity with dishing is \
         refused.",
        report.len(),
        report.len() - computed,
        measurements().not_checked.len(),
    );
    table + "\n" + &text::hanging("", &said, 0)
}

fn closure_words(closure: Closure) -> &'static str {
    match closure {
        Closure::Given => "a flow strength that is given",
        Closure::Cavity | Closure::ByThickness => "cavity, without dishing",
        Closure::Cylindrical => "cylindrical, without dishing",
        Closure::DoubleYield => "double-yield, with dishing",
    }
}
