//! Zoom, fit and pan of the maps: the same keys in Explore, Limit and Numerics, in decades on a logarithmic axis.

use std::sync::Arc;

use super::bench::Bench;
use super::{search, stability, sweep};
use cmra::model::scene::Closure;
use cmra::tui::pages::limit::comparison::EqualMass;
use cmra::tui::pages::numerics::stability::StabilityMap;
use cmra::tui::theme::GlyphSet;

type Ends = [(f64, f64); 2];

fn is_near(a: f64, b: f64) -> bool {
    (a / b - 1.0).abs() < 1e-9
}

/// The decades between two ends.
fn decades((from, to): (f64, f64)) -> f64 {
    (to / from).log10()
}

/// The ends of the map of Explore, which are those of its setup.
fn swept(bench: &Bench) -> Vec<(f64, f64)> {
    let axes = &bench.app.scene.sweep.as_ref().expect("a sweep").axes;
    axes.iter().map(|axis| (axis.from, axis.to)).collect()
}

#[test]
fn the_map_of_explore_is_zoomed_by_the_ends_of_its_axes_and_an_undo_takes_it_back() {
    let mut bench = sweep::open_map("figure-9.8", 5, GlyphSet::Ascii, (80, 24));
    bench.keys("2");
    sweep::answer(&mut bench);
    bench.keys("<Right>");
    let design = bench.app.sweep_design().expect("a design").scene;
    let before = swept(&bench);
    bench.keys("+");
    assert!(bench.message().contains("computing the map again"), "{}", bench.message());
    sweep::answer(&mut bench);
    for ((from, to), (low, high)) in before.iter().zip(swept(&bench)) {
        assert!(((high - low) / (to - from) - 0.5).abs() < 1e-3, "{from} {to}: {low} {high}");
    }
    let after = bench.app.sweep_design().expect("a design").scene;
    assert!((after.plate.mass_ratio / design.plate.mass_ratio - 1.0).abs() < 1e-3, "in its place");
    bench.keys("u");
    assert_eq!(swept(&bench), before);
}

#[test]
fn the_map_of_explore_is_panned_and_fitted_to_the_ends_of_the_preset() {
    let mut bench = sweep::open_map("figure-9.8", 5, GlyphSet::Ascii, (80, 24));
    bench.keys("2");
    sweep::answer(&mut bench);
    let before = swept(&bench);
    bench.keys("+");
    sweep::answer(&mut bench);
    let near = swept(&bench);
    bench.keys("]");
    sweep::answer(&mut bench);
    let panned = swept(&bench);
    let quarter = 0.25 * (near[0].1 - near[0].0);
    assert!((panned[0].0 - near[0].0 - quarter).abs() < 1e-3 * quarter, "{near:?} {panned:?}");
    assert_eq!(panned[1], near[1], "only across");
    bench.keys("[");
    sweep::answer(&mut bench);
    assert_eq!(swept(&bench), near);
    bench.keys("0");
    sweep::answer(&mut bench);
    assert_eq!(swept(&bench), before);
    bench.keys("0");
    assert_eq!(bench.message(), "the map ends here");
}

/// The ends of the map of stability that is being computed.
fn requested(bench: &Bench) -> Option<Ends> {
    bench.app.jobs.study::<StabilityMap>().expect("a map").1.0.ends
}

#[test]
fn the_map_of_stability_is_computed_again_over_half_its_decades() {
    let mut bench = stability::open(GlyphSet::Ascii, (80, 24));
    let (whole, cursor) = (bench.app.map_readout(), [1e-6, 1e5]);
    bench.keys("+");
    assert!(bench.message().contains("computing the map again (0 shows"));
    let near = requested(&bench).expect("a part");
    // Of 1e-9 to 1e-4 s and 1e3 to 1e12 N/m; about the crosshair, which keeps its share of them.
    assert!(is_near(decades(near[0]), 2.5) && is_near(decades(near[1]), 4.5), "{near:?}");
    for ((from, _), at, share) in [(near[0], cursor[0], 1.5), (near[1], cursor[1], 1.0)] {
        assert!((decades((from, at)) - share).abs() < 0.3, "{near:?}");
    }
    stability::answer(&mut bench);
    let before = bench.message();
    assert!(bench.screen().contains("the thesis's scheme, not auto; up: k"), "{}", bench.screen());
    bench.keys("]");
    let panned = requested(&bench).expect("a part");
    assert!(is_near(decades((near[0].0, panned[0].0)), 2.5 / 4.0), "{near:?} {panned:?}");
    assert!(is_near(decades(panned[0]), 2.5) && is_near(decades(panned[1]), 4.5));
    assert!(is_near(panned[1].0, near[1].0), "only across");
    stability::answer(&mut bench);
    bench.keys("0");
    assert_eq!(requested(&bench), None);
    stability::answer(&mut bench);
    bench.app.notice = None;
    assert_eq!(bench.app.map_readout(), whole, "the crosshair is where it was: {before}");
    // The whole map is all there is.
    bench.keys("-");
    assert_eq!(bench.message(), "the map ends here");
    bench.keys("X");
    assert_eq!(bench.message(), "both axes of this map are logarithmic");
}

