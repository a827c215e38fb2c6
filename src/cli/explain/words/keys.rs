//! Keys of JSON and CSV that are neither variables nor quantities, each with its explanation; words of screens have theirs elsewhere.

use super::Entry;

/// Parts of keys that belong to a quantity or key, each with the beginning of the explanation.
pub(in crate::cli::explain) const FAMILIES: [(&str, &str); 3] = [
    ("_at_limit", "for the fastest shot that is stopped"),
    ("_if_spring_survives", "for the shot just below the limit if the spring survives"),
    ("measured_", "measured value"),
];

/// Keys of files.
pub(super) const KEYS: &[Entry] = &[
    // All JSON objects.
    (
        &["complete"],
        "whether the study or run is finished; `false` after an interrupt, or while the outcome is open",
    ),
    (&["version"], "version of the program that wrote the file"),
    (&["title"], "title of the scene file"),
    (&["name"], "name of a variable or of a line"),
    (&["unit"], "unit of the value beside it; empty for a pure number"),
    (&["value"], "value of the variable, result or formula that the same object names"),
    (&["source"], "publication, table or formula that the line is from"),
    (&["line"], "line of the user's file"),
    (&["file"], "path of the file that was read"),
    (&["kind"], "kind of a line: solution, jump, gap or nearest value"),
    (&["output", "outputs"], "result that a study computes, by its name in files"),
    (
        &["variable", "variables", "inputs"],
        "variables by symbol or key, with their values or ranges",
    ),
    (&["axes"], "variables of a sweep, with their values"),
    (&["values"], "values of an axis, in order"),
    (&["from", "to"], "first and last value of an axis"),
    (&["count"], "number of values or rows"),
    (&["points"], "number of points of a study, or the points themselves"),
    (&["points_done"], "number of points computed before the end or an interrupt"),
    (&["shard"], "part of a sweep, I/N: every N-th row, beginning with row I"),
    (
        &["lower_bounds"],
        "results that are lower bounds, because the run ended before they were final",
    ),
    (&["refused"], "reason why a row has no result; in an object, the number of such rows"),
    // Runs.
    (
        &["error_estimates", "error_estimate_basis"],
        "relative error estimate of each result with a value, and what the estimates are based on",
    ),
    (&["method_reason"], "why the integration method was chosen"),
    (
        &["run_time_s", "run_time_s_min"],
        "time that the computation took, s; the shortest of several measurements",
    ),
    (&["time_s"], "instant of an event, from the first contact, s"),
    (
        &["penetration_m", "depth_m"],
        "depth of the projectile in the plate, m; null where it does not exist",
    ),
    (&["penetration_at_most_m"], "upper bound of a depth that is not final, by energy, m"),
    (&["nose_protrusion_m"], "length of the nose of a stopped projectile beyond the rear face, m"),
    (
        &["initial_kinetic", "initial_plate", "initial_spring"],
        "energy at the start, J: of the projectile, of the plate and of the cocked spring",
    ),
    (&["mechanism_inertia"], "kinetic energy of parts that move with the plate, at the end, J"),
    (&["plug_pick_up"], "energy lost when the nose picks up the plug, J"),
    (&["plates"], "results of each struck plate of a stack, in order"),
    (&["impact_velocity_m_s"], "velocity of the projectile when it meets the plate, m/s"),
    // Traces beside a run.
    (
        &["with", "traces"],
        "measured traces of a file beside a run, a row for each column of the file",
    ),
    (&["from_s", "to_s"], "first and last instant of a trace that is compared, s"),
    (
        &["measured_peak", "computed_peak"],
        "greatest value of a trace, and of the run at its instants",
    ),
    (&["measured_peak_time_s", "computed_peak_time_s"], "instants of these greatest values, s"),
    (&["measured_end", "computed_end"], "last value of a trace, and of the run at that instant"),
    (&["rms_difference"], "root mean square of computed minus measured values of a trace"),
    (
        &["greatest_difference", "greatest_difference_time_s"],
        "greatest difference of computed and measured values, and its instant, s",
    ),
    // Limits.
    (&["basis"], "how a value was found: by a formula, by bisection, or against which reference"),
    (&["no_limit"], "reason why there is no ballistic limit; null with one"),
    (
        &["limit_m_s", "deviation_m_s"],
        "ballistic limit V50 of a measurement, and its standard deviation, m/s",
    ),
    (&["stopped_again_at_m_s"], "slowest shot above the limit that is stopped again, m/s"),
    (&["undecided_at_m_s"], "slowest shot that is not known to be stopped, m/s"),
    (&["interface_holds_m_s"], "impact velocity up to which a fused interface bears its load, m/s"),
    (&["residual_at_limit_m_s"], "residual velocity of a shot just above the limit, m/s"),
    (&["closures"], "ballistic limit by each strength rule, with its drag coefficient"),
    (
        &["double_yield_dishing_m_s", "cavity_no_dishing_m_s", "cylindrical_no_dishing_m_s"],
        "ballistic limit by one strength rule, m/s",
    ),
    (
        &["double_yield_drag_coefficient", "cavity_drag_coefficient"],
        "drag coefficient that goes with a strength rule",
    ),
    (
        &["jump_m_s"],
        "limits on the two sides of the thickness at which the strength rule changes, m/s",
    ),
    (
        &["recht_ipson", "lambert_jonas"],
        "coefficients a, p and v_bl_m_s of the fitted law of residual velocities, with its RMS error",
    ),
    (&["recht_ipson_m_s", "lambert_jonas_m_s"], "residual velocity by the fitted law, m/s"),
    (&["p"], "exponent of a fitted law of residual velocities"),
    (&["v_bl_m_s"], "ballistic limit of a fitted law of residual velocities, m/s"),
    (
        &["misfit_m_s", "rms_error_m_s"],
        "root mean square of computed minus measured or fitted velocities, m/s",
    ),
    (&["shots"], "shots of the search, each with its impact velocity and outcome"),
    (&["papers"], "number of publications that a class of measurements is from"),
    // Comparison.
    (
        &["conclusion", "pays"],
        "whether the mechanism pays: as a sentence, and as true, false or null (undecided)",
    ),
    (&["design_velocity_m_s"], "impact velocity of the scene, for which the armour is meant, m/s"),
    (&["governed_by"], "what ends the range of safe shots: perforation, or a limit of the spring"),
    (&["mass_not_counted"], "parts that take up energy and whose mass is not counted"),
    (&["no_mass_efficiency"], "reason why there is no mass efficiency; null with one"),
    (&["penetration_over_solid"], "depth over the depth in a solid plate of the same areal mass"),
    (&["preload_energy_j"], "energy in the cocked spring before the shot, J"),
    (
        &["counted_spring_mass_kg"],
        "mass of the springs in the areal mass: given, or the least that stores the energy, kg",
    ),
    (
        &["spring_energy_j", "spring_energy_j_per_kg"],
        "greatest energy in the springs, J, and their capacity over their mass, J/kg",
    ),
    (&["spring_is_sized"], "whether the springs are sized for the design shot alone (`--size`)"),
    (&["face_m2"], "area of the plate over which masses are divided, m2"),
    (&["thickness_m"], "thickness of the plate, m"),
    (
        &["sized_thickness_m", "sized_areal_mass_kg_m2"],
        "thinnest armour of the kind that stops the shot: thickness, m, and areal mass, kg/m2",
    ),
    (
        &["solid_areal_mass_kg_m2"],
        "areal mass of the thinnest solid plate that stops the shot, kg/m2",
    ),
    (
        &["rigid_mount", "free_plate", "solid_plate"],
        "candidates: the same plate held, without mechanism, and a solid plate of the same areal mass",
    ),
    // Searches.
    (
        &["objectives", "constraints"],
        "results to minimise or maximise, and the bounds that a design has to keep",
    ),
    (&["is", "bound"], "a constraint: <= or >=, and the value on its right"),
    (&["given_up"], "number of runs that were stopped after too many steps"),
    (&["no_design"], "reasons why designs are infeasible or lack an objective"),
    (&["target"], "value that the output has to reach"),
    (&["scan_points"], "number of points of the scan, before solutions are refined"),
    (
        &["solutions", "jumps", "gaps"],
        "places where the output reaches the goal, jumps across it, or has no value beside it",
    ),
    (&["at", "until"], "value of the variable there; until: the other end of an interval"),
    (&["nearest"], "scanned point with the value closest to a goal that is not reached"),
    (&["most", "greatest"], "largest value of the output over the range"),
    (&["output_of_scene"], "output of the unchanged scene"),
    (
        &["output_at_low", "output_at_high", "outcome_at_low", "outcome_at_high"],
        "output and outcome at the low and at the high end of a variable's range",
    ),
    (&["slope"], "derivative of the output with respect to the variable at the scene"),
    // Monte Carlo.
    (
        &["distribution", "parameters"],
        "distribution of an input, and its two numbers: mean or median and width, or ends",
    ),
    (&["redrawn"], "number of draws repeated because the value was not allowed"),
    (
        &["redrawn_together"],
        "number of samples drawn again because their values were not allowed together",
    ),
    (&["outcomes"], "number of samples with each outcome"),
    (&["probability"], "fraction of the samples that perforate"),
    (
        &["low_95", "high_95", "mean_low_95", "mean_high_95"],
        "ends of the 95 % confidence interval of an estimate",
    ),
    (
        &["deviation", "standard_deviation", "relative_error_deviation"],
        "standard deviation of the samples, or of computed over measured",
    ),
    (&["quantiles"], "values that a given share of the samples does not exceed"),
    (&["model_error"], "bias and spread of the model by measurements, which correct the limit"),
    // Measurements.
    (&["case", "cases"], "published measurements beside what the model computes, by a short name"),
    (&["computed"], "value that the model gives in place of a measured or printed one"),
    (
        &["relative_error", "other_relative_error"],
        "computed over measured value, minus one; other: by the other strength rule",
    ),
    (&["other_closure"], "value by the other strength rule"),
    (&["beyond_closure"], "how the plate is outside the range of its strength rule; null inside"),
    (
        &["nose_pressure_pa"],
        "initial pressure on the nose, which a rigid projectile has to bear, Pa",
    ),
    (&["not_checked_because"], "reason why a measurement cannot be used as a check"),
    (&["resolution"], "resolution of a measured value, in its unit"),
    (&["errors"], "bias and scatter of computed over measured limits, by class"),
    (
        &["mean_absolute_error_m_s"],
        "mean of the absolute differences of computed and measured limits, m/s",
    ),
    (&["inside_band"], "whether the measured limit is inside its 90 % band"),
    (
        &["rows_with_band", "share_inside_band"],
        "number of measured limits with a band, and the fraction inside it",
    ),
    // Accuracy and stability.
    (&["answers"], "fastest method for each allowed error, beside method `auto`"),
    (&["parameter"], "step size or tolerance of a method"),
    (
        &["auto_tolerance", "auto_run_time_s"],
        "tolerance and run time of method `auto` for an allowed error",
    ),
    (&["time_step_s", "dt_s"], "step size of a method with fixed steps, s"),
    (&["letter"], "letter of a method in charts"),
    (
        &[
            "penetration_error",
            "time_error",
            "displacement_error",
            "force_error",
            "mount_force_error",
            "last_velocity_error",
            "last_time_error",
        ],
        "relative error of one result against the reference; last: of a projectile that leaves the plate",
    ),
    (&["at_floor"], "whether the error is at most the uncertainty of the reference"),
    (
        &["references", "ending", "end_time_s"],
        "reference solutions: their outcome, and the time of the first arrest or exit, s",
    ),
    (
        &["uncertainty", "reference_uncertainty"],
        "relative uncertainty of a reference; smaller errors are not known",
    ),
    (&["printed_scheme_off"], "relative error of the printed scheme in the limit of small steps"),
    (
        &["part", "with_s", "without_s"],
        "omitted part of the model, and the run time with and without it, s",
    ),
    (
        &["stiffness_ratio"],
        "contact time over the shortest time scale of spring and damper at the first arrest",
    ),
    (&["greatest_estimate"], "greatest error estimate of all results of the run"),
    (&["changes"], "changes to the baseline that make the scene, as `--set` takes them"),
    (
        &["shortfall", "short"],
        "requirement that a row misses, null if it passes; short: the number of such rows",
    ),
    (&["why_hard"], "why a scene is hard to integrate"),
    (&["cell", "cells"], "marks of a map, by row: one letter for each step size"),
    (&["present"], "value of the variable and step size of the scene in a map"),
    // Reproduction.
    (&["id"], "permanent short name of a statement of the thesis"),
    (&["where"], "section, table or figure of the thesis"),
    (&["as_printed"], "value by the scheme of the thesis as printed"),
];
