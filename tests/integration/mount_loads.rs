//! The loads of mount and interface over the whole motion, the way back included: against closed forms, and against a run that goes
//! on for long enough.

use serde_json::Value;

use crate::support::{assert_near, says};

/// A run's JSON: a preset or nothing, and variables.
fn run(pairs: &str) -> Value {
    let words = pairs.split_whitespace();
    let set =
        words.flat_map(|word| if word.contains('=') { vec!["--set", word] } else { vec![word] });
    let arguments: Vec<&str> = set.chain(["--json"]).collect();
    serde_json::from_str(&says("run", &arguments, 0).0).unwrap()
}

fn number(run: &Value, key: &str) -> f64 {
    run[key].as_f64().unwrap_or_else(|| panic!("{key}: {run}"))
}

/// The greatest of what `of` makes of contact, spring, damper and stop force in the rows of a run, N.
fn greatest_of_rows_n(pairs: &str, of: impl Fn([f64; 4]) -> f64) -> f64 {
    let set = pairs.split_whitespace().flat_map(|pair| ["--set", pair]);
    let (rows, _) = says("run", &set.chain(["--csv", "-"]).collect::<Vec<_>>(), 0);
    let mut rows = rows.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = rows.next().unwrap();
    let columns = ["contact", "spring", "damper", "stop"]
        .map(|force| names.iter().position(|name| *name == format!("{force}_force_n")).unwrap());
    let forces = |row: Vec<&str>| columns.map(|at| row[at].parse::<f64>().unwrap());
    rows.map(|row| of(forces(row)).abs()).fold(0.0, f64::max)
}

/// The greatest force in the rows of a run that goes on for 60 ms, N.
fn of_rows_n(pairs: &str) -> f64 {
    let pairs = format!("{pairs} horizon=60ms");
    greatest_of_rows_n(&pairs, |[_, spring, damper, stop]| spring + damper + stop)
}

/// The bistable spring pushes forward only half as hard as it pulls on the swing back.
#[test]
fn valid_the_mount_carries_the_swing_back_of_an_asymmetric_spring() {
    for damper in ["", " b=50", " x_stop=1m"] {
        let pairs = format!("spring=bistable x_u=15mm F_bar=6kN{damper}");
        let found = number(&run(&pairs), "peak_mount_force_n");
        assert_near(found, of_rows_n(&pairs), 1e-4);
        assert!(found > 16e3, "{pairs}: {found}");
    }
}

/// The mount turns a mass J with the plate, and takes its part of the contact force F: `(J F + m_2 k x)/(m_2 + J)`. The light one is
/// loaded most when the plate turns back, the heavy one within the contact.
#[test]
fn valid_a_mount_that_turns_a_mass_takes_its_part_of_the_contact_force() {
    for inertia_kg_m2 in [2.1e-6, 4.2e-5] {
        let (turning_kg, plate_kg) = (inertia_kg_m2 * 60.0 * 60.0, 0.0295);
        let pairs = format!("spring=helix k_helix=2e5 twist=60 I_z={inertia_kg_m2}");
        let rows_n = greatest_of_rows_n(&pairs, |[contact, spring, ..]| {
            (turning_kg * contact + plate_kg * spring) / (turning_kg + plate_kg)
        });
        assert_near(number(&run(&pairs), "peak_mount_force_n"), rows_n, 1e-4);
        let asked = ["--over", "gamma=1..2:2", "--outputs", "peak_mount_force_n", "--csv", "-"];
        let set = pairs.split_whitespace().flat_map(|pair| ["--set", pair]);
        let (swept, _) = says("sweep", &set.chain(asked).collect::<Vec<_>>(), 0);
        let first = swept.lines().nth(1).unwrap().split(',').nth(3).unwrap();
        assert_near(first.parse().unwrap(), rows_n, 1e-4);
    }
}

/// The table is F = 3 kN + x 200 kN/m: it pulls the plate back before the shot drives it forward, and is never loaded more than at
/// first contact.
#[test]
fn valid_a_preloaded_plate_that_only_goes_back_does_not_stand_still() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("preloaded.csv");
    std::fs::write(&table, "-0.02,-1000\n0.01,5000\n").unwrap();
    let table = format!("table={}", table.display());
    let (found, _) = says("run", &["--set", &table, "--set", "v_i=10", "--json"], 0);
    let found = serde_json::from_str(&found).unwrap();
    assert_near(number(&found, "peak_mount_force_n"), 3000.0, 1e-12);
}

