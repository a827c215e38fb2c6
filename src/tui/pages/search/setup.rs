//! What is looked for, as a list of rows that can be stepped and typed into. No drawing.

use crate::model::scene::Scene;
use crate::model::units::{self, significant};
use crate::model::variables::{self, Group, Kind};
use crate::study::monte_carlo::{self, usual_tolerances};
use crate::study::quantities::{self, Quantity, named};
use crate::study::search::front::{self, Constraint, Objective, Task, USUAL};
use crate::study::search::nsga;
use crate::study::search::seek::{Goal, SCAN_USUAL};
use crate::study::sensitivity;
use crate::study::sweep::Axis;
use crate::tui::app::App;
use crate::tui::pages::search::bounds::{Bound, axis, bound, range};
use crate::tui::pages::search::request::Request;
use crate::tui::pages::search::state::Page;

/// What is looked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Goal seek: the variable.
    pub seek: Bound,
    /// Points of its scan.
    pub points: u64,
    /// The result and its wanted value.
    pub goal: (&'static str, f64),
    /// Variables of fronts and sensitivity; empty: those of Table 9.2.
    pub bounds: Vec<Bound>,
    /// Which of the usual objectives count.
    pub objectives: [bool; 4],
    /// The greatest stroke allowed, m.
    pub stroke_m: Option<f64>,
    /// Designs that are not feasible do not count.
    pub feasible: bool,
    /// Points of a generation, and generations.
    pub effort: (usize, usize),
    /// Measures drawn across and up, by their place.
    pub axes: (usize, usize),
    /// The result of sensitivity and scatter.
    pub output: &'static str,
    /// Relative deviation of every input, percent.
    pub percent: f64,
    /// Samples.
    pub samples: usize,
}

impl Default for Setup {
    fn default() -> Self {
        Self {
            seek: Bound { name: "d", ends: (0.0, 0.5), log: false, on: true },
            points: SCAN_USUAL,
            goal: ("percent_of_baseline", 60.0),
            bounds: Vec::new(),
            objectives: [true; 4],
            stroke_m: Some(1.0),
            feasible: true,
            effort: (60, 40),
            axes: (0, 1),
            output: "percent_of_baseline",
            percent: 2.0,
            samples: 10_000,
        }
    }
}

/// One row of the setup.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Row {
    /// A heading.
    Heading(&'static str),
    /// Goal seek: the variable.
    Name,
    /// Its first value.
    From,
    /// Its last value.
    To,
    /// How its scan is spread.
    Spacing,
    /// Points of the scan.
    Points,
    /// The result that has a goal.
    Result,
    /// The goal: what a person changes first.
    #[default]
    Goal,
    /// A variable with its bounds.
    Bound(usize),
    /// An objective.
    Objective(usize),
    /// The greatest stroke.
    Stroke,
    /// Whether designs have to be feasible.
    Feasible,
    /// Points of a generation.
    Population,
    /// Generations.
    Generations,
    /// The measure across.
    Across,
    /// The measure up.
    Up,
    /// The result of sensitivity and scatter.
    Output,
    /// Relative deviation of the inputs.
    Percent,
    /// Samples.
    Samples,
}

/// Short names of the usual objectives.
pub const OBJECTIVES: [&str; 4] = ["depth", "stroke", "system mass", "mount force"];

/// A measure in a word or two.
pub fn brief(column: &Quantity) -> String {
    let at = USUAL.iter().position(|name| *name == column.name);
    at.map_or_else(|| column.title(), |at| OBJECTIVES[at].to_owned())
}

/// What a quantity is called on the screen.
fn title(name: &str) -> String {
    named(name).map_or_else(|_| name.to_owned(), Quantity::title)
}

/// The variables that fronts and sensitivity can vary: those of Table 9.2 that matter are on, the shot's and the target's off.
fn usual_bounds(scene: &Scene) -> Vec<Bound> {
    let thesis = sensitivity::thesis_axes(scene).unwrap_or_default();
    let mut list: Vec<Bound> = thesis
        .iter()
        .map(|axis| Bound { name: axis.symbol(), ends: axis.ends(), log: false, on: true })
        .collect();
    let others = variables::VARIABLES.iter().filter(|variable| {
        let group = matches!(variable.group, Group::Projectile | Group::Target);
        group && variables::is_used(variable, scene)
    });
    for variable in others {
        let positive = match &variable.kind {
            Kind::Number(number) => (number.get)(scene).is_some_and(|value| value > 0.0),
            Kind::Choice(_) | Kind::Switch { .. } => false,
        };
        if let Ok(bound) = bound(scene, variable.symbol)
            && positive
        {
            list.push(Bound { on: false, ..bound });
        }
    }
    list
}

impl App {
    /// The variables of fronts and sensitivity.
    pub fn search_bounds(&self) -> Vec<Bound> {
        let kept = &self.pages.search.setup.bounds;
        if kept.is_empty() { usual_bounds(&self.scene) } else { kept.clone() }
    }

