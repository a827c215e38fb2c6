//! Discrete states between events, and the events that end them.

use crate::model::contact::AreaPiece;
use crate::model::mechanism::Spring;
/// Contact of projectile and plate; the `mode` of a row.
pub(super) use crate::model::run::ContactMode as Contact;

/// Constraint of the plate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PlateConstraint {
    /// No constraint: the plate moves.
    Free,
    /// Rigid stop that the plate is pressed on.
    OnStop,
    /// Spring that is singular at the position of the plate (locked plate).
    Spring,
    /// Rigid mount.
    Mount,
}

/// Discrete state of the hybrid system between two events.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct HybridMode {
    pub(super) contact: Contact,
    pub(super) hold: PlateConstraint,
    /// Displacement at which a locked plate unlocks, m.
    pub(super) held_m: f64,
    /// Whether the plate is pressed on its elastic stop.
    pub(super) is_pressed: bool,
    /// Piece of the area law at the nose.
    pub(super) piece: AreaPiece,
    /// Maximum travel so far: bottom of the hole.
    pub(super) deepest_m: f64,
    /// Volumes that the nose has swept up to where plastic bodies stick and up to the bottom of the hole, m³; `None` while they slip.
    pub(super) stuck_m3: Option<[f64; 2]>,
    /// Origin of the displacement in the state, m: zero, or the stop once the plate has struck it, so that small bounces keep their digits.
    pub(super) origin_m: f64,
    pub(super) spring: Spring,
    /// Combined law of spring and elastic stop.
    pub(super) elastic: Spring,
    /// Piece of the spring's law at the plate, or that it enters.
    pub(super) stretch: usize,
    /// Crushed length of the absorber, m.
    pub(super) crushed_m: f64,
    /// Energy dissipated by crushing, J.
    pub(super) crushed_j: f64,
    /// Smallest error scales of the plate's displacement, m, and velocity, m/s.
    pub(super) least: [f64; 2],
    /// Direction of motion of the plate, 1 or -1; that it starts in if at rest.
    pub(super) w_side: f64,
}

/// Event that ends a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Event {
    /// Upper end of a piece of the area law; at the last one the nose is through, or picks up the plug.
    PieceEnd,
    /// Lower end of a piece of the area law; at the first one the nose is out.
    PieceStart,
    /// Return to the bottom of the hole.
    Bottom,
    /// Zero of the relative velocity.
    SlipZero,
    /// Renewed contact of a projectile that was out of contact.
    Recontact,
    /// End of the force of a lumped interface.
    ContactLost,
    /// End of the prescribed force history.
    HistoryEnd,
    /// Compression of the fused interface reaches its limit load.
    PushLimit,
    /// Tension of the fused interface reaches its limit load.
    PullLimit,
    /// Knot of the spring's law at larger displacement.
    KnotAhead,
    /// Knot of the spring's law at smaller displacement.
    KnotBehind,
    /// Reversal of the plate.
    SpeedZero,
    /// Contact of the plate with its stop; an elastic stop can follow and reach the plate.
    StopReached,
    /// End of the force of the elastic stop.
    StopSlack,
    /// End of the force on the rigid stop.
    StopRelease,
    /// Locking of the plate by a singular spring.
    SpringHolds,
    /// Unlocking of the plate: the displacement of the spring is no longer negligible.
    Yields,
}

impl Event {
    /// Returns `true` if another event is the reverse of this one.
    pub(super) fn is_undone_by(self, other: Self) -> bool {
        matches!(
            (self, other),
            (Self::StopSlack, Self::StopReached)
                | (Self::StopReached, Self::StopSlack)
                | (Self::ContactLost, Self::Recontact)
                | (Self::Recontact, Self::ContactLost)
        )
    }
}
