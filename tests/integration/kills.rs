//! Programs killed while they write: what is found afterwards is whole, and files that belong together belong together.

use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::Duration;

use cmra::files::atomic::{OverwritePolicy, PartialFile};
use cmra::files::export::{self, Destination};
use cmra::files::paths::Paths;
use cmra::files::preset;
use cmra::files::session::{self, Session, SessionFingerprint};
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_studies::report::run::{NamedRun, csv};

use crate::random::Random;
use crate::support::{run, scene, scene_file};

/// Where the child writes.
const PLACE: &str = "CMRA_TEST_PLACE";

/// How often a program is killed, unless the environment says otherwise.
const KILLS: usize = 20;

/// The two states that every file alternates between.
const STATES: [&str; 2] = ["gamma=1 k=1e5", "gamma=2 k=1e6"];

fn table_of(run: Arc<Run>) -> Vec<NamedRun> {
    vec![("now".to_owned(), run)]
}

fn destination(place: &Path, name: &str) -> Destination {
    Destination { path: place.join(name), existing: OverwritePolicy::Replace }
}

fn session_of(scene: Scene) -> Session {
    Session { scene, ..Session::default() }
}

/// A table as a sweep writes it, and its scene.
fn table(state: usize) -> (Vec<u8>, Vec<u8>) {
    (format!("{state}\n").repeat(50_000).into_bytes(), format!("# {state}\n").into_bytes())
}

#[test]
#[ignore = "run and killed by the test below"]
fn writes_until_it_is_killed() {
    let Some(place) = std::env::var_os(PLACE) else { return };
    let place = Path::new(&place);
    let paths = Paths::below(place);
    let runs = STATES.map(|state| Arc::new(run(scene(state))));
    let mut known = SessionFingerprint::default();
    for state in [0, 1].into_iter().cycle() {
        let scene = scene(STATES[state]);
        let exported = table_of(Arc::clone(&runs[state]));
        let text = csv(&exported);
        destination(place, "run.csv")
            .write(text.as_bytes(), &export::scenes(&exported), true)
            .unwrap();
        preset::save(&paths, "mine", &scene, OverwritePolicy::Replace).unwrap();
        session::save(&paths.session_file(), &session_of(scene), &mut known, &|| true).unwrap();
        let (rows, beside) = table(state);
        let mut growing =
            PartialFile::begin(&place.join("sweep.csv"), OverwritePolicy::Replace).unwrap();
        for piece in rows.chunks(10_000) {
            growing.add(piece).unwrap();
        }
        let beside = [(place.join("sweep.toml"), String::from_utf8(beside).unwrap())];
        growing.finish(&beside, OverwritePolicy::Replace).unwrap();
    }
}

/// Counts of the states found after the kills.
#[derive(Debug, Default, PartialEq)]
struct Found {
    /// Files that are neither of the two states.
    torn: usize,
    /// Files that were there before and are not any more.
    lost: usize,
    /// Pairs of which the files are of different states.
    mixed: usize,
    /// Tables without their scene: killed between the two names.
    alone: usize,
}

/// Returns the state that a file is in; `None` if it does not exist.
fn state_of(path: &Path, states: &[Vec<u8>; 2], found: &mut Found) -> Option<usize> {
    let bytes = fs::read(path).ok()?;
    let state = states.iter().position(|state| *state == bytes);
    found.torn += usize::from(state.is_none());
    state
}

/// Look at a table and the scene beside it.
fn pair(place: &Path, name: &str, states: &[[Vec<u8>; 2]; 2], found: &mut Found) {
    let table = state_of(&place.join(format!("{name}.csv")), &states[0], found);
    let scene = state_of(&place.join(format!("{name}.toml")), &states[1], found);
    match (table, scene) {
        (Some(table), Some(scene)) => found.mixed += usize::from(table != scene),
        (Some(_), None) => found.alone += 1,
        (None, _) => found.lost += 1,
    }
}

#[test]
fn nothing_is_torn_or_lost_when_a_program_is_killed_while_it_writes() {
    let kills = std::env::var("CMRA_KILLS").ok().and_then(|count| count.parse().ok());
    let kills = kills.unwrap_or(KILLS);
    let place = tempfile::tempdir().unwrap();
    let paths = Paths::below(place.path());
    let scenes = STATES.map(scene);
    // A new file has its own name as title.
    let saved = scenes.clone().map(|scene| Scene { title: "mine".to_owned(), ..scene });
    let exported = STATES.map(|state| {
        let exported = table_of(Arc::new(run(scene(state))));
        let beside = export::scenes(&exported)[0].file(&place.path().join("run.csv"));
        (csv(&exported).into_bytes(), beside.into_bytes())
    });
    let [(first, beside_first), (second, beside_second)] = exported;
    let exported = [[first, second], [beside_first, beside_second]];
    let [(first, beside_first), (second, beside_second)] = [0, 1].map(table);
    let swept = [[first, second], [beside_first, beside_second]];
    let (mut found, mut random) = (Found::default(), Random(16));
    for _ in 0..kills {
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["--ignored", "--exact", "kills::writes_until_it_is_killed"])
            .env(PLACE, place.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        // Not before everything is there for the first time.
        while !place.path().join("sweep.toml").exists() && child.try_wait().unwrap().is_none() {
            std::thread::yield_now();
        }
        let wait = Duration::from_micros(random.below(100_000) as u64);
        let (_send, nothing) = std::sync::mpsc::channel::<()>();
        assert!(nothing.recv_timeout(wait).is_err());
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        child.kill().unwrap();
        child.wait().unwrap();
        pair(place.path(), "run", &exported, &mut found);
        pair(place.path(), "sweep", &swept, &mut found);
        match scene_file(&paths.preset_file("mine")) {
            Ok(scene) => found.torn += usize::from(!saved.contains(&scene)),
            Err(_) => found.lost += 1,
        }
        match session::load(&paths.session_file()) {
            session::Loaded { session: Some(session), notice: None, .. } => {
                found.torn += usize::from(!scenes.contains(&session.scene));
            }
            _ => found.lost += 1,
        }
    }
    let _ = writeln!(std::io::stderr(), "{kills} kills: {found:?}");
    assert_eq!(found, Found { alone: found.alone, ..Found::default() });
}
