//! The course of two bodies from event to event: stretches of smooth motion, what the mechanism does to the plate on the
//! way, and the points to draw. What the contact does is decided by the models.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::contact::Geometry;
use crate::model::interaction::pair::{CONTACT, DAMPER, N, Pair, Push, Q, STOP, Units, V, W, X};
use crate::model::interaction::{ModelNote, blank};
use crate::model::run::Observer;
use crate::model::run::{
    Arrest, Cost, EndReason, EnergyLedger, Event, EventKind, Mode, Outcome, Run, Sample, Warning,
};
use crate::model::scene::Scene;
use crate::numerics::explicit::{Boundary, Count, Limits, Start, Stop, System as _, dop853};
use crate::numerics::{larger, smaller};

mod stop;

/// Local tolerance per tolerance asked for.
const LOCAL: f64 = 0.1;
/// Steps after which a course ends early.
const STEPS_MAX: usize = 400_000;
/// Events after which it does.
const EVENTS_MAX: usize = 20_000;
/// Events after which a plate that rattles about its neutral position is no longer stopped there: steps pass over the kink.
const KINKS_MAX: usize = 200;
/// How far before its elastic stop, per length, a plate is that has been put there.
const AT_STOP: f64 = 1e-12;
/// Points of a stretch to draw.
const POINTS: usize = 48;
/// Points in all to draw.
const POINTS_MAX: usize = 20_000;

/// What ends a stretch. Those of the mechanism are dealt with here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tag {
    /// Common velocity.
    Arrest,
    /// The interface's force has fallen to zero.
    Slack,
    /// The interface is touched again.
    Touch,
    /// The projectile has come out of the dent that the interface no longer pushes it out of.
    Clear,
    /// The interface is pressed as far as ever.
    Deepest,
    /// The plate turns back: a greatest displacement.
    Turn,
    /// The plate turns forward.
    Forward,
    /// A force law's kink.
    Kink,
    /// The stop is met.
    StopHit,
    /// A plate held by its stop is let go.
    StopRelease,
}

/// How a stretch ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fired {
    /// With this event.
    Tag(Tag),
    /// At the time asked for.
    Until,
    /// Before its time.
    Early(EndReason),
}

/// A course in progress.
pub(super) struct Course<'a> {
    pub(super) scene: &'a Arc<Scene>,
    pub(super) pair: Pair,
    pub(super) units: Units,
    pub(super) geometry: Geometry,
    pub(super) t: f64,
    pub(super) y: [f64; N],
    pub(super) mode: Mode,
    pub(super) first_arrest: Option<Arrest>,
    pub(super) events: Vec<Event>,
    pub(super) peak_n: f64,
    /// Greatest travel so far, m.
    pub(super) deepest_m: f64,
    /// Greatest plate displacement so far, scaled.
    pub(super) farthest: f64,
    pub(super) count: Count,
    series: Option<Vec<Sample>>,
    tolerance: f64,
    step: Option<f64>,
    start_x: f64,
    initial_spring: f64,
    hits: usize,
}

impl<'a> Course<'a> {
    /// First contact. `tighter` scales the tolerance.
    pub(super) fn new(scene: &'a Arc<Scene>, keep_series: bool, tighter: f64) -> Self {
        let units = Units::of(scene);
        let pair = Pair::of(scene, &units);
        let start_x = if pair.rigid { 0.0 } else { (0.0 - scene.plate.cocking_m) / units.length_m };
        let mut y = [0.0; N];
        y[V] = 1.0;
        y[X] = start_x;
        let initial_spring = pair.spring.integral(start_x);
        let mut course = Self {
            scene,
            pair,
            units,
            geometry: Geometry::of(scene),
            t: 0.0,
            y,
            mode: Mode::Penetrating,
            first_arrest: None,
            events: Vec::new(),
            peak_n: 0.0,
            deepest_m: 0.0,
            farthest: start_x,
            count: Count::default(),
            series: keep_series.then(Vec::new),
            tolerance: scene.run.tolerance * tighter * LOCAL,
            step: None,
            start_x,
            initial_spring,
            hits: 0,
        };
        course.pair.held = course.pair.rigid_stop().is_some() && start_x >= course.pair.stop_at;
        course
    }

    /// Note an event now.
    pub(super) fn event(&mut self, kind: EventKind) {
        self.events.push(Event { t_s: self.t * self.units.time_s, kind });
    }

