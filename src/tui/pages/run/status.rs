//! Texts of the Run tab: selected variable, crosshair, status row.

use crate::tui::app::notice::demand;
use crate::tui::app::show_duration;
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::value_steps::engineering;
use cmra_engine::model::run::{EndReason, Outcome, Run};
use cmra_engine::model::units::{self, in_unit};
use cmra_studies::report::series::Channel;
use cmra_studies::study::verdict::{Decision, Verdict};

impl App {
    /// Explains the selected variable, with its source if it fits.
    pub(crate) fn variable_words(&self, room: usize) -> String {
        let variable = self.pages.run.editor.variable();
        let idle = !cmra_engine::model::variables::is_used(variable, &self.scene);
        let note = if idle { " (no effect here)" } else { "" };
        let text = format!("{}{note}: {}", variable.symbol, variable.meaning);
        let unit = self.pages.run.editor.unit(self.pages.run.editor.selected);
        let range = variable.number().and_then(|number| {
            let (low, high) = variable.thesis_range?;
            let show = |value| in_unit(value, unit, number.quantity).map(|it| significant(it, 6));
            Some(format!("thesis {} to {} {unit}", show(low)?, show(high)?))
        });
        let range = range.unwrap_or_else(|| variable.allowed());
        let long = format!("{text}; {}", range.trim_end());
        // Truncated instead of wrapped; `?` shows the whole text.
        if long.chars().count() <= room { long } else { clip(&text, room) }
    }

    /// Describes the values at the crosshair: all of the current run, and the selected chart's quantity of the others.
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
            let quantities = if view.letter.is_none() { &full[..] } else { &[selected] };
            let values = quantities
                .iter()
                .map(|one| format!("{} {}", one.symbol(), value_at(view.run, *one, cursor)));
            let values = values.collect::<Vec<_>>().join("  ");
            let name = view.letter.map_or_else(|| "now".to_owned(), String::from);
            // A single run needs no name.
            parts.push(if views.len() == 1 { values } else { format!("{name} {values}") });
        }
        parts.join(" | ")
    }

    pub(crate) fn run_status(&self) -> Vec<StatusPart> {
        let state = self.state_words();
        let is_done = self.shown.as_ref().is_some_and(|shown| {
            shown.elapsed.is_some() && shown.run.end.is_complete() && !self.shows_old()
        });
        let mut parts = if is_done { self.cost_words().into_iter().collect() } else { vec![state] };
        let Some(shown) = &self.shown else {
            return parts;
        };
        let run = &shown.run;
        if shown.elapsed.is_none() && self.jobs.current.is_some() {
            // The outcome is not yet known.
            parts.push(part(Severity::Note, "the curve so far".to_owned()));
            return parts;
        }
        if let Some(stack) = &run.stack {
            let severity = match stack.outcome {
                Outcome::Arrested | Outcome::Separated => Severity::Note,
                Outcome::Perforated | Outcome::Moving | Outcome::Unmeasured => Severity::Warning,
            };
            parts.push(part(severity, stack.sentence()));
        } else if run.outcome == Outcome::Moving && run.end == EndReason::Oscillates {
            parts.push(part(Severity::Warning, "moving after many turns and touches".to_owned()));
        }
        let verdict = Verdict::from_scene(&run.scene);
        let severity = match verdict.decision {
            Decision::Stops | Decision::NotMeasured => Severity::Note,
            Decision::Open | Decision::Perforates => Severity::Warning,
        };
        // Most scenes have a moving plate; the Limit tab states that there are no measurements for it.
        let is_measured = verdict.expected.is_some();
        parts.extend(
            is_measured.then(|| part(severity, format!("measured: {}", verdict.decision.words()))),
        );
        parts.extend(demand(run).map(|text| part(Severity::Warning, text)));
        parts.extend(self.validity_part());
        parts
    }

    /// Describes the estimated error of the run, and its run time including the estimate.
    fn cost_words(&self) -> Option<StatusPart> {
        let shown = self.shown.as_ref()?;
        let took = show_duration(shown.elapsed?);
        let error = shown.run.depth_error().map(|error| match error {
            f64::INFINITY => "error unknown".to_owned(),
            0.0 => "exact".to_owned(),
            _ => format!("error {}", units::below(error)),
        });
        let text = error.map_or_else(|| took.clone(), |error| format!("{error}, {took}"));
        Some(part(Severity::Note, text))
    }

    fn state_words(&self) -> StatusPart {
        if let Some(job) = &self.jobs.current
            && (self.jobs.overdue
                || self.shown.as_ref().is_none_or(|shown| shown.elapsed.is_none()))
        {
            let reached = job.reached.map_or_else(String::new, |(t_s, elapsed)| {
                let (seconds, t) = (elapsed.as_secs_f64(), engineering(t_s, "s"));
                format!(" for {seconds:.1} s, at t = {t}")
            });
            return part(Severity::Note, format!("running{reached} (<back> cancels)"));
        }
        if self.jobs.failure.is_some() {
            return part(Severity::Error, "failed: see <tab-log>:Log");
        }
        match &self.shown {
            None => part(Severity::Note, NO_RESULTS),
            Some(_) if self.is_stale() && self.jobs.current.is_none() => {
                part(Severity::Warning, old("scene"))
            }
            Some(shown) if shown.elapsed.is_some() => part(Severity::Warning, "ended early"),
            Some(_) => part(Severity::Warning, "cancelled: a part is shown"),
        }
    }
}

/// Formats the value at a time with its unit; `-` outside the run.
fn value_at(run: &Run, quantity: Channel, t_s: f64) -> String {
    let value = quantity.at(run, t_s);
    if quantity == Channel::Penetration && value.is_some_and(|depth| depth < 0.0) {
        return "out".to_owned();
    }
    value.map_or_else(|| "-".to_owned(), |value| engineering(value, quantity.unit()))
}
