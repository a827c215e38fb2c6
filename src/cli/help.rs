//! `cmra help [TOPIC]`, and the commands in groups at the top of `cmra --help`.

use std::fmt::Write as _;

use clap::{Args, Command};

use crate::cli::{CliError, output};
use crate::files::error::did_you_mean;
use crate::tui::keymap::{GLOBAL_KEYS, KeyHelp, Keymap, PANE_KEYS};
use crate::tui::pages::all_panes;
use cmra_studies::report::wrap::wrap;

/// Pages of `cmra help`: name, subject, text. The page of keys is generated from the key bindings.
#[rustfmt::skip]
const TOPICS: [(&str, &str, &str); 8] = [
    ("scenes", "scene files, presets, values and units", include_str!("help/scenes.txt")),
    ("sweeps", "axes, designs, parts of a sweep on many machines", include_str!("help/sweeps.txt")),
    ("csv", "CSV, JSON and exit status", include_str!("help/csv.txt")),
    ("equations", "what is computed, with every symbol", include_str!("help/equations.txt")),
    ("mechanisms", "kinds of springs, dampers and stops", include_str!("help/mechanisms.txt")),
    ("stacks", "several plates behind one another", include_str!("help/stacks.txt")),
    ("methods", "how it is computed, and how that is checked", include_str!("help/methods.txt")),
    ("validation", "where the model may be used, and where not", include_str!("help/validation.txt")),
];
const KEYS: &str = "keys";

#[derive(Debug, Args)]
pub(super) struct HelpArguments {
    /// A topic or a command; without it: the list of topics
    topic: Option<String>,
}

/// How many of the commands do what most people come for.
const FIRST: usize = 9;

/// Returns the parser with the subcommands of its help in two groups: the main ones, then the others.
pub(super) fn grouped(program: Command) -> Command {
    let mut groups = String::from("Commands:\n");
    for (index, command) in program.get_subcommands().enumerate() {
        if index == FIRST {
            groups.push_str("\nMore:\n");
        }
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        let _ = writeln!(groups, "  {:<12} {about}", command.get_name());
    }
    program.help_template(format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{groups}\n\
         Arguments:\n{{positionals}}\n\nOptions:\n{{options}}{{after-help}}"
    ))
}

/// Prints a topic, the help of a command, or the list of topics.
pub(super) fn run(arguments: &HelpArguments, program: Command) -> Result<(), CliError> {
    let Some(name) = arguments.topic.as_deref() else {
        return output::print(&list());
    };
    let mut program = grouped(program);
    program.build();
    let text = if name == KEYS {
        keys()
    } else if let Some((_, _, text)) = TOPICS.into_iter().find(|topic| topic.0 == name) {
        text.to_owned()
    } else if let Some(found) = program.find_subcommand_mut(name) {
        found.render_long_help().to_string()
    } else {
        return Err(unknown(name, &program));
    };
    output::print(&text)
}

fn topics() -> Vec<&'static str> {
    TOPICS.iter().map(|topic| topic.0).chain([KEYS]).collect()
}

fn unknown(name: &str, program: &Command) -> CliError {
    let commands = program.get_subcommands().map(Command::get_name);
    let known: Vec<&str> = topics().into_iter().chain(commands).collect();
    let cure = did_you_mean(name, &known)
        .unwrap_or_else(|| format!("the topics are {}", topics().join(", ")));
    CliError::Option(format!("`{name}` is neither a topic nor a command: {cure}"))
}

fn list() -> String {
    let mut text = String::from("cmra help TOPIC, where TOPIC is one of\n\n");
    for (name, about, _) in TOPICS {
        let _ = writeln!(text, "  {name:<12} {about}");
    }
    let _ = writeln!(text, "  {KEYS:<12} every key of the workbench");
    text + "\nor a command: `cmra help run` prints `cmra run --help`.\n`cmra --help` lists the commands.\n"
}

/// Width of the description of a key, for a terminal of 80 columns.
const HELP_WIDTH: usize = 52;

/// Returns the page of keys: those with one meaning in all panes, then those of each pane.
fn keys() -> String {
    let map = Keymap::default();
    let mut text = String::from(
        "KEYS\n\nEvery key has one meaning in all panes. `?` in the workbench lists those of the\n\
         focused pane first. Other keys: [keys] in config.toml (see `cmra help scenes`),\n\
         each action by its name in brackets, as in `undo = \"U\"`.\n",
    );
    let line = |text: &mut String, keys: &str, help: &str| {
        for (row, line) in wrap(help, HELP_WIDTH).into_iter().enumerate() {
            let keys = if row == 0 { keys } else { "" };
            let _ = writeln!(text, "  {keys:<20}  {line}");
        }
    };
    let table = |text: &mut String, rows: &[KeyHelp]| {
        for row in rows {
            let names: Vec<&str> = row.keys.iter().map(|(_, name, _)| *name).collect();
            let help = format!("{} [{}]", map.shown(row.meaning), names.join(", "));
            line(text, &map.line_label(row), &help);
        }
    };
    text.push_str("\nIn every pane\n");
    table(&mut text, GLOBAL_KEYS);
    text.push_str("\nIn forms, charts and tables\n");
    table(&mut text, PANE_KEYS);
    for pane in all_panes() {
        let _ = writeln!(text, "\n{}", pane.label);
        for row in pane.keys {
            line(&mut text, &map.label(row.action), &map.shown(row.help));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::{CommandFactory as _, Parser as _};

    use crate::cli::{Arguments, commands};

    const COLUMNS: usize = 80;

    /// The examples of all pages, without what is said beside them.
    fn examples() -> Vec<&'static str> {
        let lines = TOPICS.iter().flat_map(|topic| topic.2.lines());
        let examples = lines.filter_map(|line| line.strip_prefix("  cmra "));
        examples.map(|line| line.split("  ").next().unwrap().trim_end_matches(" \\")).collect()
    }

    #[test]
    fn every_example_is_accepted() {
        assert!(examples().len() > 10, "{:?}", examples());
        for example in examples() {
            let words = std::iter::once("cmra").chain(example.split(' '));
            let typed = Arguments::try_parse_from(words).expect(example);
            // Those of a cluster are for its own files.
            if let Some(commands::Commands::Sweep(arguments)) = typed.command
                && !example.contains('$')
            {
                assert_eq!(arguments.problem(), None, "{example}");
            }
        }
    }

    /// A line break in the source of a text that is none in the text.
    #[test]
    fn helps_have_no_marks_of_the_source() {
        let mut program = commands::whole();
        for command in program.get_subcommands_mut() {
            let help = command.render_long_help().to_string();
            assert!(!help.contains('\\') && !help.contains("///"), "{help}");
        }
    }

    #[test]
    fn pages_fit_80_columns() {
        let pages = TOPICS.iter().map(|topic| (topic.0, topic.2.to_owned()));
        for (name, text) in pages.chain([(KEYS, keys()), ("list", list())]) {
            for line in text.lines() {
                assert!(line.chars().count() <= COLUMNS, "{name}: {line}");
            }
        }
        let help = grouped(Arguments::command()).term_width(COLUMNS).render_help().to_string();
        assert!(help.lines().all(|line| line.chars().count() <= COLUMNS), "{help}");
    }

    /// `Inertia` sizes a coil by the energies of a shot, whatever its run stores.
    #[test]
    fn the_mass_of_a_coil_is_that_of_its_rule() {
        let page = TOPICS.iter().find(|topic| topic.0 == "mechanisms").unwrap().2;
        let words = page.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(!words.contains("the least that stores"), "{words}");
        assert!(words.contains("projectile and plate at their common velocity"), "{words}");
    }
}
