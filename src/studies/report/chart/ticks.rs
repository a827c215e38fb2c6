//! Ticks of an axis and their labels: steps of 1, 2 or 5 times a power of ten, or decades on a logarithmic axis, as many as fit.
//!
//! The cell of a tick comes from the [`Mapping`] of the curves, and its label is centred on that cell. A common power of ten is factored
//! out of the labels. Rows of a terminal are coarse, so a value is labelled only if it lies near the centre of a row. If no two round
//! values do, the ends of the axis are labelled.

use super::scale::{Mapping, Scale, ViewRange};
use crate::report::steps::{Step, decade, power};

/// Minimum and maximum number of blank cells between adjacent labels. The gap is a twelfth of the axis within these limits.
const LABEL_GAP: (i32, i32) = (2, 8);
/// Maximum number of steps tried for an axis, each 2 or 2.5 times the previous one; covers one tick per cell to a single tick.
const STEPS_TRIED: usize = 24;
/// Maximum distance of a labelled value from the centre of its row, in rows; smaller than the resolution of a curve's dots.
const IN_ROW: f64 = 0.25;
/// Label distance, in rows, from which any position in the row is allowed, because an error of one row is not visible.
const EVEN_ROWS: u16 = 6;
/// Maximum number of digits of the label at an end of an axis.
const END_DIGITS: usize = 6;
/// Minimum number of labels of a vertical axis, by its minimum number of rows.
const MIN_LABELS: [(u16, usize); 3] = [(16, 5), (8, 3), (2, 2)];
/// Maximum distance of a value beyond the centre of the first or last row, in rows; the value is still in the row.
const BEYOND: f64 = 0.45;
/// Maximum length of a vertical axis, relative to the range of its values.
const MAX_SPREAD: f64 = 2.6;
/// Costs of a label distance one row from the ideal, and of a step of 2.5, relative to the unused fraction of the axis.
const UNWANTED_ROW: f64 = 0.04;
const UNUSUAL_STEP: f64 = 0.03;
/// Cost of a level line in the row of another value's label.
const CROSSED_LABEL: f64 = 0.5;
const BESIDE: f64 = 0.1;
/// Decades between labels of a logarithmic axis.
const DECADES: [u8; 9] = [1, 2, 3, 5, 10, 20, 50, 100, 200];
/// Maximum distance of the labels 2 and 5 of a decade from the centre of their rows, in rows: half a braille dot.
const NEAR: f64 = 0.125;
/// Maximum number of ticks evaluated for one step; more never fit.
const TICKS_LOOKED_AT: usize = 512;

/// Tick of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Cell from the start of the axis.
    pub cell: u16,
    /// Value, in the displayed unit.
    pub value: f64,
    /// Label of the tick.
    pub label: String,
}

/// Ticks of an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ticks {
    /// Ticks with labels, in order of value.
    pub labelled: Vec<Tick>,
    /// Power of ten by which the labels are multiplied.
    pub exponent: i32,
}

impl Ticks {
    /// Returns the width of the widest label.
    pub fn width(&self) -> u16 {
        let widest = self.labelled.iter().map(|tick| tick.label.len()).max();
        widest.and_then(|width| u16::try_from(width).ok()).unwrap_or(0)
    }
}

/// Arrangement of labels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Horizontal axis; label widths determine the distance.
    Row,
    /// Vertical axis with a mean distance in half rows; no two labels are closer than its whole rows.
    Column(u16),
    /// Vertical axis with labels at the centres of rows only.
    Rows(u16),
}

impl Along {
    /// Returns the distance between labels in half rows.
    fn half_rows(self) -> Option<u16> {
        match self {
            Self::Row => None,
            Self::Column(halves) | Self::Rows(halves) => Some(halves),
        }
    }
}

/// Returns as many ticks of an axis as fit.
pub fn ticks(map: Mapping, along: Along) -> Ticks {
    if map.cells == 0 {
        return Ticks::default();
    }
    match map.scale {
        Scale::Linear => linear(map, along),
        Scale::Log10 => decades(map, along).unwrap_or_else(|| linear(map, along)),
    }
}

/// Returns the first cell of a label that is centred on a cell: the only rule for placing labels.
pub fn label_start(cell: i32, length: i32) -> i32 {
    cell - length / 2
}

