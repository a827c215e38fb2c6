//! The drawing of the impact below an enlarged chart, and its playing. The runs are real ones: their digits on the screen are few.

use cmra::tui::pages::run::charts::end_s;
use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::sync::Arc;

use super::bench::{Bench, done};
use cmra::tui::message::{Effect, Message};
use cmra::tui::preset::ReferencePreset;
use cmra::tui::theme::GlyphSet;
use cmra::tui::update::start;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables::changed;
use insta::assert_snapshot;

/// A cylinder on a plate of the library's 6061-T6.
const PLUG: &str = "nose=blunt closure=cylindrical Y=276MPa UTS=310MPa E=68.3GPa h=6.35mm v_i=300";

/// Scenes with the keys that lead to a telling moment.
const SCENES: [(&str, &str, &str); 12] = [
    ("baseline", "", ""),
    ("rigid", "mount=rigid", ""),
    ("free", "k=0", ""),
    ("cocked", "d=0.5", ""),
    ("oblique", "theta=30deg", ""),
    ("perforated", "h=6.35mm v_i=300", "LL"),
    ("plug", PLUG, "LLLL"),
    ("stop", "x_stop=5mm e=0.5", "LL"),
    ("gap in flight", "interface=plastic g=0.01 k=1e7 gamma=2", "cLLLLL"),
    ("stack", "elements=3 h_base=10mm h=3mm v_i=250", ""),
    ("lumped", "model=lumped", ""),
    ("half-sine", "model=half-sine", ""),
];

/// The enlarged chart of a scene, with its real run.
fn open(text: &str, glyphs: GlyphSet, size: (u16, u16)) -> Bench {
    let mut bench = Bench::closed(glyphs, size);
    let scene = Arc::new(changed(Scene::default(), text).expect("a scene"));
    let base =
        ReferencePreset { name: "scene".to_owned(), is_mine: false, scene: Arc::clone(&scene) };
    (bench.app.base, bench.app.scene) = (base, scene);
    let effects = start(&mut bench.app);
    bench.effects.extend(effects);
    for job in bench.jobs() {
        let run = simulate(&job.scene, &Settings::SERIES, &mut |_| ControlFlow::Continue(()));
        bench.reply(job.id, done(run.expect("a run")));
    }
    bench.press("<Tab>z");
    bench
}

/// The lines of the drawing.
fn drawing(bench: &Bench) -> String {
    let screen = bench.screen();
    let lines: Vec<&str> = screen.lines().collect();
    let is_frame = |at: &usize| lines[*at].starts_with(['+', '\u{250c}', '\u{2514}']);
    let frames: Vec<usize> = (0..lines.len()).filter(is_frame).collect();
    let [.., top, bottom] = frames[..] else { return String::new() };
    lines[top..=bottom].join("\n")
}

#[test]
fn twelve_scenes_at_every_size() {
    for (columns, rows) in [(60, 16), (80, 24), (120, 36), (160, 48)] {
        for glyphs in [GlyphSet::Braille, GlyphSet::Ascii] {
            let mut all = String::new();
            for (name, text, keys) in SCENES {
                let mut bench = open(text, glyphs, (columns, rows));
                bench.press(keys);
                write!(all, "{name}\n{}\n\n", drawing(&bench)).expect("a text");
            }
            assert_snapshot!(format!("impact_{columns}x{rows}_{glyphs}"), all);
        }
    }
}

#[test]
fn half_blocks_draw_it_too() {
    let mut all = String::new();
    for (name, text, keys) in SCENES {
        let mut bench = open(text, GlyphSet::Block, (80, 24));
        bench.press(keys);
        write!(all, "{name}\n{}\n\n", drawing(&bench)).expect("a text");
    }
    assert_snapshot!("impact_80x24_block", all);
}

/// The numbers of the playing whose pictures are due.
fn ticks(bench: &mut Bench) -> Vec<u64> {
    let due = |effect: &Effect| match effect {
        Effect::After(_, Message::Tick(serial)) => Some(*serial),
        _ => None,
    };
    let found = bench.effects.iter().filter_map(due).collect();
    bench.effects.retain(|effect| due(effect).is_none());
    found
}

#[test]
fn playing_goes_from_the_start_to_the_end_in_four_seconds() {
    let mut bench = open("", GlyphSet::Ascii, (80, 24));
    let end_s = end_s(&bench.app, 0);
    bench.press(".");
    assert_eq!(bench.app.pages.run.charts.cursor_s, Some(0.0));
    let mut played = 0;
    while let [serial] = ticks(&mut bench)[..] {
        bench.send(Message::Tick(serial));
        played += 1;
    }
    // A picture each 50 ms.
    assert_eq!(played, 80);
    assert_eq!(bench.app.pages.run.charts.cursor_s, Some(end_s));
    // From the end it begins again.
    bench.press(".");
    assert_eq!(bench.app.pages.run.charts.cursor_s, Some(0.0));
}

#[test]
fn a_key_ends_the_playing_and_old_pictures_are_dropped() {
    for (key, is_full) in [("<Esc>", true), (".", true), ("h", true), ("7", true)] {
        let mut bench = open("", GlyphSet::Ascii, (80, 24));
        bench.press(".");
        let [serial] = ticks(&mut bench)[..] else { panic!("nothing is played") };
        bench.send(Message::Tick(serial));
        bench.press(key);
        let at_s = bench.app.pages.run.charts.cursor_s;
        assert!(at_s.is_some(), "{key}");
        for serial in ticks(&mut bench) {
            bench.send(Message::Tick(serial));
        }
        assert_eq!(bench.app.pages.run.charts.cursor_s, at_s, "{key}");
        assert_eq!(bench.app.pages.run.is_full, is_full, "{key}");
    }
}

#[test]
fn esc_takes_the_crosshair_away_and_then_the_enlarged_chart() {
    let mut bench = open("", GlyphSet::Ascii, (80, 24));
    bench.press("l");
    assert!(bench.app.pages.run.charts.cursor_s.is_some());
    bench.press("<Esc>");
    assert!(bench.app.pages.run.charts.cursor_s.is_none() && bench.app.is_full());
    bench.press("<Esc>");
    assert!(!bench.app.is_full());
    bench.press("l<Esc>");
    assert!(bench.app.pages.run.charts.cursor_s.is_none());
}

#[test]
fn any_scene_is_drawn_at_any_size_and_time() {
    let sizes = [(60, 16), (73, 19), (99, 30)];
    for ((_, text, _), glyphs) in SCENES.into_iter().zip(GlyphSet::ALL.into_iter().cycle()) {
        let mut bench = open(text, glyphs, sizes[0]);
        for (keys, size) in
            [("LLLLL", 0), ("c", 1), ("LLLLL", 2), ("HHHHHHHHHHHH", 1), ("vvvvvv", 2)]
        {
            bench.press(keys);
            bench.app.size = sizes[size];
            assert!(bench.screen().contains("projectile "), "{text}");
        }
    }
}
