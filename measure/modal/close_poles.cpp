#include "measure/modal/close_poles.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "numerics/orthonormal_span.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Of unit length; exact at every 32nd row.
MatrixXd pole_columns(Index rows, double rate, Complex pole) {
  constexpr Index block = 32;
  Complex offset[block], start = 0;
  for (Index j = 0; j < block; ++j) offset[j] = std::exp(pole * (static_cast<double>(j) / rate));
  MatrixXd columns(rows, 2);
  for (Index i = 0; i < rows; ++i) {
    if (i % block == 0) start = std::exp(pole * (static_cast<double>(i) / rate));
    const Complex factor = offset[i % block];
    columns(i, 0) = start.real() * factor.real() - start.imag() * factor.imag();
    columns(i, 1) = -start.real() * factor.imag() - start.imag() * factor.real();
  }
  for (Index c = 0; c < 2; ++c) columns.col(c) /= std::max(columns.col(c).norm(), 1e-300);
  return columns;
}

// Two bandwidths to both sides, at half to twice the rate.
std::vector<Complex> grid_about(Complex pole, double duration, double highest) {
  const double width = std::max(std::abs(pole.real()), 1 / duration);
  std::vector<Complex> grid;
  for (const double rate : {0.5, 1.0, 2.0})
    for (const double offset : {-4.0, -2.0, -1.0, 0.0, 1.0, 2.0, 4.0}) {
      const Complex at(rate * (pole.real() > 0 ? width : -width), pole.imag() + offset * width);
      if (at.imag() > 0 && at.imag() < highest && representable(at, duration)) grid.push_back(at);
    }
  return grid;
}

}  // namespace

std::pair<Complex, Complex> closest_pair(const Eigen::Ref<const MatrixXd>& samples, double rate, const PoleFit& fit,
                                         Index row) {
  const Index rows = samples.rows(), n = fit.poles.size();
  MatrixXd others = MatrixXd::Ones(rows, 2 * (n - 1) + 1);
  std::pair<Complex, Complex> best(fit.poles(row), fit.poles(row));
  for (Index r = 0, at = 0; r < n; ++r)
    if (r != row) others.middleCols(2 * at++, 2) = pole_columns(rows, rate, fit.poles(r));
  const Eigen::HouseholderQR<MatrixXd> qr(others);
  const MatrixXd basis = qr.householderQ() * MatrixXd::Identity(rows, others.cols());
  const std::vector<Complex> grid =
      grid_about(fit.poles(row), static_cast<double>(rows) / rate, std::numbers::pi * rate);
  MatrixXd columns(rows, 2 * static_cast<Index>(grid.size()));
  for (std::size_t g = 0; g < grid.size(); ++g)
    columns.middleCols(2 * static_cast<Index>(g), 2) = pole_columns(rows, rate, grid[g]);
  columns = without_span(basis, columns);
  const VectorXd weight = fit.noise_sd.cwiseMax(1e-300).cwiseInverse();
  const MatrixXd moments = columns.transpose() * columns,
                 slopes = columns.transpose() * samples * weight.asDiagonal();
  double most = -1;
  for (std::size_t a = 0; a < grid.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const auto i = 2 * static_cast<Index>(a), k = 2 * static_cast<Index>(b);
      const std::vector<Index> both = {i, i + 1, k, k + 1};
      const MatrixXd slope = slopes(both, Eigen::all);
      const double gain = slope.cwiseProduct(MatrixXd(moments(both, both)).ldlt().solve(slope)).sum();
      if (!(gain > most)) continue;
      most = gain;
      best = {grid[a], grid[b]};
    }
  return best;
}

VectorXcd with_pair(const VectorXcd& poles, Index row, const std::pair<Complex, Complex>& pair) {
  VectorXcd more(poles.size() + 1);
  more << poles, pair.second;
  more(row) = pair.first;
  return more;
}

}  // namespace secular
