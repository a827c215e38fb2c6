//! A sweep as rows for machines: CSV and JSON, one row a point, made piece by piece so that 10^8 rows need no memory.
//!
//! Axis values first, then what was asked for; an empty field (JSON: null) where a quantity does not exist; `error` last, which
//! says why a point failed. The time a point took is left out: it would make no two files equal.

use std::fmt::Write as _;
use std::ops::Range;

use crate::files::error::FileError;
use crate::model::run::{Run, envelope};
use crate::model::scene::Scene;
use crate::model::units;
use crate::model::variables;
use crate::study::quantities::of_every_run;
use crate::study::sweep::grid::Grid;
use crate::study::sweep::{Axis, Evaluator, Fate, Plan, Rows, Shard, Spacing};
use crate::study::validity;

/// Which columns stand after the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Columns {
    /// The outcome and the plan's outputs.
    Chosen,
    /// Everything `cmra run --json` tells of a run in one field; the plan's outputs must then be all results.
    All,
}

/// Which texts are made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Texts {
    /// Lines of CSV.
    pub csv: bool,
    /// Objects of JSON, separated by commas.
    pub json: bool,
}

/// A piece of a sweep as text.
#[derive(Debug, Default)]
pub struct Piece {
    /// What came out.
    pub rows: Rows,
    /// Lines of CSV, if asked for.
    pub csv: Vec<u8>,
    /// Objects of JSON, if asked for.
    pub json: String,
}

/// A field of a row.
enum Field<'a> {
    None,
    Number(f64),
    Text(&'a str),
    Long(String),
}

/// Makes the rows of a sweep.
#[derive(Clone, Debug)]
pub struct Sheet<'p> {
    plan: &'p Plan,
    scene: &'p str,
    columns: Columns,
    texts: Texts,
    names: Vec<&'static str>,
}

impl<'p> Sheet<'p> {
    /// The sheet of a plan on the scene of this name.
    pub fn new(plan: &'p Plan, scene: &'p str, columns: Columns, texts: Texts) -> Self {
        let mut names: Vec<&str> = plan.axes().iter().map(Axis::symbol).collect();
        match columns {
            Columns::Chosen => {
                names.push("outcome");
                names.extend(plan.outputs().iter().map(|output| output.name));
            }
            Columns::All => {
                names.extend(["scene", "model", "interface", "outcome", "end"]);
                names.extend(of_every_run().map(|column| column.name));
                names.extend(["method", "omitted", "warnings"]);
            }
        }
        names.push("error");
        Self { plan, scene, columns, texts, names }
    }

    /// The names of all columns.
    pub fn names(&self) -> &[&'static str] {
        &self.names
    }

