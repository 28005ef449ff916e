#include "diagnose/inference/fold_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/inference/directions.hpp"
#include "numerics/cluster_scatter.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// In the coordinates of the columns along the directions that are seen, `columns`.
std::vector<ClusterOfRows> folds_of(const MatrixXd& columns, const VectorXd& rows,
                                    const std::vector<RowLabel>& labels) {
  std::map<int, std::vector<Index>> of_fold;
  for (std::size_t r = 0; r < labels.size(); ++r) of_fold[labels[r].fold].push_back(static_cast<Index>(r));
  std::vector<ClusterOfRows> clusters;
  for (const auto& [fold, which] : of_fold) {
    const MatrixXd part = columns(which, Eigen::all);
    clusters.push_back({part.transpose() * part, part.transpose() * rows(which)});
  }
  return clusters;
}

}  // namespace

MatrixXd covariance_of(const Refit& fit, const std::vector<RowLabel>& labels, double freedom,
                       double least_dispersion) {
  const MatrixXd plain =
      std::max(least_dispersion, dispersion_of(fit.chi_squared, freedom - static_cast<double>(fit.rank))) *
      fit.covariance;
  if (fit.rank == 0) return plain;
  const MatrixXd to_unknowns = Directions(fit.jacobian).to_orthonormal();
  const auto scatter =
      cluster_scatter(folds_of(fit.jacobian * to_unknowns, fit.rows, labels), fit.scale.asDiagonal() * to_unknowns);
  if (!scatter) return plain;
  const VectorXd wider = plain.diagonal().binaryExpr(scatter->covariance.diagonal(), [](double is, double found) {
    return is > 0 ? std::sqrt(std::max(1.0, found / is)) : 1.0;
  });
  return wider.asDiagonal() * plain * wider.asDiagonal();
}

}  // namespace secular
