//! Every reader of text from outside, tested with malformed texts: a corpus, and what becomes of it when bytes
//! are changed at random. A reader accepts what makes sense and comes back the same, or says in a short text why it does not.

use std::cell::Cell;
use std::fs;
use std::io::Write as _;
use std::panic::{self, AssertUnwindSafe};
use std::path::Path;
use std::time::{Duration, Instant};

use cmra::files::read;
use cmra::files::{read_table, session, write};
use cmra_engine::model::scene::{PlateSize, Scene};
use cmra_engine::model::units::{self, Bare, Dimension};
use cmra_engine::model::variables;
use cmra_studies::study::monte_carlo::Tolerance;

use crate::random::Random;
use crate::support::{files_in, in_repository};

/// Mutated inputs of each reader in the usual tests, and in the long one: a million in all.
const DEFAULT: usize = 300;
const LONG: usize = 1_000_000 / 6;

/// Reads a text.
type Read<'a> = Box<dyn Fn(&str) -> Result<(), String> + 'a>;

/// A reader, what it is fed with, and what it makes of it: `Ok` where it else what it says.
struct Reader<'a> {
    name: &'static str,
    seeds: Vec<Vec<u8>>,
    read: Read<'a>,
}

/// Pieces that mean something to one of the readers, and some that should mean nothing to any.
const TOKENS: [&str; 44] = [
    "nan",
    "inf",
    "-inf",
    "1e999",
    "-0.0",
    "1e-400",
    "0",
    "-1",
    "9223372036854775808",
    "0x10",
    "1_0",
    "=",
    "=\n",
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "\"",
    "'''",
    "\\u0000",
    "\\",
    "#",
    ",",
    ";",
    "..",
    ":log",
    "%",
    "MN/m",
    "µs",
    "deg",
    "mm",
    "true",
    "none",
    "table",
    "stack.layer",
    "[sweep]",
    "format = 1\n",
    "\r",
    "\u{202e}",
    "\u{9b}31m",
    "\u{feff}",
    "\u{10ffff}",
];

/// Texts of scenes that once were, or might be, trouble.
const SCENES: [&str; 10] = [
    "",
    "format = 1\n",
    "\u{feff}format = 1\n",
    "format = 1\n[mechanism.spring]\nkind = \"table\"\n[mechanism.spring.table]\npoints = [[0, 0], [1e-3, 1e300], [1e-3, 0]]\n",
    "format = 1\n[[stack.layer]]\nplate.mass_ratio = nan\n[[stack.layer]]\n",
    "format = 1\n[sweep]\naxes = [{ name = \"gamma\", from = 1, to = inf, count = 18446744073709551615 }]\n",
    "format = 1\na.b.c.d.e.f.g = { h = [[[[[[[[[[]]]]]]]]]] }\n",
    "format = 1\ntitle = \"\"\"\\\n   x\\u202ey\"\"\"\nnotes = '''\r\n'''\n",
    "format = 0x1\n[projectile]\nmass_kg = 1979-05-27\n",
    "format = 1\n[run]\nhorizon_s = 1e-400\ntolerance = 5e-324\n",
];

const QUANTITIES: [&str; 14] = [
    "7.5MN/m",
    "25.4mm",
    "29.5 g",
    "150 us",
    "150\u{b5}s",
    "30deg",
    "151.6 MPa",
    "1/3",
    "2*3e5",
    "*2",
    "+5%",
    "-5%",
    "1e308*10",
    "(1+2)/0",
];

const SETTINGS: [&str; 10] = [
    "gamma=2",
    "k=7.5MN/m",
    "theta=30deg",
    "mechanism.stop.position_m=none",
    "interface=plastic",
    "model=lumped",
    "spring=helix",
    "gamma=",
    "=2",
    "g\u{e4}mma=2\n",
];

const TOLERANCES: [&str; 7] = [
    "v_i=normal:2%",
    "h=uniform:24mm..27mm",
    "k=lognormal:10%",
    "v_i=normal:-1%",
    "v_i=uniform:2..1",
    "v_i=:",
    "v_i=normal:nan",
];

