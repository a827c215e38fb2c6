//! The law of an impact, read off the equations once more: classical Runge-Kutta in tiny equal steps from first contact on.
//!
//! The oracle keeps no discrete state between steps. The state at the start of a step determines the interface: u > 0 at the bottom of the
//! hole deepens it, u > 0 above the bottom closes the gap, u < 0 pulls out. At u = 0 the bodies stick unless the limit loads are exceeded.
//! Contact with a rigid stop and the force of an elastic one follow from the state as well. A step is shortened by bisection to the first
//! sign change of a quantity that the law depends on. The only function shared with the engine is the oblique section's area. The springs
//! are in `springs.rs`, contacts other than the hydrodynamic one in `contacts.rs`.

use std::f64::consts::PI;

use cmra_engine::model::contact::Geometry;
use cmra_engine::model::scene::{Closure, ContactModel, InterfaceLaw, Scene, Stop, StopKind};

use crate::contacts::Contact;
use crate::plug::Plug;
use crate::springs::{Law, moving_kg};

/// A plate that meets its rigid stop more slowly than this stays there, m/s.
const STAYS_M_S: f64 = 2e-5;
/// Changes after which a scene is given up: a plate that rattles, for instance.
const CHANGES_MAX: usize = 3_000;

/// Travel and slip of the projectile against the plate, displacement and velocity of the plate: q, u, x, w.
pub type State = [f64; 4];

/// Interface state during a step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Interface {
    Deepens,
    Closes,
    PullsOut,
    Holds,
    Gone,
    /// The half-sine history.
    Pulse,
    /// The lumped interface: pressed in farther than ever, on its steeper branch, slack.
    Loads,
    Springs,
    Slack,
}

/// Discrete state during a step, fixed at the start of the step.
#[derive(Clone, Copy)]
struct Now {
    interface: Interface,
    /// The plate is pressed against its rigid stop, at rest.
    held: bool,
    /// The plate is beyond the place of its elastic stop.
    beyond: bool,
}

/// Projectile and plate.
struct Bodies {
    strength_pa: f64,
    projectile_kg: f64,
    plate_kg: f64,
    plug: Option<Plug>,
    /// The plug moves with the projectile.
    is_sheared: bool,
    /// Cosine of the obliquity.
    cos: f64,
    /// Thickness of the plate along the axis of the projectile, m.
    thickness_m: f64,
    /// Travel at which the nose is clear of the rear face.
    exit_m: f64,
}

/// A shot on its way.
pub struct Shot<'a> {
    scene: &'a Scene,
    geometry: Geometry,
    contact: Contact,
    law: Law<'a>,
    /// Displacements at which a step is cut, m.
    corners_m: Vec<f64>,
    bodies: Bodies,
    step_s: f64,
    /// Time, s.
    pub t_s: f64,
    /// State at that time.
    pub state: State,
    /// Greatest travel so far.
    pub deepest_m: f64,
    /// Together for good: the fused law.
    fused: bool,
    /// Time and state at the first moment of common velocity.
    pub first_arrest: Option<(f64, State)>,
    /// Time and state when the nose was clear of the rear face.
    pub exit: Option<(f64, State)>,
    /// Time and state when the nose was last clear of the entry face.
    pub separation: Option<(f64, State)>,
    /// Greatest displacement so far.
    pub farthest_m: f64,
    /// Times a step was cut.
    changes: usize,
}

