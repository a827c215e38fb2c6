//! State of the tabs.

use crate::tui::app::notice::Notice;
use crate::tui::pages::explore::state::Sweeping;
use crate::tui::pages::limit::state::Ballistic;
use crate::tui::pages::numerics::state::Numerics;
use crate::tui::pages::run::state::RunPage;
use crate::tui::pages::search::state::Searching;
use crate::tui::pages::thesis::state::Thesis;

#[derive(Clone, Debug, Default)]
pub struct States {
    pub run: RunPage,
    pub explore: Sweeping,
    pub limit: Ballistic,
    pub search: Searching,
    pub numerics: Numerics,
    pub thesis: Thesis,
    pub log: Log,
}

#[derive(Clone, Debug, Default)]
pub struct Log {
    /// All messages of this session, oldest first.
    pub messages: Vec<Notice>,
    /// First visible row.
    pub scroll: usize,
    /// Filter text of the lines.
    pub find: String,
}
