//! The references for the rows of the stiff scenes.

use super::*;
use crate::model::run::Outcome;
use crate::study::context::CancelFlag;

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
        assert_eq!(row.shortfall, None, "{}: {:?}", case.name, row.error);
    }
    // 100 000 oscillations within the contact are too many for other steps.
    assert_eq!(without_others, ["k 1e12, gamma 1e-4"]);
}
