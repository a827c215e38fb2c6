//! THE table of quantities: the name, unit, meaning and source of every number that a scene comes down to.
//!
//! JSON keys, the rows of exports, the outputs of sweeps, and what searches, Monte Carlo and sensitivity analysis request are all
//! taken from here, so that a name means the same everywhere: a new quantity is one row. What a quantity needs decides what it
//! costs: nothing is computed for a quantity that is not requested. Nothing here knows files or screens; the time a run took is
//! measured by whoever ran it.

use crate::study::error::QuantityError;
use crate::study::first_contact::FirstContact;
use crate::study::load::{impulse_n_s, peak_n};
use crate::study::measured::Key;
use crate::study::verdict::Expected;
use cmra_engine::model::mechanism::load;
use cmra_engine::model::run::{Run, RunResult, envelope};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::{self, Bare, Dimension, engineering};

mod mount;
mod names;

pub(in crate::study) use mount::turn_tells_force;
pub use names::{find, listing, named, nearest};

/// Quantity: a result that can be swept, sought, optimised and scattered.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Name in JSON, CSV and `[sweep] outputs`; with its unit at the end.
    pub name: &'static str,
    /// The kind of its values, which says in what units they may be written.
    kind: Dimension,
    /// Meaning, in a few words.
    pub meaning: &'static str,
    source: Source,
    /// How it follows from the first contact.
    pub(in crate::study) from_contact: FromContact,
    /// Lower bound for a run that ended before the value was final.
    lower_bound: Option<fn(&Run) -> Option<f64>>,
    /// Label if it differs from the name in files; else empty.
    title: &'static str,
    /// A word or two for narrow columns; empty: its title.
    short: &'static str,
    /// Why a shot that is stopped may be without it.
    pub(in crate::study) absence: &'static str,
    /// Flags of the quantity.
    traits: &'static [QuantityFlag],
}

/// Flag of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuantityFlag {
    /// Describes a perforation; most other quantities would mislead for perforated plates.
    OfPerforation,
    /// Describes the computation, not the design.
    OfComputation,
    /// A stack has it, too: of the whole shot.
    OfStack,
    /// A count of the computation, which JSON has as a whole number.
    Whole,
    /// A percentage.
    Percent,
    /// Describes the hole, which is as deep as a perforated plate.
    OfHole,
    /// Includes springs that are sized for one shot.
    CountsSprings,
    /// Needs the error estimate of a run.
    Estimate,
}

/// The searches with many shots.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) enum Search {
    Limit,
    /// A velocity of the limit that measurements let expect.
    Expected(fn(&Expected) -> f64),
    /// The lower end of that limit's band, else the law's limit.
    DesignLimit,
    LimitIfSpringSurvives,
    MassEfficiency,
}

/// Where a quantity comes from; `None` where it does not exist.
#[derive(Clone, Copy, Debug)]
enum Source {
    Scene(fn(&Scene) -> Option<f64>),
    Run(fn(&Run) -> Option<f64>),
    Result(RunResult),
    /// From a run with its course in time.
    Course(fn(&Run) -> Option<f64>),
    /// From a search with many shots, which the study of that search makes.
    Search(Search),
}

/// How a quantity follows from the first contact of a shot that this decides.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) enum FromContact {
    /// Needs a simulation.
    No,
    /// From its end.
    End(fn(&FirstContact) -> Option<f64>),
    /// From its end, the greatest displacement and the scene.
    Displacement(fn(&FirstContact, &Scene) -> Option<f64>),
    Scene,
}

enumeration! {
    /// The computation that a quantity needs.
    #[derive(PartialOrd, Ord)]
    pub enum Needs in NeedsRow {
        /// In a word.
        word: &'static str,
        /// In words, for people.
        words: &'static str,
    }
    /// Nothing.
    Scene { word: "scene", words: "no simulation" }
    /// A run.
    Run { word: "run", words: "a run" }
    /// A run with its course in time.
    Course { word: "course", words: "one simulation and its time series" }
    /// Many shots.
    Limit { word: "limit", words: "many shots (a limit search)" }
}

