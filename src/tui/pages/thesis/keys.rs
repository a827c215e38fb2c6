//! The Thesis tab: asking for the report, filtering it, opening what a row shows, changing weights.

use std::sync::Arc;

use crate::model::units::significant;
use crate::study::principles::PRINCIPLES;
use crate::study::screening::{CONCEPTS, CRITERIA, WEIGHTS_PERCENT, ranking};
use crate::study::thesis::Opens;
use crate::tui::app::history::{Change, Setting};
use crate::tui::app::notice::Severity;
use crate::tui::app::{App, Base, Origin};
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::Tab;
use crate::tui::pages::explore;
use crate::tui::pages::explore::state::{Picture, Spread};
use crate::tui::pages::run;
use crate::tui::pages::run::keys::step_of;
use crate::tui::pages::thesis::state::Claims;
use crate::tui::pages::thesis::{self, CLAIMS, SCREENING};
use crate::tui::update::{edit, jobs};

/// A step of a weight, percent.
const STEP: f64 = 1.0;
/// Steps of a weight that belong to one edit carry this and the criterion in place of a variable.
const STEPPING: usize = usize::MAX - 100;
/// No weight is greater.
const WEIGHT_MAX: f64 = 100.0;

/// The tab is shown: check the claims, unless they have been or are being.
pub(in crate::tui) fn enter(app: &mut App) -> Vec<Effect> {
    let tab = &app.pages.thesis;
    let there = tab.report.as_ref().is_some_and(|report| report.is_complete)
        || app.jobs.running::<Claims>().is_some();
    if there || app.pane() != CLAIMS { Vec::new() } else { check(app) }
}

/// What an action does here; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    let pane = app.pane();
    if let (SCREENING, Some(press)) = (pane, step_of(action)) {
        let step = STEP * press.size.factor();
        let (mut weights, at) = (app.pages.thesis.weights, app.pages.thesis.criterion);
        weights[at] = (weights[at] + if press.up { step } else { -step }).clamp(0.0, WEIGHT_MAX);
        weigh(app, weights, Some(at));
        return Some(Vec::new());
    }
    match action {
        Action::Run => return Some(check(app)),
        Action::Enter => return Some(open(app)),
        Action::View if pane == CLAIMS => app.pages.thesis.next_filter(),
        Action::Sort => app.pages.thesis.by_verdict = !app.pages.thesis.by_verdict,
        Action::Reset => {
            let (mut weights, at) = (app.pages.thesis.weights, app.pages.thesis.criterion);
            weights[at] = WEIGHTS_PERCENT[at];
            weigh(app, weights, None);
            app.say(Severity::Note, "the weight is that of Table 7.1 again (u undoes)");
        }
        _ => return None,
    }
    Some(Vec::new())
}

/// Other weights, as one edit; steps of one criterion join.
fn weigh(app: &mut App, weights: [f64; 7], stepped: Option<usize>) {
    let before = std::mem::replace(&mut app.pages.thesis.weights, weights);
    if weights.map(f64::to_bits) == before.map(f64::to_bits) {
        return;
    }
    let stepping = stepped.map(|at| STEPPING + at);
    let label = match stepped {
        None => "printed weights".to_owned(),
        Some(at) => {
            // Held arrows: from where they began.
            let first = match app.history.extended(stepping) {
                Some(Change::Setting(Setting::Weights(first), _)) => first[at],
                _ => before[at],
            };
            let percent = |weight| significant(weight, 4);
            format!("{} {} -> {} %", CRITERIA[at], percent(first), percent(weights[at]))
        }
    };
    let setting = (Setting::Weights(before), Setting::Weights(weights));
    edit::note_setting(app, setting, label, stepping);
}

fn check(app: &mut App) -> Vec<Effect> {
    let scene = Arc::clone(&app.scene);
    jobs::study(app, Tab::Thesis, &scene, Claims)
}

/// Open what the selected row shows, as one edit: a sweep in its tab, another scene in the Run tab.
fn open(app: &mut App) -> Vec<Effect> {
    let tab = &app.pages.thesis;
    let row = app.claim();
    let opens = match app.pane() {
        thesis::PRINCIPLES => {
            PRINCIPLES[tab.principle].preset.map_or(Opens::Nothing, Opens::Preset)
        }
        SCREENING => Opens::Preset(CONCEPTS[ranking(&tab.weights)[0].concept].preset),
        _ => row.map_or(Opens::Nothing, |row| row.claim.opens),
    };
    let id = row.map_or("claim", |row| row.claim.id);
    let base = match opens {
        Opens::Nothing => None,
        Opens::Scene(scene) => Some(Base {
            name: format!("claim {id}"),
            origin: Origin::Other,
            scene: Arc::new(scene.clone()),
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
    show(app, base)
}

/// Load a scene and show what it is about: a sweep in Explore, else its run.
pub(in crate::tui) fn show(app: &mut App, base: Base) -> Vec<Effect> {
    let name = base.name.clone();
    let axes = base.scene.sweep.as_ref().map_or(0, |sweep| sweep.axes.len());
    let mut effects = edit::load(app, base);
    if axes == 0 {
        app.focus_on(run::VARIABLES);
        return effects;
    }
    app.focus_on(explore::RESULTS);
    app.pages.explore.output = 0;
    app.pages.explore.cursor = [None; 2];
    app.pages.explore.zoomed = None;
    // The sweep as the preset has it, whatever was looked at before.
    let visits = &mut app.pages.explore.visits;
    visits.picture = if axes == 1 { Picture::Line } else { Picture::Surface };
    visits.spreads = [Spread::Grid; 2];
    effects.extend(explore::keys::enter(app));
    app.say(Severity::Note, format!("{name} loaded, here is its sweep (u undoes)"));
    effects
}
