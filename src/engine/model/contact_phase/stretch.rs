//! One stretch of the contact phase: the equations between two boundaries, and what follows a boundary.
//!
//! A stretch ends where a formula changes (a joint of the area law, a knot of the spring, the zero of a power law), at the stop,
//! and at arrest. A plate at rest on a rigid stop is held there as long as the contact presses it against the stop. Knows no
//! method.

use super::{Ending, Phase, Refusal};
use crate::model::mechanism::stop::{self, Hit};
use crate::model::scene::{Stop as StopOfScene, StopKind};
use crate::numerics::smaller;
use crate::numerics::stepper::{Boundary, Reached, StopReason, System};

/// The meaning of the boundary with this index.
const ARREST: usize = 0;
const JOINT: usize = 1;
const STOP: usize = 2;
const PLATE_ZERO: usize = 3;
const SPEED_ZERO: usize = 4;
const KNOT_BELOW: usize = 5;
const KNOT_ABOVE: usize = 6;
const PRESSED: usize = 7;
const BOUNDARIES: usize = 8;

/// A boundary that is never met.
const NEVER: Boundary<4> = Boundary { offset: 1.0, slope: [0.0; 4] };

/// Tolerance with which a plate comes to rest on its rigid stop.
const STOP_TOLERANCE: f64 = 1e-9;
/// How many times the rounding that the rule of the rigid stop allows for is allowed for here.
const ROUNDINGS: f64 = 4.0;
const PLACE_ROUNDING: f64 = ROUNDINGS * stop::HEIGHT_ROUNDING;

/// A stop, with stiffness and damping in scaled units, and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wall {
    x: f64,
    stop: StopOfScene,
}

impl Wall {
    /// The stop of a scene whose units of length, velocity and force are given; nothing without one.
    pub(super) fn of(stop: &StopOfScene, r: f64, v: f64, unit_n: f64) -> Option<Self> {
        let scaled = StopOfScene {
            stiffness_n_m: stop.stiffness_n_m * r / unit_n,
            damping_n_s_m: stop.damping_n_s_m * v / unit_n,
            ..*stop
        };
        stop.position_m.map(|x| Self { x: x / r, stop: scaled })
    }

    fn is_elastic(&self) -> bool {
        self.stop.kind == StopKind::Elastic
    }

    /// The force of an elastic stop (or, times -1, the force missing until it pushes again); 0 for a rigid one.
    fn force(&self, sign: f64) -> Boundary<4> {
        if !self.is_elastic() {
            return NEVER;
        }
        let StopOfScene { stiffness_n_m, damping_n_s_m, .. } = self.stop;
        let slope = [0.0, 0.0, sign * stiffness_n_m, sign * damping_n_s_m];
        Boundary { offset: -sign * stiffness_n_m * self.x, slope }
    }
}

/// The stop or air behind the plate.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Behind {
    /// Nothing.
    Room,
    /// A rigid stop it rests on, with this engaged area at the beginning of the stretch.
    Held(f64),
    /// An elastic stop it presses on.
    Pressed,
}

/// A stretch of the phase.
pub struct Stretch<'a> {
    pub(super) phase: &'a Phase,
    /// Whether events are located, and formulas kept to up to them.
    located: bool,
    /// The piece of the area law to stay on, or to look up each time.
    pub(super) piece: Option<usize>,
    /// The stretch of the spring's curve to stay on, or to look up each time.
    region: Option<usize>,
    behind: Behind,
    boundaries: [Boundary<4>; BOUNDARIES],
}

impl<'a> Stretch<'a> {
    pub(super) fn first(phase: &'a Phase, located: bool) -> Self {
        let curve = phase.spring.law.curve().filter(|_| located && !phase.rigid);
        let region = curve.map(|curve| curve.region(phase.start_x * phase.spring.length));
        let piece = located.then_some(0);
        let behind = Behind::Room;
        let mut stretch =
            Self { phase, located, piece, region, behind, boundaries: [NEVER; BOUNDARIES] };
        stretch.watch_knots();
        stretch.boundaries[ARREST] = plane(0.0, 1, 1.0);
        stretch.watch_joint();
        stretch.watch_stop();
        if let Some(wall) = phase.wall.filter(|wall| phase.start_x >= wall.x) {
            stretch.press_on(wall, 0.0);
        }
        if located && !phase.rigid {
            let side = if phase.start_x < 0.0 { -1.0 } else { 1.0 };
            if phase.spring.law.power().is_some_and(|law| !law.is_smooth_at_zero()) {
                stretch.boundaries[PLATE_ZERO] = plane(0.0, 2, side);
            }
            stretch.watch_speed(1.0);
        }
        stretch
    }

