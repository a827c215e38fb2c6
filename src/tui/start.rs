//! Start-up: creates the initial state from the command line and the last session, and converts the state to a session.

use crate::tui::pages::run::runs::name_of;
use std::path::Path;
use std::sync::Arc;

use super::Options;
use crate::files::bundled::BASELINE;
use crate::files::config;
use crate::files::error::FileError;
use crate::files::paths::Paths;
use crate::files::preset::{self, Preset};
use crate::files::session::{self, Session, SessionFingerprint, View};
use crate::tui::app::notice::Severity;
use crate::tui::app::pins::{LETTERS, Pin};
use crate::tui::app::{App, Settings, edit};
use crate::tui::keymap::Keymap;
use crate::tui::pages::explore::state::{ChartKind, sweep_of};
use crate::tui::pages::search::state::Setup;
use crate::tui::pages::{run, thesis};
use crate::tui::preset::{PresetEntry, ReferencePreset};
use crate::tui::theme::{ColourDepth, GlyphSet, Theme};
use crate::tui::update;
use cmra_engine::model::scene::Scene;

/// Returns the initial state, and the fingerprint of the session file.
pub(super) fn app(options: Options, paths: Option<&Paths>) -> (App, SessionFingerprint) {
    let detected = Theme::detect(environment);
    let theme = Theme { glyphs: options.glyphs.unwrap_or(detected.glyphs), ..detected };
    let directory = std::env::current_dir().unwrap_or_default();
    let mut loaded =
        paths.map_or_else(session::Loaded::default, |paths| session::load(&paths.session_file()));
    let is_first = paths.is_some_and(|paths| !paths.session_file().exists());
    let recent = loaded.session.as_ref().map(|last| last.recent.clone()).unwrap_or_default();
    let kept = match (paths, &loaded.session) {
        (Some(paths), Some(last)) if options.fresh || options.scene.is_some() => {
            keep_previous(last, paths)
        }
        _ => None,
    };
    if options.fresh {
        loaded.session = None;
    }
    let opened = options.scene.as_ref().and_then(|preset| match &preset.origin {
        preset::Origin::File(path) => Some(path.clone()),
        _ => None,
    });
    let mut app = match (options.scene, loaded.session) {
        (Some(preset), _) => {
            let mut app = App::new(base_of(preset), theme, directory);
            thesis::begin(&mut app);
            app
        }
        (None, Some(last)) => {
            let base = base_named(last.preset.as_deref(), &last.scene, paths);
            let mut app = App::new(base, theme, directory);
            restore(&mut app, last, options.glyphs);
            app
        }
        (None, None) => App::new(baseline(), theme, directory),
    };
    if let Some(traces) = options.with {
        run::lay_beside(&mut app, Arc::new(traces));
    }
    app.files.recent = recent;
    if let Some(path) = opened {
        app.note_recent(&path);
    }
    app.first_run = is_first && app.base.name == BASELINE && !app.is_modified();
    if let Some(paths) = paths {
        configure(&mut app, &paths.config, options.glyphs);
    }
    if let Some(text) = loaded.notice {
        app.say(Severity::Warning, text);
    }
    if let Some((severity, text)) = kept {
        app.say(severity, text);
    }
    if paths.is_none() {
        update::session(&mut app, &Err(FileError::NoHome.to_string()));
    }
    (app, loaded.known)
}

/// Applies keys, colours and characters of the configuration; reports invalid settings and keeps their defaults.
fn configure(app: &mut App, path: &Path, glyphs: Option<GlyphSet>) {
    let config = match config::load(path) {
        Ok(config) => config,
        Err(text) => return app.say(Severity::Warning, text),
    };
    let mut refused = Vec::new();
    match Keymap::remapped(&config.keys) {
        Ok(keymap) => {
            app.keymap = keymap;
            let without = config.keys.iter().filter(|(_, keys)| keys.is_empty());
            let text = |name| format!("[keys] {name} = []: no key does it now; `:{name}` does");
            refused.extend(without.map(|(name, _)| text(name)));
        }
        Err(text) => refused.push(text),
    }
    if let (None, Some(word)) = (glyphs, &config.characters) {
        match GlyphSet::named(word) {
            Ok(choice) => {
                app.settings.theme.glyphs = choice.unwrap_or_else(|| GlyphSet::detect(environment));
            }
            Err(error) => refused.push(error),
        }
    }
    if let Some(word) = &config.colours {
        match ColourDepth::named(word) {
            Some(depth) => app.settings.theme.depth = depth,
            None => refused.push(format!("colours = \"{word}\": use none, sixteen, 256 or full")),
        }
    }
    for text in refused {
        app.say(Severity::Warning, format!("{}: {text}", path.display()));
    }
}

