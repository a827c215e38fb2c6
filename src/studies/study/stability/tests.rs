//! The references for the rows of the stiff scenes.

use std::ops::ControlFlow;

use super::*;
use crate::study::accuracy::Compared;
use crate::study::context::CancelFlag;
use crate::study::plain_run;
use cmra_engine::model::run::{Outcome, RunSnapshot};

#[test]
fn a_row_that_is_decided_is_compared_with_other_steps() {
    let stop = CancelFlag::default();
    let mut without_others = Vec::new();
    for case in cases::CASES.iter() {
        let row = examine(case, &|| 0.0, &stop).unwrap();
        match row.basis {
            None => assert_eq!(row.run.outcome, Outcome::Moving, "{}", case.name),
            Some(ReferenceSource::Engine) => without_others.push(case.name),
            Some(_) => {}
        }
        assert_eq!(row.shortfall, None, "{}: {:?}", case.name, row.error);
    }
    // 100 000 oscillations within the contact are too many for other steps.
    assert_eq!(without_others, ["k 1e12, gamma 1e-4"]);
}

/// Each of them, by changing the reference: one that pulls out has them all.
#[test]
fn every_result_of_a_row_is_judged() {
    let case = cases::CASES.iter().find(|case| case.name == "gamma 0.8, plastic").unwrap();
    let scene = case.scene().unwrap();
    let run = plain_run(&scene).unwrap();
    let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
    let right = References::from_scene(&scene, go_on).other.unwrap();
    assert_eq!(shortfall(&run, error_of(&run, &right)), None);
    for at in Compared::ALL {
        for wrong in [right.results.get(at).map(|result| result * (1.0 + 1e-6)), None] {
            let mut other = right;
            other.results.set(at, wrong);
            let short = shortfall(&run, error_of(&run, &other));
            assert_eq!(short, Some(FailureReason::Error), "{at:?}: {wrong:?}");
        }
    }
}
