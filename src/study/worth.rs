//! Is the mechanism worth it? Chapter 4's own criterion: against the same plate on a rigid mount, against the plate merely free,
//! and against a solid plate of equal areal mass, all under the same shot.
//!
//! Areal mass: the plate is a block of its material, so its face is `m_2`/(rho h); plate, spring and mount together over that face.
//! The solid plate is of the same material, held rigidly, and as thick as that mass makes it. Mass efficiency is the areal mass of
//! the solid plate with the same limit velocity over the candidate's own. Must not know files, threads, screens or a clock.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::impact::{Settings, simulate};
use crate::model::mechanism::Mechanism;
use crate::model::run::{EndReason, Outcome, Run};
use crate::model::scene::{Mount, Scene};
use crate::model::variables::{self, VariableError};
use crate::numerics::larger;
use crate::study::limit::{self, Limit};

pub(in crate::study) mod load;
mod solid;

pub use solid::thickness_of_limit_m;

/// Least mass of a helical steel spring that stores one joule, kg: its wire, in torsion, stores tau²/(4 G) a volume; rho 7850
/// kg/m³, G 7.93e10 Pa, tau 7e8 Pa.
pub const SPRING_KG_PER_J: f64 = 4.0 * 7850.0 * 79.3e9 / (700e6 * 700e6);

/// Who is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Candidate {
    /// The scene as it is.
    Scene,
    /// The same plate, held rigidly.
    Rigid,
    /// The same plate without spring, damper, stop and cocking.
    Free,
    /// A solid plate of the scene's areal mass, held rigidly.
    Solid,
}

impl Candidate {
    /// All, in the order of tables.
    pub const ALL: [Self; 4] = [Self::Scene, Self::Rigid, Self::Free, Self::Solid];

    /// The word in files and on screens.
    pub fn word(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Rigid => "rigid mount",
            Self::Free => "free plate",
            Self::Solid => "solid plate",
        }
    }
}

/// What there is besides the plate.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Masses {
    /// The spring's mass, >= 0 kg; `None`: that of the scene's own beams, or the least a steel spring needs for the
    /// energy it has to store.
    pub spring_kg: Option<f64>,
    /// Everything else that carries the plate, >= 0 kg.
    pub mount_kg: f64,
}

/// The figures of one candidate; `None` where a figure does not exist.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Which.
    pub candidate: Candidate,
    /// The scene that was run.
    pub scene: Arc<Scene>,
    /// What became of the scene's own shot.
    pub outcome: Outcome,
    /// The limit.
    pub limit: Limit,
    /// Everything of it over the plate's face, kg/m²; `None` where the spring's mass is not known.
    pub areal_kg_m2: Option<f64>,
    /// Depth of the hole, m; `None` when perforated.
    pub depth_m: Option<f64>,
    /// Velocity left after perforation, m/s.
    pub residual_m_s: Option<f64>,
    /// Thickness of the solid plate with the same limit velocity, m.
    pub equivalent_m: Option<f64>,
    /// Areal mass of that over the candidate's own.
    pub mass_efficiency: Option<f64>,
    /// Greatest displacement plus cocking distance, m.
    pub stroke_m: Option<f64>,
    /// Greatest displacement of the plate, m.
    pub back_face_m: Option<f64>,
    /// Greatest force into the mount, N; `None` where there is no mount, or where a rigid stop is hit.
    pub mount_force_n: Option<f64>,
    /// Impulse into the mount up to the greatest displacement, N s.
    pub impulse_n_s: Option<f64>,
    /// Energy in the cocked spring, J.
    pub preload_j: Option<f64>,
}

/// One number of an [`Entry`].
pub struct Figure {
    /// Name in files; it ends in its unit.
    pub name: &'static str,
    /// Read it.
    pub get: fn(&Entry) -> Option<f64>,
}

