//! The thesis's tables and figures by their numbers, and its symbols by their meanings: for claims about references.

/// Tables, as they are captioned.
const TABLES: [&str; 9] = ["4.1", "5.1", "7.1", "7.2", "8.1", "8.2", "9.1", "9.2", "9.3"];

/// The last figure of each chapter, from the second on.
const LAST_FIGURE: [(u32, u32); 8] =
    [(2, 18), (3, 1), (4, 2), (5, 4), (6, 9), (7, 0), (8, 18), (9, 14)];

/// Captions that a claim turns on, as printed.
const CAPTIONS: [(&str, &str); 2] = [
    ("8.4", "Simple ballistic impact lumped-parameter model"),
    ("8.8", "Combined lumped-parameter model of projectile-plate and plate-mechanism reaction"),
];

/// Symbols with more than one meaning, and what they stand for where.
pub(super) const SYMBOLS: [(&str, &[&str]); 8] = [
    (
        "gamma",
        &[
            "change of trajectory (Figure 2.16)",
            "mass ratio (9.1)",
            "mass of a spring (9.5.1)",
            "radius factor (Table 9.3)",
        ],
    ),
    ("S_y", &["dynamic strength (8.4)", "static yield (8.3.1)", "yield strength (Table 9.3)"]),
    ("d", &["projectile diameter (2.3)", "effective thickness (4.1)", "cocking distance (9.2.2)"]),
    ("b", &["damper (8.1)", "height of the tip (9.5.2)"]),
    ("m", &["mass (2.4)", "damper's exponent (8.1)"]),
    ("h", &["plate thickness (Table 9.1)", "beam height (Table 9.3)"]),
    ("A", &["area (8.4)", "amplitude (8.7)"]),
    ("theta", &["yaw (2.4.2)", "incidence (Appendix)"]),
];

/// Whether a table of this number exists.
pub(super) fn has_table(number: &str) -> bool {
    TABLES.contains(&number)
}

/// The caption of a figure, where a claim turns on it.
pub(super) fn caption(figure: &str) -> Option<&'static str> {
    CAPTIONS.iter().find(|(number, _)| *number == figure).map(|(_, caption)| *caption)
}

/// Whether a figure of this number exists.
pub(super) fn has_figure(number: &str) -> bool {
    let Some((chapter, figure)) = number.split_once('.') else { return false };
    let (Ok(chapter), Ok(figure)) = (chapter.parse::<u32>(), figure.parse::<u32>()) else {
        return false;
    };
    let last = LAST_FIGURE.iter().find(|(own, _)| *own == chapter).map_or(0, |(_, last)| *last);
    (1..=last).contains(&figure)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_looked_up() {
        assert!(has_table("9.3") && !has_table("9.5.2"));
        assert!(has_figure("5.2") && has_figure("8.18") && has_figure("9.14"));
        assert!(
            !has_figure("5.1.2") && !has_figure("7.1") && !has_figure("8.19") && !has_figure("x")
        );
        assert!(SYMBOLS.iter().all(|(_, meanings)| meanings.len() > 1));
    }
}
