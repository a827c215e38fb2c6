//! Scenes and axes that several tests need.

use crate::study::sweep::{Axis, Spacing};
use crate::study::{changed, run_with};
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::{Mount, Scene};
use cmra_engine::model::simulate::Settings;

/// The default scene with some variables changed: `gamma=2 k=1e5`.
pub(crate) fn scene(pairs: &str) -> Scene {
    changed(Scene::default(), pairs).unwrap()
}

/// The default scene on a rigid mount.
pub(super) fn rigid() -> Scene {
    let mut scene = Scene::default();
    scene.plate.mount = Mount::Rigid;
    scene
}

/// Axes by name and ends, as searches have them.
pub(super) fn axes(list: &[(&str, f64, f64)]) -> Vec<Axis> {
    let axis = |(name, low, high): &(&str, f64, f64)| {
        Axis::new(name, (*low, *high), 2, Spacing::Linear).unwrap()
    };
    list.iter().map(axis).collect()
}

/// Runs the default scene with some variables changed, with its time series.
pub(crate) fn run_of(pairs: &str) -> Run {
    run_with(&scene(pairs), Settings::SERIES).unwrap()
}
