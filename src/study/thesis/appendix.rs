//! Claims of Appendix A: what the listing computes, quirk by quirk.

use crate::model::appendix::Scheme;
use crate::model::run::{EndReason, EventKind, Mode, Outcome, Run};
use crate::model::scene::{Jumps, Listing, Reading, Scene};
use crate::study::thesis::lab::{
    LAWS, Law, both, changed, found, listing_material, mm, near, number, number_verdict, pc, rigid,
    trend_verdict, unit, with,
};
use crate::study::thesis::{Claim, Opens, Verdict};

/// The case the listing is set up for: `m_2` = 0.1 kg, no spring, no damper, exponents 3.
fn listed() -> Scene {
    listing_material(with(&[("gamma", 0.1 / 0.0295), ("k", 0.0), ("n", 3.0), ("m", 3.0)]))
}

fn quirk(mut scene: Scene, change: fn(&mut Listing)) -> Scene {
    change(&mut scene.contact.appendix);
    scene
}

fn damped() -> Scene {
    with(&[("b", 50.0), ("horizon", 8e-3)])
}

fn thin() -> Scene {
    with(&[("v_i", 300.0), ("h", 0.003)])
}

fn violent() -> Scene {
    with(&[("gamma", 0.8), ("k", 7.5e6), ("d", 0.1), ("h", 0.0014)])
}

fn oblique() -> Scene {
    with(&[("theta", 30.0)])
}

/// A spring of so low an exponent that it holds the plate.
fn held() -> Scene {
    with(&[("k", 1e6), ("n", 0.1)])
}

/// The stiffest spring of Table 9.2 under the lightest plate, with an interface that gives way.
fn resuming() -> Scene {
    let mut scene = with(&[("gamma", 0.8), ("k", 7.5e6)]);
    scene.interface.law = crate::model::scene::InterfaceLaw::Plastic;
    scene
}

