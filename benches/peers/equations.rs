//! The contact phase as the peers get it: lengths by R, velocities by `v_i`, times by `R/v_i`, forces by `m_p v_i²/R`.
//! State: travel q and speed u of the projectile into the plate, displacement x and velocity w of the plate. Normal impact.

use std::f64::consts::PI;

use cmra_engine::model::scene::Scene;

/// Below this the tangent of a power law is taken there: at zero it is infinite.
const TANGENT_FROM: f64 = 1e-30;

/// A force law `k |z|^n sgn z`.
#[derive(Clone, Copy)]
pub(crate) struct Law(f64, f64);

impl Law {
    fn force(self, z: f64) -> f64 {
        let Self(k, n) = self;
        if k == 0.0 {
            0.0
        } else if (n - 1.0).abs() < 1e-15 {
            k * z
        } else {
            k * z.abs().powf(n) * z.signum()
        }
    }

    fn tangent(self, z: f64) -> f64 {
        let Self(k, n) = self;
        if k == 0.0 || (n - 1.0).abs() < 1e-15 {
            return k;
        }
        let z = if z.abs() > TANGENT_FROM { z.abs() } else { TANGENT_FROM };
        k * n * z.powf(n - 1.0)
    }
}

/// The scaled problem.
#[derive(Clone, Copy)]
pub(crate) struct Equations {
    strength: f64,
    drag: f64,
    mass_ratio: f64,
    spring: Law,
    damper: Law,
    slope: f64,
    thickness: f64,
    bend: f64,
    start: f64,
    /// R, m, and R/v, s.
    units: (f64, f64),
}

impl Equations {
    /// Builds the equations of a scene.
    pub(crate) fn from_scene(scene: &Scene) -> Self {
        let (m, r, v) = (
            scene.projectile.mass_kg,
            scene.projectile.tip_radius_m,
            scene.projectile.velocity_m_s,
        );
        let (spring, damper) = (&scene.mechanism.spring, scene.mechanism.damper);
        let thickness = scene.target.thickness_m / r;
        let per_force = r / (m * v * v);
        Self {
            strength: scene.flow_strength_pa() * r * r * per_force,
            drag: scene.drag_kg_m3() * r.powi(3) / m,
            mass_ratio: scene.mass_ratio(),
            spring: Law(spring.coefficient * r.powf(spring.exponent) * per_force, spring.exponent),
            damper: Law(damper.coefficient * v.powf(damper.exponent) * per_force, damper.exponent),
            slope: thickness / (thickness + 2.0),
            thickness,
            bend: thickness + 2.0,
            start: -scene.plate.cocking_m / r,
            units: (r, r / v),
        }
    }

    /// The state at first contact.
    pub(crate) fn start(&self) -> [f64; 4] {
        [0.0, 1.0, self.start, 0.0]
    }

    /// Depth at a travel.
    fn depth(&self, q: f64) -> f64 {
        if q <= self.bend { q * self.slope } else { q - 2.0 }
    }

    /// Time, s, and depth, m.
    pub(crate) fn end(&self, t: f64, q: f64) -> (f64, f64) {
        (t * self.units.1, self.depth(q) * self.units.0)
    }

    /// Area and its slope at a travel.
    fn area(&self, q: f64) -> (f64, f64) {
        let section = |p: f64| {
            if p <= 0.0 {
                (0.0, 0.0)
            } else if p < 1.0 {
                (PI * p * (2.0 - p), 2.0 * PI * (1.0 - p))
            } else {
                (PI, 0.0)
            }
        };
        let p = self.depth(q);
        let (front, rear) = (section(p), section(p - self.thickness));
        let per_travel = if q <= self.bend { self.slope } else { 1.0 };
        (front.0 - rear.0, (front.1 - rear.1) * per_travel)
    }

    /// Travels at which the area law has a joint, rising; at the last one the nose is clear of the plate.
    pub(crate) fn joints(&self) -> [f64; 3] {
        let travel = |p: f64| if p <= self.thickness { p / self.slope } else { p + 2.0 };
        let mut joints = [travel(1.0), self.bend, travel(self.thickness + 1.0)];
        joints.sort_by(f64::total_cmp);
        joints
    }

    /// The rates of (q, u, x, w).
    pub(crate) fn rates(&self, [q, u, x, w]: [f64; 4]) -> [f64; 4] {
        let f = self.area(q).0 * (self.strength + self.drag * u * u);
        let plate = (f - self.damper.force(w) - self.spring.force(x)) / self.mass_ratio;
        [u, -f - plate, w, plate]
    }

    /// Their derivatives, row by row.
    pub(crate) fn jacobian(&self, [q, u, x, w]: [f64; 4]) -> [[f64; 4]; 4] {
        let (area, slope) = self.area(q);
        let f = [slope * (self.strength + self.drag * u * u), 2.0 * area * self.drag * u];
        let g = self.mass_ratio;
        let plate = [f[0] / g, f[1] / g, -self.spring.tangent(x) / g, -self.damper.tangent(w) / g];
        let slip = [-f[0] - plate[0], -f[1] - plate[1], -plate[2], -plate[3]];
        [[0.0, 1.0, 0.0, 0.0], slip, [0.0, 0.0, 0.0, 1.0], plate]
    }
}
