//! When a plate that oscillates without contact is taken to be at rest.

use crate::model::impact::termination::{DEAD, FAINT};
use crate::model::impact::track::Track;
use crate::model::motion::ContactForce;
use crate::model::run::Mode;

impl Track<'_> {
    /// Puts a plate at rest that oscillates about zero without contact, with less energy than rounding leaves, until it is struck
    /// again. A plate that nothing can strike any more, on a spring whose oscillations grow ever faster, rests a little earlier:
    /// they never end.
    pub(super) fn come_to_rest(&mut self) {
        let Some(law) = self.problem.mechanism.spring.power().filter(|law| law.coefficient > 0.0)
        else {
            return;
        };
        let for_good = self.decided.is_some() && law.exponent < 1.0;
        let least = match self.mode {
            Mode::FreeFlight | Mode::Withdrawing | Mode::Closing
                if self.motion().contact == ContactForce::None =>
            {
                DEAD
            }
            Mode::Perforated | Mode::Fused if for_good => FAINT,
            Mode::Penetrating
            | Mode::Withdrawing
            | Mode::Closing
            | Mode::FreeFlight
            | Mode::Fused
            | Mode::Perforated => return,
        };
        if !self.is_still() && !self.stop_touches && self.has_less_than(least) {
            if self.mode != Mode::Fused {
                self.state.slip_m_s += self.state.plate_m_s * self.problem.cos;
            }
            (self.state.plate_m, self.state.plate_m_s) = (0.0, 0.0);
            self.resting = true;
            self.stiff = false;
        }
    }
}
