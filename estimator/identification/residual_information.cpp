#include "estimator/identification/residual_information.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <vector>

#include "estimator/thresholds.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of a change, squared, that coefficients cannot do: less is the error of a change that was found as a difference.
constexpr double no_change_share = 1e-8;

/// That tell the scatter between conditions, of which each direction takes up one.
constexpr auto& least_freedom = estimator_thresholds().fewest_freedom;

}  // namespace

ResidualInformation residual_information(const MatrixXd& change, const LinearFit& fit,
                                         std::span<const int> condition) {
  ResidualInformation evidence{MatrixXd::Zero(0, change.cols()), VectorXd::Zero(0)};
  if (change.rows() == 0 || change.cols() == 0 || fit.residual.size() != change.rows()) return evidence;
  const MatrixXd beside = change - fit.orthonormal * (fit.orthonormal.transpose() * change);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> own(MatrixXd(beside.transpose() * beside));
  std::vector<Index> seen;
  for (Index i = 0; i < own.eigenvalues().size(); ++i) {
    const double whole = (change * own.eigenvectors().col(i)).squaredNorm();
    if (own.eigenvalues()(i) > no_change_share * whole && whole > 0) seen.push_back(i);
  }
  const auto count = static_cast<Index>(seen.size());
  if (count == 0) return evidence;
  // Coordinates in which the columns beside the coefficients' are orthonormal.
  const MatrixXd map =
      own.eigenvectors()(Eigen::all, seen) * own.eigenvalues()(seen).cwiseSqrt().cwiseInverse().asDiagonal();
  const MatrixXd columns = beside * map;
  const VectorXd estimate = -columns.transpose() * fit.residual;
  const VectorXd left = fit.residual + columns * estimate;
  const auto spare = static_cast<double>(left.size() - fit.rank - count);
  if (!(spare > 0)) return evidence;
  const double variance = left.squaredNorm() / spare;
  if (!(variance > 0)) return evidence;
  std::map<int, std::vector<Index>> members;
  for (Index r = 0; r < left.size(); ++r) members[condition[static_cast<std::size_t>(r)]].push_back(r);
  const auto conditions = static_cast<Index>(members.size());
  if (static_cast<double>(conditions - count) < least_freedom) return evidence;
  // What the estimate changes by where one condition is left out, of the coefficients' regression as well.
  MatrixXd all(left.size(), fit.orthonormal.cols() + count);
  all << fit.orthonormal, columns;
  MatrixXd scatter = MatrixXd::Zero(count, count);
  for (const auto& [label, rows] : members) {
    const MatrixXd own_rows = all(rows, Eigen::all);
    const MatrixXd kept = MatrixXd::Identity(all.cols(), all.cols()) - own_rows.transpose() * own_rows;
    const VectorXd change_of_all = kept.ldlt().solve(VectorXd(own_rows.transpose() * left(rows)));
    const VectorXd moved = change_of_all.tail(count);
    if (!moved.allFinite()) return evidence;
    scatter += moved * moved.transpose();
  }
  scatter *= static_cast<double>(conditions - 1) / (static_cast<double>(conditions) * variance);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> larger(scatter);
  const MatrixXd whitening = larger.eigenvalues().cwiseMax(1.0).cwiseSqrt().cwiseInverse().asDiagonal() *
                             larger.eigenvectors().transpose() / std::sqrt(variance);
  // columns = beside*map: a step along the null space s moves them by map^+ s.
  const MatrixXd design = whitening * own.eigenvalues()(seen).cwiseSqrt().asDiagonal() *
                          own.eigenvectors()(Eigen::all, seen).transpose();
  const Eigen::JacobiSVD<MatrixXd> svd(design, Eigen::ComputeThinU | Eigen::ComputeThinV);
  // Combinations that the rows know better than what is plausible of them, a standard deviation of one.
  std::vector<Index> sharp;
  for (Index i = 0; i < svd.singularValues().size(); ++i)
    if (svd.singularValues()(i) > 1) sharp.push_back(i);
  evidence.design = svd.singularValues()(sharp).asDiagonal() * svd.matrixV()(Eigen::all, sharp).transpose();
  evidence.target = svd.matrixU()(Eigen::all, sharp).transpose() * (whitening * estimate);
  return evidence;
}

}  // namespace secular
