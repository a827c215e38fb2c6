//! Effects of keys: messages in, state and effects out.

#![expect(clippy::float_cmp, reason = "what is typed is stored to the last bit")]

use cmra::tui::pages::run::charts::{curves, end_s};
use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::Arc;

use super::bench::{Bench, done, made};
use super::sweep;
use cmra::files::atomic::OverwritePolicy;
use cmra::tui::app::notice::Severity;
use cmra::tui::keymap::Tab;
use cmra::tui::keymap::{Key, bound};
use cmra::tui::message::{Content, Effect, EffectReport, ExportOutcome, FileTask, Message};
use cmra::tui::pages::all_panes;
use cmra::tui::pages::run::state::Window;
use cmra::worker::{JobProgress, ReportBody};
use cmra_engine::model::run::{EndReason, Run};
use cmra_engine::model::scene::{InterfaceLaw, Mount, Scene, SpringKind, StopKind};
use cmra_studies::report::series::Channel;
use crossterm::event::KeyEvent;

fn bench() -> Bench {
    Bench::ascii(80, 24)
}

fn gamma(bench: &Bench) -> f64 {
    bench.app.scene.mass_ratio()
}

/// Select a variable by its symbol, without a filter left.
fn select(bench: &mut Bench, symbol: &str) {
    let all = &cmra_engine::model::variables::VARIABLES;
    bench.app.pages.run.editor.selected = all.iter().position(|one| one.symbol == symbol).unwrap();
}

/// Every key of the table in every pane: the screen is drawn, and where the footer or help offer the key it does something.
#[test]
fn every_key_works_in_its_pane_and_draws() {
    for pane in all_panes() {
        for (action, name, keys) in bound() {
            let mut bench = bench();
            bench.keys(" ");
            bench.app.focus_on(pane.pane);
            let key = keys.split(' ').next().and_then(Key::parse).expect("a key");
            bench.send(Message::Key(KeyEvent::new(key.0, key.1)));
            bench.answer();
            assert!(bench.screen().contains("1:Run"), "{name} in {}", pane.label);
            if pane.keys.iter().any(|row| row.action == *action) {
                let unknown = bench.message().contains("does nothing here");
                assert!(!unknown, "{name} in {}: {}", pane.label, bench.message());
            }
        }
    }
}

#[test]
fn a_typed_value_replaces_the_old_one() {
    let mut bench = bench();
    select(&mut bench, "v_i");
    bench.press("<Enter>120 m/s<Enter>");
    assert_eq!(bench.app.scene.projectile.velocity_m_s, 120.0);
    assert_eq!(bench.app.pages.run.editor.variable().symbol, "v_i");
    assert!(bench.app.field().is_none());
    let jobs = bench.jobs();
    assert_eq!(jobs.len(), 1);
    assert_eq!(jobs[0].scene, bench.app.scene);
    assert!(bench.effects.iter().any(|effect| matches!(effect, Effect::SaveSession)));
}

#[test]
fn units_fractions_and_relative_values_are_read() {
    for (symbol, text, expected) in [
        ("R", "6.5mm", 0.0065),
        ("gamma", "1/3", 1.0 / 3.0),
        ("gamma", "*2", 2.0),
        ("gamma", "+50%", 1.5),
        ("k", "7.5MN/m", 7.5e6),
        ("theta", "30", 30.0),
    ] {
        let mut bench = bench();
        select(&mut bench, symbol);
        bench.keys(&format!("<Enter>{text}<Enter>"));
        let shown = bench.app.field().is_none();
        assert!(shown, "{symbol} = {text}: {}", bench.message());
        let variable = cmra_engine::model::variables::find(symbol).unwrap();
        let cmra_engine::model::variables::Value::Number(value) = variable.value(&bench.app.scene)
        else {
            panic!("{symbol} is a number");
        };
        assert!((value - expected).abs() <= 1e-12 * expected, "{symbol} = {text}: {value}");
    }
}

#[test]
fn a_bad_text_stays_with_its_reason_and_the_last_good_value_stays_live() {
    let mut bench = bench();
    bench.press("/m_p<Enter><Enter>12 mm<Enter>");
    let field = bench.app.field().cloned().unwrap();
    assert_eq!(field.value(), "12 mm");
    assert!(bench.message().contains("`mm` is not a unit of this quantity (column 4)"));
    assert_eq!(bench.app.scene.projectile.mass_kg, 0.0295);
    assert!(bench.jobs().is_empty());
    // Typing goes on where it was; the error goes with the next character.
    bench.press("<BS><BS>kg");
    assert_eq!(bench.app.field().cloned().unwrap().error, None);
    bench.press("<Enter>");
    assert_eq!(bench.app.scene.projectile.mass_kg, 12.0);
}

