//! The pages: for every tab its panes, the names of its pages, what it computes when it is shown, what keys do in it, and what it
//! says. The loop of the workbench knows only this.

use super::app::notice::Severity;
use super::app::{App, Tab};
use super::keymap::{Action, Pane};
use super::message::Effect;
use super::update;

/// A part of the status row: how serious, the text, and a shorter form of it.
pub type StatusPart = (Severity, String, String);

/// A computation of a page that has not ended.
#[derive(Clone, Debug)]
pub struct Running {
    /// What it is, for the status row of other tabs.
    pub label: &'static str,
    /// What stops it.
    pub cancel: Effect,
    /// It has been running for so long that leaving asks first.
    pub long: bool,
}

/// A tab of the workbench.
pub trait Page {
    /// The panes of the page shown, in the order in which Tab goes through them.
    fn panes(&self, app: &App) -> &'static [Pane];

    /// The names of its pages, where it has several.
    fn names(&self) -> &'static [&'static str] {
        &[]
    }

    /// The page shown, by its place among the names.
    fn shown(&self, _app: &App) -> usize {
        0
    }

    /// Show another page; it computes what it has not.
    fn turn_to(&self, _app: &mut App, _page: usize) -> Vec<Effect> {
        Vec::new()
    }

    /// The tab is shown: it computes what it has not, for the scene there is.
    fn enter(&self, _app: &mut App) -> Vec<Effect> {
        Vec::new()
    }

    /// What a key does here; `None` where the page has no meaning for it.
    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>>;

    /// What stands under the cursor, or what the selected row means.
    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)>;

    /// The status row, the most important part first.
    fn status(&self, app: &App) -> Vec<StatusPart>;

    /// What it is computing.
    fn running(&self, app: &App) -> Vec<Running>;
}

/// The page of a tab.
pub fn of(tab: Tab) -> &'static dyn Page {
    match tab {
        Tab::Run => &RunPage,
        Tab::Explore => &ExplorePage,
        Tab::Limit => &LimitPage,
        Tab::Search => &SearchPage,
        Tab::Numerics => &NumericsPage,
        Tab::Thesis => &ThesisPage,
        Tab::Log => &LogPage,
    }
}

fn note(text: Option<String>) -> Option<(Severity, String)> {
    text.map(|text| (Severity::Note, text))
}

struct RunPage;

impl Page for RunPage {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::Variables, Pane::Charts, Pane::Runs]
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        update::run::act(app, action)
    }

    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            Pane::Charts if app.charts.cursor_s.is_some() => note(Some(app.readout())),
            Pane::Variables => note(Some(app.variable_words(room))),
            _ => None,
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.run_status()
    }

    fn running(&self, app: &App) -> Vec<Running> {
        let job = app.jobs.current.as_ref();
        let running =
            job.map(|job| Running { label: "1:Run", cancel: Effect::CancelJob, long: job.long });
        running.into_iter().collect()
    }
}

struct ExplorePage;

impl Page for ExplorePage {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::ExploreSetup, Pane::Explore]
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        update::sweep::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        update::sweep::act(app, action)
    }

    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)> {
        note(match app.pane() {
            Pane::ExploreSetup => Some(app.setup_readout(app.picture())),
            _ => app.sweep_readout(room),
        })
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.sweep_status(app.picture())
    }

    fn running(&self, app: &App) -> Vec<Running> {
        let job = app.sweeping.computing.as_ref();
        let running = job.map(|job| Running {
            label: "2:Explore",
            cancel: Effect::CancelSweep,
            long: job.long,
        });
        running.into_iter().collect()
    }
}

struct LimitPage;

impl Page for LimitPage {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::Residual, Pane::Comparison, Pane::EfficiencyMap]
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        update::limit::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        update::limit::act(app, action)
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            Pane::Residual => app.limit_readout(),
            Pane::Comparison => note(app.comparison_readout()),
            _ => note(app.efficiency_readout()),
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.limit_status()
    }

    fn running(&self, app: &App) -> Vec<Running> {
        let jobs = [app.limit.finding.as_ref(), app.limit.comparing.as_ref()];
        studies("3:Limit", &jobs)
    }
}

