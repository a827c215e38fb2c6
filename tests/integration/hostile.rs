//! Files that are not scenes, devices that never end, places that cannot be written: reported in one short line, with the exit
//! status that stands for it.

use std::fs;

use crate::support::{cmra, says};

/// The error text of a refused scene file.
#[track_caller]
fn refused(content: &[u8]) -> String {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("scene.toml");
    fs::write(&path, content).unwrap();
    let (out, error) = says("run", &[path.to_str().unwrap()], 2);
    assert_eq!(out, "");
    assert!(error.len() < 1000 && error.starts_with("error: "), "{error}");
    error
}

#[test]
fn a_file_that_is_not_a_scene_is_refused_in_a_short_line() {
    let deep = format!("format = 1\na = {}{}\n", "[".repeat(50_000), "]".repeat(50_000));
    let long_key = format!("format = 1\n{} = 1\n", "k".repeat(100_000));
    let huge = format!("format = 1\nnotes = \"{}\"\n", "x".repeat(2 << 20));
    let cases = [
        (b"\xff\xfe\x00binary".to_vec(), "is not UTF-8 text"),
        (deep.into_bytes(), "recursion"),
        (long_key.into_bytes(), "is not a key of a scene"),
        (huge.into_bytes(), "is this the right file"),
        (Vec::new(), "`format` is missing"),
        (b"format = 1\n[plate]\nmass_ratio = 1\nmass_ratio = 2\n".to_vec(), "duplicate key"),
    ];
    for (content, expected) in cases {
        let error = refused(&content);
        assert!(error.contains(expected), "{error} lacks {expected}");
    }
}

