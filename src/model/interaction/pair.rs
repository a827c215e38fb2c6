//! Two bodies, the force between them and the mechanism behind the plate, as a plain system of equations.
//!
//! In units of the nose radius R, the impact velocity v, R/v and the projectile's mass:
//!
//! ```text
//! q' = v - w cos    v' = -F    x' = w    w' = (F cos - G)/gamma        apart
//! q' = 0            v = w cos            w' = -G/(gamma + cos²)         joined
//! ```
//!
//! with G the mechanism's force. Three more components add up the work of F, of the damper and of the stop.

use crate::model::mechanism::{Inertia, Mechanism, PowerKind, PowerLaw};
use crate::model::scene::{Mount, Scene, Stop};
use crate::numerics::explicit::{Boundary, System};

/// Components of the state.
pub(super) const N: usize = 7;
/// Travel q.
pub(super) const Q: usize = 0;
/// Projectile velocity v.
pub(super) const V: usize = 1;
/// Plate displacement x.
pub(super) const X: usize = 2;
/// Plate velocity w.
pub(super) const W: usize = 3;
/// Work of the contact force.
pub(super) const CONTACT: usize = 4;
/// Work taken by the damper.
pub(super) const DAMPER: usize = 5;
/// Work taken by the stop.
pub(super) const STOP: usize = 6;

/// A spring with infinite slope at zero is taken as a straight line within this part of the nose radius.
const STRAIGHT: f64 = 1e-9;

/// The units, in SI.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    pub(super) length_m: f64,
    pub(super) speed_m_s: f64,
    pub(super) time_s: f64,
    pub(super) force_n: f64,
    pub(super) energy_j: f64,
}

impl Units {
    pub(super) fn of(scene: &Scene) -> Self {
        let (r, v) = (scene.projectile.tip_radius_m, scene.projectile.velocity_m_s);
        let energy_j = scene.projectile.mass_kg * v * v;
        Self { length_m: r, speed_m_s: v, time_s: r / v, force_n: energy_j / r, energy_j }
    }

    /// A stiffness, N/m, in these units.
    pub(super) fn stiffness(&self, stiffness_n_m: f64) -> f64 {
        stiffness_n_m * self.length_m / self.force_n
    }

    /// A damping, N s/m, in these units.
    pub(super) fn damping(&self, damping_n_s_m: f64) -> f64 {
        damping_n_s_m * self.speed_m_s / self.force_n
    }
}

/// The force between the bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Push {
    /// None.
    None,
    /// A half-sine of this amplitude and duration.
    Pulse { amplitude: f64, duration: f64 },
    /// A spring that is slack at `slack`, with a damper beside it; both together only push.
    Spring { stiffness: f64, slack: f64, damping: f64 },
}

impl Push {
    pub(super) fn force(&self, t: f64, q: f64, slip: f64) -> f64 {
        match *self {
            Self::None => 0.0,
            Self::Pulse { amplitude, duration } => {
                amplitude * (std::f64::consts::PI * t / duration).sin()
            }
            Self::Spring { stiffness, slack, damping } => stiffness * (q - slack) + damping * slip,
        }
    }
}

/// The two bodies.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub(super) gamma: f64,
    pub(super) cos: f64,
    pub(super) spring: PowerLaw,
    pub(super) damper: PowerLaw,
    pub(super) stop: Option<Stop>,
    /// In units of length; infinite where there is none.
    pub(super) stop_at: f64,
    stop_stiffness: f64,
    stop_damping: f64,
    /// The plate cannot move.
    pub(super) rigid: bool,
    /// The plate rests on its rigid stop.
    pub(super) held: bool,
    /// Both bodies move as one.
    pub(super) joined: bool,
    pub(super) push: Push,
    pub(super) boundaries: Vec<Boundary<N>>,
}

impl Pair {
    pub(super) fn of(scene: &Scene, units: &Units) -> Self {
        let mechanism = Mechanism::of(scene);
        let scaled = |law: PowerLaw, unit: f64| PowerLaw {
            coefficient: law.coefficient * unit.powf(law.exponent) / units.force_n,
            ..law
        };
        let none = PowerLaw { coefficient: 0.0, exponent: 1.0 };
        let stop = mechanism.stop;
        Self {
            gamma: scene.plate.mass_ratio
                + Inertia::of(scene).added_kg() / scene.projectile.mass_kg,
            cos: scene.cos_obliquity(),
            // A valid scene of these models has no curve.
            spring: scaled(mechanism.spring.power().unwrap_or(none), units.length_m),
            damper: scaled(mechanism.damper, units.speed_m_s),
            stop,
            stop_at: mechanism.stop_at_m / units.length_m,
            stop_stiffness: stop.map_or(0.0, |stop| units.stiffness(stop.stiffness_n_m)),
            stop_damping: stop.map_or(0.0, |stop| units.damping(stop.damping_n_s_m)),
            rigid: scene.plate.mount == Mount::Rigid,
            held: false,
            joined: false,
            push: Push::None,
            boundaries: Vec::new(),
        }
    }