impl<'a> Shot<'a> {
    /// At first contact, in steps of `step_s`.
    pub fn new(scene: &'a Scene, step_s: f64) -> Self {
        let sprung = scene.is_sprung();
        let plate = scene.plate;
        let [start_m, w] = if sprung { [-plate.cocking_m, plate.velocity_m_s] } else { [0.0; 2] };
        let closing = scene.projectile.velocity_m_s - w * scene.cos_obliquity();
        let law = Law::new(&scene.mechanism);
        let mut shot = Self {
            scene,
            geometry: Geometry::from_scene(scene),
            contact: Contact::new(scene),
            corners_m: law.corners_m(),
            law,
            bodies: Bodies {
                strength_pa: strength_pa(scene),
                projectile_kg: scene.projectile.mass_kg,
                plate_kg: moving_kg(scene),
                plug: Plug::new(scene),
                is_sheared: false,
                cos: scene.cos_obliquity(),
                thickness_m: scene.effective_thickness_m(),
                exit_m: Plug::new(scene).map_or_else(|| exit_m(scene), |plug| plug.to_m),
            },
            step_s,
            t_s: 0.0,
            state: [0.0, closing, start_m, w],
            deepest_m: 0.0,
            fused: false,
            first_arrest: None,
            exit: None,
            separation: None,
            farthest_m: start_m,
            changes: 0,
        };
        if scene.contact.model == ContactModel::InitialVelocity {
            shot.join();
        }
        if shot.bodies.plug.is_some_and(|plug| plug.from_m <= 0.0) {
            shot.pick_up();
        }
        shot
    }

    /// The plug joins the projectile, with the momentum of both; the rest of the plate keeps its velocity.
    fn pick_up(&mut self) {
        let Some(plug) = self.bodies.plug else { return };
        self.state[1] *= self.bodies.projectile_kg / (self.bodies.projectile_kg + plug.mass_kg);
        self.bodies.projectile_kg += plug.mass_kg;
        if self.scene.is_sprung() {
            self.bodies.plate_kg -= plug.mass_kg;
        }
        self.bodies.is_sheared = true;
    }

    /// Travel at which a plug is still to be picked up.
    fn plug_at_m(&self) -> Option<f64> {
        self.bodies.plug.filter(|_| !self.bodies.is_sheared).map(|plug| plug.from_m)
    }

    /// A perfectly inelastic collision: one body from now on, with the momentum along the plate's normal that both had.
    fn join(&mut self) {
        let [_, u, _, w] = self.state;
        let (m_p, m_2, cos) =
            (self.scene.projectile.mass_kg, self.bodies.plate_kg, self.bodies.cos);
        let momentum = m_p * (u + w * cos) * cos + m_2 * w;
        let still = !self.scene.is_sprung();
        self.state[1] = 0.0;
        self.state[3] = if still { 0.0 } else { momentum / (m_2 + m_p * cos * cos) };
        if self.scene.contact.model != ContactModel::InitialVelocity {
            self.first_arrest.get_or_insert((self.t_s, self.state));
        }
        self.fused = true;
    }

    /// Depth now, travel, and the plate's displacement, m.
    pub fn place(&self) -> [f64; 3] {
        let [q, _, x, _] = self.state;
        [self.depth_m(q), q, x]
    }

    /// Whether projectile and plate are together.
    pub fn holds(&self) -> bool {
        self.interface() == Interface::Holds
    }

    /// Depth of the hole that is left, m.
    pub fn hole_m(&self) -> f64 {
        let lumped = self.scene.contact.model == ContactModel::Lumped;
        let deepest = self.deepest_m;
        self.depth_m(if lumped { self.contact.slack_m(deepest) } else { deepest })
    }

    /// The projectile's velocity in a state, m/s.
    pub fn velocity_m_s(&self, [_, u, _, w]: State) -> f64 {
        u + w * self.bodies.cos
    }

    /// Go on to a time; false where that takes too many steps.
    pub fn go_to(&mut self, t_s: f64) -> bool {
        let pulse_s = self.contact.duration_s;
        while self.t_s < t_s {
            let pulses = self.contact.model == ContactModel::HalfSine && self.t_s < pulse_s;
            let until_s = if pulses { pulse_s.min(t_s) } else { t_s };
            let left_s = until_s - self.t_s;
            let whole_s = self.step_s / (1.0 + self.step_s * self.fastest_per_s() * 5.0);
            let last = left_s <= whole_s;
            if self.advance(if last { left_s } else { whole_s }) && last {
                self.t_s = until_s;
                if pulses && pulse_s <= t_s {
                    self.join();
                }
            }
            if self.changes > CHANGES_MAX {
                return false;
            }
        }
        true
    }

