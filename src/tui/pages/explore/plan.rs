//! The plan of a chart or map of the Explore tab.

use crate::model::run::Outcome;
use crate::model::scene::ContactModel;
use crate::study::sweep::grid::{self, GRID_COUNTS, Grid};
use crate::study::sweep::{Axis, Plan, PointOutcome, SweepError};
use crate::tui::pages::explore::state::{Picture, has_family, sweep_of};
use crate::tui::pages::prelude::*;

impl App {
    /// The plan of a figure's curves by the scheme that the thesis prints; `None` where the scene is no figure, or drawn by it.
    pub(crate) fn printed_plan(&self) -> Option<Plan> {
        let is_figure = self.base.name.starts_with("figure-") && self.picture() == Picture::Line;
        if !is_figure || self.scene.contact.model != ContactModel::Hydrodynamic {
            return None;
        }
        let mut scene = Scene::clone(&self.scene);
        scene.contact.model = ContactModel::Appendix;
        self.sweep_plan_of(&scene, Picture::Line).ok()
    }

    /// The plan of a chart or map of the present scene.
    pub fn sweep_plan(&self, picture: Picture) -> Result<Plan, SweepError> {
        self.sweep_plan_of(&self.scene, picture)
    }

    /// The same for another scene.
    pub fn sweep_plan_of(&self, scene: &Scene, picture: Picture) -> Result<Plan, SweepError> {
        let sweep = sweep_of(scene);
        let axis = |at: usize| Axis::of(&sweep.axes[at], &GRID_COUNTS);
        let mut axes = vec![axis(0)?];
        match picture {
            Picture::Line if has_family(scene) => {
                let second = axis(1)?;
                let (name, ends) = (second.symbol(), second.ends());
                axes.push(Axis::new(name, ends, self.pages.explore.plan.curves, second.spacing())?);
            }
            Picture::Line => {}
            Picture::Surface => axes.push(axis(1)?),
        }
        let plan = Plan::new(scene, axes, &sweep.outputs)?;
        grid::fits(&plan).map(|()| plan)
    }
}

/// Why no point of a picture has a value of an output that can be drawn, and what to do about it, in a few lines.
pub fn no_value(grid: &Grid, output: usize) -> Vec<String> {
    let column = grid.plan().outputs()[output];
    let name = column.title();
    let (done, _) = grid.progress();
    if done == 0 {
        return vec!["sweeping the first points".to_owned()];
    }
    let (along, up) = grid.counts();
    let mut points = (0..along).flat_map(|x| (0..up).map(move |y| (x, y)));
    if points.any(|(x, y)| grid.cell(x, y, output).value().is_some()) {
        return lines(
            &format!("no {name} above 0: a log scale shows none"),
            &["<log-y>: linear scale"],
        );
    }
    let counts = grid.outcomes();
    let all = counts.total();
    let other = "<view>, or Show in the setup (<next-pane>): another output";
    if counts.of(Outcome::Perforated) == all {
        let instead = "or show residual_velocity_m_s (<next-pane>, Show)";
        let cure = ["lower v_i, or raise h or S_y (<next-pane>, Hold)", instead];
        return lines(&format!("every point perforates: no {name}"), &cure);
    }
    if counts.of(Outcome::Arrested) + counts.of(Outcome::Separated) == all {
        let why = match column.name {
            "residual_velocity_m_s" | "exit_time_s" => "every point is stopped",
            _ => PointOutcome::Ended(Outcome::Arrested).without_value(column),
        };
        return lines(&format!("no {name}: {why}"), &[other]);
    }
    if counts.of(Outcome::Moving) == all {
        let cure = ["a longer horizon decides them (<next-pane>, Hold)", other];
        return lines(&format!("every point still moves at the end: no {name}"), &cure);
    }
    if counts.failed == all {
        return lines(
            "every point failed",
            &["<enter> opens one in the Run tab, and <tab-log>:Log says why"],
        );
    }
    lines(&format!("no point has a {name}"), &[&counts.to_string(), other])
}

/// How many points came to rest and still have no value of an output, with the letter of these gaps and what it means.
pub(crate) fn at_rest(grid: &Grid, output: usize) -> Option<String> {
    let (along, up) = grid.counts();
    let points = (0..along).flat_map(|x| (0..up).map(move |y| (x, y)));
    let is_empty = |(x, y): &(usize, usize)| grid.value(*x, *y, output).is_none();
    let outcomes = points.filter(is_empty).filter_map(|(x, y)| grid.outcome(x, y));
    let mut without = outcomes.filter(|outcome| outcome.is_stopped());
    let outcome = without.next()?;
    let why = outcome.without_value(grid.plan().outputs()[output]);
    let points = match without.count() {
        0 => "1 point".to_owned(),
        more => format!("{} points", more + 1),
    };
    Some(format!("{points} ({}): {why}", outcome.letter()))
}

/// The reason, then what to do about it.
fn lines(what: &str, cures: &[&str]) -> Vec<String> {
    std::iter::once(what).chain(cures.iter().copied()).map(str::to_owned).collect()
}