/// Every number, in the order of files.
#[rustfmt::skip]
pub static FIGURES: &[Figure] = &[
    Figure { name: "thickness_m", get: |entry| Some(entry.scene.target.thickness_m) },
    Figure { name: "areal_mass_kg_m2", get: |entry| entry.areal_kg_m2 },
    Figure { name: "penetration_m", get: |entry| entry.depth_m },
    Figure { name: "residual_velocity_m_s", get: |entry| entry.residual_m_s },
    Figure { name: "limit_velocity_m_s", get: |entry| entry.limit.velocity_m_s() },
    Figure { name: "equivalent_thickness_m", get: |entry| entry.equivalent_m },
    Figure { name: "mass_efficiency", get: |entry| entry.mass_efficiency },
    Figure { name: "stroke_m", get: |entry| entry.stroke_m },
    Figure { name: "max_plate_displacement_m", get: |entry| entry.back_face_m },
    Figure { name: "peak_mount_force_n", get: |entry| entry.mount_force_n },
    Figure { name: "mount_impulse_n_s", get: |entry| entry.impulse_n_s },
    Figure { name: "preload_energy_j", get: |entry| entry.preload_j },
];

/// The comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The plate's face, m².
    pub face_m2: f64,
    /// Greatest energy the spring has to store under this shot or cocked, J; `None` where it is not known.
    pub spring_energy_j: Option<f64>,
    /// The spring's mass that was counted, kg; `None` where it is not known: there is no solid plate then.
    pub spring_kg: Option<f64>,
    /// The scene itself says what its springs weigh.
    pub spring_is_own: bool,
    /// The mass of the mount that was counted, kg.
    pub mount_kg: f64,
    /// The candidates, without those that cannot be made or were not reached.
    pub entries: Vec<Entry>,
    /// Whether it was done to its end.
    pub is_complete: bool,
}

impl Report {
    /// One candidate's figures.
    pub fn of(&self, candidate: Candidate) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.candidate == candidate)
    }

    /// First requirement of chapter 4: depth over that in a solid plate of equal mass; below 1 it is met.
    pub fn depth_over_solid(&self) -> Option<f64> {
        Some(self.of(Candidate::Scene)?.depth_m? / self.of(Candidate::Solid)?.depth_m?)
    }

    /// What is to be said against the limits, and so against the mass efficiency; see [`Limit::caution`].
    pub fn caution(&self) -> Option<String> {
        self.entries.iter().find_map(|entry| entry.limit.caution(&entry.scene))
    }
}

/// Steps of a run after which it is asked again.
const LOOK: u32 = 64;

/// Asked now and then with candidates done and how many there are; `Break` stops, and keeps what there is.
pub type Watch<'a> = &'a mut dyn FnMut(usize, usize) -> ControlFlow<()>;

/// Compare.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense.
pub fn compare(
    scene: &Arc<Scene>,
    masses: Masses,
    watch: Watch<'_>,
) -> Result<Report, VariableError> {
    variables::validate(scene)?;
    variables::require_single(scene)?;
    let face_m2 = scene.plate_mass_kg() / plate_areal(scene);
    let total = Candidate::ALL.len();
    let own = run(scene, &mut || watch(0, total))?;
    let spring_energy_j = spring_energy_j(scene, own.start_m(), own.max_plate_displacement_m);
    let spring_kg = masses
        .spring_kg
        .or(own.mechanism.spring_mass_kg)
        .or_else(|| spring_energy_j.map(|energy| SPRING_KG_PER_J * energy));
    let mount_kg = masses.mount_kg;
    let mut report = Report {
        face_m2,
        spring_energy_j,
        spring_kg,
        spring_is_own: masses.spring_kg.is_none() && own.mechanism.spring_mass_kg.is_some(),
        mount_kg,
        entries: Vec::new(),
        is_complete: false,
    };
    if own.end == EndReason::Cancelled {
        return Ok(report);
    }
    for (done, candidate) in Candidate::ALL.into_iter().enumerate() {
        let mechanism = spring_kg.map(|kg| (kg + mount_kg) / face_m2);
        let Some((made, areal_kg_m2)) = make(scene, candidate, mechanism) else { continue };
        let made = Arc::new(made);
        let limit = limit::alone(&made, &mut |_, _| watch(done, total))?;
        if limit == Limit::Unknown || watch(done, total).is_break() {
            return Ok(report);
        }
        let run = run(&made, &mut || watch(done, total))?;
        if run.end == EndReason::Cancelled {
            return Ok(report);
        }
        report.entries.push(entry(candidate, (made, &run), limit, areal_kg_m2));
    }
    report.is_complete = true;
    Ok(report)
}

