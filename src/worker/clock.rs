//! The clock of the tasks, and the one that methods are compared by.

use std::sync::Arc;
use std::time::{Duration, Instant};

use rustix::time::{ClockId, clock_gettime};

/// Gives the time since a moment of its own. Tests hand in one that moves as they want.
pub type Clock = Arc<dyn Fn() -> Duration + Send + Sync>;

/// The time since now.
pub fn wall() -> Clock {
    let start = Instant::now();
    Arc::new(move || start.elapsed())
}

/// The processor time that this thread has used, s. Unlike the time of day it stands still while other programs have the
/// processor, so that a method is not taken for a slow one on a busy machine.
pub fn processor_s() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Works until this thread has used so much processor time.
    fn use_up(seconds: f64) {
        let start = processor_s();
        while processor_s() - start < seconds {
            std::hint::spin_loop();
        }
    }

    #[test]
    fn it_counts_the_work_of_its_own_thread_only() {
        let start = processor_s();
        std::thread::spawn(|| use_up(0.1)).join().unwrap();
        assert!(processor_s() - start < 0.1, "that of another thread is counted");
        use_up(1e-3);
        assert!(processor_s() - start >= 1e-3);
    }
}
