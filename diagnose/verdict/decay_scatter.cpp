#include "diagnose/verdict/decay_scatter.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>

#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

// Of natural frequencies that differ more than their decays leave open, at the level of all disturbances.
Eigen::VectorXd scatter_of_decays(const std::vector<EstimatedValue>& parameters) {
  Eigen::VectorXd sd;
  for (const EstimatedValue& value : parameters) {
    if (!value.value || !value.between_records) continue;
    const ScatterBetweenRecords& scatter = *value.between_records;
    const auto mode = static_cast<Eigen::Index>(scatter.mode);
    if (sd.size() <= mode) sd.conservativeResizeLike(Eigen::VectorXd::Zero(mode + 1));
    if (scatter.p_value < measure_thresholds().disturbance_false_alarm)
      sd(mode) = scatter.sd / std::abs(*value.value);
  }
  return sd;
}

}  // namespace

DecayScatter find_decay_scatter(const EstimatedParameters& identified) {
  const auto not_found_out = [](const std::exception& error) -> DecayScatter {
    return {{}, fmt::format("whether frequencies of decays differ was not found out: {}", error.what())};
  };
  try {
    return {scatter_of_decays(identified()), ""};
  } catch (const InputError& error) {
    return not_found_out(error);
  } catch (const NumericalFailure& failure) {
    return not_found_out(failure);
  }
}

}  // namespace secular
