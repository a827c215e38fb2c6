//! The comparison at equal areal mass in the Limit tab: the verdict, the figures of the candidates beside each other, the map of
//! mass efficiency and the design under its cursor. No drawing.

pub(in crate::tui) mod draw;

use std::error::Error;
use std::sync::Arc;

use crate::model::library::{Entry, Library};
use crate::model::scene::Scene;
use crate::model::units::{Engineering, significant};
use crate::report;
use crate::study::compare::map::{self, Map};
use crate::study::compare::{self, Hardware, summary::sentences};
use crate::study::context::{Context, Progress};
use crate::study::sweep::Axis;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::app::status::wrap;
use crate::tui::pages::explore::state::placed;
use crate::tui::pages::search::lines::Line;
use crate::worker::Finding;
use crate::worker::reporter::Reporter;
use crate::worker::study::{Lane, Study};

/// Points along each axis of the map of the mass efficiency.
const MAP_POINTS: u64 = 41;

/// Compares at equal areal mass, and maps the mass efficiency around the scene.
#[derive(Debug)]
pub struct EqualMass;

/// A comparison at equal areal mass with its map, where there is one.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The candidates.
    pub report: compare::Report,
    /// Mass efficiency over impact velocity and mass ratio.
    pub map: Option<Map>,
}

impl Study for EqualMass {
    fn lane(&self) -> Lane {
        Lane::Searches
    }

    /// A scene without such a map, a stack for one, has none.
    fn make(&self, scene: &Arc<Scene>, reporter: &Reporter<'_>) -> Result<Finding, Box<dyn Error>> {
        let points = usize::try_from(MAP_POINTS * MAP_POINTS)?;
        let whole = points + compare::Candidate::ALL.len();
        let of_all = |progress: Progress, before: usize| Progress {
            done: before + progress.done,
            total: whole,
        };
        let watch = &mut |progress, _: Option<&()>| reporter.tell(of_all(progress, 0), &|| None);
        let context = &mut Context::new(1, watch);
        let report = compare::compare(scene, Hardware::default(), context)?;
        let axes = [("v_i", MAP_POINTS), ("gamma", MAP_POINTS)]
            .map(|(name, count)| map::usual_axis(scene, name, count).ok());
        let [Some(x), Some(y)] = axes else {
            return Ok(Finding::new(Comparison { report, map: None }));
        };
        if !report.is_complete {
            return Ok(Finding::new(Comparison { report, map: None }));
        }
        let part = || Some(Finding::new(Comparison { report: report.clone(), map: None }));
        let done = whole - points;
        let watch = &mut |progress, _: Option<&()>| reporter.tell(of_all(progress, done), &part);
        let context = &mut Context::new(reporter.threads(), watch);
        let map = Map::compute(scene, &[x, y], Hardware::default(), context).ok();
        Ok(Finding::new(Comparison { report, map }))
    }
}

fn note(text: String) -> Line {
    (Severity::Note, text)
}

impl App {
    /// The absorbers of the library that the comparison can be made with.
    pub fn absorbers(&self) -> Vec<&Entry> {
        let parts = self.presets.iter().filter_map(|entry| entry.part.as_ref());
        parts.filter(|part| part.library == Library::Absorbers).collect()
    }

    /// The absorber chosen, where it is not the scene's own.
    pub fn absorber(&self) -> Option<&Entry> {
        self.absorbers().get(self.pages.limit.absorber.checked_sub(1)?).copied()
    }

    /// The scene that is compared: with the absorber chosen.
    ///
    /// # Errors
    /// Why the absorber does not fit.
    pub fn compared_scene(&self) -> Result<Scene, String> {
        let mut scene = (*self.scene).clone();
        if let Some(absorber) = self.absorber() {
            absorber.apply(&mut scene).map_err(|error| error.to_string())?;
        }
        Ok(scene)
    }

    /// Whether the comparison belongs to another scene than the one on the screen.
    pub fn comparison_is_old(&self) -> bool {
        let wanted = self.compared_scene().ok();
        self.pages
            .limit
            .comparison
            .as_ref()
            .is_some_and(|(scene, _)| Some(&**scene) != wanted.as_ref())
    }

    /// The comparison there is.
    pub fn comparison(&self) -> Option<&Comparison> {
        self.pages.limit.comparison.as_ref().map(|(_, found)| &**found)
    }

    /// The comparison in lines of so many columns.
    pub fn comparison_lines(&self, width: usize) -> Vec<Line> {
        self.comparison().map_or_else(Vec::new, |found| compared(&found.report, width))
    }

    /// With which absorber the comparison is made.
    pub fn comparison_readout(&self) -> Option<String> {
        let with = self.absorber().map_or_else(
            || "the scene's own spring".to_owned(),
            |absorber| format!("{}: {}", absorber.name, absorber.title),
        );
        Some(format!("absorber: {with} (v: the next one of the library)"))
    }

    /// The cell of the map under the cursor: the one it was moved to, else the one nearest to the scene.
    pub fn efficiency_cursor(&self) -> Option<(usize, usize)> {
        let map = self.comparison()?.map.as_ref()?;
        let nearest = |axis: &Axis| {
            let value = (axis.number().get)(&self.scene)?;
            usize::try_from(axis.nearest(value)).ok()
        };
        let own = || Some((nearest(map.x())?, nearest(map.y())?));
        self.pages.limit.map_cursor.or_else(own).or(Some((0, 0)))
    }

