#include "diagnose/observe_decay.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/record_window.hpp"
#include "estimator/signal/free_decay.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// About so many windows in a decay, none shorter than so many periods.
constexpr double windows_wanted = 40, fewest_periods = 3;

// How much rougher a series is from entry to entry than its errors say: third differences of a smooth law vanish.
double roughness(const std::vector<double>& values, const std::vector<double>& sds) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i + 3 < values.size(); ++i) {
    const double third = values[i + 3] - 3 * values[i + 2] + 3 * values[i + 1] - values[i];
    const double sd = std::sqrt(sds[i + 3] * sds[i + 3] + 9 * sds[i + 2] * sds[i + 2] +
                                9 * sds[i + 1] * sds[i + 1] + sds[i] * sds[i]);
    if (sd > 0) ratios.push_back(std::abs(third) / sd);
  }
  if (ratios.empty()) return 1;
  std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
  return std::max(1.0, ratios[ratios.size() / 2] / 0.6745);  // median of |normal|
}

}  // namespace

std::vector<Condition> observe_decay(const Campaign& campaign, std::size_t index, const Record& record,
                                     const CompiledModel& model, const SensorModel& sensors, const Window& window,
                                     std::vector<std::string>& warnings) {
  const RecordEntry& entry = campaign.records[index];
  const auto leave_out = [&](const std::string& reason) {
    warnings.push_back(entry.file + ": " + reason + ", left out");
    return std::vector<Condition>{};
  };
  if (model.modes() != 1) return leave_out("free decays of several modes at once are not diagnosed");
  const RecordPart part = part_of(record, sensors.responses, window);
  const double rate = record.sample_rate_hz;
  const Eigen::VectorXd modal =
      part.samples * sensors.shapes.completeOrthogonalDecomposition().pseudoInverse().row(0).transpose();
  const auto start = find_decay_start(modal, rate);
  if (!start) return leave_out("no free decay is found in it");
  const Index swing = part.samples.rows() - start->sample;
  WindowOptions options;
  options.periods = std::max(fewest_periods, static_cast<double>(swing) / rate * start->frequency /
                                                 (2 * std::numbers::pi) / windows_wanted);
  options.overlap = 0;
  options.harmonics = {1, 2, 3};
  const std::vector<DecayWindow> windows =
      sliding_windows(part.samples.bottomRows(swing), rate, start->frequency, options);
  if (windows.size() < 6) return leave_out("fewer than six windows of free decay");

  std::vector<double> frequency, frequency_sd, growth, growth_sd;
  for (const DecayWindow& w : windows) {
    frequency.push_back(w.frequency);
    frequency_sd.push_back(w.frequency_sd);
    growth.push_back(w.growth);
    growth_sd.push_back(w.growth_sd);
  }
  const double frequency_factor = roughness(frequency, frequency_sd), growth_factor = roughness(growth, growth_sd);
  const auto torus = std::make_shared<const Torus>(1, 6, 128);
  std::vector<Condition> conditions;
  const auto fold_size = std::max<std::size_t>(1, windows.size() / 8);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const DecayWindow& w = windows[i];
    Condition c;
    c.name = entry.file;
    c.record = index;
    c.fold = static_cast<int>(index) + 1000 * static_cast<int>(1 + i / fold_size);
    c.kind = entry.kind;
    c.time_s = part.start_s - record.start_s + static_cast<double>(start->sample) / rate + w.centre_s;
    c.torus = torus;
    c.rate = {Complex(w.growth, w.frequency), Complex(0)};
    c.growth_sd[0] = growth_factor * w.growth_sd;
    c.frequency_sd[0] = frequency_factor * w.frequency_sd;
    c.masters = {{0, 1}};
    c.lines = {1, 2, 3};
    c.response = w.amplitude.transpose();
    c.response_sd = std::max(frequency_factor, growth_factor) * w.amplitude_sd.transpose();
    // The mean of a differentiated channel is nothing but an offset; it is seen against the others' scatter.
    conditions.push_back(std::move(c));
  }
  return conditions;
}

}  // namespace secular
