//! Report of a ballistic limit: a table with one row for each shot, and an object. SI.

use serde_json::{Value, json};

use crate::report::Remark;
use crate::report::chart::{Axis, Chart, Curve, Mark, Scale, Unit};
use crate::report::page::Page;
use crate::report::svg::Picture;
use crate::report::table::Table;
use crate::report::verdict;
use crate::study::compare::{is_held, is_spring_sized_by_shot};
use crate::study::envelope;
use crate::study::limit::residual_law::ResidualLaw;
use crate::study::limit::{
    Closures, Limit, LimitReport, RANGE_M_S, ResidualAtLimit, Shot, is_stopped_by_every_closure,
};
use crate::study::quantities::find;
use crate::study::validity;
use crate::study::verdict::{Decision, Verdict};
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::run::Warning;
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::{engineering, fixed_significant, significant, velocity};

const LAW_POINTS: usize = 400;
/// Ratio of the scene's velocity to the limit up to which the chart shows the velocity.
const OWN_IN_VIEW: f64 = 4.0;
/// Limits of a second and third hit relative to the first.
const REPEATED: &str = "second and third hit at one place: about 0.59 and 0.46 of the first limit (finite elements, Qiang 2022; no measurement)";
/// Ratio of the residual velocity just above the limit to the impact velocity, above which the plate's own motion explains it.
const CARRIED: f64 = 0.2;

/// Returns all remarks on a limit, in words.
pub fn remarks(report: &LimitReport) -> Vec<Remark> {
    let mut remarks = Vec::new();
    if let Limit::Found { stopped_at_m_s: Some(again), .. } = report.limit {
        let again = velocity(again, 4);
        let text = format!("no single limit: {again} is stopped again; the lowest is given");
        remarks.push(Remark::caution("warning", text));
    }
    remarks.extend(report.undecided().map(|text| Remark::caution("warning", text)));
    remarks.extend(report.caution().map(|text| Remark::caution("caution", text)));
    if let Some(run) = report.at_limit.as_ref().filter(|_| !report.scene.is_stack()) {
        let none = || {
            let reason = if is_held(&report.scene) {
                "stroke and mount force are not known: the outcome of the shot just below it is undecided"
            } else {
                "nothing stops plate and projectile: no stroke, no mount force"
            };
            reason.to_owned()
        };
        remarks.push(Remark::new("at the limit", load(run).unwrap_or_else(none)));
    }
    if is_spring_sized_by_shot(&report.scene) {
        let text = "by own_mass=counted each shot has a spring of its own mass; `cmra compare` keeps that of the design shot";
        remarks.push(Remark::new("spring", text));
    }
    remarks.extend(interface(report).map(|text| Remark::caution("interface", text)));
    if let Some(closure) = report.scene.closure_by_thickness() {
        let text = format!("{}, by the plate's thickness", closure.word());
        remarks.push(Remark::new("strength rule", text));
    }
    if let Some((thin, thick)) = report.jump_m_s {
        let Scene { target, projectile, .. } = &*report.scene;
        let change_m = target.nearest_change_m(projectile.tip_radius_m);
        let body_m = 2.0 * projectile.tip_radius_m;
        let bodies =
            if change_m > body_m { significant(change_m / body_m, 2) + " " } else { String::new() };
        let change = engineering(change_m, "m", 4);
        let (thin, thick) = (fixed_significant(thin, 4), velocity(thick, 4));
        let text = format!(
            "at h = {bodies}D = {change} the strength rule changes and the limit jumps from {thin} to {thick}: between these two it is not known"
        );
        remarks.push(Remark::caution("jump", text));
    }
    if let Some(closures) = &report.closures {
        remarks.push(Remark::new("by each rule", self::closures(closures)));
    }
    remarks.extend(carried(report).map(|text| Remark::new("note", text)));
    if report.lambert_jonas.is_some() {
        remarks.push(Remark::new("laws", "residual velocity v_r = a (v^p - v_bl^p)^(1/p)"));
    }
    if let Some(law) = report.recht_ipson {
        let (a, misfit) = (fixed_significant(law.a, 4), significant(law.misfit_m_s, 2));
        let text = format!("a {a}, p 2, same v_bl; RMS error {misfit} m/s");
        remarks.push(Remark::new(FittedLaw::RechtIpson.name(), text));
    }
    if let Some(law) = report.lambert_jonas {
        let (a, p) = (fixed_significant(law.a, 4), fixed_significant(law.p, 4));
        let (limit, misfit) = (velocity(law.limit_m_s, 4), significant(law.misfit_m_s, 2));
        let text = format!("a {a}, p {p}, v_bl {limit}; RMS error {misfit} m/s");
        remarks.push(Remark::new(FittedLaw::LambertJonas.name(), text));
    }
    remarks
}

