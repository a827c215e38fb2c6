//! The setup of Explore as a list: axes, output, and the variables that are held. No drawing.

pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;

use crate::model::scene::SweepAxis;
use crate::model::units;
use crate::model::variables::{self, VARIABLES};
use crate::study::quantities::Quantity;
use crate::tui::app::App;
use crate::tui::pages::explore::state::{Picture, Spread, has_family, sweep_of};

/// One row of the setup.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SetupRow {
    /// A heading.
    Heading(&'static str),
    /// The variable of an axis.
    Name(usize),
    /// Its first value.
    From(usize),
    /// Its last value.
    To(usize),
    /// Its number of points.
    Points(usize),
    /// How they are spread.
    Spacing(usize),
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

/// What a row shows: its name, its value, its unit.
pub struct Shown {
    /// At the left.
    pub label: String,
    /// At the right.
    pub value: String,
    /// After the value.
    pub unit: &'static str,
}

impl App {
    /// The rows of the setup, headings included.
    pub fn setup_rows(&self, picture: Picture) -> Vec<SetupRow> {
        use SetupRow as R;
        let axis = |at| [R::Name(at), R::From(at), R::To(at), R::Points(at), R::Spacing(at)];
        let mut rows = vec![R::Heading("Show"), R::Output, R::Picture, R::Heading("Along")];
        rows.extend(axis(0));
        match picture {
            Picture::Surface => {
                let grid = self.pages.explore.spread(picture) == Spread::Grid;
                rows.extend([R::Design, R::Heading("Across"), R::Name(1), R::From(1), R::To(1)]);
                // A design has so many points in all, not along each axis.
                rows.extend(grid.then_some(R::Points(1)));
                rows.push(R::Spacing(1));
            }
            Picture::Line => {
                let grid = self.pages.explore.spread(picture) == Spread::Grid;
                rows.push(R::Design);
                rows.extend([R::Heading("Across"), R::Name(1)]);
                if has_family(&self.scene) {
                    rows.extend([R::From(1), R::To(1)]);
                    rows.extend(grid.then_some(R::Curves));
                    rows.push(R::Spacing(1));
                }
            }
        }
        rows.push(R::Heading("Hold"));
        let sweep = sweep_of(&self.scene);
        let axes = if picture == Picture::Surface || has_family(&self.scene) { 2 } else { 1 };
        let swept = |variable: &variables::Variable| {
            let key = |axis: &SweepAxis| variables::find(&axis.name).map(|found| found.key);
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
    pub fn setup_choices(&self, picture: Picture) -> Vec<SetupRow> {
        let mut rows = self.setup_rows(picture);
        rows.retain(|row| !matches!(row, SetupRow::Heading(_)));
        rows
    }

    /// The selected row; the first one where the selection is not there any more.
    pub fn setup_row(&self, picture: Picture) -> SetupRow {
        let rows = self.setup_choices(picture);
        if rows.contains(&self.pages.explore.row) {
            self.pages.explore.row
        } else {
            SetupRow::Name(0)
        }
    }

    /// What a row shows, its value in at most `width` characters.
    pub fn setup_shown(&self, picture: Picture, row: SetupRow, width: usize) -> Shown {
        let sweep = sweep_of(&self.scene);
        let axis = |at: usize| &sweep.axes[at];
        let unit = |at: usize| {
            variables::find(&axis(at).name).map_or("", |found| found.unit().trim_matches('-'))
        };
        let shown =
            |label: &str, value: String, unit| Shown { label: label.to_owned(), value, unit };
        match row {
            SetupRow::Heading(text) => shown(text, String::new(), ""),
            SetupRow::Name(1) if picture == Picture::Line && !has_family(&self.scene) => {
                shown("variable", "none".to_owned(), "")
            }
            SetupRow::Name(at) => shown("variable", axis(at).name.clone(), ""),
            SetupRow::From(at) => shown("from", number(axis(at).from, width), unit(at)),
            SetupRow::To(at) => shown("to", number(axis(at).to, width), unit(at)),
            SetupRow::Points(at) => shown("points", axis(at).count.to_string(), ""),
            SetupRow::Spacing(at) => {
                let word = if axis(at).log { "log" } else { "linear" };
                shown("spacing", word.to_owned(), "")
            }
            SetupRow::Picture => {
                let word = if picture == Picture::Line { "curves" } else { "map" };
                shown("shown as", word.to_owned(), "")
            }
            SetupRow::Design => {
                shown("design", self.pages.explore.spread(picture).word().to_owned(), "")
            }
            SetupRow::Curves => shown("curves", self.pages.explore.visits.curves.to_string(), ""),
            SetupRow::Output => {
                let at = self.pages.explore.output.min(sweep.outputs.len() - 1);
                shown(&sweep.outputs[at], String::new(), "")
            }
            SetupRow::Held(index) => {
                let variable = &VARIABLES[index];
                Shown {
                    label: variable.symbol.to_owned(),
                    value: crate::tui::pages::run::editor::shown_value(
                        variable,
                        &self.scene,
                        width,
                    ),
                    unit: match variable.value(&self.scene) {
                        variables::Value::Number(_) => variable.unit().trim_matches('-'),
                        variables::Value::Absent
                        | variables::Value::Word(_)
                        | variables::Value::Switch(_) => "",
                    },
                }
            }
        }
    }

    /// The text a field opens with.
    pub fn setup_text(&self, row: SetupRow) -> String {
        let sweep = sweep_of(&self.scene);
        match row {
            SetupRow::From(at) => units::shortest(sweep.axes[at].from),
            SetupRow::To(at) => units::shortest(sweep.axes[at].to),
            // What is shown: a stand-in that nobody chose would be taken for chosen.
            SetupRow::Name(1) if self.picture() == Picture::Line && !has_family(&self.scene) => {
                "none".to_owned()
            }
            SetupRow::Name(at) => sweep.axes[at].name.clone(),
            SetupRow::Points(at) => sweep.axes[at].count.to_string(),
            SetupRow::Curves => self.pages.explore.visits.curves.to_string(),
            SetupRow::Output => {
                let name = &sweep.outputs[self.pages.explore.output.min(sweep.outputs.len() - 1)];
                crate::study::quantities::find(name).map_or_else(|| name.clone(), Quantity::title)
            }
            SetupRow::Held(index) => VARIABLES[index].show(&self.scene),
            SetupRow::Heading(_) | SetupRow::Spacing(_) | SetupRow::Picture | SetupRow::Design => {
                String::new()
            }
        }
    }

    /// What the selected row of the setup means.
    pub fn setup_readout(&self, picture: Picture) -> String {
        let sweep = sweep_of(&self.scene);
        let of_axis = |at: usize| {
            let name = &sweep.axes[at].name;
            variables::find(name).map_or_else(
                |_| name.clone(),
                |found| format!("{}: {}", found.symbol, found.meaning),
            )
        };
        match self.setup_row(picture) {
            SetupRow::Heading(_) => String::new(),
            SetupRow::Name(1) if picture == Picture::Line && !has_family(&self.scene) => {
                "curves can be repeated for values of a second variable: l, or Enter and its name"
                    .to_owned()
            }
            SetupRow::Name(at)
            | SetupRow::From(at)
            | SetupRow::To(at)
            | SetupRow::Points(at)
            | SetupRow::Spacing(at) => of_axis(at),
            SetupRow::Picture => {
                "curves: one for each value of the variable across, if any; map: colours over both"
                    .to_owned()
            }
            SetupRow::Design => {
                "every combination; or a Latin hypercube or Sobol's sequence of so many points"
                    .to_owned()
            }
            SetupRow::Curves => "how many curves, their values spread over the range".to_owned(),
            SetupRow::Output => {
                let name = &sweep.outputs[self.pages.explore.output.min(sweep.outputs.len() - 1)];
                crate::study::quantities::find(name).map_or_else(String::new, |output| {
                    format!("{}: {}", output.title(), output.meaning)
                })
            }
            SetupRow::Held(index) => {
                let variable = &VARIABLES[index];
                let allowed = variable.allowed();
                format!("{}: {} (held); {allowed}", variable.symbol, variable.meaning)
            }
        }
    }
}

fn number(value: f64, width: usize) -> String {
    crate::tui::pages::run::editor::shown_number(value, width)
}
