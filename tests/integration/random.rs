//! Random scenes, fused and without a stop, over the ranges of ordinary and demanding work: shared by the tests that compare
//! ways to compute the same thing.

use std::sync::Arc;

use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables;

/// `SplitMix64`: Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Uniform on [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A whole number below this one.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        let share = self.unit();
        (0..end).rfind(|index| *index as f64 <= share * end as f64).unwrap_or(0)
    }

    /// Between two positive numbers, evenly in the logarithm.
    pub(crate) fn log(&mut self, low: f64, high: f64) -> f64 {
        let value = low * (high / low).powf(self.unit());
        format!("{value:.4e}").parse().unwrap()
    }

    /// Zero with a chance, else as `log`.
    pub(crate) fn log_or_zero(&mut self, chance: f64, low: f64, high: f64) -> f64 {
        if self.unit() < chance { 0.0 } else { self.log(low, high) }
    }

    /// Draws an element of a list.
    pub(crate) fn of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }

    fn exponent(&mut self, low: f64, high: f64) -> f64 {
        if self.unit() < 0.4 { self.of(&[0.5, 1.0, 1.5, 2.0, 3.0]) } else { self.log(low, high) }
    }

    /// A scene over the ranges of ordinary and demanding work, as the changes a person would type.
    pub(crate) fn changes(&mut self) -> Vec<(&'static str, f64)> {
        let theta = if self.unit() < 0.8 { 0.0 } else { 60.0 * self.unit() };
        vec![
            ("n", self.exponent(0.2, 4.0)),
            ("m", self.exponent(0.5, 3.0)),
            ("k", self.log_or_zero(0.1, 1e2, 1e9)),
            ("b", self.log_or_zero(0.4, 1.0, 1e5)),
            ("d", self.log_or_zero(0.5, 1e-5, 0.5)),
            ("gamma", self.log(0.05, 100.0)),
            ("v_i", self.log(5.0, 1.5e3)),
            ("h", self.log(1e-3, 0.1)),
            ("theta", theta.to_radians()),
            ("S_y", self.log(1e7, 2e9)),
            ("C_d", self.log_or_zero(0.1, 0.05, 2.0)),
            ("run.tolerance", self.log(1e-12, 1e-4)),
        ]
    }
}

/// The scene with these changes.
pub(crate) fn scene(changes: &[(&'static str, f64)]) -> Arc<Scene> {
    let mut scene = Scene::default();
    for (name, value) in changes {
        variables::set_by_name(&mut scene, name, &word(name, *value)).unwrap();
    }
    Arc::new(scene)
}

/// A value as it is typed: an angle has its unit.
fn word(name: &str, value: f64) -> String {
    let unit = if name == "theta" { " rad" } else { "" };
    format!("{value:e}{unit}")
}

/// The changes as they are typed behind `cmra run`.
pub(crate) fn typed(changes: &[(&'static str, f64)]) -> String {
    let words: Vec<String> = changes
        .iter()
        .map(|(name, value)| format!("--set '{name}={}'", word(name, *value)))
        .collect();
    words.join(" ")
}
