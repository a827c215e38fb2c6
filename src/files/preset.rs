//! Presets: the bundled ones and the user's own, found by name; and scenes found by name or path.
//!
//! Bundled names cannot be taken by own presets, so a name always means the same scene. Own presets are plain scene
//! files; saving over one keeps its comments and its layout.

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

/// A scene with its name and where it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset {
    /// Name or path to load it by.
    pub name: String,
    /// Heading of the pages: the preset's name, or how the scene was made from it.
    pub heading: String,
    /// Where it comes from.
    pub origin: Origin,
    /// The scene.
    pub scene: Scene,
    /// The comment block at the head of its file, without the `#`: source and what to expect.
    pub comment: String,
    /// The whole text of its file.
    pub text: String,
}

/// Where a scene comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Compiled in.
    Bundled,
    /// The user's own preset, in this file.
    Mine(PathBuf),
    /// A scene file named by its path.
    File(PathBuf),
    /// Text handed in, such as standard input.
    Text,
}

impl Origin {
    /// The word for lists.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Bundled => "bundled",
            Self::Mine(_) => "mine",
            Self::File(_) => "file",
            Self::Text => "text",
        }
    }
}

/// The presets that can be read, bundled first, then the user's own by name; and the names of those that cannot, with the reason.
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

/// The scene meant by `name`: a bundled preset, an own one, or the path of a TOML file.
pub fn resolve(name: &str, paths: Option<&Paths>) -> Result<Preset, FileError> {
    if let Some(preset) = bundled::find(name) {
        return from_bundled(preset);
    }
    if let Some(paths) = paths
        && check_name(name).is_ok()
    {
        let path = paths.preset_file(name);
        // What is no file is refused in its own words.
        if fs::symlink_metadata(&path).is_ok() {
            return from_own(name.to_owned(), path);
        }
    }
    let path = Path::new(name);
    match fs::metadata(path) {
        Ok(_) => from_file(path),
        // It is there, but something is in the way: a loop of links, a folder that may not be entered.
        Err(source)
            if fs::symlink_metadata(path).is_ok() || source.kind() != io::ErrorKind::NotFound =>
        {
            Err(FileError::read(path, source))
        }
        Err(_) => Err(FileError::UnknownScene { name: name.to_owned(), hint: hint(name, paths) }),
    }
}

/// A scene in a file, or that of a session that was kept.
pub fn from_file(path: &Path) -> Result<Preset, FileError> {
    inputs::note(path)?;
    let text = read::text_file(path, read::BYTES_MAX)?;
    let text = session::scene_in(&text).unwrap_or(text);
    from_text(path.display().to_string(), Origin::File(path.to_owned()), text)
}

/// A scene in a text; `name` is used in errors.
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

/// The scene everything starts from.
pub fn baseline() -> Result<Preset, FileError> {
    resolve(bundled::BASELINE, None)
}

/// Save a scene as an own preset and give the path of its file. An existing file is replaced only where that is allowed, and
/// keeps its comments, its order and its formatting.
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

/// Whether a scene of this name is a file: it has a folder or the ending of one.
pub fn is_path(name: &str) -> bool {
    name.contains('/') || Path::new(name).extension().is_some_and(|end| end == "toml")
}

/// Save a scene in a file, as [`save`] does. A file keeps its title; a new one has its own name as title, not that of the scene
/// it is a copy of.
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

/// Whether an own preset may have this name.
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
    inputs::note(&path)?;
    let text = read::text_file(&path, read::BYTES_MAX)?;
    from_text(name, Origin::Mine(path), text)
}

/// Names and files of the user's own presets, by name; of those that cannot be read, the reason.
fn own_presets(paths: &Paths) -> Vec<(String, Result<PathBuf, FileError>)> {
    let entries = match fs::read_dir(&paths.presets) {
        Ok(entries) => entries,
        // No preset has been saved yet.
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

/// The likely meaning of `name`.
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

/// The comment lines a text begins with, without their `#`.
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
