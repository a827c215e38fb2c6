//! The texts of the message row and the status row. No drawing.

use crate::tui::app::notice::StatusPart;
use crate::tui::pages::{self, note};
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
        let page = pages::of(self.tab);
        let meaning = page.form(self).and_then(|form| Some(form.line()?.meaning.clone()));
        let (severity, text) = note(meaning).or_else(|| page.readout(self, room))?;
        Some((severity, self.keymap.shown(&text)))
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
}

/// Lines as they are drawn: numbers and units are apart by a plain blank again.
fn plain(severity: Severity, lines: Vec<String>) -> Vec<(Severity, String)> {
    lines.into_iter().map(|line| (severity, line.replace('\u{a0}', " "))).collect()
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
