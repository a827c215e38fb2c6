//! The contact force, one Taylor coefficient at a time.

use super::contact_force::{ElasticForce, Pressure, Pulse};
use crate::model::contact::{NoseGeometry, Section};
use crate::numerics::series::{product, quotient, square, square_root};

/// A contact force whose coefficients are requested in order, 0 first.
pub(super) trait ContactTerm<const N: usize> {
    /// Coefficient j of the force, given the coefficients of travel and slip up to j.
    fn coefficient(&mut self, travel: &[f64; N], slip: &[f64; N], j: usize) -> f64;
}

pub(super) struct NoContact;

impl<const N: usize> ContactTerm<N> for NoContact {
    #[inline]
    fn coefficient(&mut self, _: &[f64; N], _: &[f64; N], _: usize) -> f64 {
        0.0
    }
}

impl<const N: usize> ContactTerm<N> for ElasticForce {
    fn coefficient(&mut self, travel: &[f64; N], slip: &[f64; N], j: usize) -> f64 {
        let pressed = if j == 0 { travel[0] - self.slack_m } else { travel[j] };
        self.stiffness_n_m * pressed + self.damping_n_s_m * slip[j]
    }
}

/// A half-sine from a moment on.
pub(super) struct Phase {
    pub(super) pulse: Pulse,
    pub(super) t_s: f64,
    pub(super) unit_s: f64,
}

impl<const N: usize> ContactTerm<N> for Phase {
    fn coefficient(&mut self, _: &[f64; N], _: &[f64; N], j: usize) -> f64 {
        let rate = std::f64::consts::PI / self.pulse.duration_s;
        let (sin, cos) = (rate * self.t_s).sin_cos();
        // sin(z + h) has the derivatives sin z, cos z, -sin z, -cos z.
        let derivative = [sin, cos, -sin, -cos][j % 4];
        let scale = (1..=j).fold(self.pulse.amplitude_n, |c, i| c * rate * self.unit_s / i as f64);
        scale * derivative
    }
}

/// Coefficient j of S + c u².
#[inline]
fn pressure<const N: usize>(slip: &[f64; N], pressure: Pressure, j: usize) -> f64 {
    let drag = pressure.drag_kg_m3 * square(slip, j);
    if j == 0 { pressure.strength_pa + drag } else { drag }
}

/// An area that is a quadratic in travel.
pub(super) struct Quadratic<const N: usize> {
    origin_m: f64,
    a: [f64; 3],
    law: Pressure,
    /// Travel from the origin.
    offset: [f64; N],
    area: [f64; N],
    pressure: [f64; N],
}

impl<const N: usize> Quadratic<N> {
    pub(super) fn new(origin_m: f64, a: [f64; 3], law: Pressure) -> Self {
        Self { origin_m, a, law, offset: [0.0; N], area: [0.0; N], pressure: [0.0; N] }
    }
}

impl<const N: usize> ContactTerm<N> for Quadratic<N> {
    #[inline]
    fn coefficient(&mut self, travel: &[f64; N], slip: &[f64; N], j: usize) -> f64 {
        self.offset[j] = if j == 0 { travel[0] - self.origin_m } else { travel[j] };
        let constant = if j == 0 { self.a[0] } else { 0.0 };
        self.area[j] = constant + self.a[1] * self.offset[j] + self.a[2] * square(&self.offset, j);
        self.pressure[j] = pressure(slip, self.law, j);
        product(&self.area, &self.pressure, j)
    }
}

/// Oblique: entry section less exit section, at least one of them across sphere and cylinder.
pub(super) struct Partial<const N: usize> {
    /// Depth per travel.
    rate: f64,
    law: Pressure,
    entry: Face<N>,
    exit: Face<N>,
    area: [f64; N],
    pressure: [f64; N],
}

