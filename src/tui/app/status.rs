//! The texts of the message row and the status row, and the summary printed after leaving. No drawing.

use super::notice::{Severity, demand, times};
use super::quantity::Quantity;
use super::runs::{RunView, engineering, millimetres, name_of};
use super::show_duration;
use super::{App, Tab};
use crate::model::run::envelope;
use crate::model::run::{EndReason, EstimateBasis, Outcome, Run, Warning};
use crate::tui::message::Place;
use crate::tui::theme::columns;

/// Most rows a message may take; the second on a screen lower than that.
const MESSAGE_ROWS: (usize, usize) = (4, 2);
const LOW: u16 = 20;

impl App {
    /// The message row: error of the open field, newest message, readout, or what the selected variable means; wrapped.
    pub fn message_lines(&self, width: usize) -> Vec<(Severity, String)> {
        let (severity, text) = self.message(width);
        let room = width.saturating_sub(4).max(10);
        let mut lines = wrap(&glued(&text), room);
        // A refused text keeps its whole reason: it is nowhere else.
        let is_kept = self.notice.as_ref().is_some_and(|notice| notice.text == text);
        let most = if self.size.1 < LOW && is_kept { MESSAGE_ROWS.1 } else { MESSAGE_ROWS.0 };
        if lines.len() > most {
            lines.truncate(most);
            let end = if is_kept { " ...: 6:Log" } else { " ..." };
            if let Some(last) = lines.last_mut() {
                *last = clip(last, room.saturating_sub(end.len())).trim_end_matches('.').to_owned()
                    + end;
            }
        }
        lines.into_iter().map(|line| (severity, line.replace('\u{a0}', " "))).collect()
    }

    fn message(&self, width: usize) -> (Severity, String) {
        let field_error = self.editor.field.as_ref().and_then(|field| field.error.clone());
        let in_setup = self.sweeping.field.as_ref().and_then(|field| field.error.clone());
        let in_search = self.searching.field.as_ref().and_then(|field| field.error.clone());
        if let Some(error) = field_error.or(in_setup).or(in_search) {
            return (Severity::Error, error);
        }
        if let Some(notice) = &self.notice {
            return (notice.severity, notice.text.clone());
        }
        if self.dialog.is_some() {
            return (Severity::Note, String::new());
        }
        if self.needs_single_plate()
            && let Err(error) = crate::model::variables::require_single(&self.scene)
        {
            return (Severity::Warning, error.to_string());
        }
        if self.place() == Place::Charts && self.charts.cursor_s.is_some() {
            return (Severity::Note, self.readout());
        }
        if self.place() == Place::Accuracy
            && let Some(text) = self.accuracy_readout()
        {
            return (Severity::Note, text);
        }
        let room = width.saturating_sub(4);
        if let Some(picture) = self.picture() {
            let text = if self.sweeping.on_setup {
                self.setup_readout(picture)
            } else {
                self.sweep_readout(room).unwrap_or_default()
            };
            return (Severity::Note, text);
        }
        if self.place() == Place::Map
            && let Some(text) = self.map_readout()
        {
            return (Severity::Note, text);
        }
        if self.place() == Place::Battery
            && let Some((severity, text)) = self.battery_readout()
        {
            return (severity, text);
        }
        if self.tab == Tab::Limit
            && let Some((severity, text)) = self.limit_readout()
        {
            return (severity, text);
        }
        if self.tab == Tab::Search
            && let Some(text) = self.search_readout()
        {
            return (Severity::Note, text);
        }
        if self.tab == Tab::Thesis
            && let Some(text) = self.thesis_readout()
        {
            return (Severity::Note, text);
        }
        if self.place() == Place::Variables {
            return (Severity::Note, self.variable_words(width.saturating_sub(4)));
        }
        (Severity::Note, String::new())
    }

    /// What the selected variable means, with its source where there is room.
    fn variable_words(&self, room: usize) -> String {
        let variable = self.editor.variable();
        let idle = !crate::model::variables::is_used(variable, &self.scene);
        let note = if idle { " (no effect here)" } else { "" };
        let text = format!("{}{note}: {}", variable.symbol, variable.meaning);
        let long = format!("{text}; {}", variable.source);
        // Cut, not wrapped: the list would move while it is walked through; `?` has all of it.
        if long.chars().count() <= room { long } else { clip(&text, room) }
    }

