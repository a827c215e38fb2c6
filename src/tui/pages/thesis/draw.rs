//! Draws the Thesis tab: claims with the selected one in full, principles with what serves them, the concepts' ratings.

use crate::study::principles::{CONCEPTS, CRITERIA, PRINCIPLES};
use crate::study::thesis::ClaimVerdict;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::thesis::state;
use crate::tui::widgets::table::{NO_MATCH, filtered};
use crate::worker::studies::Claims;

/// From this width on the detail stands beside the list.
const BESIDE: u16 = 110;
/// Columns of a claim's place in the list, at most; a third of a narrow list.
const PLACE: u16 = 25;
const LABEL: u16 = 12;

pub(crate) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    match app.pane() {
        state::CLAIMS => claims(app, area, canvas),
        state::PRINCIPLES => principles(app, area, canvas),
        _ => concepts(app, area, canvas),
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
        ClaimVerdict::Reproduced => Role::Text,
        ClaimVerdict::Corrected | ClaimVerdict::Misprint => Role::Warning,
        ClaimVerdict::NotReproduced => Role::Error,
    }
}

fn claims(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.thesis;
    let (list, detail) = split(area, 11);
    let shown = app.claims();
    let count = format!("{} of {}", shown.len(), tab.rows().len());
    let title = filtered("Claims of the thesis", &tab.find);
    let pane = PaneFrame::new(title).right(count).focused(app.dialog.is_none());
    let inner = pane.draw(list, canvas);
    if shown.is_empty() {
        let text = match tab.rows() {
            [] => nothing::<Claims>(app, "checking the first claims", None),
            _ => app.keymap.shown(NO_MATCH),
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
    let target = |line: usize| Some(Target::Row(state::CLAIMS, lines[line].0));
    rows.render(canvas, inner, target, |canvas, line, at| {
        let (index, is_first, part) = &lines[at];
        let row = shown[*index];
        let role = role(row.claim.verdict);
        if *is_first {
            canvas.put(line, (0, 0), &row.claim.verdict.letter().to_string(), role);
            let place = clip(row.claim.place, usize::from(says.saturating_sub(3)));
            canvas.put(line, (2, 0), &place, role);
        }
        canvas.put(line, (says, 0), part, role);
        if *index == tab.selected && app.dialog.is_none() {
            canvas.paint_row(line);
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
        let verdict = row.claim.verdict;
        let verdict = format!("{} {}", verdict.letter(), verdict.words());
        let texts = [
            ("says", row.claim.says),
            ("computed", &row.computed),
            ("as printed", &row.as_printed),
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

/// A letter for each function of Table 5.1; the title explains them.
const FUNCTIONS: [(char, &str); 4] = [
    ('O', "armor plate orientation"),
    ('A', "accelerated elements"),
    ('S', "controlled stiffness"),
    ('L', "lateral array"),
];
const LEGEND: &str = "O orientation, A acceleration, S stiffness, L lateral";

fn principles(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let pane = PaneFrame::new(LEGEND)
        .right(app.keymap.shown("<next-pane>: concepts"))
        .focused(app.dialog.is_none());
    let inner = pane.draw(area, canvas);
    let (mut y, mut family) = (0, "");
    for principle in PRINCIPLES {
        if principle.family != family {
            family = principle.family;
            canvas.put(inner, (0, y), family, Role::Title);
            y += 1;
        }
        canvas.put(inner, (1, y), principle.name, Role::Text);
        for (column, (letter, function)) in (47..).step_by(3).zip(FUNCTIONS) {
            if principle.functions.contains(&function) {
                canvas.put(inner, (column, y), &letter.to_string(), Role::Text);
            }
        }
        y += 1;
    }
}

fn concepts(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let pane = PaneFrame::new("Ratings of the concepts, 3 is the reference (Table 7.1)")
        .right(app.keymap.shown("<next-pane>: claims"))
        .focused(app.dialog.is_none());
    let inner = pane.draw(area, canvas);
    // A narrow screen cuts the ends of the criteria's names.
    let (name, cell) = if inner.width < 78 { (11, 5) } else { (22, 6) };
    let put = |canvas: &mut Canvas<'_>, y: u16, label: &str, weight: &str, cells: [String; 8]| {
        canvas.put(inner, (0, y), &clip(label, usize::from(name) - 1), Role::Text);
        canvas.put(inner, (name, y), weight, Role::Text);
        for (column, text) in (name + 7..).step_by(cell).zip(cells) {
            canvas.put(inner, (column, y), &text, Role::Text);
        }
    };
    put(canvas, 0, "criterion", "weight", CONCEPTS.map(|it| initials(it.name)));
    for (y, (at, (criterion, weight))) in (1..).zip(CRITERIA.iter().enumerate()) {
        let ratings = CONCEPTS.map(|it| significant(it.ratings[at], 2));
        put(canvas, y, criterion, &format!("{weight:>3} %"), ratings);
    }
    put(canvas, 8, "total", "", CONCEPTS.map(|it| format!("{:.2}", it.total)));
    put(canvas, 9, "rank", "", CONCEPTS.map(|it| it.rank.to_string()));
    for (y, it) in (11..inner.height).zip(CONCEPTS) {
        let line = format!("{}  {}", initials(it.name), it.name);
        canvas.put(inner, (0, y), &line, Role::Dim);
    }
}

/// Two letters of the first word and one of the second: `EmF` for `Emergent four-bar`.
fn initials(name: &str) -> String {
    let mut words = name.split(' ');
    let first: String = words.next().unwrap_or_default().chars().take(2).collect();
    let second: String = words.next().unwrap_or_default().chars().take(1).collect();
    first + &second.to_uppercase()
}
