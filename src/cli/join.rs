//! `cmra join PART...`: the parts of a sweep as the one file that a single run would have written.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use crate::cli::table::exists;
use crate::cli::{CliError, output, sidecar};
use crate::files::atomic::{Existing, Growing};
use crate::files::export;
use crate::files::join::Whole;

#[derive(Debug, Args)]
#[command(
    after_help = "The parts may be named in any order. Each needs the .toml file beside it, which says what part it is.\n\
                  A missing part, a part that is named twice, a part of another sweep and a changed part are refused.\n\
                  `cmra help sweeps` shows how parts are computed."
)]
pub(super) struct JoinArguments {
    /// Files written by `cmra sweep --shard I/N --csv FILE`
    #[arg(required = true, value_name = "PART")]
    parts: Vec<PathBuf>,
    /// Write the table to this file and its scene beside it; without it, or with `-`, to standard output
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Replace what exists
    #[arg(long, requires = "csv")]
    force: bool,
}

/// Join.
pub(super) fn run(arguments: &JoinArguments) -> Result<ExitCode, CliError> {
    let existing = if arguments.force { Existing::Replace } else { Existing::Keep };
    let target = arguments.csv.as_deref().filter(|path| path.as_os_str() != "-");
    if let Some(path) = target {
        sidecar::check(path, existing).map_err(exists)?;
    }
    let mut file = target.map(|path| Growing::begin(path, existing)).transpose().map_err(exists)?;
    let whole = Whole::of(&arguments.parts)?;
    whole.each_piece(|piece| match &mut file {
        Some(file) => file.add(piece).map_err(CliError::File),
        None => output::print_bytes(piece),
    })?;
    let (Some(file), Some(path)) = (file, target) else {
        output::print("")?;
        return Ok(ExitCode::SUCCESS);
    };
    let (beside, text) = (export::sidecar_path(path, None), whole.sidecar(path));
    let has_place = sidecar::is_ordinary(path);
    let files = has_place.then(|| (beside.clone(), text.as_bytes()));
    file.finish(files.as_slice(), existing).map_err(exists)?;
    output::note(&format!("joined {} parts: wrote {}", whole.count(), path.display()));
    if has_place {
        output::note(&format!("wrote {}", beside.display()));
    }
    Ok(ExitCode::SUCCESS)
}