/// Energy of plate, projectile and spring right after the first turn, and when it comes back through neutral, J.
fn swing_j(run: &Run) -> (f64, f64) {
    let energy = |row: &crate::model::run::Sample| {
        0.5 * 0.059 * row.plate_velocity_m_s.powi(2) + 0.5e5 * row.plate_displacement_m.powi(2)
    };
    let turn = run.events.iter().find(|event| event.kind == EventKind::GreatestDisplacement);
    let turn_s = turn.map_or(f64::INFINITY, |event| event.t_s);
    let after = |test: fn(f64) -> bool| {
        run.series
            .iter()
            .find(|row| row.t_s >= turn_s && test(row.plate_displacement_m))
            .map_or(f64::NAN, energy)
    };
    (after(|_| true), after(|x| x < 0.0))
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "A.1-case",
        place: "A.1",
        says: "the listing is set up with a plate of 0.1 kg, no spring, no damper, exponents 3",
        opens: Opens::Preset("appendix-listing"),
        check: |lab| {
            let [sound, printed] = LAWS.map(|law| lab.depth_m(law, &listed()));
            // The plate of Table 9.1: 25.4 mm of 2710 kg/m3.
            let side_m = (0.1f64 / (2710.0 * 0.0254)).sqrt();
            both(
                format!("{}; 0.1 kg is a square of {} of Table 9.1's plate", mm(sound), mm(side_m)),
                mm(printed),
                if near(side_m, 0.0381, 1e-3) { Verdict::Reproduced } else { Verdict::Unchecked },
                "1.5 in square and 1 in thick: a plate that can be cut, but no case of chapter 9, which has n = 1 and m = 1",
            )
        },
    },
    Claim {
        id: "A.1-step",
        place: "A.1, dt",
        says: "a time step of 1 us is enough",
        opens: Opens::Preset("rigid-mount"),
        check: |lab| {
            let depth = |dt: f64| {
                let mut scene = rigid(listing_material(with(&[])));
                scene.contact.appendix.step_s = dt;
                lab.depth_m(Law::Printed, &scene)
            };
            let exact = lab.depth_m(Law::Sound, &rigid(listing_material(with(&[]))));
            let errors = [2e-6, 1e-6, 5e-7].map(|dt| depth(dt) / exact - 1.0);
            let first_order =
                near(errors[0] / errors[1], 2.0, 0.1) && near(errors[1] / errors[2], 2.0, 0.1);
            both(
                mm(exact),
                format!(
                    "errors {} %, {} %, {} % with 2, 1, 0.5 us",
                    number(100.0 * errors[0]),
                    number(100.0 * errors[1]),
                    number(100.0 * errors[2])
                ),
                number_verdict(errors[1].abs() < 1e-3, first_order && errors[1].abs() < 1e-2),
                "first order: 0.4 % of depth, and the Runge-Kutta steps of the plate do not help",
            )
        },
    },
    Claim {
        id: "A.1-tmax",
        place: "A.1, tmax",
        says: "a run of 0.2 ms shows the greatest displacement",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let run = lab.run(Law::Sound, &with(&[]));
            let turn =
                run.events.iter().find(|event| event.kind == EventKind::GreatestDisplacement);
            let turn_s = turn.map_or(f64::NAN, |event| event.t_s);
            let cut = lab.run(Law::Printed, &with(&[("horizon", 2e-4)]));
            let reached = cut.max_plate_displacement_m.is_some();
            both(
                format!("the plate turns at {}", unit(turn_s, "s")),
                format!("reached by 0.2 ms: {reached}"),
                number_verdict(reached, turn_s.is_finite()),
                "a quarter of the oscillation takes six times as long: chapter 9 must have run on",
            )
        },
    },
    Claim {
        id: "A.1-maxdisp",
        place: "A.1, MaxDisp",
        says: "the space a design needs is the plate's greatest position",
        opens: Opens::Preset("cocked"),
        check: |lab| {
            let run = lab.run(Law::Sound, &with(&[("d", 0.5)]));
            let (most, stroke) = (
                run.max_plate_displacement_m.unwrap_or(f64::NAN),
                run.stroke_m().unwrap_or(f64::NAN),
            );
            both(
                format!("{} forward of neutral, {} in all", mm(most), mm(stroke)),
                format!("{} mm", number(lab.travel_mm(Law::Printed, &with(&[("d", 0.5)])))),
                number_verdict(near(most, stroke, 0.01), stroke > most),
                "counted from neutral it excludes the cocked travel, here half of the space",
            )
        },
    },
    Claim {
        id: "A.2-coupling",
        place: "A.2, p = Pen... - (...)",
        says: "depth subtracts the plate's motion",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let sound = lab.percent(Law::Sound, &with(&[]));
            let printed = lab.percent(Law::Printed, &with(&[]));
            let corrected =
                lab.percent(Law::Printed, &quirk(with(&[]), |it| it.coupling = Reading::Corrected));
            let mut fine = with(&[]);
            fine.contact.appendix.step_s = 1e-7;
            let finer = lab.percent(Law::Printed, &fine);
            both(
                pc(sound),
                format!(
                    "{}, with dt = 1e-7 {}; corrected {}",
                    pc(printed),
                    pc(finer),
                    pc(corrected)
                ),
                number_verdict(
                    near(printed, sound, 0.02),
                    near(corrected, sound, 0.02) && !near(finer, sound, 0.1),
                ),
                "only the last step's increment is subtracted; the error does not vanish as dt goes to 0",
            )
        },
    },
    Claim {
        id: "A.2-shares",
        place: "A.2, over Figure 9.2",
        says: "the listing gives the figure's shares of the baseline",
        opens: Opens::Preset("figure-9.2"),
        check: |lab| {
            let shares = |law: Law| {
                [0.8, 2.0, 7.0]
                    .map(|gamma| lab.percent(law, &listing_material(with(&[("gamma", gamma)]))))
            };
            let told = |values: [f64; 3]| {
                format!(
                    "{}, {}, {} at gamma = 0.8, 2, 7",
                    pc(values[0]),
                    pc(values[1]),
                    pc(values[2])
                )
            };
            let (sound, printed) = (shares(Law::Sound), shares(Law::Printed));
            both(
                told(sound),
                told(printed),
                number_verdict(near(printed[0], sound[0], 0.02), printed[0] > sound[0]),
                "every benefit of compliance is understated: 22 % instead of 40 % at gamma = 0.8",
            )
        },
    },
    Claim {
        id: "A.2-theta",
        place: "A.2, A.3, theta = 0",
        says: "the same lines serve normal and oblique impact",
        opens: Opens::Scene(|| rigid(with(&[]))),
        check: |lab| {
            let ignored = quirk(rigid(with(&[])), |it| it.jumps = Jumps::Ignored);
            let run = lab.run(Law::Printed, &ignored);
            let meant = lab.run(Law::Printed, &rigid(with(&[])));
            both(
                mm(lab.depth_m(Law::Sound, &rigid(with(&[])))),
                format!("without the jumps: {}; with them {}", run.end.words(), meant.outcome),
                number_verdict(run.end != EndReason::NonFinite, meant.outcome == Outcome::Arrested),
                "once the nose is buried they divide by tan(0): only a jump over them saves the baseline",
            )
        },
    },
    Claim {
        id: "A.2-jumps",
        place: "A.1 to A.4",
        says: "m50, m200 and m300 call each other, with break and continue across files",
        opens: Opens::Nothing,
        check: |lab| {
            let depth = lab.depth_m(Law::Printed, &listed());
            let run = lab.run(Law::Printed, &listed());
            let peak = run.peak_contact_force_n.unwrap_or(f64::NAN);
            both(
                String::new(),
                format!("read as one loop: {}, {}", mm(depth), unit(peak, "N")),
                number_verdict(false, near(depth, 6.8806e-3, 1e-3)),
                "meant as jumps: one force, one plate step, the projectile by the trapezoid; as calls each step would run three times",
            )
        },
    },
    Claim {
        id: "A.2-break",
        place: "A.2, if p < 0, break",
        says: "a negative depth ends the run",
        opens: Opens::Scene(violent),
        check: |lab| {
            let run = lab.run(Law::Printed, &violent());
            let broke = run.end == EndReason::BreaksOff;
            both(
                mm(lab.depth_m(Law::Sound, &violent())),
                run.end.words().to_owned(),
                number_verdict(!broke, broke),
                "a thin, hard drawn plate outruns the shot within a step; the script then has no history to plot and fails",
            )
        },
    },
    Claim {
        id: "A.2-slow",
        place: "A.2, vrel < 0.01",
        says: "penetration ends at common velocity",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let scene = rigid(with(&[]));
            let scheme = Scheme::of(&scene, Listing::default());
            let mut state = scheme.start();
            let mut steps = 0;
            while scheme.ended(&state).is_none_or(|_| steps == 0) && steps < 10_000 {
                steps += 1;
                if scheme.step(&mut state).is_err() {
                    break;
                }
            }
            let corrected = quirk(scene.clone(), |it| it.stopping = Reading::Corrected);
            let depths = [&scene, &corrected].map(|scene| lab.depth_m(Law::Printed, scene));
            both(
                "0 m/s, located".to_owned(),
                format!(
                    "overshoots to {}; {} and, located, {}",
                    unit(state.slip_m_s, "m/s"),
                    mm(depths[0]),
                    mm(depths[1])
                ),
                number_verdict(state.slip_m_s.abs() < 0.01, near(depths[0], depths[1], 1e-2)),
                "it is checked only after whole steps, when the relative velocity has changed sign",
            )
        },
    },
    Claim {
        id: "A.4-trapezoid",
        place: "A.4",
        says: "the impulse on the projectile is that on the plate",
        opens: Opens::Scene(|| with(&[("k", 0.0)])),
        check: |lab| {
            let momentum = |law| {
                let scene = with(&[("k", 0.0)]);
                lab.run(law, &scene).first_arrest.map_or(f64::NAN, |_| {
                    let run = lab.run_with(law, &scene, true);
                    let end_s = run.first_arrest.map_or(f64::NAN, |it| it.t_s);
                    let row = run.series.iter().rev().find(|row| row.t_s <= end_s * (1.0 + 1e-12));
                    row.map_or(f64::NAN, |row| {
                        0.0295 * (row.projectile_velocity_m_s + row.plate_velocity_m_s) / 2.95
                    })
                })
            };
            let (sound, printed) = (momentum(Law::Sound), momentum(Law::Printed));
            both(
                format!("momentum kept to {} %", number(100.0 * (sound - 1.0).abs())),
                format!("off by {} %", number(100.0 * (printed - 1.0).abs())),
                number_verdict(near(printed, 1.0, 1e-4), near(sound, 1.0, 1e-9)),
                "the projectile gets the mean of old and new force, the plate the new one",
            )
        },
    },
    Claim {
        id: "A.4-rewind",
        place: "A.4",
        says: "the run after the contact goes on where the contact ended",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let jump = |scene: &Scene| {
                let run = lab.run_with(Law::Printed, scene, true);
                let end_s = run.first_arrest.map_or(f64::NAN, |arrest| arrest.t_s);
                let end = run.first_arrest.map_or(f64::NAN, |arrest| arrest.plate_displacement_m);
                let next = run.series.iter().find(|row| row.t_s > end_s * (1.0 + 1e-9));
                next.map_or(f64::NAN, |row| {
                    row.plate_displacement_m - end - row.plate_velocity_m_s * (row.t_s - end_s)
                })
            };
            let printed = jump(&with(&[]));
            let corrected = jump(&quirk(with(&[]), |it| it.stopping = Reading::Corrected));
            both(
                "one state, no seam".to_owned(),
                format!(
                    "the plate jumps by {} um; corrected by {} um",
                    number(1e6 * printed),
                    number(1e6 * corrected)
                ),
                number_verdict(printed.abs() < 1e-6, corrected.abs() < 0.1 * printed.abs()),
                "it starts from the state before the last accepted step: the plate is set back by one dt",
            )
        },
    },
    Claim {
        id: "A.8-chatter",
        place: "A.8, n < 1",
        says: "Runge-Kutta of order four follows the plate on any spring",
        opens: Opens::Scene(held),
        check: |lab| {
            let rattle = |law| {
                let run = lab.run_with(law, &held(), true);
                let contact = run.series.iter().filter(|row| row.mode == Mode::Penetrating);
                let speeds: Vec<f64> = contact.map(|row| row.plate_velocity_m_s).collect();
                let turns = speeds.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
                (turns, speeds.into_iter().map(f64::abs).fold(0.0, crate::numerics::larger))
            };
            let told = |(turns, most): (usize, f64)| {
                format!(
                    "the plate turns {turns} times within the contact, with up to {}",
                    unit(most, "m/s")
                )
            };
            let [sound, printed] = [Law::Sound, Law::Printed].map(rattle);
            both(
                told(sound),
                told(printed),
                number_verdict(printed.0 < 10, sound.0 < 10),
                "k = 1e6, n = 0.1: infinitely stiff at x = 0, where steps of a fixed size throw the plate to and fro",
            )
        },
    },
    Claim {
        id: "A.5-mass",
        place: "A.5, A.7",
        says: "after the contact m_1 + m_2 moves on",
        opens: Opens::Scene(thin),
        check: |lab| {
            let printed = lab.travel_mm(Law::Printed, &thin());
            let corrected = lab
                .travel_mm(Law::Printed, &quirk(thin(), |it| it.afterwards = Reading::Corrected));
            let sound = lab.travel_mm(Law::Sound, &thin());
            both(
                format!("perforated; the plate alone goes {} mm", number(sound)),
                format!("{} mm; parted {} mm", number(printed), number(corrected)),
                number_verdict(near(printed, sound, 0.05), near(corrected, sound, 0.05)),
                "also after a perforation, when the projectile has left",
            )
        },
    },
    Claim {
        id: "A.7-damper",
        place: "A.7, A.9",
        says: "the damper's force is b |w|^m",
        opens: Opens::Scene(damped),
        check: |lab| {
            let gain = |law, scene: &Scene| {
                let (turn, back) = swing_j(&lab.run_with(law, scene, true));
                back / turn
            };
            let sound = gain(Law::Sound, &damped());
            let printed = gain(Law::Printed, &damped());
            let corrected =
                gain(Law::Printed, &quirk(damped(), |it| it.damper = Reading::Corrected));
            both(
                format!("{} of the energy is left on the way back", pc(100.0 * sound)),
                format!("{}; with a sign {}", pc(100.0 * printed), pc(100.0 * corrected)),
                number_verdict(printed < 1.0, corrected < 1.0),
                "without a sign it pushes the same way whichever way the plate moves: it adds energy on the rebound",
            )
        },
    },
    Claim {
        id: "A.4-oblique",
        place: "A.2 to A.4, theta > 0",
        says: "the contact force acts on projectile and plate alike",
        opens: Opens::Scene(oblique),
        check: |lab| {
            let sound = lab.depth_m(Law::Sound, &oblique());
            let all = |obliquity| {
                let mut scene = oblique();
                scene.contact.appendix = Listing { obliquity, ..Listing::corrected(1e-6) };
                lab.depth_m(Law::Printed, &scene)
            };
            let (printed, corrected) = (all(Reading::Printed), all(Reading::Corrected));
            both(
                format!("{} at 30 deg", mm(sound)),
                format!("{}; resolved on the normal {}", mm(printed), mm(corrected)),
                number_verdict(near(printed, sound, 1e-3), near(corrected, sound, 1e-3)),
                "the plate is guided along its normal: it gets the cosine's part, and only then is energy kept",
            )
        },
    },
    Claim {
        id: "A-resumption",
        place: "9.2.2, A.2",
        says: "penetration is over at the first common velocity",
        opens: Opens::Preset("cocked-plastic"),
        check: |lab| {
            let mut cocked = with(&[("d", 0.5)]);
            let first = lab.percent(Law::Sound, &cocked);
            cocked.interface.law = crate::model::scene::InterfaceLaw::Plastic;
            let run = lab.run(Law::Sound, &cocked);
            let printed = lab.percent(Law::Printed, &changed(with(&[]), &[("d", 0.5)]));
            both(
                format!("d = 0.5 m: {} at first, then {}", pc(first), run.outcome),
                pc(printed),
                number_verdict(run.outcome == Outcome::Arrested, false),
                "the spring later demands more than A S_y of the interface: a rigid-plastic one yields, and the plate is perforated",
            )
        },
    },
    Claim {
        id: "A-resumption-k",
        place: "9.2.2, A.2",
        says: "nor does anything penetrate again uncocked",
        opens: Opens::Scene(resuming),
        check: |lab| {
            let greatest = |gamma: f64| {
                let demand = |k: f64| {
                    let run = lab.run(Law::Sound, &with(&[("gamma", gamma), ("k", k)]));
                    (run.interface_demand_ratio.unwrap_or(0.0), k)
                };
                let all = (1..=40).map(|i| demand(0.25e6 * f64::from(i)));
                all.fold((0.0, 0.0), |most, own| if own.0 > most.0 { own } else { most })
            };
            let most = [0.8, 1.0].map(greatest);
            found(
                format!(
                    "over k to 10 MN/m the spring demands up to {} of A S_y at gamma = 0.8 (k = {}), {} at 1",
                    pc(100.0 * most[0].0),
                    unit(most[0].1, "N/m"),
                    pc(100.0 * most[1].0)
                ),
                trend_verdict(most.iter().all(|(ratio, _)| *ratio <= 1.0)),
                "at the corner of Table 9.2 the interface just yields: 4.6993 mm become 4.7000 mm",
            )
        },
    },
];
