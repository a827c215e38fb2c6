//! State of the Run tab.

use std::sync::Arc;

use crate::tui::app::running::CachedResult;
use crate::tui::keymap::{Pane, Tab};
use crate::tui::pages::run::editor::Editor;
use crate::worker::studies::SearchAnswer;
use cmra_engine::model::run::Run;
use cmra_studies::report::chart::Curve;
use cmra_studies::report::series::Channel;
use cmra_studies::report::traces::Traces;

pub const VARIABLES: Pane = Pane::new(Tab::Run, 0);
pub const CHARTS: Pane = Pane::new(Tab::Run, 1);
pub const RUNS: Pane = Pane::new(Tab::Run, 2);

#[derive(Clone, Debug, Default)]
pub struct RunPage {
    pub editor: Editor,
    pub charts: Charts,
    /// Sensitivity bars in place of labels.
    pub matters: Matters,
    /// Traces drawn with the runs.
    pub beside: Option<Arc<Traces>>,
    /// Differences of the current run from these traces.
    pub differences: Differences,
    /// Curves of these traces in the charts.
    pub drawn: Drawn,
    /// Selected row in the table of runs; 0 is the current run.
    pub selected: usize,
    /// Whether the focused pane fills the body.
    pub is_full: bool,
}

/// State of the sensitivity bars: displayed output, and computed points.
#[derive(Clone, Debug, Default)]
pub struct Matters {
    /// Index of the displayed output; `None` for labels instead of bars.
    pub output: Option<usize>,
    /// Latest report, possibly partial.
    pub kept: CachedResult<SearchAnswer>,
}

/// Maximum differences of a run from traces, for the quantities of the charts; computed once for each pair.
#[derive(Clone, Debug, Default)]
pub struct Differences {
    pair: Option<(Arc<Run>, Arc<Traces>, [Channel; 3])>,
    greatest: Vec<(Channel, f64)>,
}

impl Differences {
    /// Returns the maximum difference of a quantity; `None` without a trace of it.
    pub fn get(&self, channel: Channel) -> Option<f64> {
        self.greatest.iter().find(|one| one.0 == channel).map(|one| one.1)
    }

    /// Computes the differences if the run, the traces or the quantities have changed.
    pub(crate) fn follow(
        &mut self,
        run: Option<&Arc<Run>>,
        traces: Option<&Arc<Traces>>,
        channels: [Channel; 3],
    ) {
        let Some((run, traces)) = run.zip(traces) else {
            *self = Self::default();
            return;
        };
        let is_same = |pair: &(Arc<Run>, Arc<Traces>, [Channel; 3])| {
            Arc::ptr_eq(&pair.0, run) && Arc::ptr_eq(&pair.1, traces) && pair.2 == channels
        };
        if self.pair.as_ref().is_some_and(is_same) {
            return;
        }
        let greatest = |channel| Some((channel, traces.greatest(channel, run)?));
        self.greatest = channels.into_iter().filter_map(greatest).collect();
        self.pair = Some((Arc::clone(run), Arc::clone(traces), channels));
    }
}

/// Curves of the traces, thinned once for each chart and end time instead of each frame.
#[derive(Clone, Debug, Default)]
pub struct Drawn {
    of: Option<(Arc<Traces>, Ends)>,
    /// Traces with fewer points, thinned once.
    few: Option<Traces>,
    curves: Vec<Vec<Curve<'static>>>,
}

/// Quantity of each chart, and the bits of its end time in s.
type Ends = [(Channel, u64); 3];

impl Drawn {
    /// Returns the curves of a quantity in a chart.
    pub fn get(&self, chart: usize, channel: Channel) -> &[Curve<'static>] {
        let is_it = self.of.as_ref().is_some_and(|of| of.1[chart].0 == channel);
        self.curves.get(chart).filter(|_| is_it).map_or(&[], Vec::as_slice)
    }

    /// Thins the traces if they, the quantities or the end times have changed.
    pub(crate) fn follow(&mut self, traces: Option<&Arc<Traces>>, charts: [(Channel, f64); 3]) {
        let Some(traces) = traces else {
            *self = Self::default();
            return;
        };
        let ends = charts.map(|(channel, end_s)| (channel, end_s.to_bits()));
        let is_same = |of: &(Arc<Traces>, Ends)| Arc::ptr_eq(&of.0, traces) && of.1 == ends;
        let is_known = self.of.as_ref().is_some_and(|of| Arc::ptr_eq(&of.0, traces));
        if !self.of.as_ref().is_some_and(is_same) {
            let few = self.few.take().filter(|_| is_known);
            let few = few.unwrap_or_else(|| traces.for_drawing());
            let curves = charts.iter();
            let curves = curves.map(|(channel, end_s)| traces.curves_from(&few, *channel, *end_s));
            self.curves = curves.collect();
            self.few = Some(few);
            self.of = Some((Arc::clone(traces), ends));
        }
    }
}

/// Displayed time range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Window {
    /// From the first contact to shortly after the last change of the depth.
    Contact,
    Whole,
}

#[derive(Clone, Debug)]
pub struct Charts {
    /// Quantities of the charts, from top to bottom.
    pub quantities: [Channel; 3],
    /// Time range of each chart.
    pub windows: [Window; 3],
    /// Selected chart.
    pub selected: usize,
    /// Crosshair, s since first contact.
    pub cursor_s: Option<f64>,
    /// Whether the animation moves the crosshair.
    pub is_playing: bool,
    /// Serial number of the latest animation; ticks of earlier ones are outdated.
    pub serial: u64,
}

impl Default for Charts {
    fn default() -> Self {
        Self {
            quantities: [Channel::Penetration, Channel::ContactForce, Channel::PlateDisplacement],
            windows: [Window::Contact, Window::Contact, Window::Whole],
            selected: 0,
            cursor_s: None,
            is_playing: false,
            serial: 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cmra_studies::report::traces::Trace;

    #[test]
    fn traces_are_thinned_once_for_each_window() {
        let points = (0..100_000).map(|at| (1e-8 * f64::from(at), 1.0)).collect();
        let channel = Channel::Penetration;
        let trace = Trace { heading: "depth".to_owned(), channel, points };
        let traces = Arc::new(Traces { name: "T.csv".to_owned(), traces: vec![trace] });
        let charts = |end_s| [(channel, end_s), (Channel::ContactForce, end_s), (channel, 1.0)];
        let mut drawn = Drawn::default();
        drawn.follow(Some(&traces), charts(1e-4));
        let place = |drawn: &Drawn| drawn.get(0, channel)[0].points.as_ptr();
        let first = place(&drawn);
        drawn.follow(Some(&traces), charts(1e-4));
        assert_eq!(place(&drawn), first);
        drawn.follow(Some(&traces), charts(5e-4));
        assert!(drawn.get(0, channel)[0].points.last().is_some_and(|point| point.0 > 4e-4));
        assert!(drawn.get(1, channel).is_empty() && drawn.get(1, Channel::ContactForce).is_empty());
        drawn.follow(None, charts(5e-4));
        assert!(drawn.get(0, channel).is_empty());
    }
}
