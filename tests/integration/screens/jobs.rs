//! Jobs on the screen: what they show, how they are stopped, and what is kept of them.

use std::sync::{Arc, mpsc};
use std::time::Duration;

use super::bench::{Bench, ended, made, stopped};
use super::search::in_search;
use super::{accuracy, limit, search};
use crate::support::scene;
use cmra::tui::app::running::Running;
use cmra::tui::message::{Effect, EffectReport, ExportOutcome, FileTask, Message};
use cmra::tui::pages::search::state::Page;
use cmra::tui::theme::GlyphSet;
use cmra::worker::studies::{
    EfficiencyMapStudy, LimitSearch, MassComparison, RequestVariant, SearchAnswer, SearchRequest,
};
use cmra::worker::{ReportBody, TaskReport, Worker};
use cmra_engine::model::run::EndReason;
use cmra_engine::model::scene::Scene;

/// Samples of the Monte Carlo study that runs beside a goal seek: enough to outlast it, few enough for a build without optimisation.
const SAMPLES: usize = 2000;

/// The search that was submitted last.
fn searched(bench: &mut Bench) -> (u64, Page) {
    let studies = bench.studies();
    let found = studies
        .iter()
        .rev()
        .find_map(|it| Some((it.id, Page::from_request(SearchRequest::downcast(&it.request)?))));
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
    bench.press("4");
    search::answer(&mut bench);
    bench.press("4r");
    bench.press("7");
    assert!(bench.screen().contains("4:Search is computing"), "{}", bench.screen());
    bench.effects.clear();
    bench.press("<Esc>");
    assert!(bench.effects.is_empty(), "{:?}", bench.effects);
    assert!(bench.message().contains("4:Search"), "{}", bench.message());
    bench.press("4<Esc>");
    assert!(bench.has_cancelled());
}

