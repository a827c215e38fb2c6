//! Results that a page keeps: of which scene, how far they came, and what a key of another meaning is called.

use std::collections::BTreeMap;
use std::time::Duration;

use super::bench::{Bench, ended, made};
use super::{limit, search, stability};
use cmra::files::library;
use cmra::model::library::Library;
use cmra::model::run::EndReason;
use cmra::tui::keymap::Keymap;
use cmra::tui::message::{Effect, FileTask, PresetEntry};
use cmra::tui::pages::limit::comparison::{Comparison, EqualMass};
use cmra::tui::pages::limit::state::LimitSearch;
use cmra::tui::pages::search::state::{Page, Request};
use cmra::tui::theme::GlyphSet;
use cmra::worker::{Finding, ReportBody};

/// The search that was submitted last.
fn searched(bench: &mut Bench) -> (u64, Page) {
    let studies = bench.studies();
    let found = studies.iter().rev().find_map(|it| Some((it.id, it.asked.of::<Request>()?.page())));
    found.expect("a search")
}

/// The search tab with a goal seek that is done.
fn sought(size: (u16, u16)) -> Bench {
    let mut bench = Bench::open(GlyphSet::Ascii, size);
    bench.keys("4<Tab>");
    search::answer(&mut bench);
    bench
}

#[test]
fn looking_at_another_page_leaves_a_search_alone() {
    let mut bench = sought((80, 24));
    bench.keys("4");
    let front = bench.app.jobs.studies[0].id;
    // Through the two pages without results to the goal seek, whose setup is edited, and back.
    bench.keys("444<Tab><Enter>50 %<Enter><Tab>4");
    assert_eq!(bench.app.pages.search.page, Page::Front);
    assert!(bench.screen().contains("searching"), "{}", bench.screen());
    // The next page waits for it, and begins when it is done.
    bench.keys("4");
    let jobs: Vec<u64> = bench.app.jobs.studies.iter().map(|running| running.id).collect();
    assert_eq!(jobs, [front]);
    assert!(bench.screen().contains("waits for another search"), "{}", bench.screen());
    search::answer(&mut bench);
    assert_eq!(bench.app.pages.search.page, Page::Sensitivity);
    assert!(bench.app.pages.search.shown().is_some(), "{}", bench.screen());
}

#[test]
fn an_error_stays_with_the_page_that_was_searched() {
    let mut bench = sought((80, 24));
    bench.keys("4");
    let (front, _) = searched(&mut bench);
    bench.keys("4");
    bench.reply(front, ReportBody::Failed("no design has a stroke".to_owned()));
    assert_eq!(bench.app.pages.search.page, Page::Sensitivity);
    // The page that waited has its turn.
    let (waiting, page) = searched(&mut bench);
    assert_eq!(page, Page::Sensitivity);
    bench.reply(waiting, ReportBody::Ended { found: None, took: Duration::ZERO });
    bench.app.notice = None;
    assert!(!bench.screen().contains("cannot be searched"), "{}", bench.screen());
    bench.app.pages.search.page = Page::Front;
    bench.app.notice = None;
    let screen = bench.screen();
    assert!(screen.contains("cannot be searched"), "{screen}");
    assert!(bench.message().contains("no design has a stroke"), "{}", bench.message());
}

#[test]
fn each_page_of_the_search_has_its_own_zoom_until_other_results_come() {
    let mut bench = sought((80, 24));
    bench.keys("+");
    assert!(bench.app.pages.search.zoomed().is_some());
    bench.keys("4");
    search::answer(&mut bench);
    assert_eq!(bench.app.pages.search.zoomed(), None);
    bench.keys("444");
    assert!(bench.app.pages.search.zoomed().is_some());
    bench.keys("r");
    search::answer(&mut bench);
    assert!(bench.app.pages.search.zoomed().is_some(), "the same results");
    bench.keys("1jjl4r");
    search::answer(&mut bench);
    assert_eq!(bench.app.pages.search.zoomed(), None);
}

#[test]
fn the_histogram_of_the_samples_is_zoomed_and_another_quantity_is_shown_whole() {
    let mut bench = sought((80, 24));
    bench.keys("444");
    search::answer(&mut bench);
    let whole = bench.screen();
    bench.keys("+");
    let zoomed = bench.app.pages.search.zoomed().expect("a part");
    assert_ne!(bench.screen(), whole);
    bench.keys("]");
    assert!(bench.app.pages.search.zoomed().expect("a part").lo() > zoomed.lo());
    bench.keys("0");
    assert_eq!(bench.screen(), whole);
    bench.keys("+<Tab>/percent<Enter>l");
    assert_eq!(bench.app.pages.search.zoomed(), None, "{}", bench.screen());
}

