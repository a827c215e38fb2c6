//! Geometry of the contact between nose and plate: depth as a function of travel, engaged area as a function of depth.
//!
//! Travel q is the relative displacement of the projectile along its axis since first contact. Depth p is smaller than q, because a bulge
//! of the plate (dishing) takes up one projectile diameter in total. The engaged area is the projected area of the nose between entry and
//! exit face, A(p) = `A_in(p)` - `A_in(p - h_e)`. Sources: thesis equation 8.4, section 8.3.1, Appendix A.2 and A.3; the sphere-cylinder
//! section is rewritten without the division by tan(theta). Tests compare with numerically integrated areas and check continuity.

use std::f64::consts::PI;

use crate::model::plug::Plug;
use crate::model::scene::Scene;
use crate::numerics::quadrature::gauss;
use crate::numerics::root::bracketed_root;
use crate::numerics::{larger, smaller};

/// Fraction of the range of partial engagement, at each end, in which the adjacent closed form is used. The error is the 5/2 power of this
/// value, below rounding; the derivatives of the exact section are singular there.
const JOINT: f64 = 1e-5;
/// Obliquity below which the impact counts as normal, rad; the error is of the order of its square.
const NORMAL_BELOW: f64 = 1e-7;

/// Geometry of the nose along the axis of the projectile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoseGeometry {
    /// Radius R, m.
    pub radius_m: f64,
    /// sin(theta).
    pub sin: f64,
    /// cos(theta).
    pub cos: f64,
    /// Range of depths in which a face intersects both hemisphere and cylinder; empty at normal impact.
    partial_from_m: f64,
    partial_to_m: f64,
}

/// Maximum number of pieces of a passage: each face meets the nose at up to three depths.
const PIECES_MAX: usize = 6;

/// Depth and area laws of a scene, in analytic pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct Geometry {
    /// Nose.
    pub nose: NoseGeometry,
    /// Thickness along the axis of the projectile, `h_e` = h / cos(theta), m.
    pub thickness_m: f64,
    /// Derivative of depth by travel up to `bend_m`.
    pub slope: f64,
    /// Travel up to which the depth is `slope` times travel, m; beyond, the depth is travel minus `lag_m`.
    pub bend_m: f64,
    /// Travel taken up by dishing, m.
    pub lag_m: f64,
    /// Travel at which the nose leaves the rear face, or reaches the plug, m.
    pub exit_m: f64,
    /// Pieces, of which the first `count` are used; an array, so that a sweep does not allocate.
    pieces: [AreaPiece; PIECES_MAX],
    count: usize,
}

/// Interval of travel in which the area is one analytic function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaPiece {
    /// Lower end, m.
    pub from_m: f64,
    /// Upper end, m.
    pub to_m: f64,
    /// Area law.
    pub law: AreaLaw,
}

/// Engaged area as a function of travel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AreaLaw {
    /// a0 + a1 (q - origin) + a2 (q - origin)², m².
    Quadratic {
        /// Origin of the polynomial, m.
        origin_m: f64,
        /// Coefficients.
        a: [f64; 3],
    },
    /// Oblique impact with a face across sphere and cylinder: entry section minus exit section.
    Partial {
        /// Origin of the depth of the entry section, p = p0 + p1 (q - origin), m.
        origin_m: f64,
        /// Depth at the origin, m.
        p0: f64,
        /// Derivative of depth by travel.
        p1: f64,
        /// Depth at which the exit section starts, m.
        exit_depth_m: f64,
    },
}

/// Section of the nose by a face.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Section {
    /// No section.
    None,
    /// Ellipse within the hemisphere.
    Cap,
    /// Section across hemisphere and cylinder.
    Partial,
    /// Section of the cylinder.
    Full,
}

