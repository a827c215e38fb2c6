//! `cmra libraries`: threats, materials and absorbers, bundled or the user's own.

use clap::Args;

use crate::cli::table::{TableArguments, choice};
use crate::cli::{CliError, output, text};
use crate::files::library;
use crate::files::paths::Paths;
use cmra_studies::report::library::page;
use cmra_studies::study::library::Library;

#[derive(Debug, Args)]
pub(super) struct LibrariesArguments {
    /// Show only this library
    #[arg(value_parser = choice(&Library::ALL, Library::file, about))]
    library: Option<Library>,
}

/// Describes the contents of a library, for `--help`.
fn about(library: Library) -> &'static str {
    match library {
        Library::Threats => "Projectiles and their velocities",
        Library::Materials => "Densities, strengths and moduli of plates",
        Library::Absorbers => "Springs and crushable absorbers, with their energy per mass",
    }
}

pub(super) fn run(arguments: &LibrariesArguments) -> Result<(), CliError> {
    let (entries, problems) = library::list(Paths::of_user().ok().as_ref());
    let of = |library| entries.iter().filter(move |entry| entry.library == library);
    let shown = Library::ALL
        .into_iter()
        .filter(|library| arguments.library.is_none_or(|one| one == *library));
    let style = TableArguments::default().style();
    let pages: Vec<String> =
        shown.map(|library| text::plain(&page(library, of(library)), style)).collect();
    output::print(&pages.join("\n"))?;
    for problem in problems {
        output::note(&format!("not listed: {problem}"));
    }
    Ok(())
}
