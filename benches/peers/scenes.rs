//! The eighteen scenes, and the answers the solvers are compared with: none of these comes from a solver that is timed.

use std::ops::ControlFlow;
use std::sync::Arc;

use cmra_engine::model::impact::IntegrationMethod;
use cmra_engine::model::impact::step_by;
use cmra_engine::model::reference::Stored;
use cmra_engine::model::run::{Outcome, RunSnapshot};
use cmra_engine::model::scene::{Mount, Scene};
use cmra_engine::model::variables::changed_free_plate;

/// Name and changes to Table 9.1 with gamma = 1 and neither spring nor damper. A prime marks a scene that replaces one of an earlier
/// comparison, whose parameters were not recorded.
pub(crate) const SCENES: [(&str, &str); 18] = [
    ("S1", "gamma=1"),
    ("S2", "k=1e5"),
    ("S3'", "gamma=3 k=1e6"),
    ("S4", "k=1e6 n=0.5"),
    ("S5", "k=1e5 n=0.3"),
    ("S6'", "k=1e6 n=1.5"),
    ("S7", "b=1000"),
    ("S8", "b=2000 k=1e5"),
    ("S9'", "b=1000 m=0.5"),
    ("S10", "d=0.5 k=1e5"),
    ("S11'", "d=0.5 k=1e8"),
    ("S12'", "d=0.1 k=1e5 n=1.4 b=500"),
    ("S13", "k=1e6 n=0.1"),
    ("S14'", "k=7.5e6 n=0.1"),
    ("S15", "k=1e9"),
    ("S16'", "b=1e6 k=1e5"),
    ("S17", "h=0.003 v_i=400 k=1e5"),
    ("S18'", "h=0.003 v_i=300 k=1e6 n=0.5"),
];
/// Where the plate moves by less than this part of the nose radius, it is as good as rigid.
const IMMOBILE: f64 = 1e-17;
/// Tolerance of the computed references.
const TIGHT: f64 = 1e-14;

/// Time, s, and depth, m, at the end of the contact.
pub(crate) type End = (f64, f64);

/// Reference results of a scene.
pub(crate) struct Reference {
    /// The time, s, and of an arrest the depth, m.
    t_s: f64,
    depth_m: Option<f64>,
    /// Where it comes from.
    pub(crate) source: &'static str,
}

impl Reference {
    /// The stored digits; else DOP853 at 1e-14 on the simulation's loop; of a plate that provably cannot move, on a rigid mount.
    pub(crate) fn new(name: &str, scene: &Scene) -> Self {
        if let Some(row) = Stored::rows().find(|row| row.name == name) {
            let depth_m = (row.outcome == Outcome::Arrested).then_some(row.depth_m);
            return Self { t_s: row.t_s, depth_m, source: "stored digits" };
        }
        let mut own = scene.clone();
        let is_immobile = greatest_give(scene) < IMMOBILE;
        if is_immobile {
            own.plate.mount = Mount::Rigid;
        }
        let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
        let run = step_by(IntegrationMethod::Dop853(TIGHT), &Arc::new(own), go_on);
        let run = run.expect("a valid scene");
        let run = run.expect("a power law");
        let arrest = run.first_arrest.map(|arrest| (arrest.t_s, Some(arrest.penetration_m)));
        let end = arrest.or_else(|| Some((run.departure.exit_time_s?, None)));
        let (t_s, depth_m) = end.expect("a reference for each scene");
        let source = if is_immobile { "DOP853 at 1e-14: immobile" } else { "DOP853 at 1e-14" };
        Self { t_s, depth_m, source }
    }

    /// The greater of the relative errors of depth and time; of a perforation, whose depth is a matter of definition, that of
    /// time.
    pub(crate) fn error(&self, (t_s, depth_m): End) -> f64 {
        let time = (t_s / self.t_s - 1.0).abs();
        let depth = self.depth_m.map_or(0.0, |right| (depth_m / right - 1.0).abs());
        if time > depth || time.is_nan() { time } else { depth }
    }
}

/// A bound on how far an uncocked spring gives way under the greatest contact force, over the nose radius. (Undamped the
/// plate oscillates at most twice as far as its rest position, in a convex potential.)
fn greatest_give(scene: &Scene) -> f64 {
    let (r, v) = (scene.projectile.tip_radius_m, scene.projectile.velocity_m_s);
    let pressure = scene.flow_strength_pa() + scene.drag_kg_m3() * v * v;
    let force = std::f64::consts::PI * r * r * pressure;
    let spring = &scene.mechanism.spring;
    // k x^(n+1)/(n+1) = F x is the farthest point of a plate pushed from rest by a constant force.
    let farthest =
        ((spring.exponent + 1.0) * force / spring.coefficient).powf(1.0 / spring.exponent);
    if scene.plate.cocking_m == 0.0 { farthest / r } else { f64::INFINITY }
}

/// The scene of a row at a tolerance.
pub(crate) fn scene(pairs: &str, tolerance: f64) -> Arc<Scene> {
    let mut scene = changed_free_plate(pairs).expect("legal values");
    scene.run.tolerance = tolerance;
    Arc::new(scene)
}
