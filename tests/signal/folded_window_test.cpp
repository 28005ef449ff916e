#include "measure/signal/folded_window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "measure/signal/refine_poles.hpp"
#include "tests/signal/tone_pole.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Sums of products of cosines and sines in closed form are those that are added up, also where tones nearly
// coincide, lie near zero or at half the sampling rate.
TEST(FoldedWindow, GramMatrixIsTheSumOfProducts) {
  const std::vector<std::vector<Pole>> cases = {
      {},
      {tone(12.5), tone(33.1), tone(45.6)},
      {{PoleFamily::constant, 0, 0, true}, tone(3.3), tone(3.3 + 1e-6), tone(120)},
      {tone(1e-3), tone(50)},
      {tone(128 - 1e-5), tone(20)},
      {tone(128), tone(20)},
      {{PoleFamily::hyperbolic, 0, 2.0, false}, tone(20)},
      {{PoleFamily::nyquist_hyperbolic, 0, 2.0, false}, tone(20), {PoleFamily::product, 60, 1.0, false}},
  };
  for (const Index samples : {255, 256})
    for (std::size_t c = 0; c < cases.size(); ++c) {
      const FoldedWindow window(samples, rate);
      const FoldedFunctions functions(cases[c], window);
      const MatrixXd gram = functions.gram();
      const double first = -0.5 * static_cast<double>(samples - 1) / rate;
      const MatrixXd all = pole_functions(cases[c], samples, rate, first);
      ASSERT_EQ(gram.rows(), all.cols());
      // Values of either side are off by the rounding of their arguments, of up to 402 rad, and of the addition
      // theorem; with two factors, and sums of as many products.
      const double largest = all.size() > 0 ? all.cwiseAbs().maxCoeff() : 0;
      const double rounding =
          4 * 0x1p-52 * (std::numbers::pi * rate * 0.5 + 8) * static_cast<double>(samples) * largest * largest;
      for (Index i = 0; i < all.cols(); ++i)
        for (Index j = 0; j < all.cols(); ++j)
          EXPECT_NEAR(gram(i, j), all.col(i).dot(all.col(j)), rounding)
              << "case " << c << ", " << samples << " samples, " << i << ", " << j;
    }
}

// The last step is taken along the tangent: a refinement that starts at the result finds nothing to add.
TEST(FoldedWindow, RefinedPolesAreWhereAnotherRefinementStays) {
  std::vector<Pole> poles = {tone(12.5), tone(33.1), tone(45.6), tone(58.1)};
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (int draw = 0; draw < 20; ++draw) {
    MatrixXd amplitudes(8, 3);
    for (double& a : amplitudes.reshaped()) a = normal(random);
    MatrixXd y = pole_functions(poles, 512, rate, 0) * amplitudes;
    for (double& value : y.reshaped()) value += 0.05 * normal(random);
    std::vector<Pole> start = poles;
    for (Pole& pole : start) pole.frequency += 0.2 * normal(random);  // a bin is 3 rad/s wide
    const RefinedPoles once = refine_poles(y, rate, start), again = refine_poles(y, rate, once.poles);
    ASSERT_EQ(once.ending, SolverEnding::converged);
    const MatrixXd covariance = again.covariance.matrix();
    for (std::size_t i = 0; i < poles.size(); ++i) {
      const auto at = static_cast<Index>(i);
      EXPECT_NEAR(once.poles[i].frequency, again.poles[i].frequency, 1e-3 * std::sqrt(covariance(at, at)));
    }
    for (Index c = 0; c < 3; ++c)
      for (Index k = 0; k < 8; ++k) {
        const Index at = 4 + 8 * c + k;
        EXPECT_NEAR(once.amplitudes(k, c), again.amplitudes(k, c), 1e-3 * std::sqrt(covariance(at, at)));
      }
    EXPECT_NEAR(once.cost, again.cost, 1e-3);
  }
}

}  // namespace
}  // namespace secular
