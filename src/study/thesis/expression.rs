//! The expressions of the claims: numbers, lists, texts, arithmetic, conditions, functions, and quantities of scenes.
//!
//! Parsed when the claims are read, with all names resolved: a wrong one is refused then, not when a claim is checked.

use std::collections::BTreeMap;

use crate::model::scene::Scene;
use crate::model::variables::{self, Variable};
use crate::study::thesis::functions::{FUNCTIONS, Function};
use crate::study::thesis::quantities::Quantity;
use crate::study::thesis::runs::Method;

pub(super) enum Expression {
    Number(f64),
    Text(String),
    /// A value of the claim.
    Name(String),
    List(Vec<Self>),
    /// One of a list.
    Item(Box<Self>, usize),
    /// The contrary of a condition.
    Not(Box<Self>),
    /// Two operands.
    Binary(Operator, Box<[Self; 2]>),
    Call(&'static Function, Vec<Self>),
    /// A value by a certain method.
    By(Method, Box<Self>),
    /// A quantity of one or more scenes.
    Query(Query),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operator {
    Or,
    And,
    Equal,
    Unequal,
    Less,
    AtMost,
    Greater,
    AtLeast,
    Plus,
    Minus,
    Times,
    Over,
    Power,
}

/// A quantity of scenes with some variables changed.
pub(super) struct Query {
    /// Which quantity.
    pub quantity: Quantity,
    /// Of which scenes; one at least.
    pub scenes: Vec<Scene>,
    /// What is changed in them, in order.
    pub settings: Vec<Setting>,
}

/// A variable that is changed.
pub(super) struct Setting {
    /// Which; `None` is the displacement that some quantities depend on.
    pub variable: Option<&'static Variable>,
    /// Its values.
    pub values: Values,
}

/// The values of a variable.
pub(super) enum Values {
    /// One, or a list.
    Of(Expression),
    /// Equally spaced ones: a curve.
    Range([Expression; 2], usize),
}

/// What binds weakest comes first.
const LEVELS: [&[(&str, Operator)]; 5] = [
    &[("or", Operator::Or)],
    &[("and", Operator::And)],
    &[
        ("==", Operator::Equal),
        ("!=", Operator::Unequal),
        ("<=", Operator::AtMost),
        (">=", Operator::AtLeast),
        ("<", Operator::Less),
        (">", Operator::Greater),
    ],
    &[("+", Operator::Plus), ("-", Operator::Minus)],
    &[("*", Operator::Times), ("/", Operator::Over)],
];

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

/// Reads expressions of one claim and notes which of its values they name.
pub(super) struct Parser<'a> {
    scenes: &'a BTreeMap<String, Scene>,
    tokens: Vec<Token>,
    at: usize,
    /// The names of values met so far.
    pub names: Vec<String>,
}

type Parsed<T = Expression> = Result<T, String>;

impl<'a> Parser<'a> {
    pub(super) fn new(scenes: &'a BTreeMap<String, Scene>) -> Self {
        Self { scenes, tokens: Vec::new(), at: 0, names: Vec::new() }
    }

