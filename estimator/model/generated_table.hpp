#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <string_view>

#include "estimator/model/block_functions.hpp"
#include "estimator/model/compiled_model.hpp"
#include "estimator/model/lump_functions.hpp"

/// Generated functions, which take plain arrays, as the tables of compiled_model.hpp call them.
namespace secular {

/// What the functions of a case are made of: the tables of its model and its case.
struct GeneratedCase {
  const LumpFunctions* functions = nullptr;  ///< of the model's lumps
  std::span<const int> lumps;                ///< numbers of those of the case
  const BlockFunctions* block_functions = nullptr;
  std::span<const RegressorBlock> blocks;
  std::span<const Ratio> observed_frequency;
  std::span<const bool> mode_at_rest;
};

/// Values for one call, few of them on the stack. (Own models are compiled when they are used: <memory> and
/// <algorithm> would take a third of the time that this takes.)
template <class Value>
class CallValues {
 public:
  explicit CallValues(std::size_t count) : values_(count > few ? new Value[count] : few_) {}
  ~CallValues() {
    if (values_ != few_) delete[] values_;
  }
  CallValues(const CallValues&) = delete;
  CallValues& operator=(const CallValues&) = delete;
  Value* data() { return values_; }
  Value& operator[](std::size_t i) { return values_[i]; }

 private:
  static constexpr std::size_t few = 32;
  Value few_[few];
  Value* values_;
};

/// Arrays of complex numbers as pairs of real and imaginary parts: what the standard allows for std::complex.
inline const double* parts_of(const std::complex<double>* values) {
  return reinterpret_cast<const double*>(values);
}
inline double* parts_of(std::complex<double>* values) {
  return reinterpret_cast<double*>(values);
}

/// A batch and the columns made of it as plain arrays.
class PlainBatch {
 public:
  PlainBatch(const BlockFunctions& block, const ObservationBatch& data, std::complex<double>* const* values)
      : amplitude_(block.modes), forcing_(block.excitations), columns_(block.columns_count) {
    for (std::size_t k = 0; k < block.modes; ++k) amplitude_[k] = parts_of(data.amplitude[k]);
    for (std::size_t j = 0; j < block.excitations && data.forcing != nullptr; ++j)
      forcing_[j] = parts_of(data.forcing[j]);
    for (std::size_t j = 0; j < block.columns_count; ++j) columns_[j] = parts_of(values[j]);
    batch_ = {data.count, data.natural_frequency, data.excitation_frequency, amplitude_.data(), forcing_.data()};
  }

  const BatchArrays& data() const { return batch_; }
  double* const* columns() { return columns_.data(); }

 private:
  CallValues<const double*> amplitude_, forcing_;
  CallValues<double*> columns_;
  BatchArrays batch_;
};

inline void call_rows(const void* block, const ObservationBatch& data, std::complex<double>* const* columns) {
  const auto& functions = *static_cast<const BlockFunctions*>(block);
  PlainBatch batch(functions, data, columns);
  functions.columns(batch.data(), batch.columns());
}

inline void call_slopes(const void* block, const ObservationBatch& data, std::size_t mode,
                        std::complex<double>* const* columns) {
  const auto& functions = *static_cast<const BlockFunctions*>(block);
  if (functions.column_slopes == nullptr) {
    for (std::size_t j = 0; j < functions.columns_count; ++j)
      for (std::size_t i = 0; i < data.count; ++i) columns[j][i] = 0.0;
    return;
  }
  PlainBatch batch(functions, data, columns);
  functions.column_slopes(batch.data(), mode, batch.columns());
}

inline void call_lumps(const void* data, const double* parameters, double* lumps) {
  const auto& c = *static_cast<const GeneratedCase*>(data);
  if (!c.lumps.empty()) c.functions->values(parameters, c.lumps.data(), c.lumps.size(), lumps);
}

inline void call_lump_jacobian(const void* data, const double* parameters, double* jacobian) {
  const auto& c = *static_cast<const GeneratedCase*>(data);
  if (!c.lumps.empty()) c.functions->jacobian(parameters, c.lumps.data(), c.lumps.size(), jacobian);
}

/// The modulation equations at one point: for every mode that moves the sum of its block's columns times lumps,
/// less the turning of the observed frame, which is i*(w_k - omega_k)*B_k.
class ModulationPoint {
 public:
  ModulationPoint(const GeneratedCase& resonance, const double* parameters, const double* excitation_frequency,
                  const std::complex<double>* amplitude, const std::complex<double>* forcing)
      : case_(resonance),
        modes_(resonance.mode_at_rest.size()),
        frequencies_(resonance.observed_frequency.size() / modes_),
        parameters_(parameters),
        excitation_frequency_(excitation_frequency),
        amplitudes_(modes_),
        forcings_(frequencies_ - modes_),
        excitations_(frequencies_ - modes_),
        lumps_(resonance.lumps.size()) {
    for (std::size_t k = 0; k < modes_; ++k) amplitudes_[k] = parts_of(amplitude + k);
    for (std::size_t j = 0; j < frequencies_ - modes_; ++j) {
      forcings_[j] = parts_of(forcing + j);
      excitations_[j] = excitation_frequency + j;
    }
    std::size_t wanted = 0;  // a case's lumps stand in the order of its blocks, those of motions first
    for (const RegressorBlock& block : resonance.blocks)
      for (const int lump : block.lumps)
        if (const auto count = static_cast<std::size_t>(lump) + 1;
            block.kind == BlockKind::modulation && count > wanted)
          wanted = count;
    if (wanted != 0) resonance.functions->values(parameters, resonance.lumps.data(), wanted, lumps_.data());
    point_ = {1, parameters, excitations_.data(), amplitudes_.data(), forcings_.data()};
  }

