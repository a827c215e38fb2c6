//! Claims of section 8.3: the evaluation model, what it assumes, and its validation.

use crate::model::run::Outcome;
use crate::model::scene::{Closure, ContactModel, OwnMass, Scene};
use crate::study::thesis::lab::{
    BASELINE_M, LAWS, Lab, Law, both, changed, found, limit_m_s, listing_material, mm, near,
    number, number_verdict, pc, rigid, trend_verdict, unit, with,
};
use crate::study::thesis::{Claim, Opens, Verdict};

fn rigid_base() -> Scene {
    rigid(with(&[]))
}

/// The spring's own mass counted.
fn weighed() -> Scene {
    let mut scene = with(&[]);
    scene.mechanism.spring.own_mass = OwnMass::Counted;
    scene
}

fn free() -> Scene {
    with(&[("k", 0.0)])
}

fn at_once() -> Scene {
    let mut scene = with(&[]);
    scene.contact.model = ContactModel::InitialVelocity;
    scene
}

/// Table 8.2; R, `S_y` and `C_d`, which it leaves out, are those of Table 9.1.
fn yang_xi() -> Scene {
    let changes = [
        ("m_p", 0.034),
        ("v_i", 118.2),
        ("gamma", 0.195 / 0.034),
        ("h", 0.01),
        ("rho", 2600.0),
        ("k", 0.0),
        ("horizon", 2.714e-3),
    ];
    with(&changes)
}

/// Plate displacement at the end of the photographs, mm.
fn moved_mm(lab: &Lab, law: Law, strength_pa: f64) -> f64 {
    let scene = changed(yang_xi(), &[("S_y", strength_pa)]);
    let run = lab.run_with(law, &scene, true);
    match run.outcome {
        Outcome::Perforated => f64::NAN,
        Outcome::Arrested | Outcome::Separated | Outcome::Moving => {
            run.series.last().map_or(f64::NAN, |row| 1e3 * row.plate_displacement_m)
        }
    }
}

