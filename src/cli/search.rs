//! Common parts of the search commands: reading bounds.

use clap::Args;

use crate::cli::CliError;
use crate::cli::scene::SceneArguments;
use crate::cli::sweep::axes::range;
use crate::model::scene::{InterfaceLaw, Scene};
use crate::study::parallel::cores;
use crate::study::search::seek::has_unlimited_interface;
use crate::study::sensitivity::thesis_axes;
use crate::study::sweep::{Axis, COUNTS};

/// Let a search look on the plastic law, unless `--set interface=...` says otherwise: fused, a search ends where the interface is
/// loaded beyond what it can carry. Gives the note to print.
pub(super) fn be_cautious(arguments: &SceneArguments, scene: &mut Scene) -> Option<String> {
    let chosen = arguments.changes.set_of(|key| key == "interface.law").is_some();
    if chosen || !has_unlimited_interface(scene) {
        return None;
    }
    scene.interface.law = InterfaceLaw::Plastic;
    Some(
        "searched with interface=plastic: a fused interface has no limit of strength; --set interface=fused \
         searches with fused"
            .to_owned(),
    )
}

/// `--threads`.
#[derive(Debug, Args)]
pub(super) struct Threads {
    /// Threads; the digits do not depend on it [default: one for each core]
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Threads {
    /// The number given, or one for each core.
    pub(super) fn count(&self) -> usize {
        self.threads.map_or_else(all_threads, usize::from)
    }
}

/// `--seed`.
#[derive(Debug, Args)]
pub(super) struct Random {
    /// Random seed: the same seed gives the same digits
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true, default_value_t = 1)]
    pub(super) seed: u64,
}

/// One thread for each core.
pub(super) fn all_threads() -> usize {
    cores()
}

/// Variables and their bounds; without any those of Table 9.2.
pub(super) fn bounds(texts: &[String], scene: &Scene) -> Result<Vec<Axis>, CliError> {
    if !texts.is_empty() {
        return texts.iter().map(|text| range(text, Some(*COUNTS.start()), &COUNTS)).collect();
    }
    let axes = thesis_axes(scene)?;
    if axes.is_empty() {
        return Err(CliError::Option(
            "no variable of Table 9.2 has an effect on this scene: name one, for example --over v_i=80..120"
                .to_owned(),
        ));
    }
    Ok(axes)
}