    /// The rows of the setup, headings included.
    pub fn search_rows(&self) -> Vec<Row> {
        let bounds = || (0..self.search_bounds().len()).map(Row::Bound);
        let mut rows = Vec::new();
        match self.pages.search.page {
            Page::Seek => rows.extend([
                Row::Heading("Goal"),
                Row::Result,
                Row::Goal,
                Row::Heading("Vary"),
                Row::Name,
                Row::From,
                Row::To,
                Row::Spacing,
                Row::Points,
            ]),
            Page::Front => {
                rows.push(Row::Heading("Make small"));
                rows.extend((0..OBJECTIVES.len()).map(Row::Objective));
                rows.extend([Row::Stroke, Row::Feasible, Row::Heading("Vary")]);
                rows.extend(bounds());
                rows.extend([Row::Heading("Show"), Row::Across, Row::Up]);
                rows.extend([Row::Heading("Effort"), Row::Population, Row::Generations]);
            }
            Page::Sensitivity => {
                rows.extend([Row::Heading("Of"), Row::Output, Row::Heading("Vary")]);
                rows.extend(bounds());
            }
            Page::MonteCarlo => rows.extend([
                Row::Heading("Every input"),
                Row::Percent,
                Row::Samples,
                Row::Heading("Show"),
                Row::Output,
            ]),
        }
        rows
    }

    /// The rows that can be selected.
    pub fn search_choices(&self) -> Vec<Row> {
        let mut rows = self.search_rows();
        rows.retain(|row| !matches!(row, Row::Heading(_)));
        rows
    }

    /// The selected row; where the selection is not there any more, what a person changes first: the goal, else the first row.
    pub fn search_row(&self) -> Row {
        let rows = self.search_choices();
        if rows.contains(&self.pages.search.row) {
            return self.pages.search.row;
        }
        let goal = Some(Row::Goal).filter(|row| rows.contains(row));
        goal.or_else(|| rows.first().copied()).unwrap_or_default()
    }

    /// What a row shows: its label and its value.
    pub fn search_shown(&self, row: Row) -> (String, String) {
        let setup = &self.pages.search.setup;
        let text = |label: &str, value: String| (label.to_owned(), value);
        let on = |on: bool| if on { "yes" } else { "no" }.to_owned();
        let number = |value: f64| significant(value, 5);
        match row {
            Row::Heading(heading) => text(heading, String::new()),
            Row::Name => text("variable", setup.seek.name.to_owned()),
            Row::From => text("from", number(setup.seek.ends.0)),
            Row::To => text("to", number(setup.seek.ends.1)),
            Row::Spacing => {
                text("spacing", if setup.seek.log { "log" } else { "linear" }.to_owned())
            }
            Row::Points => text("points", setup.points.to_string()),
            Row::Result => (title(setup.goal.0), String::new()),
            Row::Goal => text("is", self.search_text(row)),
            Row::Bound(at) => {
                let bounds = self.search_bounds();
                bounds.get(at).map_or_else(
                    || (String::new(), String::new()),
                    |bound| {
                        text(bound.name, if bound.on { range(bound) } else { "held".to_owned() })
                    },
                )
            }
            Row::Objective(at) => text(OBJECTIVES[at], on(setup.objectives[at])),
            Row::Stroke => text("stroke at most", self.search_text(row)),
            Row::Feasible => text("feasible", on(setup.feasible)),
            Row::Population => text("designs", setup.effort.0.to_string()),
            Row::Generations => text("generations", setup.effort.1.to_string()),
            Row::Across => text("across", self.axis_title(setup.axes.0)),
            Row::Up => text("up", self.axis_title(setup.axes.1)),
            Row::Output => (title(setup.output), String::new()),
            Row::Percent => text("deviation", format!("{} %", number(setup.percent))),
            Row::Samples => text("samples", setup.samples.to_string()),
        }
    }

    fn axis_title(&self, at: usize) -> String {
        let chosen = self.chosen_objectives();
        let name = chosen.get(at.min(chosen.len().saturating_sub(1)));
        name.map_or_else(|| "-".to_owned(), |at| OBJECTIVES[*at].to_owned())
    }

    /// The places of the objectives that count.
    pub fn chosen_objectives(&self) -> Vec<usize> {
        (0..OBJECTIVES.len()).filter(|at| self.pages.search.setup.objectives[*at]).collect()
    }

