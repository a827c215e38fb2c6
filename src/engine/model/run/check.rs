//! Checks of validity: the variable at which each is marked, and what each means; and the warnings that name them.

use std::fmt;

use crate::model::labelled_enum::labelled_enum;

labelled_enum! {
    /// Check of validity.
    pub enum Check: label {
        Thickness = "h/D",
        Material = "material",
        Nose = "nose",
        NosePressure = "nose pressure",
        NoseMass = "nose mass",
        Face = "plate face",
        Velocity = "velocity",
        Obliquity = "obliquity",
        Spring = "spring",
        SpringMass = "spring mass",
        Stop = "rigid stop",
        Interface = "interface",
        Rebound = "rebound",
    }
}

labelled_enum! {
    /// On which side the answer errs.
    pub enum Direction: word {
        /// The real plate resists more: limits come out too low, depths too great.
        Conservative = "conservative",
        /// The real plate resists less: limits come out too high, depths too small.
        Unconservative = "unconservative",
        /// Not known.
        Unknown = "direction unknown",
    }
}

impl Check {
    /// Whether it is of what the design itself has to bear, not of the model's choice.
    pub fn is_of_load(self) -> bool {
        matches!(self, Self::Face | Self::Spring | Self::Stop | Self::Interface | Self::Rebound)
    }

    /// The variable in whose row the breach is marked.
    pub fn symbol(self) -> &'static str {
        self.row().0
    }

    /// Explains the check in a paragraph: meaning, direction of the error, remedy.
    pub fn about(self) -> &'static str {
        self.row().1
    }

    #[rustfmt::skip]
    fn row(self) -> (&'static str, &'static str) {
        match self {
            Self::Thickness => ("h",
               "Plate thickness over projectile diameter, by which a plate fails in another way: with dishing the law is validated \
                up to about 1 (conservative beyond: limits come out too low) and from about 0.3 (unconservative below), without it \
                from about 1 (unconservative below). Cure: dishing=off with closure=cavity for a thick plate, dishing=on with \
                closure=double-yield for a thin one. Under a pointed core a plate of 1250 MPa and more comes out 40 to 50 % too high \
                below about 0.7 (unconservative), and under a rigid cylinder every plate too low below about 0.6 (conservative): \
                there is no cure."),
            Self::Material => ("rho",
               "The target is no metal by its density and yield stress, and strength and drag are laws for metal plates. On which \
                side the answer errs is not known. Cure: give rho and S_y of a metal."),
            Self::Nose => ("nose",
               "Another nose than a hemisphere has its law measured with closure=cylindrical only: on which side the answer errs with \
                another closure is not known. Cure: closure=cylindrical with Y, UTS and E. A core that deforms is taken as rigid \
                (conservative); there is no cure."),
            Self::NosePressure => ("v_i",
               "The pressure on the nose, S + c v^2, is more than half of the 2 GPa of hardened steel: the projectile may deform or \
                break, which the model does not know. Conservative: a broken projectile penetrates less. Cure: a lower v_i or a \
                softer plate."),
            Self::NoseMass => ("m_p",
               "The sphere of the nose alone weighs more than the projectile: radius, density and mass do not fit. On which side \
                the answer errs is not known. Cure: correct m_p or R."),
            Self::Face => ("gamma",
               "The plate's face is narrower than 3 projectile diameters: its edges yield, and the hole has no room. \
                Unconservative: the real plate resists less. Cure: raise gamma or set face."),
            Self::Velocity => ("v_i",
               "The shot is slower than 50 m/s, the least in measurements, or faster than 1000 m/s, where heating, rate and \
                erosion count. On which side the answer errs is not known. Cure: v_i between them."),
            Self::Obliquity => ("theta",
               "The shot is oblique: limits come out below measured ones (`cmra validate`), the more so the larger theta is and the \
                lighter the plate; beyond about 20 deg the model is not meant for it, and ricochet is not modelled. \
                Conservative. Cure: theta=0."),
            Self::Spring => ("k",
               "More than the spring bears: it is displaced beyond the limit of its stress, travel or shape, or its \
                end moves faster than about 20 m/s, at which a steel coil surges and its coils may close. Unconservative: a real \
                spring fails or is stiffer. Cure: a heavier plate (gamma), or a spring with more travel."),
            Self::SpringMass => ("own_mass",
               "The springs' own mass is omitted although the part of it that moves is more than a tenth of the plate's mass. \
                Unconservative: the real mount moves more slowly. Cure: own_mass=counted; where the mass is not known, \
                m_spring or e_spring."),
            Self::Stop => ("x_stop",
               "A rigid stop asks the fused interface for an unbounded force: nothing after the hit is to be believed. \
                Unconservative. Cure: stop_kind=elastic, or with the hydrodynamic model interface=plastic."),
            Self::Interface => ("interface",
               "The fused interface must carry more than its strength A S_y, or in tension g A S_y (the grip g is an assumption): \
                penetration would resume, or the projectile would be pulled out. Unconservative. Cure: interface=plastic."),
            Self::Rebound => ("interface",
               "After the run the plate comes back and pulls at the fused interface with more than its strength g A S_y (the grip g \
                is an assumption): the projectile may come loose and strike again. Unconservative. Cure: interface=plastic."),
        }
    }
}

