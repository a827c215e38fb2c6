//! The setup of Explore as a list: axes, output, and the variables that are held. No drawing.

pub(in crate::tui) mod keys;

use crate::model::scene::SweepAxis;
use crate::model::variables::{self, VARIABLES, Value};
use crate::tui::app::App;
use crate::tui::pages::explore::state::{Picture, Spread, has_family, sweep_of};
use crate::tui::pages::run::editor::shown_value;
use crate::tui::theme::Role;
use crate::tui::widgets::axis::meaning;
use crate::tui::widgets::form::{Form, Line, VALUE_WIDTH};

pub use crate::tui::widgets::axis::Part;

/// One row of the setup.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SetupRow {
    /// A heading.
    Heading(&'static str),
    /// A part of an axis.
    Axis(usize, Part),
    /// Curves or a map.
    Picture,
    /// Which points there are.
    Design,
    /// The number of curves of a family.
    Curves,
    /// The output shown.
    Output,
    /// A held variable, by index into the table.
    Held(usize),
}

impl App {
    /// The rows of the setup, headings included.
    fn setup_rows(&self) -> Vec<SetupRow> {
        use SetupRow as R;
        let is_map = self.picture() == Picture::Surface;
        let has_two = is_map || has_family(&self.scene);
        let is_grid = self.pages.explore.spread(self.picture()) == Spread::Grid;
        let mut rows = vec![R::Heading("Show"), R::Output, R::Picture, R::Heading("Along")];
        let along = [Part::Name, Part::From, Part::To, Part::Points, Part::Spacing];
        rows.extend(along.map(|part| R::Axis(0, part)));
        rows.extend([R::Design, R::Heading("Across"), R::Axis(1, Part::Name)]);
        if has_two {
            rows.extend([R::Axis(1, Part::From), R::Axis(1, Part::To)]);
            // A design has so many points in all, not along each axis.
            let count = if is_map { R::Axis(1, Part::Points) } else { R::Curves };
            rows.extend(is_grid.then_some(count));
            rows.push(R::Axis(1, Part::Spacing));
        }
        rows.push(R::Heading("Hold"));
        let sweep = sweep_of(&self.scene);
        let swept = |variable: &variables::Variable| {
            let key = |axis: &SweepAxis| variables::find(&axis.name).map(|found| found.key);
            let axes = if has_two { 2 } else { 1 };
            sweep.axes.iter().take(axes).any(|axis| key(axis) == Ok(variable.key))
        };
        let listed = |variable| variables::is_offered(variable, &self.scene);
        let held = VARIABLES
            .iter()
            .enumerate()
            .filter(|(_, variable)| listed(variable) && !swept(variable));
        rows.extend(held.map(|(index, _)| R::Held(index)));
        rows
    }

    /// The rows that can be selected.
    pub fn setup_choices(&self) -> Vec<SetupRow> {
        let mut rows = self.setup_rows();
        rows.retain(|row| !matches!(row, SetupRow::Heading(_)));
        rows
    }

    /// The selected row; the first of the axes where the selection is not there any more.
    fn setup_row(&self) -> SetupRow {
        let row = self.pages.explore.row;
        if self.setup_rows().contains(&row) { row } else { SetupRow::Axis(0, Part::Name) }
    }

    /// The setup as a form.
    pub(in crate::tui) fn setup_form(&self) -> Form {
        let sweep = sweep_of(&self.scene);
        let line = |row| match row {
            SetupRow::Heading(text) => Line::heading(text),
            SetupRow::Axis(1, Part::Name) if self.has_no_second() => Line::typed(
                "variable", "none",
            )
            .means(
                "curves can be repeated for values of a second variable: l, or Enter and its name",
            ),
            SetupRow::Axis(at, part) => part.line(&sweep.axes[at]),
            SetupRow::Picture => {
                let word = if self.picture() == Picture::Line { "curves" } else { "map" };
                Line::word("shown as", word).means(
                    "curves: one for each value of the variable across, if any; map: colours over both",
                )
            }
            SetupRow::Design => {
                let word = self.pages.explore.spread(self.picture()).word();
                Line::word("design", word).means(
                    "every combination; or a Latin hypercube or Sobol's sequence of so many points",
                )
            }
            SetupRow::Curves => Line::typed("curves", self.pages.explore.visits.curves.to_string())
                .means("how many curves, their values spread over the range"),
            SetupRow::Output => {
                Line::quantity(&sweep.outputs[self.pages.explore.output_of(&sweep)])
            }
            SetupRow::Held(index) => self.held_line(index),
        };
        Form::new(&self.setup_rows(), self.setup_row(), line)
    }

    fn held_line(&self, index: usize) -> Line {
        let variable = &VARIABLES[index];
        let is_number = matches!(variable.value(&self.scene), Value::Number(_));
        let shown = shown_value(variable, &self.scene, usize::from(VALUE_WIDTH));
        let is_used = variables::is_used(variable, &self.scene);
        Line {
            unit: if is_number { variable.unit().trim_matches('-') } else { "" },
            text: Some(variable.show(&self.scene)),
            takes_unit: true,
            is_changed: variable.value(&self.scene) != variable.value(&self.base.scene),
            role: if is_used { Role::Text } else { Role::Dim },
            ..Line::word(variable.symbol, shown)
        }
        .means(format!("{} (held); {}", meaning(variable), variable.allowed()))
    }

    /// Whether there is one curve: a stand-in for the second axis that nobody chose is not shown as chosen.
    fn has_no_second(&self) -> bool {
        self.picture() == Picture::Line && !has_family(&self.scene)
    }
}
