//! The table of variables in the order of the editor: where each part of a scene stands, whose rows are beside its fields.

use std::sync::LazyLock;

use super::Variable;
use super::part::place;
use super::visible::{has_second, is_hydrodynamic, is_listing, is_sprung, may_stop};
use crate::model::mechanism::kinds::add_spring_rows;
use crate::model::scene::{
    Contact, Damper, Interface, Listing, Mechanism, Plate, Projectile, RunSettings, Second, Stack,
    Stop, Target,
};

place!(Projectile, projectile: Projectile);
place!(Target, target: Target);
place!(Plate, plate: Plate);
place!(Mechanism, mechanism: Mechanism, used is_sprung);
place!(Mechanism, mechanism.damper: Damper, used is_sprung);
place!(Mechanism, mechanism.second: Second, listed has_second);
place!(Stop, mechanism.stop: Stop, used may_stop);
place!(Stack, stack: Stack);
place!(Interface, contact: Contact);
place!(Interface, contact.appendix: Listing, listed is_listing);
place!(Interface, interface: Interface, used is_hydrodynamic);
place!(Run, run: RunSettings);

/// Every variable there is.
pub static VARIABLES: LazyLock<Vec<Variable>> = LazyLock::new(|| {
    let mut rows = Vec::new();
    Projectile::add_rows(&mut rows);
    Target::add_rows(&mut rows);
    Plate::add_rows(&mut rows);
    Damper::add_rows(&mut rows);
    add_spring_rows(&mut rows);
    Mechanism::add_rows(&mut rows);
    Second::add_rows(&mut rows);
    Stop::add_rows(&mut rows);
    Stack::add_rows(&mut rows);
    Contact::add_rows(&mut rows);
    Listing::add_rows(&mut rows);
    Interface::add_rows(&mut rows);
    RunSettings::add_rows(&mut rows);
    rows
});
