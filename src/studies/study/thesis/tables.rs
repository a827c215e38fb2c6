//! Claims of the tables, the baseline, the spring and the beam of section 9.5, and the listing of Appendix A.

use std::collections::HashSet;

use super::ClaimVerdict::{Corrected, Misprint, NotReproduced, Reproduced};
use super::{Check, Claim, Shots, claim, four, list, millimetres, near};
use crate::study::limit;
use crate::study::principles::{CONCEPTS, CRITERIA, Concept, PRINCIPLES};
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::run::{EventKind, Run, Sample};
use cmra_engine::model::scene::{Beam, Listing, Wire};
use cmra_engine::model::units::engineering;

/// Material of the listing.
const LISTED: &str = "rho=2780 S_y=151.6e6";
/// Input values of the listing; the plate weighs 0.1 kg.
const CASE: &str = "rho=2780 S_y=151.6e6 gamma=3.3898305084745766 k=0 n=3 m=3";
/// Values of Table 8.2; values of the impact that it omits are those of Table 9.1.
const YANG_XI: &str =
    "m_p=0.034 v_i=118.2 gamma=5.735294117647059 h=0.01 rho=2600 k=0 horizon=2.714e-3";

pub(super) const CLAIMS: &[Claim] = &[
    claim(
        ("5.1-principles", "Tables 4.1 and 5.1", Reproduced, None),
        "three families of seven principles, served by four functions",
        "read from the text; nothing of it is computed",
        |_| {
            let families: HashSet<_> = PRINCIPLES.iter().map(|it| it.family).collect();
            let functions: HashSet<_> = PRINCIPLES.iter().flat_map(|it| it.functions).collect();
            let counts = [families.len(), PRINCIPLES.len(), functions.len()];
            let [families, principles, functions] = counts;
            let text = format!(
                "read from the text: {families} families, {principles} principles, {functions} functions"
            );
            Check { text, holds: counts == [3, 7, 4] }
        },
    ),
    claim(
        ("7.1-totals", "Table 7.1", Reproduced, Some("concept-cocked-cantilever")),
        "eight weighted totals from 2.02 to 3.78, the cocked cantilever's first",
        "ratings times weights; ease of analysis alone has 35 % of the weight, plate acceleration 3 %",
        |_| {
            let totals = CONCEPTS.map(|it| it.weighted());
            let rank = |own: f64| 1 + totals.iter().filter(|other| **other > own + 1e-9).count();
            let as_printed = |(it, total): (&Concept, f64)| {
                (total - it.total).abs() < 5e-3 && rank(total) == it.rank
            };
            let whole: f64 = CRITERIA.iter().map(|(_, weight)| weight).sum();
            let holds = near(whole, 100.0, 1e-12) && CONCEPTS.iter().zip(totals).all(as_printed);
            Check { text: list(&totals, "in the table's order"), holds }
        },
    ),
    claim(
        ("4.4.1-duration", "4.4.1, eq. 4.1", Corrected, Some("thesis-baseline")),
        "a softer mount reduces penetration: the projectile takes longer to stop completely",
        "the time to a full stop is longer; the contact itself is shorter, since less velocity is lost in it",
        |shots| {
            let contact_s = |run: &Run| run.first_arrest.map_or(f64::NAN, |it| it.t_s);
            let rigid_s = contact_s(&shots.run("mount=rigid"));
            let sprung = shots.run_with_series("");
            let (common_s, rest_s) = (contact_s(&sprung), turns_at_s(&sprung));
            let [rigid, common, rest] =
                [rigid_s, common_s, rest_s].map(|t_s| engineering(t_s, "s", 4));
            let text = format!(
                "rigid mount: at rest after {rigid}; k = 1e5: common velocity after {common}, at rest after {rest}"
            );
            Check { text, holds: rest_s > rigid_s && common_s < rigid_s }
        },
    ),
    claim(
        ("8.2-mass", "Table 8.2", Reproduced, Some("yang-xi")),
        "the beam weighs 0.195 kg",
        "density times base, width and length",
        |_| {
            let mass_kg = 2600.0 * 0.025 * 0.01 * 0.3;
            Check { text: list(&[mass_kg], "kg"), holds: near(mass_kg, 0.195, 1e-3) }
        },
    ),
    claim(
        ("8.18-distance", "8.3.2, Figure 8.18", Corrected, Some("yang-xi")),
        "the model moves the beam 46.2 mm in 2.714 ms; the photographs show 42 mm",
        "R, S_y and C_d are not given, and hardly matter: momentum alone gives 47.6 mm, so the test says nothing of depth",
        |shots| {
            let moved = |strength: &str| {
                let run = shots.run_with_series(&format!("{YANG_XI} {strength}"));
                1e3 * run.series.last().map_or(f64::NAN, |row| row.plate_displacement_m)
            };
            let (stated, stronger) = (moved(""), moved("S_y=3e8"));
            let text = list(&[stated, stronger], "mm with S_y = 152 and 300 MPa");
            Check { text, holds: near(stated, 46.2, 0.02) && near(stronger, 46.2, 2e-3) }
        },
    ),
    claim(
        ("9.1-strength", "Table 9.1, S_y", Misprint, Some("rigid-mount")),
        "the dynamic strength is 1.52e7 Pa",
        "a power of ten is missing: the Appendix has 2 x 75.8e6, and only that stops the shot on a rigid mount",
        |shots| {
            let [printed, meant] =
                ["1.52e7", "1.52e8"].map(|it| shots.depth_m(&format!("mount=rigid S_y={it}")));
            let limit = limit::closed_form(&shots.scene("mount=rigid S_y=1.52e7"));
            let limit = limit.map_or(String::new(), |it| format!(" (limit {} m/s)", four(it)));
            let holds = printed.is_infinite() && near(meant, 7.129e-3, 5e-3);
            let [printed, meant] = [printed, meant].map(millimetres);
            let text = format!("rigid mount: {printed} at 1.52e7 Pa{limit}, {meant} at 1.52e8");
            Check { text, holds }
        },
    ),
    claim(
        ("9.1-density", "Table 9.1, rho", Reproduced, Some("rigid-mount")),
        "the density is 2710 kg/m3; the Appendix has 2780",
        "0.04 % of the baseline lies between them",
        |shots| {
            let depths = [2710, 2780]
                .map(|rho| shots.depth_m(&format!("mount=rigid S_y=151.6e6 rho={rho}")));
            let text = depths.map(millimetres).join(" and ");
            Check { text, holds: depths.iter().all(|depth| near(*depth, 7.129e-3, 5e-3)) }
        },
    ),
    claim(
        ("9.2-k-limit", "Table 9.2 and 9.2.2", Misprint, Some("figure-9.5")),
        "k is searched up to 7.5 MN/m (table) or 10 MN/m (text)",
        "text and table disagree; depth differs by 3 % of that on a rigid mount",
        |shots| {
            let depths = ["7.5e6", "1e7"].map(|k| shots.percent(&format!("k={k}")));
            let text = list(&depths, "% of the depth on a rigid mount");
            Check { text, holds: near(depths[0], depths[1], 0.05) }
        },
    ),
    claim(
        ("9.3-baseline", "9.3", Corrected, Some("rigid-mount")),
        "rigidly mounted, the shot penetrates 7.129 mm",
        "the exact depth plus an error of the time step, which is not the listing's 1e-6 s",
        |shots| {
            let listed = format!("{LISTED} mount=rigid");
            let step = |step_s| shots.by(Listing { step_s, ..Listing::default() }).depth_m(&listed);
            let (fine, exact) = (step(2e-7), shots.depth_m("mount=rigid S_y=151.6e6"));
            let holds = near(exact, 7.126e-3, 1e-5) && near(fine, 7.129e-3, 5e-5);
            let [exact, fine] = [exact, fine].map(millimetres);
            let text = if shots.listing.is_some() {
                format!("{exact} with dt = 1e-6 s, {fine} with 2e-7 s")
            } else {
                let table = millimetres(shots.depth_m("mount=rigid"));
                format!("{exact} (1.516e8 Pa), {table} (1.52e8 Pa)")
            };
            Check { text, holds }
        },
    ),
    claim(
        ("9.5.1-mass", "9.5.1", Corrected, Some("cocked")),
        "steel coil springs of these stiffnesses weigh more than 25 projectiles, mostly",
        "the mass goes with the stored energy, not with the stiffness: a mass ratio near one is out of reach",
        |_| {
            // After the contact projectile and plate move together at half the impact velocity.
            let motion_j = 0.5 * (2.0 * 0.0295) * 50.0 * 50.0;
            let coils = |d_m: f64| {
                let energy_j = motion_j + 0.5 * 1e5 * d_m * d_m;
                energy_j / Wire::default().specific_energy_j_kg() / 0.0295
            };
            let (uncocked, cocked) = (coils(0.0), coils(0.5));
            let [low, high] = [uncocked, cocked].map(four);
            let text = format!(
                "gamma = 1: at least {low} projectiles uncocked, {high} at d = 0.5 m with k = 1e5"
            );
            Check { text, holds: uncocked < 25.0 && cocked > 25.0 }
        },
    ),
    claim(
        ("9.5.1-stop", "9.5.1, 9.6", NotReproduced, Some("stop")),
        "a stop that is hit after common velocity carries no danger of further penetration",
        "the projectile keeps the common velocity when the plate is stopped: by the same law penetration resumes",
        |shots| {
            if shots.listing.is_some() {
                return Check { text: "the listing has no stop".to_owned(), holds: false };
            }
            let run = shots.run("k=0 x_stop=0.01 interface=plastic");
            let first = run.first_arrest.map_or(f64::NAN, |it| it.penetration_m);
            let last = run.penetration.final_m.unwrap_or(f64::NAN);
            let rigid = shots.depth_m("mount=rigid");
            let [first, last] = [first, last].map(|depth| 100.0 * depth / rigid);
            let text = format!("{} % at the first stop, {} % in the end", four(first), four(last));
            Check { text, holds: last > first + 10.0 }
        },
    ),
    claim(
        ("9.3-torsion", "Table 9.3, K", Reproduced, Some("concept-cocked-cantilever")),
        "the torsional spring constant is 7200 N/rad",
        "gamma K_Theta E I/l, in N m/rad",
        |_| {
            let stiffness = Beam::default().torsional_n_m();
            Check { text: list(&[stiffness], "N m/rad"), holds: near(stiffness, 7200.0, 2e-3) }
        },
    ),
    claim(
        ("9.14-stiffness", "9.5.2, Figure 9.14(a)", Corrected, Some("concept-cocked-cantilever")),
        "the effective stiffness grows a little with deflection, to 0.111 MN/m at d = 0.03 m",
        "the stated value is the stiffness at rest",
        |shots| {
            let spring = Mechanism::from_scene(&shots.scene("spring=prbm-cantilever")).spring;
            let (rest, at_yield) = (spring.tangent(0.0), spring.tangent(0.03));
            let [low, high] = [rest, at_yield].map(|it| engineering(it, "N/m", 4));
            let text = format!("{low} at rest, {high} at 0.03 m");
            Check { text, holds: near(rest, 0.111e6, 5e-3) && at_yield > 1.02 * rest }
        },
    ),
    claim(
        ("9.14-yield", "9.5.2, Figure 9.14(b)", Reproduced, Some("concept-cocked-cantilever")),
        "the beam yields at d near 0.03 m",
        "there the bending stress at the root reaches 880 MPa",
        |shots| {
            let spring = shots.scene("spring=prbm-cantilever").mechanism.spring;
            let yields_m = spring.yields_at_m().unwrap_or(f64::NAN);
            Check { text: millimetres(yields_m), holds: near(yields_m, 0.03, 0.02) }
        },
    ),
    claim(
        ("9.5.2-reduction", "9.5.2", Reproduced, Some("concept-cocked-cantilever")),
        "cocked as far as the beam yields, it reduces penetration only a little",
        "gamma = 1, k = 0.111 MN/m, d = 0 and 0.03 m, as Figure 9.11 has it",
        |shots| {
            let depths = ["d=0", "d=0.03"].map(|d| shots.percent(&format!("k=0.111e6 {d}")));
            let gain = depths[0] - depths[1];
            Check::new("uncocked, cocked:", &depths, "%", gain > 0.0 && gain < 10.0)
        },
    ),
    claim(
        ("A.1-case", "A.1", Reproduced, Some("appendix-listing")),
        "the listing is set up with a plate of 0.1 kg, no spring, no damper, exponents 3",
        "1.5 in square and 1 in thick; read as one loop, since its jumps between scripts are not calls",
        |shots| {
            let side_m = (0.1_f64 / (2710.0 * 0.0254)).sqrt();
            let (depth, side) = (millimetres(shots.depth_m(CASE)), four(1e3 * side_m));
            let text = format!("{depth}; 0.1 kg of Table 9.1's plate is a square of {side} mm");
            Check { text, holds: near(side_m, 1.5 * 0.0254, 1e-3) }
        },
    ),
    claim(
        ("A.1-step", "A.1, dt", Corrected, Some("rigid-mount")),
        "a time step of 1 us is enough",
        "the scheme is of first order: 0.4 % of the depth on a rigid mount",
        |shots| {
            let listed = format!("{LISTED} mount=rigid");
            let exact = shots.depth_m(&listed);
            let depths = [2e-6, 1e-6, 5e-7]
                .map(|step_s| shots.by(Listing { step_s, ..Listing::default() }).depth_m(&listed));
            let ratio = (depths[0] - depths[1]) / (depths[1] - depths[2]);
            let [two, one, half] = depths.map(millimetres);
            let text = if shots.listing.is_some() {
                format!("{two}, {one}, {half} with 2, 1, 0.5 us")
            } else {
                millimetres(exact)
            };
            Check { text, holds: near(ratio, 2.0, 0.1) && near(depths[1], exact, 1e-2) }
        },
    ),
    claim(
        ("A.1-tmax", "A.1, tmax", NotReproduced, Some("thesis-baseline")),
        "a run of 0.2 ms shows the greatest displacement",
        "a quarter of the oscillation takes six times as long: the runs of chapter 9 must have been longer",
        |shots| {
            let turn_s = turns_at_s(&shots.run_with_series(""));
            let text = format!("the plate turns at {}", engineering(turn_s, "s", 4));
            Check { text, holds: turn_s > 2e-4 }
        },
    ),
    claim(
        ("A.2-coupling", "A.2, p = Pen... - (...)", Corrected, Some("thesis-baseline")),
        "depth subtracts the plate's motion",
        "only the last step's increment is subtracted, and no smaller step makes that good",
        |shots| {
            let fixed = Listing { corrects_coupling: true, ..Listing::default() };
            fault(shots, [Listing::default(), fixed], "%", |shots| shots.percent(""))
        },
    ),
    claim(
        ("A.2-jumps", "A.2, A.3, theta = 0", Corrected, Some("rigid-mount")),
        "the same lines serve normal and oblique impact",
        "once the nose is buried they divide by tan(0): only a jump over them saves the baseline",
        |shots| {
            let ignored = Listing { corrects_jumps: false, ..Listing::default() };
            let without = shots.by(ignored).run("mount=rigid").end;
            let own = millimetres(shots.depth_m("mount=rigid"));
            let text = if shots.listing.is_some() {
                format!("{own}; without the jumps: {}", without.words())
            } else {
                own
            };
            Check { text, holds: !without.is_complete() }
        },
    ),
    claim(
        ("A.4-scheme", "A.4", Corrected, Some("free-plate")),
        "the impulse on the projectile is that on the plate",
        "the projectile gets the mean of the old and the new force, the plate the new one",
        |shots| {
            let fixed = Listing { corrects_scheme: true, ..Listing::default() };
            fault(shots, [Listing::default(), fixed], "% of the momentum kept", |shots| {
                100.0 * momentum_kept(&shots.run_with_series("k=0"))
            })
        },
    ),
    claim(
        ("A.4-oblique", "A.2 to A.4, theta > 0", Corrected, Some("oblique")),
        "the contact force acts on projectile and plate alike",
        "the plate is guided along its normal and receives the cosine of the force: only then is energy conserved",
        |shots| {
            // The other errors of the listing hide this one.
            let fixed = Listing {
                corrects_coupling: true,
                corrects_stopping: true,
                corrects_scheme: true,
                corrects_obliquity: true,
                ..Listing::default()
            };
            let oblique = Listing { corrects_obliquity: false, ..fixed };
            fault(shots, [oblique, fixed], "mm at 30 degrees", |shots| {
                1e3 * shots.depth_m("theta=30deg")
            })
        },
    ),
    claim(
        ("A.5-mass", "A.5, A.7", Corrected, Some("thin-plate-perforation")),
        "after the contact m_1 + m_2 moves on",
        "also after a perforation, when the projectile has left",
        |shots| {
            let fixed = Listing { corrects_afterwards: true, ..Listing::default() };
            let travel = |shots: &Shots<'_>| shots.travel_mm("v_i=300 h=0.003");
            fault(shots, [Listing::default(), fixed], "mm of the perforated plate's travel", travel)
        },
    ),
    claim(
        ("A.7-damper", "A.7, A.9", Corrected, Some("overdamped")),
        "the damper's force is b |w|^m",
        "without a sign it acts the same way whichever way the plate moves: it adds energy on the rebound",
        |shots| {
            let fixed = Listing { corrects_damper: true, ..Listing::default() };
            let unit = "% of the energy left after the rebound";
            fault(shots, [Listing::default(), fixed], unit, |shots| {
                100.0 * energy_after_return(&shots.run_with_series("b=50 horizon=8e-3"))
            })
        },
    ),
];

