//! The expressions of the claims: numbers, lists, texts, arithmetic, conditions, functions, and quantities of scenes; computed as
//! they are read.

use crate::model::scene::Scene;
use crate::model::units::Bare;
use crate::model::variables::{self, Variable};
use crate::study::thesis::check::Evaluation;
use crate::study::thesis::functions::FUNCTIONS;
use crate::study::thesis::quantities::Quantity;
use crate::study::thesis::runs::{Algorithm, Runs};
use crate::study::thesis::value::{Curve, Value, join};

/// A value, or what is wrong with the expression.
pub(super) type Evaluated<T = Value> = Result<T, String>;

/// A quantity of one or more scenes, with variables changed.
pub(super) struct Query {
    quantity: Quantity,
    scenes: Vec<Scene>,
    /// Those with a list come before the one that makes a curve.
    settings: Vec<Setting>,
}

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

impl Query {
    fn value(&self, runs: &Runs<'_>, method: Algorithm) -> Evaluated {
        let of = |scene: &Scene| {
            let case = Case { scene: scene.clone(), x_m: f64::NAN };
            self.along(&case, &self.settings, &|case| {
                self.quantity.of(runs, method, &case.scene, case.x_m)
            })
        };
        match self.scenes.as_slice() {
            [scene] => of(scene),
            scenes => Ok(Value::List(scenes.iter().map(of).collect::<Evaluated<_>>()?)),
        }
    }

    /// The values of a query for the settings that are not yet made, a value for each combination.
    fn along(&self, case: &Case, settings: &[Setting], of: &dyn Fn(&Case) -> Value) -> Evaluated {
        let Some((setting, rest)) = settings.split_first() else { return Ok(of(case)) };
        let with = |value: &Value| self.along(&case.with(setting, value)?, rest, of);
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
                Ok(Value::Curve(Curve { points, along, unit: self.quantity.unit() }))
            }
        }
    }

    /// Its first scene with the variables that have one value.
    pub(super) fn scene(&self) -> Evaluated<Scene> {
        let mut scene = self.scenes[0].clone();
        for setting in &self.settings {
            if let (Values::Of(value), Some(variable)) = (&setting.values, setting.variable) {
                set(&mut scene, variable, value)?;
            }
        }
        Ok(scene)
    }
}

/// The operators, what binds weakest first.
const LEVELS: [&[&str]; 5] =
    [&["or"], &["and"], &["==", "!=", "<=", ">=", "<", ">"], &["+", "-"], &["*", "/"]];

/// The level that `not` stands before.
const COMPARISONS: usize = 2;

/// Longer ones before those they begin with.
const SYMBOLS: [&str; 19] = [
    "..", "==", "!=", "<=", ">=", "<", ">", "=", "+", "-", "*", "/", "^", "(", ")", "[", "]", ",",
    ":",
];

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(f64),
    Word(String),
    Text(String),
    Symbol(&'static str),
}

/// Reads and computes one expression.
pub(super) struct Reader<'a> {
    evaluation: &'a Evaluation<'a>,
    method: Algorithm,
    tokens: Vec<Token>,
    at: usize,
}

impl<'a> Reader<'a> {
    pub(super) fn new(
        evaluation: &'a Evaluation<'a>,
        text: &str,
        method: Algorithm,
    ) -> Evaluated<Self> {
        Ok(Self { evaluation, method, tokens: tokens(text)?, at: 0 })
    }

    /// The value of the whole expression.
    pub(super) fn value(mut self) -> Evaluated {
        let value = self.level(0)?;
        match self.tokens.get(self.at) {
            None => Ok(value),
            Some(token) => Err(format!("{token:?} is not expected after an expression")),
        }
    }

    /// The query that the expression is; `None` where it is something else.
    pub(super) fn only_query(mut self) -> Evaluated<Option<Query>> {
        let Some(Token::Word(name)) = self.next() else { return Ok(None) };
        match Quantity::find(&name) {
            Some(quantity) if self.take("(") => self.query(&name, quantity).map(Some),
            Some(_) | None => Ok(None),
        }
    }

    fn next(&mut self) -> Option<Token> {
        let next = self.tokens.get(self.at).cloned();
        self.at += 1;
        next
    }

    fn take(&mut self, symbol: &str) -> bool {
        let is_next = match self.tokens.get(self.at) {
            Some(Token::Symbol(own)) => *own == symbol,
            Some(Token::Word(own)) => own == symbol,
            Some(Token::Number(_) | Token::Text(_)) | None => false,
        };
        self.at += usize::from(is_next);
        is_next
    }

