//! The setups of Explore and Search as a session keeps them.

use std::sync::Arc;

use crate::files::session;
use crate::tui::pages::explore::state::{Picture, sweep_of};
use crate::tui::pages::search::state::Setup;
use crate::tui::prelude::*;

impl App {
    pub fn setups(&self) -> session::Setup {
        let (explore, mut sweep) = (&self.pages.explore, sweep_of(&self.scene));
        let picture = session::Explore {
            is_map: explore.picture == Picture::Surface,
            output: sweep.outputs.swap_remove(explore.output_of(&sweep)),
        };
        session::Setup { explore: Some(picture), search: Some(self.pages.search.setup.kept()) }
    }

    /// Take over what was kept, as far as it still means something.
    pub fn restore_setups(&mut self, kept: session::Setup) {
        let picture = kept.explore.unwrap_or_default();
        let explore = &mut self.pages.explore;
        explore.picture = if picture.is_map { Picture::Surface } else { Picture::Line };
        let outputs = sweep_of(&self.scene).outputs;
        explore.output = outputs.iter().position(|it| *it == picture.output).unwrap_or(0);
        let search = kept.search.map_or_else(Setup::default, |kept| Setup::of(&kept));
        self.pages.search.setup = Arc::new(search);
        // Restoring is no edit.
        (self.history, self.effects) = Default::default();
    }
}
