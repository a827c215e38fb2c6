//! Measurements beside what the model computes for them: one row for each case, one for each that cannot be checked, and one for the bias of
//! each class. SI.

use serde_json::Value;

use crate::report::measured::{error_page, json as limits_json, list};
use crate::report::page::Page;
use crate::report::table::Table;
use crate::study::measured;
use crate::study::validation::{
    Bias, Case, MeasuredQuantity, NOT_COUNTED, NotChecked, Row, biases, measurements,
};
use cmra_engine::model::scene::Closure;
use cmra_engine::model::units::{engineering, fixed_significant};

/// A row of the table.
pub struct ValidationLine<'r> {
    row: Option<&'r Row>,
    /// A case that cannot be checked: what it says, where it comes from, and why not.
    not_checked: Option<&'static NotChecked>,
    bias: Option<Bias>,
}

impl ValidationLine<'_> {
    fn case(&self) -> Option<&'static Case> {
        self.row.map(|row| row.case)
    }

    fn id(&self) -> &'static str {
        let id = self.case().map(|case| case.id).or_else(|| Some(self.not_checked?.id));
        id.unwrap_or("bias")
    }

    fn quantity(&self) -> &'static str {
        let word = self.case().map(|case| case.quantity.label());
        word.or_else(|| Some(self.not_checked?.says)).unwrap_or("mean relative error")
    }

    fn class(&self) -> Option<&'static str> {
        let of_bias = || Some(self.bias.as_ref()?.class.unwrap_or("all points"));
        self.case().map(|case| case.class).or_else(of_bias)
    }

    /// Relative to the measurement; of a class the mean.
    fn error(&self) -> Option<f64> {
        let own = |row: &Row| Some(row.error(row.computed?));
        self.row.and_then(own).or_else(|| Some(self.bias.as_ref()?.mean))
    }
}

/// All of them.
pub fn table(report: &[Row]) -> Table<'_, ValidationLine<'_>> {
    let line = |row, not_checked, bias| ValidationLine { row, not_checked, bias };
    let cases = report.iter().map(|row| line(Some(row), None, None));
    let others = measurements().not_checked.iter().map(|it| line(None, Some(it), None));
    let biases = biases(report).into_iter().map(|it| line(None, None, Some(it)));
    Table::new(cases.chain(others).chain(biases))
        .field("case", ValidationLine::id)
        .field("preset", |it| it.case().map(|case| case.preset))
        .field("quantity", ValidationLine::quantity)
        .field("unit", |it| it.case().map(|case| case.quantity.unit()))
        .field("measured", |it| it.case().map(|case| case.measured))
        .field("resolution", |it| it.case()?.resolution)
        .field("closure", |it| it.row.map(|row| row.closure.word()))
        .field("computed", |it| it.row?.computed)
        .field("relative_error", ValidationLine::error)
        .field("other_closure", |it| it.row?.other)
        .field("other_relative_error", |it| Some(it.row?.error(it.row?.other?)))
        .field("thickness_over_diameter", |it| it.row.map(|row| row.thickness_ratio))
        .field("nose_pressure_pa", |it| it.row.map(|row| row.pressure_pa))
        .field("nose", |it| it.case().map(|case| case.nose))
        .field("projectile", |it| it.case().map(|case| case.projectile))
        .field("source", |it| {
            it.case().map(|case| case.source).or_else(|| Some(it.not_checked?.source))
        })
        .field("caution", |it| it.case().map(|case| case.caution))
        .field("beyond_closure", |it| it.row?.beyond.clone())
        .field("not_checked_because", |it| it.not_checked.map(|it| it.why))
        .field("class", ValidationLine::class)
        .field("points", |it| it.bias.as_ref().map(|bias| bias.points))
        .field("relative_error_deviation", |it| it.bias.as_ref()?.deviation)
}

/// Returns the page of the built-in measurements: errors by class, all rows if `lists_all`, and the summary, or what is missing of it.
pub fn page(
    rows: &[measured::Row],
    report: &[Row],
    lists_all: bool,
    missing: Option<String>,
) -> Page {
    let mut page = Page::new(
        "Measured ballistic limits beside those expected from all other papers, by class",
    );
    page.space();
    error_page(&mut page, rows);
    if lists_all {
        page.space();
        list(&mut page, rows);
        page.space();
    }
    page.space();
    if lists_all {
        each_case(&mut page, report);
    }
    match missing {
        Some(missing) => page.line(missing),
        None => summary(&mut page, report),
    }
    page
}

