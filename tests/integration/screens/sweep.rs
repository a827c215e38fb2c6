//! The Sweep and Surface tabs: whole screens on real sweeps of few points, and keys.

use cmra::tui::pages::explore::cursor::chart_kind;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use super::at_every_size;
use super::bench::{Bench, ended, stopped};
use cmra::files::atomic::OverwritePolicy;
use cmra::files::preset;
use cmra::tui::keymap::Tab;
use cmra::tui::message::ExportOutcome;
use cmra::tui::pages::explore::state::{ChartKind, Part, SetupRow};
use cmra::tui::preset::ReferencePreset;
use cmra::tui::theme::{ColourDepth, GlyphSet, Theme};
use cmra::tui::view::view;
use cmra::worker::studies::{PictureSweep, PrintedSweep, RequestVariant, StudyResult};
use cmra::worker::{JobProgress, ReportBody};
use cmra_engine::model::scene::SpringKind;
use cmra_engine::model::variables::{VARIABLES, Variable, find, is_used};
use cmra_studies::study::context::{self as study, Context};
use cmra_studies::study::sweep::Plan;
use cmra_studies::study::sweep::grid::Grid;
use insta::assert_snapshot;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Color;

/// A sweep that was requested.
struct Job {
    id: u64,
    plan: Arc<Plan>,
}

/// The sweeps requested and not answered.
fn jobs(bench: &mut Bench) -> Vec<Job> {
    bench.sweeps().into_iter().map(|(id, _, plan)| Job { id, plan }).collect()
}

