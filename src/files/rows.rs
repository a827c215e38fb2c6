//! A table of values for machines: the same rows as CSV (RFC 4180) or as a JSON list of objects.
//!
//! A value that does not exist is null in JSON and an empty field in CSV. Floats are written with the shortest digits that
//! read back to the same number.

use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::Value;

use crate::files::error::FileError;
use crate::model::units;

/// Named columns and rows of as many values.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// Keys, in order.
    pub columns: Vec<&'static str>,
    /// The rows.
    pub rows: Vec<Vec<Value>>,
}

/// A number; null for one that does not exist or that JSON cannot say.
pub fn number(value: Option<f64>) -> Value {
    value.and_then(serde_json::Number::from_f64).map_or(Value::Null, Value::Number)
}

/// A row with its keys, in their order; a map would sort them.
struct Entries<'a>(&'a [&'static str], &'a [Value]);

impl Serialize for Entries<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.1.len()))?;
        for (key, value) in self.0.iter().zip(self.1) {
            map.serialize_entry(key, value)?;
        }
        map.end()
    }
}

impl Rows {
    /// As CSV.
    ///
    /// # Errors
    /// [`FileError::Csv`] should a row be malformed.
    pub fn csv(&self) -> Result<String, FileError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(&self.columns)?;
        for row in &self.rows {
            writer.write_record(row.iter().map(field))?;
        }
        let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// With the warnings of the whole table in every row.
    #[must_use]
    pub fn with_warnings(&self, warnings: &[String]) -> Self {
        let mut own = self.clone();
        own.columns.push("warnings");
        let text = warnings.join("; ");
        for row in &mut own.rows {
            row.push(Value::from(text.as_str()));
        }
        own
    }

    /// As a JSON list of objects.
    pub fn json(&self) -> String {
        let list: Vec<Entries<'_>> =
            self.rows.iter().map(|row| Entries(&self.columns, row)).collect();
        // Keys are strings and every number is finite, so nothing can be refused.
        serde_json::to_string_pretty(&list).unwrap_or_default() + "\n"
    }
}

fn field(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::Number(number) => match number.as_f64() {
            Some(float) if number.is_f64() => units::shortest(float),
            _ => number.to_string(),
        },
        Value::String(text) => text.clone(),
        Value::Bool(_) | Value::Array(_) | Value::Object(_) => value.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms_keep_order_digits_and_what_does_not_exist() {
        let rows = Rows {
            columns: vec!["name", "depth_m", "steps"],
            rows: vec![
                vec![Value::from("a, b"), number(Some(0.1 + 0.2)), Value::from(3)],
                vec![Value::from("c"), number(None), number(Some(f64::NAN))],
            ],
        };
        assert_eq!(
            rows.csv().unwrap(),
            "name,depth_m,steps\n\"a, b\",0.30000000000000004,3\nc,,\n"
        );
        let back: Vec<serde_json::Map<String, Value>> = serde_json::from_str(&rows.json()).unwrap();
        assert_eq!(back[0]["depth_m"], number(Some(0.1 + 0.2)));
        assert_eq!(back[1]["steps"], Value::Null);
        assert!(rows.json().find("name") < rows.json().find("depth_m"));
    }
}