#[test]
fn an_impossible_value_is_refused_with_the_rule() {
    let mut bench = bench();
    bench.press("/m_p<Enter><Enter>-1<Enter>");
    assert!(bench.message().contains("must be a number greater than 0 kg"));
    assert_eq!(bench.app.scene.projectile.mass_kg, 0.0295);
    bench.press("<Esc>");
    assert!(bench.app.field().is_none());
    assert_eq!(bench.app.scene.projectile.mass_kg, 0.0295);
}

#[test]
fn values_that_contradict_each_other_are_refused() {
    let mut bench = bench();
    select(&mut bench, "x_stop");
    bench.keys("<Enter>-5mm<Enter>");
    assert!(bench.message().contains("lies behind the plate's start"), "{}", bench.message());
    assert_eq!(bench.app.scene.mechanism.stop.position_m, None);
}

#[test]
fn a_value_outside_the_searched_range_counts_and_warns() {
    let mut bench = bench();
    select(&mut bench, "gamma");
    bench.keys("<Enter>12<Enter>");
    assert_eq!(gamma(&bench), 12.0);
    assert_eq!(bench.app.notice.clone().unwrap().severity, Severity::Warning);
    assert!(bench.message().contains("outside 0.8..7 of Table 9.2"));
}

#[test]
fn escape_restores_and_enter_without_a_change_changes_nothing() {
    let mut bench = bench();
    bench.keys("<Enter>99<Esc>");
    assert!(!bench.app.is_modified());
    bench.keys("<Enter><Enter>");
    assert!(!bench.app.is_modified());
    assert!(bench.app.history.edits.is_empty());
}

#[test]
fn an_absent_number_can_be_set_and_unset() {
    let mut bench = bench();
    select(&mut bench, "x_stop");
    bench.keys("l");
    assert_eq!(bench.app.scene.mechanism.stop.position_m, Some(0.01));
    bench.keys("<Enter>none<Enter>");
    assert_eq!(bench.app.scene.mechanism.stop.position_m, None);
}

#[test]
fn choices_and_switches_go_round() {
    let mut bench = bench();
    select(&mut bench, "mount");
    bench.keys("<Enter>");
    assert_eq!(bench.app.scene.plate.mount, Mount::Rigid);
    bench.keys("h");
    assert_eq!(bench.app.scene.plate.mount, Mount::Sprung);
    select(&mut bench, "dishing");
    bench.keys("l");
    assert!(!bench.app.scene.target.dishing);
    select(&mut bench, "interface");
    bench.keys("l");
    assert_eq!(bench.app.scene.interface.law, InterfaceLaw::Plastic);
}

#[test]
fn enter_on_a_choice_of_many_words_lists_them() {
    let mut bench = bench();
    select(&mut bench, "spring");
    bench.keys("<Enter>");
    let screen = bench.screen();
    for word in ["power-law  now", "bistable", "column", "helix", "the spring's force law"] {
        assert!(screen.contains(word), "{word}: {screen}");
    }
    bench.keys("<Esc>");
    assert!(bench.app.history.edits.is_empty());
    bench.keys("<Enter>jjj<Enter>");
    assert_eq!(bench.app.scene.mechanism.spring.kind, SpringKind::FixedGuided);
    assert_eq!(bench.app.history.edits.len(), 1);
    bench.keys("u");
    assert_eq!(bench.app.scene.mechanism.spring.kind, SpringKind::PowerLaw);
}

#[test]
fn the_values_of_a_stop_are_listed_with_the_stop() {
    let mut bench = Bench::ascii(160, 50);
    assert!(bench.screen().contains("x_stop"));
    assert!(!bench.screen().contains("stop_kind") && !bench.screen().contains("k_stop"));
    select(&mut bench, "x_stop");
    bench.keys("<Enter>0.01<Enter>");
    assert!(bench.screen().contains("stop_kind") && !bench.screen().contains("k_stop"));
}

#[test]
fn held_arrows_are_one_edit() {
    let mut bench = bench();
    select(&mut bench, "gamma");
    bench.keys("llll");
    assert_eq!(gamma(&bench), 1.4);
    assert_eq!(bench.app.history.edits.len(), 1);
    assert_eq!(bench.app.history.edits[0].label, "gamma 1 -> 1.4");
    bench.keys("u");
    assert_eq!(gamma(&bench), 1.0);
    bench.keys("<C-r>");
    assert_eq!(gamma(&bench), 1.4);
    // Anything in between starts a new edit.
    bench.keys("lkjl");
    assert_eq!(bench.app.history.edits.len(), 3);
}

