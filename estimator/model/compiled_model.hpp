#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "estimator/model/excitation_sample.hpp"
#include "estimator/model/lanes.hpp"
#include "estimator/model/model_function.hpp"

/// What generated code offers to the estimator and the simulator: plain tables and functions, no symbols.
///
/// Conventions. A mode's oscillation is v = B exp(i*w*t) + conj(B) exp(-i*w*t) + harmonics: B is half the peak
/// amplitude. An excitation is F cos(W*t + phase), handed over as the complex number F exp(i*phase), whose modulus
/// is the full peak amplitude. Frequencies are in rad/s.
namespace secular {

/// A rational number, used for exponents of units and for frequencies.
struct Ratio {
  int numerator = 0;
  int denominator = 1;
};

/// A symbol of the model. `dimension` holds its unit as powers of: each coordinate's unit, each excitation's unit,
/// the second (in this order); empty where the equations do not fix it.
struct CompiledSymbol {
  std::string_view name;
  std::span<const Ratio> dimension;
};

/// A parameter combination that multiplies data: `definition` is readable text in the model's symbols.
struct CompiledLump {
  std::string_view name;
  std::string_view definition;
  std::span<const Ratio> dimension;
};

/// Data of one batch of observations, structure of arrays: [index][observation].
struct ObservationBatch {
  std::size_t count = 0;
  const double* natural_frequency = nullptr;               ///< [mode], one value for all observations
  const double* const* excitation_frequency = nullptr;     ///< [excitation][observation]
  const std::complex<double>* const* amplitude = nullptr;  ///< [mode][observation], B as above
  const std::complex<double>* const* forcing = nullptr;    ///< [excitation][observation], F exp(i*phase)
};

enum class BlockKind { modulation, harmonic };

/// One complex equation, linear in lumps: target = sum_j column_j * lump_j with complex columns and real lumps.
/// modulation: target = (rate - i*w) * B, where rate = growth + i*(observed angular frequency) of mode `mode`;
/// harmonic:   target = complex amplitude of exp(i*observed frequency*t) in mode `mode`, half of the real amplitude
///             (the full real value at zero frequency). Its observed frequency is sum_j phase[j] * f_j over the
///             modes' observed frequencies and then the excitations' frequencies.
struct RegressorBlock {
  BlockKind kind = BlockKind::modulation;
  std::string_view name;
  int mode = 0;
  int order = 0;  ///< lowest power of eps at which its terms appear
  std::span<const int> phase;
  std::span<const int> lumps;  ///< indices into CompiledCase::lumps, one a column
  /// Fills columns[j][observation]. Output arrays must not overlap one another or the data.
  ModelFunction<void(const ObservationBatch& data, std::complex<double>* const* columns)> columns;
  /// columns[j][observation] = d(column j)/d(natural frequency of `mode`).
  ModelFunction<void(const ObservationBatch& data, std::size_t mode, std::complex<double>* const* columns)>
      column_slopes;
};

/// One resonance case of the model, derived by the method of multiple scales.
struct CompiledCase {
  std::string_view name;
  bool excited = false;  ///< false: derived with F = 0 (free decay)
  /// Resonance relations, each a row over the natural frequencies and then the excitations' frequencies whose
  /// weighted sum is (nearly) zero; row-major.
  std::span<const int> relations;
  /// Observed frequency of every mode: [mode][natural frequencies..., excitation frequencies...], row-major; a mode
  /// locked to half of the excitation has 1/2 in the excitation's column and 0 elsewhere.
  std::span<const Ratio> observed_frequency;
  std::span<const bool> mode_at_rest;  ///< [mode]
  std::span<const CompiledLump> lumps;
  std::span<const RegressorBlock> blocks;
  /// lumps[l] from the model's parameters (order of CompiledModel::symbols).
  ModelFunction<void(const double* parameters, double* lumps)> evaluate_lumps;
  /// jacobian[l * symbols + p] = d lump_l / d parameter_p.
  ModelFunction<void(const double* parameters, double* jacobian)> evaluate_lumps_jacobian;
  /// dB/dt of every mode in the frame that rotates with its observed frequency: zero at a steady state.
  ModelFunction<void(const double* parameters, const double* excitation_frequency,
                     const std::complex<double>* amplitude, const std::complex<double>* forcing,
                     std::complex<double>* derivative)>
      modulation;
  /// Its derivative by Cartesian amplitudes: with z = (Re B_0, Im B_0, Re B_1, ...) and dz/dt = f(z),
  /// jacobian[i * 2 * modes + j] = d f_i / d z_j. Safe at zero amplitude.
  ModelFunction<void(const double* parameters, const double* excitation_frequency,
                     const std::complex<double>* amplitude, const std::complex<double>* forcing, double* jacobian)>
      modulation_jacobian;
};

/// A model: its equations of motion and its cases.
struct CompiledModel {
  std::string_view name;
  std::string_view source;
  std::string_view fingerprint;  ///< digest of the equations and cases this code was made from
  std::span<const std::string_view> coordinates;
  std::span<const std::string_view> excitations;             ///< amplitude symbols: F, F2, ...
  std::span<const std::string_view> excitation_frequencies;  ///< Omega, Omega2, ...
  std::span<const CompiledSymbol> symbols;  ///< every parameter, natural frequencies first, by mode
  std::span<const double> nominal;          ///< by symbol; NaN where the model gives none
  std::span<const CompiledCase> cases;
  /// Of the full equations of motion, never of the expansion. excitation: [excitation]; displacement, velocity:
  /// [mode].
  using MotionFunction = ModelFunction<void(const double* parameters, const ExcitationSample* excitation,
                                            const double* displacement, const double* velocity, double* result)>;
  MotionFunction mass_matrix;   ///< [equation][mode], row-major
  MotionFunction acceleration;  ///< [mode], solved from the state-dependent mass matrix
  /// The same of several motions at once, each number to the last bit. Empty: they are computed one by one.
  ModelFunction<void(const LaneParameter* parameters, const LaneSample* excitation, const Lanes* displacement,
                     const Lanes* velocity, Lanes* result)>
      acceleration_of_lanes;
  /// [mode][displacements..., velocities...] and [mode][symbol], row-major: derivatives of the accelerations. Of
  /// nonsmooth terms the classical derivative on either side, zero at the corner.
  MotionFunction acceleration_by_state, acceleration_by_parameters;

  std::size_t modes() const { return coordinates.size(); }
};

/// Number of this interface: its version, and the sizes that a compiler or a standard library may choose otherwise.
/// A shared object of generated code is taken only if both sides compute the same.
constexpr std::uint64_t compiled_model_abi() {
  std::uint64_t number = 5;
  for (const std::size_t size :
       {sizeof(CompiledModel), sizeof(CompiledCase), sizeof(RegressorBlock), sizeof(CompiledLump),
        sizeof(CompiledSymbol), sizeof(Ratio), sizeof(ObservationBatch), sizeof(ExcitationSample),
        sizeof(std::span<const int>), sizeof(std::string_view), sizeof(std::complex<double>), sizeof(void*),
        sizeof(Lanes)})
    number = number * 1099511628211ULL + size;
  return number;
}

}  // namespace secular
