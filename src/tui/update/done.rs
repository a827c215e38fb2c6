//! What the reports of effects do: saved, exported, listed, loaded, copied, completed.

use std::path::Path;
use std::sync::Arc;

use tui_input::Input;

use crate::tui::app::notice::Severity;
use crate::tui::app::{App, Base, Origin};
use crate::tui::dialogs::{Dialog, curve};
use crate::tui::message::{Effect, EffectReport, ExportOutcome};
use crate::tui::update::edit;

/// An effect has been carried out, or has failed.
pub(in crate::tui) fn done(app: &mut App, report: EffectReport) -> Vec<Effect> {
    match report {
        EffectReport::Saved(Ok((name, path))) => return saved(app, name, &path),
        EffectReport::Saved(Err(text)) => match &mut app.dialog {
            Some(Dialog::Save(save)) => save.error = Some(text),
            _ => app.say(Severity::Error, text),
        },
        EffectReport::Exported(outcome) => exported(app, outcome),
        EffectReport::Presets(list) => app.presets = list,
        EffectReport::Loaded(Ok((name, scene))) => {
            let base = Base { name, origin: Origin::Other, scene: Arc::new(*scene) };
            return edit::load(app, base);
        }
        EffectReport::Refused(text) | EffectReport::Loaded(Err(text)) => {
            app.say(Severity::Error, text);
        }
        EffectReport::Session(kept) => session(app, &kept),
        EffectReport::Warned(text) => app.say(Severity::Warning, text),
        EffectReport::Copied(text) => app.say(Severity::Note, text),
        EffectReport::Completions(names) => complete(app, names),
        EffectReport::Curve(second, path, points) => {
            return curve::read(app, second, &path, points);
        }
    }
    Vec::new()
}

/// Leaving would lose what is not saved otherwise: it is said, and asked before leaving.
pub(in crate::tui) fn session(app: &mut App, kept: &Result<(), String>) {
    match kept {
        Ok(()) => app.say(Severity::Note, "the session is kept again"),
        Err(why) => {
            let text = format!("the session cannot be kept: {why}; e exports the table");
            app.say(Severity::Warning, text);
        }
    }
    app.session_lost = kept.is_err();
}

fn saved(app: &mut App, name: String, path: &Path) -> Vec<Effect> {
    if matches!(app.dialog, Some(Dialog::Save(_))) {
        app.dialog = None;
    }
    app.say(Severity::Note, format!("saved `{name}` as {}", path.display()));
    app.base = Base { name, origin: Origin::Mine, scene: Arc::clone(&app.scene) };
    vec![Effect::ListPresets, Effect::SaveSession]
}

fn exported(app: &mut App, outcome: ExportOutcome) {
    match (outcome, &mut app.dialog) {
        (ExportOutcome::Written(files), dialog) => {
            if matches!(dialog, Some(Dialog::Export(_) | Dialog::ExportTable(..))) {
                *dialog = None;
            }
            let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
            app.say(Severity::Note, format!("written: {}", names.join(" and ")));
        }
        (ExportOutcome::Exists(_), Some(Dialog::Export(export))) => export.question = true,
        (ExportOutcome::Exists(_), Some(Dialog::ExportTable(_, save))) => save.question = true,
        (ExportOutcome::Failed(text), Some(Dialog::ExportTable(_, save))) => {
            save.error = Some(text);
        }
        (ExportOutcome::Failed(text), Some(Dialog::Export(export))) => export.error = Some(text),
        (ExportOutcome::Exists(path), _) => {
            app.say(Severity::Error, format!("{} exists and was left alone", path.display()));
        }
        (ExportOutcome::Failed(text), _) => app.say(Severity::Error, text),
    }
}

/// One name: take it. Several: what they have in common, and the list.
fn complete(app: &mut App, names: Vec<String>) {
    if let Some(Dialog::Curve(_, save) | Dialog::ExportTable(_, save)) = &mut app.dialog {
        match common_start(&names) {
            Some(common) => (save.input, save.all_selected) = (Input::new(common), false),
            None => save.error = Some("no file or directory begins like this".to_owned()),
        }
        return;
    }
    let Some(Dialog::Export(export)) = &mut app.dialog else {
        return;
    };
    let Some(common) = common_start(&names) else {
        export.error = Some("no file or directory begins like this".to_owned());
        return;
    };
    export.path = Input::new(common);
    export.completions = if names.len() > 1 { names } else { Vec::new() };
}

fn common_start(names: &[String]) -> Option<String> {
    let first = names.first()?;
    let mut length = first.len();
    for name in names {
        let same = first
            .char_indices()
            .zip(name.chars())
            .take_while(|((_, a), b)| a == b)
            .map(|((at, a), _)| at + a.len_utf8())
            .last()
            .unwrap_or(0);
        length = length.min(same);
    }
    Some(first[..length].to_owned())
}
