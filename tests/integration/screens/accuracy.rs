//! The Accuracy tab: keys and whole screens, on made-up measurements whose digits never change a picture.

use std::sync::Arc;

use super::bench::{Bench, ended, stopped};
use cmra::tui::keymap::Tab;
use cmra::tui::message::Message;
use cmra::tui::theme::GlyphSet;
use cmra::worker::ReportBody;
use cmra::worker::studies::{MethodBenchmark, StudyResult};
use cmra_engine::model::run::Outcome;
use cmra_engine::model::scene::Scene;
use cmra_studies::study::accuracy::method::{
    Answer, Compared, Method, Parameter, Refusal, Results, SettingGrid,
};
use cmra_studies::study::accuracy::reference::{Reference, ReferenceSource, References};
use cmra_studies::study::accuracy::{AccuracyReport, Measured, MethodReport, OmissionGain, Point};

/// Numbers for the depth and the time alone.
fn of_end(depth: f64, time: f64) -> Results {
    Results::new(|of| match of {
        Compared::Depth => Some(depth),
        Compared::Time => Some(time),
        _ => None,
    })
}

/// When the made-up contact ends, s, and how deep it is then, m.
const END: (f64, f64) = (113.6e-6, 4.571_788_754e-3);

/// Order, error at ten steps (or at a tolerance of one), and cost of a step, s, of a made-up method.
fn character(method: Method) -> (f64, f64, f64) {
    match method {
        Method::ThesisPrinted => (1.0, 0.05, 40e-9),
        Method::Rk4 => (1.5, 0.02, 50e-9),
        Method::Rk4Events => (4.0, 1e-3, 60e-9),
        Method::Dop853 => (8.0, 0.5, 200e-9),
        Method::Radau => (5.0, 0.8, 2e-6),
        Method::ContactKernel => (16.0, 0.05, 50e-9),
        Method::Full => (16.0, 0.1, 105e-9),
        Method::Auto => (16.0, 0.05, 110e-9),
    }
}

fn point(method: Method, parameter: Parameter) -> Point {
    let (order, lead, cost_s) = character(method);
    let steps = match parameter {
        Parameter::Step(dt_s) => END.0 / dt_s,
        Parameter::Tolerance(tolerance) => 4.0 + (lead / tolerance).powf(1.0 / order),
    };
    let error = match parameter {
        Parameter::Step(_) => lead * (10.0 / steps).powf(order),
        Parameter::Tolerance(tolerance) => 0.3 * tolerance,
    };
    let is_refused = method == Method::Radau && error < 1e-11;
    let min_s = steps * cost_s;
    let whole: usize = format!("{steps:.0}").parse().expect("a whole number");
    let measured = Measured {
        answer: Answer {
            outcome: Outcome::Arrested,
            results: of_end(END.1, END.0),
            steps: whole,
            rejected: 0,
            evaluations: 4 * whole,
        },
        errors: of_end(error, error),
        floor: 1e-15,
        min_s,
    };
    Point { parameter, result: if is_refused { Err(Refusal::TooMuchWork) } else { Ok(measured) } }
}

/// Made-up measurements of the first few methods.
fn measured(scene: &Arc<Scene>, methods: usize) -> AccuracyReport {
    let reference = Reference {
        basis: ReferenceSource::Stored("S2"),
        outcome: Outcome::Arrested,
        results: of_end(END.1, END.0),
        uncertainty: Some(1e-15),
    };
    let of = |method: Method| {
        let parameters = method.parameters(END.0, SettingGrid::Full);
        let points = parameters.into_iter().map(|parameter| point(method, parameter)).collect();
        MethodReport { method, reference: Some(reference), points }
    };
    AccuracyReport {
        scene: Arc::clone(scene),
        references: References { engine: Some(reference), other: Some(reference) },
        methods: Method::ALL.into_iter().take(methods).map(of).collect(),
        printed_off: Some(0.28),
        run_s: Some(74e-6),
        savings: vec![OmissionGain { part: "error estimate", with_s: 74e-6, without_s: 37e-6 }],
    }
}

pub(super) fn answer(bench: &mut Bench, methods: usize) {
    for study in bench.studies() {
        let found = StudyResult::from(measured(&study.scene, methods));
        if methods == Method::ALL.len() {
            bench.reply(study.id, ended(found));
        } else {
            bench.part(study.id, (30, 79), found);
        }
    }
}

/// The tab with everything measured.
pub(super) fn open(glyphs: GlyphSet, size: (u16, u16)) -> Bench {
    let mut bench = Bench::open(glyphs, size);
    bench.keys("5");
    answer(&mut bench, Method::ALL.len());
    bench
}

