#include "measure/observe/driven_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "measure/observe/record_window.hpp"
#include "measure/signal/transform_length.hpp"
#include "measure/thresholds.hpp"
#include "numerics/fourier_transform.hpp"
#include "numerics/hertz.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Numbers of docs/inference.md (51); more are thresholds.

/// At least so many lines to either side: neighbours are correlated.
constexpr Index fewest_lines = 4;
/// Lines of a Hann window over those that are independent: its equivalent noise bandwidth in bins.
constexpr double lines_per_value = 1.5;
/// Ranges over which lines are compared to tell their scatter.
constexpr Index wider = 5;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Power of one record's lines.
struct DrivenSpectrum {
  double bin = 0;      // rad/s
  VectorXd driving;    // of all excitations
  VectorXd about;      // the mean of `driving` over the range about each line
  double largest = 0;  // of `about`
  MatrixXd response;   // lines x channels
  MatrixXd bends;      // the same: sizes of second differences of log(response/driving), NaN where not all drive

  bool drives(Index i) const {
    return about(i) >= measure_thresholds().driving_share * largest &&
           driving(i) >= measure_thresholds().driving_share_about * about(i);
  }
  Index half(double frequency) const {
    return std::max(fewest_lines, static_cast<Index>(measure_thresholds().driven_range * frequency / bin));
  }
};

VectorXd mean_about(const VectorXd& power, const DrivenSpectrum& lines) {
  VectorXd sum(power.size() + 1);
  sum(0) = 0;
  for (Index i = 0; i < power.size(); ++i) sum(i + 1) = sum(i) + power(i);
  VectorXd mean(power.size());
  for (Index i = 0; i < power.size(); ++i) {
    const Index half = lines.half(static_cast<double>(i) * lines.bin), low = std::max<Index>(0, i - half),
                end = std::min(power.size(), i + half + 1);
    mean(i) = (sum(end) - sum(low)) / static_cast<double>(end - low);
  }
  return mean;
}

// Of Hann; of a sweep, which tells each frequency at a time of its own, with tapers of a twentieth alone.
VectorXd window_of(RecordKind kind, Index samples) {
  const Index taper = kind == RecordKind::sweep ? std::max<Index>(1, samples / 20) : samples / 2;
  VectorXd window = VectorXd::Ones(samples);
  for (Index i = 0; i < taper; ++i) {
    const double rise =
        0.5 - 0.5 * std::cos(0.5 * two_pi * (static_cast<double>(i) + 0.5) / static_cast<double>(taper));
    window(i) *= rise;
    window(samples - 1 - i) *= rise;
  }
  return window;
}

MatrixXd powers(const MatrixXd& samples, const VectorXd& window) {
  MatrixXd power(samples.rows() / 2 + 1, samples.cols());
  for (Index c = 0; c < samples.cols(); ++c)
    power.col(c) =
        half_spectrum((samples.col(c).array() - samples.col(c).mean()).matrix().cwiseProduct(window)).cwiseAbs2();
  return power;
}

// Over lines that are each next but one to the last.
MatrixXd second_differences(const DrivenSpectrum& lines) {
  const Index count = lines.about.size();
  MatrixXd bends = MatrixXd::Constant(count, lines.response.cols(), nothing);
  for (Index c = 0; c < lines.response.cols(); ++c) {
    VectorXd logarithm(count);
    for (Index i = 0; i < count; ++i)
      logarithm(i) = lines.drives(i) ? std::log(lines.response(i, c) / lines.driving(i)) : nothing;
    for (Index i = 3; i + 2 < count; ++i)
      bends(i, c) = std::abs(logarithm(i - 2) - 2 * logarithm(i) + logarithm(i + 2));
  }
  return bends;
}

