//! What follows the contact: the plate on its mechanism, alone or with the projectile, to its greatest displacement.

use crate::model::interaction::course::{Course, Fired, Tag};
use crate::model::interaction::pair::{W, X};
use crate::model::run::Observer;
use crate::model::run::{EndReason, EventKind};
use crate::numerics::{larger, smaller};

/// A plate slowed by its damper alone to this part of its speed has arrived, for the eye.
const FADED: f64 = 1e-2;

impl Course<'_> {
    /// Nothing pushes any more: on to the greatest displacement, and to the horizon where one is asked for. Gives the greatest
    /// displacement, m, and why the course ended.
    pub(super) fn coast(
        &mut self,
        horizon: f64,
        observer: Observer<'_>,
    ) -> (Option<f64>, EndReason) {
        let asked = self.scene.run.horizon_s.is_some();
        let mut known = self.known_farthest();
        let until = if known == Some(f64::INFINITY) || self.pair.is_still() {
            if asked { horizon } else { smaller(1.25 * self.t + 1.0, horizon) }
        } else if self.only_damped() {
            if asked { horizon } else { smaller(self.faded(), horizon) }
        } else {
            horizon
        };
        let mut end = if known.is_some() { EndReason::Decided } else { EndReason::Horizon };
        let mut turned = known.is_some() && !self.has_swing();
        while self.t < until {
            match self.advance(until, &[], observer) {
                Fired::Early(reason) => {
                    end = reason;
                    break;
                }
                Fired::Until => break,
                Fired::Tag(Tag::Turn) if !turned => {
                    self.event(EventKind::GreatestDisplacement);
                    turned = true;
                    let reached = larger(known.unwrap_or(self.farthest), self.farthest);
                    known = Some(reached);
                    end = EndReason::Decided;
                    if !asked {
                        break;
                    }
                }
                Fired::Tag(_) => {}
            }
            if self.pair.held && !asked {
                known = Some(self.farthest);
                end = EndReason::Decided;
                break;
            }
        }
        let metres = known.filter(|x| x.is_finite()).map(|x| x * self.units.length_m);
        (metres, end)
    }

    /// Whether the plate still swings forward towards a turning point.
    fn has_swing(&self) -> bool {
        !self.pair.is_still() && self.y[W] > 0.0 && !self.only_damped() && !self.pair.is_free()
    }

    fn only_damped(&self) -> bool {
        let pair = &self.pair;
        pair.spring.coefficient == 0.0 && pair.stop.is_none() && pair.damper.coefficient > 0.0
    }

    /// The greatest displacement where it is known beforehand; infinite where nothing stops the plate.
    fn known_farthest(&self) -> Option<f64> {
        let (pair, x, w) = (&self.pair, self.y[X], self.y[W]);
        if pair.is_still() || (w <= 0.0 && x >= 0.0) {
            return Some(self.farthest);
        }
        if pair.is_free() {
            return Some(f64::INFINITY);
        }
        if self.only_damped() {
            let m = pair.damper.exponent;
            let travel =
                pair.moving_mass() * w.abs().powf(2.0 - m) / (pair.damper.coefficient * (2.0 - m));
            return Some(if m < 2.0 { larger(x + travel, self.farthest) } else { f64::INFINITY });
        }
        if pair.damper.coefficient == 0.0 && pair.stop.is_none() {
            return Some(larger(
                pair.spring.at_integral(pair.plate_energy(&self.y)),
                self.farthest,
            ));
        }
        None
    }

    /// When a plate that only a damper slows has arrived, for the eye.
    fn faded(&self) -> f64 {
        let (pair, w) = (&self.pair, self.y[W].abs());
        let rate = pair.damper.force(w) / (pair.moving_mass() * w);
        self.t + (1.0 / FADED).ln() / rate
    }
}
