//! The Limit tab: keys and whole screens. The curve of residual velocities is made up, the comparison and a coarse map are computed.

use cmra::tui::pages::limit::comparison::candidate_lines;
use std::sync::Arc;

use super::at_every_size;
use super::bench::{Bench, Study, ended, stopped};
use crate::support::{says, scene};
use cmra::tui::message::{Effect, Message};
use cmra::tui::theme::GlyphSet;
use cmra::worker::ReportBody;
use cmra::worker::studies::{LimitSearch, MassComparison, RequestVariant, StudyRequest, V50Study};
use cmra_engine::model::run::Outcome;
use cmra_engine::model::scene::Scene;
use cmra_studies::study::compare::map::{Map, default_axes};
use cmra_studies::study::compare::{Hardware, compare};
use cmra_studies::study::context::{Context, never_cancel};
use cmra_studies::study::limit::residual_law::ResidualLaw;
use cmra_studies::study::limit::{Limit, LimitMethod, LimitReport, Shot};
use cmra_studies::study::monte_carlo;
use cmra_studies::study::sweep::Axis;
use insta::assert_snapshot;

/// The made-up limit, m/s.
const V_BL: f64 = 232.3;

/// A plate that takes a little more than its own share beyond the limit.
fn found(scene: &Arc<Scene>) -> LimitReport {
    let below = (0..6).map(|i| 0.5 + f64::from(i) / 12.0);
    let above = (1..=24).map(|i| 1.0 + 1.5 * (f64::from(i) / 24.0).powi(2));
    let law = |v: f64| 0.92 * (v.powf(2.2) - V_BL.powf(2.2)).powf(1.0 / 2.2);
    let shot = |times: f64| Shot {
        impact_m_s: times * V_BL,
        outcome: if times > 1.0 { Outcome::Perforated } else { Outcome::Arrested },
        residual_m_s: (times > 1.0).then(|| law(times * V_BL)),
    };
    LimitReport {
        scene: Arc::clone(scene),
        limit: Limit::found(V_BL, LimitMethod::Outcome),
        at_limit: None,
        residual_at_limit: None,
        interface_holds_m_s: None,
        closures: None,
        jump_m_s: None,
        shots: below.chain(above).map(shot).collect(),
        recht_ipson: Some(ResidualLaw { a: 0.9412, p: 2.0, limit_m_s: V_BL, misfit_m_s: 4.321 }),
        lambert_jonas: Some(ResidualLaw { a: 0.92, p: 2.2, limit_m_s: V_BL, misfit_m_s: 0.0123 }),
    }
}

/// Stop the search of the limit.
pub(super) fn stop(bench: &mut Bench) {
    for study in bench.studies() {
        if let StudyRequest::Limit(_) = study.request {
            bench.reply(study.id, stopped((12, 111), found(&study.scene)));
        }
    }
}

/// A map of few points.
fn mapped(scene: &Arc<Scene>) -> Map {
    let axes = default_axes(scene).unwrap();
    let axes = axes.map(|it| Axis::new(it.symbol(), it.ends(), 13, it.spacing()).unwrap());
    let mut watch = never_cancel;
    Map::compute(scene, &axes, Hardware::default(), &mut Context::new(1, &mut watch)).unwrap()
}

/// The tab of a changed baseline, with what was requested on entering it.
fn entered(changes: &str, size: (u16, u16)) -> (Bench, Vec<Study>) {
    let mut bench = Bench::open(GlyphSet::Ascii, size);
    bench.app.scene = Arc::new(scene(changes));
    bench.keys("3");
    let mut asked = Vec::new();
    loop {
        let studies = bench.studies();
        let answers = studies.iter().filter_map(|it| Some((it.id, answers(it, &|_| {})?)));
        let answers: Vec<_> = answers.collect();
        if answers.is_empty() {
            return (bench, asked);
        }
        for (id, body) in answers {
            bench.reply(id, body);
        }
        asked.extend(studies);
    }
}

