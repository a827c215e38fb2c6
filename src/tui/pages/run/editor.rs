//! List of variables: rows, selection, and formatting of values. No drawing.

pub(crate) mod draw;

use std::collections::BTreeMap;

use crate::tui::widgets::find::{rank_variable, ranked};
use cmra_engine::model::scene::{Scene, SpringKind};
use cmra_engine::model::units::{self, significant};
use cmra_engine::model::variables::{VARIABLES, Value, Variable, is_offered, is_used};

/// Main variables, always in the list: the design variables and given parameters of the thesis. Each has a short label in case its label is
/// too long.
const DESIGN: [(&str, &str); 7] = [
    ("gamma", "mass"),
    ("d", "cocking"),
    ("k", "spring"),
    ("n", "exponent"),
    ("b", "damper"),
    ("m", "exponent"),
    ("x_stop", "position"),
];
const ANALYSIS: [(&str, &str); 7] = [
    ("v_i", "velocity"),
    ("m_p", "projectile"),
    ("R", "nose radius"),
    ("h", "thickness"),
    ("rho", "density"),
    ("S_y", "strength"),
    ("C_d", "drag"),
];

#[derive(Clone, Debug)]
pub struct Editor {
    /// Selected variable, by index into the table.
    pub selected: usize,
    /// Filter text of the rows.
    pub filter: String,
    /// Arrow step in use: the variable and its decade, constant during repeated arrow keys.
    pub stepped: Option<(usize, i32)>,
    /// Typed units, by index into the table, used for display.
    pub units: BTreeMap<usize, &'static str>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum EditorRow {
    Heading(&'static str),
    /// Heading of the variables that a folded list omits.
    More,
    /// Variable, by index into the table.
    Variable(usize),
}

impl EditorRow {
    fn variable(self) -> Option<usize> {
        if let Self::Variable(index) = self { Some(index) } else { None }
    }
}

/// Returns the index of a symbol in the table.
pub(crate) fn index_of(symbol: &str) -> usize {
    VARIABLES.iter().position(|variable| variable.symbol == symbol).unwrap_or_default()
}

/// Returns the short label of a main variable; `None` for others.
fn short_label(variable: &Variable) -> Option<&'static str> {
    let mut all = DESIGN.iter().chain(&ANALYSIS);
    all.find(|(symbol, _)| *symbol == variable.symbol).map(|(_, label)| *label)
}

fn is_main(variable: &Variable) -> bool {
    short_label(variable).is_some()
}

/// Returns the variables of the scene's kind of spring that a power law lacks; empty for a power law.
pub(crate) fn spring_rows(scene: &Scene) -> Vec<usize> {
    if scene.mechanism.spring.kind == SpringKind::PowerLaw {
        return Vec::new();
    }
    let mut plain = scene.clone();
    plain.mechanism.spring.kind = SpringKind::PowerLaw;
    let is_own = |variable: &Variable| {
        let is_there = is_offered(variable, scene) && is_used(variable, scene);
        is_there && variable.key.starts_with("mechanism.spring.") && !is_used(variable, &plain)
    };
    let all = VARIABLES.iter().enumerate().filter(|(_, variable)| is_own(variable));
    all.map(|(index, _)| index).collect()
}

impl Default for Editor {
    /// Selects the first design variable.
    fn default() -> Self {
        let (filter, stepped, units) = Default::default();
        Self { selected: index_of(DESIGN[0].0), filter, stepped, units }
    }
}

impl Editor {
    /// Iterates over the offered variables that are not main variables.
    fn more(scene: &Scene) -> impl Iterator<Item = usize> {
        let all = VARIABLES.iter().enumerate();
        let own = spring_rows(scene);
        let is_more = move |variable: &Variable| {
            let is_own = own.iter().any(|index| VARIABLES[*index].key == variable.key);
            !is_own && !is_main(variable) && is_offered(variable, scene)
        };
        all.filter(move |(_, variable)| is_more(variable)).map(|(index, _)| index)
    }