#[test]
fn another_curve_of_the_limit_is_shown_whole() {
    let mut bench = limit::open(GlyphSet::Ascii, (120, 36));
    bench.keys("l++");
    assert!(bench.app.pages.limit.zoomed.is_some());
    bench.keys("r");
    limit::answer(&mut bench);
    assert!(bench.app.pages.limit.zoomed.is_some(), "the same curve");
    bench.keys("r");
    limit::end(&mut bench, |report| report.shots.truncate(20));
    assert_eq!((bench.app.pages.limit.zoomed, bench.app.pages.limit.cursor), (None, None));
}

#[test]
fn the_cursor_of_a_map_begins_again_on_a_map_of_another_scene() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("3");
    search::answer(&mut bench);
    bench.keys("<Tab><Tab>ll");
    assert!(bench.app.pages.limit.map_cursor.is_some());
    bench.keys("r");
    search::answer(&mut bench);
    assert!(bench.app.pages.limit.map_cursor.is_some(), "the same map");
    bench.keys("1jjl3");
    search::answer(&mut bench);
    assert_eq!(bench.app.pages.limit.map_cursor, None);
}

/// Whether the table that was exported last is a part.
pub(super) fn writes_a_part(bench: &Bench) -> bool {
    let content = bench.effects.iter().rev().find_map(|effect| match effect {
        Effect::Files(FileTask::Export(_, content)) => Some(format!("{content:?}")),
        _ => None,
    });
    content.expect("an export").contains("is_complete: false")
}

/// The comparison with a part of its map, as a person left it.
fn stopped(bench: &Bench) -> Comparison {
    let found = bench.app.comparison().expect("a comparison").clone();
    let mut map = found.map.clone().expect("a map");
    map.cells.truncate(30);
    Comparison { map: Some(map), ..found }
}

/// Each pane of the Limit tab tells of its own study; what a person stopped waits for `r`, also where the tab is shown again.
#[test]
fn a_stopped_comparison_says_so_in_its_panes_and_waits() {
    let mut bench = limit::open(GlyphSet::Ascii, (120, 40));
    bench.keys("<Tab>r");
    search::answer(&mut bench);
    let part = stopped(&bench);
    bench.keys("r");
    let study = bench.studies().remove(0);
    assert!(study.asked.of::<EqualMass>().is_some());
    bench.keys("<Esc>");
    bench.reply(study.id, ended(Finding::new(part)));
    for pane in ["comparison", "mass efficiency"] {
        assert!(bench.screen().contains("cancelled: press r"), "{pane}: {}", bench.screen());
        bench.keys("<Tab>");
    }
    assert!(!bench.screen().contains("cancelled"), "the limit is there: {}", bench.screen());
    bench.keys("13");
    let again = bench.studies();
    assert!(again.iter().all(|study| study.asked.of::<LimitSearch>().is_none()));
    assert!(again.iter().all(|study| study.asked.of::<EqualMass>().is_none()));
    // Its map is written as a part.
    bench.keys("<S-Tab>e<Enter>");
    assert!(writes_a_part(&bench));
}

/// A pin whose run was stopped has no result, and gets one with the next pins that are computed.
#[test]
fn a_part_of_a_run_is_not_the_result_of_a_pin() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("jjl ");
    let jobs = bench.jobs();
    assert_eq!(bench.app.pins.len(), 1);
    let job = bench.app.pins[0].job.expect("the pin is computed");
    let mut part = made(&bench.app.pins[0].scene);
    part.end = EndReason::Cancelled;
    bench.reply(job, ended(Finding::new(part)));
    assert!(bench.app.pins[0].run.is_none() && bench.app.pins[0].job.is_none());
    for other in jobs.iter().filter(|other| other.id != job) {
        bench.reply(other.id, ended(Finding::new(made(&other.scene))));
    }
    bench.keys("jl ");
    assert!(bench.app.pins.iter().all(|pin| pin.run.is_some()));
}

/// `config.toml` gives actions other keys: the texts name those.
#[test]
fn texts_name_the_keys_in_force() {
    let mut bench = Bench::ascii(80, 24);
    let keys = [("run", "F5"), ("undo", "U"), ("view", "F2")];
    let keys = keys.map(|(action, key)| (action.to_owned(), vec![key.to_owned()]));
    bench.app.keymap = Keymap::remapped(&BTreeMap::from(keys)).unwrap();
    bench.keys("3");
    limit::end(&mut bench, |report| report.is_complete = false);
    assert!(bench.screen().contains("cancelled: press F5"), "{}", bench.screen());
    bench.keys("<Tab>");
    assert!(bench.message().contains("(F2: the next one"), "{}", bench.message());
    bench.keys("1jjl ");
    bench.keys("r");
    assert!(bench.message().contains("`r` does nothing here"), "{}", bench.message());
    bench.keys("2<Tab>g<Enter>zzz<Enter>");
    assert!(bench.message().contains("l steps through all of them"), "{}", bench.message());
}

