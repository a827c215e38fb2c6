//! Runs as CSV text (RFC 4180): series, uniform grid, results, events.
//!
//! One header row, SI units named in the header, shortest digits that read back to the same float, an empty field where a
//! quantity does not exist. Where the text goes is [`crate::files::export`]'s business.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::files::error::FileError;
use crate::model::run::{Event, Run, Sample};
use crate::model::units;
use crate::study::quantities::of_runs;

/// Which rows a table has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rows {
    /// The solver's steps and enough between them to draw from.
    Series,
    /// A uniform grid of this many rows (at least 2) from the first to the last moment, linear between the rows of the series.
    Grid(usize),
    /// One row per run: its results.
    Results,
    /// The events.
    Events,
}

/// A run and the name it goes by (`now`, `A`, ...).
pub type NamedRun = (String, Arc<Run>);

/// A number of the series.
type Column = (&'static str, fn(&Sample) -> f64);

const NUMBERS: [Column; 10] = [
    ("time_s", |row| row.t_s),
    ("penetration_m", |row| row.penetration_m),
    ("projectile_displacement_m", |row| row.projectile_displacement_m),
    ("projectile_velocity_m_s", |row| row.projectile_velocity_m_s),
    ("plate_displacement_m", |row| row.plate_displacement_m),
    ("plate_velocity_m_s", |row| row.plate_velocity_m_s),
    ("contact_force_n", |row| row.contact_force_n),
    ("spring_force_n", |row| row.spring_force_n),
    ("damper_force_n", |row| row.damper_force_n),
    ("stop_force_n", |row| row.stop_force_n),
];

/// The names of all columns a table of these rows has.
pub fn columns(rows: Rows, several: bool) -> Vec<&'static str> {
    let mut names = match rows {
        Rows::Series | Rows::Grid(_) => {
            let mut names: Vec<&str> = NUMBERS.iter().map(|(name, _)| *name).collect();
            names.insert(1, "mode");
            names.push("event");
            names
        }
        Rows::Results => {
            let mut names = vec!["scene", "outcome", "end", "method"];
            names.extend(of_runs().map(|column| column.name));
            names
        }
        Rows::Events => vec!["time_s", "event"],
    };
    if several || rows == Rows::Results {
        names.insert(0, "run");
    }
    names
}

/// The CSV text of some runs; `wanted` names the columns in order, empty means all.
///
/// # Errors
/// [`FileError::Column`] when a wanted column does not exist; [`FileError::Csv`] should a row be malformed.
pub fn text(rows: Rows, runs: &[NamedRun], wanted: &[String]) -> Result<String, FileError> {
    head(rows, runs, wanted, usize::MAX)
}

