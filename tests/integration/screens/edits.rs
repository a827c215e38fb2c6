//! Edits of the scene and of setups: what they change, and how they are undone.

use cmra::tui::pages::explore::cursor::{chart_kind, sweep_is_old};
use cmra::tui::pages::explore::plan::sweep_plan;
use std::sync::Arc;

use super::bench::Bench;
use super::search::in_search;
use super::sweep::keys;
use super::{accuracy, limit, search};
use cmra::tui::pages::explore;
use cmra::tui::pages::explore::state::ChartKind;
use cmra::tui::theme::GlyphSet;
use cmra_engine::model::scene::PlateSize;
use cmra_studies::study::accuracy::method::Method;
use cmra_studies::study::quantities::named;

#[test]
fn a_changed_goal_is_searched_for_before_enter_loads_anything() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("4");
    search::answer(&mut bench);
    let before = Arc::clone(&bench.app.scene);
    bench.press("<Enter>50 %<Enter><Tab><Enter>");
    assert_eq!(bench.app.scene, before, "the results of 60 % are stale");
    assert!(bench.message().contains("press r"), "{}", bench.message());
    search::answer(&mut bench);
    bench.press("<Enter>");
    assert_ne!(bench.app.scene, before);
}

#[test]
fn redo_takes_away_the_run_that_was_unpinned_whatever_letter_it_has_now() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys(" ");
    let first = Arc::clone(&bench.app.pins[0].scene);
    bench.keys("<Tab><Tab>j <S-Tab><S-Tab>jjl ");
    let second = Arc::clone(&bench.app.pins[0].scene);
    assert_ne!(first, second);
    bench.keys("uu");
    bench.keys("<C-r><C-r>");
    assert_eq!(bench.app.pins.len(), 1);
    assert_eq!(bench.app.pins[0].scene, second, "the other run stays");
}

#[test]
fn a_design_that_is_the_scene_already_is_not_loaded_again() {
    let mut bench = Bench::ascii(120, 40);
    keys(&mut bench, "2l<Enter>");
    let edits = bench.app.history.edits.len();
    keys(&mut bench, "<Enter>");
    assert!(bench.message().contains("is this design already"), "{}", bench.message());
    assert_eq!(bench.app.history.edits.len(), edits);
}

#[test]
fn enter_after_a_value_stays_on_its_row_in_every_form() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/gamma<Enter><Enter>2<Enter>");
    assert_eq!(bench.app.pages.run.editor.variable().symbol, "gamma");
    bench.keys("<Esc><Enter>3<Down>");
    assert_ne!(bench.app.pages.run.editor.variable().symbol, "gamma");
    keys(&mut bench, "2<Tab>gjjj<Enter>1<Enter>");
    assert!(bench.screen().contains("> from"), "{}", bench.screen());
}

#[test]
fn the_plates_face_is_set_in_the_run_tab() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/face<Enter>");
    assert!(bench.screen().contains("> face   plate side     none"), "{}", bench.screen());
    bench.keys("<Enter>150mm<Enter>");
    assert_eq!(bench.app.scene.plate.size, PlateSize::Face(0.15));
    // rho h face^2 / m_p
    let exact = 2710.0 * 0.0254 * 0.15 * 0.15 / 0.0295;
    assert!((bench.app.scene.mass_ratio() - exact).abs() < 1e-12 * exact);
    // The axis of Explore is the face, from half to twice its value: gamma follows from it.
    let plan = sweep_plan(&bench.app).expect("a plan");
    assert_eq!((plan.axes()[0].symbol(), plan.axes()[0].ends()), ("face", (0.075, 0.3)));
    bench.keys("/gamma<Enter><Enter>2<Enter>");
    assert_eq!(bench.app.scene.plate.size, PlateSize::Ratio(2.0));
    // A step begins at the size there is: (2 m_p / (rho h))^(1/2) = 29.277 mm.
    bench.keys("/face<Enter>l");
    assert_eq!(bench.app.scene.plate.size, PlateSize::Face(0.0293));
}