std::vector<DrivenSpectrum> lines_of_driven(const Campaign& campaign, const RecordReader& read,
                                            const Window& window) {
  const std::vector<std::size_t> excitations = channels_of(campaign, ChannelRole::excitation),
                                 responses = seen_responses(campaign);
  std::vector<DrivenSpectrum> all;
  if (excitations.empty()) return all;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if ((entry.kind != RecordKind::sweep && entry.kind != RecordKind::broadband) || !window.takes(r, entry.file))
      continue;
    const Record record = read(r);
    const SampleRange range = range_of(record, window);
    const Index count = cut_transform_length(range.count);
    if (count < 8 * fewest_lines) continue;
    DrivenSpectrum lines;
    lines.bin = two_pi * record.sample_rate_hz / static_cast<double>(count);
    const VectorXd taper = window_of(entry.kind, count);
    const MatrixXd driving = powers(samples_of(record, excitations, range.first, count), taper);
    lines.driving = VectorXd::Zero(driving.rows());
    for (Index e = 0; e < driving.cols(); ++e)  // whatever their units
      if (const double all_of_it = driving.col(e).sum(); all_of_it > 0) lines.driving += driving.col(e) / all_of_it;
    lines.about = mean_about(lines.driving, lines);
    lines.largest = lines.about.maxCoeff();
    lines.response = powers(samples_of(record, responses, range.first, count), taper);
    if (!(lines.largest > 0) || !lines.driving.allFinite() || !lines.response.allFinite()) continue;
    lines.bends = second_differences(lines);
    all.push_back(std::move(lines));
  }
  return all;
}

// Middles of ranges, rad/s, that overlap by three quarters.
std::vector<double> ranges_of(const std::vector<DrivenSpectrum>& all, const Window& window) {
  double low = std::numeric_limits<double>::infinity(), high = 0, finest = low;
  for (const DrivenSpectrum& lines : all)
    for (Index i = 1; i < lines.about.size(); ++i) {
      const double frequency = static_cast<double>(i) * lines.bin;
      if (lines.about(i) < measure_thresholds().driving_share * lines.largest || !window.passes(frequency))
        continue;
      low = std::min(low, frequency);
      high = std::max(high, frequency);
      finest = std::min(finest, lines.bin);
    }
  std::vector<double> middles;
  for (double w = low; w <= high; w += std::max(finest, measure_thresholds().driven_range * w / 4))
    middles.push_back(w);
  return middles;
}

// Response over excitation at one middle.
struct DrivenRatio {
  double power = nothing;  // sum over channels
  double sd = nothing;     // of its logarithm, at most
};

// Standard deviation of the logarithm of a line about that one.
double sd_of_lines(const DrivenSpectrum& lines, Index channel, Index at, Index half) {
  const Index low = std::max<Index>(0, at - wider * half),
              end = std::min(lines.about.size(), at + wider * half + 1);
  std::vector<double> differences;
  for (Index i = low; i < end; ++i)
    if (std::isfinite(lines.bends(i, channel))) differences.push_back(lines.bends(i, channel));
  return differences.empty() ? nothing : sd_of_median * upper_median(std::move(differences)) / std::sqrt(6.0);
}

DrivenRatio ratio_at(double middle, const std::vector<DrivenSpectrum>& all) {
  constexpr double of_median = 1.2533;  // standard deviation over that of the mean, normal law
  DrivenRatio ratio{0, 0};
  for (Index c = 0; c < all.front().response.cols(); ++c) {
    std::vector<double> values;
    double sd = 0;
    for (const DrivenSpectrum& lines : all) {
      const Index half = lines.half(middle), at = static_cast<Index>(std::lround(middle / lines.bin));
      if (at - half < 1 || at + half >= lines.about.size()) continue;
      if (lines.about.segment(at - half, 2 * half + 1).minCoeff() <
          measure_thresholds().driving_share * lines.largest)
        continue;
      for (Index i = at - half; i <= at + half; ++i)
        if (lines.drives(i)) values.push_back(lines.response(i, c) / lines.driving(i));
      const double own = sd_of_lines(lines, c, at, half);
      sd = std::isfinite(own) ? std::max(sd, own) : own;  // what one record does not tell is not known
      if (!std::isfinite(sd)) return {};
    }
    if (values.empty()) return {};
    ratio.sd = std::max(ratio.sd, of_median * sd * std::sqrt(lines_per_value / static_cast<double>(values.size())));
    ratio.power += upper_median(std::move(values));
  }
  return ratio;
}

// Each channel's power over its own median among the lines that drive: all count alike.
void level_channels(std::vector<DrivenSpectrum>& all) {
  for (DrivenSpectrum& lines : all)
    for (Index c = 0; c < lines.response.cols(); ++c) {
      std::vector<double> values;
      for (Index i = 1; i < lines.about.size(); ++i)
        if (lines.drives(i)) values.push_back(lines.response(i, c) / lines.driving(i));
      const double level = values.empty() ? 0 : upper_median(std::move(values));
      if (level > 0) lines.response.col(c) /= level;
    }
}

struct DrivenPeak {
  double frequency = 0, power = 0;
};

