//! Classes and errors against an independent computation; tables that are accepted and rejected.

use super::*;
use crate::study::context::Context;
use crate::study::context::never_cancel;
use crate::study::limit;
use crate::study::verdict::{Decision, Verdict};
use cmra_engine::model::scene::{Core, Nose, Scene};
use cmra_engine::model::variables::changed;
use cmra_oracle::assert_near;

fn scene(pairs: &str) -> Scene {
    changed(Scene::default(), &format!("mount=rigid closure=cylindrical {pairs}")).unwrap()
}

/// Returns a scene with the core of a 7.62 mm APM2 bullet and a plate.
fn core(pairs: &str) -> Scene {
    scene(&format!("nose=pointed m_p=5.3g R=3.1242mm {pairs}"))
}

const AA6061: &str = "rho=2700 E=68.3GPa Y=276MPa UTS=310MPa";

#[test]
fn every_row_of_the_built_in_table_can_be_computed() {
    let rows = built_in();
    assert_eq!(rows.len(), 597);
    for row in rows {
        let scene = row.scene.as_ref().unwrap_or_else(|why| panic!("line {}: {why}", row.line));
        assert!(limit::closed_form(scene).is_some_and(f64::is_finite), "line {}", row.line);
        assert!(row.measured.limit_m_s.is_some() && !row.source.is_empty() && !row.note.is_empty());
    }
}

/// Independent reference: law, hardening, integral and statistics in Python with `SciPy` (Brent, QUADPACK, `stats.t`), from the same file.
#[test]
fn valid_classes_of_the_built_in_table() {
    let expected = [
        ("steel core on light alloy", 381, 13, 0.010_983_813_7, 0.047_232_720_7, 1.649_004_810_8),
        (
            "steel core on light alloy, oblique",
            33,
            5,
            0.023_220_626_4,
            0.043_496_235_6,
            1.701_130_934_3,
        ),
        ("fragment on light alloy", 90, 7, 0.010_460_071_9, 0.058_247_789_7, 1.663_420_174_9),
        (
            "tungsten-carbide core on light alloy",
            8,
            2,
            -0.109_767_083_8,
            0.053_555_686_5,
            1.647_654_321_1,
        ),
        ("steel core on steel", 30, 3, 0.097_830_100_8, 0.079_597_403_6, 1.703_288_445_7),
        (
            "tungsten-carbide core on steel",
            3,
            1,
            -0.020_676_714_8,
            0.053_555_686_5,
            1.647_654_321_1,
        ),
        ("steel core on steel, oblique", 26, 3, -0.020_094_145_0, 0.063_109_553_2, 1.713_871_527_7),
        ("fragment on steel", 9, 1, -0.014_191_366_9, 0.053_555_686_5, 1.647_654_321_1),
        (
            "tungsten-carbide core on steel, oblique",
            2,
            2,
            0.008_974_363_3,
            0.053_555_686_5,
            1.647_654_321_1,
        ),
    ];
    assert_eq!(known().len(), expected.len());
    for (class, (words, rows, papers, bias, deviation, student)) in known().iter().zip(expected) {
        assert_eq!(class.key.words(), words);
        assert_eq!((class.measurements, class.papers), (rows, papers), "{words}");
        assert_near(class.bias, bias, 1e-7);
        assert_near(class.deviation, deviation, 1e-8);
        assert_near(class.student, student, 1e-9);
    }
}

