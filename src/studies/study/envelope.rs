//! Envelope of validity of the model: the same checks for every command, page and study.
//!
//! Each [`Breach`] contains the value, its meaning, and the direction of the error. [`of_scene`] finds the breaches that follow from the
//! scene, [`of_run`] also those that need a run (stop, spring, interface). Simulations do not evaluate these checks, so sweeps and searches
//! have no extra cost.

use cmra_engine::model::plug::CYLINDER_FROM;
pub use cmra_engine::model::plug::{is_law_low, thickness_ratio};
pub use cmra_engine::model::run::{Check, Direction};

use crate::study::design::critical_obliquity_deg;
use crate::study::library;
use Direction::{Conservative, Unconservative, Unknown};
use cmra_engine::model::mechanism::{Inertia, Mechanism};
use cmra_engine::model::run::{EventKind, Run, RunWarning, Warning};
use cmra_engine::model::scene::{
    Closure, ContactModel, Core, InterfaceLaw, Nose, OwnMass, Projectile, Scene, Target,
};
use cmra_engine::model::units::{engineering, significant};
use cmra_engine::model::variables;

/// Plate thickness h/D up to which the model is validated with dishing, and above which without. The text says "about" within a tenth of
/// it.
const THICKNESS: f64 = 1.0;
const ABOUT: f64 = 0.1;
/// Minimum h/D at which the diameter over which a dished plate fails agrees with measurements.
const SHEET: f64 = 0.3;
/// Minimum density, kg/m³, and yield stress, Pa, of a metal target.
const METAL_KG_M3: f64 = 1500.0;
const METAL_PA: f64 = 1e8;
/// Yield strength of plates that break a pointed core above about 500 m/s and not below 450 m/s, Pa, and the h/D below which the core stays
/// whole.
const BREAKS_PA: f64 = 1.25e9;
const BREAKS_BELOW: f64 = 0.7;
/// Strength of a hardened steel projectile, Pa, and the fraction of it above which the projectile may deform.
pub const PROJECTILE_STRENGTH_PA: f64 = 2e9;
const RIGID_UP_TO: f64 = 0.5;
/// Minimum side of the plate's face, in projectile diameters.
pub const FACE_LEAST: f64 = 3.0;
/// Range of measured impact velocities, quasi-static to moderate, m/s.
const VELOCITIES_M_S: (f64, f64) = (50.0, 1000.0);
/// Angle, deg, and the underestimation of limits of a hard core on aluminium, percent (`validate`); the last angle is the maximum for the
/// model.
pub const OBLIQUE_LOW: [(f64, f64); 3] = [(15.0, 3.6), (30.0, 8.6), (45.0, 16.1)];
const OBLIQUE_UP_TO: f64 = 20.0;
/// Remark on oblique limits of a nose that shears out a plug.
const PLUG_AT_AN_ANGLE: &str = "no limit of a nose that shears out a plug is measured at an angle";
/// Maximum velocity of the end of a steel coil, m/s. A faster end sends a wave through the wire that exceeds its strength.
const COIL_END_M_S: f64 = 20.0;
/// Maximum ratio of the springs' moving mass to the plate mass for which it may be omitted.
const SPRING_MASS_MOST: f64 = 0.1;

/// Rule of the table that a scene or a run violates.
#[derive(Clone, Debug, PartialEq)]
pub struct Breach {
    /// Violated check.
    pub check: Check,
    /// Direction of the error.
    pub direction: Direction,
    /// Severity: the breach with the larger magnitude is worse. The sign distinguishes breaches of the same check: it is negative for a
    /// shot that is too slow and for the surge of a coil.
    pub degree: f64,
    /// Clause with the number.
    value: String,
    /// Rest of the sentence, from its punctuation mark on.
    meaning: String,
}

impl Breach {
    /// Returns `true` if two breaches have the same check, direction and sign of the severity.
    pub fn is_same(&self, other: &Self) -> bool {
        let key = |it: &Self| (it.check, it.direction, it.degree.is_sign_negative());
        key(self) == key(other)
    }

    /// Returns `true` if each of the others is a different or a less severe breach.
    pub fn is_new_to<'b>(&self, mut others: impl Iterator<Item = &'b Self>) -> bool {
        others.all(|other| !self.is_same(other) || self.degree.abs() > other.degree.abs())
    }
}

