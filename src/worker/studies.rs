//! Requests to the worker and their results: runs, and studies of many runs.

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use super::reporter::{BETWEEN, ReportInterval, Reporter};
use super::{Slot, clock, runs};
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_studies::study::accuracy::{self, ComparisonOptions};
use cmra_studies::study::compare::map::{Map as EfficiencyMap, default_axes};
use cmra_studies::study::compare::{self, Hardware};
use cmra_studies::study::context::{Context, Progress, Threads};
use cmra_studies::study::search::{front, seek};
use cmra_studies::study::stability::map::{self, Map as StabilityCells, StabilityMapRequest};
use cmra_studies::study::sweep::grid::{self, Grid};
use cmra_studies::study::sweep::{Plan, StudyError};
use cmra_studies::study::{limit, monte_carlo, sensitivity, stability, thesis};

/// Defines an enum with one variant per type, and a trait that converts between the enum and these types.
macro_rules! typed_enum {
    ($(#[$doc:meta])* $name:ident, $(#[$about:meta])* $of:ident: $($kind:ident($type:ty),)*) => {
        $(#[$doc])*
        #[derive(Clone, Debug)]
        pub enum $name {
            $($kind(Arc<$type>),)*
        }

        $(#[$about])*
        pub trait $of: Sized + 'static {
            /// Returns the value if it has this type.
            fn downcast(one: &$name) -> Option<&Arc<Self>>;
        }

        $(
            impl From<$type> for $name {
                fn from(it: $type) -> Self {
                    Self::$kind(Arc::new(it))
                }
            }

            impl From<Arc<$type>> for $name {
                fn from(it: Arc<$type>) -> Self {
                    Self::$kind(it)
                }
            }

            impl $of for $type {
                fn downcast(one: &$name) -> Option<&Arc<Self>> {
                    if let $name::$kind(it) = one { Some(it) } else { None }
                }
            }
        )*
    };
}

typed_enum! {
    /// Request of a task.
    StudyRequest,
    /// Type of the content of a [`StudyRequest`].
    RequestVariant:
    Run(SceneRun),
    Picture(PictureSweep),
    Printed(PrintedSweep),
    Limit(LimitSearch),
    Spread(V50Study),
    EqualMass(MassComparison),
    EfficiencyMap(EfficiencyMapStudy),
    Measurements(MethodBenchmark),
    StabilityMap(StabilityMap),
    StiffScenes(StiffScenes),
    Claims(Claims),
    Search(SearchRequest),
}

typed_enum! {
    /// Final or partial result of a task.
    StudyResult,
    /// Type of the content of a [`StudyResult`].
    ResultVariant:
    Run(Run),
    Grid(Grid),
    Limit(limit::LimitReport),
    Spread(monte_carlo::MonteCarloReport),
    Comparison(compare::ComparisonReport),
    EfficiencyMap(EfficiencyMap),
    Measurements(accuracy::AccuracyReport),
    StabilityMap(StabilityCells),
    StiffScenes(Vec<stability::Row>),
    Claims(Vec<thesis::Row>),
    Search(SearchAnswer),
}

/// Time before the first partial result of a sweep; a shorter sweep sends its final result only.
const FIRST: Duration = Duration::from_millis(25);
/// Minimum interval between two partial results of a sweep.
const BETWEEN_PASSES: Duration = Duration::from_millis(120);

/// Chart of a sweep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ChartKind {
    /// Sweep of one axis, with or without a family of curves.
    #[default]
    Line,
    /// Map over two axes.
    Surface,
}

/// Run of a scene: that on the screen, or a pinned one.
#[derive(Debug)]
pub struct SceneRun(pub Slot);

/// Computes the points of a chart, coarse grids first.
#[derive(Debug)]
pub struct PictureSweep {
    pub picture: ChartKind,
    pub plan: Arc<Plan>,
}

/// Computes the curves of a figure with the fixed-step scheme of the thesis, which the plan selects.
#[derive(Debug)]
pub struct PrintedSweep(pub Arc<Plan>);

/// Finds the ballistic limit.
#[derive(Debug, PartialEq)]
pub struct LimitSearch;

/// Computes V50 and its spread, as `cmra montecarlo --outputs limit_velocity_m_s` does.
#[derive(Debug, PartialEq)]
pub struct V50Study(pub monte_carlo::Request);

/// Compares the scene with a solid plate and other candidates of equal areal mass.
#[derive(Debug)]
pub struct MassComparison;

/// Maps the mass efficiency around the scene: over impact velocity and mass ratio, or the variable that sets the mass of the plate instead.
#[derive(Debug)]
pub struct EfficiencyMapStudy;

/// Measures error and run time of every method.
#[derive(Debug)]
pub struct MethodBenchmark(pub ComparisonOptions);

/// Maps the stability of a method with a fixed step size.
#[derive(Debug, PartialEq)]
pub struct StabilityMap(pub StabilityMapRequest);

/// Runs the stiff and extreme test scenes; independent of the edited scene.
#[derive(Debug)]
pub struct StiffScenes;

/// Checks every claim of the thesis; independent of the edited scene.
#[derive(Debug)]
pub struct Claims;

impl StudyRequest {
    /// Returns the intervals of partial results.
    pub(super) fn tempo(&self) -> ReportInterval {
        match self {
            Self::Picture(_) | Self::EfficiencyMap(_) => {
                ReportInterval { first: FIRST, between: BETWEEN_PASSES }
            }
            _ => ReportInterval { first: BETWEEN, between: BETWEEN },
        }
    }

    /// Computes the result; a stopped study returns its partial result.
    pub(super) fn make(
        &self,
        scene: &Arc<Scene>,
        reporter: &Reporter<'_>,
    ) -> Result<StudyResult, Box<dyn Error>> {
        let threads = reporter.threads.clone();
        Ok(match self {
            Self::Run(request) => runs::of_scene(request.0, scene, reporter)?,
            Self::Picture(request) => fill(&request.plan, reporter)?,
            Self::Printed(request) => fill(&request.0, reporter)?,
            Self::Limit(_) => {
                let watch = &mut reporter.progress();
                limit::find(scene, &mut Context::new(threads, watch))?.into()
            }
            Self::Spread(request) => {
                let watch = &mut reporter.watch(monte_carlo::MonteCarloReport::clone);
                monte_carlo::run(scene, &request.0, &mut Context::new(threads, watch))?.into()
            }
            Self::EqualMass(_) => {
                let watch = &mut reporter.progress();
                compare::compare(scene, Hardware::default(), &mut Context::new(threads, watch))?
                    .into()
            }
            Self::EfficiencyMap(_) => {
                let axes = default_axes(scene).ok_or("no map over v_i and the plate's size")?;
                let watch = &mut reporter.watch(EfficiencyMap::clone);
                let context = &mut Context::new(threads, watch);
                EfficiencyMap::compute(scene, &axes, Hardware::default(), context)?.into()
            }
            Self::Measurements(request) => {
                let watch = &mut reporter.watch(accuracy::AccuracyReport::clone);
                // Further threads would disturb the measured times.
                let context = &mut Context::new(1, watch);
                accuracy::compare(scene, request.0, &mut clock::processor_s, context)?.into()
            }
            Self::StabilityMap(request) => {
                map::accepts(scene)?;
                let watch = &mut reporter.watch(StabilityCells::clone);
                map::map(scene, request.0, &mut Context::new(1, watch))?.into()
            }
            Self::StiffScenes(_) => {
                let cases = stability::battery(false);
                let watch = &mut reporter.watch(<[stability::Row]>::to_vec);
                let context = &mut Context::new(threads.at_most(2), watch);
                stability::run(&cases, &reporter.clock(), context)?.into()
            }
            Self::Claims(_) => {
                let watch = &mut reporter.watch(<[thesis::Row]>::to_vec);
                thesis::reproduce(&mut Context::new(threads, watch)).into()
            }
            Self::Search(request) => {
                let tell = |progress, part: &dyn Fn() -> Option<StudyResult>| {
                    reporter.report_progress(progress, part)
                };
                request.run(scene, threads, &tell)?.into()
            }
        })
    }
}

/// Computes the points of a plan, pass by pass; the last pass is the final result.
fn fill(plan: &Arc<Plan>, reporter: &Reporter<'_>) -> Result<StudyResult, Box<dyn Error>> {
    grid::fits(plan)?;
    let grid = Grid::new(Arc::clone(plan));
    let grid = grid.ok_or("a chart has one axis and a map two: use fewer axes")?;
    let watch = &mut |progress, pass: Option<&Grid>| {
        let pass = pass.filter(|grid| !grid.is_complete());
        reporter.report_progress(progress, &|| pass.map(|grid| grid.clone().into()))
    };
    Ok(grid.fill(grid::PIECE, &mut Context::new(reporter.threads.clone(), watch)).into())
}

/// Defines requests and results of the Search tab from a list: variant, module of the study (and of its page), and report type.
macro_rules! search_studies {
    ($($(#[$doc:meta])* $kind:ident $study:ident $report:ident,)*) => {
        /// Request of a search.
        #[derive(Clone, Debug, PartialEq)]
        pub enum SearchRequest {
            $($(#[$doc])* $kind($study::Request),)*
        }

        #[derive(Clone, Debug)]
        pub enum SearchAnswer {
            $($kind(Box<$study::$report>),)*
        }

        impl SearchRequest {
            /// Returns the command with the same result: its name and options.
            pub fn command(&self) -> String {
                match self {
                    $(Self::$kind(request) => request.to_string(),)*
                }
            }

            /// Runs the search on a number of threads; `tell` receives progress and partial results.
            pub fn run(
                &self,
                scene: &Scene,
                threads: impl Into<Threads>,
                tell: &dyn Fn(Progress, &dyn Fn() -> Option<StudyResult>) -> ControlFlow<()>,
            ) -> Result<SearchAnswer, StudyError> {
                match self {
                    $(Self::$kind(request) => {
                        let answer = |report| SearchAnswer::$kind(Box::new(report));
                        let watch = &mut |progress, part: Option<&$study::$report>| {
                            tell(progress, &|| Some(answer(part?.clone()).into()))
                        };
                        $study::run(scene, request, &mut Context::new(threads, watch)).map(answer)
                    })*
                }
            }
        }
    };
}
search_studies! {
    /// Goal seek: values of a variable for which a quantity reaches a goal.
    Seek seek SeekReport,
    /// Pareto front: designs that no other design dominates.
    Front front FrontReport,
    /// Sensitivity of a quantity to each variable.
    Sensitivity sensitivity SensitivityReport,
    /// Distribution of results for random inputs.
    MonteCarlo monte_carlo MonteCarloReport,
}
