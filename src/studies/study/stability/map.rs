//! Stability map of a method with a fixed step size, over the step size and one variable of the scene.

use std::fmt;
use std::sync::Arc;

use crate::study::context::Context;
use crate::study::sweep::{Axis, Spacing, StudyError};
use cmra_engine::model::appendix::Scheme;
use cmra_engine::model::run::{EndReason, Observer, Outcome};
use cmra_engine::model::scene::{Listing, Scene};
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables::{self, VariableError};
use cmra_engine::numerics::larger;

/// Largest relative error of an accurate cell.
pub const ACCURATE: f64 = 1e-2;
/// Ratio of the velocity of the plate to that of the reference above which a run counts as diverged. The contact can end before values
/// overflow.
const RUNS_AWAY_FROM: f64 = 1e2;
/// Maximum number of steps of a cell.
const STEPS_MAX: usize = 200_000;
/// Size of a map: values of the variable, and step sizes; at least 2 each.
pub const SIZE: (usize, usize) = (19, 61);
/// Size of a quick map.
pub const QUICK: (usize, usize) = (10, 31);
/// Step size of the thesis, s.
pub const THESIS_DT_S: f64 = 1e-6;

enumeration! {
    /// Method of a map.
    pub enum FixedStep in FixedStepRow {
        /// Name on pages.
        name: &'static str,
        /// Key on the command line.
        word: &'static str,
        /// Description in the command's help.
        about: &'static str,
        /// Whether it corrects the scheme of the listing.
        corrects_scheme: bool,
    }
    /// Listing of Appendix A with the depth from the relative displacement.
    Thesis {
        name: "the thesis's scheme", word: "thesis", about: "Appendix A with its depth corrected",
        corrects_scheme: false
    }
    /// Classical Runge-Kutta method for the whole system.
    Rk4 {
        name: "classical Runge-Kutta", word: "rk4", about: "Classical Runge-Kutta",
        corrects_scheme: true
    }
}

enumeration! {
    /// Variable of a map.
    pub enum MapVariable in MapVariableRow {
        /// Symbol of the variable.
        symbol: &'static str,
        /// Meaning of the variable.
        about: &'static str,
        /// Smallest and largest value; the values in between have equal ratios.
        range: (f64, f64),
    }
    /// Spring coefficient.
    K {
        symbol: "k", about: "Spring coefficient", range: (1e3, 1e12) }
    /// Spring exponent.
    N {
        symbol: "n", about: "Spring exponent", range: (0.05, 6.0) }
    /// Damper coefficient.
    B {
        symbol: "b", about: "Damper coefficient", range: (1.0, 1e8) }
}

enumeration! {
    /// Behaviour of a method for a step size and a value.
    pub enum Cell in CellRow {
        /// Word in files.
        word: &'static str,
        /// Label in the legend.
        label: &'static str,
        /// Rest of the label on the printed page.
        more: &'static str,
        /// Character on a map: the worse, the darker.
        shade: char,
    }
    /// Error of at most 1 %.
    Accurate { word: "accurate", label: "accurate", more: " (1 %)", shade: ' ' }
    /// Error above 1 %.
    Inaccurate { word: "inaccurate", label: "inaccurate", more: "", shade: '.' }
    /// Values grow without bound.
    BlownUp { word: "blown up", label: "diverged", more: "", shade: '@' }
    /// The maximum number of steps is exceeded.
    TooManySteps { word: "too many steps", label: "too many steps", more: "", shade: '~' }
    /// There is no reference.
    Unknown { word: "unknown", label: "nothing to compare with", more: "", shade: '?' }
    /// Cell that is not computed yet.
    Waiting { word: "not computed", label: "not computed", more: "", shade: '_' }
}

impl Cell {
    /// The whole label.
    pub fn words(self) -> String {
        format!("{}{}", self.label(), self.more())
    }
}

/// Request for a stability map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilityMapRequest {
    /// The method.
    pub method: FixedStep,
    /// The variable of the rows.
    pub variable: MapVariable,
    /// Numbers of rows and columns.
    pub size: (usize, usize),
}

/// Formats the command with its options.
impl fmt::Display for StabilityMapRequest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let quick = if self.size == QUICK { " --quick" } else { "" };
        let (variable, method) = (self.variable.symbol(), self.method.word());
        write!(f, "stability --map {variable} --method {method}{quick}")
    }
}

