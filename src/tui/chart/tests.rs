//! Pictures of small charts, each drawn by hand from the rules first, and properties of charts of any size.
//!
//! The hand-drawn ones have a plot of 21 columns for x from 0 to 20 and 5 rows for y from 0 to 4, so that a value is its column
//! or row.

use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

use super::*;
use crate::tui::theme::ColourDepth;

fn small(curves: Vec<Curve<'_>>) -> Chart<'_> {
    let x = Axis::new("t", ViewRange::new(0.0, 20.0)).unit(Unit::new("s"));
    let y = Axis::new("", ViewRange::new(0.0, 4.0)).unit(Unit::new("m"));
    Chart { legend: Legend::Hidden, ..Chart::new("y", x, y, curves) }
}

fn picture(chart: &Chart<'_>) -> Vec<String> {
    chart.to_lines(29, 9, Theme::PLAIN)
}

/// The rows of the plot of one curve.
fn plot(points: &[(f64, f64)]) -> Vec<String> {
    picture(&small(vec![Curve::new('*', "now", points)]))[1..6].to_vec()
}

const RISING: [(f64, f64); 2] = [(0.0, 0.0), (20.0, 4.0)];
const FALLING: [(f64, f64); 2] = [(0.0, 4.0), (20.0, 0.0)];

#[test]
fn a_value_that_is_missing_is_a_gap() {
    let points = [
        (0.0, 1.0),
        (8.0, 1.0),
        (9.0, f64::NAN),
        (10.0, 1.0),
        (14.0, 1.0),
        (15.0, f64::INFINITY),
        (16.0, 3.0),
        (17.0, f64::NEG_INFINITY),
    ];
    assert_eq!(
        plot(&points),
        [
            "|  4+                       |",
            "|   |                *      |",
            "|  2+                       |",
            "|   |********* *****        |",
            "|  0+                       |",
        ]
    );
}

#[test]
fn one_spike_among_a_hundred_thousand_points_is_drawn() {
    let spike = |index: u32| {
        let y = if index == 50_000 { 4.0 } else { 0.0 };
        (f64::from(index) * 20.0 / 1e5, y)
    };
    let points: Vec<(f64, f64)> = (0..=100_000).map(spike).collect();
    assert_eq!(
        plot(&points),
        [
            "|  4+          *            |",
            "|   |          *            |",
            "|  2+          *            |",
            "|   |          *            |",
            "|  0+*********************  |",
        ]
    );
}

#[test]
fn where_curves_cross_the_later_or_the_selected_one_is_on_top() {
    let crossing = |emphasis| {
        let lines = picture(&small(vec![
            Curve::new('*', "now", &RISING).emphasis(emphasis),
            Curve::new('o', "A", &FALLING),
        ]));
        lines[1..6].to_vec()
    };
    assert_eq!(
        crossing(Emphasis::Normal),
        [
            "|  4+ooo               ***  |",
            "|   |   ooooo     *****     |",
            "|  2+        ooooo          |",
            "|   |   *****     ooooo     |",
            "|  0+***               ooo  |",
        ]
    );
    assert_eq!(crossing(Emphasis::Selected)[2], "|  2+        *****          |");
    assert_eq!(crossing(Emphasis::Stale)[2], "|  2+        ooooo          |");
}

#[test]
fn event_lines_lie_under_curves_and_the_crosshair_over_them() {
    let mut chart = small(vec![Curve::new('*', "now", &RISING)]);
    chart.marks = vec![Mark::new(15.0, "b"), Mark::new(5.0, "a"), Mark::new(99.0, "c")];
    chart.levels = vec![Mark::new(3.0, "max")];
    chart.crosshair = Some(10.2);
    assert_eq!(
        picture(&chart),
        [
            "+- y [m] ------------ t [s] +",
            "|  4+     a    |    b  ***  |",
            "|   |. . .: max| .*****. .  |",
            "|  2+     :  *****  :       |",
            "|   |   *****  |    :       |",
            "|  0+***  :    |    :       |",
            "|   ++----+----+----+----+  |",
            "|    0    5   10   15   20  |",
            "+---------------------------+",
        ]
    );
}

/// The first letters of a word may stand for something else: `s` of `scene` for `stopped`.
#[test]
fn the_word_of_an_event_is_whole_or_omitted() {
    let mut chart = small(vec![Curve::new('*', "now", &RISING)]);
    chart.marks = vec![Mark::new(12.0, "through"), Mark::new(15.0, "v"), Mark::new(19.0, "scene")];
    let text = picture(&chart).join("\n");
    assert!(text.contains('v') && text.contains("scene"), "{text}");
    assert!(!text.contains("th"), "{text}");
}

#[test]
fn a_logarithmic_axis_has_decades_and_counts_hidden_points() {
    let points = [(-1.0, 5.0), (0.0, 5.0), (1.0, 1.0), (1000.0, 1000.0), (f64::NAN, 1.0)];
    let axis = |label| Axis::new(label, ViewRange::new(1.0, 1000.0)).scale(Scale::Log10);
    let chart = Chart {
        legend: Legend::Hidden,
        ..Chart::new("e", axis("n"), axis(""), vec![Curve::new('*', "now", &points)])
    };
    // 31 columns and 7 rows: a decade is 10 columns and 2 rows; the slope is 1 row in 5 columns.
    assert_eq!(
        chart.to_lines(41, 11, Theme::PLAIN),
        [
            "+- e (2 <= 0 not drawn) ------------- n +",
            "| 1000+                            ***  |",
            "|     |                       *****     |",
            "|  100+                  *****          |",
            "|     |             *****               |",
            "|   10+        *****                    |",
            "|     |   *****                         |",
            "|    1+***                              |",
            "|     ++---------+---------+---------+  |",
            "|      1        10        100      1000 |",
            "+---------------------------------------+",
        ]
    );
}

#[test]
fn inside_a_decade_a_logarithmic_axis_has_linear_ticks() {
    let axis = Axis::new("n", ViewRange::new(30.0, 80.0)).scale(Scale::Log10);
    let y = Axis::new("", ViewRange::new(0.0, 4.0));
    let lines = Chart::new("e", axis, y, Vec::new()).to_lines(48, 9, Theme::PLAIN);
    for label in ["30", "40", "50", "60", "70", "80"] {
        assert!(lines[7].contains(label), "{label} in {}", lines[7]);
    }
}

#[test]
fn a_common_power_of_ten_goes_into_the_unit() {
    let mut chart = small(Vec::new());
    chart.y.view = ViewRange::new(0.0, 4e7);
    chart.x.unit = Unit { factor: 1e-9, name: "Gs".into() };
    let lines = picture(&chart);
    assert!(lines[0].starts_with("+- y [1e6 m] -"), "{}", lines[0]);
    assert!(lines[0].ends_with(" t [1e-9 Gs] +"), "{}", lines[0]);
    assert_eq!(lines[7], "|    0    5   10   15   20  |");
    assert_eq!(&lines[1][..5], "| 40+");
}

#[test]
fn a_power_of_ten_stays_where_factoring_it_out_would_lengthen_the_labels() {
    let view = ViewRange::new(99_990.0, 100_010.0);
    let chart = Chart::new("y", Axis::new("", view), Axis::new("", view), Vec::new());
    let lines = chart.to_lines(60, 9, Theme::PLAIN);
    assert!(lines[0].starts_with("+- y ---"), "{}", lines[0]);
    assert!(lines[7].contains(" 100000 "), "{}", lines[7]);
}

/// Columns where the line of the horizontal axis has a tick.
fn tick_columns(line: &str) -> Vec<usize> {
    let ticks = line.char_indices().filter(|(_, c)| *c == '+');
    ticks.map(|(column, _)| column).collect()
}

fn any_f64() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -10.0..10.0_f64,
        1 => any::<f64>(),
        1 => prop::sample::select(vec![
            0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, 5e-324, -1e-310,
        ]),
    ]
}

