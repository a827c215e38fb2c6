//! A form: rows with their values below each other, the field that is open over the selected one.

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

/// A row of a form: its label, its value, what its field opens with, and what it means.
#[derive(Clone, Default)]
pub(crate) struct FormRow {
    pub label: String,
    /// At the right; empty where the label is the value.
    pub value: String,
    /// After the value.
    pub unit: &'static str,
    /// The text that its field opens with; `None` where Enter takes the next value.
    pub text: Option<String>,
    /// Meaning, for the message area.
    pub meaning: String,
    /// Quantity of its field; `None` for text.
    pub quantity: Option<FieldQuantity>,
    /// Headings are titles; a value that has no effect at present is dim.
    pub role: Role,
}

/// The quantity that a field reads.
#[derive(Clone, Default)]
pub(crate) struct FieldQuantity {
    /// The unit of a bare number; empty for a pure number.
    pub unit: String,
    /// The variable that is shown in this unit.
    pub variable: Option<&'static Variable>,
}

impl FormRow {
    pub(crate) fn heading(label: &str) -> Self {
        Self { role: Role::Title, ..Self::choice(label, "") }
    }

    /// A row whose values are gone through.
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

    /// The column in which its field begins.
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
        // A long name moves its value to the right, a long value begins further left.
        let wide = columns(&self.value);
        let start = (VALUE + VALUE_WIDTH).saturating_sub(wide).max(VALUE);
        let start = start.min(area.width.saturating_sub(wide)).max(label + 1);
        let end = canvas.put(area, (start, 0), &clip(&self.value, room(start)), self.role);
        // Half a unit would be another one.
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

/// The name of another quantity: the one that was typed, or the next one, in a circle.
pub(crate) fn quantity_after(name: &str, input: Input<'_>) -> Result<&'static str, String> {
    match input {
        Input::Text(text) => quantity_called(text).map(|quantity| quantity.name),
        Input::Step(press) => {
            let at = QUANTITIES.iter().position(|one| one.name == name).unwrap_or(0);
            Ok(QUANTITIES[cycled(at, press.by(), QUANTITIES.len())].name)
        }
    }
}

/// The setup of a study.
pub(crate) struct Form {
    /// Rows, headings included.
    lines: Vec<FormRow>,
    selected: usize,
}

impl Form {
    /// A form of these rows with one of them selected, the first one where it is not among them.
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

    /// Draw it into a frame. Where its pane has the keys (`on`) it keeps the selected row in sight, with the field that is open.
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
            // Without the keys it shows its beginning.
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
