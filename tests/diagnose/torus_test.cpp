#include "motion/balance/torus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "diagnose/evidence/resonant_lines.hpp"
#include "diagnose/evidence/sensor_model.hpp"
#include "motion/balance/motion_balance.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

TEST(Torus, CoefficientsAndSamplesAreEachOthersInverse) {
  for (const Torus& torus : {Torus(1, 6, 32), Torus(2, 3, 16)}) {
    MatrixXcd coefficients = MatrixXcd::Random(3, torus.lines());
    coefficients.col(0).imag().setZero();
    EXPECT_LT((torus.coefficients(torus.samples(coefficients)) - coefficients).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(Torus, ProductsOfLinesFallOnSumsAndDifferences) {
  const Torus torus(2, 3, 16);
  MatrixXcd x = MatrixXcd::Zero(1, torus.lines()), y = x;
  const Complex a(0.3, -0.2), b(1.1, 0.4);
  x(0, *torus.find({1, 0})) = a;
  y(0, *torus.find({0, 1})) = b;
  const MatrixXcd product = torus.coefficients(torus.samples(x).cwiseProduct(torus.samples(y)));
  EXPECT_LT(std::abs(product(0, *torus.find({1, 1})) - a * b), 1e-15);
  EXPECT_LT(std::abs(product(0, *torus.find({-1, 1})) - std::conj(a) * b), 1e-15);
  EXPECT_FALSE(torus.find({1, -1}));  // the other half of the lattice
}

// With few points for the lines that a product has, so that some of them alias.
TEST(Torus, ProductWithALineNeedsNoSamplesOfIt) {
  for (const Torus& torus : {Torus(1, 6, 15), Torus(2, 3, 8)}) {
    const MatrixXd factor = MatrixXd::Random(1, torus.points());
    const MatrixXcd sums = torus.coefficients_of_sums(factor);
    for (Eigen::Index line = 0; line < torus.lines(); ++line) {
      const Complex a(0.7, line == 0 ? 0 : -1.3);
      MatrixXcd product = MatrixXcd::Zero(1, torus.lines());
      torus.add_product(sums.row(0), line, a, product.row(0));
      const MatrixXcd expected = torus.coefficients(factor.cwiseProduct(torus.samples_of_line(line, a)));
      EXPECT_LT((product - expected).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST(Slider, LosesFourTimesSlipTimesSlidingInACycle) {
  // A spring of unit stiffness in series with a slider, driven by x = X cos(theta): the loop's area is 4 z (X - z).
  const Torus torus(1, 1, 4096);
  MatrixXcd line = MatrixXcd::Zero(1, 2);
  const double amplitude = 2, slip = 0.3;
  line(0, 1) = amplitude / 2;
  const MatrixXd path = torus.samples(line);
  const Eigen::RowVectorXd stretch = slider_stretch(path, {slip});
  double area = 0;
  for (Eigen::Index i = 0; i < path.cols(); ++i) {
    const Eigen::Index before = i == 0 ? path.cols() - 1 : i - 1;
    area += 0.5 * (stretch(i) + stretch(before)) * (path(0, i) - path(0, before));
  }
  EXPECT_NEAR(area, 4 * slip * (amplitude - slip), 1e-5);
  // Below its slip it is a spring and loses nothing.
  EXPECT_LT((slider_stretch(path, {10}) - slider_stretch(path, {20})).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(LineLayout, FindsTheResonanceOfEveryKind) {
  EXPECT_EQ(possible_layouts({100}, 101).front().resonances.front().line, (LinePhase{1, 0}));
  const LineLayout parametric = possible_layouts({100}, 199).front();
  EXPECT_EQ(parametric.divisor, 2);
  EXPECT_EQ(parametric.excitation, (LinePhase{2, 0}));
  EXPECT_EQ(parametric.resonances.front().line, (LinePhase{1, 0}));
  const LineLayout superharmonic = possible_layouts({100}, 50).front();
  EXPECT_EQ(superharmonic.resonances.front().line, (LinePhase{2, 0}));
  const LineLayout additive = possible_layouts({72, 209}, 283).front();
  EXPECT_EQ(additive.dimensions, 2);
  EXPECT_EQ(additive.excitation, (LinePhase{1, 1}));
  const LineLayout difference = possible_layouts({250, 95}, 155).front();
  EXPECT_EQ(difference.excitation, (LinePhase{-1, 1}));
  EXPECT_EQ(difference.resonances.front().mode, 1U);
  // Nothing near: forced motion alone.
  EXPECT_TRUE(possible_layouts({100}, 470).front().resonances.empty());
}

// Two numbers with two meanings, one of which must lie within the other.
TEST(LineLayout, LooksAtEveryLineThatIsNoSlave) {
  constexpr std::pair<double, int> multiples[] = {{1, 1}, {2, 2}, {3, 3}, {0.5, 1}, {1.0 / 3, 1}};
  for (const auto& [multiple, line] : multiples)
    for (const double sign : {-1.0, 1.0}) {
      const double frequency = 100 * std::sqrt(1 + sign * least_slaved_stiffness);
      const LineLayout layout = possible_layouts({100}, frequency / multiple).front();
      ASSERT_EQ(layout.resonances.size(), 1U) << multiple << ", " << frequency;
      EXPECT_EQ(layout.resonances.front().line, (LinePhase{line, 0})) << multiple << ", " << frequency;
    }
}

}  // namespace
}  // namespace secular
