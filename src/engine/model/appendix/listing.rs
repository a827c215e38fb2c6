//! Run of the listing of Appendix A: the contact, step by step, and the plate motion of its `simulator` afterwards.
//!
//! As printed, the motion after the contact starts from the plate's state before the last step. It uses the same step size to the plate's
//! first turning point, or to a requested horizon. The energy ledger sums the work of the scheme's forces over its steps, so the energy
//! residual is the error of the scheme.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::appendix::{Plate, Scheme, State};
use crate::model::estimate;
use crate::model::run::{
    Arrest, AtLeast, ContactMode, EndReason, EstimateBasis, Event, EventKind, NotModelled,
    Observer, Outcome, Run, RunSnapshot, RunWarning, Sample, Settings,
};
use crate::model::scene::{InterfaceLaw, Listing, Mount, Scene};
use crate::numerics::{larger, smaller};

/// Maximum number of steps of the contact, and of the motion afterwards.
const STEPS_MAX: usize = 2_000_000;
/// Approximate maximum number of stored points of the contact, and of the motion afterwards.
const POINTS: usize = 4_000;
/// Steps between calls of the observer.
const LOOK: usize = 64;
/// Duration of the motion after the contact over that of the contact, if nothing stops the plate.
const TAIL: f64 = 0.25;

/// Velocity over impact velocity below which a plate without a spring has arrested.
const FADED: f64 = 1e-6;

struct Work {
    scheme: Scheme,
    state: State,
    run: Run,
    keep: bool,
    t_s: f64,
    deepest_m: f64,
    max_displacement_m: f64,
    peak_n: f64,
    peak_mount_n: f64,
    backmost_m: f64,
    before: Option<Sample>,
}

/// Simulates a valid scene by the listing.
pub(in crate::model) fn run(scene: &Arc<Scene>, settings: Settings, observer: Observer<'_>) -> Run {
    let listing = scene.contact.appendix;
    let mut run = compute(scene, listing, settings.series, observer);
    if settings.estimate && run.end.is_complete() {
        let half = Listing { step_s: 0.5 * listing.step_s, ..listing };
        let second = compute(scene, half, false, observer);
        estimate::set(&mut run, &second, EstimateBasis::HalfStep);
    }
    run.penetration.baseline_m = if scene.is_sprung() {
        let mut rigid = Scene::clone(scene);
        rigid.plate.mount = Mount::Rigid;
        compute(&Arc::new(rigid), listing, false, observer).penetration.final_m
    } else {
        run.penetration.final_m
    };
    run
}

/// Runs the listing on a scene, without error estimate and without the rigid-mount run.
pub(in crate::model) fn compute(
    scene: &Arc<Scene>,
    listing: Listing,
    keep: bool,
    observer: Observer<'_>,
) -> Run {
    let scheme = Scheme::from_scene(scene, listing);
    let state = scheme.start;
    let mut run = Run { scene: Arc::clone(scene), ..Run::default() };
    (run.cost.method, run.cost.reason) = ("Appendix A", "fixed step, force held over it");
    let (m, v, [x, w]) = (scene.projectile.mass_kg, state.velocity_m_s, state.plate);
    run.ledger.initial_kinetic_j = 0.5 * m * v * v;
    run.ledger.initial_plate_j = 0.5 * scene.plate_mass_kg() * w * w;
    run.ledger.initial_spring_j = scheme.plate.spring.integral(x);
    let mut work = Work {
        scheme,
        state,
        run,
        keep,
        t_s: 0.0,
        deepest_m: 0.0,
        // The listing prepends a zero to the plate's positions, so the maximum of a cocked plate that stays behind neutral is zero.
        max_displacement_m: 0.0,
        peak_n: 0.0,
        peak_mount_n: 0.0,
        backmost_m: 0.0,
        before: None,
    };
    work.note(ContactMode::Penetrating, 0, true);
    work.run.end = work.contact(observer);
    work.finish()
}