#[cfg(unix)]
#[test]
fn an_endless_device_is_refused_as_scene_and_table() {
    assert!(says("run", &["--csv", "/dev/ptmx"], 2).1.contains("is a device or a pipe"));
    // All but the last would wait for ever.
    for path in ["/dev/ptmx", "/proc/kmsg", "/dev/zero"] {
        for arguments in [&[path][..], &["--set", &format!("table={path}")]] {
            let (_, error) = says("run", arguments, 2);
            assert!(error.contains(&format!("`{path}` is a device or a pipe")), "{error}");
        }
    }
    let hex = "format = 1\n[plate]\nmass_ratio = 0xFFFFFFFFFFFFFFFFFF\n";
    let scene: Vec<u8> = hex.into();
    let read = cmra("run", &["/dev/stdin", "--json"]).write_stdin(scene).output().unwrap();
    // 2^72, read as a number though no integer holds it.
    let error = String::from_utf8(read.stderr).unwrap();
    assert!(error.contains("4.722366482869645e21") && error.contains("1e15"), "{error}");
    let table = "format = 1\n[mechanism.spring]\nkind = \"table\"\n[mechanism.spring.table]\n\
                 file = \"/dev/zero\"\n";
    assert!(refused(table.as_bytes()).contains("`/dev/zero` is a device or a pipe"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_failure_that_names_the_place() {
    for subcommand in ["run", "limit"] {
        let (out, error) = says(subcommand, &["--csv", "/dev/full"], 1);
        // What took a while to compute is shown all the same.
        assert_eq!(out.contains("limit"), subcommand == "limit", "{out}");
        assert!(error.contains("cannot write `/dev/full`: no space left"), "{error}");
    }
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_cmra"));
    let output = command.args(["presets"]).stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("standard output"));
}

#[test]
fn a_sweep_of_few_slow_points_is_estimated_too_and_does_all_of_them() {
    let csv = cmra("sweep", &["--over", "gamma=1..2:9", "--csv", "-"]).output().unwrap();
    assert_eq!(String::from_utf8(csv.stdout).unwrap().lines().count(), 10);
}

/// A command line with what a terminal would obey must not reach one.
#[cfg(unix)]
#[test]
fn names_and_arguments_cannot_command_the_terminal() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str, content: &str| {
        let path = place.path().join(name);
        fs::write(&path, content).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let sound = at("a\nb\u{1b}[2J.toml", "format = 1\n");
    let broken = at("c\u{1b}]0;x\u{7}.toml", "format = 2\n");
    let cases: [(&[&str], i32); 7] = [
        (&[&sound], 0),
        (&[&broken], 2),
        (&["\u{1b}[31mname"], 2),
        (&["--set", "k\u{1b}[31m=3"], 2),
        (&["--set", "k=3\u{9b}31m"], 2),
        (&["--\u{1b}[31moption"], 2),
        (&["--csv", "/nowhere/\u{1b}[31m.csv"], 1),
    ];
    for (arguments, code) in cases {
        let (out, error) = says("run", arguments, code);
        let said = out + &error;
        let commands = |c: char| c.is_control() && c != '\n';
        assert!(!said.is_empty() && !said.contains(commands), "{arguments:?}: {said:?}");
    }
    // One line for one error, whatever is in the name.
    let (_, error) = says("run", &[&format!("{sound}x")], 2);
    assert_eq!(error.trim_end().lines().count(), 1, "{error:?}");
}

#[test]
fn a_file_of_another_kind_reports_a_few_lines_only() {
    let unknown: Vec<String> = (0..60_000).map(|number| format!("k{number} = 1\n")).collect();
    let unknown = unknown.concat();
    let axis = "{ name = \"gamma\", from = 1, to = 2, count = 3 },";
    let axes = format!("[sweep]\naxes = [{}]\n", axis.repeat(10_000));
    for content in [unknown, axes] {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("scene.toml");
        fs::write(&path, format!("format = 1\n{content}")).unwrap();
        let (_, error) = says("run", &[path.to_str().unwrap()], 2);
        assert_eq!(error.lines().count(), 21, "{error}");
        assert!(error.trim_end().ends_with("and more: correct these first"), "{error}");
    }
}

#[cfg(unix)]
#[test]
fn an_impossible_path_names_the_obstacle() {
    use std::os::unix::ffi::OsStrExt as _;
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name).to_str().unwrap().to_owned();
    std::os::unix::fs::symlink(at("loop.toml"), at("loop.toml")).unwrap();
    std::os::unix::fs::symlink(at("gone"), at("dangling.toml")).unwrap();
    fs::write(at("file"), "").unwrap();
    for (name, expected) in [
        (at("loop.toml"), "too many levels of symbolic links"),
        (at("dangling.toml"), "no such file"),
        (at("file/below.toml"), "not a directory"),
        (at("."), "is a directory"),
        (at(&"x".repeat(300)), "file name too long"),
        (String::new(), "the name is empty"),
    ] {
        let (_, error) = says("run", &[&name], 2);
        assert!(error.contains(expected), "{error}");
    }
    // A name that is not UTF-8 works, too.
    let name = place.path().join(std::ffi::OsStr::from_bytes(b"\xff\xfe.toml"));
    fs::write(&name, "format = 1\ntitle = \"found\"\n").unwrap();
    let out = cmra("run", &[]).arg(&name).output().unwrap().stdout;
    assert!(String::from_utf8_lossy(&out).contains("found"));
}

#[test]
fn an_unwritable_table_is_refused_before_the_computation() {
    let place = tempfile::tempdir().unwrap();
    let mine = place.path().join("mine.csv");
    fs::write(&mine, "mine").unwrap();
    let nowhere = place.path().join("nowhere/a.csv");
    // Any of these but the last takes longer than this test may.
    let long: [(&str, &[&str]); 4] = [
        ("optimise", &["--samples", "16777216"]),
        ("montecarlo", &["--samples", "10000000"]),
        ("sweep", &["--over", "gamma=1..2:1000000000"]),
        ("reproduce", &[]),
    ];
    for (subcommand, arguments) in long {
        for (path, code, expected) in
            [(&mine, 2, "already exists"), (&nowhere, 1, "no such file or directory")]
        {
            let arguments = [arguments, &["--csv", path.to_str().unwrap()]].concat();
            let (out, error) = says(subcommand, &arguments, code);
            assert!(out.is_empty() && error.contains(expected), "{subcommand}: {out}{error}");
        }
    }
    assert_eq!(fs::read_to_string(&mine).unwrap(), "mine");
    assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1, "nothing is left behind");
}

#[test]
fn numbers_out_of_range_are_refused_with_the_range() {
    for (subcommand, arguments, expected) in [
        ("sweep", ["--over=gamma=1..2:5", "--threads=100000"], "1..=1024"),
        ("sweep", ["--over=gamma=1..2:5", "--threads=0"], "1..=1024"),
        ("montecarlo", ["--model-spread", "-1"], "outside 0..0.5"),
        ("montecarlo", ["--samples", "-1"], "'-1' for '--samples"),
    ] {
        let (_, error) = says(subcommand, &arguments, 2);
        assert!(error.contains(expected), "{error}");
    }
}

/// A pipe without a writer.
#[cfg(unix)]
pub(crate) fn pipe(path: &std::path::Path) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let made = std::process::Command::new("mkfifo").arg(path).status().unwrap();
    assert!(made.success());
}

