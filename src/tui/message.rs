//! What can happen to the workbench ([`Message`]), what it asks the outside to do ([`Effect`]), and THE key table.
//!
//! Dispatch, the footer, the help overlay and the palette all read [`BINDINGS`]; a test fails when one key would do two things
//! in one place.

use std::path::PathBuf;
use std::time::Duration;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use crate::files::accuracy::Named;
use crate::files::export::ExportRequest;
use crate::model::scene::Scene;
use crate::worker::studies::{Study, StudyReport};
use crate::worker::{Job, Report};

/// What can happen.
#[derive(Clone, Debug)]
pub enum Message {
    /// A key was pressed.
    Key(KeyEvent),
    /// Text was pasted (bracketed paste).
    Paste(String),
    /// The terminal has a new size.
    Resize(u16, u16),
    /// An action was chosen from the palette or the help overlay.
    Act(Action),
    /// A report from the worker.
    Report(Report),
    /// A report from the thread for studies.
    Study(StudyReport),
    /// The quiet time after an edit is over; stale when the serial number is not the newest.
    RunDue(u64),
    /// A job has been running for so long that leaving must not drop it unasked: its number.
    LongJob(u64),
    /// An effect has been carried out, or has failed.
    Done(EffectReport),
    /// A line of the program's own log, for the Log tab (not for the message row).
    Logged(log::Level, String),
}

/// How an effect ended. The texts are for the message row.
#[derive(Clone, Debug)]
pub enum EffectReport {
    /// A preset was saved: its name and path.
    Saved(Result<(String, PathBuf), String>),
    /// An export was written; or the target exists already; or it failed.
    Exported(ExportOutcome),
    /// The presets that can be loaded now.
    Presets(Vec<PresetEntry>),
    /// A scene file was read.
    Loaded(Result<(String, Box<Scene>), String>),
    /// Text was copied (or could not be), and where else it was put.
    Copied(String),
    /// Something could not be done, and why.
    Refused(String),
    /// Names that complete a path.
    Completions(Vec<String>),
}

/// How an export ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExportOutcome {
    /// Written: the files.
    Written(Vec<PathBuf>),
    /// The file exists and was left alone.
    Exists(PathBuf),
    /// Failed, and why.
    Failed(String),
}

/// A preset that can be loaded.
#[derive(Clone, Debug, PartialEq)]
pub struct PresetEntry {
    /// Name to load it by.
    pub name: String,
    /// Where it comes from: `bundled`, `mine` or `recent`.
    pub origin: &'static str,
    /// The scene.
    pub scene: Scene,
    /// The comment block at the head of its file: source and what to expect.
    pub comment: String,
}

/// What the workbench asks the outside to do.
#[derive(Clone, Debug)]
pub enum Effect {
    /// Give the worker a job; a newer job for the same slot replaces an older one.
    Submit(Job),
    /// Stop the running job.
    CancelJob,
    /// Send a message after a delay.
    After(Duration, Message),
    /// Save the scene as a preset of the user's, keeping the comments of an existing file.
    SavePreset {
        /// Name without extension.
        name: String,
        /// The scene.
        scene: Box<Scene>,
        /// Replace an existing preset of this name.
        overwrite: bool,
    },
    /// Write an export.
    Export(Box<ExportRequest>),
    /// Make a study; a newer one replaces an older one.
    Study(Study),
    /// Stop the study that is being made.
    CancelStudy,
    /// Write what was measured of the methods as a table.
    ExportAccuracy {
        /// The CSV file.
        path: PathBuf,
        /// Replace an existing file.
        overwrite: bool,
        /// The scene's name and what was measured.
        found: Box<Named>,
    },
    /// Save the session soon (edits in quick succession are saved once).
    SaveSession,
    /// List presets.
    ListPresets,
    /// Read a scene file.
    Load(PathBuf),
    /// Complete a path.
    Complete(String),
    /// Copy to the clipboard of the terminal (OSC 52), and to a file as a fallback.
    Copy(String),
    /// Capture the mouse or let it go.
    Mouse(bool),
    /// Clear and redraw everything.
    Redraw,
    /// Restore the terminal and stop until `fg`.
    Suspend,
    /// Leave; with the last summary printed on the main screen or without.
    Quit {
        /// Print the summary of the last run after leaving.
        summary: bool,
    },
}

/// Where a key is pressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// Anywhere outside an open field or dialog.
    Anywhere,
    /// The list of variables.
    Variables,
    /// A chart.
    Charts,
    /// The table of runs.
    Runs,
    /// The Accuracy tab.
    Accuracy,
    /// The Log tab.
    Log,
}

