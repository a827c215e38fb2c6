//! Figures in the README are those that its commands print.

use crate::support::{in_repository, json, number};

const CORE: &str = "--threat m2-ap-core --material aa6082-t651 --set v_i=450 --set h=20mm";

/// The README, without line breaks.
pub(crate) fn readme() -> String {
    let text = std::fs::read_to_string(in_repository("README.md")).unwrap();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn figures_of_the_readme_are_those_of_its_commands() {
    let text = readme();
    let rigid = format!("{CORE} --set mount=rigid");
    let sprung = format!("{CORE} --set face=150mm --set k=2MN/m");
    let [run, limit] = ["run", "limit"].map(|command| format!("{command} {rigid}"));
    let [moving, compare] = ["limit", "compare --absorber steel-coil-1200"]
        .map(|command| format!("{command} {sprung}"));
    let fragment = "--threat fsp-20mm --material aa6061-t651 --set v_i=500 --set mount=rigid";
    let seek = format!("seek {fragment} --over h=10mm..60mm --goal limit_velocity_m_s=500");
    let rounded = "run --set S_y=1.516e8 --set mount=rigid";
    // The command, the place of the figure in its JSON, the size of its unit, its decimals, and the words about it, `#`.
    for (command, place, unit, decimals, words) in [
        (&*run, "/final_penetration_m", 1e-3, 2, "It stops # mm deep"),
        (&limit, "/expected_low_m_s", 1.0, 1, "measured limits lie, # to "),
        (&limit, "/expected_high_m_s", 1.0, 1, " to # m/s; the limit is expected at"),
        (&limit, "/expected_limit_m_s", 1.0, 1, "the limit is expected at # m/s"),
        (&limit, "/limit_velocity_m_s", 1.0, 1, "(by the law alone # m/s)"),
        (&moving, "/limit_velocity_m_s", 1.0, 1, " # m/s, not measured."),
        (&compare, "/mass_efficiency", 1.0, 3, "the mass efficiency is #."),
        (&seek, "/solutions/0/at", 1e-3, 2, " # mm: where such shots were measured"),
        ("run yang-xi", "/max_plate_displacement_m", 1e-3, 1, "the program has # mm."),
        ("run", "/first_arrest_time_s", 1e-6, 1, "the projectile stops after # us"),
        ("run --set mount=rigid", "/first_arrest_time_s", 1e-6, 1, "instead of # us"),
        ("run", "/max_plate_displacement_time_s", 1e-3, 3, "Stopping the plate takes # ms"),
        ("run", "/percent_of_baseline", 1.0, 0, "instead of # %."),
        (rounded, "/final_penetration_m", 1e-3, 3, "the exact depth is # mm"),
    ] {
        let arguments: Vec<&str> = command.split(' ').collect();
        let object = json(arguments[0], &arguments[1..]);
        let found = number(object.pointer(place).unwrap()) / unit;
        let said = words.replace('#', &format!("{found:.decimals$}"));
        assert!(text.contains(&said), "{command}: {said}");
    }
}
