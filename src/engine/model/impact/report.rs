//! The [`Run`] from a finished simulation.

use std::sync::Arc;

use crate::model::impact::body::MaximumDisplacement;
use crate::model::impact::problem::{PlateResponse, Problem};
use crate::model::impact::record::Record;
use crate::model::impact::simulation::Simulation;
use crate::model::mechanism::{PowerKind, Spring, load};
use crate::model::run::{
    AtLeast, Cost, EndReason, EnergyLedger, Event, EventKind, MechanismLoad, Mode, NotModelled,
    Outcome, Run, STILL_WITHIN_CONTACT, Warning,
};
use crate::model::scene::InterfaceLaw;
use crate::numerics::larger;

/// Part of the mount's force within which way back and way forward are the same.
const ROUNDING: f64 = 1e-9;

pub(super) fn gather(problem: &Problem, simulation: Simulation<'_>, end: EndReason) -> Run {
    let outcome = simulation
        .termination
        .decided
        .map_or_else(|| simulation.body.outcome(), |decided| decided.0);
    let ledger = ledger(problem, &simulation);
    let geometry = &problem.geometry;
    let hole_m = problem.contact.hole_m(simulation.body.deepest_m);
    let hole_m = hole_m.map(|travel_m| geometry.depth_m(travel_m));
    let final_penetration_m = match outcome {
        Outcome::Arrested | Outcome::Separated => hole_m,
        Outcome::Perforated => Some(geometry.depth_m(geometry.exit_m)),
        Outcome::Moving => None,
    };
    let penetration_at_most_m =
        if outcome == Outcome::Moving { simulation.body.depth_at_most_m() } else { None };
    // A hole that can grow by less than the error of the run has its final depth.
    let negligible = problem.scene.run.tolerance;
    let final_penetration_m = final_penetration_m.or_else(|| {
        let at_most_m = penetration_at_most_m?;
        hole_m.filter(|depth_m| at_most_m - depth_m <= negligible * depth_m)
    });
    let so_far_m = simulation.record.max_displacement_m;
    let max_displacement = max_displacement_m(&simulation);
    let mut warnings =
        warnings(problem, &simulation, end, &ledger, max_displacement.unwrap_or(so_far_m));
    warnings.extend(notes(problem, &simulation, final_penetration_m));
    let at_least = AtLeast {
        penetration_m: hole_m.filter(|_| final_penetration_m.is_none()),
        plate_displacement_m: (max_displacement.is_none()
            && simulation.termination.max_displacement == MaximumDisplacement::Pending)
            .then_some(so_far_m),
    };
    if outcome == Outcome::Moving || !at_least.is_empty() {
        warnings.push(Warning::StillMoving { outcome, at_least });
    }
    let cost = cost(problem, &simulation);
    let mechanism = load(problem, &simulation, max_displacement);
    let omitted = omitted(problem, &simulation);
    let mut record = simulation.record;
    tidy_events(&mut record);
    Run {
        scene: Arc::clone(&problem.scene),
        outcome,
        end,
        first_arrest: record.first_arrest,
        final_penetration_m,
        // On a rigid mount both are the same, to the last digit.
        baseline_penetration_m: final_penetration_m
            .filter(|_| problem.rigid && !problem.flows())
            .or(problem.baseline_m),
        peak_contact_force_n: hole_m.map(|_| record.peak_contact_n),
        max_plate_displacement_m: max_displacement,
        at_least,
        penetration_at_most_m,
        residual_velocity_m_s: record.exit.map(|exit| exit.velocity_m_s),
        exit_time_s: record.exit.map(|exit| exit.t_s),
        separation: record.separation.filter(|_| outcome == Outcome::Separated),
        interface_demand_ratio: record.push_ratio,
        interface_tension_ratio: tension(problem, &record),
        error_estimate: None,
        error_estimates: Vec::new(),
        series: record.series,
        events: record.events,
        ledger,
        mechanism,
        stack: None,
        plastic: None,
        cost,
        omitted,
        warnings,
    }
}

/// The greatest tension that a fused interface carried, over its strength; `None` where it can let go.
fn tension(problem: &Problem, record: &Record<'_>) -> Option<f64> {
    let is_known = record.push_ratio.is_some() && !problem.plastic;
    is_known.then(|| tension_ratio(record.pull_ratio, problem.grip))
}

/// The tension of a fused interface on the way back, after the run, over its strength in tension, where it is too much and nothing
/// has been before.
fn rebound(problem: &Problem, simulation: &Simulation<'_>, farthest_m: f64) -> Option<f64> {
    let (body, record) = (&simulation.body, &simulation.record);
    let is_exceeded = record.push_exceeded_s.or(record.pull_exceeded_s).is_some();
    let is_asked = body.mode == Mode::Fused && !problem.plastic && !is_exceeded;
    let strength_n = Some(body.interface_n()).filter(|strength_n| is_asked && *strength_n > 0.0)?;
    let pull = body.rebound_pull_n(farthest_m)? / strength_n;
    Some(tension_ratio(pull, problem.grip)).filter(|ratio| *ratio > 1.0)
}

