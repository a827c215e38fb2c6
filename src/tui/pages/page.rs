//! Interface of a page: panes and their keys, computation on entry, effects of keys, texts.

/// Common imports of the pages.
pub(crate) mod prelude {
    pub(crate) use std::sync::Arc;

    pub(crate) use super::{About, Page, PageSpec};
    pub(crate) use super::{
        BEING_COMPUTED, NOT_YET, cut, not_yet, note, nothing, progress, under_way,
    };
    pub(crate) use crate::tui::app::notice::{StatusPart, old, part};
    pub(crate) use crate::tui::app::running::Running;
    pub(crate) use crate::tui::app::{edit, jobs};
    pub(crate) use crate::tui::chart::{Scale, ViewRange};
    pub(crate) use crate::tui::keymap::{Action as A, Command, CommandTarget, PaneSpec, key};
    pub(crate) use crate::tui::message::PageTable;
    pub(crate) use crate::tui::prelude::*;
    pub(crate) use crate::tui::preset::LabelledScene;
    pub(crate) use crate::tui::widgets::text::{TextLine, clip, columns};
    pub(crate) use crate::tui::widgets::{RowList, Rows, split_bottom, split_left, split_top};
    pub(crate) use crate::worker::ReportBody;
    pub(crate) use crate::worker::studies::RequestVariant;
    pub(crate) use cmra_engine::model::scene::Scene;
    pub(crate) use cmra_engine::model::units::significant;
    pub(crate) use cmra_studies::report::wrap::wrap;
    pub(crate) use cmra_studies::study::context::Reach;
}

use prelude::*;
use ratatui::buffer::Buffer;

use crate::tui::app::ActiveInput;
use crate::tui::app::running::CachedResult;
use crate::tui::pages::{self, run};
use crate::tui::widgets::form::{FieldQuantity, Form};
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::layout::{Layout, layout};
use crate::tui::widgets::value_steps::Input;
use cmra_engine::model::variables::{self, VARIABLES};

/// Error for an action that needs results under computation.
pub(crate) const BEING_COMPUTED: &str = "being computed";

/// Text in place of a value that a stopped study did not reach, whether its time limit or the user stopped it.
pub(crate) const NOT_YET: &str = "not computed yet: <run> computes it";

/// Returns the text of an empty pane: that its study runs, else the reason.
pub(crate) fn nothing<S: RequestVariant>(app: &App, running: &str, why: Option<&str>) -> String {
    let waits = app.jobs.running::<S>().is_some();
    app.keymap.shown(if waits { running } else { why.unwrap_or(NO_RESULTS) })
}

/// Returns the text in place of a value that the computed part of its study does not have.
pub(crate) fn not_yet(app: &App, running: Option<&Running>) -> String {
    app.keymap.shown(if running.is_some() { "not computed yet" } else { NOT_YET })
}

/// Returns the status part for an active study, the same on all pages, with its progress.
pub(crate) fn under_way(what: &str) -> StatusPart {
    part(Severity::Note, format!("{what} (<back> cancels)"))
}

/// Returns the status part for a stopped study, with its progress.
pub(crate) fn cut<T>(kept: &CachedResult<T>, items: &str) -> StatusPart {
    let reach = kept.reach.counted(items).map_or_else(String::new, |it| format!(" ({it})"));
    let what = if kept.is_look { "first look" } else { "cancelled" };
    part(Severity::Warning, format!("{what}: press <run>{reach}"))
}

/// Returns the status part for the progress of a study; `None` for a complete result.
pub(crate) fn progress<S: RequestVariant, T>(
    app: &App,
    kept: &CachedResult<T>,
    scene: &Scene,
    words: impl FnOnce(&Running) -> String,
    items: &str,
) -> Option<StatusPart> {
    match app.jobs.running::<S>() {
        Some(running) => Some(under_way(&words(running))),
        None if kept.is_stale(scene) => Some(part(Severity::Warning, old("scene"))),
        None if kept.result.is_none() => Some(part(Severity::Note, NO_RESULTS)),
        None => (!kept.is_complete()).then(|| cut(kept, items)),
    }
}

/// Page of a tab with several pages.
pub(crate) struct PageSpec {
    pub name: &'static str,
    pub panes: &'static [Pane],
}

/// Constants of a tab.
pub(crate) struct About {
    /// Subpages; empty for a single page.
    pub pages: &'static [PageSpec],
    /// All panes of the tab; the first one has the initial focus.
    pub panes: &'static [PaneSpec],
    /// Commands for the palette.
    pub commands: &'static [Command],
}

