//! List dialogs with a filter text.

use std::fmt::Debug;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::layout::Constraint;
use ratatui::widgets::{Clear, Widget};

use crate::tui::app::dialog::{Dialog, Outcome};
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::{RowList, rows_moved};

/// Rows of a page movement in a list.
const PAGE: usize = 11;

/// State of a list dialog.
#[derive(Debug, Default)]
pub(crate) struct Picker {
    pub filter: TextField,
    /// Selected row, among the rows that match the filter.
    pub selected: usize,
    /// Whether the user moved to the row, instead of only filtering.
    pub moved: bool,
}

/// Content of a list dialog.
pub(crate) trait List: Debug + 'static {
    /// Action that opens the dialog; its key also closes it.
    const OPENED_BY: Action;
    /// Whether typed characters filter the rows.
    const IS_FILTERED: bool;
    const FOOTER: &'static str;

    /// Returns the number of rows that match the filter.
    fn count(&self, app: &App, typed: &str) -> usize;

    /// Handles Enter on the selected row.
    fn chosen(&mut self, app: &mut App, picker: &Picker) -> Outcome;

    fn draw(&self, app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>);
}

/// Dialog of a list.
#[derive(Debug)]
struct Listed<L> {
    list: L,
    picker: Picker,
}

/// Creates a list dialog with a selected row.
pub(crate) fn listed<L: List>(list: L, selected: usize) -> Box<dyn Dialog> {
    Box::new(Listed { list, picker: Picker { selected, ..Picker::default() } })
}

impl<L: List> Dialog for Listed<L> {
    fn footer(&self) -> &'static str {
        L::FOOTER
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        let (list, picker) = (&mut self.list, &mut self.picker);
        let action = app.keymap.action(key).filter(|_| !(L::IS_FILTERED && is_text(key)));
        // Within a text, these keys move the cursor of the field.
        let moves =
            action.filter(|it| !(L::IS_FILTERED && matches!(it, Action::First | Action::Last)));
        if let Some(by) = moves.and_then(|action| rows_moved(action, PAGE)) {
            let last = list.count(app, picker.filter.value()).saturating_sub(1);
            picker.selected = picker.selected.saturating_add_signed(by).min(last);
            picker.moved = true;
            return Outcome::Stays;
        }
        match action {
            Some(Action::Enter) => list.chosen(app, picker),
            Some(Action::Back | Action::Quit) => Outcome::Closes,
            Some(action) if action == L::OPENED_BY => Outcome::Closes,
            _ => {
                if L::IS_FILTERED && picker.filter.press(key) {
                    picker.begin();
                }
                Outcome::Stays
            }
        }
    }

    fn click(&mut self, row: usize) {
        (self.picker.selected, self.picker.moved) = (row, true);
    }

    fn paste(&mut self, text: &str) -> bool {
        if L::IS_FILTERED {
            self.picker.filter.insert(text);
            self.picker.begin();
        }
        L::IS_FILTERED
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        self.list.draw(app, &self.picker, screen, canvas);
    }
}

/// Returns `true` if a key is a character of a text.
pub(crate) fn is_text(key: KeyEvent) -> bool {
    matches!(key.code, KeyCode::Char(_))
        && !key.modifiers.intersects(KeyModifiers::CONTROL | KeyModifiers::ALT)
}

impl Picker {
    /// Resets the selection after a change of the filter.
    fn begin(&mut self) {
        (self.selected, self.moved) = (0, false);
    }

    /// Draws the filter in the first row of an area.
    pub(crate) fn draw_filter(&self, area: Rect, canvas: &mut Canvas<'_>) {
        let end = canvas.put(area, (0, 0), "> ", Role::Key);
        let room = area.width.saturating_sub(end);
        self.filter.draw(canvas, Rect { x: area.x + end, width: room, ..area });
    }

    /// Draws the rows of the list, each by its index.
    pub(crate) fn draw_rows(
        &self,
        count: usize,
        area: Rect,
        canvas: &mut Canvas<'_>,
        draw: impl FnMut(&mut Canvas<'_>, Rect, usize),
    ) {
        let rows = RowList { count, selected: self.selected, painted: true };
        rows.render(canvas, area, |row| Some(Target::DialogRow(row)), draw);
    }
}

/// Clears the middle of the body and draws a frame there, at most this large; returns the area inside, with a blank column at each side.
pub(crate) fn frame(
    screen: Rect,
    (width, height): (u16, u16),
    pane: PaneFrame<'_>,
    canvas: &mut Canvas<'_>,
) -> Rect {
    // Keep the title row above, and message, status and keys below visible.
    let body = Rect {
        y: screen.y + screen.height.min(1),
        height: screen.height.saturating_sub(4),
        ..screen
    };
    let area = body.centered(Constraint::Max(width), Constraint::Max(height));
    canvas.cover();
    Clear.render(area, canvas);
    let inner = pane.focused(true).draw(area, canvas);
    Rect { x: inner.x + inner.width.min(1), width: inner.width.saturating_sub(2), ..inner }
}