#[test]
fn steps_back_and_forth_come_back() {
    for symbol in ["gamma", "k", "m_p", "S_y", "theta", "d", "n", "tol"] {
        let mut bench = bench();
        select(&mut bench, symbol);
        let before = bench.app.scene.clone();
        bench.keys("lllllllllllllhhhhhhhhhhhhh");
        assert_eq!(bench.app.scene, before, "{symbol}");
    }
}

#[test]
fn undo_is_unlimited() {
    let mut bench = bench();
    for value in 2..40 {
        select(&mut bench, "gamma");
        bench.keys(&format!("<Enter>{value}<Enter>"));
    }
    let edits = bench.app.history.edits.len();
    bench.keys(&"u".repeat(edits + 2));
    assert!(!bench.app.is_modified());
    assert_eq!(bench.message(), "nothing to undo");
}

#[test]
fn reset_takes_the_presets_value_and_can_be_undone() {
    let mut bench = bench();
    select(&mut bench, "gamma");
    bench.keys("lljl");
    bench.keys(":reset all<Enter>");
    assert!(!bench.app.is_modified());
    bench.keys("u");
    assert!(bench.app.is_modified());
    select(&mut bench, "gamma");
    bench.keys("d");
    assert_eq!(gamma(&bench), 1.0);
}

#[test]
fn during_a_run_the_newest_edit_wins_after_a_pause() {
    let mut bench = bench();
    select(&mut bench, "v_i");
    bench.press("l");
    let first = bench.jobs().remove(0);
    bench.press("ll");
    assert!(bench.jobs().is_empty(), "nothing is submitted while one is in flight");
    let serial = bench.app.jobs.serial;
    bench.send(Message::RunDue(serial - 1));
    assert!(bench.jobs().is_empty(), "an older pause is out of date");
    bench.send(Message::RunDue(serial));
    let second = bench.jobs().remove(0);
    assert_eq!(second.scene, bench.app.scene);
    assert!(bench.app.shows_old());
    // The replaced job's report is dropped.
    bench.reply(first.id, done(made(&first.scene)));
    assert!(bench.app.is_stale());
    bench.reply(second.id, done(made(&second.scene)));
    assert!(!bench.app.is_stale());
}

#[test]
fn a_result_of_an_edited_scene_requests_the_next_one() {
    let mut bench = bench();
    select(&mut bench, "v_i");
    bench.press("l");
    let first = bench.jobs().remove(0);
    bench.press("l");
    bench.reply(first.id, done(made(&first.scene)));
    let next = bench.jobs().remove(0);
    assert_eq!(next.scene, bench.app.scene);
}

#[test]
fn a_cancelled_job_keeps_its_part_and_a_failed_one_says_why() {
    let mut bench = bench();
    select(&mut bench, "v_i");
    bench.press("l");
    bench.press("<Esc>");
    assert!(bench.has_cancelled());
    let job = bench.jobs().remove(0);
    let partial = Run { end: EndReason::Cancelled, ..made(&job.scene) };
    bench.reply(job.id, done(partial));
    assert!(bench.app.shown.as_ref().unwrap().elapsed.is_none());
    bench.press("r");
    let job = bench.jobs().remove(0);
    bench.reply(job.id, ReportBody::Failed("internal error".to_owned()));
    assert_eq!(bench.message(), "internal error");
    assert!(bench.app.shown.is_some(), "the last good result stays");
}

#[test]
fn pins_keep_scene_and_result() {
    let mut bench = bench();
    bench.keys(" ");
    assert_eq!(bench.app.pins[0].letter, 'A');
    assert!(bench.app.pins[0].run.is_some());
    select(&mut bench, "gamma");
    bench.keys("<Enter>2<Enter> ");
    assert_eq!(bench.app.pins[1].name, "gamma=2");
    // Load A: back to the first scene, as an edit.
    bench.keys("<Tab><Tab>j<Enter>");
    assert_eq!(gamma(&bench), 1.0);
    bench.keys("u");
    assert_eq!(gamma(&bench), 2.0);
    bench.keys(" ");
    assert_eq!(bench.app.pins.len(), 1);
    assert_eq!(bench.app.pins[0].letter, 'B');
}

