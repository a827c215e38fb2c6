//! The keys row: what can be pressed here, from the key table; the most important is dropped last.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use super::text::{columns, put_line};
use crate::tui::app::App;
use crate::tui::app::dialog::Dialog;
use crate::tui::app::sweep::{SetupRow, has_family};
use crate::tui::message::{Action, BINDINGS, Binding, Place};
use crate::tui::theme::Role;

type Keys = &'static [(&'static str, &'static str)];

/// Draw it.
pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
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
    put_line(buffer, area, 0, &Line::from(spans));
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
    match &app.dialog {
        Some(dialog) => Some(in_dialog(dialog)),
        None if app.editor.field.is_some() => Some(QUANTITY),
        None if app.sweeping.field.is_some() && app.picture().is_some() => {
            let row = app.sweeping.field.as_ref().map(|field| field.row);
            let has_unit =
                matches!(row, Some(SetupRow::From(_) | SetupRow::To(_) | SetupRow::Held(_)));
            Some(if has_unit { QUANTITY } else { WORD })
        }
        None if app.searching.field.is_some() => Some(WORD),
        None if app.editor.filter_field.is_some() => {
            Some(&[("Enter", "keep"), ("Esc", "all rows again"), ("Up/Down", "move")])
        }
        None => None,
    }
}

fn in_dialog(dialog: &Dialog) -> Keys {
    match dialog {
        Dialog::Help(picker) if picker.typing => {
            &[("Enter", "do it"), ("Esc", "all keys"), ("Up/Down", "move")]
        }
        Dialog::Help(_) => &[("q", "close"), ("j/k", "move"), ("Enter", "do it"), ("/", "search")],
        Dialog::Palette(_) => &[("Enter", "do it"), ("Esc", "close"), ("Up/Down", "move")],
        Dialog::Presets(picker) if picker.typing => {
            &[("Enter", "load"), ("Esc", "all presets"), ("Up/Down", "move")]
        }
        Dialog::Presets(_) => &[
            ("Enter", "load"),
            ("Space", "pin only"),
            ("j/k", "move"),
            ("/", "search, or a file's path"),
            ("q", "close"),
        ],
        Dialog::History(_) => &[("Enter", "go to this state"), ("j/k", "move"), ("q", "close")],
        Dialog::Words(_) => &[("Enter", "take it"), ("j/k", "move"), ("q", "close")],
        Dialog::Save(save) if save.question => {
            &[("y", "overwrite"), ("n", "another name"), ("Esc", "do not save")]
        }
        Dialog::ExportAccuracy(save) | Dialog::ExportSweep(save) | Dialog::ExportTable(_, save)
            if save.question =>
        {
            &[("o", "overwrite"), ("r", "rename"), ("Esc", "back")]
        }
        Dialog::ExportAccuracy(_) | Dialog::ExportSweep(_) | Dialog::ExportTable(..) => {
            &[("Enter", "write"), ("Tab", "complete path"), ("Esc", "close")]
        }
        Dialog::Curve(..) => &[("Tab", "complete"), ("Enter", "read"), ("Esc", "keep")],
        Dialog::Save(_) => &[("Enter", "save"), ("Esc", "do not save")],
        Dialog::Export(export) if export.question => {
            &[("o", "overwrite"), ("r", "rename"), ("Esc", "back")]
        }
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

/// As many as fit by priority, then the pane's own first and `?` last.
fn from_table(app: &App, width: u16) -> Vec<(String, String)> {
    let place = app.place();
    let mut rows: Vec<&Binding> = BINDINGS
        .iter()
        .filter(|row| row.footer > 0 && (row.place == place || row.place == Place::Anywhere))
        // These tabs have one pane.
        .filter(|row| {
            let elsewhere = [Action::Pin, Action::Window, Action::FullPane];
            match place {
                Place::Log | Place::Accuracy | Place::Limit => {
                    row.action != Action::FocusNext && !elsewhere.contains(&row.action)
                }
                Place::Map
                | Place::Battery
                | Place::SearchSetup
                | Place::Search
                | Place::Claims
                | Place::Principles
                | Place::Screening => !elsewhere.contains(&row.action),
                Place::Setup | Place::Lines | Place::Surface => row.action != Action::Window,
                Place::Anywhere | Place::Variables | Place::Charts | Place::Runs => true,
            }
        })
        .collect();
    rows.retain(|row| !is_idle(app, row));
    rows.sort_by_key(|row| (row.footer, row.place == Place::Anywhere));
    let mut used = 1;
    rows.retain(|row| {
        let (key, short) = entry(row);
        used += columns(&key) + columns(short) + 3;
        used <= width + 2
    });
    rows.sort_by_key(|row| (row.footer == 1, row.place == Place::Anywhere, row.footer));
    rows.into_iter()
        .map(|row| {
            let (key, short) = entry(row);
            (key, short.to_owned())
        })
        .collect()
}

/// Whether it has nothing to act on as things are: no design to choose or open, no family of curves.
fn is_idle(app: &App, row: &Binding) -> bool {
    match (row.place, row.action) {
        (Place::Search, Action::CursorRight | Action::OpenDesign) => app.searching.choices() == 0,
        (Place::Lines, Action::Down) => !has_family(&app.scene),
        (_, _) => false,
    }
}

/// The key to show, with its opposite where there is one: `h/l step`.
fn entry(row: &Binding) -> (String, &'static str) {
    let key = row.keys.first().map_or_else(String::new, |key| key.words());
    let Some((opposite, short, first)) = opposite(row.action) else {
        return (key, row.short);
    };
    let other = BINDINGS.iter().find(|other| other.place == row.place && other.action == opposite);
    let other = other.and_then(|other| other.keys.first()).map(|key| key.words());
    let Some(other) = other else {
        return (key, short);
    };
    let short = if short.is_empty() { row.short } else { short };
    (if first { format!("{key}/{other}") } else { format!("{other}/{key}") }, short)
}

/// The action that goes the other way, a word for both, and whether the action itself is named first.
fn opposite(action: Action) -> Option<(Action, &'static str, bool)> {
    match action {
        Action::StepUp => Some((Action::StepDown, "step", false)),
        Action::CursorRight => Some((Action::CursorLeft, "", false)),
        Action::ZoomIn => Some((Action::ZoomOut, "zoom", true)),
        Action::EventNext => Some((Action::EventPrevious, "event", true)),
        Action::Down => Some((Action::Up, "", true)),
        _ => None,
    }
}
