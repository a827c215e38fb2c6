//! Records of a run: rows, events, work, milestones and extremes of the accepted steps.

use std::array;

use crate::model::contact_models::ContactLaw;
use crate::model::impact::contact_end::ContactEnd;
use crate::model::impact::dense_output::DenseOutput;
use crate::model::impact::equations::Equations;
use crate::model::impact::free_oscillation::FreeOscillation;
use crate::model::impact::fused_swing::FusedSwing;
use crate::model::impact::loads::{COMPRESSION_TENSION_SIGNS, Loads};
use crate::model::impact::modes::{self, Contact, HybridMode, PlateConstraint};
use crate::model::impact::parameters::{ImpactParameters, Masses};
use crate::model::impact::resolution::RESOLUTION;
use crate::model::impact::results::sample;
use crate::model::impact::state::State;
use crate::model::impact::zero_passage::ZeroPassage;
use crate::model::run::{
    Arrest, Cost, EVERY_ROWS_MAX, EnergyLedger, Event, EventKind, Parting, Sample,
};
use crate::numerics::event_location::{EventSearch, first_crossing};
use crate::numerics::quadrature::GAUSS_10;
use crate::numerics::{larger, smaller};

/// Number of rows after which only the ends of steps are kept.
const ROWS_MAX: usize = 20_000;

/// Recorder of a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Recorder {
    pub(super) keep_series: bool,
    /// Whether the marking of events has ended, but for hits on a stop: an unbounded load.
    pub(super) is_over: bool,
    /// Interval of rows at equal times, s.
    pub(super) every_s: Option<f64>,
    pub(super) series: Vec<Sample>,
    pub(super) events: Vec<Event>,
    /// Energies that are integrated; the other terms are 0.
    pub(super) work: EnergyLedger,
    pub(super) first_arrest: Option<Arrest>,
    pub(super) exit: Option<Parting>,
    pub(super) separation: Option<Parting>,
    pub(super) resumed_s: Option<f64>,
    pub(super) peak_contact_n: f64,
    pub(super) loads: Loads,
    /// Maximum displacement, m.
    pub(super) farthest_m: f64,
    /// Displacement, m, and time, s, of the reversal farthest ahead; a hit on the stop is one.
    pub(super) turn: Option<[f64; 2]>,
    /// Whether the plate was locked up to the first arrest.
    pub(super) was_held: bool,
    pub(super) cost: Cost,
    /// Free oscillation of the plate, in the second computation of an estimate.
    pub(super) oscillation: FreeOscillation,
    pub(super) contact_end: ContactEnd,
    /// Amplitude that the method has damped at the first arrest and at the maximum displacement.
    pub(super) left_out: [f64; 2],
}

impl Recorder {
    /// Records the state at first contact.
    pub(super) fn begin(&mut self, equations: &Equations<'_>, state: &State) {
        let x_m = equations.displacement_m(state.x_m);
        (self.farthest_m, self.loads.backmost_m) = (x_m, x_m);
        self.peak_contact_n = equations.contact_n(state);
        if equations.setup.law == ContactLaw::AtOnce {
            self.note(state.t_s, EventKind::FirstArrest);
            self.work.penetration_j = equations.setup.initial_j() - equations.kinetic_j(state);
        }
        if equations.setup.shears() {
            self.note(state.t_s, EventKind::Plug);
            self.work.pick_up_j = equations.setup.initial_j() - equations.kinetic_j(state);
        }
        if equations.setup.is_second() {
            self.oscillation.start(equations);
        }
        self.note_mount(equations, state);
        self.row(equations, state);
    }

    /// Records the work of contact and damper in the first moment, J.
    pub(super) fn first_moment(
        &mut self,
        setup: &ImpactParameters,
        [contact_j, damper_j]: [f64; 2],
    ) {
        *self.in_hole_j(setup) += contact_j;
        self.work.damper_j += damper_j;
    }

    /// Returns the work in the hole, or the shear work of a plug.
    fn in_hole_j(&mut self, setup: &ImpactParameters) -> &mut f64 {
        if setup.shears() { &mut self.work.shear_j } else { &mut self.work.penetration_j }
    }

