//! The measurements, computed from their presets.

use std::ops::Range;

use crate::files::error::FileError;
use crate::files::preset;
use crate::study::context::Context;
use crate::study::sweep::crew::Crew;
use crate::study::validation::{Row, cases, compute};

/// Every case, computed from its bundled preset; fewer than all when stopped.
///
/// # Errors
/// [`FileError`] should a preset be missing.
pub fn report(context: &mut Context<'_>) -> Result<Vec<Row>, FileError> {
    let all: Vec<_> = cases()
        .map(|case| Ok((case, preset::resolve(case.preset, None)?.scene)))
        .collect::<Result<_, FileError>>()?;
    context.expect(all.len());
    let crew = Crew { threads: context.threads(), piece: 1 };
    let mut rows = Vec::new();
    let compute = |piece: Range<u64>| {
        let (case, scene) = all.get(usize::try_from(piece.start).ok()?)?;
        Some(compute(case, scene))
    };
    let _ = crew.work_heard(
        0..all.len() as u64,
        || compute,
        |news| {
            context.count(usize::from(news.is_some()));
            rows.extend(news.and_then(|(_, row)| row));
            context.flow()
        },
    );
    Ok(rows)
}
