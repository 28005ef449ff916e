#include "motion/response/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double neutral = 1e-9;

// Calls visit(l_i, l_j) for every pair whose sum and product are real: two real ones, or a conjugate pair.
template <class Visitor>
void for_each_real_pair(const VectorXcd& values, const Visitor& visit) {
  for (Index i = 0; i < values.size(); ++i)
    for (Index j = i + 1; j < values.size(); ++j) {
      const bool both_real = values(i).imag() == 0 && values(j).imag() == 0;
      if (both_real || (values(i).imag() != 0 && values(i) == std::conj(values(j)))) visit(values(i), values(j));
    }
}

}  // namespace

Spectrum spectrum_of(const Eigen::Ref<const MatrixXd>& jacobian) {
  Spectrum spectrum;
  if (!jacobian.allFinite()) {
    spectrum.eigenvalues = VectorXcd::Constant(jacobian.rows(), std::numeric_limits<double>::quiet_NaN());
    return spectrum;
  }
  Eigen::EigenSolver<MatrixXd> solver(MatrixXd(jacobian), false);
  // Matrices of a symmetric field, with every eigenvalue twice over, can stall the QR algorithm: reflected ones do
  // not.
  for (int attempt = 1; solver.info() != Eigen::Success && attempt < 4; ++attempt) {
    const VectorXd normal = VectorXd::LinSpaced(jacobian.rows(), 1, 1 + attempt).normalized();
    MatrixXd reflected = jacobian - 2 * normal * (normal.transpose() * jacobian);
    reflected -= 2 * (reflected * normal) * normal.transpose();
    solver.compute(reflected, false);
  }
  if (solver.info() != Eigen::Success) {
    spectrum.eigenvalues = VectorXcd::Constant(jacobian.rows(), std::numeric_limits<double>::quiet_NaN());
    return spectrum;
  }
  std::vector<Complex> values(solver.eigenvalues().begin(), solver.eigenvalues().end());
  std::sort(values.begin(), values.end(), [](const Complex& a, const Complex& b) {
    return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag();
  });
  spectrum.eigenvalues = Eigen::Map<VectorXcd>(values.data(), static_cast<Index>(values.size()));
  const double largest = spectrum.eigenvalues.cwiseAbs().maxCoeff();
  spectrum.unstable = static_cast<int>((spectrum.eigenvalues.real().array() > neutral * largest).count());
  return spectrum;
}

EigenvaluePair most_neutral_pair(const Spectrum& spectrum) {
  EigenvaluePair best{std::numeric_limits<double>::infinity(), 0};
  for_each_real_pair(spectrum.eigenvalues, [&](const Complex& a, const Complex& b) {
    const double sum = (a + b).real();
    if (std::abs(sum) < std::abs(best.sum)) best = {sum, (a * b).real()};
  });
  return best;
}

EigenvaluePair nearest_pair(const Spectrum& spectrum, const EigenvaluePair& reference) {
  const double largest = spectrum.eigenvalues.cwiseAbs().maxCoeff();
  const double rate = std::max({largest, std::sqrt(std::abs(reference.product)), 1e-100});
  EigenvaluePair best{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  double least = std::numeric_limits<double>::infinity();
  for_each_real_pair(spectrum.eigenvalues, [&](const Complex& a, const Complex& b) {
    const EigenvaluePair pair{(a + b).real(), (a * b).real()};
    const double distance =
        std::hypot((pair.sum - reference.sum) / rate, (pair.product - reference.product) / (rate * rate));
    if (distance < least) {
      least = distance;
      best = pair;
    }
  });
  return best;
}

double hopf_test(const Spectrum& spectrum) {
  const VectorXcd& values = spectrum.eigenvalues;
  if (values.size() < 2) return 0;
  const double largest = values.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return 0;
  Complex sign = 1;
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < values.size(); ++i)
    for (Index j = i + 1; j < values.size(); ++j) {
      const Complex sum = values(i) + values(j);
      const double size = std::abs(sum);
      if (size == 0) return 0;
      sign *= sum / size;
      least = std::min(least, size);
    }
  return std::copysign(least / largest, sign.real());
}

}  // namespace secular