/// Stores the last session separately if another start would lose pins or an edited scene. Returns a message for the user.
fn keep_previous(last: &Session, paths: &Paths) -> Option<(Severity, String)> {
    let base = base_named(last.preset.as_deref(), &last.scene, Some(paths));
    let untouched = *base.scene == scene_of_session(last, &base)
        && last.preset.as_deref().is_some_and(|name| preset::resolve(name, Some(paths)).is_ok());
    if untouched && last.pins.is_empty() {
        return None;
    }
    Some(match session::keep(&paths.recent_folder(), last) {
        Ok(_) => {
            let name = label(last);
            let text = format!("the last session ({name}) is kept: <presets> lists it as recent");
            (Severity::Note, text)
        }
        Err(error) => (Severity::Warning, format!("the last session is not kept: {error}")),
    })
}

/// Describes a session in a few words: `cocked, 8 pinned runs`.
fn label(session: &Session) -> String {
    let name = session.preset.as_deref().unwrap_or("a scene");
    // A path is too long for a list.
    let name = name.rsplit('/').next().unwrap_or(name);
    format!("{name}{}", counted_pins(session.pins.len()))
}

/// Returns the entry of a stored session in the list of presets.
pub(super) fn entry_of_session(session: Session, paths: Option<&Paths>) -> PresetEntry {
    let base = base_named(session.preset.as_deref(), &session.scene, paths);
    PresetEntry {
        name: label(&session),
        origin: "recent",
        scene: scene_of_session(&session, &base),
        session: Some(Box::new((base, session))),
        ..PresetEntry::default()
    }
}

/// Returns the part of the state that the session file stores.
pub(super) fn session(app: &App) -> Session {
    let detected = Theme::detect(environment);
    // Store only settings chosen by the user, because the next terminal may differ.
    let Settings { theme, .. } = &app.settings;
    let chosen = |word: &str, is_chosen: bool| is_chosen.then(|| word.to_owned());
    let view = View {
        glyphs: chosen(theme.glyphs.word(), theme.glyphs != detected.glyphs),
        colours: chosen(theme.depth.word(), theme.depth != detected.depth),
    };
    Session {
        scene: (*app.scene).clone(),
        preset: Some(kept_name(app, &app.base)),
        pins: app.pins.iter().map(|pin| (pin.letter.to_string(), (*pin.scene).clone())).collect(),
        view,
        setup: app.setups(),
        recent: app.files.recent.clone(),
    }
}

impl App {
    /// Returns the setups of Explore and Search for the session.
    pub fn setups(&self) -> session::Setup {
        let (explore, mut sweep) = (&self.pages.explore, sweep_of(&self.scene));
        let picture = session::Explore {
            is_map: explore.picture == ChartKind::Surface,
            output: sweep.outputs.swap_remove(explore.output_of(&sweep)),
        };
        session::Setup { explore: Some(picture), search: Some(self.pages.search.setup.kept()) }
    }

    /// Restores stored setups, as far as they are still valid.
    pub fn restore_setups(&mut self, kept: session::Setup) {
        self.take_setups(kept);
        // Restoring is not an edit.
        (self.history, self.effects) = Default::default();
    }

    fn take_setups(&mut self, kept: session::Setup) {
        let picture = kept.explore.unwrap_or_default();
        let explore = &mut self.pages.explore;
        explore.picture = if picture.is_map { ChartKind::Surface } else { ChartKind::Line };
        let outputs = sweep_of(&self.scene).outputs;
        explore.output = outputs.iter().position(|it| *it == picture.output).unwrap_or(0);
        let search = kept.search.map_or_else(Setup::default, |kept| Setup::from_session(&kept));
        self.pages.search.setup = Arc::new(search);
    }

