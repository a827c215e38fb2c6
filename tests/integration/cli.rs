//! The command line as a script sees it: exit codes, what goes to which stream, JSON keys, files written and files left alone.

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

use crate::support::in_folder;

/// A directory of its own for each test, with a home inside.
struct Place(TempDir);

/// Result of a command.
struct Outcome {
    code: i32,
    out: String,
    err: String,
}

impl Place {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_cmra"));
        command
            .current_dir(self.0.path())
            .env_clear()
            .env("HOME", self.path("home"))
            .env("XDG_DATA_HOME", self.path("data"))
            .env("XDG_STATE_HOME", self.path("state"))
            .env("XDG_CONFIG_HOME", self.path("config"));
        command
    }

    /// Run `cmra` with arguments split at spaces; `~` stands for a space within one.
    fn cmra(&self, arguments: &str) -> Outcome {
        let split = arguments.split_whitespace().map(|argument| argument.replace('~', " "));
        outcome(self.command().args(split))
    }

    fn json(&self, arguments: &str) -> Value {
        let done = self.cmra(arguments);
        assert_eq!((done.code, done.err.as_str()), (0, ""), "{arguments}");
        serde_json::from_str(&done.out).unwrap()
    }
}

fn outcome(command: &mut Command) -> Outcome {
    let output = command.output().unwrap();
    Outcome {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// The keys every script may rely on.
const CONTRACT_KEYS: [&str; 27] = [
    "scene",
    "model",
    "interface",
    "outcome",
    "first_arrest_penetration_m",
    "first_arrest_time_s",
    "first_arrest_plate_displacement_m",
    "first_arrest_plate_velocity_m_s",
    "final_penetration_m",
    "percent_of_baseline",
    "peak_contact_force_n",
    "max_plate_displacement_m",
    "stroke_m",
    "residual_velocity_m_s",
    "exit_time_s",
    "interface_demand_ratio",
    "energy_residual",
    "error_estimate",
    "method",
    "steps",
    "rejected",
    "rhs_evaluations",
    "run_time_s",
    "omitted",
    "warnings",
    "end",
    "title",
];

/// The columns every script may rely on, in order.
const CONTRACT_COLUMNS: &str = "time_s,mode,penetration_m,projectile_displacement_m,projectile_velocity_m_s,\
     plate_displacement_m,plate_velocity_m_s,contact_force_n,spring_force_n,damper_force_n";

/// A run's JSON without what differs from one computation to the next.
fn digits(mut json: Value) -> Value {
    let map = json.as_object_mut().unwrap();
    for key in ["run_time_s", "scene"] {
        assert!(map.remove(key).is_some(), "{key}");
    }
    json
}

#[test]
fn run_prints_a_summary_of_the_baseline() {
    let place = Place::new();
    let done = place.cmra("run");
    assert_eq!((done.code, done.err.as_str()), (0, ""));
    let mut lines = done.out.lines();
    assert_eq!(lines.next(), Some("thesis-baseline: Baseline of chapter 9"));
    assert!(lines.next().unwrap().starts_with("arrested: "), "{}", done.out);
    // The answer and its numbers, then what the model is not valid for, into a pipe in full.
    let force = done.out.find("\npeak mount force        3.83798 kN\n").unwrap();
    let warnings = done.out.find("\nwarnings\n").unwrap();
    let first = done.out.find("\n  ! outside validity: h/D = 2: with dishing").unwrap();
    assert!(force < warnings && warnings < first, "{}", done.out);
    let full = place.cmra("run --verbose");
    assert!(full.out.contains("! outside validity: h/D = 2: with dishing"), "{}", full.out);
    for label in ["first stop", "peak contact force", "residual", "run time"] {
        assert!(done.out.contains(label), "{label}\n{}", done.out);
    }
    assert!(!done.out.contains('\u{1b}'), "no colour codes in a pipe");
}

/// A line of a warning has its number and direction whole within 80 columns, whatever the scene.
#[test]
fn no_warning_is_cut_before_its_number() {
    let place = Place::new();
    let mut lines = 0;
    for changes in [
        "gamma=0.05 k=7.5e6 d=0.5",
        "h=1mm nose=blunt",
        "v_i=1200 S_y=1.9e9",
        "m_p=1g x_stop=1mm",
        "rho=1200 S_y=1e7",
        "model=half-sine",
        "interface=plastic d=0.5",
        "horizon=10us spring=prbm-cantilever",
        "g=0 d=0.1 gamma=7",
    ] {
        let sets: Vec<String> = changes.split(' ').map(|it| format!(" --set {it}")).collect();
        let out = place.cmra(&format!("run{}", sets.concat())).out;
        for line in out.lines().filter(|line| line.starts_with("  ! ")) {
            assert!(
                line.len() <= 80 && !line.contains(".. (") && !line.ends_with(".."),
                "{changes}: {line}"
            );
            lines += 1;
        }
    }
    assert!(lines > 40, "{lines}");
}

/// Stone's depth is `m_p v_i^2/(pi R^2 rho c_t)`, and the projectile as a rod is `m_p/(rho_p pi R^2)` long.
#[test]
fn valid_formulas_of_a_shot() {
    let done = Place::new().cmra("design --c-t 1e5");
    for line in ["8.593 mm  Stone's depth P (eq. 2.4)", "29.67 mm    length of the rod"] {
        assert!(done.out.contains(line), "{}", done.out);
    }
}

/// A result that cannot be written is no success; one that is thrown away on purpose is.
#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_output_is_a_failure() {
    let status = |arguments: &str, to: &str| {
        let shell = format!("{} {arguments} {to}", env!("CARGO_BIN_EXE_cmra"));
        let done = Command::new("sh").args(["-c", &shell]).output().unwrap();
        (done.status.code(), String::from_utf8_lossy(&done.stderr).contains("standard output"))
    };
    for arguments in ["run", "presets", "--help", "run --csv -"] {
        assert_eq!(status(arguments, ">/dev/full"), (Some(1), true), "{arguments}");
    }
    for to in [">/dev/null", "<>/dev/null >&0 2>&0"] {
        assert_eq!(status("presets", to), (Some(0), false), "{to}");
    }
}

#[test]
fn json_has_every_key_of_the_contract() {
    let place = Place::new();
    for scene in ["thesis-baseline", "thin-plate-perforation", "rigid-mount"] {
        let json = place.json(&format!("run {scene} --json"));
        for key in CONTRACT_KEYS {
            assert!(json.get(key).is_some(), "{scene}: {key}");
        }
        assert_eq!(json["scene"], scene);
        assert_eq!(json["interface"], "fused");
        assert_eq!(json["model"], "hydrodynamic");
        assert!(json["steps"].is_u64() && json["warnings"].is_array());
        assert!(json["run_time_s"].as_f64().unwrap() > 0.0);
    }
}

#[test]
fn set_changes_variables_in_order() {
    let place = Place::new();
    let json = place.json(
        "run --json --set gamma=2 --set plate.mass_ratio=*2 --set k=7.5MN/m --set h=25.4mm --set interface=plastic \
         --set theta=0deg --set d=50~mm",
    );
    let variables = &json["variables"];
    assert_eq!(variables["plate.mass_ratio"], 4.0);
    assert_eq!(variables["mechanism.spring.coefficient"], 7.5e6);
    assert_eq!(variables["target.thickness_m"], 0.0254);
    assert_eq!(variables["plate.cocking_m"], 0.05);
    assert_eq!(json["interface"], "plastic");
}

#[test]
fn errors_of_the_command_line_have_one_line() {
    let place = Place::new();
    for (arguments, fragments) in [
        ("run --set gama=2", &["`gama` is not a variable", "`gamma`"][..]),
        ("run --set gamma", &["NAME=VALUE"]),
        ("run --set gamma=heavy", &["gamma (plate.mass_ratio)", "`heavy` is not a number"]),
        (
            "run --set gamma=-1",
            &["gamma (plate.mass_ratio) = -1", "greater than 0", "did you mean 1?"],
        ),
        (
            "run --set m_2=100g --set gamma=2",
            &["--set m_2=100g and --set gamma=2", "give one of gamma, m_2 and face"],
        ),
        ("run --set m_p=nan", &["m_p (projectile.mass_kg)", "nan"]),
        ("run --set m_p=1e999", &["m_p (projectile.mass_kg)", "not a finite number"]),
        ("run --set h=3kg", &["h (target.thickness_m)", "`kg` is not a unit", "mm"]),
        ("run --set interface=glue", &["interface (interface.law) = `glue`", "fused or plastic"]),
        ("run --set stop=-1", &["x_stop (mechanism.stop.position_m) = -1 m", "reduce d"]),
        ("run basline", &["`basline` is neither a preset nor a file"]),
        ("run thesis-basline", &["did you mean `thesis-baseline`?"]),
        ("run no/such.toml", &["no such file"]),
        ("run .", &["cannot read `.`"]),
        ("montecarlo --vary v_i=normal", &["--vary v_i=normal: `normal` is not a number"]),
        ("sweep --over v_i=10..20m/s:3", &["write `10 m/s..20m/s`\n"]),
        ("presets show cockd", &["did you mean `cocked`"]),
        ("swep cocked --over gamma=1..2:3", &["`swep` is not a subcommand", "`sweep`"]),
        ("run --sett gamma=2", &["unexpected argument '--sett'", "'--set'", "`cmra run --help`"]),
        ("run --csv", &["--csv", "a value is required"]),
        ("montecarlo --seed many", &["--seed", "many", "invalid digit"]),
        ("completions bish", &["'bish'", "bash", "fish"]),
        ("presets shwo cocked", &["'shwo'", "exists: 'show'", "`cmra presets --help`"]),
        ("seek --goal stroke=1mm", &["--over", "not provided", "`cmra seek --help`"]),
        ("sweep --over k=1e4,1e5 --outputs strok", &["output strok", "`stroke_m`"]),
        ("preset", &["did you mean the subcommand `presets`?"]),
        ("thesis-basline", &["did you mean `thesis-baseline`?"]),
        ("run --csv a.toml", &["`a.toml` cannot be the target", "name a CSV file"]),
    ] {
        let done = place.cmra(arguments);
        assert_eq!((done.code, done.out.as_str()), (2, ""), "{arguments}: {}", done.err);
        assert!(done.err.starts_with("error: "), "{arguments}: {}", done.err);
        assert_eq!(done.err.lines().count(), 1, "{arguments}: {}", done.err);
        for fragment in fragments {
            assert!(done.err.contains(fragment), "{arguments}: {}", done.err);
        }
    }
}

/// Messages and help name the command that manuals and completions know, whatever the file of the program is called.
#[test]
fn the_program_under_another_name_says_the_same() {
    let place = Place::new();
    let other = place.path("Armour-2");
    std::os::unix::fs::symlink(env!("CARGO_BIN_EXE_cmra"), &other).unwrap();
    for arguments in
        [&["swep", "cocked", "--over", "k=1,2"][..], &["run", "--nonsense"], &["run", "-h"]]
    {
        let said = |program: &Path| {
            let done = std::process::Command::new(program).args(arguments).output().unwrap();
            String::from_utf8([done.stdout, done.stderr].concat()).unwrap()
        };
        assert_eq!(said(&other), said(Path::new(env!("CARGO_BIN_EXE_cmra"))));
    }
}

#[test]
fn contradictory_options_are_refused() {
    let place = Place::new();
    for arguments in ["run --json --plain", "run --force", "run --nonsense", "cocked --fresh"] {
        let done = place.cmra(arguments);
        assert_eq!((done.code, done.out.as_str()), (2, ""), "{arguments}");
        assert!(done.err.starts_with("error: ") && done.err.lines().count() == 1, "{}", done.err);
        assert!(done.err.contains("--help`"), "{arguments}: {}", done.err);
    }
}

#[test]
fn a_broken_scene_file_is_reported_with_its_lines() {
    let place = Place::new();
    place.write("bad.toml", "format = 1\n[plate]\nmass_ration = 2\ncocking_m = -1\n");
    let done = place.cmra("run bad.toml");
    assert_eq!(done.code, 2);
    assert!(done.err.contains("bad.toml:3:1: `plate.mass_ration`"), "{}", done.err);
    assert!(done.err.contains("bad.toml:4:13: d (plate.cocking_m) = -1 m"), "{}", done.err);
}

#[test]
fn a_scene_comes_from_standard_input() {
    let place = Place::new();
    let done = outcome(
        place
            .command()
            .args(["run", "-", "--json"])
            .write_stdin("format = 1\nplate.mass_ratio = 3\n"),
    );
    assert_eq!(done.code, 0, "{}", done.err);
    let json: Value = serde_json::from_str(&done.out).unwrap();
    assert_eq!(json["variables"]["plate.mass_ratio"], 3.0);
}

/// Rows at equal time steps are those of a run that ends there: the horizon puts a step's end at the time.
#[test]
fn rows_at_equal_time_steps_are_located_and_not_interpolated() {
    let place = Place::new();
    for (scene, horizons) in [
        // Tens of microseconds.
        ("thesis-baseline", &[2, 9, 70][..]),
        ("cocked-plastic", &[3, 8]),
        ("overdamped", &[3, 25]),
    ] {
        let done = place.cmra(&format!("run {scene} --csv even.csv --dt 10us --force"));
        assert_eq!(done.code, 0, "{}", done.err);
        let mut reader = csv::Reader::from_path(place.path("even.csv")).unwrap();
        let rows: Vec<Vec<f64>> = reader
            .records()
            .map(|row| row.unwrap().iter().map(|field| field.parse().unwrap_or(f64::NAN)).collect())
            .collect();
        // The last row is that of the end.
        for (number, row) in rows.iter().enumerate().take(rows.len() - 1) {
            assert!((row[0] - 1e-5 * number as f64).abs() < 1e-12, "{scene} {number}: {}", row[0]);
        }
        for number in horizons {
            let horizon = format!("{number}e-5");
            let done = place
                .cmra(&format!("run {scene} --csv own.csv --force --set run.horizon_s={horizon}"));
            assert!(done.code < 2, "{}", done.err);
            let mut reader = csv::Reader::from_path(place.path("own.csv")).unwrap();
            let last = reader.records().last().unwrap().unwrap();
            let row = &rows[*number];
            for column in [2, 3, 4, 5, 6] {
                let (found, exact) = (row[column], last[column].parse::<f64>().unwrap());
                let scale = exact.abs().max(1e-9);
                assert!(
                    (found - exact).abs() <= 1e-7 * scale,
                    "{scene} {horizon} {column}: {found} {exact}"
                );
            }
        }
    }
    for bad in ["--dt 0", "--dt 5kg", "--dt -1us"] {
        assert_eq!(place.cmra(&format!("run --csv even.csv --force {bad}")).code, 2, "{bad}");
    }
    // A single row besides that of the end.
    let rows = place.cmra("run --csv - --dt 1").out;
    let rows: Vec<&str> = rows.lines().skip(1).collect();
    assert!(rows[0].starts_with("0,") && rows[0].ends_with(','), "{rows:?}");
    assert!(rows[1].ends_with(",projectile first stops; greatest displacement"), "{rows:?}");
    assert_eq!(rows.len(), 2);
}

#[test]
fn equal_time_steps_are_refused_in_their_own_words() {
    let place = Place::new();
    for (set, word) in [
        ("model=half-sine", "model = half-sine"),
        ("model=lumped", "model = lumped"),
        ("h_base=10mm", "a stack"),
    ] {
        let done = place.cmra(&format!("run --csv - --dt 10us --set {set}"));
        assert_eq!(done.code, 2, "{}", done.out);
        let is_own = done.err.contains("--dt: ") && done.err.contains(word);
        assert!(is_own && !done.err.contains("study"), "{}", done.err);
    }
    let help = place.cmra("run --help").out;
    let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(help.contains("for a single plate with model=hydrodynamic"), "{help}");
}

/// The overdamped plate creeps to its neutral position, which it left at time 0; the other scenes are not cocked, and level at theta = 0.
#[test]
fn pages_show_no_rounding_as_a_value() {
    let place = Place::new();
    let page = place.cmra("run --set gamma=5 --set w_0=-30 --set v_i=30 --set b=2000").out;
    assert!(page.contains("max plate displacement  0 m\n"), "{page}");
    assert!(!page.contains(" fm") && !page.contains("(stored energy)"), "{page}");
    let page = place.cmra("run --set spring=bistable").out;
    assert!(!page.contains("cocked spring"), "{page}");
    let page = place.cmra("sensitivity --over theta=0deg..60deg").out;
    assert!(page.contains(" 0 m for +0.1"), "{page}");
    let rows = place.cmra("run --set d=0.1 --set x_stop=0 --set e=0 --csv -").out;
    assert!(rows.contains("held by the stop") && !rows.contains(",-0,"), "{rows}");
}

#[test]
fn csv_reads_back_the_same_floats() {
    let place = Place::new();
    let done = place.cmra("run free-plate --csv out.csv");
    assert_eq!(done.code, 0, "{}", done.err);
    assert!(done.err.contains("wrote out.csv\nwrote out.toml"), "{}", done.err);
    let text = place.read("out.csv");
    assert!(text.starts_with(CONTRACT_COLUMNS), "{}", text.lines().next().unwrap());
    assert!(text.contains("projectile first stops"), "events stand in the rows");

    // The same run inside this process, for floats to compare with.
    let preset = cmra::files::preset::resolve("free-plate", None).unwrap();
    let run = cmra_engine::model::simulate::simulate(
        &std::sync::Arc::new(preset.scene),
        &cmra_engine::model::simulate::Settings::default(),
        &mut |_| std::ops::ControlFlow::Continue(()),
    )
    .unwrap();
    let mut reader = csv::Reader::from_path(place.path("out.csv")).unwrap();
    let mut rows = 0;
    for (record, sample) in reader.records().zip(&run.series) {
        let record = record.unwrap();
        let number = |at: usize| record[at].parse::<f64>().unwrap().to_bits();
        assert_eq!(number(0), sample.t_s.to_bits());
        assert_eq!(&record[1], sample.mode.word());
        assert_eq!(number(2), sample.penetration_m.to_bits());
        assert_eq!(number(6), sample.plate_velocity_m_s.to_bits());
        assert_eq!(number(7), sample.contact_force_n.to_bits());
        rows += 1;
    }
    assert_eq!(rows, run.series.len());
    assert!(rows > 20);
}

#[test]
fn the_sidecar_runs_again_to_the_same_digits() {
    let place = Place::new();
    let first = place.json("run cocked --set gamma=1.7 --set h=1/30 --json");
    let done = place.cmra("run cocked --set gamma=1.7 --set h=1/30 --csv out.csv");
    assert_eq!(done.code, 0, "{}", done.err);
    let sidecar = place.read("out.toml");
    let version = env!("CARGO_PKG_VERSION");
    assert!(sidecar.starts_with(&format!("# exported by cmra {version} with out.csv, checksum ")));
    for line in ["# outcome: ", "# run_time_s = "] {
        assert!(sidecar.contains(line), "{sidecar}");
    }
    let again = place.json("run out.toml --json");
    assert_eq!(digits(again), digits(first));
    let before = place.read("out.csv");
    assert_eq!(place.cmra("run out.toml --csv again.csv").code, 0);
    assert_eq!(place.read("again.csv"), before);
}

#[test]
fn nothing_is_overwritten_without_force() {
    let place = Place::new();
    place.write("out.csv", "mine");
    let done = place.cmra("run --csv out.csv");
    assert_eq!((done.code, done.out.as_str()), (2, ""));
    assert!(
        done.err.contains("`out.csv` already exists") && done.err.contains("--force"),
        "{}",
        done.err
    );
    assert_eq!(place.read("out.csv"), "mine");
    assert!(!place.path("out.toml").exists());

    assert_eq!(place.cmra("run --csv out.csv --force").code, 0);
    assert!(place.read("out.csv").starts_with("time_s"));
    assert_eq!(place.cmra("run --csv out.csv --force").code, 0, "an own sidecar may go");

    // A sidecar alone in the way keeps the CSV from being written, too.
    fs::remove_file(place.path("out.csv")).unwrap();
    let done = place.cmra("run --csv out.csv");
    assert_eq!(done.code, 2);
    assert!(done.err.contains("out.toml` already exists"), "{}", done.err);
    assert!(!place.path("out.csv").exists());
}

#[test]
fn a_scene_someone_wrote_is_never_taken_for_a_sidecar() {
    let place = Place::new();
    let mine = "# my plate\nformat = 1\nplate.mass_ratio = 2\n";
    place.write("plate.toml", mine);
    let done = place.cmra("run plate.toml --csv plate.csv --force");
    assert_eq!(done.code, 2);
    assert!(done.err.contains("was not written by an export"), "{}", done.err);
    assert_eq!(place.read("plate.toml"), mine);
    assert!(!place.path("plate.csv").exists());
}

#[test]
fn csv_goes_to_standard_output_alone() {
    let place = Place::new();
    let done = place.cmra("run free-plate --csv -");
    assert_eq!((done.code, done.err.as_str()), (0, ""));
    assert!(done.out.starts_with(CONTRACT_COLUMNS));
    assert!(!done.out.contains("arrested:"));
    assert_eq!(fs::read_dir(place.0.path()).unwrap().count(), 0);
}

#[test]
fn a_file_that_cannot_be_written_is_a_failure_and_leaves_nothing() {
    let place = Place::new();
    let done = place.cmra("run --csv no/such/out.csv");
    assert_eq!((done.code, done.out.as_str()), (1, ""));
    assert!(done.err.contains("cannot write `no/such/out.csv`"), "{}", done.err);
    assert_eq!(fs::read_dir(place.0.path()).unwrap().count(), 0);
}

#[test]
fn presets_are_listed_and_shown() {
    let place = Place::new();
    let list = place.cmra("presets");
    assert_eq!((list.code, list.err.as_str()), (0, ""));
    for (name, text) in cmra::files::bundled::BUNDLED {
        let row = list.out.lines().find(|line| line.split_whitespace().next() == Some(name));
        assert!(row.is_some(), "{name}");
        let shown = place.cmra(&format!("presets show {name}"));
        assert_eq!((shown.code, shown.out.as_str()), (0, *text));
    }
}

#[test]
fn own_presets_are_found_by_name() {
    let place = Place::new();
    place.write(
        "data/cmra/presets/heavy.toml",
        "format = 1\ntitle = \"Heavy\"\nplate.mass_ratio = 6\n",
    );
    place.write("data/cmra/presets/hurt.toml", "format = 1\nplate = 6\n");
    // A file of a bundled name is not what that name means.
    place.write("data/cmra/presets/cocked.toml", "format = 1\nplate.mass_ratio = 6\n");
    let list = place.cmra("presets");
    assert_eq!(list.code, 0);
    assert!(list.out.contains("\nheavy ") && list.out.contains("Heavy"), "{}", list.out);
    assert!(list.err.contains("hurt.toml:2:9"), "{}", list.err);
    assert_eq!(place.json("run heavy --json")["variables"]["plate.mass_ratio"], 6.0);
    // With every value, not only the one that was typed.
    let shown = place.cmra("presets show heavy").out;
    assert!(
        shown.contains("\nmass_ratio = 6") && shown.contains("\nvelocity_m_s = 100.0"),
        "{shown}"
    );
    assert_eq!(place.json("run cocked --json")["variables"]["plate.mass_ratio"], 1.0);
}

#[test]
fn own_presets_are_looked_for_where_the_environment_says() {
    let place = Place::new();
    let done = place.cmra("presets");
    let path = place.path("data/cmra/presets");
    let expected = format!("\nyour own, in {} (none yet)\n", path.display());
    assert_eq!(done.code, 0);
    assert!(done.out.ends_with(&expected), "{}", done.out);
}

#[test]
fn completions_are_printed() {
    let place = Place::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let done = place.cmra(&format!("completions {shell}"));
        assert_eq!(done.code, 0, "{shell}");
        assert!(done.out.contains("presets"), "{shell}");
    }
}

