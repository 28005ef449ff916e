#pragma once

#include <algorithm>
#include <complex>
#include <vector>

#include "estimator/model/compiled_model.hpp"

/// Residuals of a case at measured amplitudes and derivatives by physical parameters. They follow from the tables
/// of a CompiledModel alone: rows are linear in lumps,
///   residual = observed - columns * lumps(parameters)             harmonic
///   residual = observed - i*omega_k*B_k - columns * lumps          modulation of mode k, observed = rate * B_k
/// with columns that depend on the natural frequencies, so that
///   d residual/d lump_j      = -column_j,
///   d residual/d parameter_p = -columns * d lumps/d p  - [p is omega_m] d columns/d omega_m * lumps
///                              - [modulation and p is omega_k] i*B_k.
/// Tests hold the tables of compiled and of interpreted models against digits and each other by them. The functions
/// take plain arrays one by one, as those of CompiledCase do, which is why they have up to seven parameters.
namespace secular::test {

using Complex = std::complex<double>;

namespace residual_parts {

inline constexpr std::size_t observations_at_once = 256;

inline Complex times_i(const Complex& z) {
  return {-z.imag(), z.real()};
}

// The observations from `first` on, at most observations_at_once of them, with natural frequencies from parameters.
class Part {
 public:
  Part(const CompiledModel& model, const ObservationBatch& data, const double* parameters, std::size_t first) {
    batch_.count = std::min(observations_at_once, data.count - first);
    batch_.natural_frequency = parameters;
    for (std::size_t k = 0; k < model.modes(); ++k) amplitude_.push_back(data.amplitude[k] + first);
    for (std::size_t j = 0; j < model.excitations.size(); ++j) {
      if (data.forcing) forcing_.push_back(data.forcing[j] + first);
      if (data.excitation_frequency) frequency_.push_back(data.excitation_frequency[j] + first);
    }
    batch_.amplitude = amplitude_.data();
    if (data.forcing) batch_.forcing = forcing_.data();
    if (data.excitation_frequency) batch_.excitation_frequency = frequency_.data();
  }
  const ObservationBatch& batch() const { return batch_; }

 private:
  ObservationBatch batch_;
  std::vector<const Complex*> amplitude_, forcing_;
  std::vector<const double*> frequency_;
};

// Columns of a block for up to observations_at_once observations.
class Columns {
 public:
  explicit Columns(const RegressorBlock& block) : values_(block.lumps.size() * observations_at_once) {
    for (std::size_t j = 0; j < block.lumps.size(); ++j)
      pointers_.push_back(values_.data() + j * observations_at_once);
  }
  Complex* const* data() const { return pointers_.data(); }
  const Complex* operator[](std::size_t j) const { return pointers_[j]; }

 private:
  std::vector<Complex> values_;
  std::vector<Complex*> pointers_;
};

inline std::vector<double> lumps_of(const CompiledCase& resonance, const double* parameters) {
  std::vector<double> lumps(resonance.lumps.size());
  resonance.evaluate_lumps(parameters, lumps.data());
  return lumps;
}

// sum[i] += weight * column[i]
inline void add(Complex* sum, double weight, const Complex* column, std::size_t count) {
  if (weight == 0) return;
  for (std::size_t i = 0; i < count; ++i) sum[i] += weight * column[i];
}

// d(columns * lumps)/d parameter of the blocks of a case.
class RightSideSlopes {
 public:
  RightSideSlopes(const CompiledModel& model, const CompiledCase& resonance, const double* parameters)
      : modes_(model.modes()),
        symbols_(model.symbols.size()),
        lumps_(lumps_of(resonance, parameters)),
        lump_jacobian_(lumps_.size() * symbols_) {
    resonance.evaluate_lumps_jacobian(parameters, lump_jacobian_.data());
  }

  // sum[p * stride + i] += sign * slope by parameter p of the observations i of one part.
  void add_to(Complex* sum, std::size_t stride, double sign, const RegressorBlock& block, const Part& part) const {
    const std::size_t count = part.batch().count;
    const Columns columns(block);
    block.columns(part.batch(), columns.data());
    for (std::size_t j = 0; j < block.lumps.size(); ++j)
      for (std::size_t p = 0; p < symbols_; ++p)
        add(sum + p * stride, sign * lump_jacobian_[static_cast<std::size_t>(block.lumps[j]) * symbols_ + p],
            columns[j], count);
    for (std::size_t mode = 0; mode < modes_; ++mode) {
      block.column_slopes(part.batch(), mode, columns.data());
      for (std::size_t j = 0; j < block.lumps.size(); ++j)
        add(sum + mode * stride, sign * lumps_[static_cast<std::size_t>(block.lumps[j])], columns[j], count);
    }
  }

