//! The scene a command works on: SCENE, then every `--set` in order.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::Path;

use clap::Args;

use crate::cli::CliError;
use crate::files::bundled;
use crate::files::paths::Paths;
use crate::files::preset::{self, Origin, Preset};
use crate::files::{read, read_table};
use crate::model::scene::{Scene, SpringKind};
use crate::model::units::Bare;
use crate::model::variables;

/// SCENE and `--set`.
#[derive(Debug, Args)]
pub(super) struct SceneArguments {
    /// A preset's name, the path of a TOML file, or `-` for standard input [default: thesis-baseline]
    scene: Option<OsString>,
    /// Change a variable; may be repeated, and is applied in order.
    #[arg(
        long,
        value_name = "NAME=VALUE",
        allow_hyphen_values = true,
        help = "Change a variable: NAME is a thesis symbol (gamma, v_i, k) or a full key (interface.grip), VALUE is SI \
                or has a unit (d=50mm); table=FILE takes a measured spring curve from CSV; may be repeated"
    )]
    set: Vec<String>,
}

impl SceneArguments {
    /// The scene with every change made.
    pub(super) fn load(&self) -> Result<Preset, CliError> {
        let mut preset = match self.scene.as_deref() {
            Some(name) if name == "-" => from_stdin()?,
            name => named(name.unwrap_or_else(|| OsStr::new(bundled::BASELINE)))?,
        };
        change(&mut preset.scene, &self.set)?;
        Ok(preset)
    }

    /// The first `--set` of a variable that is chosen by its key.
    pub(super) fn set_of(&self, is_chosen: impl Fn(&str) -> bool) -> Option<&str> {
        let variable = |argument: &str| variables::find(argument.split('=').next()?.trim()).ok();
        let mut set = self.set.iter().map(String::as_str);
        set.find(|argument| variable(argument).is_some_and(|found| is_chosen(found.key)))
    }
}

/// Make every change of `--set`, in order.
pub(super) fn change(scene: &mut Scene, set: &[String]) -> Result<(), CliError> {
    for argument in set {
        let (name, value) = argument
            .split_once('=')
            .ok_or_else(|| CliError::NotAnAssignment { argument: argument.clone() })?;
        if let Some(second) = is_curve(name.trim()) {
            take_curve(scene, second, value.trim())?;
            continue;
        }
        variables::set_by_name(scene, name, value, Bare::Si).map_err(|source| CliError::Set {
            argument: argument.clone(),
            source: Box::new(source),
        })?;
    }
    Ok(())
}

/// Whether a name means the measured curve of a spring, and whether of the second one.
fn is_curve(name: &str) -> Option<bool> {
    match name {
        "table" | "mechanism.spring.table" | "mechanism.spring.table.file" => Some(false),
        "table_2" | "mechanism.second.table" | "mechanism.second.table.file" => Some(true),
        _ => None,
    }
}

/// Take a spring's curve from a CSV file; a file makes its spring one of the kind `table`.
fn take_curve(scene: &mut Scene, second: bool, file: &str) -> Result<(), CliError> {
    let points = read_table::curve(Path::new(file))?;
    let mechanism = &mut scene.mechanism;
    let spring = if second { &mut mechanism.second } else { &mut mechanism.spring };
    spring.kind = SpringKind::Table;
    spring.table.points = points;
    Ok(())
}

/// A scene by name or path. Without a home directory there are just no own presets.
pub(super) fn named(name: &OsStr) -> Result<Preset, CliError> {
    Ok(match name.to_str() {
        Some(name) => preset::resolve(name, Paths::of_user().ok().as_ref())?,
        // Only a file can have such a name.
        None => preset::from_file(Path::new(name))?,
    })
}

fn from_stdin() -> Result<Preset, CliError> {
    let name = "standard input";
    let text = read::text_from(io::stdin().lock(), Path::new(name))?;
    Ok(preset::from_text(name.to_owned(), Origin::Text, text)?)
}
