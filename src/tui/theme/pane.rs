//! Frame of a pane: title at the left of the top line, a short text at the right.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::symbols::border;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Borders, Widget};

use super::{Role, Theme, columns};
use cmra_studies::report::chart::{Below, Frame};

#[must_use]
#[derive(Clone, Debug, Default)]
pub struct PaneFrame<'a> {
    title: String,
    right: Line<'a>,
    focused: bool,
    frame: Frame,
}

impl<'a> PaneFrame<'a> {
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), ..Self::default() }
    }

    /// Sets the text at the right of the top line; uses the lower line of a separate frame if there is no room.
    pub fn right(self, right: impl Into<Line<'a>>) -> Self {
        Self { right: right.into(), ..self }
    }

    pub fn focused(self, focused: bool) -> Self {
        Self { focused, ..self }
    }

    /// Sets the frame of a pane that shares a box with others.
    pub fn frame(self, frame: Frame) -> Self {
        Self { frame, ..self }
    }

    fn block(&self) -> Block<'_> {
        let is_open = matches!(self.frame, Frame::Stacked { below: Below::Nothing, .. });
        let without = if is_open { Borders::BOTTOM } else { Borders::NONE };
        Block::new().borders(Borders::ALL.difference(without))
    }

    pub fn inner(&self, area: Rect) -> Rect {
        self.block().inner(area)
    }

    pub fn render(&self, area: Rect, buffer: &mut Buffer, theme: Theme) -> Rect {
        let area = area.intersection(buffer.area);
        let border = theme.style(if self.focused { Role::Focus } else { Role::Border });
        let mut set = border::PLAIN;
        if let Frame::Stacked { begins, below } = self.frame {
            if !begins {
                (set.top_left, set.top_right) = ("├", "┤");
            }
            if below == Below::Across {
                (set.bottom_left, set.bottom_right) = ("├", "┤");
            }
        }
        // corner, line, blank, title, blank ... blank, right, blank, corner
        let mut block = self.block().border_set(set).border_style(border);
        let title = columns(&self.title);
        if title > 0 {
            let line = Span::styled(set.horizontal_top, border);
            let text = Span::styled(&*self.title, theme.title(self.focused));
            block = block.title_top(Line::from(vec![line, " ".into(), text, " ".into()]));
        }
        let mut right = Line::from(" ");
        right.extend(self.right.spans.iter().cloned().chain([" ".into()]));
        let room = usize::from(area.width).saturating_sub(6);
        if right.width() > 2 && title + right.width() <= room {
            block = block.title_top(right.right_aligned());
        } else if right.width() > 2 && self.frame == Frame::Boxed && right.width() <= room {
            block = block.title_bottom(right.right_aligned());
        }
        let inner = block.inner(area);
        block.render(area, buffer);
        inner
    }
}

#[cfg(test)]
mod tests {
    use super::super::{ColourDepth, ascii_pass};
    use super::*;
    use crate::tui::chart::buffer_lines;

    fn lines(pane: &PaneFrame<'_>, width: u16, height: u16) -> Vec<String> {
        let area = Rect::new(0, 0, width, height);
        let mut buffer = Buffer::empty(area);
        pane.render(area, &mut buffer, Theme::PLAIN);
        ascii_pass(&mut buffer);
        buffer_lines(&buffer)
    }

    #[test]
    fn a_narrow_frame_drops_the_right_part_then_cuts_the_title() {
        let pane = PaneFrame::new("Runs").right("t [us]");
        assert_eq!(lines(&pane, 12, 2), ["+- Runs ---+", "+----------+"]);
        assert_eq!(lines(&pane, 7, 1), ["+- Run+"]);
        assert_eq!(lines(&pane, 3, 1), ["+-+"]);
    }

    #[test]
    fn the_focused_pane_is_distinguished_at_every_colour_depth() {
        let area = Rect::new(0, 0, 20, 3);
        for depth in ColourDepth::ALL {
            let theme = Theme { depth, ..Theme::PLAIN };
            let title = |focused| {
                let mut buffer = Buffer::empty(area);
                PaneFrame::new("Runs").focused(focused).render(area, &mut buffer, theme);
                buffer[(3, 0)].style()
            };
            assert_ne!(title(true), title(false), "{depth:?}");
        }
    }
}
