#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/identification/observation_set.hpp"

namespace secular {

/// What the full equations of motion do where a campaign was measured: one noise-free ensemble of every dwell at
/// the excitation that was measured there, starting from the motion that was (it may still drift slowly towards the
/// model's own steady motion: the observations hold its rate), one decay from the first state seen in every decay
/// record. `observations` are those of the campaign; only records that have some are replayed. By record, empty
/// where nothing was seen. Throws InputError where a motion grows beyond bounds.
std::vector<Record> replay_records(const Campaign& campaign, const ObservationSet& measured,
                                   const Eigen::VectorXd& parameters, unsigned threads);

/// Observations of replayed records with the noise levels of the measured ones, so that a regression weighs both
/// alike.
ObservationSet observe_replay(const Campaign& campaign, const ObservationSet& measured,
                              const std::vector<Record>& replayed, unsigned threads = 1);

}  // namespace secular
