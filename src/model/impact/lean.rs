//! The contact alone, as lean as it can be: from first contact to first arrest or exit, without series, ledger, events or
//! verdict. For sweeps and searches that ask for nothing else.
//!
//! The Taylor recurrence is the one of `motion.rs`, unrolled at compile time for each kind of spring and damper; what a scene
//! has not is not computed. Scenes it is not made for (a stop, an oblique section across the cylinder, a plate that
//! comes back through a singular point) are left to the full track: [`Contact::run`] returns `None` for them.

use crate::model::contact::{AreaLaw, Geometry, Piece};
use crate::model::mechanism::{Mechanism, PowerKind, PowerLaw, sign};
use crate::model::scene::{Mount, Scene};
use crate::numerics::larger;
use crate::numerics::series::{evaluate, evaluate_slope};

/// Terms of the expansion.
const TERMS: usize = 15;
/// Local tolerance per global tolerance.
const LOCAL: f64 = 0.1;
/// Steps after which the full track is the better way.
const STEPS_MAX: usize = 400;

/// One contact, prepared: everything that does not change along the way.
#[derive(Clone, Debug)]
pub struct Contact {
    geometry: Geometry,
    spring: PowerLaw,
    damper: PowerLaw,
    strength_pa: f64,
    drag_kg_m3: f64,
    slip_mobility: f64,
    plate_mobility: f64,
    cos: f64,
    velocity_m_s: f64,
    start_m: f64,
    has_stop: bool,
}

/// How a contact ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactEnd {
    /// Common velocity was reached; otherwise the nose is clear of the rear face.
    pub arrested: bool,
    /// When, s.
    pub t_s: f64,
    /// Depth then, m.
    pub penetration_m: f64,
    /// Plate displacement then, m.
    pub plate_displacement_m: f64,
    /// Plate velocity then, m/s.
    pub plate_velocity_m_s: f64,
    /// Steps taken.
    pub steps: usize,
}

/// The four series.
struct Series<const N: usize> {
    travel: [f64; N],
    slip: [f64; N],
    plate: [f64; N],
    speed: [f64; N],
}

/// A force law, one coefficient at a time.
trait Law<const N: usize>: Copy {
    /// Coefficient j of the force, given the argument's coefficients up to j.
    fn term(&mut self, z: &[f64; N], j: usize) -> f64;
    /// Whether the law can be expanded where its argument is zero, and through it.
    const SMOOTH: bool;
}

#[derive(Clone, Copy)]
struct Linear(f64);

impl<const N: usize> Law<N> for Linear {
    const SMOOTH: bool = true;
    #[inline]
    fn term(&mut self, z: &[f64; N], j: usize) -> f64 {
        self.0 * z[j]
    }
}

#[derive(Clone, Copy)]
struct Power<const N: usize> {
    law: PowerLaw,
    series: [f64; N],
}

impl<const N: usize> Law<N> for Power<N> {
    const SMOOTH: bool = false;
    #[inline]
    fn term(&mut self, z: &[f64; N], j: usize) -> f64 {
        self.series[j] = if j == 0 {
            self.law.coefficient * z[0].abs().powf(self.law.exponent) * sign(z[0])
        } else {
            let (rise, n) = (self.law.exponent + 1.0, j as f64);
            let mut sum = 0.0;
            for (i, z) in z.iter().enumerate().take(j + 1).skip(1) {
                sum += (i as f64 * rise - n) * z * self.series[j - i];
            }
            sum / (n * z[0])
        };
        self.series[j]
    }
}

impl Contact {
    /// Prepare the contact of a scene that has been validated.
    pub fn of(scene: &Scene) -> Self {
        let geometry = Geometry::of(scene);
        let mechanism = Mechanism::of(scene);
        let cos = geometry.nose.cos;
        let moves = scene.plate.mount == Mount::Sprung;
        let plate_mobility = if moves { 1.0 / scene.plate_mass_kg() } else { 0.0 };
        Self {
            geometry,
            spring: mechanism.spring,
            damper: mechanism.damper,
            strength_pa: scene.target.flow_strength_pa,
            drag_kg_m3: scene.drag_kg_m3(),
            slip_mobility: 1.0 / scene.projectile.mass_kg + cos * cos * plate_mobility,
            plate_mobility,
            cos,
            velocity_m_s: scene.projectile.velocity_m_s,
            start_m: if moves { 0.0 - scene.plate.cocking_m } else { 0.0 },
            has_stop: mechanism.stop.is_some(),
        }
    }

