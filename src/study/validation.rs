//! Measurements from outside the thesis, and what the model makes of them with nothing fitted.
//!
//! What was measured is written here with where it comes from; what the model gives is always computed, by the case's own
//! closure for the flow strength and by the other one. The scenes are bundled presets of the same names.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::impact::{Settings, simulate};
use crate::model::scene::{Closure, Scene};
use crate::model::units::Bare;
use crate::model::variables;
use crate::study::limit;

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The ballistic limit, m/s.
    Limit,
    /// The depth, m.
    Depth,
}

impl Quantity {
    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Limit => "ballistic limit",
            Self::Depth => "depth",
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Limit => "m/s",
            Self::Depth => "m",
        }
    }
}

/// One measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// A short name.
    pub id: &'static str,
    /// The bundled preset of the shot.
    pub preset: &'static str,
    /// What differs from the preset, as `--set` takes it.
    pub set: &'static [(&'static str, &'static str)],
    /// What was measured.
    pub quantity: Quantity,
    /// The measurement, in its unit.
    pub measured: f64,
    /// Its resolution, where it is known, in its unit.
    pub resolution: Option<f64>,
    /// Where it comes from.
    pub source: &'static str,
    /// Where the model must not be used, seen in this case.
    pub caution: &'static str,
}

const BORVIK: &str = "Borvik, Langseth, Hopperstad and Malo, IJIE 27 (2002) 19, by a reader's ledger of the paper: second-hand";
const SPHERE: &str =
    "Qiang et al. (2022), doi 10.1177/09544062221080139, quoting an experiment: second-hand";
const CORE: &str =
    "Forrestal, Borvik, Warren and Chen, Exp. Mech. 54 (2014) 471, by the REL database (CC BY 4.0)";
const CONCRETE: &str = "Li and Chen's shot 14, as worked on a public page: second-hand";

/// The measurements, in the order of the field notes.
pub const CASES: [Case; 6] = [
    Case {
        id: "borvik-hemispherical",
        preset: "validation-borvik",
        set: &[],
        quantity: Quantity::Limit,
        measured: 292.1,
        resolution: Some(5.0),
        source: BORVIK,
        caution: "one point: the plate failed by necking and a plug, which the law does not contain; both closures meet it, so \
                  it cannot tell them apart. Blunt noses (184.5 m/s) plug far earlier",
    },
    Case {
        id: "borvik-lower-yield",
        preset: "validation-borvik",
        set: &[("Y", "460MPa")],
        quantity: Quantity::Limit,
        measured: 292.1,
        resolution: Some(5.0),
        source: BORVIK,
        caution: "the nominal yield strength instead of the fitted 490 MPa: how far the answer moves with it",
    },
    Case {
        id: "sphere-on-thin-steel",
        preset: "validation-thin-sphere",
        set: &[],
        quantity: Quantity::Limit,
        measured: 205.1,
        resolution: None,
        source: SPHERE,
        caution: "h/D of 0.06 is far below what the law is made for: a thin plate stretches as a membrane. Agreement is luck",
    },
    Case {
        id: "sphere-lower-yield",
        preset: "validation-thin-sphere",
        set: &[("Y", "215MPa")],
        quantity: Quantity::Limit,
        measured: 205.1,
        resolution: None,
        source: SPHERE,
        caution: "the yield strength of 304 steel is between 215 and 310 MPa: inside that spread nothing is shown",
    },
    Case {
        id: "ap-core-on-aluminium",
        preset: "validation-ap-core",
        set: &[],
        quantity: Quantity::Limit,
        measured: 514.0,
        resolution: None,
        source: CORE,
        caution: "an ogive nose, here a sphere with the ogive's drag (N = 0.106): the area law is not its own, and h/D of 3 rules \
                  out dishing",
    },
    Case {
        id: "ogive-in-concrete",
        preset: "validation-concrete",
        set: &[],
        quantity: Quantity::Depth,
        measured: 0.173,
        resolution: None,
        source: CONCRETE,
        caution: "concrete spalls a crater on entry that resists less, and the nose is an ogive: neither is in the model",
    },
];

/// A case with what the model makes of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The case.
    pub case: &'static Case,
    /// By the case's own closure; `None` where the model gives nothing.
    pub computed: Option<f64>,
    /// Its closure's word.
    pub closure: &'static str,
    /// By the other closure; `None` where the flow strength is given outright.
    pub other: Option<f64>,
    /// Plate thickness over projectile diameter.
    pub thickness_ratio: f64,
    /// Pressure on the nose at the start, which the projectile must bear to stay rigid, Pa.
    pub pressure_pa: f64,
}

impl Row {
    /// How far off a value is, relative to the measurement.
    pub fn error(&self, value: f64) -> f64 {
        value / self.case.measured - 1.0
    }
}

/// Compute a case from its preset's scene.
pub fn compute(case: &'static Case, preset: &Scene) -> Row {
    let mut scene = preset.clone();
    for (name, value) in case.set {
        // A text that cannot be set would be seen at once: the row's numbers would be the preset's.
        let _ = variables::set_by_name(&mut scene, name, value, Bare::Si);
    }
    let v = scene.projectile.velocity_m_s;
    Row {
        case,
        computed: value(case.quantity, &scene),
        closure: match scene.target.closure {
            Closure::Given => "given",
            Closure::DoubleYield => "double-yield",
            Closure::Cavity => "cavity",
        },
        other: other(&scene).and_then(|scene| value(case.quantity, &scene)),
        thickness_ratio: 0.5 * scene.target.thickness_m / scene.projectile.tip_radius_m,
        pressure_pa: scene.flow_strength_pa() + scene.drag_kg_m3() * v * v,
    }
}

/// The scene under the other closure, with the drag each is made with: Virostek's `C_d` = 0.5 for 2 Y, a hemisphere's 1 for
/// cavity expansion.
fn other(scene: &Scene) -> Option<Scene> {
    let mut own = scene.clone();
    (own.target.closure, own.target.dishing, own.target.drag_coefficient) =
        match scene.target.closure {
            Closure::Given => return None,
            Closure::DoubleYield => (Closure::Cavity, false, 1.0),
            Closure::Cavity => (Closure::DoubleYield, true, 0.5),
        };
    Some(own)
}

fn value(quantity: Quantity, scene: &Scene) -> Option<f64> {
    variables::validate(scene).ok()?;
    match quantity {
        Quantity::Limit => limit::closed_form(scene),
        Quantity::Depth => {
            let settings = Settings { series: false, estimate: false };
            let scene = Arc::new(scene.clone());
            let run = simulate(&scene, &settings, &mut |_| ControlFlow::Continue(())).ok()?;
            run.final_penetration_m
        }
    }
}
