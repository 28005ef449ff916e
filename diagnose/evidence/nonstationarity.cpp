#include "diagnose/evidence/nonstationarity.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// What dies out varies by this share in the second half of a dwell, as squares, of what it was off in the first.
constexpr auto& left_in_the_second_half = diagnose_thresholds().left_in_the_second_half;

// Over a whole turn or two of a wave no half is quieter than that.
bool settles(const Eigen::VectorXcd& amplitude) {
  const Index half = amplitude.size() / 2;
  const Eigen::VectorXcd late = amplitude.tail(half);
  const Complex end = late.mean();
  const double early = (amplitude.head(amplitude.size() - half).array() - end).abs2().mean();
  return (late.array() - end).abs2().mean() < left_in_the_second_half * early;
}

}  // namespace

Nonstationarity nonstationarity_of(const Eigen::VectorXcd& amplitude, const Eigen::MatrixXcd& noise) {
  Nonstationarity nonstationarity;
  const auto ensembles = static_cast<double>(amplitude.size());
  if (amplitude.size() < 3 || noise.size() == 0) return nonstationarity;
  const Eigen::VectorXd time =
      Eigen::VectorXd::LinSpaced(amplitude.size(), -0.5 * (ensembles - 1), 0.5 * (ensembles - 1));
  const std::complex<double> mean = amplitude.mean();
  const std::complex<double> slope = time.dot(amplitude.real()) / time.squaredNorm() +
                                     std::complex<double>(0, 1) * time.dot(amplitude.imag()) / time.squaredNorm();
  const double deviation = (amplitude.array() - mean - slope * time.array()).abs2().sum();
  const double variance = noise.cwiseAbs2().mean() / 2;  // of a real part
  nonstationarity.squares = deviation / variance;
  nonstationarity.freedom = 2 * (ensembles - 2);
  nonstationarity.noise_freedom = 2 * static_cast<double>(noise.size());
  nonstationarity.dies_out = is_unsteady(nonstationarity) && settles(amplitude);
  return nonstationarity;
}

NonstationarityTest test_nonstationarity(const std::vector<Nonstationarity>& dwells) {
  NonstationarityTest test;
  double squares = 0, freedom = 0, noise_freedom = 0, least = 1, count = 0;
  for (const Nonstationarity& w : dwells) {
    if (!(w.freedom > 0) || !(w.noise_freedom > 2)) continue;
    ++count;
    // A ratio to a variance that was estimated is larger in the mean.
    squares += w.squares * (w.noise_freedom - 2) / w.noise_freedom;
    freedom += w.freedom;
    noise_freedom += w.noise_freedom;
    const double p = f_upper_tail(w.squares / w.freedom, w.freedom, w.noise_freedom);
    if (p < least) {
      least = p;
      test.record = w.record;
    }
  }
  if (count == 0) return test;
  test.ratio = std::sqrt(squares / freedom);
  test.p_value =
      std::min(1.0, 2 * std::min(f_upper_tail(squares / freedom, freedom, noise_freedom), count * least));
  return test;
}

bool is_unsteady(const Nonstationarity& nonstationarity) {
  return test_nonstationarity({nonstationarity}).p_value < diagnose_thresholds().unsteady_alarm;
}

}  // namespace secular
