//! Charts and maps as SVG, and reports in one file: read by an XML parser.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use roxmltree::{Document, ParsingOptions};

use crate::support::{Done, in_folder};

fn svg_of(place: &Path, arguments: &str) -> String {
    let done = in_folder(place, &format!("{arguments} --svg picture.svg --force"));
    assert_eq!(done.code, 0, "{arguments}: {}", done.err);
    assert!(done.err.contains("wrote picture.svg"), "{}", done.err);
    fs::read_to_string(place.join("picture.svg")).unwrap()
}

fn texts(read: &Document<'_>) -> Vec<String> {
    let texts =
        read.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")));
    texts.filter_map(|node| node.text().map(str::to_owned)).collect()
}

/// The picture is XML, nothing lies outside it, no number is missing, and these texts stand in it.
fn check(svg: &str, expected: &[&str]) {
    let read = Document::parse(svg).unwrap();
    let found = texts(&read);
    for text in expected {
        assert!(found.iter().any(|one| one == text), "no `{text}` in {found:?}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    for node in read.descendants() {
        for (key, most) in [("x", 640.0), ("x1", 640.0), ("x2", 640.0), ("cx", 640.0)] {
            if let Some(value) = node.attribute(key) {
                let value: f64 = value.parse().unwrap();
                assert!((0.0..=most).contains(&value), "{key} = {value}");
            }
        }
    }
}

#[test]
fn a_run_is_drawn_with_the_law_of_its_mechanism() {
    let place = tempfile::tempdir().unwrap();
    let svg = svg_of(place.path(), "run");
    let axes = [
        "penetration p [mm]",
        "plate displacement x [mm]",
        "contact force F [kN]",
        "force of the mechanism F(x) [kN]",
        "stiffness of the mechanism dF/dx [kN/m]",
        "t [us]",
    ];
    check(&svg, &axes);
    // The spring is linear: two points tell its stiffness, 100 kN/m.
    let svg = svg_of(place.path(), "run concept-cocked-cantilever");
    check(&svg, &["greatest stress over yield strength", "yield", "cocked"]);
    let done = in_folder(place.path(), "run --svg -");
    check(&done.out, &axes);
    assert_eq!(
        in_folder(place.path(), "run --svg picture.svg").code,
        2,
        "nothing is replaced unasked"
    );
    assert_eq!(in_folder(place.path(), "run --json --svg -").code, 2);
}

#[test]
fn sweeps_limits_and_comparisons_are_drawn() {
    let place = tempfile::tempdir().unwrap();
    let curve = svg_of(place.path(), "sweep --over gamma=1..7:7 --outputs stroke_m");
    check(&curve, &["gamma", "stroke [mm]", "1", "7"]);
    let read = Document::parse(&curve).unwrap();
    let line = read.descendants().find(|node| node.attribute("points").is_some()).unwrap();
    let points: Vec<&str> = line.attribute("points").unwrap().split(' ').collect();
    assert_eq!(points.len(), 7);
    // The axis runs from the left edge of the plot to its right edge.
    assert!(points[0].starts_with("72,") && points[6].starts_with("616,"), "{points:?}");
    let map = svg_of(place.path(), "sweep --over gamma=1..7:7 --over k=1e4,1e5,1e6 --csv map.csv");
    check(
        &map,
        &["gamma", "k [MN/m^n]", "% of rigid-mount depth", "[%]", "max plate displacement"],
    );
    let limit = svg_of(place.path(), "limit");
    check(
        &limit,
        &["impact velocity [m/s]", "residual velocity [m/s]", "ballistic limit", "through"],
    );
    let map = svg_of(place.path(), "compare --map v_i=10..90:5,gamma=0.5..7:5:log");
    check(&map, &["mass efficiency", "v_i [m/s]", "gamma"]);
    let colours: HashSet<&str> =
        map.split("fill=\"rgb").skip(1).filter_map(|it| it.split('"').next()).collect();
    assert!(colours.len() > 2, "{colours:?}");
    for arguments in ["compare --svg a.svg", "sweep --over gamma=1..2:3 --shard 1/2 --svg a.svg"] {
        let Done { code, err, .. } = in_folder(place.path(), arguments);
        assert_eq!((code, err.lines().count()), (2, 1), "{err}");
    }
}

#[test]
fn a_report_is_one_file_that_links_to_nothing() {
    let place = tempfile::tempdir().unwrap();
    fs::write(
        place.path().join("own.toml"),
        "format = 1\ntitle = \"<b> & co\"\n[plate]\nmass_ratio = 3.0\n[sweep]\naxes = [{ name = \"gamma\", values = [1, 2, 4] }]\n\
         outputs = [\"stroke_m\"]\n",
    )
    .unwrap();
    let done = in_folder(place.path(), "report own.toml --set v_i=90 -o report.html");
    assert_eq!(done.code, 0, "{}", done.err);
    let html = fs::read_to_string(place.path().join("report.html")).unwrap();
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let read = Document::parse_with_options(&html, options).unwrap();
    for node in read.descendants() {
        for attribute in ["href", "src", "data"] {
            assert_eq!(node.attribute(attribute), None, "{}", node.tag_name().name());
        }
    }
    assert!(!html.contains("url(") && !html.contains("@import") && !html.contains("<script"));
    let cells: Vec<&str> = read
        .descendants()
        .filter(|node| node.tag_name().name() == "td")
        .filter_map(|node| node.text())
        .collect();
    let row = |symbol: &str| cells.iter().position(|cell| *cell == symbol).map(|at| cells[at + 2]);
    assert_eq!((row("gamma"), row("v_i")), (Some("3"), Some("90")));
    assert!(cells.contains(&"final_penetration_m"), "{cells:?}");
    // The kinetic energy of 29.5 g at 90 m/s, where the text page has it.
    assert!(cells.contains(&"119.475 J"), "{cells:?}");
    let svgs = read.descendants().filter(|node| node.tag_name().name() == "svg").count();
    assert!(svgs >= 7, "{svgs} pictures");
    // The scene in it is a scene file that gives the same run.
    let code = read.descendants().find(|node| node.tag_name().name() == "code").unwrap();
    fs::write(place.path().join("again.toml"), code.text().unwrap()).unwrap();
    let depth = |arguments: &str| {
        let json: serde_json::Value =
            serde_json::from_str(&in_folder(place.path(), arguments).out).unwrap();
        json["final_penetration_m"].clone()
    };
    assert_eq!(depth("run again.toml --json"), depth("run own.toml --set v_i=90 --json"));

    let done = in_folder(place.path(), "report own.toml --set v_i=90 -o -");
    assert_eq!((done.code, done.out), (0, html), "{}", done.err);
    let done = in_folder(place.path(), "report -o report.pdf");
    assert_eq!(done.code, 2);
    assert!(done.err.contains("a report is .html, for example -o report.html"), "{}", done.err);
}
