//! Drawing of the impact below an enlarged chart, to scale at the time of the crosshair, with velocities, forces and energies; and its
//! animation.

mod raster;

use crate::tui::pages::run::charts::end_s;
use std::time::Duration;

use crate::tui::message::Message;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::state::CHARTS;
use crate::tui::theme::GlyphSet;
use crate::tui::widgets::text::fitting;
use cmra_engine::model::run::{Run, Sample};
use cmra_engine::model::units::{Prefix, engineering};
use cmra_engine::numerics::larger;
use cmra_studies::report::chart::scale::whole_below;
use cmra_studies::report::chart::without_common_unit;
use cmra_studies::report::energies::Energies;
use cmra_studies::report::figures::impact::{Stage, gap_m, mode_words};
use cmra_studies::report::series::state_at;

/// Percentage of the body's rows for the drawing.
const SHARE: u16 = 62;
/// Minimum rows of a body with chart and drawing.
const LEAST: u16 = 11;
/// Minimum rows inside the frame for a separate row of numbers.
const NUMBERS_FROM: u16 = 7;

/// Time between animation frames.
const TICK: Duration = Duration::from_millis(50);
/// Animation frames over the time range of a chart: 4 s.
const TICKS: f64 = 80.0;

/// Returns the rows of the drawing below an enlarged chart in a body of this height; 0 if there is no room.
pub(crate) fn rows(height: u16) -> u16 {
    if height < LEAST { 0 } else { height * SHARE / 100 }
}

/// Draws the impact at the time of the crosshair.
pub(crate) fn render(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let charts = &app.pages.run.charts;
    let t_s = time_shown_s(app);
    let state = app.shown.as_ref().and_then(|shown| state_at(&shown.run, t_s));
    let Some((shown, state)) = app.shown.as_ref().zip(state) else {
        PaneFrame::new("Impact").focused(focused).draw(area, canvas);
        return;
    };
    let run = &*shown.run;
    let width = usize::from(area.width.saturating_sub(2));
    let has_row = area.height.saturating_sub(2) >= NUMBERS_FROM;
    let old = if app.shows_old() { " (old)" } else { "" };
    let mut title = format!(
        "Impact at {}: {}{old}",
        engineering(t_s, "s", 3),
        mode_words(&run.scene, state.mode)
    );
    let mut numbers = numbers(run, &state);
    if !has_row {
        title = format!("{}{old}", engineering(t_s, "s", 3));
        while let Some(one) = numbers.first() {
            if title.len() + one.len() + 6 > width {
                break;
            }
            title = format!("{title}  {one}");
            numbers.remove(0);
        }
    }
    let inside = Rect { height: area.height.saturating_sub(2), ..area };
    let bars = bars(run, t_s, width - 2, inside.height >= NUMBERS_FROM, canvas.theme.glyphs);
    let lines = u16::try_from(bars.len()).unwrap_or(0) + u16::from(has_row);
    let picture = Rect {
        x: area.x + 1,
        y: area.y + 1 + u16::from(has_row),
        width: area.width.saturating_sub(2),
        height: inside.height.saturating_sub(lines),
    };
    let end_s = end_s(app, charts.selected);
    let stage = Stage::from_run(run, end_s, raster::dots_of(picture, canvas.theme.glyphs));
    let notes = stage.as_ref().map_or_else(String::new, |stage| stage.notes.join("; "));
    let has_room = title.len() + notes.len() + 10 <= width;
    let right = if has_room { notes.clone() } else { String::new() };
    let inner = PaneFrame::new(title).right(right).focused(focused).draw(area, canvas);
    if has_row {
        let mut line = String::new();
        for one in numbers {
            if line.len() + one.len() + 4 <= width {
                line = format!("{line}{}{one}", if line.is_empty() { "" } else { "  " });
            }
        }
        canvas.put(inner, (1, 0), &line, Role::Text);
    }
    if let Some(stage) = stage {
        let shapes = stage.picture(&state);
        raster::paint(&shapes, &stage, picture, canvas);
        if let Some(out_m) = stage.beyond_m(&state) {
            let text = format!("< projectile, {} away", engineering(out_m, "m", 3));
            canvas.put(picture, (0, picture.height / 2), &text, Role::Curve(0));
        }
    }
    if !has_room && !notes.is_empty() {
        let notes = format!(" {} ", clip(&notes, usize::from(picture.width.saturating_sub(2))));
        let column = picture.width.saturating_sub(columns(&notes)) / 2;
        canvas.put(picture, (column, picture.height.saturating_sub(1)), &notes, Role::Dim);
    }
    for (row, line) in (picture.bottom() - inner.y..).zip(bars) {
        canvas.put(inner, (1, row), &line, Role::Text);
    }
}

