//! The Thesis tab: claims come in as they are checked, are filtered and opened; weights change the ranking.

use super::bench::{Bench, ended};
use super::kept::writes_a_part;
use cmra::study::sweep::Axis;
use cmra::study::thesis::{ClaimVerdict, Opens, Row, check, claims};
use cmra::tui::message::PresetEntry;
use cmra::tui::pages::Tab;
use cmra::tui::pages::thesis::Claims;
use cmra::worker::Finding;
use cmra::worker::study::RowsSoFar;
use insta::assert_snapshot;

/// The tab with the quick claims of the first chapters answered.
fn bench(columns: u16, rows: u16) -> Bench {
    let mut bench = Bench::ascii(columns, rows);
    bench.keys("6");
    let id = asked(&mut bench).expect("the claims are asked for");
    let rows: Vec<Row> = claims().iter().take(24).map(check).collect();
    bench.reply(id, ended(Finding::new(RowsSoFar { rows, is_complete: true })));
    bench
}

#[test]
fn the_count_of_every_verdict_fits() {
    let letters = "25 =, 29 ~, 22 M, 83 +, 23 -, 17 ?";
    assert!(all_counted(60, 16).contains(letters), "{}", all_counted(60, 16));
    let words = "=25 reproduced, ~29 corrected, M22 misprint, +83 hold, -23 fail, ?17 unchecked";
    assert!(all_counted(80, 24).contains(words), "{}", all_counted(80, 24));
}

/// The screen with all claims checked.
fn all_counted(columns: u16, rows: u16) -> String {
    let mut bench = Bench::ascii(columns, rows);
    bench.keys("6");
    let id = asked(&mut bench).expect("the claims are asked for");
    let one = check(&claims()[0]);
    // The counts that the report of all claims ends with.
    let counts = [25, 29, 22, 83, 23, 17];
    let rows = ClaimVerdict::ALL.into_iter().zip(counts).flat_map(|(verdict, count)| {
        let mut row = one.clone();
        row.found.verdict = verdict;
        std::iter::repeat_n(row, count)
    });
    let rows: Vec<Row> = rows.collect();
    bench.reply(id, ended(Finding::new(RowsSoFar { rows, is_complete: true })));
    bench.screen()
}

/// The number of the study of the claims that was requested.
fn asked(bench: &mut Bench) -> Option<u64> {
    let studies = bench.studies();
    Some(studies.iter().rev().find(|it| it.asked.of::<Claims>().is_some())?.id)
}

#[test]
fn the_pages_at_two_sizes() {
    for (columns, rows) in [(80, 24), (120, 40)] {
        let mut bench = bench(columns, rows);
        bench.keys("jjj");
        assert_snapshot!(format!("thesis_claims_{columns}x{rows}"), bench.screen());
        bench.keys("<Tab>jj");
        assert_snapshot!(format!("thesis_principles_{columns}x{rows}"), bench.screen());
        bench.keys("<Tab>G");
        for _ in 0..35 {
            bench.keys("h");
        }
        assert_snapshot!(format!("thesis_screening_{columns}x{rows}"), bench.screen());
    }
}

#[test]
fn rows_come_in_parts_and_a_stopped_report_says_so() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("6");
    assert!(bench.screen().contains("checking the first claims"));
    let id = asked(&mut bench).unwrap();
    let some: Vec<Row> = claims().iter().take(2).map(check).collect();
    let part = Finding::new(RowsSoFar { rows: some.clone(), is_complete: false });
    bench.part(id, (2, 114), part);
    assert!(bench.screen().contains("checking the claims: 2 of 114 (Esc cancels)"));
    bench.keys("<Esc>");
    assert!(bench.has_cancelled());
    bench.reply(id, ended(Finding::new(RowsSoFar { rows: some, is_complete: false })));
    assert!(bench.screen().contains("cancelled: press r"));
    bench.keys("e<Enter>");
    assert!(writes_a_part(&bench));
}

