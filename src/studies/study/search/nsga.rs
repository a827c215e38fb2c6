//! NSGA-II: the Pareto front of any function of the unit cube, with constraints; with one objective a genetic search for its least
//! value.
//!
//! K. Deb, A. Pratap, S. Agarwal and T. Meyarivan, *IEEE Transactions on Evolutionary Computation* 6 (2002) 182-197: ranks by
//! constrained domination, crowding distance, binary tournaments. Children by simulated binary crossover (K. Deb and R. B. Agrawal,
//! *Complex Systems* 9 (1995) 115-148) and polynomial mutation, both bounded. Written here because the crates there are for it bring
//! some ninety others, several of them twice, and cannot be cancelled.

use crate::numerics::random::Random;
use crate::numerics::statistics::ascending;

/// Distribution index of the crossover, and how often it happens.
const ETA_CROSS: f64 = 15.0;
const CROSSED: f64 = 0.9;
/// Distribution index of the mutation.
const ETA_MUTATE: f64 = 20.0;

/// The result of a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The objectives, all to be made small.
    pub objectives: Vec<f64>,
    /// By how much constraints are violated, together; 0: not at all; infinite where there is no value.
    pub violation: f64,
}

impl Judged {
    /// Whether it keeps every constraint.
    pub fn is_feasible(&self) -> bool {
        self.violation == 0.0
    }

    /// Constrained domination: feasible before infeasible, then by the violation, then no worse in any objective and better in
    /// one.
    pub fn dominates(&self, other: &Self) -> bool {
        if !self.is_feasible() || !other.is_feasible() {
            return self.violation < other.violation;
        }
        let mut pairs = self.objectives.iter().zip(&other.objectives);
        let no_worse = pairs.clone().all(|(own, others)| own <= others);
        no_worse && pairs.any(|(own, others)| own < others)
    }
}

/// A point and what it comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct Individual<T> {
    /// Where, 0 to 1 along every input.
    pub shares: Vec<f64>,
    /// Its result.
    pub judged: Judged,
    /// What else is known of it.
    pub found: T,
}

/// How much is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EvolutionOptions {
    /// Points of a generation, >= 4 and even.
    pub population: usize,
    /// Generations after the first.
    pub generations: usize,
    /// Seed: the same gives the same digits.
    pub seed: u64,
}

impl EvolutionOptions {
    /// Evaluations in all.
    pub fn evaluations(self) -> usize {
        self.population * (self.generations + 1)
    }
}

/// The function, many points at once; `None` when it was stopped.
pub type Function<'a, T> = &'a mut dyn FnMut(&[Vec<f64>]) -> Option<Vec<(Judged, T)>>;

/// Told every generation: how many there have been, and the points that are there.
pub type Observer<'a, T> = &'a mut dyn FnMut(usize, &[Individual<T>]);

/// The last generation, the best first; what there was of it when the function was stopped. `starts` are points of the first
/// generation, the others a Latin hypercube.
pub fn evolve<T>(
    inputs: usize,
    starts: &[Vec<f64>],
    effort: EvolutionOptions,
    function: Function<'_, T>,
    observe: Observer<'_, T>,
) -> Vec<Individual<T>> {
    let mut random = Random::new(effort.seed);
    let mut first: Vec<Vec<f64>> = starts.iter().take(effort.population / 2).cloned().collect();
    let rest = effort.population - first.len();
    first.extend(hypercube(inputs, rest, &mut random));
    let Some(judged) = function(&first) else { return Vec::new() };
    let mut people = join(first, judged);
    let mut places = rank(&people);
    observe(0, &people);
    for generation in 1..=effort.generations {
        let children: Vec<Vec<f64>> = (0..effort.population / 2)
            .flat_map(|_| {
                let (a, b) = (tournament(&places, &mut random), tournament(&places, &mut random));
                let mut pair = cross(&people[a].shares, &people[b].shares, &mut random);
                for child in &mut pair {
                    mutate(child, &mut random);
                }
                pair
            })
            .collect();
        let Some(judged) = function(&children) else { break };
        people.extend(join(children, judged));
        people = survivors(people, effort.population);
        places = rank(&people);
        observe(generation, &people);
    }
    survivors(people, effort.population)
}

/// The feasible points that no other dominates, each once.
pub fn front<T: Clone>(people: &[Individual<T>]) -> Vec<Individual<T>> {
    let mut best: Vec<Individual<T>> = Vec::new();
    for one in people.iter().filter(|one| one.judged.is_feasible()) {
        let dominated = people.iter().any(|other| other.judged.dominates(&one.judged));
        let known = best.iter().any(|other| other.judged.objectives == one.judged.objectives);
        if !dominated && !known {
            best.push(one.clone());
        }
    }
    best
}

fn join<T>(points: Vec<Vec<f64>>, judged: Vec<(Judged, T)>) -> Vec<Individual<T>> {
    let pairs = points.into_iter().zip(judged);
    pairs.map(|(shares, (judged, found))| Individual { shares, judged, found }).collect()
}

/// As many points as slices of every input, one in each (`McKay`, Beckman and Conover 1979).
fn hypercube(inputs: usize, points: usize, random: &mut Random) -> Vec<Vec<f64>> {
    let mut all = vec![vec![0.0; inputs]; points];
    for input in 0..inputs {
        let mut slices: Vec<usize> = (0..points).collect();
        for last in (1..points).rev() {
            slices.swap(last, random.below(last + 1));
        }
        for (point, slice) in all.iter_mut().zip(slices) {
            point[input] = (slice as f64 + random.unit()) / points as f64;
        }
    }
    all
}

