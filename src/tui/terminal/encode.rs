//! Encoder of changed cells to few bytes that every terminal understands: short cursor moves, one style sequence per change of style, and
//! short codes for the eight and sixteen colours. The number of bytes limits the speed over SSH.

use std::io::Write;

use ratatui::buffer::{Buffer, Cell};
use ratatui::style::{Color, Modifier};

/// Style of a cell, as sent to the terminal.
#[derive(Clone, Copy, PartialEq)]
struct Style {
    fg: Color,
    bg: Color,
    modifier: Modifier,
}

const PLAIN: Style = Style { fg: Color::Reset, bg: Color::Reset, modifier: Modifier::empty() };

/// Attributes that are visible on a blank.
const ON_BLANKS: Modifier = Modifier::UNDERLINED.union(Modifier::REVERSED);

/// Maximum columns that are written again instead of moving the cursor over them, which takes three bytes or more.
const GAP: u16 = 3;

/// Returns `true` for a cell that looks the same in every style without a background.
fn is_bare(cell: &Cell) -> bool {
    cell.symbol() == " " && cell.bg == Color::Reset && !cell.modifier.intersects(ON_BLANKS)
}

/// Returns `true` if two cells look the same.
fn look_alike(one: &Cell, other: &Cell) -> bool {
    one == other || is_bare(one) && is_bare(other)
}

impl Style {
    fn of(cell: &Cell) -> Self {
        Self { fg: cell.fg, bg: cell.bg, modifier: cell.modifier }
    }

    /// Returns `true` if a cell written in this style looks as it should.
    fn suits(self, cell: &Cell) -> bool {
        let shows_blanks = self.bg == Color::Reset && !self.modifier.intersects(ON_BLANKS);
        self == Self::of(cell) || shows_blanks && is_bare(cell)
    }
}

/// Appends the cells that changed between two buffers of the same size to `out`; resets the style at the end.
pub(super) fn cells(out: &mut Vec<u8>, before: &Buffer, after: &Buffer) {
    let mut style = PLAIN;
    // Cursor position after the last character.
    let mut next: Option<(u16, u16)> = None;
    let changed = before.diff_iter(after);
    for (x, y, cell) in changed.filter(|(x, y, cell)| !look_alike(&before[(*x, *y)], cell)) {
        let between =
            next.filter(|(from, row)| *row == y && (1..=GAP).contains(&x.wrapping_sub(*from)));
        let is_cheap = |x: u16| {
            let cell = &after[(x, y)];
            cell.symbol().len() == 1 && style.suits(cell)
        };
        match between {
            Some((from, _)) if (from..x).all(is_cheap) => {
                out.extend((from..x).flat_map(|x| after[(x, y)].symbol().bytes()));
            }
            _ => go_to(out, next, (x, y)),
        }
        if !style.suits(cell) {
            let wanted = if is_bare(cell) { PLAIN } else { Style::of(cell) };
            set_style(out, style, wanted);
            style = wanted;
        }
        out.extend_from_slice(cell.symbol().as_bytes());
        // Terminals disagree on the width of some characters: set the position explicitly after all others.
        next = is_narrow(cell.symbol()).then(|| (x.saturating_add(1), y));
    }
    if style != PLAIN {
        out.extend_from_slice(b"\x1b[m");
    }
}

/// Returns `true` if a symbol is certain to take one column: a single character of those used by this program.
fn is_narrow(symbol: &str) -> bool {
    let mut characters = symbol.chars();
    let is_known = |c: char| matches!(c, ' '..='~' | '\u{a0}'..='\u{2ff}' | '\u{370}'..='\u{3ff}' | '\u{2500}'..='\u{259f}' | '\u{2800}'..='\u{28ff}');
    characters.next().is_some_and(is_known) && characters.next().is_none()
}

