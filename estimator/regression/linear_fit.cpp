#include "estimator/regression/linear_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "estimator/regression/cluster_jackknife.hpp"
#include "estimator/regression/scaled_decomposition.hpp"
#include "estimator/thresholds.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Clusters with fewer, their number less one, say too little of their scatter.
constexpr auto& fewest_freedom = estimator_thresholds().fewest_freedom;

/// What errors of the columns leave of a clear direction, at least: none with less than noise_ratio times what they
/// give, or half of that where it was clear before, is one.
double smallest_signal() {
  return 1 - 2 / estimator_thresholds().noise_ratio;
}

/// Of a variance: it rests mainly on what has more.
constexpr auto& shared_variance = estimator_thresholds().shared_variance;

/// Rows that one thread takes at a time.
constexpr Index chunk = 1024;

void check_sizes(const Eigen::Ref<const MatrixXd>& design, const Eigen::Ref<const VectorXd>& response,
                 std::span<const int> cluster) {
  if (response.size() != design.rows() || static_cast<Index>(cluster.size()) != design.rows())
    throw std::invalid_argument("rows of design, response and clusters differ");
  if (design.rows() == 0 || design.cols() == 0) throw std::invalid_argument("a regression without rows or columns");
}

// By direction: squared singular value over what the errors of the columns alone give.
VectorXd signal_to_errors(const MatrixXd& basis, const MatrixXd& gram) {
  VectorXd signal = VectorXd::Constant(basis.cols(), std::numeric_limits<double>::infinity());
  if (gram.size() > 0)
    for (Index i = 0; i < basis.cols(); ++i) signal(i) = 1 / basis.col(i).dot(gram * basis.col(i));
  return signal;
}

Index count_of_noisy(const VectorXd& signal, std::optional<Index> before) {
  const auto at_most = [&](double ratio) { return (signal.array() <= ratio).count(); };
  if (!before) return at_most(estimator_thresholds().noise_ratio);
  return std::clamp(*before, at_most(0.5 * estimator_thresholds().noise_ratio),
                    at_most(2 * estimator_thresholds().noise_ratio));
}

/// Directions in which the columns differ by their own errors, and the others; rising.
struct Directions {
  std::vector<Index> noisy, clear;
};

Directions by_signal(const VectorXd& signal, std::optional<Index> noisy_before) {
  std::vector<Index> order(static_cast<std::size_t>(signal.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return signal(a) < signal(b); });
  const auto border = order.begin() + count_of_noisy(signal, noisy_before);
  Directions directions{{order.begin(), border}, {border, order.end()}};
  std::sort(directions.noisy.begin(), directions.noisy.end());
  std::sort(directions.clear.begin(), directions.clear.end());
  return directions;
}

/// Coordinates in the basis of a fit, without the attenuation that errors of the columns make.
struct Coordinates {
  VectorXd value, correction;
  MatrixXd spread;  // columns x rank: what one unit of each coordinate's error does to the coefficients
};

// docs/inference.md (5): (I - B'GB) c = B'y - B'(g - G N n) in the clear directions B, n the coordinates in the
// noisy ones N, G and g the errors' products. Fills in the fit's bias and what is kept of its Gram matrix.
Coordinates without_attenuation(const VectorXd& seen, const Directions& directions, const ColumnErrors& errors,
                                LinearFit& fit) {
  const std::vector<Index>& clear = directions.clear;
  Coordinates result{seen, VectorXd(), fit.basis};
  fit.bias = VectorXd::Zero(fit.basis.rows());
  fit.kept = MatrixXd::Identity(fit.rank, fit.rank);
  if (errors.with_response.size() > 0 && !clear.empty()) {
    const MatrixXd basis = fit.basis(Eigen::all, clear);
    const VectorXd left =
        errors.with_response - errors.gram * (fit.basis(Eigen::all, directions.noisy) * seen(directions.noisy));
    const auto count = static_cast<Index>(clear.size());
    const Eigen::LDLT<MatrixXd> kept(
        MatrixXd(MatrixXd::Identity(count, count) - basis.transpose() * errors.gram * basis));
    if (kept.isPositive() && kept.vectorD().minCoeff() > smallest_signal()) {
      const VectorXd corrected = kept.solve(VectorXd(seen(clear) - basis.transpose() * left));
      fit.bias = basis * (seen(clear) - corrected);
      result.value(clear) = corrected;
      result.spread(Eigen::all, clear) = kept.solve(MatrixXd(basis.transpose())).transpose();
      fit.kept(clear, clear) = kept.reconstructedMatrix();
    }
  }
  result.correction = result.value - seen;
  return result;
}

MatrixXd orthonormal_columns(const Eigen::Ref<const MatrixXd>& design, const MatrixXd& basis, unsigned threads) {
  const Index rows = design.rows();
  MatrixXd orthonormal(rows, basis.cols());
  const auto chunks = static_cast<std::size_t>((rows + chunk - 1) / chunk);
  in_parallel(chunks, threads, [&](std::size_t c) {
    const Index begin = static_cast<Index>(c) * chunk, count = std::min(chunk, rows - begin);
    orthonormal.middleRows(begin, count).noalias() = design.middleRows(begin, count) * basis;
  });
  return orthonormal;
}

