//! What holds between two events, and what follows an event: pure functions of mode, event and state.
//!
//! One rule serves the interface. u > 0 at the bottom of the hole: the hole deepens. u > 0 above it: the gap closes against
//! friction g A S. u < 0: the projectile is pulled out against g A S. u = 0: together, as long as the force that the interface
//! must carry stays within its limits; for good, once together, where the interface is fused.

use crate::model::contact::AreaPiece;
use crate::model::hybrid::equations::{Equations, Setup, State};
use crate::model::mechanism::sign;
use crate::model::scene::StopKind;
use crate::numerics::larger;

/// Part of the tip radius that all later bounces on a rigid stop may travel in all before the plate is taken to rest on it: depth and
/// displacement change by less than that.
const RATTLE: f64 = 1e-13;
/// Part of the work of the whole hole below which a joined body that strikes a stop is stopped whole: its interface would yield by
/// less than that part of the travel.
const SOFT_BLOW: f64 = 1e-13;

/// The contact of projectile and plate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Contact {
    /// The nose goes deeper than ever.
    Deepening,
    /// In a hole that is deeper, forwards.
    Closing,
    /// In the hole, backwards.
    PullingOut,
    /// Before the plate.
    Apart,
    /// Through the plate.
    Gone,
    /// No slip.
    Joined,
}

/// What holds the plate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hold {
    /// Nothing: it moves.
    Free,
    /// The rigid stop, on which it is pressed.
    OnStop,
    /// A spring that is infinitely steep where the plate stands, and lets it move by nothing that counts.
    Spring,
    /// The rigid mount.
    Mount,
}

/// The plate and its elastic stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Touch {
    /// Before it, or there is none.
    Away,
    Pressed,
    /// Beyond its place, but returning faster than it follows.
    Slack,
}

/// What holds between two events.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mode {
    pub(super) contact: Contact,
    pub(super) hold: Hold,
    pub(super) touch: Touch,
    /// The stretch of the area law in which the nose is.
    pub(super) piece: AreaPiece,
    /// Greatest travel so far, as far as the contact is beyond it only while it deepens.
    pub(super) deepest_m: f64,
    /// Displacement from which the state's is measured: the stop's, once it has been struck, so that bounces keep their digits.
    pub(super) origin_m: f64,
    /// Side of the spring's zero on which the plate is or to which it goes, 1 or -1.
    pub(super) x_side: f64,
    /// The same of the velocity's zero.
    pub(super) w_side: f64,
}

/// What ends a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Event {
    /// The area law changes, going deeper; the last time the nose is through.
    PieceEnd,
    /// The area law changes, coming out; the last time the nose is out.
    PieceStart,
    /// The bottom of the hole is reached again.
    Bottom,
    /// Common velocity.
    SlipZero,
    /// A projectile that was out touches again.
    Recontact,
    /// The joined interface is pushed beyond its strength.
    PushLimit,
    /// It is pulled beyond its grip.
    PullLimit,
    /// The plate passes the zero of its spring.
    PlaceZero,
    /// The plate turns.
    SpeedZero,
    StopReached,
    /// The elastic stop does not press any more.
    StopSlack,
    /// The plate is before its elastic stop again.
    StopCleared,
    /// The elastic stop presses again a plate that was not clear of it.
    StopPressed,
    /// Nothing presses the plate on its rigid stop any more.
    StopRelease,
    /// A steep spring lets the plate move noticeably.
    Yields,
}

impl Event {
    /// Whether another event is this one the other way.
    pub(super) fn is_undone_by(self, other: Self) -> bool {
        matches!(
            (self, other),
            (Self::StopSlack, Self::StopPressed) | (Self::StopPressed, Self::StopSlack)
        )
    }
}

/// The mode and the state at first contact.
pub(super) fn first(setup: &Setup) -> (Mode, State) {
    let mut mode = Mode {
        contact: Contact::Deepening,
        hold: if setup.still { Hold::Mount } else { Hold::Free },
        touch: Touch::Away,
        piece: setup.geometry.piece(0.0),
        deepest_m: 0.0,
        origin_m: 0.0,
        x_side: if setup.start_m < 0.0 { -1.0 } else { 1.0 },
        w_side: 1.0,
    };
    let mut state = State { u_m_s: setup.velocity_m_s, x_m: setup.start_m, ..State::default() };
    if (Equations { setup, mode: &mode }).is_held_by_spring() {
        mode.hold = Hold::Spring;
    }
    if !setup.still && setup.start_m >= setup.stop_at_m {
        reach_stop(setup, &mut mode, &mut state);
        mode.w_side = 1.0;
    }
    (mode, state)
}