impl PartialEq for Quantity {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

const fn quantity(
    name: &'static str,
    kind: Dimension,
    meaning: &'static str,
    source: Source,
) -> Quantity {
    Quantity {
        name,
        kind,
        meaning,
        source,
        from_contact: match source {
            Source::Scene(_) => FromContact::Scene,
            Source::Run(_) | Source::Result(_) | Source::Course(_) | Source::Search(_) => {
                FromContact::No
            }
        },
        lower_bound: None,
        title: "",
        short: "",
        absence: "does not exist here",
        traits: &[],
    }
}

/// Quantity that is a result of a run with an error estimate of its own.
const fn result(result: RunResult, kind: Dimension, meaning: &'static str) -> Quantity {
    quantity(result.key(), kind, meaning, Source::Result(result))
}

/// The optional parts of a row.
impl Quantity {
    const fn by_contact(self, from_contact: FromContact) -> Self {
        Self { from_contact, ..self }
    }

    const fn at_least(self, bound: fn(&Run) -> Option<f64>) -> Self {
        Self { lower_bound: Some(bound), ..self }
    }

    const fn titled(self, title: &'static str) -> Self {
        Self { title, ..self }
    }

    const fn short(self, short: &'static str) -> Self {
        Self { short, ..self }
    }

    const fn absent(self, absence: &'static str) -> Self {
        Self { absence, ..self }
    }

