#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "estimator/planning/dwell_information.hpp"
#include "motion/response/response_field.hpp"

namespace secular {

/// A stable response that a dwell could hold, and how to get there.
struct DwellCandidate {
  DwellState state;
  double slowest = 0;     ///< 1/s, real part of the slowest eigenvalue (negative)
  double settle_s = 0;    ///< until what is left of a disturbance is `settled`
  Eigen::VectorXd start;  ///< [mode] displacement at rest from which the modulation equations go there
};

struct CandidateRequest {
  Eigen::VectorXd parameters;       ///< as ResponseField::parameter_names; force and frequency are overwritten
  std::vector<double> frequencies;  ///< rad/s, rising
  std::vector<double> forcings;     ///< peak
  double settled = 1e-3;            ///< relative
  double settle_limit = 600;        ///< s; slower responses are no candidates
  bool reached = true;              ///< only those that a release from rest reaches
  std::function<void(std::size_t done, std::size_t total)>
      progress{};  ///< of levels; what it throws ends the search
};

/// Stable responses at every frequency and level, level by level. Those that no release from rest reaches (a few
/// multiples of the response's own amplitude are tried on the modulation equations) are left out. Throws
/// std::invalid_argument for fewer than two frequencies or no level.
std::vector<DwellCandidate> response_candidates(const ResponseField& field, const CandidateRequest& request);

}  // namespace secular
