// Long stretches of driven records, fitted from far off: docs/inference.md (40).
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/inference/inference.hpp"
#include "tests/diagnose/laboratory.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
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
      Segment s;
      s.record = segments.size();
      s.sample_s = spacing_s;
      s.substeps = 4;
      s.excitation.resize(1, 2 * samples - 1);
      for (Index i = 0; i < s.excitation.cols(); ++i) {
        const double t = 0.5 * spacing_s * static_cast<double>(i);
        s.excitation(0, i) = level * std::cos((1 - 0.03 * direction + 0.01 * direction * t) * natural * t);
      }
      const MotionStart start{{unknowns.data(), unknowns.data() + lab.compiled.symbols.size()},
                              Eigen::Vector2d(direction * 4e-3, 0.1),
                              std::make_shared<const DrivingSignal>(DrivingSignal{s.excitation, spacing_s}),
                              samples,
                              4};
      s.response = MotionIntegrator(lab.compiled, {}).motion(start).acceleration +
                   noise * gaussian.vector(samples).transpose();
      s.noise_sd = VectorXd::Constant(1, noise);
      s.excitation_noise_sd = VectorXd::Zero(1);
      segments.push_back(std::move(s));
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

}  // namespace
}  // namespace secular
