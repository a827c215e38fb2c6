//! Writer of scene files in TOML: new files, or changes to an existing text, which keeps its comments, order and formatting.
//!
//! Keys and values come from [`VARIABLES`]. Floats have the fewest digits that read back to the same value. The reader is
//! [`crate::files::read`].

use std::fmt::Write as _;

use toml_edit::{DocumentMut, Item, Table, TableLike};

use crate::files::error::SceneErrors;
use crate::files::{read, read_table};
use cmra_engine::model::scene::{Layer, Scene, SpringKind, Sweep, SweepAxis};
use cmra_engine::model::units;
use cmra_engine::model::variables::{self, Group, Kind, VARIABLES, Value, Variable};

/// Column of the comment beside a value.
const VALUE_WIDTH: usize = 27;

/// Returns a scene as a new TOML file.
pub fn fresh(scene: &Scene) -> String {
    let mut text = format!("format = {}\n", read::FORMAT);
    let _ = writeln!(text, "title = {}", quoted(&scene.title));
    if !scene.notes.is_empty() {
        let _ = writeln!(text, "notes = {}", quoted(&scene.notes));
    }
    let mut table = "";
    for variable in VARIABLES.iter().filter(|row| is_written(row, scene)) {
        let (parent, key) = split(variable);
        if parent != table {
            let _ = writeln!(text, "\n[{parent}]");
            table = parent;
        }
        let (line, note) = match value_text(variable, scene) {
            Some(value) => (format!("{key} = {value}"), ""),
            // An absent optional number is written as a comment, to show its key.
            None => (format!("# {key} ="), ", omitted"),
        };
        let _ = writeln!(text, "{line:<VALUE_WIDTH$} # {}{note}", comment(variable));
    }
    if let Some((key, points)) = changed_table(&Scene::default(), scene) {
        let _ = writeln!(text, "\n[{key}]\npoints = {points}");
    }
    text.push_str(&layers_text(scene));
    if let Some(sweep) = &scene.sweep {
        let _ = write!(text, "\n[sweep]\n{}", sweep_text(sweep));
    }
    text
}

/// Returns the scene file `text` with the values of `scene`; everything unchanged stays as it is.
///
/// # Errors
/// [`SceneErrors`] if `text` is not a scene: a change could lose its content.
pub fn updated(text: &str, file: &str, scene: &Scene) -> Result<String, SceneErrors> {
    let old = read::scene(text, file)?;
    // The strict reader has accepted the text, and the editing parser has the same grammar.
    let Ok(mut document) = text.parse::<DocumentMut>() else {
        return Ok(fresh(scene));
    };
    let root = document.as_table_mut();
    if old.title != scene.title {
        put(root, "title", &quoted(&scene.title));
    }
    if old.notes != scene.notes {
        put(root, "notes", &quoted(&scene.notes));
    }
    put_changes(root, &old, scene, false);
    // Further elements inherit from the first plate, which can have changed.
    let now = read::scene(&document.to_string(), file).ok();
    let root = document.as_table_mut();
    if now.as_ref().is_none_or(|now| now.stack.layers != scene.stack.layers) {
        put_layers(root, now.as_ref(), scene);
    }
    if old.sweep != scene.sweep {
        root.remove("sweep");
        let text = scene.sweep.as_ref().map(sweep_text);
        if let Some(Ok(parsed)) = text.map(|text| text.parse::<DocumentMut>()) {
            let mut fresh = parsed.into_table();
            fresh.set_position(None);
            root.insert("sweep", Item::Table(fresh));
        }
    }
    Ok(document.to_string())
}

/// Writes the differences between two scenes. An absent value is removed, or its absence is written.
fn put_changes(root: &mut Table, old: &Scene, scene: &Scene, writes_absent: bool) {
    for variable in VARIABLES.iter().filter(|variable| !is_kept(variable, old, scene)) {
        let (parent, key) = split(variable);
        let absent = || writes_absent.then(|| quoted(&variable.show(scene)));
        let value = value_text(variable, scene).or_else(absent);
        match value.filter(|_| !is_other_size(variable, scene)) {
            Some(value) => put(table_at(root, parent), key, &value),
            None => {
                table_at(root, parent).remove(key);
            }
        }
    }
    if let Some((key, points)) = changed_table(old, scene) {
        let table = table_at(root, key);
        table.remove("file");
        put(table, "points", &points);
    }
}