const TABLES: [&str; 7] = [
    "x,F\n0,0\n0.01,1000\n0.02,1500\n",
    "0;0\n1;1\n",
    "0,0\n0,0\n",
    "\u{feff}0,0\r\n1,1\r\n",
    "\"0\n\",0\n1,1",
    "# c\n\n\n",
    "0,1e308\n1,-1e308\n2,1e308\n",
];

/// Accepted text is valid, is written, and is read back unchanged.
fn read_scene(text: &str) -> Result<(), String> {
    let found = read::scene(text, "x.toml").map_err(|error| error.to_string())?;
    variables::validate(&found).unwrap();
    assert_eq!(read::scene(&write::fresh(&found), "fresh.toml").unwrap(), found);
    let mut changed = found;
    changed.title.push('\n');
    changed.plate.size = PlateSize::Ratio(1.5);
    if variables::validate(&changed).is_ok() {
        let updated = write::updated(text, "x.toml", &changed).unwrap();
        assert_eq!(read::scene(&updated, "updated.toml").unwrap(), changed, "{updated}");
    }
    Ok(())
}

fn read_quantity(text: &str) -> Result<(), String> {
    const ALL: [Dimension; 6] = [
        Dimension::Number,
        Dimension::Length,
        Dimension::Angle,
        Dimension::Pressure,
        Dimension::Time,
        Dimension::SpringCoefficient,
    ];
    let mut last = Ok(());
    for quantity in ALL {
        for bare in [Bare::Si, Bare::Stored] {
            match units::parse_relative(text, 1.5, quantity, bare) {
                Ok(value) => assert!(value.is_finite(), "{text:?} is {value}"),
                Err(error) => last = Err(error.to_string()),
            }
        }
    }
    last
}

fn read_setting(text: &str) -> Result<(), String> {
    let (name, value) = text.split_once('=').ok_or("no assignment")?;
    let mut scene = Scene::default();
    variables::set_by_name(&mut scene, name, value).map_err(|error| error.to_string())
}

fn read_tolerance(text: &str) -> Result<(), String> {
    let (name, how) = text.split_once('=').ok_or("no assignment")?;
    Tolerance::parse(name, how, &Scene::default()).map(drop).map_err(|error| error.to_string())
}

fn read_points(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).unwrap();
    let points = read_table::curve(path).map_err(|error| error.to_string())?;
    assert!(points.iter().flatten().all(|number| number.is_finite()), "{points:?}");
    Ok(())
}

fn read_session(place: &Path, text: &str) -> Result<(), String> {
    // A folder of its own: every refused session keeps a name, and a free one would take longer to find with each.
    let folder = tempfile::tempdir_in(place).unwrap();
    let path = &folder.path().join("session.toml");
    fs::write(path, text).unwrap();
    let loaded = session::load(path);
    // One that cannot be read is backed up and never lost.
    assert_eq!(path.exists(), loaded.notice.is_none());
    loaded.notice.map_or(Ok(()), Err)
}

fn readers(place: &Path) -> Vec<Reader<'_>> {
    let texts =
        |list: &[&str]| list.iter().map(|text| text.as_bytes().to_vec()).collect::<Vec<_>>();
    let folder = |name: &str| {
        files_in(&in_repository(name), "toml")
            .iter()
            .map(|path| fs::read(path).unwrap())
            .collect::<Vec<_>>()
    };
    let saved = place.join("seed.toml");
    let mut kept = session::Session::default();
    kept.pins.push(("A".to_owned(), Scene::default()));
    session::save(&saved, &kept, &mut session::SessionFingerprint::default(), &|| true).unwrap();
    let curve = place.join("curve.csv");
    vec![
        Reader {
            name: "scene",
            seeds: [texts(&SCENES), folder("presets"), folder("tests/cases/invalid")].concat(),
            read: Box::new(read_scene),
        },
        Reader { name: "quantity", seeds: texts(&QUANTITIES), read: Box::new(read_quantity) },
        Reader { name: "--set", seeds: texts(&SETTINGS), read: Box::new(read_setting) },
        Reader { name: "--vary", seeds: texts(&TOLERANCES), read: Box::new(read_tolerance) },
        Reader {
            name: "spring table",
            seeds: texts(&TABLES),
            read: Box::new(move |text| read_points(&curve, text)),
        },
        Reader {
            name: "session",
            seeds: vec![fs::read(saved).unwrap()],
            read: Box::new(|text| read_session(place, text)),
        },
    ]
}

