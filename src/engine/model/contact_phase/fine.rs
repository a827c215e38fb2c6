//! The contact phase to some 20 digits: Taylor series in double-double arithmetic: a reference for results that are accurate to
//! 1e-15.
//!
//! A third implementation, independent of the engine and of the explicit methods beside it: SI units, own coefficients, own step
//! rule, own event location. Made for normal impact without a stop; other scenes are refused, not approximated. A law that is
//! singular at zero (an exponent other than one) is omitted for an instant there, 1e-20 of the contact's scale: what its impulse
//! would have done is of the order of that instant squared at first contact, and of its power 1 + n later.
//!
//! Must not know the engine, a screen or a clock.

use crate::model::contact_phase::{ContactSolution, Ending, Refusal};
use crate::model::scene::Scene;
use series::{Number, Series, TERMS, at, product, root, trusted};

mod series;

/// Size of the last terms of a step, relative: as fine as there is use for, and for telling how fine that is.
const TRUNCATION: f64 = 1e-27;
const COARSE: f64 = 1e-23;
/// The first instant, over R/v.
const INSTANT: f64 = 1e-20;
/// The same where the spring is stronger than the contact at first; what it omits is of the second order.
const BALANCE: f64 = 1e-10;
/// A spring of smaller exponent oscillates too fast to be followed from there.
const STIFF_BELOW: f64 = 0.2;
/// Steps after which a scene is too stiff for this.
const STEPS_MAX: usize = 1_500;
/// Steps shorter than this part of the time have come to a singular zero.
const CLOSE: f64 = 1e-20;
/// A zero further ahead than this many steps is not what made them short.
const NEAR: f64 = 1e3;
/// Where the jump over one ends, per distance from it.
const JUMP: f64 = 100.0;
/// Singular zeros a plate may pass in its oscillations.
const PASSED_MAX: usize = 20;

/// The end of a contact in more digits than a double holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fine {
    /// Common velocity, or the nose clear of the rear face.
    pub ending: Ending,
    /// When, s.
    pub t_s: Number,
    /// Depth then, m.
    pub depth_m: Number,
    /// Velocity of the projectile relative to the plate then, along its own axis, m/s.
    pub slip_m_s: Number,
    /// Plate displacement then, m.
    pub plate_m: Number,
    /// Plate velocity then, m/s.
    pub plate_m_s: Number,
    /// Steps taken.
    pub steps: usize,
}

impl Fine {
    /// The same to double precision.
    pub fn answer(&self) -> ContactSolution {
        let free = ContactSolution::free(self.ending, self.t_s.nearest(), self.depth_m.nearest());
        ContactSolution { steps: self.steps, evaluations: self.steps, ..free }
    }
}

/// A force law `k |z|^n sgn z`.
#[derive(Clone, Copy)]
struct Law {
    coefficient: Number,
    exponent: Number,
}

impl Law {
    /// No force.
    const NONE: Self = Self { coefficient: Number::ZERO, exponent: Number::ONE };

    fn of(coefficient: f64, exponent: f64) -> Self {
        Self { coefficient: coefficient.into(), exponent: exponent.into() }
    }

    fn acts(self) -> bool {
        self.coefficient > Number::ZERO
    }

    fn is_linear(self) -> bool {
        self.exponent == Number::ONE
    }

    /// Whether it can be expanded about zero.
    fn is_singular(self) -> bool {
        self.acts() && !self.is_linear()
    }

    /// Coefficient j of the force, given those of z up to j and of |z|^n below j.
    fn term(self, z: &Series, power: &mut Series, j: usize) -> Number {
        if !self.acts() {
            return Number::ZERO;
        }
        if self.is_linear() {
            return self.coefficient * z[j];
        }
        power[j] = if j == 0 {
            let size = z[0].abs().powf(self.exponent);
            if z[0] < Number::ZERO { -size } else { size }
        } else {
            let whole = Number::from(j as f64);
            let mut sum = Number::ZERO;
            for i in 1..=j {
                let weight = Number::from(i as f64) * (self.exponent + Number::ONE) - whole;
                sum = sum + weight * z[i] * power[j - i];
            }
            sum / (whole * z[0])
        };
        self.coefficient * power[j]
    }
}

/// The area law between two joints: a0 + a1 q + a2 q².
struct AreaPiece {
    until_m: Number,
    area: [Number; 3],
}