/// The same, of each run no more than so many rows: what a table would look like, whatever its length.
///
/// # Errors
/// As [`text`].
pub fn head(
    rows: Rows,
    runs: &[NamedRun],
    wanted: &[String],
    most: usize,
) -> Result<String, FileError> {
    let header = columns(rows, runs.len() > 1);
    let chosen = choose(&header, wanted)?;
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(chosen.iter().map(|at| header[*at]))?;
    let mut outcome = Ok(());
    for (name, run) in runs {
        let mut left = most;
        // Row by row: a table of a million rows is large enough as text.
        each_row(rows, run, &mut |mut row| {
            if header[0] == "run" {
                row.insert(0, name.clone());
            }
            outcome = writer.write_record(chosen.iter().map(|at| row[*at].as_str()));
            left -= 1;
            if left > 0 && outcome.is_ok() {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        });
        if outcome.is_err() {
            break;
        }
    }
    outcome?;
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn choose(header: &[&'static str], wanted: &[String]) -> Result<Vec<usize>, FileError> {
    if wanted.is_empty() {
        return Ok((0..header.len()).collect());
    }
    let place = |name: &String| {
        header
            .iter()
            .position(|have| have == name)
            .ok_or_else(|| FileError::Column { name: name.clone(), columns: header.join(", ") })
    };
    wanted.iter().map(place).collect()
}

/// Takes one row after the other; `Break` has had enough.
type Take<'t> = &'t mut dyn FnMut(Vec<String>) -> ControlFlow<()>;

/// Give away the rows of one run.
fn each_row(rows: Rows, run: &Run, take: Take<'_>) {
    // Who has had enough is no news to anybody.
    let _ = match rows {
        Rows::Series => series_rows(run.series.iter(), &run.events, take),
        Rows::Grid(count) => series_rows(grid(&run.series, count).iter(), &run.events, take),
        Rows::Results => take(result_row(run)),
        Rows::Events => run
            .events
            .iter()
            .map(|event| vec![number(event.t_s), event.kind.words().to_owned()])
            .try_for_each(take),
    };
}

/// A number; an empty field for one that does not exist.
fn number(value: f64) -> String {
    if value.is_finite() { units::shortest(value) } else { String::new() }
}

/// One text row per sample; an event stands in the first row at or after its time.
fn series_rows<'s>(
    series: impl ExactSizeIterator<Item = &'s Sample>,
    events: &[Event],
    take: Take<'_>,
) -> ControlFlow<()> {
    let mut waiting = events.iter().peekable();
    let count = series.len();
    for (index, sample) in series.enumerate() {
        let is_last = index + 1 == count;
        let mut row: Vec<String> = NUMBERS.iter().map(|(_, get)| number(get(sample))).collect();
        row.insert(1, sample.mode.word().to_owned());
        let mut words: Vec<&str> = Vec::new();
        while let Some(event) = waiting.next_if(|event| is_last || event.t_s <= sample.t_s) {
            words.push(event.kind.words());
        }
        row.push(words.join("; "));
        take(row)?;
    }
    ControlFlow::Continue(())
}

fn result_row(run: &Run) -> Vec<String> {
    let mut row = vec![
        run.scene.title.clone(),
        run.outcome.word().to_owned(),
        run.end.words().to_owned(),
        run.cost.method.to_owned(),
    ];
    row.extend(of_runs().map(|it| it.value(run).map(number).unwrap_or_default()));
    row
}

/// The series at `count` equal distances in time.
fn grid(series: &[Sample], count: usize) -> Vec<Sample> {
    let (Some(first), Some(last)) = (series.first(), series.last()) else {
        return Vec::new();
    };
    let count = count.max(2);
    let mut after = 0;
    (0..count)
        .map(|index| {
            let share = index as f64 / (count - 1) as f64;
            let t_s = if index + 1 == count {
                last.t_s
            } else {
                first.t_s + share * (last.t_s - first.t_s)
            };
            // Where two rows share a moment, the later one holds from there on.
            while after < series.len() && series[after].t_s <= t_s {
                after += 1;
            }
            let low = &series[after.saturating_sub(1)];
            series.get(after).map_or(*low, |high| between(low, high, t_s))
        })
        .collect()
}

fn between(low: &Sample, high: &Sample, t_s: f64) -> Sample {
    let share = (t_s - low.t_s) / (high.t_s - low.t_s);
    let mix = |get: fn(&Sample) -> f64| get(low) + share * (get(high) - get(low));
    Sample {
        t_s,
        mode: low.mode,
        penetration_m: mix(|row| row.penetration_m),
        projectile_displacement_m: mix(|row| row.projectile_displacement_m),
        projectile_velocity_m_s: mix(|row| row.projectile_velocity_m_s),
        plate_displacement_m: mix(|row| row.plate_displacement_m),
        plate_velocity_m_s: mix(|row| row.plate_velocity_m_s),
        contact_force_n: mix(|row| row.contact_force_n),
        spring_force_n: mix(|row| row.spring_force_n),
        damper_force_n: mix(|row| row.damper_force_n),
        stop_force_n: mix(|row| row.stop_force_n),
        is_step: share == 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::run::{EventKind, Mode};

    fn sample(t_s: f64, penetration_m: f64, mode: Mode) -> Sample {
        Sample {
            t_s,
            mode,
            penetration_m,
            projectile_displacement_m: 0.0,
            projectile_velocity_m_s: 0.0,
            plate_displacement_m: 0.0,
            plate_velocity_m_s: 0.0,
            contact_force_n: 0.0,
            spring_force_n: 0.0,
            damper_force_n: 0.0,
            stop_force_n: 0.0,
            is_step: true,
        }
    }

    fn jump() -> Vec<Sample> {
        vec![
            sample(0.0, 0.0, Mode::Penetrating),
            sample(1.0, 2.0, Mode::Penetrating),
            sample(1.0, 5.0, Mode::Fused),
            sample(2.0, 5.0, Mode::Fused),
        ]
    }

    #[test]
    fn a_grid_is_linear_between_rows_and_keeps_jumps() {
        let grid = grid(&jump(), 5);
        let depths: Vec<f64> = grid.iter().map(|row| row.penetration_m).collect();
        assert_eq!(depths, [0.0, 1.0, 5.0, 5.0, 5.0]);
        assert_eq!(grid[1].mode, Mode::Penetrating);
        assert_eq!(grid[2].mode, Mode::Fused);
        assert!(super::grid(&[], 5).is_empty());
        assert_eq!(super::grid(&jump()[..1], 5).len(), 5);
    }

    #[test]
    fn each_event_stands_once_and_none_is_lost() {
        let events = [
            (1.0, EventKind::FirstArrest),
            (1.0, EventKind::NoseBuried),
            (3.0, EventKind::GreatestDisplacement),
        ]
        .map(|(t_s, kind)| Event { t_s, kind });
        let mut rows = Vec::new();
        let _ = series_rows(jump().iter(), &events, &mut |row| {
            rows.push(row);
            ControlFlow::Continue(())
        });
        let words: Vec<&str> = rows.iter().map(|row| row.last().unwrap().as_str()).collect();
        assert_eq!(words, ["", "first arrest; nose buried", "", "greatest displacement"]);
    }
}
