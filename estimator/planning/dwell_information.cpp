#include "estimator/planning/dwell_information.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "estimator/model/block_frequency.hpp"
#include "estimator/model/by_name.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool is_used(const RegressorBlock& block) {
  return block.kind == BlockKind::modulation || block.order <= 1;
}

// Observed frequency of a mode: of the locked frame, plus the frequency shift of one whose phase is free.
double observed_frequency(const CompiledModel& model, const CompiledCase& resonance, const VectorXd& parameters,
                          const DwellState& state, std::size_t mode) {
  const std::size_t modes = model.modes(), columns = modes + model.excitations.size();
  double frequency = state.frequency_shift[mode];
  for (std::size_t c = 0; c < columns; ++c) {
    const Ratio r = resonance.observed_frequency[mode * columns + c];
    frequency += static_cast<double>(r.numerator) / r.denominator *
                 (c < modes ? parameters(static_cast<Index>(c)) : state.frequency);
  }
  return frequency;
}

// The first-order model of one dwell: what its equations see, and what noise makes of their residuals. States are
// (Re B_0, Im B_0, Re B_1, ...).
class Dwell {
 public:
  Dwell(const PlannedTest& test, const DwellState& state)
      : case_(test.resonance),
        modes_(test.model.modes()),
        values_(test.parameters),
        unknowns_(test.unknowns),
        noise_(test.noise),
        state_(state),
        frequency_(modes_, 0.0) {
    for (std::size_t k = 0; k < modes_; ++k) {
      amplitudes_.push_back(&state.amplitude[k]);
      if (case_.mode_at_rest[k]) continue;
      active_.push_back(static_cast<Index>(k));
      frequency_[k] = observed_frequency(test.model, case_, values_, state, k);
    }
  }

  const std::vector<Index>& active() const { return active_; }

  // Columns of every unknown in the modulation equations, real rows (Re, Im) by mode.
  MatrixXd modulation_columns() const {
    MatrixXd columns = MatrixXd::Zero(states(), static_cast<Index>(unknowns_.names.size()));
    for (const RegressorBlock& block : case_.blocks)
      if (block.kind == BlockKind::modulation) columns.middleRows(2 * block.mode, 2) = rows_of(block);
    add_natural_frequencies(columns);
    return columns;
  }

  // Information of the harmonics that the record resolves, each with its own noise.
  MatrixXd harmonic_information(double repeats) const {
    const auto size = static_cast<Index>(unknowns_.names.size());
    MatrixXd information = MatrixXd::Zero(size, size);
    const double resolution = two_pi / noise_.ensemble_s, half_rate = 0.5 * two_pi * noise_.sample_rate_hz;
    for (const RegressorBlock& block : case_.blocks) {
      if (block.kind == BlockKind::modulation || !is_used(block)) continue;
      const double at =
          block_frequency(block, [&](std::size_t i) { return i < modes_ ? frequency_[i] : state_.frequency; });
      if (std::abs(at) < 2 * resolution || std::abs(at) > half_rate) continue;
      const double sd = amplitude_sd(static_cast<std::size_t>(block.mode), std::abs(at));
      const MatrixXd rows = rows_of(block);
      information += repeats / (sd * sd) * rows.transpose() * rows;
    }
    return information;
  }

  // What noise makes of the residual i (observed - frame) B - dB/dt.
  MatrixXd residual_covariance(const Eigen::Ref<const MatrixXd>& symmetry, double repeats) const {
    MatrixXd covariance = MatrixXd::Zero(states(), states());
    add_amplitude_noise(covariance, repeats);
    add_force_noise(covariance, repeats);
    add_free_phases(covariance, symmetry, repeats);
    return covariance;
  }

 private:
  Index states() const { return static_cast<Index>(2 * modes_); }
  // Of an amplitude of displacement, from the spectrum of an ensemble at a frequency in rad/s.
  double amplitude_sd(std::size_t mode, double frequency) const {
    return noise_.response_sd[mode] / std::sqrt(2 * noise_.samples()) / std::pow(frequency, noise_.derivatives);
  }

  // Columns of a block at given parameters (natural frequencies).
  std::vector<Complex> columns_of(const RegressorBlock& block, const VectorXd& parameters) const {
    std::vector<Complex> column(block.lumps.size());
    std::vector<Complex*> pointers;
    for (Complex& c : column) pointers.push_back(&c);
    const Complex* forcings[] = {&forcing_};
    const double* excitations[] = {&state_.frequency};
    block.columns({1, parameters.data(), excitations, amplitudes_.data(), forcings}, pointers.data());
    return column;
  }