    pub(super) fn parse(&mut self, text: &str) -> Parsed {
        (self.tokens, self.at) = (tokens(text)?, 0);
        let expression = self.level(0)?;
        match self.tokens.get(self.at) {
            None => Ok(expression),
            Some(token) => Err(format!("`{text}`: {token:?} is not expected after an expression")),
        }
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

    fn expect(&mut self, symbol: &str) -> Parsed<()> {
        if self.take(symbol) {
            return Ok(());
        }
        let found = self.tokens.get(self.at);
        Err(found.map_or_else(
            || format!("`{symbol}` is missing at the end"),
            |token| format!("`{symbol}` is expected before {token:?}"),
        ))
    }

    fn level(&mut self, level: usize) -> Parsed {
        let Some(operators) = LEVELS.get(level) else { return self.power() };
        if level == COMPARISONS && self.take("not") {
            return Ok(Expression::Not(Box::new(self.level(level)?)));
        }
        let mut left = self.level(level + 1)?;
        while let Some((_, operator)) = operators.iter().find(|(symbol, _)| self.take(symbol)) {
            left = Expression::Binary(*operator, Box::new([left, self.level(level + 1)?]));
        }
        Ok(left)
    }

    fn power(&mut self) -> Parsed {
        if self.take("-") {
            let operands = [Expression::Number(-1.0), self.power()?];
            return Ok(Expression::Binary(Operator::Times, Box::new(operands)));
        }
        let mut base = self.atom()?;
        while self.take("[") {
            base = Expression::Item(Box::new(base), self.whole_number()?);
            self.expect("]")?;
        }
        if !self.take("^") {
            return Ok(base);
        }
        Ok(Expression::Binary(Operator::Power, Box::new([base, self.power()?])))
    }

    fn whole_number(&mut self) -> Parsed<usize> {
        let next = self.tokens.get(self.at).cloned();
        self.at += 1;
        match next {
            Some(Token::Number(number)) => number.to_string().parse().ok(),
            Some(Token::Word(_) | Token::Text(_) | Token::Symbol(_)) | None => None,
        }
        .ok_or_else(|| format!("a whole number is expected, not {next:?}"))
    }

    fn atom(&mut self) -> Parsed {
        let Some(token) = self.tokens.get(self.at).cloned() else {
            return Err("a value is missing at the end".to_owned());
        };
        self.at += 1;
        match token {
            Token::Number(number) => Ok(Expression::Number(number)),
            Token::Text(text) => Ok(Expression::Text(text)),
            Token::Symbol("(") => {
                let inner = self.level(0)?;
                self.expect(")")?;
                Ok(inner)
            }
            Token::Symbol("[") => Ok(Expression::List(self.until("]", |own| own.level(0))?)),
            Token::Symbol(symbol) => Err(format!("`{symbol}` is not the beginning of a value")),
            Token::Word(name) if self.take("(") => self.call(&name),
            Token::Word(name) if name == "pi" => Ok(Expression::Number(std::f64::consts::PI)),
            Token::Word(name) => {
                self.names.push(name.clone());
                Ok(Expression::Name(name))
            }
        }
    }

    /// What stands between commas up to a closing symbol.
    fn until<T>(
        &mut self,
        end: &str,
        mut each: impl FnMut(&mut Self) -> Parsed<T>,
    ) -> Parsed<Vec<T>> {
        let mut all = Vec::new();
        while !self.take(end) {
            if !all.is_empty() {
                self.expect(",")?;
            }
            all.push(each(self)?);
        }
        Ok(all)
    }

    fn call(&mut self, name: &str) -> Parsed {
        let method = match name {
            "sound" => Some(Method::Sound),
            "printed" => Some(Method::Printed),
            _ => None,
        };
        if let Some(method) = method {
            let inner = self.level(0)?;
            self.expect(")")?;
            return Ok(Expression::By(method, Box::new(inner)));
        }
        if let Some(quantity) = Quantity::find(name) {
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
        Ok(Expression::Call(function, arguments))
    }

    fn query(&mut self, own_name: &str, quantity: Quantity) -> Parsed {
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
            let Some(scene) = own.scenes.get(&name) else {
                let known: Vec<&str> = own.scenes.keys().map(String::as_str).collect();
                return Err(format!("`{name}` is no scene: take one of {}", known.join(", ")));
            };
            query.scenes.push(scene.clone());
            Ok(())
        })?;
        query.settings.sort_by_key(|it| matches!(it.values, Values::Range(..)));
        if query.scenes.is_empty() {
            query.scenes.push(Scene::default());
        }
        Ok(Expression::Query(query))
    }

    fn setting(&mut self, name: &str) -> Parsed<Setting> {
        let variable = match name {
            "x" => None,
            name => Some(variables::find(name).map_err(|error| error.to_string())?),
        };
        let first = self.level(COMPARISONS + 1)?;
        let values = if self.take("..") {
            let last = self.level(COMPARISONS + 1)?;
            self.expect(":")?;
            Values::Range([first, last], self.whole_number()?)
        } else {
            Values::Of(first)
        };
        Ok(Setting { variable, values })
    }
}

fn tokens(text: &str) -> Parsed<Vec<Token>> {
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

    #[test]
    fn names_of_values_are_noted() {
        let scenes = BTreeMap::new();
        let mut parser = Parser::new(&scenes);
        assert!(parser.parse("near(a, b[0], 1e-3) and not c > 2 * pi").is_ok());
        assert_eq!(parser.names, ["a", "b", "c"]);
        for wrong in ["", "1 2", "(1", "[1, 2", "depth(x=1..2)", "a[1.5]", "1 +"] {
            assert!(parser.parse(wrong).is_err(), "{wrong}");
        }
    }
}
