//! The lines of the options menu, each switched by name.

use cmra_studies::enumeration;

enumeration! {
    #[derive(Hash, PartialOrd, Ord)]
    pub enum OptionRow in OptionText {
        name: &'static str,
        meaning: &'static str,
    }
    Characters {
        name: "characters", meaning: "what charts are drawn with: ASCII, blocks or braille dots"
    }
    Colours { name: "colours", meaning: "how many colours the terminal shows" }
    Mouse {
        name: "mouse",
        meaning: "on: a click selects, a second one opens, the wheel moves; off: the terminal selects text"
    }
    /// Whether every edit runs.
    AutoRun { name: "auto-run", meaning: "on: every edit runs at once; off: <run> runs" }
    /// On how many threads sweeps and studies run.
    Threads { name: "threads", meaning: "how many threads sweeps and studies use" }
    Interface {
        name: "interface law",
        meaning: "whether projectile and plate stay together once the projectile stops"
    }
    Contact { name: "contact model", meaning: "the force between projectile and plate" }
}
