//! Zoom of curves in Explore.

use super::bench::Bench;
use super::sweep;
use cmra::tui::theme::GlyphSet;

/// As in Run, the axis of values is that of what is in view.
#[test]
fn curves_that_are_zoomed_have_the_values_in_view() {
    let labels = |bench: &Bench| {
        let screen = bench.screen();
        let of = |line: &str| Some(line.split_once("||")?.1.split_once('+')?.0.trim().parse().ok());
        let labels: Vec<f64> = screen.lines().filter_map(of).flatten().collect();
        labels.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b))
            - labels.iter().fold(f64::INFINITY, |a, b| a.min(*b))
    };
    let mut bench = sweep::open("figure-9.4", 21, GlyphSet::Ascii, (80, 24));
    bench.keys("2");
    sweep::answer(&mut bench);
    let whole = labels(&bench);
    bench.keys("++");
    assert!(labels(&bench) < 0.5 * whole, "{whole}: {}", bench.screen());
}
