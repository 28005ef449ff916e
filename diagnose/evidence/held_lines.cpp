#include "diagnose/evidence/held_lines.hpp"

#include <utility>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Slaved lines are moved by this share of the largest line to find what depends on them.
constexpr double line_step = 1e-6;

}  // namespace

HeldLines::HeldLines(const Condition& condition, const MotionBalance& balance, const SensorModel& sensors,
                     const Faults& faults, std::span<const double> parameters, const MatrixXcd& displacement)
    : balance_(balance),
      faults_(faults),
      evaluation_(condition, balance, sensors, faults_, parameters),
      setting_(evaluation_.setting()),
      sweep_(balance.model(), balance.forces(), setting_),
      amplitudes_(evaluation_.readings().master_amplitudes(displacement)) {}

std::vector<SlavedLine> HeldLines::slaves() const {
  return slaved_lines(setting_, balance_.model(), evaluation_.parameters());
}

BalanceSweep::Path HeldLines::path(MatrixXcd displacement) const {
  place_masters(setting_, amplitudes_, displacement);
  return sweep_.path(std::move(displacement));
}

HeldLines::Values HeldLines::at(const BalanceSweep::Path& path, const std::vector<SlavedLine>& slaves) {
  return values(path, evaluation_.parameters(), slaves);
}

HeldLines::Values HeldLines::at(const BalanceSweep::Path& path, std::span<const double> parameters,
                                const std::vector<SlavedLine>& slaves) {
  return values(path, evaluation_.at_condition(parameters), slaves);
}

HeldLines::Slopes HeldLines::symbol_slopes(const BalanceSweep::Path& path, const std::vector<std::size_t>& symbols,
                                           Index rows, const std::vector<SlavedLine>& slaves) {
  const std::vector<MatrixXcd> slopes = sweep_.parameter_slopes(path, evaluation_.parameters(), symbols);
  Slopes result{MatrixXd::Zero(rows, static_cast<Index>(symbols.size())),
                MatrixXd(gathered(slaves, path.lines).size(), static_cast<Index>(symbols.size()))};
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const auto column = static_cast<Index>(i);
    const MatrixXcd slope = slopes[i] * evaluation_.factor_at_condition(symbols[i]);
    // A row of the equations of motion is the masters' balance over their amplitudes.
    const VectorXcd balance = balance_of_masters(setting_, slope).cwiseQuotient(amplitudes_);
    for (Index m = 0; m < balance.size(); ++m) {
      result.rows(2 * m, column) = balance(m).real();
      result.rows(2 * m + 1, column) = balance(m).imag();
    }
    result.steps.col(column) = BalanceSweep::steps(slaves, slope);
  }
  return result;
}

HeldLines::AlongLines HeldLines::along_lines(const BalanceSweep::Path& path,
                                             const std::vector<SlavedLine>& slaves) {
  const double motion = path.lines.cwiseAbs().maxCoeff();
  const double step = line_step * (motion > 0 ? motion : evaluation_.measured_displacement());
  const MatrixXcd residual = sweep_.residual(path, evaluation_.parameters());
  const MatrixXcd slopes = sweep_.residual_slopes(path, evaluation_.parameters(), slaves, step);
  const Values here{rows(path.lines, residual), BalanceSweep::steps(slaves, residual)};
  Slopes result{MatrixXd(here.rows.size(), slopes.cols()), MatrixXd(slopes.cols(), slopes.cols())};
  for (Index s = 0; s < slopes.cols(); ++s) {
    const MatrixXcd slope = slopes.col(s).reshaped(residual.rows(), residual.cols());
    result.rows.col(s) = (rows(with_step(slaves, path.lines, s, step), residual + step * slope) - here.rows) / step;
    result.steps.col(s) = BalanceSweep::steps(slaves, slope);
  }
  return {here, result};
}

VectorXd HeldLines::rows(const MatrixXcd& displacement, const MatrixXcd& residual) const {
  return evaluation_.rows_of(amplitudes_,
                             {displacement, balance_of_masters(setting_, residual), SolverEnding::converged});
}

HeldLines::Values HeldLines::values(const BalanceSweep::Path& path, std::span<const double> parameters,
                                    const std::vector<SlavedLine>& slaves) {
  const MatrixXcd residual = sweep_.residual(path, parameters);
  return {rows(path.lines, residual), BalanceSweep::steps(slaves, residual)};
}

}  // namespace secular
