//! The fits against a textbook example, drawn shots, and sets that bracket no limit.

use super::*;
use crate::numerics::random::Random;

fn shot(velocity_m_s: f64, perforated: bool) -> MeasuredShot {
    MeasuredShot { velocity_m_s, perforated, residual_m_s: None, penetration_m: None }
}

/// The example of hours of study and exams passed that textbooks and encyclopaedias have: intercept -4.0777, slope 1.5046 an hour; the ends
/// of the interval come from a search over the likelihood by hand, outside this program.
#[test]
fn the_textbook_example_of_hours_and_exams() {
    let hours = [
        0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0, 3.25, 3.5, 4.0, 4.25,
        4.5, 4.75, 5.0, 5.5,
    ];
    let passed = [0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 1, 1, 1, 1, 1];
    let shots = hours.into_iter().zip(passed).map(|(hours, passed)| shot(hours, passed == 1));
    let report = fit(shots.collect()).unwrap();
    let found = report.logistic;
    assert_eq!(found.method, Estimator::MaximumLikelihood);
    assert!(report.has_mixed_results());
    assert!((1.0 / found.scale_m_s - 1.5046).abs() < 1e-4, "{found:?}");
    assert!((found.v50_m_s / found.scale_m_s - 4.0777).abs() < 1e-4, "{found:?}");
    assert!((found.range_m_s.0.unwrap() - 1.795_851).abs() < 1e-5, "{found:?}");
    assert!((found.range_m_s.1.unwrap() - 3.708_988).abs() < 1e-5, "{found:?}");
    // Two hours of study: 0.26; four: 0.87.
    assert!(
        (found.probability(2.0) - 0.26).abs() < 5e-3
            && (found.probability(4.0) - 0.87).abs() < 5e-3
    );
    assert!((found.probability(found.quantile_m_s(0.9)) - 0.9).abs() < 1e-12);
}

/// No zone of mixed results: plain likelihood has no maximum. The values come from a search over the penalised likelihood outside
/// this program.
#[test]
fn separated_shots_take_firths_penalty() {
    let stopped = [280.0, 285.0, 290.0, 296.0].map(|v| shot(v, false));
    let through = [301.0, 304.0, 310.0, 318.0].map(|v| shot(v, true));
    let report = fit([stopped, through].concat()).unwrap();
    assert!(!report.has_mixed_results());
    assert_eq!((report.highest_stopped_m_s, report.lowest_perforated_m_s), (296.0, 301.0));
    let found = report.logistic;
    assert_eq!(found.method, Estimator::Firth);
    assert!((found.v50_m_s - 297.763_464).abs() < 1e-4, "{found:?}");
    assert!((found.scale_m_s - 4.935_029).abs() < 1e-4, "{found:?}");
    assert!((found.range_m_s.0.unwrap() - 281.632_948).abs() < 1e-4, "{found:?}");
    assert!((found.range_m_s.1.unwrap() - 314.522_138).abs() < 1e-4, "{found:?}");
}

/// Shots drawn from a curve of 250 m/s and 4 m/s: the estimate of many is near, and the interval of few holds the truth in about
/// 95 % of the sets.
#[test]
fn shots_drawn_from_a_known_curve() {
    let mut random = Random::new(7);
    let mut draw = |count: usize| -> Vec<MeasuredShot> {
        (0..count)
            .map(|_| {
                let velocity = 230.0 + 40.0 * random.unit();
                let p = 1.0 / (1.0 + (-(velocity - 250.0) / 4.0).exp());
                shot(velocity, random.unit() < p)
            })
            .collect()
    };
    let many = fit(draw(4000)).unwrap().logistic;
    // Standard deviations of some 0.2 m/s and 0.15 m/s.
    assert!((many.v50_m_s - 250.0).abs() < 0.8, "{many:?}");
    assert!((many.scale_m_s - 4.0).abs() < 0.6, "{many:?}");
    let (mut sets, mut hold) = (0.0, 0.0);
    for _ in 0..200 {
        let Ok(report) = fit(draw(16)) else { continue };
        let (low, high) = report.logistic.range_m_s;
        sets += 1.0;
        hold +=
            f64::from(u8::from(low.is_none_or(|v| v < 250.0) && high.is_none_or(|v| v > 250.0)));
    }
    assert!(sets > 190.0 && (0.89..0.99).contains(&(hold / sets)), "{hold} of {sets}");
}

#[test]
fn residual_velocities_give_the_law_they_were_made_with() {
    let mut shots: Vec<MeasuredShot> = [200.0, 215.0, 225.0].map(|v| shot(v, false)).to_vec();
    for i in 1..=8 {
        let v = 232.3 + 15.0 * f64::from(i);
        let residual_m_s = Some(0.9 * (v * v - 232.3 * 232.3).sqrt());
        shots.push(MeasuredShot { residual_m_s, ..shot(v, true) });
    }
    let report = fit(shots).unwrap();
    let law = report.lambert_jonas.unwrap();
    assert!((law.limit_m_s - 232.3).abs() < 0.01, "{law:?}");
    assert!((law.a - 0.9).abs() < 1e-3 && (law.p - 2.0).abs() < 1e-2, "{law:?}");
    assert_eq!((report.perforated(), report.residuals().len()), (8, 8));
}

#[test]
fn shots_that_bracket_no_limit_are_refused_with_the_cure() {
    let told = |shots: &[MeasuredShot]| fit(shots.to_vec()).unwrap_err();
    assert!(told(&[shot(1.0, true), shot(2.0, false)]).contains("2 shots are too few"));
    let slow = [1.0, 2.0, 3.0].map(|v| shot(v, false));
    assert!(told(&slow).contains("above 3 m/s"), "{}", told(&slow));
    let fast = [1.0, 2.0, 3.0].map(|v| shot(v, true));
    assert!(told(&fast).contains("below 1 m/s"), "{}", told(&fast));
    let odd = [shot(1.0, true), shot(2.0, true), shot(3.0, false), shot(4.0, false)];
    assert!(told(&odd).contains("does not become more frequent"));
    let equal = [shot(2.0, true), shot(2.0, true), shot(2.0, false)];
    assert!(told(&equal).contains("does not become more frequent"));
}

/// A shot far off, and thousands of them, leave everything finite; two shots that hardly bound the limit say so.
#[test]
fn extreme_sets_stay_finite() {
    for set in [
        vec![shot(1.0, false), shot(300.0, true), shot(3000.0, true)],
        vec![shot(299.999_999, false), shot(300.0, true), shot(300.0, true), shot(1e4, true)],
        vec![shot(250.0, false), shot(300.0, true), shot(299.0, false), shot(251.0, true)],
    ] {
        let found = fit(set.clone()).unwrap().logistic;
        assert!(found.v50_m_s.is_finite() && found.scale_m_s > 0.0, "{set:?}: {found:?}");
        let (low, high) = found.range_m_s;
        assert!(low.is_none_or(|v| v < found.v50_m_s) && high.is_none_or(|v| v > found.v50_m_s));
    }
}
