//! Errors of the command line in one line: what was written, what is allowed, the nearest name, and the cure.

use std::error::Error as _;
use std::ffi::OsString;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, Error};

use crate::files::clean;
use crate::files::error::did_you_mean;

/// The line of an error; `None` for help and version, which are results.
pub(super) fn line(error: &Error, program: &Command, written: &[OsString]) -> Option<String> {
    if !error.use_stderr() {
        return None;
    }
    let first = |kind| all(error, kind).into_iter().next();
    let argument = first(ContextKind::InvalidArg).unwrap_or_default();
    let commands: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
    let named = written.get(1).and_then(|word| word.to_str()).filter(|it| commands.contains(it));
    let command = command_of(error, named);
    // After a misspelt command the other arguments have no meaning.
    if command == "cmra"
        && let Some(word) = written.get(1).and_then(|word| word.to_str())
        && !commands.contains(&word)
        && let Some(hint) = did_you_mean(word, &commands)
    {
        return Some(format!("`{word}` is not a subcommand: {hint} `cmra --help` lists them"));
    }
    let problem = match error.kind() {
        ErrorKind::InvalidValue => value(error, &argument),
        ErrorKind::ValueValidation => {
            let value = first(ContextKind::InvalidValue).unwrap_or_default();
            let why = error.source().map(ToString::to_string).unwrap_or_default();
            let option = argument.split(" <").next().unwrap_or_default();
            format!("{option} {value}: {why}")
        }
        ErrorKind::UnknownArgument => return Some(unknown(error, program, &command)),
        ErrorKind::InvalidSubcommand => {
            let name = first(ContextKind::InvalidSubcommand).unwrap_or_default();
            let known = all(error, ContextKind::SuggestedSubcommand);
            let known: Vec<&str> = known.iter().map(String::as_str).collect();
            let hint = did_you_mean(&name, &known).unwrap_or_default();
            format!("`{name}` is not a subcommand of `{command}`: {hint}")
        }
        ErrorKind::MissingRequiredArgument => {
            let missing = all(error, ContextKind::InvalidArg);
            format!(
                "{} {} missing",
                missing.join(" and "),
                if missing.len() > 1 { "are" } else { "is" }
            )
        }
        ErrorKind::ArgumentConflict => match all(error, ContextKind::PriorArg).as_slice() {
            [] => format!("{argument} cannot be used here"),
            [same] if *same == argument => format!("{argument} is given twice: write it once"),
            others => {
                format!("{argument} cannot be used with {}: omit one", others.join(" or "))
            }
        },
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            let own =
                command.split_whitespace().skip(1).try_fold(program, Command::find_subcommand);
            let names = own.into_iter().flat_map(Command::get_subcommands).map(Command::get_name);
            format!("a subcommand is missing: use one of {}", names.collect::<Vec<_>>().join(", "))
        }
        // All others are explained by their first line.
        _ => {
            let text = error.to_string();
            let first = text.lines().next().unwrap_or_default();
            first.trim_start_matches("error: ").to_owned()
        }
    };
    Some(format!("{}; see `{command} --help`", problem.trim_end_matches([' ', ':', ';'])))
}

/// The texts of one kind in the context of an error.
fn all(error: &Error, kind: ContextKind) -> Vec<String> {
    match error.get(kind) {
        Some(ContextValue::String(text)) => vec![text.clone()],
        Some(ContextValue::Strings(texts)) => texts.clone(),
        _ => Vec::new(),
    }
}

/// The command that the error is about, such as `cmra run`; if the error does not name it, the command that was typed.
fn command_of(error: &Error, named: Option<&str>) -> String {
    let usage = match error.get(ContextKind::Usage) {
        Some(ContextValue::StyledStr(usage)) => usage.to_string(),
        _ => String::new(),
    };
    let words = usage.trim_start_matches("Usage: ").split_whitespace();
    let words = words.take_while(|word| word.starts_with(|c: char| c.is_ascii_lowercase()));
    let words: Vec<&str> = words.collect();
    if words.is_empty() {
        return named.map_or_else(|| "cmra".to_owned(), |name| format!("cmra {name}"));
    }
    words.join(" ")
}

/// Describes a value that is missing or not allowed.
fn value(error: &Error, argument: &str) -> String {
    let valid = all(error, ContextKind::ValidValue);
    let written = all(error, ContextKind::InvalidValue).concat();
    let list =
        if valid.is_empty() { String::new() } else { format!("use one of {}", valid.join(", ")) };
    if written.is_empty() {
        return format!("{argument} has no value: {list}");
    }
    let known: Vec<&str> = valid.iter().map(String::as_str).collect();
    let hint = did_you_mean(&written, &known).map_or_else(String::new, |hint| hint + " ");
    format!("`{written}` is not a value of {argument}: {hint}{list}")
}

/// Describes an unknown option, or an argument too many.
fn unknown(error: &Error, program: &Command, command: &str) -> String {
    let argument = all(error, ContextKind::InvalidArg).concat();
    let own = command.split_whitespace().skip(1).try_fold(program, Command::find_subcommand);
    let options: Vec<String> = own
        .into_iter()
        .flat_map(Command::get_arguments)
        .filter(|option| !option.is_hide_set())
        .filter_map(|option| Some(format!("--{}", option.get_long()?)))
        .collect();
    let options: Vec<&str> = options.iter().map(String::as_str).collect();
    let what = if argument.starts_with('-') { "an option of" } else { "understood by" };
    let hint = did_you_mean(&argument, &options).map_or_else(String::new, |hint| hint + " ");
    format!("`{}` is not {what} `{command}`: {hint}see `{command} --help`", clean::line(&argument))
}
