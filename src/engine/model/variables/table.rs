//! The table of variables in the order of the editor: where each part of a scene stands, whose rows are beside its fields.

use std::sync::LazyLock;

use super::part::Place;
use super::visible::{has_second, is_hydrodynamic, is_listing, is_sprung, may_stop};
use super::{Group, Variable};
use crate::model::mechanism::kinds::add_spring_rows;
use crate::model::scene::{
    Contact, Damper, Interface, Listing, Mechanism, Plate, Projectile, RunSettings, Scene, Second,
    Stack, Stop, Target,
};

/// Defines where parts stand in a scene: their group, their path, and when they are listed and used.
macro_rules! places {
    ($($group:ident, $first:ident $(. $field:ident)*: $part:ident $(, listed $listed:ident)? $(, used $used:ident)?;)+) => {$(
        impl Place<$part> for Scene {
            const GROUP: Group = Group::$group;
            const PATH: [&'static str; 2] = [concat!(stringify!($first) $(, ".", stringify!($field))*), ""];

            fn part(scene: &Self) -> &$part {
                &scene.$first$(.$field)*
            }

            fn part_mut(scene: &mut Self) -> &mut $part {
                &mut scene.$first$(.$field)*
            }

            $(fn is_listed(scene: &Self) -> bool {
                $listed(scene)
            })?

            $(fn is_used(scene: &Self) -> bool {
                $used(scene)
            })?
        }
    )+};
}

places! {
    Projectile, projectile: Projectile;
    Target, target: Target;
    Plate, plate: Plate;
    Mechanism, mechanism: Mechanism, used is_sprung;
    Mechanism, mechanism.damper: Damper, used is_sprung;
    Mechanism, mechanism.second: Second, listed has_second, used has_second;
    Stop, mechanism.stop: Stop, used may_stop;
    Stack, stack: Stack;
    Interface, contact: Contact;
    Interface, contact.appendix: Listing, listed is_listing, used is_listing;
    Interface, interface: Interface, used is_hydrodynamic;
    Run, run: RunSettings;
}

/// Every variable there is.
pub static VARIABLES: LazyLock<Vec<Variable>> = LazyLock::new(|| {
    let mut rows = Vec::new();
    Projectile::add_rows::<Scene>(&mut rows);
    Target::add_rows::<Scene>(&mut rows);
    Plate::add_rows::<Scene>(&mut rows);
    Damper::add_rows::<Scene>(&mut rows);
    add_spring_rows(&mut rows);
    Mechanism::add_rows::<Scene>(&mut rows);
    Second::add_rows::<Scene>(&mut rows);
    Stop::add_rows::<Scene>(&mut rows);
    Stack::add_rows::<Scene>(&mut rows);
    Contact::add_rows::<Scene>(&mut rows);
    Listing::add_rows::<Scene>(&mut rows);
    Interface::add_rows::<Scene>(&mut rows);
    RunSettings::add_rows::<Scene>(&mut rows);
    rows
});