/// Tab of the workbench. Methods for a pane apply to the focused pane, which belongs to the page.
pub(crate) trait Page: Sync {
    fn about(&self) -> About;

    /// Returns the shown panes, in the order of Tab.
    fn shown_panes(&self, app: &App) -> Vec<Pane> {
        let About { panes, pages, .. } = self.about();
        let all = || panes.iter().map(|spec| spec.pane).collect();
        pages.get(self.shown(app)).map_or_else(all, |page| page.panes.to_vec())
    }

    /// Returns the index of the shown page: the first one that contains the focused pane.
    fn shown(&self, app: &App) -> usize {
        let pages = self.about().pages.iter();
        pages.take_while(|page| !page.panes.contains(&app.pane())).count()
    }

    /// Shows another page and computes its missing results.
    fn turn_to(&self, app: &mut App, page: usize) {
        if let Some(page) = self.about().pages.get(page) {
            app.focus_on(page.panes[0]);
            self.enter(app);
        }
    }

    /// Called when the tab is shown; computes the missing results of the scene.
    fn enter(&self, _app: &mut App) {}

    /// Called when the scene or its sweep changes while the tab is shown.
    fn edited(&self, _app: &mut App) {}

    /// Called when another pane of the tab gets the focus.
    fn focused(&self, _app: &mut App) {}

    /// Called on a key or a change of the scene; restarts the idle time of deferred results.
    fn await_rest(&self, _app: &mut App) {}

    /// Called after the idle time; computes the deferred results.
    fn rested(&self, _app: &mut App) {}

    /// Performs an action; returns `false` if the page has no meaning of its own for it.
    fn act(&self, _app: &mut App, _action: Action) -> bool {
        false
    }

    /// Returns `true` if an action of the focused pane is useful now; the footer omits others.
    fn is_of_use(&self, _app: &App, _action: Action) -> bool {
        true
    }

    /// Describes the cell under the cursor or the selected row.
    fn readout(&self, _app: &App, _room: usize) -> Option<(Severity, String)> {
        None
    }

    /// Returns the status row, the most important part first.
    fn status(&self, app: &App) -> Vec<StatusPart>;

    fn report(&self, _app: &mut App, _running: &Running, _news: &ReportBody) {}

    /// Returns the displayed table; `None` if it is empty.
    fn table(&self, _app: &App) -> Option<PageTable> {
        None
    }

    fn form(&self, _app: &App) -> Option<Form> {
        None
    }

    /// Returns the rows of the pane if it is a list or a form.
    fn rows(&self, app: &App) -> Option<Rows> {
        self.form(app).map(|form| form.rows(app.list_rows()))
    }

    fn select(&self, _app: &mut App, _row: usize) {}

    /// Returns the filter text of the pane's rows, if `/` filters them.
    fn filter<'a>(&self, _app: &'a mut App) -> Option<&'a mut String> {
        None
    }

    /// Returns the initial text of the selected row's field.
    fn text(&self, app: &App) -> String {
        let text = || self.form(app)?.line()?.text.clone();
        text().unwrap_or_default()
    }

    /// Returns the quantity of the open field, if it has one.
    fn field_quantity(&self, app: &App) -> Option<FieldQuantity> {
        self.form(app)?.line()?.quantity.clone()
    }

    /// Returns `true` if a text differs from the row's value, or the row is dim: a dim value is not in effect, and typing it again puts it
    /// into effect.
    fn is_new(&self, app: &App, text: &str) -> bool {
        let form = self.form(app);
        let is_dim = form.is_some_and(|form| form.line().is_some_and(|it| it.role == Role::Dim));
        is_dim || text != self.text(app)
    }

    /// Changes the value of the selected row.
    fn change(&self, _app: &mut App, _input: Input<'_>) -> Result<(), String> {
        Ok(())
    }

    /// Moves the cursor to a cell of the pane's map.
    fn go_to_cell(&self, _app: &mut App, _cell: (usize, usize)) {}

    /// Moves the crosshair of a chart to a value of its horizontal axis.
    fn go_to_value(&self, _app: &mut App, _chart: usize, _value: f64) {}

    /// Returns the axes of the crosshair, each with the unit of a bare number; empty without a crosshair.
    fn places(&self, _app: &App) -> Vec<(String, String)> {
        Vec::new()
    }

    /// Moves the crosshair to a typed position.
    fn go_to_place(&self, _app: &mut App, _text: &str) -> Result<(), String> {
        Ok(())
    }

    /// Removes the crosshair of the pane or resets it to its default; `false` if it is already there.
    fn remove_cursor(&self, _app: &mut App) -> bool {
        false
    }

    /// Draws the panes into the body of the screen.
    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>);
}

