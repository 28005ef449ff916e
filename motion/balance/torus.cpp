#include "motion/balance/torus.hpp"

#include <cmath>
#include <map>

#include "numerics/hertz.hpp"

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

/// So many lines are added up one by one.
constexpr Index few_lines = 4;

/// So many rows are transformed one by one.
constexpr Index few_rows = 8;

// Sums of two of them have twice the highest.
std::vector<LinePhase> half_lattice(int dimensions, int highest) {
  std::vector<LinePhase> phases{{0, 0}};
  for (int m = 0; m <= (dimensions == 1 ? 0 : highest); ++m)
    for (int n = m == 0 ? 1 : m - highest; n <= highest - m; ++n) phases.push_back({n, m});
  return phases;
}

// samples: rows x points; basis: points x (cosine, -sine of every line).
MatrixXcd projected(const MatrixXd& samples, const MatrixXd& basis) {
  MatrixXcd coefficients(samples.rows(), basis.cols() / 2);
  const MatrixXd all = samples * basis / static_cast<double>(basis.rows());
  for (Index l = 0; l < coefficients.cols(); ++l) {
    coefficients.col(l).real() = all.col(2 * l);
    coefficients.col(l).imag() = all.col(2 * l + 1);
  }
  return coefficients;
}

bool is_negative(const LinePhase& n) {
  return n[1] < 0 || (n[1] == 0 && n[0] < 0);
}

}  // namespace

Torus::Torus(int dimensions, int highest, Index points)
    : dimensions_(dimensions),
      highest_(highest),
      turn_points_(points),
      phases_(half_lattice(dimensions, highest)),
      basis_(basis_of(phases_)) {}

// Angles are odd multiples of half a step.
MatrixXd Torus::basis_of(const std::vector<LinePhase>& phases) const {
  const Index halves = 2 * turn_points_, total = dimensions_ == 1 ? turn_points_ : turn_points_ * turn_points_;
  std::vector<Complex> turned;
  for (Index h = 0; h < halves; ++h)
    turned.push_back(std::polar(1.0, two_pi * static_cast<double>(h) / static_cast<double>(halves)));
  MatrixXd basis(total, 2 * static_cast<Index>(phases.size()));
  for (Index l = 0; l < static_cast<Index>(phases.size()); ++l) {
    const LinePhase& n = phases[static_cast<std::size_t>(l)];
    for (Index p = 0; p < total; ++p) {
      const Index half = (n[0] * (2 * (p % turn_points_) + 1) + n[1] * (2 * (p / turn_points_) + 1)) % halves;
      const Complex here = turned[static_cast<std::size_t>(half < 0 ? half + halves : half)];
      basis(p, 2 * l) = here.real();
      basis(p, 2 * l + 1) = -here.imag();
    }
  }
  return basis;
}

const Torus::Sums& Torus::sums() const {
  std::call_once(sums_->once, [&] {
    const std::vector<LinePhase> all = half_lattice(dimensions_, 2 * highest_);
    sums_->basis = basis_of(all);
    std::map<LinePhase, Index> columns;
    for (std::size_t s = 0; s < all.size(); ++s) columns.emplace(all[s], static_cast<Index>(s));
    const auto place = [&](const LinePhase& n) {
      const bool negative = is_negative(n);
      return Place{columns.at(negative ? LinePhase{-n[0], -n[1]} : n), negative};
    };
    for (const LinePhase& l : phases_)
      for (const LinePhase& n : phases_) {
        sums_->difference.push_back(place({n[0] - l[0], n[1] - l[1]}));
        sums_->sum.push_back(place({n[0] + l[0], n[1] + l[1]}));
      }
  });
  return *sums_;
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
MatrixXd Torus::samples(const MatrixXcd& coefficients) const {
  MatrixXd samples(coefficients.rows(), points());
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

MatrixXcd Torus::coefficients(const MatrixXd& samples) const {
  if (samples.rows() > few_rows) return projected(samples, basis_);
  MatrixXcd coefficients(samples.rows(), lines());
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

MatrixXcd Torus::coefficients_of_sums(const MatrixXd& samples) const {
  return projected(samples, sums().basis);
}

void Torus::add_product(const Eigen::Ref<const Eigen::RowVectorXcd, 0, Eigen::InnerStride<>>& sums, Index line,
                        Complex coefficient, Eigen::Ref<Eigen::RowVectorXcd, 0, Eigen::InnerStride<>> lines) const {
  const Complex a = line == 0 ? 0.5 * coefficient.real() : coefficient;
  const auto at = [&](const Place& place) {
    const Complex value = sums(place.column);
    return place.conjugated ? std::conj(value) : value;
  };
  const Sums& places = this->sums();
  for (Index n = 0; n < lines.size(); ++n) {
    const auto pair = static_cast<std::size_t>(line * lines.size() + n);
    lines(n) += a * at(places.difference[pair]) + std::conj(a) * at(places.sum[pair]);
  }
}

}  // namespace secular
