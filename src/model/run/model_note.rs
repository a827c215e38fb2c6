//! Notes on the contact models: what each does not contain.

/// Notes on the effects that a contact model neglects or assumes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the sentence of each says what it means")]
pub enum ModelNote {
    Overruns { t_s: f64, duration_s: f64 },
    DeeperThanPlate,
    NoPlasticLaw,
    NoStop,
    JoinedThroughHole,
}

impl ModelNote {
    /// The sentence.
    pub fn words(self) -> String {
        match self {
            Self::Overruns { t_s, duration_s } => format!(
                "the half-sine history is that of a fixed plate: here both bodies have the same velocity at {:.4} us, and the \
                 force goes on to t_d = {:.4} us",
                t_s * 1e6,
                duration_s * 1e6
            ),
            Self::DeeperThanPlate => {
                "the depth is beyond the rear face, of which this model knows nothing: the plate would be perforated".to_owned()
            }
            Self::NoPlasticLaw => {
                "interface = plastic is ignored: only the hydrodynamic model has an interface that can yield".to_owned()
            }
            Self::NoStop => "the stop is ignored: the listing of Appendix A has none".to_owned(),
            Self::JoinedThroughHole => {
                "as printed, projectile and plate move on as one body although the plate is perforated; \
                 contact.appendix.afterwards = corrected parts them"
                    .to_owned()
            }
        }
    }
}
