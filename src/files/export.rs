//! Exports: a CSV file, and beside it a scene file that reproduces it (sidecar).
//!
//! All commands and the workbench write tables through this module. Either both files are written or none. An existing file is replaced
//! only on request. The comments of the sidecar have the version of the program and the outcome.

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use crate::files::atomic::{self, OverwritePolicy, PartialFile};
use crate::files::clean;
use crate::files::error::FileError;
use crate::files::inputs;
use crate::files::read;
use crate::files::write;
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units;
use cmra_studies::report::run::NamedRun;
use cmra_studies::study::envelope;
use cmra_studies::study::quantities::of_runs;
use cmra_studies::study::sweep::Plan;
use cmra_studies::study::validity;

/// First words of every sidecar. A file with the name of a sidecar but another start is a scene of the user.
const MARK: &str = "# exported by cmra";
/// Text before the checksum at the end of the first line.
const SUM: &str = ", checksum ";

/// Destination of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Destination {
    /// Path of the CSV file.
    pub path: PathBuf,
    /// Policy for an existing file.
    pub existing: OverwritePolicy,
}

/// Scene file beside a table.
pub struct Sidecar<'a> {
    /// Name of the run if the table has several; part of the file name.
    pub run: Option<&'a str>,
    /// Scene.
    pub scene: &'a Scene,
    /// Comment lines above the scene.
    pub notes: String,
    /// Command that reproduces the table from the scene: name and options.
    pub command: String,
}

/// File extensions of formats; a target with that of another format is rejected.
const FORMATS: [&str; 20] = [
    "csv", "docx", "gif", "gz", "html", "jpeg", "jpg", "json", "md", "ods", "parquet", "pdf",
    "png", "svg", "toml", "tsv", "xls", "xlsm", "xlsx", "zip",
];

/// Checks that a file can be written in a format such as `csv`: it is no input, its name is free or may be replaced, and its extension is
/// not that of another format.
pub fn check(path: &Path, format: &str, existing: OverwritePolicy) -> Result<(), FileError> {
    inputs::reserve(path)?;
    check_end(path, format)?;
    atomic::check(path, existing)
}

/// Rejects a name with the extension of another format.
fn check_end(path: &Path, format: &str) -> Result<(), FileError> {
    let Some(end) = path.extension().and_then(OsStr::to_str).map(str::to_lowercase) else {
        return Ok(());
    };
    // `.toml` is the extension of the sidecar.
    let is_scene = format == "csv" && end == "toml";
    if end == format || !(is_scene || FORMATS.contains(&&*end)) {
        return Ok(());
    }
    let example = path.with_extension(format);
    let name = example.file_name().unwrap_or_default().to_string_lossy();
    let a_file = match format {
        "csv" => "a CSV file, which spreadsheets open",
        "svg" => "an SVG file",
        _ => "an HTML file",
    };
    let problem =
        format!("it ends like another format; name {a_file}, for example {}", clean::line(&name));
    Err(FileError::target(path, &problem))
}

impl Destination {
    /// Checks, before a long computation, that the table and its sidecar can be written.
    pub fn check(&self, has_scene: bool) -> Result<(), FileError> {
        let beside = sidecar_path(&self.path, None);
        let has_beside = has_scene && self.has_beside();
        if has_beside {
            inputs::reserve(&beside)?;
            check_sidecar(&self.path, &beside)?;
        }
        check(&self.path, "csv", self.existing)?;
        if has_beside
            && self.existing == OverwritePolicy::Keep
            && fs::symlink_metadata(&beside).is_ok()
        {
            return Err(FileError::Exists(beside));
        }
        Ok(())
    }

    /// Returns `true` if a sidecar can be written; not for a device, a pipe, or a file that a shell hands over.
    fn has_beside(&self) -> bool {
        let is_of_system = ["/dev", "/proc"].iter().any(|folder| self.path.starts_with(folder));
        !is_of_system && fs::metadata(&self.path).map_or(true, |found| found.is_file())
    }

