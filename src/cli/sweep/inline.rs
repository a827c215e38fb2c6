//! The scene of a sweep and its axes in comment lines at the head of its CSV.

use std::fmt::Write as _;

use crate::files::export;
use crate::files::preset::Preset;
use crate::study::sweep::{Design, Plan};

/// The held variables and the axes as comment lines `# key: value (unit)`.
pub(super) fn comments(preset: &Preset, plan: &Plan) -> String {
    let axes = plan.axes();
    let held = |key: &str| axes.iter().all(|axis| axis.variable().key != key);
    let mut text =
        export::inline_scene(("sweep of", &preset.name), &preset.scene, |one| held(one.key));
    for axis in axes {
        let unit = export::unit_behind(axis.variable());
        let _ = writeln!(text, "# over {}: {}{unit}", axis.variable().key, axis.range());
    }
    let design = plan.design();
    let _ = match design {
        Design::Factorial => writeln!(text, "# design: {}", design.word()),
        Design::LatinHypercube { seed, .. } | Design::Sobol { seed, .. } => {
            writeln!(text, "# design: {}, {} points, seed {seed}", design.word(), plan.points())
        }
    };
    text
}
