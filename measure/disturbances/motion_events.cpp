#include "measure/disturbances/motion_events.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "measure/thresholds.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

constexpr int most_clusters = 4;      // in a turn
constexpr double fixed_phases = 0.5;  // half way between any phases and fixed ones

// Phase of the motion at a sample from two turns on either side of it, without what the event has touched.
double phase_at(std::span<const double> x, double turns_a_sample, std::size_t at) {
  const auto around = static_cast<std::ptrdiff_t>(std::ceil(2 / turns_a_sample));
  std::complex<double> turned_values = 0, turned = 0;
  double values = 0, weights = 0;
  for (std::ptrdiff_t j = -around; j <= around; ++j) {
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(at) + j;
    if (std::abs(j) <= 2 || i < 0 || i >= static_cast<std::ptrdiff_t>(x.size())) continue;
    const double weight = 1 + std::cos(two_pi / 2 * static_cast<double>(j) / static_cast<double>(around + 1)),
                 value = weight * x[static_cast<std::size_t>(i)];
    const std::complex<double> turn = std::polar(1.0, -two_pi * turns_a_sample * static_cast<double>(j));
    values += value;
    weights += weight;
    turned_values += value * turn;
    turned += weight * turn;
  }
  return std::arg(turned_values - values / weights * turned);
}

// Turns between the first and the last of the events.
double turns_between(const std::vector<std::size_t>& events, double turns_a_sample) {
  const auto [first, last] = std::minmax_element(events.begin(), events.end());
  return turns_a_sample * static_cast<double>(*last - *first);
}

double turns_a_sample_of(const std::vector<double>& powers) {
  const auto strongest = std::max_element(powers.begin() + 1, powers.end()) - powers.begin();
  return 0.5 * static_cast<double>(strongest) / (static_cast<double>(powers.size()) - 1);
}

// Of phases at random, so many, a cluster in a turn, two, ... has at least that squared length of their sum with no
// more probability (Rayleigh's law).
bool is_chance(double squared_length, std::size_t phases) {
  return most_clusters * std::exp(-squared_length / static_cast<double>(phases)) >
         measure_thresholds().spikes_not_told;
}

// Of so few not even fixed phases are told from any.
bool are_few(std::size_t phases) {
  return is_chance(static_cast<double>(phases * phases), phases);
}

bool are_often(const std::vector<double>& powers, const std::vector<std::size_t>& events) {
  return powers.size() >= 2 && events.size() >= 3 &&
         2 * static_cast<double>(events.size() - 1) >= turns_between(events, turns_a_sample_of(powers));
}

}  // namespace

bool keeps_to_phases(std::span<const double> samples, const std::vector<double>& powers,
                     const std::vector<std::size_t>& events) {
  if (!are_often(powers, events) || are_few(events.size())) return false;
  std::vector<double> phases;
  for (const std::size_t at : events) phases.push_back(phase_at(samples, turns_a_sample_of(powers), at));
  for (int k = 1; k <= most_clusters; ++k) {
    std::complex<double> sum = 0;
    for (const double phase : phases) sum += std::polar(1.0, k * phase);
    if (std::norm(sum) > fixed_phases * static_cast<double>(phases.size() * phases.size()) &&
        !is_chance(std::norm(sum), phases.size()))
      return true;
  }
  return false;
}

bool recurs_with_motion(std::span<const double> samples, const std::vector<double>& powers,
                        const std::vector<std::size_t>& events) {
  if (!are_often(powers, events)) return false;
  const double turns = turns_between(events, turns_a_sample_of(powers));
  return are_few(events.size()) || static_cast<double>(events.size() - 1) > 2 * turns ||
         keeps_to_phases(samples, powers, events);
}

}  // namespace secular
