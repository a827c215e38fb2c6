//! Parameters of an impact: bodies, contact, mechanism and their starting state, from a scene.

use crate::model::contact::Geometry;
use crate::model::contact_models::ContactLaw;
use crate::model::impact::method::IntegrationMethod;
use crate::model::impact::resolution::RESOLUTION;
use crate::model::impact::state::State;
use crate::model::mechanism::{Inertia, Mechanism, PowerLaw, Spring, moving_plate_kg};
use crate::model::plug::Plug;
use crate::model::scene::{self, InterfaceLaw, Scene, SpringKind};
use crate::numerics::larger;

/// Parameters of an impact.
#[derive(Clone, Debug)]
pub(super) struct ImpactParameters {
    pub(super) law: ContactLaw,
    pub(super) geometry: Geometry,
    /// Spring at first contact; the law of an absorber changes as it is crushed.
    pub(super) spring: Spring,
    /// Mechanism that contains a crush absorber, if any.
    pub(super) absorber: Option<Box<scene::Mechanism>>,
    pub(super) damper: PowerLaw,
    /// Velocity below which a damper with exponent < 1 is linearised, m/s; else 0.
    pub(super) creep_m_s: f64,
    pub(super) stop: StopParameters,
    pub(super) mass: Masses,
    /// Cosine of the obliquity.
    pub(super) cos: f64,
    pub(super) strength_pa: f64,
    pub(super) drag_kg_m3: f64,
    pub(super) interface: InterfaceParameters,
    pub(super) reference: ReferenceScales,
    pub(super) start: FirstContact,
    /// Whether the mount is rigid.
    pub(super) is_rigid_mount: bool,
    pub(super) numerics: Numerics,
    /// Parameters after the plug is picked up; `None` for a nose without a plug, and in these parameters themselves.
    pub(super) plug: Option<Box<Self>>,
    /// Factor of the relative velocity when the plug is picked up; 1 before.
    pub(super) kept: f64,
    /// Weight of the projectile along its axis, N; 0 if it is not included.
    pub(super) weight_n: f64,
}

/// Stop of the plate.
#[derive(Clone, Copy, Debug)]
pub(super) struct StopParameters {
    /// Position, m; infinite without a stop.
    pub(super) position_m: f64,
    /// Coefficient of restitution of a rigid stop; `None` without one.
    pub(super) restitution: Option<f64>,
    /// Stiffness of an elastic stop, N/m; else 0.
    pub(super) stiffness_n_m: f64,
    /// Damping coefficient of an elastic stop, N s/m; else 0.
    pub(super) damping_n_s_m: f64,
}

/// Masses of the bodies, kg.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::struct_field_names, reason = "the ending is the unit")]
pub(super) struct Masses {
    /// Mass of the projectile, with a plug that it has picked up, kg.
    pub(super) projectile_kg: f64,
    /// Mass of the plate with the mass that the mechanism adds, kg.
    pub(super) plate_kg: f64,
    /// Part of `plate_kg` that represents inertia geared to the plate and carried by the mount.
    pub(super) turning_kg: f64,
    /// Mass of the fused bodies along the normal of the plate, kg.
    pub(super) joined_kg: f64,
}

/// Interface between projectile and plate after the first arrest.
#[derive(Clone, Copy, Debug)]
pub(super) struct InterfaceParameters {
    /// Whether the interface can slip after the first arrest.
    pub(super) is_plastic: bool,
    /// Limit load in tension, relative to that in compression.
    pub(super) grip: f64,
}

/// Reference quantities of the tolerances.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReferenceScales {
    /// Larger of projectile velocity and closing velocity at first contact, m/s.
    pub(super) velocity_m_s: f64,
    /// Smaller of the tip radius and the travel over which the strength alone stops the shot, m.
    pub(super) length_m: f64,
}

/// State at first contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct FirstContact {
    /// Displacement of the plate, m.
    pub(super) x_m: f64,
    /// Velocity of the plate, m/s.
    pub(super) w_m_s: f64,
    /// Relative velocity, m/s.
    pub(super) closing_m_s: f64,
    /// Kinetic energy of projectile and plate, J.
    pub(super) kinetic_j: [f64; 2],
}

/// Method and tolerance of the integration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Numerics {
    /// Integration method.
    pub(super) method: IntegrationMethod,
    /// Relative tolerance of the local error.
    pub(super) tolerance: f64,
}

impl StopParameters {
    fn from_mechanism(mechanism: &Mechanism) -> Self {
        Self {
            position_m: mechanism.stop.and_then(|stop| stop.position_m).unwrap_or(f64::INFINITY),
            restitution: mechanism.rigid_stop().map(|stop| stop.restitution),
            stiffness_n_m: mechanism.elastic_stop().map_or(0.0, |stop| stop.stiffness_n_m),
            damping_n_s_m: mechanism.elastic_stop().map_or(0.0, |stop| stop.damping_n_s_m),
        }
    }
}

