//! Where an axis has ticks and what is written at them: 1-2-5 steps, decades on a logarithmic axis, as many as fit.
//!
//! A tick knows its cell from the same [`Mapping`] the curves use, and its label is centred on that cell. What is common to
//! all labels (a power of ten) is factored out. Rows of a terminal are coarse: a value is labelled there only where it lies near the
//! middle of a row, and where no two round values do, the ends of the axis are.

use super::scale::{Mapping, Scale};
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
/// Ticks looked at for one step; more would never fit.
const TICKS_LOOKED_AT: usize = 512;

/// One tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Cell from the start of the axis.
    pub cell: u16,
    /// Its value, in the unit shown.
    pub value: f64,
    /// Its label.
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
    /// One above the other: a given number of half rows apart on average, and no two nearer than the whole rows in that.
    Column(u16),
    /// The same where a label can stand in the middle of a row only.
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
    let first = decade(map.view.lo());
    let last = decade(map.view.hi());
    let (low, high) = (map.view.lo() * (1.0 - 1e-9), map.view.hi() * (1.0 + 1e-9));
    let list = |mantissas: &[u8], every: i32| -> Vec<Tick> {
        let exponents = (first..=last).filter(|exponent| exponent % every == 0);
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
    };
    let dense = list(&[1, 2, 5], 1);
    if dense.len() < 3 {
        return None;
    }
    if fits(&dense, along, map) {
        return Some(Ticks { labelled: dense, exponent: 0 });
    }
    let decades = [1, 2, 3, 5, 10, 20, 50, 100, 200];
    let mut found = decades.into_iter().map(|every| list(&[1], every));
    let labelled = found.find(|ticks| !ticks.is_empty() && fits(ticks, along, map))?;
    Some(Ticks { labelled, exponent: 0 })
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
