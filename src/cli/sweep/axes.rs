//! `--over NAME=LO..HI:COUNT[:log]`, `--over NAME=A,B,C` and the other options for the points of a sweep.

use clap::Args;

use crate::cli::CliError;
use crate::files::preset::Preset;
use cmra_engine::model::scene::Scene;
use cmra_studies::report::sweep::Columns;
use cmra_studies::study::quantities::of_every_run;
use cmra_studies::study::sweep::{Axis, COUNTS, Plan, StudyError, default_outputs};

/// Arguments for the points of a sweep and the outputs at each.
#[derive(Debug, Args)]
pub(super) struct PointArguments {
    /// An axis: a variable with its first and last value (SI, or with a unit), the number of points and `:log` for equal ratios,
    /// or with a list of values; may be repeated
    #[arg(long, value_name = "NAME=LO..HI:COUNT[:log]|NAME=A,B,...", allow_hyphen_values = true)]
    over: Vec<String>,
    /// Quantities to compute, separated by commas; `all` for every one that needs neither a time series nor a limit search
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    outputs: Vec<String>,
}

impl PointArguments {
    /// Returns the plan of a sweep and its columns. Without `--outputs` a page has the main quantities.
    pub(super) fn plan(&self, preset: &Preset, is_page: bool) -> Result<(Plan, Columns), CliError> {
        let scene = &preset.scene;
        let axes = if self.over.is_empty() {
            let sweep = scene.sweep.as_ref();
            let sweep = sweep.ok_or_else(|| {
                CliError::Option(format!(
                    "{} has no [sweep] of its own: name an axis, for example --over gamma=0.8..7:101",
                    preset.name
                ))
            })?;
            Axis::all_of(sweep)?
        } else {
            let axes = self.over.iter().map(|text| Axis::read(text, None, &COUNTS));
            axes.collect::<Result<Vec<_>, _>>()?
        };
        let (outputs, columns) = self.outputs(scene, is_page);
        let plan = Plan::new(scene, axes, &outputs)?;
        if columns == Columns::Chosen && outputs != default_outputs(scene) {
            // The base has the values of the axes, which can make a stack of the scene.
            let mut chosen = plan.outputs().iter();
            chosen.try_for_each(|it| it.check_exists(plan.base())).map_err(StudyError::from)?;
        }
        Ok((plan, columns))
    }

    fn outputs(&self, scene: &Scene, is_page: bool) -> (Vec<String>, Columns) {
        let kept = scene.sweep.as_ref().map(|sweep| &sweep.outputs).filter(|it| !it.is_empty());
        let every = || of_every_run().map(|column| column.name.to_owned()).collect();
        match (&self.outputs[..], kept) {
            ([only], _) if only == "all" => (every(), Columns::All),
            ([], Some(kept)) => (kept.clone(), Columns::Chosen),
            ([], None) if is_page => (
                default_outputs(scene).iter().map(|it| (*it).to_owned()).collect(),
                Columns::Chosen,
            ),
            ([], None) => (every(), Columns::All),
            (named, _) => (named.to_vec(), Columns::Chosen),
        }
    }
}
