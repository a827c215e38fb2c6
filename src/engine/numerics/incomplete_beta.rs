//! Incomplete beta function.

/// Maximum number of terms of the series. At 1/2 each is about half of the one before.
const TERMS: i32 = 56;
/// Term, relative to the sum, below which the series ends.
const NEGLIGIBLE: f64 = 1e-17;

/// Returns the integral of t^(a-1) (1-t)^(b-1) from 0 to z, by its series from the nearer end. `rest` is 1 - z, without cancellation.
pub(crate) fn incomplete_beta([z, rest]: [f64; 2], [a, b]: [f64; 2]) -> f64 {
    if z <= rest {
        return near_zero(z, a, b);
    }
    near_zero(0.5, a, b) + near_zero(0.5, b, a) - near_zero(rest, b, a)
}

/// Returns the integral for z up to 1/2, from the expansion of (1-t)^(b-1) in powers of t.
fn near_zero(z: f64, a: f64, b: f64) -> f64 {
    let (mut factor, mut sum) = (z.powf(a), 0.0);
    for j in (0..TERMS).map(f64::from) {
        sum += factor / (a + j);
        factor *= z * (1.0 - b + j) / (j + 1.0);
        if factor < NEGLIGIBLE * sum {
            break;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// B(z; 1/2, 1/2) = 2 asin(z^(1/2)); B(z; a, 1) = z^a/a; B(z; 1, b) = (1 - (1-z)^b)/b.
    #[test]
    fn valid_the_integral_equals_its_closed_forms() {
        for z in [0.0, 1e-9, 0.2, 0.5, 0.7, 1.0 - 1e-9, 1.0f64] {
            let at = |a: f64, b: f64| incomplete_beta([z, 1.0 - z], [a, b]);
            assert!((at(0.5, 0.5) - 2.0 * z.sqrt().atan2((1.0 - z).sqrt())).abs() < 4e-15, "{z}");
            assert!((at(0.7, 1.0) - z.powf(0.7) / 0.7).abs() < 4e-15, "{z}");
            assert!((at(1.0, 0.3) - (1.0 - (1.0 - z).powf(0.3)) / 0.3).abs() < 8e-15, "{z}");
        }
    }
}