#[test]
fn opening_the_tab_measures_once_a_scene() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    assert_eq!(bench.app.tab, Tab::Numerics);
    bench.keys("15");
    assert!(bench.studies().is_empty());
    // Another scene is measured again; what belongs to the old one says so meanwhile.
    bench.keys("1jjl5");
    assert_eq!(bench.studies().len(), 1);
    assert!(bench.screen().contains("of another scene"));
    // And by r at any time.
    bench.keys("r");
    assert_eq!(bench.studies()[0].scene, bench.app.scene);
}

#[test]
fn reports_of_replaced_studies_are_dropped() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("5");
    let first = bench.studies().remove(0);
    bench.keys("r");
    let body = ReportBody::Failed("no longer wanted".to_owned());
    bench.reply(first.id, body);
    assert!(bench.app.jobs.running::<MethodBenchmark>().is_some());
    assert!(!bench.message().contains("no longer wanted"));
}

#[test]
fn escape_stops_and_keeps_partial_results() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("5");
    let study = bench.studies().remove(0);
    bench.keys("<Esc>");
    assert!(bench.has_cancelled());
    let found = StudyResult::from(measured(&study.scene, 3));
    bench.reply(study.id, stopped((30, 79), found));
    assert!(bench.message().contains("partial results are shown"), "{}", bench.message());
    assert!(bench.screen().contains("cancelled: press r (30 of 79 points)"));
}

#[test]
fn the_table_has_a_row_a_point() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    bench.keys("e<Enter>");
    let (to, csv, has_scene) = bench.exported().expect("an export");
    assert_eq!(to.path, std::path::Path::new("/home/ada/work/thesis-baseline-accuracy.csv"));
    let report = bench.app.pages.numerics.accuracy.report.result.as_ref().unwrap();
    let points: usize = report.methods.iter().map(|method| method.points.len()).sum();
    assert!(has_scene && csv.lines().nth(1).unwrap().starts_with("thesis-baseline,"));
    assert_eq!(csv.lines().count(), points + 1);
}

#[test]
fn leaving_asks_while_a_study_has_been_going_on_for_long() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("5");
    let study = bench.studies().remove(0);
    bench.send(Message::LongJob(study.id));
    bench.keys("q");
    assert!(bench.message().contains("q again quits"), "{}", bench.message());
}

#[test]
fn the_answer_comes_first_and_the_printed_scheme_stands_apart() {
    for size in [(60, 16), (80, 24), (120, 40)] {
        let screen = open(GlyphSet::Ascii, size).screen();
        let line = screen.lines().find(|line| line.contains("error 1e-6: ")).expect("an answer");
        assert!(line.contains("by auto at tol"), "{line}");
        assert!(screen.contains("printed scheme: 28 % off at any step"), "{screen}");
    }
}

/// The answer is that of auto, which is measured first; the other methods are for comparison.
#[test]
fn the_answer_is_shown_as_soon_as_auto_is_measured() {
    let auto = Method::ALL.iter().position(|it| *it == Method::Auto).unwrap();
    for (methods, words) in
        [(auto, "error 1e-6: not computed yet (30 of 79)"), (auto + 1, "by auto at tol")]
    {
        let mut bench = Bench::ascii(120, 40);
        bench.keys("5");
        answer(&mut bench, methods);
        assert!(bench.screen().contains(words), "{words}: {}", bench.screen());
    }
}

/// The footer offers to use what can be used; the tolerance is that of the answer above, and not looser than the error that is asked for.
#[test]
fn only_what_can_be_used_is_offered() {
    let mut bench = open(GlyphSet::Ascii, (120, 40));
    let is_offered =
        |bench: &mut Bench| bench.screen().lines().last().unwrap().contains("Enter use");
    let auto = Method::ALL.iter().position(|it| *it == Method::Auto).unwrap();
    assert_eq!(bench.app.pages.numerics.accuracy.selected_row(), auto);
    assert!(is_offered(&mut bench), "{}", bench.screen());
    let tolerance = bench.app.pages.numerics.accuracy.tolerance().unwrap();
    assert!(tolerance <= 1e-6, "{tolerance}");
    let answer = format!("by auto at tol {tolerance:.0e}");
    assert!(bench.screen().contains(&answer), "{}", bench.screen());
    assert!(bench.screen().contains(&format!("tol {tolerance:.0e}: error")), "{}", bench.screen());
    for row in (0..Method::ALL.len()).filter(|row| *row != auto) {
        bench.app.pages.numerics.accuracy.selected = Some(row);
        assert!(!is_offered(&mut bench), "{}", bench.screen());
        let before = bench.app.scene.clone();
        bench.keys("<Enter>");
        assert_eq!(bench.app.scene, before);
        assert!(bench.message().contains("a scene is run by auto"), "{}", bench.message());
    }
    bench.app.pages.numerics.accuracy.selected = Some(auto);
    bench.keys("<Enter>");
    assert_eq!(bench.app.scene.run.tolerance.to_bits(), tolerance.to_bits());
}
