//! Lists and what is typed into them: the palette, presets, options, filters, help.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::bench::Bench;
use super::{limit, stability};
use cmra::tui::keymap::Keymap;
use cmra::tui::keymap::Tab;
use cmra::tui::message::Effect;
use cmra::tui::preset::PresetEntry;
use cmra::tui::theme::GlyphSet;

/// A name that nothing has matches nothing; a name that something has opens it, and nothing else is loaded.
#[test]
fn the_palette_never_loads_a_scene_by_scattered_letters() {
    let mut bench = Bench::ascii(80, 24);
    let before = Arc::clone(&bench.app.scene);
    bench.press(":pareto<Enter>");
    assert_eq!(bench.app.tab, Tab::Search);
    assert!(bench.screen().contains("[Pareto front]"), "{}", bench.screen());
    assert_eq!(bench.app.scene, before);
}

#[test]
fn a_broken_preset_is_listed_with_its_error_and_cannot_be_loaded() {
    let mut bench = Bench::ascii(80, 24);
    let problem = "mine.toml, line 3: unknown key `gama`".to_owned();
    bench.app.files.presets.push(PresetEntry::broken("mine-too".to_owned(), problem));
    let before = Arc::clone(&bench.app.scene);
    bench.press("pmine-too");
    let screen = bench.screen();
    assert!(screen.contains("!mine-too") && screen.contains("unknown key"), "{screen}");
    bench.press("<Enter>");
    assert_eq!(bench.app.scene, before);
    assert!(bench.message().contains("cannot be loaded"), "{}", bench.message());
    // A long error stands whole above the dialog.
    let mut bench = Bench::ascii(80, 24);
    let why = ["expected a length;"; 10].join(" ") + " write\nfor example 0.0295";
    bench.app.files.presets.push(PresetEntry::broken("mine-too".to_owned(), why.clone()));
    bench.press("pmine-too<Enter>");
    let screen = bench.screen();
    let lines: Vec<&str> = screen.lines().skip(18).map(str::trim).collect();
    let refusal = format!("mine-too cannot be loaded: {why}").replace('\n', "; ");
    assert!(lines.join(" ").contains(&refusal), "{screen}");
    // A text that no preset has loads none.
    let mut bench = Bench::ascii(80, 24);
    bench.press("pzqx<Enter>");
    assert!(bench.app.history.edits.is_empty());
}

#[test]
fn the_exact_symbol_comes_first() {
    for (typed, symbol) in [("k", "k"), ("d", "d"), ("h", "h"), ("gam", "gamma"), ("cock", "d")] {
        let mut bench = Bench::ascii(80, 24);
        bench.keys(&format!("/{typed}"));
        assert_eq!(bench.app.pages.run.editor.variable().symbol, symbol, "{typed}");
        bench.keys("<Enter><Enter>");
        assert!(bench.app.field().is_some(), "{typed}");
    }
}

/// A preset that only sweeps says where it shows, and loading it opens Explore.
#[test]
fn a_preset_of_a_figure_opens_its_sweep() {
    let mut bench = Bench::ascii(80, 24);
    let scene = cmra::files::preset::resolve("figure-9.8", None).unwrap().scene;
    let name = "figure-9.8".to_owned();
    bench.app.files.presets.push(PresetEntry { name, scene, ..PresetEntry::default() });
    bench.press("pfigure 9.8");
    assert!(bench.screen().contains("shows on 2:Explore"), "{}", bench.screen());
    bench.press("<Enter>");
    assert_eq!(bench.app.tab, Tab::Explore);
    assert_eq!(bench.sweeps().len(), 1);
}

#[test]
fn characters_colours_and_mouse_are_changed_by_a_key() {
    let mut bench = Bench::ascii(80, 24);
    for (key, said) in [("m", "characters: block"), ("t", "colours: 256"), ("M", "mouse on")] {
        bench.press(key);
        assert!(bench.message().starts_with(said), "{key}: {}", bench.message());
    }
    assert!(bench.app.settings.mouse);
    assert!(bench.effects.iter().any(|effect| matches!(effect, Effect::Mouse(true))));
}

/// A name that no quantity has is answered with titles as they stand on the screen, never with keys of files.
#[test]
fn quantities_are_named_as_the_screen_names_them() {
    let mut bench = Bench::ascii(120, 36);
    bench.press("2<Tab>g<Enter>depth of snow<Enter>");
    assert!(bench.message().contains("no quantity is called"), "{}", bench.message());
    assert!(!bench.message().contains('_'), "{}", bench.message());
    let mut bench = Bench::ascii(120, 36);
    bench.press("4k<Enter>");
    let typed = bench.app.field().expect("a field").value().to_owned();
    assert_eq!(typed, "% of rigid-mount depth");
    bench.press("penetration<Enter>");
    assert!(bench.message().contains("final depth"), "{}", bench.message());
    assert!(!bench.message().contains('_'), "{}", bench.message());
}