    /// Advances by one step, or up to the next change of the discrete state; returns `true` for a whole step.
    fn advance(&mut self, dt_s: f64) -> bool {
        let now = self.with(self.interface());
        let from = self.state;
        let mut dt_s = dt_s;
        let mut to = self.moved(from, dt_s, now);
        let changes = self.changes(now, to);
        if changes {
            self.changes += 1;
            let mut before_s = 0.0;
            for _ in 0..60 {
                let middle_s = 0.5 * (before_s + dt_s);
                let middle = self.moved(from, middle_s, now);
                if self.changes(now, middle) {
                    (dt_s, to) = (middle_s, middle);
                } else {
                    before_s = middle_s;
                }
            }
        }
        self.t_s += dt_s;
        if from[0] > 0.0 && to[0] <= 0.0 {
            self.separation = Some((self.t_s, to));
        }
        self.state = to;
        if changes {
            self.settle(now);
        }
        if now.interface.deepens() && self.state[0] > self.deepest_m {
            self.deepest_m = self.state[0];
        }
        if self.state[2] > self.farthest_m {
            self.farthest_m = self.state[2];
        }
        !changes
    }

    /// Applies the transition after a shortened step; the state lies slightly beyond the change.
    fn settle(&mut self, now: Now) {
        let [q, u, x, w] = self.state;
        match now.interface {
            Interface::Deepens if self.plug_at_m().is_some_and(|at| q >= at) => self.pick_up(),
            Interface::Deepens if q >= self.bodies.exit_m => {
                self.exit = Some((self.t_s, self.state));
            }
            Interface::Deepens | Interface::Closes if u <= 0.0 => self.meet(),
            Interface::PullsOut if u >= 0.0 => self.meet(),
            Interface::Pulse | Interface::Loads if u <= 0.0 => {
                self.first_arrest.get_or_insert((self.t_s, self.state));
            }
            Interface::Closes if q >= self.deepest_m => self.state[0] = self.deepest_m,
            _ => {}
        }
        let Some(stop) = self.rigid_stop() else { return };
        if !now.held && x > stop.position_m.expect("a stop has a place") {
            let back = if w < STAYS_M_S { 0.0 } else { -stop.restitution * w };
            self.state[2] = stop.position_m.expect("a stop has a place");
            self.state[3] = back;
            if !self.fused {
                self.state[1] += (w - back) * self.bodies.cos;
            }
        }
    }

    /// Common velocity.
    fn meet(&mut self) {
        self.state[1] = 0.0;
        if self.first_arrest.is_none() {
            self.first_arrest = Some((self.t_s, self.state));
            self.fused = self.scene.interface.law == InterfaceLaw::Fused;
        }
    }

    /// Whether something that the law depends on changes on the way to a state.
    fn changes(&self, now: Now, to: State) -> bool {
        let from = self.state;
        let interface_changes = match now.interface {
            Interface::Deepens => {
                let end_m = self.plug_at_m().unwrap_or(self.bodies.exit_m);
                to[1] <= 0.0 || to[0] >= end_m
            }
            Interface::Closes => to[1] <= 0.0 || to[0] >= self.deepest_m,
            Interface::PullsOut => to[1] >= 0.0,
            Interface::Pulse => from[1] > 0.0 && to[1] <= 0.0,
            Interface::Loads | Interface::Springs | Interface::Slack => {
                self.lumped(to) != now.interface
            }
            Interface::Holds | Interface::Gone => false,
        };
        let passes = |z: f64| (from[2] > z) != (to[2] > z);
        let stop = self.scene.mechanism.stop;
        let meets_stop = stop.position_m.is_some_and(|z| match stop.kind {
            StopKind::Rigid => self.rigid_stop().is_some() && !now.held && to[2] > z,
            StopKind::Elastic => passes(z),
        });
        let turns = from[3] != 0.0 && from[3] * to[3] <= 0.0;
        interface_changes || meets_stop || turns || self.corners_m.iter().any(|z| passes(*z))
    }

