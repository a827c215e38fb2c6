//! Algorithm of the thesis's Appendix A, step by step; each of its errors is a switch.
//!
//! The scripts m50, m200 and m300 are read as one loop. Each step computes the depth from the projectile's travel, then the area and one
//! force. The projectile is advanced by the trapezoid of old and new force (its travel by forward Euler), the plate by one Runge-Kutta step
//! with a constant force. The contact ends when the relative velocity falls below 0.01 m/s or the area vanishes. [`Listing`] names the
//! errors. This module computes a step of the contact; `listing` computes the run.

use crate::model::contact::Geometry;
use crate::model::power_law::PowerLaw;
use crate::model::run::{EndReason, Outcome};
use crate::model::scene::{Listing, Scene};

pub(in crate::model) mod listing;

/// Relative velocity at which the listing ends the contact, m/s.
const SLOW_M_S: f64 = 0.01;

/// State of the scheme.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct State {
    /// Travel of the projectile itself, the listing's `Pen`, m.
    pub pen_m: f64,
    /// Relative travel, m.
    pub travel_m: f64,
    /// Projectile velocity, m/s.
    pub velocity_m_s: f64,
    /// Plate displacement, m, and velocity, m/s.
    pub plate: [f64; 2],
    /// Plate state before the last step.
    pub plate_before: [f64; 2],
    /// Relative velocity, m/s.
    pub slip_m_s: f64,
    /// Depth, m.
    pub depth_m: f64,
    /// Engaged area, m².
    pub area_m2: f64,
    /// Contact force of this step, N.
    pub force_n: f64,
}

/// Scheme with the constants of a scene.
#[derive(Clone, Debug)]
pub struct Scheme {
    listing: Listing,
    geometry: Geometry,
    projectile_kg: f64,
    strength_pa: f64,
    drag_kg_m3: f64,
    /// Cosine of the obliquity, which couples force, plate and relative travel.
    cos: f64,
    plate: Plate,
    /// State at first contact. As printed, its relative velocity is the projectile's own velocity.
    pub start: State,
}

/// Plate with its mechanism.
#[derive(Clone, Copy, Debug)]
pub struct Plate {
    mass_kg: f64,
    spring: PowerLaw,
    damper: PowerLaw,
    signed: bool,
}

impl Plate {
    /// Returns spring and damper force at a state, N, with the signs of the listing.
    pub fn forces_n(&self, [x, w]: [f64; 2]) -> (f64, f64) {
        (self.spring.force(x), self.damper.force(if self.signed { w } else { w.abs() }))
    }

    /// Returns d/dt of (displacement, velocity) under the force (A.9).
    fn rate(&self, y: [f64; 2], force_n: f64) -> [f64; 2] {
        let (spring, damper) = self.forces_n(y);
        [y[1], (force_n - damper - spring) / self.mass_kg]
    }

    /// Advances the plate by one Runge-Kutta step (A.8; A.6 for zero force).
    pub fn step(&self, y: [f64; 2], force_n: f64, dt_s: f64) -> [f64; 2] {
        runge_kutta(y, dt_s, |y| self.rate(y, force_n))
    }
}

fn runge_kutta<const N: usize>(
    y: [f64; N],
    dt_s: f64,
    rate: impl Fn([f64; N]) -> [f64; N],
) -> [f64; N] {
    let ahead = |k: [f64; N], fraction: f64| std::array::from_fn(|i| y[i] + fraction * k[i]);
    let k1 = rate(y);
    let k2 = rate(ahead(k1, 0.5 * dt_s));
    let k3 = rate(ahead(k2, 0.5 * dt_s));
    let k4 = rate(ahead(k3, dt_s));
    std::array::from_fn(|i| y[i] + dt_s * ((k1[i] + k4[i]) / 6.0 + (k2[i] + k3[i]) / 3.0))
}

impl Scheme {
    /// Creates the time-stepping scheme of Appendix A for a valid scene; `listing` says which errors of the printed algorithm are corrected.
    pub fn from_scene(scene: &Scene, listing: Listing) -> Self {
        let geometry = Geometry::from_scene(scene);
        let cos = if listing.corrects_obliquity { geometry.nose.cos } else { 1.0 };
        let spring = &scene.mechanism.spring;
        let (velocity_m_s, plate_m_s) = (scene.projectile.velocity_m_s, scene.plate_velocity_m_s());
        let plate = [scene.start_m(), plate_m_s];
        let coupled_m_s = if listing.corrects_coupling { cos * plate_m_s } else { 0.0 };
        let slip_m_s = velocity_m_s - coupled_m_s;
        Self {
            listing,
            geometry,
            projectile_kg: scene.projectile.mass_kg,
            strength_pa: scene.flow_strength_pa(),
            drag_kg_m3: scene.drag_kg_m3(),
            cos,
            plate: Plate {
                mass_kg: if scene.is_sprung() { scene.plate_mass_kg() } else { f64::INFINITY },
                spring: PowerLaw { coefficient: spring.coefficient, exponent: spring.exponent },
                damper: scene.mechanism.damper,
                signed: listing.corrects_damper,
            },
            start: State { velocity_m_s, plate, plate_before: plate, slip_m_s, ..State::default() },
        }
    }

