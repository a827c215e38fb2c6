//! Strict reader of scene files in TOML.
//!
//! Keys are those of [`VARIABLES`]; there is no second list. All problems of a file are reported together, each with line and column. The
//! writer is [`crate::files::write`].

use std::fs;
use std::io::Read;
use std::ops::Range;
use std::os::unix::fs::FileTypeExt as _;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::files::error::{FileError, SceneErrors, nearest, shown};
use crate::files::reader::{Reader, kind_of, syntax};
use crate::files::{clean, read_stack, read_sweep, read_table};
use cmra_engine::model::scene::{PlateSize, Scene, SpringKind};
use cmra_engine::model::units::{self, Bare};
use cmra_engine::model::variables::{self, Kind, VARIABLES, Value, Variable};
use cmra_studies::study::error::refusal;

/// Version of the scene format.
pub const FORMAT: i64 = 1;

/// Maximum size of a scene file, bytes; a larger file is not a scene.
pub const BYTES_MAX: u64 = 1 << 20;

/// Reads a file of at most `bytes_max` bytes.
pub fn text_file(path: &Path, bytes_max: u64) -> Result<String, FileError> {
    let failed = |source| FileError::read(path, source);
    let found = fs::metadata(path).map_err(failed)?;
    // A pipe can have no writer, and a device no end.
    let may_wait = !found.is_file() && !found.is_dir() || is_of_system(path);
    if may_wait && (!is_handed(path) || found.file_type().is_char_device()) {
        return Err(FileError::special(path));
    }
    text_from(fs::File::open(path).map_err(failed)?, path, bytes_max)
}

/// Returns `true` for standard input and pipes passed by a shell, `<(...)`.
fn is_handed(path: &Path) -> bool {
    path == Path::new("/dev/stdin")
        || path.starts_with("/dev/fd")
        || path.starts_with("/proc") && path.iter().any(|part| part == "fd")
}

/// Returns `true` for files of the kernel, which can have no end or block.
fn is_of_system(path: &Path) -> bool {
    let real = fs::canonicalize(path).unwrap_or_default();
    real.starts_with("/proc") || real.starts_with("/sys")
}

/// Reads a source of at most `bytes_max` bytes, and no more than that; `path` appears in error messages.
pub fn text_from(source: impl Read, path: &Path, bytes_max: u64) -> Result<String, FileError> {
    let mut bytes = Vec::new();
    let read = source.take(bytes_max + 1).read_to_end(&mut bytes);
    read.map_err(|source| FileError::read(path, source))?;
    let refused = |problem: &str| FileError::Refused(format!("`{}` {problem}", shown(path)));
    if bytes.len() as u64 > bytes_max {
        return Err(refused(&format!(
            "has more than {bytes_max} bytes, the most that is read: is this the right file?"
        )));
    }
    String::from_utf8(bytes).map_err(|_not_text| {
        refused("is not UTF-8 text: is this the right file? if so, save it as UTF-8")
    })
}

/// Reads a scene from a text; `file` appears in error messages.
pub fn scene(text: &str, file: &str) -> Result<Scene, SceneErrors> {
    let mut reader = Reader::new(text, file);
    let mut scene = Scene::default();
    match DeTable::parse(text) {
        Ok(document) => reader.document(&mut scene, document.get_ref()),
        Err(error) => reader.problem(error.span().unwrap_or(0..0), syntax(error.message())),
    }
    reader.finish().map(|()| scene)
}

