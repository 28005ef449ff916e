#include "estimator/planning/dwell_information.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool is_used(const RegressorBlock& block) {
  return block.kind == BlockKind::modulation || block.order <= 1;
}

// Observed frequency of a mode: of the locked frame, plus the drift of a free phase.
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

}  // namespace

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
  for (const std::string& name : fixed) {
    const bool lump = std::any_of(resonance.lumps.begin(), resonance.lumps.end(),
                                  [&](const CompiledLump& l) { return l.name == name; });
    const bool frequency =
        std::any_of(model.symbols.begin(), model.symbols.begin() + static_cast<std::ptrdiff_t>(model.modes()),
                    [&](const CompiledSymbol& s) { return s.name == name; });
    if (!lump && !frequency) throw std::invalid_argument("'" + name + "' is no lump and no natural frequency");
  }
  unknowns.values = Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
  return unknowns;
}

MatrixXd dwell_information(const CompiledModel& model, const CompiledCase& resonance,
                           const Eigen::Ref<const VectorXd>& parameters, const DwellState& state,
                           const Eigen::Ref<const MatrixXd>& symmetry, const PlanUnknowns& unknowns,
                           const PlanningNoise& noise, int ensembles) {
  const std::size_t modes = model.modes();
  const auto size = static_cast<Index>(unknowns.names.size()), states = static_cast<Index>(2 * modes);
  std::vector<Index> active;
  for (std::size_t k = 0; k < modes; ++k)
    if (!resonance.mode_at_rest[k]) active.push_back(static_cast<Index>(k));
  const double n = noise.samples(), repeats = ensembles;
  const Complex forcing = state.forcing;
  const VectorXd values = parameters;
  std::vector<double> frequency(modes, 0.0), amplitude_sd(modes, 0.0);
  for (const Index k : active) {
    const auto m = static_cast<std::size_t>(k);
    frequency[m] = observed_frequency(model, resonance, values, state, m);
    amplitude_sd[m] = noise.response_sd[m] / std::sqrt(2 * n) / std::pow(frequency[m], noise.derivatives);
  }

  // Columns of every unknown in the modulation equations, real rows (Re, Im) by mode.
  MatrixXd columns = MatrixXd::Zero(states, size);
  MatrixXd information = MatrixXd::Zero(size, size);
  std::vector<const Complex*> amplitudes;
  for (const Complex& b : state.amplitude) amplitudes.push_back(&b);
  const Complex* forcings[] = {&forcing};
  const double* excitations[] = {&state.frequency};
  const ObservationBatch batch{1, values.data(), excitations, amplitudes.data(), forcings};
  for (const RegressorBlock& block : resonance.blocks) {
    if (!is_used(block)) continue;
    std::vector<Complex> column(block.lumps.size());
    std::vector<Complex*> pointers;
    for (Complex& c : column) pointers.push_back(&c);
    block.columns(batch, pointers.data());
    MatrixXd rows = MatrixXd::Zero(2, size);
    for (std::size_t j = 0; j < column.size(); ++j)
      for (Index u = 0; u < size; ++u)
        if (unknowns.lump[static_cast<std::size_t>(u)] == block.lumps[j])
          rows.col(u) << column[j].real(), column[j].imag();
    if (block.kind == BlockKind::modulation) {
      columns.middleRows(2 * block.mode, 2) = rows;
      continue;
    }
    double at = 0;
    for (std::size_t i = 0; i < block.phase.size(); ++i)
      at += block.phase[i] * (i < modes ? frequency[i] : state.frequency);
    const double resolution = 2 * 3.141592653589793 / noise.ensemble_s;
    if (std::abs(at) < 2 * resolution || std::abs(at) > 3.141592653589793 * noise.sample_rate_hz) continue;
    const double sd = noise.response_sd[static_cast<std::size_t>(block.mode)] / std::sqrt(2 * n) /
                      std::pow(std::abs(at), noise.derivatives);
    information += repeats / (sd * sd) * rows.transpose() * rows;
  }
  // A natural frequency stands in the equation by itself and, weakly, in the coefficients.
  std::vector<double> lumps(resonance.lumps.size());
  resonance.evaluate_lumps(values.data(), lumps.data());
  for (Index u = 0; u < size; ++u) {
    const int mode = unknowns.mode[static_cast<std::size_t>(u)];
    if (mode < 0) continue;
    const Complex turned = Complex(0, 1) * state.amplitude[static_cast<std::size_t>(mode)];
    columns(2 * mode, u) = turned.real();
    columns(2 * mode + 1, u) = turned.imag();
    const double step = 1e-4 * values(mode);
    for (const double side : {-1.0, 1.0}) {
      VectorXd moved = values;
      moved(mode) += side * step;
      for (const RegressorBlock& block : resonance.blocks) {
        if (block.kind != BlockKind::modulation) continue;
        std::vector<Complex> column(block.lumps.size());
        std::vector<Complex*> pointers;
        for (Complex& c : column) pointers.push_back(&c);
        block.columns({1, moved.data(), excitations, amplitudes.data(), forcings}, pointers.data());
        Complex sum = 0;
        for (std::size_t j = 0; j < column.size(); ++j)
          sum += column[j] * lumps[static_cast<std::size_t>(block.lumps[j])];
        sum *= side / (2 * step);
        columns(2 * block.mode, u) += sum.real();
        columns(2 * block.mode + 1, u) += sum.imag();
      }
    }
  }

  // What noise makes of the misfit i (observed - frame) B - dB/dt.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(states, states);
  resonance.modulation_jacobian(values.data(), &state.frequency, state.amplitude.data(), &forcing, jacobian.data());
  MatrixXd slope = -MatrixXd(jacobian);
  for (const Index k : active) {
    const double shift = state.frequency_shift[static_cast<std::size_t>(k)];
    slope(2 * k, 2 * k + 1) -= shift;
    slope(2 * k + 1, 2 * k) += shift;
  }
  MatrixXd covariance = MatrixXd::Zero(states, states);
  VectorXd scatter = VectorXd::Zero(states);
  for (const Index k : active) {
    const double variance = std::pow(amplitude_sd[static_cast<std::size_t>(k)], 2) / repeats;
    covariance += variance * (slope.col(2 * k) * slope.col(2 * k).transpose() +
                              slope.col(2 * k + 1) * slope.col(2 * k + 1).transpose());
    const Complex b = state.amplitude[static_cast<std::size_t>(k)];
    scatter += noise.repeatability * (slope.col(2 * k) * b.real() + slope.col(2 * k + 1) * b.imag());
  }
  covariance += scatter * scatter.transpose();
  const double force_sd = noise.excitation_sd * std::sqrt(2 / n / repeats);
  if (force_sd > 0) {
    std::vector<Complex> up(modes), down(modes);
    for (const Complex direction : {Complex(1, 0), Complex(0, 1)}) {
      const double step = 1e-4 * state.forcing;
      const Complex above = forcing + step * direction, below = forcing - step * direction;
      resonance.modulation(values.data(), &state.frequency, state.amplitude.data(), &above, up.data());
      resonance.modulation(values.data(), &state.frequency, state.amplitude.data(), &below, down.data());
      VectorXd change(states);
      for (std::size_t k = 0; k < modes; ++k) {
        const Complex d = (up[k] - down[k]) / (2 * step);
        change(static_cast<Index>(2 * k)) = d.real();
        change(static_cast<Index>(2 * k) + 1) = d.imag();
      }
      covariance += force_sd * force_sd * change * change.transpose();
    }
  }
  // The frequency along a free phase is measured: 24 sd^2/(a^2 N T^2) for each mode's own tone.
  for (Index r = 0; r < symmetry.rows(); ++r) {
    double weight = 0;
    VectorXd direction = VectorXd::Zero(states);
    for (const Index k : active) {
      const Complex b = state.amplitude[static_cast<std::size_t>(k)];
      const double turn = symmetry(r, k),
                   peak = 2 * std::abs(b) * std::pow(frequency[static_cast<std::size_t>(k)], noise.derivatives);
      const double variance = 24 * std::pow(noise.response_sd[static_cast<std::size_t>(k)] / peak, 2) /
                              (n * noise.ensemble_s * noise.ensemble_s);
      if (turn != 0 && variance > 0) weight += turn * turn / variance;
      const Complex turned = Complex(0, turn) * b;
      direction(2 * k) = turned.real();
      direction(2 * k + 1) = turned.imag();
    }
    if (weight > 0) covariance += direction * direction.transpose() / (weight * repeats);
  }

  std::vector<Index> rows;
  for (const Index k : active) rows.insert(rows.end(), {2 * k, 2 * k + 1});
  // Rows in units of their own deviation: modes differ by orders of magnitude.
  const MatrixXd part = covariance(rows, rows);
  const VectorXd unit = part.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  const Eigen::LLT<MatrixXd> cholesky(
      MatrixXd(unit.asDiagonal() * part * unit.asDiagonal()) +
      1e-12 * MatrixXd::Identity(static_cast<Index>(rows.size()), static_cast<Index>(rows.size())));
  MatrixXd whitened = unit.asDiagonal() * columns(rows, Eigen::all);
  cholesky.matrixL().solveInPlace(whitened);
  return information + whitened.transpose() * whitened;
}

}  // namespace secular
