//! The texts of the message row and the status row, and the summary printed after leaving. No drawing.

use crate::model::run::envelope::{self, Breach, Check};
use crate::model::run::{EndReason, EstimateBasis, Outcome, Run, Warning};
use crate::model::units::{in_unit, significant};
use crate::report::series::Channel;
use crate::tui::app::notice::demand;
use crate::tui::app::show_duration;
use crate::tui::pages::numerics::{ACCURACY, STABILITY};
use crate::tui::pages::run::editor;
use crate::tui::pages::run::runs::{RunView, engineering};
use crate::tui::pages::{self, StatusPart, note, old, part};
use crate::tui::prelude::*;
use crate::tui::theme;
use crate::tui::widgets::text::{clip, fitting, wrap};

const MESSAGE_LINES: usize = 4;
/// How to begin, at the first start.
const FIRST_LINE: &str = "Move <down>/<up>, change <left>/<right>, type <enter>, <tab-explore> explore, <tab-limit> limit, <help> help.";

impl App {
    /// The message area: what stands under the cursor or what the selected row means, and below it the newest message; wrapped.
    /// A message with more lines than the area has covers what stands above it.
    pub fn message_lines(&self, width: usize) -> Vec<(Severity, String)> {
        let room = width.saturating_sub(4).max(10);
        let wrapped = |text: &str| wrap(&glued(text), room);
        let area = usize::from(self.layout().message.height).max(1);
        let readout = self.readout_line(room);
        let Some((severity, text)) = self.urgent() else {
            let (severity, text) = readout.unwrap_or((Severity::Note, String::new()));
            let mut lines = wrapped(&text);
            if lines.len() > area {
                lines.truncate(area);
                if let Some(last) = lines.last_mut() {
                    *last = clip(last, room.saturating_sub(4)) + " ...";
                }
            }
            let is_full = lines.len() >= area;
            let mut lines = plain(severity, lines);
            let hint = self.pin_hint(room).filter(|_| !is_full);
            lines.extend(hint.map(|text| (Severity::Note, text)));
            return lines;
        };
        let room = room.saturating_sub(theme::columns(severity.mark()).saturating_sub(1)).max(10);
        let mut lines = wrap(&glued(&text), room);
        if lines.len() > MESSAGE_LINES {
            lines.truncate(MESSAGE_LINES);
            let end = self.keymap.shown(" ...: <tab-log>:Log");
            if let Some(last) = lines.last_mut() {
                *last = clip(last, room.saturating_sub(end.len())).trim_end_matches('.').to_owned()
                    + &end;
            }
        }
        let mut all = Vec::new();
        if lines.len() < area
            && let Some((severity, text)) = readout
        {
            all.extend(plain(severity, vec![clip(&text, room)]));
        }
        all.extend(plain(severity, lines));
        all
    }

    /// How to keep the run on the screen, and what it did not need.
    fn pin_hint(&self, room: usize) -> Option<String> {
        let is_shown = self.tab == Tab::Run && self.pins.is_empty() && !self.is_stale();
        let run = &self.shown.as_ref().filter(|_| is_shown)?.run;
        if self.first_run {
            return Some(clip(&self.keymap.shown(FIRST_LINE), room));
        }
        let hint = self
            .keymap
            .shown("<mark> pins this run to compare, <presets> presets, <export> export");
        let omitted = &run.omitted;
        let left_out = |count: usize| {
            let more = if count < omitted.len() {
                format!(" +{}", omitted.len() - count)
            } else {
                String::new()
            };
            format!("{hint}; omitted: {}{more}", omitted[..count].join(", "))
        };
        let texts = (1..=omitted.len()).rev().map(left_out).chain([hint.clone()]);
        Some(fitting(texts, room))
    }

    /// Why an open field refuses its text, or the newest message.
    fn urgent(&self) -> Option<(Severity, String)> {
        if let Some(error) = self.field().and_then(|field| field.text.error.clone()) {
            return Some((Severity::Error, self.keymap.shown(&error)));
        }
        if let Some(notice) = &self.notice {
            return Some((notice.severity, notice.text.clone()));
        }
        None
    }

    /// What stands under the cursor, or what the selected row means.
    fn readout_line(&self, room: usize) -> Option<(Severity, String)> {
        if self.dialog.is_some() {
            return None;
        }
        if self.needs_single_plate()
            && let Err(error) = crate::model::variables::require_single(&self.scene)
        {
            return Some((Severity::Warning, error.to_string()));
        }
        let page = pages::of(self.tab);
        let meaning = page.form(self).and_then(|form| Some(form.line()?.meaning.clone()));
        let (severity, text) = note(meaning).or_else(|| page.readout(self, room))?;
        Some((severity, self.keymap.shown(&text)))
    }

