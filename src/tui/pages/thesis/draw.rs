//! The Thesis tab: claims with the selected one in full, principles with what serves them, the screening matrix.

use ratatui::layout::Rect;

use crate::model::units::significant;
use crate::study::principles::PRINCIPLES;
use crate::study::screening::{CONCEPTS, CRITERIA, rank, ranking};
use crate::study::thesis::Verdict;
use crate::tui::app::App;
use crate::tui::app::status::{clip, wrap};
use crate::tui::message::Target;
use crate::tui::pages::thesis::state::Claims;
use crate::tui::pages::thesis::{self, CLAIMS, SCREENING};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::list::List;
use crate::tui::widgets::text::{columns, paint_row, put};

/// From this width on the detail stands beside the list.
const BESIDE: u16 = 110;
/// Columns of a claim's place in the list, at most; a third of a narrow list.
const PLACE: u16 = 25;
/// Columns of a label of the detail.
const LABEL: u16 = 12;

/// Draw the page shown.
pub(in crate::tui) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    match app.pane() {
        CLAIMS => claims(app, area, canvas),
        SCREENING => screening(app, area, canvas),
        _ => principles(app, area, canvas),
    }
}

/// The list and the detail, beside or below each other.
fn split(area: Rect, below: u16) -> (Rect, Rect) {
    if area.width >= BESIDE {
        let left = area.width * 11 / 20;
        let detail = Rect { x: area.x + left, width: area.width - left, ..area };
        return (Rect { width: left, ..area }, detail);
    }
    let below = below.min(area.height / 2);
    let top = area.height - below;
    (Rect { height: top, ..area }, Rect { y: area.y + top, height: below, ..area })
}

fn role(verdict: Verdict) -> Role {
    match verdict {
        Verdict::Reproduced | Verdict::TrendHolds => Role::Text,
        Verdict::Corrected | Verdict::Misprint => Role::Warning,
        Verdict::TrendFails => Role::Error,
        Verdict::Unchecked => Role::Dim,
    }
}

/// Draw the claims.
fn claims(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.thesis;
    let (list, detail) = split(area, 11);
    let shown = app.claims();
    let title = match tab.filter {
        None => "Claims of the thesis".to_owned(),
        Some(verdict) => format!("Claims: {}", verdict.words()),
    };
    let count = format!("{} of {}", shown.len(), tab.rows().len());
    let pane = PaneFrame::new(title).right(count).focused(app.dialog.is_none());
    let inner = pane.render(list, canvas, app.theme);
    if shown.is_empty() {
        let text = match (app.jobs.running::<Claims>(), tab.rows().is_empty()) {
            (_, false) => "no row has this verdict: v for the next",
            (Some(_), true) => "checking the first claims",
            (None, true) => "r checks every claim",
        };
        put(canvas, inner, (1, 1), text, app.theme.style(Role::Dim));
    }
    let says = PLACE.min(inner.width / 3);
    // A claim has as many lines as it needs.
    let room = usize::from(inner.width.saturating_sub(says));
    let lines: Vec<(usize, bool, String)> = shown
        .iter()
        .enumerate()
        .flat_map(|(index, row)| {
            let parts = wrap(row.claim.says, room).into_iter().enumerate();
            parts.map(move |(at, part)| (index, at == 0, part))
        })
        .collect();
    let selected = lines.iter().position(|line| line.0 == tab.selected).unwrap_or(0);
    let rows = List { count: lines.len(), selected, painted: false };
    let target = |line: usize| Some(Target::Row(CLAIMS, lines[line].0));
    rows.render(canvas, inner, app.theme, target, |canvas, line, at| {
        let (index, is_first, part) = &lines[at];
        let row = shown[*index];
        let style = app.theme.style(role(row.found.verdict));
        if *is_first {
            put(canvas, line, (0, 0), &row.found.verdict.letter().to_string(), style);
            let place = clip(row.claim.place, usize::from(says.saturating_sub(3)));
            put(canvas, line, (2, 0), &place, style);
        }
        put(canvas, line, (says, 0), part, style);
        if *index == tab.selected && app.dialog.is_none() {
            paint_row(canvas, line, 0, app.theme.style(Role::Selection));
        }
    });
    let pane =
        PaneFrame::new(app.claim().map_or_else(String::new, |row| row.claim.place.to_owned()))
            .right("Tab: principles");
    let inner = pane.render(detail, canvas, app.theme);
    if let Some(row) = app.claim() {
        let found = &row.found;
        let mut y = 0;
        let verdict = format!("{} {}", found.verdict.letter(), found.verdict.words());
        for (label, text) in [
            ("says", row.claim.says),
            ("computed", found.sound.as_str()),
            ("as printed", found.printed.as_str()),
            ("verdict", verdict.as_str()),
            ("cause", row.claim.cause),
        ] {
            if !text.is_empty() {
                y = labelled(app, inner, y, (label, text), canvas);
            }
        }
    }
}

/// A label and a text over as many rows as it needs; gives the row after it.
fn labelled(
    app: &App,
    area: Rect,
    from: u16,
    (label, text): (&str, &str),
    canvas: &mut Canvas<'_>,
) -> u16 {
    put(canvas, area, (0, from), label, app.theme.style(Role::Dim));
    let room = usize::from(area.width.saturating_sub(LABEL).max(8));
    let mut y = from;
    for line in wrap(text, room) {
        put(canvas, area, (LABEL, y), &line, app.theme.style(Role::Text));
        y += 1;
    }
    y
}

