//! How a curve is told from others.

use ratatui::text::Span;

use super::{Curve, Emphasis};
use crate::tui::theme::Role;

/// Characters that tell curves apart, the current run's first; none is used by axes, event lines or the crosshair alone.
pub const MARKERS: [char; 9] = ['*', 'o', '+', 'x', '#', '%', '@', '&', '$'];

impl Curve<'_> {
    /// The role that colours it.
    pub(super) fn role(&self) -> Role {
        match self.emphasis {
            Emphasis::Stale => Role::Dim,
            Emphasis::Normal | Emphasis::Selected => Role::Curve(self.colour),
        }
    }

    /// The marker, if it takes exactly one cell; else one that does.
    pub(super) fn cell_marker(&self) -> char {
        let mut bytes = [0; 4];
        let text: &str = self.marker.encode_utf8(&mut bytes);
        if !self.marker.is_control() && Span::raw(text).width() == 1 {
            self.marker
        } else {
            MARKERS[0]
        }
    }
}
