//! The plug that a blunt nose or a fragment shears out of a plate.
//!
//! Form of the law: R. F. Recht and T. W. Ipson, *Journal of Applied Mechanics* 30 (1963) 384-390: the projectile picks up the plug in a
//! perfectly inelastic impact, then shears it off. Four constants are fitted to measured ballistic limits of the REL database (Ryan et al.,
//! *Defence Technology* 2023; Mendeley Data, doi 10.17632/4f92y6jzzh.2, CC BY 4.0) and marked as fitted.
//!
//! The force over the slip s is `F = pi D_p tau (h_p - s)` with tau = `sigma_1`/3^(1/2), up to the slip at which the work per sheared area
//! has reached `w h_p`. So the work is W = `pi D_p h_p² w`; the slip ends at `s_f = h_p (1 - (1 - 2 w/tau)^(1/2))`. Ductile shearing through
//! the whole thickness is w = tau/2. Adiabatic shear ends it at a work that hardly depends on the strength.

use std::f64::consts::{FRAC_PI_4, PI, SQRT_2};

use crate::model::scene::{ContactModel, Nose, Scene};
use crate::model::strength::flow_stress_pa;
use crate::numerics::smaller;

/// Maximum thickness of the plug, in projectile diameters; fitted.
const THICKNESS: f64 = 1.35;
/// Area of the hole of a fragment over its cross-section, because a fragment mushrooms; fitted. A rigid cylinder has 1.
const FRAGMENT_AREA: f64 = 2.0;
/// Diameter of a fragment's plug in steel, in fragment diameters; fitted.
const ON_STEEL: f64 = SQRT_2;
/// Work w of adiabatic shear of light alloys and of steel, Pa; fitted. For nine aluminium alloys of 310e6 to 552e6 Pa it was 88e6 to 128e6
/// Pa.
const ADIABATIC_LIGHT_PA: f64 = 95e6;
const ADIABATIC_STEEL_PA: f64 = 250e6;

/// Minimum h/D at which a plate shears more than it dishes under a rigid cylinder.
pub const CYLINDER_FROM: f64 = 0.6;

/// Returns plate thickness over projectile diameter.
pub fn thickness_ratio(scene: &Scene) -> f64 {
    0.5 * scene.target.thickness_m / scene.projectile.tip_radius_m
}

/// Returns `true` if the plate dishes more than it shears under a rigid cylinder. The law of the plug is then too low: a stopped shot is
/// stopped, but perforations and residual velocities are not reliable.
pub fn is_law_low(scene: &Scene) -> bool {
    scene.contact.model == ContactModel::Hydrodynamic
        && scene.projectile.nose == Nose::Blunt
        && thickness_ratio(scene) < CYLINDER_FROM
}

/// Metals with a plug law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metal {
    /// Alloys of aluminium and magnesium.
    Light,
    /// Steels.
    Steel,
}

impl Metal {
    /// Upper limit of the density of a light alloy, kg/m³.
    pub const LIGHT_BELOW_KG_M3: f64 = 4000.0;
    /// Range of the density of steels, kg/m³, from high-chromium to austenitic steel.
    pub const STEEL_KG_M3: (f64, f64) = (7500.0, 8100.0);

    /// Returns the metal of a density, kg/m³; `None` for other metals.
    pub fn of_density(density_kg_m3: f64) -> Option<Self> {
        let (low, high) = Self::STEEL_KG_M3;
        let is_steel = (low..=high).contains(&density_kg_m3);
        let is_light = density_kg_m3 < Self::LIGHT_BELOW_KG_M3;
        is_light.then_some(Self::Light).or_else(|| is_steel.then_some(Self::Steel))
    }

    fn adiabatic_pa(self) -> f64 {
        match self {
            Self::Light => ADIABATIC_LIGHT_PA,
            Self::Steel => ADIABATIC_STEEL_PA,
        }
    }
}

/// Plug of a shot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plug {
    /// Mass `m_k`, kg.
    pub mass_kg: f64,
    /// Diameter `D_p`, m.
    pub diameter_m: f64,
    /// Thickness `h_p` along the shot's line, m.
    pub thickness_m: f64,
    /// Shear strength tau, Pa.
    pub shear_pa: f64,
    /// Slip at which the plug is fully sheared, `s_f`, m.
    pub slip_m: f64,
    /// Work of shearing W, J.
    pub work_j: f64,
    /// Area of the hole in front of the plug, m².
    pub hole_area_m2: f64,
}

impl Plug {
    /// Computes the plug of a valid scene; `None` for a nose that pushes the metal aside, or without a law for the metal.
    pub fn from_scene(scene: &Scene) -> Option<Self> {
        let nose = scene.projectile.nose;
        if !nose.shears() {
            return None;
        }
        let target = &scene.target;
        let metal = Metal::of_density(target.density_kg_m3)?;
        let strength_pa =
            flow_stress_pa(target.yield_pa, target.modulus_pa, scene.hardening_exponent());
        let body_m = 2.0 * scene.projectile.tip_radius_m;
        let thickness_m = smaller(scene.effective_thickness_m(), THICKNESS * body_m);
        Some(Self::new(nose, metal, body_m, target.density_kg_m3, (thickness_m, strength_pa)))
    }

