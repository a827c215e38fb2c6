//! The Stability tab: the map and the battery, what is selected in them, and both in words. No drawing.

pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;

use std::error::Error;
use std::sync::Arc;

use crate::model::scene::Scene;
use crate::model::units::significant;
use crate::report::accuracy::seconds;
use crate::report::stability::{HOW_IT_RAN, table};
use crate::study::context::Context;
use crate::study::stability::map::{self, Axis, Map, Method};
use crate::study::stability::{self, Row};
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::pages::numerics::STIFF_SCENES;
use crate::tui::pages::{Progress, StatusPart, part};
use crate::tui::widgets::table::Sorting;
use crate::worker::Finding;
use crate::worker::reporter::Reporter;
use crate::worker::study::{Lane, RowsSoFar, Study};

/// What the battery's columns of other methods are, in full and where there is less room.
const COLUMNS: &str =
    "expl, D: DOP853, impl, R: Radau IIA, th-6 and th-7: the thesis's scheme at dt 1e-6 and 1e-7 s";
const COLUMNS_BRIEF: &str = "expl, D: DOP853, impl, R: Radau IIA";

/// Computes where a fixed-step method is stable.
#[derive(Debug, PartialEq)]
pub struct StabilityMap {
    /// The method.
    pub method: Method,
    /// The variable.
    pub axis: Axis,
}

impl Study for StabilityMap {
    fn lane(&self) -> Lane {
        Lane::Searches
    }

    fn make(&self, scene: &Arc<Scene>, reporter: &Reporter<'_>) -> Result<Finding, Box<dyn Error>> {
        map::accepts(scene)?;
        let watch = &mut reporter.watch(Map::clone);
        let context = &mut Context::new(1, watch);
        Ok(Finding::new(map::map(scene, (self.method, self.axis), map::CELLS, context)))
    }
}

/// Runs the battery of stiff and extreme scenes; the scene plays no part.
#[derive(Debug)]
pub struct StiffScenes;

impl Study for StiffScenes {
    fn lane(&self) -> Lane {
        Lane::Studies
    }

    fn make(&self, _: &Arc<Scene>, reporter: &Reporter<'_>) -> Result<Finding, Box<dyn Error>> {
        let cases = stability::battery(false);
        let watch = &mut reporter.watch(RowsSoFar::part);
        // A run of an edited scene has its turn beside it.
        let context = &mut Context::new(reporter.threads().min(2), watch);
        let rows = stability::run(&cases, &reporter.clock(), context)?;
        Ok(Finding::new(RowsSoFar::ended(rows, cases.len())))
    }
}

/// The columns of the table of stiff scenes.
pub fn keys() -> Vec<&'static str> {
    ["scene", "shortfall"].into_iter().chain(HOW_IT_RAN).chain(["reference"]).collect()
}

/// The state of the tab.
#[derive(Clone, Debug)]
pub struct Stability {
    /// The method of the map.
    pub method: Method,
    /// Its variable.
    pub axis: Axis,
    /// The map with the scene it belongs to.
    pub map: Option<(Arc<Scene>, Arc<Map>)>,
    /// The crosshair: row and column of the map; `None` at the present point.
    pub cursor: Option<(usize, usize)>,
    /// How the table of stiff scenes is sorted.
    pub sorting: Sorting,
    /// The rows of the battery.
    pub battery: Option<Arc<RowsSoFar<Row>>>,
    /// The selected row of the battery.
    pub selected: usize,
    /// The page of its columns.
    pub table_page: usize,
}

impl Default for Stability {
    fn default() -> Self {
        Self {
            method: Method::Thesis,
            axis: Axis::K,
            map: None,
            cursor: None,
            sorting: Sorting::default(),
            battery: None,
            selected: 0,
            table_page: 0,
        }
    }
}

impl Stability {
    /// The cell of the present point: the scene's value and the thesis's step; `None` outside the map.
    pub fn present(&self) -> Option<(usize, usize)> {
        self.map.as_ref()?.1.present_at()
    }

    /// Where the crosshair stands: the middle of the map where nothing else is known.
    pub fn cursor(&self) -> Option<(usize, usize)> {
        let (_, map) = self.map.as_ref()?;
        let middle = (map.values.len() / 2, map.dt_s.len() / 2);
        self.cursor.or_else(|| self.present()).or(Some(middle))
    }

    /// Move the crosshair by rows (up is positive) and columns.
    pub fn move_cursor(&mut self, rows: isize, columns: isize) {
        if let (Some((row, column)), Some((_, map))) = (self.cursor(), &self.map) {
            let row = row.saturating_add_signed(rows).min(map.values.len().saturating_sub(1));
            let column =
                column.saturating_add_signed(columns).min(map.dt_s.len().saturating_sub(1));
            self.cursor = Some((row, column));
        }
    }

