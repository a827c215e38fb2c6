//! Reader of the further elements of a stack, `[[stack.layer]]`: each has the values of the scene except its own keys.

use toml::Spanned;
use toml::de::DeValue;

use crate::files::reader::{Reader, kind_of};
use cmra_engine::model::scene::{LAYERS_MAX, Layer, Scene};

/// Key of the list.
pub(super) const KEY: &str = "stack.layer";
const TABLES: [&str; 3] = ["target", "plate", "mechanism"];

/// Reads the elements in a list of tables; `scene` has their default values.
pub(super) fn layers(
    reader: &mut Reader<'_>,
    scene: &Scene,
    value: &Spanned<DeValue<'_>>,
) -> Vec<Layer> {
    let DeValue::Array(list) = value.get_ref() else {
        let text = format!(
            "{KEY} is {}: it is a list of tables; write [[{KEY}]] above each element",
            kind_of(value.get_ref())
        );
        reader.problem(value.span(), text);
        return Vec::new();
    };
    if list.len() > LAYERS_MAX {
        let text = format!(
            "{KEY} has {} elements: at most {LAYERS_MAX} are read; use stack.elements for equal ones",
            list.len()
        );
        reader.problem(value.span(), text);
        return Vec::new();
    }
    let mut layers = Vec::new();
    for row in list {
        if reader.is_full() {
            break;
        }
        let DeValue::Table(table) = row.get_ref() else {
            let text = format!(
                "{KEY} has {} among its elements: write [[{KEY}]] above each element",
                kind_of(row.get_ref())
            );
            reader.problem(row.span(), text);
            continue;
        };
        reader.one_size(table);
        let mut own = scene.clone();
        for (key, value) in table {
            let name = key.get_ref().as_ref();
            if TABLES.contains(&name) {
                reader.entry(&mut own, name, key.span(), value);
            } else {
                let text = format!(
                    "`{KEY}.{name}` is not a key of a scene: an element has keys of {}, for example target.thickness_m = 0.006",
                    TABLES.join(", ")
                );
                reader.problem(key.span(), text);
            }
        }
        layers.push(Layer { target: own.target, plate: own.plate, mechanism: own.mechanism });
    }
    layers
}
