//! The sidecar of a part of a sweep: which part of which design it is, and its CSV dialect.

use std::fmt::Write as _;

use crate::files::clean;
use crate::files::export::{self, Beside};
use crate::files::style::Style;
use crate::model::scene::Scene;
use crate::study::sweep::axis::scene_with;
use crate::study::sweep::{Axis, Design, Sampling, Shard};
use crate::study::validity;

/// A part of a sweep, as its sidecar describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Which part.
    pub shard: Shard,
    /// The design of the whole sweep.
    pub design: Design,
    /// The name of the scene in the rows.
    pub name: String,
    /// The CSV dialect of the table.
    pub style: Style,
}

impl Part {
    /// The scene that goes beside this part: what makes the rows again, and, for a part, what it takes to join it. The scene has
    /// its `[sweep]`.
    pub fn beside<'a>(&'a self, scene: &'a Scene, missing: Option<&'a str>) -> Beside<'a> {
        let notes = move |own: &str| self.notes(own, scene, missing);
        Beside { run: None, scene, notes: Box::new(notes) }
    }

    fn notes(&self, own: &str, scene: &Scene, missing: Option<&str>) -> String {
        let mut again = format!("cmra sweep {}", clean::shell_word(own));
        let Design { sampling, points, seed } = self.design;
        if sampling != Sampling::Factorial {
            let word = sampling.word();
            let _ = write!(again, " --design {word} --points {points} --seed {seed}");
        }
        if self.shard != Shard::WHOLE {
            let _ = write!(again, " --shard {}", self.shard);
        }
        again += " --csv -";
        let missing = missing.map(|it| format!("not complete: {it}"));
        let mut text = String::new();
        for note in missing.into_iter().chain(self.lines()).chain(warnings(scene)) {
            let _ = writeln!(text, "# {note}");
        }
        text + &export::again(&again)
    }

    /// The lines that `join` reads.
    fn lines(&self) -> Vec<String> {
        if self.shard == Shard::WHOLE {
            return Vec::new();
        }
        let Design { sampling, points, seed } = self.design;
        vec![
            format!("shard: {}", self.shard),
            format!("design: {} {points} {seed}", sampling.word()),
            format!("name: {}", clean::line(&self.name)),
            format!("style: {}", self.style.word()),
        ]
    }

    /// Read the lines of a sidecar; what is wrong, in words, where they are not those of a part.
    ///
    /// # Errors
    /// The error in words.
    pub fn read(sidecar: &str) -> Result<Self, String> {
        let note = |key: &str| {
            let head = format!("# {key}: ");
            sidecar.lines().find_map(|line| line.strip_prefix(head.as_str())).map(str::trim)
        };
        if let Some(missing) = note("not complete") {
            return Err(format!("it is not complete ({missing}): compute it again"));
        }
        let shard = note("shard").ok_or("not a part of a sweep: make parts with --shard I/N")?;
        let broken = |key: &str| format!("its line `# {key}:` is missing or was changed");
        let design = || {
            let words: Vec<&str> = note("design")?.split(' ').collect();
            let [word, points, seed] = words[..] else { return None };
            let (points, seed) = (points.parse().ok()?, seed.parse().ok()?);
            let sampling = Sampling::ALL.into_iter().find(|it| it.word() == word)?;
            Some(Design { sampling, points, seed })
        };
        let style =
            note("style").and_then(|word| Style::ALL.into_iter().find(|it| it.word() == word));
        Ok(Self {
            shard: Shard::parse(shard).map_err(|_not_one| broken("shard"))?,
            design: design().ok_or_else(|| broken("design"))?,
            name: note("name").ok_or_else(|| broken("name"))?.to_owned(),
            style: style.ok_or_else(|| broken("style"))?,
        })
    }
}

/// Warnings about the rows, as lines of a sidecar.
fn warnings(scene: &Scene) -> Vec<String> {
    let axes = scene.sweep.as_ref().and_then(|sweep| Axis::all_of(sweep).ok()).unwrap_or_default();
    let ends: Vec<f64> = axes.iter().map(|axis| axis.ends().0).collect();
    let warnings = validity::of_axes(&scene_with(scene, &axes, &ends), &axes);
    warnings.iter().map(|warning| format!("warning: {}", clean::line(warning))).collect()
}
