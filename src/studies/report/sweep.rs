//! A sweep as rows for machines: CSV and JSON, one row a point, made piece by piece so that 10^8 rows need no memory.
//!
//! Axis values first, then what was requested; an empty field (JSON: null) where a quantity does not exist; `error` last, which
//! says why a point failed. No column has the time a point took: files of the same sweep are equal.

use std::rc::Rc;

use serde_json::{Value, json};

use crate::report::table::{Table, pretty};
use crate::report::table::{listed, texts};
use crate::report::verdict;
use crate::study::context::Reach;
use crate::study::sweep::grid::Grid;
use crate::study::sweep::{Axis, Evaluator, Plan, Point, Shard, Spacing};
use crate::study::validity;
use crate::study::verdict::Verdict;
use cmra_engine::model::run::{Run, envelope};
use cmra_engine::model::scene::{Scene, Sweep};
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
        let run = |row: &usize| runs[*row].as_ref();
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
            let value = move |row: &usize| found[*row].values[at];
            table = table.field(output.name, value);
        }
        if is_all {
            let keys = [
                "limit_velocity_m_s",
                "expected_limit_m_s",
                "expected_low_m_s",
                "expected_high_m_s",
                "class",
                "measurements",
                "papers",
            ];
            for key in keys {
                let verdicts = Rc::clone(&verdicts);
                table = table.field(key, move |row| verdict::object(&verdicts[*row])[key].clone());
            }
            table = table
                .field("method", move |row| Some(run(row)?.cost.method))
                .field("omitted", move |row| Some(run(row)?.omitted.join("; ")))
                .field("warnings", move |row| Some(listed(&envelope::warnings(run(row)?))));
        }
        table.field("error", move |row| found[*row].reason())
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
