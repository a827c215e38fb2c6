//! Faults of counters, ranges and labels that were found by use and put right, each with the keys that showed it.

use super::accuracy;
use super::bench::Bench;
use super::{limit, search, stability, sweep};
use cmra::study::stability::map::{Axis, Cell, FixedStep};
use cmra::tui::message::{Effect, Message, PresetEntry};
use cmra::tui::pages::Tab;
use cmra::tui::pages::explore;
use cmra::tui::theme::GlyphSet;
use cmra::tui::view::plot_columns;
use cmra::worker::Finding;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use std::sync::Arc;

/// A name that nothing has matches nothing; a name that something has opens it, and nothing else is loaded.
#[test]
fn the_palette_never_loads_a_scene_by_scattered_letters() {
    let mut bench = Bench::ascii(80, 24);
    let before = Arc::clone(&bench.app.scene);
    bench.press(":pareto<Enter>");
    assert_eq!(bench.app.tab, Tab::Search);
    assert!(bench.screen().contains("[Pareto front]"), "{}", bench.screen());
    assert_eq!(bench.app.scene, before);
}

#[test]
fn a_broken_preset_is_listed_with_its_error_and_cannot_be_loaded() {
    let mut bench = Bench::ascii(80, 24);
    let problem = "mine.toml, line 3: unknown key `gama`".to_owned();
    bench.app.presets.push(PresetEntry::broken("mine-too".to_owned(), problem));
    let before = Arc::clone(&bench.app.scene);
    bench.press("pmine-too");
    let screen = bench.screen();
    assert!(screen.contains("!mine-too") && screen.contains("unknown key"), "{screen}");
    bench.press("<Enter>");
    assert_eq!(bench.app.scene, before);
    assert!(bench.message().contains("cannot be loaded"), "{}", bench.message());
    // A long error stands whole above the dialog.
    let mut bench = Bench::ascii(80, 24);
    let why = ["expected a length;"; 10].join(" ") + " write\nfor example 0.0295";
    bench.app.presets.push(PresetEntry::broken("mine-too".to_owned(), why.clone()));
    bench.press("pmine-too<Enter>");
    let screen = bench.screen();
    let lines: Vec<&str> = screen.lines().skip(18).map(str::trim).collect();
    let refusal = format!("mine-too cannot be loaded: {why}").replace('\n', "; ");
    assert!(lines.join(" ").contains(&refusal), "{screen}");
    // A text that no preset has loads none.
    let mut bench = Bench::ascii(80, 24);
    bench.press("pzqx<Enter>");
    assert!(bench.app.history.edits.is_empty());
}

#[test]
fn a_cancelled_study_draws_no_conclusion() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("5");
    accuracy::answer(&mut bench, 1);
    let screen = bench.screen();
    assert!(screen.contains("not computed yet ("), "{screen}");
    assert!(!screen.contains("no method"), "{screen}");
}

#[test]
fn a_changed_goal_is_searched_for_before_enter_loads_anything() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("4");
    search::answer(&mut bench);
    let before = Arc::clone(&bench.app.scene);
    bench.press("<Enter>50 %<Enter><Tab><Enter>");
    assert_eq!(bench.app.scene, before, "the results of 60 % are stale");
    assert!(bench.message().contains("press r"), "{}", bench.message());
    search::answer(&mut bench);
    bench.press("<Enter>");
    assert_ne!(bench.app.scene, before);
}

#[test]
fn the_focus_belongs_to_the_tab() {
    let mut bench = sweep::open("figure-9.2", 5, GlyphSet::Ascii, (80, 24));
    bench.keys("2<Tab>");
    assert_eq!(bench.app.pane(), explore::SETUP);
    let before = Arc::clone(&bench.app.scene);
    bench.keys("30ll");
    assert_eq!(bench.app.pane(), cmra::tui::pages::limit::RESIDUAL);
    assert_eq!(bench.app.scene, before);
    bench.keys("2");
    assert_eq!(bench.app.pane(), explore::SETUP, "each tab keeps its own");
}

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
fn messages_never_move_the_panes() {
    for size in [(60, 16), (80, 24), (120, 40)] {
        let mut bench = Bench::ascii(size.0, size.1);
        let before = bench.app.layout().body;
        let long = "a message that is far too long for one row of any screen ".repeat(6);
        bench.app.say(cmra::tui::app::notice::Severity::Warning, long);
        assert_eq!(bench.app.layout().body, before);
    }
}

