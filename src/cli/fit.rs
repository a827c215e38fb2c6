//! `cmra fit SHOTS`: V50 from a person's own shots, and the strength that gives it.

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use clap::Args;

use crate::cli::scene::SceneArguments;
use crate::cli::table::TableArguments;
use crate::cli::text::{labelled, width};
use crate::cli::{CliError, output, progress};
use crate::files::{clean, shots};
use crate::model::units::{engineering, fixed_significant, velocity};
use crate::numerics::statistics::sorted_by;
use crate::report::fit as tables;
use crate::report::fit::table;
use crate::study::fit::calibrate::{Calibration, calibrate};
use crate::study::fit::{Estimator, Report, fit};

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

/// The page; a calibration with the name of its scene.
fn page(file: &str, report: &Report, calibration: Option<(&str, &Calibration)>) -> String {
    let mut page = format!("{}: ballistic limit from shots\n\n", clean::line(file));
    let (all, through) = (report.shots.len(), report.perforated());
    labelled(
        &mut page,
        "shots",
        &format!("{all}: {} stopped, {through} perforated", all - through),
    );
    labelled(&mut page, "results", &results(report));
    let fit = &report.logistic;
    labelled(
        &mut page,
        "V50",
        &format!(
            "{}, 95 % confidence {}",
            velocity(fit.v50_m_s, 5),
            range(fit.range_m_s, |it| velocity(it, 5))
        ),
    );
    labelled(
        &mut page,
        "curve",
        &format!(
            "10 % perforate at {}, 90 % at {} (logistic, {})",
            velocity(fit.quantile_m_s(0.1), 5),
            velocity(fit.quantile_m_s(0.9), 5),
            fit.method.words()
        ),
    );
    labelled(&mut page, "residual", &residual(report));
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
            format!(
                "v_r = a (v^p - v_l^p)^(1/p): a = {}, p = {}, v_l = {}; RMS error {} over {count} shots",
                fixed_significant(law.a, 4),
                fixed_significant(law.p, 4),
                velocity(law.limit_m_s, 5),
                velocity(law.misfit_m_s, 5)
            )
        },
    )
}

fn calibrated(page: &mut String, scene: &str, found: &Calibration) {
    let own = found.own_limit_m_s.map_or_else(
        || "has no limit".to_owned(),
        |v| format!("has a limit of {}", velocity(v, 5)),
    );
    labelled(
        page,
        "scene",
        &format!(
            "{}: with {} = {} it {own}",
            clean::line(scene),
            found.symbol,
            strength(found.own_pa)
        ),
    );
    let fitted = found.from_limit_pa.map_or_else(
        || format!("no {} gives the scene this V50", found.symbol),
        |value| {
            format!(
                "{} = {} gives it this V50; confidence {}; try --set {}={value:.0}",
                found.symbol,
                strength(value),
                range(found.range_pa, strength),
                found.symbol
            )
        },
    );
    labelled(page, "calibrated", &fitted);
    if let Some(depths) = found.from_depths {
        let scatter = depths
            .deviation_pa
            .map_or_else(String::new, |it| format!(", standard deviation {}", strength(it)));
        let left_out = match depths.left_out {
            0 => String::new(),
            count => format!("; no strength gives the depth of {count} more"),
        };
        labelled(
            page,
            "from depths",
            &format!(
                "{} = {}{scatter}, mean over {} stopped shots{left_out}",
                found.symbol,
                strength(depths.mean_pa),
                depths.shots
            ),
        );
    }
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
