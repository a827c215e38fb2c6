//! Results: builds a [`Run`] from the final state and the records of the loop.

use std::sync::Arc;

use crate::model::closed_form::Passage;
use crate::model::contact::Geometry;
use crate::model::contact_models::ContactLaw;
use crate::model::impact::equations::Equations;
use crate::model::impact::modes::{Contact, HybridMode, PlateConstraint};
use crate::model::impact::parameters::ImpactParameters;
use crate::model::impact::recorder::Recorder;
use crate::model::impact::resolution::{CHANGES_MANY, RESOLUTION};
use crate::model::impact::state::State;
use crate::model::mechanism::{Inertia, PowerLaw, load};
use crate::model::run::{
    AtLeast, CONTACT_WINDOW, Cost, Departure, EndReason, EnergyLedger, ErrorEstimate, EventKind,
    InterfaceLoad, LeftOut, MechanismLoad, NotModelled, Outcome, Penetration, Run, RunWarning,
    Sample,
};
use crate::model::scene::{InterfaceLaw, Scene, Target};
use crate::numerics::larger;

/// Velocity of a damped plate, relative to its maximum, at which the time series ends.
const ARRIVED_SPEED: f64 = 1e-2;
/// Energy residual above which a warning is given, relative to the energy at the start.
const DRIFT: f64 = 1e-8;

/// Work of the weight above which a warning is given if it is not included, relative to the energy of the impact.
const WEIGHT_FRACTION: f64 = 0.02;

/// State of an impact, from which all results follow.
#[derive(Clone, Debug)]
pub(super) struct ImpactRun<'a> {
    pub(super) scene: &'a Arc<Scene>,
    pub(super) setup: &'a ImpactParameters,
    pub(super) mode: HybridMode,
    pub(super) state: State,
    pub(super) record: Recorder,
    /// Final outcome and the time at which it became final, s.
    pub(super) outcome: Option<(Outcome, f64)>,
    /// Final outcome and maximum displacement; infinite if nothing stops the plate, `None` if not final.
    pub(super) decided: Option<(Outcome, f64)>,
    /// Upper bound of the further depth of the hole after the outcome is decided, m; else 0.
    pub(super) deepens_m: f64,
    /// Horizon, s; infinite without one.
    pub(super) horizon_s: f64,
}

