//! Tasks of a new user at 80 x 24, with the keys they take from the start and without `:`: a text that is typed counts as one key.

use super::accuracy;
use std::sync::Arc;

use super::bench::{self, Bench};
use super::{limit, search, sweep};
use cmra::files::library;
use cmra::tui::keymap::Tab;
use cmra::tui::message::{Content, Effect, EffectReport, ExportOutcome, FileTask, Message};
use cmra::tui::pages::explore;
use cmra::tui::pages::search::results::search_is_old;
use cmra::tui::pages::search::state::Page;
use cmra::tui::preset::PresetEntry;
use cmra_engine::model::scene::PlateSize;
use cmra_studies::study::accuracy::method::Method;

/// A new user at 80 x 24, who presses only keys that the screen shows.
struct Newcomer(Bench);

impl Newcomer {
    fn start() -> Self {
        let mut bench = Bench::ascii(80, 24);
        bench.app.first_run = true;
        Self(bench)
    }

    /// Whether tabs, messages, status or footer name a key; on the open dialog its own footer does.
    fn is_shown(&self, key: &str) -> bool {
        let label = match key {
            " " => "Space",
            key => key.trim_matches(['<', '>']),
        };
        let screen = self.0.screen();
        let lines: Vec<&str> = screen.lines().collect();
        let told = lines[..1].iter().chain(&lines[lines.len() - 4..]);
        let ends = |letter: char| !letter.is_alphanumeric() && letter != '=' && letter != '.';
        told.flat_map(|line| line.split(ends)).any(|word| word == label)
    }

    /// Presses keys that are shown and answers what they request.
    fn keys(&mut self, keys: &str) -> &mut Self {
        for key in bench::keys_of(keys) {
            assert!(self.is_shown(&key), "{key} is not shown on\n{}", self.0.screen());
            self.0.keys(&key);
            match self.0.app.tab {
                Tab::Explore => sweep::answer(&mut self.0),
                Tab::Limit => limit::answer(&mut self.0),
                Tab::Numerics => accuracy::answer(&mut self.0, Method::ALL.len()),
                _ => search::answer(&mut self.0),
            }
        }
        self
    }

    /// Types into the open field or dialog.
    fn text(&mut self, text: &str) -> &mut Self {
        assert!(self.0.app.typing.is_some() || self.0.app.has_dialog(), "{}", self.0.screen());
        self.0.press(text);
        self
    }

    fn sees(&self, words: &[&str]) {
        let screen = self.0.screen();
        for word in words {
            assert!(screen.contains(word), "{word} is not on\n{screen}");
        }
    }
}

/// Figure 9.8 with five points along each axis.
fn figure_9_8_of_few_points() -> PresetEntry {
    let found = cmra::files::preset::resolve("figure-9.8", None).unwrap();
    let (name, mut scene) = (found.name, found.scene);
    for axis in &mut scene.sweep.as_mut().unwrap().axes {
        axis.count = 5;
    }
    PresetEntry { name, scene, ..PresetEntry::default() }
}

#[test]
fn a_newcomer_finds_depth_and_changes_the_scene() {
    let mut task = Newcomer::start();
    task.sees(&["Penetration 4.565 mm", "! validity", "Move j/k"]);
    task.keys("<Enter>").text("2").keys("<Enter>");
    assert_eq!(task.0.app.scene.mass_ratio().to_bits(), 2.0_f64.to_bits());
    task.sees(&["since gamma 1"]);
    let mut task = Newcomer::start();
    task.keys("jj<Enter>").text("2MN/m").keys("<Enter>");
    assert!((task.0.app.scene.mechanism.spring.coefficient - 2e6).abs() < 1e-6);
    task.sees(&["2 MN/m"]);
    let mut task = Newcomer::start();
    task.keys("jjjj<Enter>").text("500").keys("<Enter>");
    assert!((task.0.app.scene.mechanism.damper.coefficient - 500.0).abs() < 1e-9);
    let mut task = Newcomer::start();
    task.keys("j<Enter>").text("50").keys("<Enter>");
    assert!((task.0.app.scene.plate.cocking_m - 0.05).abs() < 1e-12);
    task.sees(&["stroke", "interface"]);
}

#[test]
fn a_newcomer_finds_figure_9_8_at_n_0_5() {
    let mut task = Newcomer::start();
    task.0.app.files.presets.push(figure_9_8_of_few_points());
    task.keys("p").text("9.8").keys("<Enter>");
    let at = |task: &Newcomer| task.0.message().contains(" n 0.5:");
    for _ in 0..10 {
        if !at(&task) {
            task.keys("j");
        }
    }
    assert!(at(&task), "{}", task.0.screen());
}

