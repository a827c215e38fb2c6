//! What the commands that look for designs have in common: reading bounds, and saying how long it will take.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use crate::cli::sweep::axes::over;
use crate::cli::sweep::page::duration;
use crate::cli::{CliError, output};
use crate::model::scene::Scene;
use crate::study::search::field::Field;
use crate::study::sensitivity::thesis_axes;
use crate::study::sweep::crew::Crew;
use crate::study::sweep::{Axis, COUNTS};

/// A search expected to take longer says so before it begins.
const LONG: Duration = Duration::from_secs(60);
/// Designs tried for that, and how long they may take.
const TRIED: usize = 32;
const TRYING: Duration = Duration::from_millis(250);
/// At the most one run for so many is tried: a search of fewer is not asked how long it will take.
const SPARED: usize = 4;

/// The threads asked for, or one for each core.
pub(super) fn threads(asked: Option<u16>) -> usize {
    asked.map_or_else(|| Crew::of_machine().threads, usize::from)
}

/// Variables and their bounds; without any those of Table 9.2.
pub(super) fn bounds(texts: &[String], scene: &Scene) -> Result<Vec<Axis>, CliError> {
    if !texts.is_empty() {
        return texts.iter().map(|text| over(text, Some(*COUNTS.start()), &COUNTS)).collect();
    }
    let axes = thesis_axes(scene)?;
    if axes.is_empty() {
        return Err(CliError::Option(
            "no variable of Table 9.2 has an effect on this scene: name one, for example --over v_i=80..120"
                .to_owned(),
        ));
    }
    Ok(axes)
}

/// Try a few designs spread over the bounds, and say how long so many runs will take where that is long.
pub(super) fn say_if_long(field: &Field, runs: usize, threads: usize) {
    let most = TRIED.min(runs / SPARED);
    if most == 0 {
        return;
    }
    let start = Instant::now();
    let mut tried = 0;
    while tried < most && start.elapsed() < TRYING {
        // Shares that do not fall on one line through the box.
        let share = |axis: usize| (0.5 + 0.618_034 * (tried * (axis + 1)) as f64).fract();
        let axes = field.axes().iter().enumerate();
        let design = axes.map(|(at, axis)| axis.at_share(share(at))).collect();
        let _ = field.evaluate(&[design], &mut |_| ControlFlow::Continue(()));
        tried += 1;
    }
    let each_s = start.elapsed().as_secs_f64() / tried.max(1) as f64;
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let takes_s = each_s * runs as f64 / threads.min(cores) as f64;
    if takes_s > LONG.as_secs_f64() {
        output::note(&format!(
            "{runs} runs will take about {} (estimated from {tried} of them); an interrupt keeps what is finished",
            duration(takes_s)
        ));
    }
}
