//! What somebody new to the workbench tries: undoing a setup, keys that belong to another pane, the palette in every tab,
//! Ctrl-C in an open field, leaving with the summary.

use super::bench::Bench;
use super::pointer::{click, find};
use super::{limit, search, stability};
use cmra::model::run::{EndReason, Outcome, Warning};
use cmra::tui::chart::Scale;
use cmra::tui::message::{Effect, Message, Target};
use cmra::tui::pages::Tab;
use cmra::tui::pages::run;
use cmra::tui::pages::search::state::Page;
use cmra::tui::theme::GlyphSet;
use cmra::tui::view::target;
use std::sync::Arc;

fn in_search(size: (u16, u16)) -> Bench {
    let mut bench = Bench::ascii(size.0, size.1);
    bench.press("4");
    search::answer(&mut bench);
    bench
}

#[test]
fn the_search_setup_is_undone_and_redone_like_any_edit() {
    let mut bench = in_search((80, 24));
    let scene = bench.app.scene.clone();
    bench.keys("<Enter>50 %<Enter>");
    assert_eq!(bench.app.pages.search.setup.goal.1.to_bits(), 50.0_f64.to_bits());
    // Held arrows are one edit.
    bench.keys("kll");
    assert_eq!(bench.app.pages.search.setup.goal.0, "peak_contact_force_n");
    assert_eq!(bench.app.history.edits.len(), 2);
    assert_eq!(bench.app.history.edits[0].label, "search: is 60 % -> 50 %");
    bench.keys("u");
    assert_eq!(bench.app.pages.search.setup.goal.0, "percent_of_baseline");
    assert!(bench.message().starts_with("undone: search: percent of baseline ->"));
    bench.keys("u");
    assert_eq!(bench.app.pages.search.setup.goal.1.to_bits(), 60.0_f64.to_bits());
    bench.keys("<C-r><C-r>");
    assert_eq!(bench.app.pages.search.setup.goal.0, "peak_contact_force_n");
    assert_eq!(bench.app.scene, scene);
}

#[test]
fn the_list_of_edits_leads_over_setups_and_scenes_alike() {
    let mut bench = in_search((80, 24));
    bench.keys("<Enter>50 %<Enter>");
    bench.press("1/m_p<Enter><Enter>20<Enter>4");
    search::answer(&mut bench);
    bench.keys("<Enter>40 %<Enter>");
    assert_eq!(bench.app.history.edits.len(), 3);
    let state =
        |bench: &Bench| (bench.app.pages.search.setup.goal.1, bench.app.scene.projectile.mass_kg);
    for (edits, expected) in [(0, (60.0, 0.0295)), (3, (40.0, 0.02)), (1, (50.0, 0.0295))] {
        bench.keys(":list of edits<Enter>");
        bench.keys("g");
        for _ in 0..edits {
            bench.keys("j");
        }
        bench.keys("<Enter>");
        assert_eq!(state(&bench), expected, "after {edits} edits");
    }
}

#[test]
fn ctrl_c_closes_the_field_of_a_search_and_does_not_leave() {
    let mut bench = in_search((80, 24));
    bench.keys("<Enter>50");
    assert!(bench.app.field.is_some());
    bench.keys("<C-c>");
    assert!(bench.app.field.is_none());
    assert!(!bench.effects.iter().any(|effect| matches!(effect, Effect::Quit { .. })));
}

#[test]
fn a_key_of_another_pane_says_where_it_works() {
    let mut bench = Bench::ascii(80, 24);
    for (keys, said) in [
        ("n", "`n` does nothing here, but in Charts: Tab goes there"),
        ("V", "`V` does nothing here, but in Runs: Tab goes there"),
        ("J", "`J` does nothing here: ? lists the keys"),
        ("7<Enter>", "`Enter` does nothing here: ? lists the keys"),
    ] {
        bench.press(keys);
        assert!(bench.message().ends_with(said), "{}", bench.message());
    }
}

