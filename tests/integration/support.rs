//! Helpers of several tests: paths, scenes from text, runs, and the program itself.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use assert_cmd::Command;
use cmra::files::error::FileError;
use cmra::files::preset;
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables;
pub(crate) use cmra_oracle::assert_near;
use serde_json::Value;

/// The default scene with some variables changed: `gamma=2 k=1e5`.
pub(crate) fn scene(pairs: &str) -> Scene {
    variables::changed(Scene::default(), pairs).unwrap()
}

/// A whole run of a scene.
pub(crate) fn run(scene: Scene) -> Run {
    simulate(&Arc::new(scene), &Settings::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// The program in a directory and an environment of its own: neither those of the tests nor a person's files count.
pub(crate) fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cmra"));
    command.current_dir(in_repository("")).env_clear();
    command.env("HOME", Path::new(env!("CARGO_TARGET_TMPDIR")).join("nobody"));
    command
}

/// A subcommand with arguments.
pub(crate) fn cmra(subcommand: &str, arguments: &[&str]) -> Command {
    let mut command = program();
    command.arg(subcommand).args(arguments);
    command
}

/// Runs a subcommand, checks its exit status, and returns standard output and standard error.
#[track_caller]
pub(crate) fn says(subcommand: &str, arguments: &[&str], code: i32) -> (String, String) {
    let output = cmra(subcommand, arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    let (out, error) = (text(output.stdout), text(output.stderr));
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {out}{error}");
    (out, error)
}

/// Returns the page of a subcommand that succeeds.
pub(crate) fn printed(subcommand: &str, arguments: &[&str]) -> String {
    says(subcommand, arguments, 0).0
}

/// Returns the JSON of a subcommand that succeeds.
pub(crate) fn json(subcommand: &str, arguments: &[&str]) -> Value {
    let text = printed(subcommand, &[&["--json"], arguments].concat());
    serde_json::from_str(&text).unwrap_or_else(|_| panic!("{arguments:?}: {text}"))
}

/// Returns a number of a JSON object.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

/// Result of the program: exit code, standard output, standard error.
pub(crate) struct Done {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

/// Runs the program in a folder, which is its home, with arguments split at blanks.
pub(crate) fn in_folder(place: &Path, arguments: &str) -> Done {
    let mut command = program();
    command.current_dir(place).env("HOME", place).args(arguments.split_whitespace());
    let output = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Done { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
}

/// The scene of a file.
pub(crate) fn scene_file(path: &Path) -> Result<Scene, FileError> {
    preset::from_file(path).map(|preset| preset.scene)
}

/// A path in the repository.
pub(crate) fn in_repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The files of a folder and of all folders in it with this ending, by name.
pub(crate) fn files_below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut folders = vec![folder.to_owned()];
    let mut found: Vec<PathBuf> = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == ending) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// The files of a folder with this ending, by name.
pub(crate) fn files_in(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|found| found == ending))
        .collect();
    files.sort();
    files
}
