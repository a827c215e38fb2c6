//! Small helpers for writing text into cells.

use ratatui::buffer::Buffer;
use ratatui::style::Style;
use tui_input::Input;

use crate::tui::app::status::wrap;
use crate::tui::prelude::*;
use crate::tui::theme;

/// The text of a tab that studies one plate while the scene is a stack.
pub(crate) const NEEDS_SINGLE: &str = "this tab needs a single plate";

pub(crate) fn text_role(severity: Severity) -> Role {
    match severity {
        Severity::Note => Role::Text,
        Severity::Warning => Role::Warning,
        Severity::Error => Role::Error,
    }
}

pub(crate) fn columns(text: &str) -> u16 {
    u16::try_from(theme::columns(text)).unwrap_or(u16::MAX)
}

/// The part of a field's text that is shown in a given number of columns, and the column of the cursor in it. Wide characters take two.
pub(crate) fn window(input: &Input, room: u16) -> (String, u16) {
    let room = usize::from(room);
    let scroll = input.visual_scroll(room.saturating_sub(1));
    let mut skipped = 0;
    let mut shown = String::new();
    let mut taken = 0;
    for letter in input.value().chars() {
        let width = theme::columns(letter.encode_utf8(&mut [0; 4]));
        if skipped < scroll {
            skipped += width;
            continue;
        }
        taken += width;
        if taken > room {
            break;
        }
        shown.push(letter);
    }
    let cursor = input.visual_cursor().saturating_sub(skipped).min(room);
    (shown, u16::try_from(cursor).unwrap_or(0))
}

/// Write a text into a row of an area; gives the column after it. Rows and columns outside the area are left alone.
pub(crate) fn put(
    buffer: &mut Buffer,
    area: Rect,
    at: (u16, u16),
    text: &str,
    style: Style,
) -> u16 {
    let (column, row) = at;
    let area = area.intersection(buffer.area);
    if row >= area.height || column >= area.width {
        return column;
    }
    let room = usize::from(area.width - column);
    let end = buffer.set_stringn(area.x + column, area.y + row, text, room, style).0;
    end - area.x
}

/// A line of text, and how it is drawn.
pub(crate) type TextLine = (String, Role);

/// Lines over as many rows of this many columns as each needs; a line that fits keeps its blanks.
pub(crate) fn broken(lines: Vec<TextLine>, width: usize) -> Vec<TextLine> {
    let parts = |(text, role): TextLine| {
        let fits = theme::columns(&text) <= width;
        let parts = if fits { vec![text] } else { wrap(&text, width) };
        parts.into_iter().map(move |part| (part, role))
    };
    lines.into_iter().flat_map(parts).collect()
}

/// The lines of a text of at most this many columns, all in one role.
pub(crate) fn wrapped(
    text: &str,
    width: u16,
    role: Role,
) -> impl Iterator<Item = TextLine> + use<> {
    wrap(text, usize::from(width)).into_iter().map(move |line| (line, role))
}

/// The first row of a list to show so that the selected one is in sight.
pub(crate) fn first_row(selected: usize, height: usize, count: usize) -> usize {
    let most = count.saturating_sub(height);
    selected.saturating_sub(height.saturating_sub(1) * 2 / 3).min(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_end_of_a_long_text_and_the_cursor_are_in_sight() {
        for (text, room, shown, cursor) in [
            ("abc", 10, "abc", 3),
            ("abcdefghij", 5, "ghij", 4),
            // Twelve columns in six characters: the cursor is behind the last one.
            ("\u{65e5}\u{672c}\u{8a9e}\u{65e5}\u{672c}\u{8a9e}", 5, "\u{672c}\u{8a9e}", 4),
            ("", 5, "", 0),
            ("abc", 0, "", 0),
        ] {
            let (part, at) = window(&Input::new(text.to_owned()), room);
            assert_eq!((part.as_str(), at), (shown, cursor), "{text}");
            assert!(columns(&part) <= room && at <= room);
        }
        let input = Input::new("abcdefghij".to_owned()).with_cursor(0);
        assert_eq!(window(&input, 5), ("abcde".to_owned(), 0));
    }
}
