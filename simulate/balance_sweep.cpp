#include "simulate/balance_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<SlavedLine> slaved_lines(const MotionSetting& setting, const CompiledModel& model,
                                     std::span<const double> parameters) {
  std::vector<SlavedLine> slaves;
  for (Index l = 0; l < setting.torus->lines(); ++l)
    for (Index k = 0; k < static_cast<Index>(model.modes()); ++k) {
      const auto is_this = [&](const MasterLine& m) { return static_cast<Index>(m.mode) == k && m.line == l; };
      const bool known = std::any_of(setting.masters.begin(), setting.masters.end(), is_this) ||
                         std::any_of(setting.resting.begin(), setting.resting.end(), is_this);
      const double frequency = parameters[static_cast<std::size_t>(k)], stiffness = frequency * frequency;
      const Complex rate = setting.line_rate(l), dynamic = stiffness + rate * rate;
      if (!known && std::abs(dynamic) >= resonant_band * stiffness) slaves.push_back({k, l, 1.0 / dynamic});
    }
  return slaves;
}

VectorXd gathered(const std::vector<SlavedLine>& slaves, const MatrixXcd& all) {
  Index size = 0;
  for (const SlavedLine& s : slaves) size += s.line == 0 ? 1 : 2;
  VectorXd values(size);
  Index at = 0;
  for (const SlavedLine& s : slaves) {
    const Complex value = all(s.mode, s.line);
    values(at++) = value.real();
    if (s.line != 0) values(at++) = value.imag();
  }
  return values;
}

void scattered(const std::vector<SlavedLine>& slaves, const VectorXd& values, MatrixXcd& all) {
  Index at = 0;
  for (const SlavedLine& s : slaves) {
    const double real = values(at++);
    all(s.mode, s.line) = Complex(real, s.line == 0 ? 0 : values(at++));
  }
}

MatrixXcd with_step(const std::vector<SlavedLine>& slaves, const MatrixXcd& all, Index entry, double step) {
  VectorXd values = gathered(slaves, all);
  values(entry) += step;
  MatrixXcd moved = all;
  scattered(slaves, values, moved);
  return moved;
}

BalanceSweep::BalanceSweep(const CompiledModel& model, std::vector<StateForce> forces, const MotionSetting& setting)
    : model_(model),
      forces_(std::move(forces)),
      torus_(*setting.torus),
      rates_(torus_.lines()),
      acceleration_(static_cast<Index>(model.modes()), torus_.points()),
      excitation_(model.excitations.size()) {
  for (Index l = 0; l < rates_.size(); ++l) rates_(l) = setting.line_rate(l);
  force_ = torus_.samples(setting.excitation);
  force_rate_ = torus_.samples(setting.excitation * rates_.asDiagonal());
  force_acceleration_ = torus_.samples(setting.excitation * rates_.cwiseAbs2().asDiagonal() * Complex(-1));
}

BalanceSweep::Path BalanceSweep::path(MatrixXcd displacement) const {
  MatrixXd position = torus_.samples(displacement);
  MatrixXd velocity = torus_.samples(displacement * rates_.asDiagonal());
  return {std::move(displacement), std::move(position), std::move(velocity)};
}

const MatrixXd& BalanceSweep::accelerations(const MatrixXd& position, const MatrixXd& velocity,
                                            std::span<const double> parameters) {
  std::vector<Signal> signals;
  for (const StateForce& force : forces_)
    if (parameters[force.strength_symbol] != 0)
      signals.push_back(
          {force.excitation, signal_over_turn(force, position, velocity, parameters[force.shape_symbol])});
  std::fill(excitation_.begin(), excitation_.end(), ExcitationSample{});
  for (Index p = 0; p < position.cols(); ++p) {
    for (Index j = 0; j < force_.rows(); ++j)
      excitation_[static_cast<std::size_t>(j)] = {force_(j, p), force_rate_(j, p), force_acceleration_(j, p)};
    for (const Signal& signal : signals) excitation_[signal.excitation] = {signal.values(p), 0, 0};
    model_.acceleration(parameters.data(), excitation_.data(), position.col(p).data(), velocity.col(p).data(),
                        acceleration_.col(p).data());
  }
  return acceleration_;
}

