//! A comparison in sentences: the same on the command line and in the workbench.

use crate::model::run::envelope;
use crate::model::scene::{PlateSize, Scene, SpringKind};
use crate::model::units::{fixed_significant, significant, velocity};
use crate::study::compare::sized::THINNEST_M;
use crate::study::compare::solid::{Thickness, thickness_of_limit};
use crate::study::compare::{Candidate, Entry, Profitability, Report, Sized};

/// Whether the mechanism pays, and by how much.
pub fn verdict(report: &Report) -> String {
    let design = velocity(report.scene.projectile.velocity_m_s, 4);
    let Some(own) = report.of(Candidate::Scene) else {
        return "cancelled before the scene itself was computed".to_owned();
    };
    let verdict = report.verdict();
    let efficiency = own.mass_efficiency().map(|it| fixed_significant(it, 4));
    let by_closure = own.by_closure().map(|it| (it.range(), ", by both closures"));
    match (verdict, efficiency.map(|it| (it, "")).or(by_closure)) {
        (
            Profitability::Pays | Profitability::DoesNotPay | Profitability::MakesNoDifference,
            Some((it, by)),
        ) => {
            format!(
                "mass efficiency {it} at {design}: {}{by}{}",
                verdict.words(),
                condition(report)
            )
        }
        (Profitability::Unknown, _) => {
            // What is open, the caution says.
            let why = own.sized.as_ref().err().filter(|it| !it.is_open());
            let why = why.map_or_else(String::new, |it| format!(": {}", it.words()));
            format!("{} ({design}){why}", verdict.words())
        }
        (_, _) => format!("{} ({design})", verdict.words()),
    }
}

/// The condition on parts whose mass is not counted, as the end of the verdict; empty where there is none.
fn condition(report: &Report) -> String {
    if report.uncounted.is_empty() || report.verdict() != Profitability::Pays {
        return String::new();
    }
    let parts = report.uncounted.join(" and ");
    let most = report.spare_mass_kg().map_or_else(
        || "nothing".to_owned(),
        |kg| format!("less than {} g", fixed_significant(1e3 * kg, 3)),
    );
    format!(" if its {parts} weighs {most}")
}

/// What the verdict rests on, a sentence each.
pub fn reasons(report: &Report) -> Vec<String> {
    let Some(own) = report.of(Candidate::Scene) else { return Vec::new() };
    let mut lines = slower_shots(report);
    lines.extend(sized(own, report.verdict()));
    lines.extend(as_built(own));
    lines.extend(crushed(&report.scene));
    lines.extend(outside_validity(report));
    let energy_j_kg = report.scene.mechanism.specific_energy_j_kg();
    if let Some((closed, energy_j_kg)) = report.closed_form().zip(energy_j_kg) {
        let dishing = if report.scene.dishing() { "; this plate dishes" } else { "" };
        let (efficiency, below) =
            (fixed_significant(closed.mass_efficiency, 4), velocity(closed.pays_below_m_s, 4));
        let [needed, own] = [closed.needed_j_per_kg, energy_j_kg].map(|it| significant(it, 4));
        lines.push(format!(
            "check in closed form, for a soft spring without dishing: {efficiency}; pays if e > v^2/(2 (1 + gamma)) = {needed} J/kg, \
             which is below {below} with {own} J/kg{dishing}"
        ));
    }
    lines.extend(limits(report));
    if let Some(ratio) = report.depth_over_solid() {
        let percent = 100.0 * (ratio - 1.0);
        lines.push(format!("depth {percent:+.1} % against the solid plate of equal areal mass"));
    }
    lines
}

/// What a crushed absorber is taken to be: its energy per mass alone does not stop a shot.
fn crushed(scene: &Scene) -> Option<String> {
    let spring = Some(&scene.mechanism.spring).filter(|it| it.kind == SpringKind::Crush)?;
    Some(format!(
        "the absorber is crushed at {} kN over {} mm at most (F_crush, x_crush)",
        significant(1e-3 * spring.crush.force_n, 4),
        significant(1e3 * spring.crush.stroke_m, 4)
    ))
}

/// Where what was judged is outside the model's validity and the scene as built is not: the sized armour, and each candidate at its
/// limit.
fn outside_validity(report: &Report) -> Vec<String> {
    let known = envelope::of_scene(&report.scene);
    let mut lines = Vec::new();
    let mut note = |who: String, scene: &Scene| {
        let new = envelope::of_scene(scene).into_iter();
        let new = new.filter(|breach| known.iter().all(|other| other.check != breach.check));
        let labels: Vec<&str> = new.map(|breach| breach.check.label()).collect();
        if !labels.is_empty() {
            lines.push(format!("{who}: outside the model's validity in {}", labels.join(", ")));
        }
    };
    for entry in &report.entries {
        if let (Candidate::Scene, Ok(sized)) = (entry.candidate, &entry.sized) {
            note("the sized armour".to_owned(), &sized.scene);
        }
        let Some(limit_m_s) = entry.limit_m_s.filter(|_| entry.is_held) else { continue };
        let mut at_limit = (*entry.scene).clone();
        at_limit.projectile.velocity_m_s = limit_m_s;
        note(format!("{} at its limit", entry.candidate.word()), &at_limit);
    }
    let own = report.of(Candidate::Scene).and_then(|own| own.sized.as_ref().ok());
    if own.is_some_and(|sized| sized.scene.target.thickness_m < THINNEST_M) {
        let least = 1e3 * THINNEST_M;
        lines.push(format!(
            "the sized armour: thinner than {least} mm, the least thickness within the model's range"
        ));
    }
    lines
}