impl App {
    /// Returns the unit of a variable in all fields, also that of bare numbers.
    pub(crate) fn unit_of(&self, name: &str) -> &'static str {
        let key = variables::find(name).map_or("", |variable| variable.key);
        let index = VARIABLES.iter().position(|variable| variable.key == key);
        index.map_or("", |index| self.pages.run.editor.unit(index))
    }

    pub fn layout(&self) -> Layout {
        // The row of a pinned run replaces the hint how to pin one.
        let has_hint = self.tab != Tab::Run || self.pins.is_empty();
        layout(self.size, pages::page(self.tab).about().pages.len() > 1, has_hint)
    }

    /// Returns the number of rows of a list that fills the body.
    pub(crate) fn list_rows(&self) -> usize {
        self.layout().body.map_or(10, |body| usize::from(body.height.saturating_sub(2)))
    }
}

/// Draws the setup of a study.
pub(crate) fn draw_setup(app: &App, form: &Form, pane: Pane, area: Rect, canvas: &mut Canvas<'_>) {
    let on = app.pane() == pane;
    let hint = app.keymap.shown(if on { "" } else { "<next-pane>" });
    let frame = PaneFrame::new("Setup").right(hint).focused(app.has_focus(pane));
    let inner = frame.draw(area, canvas);
    canvas.pane(area, pane);
    form.render((pane, on), app.field(), inner, canvas);
}

pub(crate) fn note(text: Option<String>) -> Option<(Severity, String)> {
    text.map(|text| (Severity::Note, text))
}

/// Iterates over the active tasks: the tab of each request, and the task number.
pub(crate) fn all_jobs(app: &App) -> impl Iterator<Item = (Tab, u64)> {
    let current = app.jobs.current.as_ref().map(|job| job.id);
    let runs = current.into_iter().chain(app.pins.iter().filter_map(|pin| pin.job));
    // The sensitivity bars are computed in idle time; any key cancels that.
    let is_rest = |running: &&Running| running.tab == Tab::Run && running.is_look;
    let studies = app.jobs.studies.iter().filter(move |running| !is_rest(running));
    let studies = studies.map(|running| (running.tab, running.id));
    runs.map(|id| (Tab::Run, id)).chain(studies)
}

/// Opens the field of the focused pane's selected row, with its text selected.
pub(crate) fn open_field(app: &mut App) {
    let text = pages::page(app.tab).text(app);
    app.typing = Some(ActiveInput::Field(TextField::selected(text)));
}

/// Moves the selection of the pane by rows, stopping at the ends.
pub(crate) fn move_by(app: &mut App, by: isize) {
    let page = pages::page(app.tab);
    if let Some(rows) = page.rows(app)
        && let Some(last) = rows.count.checked_sub(1)
    {
        page.select(app, rows.selected.min(last).saturating_add_signed(by).min(last));
    }
}

/// Returns the key of an action together with the key of its counterpart: `h/l`.
pub(crate) fn pair(app: &App, action: Action) -> String {
    let pair = match action {
        Action::Right => [Action::Left, Action::Right],
        Action::Down => [Action::Down, Action::Up],
        Action::Window if app.pane() == run::VARIABLES => [Action::Window, Action::FullPane],
        _ => return app.keymap.label(action),
    };
    let keys = pair.map(|one| app.keymap.label(one)).into_iter().filter(|key| !key.is_empty());
    keys.collect::<Vec<_>>().join("/")
}

/// Explains why a page has no table.
pub(crate) fn nothing_yet(app: &App, what: &str) -> String {
    if all_jobs(app).any(|(tab, _)| tab == app.tab) {
        return "nothing is finished yet: <back> stops the job and keeps what is finished"
            .to_owned();
    }
    format!("nothing to {what} yet: press <run> to compute it")
}

/// Returns the displayed charts and maps as SVG; empty if the page has none.
pub(crate) fn pictures(app: &App) -> Vec<String> {
    let mut buffer = Buffer::empty(Rect::new(0, 0, app.size.0, app.size.1));
    let mut canvas = Canvas::new(&mut buffer, app.settings.theme);
    canvas.pictures = Some(Vec::new());
    if let Some(body) = app.layout().body {
        pages::page(app.tab).draw(app, body, &mut canvas);
    }
    canvas.pictures.unwrap_or_default()
}
