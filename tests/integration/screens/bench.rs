//! A workbench without terminal, worker and disk: keys go in, effects are kept, jobs are answered with made-up runs.
//!
//! The runs are smooth curves of the right size, not physics: a picture must not change when a digit of the solver does.

use std::f64::consts::PI;
use std::sync::Arc;
use std::time::Duration;

use cmra::files::export::Destination;
use cmra::tui::app::App;
use cmra::tui::keymap::Target;
use cmra::tui::message::{Effect, EffectReport, ExportOutcome, FileTask, Message};
use cmra::tui::preset::{PresetEntry, ReferencePreset};
use cmra::tui::theme::{ColourDepth, GlyphSet, Theme};
use cmra::tui::update::{start, update};
use cmra::tui::view::{Targets, view};
use cmra::worker::studies::{StudyRequest, StudyResult};
use cmra::worker::{JobProgress, ReportBody, Task, TaskReport};
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::run::{
    Arrest, ContactMode, Cost, Departure, EndReason, EnergyLedger, ErrorEstimate, EstimateBasis,
    Event, EventKind, InterfaceLoad, MechanismLoad, Outcome, Penetration, Run, RunWarning, Sample,
};
use cmra_engine::model::scene::{Mount, PlateSize, Scene};
use cmra_studies::study::context::{Answer, Progress, Reach};
use cmra_studies::study::sweep::Plan;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// A workbench on a desk.
pub(crate) struct Bench {
    pub(crate) app: App,
    /// Effects that no assertion has taken yet.
    pub(crate) effects: Vec<Effect>,
}

/// A run that was submitted.
#[derive(Clone)]
pub(crate) struct Job {
    pub(crate) id: u64,
    pub(crate) scene: Arc<Scene>,
}

/// A study that was submitted.
#[derive(Clone)]
pub(crate) struct Study {
    pub(crate) id: u64,
    pub(crate) scene: Arc<Scene>,
    pub(crate) request: StudyRequest,
}

impl Bench {
    /// Open on the baseline, with its run on the screen.
    pub(crate) fn open(glyphs: GlyphSet, size: (u16, u16)) -> Self {
        let mut bench = Self::closed(glyphs, size);
        let effects = start(&mut bench.app);
        bench.effects.extend(effects);
        bench.send(Message::Resize(size.0, size.1));
        bench.send(Message::Done(EffectReport::Presets(presets())));
        bench.answer();
        bench
    }

    /// Before anything has been requested.
    pub(crate) fn closed(glyphs: GlyphSet, size: (u16, u16)) -> Self {
        let base = ReferencePreset {
            name: "thesis-baseline".to_owned(),
            is_mine: false,
            scene: Arc::new(Scene::default()),
        };
        let theme = Theme { glyphs, depth: ColourDepth::None };
        let mut app = App::new(base, theme, "/home/ada/work".into());
        app.size = size;
        Self { app, effects: Vec::new() }
    }

    pub(crate) fn ascii(columns: u16, rows: u16) -> Self {
        Self::open(GlyphSet::Ascii, (columns, rows))
    }

    pub(crate) fn send(&mut self, message: Message) {
        let effects = update(&mut self.app, message);
        self.effects.extend(effects);
    }

    /// Take out the tasks of a kind that have been submitted and not been looked at.
    pub(crate) fn tasks<T>(&mut self, of: impl Fn(&Task) -> Option<T>) -> Vec<T> {
        let mut found = Vec::new();
        self.effects.retain(|effect| match effect {
            Effect::Submit(task) => of(task).map(|one| found.push(one)).is_none(),
            _ => true,
        });
        found
    }

    /// The studies but sweeps that have been submitted and not been looked at.
    pub(crate) fn studies(&mut self) -> Vec<Study> {
        self.tasks(|task| {
            let Task { id, scene, request, .. } = task.clone();
            let other = !matches!(request, StudyRequest::Picture(_) | StudyRequest::Run(_));
            other.then_some(Study { id, scene, request })
        })
    }

