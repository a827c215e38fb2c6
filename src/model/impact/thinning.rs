//! Fewer rows of a series that show the same curves.

use crate::model::run::Sample;

/// The rows kept of a series: its first rows, and of the rest the envelope in each of a given number of equal intervals of time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Kept {
    pub(super) first: usize,
    pub(super) intervals: usize,
}

/// The quantities whose extremes are kept. The forces of spring and damper have theirs where displacement and velocity have.
const QUANTITIES: [fn(&Sample) -> f64; 6] = [
    |row| row.penetration_m,
    |row| row.projectile_velocity_m_s,
    |row| row.plate_displacement_m,
    |row| row.plate_velocity_m_s,
    |row| row.contact_force_n,
    |row| row.stop_force_n,
];

/// The rows that are kept: of each interval the first and the last, and those in which a quantity is least and greatest.
pub(super) fn thinned(series: &[Sample], kept: Kept) -> Vec<Sample> {
    let (first, rest) = series.split_at(series.len().min(kept.first));
    let mut rows = first.to_vec();
    let (Some(begin), Some(end)) = (rest.first(), rest.last()) else { return rows };
    let (begin_s, width_s) = (begin.t_s, (end.t_s - begin.t_s) / kept.intervals as f64);
    let mut from = 0;
    for interval in 1..=kept.intervals {
        let end_s = begin_s + width_s * interval as f64;
        let to = if interval == kept.intervals {
            rest.len()
        } else {
            from + rest[from..].partition_point(|row| row.t_s < end_s)
        };
        envelope(&rest[from..to], &mut rows);
        from = to;
    }
    rows
}

/// Add the rows of an interval that are kept, in their order.
fn envelope(rows: &[Sample], kept: &mut Vec<Sample>) {
    if rows.is_empty() {
        return;
    }
    let mut places = vec![0, rows.len() - 1];
    for quantity in QUANTITIES {
        let (mut least, mut most) = (0, 0);
        for (place, row) in rows.iter().enumerate() {
            let value = quantity(row);
            least = if value < quantity(&rows[least]) { place } else { least };
            most = if value > quantity(&rows[most]) { place } else { most };
        }
        places.extend([least, most]);
    }
    places.sort_unstable();
    places.dedup();
    kept.extend(places.into_iter().map(|place| rows[place]));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(t_s: f64, plate_displacement_m: f64) -> Sample {
        Sample { t_s, plate_displacement_m, ..Sample::default() }
    }

    /// A fast oscillation whose amplitude has one peak: begin, end, order, the peak and the envelope stay.
    #[test]
    fn thinning_keeps_the_first_rows_the_ends_and_the_envelope() {
        let value = |t: f64| (40.0 * t).sin() * (1.0 + (-(t - 60.0).powi(2)).exp());
        let series: Vec<Sample> =
            (0..100_000u32).map(|i| f64::from(i) * 1e-3).map(|t| row(t, value(t))).collect();
        let rows = thinned(&series, Kept { first: 500, intervals: 100 });
        assert_eq!(rows[..500], series[..500]);
        assert!(rows.len() < 500 + 100 * 4 + 1, "{}", rows.len());
        assert_eq!(rows.last(), series.last());
        assert!(rows.windows(2).all(|pair| pair[0].t_s < pair[1].t_s));
        let greatest = |rows: &[Sample]| {
            rows.iter().map(|row| row.plate_displacement_m).fold(f64::NEG_INFINITY, f64::max)
        };
        assert_eq!(greatest(&rows).to_bits(), greatest(&series).to_bits());
        // Two seconds hold at least one whole interval, and that its greatest value.
        for second in 1..98 {
            let from = f64::from(second);
            let within = |row: &&Sample| (from..from + 2.0).contains(&row.t_s);
            let kept: Vec<Sample> = rows.iter().filter(within).copied().collect();
            assert!(greatest(&kept) > 0.99, "{second} s");
        }
        assert_eq!(thinned(&series[..400], Kept { first: 500, intervals: 100 }), series[..400]);
    }
}
