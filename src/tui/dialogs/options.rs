//! The options menu: characters, colours, mouse, auto-run, threads, interface law and contact model, each switched by name.

use ratatui::layout::Rect;

use crate::model::variables::{self, Kind, VARIABLES, Value};
use crate::study::parallel::Parallel;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::popup::frame;
use crate::tui::dialogs::{self, Picker};
use crate::tui::message::Effect;
use crate::tui::theme::Role;
use crate::tui::update::{edit, jobs};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::list::List;
use crate::tui::widgets::text::{put, put_lines, wrapped};

/// One line of the menu.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum OptionRow {
    /// The characters charts are drawn with.
    Characters,
    /// The colours.
    Colours,
    /// Whether the program has the mouse.
    Mouse,
    /// Whether every edit runs.
    AutoRun,
    /// On how many threads sweeps and studies run.
    Threads,
    /// The law of the interface.
    Interface,
    /// The contact model.
    Contact,
}

impl OptionRow {
    /// All lines, in order.
    pub const ALL: [Self; 7] = [
        Self::Characters,
        Self::Colours,
        Self::Mouse,
        Self::AutoRun,
        Self::Threads,
        Self::Interface,
        Self::Contact,
    ];

    /// Its name and its present value.
    pub fn shown(self, app: &App) -> (&'static str, String) {
        let on = |on: bool| if on { "on" } else { "off" }.to_owned();
        let of = |key: &str| {
            variables::find(key).map_or_else(|_| String::new(), |found| found.show(&app.scene))
        };
        match self {
            Self::Characters => ("characters", app.theme.glyphs.to_string()),
            Self::Colours => ("colours", app.theme.depth.word().to_owned()),
            Self::Mouse => ("mouse", on(app.mouse)),
            Self::AutoRun => ("auto-run", on(app.auto_run)),
            Self::Threads => (
                "threads",
                app.threads.map_or_else(|| "one a core".to_owned(), |count| count.to_string()),
            ),
            Self::Interface => ("interface law", of("interface.law")),
            Self::Contact => ("contact model", of("contact.model")),
        }
    }

    /// What it is about.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Characters => "what charts are drawn with: ASCII, blocks or braille dots",
            Self::Colours => "how many colours the terminal shows",
            Self::Mouse => {
                "on: a click selects, a second one opens, the wheel moves; off: the terminal selects text"
            }
            Self::AutoRun => "on: every edit runs at once; off: r runs",
            Self::Threads => "how many threads sweeps and studies use",
            Self::Interface => "whether projectile and plate stay together after the first arrest",
            Self::Contact => "the force between projectile and plate",
        }
    }
}

/// Switch one by name.
pub(in crate::tui) fn switch(app: &mut App, row: OptionRow) -> Vec<Effect> {
    let effects = change(app, row, true);
    let (name, value) = row.shown(app);
    app.say(Severity::Note, format!("{name}: {value}"));
    effects
}

pub(in crate::tui) fn change(app: &mut App, row: OptionRow, forward: bool) -> Vec<Effect> {
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
            let most = Parallel::of_machine().threads;
            let now = app.threads.map_or(0, |count| count.min(most));
            let next = dialogs::wrap(now, if forward { 1 } else { -1 }, most + 1);
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

/// Where the values begin.
const VALUE: u16 = 18;

/// Draw it.
pub(in crate::tui) fn render(app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
    let count = OptionRow::ALL.len();
    let rows = u16::try_from(count).unwrap_or(u16::MAX);
    let inner = frame(app, screen, (58, rows + 6), ("Options", "h/l changes"), canvas);
    let area = Rect { height: rows.min(inner.height), ..inner };
    let list = List { count, selected: picker.selected, painted: true };
    list.in_dialog(canvas, area, app.theme, |canvas, row, index| {
        let (name, value) = OptionRow::ALL[index].shown(app);
        put(canvas, row, (1, 0), name, app.theme.style(Role::Text));
        put(canvas, row, (VALUE, 0), &format!("< {value} >"), app.theme.style(Role::Title));
    });
    let meaning = OptionRow::ALL.get(picker.selected).map_or("", |row| row.meaning());
    let below = Rect { x: inner.x + 1, width: inner.width.saturating_sub(2), ..inner };
    put_lines(canvas, below, rows + 1, app.theme, wrapped(meaning, below.width, Role::Dim));
}
