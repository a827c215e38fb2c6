//! The runs that claims need, by the engine and by the Appendix as printed; an impact that several claims need is simulated once.

use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::sync::{Arc, Mutex, PoisonError};

use crate::model::run::{Outcome, Run};
use crate::model::scene::{ContactModel, Mount, Plate, Scene};
use crate::model::simulate::{self, Settings};
use crate::study::context::CancelFlag;
use crate::study::with_numbers;

/// Longer than any contact here, s.
const CONTACT_S: f64 = 1e-3;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Algorithm {
    /// The engine.
    Sound,
    /// The Appendix as printed, at its own step.
    Printed,
}

/// Runs without series by their scenes, for all claims that are checked together.
#[derive(Default)]
pub(super) struct SharedRuns {
    known: Mutex<HashMap<String, Arc<Run>>>,
    /// Once it is set every run ends at its next step, and what is found from then on is not kept.
    stop: CancelFlag,
}

impl SharedRuns {
    /// Shared runs that this flag stops.
    pub(super) fn stopped_by(stop: CancelFlag) -> Self {
        Self { stop, ..Self::default() }
    }
}

/// The runs that one claim needs, shared with the other claims.
pub(super) struct Runs<'a> {
    shared: &'a SharedRuns,
    /// The impacts it needed.
    impacts: RefCell<HashSet<String>>,
}

/// A scene with some variables changed; names and values are this study's own, so none is refused.
pub(super) fn changed(scene: &Scene, changes: &[(&str, f64)]) -> Scene {
    let own = with_numbers(scene.clone(), changes);
    debug_assert!(own.is_ok(), "{changes:?}: {own:?}");
    own.unwrap_or_else(|_refused| scene.clone())
}

impl<'a> Runs<'a> {
    /// A claim's runs among those of all claims.
    pub(super) fn new(shared: &'a SharedRuns) -> Self {
        Self { shared, impacts: RefCell::default() }
    }

    /// Whether it was stopped: then nothing found by it counts.
    pub(super) fn is_stopped(&self) -> bool {
        self.shared.stop.is_set()
    }

    pub(super) fn impacts(&self) -> usize {
        self.impacts.borrow().len()
    }

    pub(super) fn run_with_series(&self, method: Algorithm, scene: &Scene) -> Run {
        let (own, _) = self.noted(method, scene);
        self.simulated(own, true)
    }

    /// Runs a scene without its series, or gives the run that another claim needed.
    pub(super) fn run(&self, method: Algorithm, scene: &Scene) -> Arc<Run> {
        let (own, name) = self.noted(method, scene);
        let known = || self.shared.known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(run) = known().get(&name) {
            return Arc::clone(run);
        }
        let run = Arc::new(self.simulated(own, false));
        if !self.is_stopped() {
            known().insert(name, Arc::clone(&run));
        }
        run
    }

    /// The scene as the method runs it, and what it is known by; one impact more that the claim needed.
    fn noted(&self, method: Algorithm, scene: &Scene) -> (Scene, String) {
        let mut own = scene.clone();
        if method == Algorithm::Printed {
            own.contact.model = ContactModel::Appendix;
        }
        let name = format!("{own:?}");
        self.impacts.borrow_mut().insert(name.clone());
        (own, name)
    }

    fn simulated(&self, scene: Scene, series: bool) -> Run {
        let settings = Settings { series, estimate: false };
        let observer = &mut |_t_s: f64| self.shared.stop.flow();
        simulate::simulate(&Arc::new(scene), &settings, observer)
            .expect("the scenes of this study make physical sense")
    }

    /// Depth at the first arrest, m; infinite for a perforation, NaN where there is none.
    pub(super) fn depth_m(&self, method: Algorithm, scene: &Scene) -> f64 {
        let mut own = scene.clone();
        if method == Algorithm::Printed {
            // The listing follows the plate for as long as it oscillates; its depth is known when the contact ends.
            own.run.horizon_s = own.run.horizon_s.or(Some(CONTACT_S));
        }
        let run = self.run(method, &own);
        match run.outcome {
            Outcome::Perforated => f64::INFINITY,
            Outcome::Arrested | Outcome::Separated | Outcome::Moving => {
                run.first_arrest.map_or(f64::NAN, |arrest| arrest.penetration_m)
            }
        }
    }

    /// Depth over that of the same shot on a rigid mount by the same method, percent.
    pub(super) fn percent(&self, method: Algorithm, scene: &Scene) -> f64 {
        let base = Scene::default();
        let rigid = Scene {
            projectile: scene.projectile,
            target: scene.target,
            contact: scene.contact,
            plate: Plate { mount: Mount::Rigid, ..base.plate },
            ..base
        };
        100.0 * self.depth_m(method, scene) / self.depth_m(method, &rigid)
    }
}