    /// Run it to the relative accuracy `tolerance`; `None` where the full track is needed.
    pub fn run(&self, tolerance: f64) -> Option<ContactEnd> {
        if self.has_stop {
            return None;
        }
        match (self.spring.kind(), self.damper.kind()) {
            (PowerKind::Absent | PowerKind::Linear, PowerKind::Absent | PowerKind::Linear) => {
                let (spring, damper) = (self.spring.coefficient, self.damper.coefficient);
                self.track(Linear(spring), Linear(damper), tolerance)
            }
            (PowerKind::General, PowerKind::Absent | PowerKind::Linear) if self.start_m != 0.0 => {
                let spring = Power { law: self.spring, series: [0.0; TERMS] };
                self.track(spring, Linear(self.damper.coefficient), tolerance)
            }
            (_, _) => None,
        }
    }

    fn track(
        &self,
        spring: impl Law<TERMS>,
        damper: impl Law<TERMS>,
        tolerance: f64,
    ) -> Option<ContactEnd> {
        let v = self.velocity_m_s;
        let mut state = [0.0, v, self.start_m, 0.0];
        let mut t_s = 0.0;
        let pieces = self.geometry.pieces();
        let mut piece = pieces.first()?;
        let mut index = 0;
        let mut unit_s = self.first_unit_s(piece)?;
        for steps in 1..=STEPS_MAX {
            let AreaLaw::Quadratic { origin_m, a } = piece.law else { return None };
            let series = self.expand((spring, damper), state, unit_s, (origin_m, a));
            let trusted = self.trusted(&series, tolerance * LOCAL);
            if trusted < 0.02 {
                // The unit is far too long for what happens now.
                unit_s *= larger(2.0 * trusted, 1e-3);
                continue;
            }
            let stops = evaluate(&series.slip, trusted) <= 0.0;
            let span = if stops { fall(&series.slip, trusted) } else { trusted };
            if !stops && dips(&series.slip, span) {
                return None;
            }
            // Travel only grows up to the arrest: the piece's end may lie before it.
            let at_end = evaluate(&series.travel, span) >= piece.to_m;
            let span = if at_end { rise(&series.travel, piece.to_m, span) } else { span };
            let arrested = stops && !at_end;
            t_s += span * unit_s;
            let at = |c: &[f64; TERMS]| evaluate(c, span);
            state = [at(&series.travel), at(&series.slip), at(&series.plate), at(&series.speed)];
            if !passes(&spring, self.start_m, state[2]) {
                return None;
            }
            if arrested {
                return Some(self.end(true, t_s, state, steps));
            }
            if at_end {
                state[0] = piece.to_m;
                index += 1;
                let Some(next) = pieces.get(index) else {
                    return Some(self.end(false, t_s, state, steps));
                };
                piece = next;
            }
            unit_s *= trusted;
        }
        None
    }

    fn end(&self, arrested: bool, t_s: f64, state: [f64; 4], steps: usize) -> ContactEnd {
        ContactEnd {
            arrested,
            t_s,
            penetration_m: self.geometry.depth_m(state[0]),
            plate_displacement_m: state[2],
            plate_velocity_m_s: state[3],
            steps,
        }
    }

    /// A first time unit: half the time in which a force growing as at first contact, or the preload, would stop the slip.
    fn first_unit_s(&self, piece: &Piece) -> Option<f64> {
        let AreaLaw::Quadratic { a, .. } = piece.law else { return None };
        let v = self.velocity_m_s;
        let growth = a[1] * v * (self.strength_pa + self.drag_kg_m3 * v * v) * self.slip_mobility;
        let preload = self.spring.force(self.start_m).abs() * self.plate_mobility;
        let by_contact = (2.0 * v / growth).sqrt();
        let by_preload = v / preload;
        let time = if by_preload < by_contact { by_preload } else { by_contact };
        let passage = self.geometry.exit_m / v;
        let unit = 0.5 * if time < passage { time } else { passage };
        (unit > 0.0 && unit.is_finite()).then_some(unit)
    }

