#include "numerics/quadratic_form.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace secular {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Relative: directions that do not vary, by rounding.
constexpr double rounding = 1e-12;

/// Of the logarithm of the integration variable, in which the integrand falls off exponentially on both sides and
/// is analytic within a strip as wide as pi: the trapezoidal rule's error is exp(-pi^2/step).
constexpr double from = -40, to = 80, step = 0.1;

// Probability that sum weight z^2 of independent standard normal z is positive.
double positive(const VectorXd& weight) {
  double sum = 0;
  for (double v = from; v < to; v += step) {
    const double u = std::exp(v);
    double angle = 0, fall = 0;
    for (const double w : weight) {
      angle += 0.5 * std::atan(w * u);
      fall += 0.25 * std::log1p(w * w * u * u);
    }
    sum += std::sin(angle) * std::exp(-fall);
  }
  return 0.5 + step * sum / std::numbers::pi;
}

}  // namespace

double ratio_lower_tail(double ratio, const MatrixXd& form, const MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spread(covariance);
  const VectorXd variance = spread.eigenvalues();
  if (variance.size() == 0 || !(variance.maxCoeff() > 0)) return 1;
  const VectorXd sd = (variance.array() > rounding * variance.maxCoeff()).select(variance, 0.0).cwiseSqrt();
  const MatrixXd root = spread.eigenvectors() * sd.asDiagonal();
  const MatrixXd above = ratio * MatrixXd::Identity(form.rows(), form.cols()) - form;
  VectorXd weight =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(MatrixXd(root.transpose() * above * root)).eigenvalues();
  const double largest = weight.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return 1;
  weight = (weight.cwiseAbs().array() > rounding * largest).select(weight / largest, 0.0);
  return positive(weight);
}

}  // namespace secular