#[test]
fn the_exact_symbol_comes_first() {
    for (typed, symbol) in [("k", "k"), ("d", "d"), ("h", "h"), ("gam", "gamma"), ("cock", "d")] {
        let mut bench = Bench::ascii(80, 24);
        bench.keys(&format!("/{typed}"));
        assert_eq!(bench.app.editor.variable().symbol, symbol, "{typed}");
        bench.keys("<Enter><Enter>");
        assert!(bench.app.field.is_some(), "{typed}");
    }
}

/// A preset that only sweeps says where it shows, and loading it opens Explore.
#[test]
fn a_preset_of_a_figure_opens_its_sweep() {
    let mut bench = Bench::ascii(80, 24);
    let scene = cmra::files::preset::resolve("figure-9.8", None).unwrap().scene;
    let (comment, part, problem) = (String::new(), None, None);
    let name = "figure-9.8".to_owned();
    bench.app.presets.push(PresetEntry { name, origin: "bundled", scene, comment, part, problem });
    bench.press("pfigure 9.8");
    assert!(bench.screen().contains("shows on 2:Explore"), "{}", bench.screen());
    bench.press("<Enter>");
    assert_eq!(bench.app.tab, Tab::Explore);
    assert_eq!(bench.sweeps().len(), 1);
}

#[test]
fn no_two_charts_show_the_same_quantity() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("<Tab>z");
    for _ in 0..9 {
        bench.keys("v");
        let mut shown: Vec<&str> =
            bench.app.charts.quantities.iter().map(|it| it.title()).collect();
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

#[test]
fn redo_takes_away_the_run_that_was_unpinned_whatever_letter_it_has_now() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys(" ");
    let first = Arc::clone(&bench.app.pins[0].scene);
    bench.keys("<Tab><Tab>j <S-Tab><S-Tab>jjl ");
    let second = Arc::clone(&bench.app.pins[0].scene);
    assert_ne!(first, second);
    bench.keys("uu");
    bench.keys("<C-r><C-r>");
    assert_eq!(bench.app.pins.len(), 1);
    assert_eq!(bench.app.pins[0].scene, second, "the other run stays");
}

/// Esc stops the job of the tab that is shown and no other; the others are named while they run.
#[test]
fn escape_leaves_the_jobs_of_other_tabs_alone() {
    let mut bench = Bench::ascii(120, 36);
    bench.press("44");
    bench.press("7");
    assert!(bench.screen().contains("4:Search is computing"), "{}", bench.screen());
    bench.effects.clear();
    bench.press("<Esc>");
    assert!(bench.effects.is_empty(), "{:?}", bench.effects);
    assert!(bench.message().contains("4:Search"), "{}", bench.message());
    bench.press("4<Esc>");
    assert!(bench.has_cancelled());
}

/// On a logarithmic time axis zoom and pan go by ratios: the middle of the view stays the middle in decades.
#[test]
fn zoom_on_a_logarithmic_axis_goes_by_decades() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("<Tab>X");
    let (from, to) = bench.app.time_range_s(0);
    bench.keys("l+");
    let cursor = bench.app.charts.cursor_s.unwrap();
    let (near, far) = bench.app.time_range_s(0);
    let decades = |a: f64, b: f64| (b / a).log10();
    assert!((decades(near, far) / decades(from, to) - 0.5).abs() < 1e-9);
    let before = decades(from, cursor) / decades(from, to);
    assert!((decades(near, cursor) / decades(near, far) - before).abs() < 1e-9);
}

/// `z` and Space in the Log leave the Run tab as it is.
#[test]
fn keys_do_not_change_another_tab() {
    let mut bench = Bench::ascii(120, 40);
    let before = bench.screen();
    bench.keys("7z v<Esc>1");
    assert_eq!(bench.screen(), before);
    assert!(bench.app.pins.is_empty());
}

#[test]
fn ctrl_c_at_rest_asks_first() {
    let mut bench = Bench::ascii(80, 24);
    bench.effects.clear();
    bench.press("<C-c>");
    assert!(bench.effects.is_empty());
    bench.press("j<C-c>");
    assert!(bench.effects.is_empty(), "another key takes the question back");
    bench.press("<C-c>");
    assert!(matches!(bench.effects.last(), Some(Effect::Quit { .. })));
}

#[test]
fn a_horizon_set_by_hand_is_named_when_a_sweep_begins() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/horizon<Enter><Enter>0.5<Enter>");
    bench.press("2");
    assert!(bench.message().contains("horizon is set by hand"), "{}", bench.message());
}

#[test]
fn the_smallest_screens_cut_no_word() {
    for size in [(20, 5), (25, 4), (12, 3), (40, 12)] {
        let bench = Bench::ascii(size.0, size.1);
        let screen = bench.screen();
        assert!(screen.contains("60x16"), "{screen}");
        assert!(!screen.contains("terminal la") || screen.contains("terminal larger"), "{screen}");
    }
}

