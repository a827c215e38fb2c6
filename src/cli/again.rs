//! The command line that makes a table again, with the scene read from the file beside it.

use clap::{ArgAction, Command};

use crate::cli::commands;
use crate::files::clean::shell_word;
use crate::files::export;

/// Options that the sidecar's scene already contains, or that say where results go.
const DROPPED: [&str; 9] =
    ["set", "threat", "material", "absorber", "csv", "force", "csv-style", "meta", "json"];

/// The comment line with the command that was typed. `scene` takes the place of SCENE; without one the scene and its changes stay as
/// they were typed.
pub(super) fn comment(scene: Option<&str>) -> String {
    let typed = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
    export::again(&line(&commands::whole(), &typed.collect::<Vec<_>>(), scene))
}

/// The words after the program's name that make the rows again on standard output.
fn line(program: &Command, typed: &[String], scene: Option<&str>) -> String {
    let mut words = vec!["cmra".to_owned()];
    let Some((name, rest)) = typed.split_first() else { return words.remove(0) };
    words.push(shell_word(name));
    let command = program.find_subcommand(name).unwrap_or(program);
    let place =
        command.get_positionals().position(|it| matches!(it.get_id().as_str(), "scene" | "scenes"));
    let (mut positional, mut given) = (0, false);
    let mut rest = rest.iter();
    while let Some(word) = rest.next() {
        let Some(option) = word.strip_prefix("--").filter(|it| !it.is_empty()) else {
            let is_scene = scene.is_some() && place == Some(positional);
            positional += usize::from(!word.starts_with('-') || word == "-");
            given |= is_scene;
            words.push(shell_word(scene.filter(|_| is_scene).unwrap_or(word)));
            continue;
        };
        let (long, attached) = option.split_once('=').map_or((option, false), |it| (it.0, true));
        let takes_value = command
            .get_arguments()
            .find(|it| it.get_long() == Some(long))
            .is_some_and(|it| matches!(it.get_action(), ArgAction::Set | ArgAction::Append));
        let value = if takes_value && !attached { rest.next() } else { None };
        let is_dropped =
            DROPPED.iter().position(|it| *it == long).is_some_and(|at| at >= 4 || scene.is_some());
        if !is_dropped {
            words.push(shell_word(word));
            words.extend(value.map(|it| shell_word(it)));
        }
    }
    if let Some(scene) = scene.filter(|_| !given && place.is_some()) {
        words.push(shell_word(scene));
    }
    words.push("--csv -".to_owned());
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Arg;

    fn program() -> Command {
        let scene = || Arg::new("scene");
        let set = || Arg::new("set").long("set").action(ArgAction::Append);
        let csv = || Arg::new("csv").long("csv").action(ArgAction::Set);
        let seed = || Arg::new("seed").long("seed").action(ArgAction::Set);
        Command::new("cmra")
            .subcommand(Command::new("limit").args([scene(), set(), csv(), seed()]))
            .subcommand(Command::new("fit").args([Arg::new("shots"), scene(), set(), csv()]))
    }

    #[test]
    fn the_scene_beside_stands_for_the_scene_and_its_changes() {
        let line = |typed: &str, scene: Option<&str>| {
            let typed: Vec<String> = typed.split(' ').map(str::to_owned).collect();
            line(&program(), &typed, scene)
        };
        assert_eq!(
            line("limit thin --set h=1mm --seed 4 --csv a.csv --force", Some("./a.toml")),
            "cmra limit ./a.toml --seed 4 --csv -"
        );
        assert_eq!(
            line("limit --csv=a.csv --set=h=1mm", Some("./a b.toml")),
            "cmra limit './a b.toml' --csv -"
        );
        assert_eq!(
            line("fit shots.csv thin --set h=1mm --csv a.csv", Some("./a.toml")),
            "cmra fit shots.csv ./a.toml --csv -"
        );
        assert_eq!(
            line("limit thin --set h=1mm --csv a.csv", None),
            "cmra limit thin --set h=1mm --csv -"
        );
    }
}
