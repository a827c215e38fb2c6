//! Plates of a stack: outcome of the shot, and a row for every plate that was struck.

use crate::report::page::Block;
use crate::report::table::Cells;
use crate::study::load::peak_n;
use cmra_engine::model::run::{Outcome, Run, StackRun};
use cmra_engine::model::units;

/// Lists the outcome, the struck plates and the greatest force on a mount; empty for a single plate.
pub fn blocks(run: &Run) -> Vec<Block> {
    let Some(stack) = &run.stack else { return Vec::new() };
    let mut lines = vec![stack.sentence()];
    if let Some(left) = stack.residual_velocity_m_s {
        lines.push(format!("residual velocity behind it {}", units::velocity(left, 5)));
    }
    let mut blocks: Vec<Block> = lines.into_iter().map(Block::Line).collect();
    blocks.push(Block::Table(table(run, stack)));
    let left = stack.elements - stack.behind.len();
    if left > 0 {
        blocks.push(Block::Line(format!("{left} more behind, not reached")));
    }
    if let Some((force_n, plate)) = peak_mount_n(run) {
        let force = units::engineering(force_n, "N", 4);
        blocks.push(Block::Line(format!("peak mount force of a plate: {force}, {plate}")));
    }
    blocks
}

/// Returns the greatest force on a mount of a stack, N, and the name of its plate; `None` for a single plate.
pub fn peak_mount_n(run: &Run) -> Option<(f64, String)> {
    let stack = run.stack.as_ref()?;
    let forces =
        run.plates().enumerate().filter_map(|(plate, run)| Some((peak_n(run)?, stack.name(plate))));
    // The first of equal ones.
    forces.reduce(|most, other| if other.0 > most.0 { other } else { most })
}

fn table(first: &Run, stack: &StackRun) -> Vec<Cells> {
    let column = |head: &str, is_text: bool, text: &dyn Fn(usize, &Run) -> String| Cells {
        head: head.to_owned(),
        is_text,
        cells: first.plates().enumerate().map(|(plate, run)| text(plate, run)).collect(),
    };
    let number = |value: Option<f64>| {
        value.map_or_else(|| units::NO_NUMBER.to_owned(), |it| units::fixed_significant(it, 5))
    };
    let depth = |run: &Run| match run.outcome {
        Outcome::Perforated => "through".to_owned(),
        _ => number(run.penetration.final_m.map(|depth_m| 1e3 * depth_m)),
    };
    vec![
        column("plate", true, &|plate, _| stack.name(plate)),
        column("impact m/s", false, &|_, run| number(Some(run.scene.projectile.velocity_m_s))),
        column("outcome", true, &|plate, run| stack.outcome_of(plate, run).word().to_owned()),
        column("depth mm", false, &|_, run| depth(run)),
        column("leaves m/s", false, &|_, run| number(run.departure.residual_velocity_m_s)),
        column("travel mm", false, &|_, run| number(run.max_plate_displacement_m.map(|x| 1e3 * x))),
        column("mount kN", false, &|_, run| number(peak_n(run).map(|force_n| 1e-3 * force_n))),
    ]
}
