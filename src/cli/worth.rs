//! `cmra worth [SCENE]`: chapter 4's criterion as a page, CSV or JSON.

mod page;

use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::CliError;
use crate::cli::pace::Pace;
use crate::cli::scene::SceneArguments;
use crate::cli::table::TableArguments;
use crate::files::worth as files;
use crate::model::units::{self, Bare, Quantity};
use crate::study::worth::{Masses, compare};

#[derive(Debug, Args)]
pub(super) struct WorthArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Mass of the spring, kg or with a unit [default: the least a helical steel spring needs for its energy]
    #[arg(long, value_name = "MASS", allow_hyphen_values = true)]
    spring_mass: Option<String>,
    /// Mass of damper, stop and mount together, kg or with a unit
    #[arg(long, value_name = "MASS", default_value = "0", allow_hyphen_values = true)]
    mount_mass: String,
    #[command(flatten)]
    table: TableArguments,
}

fn mass(option: &str, text: &str) -> Result<f64, CliError> {
    let refused = |why: String| CliError::Option(format!("{option} {text}: {why}"));
    let value = units::parse(text, Quantity::Mass, Bare::Si)
        .map_err(|problem| refused(problem.to_string()))?;
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(refused("a mass is 0 kg or more, for example 20g".to_owned()))
    }
}

/// Compare; a mechanism that is not worth it is an answer, too.
pub(super) fn run(arguments: &WorthArguments) -> Result<ExitCode, CliError> {
    arguments.table.check_beside()?;
    let spring = arguments.spring_mass.as_deref();
    let masses = Masses {
        spring_kg: spring.map(|text| mass("--spring-mass", text)).transpose()?,
        mount_kg: mass("--mount-mass", &arguments.mount_mass)?,
    };
    let preset = arguments.scene.load()?;
    let scene = Arc::new(preset.scene);
    let mut pace = Pace::begin();
    let watch = &mut |done, total| pace.count(done, total, "candidates");
    let report = compare(&scene, masses, watch)?;
    pace.clear();
    let name = preset.name.as_str();
    let rows = files::rows(name, &report);
    let page = || page::text(name, &scene, &report, arguments.spring_mass.is_some());
    let object = || files::json(name, &report);
    arguments.table.of(&arguments.scene, &scene).deliver_report(page, object, &rows)?;
    Ok(pace.exit_code(true))
}