/// Moves the cursor; `from` is `None` if its position is unknown.
fn go_to(out: &mut Vec<u8>, from: Option<(u16, u16)>, to: (u16, u16)) {
    let (x, y) = to;
    match from {
        Some(at) if at == to => {}
        Some((from_x, from_y)) if from_y == y && from_x < x => match x - from_x {
            1 => put(out, format_args!("\x1b[C")),
            n => put(out, format_args!("\x1b[{n}C")),
        },
        Some(_) | None if x == 0 => put(out, format_args!("\x1b[{}H", y.saturating_add(1))),
        Some(_) | None => {
            put(out, format_args!("\x1b[{};{}H", y.saturating_add(1), x.saturating_add(1)));
        }
    }
}

/// Modifiers of the theme, with their codes.
const MODIFIERS: [(Modifier, u8); 4] =
    [(Modifier::BOLD, 1), (Modifier::DIM, 2), (Modifier::UNDERLINED, 4), (Modifier::REVERSED, 7)];

/// Writes one sequence that changes one style into another. Removing an attribute starts from the plain style.
fn set_style(out: &mut Vec<u8>, mut from: Style, to: Style) {
    out.extend_from_slice(b"\x1b[");
    let mut separator = "";
    if to == PLAIN || !to.modifier.contains(from.modifier) {
        // An empty first parameter means plain.
        (from, separator) = (PLAIN, ";");
    }
    let mut push = |code: std::fmt::Arguments<'_>| {
        put(out, format_args!("{separator}{code}"));
        separator = ";";
    };
    for (_, code) in MODIFIERS.iter().filter(|it| (to.modifier - from.modifier).contains(it.0)) {
        push(format_args!("{code}"));
    }
    for (old, new, base) in [(from.fg, to.fg, 30), (from.bg, to.bg, 40)] {
        match new {
            _ if old == new => {}
            Color::Indexed(index @ 0..8) => push(format_args!("{}", base + index)),
            Color::Indexed(index @ 8..16) => push(format_args!("{}", base + 52 + index)),
            Color::Indexed(index) => push(format_args!("{};5;{index}", base + 8)),
            // The theme uses no named colours.
            _ => push(format_args!("{}", base + 9)),
        }
    }
    out.push(b'm');
}

