//! Errors of the parser in one line: argument, allowed values, nearest name, and the help to read.

use std::error::Error as _;
use std::ffi::OsString;
use std::iter::once;

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
    let parts: Vec<String> = once(problem(error)).chain(values(error)).chain(tips(error)).collect();
    let problem = parts.join("; ");
    let command = own.map_or_else(|| "cmra".to_owned(), |name| format!("cmra {name}"));
    Some(format!("{problem}; see `{command} --help`"))
}

/// The text of a context; `None` without such a text.
fn text(error: &Error, kind: ContextKind) -> Option<&str> {
    match error.get(kind)? {
        ContextValue::String(text) => Some(text),
        _ => None,
    }
}

/// The texts of a context; none without such texts.
fn texts(error: &Error, kind: ContextKind) -> Vec<&str> {
    match error.get(kind) {
        Some(ContextValue::String(text)) => vec![text],
        Some(ContextValue::Strings(texts)) => texts.iter().map(String::as_str).collect(),
        _ => Vec::new(),
    }
}

/// Returns the description of a command-line error, by its kind.
fn problem(error: &Error) -> String {
    let (argument, value) =
        (text(error, ContextKind::InvalidArg), text(error, ContextKind::InvalidValue));
    let provided = |kind| match (error.get(kind), error.get(ContextKind::ActualNumValues)) {
        (Some(ContextValue::Number(wanted)), Some(ContextValue::Number(actual))) => Some((
            wanted,
            format!("{actual} {} provided", if *actual > 1 { "were" } else { "was" }),
        )),
        _ => None,
    };
    let found = match (error.kind(), argument, value) {
        (ErrorKind::InvalidValue, Some(argument), Some("")) => {
            Some(format!("a value is required for '{argument}' but none was supplied"))
        }
        (ErrorKind::InvalidValue | ErrorKind::ValueValidation, Some(argument), Some(value)) => {
            let why = error.source().map_or_else(String::new, |source| format!(": {source}"));
            Some(format!("invalid value '{value}' for '{argument}'{why}"))
        }
        (ErrorKind::TooManyValues, Some(argument), Some(value)) => Some(format!(
            "unexpected value '{value}' for '{argument}' found; no more were expected"
        )),
        (ErrorKind::TooFewValues, Some(argument), _) => provided(ContextKind::MinValues)
            .map(|(least, given)| format!("{least} values required by '{argument}'; only {given}")),
        (ErrorKind::WrongNumberOfValues, Some(argument), _) => {
            provided(ContextKind::ExpectedNumValues).map(|(number, given)| {
                format!("{number} values required for '{argument}' but {given}")
            })
        }
        (ErrorKind::UnknownArgument, Some(argument), _) => {
            Some(format!("unexpected argument '{argument}' found"))
        }
        (ErrorKind::NoEquals, Some(argument), _) => {
            Some(format!("equal sign is needed when assigning values to '{argument}'"))
        }
        (ErrorKind::ArgumentConflict, ..) => conflict(error),
        (ErrorKind::MissingRequiredArgument, ..) => {
            let missing = texts(error, ContextKind::InvalidArg).join("; ");
            Some(format!("the following required arguments were not provided: {missing}"))
        }
        (ErrorKind::InvalidSubcommand, ..) => text(error, ContextKind::InvalidSubcommand)
            .map(|word| format!("unrecognized subcommand '{word}'")),
        (ErrorKind::MissingSubcommand, ..) => text(error, ContextKind::InvalidSubcommand)
            .map(|word| format!("'{word}' requires a subcommand but one was not provided")),
        _ => None,
    };
    found.unwrap_or_else(|| error.kind().to_string())
}

fn conflict(error: &Error) -> Option<String> {
    let named = |kind, what: &'static str| text(error, kind).map(|name| (what, name));
    let (what, name) = named(ContextKind::InvalidArg, "argument")
        .or_else(|| named(ContextKind::InvalidSubcommand, "subcommand"))?;
    let others = match error.get(ContextKind::PriorArg) {
        Some(ContextValue::String(other)) if other == name => "multiple times".to_owned(),
        Some(ContextValue::String(other)) => format!("with '{other}'"),
        Some(ContextValue::Strings(others)) => format!("with: {}", others.join("; ")),
        _ => "with one or more of the other specified arguments".to_owned(),
    };
    Some(format!("the {what} '{name}' cannot be used {others}"))
}

/// The values or subcommands to choose from.
fn values(error: &Error) -> impl Iterator<Item = String> {
    let lists = [
        ("possible values", ContextKind::ValidValue),
        ("subcommands", ContextKind::ValidSubcommand),
    ];
    lists.into_iter().filter_map(|(name, kind)| {
        let all = texts(error, kind);
        (!all.is_empty()).then(|| format!("[{name}: {}]", all.join(", ")))
    })
}

/// Returns the suggestions for a mistyped command, argument or value.
fn tips(error: &Error) -> Vec<String> {
    let kinds = [
        ("subcommand", ContextKind::SuggestedSubcommand),
        ("argument", ContextKind::SuggestedArg),
        ("value", ContextKind::SuggestedValue),
    ];
    let similar = kinds.into_iter().filter_map(|(what, kind)| match &texts(error, kind)[..] {
        [] => None,
        [one] => Some(format!("tip: a similar {what} exists: '{one}'")),
        all => Some(format!("tip: some similar {what}s exist: '{}'", all.join("', '"))),
    });
    // A value that looks like an option is seldom what was meant.
    let argument = text(error, ContextKind::InvalidArg).unwrap_or_default();
    let as_value = format!("to pass '{argument}' as a value, use '-- {argument}'");
    let others = match error.get(ContextKind::Suggested) {
        Some(ContextValue::StyledStrs(all)) => all.iter().map(ToString::to_string).collect(),
        _ => Vec::new(),
    };
    let others = others.into_iter().filter(|text| *text != as_value);
    similar.chain(others.map(|text| format!("tip: {text}"))).collect()
}
