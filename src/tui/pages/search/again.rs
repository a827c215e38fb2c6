//! The command that searches again: what stands beside an exported table.

use std::fmt::Write as _;

use crate::files::clean::shell_word;
use crate::model::scene::InterfaceLaw;
use crate::model::units::{self, significant};
use crate::study::monte_carlo::Distribution;
use crate::study::search::front::{Constraint, Task};
use crate::study::search::nsga;
use crate::study::search::seek::Goal;
use crate::study::sensitivity;
use crate::study::sweep::Axis;
use crate::tui::pages::search::state::Request;

impl Request {
    /// The command that makes it of the scene that was searched: its name, then its options.
    pub fn command(&self) -> String {
        let over = |axes: &[Axis]| -> String {
            axes.iter().map(|axis| [" --over ", &shell_word(&axis.over())].concat()).collect()
        };
        match self {
            Self::Seek(Goal { axis, measure, target }, law) => {
                let (axis, target) = (shell_word(&axis.over()), units::shortest(*target));
                // Of a scene with a fused interface the command takes the plastic one by itself.
                let is_fused = *law == InterfaceLaw::Fused;
                let law = if is_fused { " --set interface=fused" } else { "" };
                format!("seek --over {axis} --goal {measure}={target}{law}")
            }
            Self::Front(task) => front_command(task, &over(&task.axes)),
            Self::Sensitivity { axes, output, effort } => {
                let sensitivity::SamplingOptions { rows, trajectories, seed } = effort;
                let over = over(axes);
                format!(
                    "sensitivity{over} --output {output} --samples {rows} --trajectories {trajectories} --seed {seed}"
                )
            }
            Self::MonteCarlo(task) => {
                let vary = task.tolerances.iter().map(|it| match it.distribution {
                    Distribution::LogNormal { deviation, .. } => {
                        let percent = significant(100.0 * deviation, 12);
                        format!(" --vary {}=lognormal:{percent}%", it.symbol())
                    }
                    _ => String::new(),
                });
                let vary: String = vary.collect();
                format!("montecarlo{vary} --samples {} --seed {}", task.samples, task.seed)
            }
        }
    }
}

fn front_command(task: &Task, over: &str) -> String {
    let names = |maximise| {
        let those = task.objectives.iter().filter(move |it| it.maximise == maximise);
        those.map(|it| it.measure.name).collect::<Vec<&str>>().join(",")
    };
    let mut command = format!("optimise{over} --minimise {}", names(false));
    let (feasible, bounds): (Vec<_>, Vec<_>) =
        task.constraints.iter().partition(|it| it.is_feasibility);
    let mut bounds: Vec<String> = bounds.into_iter().map(Constraint::text).collect();
    if bounds.is_empty() {
        // Without a bound the command has one on the stroke.
        bounds.push("stroke_m>=0".to_owned());
    }
    for bound in bounds {
        let _ = write!(command, " --subject-to {}", shell_word(&bound));
    }
    let feasible = if feasible.is_empty() { " --no-feasibility" } else { "" };
    let laws: Vec<&str> = task.laws.iter().map(|law| law.word()).collect();
    let nsga::EvolutionOptions { population, generations, seed } = task.effort;
    let _ = write!(
        command,
        "{feasible} --laws {} --population {population} --generations {generations} --seed {seed}",
        laws.join(",")
    );
    command
}
