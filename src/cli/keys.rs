//! `cmra help keys`: every key of the workbench.

use std::fmt::Write as _;

use crate::tui::keymap::{EVERYWHERE, KeyHelp, Keymap, LISTED};
use crate::tui::pages::all_panes;
use crate::tui::widgets::text::wrap;

/// Width of the text of a key, for a terminal of 80 columns.
const HELP_WIDTH: usize = 52;

/// The table of keys: what each means in every pane, then what it does in particular in each.
pub(super) fn page() -> String {
    let map = Keymap::default();
    let mut text = String::from(
        "KEYS\n\nEvery key has one meaning in all panes. `?` in the workbench lists those of the\n\
         focused pane first. Other keys: [keys] in config.toml (see `cmra help scenes`),\n\
         each action by its name in brackets, as in `undo = \"U\"`.\n",
    );
    let line = |text: &mut String, keys: &str, help: &str| {
        for (row, line) in wrap(help, HELP_WIDTH).into_iter().enumerate() {
            let keys = if row == 0 { keys } else { "" };
            let _ = writeln!(text, "  {keys:<20}  {line}");
        }
    };
    let table = |text: &mut String, rows: &[KeyHelp]| {
        for row in rows {
            let names: Vec<&str> = row.keys.iter().map(|(_, name, _)| *name).collect();
            let help = format!("{} [{}]", map.shown(row.meaning), names.join(", "));
            line(text, &map.line_label(row), &help);
        }
    };
    text.push_str("\nIn every pane\n");
    table(&mut text, EVERYWHERE);
    text.push_str("\nIn forms, charts and tables\n");
    table(&mut text, LISTED);
    for pane in all_panes() {
        let _ = writeln!(text, "\n{}", pane.label);
        for row in pane.keys {
            line(&mut text, &map.label(row.action), &map.shown(row.help));
        }
    }
    text
}
