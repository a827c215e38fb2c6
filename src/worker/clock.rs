//! Clocks: elapsed time of tasks, and processor time for the comparison of methods.

use std::sync::Arc;
use std::time::{Duration, Instant};

pub use cmra_studies::study::context::Clock;
use rustix::time::{ClockId, clock_gettime};

/// Clocks of the worker. Tests pass clocks that they advance themselves.
#[derive(Clone)]
pub struct Clocks {
    /// Elapsed time.
    pub wall: Clock,
    /// Processor time of the calling thread.
    pub thread: Clock,
    /// Processor time of the process.
    pub process: Clock,
}

/// Returns the clocks of the system.
pub fn system() -> Clocks {
    Clocks {
        wall: wall(),
        thread: Arc::new(|| processor(ClockId::ThreadCPUTime)),
        process: Arc::new(|| processor(ClockId::ProcessCPUTime)),
    }
}

/// Returns a clock that starts now.
pub fn wall() -> Clock {
    let start = Instant::now();
    Arc::new(move || start.elapsed())
}

/// Returns the time of a clock that counts processor time.
fn processor(clock: ClockId) -> Duration {
    let time = clock_gettime(clock);
    let seconds = u64::try_from(time.tv_sec).unwrap_or(0);
    Duration::new(seconds, u32::try_from(time.tv_nsec).unwrap_or(0))
}

/// Returns the processor time of this thread, s. Other programs on a busy machine do not increase it, unlike elapsed time.
pub fn processor_s() -> f64 {
    processor(ClockId::ThreadCPUTime).as_secs_f64()
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
