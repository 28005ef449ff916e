#include "diagnose/evidence/record_directions.hpp"

#include <Eigen/Dense>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "numerics/distribution.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Of a singular value next to the largest: rounding.
constexpr double nothing = 1e-12;

}  // namespace

RecordDirections::RecordDirections(std::vector<Index> rows, MatrixXd columns, VectorXd put_in)
    : rows_(std::move(rows)), columns_(std::move(columns)), put_in_(std::move(put_in)) {
  const Eigen::BDCSVD<MatrixXd> svd(columns_, Eigen::ComputeThinU);
  const VectorXd& s = svd.singularValues();
  Index rank = 0;
  while (rank < s.size() && s(rank) > nothing * s(0)) ++rank;
  basis_ = svd.matrixU().leftCols(rank);
  dropped_ = s.head(rank).unaryExpr([](double x) { return 1 - 1 / std::sqrt(1 + x * x); });
}

void RecordDirections::whiten_slopes(Eigen::Ref<MatrixXd> all) const {
  const MatrixXd own = all(rows_, Eigen::all);
  all(rows_, Eigen::all) = own - basis_ * (dropped_.asDiagonal() * (basis_.transpose() * own));
}

void RecordDirections::whiten_rows(Eigen::Ref<VectorXd> all) const {
  const VectorXd own = VectorXd(all(rows_)) - columns_ * put_in_;
  all(rows_) = own - basis_ * (dropped_.asDiagonal() * (basis_.transpose() * own));
}

// Least |r + C d|^2 + |c + d|^2 over the step d from what was put in.
VectorXd RecordDirections::likeliest(const VectorXd& all) const {
  const VectorXd own = all(rows_);
  MatrixXd normal = columns_.transpose() * columns_;
  normal.diagonal().array() += 1;
  return put_in_ - normal.ldlt().solve(VectorXd(columns_.transpose() * own + put_in_));
}

RecordDirections::Told RecordDirections::told(const VectorXd& all, Index entry) const {
  const VectorXd own = all(rows_);
  // What the others may do is taken out of the column: what is left of it tells this one.
  MatrixXd others(columns_.rows(), columns_.cols() - 1);
  others << columns_.leftCols(entry), columns_.rightCols(columns_.cols() - entry - 1);
  VectorXd column = columns_.col(entry);
  const double before = column.norm();
  if (others.cols() > 0) column -= others * VectorXd(others.completeOrthogonalDecomposition().solve(column));
  const double squares = column.squaredNorm();
  if (!(squares > nothing * before * before)) return {0, std::numeric_limits<double>::infinity()};
  return {put_in_(entry) - column.dot(own) / squares, 1 / squares};
}

Between between_records(const VectorXd& values, const VectorXd& variances, const MatrixXd& functions) {
  const auto excess = [&](double variance) {
    const VectorXd root = (variances.array() + variance).rsqrt();
    const MatrixXd weighted = root.asDiagonal() * functions;
    const VectorXd wanted = root.cwiseProduct(values);
    return (wanted - weighted * VectorXd(weighted.householderQr().solve(wanted))).squaredNorm();
  };
  const auto freedom = static_cast<double>(values.size() - functions.cols());
  Between result;
  const double alone = excess(0);
  result.p_value = chi_squared_upper_tail(alone, freedom);
  if (!(alone > freedom)) return result;
  // The sum falls with the variance, and is below its expectation at the plain sum of squares.
  const double most = values.squaredNorm();
  std::uintmax_t steps = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      [&](double variance) { return excess(variance) - freedom; }, 0.0, most, alone - freedom,
      excess(most) - freedom, boost::math::tools::eps_tolerance<double>(40), steps);
  result.sd = std::sqrt(0.5 * (low + high));
  return result;
}

}  // namespace secular
