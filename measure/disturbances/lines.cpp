#include "measure/disturbances/lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/signal/transform_length.hpp"
#include "numerics/distribution.hpp"
#include "numerics/fourier_transform.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

// Beside a peak: bins at distances 5, 7, ... 19. Within 4 the line itself is seen, and neighbours of two bins share
// less than a tenth of their noise under this window.
constexpr std::size_t side_bins = 8;
constexpr std::size_t first_side_bin = 5;
constexpr std::size_t reach = line_reach;
static_assert(reach == first_side_bin + 2 * (side_bins - 1));

// The larger mean of the two sides of a bin; nothing near the ends of the spectrum.
double noise_beside(const std::vector<double>& powers, std::size_t bin) {
  if (bin < reach || bin + reach >= powers.size()) return 0;
  double below = 0, above = 0;
  for (std::size_t j = 0; j < side_bins; ++j) {
    below += powers[bin - first_side_bin - 2 * j] / side_bins;
    above += powers[bin + first_side_bin + 2 * j] / side_bins;
  }
  return std::max(below, above);
}

// What the window leaves of a line half a bin off its bin: (a0 s(1/2) + sum of a_k/2 (s(1/2 - k) + s(1/2 + k)))/a0
// with s(x) = sin(pi x)/(pi x) and the a of lobe_window() (0.83 dB; F. J. Harris, Proceedings of the IEEE 66,
// 1978).
constexpr double half_a_bin_off = 0.909;

// Both halves show the line, its amplitudes differ by no more than the noise that is beside it in each, and the
// whole shows no more than both together: what rings up and down in the middle, where the whole's window is highest
// and theirs are low, does. The modulus of a line in noise of mean power m has the variance m/2.
void look_at_halves(Line& line, const std::vector<double>& whole, const std::vector<double> (&halves)[2],
                    std::size_t bin, double false_alarm) {
  const std::size_t at = bin / 2;
  double variance = 0, modulus[2] = {};
  for (const int h : {0, 1}) {
    const double noise = noise_beside(halves[h], at);
    if (!(noise > 0)) return;
    variance += 0.5 * noise;
    const double power = std::max({halves[h][at - 1], halves[h][at], halves[h][at + 1]});
    if (f_upper_tail(power / noise, 2, 2 * side_bins) > false_alarm) return;
    modulus[h] = std::sqrt(power);
  }
  line.first_half = modulus[0];
  line.second_half = modulus[1];
  line.half_sd = std::sqrt(0.5 * variance);
  const double more = std::sqrt(whole[bin]) - (modulus[0] + modulus[1]) / half_a_bin_off,
               sd_of_more = std::sqrt(0.5 * noise_beside(whole, bin) + variance);
  line.steady = 2 * normal_upper_tail(std::abs(modulus[0] - modulus[1]) / std::sqrt(variance)) > false_alarm &&
                normal_upper_tail(more / sd_of_more) > false_alarm;
}

}  // namespace

std::vector<double> lobe_window(std::size_t length) {
  std::vector<double> window(length);
  for (std::size_t i = 0; i < length; ++i) {
    const double phase = two_pi * (static_cast<double>(i) + 0.5) / static_cast<double>(length);
    window[i] = 0.35875 - 0.48829 * std::cos(phase) + 0.14128 * std::cos(2 * phase) - 0.01168 * std::cos(3 * phase);
  }
  return window;
}

std::vector<double> windowed_powers(std::span<const double> samples, const std::vector<double>& window) {
  double mean = 0;
  for (std::size_t i = 0; i < window.size(); ++i) mean += samples[i] / static_cast<double>(window.size());
  Eigen::VectorXd part(static_cast<Eigen::Index>(window.size()));
  for (std::size_t i = 0; i < window.size(); ++i)
    part(static_cast<Eigen::Index>(i)) = window[i] * (samples[i] - mean);
  const Eigen::VectorXd powers = half_spectrum(part).cwiseAbs2();
  return {powers.begin(), powers.end()};
}

std::vector<Line> find_lines(std::span<const double> samples, double rate, double false_alarm,
                             std::vector<double>* spectrum) {
  std::vector<Line> lines;
  if (samples.size() < 8 * reach) return lines;
  const auto half = static_cast<std::size_t>(cut_transform_length(static_cast<Eigen::Index>(samples.size() / 2)));
  const std::size_t length = 2 * half;
  const std::vector<double> powers = windowed_powers(samples, lobe_window(length));
  const std::vector<double> window = lobe_window(half);
  const std::vector<double> halves[2] = {windowed_powers(samples.first(half), window),
                                         windowed_powers(samples.subspan(half, half), window)};
  double sum = 0;
  for (const double w : window) sum += 2 * w;
  const double of_bin = false_alarm / static_cast<double>(powers.size());
  // What rounding of a mean leaves of a channel that stands still, or of what is large beside its motion.
  double largest = 0;
  for (const double sample : samples) largest = std::max(largest, std::abs(sample));
  const double rounding = std::pow(std::numeric_limits<double>::epsilon() * largest * sum, 2);
  for (std::size_t k = reach; k + reach < powers.size(); ++k) {
    if (powers[k] <= powers[k - 1] || powers[k] < powers[k + 1] || !(powers[k] > rounding)) continue;
    const double noise = noise_beside(powers, k);
    if (!(noise > 0) || f_upper_tail(powers[k] / noise, 2, 2 * side_bins) > of_bin) continue;
    const double before = std::log(powers[k - 1]), here = std::log(powers[k]), after = std::log(powers[k + 1]);
    const double offset = 0.5 * (before - after) / (before - 2 * here + after);
    lines.push_back({(static_cast<double>(k) + offset) * rate / static_cast<double>(length),
                     2 * std::exp(0.5 * (here - 0.25 * (before - after) * offset)) / sum});
    look_at_halves(lines.back(), powers, halves, k, false_alarm);
  }
  if (spectrum != nullptr) *spectrum = powers;
  return lines;
}

double change_between_halves(std::span<const double> motion) {
  const auto half = static_cast<Eigen::Index>(motion.size() / 2);
  const Eigen::Map<const Eigen::VectorXd> all(motion.data(), 2 * half);
  const auto about_mean = [](const auto& part) { return (part.array() - part.mean()).matrix().norm(); };
  return about_mean(all.tail(half)) / about_mean(all.head(half));
}

bool outlasts_products(const Line& line, double change, double false_alarm) {
  if (!line.steady) return false;
  const double square = change * change,
               left = (line.second_half - square * line.first_half) * (square < 1 ? 1 : -1);
  return normal_upper_tail(left / (line.half_sd * std::hypot(1.0, square))) < false_alarm;
}

double probability_of_no_line(const std::vector<double>& powers, std::size_t bin) {
  const double noise = noise_beside(powers, bin);
  if (!(noise > 0)) return 1;
  const double strongest = std::max({powers[bin - 1], powers[bin], powers[bin + 1]});
  return std::min(1.0, 3 * f_upper_tail(strongest / noise, 2, 2 * side_bins));
}

}  // namespace secular