#[test]
fn eight_pins_are_the_most() {
    let mut bench = bench();
    select(&mut bench, "v_i");
    bench.keys(&" l".repeat(9));
    assert_eq!(bench.app.pins.len(), 8);
    bench.keys(" ");
    assert!(bench.message().contains("all eight pins"));
}

#[test]
fn the_crosshair_reads_out() {
    let mut bench = bench();
    bench.keys("<Tab>l");
    let cursor = bench.app.pages.run.charts.cursor_s.expect("a cursor");
    assert!(0.0 < cursor && cursor < end_s(&bench.app, 0), "{cursor}");
    assert!(
        bench.message().starts_with("t ") && bench.message().contains(" | p "),
        "{}",
        bench.message()
    );
    bench.app.pages.run.charts.cursor_s = Some(113e-6);
    assert!(bench.message().starts_with("t 113.0 us | p 4.565 mm"), "{}", bench.message());
}

#[test]
fn a_chart_shows_the_contact_or_the_whole_response() {
    let mut bench = bench();
    bench.keys("<Tab>c");
    assert_eq!(bench.app.pages.run.charts.windows[0], Window::Whole);
    assert_eq!(end_s(&bench.app, 0).to_bits(), 1.3e-3_f64.to_bits());
}

#[test]
fn loading_a_preset_is_one_edit() {
    let mut bench = bench();
    bench.keys("p<Down><Down><Enter>");
    assert_eq!(bench.app.base.name, "cocked");
    assert!(!bench.app.is_modified());
    assert!(bench.screen().contains("! interface 2.90"), "the run's warning is shown");
    bench.keys("u");
    assert_eq!(bench.app.base.name, "thesis-baseline");
    assert_eq!(bench.app.scene.plate.cocking_m, 0.0);
}

#[test]
fn undoing_a_sweep_brings_the_setup_of_explore_back() {
    let mut bench = bench();
    let before = bench.app.pages.explore.picture;
    let preset = bench.app.files.presets.iter_mut().find(|entry| entry.name == "cocked").unwrap();
    preset.scene = cmra::files::preset::resolve("figure-9.8", None).unwrap().scene;
    bench.keys("p<Down><Down><Enter>");
    assert_eq!(bench.app.base.name, "cocked");
    assert_ne!(bench.app.pages.explore.picture, before);
    bench.keys("u");
    assert_eq!(bench.app.pages.explore.picture, before);
}

#[test]
fn the_picker_opens_files_by_their_path() {
    let mut bench = bench();
    bench.press("p./mine.toml<Enter>");
    let path = bench.effects.iter().find_map(|effect| match effect {
        Effect::Files(FileTask::Load(path)) => Some(path.clone()),
        _ => None,
    });
    assert_eq!(path, Some("./mine.toml".into()));
}

/// The scene came from `my.toml`: that file is offered, and replaced only when asked. Another path makes another file.
#[test]
fn a_scene_is_saved_to_the_file_it_came_from() {
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("my.toml"), "format = 1\n").unwrap();
    let mut bench = bench();
    bench.app.files.directory = place.path().to_owned();
    let saves = |bench: &Bench| -> Vec<(PathBuf, bool)> {
        let saved = bench.effects.iter().filter_map(|effect| match effect {
            Effect::Files(FileTask::SaveScene { path, overwrite, .. }) => {
                Some((path.clone()?, *overwrite))
            }
            _ => None,
        });
        saved.collect()
    };
    let loaded = Ok(("my.toml".to_owned(), Box::default()));
    bench.send(Message::Done(EffectReport::Loaded(loaded)));
    bench.press("ls<Enter>");
    let file = place.path().join("my.toml");
    assert_eq!(saves(&bench), [(file.clone(), false)]);
    let exists = ExportOutcome::Exists(file.clone());
    bench.send(Message::Done(EffectReport::Saved("my.toml".to_owned(), exists)));
    // The path may be long: the question wraps.
    assert!(bench.screen().contains("o overwrite"), "{}", bench.screen());
    bench.press("o");
    assert_eq!(saves(&bench)[1], (file.clone(), true));
    bench.send(Message::Done(EffectReport::Saved(
        "my.toml".to_owned(),
        ExportOutcome::Written(vec![file]),
    )));
    assert!(!bench.app.has_dialog() && !bench.app.is_modified());
    bench.press("s<C-u>new/other.toml<Enter>");
    assert_eq!(saves(&bench)[2], (place.path().join("new/other.toml"), false));
    assert_eq!(bench.app.base.name, "my.toml");
}

