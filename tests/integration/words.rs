//! Texts that a user sees keep to plain English and the field's terms.

use std::fs;
use std::path::Path;

use crate::support::{files_below, in_repository};

/// Words and phrases that a reader would have to translate, in small letters, each with what to write instead.
const BANNED: &[(&str, &str)] = &[
    ("left out", "omitted, ignored or neglected"),
    ("leaves out", "omits"),
    ("worth the name", "say what is meant"),
    ("nobody", "say who or what"),
    ("as such", "delete it"),
    ("beaten", "dominated"),
    ("what there is", "say what it is"),
    ("leaves over", "residual"),
    ("the lean ", "contact kernel"),
    ("knob", "variable"),
    ("judged by", "reference"),
    (" swings", "oscillations"),
    ("gives way", "yields"),
    ("slips", "yields"),
    ("hole bottom", "maximum depth"),
    ("holds still", "is treated as fixed"),
    ("mended", "corrected"),
    ("is no level", "is not a level"),
    ("misses by", "RMS error"),
    ("falls short", "fails"),
    ("fell short", "failed"),
    ("goes on at", "residual velocity"),
    ("velocity left", "residual velocity"),
    ("what matters", "sensitivity analysis"),
    ("is it worth", "comparison at equal areal mass"),
    ("looked for", "searched"),
    ("spelt", "written"),
    ("whoever", "say who"),
    ("put aside", "backed up"),
    ("lay aside", "back up"),
    ("asked for", "requested or given"),
    ("drawn up", "computed"),
    ("broken exponent", "non-integer exponent"),
    ("heeded", "say what happens"),
    ("told", "given or reported"),
    ("is said", "is reported"),
    ("side by side", "in parallel, compared"),
    ("of themselves", "relative error"),
    ("goes through", "perforates"),
    ("no rival", "not an alternative"),
    ("left alone", "not replaced"),
    ("all of one", "explains one"),
    ("gets there", "reaches it"),
    ("grew beyond", "diverged"),
    ("looked at", "searched or computed"),
    ("at last none", "after the last, none"),
];

/// The texts of a line of Rust: its string literals. A doc comment is a text, too: in `src/cli` it is what `--help` prints.
fn texts(line: &str, is_help: bool) -> Vec<String> {
    let line = line.trim();
    if let Some(help) = line.strip_prefix("///").filter(|_| is_help) {
        return vec![help.to_owned()];
    }
    if line.starts_with("//") {
        return Vec::new();
    }
    let (mut found, mut open, mut escaped) = (Vec::new(), None, false);
    for letter in line.chars() {
        match (&mut open, letter) {
            (Some(text), '"') if !escaped => {
                found.push(std::mem::take::<String>(text));
                open = None;
            }
            (None, '"') => open = Some(String::new()),
            (Some(text), letter) => {
                escaped = letter == '\\' && !escaped;
                text.push(letter);
            }
            (None, _) => {}
        }
    }
    // A literal that goes on in the next line.
    found.extend(open);
    found
}

/// The banned words of a text, each with what to write instead. A text without a space is a key or a name, not a sentence, and what
/// stands in braces is a name of the source.
fn banned(text: &str) -> Vec<&'static (&'static str, &'static str)> {
    if !text.trim().contains(' ') {
        return Vec::new();
    }
    let outside = |part: &str| part.split('{').next().unwrap_or_default().to_owned();
    let text: String = text.split('}').map(outside).collect();
    let text = text.to_lowercase().replace("recommended", "");
    BANNED.iter().filter(|(word, _)| text.contains(word)).collect()
}

#[test]
fn texts_are_found_and_their_words_checked() {
    assert_eq!(texts(r#"say("6 left out", "a \"quoted\" one")"#, false).len(), 2);
    assert!(texts("/// left out", false).is_empty());
    assert_eq!(texts("/// left out", true), [" left out"]);
    assert_eq!(banned("6 terms Left Out").len(), 1);
    assert!(banned("a recommended design").is_empty());
    assert!(banned("at {knob}").is_empty());
}

#[test]
fn texts_that_a_user_sees_are_plain() {
    let mut complaints = Vec::new();
    let mut check = |path: &Path, at: usize, text: &str| {
        for (word, instead) in banned(text) {
            complaints.push(format!("{}:{}: `{word}`: {instead}: {text}", path.display(), at + 1));
        }
    };
    for path in files_below(&in_repository("src"), "rs") {
        let source = fs::read_to_string(&path).unwrap();
        let is_help = path.starts_with(in_repository("src/cli"));
        let is_test = path.components().any(|part| part.as_os_str() == "tests")
            || path.file_name().is_some_and(|name| name == "tests.rs");
        let lines = source.lines().take_while(|line| !line.contains("mod tests {"));
        for (at, line) in lines.enumerate().filter(|_| !is_test) {
            for text in texts(line, is_help) {
                check(&path, at, &text);
            }
        }
    }
    let help = files_below(&in_repository("src/cli/help"), "txt");
    let presets = files_below(&in_repository("presets"), "toml");
    let pages = ["README.md", "CHANGELOG.md"].map(in_repository);
    for path in help.into_iter().chain(presets).chain(pages) {
        let text = fs::read_to_string(&path).unwrap();
        for (at, line) in text.lines().enumerate() {
            check(&path, at, line);
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}
