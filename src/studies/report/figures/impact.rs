//! Drawing of an impact at a given time: projectile, hole, plate, spring, damper, stop and mount to one scale.
//!
//! A [`Stage`] fixes the scale for a part of a run, so that bodies move and the view does not. A [`Picture`] is the state of the run at a
//! time, as areas and lines in metres. Does not depend on the terminal.

use std::f64::consts::PI;

use crate::report::series::state_at;
use crate::report::steps::{decade, power};
use cmra_engine::model::contact::Geometry;
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::plug::Plug;
use cmra_engine::model::run::{ContactMode, EventKind, Run, Sample};
use cmra_engine::model::scene::{ContactModel, Scene};
use cmra_engine::model::stack;
use cmra_engine::model::units::{engineering, significant};
use cmra_engine::numerics::{larger, smaller};

/// Maximum length of a projectile that is drawn whole, in tip radii.
const WHOLE: f64 = 10.0;
/// Space behind the plate for the mechanism, relative to projectile and plate.
const ROOM: f64 = 0.35;
/// Displacement above which it is drawn reduced, relative to projectile, plate and space.
const FAR: f64 = 2.0;
/// Fraction of the width for a displacement that is drawn reduced or magnified.
const FAR_PART: f64 = 0.4;
const NEAR_PART: f64 = 0.06;
/// Displacement below which it is drawn magnified, in dots.
const NEAR_DOTS: f64 = 0.75;
/// Minimum magnification of a displacement.
const NEAR_LEAST: f64 = 5.0;
/// Minimum height of the picture, in tip radii.
const HEIGHT: f64 = 3.2;
/// Minimum drawn thickness of a plate, in dots.
const THIN_DOTS: f64 = 2.0;
/// Half height of a plate on a rigid mount, in heights of the picture.
const ENDLESS: f64 = 2.0;
/// Maximum number of plates drawn behind the first.
const BEHIND: usize = 3;
/// Fraction of the width for the plates behind the first.
const BEHIND_PART: f64 = 0.25;
/// Width of the mount, in dots.
const MOUNT_DOTS: f64 = 4.0;
/// Line segments of a nose's quarter circle.
const ARC: u32 = 8;
/// Coils of the drawn spring.
pub const COILS: u32 = 8;

/// Horizontal and vertical position, m.
pub type Place = (f64, f64);

/// Bodies of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Neutral position of the plate's front (no spring force).
    Neutral,
    /// Further plates of a stack.
    Behind,
    /// Plate of the run.
    Plate,
    /// Hole in the plate; erases the plate only.
    Hole,
    /// Stop of the plate.
    Stop,
    /// Support of spring, damper and stop; of the plate on a rigid mount.
    Mount,
    /// Springs, drawn as one.
    Spring,
    /// Damper of the plate.
    Damper,
    /// Projectile, drawn as steel.
    Projectile,
    /// Plug that a perforating projectile drives out.
    Plug,
}

/// Shape of a body or part of a body.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Filled polygon.
    Area(Part, Vec<Place>),
    /// Vertical line at a horizontal position, over the whole height.
    Wall(Part, f64),
    /// Spring between two positions, with this half width, m.
    Coils(Place, Place, f64),
    /// Damper between two positions, with this half width, m. The rod ends at the third horizontal position; the cylinder begins at the
    /// fourth.
    Dashpot(Place, Place, f64, [f64; 2]),
}

/// Size of a picture in dots, and the aspect ratio of a dot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dots {
    /// Number of dots, horizontally.
    pub across: f64,
    /// Number of dots, vertically.
    pub down: f64,
    /// Height of a dot over its width.
    pub aspect: f64,
}

