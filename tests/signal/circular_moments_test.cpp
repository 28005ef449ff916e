#include "measure/signal/circular_moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "measure/signal/folded_window.hpp"
#include "measure/signal/narrow_products.hpp"
#include "measure/signal/tone_series.hpp"
#include "tests/signal/tone_pole.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(CircularMoments, AreTheSumsOverTheSamples) {
  const std::vector<std::vector<Pole>> cases = {
      {tone(12.5)},
      {tone(12.5), tone(33.1), tone(45.6), tone(33.1 + 1.5)},
      {{PoleFamily::constant, 0, 0, true}, tone(3.3), tone(126.5)},
      {tone(40), {PoleFamily::circular, 2 * std::numbers::pi * 90, 0, true}, tone(200), tone(90.7)},
  };
  for (const Index samples : {255, 256})
    for (std::size_t c = 0; c < cases.size(); ++c) {
      const FoldedWindow window(samples, rate);
      const auto closed = circular_moments(cases[c], window);
      ASSERT_TRUE(closed) << c;
      const MatrixXd g = pole_functions(cases[c], samples, rate, -window.half);
      const VectorXd tau = VectorXd::LinSpaced(samples, -1, 1);
      const MatrixXd timed = tau.asDiagonal() * g;
      // Arguments of up to 628 rad are rounded, and the tones are apart by more than half a bin: N sin(y) > pi/2.
      const double rounding = 16 * 0x1p-52 * 640 * static_cast<double>(samples);
      EXPECT_LT((closed->zeroth - g.transpose() * g).cwiseAbs().maxCoeff(), rounding) << c;
      EXPECT_LT((closed->first - g.transpose() * timed).cwiseAbs().maxCoeff(), rounding) << c;
      EXPECT_LT((closed->second - timed.transpose() * timed).cwiseAbs().maxCoeff(), rounding) << c;
    }
}

TEST(CircularMoments, AreNotTakenWhereTheyLoseDigits) {
  const FoldedWindow window(256, rate);
  for (const std::vector<Pole>& poles : std::vector<std::vector<Pole>>{{},
                                                                       {tone(20), tone(20.05)},
                                                                       {tone(0.02)},
                                                                       {tone(127.98)},
                                                                       {tone(128)},
                                                                       {{PoleFamily::hyperbolic, 0, 2, false}}})
    EXPECT_FALSE(circular_moments(poles, window));
}

TEST(NarrowProducts, AreThoseOfEigen) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto matrix = [&](Index rows, Index columns) {
    MatrixXd m(rows, columns);
    for (double& value : m.reshaped()) value = normal(random);
    return m;
  };
  for (const Index rows : {1, 2, 31, 64})
    for (const Index left : {0, 1, 3, 4, 9})
      for (const Index right : {0, 1, 2, 5, 8}) {
        const MatrixXd a = matrix(rows, left), b = matrix(rows, right), c = matrix(left, right);
        const MatrixXd product = transposed_product(a, b);
        ASSERT_EQ(product.rows(), left);
        ASSERT_EQ(product.cols(), right);
        MatrixXd rest = b;
        subtract_product(a, c, rest);
        for (Index j = 0; j < right; ++j) {
          for (Index i = 0; i < left; ++i)
            EXPECT_NEAR(product(i, j), a.col(i).dot(b.col(j)),
                        0x1p-52 * static_cast<double>(rows) * a.col(i).norm() * b.col(j).norm());
          for (Index r = 0; r < rows; ++r) {
            double expected = b(r, j), size = std::abs(b(r, j));
            for (Index i = 0; i < left; ++i) {
              expected -= a(r, i) * c(i, j);
              size += std::abs(a(r, i) * c(i, j));
            }
            EXPECT_NEAR(rest(r, j), expected, 0x1p-52 * static_cast<double>(left + 1) * size);
          }
        }
      }
}

// Without noise the maximum is at the tones: what is left of an offset d is of the order d^5/240.
TEST(ToneSeries, ComesNextToTheMaximumOrSaysThatItIsFar) {
  const FoldedWindow window(512, rate);
  const std::vector<Pole> truth = {tone(12.5), tone(33.1), tone(58.2)};
  MatrixXd amplitudes(6, 2);
  amplitudes << 1, 0.2, -0.4, 0.9, 0.3, 1.1, 0.8, -0.5, 0.6, 0.7, -1, 0.4;
  const MatrixXd y = pole_functions(truth, 512, rate, -window.half) * amplitudes;
  for (const double offset : {1e-3, 0.03, 0.1, 0.4, 1.5}) {
    std::vector<Pole> start = truth;
    double sign = 1;
    for (Pole& pole : start) pole.frequency += (sign = -sign) * offset / window.half;
    const FoldedFunctions functions(start, window);
    const ToneSeries series =
        follow_series(start, functions, window.even(y), window.odd(y), y.colwise().squaredNorm().transpose());
    ASSERT_TRUE(series.moved);
    EXPECT_EQ(series.far, offset > 1);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double left = std::abs(series.poles[i].frequency - truth[i].frequency) * window.half;
      EXPECT_LT(left, series.far ? 0.5 * offset : std::pow(offset, 5) / 100 + 1e-9) << offset;
    }
  }
}

}  // namespace
}  // namespace secular