    /// The plans of the sweeps that have been submitted and not been looked at, with their numbers and threads.
    pub(crate) fn sweeps(&mut self) -> Vec<(u64, usize, Arc<Plan>)> {
        self.tasks(|task| {
            let StudyRequest::Picture(sweep) = &task.request else { return None };
            Some((task.id, task.threads, Arc::clone(&sweep.plan)))
        })
    }

    /// Where the last table was asked to be written, its text, and whether its scene goes beside it.
    pub(crate) fn exported(&mut self) -> Option<(Destination, String, bool)> {
        self.effects.drain(..).rev().find_map(|effect| match effect {
            Effect::Files(FileTask::Export(to, content)) => {
                let text = content.text();
                Some((to, text, !content.scenes().is_empty()))
            }
            _ => None,
        })
    }

    /// Report how the export ended that the open dialog asked for.
    pub(crate) fn export_ended(&mut self, outcome: ExportOutcome) {
        let screen = self.screen();
        let at = screen.find("/home/ada/work/").expect("a dialog that asks");
        let path = screen[at..].split([' ', '|', '│']).next().expect("a path").into();
        self.send(Message::Done(EffectReport::Exported(path, outcome)));
    }

    /// Report on a task, as its thread would.
    pub(crate) fn reply(&mut self, id: u64, body: ReportBody) {
        self.send(Message::Report(TaskReport { id, body }));
    }

    /// Report that a task has done a given number of points.
    pub(crate) fn progress(&mut self, id: u64, done: usize, total: usize) {
        let (progress, elapsed) = (JobProgress::Points(done, total), Duration::from_millis(600));
        self.reply(id, ReportBody::Progress { progress, elapsed });
    }

    /// Report what a task has so far.
    pub(crate) fn part(&mut self, id: u64, (done, total): (usize, usize), part: StudyResult) {
        self.progress(id, done, total);
        let reach = Reach::Partial(Progress { done, total });
        let elapsed = Duration::from_millis(600);
        self.reply(id, ReportBody::Part(Answer { report: part, reach, elapsed }));
    }

    /// Whether a task was cancelled.
    pub(crate) fn has_cancelled(&self) -> bool {
        self.effects.iter().any(|effect| matches!(effect, Effect::Cancel(_)))
    }

    /// Press keys: single characters, or names in angle brackets: `jj<Enter>1.25<C-r>`. Jobs stay unanswered.
    pub(crate) fn press(&mut self, keys: &str) {
        for key in keys_of(keys) {
            let event = match key.strip_prefix('<').and_then(|name| name.strip_suffix('>')) {
                Some(name) if name.len() > 1 => named(name),
                _ => {
                    let letter = key.chars().next().expect("a key");
                    KeyEvent::new(KeyCode::Char(letter), KeyModifiers::NONE)
                }
            };
            self.send(Message::Key(event));
        }
    }

    /// Press keys and answer what was requested after each.
    pub(crate) fn keys(&mut self, keys: &str) {
        self.press(keys);
        self.answer();
    }

    /// The jobs that have been submitted and not answered.
    pub(crate) fn jobs(&mut self) -> Vec<Job> {
        self.tasks(|task| {
            let is_run = matches!(task.request, StudyRequest::Run(_));
            is_run.then(|| Job { id: task.id, scene: Arc::clone(&task.scene) })
        })
    }

    /// Answer every job with a made-up run, as the worker would.
    pub(crate) fn answer(&mut self) {
        loop {
            let jobs = self.jobs();
            if jobs.is_empty() {
                return;
            }
            for job in jobs {
                self.reply(job.id, done(made(&job.scene)));
            }
        }
    }

    /// The newest message, or what stands in its place.
    pub(crate) fn message(&self) -> String {
        if let Some(notice) = &self.app.notice {
            return notice.text.clone();
        }
        let lines = self.app.message_lines(usize::from(self.app.size.0));
        lines.into_iter().map(|(_, text)| text).collect::<Vec<_>>().join(" ")
    }