    fn watch_knots(&mut self) {
        let Some(region) = self.region else { return };
        let spring = &self.phase.spring;
        let (low, high) = spring.law.ends(region);
        let knot = |end_m: f64, weight: f64| {
            let end = end_m / spring.length;
            if end.is_finite() { plane(-weight * end, 2, weight) } else { NEVER }
        };
        (self.boundaries[KNOT_BELOW], self.boundaries[KNOT_ABOVE]) =
            (knot(low, 1.0), knot(high, -1.0));
    }

    fn watch_joint(&mut self) {
        let faces = &self.phase.faces;
        let end = self.piece.map_or_else(|| faces.exit(), |piece| faces.piece_end(piece));
        self.boundaries[JOINT] = plane(end, 0, -1.0);
    }

    /// The stop ahead of a plate that has room.
    fn watch_stop(&mut self) {
        self.boundaries[STOP] = self.phase.wall.map_or(NEVER, |wall| plane(wall.x, 2, -1.0));
    }

    fn watch_speed(&mut self, way: f64) {
        if self.located && !self.phase.damper.is_smooth_at_zero() {
            self.boundaries[SPEED_ZERO] = plane(0.0, 3, 1f64.copysign(way));
        }
    }

    /// A plate that has left its stop: one that returns within a single step would not be seen but for its turn.
    fn watch_turn(&mut self) {
        self.boundaries[SPEED_ZERO] = plane(0.0, 3, -1.0);
    }

    /// The plate rests on a rigid stop, or presses on an elastic one, from a travel on.
    fn press_on(&mut self, wall: Wall, q: f64) {
        // An elastic one is left where its force has come down to zero.
        self.boundaries[STOP] = wall.force(1.0);
        self.behind = if wall.is_elastic() {
            Behind::Pressed
        } else {
            Behind::Held(self.phase.faces.area(q, self.piece))
        };
        self.boundaries[PRESSED] = NEVER;
    }

    /// The transition at the end of a stretch: an ending, or (`None`) the next stretch.
    pub(super) fn follow(&mut self, reached: &mut Reached<4>) -> Result<Option<Ending>, Refusal> {
        self.must_have_been_held(&reached.y)?;
        match reached.stop {
            StopReason::Boundary(ARREST) => return Ok(Some(Ending::Arrest)),
            StopReason::Boundary(JOINT) => {
                let next = self.piece.map(|piece| piece + 1);
                match next.filter(|next| *next < self.phase.faces.pieces()) {
                    None => return Ok(Some(Ending::Perforation)),
                    next => self.piece = next,
                }
                self.watch_joint();
                if let Behind::Held(area) = &mut self.behind {
                    *area = self.phase.faces.area(reached.y[0], self.piece);
                }
            }
            StopReason::Boundary(STOP) => self.meet_or_leave_stop(reached),
            StopReason::Boundary(PRESSED) => {
                self.boundaries[PRESSED] = NEVER;
                // Within rounding of the stop's place its own boundary would not be seen to fall.
                let beyond =
                    |wall: &Wall| reached.y[2] - wall.x >= -PLACE_ROUNDING * (1.0 + wall.x.abs());
                if let Some(wall) = self.phase.wall.filter(beyond) {
                    self.press_on(wall, reached.y[0]);
                }
            }
            StopReason::Boundary(PLATE_ZERO) => {
                self.boundaries[PLATE_ZERO].slope[2] = 1f64.copysign(reached.y[3]);
            }
            StopReason::Boundary(SPEED_ZERO) => {
                let ahead = self.rate(&reached.y)[3];
                self.boundaries[SPEED_ZERO] = NEVER;
                self.watch_speed(ahead);
            }
            StopReason::Boundary(KNOT_ABOVE) => {
                self.region = self.region.map(|region| region + 1);
                self.watch_knots();
            }
            StopReason::Boundary(KNOT_BELOW) => {
                self.region = self.region.map(|region| region.saturating_sub(1));
                self.watch_knots();
            }
            StopReason::Boundary(_) => return Err(Refusal::NoEnd),
            StopReason::StepBudget => return Err(Refusal::StepBudget),
            StopReason::StepUnderflow => return Err(Refusal::StepUnderflow),
            StopReason::NonFinite => return Err(Refusal::NonFinite),
        }
        // An arrest within rounding of another boundary would not be seen again.
        Ok((reached.y[1] <= 0.0).then_some(Ending::Arrest))
    }

