#include "measure/signal/pole_covariance.hpp"

#include <Eigen/Eigenvalues>
#include <limits>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

PoleCovariance::PoleCovariance(std::span<const Pole> of, const PoleMoments& m, const MatrixXd& amplitudes,
                               const VectorXd& noise_variance, double half)
    : variance(noise_variance), unknowns(parameter_count(of)), functions(amplitudes.rows()) {
  if (!m.usable) return;
  const PoleTurns turns(of, amplitudes);
  poles = MatrixXd::Zero(unknowns, unknowns);
  drag = MatrixXd::Zero(functions * amplitudes.cols(), unknowns);
  if (unknowns > 0) {
    const MatrixXd hessian = turns.hessian(m, variance.cwiseInverse());
    // In unit diagonal; eigenvalues at rounding level mark what is not determined.
    const VectorXd unit =
        hessian.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(
        MatrixXd(unit.asDiagonal() * hessian * unit.asDiagonal()));
    if (!(spectrum.eigenvalues().minCoeff() > 1e-13) || !hessian.allFinite()) return;
    const MatrixXd vectors = unit.asDiagonal() * spectrum.eigenvectors();
    poles = vectors * spectrum.eigenvalues().cwiseInverse().asDiagonal() * vectors.transpose() / (half * half);
    for (Index c = 0; c < amplitudes.cols(); ++c)
      drag.middleRows(c * functions, functions) = half * turns.drag(m, c);
  }
  own = m.gram.solve(MatrixXd(MatrixXd::Identity(functions, functions)));
  determined = true;
}

void PoleCovariance::move_origin(std::span<const Pole> of, const MatrixXd& amplitudes, double shift) {
  if (!determined) return;
  Index function = 0, unknown = 0;
  for (const Pole& pole : of) {
    const Index size = function_count(pole);
    const PoleMatrix turn = shift_matrix(pole, shift);
    own.middleRows(function, size) = (turn * own.middleRows(function, size)).eval();
    own.middleCols(function, size) = (own.middleCols(function, size) * turn.transpose()).eval();
    for (Index c = 0; c < amplitudes.cols(); ++c) {
      const Index row = c * functions + function;
      if (unknowns > 0) drag.middleRows(row, size) = (turn * drag.middleRows(row, size)).eval();
      // A frequency that is wrong turns the amplitudes on the way to the new origin.
      for (Index i = 0; i < parameter_count(pole); ++i)
        drag.block(row, unknown + i, size, 1) -=
            shift * (generator(pole, i) * amplitudes.block(function, c, size, 1));
    }
    function += size;
    unknown += parameter_count(pole);
  }
}

MatrixXd PoleCovariance::matrix() const {
  const Index channels = variance.size(), all = functions * channels, size = unknowns + all;
  MatrixXd covariance = MatrixXd::Zero(size, size);
  if (!determined) {
    covariance.diagonal().setConstant(std::numeric_limits<double>::infinity());
    return covariance;
  }
  // Without unknown poles there is nothing that drags the amplitudes along.
  if (unknowns > 0) {
    const MatrixXd across = -drag * poles;
    covariance.topLeftCorner(unknowns, unknowns) = poles;
    covariance.bottomLeftCorner(all, unknowns) = across;
    covariance.topRightCorner(unknowns, all) = across.transpose();
    covariance.bottomRightCorner(all, all).noalias() = -across * drag.transpose();
  }
  for (Index c = 0; c < channels; ++c) {
    const Index at = unknowns + c * functions;
    covariance.block(at, at, functions, functions) += variance(c) * own;
  }
  return covariance;
}

}  // namespace secular
