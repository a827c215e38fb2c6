//! Joins the parts of a sweep into the file that one run would have written.
//!
//! Each part is checked against the checksum in the sidecar beside it. Changed parts, parts of different sweeps, gaps and doubles
//! are refused.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::files::error::{FileError, shown};
use crate::files::export::{self, Beside};
use crate::files::read::{self, Accepts};
use crate::files::shard::{Checksum, Part, Written};
use crate::model::scene::Scene;
use crate::model::variables::VARIABLES;
use crate::study::sweep::{Axis, Shard};

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
    sidecar: String,
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
        found.iter().try_for_each(check_bytes)?;
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
        self.parts.iter().try_for_each(|path| each_piece_of(path, &mut take))
    }

    /// The scene that one run would have written beside this table.
    pub fn beside(&self) -> Beside<'_> {
        self.joined.beside(&self.scene, Written::default())
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
    Ok(Found { path: path.to_owned(), part, scene, sidecar: text, version })
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

/// Whether a part is, to the byte, as it was written.
fn check_bytes(one: &Found) -> Result<(), FileError> {
    let mut checksum = Checksum::default();
    each_piece_of(&one.path, |piece| {
        checksum.add(piece);
        Ok::<(), FileError>(())
    })?;
    if one.part.is_as_written(&one.sidecar, checksum) {
        return Ok(());
    }
    Err(refuse(format!(
        "`{}` or the `{}` beside it was changed after it was written: compute part {2} again, with --shard {2}",
        shown(&one.path),
        shown(&export::sidecar_path(&one.path, None)),
        one.part.shard
    )))
}

/// Give away the bytes of a file, piece by piece.
fn each_piece_of<E: From<FileError>>(
    path: &Path,
    mut take: impl FnMut(&[u8]) -> Result<(), E>,
) -> Result<(), E> {
    let failed = |source| FileError::read(path, source);
    let mut file = File::open(path).map_err(failed)?;
    let mut piece = vec![0; PIECE];
    loop {
        match file.read(&mut piece).map_err(failed)? {
            0 => return Ok(()),
            count => take(&piece[..count])?,
        }
    }
}
