//! The references for the rows of the stiff scenes.

use std::ops::ControlFlow;

use super::*;
use crate::model::run::Outcome;
use crate::study::context::{CancelFlag, Progress};

/// A time at which the battery leaves the other methods out.
const LATE_S: f64 = 60.0;

#[test]
fn a_row_that_is_decided_is_compared_with_other_steps() {
    // Other methods are looked at elsewhere: here their time is up at once.
    let stop = CancelFlag::default();
    let clock = TimeBudget { now_s: &|| 0.0, until_s: -1.0, stop: &stop };
    let mut without_others = Vec::new();
    for case in cases::CASES.iter() {
        let row = examine(case, clock).unwrap();
        assert!(row.others.iter().all(|verdict| *verdict == Verdict::None(Fault::CutOff)));
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
    let rows = run(&cases, &|| LATE_S, &mut Context::new(2, watch)).unwrap();
    let names: Vec<&str> = rows.iter().map(|row| row.case.name).collect();
    assert_eq!(names, cases.iter().map(|case| case.name).collect::<Vec<_>>());
}

/// Not only between two scenes: one may take seconds.
#[test]
fn a_battery_is_stopped_within_a_scene_and_keeps_what_it_has() {
    let all = battery(false);
    let quick = all.iter().find(|case| case.name != "plastic, n 0.22, g 0").unwrap();
    // It has millions of steps, and is stopped while it runs.
    let long = all.iter().find(|case| case.name == "plastic, n 0.22, g 0").unwrap();
    let mut asked = None;
    let watch = &mut |progress: Progress, _: Option<&[Row]>| {
        if progress.done > 0 {
            asked = Some(asked.unwrap_or(0) + 1);
        }
        if asked > Some(2) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let context = &mut Context::new(1, watch);
    let rows = run(&[*quick, *long], &|| LATE_S, context).unwrap();
    assert!(rows.len() == 1 && context.is_stopped());
}
/// Each of them, by changing the reference: one that pulls out has them all.
#[test]
fn every_result_of_a_row_is_judged() {
    let case = cases::CASES.iter().find(|case| case.name == "gamma 0.8, plastic").unwrap();
    let scene = case.scene().unwrap();
    let run = bare(&scene, false, &mut |_| ControlFlow::Continue(())).unwrap();
    let right = References::of(&scene).other.unwrap();
    assert_eq!(shortfall(&run, error_of(&run, &right)), None);
    for at in 0..right.results.len() {
        for wrong in [right.results[at].map(|result| result * (1.0 + 1e-6)), None] {
            let mut other = right;
            other.results[at] = wrong;
            let short = shortfall(&run, error_of(&run, &other));
            assert_eq!(short, Some(Shortfall::Error), "result {at}: {wrong:?}");
        }
    }
}
