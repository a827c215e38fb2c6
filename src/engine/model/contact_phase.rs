//! The contact phase alone, from first contact to first arrest or perforation, as a plain initial-value problem.
//!
//! A second implementation beside the engine of `impact.rs`: own equations, area formulas, scaling and boundaries, other steppers.
//! Each can check the other. In units of the nose radius R, the impact velocity v and R/v,
//!
//! ```text
//! q' = u    u' = -f (1 + cos²/gamma) + g cos/gamma    f = a(q) (sigma + kappa u²)
//! x' = w    w' = (f cos - g)/gamma                    g = K |x|^n sgn x + D |w|^m sgn w
//! ```
//!
//! Shared with the engine are the force laws of springs and damper, the rule of a rigid stop (`stop::rebound`), the Newton step
//! of the implicit method (`numerics::implicit::step`, in `radau`), the rule by which new steps come down on an event
//! (`numerics::event`), and in `exact` the geometry and the closed form (`contact::Geometry`, `closed_form::Passage`). `fine` and
//! `section` share none of them.
//! Must not know the engine, a screen or a clock.

use crate::model::mechanism::{self, Mechanism, PowerLaw, moving_plate_kg};
use crate::model::scene::Scene;
use crate::model::worded::worded;
use crate::numerics::stepper::{Count, Start, Stepper};
use section::Faces;
use stretch::{Stretch, Wall};

pub mod exact;
pub mod fine;
pub mod radau;
pub mod section;
pub mod stored;
mod stretch;

/// Stretches between boundaries after which a phase is given up: a plate that rattles about a singular zero.
const STRETCHES_MAX: usize = 2_000;

worded! {
    /// How the first contact ends.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Ending: word {
        Arrest = "arrest",
        /// The nose is clear of the rear face.
        Perforation = "perforation",
    }
}

/// The result of a method for the contact phase, and its cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSolution {
    /// How it ends.
    pub ending: Ending,
    /// When, s.
    pub t_s: f64,
    /// Depth then, m.
    pub depth_m: f64,
    /// Steps taken.
    pub steps: usize,
    /// Steps thrown away.
    pub rejected: usize,
    /// Evaluations of the right-hand side (of a Taylor method: of one set of coefficients).
    pub evaluations: usize,
}

impl ContactSolution {
    /// One that has cost nothing.
    pub fn free(ending: Ending, t_s: f64, depth_m: f64) -> Self {
        Self { ending, t_s, depth_m, steps: 0, rejected: 0, evaluations: 0 }
    }

    /// The quantity that tells how accurate it is: the depth, m; of a perforation, whose depth is a matter of definition, the
    /// time, s.
    pub fn measure(&self) -> f64 {
        match self.ending {
            Ending::Arrest => self.depth_m,
            Ending::Perforation => self.t_s,
        }
    }
}

worded! {
    /// Why a method gives no answer.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Refusal: words {
        NoClosedForm = "no closed form: a mechanism acts",
        /// The method knows the power law `k |x|^n` of the thesis only.
        NoPowerLaw = "not applicable: only a massless spring k |x|^n",
        /// The plate meets its stop within the contact, which these equations do not contain.
        StopWithinContact = "not applicable: a stop acts",
        /// The plate may leave the stop it rests on before the contact ends, which is not followed.
        LeavesStop = "gave up: the plate may leave its stop again",
        NeedsSimulation = "left to the simulation, as in a sweep",
        StepBudget = "gave up: step budget used up",
        StepUnderflow = "gave up: steps too small to move time",
        NonFinite = "diverged: a value is not finite",
        Separated = "wrong: projectile leaves through the entry face",
        NoEnd = "gave up: neither arrest nor perforation",
        TooStiff = "gave up: too stiff for Taylor steps",
        OtherEnding = "wrong: the outcome differs from the reference",
        EndedEarly = "the run ended early",
        Rattles = "gave up: the velocity changes sign too often",
        /// No reference could be computed that shares no code with the method.
        NoReference = "not run: no independent reference",
        /// It has taken so long that coarser points are all this report waits for.
        TooSlow = "not run: would take too long",
    }
}

