//! V50 from a person's own shots, by logistic regression: p(v) = 1/(1 + exp(-(v - V50)/scale)).
//!
//! Maximum likelihood where stopped and perforating velocities overlap. Where they do not, the likelihood has no maximum: then
//! Firth's penalty is used (D. Firth, Biometrika 80 (1993) 27-38), which keeps the estimate finite. The confidence interval is
//! that of the profile likelihood, which holds for few shots, too.

use crate::numerics::root;
use crate::study::limit::fit::ResidualLaw;

pub mod calibrate;

/// Half the 95 % quantile of the chi-squared distribution with one degree of freedom.
const DROP: f64 = 0.5 * 3.841_458_820_694_124;
/// The confidence that goes with it.
pub const CONFIDENCE: f64 = 0.95;
/// Maximum number of Newton steps of a fit, and the step below which it has converged, in standard deviations of the velocity.
const STEPS: usize = 200;
const CONVERGED: f64 = 1e-12;
/// How far beyond the velocities an end of the interval is looked for, in standard deviations of them.
const REACH: f64 = 1e3;
const SHOTS_MIN: usize = 3;

/// One shot of a test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredShot {
    /// Impact velocity, m/s.
    pub velocity_m_s: f64,
    /// Whether the projectile went through.
    pub perforated: bool,
    /// Its velocity behind the plate, m/s, where it was measured.
    pub residual_m_s: Option<f64>,
    /// The depth of a shot that was stopped, m, where it was measured.
    pub penetration_m: Option<f64>,
}

enumeration! {
    /// How the curve was fitted.
    pub enum Estimator in EstimatorRow {
        /// The words of pages and files.
        words: &'static str,
    }
    /// Maximum likelihood.
    MaximumLikelihood { words: "maximum likelihood" }
    /// Maximum of the likelihood with Firth's penalty: there is no zone of mixed results.
    Firth { words: "Firth's penalised likelihood" }
}

/// A fitted curve of perforation over velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Logistic {
    /// The velocity at which half of the shots perforate, m/s.
    pub v50_m_s: f64,
    /// The width of the curve, m/s: from 10 to 90 % it takes 2 ln 9 of it.
    pub scale_m_s: f64,
    /// The ends of the 95 % confidence interval of V50, m/s; `None` where the shots do not bound it.
    pub range_m_s: (Option<f64>, Option<f64>),
    /// How it was fitted.
    pub method: Estimator,
}

impl Logistic {
    /// The probability of perforation at a velocity.
    pub fn probability(&self, velocity_m_s: f64) -> f64 {
        1.0 / (1.0 + (-(velocity_m_s - self.v50_m_s) / self.scale_m_s).exp())
    }

    /// The velocity at which this many of the shots perforate, 0 < fraction < 1, m/s.
    pub fn quantile_m_s(&self, fraction: f64) -> f64 {
        self.v50_m_s + self.scale_m_s * (fraction / (1.0 - fraction)).ln()
    }
}

/// The result of a set of shots.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The shots, in the order of the file.
    pub shots: Vec<MeasuredShot>,
    /// The fastest that was stopped, m/s.
    pub highest_stopped_m_s: f64,
    /// The slowest that perforated, m/s.
    pub lowest_perforated_m_s: f64,
    /// Perforation over velocity.
    pub logistic: Logistic,
    /// Lambert and Jonas's law through the residual velocities, where there are enough.
    pub lambert_jonas: Option<ResidualLaw>,
}

impl Report {
    /// Whether some shots were stopped that were faster than some that perforated.
    pub fn has_mixed_results(&self) -> bool {
        self.highest_stopped_m_s > self.lowest_perforated_m_s
    }

    /// How many perforated.
    pub fn perforated(&self) -> usize {
        self.shots.iter().filter(|shot| shot.perforated).count()
    }

    /// The perforating shots with a residual velocity, (impact, residual), m/s.
    pub fn residuals(&self) -> Vec<(f64, f64)> {
        residuals(&self.shots)
    }
}

