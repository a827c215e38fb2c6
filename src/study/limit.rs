//! The ballistic limit: the least impact velocity that perforates, the velocity left beyond it, and how both scatter.
//!
//! Closed form for a plate that is rigid or free (model page, section 2); else a scan over the whole range of velocities, which also
//! tells where an outcome comes back, and bisection on the outcome. Must not know files, threads, screens or a clock.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::closed_form::Passage;
use crate::model::contact::Geometry;
use crate::model::contact_phase::Ending;
use crate::model::first_contact::first_contact;
use crate::model::impact::{Settings, follow, simulate};
use crate::model::mechanism::Mechanism;
use crate::model::run::{Outcome, Run};
use crate::model::scene::{ContactModel, InterfaceLaw, Mount, Scene};
use crate::model::units::fixed_significant;
use crate::model::variables::{self, VariableError};
use crate::numerics::smaller;
use crate::study::compare::{Load, outcome, residual_m_s};
use fit::{LambertJonas, RechtIpson};
use scatter::{Scatter, Scattering};

mod at_limit;
pub mod fit;
pub mod scatter;
pub mod words;

pub use at_limit::Closures;

/// Velocities that are looked at, m/s: no limit beyond them is given, by closed form or by outcome.
pub const RANGE_M_S: (f64, f64) = (1.0, 3e3);
/// Points of the scan over them, at equal ratios.
const SCAN: usize = 41;
/// Relative width to which the limit is closed in.
const WIDTH: f64 = 1e-10;
/// Undecided shots, each followed for about a second, that are spent on each edge of the velocities that no run decides, and the
/// relative width of those up to which they are one limit for any purpose.
const UNDECIDED_MAX: usize = 8;
const ONE_POINT: f64 = 1e-8;
/// Where the outcomes on either side of a limit are looked at, relative to it: all below are stopped and all above perforate, or it
/// is no single limit.
const BESIDE: [f64; 7] = [1e-7, 1e-5, 1e-3, 1e-2, 0.05, 0.15, 0.3];
/// How often a lower limit may be found beside one.
const LOWER_MAX: usize = 4;
/// The runs' tolerance, at the most.
const TOLERANCE: f64 = 1e-10;
/// Shots of the curve below and above the limit, and the range they cover, over the limit.
const BELOW: usize = 6;
const ABOVE: usize = 24;
const CURVE: (f64, f64) = (0.5, 2.5);

/// How far oblique limits come out below the measured ones, by what `cmra validate` finds for a hard core on aluminium:
/// obliquity in degrees, percent.
pub const OBLIQUE_SHORTFALL: [(f64, f64); 3] = [(15.0, 4.0), (30.0, 9.0), (45.0, 16.0)];

/// How the limit is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// Closed form: nothing but inertia, or a rigid mount, answers the shot.
    ClosedForm,
    /// Bisection on the outcome of runs.
    Outcome,
}

impl Basis {
    /// A short text.
    pub fn words(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::Outcome => "bisection on the outcome",
        }
    }
}

/// What counts as a perforation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Criterion {
    /// The nose is clear of the rear face: complete passage, as the navy criterion has it.
    #[default]
    Passage,
    /// The nose stands out of the rear face: the army criterion.
    Protrusion,
}

impl Criterion {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Passage, Self::Protrusion];

    /// The word on the command line and in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Passage => "passage",
            Self::Protrusion => "protrusion",
        }
    }

    /// A short text.
    pub fn label(self) -> &'static str {
        match self {
            Self::Passage => {
                "complete passage: the nose is clear of the rear face (navy criterion)"
            }
            Self::Protrusion => "protrusion: the nose stands out of the rear face (army criterion)",
        }
    }
}

/// Whether there is a limit, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// It is this.
    Found {
        /// The limit velocity, m/s.
        velocity_m_s: f64,
        /// How it is known.
        basis: Basis,
        /// A faster shot that is stopped again, where there is one, m/s: there is no single limit then.
        stopped_at_m_s: Option<f64>,
    },
    /// It lies between two velocities: runs between them end undecided, however long they are followed.
    Between {
        /// The fastest shot below that is known to be stopped, m/s.
        stopped_m_s: Option<f64>,
        /// The slowest shot above that is known to perforate, m/s.
        perforated_m_s: Option<f64>,
    },
    /// Nothing in range perforates.
    Never,
    /// Everything in range perforates.
    Always,
    /// Stopped before it was found.
    Unknown,
}

