//! The key table: keys and the one meaning each has in every pane, what a key does in particular in a pane, and every action by
//! name. `cmra keys`, `?`, the footer, `:` and the routing of keys all read it. Knows no state and no screen.

use std::collections::BTreeMap;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

mod commands;
mod lines;

pub use commands::{Call, Command, commands};
pub(in crate::tui) use lines::Bound;
pub use lines::{LINES, Line, Scope};

use crate::tui::dialogs::options::OptionRow;
use crate::tui::pages::Tab;

/// A pane: what can have the focus, by its tab and its place among the tab's panes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pane {
    /// The tab it is in.
    pub tab: Tab,
    at: u8,
}

impl Pane {
    /// A pane of a tab, each with a number of its own.
    pub const fn of(tab: Tab, at: u8) -> Self {
        Self { tab, at }
    }
}

/// What a page says of a pane.
pub struct PaneSpec {
    /// Which one.
    pub pane: Pane,
    /// Its name in help, palette and messages.
    pub label: &'static str,
    /// What it has for keys to act on.
    pub has: &'static [Part],
    /// What keys do in it in particular, the most useful first: the order of the footer, which drops the last ones on a narrow screen.
    pub keys: &'static [PaneKey],
}

impl PaneSpec {
    /// Whether an action means something in the pane.
    pub fn knows(&self, action: Action) -> bool {
        let line = LINES.iter().find(|line| line.keys.iter().any(|(one, _, _)| *one == action));
        line.is_none_or(|line| line.works_in(self))
    }
}

/// What a pane can have for keys to act on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Rows that have a value to change.
    Form,
    /// A chart that can be zoomed.
    Chart,
    /// A table that can be sorted.
    Table,
}

/// What a key does in particular in a pane.
pub struct PaneKey {
    /// Which: its key is that of the action.
    pub action: Action,
    /// A word or two for the footer: `load`; empty where it stands in help only.
    pub short: &'static str,
    /// A sentence for help.
    pub help: &'static str,
}

/// A row of the keys of a pane.
pub const fn key(action: Action, short: &'static str, help: &'static str) -> PaneKey {
    PaneKey { action, short, help }
}

/// Everything the workbench can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "each action is described once, in the tables, for people")]
pub enum Action {
    Tab(Tab),
    TabNext,
    TabPrevious,
    FocusNext,
    FocusPrevious,
    Up,
    Down,
    Left,
    Right,
    FarLeft,
    FarRight,
    First,
    Last,
    PageUp,
    PageDown,
    Enter,
    Back,
    Find,
    Palette,
    Help,
    Undo,
    Redo,
    Mark,
    View,
    Run,
    Export,
    Copy,
    Presets,
    Save,
    Options,
    FullPane,
    Quit,
    QuitWithSummary,
    Cancel,
    Suspend,
    Redraw,
    FineLess,
    FineMore,
    Reset,
    ZoomIn,
    ZoomOut,
    ZoomFit,
    PanLeft,
    PanRight,
    LogX,
    LogY,
    EventNext,
    EventPrevious,
    Window,
    SecondAxis,
    Difference,
    ShowHide,
    Sort,
    ResetAll,
    History,
    Models,
    Switch(OptionRow),
    FitVertical,
    Contour,
    FitResiduals,
    SlopeGuides,
    SpreadBars,
}

/// A key with its modifiers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Key(pub KeyCode, pub KeyModifiers);

impl Key {
    /// The key as people write it: `Ctrl-r`, `Space`, `Tab`, `G`.
    pub fn label(self) -> String {
        let name = match self.0 {
            KeyCode::Char(' ') => "Space".to_owned(),
            KeyCode::Char(c) => c.to_string(),
            KeyCode::BackTab => "Shift-Tab".to_owned(),
            KeyCode::PageUp => "PgUp".to_owned(),
            KeyCode::PageDown => "PgDn".to_owned(),
            KeyCode::Delete => "Del".to_owned(),
            other => format!("{other}"),
        };
        let mut text = String::new();
        if self.1.contains(KeyModifiers::CONTROL) {
            text.push_str("Ctrl-");
        }
        if self.1.contains(KeyModifiers::SHIFT) && self.0 != KeyCode::BackTab {
            text.push_str("Shift-");
        }
        text + &name
    }

