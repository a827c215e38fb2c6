//! `cmra fit SHOTS`: V50 from a person's own shots, and the strength that gives it.

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use clap::Args;

use crate::cli::scene::SceneArguments;
use crate::cli::table::TableArguments;
use crate::cli::text::{labelled_each, width};
use crate::cli::{CliError, output, progress};
use crate::files::{clean, shots};
use crate::model::units::{engineering, fixed_significant, velocity};
use crate::numerics::statistics::sorted_by;
use crate::report::fit as tables;
use crate::report::fit::table;
use crate::study::fit::calibrate::{Calibration, calibrate};
use crate::study::fit::{Estimator, MeasuredShot, Report, fit};

#[derive(Debug, Args)]
#[command(
    after_help = "SHOTS is a CSV file whose first line names its columns: velocity_m_s, perforated (1 through, 0 stopped), and where \
    measured residual_m_s and penetration_m (of stopped shots). Other columns are ignored.\n\
    With a SCENE or --set the strength (S_y, or Y where a closure makes it) that gives the scene this V50 is found."
)]
pub(super) struct FitArguments {
    /// The CSV file of shots
    #[arg(value_name = "SHOTS")]
    shots: OsString,
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    table: TableArguments,
}

/// Runs the fit; exit status 1 if no strength gives the limit, or after an interrupt.
pub(super) fn run(arguments: &FitArguments) -> Result<ExitCode, CliError> {
    let is_calibrated = arguments.scene.is_given();
    if is_calibrated {
        arguments.table.check_beside()?;
    } else {
        arguments.table.check()?;
    }
    let path = Path::new(&arguments.shots);
    let table = shots::read(path)?;
    if !table.ignored.is_empty() {
        output::note(&format!("columns not used: {}", table.ignored.join(", ")));
    }
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    let report = fit(table.shots).map_err(|error| CliError::Option(format!("{name}: {error}")))?;
    let mut found = None;
    if is_calibrated {
        let preset = arguments.scene.load()?;
        for note in too_deep(&report.shots, preset.scene.target.thickness_m) {
            output::note(&note);
        }
        let calibration = progress::study(1, "shots to calibrate the strength", |context| {
            calibrate(&preset.scene, &report.logistic, &report.shots, context)
        })?;
        found = Some((preset, calibration));
    }
    let calibration = found.as_ref().map(|(_, calibration)| calibration);
    let named = found.as_ref().map(|(preset, calibration)| (preset.name.as_str(), calibration));
    let (page, object) = (page(&name, &report, named), tables::json(&report, calibration));
    let table = match &found {
        Some((preset, _)) => arguments.table.of(&arguments.scene, &preset.scene),
        None => arguments.table.alone(),
    };
    table.deliver_report(&page, object, tables::table(&report))?;
    Ok(progress::exit_code(calibration.is_none_or(|it| it.from_limit_pa.is_some())))
}

/// A warning for each shot that was stopped deeper than the plate is thick.
fn too_deep(shots: &[MeasuredShot], thickness_m: f64) -> Vec<String> {
    let stopped = shots.iter().filter(|shot| !shot.perforated);
    let deep = stopped.filter_map(|shot| Some((shot.velocity_m_s, shot.penetration_m?)));
    deep.filter(|(_, depth_m)| *depth_m > thickness_m)
        .map(|(velocity_m_s, depth_m)| {
            format!(
                "warning: shot of {velocity_m_s} m/s: penetration_m = {depth_m} m is more than the plate's thickness of {thickness_m} m; \
                 write it in metres (its depth is not used)"
            )
        })
        .collect()
}