impl Limit {
    /// The limit velocity, m/s, where there is one.
    pub fn velocity_m_s(self) -> Option<f64> {
        match self {
            Self::Found { velocity_m_s, .. } => Some(velocity_m_s),
            Self::Between { .. } | Self::Never | Self::Always | Self::Unknown => None,
        }
    }

    /// Between which velocities it lies where runs do not decide it, m/s: the one that is stopped and the one that perforates.
    pub fn bracket_m_s(self) -> (Option<f64>, Option<f64>) {
        match self {
            Self::Between { stopped_m_s, perforated_m_s } => (stopped_m_s, perforated_m_s),
            Self::Found { .. } | Self::Never | Self::Always | Self::Unknown => (None, None),
        }
    }

    /// Why there is none.
    pub fn absence(self) -> Option<String> {
        let (low, high) = RANGE_M_S;
        match self {
            Self::Found { .. } => None,
            Self::Between { stopped_m_s, perforated_m_s } => Some(format!(
                "limit not decided: it lies above {} and below {}; runs between these velocities still oscillate when they end",
                edge(stopped_m_s, "stopped", low),
                edge(perforated_m_s, "perforated", high),
            )),
            Self::Never => Some(format!(
                "limit beyond {high} m/s: nothing from {low} to {high} m/s perforates"
            )),
            Self::Always => {
                Some(format!("no limit: everything from {low} to {high} m/s perforates"))
            }
            Self::Unknown => Some("stopped before the limit was found".to_owned()),
        }
    }

    /// What measurements say against this limit of a scene: an oblique one comes out low. `None` along the plate's normal, or
    /// without a limit.
    pub fn caution(self, scene: &Scene) -> Option<String> {
        let is_oblique = scene.projectile.obliquity_deg > 0.0;
        self.velocity_m_s().filter(|_| is_oblique)?;
        let known: Vec<String> = OBLIQUE_SHORTFALL
            .iter()
            .map(|(degrees, percent)| format!("{percent} % at {degrees} deg"))
            .collect();
        let known = known.join(", ");
        Some(format!("oblique limits come out below measured ones: {known} (cmra validate)"))
    }
}

/// A velocity with what happens at it, or the end of the range.
fn edge(velocity_m_s: Option<f64>, what: &str, end_m_s: f64) -> String {
    velocity_m_s.map_or_else(
        || format!("{end_m_s} m/s (end of the range)"),
        |velocity_m_s| format!("{} m/s ({what})", fixed_significant(velocity_m_s, 6)),
    )
}

/// What a shot tells of the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    Perforated,
    Stopped,
    /// Its run ended before that was decided.
    Undecided,
}

impl Verdict {
    /// A shot that has no energy left to go through is stopped, whether it is arrested or may still leave the way it came.
    /// In a stack the last plate that is struck decides; what protrudes from one before the base plate does not count.
    fn of(run: &Run, criterion: Criterion) -> Self {
        if let Some(stack) = &run.stack {
            let is_base = stack.behind.len() == stack.elements;
            let criterion = if is_base { criterion } else { Criterion::Passage };
            return match stack.behind.last() {
                _ if stack.outcome == Outcome::Separated => Self::Stopped,
                Some(last) => Self::of_plate(last, criterion),
                None => Self::of_plate(run, criterion),
            };
        }
        Self::of_plate(run, criterion)
    }

    fn of_plate(run: &Run, criterion: Criterion) -> Self {
        let thickness_m = match criterion {
            Criterion::Passage => f64::INFINITY,
            Criterion::Protrusion => run.scene.effective_thickness_m(),
        };
        let sure_m = run.final_penetration_m.or(run.at_least.penetration_m);
        let most_m = run.final_penetration_m.or(run.penetration_at_most_m);
        if run.outcome == Outcome::Perforated || sure_m.is_some_and(|depth| depth > thickness_m) {
            return Self::Perforated;
        }
        match run.outcome {
            Outcome::Arrested | Outcome::Separated | Outcome::Perforated => Self::Stopped,
            Outcome::Moving if most_m.is_some_and(|depth| depth <= thickness_m) => Self::Stopped,
            Outcome::Moving => Self::Undecided,
        }
    }
}

