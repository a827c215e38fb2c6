//! Studies: work of seconds that must not hold up the run of an edited scene. What there is when one is cancelled is kept.

use std::sync::Arc;
use std::time::Instant;

use super::quiet::Quiet;
use super::reporter::Reporter;
use super::searches::{self, Request};
use super::{Finding, ReportBody, Slot, clock};
use crate::model::scene::Scene;
use crate::study::accuracy::{self, Effort};
use crate::study::context::{Context, Progress};
use crate::study::stability::cases::Case;
use crate::study::stability::map::{self, Map};
use crate::study::stability::{self, Row};
use crate::study::{limit, thesis};

/// A study to make.
pub(super) struct Study<'a> {
    /// Of which scene.
    pub(super) scene: &'a Arc<Scene>,
    /// What it is of.
    pub(super) kind: &'a StudyKind,
    /// On how many threads, where it has several.
    pub(super) threads: usize,
}

/// What a study is of.
#[derive(Clone, Debug, PartialEq)]
pub enum StudyKind {
    /// Error against run time of every method.
    Accuracy(Effort),
    /// Where a fixed-step method is stable.
    Map(map::Method, map::Axis),
    /// The battery of stiff and extreme scenes; the study's own scene plays no part.
    Battery,
    /// Every claim of the thesis; the study's own scene plays no part.
    Thesis,
    /// The ballistic limit.
    Limit(limit::Effort),
    /// A search for designs.
    Search(Arc<Request>),
}

impl StudyKind {
    /// Whose result it is.
    pub(super) fn slot(&self) -> Slot {
        match self {
            Self::Accuracy(_) => Slot::Accuracy,
            Self::Map(..) => Slot::Map,
            Self::Battery => Slot::Battery,
            Self::Thesis => Slot::Claims,
            Self::Limit(_) => Slot::Limit,
            Self::Search(request) if **request == Request::Compare => Slot::Compare,
            Self::Search(_) => Slot::Search,
        }
    }
}

/// Make a study; measurements of run time have the machine to themselves.
pub(super) fn make(study: &Study<'_>, quiet: &Quiet, reporter: &Reporter<'_>) -> ReportBody {
    let cancel = reporter.cancel();
    if matches!(study.kind, StudyKind::Accuracy(_)) {
        quiet.begin(cancel);
        let body = reporter.finish(|| found(study, quiet, reporter));
        quiet.end();
        body
    } else {
        quiet.together(cancel, || reporter.finish(|| found(study, quiet, reporter)))
    }
}

fn found(study: &Study<'_>, quiet: &Quiet, reporter: &Reporter<'_>) -> Result<Finding, String> {
    let (scene, cancel) = (study.scene, reporter.cancel());
    match study.kind {
        StudyKind::Accuracy(effort) => {
            let mut shown = reporter
                .watch(|report: &accuracy::Report| Finding::Accuracy(Arc::new(report.clone())));
            let watch = &mut |progress: Progress, report: Option<&accuracy::Report>| {
                // Between two points others have their turn.
                quiet.end();
                quiet.begin(cancel);
                shown(progress, report)
            };
            let context = &mut Context::new(1, watch);
            accuracy::compare(scene, *effort, &mut clock::processor_s, context)
                .map(|report| Finding::Accuracy(Arc::new(report)))
                .map_err(|error| error.to_string())
        }
        StudyKind::Map(method, axis) => {
            map::accepts(scene).map_err(|error| error.to_string())?;
            let watch = &mut reporter.watch(|map: &Map| Finding::Map(Arc::new(map.clone())));
            let context = &mut Context::new(1, watch);
            let map = map::map(scene, (*method, *axis), map::CELLS, context);
            Ok(Finding::Map(Arc::new(map)))
        }
        StudyKind::Battery => {
            let started = Instant::now();
            // A run of an edited scene has its turn beside it.
            let (cases, threads) = (stability::battery(false), study.threads.min(2));
            battery(&cases, threads, &|| started.elapsed().as_secs_f64(), reporter)
        }
        StudyKind::Thesis => Ok(claims(study.threads, reporter)),
        StudyKind::Limit(effort) => {
            let watch = &mut |progress: Progress, _: Option<&()>| {
                reporter.tell(progress.done, progress.total, &|| None)
            };
            limit::find(scene, *effort, &mut Context::new(study.threads, watch))
                .map(|report| Finding::Limit(Arc::new(report)))
                .map_err(|error| error.to_string())
        }
        StudyKind::Search(request) => {
            let tell: searches::Tell<'_> = &mut |progress, part| {
                reporter.tell(progress.done, progress.total, &|| part().map(Finding::Search))
            };
            searches::make(scene, request, study.threads, tell).map(Finding::Search)
        }
    }
}

/// These scenes of the battery on so many threads.
fn battery(
    cases: &[&'static Case],
    threads: usize,
    now_s: &(dyn Fn() -> f64 + Sync),
    reporter: &Reporter<'_>,
) -> Result<Finding, String> {
    let watch =
        &mut reporter.watch(|rows: &[Row]| Finding::Battery(Arc::new(rows.to_vec()), false));
    let rows = stability::run(cases, now_s, &mut Context::new(threads, watch));
    let rows = rows.map_err(|error| error.to_string())?;
    let all = rows.len() == cases.len();
    Ok(Finding::Battery(Arc::new(rows), all))
}

/// The claims of the thesis on so many threads.
fn claims(threads: usize, reporter: &Reporter<'_>) -> Finding {
    let part = |rows: &[thesis::Row]| Finding::Thesis(Arc::new(rows.to_vec()), false);
    let rows = thesis::reproduce(&mut Context::new(threads, &mut reporter.watch(part)));
    let all = rows.len() == thesis::claims().len();
    Finding::Thesis(Arc::new(rows), all)
}

#[cfg(test)]
mod tests;
