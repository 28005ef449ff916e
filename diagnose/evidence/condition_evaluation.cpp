#include "diagnose/evidence/condition_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

}  // namespace

ConditionEvaluation::ConditionEvaluation(const Condition& condition, const MotionBalance& balance,
                                         const SensorModel& sensors, const Faults& faults,
                                         std::span<const double> parameters)
    : c_(condition),
      balance_(balance),
      sensors_(sensors),
      faults_(faults),
      readings_(condition, sensors, faults),
      parameters_(at_condition(parameters)) {}

MotionSetting ConditionEvaluation::setting() const {
  MotionSetting setting{c_.torus, c_.rate,
                        MatrixXcd::Zero(static_cast<Index>(balance_.model().excitations.size()), c_.torus->lines()),
                        c_.masters, c_.resting};
  const MatrixXcd& excitation = readings_.true_excitation();
  for (Index j = 0; j < excitation.rows(); ++j)
    for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
      setting.excitation(j, c_.excitation_lines[l]) = excitation(j, static_cast<Index>(l));
  return setting;
}

std::vector<double> ConditionEvaluation::at_condition(std::span<const double> parameters) const {
  std::vector<double> values(parameters.begin(), parameters.end());
  for (std::size_t s = 0; s < values.size(); ++s) values[s] *= factor_at_condition(s);
  return values;
}

double ConditionEvaluation::factor_at_condition(std::size_t symbol) const {
  if (symbol >= faults_.frequency_drift.size()) return 1;
  const double of_time = 1 + faults_.frequency_drift[symbol] * c_.time_s;
  return c_.frequency_offset.size() > 0 ? of_time * (1 + c_.frequency_offset(static_cast<Index>(symbol))) : of_time;
}

double ConditionEvaluation::measured_displacement() const {
  double largest = 0;
  for (std::size_t l = 0; l < c_.lines.size(); ++l)
    if (c_.lines[l] != 0)
      largest = std::max(largest, c_.response.col(static_cast<Index>(l)).cwiseAbs().maxCoeff() /
                                      std::abs(derivative_power(c_.line_rate(c_.lines[l]), sensors_.derivatives)));
  return largest > 0 ? largest : 1;
}

ConditionForecast ConditionEvaluation::forecast(const VectorXcd& amplitudes, const Motion* start) const {
  return forecast_of(amplitudes, balance_.solve(setting(), amplitudes, parameters_, start));
}

// A cut is undone together with the motion whose other lines it is cut with.
ConditionRows ConditionEvaluation::rows(const Motion* start) const {
  ConditionRows rows;
  rows.amplitudes = readings_.master_amplitudes(start ? start->displacement : MatrixXcd());
  ConditionForecast expected = forecast(rows.amplitudes, start);
  if (readings_.response_saturates())
    for (int i = 0; i < most_undoings && expected.motion.converged(); ++i) {
      const VectorXcd next = readings_.master_amplitudes(expected.motion.displacement);
      const double change = (next - rows.amplitudes).norm();
      if (change <= undone_cut * next.norm()) break;
      rows.amplitudes = next;
      const Motion motion = std::move(expected.motion);
      expected = forecast(rows.amplitudes, &motion);
    }
  rows.values = differences(rows.amplitudes, expected);
  rows.motion = std::move(expected.motion);
  return rows;
}

VectorXd ConditionEvaluation::rows_of(const VectorXcd& amplitudes, Motion motion) const {
  return differences(amplitudes, forecast_of(amplitudes, std::move(motion)));
}

ConditionForecast ConditionEvaluation::forecast_of(const VectorXcd& amplitudes, Motion motion) const {
  ConditionForecast forecast;
  forecast.motion = std::move(motion);
  forecast.balance = forecast.motion.balance.cwiseQuotient(amplitudes);
  const MatrixXcd lines = readings_.predicted_responses(forecast.motion.displacement);
  forecast.response.resize(lines.rows(), static_cast<Index>(c_.lines.size()));
  for (std::size_t l = 0; l < c_.lines.size(); ++l)
    forecast.response.col(static_cast<Index>(l)) = lines.col(c_.lines[l]);
  forecast.excitation = readings_.expected_excitation();
  return forecast;
}

// Measured minus expected.
VectorXd ConditionEvaluation::differences(const VectorXcd& amplitudes, const ConditionForecast& expected) const {
  std::vector<double> values;
  const auto push = [&](Complex value, bool real) {
    values.push_back(value.real());
    if (!real) values.push_back(value.imag());
  };
  for (Index m = 0; m < amplitudes.size(); ++m) {
    Complex balance = expected.balance(m);
    // An amplitude B(t) exp(i w t) has the inertia -(s^2 B + 2 s dB/dt).
    if (!c_.amplitude_drift_rate.empty())
      balance -= 2.0 * c_.line_rate(c_.masters[static_cast<std::size_t>(m)].line) *
                 c_.amplitude_drift_rate[static_cast<std::size_t>(m)];
    push(balance, false);
  }
  for (Index c = 0; c < c_.response.rows(); ++c)
    for (Index l = 0; l < c_.response.cols(); ++l)
      push(c_.response(c, l) - expected.response(c, l), c_.lines[static_cast<std::size_t>(l)] == 0);
  for (Index j = 0; j < c_.excitation.rows(); ++j)
    for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
      if (c_.excitation_lines[l] != c_.tone_of(j))
        push(c_.excitation(j, static_cast<Index>(l)) - expected.excitation(j, static_cast<Index>(l)),
             c_.excitation_lines[l] == 0);
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

}  // namespace secular
