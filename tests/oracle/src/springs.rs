//! The force of every kind of spring, read off the README and its sources once more: one formula a kind, by itself.
//!
//! Tables follow Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5 (1984) 300) written as Hermite's basis. What a spring adds to the
//! plate's mass is here, too.

use cmra_engine::model::scene::{Beam, Combination, Mechanism, OwnMass, Scene, Spring, SpringKind};

/// gamma and `K_Theta` of Table 9.3, and the angle up to which the pseudo-rigid body is good, degrees.
const GAMMA: f64 = 0.85;
const K_THETA: f64 = 2.65;
const ANGLE_DEG: f64 = 64.3;

/// The law of all springs of a mechanism.
pub(crate) struct Law<'a> {
    mechanism: &'a Mechanism,
    table: Option<Table>,
}

impl<'a> Law<'a> {
    pub(crate) fn new(mechanism: &'a Mechanism) -> Self {
        let spring = &mechanism.spring;
        let is_table = spring.kind == SpringKind::Table;
        Self { mechanism, table: is_table.then(|| Table::new(&spring.table.points)) }
    }

    /// The force against a displacement of the plate that was so far out before, N.
    pub(crate) fn force_n(&self, x: f64, farthest_m: f64) -> f64 {
        let Mechanism { spring, second, combination, .. } = self.mechanism;
        let beside = match combination {
            Combination::Alone => 0.0,
            Combination::Parallel => {
                x.signum() * power(second.coefficient, second.exponent, x.abs())
            }
        };
        self.first_n(x) + crush_n(spring, x, farthest_m) + beside
    }

    /// Places where the law has a corner, m: a step is cut there.
    pub(crate) fn corners_m(&self) -> Vec<f64> {
        let mut found = vec![0.0];
        found.extend(corners(&self.mechanism.spring));
        found
    }

    /// The first spring alone, but for what it is crushed.
    fn first_n(&self, x: f64) -> f64 {
        let spring = &self.mechanism.spring;
        let side = if x < 0.0 { -1.0 } else { 1.0 };
        let z = x.abs();
        let single = match spring.kind {
            SpringKind::PowerLaw => side * power(spring.coefficient, spring.exponent, z),
            SpringKind::Normalised => {
                let law = spring.normalised;
                side * power(law.force_n, spring.exponent, z / law.displacement_m)
            }
            SpringKind::Cantilever => side * link_n(&spring.beam, spring.beam.length_m, z),
            // Two cantilevers of half the length, one behind the other, each with half the displacement; beyond the angle as one.
            SpringKind::FixedGuided => {
                side * link_n(&spring.beam, 0.5 * spring.beam.length_m, 0.5 * z)
            }
            SpringKind::Bistable => {
                let s = spring.bistable.second_m;
                let u = spring.bistable.unstable_m.unwrap_or(0.5 * s);
                let shape = |x: f64| x * (x - u) * (x - s);
                // Where the slope of the shape is zero first.
                let top = (u + s - ((u + s).powi(2) - 3.0 * u * s).sqrt()) / 3.0;
                spring.bistable.barrier_n * shape(x) / shape(top)
            }
            SpringKind::ConstantForce => {
                side * spring.constant.force_n * (z / spring.constant.rise_m).min(1.0)
            }
            SpringKind::Column => {
                let column = spring.column;
                let past = z - column.critical_n / column.stiffness_n_m;
                let part = (past / column.fall_m).clamp(0.0, 1.0);
                let way = part * part * (3.0 - 2.0 * part);
                side * if past < 0.0 {
                    column.stiffness_n_m * z
                } else {
                    column.critical_n + way * (column.plateau_n - column.critical_n)
                }
            }
            SpringKind::Helix => spring.helix.stiffness_n_m * x,
            // It has a memory.
            SpringKind::Crush => 0.0,
            SpringKind::Table => {
                self.table.as_ref().expect("a table spring has a table").force_n(x)
            }
        };
        spring.count * single
    }
}

/// An absorber pushes with the elastic force of what is left of its rise, at most with that at which it is crushed; flat, it is
/// as stiff again.
fn crush_n(spring: &Spring, x: f64, farthest_m: f64) -> f64 {
    if spring.kind != SpringKind::Crush {
        return 0.0;
    }
    let crush = spring.crush;
    let set_m = (farthest_m.min(crush.stroke_m) - crush.force_n / crush.stiffness_n_m).max(0.0);
    let rise = (crush.stiffness_n_m * (x - set_m)).clamp(0.0, crush.force_n);
    spring.count * (rise + crush.stiffness_n_m * (x - crush.stroke_m).max(0.0))
}