fn linear(map: Mapping, along: Along) -> Ticks {
    let view = map.view;
    let greatest = view.lo().abs().max(view.hi().abs());
    let exponent = common_exponent(greatest);
    // Adjacent labels are at least two cells apart, whatever their text.
    let nearest = match along {
        Along::Row => 2.0,
        Along::Column(_) | Along::Rows(_) => 1.0,
    };
    let most = (f64::from(map.cells) / nearest).max(2.0);
    let mut step = Step::at_least(view.span() / most);
    let mut best = Ticks::default();
    for _ in 0..STEPS_TRIED {
        let found = shorter(map, step, exponent);
        if found.labelled.is_empty() {
            break;
        }
        if fits(&found.labelled, along, map) {
            return found;
        }
        best = found;
        step = step.next();
    }
    match along {
        Along::Rows(_) => ends(map),
        Along::Row | Along::Column(_) => {
            best.labelled.truncate(1);
            best
        }
    }
}

/// Returns ticks at the ends of an axis, with the fewest digits that keep the labels in their rows.
fn ends(map: Mapping) -> Ticks {
    let view = map.view;
    let exponent = if map.scale == Scale::Log10 { 0 } else { common_exponent(view.size()) };
    let last = map.cells.saturating_sub(1);
    let tick = |cell: u16| {
        let value = map.value(cell);
        let near = |text: &String| {
            let shown =
                text.parse::<f64>().ok().and_then(|shown| map.position(shown * power(exponent)));
            shown.is_some_and(|at| (at - f64::from(cell)).abs() <= IN_ROW)
        };
        let texts = (1..=END_DIGITS).map(|digits| rounded(value / power(exponent), digits));
        let all = rounded(value / power(exponent), END_DIGITS);
        Tick { cell, value, label: texts.into_iter().find(near).unwrap_or(all) }
    };
    let cells = if last == 0 { vec![0] } else { vec![0, last] };
    let mut labelled: Vec<Tick> = cells.into_iter().map(tick).collect();
    if labelled.iter().any(|tick| tick.label.contains('e')) {
        // Use the same format for both.
        for tick in labelled.iter_mut().filter(|tick| !tick.label.contains('e')) {
            tick.label =
                tick.label.parse().map_or_else(|_| tick.label.clone(), |it: f64| format!("{it:e}"));
        }
    }
    Ticks { labelled, exponent }
}

/// Formats a number with this many digits, in decimal notation if that is short.
fn rounded(value: f64, digits: usize) -> String {
    let text = format!("{value:.*e}", digits - 1);
    let exact: f64 = text.parse().unwrap_or(value);
    let plain = format!("{exact}");
    if plain.len() <= text.len() + 1 { plain } else { text }
}

/// Returns the multiples of a step in view; factors out a common power of ten if that shortens the labels.
fn shorter(map: Mapping, step: Step, exponent: i32) -> Ticks {
    let ticks = |exponent| Ticks { labelled: multiples(map, step, exponent), exponent };
    let whole = ticks(0);
    if exponent == 0 {
        return whole;
    }
    let factored = ticks(exponent);
    if whole.width() <= factored.width() { whole } else { factored }
}

/// Returns the multiples of a step in view. Counting whole steps avoids accumulated rounding errors.
fn multiples(map: Mapping, step: Step, exponent: i32) -> Vec<Tick> {
    let view = map.view;
    let size = step.size();
    let mut count = (view.lo() / size - 1e-9).ceil();
    let last = (view.hi() / size + 1e-9).floor();
    let mut found = Vec::new();
    while count <= last && found.len() < TICKS_LOOKED_AT {
        if let Some(cell) = map.cell(count * size) {
            let units = count * f64::from(step.mantissa);
            let label = label(units, step.exponent - exponent);
            found.push(Tick { cell, value: count * size, label });
        }
        count += 1.0;
    }
    found
}

/// Formats a whole number of `10^exponent` with the necessary decimals only.
fn label(units: f64, exponent: i32) -> String {
    if units == 0.0 {
        return "0".to_owned();
    }
    let decimals = usize::try_from(-exponent).unwrap_or(0);
    // Division by an exact power of ten rounds once; multiplication by its inverse rounds twice.
    let value = if exponent < 0 { units / power(-exponent) } else { units * power(exponent) };
    format!("{value:.decimals$}")
}

