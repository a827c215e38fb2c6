//! Stack of elements. A projectile that perforates an element strikes the next with its residual velocity; the last element is a base plate
//! on a rigid mount. Thesis section 6.2.8, arrays "upward out of the plane of a base armor plate".
//!
//! A projectile that shears out a plug strikes the next plate together with the plug, with a blunt front. Otherwise its mass and nose are
//! unchanged. Contact between plates is not computed; a plate that moves farther than the gap behind it gives a warning.

use std::sync::Arc;

use crate::model::plug::Plug;
use crate::model::run::{Outcome, Run, RunWarning, StackRun};
use crate::model::scene::{Closure, Layer, Mount, Nose, PlateSize, Scene, Stack};
use crate::model::variables::error::VariableError;

/// Runs the plates behind the scene's own plate, whose run is `first`, one after the other; `None` if the scene is not a stack. Adds
/// warnings about the stack to `first`.
///
/// # Errors
/// Returns a [`VariableError`] if an element makes no physical sense by itself.
pub fn follow(
    scene: &Scene,
    first: &mut Run,
    simulate: &mut dyn FnMut(Scene) -> Result<Run, VariableError>,
) -> Result<Option<StackRun>, VariableError> {
    if !scene.is_stack() {
        return Ok(None);
    }
    let plates = plates(scene);
    let elements = plates.len() - 1;
    let mut behind: Vec<Arc<Run>> = Vec::new();
    let mut passed_m = 0.0;
    for mut plate in plates.into_iter().skip(1) {
        let last = behind.last().map_or(&*first, |run| run);
        let Some(velocity) = residual_velocity_m_s(last) else {
            break;
        };
        passed_m += last.scene.effective_thickness_m();
        plate.projectile.velocity_m_s = velocity;
        behind.push(Arc::new(simulate(plate)?));
    }
    warn_of_gaps(scene, first, &behind, elements);
    let last = behind.last().map_or(&*first, |run| run);
    let residual_velocity_m_s = residual_velocity_m_s(last);
    let (ended, depth_m) = match last.outcome {
        // A plate that oscillates across the projectile has stopped it, though from behind.
        Outcome::Perforated if last.end.is_complete() && residual_velocity_m_s.is_none() => {
            (Outcome::Separated, Some(last.scene.effective_thickness_m()))
        }
        Outcome::Perforated | Outcome::Moving | Outcome::Unmeasured => (last.outcome, None),
        Outcome::Arrested | Outcome::Separated => (last.outcome, last.penetration.final_m),
    };
    // A nose that stands out of an element is still within the stack.
    let is_in_base = behind.len() == elements;
    let outcome = if is_in_base { last.shot_outcome() } else { ended };
    Ok(Some(StackRun {
        elements,
        outcome,
        penetration_m: depth_m.map(|depth_m| passed_m + depth_m),
        residual_velocity_m_s,
        behind,
    }))
}

/// Returns the velocity of the projectile behind a plate, m/s; `None` if it does not perforate.
fn residual_velocity_m_s(run: &Run) -> Option<f64> {
    let through = run.outcome == Outcome::Perforated && run.end.is_complete();
    run.departure.residual_velocity_m_s.filter(|velocity| through && *velocity > 0.0)
}

/// Returns the scene of each plate in order, the base plate last. All have the shot of the first plate; plugs join the projectile.
pub fn plates(scene: &Scene) -> Vec<Scene> {
    let alone = Scene { stack: Stack::default(), sweep: None, ..scene.clone() };
    // A validated scene has a whole number of elements, 1 to 50.
    let copies = (1..=50).take_while(|count| f64::from(*count) <= scene.stack.elements).count();
    let mut plates = vec![alone.clone(); copies];
    for Layer { target, plate, mechanism } in &scene.stack.layers {
        let mut own = alone.clone();
        (own.target, own.plate, own.mechanism) = (*target, *plate, mechanism.clone());
        plates.push(own);
    }
    for behind in plates.iter_mut().skip(1) {
        behind.plate.velocity_m_s = 0.0;
    }
    let mut base = alone;
    base.plate.mount = Mount::Rigid;
    (base.plate.cocking_m, base.plate.velocity_m_s) = (0.0, 0.0);
    base.mechanism.stop.position_m = None;
    base.target.thickness_m = scene.stack.base_thickness_m.unwrap_or(base.target.thickness_m);
    if let Some(strength_pa) = scene.stack.base_strength_pa {
        base.target = base.target_in_effect();
        base.target.closure = Closure::Given;
        base.target.flow_strength_pa = strength_pa;
    }
    plates.push(base);
    carry_plugs(&mut plates);
    plates
}