struct Problem {
    pieces: Vec<AreaPiece>,
    strength_pa: Number,
    drag_kg_m3: Number,
    per_projectile_kg: Number,
    per_plate_kg: Number,
    spring: Law,
    damper: Law,
    thickness_m: Number,
    lag_m: Number,
}

/// q, u, x, w.
type State = [Number; 4];

/// Solve the contact phase.
///
/// # Errors
/// A [`Refusal`] where the scene is oblique, has a spring that is not a power law or a stop, is too stiff for Taylor steps, or
/// oscillates through singular zeros again and again.
pub fn solve(scene: &Scene) -> Result<Fine, Refusal> {
    solve_to(scene, TRUNCATION)
}

/// How far the time and depth of [`solve`] are from those at a coarser truncation, relative: more than it is off itself.
///
/// # Errors
/// As [`solve`].
pub fn uncertainty(scene: &Scene, fine: &Fine) -> Result<f64, Refusal> {
    let coarse = solve_to(scene, COARSE)?;
    if coarse.ending != fine.ending {
        return Err(Refusal::OtherEnding);
    }
    let off = |a: Number, b: Number| (a / b - Number::ONE).nearest().abs();
    let (time, depth) = (off(coarse.t_s, fine.t_s), off(coarse.depth_m, fine.depth_m));
    Ok(if time > depth { time } else { depth })
}

fn solve_to(scene: &Scene, truncation: f64) -> Result<Fine, Refusal> {
    if scene.projectile.obliquity_deg != 0.0 {
        return Err(Refusal::NoReference);
    }
    let rigid = scene.is_rigid();
    if !rigid && !scene.mechanism.is_plain() {
        return Err(Refusal::NoPowerLaw);
    }
    if scene.mechanism.stop.position_m.is_some() && !rigid {
        return Err(Refusal::StopWithinContact);
    }
    let problem = Problem::of(scene);
    let scale_s = scene.projectile.tip_radius_m / scene.projectile.velocity_m_s;
    let state = [0.0, scene.projectile.velocity_m_s, scene.start_m(), 0.0].map(Number::from);
    let (t_s, state) = problem.leave_zero(state, scale_s)?;
    let unit_s = if t_s > Number::ZERO { t_s.nearest() } else { 0.1 * scale_s };
    let mut contact =
        Integration { problem: &problem, truncation, t_s, state, piece: 0, unit_s, passed: 0 };
    for steps in 1..=STEPS_MAX {
        if let Some(ending) = contact.step()? {
            let depth_m = problem.depth_m(contact.state[0]);
            let [_, slip_m_s, plate_m, plate_m_s] = contact.state;
            let t_s = contact.t_s;
            return Ok(Fine { ending, t_s, depth_m, slip_m_s, plate_m, plate_m_s, steps });
        }
    }
    Err(Refusal::TooStiff)
}

/// A contact in progress.
struct Integration<'a> {
    problem: &'a Problem,
    truncation: f64,
    t_s: Number,
    state: State,
    /// Which piece of the area law it is on.
    piece: usize,
    /// Time unit of the next expansion, s.
    unit_s: f64,
    /// Singular zeros jumped over.
    passed: usize,
}

