//! Movements of actions: by rows, along a chart, over a map, through choices, and steps of a value.

use crate::tui::keymap::Action;
use crate::tui::widgets::value_steps::StepKey;

/// Returns the number of rows by which an action moves in a list with this many visible rows; `None` for other actions.
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

/// Points or columns of a large movement.
const FAR: isize = 10;

/// Returns the horizontal cursor movement of an action.
pub(crate) fn along(action: Action) -> Option<isize> {
    let StepKey { up, is_far } = step_of(action)?;
    let by = if is_far { FAR } else { 1 };
    Some(if up { by } else { -by })
}

/// Returns the horizontal and vertical cursor movement of an action.
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

/// Moves a cell of a map, within its columns and rows.
pub(crate) fn moved(
    (x, y): (usize, usize),
    (across, up): (isize, isize),
    (columns, rows): (usize, usize),
) -> (usize, usize) {
    let along =
        |at: usize, by, count: usize| at.saturating_add_signed(by).min(count.saturating_sub(1));
    (along(x, across, columns), along(y, up, rows))
}

/// Returns the value step of an action.
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

/// Returns the item a number of places further on, cyclically.
pub(crate) fn around<T: Copy + PartialEq>(all: &[T], one: T, by: isize) -> T {
    let at = all.iter().position(|other| *other == one).unwrap_or(0);
    all[cycled(at, by, all.len())]
}

/// Moves an index within `0..count`, cyclically.
pub(crate) fn cycled(at: usize, by: isize, count: usize) -> usize {
    (at + count).saturating_add_signed(by) % count.max(1)
}
