//! Long series in a few points: for each quantity the first, lowest, highest and last sample of each of many short stretches.
//!
//! Drawn instead of all samples where so much of a run is in view that a column of dots holds many stretches: the picture is the
//! same, and a frame costs the same for millions of steps as for thousands. Made once, when the result lands.

use std::ops::Range;
use std::sync::{Arc, Weak};

use crate::model::run::Run;
use crate::report::series::Quantity;

/// A series of fewer samples is always drawn from all of them.
pub const SAMPLES_MIN: usize = 65_536;

/// Into how many stretches a series is cut.
const STRETCHES: usize = 16_384;

/// So many stretches in view are a few for every column of dots of the widest screen; of fewer, all samples are drawn.
const STRETCHES_SEEN_MIN: usize = 2_048;

/// The samples of one run that its curves are drawn from when much of it is in view.
#[derive(Clone, Debug)]
pub struct Coarse {
    /// Of which run: as long as this is kept, no other one can lie at its address.
    run: Weak<Run>,
    /// How many samples a stretch has, the last one perhaps fewer.
    stretch: usize,
    /// Indices into the series, rising, for each of [`Quantity::ALL`].
    kept: [Vec<usize>; Quantity::ALL.len()],
}

impl Coarse {
    /// Of a run with a long series; `None` for a short one.
    pub fn of(run: &Arc<Run>) -> Option<Self> {
        let length = run.series.len();
        if length < SAMPLES_MIN {
            return None;
        }
        let stretch = length.div_ceil(STRETCHES);
        let kept = Quantity::ALL.map(|quantity| {
            let mut kept = Vec::with_capacity(4 * STRETCHES);
            for from in (0..length).step_by(stretch) {
                keep(run, quantity, from..length.min(from + stretch), &mut kept);
            }
            kept
        });
        Some(Self { run: Arc::downgrade(run), stretch, kept })
    }

    /// Whether it is of this run.
    pub fn is_of(&self, run: &Run) -> bool {
        std::ptr::eq(self.run.as_ptr(), run)
    }

    /// Whether the run is still kept anywhere.
    pub fn is_wanted(&self) -> bool {
        self.run.strong_count() > 0
    }

    /// The samples to draw of those in view; `None` where these are so few that all are drawn.
    pub fn of_those(&self, quantity: Quantity, seen: &Range<usize>) -> Option<&[usize]> {
        if seen.len() < STRETCHES_SEEN_MIN * self.stretch {
            return None;
        }
        let at = Quantity::ALL.iter().position(|one| *one == quantity)?;
        let kept = &self.kept[at];
        // One more at either end: the line goes on to the edge of the view.
        let from = kept.partition_point(|index| *index < seen.start).saturating_sub(1);
        let to = kept.partition_point(|index| *index < seen.end).saturating_add(1).min(kept.len());
        kept.get(from..to)
    }
}