impl ImpactRun<'_> {
    pub(super) fn equations(&self) -> Equations<'_> {
        Equations { setup: self.setup, mode: &self.mode }
    }

    /// Returns `true` if the scene has no horizon.
    pub(super) fn has_no_horizon(&self) -> bool {
        self.scene.run.horizon_s.is_none()
    }

    /// Sets outcome and maximum displacement if they are final.
    pub(super) fn decide(&mut self) {
        if self.decided.is_some() {
            return;
        }
        let now = || Some((self.equations().outcome(&self.state)?, self.state.t_s));
        self.outcome = self.outcome.or_else(now);
        let known = self.outcome.map(|(outcome, _)| (outcome, 0.0));
        let Some((outcome, deepens_m)) = known.or_else(|| self.arrested_within()) else { return };
        let far_m = self.equations().farthest_m(&self.state, self.record.farthest_m);
        let Some(far_m) = far_m else { return };
        self.decided = Some((outcome, far_m));
        self.deepens_m = deepens_m;
    }

    /// Returns the arrest of a projectile that slips back and forth in its hole, with the bound of its further depth, m; `None` unless the
    /// bound is below the tolerance, or after many contact changes.
    fn arrested_within(&self) -> Option<(Outcome, f64)> {
        let deepens_m =
            self.equations().deepens_at_most_m(&self.state).filter(|_| self.has_no_horizon())?;
        let is_little = deepens_m < self.scene.run.tolerance * self.mode.deepest_m;
        let is_long = self.record.cost.events >= CHANGES_MANY;
        (is_little || is_long).then_some((Outcome::Arrested, deepens_m))
    }

    /// Returns the end of the time series of the contact, s.
    pub(super) fn tail_s(&self) -> f64 {
        let record = &self.record;
        let contact_s = record.first_arrest.map(|arrest| arrest.t_s);
        let end_s = contact_s.or_else(|| record.exit.map(|exit| exit.t_s));
        CONTACT_WINDOW * end_s.unwrap_or(self.state.t_s)
    }

    /// Returns `true` while the time series is incomplete: end of the contact, motion to the maximum displacement.
    pub(super) fn is_drawn(&self) -> bool {
        let equations = self.equations();
        // Further motion of a plate at rest is rounding error.
        let is_at_rest = equations.plate_rests() || equations.is_at_rest(&self.state);
        if is_at_rest && self.mode.contact == Contact::Fused {
            return false;
        }
        let in_tail = self.state.t_s < self.tail_s() * (1.0 - 4.0 * f64::EPSILON);
        let is_slow = self.state.w_m_s <= ARRIVED_SPEED * self.record.loads.fastest_m_s;
        in_tail || self.is_before_max_displacement() && (equations.is_undamped() || !is_slow)
    }

    fn flows(&self) -> bool {
        self.setup.law == ContactLaw::Flow
    }

    /// Returns the travel at the bottom of the hole, m.
    fn deepest_m(&self) -> f64 {
        match self.mode.contact {
            Contact::Penetrating => larger(self.state.q_m, self.mode.deepest_m),
            _ => self.mode.deepest_m,
        }
    }

    /// Returns an upper bound of the depth, m, from the remaining energy; `None` if it perforates, or if a spring can release more energy
    /// than it has stored.
    fn depth_at_most_m(&self) -> Option<f64> {
        let geometry = &self.setup.geometry;
        self.setup.spring.power().filter(|_| self.flows() && self.setup.weight_n == 0.0)?;
        let energy_j = self.equations().energy_left_j(&self.state);
        let swept_m3 = geometry.swept_m3(self.deepest_m()) + energy_j / self.setup.strength_pa;
        let travel_m = geometry.travel_at_volume_m(swept_m3)?;
        Some(geometry.depth_m(larger(travel_m, self.deepest_m())))
    }

    /// Returns an upper bound of the final depth of an arrested projectile that still slips, m; `None` if it is at rest.
    fn within_m(&self) -> Option<f64> {
        let most_m = self.setup.geometry.depth_m(self.mode.deepest_m + self.deepens_m);
        (self.deepens_m > 0.0).then_some(most_m)
    }

    /// Returns the final depth, m, from the present depth and its upper bound; `None` if it is not final.
    fn final_m(
        &self,
        outcome: Outcome,
        hole_m: Option<f64>,
        at_most_m: Option<f64>,
    ) -> Option<f64> {
        let geometry = &self.setup.geometry;
        match outcome {
            Outcome::Arrested | Outcome::Separated => hole_m,
            Outcome::Perforated => Some(geometry.depth_m(geometry.exit_m)),
            // A change below the error of the run is negligible.
            Outcome::Moving | Outcome::Unmeasured => {
                let (now_m, most_m) = (hole_m?, at_most_m?);
                (most_m - now_m <= self.scene.run.tolerance * now_m).then_some(now_m)
            }
        }
    }

    /// Returns the depth on a rigid mount, m; `None` for a perforation, or a contact model without depth.
    fn baseline_m(&self) -> Option<f64> {
        let geometry = &self.setup.geometry;
        if !self.flows() {
            return self.setup.law.on_rigid_mount_m().map(|q_m| geometry.depth_m(q_m));
        }
        // The geometry after the plug is picked up differs from that at first contact.
        let of_scene;
        let geometry = if self.setup.shears() {
            of_scene = Geometry::from_scene(self.scene);
            &of_scene
        } else {
            geometry
        };
        Passage::rigid(self.scene, geometry).arrest_m().map(|q_m| geometry.depth_m(q_m))
    }

    fn ledger(&self) -> EnergyLedger {
        let kinetic = |mass: f64, speed: f64| 0.5 * mass * speed * speed;
        let (setup, state) = (self.setup, &self.state);
        let added_kg = Inertia::from_scene(self.scene).added_kg;
        let x_m = self.equations().displacement_m(state.x_m);
        let stored_j = self.mode.spring.energy(x_m);
        // An absorber releases less energy than was spent on crushing it.
        let crushed = setup.crushed_at(x_m, self.mode.crushed_m);
        let spring_j = crushed.map_or(stored_j, |(spring, _)| spring.energy(x_m));
        let [initial_kinetic_j, initial_plate_j] = setup.start.kinetic_j;
        EnergyLedger {
            initial_kinetic_j,
            initial_plate_j,
            initial_spring_j: setup.spring.energy(setup.start.x_m),
            projectile_j: kinetic(setup.mass.projectile_kg, setup.projectile_m_s(state)),
            plate_j: kinetic(setup.mass.plate_kg - added_kg, state.w_m_s),
            inertia_j: kinetic(added_kg, state.w_m_s),
            spring_j,
            crush_j: self.mode.crushed_j + stored_j - spring_j,
            ..self.record.work
        }
    }

    fn load(&self, max_displacement_m: Option<f64>) -> MechanismLoad {
        let spring = &self.setup.spring;
        let inertia = Inertia::from_scene(self.scene);
        let ends = max_displacement_m
            .filter(|_| !self.setup.is_rigid_mount)
            .map(|far_m| [self.record.loads.backmost_m, far_m]);
        let stress_at = |x_m: f64| load::stress_ratio(self.scene, x_m);
        let stress = ends.and_then(|[from, to]| Some(larger(stress_at(from)?, stress_at(to)?)));
        let positive = |value: f64| Some(value).filter(|value| *value > 0.0);
        let speed = self.record.loads.fastest_m_s;
        MechanismLoad {
            stored_j: ends.filter(|_| !spring.is_absent()).map(|[from, to]| {
                // An absorber does not store the energy of crushing.
                let crushed = self.setup.crushed_at(to, 0.0);
                let stored_j = || spring.greatest_energy(from, to);
                crushed.map_or_else(stored_j, |(crushed, _)| {
                    larger(spring.energy(from), crushed.energy(to))
                })
            }),
            yield_margin: stress.and_then(positive).map(|ratio| 1.0 / ratio),
            added_kg: positive(inertia.added_kg),
            spring_mass_kg: inertia.spring_mass_kg,
            turn: self.turn(),
            backmost_m: ends.map(|[back_m, _]| back_m),
            peak_mount_n: (!self.setup.is_rigid_mount && !self.is_driven_away())
                .then_some(self.record.loads.mount_n),
            rotation_j: positive(inertia.rotation_kg).map(|mass| 0.5 * mass * speed * speed),
        }
    }

    /// Returns the oscillation that the method damped, at the first arrest and at the maximum displacement.
    fn left_out(&self, max_displacement_m: Option<f64>) -> LeftOut {
        let Recorder { left_out: [until_arrest, at_farthest], first_arrest, oscillation, .. } =
            &self.record;
        let equations = self.equations();
        let farthest_m = max_displacement_m.unwrap_or(self.record.farthest_m);
        let is_later = farthest_m > self.record.farthest_m;
        let at_farthest = if is_later { oscillation.left_out } else { *at_farthest };
        let at_arrest = first_arrest.map_or([0.0; 2], |arrest| {
            equations.amplitudes(*until_arrest, arrest.plate_displacement_m)
        });
        // The strength takes the velocity of the plate's oscillation.
        let strength_n = first_arrest.map_or(0.0, |arrest| {
            let q_m = self.setup.geometry.travel_m(arrest.penetration_m);
            equations.strength_n(&State { q_m, ..self.state })
        });
        let arrest_s = self.setup.mass.projectile_kg * at_arrest[1] / strength_n;
        let [farthest, _] = equations.amplitudes(at_farthest, farthest_m);
        let by_m = |of: f64| if farthest > 0.0 { farthest * of.abs() } else { 0.0 };
        LeftOut {
            arrest_m: at_arrest[0],
            arrest_m_s: at_arrest[1],
            arrest_s: if self.flows() && strength_n > 0.0 { arrest_s } else { 0.0 },
            farthest_m: farthest,
            force_n: by_m(self.mode.spring.tangent(farthest_m)),
            energy_j: by_m(self.mode.spring.force(farthest_m)),
            demand_ratio: self.omitted_demand(),
            separation_s: self.unresolved_separation_s(),
        }
    }

    /// Returns how long before the separation the force of the contact was within its error, s.
    fn unresolved_separation_s(&self) -> f64 {
        let from_s = self.record.contact_end.unresolved_from_s;
        self.record.separation.zip(from_s).map_or(0.0, |(at, from_s)| larger(at.t_s - from_s, 0.0))
    }

    /// Returns how much more a plastic interface can carry than was found, relative to its strength, where the plate was locked in a slip:
    /// its oscillation decides the load after the slip.
    fn omitted_demand(&self) -> f64 {
        let known = self.record.loads.ratios.filter(|_| self.record.oscillation.is_lost_in_slip);
        let limit_n = self.equations().limit_loads_n(&self.state).0;
        let strength_n = self.equations().strength_n(&self.state);
        known.map_or(0.0, |[push, _]| larger(limit_n / strength_n - push, 0.0))
    }

    /// Returns the largest displacement of the plate, m; infinite for a plate that moves away without end.
    fn largest_displacement_m(&self, run: &Run) -> f64 {
        match self.decided.filter(|_| self.has_no_horizon()) {
            Some((_, far_m)) if far_m.is_infinite() => far_m,
            Some(_) if self.equations().is_gone_backwards(&self.state) => f64::NEG_INFINITY,
            _ => run.max_plate_displacement_m.unwrap_or(self.record.farthest_m),
        }
    }

    fn warnings(&self, run: &Run) -> Vec<RunWarning> {
        let (setup, scene, loads) = (self.setup, self.scene, &self.record.loads);
        let (reason, t_s) = (run.end, self.state.t_s);
        let ended = scene.run.horizon_s.map_or(RunWarning::EndedEarly(reason), |horizon_s| {
            RunWarning::HorizonNotReached { reason, t_s, horizon_s }
        });
        let [pushed_s, pulled_s] = loads.exceeded_s;
        let push = pushed_s.zip(loads.ratios);
        let pull = run.interface.tension_ratio.filter(|ratio| *ratio > 1.0);
        let resumed_s = self.record.resumed_s.filter(|_| setup.interface.is_plastic);
        let has_grip = scene.interface.grip > 0.0;
        let residual = run.ledger.residual();
        let drifts = residual.abs() >= DRIFT || residual.is_nan();
        let happened = [
            (!reason.is_complete()).then_some(ended),
            push.map(|(t_s, [ratio, _])| RunWarning::InterfacePush { ratio, t_s }),
            pull.and_then(|ratio| match (pulled_s, pushed_s) {
                (Some(t_s), _) => Some(RunWarning::InterfacePull { ratio, t_s, has_grip }),
                (None, None) => Some(RunWarning::InterfaceRebound { ratio, has_grip }),
                (None, Some(_)) => None,
            }),
            (loads.no_strength && !setup.interface.is_plastic)
                .then_some(RunWarning::InterfaceWithoutStrength),
            resumed_s.map(|t_s| run.resumed(t_s)),
            drifts.then_some(RunWarning::EnergyDrift { residual }),
        ];
        let ends_m = [self.largest_displacement_m(run), loads.backmost_m];
        let limits = load::exceeded(scene, ends_m).into_iter().map(RunWarning::Limit);
        let limits = limits.filter(|_| !setup.is_rigid_mount);
        // Effects that the contact model does not include.
        let depth_m = run.penetration.final_m.filter(|_| !self.flows());
        let is_through = depth_m.is_some_and(|depth_m| depth_m > setup.geometry.thickness_m);
        let is_plastic = !self.flows() && scene.interface.law == InterfaceLaw::Plastic;
        let Run { outcome, at_least, first_arrest, penetration, .. } = *run;
        let Target { tensile_pa, yield_pa, .. } = scene.target;
        let no_hardening = RunWarning::NoHardening { tensile_pa, yield_pa };
        let is_moving = outcome == Outcome::Moving || at_least != AtLeast::default();
        let by_weight = run.weight_fraction().filter(|fraction| *fraction > WEIGHT_FRACTION);
        let omitted_weight = by_weight.filter(|_| !scene.projectile.weight);
        let notes = [
            is_through.then_some(RunWarning::NotModelled(NotModelled::RearFace)),
            is_plastic.then_some(RunWarning::NotModelled(NotModelled::PlasticLaw)),
            scene.lacks_hardening().then_some(no_hardening).filter(|_| self.flows()),
            (setup.shears() && outcome != Outcome::Perforated).then_some(RunWarning::PlugStopped),
            setup.law.overruns(first_arrest.map(|arrest| arrest.t_s)),
            omitted_weight.map(|fraction| RunWarning::WeightOmitted { fraction }),
            // No warning for a stack, where the projectile hits the next plate, or for a model without depth.
            (penetration.baseline_m.is_none() && self.flows() && !scene.is_stack())
                .then_some(RunWarning::NoBaseline),
            is_moving.then_some(RunWarning::StillMoving { outcome, at_least }),
        ];
        happened.into_iter().flatten().chain(limits).chain(notes.into_iter().flatten()).collect()
    }

    /// Returns the maximum tension of a fused interface, relative to its limit load; infinite without one, `None` for an interface that can
    /// separate.
    fn tension(&self) -> Option<f64> {
        let loads = &self.record.loads;
        let [_, pull] = loads.ratios.filter(|_| !self.setup.interface.is_plastic)?;
        Some(if pull > 0.0 { pull / self.setup.interface.grip } else { 0.0 })
    }

    fn omitted(&self) -> Vec<&'static str> {
        let (setup, record) = (self.setup, &self.record);
        let spring = &setup.spring;
        let whole = |law: PowerLaw| !law.is_absent() && matches!(law.exponent, 1.0 | 2.0 | 3.0);
        let rows = [
            (setup.is_rigid_mount, "plate motion"),
            (spring.is_absent(), "spring"),
            (setup.damper.is_absent(), "damper"),
            (!setup.has_stop(), "stop"),
            (spring.power().is_some_and(whole), "spring power function"),
            (whole(setup.damper), "damper power function"),
            (setup.geometry.nose.sin == 0.0, "obliquity"),
            (!self.flows() || self.deepest_m() <= setup.geometry.bend_m, "exit face"),
            (record.was_held, "plate motion within the contact (bounded below rounding)"),
            (!setup.interface.is_plastic, "interface law"),
            (setup.drag_kg_m3 == 0.0, "drag"),
            (
                self.is_before_max_displacement(),
                "way to the greatest displacement (energy balance)",
            ),
            (!record.keep_series, "series"),
        ];
        rows.into_iter().filter(|(omitted, _)| *omitted).map(|(_, what)| what).collect()
    }
}

