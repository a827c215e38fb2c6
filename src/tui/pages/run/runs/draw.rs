//! The table of runs: the current one and the pins, and what the scene differs from the first pin in.

use ratatui::layout::Rect;

use crate::model::run::Run;
use crate::model::units;
use crate::model::variables::VARIABLES;
use crate::tui::app::App;
use crate::tui::app::status::{clip, wrap};
use crate::tui::chart::MARKERS;
use crate::tui::message::Target;
use crate::tui::pages::run::RUNS;
use crate::tui::pages::run::runs::{Pin, final_depth, millimetres};
use crate::tui::pages::run::summary::results;
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{columns, paint_row, put};

/// A column: heading, width, value; the ones at the right go first when there is little room.
type Column = (&'static str, u16, fn(&Run) -> String);

const COLUMNS: [Column; 6] = [
    ("p_1st mm", 9, first_depth),
    ("p_end mm", 12, final_depth),
    ("% rigid", 8, |run| {
        run.percent_of_baseline().map_or_else(|| "-".to_owned(), |percent| format!("{percent:.1}"))
    }),
    ("x_max mm", 9, |run| millimetres(run.max_plate_displacement_m)),
    ("F_max kN", 9, |run| {
        run.peak_contact_force_n
            .map_or_else(|| "-".to_owned(), |peak_n| units::fixed_significant(peak_n / 1e3, 4))
    }),
    ("v_out m/s", 10, |run| {
        run.residual_velocity_m_s
            .map_or_else(|| "-".to_owned(), |speed| units::fixed_significant(speed, 4))
    }),
];

/// In a narrow pane; the title says they are mm.
const NARROW: [Column; 3] = [
    ("p_1st", 7, first_depth),
    ("p_end", 7, final_depth),
    ("x_max", 7, |run| millimetres(run.max_plate_displacement_m)),
];

fn first_depth(run: &Run) -> String {
    millimetres(run.first_arrest.map(|arrest| arrest.penetration_m))
}

/// Columns of marker, letter and a blank before the name.
const LEAD: u16 = 5;
const NAME_LEAST: u16 = 5;

/// Draw the pane.
pub(in crate::tui) fn render(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    canvas.pane(area, RUNS);
    let right = match (app.pins.is_empty(), focused) {
        (true, _) => "Space pins",
        (false, true) => "Enter load  Space unpin",
        (false, false) => "",
    };
    let table: &'static [Column] = if area.width < 60 { &NARROW } else { &COLUMNS };
    let title = if area.width < 60 { "Runs [mm]" } else { "Runs" };
    let inner = PaneFrame::new(title).right(right).focused(focused).render(area, canvas, app.theme);
    let (shown, name_width) = fitting(table, inner.width);
    header(app, inner, shown, name_width, canvas);
    let mut row = 1;
    let now = app.name_of(&app.scene);
    let run = app.shown.as_ref().map(|shown| &*shown.run);
    let mut line = |index: usize, letter: &str, name: &str, run: Option<&Run>, visible: bool| {
        let place = Place { inner, row, shown, name_width };
        one(app, &place, (index, letter, name), (run, visible), canvas);
        row += 1;
    };
    line(0, "now", &now, run, app.current_visible);
    for (at, pin) in app.pins.iter().enumerate() {
        line(at + 1, &pin.letter.to_string(), &pin.name, pin.run.as_deref(), pin.visible);
    }
    if focused {
        let selected = u16::try_from(app.selected_run).unwrap_or(0) + 1;
        paint_row(canvas, inner, selected, app.theme.style(Role::Selection));
    }
    below(app, inner, row, canvas);
    let count = app.pins.len() + 1;
    let area = Rect { y: inner.y + 1, height: inner.height.saturating_sub(1), ..inner };
    canvas.rows(area, (0, count), |run| Some(Target::Row(RUNS, run)));
}

/// How many value columns fit beside a name of some width.
fn fitting(table: &'static [Column], width: u16) -> (&'static [Column], u16) {
    let mut used = LEAD + NAME_LEAST;
    let mut count = 0;
    for (_, column, _) in table {
        if used + column > width {
            break;
        }
        used += column;
        count += 1;
    }
    let name = NAME_LEAST + width.saturating_sub(used);
    (&table[..count], name.min(28))
}

fn header(
    app: &App,
    inner: Rect,
    shown: &'static [Column],
    name_width: u16,
    canvas: &mut Canvas<'_>,
) {
    let style = app.theme.style(Role::Dim);
    put(canvas, inner, (LEAD, 0), "name", style);
    let mut end = LEAD + name_width;
    for (title, width, _) in shown {
        end += width;
        put(canvas, inner, (end.saturating_sub(columns(title)), 0), title, style);
    }
}

struct Place {
    inner: Rect,
    row: u16,
    shown: &'static [Column],
    name_width: u16,
}

fn one(
    app: &App,
    place: &Place,
    (index, letter, name): (usize, &str, &str),
    (run, visible): (Option<&Run>, bool),
    canvas: &mut Canvas<'_>,
) {
    let (inner, row) = (place.inner, place.row);
    let role = if visible { Role::Curve(index) } else { Role::Dim };
    let marker = if visible { MARKERS[index % MARKERS.len()] } else { ' ' };
    put(canvas, inner, (0, row), &format!("{marker}{letter}"), app.theme.style(role));
    let style = app.theme.style(if visible { Role::Text } else { Role::Dim });
    let name = clip(name, usize::from(place.name_width));
    put(canvas, inner, (LEAD, row), &name, style);
    let mut end = LEAD + place.name_width;
    let Some(run) = run else {
        put(canvas, inner, (end + 2, row), "running", app.theme.style(Role::Dim));
        return;
    };
    let mut columns_left = place.shown.iter();
    while let Some((_, width, value)) = columns_left.next() {
        let text = fitted(value(run), *width);
        let in_words = text.ends_with('!');
        if columns(&text) >= *width
            && let Some((_, more, _)) = columns_left.next()
        {
            // A word in place of a depth takes the next column, too.
            end += more;
        }
        end += width;
        let role = if in_words { Role::Warning } else { Role::Text };
        let style = app.theme.style(if visible { role } else { Role::Dim });
        put(canvas, inner, (end.saturating_sub(columns(&text)), row), &text, style);
    }
}

/// A number in fewer columns than these, with as many of its figures as go in; a word as it is.
fn fitted(text: String, width: u16) -> String {
    let Ok(value) = text.parse::<f64>() else { return text };
    let fewer = (1..=4_usize).rev().flat_map(|digits| {
        [units::fixed_significant(value, digits), format!("{value:.*e}", digits - 1)]
    });
    let mut spellings = std::iter::once(text.clone()).chain(fewer);
    spellings.find(|text| columns(text) < width).unwrap_or(text)
}

/// Below the rows: the difference to the selected pin (the first, where the current run is selected), or how to pin; then,
/// where there is room, the results of the selected run in words.
fn below(app: &App, inner: Rect, row: u16, canvas: &mut Canvas<'_>) {
    let width = usize::from(inner.width);
    let mut lines: Vec<(String, Role)> = match app.pins.get(app.selected_run.saturating_sub(1)) {
        Some(pin) => comparison(app, pin, width),
        None => vec![("Space pins this run to compare with".to_owned(), Role::Dim)],
    };
    let run = match app.selected_run.checked_sub(1) {
        None => app.shown.as_ref().map(|shown| &shown.run),
        Some(at) => app.pins.get(at).and_then(|pin| pin.run.as_ref()),
    };
    let details: Vec<String> = run.map_or_else(Vec::new, |run| results(run));
    let free = usize::from(inner.height.saturating_sub(row)).saturating_sub(lines.len());
    if !details.is_empty() && free > details.len() + 1 {
        lines.push((String::new(), Role::Text));
        let whose = match app.selected_run.checked_sub(1).and_then(|at| app.pins.get(at)) {
            None => "now".to_owned(),
            Some(pin) => format!("{} {}", pin.letter, pin.name),
        };
        lines.push((clip(&format!("{whose}:"), width), Role::Title));
        lines.extend(details.into_iter().map(|line| (clip(&line, width), Role::Text)));
    }
    for (row, (line, role)) in (row..inner.height).zip(&lines) {
        put(canvas, inner, (0, row), line, app.theme.style(*role));
    }
}

/// What the current run gained on a pin, and what was changed for it.
fn comparison(app: &App, pin: &Pin, width: usize) -> Vec<(String, Role)> {
    let depth = |run: &Run| run.first_arrest.map(|arrest| arrest.penetration_m);
    let pair = app.shown.as_ref().zip(pin.run.as_ref());
    let difference = pair.and_then(|(now, pin)| Some((depth(&now.run)?, depth(pin)?)));
    let difference = difference.map_or_else(
        || "no first arrest to compare".to_owned(),
        |(now, then)| {
            let percent = 100.0 * (now - then) / then;
            format!("p_1st {:+.4} mm ({percent:+.1} %)", (now - then) * 1e3)
        },
    );
    let mut lines = vec![(format!("now - {}: {difference}", pin.letter), Role::Title)];
    let words: Vec<String> = App::differing(&pin.scene, &app.scene)
        .into_iter()
        .map(|index| {
            let variable = &VARIABLES[index];
            let (then, now) = (variable.show(&pin.scene), variable.show(&app.scene));
            format!("{} {then} -> {now}", variable.symbol)
        })
        .collect();
    let text = if words.is_empty() { "same scene".to_owned() } else { words.join(", ") };
    lines.extend(wrap(&text, width).into_iter().map(|line| (line, Role::Text)));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_never_cut_in_half() {
        for (text, width, shown) in [
            ("4.572", 7, "4.572"),
            ("9.178e-10", 7, "9e-10"),
            ("1.236e7", 7, "1.24e7"),
            ("0.0001234", 7, "1.2e-4"),
            ("-1.235e-12", 9, "-1.2e-12"),
            ("-", 7, "-"),
            ("perforated!", 7, "perforated!"),
        ] {
            assert_eq!(fitted(text.to_owned(), width), shown);
        }
    }
}