/// Scale of the pictures for a part of a run.
#[derive(Clone, Debug)]
pub struct Stage<'a> {
    run: &'a Run,
    mechanism: Mechanism,
    dots: Dots,
    /// Width of a dot, m.
    pub dot_m: f64,
    /// Left edge, m.
    pub left_m: f64,
    /// Upper edge, m.
    pub top_m: f64,
    /// Drawn over true displacement of the plate.
    pub magnified: f64,
    /// Drawn over true thickness of the plate.
    pub thickened: f64,
    /// Drawn and true length of the projectile, m.
    lengths_m: (f64, f64),
    mount_m: Option<f64>,
    stop_m: Option<f64>,
    /// Minimum and maximum distance between the plate's rear face and the mount, m.
    gaps_m: (f64, f64),
    /// Notes on parts that are not to scale.
    pub notes: Vec<String>,
}

/// Drawing at a time; later shapes cover earlier ones.
pub type Picture = Vec<Shape>;

/// Returns the length of a steel projectile with the run's mass and radius, nose included, m.
pub fn projectile_length_m(run: &Run) -> f64 {
    let shot = &run.scene.projectile;
    let radius_m = shot.tip_radius_m;
    let (all_m3, section_m2) = (shot.mass_kg / shot.density_kg_m3, PI * radius_m * radius_m);
    if shot.nose.shears() {
        return all_m3 / section_m2;
    }
    let nose_m3 = 2.0 / 3.0 * PI * radius_m.powi(3);
    radius_m + larger(all_m3 - nose_m3, 0.0) / section_m2
}

/// Rounds down to 1, 2 or 5 times a power of ten.
fn round_below(value: f64) -> f64 {
    let decade = power(decade(value));
    [5.0, 2.0].into_iter().map(|digit| digit * decade).find(|it| *it <= value).unwrap_or(decade)
}

impl<'a> Stage<'a> {
    /// Creates the stage for a run up to a time, s; `None` without a series.
    pub fn from_run(run: &'a Run, end_s: f64, dots: Dots) -> Option<Self> {
        let scene = &*run.scene;
        let mechanism = Mechanism::from_scene(scene);
        let (cos, sin) = (scene.cos_obliquity(), scene.projectile.obliquity_deg.to_radians().sin());
        let (radius_m, thick_m) = (scene.projectile.tip_radius_m, scene.target.thickness_m);
        let length_m = projectile_length_m(run);
        let shown_m = smaller(length_m, WHOLE * radius_m);
        let last = state_at(run, end_s)?;
        let rows = run.series.iter().take_while(|row| row.t_s <= end_s).chain([&last]);
        let displacements = rows.map(|row| row.plate_displacement_m);
        let (mut low_m, mut high_m) = (scene.start_m(), scene.start_m());
        for x_m in displacements.filter(|x_m| x_m.is_finite()) {
            (low_m, high_m) = (smaller(low_m, x_m), larger(high_m, x_m));
        }
        let across_m = shown_m * cos + radius_m * sin;
        let stop_m = mechanism.stop.map(|_| scene.mechanism.stop.position_m).unwrap_or_default();
        let near_m = 3.0 * larger(across_m + thick_m, high_m - low_m);
        let stop_m = stop_m.filter(|stop_m| *stop_m - high_m <= near_m);
        let far_stop = mechanism.stop.is_some() && stop_m.is_none();
        high_m = larger(high_m, stop_m.unwrap_or(high_m));
        let has_mechanism = !mechanism.is_absent() || mechanism.stop.is_some();
        let room_m = if has_mechanism { ROOM * (across_m + thick_m) } else { 3.0 * radius_m };
        let behind = if scene.is_stack() { 1.0 - BEHIND_PART } else { 1.0 };
        let width = dots.across * behind - MOUNT_DOTS - 2.0;
        let (bodies_m, travel_m) = (across_m + thick_m + room_m, high_m - low_m);
        let up_m = larger(HEIGHT / 2.0 * radius_m, 0.75 * shown_m * sin + radius_m * cos);
        let down_m = larger(HEIGHT / 2.0 * radius_m, radius_m * cos + thick_m * sin / cos);
        let least_m = (up_m + down_m) / (dots.down * dots.aspect);
        let mut dot_m = larger((bodies_m + travel_m) / width, least_m);
        let mut magnified = 1.0;
        if travel_m > FAR * bodies_m {
            dot_m = larger(bodies_m / ((1.0 - FAR_PART) * width), least_m);
            magnified = smaller(1.0, round_below(FAR_PART * width * dot_m / travel_m));
        } else if travel_m > 0.0 && travel_m < NEAR_DOTS * dot_m {
            dot_m = larger(bodies_m / ((1.0 - NEAR_PART) * width), least_m);
            magnified = round_below(NEAR_PART * width * dot_m / travel_m);
            // A small magnification shows no more than the true scale.
            if magnified < NEAR_LEAST {
                magnified = 1.0;
            }
        }
        let thickened = larger(1.0, THIN_DOTS * dot_m / thick_m);
        let thick_m = thickened * thick_m;
        // The remaining width is space for the mechanism; without one, half of it is in front of the projectile.
        let needed_m = across_m + thick_m + magnified * travel_m;
        let is_held = !scene.is_sprung();
        let spare_m = larger(width * dot_m - needed_m - room_m, 0.0);
        let over_m = if is_held || !has_mechanism { spare_m } else { 0.0 };
        let left_m = magnified * low_m - across_m - dot_m - 0.5 * over_m;
        let mount_m = if is_held {
            Some(thick_m)
        } else {
            has_mechanism.then_some(left_m + (width + 2.0) * dot_m)
        };
        let gap_m = |x_m: f64| mount_m.unwrap_or(0.0) - (magnified * x_m + thick_m);
        let mut stage = Self {
            run,
            mechanism,
            dots,
            dot_m,
            left_m,
            top_m: 0.5 * dots.down * dots.aspect * dot_m + 0.5 * (up_m - down_m),
            magnified,
            thickened,
            lengths_m: (shown_m, length_m),
            mount_m,
            stop_m,
            gaps_m: (gap_m(high_m), gap_m(low_m)),
            notes: Vec::new(),
        };
        stage.notes = stage.off_scale(far_stop);
        Some(stage)
    }

