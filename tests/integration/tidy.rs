//! The rules of the source that a compiler does not check: who may import whom, what a layer must not know, how a file begins and
//! how long it may be.

use std::fs;
use std::path::Path;

use crate::support::{files_below, in_repository};

/// The layers of each package from the lowest to the highest: a file may name its own and those before it. Which package may name which
/// the compiler checks.
const LAYERS: [&[&str]; 3] =
    [&["numerics", "model"], &["study", "report"], &["files", "worker", "tui", "cli"]];

/// The layers within the workbench, in the same order; those in one row may name each other. What a page keeps is a part of the state,
/// which knows no page.
const WORKBENCH: [&[&str]; 10] = [
    &["theme"],
    &["chart"],
    &["option", "keymap"],
    &["widgets"],
    &["plain"],
    &["preset"],
    &["app", "message", "state"],
    &["pages"],
    &["dialogs"],
    &[
        "complete",
        "effects",
        "input",
        "backlog",
        "frame_scheduler",
        "event_loop",
        "signals",
        "start",
        "terminal",
        "update",
        "view",
    ],
];

/// The folders of `src` that are packages of their own.
const PACKAGES: [&str; 2] = ["engine", "studies"];

/// Words that must not appear in the code of a layer.
const MUST_NOT_KNOW: &[(&str, &[&str])] = &[
    ("numerics", &["std::fs", "std::time", "std::thread", "plate", "projectile"]),
    ("model", &["std::fs", "std::time", "std::thread", "std::io"]),
    ("files", &["std::thread", "ratatui", "crossterm", "stdout()", "stderr()"]),
    ("worker", &["ratatui", "crossterm"]),
    ("tui/app", &["ratatui::buffer", "ratatui::Frame", "std::fs", ".exists()", "Instant::now"]),
    ("tui/update", &["ratatui::buffer", "ratatui::Frame", "std::fs", ".exists()", "Instant::now"]),
    ("tui/pages", &["std::fs", ".exists()", "Instant::now"]),
    ("tui/dialogs", &["std::fs", ".exists()", "Instant::now"]),
    ("tui/chart", &["cmra_engine::model", "crate::files", "crate::worker"]),
];

const LINES_MAX: usize = 500;

const FIELDS_MAX: usize = 20;

struct Source {
    /// Path below `src/` or the folder of its package, with `/`.
    name: String,
    text: String,
}

impl Source {
    /// Everything before the tests.
    fn code(&self) -> &str {
        let end = self.text.find("#[cfg(test)]\nmod tests");
        &self.text[..end.unwrap_or(self.text.len())]
    }

    /// Lines of code with their numbers, without comments.
    fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        self.text
            .lines()
            .enumerate()
            .map(|(index, line)| (index + 1, line.split("//").next().unwrap_or("")))
    }

    /// The layers of its package and its own place among them; none for `main.rs` and `lib.rs`.
    fn layer(&self) -> Option<(&'static [&'static str], usize)> {
        let top = self.name.split(['/', '.']).next()?;
        LAYERS.iter().find_map(|layers| Some((*layers, layers.iter().position(|it| *it == top)?)))
    }
}

fn sources() -> Vec<Source> {
    let root = in_repository("src");
    let name = |path: &Path| {
        let parts = path.strip_prefix(&root).unwrap().iter();
        let parts = parts.map(|part| part.to_str().unwrap());
        parts.filter(|part| !PACKAGES.contains(part)).collect::<Vec<_>>().join("/")
    };
    files_below(&root, "rs")
        .iter()
        .map(|path| Source { name: name(path), text: fs::read_to_string(path).unwrap() })
        .collect()
}