/// Reading of the keys of a scene.
impl Reader<'_> {
    /// Reports two variables that both set the size of a plate.
    pub(super) fn one_size(&mut self, table: &DeTable<'_>) {
        let sizes = PlateSize::KEYS.iter().filter_map(|key| Some((*key, find(table, key)?)));
        // A word marks the value as absent.
        let sizes = sizes.filter(|(_, value)| !matches!(value.get_ref(), DeValue::String(_)));
        if let [(first, _), (second, value), ..] = &sizes.collect::<Vec<_>>()[..] {
            let all = PlateSize::KEYS.join(", ");
            let text =
                format!("{first} and {second} both give the plate's size: give only one of {all}");
            self.problem(value.span(), text);
        }
    }

    fn document(&mut self, scene: &mut Scene, document: &DeTable<'_>) {
        if !self.is_readable_format(document) {
            return;
        }
        for (key, value) in document {
            match key.get_ref().as_ref() {
                "format" => {}
                "title" => self.text_value("title", value, &mut scene.title),
                "notes" => self.text_value("notes", value, &mut scene.notes),
                "sweep" => scene.sweep = read_sweep::sweep(self, value),
                name => self.entry(scene, name, key.span(), value),
            }
        }
        self.measured_curve(scene, document);
        // The file has the drag coefficient in effect. A value that differs from that of the closure is given by the user.
        let drag = scene.target.drag_coefficient;
        let is_other = drag.to_bits() != scene.target_in_effect().drag_coefficient.to_bits();
        if is_other && find(document, "target.drag_coefficient").is_some() {
            scene.target.give_drag();
        }
        // After gamma, which they replace.
        self.one_size(document);
        for key in &PlateSize::KEYS[1..] {
            let found = VARIABLES.iter().find(|variable| variable.key == *key);
            if let (Some(variable), Some(value)) = (found, find(document, key)) {
                self.variable(scene, variable, value);
            }
        }
        // Last: an element has the values of the scene except its own keys.
        if let Some(list) = find(document, read_stack::KEY) {
            scene.stack.layers = read_stack::layers(self, scene, list);
        }
        if self.is_right()
            && let Err(error) = variables::validate(scene)
        {
            // Each value is valid; the remaining rules concern several values.
            let keys = error.keys();
            let named = VARIABLES.iter().map(|variable| variable.key).chain([read_table::KEY]);
            let key = named.filter(|key| keys.contains(key)).find_map(|key| find(document, key));
            let span = key.map_or(0..0, Spanned::span);
            self.problem(span, error.to_string());
        }
    }

    /// Reports a spring of the kind `table` without points; the default points are an example.
    fn measured_curve(&mut self, scene: &Scene, document: &DeTable<'_>) {
        let (kind, key) = ("mechanism.spring.kind", read_table::KEY);
        let Some(found) = find(document, kind) else { return };
        if scene.mechanism.spring.kind == SpringKind::Table && find(document, key).is_none() {
            let text = format!(
                "{kind} = \"table\" has no measured curve: add [{key}] with file = \"curve.csv\" or points = [[x, F], ...] in m and N"
            );
            self.problem(found.span(), text);
        }
    }

    /// Checks the format version; a file of another version can have other keys and is not read further.
    fn is_readable_format(&mut self, document: &DeTable<'_>) -> bool {
        let cure = format!("write `format = {FORMAT}` at the top of the file");
        let Some(value) = document.get("format") else {
            self.problem(0..0, format!("`format` is missing: {cure}"));
            return true;
        };
        let is_supported = number(value.get_ref()) == Some(FORMAT as f64);
        if !is_supported {
            let shown = self.shown(value);
            let text = format!(
                "format = {shown} is not supported: this program reads format {FORMAT}; {cure}"
            );
            self.problem(value.span(), text);
        }
        is_supported
    }

    /// Reads a key: a variable, or a table of variables.
    pub(super) fn entry(
        &mut self,
        scene: &mut Scene,
        path: &str,
        key_span: Range<usize>,
        value: &Spanned<DeValue<'_>>,
    ) {
        if self.is_full() {
            return;
        }
        if path == read_table::KEY {
            if let Some(points) = read_table::points(self, path, value) {
                scene.mechanism.spring.table.points = points;
            }
            return;
        }
        if path == read_stack::KEY {
            return;
        }
        let prefix = format!("{path}.");
        let is_table = VARIABLES.iter().any(|variable| variable.key.starts_with(&prefix));
        let variable = VARIABLES.iter().find(|variable| variable.key == path);
        match (value.get_ref(), variable) {
            (DeValue::Table(table), _) if is_table => {
                for (key, value) in table {
                    let path = format!("{prefix}{}", key.get_ref());
                    self.entry(scene, &path, key.span(), value);
                }
            }
            (_, Some(variable)) => self.variable(scene, variable, value),
            (_, None) if is_table => {
                let (shown, kind) = (self.shown(value), kind_of(value.get_ref()));
                let keys = keys_below(path);
                let text = format!(
                    "{path} = {shown} is {kind}: `{path}` is a table; write [{path}] with {keys} below it"
                );
                self.problem(value.span(), text);
            }
            (_, None) => {
                let text = unknown(path, matches!(value.get_ref(), DeValue::Table(_)));
                self.problem(key_span, text);
            }
        }
    }

    fn variable(&mut self, scene: &mut Scene, variable: &Variable, value: &Spanned<DeValue<'_>>) {
        let read = match (&variable.kind, value.get_ref()) {
            // The word that marks an optional number as absent, for an element of a stack.
            (Kind::Number(optional), DeValue::String(word))
                if optional.absent == Some(word.as_ref()) =>
            {
                Some(Value::Absent)
            }
            (Kind::Number(_), item) => number(item).map(Value::Number),
            // The table of variables has the error message of an unknown choice.
            (Kind::Choice { .. }, DeValue::String(word)) => {
                match variable.parse(scene, word, Bare::Stored) {
                    Ok(value) => Some(value),
                    Err(error) => return self.problem(value.span(), error.to_string()),
                }
            }
            (Kind::Switch { .. }, DeValue::Boolean(on)) => Some(Value::Switch(*on)),
            (Kind::Choice { .. } | Kind::Switch { .. }, _) => None,
        };
        let Some(read) = read else {
            let text = self.wrong_type(variable, value);
            return self.problem(value.span(), text);
        };
        let drag = scene.target.drag;
        if let Err(error) = variable.set(scene, read) {
            self.problem(value.span(), refusal(&error));
        }
        if variable.key == "target.drag_coefficient" {
            // The file has the drag coefficient in effect; another key says whether it is given.
            scene.target.drag = drag;
        }
    }

    fn wrong_type(&self, variable: &Variable, value: &Spanned<DeValue<'_>>) -> String {
        let defaults = Scene::default();
        let example = match variable.value(&defaults) {
            Value::Absent => "omit the key to have none".to_owned(),
            Value::Word(word) => format!("write for example \"{word}\""),
            Value::Number(_) | Value::Switch(_) => {
                format!("write for example {}", variable.show(&defaults))
            }
        };
        let quoted = match value.get_ref() {
            DeValue::String(text) => variable.parse(&defaults, text, Bare::Stored).ok(),
            _ => None,
        };
        let cure = match quoted {
            Some(Value::Number(number))
                if variable.number().is_some_and(|it| it.allowed.contains(number)) =>
            {
                format!("write {} without quotes", units::shortest(number))
            }
            Some(Value::Switch(on)) => format!("write {on} without quotes"),
            Some(_) | None => example,
        };
        let rule = variable.number().map(|number| {
            let absent = number.absent.map_or_else(String::new, |word| format!(", or \"{word}\""));
            format!("{}{absent}", number.allowed.describe(number.quantity))
        });
        let allowed = rule.unwrap_or_else(|| variable.allowed());
        format!(
            "{} = {} is {}: it must be {allowed}; {cure}",
            variable.key,
            self.shown(value),
            kind_of(value.get_ref()),
        )
    }
}