/// Returns the whole report as an object.
pub fn json(rows: &[measured::Row], report: &[Row]) -> Value {
    let mut object = limits_json(rows);
    object["cases"] = table(report).objects(|_| true);
    object
}

/// Appends each measurement with its computed value, then those that cannot be checked.
fn each_case(page: &mut Page, report: &[Row]) {
    use Closure::{Cavity, DoubleYield};
    for row in report {
        let case = row.case;
        let unit = case.quantity.unit();
        let show = |value: f64| match case.quantity {
            MeasuredQuantity::Bottoms => (if value > 0.5 { "yes" } else { "no" }).to_owned(),
            MeasuredQuantity::Ratio => fixed_significant(value, 4),
            _ => engineering(value, unit, 4),
        };
        let off = |value: f64| match case.quantity {
            MeasuredQuantity::Bottoms => show(value),
            _ => format!("{} ({:+.1} %)", show(value), 100.0 * row.error(value)),
        };
        let absent = || "nothing".to_owned();
        let scene = format!("{} {}", case.preset, case.set);
        page.fact(format!("{}  ", case.id), case.id.len() + 2, format!("[{}]", scene.trim_end()));
        let known = case.resolution.map_or_else(String::new, |it| format!(" +- {}", show(it)));
        let computed = row.computed.map_or_else(absent, off);
        let ratio = format!("h/D = {}", fixed_significant(row.thickness_ratio, 3));
        let (made_of, pressure) = (case.projectile, engineering(row.pressure_pa, "Pa", 4));
        let lines = [
            ("measured", format!("{} {}{known}", case.quantity.label(), show(case.measured))),
            ("computed", format!("{computed} by {}", closure_words(row.closure))),
            (
                "alternative",
                row.other.map_or_else(String::new, |value| {
                    let is_cavity = row.closure == Cavity;
                    let other = if is_cavity { DoubleYield } else { Cavity };
                    format!("{} by {}", off(value), closure_words(other))
                }),
            ),
            ("plate", row.beyond.clone().unwrap_or(ratio)),
            ("nose", case.nose.to_owned()),
            ("projectile", format!("{made_of}; invalid if the projectile yields below {pressure}")),
            ("caution", case.caution.to_owned()),
            ("source", case.source.to_owned()),
        ];
        page.entries(lines.iter().map(|(label, text)| (*label, text.as_str())));
        page.space();
    }
    for it in &measurements().not_checked {
        page.line(format!("{}  [cannot be checked]", it.id));
        page.entries([("says", it.says), ("why not", it.why), ("source", it.source)]);
        page.space();
    }
}

/// Minimum number of points of a class with a standard deviation.
const SCATTER_FROM: usize = 3;

/// Appends bias and scatter by class, and a summary line.
fn summary(page: &mut Page, report: &[Row]) {
    let percent = |value: f64| format!("{:+.1} %", 100.0 * value);
    let scatter = |it: &Bias| it.deviation.filter(|_| it.points >= SCATTER_FROM);
    let range = |it: &Bias| format!("{} to {}", percent(it.range.0), percent(it.range.1));
    let table = Table::new(biases(report))
        .with("class", "computed over measured, minus 1", "", |it| it.class.unwrap_or("all points"))
        .with("points", "points", "", |it| it.points)
        .with("bias", "bias", "", |it| it.mean)
        .shown(|it, _| Some(percent(it.mean)))
        .with("scatter", "scatter", "", scatter)
        .shown(|it, _| {
            Some(scatter(it).map_or_else(String::new, |it| format!("{:.1} %", 100.0 * it)))
        })
        .with("range", "least to greatest", "", |it| {
            if it.points > 1 { range(it) } else { String::new() }
        });
    page.table(table.cells(&table.keys()));
    let computed = report.iter().filter(|row| row.computed.is_some()).count();
    let aside = report.iter().filter(|row| row.case.class == NOT_COUNTED).count();
    page.space();
    let said = format!(
        "{} measurements: {computed} computed, {} not; {aside} of them not counted above (another input for a counted \
         measurement, or a quantity outside the model). {} further ones cannot be checked. Positive is unconservative: \
         the real plate holds less than computed. Nothing is fitted. The two closures are never combined: cavity with dishing is \
         refused.",
        report.len(),
        report.len() - computed,
        measurements().not_checked.len(),
    );
    page.paragraph(said, 0);
}

fn closure_words(closure: Closure) -> &'static str {
    match closure {
        Closure::Given => "a flow strength that is given",
        Closure::Cavity | Closure::ByThickness => "cavity, without dishing",
        Closure::Cylindrical => "cylindrical, without dishing",
        Closure::DoubleYield => "double-yield, with dishing",
    }
}