    /// Returns the rows, with those of More if unfolded; under a filter the matching rows, best first, without headings.
    fn rows(&self, scene: &Scene, is_unfolded: bool) -> Vec<EditorRow> {
        if !self.filter.is_empty() {
            let all = VARIABLES.iter().enumerate();
            let offered = all.filter(|(_, it)| is_main(it) || is_offered(it, scene));
            let found = ranked(offered, |(_, variable)| rank_variable(&self.filter, variable));
            return found.into_iter().map(|(index, _)| EditorRow::Variable(index)).collect();
        }
        let named = |rows: [(&str, &str); 7]| rows.map(|it| EditorRow::Variable(index_of(it.0)));
        let mut rows = named(DESIGN).to_vec();
        let own = spring_rows(scene);
        if !own.is_empty() {
            // Other kinds of springs have their own rows in place of stiffness and exponent.
            let law = ["k", "n"].map(|symbol| EditorRow::Variable(index_of(symbol)));
            let at = rows.iter().position(|row| *row == law[0]).unwrap_or(0);
            rows.retain(|row| !law.contains(row));
            rows.splice(at..at, own.into_iter().map(EditorRow::Variable));
        }
        rows.push(EditorRow::Heading("Analysis variables"));
        rows.extend(named(ANALYSIS));
        if is_unfolded {
            rows.push(EditorRow::More);
            rows.extend(Self::more(scene).map(EditorRow::Variable));
        }
        rows
    }

    /// Returns the variables that match the filter, in the order of the list.
    pub fn listed(&self, scene: &Scene) -> Vec<usize> {
        self.rows(scene, true).into_iter().filter_map(EditorRow::variable).collect()
    }

    /// Returns `true` if the selected variable is visible; otherwise it cannot be edited.
    pub fn shows(&self, scene: &Scene) -> bool {
        self.listed(scene).contains(&self.selected)
    }

    pub fn variable(&self) -> &'static Variable {
        &VARIABLES[self.selected.min(VARIABLES.len() - 1)]
    }

    /// Returns the display unit of a variable, also the unit of bare numbers typed for it.
    pub fn unit(&self, index: usize) -> &'static str {
        let usual = || VARIABLES[index].number().map_or("", |number| number.quantity.shown_unit());
        self.units.get(&index).copied().unwrap_or_else(usual)
    }

    /// Displays a variable in the typed unit (of a value or a range `LO..HI`) if that unit has a standard name.
    pub fn show_in_unit_of(&mut self, index: usize, text: &str) {
        let is_relative = text.starts_with(['*', '/', '+', '-']) && text.ends_with('%');
        let end = text.rsplit("..").next().unwrap_or(text);
        let end = end.split(':').next().unwrap_or(end);
        let written = units::written_unit(end).filter(|_| !is_relative);
        let number = VARIABLES[index].number();
        let unit = written.zip(number).and_then(|(unit, it)| units::unit_named(unit, it.quantity));
        self.units.extend(unit.map(|unit| (index, unit)));
    }
}

/// Formats the value in the unit of screens: `25.4 mm`.
pub fn shown_value(variable: &Variable, scene: &Scene) -> String {
    let unit = variable.number().map_or("", |number| number.quantity.shown_unit());
    shown_in(variable, scene, unit, 6)
}

/// Formats the value in a unit, with this many digits.
pub(crate) fn shown_in(variable: &Variable, scene: &Scene, unit: &str, digits: usize) -> String {
    match variable.value(scene) {
        Value::Number(_) => {
            format!("{} {unit}", number_in(variable, scene, unit, digits)).trim_end().to_owned()
        }
        Value::Switch(true) => "on".to_owned(),
        Value::Switch(false) => "off".to_owned(),
        Value::Absent | Value::Word(_) => variable.show(scene),
    }
}

/// Formats the number without its unit; other values unchanged.
pub(crate) fn number_in(variable: &Variable, scene: &Scene, unit: &str, digits: usize) -> String {
    let shown = || {
        let number = variable.number()?;
        let value = (number.get)(scene)?;
        Some(significant(units::in_unit(value, unit, number.quantity).unwrap_or(value), digits))
    };
    shown().unwrap_or_else(|| variable.show(scene))
}
