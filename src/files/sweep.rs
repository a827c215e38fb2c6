//! What stands above the scene beside a sweep's table: what is missing, the warnings, and the command that makes the rows again.

use std::fmt::Write as _;

use crate::files::{clean, export};
use crate::study::sweep::{Plan, Shard};
use crate::study::validity;

/// The comment lines above a scene with its `[sweep]`, whose file is called `own`; `missing`: that the table is not complete.
pub fn notes(own: &str, plan: &Plan, shard: Shard, missing: Option<&str>) -> String {
    let part = if shard == Shard::WHOLE { String::new() } else { format!(" --shard {shard}") };
    let mut text = String::new();
    if let Some(missing) = missing {
        let _ = writeln!(text, "# {missing}");
    }
    for warning in validity::of_plan(plan) {
        let _ = writeln!(text, "# warning: {}", clean::line(&warning));
    }
    text + &export::again(&format!("sweep{part}"), own)
}
