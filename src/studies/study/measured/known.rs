//! Built-in table of measured limits, and the classes computed from it.

use std::sync::LazyLock;

use crate::study::envelope::thickness_ratio;
use crate::study::limit;
use crate::study::measured::class::{Class, Key, Sample, classes};
use crate::study::measured::table::{FindEntry, Measurement, read};

/// Built-in table of measured limits, as CSV.
const FILE: &str = include_str!("../../data/limits.csv");

/// Returns the built-in table; empty if the file is invalid, which a test excludes.
pub fn built_in() -> &'static [Measurement] {
    static TABLE: LazyLock<Vec<Measurement>> = LazyLock::new(|| {
        let none: FindEntry<'_> = &|_, name| Err(format!("no entry {name}"));
        read(FILE, none).unwrap_or_default()
    });
    &TABLE
}

/// Returns the classes of the built-in table.
pub fn known() -> &'static [Class] {
    static KNOWN: LazyLock<Vec<Class>> = LazyLock::new(|| {
        let law = |it: &Measurement| it.scene.as_ref().ok().and_then(limit::closed_form);
        let samples = built_in().iter().filter_map(|it| sample(it, law(it)));
        classes(&samples.collect::<Vec<_>>())
    });
    &KNOWN
}

/// Returns the error of the law's limit, m/s, in a measurement of a class; `None` without a class, or without one of the limits.
pub(super) fn sample(measurement: &Measurement, law_m_s: Option<f64>) -> Option<Sample> {
    let scene = measurement.scene.as_ref().ok()?;
    let (law, measured) = (law_m_s?, measurement.measured.limit_m_s?);
    Some(Sample {
        key: Key::from_scene(scene)?,
        paper: measurement.source.clone(),
        error: (law / measured).ln(),
        thickness: thickness_ratio(scene),
        angle_deg: scene.projectile.obliquity_deg,
    })
}
