//! A measured force-displacement curve: as points within a scene file, or in a CSV file beside it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeValue, ValueDeserializer};

use crate::files::clean;
use crate::files::error::FileError;
use crate::files::read::{self, Accepts, Reader};

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

/// The points of a measured curve in a CSV file: displacement in m and force in N, the first two columns; a line of names may come
/// first.
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

fn points_in(text: &str, path: &Path) -> Result<Arc<[[f64; 2]]>, String> {
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