    fn meet_or_leave_stop(&mut self, reached: &mut Reached<4>) {
        let Some(wall) = self.phase.wall else { return };
        if self.behind != Behind::Room {
            self.behind = Behind::Room;
            self.watch_stop();
            self.watch_turn();
            // A plate that turns before it is clear of an elastic stop is pressed again.
            self.boundaries[PRESSED] = wall.force(-1.0);
            return;
        }
        if !wall.is_elastic() {
            reached.y[2] = wall.x;
            let before = reached.y[3];
            let push = self.rate(&[reached.y[0], reached.y[1], wall.x, 0.0])[3];
            let after = wall.stop.rebound(&Hit {
                velocity: before,
                acceleration: push,
                slow: stop::SLOW * STOP_TOLERANCE,
                length_scale: ROUNDINGS * (1.0 + wall.x.abs()),
            });
            // The stop takes the plate's velocity, not the projectile's.
            reached.y[3] = after;
            reached.y[1] += (before - after) * self.phase.faces.cos;
            if after < 0.0 || push < 0.0 {
                self.watch_turn();
                return;
            }
        }
        self.press_on(wall, reached.y[0]);
    }

    /// That the contact has pressed a resting plate against its stop all along: within a piece the area is least at one of its
    /// ends, and the slip at the last.
    fn must_have_been_held(&self, y: &[f64; 4]) -> Result<(), Refusal> {
        let Behind::Held(from) = self.behind else { return Ok(()) };
        let phase = self.phase;
        let area = smaller(from, phase.faces.area(y[0], self.piece));
        let least = area * phase.pressure(y[1]) * phase.faces.cos;
        let is_held = least >= self.spring(y[2]).0;
        if is_held { Ok(()) } else { Err(Refusal::LeavesStop) }
    }

    pub(super) fn contact_force(&self, q: f64, u: f64) -> f64 {
        let phase = self.phase;
        phase.faces.area(q, self.piece) * phase.pressure(u)
    }

    /// The rates of travel, slip, displacement and velocity where spring and damper hold with these forces.
    pub(super) fn rate_under(&self, y: &[f64; 4], spring: f64, damper: f64) -> [f64; 4] {
        let (phase, [q, u, x, w]) = (self.phase, *y);
        let f = self.contact_force(q, u);
        if self.is_still() {
            return [u, -f, 0.0, 0.0];
        }
        let cos = phase.faces.cos;
        let [stiffness, damping, stop_x] = self.pressed();
        let held = spring + damper + (stiffness * (x - stop_x) + damping * w);
        let plate = (f * cos - held) / phase.gamma;
        [u, -f - cos * plate, w, plate]
    }

    /// The derivatives of the contact force by travel and slip.
    pub(super) fn contact_tangent(&self, q: f64, u: f64) -> (f64, f64) {
        /// For a difference that is exact up to rounding: areas are of the second degree, but for oblique sections.
        const APART: f64 = 1e-5;
        let phase = self.phase;
        let area = phase.faces.area(q, self.piece);
        let slope = (phase.faces.area(q + APART, self.piece)
            - phase.faces.area(q - APART, self.piece))
            / (2.0 * APART);
        (slope * phase.pressure(u), 2.0 * area * phase.kappa * u)
    }

    pub(super) fn spring(&self, x: f64) -> (f64, f64) {
        self.phase.spring.force_and_slope(x, self.region)
    }