    fn expect(&mut self, symbol: &str) -> Evaluated<()> {
        if self.take(symbol) {
            return Ok(());
        }
        let found = self.tokens.get(self.at);
        Err(found.map_or_else(
            || format!("`{symbol}` is missing at the end"),
            |token| format!("`{symbol}` is expected before {token:?}"),
        ))
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

    fn whole_number(&mut self) -> Evaluated<usize> {
        let next = self.next();
        match next {
            Some(Token::Number(number)) => number.to_string().parse().ok(),
            Some(Token::Word(_) | Token::Text(_) | Token::Symbol(_)) | None => None,
        }
        .ok_or_else(|| format!("a whole number is expected, not {next:?}"))
    }

    fn atom(&mut self) -> Evaluated {
        let Some(token) = self.next() else {
            return Err("a value is missing at the end".to_owned());
        };
        match token {
            Token::Number(number) => Ok(Value::Number(number)),
            Token::Text(text) => Ok(Value::Text(text)),
            Token::Symbol("(") => {
                let inner = self.level(0)?;
                self.expect(")")?;
                Ok(inner)
            }
            Token::Symbol("[") => Ok(Value::List(self.until("]", |own| own.level(0))?)),
            Token::Symbol(symbol) => Err(format!("`{symbol}` is not the beginning of a value")),
            Token::Word(name) if self.take("(") => self.call(&name),
            Token::Word(name) if name == "pi" => Ok(Value::Number(std::f64::consts::PI)),
            Token::Word(name) => self.evaluation.named(&name, self.method),
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
        if let Some(quantity) = Quantity::find(name) {
            return self.query(name, quantity)?.value(self.evaluation.runs, self.method);
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

    fn query(&mut self, own_name: &str, quantity: Quantity) -> Evaluated<Query> {
        let mut query = Query { quantity, scenes: Vec::new(), settings: Vec::new() };
        self.until(")", |own| {
            let Some(Token::Word(name)) = own.tokens.get(own.at).cloned() else {
                return Err(format!("`{own_name}` takes scenes and NAME=VALUE"));
            };
            own.at += 1;
            if own.take("=") {
                query.settings.push(own.setting(&name)?);
                return Ok(());
            }
            let Some(scene) = own.evaluation.scenes.get(&name) else {
                let known: Vec<&str> = own.evaluation.scenes.keys().map(String::as_str).collect();
                return Err(format!("`{name}` is no scene: take one of {}", known.join(", ")));
            };
            query.scenes.push(scene.clone());
            Ok(())
        })?;
        query.settings.sort_by_key(|it| matches!(it.values, Values::Range { .. }));
        if query.scenes.is_empty() {
            query.scenes.push(Scene::default());
        }
        Ok(query)
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
}

fn tokens(text: &str) -> Evaluated<Vec<Token>> {
    let mut all = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let length = if first.is_ascii_digit() {
            let length = number_length(rest);
            let number = rest[..length].parse();
            all.push(Token::Number(
                number.map_err(|error| format!("`{}`: {error}", &rest[..length]))?,
            ));
            length
        } else if first.is_alphabetic() {
            let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_'));
            let word = &rest[..end.unwrap_or(rest.len())];
            all.push(Token::Word(word.to_owned()));
            word.len()
        } else if first == '\'' {
            let inner = rest[1..].split('\'').next().unwrap_or_default();
            all.push(Token::Text(inner.to_owned()));
            inner.len() + 2
        } else if let Some(symbol) = SYMBOLS.iter().find(|symbol| rest.starts_with(**symbol)) {
            all.push(Token::Symbol(symbol));
            symbol.len()
        } else {
            return Err(format!("`{text}`: `{first}` means nothing here"));
        };
        rest = rest.get(length..).unwrap_or_default().trim_start();
    }
    Ok(all)
}

/// How long the number is that a text begins with; two dots end it.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|it| it.is_ascii_digit()).count();
    let mut end = digits(0);
    if bytes.get(end) == Some(&b'.') && bytes.get(end + 1).is_some_and(u8::is_ascii_digit) {
        end += 1 + digits(end + 1);
    }
    if bytes.get(end) == Some(&b'e') {
        let sign = usize::from(bytes.get(end + 1) == Some(&b'-'));
        end += 1 + sign + digits(end + 1 + sign);
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_end_before_the_dots_of_a_range() {
        let found = tokens("0..7.5e6:26 -1e-3").unwrap();
        let expected = [
            Token::Number(0.0),
            Token::Symbol(".."),
            Token::Number(7.5e6),
            Token::Symbol(":"),
            Token::Number(26.0),
            Token::Symbol("-"),
            Token::Number(1e-3),
        ];
        assert_eq!(found, expected);
        assert!(tokens("1 ? 2").is_err());
    }
}
