//! Files that are no scenes, devices that never end, places that cannot be written: told in one short line, with the exit
//! status of the contract.

use std::fs;

use crate::support::{cmra, says};

/// What is said of a scene file that is refused.
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
fn what_is_no_scene_is_refused_in_a_short_line() {
    let deep = format!("format = 1\na = {}{}\n", "[".repeat(50_000), "]".repeat(50_000));
    let long_key = format!("format = 1\n{} = 1\n", "k".repeat(100_000));
    let huge = format!("format = 1\nnotes = \"{}\"\n", "x".repeat(2 << 20));
    let cases = [
        (b"\xff\xfe\x00binary".to_vec(), "is no text"),
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

#[test]
fn a_title_cannot_command_the_terminal() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("scene.toml");
    fs::write(&path, "format = 1\ntitle = \"a\\u001b[31mred\"\n").unwrap();
    let (page, _) = says("run", &[path.to_str().unwrap()], 0);
    assert!(page.contains("[31mred") && !page.contains('\u{1b}'), "{page}");
}

#[cfg(unix)]
#[test]
fn a_device_that_never_ends_is_no_scene_and_no_table() {
    let (_, error) = says("run", &["/dev/zero"], 2);
    assert!(error.contains("more than 1048576 bytes"), "{error}");
    let table = "format = 1\n[mechanism.spring]\nkind = \"table\"\n[mechanism.spring.table]\n\
                 file = \"/dev/zero\"\n";
    assert!(refused(table.as_bytes()).contains("more than 1048576 bytes"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_failure_that_names_the_place() {
    for subcommand in ["run", "limit"] {
        let (out, error) = says(subcommand, &["--csv", "/dev/full"], 1);
        assert_eq!(out, "", "{subcommand}");
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
