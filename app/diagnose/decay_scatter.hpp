#pragma once

#include <Eigen/Core>
#include <string>

#include "app/diagnose/diagnosis_run.hpp"

namespace secular::app {

/// How natural frequencies differ from decay to decay.
struct DecayScatter {
  /// By mode, relative: standard deviation; 0: they do not, empty: decays say nothing.
  Eigen::VectorXd frequency_sd;
  std::string warning;  ///< where it could not be looked for
};

/// As `identify` finds it with the model as it is (docs/inference.md (23)).
DecayScatter find_decay_scatter(const DiagnosisRequest& request);

}  // namespace secular::app
