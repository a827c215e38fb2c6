//! Dialogs that are lists to choose from, with a text that filters them.

use std::fmt::Debug;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::widgets::{Clear, Widget};

use crate::tui::app::dialog::{Dialog, Footer, Outcome};
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::{RowList, rows_moved};

/// The rows of a page of a list.
const PAGE: usize = 11;

/// Where a person is in a list.
#[derive(Clone, Debug, Default)]
pub(crate) struct Picker {
    pub filter: TextField,
    /// Characters go into the filter.
    pub typing: bool,
    /// The selected row of those that pass the filter.
    pub selected: usize,
    /// A row was chosen by moving to it, not only by what was typed.
    pub moved: bool,
}

/// What a dialog lists.
pub(crate) trait List: Clone + Debug + 'static {
    /// The action that opens it, whose key closes it again.
    const OPENED_BY: Action;
    /// Its rows can be filtered by a text.
    const IS_FILTERED: bool;

    fn footer(&self, typing: bool) -> Footer;

    /// How many rows match what was typed.
    fn count(&self, app: &App, typed: &str) -> usize;

    /// What Enter does with the selected row.
    fn chosen(&mut self, app: &mut App, picker: &Picker) -> Outcome;

    /// What another action does, where it does something.
    fn act(&mut self, _app: &mut App, _picker: &Picker, _action: Action) -> Option<Outcome> {
        None
    }

    fn draw(&self, app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>);
}

/// A dialog of a list.
#[derive(Clone, Debug)]
pub(crate) struct Listed<L> {
    pub list: L,
    pub picker: Picker,
}

impl<L: List> Listed<L> {
    /// Open on a row.
    pub(crate) fn at(list: L, selected: usize) -> Box<dyn Dialog> {
        Box::new(Self { list, picker: Picker { selected, ..Picker::default() } })
    }

    /// Open with characters going into the filter.
    pub(crate) fn typing(list: L) -> Box<dyn Dialog> {
        Box::new(Self { list, picker: Picker { typing: true, ..Picker::default() } })
    }
}

impl<L: List> Dialog for Listed<L> {
    fn footer(&self) -> Footer {
        self.list.footer(self.picker.typing)
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        let (list, picker) = (&mut self.list, &mut self.picker);
        let action = app.keymap.action(key).filter(|_| !(picker.typing && is_text(key)));
        // Within a text, those keys move the cursor of the field.
        let moves =
            action.filter(|it| !(picker.typing && matches!(it, Action::First | Action::Last)));
        if let Some(by) = moves.and_then(|action| rows_moved(action, PAGE)) {
            let last = list.count(app, picker.filter.value()).saturating_sub(1);
            picker.selected = picker.selected.saturating_add_signed(by).min(last);
            picker.moved = true;
            return Outcome::Stays;
        }
        match action {
            Some(Action::Back | Action::Quit) => return Outcome::Closes,
            Some(action) if action == L::OPENED_BY && action != Action::Enter => {
                return Outcome::Closes;
            }
            Some(Action::Find) if L::IS_FILTERED => picker.typing = true,
            Some(Action::Enter) => return list.chosen(app, picker),
            action => {
                if let Some(outcome) = action.and_then(|action| list.act(app, picker, action)) {
                    return outcome;
                }
                if picker.typing && picker.filter.press(key) {
                    self.pasted();
                }
            }
        }
        Outcome::Stays
    }

    fn click(&mut self, app: &mut App, row: usize) -> Outcome {
        if self.picker.selected == row {
            return self.list.chosen(app, &self.picker);
        }
        (self.picker.selected, self.picker.moved) = (row, true);
        Outcome::Stays
    }

    fn closes_beside(&self) -> bool {
        true
    }

    fn field_mut(&mut self) -> Option<&mut TextField> {
        self.picker.typing.then_some(&mut self.picker.filter)
    }

    fn pasted(&mut self) {
        // What was selected may not be there any more.
        (self.picker.selected, self.picker.moved) = (0, false);
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        self.list.draw(app, &self.picker, screen, canvas);
    }
}

/// Whether a key is a character of a text.
pub(crate) fn is_text(key: KeyEvent) -> bool {
    matches!(key.code, KeyCode::Char(_))
        && !key.modifiers.intersects(KeyModifiers::CONTROL | KeyModifiers::ALT)
}

impl Picker {
    /// The filter in the first row of an area: what was typed, or how to search.
    pub(crate) fn draw_filter(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        if self.typing {
            let end = canvas.put(area, (0, 0), "> ", Role::Key);
            let room = area.width.saturating_sub(end);
            self.filter.draw(canvas, Rect { x: area.x + end, width: room, ..area });
        } else {
            canvas.put(area, (0, 0), &app.keymap.shown("<find> to search"), Role::Dim);
        }
    }

    /// Rows of the list, each drawn by its index.
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
