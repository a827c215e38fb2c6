//! The Search tab: keys and whole screens. Everything is computed but the front, which is made up: a search by chance may take
//! another way at the last digit of a run.

use cmra::tui::pages::log::log_lines;
use cmra::tui::pages::search::results::search_is_old;
use cmra::tui::pages::search::study_page::search_words;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use super::at_every_size;
use super::bench::{Bench, Study, ended, stopped};
use crate::support::run;
use cmra_engine::model::run::Outcome;
use cmra_engine::model::scene::{InterfaceLaw, Scene};
use cmra_studies::study::envelope::Check;
use cmra_studies::study::search::front::{self, Design, FrontReport};
use cmra_studies::study::sweep::PointOutcome;
use cmra_studies::study::sweep::default_axes::{or_usual, thesis_axes};

use cmra::files::preset;
use cmra::tui::keymap::Tab;
use cmra::tui::message::Message;
use cmra::tui::pages::search;
use cmra::tui::pages::search::state::{Page, Row};
use cmra::tui::theme::GlyphSet;
use cmra::worker::studies::{RequestVariant, SearchAnswer, SearchRequest, StudyResult};
use cmra::worker::{JobProgress, ReportBody};
use insta::assert_snapshot;

/// Depth falls as stroke rises.
fn front(scene: &Scene, request: &front::Request) -> FrontReport {
    let measures =
        |i: f64| vec![Some(1e-3 + 1e-4 * i), Some(0.8 / (1.0 + i)), Some(0.5), Some(4e3)];
    let over = or_usual(&request.over, || thesis_axes(scene)).unwrap();
    let design = |i: u8| Design {
        values: over.iter().map(|axis| axis.at_fraction(f64::from(i) / 40.0)).collect(),
        measures: measures(f64::from(i)),
        outcome: PointOutcome::Ended(Outcome::Arrested),
        plastic: None,
    };
    FrontReport {
        designs: (0..40).map(design).collect(),
        request: front::Request { over, ..request.clone() },
        base: scene.clone(),
        outside: vec![(Check::Thickness, 40), (Check::Interface, 31)],
        runs: 2460,
        ..FrontReport::default()
    }
}

fn made(scene: &Arc<Scene>, request: &SearchRequest) -> SearchAnswer {
    let mut request = request.clone();
    match &mut request {
        SearchRequest::Seek(_) | SearchRequest::Sensitivity(_) => {}
        SearchRequest::Front(request) => {
            return SearchAnswer::Front(Box::new(front(scene, request)));
        }
        SearchRequest::MonteCarlo(request) => request.samples = Some(500),
    }
    request.run(scene, 1, &|_, _| ControlFlow::Continue(())).unwrap()
}

/// Answer what was requested, and what is requested then.
pub(super) fn answer(bench: &mut Bench) {
    loop {
        let studies = bench.studies();
        let answered = studies.iter().filter(|study| answer_one(bench, study)).count();
        if answered == 0 {
            return;
        }
    }
}

/// The Search tab with a goal seek that is done.
pub(super) fn in_search(size: (u16, u16)) -> Bench {
    let mut bench = Bench::ascii(size.0, size.1);
    bench.press("4");
    answer(&mut bench);
    bench
}

/// The result of a search.
pub(super) fn found(study: &Study) -> StudyResult {
    let request = SearchRequest::downcast(&study.request).expect("a search");
    StudyResult::from(made(&study.scene, request))
}

fn answer_one(bench: &mut Bench, study: &Study) -> bool {
    let is_search = SearchRequest::downcast(&study.request).is_some();
    if is_search {
        bench.reply(study.id, ended(found(study)));
    }
    is_search
}

/// Opens Search with its results selected.
pub(super) fn open(glyphs: GlyphSet, size: (u16, u16)) -> Bench {
    let mut bench = Bench::open(glyphs, size);
    bench.keys("4<Tab>");
    answer(&mut bench);
    bench
}

