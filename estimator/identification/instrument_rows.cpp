#include "estimator/identification/instrument_rows.hpp"

#include <Eigen/Dense>
#include <limits>
#include <map>

#include "numerics/unit_scale.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Relative: what rounding leaves of columns that depend on others.
constexpr double dependent_columns = 1e-10;

// Orthonormal directions of the columns: rows x rank.
MatrixXd directions_of(const MatrixXd& columns) {
  Eigen::ColPivHouseholderQR<MatrixXd> split(columns * unit_scale(columns).asDiagonal());
  split.setThreshold(dependent_columns);
  return split.householderQ() * MatrixXd::Identity(columns.rows(), split.rank());
}

}  // namespace

InstrumentRows instrument_rows(const MatrixXd& instruments, const MatrixXd& columns, const VectorXd& response) {
  const VectorXd scale = unit_scale(columns), own = unit_scale(instruments);
  const MatrixXd directions = directions_of(instruments);
  const MatrixXd seen = directions.transpose() * columns;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(dependent_columns);
  solver.compute(MatrixXd(seen * scale.asDiagonal()));
  const VectorXd coefficients = scale.cwiseProduct(solver.solve(VectorXd(directions.transpose() * response)));
  InstrumentRows result;
  result.design = directions * seen;
  result.response = response - (columns - result.design) * coefficients;
  solver.compute(MatrixXd(directions.transpose() * instruments * own.asDiagonal()));
  result.onto = own.asDiagonal() * MatrixXd(solver.solve(seen));
  return result;
}

double instrument_relevance(const MatrixXd& explained, const MatrixXd& columns,
                            const std::vector<std::size_t>& record) {
  const MatrixXd directions = directions_of(explained);
  if (directions.cols() == 0) return 0;
  const MatrixXd left = columns - explained;
  std::map<std::size_t, MatrixXd> by_record;
  for (Index r = 0; r < left.rows(); ++r) {
    MatrixXd& sum = by_record[record[static_cast<std::size_t>(r)]];
    if (sum.size() == 0) sum = MatrixXd::Zero(directions.cols(), left.cols());
    sum += directions.row(r).transpose() * left.row(r);
  }
  // explained = directions seen: of directions, what chance makes of each.
  const Eigen::CompleteOrthogonalDecomposition<MatrixXd> seen(directions.transpose() * explained);
  const MatrixXd back = seen.pseudoInverse();
  MatrixXd by_chance = MatrixXd::Zero(directions.cols(), directions.cols());
  for (const auto& [index, sum] : by_record) {
    const MatrixXd share = sum * back;
    by_chance += share.transpose() * share;
  }
  const double most = Eigen::SelfAdjointEigenSolver<MatrixXd>(by_chance).eigenvalues().maxCoeff();
  return most > 0 ? 1 / most : std::numeric_limits<double>::infinity();
}

}  // namespace secular
