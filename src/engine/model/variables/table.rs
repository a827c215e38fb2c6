//! The table of variables in the order of the editor: where each part of a scene stands, whose rows are beside its fields.

use std::sync::LazyLock;

use super::part::Place;
use super::visible::{has_second, is_hydrodynamic, is_listing, is_sprung, may_stop};
use super::{Group, Variable};
use crate::model::mechanism::kinds::add_spring_rows;
use crate::model::scene::{
    Combination, Contact, Damper, Interface, Listing, Mechanism, Plate, Projectile, RunSettings,
    Scene, Second, Stack, Stop, Target,
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

/// Where rows of springs stand in the table.
struct SpringRows {
    /// The first that a plain power law has no need of.
    beyond_plain: usize,
    /// The first that no run has any need of, behind those of the first spring.
    beyond_first: usize,
    /// The first of the second spring.
    second: usize,
    /// The first behind them.
    end: usize,
}

static SPRING_ROWS: LazyLock<SpringRows> = LazyLock::new(|| {
    let at = |key| VARIABLES.iter().position(|row| row.key == key).unwrap_or_default();
    SpringRows {
        beyond_plain: at("mechanism.spring.count"),
        beyond_first: at("mechanism.combination"),
        second: at("mechanism.second.coefficient"),
        end: at("mechanism.stop.position_m"),
    }
});

/// The rows whose values a run of this scene may read: a plain spring has no need of the rest.
pub(super) fn checked(scene: &Scene) -> impl Iterator<Item = &'static Variable> {
    let rows = &*SPRING_ROWS;
    let mechanism = &scene.mechanism;
    let first = if mechanism.is_plain() { rows.beyond_plain } else { rows.beyond_first };
    let is_alone = mechanism.combination == Combination::Alone;
    let second = if is_alone { rows.end } else { rows.second };
    VARIABLES[..first].iter().chain(&VARIABLES[second..])
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::{SPRING_ROWS, VARIABLES};

    #[test]
    fn names_are_unique() {
        let mut seen = HashSet::new();
        for variable in VARIABLES.iter() {
            for name in [variable.symbol, variable.key].iter().chain(variable.aliases) {
                assert!(seen.insert(*name), "{name} twice");
            }
        }
    }

    #[test]
    fn the_rows_of_the_springs_are_found_in_their_order() {
        let rows = &*SPRING_ROWS;
        let places = [0, rows.beyond_plain, rows.beyond_first, rows.second, rows.end];
        assert!(places.is_sorted_by(|a, b| a < b), "{places:?}");
    }
}
