//! The hardware besides the plates: its mass, and its limits.

use crate::model::mechanism::load::exceeded;
use crate::model::mechanism::{Inertia, Mechanism};
use crate::model::run::Run;
use crate::model::scene::{Mount, Scene};
use crate::study::compare::elements;

/// Energies this part apart are the same.
const SAME: f64 = 1e-9;

/// The hardware besides each plate. The energy that a spring or absorber takes up per mass is a variable of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Hardware {
    /// The spring's mass, >= 0 kg; `None`: that of the scene's own springs where they know it, or the least for the energy.
    pub spring_kg: Option<f64>,
    /// Everything else that carries the plate, >= 0 kg.
    pub mount_kg: f64,
    /// The stroke there is, > 0 m; `None`: enough.
    pub stroke_m: Option<f64>,
}

/// The failure before the plate is perforated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The spring would have to store more than its mass can.
    Energy,
    /// The spring leaves the range of its law; what the range is.
    Range(&'static str),
    /// The stroke is longer than there is room for.
    Stroke,
}

impl Failure {
    /// The failure, as the end of a sentence.
    pub fn words(self) -> String {
        match self {
            Self::Energy => "the spring reaches its energy capacity".to_owned(),
            Self::Range(what) => what.to_owned(),
            Self::Stroke => "the stroke exceeds the available stroke".to_owned(),
        }
    }

    /// One or two words for a table.
    pub fn word(self) -> &'static str {
        match self {
            Self::Energy => "spring full",
            Self::Range(_) => "spring law",
            Self::Stroke => "stroke",
        }
    }
}

impl Hardware {
    pub(super) fn bare() -> Self {
        Self { spring_kg: Some(0.0), mount_kg: 0.0, stroke_m: None }
    }
}

/// The load of a shot on the mechanism of one element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Demand {
    /// Greatest displacement, m; `None` where nothing stops the plate, or where it is not known.
    pub(super) max_displacement_m: Option<f64>,
    /// Greatest energy in the springs, J.
    pub(super) stored_j: Option<f64>,
}

impl Demand {
    pub(super) fn of(element: &Scene, max_displacement_m: Option<f64>) -> Self {
        let stored_j = spring_energy_j(element, element.start_m(), max_displacement_m);
        Self { max_displacement_m, stored_j }
    }

    fn of_rest(element: &Scene) -> Self {
        Self::of(element, Some(element.start_m()))
    }

    /// The demands of every element of a run's scene.
    pub(super) fn of_run(run: &Run, elements: &[Scene]) -> Vec<Self> {
        let mut runs = run.plates();
        let demand = |element: &Scene| {
            let struck = runs.next();
            struck.map_or_else(
                || Self::of_rest(element),
                |run| Self::of(element, run.max_plate_displacement_m),
            )
        };
        elements.iter().map(demand).collect()
    }
}

/// The mass of an element's springs for a demand, kg; `None` where it is not known.
fn spring_kg(hardware: &Hardware, element: &Scene, demand: &Demand) -> Option<f64> {
    let least_kg = || element.mechanism.least_spring_kg(demand.stored_j?);
    hardware.spring_kg.or_else(|| Inertia::of(element).spring_kg(least_kg()))
}

/// Whether the springs of a scene know their own mass.
pub(super) fn is_own(scene: &Scene) -> bool {
    Inertia::of(scene).spring_mass_kg.is_some()
}

/// The failure of an element when a spring of this capacity, J, meets the demand.
fn failure(
    hardware: &Hardware,
    element: &Scene,
    demand: &Demand,
    capacity_j: f64,
) -> Option<Failure> {
    let max_displacement_m =
        demand.max_displacement_m.filter(|_| element.plate.mount == Mount::Sprung)?;
    if let Some(limit) = exceeded(element, max_displacement_m).first() {
        return Some(Failure::Range(limit.what));
    }
    let stroke_m = max_displacement_m + element.plate.cocking_m;
    if hardware.stroke_m.is_some_and(|room| stroke_m > room * (1.0 + SAME)) {
        return Some(Failure::Stroke);
    }
    demand.stored_j.filter(|stored| *stored > capacity_j * (1.0 + SAME)).map(|_| Failure::Energy)
}