/// The last contact force before the first arrest, and the greatest, N.
fn force_at_arrest(lab: &Lab, law: Law, scene: &Scene) -> (f64, f64) {
    let run = lab.run_with(law, scene, true);
    let end_s = run.first_arrest.map_or(f64::INFINITY, |arrest| arrest.t_s);
    let mut contact = run.series.iter().filter(|row| row.t_s < end_s * (1.0 - 1e-9));
    let last = contact.next_back().map_or(f64::NAN, |row| row.contact_force_n);
    (last, run.peak_contact_force_n.unwrap_or(f64::NAN))
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "8.3-initial-velocity",
        place: "8.3",
        says: "the initial velocity model is inaccurate",
        opens: Opens::Scene(at_once),
        check: |lab| {
            let depth = lab.run(Law::Sound, &at_once()).final_penetration_m;
            let own = lab.travel_mm(Law::Sound, &at_once());
            let reference = lab.travel_mm(Law::Sound, &with(&[]));
            both(
                format!(
                    "depth {}; plate travel {} mm, drag model {} mm",
                    depth.map_or_else(|| "not given".to_owned(), mm),
                    number(own),
                    number(reference)
                ),
                format!("travel {} mm", number(lab.travel_mm(Law::Printed, &with(&[])))),
                Verdict::Unchecked,
                "the thesis needs depth, and this model gives none; the travel that it gives is right to a tenth of a percent",
            )
        },
    },
    Claim {
        id: "8.3-zero-force",
        place: "8.3",
        says: "the contact force goes to zero when both velocities are equal",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let told = |(last, peak): (f64, f64)| {
                format!("{} at the end, {} at its peak", unit(last, "N"), unit(peak, "N"))
            };
            let [sound, printed] = LAWS.map(|law| force_at_arrest(lab, law, &with(&[])));
            both(
                told(sound),
                told(printed),
                trend_verdict(sound.0 < 0.05 * sound.1),
                "equation 8.4 leaves A S_y at zero relative velocity; the scheme just stops there",
            )
        },
    },
    Claim {
        id: "8.3-end",
        place: "8.3",
        says: "depth is the projectile's travel less the plate's",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let [sound, printed] = LAWS.map(|law| lab.percent(law, &with(&[])));
            both(
                pc(sound),
                pc(printed),
                if sound < printed - 5.0 { Verdict::Corrected } else { Verdict::Reproduced },
                "text and Figure 8.14 subtract the plate's whole motion, the listing only its last increment",
            )
        },
    },
    Claim {
        id: "8.3.1-dishing",
        place: "8.3.1",
        says: "dishing takes up about one projectile diameter",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let mut stiff = listing_material(rigid_base());
            let with_it = lab.depth_m(Law::Printed, &stiff);
            stiff.target.dishing = false;
            let [sound, printed] = LAWS.map(|law| lab.depth_m(law, &stiff));
            both(
                format!("{} without", mm(sound)),
                format!("{} with, {} without", mm(with_it), mm(printed)),
                number_verdict(
                    near(with_it, BASELINE_M, 5e-3) && !near(printed, BASELINE_M, 5e-3),
                    false,
                ),
                "the stated baseline contains it; it is not in equation 8.12",
            )
        },
    },
    Claim {
        id: "8.3.1-factor",
        place: "8.3.1",
        says: "the static yield stress is scaled by 2",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let depth = lab.depth_m(Law::Sound, &changed(rigid_base(), &[("S_y", 2.0 * 75.8e6)]));
            both(
                format!("2 x 75.8 MPa: {}", mm(depth)),
                mm(lab.depth_m(Law::Printed, &listing_material(rigid_base()))),
                number_verdict(near(depth, BASELINE_M, 5e-3), false),
                "with the listing's 75.8 MPa it gives the baseline",
            )
        },
    },
    Claim {
        id: "8.3.1-rigid",
        place: "8.3.1",
        says: "the projectile does not deform",
        opens: Opens::Scene(rigid_base),
        check: |_| {
            let scene = rigid_base();
            let v = scene.projectile.velocity_m_s;
            let pressure = scene.flow_strength_pa() + scene.drag_kg_m3() * v * v;
            found(
                format!("the nose bears {}", unit(pressure, "Pa")),
                trend_verdict(pressure < 0.5e9),
                "half of what soft steel bears; against hard plates it would be another matter (cmra validate)",
            )
        },
    },
    Claim {
        id: "8.3.1-plastic",
        place: "8.3.1",
        says: "the target is rigid and perfectly plastic",
        opens: Opens::Scene(rigid_base),
        check: |_| {
            let mut other = changed(rigid_base(), &[("Y", 75.8e6), ("E", 73e9)]);
            other.target.closure = Closure::Cavity;
            (other.target.dishing, other.target.drag_coefficient) = (false, 1.0);
            found(
                format!(
                    "2 Y = 151.6 MPa with dishing: limit {}; cavity expansion, {} without: {}",
                    unit(limit_m_s(&rigid_base()), "m/s"),
                    unit(other.flow_strength_pa(), "Pa"),
                    unit(limit_m_s(&other), "m/s")
                ),
                Verdict::Unchecked,
                "2024-O hardens strongly, and no measurement on this plate is given: nothing decides between the two",
            )
        },
    },
    Claim {
        id: "8.3.1-friction",
        place: "8.3.1",
        says: "friction is minimally important",
        opens: Opens::Nothing,
        check: |_| {
            found(
                String::new(),
                Verdict::Unchecked,
                "it is in none of the models, and what [26] measured is not given",
            )
        },
    },
    Claim {
        id: "8.3.1-springs",
        place: "8.3.1",
        says: "real springs are not massless, and may weigh as much as the plates",
        opens: Opens::Scene(weighed),
        check: |lab| {
            let run = lab.run(Law::Sound, &weighed());
            let whole = run.mechanism.spring_mass_kg.unwrap_or(f64::NAN) / 0.0295;
            found(
                format!(
                    "a steel coil for this shot weighs {} plates of gamma = 1; counted, depth is {} instead of {}",
                    number(whole),
                    pc(lab.percent(Law::Sound, &weighed())),
                    pc(lab.percent(Law::Sound, &with(&[])))
                ),
                trend_verdict(whole > 1.0),
                "4 rho G U/tau^2 of wire for the energy it must store, a third of which moves with the plate; the thesis \
                 leaves it out all the same",
            )
        },
    },
    Claim {
        id: "8.2-mass",
        place: "Table 8.2",
        says: "the beam weighs 0.195 kg",
        opens: Opens::Preset("yang-xi"),
        check: |_| {
            let mass = 2600.0 * 0.025 * 0.01 * 0.3;
            found(
                format!("{} g", number(1e3 * mass)),
                number_verdict(near(mass, 0.195, 1e-3), false),
                "density times base, width and length",
            )
        },
    },
    Claim {
        id: "8.2-duration",
        place: "8.3.2, Table 8.2",
        says: "the impact is taken to last 2.714 ms, until the photograph of the separation",
        opens: Opens::Preset("yang-xi"),
        check: |lab| {
            let [sound, printed] = LAWS.map(|law| {
                lab.run(law, &yang_xi()).first_arrest.map_or(f64::NAN, |arrest| arrest.t_s)
            });
            both(
                format!(
                    "common speed after {}, with R, S_y and C_d of Table 9.1",
                    unit(sound, "s")
                ),
                unit(printed, "s"),
                Verdict::Unchecked,
                "an assumption about a photograph: the drag model has no duration to put in, and its own depends on R, S_y \
                 and C_d, which are not given",
            )
        },
    },
    Claim {
        id: "8.2-omitted",
        place: "Table 8.2",
        says: "these are the model's inputs",
        opens: Opens::Preset("yang-xi"),
        check: |lab| {
            let holds = |s| {
                lab.run(Law::Sound, &changed(yang_xi(), &[("S_y", s)])).outcome
                    != Outcome::Perforated
            };
            let (mut low, mut high) = (1e7, 2e8);
            for _ in 0..30 {
                let middle = 0.5 * (low + high);
                if holds(middle) { high = middle } else { low = middle }
            }
            found(
                format!(
                    "with R and C_d of Table 9.1 the beam is perforated below S_y = {}",
                    unit(high, "Pa")
                ),
                number_verdict(high < 1e7, false),
                "R, S_y, C_d and which of base and width is the thickness are missing, and decide even the outcome",
            )
        },
    },
    Claim {
        id: "8.17-distance",
        place: "8.3.2, Figure 8.17",
        says: "the beam moved about 14 % of its 300 mm: 42 mm",
        opens: Opens::Nothing,
        check: |_| {
            let read = 0.14 * 300.0;
            found(
                format!("{} mm", number(read)),
                number_verdict(near(read, 42.0, 1e-9), false),
                "arithmetic; read by eye from one photograph",
            )
        },
    },
    Claim {
        id: "8.18-distance",
        place: "8.3.2, Figure 8.18",
        says: "the model moves the beam 46.2 mm in 2.714 ms",
        opens: Opens::Preset("yang-xi"),
        check: |lab| {
            let [sound, printed] = LAWS.map(|law| moved_mm(lab, law, 1.52e8));
            let strengths = [1.8e8, 2.0e8, 2.2e8, 2.5e8, 3.0e8];
            let meant =
                strengths.into_iter().find(|s| near(moved_mm(lab, Law::Sound, *s), 46.2, 2e-3));
            let told =
                meant.map_or_else(String::new, |s| format!("; 46.2 mm at S_y = {}", unit(s, "Pa")));
            both(
                format!("{} mm at the S_y of Table 9.1{told}", number(sound)),
                format!("{} mm", number(printed)),
                number_verdict(near(sound, 46.2, 2e-3), meant.is_some()),
                "R, S_y and C_d are not given; a strength that is not stated reproduces it",
            )
        },
    },
    Claim {
        id: "8.3.2-separation",
        place: "8.3.2",
        says: "projectile and beam move together until they separate at 2.714 ms",
        opens: Opens::Preset("yang-xi"),
        check: |lab| {
            let common = lab
                .run(Law::Sound, &yang_xi())
                .first_arrest
                .map_or(f64::NAN, |arrest| arrest.plate_velocity_m_s);
            let seen = 42e-3 / 2.714e-3;
            found(
                format!(
                    "the model's common velocity {}, the photographs' mean {}",
                    unit(common, "m/s"),
                    unit(seen, "m/s")
                ),
                Verdict::Unchecked,
                "a free beam bends, so its middle is not its centre of mass, and bodies that separate were not inelastic",
            )
        },
    },
    Claim {
        id: "8.18-deviation",
        place: "8.3.2",
        says: "46.2 mm against 42 mm is 10 %",
        opens: Opens::Nothing,
        check: |_| {
            let off: f64 = 46.2 / 42.0 - 1.0;
            found(pc(100.0 * off), number_verdict((off - 0.1).abs() < 5e-3, false), "arithmetic")
        },
    },
    Claim {
        id: "8.18-validates",
        place: "8.3.2",
        says: "the agreement validates the model",
        opens: Opens::Preset("yang-xi"),
        check: |lab| {
            let strengths = [1e8, 1.516e8, 3e8, 1e9, 1e11];
            let moved = strengths.map(|s| moved_mm(lab, Law::Sound, s));
            let momentum = 0.034 * 118.2 / (0.034 + 0.195) * 2.714;
            both(
                format!(
                    "{} mm at 100 MPa, {} mm at 100 GPa; momentum alone {} mm",
                    number(moved[0]),
                    number(moved[4]),
                    number(momentum)
                ),
                format!("{} mm at 151.6 MPa", number(moved_mm(lab, Law::Printed, 1.516e8))),
                Verdict::Unchecked,
                "any strength that is not perforated gives nearly the same: the test cannot fail, and tests no depth",
            )
        },
    },
    Claim {
        id: "8.3.2-indefinitely",
        place: "8.3.2",
        says: "without spring and damper the plate goes on for ever at constant velocity",
        opens: Opens::Scene(free),
        check: |lab| {
            let run = lab.run_with(Law::Sound, &changed(free(), &[("horizon", 5e-3)]), true);
            let end_s = run.first_arrest.map_or(f64::NAN, |arrest| arrest.t_s);
            let after = run.series.iter().filter(|row| row.t_s > end_s);
            let constant = after.clone().count() > 0
                && after.clone().all(|row| near(row.plate_velocity_m_s, 50.0, 1e-9));
            found(
                "50 m/s to the end; no greatest displacement exists".to_owned(),
                number_verdict(constant && run.max_plate_displacement_m.is_none(), false),
                "nothing acts on it",
            )
        },
    },
];