    #[inline]
    fn expand<const N: usize>(
        &self,
        (mut spring, mut damper): (impl Law<N>, impl Law<N>),
        state: [f64; 4],
        unit_s: f64,
        (origin_m, a): (f64, [f64; 3]),
    ) -> Series<N> {
        let zero = [0.0; N];
        let mut s = Series { travel: zero, slip: zero, plate: zero, speed: zero };
        let (mut offset, mut area, mut pressure) = (zero, zero, zero);
        (s.travel[0], s.slip[0], s.plate[0], s.speed[0]) = (state[0], state[1], state[2], state[3]);
        macro_rules! order {
            ($($j:literal)*) => { $( if $j < N {
                const J: usize = $j;
                offset[J] = s.travel[J] - if J == 0 { origin_m } else { 0.0 };
                let squared = square_at::<N, J>(&offset);
                area[J] = a[1] * offset[J] + a[2] * squared + if J == 0 { a[0] } else { 0.0 };
                pressure[J] = self.drag_kg_m3 * square_at::<N, J>(&s.slip)
                    + if J == 0 { self.strength_pa } else { 0.0 };
                let f = product_at::<N, J>(&area, &pressure);
                let g = spring.term(&s.plate, J) + damper.term(&s.speed, J);
                if J + 1 < N {
                    let h = unit_s / (J + 1) as f64;
                    let plate = g * self.plate_mobility;
                    s.travel[J + 1] = h * s.slip[J];
                    s.slip[J + 1] = h * (self.cos * plate - f * self.slip_mobility);
                    s.plate[J + 1] = h * s.speed[J];
                    s.speed[J + 1] = h * (self.cos * f * self.plate_mobility - plate);
                }
            } )* };
        }
        order!(0 1 2 3 4 5 6 7 8 9 10 11 12 13);
        s
    }

    /// The part of the unit for which the truncated terms stay below the tolerance, in what matters to depth and time.
    #[inline]
    fn trusted<const N: usize>(&self, s: &Series<N>, tolerance: f64) -> f64 {
        let length = s.travel[0].abs() + s.travel[1].abs();
        let (per_length, per_speed) = (1.0 / length, 1.0 / self.velocity_m_s);
        let size = |j: usize| {
            let lengths = larger(s.travel[j].abs(), s.plate[j].abs()) * per_length;
            larger(lengths, larger(s.slip[j].abs(), s.speed[j].abs()) * per_speed)
        };
        let reach = |term: f64, order: usize| ((tolerance / term).ln() / order as f64).exp();
        let (a, b) = (reach(size(N - 1), N - 1), reach(size(N - 2), N - 2));
        let step = if a < b { a } else { b };
        // Zero terms give an infinite reach; a NaN gives none.
        if step.is_nan() {
            0.0
        } else if step < 20.0 {
            step
        } else {
            20.0
        }
    }
}

/// Coefficient J of a², with a constant index so that the loop is unrolled.
#[inline]
fn square_at<const N: usize, const J: usize>(a: &[f64; N]) -> f64 {
    let mut twice = 0.0;
    for i in 0..J.div_ceil(2) {
        twice += a[i] * a[J - i];
    }
    if J.is_multiple_of(2) { 2.0 * twice + a[J / 2] * a[J / 2] } else { 2.0 * twice }
}

/// Coefficient J of a·b.
#[inline]
fn product_at<const N: usize, const J: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let mut sum = 0.0;
    for i in 0..=J {
        sum += a[i] * b[J - i];
    }
    sum
}

/// Whether the plate is still where the spring's expansion holds: a singular law has one on either side of zero.
fn passes<L: Law<TERMS>>(_: &L, start_m: f64, plate_m: f64) -> bool {
    L::SMOOTH || plate_m * start_m > 0.0
}