#[test]
fn manual_pages_and_completions_are_installed_where_man_and_shells_look() {
    let place = Place::new();
    for (arguments, share) in [("install", "data"), ("install --prefix opt", "opt/share")] {
        let done = place.cmra(arguments);
        assert_eq!(done.code, 0, "{}", done.err);
        for (path, content) in [
            ("man/man1/cmra.1", ".TH cmra 1"),
            ("man/man1/cmra-run.1", ".TH cmra-run 1"),
            ("bash-completion/completions/cmra", "complete -F _cmra"),
            ("zsh/site-functions/_cmra", "#compdef cmra"),
            ("fish/vendor_completions.d/cmra.fish", "complete -c cmra"),
        ] {
            let written = place.path(&format!("{share}/{path}"));
            let written =
                fs::read_to_string(&written).unwrap_or_else(|error| panic!("{path}: {error}"));
            assert!(written.contains(content), "{share}/{path}");
        }
    }
}

#[test]
fn help_and_version_are_results() {
    let place = Place::new();
    for arguments in ["--help", "run --help", "--version"] {
        let done = place.cmra(arguments);
        assert_eq!((done.code, done.err.as_str()), (0, ""), "{arguments}");
        assert!(done.out.contains("cmra"), "{arguments}");
    }
}

#[test]
fn plain_charts_are_ascii_and_narrow() {
    let place = Place::new();
    let done = place.cmra("run --plain");
    assert_eq!((done.code, done.err.as_str()), (0, ""));
    assert!(done.out.is_ascii());
    for title in ["penetration p, contact", "plate displacement x", "contact force F"] {
        assert!(done.out.contains(title), "{title}");
    }
    let charts = done.out.lines().filter(|line| line.starts_with(['|', '+']));
    assert!(charts.clone().count() > 30);
    assert!(charts.clone().all(|line| line.len() <= 80));
}