/// One shot of the residual-velocity curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shot {
    /// Impact velocity, m/s.
    pub impact_m_s: f64,
    /// What became of it.
    pub outcome: Outcome,
    /// Projectile velocity after perforation, m/s.
    pub residual_m_s: Option<f64>,
}

/// What is asked for beyond the limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// What counts as a perforation.
    pub criterion: Criterion,
    /// Scatter of the inputs; `None`: not asked for.
    pub scattering: Option<Scattering>,
}

/// The limit of a scene and all that goes with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The scene.
    pub scene: Arc<Scene>,
    /// What counts as a perforation.
    pub criterion: Criterion,
    /// The limit.
    pub limit: Limit,
    /// What a shot just below the limit asks of the mechanism and its mount; `None` without a limit.
    pub load: Option<Load>,
    /// The limits by both closures, where the flow strength comes from a yield stress.
    pub closures: Option<Closures>,
    /// The curve, in order of velocity.
    pub shots: Vec<Shot>,
    /// Recht and Ipson's law through the curve.
    pub recht_ipson: Option<RechtIpson>,
    /// Lambert and Jonas's law through the curve.
    pub lambert_jonas: Option<LambertJonas>,
    /// The limit under scatter of the inputs.
    pub scatter: Option<Scatter>,
    /// Whether it was done to its end.
    pub is_complete: bool,
}

impl Report {
    /// How far the limit lies above the scene's own velocity, relative to that: negative where the shot perforates.
    pub fn margin(&self) -> Option<f64> {
        let velocity = self.limit.velocity_m_s()?;
        Some(velocity / self.scene.projectile.velocity_m_s - 1.0)
    }

    /// What is to be said against the limit; see [`Limit::caution`].
    pub fn caution(&self) -> Option<String> {
        self.limit.caution(&self.scene)
    }
}

/// Asked before each shot, and now and then within a long one, with the shots done and about how many there are; `Break` stops,
/// and keeps what there is.
pub type Watch<'a> = &'a mut dyn FnMut(usize, usize) -> ControlFlow<()>;

/// Find the limit of a scene, its residual-velocity curve, and the scatter asked for.
///
/// # Errors
/// A [`VariableError`] when the scene makes no physical sense.
pub fn find(scene: &Arc<Scene>, effort: Effort, watch: Watch<'_>) -> Result<Report, VariableError> {
    variables::validate(scene)?;
    let samples = effort.scattering.map_or(0, |scattering| scattering.samples);
    let mut range =
        Range::new(scene, SCAN + 40 + 2 * BESIDE.len() + BELOW + ABOVE + samples, watch);
    range.criterion = effort.criterion;
    let limit = range.whole_limit();
    let mut report = Report {
        scene: Arc::clone(scene),
        criterion: effort.criterion,
        limit,
        load: None,
        closures: None,
        shots: range.curve(limit),
        recht_ipson: None,
        lambert_jonas: None,
        scatter: None,
        is_complete: true,
    };
    if let Some(velocity_m_s) = limit.velocity_m_s() {
        report.load = range.load(velocity_m_s);
        report.closures = range.closures();
        let perforated: Vec<(f64, f64)> = report
            .shots
            .iter()
            .filter_map(|shot| Some((shot.impact_m_s, shot.residual_m_s?)))
            .collect();
        report.recht_ipson = RechtIpson::through(&perforated, velocity_m_s);
        report.lambert_jonas = LambertJonas::through(&perforated);
        if let Some(scattering) = effort.scattering {
            report.scatter = scatter::scatter(scene, scattering, velocity_m_s, &mut range);
        }
    }
    report.is_complete = !range.stopped;
    Ok(report)
}

/// The limit of a scene and nothing else.
///
/// # Errors
/// As [`find`].
pub fn alone(scene: &Arc<Scene>, watch: Watch<'_>) -> Result<Limit, VariableError> {
    variables::validate(scene)?;
    Ok(Range::new(scene, SCAN + 40 + 2 * BESIDE.len(), watch).whole_limit())
}

/// Steps of a shot between two questions whether to go on.
const LOOK: usize = 64;