/// Everything the workbench can do by a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "each action is described once, in BINDINGS, for people")]
pub enum Action {
    TabRun,
    TabAccuracy,
    TabLog,
    TabNext,
    TabPrevious,
    FocusNext,
    FocusPrevious,
    Up,
    Down,
    First,
    Last,
    PageUp,
    PageDown,
    Edit,
    StepDown,
    StepUp,
    StepDownCoarse,
    StepUpCoarse,
    StepDownFine,
    StepUpFine,
    Reset,
    ResetAll,
    Filter,
    Undo,
    Redo,
    History,
    Pin,
    Unpin,
    Adopt,
    ShowHide,
    Difference,
    Presets,
    Save,
    SaveAs,
    Export,
    Copy,
    Run,
    AutoRun,
    Cancel,
    Back,
    CursorLeft,
    CursorRight,
    CursorLeftFar,
    CursorRightFar,
    EventNext,
    EventPrevious,
    ZoomIn,
    ZoomOut,
    ZoomFit,
    PanLeft,
    PanRight,
    FitVertical,
    Window,
    Quantity,
    SecondAxis,
    NoSecondAxis,
    LogX,
    LogY,
    FullPane,
    Interface,
    Glyphs,
    Theme,
    Mouse,
    Redraw,
    Help,
    Palette,
    Suspend,
    Quit,
    QuitWithSummary,
}

/// A key with its modifiers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Key(pub KeyCode, pub KeyModifiers);

impl Key {
    /// The key as people write it: `Ctrl-r`, `Space`, `Tab`, `G`.
    pub fn words(self) -> String {
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
}

impl Binding {
    /// All its keys, as people write them: `j, Down`.
    pub fn keys_in_words(&self) -> String {
        let mut words: Vec<String> = self.keys.iter().map(|key| key.words()).collect();
        words.dedup();
        words.join(", ")
    }

