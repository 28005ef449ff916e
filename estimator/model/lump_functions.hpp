#pragma once

#include <cstddef>

/// Lumps of a model and their derivatives, from its generated structs: Lumps, built from the parameters, whose
/// member `list` holds the functions, and LumpGradients with `gradients`.
namespace secular {

struct LumpFunctions {
  /// values[l] = lump wanted[l].
  void (*values)(const double* parameters, const int* wanted, std::size_t count, double* values) = nullptr;
  /// jacobian[l * parameters + p] = d lump wanted[l] / d parameters[p].
  void (*jacobian)(const double* parameters, const int* wanted, std::size_t count, double* jacobian) = nullptr;
};

template <class Lumps>
void lump_values(const double* parameters, const int* wanted, std::size_t count, double* values) {
  const Lumps lumps(parameters);
  for (std::size_t l = 0; l < count; ++l) values[l] = (lumps.*Lumps::list[wanted[l]])();
}

template <class LumpGradients, std::size_t parameter_count>
void lump_jacobian(const double* parameters, const int* wanted, std::size_t count, double* jacobian) {
  const LumpGradients lumps(parameters);
  for (std::size_t i = 0; i < count * parameter_count; ++i) jacobian[i] = 0;
  for (std::size_t l = 0; l < count; ++l)
    (lumps.*LumpGradients::gradients[wanted[l]])(jacobian + l * parameter_count);
}

}  // namespace secular
