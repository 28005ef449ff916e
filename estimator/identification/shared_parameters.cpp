#include "estimator/identification/shared_parameters.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "estimator/regression/nonlinear_fit.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

}  // namespace

SharedParameters shared_parameters(std::span<const LumpEstimates> cases, const VectorXd& start,
                                   const std::vector<bool>& given) {
  const Index count = start.size();
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
  if (rows == 0) return result;
  const ResidualFunction function = [&](const VectorXd& parameters, VectorXd& residual, MatrixXd& jacobian) {
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
      const VectorXd difference = part.combination * single - part.values;
      MatrixXd slope = part.combination * single_slope;
      for (Index p = 0; p < count; ++p)
        if (given[static_cast<std::size_t>(p)]) slope.col(p).setZero();
      residual.segment(r, size) = whitening[c](difference);
      jacobian.middleRows(r, size) = whitening[c](slope);
      r += size;
    }
  };
  const FitReport report = nonlinear_fit(function, rows, start);
  result.values = report.parameters;
  result.misfit = 2 * report.cost;
  VectorXd residual(rows);
  MatrixXd jacobian(rows, count);
  function(result.values, residual, jacobian);
  // d values / d lumps = pinv(W J) W, by cases, in columns of unit norm.
  VectorXd scale = jacobian.colwise().norm().transpose();
  for (Index p = 0; p < count; ++p) scale(p) = scale(p) > 0 ? 1 / scale(p) : 1;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(1e-9);
  solver.compute(jacobian * scale.asDiagonal());
  result.surplus = rows - solver.rank();
  const MatrixXd inverse = scale.asDiagonal() * solver.pseudoInverse();
  Index r = 0;
  MatrixXd variance_by_case = MatrixXd::Zero(count, static_cast<Index>(cases.size()));
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const LumpEstimates& part = cases[c];
    const Index size = part.values.size();
    if (size == 0) continue;
    result.slope[c] = inverse.middleCols(r, size) * whitening[c](MatrixXd::Identity(size, size));
    r += size;
    const MatrixXd plain = result.slope[c] * part.plain * result.slope[c].transpose();
    result.plain_covariance += plain;
    MatrixXd covariance = plain;
    if (part.clustered) {
      const auto n = static_cast<double>(part.influence.rows());
      const MatrixXd moved = part.influence * result.slope[c].transpose();
      covariance = (n - 1) / n * moved.transpose() * moved;
    }
    result.covariance += covariance;
    variance_by_case.col(static_cast<Index>(c)) = covariance.diagonal();
  }
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