#[test]
fn two_sizes_of_the_plate_are_never_two_axes() {
    let mut bench = Bench::ascii(80, 24);
    keys(&mut bench, "2<Tab>gjj<Enter>face<Enter>");
    keys(&mut bench, "gjl");
    assert_eq!(chart_kind(&bench.app), ChartKind::Surface);
    let axes = |bench: &Bench| {
        let plan = sweep_plan(&bench.app).unwrap();
        plan.axes().iter().map(|axis| axis.symbol().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(axes(&bench), ["face", "k"]);
    // Nor by hand.
    bench.app.pages.explore.row = explore::state::SetupRow::Axis(1, explore::state::Part::Name);
    keys(&mut bench, "<Enter>gamma<Enter>");
    assert!(bench.screen().contains("both set the plate's size"), "{}", bench.screen());
    keys(&mut bench, "<Esc>");
    // The axis replaces the scene's own size, and a design keeps it.
    keys(&mut bench, "<Tab>l<Enter>");
    assert!(matches!(bench.app.scene.plate.size, PlateSize::Face(_)), "{}", bench.message());
    assert!(!sweep_is_old(&bench.app));
}

#[test]
fn only_the_method_that_runs_a_scene_is_used_for_it() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("5");
    accuracy::answer(&mut bench, Method::ALL.len());
    assert_eq!(bench.app.pages.numerics.accuracy.method(), Method::Auto);
    bench.keys("<Enter>");
    assert_eq!(bench.app.history.edits.len(), 1, "{}", bench.message());
    assert!(!bench.screen().contains("another scene"), "{}", bench.screen());
    let kernel = Method::ALL.iter().position(|one| *one == Method::ContactKernel);
    bench.app.pages.numerics.accuracy.selected = kernel;
    let before = Arc::clone(&bench.app.scene);
    bench.keys("<Enter>");
    assert!(bench.message().contains("auto, which chooses"), "{}", bench.message());
    assert_eq!(bench.app.scene, before);
}

#[test]
fn a_goal_begins_at_the_value_of_the_scene() {
    let mut bench = Bench::ascii(80, 24);
    keys(&mut bench, "4k<Enter>stroke<Enter>");
    let run = &bench.app.shown.as_ref().expect("a run").run;
    let stroke = named("stroke_m").unwrap().value(run).unwrap();
    let (name, goal) = bench.app.pages.search.setup.goal;
    assert_eq!(name, "stroke_m");
    assert!((goal / stroke - 1.0).abs() < 0.05, "{goal} {stroke}");
}

/// The curve of the limit holds at any impact velocity, the comparison does not.
#[test]
fn a_shot_that_is_loaded_leaves_the_curve_as_it_is() {
    let mut bench = limit::open_residual(GlyphSet::Ascii, (120, 40));
    Arc::make_mut(&mut bench.app.scene).projectile.velocity_m_s = 232.9;
    assert!(!bench.screen().contains("scene's results"), "{}", bench.screen());
    // 232.3 m/s over 232.9 m/s.
    let told = "232.9 m/s perforates by the law, not measured: v_bl 232.300 m/s, margin -0.3 %";
    assert!(bench.screen().contains(told), "{}", bench.screen());
    bench.keys("v");
    assert!(!bench.screen().contains("mass efficiency 0."), "of another shot");
}

#[test]
fn the_search_setup_is_undone_and_redone_like_any_edit() {
    let mut bench = in_search((80, 24));
    let scene = bench.app.scene.clone();
    bench.keys("<Enter>50 %<Enter>");
    assert_eq!(bench.app.pages.search.setup.goal.1.to_bits(), 50.0_f64.to_bits());
    bench.keys("kl");
    let next = bench.app.pages.search.setup.goal.0;
    assert_ne!(next, "percent_of_baseline");
    assert_eq!(bench.app.history.edits.len(), 2);
    assert_eq!(bench.app.history.edits[0].label, "search: is 60 % -> 50 %");
    bench.keys("u");
    assert_eq!(bench.app.pages.search.setup.goal.0, "percent_of_baseline");
    assert!(bench.message().starts_with("undone: search: % of rigid-mount depth ->"));
    bench.keys("u");
    assert_eq!(bench.app.pages.search.setup.goal.1.to_bits(), 60.0_f64.to_bits());
    bench.keys("<C-r><C-r>");
    assert_eq!(bench.app.pages.search.setup.goal.0, next);
    assert_eq!(bench.app.scene, scene);
}

/// A bare number is in the unit that the field shows, on every page, and the footer says which.
#[test]
fn a_bare_number_has_the_unit_that_its_field_shows_on_every_page() {
    use cmra::tui::pages::explore::state::{Part, SetupRow};
    use cmra::tui::pages::search::state::Row;

    #[track_caller]
    fn near(value: f64, exact: f64) {
        assert!((value - exact).abs() < 1e-15, "{value}");
    }
    let mut bench = Bench::ascii(80, 24);
    bench.keys("j<Enter>");
    assert!(bench.screen().contains("a number alone is in mm"), "{}", bench.screen());
    bench.keys("0.5<Enter>");
    near(bench.app.scene.plate.cocking_m, 0.5e-3);
    // Explore: the ends of an axis.
    keys(&mut bench, "2<Tab>");
    bench.app.pages.explore.row = SetupRow::Axis(0, Part::Name);
    keys(&mut bench, "<Enter>d<Enter>");
    bench.app.pages.explore.row = SetupRow::Axis(0, Part::To);
    keys(&mut bench, "<Enter>");
    assert!(bench.screen().contains("a number alone is in mm"), "{}", bench.screen());
    keys(&mut bench, "40 kg<Enter>");
    assert!(bench.message().contains("or no unit for mm"), "{}", bench.message());
    keys(&mut bench, "<Esc><Enter>40<Enter>");
    near(sweep_plan(&bench.app).expect("a plan").axes()[0].ends().1, 0.04);
    // Goal seek: its range and its goal.
    bench.keys("4");
    bench.app.pages.search.row = Row::Axis(Part::Name);
    bench.keys("<Enter>d<Enter>");
    bench.app.pages.search.row = Row::Axis(Part::To);
    bench.keys("<Enter>25<Enter>");
    near(bench.app.pages.search.setup.seek.to, 0.025);
    bench.app.pages.search.row = Row::Result;
    bench.keys("<Enter>max plate displacement<Enter>");
    bench.app.pages.search.row = Row::Goal;
    bench.keys("<Enter>3 cm<Enter><Enter>");
    assert!(bench.screen().contains("a number alone is in mm"), "{}", bench.screen());
    bench.keys("7<Enter>");
    near(bench.app.pages.search.setup.goal.1, 7e-3);
    // The variables of a front.
    bench.app.pages.search.page = cmra::tui::pages::search::state::Page::Front;
    let at = bench.app.search_bounds().iter().position(|it| it.axis.symbol() == "d").expect("d");
    bench.app.pages.search.row = Row::Bound(at);
    bench.keys("<Enter>1..20<Enter>");
    let ends = bench.app.search_bounds()[at].axis.ends();
    near(ends.0, 1e-3);
    near(ends.1, 0.02);
    // A unit that was typed is that of every field.
    bench.keys("<Enter>1in..3in<Enter>1/<Esc>");
    assert!(bench.screen().contains("in"), "{}", bench.screen());
    assert_eq!(bench.app.pages.run.editor.units.values().collect::<Vec<_>>(), [&"in"]);
}

/// 5 lbf/in is 875.6 N/m: 4.4482216152605 N over 25.4 mm, five times.
#[test]
fn undo_brings_back_value_and_unit() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("jj<Enter>5 lbf/in<Enter>");
    assert!(bench.screen().contains("5 lbf/in"), "{}", bench.screen());
    bench.keys("<Enter>");
    assert!(bench.screen().contains("a number alone is in lbf/in"), "{}", bench.screen());
    bench.keys("<Esc>u");
    assert!(bench.screen().contains("100 kN/m^n"), "{}", bench.screen());
    bench.keys("<Enter>7<Enter>");
    assert_eq!(bench.app.scene.mechanism.spring.coefficient.to_bits(), 7000_f64.to_bits());
    // A refused value leaves the unit; the same value in another unit is an edit.
    bench.keys("<Enter>-5 lbf/in<Enter><Esc>");
    assert!(bench.screen().contains("7 kN/m^n"), "{}", bench.screen());
    bench.keys("<Enter>7000 N/m<Enter>");
    assert!(bench.screen().contains("7000 N/m"), "{}", bench.screen());
    bench.keys("u");
    assert!(bench.screen().contains("7 kN/m^n"), "{}", bench.screen());
    bench.keys("<C-r>");
    assert!(bench.screen().contains("7000 N/m"), "{}", bench.screen());
}
