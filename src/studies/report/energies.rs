//! Energies of a run over time: distribution of the initial energy among the parts.
//!
//! Kinetic energies and the spring energy follow in closed form from a row of the series. The rest of the initial energy is dissipated. It
//! is assigned to the forces that do work between two rows.

use cmra_engine::model::mechanism::{Spring, moving_plate_kg};
use cmra_engine::model::plug::Plug;
use cmra_engine::model::run::{ContactMode, EventKind, Run, Sample};
use cmra_engine::model::scene::{ContactModel, Scene, SpringKind};
use cmra_engine::numerics::larger;

/// Distance from the stop, relative to its position and the plate's thickness, below which a velocity jump is an impact on the stop.
const AT_STOP: f64 = 1e-6;

/// Energies at a time, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Kinetic energy of the projectile.
    pub projectile_j: f64,
    /// Kinetic energy of the plug.
    pub plug_j: f64,
    /// Work of penetration.
    pub target_j: f64,
    /// Kinetic energy of the plate and the parts that move with it.
    pub plate_j: f64,
    /// Energy stored in the springs, and work of crushing an absorber.
    pub spring_j: f64,
    /// Work of the damper.
    pub damper_j: f64,
    /// Work of friction in the hole.
    pub interface_j: f64,
    /// Energy stored in, or dissipated by, the stop.
    pub stop_j: f64,
}

impl Energies {
    /// Returns the energies at a time, linear between the rows of the series; after its end those of the last row. `None` without a series.
    pub fn at(run: &Run, t_s: f64) -> Option<Self> {
        let first = run.series.first()?;
        let books = Books::from_run(run);
        let mut crushed = Crushed::default();
        let mut now = books.kept(first, false, &mut crushed);
        // An instantaneous collision precedes the first row.
        now.target_j = run.ledger.initial_j() - now.sum_j();
        for pair in run.series.windows(2) {
            if pair[0].t_s > t_s {
                break;
            }
            let next = books.next(&now, (&pair[0], &pair[1]), &mut crushed);
            if pair[1].t_s > t_s {
                let fraction = (t_s - pair[0].t_s) / (pair[1].t_s - pair[0].t_s);
                return Some(now.between(&next, fraction));
            }
            now = next;
        }
        Some(now)
    }

    /// Returns the energies with their names, long and short, in the order of a bar.
    pub fn parts(&self) -> [([&'static str; 2], f64); 8] {
        [
            (["projectile", "shot"], self.projectile_j),
            (["target"; 2], self.target_j),
            (["plate"; 2], self.plate_j),
            (["spring"; 2], self.spring_j),
            (["damper"; 2], self.damper_j),
            (["interface", "grip"], self.interface_j),
            (["stop"; 2], self.stop_j),
            (["plug"; 2], self.plug_j),
        ]
    }

    /// Returns the sum of all energies, J.
    pub fn sum_j(&self) -> f64 {
        self.parts().iter().map(|part| part.1).sum()
    }

    fn between(&self, next: &Self, fraction: f64) -> Self {
        let mix = |a: f64, b: f64| a + fraction * (b - a);
        Self {
            projectile_j: mix(self.projectile_j, next.projectile_j),
            plug_j: mix(self.plug_j, next.plug_j),
            target_j: mix(self.target_j, next.target_j),
            plate_j: mix(self.plate_j, next.plate_j),
            spring_j: mix(self.spring_j, next.spring_j),
            damper_j: mix(self.damper_j, next.damper_j),
            interface_j: mix(self.interface_j, next.interface_j),
            stop_j: mix(self.stop_j, next.stop_j),
        }
    }
}

/// Masses and laws for the energy balance of a scene.
struct Books<'a> {
    scene: &'a Scene,
    plate_kg: f64,
    /// Mass of the plug, kg, and the time from which it moves with the projectile, s.
    plug: Option<(f64, f64)>,
    spring: Spring,
    has_friction: bool,
    /// Weight of the projectile along its axis, N; zero if not counted.
    weight_n: f64,
}

/// State of an absorber's spring after its latest crushing.
#[derive(Default)]
struct Crushed {
    farthest_m: Option<f64>,
    /// Crush displacement, m, and the law from there on.
    spring: Option<(f64, Spring)>,
}

impl<'a> Books<'a> {
    fn from_run(run: &'a Run) -> Self {
        let scene = &*run.scene;
        let spring =
            if scene.is_sprung() { Spring::new(&scene.mechanism, 0.0) } else { Spring::NONE };
        let plate_kg = if scene.is_sprung() { moving_plate_kg(scene) } else { 0.0 };
        let has_friction = scene.contact.model == ContactModel::Hydrodynamic;
        let picked_up = run.events.iter().find(|event| event.kind == EventKind::Plug);
        let plug =
            Plug::from_scene(scene).zip(picked_up).map(|(plug, event)| (plug.mass_kg, event.t_s));
        let weight_n = scene.weight_n() * scene.cos_obliquity();
        Self { scene, plate_kg, plug, spring, has_friction, weight_n }
    }