    /// The whole screen as text.
    pub(crate) fn screen(&self) -> String {
        let (columns, rows) = self.app.size;
        let mut buffer = Buffer::empty(Rect::new(0, 0, columns, rows));
        view(&self.app, &mut buffer, None);
        cmra::tui::chart::buffer_lines(&buffer).join("\n")
    }
}

/// Element that a click hits on the screen as drawn now.
pub(crate) fn target(app: &App, at: (u16, u16)) -> Option<Target> {
    let mut buffer = Buffer::empty(Rect::new(0, 0, app.size.0, app.size.1));
    let mut targets = Targets::default();
    view(app, &mut buffer, Some(&mut targets));
    targets.at(at)
}

/// The keys of a text, each as it is written: `j`, `<Enter>`.
pub(crate) fn keys_of(text: &str) -> Vec<String> {
    let (mut keys, mut rest) = (Vec::new(), text);
    while let Some(first) = rest.chars().next() {
        let name = rest.strip_prefix('<').and_then(|tail| tail.find('>'));
        // One letter in brackets is typed with them.
        let length = name.filter(|at| *at > 1).map_or_else(|| first.len_utf8(), |at| at + 2);
        keys.push(rest[..length].to_owned());
        rest = &rest[length..];
    }
    keys
}

pub(crate) fn done(run: Run) -> ReportBody {
    let elapsed = Duration::from_micros(210);
    ReportBody::Ended(Some(Answer { report: run.into(), reach: Reach::Complete, elapsed }))
}

/// The last report of a task.
pub(crate) fn ended(found: impl Into<StudyResult>) -> ReportBody {
    ended_at(Reach::Complete, found)
}

/// The last report of a task that was stopped after so many of its points.
pub(crate) fn stopped((done, total): (usize, usize), found: impl Into<StudyResult>) -> ReportBody {
    ended_at(Reach::Partial(Progress { done, total }), found)
}

fn ended_at(reach: Reach, found: impl Into<StudyResult>) -> ReportBody {
    let elapsed = Duration::from_millis(8);
    ReportBody::Ended(Some(Answer { report: found.into(), reach, elapsed }))
}

fn named(name: &str) -> KeyEvent {
    let (code, modifiers) = match name {
        "Enter" => (KeyCode::Enter, KeyModifiers::NONE),
        "Esc" => (KeyCode::Esc, KeyModifiers::NONE),
        "Tab" => (KeyCode::Tab, KeyModifiers::NONE),
        "S-Tab" => (KeyCode::BackTab, KeyModifiers::SHIFT),
        "Up" => (KeyCode::Up, KeyModifiers::NONE),
        "Down" => (KeyCode::Down, KeyModifiers::NONE),
        "Left" => (KeyCode::Left, KeyModifiers::NONE),
        "Right" => (KeyCode::Right, KeyModifiers::NONE),
        "BS" => (KeyCode::Backspace, KeyModifiers::NONE),
        "PgUp" => (KeyCode::PageUp, KeyModifiers::NONE),
        "PgDn" => (KeyCode::PageDown, KeyModifiers::NONE),
        "F2" => (KeyCode::F(2), KeyModifiers::NONE),
        "F5" => (KeyCode::F(5), KeyModifiers::NONE),
        "C-c" => (KeyCode::Char('c'), KeyModifiers::CONTROL),
        "C-r" => (KeyCode::Char('r'), KeyModifiers::CONTROL),
        "C-z" => (KeyCode::Char('z'), KeyModifiers::CONTROL),
        "C-u" => (KeyCode::Char('u'), KeyModifiers::CONTROL),
        other => panic!("no key is called {other}"),
    };
    KeyEvent::new(code, modifiers)
}