#[cfg(unix)]
#[test]
fn a_pipe_among_the_presets_is_not_waited_for() {
    let place = tempfile::tempdir().unwrap();
    pipe(&place.path().join("cmra/presets/stuck.toml"));
    let output = cmra("presets", &[]).env("XDG_DATA_HOME", place.path()).output().unwrap();
    assert!(output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("stuck.toml` is a device or a pipe"));
    // Nor one where the scene of an export would go.
    let csv = place.path().join("out.csv");
    pipe(&place.path().join("out.toml"));
    let (_, error) = says("run", &["--csv", csv.to_str().unwrap()], 2);
    assert!(error.contains("out.toml`, which is there"), "{error}");
}

/// The command line does not wait for a named pipe in a folder; a pipe from the shell has a writer.
#[cfg(unix)]
#[test]
fn a_named_pipe_is_neither_a_scene_nor_a_target() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("pipe");
    pipe(&path);
    let path = path.to_str().unwrap();
    for arguments in [&[path] as &[&str], &["--csv", path], &["--csv", path, "--force"]] {
        let (_, error) = says("run", arguments, 2);
        assert!(error.contains("is a device or a pipe"), "{arguments:?}: {error}");
    }
    let piped =
        cmra("run", &["/dev/stdin"]).write_stdin("format = 1\ntitle = \"piped\"\n").output();
    assert!(String::from_utf8(piped.unwrap().stdout).unwrap().contains("piped"));
}

/// As with `ulimit -f 0`: an error of writing, and nothing is left behind.
#[cfg(unix)]
#[test]
fn a_limit_on_the_size_of_files_is_an_error() {
    let place = tempfile::tempdir().unwrap();
    let told = format!("ulimit -f 0; exec '{}' run --csv a.csv", env!("CARGO_BIN_EXE_cmra"));
    let output = std::process::Command::new("sh")
        .args(["-c", &told])
        .current_dir(place.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    assert!(
        String::from_utf8_lossy(&output.stderr).contains("cannot write `a.csv`: file too large")
    );
    assert_eq!(fs::read_dir(place.path()).unwrap().count(), 0);
    // A sweep keeps the whole rows that there was room for.
    let what = "sweep --over gamma=1..2:20000 --outputs final_penetration_m --csv a.csv";
    let told = format!("ulimit -f 300; exec '{}' {what}", env!("CARGO_BIN_EXE_cmra"));
    let mut sh = std::process::Command::new("sh");
    let output = sh.args(["-c", &told]).current_dir(place.path()).output().unwrap();
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{error}");
    assert!(
        error.contains("file too large; what was computed is kept in `a.csv.partial`"),
        "{error}"
    );
    let rows = fs::read_to_string(place.path().join("a.csv.partial")).unwrap();
    assert!(rows.lines().count() > 1000 && rows.ends_with('\n'));
    assert!(rows.lines().all(|row| row.matches(',').count() == 5), "{rows}");
}

/// Text from a file shows on every way out, and neither breaks a line nor commands a terminal.
#[test]
fn a_title_stays_one_line_wherever_it_is_shown() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("scene.toml");
    let title = r"a\rb\nx = 1\u202ec\u009b31md\u2028e";
    fs::write(&path, format!("format = 1\ntitle = \"{title}\"\n")).unwrap();
    let _path = path.to_str().unwrap();
    let shown = "a\u{fffd}b\u{fffd}x = 1\u{fffd}c\u{fffd}31md\u{fffd}e";
    // By a short path: a line is as long as a page is wide.
    let mut command = cmra("run", &["scene.toml"]);
    let out = command.current_dir(place.path()).output().unwrap().stdout;
    let out = String::from_utf8(out).unwrap();
    assert!(out.contains(shown), "{out:?}");
    let commands = |c: char| c.is_control() && c != '\n' || c == '\u{202e}' || c == '\u{2028}';
    assert!(!out.contains(commands), "{out:?}");
    // An argument is shown on one line, too.
    let (_, error) = says("run", &["--set", "gam\nma=\u{202e}2"], 2);
    assert_eq!(error.lines().count(), 1, "{error:?}");
    let (_, error) = says("run", &["--opt\nion"], 2);
    assert!(error.lines().next().unwrap().contains("--opt\u{fffd}ion"), "{error:?}");
}

