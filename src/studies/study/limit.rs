//! Ballistic limit: the smallest impact velocity that perforates, and the residual velocity above it.
//!
//! Uses the closed form for a rigid or free plate. Otherwise scans the whole velocity range and bisects on the outcome; the scan also finds
//! faster shots that are stopped again. Does not depend on files, threads, the terminal or a clock.

use std::sync::Arc;

use crate::study::context::{Context, never_cancel};
use crate::study::envelope::oblique_error;
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::fixed_significant;
use cmra_engine::model::variables::{self, VariableError};
use cmra_engine::numerics::smaller;
use residual_law::ResidualLaw;
use search::{BESIDE, ShotRunner, ShotWork};

mod closures;
pub mod residual_law;
mod search;
pub(in crate::study) mod shot_outcome;

pub use closures::{Closures, is_stopped_by_every_closure};
pub use cmra_engine::model::closed_form::ballistic_limit_m_s as closed_form;

/// Range of impact velocities, m/s. No limit outside it is reported, by closed form or by outcome.
pub const RANGE_M_S: (f64, f64) = (1.0, 3e3);
/// Relative distance from a limit of the two shots that describe it: below it for the load of the mechanism, above it for the residual
/// velocity. Ten times the relative width of the final bracket.
pub(in crate::study) const BESIDE_LIMIT: f64 = 1e-9;
/// Points of the velocity scan, geometrically spaced.
const SCAN: usize = 41;
/// Shots of the curve below and above the limit, and the range of the curve relative to the limit.
const BELOW: usize = 6;
const ABOVE: usize = 24;
const CURVE: (f64, f64) = (0.5, 2.5);

enumeration! {
    /// Method by which the limit is computed.
    pub enum LimitMethod in BasisRow {
        /// A short text.
        words: &'static str,
    }
    /// Closed form: only inertia or a rigid mount resists the shot.
    ClosedForm { words: "closed form" }
    /// Bisection on the outcome of runs.
    Outcome { words: "bisection on the outcome" }
}

/// Limit velocity of a scene, or the reason why there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// Known limit.
    Found {
        /// Limit velocity, m/s.
        velocity_m_s: f64,
        /// Method by which the limit is computed.
        basis: LimitMethod,
        /// Velocity of a faster shot that is stopped again, m/s; `None` if all faster shots perforate. The limit is not unique if there is
        /// one.
        stopped_at_m_s: Option<f64>,
        /// Velocity of a slower shot whose run ends undecided, m/s; `None` if all slower shots are decided.
        undecided_at_m_s: Option<f64>,
    },
    /// Unknown limit within a range of shots whose runs end undecided.
    Between {
        /// Velocity of the slowest shot found undecided, m/s.
        undecided_m_s: f64,
        /// Velocity of the slowest shot found to perforate, m/s; `None` if no shot is known to.
        through_m_s: Option<f64>,
    },
    /// No velocity in range perforates.
    Never,
    /// Every velocity in range perforates.
    Always,
    /// The contact model cannot perforate.
    NotModelled,
    /// Cancelled before the limit was found.
    Unknown,
}

impl Limit {
    /// Creates a unique limit: all slower shots are stopped and all faster shots perforate.
    pub fn found(velocity_m_s: f64, basis: LimitMethod) -> Self {
        Self::Found { velocity_m_s, basis, stopped_at_m_s: None, undecided_at_m_s: None }
    }

    /// Adds the velocity of a slower undecided shot, m/s.
    fn above_undecided(mut self, velocity_m_s: f64) -> Self {
        match &mut self {
            Self::Found { undecided_at_m_s, .. } => {
                let slowest_m_s = undecided_at_m_s.get_or_insert(velocity_m_s);
                *slowest_m_s = smaller(*slowest_m_s, velocity_m_s);
            }
            Self::Between { undecided_m_s, .. } => {
                *undecided_m_s = smaller(*undecided_m_s, velocity_m_s);
            }
            _ => {}
        }
        self
    }

    /// Adds the velocity of a faster shot that is stopped again, m/s, if any.
    fn stopped_again(mut self, velocity_m_s: Option<f64>) -> Self {
        if let Self::Found { stopped_at_m_s, .. } = &mut self {
            *stopped_at_m_s = velocity_m_s;
        }
        self
    }

    /// Adds the slowest shot of a curve above the limit that is stopped again, unless a stopped shot is known.
    fn with_curve(self, shots: &[Shot]) -> Self {
        let Self::Found { velocity_m_s, stopped_at_m_s: None, .. } = self else { return self };
        let is_stopped = |shot: &&Shot| {
            shot.impact_m_s > velocity_m_s
                && matches!(shot.outcome, Outcome::Arrested | Outcome::Separated)
        };
        self.stopped_again(shots.iter().find(is_stopped).map(|shot| shot.impact_m_s))
    }

