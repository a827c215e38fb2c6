//! The comparison as a page of text: the verdict, the candidates next to each other, and how mass was taken; and the map.

use std::fmt::Write as _;

use crate::cli::draw;
use crate::cli::text::{hanging, width};
use crate::model::units::{fixed_significant, significant};
use crate::report::compare::beside;
use crate::report::figures::efficiency;
use crate::study::compare::map::Map;
use crate::study::compare::summary;
use crate::study::compare::{Candidate, Report};
use crate::tui::theme::Theme;

/// Columns by which the further lines of a sentence are indented.
const INDENT: usize = 2;
const MAP: draw::Size = (78, 30);
/// Rows of the table of the line of 1.
const LINE_ROWS: u64 = 11;

pub(super) fn text(name: &str, report: &Report) -> String {
    let projectile = &report.scene.projectile;
    let mut page = format!(
        "{name}: does moving armour pay? {} g, design velocity {} m/s\n\n",
        fixed_significant(1e3 * projectile.mass_kg, 4),
        fixed_significant(projectile.velocity_m_s, 4)
    );
    let say = |page: &mut String, text: &str| *page += &hanging("", text, INDENT);
    say(&mut page, &summary::verdict(report));
    if let Some(caution) = report.caution() {
        say(&mut page, &format!("caution: {caution}"));
    }
    page.push('\n');
    page += &beside(report, width());
    page.push('\n');
    for reason in summary::reasons(report) {
        say(&mut page, &reason);
    }
    page.push('\n');
    masses(&mut page, report);
    page
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
        page.push_str("stop: absorbs energy, and its mass is not known; add it to --mount-mass\n");
    }
}

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

/// The line of 1, in numbers.
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