    /// Whether it only moves within a list: of no use by name.
    pub fn is_movement(&self) -> bool {
        matches!(
            self.action,
            Action::Up
                | Action::Down
                | Action::First
                | Action::Last
                | Action::PageUp
                | Action::PageDown
        )
    }
}

/// One row of the key table.
pub struct Binding {
    /// Where it works.
    pub place: Place,
    /// The keys, the one to show first.
    pub keys: &'static [Key],
    /// What it does.
    pub action: Action,
    /// A few words for the footer: `pin`.
    pub short: &'static str,
    /// A sentence for help and palette.
    pub help: &'static str,
    /// Footer order: 0 is never shown there, 1 is shown first and dropped last.
    pub footer: u8,
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

const fn bind(
    place: Place,
    keys: &'static [Key],
    action: Action,
    short: &'static str,
    help: &'static str,
    footer: u8,
) -> Binding {
    Binding { place, keys, action, short, help, footer }
}

use Action as A;
use KeyCode as C;
use Place::{Accuracy, Anywhere, Charts, Log, Runs, Variables};

/// THE key table.
#[rustfmt::skip]
pub static BINDINGS: &[Binding] = &[
    bind(Anywhere, &[plain('?')], A::Help, "help", "keys and what the selected row means", 1),
    bind(Anywhere, &[plain('q')], A::Quit, "quit", "quit (the session is kept)", 2),
    bind(Anywhere, &[special(C::Esc)], A::Back, "back", "stop a running job, leave the full pane or the filter", 0),
    bind(Anywhere, &[special(C::Tab)], A::FocusNext, "pane", "next pane", 3),
    bind(Anywhere, &[special(C::BackTab), shifted(C::BackTab)], A::FocusPrevious, "previous pane", "previous pane", 0),
    bind(Anywhere, &[plain('p')], A::Presets, "preset", "choose a preset", 5),
    bind(Anywhere, &[plain('e')], A::Export, "export", "export to CSV: runs or, in the Accuracy tab, what was measured", 6),
    bind(Anywhere, &[plain('u')], A::Undo, "undo", "undo the last edit", 7),
    bind(Anywhere, &[ctrl('r')], A::Redo, "redo", "redo", 0),
    bind(Anywhere, &[plain('U')], A::History, "history", "list of edits, old and new", 0),
    bind(Anywhere, &[plain(' ')], A::Pin, "pin", "pin this run to compare with (A to H)", 8),
    bind(Anywhere, &[plain('s')], A::Save, "save", "save the scene as a preset", 9),
    bind(Anywhere, &[plain('S')], A::SaveAs, "save as", "save the scene under another name", 0),
    bind(Anywhere, &[plain('y')], A::Copy, "copy", "copy the run's results to the clipboard (OSC 52)", 0),
    bind(Anywhere, &[plain('i')], A::Interface, "interface", "switch the interface law: fused or plastic", 0),
    bind(Anywhere, &[plain('c')], A::Window, "window", "contact window or whole response", 10),
    bind(Anywhere, &[plain('r')], A::Run, "run", "run now; in the Accuracy tab, measure again", 0),
    bind(Anywhere, &[plain('a')], A::AutoRun, "auto-run", "run after every edit: on or off", 0),
    bind(Anywhere, &[ctrl('c')], A::Cancel, "cancel", "cancel the running job; without one, quit", 0),
    bind(Anywhere, &[plain('z')], A::FullPane, "full", "the focused pane fills the body", 11),
    bind(Anywhere, &[plain('m')], A::Glyphs, "glyphs", "ASCII, block or braille characters", 0),
    bind(Anywhere, &[plain('t')], A::Theme, "theme", "colours: full, sixteen or none", 0),
    bind(Anywhere, &[plain('M')], A::Mouse, "mouse", "let the program have the mouse, or give it back to the terminal", 0),
    bind(Anywhere, &[ctrl('l')], A::Redraw, "redraw", "clear and redraw the screen", 0),
    bind(Anywhere, &[plain(':')], A::Palette, "palette", "find any action by name", 12),
    bind(Anywhere, &[plain('1')], A::TabRun, "Run", "the Run tab", 0),
    bind(Anywhere, &[plain('4')], A::TabAccuracy, "Accuracy", "the Accuracy tab: error against run time of every method", 0),
    bind(Anywhere, &[plain('6')], A::TabLog, "Log", "the Log tab: warnings, events, energy, paths", 0),
    bind(Anywhere, &[plain('}')], A::TabNext, "next tab", "next tab", 0),
    bind(Anywhere, &[plain('{')], A::TabPrevious, "previous tab", "previous tab", 0),
    bind(Anywhere, &[ctrl('z')], A::Suspend, "suspend", "suspend; `fg` comes back", 0),
    bind(Anywhere, &[plain('Q')], A::QuitWithSummary, "quit, summary", "quit and print the last summary", 0),

    bind(Variables, &[plain('k'), special(C::Up)], A::Up, "up", "row above", 0),
    bind(Variables, &[plain('j'), special(C::Down)], A::Down, "down", "row below", 0),
    bind(Variables, &[plain('g'), special(C::Home)], A::First, "first", "first row", 0),
    bind(Variables, &[plain('G'), special(C::End)], A::Last, "last", "last row", 0),
    bind(Variables, &[special(C::PageUp)], A::PageUp, "page up", "a page up", 0),
    bind(Variables, &[special(C::PageDown)], A::PageDown, "page down", "a page down", 0),
    bind(Variables, &[special(C::Enter)], A::Edit, "edit", "edit the value: 25.4mm, 7.5MN/m, 1/3, *2, +5%", 2),
    bind(Variables, &[plain('h'), special(C::Left)], A::StepDown, "less", "one step less", 0),
    bind(Variables, &[plain('l'), special(C::Right)], A::StepUp, "more", "one step more", 4),
    bind(Variables, &[plain('H'), shifted(C::Left)], A::StepDownCoarse, "much less", "ten steps less", 0),
    bind(Variables, &[plain('L'), shifted(C::Right)], A::StepUpCoarse, "much more", "ten steps more", 0),
    bind(Variables, &[plain(',')], A::StepDownFine, "slightly less", "a tenth of a step less", 0),
    bind(Variables, &[plain('.')], A::StepUpFine, "slightly more", "a tenth of a step more", 0),
    bind(Variables, &[plain('d')], A::Reset, "reset", "reset this row to the preset", 0),
    bind(Variables, &[plain('D')], A::ResetAll, "reset all", "reset every row to the preset", 0),
    bind(Variables, &[plain('/')], A::Filter, "filter", "show only rows that match", 0),

    bind(Charts, &[plain('h'), special(C::Left)], A::CursorLeft, "left", "crosshair left", 0),
    bind(Charts, &[plain('l'), special(C::Right)], A::CursorRight, "crosshair", "crosshair right", 2),
    bind(Charts, &[plain('H'), shifted(C::Left)], A::CursorLeftFar, "far left", "crosshair ten columns left", 0),
    bind(Charts, &[plain('L'), shifted(C::Right)], A::CursorRightFar, "far right", "crosshair ten columns right", 0),
    bind(Charts, &[plain('n')], A::EventNext, "event", "crosshair to the next event", 4),
    bind(Charts, &[plain('N')], A::EventPrevious, "previous event", "crosshair to the previous event", 0),
    bind(Charts, &[plain('+'), plain('=')], A::ZoomIn, "zoom", "zoom in about the crosshair", 3),
    bind(Charts, &[plain('-')], A::ZoomOut, "zoom out", "zoom out", 0),
    bind(Charts, &[plain('0')], A::ZoomFit, "fit", "show everything", 5),
    bind(Charts, &[plain('[')], A::PanLeft, "pan left", "pan left", 0),
    bind(Charts, &[plain(']')], A::PanRight, "pan right", "pan right", 0),
    bind(Charts, &[plain('f')], A::FitVertical, "y-fit", "fit the vertical axis to what is in view, or to everything", 0),
    bind(Charts, &[plain('v')], A::Quantity, "quantity", "another quantity in this chart", 6),
    bind(Charts, &[plain('w')], A::SecondAxis, "2nd axis", "another quantity of the same run on an axis at the right", 13),
    bind(Charts, &[plain('W')], A::NoSecondAxis, "no 2nd axis", "take the axis at the right away", 0),
    bind(Charts, &[plain('X')], A::LogX, "log time", "logarithmic or linear time axis", 0),
    bind(Charts, &[plain('Y')], A::LogY, "log value", "logarithmic or linear value axis", 0),
    bind(Charts, &[plain('D')], A::Difference, "difference", "curves as differences to the first pinned run", 0),
    bind(Charts, &[plain('j'), special(C::Down)], A::Down, "next chart", "the chart below", 0),
    bind(Charts, &[plain('k'), special(C::Up)], A::Up, "previous chart", "the chart above", 0),

    bind(Runs, &[plain('k'), special(C::Up)], A::Up, "up", "run above", 0),
    bind(Runs, &[plain('j'), special(C::Down)], A::Down, "down", "run below", 0),
    bind(Runs, &[plain('x'), special(C::Delete)], A::Unpin, "unpin", "unpin this run", 3),
    bind(Runs, &[plain('='), special(C::Enter)], A::Adopt, "adopt", "make this pinned run's scene the current one", 2),
    bind(Runs, &[plain('V')], A::ShowHide, "show/hide", "draw this run or leave it out", 4),
    bind(Runs, &[plain('D')], A::Difference, "difference", "curves as differences to the first pinned run", 0),

    bind(Accuracy, &[plain('k'), special(C::Up)], A::Up, "up", "method above", 0),
    bind(Accuracy, &[plain('j'), special(C::Down)], A::Down, "method", "method below", 3),
    bind(Accuracy, &[plain('g'), special(C::Home)], A::First, "first", "first method", 0),
    bind(Accuracy, &[plain('G'), special(C::End)], A::Last, "last", "last method", 0),
    bind(Accuracy, &[plain('h'), special(C::Left)], A::CursorLeft, "left", "crosshair left: less run time", 0),
    bind(Accuracy, &[plain('l'), special(C::Right)], A::CursorRight, "crosshair", "crosshair right: more run time", 2),
    bind(Accuracy, &[plain('H'), shifted(C::Left)], A::CursorLeftFar, "far left", "crosshair ten columns left", 0),
    bind(Accuracy, &[plain('L'), shifted(C::Right)], A::CursorRightFar, "far right", "crosshair ten columns right", 0),
    bind(Accuracy, &[plain('V'), plain('x')], A::ShowHide, "show/hide", "draw this method or leave it out", 4),

    bind(Log, &[plain('k'), special(C::Up)], A::Up, "up", "scroll up", 0),
    bind(Log, &[plain('j'), special(C::Down)], A::Down, "scroll", "scroll down", 2),
    bind(Log, &[plain('g'), special(C::Home)], A::First, "first", "to the beginning", 0),
    bind(Log, &[plain('G'), special(C::End)], A::Last, "last", "to the end", 0),
    bind(Log, &[special(C::PageUp)], A::PageUp, "page up", "a page up", 0),
    bind(Log, &[special(C::PageDown)], A::PageDown, "page down", "a page down", 0),
];

/// The action of a key in a place, if any: the place's own bindings first, then those that work anywhere.
pub fn action_for(place: Place, key: KeyEvent) -> Option<Action> {
    let pressed = normalise(key);
    let in_place = |wanted: Place| {
        BINDINGS
            .iter()
            .find(|binding| binding.place == wanted && binding.keys.contains(&pressed))
            .map(|binding| binding.action)
    };
    in_place(place).or_else(|| in_place(Anywhere))
}

/// Terminals disagree on whether a capital letter carries SHIFT: drop it for characters.
fn normalise(key: KeyEvent) -> Key {
    match key.code {
        KeyCode::Char(_) => Key(key.code, key.modifiers - KeyModifiers::SHIFT),
        _ => Key(key.code, key.modifiers),
    }
}
