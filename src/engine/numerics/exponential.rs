//! Functions of the exponential and of the logarithm as closed forms need them: without cancellation near zero, and quick.

/// ln(1 + x) for x >= 0, to a few roundings: the logarithm of the rounded sum, scaled by what rounding did to x (Goldberg,
/// *What every computer scientist should know about floating-point arithmetic*, 1991, theorem 4). Half as long in coming as
/// `f64::ln_1p`.
#[inline]
pub(crate) fn ln_one_plus(x: f64) -> f64 {
    let sum = 1.0 + x;
    let taken = sum - 1.0;
    if taken == 0.0 || sum.is_infinite() { x } else { sum.ln() * (x / taken) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_logarithm_near_one_is_the_standard_librarys() {
        for x in [0.0, 1e-300, f64::INFINITY] {
            assert_eq!(ln_one_plus(x).to_bits(), x.to_bits());
        }
        assert!(ln_one_plus(f64::NAN).is_nan());
        for i in -1700..=3000 {
            let x = 10f64.powf(f64::from(i) / 100.0);
            let (found, exact) = (ln_one_plus(x), x.ln_1p());
            assert!((found / exact - 1.0).abs() < 5.0 * f64::EPSILON, "{x}: {found} {exact}");
        }
    }
}
