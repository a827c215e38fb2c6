//! Whole screens, as a person sees them, and what keys do.

mod bench;

use bench::Bench;
use cmra::tui::theme::GlyphSet;

#[test]
fn look() {
    let size = |name: &str, d: &str| {
        std::env::var(name)
            .ok()
            .and_then(|v| v.parse().ok())
            .unwrap_or_else(|| d.parse::<u16>().unwrap())
    };
    let g = match std::env::var("GLYPHS").as_deref() {
        Ok("braille") => GlyphSet::Braille,
        Ok("block") => GlyphSet::Block,
        _ => GlyphSet::Ascii,
    };
    let mut bench = Bench::open(g, (size("W", "80"), size("H", "24")));
    for k in std::env::var("KEYS").unwrap_or_default().split("~") {
        bench.keys(k);
    }
    println!("{}", bench.screen());
}