impl Integration<'_> {
    /// One step; the ending when it is reached.
    fn step(&mut self) -> Result<Option<Ending>, Refusal> {
        let problem = self.problem;
        if self.passed > PASSED_MAX {
            return Err(Refusal::Rattles);
        }
        if self.unit_s < CLOSE * self.t_s.nearest() && self.jump() {
            return Ok(None);
        }
        let laws = (problem.spring, problem.damper);
        let mobility = problem.per_plate_kg;
        let piece = &problem.pieces[self.piece];
        let series = problem.expand(laws, mobility, &self.state, piece, self.unit_s);
        let reach = trusted(&series, self.truncation);
        if !(reach.is_finite() && reach > 0.0) {
            return Err(Refusal::NonFinite);
        }
        if reach < 0.02 {
            // The unit was far too long: coefficients of high order have lost their meaning.
            self.unit_s *= reach;
            return Ok(None);
        }
        let reach = Number::from(reach);
        let stopped = at(&series[1], reach) <= Number::ZERO;
        let span = if stopped { root(&series[1], Number::ZERO, reach) } else { reach };
        let joint = at(&series[0], span) >= piece.until_m;
        let span = if joint { root(&series[0], piece.until_m, span) } else { span };
        // An expansion knows one side of a singular zero, even where it reaches beyond: up to it, and over.
        let before_zero = problem.singular_zero(&series, span);
        let to_zero = before_zero.is_some();
        let span = before_zero.unwrap_or(span);
        self.t_s = self.t_s + span * Number::from(self.unit_s);
        self.state = [0, 1, 2, 3].map(|component| at(&series[component], span));
        if to_zero {
            self.unit_s *= span.nearest() * CLOSE;
            return if self.jump() { Ok(None) } else { Err(Refusal::Rattles) };
        }
        if joint {
            // The unit stays: the joint may have cut the step to almost nothing.
            self.state[0] = piece.until_m;
            self.piece += 1;
            return Ok((self.piece == problem.pieces.len()).then_some(Ending::Perforation));
        }
        self.unit_s *= span.nearest();
        Ok(stopped.then_some(Ending::Arrest))
    }

    /// Over a singular zero that steps have come close to, without its law, well to the other side; whether there was one ahead.
    fn jump(&mut self) -> bool {
        let problem = self.problem;
        let (piece, nothing) = (&problem.pieces[self.piece], Law::NONE);
        let expand =
            |laws| problem.expand(laws, problem.per_plate_kg, &self.state, piece, self.unit_s);
        let way = |law: Law, i: usize, laws: (Law, Law)| {
            let series = law.is_singular().then(|| expand(laws))?;
            let time = -series[i][0] / series[i][1];
            (time > Number::ZERO && time < Number::from(NEAR)).then_some((time, series))
        };
        let ways = [
            way(problem.spring, 2, (nothing, problem.damper)),
            way(problem.damper, 3, (problem.spring, nothing)),
        ];
        let nearest =
            ways.into_iter().flatten().min_by(|a, b| a.0.nearest().total_cmp(&b.0.nearest()));
        let Some((time, series)) = nearest else { return false };
        let span = time * Number::from(JUMP);
        self.passed += 1;
        self.t_s = self.t_s + span * Number::from(self.unit_s);
        self.state = [0, 1, 2, 3].map(|component| at(&series[component], span));
        self.unit_s *= span.nearest();
        true
    }
}

impl Problem {
    fn of(scene: &Scene) -> Self {
        let number = Number::from;
        let (r, h) = (number(scene.projectile.tip_radius_m), number(scene.target.thickness_m));
        let damper = scene.mechanism.damper.law();
        let two = number(2.0);
        let lag_m = if scene.dishing() { two * r } else { Number::ZERO };
        let mut problem = Self {
            pieces: Vec::new(),
            strength_pa: number(scene.flow_strength_pa()),
            drag_kg_m3: number(0.5)
                * number(scene.drag_coefficient())
                * number(scene.target.density_kg_m3),
            per_projectile_kg: Number::ONE / number(scene.projectile.mass_kg),
            per_plate_kg: Number::ONE
                / (number(scene.plate.mass_ratio) * number(scene.projectile.mass_kg)),
            spring: Law::of(scene.mechanism.spring.coefficient, scene.mechanism.spring.exponent),
            damper: Law::of(damper.coefficient, damper.exponent),
            thickness_m: h,
            lag_m,
        };
        if scene.is_rigid() {
            problem.per_plate_kg = Number::ZERO;
            (problem.spring, problem.damper) = (Law::NONE, Law::NONE);
        }
        // Depths at which a face's section changes its formula.
        let mut joints = vec![r, h, h + r];
        joints.sort_by(|a, b| a.nearest().total_cmp(&b.nearest()));
        let mut from = Number::ZERO;
        for joint in joints {
            if joint > from {
                let middle = number(0.5) * (from + joint);
                let until_m = problem.travel_m(joint);
                problem.pieces.push(AreaPiece { until_m, area: problem.area(r, middle) });
                from = joint;
            }
        }
        problem
    }

    /// The area's polynomial in the travel, where the depth is near `middle`.
    fn area(&self, r: Number, middle: Number) -> [Number; 3] {
        let two = Number::from(2.0);
        // Depth is slope q - offset here.
        let (slope, offset) = if middle < self.thickness_m {
            (self.thickness_m / (self.thickness_m + self.lag_m), Number::ZERO)
        } else {
            (Number::ONE, self.lag_m)
        };
        let section = |behind: Number| -> [Number; 3] {
            let at = middle - behind;
            if at <= Number::ZERO {
                [Number::ZERO; 3]
            } else if at < r {
                // pi p (2 R - p) with p = slope q - c.
                let c = offset + behind;
                [
                    Number::PI * (-(two * r * c) - c * c),
                    Number::PI * slope * (two * r + two * c),
                    -(Number::PI * slope * slope),
                ]
            } else {
                [Number::PI * r * r, Number::ZERO, Number::ZERO]
            }
        };
        let (front, rear) = (section(Number::ZERO), section(self.thickness_m));
        [0, 1, 2].map(|i| front[i] - rear[i])
    }

