//! CSV texts as programs and test machines write them. Does not depend on the file system.

use std::borrow::Cow;

/// A CSV text as programs and test machines write it: values separated by commas, semicolons or tabs, decimal commas where commas do
/// not separate, comment lines after `#`, the units in the headings or in a line of their own below them.
pub struct Csv {
    /// The headings, each with its unit, and their line; none where the first line has a number.
    pub headings: Option<(u64, Vec<String>)>,
    /// The fields of the other lines, each with its line.
    pub rows: Vec<(u64, Vec<String>)>,
    has_decimal_commas: bool,
}

impl Csv {
    /// Read a text; in words, what cannot be read.
    pub fn read(text: &str) -> Result<Self, String> {
        // The line after a row is known where each ends in LF.
        let text: String =
            text.trim_start_matches('\u{feff}').lines().flat_map(|line| [line, "\n"]).collect();
        let is_row = |line: &&str| !line.starts_with('#');
        let separates =
            |sign: &u8| text.lines().filter(is_row).any(|line| line.contains(char::from(*sign)));
        let separator = [b';', b'\t'].into_iter().find(separates).unwrap_or(b',');
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .delimiter(separator)
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let mut rows = Vec::new();
        let mut row = csv::StringRecord::new();
        while reader.read_record(&mut row).map_err(|error| error.to_string())? {
            let fields = row.iter().map(str::to_owned).collect();
            rows.push((reader.position().line() - 1, fields));
        }
        let mut csv = Self { headings: None, rows, has_decimal_commas: separator != b',' };
        csv.headings = csv.words();
        if csv.headings.is_some()
            && let Some((_, units)) = csv.words()
            && let Some((_, headings)) = &mut csv.headings
        {
            for (heading, unit) in headings.iter_mut().zip(units) {
                *heading = format!("{heading} ({})", unit.trim_matches(['(', ')', '[', ']']));
            }
        }
        Ok(csv)
    }

    /// The first line, taken away, if it has no number.
    fn words(&mut self) -> Option<(u64, Vec<String>)> {
        let (_, first) = self.rows.first()?;
        let is_words = first.iter().all(|field| self.number(field).is_none());
        is_words.then(|| self.rows.remove(0))
    }

    /// The finite number in a field; `None` for any other text.
    pub fn number(&self, field: &str) -> Option<f64> {
        self.with_points(field).parse().ok().filter(|number: &f64| number.is_finite())
    }

    /// A field with decimal points, also where the text has decimal commas.
    pub fn with_points<'f>(&self, field: &'f str) -> Cow<'f, str> {
        if self.has_decimal_commas { field.replace(',', ".").into() } else { field.into() }
    }
}
