#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "thesis/verify/demodulation.hpp"
#include "thesis/verify/full_equations.hpp"
#include "thesis/verify/table_arithmetic.hpp"

namespace secular::verify {
namespace {

// Harmonics that move linearly and quadratically in time come back with their rates.
TEST(Demodulation, RecoversMovingHarmonics) {
  const std::vector<double> frequencies = {1.0, 2.618033988749895};
  const double step = 0.1;
  std::vector<double> record(1200);
  const double middle = 0.5 * step * 1199;
  const auto first = [&](double t) { return std::complex<double>(0.4 + 0.001 * t, -0.1 + 2e-5 * t * t); };
  const auto mixed = [&](double t) { return std::complex<double>(0.02, 0.03 - 0.0004 * t); };
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double t = step * static_cast<double>(i);
    record[i] = 0.05 - 0.002 * t + 2 * (first(t) * std::polar(1.0, frequencies[0] * t)).real() +
                2 * (mixed(t) * std::polar(1.0, (2 * frequencies[0] - frequencies[1]) * t)).real();
  }
  const Demodulation d = demodulated(record, step, frequencies, 3, 3);
  EXPECT_LT(d.residual, 1e-10);
  EXPECT_LT(std::abs(d.harmonic.at({1, 0}) - first(middle)), 1e-9);
  EXPECT_LT(std::abs(d.rate.at({1, 0}) - std::complex<double>(0.001, 4e-5 * middle)), 1e-9);
  EXPECT_LT(std::abs(d.harmonic.at({2, -1}) - mixed(middle)), 1e-9);
  EXPECT_LT(std::abs(d.rate.at({-2, 1}) - std::complex<double>(0, 0.0004)), 1e-9);
  EXPECT_LT(std::abs(d.harmonic.at({0, 0}) - (0.05 - 0.002 * middle)), 1e-9);
}

// x'' + x = 0 with a coupled mass matrix: the energy of an undamped system does not change.
TEST(FullEquations, KeepTheEnergy) {
  const Model model = read_model_text(
      "schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\n"
      "equation = \"D2(x) + w^2*x = -d*x^2*D2(x) - d*x*D(x)^2 - g*x^3\"\n"
      "[[case]]\nname = \"free\"\norder = { d = 1, g = 1 }\nexpand_to = 1\n",
      "m");
  const FullEquations equations(model, {{"w", 1.3}, {"d", 0.4}, {"g", 0.7}});
  const double step = 0.01;
  const auto record = integrated(equations, {0.8}, {0.0}, step, 2001);
  const auto energy = [&](std::size_t i) {
    const double x = record[0][i];
    const double v =
        (8 * (record[0][i + 1] - record[0][i - 1]) - (record[0][i + 2] - record[0][i - 2])) / (12 * step);
    return 0.5 * (1 + 0.4 * x * x) * v * v + 0.5 * 1.69 * x * x + 0.25 * 0.7 * x * x * x * x;
  };
  const double start = energy(2);
  for (std::size_t i = 3; i < 1990; i += 97) EXPECT_NEAR(energy(i), start, 1e-7);
}

TEST(TableArithmetic, KnowsTheRounding) {
  EXPECT_DOUBLE_EQ(rounded_number("0.222").low, 0.2215);
  EXPECT_DOUBLE_EQ(rounded_number("0.222").high, 0.2225);
  EXPECT_DOUBLE_EQ(rounded_number("-42.5e6").low, -42.55e6);
  EXPECT_DOUBLE_EQ(rounded_number("7").high, 7.5);
}

}  // namespace
}  // namespace secular::verify
