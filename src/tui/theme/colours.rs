//! Colour depth of the terminal, and the colour of each role at each depth.
//!
//! Every fixed shade is readable on white and on black (contrast at least 3 : 1 on both, WCAG 2.1 criterion 1.4.11; tested). Curves can be
//! distinguished without red or green cones (tested with the matrices of Machado, Oliveira and Fernandes, 2009). With sixteen colours the
//! terminal's palette decides; the chosen colours are readable on both backgrounds in xterm's palette.

use cmra_studies::enumeration;
use ratatui::style::Color;

use super::glyphs::is_vt;

enumeration! {
    #[derive(Default, Hash)]
    pub enum ColourDepth in DepthRow {
        word: &'static str,
    }
    /// No colours: `NO_COLOR`, or a terminal without colours.
    #[default]
    None { word: "none" }
    Sixteen { word: "sixteen" }
    Ansi256 { word: "256" }
}

impl ColourDepth {
    /// Detects the depth that the environment guarantees.
    pub fn detect(env: impl Fn(&str) -> Option<String>) -> Self {
        let value = |name| env(name).filter(|text| !text.is_empty());
        let Some(term) = value("TERM") else {
            return Self::None;
        };
        let mono = term.ends_with("-m") || term.ends_with("-mono");
        if value("NO_COLOR").is_some() || term == "dumb" || mono {
            return Self::None;
        }
        let has_few = is_vt(&term)
            || ["linux", "ansi", "cons25"].iter().any(|name| term.starts_with(name))
            || ["-16color", "-color"].iter().any(|ending| term.ends_with(ending));
        if has_few { Self::Sixteen } else { Self::Ansi256 }
    }

    /// Returns the next depth in the cycle 256, sixteen, none.
    #[must_use]
    pub fn next(self) -> Self {
        Self::ALL[(self as usize + Self::ALL.len() - 1) % Self::ALL.len()]
    }

    /// Returns the depth with this keyword.
    pub fn named(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|it| it.word() == word)
    }
}

/// Colour index in the terminal's palette of 16, and in xterm's palette of 256.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shade(u8, u8);

impl Shade {
    /// Returns the colour at a depth; `None` without colours.
    pub(super) fn at(self, depth: ColourDepth) -> Option<Color> {
        match depth {
            ColourDepth::None => None,
            ColourDepth::Sixteen => Some(Color::Indexed(self.0)),
            ColourDepth::Ansi256 => Some(Color::Indexed(self.1)),
        }
    }
}

/// Border and title of the focused pane.
pub(super) const FOCUS: Shade = Shade(12, 32);
pub(super) const ERROR: Shade = Shade(1, 160);
pub(super) const WARNING: Shade = Shade(5, 130);
pub(super) const NOTE: Shade = Shade(12, 31);

/// Blue, orange, violet, tan, lilac, grey: the only six colours of xterm's palette that are readable on white and on black and far enough
/// from each other for every kind of colour vision.
const CURVES: [Shade; 6] =
    [Shade(12, 31), Shade(9, 202), Shade(13, 93), Shade(8, 137), Shade(5, 105), Shade(1, 59)];

/// Returns the colour of a curve at a depth; `None` without colours. Colours repeat after six curves, markers later.
pub(super) fn curve(index: usize, depth: ColourDepth) -> Option<Color> {
    CURVES[index % CURVES.len()].at(depth)
}

/// Ten shades of xterm's palette from dark blue over grey to light yellow, after cividis (Nunez, Anderton and Renslow 2018). Lightness
/// increases with every shade, so that the order is visible without hue.
const HEAT: [u8; 10] = [17, 18, 24, 60, 66, 102, 108, 144, 186, 229];
/// First shade that needs dark text.
const LIGHT_FROM: usize = 4;

/// Returns the colour of a heat map's shade, and a readable text colour.
pub(super) fn heat(shade: usize) -> (Color, Color) {
    let shade = shade.min(HEAT.len() - 1);
    let ink = if shade < LIGHT_FROM { WHITE } else { BLACK };
    (Color::Indexed(HEAT[shade]), ink)
}

const BLACK: Color = Color::Indexed(16);
const WHITE: Color = Color::Indexed(231);

