//! The limits each model has by itself, and the numbers of the model page for the listing.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::mechanism::{Inertia, Mechanism};
use crate::model::run::{EndReason, EventKind, ModelNote, Outcome, Run, Warning};
use crate::model::scene::{
    ContactModel, Jumps, Listing, Mount, Reading, Scene, SpringKind, StopKind,
};
use crate::model::simulate::{self, Settings};

use super::Values;

fn run(scene: &Scene) -> Run {
    simulate::simulate(&Arc::new(scene.clone()), &Settings::default(), &mut |_| {
        ControlFlow::Continue(())
    })
    .unwrap()
}

fn of(model: ContactModel, gamma: f64, k: f64) -> Scene {
    let mut scene = Scene::default();
    scene.contact.model = model;
    scene.plate.mass_ratio = gamma;
    scene.mechanism.spring.coefficient = k;
    scene
}

fn close(value: f64, expected: f64, relative: f64) -> bool {
    (value / expected - 1.0).abs() < relative
}

/// The integral of the contact force over time, by the trapezoid of the series' points.
fn impulse(run: &Run, until_s: f64) -> f64 {
    run.series
        .windows(2)
        .take_while(|pair| pair[1].t_s <= until_s * (1.0 + 1e-12))
        .map(|pair| {
            0.5 * (pair[0].contact_force_n + pair[1].contact_force_n) * (pair[1].t_s - pair[0].t_s)
        })
        .sum()
}

#[test]
fn valid_the_half_sine_carries_the_whole_momentum() {
    for (gamma, k) in [(1.0, 0.0), (1.0, 1e5), (3.0, 1e6)] {
        let mut scene = of(ContactModel::HalfSine, gamma, k);
        scene.contact.duration_s = Some(150e-6);
        let run = run(&scene);
        assert!(close(impulse(&run, 150e-6), 0.0295 * 100.0, 1e-3), "{gamma} {k}");
        let amplitude = 0.0295 * 100.0 * std::f64::consts::PI / (2.0 * 150e-6);
        assert!(close(run.peak_contact_force_n.unwrap(), amplitude, 1e-12));
        assert!(run.ledger.residual().abs() < 1e-9, "{}", run.ledger.residual());
    }
}

#[test]
fn valid_the_half_sine_on_a_rigid_mount_travels_half_of_v_t() {
    let mut scene = of(ContactModel::HalfSine, 1.0, 0.0);
    scene.plate.mount = Mount::Rigid;
    scene.contact.duration_s = Some(150e-6);
    let run = run(&scene);
    let travel = 0.5 * 100.0 * 150e-6;
    let depth = travel * 0.0254 / (0.0254 + 2.0 * 0.00635);
    assert!(close(run.final_penetration_m.unwrap(), depth, 1e-9));
    assert!(close(run.first_arrest.unwrap().t_s, 150e-6, 1e-12));
    assert_eq!(run.percent_of_baseline(), Some(100.0));
}

#[test]
fn valid_a_free_plate_under_the_half_sine_is_overrun_at_half_time_when_both_weigh_the_same() {
    let mut scene = of(ContactModel::HalfSine, 1.0, 0.0);
    scene.contact.duration_s = Some(200e-6);
    let run = run(&scene);
    // u = v cos(pi t/t_d): zero at half time, after a travel of v t_d/pi.
    let arrest = run.first_arrest.unwrap();
    assert!(close(arrest.t_s, 100e-6, 1e-8), "{}", arrest.t_s);
    assert!(close(arrest.plate_velocity_m_s, 50.0, 1e-8));
    let travel = 100.0 * 200e-6 / std::f64::consts::PI;
    let depth = travel * 0.0254 / (0.0254 + 2.0 * 0.00635);
    assert!(close(run.final_penetration_m.unwrap(), depth, 1e-8));
    assert!(close(run.series.last().unwrap().plate_velocity_m_s, 50.0, 1e-8));
    assert!(run.max_plate_displacement_m.is_none());
    let overrun = |warning: &Warning| matches!(warning, Warning::Model(ModelNote::Overruns { .. }));
    assert!(run.warnings.iter().any(overrun));
}