/// Returns ticks at decades, and at 2 and 5 if they fit; `None` for fewer than three ticks, because linear ticks are better within a
/// decade.
fn decades(map: Mapping, along: Along) -> Option<Ticks> {
    let dense = in_decades(map, &[1, 2, 5], 1);
    if dense.len() < 3 {
        return None;
    }
    if fits(&dense, along, map) {
        return Some(Ticks { labelled: dense, exponent: 0 });
    }
    let mut found = DECADES.into_iter().map(|every| in_decades(map, &[1], every));
    let labelled = found.find(|ticks| !ticks.is_empty() && fits(ticks, along, map))?;
    Some(Ticks { labelled, exponent: 0 })
}

/// Returns these multiples of each power of ten in view whose exponent is a multiple of `every`.
fn in_decades(map: Mapping, mantissas: &[u8], every: u8) -> Vec<Tick> {
    let first = decade(map.view.lo()) - 1;
    let last = decade(map.view.hi()) + 1;
    let (low, high) = (map.view.lo() * (1.0 - 1e-9), map.view.hi() * (1.0 + 1e-9));
    let exponents = (first..=last).filter(|exponent| exponent % i32::from(every) == 0);
    let all = exponents.flat_map(|exponent| mantissas.iter().map(move |it| (*it, exponent)));
    let all = all.map(|it| (it, f64::from(it.0) * power(it.1)));
    let seen: Vec<_> = all.filter(|(_, value)| low <= *value && *value <= high).collect();
    let spelled = seen.iter().any(|((_, exponent), _)| !(-3..=4).contains(exponent));
    let tick = |((mantissa, exponent), value): ((u8, i32), f64)| {
        let plain = || label(f64::from(mantissa), exponent);
        let label = if spelled { format!("{mantissa}e{exponent}") } else { plain() };
        Some(Tick { cell: map.cell(value)?, value, label })
    };
    seen.into_iter().filter_map(tick).collect()
}

/// Fits a vertical axis with round labels at the centres of rows: its range, extended so that a round step is a whole number of rows, and
/// its ticks. Labels avoid the level lines at these values if possible. `None` for a single row, or for a logarithmic axis over too few
/// decades.
pub fn on_rows(
    scale: Scale,
    view: ViewRange,
    rows: u16,
    lines: &[f64],
) -> Option<(ViewRange, Ticks)> {
    let view = view.on(scale);
    let (low, high) = (scale.place(view.lo()), scale.place(view.hi()));
    let last = f64::from(rows.checked_sub(1).filter(|last| *last > 0)?);
    let least = MIN_LABELS.iter().find(|(from, _)| rows >= *from).map_or(2, |it| it.1);
    let wanted = f64::from(rows_apart(rows));
    let lowest = if rows < 8 { 1 } else { 2 };
    let mut best: Option<(f64, ViewRange, Ticks)> = None;
    for (step, size) in steps(scale, (high - low) / (last + 2.0 * BEYOND)) {
        for apart in lowest..rows {
            let row = size / f64::from(apart);
            let (first, end) = ((low / row + BEYOND).floor(), (high / row - BEYOND).ceil());
            let spread = row * last / (high - low);
            let away = (f64::from(apart) - wanted).abs();
            let odd = if step.mantissa == 25 { UNUSUAL_STEP } else { 0.0 };
            let cost = spread + UNWANTED_ROW * away + odd;
            let is_worse = |cost: f64| best.as_ref().is_some_and(|best| best.0 <= cost);
            if end - first > last || spread > MAX_SPREAD || is_worse(cost) {
                continue;
            }
            // Empty rows are at the top, or at the bottom if no value is positive.
            let first = if high <= 0.0 && scale == Scale::Linear { end - last } else { first };
            // Divide last: the value of a row then equals its label.
            let value = |count: f64| scale.back(count * size / f64::from(apart));
            let shown = ViewRange::new(value(first), value(first + last)).on(scale);
            let map = Mapping::new(scale, shown, rows);
            let ticks = match scale {
                Scale::Linear => shorter(map, step, common_exponent(shown.size())),
                Scale::Log10 => logarithmic(map, step, apart),
            };
            let crosses = |line: f64| {
                let at = map.position(line).unwrap_or(-1.0);
                let of_label = |tick: &Tick| {
                    let off = (at - f64::from(tick.cell)).abs();
                    BESIDE < off && off <= 0.5
                };
                ticks.labelled.iter().any(of_label)
            };
            let crossed = lines.iter().filter(|line| crosses(**line)).count();
            let cost = cost + CROSSED_LABEL * crossed as f64;
            if ticks.labelled.len() >= least && !is_worse(cost) {
                best = Some((cost, shown, ticks));
            }
        }
    }
    best.map(|(_, shown, ticks)| (shown, ticks))
}

