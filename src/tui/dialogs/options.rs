//! The options menu: characters, colours, mouse, auto-run, threads, interface law and contact model, each switched by name.

use cmra_studies::enumeration;

use crate::model::variables::{self, Kind, VARIABLES, Value};
use crate::study::parallel::cores;
use crate::tui::dialogs::{self, Picker, frame};
use crate::tui::prelude::*;
use crate::tui::update::{edit, jobs};
use crate::tui::widgets::RowList;
use crate::tui::widgets::text::wrapped;

enumeration! {
    #[derive(Hash, PartialOrd, Ord)]
    pub enum OptionRow in OptionText {
        name: &'static str,
        meaning: &'static str,
    }
    Characters {
        name: "characters", meaning: "what charts are drawn with: ASCII, blocks or braille dots"
    }
    Colours { name: "colours", meaning: "how many colours the terminal shows" }
    Mouse {
        name: "mouse",
        meaning: "on: a click selects, a second one opens, the wheel moves; off: the terminal selects text"
    }
    /// Whether every edit runs.
    AutoRun { name: "auto-run", meaning: "on: every edit runs at once; off: <run> runs" }
    /// On how many threads sweeps and studies run.
    Threads { name: "threads", meaning: "how many threads sweeps and studies use" }
    Interface {
        name: "interface law",
        meaning: "whether projectile and plate stay together once the projectile stops"
    }
    Contact { name: "contact model", meaning: "the force between projectile and plate" }
}

impl OptionRow {
    /// Its present value.
    pub fn value(self, app: &App) -> String {
        let on = |on: bool| if on { "on" } else { "off" }.to_owned();
        let of = |key: &str| {
            variables::find(key).map_or_else(|_| String::new(), |found| found.show(&app.scene))
        };
        match self {
            Self::Characters => app.theme.glyphs.to_string(),
            Self::Colours => app.theme.depth.word().to_owned(),
            Self::Mouse => on(app.mouse),
            Self::AutoRun => on(app.auto_run),
            Self::Threads => {
                app.threads.map_or_else(|| "one per core".to_owned(), |count| count.to_string())
            }
            Self::Interface => of("interface.law"),
            Self::Contact => of("contact.model"),
        }
    }
}

pub(crate) fn switch(app: &mut App, row: OptionRow) {
    change(app, row, true);
    app.tell(format!("{}: {}", row.name(), row.value(app)));
}

pub(crate) fn change(app: &mut App, row: OptionRow, forward: bool) {
    match row {
        OptionRow::Characters => app.theme.glyphs = app.theme.glyphs.next(),
        OptionRow::Colours => app.theme.depth = app.theme.depth.next(app.best_depth),
        OptionRow::Mouse => {
            app.mouse = !app.mouse;
            app.request(Effect::Mouse(app.mouse));
        }
        OptionRow::AutoRun => {
            app.auto_run = !app.auto_run;
            if app.auto_run && app.is_stale() {
                jobs::run_now(app);
            }
        }
        OptionRow::Threads => {
            // In a circle: one a core, then 1, 2, up to as many as there are cores.
            let most = cores();
            let now = app.threads.map_or(0, |count| count.min(most));
            let next = dialogs::wrap(now, if forward { 1 } else { -1 }, most + 1);
            app.threads = (next > 0).then_some(next);
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

/// Where the values begin.
const VALUE: u16 = 18;

pub(crate) fn render(app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
    let count = OptionRow::ALL.len();
    let rows = u16::try_from(count).unwrap_or(u16::MAX);
    let inner =
        frame(screen, (58, rows + 6), PaneFrame::new("Options").right("h/l changes"), canvas);
    let area = Rect { height: rows.min(inner.height), ..inner };
    let list = RowList { count, selected: picker.selected, painted: true };
    list.in_dialog(canvas, area, |canvas, row, index| {
        let option = OptionRow::ALL[index];
        canvas.put(row, (1, 0), option.name(), Role::Text);
        canvas.put(row, (VALUE, 0), &format!("< {} >", option.value(app)), Role::Title);
    });
    let meaning = OptionRow::ALL.get(picker.selected).map_or("", |row| row.meaning());
    let meaning = &app.keymap.shown(meaning);
    let below = Rect { x: inner.x + 1, width: inner.width.saturating_sub(2), ..inner };
    canvas.put_lines(below, rows + 1, wrapped(meaning, below.width, Role::Dim));
}