/// Stability map.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// The method.
    pub method: FixedStep,
    /// Step size across.
    pub dt: Axis,
    /// Variable up.
    pub variable: Axis,
    /// Cells, row by row.
    pub cells: Vec<Cell>,
    /// Value of the scene itself, shown at the step size of the thesis.
    pub present: f64,
}

impl Map {
    /// Returns the cell in a row and a column.
    pub fn cell(&self, row: usize, column: usize) -> Cell {
        self.cells[row * self.counts().0 + column]
    }

    /// Returns the numbers of columns and of rows.
    pub fn counts(&self) -> (usize, usize) {
        let columns = usize::try_from(self.dt.count()).unwrap_or(usize::MAX);
        (columns, self.cells.len() / columns)
    }

    /// Returns `true` if every cell is computed.
    pub fn is_complete(&self) -> bool {
        !self.cells.contains(&Cell::Waiting)
    }

    /// Returns column and row of the scene itself; `None` outside the map.
    pub fn present_at(&self) -> Option<(usize, usize)> {
        self.nearest(THESIS_DT_S, self.present)
    }

    /// Returns column and row of the cell closest to a step size and a value; `None` outside the map.
    pub fn nearest(&self, dt_s: f64, value: f64) -> Option<(usize, usize)> {
        nearest(&self.dt, dt_s).zip(nearest(&self.variable, value))
    }
}

/// Returns the closest point of an axis; `None` outside its range.
fn nearest(axis: &Axis, value: f64) -> Option<usize> {
    let (low, high) = axis.ends();
    let inside = value >= 0.99 * low && value <= 1.01 * high;
    usize::try_from(axis.nearest(value)).ok().filter(|_| inside)
}

/// Checks that a scene has a stability map: one plate on a power law, hydrodynamic contact.
pub fn accepts(scene: &Scene) -> Result<(), VariableError> {
    variables::validate(scene)?;
    variables::require_hydrodynamic(scene)?;
    variables::require_plain(scene)?;
    variables::require_single(scene)
}

/// Computes the map of a valid scene and reports partial maps; a stopped map has waiting cells.
pub fn map(
    scene: &Scene,
    wanted: StabilityMapRequest,
    context: &mut Context<'_, Map>,
) -> Result<Map, StudyError> {
    let StabilityMapRequest { method, variable, size: (rows, columns) } = wanted;
    let contact_s = Target::from_scene(scene, &mut context.observer()).map_or_else(
        || scene.projectile.tip_radius_m / scene.projectile.velocity_m_s,
        |target| target.contact_s,
    );
    let in_ratios = |name, ends, count: usize| Axis::new(name, ends, count as u64, Spacing::Log);
    let dt = in_ratios("dt", (1e-5 * contact_s, contact_s), columns)?;
    let variable = in_ratios(variable.symbol(), variable.range(), rows)?;
    let (steps, values, stop) = (dt.values(), variable.values(), context.stop());
    let row = |value: &f64| {
        let mut own = scene.clone();
        variable.set(&mut own, *value);
        let target = Target::from_scene(&own, &mut |_| stop.flow());
        let cell =
            |dt_s: &f64| (!stop.is_set()).then(|| cell(&own, method, *dt_s, target.as_ref()));
        steps.iter().map(cell).collect::<Option<Vec<Cell>>>()
    };
    let mut map = Map {
        method,
        cells: vec![Cell::Waiting; rows * columns],
        present: variable.get(scene).unwrap_or(0.0),
        dt,
        variable: variable.clone(),
    };
    context.expect(rows);
    context.map_items(&values, row, |context, found| {
        let seen = found.iter().flatten();
        map.cells.iter_mut().zip(seen).for_each(|(cell, seen)| *cell = *seen);
        context.show(&map)
    });
    Ok(map)
}

/// Reference of a row: duration of the contact, maximum velocity of the plate, and end of the contact.
#[derive(Clone, Copy)]
struct Target {
    contact_s: f64,
    speed_m_s: f64,
    end: ContactEnd,
}

/// End of the first contact: arrested with the depth, m, or perforated with the time, s.
type ContactEnd = (Outcome, f64);