    fn travel_m(&self, depth: Number) -> Number {
        if depth <= self.thickness_m {
            depth * (self.thickness_m + self.lag_m) / self.thickness_m
        } else {
            depth + self.lag_m
        }
    }

    fn depth_m(&self, travel: Number) -> Number {
        if travel <= self.thickness_m + self.lag_m {
            travel * self.thickness_m / (self.thickness_m + self.lag_m)
        } else {
            travel - self.lag_m
        }
    }

    /// Time and state just off the singular zero of a force law; first contact itself where there is none.
    ///
    /// As a rule the law is omitted for the first instant. A spring of exponent below 1/3, though, is at first stronger than
    /// the contact force, and the plate follows their balance: there it starts. A damper of exponent below 1/2 is refused.
    fn leave_zero(&self, state: State, scale_s: f64) -> Result<(Number, State), Refusal> {
        let at_zero = |law: Law, i: usize| law.is_singular() && state[i] == Number::ZERO;
        if !at_zero(self.spring, 2) && !at_zero(self.damper, 3) {
            return Ok((Number::ZERO, state));
        }
        let keep = |law: Law, i: usize| if at_zero(law, i) { Law::NONE } else { law };
        let laws = (keep(self.spring, 2), keep(self.damper, 3));
        let after = |instant: f64, per_plate_kg: Number| {
            let series = self.expand(laws, per_plate_kg, &state, &self.pieces[0], scale_s);
            [0, 1, 2, 3].map(|i| at(&series[i], Number::from(instant)))
        };
        let time = |instant: f64| Number::from(instant) * Number::from(scale_s);
        let free = after(INSTANT, self.per_plate_kg);
        let spring = self.spring;
        let balances = at_zero(spring, 2)
            && spring.coefficient * free[2].abs().powf(spring.exponent) > self.force(&free);
        let resists = at_zero(self.damper, 3) && self.damper.exponent < Number::from(0.5);
        if resists || (balances && spring.exponent < Number::from(STIFF_BELOW)) {
            return Err(Refusal::TooStiff);
        }
        if !balances {
            return Ok((time(INSTANT), free));
        }
        let mut held = after(BALANCE, Number::ZERO);
        let t_s = time(BALANCE);
        held[2] = (self.force(&held) / spring.coefficient).powf(Number::ONE / spring.exponent);
        held[3] = held[2] / (spring.exponent * t_s);
        Ok((t_s, held))
    }

    /// Just before the argument of a singular law passes zero within the span.
    fn singular_zero(&self, series: &[Series; 4], span: Number) -> Option<Number> {
        let zero = |law: Law, i: usize| {
            let (before, after) = (series[i][0], at(&series[i], span));
            let passes = (before > Number::ZERO) != (after > Number::ZERO);
            (law.is_singular() && passes).then(|| root(&series[i], Number::ZERO, span))
        };
        let zeros = [zero(self.spring, 2), zero(self.damper, 3)];
        let first = zeros.into_iter().flatten().min_by(|a, b| a.nearest().total_cmp(&b.nearest()));
        first.map(|zero| zero * (Number::ONE - Number::from(CLOSE)))
    }

    /// The contact force on the first piece.
    fn force(&self, [q, u, _, _]: &State) -> Number {
        let [a0, a1, a2] = self.pieces[0].area;
        (a0 + *q * (a1 + a2 * *q)) * (self.strength_pa + self.drag_kg_m3 * *u * *u)
    }