#[test]
fn enter_opens_the_scene_of_a_claim_and_undo_returns() {
    let mut bench = bench(80, 24);
    // 2.3.1, the inelastic collision: a free plate.
    bench.keys("jjjj<Enter>");
    assert_eq!(bench.app.tab, Tab::Run);
    assert!(bench.app.scene.mechanism.spring.coefficient.abs() < f64::EPSILON);
    assert_eq!(bench.app.base.name, "claim 2.3.1-inelastic");
    bench.keys("u6");
    assert!((bench.app.scene.mechanism.spring.coefficient - 1e5).abs() < 1e-9);
    bench.keys("gj<Enter>");
    assert!(bench.message().contains("no scene shows this"), "{}", bench.message());
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
        let (name, comment) = (preset.to_owned(), String::new());
        let scene = found.scene;
        bench.app.presets.push(PresetEntry {
            name,
            origin: "bundled",
            scene,
            comment,
            part: None,
            problem: None,
        });
        bench.keys("6");
        let id = asked(&mut bench).expect("the claims are asked for");
        let rows =
            claims().iter().find(|it| matches!(it.opens(), Opens::Preset(name) if name == preset));
        let rows: Vec<Row> = rows.into_iter().map(check).collect();
        bench.reply(id, ended(Finding::new(RowsSoFar { rows, is_complete: true })));
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
fn each_page_is_exported() {
    let mut bench = bench(80, 24);
    for (file, head, rows) in [
        ("claims.csv", "id,where,says,sound,as_printed,verdict,cause,preset,runs,basis", 24),
        ("principles.csv", "family,principle,section,idea,functions,computed,preset", 0),
        ("screening.csv", "rank,concept,total,rank_printed,total_printed,section,preset", 8),
    ] {
        bench.keys("e<Enter>");
        let (to, text, has_scene) = bench.exported().expect("an export");
        assert!(to.path.ends_with(file) && !has_scene, "{}", to.path.display());
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some(head));
        assert!(rows == 0 || lines.count() == rows, "{text}");
        bench.keys("<Esc><Tab>");
    }
}

#[test]
fn the_filter_goes_through_all_verdicts() {
    let mut bench = bench(80, 24);
    let all = bench.app.claims().len();
    let mut seen = 0;
    for verdict in ClaimVerdict::ALL {
        bench.keys("v");
        assert_eq!(bench.app.pages.thesis.filter, Some(verdict));
        let shown = bench.app.claims();
        assert!(shown.iter().all(|row| row.found.verdict == verdict));
        seen += shown.len();
    }
    assert_eq!(seen, all);
    bench.keys("v");
    assert_eq!(bench.app.pages.thesis.filter, None);
}

#[test]
fn weights_change_the_ranking_and_come_back() {
    let mut bench = bench(80, 24);
    bench.keys("<Tab><Tab>G");
    for _ in 0..40 {
        bench.keys("h");
    }
    assert!(bench.app.pages.thesis.weights[6].abs() < 1e-12);
    let screen = bench.screen();
    assert!(screen.contains("4 (2)"), "{screen}");
    bench.keys("d");
    assert!((bench.app.pages.thesis.weights[6] - 35.0).abs() < 1e-12);
}

#[test]
fn on_a_small_screen_the_selected_principle_and_every_concept_are_in_sight() {
    for size in [(60, 16), (80, 24)] {
        let mut bench = bench(size.0, size.1);
        bench.keys("<Tab>G");
        let screen = bench.screen();
        // In the list and above the detail.
        let name = "Rotational or lateral kinetic energy transfer";
        assert_eq!(screen.matches(name).count(), 2, "{screen}");
        bench.keys("<Tab>");
        let screen = bench.screen();
        for text in ["EmF", "HeR", "rank (printed)", "2.07"] {
            assert!(screen.contains(text), "{text}: {screen}");
        }
        assert_snapshot!(format!("thesis_screening_small_{}x{}", size.0, size.1), screen);
    }
}