// Whether G falls from range i, in steps of one range, by half power and more than by chance before it rises above
// what it is there.
bool falls(const std::vector<DrivenRatio>& ratios, std::size_t i, int step) {
  const double power = ratios[i].power;
  for (auto j = static_cast<std::ptrdiff_t>(i) + step; j >= 0 && j < std::ssize(ratios); j += step) {
    const DrivenRatio& other = ratios[static_cast<std::size_t>(j)];
    if (!(other.power < power || (step > 0 && other.power == power)))
      return false;  // above, or nothing drives there
    if (std::log(power / other.power) >
        std::numbers::ln2 + measure_thresholds().driven_peak_sd * (ratios[i].sd + other.sd))
      return true;
  }
  return false;
}

std::vector<DrivenPeak> peaks_of(const std::vector<double>& middles, const std::vector<DrivenRatio>& ratios) {
  std::vector<DrivenPeak> peaks;
  for (std::size_t i = 0; i < middles.size(); ++i)
    if (falls(ratios, i, -1) && falls(ratios, i, 1)) peaks.push_back({middles[i], ratios[i].power});
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const DrivenPeak& a, const DrivenPeak& b) { return a.power > b.power; });
  return peaks;
}

// Of every mode the nearest peak within its search range, a peak to the mode it is nearest to; further ones to
// modes that are driven and have none in range.
void assign(ModeLines& found, const std::vector<DrivenPeak>& peaks, const std::vector<double>& nominal,
            const std::vector<double>& middles) {
  const auto off = [&](const DrivenPeak& peak, std::size_t mode) {
    const double by = std::abs(peak.frequency - nominal[mode]) / nominal[mode];
    return by < measure_thresholds().largest_detuning ? by : std::numeric_limits<double>::infinity();
  };
  std::vector<bool> is_in_range(peaks.size(), false);
  std::vector<double> nearest(nominal.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> has_any(nominal.size(), false);
  for (std::size_t p = 0; p < peaks.size(); ++p) {
    std::size_t own = nominal.size();
    for (std::size_t k = 0; k < nominal.size(); ++k) {
      if (!std::isfinite(off(peaks[p], k))) continue;
      has_any[k] = is_in_range[p] = true;
      if (own == nominal.size() || off(peaks[p], k) < off(peaks[p], own)) own = k;
    }
    if (own == nominal.size() || off(peaks[p], own) >= nearest[own]) continue;
    nearest[own] = off(peaks[p], own);
    found.at_nominal[own] = peaks[p].frequency;
  }
  std::size_t unseen = 0;
  for (std::size_t k = 0; k < nominal.size(); ++k) {
    const bool is_driven = !middles.empty() && nominal[k] > middles.front() && nominal[k] < middles.back();
    found.may_be_further[k] = !has_any[k] && (!std::isfinite(nominal[k]) || nominal.size() == 1 || is_driven);
    if (found.may_be_further[k]) ++unseen;
  }
  for (std::size_t p = 0; p < peaks.size() && found.further.size() < unseen; ++p) {
    const bool is_beside = std::any_of(found.further.begin(), found.further.end(), [&](double taken) {
      return std::abs(peaks[p].frequency - taken) < measure_thresholds().largest_detuning * taken;
    });
    // A nominal value is right to less than a half at best, see (40).
    bool is_credible = false;
    for (std::size_t k = 0; k < nominal.size(); ++k)
      is_credible = is_credible || (found.may_be_further[k] && !(peaks[p].frequency < 0.5 * nominal[k]) &&
                                    !(peaks[p].frequency > 2 * nominal[k]));
    if (is_credible && !is_in_range[p] && !is_beside) found.further.push_back(peaks[p].frequency);
  }
}

}  // namespace

ModeLines driven_lines(const Campaign& campaign, const RecordReader& read, const std::vector<double>& nominal,
                       const Window& window) {
  ModeLines found;
  found.at_nominal.resize(nominal.size());
  found.may_be_further.resize(nominal.size());
  std::vector<DrivenSpectrum> all = lines_of_driven(campaign, read, window);
  found.records = all.size();
  if (all.empty()) return found;
  level_channels(all);
  const std::vector<double> middles = ranges_of(all, window);
  std::vector<DrivenRatio> ratios;
  for (const double middle : middles) ratios.push_back(ratio_at(middle, all));
  assign(found, peaks_of(middles, ratios), nominal, middles);
  return found;
}

}  // namespace secular
