//! What goes with a limit velocity, in sentences: the same on the command line and in the workbench.

use crate::model::units::{Engineering, fixed_significant};
use crate::study::compare::Load;
use crate::study::limit::{Closures, Report};

/// Part of the impact velocity left just above the limit, from which on the plate's own motion explains it.
const CARRIED: f64 = 0.2;

/// Why the residual velocity begins far above zero, which no law of the curve knows; `None` where it does not.
pub fn carried(report: &Report) -> Option<String> {
    report.limit.velocity_m_s()?;
    let first = report.shots.iter().find_map(|shot| Some((shot.impact_m_s, shot.residual_m_s?)));
    let (_, residual) = first.filter(|(impact, residual)| *residual > CARRIED * impact)?;
    Some(format!(
        "Just above the limit the residual velocity is {} m/s, the common velocity of projectile and plate.",
        fixed_significant(residual, 4)
    ))
}

/// What the mechanism bears at the limit; `None` where nothing of it is known.
pub fn load(load: &Load) -> Option<String> {
    let part = |name: &str, value: Option<f64>, unit: &'static str| {
        let value = Engineering { value: value?, unit, digits: 4 };
        Some(format!("{name} {value}"))
    };
    let parts = [
        part("stroke", load.stroke_m, "m"),
        part("stored energy", load.stored_j, "J"),
        part("mount force", load.mount_force_n, "N"),
    ];
    let known: Vec<String> = parts.into_iter().flatten().collect();
    (!known.is_empty()).then(|| known.join(", "))
}

/// The band between the closures.
pub fn closures(closures: &Closures) -> String {
    let velocity = |value: Option<f64>| {
        value.map_or_else(|| "none".to_owned(), |v| format!("{} m/s", fixed_significant(v, 4)))
    };
    let each = format!(
        "2 Y with dishing {}, cavity without dishing and with twice the C_d {}",
        velocity(closures.double_yield_m_s),
        velocity(closures.cavity_m_s)
    );
    closures.band_m_s().map_or_else(
        || each.clone(),
        |(low, high)| format!("{} to {}: {each}", fixed_significant(low, 4), velocity(Some(high))),
    )
}