/// All studies have their gauge, their answer and their table in the same place.
#[test]
fn every_study_is_set_up_run_and_answered_on_the_same_page() {
    for page in Page::ALL {
        let mut bench = Bench::ascii(80, 24);
        bench.app.pages.search.page = page;
        bench.keys("4");
        bench.studies();
        let place = |bench: &Bench, text: &str| {
            let screen = bench.screen();
            let found = screen.lines().enumerate().find_map(|(row, line)| {
                Some((row, line.find(text).map(|at| line[..at].chars().count())?))
            });
            found.unwrap_or_else(|| panic!("{page:?}: no {text} on\n{screen}"))
        };
        place(&bench, "r search");
        bench.press("r");
        let study = bench.studies().remove(0);
        let (progress, elapsed) = (JobProgress::Points(25, 100), Duration::from_secs(4));
        bench.reply(study.id, ReportBody::Progress { progress, elapsed });
        // A quarter of 33 cells; three quarters of the work take three times as long.
        assert_eq!(place(&bench, "[########........................."), (12, 30), "{page:?}");
        place(&bench, "] 12 s left  ");
        place(&bench, "searching: about 25 of 100 runs [##......] 12 s left (Esc cancels)");
        bench.reply(study.id, ended(found(&study)));
        place(&bench, "+- Setup -");
        let (row, column) = place(&bench, &format!("+- {} -", page.title()));
        assert_eq!(column, 27, "{page:?}");
        let words = search_words(&bench.app, 51);
        let lines: Vec<String> = bench.screen().lines().map(str::to_owned).collect();
        for (line, (text, _)) in lines[row + 1..].iter().zip(&words.head) {
            assert!(line.contains(text), "{page:?}: {text}: {line}");
        }
        let (heading, answer) = words.head.split_last().unwrap();
        assert!(!answer.is_empty() && !words.body.is_empty(), "{page:?}: {words:?}");
        let rows = words.body.iter().filter(|row| row.0.starts_with(['>', ' ']));
        let as_wide = |row: &String| row.chars().count() <= heading.0.chars().count() + 12;
        assert!(rows.map(|row| &row.0).all(as_wide), "{page:?}: {words:?}");
    }
}

#[test]
fn every_page_at_every_size() {
    for (glyphs, (columns, rows)) in at_every_size(&[(60, 16), (80, 24), (160, 50)]) {
        let mut bench = open(glyphs, (columns, rows));
        for page in Page::ALL {
            assert_eq!(bench.app.pages.search.page, page);
            bench.keys("lll");
            let name = page.title().replace(' ', "_");
            assert_snapshot!(format!("search_{name}_{columns}x{rows}_{glyphs}"), bench.screen());
            bench.keys("4");
            if bench.app.pages.search.page == Page::Front {
                bench.keys("r");
            }
            answer(&mut bench);
        }
        assert_eq!(bench.app.pages.search.page, Page::Seek);
    }
}

/// Enter makes the solution the scene, which then has the depth that was sought; one undo takes it back.
#[test]
fn a_solution_becomes_the_scene_and_back() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    let before = Arc::clone(&bench.app.scene);
    bench.keys("<Enter>");
    assert_eq!(bench.app.tab, Tab::Search, "what was searched stays on the screen");
    let percent = run(bench.app.scene.as_ref().clone()).percent_of_baseline().unwrap();
    assert!((percent - 60.0).abs() < 1e-4, "{percent}");
    assert!(!search_is_old(&bench.app), "the value that was searched for does not make it stale");
    bench.keys("u");
    assert_eq!(bench.app.scene, before);
    bench.keys("4r");
    answer(&mut bench);
    bench.keys("gjj<Enter>");
    let found = bench.app.pages.search.front().expect("a front");
    let design = &found.designs[2];
    for (axis, value) in found.request.over.iter().zip(&design.values) {
        let there = axis.get(&bench.app.scene).unwrap();
        assert!((there - value).abs() <= 1e-15 * value.abs(), "{}", axis.symbol());
    }
    // Another variable makes the results stale: Enter refuses them.
    bench.keys("1/v_i<Enter>l<Esc>4");
    let before = Arc::clone(&bench.app.scene);
    bench.press("<Enter>");
    assert_eq!(bench.app.scene, before);
    assert!(bench.message().contains("press r"), "{}", bench.message());
}

