//! Theme of the screen: characters ([`GlyphSet`]), colours ([`ColourDepth`]), and styles by role ([`Role`]).
//!
//! Panes use roles, never colours. Normal text has the terminal's own foreground and background, so that light and dark themes work. The
//! module does not depend on the content. Colour is never the only indication: a role with a meaning also has a character.

use ratatui::style::{Color, Modifier, Style};
use ratatui::text::Span;

pub mod colours;
pub mod glyphs;
pub mod pane;

pub use colours::ColourDepth;
pub use glyphs::{GlyphSet, ascii_pass};
pub use pane::PaneFrame;

/// Returns the width of a text in columns: two for a wide character, none for a combining mark.
pub fn columns(text: &str) -> usize {
    if text.is_ascii() { text.len() } else { Span::raw(text).width() }
}

/// Role of a part of the screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Role {
    #[default]
    Text,
    /// Less important text: units, old results, inactive values.
    Dim,
    /// Titles of panes and tabs.
    Title,
    /// Border and title of the focused pane.
    Focus,
    /// Selected row, tab or field: reverse video.
    Selection,
    /// Error.
    Error,
    /// Warning.
    Warning,
    /// Information.
    Note,
    /// Curve: 0 is the current run, 1 the first pinned run, and so on.
    Curve(usize),
    /// Vertical lines at events, and reference lines.
    Event,
    Crosshair,
    Border,
    Key,
}

/// Glyphs and colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Theme {
    pub glyphs: GlyphSet,
    pub depth: ColourDepth,
}

impl Theme {
    /// Pure ASCII without colour, as printed by `--plain`.
    pub const PLAIN: Self = Self { glyphs: GlyphSet::Ascii, depth: ColourDepth::None };

    /// Detects the theme from the environment; `env` looks up a variable.
    pub fn detect(env: impl Fn(&str) -> Option<String>) -> Self {
        Self { glyphs: GlyphSet::detect(&env), depth: ColourDepth::detect(&env) }
    }

    pub fn style(self, role: Role) -> Style {
        let plain = Style::new();
        let bold = plain.add_modifier(Modifier::BOLD);
        match role {
            Role::Text => plain,
            Role::Title | Role::Key | Role::Crosshair => bold,
            Role::Selection => plain.add_modifier(Modifier::REVERSED),
            // `NO_COLOR` leaves bold, reverse and underline, which every terminal can show.
            Role::Dim | Role::Border | Role::Event if self.is_plain() => plain,
            Role::Dim | Role::Border | Role::Event => plain.add_modifier(Modifier::DIM),
            Role::Focus => coloured(bold, colours::FOCUS.at(self.depth)),
            Role::Error if self.is_plain() => bold.add_modifier(Modifier::REVERSED),
            Role::Error => coloured(bold, colours::ERROR.at(self.depth)),
            Role::Warning if self.is_plain() => bold,
            Role::Warning => coloured(plain, colours::WARNING.at(self.depth)),
            Role::Note if self.is_plain() => plain.add_modifier(Modifier::UNDERLINED),
            Role::Note => coloured(plain, colours::NOTE.at(self.depth)),
            Role::Curve(0) => coloured(bold, colours::curve(0, self.depth)),
            Role::Curve(index) => coloured(plain, colours::curve(index, self.depth)),
        }
    }

    /// Returns the style of a pane's title. Without colour the focused title is reversed, because a bold border is easily missed.
    pub fn title(self, focused: bool) -> Style {
        let style = self.style(if focused { Role::Focus } else { Role::Title });
        if focused && self.is_plain() { style.add_modifier(Modifier::REVERSED) } else { style }
    }

    /// Returns the colour of a heat map's shade, 0 the smallest of ten, and a readable text colour; `None` for fewer than 256 colours.
    pub fn heat(self, shade: usize) -> Option<(Color, Color)> {
        (self.depth == ColourDepth::Ansi256).then(|| colours::heat(shade))
    }

