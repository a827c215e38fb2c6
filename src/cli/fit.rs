//! `cmra fit SHOTS`: V50 from a person's own shots, and the strength that gives it.

mod page;

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use clap::Args;

use crate::cli::progress::ProgressLine;
use crate::cli::scene::SceneArguments;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, output};
use crate::files::shots;
use crate::report::fit as tables;
use crate::study::fit::calibrate::calibrate;
use crate::study::fit::fit;

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
    let mut line = ProgressLine::begin();
    let mut found = None;
    if is_calibrated {
        let preset = arguments.scene.load()?;
        let calibration = line.study(1, "shots to calibrate the strength", |context| {
            calibrate(&preset.scene, &report.logistic, &report.shots, context)
        })?;
        found = Some((preset, calibration));
    }
    let calibration = found.as_ref().map(|(_, calibration)| calibration);
    let named = found.as_ref().map(|(preset, calibration)| (preset.name.as_str(), calibration));
    let page = || page::text(&name, &report, named);
    let object = || tables::json(&report, calibration);
    let table = match &found {
        Some((preset, _)) => arguments.table.of(&arguments.scene, &preset.scene),
        None => arguments.table.alone(),
    };
    table.deliver_report(page, object, &tables::table(&report))?;
    Ok(line.exit_code(calibration.is_none_or(|it| it.from_limit_pa.is_some())))
}