/// Checks an error of the listing: computes a quantity with and without it. The corrected listing agrees with the engine.
fn fault(
    shots: &Shots<'_>,
    [faulty, fixed]: [Listing; 2],
    unit: &str,
    quantity: impl Fn(&Shots<'_>) -> f64,
) -> Check {
    let [faulty, fixed] = [faulty, fixed].map(|listing| quantity(&shots.by(listing)));
    let own = quantity(shots);
    let text = if shots.listing.is_some() {
        format!("{} {unit}; without this fault {}", four(faulty), four(fixed))
    } else {
        list(&[own], unit)
    };
    Check { text, holds: (fixed - own).abs() < 0.2 * (faulty - own).abs() }
}

/// Returns the time at which the plate reverses its motion, s.
fn turns_at_s(run: &Run) -> f64 {
    let turn = run.events.iter().find(|it| it.kind == EventKind::GreatestDisplacement);
    turn.map_or(f64::NAN, |it| it.t_s)
}

/// Returns the momentum of projectile and plate at the first arrest, relative to that at the impact.
fn momentum_kept(run: &Run) -> f64 {
    let end_s = run.first_arrest.map_or(f64::NAN, |it| it.t_s) * (1.0 + 1e-12);
    let (ratio, impact) = (run.scene.mass_ratio(), run.scene.projectile.velocity_m_s);
    let row = run.series.iter().rfind(|row| row.t_s <= end_s);
    row.map_or(f64::NAN, |row| {
        (row.projectile_velocity_m_s + ratio * row.plate_velocity_m_s) / impact
    })
}

/// Returns the energy of plate, projectile and linear spring at the return to the neutral position, relative to that at the first reversal.
fn energy_after_return(run: &Run) -> f64 {
    let scene = &run.scene;
    let mass_kg = scene.projectile.mass_kg * (1.0 + scene.mass_ratio());
    let energy_j = |row: &Sample| {
        0.5 * mass_kg * row.plate_velocity_m_s.powi(2)
            + 0.5 * scene.mechanism.spring.coefficient * row.plate_displacement_m.powi(2)
    };
    let turned_s = turns_at_s(run);
    let after: Vec<&Sample> = run.series.iter().skip_while(|row| row.t_s < turned_s).collect();
    let back = after.windows(2).find(|pair| pair[1].plate_displacement_m < 0.0);
    after.first().zip(back).map_or(f64::NAN, |(turned, pair)| {
        let [x_m, next_m] = [0, 1].map(|i| pair[i].plate_displacement_m);
        let [last_j, next_j] = [0, 1].map(|i| energy_j(pair[i]));
        (last_j + (next_j - last_j) * x_m / (x_m - next_m)) / energy_j(turned)
    })
}
