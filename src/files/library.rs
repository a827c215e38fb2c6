//! Libraries of threats, materials and absorbers in TOML: bundled ones and the user's own.
//!
//! An entry has keys of a scene with the sources of their values. An invalid entry is reported; the others are loaded.

use std::io;
use std::path::{Path, PathBuf};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::files::clean;
use crate::files::error::{FileError, SceneErrors, nearest};
use crate::files::inputs;
use crate::files::paths::Paths;
use crate::files::read;
use crate::files::reader::{self, Reader};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::VARIABLES;
use cmra_studies::study::library::{Entry, Library, Status};

/// Keys of an entry besides those of a scene.
const KEYS: [&str; 5] = ["title", "status", "source", "note", "warning"];

/// Returns the text of a bundled library.
fn bundled(library: Library) -> &'static str {
    match library {
        Library::Threats => include_str!("../../presets/library/threats.toml"),
        Library::Materials => include_str!("../../presets/library/materials.toml"),
        Library::Absorbers => include_str!("../../presets/library/absorbers.toml"),
    }
}

/// Returns all valid entries, by library and bundled first, and the errors.
pub fn list(paths: Option<&Paths>) -> (Vec<Entry>, Vec<FileError>) {
    let each: (Vec<_>, Vec<_>) = Library::ALL.into_iter().map(|it| listed(it, paths)).unzip();
    (each.0.concat(), each.1.into_iter().flatten().collect())
}

/// Returns the valid entries of a library, and the errors.
fn listed(library: Library, paths: Option<&Paths>) -> (Vec<Entry>, Vec<FileError>) {
    let file = format!("presets/library/{}.toml", library.file());
    let (mut entries, wrong) = entries(library, bundled(library), (&file, None));
    let mut problems: Vec<FileError> = wrong.into_iter().map(FileError::Scene).collect();
    let Some(path) = paths.map(|paths| paths.library_file(library.file())) else {
        return (entries, problems);
    };
    match inputs::text_file(&path, read::BYTES_MAX) {
        Ok(text) => {
            let name = path.display().to_string();
            let (own, wrong) = self::entries(library, &text, (&name, Some(&path)));
            problems.extend(wrong.into_iter().map(FileError::Scene));
            for entry in own {
                if entries.iter().any(|other| other.name == entry.name) {
                    let problem = format!("a bundled {} has it; choose another", library.key());
                    problems.push(FileError::name(&entry.name, &problem));
                } else {
                    entries.push(entry);
                }
            }
        }
        // The user has no such library.
        Err(FileError::Read { source, .. }) if source.kind() == io::ErrorKind::NotFound => {}
        Err(problem) => problems.push(problem),
    }
    (entries, problems)
}

/// Returns the entry with a name.
pub fn find(library: Library, name: &str, paths: Option<&Paths>) -> Result<Entry, FileError> {
    let (mut entries, problems) = listed(library, paths);
    if let Some(at) = entries.iter().position(|entry| entry.name == name) {
        return Ok(entries.swap_remove(at));
    }
    let names: Vec<&str> = entries.iter().map(|entry| entry.name.as_str()).collect();
    let list = format!("`cmra libraries` lists the {}", library.file());
    let mut hint = format!("{} ({list})", nearest(name, &names, "use one of"));
    for problem in problems {
        hint = format!("{hint}; {}", problem.to_string().replace('\n', "; "));
    }
    let (name, word) = (clean::line(name), library.key());
    Err(FileError::Refused(format!("`{name}` is not one of the {word}s: {hint}")))
}

/// Reads the entries of a text; `file` is the name in error messages.
fn entries(
    library: Library,
    text: &str,
    (file, own): (&str, Option<&Path>),
) -> (Vec<Entry>, Vec<SceneErrors>) {
    let document = match DeTable::parse(text) {
        Ok(document) => document,
        Err(error) => {
            let mut reader = Reader::new(text, file);
            reader.problem(error.span().unwrap_or(0..0), reader::syntax(error.message()));
            return (Vec::new(), reader.finish().err().into_iter().collect());
        }
    };
    let (mut found, mut problems) = (Vec::new(), Vec::new());
    for (name, value) in document.get_ref() {
        let mut reader = Reader::new(text, file);
        let own = own.map(Path::to_owned);
        let read = entry(&mut reader, library, (name.get_ref().as_ref(), value), own);
        match (read, reader.finish()) {
            (Some(entry), Ok(())) => found.push(entry),
            (_, Err(problem)) => problems.push(problem),
            (None, Ok(())) => {}
        }
    }
    (found, problems)
}

