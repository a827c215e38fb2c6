//! Reader of measured traces, or histories of another program, from a CSV file: a column of time and columns of quantities.
//!
//! See `Csv` for the allowed forms. Lines above the headings and columns of other quantities are ignored.

use std::path::Path;

use crate::files::clean;
use crate::files::error::{FileError, shown};
use crate::files::inputs;
use cmra_engine::model::units::{self, Bare, Dimension};
use cmra_studies::report::series::Channel;
use cmra_studies::report::traces::{Trace, Traces};
use cmra_studies::study::csv::Csv;

/// Maximum size of a file, bytes: some millions of rows.
const BYTES_MAX: u64 = 1 << 26;

/// Standard acceleration of gravity, m/s^2: the unit g.
const GRAVITY: f64 = 9.80665;

/// Maximum number of columns of a file.
const TRACES_MAX: usize = 40;

/// Kind of the unit of a quantity.
#[derive(Clone, Copy)]
enum Kind {
    Time,
    Length,
    Velocity,
    Force,
    Acceleration,
}

impl Kind {
    /// Returns a unit in stored units; `None` if the text is not a unit of this kind.
    fn factor(self, text: &str) -> Option<f64> {
        let text = text.trim();
        let of = |dimension: Dimension, text: &str| {
            if text.is_empty() {
                return None;
            }
            if text.eq_ignore_ascii_case(dimension.unit()) {
                return Some(1.0);
            }
            units::parse(&format!("1 {text}"), dimension, Bare::Stored).ok()
        };
        let quotient = |ends: &[&str]| {
            // `mm/ms`, as in solvers, and `m_s`, as in headings.
            let (over, under) = text.split_once(['/', '_'])?;
            let under = ends.iter().find_map(|end| under.strip_suffix(end))?;
            Some((of(Dimension::Length, over)?, of(Dimension::Time, under)?))
        };
        match self {
            Self::Time if text.eq_ignore_ascii_case("sec") => Some(1.0),
            Self::Time => of(Dimension::Time, text),
            Self::Length => of(Dimension::Length, text),
            Self::Force => of(Dimension::Force, text),
            Self::Velocity => of(Dimension::Velocity, text).or_else(|| {
                let (length, time) = quotient(&[""])?;
                Some(length / time)
            }),
            Self::Acceleration if text == "g" || text == "G" => Some(GRAVITY),
            Self::Acceleration => {
                let (length, time) = quotient(&["^2", "2", "²"])?;
                Some(length / (time * time))
            }
        }
    }

    /// Returns the allowed units, for error messages.
    fn allowed(self) -> &'static str {
        match self {
            Self::Time => "s, ms or us",
            Self::Length => "m, mm or in",
            Self::Velocity => "m/s, mm/ms or ft/s",
            Self::Force => "N, kN or lbf",
            Self::Acceleration => "m/s2, mm/ms2 or g",
        }
    }
}

