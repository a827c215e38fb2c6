//! Entries of the libraries: a threat, a material or an absorber as values of variables, with where they come from.

use std::path::PathBuf;

use cmra_engine::model::run::Warning;
use cmra_engine::model::scene::{Closure, DragSource, Nose, Scene, Target};
use cmra_engine::model::variables::{self, Value, VariableError};

enumeration! {
    /// Library, named after its file.
    pub enum Library in LibraryRow {
        /// Name of the file.
        file: &'static str,
        /// The word for one of its entries.
        key: &'static str,
    }
    /// Projectiles.
    Threats { file: "threats", key: "threat" }
    /// Metals of plates.
    Materials { file: "materials", key: "material" }
    /// Springs and absorbers.
    Absorbers { file: "absorbers", key: "absorber" }
}

impl Library {
    /// The start of the line in a scene's notes that warns of one of its entries.
    fn warning_start(self) -> String {
        format!("{} warning: ", self.key())
    }

    /// The tables of a scene whose keys its entries have. A threat brings the closure and the drag coefficient of its nose.
    pub fn tables(self) -> &'static [&'static str] {
        match self {
            Self::Threats => &["projectile", "target"],
            Self::Materials => &["target"],
            Self::Absorbers => &["mechanism"],
        }
    }
}

enumeration! {
    /// Evidence for the values of an entry.
    pub enum Status in StatusRow {
        /// Keyword in files.
        word: &'static str,
    }
    /// Measured.
    Measured { word: "measured" }
    /// Given by a standard.
    Standard { word: "standard" }
    /// Typical of its kind, or computed from a published formula.
    Typical { word: "typical" }
}

/// Entry of a library.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The library it belongs to.
    pub library: Library,
    /// Name to choose it by.
    pub name: String,
    /// A line for people.
    pub title: String,
    /// How well its values are known.
    pub status: Status,
    /// The publication the values come from.
    pub source: String,
    /// Further remarks; may be empty.
    pub note: String,
    /// Why a result with it must be read with care; may be empty.
    pub warning: String,
    /// The user's own file it stands in; `None` for one that comes with the program.
    pub own: Option<PathBuf>,
    /// The variables it sets, by their keys.
    pub values: Vec<(&'static str, Value)>,
}

impl Entry {
    /// Takes its values into a scene and notes where they come from. A material takes the closure that suits nose and plate.
    pub fn apply(&self, scene: &mut Scene) -> Result<(), VariableError> {
        for (key, value) in &self.values {
            variables::find(key)?.set(scene, *value)?;
        }
        if self.library == Library::Materials {
            let is_round = scene.projectile.nose == Nose::Hemispherical;
            scene.target.closure =
                if is_round { Closure::ByThickness } else { Closure::Cylindrical };
        }
        if self.library != Library::Absorbers && scene.target.closure.chooses_drag() {
            // The coefficient of a threat is that of its nose.
            scene.target.drag = DragSource::Closure;
            note_closure(scene);
        }
        let (start, warns) = (format!("{}: ", self.library.key()), self.library.warning_start());
        let is_other = |line: &&str| !line.starts_with(&start) && !line.starts_with(&warns);
        let mut notes: Vec<String> =
            scene.notes.lines().filter(is_other).map(str::to_owned).collect();
        notes.push(format!("{start}{}. {}", self.title, self.evidence()));
        if !self.warning.is_empty() {
            let warning: Vec<&str> = self.warning.split_whitespace().collect();
            notes.push(format!("{warns}{}: {}", self.name, warning.join(" ")));
        }
        scene.notes = notes.join("\n");
        Ok(())
    }

    /// Where its values come from, and what else is to be known.
    pub fn evidence(&self) -> String {
        let note = if self.note.is_empty() { String::new() } else { format!(" ({})", self.note) };
        format!("{}: {}{note}", self.status.word(), self.source)
    }
}

/// Writes the dishing and the drag in effect beside a closure by thickness: files show them, and a closure that is stated later
/// starts from them.
pub fn note_closure(scene: &mut Scene) {
    let Target { closure, drag, .. } = scene.target;
    scene.target = Target { closure, drag, ..scene.target_in_effect() };
}

/// Whether a line of a scene's notes is the warning of an entry: they stand there, so that a file keeps them.
pub fn is_warning(line: &str) -> bool {
    Library::ALL.iter().any(|library| line.starts_with(&library.warning_start()))
}

/// The warnings of the entries that a scene was made from.
pub fn warnings(scene: &Scene) -> impl Iterator<Item = Warning> {
    scene.notes.lines().filter(|line| is_warning(line)).map(|line| Warning::remark(line, ""))
}