#[test]
fn a_new_filter_begins_empty_and_what_it_hides_is_not_edited() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/gamma<Enter><Enter>2<Enter>/k<Enter><Enter>200<Enter>");
    let scene = Arc::clone(&bench.app.scene);
    assert_eq!(scene.mass_ratio().to_bits(), 2.0_f64.to_bits());
    assert_eq!(scene.mechanism.spring.coefficient.to_bits(), 2e5_f64.to_bits());
    for key in ["<Enter>", "l", "L", ",", "<BS>", "D"] {
        let mut bench = Bench::ascii(80, 24);
        bench.keys(&format!("/zz<Enter>{key}"));
        assert!(bench.screen().contains("no variable matches"), "{}", bench.screen());
        assert!(bench.app.history.edits.is_empty() && bench.app.field().is_none(), "{key}");
    }
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/zz<Enter>l");
    assert!(bench.message().contains("Esc shows all"), "{}", bench.message());
    bench.keys("<Esc>l");
    assert_eq!(bench.app.history.edits.len(), 1);
}

#[test]
fn words_on_the_screen_find_their_rows() {
    let first = |filter: &str| {
        let mut bench = Bench::ascii(80, 24);
        bench.keys(&format!("/{filter}<Enter>"));
        bench.app.pages.run.editor.variable().symbol
    };
    for (typed, symbol) in [
        ("stiffness", "k"),
        ("k", "k"),
        ("velocity", "v_i"),
        ("mass ratio", "gamma"),
        ("face", "face"),
        ("plate mass", "m_2"),
    ] {
        assert_eq!(first(typed), symbol, "{typed}");
    }
    let bench = Bench::ascii(80, 24);
    for (typed, what, name) in [
        ("stiffness", "change it; now 100 kN/m^n", "k  stiffness"),
        ("velocity", "change it; now 100 m/s", "v_i  impact velocity"),
        ("quit", "the session is kept", "Quit"),
    ] {
        let found = bench.app.palette(typed);
        let first = found.first().unwrap_or_else(|| panic!("{typed} finds nothing"));
        let described = (first.what(&bench.app), first.name());
        assert_eq!(described, (what.to_owned(), name.to_owned()), "{typed}");
    }
    assert!(bench.app.palette("quit").iter().all(|item| !item.name().starts_with("theta")));
}

/// `config.toml` gives actions other keys: the texts name those.
#[test]
fn texts_name_the_keys_in_force() {
    let mut bench = Bench::ascii(80, 24);
    let keys = [("run", "F5"), ("undo", "U"), ("view", "F2")];
    let keys = keys.map(|(action, key)| (action.to_owned(), vec![key.to_owned()]));
    bench.app.keymap = Keymap::remapped(&BTreeMap::from(keys)).unwrap();
    bench.press("3<F2>");
    bench.press("<Esc>");
    limit::stop(&mut bench);
    let screen = bench.screen();
    assert!(screen.contains("cancelled: press F5 (12"), "{screen}");
    assert!(bench.screen().contains(" F2 map "), "{}", bench.screen());
    bench.keys("1jjl ");
    bench.keys("r");
    assert!(bench.message().contains("`r` does nothing here"), "{}", bench.message());
    bench.keys("2<Tab>g<Enter>zzz<Enter>");
    assert!(bench.message().contains("l steps through all of them"), "{}", bench.message());
}

/// No text and no footer has a key of the table where `config.toml` gives the action another one or none.
#[test]
fn no_text_has_a_key_that_is_not_in_force() {
    let mut bench = Bench::ascii(160, 50);
    let mut keys = BTreeMap::new();
    for (action, key) in [
        ("down", vec!["F1"]),
        ("up", vec!["F2"]),
        ("far-left", vec!["F3"]),
        ("far-right", vec!["F4"]),
        ("tab-limit", vec!["F7"]),
        ("window", vec![]),
        ("mark", vec![]),
    ] {
        keys.insert(action.to_owned(), key.into_iter().map(str::to_owned).collect());
    }
    bench.app.keymap = Keymap::remapped(&keys).unwrap();
    bench.keys("<Tab>");
    let screen = bench.screen();
    assert!(screen.contains(" F7:Limit "), "{screen}");
    let footer = screen.lines().last().unwrap();
    assert!(footer.contains(" F1/F2 chart ") && !footer.contains("   "), "{footer}");
    assert!(!footer.contains("whole") && !footer.contains("pin"), "{footer}");
    bench.keys("?");
    assert!(bench.screen().contains("(F3 F4 ten columns)"), "{}", bench.screen());
}

