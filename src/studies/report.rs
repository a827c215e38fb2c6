//! The results of studies for people: tables, charts, maps and whole reports, each from one description.
//!
//! A description knows neither screen nor file; the renderers make SVG and HTML of it, `tui::plain` lines of text.

use std::borrow::Cow;

pub mod accuracy;
pub mod chart;
pub mod clean;
pub mod compare;
pub mod design;
pub mod document;
pub mod energies;
pub mod figures;
pub mod front;
pub mod law;
pub mod library;
pub mod limit;
pub mod map;
pub mod measured;
pub mod monte_carlo;
pub mod page;
pub mod run;
pub mod scene;
pub mod seek;
pub mod sensitivity;
pub mod series;
pub mod stability;
pub mod steps;
pub mod svg;
pub mod sweep;
pub mod table;
pub mod thesis;
pub mod traces;
pub mod validation;
pub mod verdict;
pub mod wrap;

/// Words about a result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// Subject of the line; empty if the text contains it.
    pub about: Cow<'static, str>,
    /// The words.
    pub text: String,
    /// Whether a reader has to take care.
    pub is_caution: bool,
}

impl Remark {
    /// Words about something.
    pub fn new(about: impl Into<Cow<'static, str>>, text: impl Into<String>) -> Self {
        Self { about: about.into(), text: text.into(), is_caution: false }
    }

    /// Builds a line that asks for caution.
    pub fn caution(about: impl Into<Cow<'static, str>>, text: impl Into<String>) -> Self {
        Self { is_caution: true, ..Self::new(about, text) }
    }
}
