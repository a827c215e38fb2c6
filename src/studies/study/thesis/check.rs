//! Checking a claim: its expressions computed, its texts filled in, its verdict found.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};

use crate::model::scene::Scene;
use crate::model::variables::VARIABLES;
use crate::study::thesis::claim::{CURVE, Claim};
use crate::study::thesis::expression::{Evaluated, Reader};
use crate::study::thesis::runs::{Algorithm, Runs};
use crate::study::thesis::text::{ends, filled};
use crate::study::thesis::value::Value;
use crate::study::thesis::{ClaimResult, ClaimVerdict, Evidence};

pub(super) fn check(
    claim: &Claim,
    scenes: &BTreeMap<String, Scene>,
    runs: &Runs<'_>,
) -> ClaimResult {
    let evaluation = Evaluation { claim, scenes, runs, known: RefCell::default() };
    evaluation.found().unwrap_or_else(|problem| ClaimResult {
        sound: format!("this claim is written wrongly: {problem}"),
        printed: String::new(),
        verdict: ClaimVerdict::Unchecked,
        basis: Evidence::None,
    })
}

pub(super) struct Evaluation<'a> {
    claim: &'a Claim,
    /// The scenes of the file, by name.
    pub(super) scenes: &'a BTreeMap<String, Scene>,
    pub(super) runs: &'a Runs<'a>,
    /// The claim's values that were computed, by method; `None` while one is.
    known: RefCell<HashMap<(String, Algorithm), Option<Value>>>,
}

impl Evaluation<'_> {
    fn found(&self) -> Evaluated<ClaimResult> {
        let claim = self.claim;
        let verdict = if claim.read.is_some() { claim.expected } else { self.verdict()? };
        let (sound, printed) = if claim.trend.is_some() {
            self.trend()?
        } else {
            let computed = claim.read.or(claim.computed).or(claim.both);
            let printed = claim.as_printed.or(claim.both);
            (self.filled(computed, Algorithm::Sound)?, self.filled(printed, Algorithm::Printed)?)
        };
        let basis = match verdict {
            _ if claim.read.is_some() => Evidence::Read,
            ClaimVerdict::Unchecked if sound.is_empty() => Evidence::None,
            _ => Evidence::Computed,
        };
        Ok(ClaimResult { sound, printed, verdict, basis })
    }

    fn filled(&self, text: Option<&str>, method: Algorithm) -> Evaluated<String> {
        filled(text.unwrap_or_default(), &|own| self.value(own, method))
    }

    /// The verdict of the first condition that is true; without conditions there is none.
    fn verdict(&self) -> Evaluated<ClaimVerdict> {
        for (verdict, condition) in self.claim.conditions() {
            if self.value(condition, Algorithm::Sound)?.holds()? {
                return Ok(verdict);
            }
        }
        let is_checked = self.claim.conditions().next().is_some();
        Ok(if is_checked { ClaimVerdict::TrendFails } else { ClaimVerdict::Unchecked })
    }

    /// The ends of the claim's curve by both methods, with what its scene has of its own, and where the verdicts differ.
    fn trend(&self) -> Evaluated<(String, String)> {
        let by = |method| {
            let Some((_, condition)) = self.claim.conditions().next() else {
                return Err("a trend has a condition".to_owned());
            };
            let Value::Curve(curve) = self.named(CURVE, method)? else {
                return Err("a trend is one curve: a quantity along a variable".to_owned());
            };
            Ok((ends(&curve), self.value(condition, method)?.holds()?, curve.changes))
        };
        let (sound, holds, changes) = by(Algorithm::Sound)?;
        let (printed, holds_too, _) = by(Algorithm::Printed)?;
        let differs = match (holds_too, holds) {
            (true, false) => "; there it holds",
            (false, true) => "; there it fails",
            (true, true) | (false, false) => "",
        };
        Ok((format!("{changes}{sound}"), format!("{printed}{differs}")))
    }

    fn value(&self, text: &str, method: Algorithm) -> Evaluated {
        Reader::new(self, text, method).value().map_err(|problem| format!("`{text}`: {problem}"))
    }

    /// A value of the claim, which is computed once for a method.
    pub(super) fn named(&self, name: &str, method: Algorithm) -> Evaluated {
        let key = (name.to_owned(), method);
        match self.known.borrow().get(&key) {
            Some(Some(value)) => return Ok(value.clone()),
            Some(None) => return Err(format!("`{name}` needs itself")),
            None => {}
        }
        let text = self.claim.value(name);
        let text = text.ok_or_else(|| format!("`{name}` is no value of this claim"))?;
        self.known.borrow_mut().insert(key.clone(), None);
        let value = self.value(text, method)?;
        self.known.borrow_mut().insert(key, Some(value.clone()));
        Ok(value)
    }
}

