//! Accuracy: asking for measurements, moving about in them, using a method for the scene.

use std::sync::Arc;

use crate::model::scene::ContactModel;
use crate::report::accuracy::TARGETS;
use crate::study::accuracy::method::Method;
use crate::study::accuracy::{Effort, Report};
use crate::tui::app::App;
use crate::tui::app::jobs::Running;
use crate::tui::app::notice::Severity;
use crate::tui::chart::Scale;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::Tab;
use crate::tui::pages::numerics::accuracy::Measurements;
use crate::tui::update::{edit, jobs};
use crate::tui::view::plot_columns;

/// Columns of a plot that is not drawn.
const FEW_COLUMNS: u16 = 40;
/// The tab is shown: measure, unless this scene has been or is being measured.
pub(in crate::tui) fn enter(app: &mut App) -> Vec<Effect> {
    let tab = &app.pages.numerics.accuracy;
    let measured = tab.report.as_ref().is_some_and(|report| *report.scene == *app.scene);
    if measured || app.jobs.is_coming::<Measurements>(&app.scene) {
        Vec::new()
    } else {
        measure(app)
    }
}

/// What an action does here; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    let columns = plot_columns(app).unwrap_or(FEW_COLUMNS);
    match action {
        Action::Run => return Some(measure(app)),
        Action::Enter => return Some(use_method(app)),
        Action::Left => app.pages.numerics.accuracy.move_cursor(-1, columns),
        Action::Right => app.pages.numerics.accuracy.move_cursor(1, columns),
        Action::FarLeft => app.pages.numerics.accuracy.move_cursor(-10, columns),
        Action::FarRight => app.pages.numerics.accuracy.move_cursor(10, columns),
        Action::View => app.pages.numerics.accuracy.table_page += 1,
        Action::LogX | Action::LogY | Action::SlopeGuides | Action::SpreadBars => look(app, action),
        Action::ShowHide | Action::Mark => show_or_hide(app),
        _ => return None,
    }
    Some(Vec::new())
}

/// Set the scene to the selected method at the accuracy asked for first: its tolerance, or the thesis's listing.
fn use_method(app: &mut App) -> Vec<Effect> {
    let method = app.pages.numerics.accuracy.method();
    if app.accuracy_is_old() || app.pages.numerics.accuracy.report.is_none() {
        return app.refuse("no results of this scene: press r to measure");
    }
    let mut scene = (*app.scene).clone();
    let what = match method {
        Method::ThesisPrinted => {
            scene.contact.model = ContactModel::Appendix;
            "the listing of the thesis (contact model appendix)".to_owned()
        }
        _ if method.is_of_engine() => {
            let Some(tolerance) = app.pages.numerics.accuracy.tolerance_for(method, TARGETS[0])
            else {
                let text = format!("{} does not reach an error of 1e-6 here", method.name());
                return app.refuse(text);
            };
            scene.run.tolerance = tolerance;
            format!("{}: tolerance {tolerance:.0e} gives 1e-6", method.name())
        }
        _ => {
            let text = format!(
                "{} is here for comparison: a scene is run by auto, which chooses the method",
                method.name()
            );
            return app.refuse(text);
        }
    };
    if scene == *app.scene {
        app.say(Severity::Note, format!("the scene has this already: {what}"));
        return Vec::new();
    }
    let effects = edit::commit_scene(app, scene, format!("use {what}"), None);
    app.say(Severity::Note, format!("{what} (u undoes)"));
    effects
}

/// Another way to look at the chart.
fn look(app: &mut App, action: Action) {
    let view = &mut app.pages.numerics.accuracy.view;
    let word = |scale| match scale {
        Scale::Linear => "linear",
        Scale::Log10 => "logarithmic",
    };
    let text = match action {
        Action::LogX => {
            view.time_scale = view.time_scale.toggled();
            format!("run time: {}", word(view.time_scale))
        }
        Action::LogY => {
            view.error_scale = view.error_scale.toggled();
            format!("error: {}", word(view.error_scale))
        }
        Action::SlopeGuides => {
            view.guides = !view.guides;
            let logarithmic = (view.time_scale, view.error_scale) == (Scale::Log10, Scale::Log10);
            match (view.guides, logarithmic) {
                (true, true) => "slopes of orders 1, 2, 4 and 8, from the upper left".to_owned(),
                (true, false) => "slopes of orders show where both axes are logarithmic".to_owned(),
                (false, _) => "no slopes".to_owned(),
            }
        }
        _ => {
            view.bars = !view.bars;
            if view.bars {
                "bars: from the least of the timings to their median and its deviation".to_owned()
            } else {
                "no bars".to_owned()
            }
        }
    };
    app.say(Severity::Note, text);
}

fn measure(app: &mut App) -> Vec<Effect> {
    let scene = Arc::clone(&app.scene);
    jobs::study(app, Tab::Numerics, &scene, Measurements(Effort::FULL))
}

fn show_or_hide(app: &mut App) {
    let tab = &mut app.pages.numerics.accuracy;
    let method = tab.method();
    if tab.hidden.contains(&method) {
        tab.hidden.retain(|hidden| *hidden != method);
    } else {
        tab.hidden.push(method);
    }
}

/// News of the measurements.
pub(in crate::tui) fn report(app: &mut App, running: &Running, report: Arc<Report>, is_last: bool) {
    if let Some((_, total)) = running.points {
        app.pages.numerics.accuracy.points_in_all = total;
    }
    if is_last && !report.is_complete {
        let text = "Cancelled. Partial results are shown; press r to measure again.";
        app.say(Severity::Note, text);
    }
    app.pages.numerics.accuracy.report = Some(report);
}
