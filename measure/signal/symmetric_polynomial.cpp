#include "measure/signal/symmetric_polynomial.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Product with (z + 1/z - 2 cos f) in the functions 1, z + 1/z, z^2 + 1/z^2, ...
VectorXd times_factor(const VectorXd& symmetric, double cosine) {
  const Index n = symmetric.size();
  VectorXd product = VectorXd::Zero(n + 1);
  product.head(n) = -2 * cosine * symmetric;
  product(1) += symmetric(0);
  for (Index j = 1; j < n; ++j) {
    product(j + 1) += symmetric(j);
    product(j - 1) += (j == 1 ? 2 : 1) * symmetric(j);
  }
  return product;
}

// Column k: the imposed factors times the k-th function.
MatrixXd imposed_map(Index free, std::span<const double> imposed) {
  MatrixXd map(free + static_cast<Index>(imposed.size()), free);
  for (Index k = 0; k < free; ++k) {
    VectorXd column = VectorXd::Unit(free, k);
    for (const double frequency : imposed) column = times_factor(column, std::cos(frequency));
    map.col(k) = column;
  }
  return map;
}

// The matrix of Eq. (4.27): column j holds y(l-j) + y(l+j).
MatrixXd folded(const Eigen::Ref<const VectorXd>& y, Index n) {
  const Index rows = y.size() - 2 * n;
  MatrixXd columns(rows, n + 1);
  columns.col(0) = y.segment(n, rows);
  for (Index j = 1; j <= n; ++j) columns.col(j) = y.segment(n - j, rows) + y.segment(n + j, rows);
  return columns;
}

// A^T A of the folded matrix: its entries are sums of y(l+a) y(l+b) over one range of l, and those of equal b - a
// differ by the products at the ends of the range. One sum for every lag, instead of one for every entry.
MatrixXd folded_gram(const Eigen::Ref<const VectorXd>& y, Index n) {
  const Index rows = y.size() - 2 * n, size = 2 * n + 1;
  MatrixXd sums(size, size);  // of y(l+a-n) y(l+b-n), l = n .. N-n-1
  for (Index b = 0; b < size; ++b) {
    sums(0, b) = y.head(rows).dot(y.segment(b, rows));
    for (Index a = 1; a <= b; ++a)
      sums(a, b) = sums(a - 1, b - 1) - y(a - 1) * y(b - 1) + y(rows + a - 1) * y(rows + b - 1);
    for (Index a = 0; a < b; ++a) sums(b, a) = sums(a, b);
  }
  MatrixXd gram(n + 1, n + 1);
  for (Index j = 0; j <= n; ++j)
    for (Index k = 0; k <= n; ++k) {
      const double across = sums(n - j, n - k) + sums(n + j, n - k),
                   along = sums(n - j, n + k) + sums(n + j, n + k);
      // Column 0 holds y(l) once, not twice.
      gram(j, k) = (across + along) * (j == 0 ? 0.5 : 1) * (k == 0 ? 0.5 : 1);
    }
  return gram;
}

// Upper triangle R with R^T R = A^T A, A = folded(y) * map.
MatrixXd triangle(const Eigen::Ref<const VectorXd>& y, Index n, const MatrixXd& map) {
  // Cholesky where noise keeps A^T A well away from singular: a relative error below 1e-9 and a small part of the
  // cost.
  const Eigen::LLT<MatrixXd> cholesky(MatrixXd(map.transpose() * folded_gram(y, n) * map));
  if (cholesky.info() == Eigen::Success && cholesky.rcond() > 1e-7) return cholesky.matrixU();
  const MatrixXd a = folded(y, n) * map;
  const Eigen::HouseholderQR<MatrixXd> qr(a);
  const Index k = std::min(a.rows(), a.cols());
  return qr.matrixQR().topRows(k).triangularView<Eigen::Upper>();
}

// Smallest singular direction of A in the metric D = L L^T: minimises |A x|^2 / (x^T D x).
struct NoiseDirection {
  VectorXd direction;
  double eigenvalue = 0;
};

