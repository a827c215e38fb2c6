//! Random scenes as a person would type them, and the scenes that such words make.

use std::sync::Arc;

use cmra_engine::model::scene::{Layer, Mount, Scene, SpringKind, Stack};
use cmra_engine::model::variables;

use crate::random::Random;
use crate::support::scene;

/// The scene of these words: variables, and `table=x:F,x:F`, in m and N; behind each ` / ` a further element of a
/// stack.
pub(crate) fn read(words: &str) -> Scene {
    let mut elements = words.split(" / ").map(read_one);
    let mut first = elements.next().unwrap();
    first.stack.layers = elements
        .map(|own| Layer { target: own.target, plate: own.plate, mechanism: own.mechanism })
        .collect();
    first
}

fn read_one(words: &str) -> Scene {
    let (tables, plain): (Vec<&str>, Vec<&str>) =
        words.split_whitespace().partition(|word| word.starts_with("table"));
    let mut own = scene(&plain.join(" "));
    for table in tables {
        let (_, points) = table.split_once('=').unwrap();
        let points = points.split(',').map(|point| {
            let (x, force) = point.split_once(':').unwrap();
            [x.parse().unwrap(), force.parse().unwrap()]
        });
        let points: Arc<[[f64; 2]]> = points.collect();
        own.mechanism.spring.table.points = points;
    }
    own
}

/// The plates of a stack one by one: the scene's own as often as it stands there, those that are not like it, and the base plate, which
/// cannot move.
pub(crate) fn plates(stack: &Scene) -> Vec<Scene> {
    let mut alone = stack.clone();
    alone.stack = Stack::default();
    let mut plates = Vec::new();
    while (plates.len() as f64) < stack.stack.elements {
        plates.push(alone.clone());
    }
    for layer in &stack.stack.layers {
        let (target, plate, mechanism) = (layer.target, layer.plate, layer.mechanism.clone());
        plates.push(Scene { target, plate, mechanism, ..alone.clone() });
    }
    let mut base = alone;
    base.plate.mount = Mount::Rigid;
    base.target.thickness_m = stack.stack.base_thickness_m.unwrap();
    plates.push(base);
    plates
}

fn chance(random: &mut Random, part: f64) -> bool {
    random.unit() < part
}

fn exponent(random: &mut Random, most: f64) -> f64 {
    if chance(random, 0.5) { random.of(&[0.5, 1.0, 1.5, 2.0]) } else { random.log(0.5, most) }
}

/// A moderate scene with the thesis's own spring.
pub(crate) fn plain(random: &mut Random) -> String {
    let n = exponent(random, 3.0);
    // The force at 5 mm.
    let k = random.log_or_zero(0.15, 1e3, 1e5) / 0.005_f64.powf(n);
    let law = format!("n={n} k={k:.3e}");
    around(random, &law)
}

/// Draws a scene with a plate that moves at first contact.
pub(crate) fn moving(random: &mut Random) -> String {
    loop {
        let words =
            format!("{} w_0={}", plain(random), random.of(&[1.0, -1.0]) * random.log(0.1, 60.0));
        if variables::validate(&read(&words)).is_ok() {
            return words;
        }
    }
}

/// Draws a scene with a nose that shears out a plug, on a rigid, a free or a sprung plate. A rigid cylinder shears plates of 0.6 D and more.
pub(crate) fn plugged(random: &mut Random) -> String {
    loop {
        let words = plain(random);
        let kept = words.split(' ').filter(|word| {
            let name = word.split('=').next().unwrap();
            !["h", "v_i", "dishing"].contains(&name)
        });
        let kept: Vec<&str> = kept.collect();
        let nose = random.of(&["fragment", "blunt"]);
        let metal = random.of(&["rho=2700 E=7e10", "rho=7850 E=2.07e11"]);
        let y = random.log(1e8, 1e9);
        let uts = y * (1.0 + 0.6 * random.unit());
        let r = random.log(3e-3, 1e-2);
        let m_p = 7850.0 * std::f64::consts::PI * r.powi(3) * random.log(1.0, 6.0);
        let least = if nose == "blunt" { 0.6 } else { 0.2 };
        let (h, v) = (2.0 * r * random.log(least, 2.5), random.log(60.0, 1200.0));
        let mount = match random.of(&[0, 1, 2]) {
            0 => " mount=rigid",
            1 => " k=0 b=0",
            _ => "",
        };
        let words = format!(
            "{} nose={nose} closure=cylindrical {metal} Y={y:e} UTS={uts:e} R={r:e} m_p={m_p:e} h={h:e} v_i={v:.1}{mount}",
            kept.join(" ")
        );
        if variables::changed(Scene::default(), &words)
            .is_ok_and(|own| variables::validate(&own).is_ok())
        {
            return words;
        }
    }
}

