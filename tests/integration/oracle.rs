//! Whole runs against an independent reading of the law, which knows no modes, no events and no Taylor series (the package `cmra-oracle`).
//!
//! Random moderate scenes, which equal tiny steps resolve, are stepped from first contact to a horizon, at two step sizes. The
//! program has to be where they are at its own times, within a few times their difference, and what it says of all time to come, run
//! without a horizon, must not be contradicted up to there.

use cmra_engine::model::run::{EndReason, EventKind, Outcome, Run, Sample};
use cmra_engine::model::scene::{ContactModel, Scene};
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_oracle::Shot;

use crate::random::Random;
use crate::support::scene;

mod corrected;
pub(crate) mod draw;
mod stack;

/// The coarser step, s; the finer is half as long.
const STEP_S: f64 = 4e-8;
/// Part of it with which a disagreement is looked at again.
const FINER: f64 = 0.1;
/// Differences of the two step sizes that the finer is taken to be off by.
const OFF: f64 = 5.0;
/// Absolute tolerance of a disagreement, m.
const FLOOR_M: f64 = 3e-8;
const FLOOR: f64 = 1e-6;
/// A scene whose steps differ by more than this says little, m.
const BLUNT_M: f64 = 1e-6;
/// Rows of the program's series that are compared.
const ROWS: usize = 50;

/// Results for one step size.
struct Stepped<'a> {
    /// Depth, displacement of the projectile and of the plate at each time requested, m.
    rows: Vec<[f64; 3]>,
    shot: Shot<'a>,
    /// Whether the oracle reached the last time.
    arrived: bool,
}

impl<'a> Stepped<'a> {
    fn new(scene: &'a Scene, step_s: f64, times: &[f64]) -> Self {
        let mut shot = Shot::new(scene, step_s);
        let start = shot.place()[2];
        let mut arrived = true;
        let rows = times.iter().map(|t_s| {
            arrived = shot.go_to(*t_s);
            let [depth, travel, plate] = shot.place();
            [depth, travel + (plate - start) * scene.cos_obliquity(), plate]
        });
        let rows = rows.collect();
        Self { rows, shot, arrived }
    }
}

/// A horizon's run of the program beside both step sizes.
struct Beside<'a> {
    run: Run,
    /// The rows of the run that are compared.
    rows: Vec<Sample>,
    coarse: Stepped<'a>,
    fine: Stepped<'a>,
    /// Greatest difference of the two step sizes, m.
    blunt_m: f64,
}

fn program(scene: &Scene) -> Run {
    let scene = std::sync::Arc::new(scene.clone());
    simulate(&scene, &Settings::SERIES, &mut |_| std::ops::ControlFlow::Continue(())).unwrap()
}

/// Rows where nothing jumps, evenly among all.
fn quiet_rows(run: &Run) -> Vec<Sample> {
    let quiet =
        run.series.windows(3).filter(|rows| rows[0].t_s < rows[1].t_s && rows[1].t_s < rows[2].t_s);
    let quiet: Vec<Sample> = quiet.map(|rows| rows[1]).collect();
    (0..ROWS).filter_map(|i| quiet.get(i * quiet.len() / ROWS)).copied().collect()
}

impl<'a> Beside<'a> {
    fn new(scene: &'a Scene, step_s: f64) -> Self {
        let run = program(scene);
        let rows = quiet_rows(&run);
        let mut times: Vec<f64> = rows.iter().map(|row| row.t_s).collect();
        times.push(scene.run.horizon_s.unwrap());
        let [coarse, fine] =
            [step_s, 0.5 * step_s].map(|step_s| Stepped::new(scene, step_s, &times));
        let pairs = coarse.rows.iter().flatten().zip(fine.rows.iter().flatten());
        let blunt_m = pairs.map(|(coarse, fine)| (coarse - fine).abs()).fold(0.0, f64::max);
        Self { run, rows, coarse, fine, blunt_m }
    }

