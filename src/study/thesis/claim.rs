//! The claims as the file has them, with every name in them resolved.

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;

use crate::model::scene::Scene;
use crate::model::units::Bare;
use crate::model::variables::{self, Value};
use crate::study::thesis::expression::{Expression, Parser};
use crate::study::thesis::text::Template;
use crate::study::thesis::{Opens, Verdict};

/// A claim of the thesis. Claims live as long as the program, and so do their texts.
pub struct Claim {
    /// A short name that stays: rows are compared by it.
    pub id: &'static str,
    /// Where it stands.
    pub place: &'static str,
    /// What it says, in other words.
    pub says: &'static str,
    /// Why the verdict is what it is, in one sentence.
    pub cause: &'static str,
    /// The verdict that is expected.
    pub expected: Verdict,
    /// What shows it.
    pub opens: Opens,
    pub(super) check: Check,
}

/// How a claim is checked.
pub(super) struct Check {
    /// Values by their names.
    pub values: BTreeMap<String, Expression>,
    /// What is said of the engine's results, if anything.
    pub computed: Option<Template>,
    /// What is said of the Appendix's results, if anything.
    pub as_printed: Option<Template>,
    /// The texts are those of the value `curve`, which is judged for both.
    pub is_trend: bool,
    /// The first text was read in the thesis, and so was the verdict.
    pub is_read: bool,
    /// What decides on the verdict, the first first.
    pub conditions: Vec<(Verdict, Expression)>,
}

impl fmt::Debug for Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "claim {}", self.id)
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    scenes: BTreeMap<String, BTreeMap<String, toml::Value>>,
    claim: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    id: String,
    place: String,
    says: String,
    cause: String,
    verdict: String,
    preset: Option<String>,
    scene: Option<String>,
    #[serde(default)]
    values: BTreeMap<String, String>,
    computed: Option<String>,
    as_printed: Option<String>,
    both: Option<String>,
    trend: Option<String>,
    read: Option<String>,
    reproduced: Option<String>,
    corrected: Option<String>,
    misprint: Option<String>,
    holds: Option<String>,
}

/// The claims of a file, and the scenes they are checked on.
#[derive(Default)]
pub(super) struct Claims {
    pub scenes: BTreeMap<String, Scene>,
    pub all: Vec<Claim>,
}

/// Reads the claims of a file.
///
/// # Errors
/// Names the claim and what is wrong with it.
pub(super) fn read(text: &str) -> Result<Claims, String> {
    let file: File = toml::from_str(text).map_err(|error| error.to_string())?;
    let scenes = file
        .scenes
        .into_iter()
        .map(|(name, settings)| {
            let scene = scene_of(settings).map_err(|error| format!("scene {name}: {error}"))?;
            Ok((name, scene))
        })
        .collect::<Result<BTreeMap<_, _>, String>>()?;
    let claim = |entry: Entry| {
        let id = entry.id.clone();
        entry.claim(&scenes).map_err(|error| format!("claim {id}: {error}"))
    };
    let all = file.claim.into_iter().map(claim).collect::<Result<_, _>>()?;
    Ok(Claims { scenes, all })
}

/// The thesis's scene with variables changed: numbers in SI units, words as `--set` takes them.
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

