//! What a run leaves: milestones and extremes, each from the accepted steps.

use crate::model::contact_models::Law;
use crate::model::hybrid::equations::{Equations, State};
use crate::model::hybrid::modes::{Contact, Event, Mode};
use crate::model::run::{Arrest, Departure};
use crate::numerics::larger;
use crate::numerics::maximum::greatest;

/// What is recorded of a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Record {
    pub(super) first_arrest: Option<Arrest>,
    pub(super) exit: Option<Departure>,
    pub(super) separation: Option<Departure>,
    pub(super) peak_contact_n: f64,
    /// Greatest displacement, m.
    pub(super) farthest_m: f64,
    /// Greatest force forwards through the joined interface over its strength in compression.
    pub(super) demand_ratio: Option<f64>,
    pub(super) steps: usize,
    pub(super) events: usize,
    pub(super) evaluations: usize,
    /// Ways forward of the joined body that have ended.
    pub(super) swings: usize,
}

impl Record {
    /// Notes a step, whose states are given by the part of it.
    pub(super) fn step(&mut self, equations: &Equations<'_>, at: impl Fn(f64) -> State) {
        self.steps += 1;
        let end = at(1.0);
        self.reach(equations.displacement_m(end.x_m));
        // Friction is no peak.
        let pushes = equations.goes_in() || equations.setup.law != Law::Flow;
        match equations.mode.contact {
            Contact::Deepening | Contact::PullingOut if pushes => {
                let force = |theta: f64| {
                    let state = at(theta);
                    equations.contact_n(&state)
                };
                let peak = greatest(0.0, 1.0, self.peak_contact_n, force);
                self.peak_contact_n = larger(peak, self.peak_contact_n);
            }
            Contact::Joined => {
                let known_n = self.demand_ratio.unwrap_or(0.0) * equations.strength_n(&end);
                let carried = |theta: f64| equations.carried_n(&at(theta));
                let most_n = if equations.is_undamped() {
                    // Spring and stop push most at an end: the plate turns only there.
                    larger(carried(0.0), carried(1.0))
                } else {
                    greatest(0.0, 1.0, known_n, carried)
                };
                self.carried(equations, &end, most_n);
            }
            _ => {}
        }
    }

    /// Notes a force through the joined interface.
    pub(super) fn carried(&mut self, equations: &Equations<'_>, state: &State, force_n: f64) {
        let strength_n = equations.strength_n(state);
        if strength_n > 0.0 && !equations.plate_rests() {
            let known = self.demand_ratio.unwrap_or(0.0);
            self.demand_ratio = Some(larger(known, force_n / strength_n));
        }
    }

    fn reach(&mut self, x_m: f64) {
        self.farthest_m = larger(x_m, self.farthest_m);
    }

    /// Notes an event and what it led to.
    pub(super) fn event(
        &mut self,
        event: Event,
        before: &Equations<'_>,
        after: &Mode,
        state: &State,
    ) {
        let setup = before.setup;
        self.events += 1;
        self.reach(after.origin_m + state.x_m);
        let departure = Departure { t_s: state.t_s, velocity_m_s: setup.projectile_m_s(state) };
        if matches!(event, Event::SlipZero | Event::HistoryEnd) && self.first_arrest.is_none() {
            self.first_arrest = Some(Arrest {
                t_s: state.t_s,
                penetration_m: setup.geometry.depth_m(state.q_m),
                plate_displacement_m: after.origin_m + state.x_m,
                plate_velocity_m_s: state.w_m_s,
            });
        }
        if after.contact == Contact::Gone && before.mode.contact != Contact::Gone {
            self.exit = Some(departure);
        }
        if after.contact == Contact::Apart && before.mode.contact != Contact::Apart {
            self.separation = Some(departure);
        }
        let turns_back =
            matches!(event, Event::SpeedZero | Event::StopReached) && after.w_side < 0.0;
        self.swings += usize::from(turns_back && after.contact == Contact::Joined);
        if after.contact == Contact::Joined {
            let now = Equations { setup, mode: after };
            self.carried(&now, state, now.carried_n(state));
        }
    }
}
