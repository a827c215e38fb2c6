//! Faults of the workbench that were found by use and put right, each with the keys that showed it.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::bench::{Bench, Study, done};
use super::{accuracy, search, sweep};
use cmra::model::scene::{PlateSize, Scene};
use cmra::model::simulate::{Settings, simulate};
use cmra::study::accuracy::method::Method;
use cmra::study::quantities::named;
use cmra::tui::dialogs::Dialog;
use cmra::tui::message::{EffectReport, ExportOutcome, Message};
use cmra::tui::pages::explore::state::Picture;
use cmra::tui::pages::{explore, run};
use cmra::tui::theme::GlyphSet;
use cmra::worker::{ReportBody, Task, Worker};

/// Press keys and answer runs, sweeps and searches after each.
fn keys(bench: &mut Bench, keys: &[&str]) {
    for key in keys {
        bench.keys(key);
        sweep::answer(bench);
        search::answer(bench);
    }
}

#[test]
fn a_new_filter_begins_empty_and_what_it_hides_is_not_edited() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/gamma<Enter><Enter>2<Enter>/k<Enter><Enter>200<Enter>");
    let scene = Arc::clone(&bench.app.scene);
    assert_eq!(scene.plate.mass_ratio.to_bits(), 2.0_f64.to_bits());
    assert_eq!(scene.mechanism.spring.coefficient.to_bits(), 2e5_f64.to_bits());
    for key in ["<Enter>", "l", "L", ",", "<BS>", "D"] {
        let mut bench = Bench::ascii(80, 24);
        bench.keys(&format!("/zz<Enter>{key}"));
        assert!(bench.screen().contains("no variable matches"), "{}", bench.screen());
        assert!(bench.app.history.edits.is_empty() && bench.app.field.is_none(), "{key}");
    }
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/zz<Enter>l");
    assert!(bench.message().contains("Esc shows all"), "{}", bench.message());
    bench.keys("<Esc>l");
    assert_eq!(bench.app.history.edits.len(), 1);
}

#[test]
fn enter_after_a_value_stays_on_its_row_in_every_form() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/gamma<Enter><Enter>2<Enter>");
    assert_eq!(bench.app.editor.variable().symbol, "gamma");
    bench.keys("<Esc><Enter>3<Down>");
    assert_ne!(bench.app.editor.variable().symbol, "gamma");
    keys(&mut bench, &["2", "<Tab>", "/from<Enter>", "<Enter>", "1<Enter>"]);
    assert!(bench.screen().contains("> from"), "{}", bench.screen());
}

#[test]
fn words_on_the_screen_find_their_rows() {
    let first = |filter: &str| {
        let mut bench = Bench::ascii(80, 24);
        bench.keys(&format!("/{filter}<Enter>"));
        bench.app.editor.variable().symbol
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
    for (typed, kind, name) in [
        ("stiffness", "variable", "k  stiffness"),
        ("velocity", "variable", "v_i  impact velocity"),
        ("stroke", "quantity", "stroke"),
        ("mount force", "quantity", "peak mount force"),
        ("spring force", "curve", "Spring force"),
        ("quit", "action", "Quit"),
        ("report", "action", "Export"),
        ("html", "action", "Export"),
    ] {
        let found = bench.app.palette(typed);
        let first = found.first().unwrap_or_else(|| panic!("{typed} finds nothing"));
        assert_eq!((first.kind(), first.name().as_str()), (kind, name), "{typed}");
    }
    assert!(bench.app.palette("quit").iter().all(|item| !item.name().starts_with("theta")));
}

#[test]
fn a_quantity_that_is_found_is_shown() {
    let mut bench = Bench::ascii(80, 24);
    keys(&mut bench, &[":stroke<Enter>"]);
    assert_eq!(bench.app.pane(), explore::RESULTS);
    assert!(bench.screen().contains("stroke [m"), "{}", bench.screen());
    assert!(!bench.screen().contains("* k=0"), "a family that nobody chose");
    keys(&mut bench, &[":spring force<Enter>"]);
    assert_eq!(bench.app.pane(), run::CHARTS);
    assert!(bench.screen().contains("Spring force, greatest"), "{}", bench.screen());
}

#[test]
fn the_plates_face_is_set_in_the_run_tab() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/face<Enter>");
    assert!(bench.screen().contains("> face   plate side     none"), "{}", bench.screen());
    bench.keys("<Enter>150mm<Enter>");
    let plate = bench.app.scene.plate;
    assert_eq!(plate.size, PlateSize::Face(0.15));
    // rho h face^2 / m_p
    let exact = 2710.0 * 0.0254 * 0.15 * 0.15 / 0.0295;
    assert!((plate.mass_ratio - exact).abs() < 1e-12 * exact);
    // The axis of Explore is the face, from half to twice its value: gamma follows from it.
    let plan = bench.app.sweep_plan(Picture::Line).expect("a plan");
    assert_eq!((plan.axes()[0].symbol(), plan.axes()[0].ends()), ("face", (0.075, 0.3)));
    bench.keys("/gamma<Enter><Enter>2<Enter>");
    assert_eq!(bench.app.scene.plate.size, PlateSize::Ratio);
    // A step begins at the size there is: (2 m_p / (rho h))^(1/2) = 29.277 mm.
    bench.keys("/face<Enter>l");
    assert_eq!(bench.app.scene.plate.size, PlateSize::Face(0.0293));
}

