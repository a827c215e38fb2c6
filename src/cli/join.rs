//! `cmra join PART...`: the parts of a sweep as the one file that a single run would have written.

use std::path::PathBuf;

use clap::Args;

use crate::cli::{CliError, output};
use crate::files::atomic::Existing;
use crate::files::export::{Destination, Meta};
use crate::files::join::Whole;

#[derive(Debug, Args)]
#[command(
    after_help = "The parts may be named in any order. Each needs the .toml file beside it, which says what part it is.\n\
                  Missing, repeated and incomplete parts, parts of another sweep, and parts that were changed by a single byte, are errors.\n\
                  `cmra help sweeps` shows how parts are computed."
)]
pub(super) struct JoinArguments {
    /// Files written by `cmra sweep --shard I/N --csv FILE`
    #[arg(required = true, value_name = "PART")]
    parts: Vec<PathBuf>,
    /// Write the table to this file and its scene beside it; without it, or with `-`, to standard output
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Replace an existing file
    #[arg(long, requires = "csv")]
    force: bool,
}

pub(super) fn run(arguments: &JoinArguments) -> Result<(), CliError> {
    let existing = Existing::replaced(arguments.force);
    let path = arguments.csv.clone().filter(|path| path.as_os_str() != "-");
    let to = path.map(|path| Destination { path, existing, meta: Meta::Beside });
    let mut file = to.as_ref().map(Destination::begin).transpose()?;
    let whole = Whole::of(&arguments.parts)?;
    whole.each_piece(|piece| match &mut file {
        Some(file) => file.add(piece).map_err(CliError::File),
        None => output::print_bytes(piece),
    })?;
    let (Some(to), Some(file)) = (to, file) else {
        return output::print("");
    };
    let written = to.finish(file, &[whole.beside()])?;
    output::note(&format!("joined {} parts", whole.count()));
    output::note_written(&written);
    Ok(())
}
