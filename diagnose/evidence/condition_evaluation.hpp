#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "diagnose/evidence/channel_readings.hpp"
#include "diagnose/evidence/condition_rows.hpp"

namespace secular {

/// One condition under given parameters and faults: amplitudes of the masters from what is measured
/// (ChannelReadings), the other lines from their balance (MotionBalance), and rows: what is measured minus what
/// this motion would show. References everything it is made from.
class ConditionEvaluation {
 public:
  ConditionEvaluation(const Condition& condition, const MotionBalance& balance, const SensorModel& sensors,
                      const Faults& faults, std::span<const double> parameters);

  MotionSetting setting() const;
  const ChannelReadings& readings() const { return readings_; }
  /// Parameters at the condition's time.
  const std::vector<double>& parameters() const { return parameters_; }
  std::vector<double> drifted(std::span<const double> parameters) const;
  /// What a parameter has become by the condition's time, over what it was.
  double drift(std::size_t symbol) const;
  /// The largest displacement that the strongest lines could be, 1 where nothing is seen: a size of motions beside
  /// rest.
  double measured_displacement() const;

  ConditionForecast forecast(const Eigen::VectorXcd& amplitudes, const Motion* start) const;
  ConditionRows rows(const Motion* start) const;
  /// Rows of a given motion.
  Eigen::VectorXd rows_of(const Eigen::VectorXcd& amplitudes, Motion motion) const;

 private:
  ConditionForecast forecast_of(const Eigen::VectorXcd& amplitudes, Motion motion) const;
  Eigen::VectorXd differences(const Eigen::VectorXcd& amplitudes, const ConditionForecast& expected) const;

  const Condition& c_;
  const MotionBalance& balance_;
  const SensorModel& sensors_;
  const Faults& faults_;
  ChannelReadings readings_;
  std::vector<double> parameters_;
};

}  // namespace secular
