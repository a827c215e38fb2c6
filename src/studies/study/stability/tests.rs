//! The references for the rows of the stiff scenes.

use std::ops::ControlFlow;

use super::*;
use crate::model::run::Outcome;
use crate::study::context::{CancelFlag, Progress};

#[test]
fn a_row_that_is_decided_is_compared_with_other_steps() {
    let stop = CancelFlag::default();
    let mut without_others = Vec::new();
    for case in cases::CASES.iter() {
        let row = examine(case, &|| 0.0, &stop).unwrap();
        match row.basis {
            None if row.run.outcome == Outcome::Moving => {}
            None | Some(ReferenceSource::Engine) => without_others.push(case.name),
            Some(_) => {}
        }
        assert!(row.stiffness.largest().is_finite(), "{}", case.name);
        assert_eq!(row.shortfall, None, "{}: {:?}", case.name, row.error);
    }
    // 100 000 oscillations within the contact are too many for other steps.
    assert_eq!(without_others, ["k 1e12, gamma 1e-4"]);
}

#[test]
fn a_battery_on_two_threads_has_every_scene_once_in_its_order() {
    let cases = battery(true);
    let watch = &mut |_: Progress, _: Option<&[Row]>| ControlFlow::Continue(());
    let rows = run(&cases, &|| 0.0, &mut Context::new(2, watch)).unwrap();
    let names: Vec<&str> = rows.iter().map(|row| row.case.name).collect();
    assert_eq!(names, cases.iter().map(|case| case.name).collect::<Vec<_>>());
}
