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

  /// What the motion is solved in: the condition's lines and masters, the excitation without its faults.
  MotionSetting setting() const;
  const ChannelReadings& readings() const { return readings_; }
  /// Parameters at the condition's time.
  const std::vector<double>& parameters() const { return parameters_; }
  /// What parameters of the structure are in this record at the condition's time.
  std::vector<double> at_condition(std::span<const double> parameters) const;
  /// That of one symbol over what it is for all records: a natural frequency drifts and has an offset of a record's
  /// own.
  double factor_at_condition(std::size_t symbol) const;
  /// The largest displacement that the strongest lines could be, 1 where nothing is seen: a size of motions beside
  /// rest.
  double measured_displacement() const;

  /// With given amplitudes of the masters. `start`: as MotionBalance::solve takes it.
  ConditionForecast forecast(const Eigen::VectorXcd& amplitudes, const Motion* start) const;
  /// With the measured ones; where a channel saturates, its cut is undone together with the motion.
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
