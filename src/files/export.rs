//! Exports: a CSV file, and beside it the scene that gives it again.
//!
//! Both are written or neither is, and nothing is replaced unasked. The sidecar is a scene file like any other; its
//! comments say which program wrote it and what came out.

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use crate::files::atomic::{self, Existing};
use crate::files::clean;
use crate::files::error::FileError;
use crate::files::style::Style;
use crate::files::write;
use crate::model::run::{Run, envelope};
use crate::model::scene::Scene;
use crate::model::units;
use crate::model::variables::{VARIABLES, Variable, is_used};
use crate::report::run::{self, NamedRun, Rows};
use crate::study::quantities::of_runs;

/// How every sidecar begins. A file of the sidecar's name that begins otherwise is someone's own scene.
const MARK: &str = "# exported by cmra";

/// What an export contains and where it goes.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportRequest {
    /// Target file of the CSV; the sidecar TOML goes beside it.
    pub path: PathBuf,
    /// Replace existing files.
    pub overwrite: bool,
    /// Which rows.
    pub rows: Rows,
    /// The runs, each with its name (`now`, `A`, ...); the first one's scene goes into the sidecar of the CSV's own name.
    pub runs: Vec<NamedRun>,
    /// Names of the columns to write, in order; empty: all.
    pub columns: Vec<String>,
    /// How the table is spelt.
    pub style: Style,
    /// Where the scene goes.
    pub meta: Meta,
}

/// Where the scene of an export goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Meta {
    /// Into a scene file beside the table, which runs it again to the same digits.
    #[default]
    Beside,
    /// Into comment lines at the head of the table.
    Inline,
}

impl Meta {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Beside, Self::Inline];

    /// The word of the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Beside => "beside",
            Self::Inline => "inline",
        }
    }

    /// What it is, in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Beside => "beside it, as a .toml to run again",
            Self::Inline => "in # lines at its head",
        }
    }
}

/// Write an export and give the files written, the CSV first.
///
/// # Errors
/// [`FileError`]; no file is new or changed then.
pub fn write(request: &ExportRequest) -> Result<Vec<PathBuf>, FileError> {
    let existing = if request.overwrite { Existing::Replace } else { Existing::Keep };
    let mut files = vec![(request.path.clone(), text(request)?)];
    // A device or a pipe has no place beside it.
    let ordinary = fs::metadata(&request.path).map_or(true, |found| found.is_file());
    if ordinary && request.meta == Meta::Beside {
        for (index, (name, run)) in request.runs.iter().enumerate() {
            let path = sidecar_path(&request.path, (index > 0).then_some(name.as_str()));
            check_sidecar(&request.path, &path)?;
            files.push((path, sidecar(&request.path, run)));
        }
    }
    let contents: Vec<(PathBuf, &[u8])> =
        files.iter().map(|(path, text)| (path.clone(), text.as_bytes())).collect();
    atomic::write_all(&contents, existing)?;
    Ok(files.into_iter().map(|(path, _)| path).collect())
}

/// The table as it goes into the file.
///
/// # Errors
/// [`FileError::Column`] when a wanted column does not exist.
pub fn text(request: &ExportRequest) -> Result<String, FileError> {
    let table = run::csv(request.rows, &request.runs, &request.columns, usize::MAX)?;
    let comments = match request.meta {
        Meta::Beside => String::new(),
        Meta::Inline => request.runs.iter().map(|(name, run)| inline(name, run)).collect(),
    };
    request.style.file(&comments, &table)
}

/// What gave a run and what came out, as comment lines `# key: value (unit)`.
fn inline(name: &str, run: &Run) -> String {
    inline_scene(("run", name), &run.scene, |_| true) + &outcome(run, ":")
}

/// A scene as comment lines `# key: value (unit)`, after what the table is (`run`, `sweep of`) and its name. Only those of its
/// variables that are wanted.
pub fn inline_scene(
    (what, name): (&str, &str),
    scene: &Scene,
    wanted: impl Fn(&Variable) -> bool,
) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let mut text = format!("{MARK} {version}\n# {what}: {}\n", clean::line(name));
    if !scene.title.is_empty() {
        let _ = writeln!(text, "# title: {}", clean::line(&scene.title));
    }
    for variable in VARIABLES.iter().filter(|one| is_used(one, scene) && wanted(one)) {
        let (value, unit) = (variable.show(scene), unit_behind(variable));
        let _ = writeln!(text, "# {}: {value}{unit}", variable.key);
    }
    text
}

/// A variable's unit behind its value: ` (kg)`; nothing for a pure number.
pub fn unit_behind(variable: &Variable) -> String {
    match variable.unit() {
        "-" => String::new(),
        unit => format!(" ({unit})"),
    }
}

/// What came out of a run, as comment lines; the sign stands between a result's name and its value.
fn outcome(run: &Run, sign: &str) -> String {
    let mut text = format!("# outcome: {} ({})\n", run.outcome.word(), run.end.words());
    for column in of_runs() {
        if let Some(value) = column.value(run) {
            let _ = writeln!(text, "# {}{sign} {}", column.name, units::shortest(value));
        }
    }
    let _ = writeln!(text, "# method: {}", run.cost.method);
    for warning in envelope::warnings(run) {
        let _ = writeln!(text, "# warning: {warning}");
    }
    text
}