/// A method for the phase.
pub type Method = dyn for<'a> Stepper<4, Stretch<'a>>;

/// The spring in scaled units: a power law whose coefficient is scaled, or a curve in m and N.
#[derive(Clone, Debug, PartialEq)]
struct Spring {
    law: mechanism::Spring,
    /// What a scaled displacement is in the law's own, and what one of its own forces is in scaled ones: 1 for a power law.
    length: f64,
    per_force: f64,
}

impl Spring {
    /// Scaled force at x and its slope; of a curve by the piece that is given, wherever x is, or by the one x lies in.
    fn force_and_slope(&self, x: f64, region: Option<usize>) -> (f64, f64) {
        let own = x * self.length;
        let (force, slope) = match (self.law.curve(), region) {
            (Some(curve), Some(at)) => {
                let piece = curve.piece(at);
                (piece.force(own), piece.tangent(own))
            }
            _ => (self.law.force(own), self.law.tangent(own)),
        };
        (self.per_force * force, self.per_force * self.length * slope)
    }
}

/// A law of what is measured in this unit, with its force in another; one that is absent has no exponent of its own.
fn scaled(law: PowerLaw, unit: f64, unit_n: f64) -> PowerLaw {
    if law.is_absent() {
        return PowerLaw::NONE;
    }
    PowerLaw { coefficient: law.coefficient * unit.powf(law.exponent) / unit_n, ..law }
}

/// The scaled problem of one scene; that of another is equal where its first contact is the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Phase {
    faces: Faces,
    radius_m: f64,
    unit_s: f64,
    gamma: f64,
    rigid: bool,
    sigma: f64,
    kappa: f64,
    spring: Spring,
    damper: PowerLaw,
    start_x: f64,
    wall: Option<Wall>,
}

impl Phase {
    /// The scaled problem of a valid scene.
    pub fn of(scene: &Scene) -> Self {
        let (r, v, m_p) = (
            scene.projectile.tip_radius_m,
            scene.projectile.velocity_m_s,
            scene.projectile.mass_kg,
        );
        let rigid = scene.is_rigid();
        // Forces in units of m_p v²/R.
        let unit_n = m_p * v * v / r;
        let Mechanism { spring, damper, .. } = Mechanism::of(scene);
        Self {
            faces: Faces::of(scene),
            radius_m: r,
            unit_s: r / v,
            gamma: moving_plate_kg(scene) / m_p,
            rigid,
            sigma: scene.flow_strength_pa() * r * r / unit_n,
            kappa: scene.drag_kg_m3() * r * r * r / m_p,
            spring: match spring.power() {
                Some(law) => {
                    let law = mechanism::Spring::Power(scaled(law, r, unit_n));
                    Spring { law, length: 1.0, per_force: 1.0 }
                }
                None => Spring { law: spring, length: r, per_force: 1.0 / unit_n },
            },
            damper: scaled(damper, v, unit_n),
            start_x: scene.start_m() / r,
            wall: Wall::of(&scene.mechanism.stop, r, v, unit_n).filter(|_| !rigid),
        }
    }

    fn pressure(&self, slip: f64) -> f64 {
        self.sigma + self.kappa * slip * slip
    }

    /// A time, s, in the problem's own unit.
    pub fn scaled_time(&self, t_s: f64) -> f64 {
        t_s / self.unit_s
    }

