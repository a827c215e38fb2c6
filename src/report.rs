//! What a study came to, for people: tables, charts, maps and whole reports, each from one description.
//!
//! A description knows neither screen nor file; the renderers make SVG, HTML and Markdown of it, `cli::draw` lines of text.

pub mod accuracy;
pub mod chart;
pub mod compare;
pub mod document;
pub mod figures;
pub mod fit;
pub mod front;
pub mod limit;
pub mod map;
pub mod models;
pub mod monte_carlo;
pub mod run;
pub mod seek;
pub mod sensitivity;
pub mod series;
pub mod stability;
pub mod steps;
pub mod svg;
pub mod sweep;
pub mod table;
pub mod thesis;
pub mod unit;
pub mod validation;
