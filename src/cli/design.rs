//! `cmra design`: results of a shot by formulas, without a simulation.

use clap::Args;

use crate::cli::CliError;
use crate::cli::progress::Extent;
use crate::cli::scene::SceneArguments;
use crate::cli::table::TableArguments;
use crate::cli::value_parsers::above_zero;
use cmra_engine::model::units::Dimension;
use cmra_engine::model::variables;
use cmra_studies::report::design::{formulas, page, table, warnings};

#[derive(Debug, Args)]
pub(super) struct DesignArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Give Stone's `c_t`, the square of a speed in m2/s2, for his depth P of equation 2.4
    #[arg(long, value_name = "NUMBER", value_parser = above_zero(Dimension::Number, "2e5"))]
    c_t: Option<f64>,
    #[command(flatten)]
    table: TableArguments,
}

pub(super) fn run(arguments: &DesignArguments) -> Result<(), CliError> {
    let preset = arguments.scene.load()?;
    variables::validate(&preset.scene)?;
    let found = formulas(&preset.scene, arguments.c_t);
    let warnings = warnings(&preset.scene);
    let rows = table(&found).with_warnings(&warnings);
    let page = page(&preset.heading, &found, warnings);
    arguments.table.deliver(Extent::WHOLE, None, &page, None, rows)
}