#[test]
fn a_newcomer_exports_saves_and_opens_again() {
    let mut task = Newcomer::start();
    task.keys("le<Enter>");
    assert!(task.0.exported().is_some_and(|(_, text, _)| text.contains("penetration_m")));
    task.0.press("<Esc>");
    task.keys("s").text("mine").keys("<Enter>");
    let scene = Arc::clone(&task.0.app.scene);
    let saved = task.0.effects.iter().find_map(|effect| match effect {
        Effect::Files(FileTask::SaveScene { name, scene, .. }) => {
            Some((name.clone(), scene.clone()))
        }
        _ => None,
    });
    let (name, saved) = saved.expect("a scene to save");
    assert_eq!((name.as_str(), &*saved), ("mine", &*scene));
    let files = ExportOutcome::Written(vec!["/home/ada/mine.toml".into()]);
    task.0.send(Message::Done(EffectReport::Saved(name.clone(), files)));
    let entry = PresetEntry { name, scene: *saved, origin: "mine", ..PresetEntry::default() };
    task.0.send(Message::Done(EffectReport::Presets(vec![entry])));
    task.keys("hp").text("mine").keys("<Enter>");
    assert_eq!(task.0.app.scene, scene);
    task.sees(&["mine"]);
}

#[test]
fn a_newcomer_finds_limit_goal_what_matters_error_and_method() {
    let mut task = Newcomer::start();
    task.keys("3v");
    task.sees(&["v_bl ", "m/s"]);
    let mut task = Newcomer::start();
    task.keys("4<Enter>").text("50").keys("<Enter>");
    task.sees(&["50 % at d = "]);
    let mut task = Newcomer::start();
    task.keys("v");
    task.sees(&["gamma 0.8 to 7: depth ", "Depth, 0 to "]);
    let mut task = Newcomer::start();
    task.keys("5");
    task.sees(&["error 1e-6: ", "by auto at tol"]);
}

/// A bench that counts.
struct Counted {
    bench: Bench,
    presses: usize,
}

impl Counted {
    fn start() -> Self {
        Self { bench: Bench::ascii(80, 24), presses: 0 }
    }

    /// Press one key and answer what it requests.
    fn key(&mut self, key: &str) -> &mut Self {
        self.presses += 1;
        self.bench.press(key);
        self.bench.answer();
        sweep::answer(&mut self.bench);
        self
    }

    /// Type a text, which counts as one.
    fn text(&mut self, text: &str) -> &mut Self {
        self.key(text)
    }
}

#[test]
fn comparing_two_designs_and_exporting_both_takes_11() {
    let mut task = Counted::start();
    task.key("<Enter>").text("2").key("<Enter>").key(" ");
    task.key("j").key("j").key("<Enter>").text("200").key("<Enter>");
    task.key("e").key("<Enter>");
    let request = task.bench.effects.iter().find_map(|effect| match effect {
        Effect::Files(FileTask::Export(_, Content::Runs(request))) => Some(request.clone()),
        _ => None,
    });
    let runs: Vec<String> = request.unwrap().iter().map(|(name, _)| name.clone()).collect();
    assert_eq!(runs, ["now", "A"]);
    let pin = &task.bench.app.pins[0].scene;
    assert_eq!((pin.mass_ratio().to_bits(), task.presses), (2.0_f64.to_bits(), 11));
    let now = task.bench.app.scene.mechanism.spring.coefficient;
    assert_eq!(now.to_bits(), 2e5_f64.to_bits());
}

#[test]
fn the_cocking_distance_for_60_percent_takes_1_and_for_50_percent_3_more() {
    let mut task = Counted::start();
    task.key("4");
    search::answer(&mut task.bench);
    assert!(task.bench.screen().contains("60 % at d = 25.6"), "{}", task.bench.screen());
    assert_eq!(task.presses, 1);
    task.key("<Enter>").text("50").key("<Enter>");
    search::answer(&mut task.bench);
    assert_eq!(task.presses - 1, 3);
    assert!(task.bench.screen().contains("goal 50 %"), "{}", task.bench.screen());
    assert!(!search_is_old(&task.bench.app));
}

#[test]
fn opening_figure_9_8_and_loading_a_design_takes_4_and_the_moves() {
    let mut task = Counted::start();
    task.bench.app.files.presets.push(figure_9_8_of_few_points());
    task.key("p").text("9.8").key("<Enter>");
    assert_eq!((task.bench.app.tab, task.bench.app.pane()), (Tab::Explore, explore::RESULTS));
    let before = task.bench.app.scene.mass_ratio();
    let moves = 2;
    task.key("l").key("l").key("<Enter>");
    assert!(task.bench.app.scene.mass_ratio() > before, "{}", task.bench.message());
    assert_eq!(task.presses - moves, 4);
}

