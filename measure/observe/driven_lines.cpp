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

// Shares and numbers of docs/inference.md (51).

/// Half of the range, as a share of its middle, whose lines are one value.
constexpr double half_range = 0.01;
/// At least so many lines to either side: neighbours of a Hann window are correlated.
constexpr Index fewest_lines = 4;
/// DrivenSpectrum of a Hann window over those that are independent.
constexpr double lines_per_value = 1.5;
/// A line drives where it holds this share of the power about it, and that this share of the largest.
constexpr double share_about = 0.1, share_of_largest = 0.01;
/// Ranges over which lines are compared to tell their scatter.
constexpr Index wider = 5;
/// Standard deviations by which noise moves a peak, and a valley: one range in 30,000.
constexpr double sure = 4;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Power of one record's lines.
struct DrivenSpectrum {
  double bin = 0;      // rad/s
  VectorXd driving;    // of all excitations
  VectorXd about;      // the mean of `driving` over the range about each line
  double largest = 0;  // of `about`
  MatrixXd response;   // lines x channels

  bool drives(Index i) const {
    return about(i) >= share_of_largest * largest && driving(i) >= share_about * about(i);
  }
  Index half(double frequency) const {
    return std::max(fewest_lines, static_cast<Index>(half_range * frequency / bin));
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

MatrixXd powers(const MatrixXd& samples) {
  MatrixXd power(samples.rows() / 2 + 1, samples.cols());
  const VectorXd hann =
      (1 - (VectorXd::LinSpaced(samples.rows(), 0, static_cast<double>(samples.rows() - 1)).array() * two_pi /
            static_cast<double>(samples.rows()))
               .cos());
  for (Index c = 0; c < samples.cols(); ++c)
    power.col(c) =
        half_spectrum((samples.col(c).array() - samples.col(c).mean()).matrix().cwiseProduct(hann)).cwiseAbs2();
  return power;
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
    lines.driving = powers(samples_of(record, excitations, range.first, count)).rowwise().sum();
    lines.about = mean_about(lines.driving, lines);
    lines.largest = lines.about.maxCoeff();
    lines.response = powers(samples_of(record, responses, range.first, count));
    if (lines.largest > 0 && lines.response.allFinite()) all.push_back(std::move(lines));
  }
  return all;
}

// Middles of ranges, rad/s, that overlap by three quarters.
std::vector<double> ranges_of(const std::vector<DrivenSpectrum>& all, const Window& window) {
  double low = std::numeric_limits<double>::infinity(), high = 0, finest = low;
  for (const DrivenSpectrum& lines : all)
    for (Index i = 1; i < lines.about.size(); ++i) {
      const double frequency = static_cast<double>(i) * lines.bin;
      if (lines.about(i) < share_of_largest * lines.largest || !window.passes(frequency)) continue;
      low = std::min(low, frequency);
      high = std::max(high, frequency);
      finest = std::min(finest, lines.bin);
    }
  std::vector<double> middles;
  for (double w = low; w <= high; w += std::max(finest, half_range * w / 4)) middles.push_back(w);
  return middles;
}

// Response over excitation at one middle.
struct DrivenRatio {
  double power = nothing;  // sum over channels
  double sd = nothing;     // of its logarithm, at most
};

// Standard deviation of a line's logarithm: by second differences of lines about it, each next but one to the last.
double sd_of_lines(const DrivenSpectrum& lines, Index channel, Index at, Index half) {
  const Index low = std::max<Index>(3, at - wider * half),
              end = std::min(lines.about.size() - 2, at + wider * half + 1);
  const auto logarithm = [&](Index i) {
    return lines.drives(i) ? std::log(lines.response(i, channel) / lines.driving(i)) : nothing;
  };
  std::vector<double> differences;
  for (Index i = low; i < end; ++i)
    if (const double second = logarithm(i - 2) - 2 * logarithm(i) + logarithm(i + 2); std::isfinite(second))
      differences.push_back(std::abs(second));
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
      if (lines.about.segment(at - half, 2 * half + 1).minCoeff() < share_of_largest * lines.largest) continue;
      for (Index i = at - half; i <= at + half; ++i)
        if (lines.drives(i)) values.push_back(lines.response(i, c) / lines.driving(i));
      sd = std::max(sd, sd_of_lines(lines, c, at, half));
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
    if (std::log(power / other.power) > std::numbers::ln2 + sure * (ratios[i].sd + other.sd)) return true;
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
  const std::vector<DrivenPeak> peaks = peaks_of(middles, ratios);
  const auto is_near = [](double line, double own) {
    return std::abs(line - own) < measure_thresholds().largest_detuning * own;
  };
  const auto is_driven = [&](double frequency) {
    return !middles.empty() && frequency > middles.front() && frequency < middles.back();
  };
  std::vector<double> explained;
  std::size_t unseen = 0;
  for (std::size_t k = 0; k < nominal.size(); ++k) {
    for (const DrivenPeak& peak : peaks)
      if (!found.at_nominal[k] && is_near(peak.frequency, nominal[k])) found.at_nominal[k] = peak.frequency;
    if (found.at_nominal[k]) explained.push_back(*found.at_nominal[k]);
    found.may_be_further[k] = !std::isfinite(nominal[k]) || nominal.size() == 1 || is_driven(nominal[k]);
    if (found.may_be_further[k] && !found.at_nominal[k]) ++unseen;
  }
  for (const DrivenPeak& peak : peaks) {
    if (found.further.size() >= unseen) break;
    if (std::none_of(explained.begin(), explained.end(),
                     [&](double own) { return is_near(peak.frequency, own); })) {
      found.further.push_back(peak.frequency);
      explained.push_back(peak.frequency);
    }
  }
  return found;
}

}  // namespace secular
