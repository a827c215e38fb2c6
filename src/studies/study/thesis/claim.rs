//! The claims as the file has them.

use std::collections::BTreeMap;

use serde::{Deserialize, Deserializer, de::Error};

use crate::model::scene::Scene;
use crate::model::units::Bare;
use crate::model::variables::{self, Value};
use crate::study::thesis::{ClaimVerdict, Opens};

/// The name of a trend's curve in its conditions.
pub(super) const CURVE: &str = "curve";

/// A claim of the thesis: an entry of the file, whose head says what each part means. Claims live as long as the program.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// A short name that stays: rows are compared by it.
    pub id: &'static str,
    /// Where it stands.
    pub place: &'static str,
    /// Its statement, in other words.
    pub says: &'static str,
    /// Why the verdict is what it is, in one sentence.
    pub cause: &'static str,
    /// The verdict that is expected.
    #[serde(rename = "verdict", deserialize_with = "verdict")]
    pub expected: ClaimVerdict,
    preset: Option<&'static str>,
    scene: Option<&'static str>,
    #[serde(default)]
    values: BTreeMap<&'static str, &'static str>,
    pub(super) computed: Option<&'static str>,
    pub(super) as_printed: Option<&'static str>,
    pub(super) both: Option<&'static str>,
    pub(super) trend: Option<&'static str>,
    pub(super) read: Option<&'static str>,
    reproduced: Option<&'static str>,
    corrected: Option<&'static str>,
    misprint: Option<&'static str>,
    holds: Option<&'static str>,
}

fn verdict<'de, D: Deserializer<'de>>(word: D) -> Result<ClaimVerdict, D::Error> {
    let word = <&str>::deserialize(word)?;
    let found = ClaimVerdict::ALL.into_iter().find(|it| it.words() == word);
    found.ok_or_else(|| D::Error::custom(format!("`{word}` is no verdict")))
}

impl Claim {
    /// The evidence for it.
    pub fn opens(&self) -> Opens {
        let scene = || self.scene.and_then(super::scene).map(Opens::Scene);
        self.preset.map(Opens::Preset).or_else(scene).unwrap_or(Opens::Nothing)
    }

    /// The rules of the verdict, in order.
    pub(super) fn conditions(&self) -> impl Iterator<Item = (ClaimVerdict, &'static str)> {
        let all = [
            (ClaimVerdict::Reproduced, self.reproduced),
            (ClaimVerdict::TrendHolds, self.holds),
            (ClaimVerdict::Corrected, self.corrected),
            (ClaimVerdict::Misprint, self.misprint),
        ];
        all.into_iter().filter_map(|(verdict, text)| Some((verdict, text?)))
    }

    /// The expression of one of its values.
    pub(super) fn value(&self, name: &str) -> Option<&'static str> {
        self.values.get(name).copied().or_else(|| self.trend.filter(|_| name == CURVE))
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, bound(deserialize = "'de: 'static"))]
struct File {
    scenes: BTreeMap<String, BTreeMap<String, toml::Value>>,
    claim: Vec<Claim>,
}

/// Scenes and claims of the file.
#[derive(Default)]
pub(super) struct Claims {
    pub scenes: BTreeMap<String, Scene>,
    pub all: Vec<Claim>,
}

/// Reads the file.
pub(super) fn read(text: &'static str) -> Result<Claims, String> {
    let file: File = toml::from_str(text).map_err(|error| error.to_string())?;
    let scenes = file
        .scenes
        .into_iter()
        .map(|(name, settings)| {
            let scene = scene_of(settings).map_err(|error| format!("scene {name}: {error}"))?;
            Ok((name, scene))
        })
        .collect::<Result<BTreeMap<_, _>, String>>()?;
    for claim in &file.claim {
        let problem = match (claim.preset, claim.scene) {
            (Some(_), Some(_)) => "it opens a preset or a scene, not both".to_owned(),
            (None, Some(name)) if !scenes.contains_key(name) => format!("`{name}` is no scene"),
            (_, None) | (None, Some(_)) => continue,
        };
        return Err(format!("claim {}: {problem}", claim.id));
    }
    Ok(Claims { scenes, all: file.claim })
}

fn scene_of(settings: BTreeMap<String, toml::Value>) -> Result<Scene, String> {
    let mut scene = Scene::default();
    for (name, value) in settings {
        let set = match value {
            toml::Value::Float(number) => set(&mut scene, &name, number),
            toml::Value::Integer(number) => set(&mut scene, &name, number as f64),
            toml::Value::String(word) => variables::set_by_name(&mut scene, &name, &word, Bare::Si)
                .map_err(|error| error.to_string()),
            other => Err(format!("{name} = {other} is neither a number nor a word")),
        };
        set?;
    }
    variables::validate(&scene).map_err(|error| error.to_string())?;
    Ok(scene)
}

fn set(scene: &mut Scene, name: &str, number: f64) -> Result<(), String> {
    let set = variables::find(name).and_then(|it| it.set(scene, Value::Number(number)));
    set.map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLAIM: &str = r#"
[scenes]
rigid = { mount = "rigid" }
[[claim]]
id = "one"
place = "1.1"
says = "it is deep"
cause = "so it is"
verdict = "reproduced"
"#;

    fn refusal(text: &str) -> String {
        read(text.to_owned().leak()).err().unwrap_or_default()
    }

    #[test]
    fn a_wrong_name_is_refused_by_name() {
        for (wrong, named) in [
            ("compute = \"1\"", "compute"),
            ("preset = \"a\"\nscene = \"rigid\"", "not both"),
            ("scene = \"a\"", "`a` is no scene"),
        ] {
            let problem = refusal(&format!("{CLAIM}{wrong}"));
            assert!(problem.contains(named), "{wrong}: {problem}");
        }
        let other = CLAIM.replace("reproduced", "right");
        assert!(refusal(&other).contains("`right` is no verdict"));
        let other = CLAIM.replace("mount = \"rigid\"", "m_p = -1");
        assert!(refusal(&other).contains("scene rigid: m_p"));
    }
}