    /// A point to draw, now.
    pub(super) fn point(&mut self) {
        let sample = self.sample();
        self.peak_n = larger(sample.contact_force_n, self.peak_n);
        self.deepest_m = larger(self.y[Q] * self.units.length_m, self.deepest_m);
        self.farthest = larger(self.y[X], self.farthest);
        if let Some(series) = self.series.as_mut().filter(|series| series.len() < POINTS_MAX) {
            series.push(sample);
        }
    }

    fn sample(&self) -> Sample {
        let (units, pair, y) = (&self.units, &self.pair, &self.y);
        let travel_m = y[Q] * units.length_m;
        let slip_m_s = pair.slip(y) * units.speed_m_s;
        let plate_m_s = if pair.is_still() { 0.0 } else { y[W] * units.speed_m_s };
        let moved_m = (y[X] - self.start_x) * units.length_m;
        Sample {
            t_s: self.t * units.time_s,
            mode: self.mode,
            penetration_m: self.geometry.depth_m(travel_m),
            projectile_displacement_m: travel_m + moved_m * pair.cos,
            projectile_velocity_m_s: slip_m_s + plate_m_s * pair.cos,
            plate_displacement_m: y[X] * units.length_m,
            plate_velocity_m_s: plate_m_s,
            contact_force_n: pair.contact_force(self.t, y) * units.force_n,
            spring_force_n: pair.spring_force(y[X]) * units.force_n,
            damper_force_n: pair.damper.force(y[W]) * units.force_n,
            stop_force_n: pair.stop_force(y[X], y[W]) * units.force_n,
            is_step: true,
        }
    }

    /// Note the first common velocity, once.
    pub(super) fn note_arrest(&mut self) {
        let kind = if self.first_arrest.is_none() {
            self.first_arrest = Some(Arrest {
                t_s: self.t * self.units.time_s,
                penetration_m: self.geometry.depth_m(self.y[Q] * self.units.length_m),
                plate_displacement_m: self.y[X] * self.units.length_m,
                plate_velocity_m_s: self.y[W] * self.units.speed_m_s,
            });
            EventKind::FirstArrest
        } else {
            EventKind::Arrest
        };
        self.event(kind);
    }

    /// Both bodies become one; the energy this takes is the contact's.
    pub(super) fn join(&mut self) {
        let pair = &mut self.pair;
        let before = 0.5 * self.y[V] * self.y[V] + 0.5 * pair.gamma * self.y[W] * self.y[W];
        let momentum = self.y[V] * pair.cos + pair.gamma * self.y[W];
        pair.joined = true;
        self.y[W] = if pair.is_still() { 0.0 } else { momentum / pair.moving_mass() };
        self.y[V] = self.y[W] * pair.cos;
        let after = 0.5 * pair.moving_mass() * self.y[W] * self.y[W];
        self.y[CONTACT] += before - after;
        self.mode = Mode::Fused;
        self.unload();
    }

    /// Go on until `until`, scaled, or the first of these events; what only concerns the mechanism is dealt with.
    pub(super) fn advance(
        &mut self,
        until: f64,
        own: &[(Tag, Boundary<N>)],
        observer: Observer<'_>,
    ) -> Fired {
        loop {
            if self.is_on_stop() {
                self.hit_stop();
                return Fired::Tag(Tag::StopHit);
            }
            let mut tags = own.to_vec();
            self.mechanism_boundaries(&mut tags);
            self.pair.boundaries = tags.iter().map(|(_, boundary)| *boundary).collect();
            let until_now = self.release_time().map_or(until, |release| smaller(release, until));
            match self.stretch(until_now, observer) {
                Err(reason) => return Fired::Early(reason),
                Ok(None) if until_now < until => {
                    self.release();
                    return Fired::Tag(Tag::StopRelease);
                }
                Ok(None) => return Fired::Until,
                Ok(Some(index)) => {
                    self.hits += 1;
                    if self.hits > EVENTS_MAX {
                        return Fired::Early(EndReason::EventBudget);
                    }
                    match tags[index].0 {
                        Tag::Kink => {}
                        Tag::StopHit => {
                            self.hit_stop();
                            return Fired::Tag(Tag::StopHit);
                        }
                        Tag::StopRelease => {
                            self.release();
                            return Fired::Tag(Tag::StopRelease);
                        }
                        // Exactly: what rounding leaves would turn again and again.
                        Tag::Forward => self.y[W] = 0.0,
                        Tag::Turn => {
                            self.y[W] = 0.0;
                            return Fired::Tag(Tag::Turn);
                        }
                        tag @ (Tag::Arrest
                        | Tag::Slack
                        | Tag::Touch
                        | Tag::Clear
                        | Tag::Deepest) => {
                            return Fired::Tag(tag);
                        }
                    }
                }
            }
        }
    }

