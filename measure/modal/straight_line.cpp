#include "measure/modal/straight_line.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "estimator/regression/linear_fit.hpp"
#include "numerics/confidence.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Powers of x up to `degree`, x in units of its largest value.
MatrixXd powers(const VectorXd& x, double unit, Index degree) {
  MatrixXd design = MatrixXd::Ones(x.size(), degree + 1);
  for (Index k = 1; k <= degree; ++k) design.col(k) = design.col(k - 1).cwiseProduct(x) / unit;
  return design;
}

double entry(const Banded& covariance, std::size_t i, std::size_t back) {
  return back < covariance[i].size() ? covariance[i][back] : 0;
}

// L^-1 columns for own + variance * excess = L L^T, which has the band of the two.
MatrixXd whitened(const MatrixXd& columns, const Banded& own, const Banded& excess, double variance) {
  const std::size_t n = own.size();
  Banded lower(n);
  MatrixXd result = columns;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t band = std::min(i + 1, std::max(own[i].size(), excess[i].size()));
    lower[i].resize(band);
    for (std::size_t back = band; back-- > 0;) {
      const std::size_t j = i - back;
      double sum = entry(own, i, back) + variance * entry(excess, i, back);
      for (std::size_t k = back + 1; k < band && k - back < lower[j].size(); ++k)
        sum -= lower[i][k] * lower[j][k - back];
      // Rounding leaves nothing of points that nearly repeat those before them.
      constexpr double rounding = 1e-12;
      if (back == 0) {
        lower[i][0] = std::sqrt(std::max(sum, rounding * (entry(own, i, 0) + variance * entry(excess, i, 0))));
        result.row(static_cast<Index>(i)) /= lower[i][0];
      } else {
        lower[i][back] = sum / lower[j][0];
        result.row(static_cast<Index>(i)) -= lower[i][back] * result.row(static_cast<Index>(j));
      }
    }
  }
  return result;
}

struct Regression {
  VectorXd coefficients;
  MatrixXd covariance;  // of points with the covariance that whitened them
  double excess = 0, degrees_of_freedom = 0;
  bool clustered = false;
};

// Sum of squares that whitened columns leave of the last one.
double left_of(const MatrixXd& columns) {
  const Index degree = columns.cols() - 1;
  const Eigen::HouseholderQR<MatrixXd> qr(columns.leftCols(degree));
  const VectorXd turned = qr.householderQ().transpose() * columns.col(degree);
  return turned.tail(columns.rows() - degree).squaredNorm();
}

Regression regress(const MatrixXd& design, const VectorXd& y, const Banded& own, const Banded& excess,
                   std::span<const int> cluster) {
  MatrixXd columns(design.rows(), design.cols() + 1);
  columns << design, y;
  const auto freedom = static_cast<double>(design.rows() - design.cols());
  const auto left = [&](double variance) { return left_of(whitened(columns, own, excess, variance)); };
  Regression result;
  result.degrees_of_freedom = std::numeric_limits<double>::infinity();
  if (!(left(0) <= freedom)) {  // also where points have no errors of their own, and nothing can be divided by them
    // All of the scatter is as large as excess can be; what is left falls with it.
    double high = std::max((y.array() - y.mean()).square().sum(), 1e-300);
    while (left(high) > freedom) high *= 4;
    double low = high * 1e-16;
    for (int step = 0; step < 50; ++step) {
      const double middle = std::sqrt(low * high);
      (left(middle) > freedom ? low : high) = middle;
    }
    result.excess = std::sqrt(high);
    result.degrees_of_freedom = freedom;
  }
  const MatrixXd white = whitened(columns, own, excess, result.excess * result.excess);
  const LinearFit fit = linear_fit(white.leftCols(design.cols()), white.col(design.cols()), cluster);
  result.coefficients = fit.coefficients;
  result.clustered = fit.covariance_kind == CovarianceKind::clustered;
  if (result.clustered) {
    result.covariance = fit.covariance;
    result.degrees_of_freedom = fit.degrees_of_freedom;
  } else {
    result.covariance = fit.basis * fit.basis.transpose();
  }
  return result;
}

}  // namespace

StraightLine straight_line(const Eigen::Ref<const VectorXd>& x, const Eigen::Ref<const VectorXd>& y,
                           const Banded& own, const Banded& excess, std::span<const int> cluster) {
  const auto points = static_cast<std::size_t>(x.size());
  if (x.size() != y.size() || own.size() != points || excess.size() != points || points < 3)
    throw std::invalid_argument("straight_line: fewer than three points, or sizes that differ");
  const double unit = std::max(x.cwiseAbs().maxCoeff(), 1e-300);
  const MatrixXd design = powers(x, unit, 1);
  const Regression fit = regress(design, y, own, excess, cluster);
  StraightLine line;
  line.clustered = fit.clustered;
  line.intercept = fit.coefficients(0);
  line.slope = fit.coefficients(1) / unit;
  line.intercept_sd = std::sqrt(fit.covariance(0, 0));
  line.slope_sd = std::sqrt(fit.covariance(1, 1)) / unit;
  line.scatter = std::sqrt((y - design * fit.coefficients).squaredNorm() / static_cast<double>(points - 2));
  line.excess_sd = fit.excess;
  line.degrees_of_freedom = fit.degrees_of_freedom;
  if (points >= 6) {
    const Regression curved = regress(powers(x, unit, 2), y, own, excess, cluster);
    const double sd = std::sqrt(curved.covariance(2, 2));
    if (sd > 0) line.curvature_p = two_sided_p_value(curved.coefficients(2) / sd, curved.degrees_of_freedom);
  }
  return line;
}

