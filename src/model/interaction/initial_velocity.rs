//! The initial velocity of thesis equations 8.10 and 8.11: a perfectly inelastic collision that takes no time.
//!
//! `w(0) = m_p v/(m_p + m_2)`, and both bodies are one from then on. The model knows no force and no depth.

use std::sync::Arc;

use crate::model::interaction::course::{Course, say};
use crate::model::interaction::notes_of;
use crate::model::run::{EventKind, Outcome, Run};
use crate::model::run::{Observer, Settings};
use crate::model::scene::Scene;

/// Run it.
pub(super) fn run(scene: &Arc<Scene>, settings: Settings, observer: Observer<'_>) -> Run {
    let mut course = Course::new(scene, settings.series, 1.0);
    course.join();
    course.event(EventKind::FirstArrest);
    course.point();
    // One nose radius at impact velocity stands for the contact that takes no time.
    let horizon = course.horizon(1.0);
    let (farthest, end) = course.coast(horizon, observer);
    let mut run = course.into_run(Outcome::Arrested, end);
    run.max_plate_displacement_m = farthest;
    run.peak_contact_force_n = None;
    for sample in &mut run.series {
        sample.penetration_m = f64::NAN;
    }
    say(&mut run, notes_of(scene, None));
    run
}
