//! A stack as a table for people: the same lines on the command line and in the workbench.

use crate::study::load::peak_n;
use cmra_engine::model::run::StackRun;
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::units;

/// The sentence, and a line for every plate that was struck, at most 76 columns wide.
pub fn table(first: &Run, stack: &StackRun) -> Vec<String> {
    let mut lines = vec![stack.sentence()];
    if let Some(left) = stack.residual_velocity_m_s {
        lines.push(format!("residual velocity behind it {}", units::velocity(left, 5)));
    }
    lines.push(format!(
        "{:<11}{:>10}  {:<10}{:>9}{:>12}{:>11}{:>10}",
        "plate", "impact m/s", "outcome", "depth mm", "leaves m/s", "travel mm", "mount kN"
    ));
    let mut greatest: Option<(f64, usize)> = None;
    for (plate, run) in first.plates().enumerate() {
        let force_n = peak_n(run);
        if let Some(force_n) = force_n.filter(|n| greatest.is_none_or(|(most, _)| *n > most)) {
            greatest = Some((force_n, plate));
        }
        let through = run.outcome == Outcome::Perforated;
        let depth = run.penetration.final_m.filter(|_| !through).map(|depth| depth * 1e3);
        let depth = if through { "through".to_owned() } else { number(depth) };
        lines.push(format!(
            "{:<11}{:>10}  {:<10}{:>9}{:>12}{:>11}{:>10}",
            stack.name(plate),
            number(Some(run.scene.projectile.velocity_m_s)),
            run.outcome.word(),
            depth,
            number(run.departure.residual_velocity_m_s),
            number(run.max_plate_displacement_m.map(|x| x * 1e3)),
            number(force_n.map(|n| n * 1e-3)),
        ));
    }
    let left = stack.elements - stack.behind.len();
    if left > 0 {
        lines.push(format!("{left} more behind, not reached"));
    }
    if let Some((force_n, plate)) = greatest {
        let force = units::engineering(force_n, "N", 4);
        lines.push(format!("peak mount force of a plate: {force}, {}", stack.name(plate)));
    }
    lines
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| units::fixed_significant(value, 5))
}
