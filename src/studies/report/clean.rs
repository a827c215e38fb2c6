//! Text from outside (files, names, arguments) on its way to a person: what would command a terminal, break a line, or show a line
//! in another order than it is written is replaced. The one place that decides what that is.

use std::borrow::Cow;

/// The replacement character.
const REPLACEMENT: &str = "\u{fffd}";

/// Removes line ends and control characters from a text.
pub fn line(text: &str) -> Cow<'_, str> {
    replaced(text, is_command)
}

/// A text of several lines, in the way of Unix or of Windows. What it is made of has been through `line` already where a line
/// end would mislead: here, its direction is not known.
pub fn page(text: &str) -> Cow<'_, str> {
    if text.contains('\r') {
        let lines: Vec<Cow<'_, str>> =
            text.split("\r\n").map(|part| replaced(part, is_no_layout)).collect();
        Cow::Owned(lines.join("\r\n"))
    } else {
        replaced(text, is_no_layout)
    }
}

/// A word of a command line as a shell reads it back, in quotes where it needs them.
pub fn shell_word(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=:,+@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

/// Control characters (of C0 and C1), line separators, and what changes the direction of the text after it.
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

    /// A title as of a scene file that wants something else than to be read.
    const HOSTILE: &str = "a\rb\nc\u{1b}[2Jd\u{9b}31me\u{202e}f\u{7f}g\u{2028}h\u{85}i\tj";

    #[test]
    fn a_line_stays_one_and_commands_nothing() {
        let cleaned = line(HOSTILE);
        assert_eq!(
            cleaned,
            "a\u{fffd}b\u{fffd}c\u{fffd}[2Jd\u{fffd}31me\u{fffd}f\u{fffd}g\u{fffd}h\u{fffd}i\u{fffd}j"
        );
        // What people write stays as it is.
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
