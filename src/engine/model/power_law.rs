//! Odd power law of springs and dampers: force, energy and their inverses.

/// Minimum exponent of a power law. For smaller exponents the force varies by a factor below 1000 over all floating-point numbers, and the
/// displacement of a force underflows.
pub(in crate::model) const MIN_EXPONENT: f64 = 0.01;

/// Odd power law: `coefficient |z|^exponent sgn(z)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// Coefficient, >= 0.
    pub coefficient: f64,
    /// Exponent, > 0.
    pub exponent: f64,
}

impl PowerLaw {
    /// Law without force.
    pub const NONE: Self = Self { coefficient: 0.0, exponent: 1.0 };

    /// Returns `true` for a law without force.
    pub fn is_absent(self) -> bool {
        self.coefficient == 0.0
    }

    /// Returns the law if `acts`, else a law without force and with the same exponent.
    #[must_use]
    pub fn only_if(self, acts: bool) -> Self {
        if acts { self } else { Self { coefficient: 0.0, ..self } }
    }

    /// Returns `true` if the derivative at zero is infinite.
    pub fn is_steep_at_zero(self) -> bool {
        !self.is_absent() && self.exponent < 1.0
    }

    /// Returns the velocity below which a damper with exponent < 1 is linearised, m/s, from a velocity that the plate can have; 0 for other
    /// laws.
    pub fn creep_m_s(self, plate_m_s: f64) -> f64 {
        if self.is_steep_at_zero() { 1e-13 * plate_m_s } else { 0.0 }
    }

    /// Returns `true` for a linear law or a law without force.
    pub fn is_linear(self) -> bool {
        self.is_absent() || matches!(self.exponent, 1.0)
    }

    /// Returns `true` if the law is analytic at zero (linear, cubic, ...).
    pub fn is_smooth_at_zero(self) -> bool {
        self.is_absent() || matches!(self.exponent, 1.0 | 3.0 | 5.0)
    }

    /// Returns `true` if the law of each side of zero is analytic, beyond zero as well: see [`force_on`](Self::force_on).
    pub fn is_smooth_on_each_side(self) -> bool {
        self.is_smooth_at_zero() || matches!(self.exponent, 2.0)
    }

    /// Returns the force at `z`, which can be infinite.
    pub fn force(self, z: f64) -> f64 {
        if self.is_absent() {
            0.0
        } else if self.is_linear() {
            self.coefficient * z
        } else {
            self.coefficient * power(z.abs(), self.exponent) * sign(z)
        }
    }

    /// Returns the force with the law of one side of zero, 1 or -1. A quadratic law is continued analytically beyond zero, other laws as
    /// odd functions.
    pub fn force_on(self, side: f64, z: f64) -> f64 {
        match self.exponent {
            2.0 => self.coefficient * z * z * side,
            3.0 => self.coefficient * z * z * z,
            _ => self.force(z),
        }
    }

    /// Returns the derivative of the force at `z`; infinite at zero for exponents below 1.
    pub fn tangent(self, z: f64) -> f64 {
        if self.is_linear() {
            return self.coefficient;
        }
        self.coefficient * self.exponent * power(z.abs(), self.exponent - 1.0)
    }

    /// Returns the integral of the force from 0 to `z`; for a spring the stored energy.
    pub fn integral(self, z: f64) -> f64 {
        if self.is_absent() {
            return 0.0;
        }
        self.coefficient / (self.exponent + 1.0) * power(z.abs(), self.exponent + 1.0)
    }

    /// Returns |z| for a given force; infinite for a law without force.
    pub fn at_force(self, force: f64) -> f64 {
        if self.is_absent() {
            return f64::INFINITY;
        }
        power(force.abs() / self.coefficient, 1.0 / self.exponent)
    }

    /// Returns |z| for a given integral; infinite for a law without force.
    pub fn at_integral(self, integral: f64) -> f64 {
        if self.is_absent() {
            return f64::INFINITY;
        }
        ((self.exponent + 1.0) * integral / self.coefficient).powf(1.0 / (self.exponent + 1.0))
    }
}

/// Returns a power of a number that is not negative; half powers by the square root, which takes a third of the time.
fn power(z: f64, exponent: f64) -> f64 {
    match exponent {
        0.5 => z.sqrt(),
        1.5 => z * z.sqrt(),
        2.0 => z * z,
        -0.5 => 1.0 / z.sqrt(),
        _ => z.powf(exponent),
    }
}

/// Returns the sign of a number; 0 for zero.
pub(in crate::model) fn sign(z: f64) -> f64 {
    if z == 0.0 { 0.0 } else { z.signum() }
}
