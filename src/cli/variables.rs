//! `cmra variables`: every variable of a scene, as a page, CSV or JSON.

use std::fmt::Write as _;

use crate::cli::CliError;
use crate::cli::table::TableArguments;
use crate::cli::text::hanging;
use crate::model::scene::Scene;
use crate::model::variables::{Group, VARIABLES, Variable, used_when};
use crate::report::table::Table;

pub(super) fn run(table: &TableArguments) -> Result<(), CliError> {
    table.check()?;
    table.alone().deliver(&page(), rows(&VARIABLES))
}

/// Variables with everything that is known of them, a row each.
pub(super) fn rows(variables: &[Variable]) -> Table<'_, &Variable> {
    Table::of(variables)
        .with("symbol", "symbol", "", |it| it.symbol)
        .with("name", "name", "", |it| it.name())
        .with("key", "key", "", |it| it.key)
        .with("group", "group", "", |it| it.group.title())
        .with("meaning", "meaning", "", |it| it.meaning)
        .with("unit", "unit", "", |it| it.unit())
        .with("default", "default", "", |it| it.show(&Scene::default()))
        .with("allowed", "allowed", "", |it| it.allowed())
        .with("thesis_low", "thesis from", "", |it| Some(it.thesis_range()?.0))
        .with("thesis_high", "thesis to", "", |it| Some(it.thesis_range()?.1))
        .with("used_when", "used when", "", |it| used_when(it))
        .with("source", "source", "", |it| it.source)
}

/// Its default with the unit.
pub(super) fn default_of(variable: &Variable) -> String {
    let value = variable.show(&Scene::default());
    // A word in the place of a number has no unit.
    let unit = if value.parse::<f64>().is_ok() { variable.unit() } else { "" };
    format!("{value} {unit}").trim_end().to_owned()
}

/// Its name, then its meaning, without the words of the name where it begins with them.
fn named(variable: &Variable) -> String {
    let (name, meaning) = (variable.name(), variable.meaning);
    let rest = meaning.strip_prefix(&name.replace('_', " "));
    match rest.filter(|rest| !rest.starts_with(char::is_alphanumeric)) {
        Some(rest) => format!("{name}{rest}"),
        None => format!("{name}: {meaning}"),
    }
}

fn page() -> String {
    let mut page =
        "symbol, default, name and meaning; `cmra explain SYMBOL` explains one\n".to_owned();
    for group in Group::ALL {
        let own: Vec<&Variable> = VARIABLES.iter().filter(|it| it.group == group).collect();
        // As narrow as the group allows: the meaning has the rest of the line.
        let widest = |text: fn(&Variable) -> String| {
            own.iter().map(|it| text(it).chars().count()).max().unwrap_or(0)
        };
        let (symbols, defaults) = (widest(|it| it.symbol.to_owned()), widest(default_of));
        let _ = writeln!(page, "\n{}", group.title());
        for it in own {
            let lead = format!("  {:symbols$}  {:defaults$}  ", it.symbol, default_of(it));
            page += &hanging(&lead, &named(it), lead.chars().count());
        }
    }
    page
}