impl<const N: usize> Partial<N> {
    pub(super) fn new(
        nose: NoseGeometry,
        depth_m: f64,
        rate: f64,
        exit_depth_m: f64,
        law: Pressure,
    ) -> Self {
        Self {
            rate,
            law,
            entry: Face::new(nose, depth_m),
            exit: Face::new(nose, depth_m - exit_depth_m),
            area: [0.0; N],
            pressure: [0.0; N],
        }
    }
}

impl<const N: usize> ContactTerm<N> for Partial<N> {
    #[inline]
    fn coefficient(&mut self, travel: &[f64; N], slip: &[f64; N], j: usize) -> f64 {
        let step = if j == 0 { 0.0 } else { self.rate * travel[j] };
        self.area[j] = self.entry.area(step, j) - self.exit.area(step, j);
        self.pressure[j] = pressure(slip, self.law, j);
        product(&self.area, &self.pressure, j)
    }
}

/// One face's section as a series. With kappa = 1 - p cos/R, r = sqrt(sin² - kappa²) and phi the fullness,
/// dA = -2 R² (kappa cos phi + r) dkappa and dphi = cos dkappa / ((1 - kappa²) r).
struct Face<const N: usize> {
    nose: NoseGeometry,
    section: Section,
    start_m: f64,
    kappa: [f64; N],
    kappa_slope: [f64; N],
    /// sin² - kappa².
    chord_squared: [f64; N],
    chord: [f64; N],
    /// 1 - kappa².
    rest: [f64; N],
    /// rest · chord.
    weight: [f64; N],
    phi: [f64; N],
    phi_slope: [f64; N],
    /// kappa cos phi + r.
    width: [f64; N],
}

impl<const N: usize> Face<N> {
    fn new(nose: NoseGeometry, start_m: f64) -> Self {
        let zero = [0.0; N];
        Self {
            nose,
            section: nose.section(start_m),
            start_m,
            kappa: zero,
            kappa_slope: zero,
            chord_squared: zero,
            chord: zero,
            rest: zero,
            weight: zero,
            phi: zero,
            phi_slope: zero,
            width: zero,
        }
    }

    /// Coefficient j of the area; `step_m` is coefficient j >= 1 of the depth.
    fn area(&mut self, step_m: f64, j: usize) -> f64 {
        let NoseGeometry { radius_m: r, sin, cos } = self.nose;
        let full = 2.0 * r * r;
        match self.section {
            Section::Full if j == 0 => self.nose.area_m2(self.start_m),
            Section::None | Section::Full => 0.0,
            Section::Cap => {
                // pi R² cos (1 - kappa²)
                self.kappa[j] =
                    if j == 0 { 1.0 - self.start_m * cos / r } else { -step_m * cos / r };
                let squared = square(&self.kappa, j);
                let rest = if j == 0 { 1.0 - squared } else { -squared };
                std::f64::consts::PI * r * r * cos * rest
            }
            Section::Partial => {
                if j == 0 {
                    self.kappa[0] = 1.0 - self.start_m * cos / r;
                    self.phi[0] = self.nose.fullness(self.kappa[0]);
                } else {
                    self.kappa[j] = -step_m * cos / r;
                    let i = j - 1;
                    self.kappa_slope[i] = j as f64 * self.kappa[j];
                    self.phi_slope[i] =
                        quotient(&self.kappa_slope, &self.weight, &self.phi_slope, i);
                    self.phi[j] = cos * self.phi_slope[i] / j as f64;
                }
                let squared = square(&self.kappa, j);
                let lead = if j == 0 { 1.0 } else { 0.0 };
                self.chord_squared[j] = lead * sin * sin - squared;
                self.rest[j] = lead - squared;
                self.chord[j] = square_root(&self.chord_squared, &self.chord, j);
                self.weight[j] = product(&self.rest, &self.chord, j);
                self.width[j] = cos * product(&self.kappa, &self.phi, j) + self.chord[j];
                if j == 0 {
                    self.nose.area_m2(self.start_m)
                } else {
                    -full * product(&self.width, &self.kappa_slope, j - 1) / j as f64
                }
            }
        }
    }
}