    /// Records the mount force at a state.
    fn note_mount(&mut self, equations: &Equations<'_>, state: &State) {
        self.loads.mount_n = larger(equations.mount_n(state).abs(), self.loads.mount_n);
    }

    /// Records a step from its dense output.
    pub(super) fn step(&mut self, equations: &Equations<'_>, path: &DenseOutput<'_>) {
        self.cost.steps += 1;
        self.add_work(equations, path);
        self.oscillation.step(equations, path);
        self.contact_end.step(equations, path);
        self.note_displacements(equations, path);
        self.note_forces(equations, path);
        self.draw(equations, path);
    }

    /// Records a swing of fused bodies: force and displacement are greatest at an end.
    pub(super) fn swing(
        &mut self,
        equations: &Equations<'_>,
        [from, to]: [&State; 2],
        swing: &FusedSwing,
    ) {
        self.cost.steps += 1;
        self.loads.fastest_m_s = larger(swing.greatest_m_s(), self.loads.fastest_m_s);
        let [from_n, to_n] = [from, to].map(|state| equations.mechanism_n(state.x_m, 0.0));
        let most_n = [larger(from_n, to_n), larger(-from_n, -to_n)];
        self.note_loads(equations, to, most_n, |way| Some(swing.first_exceeded_s(way)));
        self.reach(equations, to);
        if self.keep_series {
            let by_time = self.every_s.is_some();
            let at = |part: f64| if by_time { swing.at_time(part) } else { swing.at(part) };
            self.draw(equations, &DenseOutput::new(&at));
        }
    }

    /// Records a passage through the zero of the spring.
    pub(super) fn passage(&mut self, equations: &Equations<'_>, passage: &ZeroPassage) {
        self.cost.steps += 1;
        let [hole_j, damper_j, weight_j] = equations.passage_works_j(passage);
        self.work.weight_j += weight_j;
        self.work.damper_j += damper_j;
        *self.in_hole_j(equations.setup) += hole_j;
        self.note_mount(equations, &passage.to);
        self.reach(equations, &passage.to);
        // Where only the spring changes, its force is greatest at an end.
        let is_simple = equations.is_undamped()
            && equations.setup.mass.turning_kg == 0.0
            && !equations.is_loading()
            && equations.mode.contact != Contact::Fused;
        if is_simple && !self.keep_series {
            return;
        }
        let by_time = self.every_s.is_some();
        let state = if by_time { Equations::passes_at_time } else { Equations::passes };
        let at = |part: f64| state(equations, passage, part);
        let path = DenseOutput::new(&at);
        self.note_forces(equations, &path);
        self.draw(equations, &path);
    }

    /// Notes the displacements on a step. A plate that a spring holds is farthest where the contact's force is greatest.
    fn note_displacements(&mut self, equations: &Equations<'_>, path: &DenseOutput<'_>) {
        if equations.mode.hold == PlateConstraint::Spring {
            let greatest_m =
                path.greatest(self.farthest_m, |state| equations.quasi_static_state(state).0);
            self.note_displacement(greatest_m);
            return;
        }
        for state in &path.looks {
            self.note_displacement(equations.shown_displacement_m(state.x_m));
        }
    }

    fn note_displacement(&mut self, x_m: f64) {
        // Increases within rounding are ignored: a plate can reach its stop many times.
        if x_m - self.farthest_m > 4.0 * f64::EPSILON * x_m.abs() {
            self.farthest_m = x_m;
            self.left_out[1] = self.oscillation.left_out;
        }
        self.loads.backmost_m = smaller(x_m, self.loads.backmost_m);
    }

    /// Records a state.
    pub(super) fn reach(&mut self, equations: &Equations<'_>, state: &State) {
        self.note_displacement(equations.shown_displacement_m(state.x_m));
        self.loads.fastest_m_s = larger(state.w_m_s.abs(), self.loads.fastest_m_s);
    }

