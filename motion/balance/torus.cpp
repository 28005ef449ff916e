#include "motion/balance/torus.hpp"

#include <cmath>

#include "numerics/hertz.hpp"

namespace secular {

using Eigen::Index;

namespace {

/// So many lines are added up one by one.
constexpr Index few_lines = 4;

/// So many rows are transformed one by one.
constexpr Index few_rows = 8;

}  // namespace

Torus::Torus(int dimensions, int highest, Index points) : dimensions_(dimensions), turn_points_(points) {
  phases_.push_back({0, 0});
  for (int m = 0; m <= (dimensions == 1 ? 0 : highest); ++m)
    for (int n = m == 0 ? 1 : m - highest; n <= highest - m; ++n) phases_.push_back({n, m});
  const Index total = dimensions == 1 ? points : points * points;
  basis_.resize(total, 2 * lines());
  for (Index p = 0; p < total; ++p) {
    const double first = angle(p), second = angle(p / points);
    for (Index l = 0; l < lines(); ++l) {
      const double angle = phase(l)[0] * first + phase(l)[1] * second;
      basis_(p, 2 * l) = std::cos(angle);
      basis_(p, 2 * l + 1) = -std::sin(angle);
    }
  }
}

double Torus::angle(Index point) const {
  return two_pi * (static_cast<double>(point % turn_points_) + 0.5) / static_cast<double>(turn_points_);
}

std::optional<Index> Torus::find(const LinePhase& wanted) const {
  for (Index l = 0; l < lines(); ++l)
    if (phase(l) == wanted) return l;
  return std::nullopt;
}

// One product with a vector for every row: rows are few, and a product of matrices would copy the basis each time.
// Of an excitation only a line or two are not zero.
Eigen::MatrixXd Torus::samples(const Eigen::MatrixXcd& coefficients) const {
  Eigen::MatrixXd samples(coefficients.rows(), points());
  Eigen::VectorXcd line(lines());
  Eigen::VectorXd row(points());
  for (Index r = 0; r < samples.rows(); ++r) {
    if ((coefficients.row(r).array() != std::complex<double>(0)).count() <= few_lines) {
      row.setConstant(coefficients(r, 0).real());
      for (Index l = 1; l < lines(); ++l)
        if (const std::complex<double> c = 2.0 * coefficients(r, l); c != std::complex<double>(0))
          row += c.real() * basis_.col(2 * l) + c.imag() * basis_.col(2 * l + 1);
      samples.row(r) = row.transpose();
      continue;
    }
    line = 2 * coefficients.row(r).transpose();
    line(0) = coefficients(r, 0).real();
    row.noalias() =
        basis_ * Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(line.data()), 2 * lines());
    samples.row(r) = row.transpose();
  }
  return samples;
}

Eigen::RowVectorXd Torus::samples_of_line(Index line, std::complex<double> coefficient) const {
  if (line == 0) return Eigen::RowVectorXd::Constant(points(), coefficient.real());
  const std::complex<double> c = 2.0 * coefficient;
  return (c.real() * basis_.col(2 * line) + c.imag() * basis_.col(2 * line + 1)).transpose();
}

Eigen::MatrixXcd Torus::coefficients(const Eigen::MatrixXd& samples) const {
  Eigen::MatrixXcd coefficients(samples.rows(), lines());
  if (samples.rows() > few_rows) {
    const Eigen::MatrixXd all = samples * basis_ / static_cast<double>(points());
    for (Index l = 0; l < lines(); ++l) {
      coefficients.col(l).real() = all.col(2 * l);
      coefficients.col(l).imag() = all.col(2 * l + 1);
    }
    return coefficients;
  }
  Eigen::VectorXcd line(lines());
  Eigen::VectorXd row(points());
  for (Index r = 0; r < samples.rows(); ++r) {
    row = samples.row(r).transpose() / static_cast<double>(points());
    Eigen::Map<Eigen::VectorXd>(reinterpret_cast<double*>(line.data()), 2 * lines()).noalias() =
        basis_.transpose() * row;
    coefficients.row(r) = line.transpose();
  }
  return coefficients;
}

}  // namespace secular
