//! The lines of the options menu. No drawing.

pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;

use crate::model::variables;
use crate::tui::app::App;

/// One line of the menu.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
