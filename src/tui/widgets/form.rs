//! Form: rows with values in a column, and the open field over the selected row.

use ratatui::layout::Rect;

use crate::tui::keymap::{Pane, Target};
use crate::tui::theme::Role;
use crate::tui::widgets::find::quantity_called;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::clip;
use crate::tui::widgets::text::columns;
use crate::tui::widgets::value_steps::Input;
use crate::tui::widgets::{Canvas, RowList, Rows, cycled};
use cmra_engine::model::variables::Variable;
use cmra_studies::study::quantities::{QUANTITIES, Quantity, named};

/// Columns within a row: cursor, label, value, unit.
const LABEL: u16 = 2;
const VALUE: u16 = 10;
/// Columns of a number.
pub(crate) const VALUE_WIDTH: u16 = 7;
const UNIT: u16 = VALUE + VALUE_WIDTH + 1;

/// Row of a form: label, value, initial text of the field, and meaning.
#[derive(Clone, Default)]
pub(crate) struct FormRow {
    pub label: String,
    /// Value at the right; empty if the label is the value.
    pub value: String,
    /// Unit after the value.
    pub unit: &'static str,
    /// Initial text of the field; `None` if Enter takes the next value.
    pub text: Option<String>,
    /// Meaning, for the message area.
    pub meaning: String,
    /// Quantity of the field; `None` for text.
    pub quantity: Option<FieldQuantity>,
    /// Role: title for headings, dim for values without an effect.
    pub role: Role,
}

/// Quantity of a field.
#[derive(Clone, Default)]
pub(crate) struct FieldQuantity {
    /// Unit of a bare number; empty for a pure number.
    pub unit: String,
    /// Variable displayed in this unit.
    pub variable: Option<&'static Variable>,
}

impl FormRow {
    pub(crate) fn heading(label: &str) -> Self {
        Self { role: Role::Title, ..Self::choice(label, "") }
    }

    /// Creates a row whose values are stepped through.
    pub(crate) fn choice(label: &str, value: impl Into<String>) -> Self {
        Self { label: label.to_owned(), value: value.into(), ..Self::default() }
    }

    pub(crate) fn switch(label: &str, on: bool) -> Self {
        let row = Self::choice(label, if on { "yes" } else { "no" });
        Self { role: if on { Role::Text } else { Role::Dim }, ..row }
    }

    pub(crate) fn typed(label: &str, value: impl Into<String>) -> Self {
        let row = Self::choice(label, value);
        Self { text: Some(row.value.clone()), ..row }
    }

    pub(crate) fn quantity(name: &str) -> Self {
        let title = named(name).map_or_else(|_| name.to_owned(), Quantity::title);
        Self { text: Some(title.clone()), ..Self::choice(&title, "") }.means(quantity_meaning(name))
    }

    pub(crate) fn means(self, meaning: impl Into<String>) -> Self {
        Self { meaning: meaning.into(), ..self }
    }

    fn is_heading(&self) -> bool {
        self.role == Role::Title
    }

    /// Returns the first column of the field.
    fn field(&self) -> u16 {
        if self.value.is_empty() { LABEL } else { VALUE }
    }

    fn draw(&self, area: Rect, canvas: &mut Canvas<'_>) {
        if self.is_heading() {
            canvas.put(area, (0, 0), &self.label, self.role);
            return;
        }
        let room = |start: u16| usize::from(area.width.saturating_sub(start));
        let label = canvas.put(area, (LABEL, 0), &clip(&self.label, room(LABEL)), self.role);
        // A long name moves the value to the right; a long value begins further left.
        let wide = columns(&self.value);
        let start = (VALUE + VALUE_WIDTH).saturating_sub(wide).max(VALUE);
        let start = start.min(area.width.saturating_sub(wide)).max(label + 1);
        let end = canvas.put(area, (start, 0), &clip(&self.value, room(start)), self.role);
        // A truncated unit would be another unit.
        if end < UNIT && UNIT + columns(self.unit) <= area.width {
            canvas.put(area, (UNIT, 0), self.unit, Role::Dim);
        }
    }
}

pub(crate) fn quantity_meaning(name: &str) -> String {
    named(name).map_or_else(
        |_| String::new(),
        |quantity| format!("{}: {}", quantity.title(), quantity.meaning),
    )
}

/// Returns the name of another quantity: the typed one, or the next one, cyclically.
pub(crate) fn quantity_after(name: &str, input: Input<'_>) -> Result<&'static str, String> {
    match input {
        Input::Text(text) => quantity_called(text).map(|quantity| quantity.name),
        Input::Step(press) => {
            let at = QUANTITIES.iter().position(|one| one.name == name).unwrap_or(0);
            Ok(QUANTITIES[cycled(at, press.by(), QUANTITIES.len())].name)
        }
    }
}

/// Setup of a study.
pub(crate) struct Form {
    /// Rows, headings included.
    lines: Vec<FormRow>,
    selected: usize,
}

impl Form {
    /// Creates a form from these rows with a selected row; selects the first if it does not exist.
    pub(crate) fn new<R: Copy + PartialEq>(
        rows: &[R],
        selected: R,
        line: impl Fn(R) -> FormRow,
    ) -> Self {
        let at = rows.iter().position(|row| *row == selected).unwrap_or(0);
        Self { lines: rows.iter().map(|row| line(*row)).collect(), selected: at }
    }

    pub(crate) fn line(&self) -> Option<&FormRow> {
        self.lines.get(self.selected)
    }

    /// Returns the number of selectable lines above a line.
    fn place(&self, line: usize) -> usize {
        self.lines[..line].iter().filter(|line| !line.is_heading()).count()
    }

    /// Returns the selectable rows for a number of visible lines.
    pub(crate) fn rows(&self, shown: usize) -> Rows {
        let (count, selected) = (self.place(self.lines.len()), self.place(self.selected));
        Rows { count, selected, shown }
    }

    /// Draws the form into a frame. If its pane has the focus (`on`), the selected row with its open field is kept visible.
    pub(crate) fn render(
        &self,
        (pane, on): (Pane, bool),
        field: Option<&TextField>,
        inner: Rect,
        canvas: &mut Canvas<'_>,
    ) {
        let field = field.filter(|_| on);
        let list = RowList {
            count: self.lines.len(),
            // Without the focus, show the beginning.
            selected: if on { self.selected } else { 0 },
            painted: on && field.is_none(),
        };
        let target =
            |at: usize| (!self.lines[at].is_heading()).then(|| Target::Row(pane, self.place(at)));
        list.render(canvas, inner, target, |canvas, row, at| {
            let line = &self.lines[at];
            line.draw(row, canvas);
            if on && at == self.selected {
                canvas.put(row, (0, 0), ">", Role::Title);
                if let Some(field) = field {
                    let room = row.width.saturating_sub(line.field() + 1);
                    field.draw_boxed(canvas, row, line.field(), room);
                }
            }
        });
    }
}
