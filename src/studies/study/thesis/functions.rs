//! The functions that expressions of the claims may call: arithmetic, properties of curves, closed forms, the screening matrix.

use crate::model::design::{self, Rod};
use crate::model::scene::{Beam, Spring, SpringKind, Wire};
use crate::numerics::larger;
use crate::numerics::statistics::sorted_by;
use crate::study::screening::{CONCEPTS, WEIGHTS_PERCENT, rank, ranking};
use crate::study::thesis::elastica;
use crate::study::thesis::shape::{
    at, curvature, edge, falls, flattens, greatest, least, range, rises, slope,
};
use crate::study::thesis::text;
use crate::study::thesis::value::{Point, Value, through_lists};

#[derive(Debug)]
pub(super) struct Function {
    /// Its name in the claims.
    pub name: &'static str,
    /// How many arguments it takes.
    pub arguments: usize,
    apply: Apply,
}

/// The arguments of a function.
#[derive(Clone, Copy, Debug)]
enum Apply {
    /// Numbers; lists are gone through.
    Numbers(fn(&[f64]) -> Value),
    /// The points of a curve or of a list, and numbers; lists of curves are gone through.
    Points(fn(&[Point], &[f64]) -> Value),
    /// The arguments as they are.
    Whole(fn(&[Value]) -> Result<Value, String>),
}

/// A row for each function: the kind of its arguments, its name, how many it takes, and what it does.
macro_rules! functions {
    ($($kind:ident $name:literal $arguments:literal |$($own:pat_param),+| $it:expr;)*) => {
        pub(super) static FUNCTIONS: &[Function] = &[$(Function {
            name: $name,
            arguments: $arguments,
            apply: Apply::$kind(|$($own),+| $it.into()),
        }),*];
    };
}

functions! {
    Numbers "abs" 1 |it| it[0].abs();
    Numbers "sqrt" 1 |it| it[0].sqrt();
    Numbers "ln" 1 |it| it[0].ln();
    Numbers "exp" 1 |it| it[0].exp();
    Numbers "cos" 1 |it| it[0].cos();
    Numbers "acos" 1 |it| it[0].acos();
    Numbers "finite" 1 |it| it[0].is_finite();
    // A value, the stated one, and their greatest relative distance.
    Numbers "near" 3 |it| (it[0] / it[1] - 1.0).abs() <= it[2];
    // A condition, and the values where it holds and where it does not.
    Whole "choose" 3 |it| Ok(it[if it[0].holds()? { 1 } else { 2 }].clone());
    // The first of a list for which a condition holds.
    Whole "where" 2 |it| first_where(it);
    // Every product of a value of one list and one of another.
    Whole "outer" 2 |it| outer(it);
    Points "length" 1 |points, _| points.len() as f64;
    // Of conditions: how many hold.
    Points "sum" 1 |points, _| points.iter().map(|it| it.1).sum::<f64>();
    Points "mean" 1 |points, _| points.iter().map(|it| it.1).sum::<f64>() / points.len() as f64;
    Points "max" 1 |points, _| greatest(points);
    Points "min" 1 |points, _| least(points);
    // Where a curve is greatest.
    Points "argmax" 1 |points, _| {
        points.iter().find(|it| it.1 >= greatest(points)).map_or(f64::NAN, |it| it.0)
    };
    Points "first" 1 |points, _| points.first().map_or(f64::NAN, |it| it.1);
    Points "last" 1 |points, _| points.last().map_or(f64::NAN, |it| it.1);
    Points "range" 1 |points, _| range(points);
    // The value at a place, on the straight line between the points around it.
    Points "at" 2 |points, numbers| at(points, numbers[0]);
    // The slope of the least-squares line.
    Points "slope" 1 |points, _| slope(points);
    // How far a curve is from the straight line through its ends, relative to its range.
    Points "curvature" 1 |points, _| curvature(points);
    // Where a falling curve crosses the middle between its ends.
    Points "edge" 1 |points, _| edge(points).unwrap_or(f64::NAN);
    // The greatest step between neighbours.
    Points "step" 1 |points, _| {
        points.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs()).fold(0.0, larger)
    };
    // Where a curve is no greater than a number for the first time.
    Points "first_below" 2 |points, numbers| {
        points.iter().find(|it| it.1 <= numbers[0]).map_or(f64::NAN, |it| it.0)
    };
    Points "rises" 1 |points, _| rises(points);
    Points "falls" 1 |points, _| falls(points);
    Points "flattens" 1 |points, _| flattens(points);
    // Velocities after an elastic collision at 100 m/s with a plate of some masses of the projectile.
    Numbers "elastic_projectile" 1 |it| design::elastic(1.0, 100.0, it[0], 0.0)[0];
    Numbers "elastic_plate" 1 |it| design::elastic(1.0, 100.0, it[0], 0.0)[1];
    // Tate's angle, degrees, of a rod as thick as the thesis's projectile: density, strength, velocity, length.
    Numbers "ricochet_angle" 4 |it| {
        let rod = Rod {
            density_kg_m3: it[0],
            strength_pa: it[1],
            velocity_m_s: it[2],
            length_m: it[3],
            diameter_m: 0.0127,
        };
        rod.critical_obliquity_deg(2710.0)
    };
    // Mass, velocity and radius of the projectile, density of the target, parameter c_t.
    Numbers "stone_depth" 5 |it| design::stone_depth_m(it[0], it[1], it[2], it[3], it[4]);
    // The least mass of a coil of spring steel that stores some energy, kg.
    Numbers "coil_mass" 1 |it| design::coil_spring_mass_kg(it[0], &Wire::default());
    // The beam of Table 9.3.
    Numbers "beam_torsional_stiffness" 0 |_| Beam::default().torsional_n_m();
    Numbers "beam_tip_mass" 0 |_| {
        let spring = Spring { kind: SpringKind::Cantilever, ..Spring::default() };
        spring.moving_part() * spring.beam.mass_kg()
    };
    // Its tip load over the elastic line's, at a displacement over its length.
    Numbers "beam_over_elastica" 1 |it| {
        let beam = Beam::default();
        let rigidity = beam.modulus_pa * beam.width_m * beam.height_m.powi(3) / 12.0;
        let load =
            beam.link(1.0).force(it[0] * beam.length_m) * beam.length_m * beam.length_m / rigidity;
        load / elastica::load(it[0])
    };
    // Table 7.1 as printed, and computed by some weights.
    Whole "screening_weights" 0 |_| Ok(Value::numbers(WEIGHTS_PERCENT));
    Whole "printed_totals" 0 |_| Ok(Value::numbers(CONCEPTS.iter().map(|it| it.total)));
    Whole "printed_ranks" 0 |_| Ok(Value::numbers(CONCEPTS.iter().map(|it| it.rank as f64)));
    Whole "screening_totals" 1 |it| {
        Ok(Value::numbers(rank(&weights(&it[0])?).iter().map(|place| place.total)))
    };
    Whole "screening_ranks" 1 |it| {
        Ok(Value::numbers(rank(&weights(&it[0])?).iter().map(|place| place.rank as f64)))
    };
    // The concepts' names, the first rank first.
    Whole "screening_order" 1 |it| {
        let places = ranking(&weights(&it[0])?);
        let names = places.iter().map(|place| Value::from(CONCEPTS[place.concept].name));
        Ok(Value::List(names.collect()))
    };
    // The concepts with a percentage each, the least first.
    Whole "concepts_by" 1 |it| {
        let points = it[0].points()?;
        let values = points.iter().zip(&CONCEPTS).map(|(point, own)| (point.1, own.name));
        let order = sorted_by(values.collect(), |own: &(f64, &str)| own.0);
        let shown: Vec<String> =
            order.iter().map(|(value, name)| format!("{name} {}", text::percent(*value))).collect();
        Ok(Value::Text(shown.join(", ")))
    };
}

