//! The results of a run in words: beside the runs, and on the main screen after leaving. No drawing.

use crate::model::run::envelope;
use crate::model::run::{Outcome, Run, Warning};
use crate::tui::app::App;
use crate::tui::app::notice::times;
use crate::tui::app::status::wrap;
use crate::tui::pages::run::runs::{engineering, millimetres};

impl App {
    /// The last result in a few lines, for the main screen after leaving.
    pub fn summary(&self) -> String {
        let Some(shown) = &self.shown else {
            return format!("{}: not run", self.base.name);
        };
        let run = &shown.run;
        let name = self.name_of(&run.scene);
        let mut lines = vec![format!("scene         {name}")];
        lines.extend(results(run));
        // How it ended stands beside the outcome already.
        let ended = Warning::EndedEarly(run.end).to_string();
        let warnings = envelope::warnings(run).into_iter().filter(|text| *text != ended);
        lines.extend(warnings.map(|warning| format!("{:<LABEL$}{warning}", "warning")));
        let room = usize::from(self.size.0).saturating_sub(LABEL).max(LABEL);
        let hang = |line: String| {
            // A label is columns of ASCII.
            let (label, words) = line.split_at_checked(LABEL).unwrap_or((&line, ""));
            let indent = format!("\n{:LABEL$}", "");
            format!("{label}{}", wrap(words, room).join(&indent))
        };
        lines.into_iter().map(hang).collect::<Vec<_>>().join("\n")
    }
}

/// Columns of a label before its words, in the summary and beside the runs.
const LABEL: usize = 14;

/// The results of a run in words, one a line.
pub fn results(run: &Run) -> Vec<String> {
    let mut lines = vec![format!("outcome       {} ({})", run.outcome, run.end.words())];
    let mut add = |name: &str, text: String| lines.push(format!("{name:<LABEL$}{text}"));
    if let Some(arrest) = run.first_arrest {
        let depth = millimetres(Some(arrest.penetration_m));
        add("first arrest", format!("{depth} mm deep at {}", engineering(arrest.t_s, "s")));
    }
    let percent = run
        .percent_of_baseline()
        .map_or_else(String::new, |percent| format!(", {percent:.1} % of a rigid mount's"));
    if run.outcome == Outcome::Perforated {
        let time = run.exit_time_s.map(|t_s| engineering(t_s, "s"));
        add("perforation", format!("at {}", time.unwrap_or_else(|| "-".to_owned())));
        if let Some(speed) = run.residual_velocity_m_s {
            let way = if speed < 0.0 { " backwards: the plate moved over it" } else { "" };
            add("residual", format!("{}{way}", engineering(speed.abs(), "m/s")));
        }
    } else {
        match run.at_least.penetration_m {
            Some(_) => {
                let so_far = millimetres(run.at_least.penetration_m);
                add("depth so far", format!("{so_far} mm (lower bound)"));
            }
            None => {
                add("final depth", format!("{} mm{percent}", millimetres(run.final_penetration_m)));
            }
        }
        if run.protrusion_m().is_some() {
            let out = millimetres(run.protrusion_m());
            add("nose", format!("{out} mm out of the rear face"));
        }
    }
    if let Some(margin) = run.mechanism.yield_margin {
        let margin = crate::model::units::fixed_significant(margin, 3);
        add("yield margin", format!("{margin} (strength over greatest stress)"));
    }
    if let Some(peak_n) = run.peak_contact_force_n {
        add("peak force", engineering(peak_n, "N"));
    }
    if run.at_least.plate_displacement_m.is_some() {
        let so_far = millimetres(run.at_least.plate_displacement_m);
        add("plate travel", format!("{so_far} mm so far (lower bound)"));
    }
    if run.max_plate_displacement_m.is_some() {
        add("plate travel", format!("{} mm at most", millimetres(run.max_plate_displacement_m)));
    }
    if let Some(ratio) = run.interface_demand_ratio {
        add("interface", format!("{} of its strength A S_y", times(ratio)));
    }
    lines
}
