//! One-line fields: what is typed or pasted into them, what ends them, and how they are drawn.

use crossterm::event::{Event, KeyCode, KeyEvent, KeyModifiers};
use tui_input::backend::crossterm::to_input_request;
use tui_input::{Input, InputRequest};

use crate::tui::prelude::*;
use crate::tui::widgets::text::window;

/// No field of the workbench takes a longer text: characters that are not typed on purpose (a paste that came as keys, a book on
/// the keyboard) are dropped.
pub(crate) const TEXT_MAX: usize = 1024;

#[derive(Clone, Debug, Default)]
pub struct TextField {
    pub input: Input,
    /// The whole text is selected: the first character replaces it.
    pub all_selected: bool,
    /// Why the text is refused.
    pub error: Option<String>,
}

impl TextField {
    /// A field with a text and the cursor behind it.
    pub fn new(text: impl Into<String>) -> Self {
        Self { input: Input::new(text.into()), ..Self::default() }
    }

    pub fn selected(text: impl Into<String>) -> Self {
        Self { all_selected: true, ..Self::new(text) }
    }

    pub fn value(&self) -> &str {
        self.input.value()
    }

    /// Put a key into the field; whether it was one for a field.
    pub fn press(&mut self, key: KeyEvent) -> bool {
        let is_control = matches!(key.code, KeyCode::Char(c) if c.is_control());
        let request = to_input_request(&Event::Key(key)).filter(|_| !is_control);
        let Some(request) = request else { return false };
        let replaces = matches!(
            request,
            InputRequest::InsertChar(_)
                | InputRequest::DeletePrevChar
                | InputRequest::DeleteNextChar
        );
        if self.all_selected && replaces {
            self.input.reset();
        }
        self.all_selected = false;
        let adds = matches!(request, InputRequest::InsertChar(_));
        if !adds || self.value().chars().count() < TEXT_MAX {
            self.input.handle(request);
        }
        self.error = None;
        true
    }

    /// Put a text into the field, as if it had been typed.
    pub fn insert(&mut self, text: &str) {
        for c in text.chars() {
            self.press(KeyEvent::new(KeyCode::Char(c), KeyModifiers::NONE));
        }
    }

    pub(crate) fn draw(&self, canvas: &mut Canvas<'_>, area: Rect) {
        let (shown, at) = window(&self.input, area.width);
        let role = match (self.error.is_some(), self.all_selected) {
            (true, _) => Role::Error,
            (false, true) => Role::Selection,
            (false, false) => Role::Text,
        };
        canvas.put(area, (0, 0), &shown, role);
        canvas.cursor = Some((area.x + at, area.y));
    }
}

#[derive(Clone, Debug)]
pub struct Field {
    pub row: usize,
    pub text: TextField,
}

impl Field {
    /// The field of a row, its old text selected.
    pub fn new(row: usize, text: impl Into<String>) -> Self {
        Self { row, text: TextField::selected(text) }
    }

    /// Draw the field over its row as `[ 1.25_  ]`, from a column on, with room for a given number of characters.
    pub(crate) fn draw_boxed(&self, canvas: &mut Canvas<'_>, row: Rect, start: u16, room: u16) {
        let blank = " ".repeat(usize::from(room));
        canvas.put(row, (start, 0), &blank, Role::Text);
        canvas.put(row, (start - 1, 0), "[", Role::Focus);
        let area = Rect { x: row.x + start, width: room, ..row };
        self.text.draw(canvas, area.intersection(row));
        canvas.put(row, (start + room, 0), "]", Role::Focus);
        if self.text.error.is_some() {
            canvas.put(row, (0, 0), "x", Role::Error);
        }
    }
}
