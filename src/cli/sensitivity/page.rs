//! Sensitivity as a page of text: the tornado with its bars, Morris's effects, Sobol's indices.

use std::fmt::Write as _;

use crate::model::units::{fixed_significant, prefix_of, significant};
use crate::study::sensitivity::Report;
use crate::study::sensitivity::indices::Index;

/// Cells of the longest bar.
const BAR: usize = 30;

/// The page.
pub(super) fn text(name: &str, report: &Report) -> String {
    let shown = Shown::of(report);
    let own = shown.number(report.own);
    let mut page = format!(
        "{name}: what {} depends on\nthe scene itself: {own}{}\n\n",
        report.output.title(),
        shown.unit()
    );
    tornado(&mut page, report, &shown);
    morris(&mut page, report, &shown);
    sobol(&mut page, report, &shown);
    page
}

/// How the result is shown: its unit with one prefix for the whole page.
struct Shown {
    factor: f64,
    unit: String,
}

impl Shown {
    fn of(report: &Report) -> Self {
        let unit = report.output.unit();
        if unit.is_empty() || unit == "%" {
            return Self { factor: 1.0, unit: unit.to_owned() };
        }
        let values = report.bars.iter().flat_map(|bar| [bar.low, bar.high]).chain([report.own]);
        let greatest = values.flatten().map(f64::abs).fold(0.0, f64::max);
        let (factor, prefix) = prefix_of(greatest);
        Self { factor, unit: format!("{prefix}{unit}") }
    }

    fn unit(&self) -> String {
        if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) }
    }

    fn number(&self, value: Option<f64>) -> String {
        value.map_or_else(|| "-".to_owned(), |value| fixed_significant(value / self.factor, 4))
    }
}

fn tornado(page: &mut String, report: &Report, shown: &Shown) {
    let _ = writeln!(page, "one at a time, the others as in the scene{}", among(shown));
    let swings = report.bars.iter().filter_map(|bar| bar.swing());
    let widest = swings.fold(0.0, f64::max);
    let mut order: Vec<usize> = (0..report.axes.len()).collect();
    let swing = |at: &usize| report.bars[*at].swing().unwrap_or(-1.0);
    order.sort_by(|a, b| swing(b).total_cmp(&swing(a)));
    for at in order {
        let (axis, bar) = (&report.axes[at], report.bars[at]);
        let (low, high) = axis.ends();
        let unit = axis.variable().unit();
        let unit = if unit == "-" { String::new() } else { format!(" {unit}") };
        let range = format!("{} .. {}{unit}", significant(low, 4), significant(high, 4));
        let share = bar.swing().map_or(0.0, |swing| swing / widest);
        let cells = (1..=BAR).filter(|cell| share * BAR as f64 >= *cell as f64 - 0.5).count();
        let line = format!(
            "  {:8}{range:<24}{:>10} .. {:<10}{}",
            axis.symbol(),
            shown.number(bar.low),
            shown.number(bar.high),
            "#".repeat(cells)
        );
        let _ = writeln!(page, "{}", line.trim_end());
    }
    page.push('\n');
}

fn among(shown: &Shown) -> String {
    if shown.unit.is_empty() { String::new() } else { format!(", {}", shown.unit) }
}

fn morris(page: &mut String, report: &Report, shown: &Shown) {
    if report.effects.is_empty() {
        return;
    }
    let _ = writeln!(
        page,
        "Morris's effects over the whole range ({} trajectories){}\n  {:8}{:>12}{:>12}{:>12}{:>8}",
        report.effort.trajectories,
        among(shown),
        "",
        "mu*",
        "mu",
        "sigma",
        "steps"
    );
    for at in report.order() {
        let effect = report.effects[at];
        let _ = writeln!(
            page,
            "  {:8}{:>12}{:>12}{:>12}{:>8}",
            report.axes[at].symbol(),
            shown.number(effect.magnitude),
            shown.number(effect.mean),
            shown.number(effect.deviation),
            effect.used
        );
    }
    page.push('\n');
}

fn sobol(page: &mut String, report: &Report, shown: &Shown) {
    let Some(found) = &report.sobol else { return };
    let _ = writeln!(
        page,
        "Sobol's indices: parts of the variance, 95 % intervals ({} samples, seed {})\n  {:8}{:>8}  {:<18}{:>8}",
        found.rows, report.effort.seed, "", "first", "", "total"
    );
    let cell = |index: Option<Index>| {
        index.map_or_else(
            || ("-".to_owned(), String::new()),
            |index| {
                let (low, high) = index.range95;
                (format!("{:.3}", index.value), format!("{low:.3} to {high:.3}"))
            },
        )
    };
    for at in report.order() {
        let indices = found.inputs[at];
        let (first, total) = (cell(indices.first), cell(indices.total));
        let line = format!(
            "  {:8}{:>8}  {:<18}{:>8}  {}",
            report.axes[at].symbol(),
            first.0,
            first.1,
            total.0,
            total.1
        );
        let _ = writeln!(page, "{}", line.trim_end());
    }
    let deviation = found.variance.is_finite().then(|| found.variance.sqrt());
    let mean = found.mean.is_finite().then_some(found.mean);
    let _ = writeln!(
        page,
        "  mean {}{}, standard deviation {}",
        shown.number(mean),
        shown.unit(),
        shown.number(deviation)
    );
    if found.inputs.iter().all(|input| input.first.is_none()) {
        page.push_str(
            "  no indices: the result does not vary, or has no value, over these bounds\n",
        );
    }
    if found.used < found.rows {
        let _ = writeln!(
            page,
            "  {} of {} samples have a point without a value (perforated, moving or failed) and are not counted: the indices are \
             those of the rest",
            found.rows - found.used,
            found.rows
        );
    }
}
