//! The setups of Explore, Limit and Search as texts by the names of their rows: what a session keeps of them.

use std::collections::BTreeMap;

use crate::tui::app::find::quantity_called;
use crate::tui::pages::explore::setup::{self, SetupRow};
use crate::tui::pages::explore::state::sweep_of;
use crate::tui::pages::run::steps::{Input, Press};
use crate::tui::pages::search;
use crate::tui::pages::search::setup::Bound;
use crate::tui::pages::search::state::Page;
use crate::tui::prelude::*;
use crate::tui::widgets::form::FormRow;

/// A row that is gone through has no more values than these.
const VALUES_MOST: usize = 12;

const ABSORBER: &str = "Limit: absorber";

#[derive(Clone, Copy)]
enum Row {
    Explore(SetupRow),
    Search(Page, search::state::Row),
}

impl Row {
    /// All rows there are now; of Explore those that the scene does not keep.
    fn all(app: &App) -> Vec<Self> {
        use SetupRow::{Curves, Output, Picture};
        let is_own = |row: &SetupRow| matches!(row, Output | Picture | Curves);
        let explore = app.setup_choices().into_iter().filter(is_own).map(Self::Explore);
        let of_page = |page| app.search_choices(page).into_iter().map(move |row| (page, row));
        let search = Page::ALL.into_iter().flat_map(of_page);
        explore.chain(search.map(|(page, row)| Self::Search(page, row))).collect()
    }

    fn line(self, app: &App, bounds: &[Bound]) -> FormRow {
        match self {
            Self::Explore(row) => app.setup_line(row, &sweep_of(&app.scene)),
            Self::Search(_, row) => app.search_line(row, bounds),
        }
    }

    fn change(self, app: &mut App, input: Input<'_>) -> Result<(), String> {
        match self {
            Self::Explore(row) => setup::change(app, row, input),
            Self::Search(_, row) => search::change(app, row, input),
        }
    }

    /// Its name; one that shows a quantity has no other name than its value.
    fn key(self, line: &FormRow) -> String {
        let page = match self {
            Self::Explore(_) => "Explore",
            Self::Search(page, _) => page.title(),
        };
        let label = if line.value.is_empty() { "quantity" } else { &line.label };
        format!("{page}: {label}")
    }

    /// Set it to what was kept of it: by its text, or by going through its values. What is refused stays as it was.
    fn restore(self, app: &mut App, kept: &BTreeMap<String, String>) {
        for _ in 0..VALUES_MOST {
            let now = self.line(app, &app.search_bounds());
            let wanted = kept.get(&self.key(&now)).filter(|wanted| **wanted != text(&now));
            let Some(wanted) = wanted else { return };
            // An output that the scene does not have would be an edit of it.
            if let Self::Explore(SetupRow::Output) = self
                && !quantity_called(wanted)
                    .is_ok_and(|it| sweep_of(&app.scene).outputs.iter().any(|one| one == it.name))
            {
                return;
            }
            let typed = now.text.is_some();
            let input = if typed { Input::Text(wanted) } else { Input::Step(Press::NEXT) };
            if self.change(app, input).is_err() || typed {
                return;
            }
        }
    }
}

/// What sets a row, typed; the value of one that is gone through.
fn text(line: &FormRow) -> String {
    match &line.text {
        Some(text) if line.value == "held" => format!("{text} off"),
        Some(text) => text.clone(),
        None => line.value.clone(),
    }
}

impl App {
    pub fn setups(&self) -> BTreeMap<String, String> {
        let bounds = &self.pages.search.setup.bounds;
        let mut rows = Row::all(self);
        // Bounds that nobody changed follow the scene.
        rows.retain(|row| {
            !bounds.is_empty() || !matches!(row, Row::Search(_, search::state::Row::Bound(_)))
        });
        let bounds = self.search_bounds();
        let lines = rows.into_iter().map(|row| (row, row.line(self, &bounds)));
        let mut kept: BTreeMap<String, String> =
            lines.map(|(row, line)| (row.key(&line), text(&line))).collect();
        kept.extend(self.pages.limit.absorber.clone().map(|name| (ABSORBER.to_owned(), name)));
        kept
    }

    /// Take over what was kept, as far as it still means something.
    pub fn restore_setups(&mut self, kept: &BTreeMap<String, String>) {
        // The picture decides which other rows there are, and the end of a range may be allowed only beside the other one.
        for _ in 0..2 {
            for row in Row::all(self) {
                row.restore(self, kept);
            }
        }
        self.pages.limit.absorber = kept.get(ABSORBER).cloned();
        // Restoring is no edit.
        (self.history, self.effects) = Default::default();
    }
}
