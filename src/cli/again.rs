//! The command line that makes a table again, with the scene read from the file beside it.

use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Command};

use crate::cli::commands;
use crate::files::clean::shell_word;
use crate::files::export;

/// Options that the sidecar's scene already contains.
const CHANGES: [&str; 4] = ["set", "threat", "material", "absorber"];
/// Options that say where results go.
const RESULTS: [&str; 8] = ["csv", "force", "csv-style", "meta", "json", "svg", "plain", "glyphs"];

/// The comment line with the command that was typed. `scene` takes the place of SCENE; without one the scene and its changes stay as
/// they were typed.
pub(super) fn comment(scene: Option<&str>) -> String {
    let mut program = commands::whole();
    // The parser has accepted these words before.
    let typed = program.try_get_matches_from_mut(std::env::args_os()).unwrap_or_default();
    export::again(&line(&program, &typed, scene))
}

/// The command that makes the rows again on standard output: its name, its positional arguments, its options by their names of today
/// with the values as they were typed.
fn line(program: &Command, typed: &ArgMatches, scene: Option<&str>) -> String {
    let mut words = vec!["cmra".to_owned()];
    let Some((name, typed)) = typed.subcommand() else { return words.remove(0) };
    words.push(name.to_owned());
    let command = program.find_subcommand(name).unwrap_or(program);
    for argument in command.get_positionals() {
        match scene.filter(|_| matches!(argument.get_id().as_str(), "scene" | "scenes")) {
            Some(scene) => words.push(shell_word(scene)),
            None => words.extend(values(typed, argument).iter().map(|it| shell_word(it))),
        }
    }
    // In the order in which they were typed; groups have an id too.
    let option = |id| command.get_arguments().find(|it| it.get_id() == id && !it.is_positional());
    for option in typed.ids().filter_map(option) {
        let Some(long) = option.get_long() else { continue };
        let is_dropped = RESULTS.contains(&long) || scene.is_some() && CHANGES.contains(&long);
        for value in values(typed, option).iter().filter(|_| !is_dropped) {
            words.push(format!("--{long}"));
            words.extend(option.get_action().takes_values().then(|| shell_word(value)));
        }
    }
    words.push("--csv -".to_owned());
    words.join(" ")
}

/// What was typed for an argument: a text for each time, in which values that commas separate are together again.
fn values(typed: &ArgMatches, argument: &Arg) -> Vec<String> {
    let id = argument.get_id().as_str();
    let is_typed = typed.value_source(id) == Some(ValueSource::CommandLine);
    let times = typed.get_raw_occurrences(id).filter(|_| is_typed).into_iter().flatten();
    times.map(|all| all.map(|it| it.to_string_lossy()).collect::<Vec<_>>().join(",")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_makes_the_rows_again_from_the_scene_beside() {
        let line = |typed: &str, scene: Option<&str>| {
            let mut program = commands::whole();
            let words = std::iter::once("cmra").chain(typed.split(' '));
            let found = program.try_get_matches_from_mut(words).unwrap();
            line(&program, &found, scene)
        };
        for (typed, scene, expected) in [
            (
                "limit thin --seed 4 --set h=1mm --csv a.csv --force",
                "./a.toml",
                "limit ./a.toml --seed 4",
            ),
            ("limit --csv=a.csv --set=h=1mm", "./a b.toml", "limit './a b.toml'"),
            ("fit shots.csv thin --set h=1mm --csv a.csv", "./a.toml", "fit shots.csv ./a.toml"),
            (
                "limit thin --set h=1mm --set v_i=9 --csv a.csv",
                "",
                "limit thin --set h=1mm --set v_i=9",
            ),
            // Names as they are today: another spelling, an old name.
            ("limit --scatter 5% --csv a.csv", "./a.toml", "limit ./a.toml --monte-carlo 5%"),
            (
                "optimize --minimize stroke_m,steps --maximize=v_i --csv a.csv",
                "./a.toml",
                "optimise ./a.toml --minimise stroke_m,steps --maximise v_i",
            ),
            (
                "scatter --output steps --csv a.csv",
                "./a.toml",
                "montecarlo ./a.toml --outputs steps",
            ),
            // Nothing else goes to standard output.
            (
                "compare --map v_i,gamma --svg - --csv a.csv",
                "./a.toml",
                "compare ./a.toml --map v_i,gamma",
            ),
            (
                "stability --quick --map k --csv a.csv",
                "./a.toml",
                "stability ./a.toml --quick --map k",
            ),
        ] {
            let scene = Some(scene).filter(|it| !it.is_empty());
            assert_eq!(line(typed, scene), format!("cmra {expected} --csv -"), "{typed}");
        }
    }
}
