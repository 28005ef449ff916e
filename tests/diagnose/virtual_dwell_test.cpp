// Dwells predicted under an explanation, against closed forms.
#include "diagnose/evidence/virtual_dwell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "diagnose/verdict/next_dwell.hpp"
#include "tests/diagnose/made_up_explanation.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::VectorXd;
using testing_support::damping, testing_support::direct, testing_support::natural;
using testing_support::explanation, testing_support::Laboratory;

Complex transfer(double frequency) {
  return direct / Complex(natural * natural - frequency * frequency, 2 * damping * frequency);
}

TEST(VirtualDwell, OfALinearOscillatorFollowsItsTransferFunction) {
  const Laboratory lab;
  const double force = 3, frequency = 80.2;
  const Condition measured = lab.dwell(frequency, force, transfer(frequency) * force / 2.0);
  for (const auto& [level, ratio] : {std::pair(1.0, 1.0), std::pair(1.5, 1.0), std::pair(0.5, 1.01)}) {
    const auto dwell = virtual_dwell(lab.model, measured, lab.unknowns({}), level, ratio);
    ASSERT_TRUE(dwell);
    const double w = ratio * frequency;
    const Complex expected = -w * w * transfer(w) * level * force / 2.0;
    EXPECT_LT(std::abs(dwell->response(0, 0) - expected), 1e-6 * std::abs(expected));
    EXPECT_NEAR(std::abs(dwell->excitation(0, 0)), level * force / 2, 1e-12);
  }
}

// On the backbone's large branch of a softening oscillator, x'' + w^2 x - a x^3 with little force, the amplitude of
// a harmonic response solves A^2 ((w^2 - s^2 - 3 a A^2/4)^2 + (2 mu s)^2) = (eta F)^2: the large solution
// disappears where F falls below that of the upper saddle-node, at which dissipation takes all the force can give.
TEST(VirtualDwell, EndsWithTheBranch) {
  const Laboratory lab;
  // Four half-bandwidths below: more than the square root of three that a fold needs.
  const double stiffness = -2e7, frequency = natural - 4 * damping;
  const double most = std::sqrt((natural * natural - frequency * frequency) / (-0.75 * stiffness));
  const double force = 1.05 * 2 * damping * frequency * most / std::abs(direct);
  const VectorXd unknowns = lab.unknowns({{"alpha3", stiffness}});
  // In quadrature at the crest of the backbone.
  const Condition measured = lab.dwell(frequency, force, Complex(0, 0.5 * most));
  EXPECT_TRUE(virtual_dwell(lab.model, measured, unknowns, 1, 1));
  EXPECT_TRUE(virtual_dwell(lab.model, measured, unknowns, 1.2, 1));
  EXPECT_FALSE(virtual_dwell(lab.model, measured, unknowns, 0.8, 1));
}

// Two laws of damping that were matched at one amplitude part at another, and the farther from it the better; one
// law twice is never parted.
TEST(NextDwell, GoesWhereTheLawsPart) {
  const Laboratory lab;
  const double force = 3, frequency = natural, half = 0.5 * force * std::abs(direct) / (2 * damping * frequency);
  const double peak = 2 * half;
  // 2 mu + 3/4 mu3 w^2 X^2 against 2 mu + 8/(3 pi) mu2 w X: both add a tenth to the damping.
  const double added = 0.2 * damping;
  const VectorXd cubic =
      lab.unknowns({{"mu1", 0.9 * damping}, {"mu3", added / (0.75 * std::pow(frequency * peak, 2))}});
  const VectorXd drag =
      lab.unknowns({{"mu1", 0.9 * damping}, {"mu2", added / (8 / (3 * std::numbers::pi) * frequency * peak)}});
  const Condition measured = lab.dwell(frequency, force, Complex(0, half));
  const Explanation first =
                        explanation(lab, cubic, "mu3", 0.01 * cubic(static_cast<Eigen::Index>(lab.symbol("mu3")))),
                    second =
                        explanation(lab, drag, "mu2", 0.01 * drag(static_cast<Eigen::Index>(lab.symbol("mu2"))));
  const ProposedTest next = next_dwell(lab.model, {measured}, {{&first, 0.5}, {&second, 0.5}}, {});
  ASSERT_GT(next.compared, 3u);
  EXPECT_DOUBLE_EQ(next.before, 0.5);
  EXPECT_GE(next.probability, next.typical);
  EXPECT_GE(next.typical, next.before);
  EXPECT_GT(next.separation, 2);
  EXPECT_NE(next.level, 1);
  EXPECT_LE(next.level, 1.5);  // of what the structure has seen
  EXPECT_EQ(next_dwell(lab.model, {measured}, {{&first, 0.5}, {&second, 0.5}}, {.highest_level = 3}).level, 2);
  EXPECT_EQ(next.resonance, "Omega near omega0");
  const ProposedTest none = next_dwell(lab.model, {measured}, {{&first, 0.5}, {&first, 0.5}}, {});
  EXPECT_LT(none.separation, 1e-3);
  EXPECT_NEAR(none.probability, 0.5, 1e-6);
  EXPECT_EQ(none.chance, 0);
}

// A dwell four times as long, where one alone is not as good as certain, halves the errors: at most twice the
// separation (the explanations' own freedom stays). Where that is not enough either, sixteen times as long.
TEST(NextDwell, IsLongerWhereItHasToBe) {
  const Laboratory lab;
  const double force = 3, frequency = natural, half = 0.5 * force * std::abs(direct) / (2 * damping * frequency);
  const double peak = 2 * half, rate = 0.75 * std::pow(frequency * peak, 2),
               drag_rate = 8 / (3 * std::numbers::pi) * frequency * peak;
  const Condition measured = lab.dwell(frequency, force, Complex(0, half));
  double length = 1;
  std::set<double> used;
  for (const double share : {0.4, 0.01, 0.004, 0.002, 0.001, 0.0005, 0.0002, 0.0001}) {
    const double added = share * damping, own = (1 - share / 2) * damping;
    const VectorXd cubic = lab.unknowns({{"mu1", own}, {"mu3", added / rate}}),
                   drag = lab.unknowns({{"mu1", own}, {"mu2", added / drag_rate}});
    const Explanation first = explanation(lab, cubic, "mu3", 1e-3 * added / rate),
                      second = explanation(lab, drag, "mu2", 1e-3 * added / drag_rate);
    const ProposedTest next = next_dwell(lab.model, {measured}, {{&first, 0.5}, {&second, 0.5}}, {});
    // Phi((d^2/2 - ln 20)/d) of the closer of the two.
    const double d = next.separation;
    EXPECT_NEAR(next.chance, 0.5 * std::erfc(-(d / 2 - std::log(20) / d) / std::sqrt(2)), 0.1);
    EXPECT_GE(next.length, length) << "the harder to tell, the longer";
    length = next.length;
    used.insert(length);
    if (length < 16) {
      EXPECT_GT(next.chance, 0.9);
    }
  }
  EXPECT_EQ(used, (std::set<double>{1, 4, 16}));
}

}  // namespace
}  // namespace secular
