//! Charts, maps and their readouts: what is drawn, where the cursor stands, how numbers are written.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::bench::{Bench, done};
use super::{limit, search, stability};
use cmra::tui::message::Message;
use cmra::tui::pages::run;
use cmra::tui::theme::GlyphSet;
use cmra::worker::studies::StudyResult;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_studies::study::stability::map::{Cell, FixedStep, MapVariable};

#[test]
fn letters_of_events_stay_beside_pinned_runs() {
    let mut bench = Bench::ascii(100, 40);
    bench.keys(" jjl");
    let marked = |screen: &str| {
        screen
            .lines()
            .any(|line| line.contains(" a ") || line.contains("a|") || line.contains("*a"))
    };
    assert!(marked(&bench.screen()), "{}", bench.screen());
}

#[test]
fn no_two_charts_show_the_same_quantity() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("<Tab>z");
    for _ in 0..9 {
        bench.keys("v");
        let mut shown: Vec<&str> =
            bench.app.pages.run.charts.quantities.iter().map(|it| it.title()).collect();
        shown.sort_unstable();
        shown.dedup();
        assert_eq!(shown.len(), 3);
    }
}

#[test]
fn values_on_the_screen_have_six_digits_at_the_most() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/gamma<Enter><Enter>1/3<Enter>");
    let label = &bench.app.history.edits[0].label;
    assert_eq!(label, "gamma 1 -> 0.333333");
}

/// The line of a goal stands at its own value, not at that of the nearest label.
#[test]
fn a_goal_line_stands_at_its_value() {
    for size in [(60, 16), (80, 24), (120, 36)] {
        let mut bench = Bench::ascii(size.0, size.1);
        bench.press("4");
        search::answer(&mut bench);
        bench.press("<Tab>");
        let screen = bench.screen();
        let line = screen.lines().find(|line| line.contains("goal 60 %")).expect("a goal line");
        let axis = line.find(['+', '|']).map_or("", |_| line);
        let other = ["50+", "70+", "40+", "80+"].iter().any(|label| axis.contains(label));
        assert!(!other && (axis.contains(" 60+") || !axis.contains('+')), "{size:?}: {screen}");
    }
}

/// The map grows row by row; its labels are equally far apart and have a unit.
#[test]
fn the_map_of_stability_grows_and_its_labels_are_regular() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("55");
    let study = bench.studies().pop().expect("a map");
    let mut map = stability::map(FixedStep::Thesis, MapVariable::K);
    let (columns, _) = map.counts();
    map.cells.iter_mut().skip(10 * columns).for_each(|cell| *cell = Cell::Waiting);
    bench.part(study.id, (10, 19), StudyResult::from(map));
    let screen = bench.screen();
    assert!(screen.contains("computing the map: 10 of 19 rows"), "{screen}");
    assert!(screen.contains("____") && screen.contains("k [N/m^n]"), "{screen}");
    stability::answer(&mut bench);
    for size in [(60, 16), (80, 24), (120, 40)] {
        let mut bench = stability::open(GlyphSet::Ascii, size);
        bench.send(Message::Resize(size.0, size.1));
        let screen = bench.screen();
        let labels: Vec<(usize, i32)> = screen
            .lines()
            .enumerate()
            .filter_map(|(row, line)| {
                let first = line.trim_start_matches('|').trim_start().split('+').next()?;
                Some((row, first.strip_prefix("1e")?.parse().ok()?))
            })
            .collect();
        assert!(labels.len() >= 3, "{screen}");
        let apart: Vec<i32> = labels.windows(2).map(|pair| pair[0].1 - pair[1].1).collect();
        assert!(apart.iter().all(|step| *step == apart[0]), "{screen}");
    }
}

/// The curve and the map of the Limit tab are high enough to be read at 80 by 24.
#[test]
fn the_charts_of_the_limit_tab_can_be_read() {
    let bench = limit::open_residual(GlyphSet::Ascii, (80, 24));
    let screen = bench.screen();
    let rows = screen.lines().skip_while(|line| !line.contains("Residual velocity"));
    let rows = rows.take_while(|line| !line.starts_with("+--")).count();
    assert!(rows >= 10, "{screen}");
}

#[test]
fn charts_and_sentences_spell_microseconds_alike() {
    let mut bench = Bench::open(GlyphSet::Braille, (120, 40));
    bench.keys("<Tab>l");
    let screen = bench.screen();
    assert!(screen.contains(" us ") && !screen.contains('µ'), "{screen}");
}

#[test]
fn the_map_of_mass_efficiency_names_its_axis_across() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("3");
    limit::answer(&mut bench);
    let screen = bench.screen();
    let below = screen.lines().skip_while(|line| !line.contains("Mass efficiency, up: gamma"));
    assert!(below.clone().any(|line| line.contains(" v_i [")), "{screen}");
}

#[test]
fn differences_to_a_pin_have_six_digits() {
    let mut bench = Bench::ascii(120, 36);
    bench.keys("/gamma<Enter><Enter>0.9860000000000001<Enter> <Enter>1<Enter>");
    bench.keys("<Tab><Tab>");
    let text = bench.message();
    assert!(text.contains("gamma 0.986 -> 1"), "{text}");
}

/// With dishing the law holds up to h/D of about 1: the first plate is thin enough, the one behind it, which is struck, is not.
#[test]
fn a_plate_of_a_stack_behind_the_first_marks_its_variable() {
    let mut scene = Scene::default();
    (scene.target.thickness_m, scene.projectile.velocity_m_s) = (0.004, 400.0);
    scene.stack.base_thickness_m = Some(0.0254);
    let scene = Arc::new(scene);
    let mut bench = Bench::ascii(120, 40);
    bench.app.scene = Arc::clone(&scene);
    bench.press("r");
    bench.send(Message::RunDue(bench.app.jobs.serial));
    let is_marked = |bench: &Bench| {
        let screen = bench.screen();
        let row = screen.lines().find(|line| line.contains(" thickness ")).expect("the row of h");
        row.contains("! 4 mm")
    };
    assert!(!is_marked(&bench), "{}", bench.screen());
    let job = bench.jobs().remove(0);
    let run = simulate(&scene, &Settings::default(), &mut |_| ControlFlow::Continue(()));
    bench.reply(job.id, done(run.unwrap()));
    assert!(is_marked(&bench), "{}", bench.screen());
}

#[test]
fn very_small_and_large_values_keep_to_their_columns_in_the_table_of_runs() {
    for size in [(80, 24), (120, 40), (160, 45)] {
        let mut bench = Bench::ascii(size.0, size.1);
        let mut shown = bench.app.shown.clone().unwrap();
        let run = Arc::make_mut(&mut shown.run);
        run.max_plate_displacement_m = Some(9.178e-13);
        run.penetration.final_m = Some(12_345.678);
        run.peak_contact_force_n = Some(1.234_5e-9);
        bench.app.shown = Some(shown);
        bench.app.focus_on(run::RUNS);
        let screen = bench.screen();
        let line = screen.lines().find(|line| line.contains("*now")).unwrap();
        let cells: Vec<&str> = line.split(['|', ' ']).collect();
        // Each number stands by itself.
        for wanted in [1.234_567_8e7, 9.178e-10_f64] {
            let found = cells.iter().filter_map(|cell| cell.parse::<f64>().ok());
            let near = |value: f64| (value / wanted - 1.0).abs() < 0.05;
            assert!(found.into_iter().any(near), "{size:?} {wanted}: {line}");
        }
    }
}
