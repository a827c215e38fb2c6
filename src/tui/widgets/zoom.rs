//! Zooming and panning the axis across of a chart: one rule for all.

use crate::tui::chart::{Scale, ViewRange};
use crate::tui::keymap::Action;

const STEP: f64 = 2.0;
/// One pan step, as a share of the span.
const PAN: f64 = 0.25;

/// Whether an action chooses the part in view.
pub(crate) fn is_zoom(action: Action) -> bool {
    use Action::{PanLeft, PanRight, ZoomFit, ZoomIn, ZoomOut};
    matches!(action, ZoomIn | ZoomOut | ZoomFit | PanLeft | PanRight)
}

/// The axis across of the chart in the pane, and what can be shown of it.
pub(crate) struct Across<'a> {
    /// The part of it that was chosen; `None`: home.
    pub kept: &'a mut Option<ViewRange>,
    pub view: ViewRange,
    /// What is in view where nothing was chosen.
    pub home: ViewRange,
    /// Beyond this nothing is drawn.
    pub bounds: ViewRange,
    pub scale: Scale,
    /// The value that keeps its place.
    pub about: Option<f64>,
}

impl<'a> Across<'a> {
    /// An axis that shows all of itself at home.
    pub(crate) fn of(
        kept: &'a mut Option<ViewRange>,
        home: ViewRange,
        scale: Scale,
        about: Option<f64>,
    ) -> Self {
        let home = home.on(scale);
        let view = kept.map_or(home, |view| view.on(scale));
        Self { kept, view, home, bounds: home, scale, about }
    }

    /// Show what an action requests; false where it is not a zoom.
    pub(crate) fn change(self, action: Action) -> bool {
        let (view, scale) = (self.view, self.scale);
        let about = || {
            let middle = scale.back(0.5 * (scale.place(view.lo()) + scale.place(view.hi())));
            self.about.filter(|at| view.contains(*at)).unwrap_or(middle)
        };
        let next = match action {
            Action::ZoomIn => view.zoomed(scale, about(), STEP),
            Action::ZoomOut => view.zoomed(scale, about(), 1.0 / STEP),
            Action::ZoomFit => self.home,
            Action::PanLeft => view.panned(scale, -PAN, self.bounds),
            Action::PanRight => view.panned(scale, PAN, self.bounds),
            _ => return false,
        };
        let next = next.within(self.bounds);
        let is_home = action == Action::ZoomFit || next == self.home;
        *self.kept = (!is_home).then_some(next);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ends of what is in view after some actions, from all of 1 to 16.
    fn after(scale: Scale, about: f64, actions: &[Action]) -> Option<(f64, f64)> {
        let (mut kept, home) = (None, ViewRange::new(1.0, 16.0));
        for action in actions {
            assert!(Across::of(&mut kept, home, scale, Some(about)).change(*action));
        }
        kept.map(|view| (view.lo(), view.hi()))
    }

    #[test]
    fn the_view_stays_within_the_bounds() {
        use Action::{PanLeft, PanRight, ZoomFit, ZoomIn, ZoomOut};
        let linear = |actions: &[Action]| after(Scale::Linear, 1.0, actions);
        assert_eq!(linear(&[ZoomIn]), Some((1.0, 8.5)));
        assert_eq!(linear(&[ZoomIn, PanLeft]), Some((1.0, 8.5)));
        assert_eq!(
            linear(&[ZoomIn, PanRight, PanRight, PanRight, PanRight, PanRight]),
            Some((8.5, 16.0))
        );
        assert_eq!(linear(&[ZoomOut]), None);
        assert_eq!(linear(&[PanRight]), None);
        assert_eq!(linear(&[ZoomIn, ZoomOut]), None);
        assert_eq!(linear(&[ZoomIn, ZoomFit]), None);
        let (lo, hi) = after(Scale::Log10, 16.0, &[ZoomIn]).unwrap();
        assert!((lo - 4.0).abs() < 1e-12 && (hi - 16.0).abs() < 1e-12);
    }
}
