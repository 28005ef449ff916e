#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "estimator/identification/estimate.hpp"

namespace secular {

/// How natural frequencies differ from decay to decay.
struct DecayScatter {
  /// By mode, relative: standard deviation; 0: they do not, empty: decays say nothing.
  Eigen::VectorXd frequency_sd;
  std::string warning;  ///< where it could not be looked for
};

/// The parameters of an estimate.
using EstimatedParameters = std::function<std::vector<EstimatedValue>()>;

/// As identification with the model as it is tells it (docs/inference.md (23)), which is what `identified` does: it
/// may throw InputError or NumericalFailure.
DecayScatter find_decay_scatter(const EstimatedParameters& identified);

}  // namespace secular
