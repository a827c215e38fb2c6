//! What a picture of the Explore tab has to compute.

use std::error::Error;
use std::sync::Arc;
use std::time::Duration;

use crate::model::scene::Scene;
use crate::study::context::Context;
use crate::study::sweep::grid::{self, GRID_COUNTS, Grid};
use crate::study::sweep::{Axis, Plan, SweepError};
use crate::tui::app::App;
use crate::tui::pages::explore::state::{Picture, has_family, sweep_of};
use crate::worker::Finding;
use crate::worker::reporter::Reporter;
use crate::worker::study::{Lane, Study, Tempo};

/// A sweep that ends before this shows nothing on the way: no picture is drawn twice for it.
const FIRST: Duration = Duration::from_millis(25);
/// Least time between two pictures of passes.
const BETWEEN_PASSES: Duration = Duration::from_millis(120);

/// Computes the points of a picture: coarse ones come first.
#[derive(Debug)]
pub struct PictureSweep {
    /// For which picture.
    pub picture: Picture,
    /// What is swept.
    pub plan: Arc<Plan>,
}

impl Study for PictureSweep {
    fn lane(&self) -> Lane {
        Lane::Sweeps
    }

    fn tempo(&self) -> Tempo {
        Tempo { first: FIRST, between: BETWEEN_PASSES }
    }

    fn make(&self, _: &Arc<Scene>, reporter: &Reporter<'_>) -> Result<Finding, Box<dyn Error>> {
        grid::fits(&self.plan)?;
        let grid = Grid::new(Arc::clone(&self.plan));
        let grid = grid.ok_or("a picture has one axis or two: take fewer axes")?;
        let watch = &mut |progress, pass: Option<&Grid>| {
            let pass = pass.filter(|grid| !grid.is_complete());
            reporter.tell(progress, &|| pass.map(|grid| Finding::new(grid.clone())))
        };
        let context = &mut Context::new(reporter.threads(), watch);
        Ok(Finding::new(grid.fill(grid::PIECE, context)))
    }
}

impl App {
    /// What a picture of the present scene would have to compute.
    ///
    /// # Errors
    /// [`SweepError`] when the axes do not fit the scene, or have more points than a screen keeps.
    pub fn sweep_plan(&self, picture: Picture) -> Result<Plan, SweepError> {
        self.sweep_plan_of(&self.scene, picture)
    }

    /// The same for another scene.
    ///
    /// # Errors
    /// As [`sweep_plan`](Self::sweep_plan).
    pub fn sweep_plan_of(&self, scene: &Scene, picture: Picture) -> Result<Plan, SweepError> {
        let sweep = sweep_of(scene);
        let axis = |at: usize| Axis::of(&sweep.axes[at], &GRID_COUNTS);
        let mut axes = vec![axis(0)?];
        match picture {
            Picture::Line if has_family(scene) => {
                let second = axis(1)?;
                let (name, ends) = (second.symbol(), second.ends());
                axes.push(Axis::new(
                    name,
                    ends,
                    self.pages.explore.visits.curves,
                    second.spacing(),
                )?);
            }
            Picture::Line => {}
            Picture::Surface => axes.push(axis(1)?),
        }
        let design = self.pages.explore.spread(picture).design(axes[0].count());
        let plan = Plan::new(scene, axes, design, &sweep.outputs)?;
        grid::fits(&plan).map(|()| plan)
    }
}
