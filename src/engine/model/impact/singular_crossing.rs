//! Crossing steps: through the zero of a non-integer power law at once, with the law's own argument as the independent variable.
//!
//! A spring |x|^n with a non-integer n is singular where the plate comes through x = 0, a damper |w|^m where it turns round;
//! Taylor steps come closer to such a moment, and leave it again, only part by part. But the plate comes through zero with speed,
//! and turns round with acceleration: there, time and path are functions of x, or of w, in which only known powers are singular
//! ([`crate::numerics::graded`]). Past x = 0 the unknown is the energy of plate and spring instead of the speed: the spring
//! returns exactly what it took.
//!
//! A crossing step goes in to the zero or out from it, and ends, like a step, where anything else happens.

use crate::model::event_function::{EventFunction, EventId};
use crate::model::impact::record::Setting;
use crate::model::impact::simulation::{Simulation, is_finite};
use crate::model::motion::State;
use crate::model::run::Mode;
use crate::numerics::event::{SignChange, first_sign_change, land};
use crate::numerics::graded::{Graded, POINTS, part_at, solve};
use crate::numerics::root::in_bracket;
use crate::numerics::{larger, maximum, smaller};

mod independent_variable;

use independent_variable::{CrossedLaw, IndependentVariable, Unknowns};

/// Part of the plate's energy, or of the force that turns it round, that may be exchanged between zero and the end of a crossing
/// step, at tolerance 1, and how it falls with the tolerance: two computations do not share their crossing steps, and with them
/// their errors.
const EXCHANGED_PART: f64 = 0.4;
const EXCHANGED_POWER: f64 = 0.025;
/// How often a crossing step out of the zero is shortened, and by what part, until it is accurate.
const TRIALS: usize = 6;
const SHORTENING: f64 = 0.4;
/// Part of the distance at which a crossing step inwards was refused from which on it is tried again.
const RETRY_PART: f64 = 0.4;
/// Mark of a zero from which no crossing step outwards was good.
const REFUSED: f64 = 0.0;
/// A crossing step outwards begins no further from zero than this part of where it ends.
const START_PART: f64 = 0.3;
/// How many times more accurate the finer of the two rules is than their difference says, at least and usually, and what
/// rounding leaves of the difference.
const ACCURACY_GAIN_MIN: f64 = 100.0;
const ACCURACY_GAIN: f64 = 1_000.0;
const DIFFERENCE_ROUNDING: f64 = 3e-14;
/// The least path of a crossing step on an elastic stop, relative to the displacement: the stop's force is known to the
/// displacement's rounding.
const STOP_PATH_MIN: f64 = 1e-3;
/// How far from zero an event function may be where it has fallen, relative to its value at the start.
const EVENT_TOLERANCE: f64 = 1e-9;
/// Ulps of the time that a fall keeps from the zero.
const ZERO_DISTANCE_TICKS: f64 = 500.0;
/// Work of one collocation, in Taylor expansions.
const COLLOCATION_WORK: usize = 10;
/// Every this many of a crossing step's points are drawn.
const DRAWN_EVERY: usize = 4;

/// An accurate stretch: its points, the state at its end, and the event that ends it, if one does.
struct Stretch {
    graded: Graded<4>,
    states: [State; POINTS],
    end: State,
    detected: Option<EventId>,
}

