//! Every tab and the drawing of twelve scenes at four sizes in braille and ASCII: what holds on all of these screens.

use std::sync::Arc;

use super::bench::{self, Bench};
use super::{accuracy, limit, search, stability, sweep};
use cmra::files::preset;
use cmra::tui::keymap::Tab;
use cmra::tui::message::Message;
use cmra::tui::pages::numerics;
use cmra::tui::preset::ReferencePreset;
use cmra::tui::theme::GlyphSet;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::changed;
use cmra_studies::study::accuracy::method::Method;

/// The scenes: presets, or changes of the baseline.
const SCENES: [(&str, &str); 12] = [
    ("thesis-baseline", ""),
    ("rigid-mount", ""),
    ("free-plate", ""),
    ("cocked", ""),
    ("oblique", ""),
    ("thin-plate-perforation", ""),
    ("validation-borvik", ""),
    ("stop", ""),
    ("cocked-plastic", ""),
    ("array-stacked", ""),
    ("thesis-baseline", "model=lumped k_load=1e6"),
    ("figure-8.11", ""),
];
const SIZES: [(u16, u16); 4] = [(60, 16), (80, 24), (120, 36), (160, 48)];
/// The tabs with their pages, and the drawing.
const KEYS: [&str; 15] =
    ["1", "1<Tab>z", "1v", "2", "3", "3v", "4", "44", "444", "4444", "5", "55", "6", "66", "7"];

fn scene(name: &str, pairs: &str) -> Scene {
    changed(preset::resolve(name, None).unwrap().scene, pairs).unwrap()
}

/// Faults of a screen.
fn faults(screen: &str, (columns, rows): (u16, u16)) -> Vec<String> {
    let mut faults = Vec::new();
    let lines: Vec<&str> = screen.lines().collect();
    if lines.len() != usize::from(rows) {
        faults.push(format!("{} lines", lines.len()));
    }
    let is_side = |letter: char| matches!(letter, '|' | '│');
    let is_end = |letter: char| matches!(letter, '|' | '│' | '+' | '┐' | '┘' | '┤' | '├');
    for line in &lines {
        let width = line.chars().count();
        if width > usize::from(columns) {
            faults.push(format!("{width} columns: {line}"));
        }
        // What begins with the side of a frame ends with one, unless text stands right of it.
        let ends = [line.chars().next(), line.chars().next_back()];
        if let [Some(first), Some(last)] = ends
            && is_side(first)
            && width == usize::from(columns)
            && !is_end(last)
        {
            faults.push(format!("a frame is open: {line}"));
        }
        // A title that has no room runs into its corner without a blank.
        let letters: Vec<char> = line.chars().collect();
        for pair in letters.windows(2) {
            if pair[0].is_alphabetic() && matches!(pair[1], '┐') {
                faults.push(format!("a title is cut: {line}"));
            }
        }
    }
    if !lines.last().is_some_and(|line| line.ends_with("q quit")) {
        faults.push(format!("the footer is cut: {:?}", lines.last()));
    }
    faults
}

/// Chart as drawn: its rows, and the labels of its left axis with their rows.
struct Drawn {
    rows: usize,
    labels: Vec<(usize, f64, String)>,
}

/// Returns the charts of a screen by their left axes: columns of sides and ticks, each tick after its label.
fn charts(screen: &str) -> Vec<Drawn> {
    let lines: Vec<Vec<char>> = screen.lines().map(|line| line.chars().collect()).collect();
    let columns = lines.iter().map(Vec::len).max().unwrap_or(0);
    let label = |line: &[char], column: usize| {
        let begin = line[..column].iter().rposition(|letter| !is_of_number(*letter));
        let begin = begin.filter(|at| matches!(line[*at], ' ' | '|' | '│'))?;
        let text: String = line[begin + 1..column].iter().collect();
        Some((text.parse::<f64>().ok()?, text))
    };
    let mut found = Vec::new();
    for column in 0..columns {
        let mut chart: Option<Drawn> = None;
        for line in &lines {
            let letter = line.get(column).copied().unwrap_or(' ');
            let tick = matches!(letter, '┤' | '+').then(|| label(line, column)).flatten();
            match (tick, &mut chart) {
                (Some((value, text)), Some(chart)) => {
                    chart.labels.push((chart.rows, value, text));
                    chart.rows += 1;
                }
                // Rows above the first label are counted from the side of the axis.
                (Some((value, text)), None) => {
                    chart = Some(Drawn { rows: 1, labels: vec![(0, value, text)] });
                }
                (None, Some(chart)) if matches!(letter, '│' | '|') => chart.rows += 1,
                (None, _) => found.extend(chart.take()),
            }
        }
        found.extend(chart);
    }
    found.retain(|chart| chart.labels.len() > 1);
    found
}

