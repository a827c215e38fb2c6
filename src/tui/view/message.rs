//! Texts of the message row and the status row. No drawing.

use crate::tui::app::notice::StatusPart;
use crate::tui::pages::{self, note};
use crate::tui::prelude::*;
use crate::tui::theme;
use crate::tui::widgets::text::{clip, fitting};
use cmra_studies::report::wrap::wrap;

const MESSAGE_LINES: usize = 4;
/// Hint at the first start.
const FIRST_LINE: &str = "Move <down>/<up>, change <left>/<right>, type <enter>, <tab-explore> explore, <tab-limit> limit, <help> help.";

impl App {
    /// Returns the lines of the message area: the readout of the cursor or the meaning of the selected row, then the newest message;
    /// wrapped. A message with more lines than the area covers the rows above it.
    pub fn message_lines(&self, width: usize) -> Vec<(Severity, String)> {
        let room = width.saturating_sub(4).max(10);
        let area = usize::from(self.layout().message.height).max(1);
        let readout = self.readout_line(room);
        let mut all = Vec::new();
        let Some((severity, text)) = self.urgent() else {
            let (severity, text) = readout.unwrap_or((Severity::Note, String::new()));
            all.extend(lines(severity, &text, room, (area, " ...")));
            if all.len() < area {
                all.extend(self.pin_hint(room).map(|text| (Severity::Note, text)));
            }
            return all;
        };
        let room = room.saturating_sub(theme::columns(severity.mark()).saturating_sub(1)).max(10);
        let end = self.keymap.shown(" ...: <tab-log>:Log");
        let message = lines(severity, &text, room, (MESSAGE_LINES, &end));
        if message.len() < area {
            all.extend(readout.map(|(severity, text)| (severity, clip(&text, room))));
        }
        all.extend(message);
        all
    }

    /// Returns the hint how to pin the current run and what the run omitted.
    fn pin_hint(&self, room: usize) -> Option<String> {
        let is_shown = self.tab == Tab::Run && self.pins.is_empty() && !self.is_stale();
        let run = &self.shown.as_ref().filter(|_| is_shown)?.run;
        if self.first_run {
            return Some(clip(&self.keymap.shown(FIRST_LINE), room));
        }
        let hint =
            self.keymap.shown("<mark> pins this run to compare, <save> saves, <export> exports");
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

    /// Returns the error of an open field, or the newest message.
    fn urgent(&self) -> Option<(Severity, String)> {
        let typed = self.field().or_else(|| self.place());
        let refused = typed.and_then(|field| field.error.as_ref());
        let refused = refused.map(|error| (Severity::Error, self.keymap.shown(error)));
        let notice = self.notice.as_ref().map(|notice| (notice.severity, notice.text.clone()));
        refused.or(notice)
    }

    /// Returns the readout of the cursor or of the selected row.
    fn readout_line(&self, room: usize) -> Option<(Severity, String)> {
        if self.dialog.is_some() {
            return None;
        }
        let page = pages::page(self.tab);
        let meaning = page.form(self).and_then(|form| Some(form.line()?.meaning.clone()));
        let (severity, text) = note(meaning).or_else(|| page.readout(self, room))?;
        Some((severity, self.keymap.shown(&text)))
    }

    /// Returns the parts of the status row, the most important first; active computations of other tabs follow the first part.
    pub fn status(&self) -> Vec<StatusPart> {
        let mut parts = pages::page(self.tab).status(self);
        let others = pages::all_jobs(self).filter(|(tab, _)| *tab != self.tab && *tab != Tab::Run);
        for (tab, _) in others {
            let part = (Severity::Note, format!("{} is computing", tab.title(&self.keymap)));
            // A tab may have several jobs.
            if !parts.contains(&part) {
                parts.insert(parts.len().min(1), part);
            }
        }
        parts.into_iter().map(|(severity, text)| (severity, self.keymap.shown(&text))).collect()
    }
}

/// Wraps a text to at most this many lines; a shortened text ends in `end`.
fn lines(
    severity: Severity,
    text: &str,
    room: usize,
    (most, end): (usize, &str),
) -> Vec<(Severity, String)> {
    let mut lines = wrap(text, room);
    if lines.len() > most {
        lines.truncate(most);
        if let Some(last) = lines.last_mut() {
            let kept = clip(last, room.saturating_sub(end.len()));
            *last = kept.trim_end_matches('.').to_owned() + end;
        }
    }
    lines.into_iter().map(|line| (severity, line)).collect()
}
