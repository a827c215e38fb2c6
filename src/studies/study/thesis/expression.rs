//! The expressions of the claims: numbers, lists, texts, arithmetic, conditions, functions, and quantities of scenes; computed as
//! they are read.

use crate::model::scene::Scene;
use crate::model::units::Bare;
use crate::model::variables::{self, Variable};
use crate::study::thesis::check::{Evaluation, changes};
use crate::study::thesis::functions::FUNCTIONS;
use crate::study::thesis::quantities::ClaimQuantity;
use crate::study::thesis::runs::Algorithm;
use crate::study::thesis::value::{Curve, Value, join};

/// A value, or what is wrong with the expression.
pub(super) type Evaluated<T = Value> = Result<T, String>;

/// A variable that a query changes.
struct Setting {
    /// Which; `None` is the displacement that some quantities depend on.
    variable: Option<&'static Variable>,
    values: Values,
}

/// The values of a variable.
enum Values {
    /// One, or a list.
    Of(Value),
    /// Equally spaced ones from the first to the last: a curve of a given number of points.
    Range { from: f64, to: f64, count: usize },
}

/// A scene on its way to a query's value, and the displacement requested.
#[derive(Clone)]
struct Case {
    scene: Scene,
    x_m: f64,
}

impl Case {
    fn with(&self, setting: &Setting, value: &Value) -> Evaluated<Self> {
        let mut own = self.clone();
        let Some(variable) = setting.variable else {
            own.x_m = value.number()?;
            return Ok(own);
        };
        let value = match value {
            Value::Text(word) => variable.parse(&own.scene, word, Bare::Si),
            other => Ok(variables::Value::Number(other.number()?)),
        };
        let set = value.and_then(|value| variable.set(&mut own.scene, value));
        set.map_err(|error| error.to_string())?;
        Ok(own)
    }
}

/// The operators, what binds weakest first; longer ones before those they begin with.
const LEVELS: [&[&str]; 5] =
    [&["or"], &["and"], &["==", "!=", "<=", ">=", "<", ">"], &["+", "-"], &["*", "/"]];

/// The level that `not` stands before.
const COMPARISONS: usize = 2;

/// Reads and computes one expression.
pub(super) struct Reader<'a> {
    evaluation: &'a Evaluation<'a>,
    method: Algorithm,
    /// What is not read yet, without blanks before it.
    rest: &'a str,
}

impl<'a> Reader<'a> {
    pub(super) fn new(evaluation: &'a Evaluation<'a>, text: &'a str, method: Algorithm) -> Self {
        Self { evaluation, method, rest: text.trim_start() }
    }

    /// The value of the whole expression.
    pub(super) fn value(mut self) -> Evaluated {
        let value = self.level(0)?;
        if self.rest.is_empty() {
            return Ok(value);
        }
        Err(format!("`{}` is not expected after an expression", self.rest))
    }

    /// Takes an operator, a bracket or a whole word, if it stands next.
    fn take(&mut self, symbol: &str) -> bool {
        let is_whole =
            |rest: &&str| !(symbol.ends_with(is_of_word) && rest.starts_with(is_of_word));
        let after = self.rest.strip_prefix(symbol).filter(is_whole);
        self.rest = after.map_or(self.rest, str::trim_start);
        after.is_some()
    }

    fn expect(&mut self, symbol: &str) -> Evaluated<()> {
        if self.take(symbol) {
            return Ok(());
        }
        Err(format!("`{symbol}` is expected before `{}`", self.rest))
    }