    /// Adds the work in the hole, of the damper and of the elastic stop, by Gauss quadrature; exact for products of two dense-output
    /// polynomials.
    fn add_work(&mut self, equations: &Equations<'_>, path: &DenseOutput<'_>) {
        let is_damped = !equations.setup.damper.is_absent();
        self.work.weight_j += equations.weight_work_j(&path.looks[0], path.end());
        if !(equations.is_touching() || is_damped || equations.mode.is_pressed) {
            return;
        }
        let span_s = path.end().t_s - path.looks[0].t_s;
        for &(at, weight) in GAUSS_10.iter() {
            let state = path.at(0.5 + 0.5 * at);
            let State { u_m_s, x_m, w_m_s, .. } = state;
            let part_s = 0.5 * weight * span_s;
            *self.in_hole_j(equations.setup) += part_s * equations.contact_n(&state) * u_m_s;
            self.work.damper_j += part_s * equations.damper_n(w_m_s) * w_m_s;
            self.work.stop_j += part_s * equations.pressed_stop_n(x_m, w_m_s) * w_m_s;
        }
    }

    /// Records the peak forces of contact, mount and interface on a step, and the maximum speed of a plate with a geared inertia.
    fn note_forces(&mut self, equations: &Equations<'_>, path: &DenseOutput<'_>) {
        if equations.setup.mass.turning_kg > 0.0 {
            let known_m_s = self.loads.fastest_m_s;
            let greatest_m_s = path.greatest(known_m_s, |state| state.w_m_s.abs());
            self.loads.fastest_m_s = larger(greatest_m_s, known_m_s);
        }
        // Friction does not count as a peak force.
        let flows = equations.setup.law == ContactLaw::Flow;
        if equations.is_loading() || (!flows && equations.is_touching()) {
            let contact_n = |state: &State| equations.contact_n(state);
            let known_n = self.peak_contact_n;
            let peak_n = if matches!(equations.setup.law, ContactLaw::History(_)) {
                path.greatest(known_n, contact_n)
            } else {
                path.greatest_by_rate(known_n, contact_n, |state| equations.contact_rate_n_s(state))
            };
            self.peak_contact_n = larger(peak_n, self.peak_contact_n);
        }
        if equations.is_touching() && !equations.setup.is_rigid_mount {
            let mount_n = |state: &State| equations.mount_n(state).abs();
            let known_n = self.loads.mount_n;
            self.loads.mount_n = larger(peak_n(equations, path, known_n, mount_n), known_n);
        } else if equations.mode.hold == PlateConstraint::Free {
            self.note_mechanism(equations, path);
        }
    }

    /// Records the peak forces of the mechanism on a step without contact.
    fn note_mechanism(&mut self, equations: &Equations<'_>, path: &DenseOutput<'_>) {
        let force_n = |state: &State| equations.mechanism_n(state.x_m, state.w_m_s);
        let known_n = self.loads.known_n(equations, path.end());
        let greatest_n = array::from_fn(|direction| {
            peak_n(equations, path, known_n[direction], |state| {
                COMPRESSION_TENSION_SIGNS[direction] * force_n(state)
            })
        });
        let first_s = |direction: usize| {
            let gap_n = |state: &State| {
                equations.limit_load_ratios()[direction] * equations.strength_n(path.end())
                    - COMPRESSION_TENSION_SIGNS[direction]
                        * (equations.setup.interface_fraction() * force_n(state)
                            + equations.carried_weight_n())
            };
            let gaps_n = path.looks.each_ref().map(gap_n);
            if gaps_n[0] < 0.0 {
                return path.looks[0].t_s;
            }
            match first_crossing(&[gaps_n], true, |part, _| gap_n(&path.at(part))) {
                EventSearch::Fall(_, part) => path.at(part).t_s,
                EventSearch::Nothing | EventSearch::Unresolved(_) => path.end().t_s,
            }
        };
        self.note_loads(equations, path.end(), greatest_n, |direction| Some(first_s(direction)));
    }

