//! Words of results: of a run, its validity, limits and verdicts, the comparison, and formulas.

use super::Entry;

/// Words of results.
pub(super) const WORDS: &[Entry] = &[
    // Results of a run.
    (
        &["plastic"],
        "depth, and in brackets percent, of the same shot if the interface between projectile and plate can yield; set interface=plastic",
    ),
    (
        &["travel", "maximum plate displacement", "greatest displacement"],
        "maximum displacement of the plate from the neutral position of its spring (max_plate_displacement_m)",
    ),
    (
        &["displacement", "plate displacement"],
        "distance of the plate from the neutral position of its spring, positive away from the shot",
    ),
    (&["penetration", "final depth"], "depth of the projectile in the plate (final_penetration_m)"),
    (
        &["depth", "deep"],
        "final penetration into the plate, the hole that dishing leaves included (final_penetration_m)",
    ),
    (
        &["%", "of the rigid mount's"],
        "depth in percent of that of the same plate on a rigid mount (percent_of_baseline)",
    ),
    (
        &["on a rigid mount"],
        "depth of the same shot at the same plate on a rigid mount (baseline_penetration_m)",
    ),
    (
        &["baseline"],
        "the same shot at the same plate on a rigid mount, to which a depth is related",
    ),
    (&["peak"], "maximum contact force (peak_contact_force_n)"),
    (
        &["unbounded"],
        "push on a fused interface whose plate hits its rigid stop: infinite in this model",
    ),
    (
        &["mount", "mount force"],
        "maximum force on the mount, with what turns a geared mass (peak_mount_force_n); its chart and the rows of a CSV are without that",
    ),
    (
        &[
            "arrest",
            "first arrest",
            "first stop",
            "first stops",
            "stops first",
            "projectile first stops",
        ],
        "first zero of the relative velocity: projectile and plate have a common velocity, and penetration stops for the first time",
    ),
    (&["common velocity"], "velocity of projectile and plate at the first arrest"),
    (
        &["outcome", "ends", "arr", "perf", "sep", "mov", "CUT"],
        "end of a shot: arrested (arr), perforated (perf), separated (sep) or moving (mov); CUT: the run ended early",
    ),
    (
        &["arrested", "stick", "stopped"],
        "outcome: the projectile comes to rest relative to the plate within it",
    ),
    (
        &["perforated", "through", "perforation"],
        "outcome: the projectile leaves the plate through its rear face",
    ),
    (
        &["separated"],
        "outcome: the plate moves away from the projectile, which no longer touches it",
    ),
    (&["moving"], "outcome: undecided at the horizon, which is the end of the computed time"),
    (
        &["ended early"],
        "the run stopped before its outcome was decided: a limit of steps, a cancel, or a result that is not finite",
    ),
    (&["rear face reached", "nose out of rear face"], "the tip of the nose is through the plate"),
    (&["penetration resumes", "resumes"], "event: the projectile moves on into the plate"),
    (&["pull-out begins"], "event: the plate pulls harder than the grip of its hole"),
    (
        &["separation", "contact again"],
        "event: the nose leaves the plate through its entry face; it is struck by the plate again",
    ),
    (
        &["stop hit", "held by the stop", "leaves the stop"],
        "event: the plate meets its stop, rests on it, or comes off it",
    ),
    (
        &[
            "interface limit exceeded",
            "interface limit exceeded: push",
            "interface limit exceeded: pull",
        ],
        "event: a fused interface is loaded beyond its strength, in compression (push) or in tension (pull)",
    ),
    (
        &["undecided", "lower bounds", "so far"],
        "not known to perforate nor to be stopped: the run ended early; the final depth and displacement are not smaller",
    ),
    (
        &["if it can yield"],
        "result of the same shot with interface=plastic, beside that with a fused interface",
    ),
    (
        &["energy stored at most", "turning with plate"],
        "maximum energy of springs and of parts that turn with the plate (stored_energy_j, rotational_energy_j)",
    ),
    (&["nose buried", "buried"], "event: the nose is in the plate over its whole radius"),
    (
        &["event", "events"],
        "instants at which the equations change, such as the first arrest or the meeting of a stop",
    ),
    (
        &["mode", "penetrating", "withdrawing", "free-flight", "closing"],
        "contact mode of a row: penetrating; fused, at rest in the plate; withdrawing, slipping out of its hole; closing, moving back to its \
         bottom; free-flight, without contact; perforated",
    ),
    (
        &["slip", "q"],
        "displacement of the projectile relative to the plate: the path of the contact force",
    ),
    (&["method"], "integration method of a run, and why it was chosen"),
    (&["end"], "why a run ended: its outcome was decided, or it ended early"),
    (&["time"], "instant, from the first contact; in a table of methods the time that a run takes"),
    (
        &["projectile", "plate"],
        "the body that strikes and the body that is struck; in an energy balance, their kinetic energies",
    ),
    (
        &["projectile velocity"],
        "velocity of the projectile as it leaves the plate through its entry face (separation_velocity_m_s); of `cmra design`, after an \
         elastic collision",
    ),
    (
        &["at the start", "at the end"],
        "whole energy of a run before the impact and at its end; the lines below are its parts",
    ),
    (
        &["springs' own mass", "added to the plate"],
        "mass of the springs themselves (spring_mass_kg), and what the mechanism adds to the moving mass (added_inertia_kg)",
    ),
    (&["evaluations"], "of the equations of motion: the work of a run"),
    (&["share"], "fraction of a total, such as that of the energy at the start"),
    (
        &["energy"],
        "energy balance of a run; residual: what it lacks at the end, relative to the start (energy_residual)",
    ),
    (
        &["residual"],
        "residual velocity: velocity of the projectile after a perforation (residual_velocity_m_s); energy residual: error of the energy \
         balance, relative to the energy at the start (energy_residual)",
    ),
    (
        &["preloaded energy", "preloaded", "energy stored by cocking"],
        "energy in the cocked spring before the shot (preload_energy_j)",
    ),
    (
        &["cocked", "cocked spring"],
        "a spring that is deflected by the distance d, towards the shot, before the impact",
    ),
    (
        &["weight", "weight since"],
        "force of gravity on a plate that has left its support, and the energy that it has added since",
    ),
    (
        &["crushed", "crush"],
        "energy that an absorber has taken by being crushed; it does not return",
    ),
    (
        &["plug", "plug sheared", "plug pick-up", "plug picked up"],
        "disc that a blunt nose punches out of the plate: it is accelerated (pick-up) and sheared out along its edge",
    ),
    (&["shear", "sheared"], "shearing of the plug out of the plate, and its energy"),
    // Interface and validity.
    (
        &["demand", "push", "interface push"],
        "force with which a fused interface pushes the projectile, over its strength A S_y (interface_demand_ratio): above 1 penetration would \
         resume",
    ),
    (
        &["pull", "rebound pull"],
        "force with which a fused interface holds the projectile back, over its strength g A S_y (interface_tension_ratio): above 1 the \
         projectile would come loose",
    ),
    (
        &["capacity", "strength"],
        "largest load that a part bears: of the interface A S_y in compression and g A S_y in tension",
    ),
    (
        &["ratio"],
        "quotient of two quantities of the same unit: a demand over a strength, or a thickness over a diameter",
    ),
    (
        &["A"],
        "contact area of the nose, up to pi R^2: A S_y is the largest load that the interface bears",
    ),
    (&["D"], "diameter of the projectile, 2 R: h/D compares the thickness of the plate with it"),
    (
        &["validity"],
        "the range in which the model was compared with experiments; a check that fails is named, with the side on which the answer errs",
    ),
    (
        &["conservative"],
        "outside the validity, on the safe side: the model says more depth, force or displacement than there is",
    ),
    (
        &["unconservative"],
        "outside the validity, on the unsafe side: the model says less depth, force or displacement than there is",
    ),
    (
        &["warning", "warnings", "caution", "!"],
        "a check that failed; `cmra explain` lists them and explains each by its name",
    ),
    (&["note", "remark"], "something to know about a result that does not change it"),
    (
        &["hold", "held", "holds", "plate held"],
        "plate held: the spring carries the contact force and the plate stands still as on a rigid mount; of a study: a value that is \
         kept while others vary",
    ),
    (&["yield", "yields"], "stress over yield strength of the spring: from 1 on it keeps a set"),
    // Limits and verdicts.
    (
        &["v_bl", "limit", "ballistic limit", "ballistic"],
        "ballistic limit: the lowest velocity that perforates the plate (limit_velocity_m_s)",
    ),
    (
        &["V50"],
        "impact velocity at which half of the shots perforate; every ballistic limit here is a V50. A margin below it is needed to stop all",
    ),
    (&["meaning"], "what a limit says of shots at that velocity"),
    (&["at the limit"], "result of the fastest shot that is stopped, at the ballistic limit"),
    (&["at the design velocity"], "outcome of the scene's own shot, for which the armour is meant"),
    (
        &["margin"],
        "how far this shot's velocity is below the ballistic limit, in percent of the shot's velocity; a shot with a negative margin perforates",
    ),
    (
        &["expected"],
        "ballistic limit corrected for the bias of its class of measurements; low and high are the ends of its band",
    ),
    (
        &["band", "low", "high", "inside"],
        "interval around the expected limit, from low to high, that holds 90 % of measured limits of this class",
    ),
    (
        &["class", "classes"],
        "measured shots that are alike: nose, core, alloy of the plate and angle. Bias and scatter of the law are known for each; `cmra validate` \
         lists them",
    ),
    (&["bias"], "mean of computed over measured limits of a class, minus one"),
    (&["scatter"], "standard deviation of ln(computed/measured) within a class"),
    (
        &["verdict"],
        "answer to `does this armour stop this shot?`: stops, open, perforates, or not measured. In `cmra reproduce`: whether a statement of \
         the thesis is borne out",
    ),
    (&["stops", "stops it"], "verdict: the shot is slower than the band of the expected limit"),
    (&["open"], "verdict: the shot is within the band of the expected limit; a test has to decide"),
    (
        &["perforates", "is perforated"],
        "verdict: the shot is faster than the band of the expected limit",
    ),
    (
        &["not measured", "not-measured"],
        "verdict: no class of measurements has such shots, and the law alone decides",
    ),
    (
        &["judge", "judged"],
        "to give the verdict on a shot by the band of measured limits, not by the law alone",
    ),
    (&["decides", "decided"], "says which rule gave the answer: measurements, or the law alone"),
    (
        &["measured", "measurement", "measurements"],
        "a ballistic limit, depth or residual velocity from a published experiment",
    ),
    (
        &["law alone", "by the law alone"],
        "without measurements: the computed limit, with neither bias nor band, decides",
    ),
    (&["law", "laws"], "equation that gives a limit or a residual velocity, such as Recht-Ipson"),
    (&["Recht-Ipson"], "residual velocity v_r = a (v^2 - v_bl^2)^(1/2), with a by least squares"),
    (
        &["Lambert-Jonas"],
        "residual velocity v_r = a (v^p - v_bl^p)^(1/p), with a, p and v_bl by least squares",
    ),
    (
        &["RMS error"],
        "root of the mean square of the differences between a fitted law and the computed shots, m/s",
    ),
    (&["fitted", "fit"], "with coefficients by least squares from the computed shots"),
    (
        &["strength rule", "rule", "by each rule"],
        "where the strength S_y comes from: the variable `closure`",
    ),
    (
        &["jump"],
        "thickness at which the strength rule `by-thickness` changes, and the limit with it",
    ),
    (
        &["repeated hits"],
        "reduction of the limit for a second and third hit at one place, from published computations",
    ),
    (
        &["bisection"],
        "search for a limit by halving the interval between a shot that is stopped and one that perforates",
    ),
    (
        &["closed form", "exact"],
        "solution by a formula, without time steps: its error is that of rounding",
    ),
    (
        &["expansion"],
        "cavity expansion: strength from the pressure that opens a cavity in the metal",
    ),
    // Comparison.
    (
        &["areal", "areal mass"],
        "mass over area, kg/m^2: what armour weighs for each square metre that it covers",
    ),
    (
        &["mass efficiency", "efficiency"],
        "areal mass of a solid plate with the same ballistic limit, over the areal mass of this armour: above 1 the armour is lighter",
    ),
    (&["comparison", "compare"], "this armour beside a solid plate of the same areal mass"),
    (
        &["impulse", "impulse into mount"],
        "integral of the mount force over time (mount_impulse_n_s)",
    ),
    (
        &["if spring must survive", "if spring holds"],
        "ballistic limit of shots that the spring stores without yielding (limit_if_spring_survives_m_s); indented: results of the shot just \
         below it",
    ),
    // Formulas of `design`, and words of warnings.
    (
        &["critical obliquity", "Tate"],
        "angle to the normal from which a long rod ricochets, by the formula of Tate",
    ),
    (&["length of the rod"], "length of a cylinder with the projectile's mass and radius"),
    (&["effective thickness"], "path through the plate along the shot line: h/cos(theta)"),
    (&["work of the weight"], "work of m_p g on the plate's way to its greatest displacement"),
    (
        &["energy after it"],
        "kinetic energy of both bodies after an inelastic collision, which the mechanism has to take up",
    ),
    (
        &["least mass of the spring for all of it", "least mass of a steel coil for all of it"],
        "mass of a spring that stores the energy after the collision, that of cocking and the work of the weight",
    ),
    (
        &["Stone's depth P", "Stone's depth times c_t"],
        "depth of penetration by the formula of Stone (eq. 2.4), or, without its constant, their product",
    ),
    (
        &["surge", "surges"],
        "waves in a coil spring whose end moves faster than the coils follow: its stress then exceeds the static one",
    ),
];
