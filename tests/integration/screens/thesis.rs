//! The Thesis tab: claims come in as they are checked, are opened; principles and concepts are tables.

use super::bench::{Bench, ended, stopped};
use super::jobs::writes_a_part;
use cmra::tui::keymap::Tab;
use cmra::tui::preset::PresetEntry;
use cmra::worker::studies::{Claims, RequestVariant, StudyResult};
use cmra_studies::study::context::CancelFlag;
use cmra_studies::study::principles::PRINCIPLES;
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::thesis::{self, Claim, Row, claims};
use insta::assert_snapshot;

fn check(claim: &'static Claim) -> Row {
    thesis::check(claim, &CancelFlag::default())
}

/// The tab with the first claims answered.
fn bench(columns: u16, rows: u16) -> Bench {
    let mut bench = Bench::ascii(columns, rows);
    bench.keys("6");
    let id = asked(&mut bench).expect("the claims are asked for");
    let rows: Vec<Row> = claims().take(24).map(check).collect();
    bench.reply(id, ended(rows));
    bench
}

/// The number of the study of the claims that was requested.
fn asked(bench: &mut Bench) -> Option<u64> {
    let studies = bench.studies();
    Some(studies.iter().rev().find(|it| Claims::downcast(&it.request).is_some())?.id)
}

#[test]
fn the_pages() {
    let mut bench = bench(80, 24);
    bench.keys("jjj");
    assert_snapshot!("thesis_claims", bench.screen());
    bench.keys("<Tab>");
    assert_snapshot!("thesis_principles", bench.screen());
    bench.keys("<Tab>");
    assert_snapshot!("thesis_concepts", bench.screen());
    bench.keys("<Tab>");
    let screen = bench.screen();
    for text in ["computed over measured limits", "steel core on light alloy, oblique", "597   20"]
    {
        assert!(screen.contains(text), "{text}: {screen}");
    }
}

/// No list of claims begins with the second line of one.
#[test]
fn the_list_of_claims_begins_with_the_place_of_a_claim() {
    for size in [(60, 16), (80, 24), (120, 36)] {
        let mut bench = bench(size.0, size.1);
        bench.keys("g");
        for _ in 0..23 {
            let screen = bench.screen();
            let mut lines =
                screen.lines().skip_while(|line| !line.contains("Claims of the thesis"));
            let first = lines.nth(1).unwrap_or_default();
            assert!(first.starts_with(['|']) && !first.starts_with("| "), "{screen}");
            bench.keys("j");
        }
    }
}

#[test]
fn rows_come_in_parts_and_a_stopped_report_says_so() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("6");
    assert!(bench.screen().contains("checking the first claims"));
    let id = asked(&mut bench).unwrap();
    let some: Vec<Row> = claims().take(2).map(check).collect();
    let part = StudyResult::from(some.clone());
    bench.part(id, (2, 114), part);
    assert!(bench.screen().contains("checking the claims: 2 of 114 (Esc cancels)"));
    bench.keys("<Esc>");
    assert!(bench.has_cancelled());
    bench.reply(id, stopped((2, 114), some));
    assert!(bench.screen().contains("cancelled: press r (2 of 114 claims)"));
    bench.keys("e<Enter>");
    assert!(writes_a_part(&bench));
}

#[test]
fn the_first_claim_selected_can_be_opened_and_one_without_a_preset_opens_nothing() {
    let mut bench = bench(80, 24);
    assert!(bench.screen().contains("Enter open"), "{}", bench.screen());
    assert!(bench.message().contains("Enter opens "), "{}", bench.message());
    bench.keys("g");
    assert!(!bench.screen().contains("Enter open"), "{}", bench.screen());
    bench.keys("<Enter>");
    assert!(bench.message().contains("no preset shows this"), "{}", bench.message());
    assert_eq!(bench.app.tab, Tab::Thesis);
}

#[test]
fn enter_on_a_claim_of_a_figure_opens_its_sweep() {
    for (preset, tab, names) in [
        ("figure-9.2", Tab::Explore, &["gamma"][..]),
        ("figure-9.8", Tab::Explore, &["gamma", "n"][..]),
    ] {
        let mut bench = Bench::ascii(80, 24);
        let found = cmra::files::preset::resolve(preset, None).expect("a bundled preset");
        let (name, scene) = (preset.to_owned(), found.scene);
        bench.app.files.presets.push(PresetEntry { name, scene, ..PresetEntry::default() });
        bench.keys("6");
        let id = asked(&mut bench).expect("the claims are asked for");
        let rows = claims().find(|claim| claim.preset == Some(preset));
        let rows: Vec<Row> = rows.into_iter().map(check).collect();
        bench.reply(id, ended(rows));
        bench.press("<Enter>");
        assert_eq!((bench.app.tab, bench.app.base.name.as_str()), (tab, preset));
        let (_, _, plan) = bench.sweeps().pop().expect("a sweep");
        let along: Vec<&str> = plan.axes().iter().map(Axis::symbol).collect();
        assert_eq!(along, names);
        bench.press("u6");
        assert_eq!(bench.app.base.name, "thesis-baseline");
    }
}

#[test]
fn enter_on_a_principle_loads_its_preset() {
    let mut bench = Bench::ascii(80, 24);
    let preset = PRINCIPLES[3].preset;
    let found = cmra::files::preset::resolve(preset, None).expect("a bundled preset");
    let (name, scene) = (preset.to_owned(), found.scene);
    bench.app.files.presets.push(PresetEntry { name, scene, ..PresetEntry::default() });
    bench.keys("6<Tab>jjj");
    let screen = bench.screen();
    for text in [PRINCIPLES[3].idea, "section 4.4.1: Enter opens constant-force"] {
        assert!(screen.contains(text), "{text}: {screen}");
    }
    bench.press("<Enter>");
    assert_eq!((bench.app.tab, bench.app.base.name.as_str()), (Tab::Run, preset));
}

#[test]
fn each_page_is_exported() {
    let mut bench = bench(80, 24);
    for (file, head, rows) in [
        ("claims.csv", "id,where,says,computed,as_printed,verdict,holds,cause,preset", 24),
        ("principles.csv", "family,principle,section,idea,functions,preset", 7),
        ("concepts.csv", "concept,functions,total,total_printed,rank_printed,preset", 8),
    ] {
        bench.keys("e<Enter>");
        let (to, text, has_scene) = bench.exported().expect("an export");
        assert!(to.path.ends_with(file) && !has_scene, "{}", to.path.display());
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some(head));
        assert_eq!(lines.count(), rows, "{text}");
        bench.keys("<Esc><Tab>");
    }
}

#[test]
fn on_a_small_screen_every_principle_and_concept_is_in_sight() {
    let mut bench = bench(60, 16);
    bench.keys("<Tab>");
    let screen = bench.screen();
    for text in ["Rotational or lateral kinetic energy transfer", "L lateral"] {
        assert!(screen.contains(text), "{text}: {screen}");
    }
    bench.keys("<Tab>");
    let screen = bench.screen();
    for text in ["EmF", "HeR", "rank", "2.07"] {
        assert!(screen.contains(text), "{text}: {screen}");
    }
}
