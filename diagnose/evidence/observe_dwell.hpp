#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/evidence/condition.hpp"
#include "diagnose/evidence/nonstationarity.hpp"
#include "diagnose/evidence/sensor_model.hpp"
#include "diagnose/evidence/wandering_zeros.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// The mean of a dwell's ensembles and how single ensembles scatter about it.
struct Dwell {
  Condition condition;  ///< without errors: they are pooled over dwells
  std::size_t ensembles = 0;
  double degrees_of_freedom = 0;                         ///< of a scatter
  Eigen::MatrixXd response_scatter, excitation_scatter;  ///< one ensemble's sd of a real part: channel x line
  Eigen::VectorXd noise;  ///< sd of what no line explains in a sample; responses first, then excitations
  /// By master, where the excitation is steady and all lines are multiples of one frequency.
  std::vector<Nonstationarity> nonstationarity;
};

/// What dwells are read for, and with.
struct DwellContext {
  const Campaign& campaign;
  const CompiledModel& model;
  const SensorModel& sensors;
  const std::vector<double>& natural_frequency;  ///< rad/s, by mode
  const Window& window;
  const WanderingZeros& wandering;
};

/// Nothing (and a warning) for a dwell that is too short, has no steady excitation or has not settled. Phases are
/// those of the excitation's fundamental; where a motion may start anywhere against it (subharmonics, pairs of
/// modes), ensembles are turned to agree.
std::optional<Dwell> observe_dwell(const DwellContext& context, std::size_t index, const Record& record,
                                   std::vector<std::string>& warnings);

}  // namespace secular
