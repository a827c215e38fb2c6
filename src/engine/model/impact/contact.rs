//! The contact in closed form, where only the plate's inertia (or its rigid mount) resists the projectile.

use crate::model::closed_form::{Ending, Moment, Passage, Rule};
use crate::model::event_function::EventId;
use crate::model::impact::problem::{PlateResponse, Problem};
use crate::model::impact::record::Setting;
use crate::model::impact::simulation::Simulation;
use crate::model::impact::window::hermite;
use crate::model::motion::State;
use crate::model::run::Mode;
use crate::numerics::{larger, maximum, smaller};

/// Shots that leave more slowly than this part of their velocity are integrated: the closed form's slip loses digits there.
const LIMIT_MARGIN: f64 = 0.05;
/// Points to draw on each stretch of the closed form.
const POINTS: usize = 16;

impl Simulation<'_> {
    /// Begin: with the whole contact in closed form if there is one, else with the first moments.
    pub(super) fn begin(&mut self) {
        if !self.contact_in_closed_form() {
            match self.body.missed_contact_event() {
                // A collision that takes no time.
                Some(EventId::HistoryEnd) => self.apply_transition(EventId::HistoryEnd),
                _ => self.point(),
            }
            let scales = self.body.problem.time_scales();
            self.control.unit_s = 0.1 * scales.contact_s;
            self.control.stiff = scales.is_stiff() && !self.body.is_still();
            if !self.control.stiff && self.body.mode == Mode::Penetrating {
                self.start();
            }
        }
    }

    /// The whole contact at once; `false`, with nothing changed, where the closed form does not serve.
    fn contact_in_closed_form(&mut self) -> bool {
        let problem = self.body.problem;
        let free = match problem.plate_response {
            PlateResponse::Mechanism => return false,
            PlateResponse::Rigid | PlateResponse::Fixed => false,
            PlateResponse::Free => true,
        };
        let passage = problem.passage(free);
        let ending = passage.ending();
        if let Ending::Exit { velocity_m_s } = ending
            && velocity_m_s <= LIMIT_MARGIN * problem.velocity_m_s
        {
            return false;
        }
        let rule = if self.control.is_second { Rule::FINEST } else { Rule::FINE };
        let points = if self.record.keep_series { POINTS } else { rule.points };
        let moments = passage.history(ending, Rule { points, ..rule });
        let Some(last) = moments.last().copied() else {
            return false;
        };
        if last.t_s.is_nan() || last.t_s > problem.horizon_s {
            return false;
        }
        let plate_fraction =
            if free { problem.projectile_kg * problem.cos / problem.joined_kg } else { 0.0 };
        for moment in &moments {
            self.fill_up_to(moment, plate_fraction, passage.mobility_per_kg);
            self.apply_moment(moment, plate_fraction);
        }
        let slip_energy =
            problem.velocity_m_s * problem.velocity_m_s - last.slip_m_s * last.slip_m_s;
        self.record.work.penetration_j = 0.5 * slip_energy / passage.mobility_per_kg;
        self.record.peak_contact_n = peak_n(&passage, &moments);
        if matches!(ending, Ending::Arrest { .. }) {
            if problem.plate_response == PlateResponse::Fixed {
                self.body.fixed = true;
                let force = self.body.interface_n() * problem.cos;
                let spring_m = problem.mechanism.spring.at_force(force);
                self.body.state.plate_m = smaller(spring_m, self.crept_m(&passage, &moments));
            }
            self.handle(EventId::SlipZero);
        }
        true
    }

    /// How far the contact drives a plate without inertia against its damper alone, m; infinite without one.
    fn crept_m(&self, passage: &Passage<'_>, moments: &[Moment]) -> f64 {
        let problem = self.body.problem;
        let speed = |moment: &Moment| {
            let pressure = passage.strength_pa + passage.drag_kg_m3 * moment.slip_m_s.powi(2);
            let force = problem.geometry.area_m2(moment.travel_m) * pressure * problem.cos;
            problem.mechanism.damper.at_force(force)
        };
        let part = |pair: &[Moment]| {
            0.5 * (speed(&pair[0]) + speed(&pair[1])) * (pair[1].t_s - pair[0].t_s)
        };
        moments.windows(2).map(part).sum()
    }

    /// Rows at equal time steps from the last moment to the next: cubics by the velocities, and by the accelerations.
    fn fill_up_to(&mut self, moment: &Moment, plate_fraction: f64, mobility_per_kg: f64) {
        let (problem, before) = (self.body.problem, self.body.state);
        let (span_s, motion) = (moment.t_s - before.t_s, self.body.motion());
        if !self.record.keep_series || span_s <= 0.0 {
            return;
        }
        let after = state_at(problem, moment, plate_fraction);
        let travel = [&before, &after].map(|state| state.travel_m);
        let slip = [&before, &after].map(|state| state.slip_m_s);
        let slowing =
            [&before, &after].map(|state| -span_s * mobility_per_kg * motion.contact_force(state));
        let setting = Setting { body: &self.body, motion: &motion };
        self.record.draw(&setting, moment.t_s, 1, |part| {
            let moment = Moment {
                t_s: before.t_s + part * span_s,
                travel_m: hermite(part, travel, slip.map(|speed| speed * span_s)),
                slip_m_s: hermite(part, slip, slowing),
            };
            state_at(problem, &moment, plate_fraction)
        });
    }

    /// One moment of the closed form.
    fn apply_moment(&mut self, moment: &Moment, plate_fraction: f64) {
        let problem = self.body.problem;
        let state = state_at(problem, moment, plate_fraction);
        let at_joint =
            problem.geometry.pieces().iter().any(|piece| {
                (piece.to_m - moment.travel_m).abs() <= 4.0 * f64::EPSILON * piece.to_m
            });
        self.reach(state, at_joint.then_some(EventId::PieceEnd));
        let motion = self.body.motion();
        self.record.point(&Setting { body: &self.body, motion: &motion }, &self.body.state, false);
        if at_joint {
            self.handle(EventId::PieceEnd);
        }
    }
}

/// The state at a moment: the plate has what momentum the projectile lost.
fn state_at(problem: &Problem, moment: &Moment, plate_fraction: f64) -> State {
    let gone = problem.velocity_m_s * moment.t_s - moment.travel_m;
    State {
        t_s: moment.t_s,
        travel_m: moment.travel_m,
        slip_m_s: moment.slip_m_s,
        plate_m: problem.start_m + plate_fraction * gone,
        plate_m_s: plate_fraction * (problem.velocity_m_s - moment.slip_m_s),
    }
}

fn peak_n(passage: &Passage<'_>, moments: &[Moment]) -> f64 {
    let geometry = passage.geometry;
    let end = moments.last().map_or(0.0, |moment| moment.travel_m);
    let pieces = geometry.pieces().iter().filter(|piece| piece.from_m < end);
    pieces.fold(0.0, |peak, piece| {
        let force = |q: f64| {
            let drag = passage.drag_kg_m3 * larger(passage.slip_squared(q), 0.0);
            piece.law.area_m2(&geometry.nose, q) * (passage.strength_pa + drag)
        };
        larger(peak, maximum::greatest(piece.from_m, smaller(piece.to_m, end), peak, force))
    })
}
