//! The keys row: what can be pressed here, from the key table; the most important is dropped last.

use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use crate::tui::app::App;
use crate::tui::dialogs::{Dialog, List, Purpose};
use crate::tui::keymap::Action;
use crate::tui::pages;
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::{columns, put, put_line};

type Keys = &'static [(&'static str, &'static str)];

/// Draw it.
pub(in crate::tui) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    if let Some(field) = app.find.field.as_ref().filter(|_| app.dialog.is_none()) {
        return find(app, field, area, canvas);
    }
    let entries = match special(app) {
        Some(list) => {
            list.iter().map(|(key, what)| ((*key).to_owned(), (*what).to_owned())).collect()
        }
        None => from_table(app, area.width),
    };
    let mut spans = vec![Span::raw(" ")];
    let mut used = 1;
    for (key, what) in entries {
        let width = columns(&key) + columns(&what) + 3;
        if used + width > area.width + 2 {
            break;
        }
        used += width;
        spans.push(Span::styled(key, app.theme.style(Role::Key)));
        spans.push(Span::raw(format!(" {what}  ")));
    }
    put_line(canvas, area, 0, &Line::from(spans));
}

/// The field of `/`, and what ends it.
fn find(app: &App, field: &TextField, area: Rect, canvas: &mut Canvas<'_>) {
    let lead = format!("/ find in {}: ", pages::spec(app.pane()).label);
    let start = put(canvas, area, (1, 0), &lead, app.theme.style(Role::Key));
    let hint = "Enter keep  Esc all";
    let room = area.width.saturating_sub(start + columns(hint) + 2);
    field.draw(canvas, Rect { x: area.x + start, width: room, ..area }, app.theme);
    let hint_at = area.width.saturating_sub(columns(hint) + 1);
    put(canvas, area, (hint_at, 0), hint, app.theme.style(Role::Dim));
}

/// While a quantity is typed.
const QUANTITY: Keys = &[
    ("Enter", "ok"),
    ("Esc", "old value"),
    ("Up/Down", "ok and move"),
    ("also", "25.4mm 7.5MN/m 1/3 *2 +5%"),
];
/// While a name or a count is typed.
const WORD: Keys = &[("Enter", "ok"), ("Esc", "old value"), ("Up/Down", "ok and move")];

/// While something is open that takes characters, or a dialog.
fn special(app: &App) -> Option<Keys> {
    if let Some(dialog) = &app.dialog {
        return Some(in_dialog(dialog));
    }
    let takes_unit = pages::of(app.tab).takes_unit(app);
    app.field.is_some().then_some(if takes_unit { QUANTITY } else { WORD })
}

fn in_dialog(dialog: &Dialog) -> Keys {
    const REPLACE: Keys = &[("o", "overwrite"), ("r", "rename"), ("Esc", "back")];
    match dialog {
        Dialog::List(list, picker) => in_list(*list, picker.typing),
        Dialog::Ask(ask) => match (ask.purpose, ask.question) {
            (Purpose::Preset, true) => {
                &[("y", "overwrite"), ("n", "another name"), ("Esc", "do not save")]
            }
            (_, true) => REPLACE,
            (Purpose::Preset, false) => &[("Enter", "save"), ("Esc", "do not save")],
            (Purpose::Table(_), false) => {
                &[("Enter", "write"), ("Tab", "complete path"), ("Esc", "close")]
            }
            (Purpose::Curve(_), false) => {
                &[("Tab", "complete"), ("Enter", "read"), ("Esc", "keep")]
            }
        },
        Dialog::Export(export) if export.question => REPLACE,
        Dialog::Export(_) => &[
            ("Enter", "write"),
            ("Up/Down", "move"),
            ("Space", "tick"),
            ("a", "all or none"),
            ("Tab", "complete path"),
            ("Esc", "close"),
        ],
    }
}

fn in_list(list: List, typing: bool) -> Keys {
    match (list, typing) {
        (List::Help, true) => &[("Enter", "do it"), ("Esc", "all keys"), ("Up/Down", "move")],
        (List::Help, false) => {
            &[("q", "close"), ("j/k", "move"), ("Enter", "do it"), ("/", "search")]
        }
        (List::Palette, _) => &[("Enter", "do it"), ("Esc", "close"), ("Up/Down", "move")],
        (List::Presets, true) => &[("Enter", "load"), ("Esc", "all presets"), ("Up/Down", "move")],
        (List::Presets, false) => &[
            ("Enter", "load"),
            ("Space", "pin only"),
            ("j/k", "move"),
            ("/", "search, or a file's path"),
            ("q", "close"),
        ],
        (List::History, _) => &[("Enter", "go to this state"), ("j/k", "move"), ("q", "close")],
        (List::Words, _) => &[("Enter", "take it"), ("j/k", "move"), ("q", "close")],
        (List::Options, _) => &[("j/k", "move"), ("h/l", "change"), ("Esc", "close")],
    }
}

/// The keys of the pane, the most useful first, as many as fit; the keys of every pane at the end: `? keys  : find  q quit`.
fn from_table(app: &App, width: u16) -> Vec<(String, String)> {
    let map = &app.keymap;
    let key = |action| map.label(action);
    let mut last: Vec<(String, String)> = Vec::new();
    for (action, what) in
        [(Action::Help, "keys"), (Action::Palette, "find"), (Action::Quit, "quit")]
    {
        last.push((key(action), what.to_owned()));
    }
    let size = |entry: &(String, String)| columns(&entry.0) + columns(&entry.1) + 3;
    let room = width.saturating_sub(last.iter().map(size).sum::<u16>());
    let page = pages::of(app.tab);
    let own = pages::spec(app.pane()).keys.iter();
    let own = own.filter(|row| !row.short.is_empty() && !page.is_idle(app, row.action));
    let own = own.map(|row| (pair(app, row.action), row.short.to_owned()));
    let common = [
        (Action::FocusNext, "pane"),
        (Action::Presets, "presets"),
        (Action::Export, "export"),
        (Action::Undo, "undo"),
        (Action::Options, "options"),
    ];
    let common = common.map(|(action, what)| (key(action), what.to_owned()));
    let mut used = 1;
    let mut shown: Vec<(String, String)> = Vec::new();
    for entry in own.chain(common) {
        used += size(&entry);
        if used > room {
            break;
        }
        shown.push(entry);
    }
    shown.extend(last);
    shown
}

/// The key to show, with its opposite where there is one: `h/l`.
fn pair(app: &App, action: Action) -> String {
    let opposite = match action {
        Action::Right => Some((Action::Left, false)),
        Action::Down => Some((Action::Up, true)),
        Action::ZoomIn => Some((Action::ZoomOut, true)),
        Action::EventNext => Some((Action::EventPrevious, true)),
        _ => None,
    };
    let own = app.keymap.label(action);
    match opposite.map(|(other, first)| (app.keymap.label(other), first)) {
        Some((other, true)) => format!("{own}/{other}"),
        Some((other, false)) => format!("{other}/{own}"),
        None => own,
    }
}
