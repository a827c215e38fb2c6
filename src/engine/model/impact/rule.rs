//! Rules beside the equations of motion: each ends a run early, bridges a singular point, or keeps rounding errors from acting.
//!
//! A test switches each rule off and finds what it changes. A rule that changes nothing is removed.

/// Rule beside the equations of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rule {
    /// End of a plastic run once the remaining energy can neither deepen the hole nor pull the projectile out.
    EnergySpent,
    /// End of a plastic run once friction on the remaining distance dissipates all energy above that of the limit oscillation.
    SlipsWithinFriction,
    /// End of a plastic run while the projectile slips above the bottom of its hole, with an interval for the depth.
    DepthInterval,
    /// Sum of infinitely many, ever smaller slips from the energy.
    LastSlips,
    /// End of a contact without adhesion if the remaining energy cannot separate the bodies noticeably.
    Parting,
    /// End of the displacement if the remaining energy cannot exceed its maximum.
    Reach,
    /// End of the displacement of a damped plate that cannot pass its equilibrium.
    Overshoot,
    /// Maximum displacement from the energy if only the spring can reverse the plate.
    SpringTurns,
    /// Rest of a plate whose forces balance apart from rounding.
    Balance,
    /// Arrest of fused bodies by a stop that they strike with negligible energy.
    SoftBlow,
    /// Plate that a singular spring locks from the start.
    InitialLock,
    /// Plate that a singular spring locks again.
    Relock,
    /// Inertia and damping of the quasi-static plate when it unlocks.
    Lag,
    /// Limit of the step size before a singular zero.
    Approach,
    /// Passage of a plate through a singular zero with little energy in its spring.
    ZeroPassed,
    /// Rest of a plate whose further bounces are negligible.
    BouncesToRest,
    /// Look for an event function that is below zero only between two samples of a step.
    Dips,
    /// Suppression of an event that reverses the event at the same state.
    Undone,
}