/// Change a few bytes: another value, one more or less, a piece twice, two pieces exchanged, or something that means something.
fn mutated(random: &mut Random, seed: &[u8]) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + 1 + random.below(12)).min(bytes.len());
        match random.below(7) {
            0 if at < bytes.len() => bytes[at] = u8::try_from(random.below(256)).unwrap(),
            1 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            2 => drop(bytes.drain(at.min(end)..end)),
            3 => {
                let piece = bytes[at.min(end)..end].to_vec();
                let to = random.below(bytes.len() + 1);
                bytes.splice(to..to, piece);
            }
            4 => bytes.truncate(at),
            _ => drop(bytes.splice(at..at, random.of(&TOKENS).bytes())),
        }
    }
    bytes
}

/// Counts of a reader's results.
#[derive(Default)]
struct Tally {
    accepted: usize,
    refused: usize,
    longest: Duration,
    /// The inputs it panicked on.
    failed: Vec<String>,
}

fn feed(reader: &Reader<'_>, tally: &mut Tally, bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let start = Instant::now();
    let ended = panic::catch_unwind(AssertUnwindSafe(|| (reader.read)(&text)));
    tally.longest = tally.longest.max(start.elapsed());
    match ended {
        Ok(Ok(())) => tally.accepted += 1,
        Ok(Err(said)) if !said.is_empty() && said.len() < 20_000 => tally.refused += 1,
        Ok(Err(said)) => tally.failed.push(format!("{text:?} is refused with {said:?}")),
        Err(_panic) => tally.failed.push(format!("{text:?}")),
    }
}

/// The most memory this process has had, MB.
fn most_memory() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let most = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    most.and_then(|most| most.trim().trim_end_matches(" kB").parse::<u64>().ok()).unwrap_or(0)
        / 1024
}

/// Feed every reader with its corpus and with a given number of mutated inputs.
fn feed_all(count: usize) {
    let place = tempfile::tempdir().unwrap();
    let total = Cell::new(0);
    for reader in readers(place.path()) {
        let (mut random, mut tally) = (Random(16), Tally::default());
        for seed in &reader.seeds {
            feed(&reader, &mut tally, seed);
        }
        for _ in 0..count {
            let seed = random.below(reader.seeds.len());
            let bytes = mutated(&mut random, &reader.seeds[seed]);
            feed(&reader, &mut tally, &bytes);
        }
        let Tally { accepted, refused, longest, failed } = tally;
        total.set(total.get() + accepted + refused + failed.len());
        let _ = writeln!(
            std::io::stderr(),
            "{:>13}: {accepted} accepted, {refused} refused, {} failed, longest {longest:?}, at most {} MB",
            reader.name,
            failed.len(),
            most_memory()
        );
        assert!(failed.is_empty(), "{}: {:#?}", reader.name, &failed[..failed.len().min(5)]);
        assert!(accepted > 0 && refused > 0, "{} accepts or refuses everything", reader.name);
    }
    let _ = writeln!(std::io::stderr(), "{} inputs", total.get());
}

#[test]
fn readers_accept_valid_input_and_refuse_the_rest() {
    feed_all(DEFAULT);
}

#[test]
#[ignore = "takes minutes: a million mutated inputs"]
fn a_million_mutated_inputs() {
    feed_all(LONG);
}
