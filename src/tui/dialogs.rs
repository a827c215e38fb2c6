//! The dialogs on top of the panes: help, palette, preset picker, saving, exporting.

pub(crate) mod ask;
pub(crate) mod export;
pub(crate) mod help;
pub(crate) mod list;
pub mod options;
pub mod palette;
pub(crate) mod presets;

use std::path::Path;

use ratatui::widgets::{Clear, Widget};

use crate::tui::app::find::{rank, ranked};
use crate::tui::dialogs::export::Choices;
use crate::tui::keymap::{KeyHelp, LINES, Scope};
use crate::tui::message::PresetEntry;
use crate::tui::pages;
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;

#[derive(Clone, Debug)]
pub enum Dialog {
    List(List, Picker),
    /// A question that a text answers.
    Ask(Box<Ask>),
}

impl Dialog {
    /// The field that takes characters, if one does.
    pub fn field_mut(&mut self) -> Option<&mut TextField> {
        match self {
            Self::List(_, picker) => picker.typing.then_some(&mut picker.filter),
            Self::Ask(ask) => ask.field_mut(),
        }
    }
}

/// The dialog on top if it is the one that asked: meanwhile another one may have been opened.
pub(crate) fn asking(app: &mut App, is_it: impl FnOnce(&Ask, &Path) -> bool) -> Option<&mut Ask> {
    match &mut app.dialog {
        Some(Dialog::Ask(ask)) => Some(&mut **ask).filter(|ask| is_it(ask, &app.files.directory)),
        Some(Dialog::List(..)) | None => None,
    }
}

/// What an effect came to that a dialog asked for: it closes the dialog, or the reason why there is nothing stands in it.
pub(crate) fn answered<T>(
    app: &mut App,
    outcome: Result<T, String>,
    is_it: impl FnOnce(&Ask, &Path) -> bool,
) -> Option<T> {
    match (outcome, asking(app, is_it)) {
        (Ok(found), asked) => {
            if asked.is_some() {
                app.dialog = None;
            }
            return Some(found);
        }
        (Err(text), Some(ask)) => ask.text.error = Some(text),
        (Err(text), None) => app.refuse(text),
    }
    None
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum List {
    /// Keys, and what the selected variable means.
    Help,
    /// Every action by name.
    Palette,
    Presets,
    /// The words the selected variable can be.
    Words,
    Options,
}

impl List {
    pub fn at(self, selected: usize) -> Dialog {
        Dialog::List(self, Picker { selected, ..Picker::default() })
    }

    /// The dialog whose filter takes characters at once.
    pub fn typing(self) -> Dialog {
        Dialog::List(self, Picker { typing: true, ..Picker::default() })
    }
}

/// The state of a list with a filter.
#[derive(Clone, Debug, Default)]
pub struct Picker {
    pub filter: TextField,
    /// Characters go into the filter.
    pub typing: bool,
    /// The selected row of those that pass the filter.
    pub selected: usize,
    /// A row was chosen by moving to it, not only by what was typed.
    pub moved: bool,
}

/// A dialog for a text, a preset's name or a path, and for what is chosen beside it.
#[derive(Clone, Debug)]
pub struct Ask {
    pub purpose: Purpose,
    pub text: TextField,
    /// A preset or file of this name exists: the answer to "overwrite?" is awaited.
    pub question: bool,
    /// Names that complete the path.
    pub completions: Vec<String>,
    pub choices: Choices,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The name to save the scene under.
    Preset,
    /// The file to write runs to.
    Runs,
    /// The file to write the page's table to; what the table is.
    Table(&'static str),
    /// The file that has a spring's measured curve.
    Curve,
}

/// The one by this many places further on, round and round.
pub(crate) fn around<T: Copy + PartialEq>(all: &[T], one: T, by: isize) -> T {
    let at = all.iter().position(|other| *other == one).unwrap_or(0);
    all[wrap(at, by, all.len())]
}

/// `at` moved by `by` within `0..count`, round and round.
pub fn wrap(at: usize, by: isize, count: usize) -> usize {
    let count = isize::try_from(count.max(1)).unwrap_or(1);
    let at = isize::try_from(at).unwrap_or(0);
    usize::try_from((at + by).rem_euclid(count)).unwrap_or(0)
}

#[derive(Clone, Debug)]
pub struct HelpRow {
    pub keys: String,
    /// The pane they belong to; empty where they work everywhere.
    pub pane: &'static str,
    pub help: String,
    /// The action of Enter.
    pub action: Action,
}

/// What help lists: the keys of the focused pane first, with what they do there, then those that work everywhere.
pub fn help_rows(app: &App, typed: &str) -> Vec<HelpRow> {
    let pane = pages::spec(app.pane());
    let has = |line: &KeyHelp, action| line.keys.iter().any(|(one, ..)| *one == action);
    let own = pane.keys.iter().map(|row| {
        // A line of keys that the pane explains itself is listed there only.
        let of_row = |line: &&KeyHelp| line.scope != Scope::Everywhere && has(line, row.action);
        let line = LINES.iter().find(of_row).map(|line| app.keymap.line_label(line));
        HelpRow {
            keys: line.unwrap_or_else(|| app.keymap.label(row.action)),
            pane: pane.label,
            help: app.keymap.shown(row.help),
            action: row.action,
        }
    });
    let lines = |everywhere: bool| {
        let explained = move |line: &KeyHelp| pane.keys.iter().any(|row| has(line, row.action));
        let scoped = move |line: &&KeyHelp| match line.scope {
            Scope::Everywhere => everywhere,
            Scope::With(_) | Scope::Listed => !everywhere && !explained(line),
        };
        let label = if everywhere { "" } else { pane.label };
        LINES.iter().filter(|line| line.works_in(pane)).filter(scoped).map(move |line| HelpRow {
            keys: app.keymap.line_label(line),
            pane: label,
            help: app.keymap.shown(line.meaning),
            action: line.keys[0].0,
        })
    };
    let rows = own.chain(lines(false)).chain(lines(true));
    let works = rows.filter(|row| !pages::of(app.tab).is_idle(app, row.action));
    ranked(works, |row| rank(typed, &[&row.keys], &row.help))
}

/// The presets that match, best first; all of them in their order when nothing is typed.
pub fn preset_rows<'a>(presets: &'a [PresetEntry], typed: &str) -> Vec<&'a PresetEntry> {
    ranked(presets.iter(), |entry| rank(typed, &[&entry.name, entry.origin], &entry.scene.title))
}