fn residuals(shots: &[MeasuredShot]) -> Vec<(f64, f64)> {
    let through = shots.iter().filter(|shot| shot.perforated);
    through.filter_map(|shot| Some((shot.velocity_m_s, shot.residual_m_s?))).collect()
}

/// Fit shots.
///
/// # Errors
/// In words, when they do not bracket a limit.
pub fn fit(shots: Vec<MeasuredShot>) -> Result<Report, String> {
    let count = shots.len();
    if count < SHOTS_MIN {
        return Err(format!(
            "{count} shots are too few for a fit: it takes {SHOTS_MIN} or more, some stopped and some perforated"
        ));
    }
    let of = |perforated: bool| {
        shots.iter().filter(move |it| it.perforated == perforated).map(|it| it.velocity_m_s)
    };
    let every = || shots.iter().map(|it| it.velocity_m_s);
    let (Some(highest_stopped_m_s), Some(lowest_perforated_m_s)) =
        (of(false).max_by(f64::total_cmp), of(true).min_by(f64::total_cmp))
    else {
        return Err(if shots[0].perforated {
            let slowest_m_s = every().min_by(f64::total_cmp).unwrap_or(0.0);
            format!(
                "all {count} shots perforated: the limit lies below {slowest_m_s} m/s; add slower shots that are stopped"
            )
        } else {
            let fastest_m_s = every().max_by(f64::total_cmp).unwrap_or(f64::INFINITY);
            format!(
                "all {count} shots were stopped: the limit lies above {fastest_m_s} m/s; add faster shots that perforate"
            )
        });
    };
    let method = if highest_stopped_m_s > lowest_perforated_m_s {
        Estimator::MaximumLikelihood
    } else {
        Estimator::Firth
    };
    let logistic = Regression::new(&shots, method).fit().ok_or(
        "perforation does not become more frequent with velocity: check the columns velocity_m_s and perforated (1 is through)",
    )?;
    let lambert_jonas = ResidualLaw::lambert_jonas(&residuals(&shots));
    Ok(Report { shots, highest_stopped_m_s, lowest_perforated_m_s, logistic, lambert_jonas })
}

/// A logistic regression on velocities in standard deviations from their mean.
struct Regression {
    /// (velocity, 1 where it perforated).
    points: Vec<(f64, f64)>,
    mean_m_s: f64,
    width_m_s: f64,
    method: Estimator,
}

/// Logarithm of the likelihood (penalised by Firth's method), its slope, and the information, at one place.
struct Likelihood {
    value: f64,
    slope: [f64; 2],
    /// Entries 11, 12 and 22.
    information: [f64; 3],
}

impl Regression {
    fn new(shots: &[MeasuredShot], method: Estimator) -> Self {
        let n = shots.len() as f64;
        let mean_m_s = shots.iter().map(|it| it.velocity_m_s).sum::<f64>() / n;
        let squares: f64 = shots.iter().map(|it| (it.velocity_m_s - mean_m_s).powi(2)).sum();
        let width_m_s = (squares / n).sqrt();
        let points = shots
            .iter()
            .map(|it| {
                ((it.velocity_m_s - mean_m_s) / width_m_s, f64::from(u8::from(it.perforated)))
            })
            .collect();
        Self { points, mean_m_s, width_m_s, method }
    }

    /// The fit; `None` where perforation does not rise with velocity, or all velocities are equal.
    fn fit(&self) -> Option<Logistic> {
        if self.width_m_s <= 0.0 {
            return None;
        }
        let [a, b] = self.maximum()?;
        let v50 = -a / b;
        if b <= 0.0 || !v50.is_finite() {
            return None;
        }
        let best = self.at(a, b).value;
        let end = |sign: f64| self.interval_end(v50, sign / b, best - DROP);
        let m_s = |x: f64| self.mean_m_s + self.width_m_s * x;
        let physical = |x: Option<f64>| x.map(m_s).filter(|v| *v > 0.0);
        Some(Logistic {
            v50_m_s: m_s(v50),
            scale_m_s: self.width_m_s / b,
            range_m_s: (physical(end(-1.0)), physical(end(1.0))),
            method: self.method,
        })
    }

