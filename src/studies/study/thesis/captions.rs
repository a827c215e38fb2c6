//! Captions of the sensitivity plots: what each figure holds fixed.

/// Symbols and values, SI.
type Held = &'static [(&'static str, f64)];

/// The figures of section 9.3 by their presets.
const CAPTIONS: [(&str, Held); 11] = [
    ("figure-9.2", &[("k", 1e5), ("d", 0.0), ("n", 1.0), ("b", 0.0)]),
    ("figure-9.3", &[("k", 1e5), ("n", 1.0), ("gamma", 1.0), ("b", 0.0)]),
    ("figure-9.4", &[("k", 0.0), ("d", 0.0), ("n", 1.0), ("gamma", 1.0)]),
    ("figure-9.5", &[("b", 0.0), ("d", 0.0), ("n", 1.0), ("gamma", 1.0)]),
    ("figure-9.6", &[("b", 0.0), ("d", 0.0), ("gamma", 1.0), ("k", 1e5)]),
    ("figure-9.7", &[("b", 0.0), ("d", 0.0), ("n", 1.0)]),
    ("figure-9.8", &[("b", 0.0), ("d", 0.0), ("k", 1e5)]),
    ("figure-9.9", &[("b", 0.0), ("d", 0.0), ("gamma", 1.0)]),
    ("figure-9.10", &[("b", 0.0), ("k", 1e5), ("n", 1.0)]),
    ("figure-9.11", &[("b", 0.0), ("n", 1.0), ("gamma", 1.0)]),
    ("figure-9.12", &[("b", 0.0), ("k", 1e5), ("gamma", 1.0)]),
];

/// Returns what the caption of a preset's figure holds fixed; empty for other presets.
pub fn caption(preset: &str) -> Held {
    CAPTIONS.iter().find(|caption| caption.0 == preset).map_or(&[], |caption| caption.1)
}
