//! Bars of what matters in the place of the words beside the variables.

use std::ops::ControlFlow;
use std::time::Duration;

use super::bench::{Bench, ended, stopped};
use cmra::tui::message::{Effect, Message};
use cmra::tui::pages::run::editor::Editor;
use cmra::tui::theme::GlyphSet;
use cmra::worker::studies::{RequestVariant, SearchAnswer, SearchRequest, StudyResult};
use cmra_studies::study::sensitivity::VARIABLES;
use insta::assert_snapshot;

/// A study that was asked for: its number, time and result.
fn asked(bench: &mut Bench) -> Option<(u64, Option<Duration>, StudyResult)> {
    let tasks = bench.tasks(|task| {
        let request = SearchRequest::downcast(&task.request)?.clone();
        Some((task.id, task.budget, task.scene.clone(), request))
    });
    let (id, budget, scene, request) = tasks.into_iter().last()?;
    let found = request.run(&scene, 1, &|_, _| ControlFlow::Continue(())).unwrap();
    Some((id, budget, found.into()))
}

fn with_bars(glyphs: GlyphSet, size: (u16, u16)) -> Bench {
    let mut bench = Bench::open(glyphs, size);
    bench.keys("v");
    let (id, budget, found) = asked(&mut bench).expect("a look");
    assert!(budget.is_some_and(|time| time < Duration::from_millis(200)));
    bench.reply(id, ended(found));
    bench
}

#[test]
fn a_key_turns_the_words_into_bars_and_back() {
    for (glyphs, size) in [
        (GlyphSet::Ascii, (80, 24)),
        (GlyphSet::Braille, (80, 24)),
        (GlyphSet::Braille, (60, 16)),
        (GlyphSet::Braille, (120, 36)),
    ] {
        let mut bench = with_bars(glyphs, size);
        bench.keys("j");
        bench.keys("k");
        let screen = bench.screen();
        assert_snapshot!(format!("matters_{}x{}_{glyphs}", size.0, size.1), screen);
        assert!(screen.contains("gamma 0.8 to 7: depth 4.27 to 6.49 mm; here"), "{screen}");
        assert!(!screen.contains("mass ratio"), "{screen}");
        for word in ["Travel", "Force"] {
            bench.keys("v");
            let (id, _, found) = asked(&mut bench).expect("another result");
            bench.reply(id, ended(found));
            assert!(bench.screen().contains(&format!("{word}, 0 to")), "{}", bench.screen());
        }
        bench.keys("v");
        assert!(!bench.screen().contains("Force, 0 to"), "{}", bench.screen());
        assert!(asked(&mut bench).is_none());
    }
}

/// The rests that have been begun, by their numbers.
fn rests(bench: &mut Bench) -> Vec<u64> {
    let mut found = Vec::new();
    bench.effects.retain(|effect| match effect {
        Effect::After(time, Message::Rest(serial)) => {
            assert_eq!(*time, Duration::from_millis(300));
            found.push(*serial);
            false
        }
        _ => true,
    });
    found
}

#[test]
fn an_edit_begins_the_rest_again_and_only_the_last_one_counts() {
    let mut bench = with_bars(GlyphSet::Ascii, (80, 24));
    assert!(rests(&mut bench).is_empty() || asked(&mut bench).is_none());
    bench.keys("ll");
    bench.answer();
    let begun = rests(&mut bench);
    let (last, older) = begun.split_last().expect("a rest after an edit");
    for old in older {
        bench.send(Message::Rest(*old));
    }
    assert!(asked(&mut bench).is_none(), "an older rest is out of date");
    bench.send(Message::Rest(*last));
    let (id, budget, found) = asked(&mut bench).expect("a look after the rest");
    assert!(budget.is_some());
    // A key ends it.
    bench.keys("j");
    assert!(bench.has_cancelled());
    bench.reply(id, stopped((3, 240), found));
    let again = rests(&mut bench);
    bench.send(Message::Rest(*again.last().expect("a rest after the key")));
    assert!(asked(&mut bench).is_some(), "what a key ended is computed at the next rest");
}

#[test]
fn what_a_look_did_not_reach_says_so_and_a_key_computes_it() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("v");
    let (id, _, found) = asked(&mut bench).expect("a look");
    let StudyResult::Search(answer) = found else { panic!("no search") };
    let SearchAnswer::Sensitivity(mut report) = (*answer).clone() else { panic!("no effects") };
    for effect in &mut report.effects {
        effect.slope = None;
        for (at, point) in effect.points.iter_mut().enumerate() {
            point.take_if(|_| at % 8 != 0);
        }
    }
    bench.reply(id, stopped((36, 229), SearchAnswer::Sensitivity(report)));
    bench.keys("j");
    bench.keys("k");
    let screen = bench.screen();
    assert!(screen.contains("3 of 17 points; r computes all"), "{screen}");
    bench.keys("r");
    let (id, budget, found) = asked(&mut bench).expect("the whole study");
    assert_eq!(budget, None);
    bench.reply(id, ended(found));
    assert!(!bench.screen().contains("of 17 points"), "{}", bench.screen());
}

/// Esc closes what is open: bars that are computed at rest are no job to stop.
#[test]
fn esc_closes_the_enlarged_chart_while_bars_are_computed() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("vz");
    assert!(bench.app.is_full());
    bench.keys("<Esc>");
    assert!(!bench.app.is_full(), "{}", bench.screen());
}

#[test]
fn the_study_varies_the_variables_of_the_list() {
    let bench = Bench::ascii(80, 24);
    let listed = Editor::default().listed(&bench.app.scene);
    let symbols: Vec<&str> =
        listed.iter().map(|at| cmra_engine::model::variables::VARIABLES[*at].symbol).collect();
    assert_eq!(symbols[..VARIABLES.len()], VARIABLES);
}
