#pragma once

#include <Eigen/Core>

#include "diagnose/inference/refit.hpp"
#include "diagnose/verdict/comparison.hpp"

namespace secular {

/// What a law of the amplitude that a model of one mode lacks may have moved the numbers of decays by.
struct UnseenLaws {
  double deviations = 0;  ///< of the clearest law's strength from zero, in standard deviations
  double p_value = 1;     ///< all laws that were tried allowed for
  Eigen::VectorXd moved;  ///< by free unknown, the largest of all laws

  bool is_seen() const;
};

/// docs/inference.md (76). `fit`: to decays in one piece each.
UnseenLaws unseen_laws(const Comparison& comparison, const Refit& fit);

}  // namespace secular
