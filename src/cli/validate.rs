//! `cmra validate [FILE.csv]`: measurements, built-in or the user's own, with the computed results.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use serde_json::Value;

use crate::cli::charts::ChartArguments;
use crate::cli::progress::Extent;
use crate::cli::study::Threads;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, progress, text};
use crate::files::validation;
use cmra_engine::model::scene::Closure;
use cmra_engine::model::units::{engineering, fixed_significant};
use cmra_studies::report::measured as limits;
use cmra_studies::report::svg::Picture;
use cmra_studies::report::validation as tables;
use cmra_studies::study::context::Context;
use cmra_studies::study::measured;
use cmra_studies::study::validation::{MeasuredQuantity, NOT_COUNTED, Row, biases, measurements};

#[derive(Debug, Args)]
#[command(
    after_help = "FILE.csv has a row for each shot. Columns are variables as `--set` takes them, the unit in the heading: `R [mm]`, `m_p [g]`, \
    `theta [deg]`; `threat` and `material` name entries of the libraries. Measured are any of limit_m_s, deviation_m_s, depth_m, \
    residual_velocity_m_s, and of a plate that moves first_arrest_plate_velocity_m_s, plate_velocity_after_m_s, separation_velocity_m_s, \
    max_plate_displacement_m, max_plate_displacement_time_s and peak_mount_force_n; source and note are free text. A blank cell is not given. The mount is rigid and the closure cylindrical unless the row \
    says otherwise.\n\
    Such a file begins, for example:\n  \
    nose,core,R [mm],m_p [g],h [mm],rho [kg/m3],E [GPa],Y [MPa],UTS [MPa],theta [deg],mount,closure,C_d,limit_m_s,source\n\
    Exit status 1 when a row cannot be computed."
)]
pub(super) struct ValidateArguments {
    /// Your own measurements [default: the built-in ones, by class]
    #[arg(value_name = "FILE.csv")]
    file: Option<PathBuf>,
    /// List all rows of the built-in measurements
    #[arg(long)]
    rows: bool,
    #[command(flatten)]
    pictures: ChartArguments,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    table: TableArguments,
}

/// Computes every row; exit status 1 if a row cannot be computed.
pub(super) fn run(arguments: &ValidateArguments) -> Result<ExitCode, CliError> {
    let ValidateArguments { table, pictures, threads, .. } = arguments;
    table.check(false)?;
    pictures.check(table)?;
    let Some(file) = &arguments.file else { return built_in(arguments) };
    let measurements = validation::read_measurements(file)?;
    let (rows, extent) = progress::study(threads.count(), "rows", |context: &mut Context<'_>| {
        measured::evaluate(&measurements, context)
    });
    let keys = limits::page_keys(&rows);
    let mut page = limits::rows(&rows).page(&keys, text::width());
    page += &refused(&rows);
    page.push('\n');
    page += &error_page(&rows);
    deliver(arguments, extent, &page, limits::json(&rows), &rows)?;
    Ok(extent.exit_code_after(limits::refusals(&rows)))
}

/// Compares the built-in measurements.
fn built_in(arguments: &ValidateArguments) -> Result<ExitCode, CliError> {
    let (report, extent) =
        progress::study(arguments.threads.count(), "measurements", validation::report);
    let report = report?;
    let rows = measured::left_out();
    let mut page =
        "Measured ballistic limits beside those expected from all other papers, by class\n\n"
            .to_owned();
    page += &error_page(rows);
    if arguments.rows {
        page.push('\n');
        page += &limits::rows(rows).page(&limits::page_keys(rows), text::width());
        page.push('\n');
    }
    page.push('\n');
    page += &cases(&report, extent, arguments.rows);
    let mut object = limits::json(rows);
    object["cases"] = tables::table(&report).objects(|_| true);
    deliver(arguments, extent, &page, object, rows)?;
    let missing = report.iter().filter(|row| row.computed.is_none());
    let missing = missing.map(|row| format!("nothing could be computed for {}", row.case.id));
    Ok(extent.exit_code_after(missing))
}

fn deliver(
    arguments: &ValidateArguments,
    extent: Extent,
    page: &str,
    object: Value,
    rows: &[measured::Row],
) -> Result<(), CliError> {
    let ValidateArguments { table, pictures, .. } = arguments;
    let picture = || limits::picture(rows).map(Picture::Chart).into_iter().collect();
    if pictures.is_stdout() {
        return pictures.write(table, extent.reach, picture);
    }
    table.deliver(extent, None, page, Some(object), limits::rows(rows))?;
    pictures.write(table, extent.reach, picture)
}

/// Returns the errors by class and over all rows.
fn error_page(rows: &[measured::Row]) -> String {
    let errors = measured::errors(rows);
    if errors.is_empty() {
        return String::new();
    }
    limits::error_lines(&errors) + &text::hanging("", limits::ERRORS_MEAN, 0)
}

fn refused(rows: &[measured::Row]) -> String {
    let lines = limits::refusals(rows).into_iter();
    lines.map(|line| text::hanging("refused: ", &line, 9)).collect()
}

/// Returns the measurements of other quantities: bias by class, and each case if `has_rows`.
fn cases(report: &[Row], extent: Extent, has_rows: bool) -> String {
    let mut page = String::new();
    if has_rows {
        each_case(&mut page, report);
    }
    page + &extent.missing().map_or_else(|| summary(report), |missing| missing + "\n")
}

fn each_case(page: &mut String, report: &[Row]) {
    use Closure::{Cavity, DoubleYield};
    for row in report {
        let case = row.case;
        let unit = case.quantity.unit();
        let show = |value: f64| match case.quantity {
            MeasuredQuantity::Bottoms => (if value > 0.5 { "yes" } else { "no" }).to_owned(),
            MeasuredQuantity::Ratio => fixed_significant(value, 4),
            _ => engineering(value, unit, 4),
        };
        let off = |value: f64| match case.quantity {
            MeasuredQuantity::Bottoms => show(value),
            _ => format!("{} ({:+.1} %)", show(value), 100.0 * row.error(value)),
        };
        let absent = || "nothing".to_owned();
        let scene = format!("{} {}", case.preset, case.set);
        let _ = writeln!(page, "{}  [{}]", case.id, scene.trim_end());
        let known = case.resolution.map_or_else(String::new, |it| format!(" +- {}", show(it)));
        let computed = row.computed.map_or_else(absent, off);
        let ratio = format!("h/D = {}", fixed_significant(row.thickness_ratio, 3));
        let (made_of, pressure) = (case.projectile, engineering(row.pressure_pa, "Pa", 4));
        let lines = [
            ("measured", format!("{} {}{known}", case.quantity.label(), show(case.measured))),
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
        text::labelled_each(page, &lines);
        page.push('\n');
    }
    for it in &measurements().not_checked {
        let _ = writeln!(page, "{}  [cannot be checked]", it.id);
        let lines = [("says", it.says), ("why not", it.why), ("source", it.source)];
        text::labelled_each(page, &lines);
        page.push('\n');
    }
}

/// Minimum number of points of a class with a standard deviation.
const SCATTER_FROM: usize = 3;

/// Returns bias and scatter by class, and a summary line.
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
