//! What a chart of a run can show: name, symbol, unit, and where it is found in a sample.

use crate::model::run::{Run, Sample};

/// A quantity of the series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Depth of the nose in the plate.
    Penetration,
    /// Plate displacement from neutral.
    PlateDisplacement,
    /// Force between projectile and plate.
    ContactForce,
    /// Projectile velocity.
    ProjectileVelocity,
    /// Plate velocity.
    PlateVelocity,
    /// Spring force on the mount.
    SpringForce,
    /// Damper force on the mount.
    DamperForce,
    /// Projectile displacement since first contact.
    ProjectileDisplacement,
    /// Force on the mount, over the plate's displacement in place of time.
    MountForce,
}

struct Row {
    title: &'static str,
    symbol: &'static str,
    unit: &'static str,
    get: fn(&Sample) -> f64,
}

impl Quantity {
    /// All quantities, in the order `v` goes through them.
    pub const ALL: [Self; 9] = [
        Self::Penetration,
        Self::PlateDisplacement,
        Self::ContactForce,
        Self::ProjectileVelocity,
        Self::PlateVelocity,
        Self::SpringForce,
        Self::DamperForce,
        Self::ProjectileDisplacement,
        Self::MountForce,
    ];

    fn row(self) -> Row {
        let row = |title, symbol, unit, get| Row { title, symbol, unit, get };
        match self {
            Self::Penetration => row("Penetration", "p", "m", |it| it.penetration_m),
            Self::PlateDisplacement => {
                row("Plate displacement", "x", "m", |it| it.plate_displacement_m)
            }
            Self::ContactForce => row("Contact force", "F", "N", |it| it.contact_force_n),
            Self::ProjectileVelocity => {
                row("Projectile velocity", "v", "m/s", |it| it.projectile_velocity_m_s)
            }
            Self::PlateVelocity => row("Plate velocity", "w", "m/s", |it| it.plate_velocity_m_s),
            Self::SpringForce => row("Spring force", "F_spring", "N", |it| it.spring_force_n),
            Self::DamperForce => row("Damper force", "F_damper", "N", |it| it.damper_force_n),
            Self::ProjectileDisplacement => {
                row("Projectile displacement", "s", "m", |it| it.projectile_displacement_m)
            }
            Self::MountForce => row("Mount force over displacement", "F(x)", "N", |it| {
                it.spring_force_n + it.damper_force_n + it.stop_force_n
            }),
        }
    }

    /// The name for chart titles.
    pub fn title(self) -> &'static str {
        self.row().title
    }

    /// The symbol for readouts.
    pub fn symbol(self) -> &'static str {
        self.row().symbol
    }

    /// The SI unit.
    pub fn unit(self) -> &'static str {
        self.row().unit
    }

    /// The value to draw: as [`Quantity::of`], and a gap while the projectile is out of the plate and has no depth in it.
    pub fn drawn(self, sample: &Sample) -> f64 {
        match self.of(sample) {
            depth if self == Self::Penetration && depth < 0.0 => f64::NAN,
            value => value,
        }
    }

    /// The value in a sample, SI.
    pub fn of(self, sample: &Sample) -> f64 {
        (self.row().get)(sample)
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