    /// Computes the plug of a body of this diameter, from the remaining thickness and the flow stress at a strain of 1.
    fn new(
        nose: Nose,
        metal: Metal,
        body_m: f64,
        density_kg_m3: f64,
        (thickness_m, strength_pa): (f64, f64),
    ) -> Self {
        let is_fragment = nose == Nose::Fragment;
        let diameter_m =
            if is_fragment && metal == Metal::Steel { ON_STEEL * body_m } else { body_m };
        let shear_pa = strength_pa / 3f64.sqrt();
        let work_pa = smaller(0.5 * shear_pa, metal.adiabatic_pa());
        let left = 1.0 - 2.0 * work_pa / shear_pa;
        let widening = if is_fragment { FRAGMENT_AREA } else { 1.0 };
        Self {
            mass_kg: density_kg_m3 * FRAC_PI_4 * diameter_m * diameter_m * thickness_m,
            diameter_m,
            thickness_m,
            shear_pa,
            slip_m: thickness_m * (1.0 - left.sqrt()),
            work_j: PI * diameter_m * thickness_m * thickness_m * work_pa,
            hole_area_m2: widening * FRAC_PI_4 * body_m * body_m,
        }
    }

    /// Returns the shear force at a slip up to `slip_m`, N.
    pub fn force_n(&self, slip_m: f64) -> f64 {
        PI * self.diameter_m * self.shear_pa * (self.thickness_m - slip_m)
    }

    /// Returns the fraction of its velocity relative to the plate that a projectile of this mass retains when it picks up the plug.
    pub fn kept(&self, projectile_kg: f64) -> f64 {
        projectile_kg / (projectile_kg + self.mass_kg)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::variables::scene_with;

    /// Mass, thickness, shear work, slip and force of the plugs of four shots: a 20 mm fragment on 25.1 mm of AA5059-H131 and on 38.7 mm of
    /// AA2139-T8, a 12.6 mm fragment on steel, and a rigid cylinder on Weldox 460 E.
    #[test]
    fn valid_plugs_of_four_shots() {
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 2e-6;
        let plug = |pairs: &str| {
            Plug::from_scene(&scene_with(&format!("mount=rigid closure=cylindrical {pairs}")))
                .unwrap()
        };
        let on_5059 = plug(
            "nose=fragment m_p=53.78g R=9.95mm h=25.1mm rho=2660 Y=254MPa UTS=365MPa E=70.9GPa",
        );
        assert!(near(on_5059.mass_kg, 20.7659e-3) && near(on_5059.work_j, 3741.74));
        assert!(near(on_5059.slip_m, 9.198_56e-3) && near(on_5059.force_n(0.0), 498_034.0));
        let on_2139 = plug(
            "nose=fragment m_p=53.78g R=9.95mm h=38.7mm rho=2810 Y=414MPa UTS=462MPa E=73.1GPa",
        );
        assert!(near(on_2139.thickness_m, 26.865e-3) && near(on_2139.mass_kg, 23.4795e-3));
        assert!(near(on_2139.work_j, 4286.47));
        // The work is the integral of the force over the slip, a trapezium.
        for it in [
            on_5059,
            on_2139,
            plug("nose=blunt R=10mm h=12mm rho=7850 Y=490MPa UTS=567MPa E=200GPa"),
        ] {
            let work_j = 0.5 * (it.force_n(0.0) + it.force_n(it.slip_m)) * it.slip_m;
            assert!((it.work_j / work_j - 1.0).abs() < 1e-13);
        }
        // Ductile shearing ends at the rear face: w = tau/2.
        let ductile = plug("nose=blunt R=10mm h=12mm rho=7850 Y=490MPa UTS=567MPa E=200GPa");
        assert!((ductile.slip_m - ductile.thickness_m).abs() < 1e-17);
        // The plug of a fragment on steel has twice the fragment's cross-section.
        let on_steel = plug(
            "nose=fragment m_p=13.4g R=6.3mm h=10.4mm rho=7850 Y=1350MPa UTS=1640MPa E=207GPa",
        );
        assert!(near(on_steel.mass_kg, 7850.0 * PI * 0.25 * 2.0 * 0.0126f64.powi(2) * 0.0104));
    }

    #[test]
    fn other_noses_and_other_metals_have_no_plug() {
        for pairs in
            ["nose=pointed", "nose=hemispherical", "nose=blunt rho=4430", "nose=fragment rho=17000"]
        {
            assert_eq!(
                Plug::from_scene(&scene_with(&format!("closure=cylindrical {pairs}"))),
                None,
                "{pairs}"
            );
        }
    }
}
