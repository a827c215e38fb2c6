//! What keys do in particular in a pane: the words of the footer and of the first part of help.

use super::Action as A;
use super::{Action, Pane};

/// A key in a pane.
pub struct PaneKey {
    /// Where.
    pub pane: Pane,
    /// Which: its key is that of the action.
    pub action: Action,
    /// A word or two for the footer: `load`.
    pub short: &'static str,
    /// A sentence for help.
    pub help: &'static str,
}

const fn of(pane: Pane, action: Action, short: &'static str, help: &'static str) -> PaneKey {
    PaneKey { pane, action, short, help }
}

/// Pane by pane, the most useful first: the order of the footer, which drops the last ones on a narrow screen.
#[rustfmt::skip]
pub static PANE_KEYS: &[PaneKey] = &[
    of(Pane::Variables, A::Enter, "type", "type the value: 25.4mm, 7.5MN/m, 1/3, *2, +5%; of a choice, list its words"),
    of(Pane::Variables, A::Right, "change", "change the value by a step (H L ten steps, , . a tenth)"),
    of(Pane::Variables, A::Down, "move", "move to another variable"),
    of(Pane::Variables, A::Find, "find", "find a variable by symbol or word"),
    of(Pane::Variables, A::Mark, "pin", "pin this run to compare with (A to H)"),
    of(Pane::Variables, A::Reset, "reset", "reset this row to the preset's value"),

    of(Pane::Charts, A::Right, "cursor", "move the cursor in time (H L ten columns)"),
    of(Pane::Charts, A::View, "view", "show another quantity in this chart, or force over displacement"),
    of(Pane::Charts, A::EventNext, "event", "move the cursor to the next event"),
    of(Pane::Charts, A::ZoomIn, "zoom", "zoom about the cursor"),
    of(Pane::Charts, A::Window, "window", "show the contact only, or the whole response"),
    of(Pane::Charts, A::Down, "chart", "select the chart below or above"),
    of(Pane::Charts, A::Mark, "pin", "pin this run to compare with (A to H)"),
    of(Pane::Charts, A::SecondAxis, "2nd axis", "show another quantity of the same run on an axis at the right, at last none"),

    of(Pane::Runs, A::Enter, "load", "load this pinned run's scene"),
    of(Pane::Runs, A::Mark, "pin/unpin", "pin the current run, or unpin the selected one"),
    of(Pane::Runs, A::ShowHide, "show/hide", "draw this run or leave it out"),
    of(Pane::Runs, A::Difference, "difference", "show curves as differences to the first pinned run"),
    of(Pane::Runs, A::Down, "move", "select another run"),

    of(Pane::ExploreSetup, A::Enter, "type", "type a variable, an end (0.5, 7.5MN/m), a count, a quantity or a held value"),
    of(Pane::ExploreSetup, A::Right, "change", "change the value by a step, or take the next one"),
    of(Pane::ExploreSetup, A::Down, "move", "move to another row"),
    of(Pane::ExploreSetup, A::Find, "find", "find a row of the setup"),

    of(Pane::Explore, A::Right, "cursor", "move the cursor; the scene stays as it is"),
    of(Pane::Explore, A::Enter, "load", "load the design under the cursor into the scene (u undoes)"),
    of(Pane::Explore, A::View, "quantity", "show the next quantity"),
    of(Pane::Explore, A::Mark, "pin", "pin the design under the cursor"),
    of(Pane::Explore, A::ZoomIn, "zoom", "zoom the variable along about the cursor"),
    of(Pane::Explore, A::Down, "curve", "move to another curve, or down the map"),

    of(Pane::Comparison, A::View, "absorber", "compare with the next absorber of the library, or the scene's own"),
    of(Pane::Comparison, A::Enter, "load", "load the scene with this absorber (u undoes)"),

    of(Pane::Residual, A::Right, "shot", "move the cursor to the next faster shot"),
    of(Pane::Residual, A::View, "V50", "compute V50 and its spread with every input scattered by 2 %, or leave it out"),
    of(Pane::Residual, A::Enter, "load", "load the impact velocity under the cursor into the scene (u undoes)"),
    of(Pane::Residual, A::ZoomIn, "zoom", "zoom the impact velocity about the cursor"),

    of(Pane::EfficiencyMap, A::Right, "cursor", "move the cursor; the scene stays as it is"),
    of(Pane::EfficiencyMap, A::Enter, "load", "load the design under the cursor into the scene (u undoes)"),
    of(Pane::EfficiencyMap, A::Mark, "pin", "pin the design under the cursor"),

    of(Pane::SearchSetup, A::Enter, "type", "type a variable, bounds (0.8..7, 1e3..1e6:log, off), a goal or a quantity"),
    of(Pane::SearchSetup, A::Right, "change", "take the next value, or switch on and off"),
    of(Pane::SearchSetup, A::Run, "search", "search with this setup"),
    of(Pane::SearchSetup, A::Down, "move", "move to another row"),
    of(Pane::SearchSetup, A::Find, "find", "find a row of the setup"),

    of(Pane::Search, A::Down, "move", "move to the next design or solution"),
    of(Pane::Search, A::Enter, "load", "load this design into the scene (u undoes)"),
    of(Pane::Search, A::Mark, "pin", "pin this design"),
    of(Pane::Search, A::Sort, "sort", "sort the table by the next column"),
    of(Pane::Search, A::View, "axes", "show the next pair of objectives in the chart"),

    of(Pane::Accuracy, A::Down, "method", "select another method"),
    of(Pane::Accuracy, A::Enter, "use", "set the scene's tolerance to what reaches 1e-6 with this method (u undoes)"),
    of(Pane::Accuracy, A::Right, "cursor", "move the cursor in run time"),
    of(Pane::Accuracy, A::ShowHide, "show/hide", "draw this method or leave it out"),
    of(Pane::Accuracy, A::View, "columns", "show the next columns of the table"),
    of(Pane::Accuracy, A::ZoomIn, "zoom", "zoom the run time about the cursor"),

    of(Pane::StabilityMap, A::Right, "cursor", "move the cursor: a greater step, another value"),
    of(Pane::StabilityMap, A::View, "map", "show the map of another variable (k, n, b) or another method"),
    of(Pane::StabilityMap, A::Enter, "load", "load the value under the cursor into the scene (u undoes)"),

    of(Pane::Battery, A::Down, "scene", "select another scene"),
    of(Pane::Battery, A::View, "columns", "show the next columns of the table"),
    of(Pane::Battery, A::Sort, "sort", "sort the table by the next column"),

    of(Pane::Claims, A::Down, "claim", "select another claim"),
    of(Pane::Claims, A::Enter, "open", "load the claim's scene and show it"),
    of(Pane::Claims, A::View, "verdict", "show only the rows with the next verdict, or all"),
    of(Pane::Claims, A::Find, "find", "find a claim"),
    of(Pane::Claims, A::Sort, "sort", "sort the table by the next column"),

    of(Pane::Principles, A::Down, "principle", "select another principle"),
    of(Pane::Principles, A::Enter, "open", "load the preset that shows the principle"),
    of(Pane::Principles, A::Find, "find", "find a principle"),

    of(Pane::Screening, A::Right, "weight", "change the weight by a percent"),
    of(Pane::Screening, A::Down, "criterion", "select another criterion"),
    of(Pane::Screening, A::Reset, "printed", "reset the weight to the printed one"),
    of(Pane::Screening, A::Enter, "open", "load the preset nearest to the first concept"),

    of(Pane::Log, A::Down, "scroll", "scroll"),
    of(Pane::Log, A::Find, "find", "show only the lines that contain a text"),
];