#[test]
fn the_first_start_says_how_to_begin_until_the_first_edit() {
    let mut bench = Bench::ascii(80, 24);
    bench.app.first_run = true;
    let screen = bench.screen();
    assert!(screen.contains("Move j/k, change h/l, type Enter, 2 explore"), "{screen}");
    assert!(screen.contains(" gamma: mass ratio"), "the meaning stays: {screen}");
    bench.keys("jjl");
    assert!(!bench.screen().contains("Move j/k"), "{}", bench.screen());
}

/// Force over displacement is reached by `v`; it has the displacement across.
#[test]
fn v_in_a_chart_reaches_the_force_over_displacement() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("<Tab>");
    for _ in 0..6 {
        bench.keys("v");
        if bench.screen().contains("Mount force [kN]") {
            assert!(bench.screen().contains("- mm +"), "{}", bench.screen());
            return;
        }
    }
    panic!("{}", bench.screen());
}

#[test]
fn options_are_a_menu_of_named_lines() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("o");
    let screen = bench.screen();
    for name in
        ["characters", "colours", "mouse", "auto-run", "threads", "interface law", "contact model"]
    {
        assert!(screen.contains(name), "{name}: {screen}");
    }
    bench.press("jjjl");
    assert!(!bench.app.auto_run);
    bench.send(Message::Resize(80, 24));
    bench.press("<Esc>");
    assert!(bench.app.dialog.is_none());
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
    let mut map = stability::map(FixedStep::Thesis, Axis::K);
    let columns = map.dt_s.len();
    map.cells.iter_mut().skip(10 * columns).for_each(|cell| *cell = Cell::Waiting);
    bench.part(study.id, (10, 19), Finding::new(map));
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

/// A name that no quantity has is answered with titles as they stand on the screen, never with keys of files.
#[test]
fn quantities_are_named_as_the_screen_names_them() {
    let mut bench = Bench::ascii(120, 36);
    bench.press("2<Tab>g<Enter>depth of snow<Enter>");
    assert!(bench.message().contains("no quantity is called"), "{}", bench.message());
    assert!(!bench.message().contains('_'), "{}", bench.message());
    let mut bench = Bench::ascii(120, 36);
    bench.press("4k<Enter>");
    let typed = bench.app.field.as_ref().expect("a field").text.value().to_owned();
    assert_eq!(typed, "percent of baseline");
    bench.press("penetration<Enter>");
    assert!(bench.message().contains("final penetration"), "{}", bench.message());
    assert!(!bench.message().contains('_'), "{}", bench.message());
}

/// One press moves the crosshair by one column of the plot as it is drawn.
#[test]
fn the_crosshair_goes_column_by_column() {
    for size in [(60, 16), (80, 24), (120, 40), (200, 60)] {
        let mut bench = Bench::ascii(size.0, size.1);
        bench.keys("<Tab>l");
        for _ in 0..30 {
            bench.press("H");
        }
        let columns = plot_columns(&bench.app);
        let (from, to) = bench.app.time_range_s(0);
        assert_eq!(bench.app.charts.cursor_s, Some(from));
        for _ in 1..columns {
            assert!(bench.app.charts.cursor_s < Some(to));
            bench.press("l");
        }
        assert_eq!(bench.app.charts.cursor_s, Some(to), "{size:?}");
    }
}

/// What is done is never more than what there is to do.
#[test]
fn counters_do_not_pass_their_totals() {
    let mut bench = Bench::ascii(120, 36);
    bench.press("3");
    let study = bench.studies().remove(0);
    bench.progress(study.id, 90, 80);
    assert!(bench.screen().contains("80 of about 80 shots"), "{}", bench.screen());
    let mut bench = Bench::ascii(120, 36);
    bench.press("4");
    search::answer(&mut bench);
    bench.press("4");
    let study = bench.studies().pop().expect("a search");
    bench.progress(study.id, 2500, 2400);
    assert!(bench.screen().contains("2400 of 2400 runs"), "{}", bench.screen());
}

#[test]
fn threads_are_chosen_in_the_options_and_used() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("ojjjjl<Esc>");
    assert_eq!(bench.app.threads, Some(1));
    bench.press("2");
    let sweeps = bench.sweeps();
    assert!(matches!(sweeps[..], [(_, 1, _)]));
    bench.press("ojjjjh<Esc>");
    assert_eq!(bench.app.threads, None);
}

#[test]
fn a_key_that_sorts_nothing_says_so() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("2S");
    assert!(bench.message().contains("`S` does nothing here"), "{}", bench.message());
}