/// The plate coasts to its stop with the momentum p that the shot has lost, and presses it with `p sqrt(k/m_2)`, wherever it stands.
#[test]
fn valid_an_elastic_stop_takes_the_momentum_of_a_coasting_plate_however_far_away_it_stands() {
    let free = run("h=3mm v_i=400 k=0");
    let momentum = 0.0295 * (400.0 - number(&free, "residual_velocity_m_s"));
    for place in ["30mm", "60mm", "100mm", "2m"] {
        let found = run(&format!("h=3mm v_i=400 k=0 stop_kind=elastic k_stop=1e6 x_stop={place}"));
        let force = momentum * (1e6 / number(&found, "plate_mass_kg")).sqrt();
        assert_near(number(&found, "peak_mount_force_n"), force, 1e-9);
        assert_near(number(&found, "mount_impulse_n_s"), momentum, 1e-9);
    }
    // A damper of the power m takes (2 - m) b x/M of w^(2 - m).
    for (m, b) in [(1.0f64, 0.5), (3.0, 1e-5)] {
        let found = run(&format!(
            "h=3mm v_i=400 k=0 stop_kind=elastic k_stop=1e6 x_stop=500mm b={b} m={m}"
        ));
        let mass = number(&found, "plate_mass_kg");
        let left = (momentum / mass).powf(2.0 - m) - (2.0 - m) * b * 0.5 / mass;
        let force = left.powf(1.0 / (2.0 - m)) * (1e6 * mass).sqrt();
        // The damper works on the way into the stop, too.
        assert_near(number(&found, "peak_mount_force_n"), force, 0.02);
        assert_near(number(&found, "mount_impulse_n_s"), momentum, 1e-4);
    }
}

/// The mount takes all momentum of a shot that stays in a plate at rest, of both bodies, 2.95 N s, whatever brings the plate to rest; of a shot that
/// goes through what the plate has got of it.
#[test]
fn valid_the_hit_on_a_rigid_stop_belongs_to_the_impulse() {
    for more in ["", "e=0.5", "x_stop=1mm", "interface=plastic", "theta=30deg v_i=60"] {
        let found = run(&format!("k=1e5 x_stop=5mm {more}"));
        let taken = if more.contains("theta") { 0.0295 * 60.0 * 0.75f64.sqrt() } else { 2.95 };
        assert_near(number(&found, "mount_impulse_n_s"), taken, 1e-9);
    }
    // A plate that comes to its stop again and again is there for the last time, whatever the rounding.
    let [one, other] = ["1e-9", "1e-12"].map(|tolerance| {
        let bounces = "spring=helix v_i=188.8 x_stop=0.0002604 e=0.9 interface=plastic grip=1";
        number(&run(&format!("{bounces} tol={tolerance}")), "mount_impulse_n_s")
    });
    assert_near(one, other, 1e-9);
    let through = run("h=3mm v_i=400 k=0 x_stop=30mm");
    let momentum = 0.0295 * (400.0 - number(&through, "residual_velocity_m_s"));
    assert_near(number(&through, "mount_impulse_n_s"), momentum, 1e-9);
}

/// Undamped bodies come back to their stop for ever, and rounding decides how often a run sees it. Whether they come there at all is known.
#[test]
fn a_fused_stop_is_hit_or_not_whatever_the_tolerance() {
    let bounces = "v_i=158.192 gamma=11.4603 spring=bistable x_2=0.00342498 F_bar=818.272 e=0.263899 model=initial-velocity";
    for (stop, is_hit) in [("0.0055314", 1.0), ("1", 0.0)] {
        for tolerance in ["1e-9", "1e-10"] {
            let found = run(&format!("{bounces} x_stop={stop} tol={tolerance}"));
            assert_near(number(&found, "fused_stop_hit"), is_hit, 0.0);
        }
    }
}