/// Keep of a stretch what its picture needs, in order. Where a gap begins or ends in it, that is all of it.
fn keep(run: &Run, quantity: Quantity, stretch: Range<usize>, kept: &mut Vec<usize>) {
    let value = |index: usize| quantity.drawn(&run.series[index]);
    let (first, last) = (stretch.start, stretch.end - 1);
    let (mut lowest, mut highest, mut gaps) = (first, first, 0);
    for index in stretch.clone() {
        let here = value(index);
        if !here.is_finite() {
            gaps += 1;
        } else if here < value(lowest) {
            lowest = index;
        } else if here > value(highest) {
            highest = index;
        }
    }
    if gaps > 0 && gaps < stretch.len() {
        kept.extend(stretch);
        return;
    }
    let mut few = [first, lowest, highest, last];
    few.sort_unstable();
    for index in few {
        if kept.last() != Some(&index) {
            kept.push(index);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::scene::Scene;
    use crate::model::simulate::{Settings, simulate};
    use crate::tui::app::App;
    use crate::tui::app::Base;
    use crate::tui::app::Origin;
    use crate::tui::pages::run::runs::Shown;
    use crate::tui::theme::{ColourDepth, GlyphSet, Theme};

    /// A run whose displacement is a sine of so many samples, with one spike.
    fn run(samples: usize, spike: usize) -> Arc<Run> {
        let go_on = &mut |_| std::ops::ControlFlow::Continue(());
        let settings = Settings { series: true, estimate: false };
        let mut run = simulate(&Arc::new(Scene::default()), &settings, go_on).unwrap();
        let one = run.series[0];
        run.series = (0..samples)
            .map(|index| {
                let mut sample = one;
                sample.t_s = index as f64;
                sample.plate_displacement_m = (0.01 * index as f64).sin();
                // Out of the plate from two thirds on.
                sample.penetration_m = if 3 * index > 2 * samples { -1.0 } else { 1e-3 };
                sample
            })
            .collect();
        run.series[spike].plate_displacement_m = 5.0;
        Arc::new(run)
    }

    #[test]
    fn a_short_series_is_drawn_in_full() {
        assert!(Coarse::of(&run(SAMPLES_MIN - 1, 7)).is_none());
    }

    #[test]
    fn a_long_series_keeps_its_ends_its_spike_and_its_gap_in_few_points() {
        let (samples, spike) = (1_000_000, 654_321);
        let run = run(samples, spike);
        let coarse = Coarse::of(&run).unwrap();
        assert!(coarse.is_of(&run) && !coarse.is_of(&Run::clone(&run)));
        let kept = coarse.of_those(Quantity::PlateDisplacement, &(0..samples)).unwrap();
        assert!(kept.len() <= 4 * STRETCHES, "{}", kept.len());
        assert_eq!((kept.first(), kept.last()), (Some(&0), Some(&(samples - 1))));
        assert!(kept.binary_search(&spike).is_ok());
        assert!(kept.windows(2).all(|pair| pair[0] < pair[1]));
        // The last sample in the plate and the first out of it.
        let kept = coarse.of_those(Quantity::Penetration, &(0..samples)).unwrap();
        let out = run.series.partition_point(|sample| sample.penetration_m > 0.0);
        assert!(kept.binary_search(&out).is_ok() && kept.binary_search(&(out - 1)).is_ok());
    }

    #[test]
    fn a_narrow_view_is_drawn_in_full_and_a_wide_one_reaches_its_edges() {
        let run = run(1_000_000, 3);
        let coarse = Coarse::of(&run).unwrap();
        let of = |seen: Range<usize>| coarse.of_those(Quantity::PlateDisplacement, &seen);
        assert!(of(500_000..600_000).is_none());
        let seen = 200_000..700_000;
        let kept = of(seen.clone()).unwrap();
        assert!(kept[0] <= seen.start && kept[kept.len() - 1] >= seen.end - 1);
    }

    /// What a frame draws of three million samples, and that it reaches the edges of what is in view.
    #[test]
    fn the_curves_of_a_long_run_have_few_points_whatever_is_in_view() {
        let scene = Arc::new(Scene::default());
        let base = Base { name: String::new(), origin: Origin::Bundled, scene };
        let theme = Theme { glyphs: GlyphSet::Ascii, depth: ColourDepth::None };
        let mut app = App::new(base, theme, std::path::PathBuf::new());
        let run = run(3_000_000, 7);
        app.note_run(&run);
        app.note_run(&run);
        assert_eq!(app.charts.coarse.len(), 1);
        app.shown = Some(Shown { run, took: None });
        for zoom_s in [(0.0_f64, 3e6_f64), (1e6, 2e6), (0.0, 100.0), (1e6, 1.1e6), (-5.0, -1.0)] {
            app.charts.zoom_s = Some(crate::tui::chart::ViewRange::new(zoom_s.0, zoom_s.1));
            let curves = app.curves(Quantity::PlateDisplacement);
            let points = &curves[0].points;
            let most = STRETCHES_SEEN_MIN * 3_000_000usize.div_ceil(STRETCHES);
            assert!(points.len() <= most, "{} points in {zoom_s:?}", points.len());
            if zoom_s.0 >= 0.0 {
                assert!(points[0].0 <= zoom_s.0, "{zoom_s:?}");
                assert!(points[points.len() - 1].0 >= zoom_s.1.min(3e6 - 1.0), "{zoom_s:?}");
            }
        }
    }

    #[test]
    fn a_run_that_nobody_keeps_is_let_go() {
        let run = run(SAMPLES_MIN, 7);
        let coarse = Coarse::of(&run).unwrap();
        assert!(coarse.is_wanted());
        drop(run);
        assert!(!coarse.is_wanted());
    }
}