impl Function {
    /// Its value for these arguments.
    pub(super) fn of(&self, arguments: &[Value]) -> Result<Value, String> {
        let value = match self.apply {
            Apply::Numbers(it) => through_lists(arguments, &|own| Ok(it(&numbers(own)?))),
            Apply::Points(it) => through_curves(arguments, it),
            Apply::Whole(it) => it(arguments),
        };
        value.map_err(|error| format!("{}: {error}", self.name))
    }
}

fn numbers(values: &[Value]) -> Result<Vec<f64>, String> {
    values.iter().map(Value::number).collect()
}

/// Calls a function of points for a curve or a list, or for each curve of a list of curves.
fn through_curves(
    arguments: &[Value],
    each: fn(&[Point], &[f64]) -> Value,
) -> Result<Value, String> {
    let (series, rest) = arguments.split_first().ok_or("a curve is missing")?;
    if let (true, Value::List(list)) = (series.is_nested(), series) {
        let own =
            |series: &Value| through_curves(&[std::slice::from_ref(series), rest].concat(), each);
        return Ok(Value::List(list.iter().map(own).collect::<Result<_, _>>()?));
    }
    Ok(each(&series.points()?, &numbers(rest)?))
}

fn first_where(arguments: &[Value]) -> Result<Value, String> {
    let (values, holds) = (arguments[0].points()?, arguments[1].points()?);
    let found = values.iter().zip(&holds).find(|(_, holds)| holds.1 > 0.0);
    Ok(found.map(|(value, _)| value.1).into())
}

fn outer(arguments: &[Value]) -> Result<Value, String> {
    let (left, right) = (arguments[0].points()?, arguments[1].points()?);
    Ok(Value::numbers(left.iter().flat_map(|a| right.iter().map(|b| a.1 * b.1))))
}

/// Seven weights, percent.
fn weights(list: &Value) -> Result<[f64; 7], String> {
    let values: Vec<f64> = list.points()?.iter().map(|point| point.1).collect();
    values.try_into().map_err(|all: Vec<f64>| format!("Table 7.1 has 7 weights, not {}", all.len()))
}
