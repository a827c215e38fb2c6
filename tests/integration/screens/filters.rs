//! `/` in tables and lists.

use super::bench::Bench;

#[test]
fn the_title_of_the_log_has_its_filter() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("7/energy<Enter>");
    assert!(bench.screen().contains("session /energy"), "{}", bench.screen());
    bench.keys("<Esc>");
    assert!(!bench.screen().contains("/energy"), "{}", bench.screen());
}