impl Target {
    fn from_scene(scene: &Scene, observer: Observer<'_>) -> Option<Self> {
        let run = simulate(&Arc::new(scene.clone()), &Settings::SERIES, observer).ok()?;
        let (contact_s, end) = match run.first_arrest {
            Some(arrest) => (arrest.t_s, (Outcome::Arrested, arrest.penetration_m)),
            None => (run.departure.exit_time_s?, (Outcome::Perforated, run.departure.exit_time_s?)),
        };
        let rows = run.series.iter().take_while(|row| row.t_s <= contact_s);
        let speed_m_s = rows.map(|row| row.plate_velocity_m_s.abs()).fold(0.0, larger);
        Some(Self { contact_s, speed_m_s, end })
    }
}

fn cell(scene: &Scene, method: FixedStep, dt_s: f64, target: Option<&Target>) -> Cell {
    let Some(target) = target else {
        return Cell::Unknown;
    };
    // The corrected listing, with the time stepping of the thesis or Runge-Kutta for both bodies.
    let corrects_scheme = method.corrects_scheme();
    let scheme = Scheme::from_scene(scene, Listing { corrects_scheme, ..Listing::coupled(dt_s) });
    let fastest_m_s = RUNS_AWAY_FROM * target.speed_m_s;
    let mut state = scheme.start;
    for step in 1..=STEPS_MAX {
        let refused = scheme.step(&mut state);
        let is_away = state.plate[1].abs() > fastest_m_s && scene.is_sprung();
        let (outcome, value) = match (refused, scheme.ended(&state)) {
            _ if is_away => return Cell::BlownUp,
            (Err(EndReason::NonFinite), _) => return Cell::BlownUp,
            (Err(_), _) => return Cell::Inaccurate,
            (Ok(()), None) => continue,
            (Ok(()), Some(outcome @ Outcome::Perforated)) => (outcome, step as f64 * dt_s),
            (Ok(()), Some(_)) => (Outcome::Arrested, state.depth_m),
        };
        let is_accurate = outcome == target.end.0 && (value / target.end.1 - 1.0).abs() <= ACCURATE;
        return if is_accurate { Cell::Accurate } else { Cell::Inaccurate };
    }
    Cell::TooManySteps
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use super::*;
    use crate::study::context::Progress;

    /// A run of the scene may have no end.
    #[test]
    fn a_map_of_an_endless_scene_is_stopped() {
        let mut scene = Scene::default();
        scene.run.horizon_s = Some(1e9);
        scene.mechanism.spring.exponent = 0.3;
        let (method, variable) = (FixedStep::Rk4, MapVariable::K);
        let request = StabilityMapRequest { method, variable, size: QUICK };
        let stops = &mut |_: Progress, _: Option<&Map>| ControlFlow::Break(());
        let found = map(&scene, request, &mut Context::new(1, stops)).unwrap();
        assert!(found.cells.iter().all(|cell| *cell == Cell::Waiting));
    }

    #[test]
    fn every_variable_has_an_axis_whose_ends_are_inside_the_map() {
        for variable in MapVariable::ALL {
            let ends = variable.range();
            let axis = Axis::new(variable.symbol(), ends, 19, Spacing::Log).unwrap();
            assert_eq!([ends.0, ends.1].map(|end| nearest(&axis, end)), [Some(0), Some(18)]);
            assert_eq!([0.9 * ends.0, 1.1 * ends.1].map(|end| nearest(&axis, end)), [None, None]);
        }
    }

    #[test]
    fn a_plate_on_its_spring_blows_up_beyond_the_limit_and_not_below() {
        let mut scene = Scene::default();
        scene.mechanism.spring.coefficient = 1e11;
        let target = Target::from_scene(&scene, &mut |_| ControlFlow::Continue(())).unwrap();
        // Hairer and Wanner II, section IV.2: Runge-Kutta's region reaches 2 sqrt(2) up the imaginary axis.
        let limit_s = 8f64.sqrt() / (1e11f64 / 0.0295).sqrt();
        for method in [FixedStep::Rk4, FixedStep::Thesis] {
            let below = cell(&scene, method, 0.9 * limit_s, Some(&target));
            let beyond = cell(&scene, method, 1.1 * limit_s, Some(&target));
            assert_eq!((below, beyond), (Cell::Accurate, Cell::BlownUp), "{method:?}");
        }
    }
}
