//! Key table: the meaning of keys in all panes and in particular panes, and all actions by name. `cmra help keys`, `?`, the footer, `:` and
//! the routing of keys use this table. Does not depend on the state or the screen.

use std::collections::BTreeMap;

use KeyCode as C;
use cmra_studies::enumeration;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use Action as A;

enumeration! {
    /// Tabs, in the order of the title row.
    #[derive(Default, Hash, PartialOrd, Ord)]
    pub enum Tab in TabRow {
        name: &'static str,
    }
    /// Single impact: variables, charts, runs.
    #[default]
    Run { name: "Run" }
    /// Curves or a map of a quantity over one or two variables.
    Explore { name: "Explore" }
    /// Ballistic limit, and comparison at equal areal mass.
    Limit { name: "Limit" }
    /// Goal seek, Pareto front, sensitivity, Monte Carlo.
    Search { name: "Search" }
    /// Accuracy and stability of the methods.
    Numerics { name: "Numerics" }
    /// Thesis: reproduced results, principles, concepts.
    Thesis { name: "Thesis" }
    /// Warnings, events, energy, cost and messages.
    Log { name: "Log" }
}

/// Keys of the tabs.
const TAB_KEYS: &[KeyBinding] = &[
    (A::Tab(Tab::Run), "tab-run", "1"),
    (A::Tab(Tab::Explore), "tab-explore", "2"),
    (A::Tab(Tab::Limit), "tab-limit", "3"),
    (A::Tab(Tab::Search), "tab-search", "4"),
    (A::Tab(Tab::Numerics), "tab-numerics", "5"),
    (A::Tab(Tab::Thesis), "tab-thesis", "6"),
    (A::Tab(Tab::Log), "tab-log", "7"),
];

impl Tab {
    /// Returns the position in the title row, starting at 0.
    pub fn index(self) -> usize {
        self as usize
    }

    /// Returns the text in the title row, with the key of the tab.
    pub(crate) fn title(self, keys: &Keymap) -> String {
        let (key, name) = (keys.label(Action::Tab(self)), self.name());
        if key.is_empty() { name.to_owned() } else { format!("{key}:{name}") }
    }
}

/// Focusable pane, identified by its tab and its index in the tab.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Pane {
    pub tab: Tab,
    at: u8,
}

impl Pane {
    /// Creates a pane of a tab; the index must be unique in the tab.
    pub const fn new(tab: Tab, at: u8) -> Self {
        Self { tab, at }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    Tab(Tab),
    /// Page of the tab, by index.
    Page(usize),
    /// Pane as a whole.
    Pane(Pane),
    Row(Pane, usize),
    Cell(Pane, (usize, usize)),
    /// Value on the horizontal axis of a chart.
    Value {
        pane: Pane,
        chart: usize,
        value: f64,
    },
    /// Row of the list in the open dialog.
    DialogRow(usize),
}

impl Target {
    /// Returns the pane that contains the target.
    pub(crate) fn pane(self) -> Option<Pane> {
        match self {
            Self::Pane(pane)
            | Self::Row(pane, _)
            | Self::Cell(pane, _)
            | Self::Value { pane, .. } => Some(pane),
            Self::Tab(_) | Self::Page(_) | Self::DialogRow(_) => None,
        }
    }
}

pub struct PaneSpec {
    pub pane: Pane,
    /// Name in help, palette and messages.
    pub label: &'static str,
    /// Meanings of keys in the pane, the most useful first; the footer drops the last ones on a narrow screen.
    pub keys: &'static [PaneKey],
}

impl PaneSpec {
    /// Returns `true` if the pane has a meaning for an action.
    pub fn knows(&self, action: Action) -> bool {
        let is_of = |line: &KeyHelp| line.keys.iter().any(|(one, ..)| *one == action);
        !PANE_KEYS.iter().any(is_of) || self.keys.iter().any(|row| row.action == action)
    }
}

pub struct PaneKey {
    /// Action of the displayed key.
    pub action: Action,
    /// Label of one or two words for the footer: `load`; empty for help only.
    pub short: &'static str,
    pub help: &'static str,
}

pub const fn key(action: Action, short: &'static str, help: &'static str) -> PaneKey {
    PaneKey { action, short, help }
}

/// Actions of the workbench.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "each action is described once, in the tables, for people")]
pub enum Action {
    Tab(Tab),
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
    Beside,
    Presets,
    Save,
    Characters,
    Colours,
    Mouse,
    FullPane,
    Quit,
    Cancel,
    Suspend,
    Redraw,
    Reset,
    Window,
    Play,
    Locate,
    ResetAll,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Key(pub KeyCode, pub KeyModifiers);

impl Key {
    /// Keys with a name.
    const NAMED: [(KeyCode, &str); 14] = [
        (C::Char(' '), "Space"),
        (C::Tab, "Tab"),
        (C::BackTab, "Shift-Tab"),
        (C::Enter, "Enter"),
        (C::Esc, "Esc"),
        (C::Delete, "Del"),
        (C::Home, "Home"),
        (C::End, "End"),
        (C::PageUp, "PgUp"),
        (C::PageDown, "PgDn"),
        (C::Up, "Up"),
        (C::Down, "Down"),
        (C::Left, "Left"),
        (C::Right, "Right"),
    ];