/// The greatest tension over the strength in tension, from that over `A S_y`.
fn tension_ratio(pull: f64, grip: f64) -> f64 {
    match (grip > 0.0, pull > 0.0) {
        (true, _) => pull / grip,
        (false, true) => f64::INFINITY,
        (false, false) => 0.0,
    }
}

/// The maximum displacement of the plate, m; `None` while it is unknown or has no bound.
fn max_displacement_m(simulation: &Simulation<'_>) -> Option<f64> {
    let so_far_m = simulation.record.max_displacement_m;
    match simulation.termination.max_displacement {
        MaximumDisplacement::Known(x_m) => Some(larger(x_m, so_far_m)),
        MaximumDisplacement::Pending if simulation.body.displacement_is_greatest(so_far_m) => {
            Some(so_far_m)
        }
        MaximumDisplacement::Unbounded | MaximumDisplacement::Pending => None,
    }
}

fn ledger(problem: &Problem, simulation: &Simulation<'_>) -> EnergyLedger {
    let kinetic = |mass: f64, speed: f64| 0.5 * mass * speed * speed;
    let state = &simulation.body.state;
    let speed = state.projectile_m_s(problem.cos);
    let spring = &problem.mechanism.spring;
    let (spring_j, crush_j) = simulation.spring_energies();
    let added_kg = problem.inertia.added_kg();
    EnergyLedger {
        initial_kinetic_j: kinetic(problem.projectile_kg, problem.velocity_m_s),
        initial_spring_j: spring.energy(problem.start_m),
        projectile_j: kinetic(problem.projectile_kg, speed),
        plate_j: kinetic(problem.plate_kg - added_kg, state.plate_m_s),
        inertia_j: kinetic(added_kg, state.plate_m_s),
        spring_j,
        crush_j,
        ..simulation.record.work
    }
}

fn load(
    problem: &Problem,
    simulation: &Simulation<'_>,
    max_displacement: Option<f64>,
) -> MechanismLoad {
    let (spring, inertia) = (&problem.mechanism.spring, &problem.inertia);
    let speed = simulation.body.speed_scale_m_s;
    let stress_ratio_at = |x: f64| load::stress_ratio(&problem.scene, x);
    let ends = max_displacement.filter(|_| !problem.rigid).map(|far| [problem.start_m, far]);
    let stress =
        ends.and_then(|[from, to]| Some(larger(stress_ratio_at(from)?, stress_ratio_at(to)?)));
    let positive = |value: f64| Some(value).filter(|value| *value > 0.0);
    MechanismLoad {
        stored_j: ends
            .filter(|_| !spring.is_absent())
            .map(|[from, to]| spring.greatest_energy(from, to)),
        yield_margin: stress.and_then(positive).map(|ratio| 1.0 / ratio),
        added_kg: positive(inertia.added_kg()),
        spring_mass_kg: inertia.spring_mass_kg,
        peak_mount_n: if problem.follows_mount_force() {
            Some(simulation.record.peak_mount_n)
        } else {
            swinging_mount_n(problem, simulation, max_displacement)
        },
        rotation_j: positive(inertia.rotation_kg).map(|mass| 0.5 * mass * speed * speed),
    }
}

/// The greatest force of a spring that is a curve and acts alone, N: on the way of the run, and back from there with the energy
/// that is left.
fn swinging_mount_n(
    problem: &Problem,
    simulation: &Simulation<'_>,
    max_displacement: Option<f64>,
) -> Option<f64> {
    let (body, record) = (&simulation.body, &simulation.record);
    let greatest = |spring: &Spring, low_m, high_m| {
        let forces = spring.curve().map(|curve| curve.forces_between(low_m, high_m));
        forces.map(|(least, most)| larger(least.abs(), most.abs()))
    };
    let energy_j = body.energy_j();
    let reached_m = larger(record.max_displacement_m, body.reach_with(energy_j));
    let far_m = max_displacement.unwrap_or(reached_m);
    let on_the_way_n = greatest(&problem.mechanism.spring, record.min_displacement_m, far_m)?;
    // An absorber that is still being crushed gives back less than was spent on it.
    let crushed = body.problem.unloaded_spring(far_m).filter(|_| body.state.plate_m_s > 0.0);
    let back_n = if let Some(spring) = crushed {
        let back_m = -spring.backward(far_m, spring.energy(far_m));
        greatest(&spring, back_m, far_m)?
    } else {
        let spring = &body.problem.mechanism.spring;
        greatest(spring, -spring.backward(body.state.plate_m, energy_j), far_m)?
    };
    let is_more = back_n > on_the_way_n * (1.0 + ROUNDING);
    Some(if is_more { back_n } else { on_the_way_n })
}

