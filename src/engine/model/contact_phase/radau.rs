//! The contact phase by Radau IIA of order 5, from first contact to the end: what an implicit, L-stable method does.
//!
//! A power law with an exponent below one is infinitely steep at zero. There its force is the unknown, and the displacement (or
//! velocity) follows from it, which is flat. Boundaries are found on the collocation polynomial of a step and landed on by
//! stepping again. Knows the equations by their stretch only.

use super::stretch::Stretch;
use crate::model::mechanism::PowerLaw;
use crate::numerics::event::first_sign_change;
use crate::numerics::implicit::{
    ImplicitSystem, NODES, Step, Unfolded, interpolate, step, step_factor,
};
use crate::numerics::stepper::{Count, Reached, Start, Stepper, StopReason, System};

/// The first step, in R/v, where none is known.
const FIRST: f64 = 1e-4;
/// The step's factor after Newton's method has failed.
const SHORTER: f64 = 0.25;
/// Looks at the polynomial of a step for boundaries.
const LOOKS: usize = 8;

/// The unknowns of a stretch: travel, slip, and displacement and velocity or what their singular laws make of them.
struct Unknowns<'a, 'p> {
    stretch: &'a Stretch<'p>,
    spring: Option<PowerLaw>,
    damper: Option<PowerLaw>,
}

fn fold(law: Option<PowerLaw>, z: f64) -> f64 {
    law.map_or(z, |law| z.abs().powf(law.exponent).copysign(z))
}

fn unfold(law: PowerLaw, y: f64) -> Unfolded {
    let value = y.abs().powf(1.0 / law.exponent).copysign(y);
    let slope = if y == 0.0 { 0.0 } else { value / (law.exponent * y) };
    Unfolded { value, slope, force: law.coefficient * y, force_slope: law.coefficient }
}

impl<'a, 'p> Unknowns<'a, 'p> {
    fn of(stretch: &'a Stretch<'p>) -> Self {
        let singular = |law: PowerLaw| Some(law).filter(|law| law.is_steep_at_zero());
        let phase = stretch.phase;
        let (spring, damper) =
            (phase.spring.law.power().and_then(singular), singular(phase.damper));
        Self { stretch, spring, damper }
    }

    fn plate(&self, y: f64) -> Unfolded {
        let Some(law) = self.spring else {
            let (force, force_slope) = self.stretch.spring(y);
            return Unfolded { value: y, slope: 1.0, force, force_slope };
        };
        unfold(law, y)
    }

    fn speed(&self, y: f64) -> Unfolded {
        let Some(law) = self.damper else {
            let law = self.stretch.phase.damper;
            return Unfolded {
                value: y,
                slope: 1.0,
                force: law.force(y),
                force_slope: law.tangent(y),
            };
        };
        unfold(law, y)
    }

    fn fold(&self, y: &[f64; 4]) -> [f64; 4] {
        [y[0], y[1], fold(self.spring, y[2]), fold(self.damper, y[3])]
    }

    /// Stages to start Newton's method from where nothing went before: by inertia, but a singular law not beyond where it alone
    /// holds against the drive.
    fn by_inertia(&self, y: &[f64; 4], h: f64) -> [[f64; 4]; 3] {
        let [_, _, x, w] = self.carried(y);
        NODES.map(|node| {
            let t = node * h;
            let q = y[0] + y[1] * t;
            let drive = self.stretch.contact_force(q, y[1]) * self.stretch.phase.faces.cos;
            let speed = drive / self.stretch.phase.gamma * t;
            let within = |law: Option<PowerLaw>, now: f64, z: f64| {
                let free = fold(law, z);
                let held = law.map_or(f64::INFINITY, |law| drive.abs() / law.coefficient);
                let most = if held > now.abs() { held } else { now.abs() };
                if free.abs() > most { most.copysign(free) } else { free }
            };
            let plate = within(self.spring, y[2], x + (w + 0.5 * speed) * t);
            [q, y[1], plate, within(self.damper, y[3], w + speed)]
        })
    }
}

