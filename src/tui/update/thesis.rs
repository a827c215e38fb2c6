//! The Thesis tab: asking for the report, filtering it, opening what a row shows, changing weights.

use std::sync::Arc;

use super::{edit, jobs, sweep, table};
use crate::model::scene::Scene;
use crate::model::units::significant;
use crate::study::principles::PRINCIPLES;
use crate::study::screening::{CONCEPTS, CRITERIA, WEIGHTS_PERCENT, ranking};
use crate::study::thesis::Opens;
use crate::tui::app::accuracy::Measuring;
use crate::tui::app::dialog::Table;
use crate::tui::app::history::{Edit, Setting};
use crate::tui::app::notice::Severity;
use crate::tui::app::sweep::{Picture, Spread};
use crate::tui::app::thesis::Page;
use crate::tui::app::{App, Base, Origin, Tab};
use crate::tui::message::{Action, Effect, Message};
use crate::worker::studies::{Finding, Study, StudyBody, StudyKind};

/// A step of a weight, percent.
const STEP: f64 = 1.0;
/// Steps of a weight that belong to one edit carry this and the criterion in place of a variable.
const STEPPING: usize = usize::MAX - 100;
/// No weight is greater.
const WEIGHT_MAX: f64 = 100.0;

/// The tab is shown: check the claims, unless they have been or are being.
pub(super) fn enter(app: &mut App) -> Vec<Effect> {
    let tab = &app.thesis;
    let there = tab.report.as_ref().is_some_and(|(_, all)| *all) || tab.running.is_some();
    if there { Vec::new() } else { check(app) }
}

/// Whether the tab has its own meaning for an action.
pub(super) fn is_own(action: Action) -> bool {
    matches!(
        action,
        Action::Run
            | Action::Export
            | Action::FocusNext
            | Action::FocusPrevious
            | Action::OpenDesign
            | Action::NextVerdict
            | Action::StepUp
            | Action::StepDown
            | Action::ResetAll
    )
}

/// An action the tab has its own meaning for.
pub(super) fn act(app: &mut App, action: Action) -> Vec<Effect> {
    let tab = &mut app.thesis;
    match action {
        Action::Run => return check(app),
        Action::FocusNext => tab.page = tab.page.next(),
        Action::FocusPrevious => tab.page = tab.page.next().next(),
        Action::OpenDesign => return open(app),
        Action::NextVerdict => tab.next_filter(),
        Action::StepUp | Action::StepDown => {
            let by = if action == Action::StepUp { STEP } else { -STEP };
            let (mut weights, at) = (tab.weights, tab.criterion);
            weights[at] = (weights[at] + by).clamp(0.0, WEIGHT_MAX);
            weigh(app, weights, Some(at));
        }
        Action::ResetAll => {
            weigh(app, WEIGHTS_PERCENT, None);
            app.say(Severity::Note, "the weights are those of Table 7.1 again (u undoes)");
        }
        _ => table::open(app, Table::Thesis),
    }
    Vec::new()
}

/// Other weights, as one edit; steps of one criterion join.
fn weigh(app: &mut App, weights: [f64; 7], stepped: Option<usize>) {
    let before = std::mem::replace(&mut app.thesis.weights, weights);
    if weights.map(f64::to_bits) == before.map(f64::to_bits) {
        return;
    }
    let stepping = stepped.map(|at| STEPPING + at);
    let label = match stepped {
        None => "printed weights".to_owned(),
        Some(at) => {
            // Held arrows: from where they began.
            let first = match app.history.edits.last() {
                Some(Edit {
                    stepping: last, setting: Some((Setting::Weights(first), _)), ..
                }) if *last == stepping => first[at],
                Some(_) | None => before[at],
            };
            let percent = |weight| significant(weight, 4);
            format!("{} {} -> {} %", CRITERIA[at], percent(first), percent(weights[at]))
        }
    };
    let setting = (Setting::Weights(before), Setting::Weights(weights));
    edit::note_setting(app, setting, label, stepping);
}

fn check(app: &mut App) -> Vec<Effect> {
    let id = app.jobs.next_id();
    let scene = Arc::clone(&app.scene);
    app.thesis.running =
        Some(Measuring { id, scene: Arc::clone(&scene), points: None, long: false });
    vec![
        Effect::Study(Study { id, scene, kind: StudyKind::Thesis }),
        Effect::After(jobs::LONG, Message::LongJob(id)),
    ]
}

/// Open what the selected row shows, as one edit: a sweep in its tab, another scene in the Run tab.
fn open(app: &mut App) -> Vec<Effect> {
    let tab = &app.thesis;
    let opens = match tab.page {
        Page::Claims => tab.row().map_or(Opens::Nothing, |row| row.claim.opens),
        Page::Principles => PRINCIPLES[tab.principle].preset.map_or(Opens::Nothing, Opens::Preset),
        Page::Screening => Opens::Preset(CONCEPTS[ranking(&tab.weights)[0].concept].preset),
    };
    let id = tab.row().map_or("claim", |row| row.claim.id);
    let base = match opens {
        Opens::Nothing => None,
        Opens::Scene(scene) => Some(Base {
            name: format!("claim {id}"),
            origin: Origin::Other,
            scene: Arc::new(scene()),
        }),
        Opens::Preset(name) => {
            app.presets.iter().find(|entry| entry.name == name).map(|entry| Base {
                name: entry.name.clone(),
                origin: Origin::Bundled,
                scene: Arc::new(entry.scene.clone()),
            })
        }
    };
    let Some(base) = base else {
        app.say(Severity::Note, "no scene shows this");
        return Vec::new();
    };
    let name = base.name.clone();
    app.tab = tab_of(&base.scene);
    let swept = app.tab != Tab::Run;
    if swept {
        // The sweep as the preset has it, whatever was looked at before.
        app.sweeping.on_setup = false;
        app.sweeping.output = 0;
        for picture in [Picture::Line, Picture::Surface] {
            app.sweeping.set_spread(picture, Spread::Grid);
        }
    }
    let mut effects = edit::load(app, base);
    if swept {
        effects.extend(sweep::enter(app));
    }
    let what = if swept { "its sweep" } else { "its run" };
    app.say(
        Severity::Note,
        format!("{name} loaded, here is {what} (u undoes, 7 goes back to the thesis)"),
    );
    effects
}

/// The tab that shows what a scene is about: a map over two variables, curves over one, else its run.
pub(super) fn tab_of(scene: &Scene) -> Tab {
    match scene.sweep.as_ref().map_or(0, |sweep| sweep.axes.len()) {
        0 => Tab::Run,
        1 => Tab::Sweep,
        _ => Tab::Surface,
    }
}

/// A report of the study under way.
pub(super) fn report(app: &mut App, body: StudyBody) {
    let tab = &mut app.thesis;
    match body {
        StudyBody::Part { done, total, part: Finding::Thesis(rows, all) } => {
            if let Some(running) = &mut tab.running {
                running.points = Some((done, total));
            }
            tab.report = Some((rows, all));
        }
        StudyBody::Ended(Finding::Thesis(rows, all)) => {
            tab.running = None;
            tab.report = Some((rows, all));
        }
        StudyBody::Failed(text) => {
            tab.running = None;
            app.say(Severity::Error, text);
        }
        // Findings of other kinds carry other numbers.
        StudyBody::Part { .. } | StudyBody::Ended(_) => {}
    }
}
