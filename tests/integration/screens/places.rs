//! Places of a crosshair that are typed: on the charts of a run, on the curves and maps of Explore, on the map of stability.

use super::bench::Bench;
use super::{stability, sweep};
use cmra::tui::theme::GlyphSet;

const SIZE: (u16, u16) = (80, 24);

/// The last line of the screen.
fn footer(bench: &Bench) -> String {
    bench.screen().lines().last().unwrap_or_default().to_owned()
}

#[test]
fn the_time_of_the_charts_crosshair_is_typed() {
    let mut bench = Bench::open(GlyphSet::Ascii, SIZE);
    bench.press("<Tab>=");
    assert!(footer(&bench).contains("cursor to t:"), "{}", bench.screen());
    assert!(footer(&bench).contains("t in us  Enter go  Esc leave"), "{}", bench.screen());
    for (text, t_s) in [("64", 64e-6), ("t 0.05ms", 0.05e-3), ("t=12 us", 12e-6)] {
        bench.press("<Esc>=");
        bench.keys(text);
        bench.press("<Enter>");
        assert_eq!(bench.app.pages.run.charts.cursor_s, Some(t_s), "{text}");
    }
    // What is refused stays in the field, and the crosshair where it was.
    bench.press("=");
    bench.keys("5 ms");
    bench.press("<Enter>");
    assert!(bench.message().contains("t 5.000 ms is not on the axis"), "{}", bench.message());
    assert_eq!(bench.app.pages.run.charts.cursor_s, Some(12e-6));
    bench.press("<Esc>");
    assert!(bench.app.place().is_none() && bench.app.pages.run.charts.cursor_s.is_some());
    bench.press("<Esc>");
    assert_eq!(bench.app.pages.run.charts.cursor_s, None);
}

#[test]
fn the_point_of_a_map_is_typed_by_the_names_of_its_axes() {
    let mut bench = sweep::open_map("figure-9.7", 11, GlyphSet::Ascii, SIZE);
    sweep::keys(&mut bench, "2");
    assert_eq!(bench.app.pages.explore.cursor, None);
    // gamma 0.8 to 7 in steps of 0.62, k 0 to 7.5 MN/m in steps of 0.75.
    for (text, cursor) in [
        ("gamma 7", (10, 0)),
        ("k 7.5MN/m", (10, 10)),
        ("gamma=2.1 k=3 MN/m", (2, 4)),
        ("0.8", (0, 4)),
    ] {
        bench.press("=");
        bench.keys(text);
        bench.press("<Enter>");
        let found = bench.app.pages.explore.cursor;
        assert_eq!(found.map(|it| it.0), Some(cursor.0), "{text}: {}", bench.message());
        assert!(text == "gamma 7" || found == Some(cursor), "{text}: {found:?}");
    }
    bench.press("=");
    bench.keys("h 3");
    bench.press("<Enter>");
    assert!(bench.message().contains("axes here: gamma, k"), "{}", bench.message());
    bench.press("<Esc><Esc>");
    assert_eq!(bench.app.pages.explore.cursor, None);
}

#[test]
fn the_cell_of_the_map_of_stability_is_typed() {
    let mut bench = stability::open(GlyphSet::Ascii, SIZE);
    bench.press("=");
    bench.keys("dt 1e-8 k 1e9");
    bench.press("<Enter>");
    let tab = &bench.app.pages.numerics.stability;
    let (map, at) = tab.map.result.as_ref().zip(tab.cursor).expect("a cursor on a map");
    let (dt_s, k) = (map.dt.value(at.0 as u64), map.variable.value(at.1 as u64));
    assert!((dt_s / 1e-8).ln().abs() < 0.2, "{dt_s}");
    assert!((k / 1e9).ln().abs() < 0.7, "{k}");
}