  MatrixXd rows_of(const RegressorBlock& block) const {
    const std::vector<Complex> column = columns_of(block, values_);
    MatrixXd rows = MatrixXd::Zero(2, static_cast<Index>(unknowns_.names.size()));
    for (std::size_t j = 0; j < column.size(); ++j)
      for (Index u = 0; u < rows.cols(); ++u)
        if (unknowns_.lump[static_cast<std::size_t>(u)] == block.lumps[j])
          rows.col(u) << column[j].real(), column[j].imag();
    return rows;
  }

  // A natural frequency stands in the equation by itself and, weakly, in the coefficients.
  void add_natural_frequencies(MatrixXd& columns) const {
    std::vector<double> lumps(case_.lumps.size());
    case_.evaluate_lumps(values_.data(), lumps.data());
    for (Index u = 0; u < columns.cols(); ++u) {
      const int mode = unknowns_.mode[static_cast<std::size_t>(u)];
      if (mode < 0) continue;
      const Complex turned = Complex(0, 1) * state_.amplitude[static_cast<std::size_t>(mode)];
      columns(2 * mode, u) = turned.real();
      columns(2 * mode + 1, u) = turned.imag();
      const double step = 1e-4 * values_(mode);
      for (const double side : {-1.0, 1.0}) {
        VectorXd moved = values_;
        moved(mode) += side * step;
        for (const RegressorBlock& block : case_.blocks) {
          if (block.kind != BlockKind::modulation) continue;
          const std::vector<Complex> column = columns_of(block, moved);
          Complex sum = 0;
          for (std::size_t j = 0; j < column.size(); ++j)
            sum += column[j] * lumps[static_cast<std::size_t>(block.lumps[j])];
          sum *= side / (2 * step);
          columns(2 * block.mode, u) += sum.real();
          columns(2 * block.mode + 1, u) += sum.imag();
        }
      }
    }
  }

  // Noise of a sample, and the scatter from dwell to dwell, which moves all amplitudes together.
  void add_amplitude_noise(MatrixXd& covariance, double repeats) const {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(states(), states());
    case_.modulation_jacobian(values_.data(), &state_.frequency, state_.amplitude.data(), &forcing_,
                              jacobian.data());
    MatrixXd slope = -MatrixXd(jacobian);
    for (const Index k : active_) {
      const double shift = state_.frequency_shift[static_cast<std::size_t>(k)];
      slope(2 * k, 2 * k + 1) -= shift;
      slope(2 * k + 1, 2 * k) += shift;
    }
    VectorXd scatter = VectorXd::Zero(states());
    for (const Index k : active_) {
      const auto m = static_cast<std::size_t>(k);
      const double variance = std::pow(amplitude_sd(m, frequency_[m]), 2) / repeats;
      covariance += variance * (slope.col(2 * k) * slope.col(2 * k).transpose() +
                                slope.col(2 * k + 1) * slope.col(2 * k + 1).transpose());
      const Complex b = state_.amplitude[m];
      scatter += noise_.dwell_scatter * (slope.col(2 * k) * b.real() + slope.col(2 * k + 1) * b.imag());
    }
    covariance += scatter * scatter.transpose();
  }

  void add_force_noise(MatrixXd& covariance, double repeats) const {
    const double force_sd = noise_.excitation_sd * std::sqrt(2 / noise_.samples() / repeats);
    if (!(force_sd > 0)) return;
    std::vector<Complex> up(modes_), down(modes_);
    for (const Complex direction : {Complex(1, 0), Complex(0, 1)}) {
      const double step = 1e-4 * state_.forcing;
      const Complex above = forcing_ + step * direction, below = forcing_ - step * direction;
      case_.modulation(values_.data(), &state_.frequency, state_.amplitude.data(), &above, up.data());
      case_.modulation(values_.data(), &state_.frequency, state_.amplitude.data(), &below, down.data());
      VectorXd change(states());
      for (std::size_t k = 0; k < modes_; ++k) {
        const Complex d = (up[k] - down[k]) / (2 * step);
        change(static_cast<Index>(2 * k)) = d.real();
        change(static_cast<Index>(2 * k) + 1) = d.imag();
      }
      covariance += force_sd * force_sd * change * change.transpose();
    }
  }

