//! The equations of motion between two events, and their Taylor expansion.
//!
//! State: q travel of the projectile relative to the plate along its own axis, u = dq/dt, x plate displacement, w = dx/dt.
//! With the contact force F = A(q) (S + c u²), the mechanism's force G = K(x) + D(w) + stop, and theta's cosine,
//!
//! ```text
//! dq/dt = u        du/dt = -F (1/m_p + cos²/m_2) + G cos/m_2
//! dx/dt = w        dw/dt = (F cos - G)/m_2
//! ```
//!
//! The same form serves every mode: pulling out has a negative strength and no drag, free flight no area, a plate held by its
//! stop no mobility, and a joined body the mass `m_2` + `m_p` cos² and no contact force.

use crate::model::contact::AreaLaw;
use crate::model::mechanism::{Elastic, PowerKind, PowerLaw};
use crate::numerics::series::evaluate;

mod contact_force;
mod contact_term;
mod force;

pub(crate) use contact_force::{ContactForce, ElasticForce, FlowForce, Pressure, Pulse};
use contact_term::{ContactTerm, NoContact, Partial, Phase, Quadratic};
use force::{Along, ForceTerm, General, NoForce, Whole};

/// A moment, and the moving quantities then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) t_s: f64,
    pub(crate) travel_m: f64,
    pub(crate) slip_m_s: f64,
    pub(crate) plate_m: f64,
    pub(crate) plate_m_s: f64,
}

impl State {
    /// The projectile's own velocity, m/s.
    pub(crate) fn projectile_m_s(&self, cos: f64) -> f64 {
        self.slip_m_s + self.plate_m_s * cos
    }
}

/// The equations between two events.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Motion<'a> {
    /// F by travel, slip and time.
    pub(crate) contact: ContactForce,
    /// How strongly the contact force slows the slip: `1/m_p` + `cos²/m_2`, 1/kg.
    pub(crate) slip_mobility: f64,
    /// How strongly forces move the plate: `1/m_2`, 0 for a plate that is held, `1/(m_2` + `m_p` cos²) for a joined body, 1/kg.
    pub(crate) plate_mobility: f64,
    /// cos(theta) as far as it couples plate and slip; 0 for a joined body.
    pub(crate) coupling: f64,
    pub(crate) spring: Elastic<'a>,
    pub(crate) damper: PowerLaw,
    /// The elastic stop in contact, all zero without.
    pub(crate) stop: ElasticForce,
    /// The side of zero on which x is, or to which it is going: 1 or -1.
    pub(crate) side_x: f64,
    /// The same for w.
    pub(crate) side_w: f64,
}

/// du/dt and dw/dt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Accelerations {
    pub(crate) slip_m_s2: f64,
    pub(crate) plate_m_s2: f64,
}

/// A force whose greatest value is reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Force {
    Contact,
    /// Of the mechanism, on a plate that is forward of its neutral position.
    Push,
    /// The same backwards.
    Pull,
}

/// The expansion of a solution: coefficient j belongs to s^j, s = time since the start over the time unit.
#[derive(Clone, Debug)]
pub(crate) struct Expansion<const N: usize> {
    pub(crate) t_s: f64,
    pub(crate) unit_s: f64,
    pub(crate) travel: [f64; N],
    pub(crate) slip: [f64; N],
    pub(crate) plate: [f64; N],
    pub(crate) plate_speed: [f64; N],
    pub(crate) contact: [f64; N],
    /// Mechanism force G, N (spring, damper and elastic stop).
    pub(crate) mechanism: [f64; N],
    pub(crate) damper: [f64; N],
}

impl<const N: usize> Expansion<N> {
    pub(crate) fn start(&self) -> State {
        State {
            t_s: self.t_s,
            travel_m: self.travel[0],
            slip_m_s: self.slip[0],
            plate_m: self.plate[0],
            plate_m_s: self.plate_speed[0],
        }
    }