impl ImpactParameters {
    /// Creates the parameters of a valid scene, with a tolerance of the local error.
    pub(super) fn from_scene(scene: &Scene, tolerance: f64) -> Self {
        let law = ContactLaw::from_scene(scene);
        let flows = law == ContactLaw::Flow;
        let geometry = Geometry::from_scene(scene);
        let mechanism = Mechanism::from_scene(scene);
        let cos = geometry.nose.cos;
        let closing_m_s = scene.closing_velocity_m_s();
        let velocity_m_s = larger(scene.projectile.velocity_m_s, closing_m_s);
        let projectile_kg = scene.projectile.mass_kg;
        let plate_kg = moving_plate_kg(scene);
        let given_m_s = plate_velocity_m_s(scene, &geometry, (velocity_m_s, plate_kg));
        let absorbs = scene.is_sprung() && scene.mechanism.spring.kind == SpringKind::Crush;
        let kinetic_j = |kg: f64, speed: f64| 0.5 * kg * speed * speed;
        let start_m_s = scene.plate_velocity_m_s();
        let own = Self {
            law,
            absorber: absorbs.then(|| Box::new(scene.mechanism.clone())),
            damper: mechanism.damper,
            creep_m_s: mechanism.damper.creep_m_s(given_m_s),
            stop: StopParameters::from_mechanism(&mechanism),
            spring: mechanism.spring,
            mass: Masses {
                projectile_kg,
                plate_kg,
                turning_kg: Inertia::from_scene(scene).rotation_kg,
                joined_kg: plate_kg + projectile_kg * cos * cos,
            },
            cos,
            strength_pa: if flows { scene.flow_strength_pa() } else { 0.0 },
            drag_kg_m3: if flows { scene.drag_kg_m3() } else { 0.0 },
            interface: InterfaceParameters {
                is_plastic: flows && scene.interface.law == InterfaceLaw::Plastic,
                grip: scene.interface.grip,
            },
            reference: ReferenceScales {
                velocity_m_s,
                length_m: if flows {
                    flow_length_m(scene, &geometry, velocity_m_s)
                } else {
                    geometry.nose.radius_m
                },
            },
            geometry,
            start: FirstContact {
                x_m: scene.start_m(),
                w_m_s: start_m_s,
                closing_m_s,
                kinetic_j: [
                    kinetic_j(projectile_kg, closing_m_s + start_m_s * cos),
                    kinetic_j(plate_kg, start_m_s),
                ],
            },
            is_rigid_mount: !scene.is_sprung(),
            numerics: Numerics { method: IntegrationMethod::Collocation(tolerance), tolerance },
            plug: None,
            kept: 1.0,
            weight_n: scene.weight_n() * cos,
        };
        match Plug::from_scene(scene).filter(|_| flows) {
            None => own,
            Some(plug) => Self { plug: Some(Box::new(own.around(&plug))), ..own },
        }
    }

    /// Returns the parameters after a plug is picked up: it moves with the projectile, against the shear force at its rim.
    fn around(&self, plug: &Plug) -> Self {
        let projectile_kg = self.mass.projectile_kg + plug.mass_kg;
        let plate_kg = self.mass.plate_kg - plug.mass_kg;
        Self {
            geometry: self.geometry.around(plug, self.strength_pa),
            mass: Masses {
                projectile_kg,
                plate_kg,
                joined_kg: plate_kg + projectile_kg * self.cos * self.cos,
                ..self.mass
            },
            strength_pa: plug.shear_pa,
            drag_kg_m3: 0.0,
            kept: plug.kept(self.mass.projectile_kg),
            ..self.clone()
        }
    }

    /// Returns the parameters with an integration method.
    pub(super) fn by(mut self, method: IntegrationMethod) -> Self {
        self.numerics.method = method;
        self.creep_m_s *= self.threshold_factor();
        self.plug = self.plug.map(|plug| Box::new(plug.by(method)));
        self
    }

    /// Returns the parameters at an end of a piece of the area law: those with the plug if it is picked up there.
    pub(super) fn at(&self, q_m: f64) -> &Self {
        self.plug.as_deref().filter(|_| q_m >= self.geometry.exit_m).unwrap_or(self)
    }

    /// Returns `true` if the plug is picked up.
    pub(super) fn shears(&self) -> bool {
        self.kept < 1.0
    }

