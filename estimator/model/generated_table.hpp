#pragma once

#include <complex>
#include <cstddef>

#include "estimator/model/batch_arrays.hpp"
#include "estimator/model/compiled_model.hpp"

/// Generated functions, which take plain arrays, as the tables of compiled_model.hpp call them. A template's
/// parameters say how many modes, excitations and columns its function has.
namespace secular {

/// Arrays of complex numbers as pairs of real and imaginary parts: what the standard allows for std::complex.
inline const double* parts_of(const std::complex<double>* values) {
  return reinterpret_cast<const double*>(values);
}
inline double* parts_of(std::complex<double>* values) {
  return reinterpret_cast<double*>(values);
}

/// A batch and the columns made of it as plain arrays.
template <std::size_t modes, std::size_t excitations, std::size_t columns>
class PlainBatch {
 public:
  PlainBatch(const ObservationBatch& data, std::complex<double>* const* values) {
    for (std::size_t k = 0; k < modes; ++k) amplitude_[k] = parts_of(data.amplitude[k]);
    for (std::size_t j = 0; j < excitations && data.forcing != nullptr; ++j)
      forcing_[j] = parts_of(data.forcing[j]);
    for (std::size_t j = 0; j < columns; ++j) columns_[j] = parts_of(values[j]);
    batch_ = {data.count, data.natural_frequency, data.excitation_frequency, amplitude_, forcing_};
  }
  PlainBatch(const PlainBatch&) = delete;
  PlainBatch& operator=(const PlainBatch&) = delete;

  const BatchArrays& data() const { return batch_; }
  double* const* values() const { return columns_; }

 private:
  const double* amplitude_[modes];
  const double* forcing_[excitations + 1] = {};
  double* columns_[columns];
  BatchArrays batch_;
};

template <void (*function)(const BatchArrays&, double* const*), std::size_t... sizes>
void column_function(const ObservationBatch& data, std::complex<double>* const* columns) {
  const PlainBatch<sizes...> batch(data, columns);
  function(batch.data(), batch.values());
}
template <void (*function)(const BatchArrays&, std::size_t, double* const*), std::size_t... sizes>
void column_slope_function(const ObservationBatch& data, std::size_t mode, std::complex<double>* const* columns) {
  const PlainBatch<sizes...> batch(data, columns);
  function(batch.data(), mode, batch.values());
}

/// Functions of Cartesian amplitudes.
template <void (*function)(const double*, const double*, const double*, const double*, double*)>
void modulation_function(const double* parameters, const double* excitation_frequency,
                         const std::complex<double>* amplitude, const std::complex<double>* forcing,
                         std::complex<double>* derivative) {
  function(parameters, excitation_frequency, parts_of(amplitude), parts_of(forcing), parts_of(derivative));
}
template <void (*function)(const double*, const double*, const double*, const double*, double*)>
void jacobian_function(const double* parameters, const double* excitation_frequency,
                       const std::complex<double>* amplitude, const std::complex<double>* forcing,
                       double* jacobian) {
  function(parameters, excitation_frequency, parts_of(amplitude), parts_of(forcing), jacobian);
}

}  // namespace secular
