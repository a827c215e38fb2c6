//! The report of a scene: one self-contained file with its inputs, results, charts, ballistic limit, sweep and warnings.

use std::path::Path;

use crate::files::{clean, write};
use crate::model::library;
use crate::model::run::{Run, envelope};
use crate::model::scene::Scene;
use crate::model::units;
use crate::model::variables::{VARIABLES, Variable, is_used};
use crate::report::document::{Block, Document};
use crate::report::figures::run::selected;
use crate::report::figures::sweeps::picture;
use crate::report::limit::{remarks, residual, taken_to_hold};
use crate::report::run::page::{of_first, sentence};
use crate::report::svg::Picture;
use crate::study::limit;
use crate::study::quantities::{Quantity, of_runs};
use crate::study::stack;
use crate::study::sweep::grid::Grid;
use crate::study::validity;

/// Digits of a result.
const DIGITS: usize = 6;

/// What a report is about, computed.
pub struct Subject<'a> {
    /// The scene's name.
    pub name: &'a str,
    /// The scene, with title, notes and sweep.
    pub scene: &'a Scene,
    /// Its run.
    pub run: &'a Run,
    /// Its ballistic limit.
    pub limit: &'a limit::Report,
    /// The sweep that is kept with it, over one axis or two.
    pub sweep: Option<&'a Grid>,
}

/// Whether the ending of a file is that of a report.
pub fn is_report(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    matches!(ending.as_str(), "html" | "htm" | "xhtml")
}

impl Subject<'_> {
    /// The text of the report, as HTML.
    pub fn html(&self) -> String {
        let mut document = self.head();
        results(&mut document, self.run);
        let charts = selected(self.run).into_iter().map(Picture::Chart).map(block);
        section(&mut document, &format!("Charts{}", of_first(self.run)), charts.collect());
        section(&mut document, "Ballistic limit", ballistic_limit(self.limit));
        section(&mut document, "Sweep", self.sweep.map(own_sweep).unwrap_or_default());
        section(&mut document, "Run it again", self.again());
        clean::page(&document.html()).into_owned()
    }

    /// The title, the warnings, and the changed inputs.
    fn head(&self) -> Document {
        let Self { name, scene, run, .. } = *self;
        let title = clean::line(&scene.title);
        let title = if title.is_empty() { name.to_owned() } else { format!("{name}: {title}") };
        let outcome = run.stack.as_ref().map_or_else(|| sentence(run), |stack| stack.sentence());
        let mut document = Document { title, blocks: vec![Block::Paragraph(outcome)] };
        // Warnings have a section of their own.
        let notes = scene.notes.lines().filter(|line| !library::is_warning(line));
        document.blocks.extend(notes.map(|line| Block::Paragraph(line.to_owned())));
        let warnings = envelope::warnings(run);
        let warnings = if warnings.is_empty() {
            vec![Block::Paragraph(
                "No warning: the scene is within the validity of the model.".to_owned(),
            )]
        } else {
            vec![Block::List(warnings)]
        };
        section(&mut document, "Warnings and validity", warnings);
        let usual = Scene::default();
        let changed = |one: &&Variable| is_used(one, scene) && one.show(scene) != one.show(&usual);
        let row = |one: &Variable| {
            let unit = one.unit().to_owned();
            vec![
                one.symbol.to_owned(),
                one.meaning.to_owned(),
                one.show(scene),
                one.show(&usual),
                unit,
            ]
        };
        let rows: Vec<Vec<String>> = VARIABLES.iter().filter(changed).map(row).collect();
        let inputs = if rows.is_empty() {
            Block::Paragraph("Every input has the value of the baseline.".to_owned())
        } else {
            let head = ["symbol", "input", "value", "baseline", "unit"].map(str::to_owned).to_vec();
            Block::Table { head, rows }
        };
        section(&mut document, "Inputs that differ from the baseline", vec![inputs]);
        document
    }

    /// The version, the scene as a file, and what to do with it.
    fn again(&self) -> Vec<Block> {
        vec![
            Block::Paragraph(format!(
                "Computed by cmra {} ({}). Save these lines as scene.toml:",
                env!("CARGO_PKG_VERSION"),
                self.run.cost.method
            )),
            Block::Code(write::fresh(self.scene)),
            Block::Paragraph(
                "The first command prints the run, the second makes this report:".to_owned(),
            ),
            Block::Code("cmra run scene.toml\ncmra report scene.toml -o report.html".to_owned()),
        ]
    }
}

fn block(picture: Picture) -> Block {
    Block::Picture(Box::new(picture))
}

/// Adds a section unless it is empty.
fn section(document: &mut Document, title: &str, blocks: Vec<Block>) {
    if !blocks.is_empty() {
        document.blocks.push(Block::Heading(title.to_owned()));
        document.blocks.extend(blocks);
    }
}

/// The results, each with the estimate of its error.
fn results(document: &mut Document, run: &Run) {
    let error = |name: &str| {
        run.error_of(name).map_or_else(|| "-".to_owned(), |error| units::scientific(error, 1))
    };
    let row = |column: &Quantity| {
        let value = column.value(run)?;
        Some(vec![
            column.title(),
            column.show(value, DIGITS),
            error(column.name),
            column.name.to_owned(),
        ])
    };
    let head = ["result", "value", "relative error", "key"].map(str::to_owned).to_vec();
    let blocks = vec![Block::Table { head, rows: of_runs().filter_map(row).collect() }];
    let events = run.events.iter().map(|event| {
        let time = units::engineering(event.t_s, "s", DIGITS);
        format!("{time}: {}", event.kind.words())
    });
    let events: Vec<String> = events.collect();
    section(document, "Results", blocks);
    if let Some(stack) = &run.stack {
        let table = stack::table(run, stack).join("\n");
        section(document, "Stack: plate by plate", vec![Block::Code(table)]);
    }
    if !events.is_empty() {
        section(document, &format!("Events{}", of_first(run)), vec![Block::List(events)]);
    }
}

/// The ballistic limit with its curve.
fn ballistic_limit(report: &limit::Report) -> Vec<Block> {
    let mut lines = Vec::new();
    match report.limit.velocity_m_s() {
        Some(velocity) => lines.push(units::velocity(velocity, DIGITS)),
        None => lines.extend(report.limit.absence()),
    }
    lines.push(format!("criterion: {}", report.scene.target.criterion.label()));
    if let Some(margin) = report.margin() {
        lines.push(format!("{:+.1} % over the scene's own velocity", 100.0 * margin));
    }
    let remarks = remarks(report).into_iter().chain(taken_to_hold(report));
    lines.extend(remarks.map(|remark| format!("{}: {}", remark.about, remark.text)));
    let warnings = report.at_limit.as_ref().map_or(&[][..], |it| &it.warnings);
    let known: Vec<&str> = library::warnings(&report.scene).collect();
    let of_limit = warnings.iter().filter(|warning| !known.contains(&warning.as_str()));
    lines.extend(of_limit.map(|warning| format!("at the limit: {warning}")));
    let chart =
        residual(report, report.scene.projectile.velocity_m_s).map(Picture::Chart).map(block);
    std::iter::once(Block::List(lines)).chain(chart).collect()
}

/// The pictures of the sweep that is kept with the scene.
fn own_sweep(grid: &Grid) -> Vec<Block> {
    let plan = grid.plan();
    let pictures = (0..plan.outputs().len()).filter_map(|output| picture(grid, output));
    let mut blocks: Vec<Block> = pictures.map(block).collect();
    let warnings = validity::of_plan(plan);
    blocks.extend((!warnings.is_empty()).then_some(Block::List(warnings)));
    blocks
}