impl Simulation<'_> {
    /// Takes a crossing step, if a non-integer law's zero is close enough.
    pub(super) fn cross_singularity(&mut self) -> bool {
        if self.body.is_still()
            || self.control.stiff
            || self.body.x_zero.omitted
            || self.body.w_zero.omitted
        {
            return false;
        }
        let mechanism = &self.body.problem.mechanism;
        let (spring, damper) = (mechanism.spring.is_singular(), mechanism.damper.is_singular());
        spring && self.cross_by(CrossedLaw::Spring) || damper && self.cross_by(CrossedLaw::Damper)
    }

    fn cross_by(&mut self, law: CrossedLaw) -> bool {
        let motion = self.body.motion();
        let variable = IndependentVariable::new(law, &motion, self.body.state);
        let room = variable.room(EXCHANGED_PART * self.body.tolerance.powf(EXCHANGED_POWER));
        if variable.heading == 0.0 || !room.is_finite() {
            return false;
        }
        let crossed_to = &mut self.control.crossed_to[law as usize];
        if *crossed_to * variable.heading < 0.0 {
            *crossed_to = 0.0;
        }
        if variable.now() * variable.heading < 0.0 {
            self.cross_in(&variable, room)
        } else {
            self.cross_out(&variable, room)
        }
    }

    fn cross_in(&mut self, variable: &IndependentVariable<'_>, room: f64) -> bool {
        let from = variable.now().abs();
        let refused = &mut self.control.crossing_refused[variable.law as usize];
        if *refused == REFUSED {
            *refused = f64::INFINITY;
        }
        if from > smaller(*refused, room) {
            return false;
        }
        let Some(stretch) = self.stretch(variable, 0.0) else {
            self.control.crossing_refused[variable.law as usize] = RETRY_PART * from;
            return false;
        };
        self.go(variable, &stretch);
        if variable.law == CrossedLaw::Damper && stretch.end.plate_m_s == 0.0 {
            self.turned_round();
        }
        self.apply_detected(stretch.detected);
        true
    }

    /// From the zero, or from close to it, as far as there is room.
    fn cross_out(&mut self, variable: &IndependentVariable<'_>, room: f64) -> bool {
        // Ordinary steps follow a velocity only as far as it matters: it may seem to have come back towards the zero it has left.
        let now = variable.now() * variable.heading;
        let has_left = now > 0.0 && now < self.control.crossed_to[variable.law as usize].abs();
        if has_left || self.control.crossing_refused[variable.law as usize] == REFUSED {
            return false;
        }
        let mut far = room;
        for trial in 0..TRIALS {
            if variable.now().abs() > START_PART * far {
                if trial == 0 {
                    return false;
                }
                break;
            }
            if let Some(stretch) = self.stretch(variable, variable.heading * far) {
                self.go(variable, &stretch);
                self.control.crossed_to[variable.law as usize] = variable.shown(&self.body.state);
                self.apply_detected(stretch.detected);
                return true;
            }
            far *= SHORTENING;
        }
        self.control.crossing_refused[variable.law as usize] = REFUSED;
        false
    }

    /// The stretch to `to`, or to the first event on it, if it is accurate.
    fn stretch(&self, variable: &IndependentVariable<'_>, to: f64) -> Option<Stretch> {
        let whole = self.unbroken(variable, to)?;
        let taken = CrossingStep { simulation: self, variable, whole: &whole };
        let events = self.active_events();
        let mut first: Option<(EventId, EventFunction, SignChange)> = None;
        for (event, form) in events.iter().filter(|(event, _)| *event != variable.own_trigger()) {
            let value = |state: &State| form.value_beyond_rounding(variable.motion, state);
            let start = value(&self.body.state);
            let values = whole.states.each_ref().map(value);
            if start == 0.0 && values.iter().find(|it| **it != 0.0).is_some_and(|it| *it < 0.0) {
                // It may have risen and fallen in between, or have fallen from the start.
                return None;
            }
            let samples = values.into_iter().enumerate().map(|(i, value)| (part_at(i), value));
            let samples = samples.chain([(1.0, value(&whole.end))]);
            let samples = samples.skip_while(|(_, value)| start <= 0.0 && *value <= 0.0);
            let found = first_sign_change(samples, |part| value(&taken.dense(part)));
            if let Some(sign_change) = found
                && first.as_ref().is_none_or(|first| sign_change.part < first.2.part)
            {
                first = Some((*event, *form, sign_change));
            }
        }
        let Some((event, form, sign_change)) = first else { return Some(whole) };
        let landed = taken.landed(&form, &sign_change)?;
        Some(Stretch { detected: Some(event), ..landed })
    }

    /// The stretch to `to`, whatever happens on it, if it is accurate.
    fn unbroken(&self, variable: &IndependentVariable<'_>, to: f64) -> Option<Stretch> {
        let from = variable.now();
        let scale = self.crossing_scale(variable, to - from);
        let on_stop =
            variable.law == CrossedLaw::Damper && variable.motion.stop.stiffness_n_m > 0.0;
        if on_stop && scale[3] < STOP_PATH_MIN * self.body.state.plate_m.abs() {
            return None;
        }
        let rate = |z: f64, y: &Unknowns| variable.rate(&variable.state(z, y));
        self.control.worked(COLLOCATION_WORK);
        let graded = solve(from, to, &[0.0; 4], &scale, rate)?;
        let states = graded.points.each_ref().map(|point| variable.state(point.z, &point.y));
        let end = variable.state(to, &graded.end);
        let allowed = larger(ACCURACY_GAIN_MIN * self.body.local_tolerance(), DIFFERENCE_ROUNDING);
        let took_s = graded.end[0];
        let fits = graded.difference <= allowed
            && is_finite(&end)
            && self.body.state.t_s + took_s > self.body.state.t_s
            && self.body.state.t_s + took_s < self.until_s();
        fits.then_some(Stretch { graded, states, end, detected: None })
    }

    /// What errors of the unknowns are measured by, on a stretch of this length: its duration and the plate's own path or energy,
    /// and for the projectile the scales of Taylor steps.
    fn crossing_scale(&self, variable: &IndependentVariable<'_>, way: f64) -> Unknowns {
        let duration_s = (way / variable.speed()).abs();
        let path_m = self.body.state.travel_m.abs() + self.body.state.slip_m_s.abs() * duration_s;
        let plate = match variable.law {
            CrossedLaw::Spring => variable.energy(),
            CrossedLaw::Damper => {
                (0.5 * way).abs() * duration_s
                    + self.body.resolved_part() * self.body.state.travel_m.abs()
            }
        };
        [duration_s, path_m, self.body.problem.velocity_m_s, plate]
            .map(|scale| scale + f64::MIN_POSITIVE)
    }

    /// Take a stretch: work by its own rule, the greatest forces, points to draw.
    fn go(&mut self, variable: &IndependentVariable<'_>, stretch: &Stretch) {
        let Stretch { graded, states, end, detected } = stretch;
        let motion = variable.motion;
        let mut record = std::mem::take(&mut self.record);
        let setting = Setting { body: &self.body, motion };
        let taken = CrossingStep { simulation: self, variable, whole: stretch };
        // Rows at equal time steps alone: the others are at the points.
        record.draw(&setting, end.t_s, 1, |part| taken.at_time(part));
        for (place, (point, state)) in graded.points.iter().zip(states).enumerate() {
            record.worked(&setting, state, variable.rate(state)[0] * point.dz);
            if place % DRAWN_EVERY == DRAWN_EVERY / 2 {
                record.point(&setting, state, false);
            }
        }
        record.note_extremes(&setting, |force, known| {
            let value = |state: &State| motion.force(force, state);
            let close = |part: f64| value(&taken.dense(part));
            maximum::greatest_at(0.0, 1.0, known, close, |part| value(&taken.exact(part)))
        });
        self.record = record;
        if self.body.mode != Mode::Fused || self.body.problem.plastic {
            // An oblique section is not smooth enough for the finer rule to gain much.
            let finer = if motion.contact.is_smooth() { ACCURACY_GAIN } else { 1.0 };
            self.control.crossing_error += graded.difference / finer;
        }
        self.control.steps += 1;
        self.control.stretch_steps += 1;
        self.control.count_turns(motion.accelerations(&self.body.state).plate_m_s2);
        let took_s = graded.end[0];
        self.control.unit_s = larger(took_s, f64::MIN_POSITIVE);
        self.arrive(*end, motion, *detected);
    }
}