fn assert_none(complaints: &[String]) {
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// The modules named directly after `crate::` in a line, `crate::{a, b}` included.
fn named_modules(line: &str) -> Vec<&str> {
    let mut names = Vec::new();
    for after in line.split("crate::").skip(1) {
        let group = after.strip_prefix('{').map(|rest| rest.split('}').next().unwrap_or(rest));
        let list = group.unwrap_or(after);
        for item in list.split(',') {
            let end = item.trim_start().find(|c: char| !(c.is_alphanumeric() || c == '_'));
            let item = item.trim_start();
            names.push(&item[..end.unwrap_or(item.len())]);
            if group.is_none() {
                break;
            }
        }
    }
    names
}

#[test]
fn arrows_point_one_way() {
    let mut complaints = Vec::new();
    for source in sources() {
        let Some((layers, own)) = source.layer() else { continue };
        for (number, line) in source.lines() {
            for name in named_modules(line) {
                let Some(other) = layers.iter().position(|layer| *layer == name) else {
                    complaints.push(format!("{}:{number}: crate::{name} is no layer", source.name));
                    continue;
                };
                if other > own {
                    complaints.push(format!(
                        "{}:{number}: {} must not know {name}",
                        source.name, layers[own]
                    ));
                }
            }
        }
    }
    assert_none(&complaints);
}

/// Where a path below the workbench stands among its layers, and the part of it that it belongs to.
fn layer_in_workbench(path: &str) -> (&str, Option<usize>) {
    let mut names = path.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    let part = match names.next().unwrap_or_default() {
        // What all above the widgets import.
        "prelude" => "app",
        "pages" if path.contains("draw") => "pages",
        "pages" if names.any(|name| ["state", "states", "editor"].contains(&name)) => "state",
        part => part,
    };
    (part, WORKBENCH.iter().position(|parts| parts.contains(&part)))
}

#[test]
fn arrows_of_the_workbench_point_one_way() {
    let mut complaints = Vec::new();
    for source in sources() {
        let Some(path) = source.name.strip_prefix("tui/") else { continue };
        let (part, Some(own)) = layer_in_workbench(path) else {
            complaints.push(format!("{}: in no layer", source.name));
            continue;
        };
        for (number, line) in source.lines().take(source.code().lines().count()) {
            let Some((_, after)) = line.split_once("crate::tui::") else { continue };
            let (name, other) = layer_in_workbench(after.split(['{', ';']).next().unwrap());
            if other.is_some_and(|other| other > own) {
                complaints.push(format!("{}:{number}: {part} must not know {name}", source.name));
            }
        }
    }
    assert_none(&complaints);
}

#[test]
fn named_modules_are_found() {
    assert_eq!(named_modules("use crate::model::run::Run;"), ["model"]);
    assert_eq!(named_modules("use crate::{tui, cli::run};"), ["tui", "cli"]);
    assert_eq!(named_modules("f(crate::a::B, crate::c)"), ["a", "c"]);
    assert!(named_modules("use super::x;").is_empty());
}

#[test]
fn imports_point_one_way() {
    let mut complaints = Vec::new();
    for source in sources() {
        let code_lines = source.code().lines().count();
        for (part, words) in MUST_NOT_KNOW {
            let is_part =
                source.name == format!("{part}.rs") || source.name.starts_with(&format!("{part}/"));
            if !is_part {
                continue;
            }
            for (number, line) in source.lines().take(code_lines) {
                for word in *words {
                    if line.contains(word) {
                        complaints.push(format!("{}:{number}: knows {word}", source.name));
                    }
                }
            }
        }
    }
    assert_none(&complaints);
}

#[test]
fn every_file_has_a_head_and_a_bounded_length() {
    let mut complaints = Vec::new();
    for source in sources() {
        if !source.text.starts_with("//! ") {
            complaints.push(format!("{}: does not open with `//!`", source.name));
        }
        let lines = source.code().lines().count();
        if lines > LINES_MAX {
            complaints.push(format!("{}: {lines} lines before its tests", source.name));
        }
        if source.name.ends_with("mod.rs") {
            complaints.push(format!("{}: write a parent file instead", source.name));
        }
        for (number, line) in source.lines() {
            if line.trim_start().starts_with("pub use") && line.contains("::*") {
                complaints.push(format!("{}:{number}: pub use of everything", source.name));
            }
        }
    }
    assert_none(&complaints);
}

/// Names and numbers of fields of the structs with named fields in a text formatted by rustfmt.
fn structs(text: &str) -> Vec<(&str, usize)> {
    let mut found: Vec<(&str, usize)> = Vec::new();
    // Indentation of the struct that is open.
    let mut open: Option<usize> = None;
    for line in text.lines() {
        let indent = line.len() - line.trim_start().len();
        let item = without_visibility(line.trim_start());
        match open {
            None => {
                let Some(after) = item.strip_prefix("struct ") else { continue };
                let end = after.find(|c: char| !(c.is_alphanumeric() || c == '_'));
                // A unit or tuple struct ends in the line; a `where` clause may stand before the brace.
                if !line.trim_end().ends_with([';', '}']) {
                    open = Some(indent);
                    found.push((&after[..end.unwrap_or(after.len())], 0));
                }
            }
            Some(of) if indent == of && item.starts_with(['}', ')']) => open = None,
            Some(of) if indent == of + 4 => {
                let name = item.split(':').next().unwrap_or_default();
                let is_name = name.chars().all(|c| c.is_alphanumeric() || c == '_');
                if let Some(last) = found.last_mut().filter(|_| is_name && item.contains(": ")) {
                    last.1 += 1;
                }
            }
            Some(_) => {}
        }
    }
    found
}

fn without_visibility(item: &str) -> &str {
    let Some(after) = item.strip_prefix("pub") else { return item };
    let after = if after.starts_with('(') { after.split_once(')').unwrap().1 } else { after };
    after.trim_start()
}

#[test]
fn the_fields_of_a_struct_are_counted() {
    let text = "struct Unit;\npub(super) struct Two<'a> {\n    /// A length: m.\n    pub(crate) a_m: f64,\n    \
                pub b: Vec<\n        (&'a str, u8),\n    >,\n}\nstruct One(u8);\nmod inner {\n    struct Own {\n        \
                #[serde(default)]\n        c: u8,\n    }\n}\nfn f(x: u8) {\n    let y: u8 = x;\n}\n";
    assert_eq!(structs(text), [("Two", 2), ("Own", 1)]);
}

#[test]
fn no_struct_has_more_fields_than_a_reader_can_hold() {
    let mut complaints = Vec::new();
    let mut counted = 0;
    for folder in ["src", "tests", "benches"] {
        for path in files_below(&in_repository(folder), "rs") {
            let text = fs::read_to_string(&path).unwrap();
            for (name, fields) in structs(&text) {
                counted += 1;
                if fields > FIELDS_MAX {
                    complaints.push(format!("{}: {name} has {fields} fields", path.display()));
                }
            }
        }
    }
    assert!(counted > 100, "{counted}");
    assert_none(&complaints);
}

/// Finds a key in a page's text that should be an action in brackets, such as `<run>`.
fn key_in(text: &str) -> Option<&str> {
    const NAMED: [&str; 8] = ["Tab", "Enter", "Esc", "Space", "PgUp", "PgDn", "Home", "End"];
    const VERBS: [&str; 8] =
        ["adds", "hides", "opens", "puts", "runs", "shows", "toggles", "turns"];
    const PAIRS: [&str; 6] = ["hl", "jk", "HL", "nN", "h/l", "j/k"];
    let is_letter = |word: &str| word.len() == 1 && word.starts_with(|c: char| c.is_alphabetic());
    let words: Vec<&str> = text.split_whitespace().collect();
    let plain = |at: usize| words[at].trim_matches(|c: char| c.is_ascii_punctuation());
    let is_key = |at: usize| {
        let word = words[at];
        // `key c`, `w puts ...`, `Y: log`, `(w: the next one)`
        let called = at > 0 && ["key", "press"].contains(&plain(at - 1));
        let acts = words.get(at + 1).is_some_and(|next| VERBS.contains(next));
        let explained = word.ends_with(':') && (at == 0 || word.starts_with('('));
        // `H L`
        let pair = if at == 0 { String::new() } else { plain(at - 1).to_owned() } + plain(at);
        let is_named = NAMED.contains(&plain(at)) || PAIRS.contains(&plain(at));
        let is_pair = is_letter(plain(at)) && PAIRS.contains(&&*pair);
        is_named || is_pair || is_letter(plain(at)) && (called || acts || explained)
    };
    (0..words.len()).find(|at| is_key(*at)).map(|at| words[at])
}

#[test]
fn texts_of_pages_name_actions_not_their_keys() {
    let caught = [
        "n N",
        "Y: log",
        "by h/l",
        "(j, k)",
        "(key c: all)",
        "no axis: w puts one",
        "none; Tab, then Of:",
    ];
    assert!(caught.iter().all(|text| key_in(text).is_some()));
    let mut complaints = Vec::new();
    for source in sources() {
        if !["tui/app", "tui/pages"].iter().any(|part| source.name.starts_with(part)) {
            continue;
        }
        for (number, line) in source.lines().take(source.code().lines().count()) {
            for key in line.split('"').skip(1).step_by(2).filter_map(key_in) {
                complaints.push(format!("{}:{number}: the key `{key}`", source.name));
            }
        }
    }
    assert_none(&complaints);
}
