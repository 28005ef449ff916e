#include "jobs/shared/residual_whiteness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numerics/distribution.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

constexpr std::size_t most_lags = 40, fewest_samples = 16;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

report::Figure autocorrelation_figure(const std::vector<double>& autocorrelation, double band, double sample_s) {
  using report::Series;
  using report::SeriesRole;
  using report::SeriesStyle;
  Series expected{"95 % of white noise", SeriesStyle::band, SeriesRole::reference, {}, {}, {}, {}};
  Series found{"what is left", SeriesStyle::line_and_points, SeriesRole::data, {}, {}, {}, {}};
  for (std::size_t lag = 0; lag < autocorrelation.size(); ++lag) {
    const double delay = static_cast<double>(lag) * sample_s;
    expected.x.push_back(delay);
    expected.y.push_back(0);
    expected.y_error.push_back(band);
    found.x.push_back(delay);
    found.y.push_back(autocorrelation[lag]);
  }
  report::Figure figure;
  figure.title = "Autocorrelation of what is left";
  figure.x = {"Delay", "s", false, {}};
  figure.panels.push_back({"", {"Autocorrelation", "1", false, {}}, {expected, found}, true});
  figure.panels.front().y.range = std::pair(-1.05, 1.05);
  figure.panel_height_px = 200;
  return figure;
}

}  // namespace

double share_fitted(const std::vector<double>& measured, const std::vector<double>& computed) {
  const double mean = measured.empty() ? 0 : mean_of(measured);
  double left = 0, all = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    left += std::pow(measured[i] - computed[i], 2);
    all += std::pow(measured[i] - mean, 2);
  }
  return 1 - std::sqrt(left / all);
}

std::size_t LeftInTime::samples() const {
  return std::accumulate(stretches.begin(), stretches.end(), std::size_t{0},
                         [](std::size_t sum, const std::vector<double>& one) { return sum + one.size(); });
}

std::vector<double> autocorrelation(const LeftInTime& left) {
  const std::size_t samples = left.samples();
  if (samples == 0 || samples < fewest_samples * left.stretches.size()) return {};
  double mean = 0;
  for (const std::vector<double>& stretch : left.stretches)
    mean += std::accumulate(stretch.begin(), stretch.end(), 0.0) / static_cast<double>(samples);
  std::vector<double> sums;
  for (std::size_t lag = 0; lag <= std::min(most_lags, samples / left.stretches.size() / 4); ++lag) {
    double sum = 0;
    for (const std::vector<double>& stretch : left.stretches)
      for (std::size_t i = lag; i < stretch.size(); ++i) sum += (stretch[i] - mean) * (stretch[i - lag] - mean);
    sums.push_back(sum);
  }
  const double variance = sums.front();
  if (!(variance > 0)) return {};
  for (double& sum : sums) sum /= variance;
  return sums;
}

bool Whiteness::is_white() const {
  return lags == 0 || binomial_upper_tail(static_cast<double>(outside), static_cast<double>(lags), 0.05) >= 1e-3;
}

Whiteness whiteness_of(const LeftInTime& left) {
  const std::vector<double> found = autocorrelation(left);
  Whiteness result;
  if (found.empty()) return result;
  const auto samples = static_cast<double>(left.samples());
  result.band = 1.96 / std::sqrt(samples) + static_cast<double>(left.fitted) / samples;
  result.lags = found.size() - 1;
  result.outside = static_cast<std::size_t>(
      std::count_if(found.begin() + 1, found.end(), [&](double r) { return std::abs(r) > result.band; }));
  return result;
}

std::string text_of(const Whiteness& whiteness) {
  return fmt::format(
      "{} of {} lags leave the band in which white noise has 95 % of them: {}.", whiteness.outside, whiteness.lags,
      whiteness.is_white()
          ? "what is left is like white noise"
          : "what is left is not white, it holds motion that the model does not make, or coloured noise");
}

void add_whiteness(report::HtmlReport& page, const LeftInTime& left, double sample_s) {
  const std::vector<double> correlation = autocorrelation(left);
  if (correlation.empty()) return;
  const Whiteness whiteness = whiteness_of(left);
  page.figure(autocorrelation_figure(correlation, whiteness.band, sample_s), text_of(whiteness));
}

}  // namespace secular