/// Returns `true` for a variable that sets the size of the plate, if the scene sets it by another one.
fn is_other_size(variable: &Variable, scene: &Scene) -> bool {
    variables::sizes_plate(variable) && scene.plate.size.key() != variable.key
}

/// Returns `true` if a variable has the same value in both scenes, or sets the size of the plate in neither.
fn is_kept(variable: &Variable, old: &Scene, scene: &Scene) -> bool {
    let [was_other, is_other] = [old, scene].map(|scene| is_other_size(variable, scene));
    was_other == is_other && (is_other || same(variable.value(old), variable.value(scene)))
}

/// Compares values by their bits: 0.0 and -0.0 differ.
fn same(a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => a.to_bits() == b.to_bits(),
        (a, b) => a == b,
    }
}

/// Returns the table of a dotted path; creates it if it is missing.
fn table_at<'t>(root: &'t mut Table, path: &str) -> &'t mut dyn TableLike {
    let mut table: &mut dyn TableLike = root;
    for name in path.split('.') {
        if table.get(name).and_then(Item::as_table_like).is_none() {
            let mut fresh = Table::new();
            // `[mechanism]` need not appear above `[mechanism.spring]`.
            fresh.set_implicit(true);
            table.insert(name, Item::Table(fresh));
        }
        table = table
            .get_mut(name)
            .and_then(Item::as_table_like_mut)
            .expect("it is there, or has just been inserted");
    }
    table
}

/// Sets a key to a value in TOML syntax; keeps the comment and the spaces around the old value.
fn put(table: &mut dyn TableLike, key: &str, value: &str) {
    let mut value: toml_edit::Value = value.parse().expect("it was written by this file, as TOML");
    if let Some(old) = table.get(key).and_then(Item::as_value) {
        *value.decor_mut() = old.decor().clone();
    }
    if let Some(item) = table.get_mut(key) {
        *item = Item::Value(value);
    } else {
        table.insert(key, Item::Value(value));
    }
}

fn split(variable: &Variable) -> (&'static str, &'static str) {
    variable.key.rsplit_once('.').unwrap_or(("", variable.key))
}

/// Returns a scene with the plate of a further element.
fn with_layer(scene: &Scene, Layer { target, plate, mechanism }: &Layer) -> Scene {
    Scene { target: *target, plate: *plate, mechanism: mechanism.clone(), ..scene.clone() }
}

/// Formats the further elements of a stack, each with its differences from the first plate.
fn layers_text(scene: &Scene) -> String {
    let mut text = String::new();
    for layer in &scene.stack.layers {
        let own = with_layer(scene, layer);
        text.push_str("\n[[stack.layer]]\n");
        let is_open = |it: &&Variable| is_other_size(it, &own) || is_kept(it, scene, &own);
        for variable in VARIABLES.iter().filter(|it| !is_open(it)) {
            let value = value_text(variable, &own).unwrap_or_else(|| quoted(&variable.show(&own)));
            let _ = writeln!(text, "{} = {value}", variable.key);
        }
        if let Some((key, points)) = changed_table(scene, &own) {
            let _ = writeln!(text, "{key}.points = {points}");
        }
    }
    text
}

/// Writes the further elements in place if their number is unchanged; else writes all of them again.
fn put_layers(root: &mut Table, now: Option<&Scene>, scene: &Scene) {
    let stack = table_at(root, "stack");
    let layers = &scene.stack.layers;
    if let Some(tables) = stack.get_mut("layer").and_then(Item::as_array_of_tables_mut)
        && let Some(now) = now.filter(|now| now.stack.layers.len() == layers.len())
    {
        for (table, (old, new)) in tables.iter_mut().zip(now.stack.layers.iter().zip(layers)) {
            put_changes(table, &with_layer(scene, old), &with_layer(scene, new), true);
        }
        return;
    }
    stack.remove("layer");
    let parsed = layers_text(scene).parse::<DocumentMut>().ok();
    let layers = parsed.and_then(|mut text| text.get_mut("stack")?.as_table_mut()?.remove("layer"));
    if let Some(Item::ArrayOfTables(mut layers)) = layers {
        layers.iter_mut().for_each(|layer| layer.set_position(None));
        stack.insert("layer", Item::ArrayOfTables(layers));
    }
}