#[test]
fn saving_refuses_built_in_names_and_asks_before_overwriting() {
    let saves = |bench: &Bench| -> Vec<(String, bool)> {
        bench
            .effects
            .iter()
            .filter_map(|effect| match effect {
                Effect::Files(FileTask::SaveScene { name, overwrite, .. }) => {
                    Some((name.clone(), *overwrite))
                }
                _ => None,
            })
            .collect()
    };
    let mut bench = bench();
    bench.press("s<C-u>cocked<Enter>");
    assert!(bench.screen().contains("built-in preset"));
    assert!(saves(&bench).is_empty());
    bench.press("<C-u>heavy-plate<Enter>");
    assert!(bench.screen().contains("o overwrite"));
    assert!(saves(&bench).is_empty());
    bench.press("y");
    assert_eq!(saves(&bench), [("heavy-plate".to_owned(), true)]);
    let ended = |outcome| Message::Done(EffectReport::Saved("heavy-plate".to_owned(), outcome));
    let error = |bench: &Bench| bench.screen().contains("error: the disk is full");
    bench.send(ended(ExportOutcome::Failed("the disk is full".to_owned())));
    assert!(error(&bench), "{}", bench.screen());
    // A dialog that was opened meanwhile asked for something else.
    bench.press("<Esc>e");
    bench.send(ended(ExportOutcome::Failed("the disk is full".to_owned())));
    assert_eq!(bench.message(), "the disk is full");
    bench.press("<Esc>s<C-u>heavy-plate<Enter>y");
    bench.send(ended(ExportOutcome::Written(vec!["/home/ada/heavy-plate.toml".into()])));
    assert!(!bench.app.has_dialog());
    assert_eq!(bench.app.base.name, "heavy-plate");
    assert!(bench.message().contains("/home/ada/heavy-plate.toml"));
}

#[test]
fn export_asks_for_the_file_of_all_runs() {
    let mut bench = bench();
    bench.keys(" jl");
    bench.press("e<Right><BS><BS><BS><BS>-x.csv<Enter>");
    let request = bench.effects.iter().find_map(|effect| match effect {
        Effect::Files(FileTask::Export(to, Content::Runs(request))) => {
            Some((to.clone(), request.clone()))
        }
        _ => None,
    });
    let (to, request) = request.unwrap();
    assert_eq!(to.path.to_str(), Some("/home/ada/work/thesis-baseline-x.csv"));
    let names: Vec<&str> = request.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["now", "A"]);
    assert_eq!(to.existing, OverwritePolicy::Keep);
    bench.export_ended(ExportOutcome::Exists("x".into()));
    assert!(bench.screen().contains("o overwrite"), "the dialog stays open");
    bench.export_ended(ExportOutcome::Written(vec!["a.csv".into()]));
    assert!(!bench.app.has_dialog());
    assert!(bench.message().contains("written: a.csv"));
}

/// As in every field, the first character replaces the text; a folder that does not exist is accepted.
#[test]
fn what_is_typed_replaces_the_proposed_name() {
    for (typed, expected) in
        [("x.csv", "/home/ada/work/x.csv"), ("new/deep/a.csv", "/home/ada/work/new/deep/a.csv")]
    {
        let mut bench = bench();
        bench.press(&format!("e{typed}<Enter>"));
        let (to, ..) = bench.exported().expect("a file");
        assert_eq!(to.path.to_str(), Some(expected));
    }
    let mut bench = bench();
    bench.press("smine<Enter>");
    let saved = bench.effects.iter().any(
        |effect| matches!(effect, Effect::Files(FileTask::SaveScene { name, .. }) if name == "mine"),
    );
    assert!(saved, "{:?}", bench.effects);
}

#[test]
fn an_exports_bad_answers_stay_in_the_dialog() {
    let mut bench = bench();
    bench.press("e<C-u><Enter>");
    assert!(bench.screen().contains("needs a file name"));
}

#[test]
fn the_palette_executes() {
    let mut bench = bench();
    bench.keys(":whole response<Enter>");
    assert_eq!(bench.app.pages.run.charts.windows[0], Window::Whole);
    bench.keys(":log tab<Enter>");
    assert_eq!(bench.app.tab, Tab::Log);
}

