//! The measurements, computed from their presets.

use crate::files::error::FileError;
use crate::files::preset;
use crate::study::context::Context;
use crate::study::validation::{Row, compute, measurements};

/// Every case, computed from its bundled preset; fewer than all when stopped.
pub fn report(context: &mut Context<'_>) -> Result<Vec<Row>, FileError> {
    let cases = measurements().cases.iter();
    let all: Vec<_> = cases
        .map(|case| Ok((case, preset::resolve(case.preset, None)?.scene)))
        .collect::<Result<_, FileError>>()?;
    context.expect(all.len());
    Ok(context.map_items(
        &all,
        |(case, scene)| Some(compute(case, scene)),
        |context, _| context.goes_on(),
    ))
}