impl From<&Breach> for Warning {
    fn from(breach: &Breach) -> Self {
        let Breach { check, direction, .. } = *breach;
        let remark = Self::remark(&breach.value, &breach.meaning);
        Self { breach: Some((check, direction)), ..remark }
    }
}

/// Returns the yield stress of the plate, Pa; half of a directly given flow strength, by Virostek's closure.
pub fn equivalent_yield_pa(scene: &Scene) -> f64 {
    let is_given = scene.closure() == Closure::Given;
    if is_given { 0.5 * scene.flow_strength_pa() } else { scene.target.yield_pa }
}

/// Returns the pressure on the nose at impact, S + c v², over the strength of hardened steel.
pub fn nose_pressure_ratio(scene: &Scene) -> f64 {
    let v = scene.closing_velocity_m_s();
    (scene.flow_strength_pa() + scene.drag_kg_m3() * v * v) / PROJECTILE_STRENGTH_PA
}

/// Returns the side of the plate's face in projectile diameters; `None` if the plate's mass is not used.
pub fn face_ratio(scene: &Scene) -> Option<f64> {
    scene.is_sprung().then(|| 0.5 * scene.plate_face_m() / scene.projectile.tip_radius_m)
}

/// Returns the breaches that follow from a scene, in the order of the table.
pub fn of_scene(scene: &Scene) -> Vec<Breach> {
    let mut found: Vec<Breach> = thickness(scene).into_iter().chain(velocity(scene)).collect();
    let mut add = |check, direction, degree, value: String, meaning: &str| {
        found.push(Breach { check, direction, degree, value, meaning: meaning.to_owned() });
    };
    let Projectile { nose, mass_kg, obliquity_deg: theta, .. } = scene.projectile;
    let (density, yield_pa) = (scene.target.density_kg_m3, equivalent_yield_pa(scene));
    if density < METAL_KG_M3 && yield_pa < METAL_PA {
        let value = format!(
            "material is no metal: rho = {} kg/m^3, Y = {} MPa",
            significant(density, 4),
            significant(1e-6 * yield_pa, 3)
        );
        let meaning = "; both the strength and the drag are laws for metal plates";
        add(Check::Material, Unknown, METAL_KG_M3 / density, value, meaning);
    }
    for (direction, value, meaning) in of_nose(scene) {
        add(Check::Nose, direction, 1.0, value, &meaning);
    }
    let pressure = nose_pressure_ratio(scene);
    if pressure > RIGID_UP_TO && !is_measured_nose(scene) {
        let value = format!("nose pressure S + c v^2 is {} times 2 GPa", significant(pressure, 3));
        let meaning = format!(
            "; that is the strength of hardened steel, and above {RIGID_UP_TO} the projectile may deform or break"
        );
        add(Check::NosePressure, Conservative, pressure, value, &meaning);
    }
    let sphere_kg = scene.projectile.nose_sphere_kg();
    if sphere_kg > mass_kg {
        let value = format!(
            "nose mass of a sphere is {} g, the projectile has {} g",
            significant(1e3 * sphere_kg, 3),
            significant(1e3 * mass_kg, 3)
        );
        let meaning = ": radius, density and mass do not fit";
        add(Check::NoseMass, Unknown, sphere_kg / mass_kg, value, meaning);
    }
    if let Some(face) = face_ratio(scene).filter(|face| *face < FACE_LEAST) {
        let value = format!(
            "plate face is {} mm square, {} D",
            significant(1e3 * scene.plate_face_m(), 3),
            significant(face, 3)
        );
        let meaning = format!(
            ": below {FACE_LEAST} D its edges yield and the hole has no room; raise gamma or set face"
        );
        add(Check::Face, Unconservative, 1.0 / face, value, &meaning);
    }
    if theta > 0.0 {
        let ricochet = ricochet(scene).map_or_else(String::new, |text| format!("; {text}"));
        let (direction, error) = if nose.shears() {
            (Unknown, PLUG_AT_AN_ANGLE.to_owned())
        } else {
            (Conservative, oblique_error(theta))
        };
        let value = format!("theta = {} deg", significant(theta, 4));
        add(Check::Obliquity, direction, theta, value, &format!(": {error}{ricochet}"));
    }
    if has_fused_stop(scene) {
        let value = "rigid stop asks the fused interface for an unbounded force".to_owned();
        let meaning = ": nothing after it is hit is to be believed; set stop_kind=elastic";
        add(Check::Stop, Unconservative, 1.0, value, meaning);
    }
    found.sort_by_key(|breach| breach.check);
    found
}