/// A grid of the job, filled until a given number of points are done.
fn grid(job: &Job, points: usize) -> Arc<Grid> {
    let watch = &mut |progress: study::Progress, _: Option<&Grid>| {
        if progress.done >= points { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let grid = Grid::new(Arc::clone(&job.plan)).unwrap();
    Arc::new(grid.fill(1, &mut Context::new(1, watch)))
}

/// Answer every sweep with its grid, as the thread would.
pub(super) fn answer(bench: &mut Bench) {
    for job in jobs(bench) {
        let grid = grid(&job, usize::MAX);
        bench.reply(job.id, ended(grid));
    }
}

/// A bench on a figure with a given number of points along every axis.
pub(super) fn open(figure: &str, count: usize, glyphs: GlyphSet, size: (u16, u16)) -> Bench {
    let mut bench = Bench::open(glyphs, size);
    let mut scene = preset::resolve(figure, None).unwrap().scene;
    for axis in &mut scene.sweep.as_mut().unwrap().axes {
        axis.count = count;
    }
    let scene = Arc::new(scene);
    bench.app.scene = Arc::clone(&scene);
    bench.app.base = ReferencePreset { name: figure.to_owned(), is_mine: false, scene };
    bench
}

/// Opens a map.
pub(super) fn open_map(figure: &str, count: usize, glyphs: GlyphSet, size: (u16, u16)) -> Bench {
    let mut bench = open(figure, count, glyphs, size);
    bench.app.pages.explore.picture = ChartKind::Surface;
    bench
}

/// Press keys, and answer runs, sweeps and searches after each.
pub(super) fn keys(bench: &mut Bench, keys: &str) {
    let mut rest = keys;
    while let Some(first) = rest.chars().next() {
        let name = rest.find('>').filter(|_| first == '<');
        let (key, tail) = rest.split_at(name.map_or_else(|| first.len_utf8(), |end| end + 1));
        bench.keys(key);
        answer(bench);
        super::search::answer(bench);
        rest = tail;
    }
}

#[test]
fn the_sweep_tabs_at_every_size() {
    for (glyphs, (columns, rows)) in at_every_size(&[(60, 16), (80, 24), (120, 36)]) {
        let mut bench = open("figure-9.7", 21, glyphs, (columns, rows));
        keys(&mut bench, "2lll");
        assert_snapshot!(format!("lines_{columns}x{rows}_{glyphs}"), bench.screen());
        bench.app.pages.explore.picture = ChartKind::Surface;
        keys(&mut bench, "12llkkk");
        assert_snapshot!(format!("surface_{columns}x{rows}_{glyphs}"), bench.screen());
    }
}

/// The listing as printed takes away only the last increment of the plate's motion: depths of a light plate are far greater.
#[test]
fn a_figure_has_the_curves_of_the_printed_scheme_beside_its_own() {
    for figure in ["figure-9.2", "figure-9.10"] {
        let mut bench = open(figure, 7, GlyphSet::Ascii, (160, 48));
        bench.keys("2");
        let printed = bench.tasks(|task| {
            let plan = Arc::clone(&PrintedSweep::downcast(&task.request)?.0);
            Some(Job { id: task.id, plan })
        });
        answer(&mut bench);
        assert!(!bench.screen().contains("as printed"), "{}", bench.screen());
        for job in printed {
            let found = grid(&job, usize::MAX);
            bench.reply(job.id, ended(found));
        }
        let screen = bench.screen();
        assert!(screen.contains("as printed"), "{figure}\n{screen}");
        assert!(screen.contains("faint: the "), "{figure}\n{screen}");
    }
}

#[test]
fn a_figure_as_a_map_says_where_the_printed_scheme_is_drawn() {
    let mut bench = open("figure-9.8", 7, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "2<Tab>kl");
    assert_eq!(chart_kind(&bench.app), ChartKind::Surface);
    assert!(bench.message().contains("the corrected physics alone"), "{}", bench.message());
}

#[test]
fn one_curve() {
    let mut bench = open("figure-9.4", 41, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "2vlll");
    assert_snapshot!("lines_one_curve", bench.screen());
}

#[test]
fn points_without_a_value_are_letters_with_a_legend() {
    let mut bench = open_map("figure-9.7", 21, GlyphSet::Ascii, (120, 36));
    keys(&mut bench, "2<Tab>jjjjj<Enter>v_i<Enter>");
    keys(&mut bench, "<Down><Enter>150<Down><Enter>400<Enter><Tab>");
    assert_snapshot!("surface_perforated", bench.screen());
    assert!(bench.screen().contains("P perforated; n no baseline"));
    keys(&mut bench, "<PgUp><PgUp><PgUp><PgUp>");
    // A displacement counts there, a depth does not.
    let message = bench.message();
    assert!(message.contains("perforated, plate ") && !message.contains("deep"), "{message}");
}

#[test]
fn a_coloured_map_has_characters_in_ascii_too() {
    let draw = |glyphs| {
        let mut bench = open_map("figure-9.7", 21, glyphs, (80, 24));
        bench.app.settings.theme = Theme { glyphs, depth: ColourDepth::Ansi256 };
        keys(&mut bench, "2");
        let mut buffer = Buffer::empty(Rect::new(0, 0, 80, 24));
        view(&bench.app, &mut buffer, None);
        buffer
    };
    let coloured = |cell: &&ratatui::buffer::Cell| matches!(cell.bg, Color::Indexed(_));
    let block = draw(GlyphSet::Block);
    assert!(block.content.iter().filter(coloured).count() > 500);
    let ascii = draw(GlyphSet::Ascii);
    let with_both = ascii.content.iter().filter(coloured).filter(|cell| cell.symbol() != " ");
    assert!(with_both.count() > 400);
    assert!(ascii.content.iter().all(|cell| cell.symbol().is_ascii()));
}

#[test]
fn the_cursor_only_looks_and_enter_loads_that_design() {
    let mut bench = open_map("figure-9.7", 21, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "2");
    let before = Arc::clone(&bench.app.scene);
    keys(&mut bench, "llkkk");
    assert_eq!(bench.app.scene, before, "a cursor changes nothing");
    assert!(bench.message().contains("gamma 1.73 k 1125 kN/m^n"), "{}", bench.message());
    keys(&mut bench, "<Enter>");
    let scene = &bench.app.scene;
    // The baseline is nearest to point 1, 0 of 21 x 21.
    assert!((scene.mass_ratio() - (0.8 + 3.0 * 0.31)).abs() < 1e-12);
    assert!((scene.mechanism.spring.coefficient - 3.0 * 375e3).abs() < 1e-6);
    // The run of this design is computed, the surface is not: it is the same.
    assert_eq!(bench.app.shown.as_ref().unwrap().run.scene, bench.app.scene);
    assert!(jobs(&mut bench).is_empty());
    assert_eq!(bench.app.tab, Tab::Explore);
    keys(&mut bench, "u");
    assert_eq!(bench.app.scene, before);
    // Space pins the design under the cursor, and leaves the scene alone.
    keys(&mut bench, "l ");
    assert_eq!(bench.app.scene, before);
    assert_eq!(bench.app.pins.len(), 1);
}

/// Results of another scene are not loaded: the page says to press r, and Enter refuses.
#[test]
fn stale_results_are_not_loaded() {
    let mut bench = open_map("figure-9.7", 5, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "2ll");
    bench.press("1/v_i<Enter>l2");
    let before = Arc::clone(&bench.app.scene);
    bench.press("<Enter>");
    assert_eq!(bench.app.scene, before);
    assert!(bench.message().contains("press r"), "{}", bench.message());
}

#[test]
fn the_cursor_stops_at_the_ends_of_its_axes() {
    let mut bench = open_map("figure-9.7", 11, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "2LLL<PgUp><PgUp><Enter>");
    assert_eq!(bench.app.scene.mass_ratio().to_bits(), 7f64.to_bits());
    assert_eq!(bench.app.scene.mechanism.spring.coefficient.to_bits(), 7.5e6f64.to_bits());
    keys(&mut bench, "HHH<PgDn><PgDn><Enter>");
    assert_eq!(bench.app.scene.mass_ratio().to_bits(), 0.8f64.to_bits());
}

#[test]
fn a_variable_redraws_at_once_coarse_first() {
    let mut bench = open_map("figure-9.7", 21, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "21/v_i<Enter>");
    bench.keys("l2");
    assert_eq!(bench.app.scene.projectile.velocity_m_s.to_bits(), 101f64.to_bits());
    let job = jobs(&mut bench).remove(0);
    assert_eq!(job.plan.base().projectile.velocity_m_s.to_bits(), 101f64.to_bits());
    let part = grid(&job, 36);
    assert!(!part.is_complete());
    bench.part(job.id, (36, 441), StudyResult::from(part));
    assert!(bench.screen().contains("sweeping: 36 of 441 points"), "{}", bench.screen());
    assert_snapshot!("surface_coarse", bench.screen());
    // A newer edit: what the older sweep still says is dropped.
    bench.keys("1l2");
    let newer = jobs(&mut bench).remove(0);
    let late = grid(&job, usize::MAX);
    bench.reply(job.id, ended(late));
    assert!(bench.app.jobs.running::<PictureSweep>().is_some());
    let found = grid(&newer, usize::MAX);
    bench.reply(newer.id, ended(found));
    assert!(bench.screen().contains("441 points in 8.0 ms"), "{}", bench.screen());
}

#[test]
fn a_stopped_sweep_keeps_its_part_and_says_so() {
    let mut bench = open_map("figure-9.7", 21, GlyphSet::Ascii, (80, 24));
    bench.keys("2");
    let job = jobs(&mut bench).remove(0);
    let (progress, elapsed) = (JobProgress::Points(10, 441), Duration::from_secs(5));
    bench.reply(job.id, ReportBody::Progress { progress, elapsed });
    assert!(bench.screen().contains("sweeping: 10 of 441 points"), "{}", bench.screen());
    bench.keys("<Esc>");
    assert!(bench.has_cancelled());
    let found = grid(&job, 100);
    bench.reply(job.id, stopped((100, 441), found));
    assert!(bench.message().contains("partial results are shown"));
    assert!(bench.screen().contains("cancelled: press r (100 of 441 points)"));
    bench.keys("12");
    assert!(jobs(&mut bench).is_empty(), "it waits for r");
    bench.keys("r");
    assert_eq!(jobs(&mut bench).len(), 1);
}

#[test]
fn a_refused_text_stays_with_its_reason() {
    let mut bench = open_map("figure-9.7", 21, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "2<Tab>");
    for (to, text, fragments) in [
        (SetupRow::Axis(0, Part::From), "-1", &["axis gamma", "reaches -1", "greater than 0"][..]),
        (SetupRow::Axis(0, Part::To), "0.8", &["axis gamma", "both ends are 0.8", "differ"]),
        (SetupRow::Axis(1, Part::To), "12 kg", &["k", "`kg` is not a unit"]),
        (SetupRow::Axis(0, Part::Points), "1", &["`1`", "whole number, 2 to 1000000"]),
        (SetupRow::Axis(0, Part::Points), "1000001", &["`1000001`", "whole number, 2 to 1000000"]),
        (
            SetupRow::Axis(0, Part::Points),
            "50000",
            &["1050000 points are too many", "at most 1000000"],
        ),
        (SetupRow::Axis(1, Part::Points), "few", &["`few`", "whole number, 2 to 1000000"]),
        (SetupRow::Axis(0, Part::Name), "k", &["axis k", "swept twice"]),
        (SetupRow::Axis(0, Part::Name), "gama", &["`gama`", "did you mean `gamma`"]),
        (SetupRow::Axis(1, Part::Name), "interface", &["no numbers", "fused or plastic"]),
        (SetupRow::Output, "depth", &["no quantity is called `depth`", "final depth"]),
    ] {
        bench.app.pages.explore.row = to;
        let before = Arc::clone(&bench.app.scene);
        keys(&mut bench, &format!("<Enter>{text}<Enter>"));
        let field = bench.app.field().cloned().expect("the field is still open");
        assert_eq!(field.value(), text);
        for fragment in fragments {
            assert!(bench.message().contains(fragment), "{}: {fragment}", bench.message());
        }
        assert_eq!(bench.app.scene, before);
        assert!(jobs(&mut bench).is_empty());
        keys(&mut bench, "<Esc>");
    }
    // From 0 no equal ratios: refused in words, nothing changes.
    bench.app.pages.explore.row = SetupRow::Axis(1, Part::Spacing);
    keys(&mut bench, "l");
    assert!(bench.message().contains("greater than 0"), "{}", bench.message());
}

#[test]
fn axes_ranges_and_outputs_are_chosen_in_place_and_undone() {
    let mut bench = open("figure-9.2", 11, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "2<Tab>");
    let sweep = |bench: &Bench| bench.app.scene.sweep.clone().unwrap();
    // A family appears, and goes.
    bench.app.pages.explore.row = SetupRow::Axis(1, Part::Name);
    keys(&mut bench, "l");
    assert_eq!(sweep(&bench).axes.len(), 2);
    keys(&mut bench, "<Enter>none<Enter>");
    assert_eq!(sweep(&bench).axes.len(), 1);
    keys(&mut bench, "u");
    assert_eq!(sweep(&bench).axes.len(), 2);
    // Another variable, with the thesis's range.
    bench.app.pages.explore.row = SetupRow::Axis(0, Part::Name);
    keys(&mut bench, "<Enter>d<Enter>");
    assert_eq!((sweep(&bench).axes[0].name.as_str(), sweep(&bench).axes[0].to), ("d", 0.5));
    keys(&mut bench, "j<Enter>1mm<Down><Enter>50mm<Enter>");
    let axis = sweep(&bench).axes[0].clone();
    assert!((axis.from - 1e-3).abs() < 1e-15 && (axis.to - 0.05).abs() < 1e-15);
    bench.app.pages.explore.row = SetupRow::Axis(0, Part::Spacing);
    keys(&mut bench, "<Enter>");
    assert!(sweep(&bench).axes[0].log);
    bench.app.pages.explore.row = SetupRow::Output;
    keys(&mut bench, "<Enter>stroke_m<Enter>");
    assert_eq!(sweep(&bench).outputs[0], "stroke_m");
    assert!(bench.screen().contains("stroke [mm]"), "{}", bench.screen());
    // The whole way back.
    keys(&mut bench, "uuuuuu");
    assert_eq!(bench.app.scene, bench.app.base.scene);
}

/// There and back before the first sweep has ended: what is shown is what is wanted, and the late sweep does not replace it.
#[test]
fn an_edit_taken_back_leaves_the_picture_as_it_is() {
    let mut bench = open("figure-9.2", 11, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "2<Tab>");
    let shown = bench.screen();
    bench.app.pages.explore.row = SetupRow::Axis(0, Part::Spacing);
    bench.keys("l");
    let late = jobs(&mut bench).remove(0);
    bench.keys("l");
    assert!(bench.has_cancelled());
    let found = grid(&late, usize::MAX);
    bench.reply(late.id, ended(found));
    let chart = |screen: &str| -> Vec<String> {
        screen.lines().take(20).filter_map(|it| it.split_once("||")).map(|it| it.1.into()).collect()
    };
    assert_eq!(chart(&bench.screen()), chart(&shown), "{}", bench.screen());
}

#[test]
fn a_scene_without_a_sweep_gets_usual_axes() {
    let mut bench = Bench::ascii(80, 24);
    bench.app.pages.explore.picture = ChartKind::Surface;
    keys(&mut bench, "2");
    assert!(bench.screen().contains("% of rigid-mount depth, up: k"), "{}", bench.screen());
    assert!(!bench.app.is_modified(), "looking changes nothing");
    // The setup chooses curves or a map, and one undo comes back.
    bench.app.pages.explore.row = SetupRow::Picture;
    keys(&mut bench, "<Tab>l");
    assert!(bench.screen().contains("variable  gamma"), "{}", bench.screen());
    assert_eq!(chart_kind(&bench.app), ChartKind::Line);
    keys(&mut bench, "u");
    assert_eq!(chart_kind(&bench.app), ChartKind::Surface);
}

#[test]
fn results_are_exported_and_nothing_is_replaced_without_consent() {
    let mut bench = open_map("figure-9.7", 5, GlyphSet::Ascii, (80, 24));
    keys(&mut bench, "2e");
    assert_snapshot!("surface_export", bench.screen());
    bench.press("<Enter>");
    let (to, text, has_scene) = bench.exported().expect("an export");
    assert!(has_scene, "runs it again");
    assert!(to.path.ends_with("figure-9.7-gamma-k.csv") && to.existing == OverwritePolicy::Keep);
    assert!(text.starts_with(
        "gamma,k,outcome,verdict,percent_of_baseline,max_plate_displacement_m,lower_bounds,error\n"
    ));
    assert_eq!(text.lines().count(), 1 + 25);
    bench.export_ended(ExportOutcome::Exists("x.csv".into()));
    assert!(bench.screen().contains(" o overwrite"), "{}", bench.screen());
    bench.press("y");
    assert_eq!(bench.exported().expect("asked again").0.existing, OverwritePolicy::Replace);
}

/// Beyond the rigid plate's own limit there is no baseline to be a percentage of, though the plate still holds.
#[test]
fn the_letter_of_points_at_rest_without_a_value_is_explained() {
    let mut bench = open("figure-9.2", 11, GlyphSet::Ascii, (100, 24));
    bench.press("/v_i<Enter><Enter>300<Enter>2");
    bench.answer();
    answer(&mut bench);
    assert!(bench.screen().contains(" points (n): no baseline depth"), "{}", bench.screen());
}

/// The row says `none`: the variable that would be the usual one is chosen by its name like any other.
#[test]
fn curves_are_repeated_for_any_variable_that_is_typed() {
    for name in ["k", "n"] {
        let mut bench = Bench::ascii(80, 24);
        keys(&mut bench, "2<Tab>jjjjj<Enter>");
        assert!(bench.screen().contains("[none"), "{}", bench.screen());
        assert!(!bench.screen().contains("7.5MN/m"), "no unit belongs to a name");
        bench.keys(&format!("{name}<Enter>"));
        answer(&mut bench);
        let axes = &bench.app.scene.sweep.as_ref().expect("a sweep").axes;
        assert_eq!(axes.iter().map(|axis| axis.name.as_str()).collect::<Vec<_>>(), ["gamma", name]);
        assert!(bench.screen().contains("curves"), "{}", bench.screen());
    }
}

/// The plate's size is given by gamma: the cursor of a sweep over its mass stands at the mass that it has all the same.
#[test]
fn the_cursor_of_a_sweep_over_the_mass_of_the_plate_begins_at_the_scene() {
    let mut bench = Bench::ascii(80, 24);
    keys(&mut bench, "2<Tab>l<Tab>");
    let message = bench.message();
    let near = message.strip_prefix("near m_2 ").and_then(|rest| rest.split_once(' '));
    let mass_g: f64 = near.expect(&message).0.trim_end_matches(':').parse().unwrap();
    // Half a step of the axis.
    assert!((1e-3 * mass_g - bench.app.scene.plate_mass_kg()).abs() < 0.6e-3, "{message}");
}

/// The line above the chart says what is held, and where that differs from the caption; the family over n shows its edge.
#[test]
fn a_figure_says_what_it_holds_and_where_it_differs_from_its_caption() {
    let mut bench = open("figure-9.8", 9, GlyphSet::Ascii, (120, 36));
    bench.press("2");
    answer(&mut bench);
    let screen = bench.screen();
    assert!(screen.contains("d 0  k 100 kN/m"), "{screen}");
    assert!(screen.contains("b 0") && screen.contains("h 25.4 mm"), "{screen}");
    assert!(!screen.contains("caption"), "{screen}");
    let legend = "* n=0.1  o 0.2  + 0.25  x 0.3  # 0.5  % 1  @ 3";
    assert!(screen.contains(legend), "{screen}");
    let mut bench = open("figure-9.6", 9, GlyphSet::Ascii, (120, 36));
    bench.press("2");
    answer(&mut bench);
    let screen = bench.screen();
    assert!(screen.contains("k 1000 kN/m^n (caption: 100 kN/m^n, see ?)"), "{screen}");
}

/// Whatever the kind of spring, the line above the chart names the one that acts and its variables, and none that have no effect.
#[test]
fn what_is_held_names_the_spring_that_acts() {
    for kind in SpringKind::ALL {
        let mut bench = Bench::ascii(120, 36);
        let mut scene = bench.app.scene.as_ref().clone();
        scene.mechanism.spring.kind = kind;
        bench.app.scene = Arc::new(scene.clone());
        bench.press("2");
        answer(&mut bench);
        let screen = bench.screen();
        let line = format!(" {} ", screen.lines().nth(1).expect("the line of what is held").trim());
        let is_named = |symbol: &str| line.contains(&format!(" {symbol} "));
        // The points of a table are no variables; one spring needs no count.
        let is_own = |variable: &&Variable| {
            let is_number = variable.number().is_some() && variable.symbol != "N_spring";
            is_number && variable.key.starts_with("mechanism.spring.") && is_used(variable, &scene)
        };
        let is_ignored = |symbol: &str| !is_used(find(symbol).unwrap(), &scene);
        assert!(["k", "n"].iter().all(|it| !(is_ignored(it) && is_named(it))), "{line}");
        if kind == SpringKind::PowerLaw {
            assert!(is_named("k") && is_named("n"), "{line}");
            continue;
        }
        assert!(line.contains(&format!("spring {}", kind.word())), "{line}");
        let own: Vec<&str> = VARIABLES.iter().filter(is_own).map(|it| it.symbol).collect();
        let is_first_named = own.first().is_none_or(|first| is_named(first));
        assert!(is_first_named && (own.is_empty() == (kind == SpringKind::Table)), "{line}");
    }
}