/// A few presets, as the list of presets would have them.
pub(crate) fn presets() -> Vec<PresetEntry> {
    let entry = |name: &str, origin: &'static str, comment: &str, change: fn(&mut Scene)| {
        let mut scene = Scene::default();
        change(&mut scene);
        PresetEntry {
            name: name.to_owned(),
            origin,
            scene,
            comment: comment.to_owned(),
            ..PresetEntry::default()
        }
    };
    vec![
        entry(
            "thesis-baseline",
            "bundled",
            "The scene the figures of chapter 9 start from.",
            |_| {},
        ),
        entry(
            "rigid-mount",
            "bundled",
            "The plate cannot move (thesis section 9.3).\nExpect 7.113 mm in closed form; the thesis prints 7.129 mm.",
            |scene| {
                scene.title = "Rigid mount".to_owned();
                scene.plate.mount = Mount::Rigid;
            },
        ),
        entry(
            "cocked",
            "bundled",
            "A plate that meets the projectile.\nExpect 1.658 mm and a demand on the interface near 2.9.",
            |scene| {
                scene.title = "Cocked plate".to_owned();
                scene.plate.cocking_m = 0.5;
                scene.mechanism.spring.coefficient = 7.5e6;
                scene.plate.size = PlateSize::Ratio(0.8);
            },
        ),
        entry("heavy-plate", "mine", "", |scene| scene.plate.size = PlateSize::Ratio(5.0)),
    ]
}

/// How long the made-up contact lasts, s.
const ARREST_S: f64 = 113e-6;
/// When the made-up plate turns back, s.
const TURN_S: f64 = 1.3e-3;

/// The numbers a made-up run is drawn from.
struct Shape {
    depth_m: f64,
    speed_m_s: f64,
    together_m_s: f64,
    cocking_m: f64,
}

impl Shape {
    fn from_scene(scene: &Scene) -> Self {
        let gamma = scene.mass_ratio();
        let rigid = !scene.is_sprung();
        let share = if rigid { 1.0 } else { gamma / (1.0 + gamma) };
        let speed_m_s = scene.projectile.velocity_m_s;
        Self {
            depth_m: 0.007_113 * share.powf(0.64) * (speed_m_s / 100.0),
            speed_m_s,
            together_m_s: if rigid { 0.0 } else { speed_m_s * (1.0 - share) },
            cocking_m: scene.plate.cocking_m,
        }
    }

    fn sample(&self, t_s: f64) -> Sample {
        let phase = 0.5 * PI * (t_s / ARREST_S).min(1.0);
        let after = (t_s - ARREST_S).max(0.0);
        let turn = 0.5 * PI * after / (TURN_S - ARREST_S);
        let travel = self.together_m_s * (t_s.min(ARREST_S) - ARREST_S * 2.0 / PI * phase.sin());
        let rebound = self.together_m_s * (TURN_S - ARREST_S) * 2.0 / PI * turn.sin();
        let plate_m_s = self.together_m_s * (1.0 - phase.cos()) * turn.cos();
        let penetration_m = self.depth_m * phase.sin();
        Sample {
            t_s,
            mode: if after > 0.0 { ContactMode::Fused } else { ContactMode::Penetrating },
            penetration_m,
            projectile_displacement_m: penetration_m + travel + rebound,
            projectile_velocity_m_s: plate_m_s + self.speed_m_s * phase.cos(),
            plate_displacement_m: travel + rebound - self.cocking_m,
            plate_velocity_m_s: plate_m_s,
            contact_force_n: if after > 0.0 { 2e3 * turn.sin() } else { 17_745.0 * phase.sin() },
            spring_force_n: 4e3 * turn.sin(),
            damper_force_n: 0.0,
            stop_force_n: 0.0,
        }
    }

    fn series(&self, end_s: f64) -> Vec<Sample> {
        let part =
            |from: f64, to: f64| (0..=200).map(move |i| from + (to - from) * f64::from(i) / 200.0);
        part(0.0, ARREST_S).chain(part(ARREST_S, end_s)).map(|t_s| self.sample(t_s)).collect()
    }
}

/// The force of a power law alone where the plate starts and turns, N; else that of the rows.
fn mount_n(scene: &Scene) -> f64 {
    let Mechanism { spring, damper, stop } = Mechanism::from_scene(scene);
    if spring.power().is_none() || !damper.is_absent() || stop.is_some() {
        return 4e3;
    }
    let turn_m = Shape::from_scene(scene).sample(TURN_S).plate_displacement_m;
    [-scene.plate.cocking_m, turn_m]
        .map(|x_m| spring.force(x_m).abs())
        .into_iter()
        .fold(0.0, f64::max)
}