#[test]
fn the_setup_is_stepped_and_typed_into_and_bad_texts_stay() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    bench.keys("<Tab>j<Enter>k<Down>");
    assert_eq!(bench.app.pages.search.setup.seek.name, "k");
    // A goal seek takes less than a second: it follows every edit of its setup.
    assert_eq!(bench.studies().len(), 1);
    bench.keys("<Enter>-3<Enter>");
    assert!(bench.message().contains("-3000 N/m^n, which is impossible"), "{}", bench.message());
    bench.keys("<C-u>100<Down>");
    assert!((bench.app.pages.search.setup.seek.from - 1e5).abs() < 1e-9);
    bench.keys("<Enter>2MN/m<Down>");
    assert!((bench.app.pages.search.setup.seek.to - 2e6).abs() < 1e-6, "{}", bench.screen());
    bench.keys("l");
    assert!(bench.app.pages.search.setup.seek.log);
    bench.keys("gj<Enter>3kg<Enter>");
    assert!(bench.app.field().is_some());
    bench.keys("<C-u>65 %<Enter>");
    answer(&mut bench);
    assert!(bench.screen().contains("65 % at k = "), "{}", bench.screen());
}

#[test]
fn esc_stops_the_task_named_in_the_tab_before_the_run() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    bench.keys("1");
    bench.press("r");
    assert!(bench.app.jobs.current.is_some());
    bench.press("4");
    bench.press("4r");
    assert_eq!(bench.studies().len(), 1);
    assert!(bench.screen().contains("(Esc cancels)"), "{}", bench.screen());
    bench.press("<Esc>");
    assert!(bench.has_cancelled());
    assert!(bench.app.jobs.current.is_some());
}

#[test]
fn progress_is_shown_a_part_is_drawn_and_a_stop_keeps_it() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    bench.keys("4r");
    let study = bench.studies().remove(0);
    let request = SearchRequest::downcast(&study.request).expect("a search");
    let SearchAnswer::Front(front) = made(&study.scene, request) else { panic!("no front") };
    let part = StudyResult::from(SearchAnswer::Front(front));
    bench.part(study.id, (480, 2460), part.clone());
    let screen = bench.screen();
    assert!(screen.contains("searching: about 480 of 2460 runs (Esc cancels)"), "{screen}");
    bench.keys("<Esc>");
    assert!(bench.has_cancelled());
    bench.reply(study.id, stopped((480, 2460), part));
    let screen = bench.screen();
    assert!(screen.contains("cancelled: press r (480 of 2460 runs)"), "{screen}");
}

/// The baseline cocked by 0.5 m, the end of the usual range: its interface must carry 2.875 times its strength.
#[test]
fn a_breach_at_the_end_of_the_range_is_named_and_explained() {
    let mut bench = open(GlyphSet::Ascii, (120, 40));
    // Of a goal seek the solution is judged, at d = 26 mm; of a sensitivity study the whole range.
    let seek = bench.screen();
    assert!(seek.contains("of the solution: h/D") && !seek.contains("at the ends"), "{seek}");
    bench.keys("44");
    answer(&mut bench);
    assert!(bench.screen().contains("at the ends: "), "{}", bench.screen());
    bench.keys("7");
    let lines = log_lines(&bench.app, 200);
    let found =
        lines.iter().any(|line| line.0.contains("at d = 0.5: ") && line.0.contains("2.875"));
    assert!(found, "{lines:?}");
}

/// A fused interface holds at any depth: 50 % are reached at d = 98 mm, where a real interface would be torn (`cmra seek` has the
/// same). With the plastic one nothing reaches 50 %.
#[test]
fn a_solution_that_no_interface_holds_together_says_so() {
    let mut bench = Bench::ascii(120, 36);
    bench.keys("4");
    answer(&mut bench);
    bench.keys("<Enter>50<Enter>");
    answer(&mut bench);
    for words in ["50 % at d = 97.9977 mm", "interface pull is", "plastic"] {
        assert!(bench.screen().contains(words), "{words}: {}", bench.screen());
    }
    Arc::make_mut(&mut bench.app.scene).interface.law = InterfaceLaw::Plastic;
    bench.press("r");
    answer(&mut bench);
    assert!(bench.screen().contains("nothing reaches 50 %"), "{}", bench.screen());
}

/// The designs are points in the picture, too.
#[test]
fn the_front_is_exported_as_a_picture() {
    let mut bench = open(GlyphSet::Ascii, (120, 36));
    bench.press("4r");
    answer(&mut bench);
    bench.press("e<C-u>front.svg<Enter>");
    let (_, drawn, _) = bench.exported().expect("an export");
    let designs = bench.app.pages.search.front().expect("a front").designs.len();
    let circles = drawn.matches("<circle").count();
    assert!(designs > 0 && circles >= designs, "{designs} designs, {circles} circles");
}