/// The two armours that just stop the shot.
fn sized(own: &Entry, verdict: Profitability) -> Option<String> {
    let sized: &Sized = match &own.sized {
        Ok(sized) => sized,
        // The caution says why.
        Err(absence) if absence.is_open() => return None,
        Err(absence) => return Some(format!("no mass efficiency: {}", absence.words())),
    };
    let density = sized.scene.target.density_kg_m3;
    let solid_m = sized.solid_areal_kg_m2 / density;
    let efficiency = match verdict {
        Profitability::Pays | Profitability::DoesNotPay | Profitability::MakesNoDifference => {
            String::new()
        }
        Profitability::Perforated
        | Profitability::NothingStops
        | Profitability::Fails(_)
        | Profitability::Unknown => {
            format!(", mass efficiency {}", fixed_significant(sized.mass_efficiency(), 4))
        }
    };
    let given = match own.scene.plate.size {
        PlateSize::Face(_) => "",
        PlateSize::Ratio | PlateSize::Mass(_) => " (the mass ratio is kept)",
    };
    let scene = &sized.scene;
    let of = if scene.is_stack() { " in its front plate" } else { "" };
    let in_thousandths = [scene.target.thickness_m, scene.plate_face_m(), sized.spring_kg, solid_m];
    let [thickness, face, spring, solid] =
        in_thousandths.map(|value| fixed_significant(1e3 * value, 4));
    let [areal, solid_areal] =
        [sized.areal_kg_m2, sized.solid_areal_kg_m2].map(|value| fixed_significant(value, 4));
    Some(format!(
        "sized to just stop the shot: this armour with {thickness} mm{of} over a face of {face} mm square{given} and {spring} g of spring, \
         {areal} kg/m^2; a solid plate of {solid} mm, {solid_areal} kg/m^2{efficiency}"
    ))
}

/// How the armour as it stands compares.
fn as_built(own: &Entry) -> Option<String> {
    let limit = velocity(own.limit_m_s?, 4);
    if matches!(thickness_of_limit(&own.scene, own.limit_m_s?, false), Some(Thickness::Jump(_))) {
        return Some(format!(
            "no mass efficiency as built: no solid plate has its limit velocity of {limit}, since that jumps where the closure changes, at h = D"
        ));
    }
    let ratio = own.as_built?;
    let thickness = fixed_significant(1e3 * own.scene.target.thickness_m, 4);
    let factor = own.sized.as_ref().ok().map(|sized| 1.0 / sized.factor);
    let needs = factor.map_or_else(String::new, |factor| {
        let times = significant(factor, 3);
        format!("; its {thickness} mm are {times} times the thickness that just stops the shot")
    });
    Some(format!(
        "as built mass efficiency {} at its own limit velocity of {limit}{needs}",
        fixed_significant(ratio, 4)
    ))
}

/// What no limit velocity of a stack tells: that slower shots are not held.
fn slower_shots(report: &Report) -> Vec<String> {
    let slower = report.entries.iter().filter_map(|entry| Some((entry.candidate, entry.slower?)));
    let words = slower.map(|(candidate, (slower_m_s, failure))| {
        let (word, slower, why) = (candidate.word(), velocity(slower_m_s, 4), failure.words());
        format!("{word}: a shot slower than its limit is not held: from {slower} on fewer plates stop it, and {why}")
    });
    words.collect()
}

/// The causes of the limit velocities, and the missing ones.
fn limits(report: &Report) -> Vec<String> {
    let mut lines = Vec::new();
    for entry in &report.entries {
        let word = entry.candidate.word();
        if let (Some(failure), Some(limit)) = (entry.failure, entry.limit_m_s) {
            let plate = entry.perforation.velocity_m_s().map_or_else(
                || "beyond the searched range".to_owned(),
                |plate| format!("at {}", velocity(plate, 4)),
            );
            let (limit, why) = (velocity(limit, 4), failure.words());
            let text =
                format!("limit velocity {limit}, where {why}; the plate is perforated {plate}");
            lines.push(format!("{word}: {text}"));
        }
        lines.extend(entry.no_limit().map(|absence| format!("{word}: {absence}")));
        if !entry.is_held {
            lines.push(format!("{word}: nothing stops plate and projectile"));
        }
    }
    lines
}