/// Returns round steps of at least a row with their lengths in the coordinates of the scale, as many as an axis may need.
fn steps(scale: Scale, row: f64) -> Vec<(Step, f64)> {
    let decades = || {
        let step = |every: u8| Step { mantissa: every, exponent: 0 };
        DECADES.map(step).map(|step| (step, f64::from(step.mantissa))).to_vec()
    };
    let linear = || {
        let first = decade(row);
        let round = |exponent: i32| {
            let less = exponent - 1;
            [(1, exponent), (2, exponent), (25, less), (5, exponent)]
                .map(|(mantissa, exponent)| Step { mantissa, exponent })
        };
        let all = (first..first + 4).flat_map(round);
        all.map(|step| (step, step.size())).collect()
    };
    match scale {
        Scale::Linear => linear(),
        Scale::Log10 => decades(),
    }
}

/// Returns ticks at powers of ten a step apart, and at 2 and 5 times each if these are at the centres of rows and fit.
fn logarithmic(map: Mapping, every: Step, apart: u16) -> Ticks {
    let off = |mantissa: f64| {
        let at = mantissa.log10() * f64::from(apart);
        (at - at.round()).abs()
    };
    let has_room = every.mantissa == 1 && apart >= 7;
    let is_dense = has_room && [2.0, 5.0].into_iter().all(|mantissa| off(mantissa) <= NEAR);
    let mantissas: &[u8] = if is_dense { &[1, 2, 5] } else { &[1] };
    Ticks { labelled: in_decades(map, mantissas, every.mantissa), exponent: 0 }
}

/// Returns the ideal distance between labels, in rows.
fn rows_apart(rows: u16) -> u16 {
    match rows {
        0..4 => 1,
        4..12 => 2,
        12..24 => 3,
        24.. => 4,
    }
}

/// Returns `true` if no labels overlap and each has its own cell. Labels on rows must number at least two, each at the centre of its row.
fn fits(ticks: &[Tick], along: Along, map: Mapping) -> bool {
    let (least, most) = LABEL_GAP;
    let gap = (i32::from(map.cells) / 12).clamp(least, most);
    let apart = |pair: &[Tick]| match (pair, along.half_rows()) {
        ([a, b], Some(halves)) => b.cell >= a.cell + (halves / 2).max(1),
        ([a, b], None) => {
            let [la, lb] = [a, b].map(|tick| i32::try_from(tick.label.len()).unwrap_or(0));
            let end = label_start(i32::from(a.cell), la) + la;
            label_start(i32::from(b.cell), lb) >= end + gap
        }
        (_, _) => true,
    };
    let loose = match (ticks, along.half_rows()) {
        ([first, .., last], Some(halves)) => {
            let between = u32::try_from(ticks.len() - 1).unwrap_or(u32::MAX);
            2 * u32::from(last.cell.abs_diff(first.cell)) >= between.saturating_mul(halves.into())
        }
        (_, _) => true,
    };
    let far = ticks.windows(2).all(|pair| pair[1].cell.abs_diff(pair[0].cell) >= EVEN_ROWS);
    let in_row = |tick: &Tick| {
        let at = map.position(tick.value);
        far || at.is_some_and(|at| (at - f64::from(tick.cell)).abs() <= IN_ROW)
    };
    let placed = !matches!(along, Along::Rows(_)) || ticks.len() > 1 && ticks.iter().all(in_row);
    loose && placed && ticks.windows(2).all(apart)
}

/// Returns the power of ten, a multiple of three, that keeps labels short: 0 for 0.001 to 99999.
fn common_exponent(greatest: f64) -> i32 {
    if (1e-3..1e5).contains(&greatest) { 0 } else { decade(greatest).div_euclid(3) * 3 }
}