 private:
  std::size_t modes_, symbols_;
  std::vector<double> lumps_, lump_jacobian_;
};

}  // namespace residual_parts

/// residual[observation] of one block; `parameters` in the order of CompiledModel::symbols (their first modes()
/// entries are the natural frequencies; data.natural_frequency is not read), observed[observation]. Arguments are
/// plain arrays, as generated code has them, and so many.
inline void block_residual(const CompiledModel& model, const CompiledCase& resonance, const RegressorBlock& block,
                           const double* parameters, const ObservationBatch& data, const Complex* observed,
                           Complex* residual) {
  using namespace residual_parts;
  const std::vector<double> lumps = lumps_of(resonance, parameters);
  const Columns columns(block);
  const auto mode = static_cast<std::size_t>(block.mode);
  for (std::size_t first = 0; first < data.count; first += observations_at_once) {
    const Part part(model, data, parameters, first);
    const std::size_t count = part.batch().count;
    Complex* const out = residual + first;
    std::copy_n(observed + first, count, out);
    if (block.kind == BlockKind::modulation)
      for (std::size_t i = 0; i < count; ++i) out[i] -= parameters[mode] * times_i(data.amplitude[mode][first + i]);
    block.columns(part.batch(), columns.data());
    for (std::size_t j = 0; j < block.lumps.size(); ++j)
      add(out, -lumps[static_cast<std::size_t>(block.lumps[j])], columns[j], count);
  }
}

/// jacobian[symbol][observation] = d residual/d parameter, symbol by symbol, contiguous.
inline void block_residual_by_parameters(const CompiledModel& model, const CompiledCase& resonance,
                                         const RegressorBlock& block, const double* parameters,
                                         const ObservationBatch& data, Complex* jacobian) {
  using namespace residual_parts;
  const RightSideSlopes slopes(model, resonance, parameters);
  const auto mode = static_cast<std::size_t>(block.mode);
  std::fill_n(jacobian, model.symbols.size() * data.count, Complex());
  for (std::size_t first = 0; first < data.count; first += observations_at_once) {
    const Part part(model, data, parameters, first);
    slopes.add_to(jacobian + first, data.count, -1, block, part);
    if (block.kind == BlockKind::modulation)
      for (std::size_t i = first; i < first + part.batch().count; ++i)
        jacobian[mode * data.count + i] -= times_i(data.amplitude[mode][i]);
  }
}

/// Derivative of CompiledCase::modulation by the parameters at one point: with z = (Re B_0, Im B_0, ...),
/// dz/dt = f(z, parameters), jacobian[i * symbols + p] = d f_i/d parameter_p; 2*modes rows. Arguments as there.
inline void modulation_by_parameters(const CompiledModel& model, const CompiledCase& resonance,
                                     const double* parameters, const double* excitation_frequency,
                                     const Complex* amplitude, const Complex* forcing, double* jacobian) {
  using namespace residual_parts;
  const std::size_t modes = model.modes(), symbols = model.symbols.size(), excitations = model.excitations.size();
  const RightSideSlopes slopes(model, resonance, parameters);
  std::vector<const Complex*> amplitudes, forcings;
  std::vector<const double*> frequencies;
  for (std::size_t k = 0; k < modes; ++k) amplitudes.push_back(amplitude + k);
  for (std::size_t j = 0; j < excitations; ++j) {
    forcings.push_back(forcing + j);
    frequencies.push_back(excitation_frequency + j);
  }
  const Part point(model, {1, parameters, frequencies.data(), amplitudes.data(), forcings.data()}, parameters, 0);
  std::vector<Complex> rate(modes * symbols);
  for (const RegressorBlock& block : resonance.blocks) {
    const auto mode = static_cast<std::size_t>(block.mode);
    if (block.kind != BlockKind::modulation || resonance.mode_at_rest[mode]) continue;
    slopes.add_to(rate.data() + mode * symbols, 1, 1, block, point);
  }
  // The frame turns with w_k - omega_k, w_k = sum of observed_frequency * (natural and excitation frequencies).
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t m = 0; m < modes && !resonance.mode_at_rest[k]; ++m) {
      const Ratio share = resonance.observed_frequency[k * (modes + excitations) + m];
      const double turning = static_cast<double>(share.numerator) / share.denominator - (m == k ? 1 : 0);
      rate[k * symbols + m] -= turning * times_i(amplitude[k]);
    }
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t p = 0; p < symbols; ++p) {
      jacobian[2 * k * symbols + p] = rate[k * symbols + p].real();
      jacobian[(2 * k + 1) * symbols + p] = rate[k * symbols + p].imag();
    }
}

}  // namespace secular::test
