//! Claims of sections 9.1 to 9.3: Tables 9.1 and 9.2, and the baseline.

use crate::model::mechanism::PowerLaw;
use crate::model::run::Outcome;
use crate::model::scene::Scene;
use crate::study::limit;
use crate::study::thesis::lab::{
    BASELINE_M, Lab, Law, both, changed, found, limit_m_s, listing_material, misprint_verdict, mm,
    near, number, number_verdict, pc, rigid, spelled, trend_verdict, unit, with,
};
use crate::study::thesis::{Basis, Claim, Found, Opens, Verdict};

fn rigid_base() -> Scene {
    rigid(with(&[]))
}

fn misprinted() -> Scene {
    changed(rigid_base(), &[("S_y", 1.52e7)])
}

/// A spring whose exponent is not 1, with x in metres.
fn in_metres() -> Scene {
    with(&[("k", 1e6), ("n", 0.5)])
}

/// The same stiffness at n = 1, with x in millimetres.
fn in_millimetres() -> Scene {
    changed(spelled(&[("spring", "normalised")]), &[("F_ref", 1e3), ("x_ref", 1e-3), ("n", 0.5)])
}

/// The listing on a rigid mount, by its own scheme with a step.
fn stepped(rho: f64, step_s: f64) -> Scene {
    let mut scene = changed(listing_material(rigid_base()), &[("rho", rho)]);
    scene.contact.appendix.step_s = step_s;
    scene
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "9.1-strength",
        place: "Table 9.1, S_y",
        says: "the dynamic strength is 1.52e7 Pa",
        opens: Opens::Scene(misprinted),
        check: |lab| {
            let as_printed = lab.run(Law::Sound, &misprinted());
            let meant = lab.depth_m(Law::Sound, &rigid_base());
            let free = with(&[("S_y", 1.52e7), ("k", 0.0)]);
            both(
                format!(
                    "1.52e7 Pa: {} on the rigid mount (limit {}), held by a free plate of gamma = 1 (limit {}); 1.52e8 Pa: {} \
                     on the rigid mount",
                    as_printed.outcome.word(),
                    unit(limit_m_s(&misprinted()), "m/s"),
                    limit::closed_form(&free)
                        .map_or_else(|| "unknown".to_owned(), |limit| unit(limit, "m/s")),
                    mm(meant)
                ),
                format!(
                    "{} on the rigid mount",
                    lab.run(Law::Printed, &misprinted()).outcome.word()
                ),
                misprint_verdict(
                    as_printed.outcome != Outcome::Perforated,
                    near(meant, BASELINE_M, 5e-3),
                ),
                "a power of ten is lost: the Appendix has 2 x 75.8e6, and only that stops the shot on the baseline's rigid mount",
            )
        },
    },
    Claim {
        id: "9.1-density",
        place: "Table 9.1, rho",
        says: "the density is 2710 kg/m3 (the Appendix has 2780)",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let depth = |rho| lab.depth_m(Law::Sound, &changed(rigid_base(), &[("rho", rho)]));
            let (table, listing) = (depth(2710.0), depth(2780.0));
            both(
                format!("{} and {}", mm(table), mm(listing)),
                format!(
                    "{} and {}",
                    mm(lab.depth_m(Law::Printed, &stepped(2710.0, 1e-6))),
                    mm(lab.depth_m(Law::Printed, &stepped(2780.0, 1e-6)))
                ),
                number_verdict(
                    near(table, BASELINE_M, 5e-3) && near(listing, BASELINE_M, 5e-3),
                    false,
                ),
                "0.04 % of the baseline lies between them: both reproduce it",
            )
        },
    },
    Claim {
        id: "9.1-drag",
        place: "Table 9.1, C_d",
        says: "the drag coefficient of 2024-O is 0.5",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let depths = [0.0, 0.5, 1.0]
                .map(|c| lab.depth_m(Law::Sound, &changed(rigid_base(), &[("C_d", c)])));
            let share = 0.25 * 2710.0 * 1e4 / 1.52e8;
            found(
                format!(
                    "{}, {}, {} with C_d = 0, 0.5, 1; at 100 m/s the drag is {} of S_y",
                    mm(depths[0]),
                    mm(depths[1]),
                    mm(depths[2]),
                    pc(100.0 * share)
                ),
                Verdict::Unchecked,
                "8.2.3 has it as Virostek's assumption; at this velocity no measurement could tell 0 from 1",
            )
        },
    },
    Claim {
        id: "9.2.2-preload",
        place: "9.2.2, Table 9.2",
        says: "the cocking distance goes up to 0.5 m",
        opens: Opens::Preset("cocked"),
        check: |_| {
            let spring = PowerLaw { coefficient: 1e5, exponent: 1.0 };
            let (force, energy) = (spring.force(0.5), spring.integral(0.5));
            let speed = (2.0 * energy / 0.059).sqrt();
            found(
                format!(
                    "{} and {} are latched, {} times the shot's energy; let go they throw plate and shot at {}",
                    unit(force, "N"),
                    unit(energy, "J"),
                    number(energy / 147.5),
                    unit(speed, "m/s")
                ),
                Verdict::Unchecked,
                "the range is free to choose; latch, trigger and what comes back are not in the thesis",
            )
        },
    },
    Claim {
        id: "9.2.2-damper",
        place: "9.2.2",
        says: "b up to 2000 N s/m covers some common automotive dampers",
        opens: Opens::Nothing,
        check: |_| found(String::new(), Verdict::Unchecked, "none is named, and no value given"),
    },
    Claim {
        id: "9.2-k-limit",
        place: "Table 9.2 against 9.2.2",
        says: "k up to 7.5 MN/m (table), up to 10 MN/m (text)",
        opens: Opens::Preset("figure-9.5"),
        check: |lab| {
            let at = |law, k| lab.percent(law, &with(&[("k", k)]));
            let told =
                |law| format!("{} at 7.5, {} at 10 MN/m", pc(at(law, 7.5e6)), pc(at(law, 1e7)));
            Found {
                basis: Basis::Read,
                ..both(
                    told(Law::Sound),
                    told(Law::Printed),
                    Verdict::Misprint,
                    "text and table disagree; the results hardly do",
                )
            }
        },
    },
    Claim {
        id: "9.2-unit",
        place: "Table 9.2, eq. 9.3",
        says: "k is in MN/m for every exponent",
        opens: Opens::Scene(in_metres),
        check: |lab| {
            let metres = lab.percent(Law::Sound, &in_metres());
            // The same number with x counted in millimetres: F = k (x/1 mm)^n N, scaled to equal force at n = 1.
            let millimetres = lab.percent(Law::Sound, &in_millimetres());
            found(
                format!(
                    "k = 1e6, n = 0.5: {} with x in metres, {} with x in millimetres",
                    pc(metres),
                    pc(millimetres)
                ),
                misprint_verdict(near(metres, millimetres, 1e-3), metres > millimetres),
                "for n other than 1 it is N/m^n, and what a number means hangs on the unit of length (F_ref and x_ref do not)",
            )
        },
    },
    Claim {
        id: "9.2.2-gamma",
        place: "9.2.2",
        says: "the plate's mass matters when it is near the projectile's",
        opens: Opens::Preset("figure-9.2"),
        check: |lab| {
            let at = |law, gamma| lab.percent(law, &with(&[("gamma", gamma)]));
            let told = |law| {
                let shares = [1.0, 7.0, 50.0].map(|gamma| pc(at(law, gamma)));
                format!("{} at gamma = 1, {} at 7, {} at 50", shares[0], shares[1], shares[2])
            };
            both(
                told(Law::Sound),
                told(Law::Printed),
                trend_verdict(at(Law::Sound, 1.0) < 75.0 && at(Law::Sound, 50.0) > 95.0),
                "a plate much heavier than the projectile stands still during the contact",
            )
        },
    },
    Claim {
        id: "9.3-baseline",
        place: "9.3",
        says: "rigidly mounted, the shot penetrates 7.129 mm",
        opens: Opens::Preset("rigid-mount"),
        check: |lab| {
            let exact = lab.depth_m(Law::Sound, &stepped(2710.0, 1e-6));
            let table = lab.depth_m(Law::Sound, &rigid_base());
            let coarse = lab.depth_m(Law::Printed, &stepped(2710.0, 1e-6));
            let fine = lab.depth_m(Law::Printed, &stepped(2780.0, 2e-7));
            let digits = 5e-4 / 7.129;
            both(
                format!("{} (1.516e8 Pa), {} (1.52e8 Pa)", mm(exact), mm(table)),
                format!("{} with dt = 1e-6 s, {} with 2e-7 s", mm(coarse), mm(fine)),
                number_verdict(
                    near(exact, BASELINE_M, digits),
                    near(fine, BASELINE_M, digits) && near(exact, BASELINE_M, 1e-3),
                ),
                "its last digits are the time step's: first order, and not the listing's own 1e-6 s",
            )
        },
    },
    Claim {
        id: "9.3-thick",
        place: "9.3",
        says: "the plate is thick enough to stop the shot even on a rigid mount",
        opens: Opens::Preset("rigid-mount"),
        check: |lab| {
            let limit = limit_m_s(&rigid_base());
            let depth = lab.depth_m(Law::Sound, &rigid_base());
            let thin =
                [0.003, 0.0028, 0.0026].map(|h| limit_m_s(&changed(rigid_base(), &[("h", h)])));
            both(
                format!(
                    "ballistic limit {}; 2.8 mm of plate would have {}",
                    unit(limit, "m/s"),
                    unit(thin[1], "m/s")
                ),
                lab.run(Law::Printed, &rigid_base()).outcome.word().to_owned(),
                trend_verdict(limit > 100.0 && depth.is_finite()),
                "by the thesis's own law it is about nine times thicker than needed",
            )
        },
    },
    Claim {
        id: "9.3-during",
        place: "9.3",
        says: "the second measure is the plate's greatest travel, until spring and damper stop it",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let run = lab.run(Law::Sound, &with(&[]));
            let arrest = run.first_arrest;
            let travel = arrest.map_or(f64::NAN, |arrest| 1e3 * arrest.plate_displacement_m);
            let speed = arrest.map_or(f64::NAN, |arrest| arrest.plate_velocity_m_s);
            let most = run.max_plate_displacement_m.map_or(f64::NAN, |x| 1e3 * x);
            found(
                format!(
                    "{} mm and {} at first arrest; stopped at {} mm",
                    number(travel),
                    unit(speed, "m/s"),
                    number(most)
                ),
                trend_verdict(speed > 1.0 && most > 2.0 * travel),
                "its \"impact\" includes the oscillation after the contact: only then is the plate stopped",
            )
        },
    },
    Claim {
        id: "9.3-general",
        place: "9.3",
        says: "the values are of one impact, the trends are general",
        opens: Opens::Preset("figure-9.2"),
        check: |lab| {
            let shares = [50.0, 100.0, 200.0].map(|v| {
                [0.8, 2.0, 7.0]
                    .map(|gamma| lab.percent(Law::Sound, &with(&[("v_i", v), ("gamma", gamma)])))
            });
            let told = shares.each_ref().map(|share| share.map(pc).join(" "));
            found(
                format!(
                    "gamma = 0.8, 2, 7 at 50 m/s: {}; 100: {}; 200: {}",
                    told[0], told[1], told[2]
                ),
                trend_verdict(shares.iter().all(|share| super::spread::rising(share))),
                "for the mass ratio, below the ballistic limit",
            )
        },
    },
    Claim {
        id: "9.3-maximum",
        place: "9.3",
        says: "no mount lets the shot go deeper than the rigid one",
        opens: Opens::Preset("figure-9.7"),
        check: |lab| {
            let worst = |law| worst_percent(lab, law);
            let [sound, printed] = [worst(Law::Sound), worst(Law::Printed)];
            both(
                format!("at most {} over 72 designs of Table 9.2", pc(sound)),
                format!("at most {}", pc(printed)),
                trend_verdict(sound <= 100.0 + 1e-6),
                "up to the first arrest; what happens after it is another matter (9.5.1)",
            )
        },
    },
];

/// The greatest share of the baseline over a grid of Table 9.2.
fn worst_percent(lab: &Lab, law: Law) -> f64 {
    let mut worst = 0.0;
    for gamma in [0.8, 2.0, 7.0] {
        for (k, n) in [(0.0, 1.0), (1e5, 0.5), (1e5, 3.0), (1e6, 1.0), (7.5e6, 1.0), (7.5e6, 0.3)] {
            for (d, b) in [(0.0, 0.0), (0.0, 2000.0), (0.1, 0.0), (0.5, 200.0)] {
                let changes = [("gamma", gamma), ("k", k), ("n", n), ("d", d), ("b", b)];
                let percent = lab.percent(law, &with(&changes));
                // The printed scheme breaks off on the most violent designs.
                worst = if percent > worst { percent } else { worst };
            }
        }
    }
    worst
}
