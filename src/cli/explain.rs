//! `cmra explain [NAME]`: a variable, quantity or warning, or all of them, as a page.

use std::fmt::Write as _;

use clap::Args;

use crate::cli::text::{self, hanging};
use crate::cli::{CliError, output};
use crate::tui::widgets::text::wrap;
use cmra_engine::model::run::envelope::Check;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::shortest;
use cmra_engine::model::variables::{Group, VARIABLES, Variable, find, nearest, used_where};
use cmra_studies::study::quantities::{self, QUANTITIES, Quantity};

#[derive(Debug, Args)]
pub(super) struct ExplainArguments {
    /// A variable by symbol, name or key (gamma, thickness), a quantity (`limit_velocity_m_s`) or a warning ('plate face'); without it: all of them
    name: Option<String>,
}

pub(super) fn run(arguments: &ExplainArguments) -> Result<(), CliError> {
    let page = match &arguments.name {
        None => list(),
        Some(name) => pages(name.trim())?.join("\n"),
    };
    output::print(&page)
}

/// Returns the pages for a name, which may contain blanks: a quantity or variable, a warning, or both.
fn pages(name: &str) -> Result<Vec<String>, CliError> {
    let spelled = name.replace([' ', '-'], "_");
    let quantity = quantities::find(name).or_else(|| quantities::find(&spelled));
    let variable = || find(name).or_else(|_| find(&spelled)).ok();
    let unknown = || {
        CliError::Option(format!(
            "`{name}` is neither a variable ({}) nor a quantity ({}) nor a warning ({})",
            nearest(name),
            quantities::nearest(name),
            Check::WORDS.join(", ")
        ))
    };
    let is_it = |check: &Check| check.label().eq_ignore_ascii_case(name);
    let warning = Check::ALL.into_iter().find(is_it).map(|it| {
        let lines = wrap(it.about(), text::width().saturating_sub(2));
        format!("{}: a warning\n  {}\n", it.label(), lines.join("\n  "))
    });
    let other = quantity.map(quantity_page).or_else(|| variable().map(variable_page));
    let found: Vec<String> = other.into_iter().chain(warning).collect();
    if !found.is_empty() {
        return Ok(found);
    }
    let on_screen = SCREEN.iter().filter(|(words, _)| words.contains(&name));
    let choices = VARIABLES.iter().filter(|it| it.keys().contains(&name)).map(variable_page);
    let words: Vec<String> = on_screen
        .map(|(_, about)| hanging(&format!("{name}: "), about, 2))
        .chain(choices)
        .collect();
    if !words.is_empty() {
        return Ok(words);
    }
    quantities::named(name).map(|it| vec![quantity_page(it)]).map_err(|_not_titled| unknown())
}

/// Words and signs of screens and pages that are neither variables nor quantities nor warnings.
const SCREEN: &[(&[&str], &str)] = &[
    (
        &["plastic"],
        "depth, and in brackets percent, of the same shot if the interface between projectile and plate can yield; set interface=plastic",
    ),
    (&["travel"], "greatest plate displacement (max_plate_displacement_m)"),
    (&["depth"], "final penetration into the plate (final_penetration_m)"),
    (&["%"], "depth in percent of that of the same plate on a rigid mount (percent_of_baseline)"),
    (&["peak"], "greatest contact force (peak_contact_force_n)"),
    (&["mount"], "greatest force of spring, damper and stop on the mount (peak_mount_force_n)"),
    (
        &["v_bl", "limit"],
        "ballistic limit: the least velocity that perforates the plate (limit_velocity_m_s)",
    ),
    (
        &["margin"],
        "how far this shot's velocity is below the ballistic limit, in percent of the shot's velocity; a shot with a negative margin perforates",
    ),
    (
        &["validity"],
        "the range in which the model was compared with experiments; a check that fails is named, with the side on which the answer errs",
    ),
    (
        &["conservative"],
        "outside the validity, on the safe side: the model says more depth, force or displacement than there is",
    ),
    (
        &["unconservative"],
        "outside the validity, on the unsafe side: the model says less depth, force or displacement than there is",
    ),
    (&["error"], "estimated error of the depth, relative to the depth, from a second computation"),
    (
        &["omitted"],
        "parts of the model that do nothing in this scene and are not computed: they change no digit",
    ),
    (
        &["A"],
        "contact area of the nose, up to pi R^2: A S_y is the greatest load that the interface bears",
    ),
    (&["D"], "diameter of the projectile, 2 R: h/D compares the thickness of the plate with it"),
    (
        &["arrested", "stick"],
        "outcome: the projectile comes to rest relative to the plate within it",
    ),
    (&["perforated"], "outcome: the projectile leaves the plate through its rear face"),
    (
        &["separated"],
        "outcome: the plate moves away from the projectile, which no longer touches it",
    ),
    (&["moving"], "outcome: undecided at the horizon, which is the end of the computed time"),
    (
        &["knee"],
        "design of a front beyond which an objective gains little for what the others lose",
    ),
    (
        &["feasible"],
        "a design without a warning on the unsafe side (interface, spring, stop, face)",
    ),
];