fn any_axis() -> impl Strategy<Value = Axis<'static>> {
    let scale = prop::sample::select(vec![Scale::Linear, Scale::Log10]);
    let factor = prop::sample::select(vec![1.0, 1e3, 1e-6, 1e300]);
    (any_f64(), any_f64(), scale, factor).prop_map(|(lo, hi, scale, factor)| {
        let unit = Unit { factor, name: "mµ".into() };
        let axis = Axis::new("axis", ViewRange::new(lo, hi));
        axis.unit(unit).scale(scale)
    })
}

/// Keeps failures beside those of the other tests.
fn kept() -> ProptestConfig {
    let file = FileFailurePersistence::Direct("tests/proptest-regressions/chart.txt");
    ProptestConfig { failure_persistence: Some(Box::new(file)), ..ProptestConfig::default() }
}

fn any_theme() -> impl Strategy<Value = Theme> {
    let glyphs = vec![GlyphSet::Ascii, GlyphSet::Block, GlyphSet::Braille];
    prop::sample::select(glyphs).prop_map(|glyphs| Theme { glyphs, depth: ColourDepth::Ansi256 })
}

proptest! {
    #![proptest_config(kept())]

    #[test]
    fn anything_is_drawn_inside_its_area(
        points in prop::collection::vec((any_f64(), any_f64()), 0..200),
        more in prop::collection::vec((any_f64(), any_f64()), 0..20),
        axes in (any_axis(), any_axis()),
        marks in (any_f64(), any_f64(), any_f64()),
        corner in (0_u16..20, 0_u16..20),
        size in (0_u16..300, 0_u16..300),
        frame in prop::sample::select(vec![
            Frame::Boxed,
            Frame::Stacked { begins: true, below: Below::Nothing },
            Frame::Stacked { begins: false, below: Below::End },
        ]),
        gutter in prop::sample::select(vec![0, 9, u16::MAX]),
        theme in any_theme(),
    ) {
        let (x, y) = axes;
        let chart = Chart {
            marks: vec![Mark::new(marks.0, "arrest"), Mark::new(1.0, "日")],
            levels: vec![Mark::new(marks.1, "limit")],
            crosshair: Some(marks.2),
            frame,
            gutter,
            ..Chart::new("a title", x, y, vec![
                Curve::new('*', "now", &points),
                Curve::new('w', "日", &more),
            ])
        };
        let all = Rect::new(0, 0, corner.0 + 150, corner.1 + 150);
        let area = Rect::new(corner.0, corner.1, size.0, size.1);
        let mut buffer = Buffer::filled(all, ratatui::buffer::Cell::new("~"));
        chart.render(area, &mut buffer, theme);
        for (x, y) in all.positions().map(|place| (place.x, place.y)) {
            if !area.contains((x, y).into()) {
                prop_assert_eq!(buffer[(x, y)].symbol(), "~");
            }
        }
    }

    #[test]
    fn every_label_stands_at_the_tick_of_its_value(
        lo in -1000.0..1000.0_f64, span in 0.001..2000.0_f64, width in 30_u16..160,
    ) {
        let view = ViewRange::new(lo, lo + span);
        let y = Axis::new("", ViewRange::new(0.0, 4.0));
        let chart = Chart::new("y", Axis::new("", view), y, Vec::new());
        let lines = chart.to_lines(width, 9, Theme::PLAIN);
        let axis = lines[6].as_str();
        let plot_from = axis.find('+').unwrap() + 1;
        // A long last label may have taken room from the plot: its axis line says how wide it is.
        let cells = axis[plot_from..].trim_end_matches(['|', ' ']).len() as f64;
        let mut labels = 0;
        for word in lines[7].trim_matches('|').split_whitespace() {
            let value: f64 = word.parse().unwrap();
            let column = plot_from as f64 + (cells - 1.0) * (value - lo) / span;
            // Places are rounded to 1e-4 of a cell before they are to cells.
            let near = |tick: &&usize| ((**tick as f64) - column).abs() <= 0.5 + 1e-4;
            let ticks = tick_columns(axis);
            let tick = ticks[1..].iter().find(near);
            prop_assert!(tick.is_some(), "{} not at a tick in\n{}\n{}", word, axis, lines[7]);
            // The last label may be moved left to stay in the frame, no farther than it is long.
            let shift = |start: usize| {
                let at_frame = start + word.len() + 1 == usize::from(width);
                if at_frame { word.len() } else { 0 }
            };
            let middle = lines[7]
                .match_indices(word)
                .any(|(start, _)| (start + word.len() / 2).abs_diff(*tick.unwrap()) <= shift(start));
            prop_assert!(middle, "{} not centred in\n{}\n{}", word, axis, lines[7]);
            labels += 1;
        }
        prop_assert!(labels >= 2 || width < 45, "{}", lines[7]);
    }
}