    /// Returns the kinetic and spring energies of a row. From its pick-up on the plug moves with the projectile instead of the plate.
    fn kept(&self, row: &Sample, is_picked_up: bool, crushed: &mut Crushed) -> Energies {
        let kinetic = |mass: f64, speed: f64| 0.5 * mass * speed * speed;
        let plug_kg = self.plug.filter(|_| is_picked_up).map_or(0.0, |plug| plug.0);
        let plate_kg = if self.plate_kg > 0.0 { self.plate_kg - plug_kg } else { 0.0 };
        Energies {
            projectile_j: kinetic(self.scene.projectile.mass_kg, row.projectile_velocity_m_s),
            plug_j: kinetic(plug_kg, row.projectile_velocity_m_s),
            plate_j: kinetic(plate_kg, row.plate_velocity_m_s),
            spring_j: self.spring_j(row.plate_displacement_m, crushed),
            ..Energies::default()
        }
    }

    /// Returns the work done on the springs up to a displacement, J.
    fn spring_j(&self, x_m: f64, crushed: &mut Crushed) -> f64 {
        let far_m = crushed.farthest_m.map_or(x_m, |far_m| larger(far_m, x_m));
        crushed.farthest_m = Some(far_m);
        let crush = &self.scene.mechanism.spring.crush;
        let is_absorber = crush.crushed_by(far_m, 0.0).is_some()
            && self.scene.mechanism.spring.kind == SpringKind::Crush;
        if !is_absorber || x_m >= far_m {
            return self.spring.energy(x_m);
        }
        if crushed.spring.as_ref().is_none_or(|(at_m, _)| at_m.to_bits() != far_m.to_bits()) {
            crushed.spring = Some((far_m, Spring::new(&self.scene.mechanism, far_m)));
        }
        let returned = crushed
            .spring
            .as_ref()
            .map_or(0.0, |(at_m, spring)| spring.energy(*at_m) - spring.energy(x_m));
        self.spring.energy(far_m) - returned
    }

    /// Computes the energies of the later of two rows from those of the earlier row.
    fn next(
        &self,
        now: &Energies,
        (from, to): (&Sample, &Sample),
        crushed: &mut Crushed,
    ) -> Energies {
        // The first of two rows at the same time is before the jump.
        let is_after = |(_, t_s): (f64, f64)| to.t_s > t_s || (to.t_s >= t_s && from.t_s >= t_s);
        let kept = self.kept(to, self.plug.is_some_and(is_after), crushed);
        let mut next = Energies {
            projectile_j: kept.projectile_j,
            plug_j: kept.plug_j,
            plate_j: kept.plate_j,
            spring_j: kept.spring_j,
            ..*now
        };
        let mut lost_j = now.sum_j() - next.sum_j();
        if to.t_s <= from.t_s {
            *self.jump(&mut next, from, to) += lost_j;
            return next;
        }
        if !matches!(from.mode, ContactMode::FreeFlight | ContactMode::Perforated) {
            let way_m = to.projectile_displacement_m - from.projectile_displacement_m;
            lost_j += self.weight_n * way_m;
        }
        let half_s = 0.5 * (to.t_s - from.t_s);
        let work_j = |force: fn(&Sample) -> f64| {
            half_s * (force(from) * from.plate_velocity_m_s + force(to) * to.plate_velocity_m_s)
        };
        let is_pressed = from.stop_force_n != 0.0 || to.stop_force_n != 0.0;
        let is_damped = from.damper_force_n != 0.0 || to.damper_force_n != 0.0;
        let contact = match from.mode {
            ContactMode::Withdrawing | ContactMode::Closing if self.has_friction => {
                Some(&mut next.interface_j)
            }
            ContactMode::Penetrating | ContactMode::Withdrawing | ContactMode::Closing => {
                Some(&mut next.target_j)
            }
            ContactMode::Fused | ContactMode::FreeFlight | ContactMode::Perforated => None,
        };
        // Works with their own integral are integrated. The last part takes the remainder, so the sum is exact.
        if let Some(contact) = contact {
            let (stop_j, damper_j) =
                (work_j(|row| row.stop_force_n), work_j(|row| row.damper_force_n));
            lost_j -= stop_j + damper_j;
            *contact += lost_j;
            next.stop_j += stop_j;
            next.damper_j += damper_j;
        } else if is_damped {
            let stop_j = work_j(|row| row.stop_force_n);
            next.stop_j += stop_j;
            next.damper_j += lost_j - stop_j;
        } else if is_pressed {
            next.stop_j += lost_j;
        } else {
            // Rounding error.
            next.target_j += lost_j;
        }
        next
    }