/// Corners of one spring's law besides zero.
fn corners(spring: &Spring) -> Vec<f64> {
    let ahead = match spring.kind {
        SpringKind::ConstantForce => vec![spring.constant.rise_m],
        SpringKind::Column => {
            let onset = spring.column.critical_n / spring.column.stiffness_n_m;
            vec![onset, onset + spring.column.fall_m]
        }
        SpringKind::Table => spring.table.points.iter().map(|point| point[0]).collect(),
        _ => Vec::new(),
    };
    ahead.iter().flat_map(|x| [-x, *x]).collect()
}

fn power(c: f64, exponent: f64, z: f64) -> f64 {
    if c == 0.0 { 0.0 } else { c * z.powf(exponent) }
}

/// P = K Theta/(gamma l cos Theta), x = gamma l sin Theta, on along the tangent beyond the angle.
fn link_n(beam: &Beam, length_m: f64, x: f64) -> f64 {
    let inertia = beam.width_m * beam.height_m.powi(3) / 12.0;
    let k = GAMMA * K_THETA * beam.modulus_pa * inertia / length_m;
    let reach = GAMMA * length_m;
    let last = ANGLE_DEG.to_radians();
    let angle = if x < reach * last.sin() { (x / reach).asin() } else { last };
    // dP/dTheta over dx/dTheta.
    let slope = k / reach * (1.0 + angle * angle.tan()) / angle.cos() / (reach * angle.cos());
    k * angle / (reach * angle.cos()) + slope * (x - reach * angle.sin())
}

/// Measured points with their slopes.
struct Table {
    points: Vec<[f64; 2]>,
    slopes: Vec<f64>,
    odd: bool,
}

impl Table {
    fn new(points: &[[f64; 2]]) -> Self {
        let h: Vec<f64> = points.windows(2).map(|two| two[1][0] - two[0][0]).collect();
        let d: Vec<f64> =
            points.windows(2).zip(&h).map(|(two, h)| (two[1][1] - two[0][1]) / h).collect();
        let last = points.len() - 1;
        let slope = |i: usize| {
            if last == 1 {
                d[0]
            } else if i == 0 {
                Self::end(h[0], h[1], d[0], d[1])
            } else if i == last {
                Self::end(h[last - 1], h[last - 2], d[last - 1], d[last - 2])
            } else if d[i - 1] * d[i] > 0.0 {
                let (before, after) = (h[i] * 2.0 + h[i - 1], h[i] + h[i - 1] * 2.0);
                (before + after) * d[i - 1] * d[i] / (before * d[i] + after * d[i - 1])
            } else {
                0.0
            }
        };
        Self {
            points: points.to_vec(),
            slopes: (0..=last).map(slope).collect(),
            odd: points[0] == [0.0, 0.0],
        }
    }

    /// The three-point formula at an end, as PCHIP limits it.
    fn end(near: f64, far: f64, first: f64, second: f64) -> f64 {
        let slope = first + near * (first - second) / (near + far);
        if slope * first <= 0.0 {
            0.0
        } else if first * second <= 0.0 && slope.abs() > (3.0 * first).abs() {
            3.0 * first
        } else {
            slope
        }
    }

    fn force_n(&self, x: f64) -> f64 {
        if self.odd && x < 0.0 {
            return -self.force_n(-x);
        }
        let (points, slopes) = (&self.points, &self.slopes);
        let after = points.partition_point(|point| point[0] <= x);
        if after == 0 || after == points.len() {
            let end = after.saturating_sub(1);
            return points[end][1] + slopes[end] * (x - points[end][0]);
        }
        let ([x0, f0], [x1, f1]) = (points[after - 1], points[after]);
        let (h, t) = (x1 - x0, (x - x0) / (x1 - x0));
        let s = 1.0 - t;
        // Hermite's basis.
        f0 * s * s * (1.0 + 2.0 * t)
            + f1 * t * t * (3.0 - 2.0 * t)
            + h * (slopes[after - 1] * t * s * s - slopes[after] * t * t * s)
    }
}

/// The mass that answers when the plate is pushed, kg: what turns with it, and the moving part of springs that count, whose mass is
/// given or that of their beams.
pub(crate) fn moving_kg(scene: &Scene) -> f64 {
    let spring = &scene.mechanism.spring;
    let turning = match spring.kind {
        SpringKind::Helix => spring.helix.inertia_kg_m2 * spring.helix.twist_rad_m.powi(2),
        _ => 0.0,
    };
    let part = match spring.kind {
        SpringKind::Cantilever => 33.0 / 140.0,
        SpringKind::FixedGuided => 13.0 / 35.0,
        _ => 1.0 / 3.0,
    };
    let beam = spring.beam;
    let beams = beam.density_kg_m3 * beam.width_m * beam.height_m * beam.length_m;
    let own = match spring.own_mass {
        OwnMass::Ignored => 0.0,
        OwnMass::Counted => part * spring.mass_kg.unwrap_or(spring.count * beams),
    };
    scene.mass_ratio() * scene.projectile.mass_kg + turning + own
}