    /// The text a field opens with.
    pub fn search_text(&self, row: Row) -> String {
        let setup = &self.pages.search.setup;
        match row {
            Row::Name => setup.seek.name.to_owned(),
            Row::From => units::shortest(setup.seek.ends.0),
            Row::To => units::shortest(setup.seek.ends.1),
            Row::Points => setup.points.to_string(),
            Row::Result => title(setup.goal.0),
            Row::Goal => named(setup.goal.0)
                .map_or_else(|_| String::new(), |column| column.show(setup.goal.1, 6)),
            Row::Bound(at) => self.search_bounds().get(at).map_or_else(String::new, range),
            Row::Stroke => match setup.stroke_m {
                Some(stroke) => {
                    units::Engineering { value: stroke, unit: "m", digits: 4 }.to_string()
                }
                None => "none".to_owned(),
            },
            Row::Population => setup.effort.0.to_string(),
            Row::Generations => setup.effort.1.to_string(),
            Row::Output => title(setup.output),
            Row::Percent => significant(setup.percent, 5),
            Row::Samples => setup.samples.to_string(),
            Row::Heading(_)
            | Row::Spacing
            | Row::Objective(_)
            | Row::Feasible
            | Row::Across
            | Row::Up => String::new(),
        }
    }

    /// What the selected row means.
    pub fn search_row_words(&self) -> String {
        let of = |name: &str| {
            variables::find(name).map_or_else(
                |_| String::new(),
                |found| format!("{}: {}", found.symbol, found.meaning),
            )
        };
        let result = |name: &str| {
            named(name).map_or_else(
                |_| String::new(),
                |column| format!("{}: {}", column.title(), column.meaning),
            )
        };
        match self.search_row() {
            Row::Heading(_) => String::new(),
            Row::Name | Row::From | Row::To | Row::Spacing => of(self.pages.search.setup.seek.name),
            Row::Points => "points of the scan: solutions closer together may be missed".to_owned(),
            Row::Result | Row::Goal => result(self.pages.search.setup.goal.0),
            Row::Bound(at) => {
                let name = self.search_bounds().get(at).map_or("", |bound| bound.name);
                format!("{} (Enter: LO..HI, LO..HI:log; h/l held or varied)", of(name))
            }
            Row::Objective(at) => result(USUAL[at]),
            Row::Stroke => "designs with a greater stroke do not count; none: no bound".to_owned(),
            Row::Feasible => {
                "yes: interface, yield, travel, rigid stop and plate face count".to_owned()
            }
            Row::Population => {
                "designs of a generation: the front has as many at the most".to_owned()
            }
            Row::Generations => "generations after the first".to_owned(),
            Row::Across | Row::Up => "which objective the chart shows along this axis".to_owned(),
            Row::Output => result(self.pages.search.setup.output),
            Row::Percent => "standard deviation of every input, lognormal".to_owned(),
            Row::Samples => "random scenes: the interval narrows with their root".to_owned(),
        }
    }

    /// What a page asks for.
    ///
    /// # Errors
    /// Why it cannot be looked for.
    pub fn search_request(&self, page: Page) -> Result<Request, String> {
        let setup = &self.pages.search.setup;
        let axes = || {
            let bounds = self.search_bounds();
            bounds
                .iter()
                .filter(|bound| bound.on)
                .map(|bound| axis(bound, 2))
                .collect::<Result<Vec<_>, _>>()
        };
        Ok(match page {
            Page::Seek => Request::Seek(Goal {
                axis: axis(&setup.seek, setup.points)?,
                measure: setup.goal.0.to_owned(),
                target: setup.goal.1,
            }),
            Page::Front => Request::Front(self.front_task(axes()?)?),
            Page::Sensitivity => Request::Sensitivity {
                axes: axes()?,
                output: setup.output.to_owned(),
                effort: sensitivity::Effort { rows: 1024, trajectories: 100, seed: 1 },
            },
            Page::MonteCarlo => Request::MonteCarlo(monte_carlo::Task {
                tolerances: usual_tolerances(&self.scene, setup.percent / 100.0),
                measures: quantities::usual().map(|it| it.name.to_owned()).collect(),
                samples: setup.samples,
                seed: 1,
            }),
        })
    }

    fn front_task(&self, axes: Vec<Axis>) -> Result<Task, String> {
        let setup = &self.pages.search.setup;
        let chosen: Vec<&str> = self.chosen_objectives().iter().map(|at| USUAL[*at]).collect();
        if chosen.is_empty() {
            return Err(
                "no objective is chosen: l on depth, stroke, mass or mount force".to_owned()
            );
        }
        let objectives: Vec<Objective> =
            front::objectives(&chosen, &[] as &[&str]).map_err(|error| error.to_string())?;
        let bound = setup.stroke_m.map(|bound| {
            named("stroke_m").map(|measure| Constraint {
                measure,
                at_most: true,
                bound,
                is_feasibility: false,
            })
        });
        let constraints = bound.transpose().map_err(|error| error.to_string())?;
        let (population, generations) = setup.effort;
        Ok(Task {
            axes,
            objectives,
            constraints: constraints
                .into_iter()
                .chain(front::feasibility().filter(|_| setup.feasible))
                .collect(),
            laws: vec![self.scene.interface.law],
            effort: nsga::Effort { population, generations, seed: 1 },
        })
    }
}
