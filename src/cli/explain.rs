//! `cmra explain NAME`: one variable or quantity, or all quantities, as a page, CSV or JSON.

use std::fmt::Write as _;

use clap::Args;

use crate::cli::table::TableArguments;
use crate::cli::{CliError, variables};
use crate::model::scene::Scene;
use crate::model::units::shortest;
use crate::model::variables::{Variable, find, nearest, used_when};
use crate::report::table::Table;
use crate::study::quantities::{self, QUANTITIES, Quantity};

/// The word for all quantities.
const ALL: &str = "quantities";

#[derive(Debug, Args)]
pub(super) struct ExplainArguments {
    /// A variable by symbol, name or key (gamma, thickness), a quantity (`limit_velocity_m_s`), or `quantities` for all of them
    name: String,
    #[command(flatten)]
    table: TableArguments,
}

pub(super) fn run(arguments: &ExplainArguments) -> Result<(), CliError> {
    let table = &arguments.table;
    table.check()?;
    let name = arguments.name.trim();
    if name == ALL {
        let all: Vec<&Quantity> = QUANTITIES.iter().collect();
        return table.alone().deliver(&list(), quantity_rows(&all));
    }
    let spelled = name.replace([' ', '-'], "_");
    let is_quantity = [name, &spelled].into_iter().any(|it| quantities::find(it).is_some());
    let variable = find(name).or_else(|_| find(&spelled)).ok().filter(|_| !is_quantity);
    let Some(variable) = variable else {
        let quantity = quantities::named(name).map_err(|_unknown| {
            CliError::Option(format!(
                "`{name}` is neither a variable ({}) nor a quantity ({})",
                nearest(name),
                quantities::nearest(name)
            ))
        })?;
        return table.alone().deliver(&quantity_page(quantity), quantity_rows(&[quantity]));
    };
    let mut page = format!("{}: {}\n", variable.symbol, variable.meaning);
    let mut line = |label: &str, text: &str| {
        let _ = writeln!(page, "  {label:<12} {text}");
    };
    line("name", &variable.name());
    line("key", variable.key);
    if !variable.aliases.is_empty() {
        line("also", &variable.aliases.join(", "));
    }
    line("default", &variables::default_of(variable));
    line("allowed", &variable.allowed());
    if let Some((low, high)) = variable.thesis_range() {
        let unit = variable.unit();
        line("thesis", format!("{} to {} {unit}", shortest(low), shortest(high)).trim_end());
    }
    line("used", &used_when(variable));
    line("source", variable.source);
    line("for example", &format!("--set {}={}", variable.symbol, example(variable)));
    table.alone().deliver(&page, variables::rows(std::slice::from_ref(variable)))
}

/// A value to write: the default, or the first word of a choice that is not.
fn example(variable: &Variable) -> String {
    let default = variable.show(&Scene::default());
    let other = variable.words().iter().find(|word| **word != default);
    other.map_or(default, |word| (*word).to_owned())
}

fn quantity_page(quantity: &Quantity) -> String {
    let mut page = format!("{}: {}\n", quantity.name, quantity.meaning);
    let unit = quantity.unit();
    let usable = "sweep --outputs, seek --goal, optimise --minimise, --maximise and --subject-to, montecarlo --outputs, sensitivity --output";
    let unit = if unit.is_empty() { "none" } else { unit };
    for (label, text) in
        [("unit", unit), ("needs", quantity.needs().words()), ("usable in", usable)]
    {
        let _ = writeln!(page, "  {label:<12} {text}");
    }
    page
}

fn list() -> String {
    let mut page = "quantities: name, what has to be computed, meaning\n\n".to_owned();
    for quantity in QUANTITIES {
        let Quantity { name, meaning, .. } = quantity;
        let _ = writeln!(page, "  {name:<33} {:<7} {meaning}", quantity.needs().word());
    }
    page.push_str(
        "\nscene: no simulation; run: one simulation; course: one simulation and its time series; limit: a search with many shots, only on request\n",
    );
    page
}

fn quantity_rows<'q>(quantities: &'q [&Quantity]) -> Table<'q, &'q Quantity> {
    Table::of(quantities.iter().copied())
        .with("key", "key", "", |it| it.name)
        .with("label", "label", "", |it| it.title())
        .with("unit", "unit", "", |it| it.unit())
        .with("meaning", "meaning", "", |it| it.meaning)
        .with("needs", "needs", "", |it| it.needs().words())
}
