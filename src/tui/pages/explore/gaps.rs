//! Why a picture is empty, in words: no point has a value of the output shown.

use crate::study::sweep::PointOutcome;
use crate::study::sweep::grid::{Cell, Grid};

/// Why no point of a picture has a value of an output that can be drawn, and what to do about it, in a few lines.
pub fn no_value(grid: &Grid, output: usize) -> Vec<String> {
    let column = grid.plan().outputs()[output];
    let name = column.title();
    let (done, _) = grid.progress();
    if done == 0 {
        return vec!["sweeping the first points".to_owned()];
    }
    let (along, up) = grid.counts();
    let mut points = (0..along).flat_map(|x| (0..up).map(move |y| (x, y)));
    if points.any(|(x, y)| matches!(grid.cell(x, y, output), Cell::Value(_))) {
        return lines(&format!("no {name} above 0: a log scale shows none"), &["Y: linear scale"]);
    }
    let counts = grid.outcomes();
    let all = counts.total();
    let other = "v, or Show in the setup (Tab): another output";
    if counts.perforated == all {
        let instead = "or show residual_velocity_m_s (Tab, Show)";
        let cure = ["lower v_i, or raise h or S_y (Tab, Hold)", instead];
        return lines(&format!("every point perforates: no {name}"), &cure);
    }
    if counts.arrested + counts.separated == all {
        let why = match column.name {
            "residual_velocity_m_s" | "exit_time_s" => "every point is stopped",
            _ => PointOutcome::Arrested.without_value(column),
        };
        return lines(&format!("no {name}: {why}"), &[other]);
    }
    if counts.moving == all {
        let cure = ["a longer horizon decides them (Tab, Hold)", other];
        return lines(&format!("every point still moves at the end: no {name}"), &cure);
    }
    if counts.failed == all {
        return lines(
            "every point failed",
            &["Enter opens one in the Run tab, and 7:Log says why"],
        );
    }
    lines(&format!("no point has a {name}"), &[&counts.to_string(), other])
}

/// How many points came to rest and still have no value of an output, with the letter of these gaps and what it means.
pub(in crate::tui) fn at_rest(grid: &Grid, output: usize) -> Option<String> {
    let (along, up) = grid.counts();
    let points = (0..along).flat_map(|x| (0..up).map(move |y| (x, y)));
    let rested = |(x, y): (usize, usize)| match grid.outcome(x, y)? {
        outcome @ (PointOutcome::Arrested | PointOutcome::Separated) => {
            Some((outcome, grid.value(x, y, output)))
        }
        PointOutcome::Perforated | PointOutcome::Moving | PointOutcome::Failed(_) => None,
    };
    let mut without = points.filter_map(rested).filter(|point| point.1.is_none());
    let (outcome, _) = without.next()?;
    let why = outcome.without_value(grid.plan().outputs()[output]);
    Some(format!("{} {}: {why}", 1 + without.count(), outcome.letter()))
}

/// The reason, then what to do about it.
fn lines(what: &str, cures: &[&str]) -> Vec<String> {
    std::iter::once(what).chain(cures.iter().copied()).map(str::to_owned).collect()
}
