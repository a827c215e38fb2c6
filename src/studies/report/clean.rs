//! Sanitises external text (files, names, arguments) for display. Replaces characters that would control a terminal, break a line, or
//! change the reading direction. The only definition of such characters.

use std::borrow::Cow;

/// Replacement character.
const REPLACEMENT: &str = "\u{fffd}";

/// Removes line ends and control characters from a text.
pub fn line(text: &str) -> Cow<'_, str> {
    replaced(text, is_command)
}

/// Sanitises a text of several lines with Unix or Windows line ends. Use [`line()`] first for parts in which a line end would mislead.
pub fn page(text: &str) -> Cow<'_, str> {
    if text.contains('\r') {
        let lines: Vec<Cow<'_, str>> =
            text.split("\r\n").map(|part| replaced(part, is_no_layout)).collect();
        Cow::Owned(lines.join("\r\n"))
    } else {
        replaced(text, is_no_layout)
    }
}

/// Quotes a word for a shell command line if necessary.
pub fn shell_word(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=:,+@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

/// Returns `true` for control characters (C0 and C1), line separators, and characters that change the reading direction.
fn is_command(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

fn is_no_layout(c: char) -> bool {
    is_command(c) && !matches!(c, '\n' | '\t')
}

fn replaced(text: &str, unwanted: fn(char) -> bool) -> Cow<'_, str> {
    if text.contains(unwanted) {
        Cow::Owned(text.replace(unwanted, REPLACEMENT))
    } else {
        Cow::Borrowed(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Title of a malicious scene file.
    const HOSTILE: &str = "a\rb\nc\u{1b}[2Jd\u{9b}31me\u{202e}f\u{7f}g\u{2028}h\u{85}i\tj";

    #[test]
    fn a_line_stays_one_and_commands_nothing() {
        let cleaned = line(HOSTILE);
        assert_eq!(
            cleaned,
            "a\u{fffd}b\u{fffd}c\u{fffd}[2Jd\u{fffd}31me\u{fffd}f\u{fffd}g\u{fffd}h\u{fffd}i\u{fffd}j"
        );
        // Ordinary text is unchanged.
        for text in [
            "Ta\u{308}rget \u{2013} \u{3b3} = 1",
            "\u{65e5}\u{672c}",
            "\u{5e9}\u{5dc}\u{5d5}\u{5dd}",
        ] {
            assert!(matches!(line(text), Cow::Borrowed(same) if same == text));
        }
    }

    #[test]
    fn a_page_keeps_its_lines_of_either_kind() {
        assert_eq!(page("a\r\nb\tc\n"), "a\r\nb\tc\n");
        assert_eq!(page("a\rb\u{1b}\r\n"), "a\u{fffd}b\u{fffd}\r\n");
        assert_eq!(page("a\u{202e}b\n"), "a\u{fffd}b\n");
    }

    #[test]
    fn a_shell_reads_a_word_back() {
        let words = ["./a.toml", "a b", "it's", "$(rm x)", "a;b", "`c`", "", "-n"];
        for word in words {
            let told = format!("printf %s {}", shell_word(word));
            let out = std::process::Command::new("sh").args(["-c", &told]).output().unwrap();
            assert_eq!(String::from_utf8(out.stdout).unwrap(), word, "{told}");
        }
        assert_eq!(shell_word("./a.toml"), "./a.toml");
    }
}
