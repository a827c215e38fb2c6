//! Quantities for the charts of a run: name, symbol, unit and source.

use crate::report::law::Law;
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::run::{ContactMode, Run, Sample};
use cmra_engine::model::scene::Scene;

/// Maximum number of points that are drawn without thinning.
const POINTS_MANY: usize = 16_384;
/// Number of equal time intervals for thinned points; exceeds the number of dot columns of the widest screen.
const TIMES: f64 = 4_096.0;

/// Source of a quantity's values, and the horizontal axis.
#[derive(Clone, Copy)]
pub enum Source {
    /// Samples over time.
    Time(fn(&Sample) -> f64),
    /// Samples of a scene over time.
    SceneTime(fn(&Scene, &Sample) -> f64),
    /// Samples over the plate displacement.
    Displacement(fn(&Sample) -> f64),
    /// Law of the mechanism over the plate displacement.
    Law(fn(&Law, f64) -> f64),
}

enumeration! {
    /// Quantity of the series, in the order of the key `v`.
    pub enum Channel in Row {
        /// Name in chart titles.
        title: &'static str,
        /// Symbol in readouts.
        symbol: &'static str,
        /// SI unit.
        unit: &'static str,
        /// Source of the values.
        source: Source,
    }
    /// Depth of the nose in the plate.
    Penetration { title: "Penetration", symbol: "p", unit: "m", source: Source::Time(|it| it.penetration_m) }
    /// Plate displacement from neutral.
    PlateDisplacement { title: "Plate displacement", symbol: "x", unit: "m", source: Source::Time(|it| it.plate_displacement_m) }
    /// Force between projectile and plate.
    ContactForce { title: "Contact force", symbol: "F", unit: "N", source: Source::Time(|it| it.contact_force_n) }
    /// Projectile velocity.
    ProjectileVelocity { title: "Projectile velocity", symbol: "v", unit: "m/s", source: Source::Time(|it| it.projectile_velocity_m_s) }
    /// Plate velocity.
    PlateVelocity { title: "Plate velocity", symbol: "w", unit: "m/s", source: Source::Time(|it| it.plate_velocity_m_s) }
    /// Spring force on the mount.
    SpringForce { title: "Spring force", symbol: "F_spring", unit: "N", source: Source::Time(|it| it.spring_force_n) }
    /// Damper force on the mount.
    DamperForce { title: "Damper force", symbol: "F_damper", unit: "N", source: Source::Time(|it| it.damper_force_n) }
    /// Projectile displacement since first contact.
    ProjectileDisplacement { title: "Projectile displacement", symbol: "s", unit: "m", source: Source::Time(|it| it.projectile_displacement_m) }
    /// Force on the mount over time.
    MountForceOverTime { title: "Mount force", symbol: "F_mount", unit: "N", source: Source::Time(Sample::mount_force_n) }
    /// Acceleration of the projectile along its axis; negative for a deceleration.
    Acceleration {
        title: "Projectile acceleration", symbol: "a", unit: "m/s2",
        source: Source::SceneTime(|scene, it| -it.contact_force_n / scene.projectile.mass_kg)
    }
    /// Force on the mount.
    MountForce {
        title: "Mount force over displacement", symbol: "F(x)", unit: "N",
        source: Source::Displacement(Sample::mount_force_n)
    }
    /// Stiffness of springs and elastic stop.
    Stiffness { title: "Stiffness over displacement", symbol: "dF/dx", unit: "N/m", source: Source::Law(Law::stiffness) }
    /// Maximum stress of the springs over their yield strength.
    Stress { title: "Stress over yield strength", symbol: "stress/yield", unit: "", source: Source::Law(Law::stress) }
}

