//! Charts as plain text: what the workbench draws, for pipes, logs and screen readers.
//!
//! The contact first, since it is over in a fraction of a millisecond; then the whole response, where there is more of it.
//! Event lines carry the letters of the list of events in the summary.

use crate::cli::Glyphs;
use crate::cli::summary::event_letter;
use crate::model::run::{Run, Sample};
use crate::tui::chart::{Axis, Chart, Curve, EventLine, Scale, Unit, ViewRange};
use crate::tui::theme::{ColourDepth, GlyphSet, Theme};

const WIDTH: u16 = 78;
const HEIGHT: u16 = 15;

/// A quantity to draw.
#[derive(Clone, Copy)]
struct Quantity {
    title: &'static str,
    unit: &'static str,
    get: fn(&Sample) -> f64,
}

const DEPTH: Quantity =
    Quantity { title: "penetration p", unit: "m", get: |row| row.penetration_m };
const PLATE: Quantity =
    Quantity { title: "plate displacement x", unit: "m", get: |row| row.plate_displacement_m };
const FORCE: Quantity =
    Quantity { title: "contact force F", unit: "N", get: |row| row.contact_force_n };

impl Glyphs {
    /// The set to print with; where nothing is said, the one that works everywhere.
    fn for_print(self) -> GlyphSet {
        match self {
            Self::Auto | Self::Ascii => GlyphSet::Ascii,
            Self::Block => GlyphSet::Block,
            Self::Braille => GlyphSet::Braille,
        }
    }
}

/// The charts of a run, each under the other.
pub(super) fn charts(run: &Run, glyphs: Glyphs) -> String {
    let Some(end_s) = run.series.last().map(|row| row.t_s) else {
        return String::new();
    };
    let theme = Theme { glyphs: glyphs.for_print(), depth: ColourDepth::None };
    let contact_s = run.contact_end_s();
    // A little beyond its end, so that the end itself is seen.
    let window_s = (1.1 * contact_s).min(end_s);
    let mut text = String::new();
    for quantity in [DEPTH, PLATE, FORCE] {
        push(&mut text, run, quantity, "contact", window_s, theme);
    }
    if end_s > 2.0 * window_s {
        for quantity in [DEPTH, PLATE, FORCE] {
            push(&mut text, run, quantity, "whole response", end_s, theme);
        }
    }
    text
}

fn push(text: &mut String, run: &Run, quantity: Quantity, window: &str, end_s: f64, theme: Theme) {
    // A chart of one value would be a line along its own frame.
    let shown = run.series.iter().filter(|row| row.t_s <= end_s);
    let values = ViewRange::of(Scale::Linear, shown.map(quantity.get));
    let (Some(values), true) = (values, end_s > 0.0) else {
        return;
    };
    let time = ViewRange::new(0.0, end_s);
    let view = values.including(0.0).padded(Scale::Linear, 0.05);
    let x = Axis::new("t", time).unit(Unit::with_prefix(time, "s"));
    let y = Axis::new("", view).unit(Unit::with_prefix(values, quantity.unit));
    let curve = Curve::of('*', "", &run.series, move |row: &Sample| (row.t_s, (quantity.get)(row)));
    let events = run
        .events
        .iter()
        .enumerate()
        .filter(|(_, event)| event.t_s <= end_s)
        .map(|(index, event)| EventLine {
            x: event.t_s,
            tag: event_letter(index).to_string().into(),
        })
        .collect();
    let chart = Chart {
        events,
        legend: crate::tui::chart::Legend::Hidden,
        ..Chart::new(format!("{}, {window}", quantity.title), x, y, vec![curve])
    };
    text.push('\n');
    for line in chart.to_lines(WIDTH, HEIGHT, theme) {
        text.push_str(&line);
        text.push('\n');
    }
}
