//! What the Log tab says about the run on the screen and about this session, as lines with a meaning. No drawing.

use crate::model::run::{EnergyLedger, Run, envelope};
use crate::report::figures::run::event_letter;
use crate::report::run::{EnergyTerm, energy_terms, estimate_words};
use crate::tui::app::App;
use crate::tui::app::notice::{Notice, Severity};
use crate::tui::app::status::wrap;
use crate::tui::pages::run::runs::engineering;
use crate::tui::theme::{self, Role};
use crate::tui::widgets::text::text_role;

/// Messages that stand before what is said of the run.
const NEWEST: usize = 5;

/// A line of the Log tab, and what it is.
pub type LogLine = (Role, String);

impl App {
    /// Keep a line of the program's own log; it does not show in the message row.
    pub fn note(&mut self, level: log::Level, text: String) {
        let severity = match level {
            log::Level::Error => Severity::Error,
            log::Level::Warn => Severity::Warning,
            log::Level::Info | log::Level::Debug | log::Level::Trace => Severity::Note,
        };
        self.keep(Notice { severity, text });
    }

    /// Everything the Log tab says, from top to bottom, wrapped for a screen of this many columns.
    pub fn log_lines(&self, columns: usize) -> Vec<LogLine> {
        // Two borders, and three columns of indent with one of air.
        let room = columns.saturating_sub(6).max(10);
        let wanted = self.find.log.trim().to_lowercase();
        let matches = |line: &LogLine| line.1.to_lowercase().contains(&wanted);
        let mut lines = self.whole_lines();
        lines.retain(|line| wanted.is_empty() || matches(line));
        let lines = lines.into_iter();
        lines
            .flat_map(|(role, text)| {
                let fits = theme::columns(&text) <= room;
                let parts = if fits { vec![text] } else { wrap(&text, room) };
                parts.into_iter().map(move |text| (role, text))
            })
            .collect()
    }

    fn whole_lines(&self) -> Vec<LogLine> {
        let mut lines = Vec::new();
        heading(&mut lines, "Messages of this session, newest first");
        if self.log.is_empty() {
            push(&mut lines, Role::Dim, "none".to_owned());
        }
        let (newest, older): (Vec<_>, Vec<_>) =
            self.log.iter().rev().enumerate().partition(|(at, _)| *at < NEWEST);
        let message = |lines: &mut Vec<LogLine>, notice: &Notice| {
            push(
                lines,
                text_role(notice.severity),
                format!("{:<8} {}", notice.severity.word(), notice.text),
            );
        };
        for (_, notice) in newest {
            message(&mut lines, notice);
        }
        if let Some(shown) = &self.shown {
            let which = if self.is_stale() { " (of another scene: press r)" } else { "" };
            warnings(&mut lines, &shown.run, which);
            stack(&mut lines, &shown.run);
            events(&mut lines, &shown.run);
            energy(&mut lines, &shown.run.ledger);
            cost(&mut lines, &shown.run);
        } else {
            heading(&mut lines, "Run");
            push(&mut lines, Role::Dim, "no run yet".to_owned());
        }
        if !older.is_empty() {
            heading(&mut lines, "Older messages");
        }
        for (_, notice) in older {
            message(&mut lines, notice);
        }
        lines
    }
}

fn push(lines: &mut Vec<LogLine>, role: Role, text: String) {
    lines.push((role, text));
}

fn heading(lines: &mut Vec<LogLine>, text: &str) {
    if !lines.is_empty() {
        push(lines, Role::Text, String::new());
    }
    push(lines, Role::Title, text.to_owned());
}

fn warnings(lines: &mut Vec<LogLine>, run: &Run, which: &str) {
    heading(lines, &format!("Warnings of the run{which}"));
    let warnings = envelope::warnings(run);
    if warnings.is_empty() {
        push(lines, Role::Dim, "none".to_owned());
    }
    for warning in warnings {
        push(lines, Role::Warning, format!("! {warning}"));
    }
}

fn stack(lines: &mut Vec<LogLine>, run: &Run) {
    if let Some(stack) = &run.stack {
        heading(lines, "Stack: plate by plate");
        let table = crate::study::stack::table(run, stack).into_iter();
        lines.extend(table.map(|line| (Role::Text, line)));
    }
}

fn events(lines: &mut Vec<LogLine>, run: &Run) {
    heading(lines, "Events");
    if run.events.is_empty() {
        push(lines, Role::Dim, "none".to_owned());
    }
    lines.extend(event_lines(run).into_iter().map(|line| (Role::Text, line)));
}

/// The events with their times, one a line.
pub fn event_lines(run: &Run) -> Vec<String> {
    run.events
        .iter()
        .enumerate()
        .map(|(index, event)| {
            let (tag, time) = (event_letter(index), engineering(event.t_s, "s"));
            format!("{tag:<2}{time:>10}  {}", event.kind.words())
        })
        .collect()
}

fn energy(lines: &mut Vec<LogLine>, ledger: &EnergyLedger) {
    heading(lines, "Energy: where it was at the start, and where it went");
    lines.extend(energy_lines(ledger).into_iter().map(|line| (Role::Text, line)));
}

/// The energy ledger, one term a line, with its share of the energy at the start.
pub fn energy_lines(ledger: &EnergyLedger) -> Vec<String> {
    let line = |term: &EnergyTerm| {
        let percent = crate::model::units::decimals(term.percent, 1);
        format!("{:<13}{:>10}  {percent:>5} %", term.label, engineering(term.energy_j, "J"))
    };
    let (start, end) = energy_terms(ledger);
    let residual = match ledger.residual() {
        0.0 => "0".to_owned(),
        other => crate::model::units::scientific(other, 1),
    };
    let start_j = ledger.initial_j();
    let total = |label, energy_j| line(&EnergyTerm::of(label, energy_j, start_j));
    let mut lines = vec![total("at the start", start_j)];
    // One term alone is the whole.
    lines.extend(start.iter().filter(|_| start.len() > 1).map(line));
    lines.push(total("at the end", ledger.final_j()));
    lines.extend(end.iter().map(line));
    lines.push(format!("{:<13}{residual:>10}  of the start", "residual"));
    lines
}

fn cost(lines: &mut Vec<LogLine>, run: &Run) {
    heading(lines, "Computation");
    let estimate = estimate_words(run, "").unwrap_or_else(|| "not estimated".to_owned());
    let omitted =
        if run.omitted.is_empty() { "nothing".to_owned() } else { run.omitted.join(", ") };
    let cost = &run.cost;
    for (name, text) in [
        ("method", format!("{}: {}", cost.method, cost.reason)),
        (
            "steps",
            format!(
                "{} accepted, {} rejected, {} evaluations",
                cost.steps, cost.rejected, cost.rhs_evaluations
            ),
        ),
        ("end", run.end.words().to_owned()),
        ("error", estimate),
        ("omitted", omitted),
    ] {
        push(lines, Role::Text, format!("{name:<13}{text}"));
    }
}
