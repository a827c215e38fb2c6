//! The setups of Explore, Limit and Search as texts by the names of their rows: what a session keeps of them.

use std::collections::BTreeMap;

use crate::tui::app::find::quantity_called;
use crate::tui::pages::explore::setup::{self, SetupRow};
use crate::tui::pages::explore::state::sweep_of;
use crate::tui::pages::limit;
use crate::tui::pages::run::steps::{Input, Press};
use crate::tui::pages::search;
use crate::tui::pages::search::state::{Page, Row};
use crate::tui::prelude::*;
use crate::tui::widgets::form::Line;

/// A row that is gone through has no more values than these.
const VALUES_MOST: usize = 12;

const LIMIT: &str = "Limit";
const V50: &str = "Limit: V50";
const ABSORBER: &str = "Limit: absorber";

/// A row of a page by its name; one that shows a quantity has no other name than its value.
fn key(page: &str, line: &Line) -> String {
    let label = if line.value.is_empty() { "quantity" } else { &line.label };
    format!("{page}: {label}")
}

/// What sets a row, typed; the value of one that is gone through.
fn text(line: &Line) -> String {
    match &line.text {
        Some(text) if line.value == "held" => format!("{text} off"),
        Some(text) => text.clone(),
        None => line.value.clone(),
    }
}

/// The rows of Explore that the scene does not keep.
fn explore_rows(app: &App) -> impl Iterator<Item = (SetupRow, Line)> {
    use SetupRow as R;
    let form = app.setup_form();
    let rows = app.setup_choices().into_iter().enumerate();
    let own = rows.filter(|(_, row)| matches!(row, R::Output | R::Picture | R::Design | R::Curves));
    own.filter_map(move |(at, row)| Some((row, form.row(at)?.clone())))
}

impl App {
    pub fn setups(&self) -> BTreeMap<String, String> {
        let mut kept = BTreeMap::new();
        for (_, line) in explore_rows(self) {
            kept.insert(key("Explore", &line), text(&line));
        }
        let bounds = self.search_bounds();
        for page in Page::ALL {
            for row in self.search_rows_of(page) {
                // Bounds that nobody changed follow the scene.
                let is_own = match row {
                    Row::Heading(_) => false,
                    Row::Bound(_) => !self.pages.search.setup.bounds.is_empty(),
                    _ => true,
                };
                if is_own {
                    let line = self.search_line(row, &bounds);
                    kept.insert(key(page.title(), &line), text(&line));
                }
            }
        }
        for row in limit::setup::Row::ALL {
            let line = self.pages.limit.setup.line(row);
            kept.insert(key(LIMIT, &line), text(&line));
        }
        kept.insert(V50.to_owned(), self.pages.limit.sampled.to_string());
        kept.extend(self.pages.limit.absorber.clone().map(|name| (ABSORBER.to_owned(), name)));
        kept
    }

    /// Take over what was kept, as far as it still means something.
    pub fn restore_setups(&mut self, kept: &BTreeMap<String, String>) {
        // The picture decides which other rows there are, and the end of a range may be allowed only beside the other one.
        for _ in 0..2 {
            self.restore_each(kept);
        }
        self.pages.search.page = Page::default();
        self.pages.limit.sampled = kept.get(V50).is_some_and(|word| word == "true");
        self.pages.limit.absorber = kept.get(ABSORBER).cloned();
        // Restoring is no edit.
        (self.history, self.effects) = Default::default();
    }

    fn restore_each(&mut self, kept: &BTreeMap<String, String>) {
        for (row, line) in explore_rows(self).collect::<Vec<_>>() {
            let wanted = kept.get(&key("Explore", &line));
            // An output that the scene does not have would be an edit of it.
            let outputs = sweep_of(&self.scene).outputs;
            let is_there = |text: &String| {
                quantity_called(text).is_ok_and(|it| outputs.iter().any(|one| one == it.name))
            };
            let wanted = wanted.filter(|text| row != SetupRow::Output || is_there(text));
            let now =
                |app: &Self| explore_rows(app).find(|(one, _)| *one == row).map(|(_, line)| line);
            let change = |app: &mut Self, input: Input<'_>| setup::change(app, row, input);
            self.restore(wanted, now, change);
        }
        for row in limit::setup::Row::ALL {
            let line = |app: &Self| Some(app.pages.limit.setup.line(row));
            let wanted = line(self).and_then(|line| kept.get(&key(LIMIT, &line)));
            self.restore(wanted, line, |app, input| app.pages.limit.setup.change(row, input));
        }
        for page in Page::ALL {
            self.pages.search.page = page;
            for row in self.search_choices() {
                let line = |app: &Self| Some(app.search_line(row, &app.search_bounds()));
                let wanted = line(self).and_then(|line| kept.get(&key(page.title(), &line)));
                self.restore(wanted, line, |app, input| search::change(app, row, input));
            }
        }
    }

    /// Set a row to what was kept of it: by its text, or by going through its values. What is refused stays as it was.
    fn restore(
        &mut self,
        wanted: Option<&String>,
        line: impl Fn(&Self) -> Option<Line>,
        change: impl Fn(&mut Self, Input<'_>) -> Result<(), String>,
    ) {
        let Some(wanted) = wanted else { return };
        for _ in 0..VALUES_MOST {
            let Some(now) = line(self).filter(|now| text(now) != *wanted) else { return };
            let typed = now.text.is_some();
            let input = if typed { Input::Text(wanted) } else { Input::Step(Press::NEXT) };
            if change(self, input).is_err() || typed {
                return;
            }
        }
    }
}
