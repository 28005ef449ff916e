#pragma once

#include <Eigen/Core>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// What the full equations of motion do where a campaign was measured, observed like the measurement: one
/// noise-free ensemble of every dwell at the excitation measured there, starting from what its ensembles agree on
/// (mean_motion; it may still drift slowly towards the model's own steady motion: the observations hold its rate),
/// every stretch of a
/// decay, started so that its first window shows what was measured. Records without observations in `measured` are
/// left out. Observations get the measured ones' noise levels, so that a regression weighs both alike. Few records
/// for each thread are held at a time. Throws NumericalFailure where a motion grows beyond bounds.
ObservationSet observe_replay(const Campaign& campaign, const ObservationSet& measured,
                              const Eigen::VectorXd& parameters, unsigned threads);

}  // namespace secular
