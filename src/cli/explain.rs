//! `cmra explain [NAME]`: a page about a variable, a quantity, a warning or a word of a screen, or a list of all.

use std::fmt::Write as _;

use clap::Args;

use crate::cli::text::{self, hanging};
use crate::cli::{CliError, output};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::shortest;
use cmra_engine::model::variables::{Group, VARIABLES, Variable, find, nearest, used_where};
use cmra_studies::report::wrap::wrap;
use cmra_studies::study::envelope::Check;
use cmra_studies::study::quantities::{self, QUANTITIES, Quantity};

mod words;

#[derive(Debug, Args)]
pub(super) struct ExplainArguments {
    /// A variable by symbol, name or key (gamma, thickness), a quantity (`limit_velocity_m_s`), a warning ('plate face') or a word of a
    /// screen (areal), or a key of JSON (complete); without it: all but the keys
    name: Option<String>,
}

pub(super) fn run(arguments: &ExplainArguments) -> Result<(), CliError> {
    let page = match &arguments.name {
        None => list(),
        Some(name) => pages(name.trim())?.join("\n"),
    };
    output::print(&page)
}

/// Returns the pages about a name, which may contain blanks: of a quantity or variable, a warning, or both; else of a word or a choice.
fn pages(name: &str) -> Result<Vec<String>, CliError> {
    let spelled = name.replace([' ', '-'], "_");
    let quantity = quantities::find(name).or_else(|| quantities::find(&spelled));
    let variable = || find(name).or_else(|_| find(&spelled)).ok();
    let unknown = || {
        CliError::Option(format!(
            "`{name}` is neither a variable ({}) nor a quantity ({}) nor a warning ({}) nor a word of a screen nor a key of a file",
            nearest(name),
            quantities::nearest(name),
            Check::WORDS.join(", ")
        ))
    };
    let is_it = |check: &Check| check.label().eq_ignore_ascii_case(name);
    let warning = Check::ALL.into_iter().find(is_it).map(|it| {
        let lines = wrap(it.about(), text::width().saturating_sub(2));
        format!("{}: a warning\n  {}\n", it.label(), lines.join("\n  "))
    });
    let other = quantity.map(quantity_page).or_else(|| variable().map(variable_page));
    let found: Vec<String> = other.into_iter().chain(warning).collect();
    if !found.is_empty() {
        return Ok(found);
    }
    let is_word = |words: &[&str]| words.iter().any(|word| word.eq_ignore_ascii_case(name));
    // `A` and `a` differ.
    let exact = words::all().find(|(words, _)| words.contains(&name));
    let on_screen = exact.or_else(|| words::all().find(|(words, _)| is_word(words)));
    let choices = VARIABLES.iter().filter(|it| it.keys().contains(&name)).map(variable_page);
    let words: Vec<String> = on_screen
        .into_iter()
        .map(|(_, about)| hanging(&format!("{name}: "), about, 2))
        .chain(choices)
        .collect();
    if !words.is_empty() {
        return Ok(words);
    }
    if let Some(about) = key_words(name) {
        return Ok(vec![hanging(&format!("{name}: "), &about, 2)]);
    }
    let titled = [name, &name.to_lowercase()].map(quantities::named).into_iter().flatten().next();
    if let Some(quantity) = titled {
        return Ok(vec![quantity_page(quantity)]);
    }
    // The line of a page may have a unit or more after its label: `mount force, kN`.
    name.rsplit_once(", ").and_then(|(label, _)| pages(label).ok()).ok_or_else(unknown)
}

/// Returns the explanation of a key of JSON or CSV: its own, or that of its family, then that of the quantity or key in it.
fn key_words(key: &str) -> Option<String> {
    let own = |key: &str| words::keys().find(|(keys, _)| keys.contains(&key)).map(|it| it.1);
    let of_family = |(part, adds): &(&str, &str)| {
        let rest = key.replacen(part, "", 1);
        let quantity = quantities::find(&rest).map(|it| it.meaning);
        let about = quantity.or_else(|| own(&rest)).filter(|_| rest != key)?;
        Some(format!("{adds}: {about}"))
    };
    own(key).map(str::to_owned).or_else(|| words::FAMILIES.iter().find_map(of_family))
}

