//! The options menu: characters, colours, mouse, auto-run, threads, interface law and contact model.

use crate::model::variables::{self, Kind, VARIABLES, Value};
use crate::study::parallel::cores;
use crate::tui::app::dialog::{Dialog, FootKey, Footer, Outcome};
use crate::tui::app::{edit, jobs};
use crate::tui::dialogs::list::{List, Listed, Picker, frame};
use crate::tui::option::OptionRow;
use crate::tui::prelude::*;
use crate::tui::widgets::cycled;
use crate::tui::widgets::text::wrapped;

pub(super) fn open(_: &mut App) -> Box<dyn Dialog> {
    Listed::at(Options, 0)
}

#[derive(Clone, Debug)]
struct Options;

/// Where the values begin.
const VALUE: u16 = 18;

impl List for Options {
    const OPENED_BY: Action = Action::Options;
    const IS_FILTERED: bool = false;

    fn footer(&self, _: bool) -> Footer {
        &[
            (FootKey::Pair(Action::Down, Action::Up), "move"),
            (FootKey::Pair(Action::Left, Action::Right), "change"),
            (FootKey::Of(Action::Back), "close"),
        ]
    }

    fn count(&self, _: &App, _: &str) -> usize {
        OptionRow::ALL.len()
    }

    fn chosen(&mut self, app: &mut App, picker: &Picker) -> Outcome {
        change(app, OptionRow::ALL[picker.selected], true);
        Outcome::Stays
    }

    fn act(&mut self, app: &mut App, picker: &Picker, action: Action) -> Option<Outcome> {
        let forward = match action {
            Action::Right | Action::Mark => true,
            Action::Left => false,
            _ => return None,
        };
        change(app, OptionRow::ALL[picker.selected], forward);
        Some(Outcome::Stays)
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
fn value(row: OptionRow, app: &App) -> String {
    let on = |on: bool| if on { "on" } else { "off" }.to_owned();
    let of = |key: &str| {
        variables::find(key).map_or_else(|_| String::new(), |found| found.show(&app.scene))
    };
    match row {
        OptionRow::Characters => app.settings.theme.glyphs.to_string(),
        OptionRow::Colours => app.settings.theme.depth.word().to_owned(),
        OptionRow::Mouse => on(app.settings.mouse),
        OptionRow::AutoRun => on(app.settings.auto_run),
        OptionRow::Threads => app
            .settings
            .threads
            .map_or_else(|| "one per core".to_owned(), |count| count.to_string()),
        OptionRow::Interface => of("interface.law"),
        OptionRow::Contact => of("contact.model"),
    }
}

pub(crate) fn switch(app: &mut App, row: OptionRow) {
    change(app, row, true);
    app.tell(format!("{}: {}", row.name(), value(row, app)));
}

pub(crate) fn change(app: &mut App, row: OptionRow, forward: bool) {
    match row {
        OptionRow::Characters => app.settings.theme.glyphs = app.settings.theme.glyphs.next(),
        OptionRow::Colours => {
            app.settings.theme.depth = app.settings.theme.depth.next(app.settings.best_depth);
        }
        OptionRow::Mouse => {
            app.settings.mouse = !app.settings.mouse;
            app.request(Effect::Mouse(app.settings.mouse));
        }
        OptionRow::AutoRun => {
            app.settings.auto_run = !app.settings.auto_run;
            if app.settings.auto_run && app.is_stale() {
                jobs::run_now(app);
            }
        }
        OptionRow::Threads => {
            // In a circle: one a core, then 1, 2, up to as many as there are cores.
            let most = cores();
            let now = app.settings.threads.map_or(0, |count| count.min(most));
            let next = cycled(now, if forward { 1 } else { -1 }, most + 1);
            app.settings.threads = (next > 0).then_some(next);
        }
        OptionRow::Interface => next_word(app, "interface.law", forward),
        OptionRow::Contact => next_word(app, "contact.model", forward),
    }
    app.request(Effect::SaveSession);
}

/// The next word of a choice that the scene makes sense with.
fn next_word(app: &mut App, key: &str, forward: bool) {
    let Some(index) = VARIABLES.iter().position(|one| one.key == key) else { return };
    let Kind::Choice(choice) = &VARIABLES[index].kind else { return };
    let count = choice.words.len();
    let now = (choice.get)(&app.scene);
    let mut refused = None;
    for step in 1..count {
        let at = if forward { (now + step) % count } else { (now + count - step) % count };
        match edit::set(app, index, Value::Word(choice.words[at]), None) {
            Ok(()) => return,
            Err(error) => refused = Some(error),
        }
    }
    if let Some(error) = refused {
        app.refuse(error);
    }
}
