//! What `:` finds: pages and actions, variables, presets and parts of libraries, by name or synonym, and what Enter does
//! with each.

use crate::model::variables::{VARIABLES, Variable, is_offered};
use crate::tui::app::dialog::{Dialog, Outcome};
use crate::tui::dialogs::list::{List, Picker, frame, listed};
use crate::tui::dialogs::{presets, words};
use crate::tui::keymap::{Call, Command};
use crate::tui::pages::run::editor::shown_value;
use crate::tui::pages::{commands, run};
use crate::tui::prelude::*;
use crate::tui::preset::PresetEntry;
use crate::tui::widgets::find::{rank, rank_variable, ranked};
use crate::tui::widgets::text::{clip, wrapped};
use crate::tui::widgets::{split_bottom, split_top};

pub(super) fn open(_: &mut App) -> Box<dyn Dialog> {
    listed(Palette, 0)
}

#[derive(Clone, Debug)]
struct Palette;

/// Rows that say what Enter does.
const DOES: u16 = 2;

impl List for Palette {
    const OPENED_BY: Action = Action::Palette;
    const IS_FILTERED: bool = true;
    const FOOTER: &'static str = "<enter> do it  <back> close  Up/Down move";

    fn count(&self, app: &App, typed: &str) -> usize {
        app.palette(typed).len()
    }

    fn chosen(&mut self, app: &mut App, picker: &Picker) -> Outcome {
        let found = app.palette(picker.filter.value());
        match found.get(picker.selected).copied() {
            None => {
                let typed = picker.filter.value().trim().to_owned();
                app.tell(format!("nothing is called `{typed}`"));
            }
            Some(Item::Command(command)) => return Outcome::Calls(command.call),
            Some(Item::Variable(index)) => {
                run::focus_on(app, index);
                if run::is_list(app) {
                    words::open(app);
                } else {
                    run::open(app);
                }
            }
            Some(Item::Preset(entry)) => {
                let entry = entry.clone();
                presets::take(app, entry);
            }
        }
        Outcome::Closes
    }

    fn draw(&self, app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
        let pane = PaneFrame::new("Find an action, variable, preset or page");
        let inner = frame(screen, (76, 20), pane, canvas);
        picker.draw_filter(inner, canvas);
        let (list, foot) = split_bottom(split_top(inner, 1).1, DOES);
        let found = app.palette(picker.filter.value());
        if found.is_empty() {
            canvas.put(list, (0, 0), "nothing has this name", Role::Dim);
        }
        picker.draw_rows(found.len(), list, canvas, |canvas, row, index| {
            let item = &found[index];
            let mark = if item.kind() == "broken" { "!" } else { " " };
            canvas.put(row, (0, 0), mark, Role::Warning);
            canvas.put(row, (2, 0), &clip(&item.name(), 40), Role::Text);
            let kind = row.width.saturating_sub(10);
            canvas.put(row, (kind, 0), item.kind(), Role::Dim);
        });
        let selected = found.get(picker.selected);
        let does = selected.map_or_else(String::new, |item| app.palette_does(item));
        canvas.put_lines(foot, 0, wrapped(&does, foot.width, Role::Title));
    }
}

/// Something that can be called by name.
#[derive(Clone, Copy)]
pub enum Item<'a> {
    Command(&'static Command),
    /// A variable, by index into the table.
    Variable(usize),
    Preset(&'a PresetEntry),
}

impl Item<'_> {
    pub fn name(&self) -> String {
        match self {
            Self::Command(command) => command.name.to_owned(),
            Self::Variable(index) => {
                let Variable { symbol, label, .. } = &VARIABLES[*index];
                if symbol == label { label.to_string() } else { format!("{symbol}  {label}") }
            }
            Self::Preset(entry) => entry.name.clone(),
        }
    }

    /// Its kind, in a word or two.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Command(_) => "action",
            Self::Variable(_) => "variable",
            Self::Preset(entry) if entry.problem.is_some() => "broken",
            Self::Preset(entry) => match (&entry.part, entry.origin) {
                (Some(_), origin) => origin,
                (None, _) => "preset",
            },
        }
    }

    fn rank(&self, typed: &str) -> Option<usize> {
        match self {
            Self::Command(command) => rank(typed, &[command.name], command.synonyms),
            Self::Variable(index) => rank_variable(typed, &VARIABLES[*index]),
            Self::Preset(entry) => rank(typed, &[&entry.name], &entry.scene.title),
        }
    }
}

impl App {
    /// The matches, best first; with nothing typed, the pages and actions.
    pub fn palette(&self, typed: &str) -> Vec<Item<'_>> {
        let commands = commands().map(Item::Command);
        if typed.trim().is_empty() {
            return commands.collect();
        }
        let offered = VARIABLES.iter().enumerate();
        let variables = offered
            .filter(|(_, variable)| is_offered(variable, &self.scene))
            .map(|(index, _)| Item::Variable(index));
        let presets = self.files.presets.iter().map(Item::Preset);
        ranked(commands.chain(variables).chain(presets), |item| item.rank(typed))
    }

    pub fn palette_does(&self, item: &Item<'_>) -> String {
        match item {
            Item::Command(command) => {
                let key = match command.call {
                    Call::Do(action) | Call::In(_, action) => self.keymap.label(action),
                    Call::Show(..) => String::new(),
                };
                let key = if key.is_empty() { String::new() } else { format!(" (key {key})") };
                format!("Enter: {}{key}", lower(command.name))
            }
            Item::Variable(index) => {
                let variable = &VARIABLES[*index];
                let verb = if variable.number().is_some() { "type" } else { "choose" };
                let (symbol, now) = (variable.symbol, shown_value(variable, &self.scene));
                format!("Enter: {verb} {symbol}, now {now}: {}", variable.meaning)
            }
            Item::Preset(entry) => match (&entry.problem, &entry.part) {
                (Some(problem), _) => format!("cannot be loaded: {problem}"),
                (None, Some(part)) => {
                    format!("Enter: put this {} into the scene", part.library.word())
                }
                (None, None) => {
                    format!("Enter: load it and show it in {}", shown_in(entry).title(&self.keymap))
                }
            },
        }
    }
}

/// The tab that shows what a preset is about: a sweep in Explore, else its run.
pub fn shown_in(entry: &PresetEntry) -> Tab {
    let swept = entry.scene.sweep.as_ref().is_some_and(|sweep| !sweep.axes.is_empty());
    if swept && entry.part.is_none() { Tab::Explore } else { Tab::Run }
}

/// A name within a sentence; one such as "V50" or "Monte Carlo" keeps its capitals after the first letter.
fn lower(name: &str) -> String {
    let (first, rest) = name.split_at(1);
    first.to_lowercase() + rest
}
