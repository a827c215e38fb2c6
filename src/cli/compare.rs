//! `cmra compare [SCENE]`: the comparison at equal areal mass, and its map, as a page, CSV or JSON.

use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::CliError;
use crate::cli::charts::ChartArguments;
use crate::cli::study::StudyArguments;
use crate::files::preset::Preset;
use cmra_engine::model::scene::Scene;
use cmra_studies::report::compare as tables;
use cmra_studies::report::compare::page::{map_page, page};
use cmra_studies::report::page::Block;
use cmra_studies::report::svg::Picture;
use cmra_studies::study::compare::map::{DEFAULT_COUNT, Map, default_axis};
use cmra_studies::study::compare::{Hardware, Request, compare};
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::validity;

/// Allowed number of points of an axis of a map.
const COUNTS: std::ops::RangeInclusive<u64> = 2..=1001;

#[derive(Debug, Args)]
#[command(
    after_help = "The map: --map v_i=10..90:101,gamma=0.2..7:101:log, or names alone: --map v_i,gamma.\n\
                  Above the line of 1 the armour is lighter than the solid plate that stops the same shot."
)]
pub(super) struct CompareArguments {
    /// Give a spring of unknown mass just the mass that the design shot needs: it holds no faster one
    #[arg(long)]
    size: bool,
    /// Draw a map of the mass efficiency over two variables, each `NAME` or `NAME=LO..HI:COUNT[:log]`
    #[arg(long, value_name = "X,Y")]
    map: Option<String>,
    #[command(flatten)]
    pictures: ChartArguments,
    #[command(flatten)]
    study: StudyArguments,
}

/// Runs the comparison; exit status 0 also if the mechanism has no advantage.
pub(super) fn run(arguments: &CompareArguments) -> Result<ExitCode, CliError> {
    arguments.pictures.check(&arguments.study.table)?;
    let preset = arguments.study.read()?;
    let request = arguments.request(&preset.scene)?;
    arguments.study.say_unused(&preset.scene, request.map.as_ref().map_or(&[], |axes| &axes[..]));
    if let Some(axes) = &request.map {
        return arguments.draw_map(&preset, axes, &request);
    }
    if arguments.pictures.is_wanted() {
        let text = "--svg draws a map: add --map v_i,gamma, or any two variables";
        return Err(CliError::Option(text.to_owned()));
    }
    let scene = Arc::new(preset.scene);
    let (report, extent) =
        arguments.study.run("candidates", |it| compare(&scene, request.hardware, it));
    let report = report?;
    let name = preset.name.as_str();
    let warnings = validity::of_scene(&scene);
    let (page, object) = (page(&preset.heading, &report), tables::json(name, &report));
    let (source, rows) = ((&*scene, request.to_string()), tables::table(name, &report));
    arguments.study.deliver(extent, source, &warnings, (page, object), rows)?;
    Ok(extent.exit_code(true))
}

impl CompareArguments {
    fn request(&self, scene: &Scene) -> Result<Request, CliError> {
        let hardware = if self.size { Hardware::Sized } else { Hardware::Own };
        let map = self.map.as_ref().map(|text| axes(scene, text)).transpose()?;
        Ok(Request { hardware, map })
    }

    fn draw_map(
        &self,
        preset: &Preset,
        axes: &[Axis; 2],
        request: &Request,
    ) -> Result<ExitCode, CliError> {
        let (map, extent) = self
            .study
            .run("points", |context| Map::compute(&preset.scene, axes, request.hardware, context));
        let map = map?;
        let name = preset.name.as_str();
        let warnings = validity::of_axes(map.scene(), axes);
        let mut page = map_page(&preset.heading, &map);
        page.push(Block::Warnings(warnings));
        if !self.pictures.is_stdout() {
            let source = (&self.study.scene.changes, &preset.scene, request.to_string());
            let rows = tables::map_table(name, &map);
            self.study.table.deliver(extent, Some(source), &page, None, rows)?;
        }
        let drawn = || tables::picture(&map).map(Picture::Map).into_iter().collect();
        self.pictures.write(&self.study.table, extent.reach, drawn)?;
        Ok(extent.exit_code(map.is_complete()))
    }
}

fn axes(scene: &Scene, text: &str) -> Result<[Axis; 2], CliError> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let [x, y] = parts[..] else {
        return Err(CliError::Option(format!(
            "--map {text}: give two variables, for example v_i,gamma or v_i=10..90:101,gamma=0.2..7:101:log"
        )));
    };
    let axis = |part: &str| {
        if part.contains('=') {
            Axis::read_range(part, Some(DEFAULT_COUNT), &COUNTS)
        } else {
            default_axis(scene, part, DEFAULT_COUNT)
        }
    };
    let (x, y) = (axis(x)?, axis(y)?);
    if x.variable().key == y.variable().key {
        return Err(CliError::Option(format!(
            "--map {text}: both variables are {}; give two different ones",
            x.symbol()
        )));
    }
    Ok([x, y])
}
