//! Checking a claim: its expressions evaluated, its texts filled in, its verdict found.

use std::cell::RefCell;
use std::collections::HashMap;

use crate::model::scene::Scene;
use crate::model::units::Bare;
use crate::model::variables::{self, VARIABLES, Variable};
use crate::study::thesis::claim::Claim;
use crate::study::thesis::expression::{Expression, Query, Setting, Values};
use crate::study::thesis::runs::{Method, Runs};
use crate::study::thesis::text::{Template, ends};
use crate::study::thesis::value::{Curve, Value, join};
use crate::study::thesis::{Basis, Found, Verdict};

pub(super) fn check(claim: &Claim, runs: &Runs<'_>) -> Found {
    let evaluation = Evaluation { claim, runs, known: RefCell::default() };
    evaluation.found().unwrap_or_else(|problem| Found {
        sound: format!("this claim is written wrongly: {problem}"),
        printed: String::new(),
        verdict: Verdict::Unchecked,
        basis: Basis::None,
    })
}

struct Evaluation<'a> {
    claim: &'a Claim,
    runs: &'a Runs<'a>,
    /// The claim's values that were computed, by method.
    known: RefCell<HashMap<(String, Method), Value>>,
}

type Evaluated<T = Value> = Result<T, String>;

impl Evaluation<'_> {
    fn found(&self) -> Evaluated<Found> {
        let check = &self.claim.check;
        let verdict = if check.is_read { self.claim.expected } else { self.verdict()? };
        let (sound, printed) = if check.is_trend {
            self.trend()?
        } else {
            let computed = self.filled(check.computed.as_ref(), Method::Sound)?;
            (computed, self.filled(check.as_printed.as_ref(), Method::Printed)?)
        };
        let basis = match verdict {
            _ if check.is_read => Basis::Read,
            Verdict::Unchecked if sound.is_empty() => Basis::None,
            _ => Basis::Computed,
        };
        Ok(Found { sound, printed, verdict, basis })
    }

    fn filled(&self, template: Option<&Template>, method: Method) -> Evaluated<String> {
        template.map_or(Ok(String::new()), |it| it.filled(&|own| self.value(own, method)))
    }

    fn verdict(&self) -> Evaluated<Verdict> {
        let conditions = &self.claim.check.conditions;
        for (verdict, condition) in conditions {
            if self.value(condition, Method::Sound)?.holds()? {
                return Ok(*verdict);
            }
        }
        Ok(if conditions.is_empty() { Verdict::Unchecked } else { Verdict::TrendFails })
    }

    /// The ends of the claim's curve by both methods, with what its scene has of its own, and where the verdicts differ.
    fn trend(&self) -> Evaluated<(String, String)> {
        let check = &self.claim.check;
        let (Some(Expression::Query(query)), Some((_, condition))) =
            (check.values.get("curve"), check.conditions.first())
        else {
            return Err("a trend is a quantity along a variable, with a condition".to_owned());
        };
        let by = |method| {
            let Value::Curve(curve) = self.named("curve", method)? else {
                return Err("a trend is one curve".to_owned());
            };
            Ok((ends(&curve), self.value(condition, method)?.holds()?))
        };
        let (sound, holds) = by(Method::Sound)?;
        let (printed, holds_too) = by(Method::Printed)?;
        let differs = match (holds_too, holds) {
            (true, false) => "; there it holds",
            (false, true) => "; there it fails",
            (true, true) | (false, false) => "",
        };
        Ok((format!("{}{sound}", self.settings(query)?), format!("{printed}{differs}")))
    }

    /// How a curve's scene differs from the one of chapter 9's figures: `d = 0.25 m: `.
    fn settings(&self, query: &Query) -> Evaluated<String> {
        let base = Scene::default();
        let mut scene = query.scenes[0].clone();
        for setting in &query.settings {
            if let (Values::Of(value), Some(variable)) = (&setting.values, setting.variable) {
                set(&mut scene, variable, &self.value(value, Method::Sound)?)?;
            }
        }
        let own: Vec<String> = VARIABLES
            .iter()
            .filter(|it| it.value(&scene) != it.value(&base))
            .map(|it| {
                let unit = if it.unit() == "-" { String::new() } else { format!(" {}", it.unit()) };
                format!("{} = {}{unit}", it.symbol, it.show(&scene))
            })
            .collect();
        Ok(if own.is_empty() { String::new() } else { format!("{}: ", own.join(", ")) })
    }

    fn value(&self, expression: &Expression, method: Method) -> Evaluated {
        let all = |own: &[Expression]| {
            own.iter().map(|it| self.value(it, method)).collect::<Evaluated<Vec<_>>>()
        };
        match expression {
            Expression::Number(number) => Ok(Value::Number(*number)),
            Expression::Text(text) => Ok(Value::Text(text.clone())),
            Expression::Name(name) => self.named(name, method),
            Expression::List(list) => Ok(Value::List(all(list)?)),
            Expression::Item(list, at) => match self.value(list, method)? {
                Value::List(list) => {
                    list.get(*at).cloned().ok_or_else(|| format!("there is no value [{at}]"))
                }
                other => Err(format!("a list is expected, not {other:?}")),
            },
            Expression::Not(inner) => self.value(inner, method)?.not(),
            Expression::Binary(operator, operands) => {
                let [left, right] = &**operands;
                join(*operator, &[self.value(left, method)?, self.value(right, method)?])
            }
            Expression::Call(function, arguments) => function.of(&all(arguments)?),
            Expression::By(other, inner) => self.value(inner, *other),
            Expression::Query(query) => {
                let of =
                    |scene: &Scene| self.along(query, &Case::of(scene), &query.settings, method);
                match query.scenes.as_slice() {
                    [scene] => of(scene),
                    scenes => Ok(Value::List(scenes.iter().map(of).collect::<Evaluated<_>>()?)),
                }
            }
        }
    }

    fn named(&self, name: &str, method: Method) -> Evaluated {
        if let Some(value) = self.known.borrow().get(&(name.to_owned(), method)) {
            return Ok(value.clone());
        }
        let Some(expression) = self.claim.check.values.get(name) else {
            return Err(format!("`{name}` is no value of this claim"));
        };
        let value = self.value(expression, method)?;
        self.known.borrow_mut().insert((name.to_owned(), method), value.clone());
        Ok(value)
    }

    /// A quantity for all values of the settings that are left: lists give lists, a range a curve.
    fn along(&self, query: &Query, case: &Case, settings: &[Setting], method: Method) -> Evaluated {
        let Some((setting, rest)) = settings.split_first() else {
            return Ok(query.quantity.of(self.runs, method, &case.scene, case.x_m));
        };
        let with = |value: &Value| self.along(query, &case.with(setting, value)?, rest, method);
        match &setting.values {
            Values::Of(value) => match self.value(value, method)? {
                Value::List(list) => {
                    let all: Vec<Value> = list.iter().map(with).collect::<Evaluated<_>>()?;
                    Ok(Value::flat(all))
                }
                value => with(&value),
            },
            Values::Range([from, to], count) => {
                let from = self.value(from, method)?.number()?;
                let to = self.value(to, method)?.number()?;
                let mut points = Vec::new();
                for i in 0..*count {
                    let place = from + (to - from) * i as f64 / (count - 1) as f64;
                    let value = with(&Value::Number(place))?.number()?;
                    if value.is_finite() {
                        points.push((place, value));
                    }
                }
                let along = setting.variable.map_or("x", |it| it.symbol);
                Ok(Value::Curve(Curve { points, along, unit: query.quantity.unit() }))
            }
        }
    }
}