/// A plate that nothing stops, a model that cannot perforate, and a spring of unknown mass: no point can have a value.
#[test]
fn a_map_without_a_possible_value_is_not_computed_and_says_why() {
    for (changes, why) in [
        ("k=0", "nothing stops plate and projectile"),
        ("model=half-sine", "no solid plate to compare with"),
        ("spring=column", "the spring's mass is not known"),
    ] {
        let (bench, asked) = entered(changes, (80, 24));
        let is_map = |it: &&Study| matches!(it.request, StudyRequest::EfficiencyMap(_));
        assert_eq!(asked.iter().filter(is_map).count(), 0, "{changes}");
        let screen = bench.screen();
        let why = format!("no point has a mass efficiency: {why}");
        assert!(screen.contains(&why), "{changes}: {screen}");
    }
}

/// Verdicts are shortened by leaving out whole clauses.
#[test]
fn the_verdicts_are_never_cut() {
    for changes in ["", "k=0", "v_i=400", "spring=column", "spring=prbm-cantilever", "n=0.3 d=5mm"]
    {
        for size in [(60, 16), (80, 24), (120, 40)] {
            let screen = entered(changes, size).0.screen();
            for line in screen.lines().skip(1).take(2) {
                assert!(!line.trim_end().ends_with(".."), "{changes} {size:?}: {screen}");
            }
        }
    }
}

/// Answers all studies of the tab, and those that follow them.
pub(super) fn end(bench: &mut Bench, change: impl Fn(&mut LimitReport)) {
    loop {
        let studies = bench.studies();
        let is_of_tab = |study: &&Study| answers(study, &change).is_some();
        if studies.iter().filter(is_of_tab).count() == 0 {
            return;
        }
        for study in studies {
            if let Some(body) = answers(&study, &change) {
                bench.reply(study.id, body);
            }
        }
    }
}

/// The last report of a study of the tab.
fn answers(study: &Study, change: &impl Fn(&mut LimitReport)) -> Option<ReportBody> {
    let watch = &mut never_cancel;
    Some(match &study.request {
        StudyRequest::EqualMass(_) => {
            let context = &mut Context::new(1, watch);
            match compare(&study.scene, Hardware::default(), context) {
                Ok(report) => ended(report),
                Err(why) => ReportBody::Failed(why.to_string()),
            }
        }
        StudyRequest::EfficiencyMap(_) => ended(mapped(&study.scene)),
        StudyRequest::Spread(task) => {
            let few = monte_carlo::Request { samples: Some(20), ..task.0.clone() };
            let watch = &mut never_cancel;
            ended(monte_carlo::run(&study.scene, &few, &mut Context::new(1, watch)).unwrap())
        }
        StudyRequest::Limit(_) => {
            let mut report = found(&study.scene);
            change(&mut report);
            ended(report)
        }
        _ => return None,
    })
}

/// Answer what was requested.
pub(super) fn answer(bench: &mut Bench) {
    end(bench, |_| {});
}

/// The tab with its map and its comparison.
pub(super) fn open(glyphs: GlyphSet, size: (u16, u16)) -> Bench {
    let mut bench = Bench::open(glyphs, size);
    bench.keys("3");
    answer(&mut bench);
    bench
}

/// The tab with its curve of residual velocities.
pub(super) fn open_residual(glyphs: GlyphSet, size: (u16, u16)) -> Bench {
    let mut bench = open(glyphs, size);
    bench.keys("v");
    answer(&mut bench);
    bench
}

/// The time without a key is over; answers what is requested then.
fn rest(bench: &mut Bench) {
    let mut serials = bench.effects.iter().rev().filter_map(|effect| match effect {
        Effect::After(_, Message::Rest(serial)) => Some(*serial),
        _ => None,
    });
    let serial = serials.next().expect("a rest");
    bench.send(Message::Rest(serial));
    answer(bench);
}

