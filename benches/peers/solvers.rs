//! Who is compared, and the form in which everyone's work is timed.

use crate::equations::Equations;
use crate::first_contact::first_contact;
use crate::scenes::{End, scene};
use crate::{explicit, stiff};

/// Result of a solver.
pub(crate) enum Outcome {
    /// Time, s, and depth, m.
    Answer(End),
    /// Failure; looser tolerances of the solver are tried all the same.
    Failed,
}

/// A solver, prepared for a scene and a tolerance, ready to be repeated.
pub(crate) type Job = Box<dyn FnMut() -> Outcome>;

/// Where a peer is worth its time.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reach {
    /// On every scene.
    All,
    /// On the stiff ones: elsewhere ten times and more behind DOP853.
    Stiff,
}

/// A peer.
pub(crate) struct Peer {
    /// Crate and method.
    pub(crate) name: &'static str,
    /// Where it is run.
    pub(crate) reach: Reach,
    /// Prepares it.
    pub(crate) prepare: fn(&Equations, f64) -> Job,
}

/// The peers. Of those the survey found competitive: `ode_solvers` (fastest on fourteen scenes) and `differential-equations`
/// (fastest on the stiff ones, S13 and S14 at 1e-8 excepted: there only `diffsol` ESDIRK34 arrives, in 316 us, and the crate takes
/// longer to compile than all others together). The rest are C, Python, or never first.
pub(crate) const PEERS: [Peer; 4] = [
    Peer { name: "dop853", reach: Reach::All, prepare: explicit::dop853 },
    Peer { name: "dopri5", reach: Reach::All, prepare: explicit::dopri5 },
    Peer { name: "bdf", reach: Reach::Stiff, prepare: stiff::bdf },
    Peer { name: "radau5", reach: Reach::Stiff, prepare: stiff::radau5 },
];

/// This program, through its one door.
pub(crate) fn ours(pairs: &str, tolerance: f64) -> Job {
    let scene = scene(pairs, tolerance);
    Box::new(move || {
        first_contact(&scene).map_or(Outcome::Failed, |end| Outcome::Answer((end.t_s, end.depth_m)))
    })
}