/// Leave-one-paper-out errors by the same independent Python program. Rods and balls deform; without them the error is 33.27 m/s.
#[test]
fn valid_errors_of_papers_left_out() {
    let rows = leave_out(built_in());
    let all = errors(&rows).pop().unwrap();
    assert_eq!((all.group, all.rows, all.papers), (None, 597, 20));
    assert_eq!((all.banded, all.inside), (541, 493));
    assert_near(all.mean_absolute_m_s, 40.028_236_302, 1e-8);
    assert_near(all.rms_m_s, 71.074_120_313, 1e-8);
    assert_near(all.bias, -0.017_695_781_328, 1e-7);
    assert_near(all.deviation.unwrap(), 0.073_007_518_731, 1e-8);
    let is_rigid = |row: &&Row| {
        row.measurement.scene.as_ref().is_ok_and(|it| it.projectile.core != Core::Deformable)
    };
    let rigid: Vec<Row> = rows.iter().filter(is_rigid).cloned().collect();
    let rigid = errors(&rigid).pop().unwrap();
    assert_near(rigid.mean_absolute_m_s, 33.270_424_574, 1e-8);
    assert_near(rigid.rms_m_s, 46.495_167_007, 1e-8);
    // Rows with a band.
    let banded: Vec<Row> = rows.into_iter().filter(|row| row.is_inside().is_some()).collect();
    let banded = errors(&banded).pop().unwrap();
    assert_near(banded.mean_absolute_m_s, 30.481_745_643, 1e-8);
    assert_near(banded.bias, -0.012_181_482_984, 1e-7);
    assert_near(banded.deviation.unwrap(), 0.049_536_855_143, 1e-8);
}

/// Two classes by hand. First: errors 0.1, 0.3 of one paper and 0.4 of another; means 0.2 and 0.4, bias 0.3, sum of squares between papers
/// 0.02. Second: errors 0, 0.2 of one paper. Within papers: 0.02 + 0.02 over 2 degrees of freedom; between papers: 0.02 over 1.
#[test]
fn variances_are_within_papers_and_between_them() {
    let key = Key::from_scene(&core(&format!("h=25.4mm {AA6061}"))).unwrap();
    let steel = Key { alloy: Alloy::Steel, ..key };
    let sample = |key, paper: &str, error| Sample {
        key,
        paper: paper.to_owned(),
        error,
        thickness: 2.0,
        angle_deg: 0.0,
    };
    let samples = [
        sample(key, "a", 0.1),
        sample(key, "a", 0.3),
        sample(key, "b", 0.4),
        sample(steel, "c", 0.0),
        sample(steel, "c", 0.2),
    ];
    let classes = classes(&samples);
    assert_eq!(classes.len(), 2);
    assert_near(classes[0].bias, 0.3, 1e-14);
    for class in &classes {
        assert_near(class.deviation, 0.04f64.sqrt(), 1e-14);
        assert_near(class.student, 2.919_985_580_4, 1e-9);
    }
    let at = |key| Expectation::at(key, 2.0, 0.0, &classes);
    let [low, expected, high] = at(key).unwrap().band_m_s(500.0);
    assert_near(expected, 500.0 * (-0.3f64).exp(), 1e-14);
    assert_near(low * high, expected * expected, 1e-14);
    assert_near(high / expected, (2.919_985_580_4 * 0.2f64).exp(), 1e-9);
    // A single paper is not a class, and neither is another thickness.
    assert_eq!(at(steel), None);
    assert_eq!(Expectation::at(key, 2.1, 0.0, &classes), None);
}

/// Between 10 and 30 deg the correction is linear in the angle; beyond 30 deg there is none.
#[test]
fn valid_expectations_between_two_angles() {
    let scene = |theta: f64| core(&format!("h=20mm theta={theta}deg {AA6061}"));
    let found = |theta: f64| {
        let expected = Verdict::from_scene(&scene(theta)).expected?;
        Some((limit::closed_form(&scene(theta))? / expected.limit_m_s).ln())
    };
    let (normal, oblique) = (0.010_983_813_7, 0.023_220_626_4);
    for (theta, bias) in [
        (0.0, normal),
        (9.9, normal),
        (10.0, normal),
        (15.0, 0.75 * normal + 0.25 * oblique),
        (30.0, oblique),
    ] {
        assert_near(found(theta).unwrap(), bias, 1e-7);
    }
    assert_eq!(found(30.1), None);
}