/// A scene of a heavy, slow body that falls on a plate, whose weight counts.
pub(crate) fn falling(random: &mut Random) -> String {
    loop {
        let words = if chance(random, 0.7) { plain(random) } else { curved(random) };
        let kept = words.split(' ').filter(|word| !word.starts_with("v_i="));
        let kept: Vec<&str> = kept.collect();
        let v = random.log(0.5, 20.0);
        let words = format!("{} v_i={v:.3} weight=on", kept.join(" "));
        if variables::validate(&read(&words)).is_ok() {
            return words;
        }
    }
}

/// A moderate scene with a spring of any other kind, alone or beside a power law.
pub(crate) fn curved(random: &mut Random) -> String {
    loop {
        let mut law = spring(random);
        if chance(random, 0.35) {
            let n = exponent(random, 3.0);
            let k = random.log(1e3, 1e5) / 0.005_f64.powf(n);
            law = format!("{law} combine=parallel n_2={n} k_2={k:.3e}");
        }
        let words = around(random, &law);
        if variables::validate(&read(&words)).is_ok() {
            return words;
        }
    }
}

/// A moderate scene by another interaction model.
pub(crate) fn modelled(random: &mut Random) -> String {
    loop {
        let words = plain(random);
        let model = match random.of(&[0, 1, 2]) {
            0 => {
                let given = chance(random, 0.8);
                let t_d = format!(" t_d={:e}", random.log(1e-5, 3e-4));
                format!("model=half-sine{}", if given { t_d } else { String::new() })
            }
            1 => "model=initial-velocity".to_owned(),
            _ => {
                let (load, stiffer) = (random.log(1e6, 1e8), random.log(1.0, 100.0));
                let given = chance(random, 0.8);
                let stiff = format!(" k_load={load:e} k_unload={:e}", load * stiffer);
                let b_2 = random.log_or_zero(0.4, 1.0, 1e3);
                format!("model=lumped b_2={b_2}{}", if given { stiff } else { String::new() })
            }
        };
        let words = format!("{words} {model}");
        let own = read(&words);
        // A blow that takes no time on a plate that stands at its stop: the law does not say what comes first.
        let at_once = model == "model=initial-velocity"
            && own.mechanism.stop.position_m.is_some_and(|at| at <= -own.plate.cocking_m);
        if !at_once && variables::validate(&own).is_ok() {
            return words;
        }
    }
}

/// A stack of two or three unlike elements on a base plate.
pub(crate) fn stacked(random: &mut Random) -> String {
    loop {
        let of_any = |random: &mut Random| {
            let words = if chance(random, 0.5) { plain(random) } else { curved(random) };
            // Thin and struck hard, so that something perforates; and the final state of a run.
            let kept = words.split(' ').filter(|word| {
                let name = word.split('=').next().unwrap();
                !["h", "v_i", "run.horizon_s", "theta", "interface", "g"].contains(&name)
            });
            let kept: Vec<&str> = kept.collect();
            format!("{} h={:e}", kept.join(" "), random.log(1e-3, 0.012))
        };
        let (v, g) = (random.log(100.0, 700.0), random.of(&[0.0, 0.1, 0.6]));
        let law = random.of(&["fused", "plastic"]);
        let theta = if chance(random, 0.2) { 50.0 * random.unit() } else { 0.0 };
        let base = random.log(2e-3, 0.03);
        let first = of_any(random);
        let mut words = format!(
            "{first} v_i={v:e} interface={law} g={g} theta={theta:.1}deg h_base={base:e} elements={}",
            random.of(&[1, 1, 2])
        );
        for _ in 0..random.of(&[0, 1, 2]) {
            words = format!("{words} / {}", of_any(random));
        }
        if variables::validate(&read(&words)).is_ok() {
            return words;
        }
    }
}