#[test]
fn the_limit_tab_at_every_size() {
    for (glyphs, (columns, rows)) in at_every_size(&[(60, 16), (80, 24), (120, 36)]) {
        let mut bench = open(glyphs, (columns, rows));
        bench.keys("=v_i 40 gamma 4<Enter>");
        rest(&mut bench);
        assert_snapshot!(format!("limit_{columns}x{rows}_{glyphs}"), bench.screen());
        bench.keys("<Tab>");
        assert_snapshot!(format!("limit_candidates_{columns}x{rows}_{glyphs}"), bench.screen());
        bench.keys("vr");
        answer(&mut bench);
        assert_snapshot!(format!("limit_v50_{columns}x{rows}_{glyphs}"), bench.screen());
    }
}

/// The first line answers whether the shot is stopped, the second whether moving pays and where: with e J/kg it pays below
/// sqrt(2 (1 + gamma) e) without dishing, 28.06 m/s for a steel coil of 196.8 J/kg and equal masses.
#[test]
fn the_first_lines_are_the_verdict() {
    let mut bench = Bench::ascii(80, 24);
    bench.app.scene = Arc::new(scene("dishing=off k=1"));
    bench.keys("3");
    answer(&mut bench);
    let screen = bench.screen();
    let lines: Vec<&str> = screen.lines().collect();
    assert!(lines[1].contains("100 m/s is stopped by the law, not measured: v_bl "), "{screen}");
    let edge = lines[2].split("it pays below ").nth(1).expect(lines[2]);
    let edge: f64 = edge.split(' ').next().unwrap().parse().unwrap();
    assert!((edge / 28.06 - 1.0).abs() < 0.05 && lines[2].ends_with("at gamma 1"), "{screen}");
    assert!(lines[2].contains("Moving does not pay: mass efficiency 0.1"), "{screen}");
}

/// The numbers below the map are those of the design under the cursor; Enter loads it, Space pins it, Esc goes back to the scene.
#[test]
fn the_cursor_of_the_map_chooses_a_design() {
    let mut bench = open(GlyphSet::Ascii, (120, 36));
    let own = Arc::clone(&bench.app.scene);
    assert!(bench.screen().contains("Candidates: this scene"));
    bench.press("=v_i 20 gamma 4<Enter>");
    let asked = bench.studies();
    assert!(asked.is_empty(), "computed at rest");
    assert!(bench.screen().contains("computed when the cursor rests"), "{}", bench.screen());
    rest(&mut bench);
    let screen = bench.screen();
    assert!(screen.contains("Candidates: v_i 21.147 m/s, gamma 4.6416"), "{screen}");
    assert!(screen.contains(": mass efficiency 1.1"), "{screen}");
    assert_eq!(bench.app.scene, own, "the scene stays as it is");
    // Back at the same place nothing is computed again.
    bench.press("<Esc>");
    assert!(bench.screen().contains("Candidates: this scene"));
    bench.press("=v_i 20 gamma 4<Enter> ");
    assert!(bench.studies().is_empty());
    assert_eq!(bench.app.pins.len(), 1);
    bench.press("<Enter>");
    let loaded = &bench.app.scene;
    assert!((loaded.projectile.velocity_m_s - 21.147).abs() < 0.01, "{}", bench.message());
    assert!((loaded.mass_ratio() - 4.642).abs() < 0.01);
    // The map is that of the loaded design, too.
    rest(&mut bench);
    assert!(bench.app.pages.limit.map.scene != bench.app.scene);
    bench.press("=v_i 5000<Enter>");
    assert!(bench.screen().contains("is not on the axis"), "{}", bench.screen());
}

