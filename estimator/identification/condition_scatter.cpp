#include "estimator/identification/condition_scatter.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "numerics/unit_scale.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Singular values of columns of unit norm below this share of the largest are none.
constexpr double lost_column = 1e-9;

/// A condition that alone determines a direction leaves nothing to compare it with.
constexpr double largest_leverage = 0.999;

// Residuals of the common fit in the case's coordinates, less those of its own: what the other unknowns of the case
// take up is taken off.
VectorXd left_by_common_fit(const CommonFit& c) {
  const RowsByCondition& rows = *c.rows;
  const VectorXd left = rows.estimate - rows.entries * (c.values - rows.reference);
  if (rows.others.cols() == 0) return left;
  const MatrixXd weighted = rows.kept * rows.others;
  return left - rows.others * weighted.completeOrthogonalDecomposition().solve(rows.kept * left);
}

// Conditions differ by no less than their repeats make them: docs/inference.md (27). `least`: that variance, by
// unknown, and `error`: its square over its degrees of freedom.
void keep_above(const VectorXd& least, const VectorXd& error, ConditionScatter& scatter) {
  VectorXd larger = VectorXd::Ones(least.size());
  for (Index p = 0; p < least.size(); ++p) {
    const double found = scatter.covariance(p, p), kept = std::max(found, least(p));
    double& freedom = scatter.degrees_of_freedom(p);
    if (!(found > 0) || !(freedom > 0)) continue;
    larger(p) = std::sqrt(kept / found);
    freedom = kept * kept / (error(p) + (kept * kept - least(p) * least(p)) / freedom);
  }
  scatter.covariance = larger.asDiagonal() * scatter.covariance * larger.asDiagonal();
}

}  // namespace

std::optional<ConditionScatter> condition_scatter(std::span<const CommonFit> cases, const MatrixXd& further,
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
  // By condition of all cases: its Gram matrix in the coordinates u, and what it alone moves the unknowns by.
  std::vector<MatrixXd> grams, roots;
  std::vector<VectorXd> moves;
  VectorXd repeats = VectorXd::Zero(common), repeats_error = VectorXd::Zero(common);
  row = 0;
  for (const CommonFit& c : cases) {
    const RowsByCondition& rows = *c.rows;
    const MatrixXd part = u.middleRows(row, rows.entries.rows());
    row += rows.entries.rows();
    const Eigen::PartialPivLU<MatrixXd> kept(rows.kept);
    const VectorXd left = left_by_common_fit(c);
    const double noise = rows.repeat_variance / (rows.residual_sd * rows.residual_sd);
    const VectorXd of_case = noise * (spread * part.transpose()).rowwise().squaredNorm();
    repeats += of_case;
    if (rows.repeat_freedom > 0) repeats_error += of_case.cwiseAbs2() / rows.repeat_freedom;
    for (std::size_t g = 0; g < rows.gram.size(); ++g) {
      const MatrixXd gram = part.transpose() * rows.gram[g] * kept.solve(part);
      const MatrixXd symmetric = 0.5 * (gram + gram.transpose());
      const Eigen::SelfAdjointEigenSolver<MatrixXd> stays(MatrixXd::Identity(rank, rank) - symmetric);
      if (stays.eigenvalues().minCoeff() < 1 - largest_leverage) return std::nullopt;
      const MatrixXd root = stays.operatorInverseSqrt();
      const VectorXd score = part.transpose() * (rows.score[g] + rows.gram[g] * left) / rows.residual_sd;
      moves.emplace_back(spread * (root * score));
      roots.emplace_back(root * spread.transpose());
      grams.push_back(symmetric);
    }
  }
  ConditionScatter result{MatrixXd::Zero(common, common), VectorXd::Zero(common)};
  const auto conditions = static_cast<Index>(moves.size());
  for (const VectorXd& move : moves) result.covariance += move * move.transpose();
  // The estimated variance is a sum of squares of linear forms in the residuals; where these are noise of unit
  // variance, the forms have the covariance `forms`.
  for (Index p = 0; p < common; ++p) {
    MatrixXd products(rank, conditions);
    VectorXd own(conditions);
    for (Index g = 0; g < conditions; ++g) {
      const auto at = static_cast<std::size_t>(g);
      products.col(g) = grams[at] * roots[at].col(p);
      own(g) = roots[at].col(p).dot(products.col(g));
    }
    MatrixXd forms = -products.transpose() * products;
    forms.diagonal() += own;
    const double trace = forms.trace(), square = forms.squaredNorm();
    if (trace > 0 && square > 0) result.degrees_of_freedom(p) = trace * trace / square;
  }
  keep_above(repeats, repeats_error, result);
  return result;
}

}  // namespace secular