/// Where a rising series reaches `level`, between 0 and `end`: Newton's method kept inside the bracket.
fn rise(c: &[f64; TERMS], level: f64, end: f64) -> f64 {
    root(end, |s| evaluate(c, s) - level, |s| evaluate_slope(c, s))
}

/// Where a falling series reaches zero, between 0 and `end`.
fn fall(c: &[f64; TERMS], end: f64) -> f64 {
    root(end, |s| -evaluate(c, s), |s| -evaluate_slope(c, s))
}

fn root(end: f64, value: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, end);
    let mut s = end - value(end) / slope(end);
    if !(s > low && s < high) {
        s = 0.5 * end;
    }
    for _ in 0..60 {
        let at = value(s);
        if at > 0.0 {
            high = s;
        } else {
            low = s;
        }
        let newton = s - at / slope(s);
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - s).abs() <= 4.0 * f64::EPSILON * s {
            return next;
        }
        s = next;
    }
    s
}

/// Whether a series that is positive at both ends may have touched zero between them.
fn dips(c: &[f64; TERMS], end: f64) -> bool {
    let mut below = c[0];
    let mut power = 1.0;
    for c in &c[1..] {
        power *= end;
        below -= c.abs() * power;
    }
    below <= 0.0 && c[1] < 0.0 && evaluate_slope(c, end) > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::{Settings, simulate};
    use crate::model::units::Bare;
    use crate::model::variables::set_by_name;
    use std::ops::ControlFlow;
    use std::sync::Arc;

    fn scene(pairs: &str) -> Scene {
        let mut scene = Scene::default();
        scene.mechanism.spring.coefficient = 0.0;
        for pair in pairs.split_whitespace() {
            let (name, value) = pair.split_once('=').unwrap();
            set_by_name(&mut scene, name, value, Bare::Si).unwrap();
        }
        scene
    }

    /// (time, depth) by the full track.
    fn full(scene: &Scene) -> (f64, f64) {
        let settings = Settings { series: false, estimate: false };
        let go_on = &mut |_: f64| ControlFlow::Continue(());
        let run = simulate(&Arc::new(scene.clone()), &settings, go_on).unwrap();
        let arrest = run.first_arrest.map(|arrest| (arrest.t_s, arrest.penetration_m));
        arrest.unwrap_or_else(|| (run.exit_time_s.unwrap(), run.final_penetration_m.unwrap()))
    }

    const SCENES: [&str; 9] = [
        "gamma=1",
        "k=1e5",
        "gamma=3 k=1e6",
        "b=1000",
        "b=2000 k=1e5",
        "d=0.5 k=1e5",
        "k=1e9",
        "h=0.003 v_i=400 k=1e5",
        "d=0.1 k=1e5 n=1.4",
    ];

    #[test]
    fn the_lean_contact_agrees_with_the_full_track() {
        for pairs in SCENES {
            let scene = scene(pairs);
            let (t_s, depth_m) = full(&scene);
            let end = Contact::of(&scene).run(1e-11).unwrap();
            assert!((end.t_s / t_s - 1.0).abs() < 1e-11, "{pairs}: {} {t_s}", end.t_s);
            assert!((end.penetration_m / depth_m - 1.0).abs() < 1e-11, "{pairs}");
        }
    }

    #[test]
    fn the_error_stays_below_the_tolerance() {
        for pairs in SCENES {
            let scene = scene(pairs);
            let (t_s, depth_m) = full(&scene);
            for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
                let end = Contact::of(&scene).run(tolerance).unwrap();
                let error =
                    larger((end.t_s / t_s - 1.0).abs(), (end.penetration_m / depth_m - 1.0).abs());
                assert!(
                    error < tolerance,
                    "{pairs} {tolerance:e}: {error:e} in {} steps",
                    end.steps
                );
            }
        }
    }

    #[test]
    fn scenes_it_is_not_made_for_are_left_to_the_full_track() {
        for pairs in
            ["k=1e5 x_stop=0.01", "k=1e6 n=0.5", "b=1000 m=0.5", "theta=30deg k=1e5 v_i=150"]
        {
            assert_eq!(Contact::of(&scene(pairs)).run(1e-9), None, "{pairs}");
        }
    }
}
