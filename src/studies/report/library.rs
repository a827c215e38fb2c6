//! Entries of a library as a page.

use crate::report::clean;
use crate::report::page::Page;
use crate::study::library::{Entry, Library};

/// Returns the page of a library with its entries.
pub fn page<'a>(library: Library, entries: impl Iterator<Item = &'a Entry>) -> Page {
    let mut page = Page::new(format!("{}: --{} NAME", library.file(), library.key()));
    for entry in entries {
        let own = if entry.own.is_some() { ", your own" } else { "" };
        let name = clean::line(&entry.name);
        page.space();
        page.line(format!("  {name}: {}{own}", clean::line(&entry.title)));
        let status = entry.status.word();
        let lines = [(status, &entry.source), ("note", &entry.note), ("warning", &entry.warning)];
        let lines = lines.map(|(label, words)| (label, clean::line(words)));
        page.entries(lines.iter().map(|(label, words)| (*label, &**words)));
    }
    page
}
