//! Presets, bundled and the user's own, by name; scenes by name or path.
//!
//! A user's preset cannot have the name of a bundled one: a name always means the same scene. A user's preset is a scene file; replacing it
//! keeps its comments and its layout.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::files::atomic::{self, OverwritePolicy};
use crate::files::bundled::{self, BUNDLED, Bundled};
use crate::files::clean;
use crate::files::error::{FileError, did_you_mean};
use crate::files::inputs;
use crate::files::paths::Paths;
use crate::files::read;
use crate::files::session;
use crate::files::write;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables;

/// Scene with its name and origin.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset {
    /// Name or path of the scene.
    pub name: String,
    /// Heading of pages: the name of the preset, with the changes to it.
    pub heading: String,
    /// Origin.
    pub origin: Origin,
    /// Scene.
    pub scene: Scene,
    /// Comment at the top of the file, without `#`: source and expected results.
    pub comment: String,
    /// Text of the file.
    pub text: String,
}

/// Origin of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Bundled preset.
    Bundled,
    /// Preset of the user, in this file.
    Mine(PathBuf),
    /// Scene file, by its path.
    File(PathBuf),
    /// Text, such as standard input.
    Text,
}

impl Origin {
    /// Returns the label in lists.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Bundled => "bundled",
            Self::Mine(_) => "mine",
            Self::File(_) => "file",
            Self::Text => "text",
        }
    }
}

/// Returns all readable presets, bundled first, then the user's own by name; and the names of unreadable ones with their errors.
pub fn list(paths: Option<&Paths>) -> (Vec<Preset>, Vec<(String, FileError)>) {
    let bundled = BUNDLED.iter().map(|preset| (preset.0.to_owned(), from_bundled(*preset)));
    let own = paths.map(own_presets).unwrap_or_default().into_iter().map(|(name, path)| {
        let preset = path.and_then(|path| from_own(name.clone(), path));
        (name, preset)
    });
    let (mut presets, mut unreadable) = (Vec::new(), Vec::new());
    for (name, preset) in bundled.chain(own) {
        match preset {
            Ok(preset) => presets.push(preset),
            Err(error) => unreadable.push((name, error)),
        }
    }
    (presets, unreadable)
}

/// Loads the scene `name`: a bundled preset, a preset of the user, or the path of a TOML file.
pub fn resolve(name: &str, paths: Option<&Paths>) -> Result<Preset, FileError> {
    if let Some(preset) = bundled::find(name) {
        return from_bundled(preset);
    }
    if let Some(paths) = paths
        && check_name(name).is_ok()
    {
        let path = paths.preset_file(name);
        // A path that is not a file has its own error message.
        if fs::symlink_metadata(&path).is_ok() {
            return from_own(name.to_owned(), path);
        }
    }
    let path = Path::new(name);
    match fs::metadata(path) {
        Ok(_) => from_file(path),
        // The path exists but cannot be read: a loop of links, a folder without permission.
        Err(source)
            if fs::symlink_metadata(path).is_ok() || source.kind() != io::ErrorKind::NotFound =>
        {
            Err(FileError::read(path, source))
        }
        Err(_) => Err(FileError::UnknownScene { name: name.to_owned(), hint: hint(name, paths) }),
    }
}

/// Loads a scene from a file, or from a saved session.
pub fn from_file(path: &Path) -> Result<Preset, FileError> {
    let text = inputs::text_file(path, read::BYTES_MAX)?;
    let text = session::scene_in(&text).unwrap_or(text);
    from_text(path.display().to_string(), Origin::File(path.to_owned()), text)
}

/// Loads a scene from a text; `name` appears in error messages.
pub fn from_text(name: String, origin: Origin, text: String) -> Result<Preset, FileError> {
    let file = match &origin {
        Origin::Bundled => format!("presets/{name}.toml"),
        Origin::Mine(path) | Origin::File(path) => path.display().to_string(),
        Origin::Text => name.clone(),
    };
    Ok(Preset {
        scene: read::scene(&text, &file).map_err(FileError::Scene)?,
        comment: head_comment(&text),
        heading: name.clone(),
        name,
        origin,
        text,
    })
}

/// Loads the baseline.
pub fn baseline() -> Result<Preset, FileError> {
    resolve(bundled::BASELINE, None)
}

/// Saves a scene as a preset of the user and returns the path. A replaced file keeps its comments, order and formatting.
///
/// # Errors
/// [`FileError`]; an existing file is unchanged then.
pub fn save(
    paths: &Paths,
    name: &str,
    scene: &Scene,
    existing: OverwritePolicy,
) -> Result<PathBuf, FileError> {
    check_name(name)?;
    let path = paths.preset_file(name);
    save_file(&path, scene, existing)?;
    Ok(path)
}

/// Returns `true` if a name is a path: it has a folder or the extension `toml`.
pub fn is_path(name: &str) -> bool {
    name.contains('/') || Path::new(name).extension().is_some_and(|end| end == "toml")
}

