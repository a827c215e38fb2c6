//! Whole screens, as a person sees them. Each was looked at before it was kept.

mod accuracy;
mod bench;
mod beside;
mod cases;
mod changed;
mod charts;
mod doors;
mod edits;
mod every;
mod exports;
mod filters;
mod impact;
mod jobs;
mod keys;
mod libraries;
mod limit;
mod lists;
mod matters;
mod models;
mod panes;
mod places;
mod pointer;
mod search;
mod stability;
mod sweep;
mod tasks;
mod thesis;

use bench::Bench;
use cmra::tui::message::{ExportOutcome, Message};
use cmra::tui::theme::GlyphSet;
use cmra::worker::ReportBody;
use insta::assert_snapshot;
use proptest::prelude::*;

/// Braille at each size, and ASCII at the usual one.
fn at_every_size(sizes: &[(u16, u16)]) -> impl Iterator<Item = (GlyphSet, (u16, u16))> {
    let braille = sizes.iter().map(|size| (GlyphSet::Braille, *size));
    std::iter::once((GlyphSet::Ascii, (80, 24))).chain(braille)
}

#[test]
fn the_run_tab_at_every_size() {
    for (columns, rows) in [(30, 8), (60, 16), (80, 24), (100, 24), (120, 40), (200, 60)] {
        let mut bench = Bench::ascii(columns, rows);
        // A pin to compare with, an edit, and the crosshair.
        bench.keys(" /gamma<Enter><Enter>1.25<Enter>/<C-u><Enter><Tab>lll");
        assert_snapshot!(format!("run_{columns}x{rows}"), bench.screen());
    }
}

#[test]
fn the_first_screen() {
    let bench = Bench::ascii(80, 24);
    assert_snapshot!(bench.screen());
}

#[test]
fn before_the_first_result() {
    let bench = Bench::closed(GlyphSet::Ascii, (80, 24));
    assert_snapshot!(bench.screen());
}

#[test]
fn a_value_is_being_typed() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("jj<Enter>1.2e2 m");
    assert_snapshot!(bench.screen());
}

#[test]
fn a_text_that_is_not_a_value() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("<Enter>12 mm<Enter>");
    assert_snapshot!(bench.screen());
}

#[test]
fn a_value_outside_table_9_2() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/gamma<Enter><Enter>12<Enter>");
    assert_snapshot!(bench.screen());
}

#[test]
fn curves_of_an_older_scene() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("jjl");
    let serial = bench.app.jobs.serial;
    bench.send(Message::RunDue(serial));
    assert_snapshot!(bench.screen());
}

#[test]
fn a_perforated_plate() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys(" /thickness<Enter><Enter>6.35 mm<Enter><Tab>");
    assert_snapshot!(bench.screen());
}

#[test]
fn a_demand_on_the_interface() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("/cocking<Enter><Enter>0.5m<Enter>");
    assert_snapshot!(bench.screen());
}

#[test]
fn the_table_of_runs_on_a_small_screen() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys(" /gamma<Enter><Enter>1.25<Enter> <Enter>3<Enter><Tab><Tab>j");
    assert_snapshot!(bench.screen());
}

#[test]
fn a_failed_run() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("jjl");
    let job = bench.jobs().remove(0);
    bench.reply(job.id, ReportBody::Failed("internal error: the job panicked".to_owned()));
    assert_snapshot!(bench.screen());
}

#[test]
fn the_log_tab() {
    for (columns, rows) in [(80, 24), (120, 40)] {
        let mut bench = Bench::ascii(columns, rows);
        bench.keys("/cocking<Enter><Enter>0.5m<Enter>7");
        assert_snapshot!(format!("log_{columns}x{rows}"), bench.screen());
    }
}

#[test]
fn dialogs() {
    for (name, keys) in [
        ("help", "jj?"),
        ("help_charts", "<Tab>?"),
        ("palette", ":expo"),
        ("presets", "p<Down><Down>"),
        ("save", "jls"),
        ("save_over", "s<C-u>heavy-plate<Enter>"),
        ("export", " jle<Down><Down><Down>"),
    ] {
        let mut bench = Bench::ascii(80, 24);
        bench.keys(keys);
        assert_snapshot!(format!("dialog_{name}"), bench.screen());
    }
}

#[test]
fn the_export_target_exists() {
    let mut bench = Bench::open(GlyphSet::Braille, (120, 40));
    bench.keys("e<Enter>");
    bench.export_ended(ExportOutcome::Exists("x.csv".into()));
    assert_snapshot!(bench.screen());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_size_can_be_drawn(columns in 0u16..300, rows in 0u16..300, state in 0usize..17, full in any::<bool>()) {
        let keys = [
            "", "<Tab>l", "<Tab><Tab>", "?", "p", "e", "7", "<Enter>abc<Enter>", "5", "55", "55<Tab>",
            "2", "2l", "2<Tab>l", "2<Tab><Enter>abc<Enter>", "3", "3v",
        ];
        let mut bench = Bench::ascii(80, 24);
        bench.keys(if full { "z" } else { "" });
        bench.keys(keys[state]);
        if state == 8 {
            accuracy::answer(&mut bench, 9);
        }
        stability::answer(&mut bench);
        sweep::answer(&mut bench);
        limit::answer(&mut bench);
        bench.app.size = (columns, rows);
        let drawn = bench.screen();
        prop_assert!(drawn.lines().count() <= usize::from(rows) || rows == 0);
    }
}

#[test]
fn the_accuracy_tab_at_every_size() {
    for (glyphs, (columns, rows)) in at_every_size(&[(60, 16), (80, 24), (120, 40), (200, 60)]) {
        let mut bench = accuracy::open(glyphs, (columns, rows));
        bench.keys("gjjjlll");
        assert_snapshot!(format!("accuracy_{columns}x{rows}_{glyphs}"), bench.screen());
    }
}

#[test]
fn while_accuracy_is_being_measured() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("5");
    assert_snapshot!("accuracy_begins", bench.screen());
    accuracy::answer(&mut bench, 4);
    assert_snapshot!("accuracy_grows", bench.screen());
}

#[test]
fn a_method_that_refuses_says_why() {
    let mut bench = accuracy::open(GlyphSet::Ascii, (120, 40));
    bench.keys("gjjjjj");
    assert_snapshot!("accuracy_refusals", bench.screen());
    bench.keys("e");
    assert_snapshot!("accuracy_export", bench.screen());
}

#[test]
fn the_stability_tab_at_every_size() {
    for (glyphs, (columns, rows)) in at_every_size(&[(60, 16), (80, 24), (120, 40)]) {
        let mut bench = stability::open(glyphs, (columns, rows));
        assert_snapshot!(format!("map_{columns}x{rows}_{glyphs}"), bench.screen());
        bench.keys("<Tab>");
        stability::answer(&mut bench);
        bench.keys("j");
        assert_snapshot!(format!("battery_{columns}x{rows}_{glyphs}"), bench.screen());
    }
}
