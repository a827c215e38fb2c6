//! `cmra variables`: every variable of a scene, as a page, CSV or JSON.

use std::fmt::Write as _;

use clap::Args;
use serde_json::Value;

use crate::cli::CliError;
use crate::cli::table::TableArguments;
use crate::files::rows::{Rows, number};
use crate::model::scene::Scene;
use crate::model::variables::{Group, Kind, VARIABLES, Variable, used_when};

#[derive(Debug, Args)]
pub(super) struct VariablesArguments {
    #[command(flatten)]
    table: TableArguments,
}

/// Print the table.
pub(super) fn run(arguments: &VariablesArguments) -> Result<(), CliError> {
    arguments.table.check()?;
    arguments.table.deliver(&page(), &rows(VARIABLES))
}

/// Variables with everything that is known of them, a row each.
pub(super) fn rows(variables: &[Variable]) -> Rows {
    let columns = vec![
        "symbol",
        "name",
        "key",
        "group",
        "meaning",
        "unit",
        "default",
        "allowed",
        "thesis_low",
        "thesis_high",
        "used_when",
        "source",
    ];
    let row = |variable: &Variable| {
        let range = thesis_range(variable);
        vec![
            Value::from(variable.symbol),
            Value::from(variable.name()),
            Value::from(variable.key),
            Value::from(variable.group.title()),
            Value::from(variable.meaning),
            Value::from(variable.unit().trim_matches('-')),
            Value::from(variable.show(&Scene::default())),
            Value::from(variable.allowed()),
            number(range.map(|range| range.0)),
            number(range.map(|range| range.1)),
            Value::from(used_when(variable)),
            Value::from(variable.source),
        ]
    };
    Rows { columns, rows: variables.iter().map(row).collect() }
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