impl NoseGeometry {
    /// Creates the nose of the projectile of a scene.
    pub fn from_scene(scene: &Scene) -> Self {
        let (sin, cos) = scene.projectile.obliquity_deg.to_radians().sin_cos();
        let radius_m = scene.projectile.tip_radius_m;
        let mut nose = Self { radius_m, sin, cos, partial_from_m: 0.0, partial_to_m: 0.0 };
        let (from, to) = (nose.cap_end_m(), nose.full_from_m());
        let joint = JOINT * (to - from);
        let middle = 0.5 * (from + to);
        (nose.partial_from_m, nose.partial_to_m) =
            if nose.is_normal() { (middle, middle) } else { (from + joint, to - joint) };
        nose
    }

    /// Returns the depth at which a face starts to intersect the cylinder, R (1/cos - tan), m.
    pub fn cap_end_m(&self) -> f64 {
        self.radius_m * (1.0 - self.sin) / self.cos
    }

    /// Returns the depth from which a face intersects only the cylinder, R (1/cos + tan), m.
    pub fn full_from_m(&self) -> f64 {
        self.radius_m * (1.0 + self.sin) / self.cos
    }

    /// Returns the depth from which the nose is buried in a piece of the area law, m.
    pub(in crate::model) fn buried_from_m(&self) -> f64 {
        self.partial_to_m
    }

    fn is_normal(&self) -> bool {
        self.sin < NORMAL_BELOW
    }

    /// Returns the section at depth `p_m`.
    fn section(&self, p_m: f64) -> Section {
        if p_m <= 0.0 {
            Section::None
        } else if p_m < self.partial_from_m {
            Section::Cap
        } else if p_m < self.partial_to_m {
            Section::Partial
        } else {
            Section::Full
        }
    }

    /// Returns the projected area of the nose behind a face that it has passed by the depth `p_m`, m².
    pub fn area_m2(&self, p_m: f64) -> f64 {
        self.polynomial(self.section(p_m), p_m, 1.0)[0]
    }

    /// Returns the Taylor coefficients of the area by travel at the depth `p_m`, for a given derivative of depth by travel; only the first
    /// one for a partial section.
    #[inline]
    fn polynomial(&self, section: Section, p_m: f64, rate: f64) -> [f64; 3] {
        let (r, c) = (self.radius_m, self.cos);
        let factor = PI * c * c;
        match section {
            Section::None => [0.0; 3],
            Section::Cap => [
                factor * p_m * (2.0 * r - p_m * c),
                factor * 2.0 * (r - p_m * c) * rate,
                -factor * c * rate * rate,
            ],
            Section::Partial => [self.partial_m2(p_m), 0.0, 0.0],
            Section::Full => [PI * r * r, 0.0, 0.0],
        }
    }

    /// Returns the area of a section across sphere and cylinder, m².
    ///
    /// kappa = 1 - p cos/R is the height of the face above the centre of the sphere over R, and
    /// A/R² = cos (1 - kappa²) phi + acos(kappa/sin) - kappa (sin² - kappa²)^(1/2). phi is half the angle of the section's circle that lies
    /// on the forward hemisphere: pi for a section of the hemisphere only, 0 for one of the cylinder only.
    fn partial_m2(&self, p_m: f64) -> f64 {
        let (r, sin, cos) = (self.radius_m, self.sin, self.cos);
        let (kappa, phi, chord) = self.across(p_m);
        let circle = 1.0 - kappa * kappa;
        let beyond = (kappa / sin).clamp(-1.0, 1.0).acos();
        r * r * (cos * circle * phi + beyond - kappa * chord)
    }

    /// Returns kappa, phi and (sin² - kappa²)^(1/2) of a section across sphere and cylinder.
    fn across(&self, p_m: f64) -> (f64, f64, f64) {
        let (sin, cos) = (self.sin, self.cos);
        let kappa = 1.0 - p_m * cos / self.radius_m;
        let circle = 1.0 - kappa * kappa;
        let phi = (-kappa * cos / (sin * circle.sqrt())).clamp(-1.0, 1.0).acos();
        (kappa, phi, larger(sin * sin - kappa * kappa, 0.0).sqrt())
    }