fn is_of_number(letter: char) -> bool {
    letter.is_ascii_digit() || matches!(letter, '.' | '-' | 'e')
}

/// Returns `true` if all values are multiples of 1, 2, 2.5 or 5 times a power of ten that divides their distance.
fn are_round(values: &[f64]) -> bool {
    let apart = values.windows(2).map(|pair| (pair[0] - pair[1]).abs());
    let Some(apart) = apart.reduce(f64::min) else { return true };
    let decade = 10f64.powf(apart.log10().floor() + 1e-9);
    let is_multiple = |value: f64, of: f64| (value / of - (value / of).round()).abs() < 1e-6;
    let steps = [5.0, 2.5, 2.0, 1.0].map(|step| step * decade);
    steps.into_iter().any(|step| values.iter().all(|value| is_multiple(*value, step)))
}

/// Returns the faults of the labels on the left axes of a screen.
fn label_faults(screen: &str) -> Vec<String> {
    let mut faults = Vec::new();
    for Drawn { rows, labels } in charts(screen) {
        let values: Vec<f64> = labels.iter().map(|label| label.1).collect();
        // The greatest value of a low chart is on top.
        let is_low = rows <= 4;
        // Labels of a logarithmic axis are 1, 2 or 5 times a power of ten; such values have no row of their own.
        let decade = |value: f64| {
            let place = value.log10();
            let round = [1.0_f64, 2.0, 5.0].map(|it| (place - it.log10()).rem_euclid(1.0));
            let is_round = round.iter().any(|part| part.min(1.0 - part) < 1e-9);
            (value > 0.0 && is_round).then_some(place)
        };
        let decades: Option<Vec<f64>> = values.iter().map(|value| decade(*value)).collect();
        let lies = |values: &[f64], most: f64| {
            let (first, last) = (0, values.len() - 1);
            let slope = (values[last] - values[first]) / (labels[last].0 - labels[first].0) as f64;
            let at = |row: usize| values[first] + slope * (row - labels[first].0) as f64;
            let off = |(at_row, value): (f64, f64)| (at_row - value).abs() / slope.abs();
            labels.iter().zip(values).all(|(label, value)| off((at(label.0), *value)) < most)
        };
        let is_linear =
            lies(&values, 1e-6) && are_round(if is_low { &values[1..] } else { &values });
        if !is_linear && !decades.is_some_and(|decades| lies(&decades, 0.3)) {
            let texts: Vec<String> =
                labels.iter().map(|(row, _, text)| format!("{text} in row {row}")).collect();
            faults.push(format!("labels of {rows} rows: {}", texts.join(", ")));
        }
        let least = match rows {
            16.. => 5,
            8.. => 3,
            _ => 2,
        };
        if labels.len() < least {
            faults.push(format!("{} labels in {rows} rows", labels.len()));
        }
    }
    faults
}

#[test]
fn the_reader_of_charts_finds_labels_beside_their_rows() {
    let screen = "|  5+ x|\n|   |  |\n|  3+  |\n|   |  |\n|  0+  |\n+---+--+";
    let read = charts(screen);
    assert_eq!((read.len(), read[0].rows, read[0].labels.len()), (1, 5, 3));
    assert_eq!(label_faults(screen).len(), 1, "3 lies at 2.5");
    assert!(label_faults(&screen.replace('3', "2.5").replace("  2.5", "2.5")).is_empty());
    assert_eq!(label_faults("|1e6+|\n|   ||\n|1e4+|\n|   ||\n|1e2+|"), Vec::<String>::new());
    assert!(!label_faults("|1e6+|\n|   ||\n|1e4+|\n|   ||\n|   ||\n|1e2+|").is_empty());
    assert!(!label_faults("|7.3+|\n|   ||\n|   ||\n|   ||\n|2.1+|").is_empty(), "no round number");
}

