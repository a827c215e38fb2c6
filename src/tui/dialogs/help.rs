//! Help: meaning of the selected variable or the pane, then the keys of the pane, then the global keys.

use crate::tui::app::dialog::Outcome;
use crate::tui::dialogs::list::{List, Picker, frame};
use crate::tui::keymap::GLOBAL_KEYS;
use crate::tui::pages::limit::comparison::COMPARISON_WORDS;
use crate::tui::pages::limit::map::efficiency_map;
use crate::tui::pages::limit::{CANDIDATES, EFFICIENCY_MAP};
use crate::tui::pages::numerics::STIFF_SCENES;
use crate::tui::pages::numerics::stability::stiff_scenes_words;
use crate::tui::pages::page::pair;
use crate::tui::pages::{self, explore, run};
use crate::tui::prelude::*;
use crate::tui::widgets::split_top;
use crate::tui::widgets::text::{TextLine, clip, wrapped};
use cmra_engine::model::units::shortest;
use cmra_studies::report::compare::picture;

#[derive(Debug)]
pub(super) struct Help;

const SENTENCE: u16 = 15;

impl List for Help {
    const OPENED_BY: Action = Action::Help;
    const IS_FILTERED: bool = false;
    const FOOTER: &'static str = "<back> close  <down>/<up> move";

    fn count(&self, app: &App, _: &str) -> usize {
        rows(app).count()
    }

    fn chosen(&mut self, _: &mut App, _: &Picker) -> Outcome {
        Outcome::Closes
    }

    fn draw(&self, app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
        let title = format!("Keys of {}, then of every pane", pages::spec(app.pane()).label);
        let inner = frame(screen, (92, 48), PaneFrame::new(title), canvas);
        let about = about(app, inner);
        let (_, area) = split_top(inner, u16::try_from(about.len()).unwrap_or(u16::MAX));
        canvas.put_lines(inner, 0, about);
        let rows: Vec<_> = rows(app).collect();
        let room = usize::from(area.width.saturating_sub(SENTENCE));
        picker.draw_rows(rows.len(), area, canvas, |canvas, row, index| {
            let (keys, help, role) = &rows[index];
            canvas.put(row, (0, 0), &clip(keys, usize::from(SENTENCE) - 2), Role::Key);
            let help = app.keymap.shown(help);
            canvas.put(row, (SENTENCE, 0), &clip(&help, room), *role);
        });
    }
}

/// Iterates over keys with their meanings and roles: those of the focused pane first, then the global ones.
fn rows(app: &App) -> impl Iterator<Item = (String, &'static str, Role)> {
    let own = pages::spec(app.pane()).keys.iter();
    let own = own.map(|row| (pair(app, row.action), row.help, Role::Text));
    let everywhere = GLOBAL_KEYS.iter();
    own.chain(everywhere.map(|line| (app.keymap.line_label(line), line.meaning, Role::Dim)))
}

/// Explanation of the labels and signs of the Run tab.
const RUN_WORDS: &str = "%: of the depth on a rigid mount. plastic: depth (%) if the interface can yield. travel: greatest plate \
    displacement. peak: contact force. mount: force of spring, damper and stop. a, b: events, which Log names. !: outside the model's \
    validity; see Log. error: estimated, of the depth, relative; and the run time. omitted: what this scene need not compute";
/// Minimum rows for keys below the explanation.
const KEY_ROWS: usize = 5;

/// Explains the labels and signs of the focused pane; on Run the selected variable comes first.
fn about(app: &App, Rect { width, height, .. }: Rect) -> Vec<TextLine> {
    let is_run = matches!(app.pane(), run::VARIABLES | run::CHARTS | run::RUNS);
    let words = match app.pane() {
        CANDIDATES => COMPARISON_WORDS.to_owned(),
        EFFICIENCY_MAP => efficiency_letters(app),
        STIFF_SCENES => stiff_scenes_words(),
        explore::RESULTS => comment(app),
        _ if is_run => RUN_WORDS.to_owned(),
        _ => return Vec::new(),
    };
    if words.is_empty() {
        return Vec::new();
    }
    let mut lines = if app.pane() == run::VARIABLES { variable(app, width) } else { Vec::new() };
    let paragraphs = words.split("\n\n").map(|it| it.replace('\n', " "));
    let words: Vec<TextLine> =
        paragraphs.flat_map(|it| wrapped(&it, width, Role::Text).collect::<Vec<_>>()).collect();
    if !is_run || lines.len() + words.len() + 1 + KEY_ROWS < usize::from(height) {
        lines.extend(words);
        lines.push((String::new(), Role::Text));
    }
    lines
}

/// Returns the meaning of every letter on the map of mass efficiency, of which its legend may have no room for all.
fn efficiency_letters(app: &App) -> String {
    let map = efficiency_map(app).and_then(picture);
    let marks = map.iter().flat_map(|map| &map.marks);
    marks.map(ToString::to_string).collect::<Vec<_>>().join("\n\n")
}

/// Returns the comment of the scene's preset: source and expected result.
fn comment(app: &App) -> String {
    let entry = app.files.presets.iter().find(|entry| entry.name == app.base.name);
    let text = entry.map_or("", |entry| &*entry.comment);
    if text.is_empty() { String::new() } else { format!("{}: {text}", app.base.name) }
}

/// Describes the selected variable: meaning, allowed values, range and source.
fn variable(app: &App, width: u16) -> Vec<TextLine> {
    let variable = app.pages.run.editor.variable();
    let mut lines = vec![(format!("{}  {}", variable.symbol, variable.key), Role::Title)];
    let mut text = |text: String| {
        let indented = wrapped(&text, width.saturating_sub(2), Role::Text);
        lines.extend(indented.map(|(line, role)| (format!("  {line}"), role)));
    };
    text(variable.meaning.to_owned());
    let range = variable.thesis_range.map_or_else(String::new, |(low, high)| {
        let (low, high) = (shortest(low), shortest(high));
        format!("; the thesis searched {low} to {high} (Table 9.2, T9.2)")
    });
    text(format!("now {}; allowed: {}{range}", variable.show(&app.scene), variable.allowed()));
    text(format!("default: {}", variable.source));
    lines.push((String::new(), Role::Text));
    lines
}
