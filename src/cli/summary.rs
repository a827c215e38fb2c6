//! A run as a page of text: what happened first, then the numbers, the energy, the computation, and what to be careful about.

use std::fmt::Write as _;

use crate::cli::run::Computed;
use crate::cli::table::at_top;
use crate::files::clean;
use crate::model::run::envelope::warnings;
use crate::report::run::page::{computation, energy, events, results, sentence};
use crate::study::stack;

pub(super) fn text(computed: &Computed) -> String {
    let run = &computed.run;
    let title = clean::line(&run.scene.title);
    let name = &computed.preset.name;
    let title = if title.is_empty() { name.clone() } else { format!("{name}: {title}") };
    let mut page = title + "\n";
    if let Some(stack) = &run.stack {
        for line in stack::table(run, stack) {
            let _ = writeln!(page, "{line}");
        }
        page.push_str("\nelement 1 in full:\n");
    }
    let _ = writeln!(page, "{}\n", sentence(run));
    for line in results(run) {
        let _ = writeln!(page, "{line}");
    }
    let sections = [
        ("energy", energy(&run.ledger)),
        ("events", events(run)),
        ("computation", computation(run, Some(computed.took))),
    ];
    for (heading, lines) in sections.into_iter().filter(|(_, lines)| !lines.is_empty()) {
        let _ = writeln!(page, "\n{heading}");
        for line in lines {
            let _ = writeln!(page, "  {line}");
        }
    }
    at_top(&page, &warnings(run))
}
