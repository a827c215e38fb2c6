//! The parameters of the stop.

use crate::model::variables::part::parts;
use crate::model::variables::visible::{has_stop, has_stop_of};
use crate::model::worded::worded;

parts! {
    /// A mechanical stop, which acts on the plate.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Stop at (mechanism.stop) {
        pub position_m: Option<f64> = None => "x_stop", "stop position", "where the plate meets a mechanical stop",
            optional(Length, Any, "none").also(&["stop"]).from("thesis sections 9.5.1 and 9.6");
        pub kind: StopKind = StopKind::Rigid => "stop_kind", "kind of stop",
            "rigid: an impact with restitution; elastic: a one-sided spring and damper",
            choice().used_when(has_stop).from("assumption: the thesis names no kind");
        pub restitution: f64 = 0.0 => "e", "restitution", "restitution of a rigid stop: w becomes -e w",
            number(Number, Between(0.0, 1.0)).used_when(|scene| has_stop_of(scene, StopKind::Rigid));
        pub stiffness_n_m: f64 = 1e8 => "k_stop", "stop stiffness", "stiffness of an elastic stop",
            number(Stiffness, Positive).log().used_when(|scene| has_stop_of(scene, StopKind::Elastic));
        pub damping_n_s_m: f64 = 0.0 => "b_stop", "stop damping", "damping of an elastic stop (it only pushes)",
            number(Damping, NonNegative).log().used_when(|scene| has_stop_of(scene, StopKind::Elastic));
    }
}

worded! {
    /// The kind of stop.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
    pub enum StopKind: word {
        #[default]
        Rigid = "rigid",
        Elastic = "elastic",
    }
}