    /// Smooth motion, in as many parts as there are points to draw.
    fn stretch(&mut self, until: f64, observer: Observer<'_>) -> Result<Option<usize>, EndReason> {
        let parts = if self.series.is_some() { POINTS } else { 8 };
        let begin = self.t;
        for part in 1..=parts {
            if observer(self.t * self.units.time_s) == ControlFlow::Break(()) {
                return Err(EndReason::Cancelled);
            }
            let to = begin + (until - begin) * part as f64 / parts as f64;
            let to = if part == parts { until } else { to };
            if to <= self.t {
                continue;
            }
            let start = Start { t: self.t, y: self.y, step: self.step };
            let limits = Limits { until: to, steps: STEPS_MAX };
            let pair = &mut self.pair;
            let end = dop853::integrate(pair, start, self.tolerance, limits, &mut self.count);
            (self.t, self.y) = (end.t, end.y);
            // A last step cut short by `to` says nothing about the next.
            self.step = (end.step > 0.0 && end.step.is_finite()).then_some(end.step);
            self.point();
            match end.stop {
                Stop::Boundary(index) => return Ok(Some(index)),
                Stop::Until => {
                    let landed = self.landed_on(&start.y);
                    if landed.is_some() {
                        return Ok(landed);
                    }
                }
                Stop::StepBudget => return Err(EndReason::StepBudget),
                Stop::StepUnderflow => return Err(EndReason::StepUnderflow),
                Stop::NonFinite => return Err(EndReason::NonFinite),
            }
        }
        Ok(None)
    }

    /// A boundary that lies exactly at the end of a part: it would not be armed in the next.
    fn landed_on(&mut self, before: &[f64; N]) -> Option<usize> {
        let rate = self.pair.rate(self.t, &self.y);
        self.pair.boundaries.iter().position(|boundary| {
            let sizes = boundary.slope.iter().zip(&self.y).map(|(slope, y)| (slope * y).abs());
            let size = sizes.sum::<f64>() + boundary.offset.abs();
            boundary.at(&self.y).abs() <= 16.0 * f64::EPSILON * size
                && boundary.at(before) > 1e-12 * size
                && boundary.along(&rate) < 0.0
        })
    }

    /// Kinks of the laws, the plate's turning, and the stop.
    fn mechanism_boundaries(&self, tags: &mut Vec<(Tag, Boundary<N>)>) {
        let pair = &self.pair;
        if pair.rigid {
            return;
        }
        let plane = |component: usize, slope: f64, offset: f64| {
            let mut boundary = Boundary { offset, slope: [0.0; N] };
            boundary.slope[component] = slope;
            boundary
        };
        let side = |z: f64| if z < 0.0 { -1.0 } else { 1.0 };
        if !pair.held {
            if !pair.spring.is_smooth_at_zero() && self.hits < KINKS_MAX {
                tags.push((Tag::Kink, plane(X, side(self.y[X]), 0.0)));
            }
            tags.push((Tag::Turn, plane(W, 1.0, 0.0)));
            // A bounce that returns within one step would not be seen: its own turn arms the stop again.
            let bounces = pair.rigid_stop().is_some();
            if bounces || !pair.damper.is_smooth_at_zero() && self.hits < KINKS_MAX {
                tags.push((Tag::Forward, plane(W, -1.0, 0.0)));
            }
            if pair.rigid_stop().is_some() {
                tags.push((Tag::StopHit, plane(X, -1.0, pair.stop_at)));
            } else if pair.has_elastic_stop() {
                tags.push((Tag::Kink, plane(X, -1.0, pair.stop_at)));
                tags.push((Tag::Kink, plane(X, 1.0, -pair.stop_at)));
                if self.y[X] - pair.stop_at > -AT_STOP * (1.0 + pair.stop_at.abs()) {
                    // Its damper would pull a plate that goes back fast, and it only pushes.
                    for sign in [1.0, -1.0] {
                        tags.push((Tag::Kink, pair.stop_plane(sign)));
                    }
                }
            }
        } else if let Push::Spring { stiffness, slack, damping } = pair.push {
            // cos F - G as a function of the state, while the plate is held.
            let held = pair.spring_force(self.y[X]);
            let mut boundary =
                Boundary { offset: -pair.cos * stiffness * slack - held, slope: [0.0; N] };
            boundary.slope[Q] = pair.cos * stiffness;
            boundary.slope[V] = pair.cos * damping;
            tags.push((Tag::StopRelease, boundary));
        }
    }

