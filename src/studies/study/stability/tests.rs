//! The references for the rows of the stiff scenes.

use super::*;
use crate::study::accuracy::Compared;
use crate::study::context::CancelFlag;
use crate::study::plain_run;

#[test]
fn a_row_is_compared_with_other_steps() {
    let stop = CancelFlag::default();
    let mut without_others = Vec::new();
    for case in cases::CASES.iter() {
        let row = examine(case, &|| 0.0, &stop).unwrap();
        match row.basis {
            None => panic!("{}", case.name),
            Some(ReferenceSource::Engine) => without_others.push(case.name),
            Some(_) => {}
        }
        assert_eq!(row.shortfall, None, "{}: {:?}", case.name, row.error);
    }
    // 100 000 oscillations within the contact are too many for other steps.
    assert_eq!(without_others, ["k 1e12, gamma 1e-4"]);
}

/// Each of them, by changing the reference: a pull-out has all of them, an undecided shot those of its first arrest.
#[test]
fn every_result_of_a_row_is_judged() {
    let arrest = [Compared::Depth, Compared::Time];
    for (name, judged) in
        [("gamma 0.8, plastic", &Compared::ALL[..]), ("elastic stop, n 0.4", &arrest)]
    {
        let case = cases::CASES.iter().find(|case| case.name == name).unwrap();
        let run = plain_run(&case.scene().unwrap()).unwrap();
        let right = reference_of(&run, &CancelFlag::default()).unwrap();
        assert_eq!(shortfall(&run, error_of(&run, &right)), None, "{name}");
        for at in judged {
            for wrong in [right.results.get(*at).map(|result| result * (1.0 + 1e-6)), None] {
                let mut other = right;
                other.results.set(*at, wrong);
                let short = shortfall(&run, error_of(&run, &other));
                assert_eq!(short, Some(FailureReason::Error), "{name}, {at:?}: {wrong:?}");
            }
        }
    }
}
