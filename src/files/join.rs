//! Joins the parts of a sweep into the file that one run would have written.
//!
//! Each part is checked against the sidecar beside it: every row must be the row of its point. Parts of different sweeps, gaps
//! and doubles are refused.

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use csv::ReaderBuilder;

use crate::files::error::{FileError, shown};
use crate::files::export::{self, Beside};
use crate::files::read::{self, Accepts};
use crate::files::shard::Part;
use crate::files::style::Style;
use crate::model::scene::Scene;
use crate::model::units;
use crate::model::variables::VARIABLES;
use crate::study::sweep::{Axis, Plan, Shard};

const PIECE: usize = 1 << 16;

/// The parts of one sweep, in order, none missing.
#[derive(Debug)]
pub struct Whole {
    parts: Vec<PathBuf>,
    joined: Part,
    scene: Scene,
}

/// A part with what its sidecar says.
struct Found {
    path: PathBuf,
    part: Part,
    scene: Scene,
    version: String,
}

impl Whole {
    /// Check the parts.
    ///
    /// # Errors
    /// [`FileError::Refused`] when they are not the parts of one sweep, each once; [`FileError`] when one cannot be read.
    pub fn of(paths: &[PathBuf]) -> Result<Self, FileError> {
        let mut found = paths.iter().map(|path| found(path)).collect::<Result<Vec<_>, _>>()?;
        found.sort_by_key(|one| one.part.shard.place());
        let Some((first, others)) = found.split_first() else {
            return Err(refuse("no part is given to join".to_owned()));
        };
        for other in others {
            if let Some(difference) = difference(first, other) {
                let (first, other) = (shown(&first.path), shown(&other.path));
                let text = format!("`{first}` and `{other}` are parts of different sweeps");
                return Err(refuse(format!("{text}: {difference}")));
            }
        }
        each_once(&found)?;
        let sweep = first.scene.sweep.clone().unwrap_or_default();
        let axes = Axis::all_of(&sweep);
        let plan = axes.and_then(|axes| Plan::new(&first.scene, axes, first.part.design, &[""; 0]));
        let plan = plan.map_err(|error| refuse(format!("`{}`: {error}", shown(&first.path))))?;
        for one in &found {
            check_rows(one, &plan)?;
        }
        let parts = found.iter().map(|one| one.path.clone()).collect();
        let first = found.swap_remove(0);
        let joined = Part { shard: Shard::WHOLE, ..first.part };
        Ok(Self { parts, joined, scene: first.scene })
    }

    /// How many parts there are.
    pub fn count(&self) -> usize {
        self.parts.len()
    }

    /// Give away the bytes of the whole table, piece by piece.
    ///
    /// # Errors
    /// [`FileError::Read`], and what `take` fails with.
    pub fn each_piece<E: From<FileError>>(
        &self,
        mut take: impl FnMut(&[u8]) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut piece = vec![0; PIECE];
        for path in &self.parts {
            let failed = |source| FileError::read(path, source);
            let mut file = File::open(path).map_err(failed)?;
            loop {
                let count = file.read(&mut piece).map_err(failed)?;
                if count == 0 {
                    break;
                }
                take(&piece[..count])?;
            }
        }
        Ok(())
    }

    /// The scene that one run would have written beside this table.
    pub fn beside(&self) -> Beside<'_> {
        self.joined.beside(&self.scene, None)
    }
}

fn refuse(problem: String) -> FileError {
    FileError::Refused(problem)
}

fn found(path: &Path) -> Result<Found, FileError> {
    let beside = export::sidecar_path(path, None);
    std::fs::metadata(path).map_err(|source| FileError::read(path, source))?;
    if !beside.exists() {
        let (path, beside) = (shown(path), shown(&beside));
        return Err(refuse(format!(
            "`{path}` has no `{beside}` beside it, which names its part: make the parts with --shard and without --meta inline"
        )));
    }
    let text = read::text_file(&beside, Accepts::Handed, read::BYTES_MAX)?;
    let part =
        Part::read(&text).map_err(|problem| refuse(format!("`{}`: {problem}", shown(path))))?;
    let scene = read::scene(&text, &shown(&beside)).map_err(FileError::Scene)?;
    let version = text.split_whitespace().nth(4).unwrap_or_default().to_owned();
    Ok(Found { path: path.to_owned(), part, scene, version })
}