/// A stop that the plate hits while the projectile still penetrates or its force history lasts, or after it is through, loads no fused
/// interface: the shot is that of a plastic one.
#[test]
fn a_stop_that_is_hit_before_the_bodies_fuse_or_after_the_exit_is_no_fused_one() {
    let history = "model=half-sine x_stop=3mm gamma=0.6 t_d=120us b=20";
    for pairs in ["x_stop=1mm", "x_stop=20mm v_i=400", history] {
        let [fused, plastic] =
            ["", " interface=plastic"].map(|more| run(&format!("{pairs}{more}")));
        assert_near(number(&fused, "fused_stop_hit"), 0.0, 0.0);
        assert!(!fused["warnings"].to_string().contains("unbounded"), "{pairs}");
        for key in ["final_penetration_m", "stroke_m"] {
            assert_near(number(&fused, key), number(&plastic, key), 1e-12);
        }
    }
}

/// A falling table is extrapolated linearly beyond its end, to a force that pushes the plate away without bound.
#[test]
fn a_spring_that_drives_its_plate_away_has_no_greatest_load() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("falls.csv");
    std::fs::write(&path, "displacement_m,force_N\n0,0\n0.01,2000\n0.02,1000\n0.03,100\n").unwrap();
    let table = format!("table={}", path.to_str().unwrap());
    let found = |more: &[&str]| {
        let arguments = [&["--set", &table, "--set", "v_i=150", "--json"], more].concat();
        serde_json::from_str::<Value>(&says("run", &arguments, 0).0).unwrap()
    };
    let for_ever = found(&[]);
    assert!(for_ever["max_plate_displacement_m"].is_null());
    for key in [
        "peak_mount_force_n",
        "mount_impulse_n_s",
        "interface_demand_ratio",
        "interface_tension_ratio",
    ] {
        assert!(for_ever[key].is_null(), "{key}");
    }
    let (page, _) = says("run", &["--set", &table, "--set", "v_i=150"], 0);
    assert!(page.contains("none: nothing stops the plate"), "{page}");
    // Up to a time all is known: the force is greatest at 10 mm.
    let up_to = found(&["--set", "horizon=0.4ms"]);
    assert_near(number(&up_to, "peak_mount_force_n"), 2000.0, 1e-9);
}

/// A lumped interface only pushes: its bodies part, and a stop acts on the plate alone.
#[test]
fn a_lumped_interface_asks_nothing_of_a_stop() {
    for place in ["1mm", "5mm", "20mm"] {
        let found = run(&format!("model=lumped x_stop={place}"));
        assert!(found["fused_stop_hit"].is_null() && found["outcome"] == "separated", "{place}");
        assert!(!found["warnings"].to_string().contains("unbounded"), "{place}");
    }
}

/// Thrown back at first, fused bodies come to the stop at their own starting place: 1 um / 20 m/s before a stop that stands 1 um further.
#[test]
fn valid_a_stop_at_the_starting_place_is_hit_on_the_way_back() {
    let [at_start, beyond] = ["0", "1um"].map(|place| {
        let found = run(&format!("w_0=-30 v_i=30 gamma=5 x_stop={place}"));
        assert!(found["peak_mount_force_n"].is_null(), "{found}");
        assert_near(number(&found, "fused_stop_hit"), 1.0, 0.0);
        let hit = found["events"].as_array().unwrap().last().unwrap().clone();
        assert_eq!(hit["event"], "stop hit");
        number(&hit, "time_s")
    });
    // The common velocity of -20 m/s comes back: (30 - 5 x 30)/6.
    assert_near(beyond - at_start, 1e-6 / 20.0, 1e-2);
}

/// A damper alone stops the plate at last: the mount takes all of the shot's momentum, 0.0295 kg at 50 m/s.
#[test]
fn valid_a_damper_takes_all_momentum_of_an_arrested_shot() {
    for damper in ["b=100", "b=2000 m=2", "b=50 m=2", "b=50 m=3"] {
        let found = run(&format!("v_i=50 k=0 {damper}"));
        assert_near(number(&found, "mount_impulse_n_s"), 1.475, 1e-12);
    }
}

