//! Mass efficiencies by either closure, where the change of a closure by thickness alone decides: the armour or the solid plate of just
//! the thickness at which it changes stops the shot with something to spare, and any thinner one is perforated; or armour and solid
//! plate have different closures, and a verdict that neither closure gives.

use crate::model::scene::{Closure, Scene};
use crate::model::units::{NO_NUMBER, fixed_significant, significant};
use crate::study::compare::sized::{Absence, sized};
use crate::study::compare::{Hardware, Profitability};
use crate::study::limit::by_closure;

/// Mass efficiencies by the two closures; `None` where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByClosure {
    /// 2 Y, with dishing.
    pub double_yield: Option<f64>,
    /// Cavity expansion.
    pub cavity: Option<f64>,
    /// The drag coefficients with them.
    drag: [f64; 2],
}

impl ByClosure {
    /// Of a scene; the reason where there is none.
    pub(super) fn of(scene: &Scene, hardware: &Hardware, width: f64) -> Result<Self, Absence> {
        let scenes = [Closure::DoubleYield, Closure::Cavity].map(|it| by_closure(scene, it));
        let by = |own| sized(own, hardware, width).map(|sized| sized.mass_efficiency());
        match scenes.each_ref().map(by) {
            [Err(absence), Err(_)] => Err(absence),
            [double_yield, cavity] => Ok(Self {
                double_yield: double_yield.ok(),
                cavity: cavity.ok(),
                drag: scenes.map(|own| own.drag_coefficient()),
            }),
        }
    }

    /// Whether both agree on another verdict than that of this mass efficiency.
    pub(super) fn contradict(self, mass_efficiency: f64) -> bool {
        self.verdict()
            .pays()
            .is_some_and(|pays| Some(pays) != Profitability::of(mass_efficiency).pays())
    }

    /// The verdict on which both agree.
    pub fn verdict(self) -> Profitability {
        let both = self
            .double_yield
            .zip(self.cavity)
            .map(|(a, b)| (Profitability::of(a), Profitability::of(b)));
        match both {
            Some((a, b)) if a == b => a,
            Some((a, b)) if a != Profitability::Pays && b != Profitability::Pays => {
                Profitability::DoesNotPay
            }
            _ => Profitability::Unknown,
        }
    }

    /// Both on a page, the lower one first: one where they are the same.
    pub fn range(self) -> String {
        let Some((a, b)) = self.double_yield.zip(self.cavity) else { return NO_NUMBER.to_owned() };
        let (low, high) = if a < b { (a, b) } else { (b, a) };
        let [low, high] = [low, high].map(|it| fixed_significant(it, 4));
        if low == high { low } else { format!("{low}..{high}") }
    }

    pub(super) fn letter(self) -> char {
        match self.verdict().pays() {
            Some(true) => 'P',
            Some(false) => 'D',
            None => 'C',
        }
    }

    pub(super) fn brief(self) -> String {
        let verdict = match self.verdict().pays() {
            Some(true) => "pays by both closures",
            Some(false) => "pays by neither closure",
            None => "not decided between the closures",
        };
        format!("{verdict} (change at h = D)")
    }

    pub(super) fn words(self) -> String {
        let [double_yield, cavity] = [self.double_yield, self.cavity]
            .map(|it| it.map_or_else(|| "none".to_owned(), |it| fixed_significant(it, 4)));
        let [thin, thick] = self.drag.map(|it| significant(it, 4));
        format!(
            "only the change of closure at h = D decides: mass efficiency {double_yield} by closure=double-yield (dishing=true, \
             C_d={thin}), {cavity} by closure=cavity (dishing=false, C_d={thick}); set one of them"
        )
    }
}