/// What a quantity is asked of.
#[derive(Clone)]
struct Case {
    scene: Scene,
    /// The displacement, m.
    x_m: f64,
}

impl Case {
    fn of(scene: &Scene) -> Self {
        Self { scene: scene.clone(), x_m: f64::NAN }
    }

    fn with(&self, setting: &Setting, value: &Value) -> Evaluated<Self> {
        let mut own = self.clone();
        match setting.variable {
            Some(variable) => set(&mut own.scene, variable, value)?,
            None => own.x_m = value.number()?,
        }
        Ok(own)
    }
}

fn set(scene: &mut Scene, variable: &Variable, value: &Value) -> Evaluated<()> {
    let value = match value {
        Value::Text(word) => variable.parse(scene, word, Bare::Si),
        other => Ok(variables::Value::Number(other.number()?)),
    };
    let set = value.and_then(|value| variable.set(scene, value));
    set.map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use super::*;
    use crate::study::thesis::claim;
    use crate::study::thesis::runs::SharedRuns;

    /// What is found for a claim with these values and checks.
    fn found(checks: &[(&str, &str)]) -> Found {
        let mut text =
            "[scenes]\n[[claim]]\nid = \"a\"\nplace = \"1\"\nsays = \"b\"\ncause = \"c\"\n\
                        verdict = \"misprint\"\n"
                .to_owned();
        for (name, value) in checks {
            let _ = writeln!(text, "{name} = \"{value}\"");
        }
        let claims = claim::read(&text).map_err(|problem| panic!("{problem}")).unwrap();
        check(&claims.all[0], &Runs::new(&SharedRuns::default()))
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
        ] {
            assert_eq!(value(expression), expected, "{expression}");
        }
    }

    #[test]
    fn the_first_condition_that_is_true_gives_the_verdict() {
        let verdict = |checks: &[(&str, &str)]| found(checks).verdict;
        assert_eq!(verdict(&[("reproduced", "1 > 2"), ("misprint", "2 > 1")]), Verdict::Misprint);
        assert_eq!(
            verdict(&[("corrected", "2 > 1"), ("reproduced", "2 > 1")]),
            Verdict::Reproduced
        );
        assert_eq!(verdict(&[("holds", "[1, 3] > 2")]), Verdict::TrendFails);
        assert_eq!(verdict(&[("holds", "0 / 0 > 2")]), Verdict::TrendFails);
        let read = found(&[("read", "as it says")]);
        assert_eq!((read.verdict, read.basis), (Verdict::Misprint, Basis::Read));
        assert_eq!(found(&[]).basis, Basis::None);
        let wrong = found(&[("computed", "{1 + 'a'}")]);
        assert!(wrong.sound.starts_with("this claim is written wrongly"), "{}", wrong.sound);
        assert_eq!(wrong.verdict, Verdict::Unchecked);
    }
}