    /// Stiffness, damping and place of an elastic stop that is pressed; zeros without.
    pub(super) fn pressed(&self) -> [f64; 3] {
        let wall = self.phase.wall.filter(|_| self.behind == Behind::Pressed);
        wall.map_or([0.0; 3], |Wall { x, stop }| [stop.stiffness_n_m, stop.damping_n_s_m, x])
    }

    pub(super) fn is_still(&self) -> bool {
        self.phase.rigid || matches!(self.behind, Behind::Held(_))
    }
}

impl System<4> for Stretch<'_> {
    fn rate(&self, y: &[f64; 4]) -> [f64; 4] {
        let (spring, damper) = (self.spring(y[2]).0, self.phase.damper.force(y[3]));
        self.rate_under(y, spring, damper)
    }

    fn boundaries(&self) -> &[Boundary<4>] {
        &self.boundaries
    }
}

fn plane(offset: f64, component: usize, weight: f64) -> Boundary<4> {
    let mut slope = [0.0; 4];
    slope[component] = weight;
    Boundary { offset, slope }
}

#[cfg(test)]
mod tests {
    use super::super::radau::Radau;
    use super::super::{ContactSolution, Method, Phase, exact};
    use super::*;
    use crate::model::variables::scene_without_spring as scene;
    use crate::numerics::stepper::dop853::Dop853;

    const METHODS: [&Method; 2] = [&Dop853 { tolerance: 1e-12 }, &Radau { tolerance: 1e-11 }];

    fn solve(pairs: &str, method: &Method) -> Result<ContactSolution, Refusal> {
        Phase::of(&scene(pairs)).solve(method, 100_000)
    }

    #[test]
    fn valid_a_stop_without_gap_is_a_rigid_mount() {
        let mut rigid = scene("");
        rigid.plate.mount = crate::model::scene::Mount::Rigid;
        let closed = exact::solve(&rigid).unwrap();
        for method in METHODS {
            for pairs in ["k=1e5 x_stop=0", "x_stop=0 e=1"] {
                let held = solve(pairs, method).unwrap();
                assert!((held.depth_m / closed.depth_m - 1.0).abs() < 1e-9, "{pairs}");
                assert!((held.t_s / closed.t_s - 1.0).abs() < 1e-9, "{pairs}");
            }
        }
    }

    #[test]
    fn valid_an_elastic_stop_tends_to_a_rigid_one_that_gives_all_speed_back() {
        let rigid = solve("k=1e5 x_stop=0.001 e=1", METHODS[0]).unwrap();
        let away = |stiffness: &str| {
            let pairs = format!("k=1e5 x_stop=0.001 stop_kind=elastic k_stop={stiffness}");
            let elastic = solve(&pairs, METHODS[0]).unwrap();
            (elastic.depth_m / rigid.depth_m - 1.0).abs()
        };
        let (soft, hard) = (away("1e10"), away("1e14"));
        assert!(hard < 0.05 * soft && hard < 1e-3, "{soft:e} {hard:e}");
    }

    #[test]
    fn both_methods_agree_on_every_kind_of_stop() {
        for pairs in [
            "k=1e5 x_stop=0.001",
            "k=1e5 x_stop=0.001 e=0.5",
            "k=1e5 x_stop=0.001 theta=30deg",
            "k=1e5 x_stop=0.001 stop_kind=elastic k_stop=1e9 b_stop=1e3",
            "d=0.01 k=1e6 x_stop=-0.01 e=0.3",
            // An undamped one throws the plate back, and meets it again.
            "n=2 k=259000 gamma=3.3 v_i=152 h=0.00791 x_stop=0.000226 stop_kind=elastic k_stop=3.24e8",
            // It lets go of the plate, and presses it again before it is clear.
            "k=1e4 x_stop=0.000169 stop_kind=elastic k_stop=1.28e8 b_stop=342 v_i=300 h=0.05",
        ] {
            let [explicit, implicit] = METHODS.map(|method| solve(pairs, method).unwrap());
            assert_eq!(explicit.ending, implicit.ending, "{pairs}");
            let depth = (explicit.depth_m / implicit.depth_m - 1.0).abs();
            let time = (explicit.t_s / implicit.t_s - 1.0).abs();
            assert!(depth < 1e-8 && time < 1e-8, "{pairs}: {depth:e} {time:e}");
        }
    }
}
