#include "estimator/identification/shared_parameters.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "estimator/regression/clustered_chi_squared.hpp"
#include "estimator/regression/nonlinear_fit.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Singular values of scaled columns below this share of the largest are none; parts of directions, squared, below
/// the other belong to nothing.
constexpr double lost_direction = 1e-9, part_of_group = 1e-8;

// Whitening of one case's lumps through scaled variables: they differ by many powers of ten.
struct Whitening {
  VectorXd inverse_sd;
  Eigen::LLT<MatrixXd> cholesky;

  explicit Whitening(const MatrixXd& covariance) {
    const VectorXd sd = covariance.diagonal().cwiseSqrt().cwiseMax(std::numeric_limits<double>::min());
    inverse_sd = sd.cwiseInverse();
    const MatrixXd correlation = inverse_sd.asDiagonal() * covariance * inverse_sd.asDiagonal();
    cholesky.compute(correlation + 1e-12 * MatrixXd::Identity(sd.size(), sd.size()));
  }
  MatrixXd operator()(MatrixXd m) const {
    m = inverse_sd.asDiagonal() * m;
    cholesky.matrixL().solveInPlace(m);
    return m;
  }
};

// See SharedParameters::unseen, of the whitened Jacobian. In columns of unit norm entangled parameters do the same
// for the same size.
MatrixXd unseen_directions(const MatrixXd& jacobian, const VectorXd& scale, const VectorXd& values,
                           const VectorXd& plausible_size) {
  std::vector<Index> seen;
  for (Index p = 0; p < jacobian.cols(); ++p)
    if (jacobian.col(p).squaredNorm() > 0) seen.push_back(p);
  const MatrixXd columns = jacobian(Eigen::all, seen) * scale(seen).asDiagonal();
  const VectorXd sizes = values(seen).cwiseQuotient(scale(seen)), plausible_sizes = plausible_size(seen);
  const auto width = static_cast<Index>(seen.size());
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  const MatrixXd triangle = qr.matrixQR().topRows(std::min(columns.rows(), width)).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<MatrixXd> svd(triangle * qr.colsPermutation().transpose(), Eigen::ComputeFullV);
  std::vector<Index> lost;
  for (Index k = 0; k < width; ++k) {
    const double singular = k < svd.singularValues().size() ? svd.singularValues()(k) : 0;
    if (singular <= lost_direction * svd.singularValues()(0) ||
        !is_informed(svd.matrixV().col(k), singular, scale(seen), plausible_sizes))
      lost.push_back(k);
  }
  const MatrixXd null = svd.matrixV()(Eigen::all, lost);
  const MatrixXd projection = null * null.transpose();
  MatrixXd result(jacobian.cols(), null.cols());
  Index found = 0;
  std::vector<bool> done(seen.size(), false);
  for (Index first = 0; first < width; ++first) {
    if (done[static_cast<std::size_t>(first)] || projection(first, first) < part_of_group) continue;
    // Everything that is entangled with it.
    std::vector<Index> group{first};
    done[static_cast<std::size_t>(first)] = true;
    for (std::size_t at = 0; at < group.size(); ++at)
      for (Index other = 0; other < width; ++other)
        if (!done[static_cast<std::size_t>(other)] && std::abs(projection(group[at], other)) > part_of_group) {
          done[static_cast<std::size_t>(other)] = true;
          group.push_back(other);
        }
    // If each of n alone were as likely to be the whole effect e, shares e/n would have the covariance e^2/n
    // orthogonal to their sum.
    const double effect = (columns(Eigen::all, group) * sizes(group)).norm();
    const double plausible = effect / std::sqrt(static_cast<double>(group.size()));
    const Eigen::SelfAdjointEigenSolver<MatrixXd> own(MatrixXd(projection(group, group)));
    for (Index i = 0; i < own.eigenvalues().size() && found < result.cols(); ++i) {
      if (own.eigenvalues()(i) < 0.5) continue;
      result.col(found).setZero();
      for (std::size_t g = 0; g < group.size(); ++g)
        result(seen[static_cast<std::size_t>(group[g])], found) = plausible *
                                                                  own.eigenvectors()(static_cast<Index>(g), i) *
                                                                  scale(seen[static_cast<std::size_t>(group[g])]);
      ++found;
    }
  }
  return result.leftCols(found);
}