    /// Returns the derivative of the area by depth, m; across sphere and cylinder 2 R cos (kappa cos phi + (sin² - kappa²)^(1/2)).
    fn slope_m(&self, p_m: f64) -> f64 {
        match self.section(p_m) {
            Section::Partial => {
                let (kappa, phi, chord) = self.across(p_m);
                2.0 * self.radius_m * self.cos * (kappa * self.cos * phi + chord)
            }
            section => self.polynomial(section, p_m, 1.0)[1],
        }
    }
}

impl Geometry {
    /// Creates the geometry of a scene; with a plug, that of the hole in front of it.
    pub fn from_scene(scene: &Scene) -> Self {
        let nose = NoseGeometry::from_scene(scene);
        let thickness_m = scene.effective_thickness_m();
        if let Some(plug) = Plug::from_scene(scene) {
            return Self::ahead_of(&plug, nose, thickness_m);
        }
        let lag_m = if scene.target_in_effect().dishing { 2.0 * nose.radius_m } else { 0.0 };
        let bend_m = thickness_m + lag_m;
        let slope = thickness_m / bend_m;
        let (h, r, f) = (thickness_m, nose.partial_from_m, nose.partial_to_m);
        let end = h + nose.full_from_m();
        let mut geometry = Self {
            nose,
            thickness_m,
            slope,
            bend_m,
            lag_m,
            exit_m: end + lag_m,
            pieces: [AreaPiece::free(0.0, 0.0); PIECES_MAX],
            count: 0,
        };
        // The pieces end at the depths at which a face meets the tip, the cylinder or the end of the nose, and at the thickness. They
        // are in this order for a thick plate.
        let mut depths = [r, f, h, h + r, h + f, end];
        if f > h {
            depths.sort_unstable_by(f64::total_cmp);
        }
        let mut from_m = 0.0;
        for depth in depths {
            let to_m = geometry.travel_m(depth);
            if to_m > from_m {
                let law = geometry.law(from_m, to_m);
                geometry.pieces[geometry.count] = AreaPiece { from_m, to_m, law };
                geometry.count += 1;
                from_m = to_m;
            }
        }
        geometry
    }

    /// Creates the geometry of the hole in front of a plug: a blunt nose has its full area from the start. Without pieces if the plug
    /// comprises the whole thickness.
    fn ahead_of(plug: &Plug, nose: NoseGeometry, thickness_m: f64) -> Self {
        let exit_m = thickness_m - plug.thickness_m;
        let mut geometry = Self {
            nose,
            thickness_m,
            slope: 1.0,
            bend_m: thickness_m,
            lag_m: 0.0,
            exit_m,
            pieces: [AreaPiece::free(0.0, 0.0); PIECES_MAX],
            count: 0,
        };
        if exit_m > 0.0 {
            geometry.push(exit_m, [plug.hole_area_m2, 0.0, 0.0]);
        }
        geometry
    }

    /// Returns the geometry after the plug is picked up: the sheared area as a function of travel, to be multiplied by the shear strength.
    /// The hole in front of the plug has an area with equal resistance at this strength.
    #[must_use]
    pub(in crate::model) fn around(&self, plug: &Plug, strength_pa: f64) -> Self {
        let mut geometry = Self { count: 0, ..self.clone() };
        if self.exit_m > 0.0 {
            geometry.push(self.exit_m, [plug.hole_area_m2 * strength_pa / plug.shear_pa, 0.0, 0.0]);
        }
        geometry.exit_m = self.exit_m + plug.slip_m;
        let rim_m = PI * plug.diameter_m;
        geometry.push(geometry.exit_m, [rim_m * plug.thickness_m, -rim_m, 0.0]);
        geometry
    }