/// A row of the list of principles.
enum Line {
    Family(&'static str),
    /// By its place.
    Principle(usize),
}

/// Every family with its principles below it.
fn listed() -> Vec<Line> {
    let mut lines = Vec::new();
    let mut family = "";
    for (index, principle) in PRINCIPLES.iter().enumerate() {
        if principle.family != family {
            family = principle.family;
            lines.push(Line::Family(family));
        }
        lines.push(Line::Principle(index));
    }
    lines
}

/// Draw the principles.
fn principles(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.thesis;
    let (list, detail) = split(area, 8);
    let pane = PaneFrame::new("Families and principles (Table 4.1)").focused(app.dialog.is_none());
    let inner = pane.render(list, canvas, app.theme);
    let lines = listed();
    let here = |line: &Line| matches!(line, Line::Principle(index) if *index == tab.principle);
    let selected = lines.iter().position(here).unwrap_or(0);
    let rows = List { count: lines.len(), selected, painted: app.dialog.is_none() };
    let target = |row: usize| match lines[row] {
        Line::Family(_) => None,
        Line::Principle(index) => Some(Target::Row(thesis::PRINCIPLES, index)),
    };
    rows.render(canvas, inner, app.theme, target, |canvas, row, at| {
        match lines[at] {
            Line::Family(name) => put(canvas, row, (0, 0), name, app.theme.style(Role::Title)),
            Line::Principle(index) => {
                put(canvas, row, (2, 0), PRINCIPLES[index].name, app.theme.style(Role::Text))
            }
        };
    });
    let principle = &PRINCIPLES[tab.principle];
    let title = format!("{}, section {}", principle.name, principle.section);
    let inner = PaneFrame::new(title).right("Tab: screening").render(detail, canvas, app.theme);
    let functions: Vec<&str> = principle.functions.iter().map(|it| it.name()).collect();
    let functions = functions.join(", ");
    let mut presets: Vec<&str> = principle.preset.into_iter().collect();
    for preset in principle.functions.iter().flat_map(|it| it.presets()) {
        if !presets.contains(preset) {
            presets.push(preset);
        }
    }
    let presets = presets.join(", ");
    let mut y = 0;
    for (label, text) in [
        ("idea", principle.idea),
        ("functions", functions.as_str()),
        ("computed", principle.computed),
        ("presets", presets.as_str()),
    ] {
        y = labelled(app, inner, y, (label, text), canvas);
    }
}

/// Draw the matrix.
fn screening(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.thesis;
    let pane = PaneFrame::new("Screening matrix (Table 7.1), weights h/l")
        .right("Tab: claims")
        .focused(app.dialog.is_none());
    let inner = pane.render(area, canvas, app.theme);
    let (dim, text) = (app.theme.style(Role::Dim), app.theme.style(Role::Text));
    let places = rank(&tab.weights);
    // On a narrow screen every concept counts for more than the end of a criterion's name, which is in the message row.
    let (name, start, cell) = if inner.width < 78 { (11, 18, 5) } else { (22, 30, 6) };
    put(canvas, inner, (0, 0), "criterion", dim);
    put(canvas, inner, (name, 0), "weight", dim);
    for (index, concept) in CONCEPTS.iter().enumerate() {
        let column = start + cell * u16::try_from(index).unwrap_or(0);
        put(canvas, inner, (column + 1, 0), &initials(concept.name), dim);
    }
    let count = CRITERIA.len();
    let height = u16::try_from(count).unwrap_or(u16::MAX).min(inner.height.saturating_sub(1));
    let list = Rect { y: inner.y + 1, height, ..inner };
    let rows = List { count, selected: tab.criterion, painted: app.dialog.is_none() };
    let target = |row| Some(Target::Row(SCREENING, row));
    rows.render(canvas, list, app.theme, target, |canvas, row, index| {
        put(canvas, row, (1, 0), &clip(CRITERIA[index], usize::from(name) - 1), text);
        let weight = format!("{} %", significant(tab.weights[index], 3));
        put(canvas, row, (name + 6 - columns(&weight).min(6), 0), &weight, text);
        for (at, concept) in CONCEPTS.iter().enumerate() {
            let column = start + cell * u16::try_from(at).unwrap_or(0);
            put(canvas, row, (column + 2, 0), &significant(concept.ratings[index], 2), text);
        }
    });
    for (y, label) in [(8, "total"), (9, "rank (printed)")] {
        put(canvas, inner, (0, y), label, app.theme.style(Role::Title));
    }
    for place in &places {
        let column = start + cell * u16::try_from(place.concept).unwrap_or(0);
        put(canvas, inner, (column, 8), &format!("{:.2}", place.total), text);
        let concept = &CONCEPTS[place.concept];
        let printed = if cell > 5 {
            format!("{} ({})", place.rank, concept.rank)
        } else {
            format!("{}({})", place.rank, concept.rank)
        };
        let moved = place.rank != concept.rank;
        let style = app.theme.style(if moved { Role::Warning } else { Role::Text });
        put(canvas, inner, (column, 9), &printed, style);
    }
    for (y, place) in (10..inner.height).zip(ranking(&tab.weights)) {
        let concept = &CONCEPTS[place.concept];
        let line = format!(
            "{}  {:<4}{:<24} {:.2}   section {}",
            place.rank,
            initials(concept.name),
            concept.name,
            place.total,
            concept.section
        );
        put(canvas, inner, (1, y), &line, text);
    }
}

/// Two letters of the first word and one of the second: `EmF` for `Emergent four-bar`.
fn initials(name: &str) -> String {
    let mut words = name.split(' ');
    let first: String = words.next().unwrap_or_default().chars().take(2).collect();
    let second: String = words.next().unwrap_or_default().chars().take(1).collect();
    first + &second.to_uppercase()
}
