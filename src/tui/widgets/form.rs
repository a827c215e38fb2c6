//! A form: rows with their values below each other, the field that is open over the selected one.

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::keymap::Pane;
use crate::tui::message::Target;
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::list::List;
use crate::tui::widgets::text::put;

/// The setup of a study.
pub(in crate::tui) struct Form<'a, R> {
    /// The pane it is in.
    pub pane: Pane,
    /// Its rows, headings included.
    pub rows: &'a [R],
    /// Those that can be selected.
    pub choices: &'a [R],
    /// The selected one.
    pub selected: R,
    /// The column in which the field of the selected row begins.
    pub field: u16,
}

impl<R: PartialEq> Form<'_, R> {
    /// Draw it; `draw` draws a row.
    pub(in crate::tui) fn render(
        &self,
        app: &App,
        area: Rect,
        canvas: &mut Canvas<'_>,
        draw: impl Fn(&mut Canvas<'_>, Rect, &R),
    ) {
        let on = app.pane() == self.pane;
        let frame = PaneFrame::new("Setup").right(if on { "" } else { "Tab" });
        let inner = frame.focused(app.has_focus(self.pane)).render(area, canvas, app.theme);
        canvas.pane(area, self.pane);
        // Without the keys it shows its beginning.
        let selected = self.rows.iter().position(|row| *row == self.selected).filter(|_| on);
        let field = app.field.as_ref().filter(|_| on);
        let list = List {
            count: self.rows.len(),
            selected: selected.unwrap_or(0),
            painted: on && field.is_none(),
        };
        let target = |at: usize| {
            let row = self.choices.iter().position(|row| *row == self.rows[at])?;
            Some(Target::Row(self.pane, row))
        };
        list.render(canvas, inner, app.theme, target, |canvas, line, at| {
            draw(canvas, line, &self.rows[at]);
            if selected == Some(at) {
                put(canvas, line, (0, 0), ">", app.theme.style(Role::Title));
                if let Some(field) = field {
                    let room = line.width.saturating_sub(self.field + 1);
                    field.draw_boxed(canvas, line, self.field, room, app.theme);
                }
            }
        });
    }
}