    const fn is(self, traits: &'static [QuantityFlag]) -> Self {
        Self { traits, ..self }
    }
}

use Dimension::{ArealMass, Energy, Force, Impulse, Length, Mass, Number, Time, Velocity};
use FromContact::{Displacement, End};
use QuantityFlag::{
    CountsSprings, Estimate, OfComputation, OfHole, OfPerforation, OfStack, Percent, Whole,
};
use RunResult::{
    ArrestPenetration, ArrestPlateDisplacement, ArrestPlateVelocity, ArrestTime, ExitTime,
    FinalPenetration, InterfaceDemand, MaxPlateDisplacement, PeakContactForce, PeakMountForce,
    ResidualVelocity, RotationalEnergy, SeparationTime, SeparationVelocity, StoredEnergy, Stroke,
};

/// Why there is no displacement, and no percentage.
const UNSTOPPED: &str = "nothing stops the plate";
const NOT_MEASURED: &str = "not measured";
const NO_BASELINE: &str = "no baseline depth";

/// The greatest ratio that is reported: it stands for infinity, the ratio to a strength of zero.
const UNBOUNDED_RATIO: f64 = 1e6;

/// Name of the ballistic limit by the law, and of the limit that a search takes in its place.
pub const LIMIT: &str = "limit_velocity_m_s";
const DESIGN_LIMIT: &str = "design_limit_m_s";

/// Every quantity, in the order of files.
#[rustfmt::skip]
pub static QUANTITIES: &[Quantity] = &[
    result(ArrestPenetration, Length, "depth when projectile and plate first reach common velocity")
        .by_contact(End(|it| Some(it.arrest()?.penetration_m))).titled("depth at first stop"),
    result(ArrestTime, Time, "time at which projectile and plate first reach common velocity")
        .by_contact(End(|it| Some(it.arrest()?.t_s))).titled("time at first stop"),
    result(ArrestPlateDisplacement, Length, "plate displacement when projectile and plate first reach common velocity")
        .by_contact(End(|it| Some(it.arrest()?.plate_displacement_m))).titled("plate displacement at first stop"),
    result(ArrestPlateVelocity, Velocity, "the first common velocity of projectile and plate")
        .by_contact(End(|it| Some(it.arrest()?.plate_velocity_m_s))).titled("common velocity at first stop"),
    quantity(FinalPenetration.key(), Length, "depth of the hole at the end; of a stack, in all its plates", Source::Run(Run::shot_depth_m))
        .by_contact(End(|it| Some(it.end.penetration_m)))
        .at_least(|run| run.at_least.penetration_m).titled("final depth").short("depth").is(&[OfStack, OfHole]),
    quantity("percent_of_baseline", Number, "final depth over that of the same plate on a rigid mount, percent", Source::Run(Run::percent_of_baseline))
        .by_contact(End(|it| Some(100.0 * (it.arrest()?.penetration_m / it.baseline_m?))))
        .at_least(|run| Some(100.0 * (run.at_least.penetration_m? / run.baseline_penetration_m?)))
        .titled("% of rigid-mount depth").short("% of rigid mount").absent(NO_BASELINE).is(&[OfHole, Percent]),
    quantity("baseline_penetration_m", Length, "depth of the same shot into the same plate on a rigid mount", Source::Run(|run| run.baseline_penetration_m))
        .by_contact(End(|it| it.baseline_m)).titled("depth on a rigid mount").absent(NO_BASELINE),
    result(PeakContactForce, Force, "greatest contact force while penetrating").short("contact"),
    result(MaxPlateDisplacement, Length, "greatest plate displacement")
        .by_contact(Displacement(|it, _| it.max_displacement_m))
        .at_least(|run| run.at_least.plate_displacement_m).short("plate").absent(UNSTOPPED),
    result(Stroke, Length, "greatest displacement plus cocking distance: the space the mechanism needs behind the plate, not that of a swing back of neutral")
        .by_contact(Displacement(|it, _| Some(it.max_displacement_m? + it.start_m.abs())))
        .at_least(|run| Some(run.at_least.plate_displacement_m? - run.scene.start_m())).absent(UNSTOPPED),
    quantity(ResidualVelocity.key(), Velocity, "projectile velocity after perforation; of a stack, behind its base plate", Source::Run(Run::shot_residual_m_s)).is(&[OfPerforation, OfStack]),
    result(ExitTime, Time, "when the nose was clear of the rear face").is(&[OfPerforation]),
    result(SeparationTime, Time, "when the projectile left through the entry face"),
    result(SeparationVelocity, Velocity, "projectile velocity when it left through the entry face"),
    quantity("plate_velocity_after_m_s", Velocity, "plate velocity when projectile and plate part: as the nose is clear of the rear face, or leaves through the entry face", Source::Run(|run| run.plate_velocity_after_m_s)).titled("plate velocity after parting").short("plate after").absent("they do not part"),
    quantity("max_plate_displacement_time_s", Time, "when the plate comes to its greatest displacement", Source::Course(Run::max_displacement_time_s)).absent(UNSTOPPED),
    result(InterfaceDemand, Number, "greatest compression the fused interface carried, over its strength A S_y").titled("interface push over strength").short("push"),
    quantity("interface_tension_ratio", Number, "greatest tension the fused interface carries, way back included, over its strength g A S_y (1e6 without a grip)", Source::Run(|run| Some(run.interface_tension_ratio?.min(UNBOUNDED_RATIO)))).titled("interface pull over strength").short("pull"),
    quantity("energy_residual", Number, "error of the energy balance, relative to the energy at the start", Source::Run(energy_residual)).is(&[OfComputation, OfStack]),
    quantity("error_estimate", Number, "relative error estimate of the final depth", Source::Run(|run| run.error_estimate)).is(&[OfComputation, OfStack, Estimate]),
    result(StoredEnergy, Energy, "greatest energy stored in the springs"),
    quantity("yield_margin", Number, "yield strength over the greatest bending stress of the mechanism's beams", Source::Run(|run| run.mechanism.yield_margin)),
    quantity("added_inertia_kg", Mass, "mass that the mechanism adds to the plate: rotation, and the springs' own mass", Source::Run(|run| run.mechanism.added_kg)),
    quantity("spring_mass_kg", Mass, "the springs' own mass", Source::Run(|run| run.mechanism.spring_mass_kg)),
    result(RotationalEnergy, Energy, "greatest energy of the plate's rotation"),
    quantity(PeakMountForce.key(), Force, "greatest force into the mount, way back included: spring, damper and elastic stop; of a rigid mount, the contact force along the normal", Source::Run(peak_n))
        .by_contact(Displacement(|it, scene| mount::force_n(scene, it.max_displacement_m))).at_least(mount::min_peak_n).short("mount force"),
    quantity("mount_impulse_n_s", Impulse, "impulse into the mount along the plate's normal, up to the greatest displacement", Source::Course(|run| impulse_n_s(run).filter(|_| !run.series.is_empty()))),
    quantity("travel_margin", Number, "travel of a spring up to yield or the end of its law, over its greatest travel", Source::Run(travel_margin)),
    quantity("fused_stop_hits", Number, "hits on a rigid stop under a fused interface, which cannot carry them", Source::Run(|run| envelope::fused_stop_hits(run).map(|hits| hits as f64))),
    quantity("plate_mass_kg", Mass, "mass of the plate: gamma times that of the projectile", Source::Scene(|scene| Some(scene.plate_mass_kg()))),
    quantity("least_spring_mass_kg", Mass, "least mass of the springs for the greatest energy stored, by e_spring or of coils; not known of other springs", Source::Run(|run| mount::min_spring_kg(&run.scene, run.max_plate_displacement_m)))
        .by_contact(Displacement(|it, scene| mount::min_spring_kg(scene, it.max_displacement_m))).is(&[CountsSprings]),
    quantity("system_mass_kg", Mass, "plate and springs: their own mass where it is known, else their least mass; a damper, a stop and the mount are not counted; springs behind a perforated plate are not sized, then there is none", Source::Run(|run| mount::system_kg(&run.scene, mount::stopped_displacement_m(run))))
        .by_contact(Displacement(|it, scene| mount::system_kg(scene, it.stopped_displacement_m()))).short("system").is(&[CountsSprings]),
    quantity("areal_mass_kg_m2", ArealMass, "plate and springs over the plate's face; a damper, a stop and the mount are not counted; springs behind a perforated plate are not sized, then there is none", Source::Run(|run| mount::areal_kg_m2(&run.scene, mount::stopped_displacement_m(run))))
        .by_contact(Displacement(|it, scene| mount::areal_kg_m2(scene, it.stopped_displacement_m()))).is(&[CountsSprings]),
    quantity("plate_face_m", Length, "side of the plate's square face: the plate is a block of its material", Source::Scene(|scene| scene.is_sprung().then(|| scene.plate_face_m()))),
    quantity("face_over_diameter", Number, "side of the plate's face over the projectile's diameter: 3 or more for the model to hold", Source::Scene(envelope::face_ratio)),
    quantity("thickness_over_diameter", Number, "plate thickness over projectile diameter, h/D", Source::Scene(|scene| Some(envelope::thickness_ratio(scene)))),
    quantity("nose_pressure_ratio", Number, "pressure on the nose at impact, S + c v^2, over 2 GPa of hardened steel: below 0.5 it stays rigid", Source::Scene(|scene| Some(envelope::nose_pressure_ratio(scene)))),
    quantity(LIMIT, Velocity, "ballistic limit v_bl: the least impact velocity that perforates, whatever its springs have to store", Source::Search(Search::Limit)).short("limit").is(&[OfStack]),
    quantity("limit_if_spring_survives_m_s", Velocity, "least impact velocity that perforates or that the spring does not survive, by its known mass and the range of its law: as in `compare`", Source::Search(Search::LimitIfSpringSurvives)).short("spring survives"),
    quantity("expected_limit_m_s", Velocity, "ballistic limit that measurements of such shots let expect; none where no class was measured", Source::Search(Search::Expected(|it| it.limit_m_s))).short("expected").absent(NOT_MEASURED),
    quantity("expected_low_m_s", Velocity, "lower end of the band that holds 90 % of such measured limits", Source::Search(Search::Expected(|it| it.low_m_s))).short("low").absent(NOT_MEASURED),
    quantity("expected_high_m_s", Velocity, "upper end of the band that holds 90 % of such measured limits", Source::Search(Search::Expected(|it| it.high_m_s))).short("high").absent(NOT_MEASURED),
    quantity(DESIGN_LIMIT, Velocity, "limit to design for: expected_low_m_s where such shots were measured, else limit_velocity_m_s", Source::Search(Search::DesignLimit)).short("design limit").is(&[OfStack]),
    quantity("mass_efficiency", Number, "areal mass of the solid plate that just stops the same shot, over that of this armour", Source::Search(Search::MassEfficiency)).short("efficiency"),
    quantity("steps", Number, "accepted steps", Source::Run(|run| Some(run.cost.steps as f64))).is(&[OfComputation, Whole]),
    quantity("rejected", Number, "rejected steps", Source::Run(|run| Some(run.cost.rejected as f64))).is(&[OfComputation, Whole]),
    quantity("rhs_evaluations", Number, "evaluations of the equations of motion", Source::Run(|run| Some(run.cost.rhs_evaluations as f64))).is(&[OfComputation, Whole]),
];

impl Quantity {
    /// Whether this is so of it.
    pub fn has(&self, what: QuantityFlag) -> bool {
        self.traits.contains(&what)
    }

