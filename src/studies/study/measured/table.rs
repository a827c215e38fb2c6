//! Measurements as a CSV table. Each row is a shot: its inputs as for `--set`, and the measured quantities.

use crate::study::csv::Csv;
use crate::study::library::{Entry, Library};
use cmra_engine::model::scene::{Closure, Core, Mount, Scene};
use cmra_engine::model::units::{self, Bare, Dimension};
use cmra_engine::model::variables::{self, Kind, Value, Variable};

/// Function that returns a library entry by name, or the reason why there is none.
pub type FindEntry<'a> = &'a dyn Fn(Library, &str) -> Result<Entry, String>;

/// Inputs required in every row, given directly or by a library entry.
const REQUIRED: [&str; 4] = ["projectile.mass_kg", RADIUS, THICKNESS, "target.density_kg_m3"];
const RADIUS: &str = "projectile.tip_radius_m";
const THICKNESS: &str = "target.thickness_m";
const CLOSURE: &str = "target.closure";
const DISHING: &str = "target.dishing";
const STRENGTH: &str = "target.flow_strength_pa";
const YIELD: &str = "target.yield_pa";
const MODULUS: &str = "target.modulus_pa";
const VELOCITY: &str = "projectile.velocity_m_s";
const NOSE: &str = "projectile.nose";
const CORE: &str = "projectile.core";

/// Synonyms for noses and cores in tables of measurements: the variable, the word, and its choice.
const SYNONYMS: [(&str, &str, &str); 9] = [
    (NOSE, "ogive", "pointed"),
    (NOSE, "conical", "pointed"),
    (NOSE, "ball", "pointed"),
    (NOSE, "rod", "blunt"),
    (NOSE, "sphere", "hemispherical"),
    (CORE, "lead", "deformable"),
    (CORE, "tungsten", "deformable"),
    (CORE, "rod", "deformable"),
    (CORE, "deforming", "deformable"),
];
/// Synonyms of projectiles that deform, whatever their core.
const DEFORM: [&str; 2] = ["ball", "rod"];

/// Measured quantities of a shot; `None` if not measured.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// Ballistic limit V50, m/s.
    pub limit_m_s: Option<f64>,
    /// Standard deviation of the limit, m/s.
    pub deviation_m_s: Option<f64>,
    /// Depth, m.
    pub depth_m: Option<f64>,
    /// Projectile velocity after perforation, m/s.
    pub residual_velocity_m_s: Option<f64>,
    /// Quantities of a moving plate, in the order of [`OUTPUTS`], SI.
    pub outputs: [Option<f64>; OUTPUTS.len()],
}

/// Measured quantities of a moving plate: the name of the result, and the key of its measurement in files.
pub const OUTPUTS: [(&str, &str); 6] = [
    ("first_arrest_plate_velocity_m_s", "measured_first_arrest_plate_velocity_m_s"),
    ("plate_velocity_after_m_s", "measured_plate_velocity_after_m_s"),
    ("separation_velocity_m_s", "measured_separation_velocity_m_s"),
    ("max_plate_displacement_m", "measured_max_plate_displacement_m"),
    ("max_plate_displacement_time_s", "measured_max_plate_displacement_time_s"),
    ("peak_mount_force_n", "measured_peak_mount_force_n"),
];

impl Measured {
    /// Returns `true` if a quantity other than the limit was measured. Such quantities need a run.
    pub fn needs_run(&self) -> bool {
        let besides = self.depth_m.or(self.residual_velocity_m_s);
        besides.is_some() || self.outputs.iter().any(Option::is_some)
    }
}

/// Column of a measured quantity: its heading, its dimension, and its field of [`Measured`].
type MeasuredColumn = (&'static str, Dimension, fn(&mut Measured) -> &mut Option<f64>);

const MEASURED: [MeasuredColumn; 4 + OUTPUTS.len()] = [
    ("limit_m_s", Dimension::Velocity, |it| &mut it.limit_m_s),
    ("deviation_m_s", Dimension::Velocity, |it| &mut it.deviation_m_s),
    ("depth_m", Dimension::Length, |it| &mut it.depth_m),
    ("residual_velocity_m_s", Dimension::Velocity, |it| &mut it.residual_velocity_m_s),
    (OUTPUTS[0].0, Dimension::Velocity, |it| &mut it.outputs[0]),
    (OUTPUTS[1].0, Dimension::Velocity, |it| &mut it.outputs[1]),
    (OUTPUTS[2].0, Dimension::Velocity, |it| &mut it.outputs[2]),
    (OUTPUTS[3].0, Dimension::Length, |it| &mut it.outputs[3]),
    (OUTPUTS[4].0, Dimension::Time, |it| &mut it.outputs[4]),
    (OUTPUTS[5].0, Dimension::Force, |it| &mut it.outputs[5]),
];

/// Headings without a variable or a measured quantity.
const OTHERS: [&str; 4] = ["threat", "material", "source", "note"];

/// Row of a table of measurements.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// Line of the file, starting at 1.
    pub line: u64,
    /// Scene of the shot, or the reason why it cannot be computed.
    pub scene: Result<Scene, String>,
    /// Measured quantities.
    pub measured: Measured,
    /// Publication or laboratory; may be empty.
    pub source: String,
    /// Remark, such as projectile and target; may be empty.
    pub note: String,
}