namespace {

// What the fit with all powers says of the value at zero where only the first `degree` powers are there, Eqs. (M1)
// to (M3).
struct LawPosterior {
  double log_evidence = 0, variance = 0;
  VectorXd coefficients;  // of the powers of x over its unit
};

LawPosterior posterior_of(const Regression& full, Index degree, double change_sd) {
  const Index powers = full.coefficients.size() - 1;
  const VectorXd seen = full.coefficients.tail(powers);
  const MatrixXd errors = full.covariance.bottomRightCorner(powers, powers);
  VectorXd before = VectorXd::Zero(powers);
  before.head(degree).setConstant(change_sd * change_sd);
  const MatrixXd expected = errors + MatrixXd(before.asDiagonal());
  const Eigen::LDLT<MatrixXd> solver(expected);
  const double square = seen.dot(VectorXd(solver.solve(seen))), freedom = full.degrees_of_freedom;
  LawPosterior result;
  result.log_evidence = -0.5 * solver.vectorD().array().max(1e-300).log().sum();
  result.log_evidence -= std::isinf(freedom)
                             ? 0.5 * square
                             : 0.5 * (freedom + static_cast<double>(powers)) * std::log1p(square / freedom);
  const MatrixXd keep = before.asDiagonal() * MatrixXd(solver.solve(MatrixXd(MatrixXd::Identity(powers, powers))));
  const VectorXd mean = keep * seen;
  const MatrixXd left = MatrixXd(before.asDiagonal()) - keep * MatrixXd(before.asDiagonal());
  const VectorXd along = errors.ldlt().solve(VectorXd(full.covariance.col(0).tail(powers)));
  result.coefficients.resize(powers + 1);
  result.coefficients(0) = full.coefficients(0) + along.dot(mean - seen);
  result.coefficients.tail(powers) = mean;
  result.variance = std::max(0.0, full.covariance(0, 0) - along.dot(errors * along) + along.dot(left * along));
  return result;
}

}  // namespace

double AmplitudeLaw::others_variance(double value) const {
  double sum = 0;
  for (int d = 0; d < 3; ++d)
    if (d != degree) sum += probability[d] * (variance[d] + (at_zero[d] - value) * (at_zero[d] - value));
  return sum;
}

AmplitudeLaw amplitude_law(const Eigen::Ref<const VectorXd>& x, const Eigen::Ref<const VectorXd>& y,
                           const Banded& own, const Banded& excess, std::span<const int> cluster,
                           double change_sd) {
  const auto points = static_cast<std::size_t>(x.size());
  if (x.size() != y.size() || own.size() != points || excess.size() != points || points < 3)
    throw std::invalid_argument("amplitude_law: fewer than three points, or sizes that differ");
  const double unit = std::max(x.cwiseAbs().maxCoeff(), 1e-300);
  const Index highest = points >= 6 ? 2 : 1;
  const Regression full = regress(powers(x, unit, highest), y, own, excess, cluster);
  AmplitudeLaw law;
  law.degrees_of_freedom = full.degrees_of_freedom;
  law.excess = full.excess > 0 || full.clustered;
  std::vector<LawPosterior> laws;
  double best = -std::numeric_limits<double>::infinity(), sum = 0;
  for (Index degree = 0; degree <= highest; ++degree) {
    laws.push_back(posterior_of(full, degree, change_sd));
    if (laws.back().log_evidence > best) law.degree = static_cast<int>(degree);
    best = std::max(best, laws.back().log_evidence);
  }
  for (std::size_t d = 0; d < laws.size(); ++d) sum += law.probability[d] = std::exp(laws[d].log_evidence - best);
  for (std::size_t d = 0; d < laws.size(); ++d) {
    law.probability[d] /= sum;
    law.at_zero[d] = laws[d].coefficients(0);
    law.variance[d] = laws[d].variance;
  }
  const LawPosterior& chosen = laws[static_cast<std::size_t>(law.degree)];
  for (Index k = 0; k <= law.degree; ++k)
    law.coefficients[k] = chosen.coefficients(k) / std::pow(unit, static_cast<double>(k));
  law.intercept_sd = std::sqrt(law.probability[law.degree] * chosen.variance +  // Eq. (M4)
                               law.others_variance(law.coefficients[0]));
  return law;
}

}  // namespace secular
