//! When a plate that oscillates without contact is taken to be at rest.

use crate::model::impact::body::NO_ENERGY;
use crate::model::impact::track::Track;
use crate::model::motion::ContactForce;
use crate::model::run::Mode;

/// Energy below this part of the projectile's that nothing depends on any more: below the rounding of the energies.
const LITTLE_ENERGY: f64 = 1e-18;

impl Track<'_> {
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
            Mode::Perforated | Mode::Fused if for_good => LITTLE_ENERGY,
            _ => return,
        };
        if !self.body.is_still() && !self.body.stop_touches && self.body.has_less_than(least) {
            if self.body.mode != Mode::Fused {
                self.body.state.slip_m_s += self.body.state.plate_m_s * self.body.problem.cos;
            }
            (self.body.state.plate_m, self.body.state.plate_m_s) = (0.0, 0.0);
            self.body.at_rest = true;
            self.control.stiff = false;
        }
    }
}
