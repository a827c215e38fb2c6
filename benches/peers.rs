//! The contact phase beside the fastest peer solver, in one run: `cargo bench`.
//!
//! For each scene: the time of the loosest tolerance whose measured error, and that of all tighter ones, is below the target,
//! for this program and for `ode_solvers` DOP853 restarted at the located events (Hénon's trick: the event's own variable
//! becomes the independent one), both on one core. Error is the greater of the relative errors of depth and time, against the full track at a
//! far tighter tolerance. Absolute times hold for one machine on one day; the ratios are what counts.

use std::f64::consts::PI;
use std::hint::black_box;
use std::io::Write as _;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use cmra::model::impact::lean::Contact;
use cmra::model::impact::{Settings, simulate};
use cmra::model::scene::Scene;
use cmra::model::units::Bare;
use cmra::model::variables::set_by_name;
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, SVector, System};

type Y = SVector<f64, 5>;

/// Name and parameters (changes to Table 9.1 with gamma = 1, no spring, no damper).
const SCENES: [(&str, &str); 11] = [
    ("S1", "gamma=1"),
    ("S2", "k=1e5"),
    ("S3'", "gamma=3 k=1e6"),
    ("S4", "k=1e6 n=0.5"),
    ("S5", "k=1e5 n=0.3"),
    ("S7", "b=1000"),
    ("S8", "b=2000 k=1e5"),
    ("S9'", "b=1000 m=0.5"),
    ("S10", "d=0.5 k=1e5"),
    ("S15", "k=1e9"),
    ("S17", "h=0.003 v_i=400 k=1e5"),
];
const TARGET: f64 = 1e-8;

/// What the equations run on.
#[derive(Clone, Copy)]
enum Independent {
    Time,
    Travel,
    Slip,
}

/// The contact phase, nondimensional: lengths by R, velocities by `v_i`; the state is `(q, u, x, w, t)`.
#[derive(Clone, Copy)]
struct Peer {
    strength: f64,
    drag: f64,
    mass_ratio: f64,
    spring: (f64, f64),
    damper: (f64, f64),
    slope: f64,
    thickness: f64,
    bend: f64,
    independent: Independent,
    /// Travel at which a stretch ends.
    kink: f64,
}

impl Peer {
    fn of(scene: &Scene) -> Self {
        let (m, r, v) = (
            scene.projectile.mass_kg,
            scene.projectile.tip_radius_m,
            scene.projectile.velocity_m_s,
        );
        let law = &scene.mechanism;
        let thickness = scene.target.thickness_m / r;
        Self {
            strength: scene.target.flow_strength_pa * r.powi(3) / (m * v * v),
            drag: scene.drag_kg_m3() * r.powi(3) / m,
            mass_ratio: scene.plate.mass_ratio,
            spring: (
                law.spring.coefficient * r.powf(law.spring.exponent) * r / (m * v * v),
                law.spring.exponent,
            ),
            damper: (
                law.damper.coefficient * v.powf(law.damper.exponent) * r / (m * v * v),
                law.damper.exponent,
            ),
            slope: thickness / (thickness + 2.0),
            thickness,
            bend: thickness + 2.0,
            independent: Independent::Time,
            kink: f64::INFINITY,
        }
    }

    fn depth(&self, q: f64) -> f64 {
        if q <= self.bend { q * self.slope } else { q - 2.0 }
    }

    fn area(&self, q: f64) -> f64 {
        let section = |p: f64| {
            if p <= 0.0 {
                0.0
            } else if p < 1.0 {
                PI * p * (2.0 - p)
            } else {
                PI
            }
        };
        let p = self.depth(q);
        section(p) - section(p - self.thickness)
    }

    fn kinks(&self) -> [f64; 3] {
        let travel = |p: f64| if p <= self.thickness { p / self.slope } else { p + 2.0 };
        let mut kinks = [travel(1.0), self.bend, travel(self.thickness + 1.0)];
        kinks.sort_by(f64::total_cmp);
        kinks
    }
}

fn odd(z: f64, (k, n): (f64, f64)) -> f64 {
    if k == 0.0 {
        0.0
    } else if (n - 1.0).abs() < 1e-15 {
        k * z
    } else {
        k * z.abs().powf(n) * z.signum()
    }
}

impl System<f64, Y> for Peer {
    fn system(&self, _: f64, y: &Y, dy: &mut Y) {
        let f = self.area(y[0]) * (self.strength + self.drag * y[1] * y[1]);
        let w = (f - odd(y[3], self.damper) - odd(y[2], self.spring)) / self.mass_ratio;
        let rate = [y[1], -f - w, y[3], w, 1.0];
        let per = match self.independent {
            Independent::Time => 1.0,
            Independent::Travel => 1.0 / rate[0],
            Independent::Slip => 1.0 / rate[1],
        };
        for (dy, rate) in dy.iter_mut().zip(rate) {
            *dy = rate * per;
        }
    }

    fn solout(&mut self, _: f64, y: &Y, _: &Y) -> bool {
        matches!(self.independent, Independent::Time) && (y[1] < 0.0 || y[0] > self.kink)
    }
}

fn integrate(peer: Peer, from: f64, to: f64, y: Y, tolerance: f64) -> Option<Y> {
    let mut solver = Dop853::from_param(
        peer,
        from,
        to,
        0.0,
        y,
        tolerance,
        tolerance,
        0.9,
        0.0,
        0.333,
        6.0,
        (to - from).abs(),
        0.0,
        100_000,
        1_000_000,
        OutputType::Sparse,
    );
    solver.integrate().ok()?;
    solver.y_out().last().copied()
}

