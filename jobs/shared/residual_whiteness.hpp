#pragma once

#include <string>
#include <vector>

#include "report/html_report.hpp"

namespace secular {

/// docs/inference.md (R1): share of what was measured that is computed, 1 - |measured - computed| / |measured -
/// mean|, Euclidean norms over the samples; 1 is perfect, 0 no better than the mean. Sizes equal.
double share_fitted(const std::vector<double>& measured, const std::vector<double>& computed);

/// What is left of samples: stretches without a gap, and how many numbers were fitted to them besides parameters
/// (states at the beginnings of segments).
struct LeftInTime {
  std::vector<std::vector<double>> stretches;
  std::size_t fitted = 0;
  std::size_t samples() const;
};

/// docs/inference.md (R2): autocorrelation within stretches, mean of all removed, at lags 0 to min(40, a quarter of
/// the mean length). Empty where nothing is left or a stretch has fewer than 16 samples in the mean.
std::vector<double> autocorrelation(const LeftInTime& left);

/// Of lags beyond zero: how many there are, and how many leave the 95 % band of white noise to which numbers were
/// fitted, +-(1.96/sqrt(N) + fitted/N).
struct Whiteness {
  std::size_t lags = 0, outside = 0;
  double band = 0;        ///< half width
  bool is_white() const;  ///< else an alarm: binomial, 1 in 1000
};
Whiteness whiteness_of(const LeftInTime& left);

/// "White: 2 of 40 lags leave ...", or what it means that more do: binomial, 1 in 1000 (docs/inference.md (R2)).
std::string text_of(const Whiteness& whiteness);

/// The autocorrelation against lag, with its band, and what it says, where there is anything left to look at;
/// `sample_s` between samples.
void add_whiteness(report::HtmlReport& page, const LeftInTime& left, double sample_s);

}  // namespace secular
