//! Completing a path that is being typed.

use std::fs;
use std::path::{MAIN_SEPARATOR, Path};

/// Names given at most: more than a dialog can show.
const NAMES_MAX: usize = 100;

/// The paths that continue `text`, in order; directories end with a separator. Hidden ones only where the dot has been typed.
pub(super) fn paths(text: &str) -> Vec<String> {
    let split = text.rfind(MAIN_SEPARATOR).map_or(0, |at| at + 1);
    let (directory, start) = text.split_at(split);
    let place = if directory.is_empty() { "." } else { directory };
    let Ok(entries) = fs::read_dir(place) else {
        return Vec::new();
    };
    let mut names: Vec<String> = entries
        .filter_map(Result::ok)
        .filter_map(|entry| {
            let name = entry.file_name().into_string().ok()?;
            let wanted =
                name.starts_with(start) && (start.starts_with('.') || !name.starts_with('.'));
            wanted.then(|| format!("{directory}{name}"))
        })
        .collect();
    names.sort();
    names.truncate(NAMES_MAX);
    // Only of the few that are shown: in a folder of very many files this takes longest.
    for name in names.iter_mut().filter(|name| Path::new(name).is_dir()) {
        name.push(MAIN_SEPARATOR);
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_completed_by_its_prefix() {
        let place = tempfile::tempdir().unwrap();
        let at = |name: &str| format!("{}/{name}", place.path().display());
        for name in ["run-1.csv", "run-2.csv", "other.csv", ".hidden"] {
            fs::write(at(name), "").unwrap();
        }
        fs::create_dir(at("runs")).unwrap();
        assert_eq!(paths(&at("run")), [at("run-1.csv"), at("run-2.csv"), at("runs/")]);
        assert_eq!(paths(&at(".h")), [at(".hidden")]);
        assert_eq!(paths(&at("")).len(), 4);
        assert_eq!(paths(&at("nothing/here")), Vec::<String>::new());
    }
}
