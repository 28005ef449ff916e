#pragma once

#include <vector>

#include "perturb/field.hpp"
#include "perturb/term_sum.hpp"
#include "perturb/time_scales.hpp"

namespace secular {

/// What the factors of the equations of motion are on the expansion as far as it is known, by powers of eps: every
/// coordinate and excitation with its first two time derivatives; clocks and nonsmooth factors when asked for.
class MotionSeries {
 public:
  /// Nothing moves yet but the excitations. `at_rest`: modes whose leading motion is rest; nonsmooth functions of
  /// them are left out. `products`: counts those of product().
  MotionSeries(PhaseRates rates, int highest_order, std::vector<bool> at_rest,
               ProductCount products = ProductCount());

  /// Takes over the coordinates at eps^order. Lower orders, once solved, stay as they are.
  void update(const std::vector<FieldSeries>& response, const AmplitudeRates& amplitude_rates, int order);

  const FieldSeries& coordinate(std::size_t mode, std::size_t derivative) const {
    return coordinate_[mode][derivative];
  }

  /// The part of a product at eps^order: the convolution of its factors' series. Throws std::length_error where all
  /// of them come to more products of terms than are allowed.
  Field product(const FactorProduct& factors, int order) const;

 private:
  Field harmonic_wave(std::size_t excitation, int multiple, const GiNaC::ex& coefficient, bool amplitude) const;
  Field nonsmooth_product(const Factor& nonsmooth, std::vector<const FieldSeries*> smooth, int order) const;

  PhaseRates rates_;
  int highest_order_;
  std::vector<bool> at_rest_;
  mutable ProductCount products_;
  std::vector<std::vector<FieldSeries>> coordinate_, excitation_;  // [index][derivative]
};

}  // namespace secular