/// Things are found by their names and by what else people call them; what is in no name matches nothing.
#[test]
fn the_palette_finds_by_name_and_synonym_and_describes_enter() {
    for (typed, name, does) in [
        ("pareto", "Pareto front", "Enter: pareto front"),
        ("optimise", "Pareto front", "Enter: pareto front"),
        ("v50", "Ballistic limit", "Enter: ballistic limit"),
        ("cocking", "d  cocking distance", "Enter: type d, now 0"),
        ("k", "k  stiffness", "Enter: type k"),
        ("gamma", "gamma  mass ratio", "Enter: type gamma"),
        ("limit", "Limit tab", "Enter: limit tab"),
        ("efficiency", "Efficiency map", "Enter: efficiency map"),
        ("worth", "Comparison at equal areal mass", "Enter: comparison"),
        ("rigid", "rigid-mount", "show it in 1:Run"),
        ("mouse", "Switch the mouse", "Enter: switch the mouse"),
        ("largest stable", "Stability", "Enter: stability"),
    ] {
        let bench = Bench::ascii(80, 24);
        let found = bench.app.palette(typed);
        let first = found.first().unwrap_or_else(|| panic!("{typed} finds nothing"));
        assert_eq!(first.name(), name, "{typed}");
        assert!(bench.app.palette_does(first).contains(does), "{}", bench.app.palette_does(first));
    }
    let mut bench = Bench::ascii(80, 24);
    bench.press(":xqzt<Enter>");
    assert!(bench.message().contains("nothing is called `xqzt`"), "{}", bench.message());
    assert!(bench.app.history.edits.is_empty());
}

#[test]
fn the_keys_row_omits_keys_without_effect() {
    let mut bench = in_search((120, 36));
    let keys = |bench: &Bench| bench.screen().lines().last().unwrap().to_owned();
    bench.press("<Tab>");
    assert!(keys(&bench).contains("Enter load"), "{}", keys(&bench));
    bench.press("44");
    search::answer(&mut bench);
    assert_eq!(bench.app.pages.search.page, Page::Sensitivity);
    assert!(!keys(&bench).contains("Enter"), "{}", keys(&bench));
    bench.press("X");
    assert!(bench.message().contains("only the chart of the Pareto front"));
    assert_eq!(bench.app.pages.search.scales, (Scale::Linear, Scale::Linear));
}

#[test]
fn lists_and_maps_have_their_ends_and_their_pages() {
    let mut bench = limit::open(GlyphSet::Ascii, (120, 36));
    let last = bench.app.pages.limit.shots().len() - 1;
    bench.keys("G");
    assert_eq!(bench.app.pages.limit.cursor, Some(last));
    bench.keys("g");
    assert_eq!(bench.app.pages.limit.cursor, Some(0));
    let mut bench = stability::open(GlyphSet::Ascii, (80, 24));
    let (column, row) = bench.app.pages.numerics.stability.cursor().unwrap();
    // On the scene itself its words stay in one row: a second one would move the map.
    assert!(bench.message().ends_with("; the scene"), "{}", bench.message());
    bench.keys("<PgUp>");
    assert_eq!(bench.app.pages.numerics.stability.cursor(), Some((column, row + 10)));
    bench.keys("<PgDn>");
    assert_eq!(bench.app.pages.numerics.stability.cursor(), Some((column, row)));
}

#[test]
fn a_click_selects_a_run_and_one_beside_them_takes_the_keys_there() {
    let mut bench = Bench::ascii(160, 45);
    bench.press(" ll ");
    let at = find(&bench, "+B");
    assert_eq!(target(&bench.app, at), Some(Target::Row(run::RUNS, 2)));
    click(&mut bench, at);
    assert_eq!((bench.app.pane(), bench.app.selected_run), (run::RUNS, 2));
    let first = find(&bench, "oA ");
    click(&mut bench, first);
    click(&mut bench, first);
    assert!(bench.message().contains("load A"), "{}", bench.message());
    assert_eq!(bench.app.scene, bench.app.base.scene);
    let heading = find(&bench, "Design variables");
    click(&mut bench, heading);
    assert_eq!(bench.app.pane(), run::VARIABLES);
}

