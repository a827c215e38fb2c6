//! Measurements: the built-in ones, computed from their presets, and the user's own from a CSV file.

use std::path::Path;

use crate::files::error::FileError;
use crate::files::paths::Paths;
use crate::files::{clean, inputs, library, preset, read};
use cmra_studies::study::context::Context;
use cmra_studies::study::library::Library;
use cmra_studies::study::measured::{self, FindEntry, Measurement};
use cmra_studies::study::validation::{Row, compute, measurements};

/// Reads measurements from a CSV file, with the user's own threats and materials.
///
/// # Errors
/// A [`FileError`] if the file cannot be read or is not a table of measurements.
pub fn read_measurements(path: &Path) -> Result<Vec<Measurement>, FileError> {
    let text = inputs::text_file(path, read::BYTES_MAX)?;
    let paths = Paths::of_user().ok();
    let find: FindEntry<'_> = &|library: Library, name: &str| {
        library::find(library, name, paths.as_ref()).map_err(|problem| problem.to_string())
    };
    measured::read(&text, find).map_err(|problem| {
        let name = clean::line(&path.to_string_lossy()).into_owned();
        FileError::Refused(format!("`{name}`, {problem}"))
    })
}

/// Computes every case from its bundled preset; returns fewer rows if stopped.
pub fn report(context: &mut Context<'_>) -> Result<Vec<Row>, FileError> {
    let cases = measurements().cases.iter();
    let all: Vec<_> = cases
        .map(|case| Ok((case, preset::resolve(case.preset, None)?.scene)))
        .collect::<Result<_, FileError>>()?;
    context.expect(all.len());
    Ok(context.map_items(
        &all,
        |(case, scene)| Some(compute(case, scene)),
        |context, _| context.should_continue(),
    ))
}
