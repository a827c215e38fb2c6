//! Jobs on the screen: what they show, how they are stopped, and what is kept of them.

use std::time::Duration;

use super::bench::{Bench, ended, made};
use super::search::in_search;
use super::{accuracy, limit, search};
use cmra::model::run::EndReason;
use cmra::tui::message::{Effect, EffectReport, ExportOutcome, FileTask, Message};
use cmra::tui::pages::search::state::Page;
use cmra::tui::theme::GlyphSet;
use cmra::worker::ReportBody;
use cmra::worker::studies::{AskedFor, Comparison, EqualMass, LimitSearch, SearchRequest};

/// The search that was submitted last.
fn searched(bench: &mut Bench) -> (u64, Page) {
    let studies = bench.studies();
    let found =
        studies.iter().rev().find_map(|it| Some((it.id, Page::of(SearchRequest::of(&it.asked)?))));
    found.expect("a search")
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

#[test]
fn a_cancelled_study_draws_no_conclusion() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("5");
    accuracy::answer(&mut bench, 1);
    let screen = bench.screen();
    assert!(screen.contains("not computed yet ("), "{screen}");
    assert!(!screen.contains("no method"), "{screen}");
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
fn an_export_that_ends_leaves_another_dialog_alone() {
    let path: std::path::PathBuf = "/home/ada/work/a.csv".into();
    let ended = Message::Done(EffectReport::Exported(path.clone(), ExportOutcome::Exists(path)));
    let mut bench = Bench::ascii(80, 24);
    bench.keys("e<C-u>a.csv<Enter><Esc>s");
    bench.send(ended.clone());
    assert!(bench.app.has_dialog() && !bench.screen().contains(" o overwrite"));
    assert!(bench.message().contains("a.csv already exists"), "{}", bench.message());
    bench.keys("<Esc>e<C-u>b.csv");
    bench.send(ended.clone());
    assert!(bench.app.has_dialog() && !bench.screen().contains(" o overwrite"));
    bench.keys("<C-u>a.csv");
    bench.send(ended);
    assert!(bench.screen().contains(" o overwrite"), "{}", bench.screen());
}

#[test]
fn looking_at_another_page_leaves_a_search_alone() {
    let mut bench = search::open(GlyphSet::Ascii, (80, 24));
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
    let mut bench = search::open(GlyphSet::Ascii, (80, 24));
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

/// Each pane of the Limit tab tells of its own study; what a person stopped waits for `r`, also where the tab is shown again.
#[test]
fn a_stopped_comparison_says_so_in_its_panes_and_waits() {
    let mut bench = limit::open(GlyphSet::Ascii, (120, 40));
    bench.keys("<Tab>r");
    search::answer(&mut bench);
    let part = stopped(&bench);
    bench.keys("r");
    let study = bench.studies().remove(0);
    assert!(EqualMass::of(&study.asked).is_some());
    bench.keys("<Esc>");
    bench.reply(study.id, ended(part));
    for pane in ["comparison", "mass efficiency"] {
        assert!(bench.screen().contains("cancelled: press r"), "{pane}: {}", bench.screen());
        bench.keys("<Tab>");
    }
    assert!(!bench.screen().contains("cancelled"), "the limit is there: {}", bench.screen());
    bench.keys("13");
    let again = bench.studies();
    assert!(again.iter().all(|study| LimitSearch::of(&study.asked).is_none()));
    assert!(again.iter().all(|study| EqualMass::of(&study.asked).is_none()));
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
    bench.reply(job, ended(part));
    assert!(bench.app.pins[0].run.is_none() && bench.app.pins[0].job.is_none());
    for other in jobs.iter().filter(|other| other.id != job) {
        bench.reply(other.id, ended(made(&other.scene)));
    }
    bench.keys("jl ");
    assert!(bench.app.pins.iter().all(|pin| pin.run.is_some()));
}

#[test]
fn a_design_that_is_being_computed_cannot_be_loaded_yet() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("2<Enter>");
    assert_eq!(bench.message(), "being computed");
}

#[test]
fn ctrl_c_closes_the_field_of_a_search_and_does_not_leave() {
    let mut bench = in_search((80, 24));
    bench.keys("<Enter>50");
    assert!(bench.app.field().is_some());
    bench.keys("<C-c>");
    assert!(bench.app.field().is_none());
    assert!(!bench.effects.iter().any(|effect| matches!(effect, Effect::Quit)));
}
