#include "measure/observe/decay_lines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "measure/observe/decay_window.hpp"
#include "measure/observe/natural_frequency_starts.hpp"
#include "measure/observe/record_window.hpp"
#include "measure/signal/free_decay.hpp"
#include "measure/signal/spectral_survey.hpp"
#include "measure/thresholds.hpp"
#include "numerics/hertz.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The main lobe of a Hann window, to either side of its line.
constexpr Index lobe = 2;

/// The largest number of a frequency in a combination that nonlinear terms up to the third degree make.
constexpr int highest_degree = 3;

// Root of the power of all response channels, each over its own.
struct Spectrum {
  double bin = 0;  // rad/s
  VectorXd amplitude;
  double floor = 0;
  std::size_t records = 0;

  Index at(double frequency) const {
    return std::clamp<Index>(static_cast<Index>(std::lround(frequency / bin)), 0, amplitude.size() - 1);
  }
  bool is_peak(Index i) const {
    if (i <= lobe || i + lobe >= amplitude.size() ||
        !(amplitude(i) > measure_thresholds().seen_above_noise * floor))
      return false;
    return amplitude.segment(i - lobe, 2 * lobe + 1).maxCoeff() <= amplitude(i);
  }
};

// Of all decays together, from where each begins.
std::optional<Spectrum> spectrum_of_decays(const Campaign& campaign, const RecordReader& read,
                                           const Window& window) {
  const std::vector<std::size_t> responses = channels_of(campaign, ChannelRole::response);
  std::vector<MatrixXd> decays;
  double rate = 0;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    const bool decays_freely = entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact;
    if (!decays_freely || !window.takes(r, entry.file)) continue;
    const Record record = read(r);
    const SampleRange range = range_of(record, window);
    if (range.count == 0) continue;
    MatrixXd samples = samples_of(record, responses, range.first, range.count);
    const VectorXd size = (samples.rowwise() - samples.colwise().mean()).colwise().norm().transpose();
    Index leading = 0;
    size.maxCoeff(&leading);
    const std::optional<DecayStart> start = find_decay_start(samples.col(leading), record.sample_rate_hz);
    if (!start) continue;
    rate = record.sample_rate_hz;
    decays.push_back(samples.bottomRows(samples.rows() - start->sample));
  }
  if (decays.empty()) return std::nullopt;
  Index length = decays.front().rows();
  for (const MatrixXd& decay : decays) length = std::min(length, decay.rows());
  Spectrum all;
  all.records = decays.size();
  for (const MatrixXd& decay : decays) {
    const MatrixXd centred = decay.topRows(length).rowwise() - decay.topRows(length).colwise().mean();
    const AmplitudeSpectrum one = amplitude_spectrum(centred, rate, length);
    const VectorXd own =
        (one.amplitude.array().square().rowwise() / (one.amplitude.array().square().colwise().sum() + 1e-300))
            .rowwise()
            .sum();
    if (all.amplitude.size() == 0) all.amplitude = VectorXd::Zero(own.size());
    all.amplitude += own;
    all.bin = two_pi * (one.frequency_hz(1) - one.frequency_hz(0));
  }
  all.amplitude = all.amplitude.cwiseSqrt();
  std::vector<double> passed;
  for (Index i = 0; i < all.amplitude.size(); ++i)
    if (window.passes(static_cast<double>(i) * all.bin)) passed.push_back(all.amplitude(i));
  if (passed.empty()) return std::nullopt;
  all.floor = upper_median(std::move(passed));
  return all;
}

// A sum or difference of up to three of the frequencies, one counted as often as it comes in, zero among them.
bool is_combination(double line, const std::vector<double>& frequencies, double width) {
  const std::function<bool(std::size_t, int, double)> reaches = [&](std::size_t from, int left, double sum) {
    if (from == frequencies.size()) return std::abs(std::abs(sum) - line) <= width;
    for (int n = -left; n <= left; ++n)
      if (reaches(from + 1, left - std::abs(n), sum + n * frequencies[from])) return true;
    return false;
  };
  return reaches(0, highest_degree, 0);
}

}  // namespace

ModeLines decay_lines(const Campaign& campaign, const RecordReader& read, const std::vector<double>& nominal,
                      const Window& window) {
  ModeLines lines;
  lines.at_nominal.resize(nominal.size());
  lines.may_be_further.assign(nominal.size(), true);
  const std::optional<Spectrum> spectrum = spectrum_of_decays(campaign, read, window);
  if (!spectrum) return lines;
  lines.records = spectrum->records;
  const VectorXd& amplitude = spectrum->amplitude;
  std::vector<double> explained;
  for (std::size_t k = 0; k < nominal.size(); ++k) {
    if (!std::isfinite(nominal[k])) continue;
    const Index low = spectrum->at((1 - measure_thresholds().largest_detuning) * nominal[k]),
                high = spectrum->at((1 + measure_thresholds().largest_detuning) * nominal[k]);
    Index best = 0;
    amplitude.segment(low, high - low + 1).maxCoeff(&best);
    // The flank of another mode's line is highest at the range's end.
    if (!spectrum->is_peak(low + best)) continue;
    lines.at_nominal[k] = spectrum->bin * static_cast<double>(low + best);
    explained.push_back(*lines.at_nominal[k]);
  }
  std::vector<Index> peaks;
  for (Index i = 0; i < amplitude.size(); ++i)
    if (spectrum->is_peak(i)) peaks.push_back(i);
  std::stable_sort(peaks.begin(), peaks.end(), [&](Index a, Index b) { return amplitude(a) > amplitude(b); });
  for (const Index i : peaks) {
    if (explained.size() >= nominal.size()) break;
    const double line = spectrum->bin * static_cast<double>(i);
    const bool near = std::any_of(explained.begin(), explained.end(), [&](double other) {
      return std::abs(line - other) < measure_thresholds().largest_detuning * other;
    });
    if (near || is_combination(line, explained, 2 * lobe * spectrum->bin)) continue;
    lines.further.push_back(line);
    explained.push_back(line);
  }
  return lines;
}

}  // namespace secular