/// Column of the table, identified by its heading.
#[derive(Clone, Copy)]
enum Column {
    Variable(&'static Variable),
    Measured(MeasuredColumn),
    Entry(Library),
    Source,
    Note,
}

/// Heading: its column, the name before the unit, and the unit.
struct Heading {
    column: Column,
    text: String,
    name: String,
    unit: Option<String>,
}

/// Reads measured limits from a CSV table. A row that cannot be computed is kept, with the reason.
///
/// # Errors
/// Returns one line with the remedy for an unknown column, a column given twice, or units both in a heading and in its cells.
pub fn read(text: &str, find: FindEntry<'_>) -> Result<Vec<Measurement>, String> {
    let csv = Csv::read(text)?;
    let Some((line, headings)) = &csv.headings else {
        return Err(format!(
            "line 1 has no headings: begin with the names of the columns, for example `R [mm],m_p [g],h [mm],{}`",
            MEASURED[0].0
        ));
    };
    let at = |line: &u64, problem: String| format!("line {line}: {problem}");
    let headings: Vec<Heading> = headings
        .iter()
        .map(|text| Heading::read(text))
        .collect::<Result<_, _>>()
        .map_err(|problem| at(line, problem))?;
    refuse_twice(&headings).map_err(|problem| at(line, problem))?;
    let table = Table { csv: &csv, headings, find };
    table.refuse_mixed_units()?;
    let has_values = |row: &&(u64, Vec<String>)| row.1.iter().any(|cell| !cell.is_empty());
    Ok(csv
        .rows
        .iter()
        .filter(has_values)
        .map(|(line, row)| table.measurement(*line, row))
        .collect())
}

impl Heading {
    fn read(text: &str) -> Result<Self, String> {
        let (name, unit) = split(text);
        let column = column(name).map_err(|hint| format!("`{text}` is no column: {hint}"))?;
        let heading = Self {
            column,
            text: text.to_owned(),
            name: name.to_owned(),
            unit: unit.map(str::to_owned),
        };
        let Some(unit) = unit else { return Ok(heading) };
        let Some(quantity) = heading.dimension() else {
            return Err(format!("`{text}` takes no unit: write `{name}`"));
        };
        let parsed = units::parse(&format!("1 {unit}"), quantity, Bare::Stored);
        parsed.map(|_| heading).map_err(|_problem| {
            format!("`{unit}` is no unit of `{text}`: use {}", quantity.accepted())
        })
    }

    /// Returns the dimension of the numbers in the column; `None` for words.
    fn dimension(&self) -> Option<Dimension> {
        match self.column {
            Column::Variable(variable) => variable.number().map(|number| number.quantity),
            Column::Measured((_, dimension, _)) => Some(dimension),
            Column::Entry(_) | Column::Source | Column::Note => None,
        }
    }

    /// Returns the unit of numbers without one: from the heading, or from the name.
    fn bare(&self) -> Bare<'_> {
        match self.column {
            Column::Variable(variable) => variable.bare(&self.name),
            _ => Bare::Stored,
        }
    }

    /// Parses the number of a cell, in the stored unit.
    fn number(&self, cell: &str, quantity: Dimension) -> Result<f64, String> {
        let parsed = match &self.unit {
            Some(unit) => units::parse(&format!("{cell} {unit}"), quantity, Bare::Stored),
            None => units::parse(cell, quantity, self.bare()),
        };
        parsed.map_err(|problem| format!("{} = `{cell}`: {problem}", self.text))
    }
}

/// Splits a heading into its name and its unit in brackets.
fn split(heading: &str) -> (&str, Option<&str>) {
    let unit = |(open, close)| {
        let (name, unit) = heading.strip_suffix(close)?.rsplit_once(open)?;
        Some((name.trim(), Some(unit.trim())))
    };
    [('[', ']'), ('(', ')')].into_iter().find_map(unit).unwrap_or((heading, None))
}

