//! When a run is over: the outcome is decided and the greatest displacement is known, or the horizon is reached.
//!
//! Bounds come from energy: what is left, all of it in the spring, tells how far the plate can still go and what force the
//! interface can still be asked to carry.

use crate::model::impact::track::Track;
use crate::model::motion::State;
use crate::model::run::{EndReason, Mode, Outcome};
use crate::numerics::root::in_bracket;
use crate::numerics::{larger, smaller};

/// Extra time shown after everything is decided, relative to the contact.
const TAIL: f64 = 1.25;
/// Steps spent on it at the most: a stiff mount may swing a million times in it.
const TAIL_STEPS: usize = 200;
/// A later change of depth below this part of the tolerance does not count.
const NEGLIGIBLE: f64 = 1e-3;
/// Nor does one below this part of the depth, however tight the tolerance.
const UNSEEN: f64 = 1e-12;
/// Energy below this part of the projectile's at first contact counts as none: velocities of 1e-12 of the impact's.
pub(super) const DEAD: f64 = 1e-24;
/// The same for what nobody asks about any more: below the rounding of the energies.
pub(super) const FAINT: f64 = 1e-18;
/// Energy below this part of all there was with which bodies that are not joined are at rest.
const AT_REST: f64 = 1e-9;
/// Slips in a row, none of which deepened the hole noticeably, after which a projectile that cannot be pulled out counts
/// as arrested: an undamped mount rattles for ever.
const RATTLES: usize = 24;
/// Excess of the interface's load over its strength, relative, from which on the remaining slips are taken at once. They
/// are exact in energy but for the drag, far below rounding at such slips.
const LAST_SLIPS: f64 = 2e-2;
/// Loss of energy, relative, from which on the outcome is asked for again: far above rounding, far below a swing's.
const LOST: f64 = 1e-9;
/// How far a stop that gives way to a spring driving the plate away is followed, m.
const FARTHEST_M: f64 = 1e3;
/// A plate slowed by its damper alone to this part of its speed has arrived, for the eye.
const FADED: f64 = 1e-2;

/// The greatest displacement, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum MaximumDisplacement {
    /// It is this, m.
    Known(f64),
    /// Nothing ever stops the plate.
    Unbounded,
    /// The plate is still on its way.
    Pending,
}

/// What the outcome depends on while projectile and plate are together: if none of it changes, it stays the same.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Asked {
    energy_j: f64,
    travel_m: f64,
    slips: usize,
}

