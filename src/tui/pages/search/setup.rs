//! Setup of a search, as rows that can be stepped and edited. No drawing.

use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::state::{Bound, Page, Row};
use crate::tui::widgets::axis::{FIELD_DIGITS, Part, meaning, numeric, over};
use crate::tui::widgets::form::{FieldQuantity, Form, FormRow, quantity_meaning};
use crate::worker::studies::SearchRequest;
use cmra_engine::model::units;
use cmra_engine::model::variables::{self, Group, Value, Variable};
use cmra_studies::study::quantities::{QUANTITIES, Quantity, named};
use cmra_studies::study::search::front::{self, Constraint, DEFAULT};
use cmra_studies::study::sweep::default_axes::thesis_axes;
use cmra_studies::study::sweep::{Axis, COUNTS, Spacing};

/// Short names of the default objectives.
pub const OBJECTIVES: [&str; 4] = ["depth", "stroke", "system mass", "mount force"];

/// Returns a label of one or two words for a measure.
pub fn brief(column: &Quantity) -> String {
    let at = DEFAULT.iter().position(|name| *name == column.name);
    at.map_or_else(|| column.heading(), |at| OBJECTIVES[at].to_owned())
}

/// Formats a constraint in the unit on screens, under this name of its measure: `mount force<=20.00 kN`.
fn constraint(bound: &Constraint, name: &str, number: impl Fn(f64) -> String) -> String {
    let measure = bound.measure;
    let value = number(measure.in_shown_unit(bound.bound));
    format!("{name}{}{value} {}", bound.sign(), measure.shown_unit()).trim_end().to_owned()
}

/// Returns the units of bare numbers in constraints: those on screens that are not SI units.
fn constraint_units() -> String {
    let mut units: Vec<&str> = Vec::new();
    for quantity in QUANTITIES {
        let unit = quantity.shown_unit();
        if unit != quantity.unit() && !units.contains(&unit) {
            units.push(unit);
        }
    }
    format!("{} or SI", units.join(", "))
}

/// Returns the variables for fronts: the important ones of Table 9.2 are on, all others that the scene uses are off.
fn default_bounds(scene: &Scene) -> Vec<Bound> {
    let thesis = thesis_axes(scene).unwrap_or_default();
    let is_there = |it: &Variable| thesis.iter().any(|axis| axis.variable().key == it.key);
    let others = numeric(scene).filter(|variable| {
        let positive = matches!(variable.value(scene), Value::Number(value) if value > 0.0);
        let is_model = variable.group != Group::Run && variables::is_listed(variable, scene);
        positive && is_model && variables::is_used(variable, scene) && !is_there(variable)
    });
    let usual = |variable| Axis::from_sweep_axis(&over(scene, variable, 2).ok()?, &COUNTS).ok();
    let others = others.filter_map(usual).map(|axis| Bound { axis, on: false });
    let others: Vec<Bound> = others.collect();
    thesis.into_iter().map(|axis| Bound { axis, on: true }).chain(others).collect()
}

impl App {
    /// Returns the variables of fronts; the default ones if the user has not changed a bound.
    pub fn search_bounds(&self) -> Vec<Bound> {
        let kept = &self.pages.search.setup.bounds;
        let kept = |symbol: &str| kept.iter().find(|it| it.axis.symbol() == symbol).cloned();
        let usual = default_bounds(&self.scene).into_iter();
        usual.map(|bound| kept(bound.axis.symbol()).unwrap_or(bound)).collect()
    }

    /// Returns the rows of a page's setup, headings included.
    fn search_rows(&self, page: Page) -> Vec<Row> {
        (page.study().rows)(self)
    }

    /// Returns a row for each variable that can be varied.
    pub(super) fn bound_rows(&self) -> impl Iterator<Item = Row> {
        (0..self.search_bounds().len()).map(Row::Bound)
    }

    /// Returns the selectable rows.
    pub(crate) fn search_choices(&self, page: Page) -> Vec<Row> {
        let mut rows = self.search_rows(page);
        rows.retain(|row| !matches!(row, Row::Heading(_)));
        rows
    }

    /// Returns the selected row. If it no longer exists, returns the goal, else the first row.
    pub(crate) fn search_row(&self) -> Row {
        let (rows, row) = (self.search_choices(self.pages.search.page), self.pages.search.row);
        let there = [row, Row::Goal].into_iter().find(|row| rows.contains(row));
        there.or_else(|| rows.first().copied()).unwrap_or_default()
    }

    pub(crate) fn search_form(&self) -> Form {
        let bounds = self.search_bounds();
        let rows = self.search_rows(self.pages.search.page);
        Form::new(&rows, self.search_row(), |row| self.search_line(row, &bounds))
    }

