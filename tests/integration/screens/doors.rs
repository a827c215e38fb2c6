//! A study is one request, whichever door it is asked at: the request of a tab, shown as a command, makes the same rows there.

use cmra::tui::pages::explore::plan::sweep_plan;
use std::ops::ControlFlow;
use std::sync::Arc;

use super::bench::Bench;
use crate::support::{cmra, scene};
use cmra::tui::pages::search::state::Page;
use cmra::worker::studies::SearchRequest;
use cmra_studies::report::sweep::grid_csv;
use cmra_studies::study::context::{Context, Reach, never_cancel};
use cmra_studies::study::sweep::grid::{Grid, PIECE};

/// Changes to the baseline that between them have another interface, mount, spring, damper, threat and plate.
const SCENES: [&str; 5] = [
    "",
    "interface=plastic gamma=4 d=0.02 b=200",
    "mount=rigid h=20mm",
    "k=1e6 n=1.5 b=50 v_i=80",
    "m_p=9.5g R=3.81mm v_i=120 h=10mm k=2e5",
];
const NAME: &str = "thesis-baseline";

fn bench(pairs: &str) -> Bench {
    let mut bench = Bench::ascii(80, 24);
    bench.app.scene = Arc::new(scene(pairs));
    bench
}

/// The table that a command writes, or why it does not.
fn by_command(command: &str, pairs: &str) -> Result<String, String> {
    let mut words = command.split(' ');
    let mut program = cmra(words.next().unwrap(), &words.collect::<Vec<_>>());
    for pair in pairs.split(' ').filter(|pair| !pair.is_empty()) {
        program.args(["--set", pair]);
    }
    let output = program.args(["--csv", "-"]).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    if output.status.code() == Some(2) {
        return Err(text(output.stderr));
    }
    Ok(text(output.stdout))
}

/// The table of the Search tab.
fn by_tab(bench: &Bench, request: &SearchRequest) -> Result<String, String> {
    let scene = &bench.app.scene;
    let answer = request.run(scene, 2, &|_, _| ControlFlow::Continue(()));
    Ok(answer.map_err(|error| error.to_string())?.csv(scene, NAME, Reach::Complete))
}

#[test]
fn the_requests_of_the_search_tab_are_those_of_the_commands() {
    for pairs in SCENES {
        let bench = bench(pairs);
        for (page, bare) in [
            (Page::Seek, "seek --over d=0..0.5:65 --goal percent_of_baseline=60"),
            (Page::Front, "optimise"),
            (Page::Sensitivity, "sensitivity"),
            (Page::MonteCarlo, "montecarlo"),
        ] {
            let mut request = bench.app.search_request(page).unwrap();
            assert_eq!(request.command(), bare, "{pairs}: what nobody changed needs no option");
            match &mut request {
                SearchRequest::Seek(_) | SearchRequest::Sensitivity(_) => {}
                SearchRequest::Front(request) => request.samples = 64,
                SearchRequest::MonteCarlo(request) => request.samples = Some(20),
            }
            let command = request.command();
            match (by_tab(&bench, &request), by_command(&command, pairs)) {
                (Ok(here), Ok(there)) => assert_eq!(here, there, "{command} of {pairs}"),
                (Err(here), Err(there)) => assert!(there.contains(&here), "{here}: {there}"),
                (here, there) => panic!("{command} of {pairs}: {here:?}, {there:?}"),
            }
        }
    }
}

#[test]
fn the_points_of_explore_are_those_of_a_sweep() {
    for pairs in SCENES {
        let plan = Arc::new(sweep_plan(&bench(pairs).app).unwrap());
        let outputs: Vec<&str> = plan.outputs().iter().map(|output| output.name).collect();
        let over: Vec<String> = plan.axes().iter().map(|axis| format!("--over {axis}")).collect();
        let command = format!("sweep {} --outputs {}", over.join(" "), outputs.join(","));
        let mut watch = never_cancel;
        let grid = Grid::new(plan).unwrap().fill(PIECE, &mut Context::new(2, &mut watch));
        assert_eq!(
            Ok(grid_csv(NAME, &grid, Reach::Complete)),
            by_command(&command, pairs),
            "{command} of {pairs}"
        );
    }
}