/// A plate that only approaches its greatest displacement is there at no time, and its weight acts without an end: at b/(3 k x²) = 9 s for
/// each e-fold it is still on its way after minutes. One that is thrown back for good has loaded no mount at its start. One that follows the
/// contact force by 1e-16 m on a steep spring comes to no reversal.
#[test]
fn a_displacement_that_is_not_arrived_at_has_neither_time_nor_impulse() {
    let creeps = "v_i=7.21896 gamma=1.67918 R=5.14309mm w_0=3.62613 b=418.392 k=49341.5 n=3 interface=plastic weight=on";
    let sits = "v_i=524.701 gamma=5.00084 m_p=0.321439 h=63.435mm theta=65.08deg dishing=off k=1.89347e7 n=0.198804 interface=plastic";
    for tolerance in ["1e-3", "1e-6", "1e-9"] {
        for pairs in [creeps, sits] {
            let found = run(&format!("{pairs} tol={tolerance}"));
            assert!(found["max_plate_displacement_time_s"].is_null(), "{pairs} {tolerance}");
            assert!(found["mount_impulse_n_s"].is_null(), "{pairs} {tolerance}");
        }
    }
    let thrown = run("w_0=-60 gamma=2 k=0 b=1000");
    assert_near(number(&thrown, "max_plate_displacement_time_s"), 0.0, 0.0);
    assert_near(number(&thrown, "mount_impulse_n_s"), 0.0, 0.0);
}

/// A run that is cut short knows only what the mount has carried so far.
#[test]
fn the_load_up_to_a_horizon_before_the_stop_is_a_lower_bound() {
    let found = run("h=3mm v_i=400 k=0 stop_kind=elastic k_stop=1e6 x_stop=100mm horizon=1ms");
    let bounds = found["lower_bounds"].as_array().unwrap();
    assert!(bounds.contains(&Value::from("peak_mount_force_n")), "{found}");
    assert!(found["mount_impulse_n_s"].is_null());
}

/// The column's 15 kN are passed while the shot still penetrates; the fused interface meets them on the way back, with the half of
/// two equal masses: `15 kN/2` over `pi R² S_y`.
#[test]
fn valid_the_fused_interface_carries_the_buckling_load_on_the_way_back() {
    let demand = |pairs: &str| number(&run(pairs), "interface_demand_ratio");
    let column = "spring=column F_crit=15kN F_plat=3kN k_col=1e8 S_y=1.52e8";
    let depth_m = number(&run(column), "final_penetration_m").min(0.00635);
    let area_m2 = std::f64::consts::PI * (2.0 * 0.00635 * depth_m - depth_m * depth_m);
    assert_near(demand(column), 7500.0 / (area_m2 * 1.52e8), 1e-9);
    let preset = "concept-buckling-four-bar";
    assert_near(demand(preset), demand(&format!("{preset} horizon=60ms")), 1e-9);
}

/// A plastic interface whose swing is to exceed its limit load slips: above the bottom of the hole it carries the grip of its strength, and
/// no more. No slip is resolved while a steep spring locks the plate: the estimate holds what that leaves out.
#[test]
fn valid_a_plastic_interface_carries_its_limit_load_and_no_more() {
    let steep = "v_i=36.2074 gamma=0.98949 h=0.0603193 w_0=-8.61855 k=341951 n=0.197821";
    let guided = "v_i=217.934 gamma=4.23491 d=0.000146836 w_0=-0.303255 spring=prbm-guided \
                  l_beam=0.116967 N_spring=5";
    for (scene, end) in [(steep, "horizon=0.4ms"), (guided, "horizon=10ms")] {
        for more in ["", "x_stop=1e6", "b=1e-12", "tol=1e-12", end] {
            let found = run(&format!("{scene} interface=plastic {more}"));
            assert_near(number(&found, "interface_demand_ratio"), 0.1, 1e-9);
        }
    }
    for more in ["tol=1e-3", "tol=1e-6", "g=0.05"] {
        let grip = if more == "g=0.05" { 0.05 } else { 0.1 };
        let found = run(&format!("{steep} interface=plastic {more}"));
        let demand = number(&found, "interface_demand_ratio");
        let estimate = number(&found["error_estimates"], "interface_demand_ratio");
        assert!((demand - grip).abs() <= estimate * demand * (1.0 + 1e-9), "{more}: {demand}");
    }
}

