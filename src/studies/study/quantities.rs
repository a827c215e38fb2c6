//! Table of all quantities: name, unit, meaning and source of each number computed for a scene.
//!
//! JSON keys, export rows, sweep outputs, and the requests of searches, Monte Carlo and sensitivity studies use this table. A name
//! therefore has the same meaning everywhere, and a new quantity is one row. The source of a quantity determines its cost; quantities that
//! are not requested are not computed. The module does not depend on files or the terminal. The caller measures the run time.

use crate::study::envelope;
use crate::study::error::QuantityError;
use crate::study::first_contact::FirstContact;
use crate::study::load::{impulse_n_s, peak_n};
use crate::study::measured::class::Key;
use crate::study::verdict::Expected;
use cmra_engine::model::mechanism::load;
use cmra_engine::model::run::{Run, RunResult};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::{self, Bare, Dimension, UnitError, engineering};

mod mount;
mod names;

pub(in crate::study) use mount::turn_tells_force;
pub use names::{find, listing, named, nearest};

/// Quantity: a result that can be swept, sought, optimised and scattered.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Name in JSON, CSV and `[sweep] outputs`, ending in the unit.
    pub name: &'static str,
    /// Dimension of the values; determines the allowed units.
    kind: Dimension,
    /// Short description.
    pub meaning: &'static str,
    source: Source,
    /// Computation from the first contact.
    pub(in crate::study) from_contact: FromContact,
    /// Lower bound for a run that ended before the value was final.
    lower_bound: Option<fn(&Run) -> Option<f64>>,
    /// Label if it differs from the name in files; else empty.
    title: &'static str,
    /// Title in fewer letters, distinct from the other titles; empty if the title is short.
    brief_title: &'static str,
    /// Label of one or two words for narrow columns; empty for the title.
    short: &'static str,
    /// Reason why a stopped shot may lack the quantity.
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
    /// Also exists for a stack, where it describes the whole shot.
    OfStack,
    /// Counter of the computation, a whole number in JSON.
    Whole,
    /// Percentage.
    Percent,
    /// Describes the hole, whose depth is the plate thickness after a perforation.
    OfHole,
    /// Includes springs that are sized for one shot.
    CountsSprings,
    /// Needs the error estimate of a run.
    Estimate,
}

/// Searches that take many shots.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) enum Search {
    Limit,
    /// Velocity from the limit expected by measurements.
    Expected(fn(&Expected) -> f64),
    /// Lower end of the band of the expected limit, else the law's limit.
    DesignLimit,
    LimitIfSpringSurvives,
    MassEfficiency,
}

/// Source of a quantity; the value is `None` if it does not exist.
#[derive(Clone, Copy, Debug)]
enum Source {
    Scene(fn(&Scene) -> Option<f64>),
    Run(fn(&Run) -> Option<f64>),
    Result(RunResult),
    /// Time series of a run.
    Course(fn(&Run) -> Option<f64>),
    /// Search with many shots, by the study of that search.
    Search(Search),
}

/// Computation of a quantity for a shot that is decided at the first contact.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) enum FromContact {
    /// Not possible: the quantity needs a simulation.
    No,
    /// From the state at the end of the contact.
    End(fn(&FirstContact) -> Option<f64>),
    /// From that state, the maximum plate displacement and the scene.
    Displacement(fn(&FirstContact, &Scene) -> Option<f64>),
    Scene,
}

enumeration! {
    /// Computation required for a quantity.
    #[derive(PartialOrd, Ord)]
    pub enum Needs in NeedsRow {
        /// Keyword.
        word: &'static str,
        /// Text for the user.
        words: &'static str,
    }
    /// No computation.
    Scene { word: "scene", words: "no simulation" }
    /// Single run.
    Run { word: "run", words: "a run" }
    /// Single run with its time series.
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
        brief_title: "",
        short: "",
        absence: "does not exist here",
        traits: &[],
    }
}

/// Creates a quantity from a result of a run that has an error estimate.
const fn result(result: RunResult, kind: Dimension, meaning: &'static str) -> Quantity {
    quantity(result.key(), kind, meaning, Source::Result(result))
}

