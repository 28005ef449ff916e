#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/evidence/condition.hpp"
#include "diagnose/evidence/sensor_model.hpp"

namespace secular {

class HeldLines;

/// What a row of a discrepancy speaks of.
struct RowMeaning {
  enum class Kind { balance, response, excitation };
  Kind kind = Kind::balance;
  std::size_t mode = 0;     ///< balance
  std::size_t channel = 0;  ///< response, excitation
  Eigen::Index line = 0;
  bool imaginary = false;  ///< of balance over amplitude: the real part is conservative, the imaginary dissipative
};

/// The discrepancy of one condition: balance of every master over its amplitude (1/s^2), then measured minus
/// predicted lines of every channel (channel units), real and imaginary parts.
struct ConditionRows {
  Eigen::VectorXd values;
  Motion motion;
  Eigen::VectorXcd amplitudes;  ///< of the masters
};

/// What a condition's channels would show if its masters had given amplitudes.
struct ConditionForecast {
  Motion motion;
  Eigen::VectorXcd balance;     ///< by master, over its amplitude, 1/s^2: zero for a steady motion
  Eigen::MatrixXcd response;    ///< response channel x observed line
  Eigen::MatrixXcd excitation;  ///< excitation channel x excitation line
};

/// Turns unknowns (model's symbols, then the faults of `table`) into rows.
class ConditionModel {
 public:
  ConditionModel(const MotionBalance& balance, const SensorModel& sensors, const FaultTable& table)
      : balance_(balance), sensors_(sensors), table_(table) {}

  /// `start`: a motion near the one looked for, as MotionBalance::solve takes it; nullptr: none is known.
  ConditionRows rows(const Condition& condition, const Eigen::VectorXd& unknowns, const Motion* start) const;
  /// Change of the rows with some of the unknowns, per `scale` of each, near a motion in balance whose lines are
  /// `displacement`. The slaved lines' balance is linearised there, so that no column needs an iteration:
  /// parameters of the equations of motion by their derivatives, all others by central differences.
  Eigen::MatrixXd slopes(const Condition& condition, const Eigen::VectorXd& unknowns,
                         const Eigen::MatrixXcd& displacement, const std::vector<std::size_t>& which,
                         const Eigen::VectorXd& scale) const;
  /// Of every row, in their order.
  std::vector<RowMeaning> meanings(const Condition& condition) const;
  /// Of the condition only the excitation and the layout of lines count; `amplitudes` by master.
  ConditionForecast forecast(const Condition& condition, const Eigen::VectorXcd& amplitudes,
                             const Eigen::VectorXd& unknowns, const Motion* start) const;

  /// Covariance of the rows from the errors of everything measured in the condition, at `unknowns` about `here`,
  /// the rows there: each reading is changed by its error, and the slaved lines follow to first order. Not finite
  /// where no motion is found.
  Eigen::MatrixXd covariance(const Condition& condition, const Eigen::VectorXd& unknowns,
                             const ConditionRows& here) const;

  const SensorModel& sensors() const { return sensors_; }
  const MotionBalance& balance() const { return balance_; }

 private:
  HeldLines held(const Condition& condition, const Eigen::VectorXd& unknowns,
                 const Eigen::MatrixXcd& displacement) const;
  bool is_shape(std::size_t symbol) const;

  MotionBalance balance_;
  SensorModel sensors_;
  FaultTable table_;
};

}  // namespace secular
