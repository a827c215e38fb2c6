//! Single-line input fields: editing, closing and drawing.

use crossterm::event::{Event, KeyCode, KeyEvent, KeyModifiers};
use ratatui::layout::Rect;
use ratatui::text::Span;
use ratatui::widgets::{Paragraph, Widget};
use tui_input::backend::crossterm::to_input_request;
use tui_input::{Input, InputRequest};

use crate::files::clean;
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;

/// Maximum length of a text. Larger input is accidental, such as a paste received as keys, and is truncated.
pub(crate) const TEXT_MAX: usize = 1024;

#[derive(Clone, Debug, Default)]
pub struct TextField {
    pub input: Input,
    /// Whether the whole text is selected and will be replaced by the first character.
    pub all_selected: bool,
    /// Reason why the text is rejected.
    pub error: Option<String>,
}

impl TextField {
    /// Creates a field with a text and the cursor after it.
    pub fn new(text: impl Into<String>) -> Self {
        Self { input: Input::new(text.into()), ..Self::default() }
    }

    pub fn selected(text: impl Into<String>) -> Self {
        Self { all_selected: true, ..Self::new(text) }
    }

    pub fn value(&self) -> &str {
        self.input.value()
    }

    /// Handles a key; returns whether the field uses it.
    pub fn press(&mut self, key: KeyEvent) -> bool {
        // Pasted text may contain control characters or change the reading direction.
        let is_command =
            matches!(key.code, KeyCode::Char(c) if clean::line(&c.to_string()) != c.to_string());
        let request = to_input_request(&Event::Key(key)).filter(|_| !is_command);
        let Some(request) = request else { return false };
        let replaces = matches!(
            request,
            InputRequest::InsertChar(_)
                | InputRequest::DeletePrevChar
                | InputRequest::DeleteNextChar
        );
        if self.all_selected && replaces {
            self.input.reset();
        }
        self.all_selected = false;
        let adds = matches!(request, InputRequest::InsertChar(_));
        if !adds || self.value().chars().count() < TEXT_MAX {
            self.input.handle(request);
        }
        self.error = None;
        true
    }

    /// Inserts a text as if it were typed.
    pub fn insert(&mut self, text: &str) {
        for c in text.chars() {
            self.press(KeyEvent::new(KeyCode::Char(c), KeyModifiers::NONE));
        }
    }

    pub(crate) fn draw(&self, canvas: &mut Canvas<'_>, area: Rect) {
        let role = match (self.error.is_some(), self.all_selected) {
            (true, _) => Role::Error,
            (false, true) => Role::Selection,
            (false, false) => Role::Text,
        };
        let at = self.put(canvas, area, role);
        canvas.cursor = Some((area.x + at, area.y));
    }

    /// Draws the field over its row as `[ 1.25_  ]`, starting at a column, with a given number of characters.
    pub(crate) fn draw_boxed(&self, canvas: &mut Canvas<'_>, row: Rect, start: u16, room: u16) {
        let blank = " ".repeat(usize::from(room));
        canvas.put(row, (start, 0), &blank, Role::Text);
        canvas.put(row, (start - 1, 0), "[", Role::Focus);
        let area = Rect { x: row.x + start, width: room, ..row };
        self.draw(canvas, area.intersection(row));
        canvas.put(row, (start + room, 0), "]", Role::Focus);
        if self.error.is_some() {
            canvas.put(row, (0, 0), "x", Role::Error);
        }
    }

    /// Draws the part of the text around the cursor; returns the column of the cursor.
    pub(crate) fn put(&self, canvas: &mut Canvas<'_>, area: Rect, role: Role) -> u16 {
        let scroll = self.input.visual_scroll(usize::from(area.width.saturating_sub(1)));
        let columns = |count: usize| u16::try_from(count).unwrap_or(u16::MAX);
        let text = Span::styled(self.value(), canvas.theme.style(role));
        let text = Paragraph::new(text).scroll((0, columns(scroll)));
        text.render(area.intersection(canvas.area), canvas);
        columns(self.input.visual_cursor().saturating_sub(scroll)).min(area.width)
    }
}

#[cfg(test)]
mod tests {
    use ratatui::buffer::Buffer;

    use super::*;
    use crate::tui::theme::Theme;

    fn shown(field: &TextField, room: u16) -> (String, u16) {
        let mut buffer = Buffer::empty(Rect::new(0, 0, room, 1));
        let area = buffer.area;
        let mut canvas = Canvas::new(&mut buffer, Theme::PLAIN);
        let at = field.put(&mut canvas, area, Role::Text);
        (crate::tui::chart::buffer_lines(&buffer).concat(), at)
    }

    #[test]
    fn what_would_turn_or_command_a_line_is_not_taken() {
        let mut field = TextField::default();
        field.insert("a\u{202e}b\u{1b}[2Jc\u{2066}d\u{9b}e");
        assert_eq!(field.value(), "ab[2Jcde");
    }

    #[test]
    fn the_end_of_a_long_text_and_the_cursor_are_in_sight() {
        for (text, room, part, cursor) in [
            ("abc", 10, "abc", 3),
            ("abcdefghij", 5, "ghij", 4),
            // Six characters of twelve columns; the cursor is after the last one.
            ("\u{65e5}\u{672c}\u{8a9e}\u{65e5}\u{672c}\u{8a9e}", 5, "\u{672c}\u{8a9e}", 4),
            ("", 5, "", 0),
            ("abc", 0, "", 0),
        ] {
            assert_eq!(shown(&TextField::new(text), room), (part.to_owned(), cursor), "{text}");
        }
        let input = Input::new("abcdefghij".to_owned()).with_cursor(0);
        assert_eq!(shown(&TextField { input, ..TextField::default() }, 5), ("abcde".to_owned(), 0));
    }
}
