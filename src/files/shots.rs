//! Shots of a ballistic test, read from CSV. SI.

use std::path::Path;

use crate::files::clean;
use crate::files::error::{FileError, did_you_mean};
use crate::files::read::{self, Accepts};
use crate::files::read_table;
use crate::study::fit::MeasuredShot;

/// The columns that are read; the first two are needed.
const COLUMNS: [&str; 4] = ["velocity_m_s", "perforated", "residual_m_s", "penetration_m"];
const SHOWN_MAX: usize = 40;

/// The shots of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// In the order of the file.
    pub shots: Vec<MeasuredShot>,
    /// Columns that mean nothing here.
    pub ignored: Vec<String>,
}

/// Read a file of shots.
///
/// # Errors
/// [`FileError`] when it cannot be read, or names the line, the column, what is allowed and the cure.
pub fn read(path: &Path) -> Result<Table, FileError> {
    let text = read::text_file(path, Accepts::Handed, read::BYTES_MAX)?;
    parse(&text, &path.to_string_lossy()).map_err(FileError::Refused)
}

fn parse(text: &str, name: &str) -> Result<Table, String> {
    let name = clean::line(name);
    let mut rows = read_table::csv_rows(text, &name)?.into_iter();
    let (_, header) = rows.next().unwrap_or_default();
    let place = |column: &str| header.iter().position(|it| it.eq_ignore_ascii_case(column));
    let places = COLUMNS.map(place);
    for (column, found) in COLUMNS.iter().zip(places).take(2) {
        if found.is_none() {
            return Err(format!(
                "`{name}` has no column `{column}`: its first line must name the columns {} (the last two are optional)",
                COLUMNS.join(", ")
            ));
        }
    }
    let is_known = |it: &&str| COLUMNS.iter().any(|column| it.eq_ignore_ascii_case(column));
    let ignored: Vec<String> = header
        .iter()
        .filter(|it| !it.is_empty() && !is_known(it))
        .map(|it| {
            let meant =
                did_you_mean(it, &COLUMNS).map_or_else(String::new, |text| format!(" ({text})"));
            clean::line(it).into_owned() + &meant
        })
        .collect();
    let mut shots = Vec::new();
    for (line, row) in rows {
        if row.len() != header.len() {
            return Err(format!(
                "`{name}`, line {line}: it has {} fields, and the first line names {} columns: write each, empty where unknown",
                row.len(),
                header.len()
            ));
        }
        let field = |at: usize| places[at].and_then(|place| row.get(place)).unwrap_or_default();
        let wrong = |at: usize, allowed: &str| {
            let shown: String = clean::line(field(at)).chars().take(SHOWN_MAX).collect();
            format!("`{name}`, line {line}: {} = `{shown}` must be {allowed}", COLUMNS[at])
        };
        let value = |at: usize, allowed: &str| match field(at) {
            "" => Ok(None),
            text => match text.parse::<f64>() {
                Ok(value) if value.is_finite() && value >= 0.0 => Ok(Some(value)),
                _ => Err(wrong(at, allowed)),
            },
        };
        let above = "a number above 0, in m/s";
        let velocity_m_s = value(0, above)?.filter(|v| *v > 0.0).ok_or_else(|| wrong(0, above))?;
        let perforated = match field(1).to_lowercase().as_str() {
            "1" | "true" | "yes" => true,
            "0" | "false" | "no" => false,
            _ => return Err(wrong(1, "1 or yes (through), 0 or no (stopped)")),
        };
        let residual_m_s = value(2, "a number of 0 or more, in m/s, or empty")?;
        let penetration_m = value(3, "a number of 0 or more, in m, or empty")?;
        if residual_m_s.is_some_and(|residual| residual > velocity_m_s) {
            return Err(wrong(2, "no greater than velocity_m_s"));
        }
        if !perforated && residual_m_s.is_some_and(|residual| residual > 0.0) {
            return Err(wrong(2, "empty or 0 for a shot that was stopped"));
        }
        shots.push(MeasuredShot {
            velocity_m_s,
            perforated,
            residual_m_s: residual_m_s.filter(|_| perforated),
            penetration_m: penetration_m.filter(|depth| *depth > 0.0),
        });
    }
    Ok(Table { shots, ignored })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_of_shots_is_read() {
        let text = "\u{feff}shot,Velocity_m_s,perforated,residual,penetration_m\n# a comment\n1,250.5,no,,0.011\n2,300,1,,\n";
        let table = parse(text, "shots.csv").unwrap();
        assert_eq!(table.ignored, ["shot", "residual (did you mean `residual_m_s`?)"]);
        assert_eq!(table.shots.len(), 2);
        assert_eq!(
            table.shots[0],
            MeasuredShot {
                velocity_m_s: 250.5,
                perforated: false,
                residual_m_s: None,
                penetration_m: Some(0.011)
            }
        );
        assert!(table.shots[1].perforated);
    }

    #[test]
    fn errors_are_reported_with_line_and_cure() {
        let told = |text: &str| parse(text, "a.csv").unwrap_err();
        assert!(told("v,perforated\n1,1\n").contains("has no column `velocity_m_s`"));
        let head = "velocity_m_s,perforated,residual_m_s,penetration_m\n";
        for (row, said) in [
            ("fast,1,,", "line 2: velocity_m_s = `fast` must be a number above 0"),
            ("-3,1,,", "velocity_m_s = `-3`"),
            ("0,1,,", "velocity_m_s = `0`"),
            ("inf,1,,", "velocity_m_s = `inf`"),
            ("NaN,1,,", "velocity_m_s = `NaN`"),
            ("300,maybe,,", "perforated = `maybe` must be 1 or yes (through), 0 or no (stopped)"),
            ("300,1,310,", "residual_m_s = `310` must be no greater than velocity_m_s"),
            ("300,0,10,", "must be empty or 0 for a shot that was stopped"),
            ("300,0,,x", "penetration_m = `x`"),
        ] {
            let text = told(&format!("{head}{row}\n"));
            assert!(text.contains(said), "{row}: {text}");
        }
        let short = told(&format!("{head}300,1,,\r\n\r\n1,1\r\n"));
        assert!(short.contains("line 4: it has 2 fields, and the first line names 4"), "{short}");
    }
}
