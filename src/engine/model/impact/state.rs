//! Mechanical state of projectile and plate.

/// State: time, travel, relative velocity, and displacement (from the origin of the mode) and velocity of the plate.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub(super) struct State {
    pub(super) t_s: f64,
    pub(super) q_m: f64,
    pub(super) u_m_s: f64,
    pub(super) x_m: f64,
    pub(super) w_m_s: f64,
}
