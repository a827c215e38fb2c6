//! The ballistic limit as a page of text: what it is, how far the scene is from it, the curve, the fitted laws, the scatter.

use std::fmt::Write as _;

use crate::cli::draw;
use crate::cli::text::hanging;
use crate::model::units::{fixed_significant, significant};
use crate::report::figures::limit::residual;
use crate::study::limit::monte_carlo::ModelError;
use crate::study::limit::{Limit, Report, words};
use crate::tui::theme::Theme;

const WIDTH: u16 = 80;
const HEIGHT: u16 = 18;
/// Columns of a label, and of further lines of a sentence.
const LABEL: usize = 16;
const INDENT: usize = 2;

/// The page.
pub(super) fn text(name: &str, report: &Report) -> String {
    let mut page = format!("{name}: ballistic limit\n\n");
    head(&mut page, report);
    if let Some(chart) = residual(report, None) {
        page.push_str(&draw::chart(&chart, (WIDTH, HEIGHT), Theme::PLAIN));
    }
    laws(&mut page, report);
    sampled(&mut page, report);
    page
}

fn velocity(value_m_s: f64) -> String {
    format!("{} m/s", fixed_significant(value_m_s, 6))
}

fn head(page: &mut String, report: &Report) {
    let own = report.scene.projectile.velocity_m_s;
    match report.limit {
        Limit::Found { velocity_m_s, basis, stopped_at_m_s } => {
            let _ = writeln!(page, "limit velocity  {}, {}", velocity(velocity_m_s), basis.words());
            if let Some(again) = stopped_at_m_s {
                let _ = writeln!(
                    page,
                    "no single limit: a shot at {} is stopped again; the lowest is given",
                    velocity(again)
                );
            }
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
    let load = report.load.as_ref();
    if load.is_some() {
        let none = "nothing stops plate and projectile: no stroke, no mount force".to_owned();
        let load = load.and_then(words::load).unwrap_or(none);
        *page += &hanging("at the limit    ", &load, LABEL);
    }
    if let Some(closures) = &report.closures {
        *page += &hanging("closure band    ", &words::closures(closures), LABEL);
    }
    if let Some(caution) = report.caution() {
        *page += &hanging("caution         ", &caution, LABEL);
    }
    page.push('\n');
}

fn laws(page: &mut String, report: &Report) {
    if let Some(carried) = words::carried(report) {
        *page += &hanging("", &carried, 0);
    }
    if let Some(law) = report.recht_ipson {
        let text = format!(
            "Recht-Ipson    v_r = a (v^2 - v_bl^2)^(1/2)  a {:.4}; RMS error {} m/s",
            law.a,
            significant(law.misfit_m_s, 2)
        );
        *page += &hanging("", &text, INDENT);
    }
    if let Some(law) = report.lambert_jonas {
        let text = format!(
            "Lambert-Jonas  v_r = a (v^p - v_bl^p)^(1/p)  a {:.4}, p {:.3}, v_bl {}; RMS error {} m/s",
            law.a,
            law.p,
            velocity(law.limit_m_s),
            significant(law.misfit_m_s, 2)
        );
        *page += &hanging("", &text, INDENT);
    }
}

fn sampled(page: &mut String, report: &Report) {
    let Some(found) = report.sampled else { return };
    let asked = found.sampling;
    let mut line = |text: &str| *page += &hanging("", text, INDENT);
    line("");
    line(&format!(
        "every mass, length, strength and coefficient varied by {:.3} % ({} samples, seed {})",
        100.0 * asked.deviation,
        asked.samples,
        asked.seed
    ));
    if asked.model != ModelError::default() {
        line(&format!(
            "corrected for the model's bias of {:+.3} %, and varied by its spread of {:.3} %",
            100.0 * asked.model.bias,
            100.0 * asked.model.spread
        ));
    }
    line(&format!(
        "V50 {}, standard deviation {}, 90 % of limits in {} to {}",
        velocity(found.v50_m_s),
        velocity(found.deviation_m_s),
        velocity(found.range90_m_s.0),
        velocity(found.range90_m_s.1)
    ));
    line(&format!(
        "{:.1} % of the shots at {} go through (95 % confidence: {:.1} to {:.1} %)",
        100.0 * found.perforated,
        velocity(report.scene.projectile.velocity_m_s),
        100.0 * found.perforated95.0,
        100.0 * found.perforated95.1
    ));
    if found.without > 0 {
        let count = found.without;
        line(&format!("{count} samples have no limit within a factor of two of the nominal one"));
    }
}