    /// Returns the unit; `%` for a percentage, empty for a pure number.
    pub fn unit(&self) -> &'static str {
        if self.has(Percent) { "%" } else { self.kind.unit() }
    }

    /// Returns the label without the unit: `max plate displacement`.
    pub fn title(&self) -> String {
        if self.title.is_empty() { self.key_words() } else { self.title.to_owned() }
    }

    /// The words of its name in files, by which it is found too: `first arrest penetration`.
    pub fn key_words(&self) -> String {
        self.bare().replace('_', " ")
    }

    /// Returns the name in files without the unit: `max_plate_displacement`.
    fn bare(&self) -> &'static str {
        let end = format!("_{}", self.kind.unit().to_lowercase().replace(['/', ' '], "_"));
        self.name.strip_suffix(&end).unwrap_or(self.name)
    }

    /// Returns the short label for a heading.
    pub fn heading(&self) -> String {
        if self.short.is_empty() { self.title() } else { self.short.to_owned() }
    }

    /// The computation it needs.
    pub fn needs(&self) -> Needs {
        match self.source {
            Source::Scene(_) => Needs::Scene,
            Source::Run(_) | Source::Result(_) => Needs::Run,
            Source::Course(_) => Needs::Course,
            Source::Search(_) => Needs::Limit,
        }
    }

    /// A value with its unit, in a given number of digits: `64.27 %`, `37.98 mm`, `61.2 g`.
    pub fn show(&self, value: f64, digits: usize) -> String {
        self.shown(value, digits, units::significant)
    }

    /// Formats a value for a table with all digits: `60.00 %`.
    pub fn show_all_digits(&self, value: f64, digits: usize) -> String {
        self.shown(value, digits, units::fixed_significant)
    }

    fn shown(&self, value: f64, digits: usize, number: fn(f64, usize) -> String) -> String {
        match self.unit() {
            unit @ ("" | "%" | "kg/m2") => {
                format!("{} {unit}", number(value, digits)).trim_end().to_owned()
            }
            unit => engineering(value, unit, digits),
        }
    }

    /// Formats a value; a dash for `None`.
    pub fn show_any(&self, value: Option<f64>, digits: usize) -> String {
        value.map_or_else(|| units::NO_NUMBER.to_owned(), |value| self.show(value, digits))
    }

    /// Read a value: SI, or with a unit (`45mm`, `20 kN`, `1kJ`); percentages as they are shown (`60` or `60 %`).
    pub fn parse(&self, text: &str) -> Result<f64, String> {
        let bare = if self.unit() == "%" { text.trim().trim_end_matches('%') } else { text };
        units::parse(bare, self.kind, Bare::Si)
    }

    /// Reads a value; a bare number has the unit shown beside the field.
    pub fn parse_in(&self, text: &str, unit: &str) -> Result<f64, String> {
        // Percentages are numbers of per cent.
        if self.unit() == "%" {
            self.parse(text)
        } else {
            units::parse(text, self.kind, Bare::In(unit))
        }
    }

    /// Returns the lower bound if a run ended before the value was final; `None` if it is final or unknown.
    pub fn lower_bound(&self, run: &Run) -> Option<f64> {
        // The bounds of a run are those of its first plate.
        self.lower_bound?(run).filter(|bound| bound.is_finite() && run.stack.is_none())
    }

    /// Returns the value for a run; `None` if it does not exist. Values are finite.
    pub fn value(&self, run: &Run) -> Option<f64> {
        let own = || match self.source {
            Source::Scene(get) => get(&run.scene),
            Source::Run(get) | Source::Course(get) => get(run),
            Source::Result(result) => result.value(run),
            Source::Search(_) => None,
        };
        let has = self.has(OfStack) || run.stack.is_none();
        own().filter(|value| has && value.is_finite())
    }

    /// Checks that the quantity exists for the scene; a stack lacks some quantities.
    pub(in crate::study) fn check_exists(&self, scene: &Scene) -> Result<(), QuantityError> {
        if self.has(OfStack) || !scene.is_stack() {
            return Ok(());
        }
        Err(QuantityError::NotOfStacks { title: self.title(), instead: OF_STACKS })
    }

    /// Returns the value for a shot that the first contact decides.
    pub(in crate::study) fn of_contact(&self, answer: &FirstContact, scene: &Scene) -> Option<f64> {
        match (self.from_contact, self.source) {
            (End(get), _) => get(answer),
            (Displacement(get), _) => get(answer, scene),
            (FromContact::Scene, Source::Scene(get)) => get(scene),
            (FromContact::Scene | FromContact::No, _) => None,
        }
    }

    /// The quantity that a search for designs of a scene takes in its place: for the limit of shots that were measured the lower end of
    /// their band.
    pub(in crate::study) fn design_quantity(&'static self, scene: &Scene) -> &'static Self {
        let is_limit = self.name == LIMIT && Key::from_scene(scene).is_some();
        is_limit.then(|| find(DESIGN_LIMIT)).flatten().unwrap_or(self)
    }

    /// The search that finds it, if one has to.
    pub(in crate::study) fn search(&self) -> Option<Search> {
        if let Source::Search(search) = self.source { Some(search) } else { None }
    }

    /// Whether a run has to keep its course in time for it.
    pub(in crate::study) fn needs_course(&self) -> bool {
        self.needs() == Needs::Course
    }

    /// Whether designs that are perforated may be compared by it.
    pub(in crate::study) fn is_defined_when_perforated(&self) -> bool {
        // What does not depend on the outcome of the shot does.
        self.has(OfPerforation) || matches!(self.source, Source::Scene(_) | Source::Search(_))
    }
}