impl ImplicitSystem<4> for Unknowns<'_, '_> {
    fn carried(&self, y: &[f64; 4]) -> [f64; 4] {
        [y[0], y[1], self.plate(y[2]).value, self.speed(y[3]).value]
    }

    fn carried_slope(&self, y: &[f64; 4]) -> [f64; 4] {
        [1.0, 1.0, self.plate(y[2]).slope, self.speed(y[3]).slope]
    }

    fn rate(&self, _: f64, y: &[f64; 4]) -> [f64; 4] {
        let (x, w) = (self.plate(y[2]), self.speed(y[3]));
        self.stretch.rate_under(&[y[0], y[1], x.value, w.value], x.force, w.force)
    }

    fn jacobian(&self, y: &[f64; 4]) -> [[f64; 4]; 4] {
        let phase = self.stretch.phase;
        let (by_q, by_u) = self.stretch.contact_tangent(y[0], y[1]);
        if self.stretch.is_still() {
            return [[0.0, 1.0, 0.0, 0.0], [-by_q, -by_u, 0.0, 0.0], [0.0; 4], [0.0; 4]];
        }
        let (x, w) = (self.plate(y[2]), self.speed(y[3]));
        let [stiffness, damping, _] = self.stretch.pressed();
        let cos = phase.faces.cos;
        let by_x = x.force_slope + stiffness * x.slope;
        let held = [0.0, 0.0, by_x, w.force_slope + damping * w.slope];
        let push = [by_q * cos, by_u * cos, 0.0, 0.0];
        let plate: [f64; 4] = std::array::from_fn(|i| (push[i] - held[i]) / phase.gamma);
        let contact = [by_q, by_u, 0.0, 0.0];
        let slip = std::array::from_fn(|i| -contact[i] - cos * plate[i]);
        [[0.0, 1.0, 0.0, 0.0], slip, [0.0, 0.0, 0.0, w.slope], plate]
    }

    fn scale(&self) -> [f64; 4] {
        [1.0; 4]
    }
}

/// A step from `y`, from the best guess that leads anywhere.
fn advance(
    system: &Unknowns<'_, '_>,
    y: &[f64; 4],
    h: f64,
    last: Option<&(f64, [f64; 4], Step<4>)>,
    count: &mut Count,
) -> Option<Step<4>> {
    let ahead = last.map(|(length, from, solved)| {
        NODES.map(|node| interpolate(from, solved, 1.0 + node * h / length))
    });
    let guesses = [ahead, Some(system.by_inertia(y, h)), Some([*y; 3])];
    guesses.into_iter().flatten().find_map(|guess| {
        let solved = step::<4, 12>(system, y, h, guess);
        let iterations = solved.as_ref().map_or(1, |solved| solved.iterations);
        count.evaluations += 1 + NODES.len() * iterations;
        solved.filter(|solved| solved.stages.iter().flatten().all(|value| value.is_finite()))
    })
}

/// The method to a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radau {
    /// Bound of a step's error, relative to the unit of each component.
    pub tolerance: f64,
}

impl Stepper<4, Stretch<'_>> for Radau {
    fn integrate(&self, stretch: &Stretch<'_>, start: Start<4>, count: &mut Count) -> Reached<4> {
        let tolerance = self.tolerance;
        let system = Unknowns::of(stretch);
        let (mut t, mut y) = (start.t, system.fold(&start.y));
        let mut here = start.y;
        let mut h = start.step.unwrap_or(FIRST);
        let mut last = None;
        loop {
            if let Some(stop) = count.forbids(t, h) {
                return Reached { t, y: here, stop, step: h };
            }
            let Some(solved) = advance(&system, &y, h, last.as_ref(), count) else {
                count.rejected += 1;
                h *= SHORTER;
                continue;
            };
            let factor = step_factor(solved.error, tolerance);
            if solved.error > tolerance {
                count.rejected += 1;
                h *= factor;
                continue;
            }
            count.steps += 1;
            if let Some((index, s, y)) = landed(&system, &y, &solved, h, count) {
                return Reached { t: t + s * h, y, stop: StopReason::Boundary(index), step: h };
            }
            t += h;
            here = system.carried(&solved.stages[2]);
            let next = solved.stages[2];
            last = Some((h, y, solved));
            (y, h) = (next, h * factor);
        }
    }
}

