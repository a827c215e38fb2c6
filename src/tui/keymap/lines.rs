//! The lines of the key table: keys that belong together and what they mean, wherever they work.

use crossterm::event::{KeyCode, KeyModifiers};

use super::Action as A;
use super::{Action, Key, PaneSpec, Part};
use crate::tui::pages::TAB_KEYS;

/// Where a line of the table works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// In every pane.
    Everywhere,
    /// In the panes that have such a part.
    With(Part),
    /// In the panes that list one of its keys.
    Listed,
}

/// An action, its name in the configuration, and its keys, the one to show first.
pub(in crate::tui) type Bound = (Action, &'static str, &'static [Key]);

/// One line of the table.
pub struct Line {
    /// Where it works.
    pub scope: Scope,
    /// Its actions and their keys.
    pub keys: &'static [Bound],
    /// What they always mean.
    pub meaning: &'static str,
}

impl Line {
    /// Whether its keys mean something in a pane.
    pub fn works_in(&self, pane: &PaneSpec) -> bool {
        match self.scope {
            Scope::Everywhere => true,
            Scope::With(part) => pane.has.contains(&part),
            Scope::Listed => pane
                .keys
                .iter()
                .any(|row| self.keys.iter().any(|(action, _, _)| *action == row.action)),
        }
    }
}

const fn plain(c: char) -> Key {
    Key(KeyCode::Char(c), KeyModifiers::NONE)
}

const fn ctrl(c: char) -> Key {
    Key(KeyCode::Char(c), KeyModifiers::CONTROL)
}

const fn special(code: KeyCode) -> Key {
    Key(code, KeyModifiers::NONE)
}

const fn shifted(code: KeyCode) -> Key {
    Key(code, KeyModifiers::SHIFT)
}

const fn everywhere(keys: &'static [Bound], meaning: &'static str) -> Line {
    Line { scope: Scope::Everywhere, keys, meaning }
}

const fn with(part: Part, keys: &'static [Bound], meaning: &'static str) -> Line {
    Line { scope: Scope::With(part), keys, meaning }
}

const fn listed(keys: &'static [Bound], meaning: &'static str) -> Line {
    Line { scope: Scope::Listed, keys, meaning }
}

use KeyCode as C;

/// The key table.
#[rustfmt::skip]
pub static LINES: &[Line] = &[
    everywhere(TAB_KEYS, "go to the tab; again: its next page"),
    everywhere(&[(A::TabPrevious, "previous-tab", &[plain('{')]), (A::TabNext, "next-tab", &[plain('}')])], "previous tab, next tab"),
    everywhere(&[
        (A::FocusNext, "next-pane", &[special(C::Tab)]),
        (A::FocusPrevious, "previous-pane", &[special(C::BackTab)]),
    ], "next pane, previous pane"),
    everywhere(&[
        (A::Left, "left", &[plain('h'), special(C::Left)]),
        (A::Down, "down", &[plain('j'), special(C::Down)]),
        (A::Up, "up", &[plain('k'), special(C::Up)]),
        (A::Right, "right", &[plain('l'), special(C::Right)]),
    ], "move the selection or the cursor (arrows too); in a form h and l change the value"),
    everywhere(&[
        (A::FarLeft, "far-left", &[plain('H'), shifted(C::Left)]),
        (A::FarRight, "far-right", &[plain('L'), shifted(C::Right)]),
    ], "ten steps at once"),
    everywhere(&[
        (A::First, "first", &[plain('g'), special(C::Home)]),
        (A::Last, "last", &[plain('G'), special(C::End)]),
    ], "first, last"),
    everywhere(&[(A::PageUp, "page-up", &[special(C::PageUp)]), (A::PageDown, "page-down", &[special(C::PageDown)])], "a page up, a page down"),
    everywhere(&[(A::Enter, "enter", &[special(C::Enter)])], "edit, open, or load what is under the cursor into the scene"),
    everywhere(&[(A::Back, "back", &[special(C::Esc)])], "close, or stop the job of this tab"),
    everywhere(&[(A::Find, "find", &[plain('/')])], "find in this pane"),
    everywhere(&[(A::Palette, "palette", &[plain(':')])], "find an action, preset, variable or page by name"),
    everywhere(&[(A::Help, "help", &[plain('?')])], "keys of this pane, and what the selected row means"),
    everywhere(&[(A::Undo, "undo", &[plain('u')]), (A::Redo, "redo", &[ctrl('r')])], "undo, redo: scene, setups, pins"),
    everywhere(&[(A::Mark, "mark", &[plain(' ')])], "pin or unpin a run to compare with; mark a row of a table"),
    everywhere(&[(A::View, "view", &[plain('v')])], "next view of this pane"),
    everywhere(&[(A::Run, "run", &[plain('r')])], "run again what this page computes"),
    everywhere(&[(A::Export, "export", &[plain('e')]), (A::Copy, "copy", &[plain('y')])], "export, copy what this page shows"),
    everywhere(&[(A::Presets, "presets", &[plain('p')]), (A::Save, "save", &[plain('s')])], "presets, threats, materials and absorbers; save the scene"),
    everywhere(&[(A::Options, "options", &[plain('o')])], "options: characters, colours, mouse, auto-run, threads, models"),
    everywhere(&[(A::FullPane, "full-pane", &[plain('z')])], "show this pane alone"),
    everywhere(&[(A::Quit, "quit", &[plain('q')]), (A::QuitWithSummary, "quit-with-summary", &[plain('Q')])], "quit (the session is kept), quit and print a summary"),
    everywhere(&[(A::Cancel, "cancel", &[ctrl('c')])], "cancel the job; pressed twice: quit"),
    everywhere(&[(A::Suspend, "suspend", &[ctrl('z')]), (A::Redraw, "redraw", &[ctrl('l')])], "suspend (`fg` comes back), redraw the screen"),

    with(Part::Form, &[(A::FineLess, "fine-less", &[plain(',')]), (A::FineMore, "fine-more", &[plain('.')])], "a tenth of a step less, more"),
    with(Part::Form, &[(A::Reset, "reset", &[plain('d'), special(C::Delete)])], "reset this row"),
    with(Part::Chart, &[(A::ZoomIn, "zoom-in", &[plain('+'), plain('=')]), (A::ZoomOut, "zoom-out", &[plain('-')])], "zoom in, zoom out"),
    with(Part::Chart, &[(A::ZoomFit, "zoom-fit", &[plain('0')])], "show everything"),
    with(Part::Chart, &[(A::PanLeft, "pan-left", &[plain('[')]), (A::PanRight, "pan-right", &[plain(']')])], "pan left, pan right"),
    with(Part::Chart, &[(A::LogX, "log-x", &[plain('X')]), (A::LogY, "log-y", &[plain('Y')])], "logarithmic or linear axis: across, upward"),
    listed(&[(A::EventNext, "next-event", &[plain('n')]), (A::EventPrevious, "previous-event", &[plain('N')])], "cursor to the next event, the previous one"),
    listed(&[(A::Window, "window", &[plain('c')])], "contact only, or the whole response"),
    listed(&[(A::SecondAxis, "second-axis", &[plain('w')])], "another quantity on an axis at the right, at last none"),
    listed(&[(A::Difference, "difference", &[plain('D')])], "curves as differences to the first pinned run"),
    listed(&[(A::ShowHide, "show-hide", &[plain('V')])], "show or hide this curve"),
    with(Part::Table, &[(A::Sort, "sort", &[plain('S')])], "sort by the next column"),
];
