//! Report of the comparison, and of its map, for readers.

use crate::report::Remark;
use crate::report::compare::{UNHELD, beside, picture, reasons, verdict, where_it_pays};
use crate::report::page::{Block, Page, Size};
use crate::report::svg::Picture;
use crate::study::compare::map::Map;
use crate::study::compare::{Absence, Candidate, ComparisonReport, Hardware};
use cmra_engine::model::scene::{Criterion, Scene};
use cmra_engine::model::units::{fixed_significant, significant};

/// Size of the map in text.
const MAP: Size = (78, 30);

/// Returns the report: the verdict, the candidates side by side, the reasons, and how masses are counted.
pub fn page(title: &str, report: &ComparisonReport) -> Page {
    let projectile = &report.scene.projectile;
    let [gram, v] = [1e3 * projectile.mass_kg, projectile.velocity_m_s]
        .map(|value| fixed_significant(value, 4));
    let title = format!("{title}: does moving armour pay? {gram} g, design velocity {v} m/s");
    let mut page = Page::new(title);
    page.space();
    page.paragraph(verdict(report), 2);
    let criterion = report.scene.target.criterion;
    if criterion != Criterion::Passage {
        page.paragraph(format!("criterion: {}", criterion.label()), 2);
    }
    let [caution, table, reasons] = parts(report);
    page.blocks.extend(caution);
    page.space();
    page.blocks.extend(table);
    page.space();
    page.blocks.extend(reasons);
    page.space();
    masses(&mut page, report);
    page
}

/// Returns the parts that every rendering has: cautions, the candidates side by side, and the reasons for the verdict.
pub fn parts(report: &ComparisonReport) -> [Vec<Block>; 3] {
    let caution = report.caution().map(|text| Remark::caution("", format!("caution: {text}")));
    let caution = caution.map(|remark| Block::Fact { remark, column: 2 });
    let mut table = vec![Block::Table(beside(report))];
    if report.entries.iter().any(|entry| !entry.is_held) {
        table.push(Block::Line(UNHELD.to_owned()));
    }
    let reasons = reasons(report).into_iter().map(Block::paragraph).collect();
    [caution.into_iter().collect(), table, reasons]
}

fn masses(page: &mut Page, report: &ComparisonReport) {
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
            let is_at_limit = own.is_some_and(|own| own.is_sized_at_limit);
            let shot =
                if is_at_limit { "the fastest shot that is stopped" } else { "the design shot" };
            format!("{gram} g, the least for {shot} at {energy} (e_spring); {holds}")
        }
        None if report.scene.mechanism.specific_energy_j_kg().is_none() => {
            "not known, since it is no coil; set e_spring or m_spring, or give --absorber"
                .to_owned()
        }
        None => "not known, since nothing stops the plate or the run ended early; set m_spring"
            .to_owned(),
    };
    let face = fixed_significant(1e4 * report.face_m2, 3);
    page.line(format!("areal mass: over the plate's face of {face} cm^2, its mass over rho h"));
    page.line(format!("spring: {spring}"));
    for part in &report.uncounted {
        page.line(format!("{part}: takes up energy, and its mass is not counted"));
    }
}

/// Formats the energy per mass of the springs.
fn per_mass(scene: &Scene) -> String {
    let energy_j_kg = scene.mechanism.specific_energy_j_kg();
    let known = energy_j_kg.map(|energy| significant(energy, 4));
    format!("{} J/kg", known.as_deref().unwrap_or("unknown"))
}

/// Formats the reason why a map has no value.
pub fn no_efficiency(absence: Option<Absence>) -> String {
    let why = absence.map_or_else(String::new, |it| format!(": {}", it.label));
    format!("no point has a mass efficiency{why}")
}

/// Returns the report of a map: where the mechanism pays, and the map.
pub fn map_page(title: &str, map: &Map) -> Page {
    let (x, y, energy) = (map.x().symbol(), map.y().symbol(), per_mass(map.scene()));
    let mut page =
        Page::new(format!("{title}: mass efficiency over {x} and {y}, springs of {energy}"));
    page.space();
    let Some(drawn) = picture(map).filter(|drawn| drawn.values().next().is_some()) else {
        page.line(no_efficiency(map.absence()));
        return page;
    };
    if let Some(place) = where_it_pays(map, map.scene()) {
        page.line(place);
        page.space();
    }
    page.picture(Picture::Map(drawn), MAP);
    page
}