#[test]
fn valid_the_initial_velocity_is_the_limit_of_short_histories() {
    for (b, theta) in [(0.0, 0.0), (200.0, 0.0), (0.0, 30.0)] {
        let mut at_once = of(ContactModel::InitialVelocity, 1.5, 1e5);
        at_once.mechanism.damper.coefficient = b;
        at_once.projectile.obliquity_deg = theta;
        let mut sine = at_once.clone();
        sine.contact.model = ContactModel::HalfSine;
        let limit = run(&at_once).max_plate_displacement_m.unwrap();
        let mut last = f64::INFINITY;
        for t_d in [1e-4, 1e-5, 1e-6, 1e-7] {
            sine.contact.duration_s = Some(t_d);
            let error = (run(&sine).max_plate_displacement_m.unwrap() / limit - 1.0).abs();
            assert!(error < 0.3 * last, "{b} {theta} {t_d}: {error}");
            last = error;
        }
        assert!(last < 1e-4, "{last}");
    }
}

#[test]
fn valid_the_initial_velocity_swings_as_far_as_energy_allows_and_invents_nothing() {
    let run = run(&of(ContactModel::InitialVelocity, 1.0, 1e5));
    let w = 50.0;
    let expected = w * (2.0 * 0.0295 / 1e5f64).sqrt();
    assert!(close(run.max_plate_displacement_m.unwrap(), expected, 1e-9));
    assert_eq!((run.outcome, run.end), (Outcome::Arrested, EndReason::Decided));
    assert_eq!((run.final_penetration_m, run.peak_contact_force_n), (None, None));
    assert!(run.first_arrest.is_none() && run.error_estimate.is_none());
    assert!(run.ledger.residual().abs() < 1e-9);
    assert!(close(run.ledger.penetration_j, 0.5 * 147.5, 1e-12));
}

#[test]
fn valid_the_lumped_interface_conserves_momentum_and_dissipates_by_its_hysteresis() {
    let mut scene = of(ContactModel::Lumped, 2.0, 0.0);
    scene.contact.load_stiffness_n_m = Some(2e6);
    scene.contact.unload_stiffness_n_m = Some(8e6);
    let run = run(&scene);
    assert_eq!(run.outcome, Outcome::Separated);
    for sample in &run.series {
        let momentum = 0.0295 * (sample.projectile_velocity_m_s + 2.0 * sample.plate_velocity_m_s);
        assert!(close(momentum, 2.95, 1e-9), "{momentum}");
    }
    // Half of the relative speed comes back: sqrt(k_load/k_unload).
    let last = run.series.last().unwrap();
    let slip = last.projectile_velocity_m_s - last.plate_velocity_m_s;
    assert!(close(slip, -50.0, 1e-7), "{slip}");
    let mu = 0.0295 * 2.0 / 3.0;
    assert!(close(run.ledger.penetration_j, 0.5 * mu * 1e4 * 0.75, 1e-7));
    // delta_max = u sqrt(mu/k_load); a quarter of it springs back.
    let dent = 100.0 * (mu / 2e6f64).sqrt() * 0.75;
    let depth = dent * 0.0254 / (0.0254 + 2.0 * 0.00635);
    assert!(close(run.final_penetration_m.unwrap(), depth, 1e-7));
    assert!(close(run.first_arrest.unwrap().penetration_m, depth / 0.75, 1e-7));
}

