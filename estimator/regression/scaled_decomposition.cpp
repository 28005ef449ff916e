#include "estimator/regression/scaled_decomposition.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <vector>

#include "estimator/regression/condensed_rows.hpp"
#include "numerics/unit_scale.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ScaledDecomposition scaled_decomposition(const Eigen::Ref<const MatrixXd>& design,
                                         const Eigen::Ref<const VectorXd>& response, double tolerance,
                                         unsigned threads) {
  const Index columns = design.cols();
  ScaledDecomposition result;
  result.scale = unit_scale(design);
  const bool tall = design.rows() > 2 * columns;
  MatrixXd core;
  VectorXd target = response;
  if (tall) {
    const CondensedRows condensed = condensed_rows(design, response, threads);
    core = condensed.design.topRows(columns) * result.scale.asDiagonal();
    target = condensed.response.head(columns);
  } else {
    core = design * result.scale.asDiagonal();
  }
  const Eigen::BDCSVD<MatrixXd> svd(core, Eigen::ComputeThinU | Eigen::ComputeFullV);
  const VectorXd singular = svd.singularValues();
  result.largest = singular(0);
  const double cut = tolerance * std::max(singular(0), std::numeric_limits<double>::min());
  // Singular values come in falling order.
  const Index rank = (singular.array() > cut).count();
  const MatrixXd left = svd.matrixU().leftCols(rank);
  result.seen = svd.matrixV().leftCols(rank);
  result.null = svd.matrixV().rightCols(columns - rank);
  result.inverse = singular.head(rank).cwiseInverse();
  result.coordinates = left.transpose() * target;
  if (!tall) result.left = left;
  return result;
}

}  // namespace secular
