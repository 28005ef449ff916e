// What ensembles of one dwell agree on, whatever the phases at which they were taken.
#include "motion/correction/mean_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "measure/observe/mode_frequencies.hpp"
#include "motion/simulate/noise.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

struct Dwell {
  const CompiledModel& model;
  const CompiledCase& resonance;

  Dwell(std::string_view name, std::string_view case_name)
      : model(*generated::find_compiled_model(name)), resonance(secular::case_named(model, case_name)) {}

  // The same motion with the excitation's phase turned by `excitation` and every free frequency's by `free`.
  Observation at(double excitation, double free) const {
    const ModeFrequencies modes = mode_frequencies(model, resonance);
    Observation o;
    o.excitation_frequency = {286.0};
    o.forcing = {std::polar(23.0, 0.3 + excitation)};
    for (std::size_t k = 0; k < model.modes(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      const double turn = modes.forced(row, 0) * excitation + modes.coupling.row(row).sum() * free;
      o.amplitude.push_back(std::polar(3e-5 / static_cast<double>(k + 1), 0.7 + static_cast<double>(k) + turn));
      o.rate.emplace_back(0.0, 77.8);
    }
    return o;
  }
};

void expect_same(const Observation& mean, const Observation& motion, double tolerance) {
  for (std::size_t k = 0; k < motion.amplitude.size(); ++k)
    EXPECT_LT(std::abs(mean.amplitude[k] - motion.amplitude[k]), tolerance * std::abs(motion.amplitude[k])) << k;
  EXPECT_LT(std::abs(mean.forcing[0] - motion.forcing[0]), tolerance * std::abs(motion.forcing[0]));
}

// A resonance that leaves a frequency free, and one in which the mode is locked to half of the excitation: after
// one turn of that the mode is at its opposite.
const std::vector<std::pair<const char*, const char*>> cases = {{"two_mass_lumps", "additive_combination"},
                                                                {"two_mass_mode1", "principal_parametric"}};

TEST(MeanMotion, PhasesOfTheEnsemblesDoNotMatterAndOneOutlierNeither) {
  for (const auto& [model, resonance] : cases) {
    const Dwell dwell(model, resonance);
    std::vector<Observation> ensembles;
    for (int i = 0; i < 9; ++i) ensembles.push_back(dwell.at(1.9 * i, -2.7 * i));
    expect_same(mean_motion(ensembles, dwell.model, dwell.resonance), dwell.at(0, 0), 1e-12);
    for (Complex& a : ensembles[4].amplitude) a *= Complex(1.5, 0.4);
    expect_same(mean_motion(ensembles, dwell.model, dwell.resonance), dwell.at(0, 0), 1e-12);
  }
}

TEST(MeanMotion, NoiseIsThatOfAMedian) {
  const Dwell dwell("two_mass_mode1", "principal_parametric");
  constexpr int draws = 300, count = 9;
  constexpr double noise_sd = 1e-7;
  double square = 0;
  for (int draw = 0; draw < draws; ++draw) {
    NoiseStream noise(5, static_cast<std::uint64_t>(draw), 0);
    std::vector<Observation> ensembles;
    for (int i = 0; i < count; ++i) {
      ensembles.push_back(dwell.at(1.9 * i, 0));
      Complex& a = ensembles.back().amplitude[0];
      a += noise_sd * Complex(noise.gaussian(), noise.gaussian());
    }
    const Observation mean = mean_motion(ensembles, dwell.model, dwell.resonance);
    square += std::pow((std::abs(mean.amplitude[0]) - 3e-5) / noise_sd, 2) / draws;
  }
  constexpr double of_nine = 0.166;  // variance of the median of nine; pi/(2 n) of many
  EXPECT_NEAR(square, of_nine, 4.5 * std::sqrt(2.0 / draws) * of_nine);
}

}  // namespace
}  // namespace secular