  /// call(mode, functions, lumps of the block, point) of every block that moves.
  template <class Call>
  void each_block(const Call& call) {
    for (std::size_t b = 0; b < case_.blocks.size(); ++b) {
      const RegressorBlock& block = case_.blocks[b];
      const auto mode = static_cast<std::size_t>(block.mode);
      if (block.kind != BlockKind::modulation || case_.mode_at_rest[mode]) continue;
      CallValues<double> own(block.lumps.size());
      for (std::size_t j = 0; j < block.lumps.size(); ++j)
        own[j] = lumps_[static_cast<std::size_t>(block.lumps[j])];
      call(mode, case_.block_functions[b], own.data(), point_);
    }
  }

  /// w_k - omega_k; zero for a mode at rest.
  double turning(std::size_t mode) const {
    if (case_.mode_at_rest[mode]) return 0;
    double sum = 0;
    for (std::size_t i = 0; i < frequencies_; ++i) {
      const Ratio share = case_.observed_frequency[mode * frequencies_ + i];
      const int numerator = share.numerator - (i == mode ? share.denominator : 0);
      if (numerator != 0)
        sum += numerator * (i < modes_ ? parameters_[i] : excitation_frequency_[i - modes_]) / share.denominator;
    }
    return sum;
  }

 private:
  const GeneratedCase& case_;
  std::size_t modes_, frequencies_;
  const double *parameters_, *excitation_frequency_;
  CallValues<const double*> amplitudes_, forcings_, excitations_;
  CallValues<double> lumps_;
  BatchArrays point_;
};

inline void call_modulation(const void* data, const double* parameters, const double* excitation_frequency,
                            const std::complex<double>* amplitude, const std::complex<double>* forcing,
                            std::complex<double>* derivative) {
  const auto& resonance = *static_cast<const GeneratedCase*>(data);
  ModulationPoint at(resonance, parameters, excitation_frequency, amplitude, forcing);
  for (std::size_t k = 0; k < resonance.mode_at_rest.size(); ++k) {
    const double turning = at.turning(k);
    derivative[k] = {turning * amplitude[k].imag(), -turning * amplitude[k].real()};
  }
  at.each_block([&](std::size_t k, const BlockFunctions& block, const double* lumps, const BatchArrays& point) {
    double rate[2];
    block.rate(lumps, point, rate);
    derivative[k] += std::complex<double>(rate[0], rate[1]);
  });
}

inline void call_modulation_jacobian(const void* data, const double* parameters, const double* excitation_frequency,
                                     const std::complex<double>* amplitude, const std::complex<double>* forcing,
                                     double* jacobian) {
  const auto& resonance = *static_cast<const GeneratedCase*>(data);
  ModulationPoint at(resonance, parameters, excitation_frequency, amplitude, forcing);
  const std::size_t modes = resonance.mode_at_rest.size(), width = 2 * modes;
  for (std::size_t i = 0; i < width * width; ++i) jacobian[i] = 0;
  at.each_block([&](std::size_t k, const BlockFunctions& block, const double* lumps, const BatchArrays& point) {
    block.rate_by_amplitude(lumps, point, jacobian + 2 * k * width);
  });
  for (std::size_t j = 0; j < modes; ++j)
    for (std::size_t row = 0; row < width && resonance.mode_at_rest[j]; ++row)
      jacobian[row * width + 2 * j] = jacobian[row * width + 2 * j + 1] = 0;
  for (std::size_t k = 0; k < modes; ++k) {
    jacobian[2 * k * width + 2 * k + 1] += at.turning(k);
    jacobian[(2 * k + 1) * width + 2 * k] -= at.turning(k);
  }
}

/// What tables say of a block; `columns`: how many it has.
struct BlockTable {
  BlockKind kind;
  std::string_view name;
  int mode, order;
  std::size_t columns;
};

/// Blocks of a case. `lumps`: those of their columns, block after block; `phases`: multiples of all frequencies,
/// one harmonic after the other.
template <std::size_t count>
constexpr std::array<RegressorBlock, count> regressor_blocks(const BlockTable (&tables)[count],
                                                             const BlockFunctions* functions, const int* lumps,
                                                             const int* phases, std::size_t frequencies) {
  std::array<RegressorBlock, count> blocks;
  for (std::size_t b = 0; b < count; ++b) {
    const BlockTable& table = tables[b];
    blocks[b] = {table.kind,
                 table.name,
                 table.mode,
                 table.order,
                 {},
                 {lumps, table.columns},
                 {call_rows, functions + b},
                 {call_slopes, functions + b}};
    lumps += table.columns;
    if (table.kind == BlockKind::modulation) continue;
    blocks[b].phase = {phases, frequencies};
    phases += frequencies;
  }
  return blocks;
}

/// Those of a model's lumps that have these numbers.
template <std::size_t count>
constexpr std::array<CompiledLump, count> chosen_lumps(const CompiledLump* all, const int (&numbers)[count]) {
  std::array<CompiledLump, count> lumps;
  for (std::size_t l = 0; l < count; ++l) lumps[l] = all[numbers[l]];
  return lumps;
}

constexpr CompiledCase compiled_case(std::string_view name, bool excited, std::span<const int> relations,
                                     std::span<const CompiledLump> lumps, const GeneratedCase& generated) {
  return {.name = name,
          .excited = excited,
          .relations = relations,
          .observed_frequency = generated.observed_frequency,
          .mode_at_rest = generated.mode_at_rest,
          .lumps = lumps,
          .blocks = generated.blocks,
          .evaluate_lumps = {call_lumps, &generated},
          .evaluate_lumps_jacobian = {call_lump_jacobian, &generated},
          .modulation = {call_modulation, &generated},
          .modulation_jacobian = {call_modulation_jacobian, &generated}};
}

}  // namespace secular