    /// Returns a row of the setup, with these variables to vary.
    pub(crate) fn search_line(&self, row: Row, bounds: &[Bound]) -> FormRow {
        let setup = &self.pages.search.setup;
        match row {
            Row::Heading(heading) => FormRow::heading(heading),
            Row::Axis(Part::Points) => Part::Points
                .line(&setup.seek, "")
                .means("points of the scan: solutions closer together may be missed"),
            Row::Axis(part) => part.line(&setup.seek, self.unit_of(&setup.seek.name)),
            Row::Result => FormRow::quantity(setup.goal.0),
            Row::Goal => {
                let goal = named(setup.goal.0).map(|quantity| quantity.show(setup.goal.1, 6));
                let goal = goal.unwrap_or_default();
                let unit = shown_unit(&goal).to_owned();
                let quantity = Some(FieldQuantity { unit, variable: None });
                FormRow { quantity, ..FormRow::typed("is", goal) }
                    .means(quantity_meaning(setup.goal.0))
            }
            Row::Bound(at) => bounds.get(at).map_or_else(
                || FormRow::choice("", ""),
                |bound| bound_line(bound, self.unit_of(bound.axis.symbol())),
            ),
            Row::Objective(at) => {
                let objective = FormRow::switch(OBJECTIVES[at], setup.objectives[at]);
                objective.means(quantity_meaning(DEFAULT[at]))
            }
            Row::Bounds => self.constraints_line(),
            Row::Feasible => FormRow::switch("feasible", setup.feasible).means(
                "yes: only designs without a new warning on the unsafe side (interface, spring, stop, face)",
            ),
            Row::Designs => FormRow::typed("designs", setup.designs.to_string())
                .means("designs to try; the front has at most 100 of them"),
            Row::Affected => FormRow::quantity(setup.affected),
            Row::Output => FormRow::quantity(setup.output),
            Row::Percent => FormRow::typed("std dev", format!("{} %", significant(setup.percent, 5)))
                .means("standard deviation of every input, lognormal"),
            Row::Samples => FormRow::typed("samples", setup.samples.to_string())
                .means("number of samples; the confidence interval narrows with its square root"),
        }
    }

    /// Returns the row of the constraints, in the units of screens.
    fn constraints_line(&self) -> FormRow {
        let each = &self.search_constraints();
        let written = |of: &dyn Fn(&Constraint) -> String| {
            let each: Vec<String> = each.iter().map(of).collect();
            if each.is_empty() { "none".to_owned() } else { each.join(", ") }
        };
        let shown = written(&|it| {
            constraint(it, &brief(it.measure), |value| units::fixed_significant(value, 4))
        });
        let text = written(&|it| {
            constraint(it, it.measure.name, |value| significant(value, FIELD_DIGITS))
        });
        let unit = constraint_units();
        let meaning = format!(
            "{text} (QUANTITY<=VALUE or QUANTITY>=VALUE, a number alone in {unit}, separated by commas, or none: peak_mount_force_n<=20kN)"
        );
        let quantity = Some(FieldQuantity { unit, variable: None });
        FormRow { text: Some(text), quantity, ..FormRow::choice("bounds", shown) }.means(meaning)
    }

    /// Returns the constraints; of the default ones those that exist for the scene.
    pub(super) fn search_constraints(&self) -> Vec<Constraint> {
        let usual = front::Request::default().subject_to;
        let mut constraints = self.pages.search.setup.subject_to.clone();
        constraints.retain(|it| it.measure.exists(&self.scene) || !usual.contains(it));
        constraints
    }

    /// Builds the request of a page's setup.
    pub fn search_request(&self, page: Page) -> Result<SearchRequest, String> {
        (page.study().request)(self)
    }

    /// Returns the varied variables; empty for the default ones, which the command omits.
    pub(super) fn varied(&self) -> Result<Vec<Axis>, String> {
        if self.pages.search.setup.bounds.is_empty() {
            return Ok(Vec::new());
        }
        let varied = self.search_bounds().into_iter().filter(|bound| bound.on);
        let varied: Vec<Axis> = varied.map(|bound| bound.axis).collect();
        if varied.is_empty() {
            return Err("every variable is held: vary one (<right>)".to_owned());
        }
        Ok(varied)
    }
}

/// Returns the unit after the number of a displayed value: `mm`.
pub(super) fn shown_unit(value: &str) -> &str {
    value.split_once(' ').map_or("", |(_, unit)| unit)
}

/// Returns the row of a bound in the display unit of its variable: `0.8..7` or `1..7500 kN/m^n log`.
pub(crate) fn bound_line(bound: &Bound, unit: &'static str) -> FormRow {
    let variable = bound.axis.variable();
    let number_in = |value: f64| {
        let number = variable.number();
        number.and_then(|it| units::in_unit(value, unit, it.quantity)).unwrap_or(value)
    };
    let (low, high) = bound.axis.ends();
    let log = if bound.axis.spacing() == Spacing::Log { ":log" } else { "" };
    let range = |digits: usize| {
        let shown = |end| significant(number_in(end), digits);
        format!("{}..{}", shown(low), shown(high))
    };
    let shown = format!("{} {unit}", range(5));
    let shown = if bound.on { format!("{}{log}", shown.trim_end()) } else { "held".to_owned() };
    let meaning = meaning(variable);
    FormRow {
        text: Some(format!("{}{log}", range(FIELD_DIGITS))),
        quantity: Some(FieldQuantity { unit: unit.to_owned(), variable: Some(variable) }),
        role: if bound.on { Role::Text } else { Role::Dim },
        ..FormRow::choice(bound.axis.symbol(), shown)
    }
    .means(format!("{meaning} (<enter>: LO..HI, LO..HI:log; <left>/<right> held or varied)"))
}

/// Parses `0.8..7`, `1e3..7.5e6:log`, with units or in the displayed unit.
pub(crate) fn read_bound(old: &Bound, text: &str, unit: &str) -> Result<Bound, String> {
    let (name, count) = (old.axis.symbol(), Some(old.axis.count()));
    let axis = Axis::read_range_in(unit, (name, text), count, &COUNTS);
    Ok(Bound { axis: axis.map_err(|error| error.to_string())?, on: true })
}
