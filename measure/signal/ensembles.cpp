#include "measure/signal/ensembles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double EnsembleLayout::share() const {
  return std::max(0.0, 1 - static_cast<double>(step) / static_cast<double>(length));
}

EnsembleLayout ensemble_layout(Index samples, Index length, double overlap) {
  if (length < 1 || length > samples || !(overlap >= 0 && overlap < 1))
    throw std::invalid_argument("no ensemble of that length and overlap fits into the record");
  EnsembleLayout layout;
  layout.length = length;
  layout.step = std::max<Index>(1, static_cast<Index>(std::lround((1 - overlap) * static_cast<double>(length))));
  layout.count = (samples - length) / layout.step + 1;
  return layout;
}

double ensemble_correlation(const EnsembleLayout& layout, Index lag) {
  return std::max(0.0, 1 - static_cast<double>(lag * layout.step) / static_cast<double>(layout.length));
}

EnsembleMean ensemble_mean(const Eigen::Ref<const MatrixXd>& values, const EnsembleLayout& layout) {
  const Index count = values.rows();
  if (count < 2) throw std::invalid_argument("the scatter of ensembles needs at least two of them");
  const auto k = static_cast<double>(count);
  MatrixXd correlation(count, count);
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < count; ++j) correlation(i, j) = ensemble_correlation(layout, std::abs(i - j));
  EnsembleMean result;
  result.mean = values.colwise().mean().transpose();
  const MatrixXd centred = values.rowwise() - result.mean.transpose();
  const double mean_variance = correlation.sum() / (k * k);  // of the mean, for unit variance of one ensemble
  const double seen = k - k * mean_variance;                 // expected sum of squares about the mean
  result.independent = 1 / mean_variance;
  result.covariance = (mean_variance / seen) * (centred.transpose() * centred);
  const MatrixXd projected = correlation.rowwise() - correlation.colwise().mean();  // (1 - 11^T/K) R
  result.degrees_of_freedom = projected.trace() * projected.trace() / (projected * projected).trace();
  return result;
}

}  // namespace secular
