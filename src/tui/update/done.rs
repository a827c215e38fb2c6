//! What the reports of effects do: saved, exported, listed, loaded, copied, completed.

use std::path::Path;
use std::sync::Arc;

use crate::tui::app::notice::Severity;
use crate::tui::app::{App, Base, Origin};
use crate::tui::dialogs::{Dialog, Purpose, curve, list};
use crate::tui::message::{Effect, EffectReport, ExportOutcome};
use crate::tui::update::edit;

/// An effect has been carried out, or has failed.
pub(in crate::tui) fn done(app: &mut App, report: EffectReport) -> Vec<Effect> {
    match report {
        EffectReport::Saved(Ok((name, path))) => return saved(app, name, &path),
        EffectReport::Saved(Err(text)) => match &mut app.dialog {
            Some(Dialog::Ask(ask)) => ask.text.error = Some(text),
            _ => app.say(Severity::Error, text),
        },
        EffectReport::Exported(outcome) => exported(app, outcome),
        EffectReport::Presets(list) => app.presets = list,
        EffectReport::Loaded(Ok((name, scene))) => {
            app.note_recent(Path::new(&name));
            let base = Base { name, origin: Origin::Other, scene: Arc::new(*scene) };
            return edit::load(app, base);
        }
        EffectReport::Refused(text) | EffectReport::Loaded(Err(text)) => {
            app.say(Severity::Error, text);
        }
        EffectReport::Session(kept) => session(app, &kept),
        EffectReport::Warned(text) => app.say(Severity::Warning, text),
        EffectReport::Copied(text) => app.say(Severity::Note, text),
        EffectReport::Completions(names) => list::complete(app, names),
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
    if matches!(&app.dialog, Some(Dialog::Ask(ask)) if ask.purpose == Purpose::Preset) {
        app.dialog = None;
    }
    app.say(Severity::Note, format!("saved `{name}` as {}", path.display()));
    app.base = Base { name, origin: Origin::Mine, scene: Arc::clone(&app.scene) };
    vec![app.list_presets(), Effect::SaveSession]
}

fn exported(app: &mut App, outcome: ExportOutcome) {
    match (outcome, &mut app.dialog) {
        (ExportOutcome::Written(files), dialog) => {
            if matches!(dialog, Some(Dialog::Export(_) | Dialog::Ask(_))) {
                *dialog = None;
            }
            let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
            app.say(Severity::Note, format!("written: {}", names.join(" and ")));
        }
        (ExportOutcome::Exists(_), Some(Dialog::Export(export))) => export.question = true,
        (ExportOutcome::Exists(_), Some(Dialog::Ask(ask))) => ask.question = true,
        (ExportOutcome::Failed(text), Some(Dialog::Ask(ask))) => ask.text.error = Some(text),
        (ExportOutcome::Failed(text), Some(Dialog::Export(export))) => export.error = Some(text),
        (ExportOutcome::Exists(path), _) => {
            app.say(Severity::Error, format!("{} exists and was left alone", path.display()));
        }
        (ExportOutcome::Failed(text), _) => app.say(Severity::Error, text),
    }
}
