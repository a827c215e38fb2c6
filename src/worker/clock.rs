//! The clock that methods are compared by.

use rustix::time::{ClockId, clock_gettime};

/// The processor time that this thread has used, s. Unlike the time of day it stands still while other programs have the
/// processor, so that a method is not taken for a slow one on a busy machine.
pub fn processor_s() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_stands_still_while_the_thread_does_not_run() {
        let start = processor_s();
        let (_send, wait) = std::sync::mpsc::channel::<()>();
        assert!(wait.recv_timeout(std::time::Duration::from_millis(100)).is_err());
        let waited = processor_s() - start;
        assert!((0.0..0.05).contains(&waited), "{waited}");
        let mut sum = 0.0;
        while processor_s() - start < waited + 1e-3 {
            sum += 1.0;
        }
        assert!(sum > 0.0);
    }
}
