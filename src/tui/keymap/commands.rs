//! Every action by name, with the words people look for it by: what `:` finds and the options menu shows.

use super::Action as A;
use super::{Action, Pane};

/// An action that can be called by name.
pub struct Command {
    /// What it does.
    pub action: Action,
    /// Its name, a verb first.
    pub name: &'static str,
    /// Other words it is found by.
    pub synonyms: &'static str,
    /// The pane it acts on, which is shown first; `None`: the one that has the focus.
    pub pane: Option<Pane>,
}

const fn named(action: Action, name: &'static str, synonyms: &'static str) -> Command {
    Command { action, name, synonyms, pane: None }
}

const fn of(pane: Pane, action: Action, name: &'static str, synonyms: &'static str) -> Command {
    Command { action, name, synonyms, pane: Some(pane) }
}

/// All of them: pages first, then what acts anywhere, then what acts on a pane.
#[rustfmt::skip]
pub static COMMANDS: &[Command] = &[
    named(A::TabRun, "Run tab", "variables charts curves impact simulation"),
    named(A::TabExplore, "Explore tab", "sweep surface map family curves parameter study heat map"),
    named(A::TabLimit, "Limit tab", "stopped perforated"),
    named(A::TabSearch, "Search tab", "find a design"),
    named(A::TabNumerics, "Numerics tab", "method solver integrator"),
    named(A::TabThesis, "Thesis tab", "reproduce"),
    named(A::TabLog, "Log tab", "messages warnings events energy paths"),
    named(A::PageGoalSeek, "Goal seek", "seek target solve inverse root"),
    named(A::PageFront, "Pareto front", "optimise optimize best designs knee trade-off"),
    named(A::PageSensitivity, "Sensitivity", "sobol morris importance ranking"),
    named(A::PageMonteCarlo, "Monte Carlo", "uncertainty scatter spread distribution histogram"),
    named(A::PageResidual, "Ballistic limit", "v50 residual velocity perforation recht-ipson lambert-jonas"),
    named(A::PageComparison, "Comparison at equal areal mass", "does it pay mass efficiency compare worth absorber"),
    named(A::PageAccuracy, "Accuracy", "error run time cost method tolerance convergence order"),
    named(A::PageStability, "Stability", "largest stable step fixed step map"),
    named(A::PageBattery, "Stiff scenes", "battery extreme cases"),
    named(A::PageClaims, "Claims", "reproduce thesis check verdict"),
    named(A::PagePrinciples, "Principles", "families functions"),
    named(A::PageScreening, "Screening", "matrix weights criteria concepts"),

    named(A::Help, "Help", "keys"),
    named(A::Options, "Options", "settings preferences menu"),
    named(A::Presets, "Presets", "load open threats materials absorbers scenes file"),
    named(A::Save, "Save the scene", "preset write store"),
    named(A::Export, "Export", "csv write file table"),
    named(A::Copy, "Copy", "clipboard osc 52"),
    named(A::Run, "Run again", "recompute calculate compute"),
    named(A::Undo, "Undo", "take back"),
    named(A::Redo, "Redo", "again"),
    named(A::History, "List of edits", "history undo"),
    named(A::Mark, "Pin this run", "compare keep mark"),
    named(A::ResetAll, "Reset all variables to the preset", "start again default"),
    named(A::FullPane, "Show this pane alone", "full zoom maximise"),
    named(A::Interface, "Switch the interface law", "fused plastic"),
    named(A::Models, "Pin this scene by every contact model", "compare interaction half-sine initial velocity lumped appendix"),
    named(A::AutoRun, "Switch auto-run", "run after every edit"),
    named(A::Glyphs, "Next set of characters", "ascii block braille glyphs"),
    named(A::Theme, "Next set of colours", "theme colors"),
    named(A::Mouse, "Switch the mouse", "click wheel release"),
    named(A::Redraw, "Redraw the screen", "clear refresh"),
    named(A::Suspend, "Suspend", "shell background"),
    named(A::Quit, "Quit", "exit leave"),
    named(A::QuitWithSummary, "Quit with a summary", "exit print"),

    of(Pane::Variables, A::Find, "Find a variable", "filter search"),
    of(Pane::Charts, A::View, "Next quantity of the chart", "velocity force displacement stress yield"),
    of(Pane::Charts, A::Window, "Contact or whole response", "window time"),
    of(Pane::Charts, A::SecondAxis, "Second axis of the chart", "right"),
    of(Pane::Charts, A::Difference, "Differences to the first pinned run", "compare subtract"),
    of(Pane::Charts, A::EventNext, "Next event", "arrest cursor"),
    of(Pane::Charts, A::FitVertical, "Fit the vertical axis to the view or to everything", "scale"),
    of(Pane::Charts, A::LogX, "Logarithmic or linear time axis", "log x"),
    of(Pane::Charts, A::LogY, "Logarithmic or linear value axis", "log y"),
    of(Pane::Charts, A::ZoomFit, "Show everything", "fit zoom"),
    of(Pane::Explore, A::Contour, "Contour through the cursor", "level line"),
    of(Pane::Explore, A::FitResiduals, "Toggle residuals of the quadratic fit", "response surface r2"),
    of(Pane::Accuracy, A::SlopeGuides, "Toggle reference slopes", "order guides"),
    of(Pane::Accuracy, A::SpreadBars, "Toggle bars of the timings", "spread"),
];
