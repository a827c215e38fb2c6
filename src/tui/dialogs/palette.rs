//! Command palette (`:`): pages and actions, variables, presets and library entries, by name or synonym.

use crate::tui::app::dialog::Outcome;
use crate::tui::dialogs::list::{List, Picker, frame};
use crate::tui::dialogs::{choice, presets};
use crate::tui::keymap::{Command, CommandTarget};
use crate::tui::pages::page::About;
use crate::tui::pages::run::editor::shown_value;
use crate::tui::pages::{self, commands, run};
use crate::tui::prelude::*;
use crate::tui::preset::PresetEntry;
use crate::tui::widgets::find::{rank, rank_variable, ranked};
use crate::tui::widgets::split_top;
use crate::tui::widgets::text::clip_words;
use cmra_engine::model::variables::{VARIABLES, Variable, is_offered};

#[derive(Debug)]
pub(super) struct Palette;

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
                app.report_progress(format!("nothing is called `{typed}`"));
            }
            Some(Item::Command(command)) => return Outcome::Calls(command.call),
            Some(Item::Variable(index)) => {
                run::focus_on(app, index);
                if run::is_list(app) {
                    choice::open(app);
                } else {
                    run::open(app);
                }
            }
            Some(Item::Preset(entry)) => {
                let entry = entry.clone();
                if let Err(why) = presets::take(app, entry) {
                    app.refuse(why);
                }
            }
        }
        Outcome::Closes
    }

    fn draw(&self, app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
        let pane = PaneFrame::new("Find an action, variable, preset or page");
        let inner = frame(screen, (76, 20), pane, canvas);
        picker.draw_filter(inner, canvas);
        let (_, list) = split_top(inner, 1);
        let found = app.palette(picker.filter.value());
        if found.is_empty() {
            canvas.put(list, (0, 0), "nothing has this name", Role::Dim);
        }
        picker.draw_rows(found.len(), list, canvas, |canvas, row, index| {
            let item = &found[index];
            let mark = if item.is_broken() { "!" } else { " " };
            canvas.put(row, (0, 0), mark, Role::Warning);
            canvas.put(row, (2, 0), &clip_words(&item.name(), usize::from(KEY - 3)), Role::Text);
            canvas.put(row, (KEY, 0), &item.key(app), Role::Key);
            let room = usize::from(row.width.saturating_sub(WHAT));
            canvas.put(row, (WHAT, 0), &clip_words(&item.what(app), room), Role::Dim);
        });
    }
}

/// Columns of an item's key and of what it does.
const KEY: u16 = 36;
const WHAT: u16 = 44;

/// Named item.
#[derive(Clone, Copy)]
pub enum Item<'a> {
    Command(&'static Command),
    /// Variable, by index into the table.
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

    fn is_broken(&self) -> bool {
        matches!(self, Self::Preset(entry) if entry.problem.is_some())
    }

    /// Returns the key that does the same; empty if there is none.
    fn key(&self, app: &App) -> String {
        let Self::Command(command) = self else { return String::new() };
        app.keymap.label(match command.call {
            CommandTarget::Do(action) | CommandTarget::In(_, action) => action,
            CommandTarget::Show(pane, _) => Action::Tab(pane.tab),
        })
    }

    /// Describes what choosing the item does, in some words.
    pub fn what(&self, app: &App) -> String {
        match self {
            Self::Command(command) => match command.call {
                CommandTarget::Do(Action::Tab(tab)) => {
                    let About { pages, panes, .. } = pages::page(tab).about();
                    let names: Vec<&str> = if pages.is_empty() {
                        panes.iter().map(|spec| spec.label).collect()
                    } else {
                        pages.iter().map(|page| page.name).collect()
                    };
                    names.join(", ")
                }
                CommandTarget::Do(_) => command.what.to_owned(),
                CommandTarget::In(pane, action) => {
                    let help = pages::spec(pane).keys.iter().find(|key| key.action == action);
                    help.map_or_else(String::new, |key| app.keymap.shown(key.help))
                }
                CommandTarget::Show(pane, _) => {
                    format!("a page of {}", pane.tab.title(&app.keymap))
                }
            },
            Self::Variable(index) => {
                format!("change it; now {}", shown_value(&VARIABLES[*index], &app.scene))
            }
            Self::Preset(entry) => match (&entry.problem, &entry.part) {
                (Some(_), _) => "cannot be loaded".to_owned(),
                (None, Some(_)) => entry.origin.to_owned(),
                (None, None) => entry.scene.title.clone(),
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
    /// Returns the matches, best first; pages and actions for an empty text.
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
}