// That of an upper triangle T in the metric one by inverse iteration, (T^T T)^-1 x again and again until x changes
// by less than `tolerance`: a small part of the cost of all directions. None where the next one is so close that
// this takes long, or where T is singular.
std::optional<NoiseDirection> smallest_direction(const MatrixXd& triangle, double tolerance) {
  constexpr int most_iterations = 20;
  const Index n = triangle.cols();
  if (triangle.rows() < n) return std::nullopt;
  const auto upper = triangle.topRows(n).triangularView<Eigen::Upper>();
  VectorXd x = VectorXd::Constant(n, 1 / std::sqrt(static_cast<double>(n)));
  for (int i = 0; i < most_iterations; ++i) {
    VectorXd next = x;
    upper.transpose().solveInPlace(next);
    upper.solveInPlace(next);
    const double length = next.norm();
    if (!std::isfinite(length)) return std::nullopt;
    next /= length;
    const double change = (next - x).norm();
    x = next;
    if (change < tolerance) return NoiseDirection{x, (upper * x).squaredNorm()};
  }
  return std::nullopt;
}

NoiseDirection noise_direction(const MatrixXd& a, const Eigen::LLT<MatrixXd>& metric) {
  const MatrixXd whitened = metric.matrixL().solve(MatrixXd(a.transpose())).transpose();
  const Eigen::HouseholderQR<MatrixXd> qr(whitened);
  NoiseDirection found;
  if (const auto smallest = smallest_direction(qr.matrixQR(), 1e-14)) {
    found = *smallest;
  } else {
    const Eigen::JacobiSVD<MatrixXd> svd(whitened, Eigen::ComputeFullV);
    const Index last = whitened.cols() - 1;
    found.direction = svd.matrixV().col(last);
    const double value = last < svd.singularValues().size() ? svd.singularValues()(last) : 0;
    found.eigenvalue = value * value;
  }
  found.direction = metric.matrixU().solve(found.direction);
  return found;
}

// Smallest eigenvalue of R^T R in the metric, to the digits that a weight needs. R L^-T is a triangle, as R is.
double noise_level(const MatrixXd& r, const Eigen::LLT<MatrixXd>& metric) {
  const MatrixXd whitened = metric.matrixL().solve(MatrixXd(r.transpose()));
  if (const auto smallest = smallest_direction(whitened.transpose(), 1e-7)) return smallest->eigenvalue;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(whitened * whitened.transpose(), Eigen::EigenvaluesOnly);
  return std::max(0.0, spectrum.eigenvalues()(0));
}

VectorXd monic_solution(const MatrixXd& equations) {
  const Index n = equations.cols() - 1;
  VectorXd solution(n + 1);
  solution.head(n) = -VectorXd(equations.leftCols(n).colPivHouseholderQr().solve(VectorXd(equations.col(n))));
  solution(n) = 1;
  return solution;
}

}  // namespace

Index fewest_for_polynomial(Index pairs, PolynomialMethod method) {
  return (method == PolynomialMethod::lagged_covariance ? 5 : 3) * pairs;
}

