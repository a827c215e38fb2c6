//! Where this program keeps its own files, by the conventions of the platform (XDG on Linux).

use std::path::{Path, PathBuf};

use directories::{BaseDirs, ProjectDirs};

use crate::files::error::FileError;

/// The program's own directories and files. None need exist; they are made when something is first written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Paths {
    /// The user's own presets.
    pub presets: PathBuf,
    /// Keys, colours and characters of the workbench.
    pub config: PathBuf,
    /// Session, log and reports of a crash.
    pub state: PathBuf,
}

/// Where `man` and the shells look for what this user has installed: `$XDG_DATA_HOME`, by default `~/.local/share`.
pub fn share_of_user() -> Result<PathBuf, FileError> {
    BaseDirs::new().map(|dirs| dirs.data_dir().to_owned()).ok_or(FileError::NoHome)
}

impl Paths {
    /// The paths of this user.
    pub fn of_user() -> Result<Self, FileError> {
        let dirs = ProjectDirs::from("", "", "cmra").ok_or(FileError::NoHome)?;
        Ok(Self {
            presets: dirs.data_dir().join("presets"),
            config: dirs.config_dir().join("config.toml"),
            // Only some platforms have a state directory of their own.
            state: dirs.state_dir().unwrap_or_else(|| dirs.data_local_dir()).to_owned(),
        })
    }

    /// Paths below one directory, for tests.
    pub fn below(directory: &Path) -> Self {
        Self {
            presets: directory.join("data/presets"),
            config: directory.join("config/config.toml"),
            state: directory.join("state"),
        }
    }

    /// The file of the last session.
    pub fn session_file(&self) -> PathBuf {
        self.state.join("session.toml")
    }

    /// The folder of the scenes that were left unsaved.
    pub fn recent_folder(&self) -> PathBuf {
        self.state.join("recent")
    }

    /// The user's own library of this name, beside the presets.
    pub fn library_file(&self, name: &str) -> PathBuf {
        self.presets.with_file_name("library").join(format!("{name}.toml"))
    }

    /// The file of an own preset.
    pub fn preset_file(&self, name: &str) -> PathBuf {
        self.presets.join(format!("{name}.toml"))
    }
}