/// An action of another tab leads there, and there it computes as if its key had led there.
#[test]
fn an_action_of_another_tab_enters_it() {
    for (typed, tab) in [
        ("convergence", Tab::Numerics),
        ("stability", Tab::Numerics),
        ("claims", Tab::Thesis),
        ("pareto", Tab::Search),
        ("does it pay", Tab::Limit),
    ] {
        let mut bench = bench();
        bench.press(&format!(":{typed}<Enter>"));
        assert_eq!(bench.app.tab, tab, "{typed}");
        // A front is searched for on request only.
        assert_eq!(bench.studies().is_empty(), typed == "pareto", "{typed}");
    }
}

#[test]
fn the_filter_follows_every_character() {
    let mut bench = bench();
    bench.keys("/exponent");
    assert_eq!(bench.app.pages.run.editor.listed(&bench.app.scene).len(), 2);
    assert_eq!(bench.app.pages.run.editor.variable().symbol, "n");
    bench.keys("<Enter>j");
    assert_eq!(bench.app.pages.run.editor.variable().symbol, "m");
    bench.keys("<Esc>");
    assert!(bench.app.pages.run.editor.filter.is_empty());
    assert_eq!(bench.app.pages.run.editor.variable().symbol, "m");
}

#[test]
fn pasted_text_goes_into_an_open_field_only() {
    let mut bench = bench();
    bench.send(Message::Paste("q".to_owned()));
    assert!(bench.message().contains("ignored"));
    bench.keys("/m_p<Enter><Enter>");
    bench.send(Message::Paste("30\n".to_owned()));
    bench.keys("<Enter>");
    assert_eq!(bench.app.scene.projectile.mass_kg, 0.03);
}

#[test]
fn on_a_screen_too_small_keys_only_lead_out() {
    let mut bench = Bench::ascii(30, 8);
    bench.keys("lll<Enter>5<Enter>");
    assert!(!bench.app.is_modified());
    bench.press("q");
    assert!(matches!(bench.effects.last(), Some(Effect::Quit)));
}

#[test]
fn leaving_keeps_the_session() {
    let mut bench = bench();
    bench.effects.clear();
    bench.press("q");
    assert!(matches!(bench.effects.as_slice(), [Effect::SaveSession, Effect::Quit]));
    bench.effects.clear();
    bench.press("<Esc>");
    assert!(bench.effects.is_empty(), "Esc does not quit");
    bench.press("<C-c>");
    assert!(bench.effects.is_empty(), "Ctrl-C at rest asks first");
    assert!(bench.message().contains("Ctrl-c again quits"), "{}", bench.message());
    bench.press("<C-c>");
    assert!(matches!(bench.effects.last(), Some(Effect::Quit)));
}

/// As help says: once cancels every job, twice quits, whether or not a job has ended by then.
#[test]
fn the_key_that_cancels_quits_when_pressed_twice() {
    let mut bench = bench();
    bench.press("jjl");
    bench.effects.clear();
    bench.press("<C-c>");
    assert!(bench.has_cancelled());
    assert!(!bench.effects.iter().any(|one| matches!(one, Effect::Quit)));
    bench.press("<C-c>");
    assert!(matches!(bench.effects.last(), Some(Effect::Quit)));
}

/// The first key closes what is open, and counts as the first of two.
#[test]
fn the_key_that_cancels_quits_when_pressed_twice_in_a_field_or_dialog() {
    for keys in ["<Enter>", "?", "p", ":", "e", "/ga"] {
        let mut bench = bench();
        bench.keys(keys);
        bench.effects.clear();
        bench.press("<C-c>");
        assert!(!bench.app.has_dialog() && bench.app.field().is_none(), "{keys}");
        assert!(bench.message().contains("Ctrl-c again quits"), "{keys}: {}", bench.message());
        bench.press("<C-c>");
        assert!(matches!(bench.effects.last(), Some(Effect::Quit)), "{keys}");
    }
}

#[test]
fn popups_close_by_q_and_escape() {
    for keys in ["?q", "?<Esc>", "p<Esc>", ":<Esc>", "s<Esc>", "e<Esc>"] {
        let mut bench = bench();
        bench.effects.clear();
        bench.keys(keys);
        assert!(!bench.app.has_dialog(), "{keys}");
        assert!(!bench.effects.iter().any(|effect| matches!(effect, Effect::Quit)), "{keys}");
    }
}

