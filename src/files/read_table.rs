//! Reader of measured force-displacement curves: points in a scene file, or a CSV file beside it.

use std::path::Path;
use std::sync::Arc;

use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeValue, ValueDeserializer};

use crate::files::clean;
use crate::files::error::FileError;
use crate::files::inputs;
use crate::files::read;
use crate::files::reader::{self, Reader};
use cmra_engine::model::units::{self, Bare, Dimension};
use cmra_studies::study::csv::Csv;

/// Key of the table of the spring.
pub(super) const SPRING: &str = "mechanism.spring";
/// Key of the table of measured points.
pub(super) const KEY: &str = "mechanism.spring.table";

/// Table as in the file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct Curve {
    points: Option<Vec<[f64; 2]>>,
    file: Option<Spanned<String>>,
}

/// Reads the points of a `[mechanism.spring.table]`; reports a problem and returns `None` without points.
pub(super) fn points(
    reader: &mut Reader<'_>,
    key: &str,
    value: &Spanned<DeValue<'_>>,
) -> Option<Arc<[[f64; 2]]>> {
    let read = Curve::deserialize(ValueDeserializer::from(value.clone()));
    let found = match read {
        Ok(Curve { points: Some(points), file: None }) => Ok(points.into()),
        Ok(Curve { points: None, file: Some(file) }) => {
            // Waiting for a pipe named in a scene would not be visible.
            // The path is relative to the folder of the scene.
            let folder = Path::new(reader.file()).parent().unwrap_or_else(|| Path::new(""));
            curve(&folder.join(file.get_ref())).map_err(|error| (file.span(), error.to_string()))
        }
        Ok(Curve { points: Some(_), file: Some(_) }) => {
            let text = format!("{key} has both file and points: omit one of them");
            Err((value.span(), text))
        }
        Ok(Curve { points: None, file: None }) => return None,
        Err(error) => {
            let what = reader::misfit(&error);
            let text = format!(
                "{key}: {what}; write file = \"curve.csv\" or points = [[x, F], ...] with x in m and F in N"
            );
            Err((error.span().unwrap_or_else(|| value.span()), text))
        }
    };
    found.map_err(|(span, text)| reader.problem(span, text)).ok()
}

/// Reads the points of a measured curve from a CSV file; see `Csv` for the allowed forms.
///
/// The columns of displacement and force are those with a unit or a name of their kind in the heading, such as
/// `time_s,displacement_mm,force_N`; otherwise the first two columns. Without a unit they are in m and N. The end of a heading in brackets,
/// or after `_` or `/`, has to be a unit.
pub fn curve(path: &Path) -> Result<Arc<[[f64; 2]]>, FileError> {
    let text = inputs::text_file(path, read::BYTES_MAX)?;
    points_in(&text, path).map_err(FileError::Refused)
}

/// Returns the unit at the end of a heading, and whether it must be a unit.
fn end(heading: &str) -> Option<(&str, bool)> {
    if let Some(inner) = heading.strip_suffix([')', ']']) {
        return inner.rsplit_once(['(', '[']).map(|(_, end)| (end.trim(), true));
    }
    let at = heading.rfind(['_', '/', ' '])?;
    Some((&heading[at + 1..], !heading[at..].starts_with(' ')))
}

/// Returns the unit at the end of a heading, in stored units; `None` without a unit of this kind.
fn unit(heading: &str, quantity: Dimension) -> Option<f64> {
    let (unit, _) = end(heading)?;
    // Headings of exported tables end in lower-case units such as `_n`.
    if unit.eq_ignore_ascii_case(quantity.unit()) {
        return Some(1.0);
    }
    units::parse(&format!("1 {unit}"), quantity, Bare::Stored).ok().filter(|_| !unit.is_empty())
}

/// Column of a curve: its quantity, and words in its heading that replace a unit.
struct Measured {
    quantity: Dimension,
    letter: &'static str,
    words: &'static [&'static str],
}

const DISPLACEMENT: Measured = Measured {
    quantity: Dimension::Length,
    letter: "x",
    words: &["displacement", "travel", "extension", "stroke", "deflection", "position"],
};
const FORCE: Measured =
    Measured { quantity: Dimension::Force, letter: "F", words: &["force", "load"] };

impl Measured {
    /// Returns the column with a unit of this kind; without one, a column with one of the words.
    fn column(&self, headings: &[String]) -> Option<usize> {
        let is_named = |heading: &String| {
            let lower = heading.to_lowercase();
            let first = heading.split(|c: char| !c.is_alphanumeric()).next();
            self.words.iter().any(|word| lower.contains(word))
                || first.is_some_and(|first| first.eq_ignore_ascii_case(self.letter))
        };
        let has_unit = |heading: &String| unit(heading, self.quantity).is_some();
        headings.iter().position(has_unit).or_else(|| headings.iter().position(is_named))
    }

    /// Returns the unit of a heading in stored units, or an error message.
    fn factor(&self, heading: &str) -> Result<f64, String> {
        let found = unit(heading, self.quantity);
        match end(heading).filter(|_| found.is_none()) {
            Some((word, true)) => Err(format!(
                "`{}` is not a unit of `{}`: write mm, m, N, kN or lbf, or no unit for m and N",
                clean::line(word),
                clean::line(heading)
            )),
            _ => Ok(found.unwrap_or(1.0)),
        }
    }
}