/// The mode that follows an event; the state is put exactly on the event, and jumps where the event makes it.
pub(super) fn after(setup: &Setup, mode: &Mode, event: Event, state: &mut State) -> Mode {
    let mut next = *mode;
    match event {
        Event::PieceEnd => {
            state.q_m = mode.piece.to_m;
            next.piece = setup.geometry.piece(state.q_m);
            if state.q_m >= setup.geometry.exit_m {
                next.deepest_m = larger(mode.deepest_m, state.q_m);
                next.contact = Contact::Gone;
            }
        }
        Event::PieceStart => {
            state.q_m = larger(mode.piece.from_m, 0.0);
            pull_out(setup, &mut next, state);
        }
        Event::Bottom => {
            state.q_m = mode.deepest_m;
            push_in(setup, &mut next, state);
        }
        Event::Recontact => {
            state.q_m = 0.0;
            push_in(setup, &mut next, state);
        }
        Event::SlipZero => {
            if mode.hold == Hold::Spring {
                next.hold = Hold::Free;
                (state.x_m, state.w_m_s) = (Equations { setup, mode }).balanced(state);
            }
            state.u_m_s = 0.0;
            if mode.contact == Contact::Deepening {
                next.deepest_m = state.q_m;
            }
            settle(setup, &mut next, state);
        }
        Event::PushLimit => push_in(setup, &mut next, state),
        Event::PullLimit => pull_out(setup, &mut next, state),
        Event::PlaceZero => {
            state.x_m = -mode.origin_m;
            next.x_side = -mode.x_side;
        }
        Event::SpeedZero => {
            state.w_m_s = 0.0;
            next.w_side = -mode.w_side;
        }
        Event::StopReached => {
            state.x_m = setup.stop_at_m - mode.origin_m;
            reach_stop(setup, &mut next, state);
        }
        Event::StopSlack => {
            let beyond_m = Equations { setup, mode }.beyond_stop_m(state.x_m);
            next.touch = if beyond_m > 0.0 && damps(setup) { Touch::Slack } else { Touch::Away };
            if next.touch == Touch::Away {
                state.x_m = setup.stop_at_m - mode.origin_m;
            }
        }
        Event::StopCleared => {
            state.x_m = setup.stop_at_m - mode.origin_m;
            next.touch = Touch::Away;
        }
        Event::StopPressed => next.touch = Touch::Pressed,
        Event::StopRelease => release(setup, &mut next, state),
        Event::Yields => {
            next.hold = Hold::Free;
            (state.x_m, state.w_m_s) = (Equations { setup, mode }).balanced(state);
            state.u_m_s -= setup.cos * state.w_m_s;
        }
    }
    if next.hold == Hold::OnStop && (Equations { setup, mode: &next }).push_on_stop_n(state) < 0.0 {
        release(setup, &mut next, state);
    }
    next
}

/// The nose goes forward where it is.
fn push_in(setup: &Setup, mode: &mut Mode, state: &State) {
    let at_bottom = state.q_m >= mode.deepest_m;
    mode.contact = if at_bottom { Contact::Deepening } else { Contact::Closing };
    mode.piece = setup.geometry.piece(state.q_m);
}

/// The nose goes back where it is, or is out.
fn pull_out(setup: &Setup, mode: &mut Mode, state: &State) {
    let piece = setup.geometry.piece_behind(state.q_m);
    mode.contact = if piece.is_some() { Contact::PullingOut } else { Contact::Apart };
    mode.piece = piece.copied().unwrap_or_else(|| setup.geometry.piece(-1.0));
}

/// The force that the interface can carry forwards and backwards while joined, N.
pub(super) fn limits_n(setup: &Setup, mode: &Mode, q_m: f64) -> (f64, f64) {
    let strength = setup.geometry.area_m2(q_m) * setup.strength_pa;
    let friction = setup.grip * strength;
    (if q_m >= mode.deepest_m { strength } else { friction }, friction)
}

/// What follows where the slip is zero: together, unless the interface cannot carry what it must.
fn settle(setup: &Setup, mode: &mut Mode, state: &State) {
    mode.contact = Contact::Joined;
    if mode.hold == Hold::OnStop {
        if (Equations { setup, mode }).push_on_stop_n(state) >= 0.0 {
            return;
        }
        leave_stop(setup, mode, state);
    }
    if !setup.plastic {
        return;
    }
    let carried_n = Equations { setup, mode }.carried_n(state);
    let (push_n, pull_n) = limits_n(setup, mode, state.q_m);
    if carried_n > push_n {
        push_in(setup, mode, state);
    } else if carried_n < -pull_n {
        pull_out(setup, mode, state);
    }
}