/// Describes where the fused interface is overloaded below the limit; `None` if it is not just below it.
fn interface(report: &LimitReport) -> Option<String> {
    let overloads = |run: &&Run| envelope::is_overloaded(run);
    let Some(holds_m_s) = report.interface_holds_m_s else {
        return report.at_limit.as_ref().filter(overloads).map(|_| {
            "fused, carries more than its strength just below the limit and in the slowest shots: take interface=plastic".to_owned()
        });
    };
    let holds = if holds_m_s < RANGE_M_S.0 {
        "at no velocity".to_owned()
    } else {
        format!("up to {}", velocity(holds_m_s, 4))
    };
    Some(format!(
        "fused, carries no more than its strength {holds}; beyond, take interface=plastic"
    ))
}

/// Warns of a limit that ignores the strength of its mechanism; `None` if there is no such mechanism.
pub fn taken_to_hold(report: &LimitReport) -> Option<Remark> {
    let text = "taken to hold whatever it stores; `cmra compare` gives the limit if the spring must survive";
    let is_so =
        report.limit.velocity_m_s().is_some() && !Mechanism::from_scene(&report.scene).is_absent();
    is_so.then(|| Remark::new("mechanism", text))
}

/// Explains a residual velocity that starts far above zero, which the laws of the curve do not describe; `None` for other limits.
fn carried(report: &LimitReport) -> Option<String> {
    let limit_m_s = report.limit.velocity_m_s()?;
    let ResidualAtLimit { velocity_m_s, is_settled } = report.residual_at_limit?;
    let size = if is_settled {
        format!("{} m/s", fixed_significant(velocity_m_s.abs(), 4))
    } else {
        "a velocity that depends on how close to the limit it is".to_owned()
    };
    if velocity_m_s < 0.0 {
        Some(format!(
            "Just above the limit the shot rebounds: it is through the plate, which carries it back at {size}."
        ))
    } else {
        (velocity_m_s > CARRIED * limit_m_s).then(|| {
            format!("Just above the limit the residual velocity is {size}: the plate moves along with the projectile.")
        })
    }
}

/// Describes the load of the mechanism at the limit; `None` if unknown.
fn load(run: &Run) -> Option<String> {
    let part = |label: &str, name| {
        let quantity = find(name)?;
        Some(format!("{label} {}", quantity.show(quantity.value(run)?, 4)))
    };
    let force = part("mount force", "peak_mount_force_n");
    let is_hit = force.is_none() && Mechanism::from_scene(&run.scene).rigid_stop().is_some();
    let parts = [part("stroke", "stroke_m"), part("stored energy", "stored_energy_j"), force];
    let mut known: Vec<String> = parts.into_iter().flatten().collect();
    if is_hit && !known.is_empty() {
        known.push("mount force unknown (rigid stop)".to_owned());
    }
    (!known.is_empty()).then(|| known.join(", "))
}

/// Returns warnings about the rows, from the shot at the limit; about the scene's own shot if there is no limit.
pub fn warnings(report: &LimitReport) -> Vec<Warning> {
    let at_limit = report.at_limit.as_ref().map(envelope::warnings);
    at_limit.unwrap_or_else(|| validity::of_scene(&report.scene))
}

/// Explains a limit, and its decrease after a hit at the same place.
pub fn meaning(report: &LimitReport) -> Vec<Remark> {
    let is_found = report.limit.velocity_m_s().is_some();
    let remarks = [Remark::new("meaning", verdict::V50), Remark::new("repeated hits", REPEATED)];
    remarks.into_iter().filter(|_| is_found).collect()
}

