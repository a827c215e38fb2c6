//! `cmra design`: what a designer works with that needs no simulation: a shot's formulas, the screening matrix, the principles.

use std::fmt::Write as _;

use clap::{Args, Subcommand};

use crate::cli::CliError;
use crate::cli::scene::SceneArguments;
use crate::cli::table::{TableArguments, at_top};
use crate::model::design;
use crate::model::library;
use crate::model::run::envelope;
use crate::model::scene::{Scene, Wire};
use crate::model::units::{engineering, significant};
use crate::model::variables;
use crate::report::table::Table;
use crate::report::thesis;
use crate::study::principles::PRINCIPLES;
use crate::study::screening::{CONCEPTS, CRITERIA, WEIGHTS_PERCENT, ranking};

#[derive(Debug, Args)]
#[command(arg_required_else_help = false)]
pub(super) struct DesignArguments {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// A shot by formulas: ricochet, effective thickness, collisions, the mass of a spring
    Shot(ShotArguments),
    /// The screening matrix of Table 7.1, with your own weights
    Screening(ScreeningArguments),
    /// Families, principles and functions of Tables 4.1 and 5.1, and the presets that show them
    Principles(PrinciplesArguments),
}

#[derive(Debug, Args)]
struct ShotArguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    table: TableArguments,
}

#[derive(Debug, Args)]
struct ScreeningArguments {
    /// Weight of a criterion in percent, named by any part of its name; may be repeated
    #[arg(long, value_name = "CRITERION=PERCENT")]
    weight: Vec<String>,
    #[command(flatten)]
    table: TableArguments,
}

#[derive(Debug, Args)]
struct PrinciplesArguments {
    #[command(flatten)]
    table: TableArguments,
}

pub(super) fn run(arguments: &DesignArguments) -> Result<(), CliError> {
    match &arguments.what {
        What::Shot(arguments) => shot(arguments),
        What::Screening(arguments) => screening(arguments),
        What::Principles(arguments) => principles(arguments),
    }
}

fn shot(arguments: &ShotArguments) -> Result<(), CliError> {
    let preset = arguments.scene.load()?;
    variables::validate(&preset.scene)?;
    let found = formulas(&preset.scene);
    let mut page = format!("{}: by formulas alone\n\n", preset.name);
    for Formula { name, value, unit, source } in &found {
        let shown = engineering(*value, unit, 4);
        let _ = writeln!(page, "{shown:>14}  {name} ({source})");
    }
    let rows = Table::of(&found)
        .with("name", "name", "", |it| it.name)
        .with("value", "value", "", |it| it.value)
        .with("unit", "unit", "", |it| it.unit)
        .with("source", "source", "", |it| it.source);
    let breaches = envelope::of_scene(&preset.scene);
    let mut warnings: Vec<String> = breaches.iter().map(ToString::to_string).collect();
    warnings.extend(variables::range_warnings(&preset.scene));
    warnings.extend(library::warnings(&preset.scene).map(str::to_owned));
    arguments.table.alone().deliver(&at_top(&page, &warnings), rows.with_warnings(&warnings))
}

/// A value by a formula, and where that is from.
struct Formula {
    name: &'static str,
    value: f64,
    unit: &'static str,
    source: &'static str,
}