/// Returns the breach of the range of measured velocities.
fn velocity(scene: &Scene) -> Option<Breach> {
    let (v, (slow, fast)) = (scene.closing_velocity_m_s(), VELOCITIES_M_S);
    let symbol = if scene.plate_velocity_m_s() == 0.0 { "v_i" } else { "v_i - w_0 cos(theta)" };
    let shown = format!("{symbol} = {} m/s is", significant(v, 4));
    let (degree, value, meaning) = if v < slow {
        (-slow / v, format!("{shown} below the {slow} m/s of measurements"), "")
    } else if v > fast {
        let meaning = ": heating, rate and erosion are not modelled";
        (v / fast, format!("{shown} above {fast} m/s"), meaning)
    } else {
        return None;
    };
    let meaning = meaning.to_owned();
    Some(Breach { check: Check::Velocity, direction: Unknown, degree, value, meaning })
}

/// Returns `true` if the law in effect is validated by measurements with the nose. It must not be a hemisphere; its deformation does not
/// matter.
fn is_measured_nose(scene: &Scene) -> bool {
    let is_round = scene.projectile.nose == Nose::Hemispherical;
    !is_round && scene.closure() == Closure::Cylindrical
}

/// Returns the breaches that follow from nose and core.
fn of_nose(scene: &Scene) -> Vec<(Direction, String, String)> {
    let Projectile { nose, core, .. } = scene.projectile;
    let is_foreign = nose != Nose::Hemispherical && !is_measured_nose(scene);
    let foreign = is_foreign && scene.contact.model == ContactModel::Hydrodynamic;
    let foreign = foreign.then(|| {
        let meaning = format!(
            ": its law is measured with closure = cylindrical, and closure = {} is in effect; set closure=cylindrical with Y, UTS and E",
            scene.closure().word()
        );
        (Unknown, format!("nose is {}", nose.word()), meaning)
    });
    let deforms = (core == Core::Deformable).then(|| {
        let meaning =
            ": the law takes the projectile as rigid, which penetrates more than one that deforms";
        (Conservative, "core is deformable".to_owned(), meaning.to_owned())
    });
    foreign.into_iter().chain(deforms).collect()
}

fn thickness(scene: &Scene) -> Option<Breach> {
    if !scene.contact.model.knows_perforation() {
        return None;
    }
    let ratio = thickness_ratio(scene);
    let (direction, target, meaning) = match scene.projectile.nose {
        Nose::Hemispherical => {
            let (direction, meaning) = under_hemisphere(scene, ratio)?;
            (direction, String::new(), meaning)
        }
        Nose::Pointed if scene.target.yield_pa >= BREAKS_PA && ratio < BREAKS_BELOW => {
            let target = format!(
                " of a hard plate, Y = {} MPa, under a pointed core",
                significant(1e-6 * scene.target.yield_pa, 4)
            );
            let meaning =
                format!(": below about {BREAKS_BELOW} limits come out 40 to 50 % too high");
            (Unconservative, target, meaning)
        }
        Nose::Blunt if ratio < CYLINDER_FROM => {
            let meaning = format!(
                ": below about {CYLINDER_FROM} the plate dishes, which the plug law does not contain, and its limits come out 1.6 to 4 \
                 times too low"
            );
            (Conservative, " under a rigid cylinder".to_owned(), meaning)
        }
        Nose::Pointed | Nose::Blunt | Nose::Fragment => return None,
    };
    let degree = if direction == Conservative { ratio } else { 1.0 / ratio };
    let value = format!("h/D = {}{target}", significant(ratio, 3));
    Some(Breach { check: Check::Thickness, direction, degree, value, meaning })
}

