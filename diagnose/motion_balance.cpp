#include "diagnose/motion_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::RowVectorXcd;

constexpr int iteration_limit = 200;
constexpr double tolerance = 1e-10;

RowVectorXcd line_rates(const MotionSetting& setting) {
  RowVectorXcd rates(setting.torus->lines());
  for (Index l = 0; l < rates.size(); ++l) rates(l) = setting.line_rate(l);
  return rates;
}

}  // namespace

Complex line_rate(const Torus& torus, const std::array<Complex, 2>& rate, Index line) {
  const LinePhase& n = torus.phase(line);
  Complex sum = 0;
  for (std::size_t j = 0; j < 2; ++j) sum += Complex(std::abs(n[j]) * rate[j].real(), n[j] * rate[j].imag());
  return sum;
}

Eigen::RowVectorXd slider_stretch(const Eigen::RowVectorXd& path, double slip) {
  Eigen::RowVectorXd stretch(path.size());
  double z = 0, before = path(path.size() - 1);
  for (int turn = 0; turn < 2; ++turn)
    for (Index i = 0; i < path.size(); ++i) {
      z = std::clamp(z + path(i) - before, -slip, slip);
      before = path(i);
      stretch(i) = z;
    }
  return stretch;
}

Motion MotionBalance::solve(const MotionSetting& setting, const Eigen::VectorXcd& amplitudes,
                            std::span<const double> parameters, const Motion* start) const {
  const Torus& torus = *setting.torus;
  const auto modes = static_cast<Index>(model_->modes());
  const Index lines = torus.lines(), points = torus.points();
  const RowVectorXcd rates = line_rates(setting);

  Motion motion;
  motion.displacement = start ? start->displacement : MatrixXcd::Zero(modes, lines);
  motion.balance.resize(static_cast<Index>(setting.masters.size()));
  double scale = 0;
  for (std::size_t m = 0; m < setting.masters.size(); ++m) {
    const MasterLine& master = setting.masters[m];
    motion.displacement(static_cast<Index>(master.mode), master.line) = amplitudes(static_cast<Index>(m));
    scale = std::max(scale, std::abs(amplitudes(static_cast<Index>(m))));
  }
  // Compliance of the slaved lines, zero for masters and for resonant lines on which the mode is at rest.
  MatrixXcd compliance(modes, lines);
  for (Index k = 0; k < modes; ++k) {
    const double stiffness = parameters[static_cast<std::size_t>(k)] * parameters[static_cast<std::size_t>(k)];
    for (Index l = 0; l < lines; ++l) {
      const Complex dynamic = stiffness + rates(l) * rates(l);
      compliance(k, l) = std::abs(dynamic) < resonant_band * stiffness ? Complex(0) : 1.0 / dynamic;
    }
  }
  for (const MasterLine& master : setting.masters) compliance(static_cast<Index>(master.mode), master.line) = 0;

  const MatrixXd force = torus.samples(setting.excitation);
  const MatrixXd force_rate = torus.samples(setting.excitation * rates.asDiagonal());
  const MatrixXd force_acceleration =
      torus.samples(setting.excitation * rates.cwiseAbs2().asDiagonal() * Complex(-1));
  std::vector<ExcitationSample> excitation(model_->excitations.size());
  MatrixXd acceleration(modes, points);
  MatrixXcd residual;
  // Strong forces on a slaved line make the plain iteration overshoot: its steps are shortened as soon as they
  // grow.
  double share = 1, before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < iteration_limit; ++i) {
    const MatrixXd position = torus.samples(motion.displacement);
    const MatrixXd velocity = torus.samples(motion.displacement * rates.asDiagonal());
    std::vector<Eigen::RowVectorXd> stretch;
    for (const MemorySlot& slot : memory_)
      stretch.push_back(slider_stretch(position.row(static_cast<Index>(slot.mode)), parameters[slot.slip_symbol]));
    for (Index p = 0; p < points; ++p) {
      for (std::size_t j = 0; j < excitation.size(); ++j) {
        const auto row = static_cast<Index>(j);
        excitation[j] = row < force.rows()
                            ? ExcitationSample{force(row, p), force_rate(row, p), force_acceleration(row, p)}
                            : ExcitationSample{};
      }
      for (std::size_t s = 0; s < memory_.size(); ++s) excitation[memory_[s].excitation] = {stretch[s](p), 0, 0};
      model_->acceleration(parameters.data(), excitation.data(), position.col(p).data(), velocity.col(p).data(),
                           acceleration.col(p).data());
    }
    residual = torus.coefficients(acceleration) - motion.displacement * rates.cwiseProduct(rates).asDiagonal();
    const MatrixXcd step = residual.cwiseProduct(compliance);
    if (!step.allFinite()) break;
    const double length = step.cwiseAbs().maxCoeff();
    if (length > before) share = std::max(0.05, 0.5 * share);
    before = length;
    motion.displacement += share * step;
    const double size = std::max(scale, motion.displacement.cwiseAbs().maxCoeff());
    if (length <= tolerance * size) {
      motion.converged = true;
      break;
    }
  }
  for (std::size_t m = 0; m < setting.masters.size(); ++m)
    motion.balance(static_cast<Index>(m)) =
        residual(static_cast<Index>(setting.masters[m].mode), setting.masters[m].line);
  return motion;
}

}  // namespace secular
