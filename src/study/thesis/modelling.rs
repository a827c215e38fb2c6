//! Claims of sections 8.1 and 8.2: the general concept, and the models of the impact that are compared.

use crate::model::mechanism::Mechanism;
use crate::model::run::{Outcome, Run, Sample};
use crate::model::scene::{ContactModel, Scene};
use crate::numerics::larger;
use crate::study::thesis::concepts::CONCEPT_SCENES;
use crate::study::thesis::lab::{
    LAWS, Lab, Law, both, changed, found, misprint_verdict, near, number, number_verdict, pc, read,
    rigid, trend_verdict, unit, with,
};
use crate::study::thesis::numbering::caption;
use crate::study::thesis::{Claim, Opens, Verdict};

const DURATION_S: f64 = 150e-6;

fn rigid_base() -> Scene {
    rigid(with(&[]))
}

fn free() -> Scene {
    with(&[("k", 0.0)])
}

fn at_once() -> Scene {
    by(ContactModel::InitialVelocity, with(&[]))
}

fn by(model: ContactModel, mut scene: Scene) -> Scene {
    scene.contact.model = model;
    scene
}

/// A damped oscillator that is set going at once: chapter 8's equation 8.3 with no force.
fn oscillator() -> Scene {
    changed(at_once(), &[("b", 50.0)])
}

fn lumped_rigid() -> Scene {
    by(ContactModel::Lumped, rigid_base())
}

fn half_sine() -> Scene {
    let mut scene = free();
    scene.contact.model = ContactModel::HalfSine;
    scene.contact.duration_s = Some(DURATION_S);
    scene
}

fn thin() -> Scene {
    changed(with(&[("v_i", 300.0)]), &[("h", 0.003)])
}

fn impulse(run: &Run, until_s: f64) -> f64 {
    let part = |pair: &[Sample]| {
        0.5 * (pair[0].contact_force_n + pair[1].contact_force_n) * (pair[1].t_s - pair[0].t_s)
    };
    run.series.windows(2).take_while(|pair| pair[1].t_s <= until_s * (1.0 + 1e-9)).map(part).sum()
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

/// The power law `c x^n` nearest to a concept's force up to where its plate goes, by the greatest distance over the greatest
/// force: n from 0.1 to 3 as in Table 9.2, c at its best.
fn distance_from_power_law(lab: &Lab, scene: &Scene) -> f64 {
    let reach = lab.run(Law::Sound, scene).max_plate_displacement_m.unwrap_or(f64::NAN);
    let spring = Mechanism::of(scene).spring;
    let points: Vec<(f64, f64)> = (1..=40)
        .map(|i| f64::from(i) / 40.0)
        .map(|part| (part, spring.force(part * reach)))
        .collect();
    let most = points.iter().map(|(_, force)| force.abs()).fold(0.0, larger);
    let worst = |n: f64, c: f64| {
        points.iter().map(|(x, force)| (c * x.powf(n) - force).abs()).fold(0.0, larger) / most
    };
    let mut best = f64::INFINITY;
    for n in 1..=30 {
        for c in 0..=50 {
            let off = worst(0.1 * f64::from(n), most * 0.03 * f64::from(c));
            best = if off < best { off } else { best };
        }
    }
    best
}

/// Depth, travel and peak force of a model over those of the hydrodynamic one.
fn against_drag(lab: &Lab, model: ContactModel) -> [Option<f64>; 3] {
    let own = lab.run(Law::Sound, &by(model, with(&[])));
    let drag = lab.run(Law::Sound, &with(&[]));
    let over = |a: Option<f64>, b: Option<f64>| Some(a? / b? - 1.0);
    [
        over(own.final_penetration_m, drag.final_penetration_m),
        over(own.max_plate_displacement_m, drag.max_plate_displacement_m),
        over(own.peak_contact_force_n, drag.peak_contact_force_n),
    ]
}

fn deviation(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), |off| format!("{:+.1} %", 100.0 * off))
}