/// The error of the energy balance of the plate where it is greatest.
fn energy_residual(run: &Run) -> Option<f64> {
    let residuals = run.plates().map(|run| run.ledger.residual());
    residuals.max_by(|a, b| a.abs().total_cmp(&b.abs()))
}

/// The least of limit over displacement, of every spring and limit; `None` where no spring has a limit that a run comes near.
fn travel_margin(run: &Run) -> Option<f64> {
    let farthest = run.max_plate_displacement_m.filter(|_| run.scene.is_sprung())?;
    load::travel_margin(&run.scene, run.scene.start_m(), farthest)
}

/// The depth in a stack, and in a single plate as a part of that in a rigid one.
const OF_STACKS: &str = "final_penetration_m";
const OF_PLATES: &str = "percent_of_baseline";

/// Returns the default quantity of a study.
pub fn default_for(scene: &Scene) -> &'static str {
    if scene.is_stack() { OF_STACKS } else { OF_PLATES }
}

/// Every quantity that a run without its course in time comes down to: what a sweep gives where nothing is named.
pub fn of_every_run() -> impl Iterator<Item = &'static Quantity> {
    QUANTITIES.iter().filter(|it| it.needs() <= Needs::Run)
}

/// Every quantity a run with its course comes down to: limit searches are made on request alone.
pub fn of_runs() -> impl Iterator<Item = &'static Quantity> {
    QUANTITIES.iter().filter(|it| it.needs() < Needs::Limit)
}

/// The quantities that describe a design, in the order of tables: those of the computation are omitted, and limits.
pub fn usual() -> impl Iterator<Item = &'static Quantity> {
    of_runs().filter(|it| !it.has(OfComputation))
}
