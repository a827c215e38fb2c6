//! Claims of chapter 7: the screening matrix of Table 7.1, its weights and its ranking.

use crate::study::principles::Function;
use crate::study::screening::{CONCEPTS, CRITERIA, WEIGHTS_PERCENT, rank, ranking};
use crate::study::thesis::concepts::{CONCEPT_SCENES, SUPPLIED};
use crate::study::thesis::lab::{
    Law, found, misprint_verdict, near, number, number_verdict, pc, read, trend_verdict,
};
use crate::study::thesis::{Claim, Opens, Verdict};

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "7.2.1-criteria",
        place: "7.2.1, Table 7.1",
        says: "the criteria are the mechanical functions of chapter 5, and feasibility",
        opens: Opens::Nothing,
        check: |_| {
            let asked = [
                "plate orientation",
                "controlled stiffness",
                "plate acceleration",
                "array compatibility",
            ];
            let there = asked.iter().filter(|name| CRITERIA.contains(name)).count();
            read(
                format!(
                    "{there} of {} functions, and {} more",
                    Function::ALL.len(),
                    CRITERIA.len() - there
                ),
                number_verdict(there == Function::ALL.len(), false),
                "acceleration stands for accelerated elements, array compatibility for lateral arrays",
            )
        },
    },
    Claim {
        id: "7.1-weights",
        place: "Table 7.1",
        says: "the weights are parts of a whole",
        opens: Opens::Nothing,
        check: |_| {
            let sum: f64 = WEIGHTS_PERCENT.iter().sum();
            found(
                pc(sum),
                number_verdict(near(sum, 100.0, 1e-12), false),
                "the seven weights add up",
            )
        },
    },
    Claim {
        id: "7.1-totals",
        place: "Table 7.1",
        says: "eight weighted totals from 2.02 to 3.78",
        opens: Opens::Nothing,
        check: |_| {
            let places = rank(&WEIGHTS_PERCENT);
            let right =
                places.iter().all(|it| (it.total - CONCEPTS[it.concept].total).abs() < 5e-3);
            let totals: Vec<String> = places.iter().map(|it| number(it.total)).collect();
            found(
                totals.join(" "),
                number_verdict(right, false),
                "ratings times weights give the printed totals",
            )
        },
    },
    Claim {
        id: "7.1-ranks",
        place: "Table 7.1, 7.2.3",
        says: "the cocked cantilever ranks first, the helical rotating spring second",
        opens: Opens::Nothing,
        check: |_| {
            let right =
                rank(&WEIGHTS_PERCENT).iter().all(|it| it.rank == CONCEPTS[it.concept].rank);
            let order: Vec<&str> =
                ranking(&WEIGHTS_PERCENT).iter().map(|it| CONCEPTS[it.concept].name).collect();
            found(
                order[..3].join(", "),
                number_verdict(right, false),
                "all eight ranks follow from the totals",
            )
        },
    },
    Claim {
        id: "7.2.2-weights",
        place: "7.2.2",
        says: "the weights reflect how important the mechanical functions are",
        opens: Opens::Nothing,
        check: |_| {
            let mut weights = WEIGHTS_PERCENT;
            weights[6] = 0.0;
            let places = rank(&weights);
            let helical = places[7];
            found(
                format!(
                    "without ease of analysis (35 %) the helical spring is {}th with {}",
                    helical.rank,
                    number(helical.total)
                ),
                trend_verdict(helical.rank <= 2),
                "ease of analysis decides the selection; plate acceleration, which chapter 9 finds strongest, has 3 %",
            )
        },
    },
    Claim {
        id: "7.2.2-reference",
        place: "7.2.2",
        says: "the angled four-bar is the reference the others are rated against",
        opens: Opens::Nothing,
        check: |_| {
            let reference = |name: &str| {
                let all_equal = |ratings: &[f64; 7]| ratings.iter().all(|it| near(*it, 3.0, 1e-12));
                CONCEPTS.iter().any(|it| it.name == name && all_equal(&it.ratings))
            };
            read(
                "the emergent four-bar alone has a 3 everywhere".to_owned(),
                misprint_verdict(reference("Angled four-bar"), reference("Emergent four-bar")),
                "no concept has that name: the emergent four-bar is meant",
            )
        },
    },
    Claim {
        id: "7.1-scale",
        place: "Table 7.1, caption, Table 7.2",
        says: "ratings range from 1 (much worse than the reference) to 5 (much better)",
        opens: Opens::Nothing,
        check: |_| {
            let all = || CONCEPTS.iter().flat_map(|it| it.ratings);
            let least = all().fold(f64::INFINITY, crate::numerics::smaller);
            let most = all().fold(0.0, crate::numerics::larger);
            read(
                format!("from {} to {}", number(least), number(most)),
                number_verdict(near(most, 5.0, 1e-12), least >= 1.0 && most <= 5.0),
                "no concept is rated much better than the reference in anything",
            )
        },
    },
    Claim {
        id: "7.1-acceleration",
        place: "Table 7.1 against 6.2",
        says: "concepts with accelerated elements are better than the reference in plate acceleration",
        opens: Opens::Nothing,
        check: |_| {
            let rated: Vec<(&str, f64)> = CONCEPTS
                .iter()
                .zip(SUPPLIED)
                .filter(|(_, supplied)| supplied.contains(&Function::AcceleratedElements))
                .map(|(concept, _)| (concept.name, concept.ratings[2]))
                .collect();
            let told: Vec<String> =
                rated.iter().map(|(name, rating)| format!("{name} {}", number(*rating))).collect();
            read(
                told.join(", "),
                trend_verdict(rated.iter().all(|(_, rating)| *rating > 3.0)),
                "6.2.7 lists accelerated elements for the helical spring, Table 7.1 rates it worse than a concept without",
            )
        },
    },
    Claim {
        id: "7.2.4-selected",
        place: "7.1, 7.2.4",
        says: "screening finds the concepts most likely to reduce the plate's deformation: cocked cantilever, helical spring",
        opens: Opens::Preset("concept-cocked-cantilever"),
        check: |lab| {
            let mut order: Vec<(f64, &str)> = CONCEPT_SCENES
                .iter()
                .zip(&CONCEPTS)
                .map(|((_, scene), concept)| (lab.percent(Law::Sound, &scene()), concept.name))
                .collect();
            order.sort_by(|a, b| a.0.total_cmp(&b.0));
            let told: Vec<String> =
                order.iter().map(|(percent, name)| format!("{name} {}", pc(*percent))).collect();
            found(
                told.join(", "),
                Verdict::Unchecked,
                "with the dimensions this program assumes; the thesis gives none, and rates ease of analysis instead of depth",
            )
        },
    },
];