/// Returns a readable text colour on a shade.
pub(crate) fn ink_on(colour: Color) -> Color {
    let shade = (0..HEAT.len()).find(|shade| heat(*shade).0 == colour);
    shade.map_or(WHITE, |shade| heat(shade).1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance, WCAG 2.1.
    fn luminance(rgb: (u8, u8, u8)) -> f64 {
        let [r, g, b] = linear(rgb);
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    fn linear((r, g, b): (u8, u8, u8)) -> [f64; 3] {
        [r, g, b].map(|byte| {
            let c = f64::from(byte) / 255.0;
            if c <= 0.03928 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        })
    }

    /// Multiplies a matrix by linear red, green, blue.
    fn seen(matrix: [[f64; 3]; 3], rgb: [f64; 3]) -> [f64; 3] {
        matrix.map(|row| row.iter().zip(rgb).map(|(a, b)| a * b).sum())
    }

    /// Converts linear sRGB, white D65, to CIE L*a*b*.
    fn lab(rgb: [f64; 3]) -> [f64; 3] {
        let to_xyz = [[0.4125, 0.3576, 0.1804], [0.2127, 0.7152, 0.0722], [0.0193, 0.1192, 0.9503]];
        let [x, y, z] = seen(to_xyz, rgb.map(|c| c.clamp(0.0, 1.0)));
        let f = |t: f64| if t > 0.008_856 { t.cbrt() } else { (903.3 * t + 16.0) / 116.0 };
        let (x, y, z) = (f(x / 0.9505), f(y), f(z / 1.0888));
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// Without red, green or blue cones: Machado, Oliveira and Fernandes, 2009, severity 1. The distance of curves in L*a*b* is at least
    /// 30, or 15 without blue cones; 2.3 is just noticeable.
    #[test]
    fn curves_are_told_apart_by_every_kind_of_sight() {
        let kinds = [
            ("all", 30.0, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
            (
                "no red",
                30.0,
                [[0.1523, 1.0526, -0.2049], [0.1145, 0.7863, 0.0992], [-0.0039, -0.0481, 1.0520]],
            ),
            (
                "no green",
                30.0,
                [[0.3673, 0.8606, -0.2280], [0.2801, 0.6725, 0.0474], [-0.0118, 0.0429, 0.9689]],
            ),
            (
                "no blue",
                15.0,
                [[1.2555, -0.0767, -0.1788], [-0.0784, 0.9309, 0.1476], [0.0047, 0.6914, 0.3039]],
            ),
        ];
        for (kind, least, matrix) in kinds {
            for (at, one) in CURVES.iter().enumerate() {
                for other in &CURVES[at + 1..] {
                    let [a, b] =
                        [one, other].map(|shade| lab(seen(matrix, linear(xterm(shade.1)))));
                    let apart = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
                    assert!(apart.sqrt() >= least, "{kind}: {one:?}, {other:?}: {apart}");
                }
            }
        }
    }

    /// RGB values of the used colours among the first 16 of xterm's palette.
    const FIRST: [(u8, (u8, u8, u8)); 6] = [
        (1, (205, 0, 0)),
        (5, (205, 0, 205)),
        (8, (127, 127, 127)),
        (9, (255, 0, 0)),
        (12, (92, 92, 255)),
        (13, (255, 0, 255)),
    ];

    /// Returns a colour of xterm's palette: a 6x6x6 cube from 16, then 24 greys from 232.
    fn xterm(index: u8) -> (u8, u8, u8) {
        let level = |step: u8| if step == 0 { 0 } else { 55 + 40 * step };
        if index >= 232 {
            let grey = 8 + 10 * (index - 232);
            return (grey, grey, grey);
        }
        let cube = index - 16;
        (level(cube / 36), level(cube / 6 % 6), level(cube % 6))
    }

    #[test]
    fn fixed_shades_are_readable_on_white_and_on_black() {
        let all = [FOCUS, ERROR, WARNING, NOTE];
        for fixed in all.into_iter().chain(CURVES) {
            let first = FIRST.into_iter().find(|(index, _)| *index == fixed.0);
            for rgb in [xterm(fixed.1), first.expect("it is listed").1] {
                let l = luminance(rgb);
                let (on_white, on_black) = (1.05 / (l + 0.05), (l + 0.05) / 0.05);
                assert!(on_white >= 3.0 && on_black >= 3.0, "{rgb:?} {on_white} {on_black}");
            }
        }
    }

    #[test]
    fn a_heat_map_grows_lighter_and_its_ink_is_readable() {
        let light = HEAT.map(|step| luminance(xterm(step)));
        assert!(light.windows(2).all(|pair| pair[0] < pair[1]), "{light:?}");
        for (shade, light) in light.into_iter().enumerate() {
            let ink = heat(shade).1;
            let contrast = if ink == WHITE { 1.05 / (light + 0.05) } else { (light + 0.05) / 0.05 };
            assert!(contrast >= 4.5, "{shade}: {contrast}");
            assert_eq!(ink_on(heat(shade).0), ink);
        }
    }

    #[test]
    fn curves_have_different_colours_at_every_depth() {
        for depth in [ColourDepth::Sixteen, ColourDepth::Ansi256] {
            let colours: std::collections::HashSet<_> =
                (0..CURVES.len()).map(|i| curve(i, depth)).collect();
            assert!(!colours.contains(&None), "{depth:?}: the colour of the text");
            assert_eq!(colours.len(), CURVES.len(), "{depth:?}");
        }
    }
}