#[test]
fn the_lumped_interface_only_pushes_and_its_ledger_closes_on_a_spring_with_a_damper() {
    let mut scene = of(ContactModel::Lumped, 1.0, 1e6);
    scene.mechanism.damper.coefficient = 20.0;
    scene.contact.damping_n_s_m = 30.0;
    let run = run(&scene);
    let strongest = run.peak_contact_force_n.unwrap();
    assert!(run.series.iter().all(|row| row.contact_force_n > -1e-6 * strongest));
    assert!(run.ledger.residual().abs() < 1e-8, "{}", run.ledger.residual());
    assert!(run.events.iter().any(|event| event.kind == EventKind::FirstArrest));
    assert!(run.error_estimate.unwrap().relative < 1e-8);
}

#[test]
fn values_left_open_are_those_of_the_hydrodynamic_contact_on_a_rigid_mount() {
    let scene = Scene::default();
    let values = Values::of(&scene);
    // Rigid, Table 9.1: 7.113055 mm deep, so 10.669583 mm of travel.
    let travel = 7.113_055e-3 * 1.5;
    assert!(close(values.load_stiffness_n_m, 0.0295 * 1e4 / (travel * travel), 1e-6));
    assert!(close(values.unload_stiffness_n_m, 100.0 * values.load_stiffness_n_m, 1e-12));
    let mut rigid = of(ContactModel::Lumped, 1.0, 0.0);
    rigid.plate.mount = Mount::Rigid;
    let run = run(&rigid);
    assert!(close(run.first_arrest.unwrap().penetration_m, 7.113_055e-3, 1e-6));
    assert_eq!(run.outcome, Outcome::Separated);
}

#[test]
fn a_rigid_stop_holds_and_lets_go_under_every_model() {
    for model in [ContactModel::HalfSine, ContactModel::InitialVelocity, ContactModel::Lumped] {
        for (kind, e) in [(StopKind::Rigid, 0.0), (StopKind::Rigid, 0.5), (StopKind::Elastic, 0.0)]
        {
            let mut scene = of(model, 1.0, 1e5);
            scene.mechanism.stop.position_m = Some(0.5e-3);
            scene.mechanism.stop.kind = kind;
            scene.mechanism.stop.restitution = e;
            let run = run(&scene);
            assert!(run.end.is_complete(), "{model:?} {kind:?} {e}: {:?}", run.end);
            assert!(run.ledger.residual().abs() < 1e-8, "{model:?} {kind:?} {e}");
            let reach = run.max_plate_displacement_m.unwrap();
            let most = if kind == StopKind::Rigid { 0.5e-3 * (1.0 + 1e-9) } else { 2.5e-3 };
            assert!(reach <= most, "{model:?} {kind:?} {e}: {reach}");
        }
    }
}

#[test]
fn valid_a_joined_plate_goes_as_far_on_any_spring_as_its_energy_allows() {
    for kind in SpringKind::ALL {
        let mut scene = of(ContactModel::InitialVelocity, 2.0, 1e5);
        scene.mechanism.spring.kind = kind;
        scene.projectile.velocity_m_s = 20.0;
        let spring = Mechanism::of(&scene).spring;
        let joined = 0.0295 + scene.plate_mass_kg() + Inertia::of(&scene).added_kg();
        let energy_j = 0.5 * (0.0295f64 * 20.0).powi(2) / joined;
        if let Some(reach_m) = run(&scene).max_plate_displacement_m {
            assert!(close(spring.energy(reach_m), energy_j, 1e-9), "{kind:?}: {reach_m}");
        } else {
            assert!(spring.forward(0.0, energy_j).is_infinite(), "{kind:?}");
        }
    }
}

#[test]
fn every_model_closes_its_ledger_on_every_spring() {
    for model in [ContactModel::HalfSine, ContactModel::InitialVelocity, ContactModel::Lumped] {
        for kind in SpringKind::ALL {
            let mut scene = of(model, 2.0, 1e5);
            scene.mechanism.spring.kind = kind;
            scene.mechanism.damper.coefficient = 20.0;
            let run = run(&scene);
            assert!(run.end.is_complete(), "{model:?} {kind:?}: {:?}", run.end);
            let residual = run.ledger.residual();
            assert!(residual.abs() < 1e-8, "{model:?} {kind:?}: {residual:e}");
        }
    }
}

