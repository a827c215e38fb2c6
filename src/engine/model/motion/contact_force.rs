//! The contact force of each contact model, as a function of travel, slip and time.

use crate::model::contact::{AreaLaw, NoseGeometry};
use crate::model::motion::State;
use crate::model::scene::Scene;

/// Part of the nose's radius over which the slope of an oblique section's area is taken.
const SLOPE: f64 = 1e-6;

/// The force between projectile and plate in one mode of one contact model, positive apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ContactForce {
    None,
    /// A (S + c u²).
    Flow(FlowForce),
    /// k (q - `q_slack`) + b u.
    Elastic(ElasticForce),
    /// F sin(pi t/`t_d`).
    HalfSine(Pulse),
}

/// The flow of the target around the nose: engaged area times pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FlowForce {
    pub(crate) nose: NoseGeometry,
    pub(crate) area: AreaLaw,
    pub(crate) pressure: Pressure,
}

/// S + c u².
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pressure {
    /// S, Pa; negative while pulling out.
    pub(crate) strength_pa: f64,
    pub(crate) drag_kg_m3: f64,
}

/// A spring and a damper side by side.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[expect(clippy::struct_field_names, reason = "they end in their units")]
pub(crate) struct ElasticForce {
    pub(crate) stiffness_n_m: f64,
    /// Where the spring is slack, m.
    pub(crate) slack_m: f64,
    pub(crate) damping_n_s_m: f64,
}

/// A half-sine from first contact on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pulse {
    pub(crate) amplitude_n: f64,
    pub(crate) duration_s: f64,
}

impl ElasticForce {
    pub(crate) fn force(&self, z_m: f64, z_m_s: f64) -> f64 {
        self.stiffness_n_m * (z_m - self.slack_m) + self.damping_n_s_m * z_m_s
    }
}

impl Pressure {
    /// Of the plate of a scene that is penetrated.
    pub(crate) fn of(scene: &Scene) -> Self {
        Self { strength_pa: scene.flow_strength_pa(), drag_kg_m3: scene.drag_kg_m3() }
    }

    /// At a slip, Pa.
    pub(crate) fn at(&self, slip_m_s: f64) -> f64 {
        self.strength_pa + self.drag_kg_m3 * slip_m_s * slip_m_s
    }
}

impl ContactForce {
    pub(crate) fn force(&self, state: &State) -> f64 {
        let (q, u) = (state.travel_m, state.slip_m_s);
        match self {
            Self::None => 0.0,
            Self::Flow(flow) => flow.area.area_m2(&flow.nose, q) * flow.pressure.at(u),
            Self::Elastic(law) => law.force(q, u),
            Self::HalfSine(pulse) => {
                pulse.amplitude_n * (std::f64::consts::PI * state.t_s / pulse.duration_s).sin()
            }
        }
    }

    /// Its derivatives by travel, N/m, and by slip, N s/m.
    pub(crate) fn slopes(&self, state: &State) -> [f64; 2] {
        match self {
            Self::None | Self::HalfSine(_) => [0.0; 2],
            Self::Flow(flow) => {
                let (q, u) = (state.travel_m, state.slip_m_s);
                let area = flow.area.area_m2(&flow.nose, q);
                let slope = flow.area_slope(q) * flow.pressure.at(u);
                [slope, 2.0 * area * flow.pressure.drag_kg_m3 * u]
            }
            Self::Elastic(law) => [law.stiffness_n_m, law.damping_n_s_m],
        }
    }

    /// Whether the force has many derivatives: an oblique section has not.
    pub(crate) fn is_smooth(&self) -> bool {
        !matches!(self, Self::Flow(FlowForce { area: AreaLaw::Partial { .. }, .. }))
    }
}

impl FlowForce {
    /// dA/dq, m: by a central difference where a face crosses sphere and cylinder.
    fn area_slope(&self, q: f64) -> f64 {
        match self.area {
            AreaLaw::None => 0.0,
            AreaLaw::Quadratic { origin_m, a } => a[1] + 2.0 * a[2] * (q - origin_m),
            AreaLaw::Partial { .. } => {
                let h = SLOPE * self.nose.radius_m;
                let area = |q: f64| self.area.area_m2(&self.nose, q);
                (area(q + h) - area(q - h)) / (2.0 * h)
            }
        }
    }
}