pub(crate) fn render(app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
    match &app.dialog {
        Some(Dialog::List(list, picker)) => {
            let draw = match list {
                List::Help => help::help,
                List::Palette => help::palette,
                List::Presets => presets::render,
                List::Options => options::render,
                List::Words => list::words,
            };
            draw(app, picker, screen, canvas);
        }
        Some(Dialog::Ask(state)) => ask::render(app, state, screen, canvas),
        None => {}
    }
}

/// Clear the middle of the body and draw a frame there, at most this large; gives what is inside, a column of air at each side.
pub(crate) fn frame(
    screen: Rect,
    (width, height): (u16, u16),
    pane: PaneFrame<'_>,
    canvas: &mut Canvas<'_>,
) -> Rect {
    // Title row above, message, status and keys below stay in sight.
    let body = Rect {
        y: screen.y + screen.height.min(1),
        height: screen.height.saturating_sub(4),
        ..screen
    };
    let width = width.min(body.width);
    let height = height.min(body.height);
    let area = Rect {
        x: body.x + (body.width - width) / 2,
        y: body.y + (body.height - height) / 2,
        width,
        height,
    };
    canvas.cover(area);
    Clear.render(area, canvas);
    let inner = pane.focused(true).draw(area, canvas);
    Rect { x: inner.x + inner.width.min(1), width: inner.width.saturating_sub(2), ..inner }
}

/// The filter of a list in the first row of an area: `/gam_`, or how to search.
pub(crate) fn filter(picker: &Picker, area: Rect, canvas: &mut Canvas<'_>) {
    if picker.typing {
        let end = canvas.put(area, (0, 0), "> ", Role::Key);
        let room = area.width.saturating_sub(end);
        picker.filter.draw(canvas, Rect { x: area.x + end, width: room, ..area });
    } else {
        canvas.put(area, (0, 0), "/ to search", Role::Dim);
    }
}