    /// Returns the notation of the key: `Ctrl-r`, `Space`, `Tab`, `G`.
    pub fn label(self) -> String {
        let Self(code, modifiers) = self;
        let control = if modifiers.contains(KeyModifiers::CONTROL) { "Ctrl-" } else { "" };
        let has_shift = modifiers.contains(KeyModifiers::SHIFT) && code != KeyCode::BackTab;
        let shift = if has_shift { "Shift-" } else { "" };
        let named = Self::NAMED.iter().find(|(named, _)| *named == code);
        let name = named.map_or_else(|| code.to_string(), |(_, name)| (*name).to_owned());
        format!("{control}{shift}{name}")
    }

    /// Parses the notation of a key; `None` if invalid. Characters have no Shift: a capital letter is a separate key.
    pub fn parse(text: &str) -> Option<Self> {
        let named = |name: &str| {
            let found = Self::NAMED.iter().find(|(_, known)| known.eq_ignore_ascii_case(name));
            found.map(|(code, _)| *code)
        };
        let shifts = |name| named(name).is_some_and(|code| !matches!(code, C::Char(_) | C::Tab));
        let (modifiers, name) = match text.split_once('-') {
            Some((word, name)) if word.eq_ignore_ascii_case("ctrl") => {
                (KeyModifiers::CONTROL, name)
            }
            Some((word, name)) if word.eq_ignore_ascii_case("shift") && shifts(name) => {
                (KeyModifiers::SHIFT, name)
            }
            _ => (KeyModifiers::NONE, text),
        };
        let mut letters = name.chars();
        let code = match (named(name), letters.next(), letters.next()) {
            (Some(code), _, _) => code,
            // Terminals send the lower-case letter for both.
            (None, Some(c), None) if !c.is_control() && modifiers == KeyModifiers::CONTROL => {
                KeyCode::Char(c.to_ascii_lowercase())
            }
            (None, Some(c), None) if !c.is_control() => KeyCode::Char(c),
            (None, Some('f' | 'F'), Some(_)) => KeyCode::F(name[1..].parse().ok()?),
            (None, _, _) => return None,
        };
        Some(Self(code, modifiers))
    }

    /// Converts a key event. Shift is dropped for characters, because terminals differ in whether a capital letter has it.
    pub fn from_event(event: KeyEvent) -> Self {
        match event.code {
            KeyCode::Char(_) | KeyCode::BackTab => {
                Self(event.code, event.modifiers - KeyModifiers::SHIFT)
            }
            _ => Self(event.code, event.modifiers),
        }
    }
}

/// Active keys: those of the table, replaced by those of the configuration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Keymap {
    keys: BTreeMap<Action, Vec<Key>>,
}

impl Default for Keymap {
    fn default() -> Self {
        let read = |keys: &str| keys.split(' ').filter_map(Key::parse).collect();
        Self { keys: bound().map(|(action, _, keys)| (*action, read(keys))).collect() }
    }
}

impl Keymap {
    /// Creates the key map with other keys for some actions, by the actions' names in the configuration.
    pub fn remapped(wanted: &BTreeMap<String, Vec<String>>) -> Result<Self, String> {
        let mut map = Self::default();
        for (name, keys) in wanted {
            let Some((action, _, _)) = bound().find(|(_, id, _)| id == name) else {
                return Err(format!(
                    "[keys] {name}: no action has this name; `cmra help keys` lists the names"
                ));
            };
            let read = |text: &String| {
                Key::parse(text).ok_or_else(|| {
                    format!("[keys] {name} = \"{text}\": no such key; write U, Ctrl-r, Space, F5")
                })
            };
            map.keys.insert(*action, keys.iter().map(read).collect::<Result<_, _>>()?);
        }
        let all =
            || map.keys.iter().flat_map(|(action, keys)| keys.iter().map(move |key| (key, action)));
        for (at, (key, action)) in all().enumerate() {
            if let Some((_, other)) = all().take(at).find(|(known, _)| *known == key) {
                let (key, a, b) = (key.label(), name(*other), name(*action));
                return Err(format!(
                    "[keys] `{key}` would mean both {a} and {b}: give one of them another key"
                ));
            }
        }
        Ok(map)
    }