#[test]
fn without_a_terminal_the_workbench_prints_the_plain_run() {
    let place = Place::new();
    let computed = |text: &str| text.find("run time").unwrap();
    let plain = place.cmra("run cocked --plain").out;
    for arguments in ["cocked", "cocked --glyphs ascii"] {
        let done = place.cmra(arguments);
        assert_eq!(done.code, 0);
        assert!(done.err.contains("needs a terminal"), "{}", done.err);
        assert_eq!(done.err.lines().count(), 1);
        // All but the time it took.
        assert_eq!(done.out[..computed(&done.out)], plain[..computed(&plain)]);
    }
    let done = place.cmra("");
    assert!(done.out.starts_with("thesis-baseline"), "{}", done.out);
    assert!(!Path::new(&place.path("state")).exists(), "no session is written");
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_is_not_an_error() {
    use std::io::Read as _;
    use std::process::{Command, Stdio};
    let mut child = Command::new(env!("CARGO_BIN_EXE_cmra"))
        .args(["run", "--csv", "-"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let mut said = String::new();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(0));
    assert_eq!(said, "");
}

/// Depth and outcome on a plastic interface are those of two integrators that agree to 11 digits.
#[test]
fn valid_a_fused_interface_that_is_asked_for_too_much_has_the_plastic_answer_beside_it() {
    let place = Place::new();
    let line = |arguments: &str| {
        let page = place.cmra(arguments).out;
        page.lines().find(|line| line.contains("if it can yield")).map(str::to_owned)
    };
    let stiff = line("run --set gamma=0.8 --set k=7.5e6").unwrap();
    assert!(stiff.contains("separated, 4.700 mm deep"), "{stiff}");
    let cocked = line("run --set d=0.5").unwrap();
    assert!(cocked.contains("perforated"), "{cocked}");
    for other in ["run --set k=0", "run --set d=0.5 --set interface=plastic"] {
        assert_eq!(line(other), None, "{other}");
    }
    let json = |arguments: &str| -> Value {
        serde_json::from_str(&place.cmra(&format!("run --json {arguments}")).out).unwrap()
    };
    // The JSON has it wherever the interface is fused.
    for (scene, keys) in [
        ("d=0.5", ["outcome", "residual_velocity_m_s", "max_plate_displacement_m"]),
        ("gamma=5", ["outcome", "final_penetration_m", "max_plate_displacement_m"]),
    ] {
        let beside = json(&format!("--set {scene}"));
        let own = json(&format!("--set {scene} --set interface=plastic"));
        for key in keys {
            assert!(beside["plastic"][key] == own[key] && !own[key].is_null(), "{scene} {key}");
        }
        assert!(own["plastic"].is_null());
    }
}

/// A person reads JSON from its top: the scene, what came out, the rest; rows have the order of the table's columns.
#[test]
fn keys_of_json_are_in_reading_order() {
    use serde_json::{Map, Value};
    let place = Place::new();
    let object = |arguments: &str| -> Map<String, Value> {
        serde_json::from_str(&place.cmra(arguments).out).unwrap()
    };
    for (arguments, keys) in [
        ("run --json", &["scene", "title", "model", "interface", "outcome"][..]),
        ("limit --json", &["scene", "limit_velocity_m_s"]),
        ("sweep --over gamma=1..2:2 --json", &["scene", "points"]),
        ("montecarlo --samples 2 --json", &["scene", "inputs"]),
    ] {
        let found: Vec<String> = object(arguments).keys().take(keys.len()).cloned().collect();
        assert_eq!(found, keys, "{arguments}");
    }
    let over = "sweep --over gamma=1..2:2 --outputs stroke_m,percent_of_baseline";
    let rows = object(&format!("{over} --json"))["rows"].clone();
    let keys: Vec<&String> = rows[0].as_object().unwrap().keys().collect();
    let csv = place.cmra(&format!("{over} --csv -")).out;
    assert_eq!(keys, csv.lines().next().unwrap().split(',').collect::<Vec<_>>());
}

/// Every output of every command refuses every input, whichever is read first.
#[test]
fn no_output_takes_the_place_of_an_input() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    assert_eq!(in_folder(place.path(), "run --csv made.csv").code, 0);
    let scene = fs::read_to_string(at("made.toml")).unwrap();
    let curve = "displacement_m,force_n\n0,0\n0.01,1000\n0.02,3000\n";
    for name in ["plate.toml", "plate.html", "plate.svg", "plate.txt"] {
        fs::write(at(name), &scene).unwrap();
    }
    let traces = "time_ms,displacement_mm\n1,20\n2.714,42\n";
    let measured = "threat,material,h [mm],limit_m_s\nm2-ap-core,aa6082-t651,20,490\n";
    let others =
        [("t.csv", curve), ("t.svg", curve), ("traces.csv", traces), ("measured.csv", measured)];
    for (name, text) in others {
        fs::write(at(name), text).unwrap();
    }
    std::os::unix::fs::symlink(at("plate.toml"), at("link.svg")).unwrap();
    for words in [
        "run plate.toml --svg link.svg",
        "run plate.svg --svg ./plate.svg",
        "run made.toml --set gamma=2 --csv made.csv",
        "run --set table=t.csv --csv t.csv",
        "run --set table=t.svg --svg t.svg",
        "sweep --over gamma=1..2:3 --set table=t.csv --csv t.csv",
        "limit --set table=t.csv --csv t.csv",
        "seek --over gamma=1..2:5 --goal stroke_m=0.1 --set table=t.csv --csv t.csv",
        "compare --set table=t.csv --csv t.csv",
        "stability plate.txt --map k --csv plate.txt",
        "report plate.html -o plate.html",
        "report --set table=t.csv -o t.html",
        "run yang-xi --with traces.csv --csv traces.csv",
        "run yang-xi --with traces.csv --csv ./traces.csv",
        "validate measured.csv --csv measured.csv",
    ] {
        if words.ends_with("t.html") {
            fs::write(at("t.html"), curve).unwrap();
        }
        let words = words.replace("table=t.csv -o", "table=t.html -o");
        let done = in_folder(place.path(), &format!("{words} --force"));
        assert_eq!(done.code, 2, "{words}: {}", done.err);
        assert!(done.err.contains("is an input of this computation"), "{words}: {}", done.err);
        for (name, text) in others {
            assert_eq!(fs::read_to_string(at(name)).unwrap(), text, "{words}");
        }
        for name in ["plate.toml", "plate.html", "plate.svg", "plate.txt", "made.toml"] {
            assert_eq!(fs::read_to_string(at(name)).unwrap(), scene, "{words}");
        }
    }
}

/// A shell hands files over as standard input and output: the first is an input, the second takes what is written, and no more.
#[cfg(unix)]
#[test]
fn files_behind_standard_input_and_output_are_safe() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    let scene = "format = 1\ntitle = \"mine\"\n";
    let told = |words: &str| {
        fs::write(at("mine.svg"), scene).unwrap();
        let words = words.replace("cmra", env!("CARGO_BIN_EXE_cmra"));
        let mut sh = std::process::Command::new("sh");
        let done = sh.args(["-c", &words]).current_dir(place.path()).env("HOME", place.path());
        let done = done.output().unwrap();
        (done.status.code(), String::from_utf8(done.stderr).unwrap())
    };
    for input in ["- ", "/dev/stdin ", "/dev/fd/0 "] {
        let (code, error) = told(&format!("cmra run {input} --svg mine.svg --force < mine.svg"));
        assert_eq!(code, Some(2), "{input}: {error}");
        assert_eq!(fs::read_to_string(at("mine.svg")).unwrap(), scene, "{input}");
    }
    assert_eq!(told("cmra run --csv - > plain.csv").0, Some(0));
    let plain = fs::read_to_string(at("plain.csv")).unwrap();
    for output in ["/dev/stdout", "/dev/fd/1"] {
        let (code, error) = told(&format!("echo mine > out; cmra run --csv {output} >> out"));
        assert_eq!(
            (code, fs::read_to_string(at("out")).unwrap()),
            (Some(0), format!("mine\n{plain}"))
        );
        assert!(!error.contains("wrote"), "{error}");
    }
    for name in ["/dev/stdout.toml", "/dev/fd/1.toml"] {
        assert!(!Path::new(name).exists(), "{name}");
    }
}