/// The screens kept as snapshots, too.
#[test]
fn every_label_of_every_snapshot_lies_on_its_row() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = folder.join("tests/integration/screens/snapshots");
    let (mut read, mut found) = (0, Vec::new());
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        read += charts(&text).len();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        found.extend(label_faults(&text).into_iter().map(|fault| format!("{name}: {fault}")));
    }
    assert!(read > 60, "{read} charts");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Answers the studies of the tab shown: some computed, others made up. Those of many runs are computed for the baseline only.
fn settle(bench: &mut Bench, is_baseline: bool) {
    match (bench.app.tab, bench.app.pane()) {
        (Tab::Explore, _) if bench.app.scene.sweep.is_none() => sweep::answer(bench),
        (Tab::Numerics, numerics::ACCURACY) => accuracy::answer(bench, Method::ALL.len()),
        (Tab::Numerics, _) => stability::answer(bench),
        (Tab::Limit, _) if is_baseline => limit::answer(bench),
        (Tab::Search | Tab::Run, _) if is_baseline => search::answer(bench),
        _ => {}
    }
}

#[test]
fn no_screen_of_twelve_scenes_is_cut_or_mislabelled() {
    let mut found = Vec::new();
    for (name, pairs) in SCENES {
        let scene = Arc::new(scene(name, pairs));
        let base =
            ReferencePreset { name: name.to_owned(), is_mine: false, scene: Arc::clone(&scene) };
        for keys in KEYS {
            let mut bench = Bench::ascii(80, 24);
            (bench.app.scene, bench.app.base) = (Arc::clone(&scene), base.clone());
            bench.keys("r");
            for key in bench::keys_of(keys) {
                bench.keys(&key);
                settle(&mut bench, (name, pairs) == SCENES[0]);
            }
            for glyphs in [GlyphSet::Braille, GlyphSet::Ascii] {
                for size in SIZES {
                    bench.app.settings.theme.glyphs = glyphs;
                    bench.send(Message::Resize(size.0, size.1));
                    let screen = bench.screen();
                    let place = format!("{name} {pairs} {size:?} {glyphs} {keys}");
                    let faults = faults(&screen, size).into_iter().chain(label_faults(&screen));
                    found.extend(faults.map(|fault| format!("{place}: {fault}")));
                }
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// The keys that the footer of a screen shows for its pane, as they are pressed.
fn offered(screen: &str) -> Vec<String> {
    let footer = screen.lines().last().unwrap_or_default();
    let entries = footer.trim().split("  ").filter_map(|entry| entry.trim().split_once(' '));
    let keys = entries.filter(|(_, what)| *what != "quit").flat_map(|(keys, _)| keys.split('/'));
    let written = |key: &str| match key {
        "Space" => " ".to_owned(),
        "Enter" | "Tab" | "Esc" => format!("<{key}>"),
        key => key.to_owned(),
    };
    keys.filter(|key| !key.is_empty()).map(written).collect()
}

#[test]
fn every_key_of_a_footer_does_something() {
    let (mut found, mut tried) = (Vec::new(), 0);
    let screens = [
        "1",
        "1<Tab>",
        "1<Tab>z",
        "1<Tab><Tab>",
        "2",
        "2v",
        "3",
        "3v",
        "5",
        "55",
        "55<Tab>",
        "6",
        "66",
        "7",
    ];
    for keys in screens {
        let mut bench = Bench::ascii(160, 48);
        for key in bench::keys_of(keys) {
            bench.keys(&key);
            settle(&mut bench, true);
        }
        let (pane, is_full) = (bench.app.pane(), bench.app.is_full());
        for key in offered(&bench.screen()) {
            bench.press(&key);
            tried += 1;
            let message = bench.message();
            if message.contains("does nothing here") || message.contains("nothing to ") {
                found.push(format!("{keys}: `{key}`: {message}"));
            }
            if bench.app.has_dialog() || bench.app.typing.is_some() {
                bench.press("<Esc>");
            }
            bench.app.focus_on(pane);
            bench.app.pages.run.is_full = is_full;
            bench.answer();
        }
    }
    assert!(tried > 60, "{tried} keys");
    assert!(found.is_empty(), "{}", found.join("\n"));
}