fn variable_page(variable: &Variable) -> String {
    let mut page = format!("{}: {}\n", variable.symbol, variable.meaning);
    let mut line = |label: &str, text: &str| {
        let _ = writeln!(page, "  {label:<12} {text}");
    };
    line("name", &variable.name());
    line("key", variable.key);
    if !variable.aliases.is_empty() {
        line("also", &variable.aliases.join(", "));
    }
    line("default", &default_of(variable));
    line("allowed", &variable.allowed());
    if let Some((low, high)) = variable.thesis_range {
        let unit = variable.unit();
        line("thesis", format!("{} to {} {unit}", shortest(low), shortest(high)).trim_end());
    }
    if let Some(used) = used_where(variable, &Scene::default()) {
        line("used", &used);
    }
    line("source", variable.source);
    line("for example", &format!("--set {}={}", variable.symbol, example(variable)));
    page
}

/// A value to write: the default, or the first word of a choice that is not.
fn example(variable: &Variable) -> String {
    let default = variable.show(&Scene::default());
    let other = variable.keys().iter().find(|word| **word != default);
    other.map_or(default, |word| (*word).to_owned())
}

fn quantity_page(quantity: &Quantity) -> String {
    let mut page = format!("{}: {}\n", quantity.name, quantity.meaning);
    let unit = quantity.unit();
    let usable = "sweep --outputs, seek --goal, optimise --minimise, --maximise and --subject-to, montecarlo --outputs, sensitivity --output";
    let unit = if unit.is_empty() { "none" } else { unit };
    for (label, text) in
        [("unit", unit), ("needs", quantity.needs().words()), ("usable in", usable)]
    {
        let _ = writeln!(page, "  {label:<12} {text}");
    }
    page
}

/// Formats the default of a variable with its unit.
fn default_of(variable: &Variable) -> String {
    let value = variable.show(&Scene::default());
    // A word in the place of a number has no unit.
    let unit = if value.parse::<f64>().is_ok() { variable.unit() } else { "" };
    format!("{value} {unit}").trim_end().to_owned()
}

/// Formats name and meaning of a variable; words that both begin with appear once.
fn name_and_meaning(variable: &Variable) -> String {
    let (name, meaning) = (variable.name(), variable.meaning);
    let rest = meaning.strip_prefix(&name.replace('_', " "));
    match rest.filter(|rest| !rest.starts_with(char::is_alphanumeric)) {
        Some(rest) => format!("{name}{rest}"),
        None => format!("{name}: {meaning}"),
    }
}

/// All variables by their groups, then all quantities.
fn list() -> String {
    let mut page = "VARIABLES: symbol, default, name and meaning\n".to_owned();
    for group in Group::ALL {
        let own: Vec<&Variable> = VARIABLES.iter().filter(|it| it.group == group).collect();
        // As narrow as the group allows: the meaning has the rest of the line.
        let widest = |text: fn(&Variable) -> String| {
            own.iter().map(|it| text(it).chars().count()).max().unwrap_or(0)
        };
        let (symbols, defaults) = (widest(|it| it.symbol.to_owned()), widest(default_of));
        let _ = writeln!(page, "\n{}", group.title());
        for it in own {
            let lead = format!("  {:symbols$}  {:defaults$}  ", it.symbol, default_of(it));
            page += &hanging(&lead, &name_and_meaning(it), lead.chars().count());
        }
    }
    page.push_str("\nQUANTITIES: name, what has to be computed, meaning\n\n");
    for quantity in QUANTITIES {
        let Quantity { name, meaning, .. } = quantity;
        let _ = writeln!(page, "  {name:<33} {:<7} {meaning}", quantity.needs().word());
    }
    page.push_str(
        "\nscene: no simulation; run: one simulation; course: one simulation and its time series; limit: a search with many shots, only on request\n\nWARNINGS: ",
    );
    page += &Check::WORDS.join(", ");
    page.push_str("\n\n");
    let words: Vec<&str> = words::all().flat_map(|(words, _)| words.iter().copied()).collect();
    page += &hanging("WORDS of screens: ", &words.join(", "), 2);
    page.push_str("\n`cmra explain NAME` explains one.\n");
    page
}

#[cfg(test)]
mod tests {
    use super::*;
    use cmra_engine::model::run::{ContactMode, EventKind};

    use std::collections::BTreeSet;
    use std::fs;
    use std::path::Path;