impl Entry {
    fn claim(self, scenes: &BTreeMap<String, Scene>) -> Result<Claim, String> {
        let opens = match (self.preset, self.scene) {
            (Some(_), Some(_)) => return Err("it opens a preset or a scene, not both".to_owned()),
            (Some(preset), None) => Opens::Preset(preset.leak()),
            (None, Some(name)) => {
                let scene = scenes.get(&name).ok_or_else(|| format!("`{name}` is no scene"))?;
                Opens::Scene(Box::leak(Box::new(scene.clone())))
            }
            (None, None) => Opens::Nothing,
        };
        let expected = Verdict::ALL.into_iter().find(|it| it.words() == self.verdict);
        let expected = expected.ok_or_else(|| format!("`{}` is no verdict", self.verdict))?;
        let is_trend = self.trend.is_some();
        let mut texts = self.values;
        texts.extend(self.trend.map(|curve| ("curve".to_owned(), curve)));
        let mut parser = Parser::new(scenes);
        let values = in_order(texts, &mut parser)?;
        let template = |text: Option<String>, parser: &mut Parser<'_>| {
            text.map(|text| Template::parse(&text, parser)).transpose()
        };
        let is_read = self.read.is_some();
        let computed =
            template(self.read.or(self.computed).or_else(|| self.both.clone()), &mut parser)?;
        let as_printed = template(self.as_printed.or(self.both), &mut parser)?;
        let conditions = [
            (Verdict::Reproduced, self.reproduced),
            (Verdict::TrendHolds, self.holds),
            (Verdict::Corrected, self.corrected),
            (Verdict::Misprint, self.misprint),
        ];
        let conditions = conditions
            .into_iter()
            .filter_map(|(verdict, text)| Some((verdict, text?)))
            .map(|(verdict, text)| Ok((verdict, parser.parse(&text)?)))
            .collect::<Result<Vec<_>, String>>()?;
        if let Some(name) = parser.names.iter().find(|name| !values.contains_key(*name)) {
            return Err(format!("`{name}` is no value of this claim"));
        }
        let check = Check { values, computed, as_printed, is_trend, is_read, conditions };
        let Self { id, place, says, cause, .. } = self;
        let [id, place, says, cause] = [id, place, says, cause].map(|text| &*text.leak());
        Ok(Claim { id, place, says, cause, expected, opens, check })
    }
}

/// Parses values, each of which may name others, but none itself.
fn in_order(
    texts: BTreeMap<String, String>,
    parser: &mut Parser<'_>,
) -> Result<BTreeMap<String, Expression>, String> {
    let mut waiting = Vec::new();
    for (name, text) in texts {
        parser.names.clear();
        let expression = parser.parse(&text)?;
        waiting.push((name, expression, std::mem::take(&mut parser.names)));
    }
    let mut values = BTreeMap::new();
    loop {
        let before = waiting.len();
        let (ready, later): (Vec<_>, Vec<_>) = waiting
            .into_iter()
            .partition(|(_, _, needs)| needs.iter().all(|name| values.contains_key(name)));
        values.extend(ready.into_iter().map(|(name, expression, _)| (name, expression)));
        waiting = later;
        match waiting.first() {
            None => return Ok(values),
            Some((name, _, needs)) if waiting.len() == before => {
                return Err(format!(
                    "the value `{name}` needs {}, one of which is none or needs `{name}`",
                    needs.join(", ")
                ));
            }
            Some(_) => {}
        }
    }
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
        read(text).err().unwrap_or_default()
    }

    #[test]
    fn a_wrong_name_is_refused_by_name() {
        assert_eq!(
            read(&format!("{CLAIM}computed = \"{{depth(rigid) | mm}}\"")).unwrap().all.len(),
            1
        );
        for (wrong, named) in [
            ("compute = \"1\"", "compute"),
            ("computed = \"{dept(rigid)}\"", "`dept`"),
            ("computed = \"{depth(rigit)}\"", "`rigit`"),
            ("computed = \"{depth(rigid, gama=2)}\"", "gama"),
            ("computed = \"{depth() | kg}\"", "`kg`"),
            ("computed = \"{other}\"", "`other`"),
            ("computed = \"{near(1, 2)}\"", "3 arguments"),
            ("computed = \"{1 + }\"", "missing at the end"),
            ("values.a = \"b\"\nvalues.b = \"a\"", "`a`"),
            ("preset = \"a\"\nscene = \"rigid\"", "not both"),
            ("scene = \"a\"", "`a` is no scene"),
        ] {
            let problem = refusal(&format!("{CLAIM}{wrong}"));
            assert!(problem.contains(named), "{wrong}: {problem}");
        }
        let other = CLAIM.replace("reproduced", "right");
        assert!(refusal(&other).contains("claim one: `right` is no verdict"));
        let other = CLAIM.replace("mount = \"rigid\"", "m_p = -1");
        assert!(refusal(&other).contains("scene rigid: m_p"));
    }
}