/// Reads an entry; reports a problem and returns `None` if it is invalid.
fn entry(
    reader: &mut Reader<'_>,
    library: Library,
    (name, value): (&str, &Spanned<DeValue<'_>>),
    own: Option<PathBuf>,
) -> Option<Entry> {
    let (word, tables) = (library.key(), library.tables());
    let DeValue::Table(table) = value.get_ref() else {
        let text = format!("`{name}` is not a {word}: write [{name}] and its keys below it");
        reader.problem(value.span(), text);
        return None;
    };
    let mut texts = [const { String::new() }; KEYS.len()];
    let mut scene = Scene::default();
    let mut keys = Vec::new();
    for (key, value) in table {
        let key_name = key.get_ref().as_ref();
        if let Some(at) = KEYS.iter().position(|known| *known == key_name) {
            reader.text_value(key_name, value, &mut texts[at]);
        } else if tables.contains(&key_name) {
            reader.entry(&mut scene, key_name, key.span(), value);
            leaves(key_name, value, &mut keys);
        } else {
            let text = format!(
                "`{key_name}` is not a key of a {word}: it has {}, and keys of [{}]",
                KEYS.join(", "),
                tables.join("] or [")
            );
            reader.problem(key.span(), text);
        }
    }
    let [title, status, source, note, warning] = texts;
    for (key, text) in [("title", &title), ("status", &status), ("source", &source)] {
        if text.is_empty() {
            let text = format!("{word} `{name}` has no {key}: write {key} = \"...\"");
            reader.problem(value.span(), text);
        }
    }
    let known = Status::ALL.into_iter().find(|known| known.word() == status);
    if known.is_none() && !status.is_empty() {
        let text =
            format!("status = \"{status}\" of `{name}` must be measured, standard or typical");
        reader.problem(value.span(), text);
    }
    let variables = keys.iter().filter_map(|key| VARIABLES.iter().find(|row| row.key == *key));
    let values = variables.map(|variable| (variable.key, variable.value(&scene))).collect();
    let name = name.to_owned();
    Some(Entry { library, name, title, status: known?, source, note, warning, own, values })
}

/// Collects the full keys of the values below a table.
fn leaves(path: &str, value: &Spanned<DeValue<'_>>, keys: &mut Vec<String>) {
    match value.get_ref() {
        DeValue::Table(table) => {
            for (key, value) in table {
                leaves(&format!("{path}.{}", key.get_ref()), value, keys);
            }
        }
        _ => keys.push(path.to_owned()),
    }
}

#[cfg(test)]
mod tests {

    use super::*;
    use cmra_engine::model::run::Warning;
    use cmra_studies::study::library::warnings;

    #[test]
    fn bundled_entries_are_all_read_and_cite_a_source() {
        let (entries, problems) = list(None);
        assert!(problems.is_empty(), "{problems:?}");
        for library in Library::ALL {
            assert!(entries.iter().filter(|entry| entry.library == library).count() >= 6);
        }
        for entry in &entries {
            assert!(!entry.values.is_empty() && entry.source.len() > 10, "{}", entry.name);
            let mut scene = Scene::default();
            entry.apply(&mut scene).unwrap();
            cmra_engine::model::variables::validate(&scene).unwrap();
            assert!(scene.notes.contains(&entry.source), "{}", entry.name);
        }
    }

    #[test]
    fn a_threat_sets_the_shot_and_a_second_one_replaces_its_note() {
        let mut scene = Scene::default();
        find(Library::Threats, "m80-ball", None).unwrap().apply(&mut scene).unwrap();
        find(Library::Threats, "m855-ball", None).unwrap().apply(&mut scene).unwrap();
        let shot = scene.projectile;
        assert_eq!((shot.mass_kg, shot.velocity_m_s), (0.004, 950.0));
        assert_eq!(scene.notes.lines().count(), 2, "{}", scene.notes);
        let warnings: Vec<Warning> = warnings(&scene).collect();
        assert!(
            matches!(&warnings[..], [one] if one.value.contains("m855-ball: steel tip")),
            "{warnings:?}"
        );
        // What has no warning leaves none.
        find(Library::Threats, "m2-ap", None).unwrap().apply(&mut scene).unwrap();
        assert_eq!(scene.notes.lines().count(), 1, "{}", scene.notes);
    }

    #[test]
    fn coils_store_the_energy_of_the_formula() {
        for (name, tau, rho, g) in [
            ("steel-coil-700", 700e6_f64, 7850.0, 79.3e9),
            ("steel-coil-1200", 1200e6, 7850.0, 79.3e9),
            ("titanium-coil-800", 800e6, 4820.0, 41e9),
        ] {
            let mut scene = Scene::default();
            find(Library::Absorbers, name, None).unwrap().apply(&mut scene).unwrap();
            let energy = scene.mechanism.specific_energy_j_kg().unwrap();
            assert!(
                (energy / (tau * tau / (4.0 * rho * g)) - 1.0).abs() < 2e-4,
                "{name}: {energy}"
            );
        }
        // Without an entry: the wire of the scene, decisions of the project: 196.8 J/kg.
        let own = Scene::default().mechanism.specific_energy_j_kg().unwrap();
        assert!((own - 196.8).abs() < 0.05, "{own}");
    }
}
