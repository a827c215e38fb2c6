//! The Thesis tab: claims with the selected one in full, principles with what serves them, the screening matrix.

use crate::study::principles::PRINCIPLES;
use crate::study::screening::{CONCEPTS, CRITERIA, rank, ranking};
use crate::study::thesis::ClaimVerdict;
use crate::tui::pages::prelude::*;
use crate::tui::pages::thesis::{self, CLAIMS, Claims, SCREENING};
use crate::tui::widgets::table::{NO_MATCH, filtered};

/// From this width on the detail stands beside the list.
const BESIDE: u16 = 110;
/// Columns of a claim's place in the list, at most; a third of a narrow list.
const PLACE: u16 = 25;
const LABEL: u16 = 12;

pub(crate) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    match app.pane() {
        CLAIMS => claims(app, area, canvas),
        SCREENING => screening(app, area, canvas),
        _ => principles(app, area, canvas),
    }
}

/// The list and the detail, beside or below each other.
fn split(area: Rect, below: u16) -> (Rect, Rect) {
    if area.width >= BESIDE {
        return split_left(area, area.width * 11 / 20);
    }
    split_bottom(area, below.min(area.height / 2))
}

fn role(verdict: ClaimVerdict) -> Role {
    match verdict {
        ClaimVerdict::Reproduced | ClaimVerdict::TrendHolds => Role::Text,
        ClaimVerdict::Corrected | ClaimVerdict::Misprint => Role::Warning,
        ClaimVerdict::TrendFails => Role::Error,
        ClaimVerdict::Unchecked => Role::Dim,
    }
}

fn claims(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.thesis;
    let (list, detail) = split(area, 11);
    let shown = app.claims();
    let title = match tab.filter {
        None => "Claims of the thesis".to_owned(),
        Some(verdict) => format!("Claims: {}", verdict.words()),
    };
    let count = format!("{} of {}", shown.len(), tab.rows().len());
    let pane =
        PaneFrame::new(filtered(&title, &tab.find)).right(count).focused(app.dialog.is_none());
    let inner = pane.draw(list, canvas);
    if shown.is_empty() {
        let text = match tab.rows() {
            [] => nothing::<Claims>(app, "checking the first claims", None),
            _ if !tab.find.is_empty() => app.keymap.shown(NO_MATCH),
            _ => app.keymap.shown("no row has this verdict: <view> for the next"),
        };
        canvas.put(inner, (1, 1), &text, Role::Dim);
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
    let rows = RowList { count: lines.len(), selected, painted: false };
    let target = |line: usize| Some(Target::Row(CLAIMS, lines[line].0));
    rows.render(canvas, inner, target, |canvas, line, at| {
        let (index, is_first, part) = &lines[at];
        let row = shown[*index];
        let role = role(row.found.verdict);
        if *is_first {
            canvas.put(line, (0, 0), &row.found.verdict.letter().to_string(), role);
            let place = clip(row.claim.place, usize::from(says.saturating_sub(3)));
            canvas.put(line, (2, 0), &place, role);
        }
        canvas.put(line, (says, 0), part, role);
        if *index == tab.selected && app.dialog.is_none() {
            canvas.paint_row(line, 0);
        }
    });
    claim(app, detail, canvas);
}

/// The selected claim in full.
fn claim(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let place = app.claim().map_or("", |row| row.claim.place);
    let inner =
        PaneFrame::new(place).right(app.keymap.shown("<next-pane>: principles")).draw(area, canvas);
    if let Some(row) = app.claim() {
        let found = &row.found;
        let verdict = format!("{} {}", found.verdict.letter(), found.verdict.words());
        let texts = [
            ("says", row.claim.says),
            ("computed", &found.sound),
            ("as printed", &found.printed),
            ("verdict", &verdict),
            ("cause", row.claim.cause),
        ];
        let texts = texts.into_iter().filter(|(_, text)| !text.is_empty());
        labelled(inner, texts, canvas);
    }
}

/// Texts below each other, each with its label and over as many rows as it needs.
fn labelled<'a>(
    area: Rect,
    texts: impl IntoIterator<Item = (&'static str, &'a str)>,
    canvas: &mut Canvas<'_>,
) {
    let mut y = 0;
    for (label, text) in texts {
        canvas.put(area, (0, y), label, Role::Dim);
        for line in wrap(text, usize::from(area.width.saturating_sub(LABEL).max(8))) {
            canvas.put(area, (LABEL, y), &line, Role::Text);
            y += 1;
        }
    }
}

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

