//! Scene of a command: SCENE, then library entries, then every `--set` in order.

use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::io;
use std::path::Path;

use clap::Args;

use crate::cli::{CliError, output, text};
use crate::files::bundled;
use crate::files::inputs;
use crate::files::library;
use crate::files::paths::Paths;
use crate::files::preset::{self, Origin, Preset};
use crate::files::read;
use crate::files::{clean, read_table};
use cmra_engine::model::mechanism::PowerLaw;
use cmra_engine::model::scene::{Closure, Mechanism, PlateSize, Scene, SpringKind, Table};
use cmra_engine::model::units::{self, Bare, Dimension, shortest};
use cmra_engine::model::variables::{self, Variable, can_be_used, used_where};
use cmra_studies::study::error::refusal;
use cmra_studies::study::library::{Library, note_closure};

const VELOCITY: &str = "projectile.velocity_m_s";

/// Arguments of a scene: SCENE and its changes.
#[derive(Debug, Args)]
pub(super) struct SceneArguments {
    /// A preset's name, the path of a TOML file, or `-` for standard input [default: thesis-baseline]
    scene: Option<OsString>,
    #[command(flatten)]
    pub(super) changes: SceneOverrides,
}

/// Changes of a scene: library entries, then `--set`.
#[derive(Debug, Args)]
pub(super) struct SceneOverrides {
    /// Take mass, radius and velocity of a threat (`cmra libraries threats` lists them)
    #[arg(long, value_name = "NAME")]
    threat: Option<String>,
    /// Take density and strength of a material, with the closure that suits the plate (`cmra libraries materials`)
    #[arg(long, value_name = "NAME")]
    material: Option<String>,
    /// Take the energy per mass of an absorber (`cmra libraries absorbers`)
    #[arg(long, value_name = "NAME")]
    absorber: Option<String>,
    /// Change a variable; may be repeated, and is applied in order.
    #[arg(
        long,
        value_name = "NAME=VALUE",
        allow_hyphen_values = true,
        help = "Change a variable: NAME is a thesis symbol (gamma, v_i, k) or a full key (interface.grip), VALUE is SI \
                or has a unit (d=50mm); table=FILE takes a measured spring curve from CSV; may be repeated"
    )]
    set: Vec<String>,
}

impl SceneArguments {
    /// Returns the scene with all changes applied, and says which of them have no effect.
    pub(super) fn load(&self) -> Result<Preset, CliError> {
        let preset = self.read()?;
        self.changes.say_unused(&preset.scene, []);
        Ok(preset)
    }

    /// Returns the scene with all changes applied. A study that varies variables then calls [`SceneOverrides::say_unused`].
    pub(super) fn read(&self) -> Result<Preset, CliError> {
        let mut preset = match self.scene.as_deref() {
            Some(name) if name == "-" => from_stdin()?,
            name => named(name.unwrap_or_else(|| OsStr::new(bundled::BASELINE)))?,
        };
        self.changes.apply(&mut preset.scene)?;
        if let Some(heading) = self.changes.heading(&preset.name) {
            preset.heading.clone_from(&heading);
            preset.scene.title = heading;
        }
        Ok(preset)
    }

    /// Returns `true` if a scene or a change is given.
    pub(super) fn is_given(&self) -> bool {
        self.scene.is_some() || !self.changes.typed().is_empty()
    }
}

impl SceneOverrides {
    pub(super) fn apply(&self, scene: &mut Scene) -> Result<(), CliError> {
        for (library, name) in self.entries() {
            let entry = library::find(library, name, Paths::of_user().ok().as_ref())?;
            entry.apply(scene)?;
            let has_velocity = entry.values.iter().any(|(key, _)| *key == VELOCITY);
            if library == Library::Threats
                && !has_velocity
                && self.set_of(|key| key == VELOCITY).is_none()
            {
                let v = scene.projectile.velocity_m_s;
                output::note(&format!(
                    "warning: threat {name} has no velocity: v_i = {v} m/s is the scene's; set v_i, unless an axis does"
                ));
            }
        }
        change(scene, &self.set)?;
        let set = |key| self.set_of(|found| found == key).is_some();
        if set("target.drag_coefficient") && !set("target.drag") {
            // The default drag coefficient depends on the closure, which can be set later.
            scene.target.give_drag();
        }
        if self.material.is_none() || set("target.closure") {
            return Ok(());
        }
        let is_given = set("target.flow_strength_pa");
        // A value given explicitly takes precedence over the default for the thickness.
        let own_dishing = set("target.dishing").then_some(scene.target.dishing);
        if !is_given && own_dishing.is_none() {
            note_closure(scene);
            return Ok(());
        }
        scene.target = scene.target_in_effect();
        scene.target.dishing = own_dishing.unwrap_or(scene.target.dishing);
        if is_given {
            scene.target.closure = Closure::Given;
        } else {
            let closure = scene.target.closure.word();
            output::note(&format!(
                "warning: dishing is set: closure = {closure} then holds for every thickness"
            ));
        }
        Ok(())
    }

