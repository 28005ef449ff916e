// Long stretches of driven records, fitted from far off: docs/inference.md (40).
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/inference/inference.hpp"
#include "tests/diagnose/driven_segment.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using testing_support::driven_segment;
using testing_support::Laboratory;
using testing_support::natural;

// Forty turns of slow sweeps through the resonance, up and down, at two levels: motions of up to 4 mm, at which the
// cubic spring moves the natural frequency by 3 %.
std::vector<Segment> sweeps(const Laboratory& lab, const VectorXd& unknowns) {
  constexpr Index samples = 1000;
  constexpr double spacing_s = 40 * 2 * std::numbers::pi / natural / samples, noise = 0.05;
  testing_support::Gaussian gaussian(11);
  std::vector<Segment> segments;
  for (const double level : {8.0, 16.0})
    for (const double direction : {1.0, -1.0}) {
      const auto base = [=](double t) {
        return level * std::cos((1 - 0.03 * direction + 0.01 * direction * t) * natural * t);
      };
      segments.push_back(driven_segment(lab, unknowns, {samples, spacing_s, base},
                                        Eigen::Vector2d(direction * 4e-3, 0.1), noise, gaussian));
      segments.back().record = segments.size() - 1;
    }
  return segments;
}

TEST(DrivenSegments, NumbersAreFoundFromFarOff) {
  const Laboratory lab;
  const double cubic = 8.0 / 3 * natural * natural * 0.03 / (4e-3 * 4e-3);
  for (const double sign : {1.0, -1.0}) {
    const VectorXd truth = lab.unknowns({{"alpha3", sign * cubic}});
    Discrepancy discrepancy;
    discrepancy.add(std::make_unique<SegmentEvidence>(lab.compiled, std::vector<StateForce>{}, lab.sensors,
                                                      lab.faults, sweeps(lab, truth)));
    const std::vector<std::size_t> own{lab.symbol("omega0"), lab.symbol("mu1"), lab.symbol("eta1"),
                                       lab.symbol("alpha3")};
    for (const double off : {0.99, 1.01}) {
      const VectorXd start = lab.unknowns({{"omega0", off * natural}, {"mu1", 0}, {"eta1", 0}});
      const Refit fit = infer(discrepancy, {}, start, own, {}).null.fit;
      const auto freedom = static_cast<double>(discrepancy.freedom() - fit.rank);
      EXPECT_NEAR(fit.chi_squared, freedom, 5 * std::sqrt(2 * freedom)) << sign << ' ' << off;
      for (std::size_t f = 0; f < own.size(); ++f) {
        const auto u = static_cast<Index>(own[f]), i = static_cast<Index>(f);
        // A normal variable exceeds four standard deviations once in 16000 times.
        EXPECT_NEAR(fit.unknowns(u), truth(u), 4 * std::sqrt(fit.covariance(i, i)))
            << f << ' ' << sign << ' ' << off;
      }
    }
  }
}

// Of a tone w at steps h the polynomial through ten samples is off by (0.5 1.5 2.5 3.5 4.5)^2 (w h)^10/10! halfway,
// and by none at samples.
TEST(HalfSamples, AreOfTenthOrder) {
  const auto worst_of = [](double step) {
    Eigen::MatrixXd samples(1, 40);
    for (Eigen::Index i = 0; i < 40; ++i) samples(i) = std::cos(step * static_cast<double>(i));
    const Eigen::MatrixXd all = at_half_samples(samples);
    EXPECT_EQ(all.cols(), 79);
    double worst = 0;
    for (Eigen::Index i = 0; i < 40; ++i) EXPECT_EQ(all(2 * i), samples(i));
    for (Eigen::Index i = 9; i < 70; i += 2)
      worst = std::max(worst, std::abs(all(i) - std::cos(step * static_cast<double>(i) / 2)));
    return worst;
  };
  EXPECT_NEAR(worst_of(0.4) / (872.09 / 3628800 * std::pow(0.4, 10)), 1, 0.1);
  EXPECT_NEAR(std::log2(worst_of(0.8) / worst_of(0.4)), 10, 0.25);
}

}  // namespace
}  // namespace secular
