#include "jobs/predict/uncertain_text.hpp"

#include <cmath>

#include "numerics/hertz.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

std::optional<LimitCycleSpread> spread_of_cycle(const Prediction& prediction, std::size_t k, std::size_t cycle) {
  if (k >= prediction.limit_cycle_spread.size()) return {};
  return prediction.limit_cycle_spread[k][cycle];
}

}  // namespace

std::string uncertain_number(double value, std::optional<double> sd, int digits) {
  if (!sd || !(*sd > 0) || !std::isfinite(*sd)) return report::format_number(value, digits);
  return report::format_uncertain(value, *sd);
}

std::string special_place(const Prediction& prediction, const ResponseSpecial& special) {
  std::optional<double> sd = special.sd;
  if (sd) *sd /= prediction.axis;
  return uncertain_number(special.at.parameter / prediction.axis, sd, 6);
}

std::string special_amplitude(const Prediction& prediction, const ResponseSpecial& special, std::size_t mode) {
  // Below this the branch meets the state of rest: the rest is rounding.
  const double amplitude = 2 * std::abs(special.at.modes.amplitude[mode]);
  return report::format_number(amplitude > 1e-6 * prediction.diagram.scale ? amplitude : 0, 4);
}

std::string cycle_amplitude(const Prediction& prediction, std::size_t k, std::size_t cycle) {
  const auto spread = spread_of_cycle(prediction, k, cycle);
  return uncertain_number(2 * prediction.limit_cycles[k][cycle].at.amplitude,
                          spread ? std::optional<double>(2 * spread->amplitude) : std::nullopt, 6);
}

std::string cycle_frequency(const Prediction& prediction, std::size_t k, std::size_t cycle) {
  const auto spread = spread_of_cycle(prediction, k, cycle);
  return uncertain_number(prediction.limit_cycles[k][cycle].at.frequency * to_hz,
                          spread ? std::optional<double>(spread->frequency * to_hz) : std::nullopt, 6);
}

bool first_order_holds(const ResponsePoint& point, std::size_t mode) {
  if (mode >= point.spread.size() || point.outside) return false;
  return 2 * point.spread[mode].amplitude <= std::abs(point.modes.amplitude[mode]);
}

std::optional<double> amplitude_sd(const ResponsePoint& point, std::size_t mode) {
  if (!first_order_holds(point, mode)) return {};
  const double sd = 2 * point.spread[mode].amplitude;
  return sd > 0 ? std::optional<double>(sd) : std::nullopt;
}

}  // namespace secular