    /// Words of screens that have their everyday meaning, are parts of names, or are cut off at the edge of a pane.
    const PLAIN: &str = "\
        acceleration action also analysis assembly back buckling bundled cancels cantilever change chart charts close cmra \
        coeffic comparing compatibility computed contact controlled curve curves dissipation distance distribution \
        does done ease emergent enlarge enter every expo export figure file final find finite first flight flow force \
        four-bar fourth free from greatest heavy-plate helical impact induction inertia input keys last line lists load loaded \
        manufacture many mass meaning measuring method methods mine minimization more move name near next none nothing oasl \
        order other over overwrite page pane play points position presets quit quits rate reduction rejection \
        relative removes reset result results resume ricochet rigid-mount rotating running same save scenes scroll second \
        sectional shift-tab show shown shows shuttle side simulation small space spacing speed start strain strengt stress \
        target thesis-base thesis-baseline times transfer tube type undo unit value values variable variables vary wanted wire \
        with would write your zoom";

    /// Functions whose string arguments are shown as labels, with the index of the label among them, and fields of labels.
    const LABELLED: [(&str, usize); 16] = [
        (".with(", 1),
        ("column(table,", 1),
        ("Axis::over(", 0),
        ("Axis::new(", 0),
        ("Curve::new(", 0),
        ("Chart::new(", 0),
        ("Mark::new(", 0),
        (".tag(", 0),
        ("Remark::new(", 0),
        ("Remark::caution(", 0),
        ("PaneFrame::new(", 0),
        ("Choice::new(", 0),
        ("label: ", 0),
        ("name: ", 0),
        ("title: ", 0),
        ("words: ", 0),
    ];