    /// Returns the interface state at the present state.
    fn interface(&self) -> Interface {
        let [q, u, ..] = self.state;
        match self.contact.model {
            ContactModel::HalfSine | ContactModel::InitialVelocity if self.fused => {
                return Interface::Holds;
            }
            ContactModel::HalfSine => return Interface::Pulse,
            ContactModel::Lumped => return self.lumped(self.state),
            _ => {}
        }
        let forward = if q >= self.deepest_m { Interface::Deepens } else { Interface::Closes };
        if self.exit.is_some() {
            Interface::Gone
        } else if self.fused {
            Interface::Holds
        } else if u > 0.0 {
            forward
        } else if u < 0.0 {
            Interface::PullsOut
        } else if self.parts(forward) > 0.0 {
            forward
        } else if self.parts(Interface::PullsOut) < 0.0 {
            Interface::PullsOut
        } else {
            Interface::Holds
        }
    }

    /// The lumped interface: it only pushes, and not where the hole is open.
    fn lumped(&self, [q, u, ..]: State) -> Interface {
        let contact = &self.contact;
        if q >= self.deepest_m && u > 0.0 {
            Interface::Loads
        } else if q <= contact.slack_m(self.deepest_m)
            || contact.springs_n(q, u, self.deepest_m) <= 0.0
        {
            Interface::Slack
        } else {
            Interface::Springs
        }
    }

    /// du/dt with what the interface would do.
    fn parts(&self, interface: Interface) -> f64 {
        self.rates(0.0, self.state, self.with(interface))[1]
    }

    /// Returns the discrete state for a given interface state.
    fn with(&self, interface: Interface) -> Now {
        let [_, _, x, w] = self.state;
        let at = self.scene.mechanism.stop.position_m;
        let free = Now { interface, held: false, beyond: at.is_some_and(|at| x > at) };
        let rests = self.rigid_stop().is_some() && at.is_some_and(|at| x >= at) && w == 0.0;
        Now { held: rests && self.rates(0.0, self.state, free)[3] >= 0.0, ..free }
    }

    /// The equations of motion, so long after the start of the step.
    fn rates(&self, after_s: f64, state: State, now: Now) -> State {
        let [_, u, x, w] = state;
        let (m_p, m_2, cos) = (self.bodies.projectile_kg, self.bodies.plate_kg, self.bodies.cos);
        let force = self.contact_n(after_s, state, now.interface);
        let back = self.law.force_n(x, self.farthest_m)
            + self.damper_n(w)
            + if now.beyond { self.stop_n(x, w) } else { 0.0 };
        let still = now.held || !self.scene.is_sprung();
        let parted = matches!(now.interface, Interface::Gone | Interface::Slack) || state[0] < 0.0;
        let falls = self.scene.projectile.weight && self.scene.is_sprung() && !parted;
        let weight = if falls { m_p * 9.80665 * cos } else { 0.0 };
        let plate = match now.interface {
            _ if still => 0.0,
            Interface::Holds => (weight * cos - back) / (m_2 + m_p * cos * cos),
            _ => (force * cos - back) / m_2,
        };
        let slip = match now.interface {
            Interface::Holds => 0.0,
            _ => (weight - force) / m_p - plate * cos,
        };
        [u, slip, if still { 0.0 } else { w }, plate]
    }

