//! Quantities of the claims that are read from the series of a run.

use std::f64::consts::PI;

use crate::model::run::{EventKind, Mode, Outcome, Run, Sample};
use crate::numerics::larger;
use crate::study::thesis::value::Value;

fn arrest_s(run: &Run) -> f64 {
    run.first_arrest.map_or(f64::NAN, |arrest| arrest.t_s)
}

/// The force of the contact summed over the time between neighbouring samples, N s.
fn summed<'a>(pairs: impl Iterator<Item = (&'a Sample, &'a Sample)>) -> f64 {
    pairs.map(|(a, b)| 0.5 * (a.contact_force_n + b.contact_force_n) * (b.t_s - a.t_s)).sum()
}

pub(super) fn displacement_at_end_mm(run: &Run) -> Option<f64> {
    let end = run.series.last().filter(|_| run.outcome != Outcome::Perforated);
    end.map(|row| 1e3 * row.plate_displacement_m)
}

pub(super) fn last_force(run: &Run) -> Option<f64> {
    let end_s = run.contact_end_s() * (1.0 - 1e-9);
    run.series.iter().rfind(|row| row.t_s < end_s).map(|row| row.contact_force_n)
}

pub(super) fn momentum(run: &Run) -> Value {
    let end_s = arrest_s(run);
    // The last sample may be that after the arrest, where the force has ended.
    let inside: Vec<&Sample> = run
        .series
        .iter()
        .take_while(|row| row.t_s <= end_s * (1.0 + 1e-12))
        .filter(|row| row.contact_force_n > 0.0 || row.t_s < end_s)
        .collect();
    let lost = inside.first().zip(inside.last()).map(|(first, last)| {
        let mass_kg = run.scene.projectile.mass_kg;
        mass_kg * (first.projectile_velocity_m_s - last.projectile_velocity_m_s)
    });
    let given = summed(inside.windows(2).map(|pair| (pair[0], pair[1])));
    Value::List(vec![lost.into(), given.into()])
}

/// Until the end of a prescribed contact.
pub(super) fn impulse(run: &Run) -> f64 {
    let until_s = run.scene.contact.duration_s.unwrap_or(f64::NAN) * (1.0 + 1e-9);
    let pairs = run.series.windows(2).take_while(|pair| pair[1].t_s <= until_s);
    summed(pairs.map(|pair| (&pair[0], &pair[1])))
}

pub(super) fn acceleration_ratio(run: &Run) -> Option<f64> {
    let pair = run.series.windows(2).find(|pair| pair[0].contact_force_n > 1e3)?;
    let change = pair[1].projectile_velocity_m_s - pair[0].projectile_velocity_m_s;
    let force_n = 0.5 * (pair[0].contact_force_n + pair[1].contact_force_n);
    Some(run.scene.projectile.mass_kg * change / (pair[1].t_s - pair[0].t_s) / force_n)
}

pub(super) fn off_half_sine(run: &Run) -> f64 {
    let end_s = arrest_s(run);
    let peak = run.peak_contact_force_n.unwrap_or(f64::NAN);
    let contact = run.series.iter().filter(|row| row.t_s < end_s * (1.0 - 1e-9));
    let off = contact.map(|row| (row.contact_force_n / peak - (PI * row.t_s / end_s).sin()).abs());
    off.fold(0.0, larger)
}

pub(super) fn velocities_after_contact(run: &Run) -> Value {
    let end_s = arrest_s(run);
    let after = run.series.iter().filter(|row| row.t_s > end_s);
    let velocities: Vec<f64> = after.map(|row| row.plate_velocity_m_s).collect();
    // Of nothing no condition holds.
    Value::numbers(if velocities.is_empty() { vec![f64::NAN] } else { velocities })
}

/// Of the projectile, when the plate passes neutral or at first arrest, whichever comes first.
pub(super) fn velocity_at_neutral(run: &Run) -> Option<f64> {
    let passed = run.series.iter().find(|row| row.plate_displacement_m >= 0.0);
    let arrest_s = run.first_arrest.map_or(f64::INFINITY, |arrest| arrest.t_s);
    let before = run.series.iter().rfind(|row| row.t_s <= arrest_s);
    let at = passed.filter(|row| row.t_s < arrest_s).or(before)?;
    Some(at.projectile_velocity_m_s)
}

pub(super) fn momentum_at_arrest(run: &Run) -> Option<f64> {
    let end_s = arrest_s(run) * (1.0 + 1e-12);
    let row = run.series.iter().rev().find(|row| row.t_s <= end_s)?;
    let (projectile_kg, ratio) = (run.scene.projectile.mass_kg, run.scene.plate.mass_ratio);
    Some(projectile_kg * (row.projectile_velocity_m_s + ratio * row.plate_velocity_m_s))
}

/// How far the plate is set off from where it should be at the first sample after the contact, m.
pub(super) fn jump_after_contact(run: &Run) -> Option<f64> {
    let end_s = arrest_s(run);
    let end_m = run.first_arrest?.plate_displacement_m;
    let row = run.series.iter().find(|row| row.t_s > end_s * (1.0 + 1e-9))?;
    Some(row.plate_displacement_m - end_m - row.plate_velocity_m_s * (row.t_s - end_s))
}

fn speeds_in_contact(run: &Run) -> Vec<f64> {
    let contact = run.series.iter().filter(|row| row.mode == Mode::Penetrating);
    contact.map(|row| row.plate_velocity_m_s).collect()
}

pub(super) fn turns_in_contact(run: &Run) -> f64 {
    speeds_in_contact(run).windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count() as f64
}

pub(super) fn speed_in_contact(run: &Run) -> f64 {
    speeds_in_contact(run).into_iter().map(f64::abs).fold(0.0, larger)
}

/// Energy of plate, projectile and linear spring.
pub(super) fn energy_after_return(run: &Run) -> Option<f64> {
    let scene = &run.scene;
    let mass_kg = scene.projectile.mass_kg * (1.0 + scene.plate.mass_ratio);
    let energy_j = |row: &Sample| {
        0.5 * mass_kg * row.plate_velocity_m_s.powi(2)
            + 0.5 * scene.mechanism.spring.coefficient * row.plate_displacement_m.powi(2)
    };
    let turn = run.events.iter().find(|event| event.kind == EventKind::GreatestDisplacement);
    let turn_s = turn.map_or(f64::INFINITY, |event| event.t_s);
    let mut after = run.series.iter().skip_while(|row| row.t_s < turn_s);
    let turned = after.clone().next()?;
    let back = after.find(|row| row.plate_displacement_m < 0.0)?;
    Some(energy_j(back) / energy_j(turned))
}
