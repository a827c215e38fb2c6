//! How a curve is told from others.

use ratatui::text::Span;

use super::{Curve, Emphasis};
use crate::tui::theme::Role;

/// Characters that tell curves apart, the current run's first; none is used by axes, event lines or the crosshair alone.
pub const MARKERS: [char; 9] = ['*', 'o', '+', 'x', '#', '%', '@', '&', '$'];

/// The role that colours it.
pub(super) fn role(curve: &Curve<'_>) -> Role {
    match curve.emphasis {
        Emphasis::Stale => Role::Dim,
        Emphasis::Normal | Emphasis::Selected => Role::Curve(curve.colour),
    }
}

/// The marker, if it takes exactly one cell; else one that does.
pub(super) fn cell_marker(curve: &Curve<'_>) -> char {
    let mut bytes = [0; 4];
    let text: &str = curve.marker.encode_utf8(&mut bytes);
    if !curve.marker.is_control() && Span::raw(text).width() == 1 {
        curve.marker
    } else {
        MARKERS[0]
    }
}