/// The energy that springs of this mass can store, J: without bound in beams, whose law says itself how far it goes, and where
/// their specific energy is not known.
fn capacity_j(hardware: &Hardware, element: &Scene, spring_kg: Option<f64>) -> f64 {
    if hardware.spring_kg.is_none() && element.mechanism.spring.has_own_mass() {
        return f64::INFINITY;
    }
    let capacity_j = spring_kg.zip(element.mechanism.specific_energy_j_kg()).map(|(kg, e)| kg * e);
    capacity_j.unwrap_or(f64::INFINITY)
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Built {
    hardware: Hardware,
    elements: Vec<Scene>,
    /// The springs' mass, kg, and what they can store, J, by element.
    springs_kg: Vec<Option<f64>>,
    capacities_j: Vec<f64>,
}

impl Built {
    /// Size the springs of a scene for a run.
    pub(super) fn of(scene: &Scene, hardware: &Hardware, run: &Run) -> Self {
        let elements = elements(scene);
        let demands = Demand::of_run(run, &elements);
        Self::for_demands(elements, hardware, &demands)
    }

    /// Size the springs of a scene's elements for their demands.
    pub(super) fn for_demands(
        elements: Vec<Scene>,
        hardware: &Hardware,
        demands: &[Demand],
    ) -> Self {
        let pairs = elements.iter().zip(demands);
        let springs_kg: Vec<Option<f64>> =
            pairs.map(|(element, demand)| spring_kg(hardware, element, demand)).collect();
        let pairs = elements.iter().zip(&springs_kg);
        let capacities_j = pairs.map(|(element, kg)| capacity_j(hardware, element, *kg)).collect();
        Self { hardware: *hardware, elements, springs_kg, capacities_j }
    }

    /// All springs together, kg; `None` where one is not known.
    pub(super) fn spring_kg(&self) -> Option<f64> {
        self.springs_kg.iter().copied().sum()
    }

    /// Areal mass of the scene with these springs, kg/m².
    pub(super) fn areal_kg_m2(&self, scene: &Scene) -> Option<f64> {
        let mut sum = 0.0;
        for (element, spring_kg) in self.elements.iter().zip(&self.springs_kg) {
            let plate = element.target.density_kg_m3 * element.target.thickness_m;
            let besides_kg = (*spring_kg)? + self.hardware.mount_kg;
            sum += plate * (1.0 + besides_kg / element.plate_mass_kg());
        }
        let base = scene.stack.base_thickness_m;
        Some(sum + base.map_or(0.0, |thickness| thickness * scene.target.density_kg_m3))
    }

    pub(super) fn failure(&self, run: &Run) -> Option<Failure> {
        self.failure_under(&Demand::of_run(run, &self.elements))
    }

    /// The failure of the elements under these demands.
    pub(super) fn failure_under(&self, demands: &[Demand]) -> Option<Failure> {
        let mut each = self.elements.iter().zip(demands).zip(&self.capacities_j);
        each.find_map(|((element, demand), capacity_j)| {
            failure(&self.hardware, element, demand, *capacity_j)
        })
    }
}

/// Greatest energy in the springs between where the plate starts and its greatest displacement, J.
pub(in crate::study) fn spring_energy_j(
    scene: &Scene,
    start_m: f64,
    max_displacement_m: Option<f64>,
) -> Option<f64> {
    let spring = Mechanism::of(scene).spring;
    if scene.plate.mount == Mount::Rigid || spring.is_absent() {
        return Some(0.0);
    }
    Some(spring.greatest_energy(start_m, max_displacement_m?))
}
