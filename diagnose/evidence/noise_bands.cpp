#include "diagnose/evidence/noise_bands.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numerics/distribution.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Half an octave, and no fewer cosines than this: what a band's noise is, few values do not tell.
constexpr double band_ratio = std::numbers::sqrt2;
constexpr Index fewest_cosines = 4;

/// Of a band whose degrees of freedom are taken by something else nothing is told.
constexpr double fewest_freedom = 1;

Index end_of_band(Index begin, Index size) {
  const Index end =
      std::max(begin + fewest_cosines, static_cast<Index>(std::lround(band_ratio * static_cast<double>(begin))));
  return size - end < fewest_cosines ? size : end;
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

VectorXd noise_by_band(const CosineStretches& stretches, double least) {
  const Index size = stretches.values.rows(), count = stretches.values.cols();
  VectorXd sd = VectorXd::Constant(size, least);
  for (Index begin = 0, end = 0; begin < size; begin = end) {
    end = end_of_band(begin, size);
    std::vector<double> variances, freedoms;
    for (Index s = 0; s < count; ++s) {
      const double freedom = stretches.freedom.col(s).segment(begin, end - begin).sum();
      if (!(freedom >= fewest_freedom)) continue;
      variances.push_back(stretches.values.col(s).segment(begin, end - begin).squaredNorm() / freedom);
      freedoms.push_back(freedom);
    }
    if (variances.empty()) continue;
    const auto quarter = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 4);
    std::nth_element(variances.begin(), quarter, variances.end());
    // A quarter of chi-squared variables is below this.
    const double freedom = upper_median(std::move(freedoms)),
                 below = chi_squared_upper_quantile(0.75, freedom) / freedom;
    sd.segment(begin, end - begin).setConstant(std::max(least, std::sqrt(*quarter / below)));
  }
  return sd;
}

}  // namespace secular
