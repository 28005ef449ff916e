#include "estimator/regression/linear_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "estimator/regression/condensed_rows.hpp"
#include "numerics/in_parallel.hpp"
#include "numerics/unit_scale.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Fewer clusters say too little of their scatter.
constexpr Index fewest_clusters = 5;

/// Of a direction, at least, next to the errors of the columns.
constexpr double smallest_signal = 0.5;

/// Rows that one thread takes at a time.
constexpr Index chunk = 1024;

/// A cluster that alone determines a direction leaves nothing to compare it with.
constexpr double largest_leverage = 0.999;

// By direction: squared singular value over what the errors of the columns alone give.
VectorXd signal_to_errors(const MatrixXd& basis, const MatrixXd& gram) {
  VectorXd signal = VectorXd::Constant(basis.cols(), std::numeric_limits<double>::infinity());
  if (gram.size() > 0)
    for (Index i = 0; i < basis.cols(); ++i) signal(i) = 1 / basis.col(i).dot(gram * basis.col(i));
  return signal;
}

Index count_of_noisy(const VectorXd& signal, std::optional<Index> before) {
  const auto at_most = [&](double ratio) { return (signal.array() <= ratio).count(); };
  if (!before) return at_most(noise_ratio);
  return std::clamp(*before, at_most(0.5 * noise_ratio), at_most(2 * noise_ratio));
}

}  // namespace

