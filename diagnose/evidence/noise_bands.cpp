#include "diagnose/evidence/noise_bands.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Half an octave, and no fewer cosines than this: what a band's noise is, few values do not tell.
constexpr double band_ratio = std::numbers::sqrt2;
constexpr auto& fewest_cosines = diagnose_thresholds().fewest_cosines;

/// Of a band whose degrees of freedom are taken by something else nothing is told.
constexpr double fewest_freedom = 1;

Index end_of_band(Index begin, Index size) {
  const Index end =
      std::max(begin + fewest_cosines, static_cast<Index>(std::lround(band_ratio * static_cast<double>(begin))));
  return size - end < fewest_cosines ? size : end;
}

struct NoiseBand {
  Index begin, end;
  double variance;  // NaN: not told
};

// Of the middle stretch.
double middle_variance(const CosineStretches& stretches, const NoiseBand& band) {
  std::vector<double> of_stretches, freedoms;
  for (Index s = 0; s < stretches.values.cols(); ++s) {
    const double freedom = stretches.freedom.col(s).segment(band.begin, band.end - band.begin).sum();
    if (!(freedom >= fewest_freedom)) continue;
    of_stretches.push_back(stretches.values.col(s).segment(band.begin, band.end - band.begin).squaredNorm() /
                           freedom);
    freedoms.push_back(freedom);
  }
  if (of_stretches.empty()) return NAN;
  const double freedom = upper_median(std::move(freedoms));
  return upper_median(std::move(of_stretches)) * freedom / chi_squared_upper_quantile(0.5, freedom);
}

// Of all stretches together; zero where they tell nothing.
double mean_variance(const CosineStretches& stretches, const NoiseBand& band) {
  const Index count = band.end - band.begin;
  const double freedom = stretches.freedom.middleRows(band.begin, count).sum();
  return freedom >= fewest_freedom ? stretches.values.middleRows(band.begin, count).squaredNorm() / freedom : 0;
}

// Between the nearest bands that are told, as a geometric mean; zero where none is.
double told_or_between(const std::vector<NoiseBand>& bands, std::size_t at) {
  double below = NAN, above = NAN;
  for (std::size_t b = 0; b <= at; ++b)
    if (std::isfinite(bands[b].variance)) below = bands[b].variance;
  for (std::size_t b = bands.size(); b-- > at;)
    if (std::isfinite(bands[b].variance)) above = bands[b].variance;
  if (std::isfinite(below) && std::isfinite(above)) return std::sqrt(below * above);
  return std::isfinite(below) ? below : std::isfinite(above) ? above : 0;
}

}  // namespace

MatrixXd cosines(Index samples) {
  const auto n = static_cast<double>(samples);
  MatrixXd rows(samples, samples);
  for (Index k = 0; k < samples; ++k)
    for (Index i = 0; i < samples; ++i)
      rows(k, i) = std::sqrt((k == 0 ? 1 : 2) / n) *
                   std::cos(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / n);
  return rows;
}

VectorXd noise_by_band(const CosineStretches& stretches, const std::vector<Index>& of_motion, double white) {
  const Index size = stretches.values.rows(), count = stretches.values.cols();
  std::vector<NoiseBand> bands;
  double least = white * white;
  for (Index begin = 0; begin < size; begin = bands.back().end) {
    bands.push_back({begin, end_of_band(begin, size), NAN});
    NoiseBand& band = bands.back();
    const bool moves = std::any_of(of_motion.begin(), of_motion.end(),
                                   [&](Index k) { return k + 1 >= band.begin && k <= band.end; });
    if (moves) continue;
    band.variance = middle_variance(stretches, band);
    if (const double mean = mean_variance(stretches, band); mean > 0) least = std::min(least, mean);
  }
  VectorXd variance(size);
  for (std::size_t b = 0; b < bands.size(); ++b)
    variance.segment(bands[b].begin, bands[b].end - bands[b].begin)
        .setConstant(std::max(least, told_or_between(bands, b)));
  // What all bands of a stretch hold together, in units of these.
  std::vector<double> whole;
  for (Index s = 0; s < count; ++s)
    whole.push_back(stretches.values.col(s).cwiseAbs2().cwiseQuotient(variance).sum() /
                    stretches.freedom.col(s).sum());
  const auto quarter = whole.begin() + count / 4;
  std::nth_element(whole.begin(), quarter, whole.end());
  const double freedom = stretches.freedom.sum() / static_cast<double>(count),
               below = chi_squared_upper_quantile(0.75, freedom) / freedom;
  return (variance * std::min(1.0, *quarter / below)).cwiseMax(least).cwiseSqrt();
}

}  // namespace secular