fn principles(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.thesis;
    let (list, detail) = split(area, 8);
    let pane = PaneFrame::new("Families and principles (Table 4.1)").focused(app.dialog.is_none());
    let inner = pane.draw(list, canvas);
    let lines = listed();
    let here = |line: &Line| matches!(line, Line::Principle(index) if *index == tab.principle);
    let selected = lines.iter().position(here).unwrap_or(0);
    let rows = RowList { count: lines.len(), selected, painted: app.dialog.is_none() };
    let target = |row: usize| match lines[row] {
        Line::Family(_) => None,
        Line::Principle(index) => Some(Target::Row(thesis::PRINCIPLES, index)),
    };
    rows.render(canvas, inner, target, |canvas, row, at| {
        match lines[at] {
            Line::Family(name) => canvas.put(row, (0, 0), name, Role::Title),
            Line::Principle(index) => canvas.put(row, (2, 0), PRINCIPLES[index].name, Role::Text),
        };
    });
    let principle = &PRINCIPLES[tab.principle];
    let title = format!("{}, section {}", principle.name, principle.section);
    let inner = PaneFrame::new(title)
        .right(app.keymap.shown("<next-pane>: screening"))
        .draw(detail, canvas);
    let functions = principle.functions.join(", ");
    let presets: Vec<&str> =
        principle.preset.into_iter().chain(principle.see_also.iter().copied()).collect();
    let presets = presets.join(", ");
    let texts = [
        ("idea", principle.idea),
        ("functions", &functions),
        ("computed", principle.computed),
        ("presets", &presets),
    ];
    labelled(inner, texts, canvas);
}

fn screening(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.thesis;
    let pane =
        PaneFrame::new(app.keymap.shown("Screening matrix (Table 7.1), weights <left>/<right>"))
            .right(app.keymap.shown("<next-pane>: claims"))
            .focused(app.dialog.is_none());
    let inner = pane.draw(area, canvas);
    let places = rank(&tab.weights);
    // On a narrow screen every concept counts for more than the end of a criterion's name, which is in the message row.
    let (name, start, cell) = if inner.width < 78 { (11, 18, 5) } else { (22, 30, 6) };
    canvas.put(inner, (0, 0), "criterion", Role::Dim);
    canvas.put(inner, (name, 0), "weight", Role::Dim);
    for (index, concept) in CONCEPTS.iter().enumerate() {
        let column = start + cell * u16::try_from(index).unwrap_or(0);
        canvas.put(inner, (column + 1, 0), &initials(concept.name), Role::Dim);
    }
    let count = CRITERIA.len();
    let height = u16::try_from(count).unwrap_or(u16::MAX).min(inner.height.saturating_sub(1));
    let list = Rect { y: inner.y + 1, height, ..inner };
    let rows = RowList { count, selected: tab.criterion, painted: app.dialog.is_none() };
    let target = |row| Some(Target::Row(SCREENING, row));
    rows.render(canvas, list, target, |canvas, row, index| {
        canvas.put(row, (1, 0), &clip(CRITERIA[index], usize::from(name) - 1), Role::Text);
        let weight = format!("{} %", significant(tab.weights[index], 3));
        canvas.put(row, (name + 6 - columns(&weight).min(6), 0), &weight, Role::Text);
        for (at, concept) in CONCEPTS.iter().enumerate() {
            let column = start + cell * u16::try_from(at).unwrap_or(0);
            canvas.put(row, (column + 2, 0), &significant(concept.ratings[index], 2), Role::Text);
        }
    });
    for (y, label) in [(8, "total"), (9, "rank (printed)")] {
        canvas.put(inner, (0, y), label, Role::Title);
    }
    for place in &places {
        let column = start + cell * u16::try_from(place.concept).unwrap_or(0);
        canvas.put(inner, (column, 8), &format!("{:.2}", place.total), Role::Text);
        let concept = &CONCEPTS[place.concept];
        let printed = if cell > 5 {
            format!("{} ({})", place.rank, concept.rank)
        } else {
            format!("{}({})", place.rank, concept.rank)
        };
        let moved = place.rank != concept.rank;
        let role = if moved { Role::Warning } else { Role::Text };
        canvas.put(inner, (column, 9), &printed, role);
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
        canvas.put(inner, (1, y), &line, Role::Text);
    }
}

/// Two letters of the first word and one of the second: `EmF` for `Emergent four-bar`.
fn initials(name: &str) -> String {
    let mut words = name.split(' ');
    let first: String = words.next().unwrap_or_default().chars().take(2).collect();
    let second: String = words.next().unwrap_or_default().chars().take(1).collect();
    first + &second.to_uppercase()
}
