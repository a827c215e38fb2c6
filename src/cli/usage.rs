//! Errors of the parser in one line: argument, allowed values, nearest name, and the help to read.

use std::ffi::OsString;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, Error};

use crate::files::clean;
use crate::files::error::did_you_mean;
use cmra_engine::model::variables;

/// Returns the line of an error; `None` for help and version, which are results.
pub(super) fn line(error: &Error, program: &Command, written: &[OsString]) -> Option<String> {
    if !error.use_stderr() {
        return None;
    }
    let first = written.get(1).and_then(|word| word.to_str()).unwrap_or_default();
    let own = program.find_subcommand(first).map(Command::get_name);
    let commands: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
    // The other arguments have no meaning after a misspelt command.
    if own.is_none()
        && let Some(hint) = did_you_mean(first, &commands)
    {
        return Some(format!("`{first}` is not a subcommand: {hint} `cmra --help` lists them"));
    }
    // `run cocked gamma=2`
    if error.kind() == ErrorKind::UnknownArgument
        && let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidArg)
        && let Some((name, _)) = word.split_once('=')
        && variables::find(name).is_ok()
    {
        let word = clean::shell_word(word);
        return Some(format!(
            "unexpected argument '{word}': to change a variable write `--set {word}`"
        ));
    }
    // Line ends within an argument are not those of the message.
    let words = written.iter().filter_map(|word| word.to_str());
    let broken = words.filter(|word| word.contains(char::is_control));
    let text = broken.fold(error.to_string(), |it, word| it.replace(word, &clean::line(word)));
    // The hint to escape a value that looks like an option is rarely useful.
    let parts = text.lines().map(str::trim).filter(|it| !it.is_empty() && !it.contains("'-- -"));
    let is_problem = |part: &&str| !part.starts_with("Usage:") && !part.starts_with("For more ");
    let problem = parts.take_while(is_problem).collect::<Vec<_>>().join("; ");
    let problem = problem.trim_start_matches("error: ").replace(":; ", ": ");
    let command = own.map_or_else(|| "cmra".to_owned(), |name| format!("cmra {name}"));
    Some(format!("{problem}; see `{command} --help`"))
}