/// Areal mass of the plate alone, kg/m².
fn plate_areal(scene: &Scene) -> f64 {
    scene.target.density_kg_m3 * scene.target.thickness_m
}

/// A candidate and its areal mass; `None` where the mechanism's areal mass would be needed and is not known.
fn make(
    scene: &Scene,
    candidate: Candidate,
    mechanism: Option<f64>,
) -> Option<(Scene, Option<f64>)> {
    let mut own = scene.clone();
    own.sweep = None;
    let plate = plate_areal(scene);
    let bare = |own: &mut Scene| {
        own.plate.cocking_m = 0.0;
        own.mechanism.stop.position_m = None;
        own.mechanism.remove_springs();
        own.mechanism.damper.coefficient = 0.0;
    };
    let areal = match candidate {
        Candidate::Scene => mechanism.map(|mechanism| plate + mechanism),
        Candidate::Rigid | Candidate::Free => {
            bare(&mut own);
            let free = candidate == Candidate::Free;
            own.plate.mount = if free { Mount::Sprung } else { Mount::Rigid };
            Some(plate)
        }
        Candidate::Solid => {
            bare(&mut own);
            own.plate.mount = Mount::Rigid;
            let areal = plate + mechanism?;
            own.target.thickness_m = areal / scene.target.density_kg_m3;
            Some(areal)
        }
    };
    Some((own, areal))
}

/// One run with its series, as far as it is wanted.
fn run(
    scene: &Arc<Scene>,
    go_on: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<Run, VariableError> {
    let settings = Settings { series: true, estimate: false };
    let mut steps = 0_u32;
    simulate(scene, &settings, &mut |_| {
        steps = steps.wrapping_add(1);
        if steps.is_multiple_of(LOOK) { go_on() } else { ControlFlow::Continue(()) }
    })
}

fn entry(
    candidate: Candidate,
    (scene, run): (Arc<Scene>, &Run),
    limit: Limit,
    areal_kg_m2: Option<f64>,
) -> Entry {
    let stays = run.outcome == Outcome::Arrested || run.outcome == Outcome::Separated;
    let velocity = limit.velocity_m_s();
    let equivalent_m = velocity.and_then(|velocity| thickness_of_limit_m(&scene, velocity));
    let equal_areal = equivalent_m.map(|thickness| thickness * scene.target.density_kg_m3);
    Entry {
        candidate,
        outcome: run.outcome,
        limit,
        areal_kg_m2,
        depth_m: run.final_penetration_m.filter(|_| stays),
        residual_m_s: run.residual_velocity_m_s,
        equivalent_m,
        mass_efficiency: equal_areal.zip(areal_kg_m2).map(|(equal, own)| equal / own),
        stroke_m: run.stroke_m(),
        back_face_m: run.max_plate_displacement_m,
        mount_force_n: load::peak_n(run),
        impulse_n_s: load::impulse_n_s(run),
        preload_j: (!Mechanism::of(&scene).is_absent()).then_some(run.ledger.initial_spring_j),
        scene,
    }
}

/// Greatest energy in the spring, J: cocked, from where it starts, or at the greatest displacement, m.
pub(in crate::study) fn spring_energy_j(
    scene: &Scene,
    start_m: f64,
    farthest_m: Option<f64>,
) -> Option<f64> {
    let spring = Mechanism::of(scene).spring;
    if scene.plate.mount == Mount::Rigid || spring.is_absent() {
        return Some(0.0);
    }
    let farthest = spring.energy(farthest_m?);
    Some(larger(farthest, spring.energy(start_m)))
}

#[cfg(test)]
mod tests;
