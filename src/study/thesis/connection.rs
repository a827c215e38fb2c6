//! Claims of section 9.4: what the trends of the spring and damper say of the other concepts.

use crate::model::mechanism::load::yields_at_m;
use crate::model::mechanism::{Mechanism, PowerLaw};
use crate::model::scene::Scene;
use crate::study::thesis::lab::Measure::Percent;
use crate::study::thesis::lab::{
    Lab, Law, changed, ends, found, mm, near, number, pc, spelled, trend_verdict, unit, with,
};
use crate::study::thesis::shape::falls;
use crate::study::thesis::{Claim, Opens};

/// The beam of Table 9.3 under a plate of gamma = 1.
fn beam(d: f64) -> Scene {
    changed(spelled(&[("spring", "prbm-cantilever")]), &[("d", d)])
}

/// A straight spring with the beam's stiffness at rest.
fn straight(d: f64) -> Scene {
    let stiffness = Mechanism::of(&beam(0.0)).spring.tangent(0.0);
    with(&[("k", stiffness), ("d", d)])
}

/// The helical spring of chapter 6, cocked.
fn helical(d: f64) -> Scene {
    let words = [("spring", "helix"), ("k_helix", "2e5"), ("twist", "60"), ("I_z", "2.1e-6")];
    changed(spelled(&words), &[("d", d)])
}

fn cocked_beam() -> Scene {
    beam(0.025)
}

fn cocked_helical() -> Scene {
    helical(0.1)
}

/// Projectile velocity at first contact, when the plate passes neutral (or at first arrest, if that is earlier), m/s.
fn velocity_at_neutral(lab: &Lab, scene: &Scene) -> (f64, f64) {
    let run = lab.run_with(Law::Sound, scene, true);
    let passed = run.series.iter().find(|row| row.plate_displacement_m >= 0.0);
    let arrest_s = run.first_arrest.map_or(f64::INFINITY, |arrest| arrest.t_s);
    let before = run.series.iter().rfind(|row| row.t_s <= arrest_s);
    let at = passed.filter(|row| row.t_s < arrest_s).or(before);
    (
        at.map_or(f64::NAN, |row| row.projectile_velocity_m_s),
        run.first_arrest.map_or(f64::NAN, |arrest| arrest.plate_displacement_m),
    )
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "9.4.1-force",
        place: "9.4.1",
        says: "the cocked cantilever pushes the plate along with the projectile's force",
        opens: Opens::Scene(cocked_beam),
        check: |lab| {
            let spring = Mechanism::of(&cocked_beam()).spring;
            let push = -spring.force(-0.025);
            let peak = lab.run(Law::Sound, &cocked_beam()).peak_contact_force_n;
            found(
                format!(
                    "{} at the start, beside {} of contact",
                    unit(push, "N"),
                    unit(peak.unwrap_or(f64::NAN), "N")
                ),
                trend_verdict(push > 0.0),
                "so it does, a sixth as strongly as the shot",
            )
        },
    },
    Claim {
        id: "9.4.1-similar",
        place: "9.4.1",
        says: "the cocked cantilever's design space is similar to the spring and damper's",
        opens: Opens::Scene(cocked_beam),
        check: |lab| {
            let cockings = [0.0, 0.01, 0.02, 0.029];
            let pairs = cockings.map(|d| {
                (lab.percent(Law::Sound, &beam(d)), lab.percent(Law::Sound, &straight(d)))
            });
            let told: Vec<String> =
                pairs.iter().map(|(own, other)| format!("{} / {}", pc(*own), pc(*other))).collect();
            found(
                format!("beam / straight spring at d = 0, 10, 20, 29 mm: {}", told.join(", ")),
                trend_verdict(pairs.iter().all(|(own, other)| near(*own, *other, 0.01))),
                "up to its yield the beam is straight to 3 %; its own mass is neglected, as in the thesis",
            )
        },
    },
    Claim {
        id: "9.4.1-stops",
        place: "9.4.1",
        says: "past its neutral position the cantilever stops plate and projectile",
        opens: Opens::Scene(cocked_beam),
        check: |lab| {
            let yields = yields_at_m(&beam(0.0).mechanism.spring).unwrap_or(f64::NAN);
            let travel = [0.0, 0.025].map(|d| lab.travel_mm(Law::Sound, &beam(d)));
            found(
                format!(
                    "it goes {} mm uncocked and {} mm cocked by 25 mm, and yields at {}",
                    number(travel[0]),
                    number(travel[1]),
                    mm(yields)
                ),
                trend_verdict(travel.iter().all(|travel| *travel < 1e3 * yields)),
                "it would not survive: 73.8 J come to 50 J it can hold",
            )
        },
    },
    Claim {
        id: "9.4.2-neutral",
        place: "9.4.2",
        says: "the projectile is not slowed before the mechanism has passed its neutral position",
        opens: Opens::Scene(cocked_helical),
        check: |lab| {
            let (velocity, displacement) = velocity_at_neutral(lab, &cocked_helical());
            found(
                format!(
                    "cocked by 100 mm: {} of 100 m/s are left at first arrest, {} short of neutral",
                    unit(velocity, "m/s"),
                    mm(-displacement)
                ),
                trend_verdict(velocity > 99.0),
                "it is slowed by the plate from the first touch, and at common speed long before neutral",
            )
        },
    },
    Claim {
        id: "9.4.2-similar",
        place: "9.4.2",
        says: "the helical spring's design space is similar to the cocked spring and damper's",
        opens: Opens::Scene(cocked_helical),
        check: |lab| {
            let axis = ("d", 0.0, 0.5, 11);
            let own = lab.curve(Law::Sound, Percent, &helical(0.0), axis);
            let turning = helical(0.0).mechanism.spring.helix;
            let law = PowerLaw { coefficient: turning.stiffness_n_m, exponent: 1.0 };
            let other = lab.curve(Law::Sound, Percent, &with(&[("k", law.coefficient)]), axis);
            found(
                format!(
                    "{}; without rotation {}",
                    ends(Percent, "d", &own),
                    ends(Percent, "d", &other)
                ),
                trend_verdict(falls(&own) && falls(&other)),
                "the same trend, with a plate that answers as if a quarter heavier; asserted there, not computed",
            )
        },
    },
];