/// At the first arrest the spring carries the strength pi R² `S_y`. It gives the fused bodies back what it has stored, less the work of the
/// damper, 2 b w X of the integral of (1 - z^(n+1))^(1/2), however short their swing is: the half that the interface carries is 5 times
/// its grip. Before the turn the damper adds more than the spring lacks, at most b² X/(2 n M F) of the force F.
#[test]
fn valid_a_swing_back_that_is_short_pulls_as_hard_as_a_long_one() {
    let pull = |pairs: &str| number(&run(pairs), "interface_tension_ratio");
    for spring in ["n=0.02 k=1e6", "n=0.05 k=1e6", "n=0.1 k=5e6"] {
        for more in ["", "b=1e-12", "b=1", "x_stop=1mm", "x_stop=1mm stop_kind=elastic"] {
            for end in ["", " horizon=1ms"] {
                assert_near(pull(&format!("{spring} {more}{end}")), 5.0, 1e-13);
            }
        }
    }
    let (kg, b) = (0.059f64, 1e5);
    for (n, k) in [(0.1f64, 1e6f64), (0.15, 3e6), (0.05, 1e5)] {
        let force = std::f64::consts::PI * 0.00635 * 0.00635 * 1.52e8;
        let far_m = (force / k).powf(1.0 / n);
        let energy_j = force * far_m / (n + 1.0);
        let parts = (0..100_000).map(|i| (f64::from(i) + 0.5) * 1e-5);
        let mean: f64 = parts.map(|z| 1e-5 * (1.0 - z.powf(n + 1.0)).sqrt()).sum();
        let taken_j = 2.0 * b * (2.0 * energy_j / kg).sqrt() * far_m * mean;
        let added = b * b * far_m / (2.0 * n * kg * force);
        let weaker = n / (n + 1.0) * taken_j / energy_j - added;
        for end in ["", " horizon=1ms"] {
            let found = pull(&format!("n={n} k={k} b={b}{end}"));
            assert_near(found, 5.0 * (1.0 - weaker), 1e-8);
        }
    }
}

/// From the first arrest on the bodies swing with their energy E over the zero of the spring, or at most to the stop before it: the mass J of
/// the rotation has J/M of E less what the spring stores there.
#[test]
fn valid_a_mass_that_turns_is_fastest_on_the_swing_not_at_the_arrest() {
    let (k, inertia_kg_m2, twist) = (2e5, 5e-6, 50.0);
    let turning_kg = inertia_kg_m2 * twist * twist;
    for (cocked_m, stop, stop_m) in [
        (0.144, "", 0.0),
        (0.144, "x_stop=0", 0.0),
        (0.144, "x_stop=5cm", 0.0),
        (0.144, "x_stop=5cm stop_kind=elastic", 0.0),
        (0.144, "x_stop=-5cm", -0.05),
        (0.01, "b=1e-9", 0.0),
    ] {
        for end in ["", " horizon=60ms"] {
            let pairs = format!("spring=helix k_helix={k} twist={twist} I_z={inertia_kg_m2}");
            let found = run(&format!("{pairs} d={cocked_m} {stop}{end}"));
            let at = |key: &str| number(&found, &format!("first_arrest_plate_{key}"));
            let (x, w) = (at("displacement_m"), at("velocity_m_s"));
            let mass = 0.0295 + 0.0295 + turning_kg;
            let energy_j = 0.5 * mass * w * w + 0.5 * k * (x * x - stop_m * stop_m);
            let found_j = number(&found, "rotational_energy_j");
            assert_near(found_j, turning_kg / mass * energy_j, 1e-9);
        }
    }
}