fn column(name: &str) -> Result<Column, String> {
    if let Some(found) = MEASURED.into_iter().find(|it| it.0 == name) {
        return Ok(Column::Measured(found));
    }
    match name {
        "threat" => return Ok(Column::Entry(Library::Threats)),
        "material" => return Ok(Column::Entry(Library::Materials)),
        "source" => return Ok(Column::Source),
        "note" => return Ok(Column::Note),
        _ => {}
    }
    variables::find(name).map(Column::Variable).map_err(|_problem| {
        let others = MEASURED.iter().map(|it| it.0).chain(OTHERS);
        let near = others.map(|other| (strsim::osa_distance(name, other), other)).collect();
        variables::close("", name, near).unwrap_or_else(|| {
            let (first, last) = name.rsplit_once('_').unwrap_or((name, ""));
            match variables::find(first) {
                Ok(variable) => format!("did you mean `{} [{last}]`?", variable.symbol),
                Err(_) => format!(
                    "{}; besides variables there are {} and {}",
                    variables::nearest(name),
                    MEASURED.map(|it| it.0).join(", "),
                    OTHERS.join(", ")
                ),
            }
        })
    })
}

/// Rejects two columns of the same quantity, such as two units of an input.
fn refuse_twice(headings: &[Heading]) -> Result<(), String> {
    let key = |heading: &Heading| match heading.column {
        Column::Variable(variable) => variable.key.to_owned(),
        _ => heading.name.clone(),
    };
    for (at, heading) in headings.iter().enumerate() {
        if let Some(first) = headings[..at].iter().find(|other| key(other) == key(heading)) {
            return Err(format!(
                "`{}` and `{}` are the same quantity: keep one of the columns",
                first.text, heading.text
            ));
        }
    }
    Ok(())
}

struct Table<'t> {
    csv: &'t Csv,
    headings: Vec<Heading>,
    find: FindEntry<'t>,
}

impl Table<'_> {
    /// Rejects a column in which some numbers have their own unit and others use the heading's unit or none.
    fn refuse_mixed_units(&self) -> Result<(), String> {
        for (at, heading) in self.headings.iter().enumerate() {
            let mut bare: Option<&str> = None;
            let mut with_unit: Option<(u64, &str, &str)> = None;
            for (line, row) in &self.csv.rows {
                let Some(cell) = row.get(at).map(String::as_str) else { continue };
                match units::written_unit(&self.csv.with_points(cell)) {
                    Some("") if self.csv.number(cell) != Some(0.0) => bare = bare.or(Some(cell)),
                    Some("") | None => {}
                    Some(_) if heading.dimension().is_some() => {
                        let unit = units::written_unit(cell).unwrap_or_default();
                        with_unit = with_unit.or(Some((*line, cell, unit)));
                    }
                    Some(_) => {}
                }
            }
            let text = &heading.text;
            match (with_unit, &heading.unit, bare) {
                (Some((line, cell, _)), Some(_), _) => {
                    return Err(format!(
                        "line {line}: `{text}` has a unit and so has `{cell}` below it: write numbers only"
                    ));
                }
                (Some((line, cell, unit)), None, Some(bare)) => {
                    return Err(format!(
                        "line {line}: `{text}` mixes `{cell}` and `{bare}`: write numbers only and the unit once, `{} [{unit}]`",
                        heading.name
                    ));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn measurement(&self, line: u64, row: &[String]) -> Measurement {
        let mut measured = Measured::default();
        let given = self.given(row);
        let mut scene = given.as_ref().map_err(String::clone).and_then(|it| self.scene(row, it));
        for (heading, cell) in self.cells(row) {
            let Column::Measured((name, quantity, place)) = heading.column else { continue };
            // A plate may move in either direction.
            let is_signed =
                quantity == Dimension::Velocity && OUTPUTS.iter().any(|it| it.0 == name);
            match heading.number(&self.csv.with_points(cell), quantity) {
                Ok(value) if value > 0.0 || is_signed => *place(&mut measured) = Some(value),
                Ok(_) => {
                    let problem = format!("{} = `{cell}` must be greater than 0", heading.text);
                    scene = scene.and(Err(problem));
                }
                Err(problem) => scene = scene.and(Err(problem)),
            }
        }
        if measured == Measured::default() {
            let names = MEASURED.map(|it| it.0).join(", ");
            scene = scene.and_then(|_| Err(format!("nothing is measured: fill in one of {names}")));
        }
        if measured.needs_run() && given.is_ok_and(|given| !given.gives(VELOCITY)) {
            let text = "v_i is not given: all but a limit needs the impact velocity";
            scene = scene.and_then(|_| Err(text.to_owned()));
        }
        let text = |is_chosen: fn(&Column) -> bool| {
            let mut cells = self.cells(row);
            cells.find(|it| is_chosen(&it.0.column)).map_or("", |it| it.1).to_owned()
        };
        Measurement {
            line,
            scene,
            measured,
            source: text(|it| matches!(it, Column::Source)),
            note: text(|it| matches!(it, Column::Note)),
        }
    }

    /// Returns the non-blank cells with their headings.
    fn cells<'r>(&'r self, row: &'r [String]) -> impl Iterator<Item = (&'r Heading, &'r str)> {
        let cells = self.headings.iter().zip(row.iter().map(String::as_str));
        cells.filter(|(_, cell)| !cell.is_empty())
    }

    /// Returns the inputs given by a row, directly and by the library entries that it names.
    fn given(&self, row: &[String]) -> Result<Given, String> {
        if row.len() > self.headings.len() {
            let (values, columns) = (row.len(), self.headings.len());
            return Err(format!("{values} values for {columns} columns: quote a text with commas"));
        }
        let mut given = Given { entries: Vec::new(), keys: Vec::new() };
        for (heading, cell) in self.cells(row) {
            match heading.column {
                Column::Entry(library) => given.entries.push((self.find)(library, cell)?),
                Column::Variable(variable) => given.keys.push(variable.key),
                Column::Measured(_) | Column::Source | Column::Note => {}
            }
        }
        Ok(given)
    }

    /// Builds the scene of a row. Defaults are a rigid mount and cylindrical cavity expansion.
    fn scene(&self, row: &[String], given: &Given) -> Result<Scene, String> {
        let mut scene = Scene::default();
        scene.plate.mount = Mount::Rigid;
        (scene.target.closure, scene.target.dishing) = (Closure::Cylindrical, false);
        for entry in &given.entries {
            entry.apply(&mut scene).map_err(|problem| problem.to_string())?;
        }
        for (heading, cell) in self.cells(row) {
            let Column::Variable(variable) = heading.column else { continue };
            let value = match &variable.kind {
                Kind::Number(number) if number.absent != Some(cell) => {
                    Value::Number(heading.number(&self.csv.with_points(cell), number.quantity)?)
                }
                _ => variable
                    .parse(&scene, choice(variable.key, cell), Bare::Stored)
                    .map_err(|problem| problem.to_string())?,
            };
            variable.set(&mut scene, value).map_err(|problem| problem.to_string())?;
        }
        let is_nose =
            |heading: &Heading| matches!(heading.column, Column::Variable(it) if it.key == NOSE);
        if self.cells(row).any(|(heading, cell)| is_nose(heading) && DEFORM.contains(&cell)) {
            scene.projectile.core = Core::Deformable;
        }
        given.complete(&mut scene)?;
        variables::validate(&scene).map_err(|problem| problem.to_string())?;
        Ok(scene)
    }
}

/// Returns the choice of a variable for a word of the table.
fn choice<'c>(key: &str, cell: &'c str) -> &'c str {
    let known = SYNONYMS.iter().find(|it| it.0 == key && it.1 == cell);
    known.map_or(cell, |it| it.2)
}