/// Returns direction and meaning of the breach of the thickness ratio under closures for a hemisphere.
fn under_hemisphere(scene: &Scene, ratio: f64) -> Option<(Direction, String)> {
    let Target { dishing: dishes, closure, .. } = scene.target_in_effect();
    Some(if dishes && ratio > THICKNESS + ABOUT {
        let is_given = closure == Closure::Given;
        let cure = if is_given { "a strength by cavity expansion" } else { "closure=cavity" };
        let meaning = ": with dishing the law is validated up to about 1; set dishing=off and ";
        (Conservative, format!("{meaning}{cure}"))
    } else if dishes && ratio < SHEET {
        let meaning = format!(
            ": with dishing each plate dishes over one diameter, however thin; below about {SHEET} several sheets resist more than \
             one plate of their mass, which no measurement supports"
        );
        (Unconservative, meaning)
    } else if !dishes && ratio < THICKNESS - ABOUT {
        let cure = match closure {
            Closure::Cavity | Closure::Cylindrical => "closure=double-yield and dishing=on",
            Closure::Given | Closure::DoubleYield | Closure::ByThickness => "dishing=on",
        };
        let meaning = ": without dishing the law is validated from about 1; a thin plate bulges and resists less; set ";
        (Unconservative, format!("{meaning}{cure}"))
    } else {
        return None;
    })
}

/// Describes the measured error of limits at an angle > 0, deg: that of the nearest measured angle.
pub fn oblique_error(theta: f64) -> String {
    let far = |it: &(f64, f64)| (it.0 - theta).abs();
    let nearest = OBLIQUE_LOW.into_iter().min_by(|a, b| far(a).total_cmp(&far(b)));
    let (angle, percent) = nearest.unwrap_or_default();
    let beyond = if theta > OBLIQUE_UP_TO {
        format!("; the model is not for more than about {OBLIQUE_UP_TO} deg")
    } else {
        String::new()
    };
    format!(
        "oblique limits come out below measured ones, by {percent} % at {angle} deg on a rigid mount (cmra validate), by more on a \
         light sprung plate{beyond}"
    )
}

/// Warns of a likely ricochet, which is not modelled; `None` up to Tate's critical angle.
pub fn ricochet(scene: &Scene) -> Option<String> {
    let critical = critical_obliquity_deg(scene);
    (scene.projectile.obliquity_deg > critical).then(|| {
        let critical = significant(critical, 3);
        format!("beyond Tate's critical {critical} deg, a rule for long rods at high speed, ricochet is likely")
    })
}

/// Returns `true` if a scene has a rigid stop under a fused interface, which cannot carry an impact on it. A lumped interface never fuses.
fn has_fused_stop(scene: &Scene) -> bool {
    scene.interface.law == InterfaceLaw::Fused
        && scene.contact.model != ContactModel::Lumped
        && Mechanism::from_scene(scene).rigid_stop().is_some()
}

/// Returns whether a rigid stop is hit under a fused interface; `None` for a scene without such a stop.
pub fn hits_fused_stop(run: &Run) -> Option<bool> {
    // Before its last arrest the projectile flows on, or its force history runs on, whatever the plate does.
    let is_arrest = |kind| matches!(kind, EventKind::FirstArrest | EventKind::Arrest);
    let arrest = run.events.iter().rposition(|event| is_arrest(event.kind));
    let fused = || run.events.iter().skip(arrest.unwrap_or(run.events.len()));
    has_fused_stop(&run.scene).then(|| fused().any(|event| event.kind == EventKind::StopHit))
}

/// Returns the breaches of a run, in the order of the table: those of its scene, and those of the loads of stop, spring and interface. For
/// a stack, returns each breach of the plate where it is worst.
pub fn of_run(run: &Run) -> Vec<Breach> {
    let mut found = of_plate(run);
    for (name, plate) in behind(run) {
        let lead = |breach: Breach| Breach { value: format!("{name}: {}", breach.value), ..breach };
        let own = of_plate(plate).into_iter();
        let new: Vec<Breach> = own.filter(|it| it.is_new_to(found.iter())).map(lead).collect();
        found.retain(|old| !new.iter().any(|it| it.is_same(old)));
        found.extend(new);
    }
    found.sort_by_key(|breach| breach.check);
    found
}

/// Returns `true` if a run puts more load on a fused interface than it carries.
pub fn is_overloaded(run: &Run) -> bool {
    of_run(run).iter().any(|it| matches!(it.check, Check::Interface | Check::Rebound))
}

/// Iterates over the struck plates behind the first of a stack, with their names.
fn behind(run: &Run) -> impl Iterator<Item = (String, &Run)> {
    let names = run.stack.iter().flat_map(|stack| (1..).map(|plate| stack.name(plate)));
    names.zip(run.plates().skip(1))
}

