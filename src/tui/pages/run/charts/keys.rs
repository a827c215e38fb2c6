//! Crosshair, zoom, axes and quantities.

use crate::report::series::Quantity;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::chart::Scale;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::run::charts::{Fit, Window};
use crate::tui::pages::run::runs;
use crate::tui::view::plot_columns;

/// Columns of a plot that is not drawn.
const FEW_COLUMNS: u16 = 40;
/// What an action does in the charts; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    use Action as A;
    let selected = app.charts.selected;
    let width = plot_columns(app).unwrap_or(FEW_COLUMNS);
    match action {
        A::Mark => return Some(runs::keys::pin_scene(app)),
        A::Left => app.move_cursor(-1, width),
        A::Right => app.move_cursor(1, width),
        A::FarLeft => app.move_cursor(-10, width),
        A::FarRight => app.move_cursor(10, width),
        A::EventNext => event(app, true),
        A::EventPrevious => event(app, false),
        A::ZoomFit => {
            app.charts.fit = Fit::View;
            return None;
        }
        A::FitVertical => fit(app),
        A::Window => window(app),
        A::View => {
            let mut next = app.charts.quantities[selected].next();
            while app.charts.quantities.contains(&next) {
                next = next.next();
            }
            app.charts.quantities[selected] = next;
            if app.charts.second[selected] == Some(next) || next == Quantity::MountForce {
                app.charts.second[selected] = None;
            }
        }
        A::SecondAxis => second_axis(app),
        A::LogX => {
            app.charts.time_scale = app.charts.time_scale.toggled();
            let text = format!("time axis: {}", word(app.charts.time_scale));
            app.say(Severity::Note, text);
        }
        A::LogY => {
            let scale = &mut app.charts.value_scales[selected];
            *scale = scale.toggled();
            let text = format!("value axis: {}", word(*scale));
            app.say(Severity::Note, text);
        }
        A::Difference => difference(app),
        _ => return None,
    }
    Some(Vec::new())
}

fn second_axis(app: &mut App) {
    let text = match app.next_second() {
        Some(quantity) => format!(
            "at the right: {} (w: the next quantity, at last none)",
            quantity.title().to_lowercase()
        ),
        None => "no second axis: w puts a quantity there".to_owned(),
    };
    app.say(Severity::Note, text);
}

fn word(scale: Scale) -> &'static str {
    match scale {
        Scale::Linear => "linear",
        Scale::Log10 => "logarithmic (values of zero or less are not drawn)",
    }
}

fn event(app: &mut App, forward: bool) {
    if app.move_to_event(forward).is_none() {
        let text = match (&app.shown, forward) {
            (None, _) => "no run yet",
            (Some(shown), _) if shown.run.events.is_empty() => "this run has no events",
            (Some(_), true) => "no later event",
            (Some(_), false) => "no earlier event",
        };
        app.say(Severity::Note, text);
    }
}

fn fit(app: &mut App) {
    app.charts.fit = match app.charts.fit {
        Fit::View => Fit::Everything,
        Fit::Everything => Fit::View,
    };
    app.say(
        Severity::Note,
        match app.charts.fit {
            Fit::View => "vertical axes: fitted to what is in view",
            Fit::Everything => "vertical axes: fitted to the whole run",
        },
    );
}

fn window(app: &mut App) {
    app.charts.window = match app.charts.window {
        Window::Contact => Window::Whole,
        Window::Whole => Window::Contact,
    };
    app.charts.zoom_s = None;
    app.say(
        Severity::Note,
        match app.charts.window {
            Window::Contact => "time axis: the contact, up to first arrest or perforation",
            Window::Whole => "time axis: the whole response",
        },
    );
}

fn difference(app: &mut App) {
    let Some(letter) = app.reference_pin().map(|pin| pin.letter) else {
        app.say(Severity::Error, "no pinned run to compare with: Space pins the current one");
        return;
    };
    app.charts.difference = !app.charts.difference;
    let text = if app.charts.difference {
        format!("curves are differences to {letter}: D shows the values again")
    } else {
        "curves are values again".to_owned()
    };
    app.say(Severity::Note, text);
}
