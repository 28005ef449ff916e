#pragma once

#include <complex>
#include <limits>

#include "estimator/model/compiled_model.hpp"

// An additive combination resonance Omega = omega1 + omega2 as generated code would offer it, with solutions known
// by hand: B1' = -mu1 B1 + i alpha |B1|^2 B1 - i F conj(B2) - i (O1 - omega1) B1 and the same for mode 2, each in
// the frame of its observed frequency O1 = omega1 + (Omega - omega1 - omega2)/2.
namespace secular::testing_support {

enum CombinationParameter { omega1, omega2, mu1, mu2, alpha, combination_parameters };

inline constexpr std::string_view combination_coordinates[] = {"v1", "v2"};
inline constexpr std::string_view combination_excitations[] = {"F"};
inline constexpr std::string_view combination_frequencies[] = {"Omega"};
inline constexpr CompiledSymbol combination_symbols[] = {
    {"omega1", {}}, {"omega2", {}}, {"mu1", {}}, {"mu2", {}}, {"alpha", {}}};
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
inline constexpr double combination_nominal[] = {unknown, unknown, unknown, unknown, unknown};
inline constexpr int combination_relations[] = {1, 1, -1};
inline constexpr Ratio combination_observed[] = {{1, 2}, {-1, 2}, {1, 2}, {-1, 2}, {1, 2}, {1, 2}};
inline constexpr bool combination_rest[] = {false, false};

inline void combination_modulation(const double* p, const double* frequency, const std::complex<double>* b,
                                   const std::complex<double>* forcing, std::complex<double>* rate) {
  const std::complex<double> i(0, 1);
  const double detuning = (frequency[0] - p[omega1] - p[omega2]) / 2;
  rate[0] =
      -(p[mu1] + i * detuning) * b[0] + i * p[alpha] * std::norm(b[0]) * b[0] - i * forcing[0] * std::conj(b[1]);
  rate[1] =
      -(p[mu2] + i * detuning) * b[1] + i * p[alpha] * std::norm(b[1]) * b[1] - i * forcing[0] * std::conj(b[0]);
}

inline const CompiledModel& combination_model() {
  static const CompiledCase cases[] = {[] {
    CompiledCase resonance;
    resonance.name = "combination";
    resonance.excited = true;
    resonance.relations = combination_relations;
    resonance.observed_frequency = combination_observed;
    resonance.mode_at_rest = combination_rest;
    resonance.modulation = combination_modulation;
    return resonance;
  }()};
  static const CompiledModel model = [] {
    CompiledModel m;
    m.name = "combination";
    m.coordinates = combination_coordinates;
    m.excitations = combination_excitations;
    m.excitation_frequencies = combination_frequencies;
    m.symbols = combination_symbols;
    m.nominal = combination_nominal;
    m.cases = cases;
    return m;
  }();
  return model;
}

}  // namespace secular::testing_support