/// Returns the breaches of the run of one plate.
fn of_plate(run: &Run) -> Vec<Breach> {
    let mut found = of_scene(&run.scene);
    if hits_fused_stop(run) == Some(false) {
        found.retain(|breach| breach.check != Check::Stop);
    }
    let mut add = |check, degree, (value, meaning)| {
        found.push(Breach { check, direction: Unconservative, degree, value, meaning });
    };
    let has_coil = run.scene.is_sprung() && run.scene.mechanism.has_coil();
    let arrest_m_s = run.first_arrest.map(|arrest| arrest.plate_velocity_m_s);
    let speed = arrest_m_s.or(run.departure.plate_velocity_m_s).unwrap_or(0.0).abs();
    if has_coil && speed > COIL_END_M_S {
        let value = format!("spring end moves at {} m/s", significant(speed, 3));
        let meaning = format!(
            ": above about {COIL_END_M_S} m/s a steel coil surges, its stress exceeds the static one, and its coils may close"
        );
        add(Check::Spring, -speed, (value, meaning));
    }
    if let Some((degree, sentence)) = spring_mass(run) {
        add(Check::SpringMass, degree, sentence);
    }
    for warning in &run.warnings {
        if let Some((check, degree)) = check_of(warning) {
            add(check, degree, warning.sentence());
        }
    }
    found
}

/// Returns the moving mass of the springs over the plate's mass, if it is omitted and would slow the plate noticeably, with value and
/// meaning.
fn spring_mass(run: &Run) -> Option<(f64, (String, String))> {
    let (scene, own) = (&run.scene, Inertia::from_scene(&run.scene));
    if own.is_uncounted {
        let meaning = ": the mass of a spring that is neither coil nor beam is not known; give m_spring or e_spring";
        let sentence = ("own_mass=counted adds nothing".to_owned(), meaning.to_owned());
        return Some((f64::INFINITY, sentence));
    }
    let spring = &scene.mechanism.spring;
    let least_kg = scene.mechanism.min_spring_kg(run.mechanism.stored_j);
    let (omitted_kg, is_least) = own.omitted_kg(least_kg);
    let over_plate = spring.moving_part() * omitted_kg / scene.plate_mass_kg();
    let is_of_second = spring.own_mass == OwnMass::Counted;
    let cure =
        if is_of_second { "add the second spring's to m_spring" } else { "set own_mass=counted" };
    let value = format!("spring mass moving is {} times the plate's", significant(over_plate, 3));
    let meaning = format!(
        "; the spring has {}{} g, which is omitted: {cure}",
        if is_least { "at least " } else { "" },
        significant(1e3 * omitted_kg, 3)
    );
    (over_plate > SPRING_MASS_MOST).then_some((over_plate, (value, meaning)))
}

/// Returns the check that a warning of a run belongs to, with its severity.
fn check_of(warning: &RunWarning) -> Option<(Check, f64)> {
    match warning {
        RunWarning::Limit(limit) => Some((Check::Spring, (limit.required_m / limit.limit_m).abs())),
        RunWarning::InterfacePush { ratio, .. } => Some((Check::Interface, *ratio)),
        // The grip is an assumption, so a push takes precedence over a pull.
        RunWarning::InterfacePull { .. } => Some((Check::Interface, 0.0)),
        RunWarning::InterfaceRebound { ratio, .. } => Some((Check::Rebound, *ratio)),
        _ => None,
    }
}

/// Returns all warnings about a run: breaches of the model's validity, then events of the run, then values outside the ranges searched by
/// the thesis.
pub fn warnings(run: &Run) -> Vec<Warning> {
    let mut list: Vec<Warning> = of_run(run).iter().map(Warning::from).collect();
    list.extend(remarks(run));
    list.extend(variables::range_warnings(&run.scene));
    list.extend(library::warnings(&run.scene));
    list
}

/// Warns of a peak contact force above the static collapse load of the clamped plate, pi Y h²; `None` below it, and for a given flow
/// strength.
fn bends(run: &Run) -> Option<Warning> {
    let Target { yield_pa, thickness_m, .. } = run.scene.target;
    let load_n = std::f64::consts::PI * yield_pa * thickness_m * thickness_m;
    let is_known = run.scene.closure() != Closure::Given;
    let peak_n = run.peak_contact_force_n.filter(|peak_n| is_known && *peak_n > load_n)?;
    let meaning = format!(
        ": the peak contact force of {} exceeds {}, the static collapse load pi Y h^2 of a clamped plate (indicative: short contacts \
         resist by inertia)",
        engineering(peak_n, "N", 3),
        engineering(load_n, "N", 3)
    );
    Some(Warning::remark("plate bends", meaning))
}

