//! Actions as movements: by rows, along a chart, over a map, round a list of choices, of a value.

use crate::tui::keymap::Action;
use crate::tui::widgets::value_steps::StepKey;

/// By how many rows an action moves in a list that shows this many at once; `None` for other actions.
pub(crate) fn rows_moved(action: Action, page: usize) -> Option<isize> {
    let page = isize::try_from(page.max(2) - 1).unwrap_or(1);
    match action {
        Action::Up => Some(-1),
        Action::Down => Some(1),
        Action::PageUp => Some(-page),
        Action::PageDown => Some(page),
        Action::First => Some(isize::MIN / 2),
        Action::Last => Some(isize::MAX / 2),
        _ => None,
    }
}

/// Far, and a page: so many points or columns.
const FAR: isize = 10;

/// How far along an action moves a cursor.
pub(crate) fn along(action: Action) -> Option<isize> {
    let StepKey { up, is_far } = step_of(action)?;
    let by = if is_far { FAR } else { 1 };
    Some(if up { by } else { -by })
}

/// How far along and upward an action moves a cursor.
pub(crate) fn cursor_moved(action: Action) -> Option<(isize, isize)> {
    match action {
        Action::Up => Some((0, 1)),
        Action::Down => Some((0, -1)),
        Action::PageUp => Some((0, FAR)),
        Action::PageDown => Some((0, -FAR)),
        Action::First => Some((isize::MIN / 2, 0)),
        Action::Last => Some((isize::MAX / 2, 0)),
        _ => along(action).map(|by| (by, 0)),
    }
}

/// A cell of a map moved across and upward, within so many columns and rows.
pub(crate) fn moved(
    (x, y): (usize, usize),
    (across, up): (isize, isize),
    (columns, rows): (usize, usize),
) -> (usize, usize) {
    let along =
        |at: usize, by, count: usize| at.saturating_add_signed(by).min(count.saturating_sub(1));
    (along(x, across, columns), along(y, up, rows))
}

/// Up or down, and by how much, an action steps a value.
pub(crate) fn step_of(action: Action) -> Option<StepKey> {
    let (up, is_far) = match action {
        Action::Left => (false, false),
        Action::Right => (true, false),
        Action::FarLeft => (false, true),
        Action::FarRight => (true, true),
        _ => return None,
    };
    Some(StepKey { up, is_far })
}

/// The one by this many places further on, round and round.
pub(crate) fn around<T: Copy + PartialEq>(all: &[T], one: T, by: isize) -> T {
    let at = all.iter().position(|other| *other == one).unwrap_or(0);
    all[cycled(at, by, all.len())]
}

/// `at` moved by a few places within `0..count`, round and round.
pub(crate) fn cycled(at: usize, by: isize, count: usize) -> usize {
    (at + count).saturating_add_signed(by) % count.max(1)
}
