//! The sidecar of a part of a sweep: which part of which design it is, and its CSV dialect.

use std::fmt::Write as _;

use crate::files::clean;
use crate::files::export::{self, Beside};
use crate::files::style::Style;
use crate::files::write;
use crate::model::scene::Scene;
use crate::study::quantities;
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

/// The FNV-1a hash of bytes, by which a changed file is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checksum(u64);

impl Default for Checksum {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Checksum {
    /// Take in further bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

/// How a table that goes beside its scene was written.
#[derive(Clone, Copy, Debug, Default)]
pub struct Written<'a> {
    /// That the table is not complete, and how much of it there is.
    pub missing: Option<&'a str>,
    /// The checksum of its bytes.
    pub checksum: Checksum,
}

impl Part {
    /// The scene that goes beside this part: what makes the rows again, and, for a part, what it takes to join it. The scene has
    /// its `[sweep]`.
    pub fn beside<'a>(&'a self, scene: &'a Scene, written: Written<'a>) -> Beside<'a> {
        let notes = move |own: &str| self.notes(own, scene, written);
        Beside { run: None, scene, notes: Box::new(notes) }
    }

    /// Whether a part with this sidecar and a table of this checksum is as it was written. Comments may change, and names of files.
    pub fn is_as_written(&self, sidecar: &str, table: Checksum) -> bool {
        note(sidecar, "checksum") == Some(self.seal(sidecar, table).as_str())
    }

    /// The checksum of the table, of the lines that `join` reads, and of the scene.
    fn seal(&self, scene: &str, mut checksum: Checksum) -> String {
        let of_scene = scene.lines().filter(|line| !line.starts_with('#'));
        for line in self.lines().iter().map(String::as_str).chain(of_scene) {
            checksum.add(line.trim_end().as_bytes());
        }
        format!("{:016x}", checksum.0)
    }

    fn notes(
        &self,
        own: &str,
        scene: &Scene,
        Written { missing, checksum }: Written<'_>,
    ) -> String {
        let mut again = format!("cmra sweep {}", clean::shell_word(own));
        let Design { sampling, points, seed } = self.design;
        if sampling != Sampling::Factorial {
            let word = sampling.word();
            let _ = write!(again, " --design {word} --points {points} --seed {seed}");
        }
        if self.shard != Shard::WHOLE {
            let _ = write!(again, " --shard {}", self.shard);
        }
        if self.style != Style::default() {
            let _ = write!(again, " --csv-style {}", self.style.word());
        }
        again += " --csv -";
        let missing = missing.map(str::to_owned);
        let is_part = self.shard != Shard::WHOLE;
        let seal =
            is_part.then(|| format!("checksum: {}", self.seal(&write::fresh(scene), checksum)));
        let mut text = String::new();
        for note in missing.into_iter().chain(self.lines()).chain(seal).chain(warnings(scene)) {
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
        let note = |key: &str| note(sidecar, key);
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
        note("checksum").ok_or_else(|| broken("checksum"))?;
        Ok(Self {
            shard: Shard::parse(shard).map_err(|_not_one| broken("shard"))?,
            design: design().ok_or_else(|| broken("design"))?,
            name: note("name").ok_or_else(|| broken("name"))?.to_owned(),
            style: style.ok_or_else(|| broken("style"))?,
        })
    }
}

/// The value of a line `# KEY: VALUE` of a sidecar.
fn note<'s>(sidecar: &'s str, key: &str) -> Option<&'s str> {
    let head = format!("# {key}: ");
    sidecar.lines().find_map(|line| line.strip_prefix(head.as_str())).map(str::trim)
}

/// Warnings about the rows, as lines of a sidecar.
fn warnings(scene: &Scene) -> Vec<String> {
    let sweep = scene.sweep.as_ref();
    let axes = sweep.and_then(|sweep| Axis::all_of(sweep).ok()).unwrap_or_default();
    let ends: Vec<f64> = axes.iter().map(|axis| axis.ends().0).collect();
    let mut warnings = validity::of_points(&scene_with(scene, &axes, &ends), &axes);
    let outputs = sweep.into_iter().flat_map(|sweep| &sweep.outputs);
    let outputs: Vec<_> = outputs.filter_map(|name| quantities::find(name)).collect();
    warnings.extend(validity::of_pair(scene, &axes, &outputs));
    warnings.iter().map(|warning| format!("warning: {}", clean::line(warning))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of the authors of FNV.
    #[test]
    fn valid_the_checksum_is_fnv_1a() {
        for (text, expected) in [("", 0xcbf2_9ce4_8422_2325), ("foobar", 0x8594_4171_f739_67e8)] {
            let mut checksum = Checksum::default();
            checksum.add(text.as_bytes());
            assert_eq!(checksum, Checksum(expected), "{text}");
        }
    }
}
