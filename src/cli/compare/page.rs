//! The comparison as a page of text: the verdict, the candidates side by side, and how mass was taken; and the map.

use std::fmt::Write as _;

use crate::cli::draw;
use crate::model::units::{fixed_significant, significant};
use crate::report::figures::efficiency;
use crate::study::compare::map::Map;
use crate::study::compare::summary::sentences;
use crate::study::compare::{Candidate, Entry, FIGURES, Report};
use crate::tui::app::status::wrap;
use crate::tui::theme::Theme;

const LABEL: usize = 27;
const COLUMN: usize = 13;
const WIDTH: usize = 80;
const INDENT: &str = "  ";
const MAP: draw::Size = (78, 30);
/// Rows of the table of the line of 1.
const LINE_ROWS: u64 = 11;

/// A line of the table: its label, what a stored unit is multiplied by, and the figure's name.
type Line = (&'static str, f64, &'static str);

const LINES: [Line; 18] = [
    ("mass efficiency", 1.0, "mass_efficiency"),
    ("  as built", 1.0, "mass_efficiency_as_built"),
    ("areal mass, kg/m^2", 1.0, "areal_mass_kg_m2"),
    ("limit velocity, m/s", 1.0, "limit_velocity_m_s"),
    ("  perforation, m/s", 1.0, "perforation_velocity_m_s"),
    ("solid of this limit, mm", 1e3, "equivalent_thickness_m"),
    ("stroke, mm", 1e3, "stroke_m"),
    ("  at the limit, mm", 1e3, "stroke_at_limit_m"),
    ("stored energy, J", 1.0, "stored_energy_j"),
    ("  at the limit, J", 1.0, "stored_energy_at_limit_j"),
    ("mount force, kN", 1e-3, "peak_mount_force_n"),
    ("  at the limit, kN", 1e-3, "peak_mount_force_at_limit_n"),
    ("impulse into mount, N s", 1.0, "mount_impulse_n_s"),
    ("preloaded energy, J", 1.0, "preload_energy_j"),
    ("back-face travel, mm", 1e3, "max_plate_displacement_m"),
    ("thickness, mm", 1e3, "thickness_m"),
    ("residual velocity, m/s", 1.0, "residual_velocity_m_s"),
    ("depth, mm", 1e3, "penetration_m"),
];

/// The page.
pub(super) fn text(name: &str, report: &Report) -> String {
    let projectile = &report.scene.projectile;
    let mut page = format!(
        "{name}: does moving armour pay? {} g, design velocity {} m/s\n\n",
        fixed_significant(1e3 * projectile.mass_kg, 4),
        fixed_significant(projectile.velocity_m_s, 4)
    );
    for sentence in sentences(report) {
        for (line, text) in wrap(&sentence, WIDTH - INDENT.len()).into_iter().enumerate() {
            let indent = if line == 0 { "" } else { INDENT };
            let _ = writeln!(page, "{indent}{text}");
        }
    }
    page.push('\n');
    table(&mut page, report);
    page.push('\n');
    masses(&mut page, report);
    page
}

fn table(page: &mut String, report: &Report) {
    let mut line = |label: &str, cell: &dyn Fn(&Entry) -> String| {
        let mut text = format!("{label:LABEL$}");
        for entry in &report.entries {
            let _ = write!(text, "{:>COLUMN$}", cell(entry));
        }
        page.push_str(text.trim_end());
        page.push('\n');
    };
    line("", &|entry| entry.candidate.word().to_owned());
    line("at the design velocity", &|entry| {
        let mark = if entry.is_held { "" } else { "*" };
        format!("{}{mark}", entry.outcome.word())
    });
    for (label, factor, name) in LINES {
        let Some(figure) = FIGURES.iter().find(|figure| figure.name == name) else { continue };
        line(label, &|entry| {
            let value = (figure.get)(entry);
            let beyond = name == "perforation_velocity_m_s" || name == "limit_velocity_m_s";
            let absent = if beyond && entry.is_beyond() { "beyond 3000" } else { "-" };
            value.map_or_else(|| absent.to_owned(), |value| fixed_significant(factor * value, 4))
        });
    }
    if report.entries.iter().any(|entry| !entry.is_held) {
        page.push_str(
            "* nothing stops plate and projectile: no rival, only what mass ratio alone does\n",
        );
    }
}

fn masses(page: &mut String, report: &Report) {
    let gram = |kg: f64| fixed_significant(1e3 * kg, 3);
    let own = report.of(Candidate::Scene);
    let known = own.and_then(|own| own.spring_kg);
    let spring = match known {
        Some(kg) if report.hardware.spring_kg.is_some() => format!("{} g as given", gram(kg)),
        Some(kg) if report.spring_is_own => format!("{} g, the scene's own", gram(kg)),
        Some(kg) => format!(
            "{} g, the least for the energy at {} J/kg (--spring-energy)",
            gram(kg),
            significant(report.scene.mechanism.specific_energy_j_kg(), 4)
        ),
        None => {
            "not known, since nothing stops the plate or the run ended early; give --spring-mass"
                .to_owned()
        }
    };
    let _ = writeln!(
        page,
        "areal mass: over the plate's face of {} cm^2, its mass over rho h\nspring: {spring}\nmount: {} g (--mount-mass)",
        fixed_significant(1e4 * report.face_m2, 3),
        gram(report.hardware.mount_kg)
    );
    if report.has_stop {
        page.push_str("stop: takes up energy, and its mass is missing; count it in --mount-mass\n");
    }
}

/// The map as a page.
pub(super) fn map(name: &str, map: &Map) -> String {
    let (x, y) = (map.x(), map.y());
    let mut page = format!(
        "{name}: mass efficiency over {} and {}, springs of {} J/kg\n\n",
        x.symbol(),
        y.symbol(),
        significant(map.scene().mechanism.specific_energy_j_kg(), 4)
    );
    let Some(drawn) = efficiency::map(map).filter(|drawn| drawn.values().next().is_some()) else {
        page.push_str("no point has a mass efficiency\n");
        return page;
    };
    page.push_str(&draw::map(&drawn, MAP, Theme::PLAIN));
    line_of_one(&mut page, map);
    page
}

/// Where the line of 1 runs, in numbers.
fn line_of_one(page: &mut String, map: &Map) {
    let (x, y) = (map.x(), map.y());
    let _ =
        writeln!(page, "\n{:>12}  {} at which the mass efficiency is 1", y.symbol(), x.symbol());
    let last = y.count() - 1;
    let rows = LINE_ROWS.min(y.count());
    for row in (0..rows).map(|row| row * last / (rows - 1)) {
        let crossings: Vec<String> =
            map.line_of_one(row).iter().map(|at| significant(*at, 4)).collect();
        let text = if crossings.is_empty() { "-".to_owned() } else { crossings.join(", ") };
        let _ = writeln!(page, "{:>12}  {text}", significant(y.value(row), 4));
    }
}
