//! The hydrodynamic model, F = A (S + c u²), with the interface law of `impact/events.rs`: a hole that is closed again rubs
//! with g A S, and so does a projectile that is pulled out.

use std::sync::Arc;

use super::{About, ContactLaw, Hole, Scales, shown};
use crate::model::closed_form::{Ending, Passage};
use crate::model::contact::{AreaLaw, Geometry};
use crate::model::event_function::{ActiveEvents, EventFunction, EventId};
use crate::model::motion::{ContactForce, FlowForce, Pressure};
use crate::model::run::Mode;
use crate::model::scene::Scene;
use crate::numerics::smaller;

/// Part of the travel at which the engaged area stands for the contact's.
const LATE: f64 = 0.9;

pub(super) const ABOUT: About = About {
    place: 1,
    strength: "simple",
    limit: "models the contact force as a modified fluid drag",
    parameters: |_| String::new(),
    of: |scene, geometry| Arc::new(FlowStrength::of(scene, geometry)),
};

/// The same law by the listing of Appendix A.
pub(super) const APPENDIX: About = About {
    place: 5,
    strength: "the method of chapter 9",
    limit: "not in Table 8.1",
    parameters: |scene| {
        let step_s = scene.contact.appendix.step_s;
        format!("dt = {}", shown(step_s, "s", Some(step_s)))
    },
    ..ABOUT
};

/// The modified drag law.
#[derive(Clone, Copy, Debug, PartialEq)]
struct FlowStrength {
    pressure: Pressure,
    grip: f64,
    scales: Scales,
    hole_on_rigid_mount_m: Option<f64>,
}

impl FlowStrength {
    fn of(scene: &Scene, geometry: &Geometry) -> Self {
        let pressure = Pressure::of(scene);
        let hole_on_rigid_mount_m = match Passage::rigid(scene, geometry).ending() {
            Ending::Arrest { travel_m } => Some(travel_m),
            Ending::Exit { .. } => None,
        };
        let v = scene.projectile.velocity_m_s;
        let travel_m = match hole_on_rigid_mount_m {
            // By way of the depth, as everything else that is compared with the baseline.
            Some(travel_m) => geometry.travel_m(geometry.depth_m(travel_m)),
            None => geometry.exit_m,
        };
        let scales = Scales {
            travel_m,
            duration_s: 2.0 * travel_m / v,
            force_n: geometry.area_m2(LATE * travel_m) * pressure.at(v),
        };
        Self { pressure, grip: scene.interface.grip, scales, hole_on_rigid_mount_m }
    }
}

impl ContactLaw for FlowStrength {
    fn force(&self, mode: Mode, hole: &Hole<'_>) -> ContactForce {
        let friction_pa = self.grip * self.pressure.strength_pa;
        let pressure = match mode {
            Mode::Penetrating => self.pressure,
            Mode::Closing => Pressure { strength_pa: friction_pa, drag_kg_m3: 0.0 },
            Mode::Withdrawing => Pressure { strength_pa: -friction_pa, drag_kg_m3: 0.0 },
            _ => return ContactForce::None,
        };
        if pressure.strength_pa == 0.0 && pressure.drag_kg_m3 == 0.0 {
            return ContactForce::None;
        }
        let (geometry, q) = (hole.geometry, hole.state.travel_m);
        let area = if mode == Mode::Withdrawing {
            geometry.piece_behind(q).map_or(AreaLaw::None, |piece| piece.law)
        } else {
            geometry.piece(q).law
        };
        ContactForce::Flow(FlowForce { nose: geometry.nose, area, pressure })
    }

    fn add_events(&self, mode: Mode, hole: &Hole<'_>, events: &mut ActiveEvents) {
        let (geometry, q) = (hole.geometry, hole.state.travel_m);
        match mode {
            Mode::Penetrating | Mode::Closing => {
                let end_m = smaller(geometry.piece(q).to_m, geometry.exit_m);
                events.add(EventId::PieceEnd, EventFunction::travel_up_to(end_m));
                events.add(EventId::SlipZero, EventFunction::slip(1.0));
                if mode == Mode::Closing {
                    events.add(EventId::HoleBottom, EventFunction::travel_up_to(hole.deepest_m));
                }
            }
            Mode::Withdrawing => {
                let start_m = geometry.piece_behind(q).map_or(0.0, |piece| piece.from_m);
                events.add(EventId::PieceStart, EventFunction::travel_down_to(start_m));
                events.add(EventId::SlipZero, EventFunction::slip(-1.0));
            }
            Mode::FreeFlight => {
                events.add(EventId::Recontact, EventFunction::travel_up_to(0.0));
            }
            _ => {}
        }
    }

    fn scales(&self) -> Scales {
        self.scales
    }

    fn hole_m(&self, deepest_m: f64) -> Option<f64> {
        Some(deepest_m)
    }

    fn hole_on_rigid_mount_m(&self) -> Option<f64> {
        self.hole_on_rigid_mount_m
    }
}