/// A scene whose file is named like a formula is text in every table.
#[test]
fn a_name_is_no_formula_in_a_table() {
    let place = tempfile::tempdir().unwrap();
    assert_eq!(in_folder(place.path(), "run --csv made.csv").code, 0);
    fs::rename(place.path().join("made.toml"), place.path().join("=1+1.toml")).unwrap();
    let table = in_folder(place.path(), "sweep =1+1.toml --over gamma=1..2:2 --csv -");
    assert!(table.out.contains("'=1+1.toml") && !table.out.contains(",=1"), "{}", table.out);
}

/// The head of a page says what the scene is: a changed one is not the preset that it began with.
#[test]
fn a_changed_scene_is_headed_by_what_it_is() {
    let place = tempfile::tempdir().unwrap();
    let head = |words: &str| {
        let done = in_folder(place.path(), words);
        assert_eq!(done.code, 0, "{words}: {}", done.err);
        done.out
            .lines()
            .find(|line| line.contains("from ") || line.contains(':'))
            .map(str::to_owned)
    };
    let own = "a scene of your own, from thesis-baseline: 2 changes";
    for command in [
        "run",
        "run --compare models",
        "limit",
        "compare",
        "compare --map gamma=1..2:2,v_i=50..60:2",
        "design",
        "seek --over k=1e4..1e6:5 --goal stroke_m=0.05",
        "sweep --over b=0..10:2",
        "sensitivity",
        "montecarlo --samples 20",
        "optimise --samples 64",
        "accuracy --quick",
        "stability thesis-baseline",
        "stability --map k --quick",
        "report --output -",
    ] {
        let done = in_folder(place.path(), &format!("{command} --set gamma=2 --set v_i=90"));
        let words: Vec<&str> = done.out.split_whitespace().collect();
        assert!(words.join(" ").contains(own), "{command}: {}", done.out);
        assert!(!done.out.contains("Baseline of chapter 9"), "{command}: {}", done.out);
    }
    assert_eq!(head("run").as_deref(), Some("thesis-baseline: Baseline of chapter 9"));
    let twice = in_folder(place.path(), "run --set k=2 --set k=3").out;
    assert!(twice.contains("from thesis-baseline: 1 change\n"), "{twice}");
    let threat =
        in_folder(place.path(), "run --threat fsp-22 --material aa6061-t651 --set gamma=2");
    let made = "threat fsp-22, material aa6061-t651, from thesis-baseline: 1 change";
    assert!(threat.out.contains(made), "{}", threat.out);
    // The exported scene has that title, too.
    assert_eq!(in_folder(place.path(), "run --set gamma=2 --csv a.csv").code, 0);
    let scene = fs::read_to_string(place.path().join("a.toml")).unwrap();
    assert!(scene.contains("a scene of your own, from thesis-baseline: 1 change"), "{scene}");
}

/// A change of a variable that stands in the place of a scene or behind it.
#[test]
fn a_change_without_its_option_is_named() {
    let place = tempfile::tempdir().unwrap();
    for words in ["run gamma=2", "run cocked gamma=2", "gamma=2", "limit thesis-baseline gamma=2"] {
        let done = in_folder(place.path(), words);
        assert_eq!(done.code, 2, "{words}: {}", done.err);
        assert!(done.err.contains("`--set gamma=2`"), "{words}: {}", done.err);
    }
}
