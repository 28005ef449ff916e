#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "diagnose/evidence/condition_evaluation.hpp"
#include "motion/balance/balance_sweep.hpp"

namespace secular {

/// Rows of a condition, and what its slaved lines lack to their balance, where these lines are held near
/// `displacement` instead of solved for. What they change of the cut of a channel that saturates is left out.
class HeldLines {
 public:
  /// `steps`: by entry of gathered(slaves), what BalanceSweep::steps makes of the residual.
  struct Values {
    Eigen::VectorXd rows, steps;
  };
  /// What moves with the slaved lines, or with symbols of the model: rows x entries, steps x entries.
  struct Slopes {
    Eigen::MatrixXd rows, steps;
  };

  /// With the lines of a path as they are, and what moves with them.
  struct AlongLines {
    Values here;
    Slopes by_line;
  };

  HeldLines(const Condition& condition, const MotionBalance& balance, const SensorModel& sensors,
            const Faults& faults, std::span<const double> parameters, const Eigen::MatrixXcd& displacement);
  HeldLines(const HeldLines&) = delete;
  HeldLines& operator=(const HeldLines&) = delete;

  /// At the parameters that this was made with.
  std::vector<SlavedLine> slaves() const;
  /// The motion with the masters at their measured amplitudes.
  BalanceSweep::Path path(Eigen::MatrixXcd displacement) const;

  /// With the lines of `path` as they are.
  Values at(const BalanceSweep::Path& path, const std::vector<SlavedLine>& slaves);
  /// With other parameters of the model.
  Values at(const BalanceSweep::Path& path, std::span<const double> parameters,
            const std::vector<SlavedLine>& slaves);

  /// Change per unit of some of the model's symbols, by their derivatives; `rows`: how many rows there are.
  Slopes symbol_slopes(const BalanceSweep::Path& path, const std::vector<std::size_t>& symbols, Eigen::Index rows,
                       const std::vector<SlavedLine>& slaves);
  /// Values, and their change with every entry of gathered(slaves), by one-sided differences.
  AlongLines along_lines(const BalanceSweep::Path& path, const std::vector<SlavedLine>& slaves);

 private:
  Eigen::VectorXd rows(const Eigen::MatrixXcd& displacement, const Eigen::MatrixXcd& residual) const;
  Values values(const BalanceSweep::Path& path, std::span<const double> parameters,
                const std::vector<SlavedLine>& slaves);

  const MotionBalance& balance_;
  Faults faults_;
  ConditionEvaluation evaluation_;
  MotionSetting setting_;
  BalanceSweep sweep_;
  Eigen::VectorXcd amplitudes_;
};

}  // namespace secular
