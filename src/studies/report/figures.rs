//! Pictures of a run and of sweeps, and the axes and maps of a sweep.

use std::borrow::Cow;

use crate::report::chart::levels::Levels;
use crate::report::chart::{Axis, Scale, Unit, ViewRange};
use crate::report::map::{Cell, Map};
use crate::study::sweep::{self, Spacing};

pub mod impact;
pub mod run;
pub mod sweeps;

/// Ratio of the values of a list above which its axis is logarithmic.
const WIDE: f64 = 30.0;
/// Cells of a map along an axis with listed values.
const LIST_CELLS: u32 = 60;

/// Converts an axis of a sweep to an axis of a picture.
pub fn axis_of(axis: &sweep::Axis) -> Axis<'static> {
    let (from, to) = axis.ends();
    let view = ViewRange::new(from, to);
    let unit = Unit::with_prefix(view.size(), axis.variable().unit());
    Axis::new(axis.symbol(), view).scale(scale_of(axis)).unit(unit)
}

/// Creates a map over two axes of a sweep from the cells of its points.
pub fn map_over(
    title: impl Into<Cow<'static, str>>,
    x: &sweep::Axis,
    y: &sweep::Axis,
    levels: Option<Levels>,
    cell: impl Fn(usize, usize) -> Cell,
) -> Map<'static> {
    let (across, up) = (places(x), places(y));
    let counts = (across.len(), up.len());
    let cell = |column: usize, row: usize| cell(across[column], up[row]);
    Map::new(title, (axis_of(x), axis_of(y)), counts, levels, cell)
}

/// Returns the column of a map that shows a point of an axis.
pub fn column_of(axis: &sweep::Axis, point: usize) -> Option<usize> {
    places(axis).iter().position(|at| *at == point)
}

fn scale_of(axis: &sweep::Axis) -> Scale {
    let (from, to) = axis.ends();
    match axis.spacing() {
        Spacing::Log => Scale::Log10,
        Spacing::Listed if from > 0.0 && to > WIDE * from => Scale::Log10,
        Spacing::Linear | Spacing::Listed => Scale::Linear,
    }
}

/// Returns the point displayed in each cell of a map, in ascending order of the axis; for a list, the nearest point.
fn places(axis: &sweep::Axis) -> Vec<usize> {
    let index = |at: u64| usize::try_from(at).unwrap_or(usize::MAX);
    let (from, to) = axis.ends();
    if axis.spacing() != Spacing::Listed {
        let rising = 0..index(axis.count());
        return if from > to { rising.rev().collect() } else { rising.collect() };
    }
    let scale = scale_of(axis);
    let (low, high) = (scale.place(from), scale.place(to));
    let gap = |at: u64, cell: u32| {
        let place = low + (high - low) * f64::from(cell) / f64::from(LIST_CELLS - 1);
        (scale.place(axis.value(at)) - place).abs()
    };
    let nearest =
        |cell: u32| (0..axis.count()).min_by(|a, b| gap(*a, cell).total_cmp(&gap(*b, cell)));
    (0..LIST_CELLS).map(|cell| index(nearest(cell).unwrap_or(0))).collect()
}
