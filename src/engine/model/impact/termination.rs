//! When a run is over: the outcome is decided and the greatest displacement is known, or the horizon is reached.
//!
//! Bounds come from energy: the remaining energy, all of it in the spring, bounds the displacement of the plate and the force
//! that the interface may have to carry.

use crate::model::impact::body::{MaximumDisplacement, NO_ENERGY};
use crate::model::impact::record::Record;
use crate::model::impact::simulation::Simulation;
use crate::model::mechanism::sign;
use crate::model::motion::ContactForce;
use crate::model::run::{EndReason, Mode, Observer, Outcome};
use crate::numerics::root::in_bracket;
use crate::numerics::{larger, smaller};

/// The end of what is shown after everything is decided, relative to the end of the contact.
const TAIL_END: f64 = 1.25;
/// Maximum number of steps spent on it: a stiff mount may oscillate a million times in it.
const TAIL_STEPS: usize = 200;
/// Excess e of the interface's load over its strength, relative, below which the remaining slips are taken at once.
///
/// Their path leaves out the drag. The relative velocity in one of them grows by `A S M/(m_p m_2) (e - (w t)²/2)` while the load exceeds the
/// strength, to at most `1.9 e^1.5 (M/m_2)` of the joined body's, which is below the impact's: the drag is at most
/// `4 e³ (M/m_2)² c v_i²/S` of the strength, and the path as much shorter.
const LAST_SLIPS: f64 = 5e-3;
/// A plate slowed by its damper alone to this part of its speed has arrived, to be drawn.
const ARRIVED_SPEED: f64 = 1e-2;
/// Part of the interface's load by which it may still grow without being followed.
const DEMAND_GROWTH: f64 = 1e-9;
/// Energy below this part of the projectile's that nothing depends on any more: below the rounding of the energies.
const NEGLIGIBLE_ENERGY: f64 = 1e-18;
/// Turns of a plate that is followed for its loads: to the way back, forward again, and the end of that.
const TURNS_FOLLOWED: usize = 3;
/// Steps in which such a plate is followed at most: one that turns takes fewer, one that creeps against its damper thousands, with
/// ever smaller loads.
const STEPS_FOLLOWED: usize = 1_000;

/// The known part of the run's outcome.
#[derive(Clone, Debug, Default)]
pub(super) struct Termination {
    /// The outcome, once it is decided, and the steps taken until then.
    pub(super) decided: Option<(Outcome, usize)>,
    pub(super) max_displacement: MaximumDisplacement,
    /// How far the first half-oscillation of the joined body has come.
    oscillation: HalfOscillation,
    /// The plate is followed after the run for its greatest loads.
    loads: Option<Following>,
}

/// A plate that is followed after the run: how often it has turned, its direction, and for how long and how many steps in all it is
/// followed.
#[derive(Clone, Copy, Debug)]
struct Following {
    turns: usize,
    way: f64,
    until_s: f64,
    steps_max: usize,
}

/// How far the joined body has come on its first forward half-oscillation, in which its mechanism pushes most.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
enum HalfOscillation {
    #[default]
    Back,
    Forward,
    Over,
}

