//! Measured traces, or the histories of another program, beside a run: what is drawn, and the differences as a table.
//!
//! All numbers are of the rows as they were read, over the times that trace and run have in common. Values between the rows of the
//! run's series are linear. SI; differences are computed less measured.

use serde_json::{Value, json};

use crate::report::chart::Curve;
use crate::report::page::Page;
use crate::report::series::{Channel, thinned_to};
use crate::report::table::Table;
use cmra_engine::model::run::Run;
use cmra_engine::model::units::engineering;
use cmra_engine::numerics::larger;

/// Mark of measured points in charts.
pub const MARK: char = 'M';

/// Colour of measured curves, after those of the current run and of eight pins.
const COLOUR: usize = 9;

/// Number of points that are drawn apart; a trace of more points is a line with some of them marked.
const POINTS_APART: usize = 40;

/// Number of equal parts of the time that a line is thinned to: three for each column of dots of 160 cells.
const TIMES: f64 = 1_024.0;

/// Number of marked points of a line.
const MARKED: usize = 12;

/// Rows from which a trace is drawn from fewer points, and the parts of its time whose ends and extremes these are.
const LONG: usize = 20_000;
const PARTS: f64 = 4.0 * TIMES;

/// Traces of one file.
#[derive(Clone, Debug, PartialEq)]
pub struct Traces {
    /// Name of the file.
    pub name: String,
    /// The traces, in the order of the columns.
    pub traces: Vec<Trace>,
}

/// A quantity over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Heading of the column.
    pub heading: String,
    /// The quantity.
    pub channel: Channel,
    /// Time, s, and value, in order of time; at least one.
    pub points: Vec<(f64, f64)>,
}

/// Peak and end of a curve within the common times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// The value of greatest magnitude.
    pub peak: f64,
    /// Time of the peak, s.
    pub peak_time_s: f64,
    /// The last value.
    pub end: f64,
}

/// A trace compared with a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Rows of the trace within the time of the run.
    pub rows: usize,
    /// First and last common time, s.
    pub times_s: (f64, f64),
    /// The trace.
    pub measured: Figures,
    /// The run.
    pub computed: Figures,
    /// Root mean square of the difference, over time by trapezoids.
    pub rms: f64,
    /// The difference of greatest magnitude.
    pub greatest: f64,
    /// Time of the greatest difference, s.
    pub greatest_time_s: f64,
}

/// A trace and its difference from a run; `None` without a common time.
type Row<'c> = (&'c Trace, Option<Difference>);

/// Number of rows of a trace at which the run has no value, mostly after its end.
fn omitted(row: &Row<'_>) -> usize {
    row.0.points.len() - row.1.map_or(0, |it| it.rows)
}

/// The value of a curve at a time, linear between the points before and after it; at a jump the value after it. `None` outside.
fn value_at(points: &[(f64, f64)], after: usize, t_s: f64) -> Option<f64> {
    let (before_s, low) = *points.get(after.checked_sub(1)?)?;
    let Some((next_s, high)) = points.get(after).copied() else {
        return (t_s <= before_s).then_some(low).filter(|value| value.is_finite());
    };
    let width_s = next_s - before_s;
    let fraction = if width_s > 0.0 { (t_s - before_s) / width_s } else { 0.0 };
    Some(low + fraction * (high - low)).filter(|value| value.is_finite())
}

/// Returns time and value of the difference of greatest magnitude between the values of a trace and a run.
fn greatest(pairs: impl Iterator<Item = (f64, f64, f64)>) -> Option<(f64, f64)> {
    let differences = pairs.map(|it| (it.0, it.2 - it.1));
    differences.reduce(|a, b| if b.1.abs() > a.1.abs() { b } else { a })
}

fn figures(points: &[(f64, f64)]) -> Option<Figures> {
    let peak = points.iter().copied().reduce(|a, b| if b.1.abs() > a.1.abs() { b } else { a })?;
    Some(Figures { peak: peak.1, peak_time_s: peak.0, end: points.last()?.1 })
}