/// Saves a scene in a file, as [`save`] does. An existing file keeps its title; the title of a new file is its name.
///
/// # Errors
/// [`FileError`]; an existing file is unchanged then.
pub fn save_file(path: &Path, scene: &Scene, existing: OverwritePolicy) -> Result<(), FileError> {
    variables::validate(scene).map_err(|error| FileError::target(path, &error.to_string()))?;
    let file = path.display().to_string();
    let titled = |title| Scene { title, ..scene.clone() };
    let text = match read::text_file(path, read::BYTES_MAX) {
        Ok(_) if existing == OverwritePolicy::Keep => {
            return Err(FileError::Exists(path.to_owned()));
        }
        Ok(old) => read::scene(&old, &file)
            .and_then(|kept| write::updated(&old, &file, &titled(kept.title)))
            .map_err(|problem| FileError::Unmendable { path: path.to_owned(), problem })?,
        Err(FileError::Read { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
            let title = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            write::fresh(&titled(title))
        }
        Err(problem) => return Err(problem),
    };
    atomic::make_folder_of(path)?;
    atomic::write(path, text.as_bytes(), existing)
}

/// Checks the name of a preset of the user.
pub fn check_name(name: &str) -> Result<(), FileError> {
    const LENGTH_MAX: usize = 64;
    let refuse = |problem: &str| Err(FileError::name(name, problem));
    if bundled::find(name).is_some() {
        return refuse("a bundled preset has it; choose another");
    }
    if name.is_empty() || name.chars().count() > LENGTH_MAX {
        return refuse(&format!("it must have 1 to {LENGTH_MAX} characters"));
    }
    if name.starts_with(['.', '-', ' ']) || name.ends_with(' ') {
        return refuse("it must begin with a letter or a digit");
    }
    let allowed = |c: char| c.is_alphanumeric() || "-_.+=, ".contains(c);
    if let Some(bad) = name.chars().find(|c| !allowed(*c)) {
        return refuse(&format!(
            "{bad:?} is not allowed; use letters, digits, spaces and - _ . + = ,"
        ));
    }
    Ok(())
}

fn from_bundled((name, text): Bundled) -> Result<Preset, FileError> {
    from_text(name.to_owned(), Origin::Bundled, text.to_owned())
}

fn from_own(name: String, path: PathBuf) -> Result<Preset, FileError> {
    let text = inputs::text_file(&path, read::BYTES_MAX)?;
    from_text(name, Origin::Mine(path), text)
}

/// Returns names and paths of the user's presets, sorted by name; for unreadable ones the error.
fn own_presets(paths: &Paths) -> Vec<(String, Result<PathBuf, FileError>)> {
    let entries = match fs::read_dir(&paths.presets) {
        Ok(entries) => entries,
        // There is no preset yet.
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Vec::new(),
        Err(error) => {
            let problem = FileError::read(&paths.presets, error);
            return vec![(paths.presets.display().to_string(), Err(problem))];
        }
    };
    let files = entries
        .filter_map(Result::ok)
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|end| end == "toml"));
    let named = files.map(|path| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let path = check_name(&name).map(|()| path);
        (name, path)
    });
    let mut own: Vec<_> = named.collect();
    own.sort_by(|a, b| a.0.cmp(&b.0));
    own
}

/// Returns the hint for an unknown name.
fn hint(name: &str, paths: Option<&Paths>) -> String {
    let own = paths.map(own_presets).unwrap_or_default();
    let bundled = BUNDLED.iter().map(|preset| preset.0);
    let names: Vec<&str> = bundled.chain(own.iter().map(|(name, _)| name.as_str())).collect();
    let list = "`cmra presets` lists the presets";
    if name.is_empty() {
        return format!("the name is empty; {list}");
    }
    // `run gamma=2`
    if let Some((variable, _)) = name.split_once('=')
        && variables::find(variable.trim()).is_ok()
    {
        return format!(
            "to change a variable of the scene write `--set {}`",
            clean::shell_word(name)
        );
    }
    match did_you_mean(name.trim_end_matches(".toml"), &names) {
        Some(hint) => format!("{hint} ({list})"),
        None if is_path(name) => format!("no such file; check the path ({list})"),
        None => format!("{list}; a file is named by its path, for example ./{name}.toml"),
    }
}

/// Returns the comment lines at the start of a text, without `#`.
fn head_comment(text: &str) -> String {
    let lines: Vec<&str> = text
        .lines()
        .map_while(|line| line.strip_prefix('#'))
        .map(|line| line.strip_prefix(' ').unwrap_or(line).trim_end())
        .collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_would_mislead_are_refused() {
        for (name, fragment) in [
            ("cocked", "bundled"),
            ("", "1 to 64"),
            (".hidden", "begin with"),
            ("../up", "begin with"),
            ("a/b", "not allowed"),
            ("tab\there", "not allowed"),
        ] {
            let error = check_name(name).unwrap_err().to_string();
            assert!(error.contains(fragment), "{error}");
        }
    }

    #[test]
    fn a_broken_own_preset_is_reported_and_never_overwritten() {
        let place = tempfile::tempdir().unwrap();
        let paths = Paths::below(place.path());
        fs::create_dir_all(&paths.presets).unwrap();
        let path = paths.preset_file("hurt");
        fs::write(&path, "format = 1\n[plate]\nmass_ration = 2\n").unwrap();
        let problem = list(Some(&paths)).1[0].1.to_string();
        assert!(problem.contains("hurt.toml:3:1"), "{problem}");
        let error = save(&paths, "hurt", &Scene::default(), OverwritePolicy::Replace).unwrap_err();
        assert!(error.to_string().contains("was not replaced"), "{error}");
        assert!(fs::read_to_string(&path).unwrap().contains("mass_ration"));
    }
}
