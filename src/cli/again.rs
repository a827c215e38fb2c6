//! The command line that makes a table again, with the scene read from the file beside it.

use std::ffi::OsString;
use std::sync::OnceLock;

use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Command};

use crate::cli::commands;
use crate::files::clean::shell_word;
use crate::files::export;
use crate::model::variables::find;

/// Options that the sidecar's scene already contains.
const CHANGES: [&str; 4] = ["set", "threat", "material", "absorber"];
/// What a goal seek would choose by itself.
const LAW: &str = "interface.law";
/// Options that say where results go.
const RESULTS: [&str; 6] = ["csv", "force", "json", "svg", "plain", "glyphs"];

/// The command line that is carried out.
static TYPED: OnceLock<Vec<OsString>> = OnceLock::new();

/// Notes the command line that is carried out.
pub(super) fn note(typed: &[OsString]) {
    TYPED.get_or_init(|| typed.to_vec());
}

/// The comment line with the command that was typed; `scene`, the file beside the table, takes the place of SCENE.
pub(super) fn comment(scene: &str) -> String {
    let mut program = commands::whole();
    // The parser has accepted these words before.
    let typed = TYPED.get().map_or(&[][..], Vec::as_slice);
    let typed = program.try_get_matches_from_mut(typed).unwrap_or_default();
    export::again(&line(&program, &typed, scene))
}

/// The command that makes the rows again on standard output: its name, its positional arguments, its options by their names of today
/// with the values as they were typed.
fn line(program: &Command, typed: &ArgMatches, scene: &str) -> String {
    let mut words = vec!["cmra".to_owned()];
    let (mut command, mut typed) = (program, typed);
    while let Some((name, inner)) = typed.subcommand() {
        words.push(name.to_owned());
        (command, typed) = (command.find_subcommand(name).unwrap_or(command), inner);
    }
    for argument in command.get_positionals() {
        let is_scene = matches!(argument.get_id().as_str(), "scene" | "scenes");
        if is_scene {
            words.push(shell_word(scene));
        } else {
            words.extend(occurrences(typed, argument).concat().iter().map(|it| shell_word(it)));
        }
    }
    let is_seek = command.get_name() == "seek";
    // In the order in which they were typed; groups have an id too.
    let option = |id| command.get_arguments().find(|it| it.get_id() == id && !it.is_positional());
    for option in typed.ids().filter_map(option) {
        let Some(long) = option.get_long() else { continue };
        let is_dropped = RESULTS.contains(&long) || CHANGES.contains(&long);
        // A goal seek takes the plastic interface unless it is told otherwise, whatever the scene beside has.
        let keeps = |values: &[String]| {
            let is_law = |it: &String| {
                it.split_once('=').is_some_and(|(name, _)| find(name).is_ok_and(|it| it.key == LAW))
            };
            is_seek && long == "set" && values.iter().any(is_law)
        };
        for values in occurrences(typed, option).iter().filter(|it| !is_dropped || keeps(it)) {
            words.push(format!("--{long}"));
            // Values that commas separated.
            words.extend(option.get_action().takes_values().then(|| shell_word(&values.join(","))));
        }
    }
    words.push("--csv -".to_owned());
    words.join(" ")
}

/// The values that were typed for an argument, each time.
fn occurrences(typed: &ArgMatches, argument: &Arg) -> Vec<Vec<String>> {
    let id = argument.get_id().as_str();
    let is_typed = typed.value_source(id) == Some(ValueSource::CommandLine);
    let times = typed.get_raw_occurrences(id).filter(|_| is_typed).into_iter().flatten();
    times.map(|all| all.map(|it| it.to_string_lossy().into_owned()).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_makes_the_rows_again_from_the_scene_beside() {
        for (typed, expected) in [
            (
                "limit thin --criterion passage --set h=1mm --csv a.csv --force",
                "limit ./a.toml --criterion passage",
            ),
            ("limit --csv=a.csv --set=h=1mm", "limit ./a.toml"),
            // Names as they are today: another spelling.
            (
                "optimize --minimize stroke_m,steps --maximize=v_i --csv a.csv",
                "optimise ./a.toml --minimise stroke_m,steps --maximise v_i",
            ),
            ("montecarlo --output steps --csv a.csv", "montecarlo ./a.toml --outputs steps"),
            // Nothing else goes to standard output.
            ("compare --map v_i,gamma --svg - --csv a.csv", "compare ./a.toml --map v_i,gamma"),
            ("run thin --dt 1us --csv a.csv", "run ./a.toml --dt 1us"),
            (
                "seek --over d=0..1 --goal stroke_m=1 --set interface=fused --set h=1mm --csv a.csv",
                "seek ./a.toml --over d=0..1 --goal stroke_m=1 --set interface=fused",
            ),
            ("design thin --set h=1mm --csv a.csv", "design ./a.toml"),
            ("stability --quick --map k --csv a.csv", "stability ./a.toml --quick --map k"),
        ] {
            let mut program = commands::whole();
            let words = std::iter::once("cmra").chain(typed.split(' '));
            let found = program.try_get_matches_from_mut(words).unwrap();
            let line = line(&program, &found, "./a.toml");
            assert_eq!(line, format!("cmra {expected} --csv -"), "{typed}");
        }
    }
}