/// The state at first contact counts, after an impact that takes no time: 2.95 kg m/s of 71.5 g. So does the way back of a plate that the
/// projectile has passed, with all of its energy at the zero of the spring.
#[test]
fn valid_a_mass_that_turns_is_fastest_at_the_start_or_on_the_way_back_of_a_perforated_plate() {
    let of = |pairs: &str| number(&run(&format!("spring=helix {pairs}")), "rotational_energy_j");
    let turning_kg = 5e-6 * 50.0 * 50.0;
    let after_m_s = 2.95 / (0.059 + turning_kg);
    let at_once_j = 0.5 * turning_kg * after_m_s * after_m_s;
    assert_near(of("model=initial-velocity twist=50 I_z=5e-6"), at_once_j, 1e-9);
    assert_near(of("w_0=-60 twist=50 I_z=5e-6"), 0.5 * turning_kg * 3600.0, 1e-12);
    let (k, twist) = (4.46319e6, 224.029);
    let pairs = format!(
        "spring=helix v_i=34.5768 gamma=0.790555 m_p=1.59753 twist={twist} I_z=5e-6 k_helix={k} interface=plastic"
    );
    let set = pairs.split_whitespace().flat_map(|pair| ["--set", pair]);
    let (rows, _) = says("run", &set.chain(["--csv", "-"]).collect::<Vec<_>>(), 0);
    let names: Vec<_> = rows.lines().next().unwrap().split(',').collect();
    let last: Vec<_> = rows.lines().last().unwrap().split(',').collect();
    let at =
        |name: &str| last[names.iter().position(|it| *it == name).unwrap()].parse::<f64>().unwrap();
    let (x, w) = (at("plate_displacement_m"), at("plate_velocity_m_s"));
    let turning_kg = 5e-6 * twist * twist;
    let mass = 0.790_555 * 1.59753 + turning_kg;
    let exact_j = turning_kg / mass * 0.5 * (mass * w * w + k * x * x);
    assert_near(number(&run(&pairs), "rotational_energy_j"), exact_j, 1e-9);
}

/// A damper alone takes `b w` at once. A cocked plate that comes back fast enough for its damper to balance its spring bears most at the
/// first arrest: 489.9605256 N by DOP853 of another library.
#[test]
fn valid_the_mount_force_counts_from_first_contact_and_all_terms_together() {
    for (pairs, exact_n) in [
        ("k=0 b=1000 w_0=-100", 1e5),
        ("k=0 b=1000 w_0=-100 interface=plastic", 1e5),
        ("k=0 b=20 m=2 w_0=-100", 2e5),
        ("k=1e4 d=0.2 b=100 v_i=30 w_0=20", 489.960_525_58),
        ("model=initial-velocity k=0 b=1000", 5e4),
    ] {
        assert_near(number(&run(pairs), "peak_mount_force_n"), exact_n, 1e-8);
    }
}

/// The line F = k x stores F²/(2 k) wherever the plate turns; the limit of a beam is as far from its neutral place on both sides.
#[test]
fn valid_a_spring_that_is_loaded_most_on_the_way_back_is_sized_for_it() {
    let start = "gamma=5 w_0=-30 v_i=30";
    for more in ["x_stop=5mm", "x_stop=0 e=1", "b=20", "b=20 horizon=60ms"] {
        let pairs = format!("{start} k=1e5 {more}");
        let back_n = greatest_of_rows_n(&format!("{pairs} horizon=60ms"), |[_, spring, ..]| spring);
        let found = run(&pairs);
        let stored_j = back_n * back_n / 2e5;
        assert_near(number(&found, "stored_energy_j"), stored_j, 1e-4);
        // A coil of steel weighs 5.08 g for each joule.
        assert_near(number(&found, "least_spring_mass_kg"), 5.08e-3 * stored_j, 1e-3);
    }
}

/// A stop that gives all energy back leaves the spring as much as it would have had without.
#[test]
fn valid_a_bounce_off_a_stop_without_loss_loads_the_spring_as_no_stop_does() {
    let keys = ["stored_energy_j", "yield_margin", "travel_margin", "system_mass_kg"];
    for spring in ["spring=prbm-guided", "k=1e5", "spring=bistable", "k=1e5 d=2mm"] {
        let [without, with] = ["", " x_stop=5mm e=1"].map(|stop| run(&format!("{spring}{stop}")));
        for key in keys.into_iter().filter(|key| !without[*key].is_null()) {
            assert_near(number(&with, key), number(&without, key), 1e-9);
        }
        let yields = |run: &Value| run["warnings"].to_string().contains("the beam yields");
        assert_eq!((yields(&with), yields(&without)), [spring.contains("prbm"); 2].into());
    }
}

/// Rows of time, s, plate displacement, m, and force on the mount, N, every half microsecond.
fn course(pairs: &str) -> Vec<[f64; 3]> {
    let set = pairs.split_whitespace().flat_map(|pair| ["--set", pair]);
    let asked: Vec<_> = set.chain(["--csv", "-", "--dt", "0.5us"]).collect();
    let (rows, _) = says("run", &asked, 0);
    let mut rows = rows.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = rows.next().unwrap();
    let at = |name: &str| names.iter().position(|it| *it == name).unwrap();
    let [t, x] = ["time_s", "plate_displacement_m"].map(at);
    let forces = ["spring_force_n", "damper_force_n", "stop_force_n"].map(at);
    rows.map(|row| {
        let number = |at: usize| row[at].parse::<f64>().unwrap();
        [number(t), number(x), forces.iter().map(|at| number(*at)).sum()]
    })
    .collect()
}