    /// Prints a note for each `--set` without effect, with the changes that would give it one, and for each coefficient with the unit of a
    /// linear law if the law is not linear. A variable that takes effect for some values of those that vary has no note.
    pub(super) fn say_unused(
        &self,
        scene: &Scene,
        varied: impl IntoIterator<Item = &'static Variable>,
    ) {
        let varied: Vec<&Variable> = varied.into_iter().collect();
        for argument in &self.set {
            let Some(variable) = variable_of(argument) else { continue };
            let (_, value) = argument.split_once('=').unwrap_or_default();
            let symbol = variable.symbol;
            if !can_be_used(variable, scene, &varied) {
                let lacks = if variables::gives_mass(variable) {
                    "changes only masses here, not the motion"
                } else {
                    "has no effect on this scene"
                };
                let used = used_where(variable, scene);
                let used = used.unwrap_or_else(|| "where it has a value".to_owned());
                output::note(&format!("warning: {symbol} {lacks}: it is used {used}"));
            } else if let Some(law) = bent_law(variable, value, scene) {
                let (unit, exponent) = (variable.unit(), law.exponent);
                output::note(&format!(
                    "warning: {argument}: {symbol} is in {unit} with an exponent of {exponent} here; it is taken as {symbol}={}",
                    shortest(law.coefficient)
                ));
            }
        }
    }

    /// Returns the library entries given.
    fn entries(&self) -> impl Iterator<Item = (Library, &str)> {
        let named = [
            (Library::Threats, &self.threat),
            (Library::Materials, &self.material),
            (Library::Absorbers, &self.absorber),
        ];
        named.into_iter().filter_map(|(library, name)| Some((library, name.as_deref()?)))
    }

    /// Returns the heading of a changed scene: `threat fsp-22, material aa6061-t651, from thesis-baseline: 2 changes`; `None` without a
    /// change.
    fn heading(&self, name: &str) -> Option<String> {
        let entries = self.entries().map(|(library, name)| format!("{} {name}", library.key()));
        let entries: Vec<String> = entries.collect();
        // The last of several values of a variable is the one that holds.
        let changed = |argument: &String| match variable_of(argument) {
            Some(variable) => variable.key.to_owned(),
            None => argument.split('=').next().unwrap_or_default().trim().to_owned(),
        };
        let changed: BTreeSet<String> = self.set.iter().map(changed).collect();
        let set = match changed.len() {
            0 if entries.is_empty() => return None,
            0 => String::new(),
            1 => ": 1 change".to_owned(),
            count => format!(": {count} changes"),
        };
        let subject =
            if entries.is_empty() { "a scene of your own".to_owned() } else { entries.join(", ") };
        Some(clean::line(&format!("{subject}, from {name}{set}")).into_owned())
    }

    /// Returns the heading lines that list the changes; empty without changes.
    pub(super) fn changed(&self) -> String {
        let typed = self.typed();
        if typed.is_empty() {
            return String::new();
        }
        let changes = typed.join(", ");
        text::hanging("", &format!("changed: {}", clean::line(&changes)), 2)
    }

    /// Returns the changes as given.
    fn typed(&self) -> Vec<String> {
        let entries = self.entries().map(|(library, name)| format!("{} {name}", library.key()));
        entries.chain(self.set.iter().cloned()).collect()
    }

    /// Returns the first `--set` whose key satisfies a predicate.
    pub(super) fn set_of(&self, is_chosen: impl Fn(&str) -> bool) -> Option<&str> {
        let mut set = self.set.iter().map(String::as_str);
        set.find(|argument| variable_of(argument).is_some_and(|found| is_chosen(found.key)))
    }
}

