//! Scenes and axes that several tests need.

use crate::study::changed;
use crate::study::sweep::{Axis, Spacing};
use cmra_engine::model::scene::{Mount, Scene};

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