/// Builder methods for the optional fields of a row.
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

    const fn briefly(self, brief_title: &'static str) -> Self {
        Self { brief_title, ..self }
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
    FinalPenetration, InterfaceDemand, InterfaceTension, MaxPlateDisplacement, PeakContactForce,
    PeakMountForce, ResidualVelocity, RotationalEnergy, SeparationTime, SeparationVelocity,
    StoredEnergy, Stroke,
};

/// Reason why there is no displacement or percentage.
const UNSTOPPED: &str = "nothing stops the plate";
const NOT_MEASURED: &str = "not measured";
const NO_BASELINE: &str = "no baseline depth";

/// Maximum reported ratio; stands for an infinite ratio, to a strength of zero.
const UNBOUNDED_RATIO: f64 = 1e6;

/// Name of the ballistic limit by the law; searches for designs may replace it.
pub const LIMIT: &str = "limit_velocity_m_s";
/// Keys of the limit that measurements let expect, and of the ends of its band.
pub const EXPECTED: [&str; 3] = ["expected_limit_m_s", "expected_low_m_s", "expected_high_m_s"];
const DESIGN_LIMIT: &str = "design_limit_m_s";

/// All quantities, in the order of files.
#[rustfmt::skip]
pub static QUANTITIES: &[Quantity] = &[
    result(ArrestPenetration, Length, "depth when projectile and plate first reach common velocity")
        .by_contact(End(|it| Some(it.arrest()?.penetration_m))).titled("depth at first stop").briefly("depth at stop"),
    result(ArrestTime, Time, "time at which projectile and plate first reach common velocity")
        .by_contact(End(|it| Some(it.arrest()?.t_s))).titled("time at first stop").briefly("time at stop"),
    result(ArrestPlateDisplacement, Length, "plate displacement when projectile and plate first reach common velocity")
        .by_contact(End(|it| Some(it.arrest()?.plate_displacement_m))).titled("plate displacement at first stop").briefly("travel at stop"),
    result(ArrestPlateVelocity, Velocity, "the first common velocity of projectile and plate")
        .by_contact(End(|it| Some(it.arrest()?.plate_velocity_m_s))).titled("common velocity at first stop").briefly("speed at stop"),
    quantity(FinalPenetration.key(), Length, "depth of the hole at the end; of a perforated plate, where the nose has left it; of a stack, in all its plates", Source::Run(Run::shot_depth_m))
        .by_contact(End(|it| Some(it.end.penetration_m)))
        .at_least(|run| run.at_least.penetration_m).titled("final depth").short("depth").is(&[OfStack, OfHole]),
    quantity("percent_of_baseline", Number, "final depth over that of the same plate on a rigid mount, percent", Source::Run(Run::percent_of_baseline))
        .by_contact(End(|it| Some(100.0 * (it.arrest()?.penetration_m / it.baseline_m?))))
        .at_least(|run| Some(100.0 * (run.at_least.penetration_m? / run.penetration.baseline_m?)))
        .titled("% of rigid-mount depth").briefly("% rigid mount").short("% of rigid mount").absent(NO_BASELINE).is(&[OfHole, Percent]),
    quantity("baseline_penetration_m", Length, "depth of the same shot into the same plate on a rigid mount", Source::Run(|run| run.penetration.baseline_m))
        .by_contact(End(|it| it.baseline_m)).titled("depth on a rigid mount").absent(NO_BASELINE),
    result(PeakContactForce, Force, "greatest contact force while penetrating").short("contact"),
    result(MaxPlateDisplacement, Length, "greatest plate displacement")
        .by_contact(Displacement(|it, _| it.max_displacement_m))
        .at_least(|run| run.at_least.plate_displacement_m).briefly("max travel").short("displacement").absent(UNSTOPPED),
    result(Stroke, Length, "greatest displacement plus cocking distance: the space the mechanism needs behind the plate, not that of a swing back of neutral")
        .by_contact(Displacement(|it, _| Some(it.max_displacement_m? + it.start_m.abs())))
        .at_least(|run| Some(run.at_least.plate_displacement_m? - run.scene.start_m())).absent(UNSTOPPED),
    quantity(ResidualVelocity.key(), Velocity, "projectile velocity after perforation; of a stack, behind its base plate", Source::Run(Run::shot_residual_m_s)).is(&[OfPerforation, OfStack]),
    result(ExitTime, Time, "when the nose was clear of the rear face").is(&[OfPerforation]),
    result(SeparationTime, Time, "when the projectile left through the entry face"),
    result(SeparationVelocity, Velocity, "projectile velocity when it left through the entry face"),
    quantity("plate_velocity_after_m_s", Velocity, "plate velocity when projectile and plate part: as the nose is clear of the rear face, or leaves through the entry face", Source::Run(|run| run.departure.plate_velocity_m_s)).titled("plate velocity after parting").short("plate after").absent("they do not part"),
    quantity("max_plate_displacement_time_s", Time, "when the plate comes to its greatest displacement", Source::Course(Run::max_displacement_time_s)).briefly("max travel time").absent("it only comes near"),
    result(InterfaceDemand, Number, "greatest compression the fused interface carried, over its strength A S_y").titled("interface push over strength").short("push"),
    quantity(InterfaceTension.key(), Number, "greatest tension the fused interface carries, way back included, over its strength g A S_y (1e6 without a grip)", Source::Run(|run| Some(run.interface.tension_ratio?.min(UNBOUNDED_RATIO)))).titled("interface pull over strength").short("pull"),
    quantity("energy_residual", Number, "error of the energy balance, relative to the energy at the start", Source::Run(energy_residual)).is(&[OfComputation, OfStack]),
    quantity("error_estimate", Number, "relative error estimate of the final depth", Source::Run(Run::depth_error)).is(&[OfComputation, OfStack, Estimate]),
    result(StoredEnergy, Energy, "greatest energy stored in the springs"),
    quantity("yield_margin", Number, "yield strength over the greatest bending stress of the mechanism's beams", Source::Run(|run| run.mechanism.yield_margin)),
    quantity("added_inertia_kg", Mass, "mass that the mechanism adds to the plate: rotation, and the springs' own mass", Source::Run(|run| run.mechanism.added_kg)),
    quantity("spring_mass_kg", Mass, "the springs' own mass", Source::Run(|run| run.mechanism.spring_mass_kg)),
    result(RotationalEnergy, Energy, "greatest energy of the plate's rotation"),
    quantity(PeakMountForce.key(), Force, "greatest force into the mount, way back included: spring, damper and elastic stop, and what turns a geared mass; of a rigid mount, the contact force along the normal", Source::Run(peak_n))
        .by_contact(Displacement(|it, scene| mount::force_n(scene, it.max_displacement_m))).at_least(mount::min_peak_n).short("mount force"),
    quantity("mount_impulse_n_s", Impulse, "impulse into the mount along the plate's normal, up to the greatest displacement; known of model = hydrodynamic alone", Source::Course(|run| impulse_n_s(run).filter(|_| !run.series.is_empty()))),
    quantity("travel_margin", Number, "travel of a spring up to yield or the end of its law, over its greatest travel", Source::Run(travel_margin)),
    quantity("fused_stop_hit", Number, "1 where a rigid stop is hit under a fused interface, which cannot carry the blow, else 0", Source::Run(|run| envelope::hits_fused_stop(run).map(|is_hit| f64::from(u8::from(is_hit))))),
    quantity("plate_mass_kg", Mass, "mass of the plate: gamma times that of the projectile", Source::Scene(|scene| Some(scene.plate_mass_kg()))),
    quantity("least_spring_mass_kg", Mass, "least mass of the springs for the greatest energy stored, by e_spring or of coils; not known of other springs", Source::Run(|run| mount::min_spring_kg(&run.scene, run.displacements_m())))
        .by_contact(Displacement(|it, scene| mount::min_spring_kg(scene, it.displacements_m()))).is(&[CountsSprings]),
    quantity("system_mass_kg", Mass, "plate and springs: their own mass where it is known, else their least mass; a damper, a stop and the mount are not counted; springs behind a perforated plate are not sized, then there is none", Source::Run(|run| mount::system_kg(&run.scene, mount::stopped_displacements_m(run))))
        .by_contact(Displacement(|it, scene| mount::system_kg(scene, it.stopped_displacements_m(scene)))).short("system").is(&[CountsSprings]),
    quantity("areal_mass_kg_m2", ArealMass, "plate and springs over the plate's face; a damper, a stop and the mount are not counted; springs behind a perforated plate are not sized, then there is none", Source::Run(|run| mount::areal_kg_m2(&run.scene, mount::stopped_displacements_m(run))))
        .by_contact(Displacement(|it, scene| mount::areal_kg_m2(scene, it.stopped_displacements_m(scene)))).is(&[CountsSprings]),
    quantity("plate_face_m", Length, "side of the plate's square face: the plate is a block of its material", Source::Scene(|scene| scene.is_sprung().then(|| scene.plate_face_m()))),
    quantity("face_over_diameter", Number, "side of the plate's face over the projectile's diameter: 3 or more for the model to hold", Source::Scene(envelope::face_ratio)),
    quantity("thickness_over_diameter", Number, "plate thickness over projectile diameter, h/D", Source::Scene(|scene| Some(envelope::thickness_ratio(scene)))),
    quantity("nose_pressure_ratio", Number, "pressure on the nose at impact, S + c v^2, over 2 GPa of hardened steel: below 0.5 it stays rigid", Source::Scene(|scene| Some(envelope::nose_pressure_ratio(scene)))),
    quantity(LIMIT, Velocity, "ballistic limit v_bl: the least impact velocity that perforates, whatever its springs have to store", Source::Search(Search::Limit)).short("limit").is(&[OfStack]),
    quantity("limit_if_spring_survives_m_s", Velocity, "least impact velocity that perforates or that the spring does not survive, by its known mass and the range of its law: as in `compare`", Source::Search(Search::LimitIfSpringSurvives)).short("spring survives"),
    quantity(EXPECTED[0], Velocity, "ballistic limit that measurements of such shots let expect; none where no class was measured", Source::Search(Search::Expected(|it| it.limit_m_s))).short("expected").absent(NOT_MEASURED),
    quantity(EXPECTED[1], Velocity, "lower end of the band that holds 90 % of such measured limits", Source::Search(Search::Expected(|it| it.low_m_s))).short("low").absent(NOT_MEASURED),
    quantity(EXPECTED[2], Velocity, "upper end of the band that holds 90 % of such measured limits", Source::Search(Search::Expected(|it| it.high_m_s))).short("high").absent(NOT_MEASURED),
    quantity(DESIGN_LIMIT, Velocity, "limit to design for: expected_low_m_s where such shots were measured, else limit_velocity_m_s", Source::Search(Search::DesignLimit)).short("design limit").is(&[OfStack]),
    quantity("mass_efficiency", Number, "areal mass of the solid plate that just stops the same shot, over that of this armour", Source::Search(Search::MassEfficiency)).short("efficiency"),
    quantity("steps", Number, "accepted steps", Source::Run(|run| Some(run.cost.steps as f64))).is(&[OfComputation, Whole]),
    quantity("rejected", Number, "rejected steps", Source::Run(|run| Some(run.cost.rejected as f64))).is(&[OfComputation, Whole]),
    quantity("rhs_evaluations", Number, "evaluations of the equations of motion", Source::Run(|run| Some(run.cost.rhs_evaluations as f64))).is(&[OfComputation, Whole]),
];

