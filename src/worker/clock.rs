//! Clocks: elapsed time of tasks, and processor time for the comparison of methods.

use std::sync::Arc;
use std::time::{Duration, Instant};

use rustix::time::{ClockId, clock_gettime};

/// Function that returns the time since a fixed instant. Tests pass a clock that they advance themselves.
pub type Clock = Arc<dyn Fn() -> Duration + Send + Sync>;

/// Returns a clock that starts now.
pub fn wall() -> Clock {
    let start = Instant::now();
    Arc::new(move || start.elapsed())
}

/// Returns the processor time of this thread, s. Other programs on a busy machine do not increase it, unlike elapsed time.
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