    /// The header line of the CSV.
    ///
    /// # Errors
    /// [`FileError::Csv`] should it be malformed.
    pub fn header(&self) -> Result<Vec<u8>, FileError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(&self.names)?;
        finished(writer)
    }

    /// Compute a piece and make its texts; fewer rows than points when the evaluator was stopped.
    ///
    /// # Errors
    /// [`FileError::Csv`] should a row be malformed.
    pub fn piece(
        &self,
        evaluator: &mut Evaluator<'_>,
        points: Range<u64>,
    ) -> Result<Piece, FileError> {
        let mut out = Out {
            csv: csv::Writer::from_writer(Vec::new()),
            json: String::new(),
            names: &self.names,
            texts: self.texts,
        };
        let rows = match self.columns {
            Columns::Chosen => {
                let rows = evaluator.rows(points.clone());
                if self.texts != Texts::default() {
                    for (row, index) in points.take(rows.len()).enumerate() {
                        out.row(self.chosen(index, &rows, row))?;
                    }
                }
                rows
            }
            Columns::All => {
                let mut rows = Rows::new(self.plan.outputs().len());
                for index in points {
                    let Some((fate, run)) = evaluator.one(index, &mut rows) else { break };
                    out.row(self.all(index, fate, run.as_ref().ok()))?;
                }
                rows
            }
        };
        Ok(Piece { rows, csv: finished(out.csv)?, json: out.json })
    }

    fn axes(&self, index: u64) -> impl Iterator<Item = Field<'_>> {
        let count = self.plan.axes().len();
        (0..count).map(move |axis| Field::Number(self.plan.coordinate(index, axis)))
    }

    fn chosen<'a>(
        &'a self,
        index: u64,
        rows: &'a Rows,
        row: usize,
    ) -> impl Iterator<Item = Field<'a>> {
        let fate = rows.fate(row);
        let values =
            (0..self.plan.outputs().len()).map(move |output| number(rows.value(row, output)));
        self.axes(index).chain([Field::Text(fate.word())]).chain(values).chain([reason(fate)])
    }

    fn all<'a>(
        &'a self,
        index: u64,
        fate: Fate,
        run: Option<&'a Run>,
    ) -> impl Iterator<Item = Field<'a>> {
        let base = self.plan.base();
        let of = move |get: fn(&'a Run) -> Field<'a>| run.map_or(Field::None, get);
        let told = run.filter(|_| !matches!(fate, Fate::Failed(_)));
        let results = of_every_run().map(move |it| number(told.and_then(|run| it.value(run))));
        self.axes(index)
            .chain([
                Field::Text(self.scene),
                word(base, "contact.model"),
                word(base, "interface.law"),
                Field::Text(fate.word()),
                of(|run| Field::Text(run.end.words())),
            ])
            .chain(results)
            .chain([
                of(|run| Field::Text(run.cost.method)),
                of(|run| list(run.omitted.iter().map(|omitted| omitted.words().to_owned()))),
                of(|run| list(envelope::warnings(run).into_iter())),
                reason(fate),
            ])
    }

    /// The head of the JSON: the sweep itself, up to the rows.
    pub fn json_head(&self, shard: Shard) -> String {
        let mut text = String::from("{\n");
        let _ = writeln!(text, "  \"scene\": {},", quoted(self.scene));
        let _ = writeln!(text, "  \"design\": {},", quoted(self.plan.design().word()));
        let seed = self.plan.design().seed().map_or_else(|| "null".to_owned(), |it| it.to_string());
        let _ = writeln!(text, "  \"seed\": {seed},");
        let _ = writeln!(text, "  \"points\": {},", self.plan.points());
        let part = shard.of(self.plan.points());
        let _ = writeln!(text, "  \"from_point\": {}, \"to_point\": {},", part.start, part.end);
        let axes: Vec<String> = self.plan.axes().iter().map(axis_json).collect();
        let _ = writeln!(text, "  \"axes\": [{}],", axes.join(", "));
        let outputs: Vec<String> =
            self.plan.outputs().iter().map(|output| quoted(output.name)).collect();
        let _ = writeln!(text, "  \"outputs\": [{}],", outputs.join(", "));
        let _ = writeln!(text, "  \"version\": {},", quoted(env!("CARGO_PKG_VERSION")));
        let warnings = validity::of_axes(self.plan.base(), self.plan.axes());
        let warnings: Vec<String> = warnings.iter().map(|text| quoted(text)).collect();
        let _ = writeln!(text, "  \"warnings\": [{}],", warnings.join(", "));
        text + "  \"rows\": [\n"
    }
}

/// The points of a grid that are there as a whole CSV, in the order of the sweep.
///
/// # Errors
/// [`FileError::Csv`] should a row be malformed.
pub fn grid_csv(scene: &str, grid: &Grid) -> Result<Vec<u8>, FileError> {
    let plan = grid.plan();
    let texts = Texts { csv: true, json: false };
    let sheet = Sheet::new(plan, scene, Columns::Chosen, texts);
    let mut out = Out {
        csv: csv::Writer::from_writer(Vec::new()),
        json: String::new(),
        names: &sheet.names,
        texts,
    };
    out.csv.write_record(&sheet.names)?;
    let (along, up) = grid.counts();
    for (index, (x, y)) in (0..).zip((0..along).flat_map(|x| (0..up).map(move |y| (x, y)))) {
        let Some(fate) = grid.fate(x, y) else { continue };
        let values = (0..plan.outputs().len()).map(|output| number(grid.value(x, y, output)));
        let outcome = [Field::Text(fate.word())];
        out.row(sheet.axes(index).chain(outcome).chain(values).chain([reason(fate)]))?;
    }
    finished(out.csv)
}

