//! The program's own log: to a file in the state directory and to the Log tab, never to the screen.
//!
//! `CMRA_LOG` sets the level: `off`, `error`, `warn` (the default), `info`, `debug`, `trace`. The file is made when
//! there is something to write. When it has grown large it becomes `cmra.log.old` at the next start.

use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::mpsc::Sender;
use std::time::{SystemTime, UNIX_EPOCH};

use log::{LevelFilter, Log, Metadata, Record};

use super::Incoming;
use crate::tui::message::Message;

/// Size at which a log is backed up, bytes.
const SIZE_MAX: u64 = 1 << 20;

/// Log from now on to `file`, and to the loop. A word in `level` that is none is reported as a warning.
pub(super) fn install(file: Option<PathBuf>, level: Option<&str>, inbox: Sender<Incoming>) {
    let chosen = level.unwrap_or("warn").parse::<LevelFilter>();
    let sink = Sink { path: file, file: OnceLock::new(), inbox };
    // A second workbench in one process (a test) keeps the first one's log.
    if log::set_boxed_logger(Box::new(sink)).is_ok() {
        log::set_max_level(*chosen.as_ref().unwrap_or(&LevelFilter::Warn));
    }
    if chosen.is_err() {
        log::warn!(
            "CMRA_LOG = `{}` is not a level: use off, error, warn, info, debug or trace",
            level.unwrap_or_default()
        );
    }
}

struct Sink {
    path: Option<PathBuf>,
    /// Opened for the first line; `None` where it cannot be.
    file: OnceLock<Option<File>>,
    inbox: Sender<Incoming>,
}

impl Sink {
    /// Add a line to the file. One that cannot be written has nowhere to say so; the Log tab still has it.
    fn write(&self, line: &str) {
        let file = self.file.get_or_init(|| open(self.path.as_deref()?).ok());
        if let Some(mut file) = file.as_ref() {
            let _ = file.write_all(line.as_bytes());
        }
    }
}

impl Log for Sink {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        // Only this program's own lines: others know nothing a person here could act on.
        metadata.target().starts_with("cmra") && metadata.level() <= log::max_level()
    }

    fn log(&self, record: &Record<'_>) {
        if !self.enabled(record.metadata()) {
            return;
        }
        let text = record.args().to_string();
        self.write(&line(SystemTime::now(), record, &text));
        // The loop may be over already.
        let _ = self.inbox.send(Incoming::Message(Message::Logged(record.level(), text)));
    }

    fn flush(&self) {}
}

fn open(path: &Path) -> std::io::Result<File> {
    if let Some(directory) = path.parent() {
        fs::create_dir_all(directory)?;
    }
    let found = fs::metadata(path).ok();
    if found.as_ref().is_some_and(|found| !found.is_file()) {
        // A pipe would be waited for.
        return Err(std::io::ErrorKind::InvalidInput.into());
    }
    if found.is_some_and(|found| found.len() > SIZE_MAX) {
        let mut old = path.as_os_str().to_owned();
        old.push(".old");
        fs::rename(path, old)?;
    }
    OpenOptions::new().create(true).append(true).open(path)
}

/// One line of the file: seconds since 1970, level, where, what.
fn line(now: SystemTime, record: &Record<'_>, text: &str) -> String {
    let since = now.duration_since(UNIX_EPOCH).unwrap_or_default();
    format!(
        "{}.{:03} {:5} {} {text}\n",
        since.as_secs(),
        since.subsec_millis(),
        record.level(),
        record.target()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_large_log_is_put_aside_and_a_small_one_is_continued() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("state/cmra.log");
        let write = |text: &str| {
            let (inbox, _) = std::sync::mpsc::channel();
            let sink = Sink { path: Some(path.clone()), file: OnceLock::new(), inbox };
            sink.write(text);
            sink.write("more\n");
        };
        write("one\n");
        write("two\n");
        assert_eq!(fs::read_to_string(&path).unwrap(), "one\nmore\ntwo\nmore\n");
        let large = "x".repeat(usize::try_from(SIZE_MAX).unwrap() + 1);
        write(&large);
        write("three\n");
        assert_eq!(fs::read_to_string(&path).unwrap(), "three\nmore\n");
        assert!(path.with_extension("log.old").exists());
    }

    #[test]
    fn a_line_has_time_level_place_and_text() {
        let record = Record::builder()
            .level(log::Level::Warn)
            .target("cmra::worker")
            .args(format_args!("careful"))
            .build();
        let now = UNIX_EPOCH + std::time::Duration::from_millis(1_002_003);
        assert_eq!(line(now, &record, "careful"), "1002.003 WARN  cmra::worker careful\n");
    }

    #[test]
    fn a_log_that_cannot_be_opened_is_not_an_error() {
        let place = tempfile::tempdir().unwrap();
        let in_the_way = place.path().join("file");
        fs::write(&in_the_way, "").unwrap();
        let (inbox, _) = std::sync::mpsc::channel();
        let sink = Sink { path: Some(in_the_way.join("cmra.log")), file: OnceLock::new(), inbox };
        sink.write("lost\n");
        assert!(matches!(sink.file.get(), Some(None)));
    }
}