#[test]
fn the_cheapest_method_for_1e_6_is_used_with_2_keys() {
    let mut task = Counted::start();
    task.key("5");
    accuracy::answer(&mut task.bench, Method::ALL.len());
    assert!(task.bench.screen().contains("error 1e-6: "), "{}", task.bench.screen());
    let before = task.bench.app.scene.run.tolerance;
    task.key("<Enter>");
    let after = task.bench.app.scene.run.tolerance;
    assert!(after > before, "{}", task.bench.message());
    assert_eq!(task.presses, 2);
}

#[test]
fn the_ballistic_limit_takes_1_and_v50_2_more() {
    let mut task = Counted::start();
    task.key("3");
    limit::answer(&mut task.bench);
    assert!(task.bench.screen().contains("v_bl 344.328 m/s"), "{}", task.bench.screen());
    assert_eq!(task.presses, 1);
    task.key("v").key("r");
    limit::answer(&mut task.bench);
    assert!(task.bench.screen().contains("V50 "), "{}", task.bench.screen());
    assert_eq!(task.presses, 3);
}

#[test]
fn the_knee_of_the_front_takes_5() {
    let mut task = Counted::start();
    task.key("4").key("4").key("r");
    search::answer(&mut task.bench);
    assert_eq!(task.bench.app.pages.search.page, Page::Front);
    let before = task.bench.app.scene.clone();
    task.key("<Tab>").key("<Enter>");
    assert_ne!(task.bench.app.scene, before, "{}", task.bench.message());
    assert!(task.bench.message().contains("loaded design"), "{}", task.bench.message());
    assert_eq!(task.presses, 5);
}

#[test]
fn the_comparison_over_velocity_takes_1() {
    let mut task = Counted::start();
    task.key("3");
    limit::answer(&mut task.bench);
    let screen = task.bench.screen();
    assert!(screen.contains("mass efficiency 0.15"), "{screen}");
    assert!(screen.contains("rigid mount"), "{screen}");
    assert!(screen.contains("ballistic limit, m/s"), "{screen}");
    assert!(screen.contains("Mass efficiency, up: gamma"), "{screen}");
    assert!(screen.contains("O line of 1"), "{screen}");
    assert_eq!(task.presses, 1);
}

#[test]
fn a_bullet_against_a_steel_plate_of_a_given_face_takes_8() {
    let mut task = Counted::start();
    let parts = library::list(None).0.into_iter().map(PresetEntry::of_part);
    task.bench.app.files.presets.extend(parts);
    task.key("p").text("m80").key("<Enter>").key("p").text("steel-4340").key("<Enter>");
    task.text("150").key("<Enter>");
    assert_eq!(task.bench.app.scene.plate.size, PlateSize::Face(0.15), "{}", task.bench.message());
    assert_eq!(task.presses, 8);
}

#[test]
fn what_grip_means_takes_2() {
    let mut task = Counted::start();
    task.key("/").text("grip");
    let screen = task.bench.screen();
    assert!(screen.contains("a pull of g x hole area x strength; 0.1 is a guess"), "{screen}");
    assert_eq!(task.presses, 2);
}

#[test]
fn undoing_everything_takes_1() {
    let mut task = Counted::start();
    let before = task.bench.app.scene.clone();
    for key in ["l", "j", "l", "l"] {
        task.key(key);
    }
    assert_ne!(task.bench.app.scene, before);
    let presses = task.presses;
    task.key("R");
    assert_eq!((&task.bench.app.scene, task.presses - presses), (&before, 1));
}

#[test]
fn starting_and_cancelling_a_search_takes_3() {
    let mut task = Counted::start();
    task.key("4").key("r");
    task.bench.effects.clear();
    task.key("<Esc>");
    assert!(task.bench.has_cancelled(), "{}", task.bench.screen());
    assert_eq!(task.presses, 3);
}

#[test]
fn saving_takes_2() {
    let mut task = Counted::start();
    task.key("l").key("s").key("<Enter>");
    let is_saved = |effect: &Effect| matches!(effect, Effect::Files(FileTask::SaveScene { .. }));
    assert!(task.bench.effects.iter().any(is_saved), "{:?}", task.bench.effects.len());
    assert_eq!(task.presses - 1, 2);
}
