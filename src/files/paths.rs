//! Folders of the program's own files, by the conventions of the platform (XDG on Linux).

use std::path::{Path, PathBuf};

use directories::{BaseDirs, ProjectDirs};

use crate::files::error::FileError;

/// Folders and files of the program; they are created at the first write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Paths {
    /// Folder of the user's presets.
    pub presets: PathBuf,
    /// Configuration file of the workbench.
    pub config: PathBuf,
    /// Folder of session, log and crash reports.
    pub state: PathBuf,
}

/// Returns the folder in which `man` and the shells search for the user's files: `$XDG_DATA_HOME`, by default `~/.local/share`.
pub fn share_of_user() -> Result<PathBuf, FileError> {
    BaseDirs::new().map(|dirs| dirs.data_dir().to_owned()).ok_or(FileError::NoHome)
}

impl Paths {
    /// Returns the paths of the user.
    pub fn of_user() -> Result<Self, FileError> {
        let dirs = ProjectDirs::from("", "", "cmra").ok_or(FileError::NoHome)?;
        Ok(Self {
            presets: dirs.data_dir().join("presets"),
            config: dirs.config_dir().join("config.toml"),
            // Some platforms have no state directory.
            state: dirs.state_dir().unwrap_or_else(|| dirs.data_local_dir()).to_owned(),
        })
    }

    /// Returns paths below one directory, for tests.
    pub fn below(directory: &Path) -> Self {
        Self {
            presets: directory.join("data/presets"),
            config: directory.join("config/config.toml"),
            state: directory.join("state"),
        }
    }

    /// Returns the path of the last session.
    pub fn session_file(&self) -> PathBuf {
        self.state.join("session.toml")
    }

    /// Returns the folder of unsaved sessions.
    pub fn recent_folder(&self) -> PathBuf {
        self.state.join("recent")
    }

    /// Returns the path of the user's library with a name.
    pub fn library_file(&self, name: &str) -> PathBuf {
        self.presets.with_file_name("library").join(format!("{name}.toml"))
    }

    /// Returns the path of a preset of the user.
    pub fn preset_file(&self, name: &str) -> PathBuf {
        self.presets.join(format!("{name}.toml"))
    }
}