/// Answers "does it stop this shot?" in one line, in versions from the longest to the shortest.
pub fn headlines(scene: &Scene, limit: Limit, condition: &str) -> Vec<String> {
    let own_m_s = scene.projectile.velocity_m_s;
    let own = format!("{} m/s", significant(own_m_s, 4));
    let Some(velocity_m_s) = limit.velocity_m_s() else {
        return limit.absence().into_iter().collect();
    };
    let verdict = Verdict::with_limit(scene, Some(velocity_m_s));
    let law = format!("{} m/s", fixed_significant(velocity_m_s, 6));
    if let Some(expected) = &verdict.expected {
        let digits = |value: f64| fixed_significant(value, 4);
        let [low, limit, high] =
            [expected.low_m_s, expected.limit_m_s, expected.high_m_s].map(digits);
        let own = match verdict.decision {
            Decision::Stops => format!("{own} is stopped"),
            Decision::Perforates => format!("{own} perforates"),
            Decision::Open | Decision::NotMeasured => format!("{own} is open"),
        };
        let answer = format!("{own}: expected limit {limit} ({low} to {high}) m/s");
        return vec![format!("{answer}; law {law}"), answer];
    }
    let margin = 100.0 * (velocity_m_s / own_m_s - 1.0);
    let answer = match limit.outcome_at(own_m_s) {
        Some(Outcome::Perforated) if envelope::is_law_low(scene) => {
            format!("the law, low here, says nothing of {own}")
        }
        Some(Outcome::Perforated) => format!("{own} perforates by the law"),
        Some(_) if !is_stopped_by_every_closure(scene) => {
            format!("{own} is stopped by this rule, not by the lowest")
        }
        Some(_) => format!("{own} is stopped by the law"),
        None if margin < 0.0 => own,
        None => format!("{own} is undecided"),
    };
    let condition = if margin < 0.0 { "" } else { condition };
    let full = format!("{answer}, not measured: v_bl {law}, margin {margin:+.1} %");
    let short = format!("{answer}: v_bl {law}, {margin:+.1} %");
    vec![full.clone() + condition, full, short]
}

/// Returns the verdict on the scene's shot as a sentence.
pub fn answer(report: &LimitReport) -> String {
    let own_m_s = report.scene.projectile.velocity_m_s;
    let by_law = report.limit.outcome_at(own_m_s);
    verdict::sentence(&report.scene, &report.verdict(), by_law)
}

/// Describes the limits by each closure.
fn closures(closures: &Closures) -> String {
    let shown = |value: Option<f64>, drag: f64| {
        let limit = value.map_or_else(|| "none".to_owned(), |it| velocity(it, 4));
        format!("(C_d = {}) {limit}", significant(drag, 4))
    };
    let each = format!(
        "2 Y with dishing {}, spherical cavity without dishing {}, cylindrical cavity {}",
        shown(closures.double_yield_m_s, closures.double_yield_drag),
        shown(closures.cavity_m_s, closures.cavity_drag),
        shown(closures.cylindrical_m_s, closures.cavity_drag)
    );
    closures.band_m_s().map_or_else(
        || each.clone(),
        |(low, high)| format!("{} to {}: {each}", fixed_significant(low, 4), velocity(high, 4)),
    )
}

/// Returns the table of the shots, sorted by velocity, with the values of each fitted law and the limit.
pub fn shots<'c>(name: &'c str, report: &'c LimitReport) -> Table<'c, &'c Shot> {
    let limit_m_s = report.limit.velocity_m_s();
    Table::new(&report.shots)
        .field("scene", move |_| name)
        .field("impact_velocity_m_s", |shot| shot.impact_m_s)
        .field("outcome", |shot| shot.outcome.word())
        .field("residual_velocity_m_s", |shot| shot.residual_m_s)
        .field("recht_ipson_m_s", |it| Some(report.recht_ipson?.residual_m_s(it.impact_m_s)))
        .field("lambert_jonas_m_s", |it| Some(report.lambert_jonas?.residual_m_s(it.impact_m_s)))
        .field("limit_velocity_m_s", move |_| limit_m_s)
}

