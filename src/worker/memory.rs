//! Memory that the C library keeps for later is given back to the system.
//!
//! GNU's C library keeps what a thread has freed between pieces still in use: in an hour of searches and sweeps the process would
//! grow to ten times of what it holds. No other library at hand does so.

/// Give back every free page, of all threads: a millisecond for a heap of 100 MB.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[expect(unsafe_code, reason = "a call of the C library, which no crate wraps")]
pub(super) fn give_back() {
    // SAFETY: it takes the locks of the heap by itself, and what is in use stays where it is.
    unsafe {
        libc::malloc_trim(0);
    }
}

/// Nothing to do: these heaps do not grow so.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
pub(super) fn give_back() {}