    /// Returns the limit velocity, m/s; `None` without one.
    pub fn velocity_m_s(self) -> Option<f64> {
        if let Self::Found { velocity_m_s, .. } = self { Some(velocity_m_s) } else { None }
    }

    /// Returns the velocity of the slowest shot that is not known to be stopped, m/s, if a shot below the limit is undecided.
    fn undecided_at_m_s(self) -> Option<f64> {
        match self {
            Self::Found { undecided_at_m_s, .. } => undecided_at_m_s,
            Self::Between { undecided_m_s, .. } => Some(undecided_m_s),
            _ => None,
        }
    }

    /// Returns the limit velocity, m/s, if all slower shots are decided.
    fn decided_m_s(self) -> Option<f64> {
        let is_decided =
            |limit: &Self| !matches!(limit, Self::Found { undecided_at_m_s: Some(_), .. });
        Some(self).filter(is_decided)?.velocity_m_s()
    }

    /// Returns what the limit says of a shot at this velocity: arrested or perforated; `None` where it does not decide.
    pub fn outcome_at(self, impact_m_s: f64) -> Option<Outcome> {
        let (undecided_m_s, through_m_s) = match self {
            Self::Found { velocity_m_s, stopped_at_m_s, undecided_at_m_s, .. } => {
                let through_m_s = stopped_at_m_s.is_none().then_some(velocity_m_s);
                (undecided_at_m_s.unwrap_or(velocity_m_s), through_m_s)
            }
            Self::Between { undecided_m_s, through_m_s } => (undecided_m_s, through_m_s),
            Self::Never => return Some(Outcome::Arrested),
            Self::Always => return Some(Outcome::Perforated),
            Self::NotModelled | Self::Unknown => return None,
        };
        if impact_m_s < undecided_m_s {
            Some(Outcome::Arrested)
        } else {
            through_m_s
                .filter(|through_m_s| impact_m_s >= *through_m_s)
                .map(|_| Outcome::Perforated)
        }
    }

    /// Explains why there is no limit velocity; `None` if there is one.
    pub fn absence(self) -> Option<String> {
        let (low, high) = RANGE_M_S;
        match self {
            Self::Found { .. } => None,
            Self::Between { undecided_m_s, through_m_s } => {
                let undecided = fixed_significant(undecided_m_s, 4);
                Some(match through_m_s.map(|it| fixed_significant(it, 4)) {
                    Some(through) => format!(
                        "limit not known: the work of a search does not decide shots from {undecided} m/s on; {through} m/s perforates"
                    ),
                    None => format!(
                        "limit not known: the work of a search does not decide a shot at {undecided} m/s, and none from {low} to {high} m/s is known \
                         to perforate"
                    ),
                })
            }
            Self::Never => Some(format!(
                "limit beyond {high} m/s: no shot tried from {low} to {high} m/s perforates"
            )),
            Self::Always => Some(format!("no limit: a shot at {low} m/s perforates already")),
            Self::NotModelled => Some(
                "no limit: the contact model cannot perforate; set model = hydrodynamic".to_owned(),
            ),
            Self::Unknown => Some("stopped before the limit was found".to_owned()),
        }
    }

    /// Warns that an oblique limit is lower than measurements; `None` at normal impact, or without a limit.
    pub fn caution(self, scene: &Scene) -> Option<String> {
        let theta = scene.projectile.obliquity_deg;
        self.velocity_m_s().filter(|_| theta > 0.0)?;
        Some(oblique_error(theta))
    }
}

/// Shot of the residual-velocity curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shot {
    /// Impact velocity, m/s.
    pub impact_m_s: f64,
    /// Outcome of the shot.
    pub outcome: Outcome,
    /// Projectile velocity after perforation, m/s.
    pub residual_m_s: Option<f64>,
}

/// Residual velocity just above a limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResidualAtLimit {
    /// The velocity, m/s; negative if the plate carries the projectile back.
    pub velocity_m_s: f64,
    /// `false` if it depends on how close to the limit the shot is: a passage whose relative velocity decays takes the longer, the closer it is.
    pub is_settled: bool,
}

/// Name of the command that finds the limit of a scene.
pub const COMMAND: &str = "limit";

