#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/balance/torus.hpp"

namespace secular {

/// Independent phases of a case: the excitations', then the free modes', each divided until every mode's phase is a
/// whole number of them; or those of two modes, where the others are whole numbers of these.
struct BasePhases {
  std::vector<LinePhase> mode;        ///< zero of modes at rest
  std::vector<LinePhase> excitation;  ///< empty of a case without
  Eigen::MatrixXd turns;              ///< base phases x (modes, excitations): what a base phase takes of each

  int dimensions() const { return static_cast<int>(turns.rows()); }
  /// The most of them, |n[0]| + |n[1]|, that make a phase of a mode or an excitation.
  int highest() const;
  /// growth + i*frequency of each, 1/s: at the observed frequencies, of a decay with the observed growth.
  std::vector<std::complex<double>> rates(const Observation& observation) const;
};

/// Nothing where there are more than two.
std::optional<BasePhases> base_phases(const CompiledModel& model, const CompiledCase& resonance);

}  // namespace secular
