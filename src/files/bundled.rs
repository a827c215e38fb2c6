//! Presets that are compiled into the program; a test compares the table with the folder `presets`.

/// Bundled preset: name and text of its file.
pub type Bundled = (&'static str, &'static str);

macro_rules! bundled {
    ($($name:literal),+ $(,)?) => {
        &[$(($name, include_str!(concat!("../../presets/", $name, ".toml")))),+]
    };
}

/// Default scene of the workbench and of `cmra run`.
pub const BASELINE: &str = "thesis-baseline";

/// Bundled presets in the order of lists: those of the thesis first.
pub static BUNDLED: &[Bundled] = bundled![
    "thesis-baseline",
    "rigid-mount",
    "free-plate",
    "figure-8.6",
    "figure-8.10",
    "figure-8.11",
    "figure-9.2",
    "figure-9.3",
    "figure-9.4",
    "figure-9.5",
    "figure-9.6",
    "figure-9.7",
    "figure-9.8",
    "figure-9.9",
    "figure-9.10",
    "figure-9.11",
    "figure-9.12",
    "appendix-listing",
    "yang-xi",
    "cocked",
    "cocked-plastic",
    "stop",
    "concept-emergent-four-bar",
    "concept-buckling-four-bar",
    "concept-buckling-cantilever",
    "concept-cocked-four-bar",
    "concept-cocked-cantilever",
    "concept-bistable-shuttle",
    "concept-buckling-tube",
    "concept-crushed-tube",
    "concept-helical-spring",
    "array-lateral",
    "array-stacked",
    "constant-force",
    "thin-plate-perforation",
    "oblique",
    "stiff-spring",
    "low-exponent",
    "overdamped",
    "validation-borvik",
    "validation-borvik-cavity",
    "validation-thin-sphere",
    "validation-ap-core",
    "validation-rod-6061",
    "validation-concrete",
];

/// Returns the bundled preset with a name.
pub fn find(name: &str) -> Option<Bundled> {
    BUNDLED.iter().copied().find(|preset| preset.0 == name)
}
