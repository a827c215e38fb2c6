//! What a picture of the Sweep or Surface tab has to compute.

use crate::model::scene::Scene;
use crate::study::sweep::grid::{self, GRID_COUNTS};
use crate::study::sweep::{Axis, Plan, SweepError};
use crate::tui::app::App;
use crate::tui::pages::explore::state::{Picture, has_family, sweep_of};

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
                axes.push(Axis::new(name, ends, self.sweeping.visits.curves, second.spacing())?);
            }
            Picture::Line => {}
            Picture::Surface => axes.push(axis(1)?),
        }
        let design = self.sweeping.spread(picture).design(axes[0].count());
        let plan = Plan::new(scene, axes, design, &sweep.outputs)?;
        grid::fits(&plan).map(|()| plan)
    }
}