    /// Appends a piece up to a travel, with the coefficients of its area.
    fn push(&mut self, to_m: f64, a: [f64; 3]) {
        let from_m = self.pieces().last().map_or(0.0, |piece| piece.to_m);
        let law = AreaLaw::Quadratic { origin_m: from_m, a };
        self.pieces[self.count] = AreaPiece { from_m, to_m, law };
        self.count += 1;
    }

    /// Returns the depth at travel `q_m`, m; negative for negative travel (the nose is in front of the entry face).
    pub fn depth_m(&self, q_m: f64) -> f64 {
        if q_m <= self.bend_m { q_m * self.slope } else { q_m - self.lag_m }
    }

    /// Returns the travel at depth `p_m`, m.
    pub fn travel_m(&self, p_m: f64) -> f64 {
        if p_m <= self.thickness_m { p_m / self.slope } else { p_m + self.lag_m }
    }

    /// Returns the engaged area at travel `q_m`, m².
    pub fn area_m2(&self, q_m: f64) -> f64 {
        self.piece(q_m).law.area_m2(&self.nose, q_m)
    }

    /// Returns the pieces in order, from zero travel to the exit.
    pub fn pieces(&self) -> &[AreaPiece] {
        &self.pieces[..self.count]
    }

    /// Returns the piece at travel `q_m`, the upper one at a joint; a piece without area before and after.
    pub fn piece(&self, q_m: f64) -> AreaPiece {
        if q_m < 0.0 {
            return AreaPiece::free(f64::NEG_INFINITY, 0.0);
        }
        let found = self.pieces().iter().find(|piece| q_m < piece.to_m);
        found.copied().unwrap_or_else(|| AreaPiece::free(self.exit_m, f64::INFINITY))
    }

    /// Returns the volume swept from first contact to travel `q_m`, the integral of the area over travel, m³.
    pub fn swept_m3(&self, q_m: f64) -> f64 {
        let before = self.pieces().iter().take_while(|piece| piece.from_m < q_m);
        before.fold(0.0, |volume_m3, piece| {
            let to_m = smaller(q_m, piece.to_m);
            volume_m3 + piece.swept_before_m3(&self.nose, to_m, to_m - piece.from_m)
        })
    }

    /// Returns the travel at which the swept volume is `volume_m3`; `None` beyond the volume of the whole passage.
    pub fn travel_at_volume_m(&self, volume_m3: f64) -> Option<f64> {
        let missing_m3 = |q_m: f64| volume_m3 - self.swept_m3(q_m);
        (missing_m3(self.exit_m) < 0.0).then(|| bracketed_root(0.0, self.exit_m, missing_m3))
    }

    fn law(&self, from_m: f64, to_m: f64) -> AreaLaw {
        let middle = self.depth_m(0.5 * (from_m + to_m));
        let nose = &self.nose;
        let (entry, exit) = (nose.section(middle), nose.section(middle - self.thickness_m));
        let rate = if 0.5 * (from_m + to_m) <= self.bend_m { self.slope } else { 1.0 };
        if entry == Section::Partial || exit == Section::Partial {
            return AreaLaw::Partial {
                origin_m: from_m,
                p0: self.depth_m(from_m),
                p1: rate,
                exit_depth_m: self.thickness_m,
            };
        }
        // The origin is the end at which the area vanishes, so that small areas are accurate.
        let leaving = exit == Section::Cap && entry == Section::Full;
        let origin_m =
            if leaving { self.travel_m(self.thickness_m + nose.cap_end_m()) } else { from_m };
        let depth = self.depth_m(origin_m);
        let inside = nose.polynomial(entry, depth, rate);
        let outside = nose.polynomial(exit, depth - self.thickness_m, rate);
        let mut a = std::array::from_fn(|i| inside[i] - outside[i]);
        if leaving && nose.is_normal() {
            (a[0], a[1]) = (0.0, 0.0);
        }
        AreaLaw::Quadratic { origin_m, a }
    }
}

impl AreaPiece {
    /// Returns a piece without area.
    const fn free(from_m: f64, to_m: f64) -> Self {
        Self { from_m, to_m, law: AreaLaw::Quadratic { origin_m: 0.0, a: [0.0; 3] } }
    }

