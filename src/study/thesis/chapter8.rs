//! Claims of chapter 8: the models of section 8.2, the evaluation model, and its validation.

use crate::model::run::{Outcome, Run, Sample};
use crate::model::scene::{ContactModel, Scene};
use crate::numerics::larger;
use crate::study::thesis::lab::{
    BASELINE_M, LAWS, Lab, Law, changed, listing_material, misprint_verdict, mm, near, number,
    number_verdict, pc, rigid, trend_verdict, unit, with,
};
use crate::study::thesis::{Claim, Found, Opens, Verdict};

const DURATION_S: f64 = 150e-6;

fn rigid_base() -> Scene {
    rigid(with(&[]))
}

fn free() -> Scene {
    with(&[("k", 0.0)])
}

fn half_sine() -> Scene {
    let mut scene = free();
    scene.contact.model = ContactModel::HalfSine;
    scene.contact.duration_s = Some(DURATION_S);
    scene
}

fn at_once() -> Scene {
    let mut scene = with(&[]);
    scene.contact.model = ContactModel::InitialVelocity;
    scene
}

fn thin() -> Scene {
    changed(with(&[("v_i", 300.0)]), &[("h", 0.003)])
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

fn impulse(run: &Run, until_s: f64) -> f64 {
    let part = |pair: &[Sample]| {
        0.5 * (pair[0].contact_force_n + pair[1].contact_force_n) * (pair[1].t_s - pair[0].t_s)
    };
    run.series.windows(2).take_while(|pair| pair[1].t_s <= until_s * (1.0 + 1e-9)).map(part).sum()
}

/// The last contact force before the first arrest, and the greatest, N.
fn force_at_arrest(lab: &Lab, law: Law, scene: &Scene) -> (f64, f64) {
    let run = lab.run_with(law, scene, true);
    let end_s = run.first_arrest.map_or(f64::INFINITY, |arrest| arrest.t_s);
    let mut contact = run.series.iter().filter(|row| row.t_s < end_s * (1.0 - 1e-9));
    let last = contact.next_back().map_or(f64::NAN, |row| row.contact_force_n);
    (last, run.peak_contact_force_n.unwrap_or(f64::NAN))
}

/// The greatest distance between the rigid mount's force history and a half-sine of the same peak and duration.
fn off_half_sine(lab: &Lab, law: Law) -> f64 {
    let run = lab.run_with(law, &rigid_base(), true);
    let end_s = run.first_arrest.map_or(f64::NAN, |arrest| arrest.t_s);
    let peak = run.peak_contact_force_n.unwrap_or(f64::NAN);
    let contact = run.series.iter().filter(|row| row.t_s < end_s * (1.0 - 1e-9));
    contact
        .map(|row| {
            let sine = (std::f64::consts::PI * row.t_s / end_s).sin();
            (row.contact_force_n / peak - sine).abs()
        })
        .fold(0.0, larger)
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "8.5-sign",
        place: "8.2.3, eq. 8.5",
        says: "the impact force is m dv/dt",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let run = lab.run_with(Law::Sound, &rigid_base(), true);
            let pair = run.series.windows(2).find(|pair| pair[0].contact_force_n > 1e3);
            let product = pair.map_or(f64::NAN, |pair| {
                let change = pair[1].projectile_velocity_m_s - pair[0].projectile_velocity_m_s;
                0.0295 * change
                    / (pair[1].t_s - pair[0].t_s)
                    / (0.5 * (pair[0].contact_force_n + pair[1].contact_force_n))
            });
            Found {
                sound: format!("m dv/dt over F along the run: {}", number(product)),
                printed: String::new(),
                verdict: misprint_verdict(near(product, 1.0, 0.05), near(product, -1.0, 0.05)),
                cause: "the sign is wrong for a deceleration; 8.6 goes on with the size",
            }
        },
    },
    Claim {
        id: "8.6-impulse",
        place: "8.2.3, eq. 8.6 and 8.9",
        says: "the half-sine's impulse is the projectile's momentum",
        opens: Opens::Scene(half_sine),
        check: |lab| {
            let run = lab.run_with(Law::Sound, &half_sine(), true);
            let found = impulse(&run, DURATION_S);
            Found {
                sound: format!("{} N s of m v = 2.95 N s", number(found)),
                printed: String::new(),
                verdict: number_verdict(near(found, 0.0295 * 100.0, 1e-3), false),
                cause: "summed over the run's own force history",
            }
        },
    },
    Claim {
        id: "8.8-amplitude",
        place: "8.2.3, eq. 8.8",
        says: "the half-sine's peak is m V pi/(2 t_d)",
        opens: Opens::Scene(half_sine),
        check: |lab| {
            let peak = lab.run(Law::Sound, &half_sine()).peak_contact_force_n.unwrap_or(f64::NAN);
            let stated = 0.0295 * 100.0 * std::f64::consts::PI / (2.0 * DURATION_S);
            Found {
                sound: format!("{} for t_d = 150 us", unit(peak, "N")),
                printed: String::new(),
                verdict: number_verdict(near(peak, stated, 1e-9), false),
                cause: "the amplitude that makes the impulse m V",
            }
        },
    },
    Claim {
        id: "8.10-shape",
        place: "8.2.3, Figure 8.10",
        says: "the force history of penetration is roughly a half-sine",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let [sound, printed] = LAWS.map(|law| off_half_sine(lab, law));
            Found {
                sound: format!("off by up to {} of the peak", pc(100.0 * sound)),
                printed: format!("off by up to {} of the peak", pc(100.0 * printed)),
                verdict: trend_verdict(sound < 0.25),
                cause: "the thesis's own law ends at A S_y, its full strength, not at zero: a ramp and a cliff",
            }
        },
    },
    Claim {
        id: "8.11-speed",
        place: "8.2.4, eq. 8.11",
        says: "projectile and plate set out at m_A v/(m_A + m_B)",
        opens: Opens::Scene(at_once),
        check: |lab| {
            let run = lab.run_with(Law::Sound, &at_once(), true);
            let start = run.series.first().map_or(f64::NAN, |row| row.plate_velocity_m_s);
            Found {
                sound: unit(start, "m/s"),
                printed: String::new(),
                verdict: number_verdict(near(start, 50.0, 1e-12), false),
                cause: "momentum; gamma = 1",
            }
        },
    },
    Claim {
        id: "8.1-perforation",
        place: "Table 8.1",
        says: "the simpler models assume that nothing is perforated, the drag model does not",
        opens: Opens::Scene(thin),
        check: |lab| {
            let outcome = |model| {
                let mut scene = thin();
                scene.contact.model = model;
                lab.run(Law::Sound, &scene).outcome
            };
            let simple =
                [ContactModel::HalfSine, ContactModel::InitialVelocity, ContactModel::Lumped];
            let drag = outcome(ContactModel::Hydrodynamic) == Outcome::Perforated;
            let blind = simple.into_iter().all(|model| outcome(model) != Outcome::Perforated);
            Found {
                sound: "3 mm at 300 m/s: perforated by the drag model alone".to_owned(),
                printed: lab.run(Law::Printed, &thin()).outcome.word().to_owned(),
                verdict: trend_verdict(drag && blind),
                cause: "they know no rear face",
            }
        },
    },
    Claim {
        id: "8.3-initial-velocity",
        place: "8.3",
        says: "the initial velocity model is inaccurate",
        opens: Opens::Scene(at_once),
        check: |lab| {
            let own = lab.travel_mm(Law::Sound, &at_once());
            let reference = lab.travel_mm(Law::Sound, &with(&[]));
            let off = (own / reference - 1.0).abs();
            Found {
                sound: format!(
                    "plate travel {} mm, drag model {} mm",
                    number(own),
                    number(reference)
                ),
                printed: format!("{} mm", number(lab.travel_mm(Law::Printed, &with(&[])))),
                verdict: trend_verdict(off > 0.01),
                cause: "for the plate's travel, which is all it gives, it is off by a tenth of a percent",
            }
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
            Found {
                sound: told(sound),
                printed: told(printed),
                verdict: trend_verdict(sound.0 < 0.05 * sound.1),
                cause: "equation 8.4 leaves A S_y at zero relative velocity; the scheme just stops there",
            }
        },
    },
    Claim {
        id: "8.3-end",
        place: "8.3",
        says: "depth is the projectile's travel less the plate's",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let [sound, printed] = LAWS.map(|law| lab.percent(law, &with(&[])));
            Found {
                sound: pc(sound),
                printed: pc(printed),
                verdict: if sound < printed - 5.0 {
                    Verdict::Corrected
                } else {
                    Verdict::Reproduced
                },
                cause: "text and Figure 8.14 subtract the plate's whole motion, the listing only its last increment",
            }
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
            Found {
                sound: format!("{} without", mm(sound)),
                printed: format!("{} with, {} without", mm(with_it), mm(printed)),
                verdict: number_verdict(
                    near(with_it, BASELINE_M, 5e-3) && !near(printed, BASELINE_M, 5e-3),
                    false,
                ),
                cause: "the stated baseline contains it; it is not in equation 8.12",
            }
        },
    },
    Claim {
        id: "8.3.1-factor",
        place: "8.3.1",
        says: "the static yield stress is scaled by 2",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let depth = lab.depth_m(Law::Sound, &changed(rigid_base(), &[("S_y", 2.0 * 75.8e6)]));
            Found {
                sound: format!("2 x 75.8 MPa: {}", mm(depth)),
                printed: mm(lab.depth_m(Law::Printed, &listing_material(rigid_base()))),
                verdict: number_verdict(near(depth, BASELINE_M, 5e-3), false),
                cause: "with the listing's 75.8 MPa it gives the baseline",
            }
        },
    },
    Claim {
        id: "8.2-mass",
        place: "Table 8.2",
        says: "the beam weighs 0.195 kg",
        opens: Opens::Preset("yang-xi"),
        check: |_| {
            let mass = 2600.0 * 0.025 * 0.01 * 0.3;
            Found {
                sound: format!("{} g", number(1e3 * mass)),
                printed: String::new(),
                verdict: number_verdict(near(mass, 0.195, 1e-3), false),
                cause: "density times base, width and length",
            }
        },
    },
    Claim {
        id: "8.2-duration",
        place: "Table 8.2",
        says: "the impact lasts 2.714 ms, an input of the model",
        opens: Opens::Preset("yang-xi"),
        check: |lab| {
            let [sound, printed] = LAWS.map(|law| {
                lab.run(law, &yang_xi()).first_arrest.map_or(f64::NAN, |arrest| arrest.t_s)
            });
            Found {
                sound: format!("common speed after {}", unit(sound, "s")),
                printed: unit(printed, "s"),
                verdict: misprint_verdict(near(sound, 2.714e-3, 0.2), sound < 2.714e-3),
                cause: "it is when the photographs show separation; the drag model has no such input",
            }
        },
    },
    Claim {
        id: "8.17-distance",
        place: "8.3.2, Figure 8.17",
        says: "the beam moved about 14 % of its 300 mm: 42 mm",
        opens: Opens::Nothing,
        check: |_| {
            let read = 0.14 * 300.0;
            Found {
                sound: format!("{} mm", number(read)),
                printed: String::new(),
                verdict: number_verdict(near(read, 42.0, 1e-9), false),
                cause: "arithmetic; read by eye from one photograph",
            }
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
            Found {
                sound: format!("{} mm at the S_y of Table 9.1{told}", number(sound)),
                printed: format!("{} mm", number(printed)),
                verdict: number_verdict(near(sound, 46.2, 2e-3), meant.is_some()),
                cause: "R, S_y and C_d are not given; a strength that is not stated reproduces it",
            }
        },
    },
    Claim {
        id: "8.18-deviation",
        place: "8.3.2",
        says: "46.2 mm against 42 mm is 10 %",
        opens: Opens::Nothing,
        check: |_| {
            let off: f64 = 46.2 / 42.0 - 1.0;
            Found {
                sound: pc(100.0 * off),
                printed: String::new(),
                verdict: number_verdict((off - 0.1).abs() < 5e-3, false),
                cause: "arithmetic",
            }
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
            Found {
                sound: format!(
                    "{} mm at 100 MPa, {} mm at 100 GPa; momentum alone {} mm",
                    number(moved[0]),
                    number(moved[4]),
                    number(momentum)
                ),
                printed: format!(
                    "{} mm at 151.6 MPa",
                    number(moved_mm(lab, Law::Printed, 1.516e8))
                ),
                verdict: Verdict::Unchecked,
                cause: "any strength that is not perforated gives nearly the same: the test cannot fail, and tests no depth",
            }
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
            Found {
                sound: "50 m/s to the end; no greatest displacement exists".to_owned(),
                printed: String::new(),
                verdict: number_verdict(constant && run.max_plate_displacement_m.is_none(), false),
                cause: "nothing acts on it",
            }
        },
    },
];