    /// The likelihood for p = 1/(1 + exp(-(a + b x))).
    fn at(&self, a: f64, b: f64) -> Likelihood {
        let firth = self.method == Estimator::Firth;
        let mut value = 0.0;
        let mut information = [0.0; 3];
        let terms: Vec<(f64, f64, f64, f64)> = self
            .points
            .iter()
            .map(|(x, y)| {
                let z = a + b * x;
                let p = 1.0 / (1.0 + (-z).exp());
                let weight = p * (1.0 / (1.0 + z.exp()));
                // ln(1 + exp(..)) without overflow.
                let against = if *y > 0.5 { -z } else { z };
                value -= against.max(0.0) + (-against.abs()).exp().ln_1p();
                information[0] += weight;
                information[1] += weight * x;
                information[2] += weight * x * x;
                (*x, *y, p, weight)
            })
            .collect();
        let [i11, i12, i22] = information;
        let determinant = i11 * i22 - i12 * i12;
        if firth {
            value += 0.5 * determinant.ln();
        }
        let mut slope = [0.0; 2];
        for (x, y, p, weight) in terms {
            let leverage = if firth {
                weight * (i22 - 2.0 * i12 * x + i11 * x * x) / determinant
            } else {
                0.0
            };
            let pull = y - p + leverage * (0.5 - p);
            slope[0] += pull;
            slope[1] += pull * x;
        }
        Likelihood { value, slope, information }
    }

    /// Where the likelihood is greatest, by Newton's method with halved steps; `None` where it does not converge.
    fn maximum(&self) -> Option<[f64; 2]> {
        let (mut a, mut b) = (0.0, 0.0);
        let mut here = self.at(a, b);
        for _ in 0..STEPS {
            let [i11, i12, i22] = here.information;
            let determinant = i11 * i22 - i12 * i12;
            let da = (i22 * here.slope[0] - i12 * here.slope[1]) / determinant;
            let db = (i11 * here.slope[1] - i12 * here.slope[0]) / determinant;
            let mut part = 1.0;
            let next = loop {
                let next = self.at(a + part * da, b + part * db);
                // A value that falls by no more than rounding is the top.
                if next.value >= here.value - 1e-12 * here.value.abs() {
                    break next;
                }
                part *= 0.5;
                if part < 1e-10 {
                    return Some([a, b]);
                }
            };
            (a, b) = (a + part * da, b + part * db);
            here = next;
            if !(a.is_finite() && b.is_finite()) {
                return None;
            }
            if da.abs() + db.abs() < CONVERGED * (1.0 + a.abs() + b.abs()) {
                return Some([a, b]);
            }
        }
        Some([a, b])
    }

    /// The likelihood where V50 is at `x50` and the curve is as steep as suits the shots best, but does not fall.
    fn profile(&self, x50: f64) -> f64 {
        let rise = |b: f64| {
            let slope = self.at(-b * x50, b).slope;
            slope[1] - x50 * slope[0]
        };
        if rise(0.0) <= 0.0 {
            return self.at(0.0, 0.0).value;
        }
        let (mut low, mut high) = (0.0, 1.0);
        while rise(high) > 0.0 && high < 1e8 {
            (low, high) = (high, 2.0 * high);
        }
        let b = root::in_bracket(low, high, rise);
        self.at(-b * x50, b).value
    }

    /// The end of the confidence interval on one side of V50, `step` being the first way towards it; `None` where there is none.
    fn interval_end(&self, x50: f64, step: f64, level: f64) -> Option<f64> {
        let above = |x: f64| self.profile(x) - level;
        let (mut inside, mut step) = (x50, 0.25 * step);
        while step.abs() < REACH {
            let outside = x50 + step;
            if above(outside) < 0.0 {
                return Some(root::in_bracket(inside, outside, above));
            }
            inside = outside;
            step *= 2.0;
        }
        None
    }
}

#[cfg(test)]
mod tests;
