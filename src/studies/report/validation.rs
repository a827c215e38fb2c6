//! Measurements beside what the model computes for them: one row for each case, one for each that cannot be checked, and one for the bias of
//! each class. SI.

use crate::report::table::Table;
use crate::study::validation::{Bias, Case, NotChecked, Row, biases, measurements};

/// A row of the table.
#[derive(Default)]
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
        let word = self.case().map(|case| case.quantity.word());
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
    let cases =
        report.iter().map(|row| ValidationLine { row: Some(row), ..ValidationLine::default() });
    let others = measurements().not_checked.iter();
    let others =
        others.map(|it| ValidationLine { not_checked: Some(it), ..ValidationLine::default() });
    let biases = biases(report).into_iter();
    let biases = biases.map(|it| ValidationLine { bias: Some(it), ..ValidationLine::default() });
    Table::of(cases.chain(others).chain(biases))
        .with("case", "case", "", ValidationLine::id)
        .with("preset", "preset", "", |it| it.case().map(|case| case.preset))
        .with("quantity", "quantity", "", ValidationLine::quantity)
        .with("unit", "unit", "", |it| it.case().map(|case| case.quantity.unit()))
        .with("measured", "measured", "", |it| it.case().map(|case| case.measured))
        .with("resolution", "resolution", "", |it| it.case()?.resolution)
        .with("closure", "closure", "", |it| it.row.map(|row| row.closure.word()))
        .with("computed", "computed", "", |it| it.row?.computed)
        .with("relative_error", "bias", "", ValidationLine::error)
        .with("other_closure", "other closure", "", |it| it.row?.other)
        .with("other_relative_error", "its error", "", |it| {
            let row = it.row?;
            Some(row.error(row.other?))
        })
        .with("thickness_over_diameter", "h/D", "", |it| it.row.map(|row| row.thickness_ratio))
        .with("nose_pressure_pa", "nose pressure", "Pa", |it| it.row.map(|row| row.pressure_pa))
        .with("nose", "nose", "", |it| it.case().map(|case| case.nose))
        .with("projectile", "projectile", "", |it| it.case().map(|case| case.projectile))
        .with("source", "source", "", |it| {
            it.case().map(|case| case.source).or_else(|| Some(it.not_checked?.source))
        })
        .with("caution", "caution", "", |it| it.case().map(|case| case.caution))
        .with("beyond_closure", "beyond closure", "", |it| it.row?.beyond.clone())
        .with("not_checked_because", "why not", "", |it| it.not_checked.map(|it| it.why))
        .with("class", "class", "", ValidationLine::class)
        .with("points", "points", "", |it| it.bias.as_ref().map(|bias| bias.points))
        .with("relative_error_deviation", "std dev", "", |it| it.bias.as_ref()?.deviation)
}