impl Channel {
    /// Returns the title without the horizontal axis, for a chart that labels it.
    pub fn name(self) -> &'static str {
        match self {
            Self::MountForce => Self::MountForceOverTime.title(),
            Self::Stiffness => "Stiffness",
            _ => self.title(),
        }
    }

    /// Returns `true` if the horizontal axis is time; `false` if it is the plate displacement.
    pub fn is_over_time(self) -> bool {
        matches!(self.source(), Source::Time(_) | Source::SceneTime(_))
    }

    /// Returns the points of a quantity for samples of a run, SI, with a gap while the projectile is out of the plate. The law of the
    /// mechanism covers all displacements.
    pub fn points(self, run: &Run, samples: &[Sample]) -> Vec<(f64, f64)> {
        match self.source() {
            Source::Time(_) | Source::SceneTime(_) => {
                let value =
                    |it| if self.exists_in(it) { self.value(&run.scene, it) } else { f64::NAN };
                samples.iter().map(|sample| (sample.t_s, value(sample))).collect()
            }
            Source::Displacement(get) => {
                let point = |sample: &Sample| (sample.plate_displacement_m, get(sample));
                samples.iter().map(point).collect()
            }
            Source::Law(get) => Law::from_run(run).map_or_else(Vec::new, |law| law.points(get)),
        }
    }

    /// Returns `true` if the quantity exists in a sample; the depth does not once the projectile has left the plate.
    fn exists_in(self, sample: &Sample) -> bool {
        let is_out = sample.penetration_m < 0.0 || sample.mode == ContactMode::Perforated;
        self != Self::Penetration || !is_out
    }

    /// Returns the value in a sample of a scene, SI; NaN for a quantity that samples do not contain.
    pub fn value(self, scene: &Scene, sample: &Sample) -> f64 {
        match self.source() {
            Source::SceneTime(get) => get(scene, sample),
            Source::Time(get) | Source::Displacement(get) => get(sample),
            Source::Law(_) => f64::NAN,
        }
    }

    /// Returns the value at a time of a run, linear between samples; after a jump, at its time. `None` outside the series, and for a depth
    /// out of the plate.
    pub fn at(self, run: &Run, t_s: f64) -> Option<f64> {
        if let Source::Law(get) = self.source() {
            let x_m = Self::PlateDisplacement.at(run, t_s)?;
            return Some(get(&Law::from_run(run)?, x_m)).filter(|value| value.is_finite());
        }
        let after = run.series.partition_point(|sample| sample.t_s <= t_s);
        let before = run.series.get(after.checked_sub(1)?).filter(|it| self.exists_in(it))?;
        let Some(next) = run.series.get(after) else {
            return (t_s <= before.t_s).then(|| self.value(&run.scene, before));
        };
        let (low, high) = (self.value(&run.scene, before), self.value(&run.scene, next));
        let width = next.t_s - before.t_s;
        let fraction = if width > 0.0 { (t_s - before.t_s) / width } else { 0.0 };
        Some(low + fraction * (high - low))
    }

    /// Explains why a run of a scene lacks the quantity; `None` if it does not.
    pub fn absence(self, scene: &Scene) -> Option<&'static str> {
        let mechanism = Mechanism::from_scene(scene);
        let is_sprung = !mechanism.spring.is_absent();
        let (there, absent) = match self {
            Self::SpringForce => (is_sprung, "no spring"),
            Self::DamperForce => (!mechanism.damper.is_absent(), "no damper"),
            Self::MountForce | Self::MountForceOverTime => {
                (!mechanism.is_absent() || mechanism.stop.is_some(), "no mechanism")
            }
            Self::Stiffness => (is_sprung || mechanism.elastic_stop().is_some(), "no spring"),
            Self::Stress => (
                is_sprung && scene.mechanism.spring.yields_at_m().is_some(),
                "no spring with a yield strength",
            ),
            _ => (true, ""),
        };
        (!there).then_some(absent)
    }

    /// Returns the next quantity, cyclically.
    #[must_use]
    pub fn next(self) -> Self {
        let at = Self::ALL.iter().position(|one| *one == self).unwrap_or(0);
        Self::ALL[(at + 1) % Self::ALL.len()]
    }
}

/// Returns the state of a run at a time, linear between the rows of its series. Velocities are constant after the last row. Returns the
/// state after a jump at its time. `None` without a series.
pub fn state_at(run: &Run, t_s: f64) -> Option<Sample> {
    let after = run.series.partition_point(|sample| sample.t_s <= t_s);
    let before = run.series[after.saturating_sub(1)..].first()?;
    let Some(next) = run.series.get(after.max(1)) else {
        let left_s = t_s - before.t_s;
        let (v, w) = (before.projectile_velocity_m_s, before.plate_velocity_m_s);
        let apart_m_s = v - w * run.scene.cos_obliquity();
        return Some(Sample {
            t_s,
            penetration_m: before.penetration_m + left_s * apart_m_s,
            projectile_displacement_m: before.projectile_displacement_m + left_s * v,
            plate_displacement_m: before.plate_displacement_m + left_s * w,
            ..*before
        });
    };
    let width_s = next.t_s - before.t_s;
    let fraction = if width_s > 0.0 { ((t_s - before.t_s) / width_s).clamp(0.0, 1.0) } else { 0.0 };
    let mix = |get: fn(&Sample) -> f64| get(before) + fraction * (get(next) - get(before));
    Some(Sample {
        t_s,
        mode: before.mode,
        penetration_m: mix(|row| row.penetration_m),
        projectile_displacement_m: mix(|row| row.projectile_displacement_m),
        projectile_velocity_m_s: mix(|row| row.projectile_velocity_m_s),
        plate_displacement_m: mix(|row| row.plate_displacement_m),
        plate_velocity_m_s: mix(|row| row.plate_velocity_m_s),
        contact_force_n: mix(|row| row.contact_force_n),
        spring_force_n: mix(|row| row.spring_force_n),
        damper_force_n: mix(|row| row.damper_force_n),
        stop_force_n: mix(|row| row.stop_force_n),
    })
}