/// A spring of any kind.
fn spring(random: &mut Random) -> String {
    // Those with a form of their own more often.
    let kinds = [&SpringKind::WORDS[..], &["bistable", "column", "table"]].concat();
    let kind = random.of(&kinds);
    let law = match kind {
        "power-law" => {
            let n = exponent(random, 3.0);
            let k = random.log(1e3, 1e5) / 0.005_f64.powf(n);
            format!("n={n} k={k:.3e}")
        }
        "normalised" => format!(
            "n={} F_ref={} x_ref={}",
            exponent(random, 3.0),
            random.log(1e2, 1e5),
            random.log(1e-3, 2e-2)
        ),
        "prbm-cantilever" | "prbm-guided" => format!(
            "l_beam={} w_beam={} h_beam={}",
            random.log(0.01, 0.4),
            random.log(0.01, 0.05),
            random.log(1e-3, 0.02)
        ),
        "bistable" => {
            let second = random.log(1e-3, 0.03);
            let law = format!("x_2={second} F_bar={}", random.log(1e2, 5e4));
            if chance(random, 0.6) {
                format!("{law} x_u={:e}", second * (0.05 + 0.9 * random.unit()))
            } else {
                law
            }
        }
        "constant" => {
            format!("F_c={} x_c={}", random.log(1e2, 3e4), random.log(1e-5, 5e-3))
        }
        "column" => format!(
            "k_col={} F_crit={} F_plat={} x_fall={}",
            random.log(1e5, 1e8),
            random.log(1e2, 3e4),
            random.log_or_zero(0.15, 1e2, 3e4),
            random.log(1e-4, 1e-2)
        ),
        "crush" => format!(
            "F_crush={} x_crush={} k_crush={}",
            random.log(1e2, 3e4),
            random.log(4e-3, 3e-2),
            random.log(1e7, 1e9)
        ),
        "helix" => format!(
            "k_helix={} twist={} I_z={}",
            random.log_or_zero(0.1, 1e4, 1e7),
            random.log(5.0, 100.0),
            random.log(1e-7, 1e-4)
        ),
        _ => format!("table={}", table(random)),
    };
    let mut words = vec![format!("spring={kind}"), law];
    if chance(random, 0.2) {
        words.push(format!("N_spring={}", random.of(&[2.0, 3.0])));
    }
    if kind.starts_with("prbm") && chance(random, 0.3) {
        words.push("own_mass=counted".to_owned());
    } else if chance(random, 0.1) {
        words.push(format!("own_mass=counted m_spring={}", random.log(1e-3, 0.1)));
    }
    words.join(" ")
}

/// Points with springs that rise, fall, snap through and are level; often odd, at times with a force at rest, at times running
/// away beyond an end.
fn table(random: &mut Random) -> String {
    let odd = chance(random, 0.6);
    let count = random.of(&[2, 3, 4, 5, 8]);
    let mut at = if odd { 0.0 } else { -random.log(1e-4, 0.02) };
    let size = random.log(1e2, 2e4);
    let mut force = if odd { 0.0 } else { -size * random.unit() };
    let rising = chance(random, 0.5);
    let mut points = vec![format!("{at:e}:{force:e}")];
    for _ in 1..count {
        at += random.log(2e-4, 0.01);
        let step = size * random.unit();
        force += if rising { step } else { step * random.of(&[1.0, 1.0, -1.0, -0.5, 0.0]) };
        points.push(format!("{at:e}:{force:e}"));
    }
    points.join(",")
}

/// Everything around a spring: damper, bodies, interface, stop and horizon.
fn around(random: &mut Random, law: &str) -> String {
    let m = exponent(random, 2.0);
    // The force at 10 m/s.
    let b = random.log_or_zero(0.4, 10.0, 1e4) / 10_f64.powf(m);
    let d = random.log_or_zero(0.4, 1e-4, 0.02);
    let g = random.of(&[0.0, 0.1, 0.3, 0.6, 1.0]);
    let interface = if chance(random, 0.65) { "plastic" } else { "fused" };
    let (gamma, v, h) = (random.log(0.2, 8.0), random.log(30.0, 500.0), random.log(2e-3, 0.05));
    let horizon_s = random.log(3e-4, 2e-3);
    let mut words = vec![format!(
        "{law} m={m} b={b:.3e} d={d} gamma={gamma} v_i={v} h={h} interface={interface} g={g} run.horizon_s={horizon_s:e}"
    )];
    if chance(random, 0.2) {
        words.push(format!("theta={:.1}deg", 60.0 * random.unit()));
    }
    if chance(random, 0.1) {
        words.push("dishing=false".to_owned());
    }
    if chance(random, 0.04) {
        words.push("mount=rigid".to_owned());
    } else if chance(random, 0.7) {
        let gap = if chance(random, 0.1) { 0.0 } else { random.log(1e-5, 0.01 + d) };
        words.push(format!("x_stop={:e}", gap - d));
        if chance(random, 0.5) {
            // A plate that is pressed on a stop that loses nothing bounces a million times before its damper has stopped it.
            let most = if b == 0.0 { 1.0 } else { 0.9 };
            words.push(format!("stop_kind=rigid e={}", random.of(&[0.0, 0.2, 0.5, 0.8, most])));
        } else {
            let damping = random.log_or_zero(0.3, 1.0, 1e5);
            words.push(format!(
                "stop_kind=elastic k_stop={} b_stop={damping}",
                random.log(1e5, 1e9)
            ));
        }
    }
    words.join(" ")
}