fn warnings(
    problem: &Problem,
    simulation: &Simulation<'_>,
    end: EndReason,
    ledger: &EnergyLedger,
    far: f64,
) -> Vec<Warning> {
    let record = &simulation.record;
    let mut list = Vec::new();
    if !end.is_complete() {
        let (t_s, horizon_s) = (simulation.body.state.t_s, problem.horizon_s);
        list.push(if problem.horizon_is_given {
            Warning::HorizonNotReached { reason: end, t_s, horizon_s }
        } else {
            Warning::EndedEarly(end)
        });
    }
    if let (Some(t_s), Some(ratio)) = (record.push_exceeded_s, record.push_ratio) {
        list.push(Warning::InterfacePush { ratio, t_s });
    }
    if let Some(t_s) = record.pull_exceeded_s {
        let ratio = tension_ratio(record.pull_ratio, problem.grip);
        list.push(Warning::InterfacePull { ratio, t_s });
    }
    if let Some(ratio) = rebound(problem, simulation, far) {
        list.push(Warning::InterfaceRebound { ratio });
    }
    if record.no_strength && !problem.plastic {
        list.push(Warning::InterfaceWithoutStrength);
    }
    if let Some(t_s) = record.resumed_s.filter(|_| problem.plastic) {
        list.push(Warning::PenetrationResumed { t_s });
    }
    list.extend(Warning::of_ledger(ledger));
    if !problem.rigid {
        let at = if far.abs() < problem.start_m.abs() { problem.start_m } else { far };
        list.extend(load::exceeded(&problem.scene, at).into_iter().map(Warning::Limit));
    }
    // What goes through the first plate of a stack meets the next.
    let is_alone = !problem.scene.is_stack();
    if problem.flows() && problem.baseline_m.is_none() && is_alone {
        list.push(Warning::NoBaseline);
    }
    list
}

/// The effects that the contact model does not contain.
fn notes(
    problem: &Problem,
    simulation: &Simulation<'_>,
    depth_m: Option<f64>,
) -> impl Iterator<Item = Warning> {
    let scene = &problem.scene;
    let through = depth_m.is_some_and(|depth_m| depth_m > problem.geometry.thickness_m);
    let plastic = scene.interface.law == InterfaceLaw::Plastic;
    let notes = [
        (through && !problem.flows()).then_some(Warning::NotModelled(NotModelled::RearFace)),
        (plastic && !problem.flows()).then_some(Warning::NotModelled(NotModelled::PlasticLaw)),
        problem.contact.note(simulation.record.first_arrest.map(|arrest| arrest.t_s)),
    ];
    notes.into_iter().flatten()
}

fn cost(problem: &Problem, simulation: &Simulation<'_>) -> Cost {
    let closed = problem.plate_response != PlateResponse::Mechanism;
    let (method, reason) = match (closed, simulation.control.steps, simulation.control.stiff_steps)
    {
        (true, 0, _) => ("closed form", "only inertia resists the projectile"),
        (true, _, 0) => ("closed form + Taylor 16", "contact in closed form, the rest integrated"),
        (_, _, 0) => ("Taylor 16", "smooth between events"),
        (_, steps, stiff) if steps == stiff => ("Radau IIA 5", "stiff"),
        (_, _, _) => ("Taylor 16 + Radau IIA 5", "partly stiff"),
    };
    Cost {
        steps: simulation.control.steps,
        rejected: simulation.control.rejected,
        turns: simulation.control.turns,
        events: simulation.control.event_count,
        rhs_evaluations: simulation.control.evaluations,
        took_s: None,
        method,
        reason,
    }
}

fn omitted(problem: &Problem, simulation: &Simulation<'_>) -> Vec<&'static str> {
    let (spring, damper) = (&problem.mechanism.spring, problem.mechanism.damper);
    let whole = |kind: PowerKind| matches!(kind, PowerKind::Linear | PowerKind::Whole(_));
    let rows = [
        (problem.rigid, "plate motion"),
        (spring.is_absent(), "spring"),
        (damper.is_absent(), "damper"),
        (problem.mechanism.stop.is_none(), "stop"),
        (spring.power().is_some_and(|law| whole(law.kind())), "spring power function"),
        (whole(damper.kind()), "damper power function"),
        (problem.geometry.nose.sin == 0.0, "obliquity"),
        (!problem.flows() || simulation.body.deepest_m <= problem.geometry.bend_m, "exit face"),
        (simulation.control.steps == 0, "integration (closed form)"),
        (problem.plate_response == PlateResponse::Fixed, STILL_WITHIN_CONTACT),
        (!problem.plastic, "interface law"),
        (problem.drag_kg_m3 == 0.0, "drag"),
        (simulation.goes_farther(), "way to the greatest displacement (energy balance)"),
        (!simulation.record.keep_series, "series"),
    ];
    rows.into_iter().filter(|(omitted, _)| *omitted).map(|(_, what)| what).collect()
}

/// Of the displacement's maxima on the way only the greatest is reported as an event.
fn tidy_events(record: &mut Record<'_>) {
    let is_maximum = |event: &Event| event.kind == EventKind::GreatestDisplacement;
    let last = record.events.iter().rposition(is_maximum);
    let mut index = 0;
    record.events.retain(|event| {
        let is_greatest = Some(index) == last && event.t_s >= record.max_displacement_s;
        index += 1;
        !is_maximum(event) || is_greatest
    });
}