    fn moved(&self, from: State, dt_s: f64, now: Now) -> State {
        let rates = |after_s, state| self.rates(after_s, state, now);
        let along = |s: f64, rate: State| std::array::from_fn(|i| from[i] + s * rate[i]);
        let a = rates(0.0, from);
        let b = rates(0.5 * dt_s, along(0.5 * dt_s, a));
        let c = rates(0.5 * dt_s, along(0.5 * dt_s, b));
        let d = rates(dt_s, along(dt_s, c));
        along(dt_s, std::array::from_fn(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0))
    }

    /// Force between projectile and plate along the projectile's axis, positive apart.
    fn contact_n(&self, after_s: f64, [q, u, ..]: State, interface: Interface) -> f64 {
        let contact = &self.contact;
        match interface {
            Interface::Pulse => return contact.pulse_n(self.t_s + after_s),
            Interface::Loads => return contact.loads_n(q, u),
            Interface::Springs => return contact.springs_n(q, u, self.deepest_m),
            _ => {}
        }
        if let Some(plug) = self.bodies.plug.filter(|_| self.bodies.is_sheared) {
            let pushed = if q < plug.from_m {
                plug.hole_m2 * self.bodies.strength_pa
            } else {
                plug.shear_n(q)
            };
            let grip = self.scene.interface.grip;
            return match interface {
                Interface::Deepens => plug.shear_n(q),
                Interface::Closes if q > 0.0 => grip * pushed,
                Interface::PullsOut if q > 0.0 => -grip * pushed,
                _ => 0.0,
            };
        }
        let strength = self.bodies.strength_pa;
        let grip = self.scene.interface.grip * strength;
        let pressure = match interface {
            Interface::Deepens => strength + self.scene.drag_kg_m3() * u * u,
            Interface::Closes => grip,
            Interface::PullsOut => -grip,
            _ => 0.0,
        };
        if pressure == 0.0 { 0.0 } else { self.area_m2(q) * pressure }
    }

    /// How deep the nose is at a travel, m.
    pub fn depth_m(&self, q: f64) -> f64 {
        let h = self.bodies.thickness_m;
        let lag = if self.scene.target_in_effect().dishing {
            2.0 * self.scene.projectile.tip_radius_m
        } else {
            0.0
        };
        if q <= h + lag { q * h / (h + lag) } else { q - lag }
    }

    fn area_m2(&self, q: f64) -> f64 {
        if let Some(plug) = self.bodies.plug {
            return if q >= 0.0 { plug.hole_m2 } else { 0.0 };
        }
        if self.scene.projectile.obliquity_deg > 0.0 {
            return self.geometry.area_m2(q);
        }
        let r = self.scene.projectile.tip_radius_m;
        let nose = |p: f64| {
            if p <= 0.0 {
                0.0
            } else if p < r {
                PI * p * (2.0 * r - p)
            } else {
                PI * r * r
            }
        };
        let p = self.depth_m(q);
        nose(p) - nose(p - self.bodies.thickness_m)
    }

    fn damper_n(&self, w: f64) -> f64 {
        let damper = self.scene.mechanism.damper;
        power(damper.coefficient, damper.exponent, w)
    }

    /// A one-sided spring and damper: beyond its place it pushes the plate back, and never pulls.
    fn stop_n(&self, x: f64, w: f64) -> f64 {
        let stop = self.scene.mechanism.stop;
        if stop.kind == StopKind::Rigid {
            return 0.0;
        }
        let beyond = stop.position_m.map_or(0.0, |at| x - at);
        let push = stop.stiffness_n_m * beyond + stop.damping_n_s_m * w;
        if push > 0.0 { push } else { 0.0 }
    }

    fn rigid_stop(&self) -> Option<Stop> {
        let stop = self.scene.mechanism.stop;
        let acts =
            stop.position_m.is_some() && stop.kind == StopKind::Rigid && self.scene.is_sprung();
        acts.then_some(stop)
    }