/// Returns the whole report as an object; null for values that do not exist.
pub fn json(name: &str, report: &LimitReport) -> Value {
    let (basis, stopped) = match report.limit {
        Limit::Found { basis, stopped_at_m_s, .. } => (Some(basis.words()), stopped_at_m_s),
        Limit::Between { .. }
        | Limit::Never
        | Limit::Always
        | Limit::NotModelled
        | Limit::Unknown => (None, None),
    };
    let at_limit = |name| find(name)?.value(report.at_limit.as_ref()?);
    // A rebounding shot has no residual velocity.
    let residual = report.residual_at_limit.filter(|it| it.is_settled && it.velocity_m_s >= 0.0);
    let closures = report.closures.map(|closures| {
        json!({
            "double_yield_dishing_m_s": closures.double_yield_m_s,
            "double_yield_drag_coefficient": closures.double_yield_drag,
            "cavity_no_dishing_m_s": closures.cavity_m_s,
            "cavity_drag_coefficient": closures.cavity_drag,
            "cylindrical_no_dishing_m_s": closures.cylindrical_m_s,
        })
    });
    let own = ["impact_velocity_m_s", "outcome", "residual_velocity_m_s"];
    let mut object = json!({ "scene": name });
    for (key, value) in verdict::object(&report.verdict()) {
        object[key] = value;
    }
    let rest = json!({
        "interface": report.scene.interface.law.word(),
        "criterion": report.scene.target.criterion.word(),
        "basis": basis,
        "no_limit": report.limit.absence(),
        "stopped_again_at_m_s": stopped,
        "undecided_at_m_s": report.undecided_at_m_s(),
        "impact_velocity_m_s": report.scene.projectile.velocity_m_s,
        "interface_holds_m_s": report.interface_holds_m_s,
        "residual_at_limit_m_s": residual.map(|it| it.velocity_m_s),
        "margin": report.margin(),
        "caution": report.caution(),
        "stroke_at_limit_m": at_limit("stroke_m"),
        "stored_energy_at_limit_j": at_limit("stored_energy_j"),
        "peak_mount_force_at_limit_n": at_limit("peak_mount_force_n"),
        "closure": report.scene.closure().word(),
        "closures": closures,
        "jump_m_s": report.jump_m_s.map(|(thin, thick)| [thin, thick]),
        "recht_ipson": report.recht_ipson,
        "lambert_jonas": report.lambert_jonas,
        "shots": shots(name, report).objects(|key| own.contains(&key)),
    });
    if let (Some(object), Value::Object(rest)) = (object.as_object_mut(), rest) {
        object.extend(rest);
    }
    object
}

enumeration! {
    /// Law that is fitted to residual velocities.
    pub enum FittedLaw in FittedLawRow {
        /// Name of the law.
        name: &'static str,
        /// Initials, for a narrow chart.
        initials: &'static str,
    }
    /// Exponent 2, the limit as found.
    RechtIpson { name: "Recht-Ipson", initials: "R-I" }
    /// Exponent and limit fitted, too.
    LambertJonas { name: "Lambert-Jonas", initials: "L-J" }
}

/// Returns the chart of residual over impact velocity, with a mark at the scene's own velocity and the laws under these names; `None` if no
/// shot perforates.
pub fn residual(
    report: &LimitReport,
    own_m_s: f64,
    name: fn(FittedLaw) -> &'static str,
) -> Option<Chart<'static>> {
    let limit = report.limit.velocity_m_s();
    let impacts = report.shots.iter().map(|shot| shot.impact_m_s);
    let own = limit.filter(|limit| own_m_s < OWN_IN_VIEW * limit).map(|_| own_m_s);
    // Without a limit the shots cover several decades.
    let scale = if limit.is_some() { Scale::Linear } else { Scale::Log10 };
    let x = Axis::over("impact velocity", "m/s", scale, impacts.chain(own))?;
    let residuals = report.shots.iter().filter_map(|shot| shot.residual_m_s);
    let y = Axis::over("residual velocity", "m/s", Scale::Linear, residuals)?;
    let unit = || Unit::new("m/s");
    let (x, y) = (x.unit(unit()), y.with_zero().padded(0.04).unit(unit()));
    // A law is undefined below its limit.
    let law = |law: Option<ResidualLaw>| {
        let Some(law) = law else { return Vec::new() };
        let step = x.view.span() / LAW_POINTS as f64;
        let at = |i: usize| x.view.lo() + step * i as f64;
        let beyond = (0..=LAW_POINTS).map(at).filter(|v| *v > law.limit_m_s);
        std::iter::once(law.limit_m_s).chain(beyond).map(|v| (v, law.residual_m_s(v))).collect()
    };
    let shots = |marker, label, outcomes: &[Outcome]| {
        let shots = report.shots.iter().filter(|shot| outcomes.contains(&shot.outcome));
        let places = shots.map(|shot| (shot.impact_m_s, shot.residual_m_s.unwrap_or(0.0)));
        Curve::points(marker, label, places)
    };
    let curves = [
        Curve::new('+', name(FittedLaw::RechtIpson), law(report.recht_ipson)).colour(1),
        Curve::new('x', name(FittedLaw::LambertJonas), law(report.lambert_jonas)).colour(2),
        shots('o', "through", &[Outcome::Perforated]).colour(3),
        shots('s', "stopped", &[Outcome::Arrested, Outcome::Separated]).colour(4),
        shots('m', "moving", &[Outcome::Moving]).colour(4),
        shots('d', "not measured", &[Outcome::Unmeasured]).colour(3),
    ];
    let curves = curves.into_iter().filter(|curve| !curve.points.is_empty());
    let limit = limit.map(|at| Mark::new(at, "ballistic limit").tag("v_bl"));
    let own = x.view.contains(own_m_s).then(|| Mark::new(own_m_s, "scene"));
    Some(Chart {
        marks: limit.into_iter().chain(own).collect(),
        ..Chart::new("residual velocity", x, y, curves.collect())
    })
}