    /// Returns the integral of the area over the last `width` before `to_m`, m³, without cancellation for a small `width`.
    #[inline]
    pub fn swept_before_m3(&self, nose: &NoseGeometry, to_m: f64, width: f64) -> f64 {
        if let AreaLaw::Quadratic { origin_m, a } = self.law {
            let s = to_m - origin_m;
            let (area_m2, half_slope_m) = (a[0] + s * (a[1] + s * a[2]), 0.5 * a[1] + s * a[2]);
            return width * (area_m2 + width * (width * a[2] / 3.0 - half_slope_m));
        }
        // Other areas: the substitution q = from + width (3 s² - 2 s³) removes the half powers at the joints.
        gauss(0.0, 1.0, 2, |s| {
            let q_m = to_m - width + width * s * s * (3.0 - 2.0 * s);
            self.law.area_m2(nose, q_m) * width * 6.0 * s * (1.0 - s)
        })
    }
}

impl AreaLaw {
    /// Returns the area at travel `q_m`, m².
    pub fn area_m2(&self, nose: &NoseGeometry, q_m: f64) -> f64 {
        match *self {
            Self::Quadratic { origin_m, a } => {
                let s = q_m - origin_m;
                a[0] + s * (a[1] + s * a[2])
            }
            Self::Partial { origin_m, p0, p1, exit_depth_m } => {
                let p = p0 + p1 * (q_m - origin_m);
                nose.area_m2(p) - nose.area_m2(p - exit_depth_m)
            }
        }
    }

