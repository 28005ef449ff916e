#pragma once

#include <cstddef>

namespace secular {

/// Arrays of pairs of real and imaginary part, which may stand in memory as arrays of std::complex<double>.
using ComplexParts __attribute__((may_alias)) = double*;
using ConstComplexParts __attribute__((may_alias)) = const double*;

/// ObservationBatch as generated code reads it: complex numbers are pairs of real and imaginary part. Generated
/// functions include no header of the C++ library that takes compilers long (<complex> alone: half a second).
struct BatchArrays {
  std::size_t count = 0;
  const double* natural_frequency = nullptr;            ///< [mode]
  const double* const* excitation_frequency = nullptr;  ///< [excitation][observation]
  const ConstComplexParts* amplitude = nullptr;         ///< [mode][2 * observation]
  const ConstComplexParts* forcing = nullptr;           ///< [excitation][2 * observation]
};

}  // namespace secular
