//! Crossing steps: through the zero of a non-integer power law at once, with the law's own argument as the independent variable.
//!
//! A spring |x|^n with a non-integer n is singular where the plate comes through x = 0, a damper |w|^m where it turns round; Taylor
//! steps come closer to such a moment, and leave it again, only part by part. But the plate comes through zero with speed, and
//! turns round with acceleration: there, time and path are functions of x, or of w, in which only known powers are singular
//! ([`crate::numerics::graded`]). Instead of its speed the plate's and the spring's energy is carried past x = 0: what the spring
//! takes it gives back exactly.
//!
//! A crossing step goes in to the zero or out from it, and ends, like a step, where anything else happens.

use crate::model::event_function::{ActiveEvents, EventFunction, EventId};
use crate::model::impact::track::{Track, is_finite};
use crate::model::mechanism::PowerKind;
use crate::model::motion::State;
use crate::model::run::Mode;
use crate::numerics::graded::{Graded, POINTS, part_at, solve};
use crate::numerics::root::in_bracket;
use crate::numerics::{larger, smaller};

mod independent_variable;

use independent_variable::{IndependentVariable, Law, Unknowns};

/// Part of the plate's energy, or of the force that turns it round, that may be exchanged between zero and the end of a crossing
/// step, at tolerance 1, and how it falls with the tolerance: two computations do not share their crossing steps, and with them
/// their errors.
const SHARE: f64 = 0.4;
const SHARE_POWER: f64 = 0.025;
/// How often a crossing step out of the zero is shortened, and by what part, until it is accurate.
const TRIALS: usize = 6;
const SHORTER: f64 = 0.4;
/// Part of the distance at which a crossing step inwards was refused from which on it is tried again.
const NEARER: f64 = 0.4;
/// Mark of a zero from which no crossing step outwards was good.
const GIVEN_UP: f64 = 0.0;
/// A crossing step outwards begins no further from zero than this part of where it ends.
const CLOSE: f64 = 0.3;
/// How many times more accurate the finer of the two rules is than their difference says, at the least and usually, and what
/// rounding leaves of the difference.
const FINER: f64 = 100.0;
const USUALLY_FINER: f64 = 1_000.0;
const DIFFERENCE_ROUNDING: f64 = 3e-14;
/// The least path of a crossing step on an elastic stop, relative to the displacement: the stop's force is known to the
/// displacement's rounding.
const OF_STOP: f64 = 1e-3;
/// Part of its greatest value on a stretch from which on an event function that starts from zero shows its sign.
const SEEN: f64 = 1e-9;
/// How far from zero an event function may be where it has fallen, relative to its value at the start, and how often it is aimed
/// at.
const LANDED: f64 = 1e-9;
const LANDINGS: usize = 6;
/// Ulps of the time that a fall keeps from the zero.
const TICKS: f64 = 500.0;
/// Work of one collocation, in Taylor expansions.
const SOLVING: usize = 10;
/// Every so many of a crossing step's points are drawn.
const DRAWN: usize = 4;

/// A crossing step has been taken, and this event ended it.
pub(super) struct Crossed(pub(super) Option<EventId>);

/// An accurate stretch: its points, the state at its end, and the event that ends it, if one does.
struct Stretch {
    graded: Graded<4>,
    states: [State; POINTS],
    end: State,
    fired: Option<EventId>,
}

/// Where an event function falls on a stretch.
struct Fall {
    event: EventId,
    form: EventFunction,
    /// The fraction of the stretch, by the polynomial through the points, and the parts of the points on either side.
    part: f64,
    between: (f64, f64),
}