    /// The Taylor coefficients of q, u, x, w in units of `unit_s`.
    fn expand(
        &self,
        (spring, damper): (Law, Law),
        per_plate_kg: Number,
        state: &State,
        piece: &AreaPiece,
        unit_s: f64,
    ) -> [Series; 4] {
        let mut s = [[Number::ZERO; TERMS]; 4];
        for (series, start) in s.iter_mut().zip(state) {
            series[0] = *start;
        }
        let (mut area, mut pressure) = ([Number::ZERO; TERMS], [Number::ZERO; TERMS]);
        let (mut of_x, mut of_w) = ([Number::ZERO; TERMS], [Number::ZERO; TERMS]);
        for j in 0..TERMS - 1 {
            let first = if j == 0 { Number::ONE } else { Number::ZERO };
            let [a0, a1, a2] = piece.area;
            area[j] = first * a0 + a1 * s[0][j] + a2 * product(&s[0], &s[0], j);
            pressure[j] = first * self.strength_pa + self.drag_kg_m3 * product(&s[1], &s[1], j);
            let f = product(&area, &pressure, j);
            let held = spring.term(&s[2], &mut of_x, j) + damper.term(&s[3], &mut of_w, j);
            let plate = (f - held) * per_plate_kg;
            let h = Number::from(unit_s) / Number::from((j + 1) as f64);
            s[0][j + 1] = h * s[1][j];
            s[1][j + 1] = h * (-(f * self.per_projectile_kg) - plate);
            s[2][j + 1] = h * s[3][j];
            s[3][j + 1] = h * plate;
        }
        s
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::contact_phase::stored::Stored;
    use crate::model::contact_phase::tests::STIFFEST;
    use crate::model::variables::scene_without_spring as scene;
    use crate::numerics::double_double::digits;

    #[test]
    fn valid_every_stored_scene_but_the_stiffest_to_the_digits_that_are_trusted() {
        for row in Stored::rows().filter(|row| row.name != STIFFEST) {
            let found = solve(&row.scene().unwrap()).unwrap();
            let off = |own: Number, at: usize| {
                (own / digits(row.digits[at]) - Number::ONE).nearest().abs()
            };
            assert!(off(found.t_s, 0) < 3e-18, "{} after {} steps", row.changes, found.steps);
            assert!(off(found.depth_m, 1) < 3e-18, "{} after {} steps", row.changes, found.steps);
            assert!(off(found.plate_m, 2) < 1e-16, "{}", row.changes);
            let own = uncertainty(&row.scene().unwrap(), &found).unwrap();
            assert!(own < 1e-18, "{}: {own:e}", row.changes);
        }
    }

    #[test]
    fn scenes_outside_its_scope_are_refused() {
        assert_eq!(solve(&scene("k=1e5 theta=10deg")), Err(Refusal::NoReference));
        assert_eq!(solve(&scene("k=1e5 x_stop=0.001")), Err(Refusal::StopWithinContact));
        assert_eq!(solve(&scene("k=1e6 n=0.1")), Err(Refusal::TooStiff));
        assert_eq!(solve(&scene("b=1000 m=0.3")), Err(Refusal::TooStiff));
        let mut broken = scene("k=1e5");
        broken.projectile.mass_kg = f64::NAN;
        assert_eq!(solve(&broken), Err(Refusal::NonFinite));
    }

    #[test]
    fn a_plate_that_oscillates_through_a_singular_zero_agrees_with_dop853() {
        use crate::model::contact_phase::Phase;
        use crate::numerics::stepper::dop853::Dop853;
        for pairs in [
            "d=0.001 k=1e6 n=0.5",
            "d=4e-5 k=4e8 n=2",
            "d=1e-4 k=1e9 n=3",
            "d=0.002 k=1e6 n=1.4 b=100",
            "d=0.01 k=1e6 b=300 m=0.7",
            // Stops at the far end and comes back, with both laws singular.
            "n=0.49478 m=2.8504 k=1.9174e7 b=1078.3 gamma=77.067 v_i=330.54 h=0.07212 S_y=4.4379e8 C_d=0.16306",
        ] {
            let own = solve(&scene(pairs)).expect(pairs);
            let tight = Dop853 { tolerance: 1e-14 };
            let other = Phase::of(&scene(pairs)).solve(&tight, 1_000_000).unwrap();
            let answer = own.answer();
            assert_eq!(answer.ending, other.ending);
            let (time, depth) =
                (answer.t_s / other.t_s - 1.0, answer.depth_m / other.depth_m - 1.0);
            assert!(time.abs() < 2e-12 && depth.abs() < 2e-12, "{pairs}: {time:e} {depth:e}");
            assert!(uncertainty(&scene(pairs), &own).unwrap() < 1e-18, "{pairs}");
        }
    }

    #[test]
    fn a_rigid_mount_agrees_with_the_closed_form() {
        let mut rigid = scene("");
        rigid.plate.mount = crate::model::scene::Mount::Rigid;
        let closed = crate::model::contact_phase::exact::solve(&rigid).unwrap();
        let own = solve(&rigid).unwrap().answer();
        assert_eq!(own.ending, closed.ending);
        assert!((own.depth_m / closed.depth_m - 1.0).abs() < 1e-15);
        assert!((own.t_s / closed.t_s - 1.0).abs() < 1e-14);
    }
}
