#include "diagnose/balance_sweep.hpp"

#include <algorithm>
#include <cmath>

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
      const bool is_master = std::any_of(setting.masters.begin(), setting.masters.end(), [&](const MasterLine& m) {
        return static_cast<Index>(m.mode) == k && m.line == l;
      });
      const double frequency = parameters[static_cast<std::size_t>(k)], stiffness = frequency * frequency;
      const Complex rate = setting.line_rate(l), dynamic = stiffness + rate * rate;
      if (!is_master && std::abs(dynamic) >= resonant_band * stiffness) slaves.push_back({k, l, 1.0 / dynamic});
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

BalanceSweep::BalanceSweep(const CompiledModel& model, const std::vector<StateForce>& forces,
                           const MotionSetting& setting, std::span<const double> parameters)
    : model_(model),
      forces_(forces),
      torus_(*setting.torus),
      parameters_(parameters),
      rates_(torus_.lines()),
      acceleration_(static_cast<Index>(model.modes()), torus_.points()),
      excitation_(model.excitations.size()) {
  for (Index l = 0; l < rates_.size(); ++l) rates_(l) = setting.line_rate(l);
  force_ = torus_.samples(setting.excitation);
  force_rate_ = torus_.samples(setting.excitation * rates_.asDiagonal());
  force_acceleration_ = torus_.samples(setting.excitation * rates_.cwiseAbs2().asDiagonal() * Complex(-1));
}

MatrixXcd BalanceSweep::residual(const MatrixXcd& displacement) {
  const MatrixXd position = torus_.samples(displacement);
  const MatrixXd velocity = torus_.samples(displacement * rates_.asDiagonal());
  std::vector<Eigen::RowVectorXd> signals;
  for (const StateForce& force : forces_)
    signals.push_back(parameters_[force.strength_symbol] == 0
                          ? Eigen::RowVectorXd::Zero(position.cols())
                          : signal_over_turn(force, position, velocity, parameters_[force.shape_symbol]));
  for (Index p = 0; p < position.cols(); ++p) {
    for (std::size_t j = 0; j < excitation_.size(); ++j) {
      const auto row = static_cast<Index>(j);
      excitation_[j] = row < force_.rows()
                           ? ExcitationSample{force_(row, p), force_rate_(row, p), force_acceleration_(row, p)}
                           : ExcitationSample{};
    }
    for (std::size_t f = 0; f < forces_.size(); ++f) excitation_[forces_[f].excitation] = {signals[f](p), 0, 0};
    model_.acceleration(parameters_.data(), excitation_.data(), position.col(p).data(), velocity.col(p).data(),
                        acceleration_.col(p).data());
  }
  return torus_.coefficients(acceleration_) - displacement * rates_.cwiseProduct(rates_).asDiagonal();
}

VectorXd BalanceSweep::steps(const std::vector<SlavedLine>& slaves, const MatrixXcd& residual) {
  MatrixXcd steps = MatrixXcd::Zero(residual.rows(), residual.cols());
  for (const SlavedLine& s : slaves) steps(s.mode, s.line) = residual(s.mode, s.line) * s.compliance;
  return gathered(slaves, steps);
}

}  // namespace secular