MatrixXcd BalanceSweep::residual(const Path& path, std::span<const double> parameters) {
  return torus_.coefficients(accelerations(path.position, path.velocity, parameters)) -
         path.lines * rates_.cwiseProduct(rates_).asDiagonal();
}

bool BalanceSweep::remembers(std::span<const double> parameters) const {
  return std::any_of(forces_.begin(), forces_.end(), [&](const StateForce& force) {
    return parameters[force.strength_symbol] != 0 && has_memory(force.law);
  });
}

MatrixXcd BalanceSweep::residual_slopes(const Path& path, std::span<const double> parameters,
                                        const std::vector<SlavedLine>& slaves, double length) {
  return remembers(parameters) ? slopes_by_line(path, parameters, slaves, length)
                               : slopes_by_point(path, parameters, slaves, length);
}

// What a line moves, every point feels through its own displacement and velocity alone: a pair of evaluations for
// each of these instead of one for each line.
MatrixXcd BalanceSweep::slopes_by_point(const Path& path, std::span<const double> parameters,
                                        const std::vector<SlavedLine>& slaves, double length) {
  const auto modes = path.position.rows(), points = path.position.cols();
  double fastest = 0;
  for (Index l = 0; l < rates_.size(); ++l) fastest = std::max(fastest, std::abs(rates_(l)));
  std::vector<MatrixXd> by_position, by_velocity;  // [coordinate]: accelerations x points
  for (Index k = 0; k < modes; ++k) {
    const auto slope = [&](bool of_velocity, double step) {
      MatrixXd position = path.position, velocity = path.velocity;
      (of_velocity ? velocity : position).row(k).array() += step;
      MatrixXd change = accelerations(position, velocity, parameters);
      (of_velocity ? velocity : position).row(k).array() -= 2 * step;
      change -= accelerations(position, velocity, parameters);
      return MatrixXd(change / (2 * step));
    };
    by_position.push_back(slope(false, length));
    by_velocity.push_back(slope(true, length * fastest));
  }
  struct Entry {
    Index mode, line;
    Complex unit;
  };
  std::vector<Entry> entries;
  for (const SlavedLine& s : slaves) {
    entries.push_back({s.mode, s.line, Complex(1, 0)});
    if (s.line != 0) entries.push_back({s.mode, s.line, Complex(0, 1)});
  }
  const Index lines = torus_.lines(), count = static_cast<Index>(entries.size());
  MatrixXd felt(count * modes, points);
  for (Index e = 0; e < count; ++e) {
    const Entry& entry = entries[static_cast<std::size_t>(e)];
    MatrixXcd alone = MatrixXcd::Zero(1, lines);
    alone(0, entry.line) = entry.unit;
    const Path moved = this->path(std::move(alone));
    const auto k = static_cast<std::size_t>(entry.mode);
    felt.middleRows(e * modes, modes) =
        by_position[k] * moved.position.row(0).asDiagonal() + by_velocity[k] * moved.velocity.row(0).asDiagonal();
  }
  const MatrixXcd changes = torus_.coefficients(felt);
  MatrixXcd slopes(modes * lines, count);
  for (Index e = 0; e < count; ++e) {
    const Entry& entry = entries[static_cast<std::size_t>(e)];
    MatrixXcd change = changes.middleRows(e * modes, modes);
    change(entry.mode, entry.line) -= entry.unit * rates_(entry.line) * rates_(entry.line);
    slopes.col(e) = change.reshaped();
  }
  return slopes;
}

// Forces with memory: the whole path counts.
MatrixXcd BalanceSweep::slopes_by_line(const Path& path, std::span<const double> parameters,
                                       const std::vector<SlavedLine>& slaves, double length) {
  const MatrixXcd base = residual(path, parameters);
  MatrixXcd slopes(base.size(), gathered(slaves, path.lines).size());
  for (Index s = 0; s < slopes.cols(); ++s)
    slopes.col(s) =
        ((residual(this->path(with_step(slaves, path.lines, s, length)), parameters) - base) / length).reshaped();
  return slopes;
}

VectorXd BalanceSweep::steps(const std::vector<SlavedLine>& slaves, const MatrixXcd& residual) {
  MatrixXcd steps = MatrixXcd::Zero(residual.rows(), residual.cols());
  for (const SlavedLine& s : slaves) steps(s.mode, s.line) = residual(s.mode, s.line) * s.compliance;
  return gathered(slaves, steps);
}

}  // namespace secular