impl Track<'_> {
    /// Whether, and why, the run is over.
    pub(super) fn finished(&mut self) -> Option<EndReason> {
        self.follow_swing();
        let at_horizon = self.state.t_s >= self.problem.horizon_s * (1.0 - 4.0 * f64::EPSILON);
        if self.decided.is_none() && self.may_have_decided() {
            let outcome = self.outcome();
            if outcome != Outcome::Moving {
                self.farthest = self.farthest();
                if self.farthest != MaximumDisplacement::Pending {
                    self.decided = Some((outcome, self.steps));
                }
            }
        }
        if at_horizon {
            let decided = self.decided.is_some();
            return Some(if decided { EndReason::Decided } else { EndReason::Horizon });
        }
        let (_, steps) = self.decided?;
        let tail_is_long = self.steps > steps + TAIL_STEPS;
        if (self.is_at_rest() || tail_is_long) && !self.problem.horizon_is_asked {
            return Some(EndReason::Decided);
        }
        let wanted = self.problem.horizon_is_asked
            || self.is_swinging()
            || self.demand_may_grow()
            || (self.record.keep_series && self.in_tail());
        (!wanted).then_some(EndReason::Decided)
    }

    /// Whether the outcome is worth asking for again. On a curve that costs roots; without losses, in the same hole, it is what
    /// it was at the step before, and an undamped mount may swing a million times.
    fn may_have_decided(&mut self) -> bool {
        if self.mode != Mode::Fused || self.problem.mechanism.spring.curve().is_none() {
            return true;
        }
        let asked = Asked {
            energy_j: self.energy_j(),
            travel_m: self.state.travel_m,
            slips: self.slips_since_deeper,
        };
        let same = self.asked.is_some_and(|before| {
            before.travel_m.to_bits() == asked.travel_m.to_bits()
                && before.slips == asked.slips
                && asked.energy_j > before.energy_j * (1.0 - LOST)
        });
        if !same {
            self.asked = Some(asked);
        }
        !same
    }

    /// The time at which the tail after the contact ends, s.
    fn tail_s(&self) -> f64 {
        let contact = self.record.first_arrest.map(|arrest| arrest.t_s);
        let end_s = contact.or_else(|| self.record.exit.map(|exit| exit.0));
        let end_s = end_s.unwrap_or(self.state.t_s);
        // A force history goes on after common velocity.
        let least_s =
            if self.problem.flows() { 0.0 } else { self.problem.contact.scales().duration_s };
        TAIL * larger(end_s, least_s)
    }

    /// The time beyond which the next step must not go, s.
    pub(super) fn until_s(&self) -> f64 {
        let tail = self.tail_s();
        let in_tail =
            self.decided.is_some() && !self.problem.horizon_is_asked && self.state.t_s < tail;
        if in_tail { smaller(tail, self.problem.horizon_s) } else { self.problem.horizon_s }
    }

    /// Whether there is still something worth drawing.
    fn in_tail(&self) -> bool {
        if self.state.t_s < self.tail_s() * (1.0 - 4.0 * f64::EPSILON) {
            return true;
        }
        // Coasting to a greatest displacement that is already known in closed form.
        matches!(self.farthest, MaximumDisplacement::Known(known) if self.record.farthest_m < known * (1.0 - 1e-9))
            && self.state.plate_m_s > FADED * self.speed_scale_m_s
    }

    /// Whether the spring has not yet been loaded most: what the interface carries then is a result, too.
    fn is_swinging(&self) -> bool {
        matches!(self.farthest, MaximumDisplacement::Known(known) if self.record.farthest_m < known * (1.0 - 1e-9))
            && !self.problem.mechanism.spring.is_absent()
    }

    /// The outcome, if nothing can change it any more; else `Moving`.
    pub(super) fn outcome(&self) -> Outcome {
        match self.mode {
            Mode::Perforated => Outcome::Perforated,
            Mode::Fused if !self.problem.plastic || self.holds_for_good() => Outcome::Arrested,
            Mode::FreeFlight if self.gone_for_good() => Outcome::Separated,
            Mode::FreeFlight | Mode::Penetrating | Mode::Closing | Mode::Withdrawing
                if self.rests_in_contact() =>
            {
                Outcome::Arrested
            }
            Mode::Fused
            | Mode::FreeFlight
            | Mode::Penetrating
            | Mode::Closing
            | Mode::Withdrawing => Outcome::Moving,
        }
    }

    /// Whether everything is at rest in a contact that does not join the bodies.
    fn rests_in_contact(&self) -> bool {
        let stored_j = self.problem.contact.stored_j(self.mode, &self.hole());
        stored_j.is_some_and(|stored_j| {
            self.energy_left_j() + stored_j < AT_REST * self.problem.energy_j
        })
    }

    /// Mass that moves with the plate, kg.
    fn moving_kg(&self) -> f64 {
        if self.mode == Mode::Fused { self.problem.joined_kg } else { self.problem.plate_kg }
    }

    /// Energy of the plate (with the projectile, when joined), spring and elastic stop, J.
    pub(super) fn energy_j(&self) -> f64 {
        let w = self.state.plate_m_s;
        0.5 * self.moving_kg() * w * w + self.potential_j(self.state.plate_m)
    }

    /// Energy in spring and elastic stop at a displacement, J.
    pub(super) fn potential_j(&self, x: f64) -> f64 {
        let mechanism = &self.problem.mechanism;
        let pressed = larger(x - mechanism.stop_at_m, 0.0);
        let stop = mechanism
            .elastic_stop()
            .map_or(0.0, |stop| 0.5 * stop.stiffness_n_m * pressed * pressed);
        mechanism.spring.energy(x) + stop
    }

    /// Whether what still moves has less energy than rounding leaves of that at the start, squared.
    pub(super) fn has_died_down(&self) -> bool {
        self.has_less_than(DEAD)
    }

    /// Whether what still moves has no more than this part of the projectile's energy at first contact.
    pub(super) fn has_less_than(&self, part: f64) -> bool {
        let problem = self.problem;
        let v = problem.velocity_m_s;
        let at_start = 0.5 * problem.projectile_kg * v * v;
        // Where the spring drives the plate away, its energy is less than nothing.
        self.energy_j() <= part * at_start
            && problem.mechanism.spring.drives_away(self.state.plate_m).is_none()
    }

    /// How far forward the plate could still go, m; infinite when nothing stops it.
    fn reach_m(&self) -> f64 {
        self.reach_with(self.energy_j())
    }

    /// How far forward the plate can go with this energy, m.
    pub(super) fn reach_with(&self, energy: f64) -> f64 {
        let mechanism = &self.problem.mechanism;
        let spring = mechanism.spring.forward(self.state.plate_m, energy);
        smaller(spring, mechanism.stop_at_m + self.pressed_with(energy))
    }

    /// How far the plate can press its elastic stop with this energy, m; zero where it does not come so far. It is found by
    /// itself: as a difference of displacements it would keep few digits far from the spring's zero.
    fn pressed_with(&self, energy: f64) -> f64 {
        let mechanism = &self.problem.mechanism;
        let Some(stop) = mechanism.elastic_stop() else { return 0.0 };
        let spring_reach = mechanism.spring.forward(self.state.plate_m, energy);
        if spring_reach <= mechanism.stop_at_m {
            return 0.0;
        }
        let at = mechanism.stop_at_m;
        let stiffness = stop.stiffness_n_m;
        let pull = |pressed: f64| mechanism.spring.force(at + pressed) + stiffness * pressed;
        let missing = |pressed: f64| {
            mechanism.spring.energy(at + pressed) + 0.5 * stiffness * pressed * pressed - energy
        };
        let mut far = smaller(spring_reach - at, (2.0 * energy.abs() / stiffness).sqrt());
        // A spring that drives the plate away presses it farther than that.
        while missing(far) < 0.0 && far < spring_reach - at && far < FARTHEST_M {
            far = 2.0 * far + mechanism.spring.force(at + far).abs() / stiffness;
        }
        if missing(far) < 0.0 && far >= FARTHEST_M {
            return f64::INFINITY;
        }
        // Of the two places with this potential the farther one: beyond where spring and stop hold each other.
        let near = larger(self.state.plate_m - at, 0.0);
        let lowest = if pull(near) < 0.0 { in_bracket(near, far, pull) } else { near };
        in_bracket(lowest, far, missing)
    }

    /// The greatest displacement, as far as it is known. Only once the outcome is decided.
    pub(super) fn farthest(&self) -> MaximumDisplacement {
        let so_far = self.record.farthest_m;
        let mechanism = &self.problem.mechanism;
        let w = self.state.plate_m_s;
        let is_over = self.is_at_rest() || self.has_died_down() || self.rests_in_contact();
        if self.problem.rigid || is_over {
            return MaximumDisplacement::Known(so_far);
        }
        if mechanism.stop.is_none()
            && let Some(way) = mechanism.spring.drives_away(self.state.plate_m)
            && way * w >= 0.0
        {
            return if way > 0.0 {
                MaximumDisplacement::Unbounded
            } else {
                MaximumDisplacement::Known(so_far)
            };
        }
        let reach = self.reach_m();
        let stroke = so_far - self.problem.start_m;
        if reach <= so_far * (1.0 + 1e-12)
            || (reach - so_far).abs() < 1e-15 * so_far.abs()
            || reach - so_far <= NEGLIGIBLE * self.tolerance * stroke
        {
            return MaximumDisplacement::Known(so_far);
        }
        let springless = mechanism.spring.is_absent();
        let damped = mechanism.damper.coefficient > 0.0 || self.stop_touches;
        if mechanism.stop.is_none() && !damped && !springless {
            // The swing ends where all energy is in the spring, if it holds the plate at all.
            let back = mechanism.spring.backward(self.state.plate_m, self.energy_j());
            return if w < 0.0 && back.is_infinite() {
                MaximumDisplacement::Known(so_far)
            } else if reach.is_finite() {
                MaximumDisplacement::Known(larger(reach, so_far))
            } else {
                MaximumDisplacement::Unbounded
            };
        }
        if springless && w <= 0.0 && !self.stop_touches {
            return MaximumDisplacement::Known(so_far);
        }
        if springless && mechanism.stop.is_none() {
            return self.coasting(so_far);
        }
        // The damper alone would stop the plate before it gets noticeably farther.
        if w >= 0.0
            && self.state.plate_m >= 0.0
            && let MaximumDisplacement::Known(at_most) = self.coasting(so_far)
            && at_most <= so_far * (1.0 + 1e-12)
        {
            return MaximumDisplacement::Known(so_far);
        }
        MaximumDisplacement::Pending
    }

    /// Without a spring: the damper's travel in closed form, x + M w^(2-m)/(b (2-m)), finite for m < 2.
    fn coasting(&self, so_far: f64) -> MaximumDisplacement {
        let damper = self.problem.mechanism.damper;
        let (m, w) = (damper.exponent, self.state.plate_m_s);
        if damper.coefficient == 0.0 || m >= 2.0 {
            return MaximumDisplacement::Unbounded;
        }
        let travel = self.moving_kg() * w.powf(2.0 - m) / (damper.coefficient * (2.0 - m));
        MaximumDisplacement::Known(larger(self.state.plate_m + travel, so_far))
    }

    /// Plastic and together: whether the interface will hold whatever comes.
    fn holds_for_good(&self) -> bool {
        if self.is_at_rest() || self.has_died_down() || self.is_thrown_back_freely() {
            return true;
        }
        let mechanism = &self.problem.mechanism;
        let (push, pull) = self.interface_limits_n();
        let energy = self.energy_j();
        let strength = self.interface_n();
        let depth = self.problem.geometry.depth_m(self.deepest_m);
        // What is left could neither deepen the hole noticeably nor pull the projectile out of it.
        let pull_out = self.problem.grip
            * self.problem.strength_pa
            * self.problem.geometry.swept_m3(self.state.travel_m);
        let negligible = larger(NEGLIGIBLE * self.problem.scene.run.tolerance, UNSEEN);
        let is_nothing = |energy: f64| energy < negligible * depth * strength && energy < pull_out;
        if is_nothing(energy) {
            return true;
        }
        if self.slips_since_deeper > RATTLES && energy < pull_out {
            return true;
        }
        let returns = !mechanism.spring.is_absent() || self.state.plate_m_s > 0.0;
        if mechanism.rigid_stop().is_some() && returns && self.reach_m() >= mechanism.stop_at_m {
            // Only what the spring does not hold when the plate meets its stop is left to the projectile.
            let on_arrival = energy - mechanism.spring.energy(mechanism.stop_at_m);
            if !is_nothing(on_arrival) {
                return false;
            }
        }
        self.push_at(energy) <= push && self.pull_at(energy) <= pull
            || self.slips_stay_within(energy)
    }

    /// Whether the plate has left its elastic stop with nothing to bring it back.
    fn leaves_for_good(&self) -> bool {
        let mechanism = &self.problem.mechanism;
        mechanism.spring.is_absent()
            && self.state.plate_m_s <= 0.0
            && !self.stop_touches
            && self.state.plate_m <= mechanism.stop_at_m
    }

    /// Whether the plate goes back where nothing acts on it any more: thrown back by an absorber, which only pushes.
    fn is_thrown_back_freely(&self) -> bool {
        let mechanism = &self.problem.mechanism;
        let goes_back = self.state.plate_m_s < 0.0 && mechanism.damper.coefficient == 0.0;
        goes_back
            && !self.stop_touches
            && mechanism.spring.curve().is_some_and(|curve| {
                let forces = curve.forces_between(f64::NEG_INFINITY, self.state.plate_m);
                forces.0 >= 0.0 && forces.1 <= 0.0
            })
    }

    /// The most the interface can be pushed with this much energy left, N.
    pub(super) fn push_at(&self, energy_j: f64) -> f64 {
        if self.leaves_for_good() {
            // A damper holds back: it pulls.
            return 0.0;
        }
        let mechanism = &self.problem.mechanism;
        let speed = (2.0 * energy_j / self.moving_kg()).sqrt();
        let reach = self.reach_with(energy_j);
        let spring = mechanism.spring.greatest_push(self.state.plate_m, energy_j, reach);
        let stop = mechanism.elastic_stop().map_or(0.0, |stop| {
            let pressed = self.pressed_with(energy_j);
            if pressed > 0.0 || self.stop_touches {
                stop.stiffness_n_m * pressed + stop.damping_n_s_m * speed
            } else {
                0.0
            }
        });
        self.problem.share * (spring + stop + mechanism.damper.force(speed))
    }

    /// The most the interface can be pulled with this much energy left, N.
    pub(super) fn pull_at(&self, energy_j: f64) -> f64 {
        let mechanism = &self.problem.mechanism;
        if mechanism.spring.is_absent() && self.state.plate_m_s >= 0.0 && mechanism.stop.is_none() {
            // Nothing sends the plate back: the damper only pushes against the projectile.
            return 0.0;
        }
        let speed = (2.0 * energy_j / self.moving_kg()).sqrt();
        let spring = mechanism.spring.greatest_pull(self.state.plate_m, energy_j);
        self.problem.share * (spring + mechanism.damper.force(speed))
    }

    /// Without damping, the swing that exceeds the interface's strength loses ever less in ever more slips; they add up to
    /// the energy above that of the swing whose peak just equals the strength. Once that is little, take them all at once.
    pub(super) fn take_last_slips(&mut self) {
        let mechanism = &self.problem.mechanism;
        let damped = mechanism.damper.coefficient > 0.0
            || mechanism.elastic_stop().is_some_and(|stop| stop.damping_n_s_m > 0.0);
        let energy = self.energy_j();
        let (push, pull) = self.interface_limits_n();
        let at_bottom = self.state.travel_m >= self.deepest_m;
        let excess = self.push_at(energy) / push - 1.0;
        if damped
            || !at_bottom
            || mechanism.rigid_stop().is_some()
            || !(excess > 0.0 && excess < LAST_SLIPS)
            || self.pull_at(energy) > pull
        {
            return;
        }
        let kinetic = 0.5 * self.moving_kg() * self.state.plate_m_s * self.state.plate_m_s;
        let geometry = &self.problem.geometry;
        let (from, strength) = (self.state.travel_m, self.problem.strength_pa);
        let swept = geometry.swept_m3(from);
        let work = |travel: f64| strength * (geometry.swept_m3(from + travel) - swept);
        // The swing that is left after a further `travel` must peak at the strength of the then deeper hole.
        let overload = |travel: f64| {
            let left = larger(energy - work(travel), 0.0);
            self.push_at(left) - geometry.area_m2(from + travel) * strength
        };
        let most = energy * excess * 4.0 / push;
        let travel = in_bracket(0.0, most, overload) * (1.0 + 1e-9);
        let lost = work(travel);
        if overload(travel) > 0.0 || lost >= kinetic {
            return;
        }
        self.state.plate_m_s *= (1.0 - lost / kinetic).sqrt();
        self.state.travel_m += travel;
        self.deepest_m = self.state.travel_m;
        self.record.work.penetration_j += lost;
    }

    /// Apart, moving apart, and unable to meet again.
    fn gone_for_good(&self) -> bool {
        let State { travel_m, slip_m_s, plate_m, plate_m_s, .. } = self.state;
        let problem = self.problem;
        let apart_m = problem.contact.slack_m(self.deepest_m) - travel_m;
        if slip_m_s > 0.0 || (apart_m <= 0.0 && slip_m_s == 0.0) {
            return false;
        }
        let v = slip_m_s + plate_m_s * problem.cos;
        let mechanism = &problem.mechanism;
        let energy = self.energy_j();
        let speed = (2.0 * energy / problem.plate_kg).sqrt();
        if v < -speed * problem.cos {
            return true;
        }
        if mechanism.spring.is_absent() && mechanism.stop.is_none() {
            let keeps_going = mechanism.damper.coefficient == 0.0;
            return slip_m_s < 0.0 && (v <= 0.0 || plate_m_s < 0.0 || keeps_going);
        }
        // The plate is driven away from it, ever faster.
        let driven = || mechanism.spring.drives_away(plate_m) == Some(1.0);
        if slip_m_s < 0.0 && plate_m_s >= 0.0 && mechanism.stop.is_none() && driven() {
            return self.motion().accelerations(&self.state).1 >= 0.0;
        }
        // The projectile flies away, and is already beyond the plate's farthest swing back.
        let back = mechanism.spring.backward(plate_m, energy);
        v < 0.0 && (plate_m + back) * problem.cos < apart_m
    }
}
