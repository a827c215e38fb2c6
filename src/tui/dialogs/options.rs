//! The options menu: characters, colours and mouse.

use cmra_studies::enumeration;

use crate::tui::app::dialog::{Dialog, Outcome};
use crate::tui::dialogs::list::{List, Picker, frame, listed};
use crate::tui::prelude::*;
use crate::tui::widgets::text::wrapped;

enumeration! {
    /// A line of the menu.
    enum OptionRow in OptionText {
        name: &'static str,
        meaning: &'static str,
    }
    Characters {
        name: "characters", meaning: "what charts are drawn with: ASCII, blocks or braille dots"
    }
    Colours { name: "colours", meaning: "how many colours the terminal shows" }
    Mouse {
        name: "mouse",
        meaning: "on: a click selects, the wheel moves; off: the terminal selects text"
    }
}

pub(super) fn open(_: &mut App) -> Box<dyn Dialog> {
    listed(Options, 0)
}

#[derive(Debug)]
struct Options;

/// Where the values begin.
const VALUE: u16 = 18;

impl List for Options {
    const OPENED_BY: Action = Action::Options;
    const IS_FILTERED: bool = false;
    const FOOTER: &'static str = "<enter> change  <down>/<up> move  <back> close";

    fn count(&self, _: &App, _: &str) -> usize {
        OptionRow::ALL.len()
    }

    fn chosen(&mut self, app: &mut App, picker: &Picker) -> Outcome {
        change(app, OptionRow::ALL[picker.selected]);
        Outcome::Stays
    }

    fn draw(&self, app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
        let count = OptionRow::ALL.len();
        let rows = u16::try_from(count).unwrap_or(u16::MAX);
        let inner = frame(screen, (58, rows + 6), PaneFrame::new("Options"), canvas);
        let area = Rect { height: rows.min(inner.height), ..inner };
        picker.draw_rows(count, area, canvas, |canvas, row, index| {
            let option = OptionRow::ALL[index];
            canvas.put(row, (1, 0), option.name(), Role::Text);
            canvas.put(row, (VALUE, 0), &format!("< {} >", value(option, app)), Role::Title);
        });
        let meaning = OptionRow::ALL.get(picker.selected).map_or("", |row| row.meaning());
        let meaning = &app.keymap.shown(meaning);
        let below = Rect { x: inner.x + 1, width: inner.width.saturating_sub(2), ..inner };
        canvas.put_lines(below, rows + 1, wrapped(meaning, below.width, Role::Dim));
    }
}

/// The present value of an option.
fn value(row: OptionRow, app: &App) -> &'static str {
    match row {
        OptionRow::Characters => app.settings.theme.glyphs.word(),
        OptionRow::Colours => app.settings.theme.depth.word(),
        OptionRow::Mouse => {
            if app.settings.mouse {
                "on"
            } else {
                "off"
            }
        }
    }
}

/// Take the next value of an option.
fn change(app: &mut App, row: OptionRow) {
    let settings = &mut app.settings;
    match row {
        OptionRow::Characters => settings.theme.glyphs = settings.theme.glyphs.next(),
        OptionRow::Colours => settings.theme.depth = settings.theme.depth.next(),
        OptionRow::Mouse => {
            settings.mouse = !settings.mouse;
            let mouse = Effect::Mouse(settings.mouse);
            app.request(mouse);
        }
    }
    app.request(Effect::SaveSession);
}