    /// Whether the plate stays where it is.
    pub(super) fn is_still(&self) -> bool {
        self.rigid || self.held
    }

    /// Whether neither spring, nor damper, nor stop acts on the plate.
    pub(super) fn is_free(&self) -> bool {
        self.spring.coefficient == 0.0 && self.damper.coefficient == 0.0 && self.stop.is_none()
    }

    /// The spring's force at x.
    pub(super) fn spring_force(&self, x: f64) -> f64 {
        if self.spring.kind() == PowerKind::General
            && self.spring.exponent < 1.0
            && x.abs() < STRAIGHT
        {
            return self.spring.force(STRAIGHT) * x / STRAIGHT;
        }
        self.spring.force(x)
    }

    /// The elastic stop's force, which only pushes.
    pub(super) fn stop_force(&self, x: f64, w: f64) -> f64 {
        if x <= self.stop_at || !self.has_elastic_stop() {
            return 0.0;
        }
        let force = self.stop_stiffness * (x - self.stop_at) + self.stop_damping * w;
        if force > 0.0 { force } else { 0.0 }
    }

    /// Where spring and damper of the elastic stop, taken together with this sign, fall to zero.
    pub(super) fn stop_plane(&self, sign: f64) -> Boundary<N> {
        let mut boundary =
            Boundary { offset: -sign * self.stop_stiffness * self.stop_at, slope: [0.0; N] };
        boundary.slope[X] = sign * self.stop_stiffness;
        boundary.slope[W] = sign * self.stop_damping;
        boundary
    }

    pub(super) fn has_elastic_stop(&self) -> bool {
        self.stop.is_some_and(|stop| stop.kind == crate::model::scene::StopKind::Elastic)
    }

    pub(super) fn rigid_stop(&self) -> Option<Stop> {
        self.stop.filter(|stop| stop.kind == crate::model::scene::StopKind::Rigid)
    }

    /// Energy in spring and elastic stop at x.
    pub(super) fn potential(&self, x: f64) -> f64 {
        let pressed =
            if x > self.stop_at && self.has_elastic_stop() { x - self.stop_at } else { 0.0 };
        self.spring.integral(x) + 0.5 * self.stop_stiffness * pressed * pressed
    }

    /// Mass that moves with the plate.
    pub(super) fn moving_mass(&self) -> f64 {
        if self.joined { self.gamma + self.cos * self.cos } else { self.gamma }
    }

    /// Kinetic energy of the moving plate, with the projectile when joined, and what spring and stop store.
    pub(super) fn plate_energy(&self, y: &[f64; N]) -> f64 {
        0.5 * self.moving_mass() * y[W] * y[W] + self.potential(y[X])
    }

    /// Relative velocity.
    pub(super) fn slip(&self, y: &[f64; N]) -> f64 {
        y[V] - self.cos * y[W]
    }

    /// The contact force now.
    pub(super) fn contact_force(&self, t: f64, y: &[f64; N]) -> f64 {
        if self.joined {
            // What moves the projectile along with the plate.
            let g = self.spring_force(y[X]) + self.damper.force(y[W]) + self.stop_force(y[X], y[W]);
            return if self.is_still() { 0.0 } else { g * self.cos / self.moving_mass() };
        }
        self.push.force(t, y[Q], self.slip(y))
    }
}

impl System<N> for Pair {
    fn rate(&mut self, t: f64, y: &[f64; N]) -> [f64; N] {
        let slip = self.slip(y);
        let push = if self.joined { 0.0 } else { self.push.force(t, y[Q], slip) };
        let damper = self.damper.force(y[W]);
        let stop = self.stop_force(y[X], y[W]);
        let g = self.spring_force(y[X]) + damper + stop;
        let plate = if self.is_still() { 0.0 } else { (push * self.cos - g) / self.moving_mass() };
        let projectile = if self.joined { plate * self.cos } else { -push };
        let w = if self.is_still() { 0.0 } else { y[W] };
        let slip = if self.joined { 0.0 } else { slip };
        [slip, projectile, w, plate, push * slip, damper * w, stop * w]
    }

    fn boundaries(&self) -> &[Boundary<N>] {
        &self.boundaries
    }
}
