//! Where an axis has ticks and what is written at them: 1-2-5 steps, decades on a logarithmic axis, as many as fit.
//!
//! A tick knows its cell from the same [`Mapping`] the curves use, and its label is centred on that cell. What is common to
//! all labels (a power of ten) is factored out. Rows of a terminal are coarse: a value is labelled there only where it lies near the
//! middle of a row, and where no two round values do, the ends of the axis are.

use super::scale::{Mapping, Scale, ViewRange};
use crate::report::steps::{Step, decade, power};

/// Blank cells between two labels next to each other: a twelfth of the axis, but at least and at most this many. Room is used for
/// calm before it is used for numbers.
const LABEL_GAP: (i32, i32) = (2, 8);
/// Steps tried for one axis, each 2 or 2.5 times the one before: enough to pass from one tick a cell to one in all.
const STEPS_TRIED: usize = 24;
/// A value lies in its row if it is this near to the middle, in rows: nearer than the dots of a curve tell. From so many rows between
/// two labels on a row more or less is not noticed, and any place in the row will do.
const IN_ROW: f64 = 0.25;
const EVEN_ROWS: u16 = 6;
/// Most digits of the label at an end of an axis.
const END_DIGITS: usize = 6;
/// Labels that an axis upward has at least, from so many rows on.
const MIN_LABELS: [(u16, usize); 3] = [(16, 5), (8, 3), (2, 2)];
/// How far beyond the middle of the first and the last row a value may lie, in rows: it still is in the row.
const BEYOND: f64 = 0.45;
/// Longest part of an axis on rows, over the range of its values.
const MAX_SPREAD: f64 = 2.6;
/// Cost of one row between labels more or less than wanted, and of a step of 2.5, relative to the fraction of the axis left empty.
const UNWANTED_ROW: f64 = 0.04;
const UNUSUAL_STEP: f64 = 0.03;
/// Cost of a level line that passes through the row of another value's label.
const CROSSED_LABEL: f64 = 0.5;
const BESIDE: f64 = 0.1;
/// Decades from one label to the next on a logarithmic axis.
const DECADES: [u8; 9] = [1, 2, 3, 5, 10, 20, 50, 100, 200];
/// How far from the middle of their rows the labels 2 and 5 of a decade may lie, in rows: half a dot of braille.
const NEAR: f64 = 0.125;
/// Ticks looked at for one step; more would never fit.
const TICKS_LOOKED_AT: usize = 512;

/// Tick of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Cell from the start of the axis.
    pub cell: u16,
    /// Value, in the unit shown.
    pub value: f64,
    /// Label of the tick.
    pub label: String,
}

/// The ticks of an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ticks {
    /// In order of value.
    pub labelled: Vec<Tick>,
    /// Power of ten the labels are to be multiplied by.
    pub exponent: i32,
}

impl Ticks {
    /// Width of the widest label.
    pub fn width(&self) -> u16 {
        let widest = self.labelled.iter().map(|tick| tick.label.len()).max();
        widest.and_then(|width| u16::try_from(width).ok()).unwrap_or(0)
    }
}

/// How labels stand to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Side by side: widths decide.
    Row,
    /// Vertical axis: a given mean distance in half rows; no two labels are closer than its whole rows.
    Column(u16),
    /// Vertical axis whose labels stand only at the middle of a row.
    Rows(u16),
}

impl Along {
    /// Half rows from one label to the next.
    fn half_rows(self) -> Option<u16> {
        match self {
            Self::Row => None,
            Self::Column(halves) | Self::Rows(halves) => Some(halves),
        }
    }
}

/// The ticks of an axis, as many as fit.
pub fn ticks(map: Mapping, along: Along) -> Ticks {
    if map.cells == 0 {
        return Ticks::default();
    }
    match map.scale {
        Scale::Linear => linear(map, along),
        Scale::Log10 => decades(map, along).unwrap_or_else(|| linear(map, along)),
    }
}

/// The first span of cells a label of this length takes when centred on a cell: the one rule for placing labels.
pub fn label_start(cell: i32, length: i32) -> i32 {
    cell - length / 2
}

fn linear(map: Mapping, along: Along) -> Ticks {
    let view = map.view;
    let greatest = view.lo().abs().max(view.hi().abs());
    let exponent = common_exponent(greatest);
    // No two labels next to each other are nearer than two cells, whatever they say.
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

/// The ends of an axis, in as few digits as keep their labels in their rows.
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
        // Both alike.
        for tick in labelled.iter_mut().filter(|tick| !tick.label.contains('e')) {
            tick.label =
                tick.label.parse().map_or_else(|_| tick.label.clone(), |it: f64| format!("{it:e}"));
        }
    }
    Ticks { labelled, exponent }
}

/// A number in so many digits, in plain decimals where that is short.
fn rounded(value: f64, digits: usize) -> String {
    let text = format!("{value:.*e}", digits - 1);
    let exact: f64 = text.parse().unwrap_or(value);
    let plain = format!("{exact}");
    if plain.len() <= text.len() + 1 { plain } else { text }
}

/// The multiples of a step in view, with the common power of ten factored out where that makes their labels shorter.
fn shorter(map: Mapping, step: Step, exponent: i32) -> Ticks {
    let ticks = |exponent| Ticks { labelled: multiples(map, step, exponent), exponent };
    let whole = ticks(0);
    if exponent == 0 {
        return whole;
    }
    let factored = ticks(exponent);
    if whole.width() <= factored.width() { whole } else { factored }
}

/// The multiples of a step in view. Counting whole steps keeps labels and places free of accumulated error.
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

/// A whole number of `10^exponent`, written with just the decimals that needs.
fn label(units: f64, exponent: i32) -> String {
    if units == 0.0 {
        return "0".to_owned();
    }
    let decimals = usize::try_from(-exponent).unwrap_or(0);
    // Dividing by a power of ten that is exact rounds once; multiplying by its inverse rounds twice.
    let value = if exponent < 0 { units / power(-exponent) } else { units * power(exponent) };
    format!("{value:.decimals$}")
}

/// Decade ticks, with 2 and 5 between them where there is room; `None` where fewer than three would be seen: a linear axis
/// tells more inside a decade.
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

/// These multiples of each power of ten whose exponent is a multiple of a number, as far as they are in view.
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

/// An axis upward whose labels are round numbers in the middle of their rows: its range, grown so that a round step is a whole
/// number of rows, and its ticks. Lines across at these values keep clear of labels of other values where they can. `None` for one row,
/// and for a logarithmic axis over too little for decades.
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
            // Rows without values are above, or below where nothing is above zero.
            let first = if high <= 0.0 && scale == Scale::Linear { end - last } else { first };
            // Divided last: a row's value comes out as it is written there.
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

/// Round steps that are at least a row, with their lengths in the space of the scale, as many as one axis may need.
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

/// Powers of ten a step apart; 2 and 5 times each, too, where they lie in the middle of rows and have room.
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

/// Rows wanted from one label to the next.
fn rows_apart(rows: u16) -> u16 {
    match rows {
        0..4 => 1,
        4..12 => 2,
        12..24 => 3,
        24.. => 4,
    }
}

/// Whether all labels stand clear of each other, each on a cell of its own. Of rows there are at least two, each at the middle of
/// its row.
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

/// The power of ten, a multiple of three, that keeps labels short: 0 from 0.001 to 99999.
fn common_exponent(greatest: f64) -> i32 {
    if (1e-3..1e5).contains(&greatest) { 0 } else { decade(greatest).div_euclid(3) * 3 }
}