/// The firing range: shots at a scene, counted.
struct Range<'s, 'w> {
    scene: &'s Arc<Scene>,
    criterion: Criterion,
    watch: Watch<'w>,
    done: usize,
    total: usize,
    stopped: bool,
}

impl<'s, 'w> Range<'s, 'w> {
    fn new(scene: &'s Arc<Scene>, total: usize, watch: Watch<'w>) -> Self {
        let criterion = Criterion::default();
        Self { scene, criterion, watch, done: 0, total, stopped: false }
    }

    /// Whether to go on with the next piece of work.
    fn goes_on(&mut self) -> bool {
        if !self.stopped {
            let most = if self.done < self.total { self.done } else { self.total };
            self.stopped = (self.watch)(most, self.total).is_break();
            self.done += 1;
        }
        !self.stopped
    }

    /// A shot at this velocity, followed until it is decided; `None` when stopped.
    fn shoot(&mut self, impact_m_s: f64) -> Option<(Shot, Verdict)> {
        if !self.goes_on() {
            return None;
        }
        let (done, total, watch) = (self.done.min(self.total), self.total, &mut *self.watch);
        let (mut steps, mut stopped) = (0_usize, false);
        let shot = shoot(self.scene, self.criterion, impact_m_s, &mut |_t_s| {
            steps += 1;
            // A run on the plastic law may have millions of steps.
            stopped = stopped || (steps.is_multiple_of(LOOK) && watch(done, total).is_break());
            if stopped { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        self.stopped = stopped;
        (!stopped).then_some(shot)
    }

    /// Whether a shot goes through; `None` when stopped. What is fused at the first arrest stays: there the first contact alone
    /// decides.
    fn verdict(&mut self, impact_m_s: f64) -> Option<Verdict> {
        let scene = self.scene;
        let decided = scene.interface.law == InterfaceLaw::Fused
            && scene.contact.model == ContactModel::Hydrodynamic
            && scene.stack.base_thickness_m.is_none();
        if decided {
            if !self.goes_on() {
                return None;
            }
            if let Ok(end) = first_contact(&aimed(scene, impact_m_s)) {
                let out = self.criterion == Criterion::Protrusion
                    && end.depth_m > scene.effective_thickness_m();
                let through = out || end.ending == Ending::Perforation;
                return Some(if through { Verdict::Perforated } else { Verdict::Stopped });
            }
        }
        Some(self.shoot(impact_m_s)?.1)
    }

    /// What a shot just below a limit asks of the mechanism; `None` when stopped.
    fn load(&mut self, limit_m_s: f64) -> Option<Load> {
        let (done, total) = (self.done.min(self.total), self.total);
        let scene = self.scene;
        self.goes_on()
            .then(|| at_limit::load(scene, limit_m_s, &mut || (self.watch)(done, total)))?
    }

    /// The limits by both closures; `None` where there is but one, or when stopped.
    fn closures(&mut self) -> Option<Closures> {
        let (done, total) = (self.done.min(self.total), self.total);
        let scene = self.scene;
        self.goes_on().then(|| Closures::of(scene, &mut |_, _| (self.watch)(done, total)))?
    }

    /// The limit within a range, looked for with so many points, to a relative width.
    fn limit(&mut self, (low, high): (f64, f64), points: usize, width: f64) -> Limit {
        let by_passage = self.criterion == Criterion::Passage;
        if let Some(velocity_m_s) = closed_form(self.scene).filter(|_| by_passage) {
            // No strength, no limit.
            return if velocity_m_s <= 0.0 {
                Limit::Always
            } else if velocity_m_s <= RANGE_M_S.1 {
                Limit::Found { velocity_m_s, basis: Basis::ClosedForm, stopped_at_m_s: None }
            } else {
                Limit::Never
            };
        }
        self.search((low, high), points, width).unwrap_or(Limit::Unknown)
    }

    /// The limit over all velocities, with a look at the outcomes on either side of it.
    fn whole_limit(&mut self) -> Limit {
        let mut limit = self.limit(RANGE_M_S, SCAN, WIDTH);
        for _ in 0..LOWER_MAX {
            let Limit::Found { velocity_m_s, basis: Basis::Outcome, stopped_at_m_s } = limit else {
                break;
            };
            let Some(beside) = self.beside(velocity_m_s, stopped_at_m_s) else {
                return Limit::Unknown;
            };
            if beside == limit {
                break;
            }
            limit = beside;
        }
        limit
    }

    /// What a limit is after shots on either side of it: a lower one, where one below perforates; no single one, where one above is
    /// stopped.
    fn beside(&mut self, limit_m_s: f64, stopped_at_m_s: Option<f64>) -> Option<Limit> {
        let mut stopped_m_s = None;
        for part in BESIDE.iter().rev() {
            let velocity_m_s = limit_m_s * (1.0 - part);
            match self.verdict(velocity_m_s)? {
                Verdict::Stopped => stopped_m_s = Some(velocity_m_s),
                Verdict::Undecided => {
                    let lower_m_s = stopped_m_s.unwrap_or(RANGE_M_S.0);
                    return self.between(lower_m_s, velocity_m_s, Some(limit_m_s));
                }
                Verdict::Perforated => {
                    let lower_m_s = stopped_m_s.unwrap_or(RANGE_M_S.0);
                    return self.closed_in(lower_m_s, velocity_m_s, WIDTH, Some(limit_m_s));
                }
            }
        }
        let mut again_m_s = stopped_at_m_s;
        for part in BESIDE {
            let velocity_m_s = limit_m_s * (1.0 + part);
            if again_m_s.is_none_or(|again_m_s| velocity_m_s < again_m_s)
                && self.verdict(velocity_m_s)? == Verdict::Stopped
            {
                again_m_s = Some(velocity_m_s);
            }
        }
        let basis = Basis::Outcome;
        Some(Limit::Found { velocity_m_s: limit_m_s, basis, stopped_at_m_s: again_m_s })
    }

    /// The limit between a shot that is stopped and one that perforates.
    fn closed_in(
        &mut self,
        stopped_m_s: f64,
        through_m_s: f64,
        width: f64,
        stopped_at_m_s: Option<f64>,
    ) -> Option<Limit> {
        let (mut stopped, mut through) = (stopped_m_s, through_m_s);
        while through - stopped > width * stopped {
            let middle = 0.5 * (stopped + through);
            match self.verdict(middle)? {
                Verdict::Perforated => through = middle,
                Verdict::Stopped => stopped = middle,
                Verdict::Undecided => return self.between(stopped, middle, Some(through)),
            }
        }
        let velocity_m_s = 0.5 * (stopped + through);
        Some(Limit::Found { velocity_m_s, basis: Basis::Outcome, stopped_at_m_s })
    }

    /// The limit on both sides of a shot that is not decided: from either side as close to it as shots are decided.
    fn between(
        &mut self,
        stopped_m_s: f64,
        undecided_m_s: f64,
        through_m_s: Option<f64>,
    ) -> Option<Limit> {
        let (mut stopped, mut above) = (stopped_m_s, undecided_m_s);
        let mut undecided = 0;
        while above - stopped > WIDTH * stopped && undecided < UNDECIDED_MAX {
            let middle = 0.5 * (stopped + above);
            let verdict = self.verdict(middle)?;
            undecided += usize::from(verdict == Verdict::Undecided);
            if verdict == Verdict::Stopped { stopped = middle } else { above = middle }
        }
        let (mut below, mut through, mut undecided) = (undecided_m_s, through_m_s, 0);
        while let Some(perforated) = through.filter(|it| it - below > WIDTH * below)
            && undecided < UNDECIDED_MAX
        {
            let middle = 0.5 * (below + perforated);
            let verdict = self.verdict(middle)?;
            undecided += usize::from(verdict == Verdict::Undecided);
            if verdict == Verdict::Perforated { through = Some(middle) } else { below = middle }
        }
        if let Some(through) = through.filter(|through| through - stopped <= ONE_POINT * stopped) {
            let (velocity_m_s, basis) = (0.5 * (stopped + through), Basis::Outcome);
            return Some(Limit::Found { velocity_m_s, basis, stopped_at_m_s: None });
        }
        let stopped_m_s = (stopped > RANGE_M_S.0).then_some(stopped);
        Some(Limit::Between { stopped_m_s, perforated_m_s: through })
    }

    fn search(&mut self, (low, high): (f64, f64), points: usize, width: f64) -> Option<Limit> {
        let ratio = (high / low).powf(1.0 / (points - 1) as f64);
        let mut scan = Vec::new();
        for point in 0..points {
            let velocity = low * ratio.powf(point as f64);
            scan.push((velocity, self.verdict(velocity)?));
        }
        let first = scan.iter().position(|point| point.1 == Verdict::Perforated);
        let below = &scan[..first.unwrap_or(scan.len())];
        if let Some(undecided) = below.iter().position(|point| point.1 == Verdict::Undecided) {
            let stopped_m_s = if undecided > 0 { scan[undecided - 1].0 } else { low };
            return self.between(stopped_m_s, scan[undecided].0, first.map(|first| scan[first].0));
        }
        let Some(first) = first else { return Some(Limit::Never) };
        if first == 0 {
            // What is stopped only above a range in which everything perforates has no limit velocity either.
            return Some(Limit::Always);
        }
        let later = scan[first..].iter().find(|point| point.1 == Verdict::Stopped);
        let stopped_at_m_s = later.map(|point| point.0);
        self.closed_in(scan[first - 1].0, scan[first].0, width, stopped_at_m_s)
    }

    /// Shots on either side of the limit, denser above it, or over the whole range.
    fn curve(&mut self, limit: Limit) -> Vec<Shot> {
        let velocities: Vec<f64> = match limit {
            Limit::Found { velocity_m_s, .. } => {
                let (from, to) = CURVE;
                let share = |i: usize, n: usize| i as f64 / n as f64;
                let below = (0..BELOW).map(|i| from + (1.0 - from) * share(i, BELOW));
                // The curve is steepest at the limit.
                let above = (1..=ABOVE).map(|i| 1.0 + (to - 1.0) * share(i, ABOVE).powi(2));
                below.chain(above).map(|times| times * velocity_m_s).collect()
            }
            Limit::Between { .. } | Limit::Never | Limit::Always => {
                let (low, high): (f64, f64) = RANGE_M_S;
                let step = (high / low).powf(1.0 / ABOVE as f64);
                (0..=ABOVE).map(|i| low * step.powf(i as f64)).collect()
            }
            Limit::Unknown => Vec::new(),
        };
        velocities.into_iter().map_while(|velocity| Some(self.shoot(velocity)?.0)).collect()
    }
}

/// The scene with another impact velocity.
fn aimed(scene: &Scene, impact_m_s: f64) -> Arc<Scene> {
    let mut own = scene.clone();
    own.projectile.velocity_m_s = impact_m_s;
    own.run.tolerance = smaller(own.run.tolerance, TOLERANCE);
    Arc::new(own)
}

/// A shot at a scene with another impact velocity; one that is left undecided is followed for longer.
fn shoot(
    scene: &Scene,
    criterion: Criterion,
    impact_m_s: f64,
    observer: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> (Shot, Verdict) {
    let settings = Settings { series: false, estimate: false };
    let own = aimed(scene, impact_m_s);
    let mut run = simulate(&own, &settings, observer);
    if run
        .as_ref()
        .is_ok_and(|run| run.stack.is_none() && Verdict::of(run, criterion) == Verdict::Undecided)
    {
        run = follow(&own, observer);
    }
    // The scene has been found valid, and so is any velocity above zero.
    run.map_or(
        (Shot { impact_m_s, outcome: Outcome::Moving, residual_m_s: None }, Verdict::Undecided),
        |run| {
            let (outcome, residual_m_s) = (outcome(&run), residual_m_s(&run));
            (Shot { impact_m_s, outcome, residual_m_s }, Verdict::of(&run, criterion))
        },
    )
}

/// The limit velocity of a rigid or free plate under the hydrodynamic force, m/s; `None` where a mechanism acts or another
/// model is asked for.
pub fn closed_form(scene: &Scene) -> Option<f64> {
    let mechanism = &scene.mechanism;
    let rigid = scene.plate.mount == Mount::Rigid;
    let acts = !Mechanism::of(scene).is_absent() || mechanism.stop.position_m.is_some();
    let is_stack = scene.stack.base_thickness_m.is_some();
    if (acts && !rigid) || is_stack || scene.contact.model != ContactModel::Hydrodynamic {
        return None;
    }
    let geometry = Geometry::of(scene);
    let passage = Passage::unsprung(scene, &geometry, !rigid);
    Some(passage.limit_velocity_m_s())
}

#[cfg(test)]
mod tests;
