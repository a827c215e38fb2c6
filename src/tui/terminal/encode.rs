//! Changed cells to bytes, as few as every terminal understands: short cursor moves, one style sequence per change of style,
//! the eight and sixteen colours by their short codes. Bytes are what an SSH line waits for.

use std::io::Write;

use ratatui::buffer::Cell;
use ratatui::style::{Color, Modifier};

/// The style of a cell, as it is sent to the terminal.
#[derive(Clone, Copy, PartialEq)]
struct Style {
    fg: Color,
    bg: Color,
    modifier: Modifier,
}

const PLAIN: Style = Style { fg: Color::Reset, bg: Color::Reset, modifier: Modifier::empty() };

/// Append the cells to `out`; the style is plain again afterwards. Returns whether there were any.
pub(super) fn cells<'a>(
    out: &mut Vec<u8>,
    content: impl Iterator<Item = (u16, u16, &'a Cell)>,
) -> bool {
    let mut style = PLAIN;
    // Where the next character would land, were nothing done about it.
    let mut next: Option<(u16, u16)> = None;
    let mut any = false;
    for (x, y, cell) in content {
        any = true;
        go_to(out, next, (x, y));
        let wanted = Style { fg: cell.fg, bg: cell.bg, modifier: cell.modifier };
        if wanted != style {
            set_style(out, style, wanted);
            style = wanted;
        }
        out.extend_from_slice(cell.symbol().as_bytes());
        // Terminals disagree about the width of some characters: after any but the plain ones, say where to go on.
        next = is_narrow(cell.symbol()).then(|| (x.saturating_add(1), y));
    }
    if style != PLAIN {
        out.extend_from_slice(b"\x1b[m");
    }
    any
}

/// Whether a symbol surely takes one column: one character of those this program draws with.
fn is_narrow(symbol: &str) -> bool {
    let mut characters = symbol.chars();
    let one = characters
        .next()
        .is_some_and(|c| matches!(c, ' '..='~' | '\u{a0}'..='\u{2ff}' | '\u{370}'..='\u{3ff}' | '\u{2500}'..='\u{259f}' | '\u{2800}'..='\u{28ff}'));
    one && characters.next().is_none()
}

/// Move the cursor; `from` is `None` where its place is not known.
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

/// One sequence from one style to another. Going back to less means starting over from plain.
fn set_style(out: &mut Vec<u8>, from: Style, to: Style) {
    if to == PLAIN {
        out.extend_from_slice(b"\x1b[m");
        return;
    }
    let mut codes = Codes { out, first: true };
    let lost = !(from.modifier - to.modifier).is_empty();
    let from = if lost { PLAIN } else { from };
    if lost {
        codes.push(format_args!("0"));
    }
    for (modifier, code) in [
        (Modifier::BOLD, 1),
        (Modifier::DIM, 2),
        (Modifier::ITALIC, 3),
        (Modifier::UNDERLINED, 4),
        (Modifier::SLOW_BLINK, 5),
        (Modifier::RAPID_BLINK, 6),
        (Modifier::REVERSED, 7),
        (Modifier::HIDDEN, 8),
        (Modifier::CROSSED_OUT, 9),
    ] {
        if (to.modifier - from.modifier).contains(modifier) {
            codes.push(format_args!("{code}"));
        }
    }
    if to.fg != from.fg {
        codes.colour(to.fg, 30);
    }
    if to.bg != from.bg {
        codes.colour(to.bg, 40);
    }
    codes.out.push(b'm');
}

/// The numbers of one style sequence.
struct Codes<'a> {
    out: &'a mut Vec<u8>,
    first: bool,
}

