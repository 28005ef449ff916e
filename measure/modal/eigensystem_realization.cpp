#include "measure/modal/eigensystem_realization.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rank_tolerance = 1e-13;

const MatrixXd& block(const ResponseSequence& responses, Index k) {
  return responses[static_cast<std::size_t>(k)];
}

// H_rs of Eq. (A.5) with Y(first) in its corner.
MatrixXd block_hankel(const ResponseSequence& responses, Index first, HankelSize size) {
  const Index p = responses.front().rows(), q = responses.front().cols();
  MatrixXd hankel(size.rows * p, size.columns * q);
  for (Index c = 0; c < size.columns; ++c)
    for (Index r = 0; r < size.rows; ++r) hankel.block(r * p, c * q, p, q) = block(responses, first + r + c);
  return hankel;
}

void check(const ResponseSequence& responses, double rate, bool feedthrough, HankelSize size) {
  const auto fail = [](const char* what) {
    throw std::invalid_argument(std::string("EigensystemRealization: ") + what);
  };
  const auto samples = static_cast<Index>(responses.size());
  if (samples < 4) fail("fewer than four samples");
  if (!(rate > 0) || !std::isfinite(rate)) fail("the sample rate is not positive");
  for (const MatrixXd& y : responses) {
    if (y.size() == 0 || y.rows() != responses.front().rows() || y.cols() != responses.front().cols())
      fail("response matrices of unequal size");
    if (!y.allFinite()) fail("samples that are not finite");
  }
  if (size.rows < 1 || size.columns < 1 || size.rows + size.columns + (feedthrough ? 1 : 0) > samples)
    fail("the Hankel matrix does not fit into the samples");
}

}  // namespace

HankelSize hankel_size(Index samples, Index responses, Index references, int largest_order, bool feedthrough,
                       Index row_limit) {
  const Index usable = samples - (feedthrough ? 1 : 0);
  HankelSize size;
  size.columns = std::max<Index>(1, std::min<Index>((2 * largest_order + references - 1) / references, usable / 2));
  size.rows = std::max<Index>(1, std::min(usable - size.columns, std::max<Index>(1, row_limit / responses)));
  return size;
}

EigensystemRealization::EigensystemRealization(const ResponseSequence& responses, double sample_rate_hz,
                                               bool feedthrough, HankelSize size)
    : sample_rate_hz_(sample_rate_hz), feedthrough_(feedthrough) {
  check(responses, sample_rate_hz, feedthrough, size);
  const Index p = responses.front().rows(), q = responses.front().cols();
  const Index first = feedthrough ? 1 : 0;
  const MatrixXd hankel = block_hankel(responses, first, size);
  // A tall matrix is reduced to its triangular factor first: H = O R, R = U S Q^T, P = O U.
  MatrixXd left, right;
  if (hankel.rows() > hankel.cols()) {
    const Eigen::HouseholderQR<MatrixXd> qr(hankel);
    const MatrixXd triangle = qr.matrixQR().topRows(hankel.cols()).triangularView<Eigen::Upper>();
    const Eigen::BDCSVD<MatrixXd> svd(triangle, Eigen::ComputeThinU | Eigen::ComputeThinV);
    left = MatrixXd::Zero(hankel.rows(), hankel.cols());
    left.topRows(hankel.cols()) = svd.matrixU();
    left.applyOnTheLeft(qr.householderQ());
    right = svd.matrixV();
    singular_values_ = svd.singularValues();
  } else {
    const Eigen::BDCSVD<MatrixXd> svd(hankel, Eigen::ComputeThinU | Eigen::ComputeThinV);
    left = svd.matrixU();
    right = svd.matrixV();
    singular_values_ = svd.singularValues();
  }
  while (rank_ < singular_values_.size() && singular_values_(rank_) > rank_tolerance * singular_values_(0)) ++rank_;
  first_rows_ = left.topRows(p).leftCols(rank_);
  first_columns_ = right.topRows(q).leftCols(rank_).transpose();
  shifted_ = left.leftCols(rank_).transpose() * (block_hankel(responses, first + 1, size) * right.leftCols(rank_));
  pulse_ = responses.front();
}

Realization EigensystemRealization::realize(Index order) const {
  if (order < 1 || order > rank_) throw std::invalid_argument("EigensystemRealization: order outside the rank");
  const VectorXd root = singular_values_.head(order).cwiseSqrt();
  const VectorXd inverse_root = root.cwiseInverse();
  const MatrixXd transition =
      inverse_root.asDiagonal() * shifted_.topLeftCorner(order, order) * inverse_root.asDiagonal();  // (A.9)
  const Eigen::EigenSolver<MatrixXd> eigen(transition);
  Realization result;
  result.z = eigen.eigenvalues();
  const MatrixXcd vectors = eigen.eigenvectors();
  result.C = (first_rows_.leftCols(order) * root.asDiagonal()).cast<Complex>() * vectors;
  const MatrixXcd amplitudes = (root.asDiagonal() * first_columns_.topRows(order)).cast<Complex>();
  result.B = vectors.partialPivLu().solve(amplitudes);
  if (feedthrough_) result.B = result.z.cwiseInverse().asDiagonal() * result.B;  // (A.13): one sample back
  result.poles = result.z.array().log().matrix() * sample_rate_hz_;
  result.D = MatrixXd::Zero(pulse_.rows(), pulse_.cols());
  if (feedthrough_) {
    const MatrixXcd modal = result.C * result.B;
    result.D = pulse_ - modal.real();  // (A.14), with the product in the order of (A.4)
  }
  return result;
}

}  // namespace secular