/// The impulse is the integral of the forces on the mount up to the greatest displacement: also with a plate that moves at first contact, and
/// with the weight of the projectile.
#[test]
fn valid_the_mount_takes_the_momentum_of_the_plate_and_of_the_weight() {
    for pairs in [
        "w_0=20",
        "w_0=-20 v_i=150",
        "w_0=-20 v_i=400",
        "w_0=20 theta=30deg v_i=80",
        "w_0=20 interface=plastic",
        "m_p=45 v_i=7.789 weight=on k=5e5 m_2=47.1 h=6mm R=5cm",
    ] {
        let rows = course(&format!("{pairs} horizon=60ms"));
        let far = rows.iter().enumerate().max_by(|a, b| a.1[1].total_cmp(&b.1[1])).unwrap().0;
        let mean = |pair: &[[f64; 3]]| 0.5 * (pair[1][0] - pair[0][0]) * (pair[0][2] + pair[1][2]);
        let impulse: f64 = rows[..=far].windows(2).map(mean).sum();
        assert_near(number(&run(pairs), "mount_impulse_n_s"), impulse, 1e-3);
    }
}

/// A plate that turns has its greatest displacement then, not where it is almost there.
#[test]
fn valid_the_time_of_the_greatest_displacement_is_that_of_the_reversal() {
    for pairs in
        ["b=5000", "b=10000 m=2", "w_0=20", "model=half-sine", "stop_kind=elastic x_stop=5mm"]
    {
        for tolerance in ["1e-6", "1e-9", "1e-12"] {
            let found = run(&format!("{pairs} tol={tolerance}"));
            let events = found["events"].as_array().unwrap();
            let turn = events.iter().find(|it| it["event"] == "greatest displacement").unwrap();
            let time_s = number(&found, "max_plate_displacement_time_s");
            assert_near(time_s, number(turn, "time_s"), 1e-12);
        }
    }
    // The line k x turns two bodies of 29.5 g that start as one after a quarter of their period.
    let found = run("model=initial-velocity k=1e5");
    let quarter_s = std::f64::consts::FRAC_PI_2 * (0.059f64 / 1e5).sqrt();
    assert_near(number(&found, "max_plate_displacement_time_s"), quarter_s, 1e-9);
    // An undamped plate comes there again and again, by rounding farther: the first time counts. The helix turns I_z twist² with it.
    let helix = "v_i=46.4492 gamma=1.1659 m_p=1.36295 spring=helix twist=14.8267 k_helix=2175.6 I_z=4.90905e-6 model=initial-velocity";
    let moving_kg = 1.36295 * 2.1659 + 4.90905e-6 * 14.8267f64.powi(2);
    let quarter_s = std::f64::consts::FRAC_PI_2 * (moving_kg / 2175.6f64).sqrt();
    for tolerance in ["1e-6", "1e-9", "1e-11", "1e-12"] {
        let found = run(&format!("{helix} tol={tolerance}"));
        assert_near(number(&found, "max_plate_displacement_time_s"), quarter_s, 1e-9);
    }
}

/// A stiff cocked spring pulls the plate away from the projectile at once, and pushes it when it is compressed: each event has the time of
/// the warning of its direction.
#[test]
fn the_two_limits_of_an_interface_are_told_apart() {
    let sets = ["v_i=50", "k=1e6", "n=0.3", "d=50mm", "gamma=7"];
    let arguments: Vec<&str> = sets.iter().flat_map(|set| ["--set", set]).collect();
    let page = crate::support::printed("run", &arguments);
    for (time, direction, warned) in [
        ("24.6053 us", "pull", "first at t = 24.61 us, the projectile would be pulled out"),
        ("245.476 us", "push", "first at t = 245.5 us, penetration would resume"),
    ] {
        let event = format!("{time}  interface limit exceeded: {direction}");
        assert!(page.contains(&event), "{event}: {page}");
        let words = page.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains(warned), "{warned}: {page}");
    }
}