impl Codes<'_> {
    fn push(&mut self, code: std::fmt::Arguments<'_>) {
        self.out.extend_from_slice(if self.first { b"\x1b[" } else { b";" });
        self.first = false;
        put(self.out, code);
    }

    /// A colour; `base` is 30 for the foreground, 40 for the background.
    fn colour(&mut self, colour: Color, base: u8) {
        let code = match colour {
            Color::Reset => base + 9,
            Color::Black => base,
            Color::Red => base + 1,
            Color::Green => base + 2,
            Color::Yellow => base + 3,
            Color::Blue => base + 4,
            Color::Magenta => base + 5,
            Color::Cyan => base + 6,
            Color::Gray => base + 7,
            Color::DarkGray => base + 60,
            Color::LightRed => base + 61,
            Color::LightGreen => base + 62,
            Color::LightYellow => base + 63,
            Color::LightBlue => base + 64,
            Color::LightMagenta => base + 65,
            Color::LightCyan => base + 66,
            Color::White => base + 67,
            Color::Indexed(index) => {
                return self.push(format_args!("{};5;{index}", base + 8));
            }
            Color::Rgb(r, g, b) => {
                return self.push(format_args!("{};2;{r};{g};{b}", base + 8));
            }
        };
        self.push(format_args!("{code}"));
    }
}

fn put(out: &mut Vec<u8>, text: std::fmt::Arguments<'_>) {
    // Writing to a vector does not fail.
    let _ = out.write_fmt(text);
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use ratatui::buffer::Buffer;
    use ratatui::layout::Rect;
    use ratatui::style::Style as Wanted;

    use super::*;

    /// Draw the difference of two buffers and let a terminal emulator read it.
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
            cells(&mut bytes, previous.diff(buffer).into_iter());
            parser.process(&bytes);
            last = bytes.len();
            previous = buffer.clone();
        }
        (parser, last)
    }

    fn ours(colour: Color) -> vt100::Color {
        match colour {
            Color::Rgb(r, g, b) => vt100::Color::Rgb(r, g, b),
            Color::Indexed(index) => vt100::Color::Idx(index),
            Color::Red => vt100::Color::Idx(1),
            Color::DarkGray => vt100::Color::Idx(8),
            Color::White => vt100::Color::Idx(15),
            other => {
                assert_eq!(other, Color::Reset, "a colour this test uses");
                vt100::Color::Default
            }
        }
    }

    fn any_cell() -> impl Strategy<Value = (String, Wanted)> {
        let colour = prop_oneof![
            3 => Just(Color::Reset),
            1 => Just(Color::Red),
            1 => Just(Color::DarkGray),
            1 => Just(Color::White),
            1 => (16u8..).prop_map(Color::Indexed),
            1 => Just(Color::Rgb(1, 2, 3)),
        ];
        let modifier = prop_oneof![
            3 => Just(Modifier::empty()),
            1 => Just(Modifier::BOLD),
            1 => Just(Modifier::REVERSED | Modifier::UNDERLINED),
            1 => Just(Modifier::BOLD | Modifier::ITALIC),
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
                    prop_assert_eq!(seen.fgcolor(), ours(drawn.fg));
                    prop_assert_eq!(seen.bgcolor(), ours(drawn.bg));
                    prop_assert_eq!(seen.bold(), drawn.modifier.contains(Modifier::BOLD));
                    prop_assert_eq!(seen.italic(), drawn.modifier.contains(Modifier::ITALIC));
                    prop_assert_eq!(seen.underline(), drawn.modifier.contains(Modifier::UNDERLINED));
                    prop_assert_eq!(seen.inverse(), drawn.modifier.contains(Modifier::REVERSED));
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
        buffer[(0, 0)].set_style(Wanted::new().fg(Color::Red).add_modifier(Modifier::BOLD));
        let mut bytes = Vec::new();
        let before = Buffer::empty(buffer.area);
        assert!(cells(&mut bytes, before.diff(&buffer).into_iter()));
        // SGR by ECMA-48: 1 bold, 31 red, none plain; CUF moves on; CUP without a column is column 1.
        assert_eq!(bytes, b"\x1b[1H\x1b[1;31mx\x1b[my\x1b[Cz");
    }

    #[test]
    fn an_unchanged_frame_takes_no_byte() {
        let buffer = Buffer::with_lines(["same", "same"]);
        assert_eq!(shown(&[buffer.clone(), buffer]).1, 0);
    }
}
