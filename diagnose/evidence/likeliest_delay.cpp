#include "diagnose/evidence/likeliest_delay.hpp"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>

namespace secular {
namespace {

/// Places of a period that are looked at: a row turns by less than a right angle from one to the next up to the
/// third multiple of the excitation.
constexpr int places = 16;

/// Of the distance of two places, 2^-9/4 (Boost's Brent): 3e-5 of a period. What is left is linear.
constexpr int bits = 10;
constexpr std::uintmax_t most_narrowings = 20;

/// Places of a period within which a deviance is a parabola: a row turns by 0.05 between two of them, whose square
/// is what is left out.
constexpr int close_places = 128;

}  // namespace

double likeliest_delay(const std::function<double(double)>& deviance, double here, double period) {
  const double reach = period / places;
  double best = here, least = deviance(here);
  for (int place = 1; place < places; ++place) {
    const double delay = here + reach * (place <= places / 2 ? place : place - places);
    const double value = deviance(delay);
    if (!(value < least)) continue;
    best = delay;
    least = value;
  }
  std::uintmax_t steps = most_narrowings;
  const auto [offset, value] = boost::math::tools::brent_find_minima(
      [&](double part) { return deviance(best + part * reach); }, -1.0, 1.0, bits, steps);
  return value < least ? best + offset * reach : best;
}

std::optional<double> likeliest_delay_near(const std::function<double(double)>& deviance, double here,
                                           double period) {
  const double reach = period / close_places, before = deviance(here - reach), at = deviance(here),
               behind = deviance(here + reach);
  const double bend = before - 2 * at + behind, step = 0.5 * reach * (before - behind) / bend;
  if (!(bend > 0) || !(std::abs(step) <= reach)) return std::nullopt;
  return deviance(here + step) <= at ? here + step : here;
}

}  // namespace secular