/// Returns remarks on a run that are not breaches of validity.
pub fn remarks(run: &Run) -> Vec<Warning> {
    let is_remark = |warning: &&RunWarning| check_of(warning).is_none();
    let mut list: Vec<Warning> = run.warnings.iter().filter(is_remark).map(Warning::from).collect();
    list.extend(bends(run));
    for (name, plate) in behind(run) {
        list.extend(bends(plate).map(|warning| warning.at(&*name)));
        // Plates of a stack have no baseline. Remarks that also apply to the first plate are not repeated.
        let is_own =
            |it: &&RunWarning| **it != RunWarning::NoBaseline && !run.warnings.contains(*it);
        let own = plate.warnings.iter().filter(is_remark).filter(is_own);
        list.extend(own.map(|warning| Warning::from(warning).at(&*name)));
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::plain_run;
    use cmra_engine::model::scene::Layer;

    fn run(scene: &Scene) -> Run {
        plain_run(scene).expect("a valid scene")
    }

    fn with(changes: &str) -> Scene {
        variables::changed(Scene::default(), changes).expect("values the variables take")
    }

    /// Returns the text of the breach of a check; empty if there is none.
    fn words(found: &[Breach], check: Check) -> String {
        let breach = found.iter().find(|breach| breach.check == check);
        breach.map(|it| Warning::from(it).to_string()).unwrap_or_default()
    }

    /// Returns a scene without breaches, with changes: a 12 mm plate under the 20 mm projectile of Borvik 2002, 10 D wide, without a
    /// spring.
    fn inside(changes: &str) -> Scene {
        let own = "m_p=0.197 R=0.01 v_i=200 h=0.012 rho=7850 face=0.2 k=0";
        with(&format!("{own} {changes}"))
    }

    #[test]
    fn every_rule_is_kept_inside_and_each_breach_gives_its_number_and_direction() {
        let core =
            |own: &str| format!("nose=pointed R=5.442mm closure=cylindrical UTS=1640MPa {own}");
        for kept in [core("Y=1350MPa h=8mm"), core("Y=1200MPa h=7mm")] {
            assert_eq!(thickness(&inside(&kept)), None, "{kept}");
        }
        let hard = core("Y=1350MPa h=7mm");
        for kept in ["", "face=50mm mount=rigid", "gamma=0.05 mount=rigid"] {
            assert_eq!(of_scene(&inside(kept)), [], "{kept}");
        }
        for (changes, check, direction, number) in [
            (hard.as_str(), Check::Thickness, Unconservative, "40 to 50 %"),
            (
                "nose=blunt closure=cylindrical h=11mm",
                Check::Thickness,
                Conservative,
                "1.6 to 4 times",
            ),
            ("h=1mm", Check::Thickness, Unconservative, "several sheets"),
            ("rho=1200", Check::Material, Unknown, "no metal"),
            // 0.06/0.02 = 3.
            ("h=60mm", Check::Thickness, Conservative, "h/D = 3"),
            ("dishing=off", Check::Thickness, Unconservative, "h/D = 0.6"),
            ("nose=blunt closure=double-yield", Check::Nose, Unknown, "closure=cylindrical"),
            ("nose=pointed", Check::Nose, Unknown, "closure = given"),
            ("core=deformable", Check::Nose, Conservative, "rigid"),
            (
                "nose=fragment closure=cylindrical theta=30deg",
                Check::Obliquity,
                Unknown,
                "at an angle",
            ),
            // 1.5e9/2e9 and a drag of 7850/4 * 200^2 = 7.85e7 Pa more.
            ("S_y=1.5e9", Check::NosePressure, Conservative, "0.789"),
            // 4/3 pi 0.01^3 7850 = 32.9 g.
            ("m_p=30g", Check::NoseMass, Unknown, "32.9 g"),
            // 50/20 = 2.5.
            ("face=50mm", Check::Face, Unconservative, "plate face is 50 mm square, 2.5 D"),
            // sqrt(0.05 * 0.197 kg/(7850 kg/m^3 * 12 mm)) = 10.2 mm.
            ("gamma=0.05", Check::Face, Unconservative, "plate face is 10.2 mm square, 0.511 D"),
            ("v_i=20", Check::Velocity, Unknown, "20 m/s"),
            ("v_i=1200", Check::Velocity, Unknown, "erosion"),
            ("theta=30deg", Check::Obliquity, Conservative, "8.6 % at 30"),
            ("x_stop=0.01", Check::Stop, Unconservative, "stop"),
        ] {
            let text = words(&of_scene(&inside(changes)), check);
            assert!(text.ends_with(&format!("({})", direction.word())), "{check:?}: {text}");
            assert!(text.contains(number), "{text}");
        }
    }

    /// A plate with gamma = 1 moves at 50 m/s after a shot of 100 m/s; a heavy plate at 10 m/s.
    #[test]
    fn a_run_warns_of_spring_stop_and_interface() {
        assert_eq!(words(&of_run(&run(&inside("k=1e6"))), Check::Spring), "");
        let of = |changes, check| words(&of_run(&run(&with(changes))), check);
        // A single coil that acts beside a beam is enough; a spring without force does not count.
        for (pairs, surges) in [
            ("k=1e5 combine=parallel k_2=0", true),
            ("spring=prbm-cantilever combine=parallel k_2=1e5", true),
            ("spring=prbm-cantilever combine=parallel k_2=0", false),
            // A perforated plate leaves with 39 m/s.
            ("k=1e5 v_i=500 h=4mm", true),
        ] {
            assert_eq!(of(pairs, Check::Spring).contains("spring end moves at"), surges, "{pairs}");
        }
        // A stop breaches validity only if the fused bodies reach it.
        assert_eq!(of("x_stop=10", Check::Stop), "");
        assert_eq!(of("x_stop=0.001", Check::Stop), "");
        assert_ne!(of("x_stop=0.02", Check::Stop), "");
        // Cocked by 0.5 m the interface must carry 25.1 kN and carries 8.7 kN.
        assert!(of("d=0.5", Check::Interface).contains("interface push is 2.8"));
    }

    /// The second element, 30 mm thick on 1e6 N/m, has the breaches of a single plate under the same shot, and its name in the text.
    #[test]
    fn a_stack_has_the_breaches_of_all_its_plates() {
        let mut scene = inside("v_i=500 h_base=0.012");
        let Scene { target, plate, mechanism, .. } = inside("h=0.03 k=1e6");
        scene.stack.layers.push(Layer { target, plate, mechanism });
        let stack = run(&scene);
        let struck = stack.plates().nth(1).unwrap().scene.projectile.velocity_m_s;
        let mut alone = inside("h=0.03 k=1e6");
        alone.projectile.velocity_m_s = struck;
        let expected = of_run(&run(&alone));
        // 0.03/0.02 = 1.5.
        assert!(expected.iter().any(|it| it.value == "h/D = 1.5"), "{expected:?}");
        let found = of_run(&stack);
        for breach in expected {
            let value = format!("element 2: {}", breach.value);
            let is_it = |it: &Breach| it.value == value && it.meaning == breach.meaning;
            assert!(found.iter().any(is_it), "{value} {found:?}");
        }
        let no_baseline = Warning::from(&RunWarning::NoBaseline);
        assert!(remarks(&stack).iter().all(|it| it.value != no_baseline.value));
    }

    /// Half of the baseline's 147.5 J needs 0.375 kg of wire (5.08 g/J), 12.7 plate masses, of which a third moves. For a given mass of 8 g
    /// a third is 0.0904 of the plate's 29.5 g; for 10 g it is 0.113. An absorber of 19460 J/kg needs 3.8 g for the same energy.
    #[test]
    fn a_springs_own_mass_that_is_omitted_is_a_breach() {
        for (changes, texts) in [
            ("k=1e5", &["at least 37", "spring mass moving is 4.2", "(unconservative)"][..]),
            ("m_spring=10g", &["has 10 g,", "is 0.113 times"]),
            ("spring=column own_mass=counted", &["give m_spring or e_spring"]),
            ("k=1e5 own_mass=counted", &[]),
            ("mount=rigid", &[]),
            ("k=0", &[]),
            ("m_spring=8g", &[]),
            ("e_spring=19460", &[]),
        ] {
            let found = words(&of_run(&run(&with(changes))), Check::SpringMass);
            assert_eq!(found.is_empty(), texts.is_empty(), "{changes}: {found}");
            assert!(texts.iter().all(|text| found.contains(text)), "{changes}: {found}");
        }
    }
}