    pub(crate) fn state(&self, s: f64) -> State {
        State {
            t_s: self.t_s + s * self.unit_s,
            travel_m: evaluate(&self.travel, s),
            slip_m_s: evaluate(&self.slip, s),
            plate_m: evaluate(&self.plate, s),
            plate_m_s: evaluate(&self.plate_speed, s),
        }
    }
}

impl Motion<'_> {
    /// The force of the elastic stop in contact on the plate, N, positive backwards.
    pub(crate) fn stop_force(&self, state: &State) -> f64 {
        self.stop.force(state.plate_m, state.plate_m_s)
    }

    pub(crate) fn contact_force(&self, state: &State) -> f64 {
        self.contact.force(state)
    }

    pub(crate) fn mechanism_force(&self, state: &State) -> f64 {
        self.spring.force(state.plate_m)
            + self.damper.force(state.plate_m_s)
            + self.stop_force(state)
    }

    pub(crate) fn force(&self, force: Force, state: &State) -> f64 {
        match force {
            Force::Contact => self.contact_force(state),
            Force::Push => self.mechanism_force(state),
            Force::Pull => -self.mechanism_force(state),
        }
    }

    /// The amounts of what makes up the mechanism's force at a state, together, N: the force is known to the rounding of this. Of
    /// the forces there the whole and the damper's are given, N; the spring's is the rest.
    pub(crate) fn mechanism_size(&self, state: &State, mechanism_n: f64, damper_n: f64) -> f64 {
        let ElasticForce { stiffness_n_m, damping_n_s_m, slack_m } = self.stop;
        let stop_n = stiffness_n_m * (state.plate_m.abs() + slack_m.abs())
            + damping_n_s_m * state.plate_m_s.abs();
        mechanism_n.abs() + 2.0 * (damper_n.abs() + stop_n)
    }

    pub(crate) fn accelerations(&self, state: &State) -> Accelerations {
        self.response(self.contact_force(state), self.mechanism_force(state))
    }

    /// The accelerations under these forces F and G of contact and mechanism: linear in both.
    #[inline]
    pub(crate) fn response(&self, contact: f64, mechanism: f64) -> Accelerations {
        let plate = mechanism * self.plate_mobility;
        Accelerations {
            slip_m_s2: self.coupling * plate - contact * self.slip_mobility,
            plate_m_s2: self.coupling * contact * self.plate_mobility - plate,
        }
    }

    /// Expand the solution from `state` with the time unit `h`, s.
    ///
    /// A general power law must not be at its zero (x or w exactly zero): step over that first.
    pub(crate) fn expand<const N: usize>(&self, state: &State, h: f64) -> Expansion<N> {
        match self.contact {
            ContactForce::None => self.with_contact(state, h, NoContact),
            ContactForce::Flow(flow) => match flow.area {
                AreaLaw::None => self.with_contact(state, h, NoContact),
                AreaLaw::Quadratic { origin_m, a } => {
                    self.with_contact(state, h, Quadratic::new(origin_m, a, flow.pressure))
                }
                AreaLaw::Partial { origin_m, p0, p1, exit_depth_m } => {
                    let depth = p0 + p1 * (state.travel_m - origin_m);
                    let area = Partial::new(flow.nose, depth, p1, exit_depth_m, flow.pressure);
                    self.with_any_mechanism(state, h, area)
                }
            },
            ContactForce::Elastic(force) => self.with_any_mechanism(state, h, force),
            ContactForce::HalfSine(pulse) => {
                self.with_any_mechanism(state, h, Phase { pulse, t_s: state.t_s, unit_s: h })
            }
        }
    }

    /// Compiled once for all springs and dampers: for contact forces that are rare, or cost more than the calls.
    fn with_any_mechanism<const N: usize>(
        &self,
        state: &State,
        h: f64,
        contact: impl ContactTerm<N>,
    ) -> Expansion<N> {
        let damper = any_power(self.damper, self.side_w);
        match self.spring {
            _ if self.plate_mobility == 0.0 => self.recur(state, h, contact, NoForce, NoForce),
            Elastic::Piece(piece) => self.recur(state, h, contact, Along::new(piece), damper),
            Elastic::Power(law) => {
                self.recur(state, h, contact, any_power(law, self.side_x), damper)
            }
        }
    }

    fn with_contact<const N: usize>(
        &self,
        state: &State,
        h: f64,
        contact: impl ContactTerm<N>,
    ) -> Expansion<N> {
        let law = match self.spring {
            Elastic::Power(law) if self.plate_mobility != 0.0 => law,
            _ => return self.with_any_mechanism(state, h, contact),
        };
        match law.kind() {
            PowerKind::Absent => self.with_spring(state, h, contact, NoForce),
            PowerKind::Linear => self.with_spring(state, h, contact, law.coefficient),
            PowerKind::Whole(n) => {
                self.with_spring(state, h, contact, Whole::new(law.coefficient, n, self.side_x))
            }
            PowerKind::General => self.with_spring(state, h, contact, General::new(law)),
        }
    }

    fn with_spring<const N: usize>(
        &self,
        state: &State,
        h: f64,
        contact: impl ContactTerm<N>,
        spring: impl ForceTerm<N>,
    ) -> Expansion<N> {
        let law = self.damper;
        match law.kind() {
            PowerKind::Absent => self.recur(state, h, contact, spring, NoForce),
            PowerKind::Linear => self.recur(state, h, contact, spring, law.coefficient),
            PowerKind::Whole(_) | PowerKind::General => {
                self.recur(state, h, contact, spring, any_power(law, self.side_w))
            }
        }
    }

    /// The recurrence, compiled for each kind of area and spring, and for no damper, a linear one, and any other.
    #[inline]
    fn recur<const N: usize>(
        &self,
        state: &State,
        h: f64,
        mut contact: impl ContactTerm<N>,
        mut spring: impl ForceTerm<N>,
        mut damper: impl ForceTerm<N>,
    ) -> Expansion<N> {
        let mut e = Expansion {
            t_s: state.t_s,
            unit_s: h,
            travel: [0.0; N],
            slip: [0.0; N],
            plate: [0.0; N],
            plate_speed: [0.0; N],
            contact: [0.0; N],
            mechanism: [0.0; N],
            damper: [0.0; N],
        };
        e.travel[0] = state.travel_m;
        e.slip[0] = state.slip_m_s;
        e.plate[0] = state.plate_m;
        e.plate_speed[0] = state.plate_m_s;
        let ElasticForce { stiffness_n_m, damping_n_s_m, slack_m } = self.stop;
        for j in 0..N {
            let f = contact.coefficient(&e.travel, &e.slip, j);
            let d = damper.coefficient(&e.plate_speed, j);
            let mut g = spring.coefficient(&e.plate, j) + d;
            g += stiffness_n_m * e.plate[j] + damping_n_s_m * e.plate_speed[j];
            if j == 0 {
                g -= stiffness_n_m * slack_m;
            }
            (e.contact[j], e.mechanism[j], e.damper[j]) = (f, g, d);
            if j + 1 < N {
                let per_order = h / (j + 1) as f64;
                let Accelerations { slip_m_s2, plate_m_s2 } = self.response(f, g);
                e.travel[j + 1] = per_order * e.slip[j];
                e.slip[j + 1] = per_order * slip_m_s2;
                e.plate[j + 1] = per_order * e.plate_speed[j];
                e.plate_speed[j + 1] = per_order * plate_m_s2;
            }
        }
        e
    }
}

