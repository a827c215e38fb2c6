//! The battery and the map as text.

use std::fmt::Write as _;

use crate::cli::draw;
use crate::model::units::Engineering;
use crate::report::figures;
use crate::report::stability::{HOW_IT_RAN, table};
use crate::study::stability::map::Map;
use crate::study::stability::{Basis, ERROR_MAX, RESIDUAL_MAX, Row};
use crate::tui::theme::Theme;

/// From this width on there is room for what makes a scene hard.
const WIDE: usize = 118;

/// The table of the battery, what it means, and one line that sums it up.
pub(super) fn battery(rows: &[Row], took_s: f64, width: usize) -> String {
    let mut keys = vec!["scene"];
    keys.extend(HOW_IT_RAN);
    if width >= WIDE {
        keys.extend(["reference", "why_hard"]);
    }
    let mut text = table(rows).page(&keys, if width >= WIDE { usize::MAX } else { width });
    for row in rows {
        if let Some(shortfall) = row.shortfall {
            let end = row.run.end.words();
            let _ = writeln!(text, "{} fails: {} ({end})", row.case.name, shortfall.words());
        }
    }
    text.push('\n');
    text.push_str(LEGEND);
    summary(&mut text, rows, took_s);
    text
}

/// What the columns mean, a line each.
const LEGEND: &str = "\
ends        arrested, perforated, separated, moving (undecided at the horizon), or CUT
error       of final depth (of exit time if perforated), against s stored digits, D DOP853 or R Radau IIA at 1e-13 on a \
second implementation of the equations, or t this solver at 1e-12 (where motion after the contact decides, or D and R fail)
stiff       largest rate of spring or damper times the contact's duration
expl, impl  DOP853 and Radau IIA at 1e-9 on the contact, at most 20000 steps
th-6, th-7  the thesis's Appendix A as printed with dt = 1e-6 and 1e-7 s: ok (error below 1e-6, thesis 1e-2), else the error, \
or end! wrong outcome, DIV diverged, stop no progress, many too many steps, late out of time, - not applicable, or nothing to \
compare with

";

fn summary(text: &mut String, rows: &[Row], took_s: f64) {
    let short: Vec<&str> =
        rows.iter().filter(|row| row.shortfall.is_some()).map(|row| row.case.name).collect();
    let without = rows.iter().filter(|row| row.basis == Basis::None).count();
    let _ = writeln!(
        text,
        "{} of {} scenes pass (energy and error within {RESIDUAL_MAX:e} and {ERROR_MAX:e}; {without} without a reference); {:.1} s",
        rows.len() - short.len(),
        rows.len(),
        took_s
    );
    if !short.is_empty() {
        let _ = writeln!(text, "auto fails on: {}", short.join("; "));
    }
}

/// The map, and the largest step of the scene.
pub(super) fn map(map: &Map, scene: &str) -> String {
    let largest = map.largest_stable_dt_s.map_or_else(
        || "no limit".to_owned(),
        |value| Engineering { value, unit: "s", digits: 3 }.to_string(),
    );
    let picture = draw::map(&figures::stability::map(map), draw::MAP, Theme::PLAIN);
    format!(
        "{} on {scene}: time step against {}\n\n{picture}\nlargest stable dt of this scene: {largest}\n",
        map.method.name(),
        map.axis.symbol()
    )
}
