//! Numerical methods that know no plate, no projectile, no metre and no screen.
