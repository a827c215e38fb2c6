//! A measured force-displacement curve: as points within a scene file, or in a CSV file beside it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeValue, ValueDeserializer};

use crate::files::clean;
use crate::files::error::FileError;
use crate::files::read::{self, Accepts, Reader};
use crate::model::units::{self, Bare, Dimension};

/// The key of a table of each spring.
pub(super) const KEYS: [&str; 2] = ["mechanism.spring.table", "mechanism.second.table"];

/// The table as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct Curve {
    points: Option<Vec<[f64; 2]>>,
    file: Option<Spanned<String>>,
}

/// The points of a `[mechanism.spring.table]`; a problem is noted and `None` returned where there are none.
pub(super) fn points(
    reader: &mut Reader<'_>,
    key: &str,
    value: &Spanned<DeValue<'_>>,
) -> Option<Arc<[[f64; 2]]>> {
    let read = Curve::deserialize(ValueDeserializer::from(value.clone()));
    let found = match read {
        Ok(Curve { points: Some(points), file: None }) => Ok(points.into()),
        Ok(Curve { points: None, file: Some(file) }) => {
            // The wait for a pipe named in a scene would be invisible.
            curve(&beside(reader.file(), file.get_ref()), Accepts::Ordinary)
                .map_err(|error| (file.span(), error.to_string()))
        }
        Ok(Curve { points: Some(_), file: Some(_) }) => {
            let text = format!("{key} has both file and points: omit one of them");
            Err((value.span(), text))
        }
        Ok(Curve { points: None, file: None }) => return None,
        Err(error) => {
            let what = read::misfit(&error);
            let text = format!(
                "{key}: {what}; write file = \"curve.csv\" or points = [[x, F], ...] with x in m and F in N"
            );
            Err((error.span().unwrap_or_else(|| value.span()), text))
        }
    };
    found.map_err(|(span, text)| reader.problem(span, text)).ok()
}

/// The points of a measured curve in a CSV file: displacement and force, the first two columns; a line of names may come first. They
/// are in m and N unless the names end in other units: `x_mm,F_kN` or `travel (in),force (lbf)`. An end in brackets or after `_` or `/`
/// must be a unit.
///
/// # Errors
/// [`FileError`] when the file cannot be read, or names the file, the line, what is wrong and the cure.
pub fn curve(path: &Path, accepts: Accepts) -> Result<Arc<[[f64; 2]]>, FileError> {
    let text = read::text_file(path, accepts, read::BYTES_MAX)?;
    points_in(&text, path).map_err(FileError::Refused)
}

/// The path of a file named in a scene: relative to the scene's own folder.
fn beside(scene: &str, file: &str) -> PathBuf {
    Path::new(scene).parent().map_or_else(|| PathBuf::from(file), |folder| folder.join(file))
}

/// What a heading ends in, where that must be a unit, or may be one.
fn end(heading: &str) -> Option<(&str, bool)> {
    if let Some(inner) = heading.strip_suffix([')', ']']) {
        return inner.rsplit_once(['(', '[']).map(|(_, end)| (end.trim(), true));
    }
    let at = heading.rfind(['_', '/', ' '])?;
    Some((&heading[at + 1..], !heading[at..].starts_with(' ')))
}

/// The unit that a heading ends in, in that of the stored quantity; `None` without one of its kind.
fn unit(heading: &str, quantity: Dimension) -> Option<f64> {
    let (unit, _) = end(heading)?;
    // Columns of tables end in `_n`.
    if unit.eq_ignore_ascii_case(quantity.unit()) {
        return Some(1.0);
    }
    units::parse(&format!("1 {unit}"), quantity, Bare::Stored).ok().filter(|_| !unit.is_empty())
}

/// The rows of a CSV text, each with its line, with any number of fields; `name` is that of the file, for errors.
///
/// # Errors
/// In words, what cannot be read.
pub(super) fn csv_rows(text: &str, name: &str) -> Result<Vec<(u64, csv::StringRecord)>, String> {
    // The line after a row is known where each ends in LF.
    let text: String =
        text.trim_start_matches('\u{feff}').lines().flat_map(|line| [line, "\n"]).collect();
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let (mut rows, mut row) = (Vec::new(), csv::StringRecord::new());
    let broken = |error| format!("cannot read `{name}` as CSV: {error}");
    while reader.read_record(&mut row).map_err(broken)? {
        rows.push((reader.position().line() - 1, row.clone()));
    }
    Ok(rows)
}

fn points_in(text: &str, path: &Path) -> Result<Arc<[[f64; 2]]>, String> {
    const SHOWN_MAX: usize = 80;
    let name = path.to_string_lossy();
    let shown = clean::line(&name);
    let mut points = Vec::new();
    let mut units = [1.0; 2];
    for (index, (line, row)) in csv_rows(text, &shown)?.iter().enumerate() {
        let finite = |number: &f64| number.is_finite();
        let field = |at: usize| row.get(at).and_then(|field| field.parse().ok()).filter(finite);
        match (field(0), field(1)) {
            (Some(x), Some(force)) => points.push([units[0] * x, units[1] * force]),
            (None, None) if index == 0 => {
                let [x, force] = [0, 1].map(|at| row.get(at).unwrap_or_default());
                let swapped = unit(x, Dimension::Force).or_else(|| unit(force, Dimension::Length));
                if swapped.is_some() {
                    return Err(format!(
                        "`{shown}`, line {line}: `{}` names a force before a displacement: write displacement first, then force",
                        clean::line(&format!("{x},{force}"))
                    ));
                }
                for (at, heading, quantity) in
                    [(0, x, Dimension::Length), (1, force, Dimension::Force)]
                {
                    let found = unit(heading, quantity);
                    if let Some((word, true)) = end(heading).filter(|_| found.is_none()) {
                        return Err(format!(
                            "`{shown}`, line {line}: `{}` is not a unit of `{}`: write mm, m, N, kN or lbf, or no unit for m \
                             and N",
                            clean::line(word),
                            clean::line(heading)
                        ));
                    }
                    units[at] = found.unwrap_or(1.0);
                }
            }
            _ => {
                return Err(format!(
                    "`{shown}`, line {line}: `{}` is not a point: write displacement in m and force in N, separated by a comma, \
                     as in 0.01,1000",
                    clean::line(
                        &row.iter()
                            .collect::<Vec<_>>()
                            .join(",")
                            .chars()
                            .take(SHOWN_MAX)
                            .collect::<String>()
                    )
                ));
            }
        }
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
        assert!(points("F_kN,x_mm").unwrap_err().contains("write displacement first"));
    }
}
