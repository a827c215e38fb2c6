//! A sweep as rows for machines: CSV and JSON, one row a point, made piece by piece so that 10^8 rows need no memory.
//!
//! Axis values first, then what was requested; an empty field (JSON: null) where a quantity does not exist; `error` last, which
//! says why a point failed. No column has the time a point took: files of the same sweep are equal.

use std::rc::Rc;

use serde_json::{Value, json};

use crate::report::figures::sweeps::picture;
use crate::report::page::{CHART, MAP, Page};
use crate::report::table::{Table, listed, pretty, texts};
use crate::report::verdict;
use crate::study::context::Reach;
use crate::study::envelope;
use crate::study::outcome::OutcomeCounts;
use crate::study::quantities::{EXPECTED, LIMIT};
use crate::study::sweep::grid::Grid;
use crate::study::sweep::{Axis, Evaluator, Plan, Point, PointOutcome, Shard, Spacing};
use crate::study::validity;
use crate::study::verdict::Verdict;
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::{Scene, Sweep};
use cmra_engine::model::units::shortest;
use cmra_engine::model::variables;

/// Columns after the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Columns {
    /// The outcome and the plan's outputs.
    Chosen,
    /// Everything `cmra run --json` tells of a run in one field; the plan's outputs must then be all results.
    All,
}

impl Columns {
    /// The sweep as a scene keeps it, which makes the same columns again.
    pub fn sweep(self, plan: &Plan) -> Sweep {
        let outputs = match self {
            Self::Chosen => plan.outputs().iter().map(|output| output.name.to_owned()).collect(),
            // Without outputs all are meant.
            Self::All => Vec::new(),
        };
        Sweep { axes: plan.axes().iter().map(Axis::to_sweep_axis).collect(), outputs }
    }
}

/// A piece of a sweep as text.
#[derive(Debug, Default)]
pub struct Piece {
    /// The results.
    pub points: Vec<Point>,
    /// Lines of CSV, if requested.
    pub csv: String,
    /// Objects of JSON, if requested.
    pub json: String,
}

/// Makes the rows of a sweep.
#[derive(Clone, Debug)]
pub struct SweepWriter<'p> {
    /// The sweep.
    pub plan: &'p Plan,
    /// The name of its scene.
    pub scene: &'p str,
    /// Columns of the table.
    pub columns: Columns,
    /// Whether lines of CSV are made.
    pub has_csv: bool,
    /// Whether objects of JSON are made, separated by commas.
    pub has_json: bool,
}

impl SweepWriter<'_> {
    /// The header line of the CSV.
    pub fn header(&self) -> String {
        self.table(&[], &[], &[]).csv()
    }

    /// Compute a piece and make its texts; fewer rows than points when the evaluator was stopped.
    pub fn piece(&self, evaluator: &mut Evaluator<'_>, points: &[u64]) -> Piece {
        let (found, runs): (Vec<Point>, Vec<Option<Run>>) = match self.columns {
            Columns::Chosen => (evaluator.points(points), Vec::new()),
            Columns::All => points.iter().map_while(|index| evaluator.one(*index)).unzip(),
        };
        let table = self.table(&points[..found.len()], &found, &runs);
        let csv = if self.has_csv { table.csv_rows() } else { String::new() };
        let json = if self.has_json { table.json_rows() } else { String::new() };
        drop(table);
        Piece { points: found, csv, json }
    }

    /// The rows of some points; with all columns the run of each, where there is one. Made for every piece, and of files alone: no
    /// column has a heading.
    fn table<'t>(
        &'t self,
        points: &'t [u64],
        found: &'t [Point],
        runs: &'t [Option<Run>],
    ) -> Table<'t, usize> {
        let is_all = self.columns == Columns::All;
        // None without all columns.
        let run = |row: &usize| runs.get(*row)?.as_ref();
        let mut table = Table::new(0..points.len());
        for (at, axis) in self.plan.axes().iter().enumerate() {
            let value = move |row: &usize| self.plan.coordinate(points[*row], at);
            table = table.field(axis.symbol(), value);
        }
        if is_all {
            let word = |key| word(self.plan.base(), key);
            table = table
                .field("scene", |_| self.scene)
                .field("model", move |_| word("contact.model"))
                .field("interface", move |_| word("interface.law"));
        }
        table = table.field("outcome", move |row| found[*row].outcome.key());
        let verdicts = points.iter().map(|index| Verdict::from_scene(&self.plan.scene(*index)));
        let verdicts: Rc<[Verdict]> = verdicts.collect();
        let words = Rc::clone(&verdicts);
        table = table.field("verdict", move |row| words[*row].decision.word());
        if is_all {
            table = table.field("end", move |row| Some(run(row)?.end.words()));
        }
        for (at, output) in self.plan.outputs().iter().enumerate() {
            let value = move |row: &usize| found[*row].values[at].or_else(|| found[*row].bound(at));
            table = table.field(output.name, value);
        }
        if is_all {
            let of_limit = [LIMIT].into_iter().chain(EXPECTED);
            for key in of_limit.chain(["class", "measurements", "papers"]) {
                let verdicts = Rc::clone(&verdicts);
                table = table.field(key, move |row| verdict::object(&verdicts[*row])[key].clone());
            }
        }
        table = table.field("lower_bounds", |row| self.lower_bounds(&found[*row]));
        if is_all {
            table = table
                .field("method", move |row| Some(run(row)?.cost.method))
                .field("omitted", move |row| Some(run(row)?.omitted.join("; ")))
                .field("warnings", move |row| Some(listed(&envelope::warnings(run(row)?))));
        }
        table.field("error", move |row| found[*row].reason())
    }

    /// The outputs of which a point has a lower bound, since its run ended before they were final.
    fn lower_bounds(&self, point: &Point) -> String {
        let outputs = self.plan.outputs().iter().enumerate();
        let bounds = outputs.filter(|(at, _)| point.bound(*at).is_some());
        bounds.map(|(_, output)| output.name).collect::<Vec<_>>().join("; ")
    }

    /// The head of the JSON: the sweep itself, up to the rows.
    pub fn json_head(&self, shard: Shard) -> String {
        let outputs: Vec<&str> = self.plan.outputs().iter().map(|output| output.name).collect();
        let head = json!({
            "scene": self.scene,
            "points": self.plan.points(),
            "shard": shard.to_string(),
            "axes": self.plan.axes().iter().map(axis_json).collect::<Value>(),
            "outputs": outputs,
            "version": env!("CARGO_PKG_VERSION"),
            "warnings": texts(&validity::of_plan(self.plan)),
        });
        pretty(&head).trim_end_matches(['\n', '}']).to_owned() + ",\n  \"rows\": [\n"
    }
}

