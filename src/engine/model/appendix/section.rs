//! Depth and engaged area as Appendix A.2 and A.3 print them, in units of the nose radius.
//!
//! The formulas for the section across sphere and cylinder are the thesis's own, with its division by tan(theta); they are kept
//! apart from `contact.rs`, whose rewritten form they check. Knows no motion.

use std::f64::consts::PI;

use crate::model::scene::Scene;

/// Below this obliquity, rad, sphere and cylinder meet in one depth.
const NORMAL_BELOW: f64 = 1e-7;
/// Joints: of the entry face two, the rear face one and again two.
const JOINTS: usize = 5;

/// Which formula a face's section has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Section {
    None,
    Cap,
    Partial,
    Full,
}

/// Both faces of the plate, as the nose passes them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faces {
    /// cos(theta).
    pub cos: f64,
    sin: f64,
    /// h / cos(theta) over R.
    thickness: f64,
    /// Travel taken up by dishing over R.
    lag: f64,
    /// Travel at the end of each piece, rising; the first `count` count.
    ends: [f64; JOINTS],
    count: usize,
}

impl Faces {
    /// The faces of a scene.
    pub fn of(scene: &Scene) -> Self {
        let (sin, cos) = scene.projectile.obliquity_deg.to_radians().sin_cos();
        let thickness = scene.target.thickness_m / cos / scene.projectile.tip_radius_m;
        let lag = if scene.dishing() { 2.0 } else { 0.0 };
        let mut faces = Self { cos, sin, thickness, lag, ends: [0.0; JOINTS], count: 0 };
        let (cap, full) = (faces.cap_end(), faces.full_from());
        let mut depths = [cap, full, thickness, thickness + cap, thickness + full];
        depths.sort_by(f64::total_cmp);
        for depth in depths {
            let end = faces.travel(depth);
            if faces.count == 0 || end > faces.ends[faces.count - 1] * (1.0 + 1e-12) {
                faces.ends[faces.count] = end;
                faces.count += 1;
            }
        }
        faces
    }

    /// Travel at which the nose is clear of the rear face.
    pub fn exit(&self) -> f64 {
        self.ends[self.count - 1]
    }

    /// Depth at a travel.
    pub fn depth(&self, q: f64) -> f64 {
        if q <= self.thickness + self.lag {
            q * (self.thickness / (self.thickness + self.lag))
        } else {
            q - self.lag
        }
    }

    fn travel(&self, depth: f64) -> f64 {
        if depth <= self.thickness {
            depth * (self.thickness + self.lag) / self.thickness
        } else {
            depth + self.lag
        }
    }

    fn cap_end(&self) -> f64 {
        (1.0 - self.sin) / self.cos
    }

    /// Depth from which on the section is that of the whole cylinder.
    pub fn full_from(&self) -> f64 {
        (1.0 + self.sin) / self.cos
    }

    /// Engaged area at a depth.
    pub fn area_at_depth(&self, depth: f64) -> f64 {
        let rear = depth - self.thickness;
        self.section(depth, self.kind(depth)) - self.section(rear, self.kind(rear))
    }

    fn kind(&self, depth: f64) -> Section {
        if depth <= 0.0 {
            Section::None
        } else if depth >= self.full_from() {
            Section::Full
        } else if depth <= self.cap_end() || self.sin < NORMAL_BELOW {
            Section::Cap
        } else {
            Section::Partial
        }
    }

    fn section(&self, depth: f64, kind: Section) -> f64 {
        let cap = || PI * self.cos * self.cos * depth * (2.0 - depth * self.cos);
        match kind {
            Section::None => 0.0,
            Section::Cap => cap(),
            Section::Full => PI,
            Section::Partial => cap() - self.cut(depth) + self.band(depth),
        }
    }

    /// `A1` of Appendix A.2: the part of the ellipse that lies beyond the sphere.
    fn cut(&self, depth: f64) -> f64 {
        let height = 1.0 - depth * self.cos;
        let s = (self.sin.asin() - unit(height).asin()).sin() / self.sin;
        let re = (depth * self.cos * (2.0 - depth * self.cos)).sqrt();
        let chord = (s * (2.0 * re - s)).max(0.0).sqrt();
        (re * re * unit((re - s) / re).acos() - (re - s) * chord) * self.cos
    }

    /// `A2` of Appendix A.2: the part of the circle between its rim and the face.
    fn band(&self, depth: f64) -> f64 {
        let z = depth * self.cos / self.sin - (1.0 / self.sin - 1.0);
        unit(1.0 - z).acos() - (1.0 - z) * (z * (2.0 - z)).max(0.0).sqrt()
    }
}

/// Kept within [-1, 1], which a stage beyond a joint, or rounding, may leave; NaN stays NaN.
fn unit(z: f64) -> f64 {
    z.clamp(-1.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::contact::Geometry;

    fn scene(theta_deg: f64, thickness_m: f64) -> Scene {
        let mut scene = Scene::default();
        scene.projectile.obliquity_deg = theta_deg;
        scene.target.thickness_m = thickness_m;
        scene
    }

    #[test]
    fn the_printed_formulas_give_the_areas_of_the_rewritten_ones() {
        for theta in [0.0, 5.0, 30.0, 60.0, 85.0] {
            for thickness in [0.0254, 0.003, 1e-4] {
                let scene = scene(theta, thickness);
                let (faces, geometry) = (Faces::of(&scene), Geometry::of(&scene));
                let r = scene.projectile.tip_radius_m;
                for i in 1..400 {
                    let q = faces.exit() * f64::from(i) / 400.0;
                    let other = geometry.area_m2(q * r) / (r * r);
                    let area = faces.area_at_depth(faces.depth(q));
                    assert!((area - other).abs() < 1e-8, "{theta} {thickness} {q}: {area} {other}");
                }
                assert!((faces.exit() * r / geometry.exit_m - 1.0).abs() < 1e-14);
            }
        }
    }
}
