//! The values of a claim's expressions, and arithmetic that goes through lists.

pub(super) type Point = (f64, f64);

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// A number; NaN where a quantity does not exist.
    Number(f64),
    Truth(bool),
    Text(String),
    List(Vec<Self>),
    /// A quantity along a variable.
    Curve(Curve),
}

/// A quantity along a variable: the points where it has a finite value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Curve {
    /// The points in the order of the variable.
    pub points: Vec<Point>,
    /// The symbol of the variable.
    pub along: &'static str,
    /// The unit of the quantity.
    pub unit: &'static str,
    /// How its scene differs from the usual one, in words.
    pub changes: String,
}

impl Value {
    pub(super) fn numbers(values: impl IntoIterator<Item = f64>) -> Self {
        Self::List(values.into_iter().map(Self::Number).collect())
    }

    /// Values in one list, those of lists among them included.
    pub(super) fn flat(values: Vec<Self>) -> Self {
        Self::List(
            values
                .into_iter()
                .flat_map(|it| if let Self::List(own) = it { own } else { vec![it] })
                .collect(),
        )
    }

    pub(super) fn number(&self) -> Result<f64, String> {
        match self {
            Self::Number(number) => Ok(*number),
            Self::Truth(truth) => Ok(f64::from(u8::from(*truth))),
            Self::Text(_) | Self::List(_) | Self::Curve(_) => {
                Err(format!("a number is expected, not {self:?}"))
            }
        }
    }

    /// Whether it holds; a list does where all of it does.
    pub(super) fn holds(&self) -> Result<bool, String> {
        match self {
            Self::Truth(truth) => Ok(*truth),
            Self::List(list) => list.iter().try_fold(true, |all, value| Ok(value.holds()? && all)),
            Self::Number(_) | Self::Text(_) | Self::Curve(_) => {
                Err(format!("a condition is expected, not {self:?}"))
            }
        }
    }

    /// Its points: those of a curve, or the values of a list over their positions.
    pub(super) fn points(&self) -> Result<Vec<Point>, String> {
        match self {
            Self::Curve(curve) => Ok(curve.points.clone()),
            Self::List(list) => {
                let point = |(at, value): (usize, &Self)| Ok((at as f64, value.number()?));
                list.iter().enumerate().map(point).collect()
            }
            Self::Number(_) | Self::Truth(_) | Self::Text(_) => {
                Err(format!("a curve or a list is expected, not {self:?}"))
            }
        }
    }

    /// One of a list, counted from 0.
    pub(super) fn item(self, at: usize) -> Result<Self, String> {
        match self {
            Self::List(list) => {
                list.into_iter().nth(at).ok_or_else(|| format!("there is no value [{at}]"))
            }
            other => Err(format!("a list is expected, not {other:?}")),
        }
    }

    /// Whether it is a list of curves or of lists.
    pub(super) fn is_nested(&self) -> bool {
        let is_series = |it: &Self| matches!(it, Self::Curve(_) | Self::List(_));
        matches!(self, Self::List(list) if list.iter().any(is_series))
    }

    /// The contrary, through lists.
    pub(super) fn not(self) -> Result<Self, String> {
        match self {
            Self::List(list) => {
                Ok(Self::List(list.into_iter().map(Self::not).collect::<Result<_, _>>()?))
            }
            other => Ok(Self::Truth(!other.holds()?)),
        }
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<Option<f64>> for Value {
    fn from(number: Option<f64>) -> Self {
        Self::Number(number.unwrap_or(f64::NAN))
    }
}

impl From<bool> for Value {
    fn from(truth: bool) -> Self {
        Self::Truth(truth)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

/// Calls a function for each place of the lists among its arguments, which are of one length; the others go with every place.
pub(super) fn through_lists(
    arguments: &[Value],
    each: &dyn Fn(&[Value]) -> Result<Value, String>,
) -> Result<Value, String> {
    let length = arguments.iter().find_map(|it| match it {
        Value::List(list) => Some(list.len()),
        Value::Number(_) | Value::Truth(_) | Value::Text(_) | Value::Curve(_) => None,
    });
    let Some(length) = length else { return each(arguments) };
    let place = |at: usize| {
        let own = arguments.iter().map(|argument| match argument {
            Value::List(list) => list
                .get(at)
                .cloned()
                .ok_or_else(|| format!("lists of {length} and of {} values", list.len())),
            other => Ok(other.clone()),
        });
        through_lists(&own.collect::<Result<Vec<_>, _>>()?, each)
    };
    Ok(Value::List((0..length).map(place).collect::<Result<_, _>>()?))
}

/// Two values joined by an operator, place by place of lists.
pub(super) fn join(operator: &str, left: Value, right: Value) -> Result<Value, String> {
    through_lists(&[left, right], &|pair| match (operator, pair) {
        ("or", [left, right]) => Ok(Value::Truth(left.holds()? || right.holds()?)),
        ("and", [left, right]) => Ok(Value::Truth(left.holds()? && right.holds()?)),
        ("==", [Value::Text(left), Value::Text(right)]) => Ok(Value::Truth(left == right)),
        ("!=", [Value::Text(left), Value::Text(right)]) => Ok(Value::Truth(left != right)),
        (_, [left, right]) => calculate(operator, left.number()?, right.number()?),
        (_, _) => Err("an operator has two operands".to_owned()),
    })
}

#[expect(
    clippy::float_cmp,
    reason = "claims compare whole numbers and a value with the greatest of its list"
)]
fn calculate(operator: &str, left: f64, right: f64) -> Result<Value, String> {
    Ok(match operator {
        "+" => (left + right).into(),
        "-" => (left - right).into(),
        "*" => (left * right).into(),
        "/" => (left / right).into(),
        "^" => left.powf(right).into(),
        "<" => (left < right).into(),
        "<=" => (left <= right).into(),
        ">" => (left > right).into(),
        ">=" => (left >= right).into(),
        "==" => (left == right).into(),
        "!=" => (left != right).into(),
        other => return Err(format!("`{other}` is no operator")),
    })
}