#[test]
fn no_line_of_the_candidates_is_cut() {
    let mut bench = Bench::ascii(80, 24);
    bench.app.scene = Arc::new(scene("k=0"));
    bench.press("3");
    answer(&mut bench);
    let lines = candidate_lines(&bench.app, 60);
    let text: Vec<&str> = lines.iter().map(|line| line.0.trim()).collect();
    assert!(lines.iter().all(|line| line.0.chars().count() <= 60), "{text:?}");
    assert!(text.join(" ").contains("not an alternative, only the effect of the mass ratio"));
}

/// Slow shots and springs that yield on one map: the legend has room for one reason at this size.
#[test]
fn the_help_of_the_map_names_every_letter_on_it() {
    let mut bench = Bench::ascii(80, 24);
    bench.app.scene = Arc::new(scene("spring=prbm-guided d=4mm"));
    bench.keys("3");
    answer(&mut bench);
    let map = bench.screen();
    bench.keys("?");
    let help = bench.screen();
    for (letter, meaning) in [("EEE", "E even the thinnest plate"), ("FFF", "F the beam yields")] {
        assert!(map.contains(letter), "{letter}: {map}");
        assert!(help.contains(meaning), "{meaning}: {help}");
    }
    assert!(help.contains("cursor"), "{help}");
}

/// The plate of 3 mm is a thin sheet, overloads its fused interface just below its limit, and its spring's end moves too fast.
#[test]
fn the_status_names_what_is_outside_validity_at_the_limit() {
    let mut scene = Scene::default();
    scene.target.thickness_m = 0.003;
    let watch = &mut never_cancel;
    let real = cmra_studies::study::limit::find(&Arc::new(scene), &mut Context::new(1, watch));
    let at_limit = real.unwrap().at_limit;
    let mut bench = Bench::ascii(120, 36);
    bench.keys("3v");
    end(&mut bench, |report| report.at_limit.clone_from(&at_limit));
    let screen = bench.screen();
    assert!(
        screen.contains("! validity at the limit: h/D, spring, spring mass, interface"),
        "{screen}"
    );
}

#[test]
fn missing_results_are_explained() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("3");
    assert_snapshot!("limit_begins", bench.screen());
    bench.keys("v");
    end(&mut bench, |report| {
        report.limit = Limit::Never;
        (report.recht_ipson, report.lambert_jonas) = (None, None);
        for shot in &mut report.shots {
            (shot.outcome, shot.residual_m_s) = (Outcome::Arrested, None);
        }
    });
    assert_snapshot!("limit_never", bench.screen());
    bench.keys("r");
    end(&mut bench, |report| {
        report.limit = Limit::Found {
            velocity_m_s: V_BL,
            basis: LimitMethod::Outcome,
            stopped_at_m_s: Some(400.0),
            undecided_at_m_s: None,
        };
    });
    assert!(bench.screen().contains("no single limit: 400.0 m/s is stopped again"));
}

#[test]
fn the_limit_is_found_once_for_each_scene_and_again_on_request() {
    let mut bench = open_residual(GlyphSet::Ascii, (80, 24));
    let told = "100 m/s is stopped by the law, not measured: v_bl 232.300 m/s, margin +132.3 %";
    assert!(bench.screen().contains(told), "{}", bench.screen());
    bench.keys("13");
    assert!(bench.studies().is_empty());
    // An edit from within the tab makes it old; r finds the new scene's.
    bench.keys("1/interface<Enter>l<Esc>");
    bench.app.focus_on(cmra::tui::pages::limit::RESIDUAL);
    assert!(bench.screen().contains("another scene's results: press r"), "{}", bench.screen());
    bench.keys("r");
    let asked = bench.studies();
    assert_eq!((asked.len(), &asked[0].scene), (2, &bench.app.scene));
    // Leaving and coming back does not ask twice.
    bench.keys("13");
    let again = bench.studies();
    assert!(again.iter().all(|study| LimitSearch::downcast(&study.request).is_none()));
}

