#include "estimator/identification/condition_scatter.hpp"

#include <Eigen/Dense>

#include "numerics/unit_scale.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Singular values of columns of unit norm below this share of the largest are none.
constexpr double lost_column = 1e-9;

// Residuals of the common fit in the case's coordinates, less those of its own: what the other unknowns of the case
// take up is taken off.
VectorXd left_by_common_fit(const CommonFit& c) {
  const RowsByCondition& rows = *c.rows;
  const VectorXd left = rows.estimate - rows.entries * (c.values - rows.reference);
  if (rows.others.cols() == 0) return left;
  const MatrixXd weighted = rows.kept * rows.others;
  return left -
         rows.others * VectorXd(weighted.completeOrthogonalDecomposition().solve(VectorXd(rows.kept * left)));
}

}  // namespace

std::optional<ClusterScatter> condition_scatter(std::span<const CommonFit> cases, const MatrixXd& further,
                                                const MatrixXd& directions) {
  const Index common = directions.rows(), fitted = directions.cols();
  Index height = further.rows(), width = fitted;
  for (const CommonFit& c : cases) {
    height += c.rows->entries.rows();
    width += c.rows->others.cols();
  }
  MatrixXd design = MatrixXd::Zero(height, width);
  Index row = 0, column = fitted;
  for (const CommonFit& c : cases) {
    const Index rank = c.rows->entries.rows(), others = c.rows->others.cols();
    const MatrixXd weight = c.rows->kept / c.rows->residual_sd;
    design.block(row, 0, rank, fitted) = weight * c.rows->entries * c.slope * directions;
    design.block(row, column, rank, others) = weight * c.rows->others;
    row += rank;
    column += others;
  }
  design.block(row, 0, further.rows(), fitted) = further * directions;
  const VectorXd scale = unit_scale(design);
  const Eigen::BDCSVD<MatrixXd> svd(design * scale.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  const VectorXd& singular = svd.singularValues();
  Index rank = 0;
  while (rank < singular.size() && singular(rank) > lost_column * singular(0)) ++rank;
  const MatrixXd u = svd.matrixU().leftCols(rank);
  const MatrixXd of_fitted = scale.head(fitted).asDiagonal() * svd.matrixV().topLeftCorner(fitted, rank) *
                             singular.head(rank).cwiseInverse().asDiagonal();
  const MatrixXd spread = directions * of_fitted;
  // By condition of all cases: its Gram matrix in the coordinates u, and what it leaves.
  std::vector<ClusterOfRows> conditions;
  VectorXd repeats = VectorXd::Zero(common), repeats_error = VectorXd::Zero(common);
  row = 0;
  for (const CommonFit& c : cases) {
    const RowsByCondition& rows = *c.rows;
    const MatrixXd part = u.middleRows(row, rows.entries.rows());
    row += rows.entries.rows();
    const Eigen::PartialPivLU<MatrixXd> kept(rows.kept);
    const VectorXd left = left_by_common_fit(c);
    const double noise = rows.repeat_variance / (rows.residual_sd * rows.residual_sd);
    const MatrixXd by_coordinate = spread * part.transpose();
    const VectorXd of_case =
        rows.repeat_gram.size() > 0
            ? VectorXd(noise * (by_coordinate * rows.repeat_gram).cwiseProduct(by_coordinate).rowwise().sum())
            : VectorXd(noise * by_coordinate.rowwise().squaredNorm());
    repeats += of_case;
    if (rows.repeat_freedom > 0) repeats_error += of_case.cwiseAbs2() / rows.repeat_freedom;
    for (std::size_t g = 0; g < rows.gram.size(); ++g) {
      const MatrixXd gram = part.transpose() * rows.gram[g] * MatrixXd(kept.solve(part));
      const VectorXd score = part.transpose() * (rows.score[g] + rows.gram[g] * left) / rows.residual_sd;
      conditions.push_back({0.5 * (gram + gram.transpose()), score});
    }
  }
  std::optional<ClusterScatter> result = cluster_scatter(conditions, spread);
  // Conditions differ by no less than their repeats make them: docs/inference.md (27).
  if (result) result->keep_above(repeats, repeats_error);
  return result;
}

}  // namespace secular
