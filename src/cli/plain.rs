//! Charts as plain text: what the workbench draws, for pipes, logs and screen readers.
//!
//! The contact first, since it is over in a fraction of a millisecond; then the whole response, where there is more of it, and the
//! law of the mechanism.
//! Event lines carry the letters of the list of events in the summary.

use crate::cli::{Glyphs, draw};
use crate::model::run::Run;
use crate::report::figures::run::{mechanism, response};
use crate::tui::theme::{ColourDepth, GlyphSet, Theme};

const SIZE: draw::Size = (78, 15);

impl Glyphs {
    /// The characters to print with; without the option, those that work everywhere.
    fn for_print(self) -> GlyphSet {
        match self {
            Self::Auto | Self::Ascii => GlyphSet::Ascii,
            Self::Block => GlyphSet::Block,
            Self::Braille => GlyphSet::Braille,
        }
    }
}

/// The charts of a run and of its mechanism, each under the other.
pub(super) fn charts(run: &Run, glyphs: Glyphs) -> String {
    let theme = Theme { glyphs: glyphs.for_print(), depth: ColourDepth::None };
    let charts = response(run).into_iter().chain(mechanism(run));
    charts.fold(String::new(), |text, chart| text + "\n" + &draw::chart(&chart, SIZE, theme))
}
