//! The list of variables: which rows there are, which is selected, and how a value is shown.

pub(in crate::tui) mod draw;

use crate::model::scene::Scene;
use crate::model::units;
use crate::model::variables::{Group, VARIABLES, Value, Variable, is_offered};
use crate::tui::app::find::{rank, ranked};

/// The list of variables.
#[derive(Clone, Debug, Default)]
pub struct Editor {
    /// Selected variable, by index into the table.
    pub selected: usize,
    /// The text that the rows shown match.
    pub filter: String,
    /// The arrow step in use: the variable and its decade, kept while the arrows go on.
    pub stepped: Option<(usize, i32)>,
}

/// One row of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Row {
    /// A group's heading.
    Heading(Group),
    /// A variable, by index into the table.
    Variable(usize),
}

impl Editor {
    /// The rows with a heading over each group; under a filter those that match, best first, without headings.
    pub fn rows(&self, scene: &Scene) -> Vec<Row> {
        if !self.filter.is_empty() {
            let offered = VARIABLES.iter().enumerate().filter(|(_, it)| is_offered(it, scene));
            let found = ranked(offered, |(_, variable)| self.rank(variable));
            return found.into_iter().map(|(index, _)| Row::Variable(index)).collect();
        }
        let mut rows = Vec::new();
        for group in Group::ALL {
            let start = rows.len();
            for (index, variable) in VARIABLES.iter().enumerate() {
                if variable.group == group && is_offered(variable, scene) {
                    rows.push(Row::Variable(index));
                }
            }
            if rows.len() > start {
                rows.insert(start, Row::Heading(group));
            }
        }
        rows
    }

    /// The variables that pass the filter, in order of the list.
    pub fn listed(&self, scene: &Scene) -> Vec<usize> {
        self.rows(scene)
            .into_iter()
            .filter_map(|row| match row {
                Row::Variable(index) => Some(index),
                Row::Heading(_) => None,
            })
            .collect()
    }

    /// The selected variable.
    pub fn variable(&self) -> &'static Variable {
        &VARIABLES[self.selected.min(VARIABLES.len() - 1)]
    }

    fn rank(&self, variable: &Variable) -> Option<usize> {
        let mut names = vec![variable.symbol];
        names.extend(variable.aliases);
        let text = [variable.key, variable.meaning, variable.group.title()].join(" ");
        rank(&self.filter, &names, &text)
    }

    /// The first of `height` rows to show so that the selected one is in sight, near the middle of a long list.
    pub fn first_row(&self, scene: &Scene, height: usize) -> usize {
        let rows = self.rows(scene);
        let here = rows.iter().position(|row| *row == Row::Variable(self.selected)).unwrap_or(0);
        let most = rows.len().saturating_sub(height);
        here.saturating_sub(height * 2 / 3).min(most)
    }
}

/// The value as shown in a row: at most `width` characters, as many of six figures as fit.
pub fn shown_value(variable: &Variable, scene: &Scene, width: usize) -> String {
    match variable.value(scene) {
        Value::Number(number) => shown_number(number, width),
        Value::Switch(true) => "on".to_owned(),
        Value::Switch(false) => "off".to_owned(),
        Value::Absent | Value::Word(_) => variable.show(scene),
    }
}

/// A number in at most `width` characters.
pub fn shown_number(number: f64, width: usize) -> String {
    (1..=6)
        .rev()
        .map(|digits| units::significant(number, digits))
        .find(|text| text.len() <= width)
        .unwrap_or_else(|| format!("{number:.0e}"))
}