/// The difference of two sweeps, in words; `None` for parts of one sweep.
fn difference(one: &Found, other: &Found) -> Option<String> {
    let axes = |found: &Found| match found.scene.sweep.as_ref().map(Axis::all_of) {
        None => String::new(),
        Some(Ok(axes)) => axes.iter().map(|axis| format!("{axis:?}")).collect::<Vec<_>>().join(" "),
        Some(Err(error)) => error.to_string(),
    };
    let outputs = |found: &Found| -> String {
        let sweep = found.scene.sweep.as_ref();
        let outputs = sweep.map(|sweep| sweep.outputs.join(",")).unwrap_or_default();
        if outputs.is_empty() { "all".to_owned() } else { outputs }
    };
    let described = |found: &Found| {
        let part = &found.part;
        let mut all = vec![
            ("the number of parts", part.shard.place().1.to_string()),
            ("the axes", axes(found)),
            ("the outputs", outputs(found)),
            ("the design", part.design.to_string()),
            ("the CSV style", part.style.word().to_owned()),
            ("the scene's name", part.name.clone()),
            ("the version", found.version.clone()),
        ];
        all.extend(VARIABLES.iter().map(|variable| (variable.symbol, variable.show(&found.scene))));
        all
    };
    let mut both = described(one).into_iter().zip(described(other));
    let differing = both.find(|(one, other)| one.1 != other.1);
    let in_words =
        |((what, one), (_, other))| format!("{what} is {one} in one and {other} in the other");
    let is_same = one.scene == other.scene;
    differing.map(in_words).or_else(|| (!is_same).then(|| "their scenes differ".to_owned()))
}

/// Whether every part is there once; they are in order.
fn each_once(found: &[Found]) -> Result<(), FileError> {
    let number = |one: &Found| one.part.shard.place().0;
    for pair in found.windows(2) {
        if number(&pair[0]) == number(&pair[1]) {
            let [one, other] = [&pair[0], &pair[1]].map(|it| shown(&it.path));
            let shard = pair[0].part.shard;
            return Err(refuse(format!("`{one}` and `{other}` are both part {shard}: omit one")));
        }
    }
    let count = found.first().map_or(0, |one| one.part.shard.place().1);
    let missing: Vec<String> = (1..=count)
        .filter(|part| found.iter().all(|one| number(one) != *part))
        .take(4)
        .map(|part| format!("{part}/{count}"))
        .collect();
    match missing.as_slice() {
        [] => Ok(()),
        [first, ..] => Err(refuse(format!(
            "part {} is missing: compute it with --shard {first}",
            missing.join(", ")
        ))),
    }
}

/// Whether every row of a part is the row of its point.
fn check_rows(one: &Found, plan: &Plan) -> Result<(), FileError> {
    let (path, style, shard) = (shown(&one.path), one.part.style, one.part.shard);
    let failed = |source| FileError::read(&one.path, source);
    let mut file = BufReader::new(File::open(&one.path).map_err(failed)?);
    let has_head = shard.is_first();
    if has_head {
        file.seek(SeekFrom::Start(style.head().len() as u64)).map_err(failed)?;
    }
    let delimiter = if style == Style::ExcelEu { b';' } else { b',' };
    let mut reader = ReaderBuilder::new()
        .has_headers(has_head)
        .delimiter(delimiter)
        .flexible(true)
        .from_reader(file);
    let points = shard.of(plan.points());
    let (mut row, mut next) = (csv::StringRecord::new(), points.start);
    while reader.read_record(&mut row)? {
        let is_own = |axis: usize| {
            let value = units::shortest(plan.coordinate(next, axis));
            row.get(axis).is_some_and(|field| field.replace(',', ".") == value)
        };
        if next >= points.end || !(0..plan.axes().len()).all(is_own) {
            let row = next - points.start + 1;
            return Err(refuse(format!(
                "`{path}`: row {row} is not the row of its point: the file was changed after it was written; compute part {shard} again"
            )));
        }
        next += 1;
    }
    if next == points.end {
        return Ok(());
    }
    let (found, all) = (next - points.start, points.end - points.start);
    Err(refuse(format!("`{path}` has {found} of the {all} rows of part {shard}: compute it again")))
}