    fn off_scale(&self, far_stop: bool) -> Vec<String> {
        let times = |factor: f64| match factor {
            ..1.0 => format!("at 1/{}", significant(1.0 / factor, 2)),
            ..1e6 => format!("{} times", significant(factor, 2)),
            _ => format!("{factor:.0e} times"),
        };
        let (shown_m, length_m) = self.lengths_m;
        let mut notes = Vec::new();
        if self.magnified.to_bits() != 1f64.to_bits() {
            notes.push(format!("displacement drawn {}", times(self.magnified)));
        }
        if self.thickened > 1.0 {
            notes.push(format!("thickness drawn {}", times(self.thickened)));
        }
        if shown_m < length_m {
            notes.push(format!("projectile {} long, cut", engineering(length_m, "m", 3)));
        }
        if far_stop {
            notes.push("stop beyond the picture".to_owned());
        }
        if self.run.scene.is_sprung() && self.mount_m.is_none() {
            notes.push("nothing holds the plate".to_owned());
        }
        if self.run.scene.is_stack() {
            notes.push("the plates behind are not to scale".to_owned());
        }
        notes
    }

    fn thick_m(&self) -> f64 {
        self.thickened * self.run.scene.target.thickness_m
    }

    /// Converts a true depth to the drawn depth, m; the depths of a plate that is drawn thicker stay inside it.
    fn depth_m(&self, depth_m: f64) -> f64 {
        let whole_m = self.run.scene.effective_thickness_m();
        let more_m = (self.thickened - 1.0) * whole_m;
        if !depth_m.is_finite() {
            0.0
        } else if depth_m <= 0.0 {
            -gap_m(&self.run.scene, depth_m)
        } else if depth_m < whole_m {
            depth_m * self.thickened
        } else {
            depth_m + more_m
        }
    }