/// A stretch, to look for events on.
struct CrossingStep<'a, 'b> {
    simulation: &'a Simulation<'b>,
    variable: &'a IndependentVariable<'a>,
    whole: &'a Stretch,
}

impl CrossingStep<'_, '_> {
    fn dense(&self, part: f64) -> State {
        let (z, y) = self.whole.graded.between(part);
        self.variable.state(z, &y)
    }

    /// The state after a part of the stretch's duration.
    fn at_time(&self, part: f64) -> State {
        let time_s = part * self.whole.graded.end[0];
        let missing = |part: f64| self.whole.graded.between(part).1[0] - time_s;
        self.dense(in_bracket(0.0, 1.0, missing))
    }

    /// The stretch from the same start to this part, with the state there.
    fn anew(&self, part: f64) -> Option<(State, Stretch)> {
        let to = self.whole.graded.between(part).0;
        let stretch = self.simulation.unbroken(self.variable, to)?;
        Some((stretch.end, stretch))
    }

    /// The state at a part of the stretch, as exact as the method is.
    fn exact(&self, part: f64) -> State {
        self.anew(part).map_or_else(|| self.dense(part), |(state, _)| state)
    }

    /// The stretch to where an event function falls.
    fn landed(&self, form: &EventFunction, sign_change: &SignChange) -> Option<Stretch> {
        let (simulation, variable) = (self.simulation, self.variable);
        let aim = self.whole.graded.between(sign_change.part).0;
        let seen =
            ZERO_DISTANCE_TICKS * f64::EPSILON * simulation.body.state.t_s * variable.speed().abs();
        if aim.abs() < seen {
            // The time does not resolve the fall from the zero: scenes 2186, 3522 and 4922 inside the envelope (`tests/integration/stability`).
            let inwards = variable.now() * variable.heading < 0.0;
            return simulation
                .unbroken(variable, if inwards { 0.0 } else { variable.heading * seen });
        }
        let value = |state: &State| form.value_beyond_rounding(variable.motion, state);
        let start = value(&simulation.body.state).abs();
        let near =
            |state: &State| larger(EVENT_TOLERANCE * start, form.rounding(variable.motion, state));
        let (dense, anew) = (|part| self.dense(part), |part| self.anew(part));
        land(sign_change, dense, anew, value, near).map(|(_, stretch)| stretch)
    }
}