    /// How fast the fastest of dampers and stop answers, 1/s: steps stay well below.
    fn fastest_per_s(&self) -> f64 {
        let Stop { position_m, kind, stiffness_n_m, damping_n_s_m, .. } = self.scene.mechanism.stop;
        let damper = self.scene.mechanism.damper;
        let w = self.state[3].abs() + 1.0;
        let mut slope = damper.coefficient * damper.exponent * w.powf(damper.exponent - 1.0);
        let mut rate = 0.0;
        if position_m.is_some_and(|at| self.state[2] > at - 1e-5) && kind == StopKind::Elastic {
            slope += damping_n_s_m;
            rate = (stiffness_n_m / self.bodies.plate_kg).sqrt();
        }
        rate + slope / self.bodies.plate_kg
    }
}

/// Travel at which the nose is clear of the rear face.
fn exit_m(scene: &Scene) -> f64 {
    let (r, cos) = (scene.projectile.tip_radius_m, scene.cos_obliquity());
    let lag = if scene.target_in_effect().dishing { 2.0 * r } else { 0.0 };
    scene.effective_thickness_m() + r * (1.0 + (1.0 - cos.powi(2)).sqrt()) / cos + lag
}

impl Interface {
    /// Whether travel beyond the greatest one is a deeper hole.
    fn deepens(self) -> bool {
        matches!(self, Self::Deepens | Self::Pulse | Self::Loads)
    }
}

/// `S_y`, or what a closure makes of Y and E, Pa.
fn strength_pa(scene: &Scene) -> f64 {
    let (y, e) = (scene.target.yield_pa, scene.target.modulus_pa);
    match scene.closure() {
        Closure::Given => scene.target.flow_strength_pa,
        Closure::DoubleYield => 2.0 * y,
        Closure::Cavity | Closure::ByThickness => {
            2.0 * y / 3.0 * (1.0 + (2.0 * e / (3.0 * y)).ln())
        }
        Closure::Cylindrical => cylindrical_pa(y, scene.target.tensile_pa.unwrap_or(y), e),
    }
}

/// The pressure on a cylindrical cavity: equilibrium summed over thin rings of the plastic region, by the middle of each. The ring between
/// the radii r and r + dr has the strain `ln(r/r_0)/(3/4)^(1/2)`, `r_0² = r² - a²`, and adds 2/3^(1/2) sigma dr/r to the elastic Y/3^(1/2).
fn cylindrical_pa(y: f64, u: f64, e: f64) -> f64 {
    let n = exponent(y, u, e);
    // With r = a (1 + exp(z)) the rings are thin where the strain is great.
    let rings = 20_000;
    let outer = (e / (3f64.sqrt() * y)).sqrt();
    let (from, to) = (-60.0, (outer - 1.0).ln());
    let width = (to - from) / f64::from(rings);
    let ring = |i: i32| {
        let s = (from + width * (f64::from(i) + 0.5)).exp();
        let strain = -((s * (2.0 + s)).ln() - 2.0 * s.ln_1p()) / 3f64.sqrt();
        2.0 / 3f64.sqrt() * y * (e * strain / y).powf(n) * s / (1.0 + s) * width
    };
    y / 3f64.sqrt() + (0..rings).map(ring).sum::<f64>()
}

/// Hardening exponent, by bisection of Considere's tensile strength.
pub(crate) fn exponent(y: f64, u: f64, e: f64) -> f64 {
    let (mut low, mut high) = (std::f64::consts::E * y / e, 2.0);
    for _ in 0..200 {
        let n = 0.5 * (low + high);
        let is_strong = y * (e * n / y).powf(n) * (-n).exp() > u;
        *(if is_strong { &mut high } else { &mut low }) = n;
    }
    if u > y { low } else { 0.0 }
}

/// c |z|^exponent sgn z.
fn power(c: f64, exponent: f64, z: f64) -> f64 {
    if c == 0.0 { 0.0 } else { c * z.abs().powf(exponent) * if z < 0.0 { -1.0 } else { 1.0 } }
}