/// (time, depth) in the scene's units of R/v and R; the flag tells an arrest.
fn peer_contact(peer: &Peer, tolerance: f64) -> Option<(f64, f64)> {
    let mut y = Y::from([0.0, 1.0, 0.0, 0.0, 0.0]);
    y[2] = peer_start(peer);
    for kink in peer.kinks() {
        let time = Peer { kink, independent: Independent::Time, ..*peer };
        y = integrate(time, 0.0, 1e4, y, tolerance)?;
        if y[0] > kink {
            let travel = Peer { independent: Independent::Travel, ..*peer };
            y = integrate(travel, y[0], kink, y, tolerance)?;
            y[0] = kink;
            continue;
        }
        let slip = Peer { independent: Independent::Slip, ..*peer };
        y = integrate(slip, y[1], 0.0, y, tolerance)?;
        return Some((y[4], peer.depth(y[0])));
    }
    Some((y[4], peer.depth(y[0])))
}

thread_local! {
    /// Where the plate starts, in R (set per scene; the peer's system has no other state).
    static START: std::cell::Cell<f64> = const { std::cell::Cell::new(0.0) };
}

fn peer_start(_: &Peer) -> f64 {
    START.get()
}

fn scene(pairs: &str) -> Scene {
    let mut scene = Scene::default();
    scene.mechanism.spring.coefficient = 0.0;
    for pair in pairs.split_whitespace() {
        let (name, value) = pair.split_once('=').expect("name=value");
        set_by_name(&mut scene, name, value, Bare::Si).expect("a legal value");
    }
    scene
}

/// (time, depth) by the full track.
fn track(scene: &Arc<Scene>) -> (f64, f64) {
    let settings = Settings { series: false, estimate: false };
    let run =
        simulate(scene, &settings, &mut |_| ControlFlow::Continue(())).expect("a legal scene");
    let arrest = run.first_arrest.map(|arrest| (arrest.t_s, arrest.penetration_m));
    arrest.or_else(|| run.exit_time_s.zip(run.final_penetration_m)).unwrap_or((f64::NAN, f64::NAN))
}

/// Minimum time of a call, s.
fn minimum(mut call: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..300 {
        let start = Instant::now();
        for _ in 0..20 {
            call();
        }
        let took = start.elapsed().as_secs_f64() / 20.0;
        best = if took < best { took } else { best };
    }
    best
}

/// Time and tolerance of the loosest setting from which on all tighter ones meet the target.
fn cheapest(
    error: impl Fn(f64) -> f64,
    mut time: impl FnMut(f64) -> f64,
) -> Option<(f64, f64, f64)> {
    let tolerances: Vec<f64> = (3..=13).map(|digits| 10f64.powi(-digits)).collect();
    let keeps = tolerances.iter().rposition(|tolerance| {
        let error = error(*tolerance);
        error.is_nan() || error > TARGET
    });
    let first = keeps.map_or(0, |last_miss| last_miss + 1);
    let tolerance = *tolerances.get(first)?;
    Some((time(tolerance), tolerance, error(tolerance)))
}

fn main() {
    let mut out = std::io::stdout().lock();
    let mut line = |text: String| writeln!(out, "{text}").expect("standard output");
    line(format!("contact phase at measured error {TARGET:e}; us per run, minimum; one core"));
    line(
        "scene  this program      tol     error    DOP853 peer    tol     error    ratio"
            .to_owned(),
    );
    for (name, pairs) in SCENES {
        let scene = scene(pairs);
        let (r, v) = (scene.projectile.tip_radius_m, scene.projectile.velocity_m_s);
        let tight = Arc::new(Scene {
            run: cmra::model::scene::RunSettings { tolerance: 1e-13, horizon_s: None },
            ..scene.clone()
        });
        let exact = track(&tight);
        let off = |(t, p): (f64, f64)| {
            let (a, b) = ((t / exact.0 - 1.0).abs(), (p / exact.1 - 1.0).abs());
            if a > b || a.is_nan() { a } else { b }
        };
        START.set(-scene.plate.cocking_m / r);
        let contact = Contact::of(&scene);
        let lean = contact.run(1e-6).is_some();
        let with = |tolerance: f64| {
            let mut scene = scene.clone();
            scene.run.tolerance = tolerance.clamp(1e-14, 1e-2);
            Arc::new(scene)
        };
        let ours = cheapest(
            |tolerance| {
                let end = contact.run(tolerance).filter(|_| lean);
                off(end.map_or_else(|| track(&with(tolerance)), |end| (end.t_s, end.penetration_m)))
            },
            |tolerance| {
                if lean {
                    minimum(|| {
                        black_box(Contact::of(black_box(&scene)).run(tolerance));
                    })
                } else {
                    let scene = with(tolerance);
                    minimum(|| {
                        black_box(track(black_box(&scene)));
                    })
                }
            },
        );
        let peer = Peer::of(&scene);
        let theirs = cheapest(
            |tolerance| {
                peer_contact(&peer, tolerance)
                    .map_or(f64::INFINITY, |(t, p)| off((t * r / v, p * r)))
            },
            |tolerance| {
                minimum(|| {
                    black_box(peer_contact(black_box(&peer), tolerance));
                })
            },
        );
        let show = |cell: Option<(f64, f64, f64)>| {
            cell.map_or_else(
                || "   none reaches it        ".to_owned(),
                |(time, tolerance, error)| {
                    format!("{:9.2}  {tolerance:7.0e}  {error:8.1e}", time * 1e6)
                },
            )
        };
        let ratio = ours.zip(theirs).map_or(f64::NAN, |(ours, theirs)| theirs.0 / ours.0);
        let path = if lean { "lean" } else { "full" };
        line(format!("{name:5} {path} {}   {}  {ratio:6.2}", show(ours), show(theirs)));
    }
}
