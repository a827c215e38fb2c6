//! Strength of a hardening metal: hardening exponent, flow stress, and the pressure that opens a hole.
//!
//! Stress over strain is `sigma = Y (E eps/Y)^n` beyond the yield stress Y, E the modulus of elasticity. Sources: A. Considère (1885);
//! V. K. Luk and M. J. Forrestal, *Int. J. Impact Engng* 6 (1987) 291-301; M. J. Forrestal and T. L. Warren, *Int. J. Impact Engng* 36
//! (2009) 220-225.

use std::f64::consts::E;

use crate::numerics::quadrature::gauss;
use crate::numerics::root::bracketed_root;

/// Square root of 3: shear stress over tensile stress in plane strain.
const ROOT_3: f64 = 1.732_050_807_568_877_2;
/// Upper bound in the search for the hardening exponent; metals have less than 0.6.
const EXPONENT_MAX: f64 = 2.0;
/// Upper limit of the hole-growth integral; the neglected part is below exp(-50).
const FAR: f64 = 50.0;
/// Panels of the quadrature on each side of a strain of order 1; converged, since twice as many give the same result.
const PANELS: usize = 5;

/// Computes the hardening exponent n of a metal with the yield stress Y and the engineering tensile strength U, Pa; 0 for U <= Y or without
/// U.
///
/// The load of a bar, `sigma exp(-eps)`, has its maximum at eps = n (Considère). Hence U = Y (E n/(e Y))^n, whose larger root lies between
/// e Y/E and 2.
pub fn hardening_exponent(yield_pa: f64, tensile_pa: Option<f64>, modulus_pa: f64) -> f64 {
    let Some(tensile_pa) = tensile_pa.filter(|tensile_pa| *tensile_pa > yield_pa) else {
        return 0.0;
    };
    let (scale, rise) = (modulus_pa / (E * yield_pa), (tensile_pa / yield_pa).ln());
    bracketed_root(1.0 / scale, EXPONENT_MAX, |n| n * (scale * n).ln() - rise)
}

/// Returns the flow stress at a strain of 1, Y (E/Y)^n, Pa.
pub fn flow_stress_pa(yield_pa: f64, modulus_pa: f64, exponent: f64) -> f64 {
    yield_pa * (modulus_pa / yield_pa).powf(exponent)
}

/// Computes the pressure S that opens a cylindrical cavity from zero radius in an incompressible metal, Pa; E > 3^(1/2) Y.
///
/// Matter at the radius r around a cavity of radius a has the strain t/3^(1/2) with exp(-t) = 1 - a²/r². Equilibrium is
/// `d sigma_r` = (2/3^(1/2)) sigma dr/r and -2 dr/r = dt/(exp(t) - 1). The elastic region outside carries Y/3^(1/2) and begins at
/// a²/r² = 3^(1/2) Y/E. So S = Y/3^(1/2) [1 + (E/(3^(1/2) Y))^n I] with I the integral of t^n/(exp(t) - 1) from -ln(1 - 3^(1/2) Y/E)
/// on. For n = 0 it is ln(E/(3^(1/2) Y)).
pub fn hole_growth_pa(yield_pa: f64, modulus_pa: f64, exponent: f64) -> f64 {
    let scale = modulus_pa / (ROOT_3 * yield_pa);
    let integral = if exponent == 0.0 {
        scale.ln()
    } else {
        let from = -(-1.0 / scale).ln_1p();
        // Integrate over ln t, in which the integrand is smooth down to the small lower limit.
        let by_logarithm = |y: f64| ((exponent + 1.0) * y).exp() / y.exp().exp_m1();
        gauss(from.ln(), 0.0, PANELS, by_logarithm) + gauss(0.0, FAR.ln(), PANELS, by_logarithm)
    };
    yield_pa / ROOT_3 * (1.0 + scale.powf(exponent) * integral)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reference: root by Brent's method and integral by adaptive quadrature in an independent program.
    #[test]
    fn valid_hardening_and_hole_growth_of_two_alloys() {
        for (y, u, e, n, s_mpa, sigma_mpa) in [
            (276e6, 310e6, 68.3e9, 0.065_218_803_285, 1_103.065_098_444, 395.376_675_796),
            (254e6, 365e6, 70.9e9, 0.137_095_065_812, 1_251.674_628_829, 549.721_274_628),
            (1350e6, 1640e6, 207e9, 0.107_799_260_651, 5_366.407_403_343, 2_322.436_110_613),
        ] {
            let found = hardening_exponent(y, Some(u), e);
            assert!((found - n).abs() < 1e-11, "{found}");
            let near = |a: f64, mpa: f64| (1e-6 * a / mpa - 1.0).abs() < 1e-11;
            assert!(near(hole_growth_pa(y, e, found), s_mpa), "{}", hole_growth_pa(y, e, found));
            assert!(near(flow_stress_pa(y, e, found), sigma_mpa));
            // Considère: the load of the bar has its maximum at eps = n, and the tensile strength is that load.
            let load = |eps: f64| y * (e * eps / y).powf(found) * (-eps).exp();
            assert!((load(found) / u - 1.0).abs() < 1e-13);
            assert!(load(0.99 * found) < u && load(1.01 * found) < u);
        }
    }

    /// For n = 1 the integral is the Debye integral: pi²/6 less a (1 - a/4 + a²/36).
    #[test]
    fn valid_hole_growth_has_its_limits() {
        let (y, e) = (276e6, 68.3e9);
        for tensile in [None, Some(276e6), Some(100e6)] {
            assert_eq!(hardening_exponent(y, tensile, e).to_bits(), 0);
        }
        let perfect = y / 3f64.sqrt() * (1.0 + (e / (3f64.sqrt() * y)).ln());
        assert!((hole_growth_pa(y, e, 0.0) / perfect - 1.0).abs() < 1e-15);
        assert!((hole_growth_pa(y, e, 1e-12) / perfect - 1.0).abs() < 1e-10);
        let scale = e / (3f64.sqrt() * y);
        let a = -(1.0 - 1.0 / scale).ln();
        let debye = std::f64::consts::PI.powi(2) / 6.0 - a * (1.0 - a / 4.0 + a * a / 36.0);
        let linear = y / 3f64.sqrt() * (1.0 + scale * debye);
        assert!((hole_growth_pa(y, e, 1.0) / linear - 1.0).abs() < 1e-12);
    }
}