fn put(out: &mut Vec<u8>, text: std::fmt::Arguments<'_>) {
    // Writing to a vector does not fail.
    let _ = out.write_fmt(text);
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use ratatui::layout::Rect;
    use ratatui::style::Style as Wanted;

    use super::*;

    /// Draws the difference of two buffers and parses it with a terminal emulator.
    fn shown(buffers: &[Buffer]) -> (vt100::Parser, usize) {
        let area = buffers[0].area;
        let mut parser = vt100::Parser::new(
            area.height.try_into().expect("not zero"),
            area.width.try_into().expect("not zero"),
            0,
        );
        let mut last = 0;
        let mut previous = Buffer::empty(area);
        for buffer in buffers {
            let mut bytes = Vec::new();
            cells(&mut bytes, &previous, buffer);
            parser.process(&bytes);
            last = bytes.len();
            previous = buffer.clone();
        }
        (parser, last)
    }

    fn ours(colour: Color) -> vt100::Color {
        match colour {
            Color::Indexed(index) => vt100::Color::Idx(index),
            _ => vt100::Color::Default,
        }
    }

    fn any_cell() -> impl Strategy<Value = (String, Wanted)> {
        let colour = prop_oneof![
            3 => Just(Color::Reset),
            3 => (0u8..16).prop_map(Color::Indexed),
            1 => (16u8..).prop_map(Color::Indexed),
        ];
        let modifier = prop_oneof![
            3 => Just(Modifier::empty()),
            1 => Just(Modifier::BOLD),
            1 => Just(Modifier::REVERSED | Modifier::DIM),
            1 => Just(Modifier::BOLD | Modifier::UNDERLINED),
        ];
        ("[ -~⣿─█é]", colour.clone(), colour, modifier).prop_map(|(text, fg, bg, modifier)| {
            (text, Wanted::new().fg(fg).bg(bg).add_modifier(modifier))
        })
    }

    fn any_buffer(width: u16, height: u16) -> impl Strategy<Value = Buffer> {
        let area = Rect::new(0, 0, width, height);
        proptest::collection::vec(any_cell(), area.area() as usize).prop_map(move |wanted| {
            let mut buffer = Buffer::empty(area);
            for (cell, (text, style)) in buffer.content.iter_mut().zip(&wanted) {
                cell.set_symbol(text).set_style(*style);
            }
            buffer
        })
    }

    proptest! {
        #[test]
        fn a_terminal_shows_what_was_drawn(buffers in proptest::collection::vec(any_buffer(9, 4), 1..4)) {
            let (parser, _) = shown(&buffers);
            let last = buffers.last().expect("one at least");
            for y in 0..4 {
                for x in 0..9 {
                    let (seen, drawn) = (parser.screen().cell(y, x).expect("in range"), &last[(x, y)]);
                    let text = if seen.has_contents() { seen.contents() } else { " " };
                    prop_assert_eq!(text, drawn.symbol());
                    prop_assert_eq!(seen.bgcolor(), ours(drawn.bg));
                    prop_assert_eq!(seen.underline(), drawn.modifier.contains(Modifier::UNDERLINED));
                    prop_assert_eq!(seen.inverse(), drawn.modifier.contains(Modifier::REVERSED));
                    // A blank without these has no ink.
                    if text != " " || seen.underline() || seen.inverse() {
                        prop_assert_eq!(seen.fgcolor(), ours(drawn.fg));
                        prop_assert_eq!(seen.bold(), drawn.modifier.contains(Modifier::BOLD));
                        prop_assert_eq!(seen.dim(), drawn.modifier.contains(Modifier::DIM));
                    }
                }
            }
        }
    }

    #[test]
    fn wide_characters_do_not_shift_what_follows() {
        let buffer = Buffer::with_lines(["a漢b", "e\u{301}x "]);
        let (parser, _) = shown(&[buffer]);
        assert_eq!(parser.screen().contents(), "a漢b\ne\u{301}x");
    }

    #[test]
    fn a_style_is_one_sequence_and_plain_text_has_none() {
        let mut buffer = Buffer::with_lines(["xy z"]);
        buffer[(0, 0)].set_style(Wanted::new().fg(Color::Indexed(1)).add_modifier(Modifier::BOLD));
        let mut bytes = Vec::new();
        let before = Buffer::empty(buffer.area);
        cells(&mut bytes, &before, &buffer);
        // SGR by ECMA-48: 1 bold, 31 red, none plain; CUP without a column is column 1.
        assert_eq!(bytes, b"\x1b[1H\x1b[1;31mx\x1b[my z");
    }

    /// CUF moves right; a short gap is written again if its characters are in the present style.
    #[test]
    fn few_unchanged_characters_are_written_again_instead_of_passed_over() {
        let bytes = |before: &str, after: &str| {
            let (before, after) = (Buffer::with_lines([before]), Buffer::with_lines([after]));
            let mut bytes = Vec::new();
            cells(&mut bytes, &before, &after);
            String::from_utf8(bytes).expect("ASCII")
        };
        assert_eq!(bytes("a b c d", "x b y d"), "\x1b[1Hx b y");
        assert_eq!(bytes("a12345b", "x12345y"), "\x1b[1Hx\x1b[5Cy");
        assert_eq!(bytes("a\u{28ff}b", "x\u{28ff}y"), "\x1b[1Hx\x1b[Cy");
    }

    /// The ink of a blank is invisible.
    #[test]
    fn a_blank_takes_the_style_before_it() {
        let mut buffer = Buffer::with_lines(["x y"]);
        let red = Wanted::new().fg(Color::Indexed(1));
        for column in [0, 2] {
            buffer[(column, 0)].set_style(red);
        }
        let mut bytes = Vec::new();
        cells(&mut bytes, &Buffer::with_lines(["aaa"]), &buffer);
        assert_eq!(bytes, b"\x1b[1H\x1b[31mx y\x1b[m");
        let mut dim = buffer.clone();
        dim[(1, 0)].set_style(Wanted::new().add_modifier(Modifier::DIM));
        bytes.clear();
        cells(&mut bytes, &buffer, &dim);
        assert!(bytes.is_empty());
    }

    #[test]
    fn an_unchanged_frame_takes_no_byte() {
        let buffer = Buffer::with_lines(["same", "same"]);
        assert_eq!(shown(&[buffer.clone(), buffer]).1, 0);
    }
}