/// Formats velocities, depth, displacement and forces, the most important first.
fn numbers(run: &Run, state: &Sample) -> Vec<String> {
    let scene = &run.scene;
    let speed = |name: &str, value: f64| format!("{name} {}", engineering(value, "m/s", 3));
    let length = |value: f64| engineering(value, "m", 4);
    let force = |value: f64| engineering(value, "N", 3);
    let mut all = vec![speed("v", state.projectile_velocity_m_s)];
    if scene.is_sprung() {
        all.push(speed("w", state.plate_velocity_m_s));
    }
    let whole_m = scene.effective_thickness_m();
    let depth_m = state.penetration_m;
    if depth_m < 0.0 {
        all.push(format!("gap {}", length(gap_m(scene, depth_m))));
    } else if depth_m > whole_m {
        all.push(format!("nose {} out", length(depth_m - whole_m)));
    } else if depth_m.is_finite() {
        let of = engineering(whole_m, "m", 3);
        all.push(format!("depth {} of {of}", without_common_unit(length(depth_m), &of)));
    }
    if scene.is_sprung() {
        all.push(format!("x {}", length(state.plate_displacement_m)));
    }
    for (name, value) in [
        ("contact", state.contact_force_n),
        ("spring", state.spring_force_n),
        ("damper", state.damper_force_n),
        ("stop", state.stop_force_n),
    ] {
        if value != 0.0 {
            all.push(format!("{name} {}", force(value)));
        }
    }
    all
}

/// Columns for the bar and the number of a part, besides its name: blanks, and up to five characters.
const NUMBER: usize = 9;
/// Minimum columns for the bar of the total energy in one row; narrower panes use two rows if they fit.
const BAR_LEAST: usize = 12;