fn listing(gamma: f64, k: f64) -> Scene {
    let mut scene = of(ContactModel::Appendix, gamma, k);
    scene.target.flow_strength_pa = 2.0 * 75.8e6;
    scene
}

#[test]
fn valid_the_listing_gives_the_baselines_of_the_model_page() {
    let mut scene = listing(1.0, 0.0);
    scene.plate.mount = Mount::Rigid;
    for (rho, dt, expected_mm) in
        [(2710.0, 1e-6, 7.1547), (2710.0, 1e-7, 7.1288), (2780.0, 2e-7, 7.1289)]
    {
        scene.target.density_kg_m3 = rho;
        scene.contact.appendix.step_s = dt;
        let depth_mm = run(&scene).final_penetration_m.unwrap() * 1e3;
        assert!((depth_mm - expected_mm).abs() < 6e-5, "{rho} {dt}: {depth_mm}");
    }
}

#[test]
fn valid_what_the_printed_coupling_costs() {
    // Of 7.129 mm, rho = 2780, dt = 1e-6: an independent port of the listing.
    let known = [
        (0.8, 78.4, 60.1),
        (1.0, 82.4, 64.4),
        (2.0, 92.2, 76.7),
        (3.0, 95.8, 82.7),
        (5.0, 98.4, 88.6),
        (7.0, 99.2, 91.5),
    ];
    for (gamma, printed, corrected) in known {
        let mut scene = listing(gamma, 1e5);
        scene.target.density_kg_m3 = 2780.0;
        let share = |scene: &Scene| run(scene).final_penetration_m.unwrap() / 7.129e-3 * 100.0;
        assert!((share(&scene) - printed).abs() < 0.06, "{gamma}");
        scene.contact.appendix.coupling = Reading::Corrected;
        assert!((share(&scene) - corrected).abs() < 0.06, "{gamma}");
    }
}

#[test]
fn valid_the_listing_as_printed_is_the_case_of_the_critique() {
    // m_2 = 0.1 kg, rho = 2780, nothing on the plate: 6.8806 mm at 0.151 ms, 19.257 kN, 22.67 against 22.91 m/s.
    let mut scene = listing(0.1 / 0.0295, 0.0);
    scene.target.density_kg_m3 = 2780.0;
    let run = run(&scene);
    assert!((run.final_penetration_m.unwrap() * 1e3 - 6.8806).abs() < 1e-3);
    assert!(close(run.peak_contact_force_n.unwrap(), 19_257.0, 1e-3));
    let arrest = run.first_arrest.unwrap();
    assert!((arrest.t_s - 0.151e-3).abs() < 1.5e-6, "{}", arrest.t_s);
    assert!((arrest.plate_velocity_m_s - 22.91).abs() < 0.01);
    assert!(run.max_plate_displacement_m.is_none());
}

#[test]
fn valid_every_quirk_mended_the_listing_converges_to_the_engine() {
    let mut scene = of(ContactModel::Appendix, 1.0, 1e5);
    scene.contact.appendix = Listing::corrected(1e-7);
    scene.mechanism.damper.coefficient = 100.0;
    let mut sound = scene.clone();
    sound.contact.model = ContactModel::Hydrodynamic;
    let (own, reference) = (run(&scene), run(&sound));
    let depth = reference.final_penetration_m.unwrap();
    assert!(close(own.final_penetration_m.unwrap(), depth, 1e-6));
    let travel = reference.max_plate_displacement_m.unwrap();
    assert!(close(own.max_plate_displacement_m.unwrap(), travel, 1e-5));
    assert!(own.error_estimate.unwrap().relative < 1e-5);
}

