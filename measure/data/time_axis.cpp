#include "measure/data/time_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "input/input_error.hpp"
#include "measure/data/rounded_stamps.hpp"
#include "measure/formats/fortran_number.hpp"
#include "numerics/median.hpp"

namespace secular {
double longest_step() {
  return 2 - largest_jitter;
}

namespace {

// Complains about the first pair of stamps that cannot be neighbours; the median step survives a few gaps.
void check_steps(const std::vector<double>& stamps, const std::string& file, const RowPlace& place) {
  std::vector<double> steps(stamps.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = stamps[i + 1] - stamps[i];
  const double step = upper_median(steps);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] > 0 && (steps[i] <= longest_step() * step || step <= 0)) continue;
    const std::string at = fmt::format("{} (t = {})", place.of(i + 1), stamps[i + 1]);
    if (steps[i] == 0) throw InputError(file, at, "repeats the time stamp before it", "time must increase evenly");
    if (steps[i] < 0) throw InputError(file, at, "time runs backwards", "time must increase evenly");
    throw InputError(file, at, fmt::format("a gap of {:.6g} s where samples are {:.6g} s apart", steps[i], step),
                     "split the record at the gap");
  }
}

// Stamps as a line mean + step * (i - middle): from the middle, where slope and position do not mix.
struct StampLine {
  double mean = 0, middle = 0, step = 0;
  double at(std::size_t i) const { return mean + step * (static_cast<double>(i) - middle); }
};

StampLine fit_line(const std::vector<double>& stamps) {
  StampLine line;
  line.middle = 0.5 * static_cast<double>(stamps.size() - 1);
  double sum = 0, product = 0, square = 0;
  for (const double t : stamps) sum += t - stamps.front();
  line.mean = stamps.front() + sum / static_cast<double>(stamps.size());
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    const double x = static_cast<double>(i) - line.middle;
    product += x * (stamps[i] - line.mean);
    square += x * x;
  }
  line.step = product / square;
  return line;
}

double largest_deviation(const std::vector<double>& stamps, const StampLine& line) {
  double largest = 0;
  for (std::size_t i = 0; i < stamps.size(); ++i) largest = std::max(largest, std::abs(stamps[i] - line.at(i)));
  return largest;
}

// Significant digits, up to the 15 that survive a change of unit.
int digits_of(double value) {
  std::string text = fmt::format("{:.15g}", value);
  text.resize(std::min(text.size(), text.find('e')));
  text.erase(0, text.find_first_not_of("-0."));
  return static_cast<int>(text.size() - (text.find('.') == std::string::npos ? 0 : 1));
}

// The step between numbers that the stamps may have been rounded to.
double resolution(const std::vector<double>& stamps) {
  double largest = 0;
  int digits = 0;
  bool single = true;
  for (const double t : stamps) {
    largest = std::max(largest, std::abs(t));
    if (digits < std::numeric_limits<double>::digits10) digits = std::max(digits, digits_of(t));
    single = single && static_cast<double>(static_cast<float>(t)) == t;
  }
  const double printed = std::pow(10, std::floor(std::log10(largest)) + 1 - digits);
  return single ? std::max(printed, largest * std::numeric_limits<float>::epsilon()) : printed;
}

// Even stamps that are rounded to ticks of a clock are a whole number of ticks apart, or one more.
bool steps_of_two_sizes(const std::vector<double>& stamps, double same) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < stamps.size(); ++i) steps.push_back(stamps[i] - stamps[i - 1]);
  const auto ends = std::minmax_element(steps.begin(), steps.end());
  return std::all_of(steps.begin(), steps.end(),
                     [&](double step) { return step - *ends.first <= same || *ends.second - step <= same; });
}

double scatter(const std::vector<double>& stamps, const StampLine& line, double largest) {
  const double negligible = 1e-6 * line.step;
  if (largest <= negligible || largest <= resolution(stamps) || steps_of_two_sizes(stamps, negligible)) return 0;
  double square = 0;
  for (std::size_t i = 0; i < stamps.size(); ++i) square += (stamps[i] - line.at(i)) * (stamps[i] - line.at(i));
  return std::sqrt(square / static_cast<double>(stamps.size()));
}

// The rate that is followed as closely as the fitted line, to 2 % of the jitter and a millionth of the step.
double simplest_rate(const std::vector<double>& stamps, const StampLine& fitted, double jitter,
                     std::optional<double> expected) {
  const auto follows = [&](double rate) {
    if (!std::isfinite(rate) || rate <= 0) return false;
    const StampLine line{fitted.mean, fitted.middle, 1 / rate};
    // The ends deviate most: they rule a candidate out before all stamps are looked at.
    const double allowed = 1.02 * jitter + 1e-6 * fitted.step;
    return std::abs(line.at(0) - fitted.at(0)) <= 2 * jitter + 1e-6 * fitted.step &&
           largest_deviation(stamps, line) <= allowed;
  };
  if (expected && follows(*expected)) return *expected;
  // Clocks that differ by a millionth: the integer is meant, as long as no stamp moves further than jitter may.
  const double whole = std::round(1 / fitted.step);
  if (std::abs(whole * fitted.step - 1) <= 1e-6 &&
      largest_deviation(stamps, {fitted.mean, fitted.middle, 1 / whole}) <= largest_jitter * fitted.step)
    return whole;
  for (int digits = 1; digits <= 12; ++digits) {
    if (const double rate = of_digits(1 / fitted.step, digits); follows(rate)) return rate;
    if (const double rate = 1 / of_digits(fitted.step, digits); follows(rate)) return rate;
  }
  return 1 / fitted.step;
}

}  // namespace

TimeAxis even_time_axis(const std::vector<double>& stamps, const std::string& file, const RowPlace& place,
                        std::optional<double> expected_rate_hz) {
  if (stamps.size() < 2) throw InputError(file, "", "has fewer than two samples", "a record needs many samples");
  const auto is_missing = [](double t) { return !std::isfinite(t); };
  if (const auto missing = std::find_if(stamps.begin(), stamps.end(), is_missing); missing != stamps.end())
    throw InputError(file, place.of(static_cast<std::size_t>(missing - stamps.begin())),
                     "the time stamp is no finite number", "leave out rows without a time: short gaps are filled");
  if (const std::optional<TimeAxis> axis = axis_of_rounded(stamps, expected_rate_hz)) return *axis;
  check_steps(stamps, file, place);
  const StampLine fitted = fit_line(stamps);
  if (!std::isfinite(fitted.step) || !std::isfinite(1 / fitted.step) || !std::isfinite(fitted.mean) ||
      fitted.step <= 0)
    throw InputError(file, "time", "has stamps out of all proportion", "seconds were expected");
  double jitter = 0;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    const double deviation = stamps[i] - fitted.at(i);
    if (!(std::abs(deviation) <= largest_jitter * fitted.step))
      throw InputError(
          file, fmt::format("{} (t = {})", place.of(i), stamps[i]),
          fmt::format("samples are not even: {:.6g} s away from an even {:.6g} Hz", deviation, 1 / fitted.step),
          "resample the record evenly first");
    jitter = std::max(jitter, std::abs(deviation));
  }
  const double rate = simplest_rate(stamps, fitted, jitter, expected_rate_hz);
  const double start = fitted.mean - fitted.middle / rate;
  const bool starts_at_first = std::abs(stamps.front() - start) < 1e-6 / rate;
  return {starts_at_first ? stamps.front() : start, rate, scatter(stamps, fitted, jitter)};
}

}  // namespace secular