/// From 100 columns a noun stands beside each symbol, whole.
#[test]
fn labels_of_variables_are_whole_nouns() {
    for size in [(100, 60), (120, 60), (200, 80)] {
        let bench = Bench::ascii(size.0, size.1);
        let screen = bench.screen();
        let list = screen.lines().filter_map(|line| line.get(..52)).collect::<Vec<_>>();
        assert!(list.iter().all(|line| !line.contains("..")), "{screen}");
        for row in ["h      plate thickness", "gamma  mass ratio", "k      stiffness"] {
            assert!(list.iter().any(|line| line.contains(row)), "{row}: {screen}");
        }
    }
}

/// The curve and the map of the Limit tab are high enough to be read at 80 by 24.
#[test]
fn the_charts_of_the_limit_tab_can_be_read() {
    let bench = limit::open(GlyphSet::Ascii, (80, 24));
    let screen = bench.screen();
    let rows = screen.lines().skip_while(|line| !line.contains("Residual velocity"));
    let rows = rows.take_while(|line| !line.starts_with("+--")).count();
    assert!(rows >= 10, "{screen}");
}

/// Each line of the options menu is found by its name.
#[test]
fn options_are_found_by_name() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys(":threads<Enter>");
    assert_eq!((bench.app.threads, bench.message()), (Some(1), "threads: 1".to_owned()));
    bench.keys(":next contact<Enter>");
    assert!(bench.message().starts_with("contact model: "), "{}", bench.message());
    assert_ne!(bench.app.scene, bench.app.base.scene);
}

/// The design under the cursor of the map of mass efficiency is not loaded where the scene is it already.
#[test]
fn a_design_that_is_the_scene_already_is_not_loaded_again() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("3");
    search::answer(&mut bench);
    bench.keys("<Tab><Tab>l");
    let scene = Arc::new(bench.app.efficiency_design().expect("a map").scene);
    bench.app.scene = Arc::clone(&scene);
    bench.app.pages.limit.comparison.scene = scene;
    let edits = bench.app.history.edits.len();
    bench.keys("<Enter>");
    assert!(bench.message().contains("is this design already"), "{}", bench.message());
    assert_eq!(bench.app.history.edits.len(), edits);
}

/// The table of stiff scenes is drawn in the order that `S` sets.
#[test]
fn the_table_of_stiff_scenes_is_sorted_on_the_screen() {
    let mut bench = stability::open(GlyphSet::Ascii, (120, 60));
    bench.keys("<Tab>");
    stability::answer(&mut bench);
    let mut names: Vec<String> = bench
        .app
        .pages
        .numerics
        .stability
        .rows()
        .iter()
        .map(|row| row.case.name.to_string())
        .collect();
    bench.keys("S");
    names.sort();
    let screen = bench.screen();
    let places: Vec<Option<usize>> =
        names.iter().map(|name| screen.find(&format!("|{name} "))).collect();
    assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{screen}");
}

/// Pins of a slower and a faster shot beside the present, fastest one: the keys go by the rows as they stand.
#[test]
fn the_table_of_runs_is_sorted_and_the_keys_follow_its_order() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys(" L L<Tab><Tab>");
    assert_eq!((bench.app.pins.len(), bench.app.run_order()), (2, vec![0, 1, 2]));
    // By name, by outcome, then by the depth.
    bench.keys("SSS");
    assert_eq!(bench.app.run_order(), [1, 2, 0]);
    assert!(bench.screen().contains("*depth mm"), "{}", bench.screen());
    bench.keys("k");
    assert_eq!(bench.app.selected_run, 2);
    bench.keys("gV");
    assert!(bench.app.selected_run == 1 && !bench.app.pins[0].visible);
}

#[test]
fn charts_and_sentences_spell_microseconds_alike() {
    let mut bench = Bench::open(GlyphSet::Braille, (120, 40));
    bench.keys("<Tab>l");
    let screen = bench.screen();
    assert!(screen.contains(" us ") && !screen.contains('µ'), "{screen}");
}

/// A terminal sends `Esc` with a key right behind it as that key with Alt: both count.
#[test]
fn a_key_in_the_same_read_as_an_escape_is_that_key() {
    let alt = |c| Message::Key(KeyEvent::new(KeyCode::Char(c), KeyModifiers::ALT));
    let mut bench = Bench::ascii(80, 24);
    bench.press("?");
    bench.send(alt('2'));
    assert!(bench.app.dialog.is_none());
    assert_eq!(bench.app.tab, Tab::Explore);
    bench.press("1<Enter>");
    bench.send(alt('2'));
    assert!(bench.app.field.is_none());
    assert_eq!(bench.app.tab, Tab::Explore);
}
