//! The first screen on scenes that differ in kind from the baseline: what it has to say of each stands in words that a test reads,
//! and the whole screen is kept as a picture. The runs are real ones; their cost is made up.

use std::ops::ControlFlow;
use std::sync::Arc;

use cmra::files::preset;
use cmra::tui::message::Message;
use cmra::tui::theme::GlyphSet;
use cmra_engine::model::run::{EstimateBasis, Run};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{RunSnapshot, Settings, simulate_beside_plastic};
use cmra_engine::model::variables::set_by_name;
use insta::assert_snapshot;

use super::bench::{Bench, done};

/// The run of a scene as the worker computes it.
fn real(scene: &Arc<Scene>) -> Run {
    let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
    let took_s = &mut || 0.0;
    let mut run =
        simulate_beside_plastic(scene, &Settings::SERIES, took_s, go_on).expect("a valid scene");
    // What depends on the method and the machine is not what these pictures are about.
    run.cost.took_s = None;
    run.estimate.main = Some(4e-15);
    run.estimate.basis = Some(EstimateBasis::SecondComputation);
    run.omitted = vec!["damper", "stop"];
    run
}

/// Answer every run that was requested with the real one.
fn answer(bench: &mut Bench) {
    loop {
        let jobs = bench.jobs();
        if jobs.is_empty() {
            return;
        }
        for job in jobs {
            bench.reply(job.id, done(real(&job.scene)));
        }
    }
}

/// The workbench on the baseline with changes, with its run on the screen.
fn shown(changes: &[(&str, &str)], size: (u16, u16)) -> Bench {
    let mut scene = preset::baseline().expect("bundled").scene;
    for (name, value) in changes {
        set_by_name(&mut scene, name, value).expect("a valid change");
    }
    let mut bench = Bench::closed(GlyphSet::Ascii, size);
    bench.app.scene = Arc::new(scene);
    bench.app.base.scene = Arc::clone(&bench.app.scene);
    bench.press("r");
    answer(&mut bench);
    bench.send(Message::Resize(size.0, size.1));
    // The warnings of the run have been read.
    bench.press("k");
    bench
}

/// The screen of a changed baseline at 80x24 has these words.
fn has(changes: &[(&str, &str)], words: &[&str]) -> String {
    let screen = shown(changes, (80, 24)).screen();
    for words in words {
        assert!(screen.contains(words), "{words}: {screen}");
    }
    screen
}

/// Another program has the same depth, displacement, force and depth by the plastic law (`values.rs`).
#[test]
fn valid_the_three_numbers_of_the_baseline_stand_at_every_size() {
    for size in [(60, 16), (80, 24), (100, 30), (120, 36), (160, 48)] {
        let screen = shown(&[], size).screen();
        for words in ["4.572", "64", "38.38", "17.74", "arrested", "error < 4e-15, 210 us"] {
            assert!(screen.contains(words), "{size:?} {words}: {screen}");
        }
    }
    assert_snapshot!("baseline_160x48", shown(&[], (160, 48)).screen());
    assert_snapshot!("baseline_60x16", shown(&[], (60, 16)).screen());
    assert_snapshot!("baseline_80x24", has(&[], &["5.269 (74)", "64 % of rigid mount"]));
}

#[test]
fn a_perforation_ends_at_the_rear_face_and_has_no_percentage() {
    let words = ["through, leaves at 279.9 m/s", " 31.8+", " h |", "perforated     through"];
    let screen = has(&[("v_i", "400")], &words);
    assert!(!screen.contains("% of rigid"), "{screen}");
    assert_snapshot!(screen);
}

#[test]
fn a_cocked_plate_shows_its_stroke_and_what_the_plastic_law_gives() {
    let words = ["plastic: through, back at 20.8 m/s", "stroke 1.003 m", " -500+", " 503+"];
    assert_snapshot!(has(&[("d", "0.5")], &words));
}