/// A power law whose coefficients are called for.
fn any_power<const N: usize>(law: PowerLaw, side: f64) -> Box<dyn ForceTerm<N>> {
    match law.kind() {
        PowerKind::Absent => Box::new(NoForce),
        PowerKind::Linear => Box::new(law.coefficient),
        PowerKind::Whole(n) => Box::new(Whole::new(law.coefficient, n, side)),
        PowerKind::General => Box::new(General::new(law)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::contact::Geometry;
    use crate::model::scene::Scene;

    fn motion(scene: &Scene, q: f64) -> Motion<'static> {
        let geometry = Geometry::of(scene);
        let (m1, m2, cos) = (scene.projectile.mass_kg, scene.plate_mass_kg(), geometry.nose.cos);
        let mechanism = &scene.mechanism;
        Motion {
            contact: ContactForce::Flow(FlowForce {
                nose: geometry.nose,
                area: geometry.piece(q).law,
                pressure: Pressure::of(scene),
            }),
            slip_mobility: 1.0 / m1 + cos * cos / m2,
            plate_mobility: 1.0 / m2,
            coupling: cos,
            spring: Elastic::Power(PowerLaw {
                coefficient: mechanism.spring.coefficient,
                exponent: mechanism.spring.exponent,
            }),
            damper: PowerLaw {
                coefficient: mechanism.damper.coefficient,
                exponent: mechanism.damper.exponent,
            },
            stop: ElasticForce { stiffness_n_m: 1e5, damping_n_s_m: 10.0, slack_m: 0.001 },
            side_x: 1.0,
            side_w: 1.0,
        }
    }

    /// The series' slope must equal the right-hand side all along the step, whatever the laws.
    #[test]
    fn the_expansion_solves_the_equations() {
        for degrees in [0.0, 30.0] {
            for (n, m) in [(1.0, 1.0), (2.0, 1.0), (3.0, 2.0), (0.5, 0.5), (1.4, 0.7), (6.0, 3.0)] {
                for depth in [0.3, 0.9, 1.3, 2.5] {
                    let mut scene = Scene::default();
                    scene.projectile.obliquity_deg = degrees;
                    scene.target.thickness_m = 0.004;
                    scene.mechanism.spring.exponent = n;
                    scene.mechanism.damper.exponent = m;
                    scene.mechanism.damper.coefficient = 50.0 * 20f64.powf(1.0 - m);
                    let q = Geometry::of(&scene).travel_m(depth * 0.00635);
                    let flow = motion(&scene, q);
                    let spring =
                        ElasticForce { stiffness_n_m: 1e7, slack_m: 0.4 * q, damping_n_s_m: 30.0 };
                    let pulse = Pulse { amplitude_n: 3e4, duration_s: 3e-5 };
                    for contact in
                        [flow.contact, ContactForce::Elastic(spring), ContactForce::HalfSine(pulse)]
                    {
                        check_slopes(&Motion { contact, ..flow }, q);
                    }
                }
            }
        }
    }

    fn check_slopes(motion: &Motion<'_>, travel_m: f64) {
        let state = State { t_s: 2e-5, travel_m, slip_m_s: 60.0, plate_m: 0.002, plate_m_s: 20.0 };
        let h = 1e-6;
        let e: Expansion<17> = motion.expand(&state, h);
        for s in [0.0, 0.2, 0.4] {
            let at = e.state(s);
            let exact = motion.accelerations(&at);
            let slope = |c: &[f64; 17]| crate::numerics::series::evaluate_slope(c, s) / h;
            let close = |a: f64, b: f64| (a - b).abs() < 1e-9 * (1.0 + b.abs());
            assert!((at.t_s - 2e-5 - s * h).abs() < 1e-19, "{s}");
            assert!(close(slope(&e.slip), exact.slip_m_s2), "{motion:?} {s}");
            assert!(close(slope(&e.plate_speed), exact.plate_m_s2), "{motion:?} {s}");
            assert!(close(evaluate(&e.contact, s), motion.contact_force(&at)));
            assert!(close(evaluate(&e.mechanism, s), motion.mechanism_force(&at)));
        }
    }
}