    /// Show a map; one of another variable has its cursor elsewhere.
    pub fn show_map(&mut self, scene: Arc<Scene>, map: Arc<Map>) {
        if self.map.as_ref().is_some_and(|(_, old)| old.axis != map.axis) {
            self.cursor = None;
        }
        self.map = Some((scene, map));
    }

    /// Sort the table by its next column.
    pub fn sort_next(&mut self) {
        self.sorting = self.sorting.next(&keys());
        self.selected = 0;
    }

    /// The rows in the order they are shown in.
    pub fn sorted(&self) -> Vec<&Row> {
        let rows = self.rows();
        self.sorting.order(&table(rows)).into_iter().map(|at| &rows[at]).collect()
    }

    /// The rows of the battery there are.
    pub fn rows(&self) -> &[Row] {
        self.battery.as_ref().map_or(&[], |battery| &battery.rows)
    }
}

impl App {
    /// Whether the map belongs to another scene than the one on the screen.
    pub fn map_is_old(&self) -> bool {
        self.pages.numerics.stability.map.as_ref().is_some_and(|(scene, _)| **scene != *self.scene)
    }

    /// The cell at the crosshair in words.
    pub fn map_readout(&self) -> Option<String> {
        let (_, map) = self.pages.numerics.stability.map.as_ref()?;
        let (row, column) = self.pages.numerics.stability.cursor()?;
        let here = if self.pages.numerics.stability.present() == Some((row, column)) {
            // In one row of 80 columns: a second one would move the map.
            "; the scene"
        } else {
            ""
        };
        let limit = map.limit_s[row]
            .map_or_else(|| "none".to_owned(), |limit_s| significant(limit_s, 2) + " s");
        Some(format!(
            "dt {} s, {} {}: {}; analytic limit {limit}{here}",
            significant(map.dt_s[column], 2),
            map.axis.symbol(),
            significant(map.values[row], 2),
            map.cell(row, column).words(),
        ))
    }

    /// The selected row of the battery in words.
    pub fn battery_readout(&self) -> Option<(Severity, String)> {
        let row =
            *self.pages.numerics.stability.sorted().get(self.pages.numerics.stability.selected)?;
        Some(match row.shortfall {
            None => (Severity::Note, format!("{}: {}", row.case.name, row.case.why)),
            Some(shortfall) => (
                Severity::Error,
                format!("{}: fails: {}; {}", row.case.name, shortfall.words(), row.run.end.words()),
            ),
        })
    }

    /// The parts of the status row in this tab; see [`App::status`].
    pub fn stability_status(&self) -> Vec<StatusPart> {
        let tab = &self.pages.numerics.stability;
        let mut parts = Vec::new();
        if self.pane() == STIFF_SCENES {
            let short = tab.rows().iter().filter(|row| row.shortfall.is_some()).count();
            let holds = format!("{} of {} scenes pass", tab.rows().len() - short, tab.rows().len());
            let severity = if short > 0 { Severity::Warning } else { Severity::Note };
            let progress = match (self.jobs.running::<StiffScenes>(), &tab.battery) {
                (Some(running), _) => Some(Progress::Running(format!(
                    "running the battery{}",
                    running.counted("of", "")
                ))),
                (None, None) => Some(Progress::Nothing),
                (None, Some(battery)) if !battery.is_complete => Some(Progress::Cut(String::new())),
                (None, Some(_)) => None,
            };
            parts.extend(progress.map(Progress::part));
            if tab.battery.is_some() {
                parts.push(part(severity, holds));
                parts.push((Severity::Note, COLUMNS.to_owned(), COLUMNS_BRIEF.to_owned()));
            }
            return parts;
        }
        let progress = match (self.jobs.running::<StabilityMap>(), &tab.map) {
            (Some(mapping), _) => Some(Progress::Running(format!(
                "computing the map{}",
                mapping.counted("of", " rows")
            ))),
            _ if self.map_is_old() => Some(Progress::Old("scene")),
            (None, None) => Some(Progress::Nothing),
            (None, Some((_, map))) if !map.is_complete() => Some(Progress::Cut(String::new())),
            (None, Some(_)) => None,
        };
        parts.extend(progress.map(Progress::part));
        if let Some((_, map)) = &tab.map {
            parts.push(part(
                Severity::Note,
                match map.largest_stable_dt_s {
                    Some(dt_s) => format!("largest stable dt of this scene: {}", seconds(dt_s)),
                    None => "largest stable dt of this scene: nothing limits it".to_owned(),
                },
            ));
            parts.push(part(Severity::Note, map.method.name().to_owned()));
        }
        parts
    }
}
