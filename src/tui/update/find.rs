//! `/`: the field that finds in the pane that has the keys. A list that can be filtered shows only what matches; in other lists
//! the selection goes to the best match.

use crossterm::event::{KeyCode, KeyEvent};

use crate::tui::app::App;
use crate::tui::app::find::{rank, ranked};
use crate::tui::app::notice::Severity;
use crate::tui::message::Effect;
use crate::tui::pages;
use crate::tui::update::act;
use crate::tui::widgets::input::TextField;

/// Open the field, with the text the list is filtered by.
pub(in crate::tui) fn open(app: &mut App) {
    let page = pages::of(app.tab);
    let filter = page.filter(app).map(|filter| filter.clone());
    let names = page.row_name(app, 0).map(|_| String::new());
    let Some(text) = filter.or(names) else {
        app.say(Severity::Note, "nothing to find in this pane: / works in its lists and forms");
        return;
    };
    app.find.field = Some(TextField::new(text));
}

/// A key while it is open: the list follows every character.
pub(in crate::tui) fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    match key.code {
        KeyCode::Esc => {
            app.find.field = None;
            clear(app);
        }
        KeyCode::Enter | KeyCode::Tab => app.find.field = None,
        KeyCode::Up => act::move_by(app, -1),
        KeyCode::Down => act::move_by(app, 1),
        _ => {
            if app.find.field.as_mut().is_some_and(|field| field.press(key)) {
                follow(app);
            }
        }
    }
    Vec::new()
}

/// Show what matches the text in the field.
pub(in crate::tui) fn follow(app: &mut App) {
    let Some(field) = &app.find.field else { return };
    let text = field.value().trim().to_owned();
    let page = pages::of(app.tab);
    if let Some(filter) = page.filter(app) {
        filter.clone_from(&text);
        if !text.is_empty() {
            page.select(app, 0);
        }
        return;
    }
    let count = page.rows(app).map_or(0, |rows| rows.count);
    let names = (0..count).filter_map(|row| Some((row, page.row_name(app, row)?)));
    let found = ranked(names, |(_, name)| rank(&text, &[name], ""));
    if let Some((row, _)) = found.first().filter(|_| !text.is_empty()) {
        page.select(app, *row);
    }
}

/// Take a filter off the pane that has the keys; whether there was one.
pub(in crate::tui) fn clear(app: &mut App) -> bool {
    let filter = pages::of(app.tab).filter(app);
    filter.is_some_and(|filter| !std::mem::take(filter).is_empty())
}