    /// The design under the cursor of the map, with the values of its axes in words.
    ///
    /// # Errors
    /// Why there is none.
    pub fn efficiency_design(&self) -> Result<(Scene, String), String> {
        let map = self.comparison().and_then(|found| found.map.as_ref());
        let Some((map, (x, y))) = map.zip(self.efficiency_cursor()) else {
            return Err("no map yet: press r to compute it".to_owned());
        };
        if self.comparison_is_old() {
            return Err("this map belongs to another scene: press r to compute it again".to_owned());
        }
        let values = [(map.x(), x), (map.y(), y)].map(|(axis, at)| (axis, axis.value(at as u64)));
        Ok(placed(self.compared_scene()?, values))
    }

    /// What the map says under its cursor.
    pub fn efficiency_readout(&self) -> Option<String> {
        let map = self.comparison()?.map.as_ref()?;
        let (x, y) = self.efficiency_cursor()?;
        let place = |axis: &Axis, at: usize| {
            format!("{} {}", axis.symbol(), axis.show(axis.value(at as u64), 5))
        };
        let value = match map.cell(x as u64, y as u64) {
            Some(Ok(value)) if value > 1.0 => {
                format!("mass efficiency {}: moving armour pays", significant(value, 4))
            }
            Some(Ok(value)) => {
                format!("mass efficiency {}: it does not pay", significant(value, 4))
            }
            Some(Err(absence)) => absence.words(),
            None => "not computed yet".to_owned(),
        };
        Some(format!("{}, {}: {value}", place(map.x(), x), place(map.y(), y)))
    }
}

/// The verdict in sentences, then the figures of the candidates beside each other, as many as fit.
pub(in crate::tui) fn compared(report: &compare::Report, width: usize) -> Vec<Line> {
    let narrow = width < LABEL + 4 * WIDE_CELL;
    let cell = if narrow { CELL } else { WIDE_CELL };
    let beside = (width.saturating_sub(LABEL) / cell).max(1);
    let sentences = sentences(report).into_iter().map(|text| {
        let is_caution = text.starts_with("caution");
        (if is_caution { Severity::Warning } else { Severity::Note }, text)
    });
    let mut lines: Vec<Line> = Vec::new();
    for (severity, text) in sentences {
        let parts = wrap(&text, width.saturating_sub(GOES_ON.len()));
        lines.extend(
            parts.into_iter().enumerate().map(|(at, part)| {
                (severity, if at == 0 { part } else { format!("{GOES_ON}{part}") })
            }),
        );
    }
    for entries in report.entries.chunks(beside) {
        lines.push(note(String::new()));
        lines.extend(figures(entries, cell));
    }
    lines
}

/// What stands before the further lines of a sentence.
pub(in crate::tui) const GOES_ON: &str = "  ";
/// Columns of a label and of a value, narrow and wide.
const LABEL: usize = 13;
const CELL: usize = 9;
const WIDE_CELL: usize = 13;

/// The figures of some candidates beside each other.
fn figures(entries: &[compare::Entry], cell: usize) -> Vec<Line> {
    // Of `rigid mount` the first word says it.
    let narrow = cell < WIDE_CELL;
    let head = |word: &'static str| word.split(' ').next().filter(|_| narrow).unwrap_or(word);
    let row = |label: &str, cells: Vec<String>| {
        let cells =
            cells.iter().fold(String::new(), |line, text| line + &format!(" {text:>0$}", cell - 1));
        note(format!("{label:LABEL$}{cells}"))
    };
    let heads = entries.iter().map(|entry| head(entry.candidate.word()).to_owned());
    let mut lines = vec![row("", heads.collect())];
    let outcomes = entries.iter().map(|entry| entry.outcome.to_string()).collect();
    lines.push(row("outcome", outcomes));
    let figures: [(&str, &str, &str); 12] = [
        ("mass_efficiency", "efficiency", ""),
        ("mass_efficiency_as_built", "as built", ""),
        ("areal_mass_kg_m2", "areal mass", "kg/m2"),
        ("limit_velocity_m_s", "limit", "m/s"),
        ("perforation_velocity_m_s", "perforation", "m/s"),
        ("stroke_m", "stroke", "m"),
        ("stroke_at_limit_m", "at limit", "m"),
        ("stored_energy_j", "energy", "J"),
        ("peak_mount_force_n", "mount force", "N"),
        ("peak_mount_force_at_limit_n", "at limit", "N"),
        ("mount_impulse_n_s", "impulse", "N s"),
        ("penetration_m", "depth", "m"),
    ];
    let table = report::compare::figures(entries);
    for (name, label, unit) in figures {
        let figure = table.columns.iter().find(|figure| figure.key == name);
        let show = |value: Option<f64>| match (value, unit) {
            (None, _) => "-".to_owned(),
            (Some(value), "" | "kg/m2") => significant(value, 4),
            // Without a prefix: velocities side by side are to be compared.
            (Some(value), "m/s") => format!("{} m/s", significant(value, 3)),
            (Some(value), unit) => Engineering { value, unit, digits: 3 }.to_string(),
        };
        let cells =
            entries.iter().map(|entry| show(figure.and_then(|it| (it.get)(&entry).as_f64())));
        lines.push(row(label, cells.collect()));
    }
    lines
}