fn variable_page(variable: &Variable) -> String {
    let mut page = format!("{}: {}\n", variable.symbol, variable.meaning);
    let mut line = |label: &str, text: &str| {
        let _ = writeln!(page, "  {label:<12} {text}");
    };
    line("name", &variable.name());
    line("key", variable.key);
    if !variable.aliases.is_empty() {
        line("also", &variable.aliases.join(", "));
    }
    line("default", &default_of(variable));
    line("allowed", &variable.allowed());
    if let Some((low, high)) = variable.thesis_range {
        let unit = variable.unit();
        line("thesis", format!("{} to {} {unit}", shortest(low), shortest(high)).trim_end());
    }
    if let Some(used) = used_where(variable, &Scene::default()) {
        line("used", &used);
    }
    line("source", variable.source);
    line("for example", &format!("--set {}={}", variable.symbol, example(variable)));
    page
}

/// A value to write: the default, or the first word of a choice that is not.
fn example(variable: &Variable) -> String {
    let default = variable.show(&Scene::default());
    let other = variable.keys().iter().find(|word| **word != default);
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

/// Formats the default of a variable with its unit.
fn default_of(variable: &Variable) -> String {
    let value = variable.show(&Scene::default());
    // A word in the place of a number has no unit.
    let unit = if value.parse::<f64>().is_ok() { variable.unit() } else { "" };
    format!("{value} {unit}").trim_end().to_owned()
}

/// Formats name and meaning of a variable; words that both begin with appear once.
fn name_and_meaning(variable: &Variable) -> String {
    let (name, meaning) = (variable.name(), variable.meaning);
    let rest = meaning.strip_prefix(&name.replace('_', " "));
    match rest.filter(|rest| !rest.starts_with(char::is_alphanumeric)) {
        Some(rest) => format!("{name}{rest}"),
        None => format!("{name}: {meaning}"),
    }
}

/// All variables by their groups, then all quantities.
fn list() -> String {
    let mut page = "VARIABLES: symbol, default, name and meaning\n".to_owned();
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
            page += &hanging(&lead, &name_and_meaning(it), lead.chars().count());
        }
    }
    page.push_str("\nQUANTITIES: name, what has to be computed, meaning\n\n");
    for quantity in QUANTITIES {
        let Quantity { name, meaning, .. } = quantity;
        let _ = writeln!(page, "  {name:<33} {:<7} {meaning}", quantity.needs().word());
    }
    page.push_str(
        "\nscene: no simulation; run: one simulation; course: one simulation and its time series; limit: a search with many shots, only on request\n\nWARNINGS: ",
    );
    page += &Check::WORDS.join(", ");
    page.push_str("\n\n`cmra explain NAME` explains one.\n");
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The words of the first screen, of its table, its status row and the pages of results, and every word of a choice.
    #[test]
    fn every_word_of_a_screen_is_explained() {
        let words = [
            "plastic",
            "travel",
            "v_bl",
            "margin",
            "validity",
            "conservative",
            "unconservative",
            "fused",
            "error",
            "A",
            "D",
            "depth",
            "peak",
            "mount",
            "omitted",
            "%",
            "arrested",
            "perforated",
            "separated",
            "moving",
            "stroke",
            "interface",
            "h/D",
            "spring mass",
            "rebound",
            "knee",
            "feasible",
        ];
        let choices = VARIABLES.iter().flat_map(|it| it.keys().iter().copied());
        for word in words.into_iter().chain(choices) {
            let found = pages(word).unwrap_or_else(|error| panic!("{word}: {error}"));
            assert!(found.iter().all(|page| page.len() > 20), "{word}: {found:?}");
        }
        assert!(pages("nonsense").is_err());
    }
}