    fn word(&mut self) -> Option<&'a str> {
        let (word, rest) =
            self.rest.split_at(self.rest.find(|c| !is_of_word(c)).unwrap_or(self.rest.len()));
        word.starts_with(char::is_alphabetic).then(|| {
            self.rest = rest.trim_start();
            word
        })
    }

    /// The longest number that stands next; two dots are those of a range.
    fn number(&mut self) -> Option<f64> {
        let before = self
            .rest
            .split("..")
            .next()
            .filter(|it| it.starts_with(|c: char| c.is_ascii_digit()))?;
        let read = |length: usize| Some((before.get(..length)?.parse().ok()?, length));
        let (number, length) = (1..=before.len()).rev().find_map(read)?;
        self.rest = self.rest[length..].trim_start();
        Some(number)
    }

    fn whole_number(&mut self) -> Evaluated<usize> {
        let own = self.rest;
        let number = self.number().and_then(|number| number.to_string().parse().ok());
        number.ok_or_else(|| format!("a whole number is expected before `{own}`"))
    }

    fn text(&mut self) -> Option<&'a str> {
        let (text, rest) = self.rest.strip_prefix('\'')?.split_once('\'')?;
        self.rest = rest.trim_start();
        Some(text)
    }

    fn level(&mut self, level: usize) -> Evaluated {
        let Some(operators) = LEVELS.get(level) else { return self.power() };
        if level == COMPARISONS && self.take("not") {
            return self.level(level)?.not();
        }
        let mut left = self.level(level + 1)?;
        while let Some(operator) = operators.iter().find(|symbol| self.take(symbol)) {
            left = join(operator, left, self.level(level + 1)?)?;
        }
        Ok(left)
    }

    fn power(&mut self) -> Evaluated {
        if self.take("-") {
            return join("*", Value::Number(-1.0), self.power()?);
        }
        let mut base = self.atom()?;
        while self.take("[") {
            base = base.item(self.whole_number()?)?;
            self.expect("]")?;
        }
        if !self.take("^") {
            return Ok(base);
        }
        join("^", base, self.power()?)
    }

    fn atom(&mut self) -> Evaluated {
        if let Some(number) = self.number() {
            return Ok(Value::Number(number));
        }
        if let Some(text) = self.text() {
            return Ok(Value::Text(text.to_owned()));
        }
        if self.take("[") {
            return Ok(Value::List(self.until("]", |own| own.level(0))?));
        }
        if self.take("(") {
            let inner = self.level(0)?;
            self.expect(")")?;
            return Ok(inner);
        }
        match self.word() {
            Some(name) if self.take("(") => self.call(name),
            Some("pi") => Ok(Value::Number(std::f64::consts::PI)),
            Some(name) => self.evaluation.named(name, self.method),
            None => Err(format!("a value is expected before `{}`", self.rest)),
        }
    }

    /// The parts between commas up to a closing symbol.
    fn until<T>(
        &mut self,
        end: &str,
        mut each: impl FnMut(&mut Self) -> Evaluated<T>,
    ) -> Evaluated<Vec<T>> {
        let mut all = Vec::new();
        while !self.take(end) {
            if !all.is_empty() {
                self.expect(",")?;
            }
            all.push(each(self)?);
        }
        Ok(all)
    }

    fn call(&mut self, name: &str) -> Evaluated {
        let by = [("sound", Algorithm::Sound), ("printed", Algorithm::Printed)];
        if let Some((_, method)) = by.into_iter().find(|it| it.0 == name) {
            let outer = std::mem::replace(&mut self.method, method);
            let inner = self.level(0)?;
            self.method = outer;
            self.expect(")")?;
            return Ok(inner);
        }
        if let Some(quantity) = ClaimQuantity::find(name) {
            return self.query(name, quantity);
        }
        let Some(function) = FUNCTIONS.iter().find(|it| it.name == name) else {
            return Err(format!(
                "`{name}` is no output, no quantity (quantities.rs) and no function (functions.rs)"
            ));
        };
        let arguments = self.until(")", |own| own.level(0))?;
        if arguments.len() != function.arguments {
            let wanted = function.arguments;
            return Err(format!("`{name}` takes {wanted} arguments, not {}", arguments.len()));
        }
        function.of(&arguments)
    }

    /// A quantity of one or more scenes, with variables changed.
    fn query(&mut self, own_name: &str, quantity: ClaimQuantity) -> Evaluated {
        let (mut scenes, mut settings) = (Vec::new(), Vec::new());
        self.until(")", |own| {
            let name = own.word();
            let name = name.ok_or_else(|| format!("`{own_name}` takes scenes and NAME=VALUE"))?;
            if own.take("=") {
                settings.push(own.setting(name)?);
                return Ok(());
            }
            let known = own.evaluation.scenes;
            scenes.push(known.get(name).ok_or_else(|| {
                let known: Vec<&str> = known.keys().map(String::as_str).collect();
                format!("`{name}` is no scene: take one of {}", known.join(", "))
            })?);
            Ok(())
        })?;
        // Lists come before the range that makes a curve.
        settings.sort_by_key(|it| matches!(it.values, Values::Range { .. }));
        let of = |scene: &Scene| {
            let case = Case { scene: scene.clone(), x_m: f64::NAN };
            self.along(&case, &settings, quantity)
        };
        match scenes.as_slice() {
            [] => of(&Scene::default()),
            [scene] => of(scene),
            scenes => Ok(Value::List(scenes.iter().map(|it| of(it)).collect::<Evaluated<_>>()?)),
        }
    }

    fn setting(&mut self, name: &str) -> Evaluated<Setting> {
        let variable = match name {
            "x" => None,
            name => Some(variables::find(name).map_err(|error| error.to_string())?),
        };
        let first = self.level(COMPARISONS + 1)?;
        let values = if self.take("..") {
            let (from, to) = (first.number()?, self.level(COMPARISONS + 1)?.number()?);
            self.expect(":")?;
            Values::Range { from, to, count: self.whole_number()? }
        } else {
            Values::Of(first)
        };
        Ok(Setting { variable, values })
    }

    /// The values of a quantity for the settings that are not yet made, a value for each combination.
    fn along(&self, case: &Case, settings: &[Setting], quantity: ClaimQuantity) -> Evaluated {
        let Some((setting, rest)) = settings.split_first() else {
            return Ok(quantity.of(self.evaluation.runs, self.method, &case.scene, case.x_m));
        };
        let with = |value: &Value| self.along(&case.with(setting, value)?, rest, quantity);
        match &setting.values {
            Values::Of(Value::List(list)) => {
                Ok(Value::flat(list.iter().map(with).collect::<Evaluated<_>>()?))
            }
            Values::Of(value) => with(value),
            Values::Range { from, to, count } => {
                let mut points = Vec::new();
                for i in 0..*count {
                    let place = from + (to - from) * i as f64 / (count - 1) as f64;
                    let value = with(&Value::Number(place))?.number()?;
                    if value.is_finite() {
                        points.push((place, value));
                    }
                }
                let along = setting.variable.map_or("x", |it| it.symbol);
                let (unit, changes) = (quantity.unit(), changes(&case.scene));
                Ok(Value::Curve(Curve { points, along, unit, changes }))
            }
        }
    }
}

fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}
