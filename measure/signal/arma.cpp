#include "measure/signal/arma.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <stdexcept>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// [V|U] of Eq. (C.4).
MatrixXd paired_hankel(const Eigen::Ref<const VectorXd>& input, const Eigen::Ref<const VectorXd>& output,
                       int ar_order, int ma_order) {
  if (input.size() != output.size()) throw std::invalid_argument("input and output of different lengths");
  if (ar_order < 0 || ma_order < 0) throw std::invalid_argument("negative order of an ARMA relation");
  const Index rows = input.size() - std::max(ar_order, ma_order), unknowns = ar_order + ma_order + 2;
  if (rows < unknowns) throw std::invalid_argument("too few samples for the orders of an ARMA relation");
  MatrixXd paired(rows, unknowns);
  for (Index k = 0; k <= ar_order; ++k) paired.col(k) = output.segment(k, rows);
  for (Index k = 0; k <= ma_order; ++k) paired.col(ar_order + 1 + k) = input.segment(k, rows);
  return paired;
}

}  // namespace

MatrixXd delayed_correlation(const Eigen::Ref<const VectorXd>& input, const Eigen::Ref<const VectorXd>& output,
                             int ar_order, int ma_order) {
  MatrixXd paired = paired_hankel(input, output, ar_order, ma_order);
  for (Index k = 0; k < paired.cols(); ++k) {
    paired.col(k).array() -= paired.col(k).mean();
    const double norm = paired.col(k).norm();
    if (norm > 0) paired.col(k) /= norm;
  }
  return paired.transpose() * paired;
}

double input_output_correlation(const Eigen::Ref<const VectorXd>& input, const Eigen::Ref<const VectorXd>& output,
                                int ar_order, int ma_order) {
  const MatrixXd correlation = delayed_correlation(input, output, ar_order, ma_order);
  const Index v = ar_order + 1, u = ma_order + 1;
  const double both = correlation.topLeftCorner(v, v).norm() * correlation.bottomRightCorner(u, u).norm();
  return both > 0 ? correlation.topRightCorner(v, u).squaredNorm() / both : 0;
}

}  // namespace secular