impl Track<'_> {
    /// Take a crossing step, if a non-integer law's zero is close enough.
    pub(super) fn cross_singularity(&mut self) -> Option<Crossed> {
        if self.body.is_still()
            || self.control.stiff
            || self.body.x_zero.omitted
            || self.body.w_zero.omitted
        {
            return None;
        }
        let mechanism = &self.body.problem.mechanism;
        let spring = mechanism.spring.power().is_some_and(|law| law.kind() == PowerKind::General);
        let damper = mechanism.damper.kind() == PowerKind::General;
        let by_spring = if spring { self.cross_by(Law::Spring) } else { None };
        by_spring.or_else(|| if damper { self.cross_by(Law::Damper) } else { None })
    }

    fn cross_by(&mut self, law: Law) -> Option<Crossed> {
        let motion = self.body.motion();
        let variable = IndependentVariable::new(law, &motion, self.body.state);
        let room = variable.room(SHARE * self.body.tolerance.powf(SHARE_POWER));
        if variable.heading == 0.0 || !room.is_finite() {
            return None;
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

    /// To the zero.
    fn cross_in(&mut self, variable: &IndependentVariable<'_>, room: f64) -> Option<Crossed> {
        let from = variable.now().abs();
        let refused = &mut self.control.crossing_refused[variable.law as usize];
        if *refused == GIVEN_UP {
            *refused = f64::INFINITY;
        }
        if from > smaller(*refused, room) {
            return None;
        }
        let Some(stretch) = self.stretch(variable, 0.0) else {
            self.control.crossing_refused[variable.law as usize] = NEARER * from;
            return None;
        };
        self.go(variable, &stretch);
        if variable.law == Law::Damper && stretch.end.plate_m_s == 0.0 {
            self.turned_round();
        }
        Some(Crossed(stretch.fired))
    }

    /// From the zero, or from close to it, as far as there is room.
    fn cross_out(&mut self, variable: &IndependentVariable<'_>, room: f64) -> Option<Crossed> {
        // Ordinary steps follow a velocity only as far as it matters: it may seem to have come back towards the zero it has left.
        let now = variable.now() * variable.heading;
        let has_left = now > 0.0 && now < self.control.crossed_to[variable.law as usize].abs();
        if has_left || self.control.crossing_refused[variable.law as usize] == GIVEN_UP {
            return None;
        }
        let mut far = room;
        for trial in 0..TRIALS {
            if variable.now().abs() > CLOSE * far {
                if trial == 0 {
                    return None;
                }
                break;
            }
            if let Some(stretch) = self.stretch(variable, variable.heading * far) {
                self.go(variable, &stretch);
                self.control.crossed_to[variable.law as usize] = variable.shown(&self.body.state);
                return Some(Crossed(stretch.fired));
            }
            far *= SHORTER;
        }
        self.control.crossing_refused[variable.law as usize] = GIVEN_UP;
        None
    }

    /// The stretch to `to`, or to the first event on it, if it is accurate.
    fn stretch(&self, variable: &IndependentVariable<'_>, to: f64) -> Option<Stretch> {
        let stretch = self.unbroken(variable, to)?;
        let events = self.active_events();
        if self.falls_at_once(variable, &events, &stretch) {
            return None;
        }
        let Some(fall) = self.first_fall(variable, &events, &stretch) else {
            return Some(stretch);
        };
        let landed = self.landed(variable, &stretch, &fall)?;
        Some(Stretch { fired: Some(fall.event), ..landed })
    }

    /// The stretch to where an event function falls, between two parts of a stretch. The polynomial through the points of the whole
    /// is not exact enough: new stretches end closer and closer to the fall.
    fn landed(
        &self,
        variable: &IndependentVariable<'_>,
        stretch: &Stretch,
        fall: &Fall,
    ) -> Option<Stretch> {
        let value = |state: &State| fall.form.watched(variable.motion, state);
        let place = |part: f64| stretch.graded.between(part).0;
        let mut aim = place(fall.part);
        let seen = TICKS * f64::EPSILON * self.body.state.t_s * variable.speed().abs();
        if aim.abs() < seen {
            // The time does not resolve the fall from the zero.
            let inwards = variable.now() * variable.heading < 0.0;
            return self.unbroken(variable, if inwards { 0.0 } else { variable.heading * seen });
        }
        let start = value(&self.body.state).abs();
        let mut best: Option<(f64, Stretch)> = None;
        for _ in 0..LANDINGS {
            let landed = self.unbroken(variable, aim)?;
            let last = POINTS - 1;
            let (at_end, at_last) = (value(&landed.end), value(&landed.states[last]));
            let next = aim - at_end * (aim - landed.graded.points[last].z) / (at_end - at_last);
            if best.as_ref().is_some_and(|best| at_end.abs() >= best.0) {
                break;
            }
            let exact = at_end.abs() <= fall.form.rounding(variable.motion, &landed.end);
            best = Some((at_end.abs(), landed));
            if exact {
                break;
            }
            aim = next;
        }
        if let Some((missed, landed)) = best
            && missed <= LANDED * start
        {
            return Some(landed);
        }
        // Too steep for secants.
        let end_of = |part: f64| {
            let state = if part == 0.0 { Some(self.body.state) } else { None };
            let state = state.or_else(|| Some(self.unbroken(variable, place(part))?.end));
            state.map_or(f64::NAN, |state| value(&state))
        };
        let landed =
            self.unbroken(variable, place(in_bracket(fall.between.0, fall.between.1, end_of)))?;
        let missed = value(&landed.end).abs();
        let exact = fall.form.rounding(variable.motion, &landed.end);
        (missed <= larger(LANDED * start, exact)).then_some(landed)
    }

    /// The stretch to `to`, whatever happens on it, if it is accurate.
    fn unbroken(&self, variable: &IndependentVariable<'_>, to: f64) -> Option<Stretch> {
        let from = variable.now();
        let scale = self.crossing_scale(variable, to - from);
        let on_stop = variable.law == Law::Damper && variable.motion.stop.stiffness_n_m > 0.0;
        if on_stop && scale[3] < OF_STOP * self.body.state.plate_m.abs() {
            return None;
        }
        let rate = |z: f64, y: &Unknowns| variable.rate(&variable.state(z, y));
        self.control.worked(SOLVING);
        let graded = solve(from, to, &[0.0; 4], &scale, rate)?;
        let states = graded.points.each_ref().map(|point| variable.state(point.z, &point.y));
        let end = variable.state(to, &graded.end);
        let allowed = larger(FINER * self.body.local_tolerance(), DIFFERENCE_ROUNDING);
        let took_s = graded.end[0];
        let fits = graded.difference <= allowed
            && is_finite(&end)
            && self.body.state.t_s + took_s > self.body.state.t_s
            && self.body.state.t_s + took_s < self.until_s();
        fits.then_some(Stretch { graded, states, end, fired: None })
    }

    /// Whether an event function that is zero at the start is below zero as soon as it is anything but rounding: it may have risen
    /// and fallen in between, or have fallen from the start.
    fn falls_at_once(
        &self,
        variable: &IndependentVariable<'_>,
        events: &ActiveEvents,
        stretch: &Stretch,
    ) -> bool {
        events.iter().any(|(event, form)| {
            let value = |state: &State| form.watched(variable.motion, state);
            if *event == variable.own_trigger() || value(&self.body.state) != 0.0 {
                return false;
            }
            let values = stretch.states.each_ref().map(value);
            let unseen = unseen(&values);
            values.iter().find(|value| value.abs() > unseen).is_some_and(|first| *first < 0.0)
        })
    }

    /// The first fall of an event function on a stretch.
    fn first_fall(
        &self,
        variable: &IndependentVariable<'_>,
        events: &ActiveEvents,
        stretch: &Stretch,
    ) -> Option<Fall> {
        let Stretch { graded, states, end, .. } = stretch;
        let mut first: Option<Fall> = None;
        for (event, form) in events.iter() {
            if *event == variable.own_trigger() {
                continue;
            }
            let value = |state: &State| form.watched(variable.motion, state);
            let between = |part: f64| {
                let (z, y) = graded.between(part);
                value(&variable.state(z, &y))
            };
            let mut before = (0.0, value(&self.body.state));
            // One that rises from zero is of either sign until it is seen.
            let from_zero = before.1 == 0.0;
            let mut unseen =
                if from_zero { unseen(&states.each_ref().map(value)) } else { f64::NEG_INFINITY };
            let places = states.iter().enumerate().map(|(i, state)| (part_at(i), state));
            for (part, state) in places.chain([(1.0, end)]) {
                let now = value(state);
                if now.abs() <= unseen {
                    continue;
                }
                unseen = f64::NEG_INFINITY;
                if before.1 > 0.0 && now <= 0.0 {
                    let between_parts = (before.0, part);
                    let part = in_bracket(before.0, part, between);
                    if first.as_ref().is_none_or(|first| part < first.part) {
                        let (event, form) = (*event, *form);
                        first = Some(Fall { event, form, part, between: between_parts });
                    }
                    break;
                }
                before = (part, now);
            }
        }
        first
    }

    /// What errors of the unknowns are measured by, on a stretch of this length: its duration and the plate's own path or energy,
    /// and for the projectile the scales of Taylor steps.
    fn crossing_scale(&self, variable: &IndependentVariable<'_>, way: f64) -> Unknowns {
        let duration_s = (way / variable.speed()).abs();
        let path_m = self.body.state.travel_m.abs() + self.body.state.slip_m_s.abs() * duration_s;
        let plate = match variable.law {
            Law::Spring => variable.energy(),
            Law::Damper => {
                (0.5 * way).abs() * duration_s
                    + self.body.resolved_part() * self.body.state.travel_m.abs()
            }
        };
        [duration_s, path_m, self.body.problem.velocity_m_s, plate]
            .map(|scale| scale + f64::MIN_POSITIVE)
    }

    /// Take a stretch: work by its own rule, the greatest forces, points to draw.
    fn go(&mut self, variable: &IndependentVariable<'_>, stretch: &Stretch) {
        let Stretch { graded, states, end, fired } = stretch;
        let motion = variable.motion;
        let mut record = std::mem::take(&mut self.record);
        let setting = self.body.setting(motion);
        for (place, (point, state)) in graded.points.iter().zip(states).enumerate() {
            record.worked(&setting, state, variable.rate(state)[0] * point.dz);
            if place % DRAWN == DRAWN / 2 {
                record.point(&setting, state, false);
            }
        }
        // At the place where the polynomial through the points is greatest: another stretch leads there.
        record.note_extremes(&setting, |force, known| {
            let value = |state: &State| motion.force(force, state);
            let ends = larger(value(&self.body.state), value(end));
            let Some((z, most)) = graded.greatest_at(known, |z, y| value(&variable.state(z, y)))
            else {
                return ends;
            };
            larger(self.unbroken(variable, z).map_or(most, |within| value(&within.end)), ends)
        });
        self.record = record;
        if self.body.mode != Mode::Fused || self.body.problem.plastic {
            // An oblique section is not smooth enough for the finer rule to gain much.
            let finer = if motion.contact.is_smooth() { USUALLY_FINER } else { 1.0 };
            self.control.crossing_error += graded.difference / finer;
        }
        self.control.steps += 1;
        self.control.stretch_steps += 1;
        self.control.count_turns(motion.accelerations(&self.body.state).1);
        let took_s = graded.end[0];
        self.control.unit_s = larger(took_s, f64::MIN_POSITIVE);
        self.arrive(*end, motion, *fired);
    }
}

/// What an event function that starts from zero must exceed on a stretch to show its sign.
fn unseen(values: &[f64; POINTS]) -> f64 {
    SEEN * values.iter().fold(0.0, |most, value| larger(value.abs(), most))
}
