//! The ballistic limit as a page of text: what it is, how far the scene is from it, the curve, the fitted laws, the scatter.

use std::fmt::Write as _;

use crate::cli::draw;
use crate::cli::text::hanging;
use crate::model::units::fixed_significant;
use crate::report::figures::limit::residual;
use crate::report::limit::remarks;
use crate::study::limit::{Limit, Report};
use crate::tui::theme::Theme;

const WIDTH: u16 = 80;
const HEIGHT: u16 = 18;
/// Columns of a label.
const LABEL: usize = 16;

pub(super) fn text(name: &str, report: &Report) -> String {
    let mut page = format!("{name}: ballistic limit\n\n");
    head(&mut page, report);
    if let Some(chart) = residual(report, None) {
        page.push_str(&draw::chart(&chart, (WIDTH, HEIGHT), Theme::PLAIN));
    }
    page.push('\n');
    for remark in remarks(report) {
        page += &hanging(&format!("{:LABEL$}", remark.about), &remark.text, LABEL);
    }
    page
}

fn velocity(value_m_s: f64) -> String {
    format!("{} m/s", fixed_significant(value_m_s, 6))
}

fn head(page: &mut String, report: &Report) {
    let own = report.scene.projectile.velocity_m_s;
    match report.limit {
        Limit::Found { velocity_m_s, basis, .. } => {
            let _ = writeln!(page, "limit velocity  {}, {}", velocity(velocity_m_s), basis.words());
        }
        Limit::Between { .. } | Limit::Never | Limit::Always | Limit::Unknown => {
            let _ = writeln!(page, "{}", report.limit.absence().unwrap_or_default());
        }
    }
    *page += &hanging("criterion       ", report.criterion.label(), LABEL);
    if let Some(margin) = report.margin() {
        let side = if margin < 0.0 { "it perforates" } else { "it is stopped" };
        let _ = writeln!(
            page,
            "margin          {:+.1} % over the scene's own {}: {side}",
            100.0 * margin,
            velocity(own)
        );
    }
    page.push('\n');
}
