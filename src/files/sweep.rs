//! What stands above the scene beside a sweep's table: what is missing, and the warnings.

use std::fmt::Write as _;

use crate::files::clean;
use crate::study::sweep::Plan;
use crate::study::validity;

/// The comment lines above a scene with its `[sweep]`; `missing`: that the table is not complete.
pub fn notes(plan: &Plan, missing: Option<&str>) -> String {
    let mut text = missing.map_or_else(String::new, |missing| format!("# {missing}\n"));
    for warning in validity::of_plan(plan) {
        let _ = writeln!(text, "# warning: {}", clean::line(&warning));
    }
    text
}
