//! Dimensions and their units, by definition: the international yard and pound of 1959, and 9.80665 m/s².

/// Defines the dimensions. Each has a stored unit, also the unit of bare numbers, a unit for screens, an example, and the accepted units.
macro_rules! dimensions {
    ($($(#[$doc:meta])* $kind:ident = $unit:literal, $shown:literal, $example:literal, $accepted:literal;)+) => {
        /// Dimension of a quantity; determines its units.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Dimension {
            $(#[doc = concat!("`", $unit, "`")] $(#[$doc])* $kind,)+
        }

        const ROWS: &[[&str; 4]] = &[$([$unit, $shown, $example, $accepted]),+];
    };
}

dimensions! {
    Number = "", "", "1.5", "%";
    Mass = "kg", "g", "29.5g", "kg, g, mg, t, gr, oz, lb";
    Length = "m", "mm", "25.4mm", "m, mm, cm, um, nm, km, in, ft, mil";
    Velocity = "m/s", "m/s", "100 m/s", "m/s, mm/s, km/s, km/h, ft/s, fps, kfps, mph";
    /// (the SI unit is rad; angles are stored in degrees)
    Angle = "deg", "deg", "30deg", "deg, rad, mrad";
    Density = "kg/m3", "kg/m3", "2710 kg/m3", "kg/m3, kg/m^3, g/cm3, g/cm^3, t/m3, t/m^3, lb/in3, lb/ft3";
    Pressure = "Pa", "MPa", "151.6 MPa", "Pa, kPa, MPa, GPa, N/mm2, N/mm^2, bar, kbar, psi, ksi, Msi";
    Time = "s", "ms", "150 us", "s, ms, us, ns, min";
    Force = "N", "kN", "19kN", "N, kN, MN, lbf";
    Impulse = "N s", "N s", "12 N s", "N s, Ns, kN s, kNs, lbf s";
    Energy = "J", "J", "1.5kJ", "J, kJ, MJ, mJ, ft lbf";
    SpecificEnergy = "J/kg", "J/kg", "20kJ/kg", "J/kg, kJ/kg, MJ/kg, J/g";
    Stiffness = "N/m", "kN/m", "7.5MN/m", "N/m, kN/m, MN/m, GN/m, N/mm, kN/mm, lbf/in";
    Damping = "N s/m", "N s/m", "2 kN s/m", "N s/m, Ns/m, kN s/m, kNs/m, MN s/m, MNs/m, lbf s/in";
    /// Dimension that depends on an exponent; the units are those of the linear spring.
    SpringCoefficient = "N/m^n", "kN/m^n", "7.5MN/m", "N/m, kN/m, MN/m, GN/m, N/mm, kN/mm, lbf/in";
    /// Dimension that depends on an exponent; the units are those of the linear damper.
    DamperCoefficient = "N(s/m)^m", "N(s/m)^m", "2 kN s/m", "N s/m, Ns/m, kN s/m, kNs/m, MN s/m, MNs/m, lbf s/in";
    Twist = "rad/m", "rad/m", "50 rad/m", "rad/m, rad/mm, deg/m, deg/mm";
    Inertia = "kg m2", "kg m2", "5e-6 kg m2", "kg m2, kg m^2, kg cm2, kg mm2, g cm2, g mm2";
    ArealMass = "kg/m2", "kg/m2", "40 kg/m2", "kg/m2, kg/m^2, g/cm2, g/cm^2, lb/ft2";
}

impl Dimension {
    /// Returns the stored unit, also the unit of bare numbers.
    pub fn unit(self) -> &'static str {
        ROWS[self as usize][0]
    }

    /// Returns the unit on screens.
    pub fn shown_unit(self) -> &'static str {
        ROWS[self as usize][1]
    }

    pub(super) fn example(self) -> &'static str {
        ROWS[self as usize][2]
    }

    /// Returns the accepted units, in addition to the stored unit with a prefix.
    pub fn accepted(self) -> &'static str {
        ROWS[self as usize][3]
    }
}

const DEG_PER_RAD: f64 = 180.0 / std::f64::consts::PI;

/// Pound-force, exactly 4.4482216152605 N (0.45359237 kg times 9.80665 m/s²), as this number over [`LBF_OVER`].
const LBF: f64 = 44_482_216_152_605.0;
const LBF_OVER: f64 = 1e13;

/// Units other than the stored ones with or without a prefix. The factor to the stored unit is the first number over the second. Both are
/// whole numbers if the definition allows it, so that `25.4mm` and `3in` are the floats nearest to 0.0254 and 0.0762.
pub(super) const UNITS: &[(&str, f64, f64)] = &[
    ("%", 1.0, 1e2),
    ("rad", DEG_PER_RAD, 1.0),
    ("g", 1.0, 1e3),
    ("t", 1e3, 1.0),
    ("gr", 6_479_891.0, 1e11),
    ("oz", 45_359_237.0, 16e8),
    ("lb", 45_359_237.0, 1e8),
    ("cm", 1.0, 1e2),
    ("in", 254.0, 1e4),
    ("ft", 3048.0, 1e4),
    ("mil", 254.0, 1e7),
    ("km/h", 10.0, 36.0),
    ("ft/s", 3048.0, 1e4),
    ("fps", 3048.0, 1e4),
    ("mph", 44_704.0, 1e5),
    ("g/cm3", 1e3, 1.0),
    ("t/m3", 1e3, 1.0),
    ("lb/in3", 453_592_370_000.0, 16_387_064.0),
    // Cubic foot: 0.028316846592 m³.
    ("lb/ft3", 453_592_370_000.0, 28_316_846_592.0),
    ("N/mm2", 1e6, 1.0),
    ("bar", 1e5, 1.0),
    // Square inch: 6.4516e-4 m².
    ("psi", LBF, 6.4516e9),
    ("ksi", LBF, 6.4516e6),
    ("Msi", LBF, 6.4516e3),
    ("min", 60.0, 1.0),
    ("lbf", LBF, LBF_OVER),
    ("lbf s", LBF, LBF_OVER),
    // Foot: 0.3048 m.
    ("ft lbf", 3048e-4 * LBF, LBF_OVER),
    ("J/g", 1e3, 1.0),
    // Coefficients in the linear case.
    ("N/m", 1.0, 1.0),
    ("N s/m", 1.0, 1.0),
    ("N/mm", 1e3, 1.0),
    ("lbf/in", LBF, 2.54e11),
    ("lbf s/in", LBF, 2.54e11),
    ("rad/mm", 1e3, 1.0),
    ("deg/m", 1.0, DEG_PER_RAD),
    ("deg/mm", 1e3, DEG_PER_RAD),
    ("g cm2", 1.0, 1e7),
    ("g mm2", 1.0, 1e9),
    ("g/cm2", 10.0, 1.0),
    // Square foot: 0.09290304 m².
    ("lb/ft2", 45_359_237.0, 9_290_304.0),
];