// By unknown: the size with which it alone would make as much as is seen of all the lumps that it is part of,
// at `parameters`. Infinite where it is part of none.
VectorXd plausible_sizes(std::span<const LumpEstimates> cases, const VectorXd& parameters, Index unknowns) {
  VectorXd seen = VectorXd::Zero(unknowns), made = VectorXd::Zero(unknowns);
  for (const LumpEstimates& part : cases) {
    const std::size_t lump_count = part.resonance->lumps.size();
    const auto count = static_cast<std::size_t>(parameters.size());
    std::vector<double> slope(lump_count * count);
    if (lump_count > 0) part.resonance->evaluate_lumps_jacobian(parameters.data(), slope.data());
    for (std::size_t i = 0; i < part.index.size(); ++i) {
      if (part.index[i] < 0) continue;
      // What was estimated of this lump: itself, or combinations with others.
      for (Index v = 0; v < part.values.size(); ++v) {
        const double share = part.combination(v, static_cast<Index>(i)), sd = std::sqrt(part.plain(v, v));
        if (share == 0 || !(sd > 0)) continue;
        for (std::size_t p = 0; p < count; ++p) {
          const double d = share * slope[static_cast<std::size_t>(part.index[i]) * count + p];
          if (d == 0) continue;
          seen(static_cast<Index>(p)) += std::pow(part.values(v) / sd, 2);
          made(static_cast<Index>(p)) += std::pow(d / sd, 2);
        }
      }
    }
  }
  VectorXd sizes = VectorXd::Constant(unknowns, std::numeric_limits<double>::infinity());
  for (Index p = 0; p < unknowns; ++p)
    if (made(p) > 0) sizes(p) = std::sqrt(seen(p) / made(p));
  return sizes;
}

// LumpEstimates::truncation_slope of all cases, whitened, in the rows and unknowns of the fit.
MatrixXd truncation_slopes(std::span<const LumpEstimates> cases, const std::vector<Whitening>& whitening,
                           Index rows, Index unknowns) {
  MatrixXd slopes = MatrixXd::Zero(rows, unknowns);
  Index r = 0;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Index size = cases[c].values.size();
    if (size > 0 && cases[c].truncation_slope.cols() > 0)
      slopes.block(r, 0, size, cases[c].truncation_slope.cols()) = whitening[c](cases[c].truncation_slope);
    r += size;
  }
  return slopes;
}

}  // namespace