#[test]
fn progress_is_shown_and_a_stopped_search_keeps_its_results() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("3v");
    let study = bench.studies().pop().expect("a search");
    bench.progress(study.id, 12, 111);
    assert!(bench.screen().contains("finding the limit: 12 of about 111 shots (Esc cancels)"));
    bench.keys("<Esc>");
    assert!(bench.has_cancelled());
    let mut report = found(&bench.app.scene);
    report.limit = Limit::Unknown;
    report.shots.clear();
    bench.reply(study.id, stopped((12, 111), report));
    let screen = bench.screen();
    assert!(screen.contains("cancelled: press r (12 of 111"), "{screen}");
    bench.keys("e");
    assert!(bench.message().contains("nothing is finished yet"), "{}", bench.message());
}

/// The study is that of `cmra montecarlo --outputs limit_velocity_m_s`, with the known error of the model.
#[test]
fn v50_is_that_of_the_command() {
    let mut bench = open_residual(GlyphSet::Ascii, (120, 36));
    bench.keys("r");
    let asked = bench.studies().pop().expect("V50").request;
    let task = monte_carlo::Request::v50();
    assert_eq!(V50Study::downcast(&asked).map(|it| &**it), Some(&V50Study(task)));
}

/// The limit is that of any shot: another impact velocity starts no second search.
#[test]
fn a_search_under_way_goes_on_at_another_impact_velocity() {
    let mut bench = Bench::ascii(80, 24);
    let asked = |bench: &mut Bench| {
        let studies = bench.studies().into_iter();
        studies.filter(|study| LimitSearch::downcast(&study.request).is_some()).count()
    };
    bench.keys("3v");
    assert_eq!(asked(&mut bench), 1);
    bench.keys("1/v_i<Enter><Enter>150<Enter>3");
    assert_eq!(asked(&mut bench), 0);
}

#[test]
fn shots_are_exported() {
    let mut bench = open_residual(GlyphSet::Ascii, (80, 24));
    bench.keys("e");
    assert_snapshot!("limit_export", bench.screen());
    bench.keys("<Enter>");
    let (to, text, has_scene) = bench.exported().expect("an export");
    assert!(has_scene, "runs it again");
    assert_eq!(to.path, std::path::Path::new("/home/ada/work/thesis-baseline-limit.csv"));
    assert_eq!(text.lines().count(), 31);
    assert!(text.starts_with("scene,impact_velocity_m_s,outcome,"));
}

#[test]
fn a_path_that_ends_in_svg_gets_the_charts_on_the_screen() {
    let mut bench = open(GlyphSet::Ascii, (120, 36));
    bench.keys("e<C-u>limit.svg<Enter>");
    let (_, drawn, has_scene) = bench.exported().expect("an export");
    assert!(drawn.contains("Mass efficiency") && drawn.contains("<polyline"), "{drawn}");
    assert!(!has_scene);
}

#[test]
fn the_curve_has_the_pane_where_curve_and_words_have_no_room() {
    let mut bench = open_residual(GlyphSet::Ascii, (60, 16));
    bench.keys("r");
    answer(&mut bench);
    let curve = bench.screen();
    assert!(curve.contains("Residual velocity") && !curve.contains("Fitted laws"), "{curve}");
    // The line below the pane has V50 all the same.
    assert!(curve.lines().any(|line| line.starts_with(" V50 ")), "{curve}");
    bench.keys("j");
    assert!(bench.screen().contains("Residual velocity"), "{}", bench.screen());
}

#[test]
fn an_oblique_limit_comes_with_the_measured_bias() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/theta<Enter><Enter>30<Enter>3v");
    answer(&mut bench);
    let screen = bench.screen();
    assert!(screen.contains("oblique limits come out below measured ones"), "{screen}");
    bench.keys("1/theta<Enter><Enter>0<Enter>3");
    answer(&mut bench);
    assert!(!bench.screen().contains("oblique limits"));
}

