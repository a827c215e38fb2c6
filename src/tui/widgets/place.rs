//! Text of a position on a chart or a map: axis values by name, `n 0.5`, `n=0.5 k=1MN/m`, or the value of the first axis alone.

/// Splits a text into the values of the named axes; `None` for an axis that is not named.
fn written(text: &str, names: &[&str]) -> Vec<Option<String>> {
    let mut found: Vec<Option<String>> = vec![None; names.len()];
    let mut axis = 0;
    for word in text.split(['=', ',', ' ', '\t']).filter(|word| !word.is_empty()) {
        if let Some(named) = names.iter().position(|name| *name == word) {
            axis = named;
        } else if let Some(value) = found.get_mut(axis) {
            let before = value.take().map_or_else(String::new, |before| before + " ");
            *value = Some(before + word);
        }
    }
    found
}

/// Parses the values of a position on the named axes; errors describe the notation.
pub(crate) fn values(
    text: &str,
    names: &[&str],
    read: impl Fn(usize, &str) -> Result<f64, String>,
) -> Result<Vec<Option<f64>>, String> {
    let found = written(text, names);
    if found.iter().all(Option::is_none) {
        let name = names.first().unwrap_or(&"");
        return Err(format!("`{text}` has no value: write for example `{name} 1`"));
    }
    let value = |(axis, text): (usize, Option<String>)| {
        let Some(text) = text else { return Ok(None) };
        let refused = |error| format!("{}: {error}; axes here: {}", names[axis], names.join(", "));
        read(axis, &text).map(Some).map_err(refused)
    };
    found.into_iter().enumerate().map(value).collect()
}

/// Rejects a value outside its axis.
pub(crate) fn on_axis(
    name: &str,
    value: f64,
    ends: (f64, f64),
    show: impl Fn(f64) -> String,
) -> Result<f64, String> {
    let (low, high) = (ends.0.min(ends.1), ends.0.max(ends.1));
    // The ends are displayed with fewer digits than stored.
    let slack = 1e-6 * (high - low);
    if (low - slack..=high + slack).contains(&value) {
        return Ok(value);
    }
    let [value, low, high] = [value, low, high].map(show);
    Err(format!("{name} {value} is not on the axis: it goes from {low} to {high}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_has_values_by_name_or_the_first_ones_alone() {
        let read =
            |_: usize, text: &str| text.parse::<f64>().ok().ok_or_else(|| format!("`{text}`?"));
        let at = |text: &str| values(text, &["n", "k"], read);
        for text in ["n 0.5", "n=0.5", "0.5", "n = 0.5"] {
            assert_eq!(at(text), Ok(vec![Some(0.5), None]), "{text}");
        }
        for text in ["n 0.5 k 1e6", "k=1e6, n=0.5", "0.5 k 1e6", "k 1e6 n 0.5"] {
            assert_eq!(at(text), Ok(vec![Some(0.5), Some(1e6)]), "{text}");
        }
        assert_eq!(at("h 5"), Err("n: `h 5`?; axes here: n, k".to_owned()));
        assert_eq!(at("n"), Err("`n` has no value: write for example `n 1`".to_owned()));
    }
}