/// The page; a calibration with the name of its scene.
fn page(file: &str, report: &Report, calibration: Option<(&str, &Calibration)>) -> String {
    let mut page = format!("{}: ballistic limit from shots\n\n", clean::line(file));
    let (all, through) = (report.shots.len(), report.perforated());
    let (stopped, fit) = (all - through, &report.logistic);
    let (v50, ends) = (velocity(fit.v50_m_s, 5), range(fit.range_m_s, |it| velocity(it, 5)));
    let [low, high] = [0.1, 0.9].map(|fraction| velocity(fit.quantile_m_s(fraction), 5));
    let method = fit.method.words();
    let lines = [
        ("shots", format!("{all}: {stopped} stopped, {through} perforated")),
        ("results", results(report)),
        ("V50", format!("{v50}, 95 % confidence {ends}")),
        ("curve", format!("10 % perforate at {low}, 90 % at {high} (logistic, {method})")),
        ("residual", residual(report)),
    ];
    labelled_each(&mut page, &lines);
    if let Some((scene, calibration)) = calibration {
        page.push('\n');
        calibrated(&mut page, scene, calibration);
    }
    let mut table = table(report);
    table.rows = sorted_by(table.rows, |shot| shot.velocity_m_s);
    page.push('\n');
    let keys = ["velocity_m_s", "perforated", "perforation_probability", "residual_m_s"];
    page += &table.page(&keys, width());
    page
}

fn results(report: &Report) -> String {
    let (stopped, through) =
        (velocity(report.highest_stopped_m_s, 5), velocity(report.lowest_perforated_m_s, 5));
    if report.has_mixed_results() {
        return format!("mixed from {through} (slowest perforation) to {stopped} (fastest stop)");
    }
    let penalty = if report.logistic.method == Estimator::Firth {
        "; plain likelihood has no maximum then, so Firth's penalty is used, and the width of the curve is hardly known"
    } else {
        ""
    };
    format!(
        "not mixed: stopped up to {stopped}, perforated from {through} on, V50 lies between{penalty}"
    )
}

fn residual(report: &Report) -> String {
    let count = report.residuals().len();
    report.lambert_jonas.map_or_else(
        || {
            format!(
                "{count} residual velocities of perforating shots: Lambert and Jonas's law takes four or more"
            )
        },
        |law| {
            let [a, p] = [law.a, law.p].map(|it| fixed_significant(it, 4));
            let [limit, error] = [law.limit_m_s, law.misfit_m_s].map(|it| velocity(it, 5));
            format!(
                "v_r = a (v^p - v_l^p)^(1/p): a = {a}, p = {p}, v_l = {limit}; RMS error {error} over {count} shots"
            )
        },
    )
}

fn calibrated(page: &mut String, scene: &str, found: &Calibration) {
    let own = found.own_limit_m_s.map_or_else(
        || "has no limit".to_owned(),
        |v| format!("has a limit of {}", velocity(v, 5)),
    );
    let (scene, own_strength) = (clean::line(scene), strength(found.own_pa));
    let (symbol, ends) = (found.symbol, range(found.range_pa, strength));
    let fitted = found.from_limit_pa.map_or_else(
        || format!("no {symbol} gives the scene this V50"),
        |value| {
            let shown = strength(value);
            format!(
                "{symbol} = {shown} gives it this V50; confidence {ends}; try --set {symbol}={value:.0}"
            )
        },
    );
    let from_depths = found.from_depths.map_or_else(String::new, |depths| {
        let scatter = depths
            .deviation_pa
            .map_or_else(String::new, |it| format!(", standard deviation {}", strength(it)));
        let left_out = match depths.left_out {
            0 => String::new(),
            count => format!("; no strength gives the depth of {count} more"),
        };
        let (mean, shots) = (strength(depths.mean_pa), depths.shots);
        format!("{symbol} = {mean}{scatter}, mean over {shots} stopped shots{left_out}")
    });
    let lines = [
        ("scene", format!("{scene}: with {symbol} = {own_strength} it {own}")),
        ("calibrated", fitted),
        ("from depths", from_depths),
    ];
    labelled_each(page, &lines);
}

fn strength(value: f64) -> String {
    engineering(value, "Pa", 4)
}

fn range((low, high): (Option<f64>, Option<f64>), show: impl Fn(f64) -> String) -> String {
    match (low.map(&show), high.map(&show)) {
        (Some(low), Some(high)) => format!("{low} to {high}"),
        (Some(low), None) => format!("{low} or more: the shots do not bound it above"),
        (None, Some(high)) => format!("{high} or less: the shots do not bound it below"),
        (None, None) => "not bounded: too few shots near the limit".to_owned(),
    }
}
