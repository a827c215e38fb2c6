//! Configuration of the workbench (keys, colours, characters): `config.toml` in the configuration folder.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Deserializer};

use crate::files::error::FileError;
use crate::files::read;

/// Contents of the configuration file; every key is optional.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(deny_unknown_fields, default)]
pub struct Config {
    /// Characters of the charts: `auto`, `ascii`, `block` or `braille`.
    #[serde(deserialize_with = "characters")]
    pub characters: Option<String>,
    /// Number of colours: `none`, `sixteen`, `256` or `full`.
    #[serde(deserialize_with = "colours")]
    pub colours: Option<String>,
    /// Keys by the names of actions: `undo = "U"` or `undo = ["u", "U"]`; help shows the first one.
    #[serde(deserialize_with = "lists")]
    pub keys: BTreeMap<String, Vec<String>>,
}

/// Deserialises the name of a character set.
fn characters<'de, D: Deserializer<'de>>(file: D) -> Result<Option<String>, D::Error> {
    word(file, "write characters = \"auto\", \"ascii\", \"block\" or \"braille\", above all tables")
}

/// Deserialises a number of colours.
fn colours<'de, D: Deserializer<'de>>(file: D) -> Result<Option<String>, D::Error> {
    word(file, "write colours = \"none\", \"sixteen\", \"256\" or \"full\", above all tables")
}

fn word<'de, D: Deserializer<'de>>(file: D, cure: &str) -> Result<Option<String>, D::Error> {
    match toml::Value::deserialize(file)? {
        toml::Value::String(word) => Ok(Some(word)),
        // 256 without quotes.
        toml::Value::Integer(number) => Ok(Some(number.to_string())),
        _ => Err(serde::de::Error::custom(cure)),
    }
}

/// Deserialises one key or a list of keys for each name.
fn lists<'de, D: Deserializer<'de>>(file: D) -> Result<BTreeMap<String, Vec<String>>, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged, expecting = "write a key, \"U\", or several, [\"u\", \"U\"]")]
    enum Keys {
        One(String),
        Several(Vec<String>),
    }
    let list = |keys| match keys {
        Keys::One(key) => vec![key],
        Keys::Several(keys) => keys,
    };
    let keys: BTreeMap<String, Keys> = Deserialize::deserialize(file)?;
    Ok(keys.into_iter().map(|(name, keys)| (name, list(keys))).collect())
}

/// Reads the configuration; empty if there is no file.
pub fn load(path: &Path) -> Result<Config, String> {
    let text = match read::text_file(path, read::BYTES_MAX) {
        Ok(text) => text,
        Err(FileError::Read { source, .. }) if source.kind() == std::io::ErrorKind::NotFound => {
            return Ok(Config::default());
        }
        Err(error) => return Err(error.to_string()),
    };
    toml::from_str(&text).map_err(|error| {
        let first = error.message().lines().next().unwrap_or_default().to_owned();
        let line = error.span().map_or(0, |span| text[..span.start].matches('\n').count() + 1);
        format!("{}, line {line}: {first}; the file is ignored", path.display())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A table in the place of a word, or a number without quotes.
    #[test]
    fn a_word_of_another_kind_gets_the_values() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("config.toml");
        let read = |text: &str| {
            std::fs::write(&path, text).unwrap();
            load(&path)
        };
        let refused = read("[colours]\nundo = \"U\"\n").unwrap_err();
        assert!(refused.contains("\"none\", \"sixteen\", \"256\" or \"full\""), "{refused}");
        assert!(read("characters = true\n").unwrap_err().contains("\"braille\""));
        assert_eq!(read("colours = 256\n").unwrap().colours.as_deref(), Some("256"));
    }

    #[test]
    fn a_configuration_is_read_and_missing_keys_are_empty() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("config.toml");
        assert_eq!(load(&path), Ok(Config::default()));
        let text = "characters = \"ascii\"\n[keys]\nundo = \"U\"\nrun = [\"r\", \"F5\"]\n";
        std::fs::write(&path, text).unwrap();
        let config = load(&path).unwrap();
        assert_eq!(config.characters.as_deref(), Some("ascii"));
        assert_eq!(config.keys["run"], ["r", "F5"]);
        std::fs::write(&path, "[keys]\nundo = 3\n").unwrap();
        let refused = load(&path).unwrap_err();
        assert!(refused.contains("line 2: write a key, \"U\""), "{refused}");
        std::fs::write(&path, "colour = \"none\"\n").unwrap();
        let refused = load(&path).unwrap_err();
        assert!(refused.contains("line 1") && refused.contains("colours"), "{refused}");
    }
}
