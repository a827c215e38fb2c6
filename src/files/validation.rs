//! The measurements, computed from their presets.

use std::ops::{ControlFlow, Range};

use crate::files::error::FileError;
use crate::files::preset;
use crate::study::sweep::crew::Crew;
use crate::study::validation::{Row, cases, compute};

/// Every case, computed from its bundled preset on all cores; `watch` is asked with the cases done and all, and `Break` keeps
/// those.
///
/// # Errors
/// [`FileError`] should a preset be missing.
pub fn report(
    watch: &mut dyn FnMut(usize, usize) -> ControlFlow<()>,
) -> Result<Vec<Row>, FileError> {
    let all: Vec<_> = cases()
        .map(|case| Ok((case, preset::resolve(case.preset, None)?.scene)))
        .collect::<Result<_, FileError>>()?;
    let crew = Crew { piece: 1, ..Crew::of_machine() };
    let mut rows = Vec::new();
    let compute = |piece: Range<u64>| {
        let (case, scene) = all.get(usize::try_from(piece.start).ok()?)?;
        Some(compute(case, scene))
    };
    let _ = crew.work_heard(
        0..all.len() as u64,
        || compute,
        |news| {
            rows.extend(news.and_then(|(_, row)| row));
            watch(rows.len(), all.len())
        },
    );
    Ok(rows)
}
