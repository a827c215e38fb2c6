//! Messages for the event loop, and their queue: gives priority to the latest requests of the user.

use std::collections::VecDeque;

use crossterm::event::{KeyEvent, MouseEvent};

use crate::tui::message::Message;

/// Message to the event loop.
pub(super) enum LoopEvent {
    Message(Message),
    Mouse(MouseEvent),
    /// The terminal has received the last frame.
    Arrived,
    /// Signal or lost terminal: quit with this exit status.
    End(u8),
    /// Stop the process (`kill -TSTP`).
    Stop,
    /// The size of the terminal has changed.
    Resized,
    /// The process continues after a stop: take over the terminal again.
    Continued,
}

/// Maximum number of equal consecutive keys in the queue: about 50 ms of work. More would continue to act after the release of a held key.
const REPEATS_MAX: usize = 1000;

/// Queue length from which the cancel key takes priority: about 15 ms of work. Shorter queues are handled in order.
const OVERTAKEN_MIN: usize = 256;

/// Shortens the queue. A request to quit comes first, the cancel key discards the other keys before it, and the number of equal consecutive
/// keys is limited.
pub(super) fn shorten(queue: &mut VecDeque<LoopEvent>, cancels: impl Fn(KeyEvent) -> bool) {
    if queue.len() <= OVERTAKEN_MIN {
        return;
    }
    let ends = |incoming: &LoopEvent| matches!(incoming, LoopEvent::End(_));
    if let Some(at) = queue.iter().position(ends)
        && let Some(end) = queue.remove(at)
    {
        queue.push_front(end);
    }
    let is_cancel = |incoming: &LoopEvent| key_of(incoming).is_some_and(&cancels);
    let cancel = queue.iter().rposition(is_cancel).filter(|at| *at > OVERTAKEN_MIN).unwrap_or(0);
    let (mut at, mut last, mut repeats) = (0, None, 0);
    queue.retain(|incoming| {
        // Pressed twice the key quits.
        let is_overtaken = at < cancel && is_typed(incoming) && !is_cancel(incoming);
        at += 1;
        let key = key_of(incoming);
        if key.is_some() && key == last {
            repeats += 1;
        } else if is_typed(incoming) {
            (last, repeats) = (key, 1);
        }
        !is_overtaken && (key.is_none() || repeats <= REPEATS_MAX)
    });
}

fn key_of(incoming: &LoopEvent) -> Option<KeyEvent> {
    if let LoopEvent::Message(Message::Key(key)) = incoming { Some(*key) } else { None }
}

fn is_typed(incoming: &LoopEvent) -> bool {
    matches!(
        incoming,
        LoopEvent::Message(Message::Key(_) | Message::Paste(_)) | LoopEvent::Mouse(_)
    )
}

#[cfg(test)]
mod tests {
    use crossterm::event::{KeyCode, KeyModifiers};

    use super::*;

    const CANCEL: KeyEvent = KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL);

    fn typed(text: &str) -> Vec<LoopEvent> {
        let key = |c| KeyEvent::new(KeyCode::Char(c), KeyModifiers::NONE);
        text.chars().map(|c| LoopEvent::Message(Message::Key(key(c)))).collect()
    }

    fn cancel() -> LoopEvent {
        LoopEvent::Message(Message::Key(CANCEL))
    }

    /// Formats the queue as text: keys, `^` for the cancel key, `$` for the end, `.` for other messages.
    fn shortened(queue: Vec<LoopEvent>) -> String {
        let mut queue = VecDeque::from(queue);
        shorten(&mut queue, |key| key == CANCEL);
        let word = |incoming: &LoopEvent| match (incoming, key_of(incoming)) {
            (_, Some(key)) if key == CANCEL => '^',
            (_, Some(KeyEvent { code: KeyCode::Char(c), .. })) => c,
            (LoopEvent::End(_), _) => '$',
            _ => '.',
        };
        queue.iter().map(word).collect()
    }

    #[test]
    fn the_key_that_cancels_overtakes_what_was_typed() {
        let mut queue = typed(&"jk".repeat(50_000));
        queue.insert(7, LoopEvent::Resized);
        queue.extend([cancel(), cancel()]);
        queue.extend(typed("xy"));
        assert_eq!(shortened(queue), ".^^xy");
        // A few keys are handled in order.
        let mut few = typed("2l");
        few.push(cancel());
        assert_eq!(shortened(few), "2l^");
    }

    #[test]
    fn a_held_key_stops_soon_after_its_release() {
        let mut queue = typed(&"l".repeat(100_000));
        queue.push(LoopEvent::Arrived);
        queue.extend(typed("lq"));
        assert_eq!(shortened(queue), "l".repeat(REPEATS_MAX) + ".q");
        // All different keys count.
        let different = "jk".repeat(2000);
        assert_eq!(shortened(typed(&different)), different);
    }

    #[test]
    fn a_reason_to_leave_comes_first() {
        let mut queue = typed(&"jk".repeat(2000));
        queue.push(LoopEvent::End(143));
        assert!(shortened(queue).starts_with("$jk"));
    }
}