    /// What the selected variable means, with its source where there is room.
    pub(crate) fn variable_words(&self, room: usize) -> String {
        let variable = self.pages.run.editor.variable();
        let idle = !crate::model::variables::is_used(variable, &self.scene);
        let note = if idle { " (no effect here)" } else { "" };
        let text = format!("{}{note}: {}", variable.symbol, variable.meaning);
        if let Some(points) = editor::measured(self) {
            return clip(&format!("{text}; {points}: <enter>"), room);
        }
        let unit = self.pages.run.editor.unit(self.pages.run.editor.selected);
        let range = variable.number().and_then(|number| {
            let (low, high) = number.thesis_range?;
            let show = |value| in_unit(value, unit, number.quantity).map(|it| significant(it, 6));
            Some(format!("thesis {} to {} {unit}", show(low)?, show(high)?))
        });
        let range = range.unwrap_or_else(|| variable.allowed());
        let long = format!("{text}; {}", range.trim_end());
        // Cut, not wrapped: `?` has all of it.
        if long.chars().count() <= room { long } else { clip(&text, room) }
    }

    /// Whether the tab shows nothing because its study looks at one plate and the scene is a stack.
    pub fn needs_single_plate(&self) -> bool {
        let is_empty = match self.pane() {
            ACCURACY => self.pages.numerics.accuracy.report.found.is_none(),
            STABILITY => self.pages.numerics.stability.map.found.is_none(),
            _ => false,
        };
        is_empty && crate::model::variables::require_single(&self.scene).is_err()
    }

    /// Everything at the crosshair: the current run in full, the others in the selected chart's quantity.
    pub fn readout(&self) -> String {
        let Some(cursor) = self.pages.run.charts.cursor_s else {
            return String::new();
        };
        let mut parts = vec![format!("t {}", engineering(cursor, "s"))];
        let selected = self.pages.run.charts.quantities[self.pages.run.charts.selected];
        let full = [
            Channel::Penetration,
            Channel::ContactForce,
            Channel::ProjectileVelocity,
            Channel::PlateVelocity,
            Channel::PlateDisplacement,
        ];
        let views = self.visible_runs();
        for view in views.iter().rev() {
            let quantities: &[Channel] =
                if view.letter.is_none() { &full } else { std::slice::from_ref(&selected) };
            let values: Vec<String> = quantities
                .iter()
                .map(|one| format!("{} {}", one.symbol(), value_at(view.run, *one, cursor)))
                // A value is not broken away from its symbol and unit.
                .map(|text| text.replace(' ', "\u{a0}"))
                .collect();
            let values = values.join("  ");
            // Alone, the run needs no name.
            parts.push(match views.len() {
                1 => values,
                _ => format!("{} {values}", short_name(view)),
            });
        }
        parts.extend(self.event_at_cursor().map(str::to_owned));
        parts.join(" | ")
    }

    /// The parts of the status row, the most important first; the second of a pair is a shorter form. What other tabs are
    /// computing stands at the end.
    pub fn status(&self) -> Vec<StatusPart> {
        let mut parts = pages::of(self.tab).status(self);
        let others = pages::all_jobs(self).filter(|(tab, _)| *tab != self.tab && *tab != Tab::Run);
        for (tab, _) in others {
            let text = format!("{} is computing", tab.title(&self.keymap));
            let at = parts.len().min(1);
            parts.insert(at, (Severity::Note, text.clone(), text));
        }
        let shown = |(severity, long, short): StatusPart| {
            (severity, self.keymap.shown(&long), self.keymap.shown(&short))
        };
        parts.into_iter().map(shown).collect()
    }

    pub(crate) fn run_status(&self) -> Vec<StatusPart> {
        let state = self.state_words();
        let is_done = self.shown.as_ref().is_some_and(|shown| {
            shown.took.is_some() && shown.run.end.is_complete() && !self.shows_old()
        });
        let mut parts = if is_done { self.cost_words().into_iter().collect() } else { vec![state] };
        let Some(shown) = &self.shown else {
            return parts;
        };
        let run = &shown.run;
        if shown.took.is_none() && self.jobs.current.is_some() {
            // What will become of it is not known yet.
            parts.push(part(Severity::Note, "the curve so far".to_owned()));
            return parts;
        }
        if let Some(stack) = &run.stack {
            let severity = match stack.outcome {
                Outcome::Arrested | Outcome::Separated => Severity::Note,
                Outcome::Perforated | Outcome::Moving => Severity::Warning,
            };
            let short = format!("stack {}", stack.outcome.word());
            parts.push((severity, stack.sentence(), short));
        } else if run.outcome == Outcome::Moving && run.end == EndReason::Oscillates {
            parts.push(part(Severity::Warning, "moving after many oscillations".to_owned()));
        }
        parts.extend(demand(run).map(|text| part(Severity::Warning, text)));
        parts.extend(self.validity_part());
        parts
    }