    /// Records the peak forces of the mechanism forwards and backwards, N, and if known the time at which they first exceed the limit loads
    /// of a fused interface, s.
    pub(super) fn note_loads(
        &mut self,
        equations: &Equations<'_>,
        state: &State,
        most_n: [f64; 2],
        first_s: impl Fn(usize) -> Option<f64>,
    ) {
        let loads = &mut self.loads;
        // The mount does not carry the force that accelerates the geared inertia.
        let part = 1.0 - equations.setup.mass.turning_kg / equations.moving_kg();
        loads.mount_n = larger(part * larger(most_n[0], most_n[1]), loads.mount_n);
        let Some(strength_n) = equations.joint_n(state) else { return };
        if strength_n <= 0.0 {
            loads.no_strength = true;
            return;
        }
        for (direction, holds) in equations.limit_load_ratios().into_iter().enumerate() {
            let carried_n = COMPRESSION_TENSION_SIGNS[direction] * equations.carried_weight_n();
            let load_n = equations.setup.interface_fraction() * most_n[direction] + carried_n;
            let ratio = load_n / strength_n;
            let known = &mut self.loads.ratios.get_or_insert_default()[direction];
            *known = larger(ratio, *known);
            let is_new =
                !equations.setup.interface.is_plastic && self.loads.exceeded_s[direction].is_none();
            if is_new
                && ratio > holds
                && let Some(t_s) = first_s(direction)
            {
                self.loads.exceeded_s[direction] = Some(t_s);
                self.note(t_s, EventKind::InterfaceExceeded);
            }
        }
    }

    /// Adds the rows of a step, at equal times or at its sampling points.
    fn draw(&mut self, equations: &Equations<'_>, path: &DenseOutput<'_>) {
        if !self.keep_series {
            return;
        }
        if let Some(every_s) = self.every_s {
            let (from_s, to_s) = (path.looks[0].t_s, path.end().t_s);
            while let t_s = self.series.len() as f64 * every_s
                && t_s <= to_s * (1.0 + 4.0 * f64::EPSILON)
                && self.series.len() < EVERY_ROWS_MAX
            {
                let state = State { t_s, ..path.at((t_s - from_s) / (to_s - from_s)) };
                self.series.push(sample(equations, &state));
            }
            return;
        }
        let from = if self.series.len() < ROWS_MAX { 1 } else { path.looks.len() - 1 };
        self.series.extend(path.looks[from..].iter().map(|state| sample(equations, state)));
    }

    fn row(&mut self, equations: &Equations<'_>, state: &State) {
        if self.keep_series && (self.every_s.is_none() || self.series.is_empty()) {
            self.series.push(sample(equations, state));
        }
    }

    fn note(&mut self, t_s: f64, kind: EventKind) {
        if !self.is_over || kind == EventKind::StopHit {
            self.events.push(Event { t_s, kind });
        }
    }