    /// Returns the combined law of spring and elastic stop, without damping.
    pub(super) fn with_stop(&self, spring: &Spring) -> Spring {
        if self.stop.stiffness_n_m == 0.0 {
            return spring.clone();
        }
        spring.beside_stop(self.stop.position_m, self.stop.stiffness_n_m)
    }

    pub(super) fn has_stop(&self) -> bool {
        self.stop.position_m.is_finite()
    }

    /// Returns the spring and the crushed length of its absorber, m, for a plate that reverses at x; `None` if it is not crushed further.
    pub(super) fn crushed_at(&self, x_m: f64, before_m: f64) -> Option<(Spring, f64)> {
        let mechanism = self.absorber.as_ref()?;
        let crushed_m = mechanism.spring.crush.crushed_by(x_m, before_m)?;
        Some((Spring::new(mechanism, crushed_m), crushed_m))
    }

    /// Returns the fraction of the mechanism's force that the fused interface carries.
    pub(super) fn interface_fraction(&self) -> f64 {
        self.mass.projectile_kg * self.cos / self.mass.joined_kg
    }

    /// Returns the reference time, s: reference length over reference velocity.
    pub(super) fn passage_s(&self) -> f64 {
        self.reference.length_m / self.reference.velocity_m_s
    }

    /// Returns `true` if the plate starts at rest at a singular zero of its spring or damper.
    pub(super) fn starts_steep(&self) -> bool {
        self.start.w_m_s == 0.0 && self.starts_at_steep_zero()
    }

    /// Returns `true` if the plate starts at a zero of its spring with infinite stiffness.
    pub(super) fn starts_at_steep_zero(&self) -> bool {
        let is_at_zero =
            !self.is_rigid_mount && self.start.x_m == 0.0 && self.spring.force(0.0) == 0.0;
        is_at_zero && self.spring.is_steep_at_zero() && self.law != ContactLaw::AtOnce
    }

    /// Returns the greatest displacement of a plate that swings on its spring with the velocity at first contact, m.
    pub(super) fn first_swing_m(&self) -> f64 {
        let moving_j = 0.5 * self.mass.plate_kg * self.start.w_m_s * self.start.w_m_s;
        self.spring.reach(0.0, moving_j, 1.0)
    }

    /// Returns `true` if the plate is at its stop or beyond at first contact.
    pub(super) fn starts_on_stop(&self) -> bool {
        !self.is_rigid_mount && self.start.x_m >= self.stop.position_m
    }

    /// Returns the position of a rigid stop, m; infinite without one.
    pub(super) fn rigid_stop_m(&self) -> f64 {
        if self.stop.restitution.is_some() { self.stop.position_m } else { f64::INFINITY }
    }

    /// Returns the kinetic energy of both bodies at first contact, J.
    pub(super) fn initial_j(&self) -> f64 {
        self.start.kinetic_j.into_iter().sum()
    }

    /// Returns the velocity of the projectile, m/s.
    pub(super) fn projectile_m_s(&self, state: &State) -> f64 {
        state.u_m_s + state.w_m_s * self.cos
    }
}

/// Returns the reference velocity of the plate, m/s: the smaller of that of the impact and the velocity that the resistance of the whole hole
/// gives the plate at it. A plate that is hardly touched moves much slower than its projectile.
fn plate_velocity_m_s(
    scene: &Scene,
    geometry: &Geometry,
    (impact_m_s, plate_kg): (f64, f64),
) -> f64 {
    let pressure_pa = scene.flow_strength_pa() + scene.drag_kg_m3() * impact_m_s * impact_m_s;
    let hole_j = pressure_pa * geometry.swept_m3(geometry.exit_m);
    let given_m_s = larger(hole_j / (plate_kg * impact_m_s), RESOLUTION * impact_m_s);
    if given_m_s < impact_m_s { given_m_s } else { impact_m_s }
}

/// Returns the reference length, m: the smaller of the tip radius and the travel over which the strength dissipates the energy of the shot,
/// with the first piece `a_0 + a_1 q` of the area law.
fn flow_length_m(scene: &Scene, geometry: &Geometry, velocity_m_s: f64) -> f64 {
    let (nose, law) = (&geometry.nose, geometry.piece(0.0).law);
    let energy_j = 0.5 * scene.projectile.mass_kg * velocity_m_s * velocity_m_s;
    let volume_m3 = energy_j / scene.flow_strength_pa();
    let (area_m2, slope_m) = (law.area_m2(nose, 0.0), law.slope_m(nose, 0.0));
    let travel_m =
        2.0 * volume_m3 / (area_m2 + (area_m2 * area_m2 + 2.0 * slope_m * volume_m3).sqrt());
    // The travel is infinite without strength.
    if travel_m < nose.radius_m { travel_m } else { nose.radius_m }
}