#[test]
fn a_rigid_mount_leaves_its_rows_to_the_other_charts() {
    let screen = has(&[("mount", "rigid")], &["Plate displacement: plate held", "mount rigid"]);
    assert_snapshot!(screen);
}

#[test]
fn a_stop_is_a_line_and_asks_too_much_of_a_fused_interface() {
    let words = ["unbounded at the stop", "plastic: 5.799 mm", " stop*", "greatest 10.00 mm"];
    assert_snapshot!(has(&[("x_stop", "10mm")], &words));
}

/// Bodies of equal mass share the momentum: half the velocity.
#[test]
fn valid_a_free_plate_leaves_at_the_common_velocity() {
    let screen = has(&[("k", "0")], &["leaves at 50.0 m/s, no greatest"]);
    assert_snapshot!(screen);
}

#[test]
fn a_plate_that_a_stiff_law_holds_is_said_to_be_held() {
    let screen = has(&[("n", "0.1")], &[" nm, held"]);
    assert_snapshot!(screen);
}

#[test]
fn a_depth_that_changes_much_later_is_said_beside_the_first() {
    has(&[("interface", "plastic")], &["4.572 mm, later 5.269 mm (74 %)", "interface plastic"]);
}

#[test]
fn two_pins_take_the_row_of_the_hint_and_one_of_the_displacement() {
    let mut bench = shown(&[], (80, 24));
    bench.press(" l");
    answer(&mut bench);
    bench.press(" h");
    answer(&mut bench);
    let screen = bench.screen();
    for words in ["A = now", "oA   thesis-baseline", "+B   gamma=1.1", "C_d    drag"] {
        assert!(screen.contains(words), "{words}: {screen}");
    }
    assert_snapshot!(screen);
}

/// Enter shows the selected chart alone and back; `c` shows the other part of its time, and the footer says so.
#[test]
fn a_chart_is_enlarged_and_shows_the_contact_or_all() {
    let mut bench = shown(&[], (80, 24));
    assert!(bench.screen().contains("c/z chart"), "{}", bench.screen());
    bench.press("<Tab>jj");
    assert!(bench.screen().contains("Enter enlarge  c contact/whole"), "{}", bench.screen());
    bench.press("<Enter>c");
    let screen = bench.screen();
    assert!(screen.contains("Plate displacement: greatest 38.38 mm"), "{screen}");
    assert!(!screen.contains("Penetration") && screen.contains(" us +"), "{screen}");
    bench.press("<Enter>c");
    assert!(bench.screen().contains("Penetration"), "{}", bench.screen());
}

/// A variable keeps the unit it was typed in; a bare number has the unit that stands beside it.
#[test]
fn values_are_shown_as_they_were_typed() {
    let mut bench = shown(&[], (80, 24));
    let mut set = |text: &str| {
        bench.press(&format!("/h<Enter><Enter>{text}<Enter><Esc>"));
        answer(&mut bench);
        (bench.app.scene.target.thickness_m, bench.screen())
    };
    for (text, thickness_m, shown) in
        [("12", 0.012, " 12 mm "), ("1in", 0.0254, " 1 in "), ("0.5", 0.0127, " 0.5 in ")]
    {
        let (is, screen) = set(text);
        assert!((is - thickness_m).abs() < 1e-15, "{text}: {is}");
        assert!(screen.contains(shown), "{shown}: {screen}");
    }
}

/// Unused variables stay in the list and can be set; a search unfolds hidden ones.
#[test]
fn unused_variables_stay_in_the_list_and_more_unfolds() {
    let mut bench = shown(&[("closure", "double-yield")], (80, 24));
    assert!(bench.screen().contains("  S_y    strength"), "{}", bench.screen());
    assert!(bench.screen().contains(", 1 changed"), "{}", bench.screen());
    bench.press("/S_y<Enter>");
    assert!(bench.message().contains("S_y (no effect here)"), "{}", bench.message());
    bench.press("<Esc>/C_d<Enter><Esc>j");
    assert!(bench.screen().contains("+- More: "), "{}", bench.screen());
}
