//! The table of variables in the order of the editor: the group of each part of a scene, and when it is listed and, of that, used. Its
//! rows stand beside its fields.

use std::sync::LazyLock;

use super::part::placed;
use super::visible::{has_second, is_hydrodynamic, is_listing, is_sprung, may_stop};
use super::{Group, Variable};
use crate::model::mechanism::kinds::spring_rows;
use crate::model::scene::{
    Contact, Damper, Interface, Listing, Mechanism, Plate, Projectile, RunSettings, Scene, Second,
    Stack, Stop, Target,
};

/// Every variable there is.
pub static VARIABLES: LazyLock<Vec<Variable>> = LazyLock::new(|| {
    let always = |_: &Scene| true;
    [
        placed(Group::Projectile, always, always, Projectile::rows()),
        placed(Group::Target, always, always, Target::rows()),
        placed(Group::Plate, always, always, Plate::rows()),
        placed(Group::Mechanism, always, is_sprung, Damper::rows()),
        spring_rows(),
        placed(Group::Mechanism, always, is_sprung, Mechanism::rows()),
        placed(Group::Mechanism, has_second, always, Second::rows()),
        placed(Group::Stop, always, may_stop, Stop::rows()),
        placed(Group::Stack, always, always, Stack::rows()),
        placed(Group::Interface, always, always, Contact::rows()),
        placed(Group::Interface, is_listing, always, Listing::rows()),
        placed(Group::Interface, always, is_hydrodynamic, Interface::rows()),
        placed(Group::Run, always, always, RunSettings::rows()),
    ]
    .concat()
});
