//! What a chart of a run can show: name, symbol, unit, and where it is found in a sample.

use crate::model::run::{Run, Sample};

enumeration! {
    /// A quantity of the series, in the order `v` goes through them.
    pub enum Quantity in Row {
        /// The name for chart titles.
        title: &'static str,
        /// The symbol for readouts.
        symbol: &'static str,
        /// The SI unit.
        unit: &'static str,
        /// Where it is found in a sample.
        get: fn(&Sample) -> f64,
    }
    /// Depth of the nose in the plate.
    Penetration { title: "Penetration", symbol: "p", unit: "m", get: |it| it.penetration_m }
    /// Plate displacement from neutral.
    PlateDisplacement { title: "Plate displacement", symbol: "x", unit: "m", get: |it| it.plate_displacement_m }
    /// Force between projectile and plate.
    ContactForce { title: "Contact force", symbol: "F", unit: "N", get: |it| it.contact_force_n }
    /// Projectile velocity.
    ProjectileVelocity { title: "Projectile velocity", symbol: "v", unit: "m/s", get: |it| it.projectile_velocity_m_s }
    /// Plate velocity.
    PlateVelocity { title: "Plate velocity", symbol: "w", unit: "m/s", get: |it| it.plate_velocity_m_s }
    /// Spring force on the mount.
    SpringForce { title: "Spring force", symbol: "F_spring", unit: "N", get: |it| it.spring_force_n }
    /// Damper force on the mount.
    DamperForce { title: "Damper force", symbol: "F_damper", unit: "N", get: |it| it.damper_force_n }
    /// Projectile displacement since first contact.
    ProjectileDisplacement { title: "Projectile displacement", symbol: "s", unit: "m", get: |it| it.projectile_displacement_m }
    /// Force on the mount, over the plate's displacement in place of time.
    MountForce {
        title: "Mount force over displacement", symbol: "F(x)", unit: "N",
        get: |it| it.spring_force_n + it.damper_force_n + it.stop_force_n
    }
}

impl Quantity {
    /// The value to draw: as [`Quantity::of`], and a gap while the projectile is out of the plate and has no depth in it.
    pub fn drawn(self, sample: &Sample) -> f64 {
        match self.of(sample) {
            depth if self == Self::Penetration && depth < 0.0 => f64::NAN,
            value => value,
        }
    }

    /// The value in a sample, SI.
    pub fn of(self, sample: &Sample) -> f64 {
        self.get()(sample)
    }

    /// The value in a run at a time, linear between samples; `None` outside the series. At a jump the value after it.
    pub fn at(self, run: &Run, t_s: f64) -> Option<f64> {
        let after = run.series.partition_point(|sample| sample.t_s <= t_s);
        let before = run.series.get(after.checked_sub(1)?)?;
        let Some(next) = run.series.get(after) else {
            return (t_s <= before.t_s).then(|| self.of(before));
        };
        let (low, high) = (self.of(before), self.of(next));
        let width = next.t_s - before.t_s;
        let share = if width > 0.0 { (t_s - before.t_s) / width } else { 0.0 };
        Some(low + share * (high - low))
    }

    /// The next quantity, round and round.
    #[must_use]
    pub fn next(self) -> Self {
        let at = Self::ALL.iter().position(|one| *one == self).unwrap_or(0);
        Self::ALL[(at + 1) % Self::ALL.len()]
    }
}
