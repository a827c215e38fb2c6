//! Whole charts as pictures, in every glyph set.

use cmra::tui::chart::{Axis, Chart, Curve, Draw, Emphasis, Mark, Scale, Unit, ViewRange};
use cmra::tui::theme::{ColourDepth, GlyphSet, Theme};

const SETS: [GlyphSet; 3] = [GlyphSet::Ascii, GlyphSet::Block, GlyphSet::Braille];

/// An approach to a limit, every half microsecond.
fn approach(limit_m: f64, time_s: f64, until_s: f64) -> Vec<(f64, f64)> {
    let times = (0..=400).map(|index| f64::from(index) * 0.5e-6);
    let depth = |t_s: f64| {
        let depth_m = limit_m * (1.0 - (-t_s / time_s).exp());
        (t_s, if t_s > until_s { f64::NAN } else { depth_m })
    };
    times.map(depth).collect()
}

fn text(chart: &Chart<'_>, width: u16, height: u16, glyphs: GlyphSet) -> String {
    let theme = Theme { glyphs, depth: ColourDepth::None };
    chart.to_lines(width, height, theme).join("\n")
}

#[test]
fn three_runs_with_events_and_a_crosshair() {
    let now = approach(4.5e-3, 60e-6, 1.0);
    let rigid = approach(8.1e-3, 95e-6, 1.0);
    let perforated = approach(1.7e-3, 30e-6, 80e-6);
    let time = ViewRange::new(0.0, 200e-6);
    let depth = ViewRange::new(0.0, 8e-3);
    let mut chart = Chart::new(
        "Penetration p",
        Axis::new("t", time).unit(Unit::with_prefix(time.size(), "s")),
        Axis::new("p", depth).unit(Unit::with_prefix(depth.size(), "m")),
        vec![
            Curve::new('*', "now", &now).emphasis(Emphasis::Selected),
            Curve::new('o', "A rigid", &rigid).colour(1),
            Curve::new('+', "B gamma=1 d=0.5", &perforated).colour(2),
        ],
    );
    chart.marks = vec![Mark::new(101.2e-6, "a")];
    chart.crosshair = Some(60e-6);
    let name = |size: &str, glyphs: GlyphSet| format!("three_runs_{size}_{glyphs}");
    for glyphs in SETS {
        insta::assert_snapshot!(name("82x11", glyphs), text(&chart, 82, 11, glyphs));
    }
    for (size, width, height) in [("49x19", 49, 19), ("30x8", 30, 8)] {
        let glyphs = GlyphSet::Braille;
        insta::assert_snapshot!(name(size, glyphs), text(&chart, width, height, glyphs));
    }
}

#[test]
fn an_error_against_time_chart_on_logarithmic_axes() {
    let error = |order: f64| -> Vec<(f64, f64)> {
        let steps = (0..13).map(f64::from);
        let point = |step: f64| (1e-6 * 10_f64.powf(0.4 * step), 10_f64.powf(-0.25 * order * step));
        steps.map(point).collect()
    };
    let (first, fourth) = (error(1.0), error(4.0));
    let time = ViewRange::new(1e-6, 0.1);
    let mut chart = Chart::new(
        "relative error",
        Axis::new("run time", time)
            .unit(Unit { factor: 1e6, name: "us".into() })
            .scale(Scale::Log10),
        Axis::new("", ViewRange::new(1e-12, 1.0)).scale(Scale::Log10),
        vec![
            Curve::new('T', "first order", &first),
            Curve::new('E', "fourth order", &fourth).colour(1),
        ],
    );
    chart.levels = vec![Mark::new(1e-9, "wanted")];
    for glyphs in SETS {
        insta::assert_snapshot!(format!("log_log_{glyphs}"), text(&chart, 78, 15, glyphs));
    }
}
