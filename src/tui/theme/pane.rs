//! The frame around a pane: title at the left of the top line, something short at its right, all panes alike.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::Line;

use super::{Role, Theme};

/// A frame with its titles.
#[derive(Clone, Debug, Default)]
pub struct PaneFrame<'a> {
    title: Line<'a>,
    right: Line<'a>,
    focused: bool,
    open_below: bool,
}

impl<'a> PaneFrame<'a> {
    /// A frame with this title at its left.
    pub fn new(title: impl Into<Line<'a>>) -> Self {
        Self { title: title.into(), ..Self::default() }
    }

    /// With this title at its left.
    #[must_use]
    pub fn titled(self, title: impl Into<Line<'a>>) -> Self {
        Self { title: title.into(), ..self }
    }

    /// With this at the right of the top line; left out where there is no room.
    #[must_use]
    pub fn right(mut self, right: impl Into<Line<'a>>) -> Self {
        self.right = right.into();
        self
    }

    /// Whether the pane has the keys.
    #[must_use]
    pub fn focused(mut self, focused: bool) -> Self {
        self.focused = focused;
        self
    }

    /// Without the line below, for panes stacked on each other.
    #[must_use]
    pub fn open_below(mut self) -> Self {
        self.open_below = true;
        self
    }

    /// What is inside the frame.
    pub fn inner(&self, area: Rect) -> Rect {
        let below = u16::from(!self.open_below);
        Rect {
            x: area.x.saturating_add(u16::from(area.width > 0)),
            y: area.y.saturating_add(u16::from(area.height > 0)),
            width: area.width.saturating_sub(2),
            height: area.height.saturating_sub(1 + below),
        }
    }

    /// Draws the frame and gives what is inside.
    pub fn render(&self, area: Rect, buffer: &mut Buffer, theme: Theme) -> Rect {
        let inner = self.inner(area);
        let area = area.intersection(buffer.area);
        if area.width < 2 || area.height < 1 {
            return inner.intersection(area);
        }
        let role = if self.focused { Role::Focus } else { Role::Border };
        self.draw_lines(area, buffer, theme, theme.style(role));
        self.draw_titles(area, buffer, theme.title(self.focused));
        inner.intersection(area)
    }

    fn draw_lines(&self, area: Rect, buffer: &mut Buffer, theme: Theme, style: Style) {
        let lines = theme.lines();
        let (left, right) = (area.left(), area.right() - 1);
        let (top, bottom) = (area.top(), area.bottom() - 1);
        let mut put = |x: u16, y: u16, c: char| {
            buffer[(x, y)].set_char(c).set_style(style);
        };
        for y in top..=bottom {
            put(left, y, lines.vertical);
            put(right, y, lines.vertical);
        }
        if !self.open_below && bottom > top {
            for x in left..=right {
                put(x, bottom, lines.horizontal);
            }
            put(left, bottom, lines.bottom_left);
            put(right, bottom, lines.bottom_right);
        }
        for x in left..=right {
            put(x, top, lines.horizontal);
        }
        put(left, top, lines.top_left);
        put(right, top, lines.top_right);
    }

    fn draw_titles(&self, area: Rect, buffer: &mut Buffer, style: Style) {
        // corner, line, blank, title, blank ... blank, right, blank, corner
        let room = area.width.saturating_sub(5);
        let title_width = width(&self.title).min(room);
        if title_width > 0 {
            let x = area.x + 2;
            buffer[(x, area.y)].set_char(' ');
            let title = self.title.clone().patch_style(style);
            let end = buffer.set_line(x + 1, area.y, &title, title_width).0;
            buffer[(end, area.y)].set_char(' ');
        }
        let right_width = width(&self.right);
        let used = 2 + title_width + 2 + 1;
        if right_width > 0 && used + right_width + 3 <= area.width {
            let x = area.right() - 2 - right_width;
            buffer[(x - 1, area.y)].set_char(' ');
            let end = buffer.set_line(x, area.y, &self.right, right_width).0;
            buffer[(end, area.y)].set_char(' ');
        }
    }
}

fn width(line: &Line<'_>) -> u16 {
    u16::try_from(line.width()).unwrap_or(u16::MAX / 2).min(u16::MAX / 2)
}

#[cfg(test)]
mod tests {
    use super::super::ColourDepth;
    use super::*;

    fn lines(pane: &PaneFrame<'_>, width: u16, height: u16) -> Vec<String> {
        let area = Rect::new(0, 0, width, height);
        let mut buffer = Buffer::empty(area);
        pane.render(area, &mut buffer, Theme::PLAIN);
        buffer
            .content
            .chunks(usize::from(width.max(1)))
            .map(|row| row.iter().map(ratatui::buffer::Cell::symbol).collect())
            .collect()
    }

    #[test]
    fn the_title_stands_left_and_the_rest_right() {
        let pane = PaneFrame::new("Runs").right("t [us]");
        assert_eq!(
            lines(&pane, 24, 3),
            ["+- Runs ------- t [us] +", "|                      |", "+----------------------+",]
        );
    }

    #[test]
    fn a_narrow_frame_drops_the_right_part_then_cuts_the_title() {
        let pane = PaneFrame::new("Runs").right("t [us]");
        assert_eq!(lines(&pane, 12, 2), ["+- Runs ---+", "+----------+"]);
        assert_eq!(lines(&pane, 7, 1), ["+- Ru +"]);
        assert_eq!(lines(&pane, 3, 1), ["+-+"]);
    }

    #[test]
    fn the_focused_pane_is_told_apart_at_every_depth() {
        let area = Rect::new(0, 0, 20, 3);
        for depth in
            [ColourDepth::None, ColourDepth::Sixteen, ColourDepth::Ansi256, ColourDepth::Rgb]
        {
            let theme = Theme { depth, ..Theme::PLAIN };
            let title = |focused| {
                let mut buffer = Buffer::empty(area);
                PaneFrame::new("Runs").focused(focused).render(area, &mut buffer, theme);
                buffer[(3, 0)].style()
            };
            assert_ne!(title(true), title(false), "{depth:?}");
        }
    }

    #[test]
    fn the_inside_of_any_size_stays_inside() {
        for width in 0..12 {
            for height in 0..6 {
                let area = Rect::new(3, 2, width, height);
                let mut buffer = Buffer::empty(Rect::new(0, 0, 20, 10));
                let inner = PaneFrame::new("A title").right("right").render(
                    area,
                    &mut buffer,
                    Theme::PLAIN,
                );
                assert_eq!(inner.intersection(area), inner, "{area} {inner}");
            }
        }
    }
}