/// Returns the measured points in TOML syntax if they differ between two scenes.
fn changed_table(old: &Scene, scene: &Scene) -> Option<(&'static str, String)> {
    let (was, is) = (&old.mechanism.spring, &scene.mechanism.spring);
    // A spring that is now of the kind `table` needs its points, even if they are unchanged.
    let begins = is.kind == SpringKind::Table && was.kind != is.kind;
    let point = |[x, force]: &[f64; 2]| format!("[{}, {}]", float(*x), float(*force));
    let points: Vec<String> = is.table.points.iter().map(point).collect();
    let is_changed = was.table != is.table || begins;
    is_changed.then(|| (read_table::KEY, format!("[{}]", points.join(", "))))
}

/// Returns `true` if a variable is written:
///
/// - of a stop, if there is one or a value differs from the default
/// - of a spring, if it belongs to its kind or differs from the default
fn is_written(variable: &Variable, scene: &Scene) -> bool {
    // Variables of a spring, or of the combination of two springs.
    let starts = ["mechanism.spring.", "mechanism.second.", "mechanism.combination"];
    if starts.iter().any(|start| variable.key.starts_with(start)) {
        let plain = Scene::default();
        let basic = !variable.is_seldom && variables::is_listed(variable, &plain);
        let listed = variables::is_listed(variable, scene)
            && (basic || !variables::is_listed(variable, &plain));
        return listed || !same(variable.value(scene), variable.value(&plain));
    }
    if is_other_size(variable, scene) {
        return false;
    }
    if variable.is_seldom {
        return !same(variable.value(scene), variable.value(&Scene::default()));
    }
    variable.group != Group::Stop
        || scene.mechanism.stop != Scene::default().mechanism.stop
            && (variable.key != "mechanism.stop.position_m"
                || scene.mechanism.stop.position_m.is_some())
}

fn value_text(variable: &Variable, scene: &Scene) -> Option<String> {
    match variable.value(scene) {
        Value::Absent => None,
        Value::Number(number) => Some(float(number)),
        Value::Word(word) => Some(quoted(word)),
        Value::Switch(on) => Some(on.to_string()),
    }
}

/// Returns the comment beside a value: its symbol, or the other choices of a word.
fn comment(variable: &Variable) -> String {
    match &variable.kind {
        Kind::Number(_) => variable.symbol.to_owned(),
        Kind::Choice { words, .. } => words.join(" or "),
        Kind::Switch { .. } => variable.meaning.to_owned(),
    }
}

/// Formats a float in TOML syntax: shortest digits, with a point or an exponent.
pub fn float(value: f64) -> String {
    let text = units::shortest(value);
    if text.contains(['.', 'e']) { text } else { text + ".0" }
}

fn quoted(text: &str) -> String {
    toml_edit::Value::from(text).to_string()
}

fn sweep_text(sweep: &Sweep) -> String {
    let axis = |axis: &SweepAxis| {
        let points = if axis.values.is_empty() {
            let ([from, to], count) = ([axis.from, axis.to].map(float), axis.count);
            let log = if axis.log { ", log = true" } else { "" };
            format!("from = {from}, to = {to}, count = {count}{log}")
        } else {
            let values: Vec<String> = axis.values.iter().copied().map(float).collect();
            format!("values = [{}]", values.join(", "))
        };
        format!("\n    {{ name = {}, {points} }}", quoted(&axis.name))
    };
    let axes: Vec<String> = sweep.axes.iter().map(axis).collect();
    let outputs: Vec<String> = sweep.outputs.iter().map(|name| quoted(name)).collect();
    format!("axes = [{},\n]\noutputs = [{}]\n", axes.join(","), outputs.join(", "))
}
