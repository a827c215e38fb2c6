//! TOML reader that collects all problems of a file, each with line and column.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use crate::files::clean;
use crate::files::error::{Problem, SceneErrors};

/// Maximum number of reported problems of a file; a file of another format has one in each line.
const PROBLEMS_MAX: usize = 20;

/// Formats the message of the parser on one line.
pub(super) fn syntax(message: &str) -> String {
    format!("not TOML: {}", message.replace('\n', ", "))
}

/// Formats the error of a value in the terms of a scene file.
pub(super) fn misfit(error: &toml::de::Error) -> String {
    let text = clean::line(error.message()).into_owned();
    [("f64", "a number"), ("u64", "a whole number"), ("a sequence", "a list")].into_iter().fold(
        text,
        |text, (type_name, word)| {
            text.replace(&format!("expected {type_name}"), &format!("expected {word}"))
        },
    )
}

/// Text with the problems found so far.
pub(super) struct Reader<'t> {
    text: &'t str,
    file: &'t str,
    problems: Vec<Problem>,
    more: bool,
}

impl<'t> Reader<'t> {
    /// Creates a reader of a text; `file` appears in error messages.
    pub(super) fn new(text: &'t str, file: &'t str) -> Self {
        Self { text, file, problems: Vec::new(), more: false }
    }

    /// Returns the problems in the order of lines, as an error.
    pub(super) fn finish(mut self) -> Result<(), SceneErrors> {
        if self.problems.is_empty() {
            return Ok(());
        }
        self.problems.sort();
        Err(SceneErrors { file: self.file.to_owned(), problems: self.problems, more: self.more })
    }

    /// Returns `true` without problems so far.
    pub(super) fn is_right(&self) -> bool {
        self.problems.is_empty()
    }

    pub(super) fn text_value(
        &mut self,
        key: &str,
        value: &Spanned<DeValue<'_>>,
        target: &mut String,
    ) {
        if let DeValue::String(text) = value.get_ref() {
            text.as_ref().clone_into(target);
        } else {
            let text = format!(
                "{key} = {} is {}: it must be text; write it in quotes",
                self.shown(value),
                kind_of(value.get_ref())
            );
            self.problem(value.span(), text);
        }
    }

    /// Returns the name of the file as given by the user.
    pub(super) fn file(&self) -> &str {
        self.file
    }

    /// Returns `true` if the maximum number of problems is reached: the rest of the file is not checked.
    pub(super) fn is_full(&mut self) -> bool {
        self.more |= self.problems.len() >= PROBLEMS_MAX;
        self.more
    }

    pub(super) fn problem(&mut self, span: Range<usize>, text: String) {
        if self.is_full() {
            return;
        }
        let before = self.text.get(..span.start).unwrap_or(self.text);
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        self.problems.push(Problem {
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
            text,
        });
    }

    /// Returns a value as in the file, shortened.
    pub(super) fn shown(&self, value: &Spanned<DeValue<'_>>) -> String {
        const SHOWN_MAX: usize = 40;
        let source = self.text.get(value.span()).unwrap_or_default();
        let line = source.lines().next().unwrap_or_default();
        if line.chars().count() > SHOWN_MAX || line.len() < source.trim_end().len() {
            let cut: String = line.chars().take(SHOWN_MAX).collect();
            format!("{cut}...")
        } else {
            line.to_owned()
        }
    }
}

/// Returns the type of a TOML value in words.
pub(super) fn kind_of(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "a switch",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
