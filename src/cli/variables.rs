//! `cmra variables`: every variable of a scene, as a page, CSV or JSON.

use std::fmt::Write as _;

use clap::Args;

use crate::cli::CliError;
use crate::cli::table::TableArguments;
use crate::model::scene::Scene;
use crate::model::variables::{Group, Kind, VARIABLES, Variable, used_when};
use crate::report::table::Table;

#[derive(Debug, Args)]
pub(super) struct VariablesArguments {
    #[command(flatten)]
    table: TableArguments,
}

/// Print the table.
pub(super) fn run(arguments: &VariablesArguments) -> Result<(), CliError> {
    arguments.table.check()?;
    arguments.table.alone().deliver(&page(), &rows(VARIABLES))
}

/// Variables with everything that is known of them, a row each.
pub(super) fn rows(variables: &[Variable]) -> Table<'_, &Variable> {
    Table::of(variables)
        .with("symbol", "symbol", "", |it| it.symbol)
        .with("name", "name", "", |it| it.name())
        .with("key", "key", "", |it| it.key)
        .with("group", "group", "", |it| it.group.title())
        .with("meaning", "meaning", "", |it| it.meaning)
        .with("unit", "unit", "", |it| it.unit().trim_matches('-'))
        .with("default", "default", "", |it| it.show(&Scene::default()))
        .with("allowed", "allowed", "", |it| it.allowed())
        .with("thesis_low", "thesis from", "", |it| Some(thesis_range(it)?.0))
        .with("thesis_high", "thesis to", "", |it| Some(thesis_range(it)?.1))
        .with("used_when", "used when", "", |it| used_when(it))
        .with("source", "source", "", |it| it.source)
}

/// The range the thesis searched.
pub(super) fn thesis_range(variable: &Variable) -> Option<(f64, f64)> {
    match &variable.kind {
        Kind::Number(number) => number.thesis_range,
        Kind::Choice(_) | Kind::Switch { .. } => None,
    }
}

/// Its default with the unit.
pub(super) fn default_of(variable: &Variable) -> String {
    let value = variable.show(&Scene::default());
    format!("{value} {}", variable.unit().trim_matches('-')).trim_end().to_owned()
}

fn page() -> String {
    let mut page =
        "symbol, name, default and meaning; `cmra explain NAME` tells all of one\n".to_owned();
    for group in Group::ALL {
        let _ = writeln!(page, "\n{}", group.title());
        for variable in VARIABLES.iter().filter(|variable| variable.group == group) {
            let _ = writeln!(
                page,
                "  {:<13} {:<26} {:<18} {}",
                variable.symbol,
                variable.name(),
                default_of(variable),
                variable.meaning
            );
        }
    }
    page
}