impl Trace {
    /// The trace compared with a run; `None` without a common time.
    pub fn difference(&self, run: &Run) -> Option<Difference> {
        let computed = self.channel.points(run, &run.series);
        let pairs: Vec<(f64, f64, f64)> = self.pairs(&computed).collect();
        let (first_s, last_s) = (pairs.first()?.0, pairs.last()?.0);
        let measured: Vec<(f64, f64)> = pairs.iter().map(|it| (it.0, it.1)).collect();
        // The run's own peak may lie between two rows of the trace.
        let mut own: Vec<(f64, f64)> = pairs.iter().map(|it| (it.0, it.2)).collect();
        let is_common =
            |point: &&(f64, f64)| (first_s..=last_s).contains(&point.0) && point.1.is_finite();
        let inner = computed.iter().filter(is_common).copied();
        let end = own.last()?.1;
        own.extend(inner);
        let greatest = greatest(pairs.iter().copied())?;
        let square = |it: &(f64, f64, f64)| (it.2 - it.1).powi(2);
        let area = |two: &[(f64, f64, f64)]| {
            0.5 * (two[1].0 - two[0].0) * (square(&two[0]) + square(&two[1]))
        };
        let whole_s = last_s - first_s;
        let mean = if whole_s > 0.0 {
            pairs.windows(2).map(area).sum::<f64>() / whole_s
        } else {
            pairs.iter().map(square).sum::<f64>() / pairs.len() as f64
        };
        Some(Difference {
            rows: pairs.len(),
            times_s: (first_s, last_s),
            measured: figures(&measured)?,
            computed: Figures { end, ..figures(&own)? },
            rms: mean.sqrt(),
            greatest: greatest.1,
            greatest_time_s: greatest.0,
        })
    }

    /// Times of the trace within those of a run, with the values of both. Both are in order of time, so one pass suffices: a trace may have
    /// a hundred thousand rows.
    fn pairs(&self, computed: &[(f64, f64)]) -> impl Iterator<Item = (f64, f64, f64)> {
        let last_s = computed.last().map_or(f64::NEG_INFINITY, |point| point.0);
        let mut after = 0;
        self.until(last_s).iter().filter_map(move |(t_s, value)| {
            after += computed[after..].iter().take_while(|point| point.0 <= *t_s).count();
            Some((*t_s, *value, value_at(computed, after, *t_s)?))
        })
    }

    /// Returns the difference of greatest magnitude from a run; `None` without a common time.
    fn greatest(&self, run: &Run) -> Option<f64> {
        let computed = self.channel.points(run, &run.series);
        greatest(self.pairs(&computed)).map(|it| it.1)
    }

    /// The points up to a time.
    fn until(&self, end_s: f64) -> &[(f64, f64)] {
        &self.points[..self.points.partition_point(|point| point.0 <= end_s)]
    }

    /// Returns the curves of the trace up to a time: separate points, or a line with marked points.
    pub fn curves(&self, end_s: f64) -> Vec<Curve<'static>> {
        let seen = self.until(end_s);
        if seen.len() <= POINTS_APART {
            return vec![self.marked(seen.iter().copied())];
        }
        let line = Curve::new(MARK, "", thinned_to(seen, TIMES)).colour(COLOUR);
        // Even in time, whatever the rows are.
        let step_s = (seen[seen.len() - 1].0 - seen[0].0) / MARKED as f64;
        let at = |mark: usize| {
            let t_s = seen[0].0 + (mark as f64 + 0.5) * step_s;
            seen[seen.partition_point(|point| point.0 < t_s).min(seen.len() - 1)]
        };
        vec![line, self.marked((0..MARKED).map(at))]
    }

    fn marked(&self, points: impl IntoIterator<Item = (f64, f64)>) -> Curve<'static> {
        Curve::points(MARK, self.heading.clone(), points).colour(COLOUR)
    }
}

impl Traces {
    /// The traces of a quantity.
    pub fn of_channel(&self, channel: Channel) -> impl Iterator<Item = &Trace> {
        self.traces.iter().filter(move |trace| trace.channel == channel)
    }

    /// Returns the traces with fewer points for long ones, from which each change of a chart draws.
    #[must_use]
    pub fn for_drawing(&self) -> Self {
        let few = |trace: &Trace| {
            let is_long = trace.points.len() > LONG;
            let points =
                if is_long { thinned_to(&trace.points, PARTS) } else { trace.points.clone() };
            Trace { points, ..trace.clone() }
        };
        Self { name: self.name.clone(), traces: self.traces.iter().map(few).collect() }
    }