#[test]
fn the_unsigned_damper_adds_energy_on_the_way_back_and_a_signed_one_does_not() {
    let mut scene = of(ContactModel::Appendix, 1.0, 1e5);
    scene.mechanism.damper.coefficient = 50.0;
    scene.run.horizon_s = Some(8e-3);
    let after_the_turn = |scene: &Scene| {
        let run = run(scene);
        let turn = run.events.iter().find(|event| event.kind == EventKind::GreatestDisplacement);
        let turn_s = turn.unwrap().t_s;
        let energy = |row: &crate::model::run::Sample| {
            0.5 * 0.059 * row.plate_velocity_m_s.powi(2) + 0.5e5 * row.plate_displacement_m.powi(2)
        };
        let before = run.series.iter().find(|row| row.t_s >= turn_s).map(energy).unwrap();
        let back = run.series.iter().find(|row| row.t_s > turn_s && row.plate_displacement_m < 0.0);
        back.map(energy).unwrap() / before
    };
    assert!(after_the_turn(&scene) > 1.05);
    scene.contact.appendix.damper = Reading::Corrected;
    assert!(after_the_turn(&scene) < 0.95);
}

#[test]
fn a_perforation_leaves_the_bodies_joined_as_printed_and_parts_them_when_corrected() {
    let mut scene = of(ContactModel::Appendix, 1.0, 1e5);
    scene.target.thickness_m = 0.003;
    scene.projectile.velocity_m_s = 300.0;
    let printed = run(&scene);
    assert_eq!(printed.outcome, Outcome::Perforated);
    assert!(printed.warnings.contains(&Warning::Model(ModelNote::JoinedThroughHole)));
    scene.contact.appendix.afterwards = Reading::Corrected;
    let corrected = run(&scene);
    let ratio =
        printed.max_plate_displacement_m.unwrap() / corrected.max_plate_displacement_m.unwrap();
    // The same speed on the same spring with twice the mass goes about sqrt(2) as far.
    assert!((ratio - 2f64.sqrt()).abs() < 0.05, "{ratio}");
    let last = corrected.series.last().unwrap();
    assert!(close(last.projectile_velocity_m_s, corrected.residual_velocity_m_s.unwrap(), 1e-12));
}

#[test]
fn ignored_jumps_end_in_no_number_and_a_stop_is_told_to_be_missing() {
    let mut scene = listing(1.0, 1e5);
    scene.plate.mount = Mount::Rigid;
    scene.contact.appendix.jumps = Jumps::Ignored;
    let run_of_it = run(&scene);
    assert_eq!(run_of_it.end, EndReason::NonFinite);
    assert!(!run_of_it.series.is_empty() && run_of_it.final_penetration_m.is_none());
    let mut stopped = listing(1.0, 1e5);
    stopped.mechanism.stop.position_m = Some(1e-3);
    assert!(run(&stopped).warnings.contains(&Warning::Model(ModelNote::NoStop)));
}

#[test]
fn each_quirk_by_itself_makes_the_difference_it_should() {
    let base = run(&listing(1.0, 1e5));
    let depth = |change: fn(&mut Listing)| {
        let mut scene = listing(1.0, 1e5);
        change(&mut scene.contact.appendix);
        run(&scene).final_penetration_m.unwrap() / base.final_penetration_m.unwrap() - 1.0
    };
    assert!((depth(|it| it.coupling = Reading::Corrected) + 0.22).abs() < 0.01);
    // The printed depth contains the projectile's own travel, 50 m/s when it stops: one step of it at most.
    assert!(depth(|it| it.stopping = Reading::Corrected).abs() < 6e-3);
    assert!((-0.01..0.0).contains(&depth(|it| it.scheme = Reading::Corrected)));
    // No damper, no perforation, no obliquity: nothing to tell apart here.
    assert!(depth(|it| it.damper = Reading::Corrected).abs() < 1e-15);
    assert!(depth(|it| it.afterwards = Reading::Corrected).abs() < 1e-15);
    assert!(depth(|it| it.obliquity = Reading::Corrected).abs() < 1e-15);
}