    /// Advances the state by one step.
    ///
    /// # Errors
    /// [`EndReason::BreaksOff`] at a negative depth, [`EndReason::NonFinite`] if it diverges.
    pub fn step(&self, state: &mut State) -> Result<(), EndReason> {
        if self.listing.corrects_scheme {
            self.step_by_runge_kutta(state)?;
        } else {
            self.step_as_printed(state)?;
        }
        let is_finite =
            [state.force_n, state.slip_m_s, state.plate[0]].iter().all(|x| x.is_finite());
        if is_finite { Ok(()) } else { Err(EndReason::NonFinite) }
    }

    fn step_as_printed(&self, state: &mut State) -> Result<(), EndReason> {
        let (dt_s, before_n) = (self.listing.step_s, state.force_n);
        state.pen_m += state.velocity_m_s * dt_s;
        state.travel_m += state.slip_m_s * dt_s;
        self.load(state)?;
        state.velocity_m_s -= dt_s * 0.5 * (state.force_n + before_n) / self.projectile_kg;
        state.plate_before = state.plate;
        state.plate = self.plate.step(state.plate, state.force_n * self.cos, dt_s);
        state.slip_m_s = state.velocity_m_s - self.cos * state.plate[1];
        Ok(())
    }

    /// Advances both bodies by one Runge-Kutta step; the force is evaluated at its stages.
    fn step_by_runge_kutta(&self, state: &mut State) -> Result<(), EndReason> {
        let increment = state.plate[0] - state.plate_before[0];
        let rate = |[pen, travel, v, x, w]: [f64; 5]| {
            let slip = v - self.cos * w;
            let force = self.force_n(self.depth_m(pen, travel, increment), slip).1;
            let [x_rate, w_rate] = self.plate.rate([x, w], force * self.cos);
            [v, slip, -force / self.projectile_kg, x_rate, w_rate]
        };
        let [x, w] = state.plate;
        let y = [state.pen_m, state.travel_m, state.velocity_m_s, x, w];
        state.plate_before = state.plate;
        [state.pen_m, state.travel_m, state.velocity_m_s, state.plate[0], state.plate[1]] =
            runge_kutta(y, self.listing.step_s, rate);
        state.slip_m_s = state.velocity_m_s - self.cos * state.plate[1];
        self.load(state)
    }

    /// Computes depth, area and force from the present travels.
    fn load(&self, state: &mut State) -> Result<(), EndReason> {
        let increment_m = state.plate[0] - state.plate_before[0];
        state.depth_m = self.depth_m(state.pen_m, state.travel_m, increment_m);
        if state.depth_m < 0.0 {
            return Err(EndReason::BreaksOff);
        }
        (state.area_m2, state.force_n) = self.force_n(state.depth_m, state.slip_m_s);
        Ok(())
    }

    fn depth_m(&self, pen_m: f64, travel_m: f64, increment_m: f64) -> f64 {
        if self.listing.corrects_coupling {
            self.geometry.depth_m(travel_m)
        } else {
            self.geometry.depth_m(pen_m) - increment_m
        }
    }

    fn force_n(&self, depth_m: f64, slip_m_s: f64) -> (f64, f64) {
        let Geometry { nose, thickness_m, .. } = &self.geometry;
        let overwritten = !self.listing.corrects_jumps && depth_m > nose.full_from_m();
        let engaged = nose.area_m2(depth_m) - nose.area_m2(depth_m - thickness_m);
        let area = if overwritten { f64::NAN } else { engaged };
        (area, area * (self.drag_kg_m3 * slip_m_s * slip_m_s + self.strength_pa))
    }

    /// Returns the outcome once the contact has ended; `None` before.
    pub fn ended(&self, state: &State) -> Option<Outcome> {
        let is_slow = if self.listing.corrects_stopping {
            state.slip_m_s <= 0.0
        } else {
            state.slip_m_s < SLOW_M_S
        };
        let is_out = state.area_m2 <= 0.0;
        is_out.then_some(Outcome::Perforated).or_else(|| is_slow.then_some(Outcome::Arrested))
    }
}
