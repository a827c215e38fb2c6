//! A curve: where its points come from, how it is told from others, and its value at the crosshair.

use std::borrow::Cow;

use ratatui::text::Span;

use crate::tui::theme::Role;

/// Characters that tell curves apart, the current run's first; none is used by axes, event lines or the crosshair alone.
pub const MARKERS: [char; 9] = ['*', 'o', '+', 'x', '#', '%', '@', '&', '$'];

/// How a curve stands among the others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Emphasis {
    /// Of results that a newer computation is about to replace: faint, at the bottom, `(old)` in the legend.
    Stale,
    /// One of many, in the order given.
    #[default]
    Normal,
    /// Drawn last, over the others.
    Selected,
}

/// Which vertical axis a curve belongs to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Side {
    /// The main one.
    #[default]
    Left,
    /// The second one; the legend says `(right)`.
    Right,
}

/// A curve.
pub struct Curve<'a> {
    /// The character it is drawn with in ASCII, and marked with otherwise. One cell wide.
    pub marker: char,
    /// Its name in the legend.
    pub label: Cow<'a, str>,
    /// Its points, in the units of the axes' views, in drawing order; a gap where a number is not finite.
    pub points: &'a [(f64, f64)],
    /// Which colour: [`Role::Curve`].
    pub colour: usize,
    /// How it stands among the others.
    pub emphasis: Emphasis,
    /// Which vertical axis it belongs to.
    pub side: Side,
}

impl<'a> Curve<'a> {
    /// A curve through points in memory.
    pub fn new(marker: char, label: impl Into<Cow<'a, str>>, points: &'a [(f64, f64)]) -> Self {
        let label = label.into();
        Self { marker, label, points, colour: 0, emphasis: Emphasis::Normal, side: Side::Left }
    }

    /// In this colour.
    #[must_use]
    pub fn colour(mut self, colour: usize) -> Self {
        self.colour = colour;
        self
    }

    /// With this emphasis.
    #[must_use]
    pub fn emphasis(mut self, emphasis: Emphasis) -> Self {
        self.emphasis = emphasis;
        self
    }

    /// On this axis.
    #[must_use]
    pub fn side(mut self, side: Side) -> Self {
        self.side = side;
        self
    }

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
