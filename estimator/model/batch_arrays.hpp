#pragma once

#include <cstddef>

namespace secular {

/// ObservationBatch as generated code reads it: complex numbers are pairs of real and imaginary part. Generated
/// functions include no header of the C++ library that takes compilers long (<complex> alone: half a second).
struct BatchArrays {
  std::size_t count = 0;
  const double* natural_frequency = nullptr;            ///< [mode]
  const double* const* excitation_frequency = nullptr;  ///< [excitation][observation]
  const double* const* amplitude = nullptr;             ///< [mode][2 * observation]
  const double* const* forcing = nullptr;               ///< [excitation][2 * observation]
};

}  // namespace secular
