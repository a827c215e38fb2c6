//! The presets that come with the program, compiled in. A test lists `presets/` and holds this table to it.

/// A bundled preset: its name, and the text of its file.
pub type Bundled = (&'static str, &'static str);

macro_rules! bundled {
    ($($name:literal),+ $(,)?) => {
        &[$(($name, include_str!(concat!("../../presets/", $name, ".toml")))),+]
    };
}

/// The scene the workbench opens on, and what `cmra run` takes without a scene.
pub const BASELINE: &str = "thesis-baseline";

/// Every bundled preset, in the order of lists: the thesis first, then what lies beyond it.
pub static BUNDLED: &[Bundled] = bundled![
    "thesis-baseline",
    "rigid-mount",
    "free-plate",
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

/// The bundled preset with this name.
pub fn find(name: &str) -> Option<Bundled> {
    BUNDLED.iter().copied().find(|preset| preset.0 == name)
}