/// Builds the results of a run with the reason for its end.
pub(super) fn gather(mut course: ImpactRun<'_>, end: EndReason) -> Run {
    let geometry = &course.setup.geometry;
    let known = course.decided.or(course.outcome).map(|(outcome, _)| outcome);
    let outcome = known.or_else(|| course.equations().outcome(&course.state));
    let outcome = outcome.unwrap_or(Outcome::Moving);
    let hole_m = course.setup.law.hole_m(course.deepest_m());
    let hole_m = hole_m.map(|travel_m| geometry.depth_m(travel_m));
    let at_most_m =
        if outcome == Outcome::Moving { course.depth_at_most_m() } else { course.within_m() };
    let final_m = course.final_m(outcome, hole_m, at_most_m);
    let moved = course.record.series.iter().map(|row| row.plate_displacement_m);
    let max_plate_displacement_m = course.max_displacement_m().map(|peak_m| raised(peak_m, moved));
    if course.setup.mass.turning_kg == 0.0 {
        let forces = course.record.series.iter().map(|row| row.mount_force_n().abs());
        course.record.loads.mount_n = raised(course.record.loads.mount_n, forces);
    }
    let is_bounded = course.decided.is_none_or(|(_, far_m)| far_m.is_finite());
    // On a rigid mount both depths are identical.
    let is_own = course.setup.is_rigid_mount && !course.flows();
    let baseline_m = final_m.filter(|_| is_own).or_else(|| course.baseline_m());
    let series = std::mem::take(&mut course.record.series);
    let mut events = std::mem::take(&mut course.record.events);
    if course.is_driven_away() {
        course.record.loads.ratios = None;
    }
    course.mark_turn(&mut events);
    // Bodies that count as joined and part later do so at a negligible velocity.
    events.retain(|event| event.kind != EventKind::Separation || outcome == Outcome::Separated);
    let record = &course.record;
    let separation = record.separation.filter(|_| outcome == Outcome::Separated);
    let parting = record.exit.or(separation);
    let mut run = Run {
        scene: Arc::clone(course.scene),
        outcome,
        end,
        first_arrest: record.first_arrest,
        penetration: Penetration { final_m, baseline_m, at_most_m },
        peak_contact_force_n: hole_m.map(|_| record.peak_contact_n),
        max_plate_displacement_m,
        at_least: AtLeast {
            penetration_m: hole_m.filter(|_| final_m.is_none()),
            plate_displacement_m: (max_plate_displacement_m.is_none() && is_bounded)
                .then_some(record.farthest_m),
        },
        departure: Departure {
            exit_time_s: record.exit.map(|exit| exit.t_s),
            residual_velocity_m_s: record.exit.map(|exit| exit.velocity_m_s),
            separation,
            plate_velocity_m_s: parting.map(|parting| parting.plate_velocity_m_s),
        },
        interface: InterfaceLoad {
            demand_ratio: record.loads.ratios.map(|[push, _]| push),
            tension_ratio: course.tension(),
        },
        series,
        events,
        ledger: course.ledger(),
        mechanism: course.load(max_plate_displacement_m),
        estimate: ErrorEstimate {
            left_out: course.left_out(max_plate_displacement_m),
            ..ErrorEstimate::default()
        },
        cost: Cost {
            method: "Radau IIA 17",
            reason: "one implicit method of high order: smooth, stiff and steep alike",
            ..record.cost
        },
        omitted: course.omitted(),
        ..Run::default()
    };
    run.warnings = course.warnings(&run);
    run
}

