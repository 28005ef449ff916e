#include "estimator/identification/even_sensor.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "estimator/identification/beyond_chance.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/observed_blocks.hpp"
#include "measure/observe/record_ranges.hpp"
#include "measure/observe/record_window.hpp"
#include "measure/observe/related_tones.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A constant, a drift of zero from record to record, and the law.
constexpr Index fitted_to_means = 3;

// Of one dwell.
struct MeanOfMotion {
  double record = 0;
  double square = 0;  // |B|^2, as the channels show it
  double mean = 0, variance = 0;
};

/// Lines of a motion and of what drives it that are fitted beside a mean.
constexpr int lines_beside_mean = 12;

// What a record's channels show at zero frequency, beside multiples of a frequency (rad/s).
RelatedToneFit fit_mean(const Record& record, const std::vector<std::size_t>& channels, const Window& window,
                        double frequency) {
  const SampleRange range = range_of(record, window);
  const double nyquist = std::numbers::pi * record.sample_rate_hz;
  std::vector<double> lines;
  for (int n = 1; n <= lines_beside_mean && n * frequency < 0.95 * nyquist; ++n) lines.push_back(n * frequency);
  const auto count = static_cast<Index>(lines.size());
  const RelatedTones tones{Eigen::Map<const VectorXd>(lines.data(), count), MatrixXd(count, 0)};
  return fit_related_tones(samples_of(record, channels, range.first, range.count), record.sample_rate_hz, tones,
                           VectorXd());
}

// By mode.
std::vector<std::vector<MeanOfMotion>> means_of(const Campaign& campaign, const RecordReader& read,
                                                const ObservationSet& set, const ModalProjection& projection,
                                                const Window& window) {
  std::vector<std::vector<MeanOfMotion>> result(set.model->modes());
  for (const RecordRange& range : ranges_of_records(set.observations)) {
    const std::span<const Observation> ensembles = range.of(set.observations);
    const Observation& first = ensembles.front();
    if (campaign.records[first.record].kind == RecordKind::lines) continue;
    double slowest = first.excitation_frequency.front();
    for (std::size_t k = 0; k < first.rate.size(); ++k)
      if (first.amplitude[k] != Complex()) slowest = std::min(slowest, first.rate[k].imag());
    const RelatedToneFit fit = fit_mean(read(first.record), projection.channels, window, slowest);
    for (std::size_t k = 0; k < result.size(); ++k) {
      MeanOfMotion one;
      one.record = static_cast<double>(first.record);
      for (const Observation& o : ensembles)
        one.square += std::norm(o.amplitude[k] * derived(o.rate[k].imag(), projection.derivatives)) /
                      static_cast<double>(ensembles.size());
      one.mean = project(projection, k, fit.offset.transpose().cast<Complex>()).real();
      one.variance = std::pow(project_sd(projection, k, fit.offset_sd.transpose()), 2);
      if (one.variance > 0) result[k].push_back(one);
    }
  }
  return result;
}

// docs/inference.md (73): 2 k, shrunk to zero where chance makes as much.
double growth_of_means(const std::vector<MeanOfMotion>& dwells) {
  const auto count = static_cast<Index>(dwells.size());
  if (count <= fitted_to_means) return 0;
  double largest = 0;
  for (const MeanOfMotion& d : dwells) largest = std::max(largest, d.square);
  if (!(largest > 0)) return 0;
  MatrixXd matrix(count, fitted_to_means);
  VectorXd target(count);
  for (Index i = 0; i < count; ++i) {
    const MeanOfMotion& d = dwells[static_cast<std::size_t>(i)];
    const double sd = std::sqrt(d.variance);
    matrix.row(i) << 1 / sd, (d.record - dwells.front().record) / sd, d.square / largest / sd;
    target(i) = d.mean / sd;
  }
  if (matrix.colPivHouseholderQr().rank() < fitted_to_means) return 0;
  return beyond_chance(matrix, target, 2, static_cast<double>(count - fitted_to_means)) / largest;
}

}  // namespace

std::optional<EvenSensor> even_sensor(const Campaign& campaign, const RecordReader& read,
                                      std::span<const ObservationSet> measured, const Window& window) {
  std::optional<EvenSensor> result;
  for (const ObservationSet& set : measured) {
    const ModalProjection projection = modal_projection(campaign, *set.model);
    if (!set.resonance->excited || projection.derivatives == 0 || !window.passes(0)) continue;
    const auto by_mode = means_of(campaign, read, set, projection, window);
    for (std::size_t mode = 0; mode < by_mode.size(); ++mode) {
      const double k = 0.5 * growth_of_means(by_mode[mode]);
      if (k == 0) continue;
      double largest = 0;
      for (const MeanOfMotion& d : by_mode[mode]) largest = std::max(largest, d.square);
      const double second = k * std::sqrt(largest);
      if (!result || std::abs(second) > std::abs(result->second))
        result = EvenSensor{set.resonance, mode, k, second, projection.derivatives};
    }
  }
  return result;
}

ObservationSet without_even_part(const ObservationSet& set, const EvenSensor& sensor) {
  ObservationSet result = set;
  for (Observation& o : result.observations) {
    const double own = o.rate[sensor.mode].imag();
    const Complex motion = o.amplitude[sensor.mode] * derived(own, sensor.derivatives);
    const Complex second = sensor.k * motion * motion / derived(2 * own, sensor.derivatives);
    for_lines_at_multiple(*set.resonance, sensor.mode, 2, o,
                          [&](Complex& seen, bool reversed) { seen -= reversed ? std::conj(second) : second; });
  }
  return result;
}

}  // namespace secular
