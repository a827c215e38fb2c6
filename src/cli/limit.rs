//! `cmra limit [SCENE]`: the ballistic limit and the residual-velocity curve, as a page, CSV or JSON.

use std::fmt::Write as _;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::charts::ChartArguments;
use crate::cli::study::StudyArguments;
use crate::cli::text::{chart_size, hanging};
use crate::cli::{CliError, draw};
use crate::tui::theme::Theme;
use cmra_engine::model::units::velocity;
use cmra_studies::report::limit::{self, meaning, remarks, residual, taken_to_hold};
use cmra_studies::report::svg::Picture;
use cmra_studies::study::limit::{COMMAND, Limit, LimitReport, find};

#[derive(Debug, Args)]
pub(super) struct LimitArguments {
    #[command(flatten)]
    pictures: ChartArguments,
    #[command(flatten)]
    study: StudyArguments,
}

/// Finds the limit. Exit status 0 also if there is none, 1 after an interrupt.
pub(super) fn run(arguments: &LimitArguments) -> Result<ExitCode, CliError> {
    let LimitArguments { study, pictures, .. } = arguments;
    pictures.check(&study.table)?;
    let preset = study.load()?;
    let scene = Arc::new(preset.scene);
    let (report, extent) = study.run("shots or so", |context| find(&scene, context));
    let report = report?;
    let name = preset.name.as_str();
    let warnings = limit::warnings(&report);
    if !pictures.is_stdout() {
        let (page, object) = (page(&preset.heading, &report), limit::json(name, &report));
        let (source, rows) = ((&*report.scene, COMMAND.to_owned()), limit::shots(name, &report));
        study.deliver(extent, source, &warnings, (page, object), rows)?;
    }
    let chart = || residual(&report, report.scene.projectile.velocity_m_s).map(Picture::Chart);
    pictures.write(&study.table, extent.reach, || chart().into_iter().collect())?;
    Ok(extent.exit_code(true))
}

const WIDTH: u16 = 80;
const HEIGHT: u16 = 18;
/// Width of a label.
const LABEL: usize = 16;

fn page(name: &str, report: &LimitReport) -> String {
    let mut page = format!("{name}: ballistic limit\n\n");
    head(&mut page, report);
    if let Some(chart) = residual(report, report.scene.projectile.velocity_m_s) {
        page.push_str(&draw::chart(&chart, chart_size((WIDTH, HEIGHT)), Theme::PLAIN));
    }
    page.push('\n');
    for remark in remarks(report).into_iter().chain(taken_to_hold(report)).chain(meaning(report)) {
        page += &hanging(&format!("{:LABEL$}", remark.about), &remark.text, LABEL);
    }
    page
}

fn head(page: &mut String, report: &LimitReport) {
    let own = report.scene.projectile.velocity_m_s;
    *page += &hanging("verdict         ", &limit::answer(report), LABEL);
    let expected = report.verdict().expected;
    if let Some(expected) = &expected {
        *page += &hanging("expected limit  ", &expected.words(), LABEL);
    }
    let label = if expected.is_some() { "law alone       " } else { "limit velocity  " };
    match report.limit {
        Limit::Found { velocity_m_s, basis, .. } => {
            let _ = writeln!(page, "{label}{}, {}", velocity(velocity_m_s, 6), basis.words());
        }
        Limit::Never | Limit::Always | Limit::Unknown => {
            let _ = writeln!(page, "{}", report.limit.absence().unwrap_or_default());
        }
    }
    *page += &hanging("criterion       ", report.scene.target.criterion.label(), LABEL);
    if let Some(margin) = report.margin() {
        let (percent, own) = (100.0 * margin, velocity(own, 6));
        let _ = writeln!(page, "margin          {percent:+.1} % relative to the scene's {own}");
    }
    page.push('\n');
}
