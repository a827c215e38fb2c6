//! What the fused interface has to carry: followed until the first forward half-oscillation is over.

use crate::model::impact::track::Track;
use crate::model::run::Mode;

/// Part of the interface's load by which it may still grow without being followed.
const DEMANDED: f64 = 1e-9;

/// How far the joined body has come on its first forward half-oscillation, in which its mechanism pushes most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Swing {
    /// Not begun.
    Back,
    /// On its way.
    Forward,
    /// Turned back.
    Turned,
}

impl Track<'_> {
    /// Note what the interface carries as soon as both bodies are one, and whether their first forward half-oscillation is over.
    pub(super) fn follow_swing(&mut self) {
        if self.body.mode != Mode::Fused {
            return;
        }
        if self.record.push_ratio.is_none() && !self.body.is_still() && self.body.problem.flows() {
            let motion = self.body.motion();
            let force = motion.mechanism_force(&self.body.state);
            self.record.carried(&self.body.setting(&motion), force, -force);
        }
        self.termination.swing = match self.termination.swing {
            Swing::Back if self.body.state.plate_m_s > 0.0 => Swing::Forward,
            Swing::Forward if self.body.state.plate_m_s <= 0.0 => Swing::Turned,
            swing => swing,
        };
    }

    /// Whether the fused interface may still have to carry more than it has so far: until the first forward half-oscillation is
    /// over, unless the energy that is left cannot push harder.
    pub(super) fn demand_may_grow(&self) -> bool {
        let strength = self.body.interface_n();
        self.body.mode == Mode::Fused
            && self.termination.swing != Swing::Turned
            && !self.body.is_still()
            && strength > 0.0
            && self.record.push_ratio.is_some_and(|known| {
                self.body.push_at(self.body.energy_j()) > known * strength * (1.0 + DEMANDED)
            })
    }
}