/// The points of a grid that are there as a whole CSV, in the order of the sweep.
pub fn grid_csv(scene: &str, grid: &Grid, reach: Reach) -> String {
    let (points, found) = grid.points();
    let (plan, columns) = (grid.plan(), Columns::Chosen);
    let sheet = SweepWriter { plan, scene, columns, has_csv: true, has_json: false };
    sheet.table(&points, &found, &[]).with_reach(reach).csv()
}

/// The end of the JSON, after the rows: how many there are, and whether these are all.
pub fn json_tail(rows: u64, is_complete: bool) -> String {
    format!("\n  ],\n  \"points_done\": {rows},\n  \"complete\": {is_complete}\n}}\n")
}

fn axis_json(axis: &Axis) -> Value {
    if axis.spacing() == Spacing::Listed {
        return json!({ "name": axis.symbol(), "values": axis.list() });
    }
    let (from, to) = axis.ends();
    let is_log = axis.spacing() == Spacing::Log;
    json!({ "name": axis.symbol(), "from": from, "to": to, "count": axis.count(), "log": is_log })
}

/// The word of a variable in a scene.
fn word(scene: &Scene, key: &str) -> Option<String> {
    variables::find(key).ok().map(|variable| variable.show(scene))
}

/// Maximum number of rows of the table of a sweep with one axis.
const TABLE_ROWS: u64 = 13;

/// Returns the page of a sweep; `how` has the run time and the number of threads.
pub fn page(
    title: &str,
    plan: &Plan,
    (ended, how): (OutcomeCounts, &str),
    kept: Option<&Grid>,
) -> Page {
    let axes: Vec<String> = plan.axes().iter().map(axis_words).collect();
    let mut page = Page::new(format!("{title}: {}", axes.join("; ")));
    page.line(format!("{} points {how}", ended.total()));
    page.space();
    if let Some(grid) = kept.filter(|grid| grid.is_complete()) {
        for output in 0..plan.outputs().len() {
            drawn(&mut page, grid, output);
        }
        if let [axis] = plan.axes() {
            values(&mut page, grid, axis);
        }
    }
    page.line(ended.to_string());
    page
}

fn axis_words(axis: &Axis) -> String {
    if axis.spacing() == Spacing::Listed {
        let unit = axis.variable().unit();
        let values = format!("{} = {} {unit}", axis.symbol(), axis.range().replace(',', ", "));
        return format!("{}, {} points", values.trim_end(), axis.count());
    }
    let (from, to) = axis.ends();
    let unit = axis.variable().unit();
    let log = if axis.spacing() == Spacing::Log { " at equal ratios" } else { "" };
    let ends = format!("{} to {} {unit}", shortest(from), shortest(to));
    format!("{} {}{log}, {} points", axis.symbol(), ends.trim_end(), axis.count())
}

/// Appends the chart of an output.
fn drawn(page: &mut Page, grid: &Grid, output: usize) {
    let column = grid.plan().outputs()[output];
    let is_axis = grid.plan().axes().len() == 1;
    let Some(picture) = picture(grid, output) else {
        let where_to = if is_axis { "axis" } else { "grid" };
        page.line(format!("{}: no value anywhere on this {where_to}", column.title()));
        page.space();
        return;
    };
    let size = if is_axis { CHART } else { MAP };
    page.picture(picture, size);
    let points = grid.counts().0;
    let gone = (0..points).filter(|at| grid.cell(*at, 0, output).value().is_none()).count();
    if gone > 0 && is_axis {
        page.line(format!("{gone} of {points} points have no value and are left blank"));
    }
    page.space();
}

fn values(page: &mut Page, grid: &Grid, axis: &Axis) {
    let last = axis.count() - 1;
    // Evenly spaced rows if the number of points allows them.
    let even = (5..TABLE_ROWS).rev().find(|steps| last.is_multiple_of(*steps));
    let count = even.map_or_else(|| TABLE_ROWS.min(axis.count()), |steps| steps + 1);
    let places = (0..count).map(|row| row * last / (count - 1));
    let shown = places.filter_map(|at| usize::try_from(at).ok());
    let unit = axis.variable().unit();
    let table = Table::new(shown)
        .with("axis", axis.symbol(), unit, |at| axis.value(*at as u64))
        .with("outcome", "outcome", "", |at| grid.outcome(*at, 0).map(PointOutcome::key));
    let outputs = grid.plan().outputs().iter().enumerate();
    let table = outputs.fold(table, |table, (output, column)| {
        table.with(column.name, column.title(), column.unit(), move |at| {
            grid.cell(*at, 0, output).value()
        })
    });
    page.table(table.cells(&table.keys()));
    page.space();
}