  // The frequency along a free phase is measured: 24 sd^2/(a^2 N T^2) for each mode's own tone.
  void add_free_phases(MatrixXd& covariance, const Eigen::Ref<const MatrixXd>& symmetry, double repeats) const {
    for (Index r = 0; r < symmetry.rows(); ++r) {
      double weight = 0;
      VectorXd direction = VectorXd::Zero(states());
      for (const Index k : active_) {
        const auto m = static_cast<std::size_t>(k);
        const Complex b = state_.amplitude[m];
        const double turn = symmetry(r, k), peak = 2 * std::abs(b) * std::pow(frequency_[m], noise_.derivatives);
        const double variance = 24 * std::pow(noise_.response_sd[m] / peak, 2) /
                                (noise_.samples() * noise_.ensemble_s * noise_.ensemble_s);
        if (turn != 0 && variance > 0) weight += turn * turn / variance;
        const Complex turned = Complex(0, turn) * b;
        direction(2 * k) = turned.real();
        direction(2 * k + 1) = turned.imag();
      }
      if (weight > 0) covariance += direction * direction.transpose() / (weight * repeats);
    }
  }

  const CompiledCase& case_;
  std::size_t modes_;
  const VectorXd& values_;
  const PlanUnknowns& unknowns_;
  const PlanningNoise& noise_;
  const DwellState& state_;
  Complex forcing_ = state_.forcing;
  std::vector<const Complex*> amplitudes_;
  std::vector<Index> active_;  // modes that are not at rest
  std::vector<double> frequency_;
};

}  // namespace

bool is_lump_or_frequency(const CompiledModel& model, const CompiledCase& resonance, const std::string& name) {
  return place_of(resonance.lumps, name) || place_of(model.symbols.first(model.modes()), name);
}

PlanUnknowns plan_unknowns(const CompiledModel& model, const CompiledCase& resonance,
                           const Eigen::Ref<const VectorXd>& parameters, const std::vector<std::string>& fixed) {
  std::vector<double> lumps(resonance.lumps.size());
  resonance.evaluate_lumps(parameters.data(), lumps.data());
  PlanUnknowns unknowns;
  std::vector<double> values;
  const auto add = [&](std::string_view name, int lump, int mode, double value) {
    const std::string text(name);
    if (std::find(fixed.begin(), fixed.end(), text) != fixed.end()) return;
    if (std::find(unknowns.names.begin(), unknowns.names.end(), text) != unknowns.names.end()) return;
    unknowns.names.push_back(text);
    unknowns.lump.push_back(lump);
    unknowns.mode.push_back(mode);
    values.push_back(value);
  };
  for (const BlockKind kind : {BlockKind::modulation, BlockKind::harmonic})
    for (const RegressorBlock& block : resonance.blocks) {
      if (block.kind != kind || !is_used(block)) continue;
      // The zero-frequency component is not recorded by accelerometers.
      const bool constant = std::all_of(block.phase.begin(), block.phase.end(), [](int n) { return n == 0; });
      if (kind == BlockKind::harmonic && constant) continue;
      for (const int l : block.lumps)
        add(resonance.lumps[static_cast<std::size_t>(l)].name, l, -1, lumps[static_cast<std::size_t>(l)]);
    }
  for (std::size_t k = 0; k < model.modes(); ++k)
    if (!resonance.mode_at_rest[k])
      add(model.symbols[k].name, -1, static_cast<int>(k), parameters(static_cast<Index>(k)));
  for (const std::string& name : fixed)
    if (!is_lump_or_frequency(model, resonance, name))
      throw std::invalid_argument("'" + name + "' is no lump and no natural frequency");
  unknowns.values = Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
  return unknowns;
}

MatrixXd dwell_information(const PlannedTest& test, const DwellState& state,
                           const Eigen::Ref<const MatrixXd>& symmetry, int ensembles) {
  const Dwell dwell(test, state);
  const MatrixXd columns = dwell.modulation_columns();
  std::vector<Index> rows;
  for (const Index k : dwell.active()) rows.insert(rows.end(), {2 * k, 2 * k + 1});
  // Rows in units of their own deviation: modes differ by orders of magnitude.
  const MatrixXd part = dwell.residual_covariance(symmetry, ensembles)(rows, rows);
  const VectorXd unit = part.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  const Eigen::LLT<MatrixXd> cholesky(
      MatrixXd(unit.asDiagonal() * part * unit.asDiagonal()) +
      1e-12 * MatrixXd::Identity(static_cast<Index>(rows.size()), static_cast<Index>(rows.size())));
  MatrixXd whitened = unit.asDiagonal() * columns(rows, Eigen::all);
  cholesky.matrixL().solveInPlace(whitened);
  return dwell.harmonic_information(ensembles) + whitened.transpose() * whitened;
}

}  // namespace secular
