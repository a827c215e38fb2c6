//! A measured force-displacement curve: as points within a scene file, or in a CSV file beside it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use toml::Spanned;
use toml::de::DeValue;

use crate::files::clean;
use crate::files::error::FileError;
use crate::files::read::{self, Reader, kind_of, number};

/// The key of a table of each spring.
pub(super) const KEYS: [&str; 2] = ["mechanism.spring.table", "mechanism.second.table"];

/// The points of a `[mechanism.spring.table]`; a problem is noted and `None` returned where there are none.
pub(super) fn points(
    reader: &mut Reader<'_>,
    key: &str,
    value: &Spanned<DeValue<'_>>,
) -> Option<Arc<[[f64; 2]]>> {
    let DeValue::Table(table) = value.get_ref() else {
        let text = format!(
            "{key} is {}: it is a table; write [{key}] with file = \"curve.csv\" or points = [[x, F], ...] below it",
            kind_of(value.get_ref())
        );
        reader.problem(value.span(), text);
        return None;
    };
    let mut found = None;
    for (name, value) in table {
        let read = match name.get_ref().as_ref() {
            "points" => listed(value.get_ref()).ok_or_else(|| {
                format!(
                    "{key}.points = {} is no list of pairs: write points = [[x, F], ...] with x in m and F in N",
                    reader.shown(value)
                )
            }),
            "file" => match value.get_ref() {
                DeValue::String(file) => ordinary_points(&beside(reader.file(), file)),
                _ => Err(format!(
                    "{key}.file = {} is {}: it must be text; write the name of a CSV file in quotes",
                    reader.shown(value),
                    kind_of(value.get_ref())
                )),
            },
            other => Err(format!("`{key}.{other}` is not a key of a scene: the keys here are file, points")),
        };
        match read {
            Ok(points) if found.is_none() => found = Some(points),
            Ok(_) => reader.problem(
                value.span(),
                format!("{key} has both file and points: leave one of them out"),
            ),
            Err(text) => reader.problem(value.span(), text),
        }
    }
    found.map(Arc::from)
}

/// The points of a measured curve in a CSV file.
///
/// # Errors
/// [`FileError::Curve`] when the file cannot be read or is no table of numbers.
pub fn curve(path: &Path) -> Result<Arc<[[f64; 2]]>, FileError> {
    csv_points(path).map(Arc::from).map_err(FileError::Curve)
}

/// The same, of an ordinary file only: for whoever cannot wait for a pipe.
///
/// # Errors
/// As [`curve`].
pub fn ordinary_curve(path: &Path) -> Result<Arc<[[f64; 2]]>, FileError> {
    ordinary_points(path).map(Arc::from).map_err(FileError::Curve)
}

/// The path of a file named in a scene: relative to the scene's own folder.
fn beside(scene: &str, file: &str) -> PathBuf {
    Path::new(scene).parent().map_or_else(|| PathBuf::from(file), |folder| folder.join(file))
}

fn listed(value: &DeValue<'_>) -> Option<Vec<[f64; 2]>> {
    let DeValue::Array(list) = value else {
        return None;
    };
    list.iter()
        .map(|pair| match pair.get_ref() {
            DeValue::Array(pair) if pair.len() == 2 => {
                let value = |at: usize| number(pair.get(at)?.get_ref());
                Some([value(0)?, value(1)?])
            }
            _ => None,
        })
        .collect()
}

/// The points in a CSV file: displacement in m and force in N, the first two columns; a line of names may come first.
///
/// # Errors
/// One line that names the file, the line, what is wrong and the cure.
fn csv_points(path: &Path) -> Result<Vec<[f64; 2]>, String> {
    points_in(&read::text_file(path).map_err(|error| error.to_string())?, path)
}

/// The same for a file that a scene names: nobody sees that it would be waited for.
fn ordinary_points(path: &Path) -> Result<Vec<[f64; 2]>, String> {
    let text =
        read::ordinary_text_file(path, read::BYTES_MAX).map_err(|error| error.to_string())?;
    points_in(&text, path)
}

fn points_in(text: &str, path: &Path) -> Result<Vec<[f64; 2]>, String> {
    const SHOWN_MAX: usize = 80;
    let name = path.to_string_lossy();
    let shown = clean::line(&name);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut points = Vec::new();
    for (index, row) in reader.records().enumerate() {
        let row = row.map_err(|error| format!("cannot read `{shown}` as CSV: {error}"))?;
        let finite = |number: &f64| number.is_finite();
        let field = |at: usize| row.get(at).and_then(|field| field.parse().ok()).filter(finite);
        let line = row.position().map_or(index as u64 + 1, csv::Position::line);
        match (field(0), field(1)) {
            (Some(x), Some(force)) => points.push([x, force]),
            (None, None) if index == 0 => {}
            _ => {
                return Err(format!(
                    "`{shown}`, line {line}: `{}` is no point: write displacement in m and force in N, separated by a comma, \
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
    Ok(points)
}
