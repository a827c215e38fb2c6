//! The numbers of contacts in parallel: one row for each quantity, one column for each lane.

use pulp::Simd;

use crate::model::contact_kernel::expansion::Constants;
use crate::numerics::wide::Wide;

/// Lanes of the widest vectors that are used.
pub(super) const LANES_MAX: usize = 4;
/// Whether vectors of this kind are worth lanes: otherwise contacts are done one by one.
pub(super) const fn has_lanes<S: Simd>() -> bool {
    S::F64_LANES > 1 && S::F64_LANES <= LANES_MAX
}

/// Rows that [`Constants`] take.
pub(super) const CONSTANTS: usize = 6;

/// The numbers of the contacts in the lanes.
#[repr(align(32))]
pub(super) struct LaneBuffer<const ROWS: usize>(pub(super) [[f64; LANES_MAX]; ROWS]);

impl<const ROWS: usize> LaneBuffer<ROWS> {
    /// Ones: what a lane without a contact computes is not used.
    pub(super) fn idle() -> Self {
        Self([[1.0; LANES_MAX]; ROWS])
    }

    #[inline(always)]
    pub(super) fn wide<S: Simd>(&self, simd: S, row: usize) -> Wide<S> {
        Wide::load(simd, &self.0[row])
    }

    #[inline(always)]
    pub(super) fn wides<S: Simd, const K: usize>(&self, simd: S, row: usize) -> [Wide<S>; K] {
        std::array::from_fn(|k| self.wide(simd, row + k))
    }

    #[inline(always)]
    pub(super) fn store<S: Simd, const K: usize>(&mut self, row: usize, numbers: [Wide<S>; K]) {
        for (row, number) in self.0[row..].iter_mut().zip(numbers) {
            number.store(row);
        }
    }

    pub(super) fn put<const K: usize>(&mut self, lane: usize, row: usize, numbers: [f64; K]) {
        for (row, number) in self.0[row..].iter_mut().zip(numbers) {
            row[lane] = number;
        }
    }

    pub(super) fn of<const K: usize>(&self, lane: usize, row: usize) -> [f64; K] {
        std::array::from_fn(|k| self.0[row + k][lane])
    }

    pub(super) fn put_constants(&mut self, lane: usize, row: usize, constants: &Constants) {
        let Constants { strength_pa, drag_kg_m3, slip_mobility, plate_mobility, cos, velocity_m_s } =
            *constants;
        let constants = [strength_pa, drag_kg_m3, slip_mobility, plate_mobility, cos, velocity_m_s];
        self.put::<CONSTANTS>(lane, row, constants);
    }

    #[inline(always)]
    pub(super) fn constants<S: Simd>(&self, simd: S, row: usize) -> Constants<Wide<S>> {
        let [strength_pa, drag_kg_m3, slip_mobility, plate_mobility, cos, velocity_m_s] =
            self.wides::<S, CONSTANTS>(simd, row);
        Constants { strength_pa, drag_kg_m3, slip_mobility, plate_mobility, cos, velocity_m_s }
    }
}