#[test]
fn on_a_small_screen_results_or_setup_have_the_room() {
    let mut bench = open(GlyphSet::Ascii, (60, 16));
    for _ in 0..4 {
        bench.keys("4");
        answer(&mut bench);
        assert!(!bench.screen().contains(".. |"), "{}", bench.screen());
    }
    bench.keys("4<Tab>");
    assert_eq!(bench.app.pane(), search::SETUP);
    assert!(bench.screen().contains("stroke<=1000 mm"), "{}", bench.screen());
    bench.keys("<Tab>");
    assert_eq!(bench.app.pane(), search::RESULTS);
}

/// The front offers its knee first: for depths falling in steps of 0.1 mm and strokes as 0.8/(1 + i) m over 40 designs, the
/// least sum of both as fractions of their ranges is at i = 5, 1.5 mm and 133 mm.
#[test]
fn the_front_begins_at_its_knee_as_a_table_that_is_sorted() {
    let mut bench = open(GlyphSet::Ascii, (120, 40));
    bench.keys("4r");
    answer(&mut bench);
    let stroke = |bench: &Bench| {
        let tab = &bench.app.pages.search;
        tab.front().expect("a front").designs[tab.selected()].measures[1].unwrap()
    };
    let best = (0..40u8).map(f64::from).min_by(|a, b| {
        let sum = |i: f64| i / 39.0 + (0.8 / (1.0 + i) - 0.02) / 0.78;
        sum(*a).total_cmp(&sum(*b))
    });
    let best = best.unwrap();
    assert!((stroke(&bench) - 0.8 / (1.0 + best)).abs() < 1e-12, "{}", stroke(&bench));
    assert!(bench.screen().contains("knee"), "{}", bench.screen());
}

/// The first design of the made-up front has no spring and no damper, the second one has both.
#[test]
fn a_design_that_nothing_holds_is_marked_and_the_mark_is_explained() {
    let mut bench = open(GlyphSet::Ascii, (120, 40));
    bench.keys("4r");
    answer(&mut bench);
    bench.keys("gj");
    let screen = bench.screen();
    for mark in ["  1*   1.000 mm", "> 2    1.100 mm", "* nothing stops plate and projectile"] {
        assert!(screen.contains(mark), "{mark}\n{screen}");
    }
}

/// Where everything perforates there is no percentage of a baseline, and each page says what to do instead.
#[test]
fn a_result_without_any_value_says_what_to_do() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/v_i<Enter><Enter>2000<Enter>4<Tab>");
    answer(&mut bench);
    let seek = bench.screen();
    assert!(seek.contains("nothing reaches 60 %") && seek.contains("perforated"), "{seek}");
    Arc::make_mut(&mut bench.app.pages.search.setup).affected = "yield_margin";
    bench.keys("44");
    answer(&mut bench);
    let matters = bench.screen();
    assert!(matters.contains("nothing to compare"), "{matters}");
    assert!(matters.contains("another one") && !matters.contains("Sobol"), "{matters}");
}

/// The bounds a held variable proposes are taken when they are typed as they stand.
#[test]
fn the_proposed_bounds_of_a_held_variable_can_be_typed() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    bench.keys("4");
    answer(&mut bench);
    bench.keys("<Tab>jjjjjjjjjjj");
    let row = |bench: &Bench| {
        let screen = bench.screen();
        let row = screen.lines().find(|line| line.contains("> m_p")).unwrap_or_default();
        row.split_whitespace().skip(1).take(2).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(row(&bench), "m_p held");
    bench.keys("<Enter><Enter>");
    assert_eq!(row(&bench), "m_p held");
    // Half to double the 0.0295 kg of the scene.
    bench.keys("<Enter><C-u>0.01475..0.059<Enter>");
    assert_eq!(row(&bench), "m_p 0.01475..0.059");
}