SharedParameters shared_parameters(std::span<const LumpEstimates> cases, const VectorXd& start,
                                   const std::vector<bool>& given) {
  const Index count = start.size();
  Index directions = 0;
  for (const LumpEstimates& part : cases) directions = std::max(directions, part.truncation_effect.cols());
  SharedParameters result;
  result.values = start;
  result.covariance = result.plain_covariance = MatrixXd::Zero(count, count);
  result.degrees_of_freedom = VectorXd::Constant(count, std::numeric_limits<double>::infinity());
  Index rows = 0;
  std::vector<Whitening> whitening;
  for (const LumpEstimates& part : cases) {
    rows += part.values.size();
    whitening.emplace_back(part.plain);
  }
  result.slope.assign(cases.size(), MatrixXd());
  result.shift_slope.assign(cases.size(), MatrixXd());
  result.shift = VectorXd::Zero(directions);
  result.shift_prior = MatrixXd::Identity(directions, directions);
  result.unseen = MatrixXd::Zero(count, 0);
  if (rows == 0) return result;
  // Unknowns: parameters, then shifts; after the lumps' rows those of the shifts' own size.
  const ResidualFunction function = [&](const VectorXd& unknowns, VectorXd& residual, MatrixXd& jacobian) {
    const VectorXd parameters = unknowns.head(count), shift = unknowns.tail(directions);
    Index r = 0;
    for (std::size_t c = 0; c < cases.size(); ++c) {
      const LumpEstimates& part = cases[c];
      const auto lump_count = static_cast<Index>(part.resonance->lumps.size());
      VectorXd lumps(lump_count);
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> lump_slope(lump_count, count);
      if (lump_count > 0) {
        part.resonance->evaluate_lumps(parameters.data(), lumps.data());
        part.resonance->evaluate_lumps_jacobian(parameters.data(), lump_slope.data());
      }
      const Index size = part.values.size();
      if (size == 0) continue;
      const auto entries = static_cast<Index>(part.index.size());
      VectorXd single(entries);
      MatrixXd single_slope = MatrixXd::Zero(entries, count);
      for (Index i = 0; i < entries; ++i) {
        const int index = part.index[static_cast<std::size_t>(i)];
        if (index < 0) {
          single(i) = parameters(-1 - index);
          single_slope(i, -1 - index) = 1;
        } else {
          single(i) = lumps(index);
          single_slope.row(i) = lump_slope.row(index);
        }
      }
      VectorXd difference = part.combination * single - part.values;
      MatrixXd slope = MatrixXd::Zero(size, count + directions);
      slope.leftCols(count) = part.combination * single_slope;
      for (Index p = 0; p < count; ++p)
        if (given[static_cast<std::size_t>(p)]) slope.col(p).setZero();
      if (part.truncation_effect.cols() > 0) {
        difference -= part.truncation_effect * shift;
        slope.rightCols(directions) = -part.truncation_effect;
      }
      residual.segment(r, size) = whitening[c](difference);
      jacobian.middleRows(r, size) = whitening[c](slope);
      r += size;
    }
    residual.tail(directions) = shift;
    jacobian.bottomRows(directions).setZero();
    jacobian.bottomRightCorner(directions, directions).setIdentity();
  };
  const Index all_rows = rows + directions, unknowns = count + directions;
  VectorXd from(unknowns);
  from << start, VectorXd::Zero(directions);
  const VectorXd plausible = plausible_sizes(cases, start, unknowns);
  const FitReport report = nonlinear_fit(function, all_rows, from, 100, plausible);
  result.values = report.parameters.head(count);
  result.shift = report.parameters.tail(directions);
  VectorXd residual(all_rows);
  MatrixXd jacobian(all_rows, unknowns);
  function(report.parameters, residual, jacobian);
  // d values / d lumps = pinv(W J) W, by cases, in columns of unit norm.
  VectorXd scale = jacobian.colwise().norm().transpose();
  for (Index p = 0; p < unknowns; ++p) scale(p) = scale(p) > 0 ? 1 / scale(p) : 1;
  result.unseen = unseen_directions(jacobian.topLeftCorner(rows, count), scale.head(count), result.values,
                                    plausible.head(count));
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(1e-9);
  solver.compute(jacobian * scale.asDiagonal());
  const MatrixXd direct = scale.asDiagonal() * solver.pseudoInverse();
  // Lumps were estimated with the truncation taken out at these very values: values p and lumps l settle together,
  // p = S (l + N p), so that a change dl of the lumps by noise moves values by (1 - S N)^-1 S dl.
  const MatrixXd by_values = truncation_slopes(cases, whitening, all_rows, unknowns);
  const MatrixXd inverse =
      (MatrixXd::Identity(unknowns, unknowns) - direct * by_values).partialPivLu().solve(direct);
  // What the fit leaves of a change of the lumps.
  const MatrixXd left = MatrixXd::Identity(all_rows, all_rows) - (jacobian - by_values) * inverse;
  ResidualScatter scatter;
  scatter.known = left.rightCols(directions);
  Index r = 0;
  MatrixXd variance_by_case = MatrixXd::Zero(count, static_cast<Index>(cases.size()));
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const LumpEstimates& part = cases[c];
    const Index size = part.values.size();
    if (size == 0) continue;
    const MatrixXd slope = inverse.middleCols(r, size) * whitening[c](MatrixXd::Identity(size, size));
    result.slope[c] = slope.topRows(count);
    result.shift_slope[c] = slope.bottomRows(directions);
    r += size;
    const MatrixXd plain = result.slope[c] * part.plain * result.slope[c].transpose();
    result.plain_covariance += plain;
    MatrixXd covariance = plain;
    if (!part.clustered) {
      scatter.known.conservativeResize(Eigen::NoChange, scatter.known.cols() + size);
      scatter.known.rightCols(size) = left.middleCols(r - size, size);
    } else {
      scatter.influence.push_back(whitening[c](part.influence.transpose()).transpose() *
                                  left.middleCols(r - size, size).transpose());
      const auto n = static_cast<double>(part.influence.rows());
      const MatrixXd moved = part.influence * result.slope[c].transpose();
      covariance = (n - 1) / n * moved.transpose() * moved;
    }
    result.covariance += covariance;
    variance_by_case.col(static_cast<Index>(c)) = covariance.diagonal();
  }
  result.surplus = all_rows - solver.rank();
  result.misfit = clustered_chi_squared(residual, result.surplus, scatter);
  const MatrixXd of_shift =
      inverse.block(0, r, count, directions) * inverse.block(0, r, count, directions).transpose();
  result.covariance += of_shift;
  result.plain_covariance += of_shift;
  result.shift_prior = inverse.block(count, r, directions, directions);
  for (Index p = 0; p < count; ++p) {
    double denominator = 0;
    for (std::size_t c = 0; c < cases.size(); ++c) {
      const double v = variance_by_case(p, static_cast<Index>(c));
      if (v > 0) denominator += v * v / cases[c].degrees_of_freedom;
    }
    const double total = result.covariance(p, p);
    if (denominator > 0) result.degrees_of_freedom(p) = total * total / denominator;
  }
  return result;
}

}  // namespace secular
