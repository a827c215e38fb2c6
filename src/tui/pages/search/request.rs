//! What the Search tab asks for, and what is found.

use std::error::Error;
use std::sync::Arc;

use crate::model::scene::Scene;
use crate::study::context::Context;
use crate::study::monte_carlo;
use crate::study::search::front::{self, Front, Task};
use crate::study::search::seek::{self, Goal};
use crate::study::sensitivity;
use crate::study::sweep::Axis;
use crate::tui::pages::search::state::Page;
use crate::worker::Finding;
use crate::worker::reporter::Reporter;
use crate::worker::study::{Lane, Study};

/// What is looked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Which values of a variable give a wanted result.
    Seek(Goal),
    /// The designs that nothing beats.
    Front(Task),
    /// Which variables matter to a result.
    Sensitivity {
        /// The variables and their bounds.
        axes: Vec<Axis>,
        /// The result.
        output: String,
        /// How much is done.
        effort: sensitivity::Effort,
    },
    /// How results scatter when inputs do.
    MonteCarlo(monte_carlo::Task),
}

impl Request {
    /// The page that asks for it.
    pub fn page(&self) -> Page {
        match self {
            Self::Seek(_) => Page::Seek,
            Self::Front(_) => Page::Front,
            Self::Sensitivity { .. } => Page::Sensitivity,
            Self::MonteCarlo(_) => Page::MonteCarlo,
        }
    }
}

/// What was found.
#[derive(Clone, Debug)]
pub enum Answer {
    /// See [`Request::Seek`].
    Seek(seek::Report),
    /// See [`Request::Front`]; the first law's.
    Front(Box<Front>),
    /// See [`Request::Sensitivity`].
    Sensitivity(sensitivity::Report),
    /// See [`Request::MonteCarlo`].
    MonteCarlo(monte_carlo::Report),
}

impl Study for Request {
    fn lane(&self) -> Lane {
        Lane::Searches
    }

    fn make(&self, scene: &Arc<Scene>, reporter: &Reporter<'_>) -> Result<Finding, Box<dyn Error>> {
        let (threads, plain) = (reporter.threads(), &mut reporter.progress());
        let answer = match self {
            Self::Seek(goal) => {
                Answer::Seek(seek::seek(scene, goal, &mut Context::new(threads, plain))?)
            }
            Self::Front(task) => {
                let watch =
                    &mut reporter.watch(|front: &Front| Answer::Front(Box::new(front.clone())));
                let fronts = front::optimise(scene, task, &mut Context::new(threads, watch))?;
                let front = fronts.into_iter().next().ok_or("no interface law was given")?;
                Answer::Front(Box::new(front))
            }
            Self::Sensitivity { axes, output, effort } => {
                let context = &mut Context::new(threads, plain);
                let report = sensitivity::study(scene, axes.clone(), output, *effort, context)?;
                Answer::Sensitivity(report)
            }
            Self::MonteCarlo(task) => {
                let context = &mut Context::new(threads, plain);
                Answer::MonteCarlo(monte_carlo::sample(scene, task, context)?)
            }
        };
        Ok(Finding::new(answer))
    }
}