#[test]
fn another_variable_or_scene_has_its_whole_map_of_stability() {
    let mut bench = stability::open(GlyphSet::Ascii, (80, 24));
    bench.keys("+");
    stability::answer(&mut bench);
    bench.keys("v");
    assert_eq!(requested(&bench), None);
    stability::answer(&mut bench);
    bench.keys("+");
    stability::answer(&mut bench);
    bench.keys("1jjl5");
    assert_eq!(requested(&bench), None);
}

#[test]
fn the_map_of_mass_efficiency_is_zoomed_panned_and_fitted() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("3");
    search::answer(&mut bench);
    bench.keys("<Tab><Tab>");
    let asked = |bench: &Bench| bench.app.jobs.study::<EqualMass>().expect("a map").1.part;
    let ends = |bench: &Bench| {
        let map = bench.app.comparison().and_then(|found| found.map.as_ref()).expect("a map");
        [map.x().ends(), map.y().ends()]
    };
    let velocity = |bench: &Bench| {
        bench.app.efficiency_design().expect("a design").scene.projectile.velocity_m_s
    };
    let (whole, at) = (ends(&bench), velocity(&bench));
    bench.keys("+");
    assert!(asked(&bench).is_some());
    assert!(bench.message().contains("computing the map again"), "{}", bench.message());
    // Until it is there the whole map is shown.
    assert_eq!(ends(&bench), whole);
    search::answer(&mut bench);
    let near = ends(&bench);
    for (near, whole) in near.iter().zip(whole) {
        assert!((decades(*near) / decades(whole) - 0.5).abs() < 1e-3, "{near:?} {whole:?}");
    }
    // Within a cell: 21 points over 0.65 decades.
    assert!((velocity(&bench) / at).log10().abs() < 0.04, "{at} {}", velocity(&bench));
    bench.keys("[");
    search::answer(&mut bench);
    assert!(ends(&bench)[0].0 < near[0].0 && ends(&bench)[1] == near[1]);
    bench.keys("0");
    search::answer(&mut bench);
    for (now, whole) in ends(&bench).iter().zip(whole) {
        assert!(is_near(now.0, whole.0) && is_near(now.1, whole.1), "{now:?} {whole:?}");
    }
    bench.keys("Y");
    assert_eq!(bench.message(), "both axes of this map are logarithmic");
    // Another scene has its whole map.
    bench.keys("+");
    search::answer(&mut bench);
    bench.keys("1jjl3");
    assert!(asked(&bench).is_none());
}

/// A hard core on AA6082, as in `cmra compare`: of 271 to 285 m/s only the change of closure at h = D decides.
#[test]
fn the_change_of_closure_is_named_in_the_comparison() {
    let opened = || {
        let mut bench = Bench::ascii(120, 40);
        let mut scene = (*bench.app.scene).clone();
        scene.projectile.mass_kg = 5.3e-3;
        scene.projectile.tip_radius_m = 3.124e-3;
        scene.projectile.velocity_m_s = 278.0;
        scene.target.closure = Closure::ByThickness;
        scene.target.thickness_m = 0.012;
        scene.plate.mass_ratio = 41.63;
        scene.mechanism.spring.coefficient = 1.0;
        scene.mechanism.energy_j_kg = Some(18_200.0);
        (scene.target.yield_pa, scene.target.modulus_pa) = (260e6, 70e9);
        bench.app.scene = Arc::new(scene);
        bench.keys("3");
        search::answer(&mut bench);
        bench
    };
    let screen = opened().screen();
    assert!(screen.contains("just as thick as the projectile (h = D)"), "{screen}");
}

#[test]
fn a_pane_without_chart_or_map_says_that_it_does_not_zoom() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("7+");
    assert_eq!(bench.message(), "only charts and maps zoom");
}

/// As in Run, the axis of values is that of what is in view.
#[test]
fn curves_that_are_zoomed_have_the_values_in_view() {
    let labels = |bench: &Bench| {
        let screen = bench.screen();
        let of = |line: &str| Some(line.split_once("||")?.1.split_once('+')?.0.trim().parse().ok());
        let labels: Vec<f64> = screen.lines().filter_map(of).flatten().collect();
        labels.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b))
            - labels.iter().fold(f64::INFINITY, |a, b| a.min(*b))
    };
    let mut bench = sweep::open("figure-9.4", 21, GlyphSet::Ascii, (80, 24));
    bench.keys("2");
    sweep::answer(&mut bench);
    let whole = labels(&bench);
    bench.keys("++");
    assert!(labels(&bench) < 0.5 * whole, "{whole}: {}", bench.screen());
}
