//! The record of a run: series, events, extremes and work.

use crate::model::impact::body::Body;
use crate::model::impact::window::Window;
use crate::model::motion::{Expansion, Force, Motion, State};
use crate::model::run::{Arrest, Departure, EnergyLedger, Event, EventKind, Mode, Sample};
use crate::numerics::root::each_down_crossing;
use crate::numerics::series::{evaluate, slope};
use crate::numerics::{larger, maximum, smaller};

/// Points drawn within each Taylor step, its end included.
const POINTS_PER_STEP: usize = 8;

/// Rows after which only the solver's own steps are kept: as many as its work allows.
const POINTS_MAX: usize = 20_000;

/// Part of a series' variation by which it may miss its quantity at the end of a step.
const CONVERGED: f64 = 1e-7;

/// What is recorded of a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Record<'a> {
    pub(super) keep_series: bool,
    /// Where the run so far is shown, if anywhere.
    pub(super) window: Option<&'a Window>,
    pub(super) series: Vec<Sample>,
    pub(super) events: Vec<Event>,
    /// The energies that have to be integrated; of the others nothing.
    pub(super) work: EnergyLedger,
    pub(super) first_arrest: Option<Arrest>,
    pub(super) exit: Option<Departure>,
    pub(super) separation: Option<Departure>,
    pub(super) resumed_s: Option<f64>,
    pub(super) peak_contact_n: f64,
    /// Greatest force of spring, damper and elastic stop, where the greatest displacement does not determine it, N.
    pub(super) peak_mount_n: f64,
    pub(super) max_displacement_m: f64,
    pub(super) max_displacement_s: f64,
    pub(super) min_displacement_m: f64,
    /// Greatest push and pull through the interface while fused, over A `S_y`, and when the limits were first passed, s.
    pub(super) push_ratio: Option<f64>,
    pub(super) pull_ratio: f64,
    pub(super) push_exceeded_s: Option<f64>,
    pub(super) pull_exceeded_s: Option<f64>,
    pub(super) no_strength: bool,
}

/// The body on a step, with the equations that hold on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setting<'a> {
    pub(super) body: &'a Body<'a>,
    pub(super) motion: &'a Motion<'a>,
}

impl Setting<'_> {
    pub(super) fn sample(&self, state: &State, is_step: bool) -> Sample {
        let Self { body, motion } = self;
        let (problem, mode) = (body.problem, body.mode);
        let mechanism = &problem.mechanism;
        let (spring, damper) =
            (mechanism.spring.force(state.plate_m), mechanism.damper.force(state.plate_m_s));
        let contact = match mode {
            Mode::Fused if body.is_still() => 0.0,
            Mode::Fused => {
                problem.interface_fraction * (spring + damper + motion.stop_force(state))
            }
            _ => motion.contact_force(state),
        };
        let stop = if body.rests_on_stop {
            contact * problem.cos - spring
        } else {
            motion.stop_force(state)
        };
        Sample {
            t_s: state.t_s,
            mode,
            penetration_m: problem.depth_m(state.travel_m),
            projectile_displacement_m: state.travel_m
                + (state.plate_m - problem.start_m) * problem.cos,
            projectile_velocity_m_s: state.projectile_m_s(problem.cos),
            plate_displacement_m: state.plate_m,
            plate_velocity_m_s: state.plate_m_s,
            contact_force_n: contact,
            spring_force_n: spring,
            damper_force_n: damper,
            stop_force_n: stop,
            is_step,
        }
    }
}

