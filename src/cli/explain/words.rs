//! Words of screens and pages that are neither variables nor quantities nor warnings, each with its explanation.

/// Words with the same explanation, and the explanation.
pub(super) const WORDS: &[(&[&str], &str)] = &[
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
    (&["%"], "depth in percent of that of the same plate on a rigid mount (percent_of_baseline)"),
    (
        &["baseline"],
        "the same shot at the same plate on a rigid mount, to which a depth is related",
    ),
    (&["peak"], "maximum contact force (peak_contact_force_n)"),
    (&["unbounded"], "peak force if a fused plate hits its rigid stop: infinite in this model"),
    (&["mount"], "maximum force of spring, damper and stop on the mount (peak_mount_force_n)"),
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
        &["outcome", "ends"],
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
    (&["interface limit exceeded"], "event: a fused interface is loaded beyond its strength"),
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
        &["preloaded energy", "preloaded"],
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
    (&["law", "laws"], "equation that gives a limit or a residual velocity, such as Recht-Ipson"),
    (&["Recht-Ipson"], "residual velocity v_r = a (v^2 - v_bl^2)^(1/2), with a by least squares"),
    (
        &["Lambert-Jonas"],
        "residual velocity v_r = a (v^p - v_bl^p)^(1/p), with a, p and v_bl by least squares",
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
        &["if spring must survive"],
        "ballistic limit of shots that the spring stores without yielding",
    ),
    // Studies.
    (
        &["front", "Pareto", "Pareto front"],
        "designs of which none is better in one objective without being worse in another",
    ),
    (
        &["knee"],
        "design of a front beyond which an objective gains little for what the others lose",
    ),
    (
        &["feasible"],
        "a design without a warning on the unsafe side (interface, spring, stop, face)",
    ),
    (
        &["design", "designs"],
        "one set of values of the variables that a study varies; in Search also their number",
    ),
    (
        &["goal", "goal seek", "seek"],
        "the value that a result has to reach; goal seek finds the values of one variable that do",
    ),
    (&["effort"], "setup of a study: how many designs or samples are computed"),
    (
        &["minimise", "maximise", "objective"],
        "a result that a front makes as small, or as large, as possible",
    ),
    (&["candidate", "candidates"], "one of the armours that are compared"),
    (&["nominal"], "result for the values of the scene itself, without their tolerances"),
    (
        &["Monte Carlo", "montecarlo", "sample", "samples"],
        "results for random values of uncertain variables; each set of values is a sample",
    ),
    (&["seed"], "number that selects the random samples: the same seed gives the same samples"),
    (
        &["interval"],
        "95 % confidence interval of an estimate: it narrows with the square root of the number of samples",
    ),
    (
        &["mean", "mean from", "mean to"],
        "average of the samples, and its 95 % confidence interval (from, to)",
    ),
    (&["std dev", "std", "spread"], "standard deviation of the samples"),
    (&["median"], "value that half of the samples do not exceed"),
    (&["bin", "samples per bin"], "interval of a histogram, and the number of samples in it"),
    (
        &["sensitivity", "matters", "bar", "bars", "low to high"],
        "effect of each variable on a result over its range: a bar from the smallest to the largest value of the result. In the Run tab the \
         view key shows bars in place of words",
    ),
    (&["swing"], "largest minus smallest value of a result over the range of one variable"),
    (&["here"], "change of a result with a variable at the scene's own value: its slope"),
    (&["at low", "at high"], "result at the low and at the high end of a variable's range"),
    (&["range"], "interval over which a study varies a variable"),
    (&["crosshair", "cursor"], "mark in a chart whose values stand in the line below it"),
    (&["map"], "chart over two variables: shades, or a mark for each cell"),
    (&["sweep"], "runs at every point of one or more axes"),
    (
        &["axis", "across", "along"],
        "variable of a sweep: along the chart, or across it as curves or rows",
    ),
    (&["contour"], "line of equal values in a map"),
    // Methods and their errors.
    (
        &["auto"],
        "method of the engine: the closed form if the scene has one, else Radau IIA 17. For charts: the finest characters that the locale allows",
    ),
    (&["auto-run"], "whether each change of the scene starts its study at once"),
    (
        &["Radau", "Radau IIA", "Radau IIA 5", "Radau IIA 17"],
        "implicit Runge-Kutta methods for stiff and smooth equations alike; the number is the order",
    ),
    (
        &["DOP853", "DOP853 + events"],
        "explicit Runge-Kutta method of order 8 with an adaptive step size, for comparison",
    ),
    (
        &["RK4", "RK4 + events", "RK4, no events", "classical Runge-Kutta", "Runge-Kutta"],
        "classical explicit Runge-Kutta method of order 4 with a fixed step size, with and without location of events",
    ),
    (
        &["contact kernel", "kernel"],
        "Taylor series for the first contact alone, as in large sweeps",
    ),
    (
        &["printed scheme", "the thesis's scheme", "printed", "scheme", "as printed"],
        "time stepping of the listing in Appendix A of the thesis, as printed; model=appendix",
    ),
    (
        &["nothing omitted"],
        "method `auto` with every term computed, also those that change no digit",
    ),
    (
        &["omitted"],
        "parts of the model that do nothing in this scene and are not computed: they change no digit",
    ),
    (
        &["gain", "with it", "without"],
        "run time with and without an omitted part, and their quotient",
    ),
    (
        &["error"],
        "estimated error of the depth, relative to the depth, from a second computation; in comparisons, the computed over the measured value, \
         minus one",
    ),
    (
        &["estimate", "estimate basis", "error estimate"],
        "error estimate: difference from a second computation with a smaller tolerance, from a closed form, or from half the step size; the \
         basis says which",
    ),
    (
        &["relative error", "error against", "reference"],
        "difference from a reference by another family of methods, relative to it; the largest of all results of the run",
    ),
    (&["floor", "reference's floor"], "uncertainty of the reference: smaller errors are not known"),
    (
        &["t(1e-6)", "t(1e-9)", "run time"],
        "time that a run takes, here with a relative error of at most 1e-6 or 1e-9",
    ),
    (&["least"], "smallest error that a method reaches, or smallest result over a range"),
    (&["tolerance"], "error that a step may have, relative to the scale of the motion"),
    (&["damper"], "part of the mechanism that resists the velocity of the plate: b |w|^m"),
    (&["exponent"], "power of a spring (n) or a damper (m): 1 is linear"),
    (&["oblique"], "a shot at an angle to the normal of the plate (theta)"),
    (
        &["bounds"],
        "ranges of the variables that a study varies, and limits that a design has to keep",
    ),
    (&["rows compared", "compared"], "points of a measured trace that were compared with the run"),
    (
        &["steps", "step", "accepted", "rejected"],
        "accepted time steps of a run; rejected steps are repeated with a smaller size",
    ),
    (&["dt"], "step size of a method with fixed steps, s"),
    (&["accuracy"], "page that compares error and run time of all methods on this scene"),
    (
        &["stability", "battery"],
        "page with stiff and extreme scenes that the engine has to pass, and the map of a method with fixed steps",
    ),
    (&["difficulty"], "why a scene of the battery is hard to integrate"),
    (&["pass", "ok", "FAIL", "failed"], "whether a row meets its requirement"),
    (
        &["accurate", "inaccurate", "diverged"],
        "cells of the map of a fixed step: error up to 1 %, more, or without bound",
    ),
    (
        &["stiff"],
        "with time scales so different that an explicit method is limited by stability, not by accuracy",
    ),
    (
        &["second computation"],
        "the same run with a smaller tolerance, from which the error is estimated",
    ),
    // The thesis.
    (&["claim", "claims"], "statement of the thesis that is computed again"),
    (&["says", "cause"], "statement of the thesis in other words, and the reason for its verdict"),
    (&["reproduced"], "verdict on a statement of the thesis: as stated"),
    (
        &["reproduced with correction", "correction"],
        "verdict on a statement of the thesis: as stated after the correction that the cause names",
    ),
    (
        &["misprint"],
        "verdict on a statement of the thesis: a wrong number or word; the intended one is computed",
    ),
    (&["not reproduced"], "verdict on a statement of the thesis: not as stated"),
    (
        &["principle", "principles"],
        "approach of chapter 4 of the thesis to reject, reduce or dissipate the energy of a projectile",
    ),
    (
        &["concept", "concepts", "criterion", "rank", "total"],
        "mechanism of chapter 6 of the thesis, rated by weighted criteria in its Table 7.1",
    ),
    (
        &["functions", "orientation", "stiffness", "lateral", "array"],
        "behaviours of chapter 5 of the thesis: O orientation of the plate, A accelerated elements, S controlled stiffness, L lateral array",
    ),
    // The workbench.
    (&["Explore"], "tab with sweeps over one or two variables"),
    (&["Search"], "tab with goal seek, Pareto front, sensitivity and Monte Carlo study"),
    (&["Numerics"], "tab with accuracy and stability of the methods"),
    (&["Thesis"], "tab with claims, principles and concepts of the thesis, and measured limits"),
    (&["Log"], "tab with warnings and messages"),
    (
        &["Run", "runs"],
        "one simulation of a scene; the tab that shows it, with the pinned runs beside it",
    ),
    (&["pin", "pinned"], "to keep a run for comparison with later ones"),
    (
        &["preset"],
        "a scene that comes with the program, or one of your own; `cmra presets` lists them",
    ),
    (
        &["scene", "modified"],
        "all values that define a shot; modified: not saved since the last change",
    ),
    (&["setup"], "what a study varies, and how much it computes"),
    (&["quantity"], "result that can be swept, searched and exported; `cmra explain` lists them"),
    (&["mechanism", "system"], "what carries the plate: spring, damper and stop"),
    (&["stack"], "several plates behind one another; see `cmra help stacks`"),
    (&["contact/whole", "whole"], "the contact alone, or the whole motion of the plate"),
    (
        &["scale", "log", "linear"],
        "spacing of an axis: equal steps for equal differences (linear) or for equal ratios (log)",
    ),
    (&["view"], "another way to show the same results"),
    (&["symbol"], "short name of a variable, as `--set` takes it"),
    (&["rows"], "number of measurements, or of points of a sweep"),
    (&["name in files", "key"], "name in scene files, CSV and JSON"),
    (
        &["solid", "solid plate"],
        "a plate of the same material without a mechanism, to which mass efficiency refers",
    ),
    (
        &["slices", "slices through the cursor"],
        "curves along both axes of a map, through the crosshair",
    ),
];
