//! The contact phase beside other solvers, in one run: `cargo bench -p cmra-benches [-- S4 S13]`, then the surfaces of chapter 9
//! (`surfaces.rs`; alone: `-- surfaces`) and whole runs by each method (`runs.rs`; alone: `-- runs`). A thousand random scenes by
//! each method take minutes and run alone only (`methods.rs`: `-- methods`).
//!
//! Eighteen scenes from first contact to first arrest or exit, on one core. Each solver runs at its loosest tolerance whose
//! *measured* error, and that of all tighter ones, is below 1e-8: the greater of the relative errors of depth and time, against
//! answers that come from none of them (`scenes.rs`). This program is asked through `first_contact.rs`, prepared
//! scene to answer, nothing kept between runs. Batches of all solvers alternate, so that a drift of the machine cancels in the
//! ratios. Absolute times hold for one machine on one day.

mod equations;
mod explicit;
mod first_contact;
mod methods;
mod runs;
mod scenes;
mod solvers;
mod stiff;
mod surfaces;
mod timing;

use std::io::Write;

use equations::Equations;
use first_contact::first_contact;
use scenes::{Reference, SCENES, scene};
use solvers::{PEERS, Reach, ours};
use timing::{TARGET, Times, Tuned, alternate, tune};

/// Scenes on which implicit peers are worth their time.
const STIFF: [&str; 4] = ["S13", "S14'", "S15", "S16'"];
/// The arguments that run the surfaces, the whole runs or the random scenes, only.
const SURFACES: &str = "surfaces";
const RUNS: &str = "runs";
const METHODS: &str = "methods";

fn main() -> std::io::Result<()> {
    let asked: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    let mut out = std::io::stdout().lock();
    if asked.iter().any(|asked| asked == METHODS) {
        return methods::print(&mut out);
    }
    let wants = |part: &str| asked.is_empty() || asked.iter().any(|asked| asked == part);
    if !asked.iter().any(|asked| [SURFACES, RUNS].contains(&asked.as_str())) {
        contacts(&mut out, &asked)?;
    }
    if wants(SURFACES) {
        surfaces::print(&mut out)?;
    }
    if wants(RUNS) {
        runs::print(&mut out)?;
    }
    Ok(())
}

fn contacts(out: &mut impl Write, asked: &[String]) -> std::io::Result<()> {
    writeln!(
        out,
        "contact phase at measured error {TARGET:e}; us per run: minimum (+ how far the median lies above), one core"
    )?;
    writeln!(
        out,
        "{:5} {:6} {:>6} {:>16} {:>7} {:>8}   {:12} {:>16} {:>7} {:>8}  {:>7}  {:>13}  reference",
        "scene",
        "path",
        "",
        "this program",
        "tol",
        "error",
        "peer",
        "us",
        "tol",
        "error",
        "ratio",
        "quarters"
    )?;
    for (name, pairs) in SCENES {
        let plain = name.trim_end_matches('\'');
        if asked.is_empty() || asked.iter().any(|asked| asked == plain) {
            row(out, name, pairs)?;
        }
    }
    writeln!(
        out,
        "ratio: peer / this program, of the minima; quarters: of the ratios round by round"
    )?;
    writeln!(out, "(a): its most accurate answer; it does not reach {TARGET:e}")
}

fn row(out: &mut impl Write, name: &str, pairs: &str) -> std::io::Result<()> {
    let base = scene(pairs, 1e-9);
    let reference = Reference::new(name, &base);
    let equations = Equations::from_scene(&base);
    let path = first_contact(&base).map_or("none", |end| end.kernel);
    let Some(own) = tune(|tolerance| ours(pairs, tolerance), |end| reference.error(end)) else {
        return writeln!(out, "{name:5} {path:6} no answer at any tolerance");
    };
    let mut names = vec![""];
    let mut tuned = vec![own];
    for peer in PEERS {
        if peer.reach == Reach::All || STIFF.contains(&name) {
            let found =
                tune(|tolerance| (peer.prepare)(&equations, tolerance), |end| reference.error(end));
            if let Some(found) = found {
                names.push(peer.name);
                tuned.push(found);
            }
        }
    }
    let times = alternate(&mut tuned);
    let own = cell(&tuned[0], &times[0]);
    for index in 1..tuned.len() {
        let ratio = times[index].min_s() / times[0].min_s();
        let (low, high) = times[index].ratio_quarters(&times[0]);
        let head = if index == 1 {
            format!("{name:5} {path:6} {:>6} {own}", "")
        } else {
            format!("{:19} {:35}", "", "")
        };
        let source = if index == 1 { reference.source } else { "" };
        let peer = cell(&tuned[index], &times[index]);
        writeln!(
            out,
            "{head}   {:12} {peer}  {ratio:7.2}  {low:6.2} {high:6.2}  {source}",
            names[index]
        )?;
    }
    out.flush()
}

/// Time, spread, tolerance and error.
fn cell(tuned: &Tuned, times: &Times) -> String {
    let mark = if tuned.meets { ' ' } else { 'a' };
    format!(
        "{:9.3} (+{:3.0}%) {:7.0e} {:8.1e}{mark}",
        times.min_s() * 1e6,
        100.0 * times.spread(),
        tuned.tolerance,
        tuned.error,
    )
}