    /// Returns the drawing of a state.
    pub fn picture(&self, state: &Sample) -> Picture {
        let scene = &*self.run.scene;
        let front_m = self.magnified * state.plate_displacement_m;
        let rear_m = front_m + self.thick_m();
        let height_m = self.dots.down * self.dots.aspect * self.dot_m;
        let (top_m, bottom_m) = (self.top_m, self.top_m - height_m);
        let half_m =
            if scene.is_sprung() { 0.5 * scene.plate_face_m() } else { ENDLESS * height_m };
        let seen_m = smaller(half_m, smaller(top_m, -bottom_m));
        let block = |part, (left, right): (f64, f64), half: f64| {
            Shape::Area(part, vec![(left, -half), (right, -half), (right, half), (left, half)])
        };
        let mut shapes = Vec::new();
        if scene.is_sprung() && !self.mechanism.spring.is_absent() {
            shapes.push(Shape::Wall(Part::Neutral, 0.0));
        }
        self.behind(&mut shapes);
        shapes.push(block(Part::Plate, (front_m, rear_m), half_m));
        let deepest_m = self.deepest_m(state);
        if deepest_m > 0.0 {
            let tip_m = self.depth_m(deepest_m);
            shapes
                .push(Shape::Area(Part::Hole, self.nosed(front_m, tip_m, tip_m + self.thick_m())));
        }
        if let Some(mount_m) = self.mount_m {
            if let Some(stop_m) = self.stop_m {
                let at_m = self.magnified * stop_m + self.thick_m();
                shapes.push(block(Part::Stop, (at_m, mount_m), 0.25 * seen_m));
            }
            shapes.push(Shape::Wall(Part::Mount, mount_m));
            let (y_m, wide_m) = (0.6 * seen_m, 0.2 * seen_m);
            if !self.mechanism.spring.is_absent() {
                shapes.push(Shape::Coils((rear_m, y_m), (mount_m, y_m), wide_m));
            }
            if !self.mechanism.damper.is_absent() {
                shapes.push(self.dashpot(rear_m, mount_m, -y_m, wide_m));
            }
        }
        let tip_m = self.depth_m(state.penetration_m);
        self.plug(&mut shapes, state, front_m, tip_m);
        shapes.push(Shape::Area(Part::Projectile, self.nosed(front_m, tip_m, self.lengths_m.0)));
        shapes
    }

    /// Returns the outline of a body with the projectile's nose, for a tip depth and a length, m.
    fn nosed(&self, front_m: f64, tip_m: f64, length_m: f64) -> Vec<Place> {
        let scene = &*self.run.scene;
        let radius_m = scene.projectile.tip_radius_m;
        let (sin, cos) = scene.projectile.obliquity_deg.to_radians().sin_cos();
        let is_flat = scene.projectile.nose.shears();
        let arc = (0..=2 * ARC).map(|step| {
            let angle = PI * (f64::from(step) / f64::from(2 * ARC) - 0.5);
            let behind_m = if is_flat { 0.0 } else { radius_m * (1.0 - angle.cos()) };
            (-behind_m, radius_m * angle.sin())
        });
        let length_m = larger(length_m, radius_m);
        let is_cut = self.lengths_m.0 < self.lengths_m.1;
        let notch_m = if is_cut { 0.4 * radius_m } else { 0.0 };
        let tail = [(1.0, 0.0), (1.0 / 3.0, 1.0), (-1.0 / 3.0, 0.0), (-1.0, 1.0)];
        let tail = tail.map(|(part, notch)| (notch * notch_m - length_m, part * radius_m));
        let along = arc.chain(tail);
        // The axis points to the right and down.
        along
            .map(|(u, v)| {
                let u = u + tip_m;
                (front_m + u * cos + v * sin, v * cos - u * sin)
            })
            .collect()
    }

    /// Returns the maximum depth up to the time of a state, m; thickness plus nose length after a perforation.
    fn deepest_m(&self, state: &Sample) -> f64 {
        let rows = self.run.series.iter().take_while(|row| row.t_s <= state.t_s);
        rows.map(|row| row.penetration_m).fold(state.penetration_m, larger)
    }