/// A point's front, 0 the best, and its crowding distance there.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    front: usize,
    crowding: f64,
}

/// The place of every point: the fast non-dominated sort, then crowding distances front by front.
fn rank<T>(people: &[Individual<T>]) -> Vec<Place> {
    let count = people.len();
    let mut beats = vec![Vec::new(); count];
    let mut dominated_by = vec![0usize; count];
    for a in 0..count {
        for b in a + 1..count {
            let (one, other) = (&people[a].judged, &people[b].judged);
            if one.dominates(other) {
                beats[a].push(b);
                dominated_by[b] += 1;
            } else if other.dominates(one) {
                beats[b].push(a);
                dominated_by[a] += 1;
            }
        }
    }
    let mut places = vec![Place { front: 0, crowding: 0.0 }; count];
    let mut current: Vec<usize> = (0..count).filter(|at| dominated_by[*at] == 0).collect();
    let mut front = 0;
    while !current.is_empty() {
        for (at, crowding) in current.iter().zip(crowding(people, &current)) {
            places[*at] = Place { front, crowding };
        }
        let mut next = Vec::new();
        for at in &current {
            for other in &beats[*at] {
                dominated_by[*other] -= 1;
                if dominated_by[*other] == 0 {
                    next.push(*other);
                }
            }
        }
        current = next;
        front += 1;
    }
    places
}

/// For each member, the sides of the box between its neighbours, each over the whole width; infinite at the ends.
fn crowding<T>(people: &[Individual<T>], members: &[usize]) -> Vec<f64> {
    let mut distance = vec![0.0; members.len()];
    let objectives = members.first().map_or(0, |at| people[*at].judged.objectives.len());
    for objective in 0..objectives {
        let value = |member: usize| people[members[member]].judged.objectives[objective];
        let order = ascending(&(0..members.len()).map(value).collect::<Vec<f64>>());
        let (Some(first), Some(last)) = (order.first(), order.last()) else { continue };
        let width = value(*last) - value(*first);
        (distance[*first], distance[*last]) = (f64::INFINITY, f64::INFINITY);
        // Infinite where a point has no value, zero where all are alike: neither distinguishes neighbours.
        if !(width > 0.0 && width.is_finite()) {
            continue;
        }
        for three in order.windows(3) {
            distance[three[1]] += (value(three[2]) - value(three[0])) / width;
        }
    }
    distance
}

/// The better of two at random: by front, then by crowding.
fn tournament(places: &[Place], random: &mut Random) -> usize {
    let (a, b) = (random.below(places.len()), random.below(places.len()));
    if is_better(&places[b], &places[a]) { b } else { a }
}

fn is_better(one: &Place, other: &Place) -> bool {
    one.front < other.front || (one.front == other.front && one.crowding > other.crowding)
}

/// The best n, the best first.
fn survivors<T>(people: Vec<Individual<T>>, count: usize) -> Vec<Individual<T>> {
    let places = rank(&people);
    let mut order: Vec<usize> = (0..people.len()).collect();
    order.sort_by(|a, b| {
        let (a, b) = (&places[*a], &places[*b]);
        a.front.cmp(&b.front).then(b.crowding.total_cmp(&a.crowding))
    });
    order.truncate(count);
    let mut people: Vec<Option<Individual<T>>> = people.into_iter().map(Some).collect();
    order.into_iter().filter_map(|at| people[at].take()).collect()
}

/// Two children between and about two parents.
fn cross(a: &[f64], b: &[f64], random: &mut Random) -> [Vec<f64>; 2] {
    let mut children = [a.to_vec(), b.to_vec()];
    if random.unit() >= CROSSED {
        return children;
    }
    for input in 0..a.len() {
        if random.unit() >= 0.5 || (a[input] - b[input]).abs() < 1e-14 {
            continue;
        }
        let (low, high) =
            if a[input] < b[input] { (a[input], b[input]) } else { (b[input], a[input]) };
        let throw = random.unit();
        // The spread of a child on the side with so much room.
        let spread = |room: f64| {
            let beta = 1.0 + 2.0 * room / (high - low);
            let alpha = 2.0 - beta.powf(-(ETA_CROSS + 1.0));
            let base =
                if throw <= 1.0 / alpha { throw * alpha } else { 1.0 / (2.0 - throw * alpha) };
            base.powf(1.0 / (ETA_CROSS + 1.0))
        };
        let below = 0.5 * (low + high - spread(low) * (high - low));
        let above = 0.5 * (low + high + spread(1.0 - high) * (high - low));
        let turned = random.unit() < 0.5;
        let (one, other) = if turned { (above, below) } else { (below, above) };
        children[0][input] = one.clamp(0.0, 1.0);
        children[1][input] = other.clamp(0.0, 1.0);
    }
    children
}

/// Move an input here and there, mostly by little.
fn mutate(child: &mut [f64], random: &mut Random) {
    let chance = 1.0 / child.len() as f64;
    let power = 1.0 / (ETA_MUTATE + 1.0);
    for value in child.iter_mut() {
        if random.unit() >= chance {
            continue;
        }
        let throw = random.unit();
        let step = if throw < 0.5 {
            let room = (1.0 - *value).powf(ETA_MUTATE + 1.0);
            (2.0 * throw + (1.0 - 2.0 * throw) * room).powf(power) - 1.0
        } else {
            let room = value.powf(ETA_MUTATE + 1.0);
            1.0 - (2.0 * (1.0 - throw) + 2.0 * (throw - 0.5) * room).powf(power)
        };
        *value = (*value + step).clamp(0.0, 1.0);
    }
}

#[cfg(test)]
mod tests;
