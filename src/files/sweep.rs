//! What stands above the scene beside a sweep's table: what is missing, the warnings, and the command that makes the rows again.

use std::fmt::Write as _;

use crate::files::{clean, export};
use crate::model::scene::Scene;
use crate::study::quantities;
use crate::study::sweep::axis::scene_with;
use crate::study::sweep::{Axis, Shard};
use crate::study::validity;

/// The comment lines above a scene with its `[sweep]`, whose file is called `own`; `missing`: that the table is not complete.
pub fn notes(own: &str, scene: &Scene, shard: Shard, missing: Option<&str>) -> String {
    let mut command = "sweep".to_owned();
    if shard != Shard::WHOLE {
        let _ = write!(command, " --shard {shard}");
    }
    let mut text = String::new();
    for note in missing.map(str::to_owned).into_iter().chain(warnings(scene)) {
        let _ = writeln!(text, "# {note}");
    }
    text + &export::again(&command, own)
}

/// Warnings about the rows, as lines of a sidecar.
fn warnings(scene: &Scene) -> Vec<String> {
    let sweep = scene.sweep.as_ref();
    let axes = sweep.and_then(|sweep| Axis::all_of(sweep).ok()).unwrap_or_default();
    let ends: Vec<f64> = axes.iter().map(|axis| axis.ends().0).collect();
    let mut warnings = validity::of_points(&scene_with(scene, &axes, &ends), &axes);
    let outputs = sweep.into_iter().flat_map(|sweep| &sweep.outputs);
    let outputs: Vec<_> = outputs.filter_map(|name| quantities::find(name)).collect();
    warnings.extend(validity::of_pair(scene, &axes, &outputs));
    warnings.iter().map(|warning| format!("warning: {}", clean::line(warning))).collect()
}
