//! Character sets of the terminal, and replacement by ASCII.
//!
//! Frames use code page 437, because the fonts of the Linux console have it. Curves use braille if the terminal has it. In ASCII mode the
//! last step of a frame replaces all other characters.

use std::fmt;

use cmra_studies::enumeration;
use ratatui::buffer::Buffer;

enumeration! {
    #[derive(Default, Hash)]
    pub enum GlyphSet in GlyphRow {
        /// Keyword on the command line and in files.
        word: &'static str,
        /// Dots per cell, horizontally and vertically.
        dots: (u16, u16),
    }
    /// `+ - |` and letters: one dot per cell, works everywhere.
    #[default]
    Ascii { word: "ascii", dots: (1, 1) }
    /// Lines and half blocks: two dots per cell, one above the other.
    Block { word: "block", dots: (1, 2) }
    /// Lines and braille: two by four dots per cell.
    Braille { word: "braille", dots: (2, 4) }
}

impl GlyphSet {
    /// Returns the character set with this keyword; `None` for `auto`, which detects it.
    pub fn named(word: &str) -> Result<Option<Self>, String> {
        if word.eq_ignore_ascii_case("auto") {
            return Ok(None);
        }
        let named = Self::ALL.into_iter().find(|set| word.eq_ignore_ascii_case(set.word()));
        let unknown =
            || format!("glyphs '{word}' are not known: choose ascii, block, braille or auto");
        named.map(Some).ok_or_else(unknown)
    }

    /// Detects the character set. The first of `LC_ALL`, `LC_CTYPE`, `LANG` that is set decides; the Linux console has no braille.
    pub fn detect(env: impl Fn(&str) -> Option<String>) -> Self {
        let value = |name| env(name).filter(|text| !text.is_empty());
        let locale = ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().find_map(value);
        let utf8 =
            locale.is_some_and(|text| text.to_ascii_uppercase().replace('-', "").contains("UTF8"));
        let term = value("TERM").unwrap_or_default();
        if !utf8 || term == "dumb" || is_vt(&term) {
            Self::Ascii
        } else if term == "linux" {
            Self::Block
        } else {
            Self::Braille
        }
    }

    /// Returns the next set in the cycle ASCII, block, braille.
    #[must_use]
    pub fn next(self) -> Self {
        Self::ALL[(self as usize + 1) % Self::ALL.len()]
    }
}

/// Returns `true` for a terminal of DEC such as vt100 and vt220; vte is GNOME's.
pub(super) fn is_vt(term: &str) -> bool {
    term.strip_prefix("vt").is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
}

impl fmt::Display for GlyphSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

/// Replaces every non-ASCII character, cell by cell; the last step of a frame in ASCII mode.
pub fn ascii_pass(buffer: &mut Buffer) {
    for cell in &mut buffer.content {
        if !cell.symbol().is_ascii() {
            let replacement = cell.symbol().chars().next().map_or(' ', ascii);
            cell.set_char(replacement);
        }
    }
}

/// Returns the nearest ASCII character of the same width in cells; `?` if there is none.
fn ascii(character: char) -> char {
    match character {
        '\u{a0}' => ' ',
        '─' | '–' | '—' | '−' => '-',
        '│' => '|',
        '\u{250c}'..='\u{254b}' => '+',
        '·' | '…' => '.',
        '“' | '”' => '"',
        '‘' | '’' => '\'',
        'µ' | 'μ' => 'u',
        '×' => 'x',
        '²' => '2',
        '³' => '3',
        '°' => 'o',
        _ if character.is_ascii() => character,
        _ => '?',
    }
}

#[cfg(test)]
mod tests {
    use ratatui::layout::Rect;
    use ratatui::style::Style;

    use super::*;

    #[test]
    fn choices_are_read_and_an_unknown_one_names_the_cure() {
        assert_eq!(GlyphSet::named("auto"), Ok(None));
        for set in GlyphSet::ALL {
            assert_eq!(GlyphSet::named(set.word()), Ok(Some(set)));
        }
        let error = GlyphSet::named("dots").unwrap_err();
        assert_eq!(error, "glyphs 'dots' are not known: choose ascii, block, braille or auto");
    }

    #[test]
    fn the_ascii_pass_writes_ascii_only_and_keeps_columns() {
        let area = Rect::new(0, 0, 20, 1);
        let mut buffer = Buffer::empty(area);
        buffer.set_string(0, 0, "┌─ 5 µs · ·… –²×│日", Style::new());
        ascii_pass(&mut buffer);
        let text: String = buffer.content.iter().map(ratatui::buffer::Cell::symbol).collect();
        assert_eq!(text, "+- 5 us . .. -2x|?  ");
    }
}
