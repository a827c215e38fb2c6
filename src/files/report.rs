//! Report of a scene as a self-contained HTML file.

use std::path::Path;

use crate::files::{clean, write};
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_studies::report::document;
use cmra_studies::report::scene::{SceneReport, page};
use cmra_studies::study::limit::LimitReport;
use cmra_studies::study::sweep::grid::Grid;

/// Returns `true` if a file has the extension of a report.
pub fn is_report(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    matches!(ending.as_str(), "html" | "htm" | "xhtml")
}

/// Returns the report of a scene as HTML: its run, its ballistic limit, and the sweep it contains (one or two axes).
pub fn html(
    (name, scene): (&str, &Scene),
    run: &Run,
    limit: &LimitReport,
    sweep: Option<&Grid>,
) -> String {
    let file = write::fresh(scene);
    let report = SceneReport { scene: (name, scene), file, run, limit, sweep };
    clean::page(&document::html(&page(&report))).into_owned()
}