    /// Returns the part to which energy lost in a velocity jump is assigned.
    fn jump<'b>(&self, energies: &'b mut Energies, from: &Sample, to: &Sample) -> &'b mut f64 {
        let stop_m = self.scene.mechanism.stop.position_m.filter(|_| self.scene.is_sprung());
        let is_at_stop = stop_m.is_some_and(|stop_m| {
            let size_m = stop_m.abs() + self.scene.target.thickness_m;
            (from.plate_displacement_m - stop_m).abs() <= AT_STOP * size_m
                && from.plate_velocity_m_s > to.plate_velocity_m_s
        });
        if is_at_stop { &mut energies.stop_j } else { &mut energies.target_j }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::run_with;
    use crate::study::testing::scene;
    use cmra_engine::model::simulate::Settings;

    /// The ledger integrates each work by Gauss's rule on the steps of the run.
    #[test]
    fn valid_energies_sum_to_that_of_the_start_and_end_as_the_ledger_has_them() {
        for text in [
            "gamma=1",
            "mount=rigid",
            "k=0",
            "d=0.5 k=7.5e6 gamma=0.8",
            "theta=30deg",
            "h=6.35mm v_i=300",
            "nose=blunt closure=cylindrical Y=276MPa UTS=310MPa E=68.3GPa h=6.35mm v_i=300",
            "nose=blunt closure=cylindrical Y=276MPa UTS=310MPa E=68.3GPa mount=rigid v_i=400",
            "x_stop=5mm e=0.5",
            "x_stop=5mm stop_kind=elastic k_stop=1e7 b_stop=100",
            "b=200 m=1",
            "b=5 m=2 h=6.35mm v_i=250",
            "interface=plastic k=1e7 gamma=2",
            "model=lumped k=1e5",
            "model=initial-velocity",
            "model=half-sine",
            "spring=crush",
            "weight=on v_i=2 k=1e4",
        ] {
            // Run to a horizon, so that the ledger is at the time of the last row.
            let text = format!("{text} horizon=2ms");
            let run = run_with(&scene(&text), Settings::SERIES).unwrap();
            let initial_j = run.ledger.initial_j();
            let end_s = run.series.last().unwrap().t_s;
            for index in 0..=50 {
                let energies = Energies::at(&run, end_s * f64::from(index) / 50.0).unwrap();
                let sum = energies.sum_j() / initial_j;
                // A weight continues to add energy.
                let is_whole = run.scene.projectile.weight || (sum - 1.0).abs() < 1e-12;
                assert!(is_whole, "{text}: {sum}");
                for ([name, _], value_j) in energies.parts() {
                    assert!(value_j > -1e-6 * initial_j, "{text}: {name} {value_j} J");
                }
            }
            let last = Energies::at(&run, end_s).unwrap();
            let ledger = &run.ledger;
            let off = last.sum_j() / ledger.given_j() - 1.0;
            assert!(off.abs() < 1e-9, "{text}: {off}");
            let contact_j = ledger.penetration_j + ledger.pick_up_j + ledger.shear_j;
            for (name, value_j, expected_j) in [
                ("projectile", last.projectile_j + last.plug_j, ledger.projectile_j),
                ("contact", last.target_j + last.interface_j, contact_j),
                ("plate", last.plate_j, ledger.plate_j + ledger.inertia_j),
                ("spring", last.spring_j, ledger.spring_j + ledger.crush_j),
                ("damper", last.damper_j, ledger.damper_j),
                ("stop", last.stop_j, ledger.stop_j),
            ] {
                let off = (value_j - expected_j).abs() / initial_j;
                assert!(off < 2e-3, "{text}: {name} {value_j} J, ledger {expected_j} J");
            }
        }
    }
}