impl Work {
    fn look(&self) -> RunSnapshot<'static> {
        RunSnapshot { t_s: self.t_s, so_far: &|| None }
    }

    fn sample(&self, mode: ContactMode) -> Sample {
        let state = &self.state;
        let (spring, damper) = self.scheme.plate.forces_n(state.plate);
        Sample {
            t_s: self.t_s,
            mode,
            penetration_m: state.depth_m,
            projectile_displacement_m: state.pen_m,
            projectile_velocity_m_s: state.velocity_m_s,
            plate_displacement_m: state.plate[0],
            plate_velocity_m_s: state.plate[1],
            contact_force_n: if mode == ContactMode::Penetrating { state.force_n } else { 0.0 },
            spring_force_n: spring,
            damper_force_n: damper,
            ..Sample::default()
        }
    }

    /// Records a step: its work by the trapezoidal rule, extremes, and a point of the series (thinned for many steps).
    fn note(&mut self, mode: ContactMode, step: usize, is_event: bool) {
        let sample = self.sample(mode);
        if let Some(before) = self.before {
            let mean = |f: fn(&Sample) -> f64| 0.5 * (f(&before) + f(&sample));
            let relative = (sample.projectile_displacement_m - before.projectile_displacement_m)
                - (sample.plate_displacement_m - before.plate_displacement_m);
            let plate = sample.plate_displacement_m - before.plate_displacement_m;
            let ledger = &mut self.run.ledger;
            if sample.mode == ContactMode::Penetrating {
                ledger.penetration_j += mean(|sample| sample.contact_force_n) * relative;
            }
            ledger.damper_j += mean(|sample| sample.damper_force_n) * plate;
        }
        self.before = Some(sample);
        self.deepest_m = larger(sample.penetration_m, self.deepest_m);
        let x_m = sample.plate_displacement_m;
        self.max_displacement_m = larger(x_m, self.max_displacement_m);
        self.backmost_m = smaller(x_m, self.backmost_m);
        self.peak_n = larger(sample.contact_force_n, self.peak_n);
        self.peak_mount_n = larger(sample.mount_force_n().abs(), self.peak_mount_n);
        if self.keep && (is_event || step.is_multiple_of(step / POINTS + 1)) {
            self.run.series.push(sample);
        }
    }

    /// Computes the contact to its end by the listing's own rule, and the motion afterwards.
    fn contact(&mut self, observer: Observer<'_>) -> EndReason {
        for step in 1..=STEPS_MAX {
            if step.is_multiple_of(LOOK) && observer(&self.look()) == ControlFlow::Break(()) {
                return EndReason::Cancelled;
            }
            let before = self.state;
            let stepped = self.scheme.step(&mut self.state);
            self.run.cost.steps += 1;
            self.run.cost.rhs_evaluations += 5;
            if let Err(reason) = stepped {
                self.state = before;
                return reason;
            }
            self.t_s = step as f64 * self.scheme.listing.step_s;
            let ending = self.scheme.ended(&self.state);
            if ending.is_some() && self.scheme.listing.corrects_stopping {
                self.locate(&before, step);
            }
            self.note(ContactMode::Penetrating, step, ending.is_some());
            if let Some(ending) = ending {
                self.note_ending(ending);
                return self.afterwards(observer);
            }
        }
        EndReason::StepBudget
    }

    /// Moves the state to the time within the last step at which the relative velocity or the area vanished.
    fn locate(&mut self, before: &State, step: usize) {
        let after = self.state;
        let fraction = if after.area_m2 > 0.0 {
            before.slip_m_s / (before.slip_m_s - after.slip_m_s)
        } else {
            let geometry = &self.scheme.geometry;
            let exit_m = geometry.depth_m(geometry.exit_m);
            (exit_m - before.depth_m) / (after.depth_m - before.depth_m)
        };
        let fraction = fraction.clamp(0.0, 1.0);
        let between = |a: f64, b: f64| a + fraction * (b - a);
        let plate = [0, 1].map(|i| between(before.plate[i], after.plate[i]));
        self.t_s = ((step - 1) as f64 + fraction) * self.scheme.listing.step_s;
        self.state = State {
            pen_m: between(before.pen_m, after.pen_m),
            velocity_m_s: between(before.velocity_m_s, after.velocity_m_s),
            plate,
            // The motion afterwards starts from the located state.
            plate_before: plate,
            depth_m: between(before.depth_m, after.depth_m),
            force_n: between(before.force_n, after.force_n),
            ..after
        };
    }

    fn note_ending(&mut self, ending: Outcome) {
        self.run.outcome = ending;
        // The listing stores the projectile's state after a step with the time before the step.
        let Listing { corrects_stopping, step_s, .. } = self.scheme.listing;
        let t_s = self.t_s - if corrects_stopping { 0.0 } else { step_s };
        let kind = if ending == Outcome::Perforated {
            self.run.departure.exit_time_s = Some(t_s);
            self.run.departure.residual_velocity_m_s = Some(self.state.velocity_m_s);
            EventKind::Perforation
        } else {
            self.run.first_arrest = Some(Arrest {
                t_s,
                penetration_m: self.state.depth_m,
                plate_displacement_m: self.state.plate[0],
                plate_velocity_m_s: self.state.plate[1],
            });
            EventKind::FirstArrest
        };
        self.run.events.push(Event { t_s, kind });
    }

    /// Computes the plate on its mechanism, with or without the projectile (A.5).
    fn afterwards(&mut self, observer: Observer<'_>) -> EndReason {
        let Scheme { plate, projectile_kg, listing, .. } = self.scheme;
        let scene = Arc::clone(&self.run.scene);
        if !scene.is_sprung() {
            self.run.max_plate_displacement_m = Some(0.0);
            return EndReason::Decided;
        }
        let parted = self.run.outcome == Outcome::Perforated && listing.corrects_afterwards;
        let projectile_kg = if parted { 0.0 } else { projectile_kg };
        let body = Plate { mass_kg: plate.mass_kg + projectile_kg, ..plate };
        let mode = if parted { ContactMode::Perforated } else { ContactMode::Fused };
        let springless = plate.spring.is_absent();
        let is_free = springless && plate.damper.is_absent();
        let contact_s = self.t_s;
        let horizon_s = scene.run.horizon_s;
        let until_s = horizon_s.or_else(|| is_free.then_some(contact_s * (1.0 + TAIL)));
        let dt_s = listing.step_s;
        let mut y = self.state.plate_before;
        let (flying_m_s, start_m) = (self.state.velocity_m_s, self.state.pen_m - y[0]);
        for step in 1..=STEPS_MAX {
            if until_s.is_some_and(|until_s| self.t_s + 0.5 * dt_s > until_s) {
                let turned = self.run.max_plate_displacement_m.is_some();
                // The listing prints the maximum displacement within the given time.
                self.run.max_plate_displacement_m = horizon_s.map(|_| self.max_displacement_m);
                return if is_free || turned { EndReason::Decided } else { EndReason::Horizon };
            }
            if step.is_multiple_of(LOOK) && observer(&self.look()) == ControlFlow::Break(()) {
                return EndReason::Cancelled;
            }
            let rising = y[1] > 0.0;
            y = body.step(y, 0.0, dt_s);
            self.run.cost.steps += 1;
            self.run.cost.rhs_evaluations += 4;
            if !(y[0].is_finite() && y[1].is_finite()) {
                return EndReason::NonFinite;
            }
            self.t_s = contact_s + step as f64 * dt_s;
            self.state.plate = y;
            if parted {
                self.state.pen_m += flying_m_s * dt_s;
            } else {
                (self.state.velocity_m_s, self.state.pen_m) = (y[1], start_m + y[0]);
            }
            // A damper alone stops the plate only asymptotically.
            let faded = springless && y[1].abs() < FADED * scene.projectile.velocity_m_s;
            let turned = rising && (y[1] <= 0.0 || faded);
            self.note(mode, step, turned);
            if turned && self.run.max_plate_displacement_m.is_none() {
                self.run.max_plate_displacement_m = Some(self.max_displacement_m);
                let kind = EventKind::GreatestDisplacement;
                self.run.events.push(Event { t_s: self.t_s, kind });
                if horizon_s.is_none() {
                    return EndReason::Decided;
                }
            }
        }
        EndReason::StepBudget
    }

    fn finish(mut self) -> Run {
        let scene = &self.run.scene;
        let (m, m_2, is_rigid) =
            (self.scheme.projectile_kg, scene.plate_mass_kg(), !scene.is_sprung());
        let (v, [x, w]) = (self.state.velocity_m_s, self.state.plate);
        let ledger = &mut self.run.ledger;
        ledger.projectile_j = 0.5 * m * v * v;
        ledger.plate_j = 0.5 * m_2 * w * w;
        ledger.spring_j = self.scheme.plate.spring.integral(x);
        let residual = ledger.residual();
        self.run.warnings.push(RunWarning::EnergyDrift { residual });
        self.run.peak_contact_force_n = Some(self.peak_n);
        self.run.mechanism.peak_mount_n = (!is_rigid).then_some(self.peak_mount_n);
        self.run.mechanism.backmost_m = (!is_rigid).then_some(self.backmost_m);
        let is_decided = self.run.outcome != Outcome::Moving;
        self.run.penetration.final_m = is_decided.then_some(self.deepest_m);
        if !self.run.end.is_complete() {
            self.run.warnings.push(RunWarning::EndedEarly(self.run.end));
            let is_known = is_rigid || self.run.max_plate_displacement_m.is_some();
            self.run.at_least = AtLeast {
                penetration_m: (!is_decided).then_some(self.deepest_m),
                plate_displacement_m: (!is_known).then_some(self.max_displacement_m),
            };
        }
        let is_plastic = scene.interface.law == InterfaceLaw::Plastic;
        let is_stopped = !is_rigid && scene.mechanism.stop.position_m.is_some();
        let stays_joined = !is_rigid
            && self.run.outcome == Outcome::Perforated
            && !self.scheme.listing.corrects_afterwards;
        for (lacks, what) in [
            (is_plastic, NotModelled::PlasticLaw),
            (is_stopped, NotModelled::Stop),
            (stays_joined, NotModelled::PartingBehindHole),
        ] {
            self.run.warnings.extend(lacks.then_some(RunWarning::NotModelled(what)));
        }
        self.run
    }
}