LinearFit linear_fit(const Eigen::Ref<const MatrixXd>& design, const Eigen::Ref<const VectorXd>& response,
                     std::span<const int> cluster, double tolerance, const ColumnErrors& errors,
                     std::optional<Index> noisy_before, unsigned threads) {
  const Index rows = design.rows(), columns = design.cols();
  if (response.size() != rows || static_cast<Index>(cluster.size()) != rows)
    throw std::invalid_argument("rows of design, response and clusters differ");
  if (rows == 0 || columns == 0) throw std::invalid_argument("a regression without rows or columns");
  LinearFit fit;
  const VectorXd scale = unit_scale(design);
  // Many rows are condensed first.
  const bool tall = rows > 2 * columns;
  MatrixXd core;
  VectorXd target = response;
  if (tall) {
    const CondensedRows condensed = condensed_rows(design, response, threads);
    core = condensed.design.topRows(columns) * scale.asDiagonal();
    target = condensed.response.head(columns);
  } else {
    core = design * scale.asDiagonal();
  }
  const Eigen::BDCSVD<MatrixXd> svd(core, Eigen::ComputeThinU | Eigen::ComputeFullV);
  const VectorXd singular = svd.singularValues();
  const double cut = tolerance * std::max(singular(0), std::numeric_limits<double>::min());
  std::vector<Index> seen, unseen;
  for (Index i = 0; i < columns; ++i) {
    (i < singular.size() && singular(i) > cut ? seen : unseen).push_back(i);
  }
  fit.rank = static_cast<Index>(seen.size());
  fit.scale = scale;
  const Index rank = fit.rank;
  MatrixXd u(core.rows(), rank), v(columns, rank), null(columns, columns - rank);
  VectorXd inverse(rank);
  for (Index i = 0; i < rank; ++i) {
    const Index from = seen[static_cast<std::size_t>(i)];
    u.col(i) = svd.matrixU().col(from);
    v.col(i) = svd.matrixV().col(from);
    inverse(i) = 1 / singular(from);
  }
  for (Index i = 0; i < null.cols(); ++i) null.col(i) = svd.matrixV().col(unseen[static_cast<std::size_t>(i)]);
  VectorXd coordinates = u.transpose() * target;
  fit.basis = scale.asDiagonal() * v * inverse.asDiagonal();
  // Directions in which the columns differ by their own errors.
  std::vector<Index> noisy, clear;
  const VectorXd signal = signal_to_errors(fit.basis, errors.gram);
  fit.noisy = count_of_noisy(signal, noisy_before);
  std::vector<Index> by_signal(static_cast<std::size_t>(rank));
  std::iota(by_signal.begin(), by_signal.end(), Index{0});
  std::stable_sort(by_signal.begin(), by_signal.end(), [&](Index a, Index b) { return signal(a) < signal(b); });
  noisy.assign(by_signal.begin(), by_signal.begin() + fit.noisy);
  clear.assign(by_signal.begin() + fit.noisy, by_signal.end());
  std::sort(noisy.begin(), noisy.end());
  std::sort(clear.begin(), clear.end());
  MatrixXd spread = fit.basis;  // what one unit of each coordinate's error does to the coefficients
  fit.bias = VectorXd::Zero(columns);
  fit.kept = MatrixXd::Identity(rank, rank);
  const VectorXd uncorrected = coordinates;
  if (errors.with_response.size() > 0 && !clear.empty()) {
    const MatrixXd basis = fit.basis(Eigen::all, clear);
    const VectorXd left = errors.with_response - errors.gram * (fit.basis(Eigen::all, noisy) * coordinates(noisy));
    const auto count = static_cast<Index>(clear.size());
    const Eigen::LDLT<MatrixXd> kept(MatrixXd::Identity(count, count) - basis.transpose() * errors.gram * basis);
    if (kept.isPositive() && kept.vectorD().minCoeff() > smallest_signal) {
      const VectorXd corrected = kept.solve(coordinates(clear) - basis.transpose() * left);
      fit.bias = basis * (coordinates(clear) - corrected);
      coordinates(clear) = corrected;
      spread(Eigen::all, clear) = kept.solve(basis.transpose()).transpose();
      fit.kept(clear, clear) = kept.reconstructedMatrix();
    }
  }
  fit.coefficients = fit.basis * coordinates;
  fit.residual = response - design * fit.coefficients;
  if (tall) {
    fit.orthonormal.resize(rows, rank);
    const auto chunks = static_cast<std::size_t>((rows + chunk - 1) / chunk);
    in_parallel(chunks, threads, [&](std::size_t c) {
      const Index begin = static_cast<Index>(c) * chunk, count = std::min(chunk, rows - begin);
      fit.orthonormal.middleRows(begin, count).noalias() = design.middleRows(begin, count) * fit.basis;
    });
  } else {
    fit.orthonormal = std::move(u);
  }
  fit.leverage = fit.orthonormal.rowwise().squaredNorm();
  fit.residual_sd = rows > rank ? std::sqrt(fit.residual.squaredNorm() / static_cast<double>(rows - rank))
                                : std::numeric_limits<double>::quiet_NaN();
  fit.condition_indices = VectorXd::Constant(columns, std::numeric_limits<double>::infinity());
  for (Index i = 0; i < rank; ++i) fit.condition_indices(i) = singular(0) * inverse(i);

  // A column is identifiable if no null direction of the scaled columns has a part in it.
  fit.identifiable.assign(static_cast<std::size_t>(columns), true);
  fit.entangled_with.resize(static_cast<std::size_t>(columns));
  const MatrixXd null_projection = null * null.transpose();
  for (Index c = 0; c < columns; ++c) {
    if (null_projection(c, c) < 1e-10) continue;
    fit.identifiable[static_cast<std::size_t>(c)] = false;
    for (Index other = 0; other < columns; ++other)
      if (other != c && std::abs(null_projection(c, other)) > 1e-8)
        fit.entangled_with[static_cast<std::size_t>(c)].push_back(static_cast<int>(other));
  }

  const MatrixXd normal_inverse = v * inverse.cwiseAbs2().asDiagonal() * v.transpose();  // of scaled columns
  fit.variance_inflation = normal_inverse.diagonal();
  fit.plain_covariance = fit.residual_sd * fit.residual_sd * (spread * spread.transpose());
  fit.variance_proportions = MatrixXd::Zero(columns, columns);
  for (Index i = 0; i < rank; ++i)
    for (Index c = 0; c < columns; ++c)
      if (normal_inverse(c, c) > 0)
        fit.variance_proportions(i, c) = v(c, i) * v(c, i) * inverse(i) * inverse(i) / normal_inverse(c, c);

  // What mainly rests on directions that are made of errors is not identifiable either.
  fit.lost = null;
  if (!noisy.empty()) {
    VectorXd share = VectorXd::Zero(columns);
    for (const Index i : noisy) share += fit.variance_proportions.row(i).transpose();
    if ((share.array() > 0.5).any()) {
      fit.lost.conservativeResize(columns, null.cols() + static_cast<Index>(noisy.size()));
      for (std::size_t i = 0; i < noisy.size(); ++i)
        fit.lost.col(null.cols() + static_cast<Index>(i)) = v.col(noisy[i]);
    }
    for (Index c = 0; c < columns; ++c)
      for (Index other = 0; other < columns && share(c) > 0.5; ++other) {
        fit.identifiable[static_cast<std::size_t>(c)] = false;
        if (other != c && share(other) > 0.5)
          fit.entangled_with[static_cast<std::size_t>(c)].push_back(static_cast<int>(other));
      }
  }

  std::map<int, std::vector<Index>> by_label;
  for (Index r = 0; r < rows; ++r) by_label[cluster[static_cast<std::size_t>(r)]].push_back(r);
  std::vector<std::vector<Index>> members;
  for (auto& [label, group] : by_label) {
    fit.cluster_labels.push_back(label);
    members.push_back(std::move(group));
  }
  const auto groups = static_cast<Index>(members.size());
  fit.influence = MatrixXd::Zero(groups, columns);
  fit.cluster_gram.resize(members.size());
  fit.cluster_score.resize(members.size());
  std::vector<char> determines_alone(members.size(), 0);
  in_parallel(members.size(), threads, [&](std::size_t g) {
    const MatrixXd basis = fit.orthonormal(members[g], Eigen::all);
    // Leaving rows out changes the coordinates in u by -(I - U_g' U_g)^-1 U_g' e_g.
    const MatrixXd gram = basis.transpose() * basis, kept = MatrixXd::Identity(rank, rank) - gram;
    const Eigen::LDLT<MatrixXd> solver(kept);
    determines_alone[g] = solver.vectorD().minCoeff() < 1 - largest_leverage;
    const VectorXd score = basis.transpose() * fit.residual(members[g]);
    fit.influence.row(static_cast<Index>(g)) = -(spread * solver.solve(score)).transpose();
    // With its part of what errors of the columns did, by the weight of its rows.
    fit.cluster_score[g] = score + gram * (coordinates - uncorrected);
    fit.cluster_gram[g] = gram;
  });
  const bool clustered = groups >= fewest_clusters && rows > rank && rank > 0 &&
                         std::count(determines_alone.begin(), determines_alone.end(), 1) == 0;
  if (clustered) {
    const auto n = static_cast<double>(groups);
    fit.covariance = (n - 1) / n * fit.influence.transpose() * fit.influence;
    fit.covariance_kind = CovarianceKind::clustered;
    fit.degrees_of_freedom = n - 1;
  } else {
    fit.covariance = fit.plain_covariance;
    fit.degrees_of_freedom = static_cast<double>(std::max<Index>(1, rows - rank));
  }
  return fit;
}

}  // namespace secular
