//! Text in cells: how wide it is, how it is cut and wrapped.

use crate::tui::theme::{self, Role};
use cmra_studies::report::wrap::wrap;

pub(crate) fn columns(text: &str) -> u16 {
    u16::try_from(theme::columns(text)).unwrap_or(u16::MAX)
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

/// Formats the range of visible rows: `3-12/40`; empty if all are visible.
pub(crate) fn counted(first: usize, shown: usize, count: usize) -> String {
    let last = (first + shown).min(count);
    if count > shown { format!("{}-{last}/{count}", first + 1) } else { String::new() }
}

/// At most `width` characters; what is cut ends in `..`.
pub(crate) fn clip(text: &str, width: usize) -> String {
    if theme::columns(text) <= width {
        return text.to_owned();
    }
    let (kept, _) = text.split_at(fits(text, width.saturating_sub(2)));
    kept.trim_end().to_owned() + ".."
}

/// The first of some texts, each shorter than the one before, that goes into a given number of columns; the last one is cut.
pub(crate) fn fitting(texts: impl IntoIterator<Item = String>, width: usize) -> String {
    let mut shortest = String::new();
    for text in texts {
        if theme::columns(&text) <= width {
            return text;
        }
        shortest = text;
    }
    clip(&shortest, width)
}

/// How many bytes of a text go into a given number of columns.
fn fits(text: &str, width: usize) -> usize {
    let mut taken = 0;
    text.char_indices()
        .find(|(at, letter)| {
            taken += theme::columns(&text[*at..at + letter.len_utf8()]);
            taken > width
        })
        .map_or(text.len(), |(at, _)| at)
}

/// A result's title with shorter words, still distinguished from every other.
pub(crate) fn shortened(title: &str) -> String {
    let words = [
        ("% of rigid-mount depth", "% rigid mount"),
        ("at first stop", "at stop"),
        ("common velocity", "speed"),
        ("plate displacement", "travel"),
    ];
    words.iter().fold(title.to_owned(), |text, (long, word)| text.replace(long, word))
}

/// A result's title in a given number of columns: in shorter words where it is too long.
pub(crate) fn fitted(title: &str, width: usize) -> String {
    if theme::columns(title) <= width { title.to_owned() } else { clip(&shortened(title), width) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_characters_take_two_columns() {
        let wide = "\u{65e5}\u{672c}\u{8a9e}";
        assert_eq!(theme::columns(wide), 6);
        assert_eq!(clip(wide, 6), wide);
        assert_eq!(clip(wide, 5), "\u{65e5}..");
        assert_eq!(wrap(wide, 4), ["\u{65e5}\u{672c}", "\u{8a9e}"]);
        assert_eq!(wrap(&format!("a {wide} b"), 8), [format!("a {wide}"), "b".to_owned()]);
        // Narrower than any of them: nothing is lost, and it ends.
        assert_eq!(wrap(wide, 1).concat(), wide);
        assert_eq!(wrap("one two", 3), ["one", "two"]);
    }
}