    /// Opens a stored session as one edit: its scene, its pins and its setups.
    pub(crate) fn open_session(&mut self, (base, session): (ReferencePreset, Session)) {
        let before = self.snapshot();
        let label = format!("open {}", label(&session));
        self.pages.run.charts.cursor_s = None;
        self.scene = Arc::new(scene_of_session(&session, &base));
        self.base = base;
        self.pins = pins_of(self, session.pins);
        self.take_setups(session.setup);
        self.report_progress(format!("{label} (<undo> undoes)"));
        edit::opened(self, before, label);
    }
}

/// Returns the name of the scene's preset. A path is stored in full, because the next start may be in another directory with another file
/// of this name.
fn kept_name(app: &App, base: &ReferencePreset) -> String {
    let name = &base.name;
    if !base.is_mine && preset::is_path(name) {
        app.files.directory.join(name).to_str().unwrap_or(name).to_owned()
    } else {
        name.clone()
    }
}

/// Returns a variable of the environment.
pub(super) fn environment(name: &str) -> Option<String> {
    std::env::var(name).ok().filter(|value| !value.is_empty())
}

/// Converts a preset to the reference for edits.
fn base_of(preset: Preset) -> ReferencePreset {
    ReferencePreset {
        is_mine: matches!(preset.origin, preset::Origin::Mine(_)),
        name: preset.name,
        scene: Arc::new(preset.scene),
    }
}

/// Returns the baseline preset. A test checks that bundled presets can be read; the scene's defaults are the baseline in any case.
fn baseline() -> ReferencePreset {
    preset::baseline().map_or_else(
        |_| ReferencePreset { name: BASELINE.to_owned(), is_mine: false, scene: Arc::default() },
        base_of,
    )
}

/// Returns the preset of this name; the scene itself if there is none.
fn base_named(name: Option<&str>, scene: &Scene, paths: Option<&Paths>) -> ReferencePreset {
    name.and_then(|name| preset::resolve(name, paths).ok()).map_or_else(
        || ReferencePreset {
            name: name.unwrap_or("session").to_owned(),
            is_mine: false,
            scene: Arc::new(scene.clone()),
        },
        base_of,
    )
}

/// Returns the session's scene with the title of its preset, because a copy may have another title.
fn scene_of_session(last: &Session, base: &ReferencePreset) -> Scene {
    Scene { title: base.scene.title.clone(), ..last.scene.clone() }
}

/// Restores the session and reports this.
fn restore(app: &mut App, last: Session, glyphs: Option<GlyphSet>) {
    app.scene = Arc::new(scene_of_session(&last, &app.base));
    app.pins = pins_of(app, last.pins);
    let View { glyphs: set, colours } = last.view;
    if glyphs.is_none()
        && let Some(Ok(Some(set))) = set.as_deref().map(GlyphSet::named)
    {
        app.settings.theme.glyphs = set;
    }
    if let Some(depth) = colours.as_deref().and_then(ColourDepth::named) {
        app.settings.theme.depth = depth;
    }
    app.restore_setups(last.setup);
    let modified = if app.is_modified() { ", modified" } else { "" };
    let pins = counted_pins(app.pins.len());
    let name = &app.base.name;
    app.report_progress(format!("session restored: {name}{modified}{pins} (or: cmra --fresh)"));
}

fn pins_of(app: &App, pins: Vec<(String, Scene)>) -> Vec<Pin> {
    let pin = |(letter, (_, scene)): (char, (String, Scene))| {
        Pin::new(letter, name_of(app, &scene), Arc::new(scene))
    };
    LETTERS.into_iter().zip(pins).map(pin).collect()
}