    /// The estimated error of the run, and how long it took with the estimate.
    fn cost_words(&self) -> Option<StatusPart> {
        let shown = self.shown.as_ref()?;
        let took = show_duration(shown.took?);
        let error = shown.run.error_estimate.map(|estimate| match estimate.basis {
            EstimateBasis::OutcomeDiffers(_) => "error unknown".to_owned(),
            _ if estimate.relative == 0.0 => "exact".to_owned(),
            _ => format!("error {:.0e}", estimate.relative),
        });
        let text = error.map_or_else(|| took.clone(), |error| format!("{error}, {took}"));
        let long = format!("{text} with its estimate");
        Some((Severity::Note, long, text))
    }

    fn state_words(&self) -> StatusPart {
        if let Some(job) = &self.jobs.current
            && (self.jobs.overdue || self.shown.as_ref().is_none_or(|shown| shown.took.is_none()))
        {
            let text = job.reached_s.map_or_else(
                || "running".to_owned(),
                |t_s| {
                    let (seconds, t) = (job.elapsed.as_secs_f64(), engineering(t_s, "s"));
                    format!("running for {seconds:.1} s, at t = {t}")
                },
            );
            return part(Severity::Note, format!("{text} (<back> cancels)"));
        }
        if self.jobs.failure.is_some() {
            return part(Severity::Error, "failed: see <tab-log>:Log");
        }
        match &self.shown {
            None => part(Severity::Note, NO_RESULTS),
            Some(_) if self.is_stale() && self.jobs.current.is_none() => {
                (Severity::Warning, old("scene"), "old: press <run>".to_owned())
            }
            Some(shown) => match shown.took {
                Some(took) if shown.run.end.is_complete() => {
                    part(Severity::Note, format!("done {}", show_duration(took)))
                }
                Some(_) => part(Severity::Warning, "ended early"),
                None => part(Severity::Warning, "cancelled: a part is shown"),
            },
        }
    }
}

/// Lines as they are drawn: numbers and units are apart by a plain blank again.
fn plain(severity: Severity, lines: Vec<String>) -> Vec<(Severity, String)> {
    lines.into_iter().map(|line| (severity, line.replace('\u{a0}', " "))).collect()
}

/// A warning with the key that acts on it, where there is one.
pub fn warning_text(warning: &Warning) -> String {
    match warning {
        Warning::InterfacePush { .. } | Warning::InterfacePull { .. } => {
            format!("{warning} (interface law: key <options>)")
        }
        _ => warning.to_string(),
    }
}

/// `now`, or the pin's letter.
pub fn short_name(view: &RunView<'_>) -> String {
    view.letter.map_or_else(|| "now".to_owned(), String::from)
}

/// The value at a time with unit, `-` outside the run.
pub fn value_at(run: &Run, quantity: Channel, t_s: f64) -> String {
    let value = quantity.at(run, t_s);
    if quantity == Channel::Penetration && value.is_some_and(|depth| depth < 0.0) {
        return "out".to_owned();
    }
    value.map_or_else(|| "-".to_owned(), |value| engineering(value, quantity.unit()))
}

/// The text with its numbers and their units held together: a line does not break between them.
fn glued(text: &str) -> String {
    let mut glued = String::with_capacity(text.len());
    let mut after_number = false;
    for (index, word) in text.split(' ').enumerate() {
        if index > 0 {
            glued.push(if after_number && !word.is_empty() { '\u{a0}' } else { ' ' });
        }
        glued.push_str(word);
        after_number = word.parse::<f64>().is_ok();
    }
    glued
}

impl App {
    /// The rules of the model's validity that the scene does not keep: by its run where that is there, with every plate struck.
    pub(crate) fn breaches(&self) -> Vec<Breach> {
        let run = self.shown.as_ref().map(|shown| &shown.run).filter(|_| !self.shows_old());
        run.map_or_else(|| envelope::of_scene(&self.scene), |run| envelope::of_run(run))
    }

    /// The same in full and short.
    pub(crate) fn validity_part(&self) -> Option<StatusPart> {
        let found = self.breaches();
        // The status row of a run has the load of the interface already, with its number.
        let of_run = matches!(self.tab, Tab::Run | Tab::Log);
        let is_shown = |check: &Check| *check == Check::Interface && of_run;
        let checks = found.iter().map(|breach| breach.check);
        outside(checks.filter(|check| !is_shown(check)), "", " (<tab-log>:Log)")
    }
}

/// The checks of the model's validity that fail, and where.
pub(crate) fn outside(
    checks: impl Iterator<Item = Check>,
    place: &str,
    more: &str,
) -> Option<StatusPart> {
    let mut labels: Vec<&str> = Vec::new();
    for label in checks.map(Check::label) {
        if !labels.contains(&label) {
            labels.push(label);
        }
    }
    let list = labels.join(", ");
    let long = format!("! outside validity{place}: {list}{more}");
    let short =
        if place.is_empty() { format!("! validity: {list}") } else { format!("!{place}: {list}") };
    (!labels.is_empty()).then_some((Severity::Warning, long, short))
}