proptest! {
    #![proptest_config(kept())]

    /// As high as a chart of any screen from 60x16 to 200x60 can be.
    #[test]
    fn a_logarithmic_chart_upward_has_two_labels_and_each_stands_at_its_value(
        lo in -1000.0..1000.0_f64,
        decades in 0.01..16.0_f64,
        round in any::<bool>(),
        (width, height) in (24_u16..200, 5_u16..58),
    ) {
        let top = 10_f64.powf(lo / 100.0);
        let view = ViewRange::new(top / 10_f64.powf(decades), top);
        let view = if round { view.in_decades() } else { view };
        let x = Axis::new("", ViewRange::new(0.0, 4.0));
        let chart = Chart::new("y", x, Axis::new("", view).scale(Scale::Log10), Vec::new());
        let layout = layout_of(&chart, Rect::new(0, 0, width, height));
        prop_assert!(layout.y_ticks.labelled.len() >= 2, "{:?}", layout.y_ticks);
        let cells = layout.y_ticks.labelled.windows(2);
        let nearest = cells.map(|pair| pair[1].cell - pair[0].cell).min().unwrap();
        for tick in &layout.y_ticks.labelled {
            let value: f64 = tick.label.parse().unwrap();
            let row = layout.y.position(value * 10_f64.powi(layout.y_ticks.exponent));
            let off = (row.unwrap() - f64::from(tick.cell)).abs();
            let most = if nearest < 6 { 0.25 } else { 0.5 };
            prop_assert!(off <= most + 1e-3, "{} is {off} rows off: {:?}", tick.label, layout.y_ticks);
        }
    }
}

