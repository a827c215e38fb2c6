//! Results of one impact that have an error estimate of their own: key and value of each.

use crate::model::labelled_enum::labelled_enum;
use crate::model::run::Run;

labelled_enum! {
    /// Result of one impact with an error estimate of its own, by its key among the quantities.
    pub enum RunResult: key {
        ArrestPenetration = "first_arrest_penetration_m",
        ArrestTime = "first_arrest_time_s",
        ArrestPlateDisplacement = "first_arrest_plate_displacement_m",
        ArrestPlateVelocity = "first_arrest_plate_velocity_m_s",
        FinalPenetration = "final_penetration_m",
        PeakContactForce = "peak_contact_force_n",
        MaxPlateDisplacement = "max_plate_displacement_m",
        Stroke = "stroke_m",
        ResidualVelocity = "residual_velocity_m_s",
        ExitTime = "exit_time_s",
        SeparationTime = "separation_time_s",
        SeparationVelocity = "separation_velocity_m_s",
        InterfaceDemand = "interface_demand_ratio",
        InterfaceTension = "interface_tension_ratio",
        PeakMountForce = "peak_mount_force_n",
        StoredEnergy = "stored_energy_j",
        RotationalEnergy = "rotational_energy_j",
    }
}

impl RunResult {
    /// The value in a run, SI; `None` if it does not exist there. Of a stack, that of the plate that is struck first.
    pub fn value(self, run: &Run) -> Option<f64> {
        match self {
            Self::ArrestPenetration => Some(run.first_arrest?.penetration_m),
            Self::ArrestTime => Some(run.first_arrest?.t_s),
            Self::ArrestPlateDisplacement => Some(run.first_arrest?.plate_displacement_m),
            Self::ArrestPlateVelocity => Some(run.first_arrest?.plate_velocity_m_s),
            Self::FinalPenetration => run.penetration.final_m,
            Self::PeakContactForce => run.peak_contact_force_n,
            Self::MaxPlateDisplacement => run.max_plate_displacement_m,
            Self::Stroke => run.stroke_m(),
            Self::ResidualVelocity => run.departure.residual_velocity_m_s,
            Self::ExitTime => run.departure.exit_time_s,
            Self::SeparationTime => Some(run.departure.separation?.t_s),
            Self::SeparationVelocity => Some(run.departure.separation?.velocity_m_s),
            Self::InterfaceDemand => run.interface.demand_ratio,
            Self::InterfaceTension => run.interface.tension_ratio,
            Self::PeakMountForce if run.scene.is_sprung() => run.mechanism.peak_mount_n,
            Self::PeakMountForce => Some(run.peak_contact_force_n? * run.scene.cos_obliquity()),
            Self::StoredEnergy => run.mechanism.stored_j,
            Self::RotationalEnergy => run.mechanism.rotation_j,
        }
    }
}
