//! The setups of Explore, Limit and Search: what a session keeps of them, as JSON by the name of the tab.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::tui::pages::explore::setup::CURVES;
use crate::tui::pages::explore::state::{Picture, PicturePlan, sweep_of};
use crate::tui::pages::search::kept::KeptSetup;
use crate::tui::prelude::*;

const EXPLORE: &str = "Explore";
const ABSORBER: &str = "Limit: absorber";
const SEARCH: &str = "Search";

/// How Explore shows the sweep of a scene.
#[derive(Serialize, Deserialize)]
#[serde(default)]
struct KeptPicture {
    is_map: bool,
    curves: u64,
    output: String,
}

impl Default for KeptPicture {
    fn default() -> Self {
        let PicturePlan { curves, picture } = PicturePlan::default();
        Self { is_map: picture == Picture::Surface, curves, output: String::new() }
    }
}

impl App {
    pub fn setups(&self) -> BTreeMap<String, String> {
        let (explore, mut sweep) = (&self.pages.explore, sweep_of(&self.scene));
        let picture = KeptPicture {
            is_map: explore.plan.picture == Picture::Surface,
            curves: explore.plan.curves,
            output: sweep.outputs.swap_remove(explore.output_of(&sweep)),
        };
        let search = KeptSetup::of(&self.pages.search.setup);
        let texts = [
            (EXPLORE, serde_json::to_string(&picture).ok()),
            (SEARCH, serde_json::to_string(&search).ok()),
            (ABSORBER, self.pages.limit.absorber.clone()),
        ];
        texts.into_iter().filter_map(|(name, text)| Some((name.to_owned(), text?))).collect()
    }

    /// Take over what was kept, as far as it still means something.
    pub fn restore_setups(&mut self, kept: &BTreeMap<String, String>) {
        let picture: KeptPicture = read(kept, EXPLORE);
        let explore = &mut self.pages.explore;
        explore.plan.picture = if picture.is_map { Picture::Surface } else { Picture::Line };
        explore.plan.curves = picture.curves.clamp(*CURVES.start(), *CURVES.end());
        let outputs = sweep_of(&self.scene).outputs;
        explore.output = outputs.iter().position(|it| *it == picture.output).unwrap_or(0);
        self.pages.limit.absorber = kept.get(ABSORBER).cloned();
        self.pages.search.setup = Arc::new(read::<KeptSetup>(kept, SEARCH).setup());
        // Restoring is no edit.
        (self.history, self.effects) = Default::default();
    }
}

/// What was kept by this name; the usual setup where it means nothing any more.
fn read<T: for<'t> Deserialize<'t> + Default>(kept: &BTreeMap<String, String>, name: &str) -> T {
    kept.get(name).and_then(|text| serde_json::from_str(text).ok()).unwrap_or_default()
}
