//! `cmra compare [SCENE]`: the comparison at equal areal mass, and its map, as a page, CSV or JSON.

use std::fmt::Write as _;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::charts::ChartArguments;
use crate::cli::study::StudyArguments;
use crate::cli::text::{chart_size, hanging, width};
use crate::cli::{CliError, draw};
use crate::files::preset::Preset;
use cmra_engine::model::scene::{Criterion, Scene};
use cmra_engine::model::units::{fixed_significant, significant};
use cmra_studies::report::compare as tables;
use cmra_studies::report::compare::beside;
use cmra_studies::report::svg::Picture;
use cmra_studies::study::compare::map::{DEFAULT_COUNT, Map, default_axis};
use cmra_studies::study::compare::{Candidate, ComparisonReport, Hardware, Request, compare};
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::validity;

/// Indent of the continuation lines of a sentence.
const INDENT: usize = 2;
const MAP: draw::Size = (78, 30);
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
    let preset = arguments.study.load()?;
    let request = arguments.request(&preset.scene)?;
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
        let page = map_page(&preset.heading, &map) + &self.study.table.warnings(&warnings);
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

fn page(name: &str, report: &ComparisonReport) -> String {
    let projectile = &report.scene.projectile;
    let [gram, v] = [1e3 * projectile.mass_kg, projectile.velocity_m_s]
        .map(|value| fixed_significant(value, 4));
    let mut page = format!("{name}: does moving armour pay? {gram} g, design velocity {v} m/s\n\n");
    let say = |page: &mut String, text: &str| *page += &hanging("", text, INDENT);
    say(&mut page, &tables::verdict(report));
    let criterion = report.scene.target.criterion;
    if criterion != Criterion::Passage {
        say(&mut page, &format!("criterion: {}", criterion.label()));
    }
    if let Some(caution) = report.caution() {
        say(&mut page, &format!("caution: {caution}"));
    }
    page.push('\n');
    page += &beside(report, width());
    page.push('\n');
    for reason in tables::reasons(report) {
        say(&mut page, &reason);
    }
    page.push('\n');
    masses(&mut page, report);
    page
}

fn masses(page: &mut String, report: &ComparisonReport) {
    let gram = |kg: f64| fixed_significant(1e3 * kg, 3);
    let own = report.entry(Candidate::Scene);
    let known = own.and_then(|own| own.spring_kg);
    let spring = match known {
        Some(kg) if report.spring_is_own => format!("{} g, the scene's own", gram(kg)),
        Some(kg) => {
            let holds = if report.hardware == Hardware::Sized {
                "it holds no faster shot (--size)"
            } else {
                "taken to hold faster shots, too; --size: it does not"
            };
            let (gram, energy) = (gram(kg), per_mass(&report.scene));
            format!("{gram} g, the least for the design shot at {energy} (e_spring); {holds}")
        }
        None if report.scene.mechanism.specific_energy_j_kg().is_none() => {
            "not known, since it is no coil; set e_spring or m_spring, or give --absorber"
                .to_owned()
        }
        None => "not known, since nothing stops the plate or the run ended early; set m_spring"
            .to_owned(),
    };
    let _ = writeln!(
        page,
        "areal mass: over the plate's face of {} cm^2, its mass over rho h\nspring: {spring}",
        fixed_significant(1e4 * report.face_m2, 3)
    );
    for part in &report.uncounted {
        let text = "takes up energy, and its mass is not counted";
        let _ = writeln!(page, "{part}: {text}");
    }
}

/// Formats the energy per mass of the springs.
fn per_mass(scene: &Scene) -> String {
    let energy_j_kg = scene.mechanism.specific_energy_j_kg();
    let known = energy_j_kg.map(|energy| significant(energy, 4));
    format!("{} J/kg", known.as_deref().unwrap_or("unknown"))
}

fn map_page(name: &str, map: &Map) -> String {
    let (x, y, energy) = (map.x().symbol(), map.y().symbol(), per_mass(map.scene()));
    let mut page = format!("{name}: mass efficiency over {x} and {y}, springs of {energy}\n\n");
    let Some(drawn) = tables::picture(map).filter(|drawn| drawn.values().next().is_some()) else {
        page.push_str("no point has a mass efficiency\n");
        return page;
    };
    if let Some(place) = tables::where_it_pays(map, map.scene()) {
        let _ = writeln!(page, "{place}\n");
    }
    page.push_str(&draw::map(&drawn, chart_size(MAP)));
    page
}
