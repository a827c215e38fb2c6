//! The one integration test binary. Tests beside the code see its inside; these see what a user or a reader of the source sees.

#[cfg(test)]
mod accuracy;
#[cfg(test)]
mod charts;
#[cfg(test)]
mod cli;
#[cfg(test)]
mod compare;
#[cfg(test)]
mod crush;
#[cfg(test)]
mod decided;
#[cfg(test)]
mod estimate;
#[cfg(test)]
mod extremes;
#[cfg(test)]
mod facts;
#[cfg(test)]
mod files;
#[cfg(test)]
mod hostile;
#[cfg(test)]
mod identities;
#[cfg(test)]
mod keys;
#[cfg(test)]
mod kills;
#[cfg(test)]
mod libraries;
#[cfg(test)]
mod limit;
#[cfg(test)]
mod measured;
#[cfg(test)]
mod mechanisms;
#[cfg(test)]
mod models;
#[cfg(test)]
mod monte_carlo;
#[cfg(test)]
mod mount_loads;
#[cfg(test)]
mod optimise;
#[cfg(test)]
mod oracle;
#[cfg(test)]
mod outputs;
#[cfg(test)]
mod physics;
#[cfg(test)]
mod pictures;
#[cfg(test)]
mod plans;
#[cfg(test)]
mod presets;
#[cfg(test)]
mod progress;
#[cfg(test)]
mod pty;
#[cfg(test)]
mod quantities;
#[cfg(test)]
mod random;
#[cfg(test)]
mod readers;
#[cfg(test)]
mod readme;
#[cfg(test)]
mod screens;
#[cfg(test)]
mod seek;
#[cfg(test)]
mod sensitivity;
#[cfg(test)]
mod sequences;
#[cfg(test)]
mod singular_crossing;
#[cfg(test)]
mod soak;
#[cfg(test)]
mod stability;
#[cfg(test)]
mod stack;
#[cfg(test)]
mod studies;
#[cfg(test)]
mod support;
#[cfg(test)]
mod sweep;
#[cfg(test)]
mod terminal;
#[cfg(test)]
mod thesis;
#[cfg(test)]
mod tidy;
#[cfg(test)]
mod traces;
#[cfg(test)]
mod trouble;
#[cfg(test)]
mod units;
#[cfg(test)]
mod validation;
#[cfg(test)]
mod values;
#[cfg(test)]
mod verdict;
#[cfg(test)]
mod weight;