/// Quantity with the words of its heading.
struct Named {
    channel: Channel,
    kind: Kind,
    /// Groups of words; the heading has a word of each group.
    words: &'static [&'static [&'static str]],
    /// Letter of the quantity, which is a heading by itself.
    symbol: &'static str,
}

const PLATE: &[&str] = &["plate", "target", "armour", "armor", "panel"];
const SHOT: &[&str] = &["projectile", "bullet", "striker", "impactor", "nose", "tup"];
const TRAVEL: &[&str] = &["displacement", "travel", "deflection", "position", "stroke"];

/// Quantities; the first match counts, so that general names come last.
const QUANTITIES: [Named; 13] = [
    named(Channel::Penetration, Kind::Length, &[&["penetration", "depth", "indentation"]], "p"),
    named(Channel::ProjectileDisplacement, Kind::Length, &[SHOT, TRAVEL], "s"),
    named(Channel::PlateDisplacement, Kind::Length, &[TRAVEL], "x"),
    named(Channel::PlateVelocity, Kind::Velocity, &[PLATE, &["velocity", "speed"]], "w"),
    named(Channel::ProjectileVelocity, Kind::Velocity, &[&["velocity", "speed"]], "v"),
    named(Channel::Acceleration, Kind::Acceleration, &[&["acceleration", "deceleration"]], "a"),
    named(Channel::SpringForce, Kind::Force, &[&["spring"], &["force", "load"]], "F_spring"),
    named(Channel::DamperForce, Kind::Force, &[&["damper"], &["force", "load"]], "F_damper"),
    named(
        Channel::MountForceOverTime,
        Kind::Force,
        &[&["mount", "support", "reaction"], &["force", "load"]],
        "F_mount",
    ),
    named(Channel::MountForceOverTime, Kind::Force, &[&["load cell", "load_cell"]], "F_mount"),
    named(Channel::ContactForce, Kind::Force, &[&["contact", "impact"], &["force", "load"]], "F"),
    named(Channel::ContactForce, Kind::Force, &[&["force", "load"]], "F"),
    named(Channel::ContactForce, Kind::Force, &[&["interface"], &["force", "load"]], "F"),
];

const fn named(
    channel: Channel,
    kind: Kind,
    words: &'static [&'static [&'static str]],
    symbol: &'static str,
) -> Named {
    Named { channel, kind, words, symbol }
}

/// Returns the first word of a heading, without its unit.
fn symbol(heading: &str) -> &str {
    let end = heading.find([' ', '(', '[', '/']).unwrap_or(heading.len());
    heading[..end].trim()
}

/// Returns the quantity of a heading; `None` for others.
fn quantity(heading: &str) -> Option<&'static Named> {
    let lower = heading.to_lowercase();
    // The force of a stop has no curve, and only the acceleration of the projectile has one.
    let is_other = lower.starts_with("stop")
        || lower.contains("celeration") && PLATE.iter().any(|word| lower.contains(word));
    let fits =
        |it: &&Named| it.words.iter().all(|group| group.iter().any(|word| lower.contains(word)));
    let by_words = QUANTITIES.iter().find(fits).filter(|_| !is_other);
    let is_symbol = |it: &&Named| {
        let first = symbol(heading);
        let stem = first.split_once('_').map_or(first, |(stem, _)| stem);
        first == it.symbol || stem == it.symbol && unit_of(heading, it.kind).is_ok()
    };
    by_words.or_else(|| QUANTITIES.iter().filter(|_| !is_other).find(is_symbol))
}

/// Returns `true` for a heading of time.
fn is_time(heading: &str) -> bool {
    let lower = heading.trim().to_lowercase();
    let words: Vec<&str> = lower.split(|c: char| !c.is_alphanumeric()).collect();
    let is_unit = ["s", "ms", "us", "sec"].contains(&lower.trim_matches(['(', ')', '[', ']']));
    words.contains(&"time") || words.first() == Some(&"t") || is_unit
}

/// Returns the unit of a heading in stored units, 1 without a unit; the error is the text that is not a unit.
fn unit_of(heading: &str, kind: Kind) -> Result<f64, String> {
    let heading = heading.trim();
    if let Some(inner) = heading.strip_suffix([')', ']']) {
        let (_, unit) = inner.rsplit_once(['(', '[']).unwrap_or(("", inner));
        // A note in brackets is not a unit.
        return kind.factor(unit).ok_or_else(|| unit.trim().to_owned());
    }
    // The longest suffix that is a unit: `m_s` in `velocity_m_s`.
    let starts = heading.char_indices().filter(|(_, c)| ['_', ' ', '/', ','].contains(c));
    let ends: Vec<&str> = starts.map(|(at, _)| &heading[at + 1..]).collect();
    if let Some(factor) = ends.iter().chain([&heading]).find_map(|end| kind.factor(end)) {
        return Ok(factor);
    }
    // The text after a slash or an underscore is a unit; after a blank it is part of the name.
    match heading.rfind(['_', '/']) {
        Some(at) if !heading[at..].contains(' ') && !is_word(&heading[at + 1..]) => {
            Err(heading[at + 1..].to_owned())
        }
        _ => Ok(1.0),
    }
}

/// Returns `true` if the suffix of a heading is part of its name, as in `plate_velocity`.
fn is_word(end: &str) -> bool {
    let lower = end.to_lowercase();
    let all = QUANTITIES.iter().flat_map(|it| it.words).flat_map(|group| group.iter());
    let mut all = all.chain(["time", "test", "run"].iter());
    all.any(|word| lower.contains(word)) || lower.chars().all(|c| c.is_ascii_digit())
}

/// Reads the traces of a file.
///
/// # Errors
/// A [`FileError`] with the problem, its position and the expected form.
pub fn traces(path: &Path) -> Result<Traces, FileError> {
    let text = inputs::text_file(path, BYTES_MAX)?;
    traces_in(&text, &shown(path)).map_err(FileError::Refused)
}

/// Turns the lines above the headings into comments; line numbers are unchanged.
fn without_header(text: &str) -> String {
    let is_heading = |line: &str| {
        let fields: Vec<&str> =
            line.split([',', ';', '\t']).map(|field| field.trim().trim_matches('"')).collect();
        fields.len() > 1
            && !line.starts_with(['#', '%'])
            && fields.iter().any(|field| is_time(field))
            && fields.iter().any(|field| quantity(field).is_some())
    };
    let Some(above) = text.lines().position(is_heading) else { return text.to_owned() };
    let line =
        |(at, line): (usize, &str)| if at < above { "#".to_owned() } else { line.to_owned() };
    text.lines().enumerate().map(line).collect::<Vec<_>>().join("\n") + "\n"
}

/// Example of headings, for error messages.
const EXAMPLE: &str = "as in `time_ms,penetration_mm,contact_force_kN`";

#[expect(
    clippy::too_many_lines,
    reason = "one pass over headings and rows, with an error for each"
)]
fn traces_in(text: &str, name: &str) -> Result<Traces, String> {
    let text = without_header(text.trim_start_matches('\u{feff}'));
    let csv = Csv::read(&text).map_err(|error| format!("cannot read `{name}` as CSV: {error}"))?;
    let at = |line: u64, problem: &str| format!("`{name}`, line {line}: {problem}");
    let Some((line, headings)) = &csv.headings else {
        return Err(format!("`{name}` has no headings: name its columns, {EXAMPLE}"));
    };
    let times: Vec<usize> = (0..headings.len()).filter(|at| is_time(&headings[*at])).collect();
    let list = |places: &[usize]| {
        let names: Vec<String> =
            places.iter().map(|at| format!("`{}`", clean::line(&headings[*at]))).collect();
        names.join(", ")
    };
    let time = match times[..] {
        [time] => time,
        [] => {
            let all: Vec<usize> = (0..headings.len()).collect();
            let problem = format!("no column of time among {}: name one, {EXAMPLE}", list(&all));
            return Err(at(*line, &problem));
        }
        _ => {
            let problem = format!(
                "{} are columns of time: keep one, and write traces with times of their own to files of their own",
                list(&times)
            );
            return Err(at(*line, &problem));
        }
    };
    let factor = |column: usize, kind: Kind| {
        unit_of(&headings[column], kind).map_err(|unit| {
            let problem = format!(
                "`{}` is not a unit of `{}`: write {}, {EXAMPLE}",
                clean::line(&unit),
                clean::line(&headings[column]),
                kind.allowed()
            );
            at(*line, &problem)
        })
    };
    let time_factor = factor(time, Kind::Time)?;
    let mut columns = Vec::new();
    for (column, heading) in headings.iter().enumerate().filter(|(column, _)| *column != time) {
        let Some(found) = quantity(heading).filter(|_| columns.len() < TRACES_MAX) else {
            continue;
        };
        let sign = if heading.to_lowercase().contains("deceleration") { -1.0 } else { 1.0 };
        let trace = Trace {
            heading: clean::line(heading).into_owned(),
            channel: found.channel,
            points: Vec::with_capacity(csv.rows.len()),
        };
        columns.push((column, sign * factor(column, found.kind)?, trace));
    }
    if columns.is_empty() {
        let others: Vec<usize> = (0..headings.len()).filter(|at| *at != time).collect();
        let problem = format!(
            "of the columns {} none is a penetration, plate displacement, plate or projectile velocity, contact or mount force, or \
             acceleration: name one so, {EXAMPLE}",
            list(&others)
        );
        return Err(at(*line, &problem));
    }
    let mut before_s = f64::NEG_INFINITY;
    for (line, row) in &csv.rows {
        let field = |column: usize| row.get(column).map_or("", |field| field.trim());
        let number = |column: usize| {
            csv.number(field(column)).ok_or_else(|| {
                let text: String = field(column).chars().take(40).collect();
                let problem = format!(
                    "`{}` in column `{}` is not a number: correct it, or leave the field empty",
                    clean::line(&text),
                    clean::line(&headings[column])
                );
                at(*line, &problem)
            })
        };
        let t_s = time_factor * number(time)?;
        if t_s < before_s {
            let problem = format!(
                "the time falls from {} to {} s: sort the rows by time, and give each trace a column of its own",
                units::shortest(before_s),
                units::shortest(t_s)
            );
            return Err(at(*line, &problem));
        }
        before_s = t_s;
        for (column, factor, trace) in &mut columns {
            // An empty cell is a missing measurement.
            if field(*column).is_empty() || field(*column).eq_ignore_ascii_case("nan") {
                continue;
            }
            trace.points.push((t_s, *factor * number(*column)?));
        }
    }
    let traces = columns.into_iter().map(|(.., trace)| trace);
    let traces: Vec<Trace> = traces.filter(|trace| !trace.points.is_empty()).collect();
    if traces.is_empty() {
        return Err(format!("`{name}` has headings but no row of numbers: add its rows"));
    }
    Ok(Traces { name: name.to_owned(), traces })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Traces, String> {
        traces_in(text, "T.csv")
    }

    fn first(text: &str) -> (Channel, (f64, f64)) {
        let found = read(text).unwrap();
        (found.traces[0].channel, found.traces[0].points[0])
    }

    fn near(found: (f64, f64), exact: (f64, f64), what: &str) {
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
        assert!(close(found.0, exact.0) && close(found.1, exact.1), "{what}: {found:?} {exact:?}");
    }

    /// 0.2 ms and 3 of each quantity, as several programs and test machines write them.
    #[test]
    fn headings_say_quantity_and_unit() {
        use Channel as C;
        for (headings, row, channel, value) in [
            ("time_s,penetration_m", "2e-4,3", C::Penetration, 3.0),
            ("time_ms,depth (mm)", "0.2,3", C::Penetration, 3e-3),
            ("t [us],p [mm]", "200,3", C::Penetration, 3e-3),
            ("Time (ms),Target displacement (mm)", "0.2,3", C::PlateDisplacement, 3e-3),
            ("time_s,projectile_velocity_m_s", "2e-4,3", C::ProjectileVelocity, 3.0),
            ("time_s,plate_velocity_m_s", "2e-4,3", C::PlateVelocity, 3.0),
            ("Time/ms,Velocity/mm/ms", "0.2,3", C::ProjectileVelocity, 3.0),
            ("time_ms,plate velocity", "0.2,3", C::PlateVelocity, 3.0),
            ("time_ms,Contact force (kN)", "0.2,3", C::ContactForce, 3e3),
            ("time_ms,Load cell [lbf]", "0.2,3", C::MountForceOverTime, 3.0 * 4.448_221_615_260_5),
            ("time_ms,spring_force_n", "0.2,3", C::SpringForce, 3.0),
            ("time_ms,acceleration (g)", "0.2,3", C::Acceleration, 3.0 * 9.80665),
            ("time_ms,deceleration (mm/ms2)", "0.2,3", C::Acceleration, -3e3),
            ("time_ms,a_m_s2", "0.2,3", C::Acceleration, 3.0),
        ] {
            let (found, point) = first(&format!("{headings}\n{row}\n"));
            assert_eq!(found, channel, "{headings}");
            near(point, (2e-4, value), headings);
        }
    }

    #[test]
    fn files_are_read_as_they_come() {
        for text in [
            "# LS-DYNA\n# rcforc\ntime_ms,force_kN\n0.2,3\n",
            "Test 12; 2024-05-01\nRate;100000\n\nTime;Force\nms;kN\n0,2;3,0\n",
            "\u{feff}Time\tForce\r\n(ms)\t(kN)\r\n0.2\t3\r\n",
            "% matlab\ntime_ms,strain,force_kN\n0.2,9,3\n",
        ] {
            let (channel, point) = first(text);
            assert_eq!(channel, Channel::ContactForce, "{text}");
            near(point, (2e-4, 3e3), text);
        }
        // Several traces of one quantity, one with gaps; other columns do not count.
        let text = "time_ms,force 1 (kN),force 2 (kN),note\n0,1,,a\n1,2,5,b\n1,3,NaN,c\n";
        let found = read(text).unwrap();
        let counts: Vec<usize> = found.traces.iter().map(|trace| trace.points.len()).collect();
        assert_eq!(counts, [3, 1]);
    }

    #[test]
    fn what_cannot_be_read_has_a_line_and_a_cure() {
        for (text, told) in [
            (
                "x_mm,force_kN\n0,1\n",
                "line 1: no column of time among `x_mm`, `force_kN`: name one",
            ),
            ("time_s,t_ms,force_kN\n0,0,1\n", "`time_s`, `t_ms` are columns of time: keep one"),
            (
                "time_ms,force_kN\n0,1\n1,2\n0.5,3\n",
                "line 4: the time falls from 0.001 to 0.0005 s: sort the rows",
            ),
            (
                "time_fortnight,force_kN\n0,1\n",
                "`fortnight` is not a unit of `time_fortnight`: write s, ms or us",
            ),
            (
                "time_ms,force (kgf)\n0,1\n",
                "`kgf` is not a unit of `force (kgf)`: write N, kN or lbf",
            ),
            ("time_ms,velocity (furlong/ms)\n0,1\n", "`furlong/ms` is not a unit"),
            ("time_ms,strain\n0,1\n", "of the columns `strain` none is a penetration"),
            (
                "time_ms,force_kN\n0,1\n1,OVER\n",
                "line 3: `OVER` in column `force_kN` is not a number",
            ),
            ("0,1\n1,2\n", "has no headings"),
            ("time_ms,force_kN\n", "no row of numbers"),
            ("time_ms,force_kN\n,1\n", "line 2: `` in column `time_ms` is not a number"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(told) && !error.contains('\n'), "{text}: {error}");
        }
    }

    /// Traces written by the program are read back to the last digit.
    #[test]
    fn a_hundred_thousand_rows_keep_their_digits() {
        let row = |at| format!("\n{},{}", f64::from(at) * 0.01, f64::from(at) * 1e-4);
        let rows: Vec<String> = (0..100_000).map(row).collect();
        let text = format!("time_us,penetration_mm{}\n", rows.concat());
        let found = read(&text).unwrap();
        assert_eq!(found.traces[0].points.len(), 100_000);
        near(found.traces[0].points[99_999], (999.99e-6, 9.9999e-3), "the last row");
    }
}
