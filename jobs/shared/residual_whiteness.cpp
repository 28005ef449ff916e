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

std::vector<double> autocorrelation(const std::vector<double>& left) {
  if (left.size() < fewest_samples) return {};
  const double mean = mean_of(left);
  std::vector<double> sums;
  for (std::size_t lag = 0; lag <= std::min(most_lags, left.size() / 4); ++lag) {
    double sum = 0;
    for (std::size_t i = lag; i < left.size(); ++i) sum += (left[i] - mean) * (left[i - lag] - mean);
    sums.push_back(sum);
  }
  const double variance = sums.front();
  if (!(variance > 0)) return {};
  for (double& sum : sums) sum /= variance;
  return sums;
}

Whiteness whiteness_of(const std::vector<double>& autocorrelation, std::size_t samples) {
  Whiteness result;
  if (autocorrelation.empty()) return result;
  result.band = 1.96 / std::sqrt(static_cast<double>(samples));
  result.lags = autocorrelation.size() - 1;
  result.outside = static_cast<std::size_t>(std::count_if(autocorrelation.begin() + 1, autocorrelation.end(),
                                                          [&](double r) { return std::abs(r) > result.band; }));
  return result;
}

std::string text_of(const Whiteness& whiteness) {
  const double tail =
      binomial_upper_tail(static_cast<double>(whiteness.outside), static_cast<double>(whiteness.lags), 0.05);
  return fmt::format(
      "{} of {} lags leave the band in which white noise has 95 % of them: {}.", whiteness.outside, whiteness.lags,
      tail < 1e-3 ? "what is left is not white, it holds motion that the model does not make, or coloured noise"
                  : "what is left is like white noise");
}

report::Figure autocorrelation_figure(const std::vector<double>& autocorrelation, std::size_t samples,
                                      double sample_s, const std::string& title) {
  using report::Series;
  using report::SeriesRole;
  using report::SeriesStyle;
  const double band = whiteness_of(autocorrelation, samples).band;
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
  figure.title = title;
  figure.x = {"Delay", "s", false, {}};
  figure.panels.push_back({"", {"Autocorrelation", "1", false, {}}, {expected, found}, true});
  figure.panels.front().y.range = std::pair(-1.05, 1.05);
  figure.panel_height_px = 200;
  return figure;
}

void add_whiteness(report::HtmlReport& page, const std::vector<double>& left, double sample_s) {
  const std::vector<double> correlation = autocorrelation(left);
  if (correlation.empty()) return;
  page.figure(autocorrelation_figure(correlation, left.size(), sample_s, "Autocorrelation of what is left"),
              text_of(whiteness_of(correlation, left.size())));
}

}  // namespace secular