#[test]
fn a_class_applies_only_where_its_law_and_its_rows_do() {
    let plate = format!("h=25.4mm {AA6061}");
    let verdict = |pairs: &str| Verdict::from_scene(&core(&format!("{plate} {pairs}")));
    // 581.574 m/s over exp(0.0109838) = 575.22 m/s; the band is exp(1.649005 x 0.0472327) = 1.08100 wide.
    let found = verdict("v_i=500");
    assert_near(found.limit_m_s.unwrap(), 581.574_272_8, 1e-9);
    let expected = found.expected.unwrap();
    assert_near(expected.limit_m_s, 575.221_347, 1e-7);
    assert_near(expected.low_m_s, 532.121_0, 1e-4);
    assert_near(expected.high_m_s, 621.813_0, 1e-4);
    assert_eq!(
        (expected.measurements, expected.papers, found.decision),
        (381, 13, Decision::Stops)
    );
    assert_eq!(verdict("v_i=575").decision, Decision::Open);
    assert_eq!(verdict("v_i=622").decision, Decision::Perforates);
    for pairs in [
        "closure=cavity",
        "closure=given",
        "C_d=0.5",
        "rho=2500",
        "E=80GPa",
        "h=9.9mm",
        "h=61mm",
        "theta=45deg",
        "core=deformable",
        "mount=sprung",
        "h_base=10mm",
        "criterion=protrusion",
        "nose=hemispherical",
        "nose=blunt",
        "nose=fragment theta=10deg",
        "rho=8900",
    ] {
        let found = verdict(pairs);
        assert_eq!((found.decision, found.expected), (Decision::NotMeasured, None), "{pairs}");
    }
    // A thin hard plate breaks the core: h/D 0.69 is not measured, 0.73 is.
    let hard = |h: f64, y: f64| {
        let pairs = format!("theta=30deg h={h}mm rho=7850 E=207GPa Y={y}MPa UTS=1600MPa");
        let mut scene = core(&pairs);
        scene.projectile.nose = Nose::Pointed;
        Verdict::from_scene(&scene).decision
    };
    assert_eq!(hard(0.69 * 6.2484, 1300.0), Decision::NotMeasured);
    assert_ne!(hard(0.73 * 6.2484, 1300.0), Decision::NotMeasured);
}

fn read_one(text: &str) -> Result<Vec<Measurement>, String> {
    read(text, &|_, name| Err(format!("`{name}` is not one of the threats")))
}

const HEAD: &str = "nose,core,R [mm],m_p [g],h [mm],rho [kg/m3],E [GPa],Y [MPa],UTS [MPa],theta [deg],mount,closure,C_d,limit_m_s,source";

/// Independent limit of this shot: 581.574 m/s.
#[test]
fn rows_are_read_with_the_units_of_their_headings() {
    for text in [
        format!("{HEAD}\npointed,steel,3.1242,5.3,25.4,2700,68.3,276,310,0,rigid,cylindrical,0.212,580,mine\n"),
        // Blank cells are not given; they take the values that follow from nose and closure.
        format!("{HEAD}\npointed,,3.1242,5.3,25.4,2700,68.3,276,310,,,,,580,mine\n"),
        format!("{}\npointed;;3,1242;5,3;25,4;2700;68,3;276;310;;;;;580;mine\n", HEAD.replace(',', ";")),
        "R,m_p,h (in),rho,E,Y,UTS,nose,limit_m_s,source\n0.0031242,5.3g,1,2700,68.3GPa,276e6,310MPa,pointed,580,mine\n".to_owned(),
    ] {
        let rows = read_one(&text).unwrap_or_else(|problem| panic!("{problem}"));
        let rows = evaluate(&rows, &mut Context::new(1, &mut never_cancel));
        let computed = rows[0].computed.as_ref().unwrap_or_else(|why| panic!("{why}: {text}"));
        assert_near(computed.verdict.limit_m_s.unwrap(), 581.574_272_8, 1e-9);
        assert_eq!(rows[0].measurement.source, "mine");
        assert_near(rows[0].limit_error().unwrap(), 575.221_347 / 580.0 - 1.0, 1e-4);
        assert_eq!(rows[0].is_inside(), Some(true));
    }
}