    /// Draws the plug in front of a projectile that has driven one out.
    fn plug(&self, shapes: &mut Picture, state: &Sample, front_m: f64, tip_m: f64) {
        let event = self.run.events.iter().find(|event| event.kind == EventKind::Plug);
        if !event.is_some_and(|event| event.t_s <= state.t_s) {
            return;
        }
        let scene = &*self.run.scene;
        let Some(plug) = Plug::from_scene(scene) else { return };
        let radius_m = 0.5 * plug.diameter_m;
        let (sin, cos) = scene.projectile.obliquity_deg.to_radians().sin_cos();
        let ends = [tip_m, tip_m + self.thickened * plug.thickness_m];
        let corners = [(ends[0], -1.0), (ends[1], -1.0), (ends[1], 1.0), (ends[0], 1.0)];
        let place = |(u, side): (f64, f64)| {
            let v = side * radius_m;
            (front_m + u * cos + v * sin, v * cos - u * sin)
        };
        shapes.push(Shape::Area(Part::Plug, corners.map(place).to_vec()));
    }

    /// Draws the damper; the rod enters the cylinder as the plate approaches.
    fn dashpot(&self, rear_m: f64, mount_m: f64, y_m: f64, wide_m: f64) -> Shape {
        let (least_m, most_m) = self.gaps_m;
        let cylinder_m = mount_m - larger(0.55 * least_m, 2.0 * self.dot_m);
        let part = (mount_m - rear_m - least_m) / larger(most_m - least_m, self.dot_m);
        let inside_m = mount_m - cylinder_m;
        let rod_m = cylinder_m + (0.85 - 0.7 * part.clamp(0.0, 1.0)) * inside_m;
        Shape::Dashpot((rear_m, y_m), (mount_m, y_m), wide_m, [rod_m, cylinder_m])
    }

    /// Draws the further plates of a stack, equally spaced behind the mount.
    fn behind(&self, shapes: &mut Picture) {
        if !self.run.scene.is_stack() {
            return;
        }
        let plates = stack::plates(&self.run.scene);
        let count = plates.len().saturating_sub(1).min(BEHIND);
        let from_m = self.left_m + self.dots.across * (1.0 - BEHIND_PART) * self.dot_m;
        let each_m = self.dots.across * BEHIND_PART * self.dot_m / count.max(1) as f64;
        let height_m = self.dots.down * self.dots.aspect * self.dot_m;
        for (at, plate) in plates.iter().skip(1).take(count).enumerate() {
            let left_m = from_m + (at as f64 + 0.3) * each_m;
            let thick_m = larger(plate.target.thickness_m, THIN_DOTS * self.dot_m);
            let right_m = left_m + smaller(thick_m, 0.5 * each_m);
            let half_m =
                if plate.is_sprung() { 0.5 * plate.plate_face_m() } else { ENDLESS * height_m };
            let corners =
                [(left_m, -half_m), (right_m, -half_m), (right_m, half_m), (left_m, half_m)];
            shapes.push(Shape::Area(Part::Behind, corners.to_vec()));
        }
    }

    /// Returns the gap between plate and projectile, if that is beyond the left edge of the drawing, m.
    pub fn beyond_m(&self, state: &Sample) -> Option<f64> {
        let tip_m = self.magnified * state.plate_displacement_m + self.depth_m(state.penetration_m);
        (tip_m < self.left_m).then(|| gap_m(&self.run.scene, state.penetration_m))
    }
}

/// Returns the gap between plate and nose at a negative depth, m: the travel, since nothing dishes in front of the plate.
pub fn gap_m(scene: &Scene, depth_m: f64) -> f64 {
    -Geometry::from_scene(scene).travel_m(depth_m)
}

