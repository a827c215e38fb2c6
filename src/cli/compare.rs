//! `cmra compare [SCENE]`: the comparison at equal areal mass, and its map, as a page, CSV or JSON.

mod page;

use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::CliError;
use crate::cli::amount::{amount, read};
use crate::cli::pictures::PictureArguments;
use crate::cli::progress::ProgressLine;
use crate::cli::scene::SceneArguments;
use crate::cli::search::all_threads;
use crate::cli::sweep::axes::range;
use crate::cli::table::{TableArguments, at_top};
use crate::files::preset::Preset;
use crate::model::scene::Scene;
use crate::model::units::Quantity;
use crate::report::compare as tables;
use crate::report::figures::efficiency;
use crate::report::svg::Picture;
use crate::study::compare::map::{COUNT_USUAL, Map, usual_axis};
use crate::study::compare::{Hardware, compare};
use crate::study::sweep::Axis;
use crate::study::validity;

/// Points that an axis of a map may have.
const COUNTS: std::ops::RangeInclusive<u64> = 2..=1001;

#[derive(Debug, Args)]
#[command(
    after_help = "The map: --map v_i=10..90:101,gamma=0.2..7:101:log, or names alone: --map v_i,gamma.\n\
                  Above the line of 1 the armour is lighter than the solid plate that stops the same shot."
)]
pub(super) struct CompareArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Velocity at which the candidates are sized and compared, m/s or with a unit [default: the scene's]
    #[arg(long, value_name = "VELOCITY", allow_hyphen_values = true)]
    design_velocity: Option<String>,
    /// Energy per mass of the spring or absorber, J/kg or with a unit (10kJ/kg) [default: the scene's, or its wire's]
    #[arg(long, value_name = "ENERGY", allow_hyphen_values = true)]
    spring_energy: Option<String>,
    /// Mass of the spring, kg or with a unit [default: the least for the energy that it stores]
    #[arg(long, value_name = "MASS", allow_hyphen_values = true)]
    spring_mass: Option<String>,
    /// Mass of damper, stop and mount together, kg or with a unit
    #[arg(long, value_name = "MASS", default_value = "0", allow_hyphen_values = true)]
    mount_mass: String,
    /// Available stroke, m or with a unit [default: unlimited]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    stroke: Option<String>,
    /// Draw a map of the mass efficiency over two variables, each `NAME` or `NAME=LO..HI:COUNT[:log]`
    #[arg(long, value_name = "X,Y")]
    map: Option<String>,
    /// Name one of the two variables of the map; give it twice instead of --map
    #[arg(
        long,
        value_name = "NAME[=LO..HI:COUNT[:log]]",
        allow_hyphen_values = true,
        conflicts_with = "map"
    )]
    over: Vec<String>,
    #[command(flatten)]
    pictures: PictureArguments,
    #[command(flatten)]
    table: TableArguments,
}

/// Runs the comparison; a mechanism that does not pay is a valid result.
pub(super) fn run(arguments: &CompareArguments) -> Result<ExitCode, CliError> {
    arguments.table.check_beside()?;
    arguments.pictures.check(&arguments.table)?;
    let hardware = arguments.hardware()?;
    let mut preset = arguments.scene.load()?;
    if let Some(text) = &arguments.design_velocity {
        let velocity = amount("--design-velocity", text, Quantity::Velocity, "230m/s")?;
        preset.scene.projectile.velocity_m_s = velocity;
    }
    if let Some(text) = &arguments.spring_energy {
        let energy = amount("--spring-energy", text, Quantity::SpecificEnergy, "197J/kg")?;
        preset.scene.mechanism.energy_j_kg = Some(energy);
    }
    let over = (!arguments.over.is_empty()).then(|| arguments.over.join(","));
    if let Some(text) = arguments.map.as_ref().or(over.as_ref()) {
        let axes = axes(&preset.scene, text)?;
        return arguments.draw_map(&preset, &axes, hardware);
    }
    if arguments.pictures.is_wanted() {
        let text = "--svg draws a map: add --map v_i,gamma, or any two variables";
        return Err(CliError::Option(text.to_owned()));
    }
    let scene = Arc::new(preset.scene);
    let mut line = ProgressLine::begin();
    let report = line.study(1, "candidates", |context| compare(&scene, hardware, context))?;
    let name = preset.name.as_str();
    let page = || page::text(name, &report);
    let object = || tables::json(name, &report);
    let warnings = validity::of_scene(&scene);
    let table = arguments.table.of(&arguments.scene, &scene);
    table.deliver_warned(&warnings, page, object, tables::table(name, &report))?;
    Ok(line.exit_code(true))
}

impl CompareArguments {
    fn hardware(&self) -> Result<Hardware, CliError> {
        let spring = self.spring_mass.as_deref();
        let stroke = self.stroke.as_deref();
        Ok(Hardware {
            spring_kg: spring.map(|text| mass("--spring-mass", text)).transpose()?,
            mount_kg: mass("--mount-mass", &self.mount_mass)?,
            stroke_m: stroke
                .map(|text| amount("--stroke", text, Quantity::Length, "20mm"))
                .transpose()?,
        })
    }

    fn draw_map(
        &self,
        preset: &Preset,
        axes: &[Axis; 2],
        hardware: Hardware,
    ) -> Result<ExitCode, CliError> {
        let mut line = ProgressLine::begin();
        let map = line.study(all_threads(), "points", |context| {
            Map::compute(&preset.scene, axes, hardware, context)
        })?;
        let name = preset.name.as_str();
        let warnings = validity::of_axes(map.scene(), axes);
        let page = at_top(&page::map(name, &map), &warnings);
        let table = self.table.of(&self.scene, &preset.scene);
        if !self.pictures.is_stdout() {
            table.deliver(&page, &tables::map_table(name, &map).with_warnings(&warnings))?;
        }
        let drawn = || efficiency::map(&map).map(Picture::Map).into_iter().collect();
        self.pictures.write(&self.table, drawn)?;
        Ok(line.exit_code(map.is_complete()))
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
            range(part, Some(COUNT_USUAL), &COUNTS)
        } else {
            Ok(usual_axis(scene, part, COUNT_USUAL)?)
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

fn mass(option: &str, text: &str) -> Result<f64, CliError> {
    let value = read(option, text, Quantity::Mass)?;
    if value >= 0.0 {
        return Ok(value);
    }
    Err(CliError::Option(format!("{option} {text}: a mass is 0 kg or more, for example 20g")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_has_two_different_variables() {
        let scene = Scene::default();
        let [x, y] = axes(&scene, "v_i=10..90:5,gamma").unwrap();
        assert_eq!((x.symbol(), x.count(), y.symbol(), y.count()), ("v_i", 5, "gamma", 101));
        for (text, word) in
            [("v_i", "two variables"), ("v_i,v_i", "both variables"), ("v_i,gama", "gama")]
        {
            assert!(axes(&scene, text).unwrap_err().to_string().contains(word), "{text}");
        }
    }
}
