//! Tables that the workbench writes, made again by the command in the scene file beside them.

use cmra::tui::pages::explore::plan::sweep_plan;
use std::fs;
use std::path::Path;
use std::sync::{Arc, mpsc};

use super::bench::Bench;
use super::sweep;
use crate::support::{self, cmra};
use cmra::files::export::sidecar_path;
use cmra::tui::message::{Effect, FileTask};
use cmra::tui::pages::search::state::Page;
use cmra::tui::preset::ReferencePreset;
use cmra::worker::{Task, TaskReport, Worker};
use cmra_engine::model::scene::{PlateSize, Scene};

/// A bench on a scene whose plate has a face, with a folder that it writes to.
fn open(folder: &Path) -> Bench {
    let mut bench = Bench::ascii(120, 36);
    let scene = Scene { title: "with a face".to_owned(), ..support::scene("face=0.1") };
    bench.app.scene = Arc::new(scene);
    bench.app.base = ReferencePreset {
        name: "face".to_owned(),
        is_mine: false,
        scene: Arc::clone(&bench.app.scene),
    };
    bench.app.files.directory = folder.to_owned();
    let setup = Arc::make_mut(&mut bench.app.pages.search.setup);
    (setup.designs, setup.samples, setup.goal.1) = (64, 40, 90.0);
    bench
}

/// Press keys, and let threads compute what was requested.
fn keys(bench: &mut Bench, keys: &str) {
    bench.press(keys);
    bench.answer();
    loop {
        let tasks = bench.tasks(|task| Some(task.clone()));
        if tasks.is_empty() {
            return;
        }
        let (send, reports) = mpsc::channel();
        let worker = Worker::spawn(move |report: TaskReport| drop(send.send(report)));
        for task in tasks {
            let id = task.id;
            // All of it, however slow the machine.
            worker.submit(Task { budget: None, ..task });
            let last = reports.iter().find(|it| it.id == id && it.body.is_last()).unwrap();
            bench.reply(id, last.body);
        }
        bench.answer();
    }
}

/// Write the table on the screen with its scene, and give its text and that of the scene file.
fn exported(bench: &mut Bench, path: &Path) -> (String, String) {
    bench.keys("e<C-u>");
    bench.press(path.file_name().unwrap().to_str().unwrap());
    bench.press("<Enter>");
    let content = bench.effects.drain(..).find_map(|effect| match effect {
        Effect::Files(FileTask::Export(_, content)) => Some(content),
        _ => None,
    });
    let content = content.unwrap_or_else(|| panic!("no export: {}", bench.screen()));
    bench.press("<Esc>");
    (content.text(), content.scenes()[0].file(path))
}

/// The rows without the name of the scene, which is that of the file when they are made again.
fn rows(csv: &str) -> Vec<String> {
    let is_named = csv.starts_with("scene,");
    let rest = |line: &str| line.split_once(',').map(|(_, rest)| rest.to_owned());
    csv.lines()
        .map(|line| rest(line).filter(|_| is_named).unwrap_or_else(|| line.to_owned()))
        .collect()
}

#[test]
fn the_command_beside_an_exported_table_makes_its_rows_again() {
    let folder = tempfile::tempdir().unwrap();
    let mut bench = open(folder.path());
    for (at, (pressed, page, command)) in [
        ("2", None, "sweep"),
        ("3r", None, "compare"),
        ("<Tab>", None, "compare"),
        ("v", None, "limit"),
        ("r", None, "limit"),
        ("4r", Some(Page::Seek), "seek"),
        ("r", Some(Page::Front), "optimise"),
        ("r", Some(Page::Sensitivity), "sensitivity"),
        ("r", Some(Page::MonteCarlo), "montecarlo"),
    ]
    .into_iter()
    .enumerate()
    {
        bench.app.pages.search.page = page.unwrap_or_default();
        keys(&mut bench, pressed);
        let path = folder.path().join(format!("{at}.csv"));
        let (csv, scene) = exported(&mut bench, &path);
        let beside = sidecar_path(&path, None);
        fs::write(&beside, &scene).unwrap();
        let again = scene.lines().find_map(|line| line.strip_prefix("# again: cmra "));
        let again = again.unwrap_or_else(|| panic!("{pressed}: {scene}"));
        assert!(again.starts_with(&format!("{command} ./{at}.toml")), "{again}");
        assert!(scene.contains("title = \"with a face\"\n"), "{scene}");
        assert!(scene.contains("face_m = 0.1 "), "{scene}");
        // A path may have a space: it is put in after the words are told apart.
        let again = again.replace('\'', "");
        let (own, path) = (format!("./{at}.toml"), beside.to_str().unwrap());
        let words: Vec<&str> =
            again.split(' ').map(|word| if word == own { path } else { word }).collect();
        let out = cmra(words[0], &words[1..]).output().unwrap().stdout;
        let out = String::from_utf8(out).unwrap();
        assert_eq!(rows(&csv), rows(&out), "{again}");
    }
}

#[test]
fn explore_varies_the_face_of_a_scene_that_has_one() {
    let folder = tempfile::tempdir().unwrap();
    let mut bench = open(folder.path());
    bench.press("2");
    sweep::answer(&mut bench);
    let plan = sweep_plan(&bench.app).unwrap();
    assert_eq!((plan.axes()[0].symbol(), plan.axes()[0].ends()), ("face", (0.05, 0.2)));
    bench.keys("g<Enter>");
    assert_eq!(bench.app.scene.plate.size, PlateSize::Face(0.05), "{}", bench.screen());
    bench.keys("<Tab>gjj<Enter><C-u>gamma<Enter>");
    let screen = bench.screen();
    assert!(screen.contains("gamma varies, but the scene has face = 0.05 m"), "{screen}");
}