#[test]
fn leaving_asks_only_while_a_run_has_been_going_on_for_long() {
    let quits = |bench: &Bench| bench.effects.iter().any(|one| matches!(one, Effect::Quit));
    let mut bench = bench();
    bench.press("jjl");
    let job = bench.jobs().remove(0);
    // Not long yet: the session is safe, so nothing is asked.
    let mut quick = Bench::ascii(80, 24);
    quick.press("jjlq");
    assert!(quits(&quick));
    let elapsed = std::time::Duration::from_millis(20);
    // Its first report sets the clock; a job that ends in time is forgotten.
    bench.reply(job.id, ReportBody::Progress { progress: JobProgress::Time(0.0), elapsed });
    let due = bench.effects.iter().find_map(|effect| match effect {
        Effect::After(delay, message @ Message::LongJob(id)) if *id == job.id => {
            Some((*delay, message.clone()))
        }
        _ => None,
    });
    let (delay, message) = due.expect("a clock");
    assert_eq!(delay.as_secs(), 5);
    bench.send(message);
    bench.press("q");
    assert!(!quits(&bench));
    assert!(bench.message().contains("q again quits"), "{}", bench.message());
    // Another key takes the question back.
    bench.press("jq");
    assert!(!quits(&bench));
    bench.press("q");
    assert!(quits(&bench));
}

#[test]
fn a_long_run_reports_its_progress() {
    let mut bench = bench();
    bench.press("jjl");
    let job = bench.jobs().remove(0);
    let elapsed = std::time::Duration::from_millis(2500);
    bench.reply(job.id, ReportBody::Progress { progress: JobProgress::Time(1e-3), elapsed });
    let serial = bench.app.jobs.serial;
    bench.send(Message::RunDue(serial));
    let screen = bench.screen();
    assert!(screen.contains("running for 2.5 s, at t = 1.000 ms (Esc cancels)"), "{screen}");
}

#[test]
fn unpinning_is_undone_and_redone_like_any_edit() {
    let mut bench = bench();
    bench.keys(" /gamma<Enter><Enter>2<Enter> ");
    let pins = bench.app.pins.clone();
    assert_eq!(pins.len(), 2);
    bench.keys("<Tab><Tab>j ");
    assert_eq!(bench.app.pins.len(), 1);
    assert!(bench.message().contains("(u undoes)"), "{}", bench.message());
    bench.keys("u");
    assert_eq!(bench.app.pins, pins);
    assert_eq!(gamma(&bench), 2.0);
    bench.keys("<C-r>");
    assert_eq!(bench.app.pins.len(), 1);
}

#[test]
fn leaving_asks_first_while_the_session_cannot_be_kept() {
    let leaves = |bench: &Bench| bench.effects.iter().any(|effect| matches!(effect, Effect::Quit));
    let mut bench = Bench::ascii(80, 24);
    let lost = || Message::Done(EffectReport::Session(Err("cannot write `/full`".to_owned())));
    bench.send(lost());
    assert!(bench.message().contains("cannot be kept: cannot write `/full`"));
    // Nothing has been changed: there is nothing to lose.
    bench.press("q");
    assert!(leaves(&bench));
    let mut bench = Bench::ascii(80, 24);
    bench.send(lost());
    bench.keys("l");
    bench.press("q");
    assert!(!leaves(&bench) && bench.message().contains("q again"), "{}", bench.message());
    bench.press("q");
    assert!(leaves(&bench));
    let mut bench = Bench::ascii(80, 24);
    bench.send(lost());
    bench.send(Message::Done(EffectReport::Session(Ok(()))));
    bench.keys("l");
    bench.press("q");
    assert!(leaves(&bench));
}

#[test]
fn view_reaches_stiffness_and_stress_with_the_yield_line_over_the_whole_way() {
    let mut bench = Bench::ascii(100, 30);
    let preset = cmra::files::preset::resolve("concept-cocked-cantilever", None).unwrap();
    bench.app.scene = Arc::new(preset.scene);
    bench.keys("r<Tab>");
    let mut titles = HashSet::new();
    for _ in 0..Channel::ALL.len() {
        bench.keys("v");
        titles.insert(bench.app.pages.run.charts.quantities[0].title());
        if bench.app.pages.run.charts.quantities[0] == Channel::Stress {
            break;
        }
    }
    assert!(titles.contains("Stiffness over displacement"), "{titles:?}");
    bench.keys("z");
    let screen = bench.screen();
    for words in ["Stress over yield strength", "cocked", "yield", "max", " mm "] {
        assert!(screen.contains(words), "{words}: {screen}");
    }
}