impl Rule {
    /// Returns `true`; `false` in a test that has switched the rule off.
    #[inline(always)]
    #[cfg_attr(not(test), expect(clippy::unused_self, reason = "a test looks which rule it is"))]
    pub(super) fn applies(self) -> bool {
        #[cfg(test)]
        return tests::OFF.get() != Some(self);
        #[cfg(not(test))]
        true
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::Rule;
    use crate::model::run::{EndReason, Run};
    use crate::model::simulate::bare_run;
    use crate::model::variables::scene_with;

    thread_local! {
        /// Rule that is switched off on this thread.
        pub(super) static OFF: Cell<Option<Rule>> = const { Cell::new(None) };
    }

    /// Difference that a rule makes.
    #[derive(Clone, Copy, Debug)]
    enum Difference {
        /// End of the run with the rule and without it.
        End([EndReason; 2]),
        /// Least work without the rule, relative to the work with it.
        Work(f64),
        /// Least change of the maximum displacement, in tolerances of the run.
        Displacement(f64),
    }

    const BUDGET: Difference = Difference::End([EndReason::Decided, EndReason::StepBudget]);
    const OSCILLATES: Difference = Difference::End([EndReason::Decided, EndReason::Oscillates]);

    /// Scene for each rule, with the difference it makes there.
    const SCENES: &[(Rule, &str, Difference)] = &[
        (
            Rule::EnergySpent,
            "gamma=1.3383 k=9.026e6 interface=plastic x_stop=1.7447mm k_stop=1e7",
            OSCILLATES,
        ),
        (
            Rule::SlipsWithinFriction,
            "gamma=2.09 k=2.664e5 interface=plastic n=0.5 x_stop=1.0355mm k_stop=1e7",
            Difference::Work(2.0),
        ),
        (Rule::DepthInterval, "gamma=2.9769 k=4.7907e6 interface=plastic", OSCILLATES),
        (
            Rule::LastSlips,
            "k=8311.1 x_stop=0.59455mm stop_kind=elastic k_stop=9.5999e8 interface=plastic",
            OSCILLATES,
        ),
        (
            Rule::Parting,
            "model=lumped k_load=1.2035e5 k_unload=2.7085e8 gamma=0.9628 k=0 b=107.78",
            OSCILLATES,
        ),
        (Rule::Reach, "n=3 m=3 k=1.47e7 b=83.5 gamma=2.17 v_i=6.26", OSCILLATES),
        (
            Rule::Overshoot,
            "n=3 m=1.3065 k=2.8213e5 b=237.52 d=0.38801 gamma=1.8898 v_i=7.7698 h=2.7148mm S_y=21.236MPa",
            BUDGET,
        ),
        (Rule::SpringTurns, "gamma=1 spring=bistable", Difference::Work(1.5)),
        (
            Rule::Balance,
            "n=0.427011 m=2.11792 k=2.49896e8 b=625.352 d=64.5938mm gamma=2.27376e-3 v_i=8.42649mm/s h=2.8536 theta=63.1568deg \
             S_y=4.56724e5 C_d=0.0652797 interface=plastic g=1.12864 x_stop=-6.452934480000001e-2 stop_kind=elastic k_stop=4.79563e10 b_stop=2.09969e5",
            BUDGET,
        ),
        (
            Rule::SoftBlow,
            "k=4.018e6 gamma=0.66691 v_i=230.3 h=37.091mm interface=plastic g=0.1 horizon=0.4503ms x_stop=10.55um e=1",
            BUDGET,
        ),
        (Rule::InitialLock, "n=0.22 m=1.5 k=2.6e5 b=185 gamma=1 v_i=43.4 S_y=1.7GPa C_d=0", BUDGET),
        (
            Rule::Relock,
            "n=0.23119 m=0.62494 k=1.1962e6 b=65.554 gamma=0.052801 v_i=241.25 h=1.8968mm S_y=366.28MPa C_d=0.16613",
            BUDGET,
        ),
        (
            Rule::Lag,
            "n=0.30364 k=3.1265e8 gamma=10.32 v_i=131.9 h=4.9831mm theta=28.962deg S_y=27.857MPa C_d=0.14203 tol=1.0608e-11",
            Difference::Displacement(100.0),
        ),
        (
            Rule::Approach,
            "n=2 m=1.5217 k=548.66 b=327.93 d=0.39043 gamma=0.70949 v_i=144.77 h=24.599mm S_y=13.612MPa C_d=0.28053 interface=plastic",
            Difference::Displacement(1e3),
        ),
        (Rule::ZeroPassed, "gamma=2 k=5e5 n=0.5 interface=plastic", Difference::Work(1.5)),
        (Rule::BouncesToRest, "k=0 b=1.36 gamma=0.747 x_stop=13.7um e=0.9", Difference::Work(2.0)),
        (
            Rule::Dips,
            "n=2.17881 m=0.759558 k=4.79807e5 gamma=8.75375e-4 v_i=0.246327 h=1.58546mm S_y=1.67879e5 C_d=0.356366 interface=plastic \
             g=0.0594629",
            Difference::Displacement(100.0),
        ),
        (
            Rule::Undone,
            "model=lumped k_load=2.1126e5 k_unload=2.4274e8 gamma=8.8094 k=0 b_2=19.644 b=8.1623",
            OSCILLATES,
        ),
    ];

    fn run(pairs: &str, off: Option<Rule>) -> Run {
        OFF.set(off);
        let run = bare_run(&scene_with(pairs));
        OFF.set(None);
        run
    }

    #[test]
    fn each_rule_makes_its_difference() {
        for (rule, pairs, difference) in SCENES {
            let [with, without] = [None, Some(*rule)].map(|off| run(pairs, off));
            match *difference {
                Difference::End(ends) => assert_eq!([with.end, without.end], ends, "{rule:?}"),
                Difference::Work(least) => {
                    let ratio = without.cost.work() as f64 / with.cost.work() as f64;
                    assert!(ratio > least, "{rule:?}: {ratio}");
                }
                Difference::Displacement(least) => {
                    let [with_m, without_m] =
                        [&with, &without].map(|run| run.max_plate_displacement_m.unwrap());
                    let change = (without_m / with_m - 1.0).abs() / with.scene.run.tolerance;
                    assert!(change > least, "{rule:?}: {change}");
                }
            }
        }
    }
}
