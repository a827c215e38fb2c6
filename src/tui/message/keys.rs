//! THE key table: key, action, and words for people. Knows no state and no screen.
//!
//! Dispatch, the footer, the help overlay and the palette all read [`BINDINGS`]; a test fails when one key would do two things
//! in one place.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::{Action, Place};

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
use Place::{
    Accuracy, Anywhere, Battery, Charts, Claims, Limit, Lines, Log, Map, Principles, Runs,
    Screening, Search, SearchSetup, Setup, Surface, Variables,
};

/// THE key table.
#[rustfmt::skip]
pub static BINDINGS: &[Binding] = &[
    bind(Anywhere, &[plain('?')], A::Help, "help", "keys and what the selected row means", 1),
    bind(Anywhere, &[plain('q')], A::Quit, "quit", "quit (the session is kept)", 2),
    bind(Anywhere, &[special(C::Esc)], A::Back, "back", "stop a running job, leave the full pane or the filter", 0),
    bind(Anywhere, &[special(C::Tab)], A::FocusNext, "pane", "next pane", 3),
    bind(Anywhere, &[special(C::BackTab), shifted(C::BackTab)], A::FocusPrevious, "previous pane", "previous pane", 0),
    bind(Anywhere, &[plain('p')], A::Presets, "preset", "choose a preset", 5),
    bind(Anywhere, &[plain('e')], A::Export, "export", "export to CSV: runs; in the tabs Sweep, Surface, Accuracy, Stability, Thesis, Limit and Search what is shown there", 6),
    bind(Anywhere, &[plain('u')], A::Undo, "undo", "undo the last edit", 7),
    bind(Anywhere, &[ctrl('r')], A::Redo, "redo", "redo", 0),
    bind(Anywhere, &[plain('U')], A::History, "history", "list of edits, old and new", 0),
    bind(Anywhere, &[plain(' ')], A::Pin, "pin", "pin this run to compare with (A to H)", 8),
    bind(Anywhere, &[plain('s')], A::Save, "save", "save the scene as a preset", 9),
    bind(Anywhere, &[plain('S')], A::SaveAs, "save as", "save the scene under another name", 0),
    bind(Anywhere, &[plain('y')], A::Copy, "copy", "copy the run's results to the clipboard (OSC 52)", 0),
    bind(Anywhere, &[plain('i')], A::Interface, "interface", "switch the interface law: fused or plastic", 0),
    bind(Anywhere, &[plain('I')], A::Models, "models", "pin this scene by every interaction model, side by side; again: take them away", 0),
    bind(Anywhere, &[plain('c')], A::Window, "window", "contact window or whole response", 10),
    bind(Anywhere, &[plain('r')], A::Run, "run", "run now; in the tabs that compute, compute again", 0),
    bind(Anywhere, &[plain('a')], A::AutoRun, "auto-run", "run after every edit: on or off", 0),
    bind(Anywhere, &[ctrl('c')], A::Cancel, "cancel", "cancel the running job; without one, quit", 0),
    bind(Anywhere, &[plain('z')], A::FullPane, "full", "the focused pane fills the body", 11),
    bind(Anywhere, &[plain('m')], A::Glyphs, "glyphs", "ASCII, block or braille characters", 0),
    bind(Anywhere, &[plain('t')], A::Theme, "theme", "colours: full, sixteen or none", 0),
    bind(Anywhere, &[plain('M')], A::Mouse, "mouse", "let the program have the mouse (a click selects, a second one opens, the wheel moves or zooms), or give it back", 0),
    bind(Anywhere, &[ctrl('l')], A::Redraw, "redraw", "clear and redraw the screen", 0),
    bind(Anywhere, &[plain(':')], A::Palette, "palette", "find any action by name", 12),
    bind(Anywhere, &[plain('1')], A::TabRun, "Run", "the Run tab", 0),
    bind(Anywhere, &[plain('2')], A::TabSweep, "Sweep", "the Sweep tab: curves over one variable", 0),
    bind(Anywhere, &[plain('3')], A::TabSurface, "Surface", "the Surface tab: a map over two variables", 0),
    bind(Anywhere, &[plain('4')], A::TabAccuracy, "Accuracy", "the Accuracy tab: error against run time of every method", 0),
    bind(Anywhere, &[plain('5')], A::TabStability, "Stability", "the Stability tab: where fixed steps fail, and the battery of stiff scenes", 0),
    bind(Anywhere, &[plain('6')], A::TabLog, "Log", "the Log tab: warnings, events, energy, paths", 0),
    bind(Anywhere, &[plain('7')], A::TabThesis, "Thesis", "the Thesis tab: its claims recomputed, its principles, its screening matrix", 0),
    bind(Anywhere, &[plain('8')], A::TabLimit, "Limit", "the Limit tab: the ballistic limit, and the velocity left beyond it", 0),
    bind(Anywhere, &[plain('9')], A::TabSearch, "Search", "the Search tab: goal seek, the best designs, what matters, scatter, mass efficiency", 0),
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

    bind(Setup, &[plain('k'), special(C::Up)], A::Up, "up", "row above", 0),
    bind(Setup, &[plain('j'), special(C::Down)], A::Down, "row", "row below", 3),
    bind(Setup, &[plain('g'), special(C::Home)], A::First, "first", "first row", 0),
    bind(Setup, &[plain('G'), special(C::End)], A::Last, "last", "last row", 0),
    bind(Setup, &[special(C::PageUp)], A::PageUp, "page up", "a page up", 0),
    bind(Setup, &[special(C::PageDown)], A::PageDown, "page down", "a page down", 0),
    bind(Setup, &[special(C::Enter)], A::Edit, "edit", "type a variable, an end (0.5, 7.5MN/m), points, an output, a held value", 2),
    bind(Setup, &[plain('h'), special(C::Left)], A::StepDown, "less", "one step less, or the one before", 0),
    bind(Setup, &[plain('l'), special(C::Right)], A::StepUp, "more", "one step more, or the next one", 4),
    bind(Setup, &[plain('H'), shifted(C::Left)], A::StepDownCoarse, "much less", "ten steps less", 0),
    bind(Setup, &[plain('L'), shifted(C::Right)], A::StepUpCoarse, "much more", "ten steps more", 0),
    bind(Setup, &[plain(',')], A::StepDownFine, "slightly less", "a tenth of a step less", 0),
    bind(Setup, &[plain('.')], A::StepUpFine, "slightly more", "a tenth of a step more", 0),
    bind(Setup, &[plain('d')], A::Reset, "reset", "reset this held variable to the preset", 0),

    bind(Lines, &[plain('h'), special(C::Left)], A::CursorLeft, "left", "one point left: this design becomes the scene", 0),
    bind(Lines, &[plain('l'), special(C::Right)], A::CursorRight, "move", "one point right: this design becomes the scene", 2),
    bind(Lines, &[plain('H'), shifted(C::Left)], A::CursorLeftFar, "far left", "ten points left", 0),
    bind(Lines, &[plain('L'), shifted(C::Right)], A::CursorRightFar, "far right", "ten points right", 0),
    bind(Lines, &[plain('k'), special(C::Up)], A::Up, "up", "the next curve of the family", 0),
    bind(Lines, &[plain('j'), special(C::Down)], A::Down, "curve", "the curve of the family before", 5),
    bind(Lines, &[special(C::Enter)], A::OpenDesign, "open in Run", "open this design in the Run tab", 3),
    bind(Lines, &[plain('v')], A::Quantity, "output", "the other output", 4),
    bind(Lines, &[plain('Y')], A::LogY, "log", "logarithmic or linear values", 0),

    bind(Surface, &[plain('h'), special(C::Left)], A::CursorLeft, "left", "one point left: this design becomes the scene", 0),
    bind(Surface, &[plain('l'), special(C::Right)], A::CursorRight, "move", "one point right: this design becomes the scene", 2),
    bind(Surface, &[plain('k'), special(C::Up)], A::Up, "up", "one point up", 0),
    bind(Surface, &[plain('j'), special(C::Down)], A::Down, "move", "one point down", 3),
    bind(Surface, &[plain('H'), shifted(C::Left)], A::CursorLeftFar, "far left", "ten points left", 0),
    bind(Surface, &[plain('L'), shifted(C::Right)], A::CursorRightFar, "far right", "ten points right", 0),
    bind(Surface, &[plain('K'), special(C::PageUp)], A::CursorUpFar, "far up", "ten points up", 0),
    bind(Surface, &[plain('J'), special(C::PageDown)], A::CursorDownFar, "far down", "ten points down", 0),
    bind(Surface, &[special(C::Enter)], A::OpenDesign, "open in Run", "open this design in the Run tab", 3),
    bind(Surface, &[plain('v')], A::Quantity, "output", "the other output", 4),
    bind(Surface, &[plain('o')], A::Contour, "contour", "the contour through the cursor: all designs as good as this one", 5),
    bind(Surface, &[plain('F')], A::Difference, "fit", "what a fitted quadratic (its R2 in the status row) leaves over, or the values again", 7),
    bind(Surface, &[plain('Y')], A::LogY, "log", "logarithmic or linear scale of values", 0),

    bind(Accuracy, &[plain('k'), special(C::Up)], A::Up, "up", "method above", 0),
    bind(Accuracy, &[plain('j'), special(C::Down)], A::Down, "method", "method below", 3),
    bind(Accuracy, &[plain('g'), special(C::Home)], A::First, "first", "first method", 0),
    bind(Accuracy, &[plain('G'), special(C::End)], A::Last, "last", "last method", 0),
    bind(Accuracy, &[plain('h'), special(C::Left)], A::CursorLeft, "left", "crosshair left: less run time", 0),
    bind(Accuracy, &[plain('l'), special(C::Right)], A::CursorRight, "crosshair", "crosshair right: more run time", 2),
    bind(Accuracy, &[plain('H'), shifted(C::Left)], A::CursorLeftFar, "far left", "crosshair ten columns left", 0),
    bind(Accuracy, &[plain('L'), shifted(C::Right)], A::CursorRightFar, "far right", "crosshair ten columns right", 0),
    bind(Accuracy, &[plain('V'), plain('x')], A::ShowHide, "show/hide", "draw this method or leave it out", 5),
    bind(Accuracy, &[plain('v')], A::Quantity, "columns", "the next columns of the table, where they do not all fit", 4),
    bind(Accuracy, &[plain('o')], A::SlopeGuides, "slopes", "lines of the slopes that orders 1, 2, 4 and 8 make", 7),
    bind(Accuracy, &[plain('b')], A::SpreadBars, "spread", "the spread of the timings as bars", 0),
    bind(Accuracy, &[plain('+'), plain('=')], A::ZoomIn, "zoom", "zoom in on the run time about the crosshair", 6),
    bind(Accuracy, &[plain('-')], A::ZoomOut, "zoom out", "zoom out", 0),
    bind(Accuracy, &[plain('0')], A::ZoomFit, "fit", "show everything", 0),
    bind(Accuracy, &[plain('[')], A::PanLeft, "pan left", "pan left: less run time", 0),
    bind(Accuracy, &[plain(']')], A::PanRight, "pan right", "pan right: more run time", 0),
    bind(Accuracy, &[plain('X')], A::LogX, "log time", "logarithmic or linear run time", 0),
    bind(Accuracy, &[plain('Y')], A::LogY, "log error", "logarithmic or linear error", 0),

    bind(Map, &[plain('h'), special(C::Left)], A::CursorLeft, "left", "crosshair left: a smaller step", 0),
    bind(Map, &[plain('l'), special(C::Right)], A::CursorRight, "crosshair", "crosshair right: a greater step", 2),
    bind(Map, &[plain('H'), shifted(C::Left)], A::CursorLeftFar, "far left", "crosshair ten columns left", 0),
    bind(Map, &[plain('L'), shifted(C::Right)], A::CursorRightFar, "far right", "crosshair ten columns right", 0),
    bind(Map, &[plain('k'), special(C::Up)], A::Up, "up", "crosshair up", 0),
    bind(Map, &[plain('j'), special(C::Down)], A::Down, "row", "crosshair down", 5),
    bind(Map, &[plain('K'), special(C::PageUp)], A::CursorUpFar, "far up", "crosshair ten rows up", 0),
    bind(Map, &[plain('J'), special(C::PageDown)], A::CursorDownFar, "far down", "crosshair ten rows down", 0),
    bind(Map, &[plain('v')], A::MapVariable, "k, n or b", "the other variable of the map: k, n or b", 3),
    bind(Map, &[plain('w')], A::MapMethod, "method", "the method of the map: the thesis's or classical Runge-Kutta", 4),

    bind(Battery, &[plain('k'), special(C::Up)], A::Up, "up", "scene above", 0),
    bind(Battery, &[plain('j'), special(C::Down)], A::Down, "scene", "scene below", 2),
    bind(Battery, &[plain('g'), special(C::Home)], A::First, "first", "first scene", 0),
    bind(Battery, &[plain('G'), special(C::End)], A::Last, "last", "last scene", 0),
    bind(Battery, &[special(C::PageUp)], A::PageUp, "page up", "a page up", 0),
    bind(Battery, &[special(C::PageDown)], A::PageDown, "page down", "a page down", 0),
    bind(Battery, &[plain('v')], A::Quantity, "columns", "the next columns of the table, where they do not all fit", 3),

    bind(Log, &[plain('k'), special(C::Up)], A::Up, "up", "scroll up", 0),
    bind(Log, &[plain('j'), special(C::Down)], A::Down, "scroll", "scroll down", 2),
    bind(Log, &[plain('g'), special(C::Home)], A::First, "first", "to the beginning", 0),
    bind(Log, &[plain('G'), special(C::End)], A::Last, "last", "to the end", 0),
    bind(Log, &[special(C::PageUp)], A::PageUp, "page up", "a page up", 0),
    bind(Log, &[special(C::PageDown)], A::PageDown, "page down", "a page down", 0),

    bind(Claims, &[plain('k'), special(C::Up)], A::Up, "up", "claim above", 0),
    bind(Claims, &[plain('j'), special(C::Down)], A::Down, "claim", "claim below", 2),
    bind(Claims, &[plain('g'), special(C::Home)], A::First, "first", "first claim", 0),
    bind(Claims, &[plain('G'), special(C::End)], A::Last, "last", "last claim", 0),
    bind(Claims, &[special(C::PageUp)], A::PageUp, "page up", "a page up", 0),
    bind(Claims, &[special(C::PageDown)], A::PageDown, "page down", "a page down", 0),
    bind(Claims, &[special(C::Enter)], A::OpenDesign, "open", "open the claim's sweep in the Sweep or Surface tab, or its scene in the Run tab", 3),
    bind(Claims, &[plain('v')], A::NextVerdict, "verdict", "show only the rows with the next verdict, or all", 4),

    bind(Principles, &[plain('k'), special(C::Up)], A::Up, "up", "principle above", 0),
    bind(Principles, &[plain('j'), special(C::Down)], A::Down, "principle", "principle below", 3),
    bind(Principles, &[plain('g'), special(C::Home)], A::First, "first", "first principle", 0),
    bind(Principles, &[plain('G'), special(C::End)], A::Last, "last", "last principle", 0),
    bind(Principles, &[special(C::Enter)], A::OpenDesign, "open", "open the preset that shows the principle", 2),

    bind(Screening, &[plain('k'), special(C::Up)], A::Up, "up", "criterion above", 0),
    bind(Screening, &[plain('j'), special(C::Down)], A::Down, "criterion", "criterion below", 3),
    bind(Screening, &[plain('g'), special(C::Home)], A::First, "first", "first criterion", 0),
    bind(Screening, &[plain('G'), special(C::End)], A::Last, "last", "last criterion", 0),
    bind(Screening, &[plain('h'), special(C::Left)], A::StepDown, "less", "a percent less weight", 0),
    bind(Screening, &[plain('l'), special(C::Right)], A::StepUp, "weight", "a percent more weight", 2),
    bind(Screening, &[plain('D')], A::ResetAll, "printed", "the printed weights again", 4),
    bind(Screening, &[special(C::Enter)], A::OpenDesign, "open", "open the preset nearest to the first concept", 5),

    bind(Limit, &[plain('h'), special(C::Left)], A::CursorLeft, "left", "crosshair to the slower shot", 0),
    bind(Limit, &[plain('l'), special(C::Right)], A::CursorRight, "shot", "crosshair to the faster shot", 2),
    bind(Limit, &[plain('H'), shifted(C::Left)], A::CursorLeftFar, "far left", "crosshair five shots slower", 0),
    bind(Limit, &[plain('L'), shifted(C::Right)], A::CursorRightFar, "far right", "crosshair five shots faster", 0),
    bind(Limit, &[plain('g'), special(C::Home)], A::First, "first", "crosshair to the slowest shot", 0),
    bind(Limit, &[plain('G'), special(C::End)], A::Last, "last", "crosshair to the fastest shot", 0),
    bind(Limit, &[plain('v')], A::Scatter, "V50", "V50 and spread with every input scattered by 2 %, or without", 3),

    bind(SearchSetup, &[plain('k'), special(C::Up)], A::Up, "up", "row above", 0),
    bind(SearchSetup, &[plain('j'), special(C::Down)], A::Down, "row", "row below", 3),
    bind(SearchSetup, &[plain('g'), special(C::Home)], A::First, "first", "first row", 0),
    bind(SearchSetup, &[plain('G'), special(C::End)], A::Last, "last", "last row", 0),
    bind(SearchSetup, &[special(C::PageUp)], A::PageUp, "page up", "a page up", 0),
    bind(SearchSetup, &[special(C::PageDown)], A::PageDown, "page down", "a page down", 0),
    bind(SearchSetup, &[special(C::Enter)], A::Edit, "edit", "type a variable, bounds (0.8..7, 1e3..1e6:log, off), a goal, a result", 2),
    bind(SearchSetup, &[plain('h'), special(C::Left)], A::StepDown, "less", "the one before, or off", 0),
    bind(SearchSetup, &[plain('l'), special(C::Right)], A::StepUp, "change", "the next one, or on", 4),
    bind(SearchSetup, &[plain('v')], A::SearchNext, "search", "the next search: seek, best designs, what matters, scatter, mass efficiency", 5),

    bind(Search, &[plain('v')], A::SearchNext, "search", "the next search: seek, best designs, what matters, scatter, mass efficiency", 2),
    bind(Search, &[plain('l'), special(C::Right), plain('j'), special(C::Down)], A::CursorRight, "design", "the next design or solution", 3),
    bind(Search, &[plain('h'), special(C::Left), plain('k'), special(C::Up)], A::CursorLeft, "before", "the design or solution before", 0),
    bind(Search, &[plain('L'), shifted(C::Right), special(C::PageDown)], A::CursorRightFar, "far right", "ten designs on", 0),
    bind(Search, &[plain('H'), shifted(C::Left), special(C::PageUp)], A::CursorLeftFar, "far left", "ten designs back", 0),
    bind(Search, &[plain('g'), special(C::Home)], A::First, "first", "the first design or solution", 0),
    bind(Search, &[plain('G'), special(C::End)], A::Last, "last", "the last design or solution", 0),
    bind(Search, &[special(C::Enter)], A::OpenDesign, "open", "load this design into the scene and open the Run tab (u undoes)", 4),
    bind(Search, &[plain('X')], A::LogX, "log across", "logarithmic or linear axis across (best designs)", 0),
    bind(Search, &[plain('Y')], A::LogY, "log up", "logarithmic or linear axis upward (best designs, goal seek)", 0),
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