    /// Begin with a step no longer than this, scaled.
    pub(super) fn step_at_most(&mut self, step: f64) {
        self.step = Some(self.step.map_or(step, |own| smaller(own, step)));
    }

    /// The time at which the course ends at the latest, scaled: asked for, or long enough for twenty swings.
    pub(super) fn horizon(&self, contact: f64) -> f64 {
        if let Some(horizon_s) = self.scene.run.horizon_s {
            return horizon_s / self.units.time_s;
        }
        let pair = &self.pair;
        let energy = 0.5 + self.initial_spring;
        let speed = (2.0 * energy / pair.gamma).sqrt();
        let swing = pair.spring.at_integral(energy) / speed * 8.0;
        let damper = pair.damper;
        let fading = if damper.coefficient > 0.0 {
            20.0 * (pair.gamma + 1.0) * speed / damper.force(speed)
        } else {
            0.0
        };
        let parts = [20.0 * swing, fading];
        parts
            .into_iter()
            .filter(|part| part.is_finite())
            .fold(50.0 * contact, |sum, part| sum + part)
    }

    /// All energy that is neither spent nor stored in the interface, scaled.
    pub(super) fn energy_left(&self) -> f64 {
        0.5 * self.y[V] * self.y[V] + self.pair.plate_energy(&self.y)
    }

    /// The greatest displacement so far, m.
    pub(super) fn farthest_m(&self) -> f64 {
        self.farthest * self.units.length_m
    }

    /// Nothing presses the plate on its stop any more: the spring may take it back.
    pub(super) fn unload(&mut self) {
        self.pair.push = Push::None;
        if self.pair.held && self.pair.spring_force(self.y[X]) > 0.0 {
            self.release();
        }
    }

    /// The run, as far as the course knows it. The work of interface and stop contains what they store.
    pub(super) fn into_run(self, outcome: Outcome, end: EndReason) -> Run {
        let (pair, y, energy_j) = (&self.pair, &self.y, self.units.energy_j);
        let (v, w) = (y[V], if pair.is_still() { 0.0 } else { y[W] });
        let ledger = EnergyLedger {
            initial_kinetic_j: 0.5 * energy_j,
            initial_spring_j: self.initial_spring * energy_j,
            projectile_j: 0.5 * v * v * energy_j,
            inertia_j: 0.0,
            plate_j: 0.5 * pair.gamma * w * w * energy_j,
            spring_j: pair.spring.integral(y[X]) * energy_j,
            crush_j: 0.0,
            damper_j: y[DAMPER] * energy_j,
            penetration_j: y[CONTACT] * energy_j,
            stop_j: y[STOP] * energy_j,
        };
        let mut run = blank(self.scene);
        run.outcome = outcome;
        run.end = end;
        run.first_arrest = self.first_arrest;
        run.peak_contact_force_n = Some(self.peak_n);
        run.series = self.series.unwrap_or_default();
        run.events = self.events;
        run.events.sort_by(|a, b| a.t_s.total_cmp(&b.t_s));
        run.ledger = ledger;
        run.cost = Cost {
            steps: self.count.steps,
            rejected: self.count.rejected,
            rhs_evaluations: self.count.evaluations,
            method: "DOP853",
            reason: "another interaction model than the engine's",
            ..Cost::default()
        };
        if !end.is_complete() {
            run.warnings.push(Warning::EndedEarly(end));
        }
        run.warnings.extend(Warning::of_ledger(&run.ledger));
        run
    }
}

/// Put what is to be said of the model into a run's warnings.
pub(super) fn say(run: &mut Run, notes: impl IntoIterator<Item = ModelNote>) {
    run.warnings.extend(notes.into_iter().map(Warning::Model));
}