/// Reduces points for drawing over a linear time axis without visible change.
///
/// Time is divided into equal intervals, more than a screen has columns of dots. The first, lowest, highest and last points of each
/// interval are kept, and the ends of gaps. Input and output are in order of time.
pub fn thinned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if points.len() <= POINTS_MANY { points } else { thinned_to(&points, TIMES) }
}

/// Thins points to a number of equal intervals of time.
pub(crate) fn thinned_to(points: &[(f64, f64)], parts: f64) -> Vec<(f64, f64)> {
    let [first, .., last] = points else { return points.to_vec() };
    let cell = |point: &(f64, f64)| ((point.0 - first.0) / (last.0 - first.0) * parts).floor();
    let mut few = Vec::new();
    for short in points.chunk_by(|a, b| cell(a).total_cmp(&cell(b)).is_eq()) {
        let gaps = short.iter().filter(|point| !point.1.is_finite()).count();
        if gaps > 0 && gaps < short.len() || short.len() <= 4 {
            few.extend(short);
            continue;
        }
        let (mut lowest, mut highest) = (0, 0);
        for (index, point) in short.iter().enumerate() {
            if point.1 < short[lowest].1 {
                lowest = index;
            } else if point.1 > short[highest].1 {
                highest = index;
            }
        }
        let kept = [0, lowest.min(highest), lowest.max(highest), short.len() - 1];
        few.extend(kept.map(|index| short[index]));
    }
    few
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::run_with;
    use crate::study::testing::scene;
    use cmra_engine::model::simulate::Settings;

    /// After the arrest projectile and plate move together on the spring. With equal masses the projectile takes half of the spring force k
    /// x.
    #[test]
    fn valid_the_contact_force_falls_at_the_first_arrest() {
        let scene = scene("k=1e5");
        let run = run_with(&scene, Settings::SERIES).unwrap();
        let arrest = run.first_arrest.unwrap();
        let points = Channel::ContactForce.points(&run, &run.series);
        let is_event = |point: &&(f64, f64)| point.0.to_bits() == arrest.t_s.to_bits();
        let at_event: Vec<f64> =
            points.iter().filter(|point| is_event(point)).map(|point| point.1).collect();
        let after = 0.5 * scene.mechanism.spring.coefficient * arrest.plate_displacement_m;
        assert_eq!(at_event.len(), 2);
        assert!((at_event[0] - run.peak_contact_force_n.unwrap()).abs() < 1e-6 * at_event[0]);
        assert!((at_event[1] - after).abs() < 1e-3 * after, "{at_event:?} {after}");
    }

    #[test]
    fn thinned_points_keep_ends_a_spike_a_gap_and_distant_points() {
        // Sine with a spike and a gap: a million points in one second, then ten points one second apart.
        let (spike, gap) = (654_321, 700_000..800_000);
        let value = |index: usize| match index {
            _ if index == spike => 5.0,
            _ if gap.contains(&index) => f64::NAN,
            _ => (0.01 * index as f64).sin(),
        };
        let mut points: Vec<_> =
            (0..1_000_000).map(|index| (1e-6 * index as f64, value(index))).collect();
        points.extend((1..=10).map(|second| (f64::from(second), f64::from(second % 2))));
        let few = thinned(points.clone());
        assert!(few.len() <= 4 * 4_096, "{} points", few.len());
        assert!(few.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        assert_eq!(
            (few[0], few[few.len() - 10..].to_vec()),
            (points[0], points[1_000_000..].to_vec())
        );
        for kept in [spike, gap.start - 1, gap.end] {
            assert!(few.contains(&points[kept]), "point {kept}");
        }
        let gaps = few.iter().filter(|point| point.1.is_nan());
        let (low, high) = (points[gap.start].0, points[gap.end - 1].0);
        assert!(gaps.map(|point| point.0).all(|t_s| (low..=high).contains(&t_s)));
    }
}
