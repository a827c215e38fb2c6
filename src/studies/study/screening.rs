//! The screening matrix of thesis Table 7.1: eight concepts, seven criteria, weights that can be changed, and the ranking.

/// Criteria, in the table's order.
pub const CRITERIA: [&str; 7] = [
    "plate orientation",
    "controlled stiffness",
    "plate acceleration",
    "array compatibility",
    "mass efficiency",
    "manufacture, assembly",
    "ease of analysis",
];

/// Weights as printed, percent.
pub const WEIGHTS_PERCENT: [f64; 7] = [12.0, 20.0, 3.0, 10.0, 10.0, 10.0, 35.0];

/// A concept of chapter 6 with what the table says of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Concept {
    /// Its name.
    pub name: &'static str,
    /// Ratings from 1 (much worse than the reference) to 5, by criterion.
    pub ratings: [f64; 7],
    /// The total as printed.
    pub total: f64,
    /// The rank as printed.
    pub rank: usize,
    /// The thesis's section.
    pub section: &'static str,
    /// The bundled preset that shows it, or comes nearest.
    pub preset: &'static str,
}

/// The concepts, in the table's order.
#[rustfmt::skip]
pub const CONCEPTS: [Concept; 8] = [
    Concept { name: "Emergent four-bar", ratings: [3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0], total: 3.0, rank: 4, section: "6.2.1", preset: "concept-emergent-four-bar" },
    Concept { name: "Buckling four-bar", ratings: [2.0, 3.0, 1.0, 3.0, 2.0, 3.0, 1.0], total: 2.02, rank: 8, section: "6.2.1", preset: "concept-buckling-four-bar" },
    Concept { name: "Buckling cantilever", ratings: [2.0, 3.0, 1.0, 3.0, 3.0, 3.0, 2.0], total: 2.47, rank: 5, section: "6.2.2", preset: "concept-buckling-cantilever" },
    Concept { name: "Cocked four-bar", ratings: [3.0, 4.0, 4.0, 3.0, 3.0, 3.0, 3.0], total: 3.23, rank: 3, section: "6.2.3", preset: "concept-cocked-four-bar" },
    Concept { name: "Cocked cantilever", ratings: [3.0, 4.0, 4.0, 3.0, 4.0, 4.0, 4.0], total: 3.78, rank: 1, section: "6.2.4", preset: "concept-cocked-cantilever" },
    Concept { name: "Bistable shuttle", ratings: [1.0, 2.0, 4.0, 3.0, 3.0, 4.0, 2.0], total: 2.34, rank: 6, section: "6.2.5", preset: "concept-bistable-shuttle" },
    Concept { name: "Buckling tube", ratings: [2.0, 1.0, 1.0, 4.0, 3.0, 2.0, 2.0], total: 2.07, rank: 7, section: "6.2.6", preset: "concept-buckling-tube" },
    Concept { name: "Helical rotating spring", ratings: [2.0, 4.0, 2.0, 4.0, 2.0, 2.0, 4.0], total: 3.3, rank: 2, section: "6.2.7", preset: "concept-helical-spring" },
];

/// A concept's place under some weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranking {
    /// Index into [`CONCEPTS`].
    pub concept: usize,
    /// Weighted total, each weight counted as percent.
    pub total: f64,
    /// 1 is the best; equal totals share a rank.
    pub rank: usize,
}

/// Totals and ranks under these weights, in the order of [`CONCEPTS`].
pub fn rank(weights_percent: &[f64; 7]) -> Vec<Ranking> {
    let total = |concept: &Concept| {
        concept
            .ratings
            .iter()
            .zip(weights_percent)
            .map(|(rating, weight)| rating * weight)
            .sum::<f64>()
            / 100.0
    };
    let totals: Vec<f64> = CONCEPTS.iter().map(total).collect();
    totals
        .iter()
        .enumerate()
        .map(|(concept, total)| Ranking {
            concept,
            total: *total,
            rank: 1 + totals.iter().filter(|other| **other > *total + 1e-9).count(),
        })
        .collect()
}

/// The same, the best first.
pub fn ranking(weights_percent: &[f64; 7]) -> Vec<Ranking> {
    let mut places = rank(weights_percent);
    places.sort_by_key(|place| place.rank);
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_the_printed_totals_and_ranks() {
        for place in rank(&WEIGHTS_PERCENT) {
            let concept = &CONCEPTS[place.concept];
            assert!((place.total - concept.total).abs() < 1e-9, "{}", concept.name);
            assert_eq!(place.rank, concept.rank, "{}", concept.name);
        }
        assert!((WEIGHTS_PERCENT.iter().sum::<f64>() - 100.0).abs() < 1e-12);
    }

    #[test]
    fn valid_without_ease_of_analysis_the_helical_spring_falls_to_fourth() {
        let mut weights = WEIGHTS_PERCENT;
        weights[6] = 0.0;
        let order: Vec<&str> =
            ranking(&weights).iter().map(|place| CONCEPTS[place.concept].name).collect();
        assert_eq!(
            order[..4],
            [
                "Cocked cantilever",
                "Cocked four-bar",
                "Emergent four-bar",
                "Helical rotating spring"
            ]
        );
        let totals = rank(&weights);
        assert!((totals[4].total - 2.38).abs() < 1e-9 && (totals[7].total - 1.90).abs() < 1e-9);
    }
}