/// With room for all there is nothing to turn; a key for another pane does not leave the tab.
#[test]
fn where_there_is_one_pane_tab_says_how_to_go_on() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("7");
    let before = bench.app.tab;
    bench.keys("<Tab>");
    assert_eq!(bench.app.tab, before);
    assert!(
        bench.message().contains("this tab has one pane; 1, 2 and so on"),
        "{}",
        bench.message()
    );
}

/// Tab 3 and the commands use the same requests and give the same digits.
#[test]
fn the_tab_and_the_commands_give_the_same_digits() {
    for name in ["thesis-baseline", "rigid-mount", "cocked", "oblique", "thin-plate-perforation"] {
        let mut bench = Bench::ascii(80, 24);
        bench.app.scene = Arc::new(cmra::files::preset::resolve(name, None).unwrap().scene);
        bench.keys("3v");
        let read = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
        let json = |command: &str| read(&says(command, &[name, "--json"], 0).0);
        let mut asked = 0;
        for study in bench.studies() {
            let mut watch = never_cancel;
            let context = &mut Context::new(1, &mut watch);
            if let Some(LimitSearch) = LimitSearch::downcast(&study.request).map(|it| &**it) {
                let report = cmra_studies::study::limit::find(&study.scene, context).unwrap();
                let own = read(&cmra_studies::report::limit::json(name, &report).to_string());
                assert_eq!(own["shots"], json("limit")["shots"], "{name}");
                asked += 1;
            } else if MassComparison::downcast(&study.request).is_some() {
                let report = compare(&study.scene, Hardware::default(), context).unwrap();
                let own = read(&cmra_studies::report::compare::json(name, &report).to_string());
                let command = json("compare");
                for key in ["mass_efficiency", "verdict", "candidates"] {
                    assert_eq!(own[key], command[key], "{name}: {key}");
                }
                asked += 1;
            }
        }
        assert_eq!(asked, 2, "{name}");
    }
}

/// The shots of `verdict.rs`, on a rigid mount and on a spring, by the limit that the tab would find.
#[test]
fn the_tab_has_the_answer_of_the_commands() {
    let rigid = [
        "m/s perforates: expected limit",
        "m/s is stopped: expected limit",
        "m/s is open: expected limit",
        "not measured",
        "not measured",
    ];
    for (mount, expected) in [("rigid", rigid), ("sprung", ["not measured"; 5])] {
        for ((name, shot), words) in crate::verdict::SHOTS.iter().zip(expected) {
            let pairs = format!("mount={mount} {shot}");
            let scene = cmra_engine::model::variables::changed(Scene::default(), &pairs).unwrap();
            let watch = &mut never_cancel;
            let context = &mut Context::new(1, watch);
            let found =
                cmra_studies::study::limit::alone(&Arc::new(scene.clone()), context).unwrap();
            let mut bench = Bench::ascii(160, 36);
            bench.app.scene = Arc::new(scene);
            bench.keys("3");
            end(&mut bench, |report| report.limit = found);
            assert!(bench.screen().contains(words), "{name}, {mount}: {}", bench.screen());
        }
    }
}

/// The fragment of `verdict.rs` on a rigid mount: the tab has the answer of the commands.
#[test]
fn the_headline_of_a_measured_shot_is_its_verdict() {
    let pairs = "mount=rigid nose=fragment m_p=53.78g R=9.95mm v_i=500 h=25.7mm rho=2700 E=68.3GPa Y=276MPa UTS=310MPa closure=cylindrical";
    let mut bench = Bench::ascii(120, 36);
    bench.app.scene =
        Arc::new(cmra_engine::model::variables::changed(Scene::default(), pairs).unwrap());
    bench.keys("3v");
    end(&mut bench, |report| {
        report.limit = Limit::found(452.133_810_6, LimitMethod::ClosedForm);
    });
    let screen = bench.screen();
    let told = "500 m/s perforates: expected limit 447.4 (406.1 to 493.0) m/s; law 452.134 m/s";
    assert!(screen.contains(told), "{screen}");
}
