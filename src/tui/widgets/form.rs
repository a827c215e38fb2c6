//! A form: rows with their values below each other, the field that is open over the selected one.

use ratatui::layout::Rect;

use crate::study::quantities::{QUANTITIES, Quantity, named};
use crate::tui::app::App;
use crate::tui::app::status::clip;
use crate::tui::dialogs::wrap;
use crate::tui::keymap::Pane;
use crate::tui::message::Target;
use crate::tui::pages::Rows;
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::list::List;
use crate::tui::widgets::text::{columns, put};

/// Columns within a row: cursor, `*`, label, value, unit.
const LABEL: u16 = 2;
const VALUE: u16 = 10;
/// Columns of a number.
pub(in crate::tui) const VALUE_WIDTH: u16 = 7;
const UNIT: u16 = VALUE + VALUE_WIDTH + 1;

/// What a row shows, and how it is meant.
pub(in crate::tui) struct Line {
    /// At the left.
    pub label: String,
    /// At the right; empty where the label is the value.
    pub value: String,
    /// After the value.
    pub unit: &'static str,
    /// The text that its field opens with; `None` where Enter takes the next value.
    pub text: Option<String>,
    /// What it means, for the message area.
    pub meaning: String,
    /// Its field takes a number with a unit.
    pub takes_unit: bool,
    /// It differs from the preset.
    pub is_changed: bool,
    /// Headings are titles; what does not count as it is is dim.
    pub role: Role,
}

impl Line {
    /// A heading.
    pub(in crate::tui) fn heading(label: &str) -> Self {
        Self { role: Role::Title, ..Self::word(label, "") }
    }

    /// A row whose values are gone through.
    pub(in crate::tui) fn word(label: &str, value: impl Into<String>) -> Self {
        Self {
            label: label.to_owned(),
            value: value.into(),
            unit: "",
            text: None,
            meaning: String::new(),
            takes_unit: false,
            is_changed: false,
            role: Role::Text,
        }
    }

    /// A row that is switched on and off.
    pub(in crate::tui) fn switch(label: &str, on: bool) -> Self {
        let row = Self::word(label, if on { "yes" } else { "no" });
        Self { role: if on { Role::Text } else { Role::Dim }, ..row }
    }

    /// A row whose value is typed.
    pub(in crate::tui) fn typed(label: &str, value: impl Into<String>) -> Self {
        let row = Self::word(label, value);
        Self { text: Some(row.value.clone()), ..row }
    }

    /// A row that chooses a quantity.
    pub(in crate::tui) fn quantity(name: &str) -> Self {
        let title = named(name).map_or_else(|_| name.to_owned(), Quantity::title);
        Self { text: Some(title.clone()), ..Self::word(&title, "") }.means(quantity_meaning(name))
    }

    /// The same with what it means.
    pub(in crate::tui) fn means(self, meaning: impl Into<String>) -> Self {
        Self { meaning: meaning.into(), ..self }
    }

    fn is_heading(&self) -> bool {
        self.role == Role::Title
    }

    /// The column in which its field begins.
    fn field(&self) -> u16 {
        if self.value.is_empty() { LABEL } else { VALUE }
    }

    fn draw(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let style = |role| app.theme.style(role);
        if self.is_heading() {
            put(canvas, area, (0, 0), &self.label, style(self.role));
            return;
        }
        if self.is_changed {
            put(canvas, area, (1, 0), "*", style(Role::Note));
        }
        let room = |start: u16| usize::from(area.width.saturating_sub(start));
        let label =
            put(canvas, area, (LABEL, 0), &clip(&self.label, room(LABEL)), style(self.role));
        // A long name moves its value to the right, a long value begins further left.
        let wide = columns(&self.value);
        let start = (VALUE + VALUE_WIDTH).saturating_sub(wide).max(VALUE);
        let start = start.min(area.width.saturating_sub(wide)).max(label + 1);
        let end = put(canvas, area, (start, 0), &clip(&self.value, room(start)), style(self.role));
        // Half a unit would be another one.
        if end < UNIT && UNIT + columns(self.unit) <= area.width {
            put(canvas, area, (UNIT, 0), self.unit, style(Role::Dim));
        }
    }
}

/// What a quantity is.
pub(in crate::tui) fn quantity_meaning(name: &str) -> String {
    named(name).map_or_else(
        |_| String::new(),
        |quantity| format!("{}: {}", quantity.title(), quantity.meaning),
    )
}

/// The name of the quantity so many after another one, in a circle.
pub(in crate::tui) fn quantity_beside(name: &str, by: isize) -> &'static str {
    let at = QUANTITIES.iter().position(|one| one.name == name).unwrap_or(0);
    QUANTITIES[wrap(at, by, QUANTITIES.len())].name
}

/// The setup of a study.
pub(in crate::tui) struct Form {
    /// Its rows, headings included.
    lines: Vec<Line>,
    /// Which of them is selected.
    selected: usize,
}

impl Form {
    /// A form of these rows with one of them selected, the first one where it is not among them.
    pub(in crate::tui) fn new<R: Copy + PartialEq>(
        rows: &[R],
        selected: R,
        line: impl Fn(R) -> Line,
    ) -> Self {
        let at = rows.iter().position(|row| *row == selected).unwrap_or(0);
        Self { lines: rows.iter().map(|row| line(*row)).collect(), selected: at }
    }

    /// The rows that can be selected.
    fn choices(&self) -> impl Iterator<Item = &Line> {
        self.lines.iter().filter(|line| !line.is_heading())
    }

    /// The selected row.
    pub(in crate::tui) fn line(&self) -> Option<&Line> {
        self.lines.get(self.selected)
    }

    /// A row of those that can be selected.
    pub(in crate::tui) fn row(&self, row: usize) -> Option<&Line> {
        self.choices().nth(row)
    }

    /// Of a line, its place among those that can be selected.
    fn place(&self, line: usize) -> usize {
        self.lines[..line].iter().filter(|line| !line.is_heading()).count()
    }

    /// Those that can be selected, where so many are shown.
    pub(in crate::tui) fn rows(&self, shown: usize) -> Rows {
        Rows { count: self.choices().count(), selected: self.place(self.selected), shown }
    }

    /// Draw it as the setup that is a pane.
    pub(in crate::tui) fn render(
        &self,
        app: &App,
        pane: Pane,
        area: Rect,
        canvas: &mut Canvas<'_>,
    ) {
        let on = app.pane() == pane;
        let frame = PaneFrame::new("Setup").right(if on { "" } else { "Tab" });
        let inner = frame.focused(app.has_focus(pane)).render(area, canvas, app.theme);
        canvas.pane(area, pane);
        let field = app.field.as_ref().filter(|_| on);
        let list = List {
            count: self.lines.len(),
            // Without the keys it shows its beginning.
            selected: if on { self.selected } else { 0 },
            painted: on && field.is_none(),
        };
        let target =
            |at: usize| (!self.lines[at].is_heading()).then(|| Target::Row(pane, self.place(at)));
        list.render(canvas, inner, app.theme, target, |canvas, row, at| {
            let line = &self.lines[at];
            line.draw(app, row, canvas);
            if on && at == self.selected {
                put(canvas, row, (0, 0), ">", app.theme.style(Role::Title));
                if let Some(field) = field {
                    let room = row.width.saturating_sub(line.field() + 1);
                    field.draw_boxed(canvas, row, line.field(), room, app.theme);
                }
            }
        });
    }
}
