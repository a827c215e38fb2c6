//! Effects of the latest edit on Run: the previous curve as faint dots, and the difference in each title.

use super::bench::{Bench, made};

/// The plot rows of the first chart.
fn upper(bench: &Bench) -> String {
    bench.screen().lines().skip(2).take(4).collect::<Vec<_>>().join("\n")
}

fn depth_mm(bench: &Bench) -> f64 {
    made(&bench.app.scene).penetration.final_m.unwrap() * 1e3
}

#[test]
fn titles_say_the_difference_until_the_next_edit() {
    let mut bench = Bench::ascii(80, 24);
    assert!(!bench.screen().contains("since"), "nothing is edited");
    let first_mm = depth_mm(&bench);
    bench.keys("/gamma<Enter><Enter>1.25<Enter>");
    let second_mm = depth_mm(&bench);
    let expected = format!("{second_mm:.3} mm, {:+.3} since gamma 1 -", second_mm - first_mm);
    assert!(bench.screen().contains(&expected), "{expected}\n{}", bench.screen());
    // The peak is made up, and the same.
    assert!(bench.screen().contains("as at gamma 1"), "{}", bench.screen());
    bench.keys("/v_i<Enter><Enter>90<Enter>");
    let expected = format!("{:+.3} since v_i 100 m/s", depth_mm(&bench) - second_mm);
    assert!(bench.screen().contains(&expected), "{expected}\n{}", bench.screen());
    bench.keys("u");
    let expected = format!("{:+.3} since v_i 90 m/s", second_mm - depth_mm_of(90.0, &bench));
    assert!(bench.screen().contains(&expected), "{expected}\n{}", bench.screen());
}

fn depth_mm_of(velocity_m_s: f64, bench: &Bench) -> f64 {
    let mut scene = (*bench.app.scene).clone();
    scene.projectile.velocity_m_s = velocity_m_s;
    made(&scene.into()).penetration.final_m.unwrap() * 1e3
}

/// Held arrows are one edit: the difference is to where they began, as undo goes back there.
#[test]
fn held_arrows_count_from_where_they_began() {
    let mut bench = Bench::ascii(80, 24);
    let first_mm = depth_mm(&bench);
    bench.keys("l");
    bench.keys("l");
    bench.keys("l");
    let expected = format!("{:+.3} since gamma 1 -", depth_mm(&bench) - first_mm);
    assert!(bench.screen().contains(&expected), "{expected}\n{}", bench.screen());
}

#[test]
fn the_curve_before_stays_as_dots_and_needs_no_pin() {
    let mut bench = Bench::ascii(80, 24);
    let dots =
        |bench: &Bench| upper(bench).matches('.').count() - upper(bench).matches("4.").count();
    let before = dots(&bench);
    bench.keys("/gamma<Enter><Enter>3<Enter>");
    assert!(dots(&bench) >= before + 10, "{}", bench.screen());
    // A scene that is loaded is another one: nothing is compared.
    bench.keys("p<Down><Enter>");
    assert!(!bench.screen().contains("since"), "{}", bench.screen());
}

#[test]
fn what_came_through_before_says_so() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys("/thickness<Enter><Enter>6.35 mm<Enter>");
    assert!(bench.screen().contains("4.565 mm at h 25.4 mm"), "{}", bench.screen());
    bench.keys("<Enter>25.4 mm<Enter>");
    assert!(bench.screen().contains("through at h 6.35 mm"), "{}", bench.screen());
}