/// Returns the variable of a `--set`.
fn variable_of(argument: &str) -> Option<&'static Variable> {
    variables::find(argument.split('=').next()?.trim()).ok()
}

/// Returns the power law of a coefficient with the unit of a linear law, if the exponent is not 1.
fn bent_law(variable: &Variable, value: &str, scene: &Scene) -> Option<PowerLaw> {
    let number = variable.number()?;
    let (linear, exponent) = match number.quantity {
        Dimension::SpringCoefficient => {
            let Mechanism { spring, second, .. } = &scene.mechanism;
            let is_second = variable.key.starts_with("mechanism.second.");
            (Dimension::Stiffness, if is_second { second.exponent } else { spring.exponent })
        }
        Dimension::DamperCoefficient => (Dimension::Damping, scene.mechanism.damper.exponent),
        _ => return None,
    };
    let is_in = |quantity| units::parse(value, quantity, Bare::Si).is_ok();
    let is_bent =
        is_in(linear) && !is_in(Dimension::Number) && (exponent - 1.0).abs() > f64::EPSILON;
    Some(PowerLaw { coefficient: (number.get)(scene)?, exponent }).filter(|_| is_bent)
}

fn change(scene: &mut Scene, set: &[String]) -> Result<(), CliError> {
    refuse_two_sizes(set)?;
    let was = scene.mechanism.spring.kind;
    let mut has_curve = false;
    for argument in set {
        let refuse = |why: &str| CliError::Option(format!("--set {argument}: {why}"));
        let (name, value) = argument
            .split_once('=')
            .filter(|(name, _)| !name.trim().is_empty())
            .ok_or_else(|| refuse("write NAME=VALUE, for example --set gamma=2"))?;
        if CURVE_NAMES.contains(&name.trim()) {
            // A file with points sets the kind of the spring to `table`.
            scene.mechanism.spring.table.points = read_table::curve(Path::new(value.trim()))?;
            scene.mechanism.spring.kind = SpringKind::Table;
            has_curve = true;
            continue;
        }
        let set = variables::set_by_name(scene, name, value);
        set.map_err(|problem| refuse(&refusal(&problem)))?;
    }
    let spring = &scene.mechanism.spring;
    let begins = spring.kind == SpringKind::Table && was != SpringKind::Table;
    // The scene can contain points that its spring does not use.
    if begins && !has_curve && spring.table == Table::default() {
        return Err(CliError::Option(
            "--set spring=table: the table has no measured curve: add --set table=FILE, a CSV file of displacement (m) and force (N)"
                .to_owned(),
        ));
    }
    Ok(())
}

/// Rejects two inputs that both set the size of the plate: the last one would silently replace the first.
fn refuse_two_sizes(set: &[String]) -> Result<(), CliError> {
    let keys = set.iter().filter_map(|argument| Some((variable_of(argument)?.key, argument)));
    let mut given = keys.filter(|(key, _)| PlateSize::KEYS.contains(key));
    let Some((first_key, first)) = given.next() else { return Ok(()) };
    given.find(|(key, _)| *key != first_key).map_or(Ok(()), |(_, second)| {
        Err(CliError::Option(format!(
            "--set {first} and --set {second}: both give the plate's size; give one of gamma, m_2 and face"
        )))
    })
}

/// Names of the measured curve of the spring.
const CURVE_NAMES: [&str; 3] = ["table", "mechanism.spring.table", "mechanism.spring.table.file"];

/// Loads a scene by name or path. Without a home directory there are only bundled presets.
pub(super) fn named(name: &OsStr) -> Result<Preset, CliError> {
    let mut preset = match name.to_str() {
        Some(name) => preset::resolve(name, Paths::of_user().ok().as_ref())?,
        // A name that is not UTF-8 can only be a path.
        None => preset::from_file(Path::new(name))?,
    };
    // The name appears in pages, tables and messages: control characters are removed.
    preset.name = clean::line(&preset.name).into_owned();
    preset.heading.clone_from(&preset.name);
    Ok(preset)
}

fn from_stdin() -> Result<Preset, CliError> {
    let name = "standard input";
    inputs::note_stdin()?;
    let text = read::text_from(io::stdin().lock(), Path::new(name), read::BYTES_MAX)?;
    Ok(preset::from_text(name.to_owned(), Origin::Text, text)?)
}