    /// Records an event with the states and modes before and after it.
    pub(super) fn event(
        &mut self,
        event: modes::Event,
        (before, from): (&Equations<'_>, &State),
        (after, to): (&Equations<'_>, &State),
    ) {
        self.loads.fastest_m_s = larger(from.w_m_s.abs(), self.loads.fastest_m_s);
        self.reach(after, to);
        let turns = matches!(event, modes::Event::SpeedZero | modes::Event::StopReached);
        let known_m = self.turn.map_or(f64::NEG_INFINITY, |[known_m, _]| known_m);
        let x_m = after.shown_displacement_m(to.x_m);
        // An undamped plate turns again and again where it turned first.
        if turns && before.mode.w_side > 0.0 && x_m - known_m > RESOLUTION * x_m.abs() {
            self.turn = Some([x_m, to.t_s]);
        }
        let picks_up = after.setup.shears() && !before.setup.shears();
        self.mark(event, (before, from), (after, to));
        let is_corner = matches!(event, modes::Event::PieceEnd | modes::Event::PieceStart);
        if is_corner && after.setup.is_second() {
            self.oscillation.corner([before, after], to);
        }
        let lost_j = before.kinetic_j(from) - after.kinetic_j(to);
        match event {
            modes::Event::StopReached => self.work.stop_j += lost_j,
            modes::Event::HistoryEnd => self.work.penetration_j += lost_j,
            _ if picks_up => self.work.pick_up_j += lost_j,
            _ => {}
        }
        self.cost.turns += usize::from(turns && before.mode.w_side * after.mode.w_side < 0.0);
        self.note_mount(after, to);
        if after.mode.contact == Contact::Fused && after.mode.hold == PlateConstraint::Free {
            let force_n = after.mechanism_n(to.x_m, to.w_m_s);
            self.note_loads(after, to, [force_n, -force_n], |_| Some(to.t_s));
        }
        let acts = |mode: &HybridMode| (mode.contact, mode.hold, mode.is_pressed);
        let is_blow = event == modes::Event::StopReached || picks_up;
        if acts(before.mode) != acts(after.mode) || is_blow {
            self.cost.events += 1;
            self.row(after, to);
        } else if let Some(row) = self.series.last_mut()
            && self.keep_series
            && self.every_s.is_none()
        {
            *row = sample(after, to);
        }
    }

    /// Records first arrest, exit and separation at an event, and marks it.
    fn mark(
        &mut self,
        event: modes::Event,
        (before, from): (&Equations<'_>, &State),
        (after, to): (&Equations<'_>, &State),
    ) {
        let setup = before.setup;
        let (old, new) = (before.mode, after.mode);
        let flows = setup.law == ContactLaw::Flow;
        let (velocity_m_s, plate_velocity_m_s) = (setup.projectile_m_s(to), to.w_m_s);
        let parting = Parting { t_s: to.t_s, velocity_m_s, plate_velocity_m_s };
        match event {
            // The force history continues.
            modes::Event::SlipZero if !flows && old.contact == Contact::Withdrawing => {}
            // Drag alone arrests nothing.
            modes::Event::SlipZero if to.u_m_s > 0.0 => {}
            modes::Event::SlipZero | modes::Event::HistoryEnd => {
                self.arrest(after, to, old.hold == PlateConstraint::Spring);
            }
            modes::Event::PieceEnd if new.contact == Contact::Perforated => {
                self.exit = Some(parting);
                self.note(to.t_s, EventKind::Perforation);
            }
            modes::Event::PieceEnd if after.setup.shears() => self.note(to.t_s, EventKind::Plug),
            modes::Event::PieceEnd if new.contact == Contact::Penetrating => {
                self.pass_joint(setup, to);
            }
            modes::Event::Recontact => self.note(to.t_s, EventKind::Recontact),
            modes::Event::StopReached if from.w_m_s > RESOLUTION * setup.reference.velocity_m_s => {
                self.note(to.t_s, EventKind::StopHit);
            }
            _ => {}
        }
        let is_new = |contact| {
            new.contact == contact && (old.contact != contact || event == modes::Event::SlipZero)
        };
        if is_new(Contact::Penetrating) && (flows || event == modes::Event::Bottom) {
            self.resumed_s.get_or_insert(to.t_s);
            self.note(to.t_s, EventKind::Resumption);
        } else if is_new(Contact::Withdrawing) && flows {
            self.note(to.t_s, EventKind::PullOut);
        } else if new.contact == Contact::FreeFlight && old.contact != Contact::FreeFlight {
            // A velocity below the tolerance, relative to the impact velocity, is zero.
            let is_known = parting.velocity_m_s.abs()
                > setup.numerics.tolerance * setup.reference.velocity_m_s;
            let velocity_m_s = if is_known { parting.velocity_m_s } else { 0.0 };
            self.separation = Some(Parting { velocity_m_s, ..parting });
            self.note(to.t_s, EventKind::Separation);
        }
        match (old.hold, new.hold) {
            (PlateConstraint::Free, PlateConstraint::OnStop) => {
                self.note(to.t_s, EventKind::StopHold);
            }
            (PlateConstraint::OnStop, PlateConstraint::Free) => {
                self.note(to.t_s, EventKind::StopRelease);
            }
            _ => {}
        }
    }

    fn arrest(&mut self, after: &Equations<'_>, state: &State, is_held: bool) {
        let is_first = self.first_arrest.is_none();
        self.note(state.t_s, if is_first { EventKind::FirstArrest } else { EventKind::Arrest });
        if is_first {
            self.was_held = is_held;
            self.left_out[0] = self.oscillation.left_out;
            self.first_arrest = Some(Arrest {
                t_s: state.t_s,
                penetration_m: after.setup.geometry.depth_m(state.q_m),
                plate_displacement_m: after.shown_displacement_m(state.x_m),
                plate_velocity_m_s: state.w_m_s,
            });
        }
    }

    /// Marks the buried nose and the arrival at the rear face, at an end of a piece of the area law.
    fn pass_joint(&mut self, setup: &ImpactParameters, state: &State) {
        let geometry = &setup.geometry;
        let is_at =
            |depth_m: f64| (geometry.depth_m(state.q_m) - depth_m).abs() < RESOLUTION * depth_m;
        if is_at(geometry.thickness_m) {
            self.note(state.t_s, EventKind::RearFace);
        } else if is_at(geometry.nose.buried_from_m()) {
            self.note(state.t_s, EventKind::NoseBuried);
        }
    }
}

impl Equations<'_> {
    /// Returns the kinetic energy of both bodies, J.
    pub(super) fn kinetic_j(&self, state: &State) -> f64 {
        let Masses { projectile_kg, plate_kg, .. } = self.setup.mass;
        let (v, w) = (self.setup.projectile_m_s(state), state.w_m_s);
        0.5 * (projectile_kg * v * v + plate_kg * w * w)
    }
}

/// Returns the peak of a force of the mechanism on a step; that of a power law is at an extreme displacement, up to rounding a sample.
fn peak_n(
    equations: &Equations<'_>,
    path: &DenseOutput<'_>,
    known_n: f64,
    force_n: impl Fn(&State) -> f64,
) -> f64 {
    let is_elastic = equations.is_undamped() && equations.mode.spring.power().is_some();
    if is_elastic
        && equations.mode.hold == PlateConstraint::Free
        && equations.setup.mass.turning_kg == 0.0
    {
        let extreme = |direction: f64| {
            let beyond = |most: &&State, state: &State| direction * (state.x_m - most.x_m) > 0.0;
            let first = &path.looks[0];
            path.looks.iter().fold(first, |most, it| if beyond(&most, it) { it } else { most })
        };
        larger(force_n(extreme(1.0)), force_n(extreme(-1.0)))
    } else {
        path.greatest(known_n, force_n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::impact::tests::{is_near, look};

    /// In a step of a second. Half of k x goes through an interface that bears pi p (2 R - p) `S_y` pushed, and a tenth of it pulled.
    #[test]
    fn valid_an_excess_is_noted_where_the_force_exceeds_the_strength() {
        let strength_n = std::f64::consts::PI / 300.0 * (0.0127 - 0.01 / 3.0) * 1.52e8;
        for (direction, (far_m, holds)) in [(4e-3, 1.0), (-4e-3, 0.1)].into_iter().enumerate() {
            let at = |s: f64| State { t_s: s, q_m: 5e-3, x_m: far_m * s, ..State::default() };
            let record = look("gamma=1 k=1e7", Contact::Fused, [0.0; 4], |equations, _| {
                let mut record = Recorder::default();
                record.step(equations, &DenseOutput::new(&at));
                record
            });
            let t_s = record.loads.exceeded_s[direction].unwrap();
            assert!(is_near(t_s, holds * strength_n / (5e6 * 4e-3), 1e-9));
            assert_eq!(record.events, [Event { t_s, kind: EventKind::InterfaceExceeded }]);
            assert!(is_near(
                record.loads.ratios.unwrap()[direction],
                5e6 * 4e-3 / strength_n,
                1e-13
            ));
            assert!(is_near(record.loads.mount_n, 1e7 * 4e-3, 1e-13));
        }
    }
}
