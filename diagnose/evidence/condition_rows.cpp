#include "diagnose/evidence/condition_rows.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "diagnose/evidence/followed_lines.hpp"
#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Nothing measured is trusted beyond this share of the largest line of its kind: truncated lines and leakage of
/// what was not fitted are of this size.
constexpr auto& line_floor = diagnose_thresholds().trusted_share;

}  // namespace

ConditionRows ConditionModel::rows(const Condition& condition, const VectorXd& unknowns,
                                   const Motion* start) const {
  const std::size_t symbols = balance_.model().symbols.size();
  const Faults faults = table_.faults(unknowns.data() + symbols);
  return ConditionEvaluation(condition, balance_, sensors_, faults, {unknowns.data(), symbols}).rows(start);
}

ConditionForecast ConditionModel::forecast(const Condition& condition, const VectorXcd& amplitudes,
                                           const VectorXd& unknowns, const Motion* start) const {
  const std::size_t symbols = balance_.model().symbols.size();
  const Faults faults = table_.faults(unknowns.data() + symbols);
  return ConditionEvaluation(condition, balance_, sensors_, faults, {unknowns.data(), symbols})
      .forecast(amplitudes, start);
}

MatrixXd ConditionModel::slopes(const Condition& condition, const VectorXd& unknowns, const MatrixXcd& displacement,
                                const std::vector<std::size_t>& which, const VectorXd& scale) const {
  const std::size_t symbols = balance_.model().symbols.size();
  HeldLines here = held(condition, unknowns, displacement);
  const FollowedLines lines(here, displacement);
  MatrixXd slopes(lines.rows(), static_cast<Index>(which.size()));
  std::vector<std::size_t> in_equations;
  std::vector<Index> columns;
  for (std::size_t w = 0; w < which.size(); ++w) {
    const auto column = static_cast<Index>(w), u = static_cast<Index>(which[w]);
    if (which[w] < symbols && !is_shape(which[w])) {
      in_equations.push_back(which[w]);
      columns.push_back(column);
      continue;
    }
    const auto at = [&](double value) {
      VectorXd moved = unknowns;
      moved(u) = value;
      if (which[w] < symbols) return here.at(lines.path(), {moved.data(), symbols}, lines.slaves());
      HeldLines there = held(condition, moved, displacement);
      return there.at(there.path(displacement), lines.slaves());
    };
    const HeldLines::Values up = at(unknowns(u) + 0.5 * scale(column)),
                            down = at(unknowns(u) - 0.5 * scale(column));
    slopes.col(column) = lines.change(up.rows - down.rows, up.steps - down.steps);
  }
  const HeldLines::Slopes by_symbol = here.symbol_slopes(lines.path(), in_equations, slopes.rows(), lines.slaves());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto column = static_cast<Index>(i);
    slopes.col(columns[i]) =
        scale(columns[i]) * lines.change(by_symbol.rows.col(column), by_symbol.steps.col(column));
  }
  return slopes;
}

HeldLines ConditionModel::held(const Condition& condition, const VectorXd& unknowns,
                               const MatrixXcd& displacement) const {
  const std::size_t symbols = balance_.model().symbols.size();
  return {condition,   balance_, sensors_, table_.faults(unknowns.data() + symbols), {unknowns.data(), symbols},
          displacement};
}

// Forces whose law the equations of motion do not hold depend on their shapes in ways that these do not show.
bool ConditionModel::is_shape(std::size_t symbol) const {
  return std::any_of(balance_.forces().begin(), balance_.forces().end(),
                     [symbol](const StateForce& force) { return force.shape_symbol == symbol; });
}

std::vector<RowMeaning> ConditionModel::meanings(const Condition& condition) const {
  std::vector<RowMeaning> rows;
  const auto push = [&](RowMeaning meaning, bool real) {
    rows.push_back(meaning);
    if (real) return;
    meaning.imaginary = true;
    rows.push_back(meaning);
  };
  for (const MasterLine& master : condition.masters)
    push({RowMeaning::Kind::balance, master.mode, 0, master.line, false}, false);
  for (std::size_t c = 0; c < sensors_.responses.size(); ++c)
    for (const Index line : condition.lines) push({RowMeaning::Kind::response, 0, c, line, false}, line == 0);
  for (std::size_t j = 0; j < static_cast<std::size_t>(condition.excitation.rows()); ++j)
    for (const Index line : condition.excitation_lines)
      if (line != condition.tone_of(static_cast<Index>(j)))
        push({RowMeaning::Kind::excitation, 0, j, line, false}, line == 0);
  return rows;
}