    fn is_plain(self) -> bool {
        self.depth == ColourDepth::None
    }
}

fn coloured(style: Style, colour: Option<Color>) -> Style {
    Style { fg: colour, ..style }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROLES: [Role; 14] = [
        Role::Text,
        Role::Dim,
        Role::Title,
        Role::Focus,
        Role::Selection,
        Role::Error,
        Role::Warning,
        Role::Note,
        Role::Curve(0),
        Role::Curve(1),
        Role::Event,
        Role::Crosshair,
        Role::Border,
        Role::Key,
    ];

    /// The first locale variable that is set determines the characters. `TERM` determines the colours, at most those common to all
    /// terminals of that name.
    #[test]
    fn the_environment_says_what_a_terminal_shows() {
        use {ColourDepth as D, GlyphSet as G};
        const UTF: (&str, &str) = ("LANG", "en_GB.UTF-8");
        const TRUE: (&str, &str) = ("COLORTERM", "truecolor");
        for (pairs, glyphs, depth) in [
            (&[][..], G::Ascii, D::None),
            (&[("LANG", "C")], G::Ascii, D::None),
            (&[("LANG", "de_DE.utf8")], G::Braille, D::None),
            (&[("LC_ALL", "C"), UTF, ("TERM", "xterm-256color")], G::Ascii, D::Ansi256),
            (&[("LC_ALL", ""), UTF, ("TERM", "xterm-256color"), TRUE], G::Braille, D::Ansi256),
            (&[("LC_CTYPE", "C.UTF-8"), ("LANG", "C"), ("TERM", "xterm")], G::Braille, D::Ansi256),
            (&[("LC_ALL", "C.UTF-8"), ("LC_CTYPE", "C")], G::Braille, D::None),
            (&[UTF, ("TERM", "vte-256color")], G::Braille, D::Ansi256),
            (&[UTF, ("TERM", "xterm-16color")], G::Braille, D::Sixteen),
            (&[UTF, ("TERM", "linux"), TRUE], G::Block, D::Sixteen),
            (&[("LANG", "C"), ("TERM", "linux")], G::Ascii, D::Sixteen),
            (&[UTF, ("TERM", "vt220")], G::Ascii, D::Sixteen),
            (&[UTF, ("TERM", "dumb"), TRUE], G::Ascii, D::None),
            (&[("TERM", "xterm-mono")], G::Ascii, D::None),
            (&[("TERM", "linux-m")], G::Ascii, D::None),
            (&[("TERM", "xterm"), ("NO_COLOR", "1")], G::Ascii, D::None),
            (&[("TERM", "xterm"), ("NO_COLOR", "")], G::Ascii, D::Ansi256),
        ] {
            let value = |name: &str| pairs.iter().find(|it| it.0 == name).map(|it| it.1.to_owned());
            assert_eq!(Theme::detect(value), Theme { glyphs, depth }, "{pairs:?}");
        }
    }

    #[test]
    fn without_colour_only_bold_reverse_and_underline_are_used() {
        let allowed = Modifier::BOLD | Modifier::REVERSED | Modifier::UNDERLINED;
        for role in ROLES {
            let style = Theme::PLAIN.style(role);
            assert_eq!((style.fg, style.bg), (None, None), "{role:?}");
            assert!(allowed.contains(style.add_modifier), "{role:?}");
        }
    }

    #[test]
    fn errors_warnings_and_notes_differ_at_every_depth() {
        for depth in ColourDepth::ALL {
            let theme = Theme { glyphs: GlyphSet::Ascii, depth };
            let [error, warning, note, text] =
                [Role::Error, Role::Warning, Role::Note, Role::Text].map(|role| theme.style(role));
            assert_ne!(error, warning);
            assert_ne!(warning, note);
            assert_ne!(note, error);
            assert!(![error, warning, note].contains(&text));
        }
    }
}