#[test]
fn on_a_screen_too_small_the_mouse_does_nothing() {
    let mut bench = Bench::ascii(40, 12);
    let before = bench.app.editor.selected;
    for at in [(0, 0), (10, 0), (20, 6)] {
        assert_eq!(target(&bench.app, at), None);
    }
    bench.send(Message::Wheel(false, None));
    bench.send(Message::Paste("1".to_owned()));
    assert_eq!((bench.app.editor.selected, bench.app.tab), (before, Tab::Run));
}

#[test]
fn the_summary_keeps_words_whole_and_says_once_how_the_run_ended() {
    let mut bench = Bench::ascii(80, 24);
    let mut shown = bench.app.shown.clone().unwrap();
    let run = Arc::make_mut(&mut shown.run);
    run.outcome = Outcome::Moving;
    run.end = EndReason::Cancelled;
    run.warnings = vec![
        Warning::EndedEarly(EndReason::Cancelled),
        Warning::InterfacePush { ratio: 2.9, t_s: 0.4e-3 },
    ];
    let warning = run.warnings[1].to_string();
    bench.app.shown = Some(shown);
    let summary = bench.app.summary();
    assert_eq!(summary.matches("cancelled").count(), 1, "{summary}");
    assert!(summary.lines().all(|line| line.chars().count() <= 80), "{summary}");
    let words: Vec<&str> = summary.split_whitespace().collect();
    assert!(words.join(" ").contains(&format!("outside validity: {warning}")), "{summary}");
    assert!(summary.lines().last().unwrap().starts_with("              "), "{summary}");
}

#[test]
fn very_small_and_large_values_keep_to_their_columns_in_the_table_of_runs() {
    for size in [(80, 24), (120, 40), (160, 45)] {
        let mut bench = Bench::ascii(size.0, size.1);
        let mut shown = bench.app.shown.clone().unwrap();
        let run = Arc::make_mut(&mut shown.run);
        run.max_plate_displacement_m = Some(9.178e-13);
        run.final_penetration_m = Some(12_345.678);
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

#[test]
fn a_search_without_a_match_explains_how_to_open_a_file() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("p");
    bench.press("zzz");
    bench.press("<Enter>");
    assert!(bench.message().contains("./zzz.toml"), "{}", bench.message());
    assert!(bench.app.dialog.is_some());
}

/// A variable that an edit takes out of the list leaves the selection to a row of the list.
#[test]
fn the_selection_stays_in_the_list_of_variables() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/m_2<Enter>h");
    assert!(bench.message().contains("cannot be stepped to less"), "{}", bench.message());
    assert!(!bench.message().contains("step finer"), "there is nothing to step");
    let of_mass = bench.app.editor.selected;
    bench.keys("<Enter>5<Enter>");
    bench.keys("/mount<Enter>l");
    bench.keys("<Esc>");
    let listed = bench.app.editor.listed(&bench.app.scene);
    assert!(listed.contains(&of_mass), "{:?}\n{}", bench.app.scene.plate, bench.screen());
    bench.app.editor.selected = of_mass;
    bench.keys("d");
    assert!(!bench.app.editor.listed(&bench.app.scene).contains(&of_mass));
    assert!(bench.app.editor.shows(&bench.app.scene), "{}", bench.screen());
}

#[test]
fn tabs_have_their_full_names_and_the_scene_where_there_is_room() {
    let name = "a-name-of-thirty-characters-xy";
    for (width, whole) in [(80, false), (100, true), (120, true), (160, true)] {
        let mut bench = Bench::ascii(width, 24);
        bench.app.base.name = name.to_owned();
        let title = bench.screen().lines().next().unwrap().to_owned();
        assert_eq!(title.contains(name), whole, "{title}");
        assert!(title.contains("7:Log"), "{title}");
    }
}