/// The plate meets its stop, of either kind.
fn reach_stop(setup: &Setup, mode: &mut Mode, state: &mut State) {
    let Some(stop) = setup.stop else { return };
    (mode.origin_m, state.x_m) = (setup.stop_at_m, 0.0);
    if stop.kind == StopKind::Elastic {
        mode.touch = Touch::Pressed;
        // Its damper pushes at once.
        if mode.contact == Contact::Joined {
            settle(setup, mode, state);
        }
        return;
    }
    let joined = mode.contact == Contact::Joined;
    let before = state.w_m_s;
    mode.w_side = -1.0;
    let blow_j = 0.5 * setup.joined_kg * before * before;
    let hole_j = setup.geometry.area_m2(mode.deepest_m) * setup.strength_pa * mode.deepest_m;
    let is_soft = joined && setup.plastic && blow_j < SOFT_BLOW * hole_j;
    state.w_m_s = if is_soft { 0.0 } else { rebound(setup, mode, stop.restitution, state) };
    if !(joined && (is_soft || !setup.plastic)) {
        state.u_m_s += (before - state.w_m_s) * setup.cos;
        match mode.contact {
            Contact::Joined | Contact::PullingOut if state.u_m_s > 0.0 => {
                push_in(setup, mode, state);
            }
            _ => {}
        }
    }
    if state.w_m_s == 0.0 {
        mode.hold = Hold::OnStop;
        let in_contact = matches!(mode.contact, Contact::Joined | Contact::PullingOut);
        if in_contact && state.u_m_s == 0.0 {
            settle(setup, mode, state);
        }
    }
}

/// The velocity after a blow on a rigid stop. The flights of a plate that is pressed on it are parabolas, each shorter by the
/// restitution: where all of them together are too short to matter it stays.
fn rebound(setup: &Setup, mode: &Mode, restitution: f64, state: &State) -> f64 {
    let speed = restitution * state.w_m_s;
    let left = State { w_m_s: 0.0, ..*state };
    let pressed = Equations { setup, mode }.accelerations(&left).1;
    let way_m = 2.0 * speed * speed / (pressed * (1.0 - restitution));
    if pressed > 0.0 && way_m < RATTLE * setup.geometry.nose.radius_m { 0.0 } else { -speed }
}

/// The plate leaves a rigid stop on which it rested.
fn release(setup: &Setup, mode: &mut Mode, state: &State) {
    leave_stop(setup, mode, state);
    if mode.contact == Contact::Joined {
        settle(setup, mode, state);
    }
}

fn leave_stop(setup: &Setup, mode: &mut Mode, state: &State) {
    mode.hold = Hold::Free;
    mode.w_side = -1.0;
    let x_m = mode.origin_m + state.x_m;
    mode.x_side = if x_m > 0.0 { 1.0 } else { -1.0 };
    debug_assert!(setup.stop.is_some(), "only a stop lets go");
}

fn damps(setup: &Setup) -> bool {
    setup.stop.is_some_and(|stop| stop.damping_n_s_m > 0.0)
}

/// The side of zero on which a plate at rest, or at the zero of its spring, goes on.
pub(super) fn face(setup: &Setup, mode: &mut Mode, state: &State) {
    if mode.hold != Hold::Free || state.w_m_s != 0.0 {
        return;
    }
    let way = sign(Equations { setup, mode }.accelerations(state).1);
    if way != 0.0 {
        mode.w_side = way;
        if mode.origin_m + state.x_m == 0.0 {
            mode.x_side = way;
        }
    }
}

/// Takes all slips to come at once: the hole is deeper by so much travel, and the energy for it is gone.
pub(super) fn take_slips(setup: &Setup, mode: &mut Mode, state: &mut State, travel_m: f64) {
    let from_m = state.q_m;
    state.q_m += travel_m;
    let swept_m3 = setup.geometry.swept_m3(state.q_m) - setup.geometry.swept_m3(from_m);
    let left = state.w_m_s * state.w_m_s - 2.0 * setup.strength_pa * swept_m3 / setup.joined_kg;
    state.w_m_s = larger(left, 0.0).sqrt().copysign(state.w_m_s);
    mode.deepest_m = state.q_m;
}