/// No text and no footer has a key of the table where `config.toml` gives the action another one or none.
#[test]
fn no_text_has_a_key_that_is_not_in_force() {
    let mut bench = Bench::ascii(160, 50);
    let mut keys = BTreeMap::new();
    for (action, key) in [
        ("next-event", vec!["F1"]),
        ("previous-event", vec!["F2"]),
        ("far-left", vec!["F3"]),
        ("far-right", vec!["F4"]),
        ("difference", vec!["F6"]),
        ("tab-limit", vec!["F7"]),
        ("window", vec![]),
        ("mark", vec![]),
    ] {
        keys.insert(action.to_owned(), key.into_iter().map(str::to_owned).collect());
    }
    bench.app.keymap = Keymap::remapped(&keys).unwrap();
    bench.keys("<Tab>");
    let screen = bench.screen();
    assert!(screen.contains(" F7:Limit "), "{screen}");
    let footer = screen.lines().last().unwrap();
    assert!(footer.contains(" F1/F2 event ") && !footer.contains("   "), "{footer}");
    assert!(!footer.contains("whole") && !footer.contains("pin"), "{footer}");
    bench.keys("?");
    assert!(bench.screen().contains("(F3 F4 ten columns)"), "{}", bench.screen());
}

/// The curve of the limit and the map of mass efficiency hold at any impact velocity.
#[test]
fn a_shot_that_is_loaded_leaves_the_curve_and_the_map_as_they_are() {
    let mut bench = limit::open(GlyphSet::Ascii, (120, 40));
    bench.keys("<Tab>r");
    search::answer(&mut bench);
    bench.keys("<S-Tab>l<Enter>");
    let velocity_m_s = bench.app.scene.projectile.velocity_m_s;
    assert!((velocity_m_s - 232.9).abs() < 0.1, "{velocity_m_s}");
    assert!(!bench.screen().contains("scene's results"), "{}", bench.screen());
    // 232.3 m/s over 232.9 m/s.
    assert!(bench.screen().contains("margin -0.3 %: 232.9 m/s perforates"), "{}", bench.screen());
    bench.keys("<Tab>");
    assert!(bench.screen().contains("another scene's results: press r"), "of another shot");
    bench.keys("<Tab>h");
    assert!(!bench.screen().contains("scene's results"), "{}", bench.screen());
    assert!(bench.app.efficiency_design().is_ok());
}

/// The absorber that is compared with has its name in the table; loading it and taking that back keeps the comparison.
#[test]
fn an_absorber_that_is_loaded_and_undone_is_still_the_one_compared_with() {
    let mut bench = limit::open(GlyphSet::Ascii, (120, 40));
    let absorbers = library::list(None).0.into_iter().filter(|it| it.library == Library::Absorbers);
    bench.app.presets.extend(absorbers.map(PresetEntry::of_part));
    bench.keys("<Tab>v");
    search::answer(&mut bench);
    let name = bench.app.absorber().expect("an absorber").name.clone();
    let is_current = |bench: &Bench| {
        let screen = bench.screen();
        assert!(screen.contains(&format!("pay? with {name} ---")), "{screen}");
        assert!(screen.contains(&format!(" {name}  rigid mount")), "{screen}");
        assert!(!bench.app.comparison_is_old());
        assert!(bench.app.efficiency_design().is_ok());
    };
    is_current(&bench);
    assert!(bench.screen().contains("Residual velocity, own spring"), "{}", bench.screen());
    let before = bench.app.scene.clone();
    bench.keys("<Enter>");
    assert_ne!(bench.app.scene, before);
    is_current(&bench);
    bench.keys("u");
    assert_eq!(bench.app.scene, before);
    is_current(&bench);
}

#[test]
fn a_design_that_is_being_computed_cannot_be_loaded_yet() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("3<Tab><Tab><Enter>");
    assert_eq!(bench.message(), "being computed");
}

/// Help lists what works on the page: of Monte Carlo nothing can be loaded.
#[test]
fn help_leaves_out_what_a_page_has_not() {
    let mut bench = sought((80, 24));
    bench.keys("444");
    search::answer(&mut bench);
    bench.keys("?");
    assert!(!bench.screen().contains("load this design"), "{}", bench.screen());
}

#[test]
fn help_explains_the_words_of_the_comparison_and_of_the_stiff_scenes() {
    let mut bench = limit::open(GlyphSet::Ascii, (80, 24));
    bench.keys("<Tab>?");
    assert!(bench.screen().contains("the plate is perforated above it"), "{}", bench.screen());
    let mut bench = stability::open(GlyphSet::Ascii, (80, 24));
    bench.keys("<Tab>?");
    assert!(bench.screen().contains("s: stored"), "{}", bench.screen());
}