/// Describes a contact mode in a few words.
pub fn mode_words(scene: &Scene, mode: ContactMode) -> &'static str {
    let has_friction = scene.contact.model == ContactModel::Hydrodynamic;
    match mode {
        ContactMode::Withdrawing if !has_friction => "pushed apart",
        ContactMode::Penetrating => "penetrating",
        ContactMode::Fused => "moving together",
        ContactMode::Withdrawing => "being pulled out",
        ContactMode::FreeFlight => "apart",
        ContactMode::Closing => "going back in",
        ContactMode::Perforated => "through",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::testing::run_of;

    const DOTS: Dots = Dots { across: 156.0, down: 28.0, aspect: 1.0 };

    fn corners(picture: &Picture, part: Part) -> Vec<Place> {
        let of_part = |shape: &Shape| match shape {
            Shape::Area(one, corners) if *one == part => Some(corners.clone()),
            _ => None,
        };
        picture.iter().find_map(of_part).unwrap_or_default()
    }

    fn ends(places: &[Place]) -> (f64, f64) {
        let across = places.iter().map(|place| place.0);
        (across.clone().fold(f64::INFINITY, smaller), across.fold(f64::NEG_INFINITY, larger))
    }

    fn stage(run: &Run, end_s: f64) -> Stage<'_> {
        Stage::from_run(run, end_s, DOTS).unwrap()
    }

    fn is_near(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9
    }

    /// 29.5 g of steel are 3.758 cm³: a half sphere of 0.5363 cm³, and 3.2217 cm³ over 1.2668 cm², which is 25.43 mm.
    #[test]
    fn valid_a_projectile_is_as_long_as_its_mass_of_steel() {
        assert!((projectile_length_m(&run_of("")) - 31.78e-3).abs() < 1e-5);
        // A steel sphere of the same radius has 8.42 g. A lighter projectile is drawn as a half sphere.
        assert!(is_near(projectile_length_m(&run_of("m_p=2g")), 6.35e-3));
    }

    #[test]
    fn valid_bodies_stand_where_the_state_has_them() {
        for (text, end_s) in
            [("", 120e-6), ("mount=rigid", 200e-6), ("x_stop=5mm", 400e-6), ("b=300", 150e-6)]
        {
            let run = run_of(text);
            let stage = stage(&run, end_s);
            assert_eq!(stage.notes, Vec::<String>::new(), "{text}");
            for part in 1..=8 {
                let state = state_at(&run, end_s * f64::from(part) / 8.0).unwrap();
                let picture = stage.picture(&state);
                let (front_m, rear_m) = ends(&corners(&picture, Part::Plate));
                let (tail_m, tip_m) = ends(&corners(&picture, Part::Projectile));
                assert!(is_near(front_m, state.plate_displacement_m), "{text}");
                assert!(is_near(rear_m - front_m, 25.4e-3), "{text}");
                assert!(is_near(tip_m - front_m, state.penetration_m), "{text}");
                assert!(is_near(tip_m - tail_m, projectile_length_m(&run)), "{text}");
                let (_, hole_m) = ends(&corners(&picture, Part::Hole));
                assert!(hole_m >= tip_m - 1e-12, "{text}");
                // All bodies are inside the picture at every time.
                let right_m = stage.left_m + DOTS.across * stage.dot_m;
                assert!(tail_m >= stage.left_m && rear_m <= right_m, "{text}");
            }
        }
    }

    /// At 30 degrees the tip of a depth p is p cos 30 behind the front face and p sin 30 below the point of entry.
    #[test]
    fn valid_an_oblique_projectile_lies_along_its_line() {
        let run = run_of("theta=30deg");
        let state = state_at(&run, 100e-6).unwrap();
        let picture = stage(&run, 150e-6).picture(&state);
        let nose = corners(&picture, Part::Projectile)[8];
        let (sin, cos) = 30f64.to_radians().sin_cos();
        let depth_m = state.penetration_m;
        assert!(is_near(nose.0, state.plate_displacement_m + depth_m * cos));
        assert!(is_near(nose.1, -depth_m * sin));
    }

    #[test]
    fn a_gap_is_seen_and_a_perforating_nose_comes_out() {
        let run = run_of("h=6.35mm v_i=300");
        let exit_s = run.departure.exit_time_s.unwrap();
        let stage = stage(&run, 1.1 * exit_s);
        let state = state_at(&run, exit_s).unwrap();
        let picture = stage.picture(&state);
        let (_, rear_m) = ends(&corners(&picture, Part::Plate));
        let (_, tip_m) = ends(&corners(&picture, Part::Projectile));
        assert!((tip_m - rear_m - 6.35e-3).abs() < 1e-5);
        let apart = Sample { penetration_m: -4e-3, ..state };
        let picture = stage.picture(&apart);
        let (front_m, _) = ends(&corners(&picture, Part::Plate));
        let (_, tip_m) = ends(&corners(&picture, Part::Projectile));
        // Dishing takes two thirds of the travel in the hole, none in front of it.
        assert!(is_near(front_m - tip_m, 12e-3));
    }

    /// Notes name dimensions that are too small or too large for the scale; each has at least one dot.
    #[test]
    fn what_is_not_to_scale_says_so() {
        for (text, end_s, word) in [
            ("n=0.1", 2e-3, "displacement drawn"),
            ("d=0.5 k=1e5", 5e-3, "displacement drawn at 1/"),
            ("h=0.01mm", 5e-5, "thickness drawn"),
            ("m_p=2", 1e-3, "cut"),
            ("x_stop=5", 1e-4, "stop beyond"),
        ] {
            let run = run_of(text);
            let stage = stage(&run, end_s);
            assert!(
                stage.notes.iter().any(|note| note.contains(word)),
                "{text}: {:?}",
                stage.notes
            );
            let (mut low_m, mut high_m) = (f64::INFINITY, f64::NEG_INFINITY);
            for part in 0..=20 {
                let state = state_at(&run, end_s * f64::from(part) / 20.0).unwrap();
                let (front_m, rear_m) = ends(&corners(&stage.picture(&state), Part::Plate));
                assert!(rear_m - front_m >= THIN_DOTS * stage.dot_m * (1.0 - 1e-9), "{text}");
                (low_m, high_m) = (smaller(low_m, front_m), larger(high_m, front_m));
            }
            if word.contains("displacement") {
                assert!(high_m - low_m >= stage.dot_m, "{text}");
                assert!(high_m - low_m <= 0.5 * DOTS.across * stage.dot_m, "{text}");
            }
        }
    }

    /// The plug is the rest of the plate in front of the nose, at most 1.35 diameters; here the whole thickness, 6.35 mm. It moves ahead of
    /// a flat nose.
    #[test]
    fn valid_a_plug_stands_before_a_flat_nose_and_is_as_thick_as_its_law_has_it() {
        let alloy = "nose=blunt closure=cylindrical rho=2700 Y=276MPa UTS=310MPa E=68.3GPa";
        for (size, thick_m) in [("h=6.35mm v_i=300", 6.35e-3), ("h=25.4mm v_i=600", 17.145e-3)] {
            let run = run_of(&format!("mount=rigid {alloy} {size}"));
            let event = run.events.iter().find(|event| event.kind == EventKind::Plug).unwrap();
            let end_s = run.series.last().unwrap().t_s;
            let state = state_at(&run, 0.5 * (event.t_s + end_s)).unwrap();
            let stage = stage(&run, end_s);
            let picture = stage.picture(&state);
            let shot = corners(&picture, Part::Projectile);
            let (plug, tip_m) = (ends(&corners(&picture, Part::Plug)), ends(&shot).1);
            assert!(is_near(plug.0, tip_m), "{size}: {plug:?} {tip_m}");
            let drawn_m = stage.thickened * thick_m;
            assert!(is_near(plug.1 - plug.0, drawn_m), "{size}: {plug:?}");
            // A flat nose: a whole side lies at the tip.
            let flat = shot.iter().filter(|place| is_near(place.0, tip_m)).map(|place| place.1);
            let (low, high) =
                flat.fold((0.0, 0.0), |(low, high), y| (smaller(low, y), larger(high, y)));
            assert!(is_near(high - low, 12.7e-3), "{size}: {low} {high}");
        }
    }
}
