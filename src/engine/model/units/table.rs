//! The units of every kind of quantity, by their definitions: the international yard and pound of 1959, and 9.80665 m/s^2.

use super::Prefix;

/// One way of writing a quantity: one of it is `times / over` in the stored unit. Both are whole numbers where the definition
/// allows it, so that `25.4mm` and `3in` are the floats nearest to 0.0254 and 0.0762.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    pub(super) name: &'static str,
    pub(super) times: f64,
    pub(super) over: f64,
}

/// The stored unit.
pub(super) const STORED: Unit = of("", 1.0);

/// A unit that holds this many of the stored one.
const fn of(name: &'static str, times: f64) -> Unit {
    Unit { name, times, over: 1.0 }
}

/// A unit that is a fraction of the stored one.
const fn ratio(name: &'static str, times: f64, over: f64) -> Unit {
    Unit { name, times, over }
}

/// The stored unit with a prefix before it.
pub(super) fn prefixed(prefix: Prefix) -> Unit {
    if prefix.size < 1.0 { ratio("", 1.0, prefix.in_one) } else { of("", prefix.size) }
}

const DEG_PER_RAD: f64 = 180.0 / std::f64::consts::PI;

/// A pound-force is 4.4482216152605 N exactly: 0.45359237 kg times 9.80665 m/s^2. A given number of N, times [`LBF_OVER`].
const LBF: f64 = 44_482_216_152_605.0;
const LBF_OVER: f64 = 1e13;

pub(super) const NUMBER_UNITS: &[Unit] = &[of("", 1.0), ratio("%", 1.0, 1e2)];
pub(super) const ANGLE_UNITS: &[Unit] =
    &[of("deg", 1.0), of("rad", DEG_PER_RAD), ratio("mrad", DEG_PER_RAD, 1e3)];
pub(super) const MASS_UNITS: &[Unit] = &[
    of("kg", 1.0),
    ratio("g", 1.0, 1e3),
    ratio("mg", 1.0, 1e6),
    of("t", 1e3),
    ratio("gr", 6_479_891.0, 1e11),
    ratio("oz", 45_359_237.0, 16e8),
    ratio("lb", 45_359_237.0, 1e8),
];
pub(super) const LENGTH_UNITS: &[Unit] = &[
    of("m", 1.0),
    ratio("mm", 1.0, 1e3),
    ratio("cm", 1.0, 1e2),
    ratio("um", 1.0, 1e6),
    ratio("nm", 1.0, 1e9),
    of("km", 1e3),
    ratio("in", 254.0, 1e4),
    ratio("ft", 3048.0, 1e4),
    ratio("mil", 254.0, 1e7),
];
pub(super) const VELOCITY_UNITS: &[Unit] = &[
    of("m/s", 1.0),
    ratio("mm/s", 1.0, 1e3),
    of("km/s", 1e3),
    ratio("km/h", 10.0, 36.0),
    ratio("ft/s", 3048.0, 1e4),
    ratio("fps", 3048.0, 1e4),
    ratio("kfps", 3048.0, 10.0),
    ratio("mph", 44_704.0, 1e5),
];
pub(super) const DENSITY_UNITS: &[Unit] = &[
    of("kg/m3", 1.0),
    of("kg/m^3", 1.0),
    of("g/cm3", 1e3),
    of("g/cm^3", 1e3),
    of("t/m3", 1e3),
    of("t/m^3", 1e3),
    ratio("lb/in3", 453_592_370_000.0, 16_387_064.0),
];
pub(super) const PRESSURE_UNITS: &[Unit] = &[
    of("Pa", 1.0),
    of("kPa", 1e3),
    of("MPa", 1e6),
    of("GPa", 1e9),
    of("N/mm2", 1e6),
    of("N/mm^2", 1e6),
    of("bar", 1e5),
    of("kbar", 1e8),
    // A square inch is 6.4516e-4 m^2.
    ratio("psi", LBF, 6.4516e9),
    ratio("ksi", LBF, 6.4516e6),
    ratio("Msi", LBF, 6.4516e3),
];
pub(super) const TIME_UNITS: &[Unit] = &[
    of("s", 1.0),
    ratio("ms", 1.0, 1e3),
    ratio("us", 1.0, 1e6),
    ratio("ns", 1.0, 1e9),
    of("min", 60.0),
];
pub(super) const FORCE_UNITS: &[Unit] =
    &[of("N", 1.0), of("kN", 1e3), of("MN", 1e6), ratio("lbf", LBF, LBF_OVER)];
pub(super) const IMPULSE_UNITS: &[Unit] = &[
    of("N s", 1.0),
    of("Ns", 1.0),
    of("kN s", 1e3),
    of("kNs", 1e3),
    ratio("lbf s", LBF, LBF_OVER),
];
pub(super) const ENERGY_UNITS: &[Unit] = &[
    of("J", 1.0),
    of("kJ", 1e3),
    of("MJ", 1e6),
    ratio("mJ", 1.0, 1e3),
    // A foot is 0.3048 m.
    ratio("ft lbf", 3048e-4 * LBF, LBF_OVER),
];
pub(super) const STIFFNESS_UNITS: &[Unit] = &[
    of("N/m", 1.0),
    of("kN/m", 1e3),
    of("MN/m", 1e6),
    of("GN/m", 1e9),
    of("N/mm", 1e3),
    of("kN/mm", 1e6),
    ratio("lbf/in", LBF, 2.54e11),
];
pub(super) const DAMPING_UNITS: &[Unit] = &[
    of("N s/m", 1.0),
    of("Ns/m", 1.0),
    of("kN s/m", 1e3),
    of("kNs/m", 1e3),
    of("MN s/m", 1e6),
    of("MNs/m", 1e6),
    ratio("lbf s/in", LBF, 2.54e11),
];
pub(super) const SPECIFIC_ENERGY_UNITS: &[Unit] =
    &[of("J/kg", 1.0), of("kJ/kg", 1e3), of("MJ/kg", 1e6), of("J/g", 1e3)];
pub(super) const TWIST_UNITS: &[Unit] = &[
    of("rad/m", 1.0),
    of("rad/mm", 1e3),
    ratio("deg/m", 1.0, DEG_PER_RAD),
    ratio("deg/mm", 1e3, DEG_PER_RAD),
];
pub(super) const AREAL_MASS_UNITS: &[Unit] = &[
    of("kg/m2", 1.0),
    of("kg/m^2", 1.0),
    of("g/cm2", 10.0),
    of("g/cm^2", 10.0),
    // A square foot is 0.09290304 m^2.
    ratio("lb/ft2", 45_359_237.0, 9_290_304.0),
];
pub(super) const INERTIA_UNITS: &[Unit] = &[
    of("kg m2", 1.0),
    of("kg m^2", 1.0),
    ratio("kg cm2", 1.0, 1e4),
    ratio("kg mm2", 1.0, 1e6),
    ratio("g cm2", 1.0, 1e7),
    ratio("g mm2", 1.0, 1e9),
];