/// Warning about a result. A short text has the value alone, a long one its meaning, too.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning {
    /// Place where the warning holds, if not the scene itself: `at d = 0.5`.
    pub place: Option<String>,
    /// Check of validity that fails, with the direction of the error; `None` for a remark.
    pub breach: Option<(Check, Direction)>,
    /// Clause with the number.
    pub value: String,
    /// Rest of the sentence, from its punctuation mark on; may be empty.
    pub meaning: String,
}

impl Warning {
    /// Creates a warning that is no breach of validity.
    pub fn remark(value: impl Into<String>, meaning: impl Into<String>) -> Self {
        Self { place: None, breach: None, value: value.into(), meaning: meaning.into() }
    }

    /// Adds the place where the warning holds.
    #[must_use]
    pub fn at(self, place: impl Into<String>) -> Self {
        let place = place.into();
        let place = self.place.map_or_else(|| place.clone(), |own| format!("{place}: {own}"));
        Self { place: Some(place), ..self }
    }

    /// Formats place, value and direction, without the meaning.
    pub fn short(&self) -> String {
        self.text("", "")
    }

    fn text(&self, outside: &str, meaning: &str) -> String {
        let place = self.place.as_ref().map_or_else(String::new, |place| format!("{place}: "));
        let value = &self.value;
        let Some((check, direction)) = self.breach else {
            return format!("{place}{value}{meaning}");
        };
        // The name of the check is what explains it.
        let name = check.label();
        let lead = if value.starts_with(name) { String::new() } else { format!("{name}: ") };
        format!("{place}{outside}{lead}{value}{meaning} ({})", direction.word())
    }
}

impl fmt::Display for Warning {
    /// Formats the whole warning.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text("outside validity: ", &self.meaning))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_short_text_has_place_number_and_direction() {
        let breach = |check, direction, value: &str, meaning: &str| Warning {
            breach: Some((check, direction)),
            ..Warning::remark(value, meaning)
        };
        let spring = breach(
            Check::Spring,
            Direction::Unconservative,
            "spring end moves at 36.8 m/s",
            ": a coil surges",
        );
        let slow =
            breach(Check::Velocity, Direction::Unknown, "v_i = 20 m/s is below the 50 m/s", "");
        let plate = Warning::remark("plate bends", ": the peak contact force exceeds 3 kN");
        for (warning, short, long) in [
            (
                spring.at("at k = 7.5e6"),
                "at k = 7.5e6: spring end moves at 36.8 m/s (unconservative)",
                "at k = 7.5e6: outside validity: spring end moves at 36.8 m/s: a coil surges (unconservative)",
            ),
            (
                slow,
                "velocity: v_i = 20 m/s is below the 50 m/s (direction unknown)",
                "outside validity: velocity: v_i = 20 m/s is below the 50 m/s (direction unknown)",
            ),
            (
                plate.at("element 2").at("at h = 5"),
                "at h = 5: element 2: plate bends",
                "at h = 5: element 2: plate bends: the peak contact force exceeds 3 kN",
            ),
        ] {
            assert_eq!((warning.short(), warning.to_string()), (short.to_owned(), long.to_owned()));
        }
    }
}