impl Record<'_> {
    pub(super) fn event(&mut self, t_s: f64, kind: EventKind) {
        self.events.push(Event { t_s, kind });
    }

    pub(super) fn point(&mut self, setting: &Setting<'_>, state: &State, is_step: bool) {
        if !self.keep_series {
            return;
        }
        let row = setting.sample(state, is_step);
        if let Some(window) = self.window {
            window.reach(&row);
        }
        self.series.push(row);
    }

    /// Note a displacement that may be the greatest, or the least, so far.
    pub(super) fn reach(&mut self, state: &State) {
        if state.plate_m > self.max_displacement_m {
            (self.max_displacement_m, self.max_displacement_s) = (state.plate_m, state.t_s);
        }
        self.min_displacement_m = smaller(state.plate_m, self.min_displacement_m);
    }

    /// Write down a step of an expansion: points to draw, work done, extremes of the forces. `span` is the part
    /// of the time unit that was used.
    pub(super) fn step<const N: usize>(
        &mut self,
        setting: &Setting<'_>,
        e: &Expansion<N>,
        span: f64,
    ) {
        let h = e.unit_s;
        self.work.penetration_j += integral(&e.contact, &e.slip, span) * h;
        if !setting.motion.damper.is_absent() {
            self.work.damper_j += integral(&e.damper, &e.plate_speed, span) * h;
        }
        let stop = setting.motion.stop;
        if stop.stiffness_n_m > 0.0 {
            let mut force = [0.0; N];
            for (j, force) in force.iter_mut().enumerate() {
                *force = stop.stiffness_n_m * e.plate[j] + stop.damping_n_s_m * e.plate_speed[j];
            }
            force[0] -= stop.stiffness_n_m * stop.slack_m;
            self.work.stop_j += integral(&force, &e.plate_speed, span) * h;
        }
        self.note_extremes(setting, |force, known| {
            let backwards;
            let series = match force {
                Force::Contact => &e.contact,
                Force::Push => &e.mechanism,
                Force::Pull => {
                    backwards = e.mechanism.map(|c| -c);
                    &backwards
                }
            };
            greatest(series, span, known, |s| setting.motion.force(force, &e.state(s)))
        });
        self.draw(setting, e.t_s + span * h, POINTS_PER_STEP, |part| e.state(span * part));
    }

    /// Draws the step to a time by its dense output: rows at equal time steps where they are wanted, and between the ends of a given number
    /// of equal parts.
    pub(super) fn draw(
        &mut self,
        setting: &Setting<'_>,
        to_s: f64,
        parts: usize,
        dense: impl Fn(f64) -> State,
    ) {
        if !self.keep_series {
            return;
        }
        if let Some(window) = self.window {
            let from_s = setting.body.state.t_s;
            let at = |t_s: f64| State { t_s, ..dense((t_s - from_s) / (to_s - from_s)) };
            window.fill(to_s, |t_s| setting.sample(&at(t_s), false));
        }
        if self.series.len() < POINTS_MAX {
            let between = (1..parts).map(|part| dense(part as f64 / parts as f64));
            self.series.extend(between.map(|state| setting.sample(&state, false)));
        }
    }

    /// Add the work done in a time `dt_s` at a state: one term of a quadrature.
    pub(super) fn worked(&mut self, setting: &Setting<'_>, state: &State, dt_s: f64) {
        let motion = setting.motion;
        let (work, w) = (&mut self.work, state.plate_m_s);
        work.penetration_j += dt_s * motion.contact_force(state) * state.slip_m_s;
        work.damper_j += dt_s * motion.damper.force(w) * w;
        work.stop_j += dt_s * motion.stop_force(state) * w;
    }

    /// Note the greatest forces of a step. `greatest` finds that of one force, as far as it exceeds what is known, N.
    pub(super) fn note_extremes(
        &mut self,
        setting: &Setting<'_>,
        greatest: impl Fn(Force, f64) -> f64,
    ) {
        let (body, problem) = (setting.body, setting.body.problem);
        match body.mode {
            Mode::Closing | Mode::Withdrawing if problem.flows() => {}
            Mode::Penetrating | Mode::Closing | Mode::Withdrawing => {
                let peak = greatest(Force::Contact, self.peak_contact_n);
                self.peak_contact_n = larger(peak, self.peak_contact_n);
            }
            Mode::Fused => {
                // The greatest forces forwards and backwards so far, as far as the interface's strength says.
                let per_ratio_n = body.interface_n() / problem.interface_fraction;
                let push_n = self.push_ratio.unwrap_or(0.0) * per_ratio_n;
                let pull_n = self.pull_ratio * per_ratio_n;
                self.carried(body, greatest(Force::Push, push_n), greatest(Force::Pull, pull_n));
            }
            Mode::FreeFlight | Mode::Perforated => {}
        }
        if !problem.follows_mount_force() {
            return;
        }
        // What a plate on its stop does not take, the mount does.
        let (forces, part): (&[Force], f64) = if body.rests_on_stop {
            (&[Force::Contact], problem.cos)
        } else {
            (&[Force::Push, Force::Pull], 1.0)
        };
        for force in forces {
            let peak = part * greatest(*force, self.peak_mount_n / part);
            self.peak_mount_n = larger(peak, self.peak_mount_n);
        }
    }

    /// Note the greatest forces of the mechanism, forwards and backwards, N; a fused interface carries its fraction of them.
    pub(super) fn carried(&mut self, body: &Body<'_>, push_n: f64, pull_n: f64) {
        if body.is_still() || !body.problem.flows() {
            return;
        }
        let interface_n = body.interface_n();
        if interface_n > 0.0 {
            let part = body.problem.interface_fraction / interface_n;
            let (push, pull) = (part * push_n, part * pull_n);
            let known = self.push_ratio.unwrap_or(0.0);
            self.push_ratio = Some(if push > known { push } else { known });
            self.pull_ratio = if pull > self.pull_ratio { pull } else { self.pull_ratio };
        } else {
            self.no_strength = true;
        }
    }
}