    /// Returns the derivative of the area by travel, m.
    pub fn slope_m(&self, nose: &NoseGeometry, q_m: f64) -> f64 {
        match *self {
            Self::Quadratic { origin_m, a } => a[1] + 2.0 * a[2] * (q_m - origin_m),
            Self::Partial { origin_m, p0, p1, exit_depth_m } => {
                let p = p0 + p1 * (q_m - origin_m);
                p1 * (nose.slope_m(p) - nose.slope_m(p - exit_depth_m))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::variables::scene_with;

    fn nose(degrees: f64) -> NoseGeometry {
        NoseGeometry::from_scene(&scene_with(&format!("theta={degrees}deg")))
    }

    /// Projected area by counting points of the disk whose surface point lies behind the face. The face's height over the sphere's
    /// centre is R - p cos; a point of the nose is behind it when its component along the normal is greater. The cylinder behind the
    /// disk reaches back for ever.
    fn brute_force(nose: &NoseGeometry, p: f64) -> f64 {
        let n = 2000;
        let place = |i: u32| 2.0 * (f64::from(i) + 0.5) / f64::from(n) - 1.0;
        let is_behind = |xi: f64, eta: f64| {
            let rest = 1.0 - xi * xi - eta * eta;
            rest >= 0.0
                && xi * nose.sin + rest.sqrt() * nose.cos > 1.0 - p * nose.cos / nose.radius_m
        };
        let points = (0..n).flat_map(|i| (0..n).map(move |j| (place(i), place(j))));
        let count = points.filter(|(xi, eta)| is_behind(*xi, *eta)).count();
        count as f64 * (2.0 * nose.radius_m / f64::from(n)).powi(2)
    }

    #[test]
    fn valid_the_slope_of_an_oblique_area_is_a_difference_of_areas() {
        for degrees in [5.0, 30.0, 70.0] {
            let nose = nose(degrees);
            for part in [0.1, 0.5, 0.99, 1.01, 1.2, 1.5, 1.9] {
                let (p, width) = (part * nose.cap_end_m(), 1e-6 * nose.radius_m);
                let rise = nose.area_m2(p + width) - nose.area_m2(p - width);
                let (slope, expected) = (nose.slope_m(p), rise / (2.0 * width));
                assert!((slope - expected).abs() < 1e-6 * nose.radius_m, "{degrees} {part}");
            }
        }
    }

    #[test]
    fn valid_oblique_area_equals_the_brute_force_projection() {
        for degrees in [15.0, 30.0, 45.0] {
            let nose = nose(degrees);
            for part in [0.2, 0.5, 0.8, 1.0, 1.2, 1.5, 1.9] {
                let p = part * nose.cap_end_m();
                let (area, counted) = (nose.area_m2(p), brute_force(&nose, p));
                let full = PI * nose.radius_m * nose.radius_m;
                assert!((area - counted).abs() < 2e-4 * full, "{degrees} {part}: {area} {counted}");
            }
        }
    }

    #[test]
    fn area_is_continuous_at_the_joints_and_full_beyond() {
        for degrees in [1e-3, 1.0, 15.0, 45.0, 85.0] {
            let nose = nose(degrees);
            let full = PI * nose.radius_m * nose.radius_m;
            for joint in [nose.cap_end_m(), nose.full_from_m()] {
                let width = nose.full_from_m() - nose.cap_end_m();
                for shift in [2.0 * JOINT, 1e-9] {
                    let (a, b) = (joint - shift * width, joint + shift * width);
                    let jump = (nose.area_m2(b) - nose.area_m2(a)).abs();
                    assert!(jump < 10.0 * shift * full + 1e-11 * full, "{degrees}: {jump}");
                }
            }
            assert!((nose.area_m2(nose.full_from_m()) - full).abs() < 1e-11 * full);
        }
    }

    #[test]
    fn valid_swept_volume_of_the_passage_is_thickness_times_section_without_dishing() {
        // Entry and exit together sweep pi R² h_e whatever the nose and the obliquity.
        for pairs in ["", "h=0.003", "theta=30deg", "theta=60deg h=0.004"] {
            let geometry = Geometry::from_scene(&scene_with(&format!("dishing=off {pairs}")));
            let swept = geometry.swept_m3(geometry.exit_m);
            let exact = PI * 0.00635f64.powi(2) * geometry.thickness_m;
            assert!((swept / exact - 1.0).abs() < 1e-11, "{pairs}: {swept} {exact}");
        }
    }

    #[test]
    fn travel_has_its_inverses_in_depth_and_in_volume() {
        for pairs in ["", "theta=25deg"] {
            let geometry = Geometry::from_scene(&scene_with(pairs));
            for part in [1e-6, 0.1, 0.3, geometry.bend_m / geometry.exit_m, 0.7, 0.99] {
                let q = part * geometry.exit_m;
                assert!((geometry.travel_m(geometry.depth_m(q)) / q - 1.0).abs() < 1e-14);
                let back = geometry.travel_at_volume_m(geometry.swept_m3(q)).unwrap();
                assert!((back / q - 1.0).abs() < 1e-12, "{part}: {back} {q}");
            }
            for q in [-0.001, 0.0, 0.01, geometry.bend_m, 0.05] {
                assert!((geometry.travel_m(geometry.depth_m(q)) - q).abs() < 1e-16);
            }
            assert!((geometry.depth_m(geometry.bend_m) - geometry.thickness_m).abs() < 1e-17);
            assert_eq!(geometry.travel_at_volume_m(1.0), None);
        }
    }

    #[test]
    fn area_of_the_pieces_is_the_area_of_the_faces() {
        for pairs in ["", "h=0.003", "theta=20deg h=0.003", "theta=50deg"] {
            let geometry = Geometry::from_scene(&scene_with(pairs));
            for i in 0..1000 {
                let q = (f64::from(i) + 0.5) / 1000.0 * geometry.exit_m;
                let p = geometry.depth_m(q);
                let faces =
                    geometry.nose.area_m2(p) - geometry.nose.area_m2(p - geometry.thickness_m);
                let difference = (geometry.area_m2(q) - faces).abs();
                assert!(difference < 1e-15, "{pairs} {q}: {difference}");
            }
        }
    }
}