/// Returns a peak, or a row above it. Rows after the decision exceed a peak that follows from the energy only by the errors of their steps.
fn raised(peak: f64, rows: impl Iterator<Item = f64>) -> f64 {
    let most = rows.fold(f64::NEG_INFINITY, |most, row| if row > most { row } else { most });
    if most > peak + RESOLUTION * peak.abs() { most } else { peak }
}

/// Returns the row of a state.
pub(super) fn sample(equations: &Equations<'_>, state: &State) -> Sample {
    let Equations { setup, mode } = equations;
    let contact_n = match mode.contact {
        Contact::Fused => equations.interface_force_n(state),
        _ => equations.contact_n(state),
    };
    let (x_m, w_m_s) = match mode.hold {
        PlateConstraint::Spring => equations.quasi_static_state(state),
        _ => (equations.shown_displacement_m(state.x_m), state.w_m_s),
    };
    let spring_n = mode.spring.force(x_m);
    Sample {
        t_s: state.t_s,
        mode: mode.contact,
        penetration_m: match setup.law {
            ContactLaw::AtOnce => f64::NAN,
            _ => setup.geometry.depth_m(state.q_m),
        },
        projectile_displacement_m: state.q_m + (x_m - setup.start.x_m) * setup.cos,
        projectile_velocity_m_s: setup.projectile_m_s(state),
        plate_displacement_m: x_m,
        plate_velocity_m_s: w_m_s,
        contact_force_n: contact_n,
        spring_force_n: spring_n,
        damper_force_n: equations.damper_n(w_m_s),
        stop_force_n: match mode.hold {
            PlateConstraint::OnStop => contact_n * setup.cos - spring_n,
            _ if mode.is_pressed => equations.stop_n(state.x_m, w_m_s),
            _ => 0.0,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::tests::{is_near, look};
    use crate::model::simulate::bare_run;
    use crate::model::variables::scene_with;

    /// A hole of 1.5 pi (R p² - p³/3) in `S_y` is 4 mm deep, and two bodies of 29.5 g and their spring have 42.825 J left.
    #[test]
    fn valid_an_undecided_run_gives_bounds() {
        let scene = &Arc::new(scene_with("gamma=1 k=1e5 g=0.125"));
        let state = [6e-3, 30.0, 1e-3, 20.0];
        let run = look("gamma=1 k=1e5 g=0.125", Contact::Penetrating, state, |it, &state| {
            let mut record = Recorder { farthest_m: 2e-3, ..Recorder::default() };
            record.loads.ratios = Some([0.5, 0.25]);
            let (setup, mode) = (it.setup, it.mode.clone());
            let course = ImpactRun {
                scene,
                setup,
                mode,
                state,
                record,
                outcome: None,
                decided: None,
                deepens_m: 0.0,
                horizon_s: 1.0,
            };
            gather(course, EndReason::StepBudget)
        });
        let energy_j = |p: f64| 1.5 * std::f64::consts::PI * (0.00635 - p / 3.0) * p * p * 1.52e8;
        let more_j = energy_j(run.penetration.at_most_m.unwrap()) - energy_j(4e-3);
        assert!(is_near(more_j, 42.825, 1e-12), "{more_j}");
        assert!(is_near(run.at_least.penetration_m.unwrap(), 4e-3, 1e-14));
        assert_eq!(run.at_least.plate_displacement_m, Some(2e-3));
        assert!(
            run.warnings.contains(&RunWarning::InterfaceRebound { ratio: 2.0, has_grip: true })
        );
    }

    /// A penetration that resumes for less than the tolerance is not called deeper.
    #[test]
    fn a_resumed_penetration_says_whether_it_is_deeper() {
        for (pairs, expected) in [
            ("gamma=2.014 v_i=232.3 k=1.806e4 n=2 d=0.009394 interface=plastic g=0", false),
            ("gamma=7 v_i=50 k=1e6 n=0.3 d=50mm interface=plastic", true),
        ] {
            let run = bare_run(&scene_with(pairs));
            let deeper = run.warnings.iter().find_map(|warning| match warning {
                RunWarning::PenetrationResumed { is_deeper, .. } => Some(*is_deeper),
                _ => None,
            });
            let depth_m = run.penetration.final_m.unwrap();
            let first_m = run.first_arrest.unwrap().penetration_m;
            assert_eq!(deeper, Some(expected), "{pairs}: {first_m} {depth_m}");
            assert_eq!(depth_m > first_m * (1.0 + 1e-6), expected, "{pairs}: {first_m} {depth_m}");
        }
    }
}