/// Counters of finished parts never exceed their totals.
#[test]
fn counters_do_not_pass_their_totals() {
    let mut bench = Bench::ascii(120, 36);
    bench.press("3v");
    let study = bench.studies().pop().expect("a search for the limit");
    bench.progress(study.id, 90, 80);
    assert!(bench.screen().contains("80 of about 80 shots"), "{}", bench.screen());
    let mut bench = Bench::ascii(120, 36);
    bench.press("4");
    search::answer(&mut bench);
    bench.press("4r");
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

/// Studies that were asked for, by a tab's page, run beside each other: none ends or waits for another one.
#[test]
fn a_search_goes_on_while_others_are_begun() {
    let mut bench = search::open(GlyphSet::Ascii, (80, 24));
    bench.keys("4r");
    let (front, _) = searched(&mut bench);
    // Through the two pages without results to the goal seek, whose setup is edited, and back.
    bench.keys("444<Tab><Enter>50 %<Enter><Tab>r4");
    assert_eq!(bench.app.pages.search.page, Page::Front);
    assert!(bench.screen().contains("searching"), "{}", bench.screen());
    let ended = |effect: &Effect| matches!(effect, Effect::Cancel(id) if *id == front);
    assert!(!bench.effects.iter().any(ended), "{:?}", bench.effects);
    bench.keys("44r");
    let jobs: Vec<Page> =
        bench.app.jobs.studies.iter().filter(|it| !it.is_look).map(page_of).collect();
    assert_eq!(jobs, [Page::Front, Page::Seek, Page::MonteCarlo]);
    search::answer(&mut bench);
    assert_eq!(bench.app.pages.search.page, Page::MonteCarlo);
    assert!(bench.app.pages.search.shown().is_some(), "{}", bench.screen());
}

fn page_of(running: &Running) -> Page {
    Page::from_request(SearchRequest::downcast(&running.request).expect("a search"))
}

/// Monte Carlo and a goal seek in the workbench, on real threads: both run at once, and both end with all of their runs.
#[test]
fn monte_carlo_and_a_goal_seek_run_at_once_and_both_end() {
    let mut bench = Bench::ascii(120, 36);
    let (send, reports) = mpsc::channel();
    let worker = Worker::spawn(move |report: TaskReport| drop(send.send(report)));
    bench.press("4444");
    Arc::make_mut(&mut bench.app.pages.search.setup).samples = SAMPLES;
    bench.effects.clear();
    bench.press("r");
    // Monte Carlo has begun when the goal seek is asked for.
    let submit = |bench: &mut Bench| {
        for effect in std::mem::take(&mut bench.effects) {
            match effect {
                Effect::Submit(task) => worker.submit(task),
                Effect::Cancel(id) => worker.cancel(id),
                _ => {}
            }
        }
    };
    submit(&mut bench);
    bench.press("4r");
    submit(&mut bench);
    let is_left = |bench: &Bench| bench.app.jobs.studies.iter().any(|running| !running.is_look);
    while is_left(&bench) {
        bench.send(Message::Report(reports.recv().expect("a report")));
        submit(&mut bench);
    }
    for page in [Page::Seek, Page::MonteCarlo] {
        assert!(bench.app.pages.search.results[page as usize].is_complete(), "{page:?}");
    }
    let scatter = bench.app.pages.search.results[Page::MonteCarlo as usize].result.clone();
    let Some(SearchAnswer::MonteCarlo(report)) = scatter.as_deref() else { panic!("{scatter:?}") };
    assert_eq!(report.samples, SAMPLES);
}

/// `4 4 4`: each page is looked at on one thread for less than 0.2 s, the front not at all, and any key ends it.
#[test]
fn looking_starts_little_work_and_a_key_ends_it() {
    let mut bench = Bench::ascii(80, 24);
    for keys in ["4", "4", "4", "4", "3", "v", "2", "5", "5", "<Tab>", "6"] {
        bench.press(keys);
        let looks = bench.tasks(|task| Some((task.id, task.threads, task.budget)));
        let time: Duration = looks.iter().map(|look| look.2.expect("little time")).sum();
        assert!(time < Duration::from_millis(200), "{keys}: {time:?}");
        assert!(looks.iter().all(|look| look.1 == 1), "{keys}");
        bench.effects.clear();
        bench.press("?<Esc>");
        for (id, ..) in looks {
            let ends = |effect: &Effect| matches!(effect, Effect::Cancel(other) if *other == id);
            assert!(bench.effects.iter().any(ends), "{keys}: {:?}", bench.effects);
        }
    }
}

/// A look that ended early says so, and is not taken for the result that `r` gives.
#[test]
fn a_first_look_says_how_far_it_came() {
    let mut bench = Bench::ascii(120, 36);
    bench.press("444");
    let study = bench.studies().pop().expect("a look");
    bench.reply(study.id, stopped((512, 2304), search::found(&study)));
    let screen = bench.screen();
    assert!(screen.contains("first look: press r (512 of 2304 runs)"), "{screen}");
    assert!(!screen.contains(" done"), "{screen}");
    bench.keys("e<Enter>");
    assert!(writes_a_part(&bench));
    let (to, csv, _) = bench.exported().expect("an export");
    assert!(to.path.to_string_lossy().contains("-incomplete.csv"), "{:?}", to.path);
    let rows: Vec<&str> = csv.lines().collect();
    assert!(rows[0].ends_with(",complete") && rows[1..].iter().all(|row| row.ends_with(",false")));
    // Shown again, it is looked at again; asked for by a key, it has all the time and threads.
    bench.press("<Esc>14");
    assert_eq!(bench.studies().len(), 1);
    bench.press("r");
    assert_eq!(bench.tasks(|task| Some(task.budget)), [None]);
}

/// A look whose time is over before the first run of a slow scene: the page says so, and neither that somebody cancelled it nor what the
/// result is.
#[test]
fn a_first_look_without_time_draws_no_conclusion() {
    let (send, reports) = mpsc::channel();
    let worker = Worker::spawn(move |report: TaskReport| drop(send.send(report)));
    let mut wrong = Vec::new();
    for keys in ["3", "3v", "4", "444", "4444", "5", "55", "55<Tab>", "6"] {
        let mut bench = Bench::ascii(80, 24);
        bench.app.scene =
            Arc::new(scene("spring=column e_spring=200 h=0.0057 gamma=10.6 interface=plastic"));
        bench.press(keys);
        while !bench.app.jobs.studies.is_empty() {
            for mut task in bench.tasks(|task| Some(task.clone())) {
                task.budget = Some(Duration::ZERO);
                worker.submit(task);
            }
            bench.send(Message::Report(reports.recv().expect("a report")));
        }
        let screen = bench.screen();
        let is_said = ["3", "55", "55<Tab>", "6"].contains(&keys)
            || screen.contains("not computed yet: r computes it");
        let conclusions = [
            "cancelled",
            "stopped before",
            "no point",
            "nothing to compare",
            "above 1e-6",
            "0 of 0",
        ];
        if !is_said || conclusions.iter().any(|it| screen.contains(it)) {
            wrong.push(screen);
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Results that another preset gave keep its title in the name of their file.
#[test]
fn the_results_of_another_preset_are_not_exported_under_the_present_name() {
    let mut bench = Bench::ascii(120, 36);
    let titled = |title: &str, bench: &mut Bench| {
        let scene = bench.app.scene.as_ref().clone();
        bench.app.scene = Arc::new(Scene { title: title.to_owned(), ..scene });
    };
    titled("Baseline of chapter 9", &mut bench);
    bench.press("444r");
    let study = bench.studies().pop().expect("a search");
    bench.reply(study.id, ended(search::found(&study)));
    bench.app.base.name = "free-plate".to_owned();
    titled("Free plate", &mut bench);
    bench.keys("e<Enter>");
    let (to, ..) = bench.exported().expect("an export");
    let file = to.path.file_name().unwrap().to_string_lossy().into_owned();
    assert!(file.starts_with("baseline-of-chapter-9-"), "{file}");
}

/// Whichever key or page would end a job of more than 5 s, it is ended only after a question.
#[test]
fn a_long_job_is_ended_only_after_a_question() {
    let is_ended = |bench: &Bench, id: u64| bench.app.jobs.studies.iter().all(|it| it.id != id);
    for (open, again) in [
        ("3", "r"),
        ("5", "r"),
        ("55", "r"),
        ("55<Tab>", "r"),
        ("6", "r"),
        ("2", "r"),
        ("44", "r"),
        ("4444", "r"),
        ("3v", "r"),
    ] {
        let mut bench = Bench::ascii(120, 36);
        bench.press(open);
        if again == "r" {
            bench.press("r");
        }
        let id = bench.app.jobs.studies.last().expect(open).id;
        bench.send(Message::LongJob(id));
        bench.press(again);
        assert!(!is_ended(&bench, id), "{open}");
        assert!(bench.message().contains("again ends it"), "{open}: {}", bench.message());
        // Another key takes the question back.
        bench.press("?<Esc>");
        bench.press(again);
        assert!(!is_ended(&bench, id), "{open}");
        bench.press(again);
        assert!(is_ended(&bench, id), "{open}");
    }
    // An edit of the scene leaves it, also where its page follows edits.
    for open in ["2r", "3r", "4r", "55r"] {
        let mut bench = Bench::ascii(120, 36);
        bench.press(open);
        let id = bench.app.jobs.studies.last().expect(open).id;
        bench.send(Message::LongJob(id));
        bench.press("1/v_i<Enter>l<Esc>");
        bench.press(&open[..1]);
        assert!(!is_ended(&bench, id), "{open}");
        let ended = |effect: &Effect| matches!(effect, Effect::Cancel(other) if *other == id);
        assert!(!bench.effects.iter().any(ended), "{open}");
    }
    let mut bench = Bench::ascii(120, 36);
    bench.press("r");
    let id = bench.app.jobs.current.as_ref().expect("a run").id;
    bench.send(Message::LongJob(id));
    bench.press("r");
    assert_eq!(bench.app.jobs.current.as_ref().map(|job| job.id), Some(id));
    bench.press("r");
    assert_ne!(bench.app.jobs.current.as_ref().map(|job| job.id), Some(id));
}

/// The key that cancels asks as well. Pressed twice it quits, also then, and the session is kept.
#[test]
fn ctrl_c_ends_a_long_job_only_after_a_question() {
    let quits =
        |bench: &Bench| matches!(bench.effects[..], [.., Effect::SaveSession, Effect::Quit]);
    let asks = |bench: &Bench, id: u64| {
        let ended = |effect: &Effect| matches!(effect, Effect::Cancel(other) if *other == id);
        let is_left = !bench.effects.iter().any(ended) && !quits(bench);
        is_left && bench.message().contains("more than 5 s: Ctrl-c again quits")
    };
    for open in ["r", "2r", "3r", "4r", "55r", "6r"] {
        let mut bench = Bench::ascii(120, 36);
        bench.press(open);
        let jobs = &bench.app.jobs;
        let id = jobs.studies.last().or(jobs.current.as_ref()).expect(open).id;
        bench.send(Message::LongJob(id));
        bench.press("<C-c>");
        assert!(asks(&bench, id), "{open}: {}", bench.message());
        // Another key takes the question back.
        bench.press("?<Esc><C-c>");
        assert!(asks(&bench, id), "{open}: {}", bench.message());
        bench.press("<C-c>");
        assert!(quits(&bench), "{open}");
    }
    // In a field the key only closes; then it asks.
    let mut bench = in_search((80, 24));
    bench.press("r");
    let id = bench.app.jobs.studies.last().expect("a search").id;
    bench.send(Message::LongJob(id));
    bench.press("<Enter>50<C-c>");
    assert!(bench.app.field().is_none() && !quits(&bench));
    bench.press("<C-c>");
    assert!(asks(&bench, id), "{}", bench.message());
    bench.press("<C-c>");
    assert!(quits(&bench));
}

/// The job has ended by itself: nothing is left to ask, and the key asks again before it quits.
#[test]
fn a_question_about_a_job_goes_with_the_job() {
    for key in ["<C-c>", "<Esc>", "q", "r"] {
        let mut bench = in_search((80, 24));
        bench.press("r");
        let id = bench.app.jobs.studies.last().expect("a search").id;
        bench.send(Message::LongJob(id));
        bench.press(key);
        assert!(
            bench.message().contains("is running") || bench.message().contains("more than 5 s")
        );
        bench.reply(id, ReportBody::Ended(None));
        assert!(!bench.screen().contains("again"), "{}", bench.screen());
        bench.press("<C-c>");
        assert!(bench.message().contains("no job is running"), "{key}: {}", bench.message());
    }
}

#[test]
fn an_error_stays_with_the_page_that_was_searched() {
    let mut bench = search::open(GlyphSet::Ascii, (80, 24));
    bench.keys("4r");
    let (front, _) = searched(&mut bench);
    bench.keys("4");
    bench.reply(front, ReportBody::Failed("no design has a stroke".to_owned()));
    assert_eq!(bench.app.pages.search.page, Page::Sensitivity);
    bench.app.notice = None;
    assert!(!bench.screen().contains("cannot be searched"), "{}", bench.screen());
    bench.app.pages.search.page = Page::Front;
    bench.app.notice = None;
    let screen = bench.screen();
    assert!(screen.contains("cannot be searched"), "{screen}");
    assert!(bench.message().contains("no design has a stroke"), "{}", bench.message());
}

/// A study that a person stopped waits for `r`, also where the tab is shown again, and is written as a part.
#[test]
fn a_stopped_map_says_so_and_waits() {
    let mut bench = limit::open(GlyphSet::Ascii, (120, 40));
    let found = bench.app.pages.limit.map.result.clone().expect("a map");
    let mut part = cmra_studies::study::compare::map::Map::clone(&found);
    part.cells[34..].fill(None);
    bench.press("r");
    let study = bench.studies().pop().expect("a map");
    assert!(EfficiencyMapStudy::downcast(&study.request).is_some());
    bench.keys("<Esc>");
    bench.reply(study.id, stopped((16, 169), part));
    let screen = bench.screen();
    assert!(screen.contains("cancelled: press r (34 of 169 points)"), "{screen}");
    bench.keys("13");
    let again = bench.studies();
    assert!(again.iter().all(|study| EfficiencyMapStudy::downcast(&study.request).is_none()));
    assert!(again.iter().all(|study| LimitSearch::downcast(&study.request).is_none()));
    bench.keys("e<Enter>");
    assert!(writes_a_part(&bench));
    bench.press("<Esc><Tab>v");
    let asked = bench.studies();
    assert!(asked.iter().all(|study| MassComparison::downcast(&study.request).is_none()));
    assert!(asked.iter().any(|study| LimitSearch::downcast(&study.request).is_some()));
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