    /// Writes the table and the sidecars; returns the paths written, the table first.
    ///
    /// # Errors
    /// [`FileError`]; no file is created or changed.
    pub fn write(
        &self,
        table: &[u8],
        scenes: &[Sidecar<'_>],
        is_complete: bool,
    ) -> Result<Vec<PathBuf>, FileError> {
        inputs::refuse(&self.path)?;
        check_end(&self.path, "csv")?;
        if !scenes.is_empty() && self.has_beside() {
            check_sidecar(&self.path, &sidecar_path(&self.path, None))?;
        }
        // A partial table has its own name and replaces an earlier partial one.
        let existing = if is_complete { self.existing } else { OverwritePolicy::Replace };
        let mut file = PartialFile::begin(&self.path, existing)?;
        file.add(table)?;
        if is_complete { self.finish(file, scenes) } else { leave(&file, scenes) }
    }

    /// Starts a table that is written in parts, with a sidecar.
    pub fn begin(&self) -> Result<PartialFile, FileError> {
        self.check(true)?;
        PartialFile::begin(&self.path, self.existing)
    }

    /// Returns `true` if a path is that of the table or of its sidecar.
    pub fn has(&self, other: &Path) -> bool {
        let real = |path: &Path| fs::canonicalize(path).or_else(|_| std::path::absolute(path)).ok();
        let is_own = |own: &Path| real(own) == real(other);
        is_own(&self.path) || self.has_beside() && is_own(&sidecar_path(&self.path, None))
    }

    /// Completes a table that was written in parts, as [`Destination::write`]. If its name is taken, the partial file remains.
    ///
    /// # Errors
    /// [`FileError`]; no file is created or changed.
    pub fn finish(
        &self,
        file: PartialFile,
        scenes: &[Sidecar<'_>],
    ) -> Result<Vec<PathBuf>, FileError> {
        let beside = |scene: &Sidecar<'_>| {
            let path = sidecar_path(&self.path, scene.run);
            check_sidecar(&self.path, &path)?;
            Ok((path, scene.file(&self.path)))
        };
        // Another process can have created the file meanwhile.
        let taken = atomic::check(&self.path, self.existing);
        let scenes = scenes.iter().filter(|_| self.has_beside());
        let beside: Result<Vec<_>, _> = taken.and_then(|()| scenes.map(beside).collect());
        let beside = beside.map_err(|problem| kept(&file, problem))?;
        file.finish(&beside, self.existing)?;
        let beside = beside.into_iter().map(|(path, _)| path);
        Ok(std::iter::once(self.path.clone()).chain(beside).collect())
    }
}

/// Keeps an incomplete table under the name of its partial file, with the sidecars; as [`Destination::write`].
pub fn leave(file: &PartialFile, scenes: &[Sidecar<'_>]) -> Result<Vec<PathBuf>, FileError> {
    let Some(path) = file.partial() else { return Ok(Vec::new()) };
    let mut files = vec![path.clone()];
    for scene in scenes {
        let beside = sidecar_path(&path, scene.run);
        check_sidecar(&path, &beside).map_err(|problem| kept(file, problem))?;
        atomic::write(&beside, scene.file(&path).as_bytes(), OverwritePolicy::Replace)?;
        files.push(beside);
    }
    Ok(files)
}

/// Adds the path of the complete rows to the error of a table that could not be completed.
pub fn kept(file: &PartialFile, problem: FileError) -> FileError {
    match file.partial() {
        Some(path) => FileError::Kept { path, problem: Box::new(problem) },
        None => problem,
    }
}

impl Sidecar<'_> {
    /// Returns the text of the sidecar of a table.
    pub fn file(&self, csv: &Path) -> String {
        let own = sidecar_path(csv, self.run);
        let own = format!("./{}", own.file_name().unwrap_or_default().to_string_lossy());
        let name = csv.file_name().unwrap_or(csv.as_os_str()).to_string_lossy();
        let (version, name, notes) = (env!("CARGO_PKG_VERSION"), clean::line(&name), &self.notes);
        let (command, options) = self.command.split_once(' ').unwrap_or((&self.command, ""));
        let words = format!("cmra {command} {} {options}", clean::shell_word(&own));
        let again = match command {
            "" => String::new(),
            _ => format!("# again: {} --csv -\n", clean::line(words.trim_end())),
        };
        let text = format!("{notes}{again}\n{}", write::fresh(self.scene));
        format!("{MARK} {version} with {name}{SUM}{:016x}\n{text}", checksum(&text))
    }
}

/// Returns the 64-bit FNV-1a hash of a text, which detects edited sidecars.
fn checksum(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |sum, byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Returns the sidecars of the runs of a table, with their outcomes; the first one has the name of the CSV file.
pub fn scenes(runs: &[NamedRun]) -> Vec<Sidecar<'_>> {
    let scenes = runs.iter().enumerate().map(|(index, (name, run))| Sidecar {
        run: (index > 0).then_some(name.as_str()),
        scene: &run.scene,
        notes: outcome(run),
        command: String::new(),
    });
    scenes.collect()
}

/// Formats the outcome of a run as comment lines.
fn outcome(run: &Run) -> String {
    let mut text = format!("# outcome: {} ({})\n", run.shot_outcome().word(), run.end.words());
    for column in of_runs() {
        if let Some(value) = column.value(run) {
            let _ = writeln!(text, "# {} = {}", column.name, units::shortest(value));
        }
    }
    let _ = writeln!(text, "# method: {}", run.cost.method);
    if let Some(took_s) = run.cost.took_s {
        let _ =
            writeln!(text, "# run_time_s = {} (with the error estimate)", units::shortest(took_s));
    }
    for warning in envelope::warnings(run) {
        let _ = writeln!(text, "# warning: {warning}");
    }
    text
}

/// Returns the comment lines of the sidecar of a sweep: what is missing, and the warnings.
pub fn sweep_notes(plan: &Plan, missing: Option<&str>) -> String {
    let mut text = missing.map_or_else(String::new, |missing| format!("# {missing}\n"));
    for warning in validity::of_plan(plan) {
        let _ = writeln!(text, "# warning: {}", clean::line(&warning.to_string()));
    }
    text
}

/// Returns the path of the sidecar of a CSV file: `NAME.toml` for `NAME.csv`, and `NAME-A.toml` for a further run named `A`.
pub fn sidecar_path(csv: &Path, run: Option<&str>) -> PathBuf {
    let is_csv = csv.extension().is_some_and(|end| end.eq_ignore_ascii_case("csv"));
    let stem = if is_csv { csv.file_stem() } else { csv.file_name() };
    let name = stem.unwrap_or_else(|| OsStr::new("export")).to_owned();
    let end = run.map_or_else(|| ".toml".to_owned(), |run| format!("-{run}.toml"));
    csv.with_file_name(atomic::fitted(&name, &end))
}

/// Checks that a sidecar replaces nothing but an unedited sidecar.
fn check_sidecar(csv: &Path, sidecar: &Path) -> Result<(), FileError> {
    match fs::metadata(sidecar) {
        // A broken symbolic link is an existing file, too.
        Err(_) if fs::symlink_metadata(sidecar).is_err() => return Ok(()),
        Ok(found) if found.is_file() && is_as_written(sidecar) => return Ok(()),
        _ => {}
    }
    let problem = format!(
        "the scene goes beside it into `{}`, which is there and was not written by an export, or was edited since; choose another name, or move it away",
        sidecar.display()
    );
    Err(FileError::target(csv, &problem))
}

/// Returns `true` for an unedited sidecar.
fn is_as_written(path: &Path) -> bool {
    let text = read::text_file(path, read::BYTES_MAX).unwrap_or_default();
    let (first, rest) = text.split_once('\n').unwrap_or_default();
    let sum = first.rsplit_once(SUM).map(|(_, sum)| sum);
    first.starts_with(MARK) && sum == Some(&format!("{:016x}", checksum(rest)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_that_is_not_complete_replaces_none() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let to = Destination { path: at("a.csv"), existing: OverwritePolicy::Keep };
        fs::write(&to.path, "whole").unwrap();
        for partial in ["a.csv.partial", "a.csv.partial-2"] {
            assert_eq!(to.write(b"1\n", &[], false).unwrap(), [at(partial)]);
        }
        fs::remove_file(&to.path).unwrap();
        let mut file = to.begin().unwrap();
        file.add(b"1\n2\n").unwrap();
        fs::write(&to.path, "whole").unwrap();
        let error = to.finish(file, &[]).unwrap_err().to_string();
        assert!(error.ends_with("a.csv.partial-3`"), "{error}");
        assert_eq!(fs::read(at("a.csv.partial-3")).unwrap(), b"1\n2\n");
        assert_eq!(fs::read(&to.path).unwrap(), b"whole");
    }

    #[test]
    fn a_sidecar_that_someone_edited_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        let to = Destination { path, existing: OverwritePolicy::Replace };
        let scene = Scene::default();
        for is_complete in [true, false] {
            let write = || {
                let (notes, command) = (String::new(), "run".to_owned());
                let beside = Sidecar { run: None, scene: &scene, notes, command };
                to.write(b"1\n", &[beside], is_complete)
            };
            let own = write().unwrap().remove(1);
            let edited = fs::read_to_string(&own).unwrap() + "# mine\n";
            // Nobody has touched this one; the table of a part may have been taken elsewhere.
            let _ = fs::remove_file(folder.path().join("a.csv.partial"));
            write().unwrap();
            fs::write(&own, &edited).unwrap();
            let _ = fs::remove_file(folder.path().join("a.csv.partial"));
            let error = write().unwrap_err().to_string();
            assert!(error.contains("edited since"), "{error}");
            assert_eq!(error.contains("is kept in"), !is_complete, "{error}");
            assert_eq!(fs::read_to_string(&own).unwrap(), edited);
            fs::remove_file(own).unwrap();
        }
    }
}
