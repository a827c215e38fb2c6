//! Contacts whose end is known to 18 digits: an 80-bit Taylor series and 30-digit arithmetic agree on them.

use crate::model::run::Outcome;

/// Text of the table, CSV with a header row.
pub const TABLE: &str = include_str!("../data/reference.csv");

/// A row of [`TABLE`].
#[derive(Clone, Debug, PartialEq)]
pub struct Stored {
    /// Name of the reference scene.
    pub name: &'static str,
    /// Changes to Table 9.1 with gamma = 1 and neither spring nor damper, for `changed_free_plate`.
    pub changes: String,
    /// How the contact ends: arrested or perforated.
    pub outcome: Outcome,
    /// End time, s.
    pub t_s: f64,
    /// Depth then, m.
    pub depth_m: f64,
    /// The digits of time and depth that can be trusted.
    pub trusted: i32,
}

impl Stored {
    /// Every row.
    pub fn rows() -> impl Iterator<Item = Self> {
        let lines = TABLE.lines().skip(1);
        lines.filter_map(|line| {
            let fields: Vec<&'static str> = line.split(',').collect();
            let [name, changes, end, t_s, depth_m, _, _, trusted] = fields[..] else {
                return None;
            };
            let mut trusted = trusted.split([':', ' ']).filter_map(|part| part.parse().ok());
            Some(Self {
                name,
                changes: changes.replace("base", ""),
                outcome: if end == "perf" { Outcome::Perforated } else { Outcome::Arrested },
                t_s: t_s.parse().ok()?,
                depth_m: depth_m.parse().ok()?,
                trusted: trusted.next()?,
            })
        })
    }
}