/// The integral of f·g over the first `span` of the time unit, of all of the product's terms: their decay is not what
/// the step was chosen by.
fn integral<const N: usize>(f: &[f64; N], g: &[f64; N], span: f64) -> f64 {
    // Row by row, so that the inner loop runs over neighbours and becomes vector instructions.
    let mut product = [0.0; TERMS_MAX];
    for (i, &f) in f.iter().enumerate() {
        for (term, &g) in product[i..i + N].iter_mut().zip(g) {
            *term += f * g;
        }
    }
    let terms = product[..2 * N - 1].iter().zip(&RECIPROCALS).rev();
    terms.fold(0.0, |sum, (term, reciprocal)| sum * span + term * reciprocal) * span
}

/// Terms of the product of two series of the longest expansion, at most.
const TERMS_MAX: usize = 64;

/// 1, 1/2, 1/3, ...: what the integral of each power of the time is multiplied by.
const RECIPROCALS: [f64; TERMS_MAX] = {
    let mut reciprocals = [0.0; TERMS_MAX];
    let mut order = 0;
    while order < TERMS_MAX {
        reciprocals[order] = 1.0 / (order as f64 + 1.0);
        order += 1;
    }
    reciprocals
};

/// The greatest value of a quantity on the first `span` of the time unit, as far as it exceeds what is known: at an end, or where
/// the slope of its series falls through zero. The series only shows where: the value there is that of the state. A series that
/// has not converged, although those of the state have, says nothing.
fn greatest<const N: usize>(
    series: &[f64; N],
    span: f64,
    known: f64,
    value: impl Fn(f64) -> f64,
) -> f64 {
    let (start, end) = (series[0], value(span));
    let best = larger(start, end);
    // The most by which series and slope may vary.
    let (mut size, mut bend, mut power) = (0.0, 0.0, 1.0);
    for (j, c) in series.iter().enumerate().skip(1) {
        bend += if j > 1 { j as f64 * (c * power).abs() } else { 0.0 };
        power *= span;
        size += (c * power).abs();
    }
    let is_converged = (evaluate(series, span) - end).abs() <= CONVERGED * size;
    if !is_converged {
        return larger(maximum::greatest(0.0, span, known, &value), best);
    }
    let does_not_matter = bend <= series[1].abs() || start + size <= known;
    let mut most = best;
    if !does_not_matter {
        each_down_crossing(&slope(series), span, |s| most = larger(value(s), most));
    }
    most
}
