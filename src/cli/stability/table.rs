//! The battery and the map as text.

use std::fmt::Write as _;

use crate::model::units::{Engineering, significant};
use crate::report::stability::{HOW_IT_RAN, table};
use crate::study::stability::map::{Cell, Map};
use crate::study::stability::{Basis, ERROR_MAX, RESIDUAL_MAX, Row};

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
    legend(&mut text);
    summary(&mut text, rows, took_s);
    text
}

fn legend(text: &mut String) {
    text.push_str(
        "ends   arrested, perforated, separated, moving (undecided at the horizon), or CUT\n\
         error  of final depth (exit time, perforated), against s stored digits, D DOP853\n\
         \x20      or R Radau IIA at 1e-13 on equations written a second time, t the engine\n\
         \x20      at 1e-12, where what follows the contact decides or neither gets through\n\
         stiff  largest rate of spring or damper times the contact's duration\n\
         expl, impl  DOP853 and Radau IIA at 1e-9 on the contact, at most 20000 steps\n\
         th-6, th-7  the thesis's Appendix A as printed with dt = 1e-6 and 1e-7 s\n\
         \x20      ok (1e-6, thesis 1e-2), else the error, or: end! another ending,\n\
         \x20      BLOW blown up, stuk stuck, many too many steps, late out of time,\n\
         \x20      - no equations for this scene, or nothing to compare with\n\n",
    );
}

fn summary(text: &mut String, rows: &[Row], took_s: f64) {
    let short: Vec<&str> =
        rows.iter().filter(|row| row.shortfall.is_some()).map(|row| row.case.name).collect();
    let without = rows.iter().filter(|row| row.basis == Basis::None).count();
    let _ = writeln!(
        text,
        "{} of {} scenes hold (energy and error within {RESIDUAL_MAX:e} and {ERROR_MAX:e}; {without} without a reference); {:.1} s",
        rows.len() - short.len(),
        rows.len(),
        took_s
    );
    if !short.is_empty() {
        let _ = writeln!(text, "auto fails on: {}", short.join("; "));
    }
}

/// The map, rows from the greatest value down, the analytic limit as `|`, the present point as `+`.
pub(super) fn map(map: &Map, scene: &str) -> String {
    let mut text =
        format!("{} on {scene}: time step against {}\n\n", map.method.name(), map.axis.symbol());
    let columns = map.dt_s.len();
    let present = map.present_at();
    for row in (0..map.values.len()).rev() {
        let limit = map.limit_column(row);
        let _ = write!(text, "{:>9} ", significant(map.values[row], 2));
        for column in 0..columns {
            let here = present == (Some(row), Some(column));
            text.push(if here {
                '+'
            } else if limit == Some(column) {
                '|'
            } else {
                map.cell(row, column).letter()
            });
        }
        text.push('\n');
    }
    let time = |value: f64| Engineering { value, unit: "s", digits: 2 }.to_string();
    let (first, last) = (time(map.dt_s[0]), time(map.dt_s[columns - 1]));
    let gap = columns.saturating_sub(first.len() + last.len());
    let _ = writeln!(text, "{:>9} {first}{:gap$}{last}   dt\n", map.axis.symbol(), "");
    let word = |cell: Cell| format!("{} {}", cell.letter(), cell.words());
    let _ = writeln!(
        text,
        "{}, {}, {}, {},\n{}, {}",
        word(Cell::Accurate),
        word(Cell::Inaccurate),
        word(Cell::Oscillating),
        word(Cell::BlownUp),
        word(Cell::TooManySteps),
        word(Cell::Unknown),
    );
    let _ = writeln!(text, "| analytic limit of stability, + the scene with dt = 1e-6 s");
    let _ = match map.largest_stable_dt_s {
        Some(value) => {
            let largest = Engineering { value, unit: "s", digits: 3 };
            writeln!(text, "largest stable dt of this scene: {largest}")
        }
        None => writeln!(text, "largest stable dt of this scene: nothing limits it"),
    };
    text
}