    /// Integrate by a method with at most `steps_max` steps. Errors and fixed steps are in scaled units.
    ///
    /// # Errors
    /// A [`Refusal`] when the phase cannot be followed to its end.
    pub fn solve(&self, method: &Method, steps_max: usize) -> Result<ContactSolution, Refusal> {
        let mut stretch = Stretch::first(self, method.lands());
        let mut count = Count::up_to(steps_max);
        let mut start = Start { t: 0.0, y: [0.0, 1.0, self.start_x, 0.0], step: None };
        for _ in 0..STRETCHES_MAX {
            let mut reached = method.integrate(&stretch, start, &mut count);
            if let Some(ending) = stretch.follow(&mut reached)? {
                return Ok(ContactSolution {
                    ending,
                    t_s: reached.t * self.unit_s,
                    depth_m: self.faces.depth(reached.y[0]) * self.radius_m,
                    steps: count.steps,
                    rejected: count.rejected,
                    evaluations: count.evaluations,
                });
            }
            start = Start { t: reached.t, y: reached.y, step: Some(reached.step) };
        }
        Err(Refusal::Rattles)
    }
}

#[cfg(test)]
pub(in crate::model) mod tests {
    use super::stored::Stored;
    use super::*;
    use crate::model::variables::scene_without_spring as scene;
    use crate::numerics::stepper::dop853::Dop853;
    use crate::numerics::stepper::rk4::{Crossing, Rk4};

    /// The row that no explicit method follows.
    pub(in crate::model) const STIFFEST: &str = "S13";

    impl Stored {
        /// The relative errors of a time, s, and a depth, m.
        pub(in crate::model) fn errors(&self, t_s: f64, depth_m: f64) -> [f64; 2] {
            let exact = self.answer();
            [(t_s / exact.t_s - 1.0).abs(), (depth_m / exact.depth_m - 1.0).abs()]
        }

        pub(in crate::model) fn errors_by(&self, method: &Method) -> [f64; 2] {
            let answer = Phase::of(&self.scene().unwrap()).solve(method, 1_000_000).unwrap();
            assert_eq!(answer.ending, self.ending, "{}", self.changes);
            self.errors(answer.t_s, answer.depth_m)
        }
    }

    pub(in crate::model) fn stored_row(name: &str) -> Stored {
        Stored::rows().find(|row| row.name == name).unwrap()
    }

    #[test]
    fn valid_every_stored_scene_but_the_stiffest_by_dop853() {
        for row in Stored::rows().filter(|row| row.name != STIFFEST) {
            // A thin plate is perforated in few steps, to a depth that geometry gives.
            let [time_max, depth_max] = match row.ending {
                Ending::Arrest => [2e-12, 2e-12],
                Ending::Perforation => [1e-13, 1e-14],
            };
            let [time, depth] = row.errors_by(&Dop853 { tolerance: 1e-13 });
            assert!(time < time_max && depth < depth_max, "{}: {time:e} {depth:e}", row.changes);
        }
    }

    #[test]
    fn located_events_keep_the_order_that_unlocated_ones_lose() {
        let row = stored_row("S8");
        let phase = Phase::of(&row.scene().unwrap());
        let error = |dt_s: f64, crossing| {
            row.errors_by(&Rk4 { step: phase.scaled_time(dt_s), crossing })[0]
        };
        let order = |crossing| (error(2e-6, crossing) / error(1.25e-7, crossing)).log2() / 4.0;
        let (with, without) = (order(Crossing::Locate), order(Crossing::Notice));
        assert!((with - 4.0).abs() < 0.4, "{with}");
        assert!(without < 2.5, "{without}");
    }

    #[test]
    fn a_scene_that_cannot_be_computed_is_refused_with_the_reason() {
        let dop853 = Dop853 { tolerance: 1e-8 };
        let solve = |pairs: &str| Phase::of(&scene(pairs)).solve(&dop853, 20_000);
        assert_eq!(solve("k=1e6 n=0.1"), Err(Refusal::StepBudget));
        // Drag alone dies away, and a spring that is compressed takes the plate off its stop.
        assert_eq!(solve("S_y=0 k=1e7 x_stop=1e-5 h=1"), Err(Refusal::LeavesStop));
    }
}