SymmetricPolynomial estimate_symmetric_polynomial(const Eigen::Ref<const MatrixXd>& channels, int order,
                                                  std::span<const double> imposed, PolynomialMethod method) {
  const Index n = order + static_cast<Index>(imposed.size()), samples = channels.rows(), count = channels.cols();
  if (order < 1 || samples < fewest_for_polynomial(n, method) || count < 1)
    throw std::invalid_argument("circular-hyperbolic decomposition needs at least " +
                                std::to_string(method == PolynomialMethod::lagged_covariance ? 5 : 3) +
                                " samples for every order");
  const MatrixXd map = imposed_map(order + 1, imposed);
  VectorXd zero_lag = VectorXd::Constant(n + 1, 2);
  zero_lag(0) = 1;
  const MatrixXd metric = map.transpose() * zero_lag.asDiagonal() * map;
  const Eigen::LLT<MatrixXd> factor(metric);
  const Index rows = samples - 2 * n;

  std::vector<MatrixXd> part(static_cast<std::size_t>(count));  // triangles, or lagged covariances
  SymmetricPolynomial result;
  result.channel_weight = VectorXd::Ones(count);
  for (Index c = 0; c < count; ++c) {
    const MatrixXd r = triangle(channels.col(c), n, map);
    const double power = channels.col(c).squaredNorm() / static_cast<double>(samples);
    if (count > 1) {
      const double noise = noise_level(r, factor) / static_cast<double>(rows);
      const double level = std::max(noise, 1e-12 * power);
      result.channel_weight(c) = level > 0 ? 1 / std::sqrt(level) : 0;
    }
    MatrixXd& mine = part[static_cast<std::size_t>(c)];
    if (method == PolynomialMethod::lagged_covariance) {
      const Index pairs = samples - 4 * n;
      const MatrixXd raw = folded(channels.col(c), n), reduced = raw * map;
      mine = result.channel_weight(c) * result.channel_weight(c) *
             (raw.topLeftCorner(pairs, n).transpose() * reduced.bottomRows(pairs));
    } else {
      mine = result.channel_weight(c) * r;
    }
  }
  if (method == PolynomialMethod::lagged_covariance) {
    MatrixXd sum = part.front();
    for (std::size_t c = 1; c < part.size(); ++c) sum += part[c];
    result.free = monic_solution(sum);
  } else {
    Index stacked_rows = 0;
    for (const MatrixXd& r : part) stacked_rows += r.rows();
    MatrixXd stacked(stacked_rows, order + 1);
    Index row = 0;
    for (const MatrixXd& r : part) {
      stacked.middleRows(row, r.rows()) = r;
      row += r.rows();
    }
    if (method == PolynomialMethod::least_squares) {
      result.free = monic_solution(stacked);
    } else {
      const NoiseDirection found = noise_direction(stacked, factor);
      result.free = found.direction;
      result.noise_variance = found.eigenvalue / static_cast<double>(rows * count);
    }
  }
  result.determined = result.free.allFinite();
  result.coefficients = map * result.free;
  return result;
}

std::vector<Pole> poles_of(const Eigen::Ref<const VectorXd>& symmetric) {
  Index n = symmetric.size() - 1;
  while (n > 0 && std::abs(symmetric(n)) <= std::numeric_limits<double>::min()) --n;
  // z^j + z^-j = 2 T_j(w/2) with w = z + 1/z: the eigenvalues of the comrade matrix of the recurrence
  // C_{j+1} = w C_j - C_{j-1}, C_1 = w, C_0 = 2, are the roots in w.
  MatrixXd comrade = MatrixXd::Zero(n, n);
  for (Index j = 1; j < n; ++j) {
    comrade(j, j - 1) = j == 1 ? 2 : 1;
    comrade(j - 1, j) = 1;
  }
  if (n > 0) comrade.row(n - 1) -= symmetric.head(n).transpose() / symmetric(n);
  std::vector<Pole> poles;
  if (n == 0) return poles;
  const Eigen::VectorXcd sums = comrade.eigenvalues();
  for (const std::complex<double>& w : sums) {
    // Eigenvalues of a real matrix: a real root has an imaginary part that is exactly zero.
    Pole pole;
    if (w.imag() == 0) {
      const double x = w.real();
      // Half-angle forms: acos and acosh of a number next to one lose half of its digits.
      if (std::abs(x) <= 2) {
        pole.family = PoleFamily::circular;
        pole.frequency = 2 * std::atan2(std::sqrt(2 - x), std::sqrt(2 + x));
      } else {
        pole.family = x > 0 ? PoleFamily::hyperbolic : PoleFamily::nyquist_hyperbolic;
        pole.rate = 2 * std::asinh(0.5 * std::sqrt(std::abs(x) - 2));
      }
      poles.push_back(pole);
    } else if (w.imag() > 0) {
      std::complex<double> z = 0.5 * (w + std::sqrt(w * w - 4.0));
      if (std::abs(z) < 1) z = 1.0 / z;
      const std::complex<double> logarithm = std::log(z);
      pole.family = PoleFamily::product;
      pole.rate = logarithm.real();
      pole.frequency = std::abs(logarithm.imag());
      poles.push_back(pole);
    }
  }
  std::sort(poles.begin(), poles.end(), [](const Pole& a, const Pole& b) {
    return a.family != b.family         ? a.family < b.family
           : a.frequency != b.frequency ? a.frequency < b.frequency
                                        : a.rate < b.rate;
  });
  return poles;
}

}  // namespace secular
