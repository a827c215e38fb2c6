//! The part of a scene that says how the force between projectile and plate is modelled: which of the models of thesis
//! section 8.2, and what each of them needs. `variables` says which of them matter to which model.

use crate::model::contact_models::contact_models;
use crate::model::defaulted::defaulted;
use crate::model::worded::worded;

defaulted! {
    /// The interaction model and its parameters.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Contact {
        pub model: ContactModel = ContactModel::Hydrodynamic,
        pub duration_s: Option<f64> = None,
        pub load_stiffness_n_m: Option<f64> = None,
        pub unload_stiffness_n_m: Option<f64> = None,
        pub damping_n_s_m: f64 = 0.0,
        pub appendix: Listing = Listing::default(),
    }

    /// The listing of Appendix A, quirk by quirk.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Listing {
        pub step_s: f64 = 1e-6,
        pub coupling: Reading = Reading::Printed,
        pub damper: Reading = Reading::Printed,
        pub stopping: Reading = Reading::Printed,
        pub afterwards: Reading = Reading::Printed,
        pub scheme: Reading = Reading::Printed,
        pub obliquity: Reading = Reading::Printed,
        pub jumps: Jumps = Jumps::Meant,
    }
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident = $word:literal, $about:path;)+) => {
        worded! {
            /// How the force between projectile and plate is modelled.
            #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
            pub enum ContactModel: word {
                $($(#[$doc])* $kind = $word,)+
            }
        }
    };
}
contact_models!(kinds);

worded! {
    /// How one doubtful place of the listing is read.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum Reading: word {
        #[default]
        Printed = "printed",
        Corrected = "corrected",
    }
}

worded! {
    /// The area once the nose is buried.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum Jumps: word {
        /// The scripts' jumps do what they are meant to: the area stays that of the full section.
        #[default]
        Meant = "meant",
        /// They are calls that come back: the next lines overwrite the area, and divide by tan(theta) = 0.
        Ignored = "ignored",
    }
}

impl Listing {
    /// As printed, but for depth, damper and obliquity, which are read so: corrected, depth follows from the whole relative
    /// travel, the damper resists, and both couplings have obliquity's cosine.
    pub fn coupled(step_s: f64, reading: Reading) -> Self {
        Self { step_s, coupling: reading, damper: reading, obliquity: reading, ..Self::default() }
    }

    /// Everything put right that can be, with the same step.
    pub fn corrected(step_s: f64) -> Self {
        let reading = Reading::Corrected;
        let coupled = Self::coupled(step_s, reading);
        Self { stopping: reading, afterwards: reading, scheme: reading, ..coupled }
    }
}
