//! Gauss-Legendre quadrature.

/// Nodes on (0, 1) and weights of the ten-point rule, exact for polynomials of degree 19
/// (Abramowitz and Stegun, Table 25.4, n = 10, mapped from (-1, 1)).
pub const GAUSS_10: [(f64, f64); 10] = gauss_10();

const fn gauss_10() -> [(f64, f64); 10] {
    const HALF: [(f64, f64); 5] = [
        (0.148_874_338_981_631_21, 0.295_524_224_714_752_87),
        (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
        (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
        (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
        (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
    ];
    let mut rule = [(0.0, 0.0); 10];
    let mut i = 0;
    while i < 5 {
        let (x, w) = HALF[i];
        rule[5 + i] = (0.5 + 0.5 * x, 0.5 * w);
        rule[4 - i] = (0.5 - 0.5 * x, 0.5 * w);
        i += 1;
    }
    rule
}

/// The integral of `f` from `a` to `b` with the ten-point rule on each of `panels` equal parts.
pub fn gauss(a: f64, b: f64, panels: usize, mut f: impl FnMut(f64) -> f64) -> f64 {
    let width = (b - a) / panels as f64;
    let mut sum = 0.0;
    for panel in 0..panels {
        let left = a + width * panel as f64;
        for (node, weight) in GAUSS_10 {
            sum += weight * f(left + width * node);
        }
    }
    sum * width
}

#[cfg(test)]
mod tests {
    use super::gauss;

    #[test]
    fn exact_for_polynomials_up_to_degree_19() {
        for degree in 0..20 {
            let integral = gauss(0.0, 2.0, 1, |x| x.powi(degree));
            let exact = 2f64.powi(degree + 1) / f64::from(degree + 1);
            assert!((integral / exact - 1.0).abs() < 2e-15, "degree {degree}: {integral}");
        }
    }

    #[test]
    fn panels_converge_on_a_smooth_function() {
        assert!((gauss(0.0, 3.0, 3, f64::exp) - 3f64.exp_m1()).abs() < 1e-14);
    }
}