/// Returns the number in a TOML value (float or integer).
fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        DeValue::Integer(integer) => {
            let radix = integer.radix();
            let mut digits = integer.as_str().chars().map(|digit| digit.to_digit(radix));
            digits.try_fold(0.0, |all, digit| Some(all * f64::from(radix) + f64::from(digit?)))
        }
        _ => None,
    }
}

/// Returns the value of a dotted key.
fn find<'d, 't>(document: &'d DeTable<'t>, key: &str) -> Option<&'d Spanned<DeValue<'t>>> {
    let (first, rest) = key.split_once('.').unwrap_or((key, ""));
    let value = document.get(first)?;
    match value.get_ref() {
        _ if rest.is_empty() => Some(value),
        DeValue::Table(table) => find(table, rest),
        _ => None,
    }
}

/// Returns the error message for an unknown key.
fn unknown(path: &str, is_table: bool) -> String {
    const SHOWN_MAX: usize = 80;
    let shown = clean::line(path);
    let mut path: String = shown.chars().take(SHOWN_MAX).collect();
    if shown.chars().count() > SHOWN_MAX {
        path += "...";
    }
    let what = if is_table { "table" } else { "key" };
    let last = path.rsplit('.').next().unwrap_or(&path);
    let hint = if let Ok(variable) = variables::find(last) {
        format!("did you mean `{}`?", variable.key)
    } else if is_table {
        let tables = VARIABLES.iter().filter_map(|variable| Some(variable.key.rsplit_once('.')?.0));
        nearest(&path, &once_each(tables.chain(["sweep"])), "the tables are")
    } else {
        variables::did_you_mean(&path).unwrap_or_else(|| {
            let parent = path.rsplit_once('.').map_or("", |(parent, _)| parent);
            format!("the keys here are {}", keys_below(parent))
        })
    };
    format!("`{path}` is not a {what} of a scene: {hint}")
}

/// Returns names in their order, without repetitions.
fn once_each<'n>(names: impl Iterator<Item = &'n str>) -> Vec<&'n str> {
    let mut once = Vec::new();
    for name in names {
        if !once.contains(&name) {
            once.push(name);
        }
    }
    once
}

/// Lists the keys and tables directly below a table (`""` for the top level).
fn keys_below(table: &str) -> String {
    let prefix = if table.is_empty() { String::new() } else { format!("{table}.") };
    let own: &[&str] = if table.is_empty() { &["format", "title", "notes", "sweep"] } else { &[] };
    let rest = VARIABLES.iter().filter_map(|variable| variable.key.strip_prefix(&prefix));
    let names = rest.filter_map(|rest| rest.split('.').next());
    let points = (table == read_table::SPRING).then_some("table");
    once_each(own.iter().copied().chain(names).chain(points)).join(", ")
}