/// Tables of measurements name bullets and rods. These deform, so they have no class.
#[test]
fn words_of_other_tables_are_understood() {
    let rest = "3.1242,5.3,25.4,2700,68.3,276,310,0,rigid,cylindrical,,580,mine";
    for (words, nose, core) in [
        ("ogive,steel", Nose::Pointed, Core::Steel),
        ("ball,lead", Nose::Pointed, Core::Deformable),
        ("ball,", Nose::Pointed, Core::Deformable),
        ("rod,tungsten", Nose::Blunt, Core::Deformable),
        ("fragment,", Nose::Fragment, Core::Steel),
    ] {
        let rows = read_one(&format!("{HEAD}\n{words},{rest}\n")).unwrap();
        let scene = rows[0].scene.as_ref().unwrap();
        assert_eq!((scene.projectile.nose, scene.projectile.core), (nose, core), "{words}");
        assert_eq!(Key::from_scene(scene).is_none(), core == Core::Deformable);
    }
}

#[test]
fn what_is_wrong_with_a_table_is_one_line_with_the_remedy() {
    for (text, told) in [
        ("0.003,5\n", "line 1 has no headings"),
        ("R [mm],mass_of_shot,limit_m_s\n1,2,3\n", "line 1: `mass_of_shot` is no column"),
        ("R_mm,limit_m_s\n1,3\n", "did you mean `R [mm]`?"),
        ("R [mm],limit_ms\n1,3\n", "did you mean `limit_m_s`?"),
        ("R [kg],limit_m_s\n1,3\n", "`kg` is no unit of `R [kg]`: use"),
        ("nose [mm],limit_m_s\npointed,3\n", "`nose [mm]` takes no unit: write `nose`"),
        ("R [mm],R [in],limit_m_s\n1,2,3\n", "`R [mm]` and `R [in]` are the same quantity"),
        ("R [mm],limit_m_s\n1,3\n2 in,3\n", "line 3: `R [mm]` has a unit and so has `2 in`"),
        (
            "R,limit_m_s\n1mm,3\n2,3\n",
            "line 2: `R` mixes `1mm` and `2`: write numbers only and the unit once, `R [mm]`",
        ),
    ] {
        let problem = read_one(text).unwrap_err();
        assert!(problem.contains(told) && !problem.contains('\n'), "{text}: {problem}");
    }
}

#[test]
fn a_row_that_cannot_be_computed_keeps_its_place_and_says_why() {
    let whole =
        "pointed,steel,3.1242,5.3,25.4,2700,68.3,276,310,0,rigid,cylindrical,0.212,580,mine";
    for (from, to, told) in [
        (",5.3,", ",,", "no value of m_p"),
        (",276,", ",,", "no value of Y"),
        (",276,", ",soft,", "Y [MPa] = `soft`"),
        ("pointed", "sharp", "`sharp` is not one of"),
        (",0,rigid", ",95,rigid", "theta"),
        (",580,", ",,", "nothing is measured"),
        (",580,", ",-580,", "must be greater than 0"),
        (",mine", ",mine,yours", "16 values for 15 columns"),
    ] {
        let rows =
            read_one(&format!("{HEAD}\n{}\n{whole}\n", whole.replacen(from, to, 1))).unwrap();
        assert_eq!(rows.len(), 2);
        let why = rows[0].scene.as_ref().unwrap_err();
        assert!(why.contains(told), "{to}: {why}");
        assert!(rows[1].scene.is_ok());
    }
    let rows = read_one("threat,h [mm],limit_m_s\nm2,3,4\n").unwrap();
    assert_eq!(rows[0].scene.as_ref().unwrap_err(), "`m2` is not one of the threats");
    let depth =
        read_one("m_p [g],R [mm],h [mm],rho,S_y [MPa],depth_m\n30,6,20,2700,200,0.005\n").unwrap();
    assert!(depth[0].scene.as_ref().unwrap_err().starts_with("v_i is not given"));
}