    /// Returns the curves of a quantity up to a time, from these traces for drawing (`few`), unless they have few points until then.
    pub fn curves_from(&self, few: &Self, channel: Channel, end_s: f64) -> Vec<Curve<'static>> {
        let pairs = self.traces.iter().zip(&few.traces).filter(|pair| pair.0.channel == channel);
        let enough = |few: &Trace| few.until(end_s).len() as f64 >= TIMES;
        pairs.flat_map(|(all, few)| if enough(few) { few } else { all }.curves(end_s)).collect()
    }

    /// The curves of a quantity up to a time.
    pub fn curves(&self, channel: Channel, end_s: f64) -> Vec<Curve<'static>> {
        self.of_channel(channel).flat_map(|trace| trace.curves(end_s)).collect()
    }

    /// The greatest difference of a run from the traces of a quantity; `None` without one.
    pub fn greatest(&self, channel: Channel, run: &Run) -> Option<f64> {
        let differences = self.of_channel(channel).filter_map(|trace| trace.greatest(run));
        differences.reduce(|a, b| if b.abs() > a.abs() { b } else { a })
    }

    /// The last time of all traces, s.
    pub fn end_s(&self) -> f64 {
        let ends = self.traces.iter().filter_map(|trace| Some(trace.points.last()?.0));
        ends.fold(0.0, larger)
    }

    /// The differences of a run, a row for each trace.
    fn table<'c>(rows: impl IntoIterator<Item = Row<'c>>) -> Table<'c, Row<'c>> {
        let with = |table: Table<'c, Row<'c>>,
                    (key, label): (&'static str, &'static str),
                    get: fn(&Difference) -> f64,
                    is_time: bool| {
            table.with(key, label, "", move |row| Some(get(row.1.as_ref()?))).shown(
                move |row, value| {
                    let unit = if is_time { "s" } else { row.0.channel.unit() };
                    Some(engineering(value.as_f64()?, unit, 4))
                },
            )
        };
        let table = Table::new(rows)
            .with("column", "column", "", |row: &Row<'c>| row.0.heading.as_str())
            .with("quantity", "quantity", "", |row| row.0.channel.title().to_lowercase())
            .with("unit", "unit", "", |row| row.0.channel.unit())
            .with("rows", "rows compared", "", |row| row.1.map(|it| it.rows))
            .field("omitted_rows", omitted);
        let table = with(table, ("from_s", "from"), |it| it.times_s.0, true);
        let table = with(table, ("to_s", "to"), |it| it.times_s.1, true);
        let table = with(table, ("measured_peak", "peak, measured"), |it| it.measured.peak, false);
        let table = with(table, ("computed_peak", "peak, computed"), |it| it.computed.peak, false);
        let table = with(
            table,
            ("measured_peak_time_s", "its time, measured"),
            |it| it.measured.peak_time_s,
            true,
        );
        let table = with(
            table,
            ("computed_peak_time_s", "its time, computed"),
            |it| it.computed.peak_time_s,
            true,
        );
        let table = with(table, ("measured_end", "end, measured"), |it| it.measured.end, false);
        let table = with(table, ("computed_end", "end, computed"), |it| it.computed.end, false);
        let table = with(table, ("rms_difference", "RMS difference"), |it| it.rms, false);
        let table =
            with(table, ("greatest_difference", "greatest difference"), |it| it.greatest, false);
        with(table, ("greatest_difference_time_s", "its time"), |it| it.greatest_time_s, true)
    }

    fn rows(&self, run: &Run) -> impl Iterator<Item = Row<'_>> {
        self.traces.iter().map(|trace| (trace, trace.difference(run)))
    }

    /// Appends the differences of a run to its report; of traces without a common time, why there are none.
    pub fn compare(&self, page: &mut Page, run: &Run) {
        let (compared, others): (Vec<_>, Vec<_>) = self.rows(run).partition(|row| row.1.is_some());
        page.heading(format!("beside {} (computed less measured)", self.name));
        let counts = compared.iter().map(|row| (&row.0.heading, omitted(row), row.0.points.len()));
        let partly: Vec<_> = counts.filter(|it| it.1 > 0).collect();
        if !compared.is_empty() {
            let table = Self::table(compared);
            let keys: Vec<&str> = table.keys().into_iter().filter(|key| *key != "unit").collect();
            page.table(table.turned(&keys));
        }
        let end_s = run.series.last().map_or(0.0, |row| row.t_s);
        let end = engineering(end_s, "s", 4);
        for (heading, omitted, all) in partly {
            let are = if omitted == 1 { "is" } else { "are" };
            page.line(format!(
                "{heading}: {omitted} of {all} rows {are} omitted, since the run, which ends at {end}, has no value then: \
                 peak and end are those of the rows compared; run longer with --set horizon=TIME"
            ));
        }
        for (trace, _) in others {
            let first = engineering(trace.points[0].0, "s", 4);
            page.line(format!(
                "{}: no row within the time of the run, which ends at {end}; the first row is at {first}: check the unit of time, \
                 or run longer with --set horizon=TIME",
                trace.heading
            ));
        }
    }

    /// The differences of a run as an object.
    pub fn json(&self, run: &Run) -> Value {
        json!({ "file": self.name, "traces": Self::table(self.rows(run)).objects(|_| true) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::testing::run_of;

    fn trace(channel: Channel, points: Vec<(f64, f64)>) -> Trace {
        Trace { heading: "measured".to_owned(), channel, points }
    }

    #[test]
    fn a_run_beside_itself_does_not_differ() {
        let run = run_of("");
        for channel in [Channel::Penetration, Channel::ContactForce, Channel::PlateVelocity] {
            let points = channel.points(&run, &run.series);
            let found = trace(channel, points.clone()).difference(&run).unwrap();
            // At a jump both rows have the time of the value after it.
            let last = points.last().unwrap().1;
            assert_eq!((found.rows, found.measured.end), (points.len(), last));
            assert_eq!(found.computed.end.to_bits(), last.to_bits());
            if channel != Channel::ContactForce {
                assert_eq!((found.rms.to_bits(), found.greatest.to_bits()), (0, 0));
            }
        }
    }

    /// Measured is computed less 1 mm and a ramp of 2 mm over the time T: the difference d = 1 + 2 s mm, s = t/T, has an RMS of
    /// sqrt(1 + 2 + 4/3) mm and is greatest at the end, 3 mm.
    #[test]
    fn valid_the_differences_of_a_ramp() {
        let run = run_of("");
        let points = Channel::Penetration.points(&run, &run.series);
        let end_s = 1.2e-4;
        let many = 20_001;
        let at = |index: usize| {
            let fraction = index as f64 / (many - 1) as f64;
            let t_s = fraction * end_s;
            let after = points.partition_point(|point| point.0 <= t_s);
            (t_s, value_at(&points, after, t_s).unwrap() - 1e-3 - 2e-3 * fraction)
        };
        let found = trace(Channel::Penetration, (0..many).map(at).collect());
        let found = found.difference(&run).unwrap();
        let exact = 1e-3 * (1.0f64 + 2.0 + 4.0 / 3.0).sqrt();
        assert!((found.rms / exact - 1.0).abs() < 1e-8, "{} {exact}", found.rms);
        assert!(
            (found.greatest - 3e-3).abs() < 1e-15 && (found.greatest_time_s - end_s).abs() < 1e-18
        );
        assert!((found.computed.end - found.measured.end - 3e-3).abs() < 1e-15);
    }

    #[test]
    fn rows_after_the_run_do_not_count_and_a_single_point_is_compared() {
        let run = run_of("");
        let last_s = run.series.last().unwrap().t_s;
        let found = trace(Channel::PlateDisplacement, vec![(1e-3, 0.0), (2.0 * last_s, 1.0)]);
        let found = found.difference(&run).unwrap();
        let computed = Channel::PlateDisplacement.at(&run, 1e-3).unwrap();
        assert_eq!((found.rows, found.greatest.to_bits()), (1, computed.to_bits()));
        assert_eq!(found.rms.to_bits(), computed.abs().to_bits());
        assert_eq!(trace(Channel::Penetration, vec![(2.0 * last_s, 1.0)]).difference(&run), None);
    }

    #[test]
    fn many_rows_are_thinned_for_drawing_and_few_are_marked() {
        let many: Vec<(f64, f64)> = (0..100_000).map(|at| (1e-8 * f64::from(at), 1.0)).collect();
        let curves = trace(Channel::Penetration, many).curves(1.0);
        assert_eq!(curves.len(), 2);
        // Four of each part of the time, and the last point.
        assert!(curves[0].points.len() <= 4 * 1_024 + 1 && curves[1].is_dotted());
        let few = trace(Channel::Penetration, vec![(0.0, 0.0), (1.0, 1.0), (2.0, 1.0)]).curves(1.5);
        assert!(few.len() == 1 && few[0].is_dotted() && few[0].points.len() == 4);
    }

    /// Each edit draws from about 16,000 points instead of all rows; a short part of a trace still has all its rows.
    #[test]
    fn long_traces_are_thinned_once_and_keep_spikes_and_short_parts() {
        let spike = 77_777;
        let value = |at: u32| if at == spike { 5.0 } else { 1e-3 * f64::from(at % 7) };
        let points = (0..100_000).map(|at| (1e-8 * f64::from(at), value(at))).collect();
        let channel = Channel::Penetration;
        let all = Traces { name: "T.csv".to_owned(), traces: vec![trace(channel, points)] };
        let few = all.for_drawing();
        assert!(few.traces[0].points.len() <= 4 * 4_096 + 1);
        let greatest = |end_s: f64| {
            let curves = all.curves_from(&few, channel, end_s);
            curves[0].points.iter().map(|point| point.1).fold(0.0, f64::max)
        };
        assert_eq!(
            (greatest(1.0).to_bits(), greatest(7e-4).to_bits()),
            (5_f64.to_bits(), 6e-3_f64.to_bits())
        );
        let part = all.curves_from(&few, channel, 5e-6);
        assert_eq!(part[0].points.len(), 501, "all rows of a short part");
    }
}
