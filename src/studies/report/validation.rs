//! Measurements beside what the model computes for them: one row for each case, one for each that cannot be checked, and one for the bias of
//! each class. SI.

use crate::report::table::Table;
use crate::study::validation::{Bias, Case, NotChecked, Row, biases, measurements};

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