/// From the first screen on, by one key.
#[test]
fn help_explains_the_words_of_the_first_screen() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("?");
    let screen = bench.screen();
    for word in ["plastic: ", "travel: ", "mount: ", "a, b: ", "!: ", "error: ", "omitted: "] {
        assert!(screen.contains(word), "{word}\n{screen}");
    }
    // A small screen keeps its rows for the keys.
    let mut bench = Bench::ascii(60, 16);
    bench.keys("?");
    assert!(bench.screen().contains("change the value by a step"), "{}", bench.screen());
}

#[test]
fn help_explains_the_words_of_the_comparison_and_of_the_stiff_scenes() {
    let mut bench = limit::open(GlyphSet::Ascii, (80, 24));
    bench.keys("<Tab>?");
    assert!(bench.screen().contains("the plate is perforated above it"), "{}", bench.screen());
    let mut bench = stability::open(GlyphSet::Ascii, (80, 24));
    bench.keys("<Tab>?");
    assert!(bench.screen().contains("s: stored"), "{}", bench.screen());
}

/// Things are found by their names and by what else people call them; what is in no name matches nothing.
#[test]
fn the_palette_finds_by_name_and_synonym() {
    for (typed, name) in [
        ("pareto", "Pareto front"),
        ("optimise", "Pareto front"),
        ("v50", "Residual velocity"),
        ("cocking", "d  cocking distance"),
        ("k", "k  stiffness"),
        ("gamma", "gamma  mass ratio"),
        ("limit", "Limit tab"),
        ("efficiency", "Map of mass efficiency"),
        ("worth", "Comparison at equal areal mass"),
        ("rigid", "rigid-mount"),
        ("stable step", "Stability"),
    ] {
        let bench = Bench::ascii(80, 24);
        let found = bench.app.palette(typed);
        let first = found.first().unwrap_or_else(|| panic!("{typed} finds nothing"));
        assert_eq!(first.name(), name, "{typed}");
    }
    let mut bench = Bench::ascii(80, 24);
    bench.press(":xqzt<Enter>");
    assert!(bench.message().contains("nothing is called `xqzt`"), "{}", bench.message());
    assert!(bench.app.history.edits.is_empty());
}

#[test]
fn a_search_without_a_match_explains_how_to_open_a_file() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("p");
    bench.press("zzz");
    bench.press("<Enter>");
    assert!(bench.message().contains("./zzz.toml"), "{}", bench.message());
    assert!(bench.app.has_dialog());
}

/// A reader types the number of a figure: it finds what the program has for it, or says that there is nothing to compute.
#[test]
fn figures_of_the_thesis_are_found_by_their_numbers() {
    let all = cmra::files::preset::list(None).0.into_iter().map(|preset| PresetEntry {
        name: preset.name,
        origin: "bundled",
        comment: preset.comment,
        scene: preset.scene,
        ..PresetEntry::default()
    });
    let all: Vec<PresetEntry> = all.collect();
    for (typed, name) in [
        ("9.14", "concept-cocked-cantilever"),
        ("8.18", "yang-xi"),
        ("8.6", "figure-8.6"),
        ("8.7", "figure-8.6"),
        ("8.10", "figure-8.10"),
        ("figure 8.11", "figure-8.11"),
        ("9.8", "figure-9.8"),
    ] {
        let mut bench = Bench::ascii(80, 24);
        bench.app.files.presets.clone_from(&all);
        bench.press("p");
        bench.press(typed);
        bench.press("<Enter>");
        assert_eq!(bench.app.base.name, name, "{typed}: {}", bench.screen());
    }
    let mut bench = Bench::ascii(80, 24);
    bench.app.files.presets = all;
    bench.press("p");
    bench.press("8.16");
    assert!(bench.screen().contains("figure 8.16 has no data to compute"), "{}", bench.screen());
    bench.press("<Enter>");
    assert!(bench.message().contains("a drawing or a photograph"), "{}", bench.message());
}

/// The row of an action has its key, and what it does in whole words; the list fits 60 columns.
#[test]
fn the_palette_shows_keys_and_what_they_do() {
    for size in [(80, 24), (60, 16)] {
        let mut bench = Bench::ascii(size.0, size.1);
        bench.press(":export");
        let screen = bench.screen();
        let row = screen.lines().find(|line| line.contains(" Export ")).unwrap();
        assert!(row.contains(" e       CSV"), "{screen}");
        bench.press("<C-u>what matters");
        let screen = bench.screen();
        let row = screen.lines().find(|line| line.contains("What matters")).unwrap();
        assert!(row.contains(" v       bars"), "{screen}");
    }
}