/// The boundary that a step crosses first, landed on by new steps: its index, the part of the step, and the state there. Looked for
/// on the collocation polynomial and not by the rates at the ends of the step, which have no bound where a law is singular.
fn landed(
    system: &Unknowns<'_, '_>,
    y: &[f64; 4],
    solved: &Step<4>,
    h: f64,
    count: &mut Count,
) -> Option<(usize, f64, [f64; 4])> {
    let here = system.carried(y);
    let dense = |s: f64| system.carried(&interpolate(y, solved, s));
    let looks: [(f64, [f64; 4]); LOOKS] = std::array::from_fn(|look| {
        let s = (look + 1) as f64 / LOOKS as f64;
        (s, if s < 1.0 { dense(s) } else { system.carried(&solved.stages[2]) })
    });
    let landed = system.stretch.boundaries().iter().enumerate().filter_map(|(index, boundary)| {
        let samples = looks.map(|(s, there)| (s, boundary.at(&there)));
        let armed = Some(boundary).filter(|boundary| boundary.is_armed(&here))?;
        let sign_change = first_sign_change(samples, |s| armed.at(&dense(s)))?;
        let anew = |s: f64| {
            advance(system, y, s * h, None, count).map(|short| system.carried(&short.stages[2]))
        };
        let (s, y) = armed.land(&here, &sign_change, dense, anew)?;
        Some((index, s, y))
    });
    landed.min_by(|a, b| a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::super::stored::Stored;
    use super::super::tests::stored_row;
    use super::super::{Ending, Phase, Refusal};
    use super::Radau;
    use crate::model::variables::scene_without_spring as scene;

    #[test]
    fn valid_every_stored_scene_with_the_stiffest() {
        for row in Stored::rows() {
            let time_max = if row.ending == Ending::Perforation { 1e-9 } else { 2e-9 };
            let [time, depth] = row.errors_by(&Radau { tolerance: 1e-11 });
            assert!(time < time_max && depth < 2e-9, "{}: {time:e} {depth:e}", row.changes);
        }
    }

    #[test]
    fn the_order_is_five_in_the_steps() {
        let row = stored_row("S8");
        let solve = |tolerance| {
            let answer = Phase::of(&row.scene().unwrap()).solve(&Radau { tolerance }, 100_000);
            let answer = answer.unwrap();
            (answer.steps as f64, row.errors(answer.t_s, answer.depth_m)[0])
        };
        let (coarse, fine) = (solve(1e-7), solve(1e-11));
        let order = (coarse.1 / fine.1).ln() / (fine.0 / coarse.0).ln();
        assert!((4.0..6.5).contains(&order), "{order}");
    }

    #[test]
    fn steps_do_not_grow_with_stiffness() {
        let steps = |pairs: &str| {
            let solved = Phase::of(&scene(pairs)).solve(&Radau { tolerance: 1e-9 }, 100_000);
            solved.unwrap().steps
        };
        let (stiff, stiffer) = (steps("b=1e6"), steps("b=1e10 gamma=1e-4"));
        assert!(stiffer < 2 * stiff, "{stiff} {stiffer}");
    }

    #[test]
    fn a_plate_between_a_singular_spring_and_a_singular_damper_is_followed() {
        let pairs = "n=0.188 m=0.216 k=835039 b=1.3593 gamma=0.0413 v_i=718 h=0.00573 S_y=8.03e8 C_d=0.0236";
        let solved = Phase::of(&scene(pairs)).solve(&Radau { tolerance: 1e-9 }, 20_000);
        assert_eq!(solved.unwrap().ending, Ending::Perforation);
    }

    #[test]
    fn a_budget_is_kept() {
        let phase = Phase::of(&scene("k=1e9"));
        assert_eq!(phase.solve(&Radau { tolerance: 1e-12 }, 50), Err(Refusal::StepBudget));
    }
}