#[test]
fn two_sizes_of_the_plate_are_never_two_axes() {
    let mut bench = Bench::ascii(80, 24);
    keys(&mut bench, &["2", "<Tab>", "/variable<Enter>", "<Enter>", "face<Enter>"]);
    keys(&mut bench, &["/shown<Enter>", "l"]);
    assert_eq!(bench.app.picture(), Picture::Surface);
    let axes = |bench: &Bench| {
        let plan = bench.app.sweep_plan(Picture::Surface).unwrap();
        plan.axes().iter().map(|axis| axis.symbol().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(axes(&bench), ["face", "k"]);
    // Nor by hand.
    keys(&mut bench, &["G", "/variable<Enter>"]);
    bench.app.pages.explore.row = explore::setup::SetupRow::Axis(1, explore::setup::Part::Name);
    keys(&mut bench, &["<Enter>", "gamma<Enter>"]);
    assert!(bench.screen().contains("both set the plate's size"), "{}", bench.screen());
    keys(&mut bench, &["<Esc>"]);
    // The axis replaces the scene's own size, and a design keeps it.
    keys(&mut bench, &["<Tab>", "l", "<Enter>"]);
    assert!(matches!(bench.app.scene.plate.size, PlateSize::Face(_)), "{}", bench.message());
    assert!(!bench.app.sweep_is_old(Picture::Surface));
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
fn the_map_of_mass_efficiency_names_its_axis_across() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("3");
    let asked = bench.effects.clone();
    super::limit::answer(&mut bench);
    bench.effects = asked;
    search::answer(&mut bench);
    let screen = bench.screen();
    let below = screen.lines().skip_while(|line| !line.contains("mass efficiency, up: gamma"));
    assert!(below.clone().any(|line| line.contains(" v_i [")), "{screen}");
}

#[test]
fn a_logarithmic_scale_of_less_than_a_decade_keeps_its_bands() {
    let mut bench = sweep::open_map("figure-9.8", 5, GlyphSet::Ascii, (120, 36));
    keys(&mut bench, &["2", "Y"]);
    let screen = bench.screen();
    assert!(screen.matches(" .. ").count() > 4, "{screen}");
    assert!(screen.contains("Y: linear"), "{screen}");
    assert!(!screen.contains("Y linear"), "{screen}");
}

#[test]
fn the_contour_of_a_map_has_its_value_in_the_picture() {
    let mut bench = sweep::open_map("figure-9.8", 5, GlyphSet::Ascii, (120, 36));
    keys(&mut bench, &["2", "e", "<C-u>", "map.svg<Enter>"]);
    let (_, svg, _) = bench.exported().expect("a picture");
    let note = svg.split('>').find(|text| text.starts_with("— ")).expect("the contour's note");
    assert!(note.contains(" %"), "{note}");
}

#[test]
fn differences_to_a_pin_have_six_digits() {
    let mut bench = Bench::ascii(120, 36);
    bench.keys("/gamma<Enter><Enter>0.9860000000000001<Enter> <Enter>1<Enter>");
    bench.keys("<Tab><Tab>");
    let text = bench.message();
    assert!(text.contains("gamma 0.986 -> 1"), "{text}");
}

#[test]
fn another_spacing_keeps_the_cursor_at_its_value() {
    let mut bench = Bench::ascii(80, 24);
    keys(&mut bench, &["2", "L"]);
    let at = |bench: &Bench| {
        let grid = &bench.app.pages.explore.found(Picture::Line).expect("a sweep").grid;
        grid.coordinate(bench.app.cursor_point(grid), 0)
    };
    let before = at(&bench);
    keys(&mut bench, &["X"]);
    let after = at(&bench);
    // The nearest of 101 points over a factor of 8.75.
    assert!((after / before - 1.0).abs() < 0.012, "{before} {after}");
    assert!(before > 1.2, "{before}");
}

#[test]
fn a_goal_begins_at_the_value_of_the_scene() {
    let mut bench = Bench::ascii(80, 24);
    keys(&mut bench, &["4", "k", "<Enter>", "stroke<Enter>"]);
    let run = &bench.app.shown.as_ref().expect("a run").run;
    let stroke = named("stroke_m").unwrap().value(run).unwrap();
    let (name, goal) = bench.app.pages.search.setup.goal;
    assert_eq!(name, "stroke_m");
    assert!((goal / stroke - 1.0).abs() < 0.05, "{goal} {stroke}");
}

#[test]
fn a_report_that_ends_leaves_another_dialog_alone() {
    let path: std::path::PathBuf = "/home/ada/work/a.html".into();
    let ended = Message::Done(EffectReport::Exported(path.clone(), ExportOutcome::Exists(path)));
    let mut bench = Bench::ascii(80, 24);
    bench.keys("e<C-u>a.html<Enter><Esc>s");
    bench.send(ended.clone());
    assert!(matches!(&bench.app.dialog, Some(Dialog::Ask(ask)) if !ask.question));
    assert!(bench.message().contains("a.html already exists"), "{}", bench.message());
    bench.keys("<Esc>e<C-u>b.html");
    bench.send(ended.clone());
    assert!(matches!(&bench.app.dialog, Some(Dialog::Ask(ask)) if !ask.question));
    bench.keys("<C-u>a.html");
    bench.send(ended);
    assert!(matches!(&bench.app.dialog, Some(Dialog::Ask(ask)) if ask.question));
}

#[test]
fn a_report_asks_about_its_file_first_and_is_computed_once() {
    let place = tempfile::tempdir().unwrap();
    let mut bench = Bench::ascii(80, 24);
    bench.app.directory = place.path().to_owned();
    std::fs::write(place.path().join("a.html"), "").unwrap();
    bench.keys("e<C-u>a.html<Enter>");
    assert!(matches!(&bench.app.dialog, Some(Dialog::Ask(ask)) if ask.question));
    assert!(bench.studies().is_empty());
    bench.keys("o");
    assert_eq!(bench.studies().len(), 1);
    bench.keys("<Esc>e<C-u>b.html<Enter>");
    assert!(bench.studies().is_empty());
    assert!(bench.screen().contains("another report is being written"), "{}", bench.screen());
    let mut bench = Bench::ascii(80, 24);
    bench.keys("e<C-u>b.html<Enter><Enter>");
    assert_eq!(bench.studies().len(), 1);
}

#[test]
fn a_name_that_ends_as_a_report_writes_the_report() {
    for (keys, heading) in [("e<C-u>rep.html<Enter>", "<h2>Ballistic limit</h2>")] {
        let mut bench = Bench::ascii(80, 24);
        bench.keys(keys);
        assert!(bench.screen().contains("writing the report"), "{}", bench.screen());
        let study = bench.studies().pop().expect("a study");
        assert!(bench.exported().is_none());
        let (send, reports) = std::sync::mpsc::channel();
        let worker = Worker::spawn(move |report| drop(send.send(report))).unwrap();
        let Study { id, scene, asked } = study;
        worker.submit(Task { id, threads: 1, scene, study: asked });
        loop {
            let report = reports.recv().expect("a report");
            let is_last = matches!(report.body, ReportBody::Ended { .. } | ReportBody::Failed(_));
            bench.send(Message::Report(report));
            if is_last {
                break;
            }
        }
        let (to, text, has_scene) = bench.exported().expect("a file");
        assert!(to.path.starts_with("/home/ada/work") && !has_scene);
        assert!(text.contains(heading) && text.contains("thesis-baseline"), "{text}");
    }
}

/// With dishing the law holds up to h/D of about 1: the first plate is thin enough, the one behind it, which is struck, is not.
#[test]
fn a_plate_of_a_stack_behind_the_first_marks_its_variable() {
    let mut scene = Scene::default();
    (scene.target.thickness_m, scene.projectile.velocity_m_s) = (0.004, 400.0);
    scene.stack.base_thickness_m = Some(0.0254);
    let scene = Arc::new(scene);
    let mut bench = Bench::ascii(120, 40);
    bench.app.scene = Arc::clone(&scene);
    bench.press("r");
    bench.send(Message::RunDue(bench.app.jobs.serial));
    let is_marked = |bench: &Bench| {
        let screen = bench.screen();
        let row = screen.lines().find(|line| line.contains(" thickness ")).expect("the row of h");
        row.contains("! 4 mm")
    };
    assert!(!is_marked(&bench), "{}", bench.screen());
    let job = bench.jobs().remove(0);
    let go_on = &mut |_| ControlFlow::Continue(());
    bench.reply(job.id, done(simulate(&scene, &Settings::default(), go_on).unwrap()));
    assert!(is_marked(&bench), "{}", bench.screen());
}

#[test]
fn the_title_row_names_the_preset_in_full_as_far_as_it_has_room() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("jjl");
    let screen = bench.screen();
    assert!(screen.lines().next().unwrap().ends_with(" thesis-baseline *"), "{screen}");
}
