#pragma once

#include <Eigen/Core>

#include "estimator/identification/observation_set.hpp"

namespace secular {

/// What the full equations of motion do where a campaign was measured, observed like the measurement: one
/// noise-free ensemble of every dwell at the excitation that was measured there, starting from the motion that was (it
/// may still drift slowly towards the model's own steady motion: the observations hold its rate), and
/// every stretch of a decay, started so that its first window shows what was measured there. Records without observations in `measured` are left out. Observations get
/// the noise levels of the measured ones, so that a regression weighs both alike. No more than a few records for each
/// thread are held at a time. Throws InputError where a motion grows beyond bounds.
ObservationSet observe_replay(const Campaign& campaign, const ObservationSet& measured,
                              const Eigen::VectorXd& parameters, unsigned threads);

}  // namespace secular
