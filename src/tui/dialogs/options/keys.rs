//! The options: characters, colours, mouse, auto-run, threads, interface law and contact model, each switched by name.

use crossterm::event::{KeyCode, KeyEvent};

use crate::model::variables::{Kind, VARIABLES, Value};
use crate::study::sweep::crew::Crew;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::options::OptionRow;
use crate::tui::dialogs::{Dialog, Picker, wrap};
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::update::{edit, jobs};

/// A key while the menu is open: Enter, Space, h and l change the line, Esc and q close it.
pub(in crate::tui) fn press(app: &mut App, mut picker: Picker, key: KeyEvent) -> Vec<Effect> {
    let last = OptionRow::ALL.len() - 1;
    let row = OptionRow::ALL[picker.selected.min(last)];
    let mut effects = Vec::new();
    match key.code {
        KeyCode::Esc | KeyCode::Char('q' | 'o') => return Vec::new(),
        KeyCode::Up | KeyCode::Char('k') => picker.selected = picker.selected.saturating_sub(1),
        KeyCode::Down | KeyCode::Char('j') => picker.selected = (picker.selected + 1).min(last),
        KeyCode::Left | KeyCode::Char('h') => effects = change(app, row, false),
        KeyCode::Enter | KeyCode::Right | KeyCode::Char('l' | ' ') => {
            effects = change(app, row, true);
        }
        _ => {}
    }
    app.dialog = Some(Dialog::Options(picker));
    effects
}

/// Switch one by name.
pub(in crate::tui) fn switch(app: &mut App, action: Action) -> Vec<Effect> {
    let row = match action {
        Action::Glyphs => OptionRow::Characters,
        Action::Theme => OptionRow::Colours,
        Action::Mouse => OptionRow::Mouse,
        Action::AutoRun => OptionRow::AutoRun,
        _ => OptionRow::Interface,
    };
    let effects = change(app, row, true);
    let (name, value) = row.shown(app);
    app.say(Severity::Note, format!("{name}: {value}"));
    effects
}

fn change(app: &mut App, row: OptionRow, forward: bool) -> Vec<Effect> {
    match row {
        OptionRow::Characters => {
            app.theme.glyphs = app.theme.glyphs.next();
            vec![Effect::SaveSession]
        }
        OptionRow::Colours => {
            app.theme.depth = app.theme.depth.next(app.best_depth);
            vec![Effect::SaveSession]
        }
        OptionRow::Mouse => {
            app.mouse = !app.mouse;
            vec![Effect::Mouse(app.mouse)]
        }
        OptionRow::AutoRun => {
            app.auto_run = !app.auto_run;
            let run = app.auto_run && app.is_stale();
            let mut effects = if run { jobs::run_now(app) } else { Vec::new() };
            effects.push(Effect::SaveSession);
            effects
        }
        OptionRow::Threads => {
            // In a circle: one a core, then 1, 2, up to as many as there are cores.
            let most = Crew::of_machine().threads;
            let now = app.threads.map_or(0, |count| count.min(most));
            let next = wrap(now, if forward { 1 } else { -1 }, most + 1);
            app.threads = (next > 0).then_some(next);
            vec![Effect::SaveSession]
        }
        OptionRow::Interface => next_word(app, "interface.law", forward),
        OptionRow::Contact => next_word(app, "contact.model", forward),
    }
}

/// The next word of a choice that the scene makes sense with.
fn next_word(app: &mut App, key: &str, forward: bool) -> Vec<Effect> {
    let Some(index) = VARIABLES.iter().position(|one| one.key == key) else { return Vec::new() };
    let Kind::Choice(choice) = &VARIABLES[index].kind else { return Vec::new() };
    let count = choice.words.len();
    let now = (choice.get)(&app.scene);
    let mut refused = None;
    for step in 1..count {
        let at = if forward { (now + step) % count } else { (now + count - step) % count };
        match edit::set(app, index, Value::Word(choice.words[at]), None) {
            Ok(effects) => return effects,
            Err(error) => refused = Some(error),
        }
    }
    if let Some(error) = refused {
        app.say(Severity::Error, error);
    }
    Vec::new()
}
