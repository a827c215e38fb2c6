//! The first contact by the quickest way there is: the contact kernel where it takes the scene, else the simulation. For programs
//! that ask for nothing but depth and time, as the benches do. Knows no clock and no screen.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::contact_kernel::contact_end;
use crate::model::contact_phase::{Ending, Refusal};
use crate::model::scene::Scene;
use crate::model::simulate::{Settings, simulate};

/// How the first contact ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstContact {
    /// Common velocity, or the nose clear of the rear face.
    pub ending: Ending,
    /// When, s.
    pub t_s: f64,
    /// Depth then, m.
    pub depth_m: f64,
    /// Which kernel found it.
    pub kernel: Kernel,
}

/// What computes a first contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// The contact alone, unrolled for its force laws.
    Lean,
    /// The whole run with modes and events.
    Full,
}

impl Kernel {
    /// The word for tables.
    pub fn word(self) -> &'static str {
        match self {
            Self::Lean => "lean",
            Self::Full => "full",
        }
    }
}

/// The first contact of a valid scene, to the scene's own tolerance.
///
/// # Errors
/// [`Refusal::EndedEarly`] when neither arrest nor perforation is found, or the scene makes no physical sense.
pub fn first_contact(scene: &Arc<Scene>) -> Result<FirstContact, Refusal> {
    if let Some(end) = contact_end(scene, scene.run.tolerance) {
        let ending = if end.arrested { Ending::Arrest } else { Ending::Perforation };
        let (t_s, depth_m) = (end.t_s, end.penetration_m);
        return Ok(FirstContact { ending, t_s, depth_m, kernel: Kernel::Lean });
    }
    let settings = Settings { series: false, estimate: false };
    let run = simulate(scene, &settings, &mut |_| ControlFlow::Continue(()))
        .map_err(|_senseless| Refusal::EndedEarly)?;
    let arrest = run.first_arrest.map(|end| (Ending::Arrest, end.t_s, end.penetration_m));
    let exit = run.exit_time_s.zip(run.final_penetration_m);
    let exit = exit.map(|(t_s, depth_m)| (Ending::Perforation, t_s, depth_m));
    let (ending, t_s, depth_m) = arrest.or(exit).ok_or(Refusal::EndedEarly)?;
    Ok(FirstContact { ending, t_s, depth_m, kernel: Kernel::Full })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::variables::scene_with;

    #[test]
    fn valid_the_door_against_the_stored_digits() {
        // Rows S2, S4 and S17 of the stored reference.
        for (pairs, t_s, depth_m) in [
            ("k=1e5", 0.000_113_597_172_897_240_72, 0.004_571_788_754_106_379),
            ("k=1e6 n=0.5", 0.000_197_151_917_116_086_2, 0.006_919_384_198_354_558),
            ("h=0.003 v_i=400 k=1e5", 0.000_058_297_967_935_076_06, 0.009_35),
        ] {
            let found = first_contact(&Arc::new(scene_with(pairs))).unwrap();
            assert!((found.t_s / t_s - 1.0).abs() < 1e-9, "{pairs}: {found:?}");
            assert!((found.depth_m / depth_m - 1.0).abs() < 1e-9, "{pairs}: {found:?}");
        }
    }
}