    /// Whether a value of the program is what the steps give, of which the same is read from both.
    fn agrees(&self, value: f64, of: impl Fn(&Shot<'_>) -> f64) -> bool {
        let (coarse, fine) = (of(&self.coarse.shot), of(&self.fine.shot));
        (value - fine).abs() <= OFF * (coarse - fine).abs() + FLOOR * fine.abs() + self.room_m()
    }

    fn room_m(&self) -> f64 {
        FLOOR_M + OFF * self.blunt_m
    }

    /// Everything in which the two differ.
    fn complaints(&self) -> Vec<String> {
        let mut found = Vec::new();
        let mut off_m: f64 = 0.0;
        for ((row, coarse), fine) in self.rows.iter().zip(&self.coarse.rows).zip(&self.fine.rows) {
            let told = [row.penetration_m, row.projectile_displacement_m, row.plate_displacement_m];
            let pairs = coarse.iter().zip(fine);
            off_m = pairs.map(|(coarse, fine)| (coarse - fine).abs()).fold(off_m, f64::max);
            let missed = told.iter().zip(fine).map(|(told, fine)| (told - fine).abs());
            // `max` passes over the depth of a model that knows none.
            if missed.fold(0.0, f64::max) > FLOOR_M + OFF * off_m {
                found.push(format!(
                    "at {:e} s, {}: {told:?}, not {fine:?}",
                    row.t_s,
                    row.mode.word()
                ));
                break;
            }
        }
        self.compare_milestones(&mut found);
        self.compare_ends(&self.run, "", &mut found);
        if !self.run.end.is_complete() {
            found.push(format!("{:?}", self.run.end));
        }
        found
    }

    /// First arrest and exit: whether, when, where, how fast.
    fn compare_milestones(&self, found: &mut Vec<String>) {
        let (run, shot) = (&self.run, &self.fine.shot);
        let both = |of: fn(&Shot<'_>) -> bool| of(&self.coarse.shot) && of(shot);
        if run.first_arrest.is_some() != shot.first_arrest.is_some() {
            found.push(format!("first arrest {:?}, not {:?}", run.first_arrest, shot.first_arrest));
        } else if let Some(arrest) =
            run.first_arrest.filter(|_| both(|shot| shot.first_arrest.is_some()))
        {
            let fits = self.agrees(arrest.t_s, |shot| shot.first_arrest.unwrap().0)
                && self.agrees(arrest.penetration_m, |shot| {
                    shot.depth_m(shot.first_arrest.unwrap().1[0])
                })
                && self.agrees(arrest.plate_displacement_m, |shot| shot.first_arrest.unwrap().1[2]);
            if !fits {
                found.push(format!("first arrest {arrest:?}, not {:?}", shot.first_arrest));
            }
        }
        if run.departure.exit_time_s.is_some() != shot.exit.is_some() {
            found.push(format!("exit {:?}, not {:?}", run.departure.exit_time_s, shot.exit));
        } else if let Some(t_s) =
            run.departure.exit_time_s.filter(|_| both(|shot| shot.exit.is_some()))
        {
            let left = run.departure.residual_velocity_m_s.unwrap();
            let fits = self.agrees(t_s, |shot| shot.exit.unwrap().0)
                && (self.agrees(left, |shot| shot.velocity_m_s(shot.exit.unwrap().1))
                    || left.abs() < 1e-3);
            if !fits {
                found.push(format!("exit {t_s} {left}, not {:?}", shot.exit));
            }
        }
    }

    /// The outcome, the depth and the greatest displacement of a run, at the horizon or at the end.
    fn compare_ends(&self, run: &Run, when: &str, found: &mut Vec<String>) {
        let shot = &self.fine.shot;
        let (deepest, farthest) = (shot.hole_m(), shot.farthest_m);
        let decided_s = run.series.last().map_or(f64::INFINITY, |row| row.t_s);
        let is_out = shot.state[0] < -self.room_m();
        let is_told = run.scene.contact.model == ContactModel::Hydrodynamic
            && shot.exit.is_none()
            && decided_s < shot.t_s;
        if is_told && run.outcome == Outcome::Arrested && is_out {
            found.push(format!("{when}{:?}, but {:?} at {} s", run.outcome, shot.state, shot.t_s));
        }
        if is_told && run.outcome == Outcome::Separated && shot.state[0] > self.room_m() {
            found.push(format!("{when}{:?}, but {:?} at {} s", run.outcome, shot.state, shot.t_s));
        }
        if shot.exit.is_some() && matches!(run.outcome, Outcome::Arrested | Outcome::Separated) {
            found.push(format!("{when}{:?}, not perforated", run.outcome));
        } else if let Some(depth) = run.penetration.final_m.filter(|_| shot.exit.is_none())
            && run.outcome != Outcome::Perforated
            && depth < deepest - self.room_m()
        {
            found.push(format!("{when}{depth} deep, not {deepest}"));
        }
        if run.max_plate_displacement_m.is_some_and(|far| far < farthest - self.room_m()) {
            found.push(format!("{when}{:?} far, not {farthest}", run.max_plate_displacement_m));
        }
    }
}

/// In what the program, on its way to the horizon and for good, differs from the steps; whether these say much; and the run.
fn compare(pairs: &str) -> (Vec<String>, bool, Option<Run>) {
    let first = compare_at(pairs, STEP_S);
    // Two coarse steps may agree by chance.
    if first.0.is_empty() { first } else { compare_at(pairs, FINER * STEP_S) }
}

fn compare_at(pairs: &str, step_s: f64) -> (Vec<String>, bool, Option<Run>) {
    let own = draw::read(pairs);
    if !Shot::new(&own, step_s).go_to(own.run.horizon_s.unwrap()) {
        // It rattles: the events are too many to compare.
        return (Vec::new(), false, None);
    }
    let beside = Beside::new(&own, step_s);
    if !(beside.coarse.arrived && beside.fine.arrived) {
        return (Vec::new(), false, None);
    }
    let mut found = beside.complaints();
    let mut open = own.clone();
    open.run.horizon_s = None;
    let for_good = program(&open);
    if for_good.end == EndReason::Decided {
        beside.compare_ends(&for_good, "for good: ", &mut found);
    }
    (found, beside.blunt_m < BLUNT_M, Some(beside.run))
}

/// Random scenes of one sort: none contradicts the steps, and most of the steps say much. Gives the kinds of events that were met.
fn compare_many(
    of: fn(&mut Random) -> String,
    (scenes, seed): (usize, u64),
) -> std::collections::HashSet<String> {
    let mut random = Random(seed);
    let (mut sharp, mut told) = (0, Vec::new());
    let mut kinds = std::collections::HashSet::new();
    for _ in 0..scenes {
        let pairs = of(&mut random);
        let (found, is_sharp, run) = compare(&pairs);
        sharp += usize::from(is_sharp);
        kinds.extend(
            run.iter().flat_map(|run| &run.events).map(|event| event.kind.words().to_owned()),
        );
        for complaint in found {
            told.push(format!("{pairs}\n    {complaint}\n"));
        }
    }
    assert!(told.is_empty(), "{}", told.concat());
    assert!(100 * sharp > 95 * scenes, "{sharp} of {scenes} say something");
    kinds
}

/// Asserts agreement on a scene; returns the program's run, unless it chatters.
#[track_caller]
fn agree(pairs: &str) -> Option<Run> {
    let (found, _, run) = compare(pairs);
    assert!(found.is_empty(), "{pairs}: {found:?}");
    run
}

#[test]
fn valid_random_scenes_against_tiny_steps_of_the_law_itself() {
    let kinds = compare_many(draw::plain, (150, 2_007));
    assert!(kinds.len() >= 13, "{kinds:?}");
}

#[test]
fn valid_random_plates_that_move_at_first_contact_against_tiny_steps() {
    compare_many(draw::moving, (60, 4_032));
}

#[test]
fn valid_random_plugs_against_tiny_steps() {
    let kinds = compare_many(draw::plugged, (120, 7_009));
    assert!(kinds.contains("plug picked up") && kinds.contains("perforation"), "{kinds:?}");
}

#[test]
fn valid_random_bodies_that_fall_against_tiny_steps() {
    compare_many(draw::falling, (60, 9_008));
}

#[test]
fn valid_random_springs_of_other_kinds_against_tiny_steps() {
    let kinds = compare_many(draw::curved, (80, 6_002));
    assert!(kinds.len() >= 13, "{kinds:?}");
}

#[test]
fn valid_random_scenes_by_other_interaction_models_against_tiny_steps() {
    compare_many(draw::modelled, (60, 8_002));
}

#[test]
fn valid_random_stacks_plate_by_plate_against_tiny_steps() {
    let mut random = Random(6_208);
    let told: Vec<String> = (0..12)
        .flat_map(|_| {
            let words = draw::stacked(&mut random);
            let found = stack::compare(&words).into_iter();
            found.map(move |complaint| format!("{words}\n    {complaint}\n"))
        })
        .collect();
    assert!(told.is_empty(), "{}", told.concat());
}

/// A stop's damper pushes at once with what the interface of the joined body may be unable to carry.
#[test]
fn valid_a_damped_stop_resumes_penetration_at_once() {
    for pairs in [
        "n=1.5 k=12900 d=0.000214 gamma=0.316 v_i=38.3 h=0.0076 g=0.954 x_stop=0.00452 k_stop=2.1e8 b_stop=1560",
        "k=0 m=1.22 b=11.3 gamma=1.08 v_i=45 h=0.0126 g=1 x_stop=0.00182 k_stop=5.93e6 b_stop=59100",
        "n=2 k=443000 m=1.89 b=0.259 d=0.000375 gamma=1.24 v_i=31.6 h=0.0321 g=0.516 x_stop=0.00308 k_stop=7.53e8 b_stop=1800",
    ] {
        let pairs = format!("{pairs} interface=plastic stop_kind=elastic run.horizon_s=1e-3");
        let run = agree(&pairs);
        assert!(
            run.unwrap().events.iter().any(|event| event.kind == EventKind::Resumption),
            "{pairs}"
        );
    }
}

/// Where the joined body's swing asks for a little more than the interface carries, the projectile slips on the way forward too.
#[test]
fn valid_slips_before_the_greatest_displacement_do_not_hide_it() {
    for pairs in [
        "gamma=0.8 k=7.6e6 g=2",
        "gamma=0.8 k=7.54e6 g=2",
        "gamma=1.2 k=3.7e9 n=2 g=3",
        "gamma=0.8 k=7.6e6 g=0.1",
    ] {
        let run = agree(&format!("{pairs} interface=plastic run.horizon_s=6e-4"));
        assert!(run.unwrap().max_plate_displacement_m.is_some(), "{pairs}");
    }
    let own = scene("gamma=0.8 k=7.6e6 g=2 interface=plastic");
    let run = program(&own);
    assert_eq!(run.outcome, Outcome::Arrested);
    // After the last slip the interface just holds.
    assert!((run.interface.demand_ratio.unwrap() - 1.0).abs() < 1e-12);
    let far_m = run.max_plate_displacement_m.unwrap();
    let mut shot = Shot::new(&own, 2e-9);
    assert!(shot.go_to(3e-4));
    assert!((far_m / shot.farthest_m - 1.0).abs() < 1e-6, "{far_m}, not {}", shot.farthest_m);
}

/// A damped elastic stop touches the plate again before the plate is clear of it; a twentieth of the usual step size.
#[test]
fn valid_a_damped_elastic_stop_presses_again_a_plate_that_turns_before_it_is_clear() {
    for pairs in [
        "k=1e4 x_stop=0.000169 k_stop=1.28e8 b_stop=342 v_i=300 h=0.05",
        "k=1e4 gamma=0.3 x_stop=0.00124 k_stop=5.88e8 b_stop=2.02e3 v_i=300 h=0.05",
        "k=1e4 x_stop=0.00129 k_stop=1.7e8 b_stop=1.45e3 h=0.05",
        "k=1e5 x_stop=0.001 k_stop=1e9 b_stop=30",
        "k=1e5 x_stop=0 k_stop=1e8 b_stop=1e4",
    ] {
        let own = scene(&format!("{pairs} stop_kind=elastic"));
        let run = program(&own);
        let arrest = run.first_arrest.unwrap();
        let mut shot = Shot::new(&own, 2e-9);
        assert!(shot.go_to(1.001 * arrest.t_s), "{pairs}");
        let (t_s, state) = shot.first_arrest.unwrap();
        let near = |value: f64, exact: f64| (value / exact - 1.0).abs() <= 1e-6;
        assert!(near(arrest.penetration_m, shot.depth_m(state[0])), "{pairs}: {arrest:?}");
        assert!(near(arrest.t_s, t_s), "{pairs}: {arrest:?}, not {t_s}");
        assert!(run.ledger.residual().abs() < 1e-12, "{pairs}");
    }
}

/// A spring that presses the plate forward on an elastic stop: the swing about where they hold each other has two ends.
#[test]
fn valid_a_plate_pressed_on_an_elastic_stop_oscillates_to_its_far_end() {
    for pairs in [
        "n=2.32 k=3.03e9 m=0.5 b=140 d=0.000995 gamma=4.25 v_i=32.5 h=0.00237 x_stop=-0.000404 k_stop=135000 b_stop=7630",
        "n=1.23 k=1.29e6 d=0.0128 gamma=0.555 v_i=377 h=0.00418 dishing=false x_stop=-0.0128 k_stop=595000 b_stop=54.2",
    ] {
        let pairs = format!("{pairs} stop_kind=elastic run.horizon_s=8e-4");
        agree(&pairs);
    }
}

/// Where the stop's place is the spring's zero, the plate that leaves it passes two marks at once.
#[test]
fn valid_an_elastic_stop_at_the_zero_of_the_spring_pushes_and_never_pulls() {
    for pairs in [
        "n=2 k=1.39e9 gamma=0.441 v_i=462 h=0.00218 g=0.844 k_stop=9.03e8",
        "n=2 k=1e9 d=0.002 k_stop=1e8",
        "n=0.5 k=2e5 d=0.002 k_stop=1e8",
        "n=1 k=1e6 d=0.002 k_stop=1e8",
        "n=1.5 k=1e7 m=0.5 b=20 k_stop=3e7",
        "n=2 k=1e9 d=0.002 k_stop=1e8 b_stop=100",
        "n=2 k=1.16e8 m=0.5 b=133 d=0.000165 gamma=2.11 v_i=123 h=0.0117 k_stop=1.12e8 b_stop=562",
    ] {
        for law in ["plastic", "fused"] {
            let pairs =
                format!("{pairs} interface={law} x_stop=0 stop_kind=elastic run.horizon_s=5e-4");
            agree(&pairs);
        }
    }
}

/// Without grip the projectile stays behind where the spring's force changes its sign.
#[test]
fn valid_nothing_pulls_a_projectile_without_grip() {
    for pairs in [
        "n=2 k=1.73e8 m=1.58 d=0.0011 gamma=6 v_i=116 h=0.00394 run.horizon_s=3e-3",
        "gamma=0.327 v_i=36.5 h=0.0163 mechanism.spring.kind=bistable mechanism.spring.bistable.second_m=0.01 mechanism.spring.bistable.unstable_m=0.004 mechanism.spring.bistable.barrier_n=8000 run.horizon_s=4.29e-4",
    ] {
        agree(&format!("{pairs} interface=plastic g=0"));
    }
}

/// A plate that its spring takes off a rigid stop, with a damper that cannot be expanded at zero velocity.
#[test]
fn a_plate_that_leaves_a_rigid_stop_does_not_hit_it_at_once() {
    for pairs in [
        "n=1.02 k=2.38e6 m=1.5 b=95.2 gamma=0.266 v_i=172 h=0.0151 interface=plastic g=0.238 x_stop=0.0000276 e=0",
        "n=0.5 k=202000 m=0.61 b=177 gamma=6.43 v_i=66.8 h=0.0449 interface=plastic g=0.663 x_stop=0.0000479 e=0.177",
        "m=1.82 k=7.14e6 b=263 gamma=7.39 v_i=149 h=0.00797 interface=plastic g=0.581 x_stop=0.000215 e=0",
        "m=1.2 k=4.98e6 b=628 d=0.000351 gamma=0.519 v_i=55.8 h=0.00368 x_stop=0.000377 e=0.203",
    ] {
        let run = agree(&format!("{pairs} run.horizon_s=6e-4"));
        let events = run.unwrap().cost.events;
        assert!(events < 100, "{pairs}: {events} events");
    }
}
