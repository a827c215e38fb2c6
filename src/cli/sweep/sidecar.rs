//! The scene beside a sweep's CSV, a scene file whose `[sweep]` makes the same rows again, or in comment lines at its head.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use crate::cli;
use crate::files::export;
use crate::files::preset::Preset;
use crate::files::shard::Part;
use crate::files::style::Style;
use crate::model::scene::Sweep;
use crate::report::sweep::Columns;
use crate::study::sweep::{Axis, Design, Plan, Shard};

/// What was made.
pub(super) struct Made<'a> {
    pub(super) plan: &'a Plan,
    pub(super) columns: Columns,
    pub(super) shard: Shard,
    pub(super) style: Style,
    /// What is missing of it, in words.
    pub(super) missing: Option<String>,
}

/// Its path and its text; `None` where there is no place beside the file.
pub(super) fn beside(csv: &Path, preset: &Preset, made: &Made<'_>) -> Option<(PathBuf, String)> {
    if !cli::sidecar::is_ordinary(csv) {
        return None;
    }
    let mut scene = preset.scene.clone();
    scene.sweep = Some(sweep(made));
    let part = Part {
        shard: made.shard,
        design: made.plan.design(),
        name: preset.name.clone(),
        style: made.style,
    };
    Some((export::sidecar_path(csv, None), part.sidecar(csv, &scene, made.missing.as_deref())))
}

/// The held variables and the axes as comment lines `# key: value (unit)`.
pub(super) fn inline(preset: &Preset, made: &Made<'_>) -> String {
    let axes = made.plan.axes();
    let held = |key: &str| axes.iter().all(|axis| axis.variable().key != key);
    let mut text =
        export::inline_scene(("sweep of", &preset.name), &preset.scene, |one| held(one.key));
    for axis in axes {
        let unit = export::unit_behind(axis.variable());
        let _ = writeln!(text, "# over {}: {}{unit}", axis.variable().key, axis.range());
    }
    let design = made.plan.design();
    let _ = match design {
        Design::Factorial => writeln!(text, "# design: {}", design.word()),
        Design::LatinHypercube { seed, .. } | Design::Sobol { seed, .. } => {
            writeln!(
                text,
                "# design: {}, {} points, seed {seed}",
                design.word(),
                made.plan.points()
            )
        }
    };
    text
}

fn sweep(made: &Made<'_>) -> Sweep {
    let axes = made.plan.axes().iter().map(Axis::asked);
    let outputs = match made.columns {
        Columns::Chosen => {
            made.plan.outputs().iter().map(|output| output.name.to_owned()).collect()
        }
        // Without outputs all are meant.
        Columns::All => Vec::new(),
    };
    Sweep { axes: axes.collect(), outputs }
}
