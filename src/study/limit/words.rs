//! What goes with a limit velocity, in sentences: the same on the command line and in the workbench.

use crate::model::units::{Engineering, fixed_significant};
use crate::study::compare::Load;
use crate::study::limit::Closures;

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