    fn files_below(folder: &str, ending: &str) -> Vec<String> {
        let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
        let mut texts = Vec::new();
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).expect("a folder of the repository") {
                let path = entry.expect("an entry").path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|it| it == ending) {
                    texts.push(fs::read_to_string(path).expect("a text"));
                }
            }
        }
        assert!(texts.len() > 10, "{folder}: {}", texts.len());
        texts
    }

    /// Returns the parts of a screen of at most three words: heads of columns, titles, labels and legends.
    fn labels_of_screen(snapshot: &str) -> Vec<String> {
        let screen = snapshot.splitn(3, "---\n").nth(2).unwrap_or_default();
        let is_text = |c: char| c.is_ascii_alphanumeric() || " .,:;()[]%/'_^!-\n".contains(c);
        let text: String = screen.chars().map(|c| if is_text(c) { c } else { '\t' }).collect();
        let text = text.replace("--", "\t").replace("  ", "\t");
        let parts = text.split(['\t', '\n']).map(str::trim);
        parts.filter(|it| it.split_whitespace().count() <= 3).map(str::to_owned).collect()
    }

    /// Returns the labels of at most four words in a source file.
    fn labels_of_source(source: &str) -> Vec<String> {
        let code = source.split("#[cfg(test)]").next().unwrap_or_default();
        let mut labels = Vec::new();
        for (opener, index) in LABELLED {
            for (at, _) in code.match_indices(opener) {
                let rest = code[at + opener.len()..].trim_start();
                let literals: Vec<&str> = rest.split('"').take(4).collect();
                // The first argument is a string, or the mark of a curve.
                let is_label = literals[0].is_empty() || literals[0].starts_with('\'');
                let label =
                    literals.get(2 * index + 1).filter(|_| is_label && literals[0].len() < 8);
                labels.extend(label.map(|it| it.trim().to_owned()));
            }
        }
        labels.retain(|it| it.split_whitespace().count() <= 4);
        labels
    }

    /// Returns `true` for a word, `false` for a number, a symbol or a row of the marks of a chart.
    fn is_word(text: &str) -> bool {
        let letters: Vec<char> = text.chars().collect();
        let is_marks = BTreeSet::from_iter(&letters).len() <= 2
            || letters.windows(3).any(|it| it[0] == it[1] && it[1] == it[2]);
        letters.len() >= 4 && !is_marks && letters.iter().all(|it| it.is_alphabetic() || *it == '-')
    }

    /// Returns the names that have a page, in lower case: looking up each word would take a minute, of which most is for hints.
    fn explained() -> BTreeSet<String> {
        let words = words::all().flat_map(|(words, _)| words.iter().copied()).chain(Check::WORDS);
        let choices = VARIABLES.iter().flat_map(|it| it.keys().iter().copied());
        let fixed =
            VARIABLES.iter().flat_map(|it| it.aliases.iter().copied().chain([it.symbol, it.key]));
        let names = VARIABLES.iter().flat_map(|it| [it.name(), it.name().replace('_', " ")]);
        let quantities =
            QUANTITIES.iter().flat_map(|it| [it.name.to_owned(), it.title(), it.key_words()]);
        let texts = words.chain(choices).chain(fixed).map(str::to_owned);
        texts.chain(names).chain(quantities).map(|it| it.to_lowercase()).collect()
    }

    #[test]
    fn every_word_of_a_screen_is_explained() {
        let snapshots = files_below("tests/integration", "snap");
        let sources =
            ["src/studies/report", "src/studies/study", "src/engine/model", "src/tui/pages"];
        // The published package contains none of the other packages.
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let sources = sources.into_iter().filter(|folder| root.join(folder).is_dir());
        let sources = sources.flat_map(|folder| files_below(folder, "rs"));
        let mut labels: BTreeSet<String> =
            snapshots.iter().flat_map(|it| labels_of_screen(it)).collect();
        labels.extend(sources.flat_map(|it| labels_of_source(&it)));
        assert!(labels.len() > 300, "{}", labels.len());
        let explained = explained();
        let is_known = |word: &str| explained.contains(&word.to_lowercase());
        let (mut known, mut unknown) = (BTreeSet::new(), BTreeSet::new());
        let plain: BTreeSet<&str> = PLAIN.split(' ').collect();
        for label in &labels {
            let whole = label.trim_matches(|c: char| " .,:;()[]-".contains(c));
            if is_known(whole) {
                known.insert(whole.to_owned());
                continue;
            }
            for word in label.split(' ') {
                let word = word.trim_matches(|c: char| !c.is_alphabetic()).to_lowercase();
                if !is_word(&word) {
                    continue;
                }
                if is_known(&word) {
                    known.insert(word);
                } else if !plain.contains(word.as_str()) {
                    unknown.insert(format!("{word} in `{label}`"));
                }
            }
        }
        assert!(unknown.is_empty(), "{unknown:#?}");
        // A title in capitals is looked up as it is typed: in small letters.
        let has_page = |name: &String| pages(name).is_ok() || pages(&name.to_lowercase()).is_ok();
        known.retain(|name| !has_page(name));
        assert!(known.is_empty(), "no page: {known:?}");
    }

    /// Signs, short words and choices, which the labels above leave out, and words that texts beside them have.
    #[test]
    fn signs_and_choices_are_explained() {
        let words = [
            "A",
            "D",
            "%",
            "h/D",
            "V50",
            "v_bl",
            "q",
            "dt",
            "RK4",
            "DOP853",
            "Radau",
            "auto",
            "plastic",
            "travel",
            "margin",
            "validity",
            "conservative",
            "unconservative",
            "knee",
            "feasible",
            "areal",
            "residual",
            "demand",
            "mode",
            "share",
            "plug",
            "first arrest",
            "ratio",
            "band",
            "class",
            "front",
            "Pareto",
            "hold",
            "slip",
            "stops",
            "open",
            "perforates",
            "not measured",
            "expected",
            "matters",
            "bar",
            "crosshair",
            "judge",
            "estimate",
            "interval",
            "push",
            "pull",
            "capacity",
            "estimate basis",
            "spring mass",
            "rebound",
            "stroke",
            "interface",
            "CUT",
            "surge",
            "Tate",
            "law alone",
            "base plate",
            "RMS error",
        ];
        let choices = VARIABLES.iter().flat_map(|it| it.keys().iter().copied());
        let listed = words::all().flat_map(|(words, _)| words.iter().copied());
        let modes = ContactMode::ALL.iter().map(|it| it.word());
        let of_rows = EventKind::ALL.iter().map(|it| it.words()).chain(modes);
        for word in words.into_iter().chain(choices).chain(listed).chain(of_rows) {
            let found = pages(word).unwrap_or_else(|error| panic!("{word}: {error}"));
            assert!(found.iter().all(|page| page.len() > 20), "{word}: {found:?}");
        }
        assert!(pages("nonsense").is_err());
    }

    #[test]
    fn a_word_has_one_explanation() {
        let entries = words::all().chain(words::keys());
        let mut words: Vec<&str> = entries.flat_map(|(words, _)| words.iter().copied()).collect();
        let count = words.len();
        words.sort_unstable();
        words.dedup();
        assert_eq!(words.len(), count);
    }
}