/// A number alone in the constraints is in the unit of screens, which the closed row, the open field and the text name.
#[test]
fn a_bound_of_a_front_is_in_the_unit_that_its_field_shows() {
    let mut bench = Bench::ascii(120, 36);
    bench.app.pages.search.page = Page::Front;
    bench.app.pages.search.row = Row::Bounds;
    let bounds = |bench: &Bench| -> Vec<(&str, f64)> {
        let each = bench.app.pages.search.setup.subject_to.iter();
        each.map(|it| (it.measure.name, it.bound)).collect()
    };
    let enter = |bench: &mut Bench, text: &str| {
        bench.press("<C-u>");
        bench.send(Message::Paste(text.to_owned()));
        bench.press("<Enter>");
    };
    bench.press("4<Enter>");
    assert!(bench.screen().contains("stroke_m<=1000 mm"), "{}", bench.screen());
    assert!(
        bench.screen().contains("a number alone is in mm, ms, kN, g or SI"),
        "{}",
        bench.screen()
    );
    // 70 * 1e-3 and 0.07 are the same float; 0.07 * 1e3 is not 70.
    for typed in ["stroke_m<=70", "stroke_m<=70 mm", "stroke_m<=0.07m", "stroke_m <= 7cm"] {
        enter(&mut bench, typed);
        assert_eq!(bounds(&bench), [("stroke_m", 0.07)], "{typed}");
        assert!(bench.screen().contains("stroke<=70.00 mm"), "{}", bench.screen());
        bench.press("<Enter>");
        assert!(bench.screen().contains("stroke_m<=70 mm"), "{}", bench.screen());
    }
    // Percentages and quantities without a unit of screens of their own.
    enter(
        &mut bench,
        "percent_of_baseline<=60,peak_mount_force_n<=20,limit_velocity_m_s>=300,system_mass_kg<=500",
    );
    let expected = [
        ("percent_of_baseline", 60.0),
        ("peak_mount_force_n", 2e4),
        ("limit_velocity_m_s", 300.0),
        ("system_mass_kg", 0.5),
    ];
    assert_eq!(bounds(&bench), expected);
    bench.press("<Enter>");
    enter(&mut bench, "stroke_m<=1 kg");
    assert!(bench.message().contains("or no unit for mm"), "{}", bench.message());
    // Whole at 80 columns, where the footer has no room for it.
    let mut small = Bench::ascii(80, 24);
    small.app.pages.search.page = Page::Front;
    small.app.pages.search.row = Row::Bounds;
    small.press("4<Enter>");
    let text = small.screen().split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("a number alone in mm, ms, kN, g or SI"), "{text}");
}

#[test]
fn what_an_absorber_uses_can_be_varied_and_any_quantity_bounded() {
    let mut bench = Bench::ascii(120, 36);
    let crush = "mechanism.spring.kind=crush F_crush=5e3 x_crush=0.05 k_crush=1e7 face=0.1";
    bench.app.scene = Arc::new(crate::support::scene(crush));
    let offered: Vec<&str> = bench.app.search_bounds().iter().map(|it| it.axis.symbol()).collect();
    for symbol in ["face", "F_crush", "x_crush", "k_crush", "v_i", "h"] {
        assert!(offered.contains(&symbol), "{symbol}: {offered:?}");
    }
    assert!(!offered.contains(&"gamma") && !offered.contains(&"tol"), "{offered:?}");
    bench.app.pages.search.page = Page::Front;
    bench.app.pages.search.row = Row::Bounds;
    bench.press("4<Enter><C-u>peak_mount_force_n<");
    bench.press("=20kN<Enter>");
    assert!(bench.screen().contains("mount force<=20.00 kN"), "{}", bench.screen());
    let request = bench.app.search_request(Page::Front);
    let Ok(SearchRequest::Front(asked)) = request else { panic!("{request:?}") };
    let bound = asked.subject_to.iter().find(|it| it.measure.name == "peak_mount_force_n").unwrap();
    assert_eq!((bound.at_most, bound.bound), (true, 2e4));
    // A session keeps it, and what the command line refuses is refused in its words.
    let mut other = Bench::ascii(120, 36);
    other.app.restore_setups(bench.app.setups());
    assert_eq!(other.app.pages.search.setup.subject_to, bench.app.pages.search.setup.subject_to);
    bench.press("<Enter><C-u>stroke_m=1<Enter>");
    assert!(bench.screen().contains("write QUANTITY<=VALUE"), "{}", bench.screen());
}

/// A stack lacks three of the four goals, and the stroke that is bounded by default.
#[test]
fn the_front_of_a_stack_has_the_goals_that_a_stack_has() {
    let mut bench = Bench::ascii(80, 24);
    bench.app.scene = Arc::new(preset::resolve("array-stacked", None).unwrap().scene);
    let SearchRequest::Front(request) = bench.app.search_request(Page::Front).unwrap() else {
        panic!("another study");
    };
    let names = request.measures().iter().map(|it| it.name).collect::<Vec<_>>();
    assert_eq!(names, ["final_penetration_m"]);
}