/// A rigid stop has no stiffness to draw: it says why, and draws no empty frame.
#[test]
fn a_rigid_stop_has_no_stiffness() {
    let mut scene = Scene::default();
    scene.mechanism.spring.coefficient = 0.0;
    scene.mechanism.stop.position_m = Some(1e-3);
    assert_eq!(Channel::Stiffness.absence(&scene), Some("no spring"));
    scene.mechanism.stop.kind = StopKind::Elastic;
    assert_eq!(Channel::Stiffness.absence(&scene), None);
}

/// Go to the charts, and with `v` to a quantity in the first of them.
fn show(bench: &mut Bench, quantity: Channel) {
    bench.keys("<Tab>");
    while bench.app.pages.run.charts.quantities[0] != quantity {
        bench.keys("v");
    }
}

#[test]
fn force_over_displacement_is_drawn_over_the_whole_way_of_the_plate() {
    let mut bench = bench();
    show(&mut bench, Channel::MountForce);
    let run = bench.app.shown.as_ref().unwrap().run.clone();
    let farthest = run.max_plate_displacement_m.unwrap();
    bench.app.pages.run.charts.quantities[0] = Channel::MountForce;
    let curves = curves(&bench.app, 0);
    let drawn = curves[0].points.iter().map(|point| point.0).fold(0.0, f64::max);
    assert!((drawn - farthest).abs() < 1e-3 * farthest, "{drawn} {farthest}");
}

/// The three numbers that a designer reads first stand in the titles, beside the meaning of the selected row.
#[test]
fn the_run_tab_says_what_came_of_the_shot() {
    let mut bench = bench();
    let run = bench.app.shown.as_ref().unwrap().run.clone();
    let depth_mm = 1e3 * run.penetration.final_m.unwrap();
    let greatest_mm = 1e3 * run.max_plate_displacement_m.unwrap();
    let screen = bench.screen();
    for words in [
        format!("Penetration {depth_mm:.3} mm (64 % of rigid mount)"),
        // The run of the bench has 17,745 N.
        "Contact force, peak 17.75 kN".to_owned(),
        format!("whole: greatest {greatest_mm:.2} mm"),
        " gamma: mass ratio".to_owned(),
    ] {
        assert!(screen.contains(&words), "{words}: {screen}");
    }
    bench.press("l");
    bench.send(Message::RunDue(bench.app.jobs.serial));
    assert!(bench.screen().contains("Penetration (old)"), "{}", bench.screen());
}

#[test]
fn a_chart_of_what_the_scene_has_not_says_so() {
    let mut bench = bench();
    show(&mut bench, Channel::DamperForce);
    assert!(bench.screen().contains("no damper"), "{}", bench.screen());
}

#[test]
fn pinning_can_be_undone_and_done_again() {
    let mut bench = bench();
    bench.keys(" ");
    let pinned = Arc::clone(&bench.app.pins[0].scene);
    bench.keys("u");
    assert!(bench.app.pins.is_empty());
    assert!(bench.message().contains("undone: pin A"), "{}", bench.message());
    bench.keys("<C-r>");
    assert_eq!(bench.app.pins[0].scene, pinned);
}

/// A report is not made of what is on the screen: its ending gets no table.
#[test]
fn an_export_named_as_a_report_is_refused_with_the_cure() {
    for page in ["", "2"] {
        let mut bench = Bench::ascii(120, 36);
        bench.keys(page);
        sweep::answer(&mut bench);
        bench.keys("e<C-u>figure.html<Enter>");
        assert!(bench.exported().is_none(), "{page}");
        let screen = bench.screen();
        assert!(screen.contains("cmra report FILE.toml -o FILE.html"), "{page}\n{screen}");
    }
}

/// A path that ends in `.svg` gets the charts on the screen: all three, or one with two axes.
#[test]
fn charts_are_exported_as_svg() {
    for (keys, titles) in [
        ("e", &["Penetration 4.565 mm", "Plate displacement", "Contact force"][..]),
        ("<Tab>ze", &["Penetration 4.565 mm"]),
    ] {
        let mut bench = Bench::ascii(120, 36);
        bench.keys(keys);
        bench.keys("<C-u>chart.svg<Enter>");
        let (to, drawn, has_scene) = bench.exported().expect("a file");
        assert!(to.path.ends_with("chart.svg") && !has_scene);
        let read = roxmltree::Document::parse(&drawn).unwrap();
        let texts: Vec<&str> = read.descendants().filter_map(|node| node.text()).collect();
        for title in titles {
            assert!(texts.iter().any(|text| text.contains(title)), "{keys} {title}: {texts:?}");
        }
        assert!(drawn.contains("<polyline") && !drawn.contains("NaN"), "{keys}");
    }
}