/// The end of the JSON, after the rows.
pub const JSON_TAIL: &str = "\n  ]\n}\n";

fn axis_json(axis: &Axis) -> String {
    let (from, to) = axis.ends();
    if axis.spacing() == Spacing::Listed {
        let values: Vec<String> = axis.list().iter().map(|value| units::shortest(*value)).collect();
        let values = values.join(", ");
        return format!("{{ \"name\": {}, \"values\": [{values}] }}", quoted(axis.symbol()));
    }
    format!(
        "{{ \"name\": {}, \"from\": {}, \"to\": {}, \"count\": {}, \"log\": {} }}",
        quoted(axis.symbol()),
        units::shortest(from),
        units::shortest(to),
        axis.count(),
        axis.spacing() == Spacing::Log
    )
}

/// Where rows become text.
struct Out<'a> {
    csv: csv::Writer<Vec<u8>>,
    json: String,
    names: &'a [&'static str],
    texts: Texts,
}

impl Out<'_> {
    fn row<'f>(&mut self, fields: impl Iterator<Item = Field<'f>>) -> Result<(), FileError> {
        if self.texts.json {
            self.json.push_str(if self.json.is_empty() { "    { " } else { ",\n    { " });
        }
        for (place, (name, field)) in self.names.iter().zip(fields).enumerate() {
            if self.texts.json {
                let comma = if place == 0 { "" } else { ", " };
                let _ = write!(self.json, "{comma}\"{name}\": {}", in_json(&field));
            }
            if self.texts.csv {
                match field {
                    Field::None => self.csv.write_field("")?,
                    Field::Number(value) => self.csv.write_field(units::shortest(value))?,
                    Field::Text(text) => self.csv.write_field(text)?,
                    Field::Long(text) => self.csv.write_field(text)?,
                }
            }
        }
        if self.texts.json {
            self.json.push_str(" }");
        }
        if self.texts.csv {
            self.csv.write_record(None::<&[u8]>)?;
        }
        Ok(())
    }
}

fn finished(writer: csv::Writer<Vec<u8>>) -> Result<Vec<u8>, FileError> {
    writer.into_inner().map_err(|error| FileError::Csv(error.into_error().into()))
}

fn number(value: Option<f64>) -> Field<'static> {
    value.filter(|value| value.is_finite()).map_or(Field::None, Field::Number)
}

fn reason(fate: Fate) -> Field<'static> {
    match fate {
        Fate::Failed(failure) => Field::Text(failure.words()),
        Fate::Arrested | Fate::Perforated | Fate::Separated | Fate::Moving => Field::None,
    }
}

fn word(scene: &Scene, key: &str) -> Field<'static> {
    variables::find(key).map_or(Field::None, |variable| Field::Long(variable.show(scene)))
}

fn list(items: impl Iterator<Item = String>) -> Field<'static> {
    Field::Long(items.collect::<Vec<_>>().join("; "))
}

/// A field in JSON: the shortest digits of a finite number are JSON as they are.
fn in_json(field: &Field<'_>) -> String {
    match field {
        Field::Number(value) => units::shortest(*value),
        Field::None => "null".to_owned(),
        Field::Text(text) => quoted(text),
        Field::Long(text) => quoted(text),
    }
}

fn quoted(text: &str) -> String {
    // A text can always be said.
    serde_json::to_string(text).unwrap_or_default()
}