    /// Reads a key as people write it; `None` where it is none.
    pub fn parse(text: &str) -> Option<Self> {
        let lower = text.to_ascii_lowercase();
        let (modifiers, name) = match lower.strip_prefix("ctrl-") {
            Some(_) => (KeyModifiers::CONTROL, &text["ctrl-".len()..]),
            None => (KeyModifiers::NONE, text),
        };
        let mut letters = name.chars();
        let code = match (letters.next(), letters.next(), name.to_ascii_lowercase().as_str()) {
            (Some(c), None, _) if !c.is_control() => KeyCode::Char(c),
            (_, _, "space") => KeyCode::Char(' '),
            (_, _, "tab") => KeyCode::Tab,
            (_, _, "shift-tab") => return Some(Self(KeyCode::BackTab, KeyModifiers::NONE)),
            (_, _, "enter") => KeyCode::Enter,
            (_, _, "esc") => KeyCode::Esc,
            (_, _, "del") => KeyCode::Delete,
            (_, _, "home") => KeyCode::Home,
            (_, _, "end") => KeyCode::End,
            (_, _, "pgup") => KeyCode::PageUp,
            (_, _, "pgdn") => KeyCode::PageDown,
            (_, _, "up") => KeyCode::Up,
            (_, _, "down") => KeyCode::Down,
            (_, _, "left") => KeyCode::Left,
            (_, _, "right") => KeyCode::Right,
            (_, _, other) => KeyCode::F(other.strip_prefix('f')?.parse().ok()?),
        };
        Some(Self(code, modifiers))
    }

    /// The key of an event. Terminals disagree on whether a capital letter carries Shift: it is dropped for characters.
    pub fn of(event: KeyEvent) -> Self {
        match event.code {
            KeyCode::Char(_) | KeyCode::BackTab => {
                Self(event.code, event.modifiers - KeyModifiers::SHIFT)
            }
            _ => Self(event.code, event.modifiers),
        }
    }
}

/// The keys in force: those of the table, with those of the configuration in their place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Keymap {
    keys: BTreeMap<Action, Vec<Key>>,
}

impl Default for Keymap {
    fn default() -> Self {
        let bound = LINES.iter().flat_map(|line| line.keys);
        Self { keys: bound.map(|(action, _, keys)| (*action, keys.to_vec())).collect() }
    }
}

impl Keymap {
    /// The table with other keys for some actions, by their names in the configuration.
    ///
    /// # Errors
    /// Which entry is refused, why, and what is allowed.
    pub fn remapped(wanted: &BTreeMap<String, Vec<String>>) -> Result<Self, String> {
        let mut map = Self::default();
        for (name, keys) in wanted {
            let bound = LINES.iter().flat_map(|line| line.keys).find(|(_, id, _)| id == name);
            let Some((action, _, _)) = bound else {
                return Err(format!(
                    "[keys] {name}: no action has this name; `cmra keys` lists the names"
                ));
            };
            let read = |text: &String| {
                Key::parse(text).ok_or_else(|| {
                    format!("[keys] {name} = \"{text}\": no such key; write U, Ctrl-r, Space, F5")
                })
            };
            map.keys.insert(*action, keys.iter().map(read).collect::<Result<_, _>>()?);
        }
        let mut seen: Vec<(Key, Action)> = Vec::new();
        for (action, keys) in &map.keys {
            for key in keys {
                if let Some((_, other)) = seen.iter().find(|(known, _)| known == key) {
                    let (a, b) = (name(*other), name(*action));
                    let key = key.label();
                    return Err(format!(
                        "[keys] `{key}` would mean both {a} and {b}: give one of them another key"
                    ));
                }
                seen.push((*key, *action));
            }
        }
        Ok(map)
    }

    /// The action of a key: the same in every pane.
    pub fn action(&self, event: KeyEvent) -> Option<Action> {
        let pressed = Key::of(event);
        self.keys.iter().find(|(_, keys)| keys.contains(&pressed)).map(|(action, _)| *action)
    }