/// The labels of the left axis of a drawn chart with their rows of the text, from the top.
fn labels(lines: &[String]) -> Vec<(usize, f64)> {
    let label = |(row, line): (usize, &String)| {
        let text = line.strip_prefix('|')?.split_once('+')?.0.trim();
        Some((row, text.parse().ok()?))
    };
    lines.iter().enumerate().filter_map(label).collect()
}

/// Whether all these values are multiples of one step of 1, 2, 2.5 or 5 times a power of ten that is not below a least one.
fn are_round(values: &[f64], least: f64) -> bool {
    let power = 10_f64.powf(least.log10().floor());
    let mut steps = [1.0, 2.0, 2.5, 5.0, 10.0].map(|mantissa| mantissa * power).into_iter();
    let is_multiple = |value: f64, step: f64| {
        let count = value / step;
        (count - count.round()).abs() < 1e-6
    };
    steps.any(|step| {
        step >= least * (1.0 - 1e-6) && values.iter().all(|value| is_multiple(*value, step))
    })
}

proptest! {
    #![proptest_config(kept())]

    /// Each label is drawn again as a level line of its value: the line must be in the row of the label.
    #[test]
    fn labels_upward_are_round_and_lie_on_their_rows(
        lo in prop_oneof![Just(0.0), -1000.0..1000.0_f64],
        span in (-4.0..6.0_f64).prop_map(|power| 10_f64.powf(power)),
        padded in prop::sample::select(vec![0.0, 0.04, 0.05]),
        rows in 2_u16..56,
        frame in prop::sample::select(vec![
            Frame::Boxed,
            Frame::Stacked { begins: true, below: Below::End },
        ]),
    ) {
        let view = ViewRange::new(lo, lo + span).padded(Scale::Linear, padded);
        let x = Axis::new("", ViewRange::new(0.0, 4.0));
        let mut chart = Chart { frame, ..Chart::new("y", x, Axis::new("", view), Vec::new()) };
        let others = match (frame, rows) {
            (Frame::Boxed, 2) => 3,
            (Frame::Boxed, _) => 4,
            (Frame::Stacked { .. }, _) => 2,
        };
        let (area, is_low) = (Rect::new(0, 0, 60, rows + others), frame != Frame::Boxed && rows <= 4);
        let layout = layout_of(&chart, area);
        prop_assert_eq!(layout.plot.height, rows);
        let lines = chart.to_lines(area.width, area.height, Theme::PLAIN);
        let found = labels(&lines);
        let power = 10_f64.powi(layout.y_ticks.exponent);
        let least = match rows { 16.. => 5, 8.. => 3, _ => 2 };
        prop_assert!(found.len() >= least, "{} labels in {}", found.len(), lines.join("\n"));
        let values: Vec<f64> = found.iter().map(|label| label.1 * power).collect();
        let round = if is_low { &values[1..] } else { &values[..] };
        let apart = if is_low { view.span() / 20.0 } else { values[0] - values[1] };
        prop_assert!(are_round(round, apart), "{}", lines.join("\n"));
        // The whole range is seen, and not much more.
        let [bottom, top] = [view.lo(), view.hi()].map(|value| layout.y.position(value).unwrap());
        prop_assert!(bottom >= -0.5 && top <= f64::from(rows) - 0.5, "{bottom} {top}");
        prop_assert!(rows < 5 || top - bottom > 0.55 * f64::from(rows - 1), "{bottom} {top} {rows}");
        if is_low {
            prop_assert!(found[0].0 == 1, "the greatest value on top: {}", lines.join("\n"));
        }
        for (row, value) in found {
            let cell = layout.plot.bottom() - 1 - u16::try_from(row).unwrap();
            let off = (layout.y.value(cell) - value * power).abs();
            // The greatest value of a low chart is rounded.
            let most = if is_low && row == 1 { 0.01 } else { 0.01 / f64::from(rows) };
            prop_assert!(off <= most * view.span(), "{value} is {off} from its row");
            chart.curves = vec![Curve::new('*', "", vec![(0.0, value * power), (4.0, value * power)])];
            let drawn = chart.to_lines(area.width, area.height, Theme::PLAIN);
            prop_assert!(drawn[row].contains("***"), "{value}: {}", drawn.join("\n"));
        }
    }
}