impl Quantity {
    /// Returns `true` if the quantity has this flag.
    pub fn has(&self, what: QuantityFlag) -> bool {
        self.traits.contains(&what)
    }

    /// Returns the unit; `%` for a percentage, empty for a pure number.
    pub fn unit(&self) -> &'static str {
        if self.has(Percent) { "%" } else { self.kind.unit() }
    }

    /// Returns the unit on screens, without a prefix that depends on the value: `mm`.
    pub fn shown_unit(&self) -> &'static str {
        if self.has(Percent) { "%" } else { self.kind.shown_unit() }
    }

    /// Converts a value to the unit on screens; percentages are stored in per cent.
    pub fn in_shown_unit(&self, value: f64) -> f64 {
        let converted = units::in_unit(value, self.kind.shown_unit(), self.kind);
        converted.filter(|_| !self.has(Percent)).unwrap_or(value)
    }

    /// Returns the label without the unit: `max plate displacement`.
    pub fn title(&self) -> String {
        if self.title.is_empty() { self.key_words() } else { self.title.to_owned() }
    }

    /// Returns the label in fewer letters, for narrow places.
    pub fn brief_title(&self) -> String {
        if self.brief_title.is_empty() { self.title() } else { self.brief_title.to_owned() }
    }

    /// Returns the name in files as words, without the unit; lookups accept it: `first arrest penetration`.
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

    /// Returns the computation required for the quantity.
    pub fn needs(&self) -> Needs {
        match self.source {
            Source::Scene(_) => Needs::Scene,
            Source::Run(_) | Source::Result(_) => Needs::Run,
            Source::Course(_) => Needs::Course,
            Source::Search(_) => Needs::Limit,
        }
    }

    /// Formats a value with its unit and a number of digits: `64.27 %`, `37.98 mm`, `61.2 g`.
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

    /// Parses a value in SI or with a unit (`45mm`, `20 kN`, `1kJ`); percentages as displayed (`60` or `60 %`).
    pub fn parse(&self, text: &str) -> Result<f64, UnitError> {
        let bare = if self.unit() == "%" { text.trim().trim_end_matches('%') } else { text };
        units::parse(bare, self.kind, Bare::Si)
    }

    /// Reads a value; a bare number has the unit shown beside the field.
    pub fn parse_in(&self, text: &str, unit: &str) -> Result<f64, UnitError> {
        // A bare percentage is already in per cent.
        if self.unit() == "%" {
            self.parse(text)
        } else {
            units::parse(text, self.kind, Bare::In(unit))
        }
    }

    /// Returns the lower bound if a run ended before the value was final; `None` if it is final or unknown.
    pub fn lower_bound(&self, run: &Run) -> Option<f64> {
        // The bounds of a run apply to its first plate.
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

    /// Returns `true` if the quantity exists for the scene; a stack lacks some quantities.
    pub fn exists(&self, scene: &Scene) -> bool {
        self.has(OfStack) || !scene.is_stack()
    }

    /// Checks that the quantity exists for the scene.
    pub fn check_exists(&self, scene: &Scene) -> Result<(), QuantityError> {
        if self.exists(scene) {
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

    /// Returns the quantity that a design search uses for this one: the lower end of the band for the limit of a shot with measurements,
    /// else the quantity itself.
    pub(in crate::study) fn design_quantity(&'static self, scene: &Scene) -> &'static Self {
        let is_limit = self.name == LIMIT && Key::from_scene(scene).is_some();
        is_limit.then(|| find(DESIGN_LIMIT)).flatten().unwrap_or(self)
    }

    /// Returns the search for the quantity; `None` if it needs no search.
    pub(in crate::study) fn search(&self) -> Option<Search> {
        if let Source::Search(search) = self.source { Some(search) } else { None }
    }

    /// Returns `true` if the quantity needs the time series of a run.
    pub(in crate::study) fn needs_course(&self) -> bool {
        self.needs() == Needs::Course
    }

    /// Returns `true` if perforated designs can be compared by the quantity.
    pub(in crate::study) fn is_defined_when_perforated(&self) -> bool {
        // Quantities that do not depend on the outcome of the shot are defined, too.
        self.has(OfPerforation) || matches!(self.source, Source::Scene(_) | Source::Search(_))
    }
}

/// Returns the energy residual of the plate with the largest absolute residual.
fn energy_residual(run: &Run) -> Option<f64> {
    let residuals = run.plates().map(|run| run.ledger.residual());
    residuals.max_by(|a, b| a.abs().total_cmp(&b.abs()))
}

/// Returns the smallest ratio of limit to displacement over all springs and limits; `None` if no spring has a relevant limit.
fn travel_margin(run: &Run) -> Option<f64> {
    load::travel_margin(&run.scene, run.displacements_m()?)
}

/// Default quantities: the depth for a stack; for a single plate the depth relative to that in a rigid plate.
const OF_STACKS: &str = "final_penetration_m";
const OF_PLATES: &str = "percent_of_baseline";

/// Returns the default quantity of a study.
pub fn default_for(scene: &Scene) -> &'static str {
    if scene.is_stack() { OF_STACKS } else { OF_PLATES }
}

/// Iterates over the quantities of a run without time series, the default outputs of a sweep.
pub fn of_every_run() -> impl Iterator<Item = &'static Quantity> {
    QUANTITIES.iter().filter(|it| it.needs() <= Needs::Run)
}

/// Iterates over the quantities of a run with time series. Limit searches are made on request only.
pub fn of_runs() -> impl Iterator<Item = &'static Quantity> {
    QUANTITIES.iter().filter(|it| it.needs() < Needs::Limit)
}

/// Iterates over the quantities that describe a design, in the order of tables; without limits and quantities of the computation.
pub fn usual() -> impl Iterator<Item = &'static Quantity> {
    of_runs().filter(|it| !it.has(OfComputation))
}