    /// Whether the tab shows nothing because its study looks at one plate and the scene is a stack.
    pub fn needs_single_plate(&self) -> bool {
        let is_empty = match self.tab {
            Tab::Accuracy => self.accuracy.report.is_none(),
            Tab::Stability => self.place() == Place::Map && self.stability.map.is_none(),
            Tab::Run
            | Tab::Sweep
            | Tab::Surface
            | Tab::Log
            | Tab::Thesis
            | Tab::Search
            | Tab::Limit => false,
        };
        is_empty && crate::model::variables::require_single(&self.scene).is_err()
    }

    /// Everything at the crosshair: the current run in full, the others in the selected chart's quantity.
    pub fn readout(&self) -> String {
        let Some(cursor) = self.charts.cursor_s else {
            return String::new();
        };
        let mut parts = vec![format!("t {}", engineering(cursor, "s"))];
        if let Some(event) = self.event_at_cursor() {
            parts.push(event.to_owned());
        }
        let selected = self.charts.quantities[self.charts.selected];
        let full = [
            Quantity::Penetration,
            Quantity::ContactForce,
            Quantity::ProjectileVelocity,
            Quantity::PlateVelocity,
            Quantity::PlateDisplacement,
        ];
        let views = self.visible_runs();
        for view in views.iter().rev() {
            let quantities: &[Quantity] =
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
        parts.join(" | ")
    }

    /// The parts of the status row, the most important first; the second of a pair is a shorter form.
    pub fn status(&self) -> Vec<(Severity, String, String)> {
        if let Some(picture) = self.picture() {
            return self.sweep_status(picture);
        }
        if self.tab == Tab::Accuracy {
            return self.accuracy_status();
        }
        if self.tab == Tab::Stability {
            return self.stability_status();
        }
        if self.tab == Tab::Limit {
            return self.limit_status();
        }
        if self.tab == Tab::Search {
            return self.search_status();
        }
        if self.tab == Tab::Thesis {
            return self.thesis_status();
        }
        let same = |severity, text: String| (severity, text.clone(), text);
        let mut parts = vec![self.state_words()];
        let Some(shown) = &self.shown else {
            return parts;
        };
        let run = &shown.run;
        if shown.took.is_none() && self.jobs.current.is_some() {
            // What will become of it is not known yet.
            parts.push(same(Severity::Note, "the curve so far".to_owned()));
            return parts;
        }
        // What became of the shot stays in sight on the narrowest screen.
        let severity = |outcome| match outcome {
            Outcome::Arrested | Outcome::Separated => Severity::Note,
            Outcome::Perforated | Outcome::Moving => Severity::Warning,
        };
        parts.push(match &run.stack {
            Some(stack) => {
                let short = format!("stack {}", stack.outcome.word());
                (severity(stack.outcome), stack.sentence(), short)
            }
            None if run.outcome == Outcome::Moving && run.end == EndReason::Swings => {
                same(severity(run.outcome), "moving after 500 swings".to_owned())
            }
            None => same(severity(run.outcome), run.outcome.word().to_owned()),
        });
        parts.extend(demand(run).map(|text| same(Severity::Warning, text)));
        parts.extend(self.validity_part());
        if let Some(estimate) = run.error_estimate {
            parts.push(same(
                Severity::Note,
                match estimate.basis {
                    EstimateBasis::ClosedForm => "exact".to_owned(),
                    EstimateBasis::SecondComputation | EstimateBasis::HalfStep => {
                        format!("err est {:.0e}", estimate.relative)
                    }
                    EstimateBasis::OutcomeDiffers(_) => "err est unknown".to_owned(),
                },
            ));
        }
        let cost = &run.cost;
        parts.push(same(Severity::Note, steps(run)));
        parts.push((
            Severity::Note,
            format!("{} ({})", cost.method, cost.reason),
            cost.method.to_owned(),
        ));
        parts.extend(left_out(run));
        parts
    }

    fn state_words(&self) -> (Severity, String, String) {
        let same = |severity, text: &str| (severity, text.to_owned(), text.to_owned());
        if let Some(job) = &self.jobs.current
            && (self.jobs.overdue || self.shown.as_ref().is_none_or(|shown| shown.took.is_none()))
        {
            let text = job.reached.map_or_else(
                || "running".to_owned(),
                |(t_s, elapsed)| {
                    let (seconds, t) = (elapsed.as_secs_f64(), engineering(t_s, "s"));
                    format!("running for {seconds:.1} s, at t = {t}")
                },
            );
            return same(Severity::Note, &format!("{text} (Esc stops)"));
        }
        if self.jobs.failure.is_some() {
            return same(Severity::Error, "failed: see 6:Log");
        }
        match &self.shown {
            None => same(Severity::Note, "not run yet: r runs"),
            Some(_) if self.is_stale() && self.jobs.current.is_none() => (
                Severity::Warning,
                "old: r runs the changed scene".to_owned(),
                "old: r runs".to_owned(),
            ),
            Some(shown) => match shown.took {
                Some(took) if shown.run.end.is_complete() => {
                    same(Severity::Note, &format!("done {}", show_duration(took)))
                }
                Some(_) => same(Severity::Warning, "ended early"),
                None => same(Severity::Warning, "cancelled: a part is shown"),
            },
        }
    }

    /// The last result in a few lines, for the main screen after leaving.
    pub fn summary(&self) -> String {
        let Some(shown) = &self.shown else {
            return format!("{}: not run", self.base.name);
        };
        let run = &shown.run;
        let name = name_of(&run.scene, &self.base.name, &self.base.scene);
        let mut lines = vec![format!("scene         {name}")];
        lines.extend(results(run));
        // How it ended stands beside the outcome already.
        let ended = Warning::EndedEarly(run.end).to_string();
        let warnings = envelope::warnings(run).into_iter().filter(|text| *text != ended);
        lines.extend(warnings.map(|warning| format!("{:<LABEL$}{warning}", "warning")));
        let room = usize::from(self.size.0).saturating_sub(LABEL).max(LABEL);
        let hang = |line: String| {
            // A label is columns of ASCII.
            let (label, words) = line.split_at_checked(LABEL).unwrap_or((&line, ""));
            let indent = format!("\n{:LABEL$}", "");
            format!("{label}{}", wrap(words, room).join(&indent))
        };
        lines.into_iter().map(hang).collect::<Vec<_>>().join("\n")
    }
}

/// Columns of a label before its words, in the summary and beside the runs.
const LABEL: usize = 14;

/// A warning with the key that acts on it, where there is one.
pub fn warning_text(warning: &Warning) -> String {
    match warning {
        Warning::InterfacePush { .. } | Warning::InterfacePull { .. } => {
            format!("{warning} (key i)")
        }
        Warning::InterfaceWithoutStrength
        | Warning::PenetrationResumed { .. }
        | Warning::EnergyDrift { .. }
        | Warning::EndedEarly(_)
        | Warning::HorizonNotReached { .. }
        | Warning::SeriesThinned { .. }
        | Warning::Model(_)
        | Warning::Limit(_)
        | Warning::PlateMeetsNext { .. }
        | Warning::StillMoving { .. }
        | Warning::NoBaseline => warning.to_string(),
    }
}

/// The results of a run in words, one a line.
pub fn results(run: &Run) -> Vec<String> {
    let mut lines = vec![format!("outcome       {} ({})", run.outcome, run.end.words())];
    let mut add = |name: &str, text: String| lines.push(format!("{name:<LABEL$}{text}"));
    if let Some(arrest) = run.first_arrest {
        let depth = millimetres(Some(arrest.penetration_m));
        add("first arrest", format!("{depth} mm deep at {}", engineering(arrest.t_s, "s")));
    }
    let percent = run
        .percent_of_baseline()
        .map_or_else(String::new, |percent| format!(", {percent:.1} % of a rigid mount's"));
    if run.outcome == Outcome::Perforated {
        let time = run.exit_time_s.map(|t_s| engineering(t_s, "s"));
        add("perforation", format!("at {}", time.unwrap_or_else(|| "-".to_owned())));
        if let Some(speed) = run.residual_velocity_m_s {
            let way = if speed < 0.0 { " backwards: the plate swung over it" } else { "" };
            add("goes on at", format!("{}{way}", engineering(speed.abs(), "m/s")));
        }
    } else {
        match run.at_least.penetration_m {
            Some(_) => {
                let so_far = millimetres(run.at_least.penetration_m);
                add("depth so far", format!("{so_far} mm (lower bound)"));
            }
            None => {
                add("final depth", format!("{} mm{percent}", millimetres(run.final_penetration_m)));
            }
        }
        if run.protrusion_m().is_some() {
            let out = millimetres(run.protrusion_m());
            add("nose", format!("{out} mm out of the rear face"));
        }
    }
    if let Some(margin) = run.mechanism.yield_margin {
        let margin = crate::model::units::fixed_significant(margin, 3);
        add("yield margin", format!("{margin} (strength over greatest stress)"));
    }
    if let Some(peak_n) = run.peak_contact_force_n {
        add("peak force", engineering(peak_n, "N"));
    }
    if run.at_least.plate_displacement_m.is_some() {
        let so_far = millimetres(run.at_least.plate_displacement_m);
        add("plate travel", format!("{so_far} mm so far (lower bound)"));
    }
    if run.max_plate_displacement_m.is_some() {
        add("plate travel", format!("{} mm at most", millimetres(run.max_plate_displacement_m)));
    }
    if let Some(ratio) = run.interface_demand_ratio {
        add("interface", format!("{} of the A S_y it can push", times(ratio)));
    }
    lines
}

/// `10 steps, 2 events`.
fn steps(run: &Run) -> String {
    let (cost, events) = (&run.cost, run.events.len());
    let rejected = match cost.rejected {
        0 => String::new(),
        count => format!(", {count} rejected"),
    };
    let (step, event) = (plural("step", cost.steps), plural("event", events));
    format!("{} {step}{rejected}, {events} {event}", cost.steps)
}

fn plural(word: &str, count: usize) -> String {
    format!("{word}{}", if count == 1 { "" } else { "s" })
}

/// `now`, or the pin's letter.
pub fn short_name(view: &RunView<'_>) -> String {
    view.letter.map_or_else(|| "now".to_owned(), String::from)
}

/// The value at a time with unit, `-` outside the run.
pub fn value_at(run: &Run, quantity: Quantity, t_s: f64) -> String {
    let value = quantity.at(run, t_s);
    if quantity == Quantity::Penetration && value.is_some_and(|depth| depth < 0.0) {
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

/// At most `width` characters; what is cut ends in `..`.
pub fn clip(text: &str, width: usize) -> String {
    if columns(text) <= width {
        return text.to_owned();
    }
    let (kept, _) = text.split_at(fits(text, width.saturating_sub(2)));
    kept.trim_end().to_owned() + ".."
}

/// How many bytes of a text go into so many columns.
fn fits(text: &str, width: usize) -> usize {
    let mut taken = 0;
    text.char_indices()
        .find(|(at, letter)| {
            taken += columns(&text[*at..at + letter.len_utf8()]);
            taken > width
        })
        .map_or(text.len(), |(at, _)| at)
}

/// A result's title with shorter words, still told apart from every other.
pub fn shortened(title: &str) -> String {
    let words = [
        ("first arrest", "1st"),
        ("plate displacement", "travel"),
        ("plate velocity", "speed"),
        ("penetration", "depth"),
        ("percent of", "% of"),
    ];
    words.iter().fold(title.to_owned(), |text, (long, word)| text.replace(long, word))
}

/// A result's title in so many columns: in shorter words where it is too long.
pub fn fitted(title: &str, width: usize) -> String {
    if columns(title) <= width { title.to_owned() } else { clip(&shortened(title), width) }
}

/// What a run could do without, in full and as a number.
fn left_out(run: &Run) -> Option<(Severity, String, String)> {
    let words: Vec<&str> = run.omitted.iter().map(|one| one.words()).collect();
    let full = format!("left out: {}", words.join(", "));
    (!words.is_empty()).then(|| (Severity::Note, full, format!("{} left out", words.len())))
}

/// Lines of at most `width` characters, broken at blanks; a longer word is broken where it must be.
pub fn wrap(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in text.split(' ') {
        let mut word = word.to_owned();
        let needed = columns(&line) + usize::from(!line.is_empty()) + columns(&word);
        if needed > width && !line.is_empty() {
            lines.push(std::mem::take(&mut line));
        }
        while columns(&word) > width {
            // A character that is wider than the line has one of its own.
            let first = word.chars().next().map_or(0, char::len_utf8);
            let rest = word.split_off(fits(&word, width).max(first));
            if rest.is_empty() {
                break;
            }
            lines.push(std::mem::replace(&mut word, rest));
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(&word);
    }
    lines.push(line);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_characters_take_two_columns() {
        let wide = "\u{65e5}\u{672c}\u{8a9e}";
        assert_eq!(columns(wide), 6);
        assert_eq!(clip(wide, 6), wide);
        assert_eq!(clip(wide, 5), "\u{65e5}..");
        assert_eq!(wrap(wide, 4), ["\u{65e5}\u{672c}", "\u{8a9e}"]);
        assert_eq!(wrap(&format!("a {wide} b"), 8), [format!("a {wide}"), "b".to_owned()]);
        // Narrower than any of them: nothing is lost, and it ends.
        assert_eq!(wrap(wide, 1).concat(), wide);
        assert_eq!(wrap("one two", 3), ["one", "two"]);
    }
}
