//! What a study came to, for people: tables, charts, maps and whole reports, each from one description.
//!
//! A description knows neither screen nor file; the renderers make SVG, HTML and Markdown of it, `cli::draw` lines of text.

pub mod chart;
pub mod document;
pub mod figures;
pub mod map;
pub mod svg;