// Collinearity of the scaled columns: what their singular values say by themselves.
void note_collinearity(const ScaledDecomposition& columns, LinearFit& fit) {
  const Index count = columns.scale.size();
  const MatrixXd& v = columns.seen;
  const VectorXd& inverse = columns.inverse;
  fit.condition_indices = VectorXd::Constant(count, std::numeric_limits<double>::infinity());
  for (Index i = 0; i < fit.rank; ++i) fit.condition_indices(i) = columns.largest * inverse(i);
  const MatrixXd normal_inverse = v * inverse.cwiseAbs2().asDiagonal() * v.transpose();
  fit.variance_inflation = normal_inverse.diagonal();
  fit.variance_proportions = MatrixXd::Zero(count, count);
  for (Index i = 0; i < fit.rank; ++i)
    for (Index c = 0; c < count; ++c)
      if (normal_inverse(c, c) > 0)
        fit.variance_proportions(i, c) = v(c, i) * v(c, i) * inverse(i) * inverse(i) / normal_inverse(c, c);
}

// A column is identifiable if no null direction of the scaled columns has a part in it.
void note_null_space(const MatrixXd& null, LinearFit& fit) {
  const Index columns = null.rows();
  fit.lost = null;
  fit.identifiable.assign(static_cast<std::size_t>(columns), true);
  fit.entangled_with.resize(static_cast<std::size_t>(columns));
  const MatrixXd projection = null * null.transpose();
  for (Index c = 0; c < columns; ++c) {
    if (projection(c, c) < 1e-10) continue;
    fit.identifiable[static_cast<std::size_t>(c)] = false;
    for (Index other = 0; other < columns; ++other)
      if (other != c && std::abs(projection(c, other)) > 1e-8)
        fit.entangled_with[static_cast<std::size_t>(c)].push_back(static_cast<int>(other));
  }
}

// What mainly rests on directions that are made of errors is not identifiable either.
void note_noisy(const std::vector<Index>& noisy, const MatrixXd& seen, LinearFit& fit) {
  fit.noisy = static_cast<Index>(noisy.size());
  if (noisy.empty()) return;
  const Index columns = seen.rows(), null = fit.lost.cols();
  VectorXd share = VectorXd::Zero(columns);
  for (const Index i : noisy) share += fit.variance_proportions.row(i).transpose();
  if ((share.array() > shared_variance).any()) {
    fit.lost.conservativeResize(columns, null + fit.noisy);
    fit.lost.rightCols(fit.noisy) = seen(Eigen::all, noisy);
  }
  for (Index c = 0; c < columns; ++c)
    for (Index other = 0; other < columns && share(c) > shared_variance; ++other) {
      fit.identifiable[static_cast<std::size_t>(c)] = false;
      if (other != c && share(other) > shared_variance)
        fit.entangled_with[static_cast<std::size_t>(c)].push_back(static_cast<int>(other));
    }
}

// docs/inference.md (6): the jackknife's where there are clusters enough, the plain one elsewhere.
void note_covariance(ClusterJackknife jackknife, const MatrixXd& spread, LinearFit& fit) {
  const Index rows = fit.residual.size(), groups = static_cast<Index>(jackknife.labels.size());
  fit.plain_covariance = fit.residual_sd * fit.residual_sd * (spread * spread.transpose());
  const bool clustered = static_cast<double>(groups) - 1 >= fewest_freedom && rows > fit.rank && fit.rank > 0 &&
                         !jackknife.one_determines_a_direction;
  if (clustered) {
    fit.covariance = jackknife.covariance();
    fit.covariance_kind = CovarianceKind::clustered;
    fit.degrees_of_freedom = static_cast<double>(groups) - 1;
  } else {
    fit.covariance = fit.plain_covariance;
    fit.degrees_of_freedom = static_cast<double>(std::max<Index>(1, rows - fit.rank));
  }
  fit.cluster_gram = std::move(jackknife.gram);
  fit.cluster_score = std::move(jackknife.score);
  fit.influence = std::move(jackknife.influence);
  fit.cluster_labels = std::move(jackknife.labels);
}

}  // namespace

LinearFit linear_fit(const Eigen::Ref<const MatrixXd>& design, const Eigen::Ref<const VectorXd>& response,
                     std::span<const int> cluster, const ColumnErrors& errors, const LinearFitOptions& options) {
  check_sizes(design, response, cluster);
  const Index rows = design.rows();
  ScaledDecomposition columns = scaled_decomposition(design, response, options.tolerance, options.threads);
  LinearFit fit;
  fit.rank = columns.rank();
  fit.scale = columns.scale;
  fit.basis = columns.scale.asDiagonal() * columns.seen * columns.inverse.asDiagonal();
  const Directions directions = by_signal(signal_to_errors(fit.basis, errors.gram), options.noisy_before);
  const Coordinates coordinates = without_attenuation(columns.coordinates, directions, errors, fit);
  fit.coefficients = fit.basis * coordinates.value;
  fit.residual = response - design * fit.coefficients;
  fit.orthonormal =
      columns.left.size() > 0 ? std::move(columns.left) : orthonormal_columns(design, fit.basis, options.threads);
  fit.leverage = fit.orthonormal.rowwise().squaredNorm();
  fit.residual_sd = rows > fit.rank ? std::sqrt(fit.residual.squaredNorm() / static_cast<double>(rows - fit.rank))
                                    : std::numeric_limits<double>::quiet_NaN();
  note_collinearity(columns, fit);
  note_null_space(columns.null, fit);
  note_noisy(directions.noisy, columns.seen, fit);
  note_covariance(cluster_jackknife({fit.orthonormal, fit.residual, coordinates.spread, coordinates.correction},
                                    cluster, options.threads),
                  coordinates.spread, fit);
  return fit;
}

}  // namespace secular