/// Names of a part of the energy, long and short, and its value, J.
type Part = ([&'static str; 2], f64);

/// Returns the energies as names, bars of a common scale and numbers, in one or two rows.
fn bars(run: &Run, t_s: f64, width: usize, has_two: bool, glyphs: GlyphSet) -> Vec<String> {
    let Some(energies) = Energies::at(run, t_s) else { return Vec::new() };
    let whole_j = energies.sum_j();
    let prefix = Prefix::for_unit(whole_j, "J");
    let decimals = match whole_j / prefix.size {
        100.0.. => 1,
        10.0.. => 2,
        _ => 3,
    };
    let number = |value_j: f64| {
        let text = format!("{:.decimals$}", value_j / prefix.size);
        if text.parse() == Ok(0.0) { "0".to_owned() } else { text }
    };
    // Omit parts that the scene cannot have.
    let last = Energies::at(run, f64::INFINITY).unwrap_or_default().parts();
    let is_used = |(at, part): &(usize, Part)| {
        let ever_j = larger(part.1.abs(), last[*at].1.abs());
        *at < 2 || (*at == 2 && run.scene.is_sprung()) || ever_j > 1e-6 * whole_j
    };
    let parts = energies.parts().into_iter().enumerate().filter(is_used);
    let parts: Vec<Part> = parts.map(|(_, part)| part).collect();
    let taken = |parts: &[Part]| {
        parts.iter().map(|part| part.0[0].len() + NUMBER).sum::<usize>().saturating_sub(2)
    };
    let unit = format!("{}J", prefix.letter);
    let lead = format!("energy [{unit}]  ");
    let one = taken(&parts) + lead.len() + BAR_LEAST <= width;
    let split = if has_two && !one { parts.len().div_ceil(2) } else { parts.len() };
    let rows: Vec<_> = parts.chunks(split.max(1)).collect();
    let widest = rows.iter().map(|row| taken(row)).max().unwrap_or(0);
    let room = width.saturating_sub(widest + lead.len());
    if room == 0 {
        // To save space omit zero parts first, then shorten names; numbers are not shortened.
        let text = |parts: &[Part], of: usize, gap: &str| {
            let words =
                parts.iter().map(|(name, value_j)| format!("{} {}", name[of], number(*value_j)));
            format!("{unit}: {}", words.collect::<Vec<_>>().join(gap))
        };
        let is_some = |part: &&Part| number(part.1) != "0";
        let some: Vec<Part> = parts.iter().filter(is_some).copied().collect();
        let texts = [(&parts, 0, "  "), (&some, 0, "  "), (&some, 0, " "), (&some, 1, " ")];
        return vec![fitting(texts.map(|(parts, of, gap)| text(parts, of, gap)), width)];
    }
    let bar = if glyphs == GlyphSet::Ascii { "#" } else { "█" };
    let line = |(index, row): (usize, &&[Part])| {
        let part = |([name, _], value_j): &Part| {
            let cells = ((value_j / whole_j).clamp(0.0, 1.0) * room as f64).round();
            let cells = whole_below(cells, room).unwrap_or(room);
            let gap = if cells > 0 { " " } else { "" };
            format!("{name} {}{gap}{}", bar.repeat(cells), number(*value_j))
        };
        let lead = if index == 0 { lead.clone() } else { " ".repeat(lead.len()) };
        lead + &row.iter().map(part).collect::<Vec<_>>().join("  ")
    };
    rows.iter().enumerate().map(line).collect()
}

/// Returns the time of the drawing, s: that of the crosshair, or the middle of the selected chart.
pub(crate) fn time_shown_s(app: &App) -> f64 {
    let charts = &app.pages.run.charts;
    charts.cursor_s.unwrap_or_else(|| 0.5 * end_s(app, charts.selected))
}

/// Ends the animation; returns whether it was active.
pub(crate) fn stop_playing(app: &mut App) -> bool {
    std::mem::take(&mut app.pages.run.charts.is_playing)
}

/// Starts the animation of the selected chart at its crosshair, or at the start if the crosshair is at the end.
pub(crate) fn play(app: &mut App) {
    app.focus_on(CHARTS);
    app.pages.run.is_full = true;
    let end_s = end_s(app, app.pages.run.charts.selected);
    let charts = &mut app.pages.run.charts;
    charts.cursor_s = charts.cursor_s.filter(|t_s| *t_s < end_s).or(Some(0.0));
    charts.is_playing = true;
    charts.serial += 1;
    let serial = charts.serial;
    app.request(Effect::After(TICK, Message::Tick(serial)));
}

/// Shows the next animation frame.
pub(crate) fn tick(app: &mut App, serial: u64) {
    let charts = &app.pages.run.charts;
    if !charts.is_playing || charts.serial != serial {
        return;
    }
    let end_s = end_s(app, charts.selected);
    let next_s = charts.cursor_s.unwrap_or(0.0) + end_s / TICKS;
    let charts = &mut app.pages.run.charts;
    // The sum of the steps equals the end time except for rounding error.
    charts.is_playing = next_s < end_s * (1.0 - 1e-9);
    charts.cursor_s = Some(if charts.is_playing { next_s } else { end_s });
    if charts.is_playing {
        app.request(Effect::After(TICK, Message::Tick(serial)));
    }
}
