//! Words of studies, of methods and their errors, of the thesis, and of the workbench.

use super::Entry;

/// Words of studies and screens.
pub(super) const WORDS: &[Entry] = &[
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
        "a design without a new warning on the unsafe side (interface, spring, stop, face)",
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
    (
        &["normal", "lognormal", "uniform"],
        "distributions of `cmra montecarlo`: about the scene's own value as the mean with a standard deviation; about it as the median with a \
         standard deviation of the natural logarithm; between two values",
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
        &["omitted", "omitted terms"],
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
        &["largest error"],
        "largest error estimate of all results of a run, and the result that has it",
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
    (&["omitted_rows"], "points of a measured trace at times when the run has no value"),
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
    (&["base plate"], "the last plate of a stack, behind its elements (h_base)"),
    (&["contact/whole", "whole"], "the contact alone, or the whole motion of the plate"),
    (
        &["scale", "log", "linear"],
        "spacing of an axis: equal steps for equal differences (linear) or for equal ratios (log)",
    ),
    (&["view"], "another way to show the same results"),
    (&["symbol"], "short name of a variable, as `--set` takes it"),
    (&["rows"], "number of measurements, or of points of a sweep"),
    (&["name in files", "key"], "name in scene files, CSV and JSON"),
    (&["rigid mount"], "a plate of the same material that cannot move"),
    (&["free plate"], "the scene's plate without spring, damper and stop"),
    (
        &["solid", "solid plate"],
        "a plate of the same material without a mechanism, to which mass efficiency refers",
    ),
    (
        &["slices", "slices through the cursor"],
        "curves along both axes of a map, through the crosshair",
    ),
];