/// A half-sine of some part of the hydrodynamic duration on the fixed plate.
fn half_sine_of(part: f64, lab: &Lab) -> Scene {
    let duration = lab.run(Law::Sound, &rigid_base()).first_arrest.map_or(f64::NAN, |it| it.t_s);
    let mut scene = by(ContactModel::HalfSine, with(&[]));
    scene.contact.duration_s = Some(part * duration);
    scene
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "8.1-sign",
        place: "8.1.1, eq. 8.1",
        says: "the damper's force is b w^m, against the motion",
        opens: Opens::Nothing,
        check: |_| {
            let force = |w: f64, m: i32| w.powi(m);
            found(
                format!(
                    "m = 2: {} b at w = 10 m/s, {} b at -10",
                    number(force(10.0, 2)),
                    number(force(-10.0, 2))
                ),
                misprint_verdict(force(-10.0, 2) < 0.0, force(-10.0, 1) < 0.0),
                "for even m it pushes along with the motion: b |w|^m sgn w is meant",
            )
        },
    },
    Claim {
        id: "8.2-sign",
        place: "8.1.1, eq. 8.2",
        says: "the spring's force is k x^n",
        opens: Opens::Preset("low-exponent"),
        check: |_| {
            let as_printed = (-0.01f64).powf(0.5);
            let scene = with(&[("n", 0.5)]);
            let odd = Mechanism::of(&scene).spring.force(-0.01);
            found(
                format!(
                    "n = 0.5 at x = -10 mm: the power is {}; k |x|^n sgn x is {}",
                    if as_printed.is_nan() { "no real number" } else { "a number" },
                    unit(odd, "N")
                ),
                misprint_verdict(!as_printed.is_nan(), odd < 0.0),
                "a cocked plate starts at x < 0, where most powers do not exist or point the wrong way",
            )
        },
    },
    Claim {
        id: "8.1.1-general",
        place: "8.1.1",
        says: "k x^n can approximate the curves of many of the other concepts",
        opens: Opens::Nothing,
        check: |lab| {
            let off = CONCEPT_SCENES.map(|(_, scene)| distance_from_power_law(lab, &scene()));
            let near_by = off.iter().filter(|off| **off < 0.1).count();
            let told = off.map(|off| pc(100.0 * off));
            found(
                format!("off by {} of the greatest force, in the order of 6.2", told.join(", ")),
                trend_verdict(near_by >= 4),
                "beams and the helix yes; what buckles or snaps no, for no power ever falls",
            )
        },
    },
    Claim {
        id: "8.3-oscillator",
        place: "8.2.2, eq. 8.3",
        says: "m x'' + b x' + k x = F",
        opens: Opens::Scene(oscillator),
        check: |lab| {
            let travel = lab.travel_mm(Law::Sound, &oscillator());
            let (mass, k, b, w): (f64, f64, f64, f64) = (0.059, 1e5, 50.0, 50.0);
            let omega = (k / mass).sqrt();
            let zeta = b / (2.0 * (k * mass).sqrt());
            let root = (1.0 - zeta * zeta).sqrt();
            let stated = 1e3 * w / omega * (-zeta / root * zeta.acos()).exp();
            found(
                format!(
                    "joined at once, b = 50: {} mm; in closed form {} mm",
                    number(travel),
                    number(stated)
                ),
                number_verdict(near(travel, stated, 1e-6), false),
                "the equation the plate is on between and after contacts",
            )
        },
    },
    Claim {
        id: "8.6-hysteresis",
        place: "8.2.2, Figures 8.6 and 8.7",
        says: "different springs for loading and unloading lose energy",
        opens: Opens::Scene(lumped_rigid),
        check: |lab| {
            let run = lab.run(Law::Sound, &lumped_rigid());
            let back = run.separation.map_or(f64::NAN, |(_, velocity)| velocity);
            found(
                format!(
                    "k_unload = 100 k_load on a fixed plate: 100 m/s in, {} out",
                    unit(back, "m/s")
                ),
                number_verdict(near(back, -10.0, 1e-3), false),
                "the root of the ratio is the speed that comes back",
            )
        },
    },
    Claim {
        id: "8.2.2-wu",
        place: "8.2.2",
        says: "Wu's model predicts certain impacts below 50 m/s",
        opens: Opens::Scene(lumped_rigid),
        check: |_| {
            found(
                String::new(),
                Verdict::Unchecked,
                "neither his springs' values nor his measurements are given",
            )
        },
    },
    Claim {
        id: "8.2.2-figure",
        place: "8.2.2, end",
        says: "both models combined are shown in Figure 8.4",
        opens: Opens::Nothing,
        check: |_| {
            let combined =
                |number| caption(number).is_some_and(|text| text.starts_with("Combined"));
            let quoted =
                |number| format!("Figure {number}: \"{}\"", caption(number).unwrap_or("none"));
            read(
                format!("{}; {}", quoted("8.4"), quoted("8.8")),
                misprint_verdict(combined("8.4"), combined("8.8")),
                "Figure 8.8 is meant",
            )
        },
    },
    Claim {
        id: "8.2.3-forms",
        place: "8.2.3",
        says: "the force history's form depends on whether the plate is perforated",
        opens: Opens::Scene(thin),
        check: |lab| {
            let end = |scene: &Scene| {
                let run = lab.run_with(Law::Sound, scene, true);
                let until_s = run.contact_end_s();
                let last = run.series.iter().rfind(|row| row.t_s < until_s * (1.0 - 1e-9));
                let peak = run.peak_contact_force_n.unwrap_or(f64::NAN);
                last.map_or(f64::NAN, |row| row.contact_force_n / peak)
            };
            let (thick, through) = (end(&with(&[])), end(&thin()));
            found(
                format!(
                    "at its end {} of the peak arrested, {} perforated",
                    pc(100.0 * thick),
                    pc(100.0 * through)
                ),
                trend_verdict(thick > 0.9 && through < 0.3),
                "an arrested nose keeps its area, a leaving one gives it back",
            )
        },
    },
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
            found(
                format!("m dv/dt over F along the run: {}", number(product)),
                misprint_verdict(near(product, 1.0, 0.05), near(product, -1.0, 0.05)),
                "the sign is wrong for a deceleration; 8.6 goes on with the size",
            )
        },
    },
    Claim {
        id: "8.6-impulse",
        place: "8.2.3, eq. 8.6 and 8.9",
        says: "the half-sine's impulse is the projectile's momentum",
        opens: Opens::Scene(half_sine),
        check: |lab| {
            let run = lab.run_with(Law::Sound, &half_sine(), true);
            let impulse = impulse(&run, DURATION_S);
            found(
                format!("{} N s of m v = 2.95 N s", number(impulse)),
                number_verdict(near(impulse, 0.0295 * 100.0, 1e-3), false),
                "summed over the run's own force history",
            )
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
            found(
                format!("{} for t_d = 150 us", unit(peak, "N")),
                number_verdict(near(peak, stated, 1e-9), false),
                "the amplitude that makes the impulse m V",
            )
        },
    },
    Claim {
        id: "8.10-shape",
        place: "8.2.3, Figure 8.10",
        says: "the force history of penetration is roughly a half-sine",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let [sound, printed] = LAWS.map(|law| off_half_sine(lab, law));
            both(
                format!("off by up to {} of the peak", pc(100.0 * sound)),
                format!("off by up to {} of the peak", pc(100.0 * printed)),
                trend_verdict(sound < 0.25),
                "the thesis's own law ends at A S_y, its full strength, not at zero: a ramp and a cliff",
            )
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
            found(
                unit(start, "m/s"),
                number_verdict(near(start, 50.0, 1e-12), false),
                "momentum; gamma = 1",
            )
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
            both(
                "3 mm at 300 m/s: perforated by the drag model alone".to_owned(),
                lab.run(Law::Printed, &thin()).outcome.word().to_owned(),
                trend_verdict(drag && blind),
                "they know no rear face",
            )
        },
    },
    Claim {
        id: "8.9-known",
        place: "8.2.3",
        says: "if t_d is known, the half-sine approximates the true force history",
        opens: Opens::Scene(half_sine),
        check: |lab| {
            let run = lab.run(Law::Sound, &half_sine_of(1.0, lab));
            let peak = run.peak_contact_force_n.unwrap_or(f64::NAN);
            let drag = lab.run(Law::Sound, &rigid_base()).peak_contact_force_n.unwrap_or(f64::NAN);
            found(
                format!(
                    "with the fixed plate's own t_d: peak {} against {}",
                    unit(peak, "N"),
                    unit(drag, "N")
                ),
                trend_verdict(near(peak, drag, 0.1)),
                "the impulse is right, the shape is not: the true history is a ramp and a cliff",
            )
        },
    },
    Claim {
        id: "8.9-limiting",
        place: "8.2.3",
        says: "the choice of t_d limits the model's accuracy",
        opens: Opens::Scene(half_sine),
        check: |lab| {
            let runs = [0.5, 1.0, 2.0].map(|part| lab.run(Law::Sound, &half_sine_of(part, lab)));
            let peaks = runs.each_ref().map(|run| run.peak_contact_force_n.unwrap_or(f64::NAN));
            let travels =
                runs.each_ref().map(|run| run.max_plate_displacement_m.unwrap_or(f64::NAN));
            found(
                format!(
                    "half, once and twice t_d: peak {}, {}, {}; plate travel {}, {}, {} mm",
                    unit(peaks[0], "N"),
                    unit(peaks[1], "N"),
                    unit(peaks[2], "N"),
                    number(1e3 * travels[0]),
                    number(1e3 * travels[1]),
                    number(1e3 * travels[2])
                ),
                trend_verdict(peaks[0] > 3.0 * peaks[2]),
                "of the force; the plate's travel, which lives on the impulse, hardly notices",
            )
        },
    },
    Claim {
        id: "8.1-errors",
        place: "Table 8.1",
        says: "the simpler models pay with accuracy for being simple",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let models =
                [ContactModel::Lumped, ContactModel::HalfSine, ContactModel::InitialVelocity];
            let off = models.map(|model| against_drag(lab, model));
            let told: Vec<String> = models
                .iter()
                .zip(&off)
                .map(|(model, [depth, travel, peak])| {
                    format!(
                        "{} {} / {} / {}",
                        model.word(),
                        deviation(*depth),
                        deviation(*travel),
                        deviation(*peak)
                    )
                })
                .collect();
            let travel = off.iter().all(|[_, travel, _]| travel.is_some_and(|it| it.abs() < 0.05));
            let depth = off.iter().all(|[depth, ..]| depth.is_none_or(|it| it.abs() > 0.05));
            both(
                format!(
                    "depth / plate travel / peak force against the drag model: {}",
                    told.join("; ")
                ),
                {
                    let [depth, travel, peak] = against_drag(lab, ContactModel::Appendix);
                    format!("{} / {} / {}", deviation(depth), deviation(travel), deviation(peak))
                },
                trend_verdict(travel && depth),
                "for the plate's travel any of them does, for depth none of the simpler ones; run times: cmra run \
                        --compare models",
            )
        },
    },
];
