#pragma once

#include <string>
#include <vector>

#include "report/html_report.hpp"

namespace secular {

/// docs/inference.md (R1): share of what was measured that is computed, 1 - |measured - computed| / |measured -
/// mean|, Euclidean norms over the samples; 1 is perfect, 0 no better than the mean. Sizes equal.
double share_fitted(const std::vector<double>& measured, const std::vector<double>& computed);

/// docs/inference.md (R2): autocorrelation of `left`, mean removed, at lags 0 to min(40, N/4). Empty where nothing
/// is left or N < 16.
std::vector<double> autocorrelation(const std::vector<double>& left);

/// Of lags beyond zero: how many there are, and how many leave the 95 % band of white noise, +-1.96/sqrt(N).
struct Whiteness {
  std::size_t lags = 0, outside = 0;
  double band = 0;  ///< half width
};
Whiteness whiteness_of(const std::vector<double>& autocorrelation, std::size_t samples);

/// "White: 2 of 40 lags leave ...", or what it means that more do: binomial, 1 in 1000 (docs/inference.md (R2)).
std::string text_of(const Whiteness& whiteness);

/// The autocorrelation against lag, with its band; `sample_s` between samples.
report::Figure autocorrelation_figure(const std::vector<double>& autocorrelation, std::size_t samples,
                                      double sample_s, const std::string& title);

/// That figure with what it says, where there is anything left to look at.
void add_whiteness(report::HtmlReport& page, const std::vector<double>& left, double sample_s);

}  // namespace secular