    /// Returns the global action of a key.
    pub fn action(&self, event: KeyEvent) -> Option<Action> {
        let pressed = Key::from_event(event);
        self.keys.iter().find(|(_, keys)| keys.contains(&pressed)).map(|(action, _)| *action)
    }

    pub fn keys(&self, action: Action) -> &[Key] {
        self.keys.get(&action).map_or(&[], Vec::as_slice)
    }

    /// Returns the displayed key of an action; empty if it has none.
    pub fn label(&self, action: Action) -> String {
        self.keys(action).first().map_or_else(String::new, |key| key.label())
    }

    /// Replaces action names in a text by keys: `press <run>`; an action without a key becomes a command, `:run`.
    pub fn shown(&self, text: &str) -> String {
        if !text.contains('<') {
            return text.to_owned();
        }
        bound().fold(text.to_owned(), |text, (action, id, _)| {
            let mark = format!("<{id}>");
            if !text.contains(&mark) {
                return text;
            }
            let key = self.label(*action);
            text.replace(&mark, &if key.is_empty() { format!(":{id}") } else { key })
        })
    }

    /// Returns the keys of a line of the table: `u Ctrl-r`, `h j k l`.
    pub fn line_label(&self, line: &KeyHelp) -> String {
        let labels = line.keys.iter().map(|(action, _, _)| self.label(*action));
        labels.filter(|label| !label.is_empty()).collect::<Vec<String>>().join(" ")
    }
}

pub fn name(action: Action) -> &'static str {
    bound().find(|(one, _, _)| *one == action).map_or("", |(_, name, _)| name)
}

/// Named command.
pub struct Command {
    pub call: CommandTarget,
    /// Name, starting with a verb.
    pub name: &'static str,
    /// Effect, in some words; empty for a page or the key of a pane, which have a text elsewhere.
    pub what: &'static str,
    /// Further words for the search.
    pub synonyms: &'static str,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommandTarget {
    /// Action in the focused pane.
    Do(Action),
    /// Action in a given pane, which is shown first.
    In(Pane, Action),
    /// Shows a pane, with a page of its tab if there are several.
    Show(Pane, Option<usize>),
}

impl Command {
    pub const fn new(call: CommandTarget, name: &'static str, synonyms: &'static str) -> Self {
        Self { call, name, what: "", synonyms }
    }
}

/// Action, its name in the configuration, and the notation of its keys, the displayed one first.
pub type KeyBinding = (Action, &'static str, &'static str);

pub struct KeyHelp {
    pub keys: &'static [KeyBinding],
    pub meaning: &'static str,
}

const fn line(keys: &'static [KeyBinding], meaning: &'static str) -> KeyHelp {
    KeyHelp { keys, meaning }
}

/// Iterates over all actions that can be bound to keys in the configuration.
pub fn bound() -> impl Iterator<Item = &'static KeyBinding> {
    GLOBAL_KEYS.iter().chain(PANE_KEYS).flat_map(|line| line.keys)
}

