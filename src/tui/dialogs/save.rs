//! The dialogs for one text: a preset's name, and the path of a table.

use ratatui::layout::Rect;

use crate::model::units;
use crate::tui::app::App;
use crate::tui::app::status::wrap;
use crate::tui::dialogs::Save;
use crate::tui::dialogs::popup::frame;
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{put, window};

/// Draw it.
pub(in crate::tui) fn render(app: &App, state: &Save, screen: Rect, canvas: &mut Canvas<'_>) {
    let inner = frame(app, screen, (64, 9), ("Save the scene as a preset", ""), canvas);
    field(app, state, ("name  ", inner), canvas);
    let (text, role) = if state.question {
        let name = state.input.value().trim();
        (
            format!("you have a preset `{name}` already: overwrite it? y / n (its comments stay)"),
            Role::Warning,
        )
    } else if let Some(error) = &state.error {
        (format!("x {error}"), Role::Error)
    } else {
        ("kept with your own presets; `cmra NAME` opens it".to_owned(), Role::Dim)
    };
    below(app, (&text, role), inner, canvas);
}

/// Draw the dialog for the path of a table.
pub(in crate::tui) fn path(
    app: &App,
    state: &Save,
    (screen, titles): (Rect, (&str, &str)),
    canvas: &mut Canvas<'_>,
) {
    let inner = frame(app, screen, (76, 9), titles, canvas);
    field(app, state, ("file  ", inner), canvas);
    let target = app.directory.join(state.input.value().trim());
    let (text, role) = if state.question {
        (format!("{} exists: [o]verwrite, [r]ename, Esc back", target.display()), Role::Warning)
    } else if let Some(error) = &state.error {
        (format!("x {error}"), Role::Error)
    } else {
        (format!("to {}", target.display()), Role::Dim)
    };
    below(app, (&text, role), inner, canvas);
}

/// Draw the dialog for the file of a spring's measured curve.
pub(in crate::tui) fn curve(
    app: &App,
    (second, state): (bool, &Save),
    screen: Rect,
    canvas: &mut Canvas<'_>,
) {
    let titles = ("Measured curve of the spring (CSV)", "Tab completes  Enter reads  Esc keeps");
    let inner = frame(app, screen, (76, 9), titles, canvas);
    field(app, state, ("file  ", inner), canvas);
    let (text, role) = state.error.as_ref().map_or_else(
        || {
            let mechanism = &app.scene.mechanism;
            let spring = if second { &mechanism.second } else { &mechanism.spring };
            let text = format!(
                "displacement in m, force in N, a point a line, as in 0.01,1000. Now: {} (Esc keeps them)",
                extent(&spring.table.points)
            );
            (text, Role::Dim)
        },
        |error| (format!("x {error}"), Role::Error),
    );
    below(app, (&text, role), inner, canvas);
}

/// `3 points, x = 0 to 0.05 m`.
pub(in crate::tui) fn extent(points: &[[f64; 2]]) -> String {
    match (points.first(), points.last()) {
        (Some(first), Some(last)) => format!(
            "{} points, x = {} to {} m",
            points.len(),
            units::shortest(first[0]),
            units::shortest(last[0])
        ),
        _ => "no points".to_owned(),
    }
}

/// The text being typed, after its name.
fn field(app: &App, state: &Save, (name, inner): (&str, Rect), canvas: &mut Canvas<'_>) {
    let lead = put(canvas, inner, (0, 1), name, app.theme.style(Role::Title));
    let (shown, at) = window(&state.input, inner.width.saturating_sub(lead + 1));
    let style = app.theme.style(if state.all_selected { Role::Selection } else { Role::Text });
    put(canvas, inner, (lead, 1), &shown, style);
    canvas.cursor = Some((inner.x + lead + at, inner.y + 1));
}

fn below(app: &App, (text, role): (&str, Role), inner: Rect, canvas: &mut Canvas<'_>) {
    for (row, line) in (3..inner.height).zip(wrap(text, usize::from(inner.width))) {
        put(canvas, inner, (0, row), &line, app.theme.style(role));
    }
}