impl Simulation<'_> {
    pub(super) fn finished(&mut self) -> Option<EndReason> {
        self.note_half_oscillation();
        let at_horizon = self.body.state.t_s >= self.horizon_s() * (1.0 - 4.0 * f64::EPSILON);
        if self.termination.loads.is_some() {
            return (at_horizon || !self.loads_are_ahead()).then_some(EndReason::Decided);
        }
        if self.termination.decided.is_none() {
            let outcome = self.body.outcome();
            if outcome != Outcome::Moving {
                self.termination.max_displacement =
                    self.body.maximum_displacement(self.record.max_displacement_m);
                if self.termination.max_displacement != MaximumDisplacement::Pending {
                    self.termination.decided = Some((outcome, self.control.steps));
                }
            }
        }
        if at_horizon {
            let decided = self.termination.decided.is_some();
            return Some(if decided { EndReason::Decided } else { EndReason::Horizon });
        }
        let (_, steps) = self.termination.decided?;
        let tail_is_long = self.control.steps > steps + TAIL_STEPS;
        if (self.body.is_at_rest() || tail_is_long) && !self.body.problem.horizon_is_given {
            return Some(EndReason::Decided);
        }
        let wanted = self.body.problem.horizon_is_given
            || self.spring_load_may_grow()
            || self.demand_may_grow()
            || (self.record.keep_series && self.in_tail());
        (!wanted).then_some(EndReason::Decided)
    }

    /// The time at which the tail after the contact ends, s.
    fn tail_s(&self) -> f64 {
        let contact = self.record.first_arrest.map(|arrest| arrest.t_s);
        let end_s = contact.or_else(|| self.record.exit.map(|exit| exit.t_s));
        let end_s = end_s.unwrap_or(self.body.state.t_s);
        // A force history goes on after common velocity.
        let least_s = if self.body.problem.flows() {
            0.0
        } else {
            self.body.problem.contact.scales().duration_s
        };
        TAIL_END * larger(end_s, least_s)
    }

    pub(super) fn until_s(&self) -> f64 {
        let tail = self.tail_s();
        let in_tail = self.termination.decided.is_some()
            && !self.body.problem.horizon_is_given
            && self.body.state.t_s < tail;
        if in_tail { smaller(tail, self.horizon_s()) } else { self.horizon_s() }
    }

    /// When the run ends at the latest, s: a plate that coasts to a stop, or presses it, arrives first.
    fn horizon_s(&self) -> f64 {
        let problem = self.body.problem;
        let stop_s = self.body.time_at_stop_s().filter(|_| !problem.horizon_is_given);
        let later_s = stop_s.map_or(0.0, |stop_s| self.body.state.t_s + 2.0 * stop_s);
        let followed_s = self.termination.loads.map_or(0.0, |it| it.until_s);
        larger(problem.horizon_s, larger(later_s, followed_s))
    }

    /// Whether there is still something worth drawing.
    fn in_tail(&self) -> bool {
        if self.body.state.t_s < self.tail_s() * (1.0 - 4.0 * f64::EPSILON) {
            return true;
        }
        // Coasting to a greatest displacement that is already known in closed form.
        self.goes_farther() && self.body.state.plate_m_s > ARRIVED_SPEED * self.body.speed_scale_m_s
    }

    /// Whether the plate is on its way to a greatest displacement that is known already.
    pub(super) fn goes_farther(&self) -> bool {
        let reached = self.record.max_displacement_m;
        matches!(self.termination.max_displacement, MaximumDisplacement::Known(far) if reached < far * (1.0 - 1e-9))
    }

    /// Whether the spring has not yet been loaded most: what the interface carries then is a result, too.
    fn spring_load_may_grow(&self) -> bool {
        self.goes_farther() && !self.body.problem.mechanism.spring.is_absent()
    }

    /// Without damping, the oscillation that exceeds the interface's strength loses ever less in ever more slips; they add up to
    /// the energy above that of the oscillation whose peak just equals the strength. Once that is little, and the greatest
    /// displacement is past, take them all at once.
    pub(super) fn yield_to_the_end(&mut self) {
        let mechanism = &self.body.problem.mechanism;
        let damped = !mechanism.damper.is_absent()
            || mechanism.elastic_stop().is_some_and(|stop| stop.damping_n_s_m > 0.0);
        let energy = self.body.energy_j();
        let (push, pull) = self.body.interface_limits_n();
        let at_bottom = self.body.state.travel_m >= self.body.deepest_m;
        let excess = self.body.push_at(energy) / push - 1.0;
        if damped
            || !at_bottom
            || mechanism.rigid_stop().is_some()
            || !(excess > 0.0 && excess < LAST_SLIPS)
            || self.body.pull_at(energy) > pull
            || !self.body.displacement_is_greatest(self.record.max_displacement_m)
        {
            return;
        }
        let kinetic =
            0.5 * self.body.moving_kg() * self.body.state.plate_m_s * self.body.state.plate_m_s;
        let geometry = &self.body.problem.geometry;
        let (from, strength) = (self.body.state.travel_m, self.body.problem.strength_pa);
        let swept = geometry.swept_m3(from);
        let work = |travel: f64| strength * (geometry.swept_m3(from + travel) - swept);
        // The oscillation that is left after a further `travel` must peak at the strength of the then deeper hole.
        let overload = |travel: f64| {
            let left = larger(energy - work(travel), 0.0);
            self.body.push_at(left) - geometry.area_m2(from + travel) * strength
        };
        let most = energy * excess * 4.0 / push;
        let travel = in_bracket(0.0, most, overload) * (1.0 + 1e-9);
        let lost = work(travel);
        if overload(travel) > 0.0 || lost >= kinetic {
            return;
        }
        self.body.state.plate_m_s *= (1.0 - lost / kinetic).sqrt();
        self.body.state.travel_m += travel;
        self.body.deepest_m = self.body.state.travel_m;
        self.record.work.penetration_j += lost;
        let problem = self.body.problem;
        let speed = 2.0 * problem.velocity_m_s * problem.joined_kg / problem.plate_kg;
        let drag = excess.powi(3) * problem.drag_kg_m3 * speed * speed / strength;
        self.control.crossing_error += drag * travel / self.body.state.travel_m;
    }

    /// Note what the interface carries as soon as both bodies are one, and whether their first forward half-oscillation is over.
    fn note_half_oscillation(&mut self) {
        if self.body.mode != Mode::Fused {
            return;
        }
        if self.record.push_ratio.is_none() && !self.body.is_still() && self.body.problem.flows() {
            let motion = self.body.motion();
            let force = motion.mechanism_force(&self.body.state);
            self.record.carried(&self.body, force, -force);
        }
        self.termination.oscillation = match self.termination.oscillation {
            HalfOscillation::Back if self.body.state.plate_m_s > 0.0 => HalfOscillation::Forward,
            HalfOscillation::Forward if self.body.state.plate_m_s <= 0.0 => HalfOscillation::Over,
            oscillation => oscillation,
        };
    }

    /// Whether the fused interface may still have to carry more than it has so far: until the first forward half-oscillation is
    /// over, unless the energy that is left cannot push harder.
    fn demand_may_grow(&self) -> bool {
        let strength = self.body.interface_n();
        self.body.mode == Mode::Fused
            && self.termination.oscillation != HalfOscillation::Over
            && !self.body.is_still()
            && strength > 0.0
            && self.record.push_ratio.is_some_and(|known| {
                self.body.push_at(self.body.energy_j()) > known * strength * (1.0 + DEMAND_GROWTH)
            })
    }

    /// Follows the plate after the run where way back or second swing forward may load mount or fused interface more than the run
    /// has: on an asymmetric or falling spring, or thrown back by an elastic stop. Nothing else of the run changes. On a spring
    /// of an odd power law the first swing forward is the greatest.
    pub(super) fn follow_loads<const N: usize>(&mut self, observer: Observer<'_>) -> EndReason {
        let mechanism = &self.body.problem.mechanism;
        let swings_otherwise =
            mechanism.spring.curve().is_some() || mechanism.elastic_stop().is_some();
        if !swings_otherwise || self.termination.decided.is_none() || !self.loads_may_grow() {
            return EndReason::Decided;
        }
        let Record {
            peak_mount_n, push_ratio, pull_ratio, push_exceeded_s, pull_exceeded_s, ..
        } = self.record;
        let mut after = Self {
            body: self.body.clone(),
            control: self.control.clone(),
            record: Record {
                peak_mount_n,
                push_ratio,
                pull_ratio,
                push_exceeded_s,
                pull_exceeded_s,
                ..Record::default()
            },
            termination: self.termination.clone(),
        };
        after.termination.loads = Some(Following {
            turns: 0,
            way: sign(self.body.state.plate_m_s),
            // A plate that leaves for good never turns; one that stays turns within its usual horizon.
            until_s: self.body.state.t_s + self.body.problem.horizon_s,
            steps_max: self.control.steps + STEPS_FOLLOWED,
        });
        let end = after.run::<N>(observer);
        let record = after.record;
        self.record.peak_mount_n = record.peak_mount_n;
        self.record.push_ratio = record.push_ratio;
        self.record.push_exceeded_s = record.push_exceeded_s;
        end
    }

    /// Whether a plate that is followed for its loads has not been far enough: back and forward again.
    fn loads_are_ahead(&mut self) -> bool {
        let way = sign(self.body.state.plate_m_s);
        let Some(following) = &mut self.termination.loads else { return false };
        if way * following.way < 0.0 {
            following.turns += 1;
        }
        // Where it turns, and a run often ends, it has none.
        following.way = if way == 0.0 { following.way } else { way };
        following.turns < TURNS_FOLLOWED
            && self.control.steps < following.steps_max
            && !self.body.is_at_rest()
            && self.loads_may_grow()
    }

    /// Whether the energy that is left may load the mount, or the fused interface, more than they have been.
    fn loads_may_grow(&self) -> bool {
        let (body, record) = (&self.body, &self.record);
        if body.is_still() {
            return false;
        }
        let energy_j = body.energy_j();
        let strength_n = body.interface_n();
        let push_n = body.push_at(energy_j);
        let is_carried = body.mode == Mode::Fused && !body.problem.plastic && strength_n > 0.0;
        let known_n = record.push_ratio.filter(|_| is_carried).map(|ratio| ratio * strength_n);
        let mount_n = larger(push_n, body.pull_at(energy_j)) / body.problem.interface_fraction;
        known_n.is_some_and(|known_n| push_n > known_n * (1.0 + DEMAND_GROWTH))
            || (body.problem.follows_mount_force()
                && mount_n > record.peak_mount_n * (1.0 + DEMAND_GROWTH))
    }

    /// Puts a plate at rest that oscillates about zero without contact, with less energy than rounding leaves, until it is struck
    /// again. A plate that nothing can strike any more, on a spring whose oscillations grow ever faster, rests a little earlier:
    /// they never end.
    pub(super) fn come_to_rest(&mut self) {
        let Some(law) = self.body.problem.mechanism.spring.power().filter(|law| !law.is_absent())
        else {
            return;
        };
        let for_good = self.termination.decided.is_some() && law.exponent < 1.0;
        let least = match self.body.mode {
            Mode::FreeFlight | Mode::Withdrawing | Mode::Closing
                if self.body.motion().contact == ContactForce::None =>
            {
                NO_ENERGY
            }
            Mode::Perforated | Mode::Fused if for_good => NEGLIGIBLE_ENERGY,
            _ => return,
        };
        if !self.body.is_still() && !self.body.stop_touches && self.body.has_less_than(least) {
            if self.body.mode != Mode::Fused {
                self.body.state.slip_m_s = self.body.state.projectile_m_s(self.body.problem.cos);
            }
            (self.body.state.plate_m, self.body.state.plate_m_s) = (0.0, 0.0);
            self.body.at_rest = true;
            self.control.stiff = false;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::problem::Problem;
    use crate::model::run::Departure;

    /// Scene, mode and state (q, u, x, w), and why the run is over, if it is.
    #[rustfmt::skip]
    const ENDS: [(&str, Mode, [f64; 4], Option<EndReason>); 9] = [
        ("k=1e5", Mode::Penetrating, [3e-3, 50.0, 0.0, 10.0], None),
        // Perforated, and nothing stops the plate: its greatest displacement is known not to exist.
        ("k=0", Mode::Perforated, [0.1, 50.0, 0.0, 10.0], Some(EndReason::Decided)),
        // Its spring is yet to be loaded most.
        ("k=1e5", Mode::Perforated, [0.1, 50.0, 1e-4, 10.0], None),
        ("k=1e5", Mode::Fused, [5e-3, 0.0, 1e-4, 10.0], None),
        ("k=1e5", Mode::Fused, [5e-3, 0.0, 0.0, 0.0], Some(EndReason::Decided)),
        // A damper alone: the greatest displacement is a closed form, and the load only falls.
        ("k=0 b=100", Mode::Perforated, [0.1, 50.0, 1e-4, 10.0], Some(EndReason::Decided)),
        // A spring with a damper: the greatest displacement is not known before it is reached.
        ("k=1e5 b=100", Mode::Perforated, [0.1, 50.0, 1e-4, 10.0], None),
        ("k=1e5 horizon=1e-4", Mode::Penetrating, [3e-3, 50.0, 0.0, 10.0], Some(EndReason::Horizon)),
        ("k=0 horizon=1e-4", Mode::Perforated, [0.1, 50.0, 0.0, 10.0], Some(EndReason::Decided)),
    ];

    #[test]
    fn a_run_is_over_when_its_outcome_and_greatest_displacement_are_known_or_at_its_horizon() {
        for (pairs, mode, state, expected) in ENDS {
            let problem = Problem::with(pairs);
            assert_eq!(
                Simulation::at(&problem, mode, state).finished(),
                expected,
                "{pairs} {mode:?}"
            );
        }
    }

    #[test]
    fn a_run_that_is_drawn_goes_on_for_a_quarter_of_its_contact_and_one_with_a_horizon_up_to_it() {
        let free = Problem::with("k=0");
        let mut drawn = Simulation::at(&free, Mode::Perforated, [0.1, 50.0, 0.0, 10.0]);
        drawn.record.keep_series = true;
        drawn.record.exit = Some(Departure { t_s: 1e-4, velocity_m_s: 60.0 });
        assert_eq!(drawn.finished(), None);
        assert!((drawn.until_s() / 1.25e-4 - 1.0).abs() < 1e-12, "{}", drawn.until_s());
        drawn.body.state.t_s = 1.25e-4;
        assert_eq!(drawn.finished(), Some(EndReason::Decided));
        let with_horizon = Problem::with("k=0 horizon=1e-3");
        let mut timed = Simulation::at(&with_horizon, Mode::Perforated, [0.1, 50.0, 0.0, 10.0]);
        assert_eq!(timed.finished(), None);
        assert!((timed.until_s() / 1e-3 - 1.0).abs() < 1e-12);
    }

    /// Both bodies weigh 29.5 g: the interface carries half of the spring's force, whose peak is sqrt(2 E k). Along the cylinder,
    /// behind the nose, A S stays what it is: the slips take all energy above 2 (A S)²/k, over the path q = E/(A S).
    #[test]
    fn valid_the_last_slips_take_the_energy_above_the_oscillation_that_holds() {
        let problem = Problem::with("k=1e7 interface=plastic grip=2");
        let mut simulation = Simulation::at(&problem, Mode::Fused, [0.012, 0.0, 0.0, 0.0]);
        simulation.body.deepest_m = 0.012;
        let strength_n = simulation.body.interface_n();
        let holding_j = 2.0 * strength_n * strength_n / 1e7;
        let energy_j = 1.004 * 1.004 * holding_j;
        simulation.body.state.plate_m_s = (2.0 * energy_j / problem.joined_kg).sqrt();
        // On its way to the greatest displacement each slip counts.
        simulation.yield_to_the_end();
        assert_eq!(simulation.body.state.travel_m.to_bits(), 0.012f64.to_bits());
        simulation.record.max_displacement_m = (2.0 * energy_j / 1e7).sqrt();
        simulation.yield_to_the_end();
        let slipped_m = simulation.body.state.travel_m - 0.012;
        let expected_m = (energy_j - holding_j) / strength_n;
        assert!((slipped_m / expected_m - 1.0).abs() < 1e-6, "{slipped_m} {expected_m}");
        assert_eq!(simulation.body.deepest_m.to_bits(), simulation.body.state.travel_m.to_bits());
        let left_j = simulation.body.energy_j();
        assert!(
            (energy_j - left_j - simulation.record.work.penetration_j).abs() < 1e-12 * energy_j
        );
        let load = simulation.body.push_at(left_j) / simulation.body.interface_n();
        assert!((load - 1.0).abs() < 1e-7, "{load}");
    }
}
