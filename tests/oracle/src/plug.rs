//! The plug that a blunt nose or a fragment shears out, read off its law once more.

use std::f64::consts::PI;

use cmra_engine::model::scene::{Nose, Scene};

use crate::law::exponent;

/// A plug, and the hole ahead of it.
#[derive(Clone, Copy)]
pub(crate) struct Plug {
    pub(crate) mass_kg: f64,
    /// Travel at which it is picked up, and at which it is free, m.
    pub(crate) from_m: f64,
    pub(crate) to_m: f64,
    /// Circumference times shear strength, N/m.
    rim_n_m: f64,
    thickness_m: f64,
    pub(crate) hole_m2: f64,
}

impl Plug {
    /// The plug of a scene; `None` for a nose that pushes the metal aside.
    pub(crate) fn new(scene: &Scene) -> Option<Self> {
        let is_fragment = match scene.projectile.nose {
            Nose::Fragment => true,
            Nose::Blunt => false,
            Nose::Hemispherical | Nose::Pointed => return None,
        };
        let target = &scene.target;
        let (y, e, body) =
            (target.yield_pa, target.modulus_pa, 2.0 * scene.projectile.tip_radius_m);
        let is_light = target.density_kg_m3 < 4000.0;
        let whole = scene.target.thickness_m / scene.cos_obliquity();
        let thickness_m = whole.min(1.35 * body);
        let tau = y * (e / y).powf(exponent(y, target.tensile_pa.unwrap_or(y), e)) / 3f64.sqrt();
        // Work of shearing per area and thickness: F over the slip up to the end of it.
        let work = (0.5 * tau).min(if is_light { 95e6 } else { 250e6 });
        let width = if is_fragment && !is_light { 2f64.sqrt() * body } else { body };
        let slip_m = thickness_m * (1.0 - (1.0 - 2.0 * work / tau).sqrt());
        let section = 0.25 * PI * body * body;
        Some(Self {
            mass_kg: target.density_kg_m3 * 0.25 * PI * width * width * thickness_m,
            from_m: whole - thickness_m,
            to_m: whole - thickness_m + slip_m,
            rim_n_m: PI * width * tau,
            thickness_m,
            hole_m2: if is_fragment { 2.0 * section } else { section },
        })
    }

    /// Shear force at a travel behind the pick-up, N.
    pub(crate) fn shear_n(&self, q: f64) -> f64 {
        self.rim_n_m * (self.thickness_m - (q - self.from_m))
    }
}