fn formulas(scene: &Scene) -> Vec<Formula> {
    let (m, v) = (scene.projectile.mass_kg, scene.projectile.velocity_m_s);
    let m_2 = scene.plate_mass_kg();
    let common = design::inelastic(m, v, m_2, 0.0);
    let [back, forward] = design::elastic(m, v, m_2, 0.0);
    let left = 0.5 * (m + m_2) * common * common;
    let drawn = variables_energy_j(scene);
    let spring = design::coil_spring_mass_kg(left + drawn, &Wire::default());
    let (r, rho) = (scene.projectile.tip_radius_m, scene.target.density_kg_m3);
    let at_one = design::stone_depth_m(m, v, r, rho, 1.0);
    let formula = |name, value, unit, source| Formula { name, value, unit, source };
    let critical_deg = design::Rod::of(scene).critical_obliquity_deg(rho);
    let tate = "Tate, eq. 2.3; rho_p and Y_p are assumptions";
    let integral = "the integral of its force; k d^(n+1)/(n+1) of a power law";
    let coil = "4 rho G U/tau^2, 700 MPa, section 9.5.1";
    let square = "eq. 2.4; c_t must be the square of a speed";
    vec![
        formula("critical obliquity", critical_deg, "deg", tate),
        formula(
            "effective thickness",
            scene.effective_thickness_m(),
            "m",
            "h/cos(theta), Figure 4.1",
        ),
        formula("common velocity, inelastic", common, "m/s", "eq. 2.2 and 8.11"),
        formula("energy after it", left, "J", "kinetic energy of both bodies together"),
        formula("projectile velocity, elastic", back, "m/s", "eq. 2.1 with momentum"),
        formula("plate velocity, elastic", forward, "m/s", "eq. 2.1 with momentum"),
        formula("energy stored by cocking", drawn, "J", integral),
        formula("least mass of a steel coil for both", spring, "kg", coil),
        formula("Stone's depth times c_t", at_one, "m3/s2", square),
    ]
}

/// The energy of a cocked spring, J.
fn variables_energy_j(scene: &Scene) -> f64 {
    let spring = crate::model::mechanism::Mechanism::of(scene).spring;
    spring.energy(0.0 - scene.plate.cocking_m)
}

fn screening(arguments: &ScreeningArguments) -> Result<(), CliError> {
    let mut weights = WEIGHTS_PERCENT;
    for text in &arguments.weight {
        let (name, value) = text.split_once('=').unwrap_or((text, ""));
        let wanted = name.trim().to_lowercase();
        let hits: Vec<usize> =
            (0..CRITERIA.len()).filter(|at| CRITERIA[*at].contains(wanted.as_str())).collect();
        let value: Option<f64> = value.trim().trim_end_matches('%').trim().parse().ok();
        let value = value.filter(|value| (0.0..=100.0).contains(value));
        let ([at], Some(value)) = (hits.as_slice(), value) else {
            return Err(CliError::Option(format!(
                "--weight {text}: write CRITERION=PERCENT with 0 to 100, for example --weight analysis=0; the criteria are {}",
                CRITERIA.join(", ")
            )));
        };
        weights[*at] = value;
    }
    let sum: f64 = weights.iter().sum();
    let mut page = String::from("criterion                weight  printed\n");
    for (at, criterion) in CRITERIA.iter().enumerate() {
        let [own, printed] = [weights[at], WEIGHTS_PERCENT[at]].map(|it| significant(it, 3));
        let _ = writeln!(page, "{criterion:<24}{own:>5} %  {printed:>5} %");
    }
    let _ = writeln!(page, "{:<24}{:>5} %\n", "sum", significant(sum, 4));
    let _ = writeln!(page, "rank  concept                   total  printed       preset");
    let places = ranking(&weights);
    for place in &places {
        let concept = &CONCEPTS[place.concept];
        let printed = format!("{} ({})", significant(concept.total, 3), concept.rank);
        let _ = writeln!(
            page,
            "{:>4}  {:<24}{:>7.2}  {printed:<12}  {}",
            place.rank, concept.name, place.total, concept.preset
        );
    }
    arguments.table.alone().deliver(&page, thesis::screening(&weights))
}

fn principles(arguments: &PrinciplesArguments) -> Result<(), CliError> {
    let mut page = String::new();
    let mut family = "";
    for principle in PRINCIPLES.iter() {
        if principle.family != family {
            family = principle.family;
            let _ = writeln!(page, "{family}");
        }
        let _ = writeln!(page, "  {} ({}): {}", principle.name, principle.section, principle.idea);
        let _ = writeln!(page, "      functions  {}", principle.functions.join(", "));
        let _ = writeln!(page, "      computed   {}", principle.computed);
        if let Some(preset) = principle.preset {
            let _ = writeln!(page, "      preset     {preset}");
        }
    }
    arguments.table.alone().deliver(&page, thesis::principles())
}
