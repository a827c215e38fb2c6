//! The comparison as a page of text: the candidates side by side, chapter 4's two requirements, and how mass was taken.

use std::fmt::Write as _;

use crate::model::scene::Scene;
use crate::model::units::fixed_significant;
use crate::study::worth::{Candidate, Entry, Report, SPRING_KG_PER_J};

const LABEL: usize = 27;
const COLUMN: usize = 13;

/// A line of the table: its words, what a stored unit is multiplied by, and the figure.
type Line = (&'static str, f64, fn(&Entry) -> Option<f64>);

const LINES: [Line; 12] = [
    ("thickness, mm", 1e3, |entry| Some(entry.scene.target.thickness_m)),
    ("areal mass, kg/m^2", 1.0, |entry| entry.areal_kg_m2),
    ("penetration, mm", 1e3, |entry| entry.depth_m),
    ("velocity left, m/s", 1.0, |entry| entry.residual_m_s),
    ("limit velocity, m/s", 1.0, |entry| entry.limit.velocity_m_s()),
    ("solid, same limit, mm", 1e3, |entry| entry.equivalent_m),
    ("mass efficiency", 1.0, |entry| entry.mass_efficiency),
    ("stroke, mm", 1e3, |entry| entry.stroke_m),
    ("back-face travel, mm", 1e3, |entry| entry.back_face_m),
    ("peak force on mount, kN", 1e-3, |entry| entry.mount_force_n),
    ("impulse into mount, N s", 1.0, |entry| entry.impulse_n_s),
    ("preloaded energy, J", 1.0, |entry| entry.preload_j),
];

/// The page.
pub(super) fn text(name: &str, scene: &Scene, report: &Report, spring_given: bool) -> String {
    let mut page = format!(
        "{name}: is it worth it? the same shot, {} g at {} m/s, against each:\n\n",
        fixed_significant(1e3 * scene.projectile.mass_kg, 4),
        fixed_significant(scene.projectile.velocity_m_s, 4)
    );
    table(&mut page, report);
    page.push('\n');
    verdict(&mut page, report);
    page.push('\n');
    masses(&mut page, report, spring_given);
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
    line("outcome", &|entry| entry.outcome.word().to_owned());
    for (label, factor, get) in LINES {
        line(label, &|entry| {
            get(entry).map_or_else(|| "-".to_owned(), |value| fixed_significant(factor * value, 4))
        });
    }
}

fn verdict(page: &mut String, report: &Report) {
    let of = |candidate| report.of(candidate);
    let (Some(own), Some(free)) = (of(Candidate::Scene), of(Candidate::Free)) else { return };
    let percent = |ratio: f64| format!("{:+.1} %", 100.0 * (ratio - 1.0));
    let depths = |other: Option<&Entry>| Some(own.depth_m? / other?.depth_m?);
    if let Some(ratio) = report.depth_over_solid() {
        let met = if ratio < 1.0 { "met" } else { "not met" };
        let _ = writeln!(
            page,
            "less penetration than a solid plate of equal mass: {met} ({})",
            percent(ratio)
        );
        let thicker = depths(of(Candidate::Rigid)) > depths(of(Candidate::Solid));
        if thicker {
            page.push_str(
                "  (the solid plate is penetrated deeper than the thin one only because it dishes less: the limit judges better)\n",
            );
        }
    }
    if let Some(efficiency) = own.mass_efficiency {
        let met = if efficiency > 1.0 { "met" } else { "not met" };
        let _ = writeln!(
            page,
            "as good as a heavier solid plate: {met} (one of the same limit weighs {} times as much)",
            fixed_significant(efficiency, 3)
        );
    }
    if let Some(ratio) = depths(of(Candidate::Rigid)) {
        let _ = writeln!(page, "penetration against the rigid mount: {}", percent(ratio));
    }
    if let Some(ratio) = depths(Some(free)) {
        let _ = writeln!(
            page,
            "penetration against the merely free plate: {}: what spring, damper, stop and cocking do",
            percent(ratio)
        );
    }
    for entry in &report.entries {
        if let Some(absence) = entry.limit.absence() {
            let _ = writeln!(page, "{}: {absence}", entry.candidate.word());
        }
    }
    if let Some(caution) = report.caution() {
        let _ = writeln!(page, "caution: {caution}");
    }
}

fn masses(page: &mut String, report: &Report, spring_given: bool) {
    let gram = |kg: f64| fixed_significant(1e3 * kg, 3);
    let spring = match (report.spring_kg, report.spring_energy_j) {
        (Some(kg), _) if spring_given => format!("{} g as given", gram(kg)),
        (Some(kg), _) if report.spring_is_own => format!("{} g, the scene's own", gram(kg)),
        (Some(kg), Some(energy)) => format!(
            "{} g, the least for {} J in helical steel ({} g/J)",
            gram(kg),
            fixed_significant(energy, 3),
            gram(SPRING_KG_PER_J)
        ),
        _ => "not known, since nothing stops the plate or the run ended early: no solid plate to compare with; \
              give --spring-mass"
            .to_owned(),
    };
    let _ = writeln!(
        page,
        "areal mass: over the plate's face of {} cm^2, its mass over rho h\nspring: {spring}\nmount: {} g (--mount-mass)",
        fixed_significant(1e4 * report.face_m2, 3),
        gram(report.mount_kg)
    );
}