/// Returns the columns of displacement and force, with their units in m and N.
fn columns(headings: &[String]) -> Result<[(usize, f64); 2], String> {
    let found = [DISPLACEMENT, FORCE].map(|measured| measured.column(headings));
    let places = match found {
        [Some(x), Some(force)] if x != force => [x, force],
        [Some(x), _] if headings.len() == 2 => [x, 1 - x],
        [_, Some(force)] if headings.len() == 2 => [1 - force, force],
        [None, None] if headings.len() >= 2 => [0, 1],
        _ => {
            return Err(format!(
                "of the columns `{}` one must be a displacement and one a force: name them so, or give them units, as in \
                 `displacement_mm,force_N`",
                clean::line(&headings.join("`, `"))
            ));
        }
    };
    let [x, force] = places;
    Ok([(x, DISPLACEMENT.factor(&headings[x])?), (force, FORCE.factor(&headings[force])?)])
}

fn points_in(text: &str, path: &Path) -> Result<Arc<[[f64; 2]]>, String> {
    const SHOWN_MAX: usize = 80;
    let name = clean::line(&path.to_string_lossy()).into_owned();
    let csv = Csv::read(text).map_err(|error| format!("cannot read `{name}` as CSV: {error}"))?;
    let at = |line: u64, problem: String| format!("`{name}`, line {line}: {problem}");
    let [x, force] = match &csv.headings {
        None => [(0, 1.0), (1, 1.0)],
        Some((line, headings)) => columns(headings).map_err(|problem| at(*line, problem))?,
    };
    let mut points: Vec<[f64; 2]> = Vec::new();
    for (line, row) in &csv.rows {
        let value = |(column, factor): (usize, f64)| Some(factor * csv.number(row.get(column)?)?);
        let Some(point) = value(x).zip(value(force)).map(<[f64; 2]>::from) else {
            let shown: String = row.join(",").chars().take(SHOWN_MAX).collect();
            let problem = format!(
                "`{}` is not a point: write displacement in m and force in N, as in 0.01,1000",
                clean::line(&shown)
            );
            return Err(at(*line, problem));
        };
        if let Some([before, _]) = points.last().filter(|[before, _]| point[0] < *before) {
            let problem = format!(
                "the displacement falls from {} to {} m, an unloading branch: a spring has one force at each displacement; keep \
                 only the rows of loading",
                units::shortest(*before),
                units::shortest(point[0])
            );
            return Err(at(*line, problem));
        }
        points.push(point);
    }
    Ok(points.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_units_of_the_first_line_are_those_of_the_points() {
        let points = |heading: &str| points_in(&format!("{heading}\n2,3\n"), Path::new("F.csv"));
        let found = |heading: &str| points(heading).unwrap()[0];
        for heading in ["x_m,F_N", "x_m,force_n", "plate travel,mount force", "x,F [N]"] {
            assert_eq!(
                found(heading).map(f64::to_bits),
                [2f64, 3f64].map(f64::to_bits),
                "{heading}"
            );
        }
        for heading in ["x_mm,F_kN", "travel (mm),force (kN)", "x/mm,F/kN"] {
            let [x, force] = found(heading);
            assert!((x - 2e-3).abs() < 1e-17 && (force - 3e3).abs() < 1e-9, "{heading}");
        }
        for (heading, told) in [
            ("x_mm,F_kgf", "`kgf` is not a unit of `F_kgf`: write mm, m, N, kN or lbf"),
            ("travel (mm),force (kg f)", "`kg f` is not a unit"),
            ("x/furlong,F", "`furlong` is not a unit of `x/furlong`"),
        ] {
            let error = points(heading).unwrap_err();
            assert!(error.contains(told), "{error}");
        }
        let wrong = "# measured\r\nx_mm,F_kN\r\n\r\n1,2\r\n3,four\r\n";
        let error = points_in(wrong, Path::new("F.csv")).unwrap_err();
        assert!(error.contains("line 5: `3,four`"), "{error}");
    }

    /// 2 mm and 3 kN, as several programs write them.
    #[test]
    fn a_curve_is_read_as_test_machines_export_it() {
        for text in [
            "time_s,displacement_mm,force_N\n0.1,2,3000\n",
            "F_kN,x_mm\n3,2\n",
            "Time;Displacement;Force\ns;mm;kN\n0,1;2,0;3,0\n",
            "Time\tExtension\tLoad\n(s)\t(mm)\t(N)\n0.1\t2.0\t3e3\n",
            "\u{feff}Travel [mm];Mount force [kN]\r\n2,0;3,0\r\n",
            "0,002;3000\n",
        ] {
            let [x, force] = points_in(text, Path::new("F.csv")).unwrap()[0];
            assert!((x - 2e-3).abs() < 1e-17 && (force - 3e3).abs() < 1e-9, "{text}: {x} {force}");
        }
    }

    #[test]
    fn what_is_no_curve_is_refused_by_name() {
        for (text, told) in [
            (
                "x_mm,F_N\n0,0\n1,10\n0.5,2\n",
                "line 4: the displacement falls from 0.001 to 0.0005 m, an unloading branch",
            ),
            (
                "time_s,strain,force_N\n0,0,0\n",
                "line 1: of the columns `time_s`, `strain`, `force_N` one must be a displacement",
            ),
            ("1.000,5;3\n", "line 1: `1.000,5,3` is not a point"),
        ] {
            let error = points_in(text, Path::new("F.csv")).unwrap_err();
            assert!(error.contains(told), "{error}");
        }
    }
}
