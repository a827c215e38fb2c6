//! Claims of chapters 5 and 6: mechanical functions, and the concepts with the dimensions this program assumes for them.

use crate::model::mechanism::Mechanism;
use crate::model::scene::Scene;
use crate::numerics::{larger, smaller};
use crate::study::principles::{Function, PRINCIPLES};
use crate::study::thesis::chapter4::spaced;
use crate::study::thesis::lab::{
    Lab, Law, changed, found, misprint_verdict, mm, near, number, number_verdict, pc, read, rigid,
    spelled, trend_verdict, unit, with,
};
use crate::study::thesis::numbering::{has_figure, has_table};
use crate::study::thesis::{Claim, Opens, Verdict};

use Function::{AcceleratedElements, ControlledStiffness, LateralArray, PlateOrientation};

/// A preset's name, and its scene.
type Named = (&'static str, fn() -> Scene);

/// The concepts in the order of chapter 6 and Table 7.1, as the bundled presets have them.
pub(super) const CONCEPT_SCENES: [Named; 8] = [
    ("concept-emergent-four-bar", || spelled(&[("spring", "prbm-guided"), ("N_spring", "2")])),
    ("concept-buckling-four-bar", || {
        let column = [("k_col", "4.55e7"), ("F_crit", "3993"), ("F_plat", "2995")];
        column_of(&[&[("N_spring", "2"), ("x_fall", "0.002")], &column[..]].concat())
    }),
    ("concept-buckling-cantilever", || {
        column_of(&[("k_col", "6.83e7"), ("F_crit", "842"), ("F_plat", "842"), ("x_fall", "0.001")])
    }),
    ("concept-cocked-four-bar", || {
        spelled(&[("spring", "prbm-guided"), ("N_spring", "2"), ("d", "0.005")])
    }),
    ("concept-cocked-cantilever", || spelled(&[("spring", "prbm-cantilever"), ("d", "0.025")])),
    ("concept-bistable-shuttle", || {
        spelled(&[("spring", "bistable"), ("x_2", "0.03"), ("x_u", "0.004"), ("F_bar", "100")])
    }),
    ("concept-buckling-tube", || {
        column_of(&[("k_col", "5e6"), ("F_crit", "8e3"), ("F_plat", "5e3"), ("x_fall", "0.003")])
    }),
    ("concept-helical-spring", || helices(&[("I_z", "2.1e-6")])),
];

/// The functions chapter 6 lists for each of them.
pub(super) const SUPPLIED: [&[Function]; 8] = [
    &[PlateOrientation, ControlledStiffness, LateralArray],
    &[PlateOrientation, ControlledStiffness, LateralArray],
    &[PlateOrientation, ControlledStiffness, LateralArray],
    &[AcceleratedElements, ControlledStiffness, LateralArray],
    &[PlateOrientation, AcceleratedElements, ControlledStiffness, LateralArray],
    &[PlateOrientation, AcceleratedElements, ControlledStiffness, LateralArray],
    &[ControlledStiffness, LateralArray],
    &[AcceleratedElements, ControlledStiffness, LateralArray],
];

const EMERGENT: usize = 0;
const BUCKLING_BAR: usize = 1;
const COCKED_BAR: usize = 3;
const COCKED_BEAM: usize = 4;
const SHUTTLE: usize = 5;
const TUBE: usize = 6;
const HELICAL: usize = 7;

fn concept(at: usize) -> Scene {
    (CONCEPT_SCENES[at].1)()
}

fn column_of(changes: &[(&str, &str)]) -> Scene {
    spelled(&[&[("spring", "column")], changes].concat())
}

fn helices(changes: &[(&str, &str)]) -> Scene {
    spelled(&[&[("spring", "helix"), ("k_helix", "2e5"), ("twist", "60")], changes].concat())
}

/// Three helical springs side by side, coupled.
fn lateral() -> Scene {
    helices(&[("gamma", "3"), ("N_spring", "3"), ("I_z", "6.3e-6")])
}

/// The strips of the buckling four-bar, free at one end: Euler's load is a sixteenth.
fn free_strips() -> Scene {
    changed(concept(BUCKLING_BAR), &[("F_crit", 3993.0 / 16.0), ("F_plat", 3993.0 / 16.0)])
}

fn weighed() -> Scene {
    let mut scene = concept(EMERGENT);
    scene.mechanism.spring.own_mass = crate::model::scene::OwnMass::Counted;
    scene
}

/// A scene's cocked concept with its uncocked twin: share of the baseline and the plate's velocity at first arrest, m/s.
fn cocked_and_not(lab: &Lab, at: usize) -> [(f64, f64); 2] {
    [concept(at), changed(concept(at), &[("d", 0.0)])].map(|scene| {
        let arrest = lab.run(Law::Sound, &scene).first_arrest;
        (lab.percent(Law::Sound, &scene), arrest.map_or(f64::NAN, |it| it.plate_velocity_m_s))
    })
}

fn served_by(own: Function) -> usize {
    PRINCIPLES.iter().filter(|it| it.functions.contains(&own)).count()
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "5.1-tables",
        place: "Tables 4.1 and 5.1",
        says: "three families, seven principles, each served by a function",
        opens: Opens::Nothing,
        check: |_| {
            let mut families: Vec<&str> = PRINCIPLES.iter().map(|it| it.family).collect();
            families.dedup();
            let served = PRINCIPLES.iter().filter(|it| !it.functions.is_empty()).count();
            read(
                format!(
                    "{} families, {} principles, {served} of them served by {} functions",
                    families.len(),
                    PRINCIPLES.len(),
                    Function::ALL.len()
                ),
                number_verdict(families.len() == 3 && served == 7, false),
                "counted in the tables (cmra design principles)",
            )
        },
    },
    Claim {
        id: "5.1.1-rotational",
        place: "5.1.1 against Table 5.1",
        says: "plate orientation serves ricochet and obliquity",
        opens: Opens::Preset("oblique"),
        check: |_| {
            let served = served_by(PlateOrientation);
            let rotation =
                PRINCIPLES.last().is_some_and(|it| it.functions.contains(&PlateOrientation));
            read(
                format!("Table 5.1 gives it {served} principles, rotational transfer among them"),
                misprint_verdict(served == 2, served == 3 && rotation),
                "the text omits what the table names",
            )
        },
    },
    Claim {
        id: "5.1.2-figure",
        place: "5.1.2, 5.1.3",
        says: "see Figures 5.1.2 and 5.1.3",
        opens: Opens::Nothing,
        check: |_| {
            let (named, meant) = (["5.1.2", "5.1.3"], ["5.2", "5.3"]);
            read(
                "chapter 5 has Figures 5.1 to 5.4".to_owned(),
                misprint_verdict(
                    named.into_iter().all(has_figure),
                    meant.into_iter().all(has_figure),
                ),
                "Figures 5.2 and 5.3 are meant",
            )
        },
    },
    Claim {
        id: "5.1.2-constant",
        place: "5.1.2, Figure 5.2",
        says: "a constant-force mechanism resists with one force throughout its displacement",
        opens: Opens::Preset("constant-force"),
        check: |lab| {
            let scene = spelled(&[("spring", "constant")]);
            let spring = Mechanism::of(&scene).spring;
            let reach = lab.travel_mm(Law::Sound, &scene) / 1e3;
            let forces: Vec<f64> = (1..=50)
                .map(|i| spring.force(1e-3 + (reach - 1e-3) * f64::from(i) / 50.0))
                .collect();
            let (least, most) = (
                forces.iter().copied().fold(f64::INFINITY, smaller),
                forces.iter().copied().fold(0.0, larger),
            );
            found(
                format!(
                    "{} to {} from 1 mm to {} mm; depth {}",
                    unit(least, "N"),
                    unit(most, "N"),
                    number(1e3 * reach),
                    pc(lab.percent(Law::Sound, &scene))
                ),
                number_verdict(near(least, most, 1e-9), false),
                "after a rise over the first millimetre, which every real one has",
            )
        },
    },
    Claim {
        id: "5.1.2-inertia",
        place: "5.1.2",
        says: "the mechanism's inertia plays a significant role during impact",
        opens: Opens::Preset("concept-emergent-four-bar"),
        check: |lab| {
            let (without, with_it) =
                (lab.percent(Law::Sound, &concept(EMERGENT)), lab.percent(Law::Sound, &weighed()));
            found(
                format!(
                    "emergent four-bar: {} massless, {} with its beams' mass",
                    pc(without),
                    pc(with_it)
                ),
                trend_verdict(with_it > without + 10.0),
                "two titanium beams of Table 9.3 move like 15 projectiles with the plate",
            )
        },
    },
    Claim {
        id: "5.1.3-release",
        place: "5.1.3",
        says: "a deflected mechanism releases its energy as accelerated motion",
        opens: Opens::Preset("concept-cocked-cantilever"),
        check: |lab| {
            let [cocked, not] = cocked_and_not(lab, COCKED_BEAM);
            found(
                format!(
                    "the plate has {} at first arrest cocked by 25 mm, {} uncocked",
                    unit(cocked.1, "m/s"),
                    unit(not.1, "m/s")
                ),
                trend_verdict(cocked.1 > not.1),
                "the spring pushes the plate along with the shot",
            )
        },
    },
    Claim {
        id: "5.1.3-cocked",
        place: "5.1.3 against Table 5.1",
        says: "accelerated elements satisfy transfer rate minimization, too",
        opens: Opens::Nothing,
        check: |_| {
            let rate = PRINCIPLES.iter().find(|it| it.name == "Transfer rate minimization");
            let listed = rate.is_some_and(|it| it.functions.contains(&AcceleratedElements));
            let stiffness = rate.is_some_and(|it| it.functions.contains(&ControlledStiffness));
            read(
                format!(
                    "in Table 5.1: accelerated elements {listed}, controlled stiffness {stiffness}"
                ),
                misprint_verdict(listed, stiffness),
                "the table leaves the function out that the text names",
            )
        },
    },
    Claim {
        id: "5.1.3-yaw",
        place: "5.1.3, 4.4.3",
        says: "cocked elements that turn the plate could make the projectile yaw",
        opens: Opens::Nothing,
        check: |_| {
            found(
                String::new(),
                Verdict::Unchecked,
                "the projectile stays straight in the thesis's model, whose equations know no yaw",
            )
        },
    },
    Claim {
        id: "5.1.4-all",
        place: "5.1.4 against Table 5.1",
        says: "arrays could satisfy all the principles of Table 4.1",
        opens: Opens::Preset("array-lateral"),
        check: |_| {
            let own = served_by(LateralArray);
            let any = PRINCIPLES.iter().all(|it| !it.functions.is_empty());
            read(
                format!("Table 5.1 gives lateral arrays {own} of {}", PRINCIPLES.len()),
                number_verdict(own == PRINCIPLES.len(), any),
                "the others are their elements' own doing, not the array's",
            )
        },
    },
    Claim {
        id: "6.2-functions",
        place: "6.2",
        says: "each concept supplies one or more of the functions",
        opens: Opens::Nothing,
        check: |_| {
            let counts = SUPPLIED.map(<[Function]>::len);
            let told: Vec<String> = counts.iter().map(usize::to_string).collect();
            read(
                format!("{} functions", told.join(", ")),
                number_verdict(counts.iter().all(|count| *count > 0), false),
                "in the order of sections 6.2.1 to 6.2.7",
            )
        },
    },
    Claim {
        id: "6.2-depth",
        place: "6.1, 6.2",
        says: "the concepts satisfy the principles: each reduces penetration",
        opens: Opens::Preset("concept-emergent-four-bar"),
        check: |lab| {
            let shares = CONCEPT_SCENES.map(|(_, scene)| lab.percent(Law::Sound, &scene()));
            let told = shares.map(pc);
            found(
                format!("{} of the fixed plate's, in the order of 6.2", told.join(", ")),
                trend_verdict(shares.iter().all(|share| *share < 90.0)),
                "by the plate's lightness (gamma = 1) far more than by what carries it; dimensions are assumed, beams weigh \
                 nothing",
            )
        },
    },
    Claim {
        id: "6.2.2-similar",
        place: "6.2.2",
        says: "the buckling cantilever behaves like the buckling four-bar, but resists rotation less",
        opens: Opens::Preset("concept-buckling-cantilever"),
        check: |lab| {
            let scenes = [concept(BUCKLING_BAR), free_strips()];
            let shares = scenes.each_ref().map(|scene| lab.percent(Law::Sound, scene));
            let travels = scenes.each_ref().map(|scene| lab.travel_mm(Law::Sound, scene));
            found(
                format!(
                    "the same strips clamped, and free at one end: {} and {} of depth, {} and {} mm of travel",
                    pc(shares[0]),
                    pc(shares[1]),
                    number(travels[0]),
                    number(travels[1])
                ),
                trend_verdict(near(travels[1], travels[0], 0.5)),
                "Euler's load of a free end is a sixteenth: it carries next to nothing",
            )
        },
    },
    Claim {
        id: "6.2.3-cocked",
        place: "6.2.3",
        says: "releasing the cocked four-bar lowers the relative velocity and the resistance to the shot",
        opens: Opens::Preset("concept-cocked-four-bar"),
        check: |lab| {
            let [cocked, not] = cocked_and_not(lab, COCKED_BAR);
            found(
                format!("{} of depth cocked by 5 mm, {} uncocked", pc(cocked.0), pc(not.0)),
                trend_verdict(cocked.0 < not.0),
                "the preload pulls the plate away from the shot",
            )
        },
    },
    Claim {
        id: "6.2.4-cocked",
        place: "6.2.4",
        says: "so does the cocked cantilever",
        opens: Opens::Preset("concept-cocked-cantilever"),
        check: |lab| {
            let [cocked, not] = cocked_and_not(lab, COCKED_BEAM);
            found(
                format!("{} of depth cocked by 25 mm, {} uncocked", pc(cocked.0), pc(not.0)),
                trend_verdict(cocked.0 < not.0),
                "as long as the beam's own mass is neglected",
            )
        },
    },
    Claim {
        id: "6.2.5-energy",
        place: "6.2.5",
        says: "a bistable shuttle can hold much energy, and little force releases it",
        opens: Opens::Preset("concept-bistable-shuttle"),
        check: |_| {
            let spring = Mechanism::of(&concept(SHUTTLE)).spring;
            let freed = spring.energy(0.0) - spring.energy(0.03);
            let force = (1..400).map(|i| spring.force(1e-5 * f64::from(i))).fold(0.0, larger);
            found(
                format!("{} set free over 30 mm by {}", unit(freed, "J"), unit(force, "N")),
                trend_verdict(freed > force * 0.03),
                "in a cubic with stable positions 30 mm apart and the barrier 4 mm from the first",
            )
        },
    },
    Claim {
        id: "6.2.5-soft",
        place: "6.2.5",
        says: "it gives a low stiffness at first during impact",
        opens: Opens::Preset("concept-bistable-shuttle"),
        check: |lab| {
            let (shuttle, free) = (
                lab.percent(Law::Sound, &concept(SHUTTLE)),
                lab.percent(Law::Sound, &with(&[("k", 0.0)])),
            );
            found(
                format!("{} of depth; a plate on nothing {}", pc(shuttle), pc(free)),
                trend_verdict(near(shuttle, free, 0.01)),
                "so low that it does nothing: the energy comes when the contact is over",
            )
        },
    },
    Claim {
        id: "6.2.6-tube",
        place: "6.2.6",
        says: "a notched tube buckles in a controlled way under the plate",
        opens: Opens::Preset("concept-buckling-tube"),
        check: |lab| {
            let run = lab.run_with(Law::Sound, &concept(TUBE), true);
            let most = run.series.iter().map(|row| row.spring_force_n).fold(0.0, larger);
            found(
                format!(
                    "never more than {} on the mount, {} mm of travel",
                    unit(most, "N"),
                    number(1e3 * run.max_plate_displacement_m.unwrap_or(f64::NAN))
                ),
                trend_verdict(most <= 8e3 * (1.0 + 1e-9)),
                "the force is bounded where a spring's is not; here it springs back, a real fold stays",
            )
        },
    },
    Claim {
        id: "6.2.7-functions",
        place: "6.2.7",
        says: "the helical spring supplies accelerated elements, controlled stiffness, lateral array",
        opens: Opens::Preset("concept-helical-spring"),
        check: |_| {
            let listed = SUPPLIED[HELICAL];
            let (cocked, turned) =
                (listed.contains(&AcceleratedElements), listed.contains(&PlateOrientation));
            read(
                format!(
                    "accelerated elements listed: {cocked}; plate orientation listed: {turned}"
                ),
                misprint_verdict(turned, cocked),
                "the section describes a plate that turns and nothing that is cocked: orientation is meant (Table 5.1)",
            )
        },
    },
    Claim {
        id: "6.2.7-rotation",
        place: "6.2.7",
        says: "its plate turns as it yields and takes up kinetic energy",
        opens: Opens::Preset("concept-helical-spring"),
        check: |lab| {
            let run = lab.run(Law::Sound, &concept(HELICAL));
            let turning = run.mechanism.rotation_j.unwrap_or(f64::NAN);
            found(
                format!("{} of 147.5 J in the rotation, at most", unit(turning, "J")),
                trend_verdict(turning > 1.0),
                "a plate of 20.7 mm that turns by 60 rad per metre; what it does to depth is row 4.4.4-rotation",
            )
        },
    },
    Claim {
        id: "6.2.8-table",
        place: "6.2.8",
        says: "Table 4.1 shows what arrays offer",
        opens: Opens::Nothing,
        check: |_| {
            let in_4_1 = PRINCIPLES.iter().any(|it| it.name.to_lowercase().contains("array"));
            read(
                format!(
                    "arrays in Table 4.1: {in_4_1}; principles they serve in Table 5.1: {}",
                    served_by(LateralArray)
                ),
                misprint_verdict(in_4_1, has_table("5.1") && served_by(LateralArray) > 0),
                "Table 5.1 is meant",
            )
        },
    },
    Claim {
        id: "6.2.8-lateral",
        place: "6.2.8, Figure 6.9",
        says: "elements coupled side by side resist better than one",
        opens: Opens::Preset("array-lateral"),
        check: |lab| {
            let [one, three] =
                [concept(HELICAL), lateral()].map(|scene| lab.percent(Law::Sound, &scene));
            let [far, near_by] =
                [concept(HELICAL), lateral()].map(|scene| lab.travel_mm(Law::Sound, &scene));
            found(
                format!(
                    "one helical spring {} and {} mm, three {} and {} mm",
                    pc(one),
                    number(far),
                    pc(three),
                    number(near_by)
                ),
                trend_verdict(three < one),
                "they share the motion, but three plates yield more slowly than one: the hole is deeper",
            )
        },
    },
    Claim {
        id: "6.2.8-stack",
        place: "6.2.8, Figure 6.9",
        says: "elements stacked upward combine spacing with the rest",
        opens: Opens::Preset("array-stacked"),
        check: |lab| {
            let run = lab.run(Law::Sound, &spaced());
            let in_all =
                run.stack.as_ref().and_then(|stack| stack.penetration_m).unwrap_or(f64::NAN);
            let solid = rigid(with(&[("v_i", 250.0), ("h", 0.019)]));
            let left = lab.run(Law::Sound, &solid).residual_velocity_m_s;
            found(
                format!(
                    "250 m/s: stopped after {} of 19 mm in three elements and a base; a solid plate of 19 mm lets {} through",
                    mm(in_all),
                    unit(left.unwrap_or(0.0), "m/s")
                ),
                trend_verdict(in_all < 0.019 && left.is_some()),
                "each element is thrown at gamma = 1; springs and their mass are not in the 19 mm",
            )
        },
    },
];