/// Inputs given by a row.
struct Given {
    /// Library entries named in the row.
    entries: Vec<Entry>,
    /// Keys of the variables with a value in the row.
    keys: Vec<&'static str>,
}

impl Given {
    fn gives(&self, key: &str) -> bool {
        let by_entry = |entry: &Entry| entry.values.iter().any(|value| value.0 == key);
        self.keys.contains(&key) || self.entries.iter().any(by_entry)
    }

    /// Sets the values that follow from these inputs; rejects a row without its required inputs.
    fn complete(&self, scene: &mut Scene) -> Result<(), String> {
        let gives = |key: &str| self.gives(key);
        if !gives(CLOSURE) && gives(STRENGTH) && !gives(YIELD) {
            scene.target.closure = Closure::Given;
        }
        let strength: &[&str] = match scene.closure() {
            Closure::Given => &[STRENGTH],
            Closure::DoubleYield => &[YIELD],
            _ => &[YIELD, MODULUS],
        };
        // A contact model without penetration needs no plate material and no nose.
        let uses = |key: &str| variables::find(key).is_ok_and(|it| variables::is_used(it, scene));
        let is_needed = |key: &str| uses(if key == RADIUS { THICKNESS } else { key });
        let required = REQUIRED.iter().chain(strength).filter(|key| !gives(key) && is_needed(key));
        let missing: Vec<&str> =
            required.filter_map(|key| variables::find(key).ok()).map(|it| it.symbol).collect();
        if !missing.is_empty() {
            return Err(format!(
                "no value of {}: fill in the row, or name a threat or a material that has it",
                missing.join(", ")
            ));
        }
        if !gives(DISHING) {
            // A cavity takes account of the bulge in its strength.
            let closure = scene.target.closure;
            scene.target.dishing = matches!(closure, Closure::Given | Closure::DoubleYield);
        }
        Ok(())
    }
}
