//! Steps that people read easily: 1, 2 or 5 times a power of ten, and exact powers of ten.

/// A step of 1, 2 or 5 times a power of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// 1, 2 or 5; where an axis needs it, 25.
    pub mantissa: u8,
    /// Power of ten.
    pub exponent: i32,
}

impl Step {
    /// The least step that is not below a positive width.
    pub fn at_least(width: f64) -> Self {
        let exponent = decade(width);
        let fraction = width / power(exponent);
        let (mantissa, exponent) = match fraction {
            f if f <= 1.0 => (1, exponent),
            f if f <= 2.0 => (2, exponent),
            f if f <= 5.0 => (5, exponent),
            _ => (1, exponent + 1),
        };
        Self { mantissa, exponent }
    }

    /// How long it is.
    pub fn size(self) -> f64 {
        f64::from(self.mantissa) * power(self.exponent)
    }

    /// The next longer step.
    #[must_use]
    pub fn next(self) -> Self {
        match self.mantissa {
            1 => Self { mantissa: 2, ..self },
            2 => Self { mantissa: 5, ..self },
            _ => Self { mantissa: 1, exponent: self.exponent + 1 },
        }
    }
}

/// The decimal exponent of a positive number, as its scientific notation has it: exact, where a logarithm might round.
pub fn decade(value: f64) -> i32 {
    let text = format!("{value:e}");
    let exponent = text.rsplit('e').next().and_then(|part| part.parse().ok());
    exponent.unwrap_or(0)
}

/// A power of ten, right to the last bit, which `powi` is not from 10^23 on.
pub fn power(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_the_least_of_their_kind_that_are_wide_enough() {
        let size = |width: f64| {
            let step = Step::at_least(width);
            (step.mantissa, step.exponent)
        };
        assert_eq!(size(1.0), (1, 0));
        assert_eq!(size(1.1), (2, 0));
        assert_eq!(size(0.03), (5, -2));
        assert_eq!(size(0.051), (1, -1));
        assert_eq!(size(7e22), (1, 23));
    }
}
