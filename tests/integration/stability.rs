//! Stability: what is promised for stiff and extreme scenes, held over ten thousand of them.

use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use cmra::model::impact::{Settings, simulate};
use cmra::model::run::{Outcome, Run};
use cmra::model::scene::Scene;

mod draw;

const SCENES: u64 = 10_000;
const RESIDUAL_MAX: f64 = 1e-8;
const STEPS_MAX: usize = 100_100;

#[derive(Clone, Debug)]
struct Shortfall {
    class: String,
    index: u64,
    detail: String,
}

fn run_of(scene: &Arc<Scene>, estimate: bool) -> (Run, bool) {
    let mut last = 0.0;
    let mut monotone = true;
    let run = simulate(scene, &Settings { series: false, estimate }, &mut |t_s: f64| {
        monotone &= t_s >= last || estimate;
        last = t_s;
        ControlFlow::Continue(())
    })
    .unwrap();
    (run, monotone)
}

fn measure(run: &Run) -> Option<f64> {
    match run.outcome {
        Outcome::Perforated => run.exit_time_s,
        Outcome::Arrested | Outcome::Separated => run.final_penetration_m,
        Outcome::Moving => None,
    }
}

fn check(index: u64) -> Option<Shortfall> {
    let changes = draw::changes(index);
    let scene = draw::scene(&changes);
    let fail =
        |class: &str, detail: String| Some(Shortfall { class: class.to_owned(), index, detail });
    let clock = std::time::Instant::now();
    let Ok((run, monotone)) = std::panic::catch_unwind(|| run_of(&scene, false)) else {
        return fail("panic", String::new());
    };
    let took = clock.elapsed().as_secs_f64();
    let residual = run.ledger.residual();
    let what = format!(
        "{} {:?} steps {} rej {} res {residual:.1e} {:.3}s {}",
        run.outcome.word(),
        run.end,
        run.cost.steps,
        run.cost.rejected,
        took,
        run.cost.method
    );
    if !run.end.is_complete() {
        return fail(&format!("end {:?}", run.end), what);
    }
    if run.outcome == Outcome::Moving {
        return fail("moving at horizon", what);
    }
    let numbers = [
        run.final_penetration_m,
        run.exit_time_s,
        run.max_plate_displacement_m,
        run.residual_velocity_m_s,
        Some(run.peak_contact_force_n),
    ];
    if numbers.iter().flatten().any(|z| !z.is_finite()) {
        return fail("not finite", what);
    }
    if !(residual.abs() < RESIDUAL_MAX) {
        return fail("energy", what);
    }
    if !monotone {
        return fail("time runs back", what);
    }
    if run.cost.steps + run.cost.rejected > STEPS_MAX {
        return fail("steps", what);
    }
    if index % 20 == 0 {
        let mut tight = (*scene).clone();
        tight.run.tolerance = 1e-11;
        let (second, _) = run_of(&Arc::new(tight), false);
        if second.outcome != run.outcome {
            return fail(
                "outcome by tolerance",
                format!("{what} / {} {:?}", second.outcome.word(), second.end),
            );
        }
        if let (Some(a), Some(b)) = (measure(&run), measure(&second)) {
            let differ = (a / b - 1.0).abs();
            if !(differ < 1e-7) {
                let (told, _) = run_of(&scene, true);
                let estimate = told.error_estimate.map_or(0.0, |e| e.relative);
                if !(estimate * 10.0 >= differ) {
                    return fail(
                        "tolerances differ silently",
                        format!("{what} differ {differ:.1e} estimate {estimate:.1e}"),
                    );
                }
                return fail(
                    "tolerances differ, told",
                    format!("{what} differ {differ:.1e} estimate {estimate:.1e}"),
                );
            }
        }
    }
    if took > 0.05 {
        return fail("slow", what);
    }
    None
}

fn sweep() -> Vec<Shortfall> {
    let next = AtomicU64::new(1);
    let mut all: Vec<Shortfall> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..2)
            .map(|_| {
                scope.spawn(|| {
                    let mut list = Vec::new();
                    loop {
                        let index = next.fetch_add(1, Ordering::Relaxed);
                        if index > SCENES {
                            return list;
                        }
                        list.extend(check(index));
                    }
                })
            })
            .collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    all.sort_by(|a, b| (&a.class, a.index).cmp(&(&b.class, b.index)));
    all
}

#[test]
fn ten_thousand() {
    let all = sweep();
    let mut text = String::new();
    for s in &all {
        let _ = writeln!(
            text,
            "{} | {} | {} |{}",
            s.class,
            s.index,
            s.detail,
            draw::typed(&draw::changes(s.index))
        );
    }
    std::fs::write("/tmp/w/T/sweep.txt", &text)
        .unwrap_or_else(|_| std::fs::write("/tmp/w/stability-sweep.txt", &text).unwrap());
}