/// A made-up run of a scene: a thin plate is perforated, a cocked one asks too much of the interface.
pub(crate) fn made(scene: &Arc<Scene>) -> Run {
    let rigid = !scene.is_sprung();
    let shape = Shape::from_scene(scene);
    let arrest = shape.sample(ARREST_S);
    let mut run = Run {
        scene: Arc::clone(scene),
        outcome: Outcome::Arrested,
        end: EndReason::Decided,
        first_arrest: Some(Arrest {
            t_s: ARREST_S,
            penetration_m: arrest.penetration_m,
            plate_displacement_m: arrest.plate_displacement_m,
            plate_velocity_m_s: arrest.plate_velocity_m_s,
        }),
        penetration: Penetration {
            final_m: Some(shape.depth_m),
            baseline_m: Some(0.007_113),
            at_most_m: None,
        },
        peak_contact_force_n: Some(17_745.0),
        max_plate_displacement_m: Some(shape.sample(TURN_S).plate_displacement_m),
        at_least: cmra_engine::model::run::AtLeast::default(),
        departure: Departure::default(),
        interface: InterfaceLoad { demand_ratio: Some(0.108), tension_ratio: Some(0.0) },
        estimate: ErrorEstimate {
            main: Some(3e-12),
            basis: Some(EstimateBasis::SecondComputation),
            ..ErrorEstimate::default()
        },
        series: shape.series(TURN_S),
        events: vec![
            Event { t_s: 55e-6, kind: EventKind::NoseBuried },
            Event { t_s: ARREST_S, kind: EventKind::FirstArrest },
            Event { t_s: TURN_S, kind: EventKind::GreatestDisplacement },
        ],
        ledger: ledger(rigid),
        mechanism: MechanismLoad { peak_mount_n: Some(mount_n(scene)), ..MechanismLoad::default() },
        stack: None,
        plastic: None,
        cost: cost(rigid),
        omitted: vec!["damper", "stop", "spring power function", "obliquity"],
        warnings: Vec::new(),
    };
    if rigid {
        run.max_plate_displacement_m = Some(0.0);
        run.events.truncate(2);
    }
    if scene.plate.cocking_m > 0.0 {
        run.interface.demand_ratio = Some(2.9);
        run.warnings = vec![RunWarning::InterfacePush { ratio: 2.9, t_s: 0.4e-3 }];
    }
    if scene.target.thickness_m < 0.01 {
        perforate(&mut run, &shape);
    }
    run
}

fn perforate(run: &mut Run, shape: &Shape) {
    let exit_s = 180e-6;
    run.outcome = Outcome::Perforated;
    run.series = shape.series(200e-6);
    run.first_arrest = None;
    run.departure.residual_velocity_m_s = Some(41.3);
    run.departure.exit_time_s = Some(exit_s);
    run.penetration.final_m =
        Some(run.scene.target.thickness_m + run.scene.projectile.tip_radius_m);
    run.events = vec![
        Event { t_s: 90e-6, kind: EventKind::RearFace },
        Event { t_s: exit_s, kind: EventKind::Perforation },
    ];
}

fn ledger(rigid: bool) -> EnergyLedger {
    EnergyLedger {
        initial_kinetic_j: 147.5,
        spring_j: if rigid { 0.0 } else { 73.65 },
        penetration_j: if rigid { 147.5 } else { 73.85 },
        ..EnergyLedger::default()
    }
}

fn cost(rigid: bool) -> Cost {
    if rigid {
        Cost { method: "closed form", reason: "the mount is rigid", ..Cost::default() }
    } else {
        Cost {
            steps: 10,
            rejected: 0,
            rhs_evaluations: 10,
            method: "Radau IIA 17",
            reason: "one implicit method of high order: smooth, stiff and steep alike",
            ..Cost::default()
        }
    }
}