/// Formats the number of pins: `, 2 pinned runs`; empty for none.
fn counted_pins(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => ", 1 pinned run".to_owned(),
        count => format!(", {count} pinned runs"),
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

    use super::*;
    use crate::files::recent;
    use crate::tui::keymap::Tab;
    use crate::tui::message::{Effect, Message};
    use crate::tui::update;
    use crate::worker::studies::StudyRequest;
    use cmra_engine::model::scene::PlateSize;

    const FRESH: Options = Options { scene: None, with: None, fresh: true, glyphs: None };

    fn state() -> App {
        App::new(baseline(), Theme::detect(environment), PathBuf::new())
    }

    /// Presses keys; a line break is Enter.
    fn press(app: &mut App, keys: &str) {
        for key in keys.chars() {
            let code = match key {
                '\n' => KeyCode::Enter,
                '\t' => KeyCode::Tab,
                key => KeyCode::Char(key),
            };
            update::update(app, Message::Key(KeyEvent::new(code, KeyModifiers::NONE)));
        }
    }

    /// A figure opens as its sweep, however it is opened.
    #[test]
    fn a_figure_of_the_command_line_opens_on_explore() {
        for (name, tab) in [
            ("figure-9.4", Tab::Explore),
            ("figure-9.8", Tab::Explore),
            ("thesis-baseline", Tab::Run),
        ] {
            let scene = preset::resolve(name, None).unwrap();
            let (mut state, _) = app(Options { scene: Some(scene), ..FRESH }, None);
            assert_eq!(state.tab, tab, "{name}");
            assert!(state.history.edits.is_empty(), "nothing to undo yet");
            let effects = update::start(&mut state);
            let is_sweep = |effect: &Effect| matches!(effect, Effect::Submit(task) if matches!(task.request, StudyRequest::Picture(_)));
            assert_eq!(effects.iter().any(is_sweep), tab == Tab::Explore, "{name}");
        }
    }

    #[test]
    fn a_session_comes_back() {
        let mut app = state();
        Arc::make_mut(&mut app.scene).plate.size = PlateSize::Ratio(2.5);
        let scene = Arc::clone(&app.base.scene);
        app.pins.push(Pin::new('A', "thesis-baseline".to_owned(), scene));
        app.settings.theme.glyphs = app.settings.theme.glyphs.next();
        app.files.recent = vec![PathBuf::from("a.toml")];
        app.size = (80, 24);
        press(&mut app, "2\tkl4gj\n45\nj\nk\njj\n9e3\nk\n8e3\n");
        press(&mut app, "4glgjjjjjj\n1..5\njjl");
        let kept = session(&app);
        assert!(kept.setup.explore.as_ref().is_some_and(|it| it.is_map), "{kept:?}");
        // A constant variable keeps its range.
        let search = kept.setup.search.as_ref().expect("a setup");
        assert_eq!((&*search.seek, &*search.goal), ("k=8e6..9e6:65", "percent_of_baseline=45"));
        let bounds: Vec<&str> = search.bounds.iter().map(|it| &*it.0).collect();
        assert!(bounds.contains(&"gamma=1..5:2") && bounds.contains(&"k=0..7.5e6:2"), "{search:?}");
        let mut again = state();
        restore(&mut again, kept.clone(), None);
        assert_eq!(again.scene, app.scene);
        assert_eq!(again.settings.theme, app.settings.theme);
        assert_eq!(again.pages.search.setup, app.pages.search.setup);
        assert_eq!(again.pages.explore.picture, app.pages.explore.picture);
        assert!(again.effects.is_empty());
        again.files.recent.clone_from(&app.files.recent);
        assert_eq!(session(&again), kept);
        let text = again.notice.expect("it says so").text;
        assert!(text.contains("modified, 1 pinned run"), "{text}");
        // Command-line settings override those of the session.
        let mut fixed = state();
        restore(&mut fixed, kept, Some(GlyphSet::Ascii));
        assert_eq!(fixed.settings.theme.glyphs, state().settings.theme.glyphs);
    }

    #[test]
    fn files_are_kept_by_their_whole_paths() {
        let mut app = state();
        app.files.directory = PathBuf::from("/somewhere");
        let named = |app: &App| session(app).preset.unwrap();
        assert_eq!(named(&app), "thesis-baseline");
        for (name, kept) in [
            ("a.toml", "/somewhere/a.toml"),
            ("/b/a.toml", "/b/a.toml"),
            ("standard input", "standard input"),
        ] {
            app.base.name = name.to_owned();
            assert_eq!(named(&app), kept);
        }
        app.note_recent(Path::new("a.toml"));
        app.note_recent(Path::new("/somewhere/a.toml"));
        assert_eq!(app.files.recent, [PathBuf::from("/somewhere/a.toml")]);
    }

    #[test]
    fn without_a_home_it_does_not_claim_to_keep_the_session() {
        let (mut state, ..) = app(FRESH, None);
        let text = state.notice.clone().expect("it is said").text;
        assert!(text.contains("cannot be kept") && text.contains("HOME"), "{text}");
        let escape = KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE);
        update::update(&mut state, Message::Key(escape));
        let text = state.notice.expect("it is said").text;
        assert!(text.contains("the session is not kept"), "{text}");
    }

    #[test]
    fn another_start_keeps_a_session_that_would_be_lost() {
        let place = tempfile::tempdir().unwrap();
        let paths = Paths::below(place.path());
        let mut last = Session { preset: Some("thesis-baseline".to_owned()), ..Session::default() };
        last.scene = preset::baseline().unwrap().scene;
        last.recent.push(PathBuf::from("a.toml"));
        // The session equals a preset: nothing to store.
        session::save(&paths.session_file(), &last, &mut SessionFingerprint::default(), &|| true)
            .unwrap();
        let (state, _) = app(FRESH, Some(&paths));
        assert!(state.notice.is_none());
        assert_eq!(state.files.recent, last.recent);
        assert!(recent::list(&paths.recent_folder()).is_empty());
        // A pin would be lost.
        last.pins.push(("A".to_owned(), last.scene.clone()));
        session::save(&paths.session_file(), &last, &mut SessionFingerprint::default(), &|| true)
            .unwrap();
        let (state, _) = app(FRESH, Some(&paths));
        assert_eq!(state.pins.len(), 0);
        let text = state.pages.log.messages.last().unwrap().text.clone();
        assert!(text.contains("1 pinned run") && text.contains("as recent"), "{text}");
        let kept = recent::list(&paths.recent_folder());
        assert_eq!(preset::resolve(kept[0].to_str().unwrap(), None).unwrap().scene, last.scene);
    }

    /// Nine scenes are one session: one row of the list, which opens all of them. Of six sessions the last five are stored.
    #[test]
    fn a_session_is_kept_and_opened_whole() {
        let place = tempfile::tempdir().unwrap();
        let paths = Paths::below(place.path());
        let of = |ratio: f64| {
            let mut scene = preset::baseline().unwrap().scene;
            scene.plate.size = PlateSize::Ratio(ratio);
            scene
        };
        let session_of = |first: u32| {
            let pins = (1..=8).map(|pin| (pin.to_string(), of(f64::from(first + pin)))).collect();
            let preset = Some("thesis-baseline".to_owned());
            Session { scene: of(f64::from(first)), pins, preset, ..Session::default() }
        };
        for first in [100, 200, 300, 400, 500, 600] {
            session::save(
                &paths.session_file(),
                &session_of(first),
                &mut SessionFingerprint::default(),
                &|| true,
            )
            .unwrap();
            app(FRESH, Some(&paths));
        }
        let files = recent::list(&paths.recent_folder());
        let ratios = |session: &Session| {
            let pins = session.pins.iter().map(|(_, scene)| scene.mass_ratio());
            std::iter::once(session.scene.mass_ratio()).chain(pins).collect::<Vec<f64>>()
        };
        let mut kept: Vec<Session> = files.iter().filter_map(|path| session::kept(path)).collect();
        kept.sort_by(|a, b| a.scene.mass_ratio().total_cmp(&b.scene.mass_ratio()));
        let all = [200, 300, 400, 500, 600].map(|first| ratios(&session_of(first)));
        assert_eq!(kept.iter().map(ratios).collect::<Vec<_>>(), all);
        // Opens completely, as one edit.
        let (mut state, _) = app(FRESH, Some(&paths));
        let entry = entry_of_session(session_of(300), Some(&paths));
        assert_eq!((&*entry.name, entry.origin), ("thesis-baseline, 8 pinned runs", "recent"));
        state.size = (80, 24);
        state.files.presets = vec![entry];
        let before = state.snapshot();
        press(&mut state, "pthesis\n");
        let pins: Vec<f64> = state.pins.iter().map(|pin| pin.scene.mass_ratio()).collect();
        assert_eq!(
            (state.scene.mass_ratio(), pins),
            (300.0, ratios(&session_of(300))[1..].to_vec())
        );
        assert_eq!(state.base.name, "thesis-baseline");
        press(&mut state, "u");
        assert_eq!(state.snapshot(), before);
    }

    #[test]
    fn a_preset_that_is_gone_does_not_lose_the_scene() {
        let mut last = Session::default();
        last.scene.plate.size = PlateSize::Ratio(3.0);
        let base = base_named(Some("gone"), &last.scene, None);
        assert_eq!((base.name.as_str(), base.is_mine), ("gone", false));
        assert_eq!(*base.scene, last.scene);
    }
}