/// Ballistic limit of a scene, with the residual-velocity curve and the limits by other closures.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitReport {
    /// The scene.
    pub scene: Arc<Scene>,
    /// Ballistic limit.
    pub limit: Limit,
    /// Shot just below the limit; `None` without a limit.
    pub at_limit: Option<Run>,
    /// Residual velocity just above the limit; `None` without a limit, or if that shot does not perforate.
    pub residual_at_limit: Option<ResidualAtLimit>,
    /// Impact velocity up to which a fused interface stays within its limit load, m/s; 0 if no shot of a scan stays within it; `None` if the
    /// interface stays within it just below the ballistic limit, or if slow shots exceed it and faster ones do not.
    pub interface_holds_m_s: Option<f64>,
    /// Limits by the three closures, if the flow strength follows from a yield stress.
    pub closures: Option<Closures>,
    /// Limits on either side of the jump at h = D, where the closure changes, m/s; `None` unless the plate's thickness is close to that.
    pub jump_m_s: Option<(f64, f64)>,
    /// Residual-velocity curve, sorted by impact velocity.
    pub shots: Vec<Shot>,
    /// Fit of Recht and Ipson's law to the curve.
    pub recht_ipson: Option<ResidualLaw>,
    /// Fit of Lambert and Jonas's law to the curve.
    pub lambert_jonas: Option<ResidualLaw>,
}

impl LimitReport {
    /// Returns the velocity of a slower undecided shot, m/s.
    pub fn undecided_at_m_s(&self) -> Option<f64> {
        self.limit.undecided_at_m_s()
    }

    /// Describes undecided shots below a known limit.
    pub fn undecided(&self) -> Option<String> {
        let velocity_m_s = self.limit.velocity_m_s().and_then(|_| self.undecided_at_m_s())?;
        Some(format!(
            "the work of a search does not decide a shot at {} m/s: it is not known to perforate",
            fixed_significant(velocity_m_s, 4)
        ))
    }

    /// Returns a caution about the limit; see [`Limit::caution`].
    pub fn caution(&self) -> Option<String> {
        self.limit.caution(&self.scene)
    }
}

/// Finds the limit of a scene and its residual-velocity curve.
pub fn find(scene: &Arc<Scene>, context: &mut Context<'_>) -> Result<LimitReport, VariableError> {
    find_within(scene, context, &mut ShotWork::default())
}

fn find_within(
    scene: &Arc<Scene>,
    context: &mut Context<'_>,
    work: &mut ShotWork,
) -> Result<LimitReport, VariableError> {
    variables::validate(scene)?;
    context.expect(SCAN + 42 + 2 * BESIDE.len() + 2 * BELOW + ABOVE);
    let mut range = ShotRunner { scene, context, work, stopped_m_s: Vec::new() };
    let limit = range.whole_limit();
    let shots = range.curve(limit);
    // The curve can have a faster shot that is stopped again between those of the search.
    let limit = limit.with_curve(&shots);
    let perforated = shots.iter().filter_map(|shot| Some((shot.impact_m_s, shot.residual_m_s?)));
    let perforated: Vec<(f64, f64)> = perforated.collect();
    let found_m_s = limit.velocity_m_s();
    let at_limit = found_m_s.and_then(|limit_m_s| range.at_limit(limit_m_s));
    let residual_at_limit = found_m_s.and_then(|limit_m_s| range.residual_at_limit(limit_m_s));
    let interface_holds_m_s = at_limit.as_ref().zip(found_m_s);
    let interface_holds_m_s = interface_holds_m_s
        .and_then(|(at_limit, limit_m_s)| range.interface_holds(at_limit, limit_m_s));
    let closures = found_m_s.and_then(|_| range.closures());
    let jump_m_s = found_m_s.and_then(|_| range.jump());
    Ok(LimitReport {
        scene: Arc::clone(scene),
        limit,
        at_limit,
        residual_at_limit,
        interface_holds_m_s,
        closures,
        jump_m_s,
        shots,
        recht_ipson: found_m_s
            .and_then(|limit_m_s| ResidualLaw::recht_ipson(&perforated, limit_m_s)),
        lambert_jonas: found_m_s.and_then(|_| ResidualLaw::lambert_jonas(&perforated)),
    })
}

/// Finds the limit of a scene, without the curve.
pub fn alone(scene: &Arc<Scene>, context: &mut Context<'_>) -> Result<Limit, VariableError> {
    alone_within(scene, context, &mut ShotWork::default())
}

fn alone_within(
    scene: &Arc<Scene>,
    context: &mut Context<'_>,
    work: &mut ShotWork,
) -> Result<Limit, VariableError> {
    variables::validate(scene)?;
    context.expect(SCAN + 40 + 2 * BESIDE.len() + BELOW);
    Ok(ShotRunner { scene, context, work, stopped_m_s: Vec::new() }.whole_limit())
}

/// Returns the limit velocity of a scene, m/s.
pub fn velocity_m_s(scene: &Scene) -> Result<f64, String> {
    let limit = alone(&Arc::new(scene.clone()), &mut Context::new(1, &mut never_cancel));
    let limit = limit.map_err(|error| error.to_string())?;
    limit.velocity_m_s().ok_or_else(|| limit.absence().unwrap_or_default())
}

#[cfg(test)]
mod tests;