/// How the scene of a curve differs from the one of chapter 9's figures: `d = 0.25 m: `.
pub(super) fn changes(scene: &Scene) -> String {
    let base = Scene::default();
    let own: Vec<String> = VARIABLES
        .iter()
        .filter(|it| it.value(scene) != it.value(&base))
        .map(|it| format!("{} = {} {}", it.symbol, it.show(scene), it.unit()))
        .map(|text| text.trim_end().to_owned())
        .collect();
    if own.is_empty() { String::new() } else { format!("{}: ", own.join(", ")) }
}

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use super::*;
    use crate::study::thesis::claim;
    use crate::study::thesis::runs::SharedRuns;

    /// The result for a claim with these values and checks.
    fn found(checks: &[(&str, &str)]) -> ClaimResult {
        let mut text =
            "[scenes]\nrigid = { mount = \"rigid\" }\n[[claim]]\nid = \"a\"\nplace = \"1\"\nsays = \"b\"\ncause = \"c\"\n\
                        verdict = \"misprint\"\n"
                .to_owned();
        for (name, value) in checks {
            let _ = writeln!(text, "{name} = \"{value}\"");
        }
        let claims = claim::read(text.leak()).map_err(|problem| panic!("{problem}")).unwrap();
        check(&claims.all[0], &claims.scenes, &Runs::new(&SharedRuns::default()))
    }

    fn value(expression: &str) -> String {
        found(&[("values.a", "[1, 2, 3]"), ("computed", &format!("{{{expression}}}"))]).sound
    }

    #[test]
    fn valid_arithmetic_binds_and_goes_through_lists_as_it_is_written() {
        for (expression, expected) in [
            ("2 + 3 * 4 ^ 2", "50"),
            ("-2 ^ 2", "-4"),
            ("(1 - 2) - 3", "-4"),
            ("2 ^ 3 ^ 2", "512"),
            ("10 * a - [1, 0, 1]", "9, 20, 29"),
            ("a[1] / 4", "0.5"),
            ("1 < 2 and not 2 < 1 or 1 > 2", "true"),
            ("not a > 1", "true, false, false"),
            ("sum(a > 1)", "2"),
            ("where(a, a > 1)", "2"),
            ("outer(a, [1, 10])", "1, 10, 2, 20, 3, 30"),
            ("choose(rises(a), 'up', 'down')", "up"),
            ("spring_force(k=[1, 2], n=1, x=-3)", "-3, -6"),
            ("spring_force(k=2, x=1..3:5) | ends", "2 N at x = 1, 6 N at 3"),
            ("slope(spring_force(k=2, x=1..3:5))", "2"),
            ("spring_force(k=[1, 2], n=[1, 2], x=3)", "3, 9, 6, 18"),
            ("100 * a | spaced %", "100.0 % 200.0 % 300.0 %"),
            ("a / 1e3 | mm", "1.0000 mm, 2.0000 mm, 3.0000 mm"),
            ("1500 | N", "1.500 kN"),
            ("1e-3-2", "-1.999"),
        ] {
            assert_eq!(value(expression), expected, "{expression}");
        }
    }

    #[test]
    fn the_first_condition_that_is_true_gives_the_verdict() {
        let verdict = |checks: &[(&str, &str)]| found(checks).verdict;
        assert_eq!(
            verdict(&[("reproduced", "1 > 2"), ("misprint", "2 > 1")]),
            ClaimVerdict::Misprint
        );
        assert_eq!(
            verdict(&[("corrected", "2 > 1"), ("reproduced", "2 > 1")]),
            ClaimVerdict::Reproduced
        );
        assert_eq!(verdict(&[("holds", "[1, 3] > 2")]), ClaimVerdict::TrendFails);
        assert_eq!(verdict(&[("holds", "0 / 0 > 2")]), ClaimVerdict::TrendFails);
        let read = found(&[("read", "as it says")]);
        assert_eq!((read.verdict, read.basis), (ClaimVerdict::Misprint, Evidence::Read));
        assert_eq!(found(&[]).basis, Evidence::None);
        let wrong = found(&[("computed", "{1 + 'a'}")]);
        assert!(wrong.sound.starts_with("this claim is written wrongly"), "{}", wrong.sound);
        assert_eq!(wrong.verdict, ClaimVerdict::Unchecked);
    }

    #[test]
    fn a_wrong_expression_is_refused_by_its_name() {
        for (wrong, named) in [
            ("dept(rigid)", "`dept`"),
            ("depth(rigit)", "`rigit`"),
            ("depth(rigid, gama=2)", "gama"),
            ("depth() | kg", "`kg`"),
            ("other", "`other`"),
            ("near(1, 2)", "3 arguments"),
            ("b", "`b` needs itself"),
            ("depth(x=1..2)", "`:` is expected"),
            ("a[1.5]", "a whole number"),
            ("1 2", "not expected after"),
            ("1 ? 2", "not expected after"),
            ("(1", "`)` is expected"),
            ("1 +", "a value is expected"),
        ] {
            let text = format!("{{{wrong}}}");
            let values = ("values.b", "c");
            let found =
                found(&[values, ("values.c", "b"), ("values.a", "[1, 2]"), ("computed", &text)]);
            assert!(found.sound.contains(named), "{wrong}: {}", found.sound);
        }
    }
}
