// The generator's structures, integrator and sensors against hand formulas.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "blind/effect.hpp"
#include "blind/integrator.hpp"
#include "blind/measurement.hpp"
#include "blind/motion.hpp"
#include "blind/structure.hpp"

namespace secular::blind {
namespace {

constexpr double pi = std::numbers::pi;

Structure one_mode(double omega) {
  Structure structure;
  structure.mode[0].omega = omega;
  return structure;
}

State at_rest_from(double q) {
  State state{};
  displacement(state, 0) = q;
  return state;
}

State after(const Structure& structure, const Drive& drive, const State& from, double duration, int steps) {
  Integrator integrator(structure, drive, 0, from);
  for (int i = 0; i < steps; ++i) integrator.advance(duration / steps);
  return integrator.state();
}

TEST(BlindIntegrator, ConvergesWithSixthOrder) {
  Structure structure = one_mode(1);
  structure.mode[0].alpha3 = 1;
  structure.mode[0].mu2 = 0.1;
  structure.mode[0].delta2 = 0.2;
  structure.mode[0].direct = 1;
  const Drive drive{.amplitude = 0.4, .frequency = 1.3};
  const State start = at_rest_from(0.5), exact = after(structure, drive, start, 1, 4096);
  const double coarse = std::abs(displacement(after(structure, drive, start, 1, 8), 0) - displacement(exact, 0));
  const double fine = std::abs(displacement(after(structure, drive, start, 1, 16), 0) - displacement(exact, 0));
  EXPECT_NEAR(std::log2(coarse / fine), 6, 0.4);
}

// Natural frequencies are given to diagnoses to ten digits: the steps of a set shift the highest one, 27 Hz, by
// less than 1e-8 of it.
TEST(BlindIntegrator, KeepsTheNaturalFrequency) {
  const double omega = 2 * pi * 27, duration = 10;
  const State end =
      after(one_mode(omega), {.frequency = 1}, at_rest_from(1), duration, static_cast<int>(duration * 256 * 4));
  const double late = std::atan2(-velocity(end, 0) / omega, displacement(end, 0)) - omega * duration;
  EXPECT_LT(std::abs(std::remainder(late, 2 * pi)), 2e-8 * omega * duration);
}

// Without damping the energy q'^2 (1 + 2 delta2 q + delta3 q^2)/2 + potential of each mode is kept.
TEST(BlindIntegrator, KeepsTheEnergyOfAConservativeStructure) {
  Structure structure;
  structure.modes = 2;
  structure.mode[0] = {.omega = 2 * pi, .alpha2 = 3, .alpha3 = 20, .alpha5 = 5, .delta2 = 0.2, .delta3 = 0.3};
  structure.mode[1] = {.omega = 15, .alpha3 = 10};
  structure.mode[0].quadratic_coupling = 4;
  structure.mode[1].cubic_coupling = 6;
  structure.mode[1].third_coupling = 2;
  const auto energy = [&](const State& x) {
    const double q = displacement(x, 0), p = velocity(x, 0), u = displacement(x, 1), r = velocity(x, 1);
    const ModeTerms& a = structure.mode[0];
    const ModeTerms& b = structure.mode[1];
    return p * p * (1 + 2 * a.delta2 * q + a.delta3 * q * q) / 2 + r * r / 2 + a.omega * a.omega * q * q / 2 +
           b.omega * b.omega * u * u / 2 + a.alpha2 * q * q * q / 3 + a.alpha3 * std::pow(q, 4) / 4 +
           a.alpha5 * std::pow(q, 6) / 6 + b.alpha3 * std::pow(u, 4) / 4 + a.quadratic_coupling * q * q * u +
           b.cubic_coupling * q * q * u * u / 2 + b.third_coupling * u * u * u * q;
  };
  State start = at_rest_from(0.4);
  displacement(start, 1) = -0.2;
  const Drive rest{.frequency = 1};
  const double coarse = energy(after(structure, rest, start, 3, 1000)) - energy(start);
  const double fine = energy(after(structure, rest, start, 3, 2000)) - energy(start);
  EXPECT_LT(std::abs(fine), 1e-5 * energy(start));
  EXPECT_LT(std::abs(fine), std::abs(coarse) / 32);  // what is lost is the integrator's
}

// Contact with stiffness k for q > 0: half periods pi/sqrt(omega^2 + k) and pi/omega.
TEST(BlindIntegrator, FindsTheMomentsOfAContact) {
  Structure structure = one_mode(3);
  structure.mode[0].bilinear = 7;
  const double period = pi / 3 + pi / 4;
  const State end = after(structure, {.frequency = 1}, at_rest_from(1), period, 200);
  EXPECT_NEAR(displacement(end, 0), 1, 1e-7);
  EXPECT_NEAR(velocity(end, 0), 0, 1e-6);
}

// Free decay with dry friction: the amplitude falls by 2 fc/omega^2 in each half cycle, and the mass stops where
// the spring is weaker than friction.
// A softening spring lets go; what is kinked besides has no moments to be found any more.
TEST(BlindIntegrator, AMotionThatLeavesForInfinityIsNotFiniteAndNoFailure) {
  for (const bool contact : {false, true}) {
    Structure structure = one_mode(1);
    structure.mode[0].alpha3 = -1;
    structure.mode[0].friction = 0.01;
    if (contact) structure.mode[0].bilinear = 0.1;
    State state{};
    EXPECT_NO_THROW(state = after(structure, {.frequency = 1}, at_rest_from(2), 50, 500)) << contact;
    EXPECT_FALSE(std::isfinite(displacement(state, 0))) << contact;
    EXPECT_NO_THROW(state = after(structure, {.frequency = 1}, at_rest_from(-2), 50, 500)) << contact;
    EXPECT_FALSE(std::isfinite(displacement(state, 0))) << contact;
  }
}

TEST(BlindIntegrator, FrictionStopsTheMotion) {
  Structure structure = one_mode(2);
  structure.mode[0].friction = 0.4;  // 0.1 in displacement
  const Drive none{.frequency = 1};
  EXPECT_NEAR(displacement(after(structure, none, at_rest_from(1), pi / 2, 100), 0), -0.8, 1e-6);
  EXPECT_NEAR(displacement(after(structure, none, at_rest_from(1), pi, 200), 0), 0.6, 1e-6);
  // 1.05, -0.85, 0.65, -0.45, 0.25, -0.05: there the spring's 0.2 is weaker than friction.
  const State end = after(structure, none, at_rest_from(1.05), 20, 2000);
  EXPECT_NEAR(displacement(end, 0), -0.05, 1e-5);
  EXPECT_EQ(velocity(end, 0), 0);
}

// A slider under slow harmonic motion of amplitude a: Jenkins' loop is a parallelogram of area 4 k slip (a - slip).
TEST(BlindIntegrator, SliderLoopHasItsArea) {
  Structure structure = one_mode(100);
  ModeTerms& m = structure.mode[0];
  m.mu1 = 60;
  m.slider = 50;  // weak: the motion stays harmonic to 50/100^2
  m.slip = 0.3;
  m.direct = 1;
  const Drive drive{.amplitude = 1e4, .frequency = 2 * pi};
  const auto loop = [&] {
    Integrator integrator(structure, drive, 0, State{});
    const int steps = 2000;
    for (int i = 0; i < steps; ++i) integrator.advance(1.0 / steps);
    double area = 0, largest = 0;
    for (int i = 0; i < steps; ++i) {
      const double q = displacement(integrator.state(), 0), s = slider_spring(integrator.state(), 0);
      integrator.advance(1.0 / steps);
      area += m.slider * (s + slider_spring(integrator.state(), 0)) / 2 * (displacement(integrator.state(), 0) - q);
      largest = std::max(largest, std::abs(q));
    }
    return std::pair(area, largest);
  };
  const auto [area, amplitude] = loop();
  EXPECT_NEAR(area, 4 * m.slider * m.slip * (amplitude - m.slip), 1e-3 * area);
  // Bouc and Wen's force saturates at the same slip: s' = q' - |q'| s|s|/slip^2 is tanh-like, and its loop smaller
  // than the square one 4 k slip a, larger than nothing.
  m.smooth_slider = true;
  const auto [smooth_area, smooth_amplitude] = loop();
  EXPECT_GT(smooth_area, 0.5 * area);
  EXPECT_LT(smooth_area, 4 * m.slider * m.slip * smooth_amplitude);
}

TEST(BlindMotion, SteadyStateIsTheTransferFunctions) {
  Structure structure = one_mode(2 * pi * 11);
  structure.mode[0].mu1 = 0.5;
  structure.mode[0].direct = 0.2;
  const Drive drive{.amplitude = 3, .frequency = 2 * pi * 11.1};
  const Settling settling{.time_constant = 2};
  const Motion motion =
      recorded_motion(structure, drive, settled_state(structure, drive, State{}, settling), 512, settling.substeps);
  const double w = drive.frequency, w0 = structure.mode[0].omega;
  const std::complex<double> q = 0.2 * 3 / std::complex(w0 * w0 - w * w, 2 * 0.5 * w);
  for (std::size_t i : {0UL, 100UL, 511UL}) {
    const double t = static_cast<double>(i) / sample_rate_hz;
    const double expected = (q * std::polar(1.0, w * t)).real();
    // The integrator's phase error (omega h)^4/120 of the frequency moves the resonance by 3e-7 omega.
    EXPECT_NEAR(motion.displacement[0][i], expected, 2e-4 * std::abs(q)) << i;
    EXPECT_NEAR(motion.acceleration[0][i], -w * w * expected, 2e-4 * w * w * std::abs(q)) << i;
  }
}

// A little above its threshold a parametric resonance takes hundreds of time constants to grow out of a tenth of a
// millionth, while the motion that the base drives directly has long settled.
TEST(BlindMotion, ASlowSubharmonicBeneathALargeMotionIsWaitedFor) {
  const double omega = 2 * pi * 12, mu = 0.6, threshold = 4 * omega * mu;
  Structure structure = one_mode(omega);
  structure.mode[0].mu1 = mu;
  structure.mode[0].mu3 = 4;
  structure.mode[0].direct = 0.01;
  structure.mode[0].parametric = 1.03;
  const Drive drive{.amplitude = threshold, .frequency = 2 * omega};
  const Settling settling{.time_constant = 1 / mu, .periods_of_two = 2};
  const double period = 2 * pi / drive.frequency;
  const auto subharmonic = [&](const State& state) {
    const State later = after(structure, drive, state, period, 60);
    return 0.5 * std::hypot(displacement(later, 0) - displacement(state, 0),
                            (velocity(later, 0) - velocity(state, 0)) / omega);
  };
  const State settled = settled_state(structure, drive, at_rest_from(1e-7), settling);
  EXPECT_GT(subharmonic(settled), 5e-4);
  const State long_after = after(structure, drive, settled, 200 * period, 12000);
  EXPECT_NEAR(subharmonic(long_after), subharmonic(settled), 2e-4 * subharmonic(settled));
}

TEST(BlindStructure, EveryTermIsItsFormula) {
  State x{};
  const double q = 0.3, p = -0.7, u = 0.2, r = 0.5, s = 0.11, f = 1.7, F = 2;
  displacement(x, 0) = q;
  velocity(x, 0) = p;
  displacement(x, 1) = u;
  velocity(x, 1) = r;
  slider_spring(x, 0) = s;
  const std::vector<std::pair<std::string, double>> expected = {{"viscous_damping", -2 * p},
                                                                {"quadratic_damping", -std::abs(p) * p},
                                                                {"cubic_damping", -p * p * p},
                                                                {"amplitude_dependent_damping", -q * q * p},
                                                                {"quadratic_stiffness", -q * q},
                                                                {"cubic_stiffness", -q * q * q},
                                                                {"quintic_stiffness", -std::pow(q, 5)},
                                                                {"septic_stiffness", -std::pow(q, 7)},
                                                                {"bilinear_stiffness", -q},
                                                                {"freeplay", 0.1},  // clamped at the gap
                                                                {"one_sided_stop", -(q - 0.1)},
                                                                {"two_sided_stop", -(q - 0.1)},
                                                                {"saturating_stiffness", q - std::tanh(q)},
                                                                {"hysteresis", -s},
                                                                {"direct_excitation", f},
                                                                {"parametric_excitation", q * f},
                                                                {"damping_coupling", -r},
                                                                {"quadratic_coupling", -2 * q * u},
                                                                {"cubic_coupling", -q * u * u},
                                                                {"parametric_coupling", u * f},
                                                                {"one_sided_damping", 0},  // p < 0
                                                                {"threshold_damping", -p},
                                                                {"quartic_damping", -std::pow(q, 4) * p},
                                                                {"level_stiffness", -F * F * q}};
  const Drive drive{.amplitude = F, .frequency = 1};
  for (const auto& [effect, term] : expected) {
    Structure structure;
    structure.modes = 2;
    structure.mode[0].gap = 0.1;
    structure.mode[0].threshold = 0.2;
    structure.mode[0].slip = 1;
    const Integrator without(structure, drive, 0, x);
    const double before = force(structure, drive, {without.regime(), 0, f, x}, 0);
    ASSERT_NE(coefficient(structure, effect, 0), nullptr) << effect;
    *coefficient(structure, effect, 0) += 1;
    const Integrator with(structure, drive, 0, x);
    EXPECT_NEAR(force(structure, drive, {with.regime(), 0, f, x}, 0) - before, term, 1e-12) << effect;
  }
}

// (1 + 2 delta2 q + delta3 q^2) q'' = -omega^2 q - delta2 q'^2 - delta3 q q'^2, and friction against the motion.
TEST(BlindStructure, InertiaAndFrictionActOnTheAcceleration) {
  Structure structure = one_mode(2);
  structure.mode[0].delta2 = 0.5;
  structure.mode[0].delta3 = 0.25;
  structure.mode[0].friction = 0.3;
  State x{};
  displacement(x, 0) = 0.4;
  velocity(x, 0) = 0.6;
  const Drive none{.frequency = 1};
  const Integrator integrator(structure, none, 0, x);
  const double expected = (-4 * 0.4 - 0.5 * 0.36 - 0.25 * 0.4 * 0.36 - 0.3) / (1 + 0.4 + 0.25 * 0.16);
  EXPECT_NEAR(integrator.acceleration().modal[0], expected, 1e-14);
}

TEST(BlindStructure, NaturalFrequencyDriftsWithCampaignTime) {
  Structure structure = one_mode(2);
  structure.mode[0].drift = 1e-3;
  const Drive drive{.frequency = 1, .started = 90};
  const Integrator integrator(structure, drive, 10, at_rest_from(1));
  EXPECT_NEAR(integrator.acceleration().modal[0], -4 * 1.1 * 1.1, 1e-12);
}

// An extra mode is a linear oscillator of its own, seen by accelerometers and displacement sensors alike.
TEST(BlindMeasurement, EverySensorSeesTheExtraMode) {
  Structure structure = one_mode(2 * pi * 11);
  structure.mode[0].mu1 = 0.5;
  structure.extra = {.omega = 2 * pi * 12, .mu = 2, .direct = 0.1};
  const Drive drive{.amplitude = 3, .frequency = 2 * pi * 11.5};
  const Motion motion =
      recorded_motion(structure, drive, settled_state(structure, drive, State{}, {.time_constant = 2}), 256, 4);
  const double w = drive.frequency, w0 = structure.extra.omega;
  const std::complex<double> z = 0.1 * 3 / std::complex(w0 * w0 - w * w, 2 * 2 * w);
  Measurement m;
  m.names = {"base", "v"};
  m.shapes = {{1.0}};
  m.fault.assign(2, {});
  for (const bool of_displacement : {false, true}) {
    m.of_displacement = of_displacement;
    const auto channels = measured(m, drive, motion, true);
    const double size = std::abs(z) * (of_displacement ? 1 : w * w);
    for (std::size_t i : {3UL, 200UL}) {
      const double phase = w * static_cast<double>(i) / sample_rate_hz;
      const double expected = (z * std::polar(1.0, phase)).real() * (of_displacement ? 1 : -w * w);
      EXPECT_NEAR(channels[1][i], expected, 1e-4 * size) << i;
    }
  }
}

TEST(BlindMeasurement, FaultsDoWhatTheySay) {
  Measurement m;
  m.names = {"base", "a", "b"};
  m.with_modal_basis = true;
  m.shapes = {{1.0, 2.0}, {3.0, 5.0}};
  m.fault.assign(3, {});
  m.fault[1] = {.gain = 0.1, .offset = 0.5, .cross_axis = 0.2};
  m.fault[2].range = 4;
  m.leak[0] = 0.5;  // mode 1 holds half of mode 2
  Motion motion;
  motion.displacement = {{0, 0}, {0, 0}};
  motion.acceleration = {{1, 2}, {0, 1}};
  motion.extra_displacement = {0, 0};
  motion.extra_acceleration = {0, 0};
  const Drive drive{.amplitude = 3, .frequency = 1};
  const auto channels = measured(m, drive, motion, true);
  EXPECT_DOUBLE_EQ(channels[0][0], 3);
  // q1 + 0.5 q2 and q2: channel a = 1 (q1 + 0.5 q2) + 2 q2
  EXPECT_NEAR(channels[1][0], 1.1 * 1 + 0.2 * 3 + 0.5, 1e-14);
  EXPECT_NEAR(channels[1][1], 1.1 * (2.5 + 2) + 0.2 * drive.at(1 / sample_rate_hz) + 0.5, 1e-14);
  EXPECT_DOUBLE_EQ(channels[2][0], 3);
  EXPECT_DOUBLE_EQ(channels[2][1], 4);  // 3*2.5 + 5 saturates
}

TEST(BlindMeasurement, ALateChannelIsTheSignalBefore) {
  std::vector<double> samples(400), expected(400);
  const double w = 2 * pi * 25, late = 0.0013;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / sample_rate_hz;
    samples[i] = std::sin(w * t);
    expected[i] = std::sin(w * (t - late));
  }
  const std::vector<double> shifted = delayed(samples, late);
  // Lagrange's remainder for eight points: at most (w dt)^8/8! times the node polynomial (1/2 3/2 5/2 7/2)^2.
  const double bound = 43.1 * std::pow(w / sample_rate_hz, 8) / 40320;
  for (std::size_t i = 8; i < 392; ++i) EXPECT_NEAR(shifted[i], expected[i], bound) << i;
}

}  // namespace
}  // namespace secular::blind
