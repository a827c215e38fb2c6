//! Text in cells: width, truncation and wrapping.

use crate::tui::theme::{self, Role};
use cmra_studies::report::wrap::wrap;

pub(crate) fn columns(text: &str) -> u16 {
    u16::try_from(theme::columns(text)).unwrap_or(u16::MAX)
}

/// Line of text with its role.
pub(crate) type TextLine = (String, Role);

/// Wraps lines to this many columns; a line that fits keeps its blanks.
pub(crate) fn broken(lines: Vec<TextLine>, width: usize) -> Vec<TextLine> {
    let parts = |(text, role): TextLine| {
        let fits = theme::columns(&text) <= width;
        let parts = if fits { vec![text] } else { wrap(&text, width) };
        parts.into_iter().map(move |part| (part, role))
    };
    lines.into_iter().flat_map(parts).collect()
}

/// Wraps a text to at most this many columns, in a single role.
pub(crate) fn wrapped(
    text: &str,
    width: u16,
    role: Role,
) -> impl Iterator<Item = TextLine> + use<> {
    wrap(text, usize::from(width)).into_iter().map(move |line| (line, role))
}

/// Returns the first visible row of a list for which the selected row is visible.
pub(crate) fn first_row(selected: usize, height: usize, count: usize) -> usize {
    let most = count.saturating_sub(height);
    selected.saturating_sub(height.saturating_sub(1) * 2 / 3).min(most)
}

/// Formats the range of visible rows: `3-12/40`; empty if all are visible.
pub(crate) fn counted(first: usize, shown: usize, count: usize) -> String {
    let last = (first + shown).min(count);
    if count > shown { format!("{}-{last}/{count}", first + 1) } else { String::new() }
}

/// Truncates to at most `width` characters; a truncated text ends in `..`, at the end of a word if most of it remains.
pub(crate) fn clip(text: &str, width: usize) -> String {
    clip_at(text, width, |end, room| 3 * end >= 2 * room, &[' '])
}

/// Truncates a name to at most `width` characters, at the end of a word if it has several; a truncated name ends in `..`.
pub(crate) fn clip_words(name: &str, width: usize) -> String {
    clip_at(name, width, |end, _| end > 0, &[' ', '-', ',', '/'])
}

/// Truncates a text at the last word end that is acceptable, else within a word.
fn clip_at(
    text: &str,
    width: usize,
    is_acceptable: impl Fn(usize, usize) -> bool,
    ends: &[char],
) -> String {
    if theme::columns(text) <= width {
        return text.to_owned();
    }
    let room = fits(text, width.saturating_sub(2));
    let ends = text.match_indices(ends).map(|(at, _)| at).take_while(|at| *at <= room);
    let end = ends.last().filter(|end| is_acceptable(*end, room)).unwrap_or(room);
    text[..end].trim_end_matches([' ', ',', ';', ':']).to_owned() + ".."
}

/// Returns the first of some texts, in order of decreasing length, that fits into the columns; truncates the last one.
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

/// Returns the number of bytes of a text that fit into the columns.
fn fits(text: &str, width: usize) -> usize {
    let mut taken = 0;
    text.char_indices()
        .find(|(at, letter)| {
            taken += theme::columns(&text[*at..at + letter.len_utf8()]);
            taken > width
        })
        .map_or(text.len(), |(at, _)| at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_ends_at_a_word() {
        let name = "gamma=1.25 k=200 n=0.5";
        for (width, short) in [
            (22, name),
            (21, "gamma=1.25 k=200.."),
            (18, "gamma=1.25 k=200.."),
            (17, "gamma=1.25.."),
            (11, "gamma=1.2.."),
        ] {
            assert_eq!(clip_words(name, width), short, "{width}");
        }
        assert_eq!(clip_words("validation-borvik-cavity", 20), "validation-borvik..");
        // A text keeps most of its letters.
        assert_eq!(clip("h/D, plate face, spring mass", 26), "h/D, plate face, spring..");
        assert_eq!(clip("100 kN/m^n", 8), "100 kN..");
    }

    #[test]
    fn wide_characters_take_two_columns() {
        let wide = "\u{65e5}\u{672c}\u{8a9e}";
        assert_eq!(theme::columns(wide), 6);
        assert_eq!(clip(wide, 6), wide);
        assert_eq!(clip(wide, 5), "\u{65e5}..");
        assert_eq!(wrap(wide, 4), ["\u{65e5}\u{672c}", "\u{8a9e}"]);
        assert_eq!(wrap(&format!("a {wide} b"), 8), [format!("a {wide}"), "b".to_owned()]);
        // Narrower than any character: no text is lost, and the function returns.
        assert_eq!(wrap(wide, 1).concat(), wide);
        assert_eq!(wrap("one two", 3), ["one", "two"]);
    }
}