/// The sidecar of a CSV file: `NAME.csv` has `NAME.toml`, and `NAME-A.toml` for a further run called `A`.
pub fn sidecar_path(csv: &Path, run: Option<&str>) -> PathBuf {
    let is_csv = csv.extension().is_some_and(|end| end.eq_ignore_ascii_case("csv"));
    let stem = if is_csv { csv.file_stem() } else { csv.file_name() };
    let mut name = stem.unwrap_or_else(|| OsStr::new("export")).to_owned();
    if let Some(run) = run {
        name.push("-");
        name.push(run);
    }
    name.push(".toml");
    csv.with_file_name(name)
}

/// Where a table goes that is not complete: `NAME.partial.csv`, with a number where that or its sidecar's name is taken. It
/// takes the place of no other table, whatever may be replaced.
pub fn partial_path(csv: &Path) -> PathBuf {
    let stem = csv.file_stem().unwrap_or_else(|| OsStr::new("export"));
    let named = |number: usize| {
        let mut name = stem.to_owned();
        name.push(".partial");
        if number > 1 {
            name.push(format!("-{number}"));
        }
        if let Some(ending) = csv.extension() {
            name.push(".");
            name.push(ending);
        }
        csv.with_file_name(name)
    };
    let is_taken = |path: &Path| fs::symlink_metadata(path).is_ok();
    (1..10_000)
        .map(named)
        .find(|path| !is_taken(path) && !is_taken(&sidecar_path(path, None)))
        .unwrap_or_else(|| named(1))
}

/// Where a table goes, and what may happen to a file that is there: a table that is not complete has a name of its own.
pub fn place(path: PathBuf, existing: Existing, is_complete: bool) -> (PathBuf, Existing) {
    // A device is refused by its own name.
    if is_complete || atomic::ordinary(&path).is_err() {
        (path, existing)
    } else {
        (partial_path(&path), Existing::Keep)
    }
}

/// A sidecar may replace an older sidecar, never a scene that someone wrote.
///
/// # Errors
/// [`FileError::Target`] when the CSV's name or what lies beside it forbids one.
pub fn check_sidecar(csv: &Path, sidecar: &Path) -> Result<(), FileError> {
    let refuse = |problem: &str| {
        Err(FileError::Target { path: csv.to_owned(), problem: problem.to_owned() })
    };
    if csv.extension().is_some_and(|end| end.eq_ignore_ascii_case("toml")) {
        return refuse("it ends like a scene file; name a CSV file, for example run.csv");
    }
    match fs::metadata(sidecar) {
        Err(_) => return Ok(()),
        Ok(found) if found.is_file() && begins_with_mark(sidecar) => return Ok(()),
        Ok(_) => {}
    }
    Err(FileError::Target {
        path: csv.to_owned(),
        problem: format!(
            "the scene goes beside it into `{}`, which is there and was not written by an export; choose another name",
            sidecar.display()
        ),
    })
}

/// No more of the file is read: it may be anything, of any size.
fn begins_with_mark(path: &Path) -> bool {
    let mut start = [0; MARK.len()];
    fs::File::open(path).and_then(|mut file| file.read_exact(&mut start)).is_ok()
        && start == *MARK.as_bytes()
}

/// The scene of a study as a file; `again` is the command line that makes the same table from it, `notes` are lines `key: text`
/// about the table.
pub fn study_sidecar(csv: &Path, scene: &Scene, again: &str, notes: &[String]) -> String {
    let mut text = first_line(csv);
    for note in notes {
        let _ = writeln!(text, "# {note}");
    }
    let _ = writeln!(text, "# again: {}\n", clean::line(again));
    text + &write::fresh(scene)
}

/// How a sidecar begins.
fn first_line(csv: &Path) -> String {
    let name = csv.file_name().unwrap_or(csv.as_os_str()).to_string_lossy();
    format!("{MARK} {} with {}\n", env!("CARGO_PKG_VERSION"), clean::line(&name))
}

/// The scene of a run as a file, with what came out as comments.
pub fn sidecar(csv: &Path, run: &Run) -> String {
    let mut text = first_line(csv);
    text.push_str(&outcome(run, " ="));
    text.push('\n');
    text + &write::fresh(&run.scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_partial_table_has_a_name_that_is_free() {
        let place = tempfile::tempdir().unwrap();
        let at = |name: &str| place.path().join(name);
        assert_eq!(partial_path(&at("a.csv")), at("a.partial.csv"));
        fs::write(at("a.partial.csv"), "").unwrap();
        fs::write(at("a.partial-2.toml"), "").unwrap();
        assert_eq!(partial_path(&at("a.csv")), at("a.partial-3.csv"));
        assert_eq!(partial_path(&at("table")), at("table.partial"));
    }

    #[test]
    fn the_sidecar_stands_beside() {
        for (csv, run, expected) in [
            ("out/a.csv", None, "out/a.toml"),
            ("out/a.CSV", Some("B"), "out/a-B.toml"),
            ("v1.2", None, "v1.2.toml"),
        ] {
            assert_eq!(sidecar_path(Path::new(csv), run), Path::new(expected));
        }
    }
}