// The cut of a channel that saturates moves with the lines that follow, which only a motion that is solved for
// shows.
MatrixXd ConditionModel::covariance(const Condition& condition, const VectorXd& unknowns,
                                    const ConditionRows& here) const {
  const Index size = here.values.size();
  if (!here.values.allFinite()) return MatrixXd::Constant(size, size, std::numeric_limits<double>::quiet_NaN());
  const Faults faults = table_.faults(unknowns.data() + balance_.model().symbols.size());
  const bool saturates = std::any_of(faults.response.begin(), faults.response.end(),
                                     [](const ChannelFaults& fault) { return fault.saturates(); });
  const MatrixXcd& displacement = here.motion.displacement;
  std::optional<FollowedLines> lines;
  if (!saturates) {
    HeldLines measured = held(condition, unknowns, displacement);
    lines.emplace(measured, displacement);
  }
  MatrixXd covariance = MatrixXd::Zero(size, size);
  Condition moved = condition;
  const auto change = [&] {
    if (saturates) return VectorXd(rows(moved, unknowns, &here.motion).values - here.values);
    HeldLines there = held(moved, unknowns, displacement);
    const HeldLines::Values values = there.at(there.path(displacement), lines->slaves());
    return lines->change(values.rows - lines->here().rows, values.steps - lines->here().steps);
  };
  const auto add = [&](double sd) {
    if (!(sd > 0)) return;
    const VectorXd difference = change();
    covariance += difference * difference.transpose();
  };
  const auto vary = [&](Complex& value, double sd, bool real) {
    const Complex kept = value;
    value = kept + sd;
    add(sd);
    if (!real) {
      value = kept + Complex(0, sd);
      add(sd);
    }
    value = kept;
  };
  // A line that no motion follows from is in its own rows alone.
  const std::vector<RowMeaning> meanings = this->meanings(condition);
  const auto stays_alone = [&](RowMeaning::Kind kind, std::size_t channel, Index line, double sd) {
    for (std::size_t r = 0; r < meanings.size(); ++r)
      if (meanings[r].kind == kind && meanings[r].channel == channel && meanings[r].line == line)
        covariance(static_cast<Index>(r), static_cast<Index>(r)) += sd * sd;
  };
  const auto is_master = [&](Index line) {
    return std::any_of(condition.masters.begin(), condition.masters.end(),
                       [line](const MasterLine& master) { return master.line == line; });
  };
  for (Index c = 0; c < condition.response.rows(); ++c) {
    const double largest = condition.response.row(c).cwiseAbs().maxCoeff();
    for (std::size_t l = 0; l < condition.lines.size(); ++l) {
      const auto column = static_cast<Index>(l);
      const Index line = condition.lines[l];
      const double sd = std::hypot(condition.response_sd(c, column), line_floor * largest);
      if (saturates || is_master(line))
        vary(moved.response(c, column), sd, line == 0);
      else
        stays_alone(RowMeaning::Kind::response, static_cast<std::size_t>(c), line, sd);
    }
  }
  for (Index j = 0; j < condition.excitation.rows(); ++j) {
    const double largest = condition.excitation.row(j).cwiseAbs().maxCoeff();
    for (std::size_t l = 0; l < condition.excitation_lines.size(); ++l) {
      const auto column = static_cast<Index>(l);
      const Index line = condition.excitation_lines[l];
      const double sd = std::hypot(condition.excitation_sd(j, column), line_floor * largest);
      if (line == 0 || line == condition.tone_of(j))
        vary(moved.excitation(j, column), sd, line == 0);
      else
        stays_alone(RowMeaning::Kind::excitation, static_cast<std::size_t>(j), line, sd);
    }
  }
  for (std::size_t m = 0; m < condition.amplitude_drift_rate_sd.size(); ++m)
    vary(moved.amplitude_drift_rate[m], condition.amplitude_drift_rate_sd[m], false);
  return covariance;
}

}  // namespace secular
