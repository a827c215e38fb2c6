//! Measurements beside what the model computes for them: a row a case, one for each that cannot be checked, and one for the bias of
//! each class. SI.

use crate::report::table::Table;
use crate::study::validation::{Bias, Case, Class, NOT_CHECKED, NotChecked, Row, biases};

/// A row of the table.
pub enum Line<'r> {
    /// A case, computed.
    Case(&'r Row),
    /// A case that cannot be checked: what it says, where it comes from, and why not.
    NotChecked(&'static NotChecked),
    /// The bias of a class of cases.
    Bias(Bias),
}

impl<'r> Line<'r> {
    fn row(&self) -> Option<&'r Row> {
        match self {
            Self::Case(row) => Some(row),
            Self::NotChecked(_) | Self::Bias(_) => None,
        }
    }

    fn case(&self) -> Option<&'static Case> {
        self.row().map(|row| row.case)
    }

    fn not_checked(&self) -> Option<&'static NotChecked> {
        match self {
            Self::NotChecked(it) => Some(it),
            Self::Case(_) | Self::Bias(_) => None,
        }
    }

    fn bias(&self) -> Option<&Bias> {
        match self {
            Self::Bias(it) => Some(it),
            Self::Case(_) | Self::NotChecked(_) => None,
        }
    }

    fn id(&self) -> &'static str {
        match self {
            Self::Case(row) => row.case.id,
            Self::NotChecked(it) => it.id,
            Self::Bias(_) => "bias",
        }
    }

    fn quantity(&self) -> &'static str {
        match self {
            Self::Case(row) => row.case.quantity.word(),
            Self::NotChecked(it) => it.says,
            Self::Bias(_) => "mean relative error",
        }
    }

    fn class(&self) -> Option<&'static str> {
        match self {
            Self::Case(row) => Some(row.case.class.word()),
            Self::NotChecked(_) => None,
            Self::Bias(it) => Some(it.class.map_or("all points", Class::word)),
        }
    }

    /// Relative to the measurement; of a class the mean.
    fn error(&self) -> Option<f64> {
        let own = |row: &Row| Some(row.error(row.computed?));
        self.row().and_then(own).or_else(|| Some(self.bias()?.mean))
    }
}

/// All of them.
pub fn table(report: &[Row]) -> Table<'_, Line<'_>> {
    let rows = report.iter().map(Line::Case);
    let rows = rows.chain(NOT_CHECKED.iter().map(Line::NotChecked));
    Table::of(rows.chain(biases(report).into_iter().map(Line::Bias)))
        .with("case", "case", "", Line::id)
        .with("preset", "preset", "", |it| it.case().map(|case| case.preset))
        .with("quantity", "quantity", "", Line::quantity)
        .with("unit", "unit", "", |it| it.case().map(|case| case.quantity.unit()))
        .with("measured", "measured", "", |it| it.case().map(|case| case.measured))
        .with("resolution", "resolution", "", |it| it.case()?.resolution)
        .with("closure", "closure", "", |it| it.row().map(|row| row.closure))
        .with("computed", "computed", "", |it| it.row()?.computed)
        .with("relative_error", "bias", "", Line::error)
        .with("other_closure", "other closure", "", |it| it.row()?.other)
        .with("other_relative_error", "its error", "", |it| {
            let row = it.row()?;
            Some(row.error(row.other?))
        })
        .with("thickness_over_diameter", "h/D", "", |it| it.row().map(|row| row.thickness_ratio))
        .with("nose_pressure_pa", "nose pressure", "Pa", |it| it.row().map(|row| row.pressure_pa))
        .with("nose", "nose", "", |it| it.case().map(|case| case.nose))
        .with("projectile", "projectile", "", |it| it.case().map(|case| case.projectile))
        .with("source", "source", "", |it| {
            it.case().map(|case| case.source).or_else(|| Some(it.not_checked()?.source))
        })
        .with("caution", "caution", "", |it| it.case().map(|case| case.caution))
        .with("beyond_closure", "beyond closure", "", |it| it.row()?.beyond.clone())
        .with("not_checked_because", "why not", "", |it| it.not_checked().map(|it| it.why))
        .with("class", "class", "", Line::class)
        .with("points", "points", "", |it| it.bias().map(|bias| bias.points))
        .with("relative_error_deviation", "deviation", "", |it| it.bias()?.deviation)
}