/// Adds each plug to the projectile that strikes the next plate. Mass ratios still refer to the first projectile.
fn carry_plugs(plates: &mut [Scene]) {
    for next in 1..plates.len() {
        let before = &plates[next - 1];
        let Some(plug) = Plug::from_scene(before) else { continue };
        let mut shot = before.projectile;
        (shot.mass_kg, shot.nose) = (shot.mass_kg + plug.mass_kg, Nose::Blunt);
        let plate = &mut plates[next];
        if let PlateSize::Ratio(_) = plate.plate.size {
            plate.plate.size = PlateSize::Mass(plate.plate_mass_kg());
        }
        plate.projectile = shot;
    }
}

fn warn_of_gaps(scene: &Scene, first: &mut Run, behind: &[Arc<Run>], elements: usize) {
    let behind = behind.iter().map(|run| run.max_plate_displacement_m);
    let travels = std::iter::once(first.max_plate_displacement_m).chain(behind).take(elements);
    first.warnings.extend(travels.enumerate().filter_map(|(plate, travel_m)| {
        let (travel_m, gap_m) = (travel_m?, scene.stack.gap_m?);
        (travel_m > gap_m).then_some(RunWarning::PlateMeetsNext { plate, travel_m, gap_m })
    }));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::simulate::bare_run;
    use crate::model::variables::{scene_with, validate};

    /// Mass that strikes a plate, kg, and velocity behind it, m/s.
    const EXPECTED: [(f64, f64); 3] = [
        (0.0134, 584.239_128_247),
        (0.019_126_629_015, 281.824_822_033),
        (0.024_853_258_030, 145.888_518_321),
    ];

    /// Reference: closed forms of three successive rigid plates in an independent program.
    #[test]
    fn valid_the_next_plate_is_struck_by_projectile_and_plug() {
        let alloy = "closure=cylindrical rho=2700 Y=276MPa UTS=310MPa E=68.3GPa";
        let shot =
            "nose=fragment m_p=13.4g R=6.3mm v_i=1100 h=20mm mount=rigid elements=2 h_base=12mm";
        let run = bare_run(&scene_with(&format!("{alloy} {shot}")));
        for (plate, (kg, after_m_s)) in run.plates().zip(EXPECTED) {
            let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-9;
            assert!(near(plate.scene.projectile.mass_kg, kg), "{:?}", plate.scene.projectile);
            assert!(near(plate.departure.residual_velocity_m_s.unwrap(), after_m_s), "{kg}");
        }
        assert_eq!(run.plates().count(), 3);
        // Plates defined by a mass ratio keep their mass.
        let heavy = plates(&scene_with(&format!("{alloy} {shot} mount=sprung gamma=5")));
        assert!((heavy[1].plate_mass_kg() / 0.067 - 1.0).abs() < 1e-14);
    }

    /// A plate behind a fragment is struck by a blunt front. It also needs the strength of its metal, and a mass above that of its plug.
    #[test]
    fn a_plate_behind_a_plug_without_its_law_is_refused() {
        let alloy = "closure=cylindrical rho=2700 Y=276MPa UTS=310MPa E=68.3GPa";
        for (pairs, text) in [
            ("nose=fragment mount=rigid elements=2 h_base=12mm S_base=300MPa", "base plate: nose"),
            ("nose=fragment elements=3 h_base=12mm gamma=0.1", "the whole plate is the plug"),
        ] {
            let error = validate(&scene_with(&format!("{alloy} {pairs}"))).unwrap_err().to_string();
            assert!(error.contains(text) && !error.contains('\n'), "{error}");
        }
    }

    #[test]
    fn the_sentence_names_the_plate_that_stopped_the_shot() {
        let stopped = |elements| StackRun {
            behind: Vec::new(),
            elements,
            outcome: Outcome::Arrested,
            penetration_m: Some(0.01),
            residual_velocity_m_s: None,
        };
        assert_eq!(stopped(1).sentence(), "stack: stopped in element 1, 10.0000 mm in all");
        assert_eq!(stopped(0).sentence(), "stack: stopped in the base plate, 10.0000 mm in all");
    }

    /// A shot that protrudes from the base plate is stopped by the one criterion and perforates by the other, in every result.
    #[test]
    fn a_nose_out_of_the_base_plate_perforates_the_stack_by_protrusion() {
        let shot = "h_base=3mm h=0.5mm v_i=110 elements=1";
        let passage = bare_run(&scene_with(shot));
        let out = bare_run(&scene_with(&format!("{shot} criterion=protrusion")));
        let [passed, stuck] = [&out, &passage].map(|run| run.stack.clone().unwrap());
        assert_eq!((passage.shot_outcome(), stuck.outcome), (Outcome::Arrested, Outcome::Arrested));
        assert_eq!(
            (out.shot_outcome(), passed.outcome),
            (Outcome::Perforated, Outcome::Perforated)
        );
        assert_eq!(passed.penetration_m, stuck.penetration_m);
        let sentence = passed.sentence();
        assert!(sentence.starts_with("stack: perforated by the army criterion"), "{sentence}");
    }
}