/// Size of the chart in text.
const SIZE: (u16, u16) = (80, 18);
/// Column of a text beside its label.
const LABEL: usize = 16;

/// Returns the report: the answer, the curve of residual velocity, and remarks.
pub fn page(title: &str, report: &LimitReport) -> Page {
    let mut page = Page::new(format!("{title}: ballistic limit"));
    page.space();
    answers(&mut page, report);
    page.space();
    if let Some(chart) = residual(report, report.scene.projectile.velocity_m_s, FittedLaw::name) {
        page.picture(Picture::Chart(chart), SIZE);
    }
    page.space();
    let all = remarks(report).into_iter().chain(taken_to_hold(report)).chain(meaning(report));
    page.remarks(all, LABEL);
    page
}

/// Appends verdict, limits, criterion and margin.
pub fn answers(page: &mut Page, report: &LimitReport) {
    let own = report.scene.projectile.velocity_m_s;
    page.fact("verdict", LABEL, answer(report));
    let expected = report.verdict().expected;
    let label = if expected.is_some() { "law alone" } else { "limit velocity" };
    if let Some(expected) = expected {
        page.fact("expected limit", LABEL, expected.words());
    }
    match report.limit {
        Limit::Found { velocity_m_s, basis, .. } => {
            let text = format!("{}, {}", velocity(velocity_m_s, 6), basis.words());
            page.fact(label, LABEL, text);
        }
        Limit::Between { .. }
        | Limit::Never
        | Limit::Always
        | Limit::NotModelled
        | Limit::Unknown => {
            page.line(report.limit.absence().unwrap_or_default());
        }
    }
    page.fact("criterion", LABEL, report.scene.target.criterion.label());
    if let Some(margin) = report.margin() {
        let (percent, own) = (100.0 * margin, velocity(own, 6));
        page.fact("margin", LABEL, format!("{percent:+.1} % relative to the scene's {own}"));
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::study::context::{Context, never_cancel};
    use crate::study::limit;
    use crate::study::plain_run;
    use cmra_engine::model::variables::changed_free_plate;

    /// Residual velocities just above the limit. A free plate has half of the limit, 347.708 m/s. The second value is from two independent
    /// integrations at `v_bl (1 + 1e-9)`.
    #[test]
    fn valid_the_residual_velocity_just_above_the_limit_is_that_of_its_shot() {
        for (pairs, said) in [
            ("gamma=1", Some("173.9 m/s")),
            ("k=1e5", Some("137.2 m/s")),
            ("k=1e6", None),
            ("k=1e5 interface=plastic", Some("the shot rebounds")),
        ] {
            let scene = Arc::new(changed_free_plate(pairs).unwrap());
            let report = limit::find(&scene, &mut Context::new(1, &mut never_cancel)).unwrap();
            let words: Vec<_> = remarks(&report).into_iter().map(|it| it.text).collect();
            let note = words.iter().find(|it| it.contains("Just above the limit"));
            assert_eq!(note.is_some(), said.is_some(), "{pairs}: {words:?}");
            assert!(said.is_none_or(|said| note.unwrap().contains(said)), "{note:?}");
        }
    }

    /// A spring holds it, whether or not the run says how far the plate goes.
    #[test]
    fn an_undecided_shot_at_the_limit_is_not_called_unstopped() {
        for (pairs, said) in [("k=1e5 horizon=1us", "undecided"), ("k=0", "nothing stops")] {
            let scene = Arc::new(changed_free_plate(pairs).unwrap());
            let found = limit::find(&scene, &mut Context::new(1, &mut never_cancel)).unwrap();
            let report = LimitReport { at_limit: Some(plain_run(&scene).unwrap()), ..found };
            let remarks = remarks(&report);
            let at_limit = remarks.iter().find(|it| it.about == "at the limit").unwrap();
            assert!(at_limit.text.contains(said), "{pairs}: {}", at_limit.text);
        }
    }
}