/// Keys with the same meaning in all panes.
#[rustfmt::skip]
pub static GLOBAL_KEYS: &[KeyHelp] = &[
    line(TAB_KEYS, "go to the tab; again: its next page"),
    line(&[(A::FocusNext, "next-pane", "Tab"), (A::FocusPrevious, "previous-pane", "Shift-Tab")], "next pane, previous pane"),
    line(&[(A::Left, "left", "h Left"), (A::Down, "down", "j Down"), (A::Up, "up", "k Up"), (A::Right, "right", "l Right")], "move the selection or cursor, as arrows do; <left> <right> change values"),
    line(&[(A::FarLeft, "far-left", "H Shift-Left"), (A::FarRight, "far-right", "L Shift-Right")], "move or change by ten steps"),
    line(&[(A::First, "first", "g Home"), (A::Last, "last", "G End")], "first, last"),
    line(&[(A::PageUp, "page-up", "PgUp"), (A::PageDown, "page-down", "PgDn")], "a page up, a page down"),
    line(&[(A::Enter, "enter", "Enter")], "edit, open, or load the design under the cursor"),
    line(&[(A::Back, "back", "Esc")], "close, or stop the job of this tab"),
    line(&[(A::Find, "find", "/")], "show the variables or lines of the log that match"),
    line(&[(A::Palette, "palette", ":")], "find an action, preset, variable or page by name"),
    line(&[(A::Help, "help", "?")], "keys of this pane, and what the selected row means"),
    line(&[(A::Undo, "undo", "u"), (A::Redo, "redo", "Ctrl-r"), (A::ResetAll, "reset-all", "R")], "undo, redo (any edit); set all variables as in the preset"),
    line(&[(A::Mark, "mark", "Space")], "pin or unpin a run to compare with"),
    line(&[(A::View, "view", "v")], "next view of this pane"),
    line(&[(A::Run, "run", "r")], "run again what this page computes"),
    line(&[(A::Export, "export", "e"), (A::Copy, "copy", "y"), (A::Beside, "beside", "o")], "export, copy what this page shows; open a measured trace"),
    line(&[(A::Presets, "presets", "p"), (A::Save, "save", "s")], "presets, threats, materials and absorbers; save the scene"),
    line(&[(A::Characters, "characters", "m"), (A::Colours, "colours", "t"), (A::Mouse, "mouse", "M")], "next characters, next colours; mouse on or off"),
    line(&[(A::Quit, "quit", "q")], "quit (the session is kept)"),
    line(&[(A::Cancel, "cancel", "Ctrl-c")], "cancel jobs of up to 5 s; pressed twice: quit"),
    line(&[(A::Suspend, "suspend", "Ctrl-z"), (A::Redraw, "redraw", "Ctrl-l")], "suspend (`fg` resumes), redraw the screen"),
];

/// Keys of individual panes.
#[rustfmt::skip]
pub static PANE_KEYS: &[KeyHelp] = &[
    line(&[(A::FullPane, "full-pane", "z")], "show this pane alone"),
    line(&[(A::Reset, "reset", "d Del")], "reset this row"),
    line(&[(A::Window, "window", "c")], "show the contact only, or the whole response"),
    line(&[(A::Play, "play", ".")], "play the impact"),
    line(&[(A::Locate, "locate", "=")], "type where the cursor goes"),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// No key has two meanings, and about twenty lines apply everywhere.
    #[test]
    fn every_key_has_one_meaning_and_there_are_few_of_them() {
        assert_eq!(Keymap::remapped(&BTreeMap::new()), Ok(Keymap::default()));
        let mut actions: Vec<Action> = bound().map(|it| it.0).collect();
        let count = actions.len();
        actions.sort();
        actions.dedup();
        assert_eq!(actions.len(), count, "an action stands in two lines");
        assert!(GLOBAL_KEYS.len() <= 24, "{} lines hold everywhere", GLOBAL_KEYS.len());
    }

    #[test]
    fn keys_are_read_as_they_are_written() {
        for key in bound().flat_map(|(_, _, keys)| keys.split(' ')) {
            assert_eq!(Key::parse(key).map(Key::label).as_deref(), Some(key));
        }
        assert_eq!(Key::parse("Ctrl-R"), Key::parse("ctrl-r"));
        for unknown in ["hyper", "Shift-u", "Shift-Space", "Ctrl-\u{7}"] {
            assert_eq!(Key::parse(unknown), None, "{unknown}");
        }
    }

    #[test]
    fn a_configuration_gives_other_keys_and_is_refused_where_a_key_would_mean_two_things() {
        let wanted =
            |name: &str, key: &str| BTreeMap::from([(name.to_owned(), vec![key.to_owned()])]);
        let press = |c: char| KeyEvent::new(KeyCode::Char(c), KeyModifiers::NONE);
        let map = Keymap::remapped(&wanted("undo", "U")).expect("a free key");
        assert_eq!(map.action(press('U')), Some(Action::Undo));
        assert_eq!(map.action(press('u')), None);
        assert_eq!(map.shown("<undo> undoes, <redo> redoes, a<b"), "U undoes, Ctrl-r redoes, a<b");
        let none =
            Keymap::remapped(&BTreeMap::from([("undo".to_owned(), vec![])])).expect("no key");
        assert_eq!(none.shown("<undo> undoes, <redo> redoes"), ":undo undoes, Ctrl-r redoes");
        let refused = Keymap::remapped(&wanted("undo", "r")).unwrap_err();
        assert!(refused.contains("both") && refused.contains("undo"), "{refused}");
        assert!(Keymap::remapped(&wanted("undoo", "U")).unwrap_err().contains("cmra help keys"));
        assert!(Keymap::remapped(&wanted("undo", "hyper")).unwrap_err().contains("no such key"));
    }
}
