#include "perturb/motion_series.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "perturb/nonsmooth.hpp"

namespace secular {
namespace {

int largest_harmonic(const FieldSeries& series, std::size_t mode, int order) {
  int largest = 0;
  for (std::size_t n = 0; n <= static_cast<std::size_t>(order) && n < series.size(); ++n)
    for (const auto& [key, ignored] : series[n].terms()) largest = std::max(largest, std::abs(key[mode]));
  return largest;
}

}  // namespace

MotionSeries::MotionSeries(PhaseRates rates, int highest_order, std::vector<bool> at_rest, ProductCount products)
    : rates_(std::move(rates)), highest_order_(highest_order), at_rest_(std::move(at_rest)), products_(products) {
  const FieldLayout& layout = rates_.layout;
  const FieldSeries nothing(static_cast<std::size_t>(highest_order_) + 1);
  coordinate_.assign(layout.modes, std::vector<FieldSeries>(3, nothing));
  for (std::size_t j = 0; j < layout.excitations; ++j) {
    excitation_.emplace_back(3, nothing);
    std::vector<FieldSeries>& wave = excitation_.back();
    wave[0][0] = harmonic_wave(j, 1, GiNaC::numeric(1, 2), true);
    // An excitation holds no amplitude A, so that nothing of D_n A enters.
    const AmplitudeRates none(layout.modes, nothing);
    for (std::size_t derivative = 1; derivative < wave.size(); ++derivative)
      for (int order = 0; order <= highest_order_; ++order)
        wave[derivative][static_cast<std::size_t>(order)] =
            time_derivative(wave[derivative - 1], order, rates_, none);
  }
}

void MotionSeries::update(const std::vector<FieldSeries>& response, const AmplitudeRates& amplitude_rates,
                          int order) {
  const auto n = static_cast<std::size_t>(order);
  for (std::size_t k = 0; k < coordinate_.size(); ++k) {
    coordinate_[k][0][n] = response[k][n];
    for (std::size_t derivative = 1; derivative < coordinate_[k].size(); ++derivative)
      coordinate_[k][derivative][n] =
          time_derivative(coordinate_[k][derivative - 1], order, rates_, amplitude_rates);
  }
}

// coefficient*exp(i*multiple*Omega*t) + conjugate, with or without the amplitude F.
Field MotionSeries::harmonic_wave(std::size_t excitation, int multiple, const GiNaC::ex& coefficient,
                                  bool amplitude) const {
  const FieldLayout& layout = rates_.layout;
  Field wave;
  for (const int sign : {1, -1}) {
    FieldKey key(layout.size(), 0);
    key[layout.modes + excitation] = sign * multiple;
    if (amplitude) key[layout.forcing(excitation)] = 1;
    wave.add(key, sign > 0 ? coefficient : coefficient.conjugate());
  }
  return wave;
}

Field MotionSeries::product(const FactorProduct& factors, int order) const {
  std::vector<FieldSeries> clocks;  // not kept
  clocks.reserve(factors.size());
  std::vector<const FieldSeries*> series;
  const Factor* nonsmooth = nullptr;
  for (const auto& [factor, power] : factors) {
    const auto index = static_cast<std::size_t>(factor.index);
    const auto derivative = static_cast<std::size_t>(factor.derivative);
    const FieldSeries* one = nullptr;
    switch (factor.kind) {
      case Factor::Kind::coordinate:
        one = &coordinate_[index][derivative];
        break;
      case Factor::Kind::excitation:
        one = &excitation_[index][derivative];
        break;
      case Factor::Kind::clock_cos:
        one = &clocks.emplace_back(FieldSeries{harmonic_wave(index, factor.multiple, GiNaC::numeric(1, 2), false)});
        break;
      case Factor::Kind::clock_sin:
        one = &clocks.emplace_back(FieldSeries{harmonic_wave(index, factor.multiple, -GiNaC::I / 2, false)});
        break;
      case Factor::Kind::absolute:
      case Factor::Kind::sign:
        nonsmooth = &factor;
        continue;
      case Factor::Kind::smooth:
        throw std::logic_error("a smooth function that was not expanded");
    }
    series.insert(series.end(), static_cast<std::size_t>(power), one);
  }
  if (nonsmooth) return nonsmooth_product(*nonsmooth, std::move(series), order);
  if (!series.empty()) return product_at_order(series, order, products_);
  Field unit;
  if (order == 0) unit.add(FieldKey(rates_.layout.size(), 0), 1);
  return unit;
}

// One nonsmooth factor times smooth ones. Harmonics up to highest_nonsmooth_harmonic are exact, because the
// nonsmooth factor is taken further by as much as the smooth ones can shift it. With x = x0 + eps x1 + ...:
// |x| = |x0| + eps sgn(x0) x1 + ...
Field MotionSeries::nonsmooth_product(const Factor& factor, std::vector<const FieldSeries*> series,
                                      int order) const {
  const FieldLayout& layout = rates_.layout;
  const auto mode = static_cast<std::size_t>(factor.index);
  if (at_rest_[mode]) return {};
  const FieldSeries& argument = coordinate_[mode][static_cast<std::size_t>(factor.derivative)];
  int shift = 0;
  for (const FieldSeries* smooth : series) shift += largest_harmonic(*smooth, mode, order);
  const int highest =
      highest_nonsmooth_harmonic + shift + (order > 0 ? largest_harmonic(argument, mode, order) : 0);
  FieldSeries nonsmooth{nonsmooth_harmonics(factor, layout, rates_.fast[mode], highest)};
  if (order > 0) {
    Factor slope = factor;
    slope.kind = Factor::Kind::sign;
    nonsmooth.push_back(nonsmooth_harmonics(slope, layout, rates_.fast[mode], highest) * argument[1]);
  }
  series.push_back(&nonsmooth);
  const Field product = product_at_order(series, order, products_);
  Field exact;
  for (const auto& [key, coefficient] : product.terms())
    if (std::abs(key[mode]) <= highest_nonsmooth_harmonic) exact.add(key, coefficient);
  return exact.with_moduli_joined(layout);
}

}  // namespace secular