/// The command line in a sidecar gives the table again, whatever the file is called.
#[cfg(unix)]
#[test]
fn the_command_in_a_sidecar_is_quoted() {
    let place = tempfile::tempdir().unwrap();
    let csv = place.path().join("it's a; table.csv");
    // Only what does not name the scene, which is that of the sidecar the second time.
    let outputs = "first_arrest_penetration_m";
    let over = ["--over", "gamma=1..2:3", "--outputs", outputs, "--csv", csv.to_str().unwrap()];
    says("sweep", &over, 0);
    let scene = fs::read_to_string(csv.with_extension("toml")).unwrap();
    let again = scene.lines().find_map(|line| line.strip_prefix("# again: cmra ")).unwrap();
    let told = format!("exec '{}' {again}", env!("CARGO_BIN_EXE_cmra"));
    let output = std::process::Command::new("sh")
        .args(["-c", &told])
        .current_dir(place.path())
        .output()
        .unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr).matches("error").count(), 0, "{output:?}");
    assert_eq!(output.stdout, fs::read(csv).unwrap());
}

/// A fused interface without any grip, and the scheme of Appendix A beyond its stability.
#[test]
fn numbers_that_do_not_exist_are_not_shown() {
    let cases: [&[&str]; 2] = [
        &["--set", "g=0", "--set", "k=1e6", "--set", "horizon=0.02"],
        &["--set", "model=appendix", "--set", "b=1e6"],
    ];
    for scene in cases {
        for form in [&[] as &[&str], &["--json"], &["--csv", "-"]] {
            let arguments = [scene, form].concat();
            let output = cmra("run", &arguments).output().unwrap();
            let out = String::from_utf8(output.stdout).unwrap();
            assert!(!out.is_empty());
            let words = out.split(|c: char| !c.is_alphanumeric());
            let bad: Vec<&str> =
                words.filter(|word| matches!(*word, "NaN" | "nan" | "inf")).collect();
            assert!(bad.is_empty(), "{arguments:?}: {out}");
        }
    }
    let (page, _) = says("run", &[cases[0], &["--verbose"]].concat(), 0);
    let words: Vec<&str> = page.split_whitespace().collect();
    assert!(words.join(" ").contains("no grip (g = 0)"), "{page}");
    let page = cmra("run", cases[1]).output().unwrap().stdout;
    assert!(String::from_utf8(page).unwrap().contains("the solution diverged"));
}

#[test]
fn very_many_layers_are_refused() {
    let many = "[[stack.layer]]\nplate.mass_ratio = 1.0\n".repeat(51);
    let error = refused(format!("format = 1\n{many}").as_bytes());
    assert!(error.contains("51 elements") && error.contains("at most 50"), "{error}");
}

/// A sweep that is cut off keeps its rows and leaves nothing else behind; one that was told to outlive its terminal does.
#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_sweep_keeps_its_finished_points() {
    use rustix::process::Signal;

    use crate::pty::{Start, Terminal, wait_while};
    for (signal, ignored) in
        [(Signal::HUP, false), (Signal::INT, false), (Signal::TERM, false), (Signal::HUP, true)]
    {
        let home = tempfile::tempdir().unwrap();
        let words = "sweep --over gamma=1..2:1000000000 --threads 2 --csv a.csv --force";
        fs::write(home.path().join("a.csv"), "complete").unwrap();
        // In a terminal, which sets the signal back to its default: the tests may run with it ignored (nohup).
        let trap = if ignored { "trap '' HUP;" } else { "" };
        let told = format!("{trap} exec \"$CMRA\" {words}");
        let mut terminal = Terminal::start_with(Start {
            shell: Some("/bin/sh"),
            arguments: &["-c", &told],
            home: Some(home),
            ..Start::default()
        });
        let place = terminal.home.take().unwrap();
        // It has begun when its rows go into a file beside the one that is wanted.
        let names = || -> Vec<String> {
            let found = fs::read_dir(place.path()).unwrap();
            found.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
        };
        let written = || {
            let size =
                |name: String| fs::metadata(place.path().join(name)).map_or(0, |it| it.len());
            names().into_iter().map(size).max().unwrap_or(0)
        };
        wait_while("nothing is written", || written() < 10_000);
        terminal.signal(signal);
        if ignored {
            let before = written();
            wait_while("it was to go on", || written() < before + 100_000);
            terminal.signal(Signal::TERM);
        }
        assert_eq!(terminal.wait_exit().exit_code(), 1, "{signal:?}");
        let mut names = names();
        names.sort();
        // An incomplete table does not get the requested name.
        assert_eq!(names, ["a.csv", "a.csv.partial", "a.csv.partial.toml"]);
        assert_eq!(fs::read_to_string(place.path().join("a.csv")).unwrap(), "complete");
        let rows = fs::read_to_string(place.path().join("a.csv.partial")).unwrap();
        assert!(rows.lines().count() > 10 && rows.ends_with('\n'));
        let scene = fs::read_to_string(place.path().join("a.csv.partial.toml")).unwrap();
        assert!(scene.contains("# not complete: ") && scene.contains("of 1000000000 points"));
    }
}
