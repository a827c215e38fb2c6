//! The way of a lean contact from step to step: how far each expansion is trusted, where the slip ends, a piece of travel, or a
//! way of expanding.

use crate::model::contact::AreaLaw;
use crate::model::impact::lean::expansion::{Clock, Series};
use crate::model::impact::lean::riding::eased;
use crate::model::impact::lean::root::{dips, fall, rise};
use crate::model::impact::lean::{Contact, ContactEnd};
use crate::numerics::larger;
use crate::numerics::series::evaluate;

/// Local tolerance per global tolerance.
const LOCAL: f64 = 0.5;
/// Steps after which the full track is the better way.
const STEPS_MAX: usize = 1500;
/// Part of a step below which a plate that no longer rides is not asked again.
const SHORTEST: f64 = 0.1;

/// Where a contact is on its way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Track {
    /// When, s.
    pub(super) t_s: f64,
    /// (travel, slip, plate, speed).
    pub(super) state: [f64; 4],
    /// Of the next step.
    pub(super) clock: Clock,
    /// Index of the piece of travel.
    pub(super) piece: usize,
    /// Greatest plate displacement so far, m.
    pub(super) farthest_m: f64,
    /// Steps taken.
    pub(super) steps: usize,
}

/// How far one way of expanding led.
pub(super) enum Way {
    /// To the end.
    Ended(ContactEnd),
    /// To where another way must take over.
    Handed(Track),
    /// To where the full track must.
    Left,
}

impl Way {
    pub(super) fn ended(self) -> Option<ContactEnd> {
        match self {
            Self::Ended(end) => Some(end),
            Self::Handed(_) | Self::Left => None,
        }
    }
}

impl Contact {
    /// The beginning, in this state.
    pub(super) fn begin(&self, t_s: f64, state: [f64; 4], clock: Clock) -> Track {
        Track { t_s, state, clock, piece: 0, farthest_m: self.start_m, steps: 0 }
    }

    /// Go on by steps from `track` to the end, or to where `expand` gives none.
    pub(super) fn go_on<const N: usize>(
        &self,
        expand: impl Fn(&Track, (f64, [f64; 3])) -> Option<Series<N>>,
        mut track: Track,
        (sides, tolerance, reach_m): ((bool, bool), f64, Option<f64>),
    ) -> Way {
        let pieces = self.geometry.pieces();
        // From where to go on another way: a step earlier than where this one was seen to fail.
        let mut before = track;
        let mut joint = None;
        let mut leash = 1.0;
        while track.steps < STEPS_MAX {
            let Some(piece) = pieces.get(track.piece) else { return Way::Left };
            let AreaLaw::Quadratic { origin_m, a } = piece.law else { return Way::Left };
            track.steps += 1;
            let Some(series) = expand(&track, (origin_m, a)) else {
                // Fine up to the joint, where the next piece sets the plate swinging?
                if joint.is_some_and(|law| expand(&track, law).is_some()) {
                    return Way::Handed(track);
                }
                if track.piece != before.piece || leash < SHORTEST {
                    return Way::Handed(before);
                }
                // The step there may have been too long, and so may be those to come.
                leash *= 0.5;
                track = Track { steps: track.steps, ..before };
                continue;
            };
            joint = None;
            let plate_m = match reach_m {
                Some(reach_m) => series.plate[0].abs() * eased(series.plate[0].abs(), reach_m),
                None => f64::INFINITY,
            };
            let trusted = leash * self.constants.trusted(&series, tolerance * LOCAL, plate_m);
            if trusted < 0.02 {
                // The unit is far too long for what happens now.
                track.clock = track.clock.shorter(larger(2.0 * trusted, 1e-3));
                continue;
            }
            let stops = evaluate(&series.slip, trusted) <= 0.0;
            let span = if stops { fall(&series.slip, trusted) } else { trusted };
            if !stops && dips(&series.slip, span) {
                return Way::Left;
            }
            // Travel only grows up to the arrest: the piece's end may lie before it.
            let at_end = evaluate(&series.travel, span) >= piece.to_m;
            let span = if at_end { rise(&series.travel, piece.to_m, span) } else { span };
            let arrested = stops && !at_end;
            before = track;
            track.t_s += track.clock.elapsed_s(span);
            track.state = series.state(span);
            track.farthest_m = larger(track.farthest_m, highest(&series, span, &track.state));
            if !self.passes(sides, &track.state) {
                return Way::Left;
            }
            if arrested {
                return Way::Ended(self.end(true, &track));
            }
            if at_end {
                track.state[0] = piece.to_m;
                track.piece += 1;
                joint = Some((origin_m, a));
                if track.piece == pieces.len() {
                    return Way::Ended(self.end(false, &track));
                }
            }
            track.clock = track.clock.next(span, trusted);
        }
        Way::Left
    }

    /// Whether the plate is still where its laws hold: on the side of zero on which it started, and going forward.
    fn passes(&self, sides: (bool, bool), state: &[f64; 4]) -> bool {
        let on_its_side = if self.start_m < 0.0 { state[2] < 0.0 } else { state[2] > 0.0 };
        (sides.0 || on_its_side) && (sides.1 || state[3] > 0.0)
    }

    /// The end, there.
    pub(super) fn end(&self, arrested: bool, track: &Track) -> ContactEnd {
        let state = &track.state;
        ContactEnd {
            arrested,
            t_s: track.t_s,
            penetration_m: self.geometry.depth_m(state[0]),
            plate_displacement_m: state[2],
            plate_velocity_m_s: state[3],
            farthest_m: track.farthest_m,
            steps: track.steps,
        }
    }
}

/// The plate's greatest displacement up to `span`. A step is shorter than half a swing, so there is one maximum at most.
fn highest<const N: usize>(s: &Series<N>, span: f64, end: &[f64; 4]) -> f64 {
    let turns = s.speed[0] > 0.0 && end[3] < 0.0;
    if turns { larger(end[2], evaluate(&s.plate, fall(&s.speed, span))) } else { end[2] }
}
