//! What the rows of the battery are measured against.

use super::*;

#[test]
fn a_row_is_judged_by_other_code_unless_what_follows_the_contact_decides() {
    // Other methods are looked at elsewhere: here their time is up at once.
    let stop = AtomicBool::new(false);
    let clock = Clock { now_s: &|| 0.0, until_s: -1.0, stop: &stop };
    let mut by_the_engine = Vec::new();
    for case in cases::CASES {
        let row = examine(case, clock).unwrap().unwrap();
        assert!(row.others.iter().all(|verdict| *verdict == Verdict::CutOff));
        match row.basis {
            Basis::Stored | Basis::Dop853 | Basis::Radau => {}
            Basis::Tighter => by_the_engine.push(case.name),
            Basis::None => assert_eq!(row.run.outcome, Outcome::Moving, "{}", case.name),
        }
        assert!(row.stiffness.largest().is_finite(), "{}", case.name);
    }
    assert_eq!(by_the_engine, ["d 0.5, k 1e5, plastic", "gamma 0.8, plastic"]);
}