struct SearchPage;

impl Page for SearchPage {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::SearchSetup, Pane::Search]
    }

    fn names(&self) -> &'static [&'static str] {
        &["Goal seek", "Pareto front", "Sensitivity", "Monte Carlo"]
    }

    fn shown(&self, app: &App) -> usize {
        app.searching.page.index()
    }

    fn turn_to(&self, app: &mut App, page: usize) -> Vec<Effect> {
        update::search::turn_to(app, page)
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        update::search::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        update::search::act(app, action)
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        note(app.search_readout())
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.search_status()
    }

    fn running(&self, app: &App) -> Vec<Running> {
        studies("4:Search", &[app.searching.running.as_ref()])
    }
}

struct NumericsPage;

impl Page for NumericsPage {
    fn panes(&self, app: &App) -> &'static [Pane] {
        if app.pane() == Pane::Accuracy {
            &[Pane::Accuracy]
        } else {
            &[Pane::StabilityMap, Pane::Battery]
        }
    }

    fn names(&self) -> &'static [&'static str] {
        &["Accuracy", "Stability"]
    }

    fn shown(&self, app: &App) -> usize {
        usize::from(app.pane() != Pane::Accuracy)
    }

    fn turn_to(&self, app: &mut App, page: usize) -> Vec<Effect> {
        app.focus_on(if page == 0 { Pane::Accuracy } else { Pane::StabilityMap });
        self.enter(app)
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        match app.pane() {
            Pane::Accuracy => update::accuracy::enter(app),
            _ => update::stability::enter(app),
        }
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        match app.pane() {
            Pane::Accuracy => update::accuracy::act(app, action),
            _ => update::stability::act(app, action),
        }
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            Pane::Accuracy => note(app.accuracy_readout()),
            Pane::StabilityMap => note(app.map_readout()),
            _ => app.battery_readout(),
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        match app.pane() {
            Pane::Accuracy => app.accuracy_status(),
            _ => app.stability_status(),
        }
    }

    fn running(&self, app: &App) -> Vec<Running> {
        let stability = &app.stability;
        let jobs = [
            app.accuracy.measuring.as_ref(),
            stability.mapping.as_ref(),
            stability.running.as_ref(),
        ];
        studies("5:Numerics", &jobs)
    }
}

struct ThesisPage;

/// The panes of the Thesis tab, page by page.
const THESIS: [&[Pane]; 3] = [&[Pane::Claims], &[Pane::Principles], &[Pane::Screening]];

impl Page for ThesisPage {
    fn panes(&self, app: &App) -> &'static [Pane] {
        THESIS[self.shown(app)]
    }

    fn names(&self) -> &'static [&'static str] {
        &["Claims", "Principles", "Screening"]
    }

    fn shown(&self, app: &App) -> usize {
        THESIS.iter().position(|panes| panes.contains(&app.pane())).unwrap_or(0)
    }

    fn turn_to(&self, app: &mut App, page: usize) -> Vec<Effect> {
        app.focus_on(THESIS[page.min(THESIS.len() - 1)][0]);
        self.enter(app)
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        update::thesis::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        update::thesis::act(app, action)
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        note(app.thesis_readout())
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.thesis_status()
    }

    fn running(&self, app: &App) -> Vec<Running> {
        studies("6:Thesis", &[app.thesis.running.as_ref()])
    }
}

struct LogPage;

impl Page for LogPage {
    fn panes(&self, _app: &App) -> &'static [Pane] {
        &[Pane::Log]
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        update::log::act(app, action)
    }

    fn readout(&self, _app: &App, _room: usize) -> Option<(Severity, String)> {
        None
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.run_status()
    }

    fn running(&self, _app: &App) -> Vec<Running> {
        Vec::new()
    }
}

fn studies(label: &'static str, jobs: &[Option<&super::app::accuracy::Measuring>]) -> Vec<Running> {
    let running = |job: &super::app::accuracy::Measuring| Running {
        label,
        cancel: Effect::CancelStudy(job.id),
        long: job.long,
    };
    jobs.iter().flatten().map(|job| running(job)).collect()
}