    /// The keys of an action.
    pub fn keys(&self, action: Action) -> &[Key] {
        self.keys.get(&action).map_or(&[], Vec::as_slice)
    }

    /// The key to show for an action; empty where it has none.
    pub fn label(&self, action: Action) -> String {
        self.keys(action).first().map_or_else(String::new, |key| key.label())
    }

    /// The keys of a line of the table: `1-7`, `u Ctrl-r`, `h j k l`.
    pub fn line_label(&self, line: &Line) -> String {
        let labels: Vec<String> =
            line.keys.iter().map(|(action, _, _)| self.label(*action)).collect();
        let digits = labels.len() > 2
            && labels.iter().zip('1'..='9').all(|(label, digit)| *label == digit.to_string());
        match (labels.first(), labels.last()) {
            (Some(first), Some(last)) if digits => format!("{first}-{last}"),
            _ => labels.join(" "),
        }
    }
}

/// The name of an action in the configuration.
pub fn name(action: Action) -> &'static str {
    let bound = LINES.iter().flat_map(|line| line.keys);
    bound.clone().find(|(one, _, _)| *one == action).map_or("", |(_, name, _)| name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::pages::all_panes;

    /// No key has two meanings, about twenty lines hold everywhere, and no pane has more than eight of its own.
    #[test]
    fn every_key_has_one_meaning_and_there_are_few_of_them() {
        let mut seen: Vec<Key> = Vec::new();
        for (_, name, keys) in LINES.iter().flat_map(|line| line.keys) {
            for key in *keys {
                assert!(!seen.contains(key), "{name}: {} has a second meaning", key.label());
                seen.push(*key);
            }
        }
        let mut actions: Vec<Action> =
            LINES.iter().flat_map(|line| line.keys).map(|it| it.0).collect();
        let count = actions.len();
        actions.sort();
        actions.dedup();
        assert_eq!(actions.len(), count, "an action stands in two lines");
        let everywhere =
            LINES.iter().filter(|line| matches!(line.scope, Scope::Everywhere)).count();
        assert!(everywhere <= 24, "{everywhere} lines hold everywhere");
        for pane in all_panes() {
            let own = LINES.iter().filter(|line| line.scope != Scope::Everywhere);
            assert!(own.filter(|line| line.works_in(pane)).count() <= 8, "{}", pane.label);
        }
    }

    #[test]
    fn what_a_pane_says_of_its_keys_works_there() {
        for pane in all_panes() {
            for row in pane.keys {
                assert!(pane.knows(row.action), "{:?} in {}", row.action, pane.label);
                assert!(!Keymap::default().keys(row.action).is_empty(), "{:?}", row.action);
            }
        }
    }

    #[test]
    fn keys_are_read_as_they_are_written() {
        for (_, _, keys) in LINES.iter().flat_map(|line| line.keys) {
            for key in keys.iter().filter(|key| !key.1.contains(KeyModifiers::SHIFT)) {
                assert_eq!(Key::parse(&key.label()), Some(*key), "{}", key.label());
            }
        }
        assert_eq!(Key::parse("hyper"), None);
    }

    #[test]
    fn a_configuration_gives_other_keys_and_is_refused_where_a_key_would_mean_two_things() {
        let wanted =
            |name: &str, key: &str| BTreeMap::from([(name.to_owned(), vec![key.to_owned()])]);
        let press = |c: char| KeyEvent::new(KeyCode::Char(c), KeyModifiers::NONE);
        let map = Keymap::remapped(&wanted("undo", "U")).expect("a free key");
        assert_eq!(map.action(press('U')), Some(Action::Undo));
        assert_eq!(map.action(press('u')), None);
        let refused = Keymap::remapped(&wanted("undo", "r")).unwrap_err();
        assert!(refused.contains("both") && refused.contains("undo"), "{refused}");
        assert!(Keymap::remapped(&wanted("undoo", "U")).unwrap_err().contains("cmra keys"));
        assert!(Keymap::remapped(&wanted("undo", "hyper")).unwrap_err().contains("no such key"));
    }
}
