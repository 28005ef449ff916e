// Means of decays behind a coupling that passes no constant part.
#include "motion/correction/coupled_means.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"

namespace secular {
namespace {

constexpr double own_of_means = 125.0, growth_of_decay = -1.0, alarm_of_means = 1e-4, window_of_means_s = 0.25;

// Half amplitudes of two decays of 5 s, in the channels' unit.
double amplitude_of(std::size_t record, double time) {
  return (record == 0 ? 10 : 7) * std::exp(growth_of_decay * time);
}

using MeanLaw = std::function<double(std::size_t record, double time)>;

// Windows that follow one another, with the mean of what `law` says in each of them.
std::vector<ObservationSet> windows_with(const MeanLaw& law, double sd, std::uint64_t seed) {
  const CompiledModel& model = *generated::find_compiled_model("duffing");
  ObservationSet set;
  set.model = &model;
  set.resonance = &case_named(model, "free");
  std::mt19937_64 draw(seed);
  std::normal_distribution<double> noise(0, sd);
  for (std::size_t record = 0; record < 2; ++record)
    for (int i = 0; i < 20; ++i) {
      Observation o;
      o.record = record;
      o.length_s = window_of_means_s;
      o.centre_s = (i + 0.5) * o.length_s;
      o.rate = {{growth_of_decay, own_of_means}};
      o.amplitude = {amplitude_of(record, o.centre_s) / std::complex<double>(0, own_of_means)};
      o.growth_sd = {0.01};
      o.mean = {noise(draw)};
      constexpr int points = 400;
      for (int p = 0; p < points; ++p)
        o.mean[0] += law(record, o.centre_s + o.length_s * ((p + 0.5) / points - 0.5)) / points;
      o.mean_sd = {sd};
      set.observations.push_back(o);
    }
  return {set};
}

// What a coupling leaves of 2 k |Y|^2 that began at zero, in the closed form of exponentials.
double behind_coupling(double k, double tau, std::size_t record, double time) {
  const double g = 2 * growth_of_decay, start = 2 * k * std::pow(amplitude_of(record, 0), 2);
  return start * (g * tau * std::exp(g * time) + std::exp(-time / tau)) / (1 + g * tau);
}

TEST(CoupledMeans, TellALawAndItsCoupling) {
  for (const double tau : {0.1, 0.3, 1.5})
    for (const double k : {0.003, -0.003}) {
      const auto law = coupled_law(
          windows_with([&](std::size_t r, double t) { return behind_coupling(k, tau, r, t) + 0.2 - 0.05 * t; },
                       1e-4, 3),
          1, 1 / own_of_means, alarm_of_means);
      ASSERT_TRUE(law) << tau;
      EXPECT_NEAR(law->k, k, 0.1 * std::abs(k)) << tau;
      EXPECT_NEAR(law->time_constant_s, tau, 0.1 * tau);
      EXPECT_GT(law->counts, 0.5);
    }
}

// Constants and drifts, what a chain makes that passes means, what a coupling makes of a step, zeros that wander.
TEST(CoupledMeans, TellNoLawWhereThereIsNone) {
  const MeanLaw laws[] = {[](std::size_t r, double t) { return 0.1 * static_cast<double>(r) + 0.02 * t; },
                          [](std::size_t r, double t) { return 0.006 * std::pow(amplitude_of(r, t), 2); },
                          [](std::size_t r, double t) { return (r == 0 ? 0.4 : -0.1) * std::exp(-t / 0.7); },
                          [](std::size_t, double t) { return 0.05 * std::sin(4 * t); }};
  for (const MeanLaw& law : laws)
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
      const auto found = coupled_law(windows_with(law, 1e-3, seed), 1, 1 / own_of_means, alarm_of_means);
      EXPECT_FALSE(found) << &law - laws << ' ' << found->k;
    }
}

}  // namespace
}  // namespace secular
