//! Messages to the person: the message row shows the newest, the Log tab keeps them all.

/// How serious a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Good to know.
    Note,
    /// Legal, yet worth a second look.
    Warning,
    /// It did not work.
    Error,
}

impl Severity {
    /// The mark in front of the text; colour is never the only channel.
    pub fn mark(self) -> &'static str {
        match self {
            Self::Note => " ",
            Self::Warning => "!",
            Self::Error => "x",
        }
    }

    /// The word in the Log tab.
    pub fn word(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// One message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// How serious.
    pub severity: Severity,
    /// One line of text.
    pub text: String,
}
